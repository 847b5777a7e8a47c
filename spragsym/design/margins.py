"""Distance of a design from a jump, and the least change of a design that moves a jump beyond a
target.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from ..core.errors import ParameterError, require_kind
from ..core.questions import Method, model_of, question
from ..display import Column
from ..models.parameters import FloatArray, ParameterSet, as_number
from ..models.quantities import QuantityValues
from ..numerics.interval_arrays import BoolArray
from ..numerics.vectors import norm
from ..results import Result
from .certificates import BoxParts, Decision
from .design_space import Design, EndOfState, MarginOptions, Space, nearest, space
from .jumps import jump_value
from .tube_certificates import claims


@dataclass(frozen=True)
class JumpMargin(Result):
    """The nearest parameters at which the followed state jumps as the friction rises to μ₀.

    Attributes
    ----------
    distance : float
        Root of the sum of squares of the changes over their tolerances; 0 if the design itself
        jumps, ``inf`` if none was found that does.
    proved : float
        It is proved that no design within this distance jumps; NaN if no proof was asked for.
    change : dict of str to float
        Change of each quantity.
    parameters : Parameters or PhysicalParameters or None
        The nearest point, on the fold itself.
    remarks : tuple of str
        Where nearer designs were met of which it is not known whether they jump.
    """

    schema = (Column("{a}_change", "{a}", "change of {a}"),)

    distance: float
    proved: float
    change: Mapping[str, float]
    parameters: ParameterSet | QuantityValues | None
    remarks: tuple[str, ...] = ()


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
        A tolerance for each quantity that may change; the others stay as they are.
    vary, begin : str and float, optional
        The parameter that rises, by default mu0, and the value from which it rises, by default the
        lower end of its range.
    options : MarginOptions, optional
        Limits of the search, and whether to prove that nothing jumps within a part of the distance.
    method : {"auto", "closed", "search"}
        Whether closed forms may answer the questions of the search, must, or must not.

    Returns
    -------
    JumpMargin

    Raises
    ------
    ParameterError
        For quantities that ``p`` does not have, tolerances that are not positive, and a proof with
        physical quantities.
    ConvergenceError
        If no state is in contact at ``begin``.

    Notes
    -----
    Source: F = 0, det K = 0 at the least change. The state is verified to jump at the design found.
    That there is no nearer one is known only within ``proved``: the search follows the fold at
    which the state ends, and looks along rays for nearer ones. If the state has no end, it goes out
    along the rays, up to 256 tolerances away.

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

    border = EndOfState(designs, name, first)
    border.require_beginning()
    unknown = np.inf

    def jumped(z: FloatArray) -> BoolArray:
        nonlocal unknown
        ended = border.ended(z)
        unknown = np.linalg.norm(z[np.isnan(ended)], axis=-1).min(initial=unknown)
        return ended == 1

    def on_fold(z: FloatArray) -> FloatArray | None:
        better = border.near(z, options.steps)
        # The followed state must jump just beyond the fold: another one may end there.
        beyond = (1 + 1e-9 * np.array([1.0, 10.0, 100.0]))[:, None]
        return better if better is not None and jumped(better * beyond).any() else None

    best = nearest(jumped, designs.limits(), on_fold, options)
    # If nothing was found, a proof within two tolerances is tried.
    distance, proved = 2.0 if best is None else norm(best), np.nan
    if options.prove:
        radii = (share * distance for share in (0.95, 0.8, 0.5, 0.2) if distance)
        safe = (r for r in radii if safe_within(designs, r, name, first, options.proof))
        proved = next(safe, 0.0)
    # Designs just beside the one that was found are unknown only because they lie on the fold.
    nearer = unknown < (np.inf if best is None else distance - 1e-6 * max(1.0, distance))
    text = (
        f"whether some designs at a distance of {unknown:.3g} or farther jump is not known, "
        f"as where no state is in contact where {name} begins"
    )
    remarks = (text,) if nearer else ()
    if best is None:
        return JumpMargin(np.inf, proved, {}, None, remarks)
    return JumpMargin(distance, proved, designs.change(best), designs.made(best), remarks)


def safe_within(
    designs: Space, radius: float, vary: str, begin: float, proof: float = 0.15
) -> bool:
    """Whether it is proved that no state ends within a ball about the design, in units of the
    tolerances.

    Parts of the box around the ball are decided, as far as they meet it. Of the parameter that
    rises, only the largest value within the ball matters for a part of the others.
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
        distance = (np.clip(origin, parts.low[rows], parts.high[rows]) - origin) / scale
        rest = (radius * (1 + 1e-9)) ** 2 - (distance**2).sum(axis=0)
        if vary in designs.names:
            k, row = designs.names.index(vary), box.sides.index(vary)
            parts.low[row] = parts.high[row] = designs.origin[k] + designs.scale[k] * np.sqrt(
                np.maximum(rest, 0.0)
            )
        return parts[rest >= 0]

    run = box.run(lambda parts: parts.open_volume, int(proof * box.most), kept=inside)
    return all((parts.outcome[last] == Decision.PROVED).all() for parts, last, _ in run)


