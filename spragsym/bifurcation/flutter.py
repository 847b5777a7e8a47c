"""Onsets of flutter of a model along one parameter, each proved, with or without damping.

With damping an onset is a Hopf point of det(λ² M + λ (C + G) + K) = 0. Without, it is a point where
two frequencies meet, or, where gyroscopic terms act beside a force without a potential, one at
which the odd coefficients of that polynomial are 0: at any other state some λ grows. Where the
search is incomplete, floats follow the states over samples of the parameter, and report crossings
that are not proved as ``"detected"``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from itertools import chain, pairwise
from typing import TYPE_CHECKING, Any, Self, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..core.errors import ParameterError
from ..core.questions import Method, question
from ..core.remarks import At, Remark
from ..display import Column, own_name
from ..models.parameters import ParameterSet, Ranges
from ..numerics.balls import UndecidedSign
from ..numerics.certified_roots import Roots, distinct
from ..numerics.interval_arrays import (
    ComplexArray,
    FloatArray,
    IntArray,
    Intervals,
    ends_around,
    quiet,
    scale_of,
    spans_of,
)
from ..numerics.vectors import in_one_turn, magnitude
from ..results import Points
from ..results.points import UNSTABLE
from ..statics import stability
from ..statics.balance import NEGLIGIBLE, Balance
from ..statics.forces import Evaluation
from ..statics.options import SearchOptions
from ..statics.precise_balance import clusters, on_contact_side, refined
from ..statics.search import balances_of, float_candidates, number_of
from ..statics.stability import (
    damped_by_friction_alone,
    damped_entries,
    is_conservative,
    is_damped,
    slope_over,
    unpaired,
)
from .defining_systems import (
    FLUTTER,
    HOPF,
    NO_SLOPE,
    Augmented,
    Block,
    Condition,
    Family,
    blocks_of,
    no_damping,
    paired,
    undamped_mode,
    within_block,
)
from .points import (
    Found,
    all_of,
    arranged,
    in_lift_off,
    matrices,
    merged,
    nothing,
    of_ends,
    search,
    together,
)

if TYPE_CHECKING:
    from .normal_forms import Coefficient, NormalForm

#: Of an onset at which a state is unstable on both sides.
ON_UNSTABLE = "on an unstable state"
#: Frequencies ω of what oscillates at a state, from its M, C + G and K.
Frequencies: TypeAlias = Callable[[FloatArray, FloatArray, FloatArray], list[float]]
#: Points of one search, their kinds and their frequencies.
_Part: TypeAlias = tuple[Found, list[str], list[float]]


@question
def flutter_onsets(
    p: ParameterSet,
    vary: str | None = None,
    *,
    damping: bool | None = None,
    between: Ranges | None = None,
    within: Ranges | None = None,
    threshold: float | None = None,
    options: SearchOptions | None = None,
    method: Method = "auto",
) -> Onsets:
    """Onsets of flutter in contact along one parameter; ``complete`` says whether these are all.

    Remarks name those that are found at states in which no contact touches.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; the value of the one that varies is not used.
    vary : str, optional
        The parameter; by default ``theta0``, or the model's first one.
    damping : bool, optional
        True for Hopf points of the full linearization, det(λ² M + λ (C + G) + K) = 0 with dampers
        and slopes of the friction laws. False for (27), without C, as the article's flutter. By
        default True unless C is 0, decided for each combination of touching contacts.
    between, within, options, method
        As for :func:`spragsym.folds`; a closed form is there for (27) along θ₀.
    threshold : float, optional
        Growth in 1/s above which it counts, of :func:`spragsym.matrices` alone. Their onsets are
        :class:`spragsym.results.MatrixOnsets`, and their options ``MatrixOptions``.

    Returns
    -------
    Onsets
        The kind is ``"hopf"`` where a pair ± i ω crosses the imaginary axis, ``"flutter"`` where
        two frequencies meet, or where without damping all λ come in pairs ± λ and at no state
        nearby, and ``"detected"`` where floats see a crossing that is not proved,
        because the search was incomplete. ``omega`` is the frequency; ``criticality`` says whether
        an onset is super- or subcritical. Where all damping changes its sign at once, as by a
        falling friction law against a damper, every pair of a state crosses, and each has a row.
        Closed forms add ``branch``, the number of the equilibrium from below in θ, from 0,
        ``count``, the number of equilibria, and ``side``: 1 if the state flutters at slightly
        larger θ₀, −1 if at slightly smaller θ₀, 0 if the boundary is only touched.

    Raises
    ------
    ParameterError
        For a parameter that is missing or an array.
    ConvergenceError
        At degenerate parameters of the article's model, where onsets can't be separated.

    Notes
    -----
    Source: F = 0 with Hurwitz's determinant of order 2 n − 1, or with the discriminant of
    det(K − κ M) in κ, or with an odd coefficient of det(λ² M + λ G + K). If only one coordinate is
    damped, its entry of C (or the slope of the friction law) is a factor of Hurwitz's determinant;
    this factor and the other are then searched separately. An end of the range at which C, or the
    odd coefficient, vanishes is no onset. Points where a real pair ± λ has the sum 0, or two real λ
    meet, are roots too and are left out.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> found = ss.flutter_onsets(ss.Parameters.article(alpha=0.7), damping=False)
    >>> print(np.degrees(found.theta0).round(6), found.side)
    [135.389588 166.068824] [ 1 -1]
    >>> onsets = ss.flutter_onsets(ss.load("stick_slip").Parameters(), vary="V")
    >>> onsets.V.round(4).tolist(), onsets.criticality.tolist()
    ([0.101, 1.4035], ['supercritical', 'subcritical'])
    """
    if threshold is not None:
        raise ParameterError(
            f"threshold = {threshold!r:.60} is for matrices; leave it out for {p.model.name}"
        )
    name = p.model.one(vary)
    families = Family.every(p, (name,), between, within, options)
    found = together([_in_combination(family, damping) for family in families])
    others = in_lift_off(families[0], between, within, partial(_in_combination, damping=damping))
    return Onsets(**vars(found) | {"remarks": (*found.remarks, *others)})


@dataclass(frozen=True)
class Sought:
    """One kind of onset in a block of coordinates: its condition, and the frequencies at a state.

    ``block`` is None for all coordinates.
    """

    condition: Condition
    frequencies: Frequencies
    kind: str
    block: Block

    @property
    def leaves_pairs(self) -> bool:
        """Whether λ come in pairs ± λ at an onset alone: on both sides of it some λ grows."""
        return self.kind == "flutter" and self.frequencies is every

    @property
    def has_simple_pair(self) -> bool:
        """Whether a single pair of eigenvalues is imaginary at an onset, as a normal form needs."""
        return self.kind != "flutter" and self.frequencies is not every

    def omega(self, *linearization: FloatArray) -> list[float]:
        """Frequencies at a state, from M, C + G and K of all coordinates."""
        if self.block is None:
            return self.frequencies(*linearization)
        part = np.ix_(self.block, self.block)
        return self.frequencies(*(one[part] for one in linearization))


@dataclass(frozen=True)
class OnsetSystems:
    """The conditions to search for onsets of a family, with or without damping.

    ``only`` is the one coordinate that is damped, if there is just one.
    """

    damping: bool
    only: int | None
    blocks: list[tuple[int, ...]]
    sought: list[Sought]

    @classmethod
    def of(cls, family: Family, damping: bool | None) -> Self:
        """The conditions for one combination of touching contacts; ``damping`` None means True
        unless there is none.
        """
        balance, over = family.balance, family.over
        # The factorization by one damped coordinate does not hold with gyroscopic forces.
        along = None if balance.gyroscopic else damped_by_friction_alone(balance, over)
        slope = None if along is None else slope_over(balance, over)
        entries, only = damped_entries(balance, over), along
        if along is None and not balance.gyroscopic and len(entries) == 1:
            row, column = entries[0]
            only = row if row == column else None
        if damping is None and slope is not None:
            damping = bool(slope.magnitude.max() > NEGLIGIBLE)
        elif damping is None:
            damping = is_damped(balance, over)
        blocks = blocks_of(family, Evaluation.by_rates if damping else Evaluation.gyroscopic)
        damped = frozenset[int]()
        if damping:  # beside friction that damps alone, entries of C are negligible
            damped = frozenset(row for row, _ in entries) if only is None else frozenset({only})
        conservative = is_conservative(balance, over)
        sought = list[Sought]()
        for block in blocks:
            own = None if len(blocks) == 1 else block
            odd = unpaired(balance, over, block)
            if odd and not damping:
                condition = within_block(paired(odd[0]), own)
                sought.append(Sought(condition, every, "flutter", own))
            elif not odd and not damped & {*block}:
                # With a symmetric K all κ are real, and two that meet pass each other.
                if not conservative and len(block) > 1:
                    sought.append(Sought(within_block(FLUTTER, own), meeting, "flutter", own))
            elif only is None or balance.n == 1:
                sought.append(Sought(within_block(HOPF, own), crossing, "hopf", own))
            else:
                # With a symmetric K, damping of one sign keeps all pairs on one side of the axis.
                if not conservative and len(block) > 1:
                    along = block.index(only)
                    mode = within_block(undamped_mode(along), own)
                    sought.append(Sought(mode, partial(_without, along), "hopf", own))
                if slope is None:
                    sought.append(Sought(no_damping(only), every, "hopf", own))
                elif conservative or slope.holds_zero().any():
                    sought.append(Sought(NO_SLOPE, every, "hopf", own))
        # NO_SLOPE comes last: its undecided boxes have remarks of their own.
        sought.sort(key=lambda one: one.condition is NO_SLOPE)
        return cls(damping, only, blocks, sought)


def _in_combination(family: Family, damping: bool | None) -> Points:
    """Onsets of one combination of touching contacts."""
    systems = OnsetSystems.of(family, damping)
    parts, said = list[_Part](), list[str]()
    for one in systems.sought:
        out = search(family, one.condition)
        if one.leaves_pairs:
            said.append(_growing(family, one))
        if out.roots.undecided.shape[2]:
            out, unproved, omega = with_seen(Augmented(family, one.condition), out)
            detected = replace(out, roots=unproved)
            if one.condition.pairs:
                parts.append((detected, ["detected"] * omega.size, omega.tolist()))
            else:
                kind = replace(one, kind="detected")
                parts.append(_part(family, detected, kind, systems.damping))
        parts.append(_part(family, out, one, systems.damping))
    parts = parts or [(nothing(family), [], [])]
    flat = bool(systems.sought) and systems.sought[-1].condition is NO_SLOPE
    return _joined(family, parts, flat=flat, said=tuple(said))


def _growing(family: Family, sought: Sought) -> Remark:
    """The remark on a family in which some λ grows without damping at almost every state."""
    (name,), ends = family.vary, sorted({*family.spans[0].tolist()})
    paired = [
        At(name, (end,), "g")
        for end in ends
        if not unpaired(family.balance, Intervals.point(family.at(np.array([[end]]))), sought.block)
    ]
    return Remark(
        "without damping some λ grows in every state that is not listed, since gyroscopic terms "
        "act beside friction or another force without a potential"
        + "".join("; but not at {}, where all λ come in pairs ± λ" for _ in paired)
        + "; damping=True asks for the onsets of the damped model",
        *paired,
    )


# ------------------------------------------------------------------------------------------------
# frequencies


def _part(family: Family, found: Found, sought: Sought, damping: bool) -> _Part:
    """The roots with their kinds and frequencies, one row for each frequency; none for a root whose
    λ are real.
    """
    rows, omega = list[int](), list[float]()
    linearization = matrices(family, found.roots.middle, damping)
    for row, each in enumerate(zip(*linearization, strict=True)):
        own = sought.omega(*each)
        omega += own
        rows += [row] * len(own)
    return (
        replace(found, roots=found.roots.select(np.array(rows, dtype=int))),
        [sought.kind] * len(rows),
        omega,
    )


def crossing(M: FloatArray, C: FloatArray, K: FloatArray) -> list[float]:
    """ω of the two roots λ of det(λ² M + λ (C + G) + K) whose sum is nearest to 0; none if they are
    real.
    """
    roots = stability.roots(M, C, K)
    one = _nearest(roots, -roots)
    return [float(abs(one.imag))] if abs(one.imag) > abs(one.real) else []


def _nearest(numbers: ComplexArray, others: ComplexArray) -> NDArray[Any]:
    """The number whose distance from an element of ``others`` at another index is least."""
    distance = np.abs(numbers[:, None] - others)
    np.fill_diagonal(distance, np.inf)
    return numbers[distance.min(axis=1).argmin()]


def _omega(square: NDArray[Any]) -> list[float]:
    """ω = √κ, if κ is positive."""
    return [float(np.sqrt(square.real))] if square.real > 0 else []


def meeting(M: FloatArray, G: FloatArray, K: FloatArray) -> list[float]:
    """ω of the two roots κ = −λ² of det(λ² M + λ G + K) that are nearest to each other; none if
    they are negative.
    """
    if G.any():
        roots = stability.roots(M, G, K)
        squares = -(roots[roots.imag > 0] ** 2)
        return [] if squares.size < 2 else _omega(_nearest(squares, squares))
    squares = stability.squares(M, K)
    return _omega(_nearest(squares, squares))


def _without(along: int, M: FloatArray, C: FloatArray, K: FloatArray) -> list[float]:
    """ω of a mode in which the coordinate ``along`` does not move.

    It is the root κ of the minor without this coordinate that is nearest to a root of all
    coordinates.
    """
    others = [i for i in range(len(K)) if i != along]
    squares = stability.squares(M[np.ix_(others, others)], K[np.ix_(others, others)])
    distance = np.abs(squares[:, None] - stability.squares(M, K)[None]).min(axis=1)
    return _omega(squares[distance.argmin()])


def every(M: FloatArray, C: FloatArray, K: FloatArray) -> list[float]:
    """ω of all pairs of a state without damping."""
    return frequencies(stability.roots(M, C, K))


def frequencies(roots: ComplexArray) -> list[float]:
    """ω of the pairs ± i ω among roots, ascending; real parts up to 1e-5 ω are neglected."""
    return sorted(
        abs(root.imag) for root in roots[roots.imag > 0] if abs(root.real) < 1e-5 * root.imag
    )


def _joined(family: Family, parts: list[_Part], flat: bool, said: tuple[str, ...] = ()) -> Points:
    """The points of all searches as one result.

    ``flat`` says that the last search was for places where the slope of the friction law vanishes.
    """
    each, kinds, frequencies = zip(*parts, strict=True)
    kind, omega = np.array([*chain(*kinds)], dtype=str), np.array([*chain(*frequencies)])
    found = all_of(each)

    def symmetric(end: float, left: FloatArray) -> str:
        if not is_conservative(family.balance, Intervals.point(family.at(np.array([[end]])))):
            return ""
        return (
            ": K is symmetric there, so that no pair crosses, but whether one does beside it is "
            "not known"
        )

    remarks = (
        *said,
        *(_undamped(family, each[-1].roots.undecided) if flat else ()),
        *of_ends(family, found, symmetric),
    )
    samples = family.balance.options.samples
    if detected := int((kind == "detected").sum()):
        remarks += (
            f"{detected} onsets are numerically detected between two of {samples} values, and "
            "not proved",
        )
    elif found.roots.undecided.shape[2] and not flat:
        remarks += (
            f"floats see no other onset between two of {samples} values of {family.vary[0]}",
        )
    own = own_name(family.p.model, "omega")
    return arranged(family, found, kind, {own: omega}, remarks)


def _undamped(family: Family, left: FloatArray) -> tuple[str, ...]:
    """Remark on undecided boxes where the slope of the friction law is practically 0."""
    balance = family.balance
    over = Intervals.between(family.at(-left[0, -1:]), family.at(left[1, -1:]))
    size = slope_over(balance, over).magnitude
    flat = size <= 1e-100  # as good as 0
    most = f"{size[flat].max(initial=0.0):.0e}"
    text = (
        f"the slope of the friction law, and with it its damping, is at most {most}: too little "
        "for floats"
    )
    return (f"in {int(flat.sum())} of {flat.size} undecided boxes {text}",) if flat.any() else ()


def with_seen(system: Augmented, found: Found) -> tuple[Found, Roots, FloatArray]:
    """The result of a search with onsets added that floats detect and that are proved; the detected
    ones that are not proved, and their frequencies.
    """
    from scipy.optimize import linear_sum_assignment  # heavy, and a refusal does not need it

    fixed, seen = system.family.begin, np.array(_sightings(system, found.roots.undecided))
    seen = seen.reshape(-1, system.n + 1)
    # The search goes beyond both ends of a turn: an image of a state there is seen as well.
    own = (in_one_turn(seen, system.balance.periodic) == seen) | np.isnan(seen)
    detected = seen[own.all(axis=1)].T
    candidates = detected[:-1]
    around = ends_around(candidates, 1e-6 * scale_of(candidates))
    tried = refined(system, fixed, Roots.at(around))
    accurate = tried.error <= system.options.tolerance
    proved, open_ = (
        on_contact_side(system, fixed, Roots.at(tried.ends[:, :, mask]))
        for mask in (accurate, ~accurate)
    )
    distance = np.abs(candidates[:, ~accurate, None] - open_.middle[:, None]).max(axis=0)
    # Several pairs may cross at one state, each with its own frequency.
    omega = detected[-1, ~accurate][linear_sum_assignment(distance.T)[1]]
    roots = distinct(found.roots.concatenated(proved.select(undecided=slice(0))))
    return replace(found, roots=roots), open_, omega


def _sightings(system: Augmented, undecided: FloatArray) -> list[FloatArray]:
    """Onsets that floats detect between values of the parameter: coordinates, parameter and ω, NaN
    if no pair was followed.

    The values are samples of the range, its ends, and values on both sides of undecided boxes. Each
    state is compared with the nearest one at the next value, and the step is bisected where a pair
    crosses.
    """
    low, high = system.family.spans[0]
    samples = system.options.samples
    even = low + (high - low) * (np.arange(samples) + 0.5) / samples
    # So far from undecided boxes that eigenvalues at a crossing in one are told from 0.
    room = 1e-6 * (high - low) * np.array([-1.0, 1.0])
    beside = np.sort((spans_of(merged(undecided))[-1] + room).clip(low, high).ravel())
    chosen = np.linspace(0, beside.size - 1, min(beside.size, samples)).astype(int)
    values = np.unique([low, *even, *beside[chosen], high])
    q, point = _states(
        float_candidates(system.balance, system.family.at(values[None]), system.family.requested)
    )
    z = np.concatenate([q, values[point][None]])
    signals, out = _signals(system, z), list[FloatArray]()
    for state in range(point.size):
        following = np.flatnonzero(point == point[state] + 1)
        if not following.size:
            continue
        other = int(following[np.abs(q[:, following] - q[:, [state]]).max(axis=0).argmin()])
        if _crossing_pairs(signals[state], signals[other]).size:
            out += _bisected(
                system, (z[:, state], signals[state]), (z[:, other], signals[other]), 40
            )
    if system.condition.pairs:
        return out
    # At a pole the condition changes its sign too, but is large there.
    most = 1e-6 * max((magnitude(row) for row in signals if row.size), default=0.0)
    return [state for state in out if (np.abs(_signals(system, state[:-1, None])[0]) <= most).any()]


def _states(found: Roots) -> tuple[FloatArray, IntArray]:
    """Float states and their points: roots, and the middles of undecided boxes that are very small,
    each once.
    """
    ends, point = found.every
    boxes = Intervals(ends)
    small = np.asarray((boxes.width <= 1e-6 * scale_of(boxes.middle)).all(axis=0))
    small[: found.point.size] = True
    hulls, point = clusters(ends[:, :, small], point[small])
    return Intervals(hulls).middle, point


def _crossing_pairs(a: ComplexArray, b: ComplexArray) -> ComplexArray:
    """Numbers of ``a`` whose real part changes its sign to the matched number of ``b``.

    The match minimizes the sum of distances.
    """
    from scipy.optimize import linear_sum_assignment  # heavy, and a refusal does not need it

    i, j = linear_sum_assignment(np.abs(a[:, None] - b[None]))
    size = max(np.abs([*a, *b]), default=0.0)
    before, after = a[i], b[j]
    passes = (before.real * after.real < 0) & (
        np.minimum(np.abs(before.real), np.abs(after.real))
        > 1e-11 * size  # eigenvalues are known to less
    )
    return before[passes]


def _bisected(
    system: Augmented,
    low: tuple[FloatArray, ComplexArray],
    high: tuple[FloatArray, ComplexArray],
    halvings: int,
) -> list[FloatArray]:
    """Onsets between two states with their signals, by bisection in the parameter.

    An onset is coordinates, parameter and ω. Both halves are followed where signals cross in both.
    """
    state = _state(system, 0.5 * (low[0] + high[0]))
    (roots,) = _signals(system, state[:, None])
    middle = state, roots
    halves = [
        (one, other)
        for one, other in pairwise((low, middle, high))
        if _crossing_pairs(one[1], other[1]).size
    ]
    if halvings and halves:
        share = (halvings - 1) // len(halves)
        return [onset for one, other in halves for onset in _bisected(system, one, other, share)]
    crossing = _crossing_pairs(low[1], high[1])
    if not system.condition.pairs:
        return [np.append(state, np.nan) for _ in crossing]
    # A larger share of growth is no crossing: the two states do not lie on one branch.
    neutral = 1e-6
    nearest = [roots[np.abs(roots - here).argmin()] for here in crossing if roots.size]
    return [
        np.append(state, abs(here.imag))
        for here in nearest
        if abs(here.real) <= neutral * abs(here)
    ]


def _state(system: Augmented, z: FloatArray) -> FloatArray:
    """The state at the parameter value z[−1], by Newton's method from z."""
    parameters = Intervals.point(system.family.at(z[-1:, None]))
    with quiet():
        q = system.balance.guessed(z[:-1, None], system.balance.prepared(parameters))
    return np.append(q[:, 0], z[-1])


