"""Distance of a design to a jump, and the least change of it that moves a jump beyond a target."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from ..core.errors import ConvergenceError, ParameterError, require_kind
from ..core.questions import Method, model_of, question
from ..models.parameters import FloatArray, ParameterSet, as_number
from ..models.quantities import QuantityValues
from ..numerics.interval_arrays import BoolArray
from ..numerics.vectors import norm
from ..results import Result
from .certificates import BoxParts, Decision
from .design_space import Design, EndOfState, MarginOptions, Space, nearest, space
from .jumps import jump_value, no_state_to_follow
from .tube_certificates import claims


@dataclass(frozen=True)
class JumpMargin(Result):
    """The nearest parameters at which the reference state jumps as the friction rises to μ₀.

    Attributes
    ----------
    distance : float
        Root of the sum of squares of the changes over their tolerances; 0 if it jumps as it is,
        ``inf`` if nothing near jumps.
    proved : float
        Within this distance nothing jumps, proved; NaN where it was not asked for.
    change : dict of str to float
        What changes, by how much.
    parameters : Parameters or PhysicalParameters or None
        The nearest point, on the fold itself.
    """

    distance: float
    proved: float
    change: Mapping[str, float]
    parameters: ParameterSet | QuantityValues | None


@question
def jump_margin(
    p: ParameterSet | QuantityValues | Design,
    scale: Mapping[str, float],
    *,
    vary: str | None = None,
    begin: float | None = None,
    options: MarginOptions | None = None,
    method: Method = "auto",
) -> JumpMargin:
    """The nearest parameters at which the followed state ends as ``vary`` rises to its value, in
    the metric of the tolerances.

    Parameters
    ----------
    p : Parameters or PhysicalParameters
        One design, with its friction.
    scale : mapping of str to float
        A tolerance for each quantity that may be off; the others stay.
    vary, begin : str and float, optional
        The parameter that rises, mu0 unless told otherwise, and from where, the lower end of its
        range.
    options : MarginOptions, optional
        Limits of the search, and whether to prove that nothing jumps within a part of the distance.
    method : {"auto", "closed", "search"}
        Whether what is asked on the way may be answered by closed forms.

    Returns
    -------
    JumpMargin

    Raises
    ------
    ParameterError
        For quantities that ``p`` does not have, tolerances that are not positive, and a proof with
        physical quantities.
    ConvergenceError
        Where no state is in contact at ``begin``.

    Notes
    -----
    Source: F = 0, det K = 0 at the least change. That the point found is on a fold at which that
    state jumps is certain; that there is no nearer one is known within ``proved`` only: the search
    follows the fold that ends the state, and asks along rays for nearer ones; where the state has
    no end, it goes out along them, up to 256 tolerances away.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> p = ss.Parameters.article(theta0=np.radians(40.0))
    >>> margin = ss.jump_margin(p, {"theta0": np.radians(1.0), "mu0": 0.05})
    >>> round(margin.distance, 4), {name: round(value, 4) for name, value in margin.change.items()}
    (1.6845, {'theta0': 0.0114, 'mu0': 0.0776})
    >>> p = ss.load("cubic_contact").Parameters(theta0=0.7, gamma=3000.0, mu0=0.5)
    >>> margin = ss.jump_margin(p, {"mu0": 0.05})
    >>> round(margin.distance, 6)
    1.948441
    """
    name, first = model_of(p).rising(vary, begin)
    options = options or MarginOptions()
    designs = space(p, scale, "scale")
    if options.prove and not isinstance(p, ParameterSet):
        raise ParameterError(
            "MarginOptions: prove = True is for dimensionless Parameters; call .dimensionless() "
            "and give their tolerances"
        )

    here = designs.sets(np.zeros(len(designs.names)))
    none = no_state_to_follow(here.replace(**{name: first}), name)
    if none:
        raise ConvergenceError(none)
    border = EndOfState(designs, name, first)
    border.require_beginning()

    def jumped(z: FloatArray) -> BoolArray:
        return border.ended(z) == 1

    def on_fold(z: FloatArray) -> FloatArray | None:
        better = border.near(z, options.steps)
        # On the fold to rounding: a hair beyond it the state jumps, if it is the one that ends
        # there.
        beyond = (1 + 1e-9 * np.array([1.0, 10.0, 100.0]))[:, None]
        return better if better is not None and jumped(better * beyond).any() else None

    best = nearest(jumped, designs.limits(), on_fold, options)
    # Where nothing was found two tolerances are enough for a proof.
    reach, proved = 2.0 if best is None else norm(best), np.nan
    if options.prove:
        radii = (share * reach for share in (0.95, 0.8, 0.5, 0.2) if reach)
        proved = next(
            (
                radius
                for radius in radii
                if safe_within(designs, radius, name, first, options.proof)
            ),
            0.0,
        )
    if best is None:
        return JumpMargin(np.inf, proved, {}, None)
    return JumpMargin(reach, proved, designs.change(best), designs.made(best))


def safe_within(
    designs: Space, radius: float, vary: str, begin: float, proof: float = 0.15
) -> bool:
    """Whether it is proved that no state ends within a ball: over parts of the box around it, as
    far as they are in the ball.

    Of what rises only the largest value matters that the ball has over a part of the others.
    """
    low, high = designs.limits()
    if (low > -radius).any() or (high < radius).any():
        return False
    corners = [designs.sets(np.full(len(designs.names), side * radius)) for side in (-1, 1)]
    box = claims((corners[0], corners[1]), "no jump", vary=vary, begin=begin)
    names = [name for name in designs.names if name in box.sides and name != vary]
    rows, columns = ([order.index(name) for name in names] for order in (box.sides, designs.names))
    origin, scale = designs.origin[columns, None], designs.scale[columns, None]

    def inside(parts: BoxParts) -> BoxParts:
        off = (np.clip(origin, parts.low[rows], parts.high[rows]) - origin) / scale
        left = (radius * (1 + 1e-9)) ** 2 - (off**2).sum(axis=0)
        if vary in designs.names:
            k, row = designs.names.index(vary), box.sides.index(vary)
            parts.low[row] = parts.high[row] = designs.origin[k] + designs.scale[k] * np.sqrt(
                np.maximum(left, 0.0)
            )
        return parts[left >= 0]

    run = box.run(lambda parts: parts.open_volume, int(proof * box.most), kept=inside)
    return all((parts.outcome[last] == Decision.PROVED).all() for parts, last, _ in run)


@dataclass(frozen=True)
class Redesign(Result):
    """The least change that keeps a jump beyond its target.

    Attributes
    ----------
    distance : float
        Root of the sum of squares of the changes over their scales; 0 if nothing need change,
        ``inf`` if nothing was found.
    change : dict of str to float
        What to change, by how much.
    parameters : Parameters or PhysicalParameters or None
        The new design.
    jump : dict of str to float
        Where the reference state jumps in the new design, solved for again, exactly; NaN where it
        never does.
    """

    distance: float
    change: Mapping[str, float]
    parameters: ParameterSet | QuantityValues | None
    jump: Mapping[str, float]


@question
def redesign(
    p: ParameterSet | QuantityValues | Design,
    change: str | Iterable[str] | Mapping[str, float],
    target: Mapping[str, float],
    *,
    begin: float | None = None,
    options: MarginOptions | None = None,
    method: Method = "auto",
) -> Redesign:
    """The least change of some quantities that keeps the end of the followed state beyond a target.

    Parameters
    ----------
    p : Parameters or PhysicalParameters
        One design.
    change : str, sequence of str, or mapping of str to float
        What may change: parameters, or physical quantities of :class:`PhysicalParameters`; a
        mapping gives each a tolerance, in which changes are measured, and otherwise its own value
        is that.
    target : mapping of str to float
        For parameters that rise, as ``mu0`` or ``theta0``, below what value the state may not end.
    begin : float, optional
        From where they rise instead of the lower end of their range: from its value in ``p`` a
        design whose state has ended below that looks like one whose state goes on.
    options : MarginOptions, optional
        Limits of the search.
    method : {"auto", "closed", "search"}
        Whether what is asked on the way may be answered by closed forms.

    Returns
    -------
    Redesign

    Raises
    ------
    ParameterError
        For quantities that ``p`` does not have, a target that is no parameter, or one that is to
        change itself.

    Notes
    -----
    Source: F = 0, det K = 0 at the target. That the new design keeps it is verified; that there is
    no smaller change is not proved: the search follows the fold, and asks along rays for nearer
    ones, or goes out along them, up to 256 scales away, if it knows none.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> p = ss.Parameters.article(theta0=np.radians(40.0))
    >>> better = ss.redesign(p, ("sigma", "theta0"), {"mu0": 0.7})
    >>> round(better.distance, 4), {name: round(value, 4) for name, value in better.change.items()}
    (0.115, {'sigma': 0.0016, 'theta0': -0.0795})
    >>> round(better.jump["mu0"], 9)
    0.7
    """
    model = model_of(p)
    ranges = model.Parameters.ranges
    require_kind("target", target, Mapping, "values below which nothing may end, by name")
    if not target or not set(target) <= set(ranges):
        raise ParameterError(
            f"target = {dict(target)!r}; give parameters of {model.name} below whose values "
            "nothing may end"
        )
    designs, options = space(p, change, "change"), options or MarginOptions()
    begin = None if begin is None else as_number("begin", begin)
    borders = list[EndOfState]()
    for name, value in target.items():
        if name in designs.names:
            raise ParameterError(
                f"{name} is the target and can't be what changes; leave it out of one of the two"
            )
        at = designs.at(name, as_number(f"target[{name!r}]", value, ranges[name]))
        lowest = ranges[name].reached(ranges[name].low)
        own = (
            lowest
            if np.isfinite(lowest)
            else float(designs.parameters(np.zeros(len(designs.names)))[name])
        )
        borders.append(EndOfState(at, name, own if begin is None else begin))
        borders[-1].require_beginning()

    def keeps(z: FloatArray) -> BoolArray:
        return np.all([border.ended(z) == 0 for border in borders], axis=0)

    def on_target(z: FloatArray) -> FloatArray | None:
        """The nearest design on a fold at one of the targets, verified."""
        candidates = []
        # A design on the target is moved outward by the first of these shares at which
        # it is verified.
        nudges = np.array([0.0, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6])
        for border in borders:
            better = border.near(z, options.steps)
            if better is not None:
                outward = better * (1 + nudges)[:, None]
                candidates += list(outward[keeps(outward)][:1])
        return min(candidates, key=norm, default=None)

    best = nearest(keeps, designs.limits(), on_target, options)
    if best is None:
        return Redesign(np.inf, {}, None, {})
    jump = {
        border.vary: float(jump_value(designs.sets(best), border.vary, begin=border.begin))
        for border in borders
    }
    return Redesign(norm(best), designs.change(best), designs.made(best), jump)