@dataclass(frozen=True)
class Redesign(Result):
    """The least change of a design that keeps a jump beyond its target.

    Attributes
    ----------
    distance : float
        Root of the sum of squares of the changes over their scales; 0 if no change is needed,
        ``inf`` if none was found.
    change : dict of str to float
        Change of each quantity.
    parameters : Parameters or PhysicalParameters or None
        The new design.
    jump : dict of str to float
        Jump values of the new design, computed again; NaN where it never jumps.
    """

    schema = (
        Column("{a}_change", "{a}", "change of {a}"),
        Column("{a}_jump", "{a}", "jump value of {a} in the new design"),
    )

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
        The quantities that may change: parameters, or physical quantities of
        :class:`PhysicalParameters`. A mapping gives the tolerance in which each change is measured;
        otherwise a change is measured relative to the quantity.
    target : mapping of str to float
        For each parameter that rises, as ``mu0`` or ``theta0``, the value below which the state may
        not end.
    begin : float, optional
        The value from which they rise; by default the lower end of the range. If it is the value
        in ``p``, an end of the state below that value is not noticed.
    options : MarginOptions, optional
        Limits of the search.
    method : {"auto", "closed", "search"}
        Whether closed forms may answer the questions of the search, must, or must not.

    Returns
    -------
    Redesign

    Raises
    ------
    ParameterError
        For quantities that ``p`` does not have, a target that is no parameter, or one that may
        change itself.

    Notes
    -----
    Source: F = 0, det K = 0 at the target. The new design is verified to keep the target. That
    there is no smaller change is not proved: the search follows the fold, and looks along rays for
    nearer ones, or goes out along the rays, up to 256 scales away, if it knows none.

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
        first = ranges[name].reached(ranges[name].low) if begin is None else begin
        if not np.isfinite(first):
            first = float(designs.parameters(np.zeros(len(designs.names)))[name])
        borders.append(EndOfState(at, name, first))

    def keeps(z: FloatArray) -> BoolArray:
        return np.all([border.ended(z) == 0 for border in borders], axis=0)

    def on_target(z: FloatArray) -> FloatArray | None:
        """The nearest design on a fold at one of the targets, verified."""
        candidates = []
        # A design on the border itself is moved outward by the first of these shares at which it
        # is verified.
        nudges = np.array([0.0, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6])
        for border in borders:
            better = border.near(z, options.steps)
            if better is not None:
                outward = better * (1 + nudges)[:, None]
                candidates += list(outward[keeps(outward)][:1])
        return min(candidates, key=norm, default=None)

    best = nearest(keeps, designs.limits(), on_target, options)
    if best is None:
        for border in borders:
            border.require_beginning()
        return Redesign(np.inf, {}, None, {})
    jump = {
        border.vary: float(jump_value(designs.sets(best), border.vary, begin=border.begin))
        for border in borders
    }
    return Redesign(norm(best), designs.change(best), designs.made(best), jump)