def _signals(system: Augmented, z: FloatArray) -> list[ComplexArray]:
    """Numbers whose real parts change sign at an onset, for each state z, shape (n + 1, N).

    These are the λ above the real axis. If the condition is not on pairs, it is the condition's own
    value, and 0 where its sign is unknown.
    """
    if system.condition.pairs:
        block = system.condition.block or range(system.balance.n)
        part = np.ix_(range(z.shape[1]), block, block)
        every = stability.roots(*(each[part] for each in matrices(system.family, z)))
        return [row[np.isfinite(row) & (row.imag > 1e-6 * np.abs(row))] for row in every]
    error = 2.0**-50  # of a state by Newton's method, over its size
    states = Intervals(ends_around(z, error * scale_of(z)))
    with quiet():
        tested = system.residuals(states, system.fixed(z.shape[1]))[-1]
    finite = np.isfinite(tested.middle)
    values = np.where(finite & tested.holds_zero(), 0.0, tested.middle).astype(complex)
    return [values[[k]] if finite[k] else values[:0] for k in range(values.size)]


def of_forms(forms: Sequence[Any], name: str, missing: float) -> FloatArray:
    """A column of normal forms; ``missing`` for points without one."""
    return np.array([missing if isinstance(form, str) else getattr(form, name) for form in forms])


