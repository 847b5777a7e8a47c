"""Basins of attraction: which attractor is reached from a grid of initial states."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from ...core.error_states import in_usual_state
from ...core.errors import ParameterTypeError
from ...core.questions import model_of, require_answered
from ...display import Column, named_fields
from ...models.parameters import FloatArray, ParameterSet, as_numbers
from ...numerics.interval_arrays import BoolArray, IntArray
from ...results.result import Named
from ..options import MotionOptions
from ..regimes import Outcome, Regime, RestSets, same_limit
from ..scales import scales_of
from ..simulation import initial_state
from .many import Sweep, rms_sweep


@dataclass(frozen=True, eq=False)
class Basin(Named):
    """Basins of attraction: the attractor that each initial state of a grid reaches.

    Attributes
    ----------
    plane : tuple of str
        The two coordinates or rates along the axes of the grid.
    starts : tuple of ndarray
        Their values.
    attractor : ndarray of int
        Index in ``attractors`` of the one that the motion reaches; −1 if it failed.
    attractors : tuple of (Regime, int, float, float)
        Regime: EQUILIBRIUM, LIMIT_CYCLE, LIFT_OFF or UNSETTLED, whether reached or approached.
        Index of the equilibrium, or −1; if friction holds a whole set of states, which is one
        attractor, the index of one of them. Mean of x on a limit cycle, and standard deviation of x
        over one period; else NaN.
    sweep : Sweep
        All results.
    remarks : tuple of str
        How many motions have no limit, and attractors that may be the same: states of rest held by
        friction that are not proved to be connected.
    """

    schema = (
        Column("attractor", "1", "number of the attractor that is reached; -1 where it failed"),
        Column("regime", "1", "kind of that attractor", Regime, of=lambda basin: basin.regimes),
    )

    plane: tuple[str, str]
    starts: tuple[FloatArray, FloatArray]
    attractor: IntArray
    attractors: tuple[tuple[Regime, int, float, float], ...]
    sweep: Sweep
    remarks: tuple[str, ...] = ()

    def _shown(self) -> dict[str, Any]:
        values = named_fields(self)
        return dict(zip(values.pop("plane"), values.pop("starts"), strict=True)) | values

    @property
    def _over(self) -> dict[str, FloatArray]:
        (one, first), (other, second) = zip(self.plane, self.starts, strict=True)
        return {one: first[:, None], other: second}

    @property
    def _items(self) -> dict[str, Any]:
        axes = dict(zip(self.plane, self.starts, strict=True))
        return {**super()._items, **axes}

    @property
    def regimes(self) -> IntArray:
        """Code of the :class:`spragsym.Regime` of each start's attractor; UNSETTLED where the
        motion failed.
        """
        codes = [int(regime) for regime, *_ in self.attractors]
        return np.array([*codes, int(Regime.UNSETTLED)])[self.attractor]


@in_usual_state
def basin(
    p: ParameterSet,
    **starts: Any,
) -> Basin:
    """Basins of attraction on a grid of initial states in two coordinates or rates.

    Parameters
    ----------
    p : Parameters
        Scalars, of any model.
    **starts
        Two of the coordinates and rates by their names, one axis each, as ``x=…, vx=…``: the grid
        has every value of one with every value of the other. Also the rest of the initial state, as
        ``y0=…``, parameters, as ``V=0.5``, and options of :func:`rms_sweep`. Without ``t_end``
        motions are followed as by :func:`spragsym.fate`: those that are undecided at one of
        ``options.times`` up to the next. A motion that has no limit by then, or by ``t_end``, is
        ``Regime.UNSETTLED``, which a remark counts. In the article's model deviations decay at the
        rate μ₀ d exp(−d V) n, with the contact force n, which can take tens of thousands of time
        units.

    Returns
    -------
    Basin

    Raises
    ------
    ParameterError, ParameterTypeError
        For invalid arguments, and parameters that are not scalars.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> from spragsym.motion.sweeps import basin
    >>> p = ss.Parameters.article(theta0=np.radians(30))
    >>> found = basin(p, V=0.5, d=4.0, x=[0.0, 0.1, 1.6], vx=[0.0], t_end=2e4, transient=1.9e4)
    >>> [(regime.name, which) for regime, which, *_ in found.attractors]
    [('EQUILIBRIUM', 0), ('UNSETTLED', -1)]
    >>> found.attractor[:, 0]
    array([0, 0, 1])
    """
    require_answered("basin", p)
    model = model_of(p)
    names = model.components
    p = p.given(**{name: starts.pop(name) for name in [*starts] if name in p.ranges})
    p.scalars(*p.ranges)
    plane = tuple(name for name in starts if name in names)
    if len(plane) != 2:
        given = ", ".join(starts) or "none"
        raise ParameterTypeError(
            f"starts are two axes of {', '.join(names)}, as {names[0]}=[0.0, 1.0]; given: {given}"
        )
    axes = {
        name: np.atleast_1d(as_numbers(name, starts.pop(name), model.any_of(name)))
        for name in plane
    }
    for name, values in axes.items():
        if values.ndim != 1:
            raise ParameterTypeError(
                f"{name} has the shape {values.shape}; give one axis of numbers"
            )
    (one, first), (other, second) = axes.items()
    options = {one + "0": first[:, None], other + "0": second, **starts}
    sweep = rms_sweep(p, **options) if "t_end" in options else _looked_at(p, options)
    field = sweep.model.field
    one_limit = partial(
        same_limit,
        field=field,
        constants=field.constants(p.scalars(*p.ranges)),
        sets=RestSets(p),
    )
    return Basin((one, other), (first, second), sweep=sweep, **_attractors(sweep, one_limit))


def _looked_at(p: ParameterSet, options: dict[str, Any]) -> Sweep:
    """The sweep with the limits of motions that are followed until they are decided, to each of the
    times at which fates are judged.
    """
    chosen = options.get("options") or MotionOptions()
    points = {
        name: options[name] for name in options if name.removesuffix("0") in p.model.components
    }
    # What is thrown far takes ever more steps.
    settings: dict[str, Any] = {"rtol": chosen.rtol, "max_steps": 1_000_000} | {
        name: value for name, value in options.items() if name not in points
    }
    state = initial_state(p.model, None, points, p)
    scales = scales_of(
        p.model.field,
        p.model.field.constants(p.scalars(*p.ranges)),
        [float(np.ravel(value)[0]) for value in state.values()],
    )
    found: Sweep | None = None
    for look in chosen.times:
        t_end = look * scales.time
        if found is None:
            found = rms_sweep(p, t_end=t_end, transient=t_end / 2, **points, **settings)
            continue
        open_ = found.regime == Regime.UNSETTLED
        if not open_.any():
            break
        some = {name: np.broadcast_to(found.inputs[name], open_.shape)[open_] for name in points}
        later = rms_sweep(p, t_end=t_end, transient=t_end / 2, **some, **settings)
        found = _with_later(found, open_, later)
    assert found is not None
    return found


def _with_later(found: Sweep, open_: BoolArray, later: Sweep) -> Sweep:
    """The sweep in which some motions are replaced by those of a longer one."""
    measured = {name: values.copy() for name, values in found.measured.items()}
    for name, values in measured.items():
        values[open_] = later.measured[name]
    regime, equilibrium = found.regime.copy(), found.equilibrium.copy()
    regime[open_], equilibrium[open_] = later.regime, later.equilibrium
    reason = found.reason.astype(object)
    reason[open_] = later.reason
    return replace(
        found,
        t_end=later.t_end,
        transient=later.transient,
        measured=measured,
        regime=regime,
        equilibrium=equilibrium,
        reason=reason.astype(str),
    )


def _attractors(
    sweep: Sweep, one_limit: Callable[[Outcome, Outcome], bool | None]
) -> dict[str, Any]:
    """Fields of :class:`Basin`: motions grouped by their limit, as ``one_limit`` compares them; it
    gives None if two limits may be the same.
    """
    labels = np.full(sweep.regime.shape, -1)
    limits, unknown = list[Outcome](), dict[int, list[int]]()
    for index in np.argwhere(sweep.regime != Regime.FAILED):
        outcome, possibly_same = sweep.outcome(tuple(index)), list[int]()
        for label, other in enumerate(limits):
            same = one_limit(other, outcome)
            if same:
                break
            if same is None:
                possibly_same.append(label)
        else:
            label = len(limits)
            limits.append(outcome)
            if possibly_same:
                unknown[label] = possibly_same
        labels[tuple(index)] = label
    count = np.count_nonzero(sweep.regime == Regime.UNSETTLED)
    open_ = f"{count} of {labels.size} motions have no limit by t = {sweep.t_end:g}"
    open_ = f"{open_}: give a longer t_end, or ask ss.fate of a start"
    return {
        "attractor": labels,
        "attractors": tuple(
            (one.limit, one.equilibrium, one.cycle_mean, one.cycle_spread) for one in limits
        ),
        "remarks": (
            *[open_] * bool(count),
            *(
                f"attractor {one} is rest where friction holds, as {', '.join(map(str, others))}: "
                "no path of such states between them is proved, and they may be one"
                for one, others in unknown.items()
            ),
        ),
    }
