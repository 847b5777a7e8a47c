"""The fate of a motion, and maps of fates over parameters.

:func:`fate` classifies the limit of a motion; an equilibrium or cycle is then computed by Newton's
method. If there is none, Lyapunov exponents decide whether the motion is chaotic. Otherwise the
fate is undecided, and a text explains what is missing. :func:`fate_map` does this for every point
of an array of parameters.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from enum import IntEnum
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.error_states import in_usual_state
from ..core.errors import ConvergenceError, ParameterError
from ..core.questions import model_of, require_answered
from ..display import Column
from ..files import storage
from ..files.journal import Record
from ..models.model import Model
from ..models.parameters import POSITIVE, FloatArray, ParameterSet, as_number
from ..motion import integrators
from ..motion.options import MotionOptions
from ..motion.regimes import Outcome, Regime
from ..motion.scales import scales_of
from ..motion.simulation import Start, initial_state, state_of
from ..motion.sweeps.many import fingerprint
from ..motion.sweeps.workers import Computation, Workers, made_or_loaded
from ..numerics.interval_arrays import Int8Array
from ..results.result import Result, with_degrees
from .exponents import rates_along
from .finding import attractor_exponents, cycle_near, repeats, stands_still
from .orbit import distance
from .system import FateVerdict, System, judged, spectrum

#: Text for a motion that cannot be integrated, as where steps become too short.
UNFOLLOWED = "the motion can't be followed"

#: Names of the numbers in a record, in order.
MEASURED = ("kind", "period", "exponent", "exponent_error", "time_scale", "t")


@dataclass(frozen=True, eq=False)
class Fate(Result):
    r"""The attractor or lift-off that a motion ends in, or the reason why that is undecided.

    Attributes
    ----------
    kind : str
        "rest", "cycle", "lift-off", "chaotic" or "undecided".
    why : str
        The evidence for the kind; for an undecided motion, what is missing.
    t : float
        Time over which the motion was followed.
    outcome : Outcome
        The attractor, reached or approached.
    exponents, error : ndarray, shape (m,)
        Lyapunov exponents, largest first, and their errors. From the eigenvalues or multipliers of
        the attractor, where the error is infinite if rounding hides a multiplier; else averaged
        along the motion, with half-widths of 95 % confidence intervals. NaN for lift-off.
    trivial : int
        Index of the exponent along the flow, which is 0; −1 if there is none.
    time_scale : float
        Time in which the slowest small deviations from steady sliding decay by 1/e, −1 / max Re λ;
        infinite if they do not decay. A motion settles within about ten of these.
    near : str
        The cycle that Newton's method finds near the end of an undecided motion. The motion need
        not approach it.
    end : ndarray, shape (m,)
        State of the motion at ``t``.
    """

    kind: str
    why: str
    t: float
    outcome: Outcome
    exponents: FloatArray
    error: FloatArray
    trivial: int
    time_scale: float
    near: str
    end: FloatArray


@in_usual_state
def fate(
    p: ParameterSet,
    *,
    start: Start | None = None,
    t_end: float | None = None,
    backend: str | None = None,
    options: MotionOptions | None = None,
    **values: float | None,
) -> Fate:
    """Long-run fate of a motion: rest, a cycle, chaos or lift-off, or undecided with the reason.

    An equilibrium or a cycle is computed by Newton's method; its eigenvalues or multipliers decide.
    Without one, the motion is chaotic if, by the 95 % confidence intervals of its Lyapunov
    exponents, one is positive and all others but the trivial one differ from 0, and if the motion
    has settled. Otherwise it is undecided. With a clock, a motion is at rest if friction holds it
    in every phase, which is proved by interval arithmetic.

    Parameters
    ----------
    p : Parameters of any model
        Scalars.
    start : array_like or mapping, optional
        Initial state, coordinates, then rates; by default 0.
    t_end : float, optional
        Time over which the motion is followed, by default 40,000 times the motion's unit of time
        (1 over the fastest rate, rounded to a power of four; 1 from 1/32 to 32). After that,
        exponents are averaged over a fifth of it, and over all of it if one may be positive.
    backend : {"heyoka", "scipy"}, optional
    options : MotionOptions, optional
        Tolerances by which a fate is recognized.
    **values : float, optional
        Values of parameters that replace those of ``p``, as ``V=0.5, d=10.0``.

    Returns
    -------
    Fate

    Raises
    ------
    ParameterError, ParameterTypeError
        For invalid arguments.

    Notes
    -----
    Source: (8)–(11). No finite time distinguishes a chaotic transient from permanent chaos. So four
    neighbours of a chaotic motion are followed, too, none of which may settle, and ``why`` states
    how long a transient would have to last.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> p = ss.Parameters.article(theta0=np.radians(42.0))
    >>> ss.fate(p, V=0.5, d=10.0).why
    'it comes to a cycle of period 34.2674'
    >>> round(ss.fate(p.replace(theta0=np.radians(30.0)), V=0.5, d=10.0).time_scale, -3)
    227000.0
    """
    require_answered("fate", p)
    system = System.of(p, backend, options, **values)
    state = state_of(p.model, start, p=p)
    if t_end is not None:
        t_end = as_number("t_end", t_end, POSITIVE)
    none, nothing = np.full(system.field.deviations, np.nan), Outcome(names=system.field.components)
    begun = Fate("undecided", "", 0.0, nothing, none, none, -1, float("inf"), "", state)
    try:
        return _followed(system, begun, t_end)
    except ConvergenceError as failed:
        return replace(begun, why=f"{UNFOLLOWED}: {failed}")


def _followed(system: System, begun: Fate, t_end: float | None) -> Fate:
    """The fate of the motion from ``begun.end``, followed to ``t_end``; other fields of ``begun``
    are defaults.
    """
    start = begun.end
    scales = system.scales(start)
    times = None if t_end is None else system.looks(scales, t_end)
    verdict = judged(system, start, times=times)
    t_end = system.options.times[-1] * scales.time if t_end is None else t_end
    scale, nearby = _time_scale(system, verdict)
    found = replace(begun, t=verdict.t, time_scale=scale, end=verdict.end)
    if verdict.decided:
        why = f"it comes to {verdict.described()}"
        held = verdict.kind == Regime.EQUILIBRIUM and system.field.clock
        why += ", where friction holds it in every phase of the clock" if held else ""
        try:
            kind, spectrum, error, drift = attractor_exponents(system, verdict)
        except ConvergenceError as failed:
            return replace(found, why=f"{why}, which Newton's method does not find again: {failed}")
        moves = held or verdict.kind == Regime.LIMIT_CYCLE
        return replace(
            found,
            kind=kind,
            why=why + str(drift),
            outcome=verdict.outcome,
            exponents=spectrum,
            error=error,
            trivial=int(np.flatnonzero(spectrum == 0)[0]) if moves else -1,
        )
    if verdict.t > t_end:
        why = "a belt carries it so slowly that it has not settled"
        return replace(found, why=why, outcome=verdict.outcome)
    rates = rates_along(system, verdict.end, 0.2 * t_end, scales)
    # More time helps only if an exponent is already positive.
    if rates.undecided(t_end) and (rates.exponents[1:] > rates.error[1:]).any():
        rates = rates.joined(rates_along(system, rates.end, 0.8 * t_end, scales))
    why, near = rates.undecided(t_end) or _transient(system, start, t_end), ""
    why = why or repeats(system, rates.end)
    if why:
        why, near = stands_still(system, rates.end) or why, _near(system, rates.end)
        if scale < np.inf:
            where = system.field.place(nearby, ".6g")
            why += f"; at steady sliding, {where}, deviations die out as exp(−τ / {scale:.3g})"
    # No motion has settled in this total time: with 95 % confidence the mean lifetime of a
    # transient exceeds a third of it (e⁻³ = 0.05).
    lasting = (system.options.neighbours + 1) * t_end / 3
    reason = why or (
        "every exponent but the trivial one is told from 0, and one at least is positive; as "
        "a transient it would live for more "
        f"than {lasting:.2g} on the average (95 %)"
    )
    return replace(
        found,
        kind="undecided" if why else "chaotic",
        why=reason,
        t=verdict.t + rates.span,
        outcome=verdict.outcome,
        exponents=rates.exponents[rates.order],
        error=rates.error[rates.order],
        trivial=rates.trivial,
        near=near,
        end=rates.end,
    )


def _time_scale(system: System, verdict: FateVerdict) -> tuple[float, FloatArray]:
    """Time scale −1 / max Re λ at an attracting equilibrium, and that equilibrium.

    It is searched for near zero displacement and near the motion's end, in the opposite order if
    the motion comes to rest. Infinity, and the motion's end, if none attracts.
    """
    guesses = [np.zeros_like(verdict.end), verdict.end]
    if verdict.kind == Regime.EQUILIBRIUM:
        guesses.reverse()
    for near in guesses:
        with suppress(ConvergenceError, ParameterError, ArithmeticError):
            rest = system.equilibrium(near)
            eigenvalues, _, error = spectrum(system, rest)
            if (eigenvalues.real + error < 0).all():
                return float(-1 / eigenvalues.real.max()), rest
    return float("inf"), verdict.end


def _transient(system: System, start: FloatArray, t_end: float) -> str:
    """Text that an irregular motion is a transient, because a neighbour settles; empty if none
    does.
    """
    for i in range(1, system.options.neighbours + 1):
        offset = i * system.options.offset
        beside = system.beside(start, offset)
        neighbour = judged(system, beside, times=system.looks(system.scales(start), t_end))
        if neighbour.decided:
            return (
                f"it is a transient: a motion that begins {offset:.0e} beside it comes to "
                f"{neighbour.described()} by t = {t_end:g}"
            )
    return ""


def _near(system: System, end: FloatArray) -> str:
    """Text about the cycle near a state."""
    try:
        found = cycle_near(system, end, patient=False)
    except ConvergenceError:
        return "no cycle"
    neutral = system.flow.options.neutral
    word = "neither stable nor unstable by its multipliers"
    if found.stable:
        word = "stable"
    elif (np.abs(found.multipliers[1:]) - found.multiplier_errors > 1 + neutral).any():
        word = "unstable"
    return f"a cycle of period {found.period:.6g}, {word}, {distance(found, end):.2g} away"


class FateKind(IntEnum):
    """Codes of the kinds of fate in :attr:`spragsym.results.Fate.kind`."""

    UNDECIDED = 0
    REST = 1
    CYCLE = 2
    LIFT_OFF = 3
    CHAOTIC = 4


@dataclass(frozen=True, eq=False)
class FateMap(Result):
    """Fates of motions over arrays of parameters. All arrays have the common shape of these.

    Attributes
    ----------
    inputs : dict of str to ndarray
        The parameters as given, which broadcast together.
    start : tuple of float
        Initial state of every motion: coordinates, then rates, without the rate of a clock.
    t_end : float
    backend : str
    kind : ndarray of int8
        0 undecided, 1 rest, 2 cycle, 3 lift-off, 4 chaotic.
    period : ndarray
        Period of the cycle; NaN for none.
    exponent, exponent_error : ndarray
        The largest Lyapunov exponent except the trivial one, and the half-width of its 95 %
        confidence interval.
    time_scale : ndarray
        Time in which the slowest deviations from steady sliding decay by 1/e.
    t : ndarray
        Time over which the motion was followed.
    why : ndarray of str
        The evidence for the kind, or what is missing.
    model : Model
    options : MotionOptions
    """

    schema = (
        Column("kind", "1", "what the motion comes to", FateKind),
        Column("period", "s", "period of the cycle; NaN for none"),
        Column("exponent", "1/s", "largest Lyapunov exponent but the trivial one"),
        Column("exponent_error", "1/s", "half-width of its 95 % interval; 0 where it is exact"),
        Column("time_scale", "s", "on which slow deviations from steady sliding die out"),
        Column("t", "s", "how long the motion was followed"),
        Column("why", "1", "what decides the kind, or would"),
    )

    inputs: dict[str, FloatArray]
    start: tuple[float, ...]
    t_end: float
    backend: str
    kind: Int8Array
    period: FloatArray
    exponent: FloatArray
    exponent_error: FloatArray
    time_scale: FloatArray
    t: FloatArray
    why: NDArray[np.str_]
    model: Any = field(repr=False)
    options: MotionOptions = field(default_factory=MotionOptions)

    @property
    def _over(self) -> dict[str, FloatArray]:
        return self.inputs

    def count(self) -> dict[str, int]:
        """Number of points of each kind.

        Returns
        -------
        dict
            Numbers of points by the kinds of fate.

        Examples
        --------
        >>> import numpy as np
        >>> import spragsym as ss
        >>> p = ss.load("stick_slip").Parameters(V=np.array([0.2, 2.5]))
        >>> ss.fate_map(p).count()
        {'undecided': 0, 'rest': 1, 'cycle': 1, 'lift-off': 0, 'chaotic': 0}
        """
        return {
            kind.name.lower().replace("_", "-"): int(np.count_nonzero(self.kind == kind))
            for kind in FateKind
        }

    def _attributes(self) -> dict[str, Any]:
        begin = {
            f"{name}0": value
            for name, value in zip(self.model.components, self.start, strict=False)
        }
        settings = {"t_end": self.t_end, "backend": self.backend}
        decides = {"start": self.start, "options": self.options, **settings}
        key = fingerprint(self.model, self.inputs, decides)
        return {
            **storage.provenance(),
            "model": self.model.name,
            **begin,
            **settings,
            "fingerprint": key,
        }

    def _columns(self) -> dict[str, NDArray[Any]]:
        columns = with_degrees(self.model, self.inputs) | {
            name: getattr(self, name) for name in (*MEASURED, "why")
        }
        return {name: np.broadcast_to(values, self.kind.shape) for name, values in columns.items()}


@in_usual_state
def fate_map(
    p: ParameterSet,
    *,
    start: Start | None = None,
    t_end: float | None = None,
    backend: str | None = None,
    options: MotionOptions | None = None,
    workers: Workers = 1,
    progress: bool = False,
    store: str | os.PathLike[str] | None = None,
    **values: ArrayLike | None,
) -> FateMap:
    """Fates of the motion from a start, at every point of a broadcast of parameters.

    Parameters
    ----------
    p : Parameters of any model
        Any shape.
    start : array_like or mapping, optional
        Initial state, coordinates, then rates; by default 0.
    t_end : float, optional
        As for :func:`spragsym.fate`; the default of the slowest point is used for all.
    backend : {"heyoka", "scipy"}, optional
    options : MotionOptions, optional
        As for :func:`spragsym.fate`.
    workers, progress
        As for :func:`~spragsym.rms_sweep`.
    store : path, optional
        ``*.csv``. Finished points are written to ``<store>.partial`` one by one. After a kill the
        same call resumes from there; once the file is complete, it loads the file.
    **values : array_like, optional
        Values of parameters that replace those of ``p``, as ``V=0.5, d=10.0``.

    Returns
    -------
    FateMap

    Raises
    ------
    ParameterError, ParameterTypeError
        Before any integration. A motion that cannot be integrated is undecided, with the reason.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> found = ss.fate_map(ss.Parameters.article(theta0=np.radians([30.0, 42.0])), V=0.5, d=10.0)
    >>> found.kind, found.period.round(3)
    (array([1, 2], dtype=int8), array([   nan, 34.267]))
    """
    require_answered("fate_map", p)
    model = model_of(p)
    p.require(*p.ranges)
    p = p.given(**values)
    inputs = {name: p[name] for name in p.ranges}
    # The rate of a clock depends on the point.
    given = list(initial_state(model, start, {}, p).values())[: model.field.deviations]
    begun, options = tuple(map(float, given)), options or MotionOptions()
    settings = {
        "start": begun,
        "t_end": as_number(
            "t_end",
            _longest(model, inputs, begun, options.times[-1]) if t_end is None else t_end,
            POSITIVE,
        ),
        "backend": integrators.choose(backend, integrators.OF_ANY_MODEL),
        "options": options,
    }
    if store is not None and Path(store).suffix != ".csv":
        raise ParameterError(f"store = {store} does not end in .csv")
    work, made = partial(_records, model, settings), partial(_made, model, inputs, settings)
    key = partial(fingerprint, model, inputs, settings)
    return made_or_loaded(
        Computation(inputs, work, made, MEASURED, "why", key), workers, progress, store
    )


def _longest(
    model: Model, inputs: Mapping[str, FloatArray], start: tuple[float, ...], longest: float
) -> float:
    """Default duration for all points: ``longest`` times the largest of their units of time."""
    units = list[float]()
    for point in np.broadcast(*inputs.values()):
        with suppress(ParameterError, ArithmeticError):  # no motion is possible there
            state = state_of(
                model, start, p=model.Parameters(**dict(zip(inputs, point, strict=True)))
            )
            units.append(scales_of(model.field, model.field.constants(point), state.tolist()).time)
    return longest * max(units, default=1.0)


def _records(
    model: Model, settings: Mapping[str, Any], points: Sequence[tuple[float, ...]]
) -> list[Record]:
    """The record of the only point in ``points``; undecided, with the reason, if no motion is
    possible there.
    """
    (values,) = points
    named = dict(zip(model.parameters, values, strict=True))
    try:
        found = fate(model.Parameters(**named), **settings)
    except (ParameterError, ArithmeticError) as error:
        return [([], f"{UNFOLLOWED}: {error}")]
    kind = FateKind[found.kind.upper().replace("-", "_")]
    which = 1 if found.trivial == 0 else 0
    largest, width = float(found.exponents[which]), float(found.error[which])
    return [
        ([float(kind), found.outcome.period, largest, width, found.time_scale, found.t], found.why)
    ]


def _made(
    model: Model,
    inputs: dict[str, FloatArray],
    settings: Mapping[str, Any],
    columns: dict[str, Any],
    _: object,
) -> FateMap:
    """The map with these columns."""
    columns["kind"] = np.nan_to_num(columns["kind"], nan=FateKind.UNDECIDED).astype(np.int8)
    return FateMap(inputs, **settings, **columns, model=model)