def unstable_beside(forms: Sequence[Any]) -> IntArray:
    """How many λ grow at smaller and at larger values of the parameter, shape (2, points)."""
    others, crossing = of_forms(forms, "others", -1).astype(int), of_forms(forms, "crossing", 0.0)
    undecided = ~(np.abs(crossing) > of_forms(forms, "crossing_error", np.inf)) | (others < 0)
    return np.where(undecided, -1, others + 2 * np.array([crossing < 0, crossing > 0]))


def onset_of(before: IntArray, after: IntArray) -> NDArray[np.str_]:
    """What sets in where the numbers of λ that grow are these on both sides, in words."""
    least = np.minimum(before, after)
    words = ["undecided", "of instability"]
    return np.select([least < 0, least == 0], words, ON_UNSTABLE)


def _column(name: str, missing: float) -> cached_property[FloatArray]:
    """A cached column of the normal forms of onsets."""
    return cached_property(lambda found: of_forms(found.normal_forms, name, missing))


@dataclass(frozen=True, eq=False)
class Onsets(Points):
    """Onsets of flutter along one parameter, with their normal forms.

    The attributes below are computed on first use, in addition to those of :class:`Points` and the
    frequency ``omega``.

    Attributes
    ----------
    criticality : ndarray of str
        ``"supercritical"`` where l₁ < 0 is proved: the cycle that is born attracts within the plane
        of the pair, and grows from nothing. ``"subcritical"`` where l₁ > 0 is proved: an unstable
        cycle shrinks onto the state, and beyond the onset motions go far. Otherwise
        ``"undecided"``, also where l₁ comes only from the tail of a law that is smoothed at rest.
    lyapunov, lyapunov_error : ndarray
        The first Lyapunov coefficient l₁ and a proved bound on its error; NaN and inf where
        ``why`` says that there is none. The state is coordinates, then rates, in the model's units,
        with ⟨q, q⟩ = ⟨p, q⟩ = 1.
    crossing, crossing_error : ndarray
        d Re λ / d parameter of the pair, and a bound on its error. Where it is positive, the state
        is unstable for larger values.
    when : ndarray of str
        The sign of ``crossing`` in words, where it is proved: this pair makes the state unstable as
        the parameter goes ``"up"`` or ``"down"``; else empty.
    unstable_before, unstable_after : ndarray of int
        How many λ have a positive real part at slightly smaller and at slightly larger values of
        the parameter: proved where the onset has a normal form or a closed form, else by floats in
        states beside it, as without damping; −1 where that is undecided.
    onset : ndarray of str
        ``"of instability"`` where one of these numbers is 0; ``"on an unstable state"`` where
        neither is: the state is unstable on both sides, and the cycle that is born is too, whatever
        ``criticality``; ``"undecided"``.
    why : tuple of str
        Why the criticality of an onset is undecided; empty where it is decided.
    """

    schema = (
        *(each for each in Points.schema if each.name not in ("ends", "when", *UNSTABLE)),
        Column("omega", "1/s", "frequency of the onset", row="behind"),
        Column("branch", "1", "number of the state from below in theta"),
        Column("count", "1", "number of states at this point"),
        Column("side", "1", "side on which flutter is"),
        Column("criticality", "1", "supercritical, subcritical or undecided", row="behind"),
        Column("when", "1", "direction of the parameter in which it sets in", row="behind"),
        Column("onset", "1", "of instability, or on an unstable state", row="behind"),
        Column("unstable_before", "1", "growing eigenvalues at smaller values", row="beside"),
        Column("unstable_after", "1", "growing eigenvalues at larger values", row="beside"),
        Column("lyapunov", "", "first Lyapunov coefficient", row="beside"),
        Column("lyapunov_error", "", "bound on its error", row="beside"),
        Column("crossing", "", "derivative of the growth by the parameter", row="beside"),
        Column("crossing_error", "", "bound on its error"),
        Column("why", "1", "why the criticality is undecided", row="beside"),
    )

    @property
    def _of_each(self) -> tuple[str, ...]:
        """Names of the columns that describe each onset."""
        more = ("omega", "branch", "count", "side")
        columns = (name for name in more if self._own(name) in self._values)
        return (*columns, "kind", "criticality", "onset")

    @cached_property
    def normal_forms(self) -> tuple[Any, ...]:
        """The :class:`~spragsym.bifurcation.normal_forms.NormalForm` of each onset, or the reason
        why it has none.
        """
        return tuple(self._normal_form(row) for row in range(len(self)))

    lyapunov = _column("lyapunov", np.nan)
    lyapunov_error = _column("lyapunov_error", np.inf)
    crossing = _column("crossing", np.nan)
    crossing_error = _column("crossing_error", np.inf)

    @cached_property
    def when(self) -> NDArray[np.str_]:
        """Direction of the parameter, ``"up"`` or ``"down"``, in which the state loses its
        stability to this pair; else empty.
        """
        decided = np.abs(self.crossing) > self.crossing_error
        return np.where(decided, np.where(self.crossing > 0, "up", "down"), "")

    @property
    def onset(self) -> NDArray[np.str_]:
        """Of instability, or on an unstable state; else undecided."""
        return onset_of(self.unstable_before, self.unstable_after)

    @cached_property
    def _unstable(self) -> IntArray:
        """Those of a closed form, or the others of the normal form and the pair where it grows; by
        floats where neither tells.
        """
        own = [self._own(name) for name in UNSTABLE]
        if own[0] in self._values:
            return np.array([self._values[name] for name in own])
        from .borders import counted_beside  # which loads what the search of onsets does not need

        found = unstable_beside(self.normal_forms)
        for row in np.flatnonzero((found[0] < 0) & (self.kind != "detected")).tolist():
            found[:, row] = counted_beside(self, row, damping=self.kind[row] == "hopf")
        return found

    @cached_property
    def criticality(self) -> NDArray[np.str_]:
        """supercritical, subcritical or undecided."""
        return np.array([criticality_of(form)[0] for form in self.normal_forms], dtype=str)

    @cached_property
    def why(self) -> tuple[str, ...]:
        """Why an onset is undecided."""
        return tuple(criticality_of(form)[1] for form in self.normal_forms)

    def _normal_form(self, row: int) -> NormalForm | str:
        if self.kind[row] == "detected":
            return "floats see it, and it is not proved: nothing bounds a coefficient there"
        if self.kind[row] != "hopf":
            return (
                "without damping eigenvalues come in pairs ± λ there, and several pairs leave the "
                "imaginary axis at once: no generic Hopf point; ask for the onsets of the "
                "damped model, damping=True, or give what oscillates a damper"
            )
        state = self.state(row)
        # The error is relative to max(1, |value|), and its product with that is rounded.
        radii = self.error[row] * scale_of([*state, self[self.vary[0]][row]]) * (1 + 2.0**-50)
        return form_or_why(self.balance(row), self.given(row), state, self.vary, radii)

    def balance(self, row: int, law: str = "friction_at_rest") -> Balance:
        """The balance of forces of the contacts that touch at one onset.

        Parameters
        ----------
        row : int
            Number of the onset, from 0.
        law : str
            The generated function that gives μ; ``"friction_at_speed"`` for μ(V).

        Returns
        -------
        Balance

        Examples
        --------
        >>> import spragsym as ss
        >>> onsets = ss.flutter_onsets(ss.load("stick_slip").Parameters(), vary="V")
        >>> onsets.balance(0).coordinates
        ['x']
        """
        model = self.parameters.model
        balances, own = balances_of(model, law=law), own_name(model, "touching")
        touching = str(self[own][row]) if own in self._values else ""
        return balances[number_of(balances, touching)]

    def given(self, row: int) -> FloatArray:
        """Parameters of one onset, in the order of the model.

        Parameters
        ----------
        row : int
            Number of the onset, from 0.

        Returns
        -------
        array
            Shape (parameters,).

        Examples
        --------
        >>> import spragsym as ss
        >>> onsets = ss.flutter_onsets(ss.load("stick_slip").Parameters(), "V")
        >>> onsets.given(0).round(6)  # mu_s, v_s, zeta and V
        array([0.5     , 0.1     , 0.05    , 0.101015])
        """
        return np.array([self[name][row] for name in self.parameters.model.parameters])

    def state(self, row: int) -> FloatArray:
        """Coordinates of one onset.

        Parameters
        ----------
        row : int
            Number of the onset, from 0.

        Returns
        -------
        array
            Shape (coordinates,), angles in radians.

        Examples
        --------
        >>> import spragsym as ss
        >>> onsets = ss.flutter_onsets(ss.load("stick_slip").Parameters(), "V")
        >>> onsets.state(0).round(6)
        array([0.499974])
        """
        return np.array([self[name][row] for name in self.parameters.model.coordinates])


def form_or_why(*point: Any) -> NormalForm | str:
    """The normal form of a point, with the arguments of :func:`.normal_forms.normal_form`, or the
    reason why it has none.
    """
    from .normal_forms import normal_form  # many who ask for onsets never ask for this

    try:
        return normal_form(*point)
    except UndecidedSign as reason:
        return str(reason)


def criticality_of(form: NormalForm | Coefficient | str) -> tuple[str, str]:
    """Criticality by the sign of l₁, and the reason if it is undecided, from a normal form or from
    the reason why there is none.
    """
    if isinstance(form, str):
        return "undecided", form
    if not abs(form.lyapunov) > form.lyapunov_error:
        return "undecided", "the first Lyapunov coefficient is not told from 0 by its bound"
    # A smaller change of the growth rate over ω comes from the tail of a smoothed law.
    meant = 1e-9
    if abs(form.lyapunov) * form.reach**2 < meant:
        return "undecided", (
            "the first Lyapunov coefficient is below the smoothing of the friction law: up to "
            "amplitudes at which sliding stops it "
            f"changes the growth rate by less than {meant:.0e} ω; what happens there decides"
        )
    return "supercritical" if form.lyapunov < 0 else "subcritical", ""
