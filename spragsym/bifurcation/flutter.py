"""Onsets of flutter of a model along one parameter, proved: with dampers and the slope of the
friction law, or without.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from itertools import chain, pairwise
from typing import TYPE_CHECKING, Any, Self, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..core.questions import Method, question
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
from ..numerics.vectors import magnitude
from ..results import Points
from ..statics import stability
from ..statics.balance import NEGLIGIBLE, Balance
from ..statics.forces import Evaluation
from ..statics.options import SearchOptions
from ..statics.precise_balance import clusters, on_contact_side, refined
from ..statics.search import balances_of, float_candidates, number_of
from ..statics.stability import (
    comes_in_pairs,
    damped_by_friction_alone,
    damped_entries,
    is_conservative,
    is_damped,
    slope_over,
)
from .borders import joined as together
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
    undamped_mode,
    within_block,
)
from .points import Found, all_of, arranged, matrices, merged, nothing, of_ends, search

if TYPE_CHECKING:
    from .normal_forms import Coefficient, NormalForm

#: Why none is searched for without damping.
NEVER_STABLE = (
    "without damping no state is stable where gyroscopic terms act beside friction, or another "
    "force without a potential, so that no flutter sets in; ask for the onsets of the damped "
    "model, damping=True"
)
#: ω of the points of a search that M, C and K are taken at.
Frequencies: TypeAlias = Callable[[FloatArray, FloatArray, FloatArray], list[float]]
#: Points of one search, their kinds and their ω.
_Part: TypeAlias = tuple[Found, list[str], list[float]]


@question
def flutter_onsets(
    p: ParameterSet,
    vary: str | None = None,
    *,
    damping: bool | None = None,
    between: Ranges | None = None,
    within: Ranges | None = None,
    options: SearchOptions | None = None,
    method: Method = "auto",
) -> Onsets:
    """Onsets of flutter in contact along one parameter, the others fixed; ``complete`` says whether
    these are all.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; the one that varies is not used.
    vary : str, optional
        A parameter; without it ``theta0``, or the model's first one.
    damping : bool, optional
        True for Hopf points of the full linearization, det(λ² M + λ (C + G) + K) = 0 with dampers
        and slope of the friction law; False for (27), without C, as the article's flutter. Without
        it True, unless C is 0, of several contacts for each combination of those that touch.
    between, within, options, method
        As for :func:`spragsym.folds`; a closed form is there for (27) along θ₀.

    Returns
    -------
    Onsets
        Of the kind ``"hopf"``, where a pair ± i ω crosses the imaginary axis, or ``"flutter"``,
        where two frequencies meet; or ``"detected"``: floats see a pair cross there, where the
        search was not complete, and no proof succeeds; ``omega`` is the frequency, ``criticality``
        whether it is super- or subcritical. Where all damping changes its sign at once, by a
        falling friction law against a damper, every pair of a state crosses, and each has a row.
        Closed forms add ``branch``, which counts the equilibria from below in θ, from 0, ``count``,
        how many there are, and ``side``: 1 where the state flutters at slightly larger θ₀, −1 where
        it does at slightly smaller θ₀, 0 where the boundary is only touched.

    Raises
    ------
    ParameterError
        For a parameter that is missing or an array.
    ConvergenceError
        At parameters of the article's model so degenerate that onsets can't be told apart.

    Notes
    -----
    Source: F = 0 and Hurwitz's determinant of order 2 n − 1, or the discriminant of det(K − κ M) in
    κ. Where one coordinate only is damped, that entry of C is a factor of Hurwitz's determinant and
    taken out: what is left, and the entry, or the slope of the friction law where it is that, are
    searched for on their own. An end of the range at which C vanishes is no onset. Points where a
    real pair ± λ has the sum 0, or two real λ meet, are roots as well and left out.

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
    name = p.model.one(vary)
    families = Family.every(p, (name,), between, within, options)
    return Onsets(**vars(together([_in_combination(family, damping) for family in families])))


@dataclass(frozen=True)
class Sought:
    """Onsets of one kind in a block of coordinates, of all for None: what holds there, and ω of
    what oscillates, from M, C + G and K of the block.
    """

    condition: Condition
    frequencies: Frequencies
    kind: str
    block: Block

    def omega(self, *linearization: FloatArray) -> list[float]:
        """Frequencies at a state, by M, C + G and K of all coordinates."""
        if self.block is None:
            return self.frequencies(*linearization)
        part = np.ix_(self.block, self.block)
        return self.frequencies(*(one[part] for one in linearization))


@dataclass(frozen=True)
class OnsetSystems:
    """What is searched for onsets of a family: with damping or without, the only coordinate that is
    damped, if there is but one, and the blocks of coordinates.
    """

    damping: bool
    only: int | None
    blocks: list[tuple[int, ...]]
    sought: list[Sought]
    said: tuple[str, ...] = ()

    @classmethod
    def of(cls, family: Family, damping: bool | None) -> Self:
        """Of one combination of contacts that touch; with damping unless there is none, if it is
        not said.
        """
        balance, over = family.balance, family.over
        # With G the pair that crosses is none of a mode that nothing damps.
        along = None if balance.gyroscopic else damped_by_friction_alone(balance, over)
        slope = None if along is None else slope_over(balance, over)
        entries, only = damped_entries(balance, over), along
        if along is None and not balance.gyroscopic and len(entries) == 1:
            row, column = entries[0]
            only = row if row == column else None
        if damping is None:
            damping = (
                is_damped(balance, over)
                if slope is None
                else bool(slope.magnitude.max() > NEGLIGIBLE)
            )
        in_pairs = comes_in_pairs(balance, over)
        if not damping and not in_pairs:
            return cls(damping, only, [], [], (NEVER_STABLE,))
        blocks = blocks_of(family, Evaluation.by_rates if damping else Evaluation.gyroscopic)
        damped = frozenset[int]()
        if damping:  # dampers as good as 0 do not count beside what damps one coordinate alone
            damped = frozenset(row for row, _ in entries) if only is None else frozenset({only})
        conservative = is_conservative(balance, over)
        sought = list[Sought]()
        for block in blocks:
            own = None if len(blocks) == 1 else block
            if in_pairs and not damped & {*block}:
                # Where K is symmetric all κ are real and stay so as K changes: where two meet they
                # pass each other.
                if not conservative and len(block) > 1:
                    sought.append(Sought(within_block(FLUTTER, own), meeting, "flutter", own))
            elif only is None or balance.n == 1:
                sought.append(Sought(within_block(HOPF, own), crossing, "hopf", own))
            else:
                # Where K is symmetric damping takes energy from all modes, or gives to all: no pair
                # crosses.
                if not conservative and len(block) > 1:
                    along = block.index(only)
                    mode = within_block(undamped_mode(along), own)
                    sought.append(Sought(mode, partial(_without, along), "hopf", own))
                if slope is None:
                    sought.append(Sought(no_damping(only), every, "hopf", own))
                elif conservative or slope.holds_zero().any():
                    sought.append(Sought(NO_SLOPE, every, "hopf", own))
        # What has no slope comes last, as its undecided boxes have remarks of their own.
        sought.sort(key=lambda one: one.condition is NO_SLOPE)
        return cls(damping, only, blocks, sought)


def _in_combination(family: Family, damping: bool | None) -> Points:
    """Onsets of one combination of contacts that touch."""
    systems = OnsetSystems.of(family, damping)
    if systems.said:
        unknown = replace(nothing(family), whole=np.zeros(1, dtype=bool))
        return _joined(family, [(unknown, [], [])], flat=False, said=systems.said)
    parts = list[_Part]()
    for one in systems.sought:
        out = search(family, one.condition)
        if out.roots.undecided.shape[2]:
            out, more, omega = with_seen(Augmented(family, one.condition), out)
            alone = replace(out, roots=more)
            followed = (alone, ["detected"] * omega.size, omega.tolist())
            parts.append(
                followed
                if one.condition.pairs
                else _part(family, alone, replace(one, kind="detected"), systems.damping)
            )
        parts.append(_part(family, out, one, systems.damping))
    parts = parts or [(nothing(family), [], [])]
    flat = bool(systems.sought) and systems.sought[-1].condition is NO_SLOPE
    return _joined(family, parts, flat=flat)


# ------------------------------------------------------------------------------------------------
# frequencies


def _part(family: Family, found: Found, sought: Sought, damping: bool) -> _Part:
    """A row for each frequency that a root has; none for roots whose λ are real."""
    rows, omega = list[int](), list[float]()
    every = matrices(family, found.roots.middle, damping)
    for row, each in enumerate(zip(*every, strict=True)):
        some = sought.omega(*each)
        omega += some
        rows += [row] * len(some)
    return (
        replace(found, roots=found.roots.select(np.array(rows, dtype=int))),
        [sought.kind] * len(rows),
        omega,
    )


def crossing(M: FloatArray, C: FloatArray, K: FloatArray) -> list[float]:
    """ω of the two roots λ of det(λ² M + λ (C + G) + K) whose sum is the nearest to 0, unless they
    are real.
    """
    roots = stability.roots(M, C, K)
    one = _nearest(roots, -roots)
    return [float(abs(one.imag))] if abs(one.imag) > abs(one.real) else []


def _nearest(numbers: ComplexArray, others: ComplexArray) -> NDArray[Any]:
    """The number that is the nearest to what stands in ``others`` in another place."""
    apart = np.abs(numbers[:, None] - others)
    np.fill_diagonal(apart, np.inf)
    return numbers[apart.min(axis=1).argmin()]


def _omega(square: NDArray[Any]) -> list[float]:
    """ω of a root κ, unless it is negative."""
    return [float(np.sqrt(square.real))] if square.real > 0 else []


def meeting(M: FloatArray, G: FloatArray, K: FloatArray) -> list[float]:
    """ω of the two roots κ = −λ² of det(λ² M + λ G + K) that are the nearest to each other, unless
    they are negative.
    """
    if G.any():
        roots = stability.roots(M, G, K)
        squares = -(roots[roots.imag > 0] ** 2)
        return [] if squares.size < 2 else _omega(_nearest(squares, squares))
    squares = stability.squares(M, K)
    return _omega(_nearest(squares, squares))


def _without(along: int, M: FloatArray, C: FloatArray, K: FloatArray) -> list[float]:
    """ω of a mode in which the coordinate ``along`` does not move: the root of its minor that is
    the nearest to one of all.
    """
    others = [i for i in range(len(K)) if i != along]
    squares = stability.squares(M[np.ix_(others, others)], K[np.ix_(others, others)])
    return _omega(
        squares[np.abs(squares[:, None] - stability.squares(M, K)[None]).min(axis=1).argmin()]
    )


def every(M: FloatArray, C: FloatArray, K: FloatArray) -> list[float]:
    """ω of all pairs of a state that nothing damps."""
    return frequencies(stability.roots(M, C, K))


def frequencies(roots: ComplexArray) -> list[float]:
    """ω of the pairs ± i ω among roots, ascending."""
    return sorted(
        abs(root.imag) for root in roots[roots.imag > 0] if abs(root.real) < 1e-5 * root.imag
    )


def _joined(family: Family, parts: list[_Part], flat: bool, said: tuple[str, ...] = ()) -> Points:
    """All parts in one result; ``flat`` where the last is of places without slope."""
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
    """Remarks on undecided boxes where the friction law has practically no slope."""
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
    """Onsets of a search, with those that floats see and that are proved; those that are not; and
    their frequencies.
    """
    from scipy.optimize import linear_sum_assignment  # heavy, and a refusal does not need it

    seen = np.array(_sightings(system, found.roots.undecided))
    fixed, sightings = system.family.begin, seen.reshape(-1, system.n + 1).T
    candidates = sightings[:-1]
    room = 1e-6 * scale_of(candidates)
    tried = refined(system, fixed, Roots.at(ends_around(candidates, room)))
    sure = tried.error <= system.options.tolerance
    proved, open_ = (
        on_contact_side(system, fixed, Roots.at(tried.ends[:, :, some])) for some in (sure, ~sure)
    )
    apart = np.abs(candidates[:, ~sure, None] - open_.middle[:, None]).max(axis=0)
    # Of several pairs that cross at one place each has its own frequency.
    omega = sightings[-1, ~sure][linear_sum_assignment(apart.T)[1]]
    return (
        replace(found, roots=distinct(found.roots.concatenated(proved.select(undecided=slice(0))))),
        open_,
        omega,
    )


def _sightings(system: Augmented, left: FloatArray) -> list[FloatArray]:
    """Onsets that floats see between values of the parameter, ends of its range and of undecided
    boxes among them: coordinates, parameter and ω, NaN where none was followed.
    """
    low, high = system.family.spans[0]
    samples = system.options.samples
    even = low + (high - low) * (np.arange(samples) + 0.5) / samples
    beside = spans_of(merged(left))[-1].ravel()
    some = np.linspace(0, beside.size - 1, min(beside.size, samples)).astype(int)
    values = np.unique([low, *even, *np.sort(beside)[some], high])
    q, point = _states(
        float_candidates(system.balance, system.family.at(values[None]), system.family.asked)
    )
    z = np.concatenate([q, values[point][None]])
    every, out = _signals(system, z), list[FloatArray]()
    for one in range(point.size):
        following = np.flatnonzero(point == point[one] + 1)
        if not following.size:
            continue
        other = int(following[np.abs(q[:, following] - q[:, [one]]).max(axis=0).argmin()])
        if _crossing_pairs(every[one], every[other]).size:
            out += _bisected(system, (z[:, one], every[one]), (z[:, other], every[other]), 40)
    if system.condition.pairs:
        return out
    # Not where the condition changes its sign at a pole.
    most = 1e-6 * max((magnitude(row) for row in every if row.size), default=0.0)
    return [one for one in out if (np.abs(_signals(system, one[:-1, None])[0]) <= most).any()]


def _states(found: Roots) -> tuple[FloatArray, IntArray]:
    """Roots, and the middles of boxes so small that rounding alone leaves them open, each once; and
    their points.
    """
    ends, point = found.every
    boxes = Intervals(ends)
    # Width of a box whose middle is as good as a root.
    small = np.asarray((boxes.width <= 1e-6 * scale_of(boxes.middle)).all(axis=0))
    small[: found.point.size] = True
    hulls, point = clusters(ends[:, :, small], point[small])
    return Intervals(hulls).middle, point


def _crossing_pairs(a: ComplexArray, b: ComplexArray) -> ComplexArray:
    """Eigenvalues above the real axis whose real part changes sign to the next state; each is
    followed.
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
    """The onsets between two states with their λ, of which some cross: those are followed anew to
    the middle and from there.
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
        # Where more than one onset lies between, the halvings are shared.
        share = (halvings - 1) // len(halves)
        return [
            sighting for one, other in halves for sighting in _bisected(system, one, other, share)
        ]
    # Else the ends do not lie on one branch.
    crossing = _crossing_pairs(low[1], high[1])
    if not system.condition.pairs:
        return [np.append(state, np.nan) for _ in crossing]
    # Growth over the size of a λ on the imaginary axis.
    neutral = 1e-6
    nearest = [roots[np.abs(roots - here).argmin()] for here in crossing if roots.size]
    return [
        np.append(state, abs(here.imag))
        for here in nearest
        if abs(here.real) <= neutral * abs(here)
    ]


def _state(system: Augmented, z: FloatArray) -> FloatArray:
    """The state of the value z[−1] that Newton's method finds near by."""
    parameters = Intervals.point(system.family.at(z[-1:, None]))
    with quiet():
        q = system.balance.guessed(z[:-1, None], system.balance.prepared(parameters))
    return np.append(q[:, 0], z[-1])


def _signals(system: Augmented, z: FloatArray) -> list[ComplexArray]:
    """Numbers whose real part changes its sign at an onset, of each state z, shape (n + 1, N).

    The λ above the real axis; where friction alone damps, or nothing, the condition's own value,
    0 where its sign is open beside a state that is known but for rounding.
    """
    if system.condition.pairs:
        block = system.condition.block or range(system.balance.n)
        part = np.ix_(range(z.shape[1]), block, block)
        every = stability.roots(*(each[part] for each in matrices(system.family, z)))
        return [row[np.isfinite(row) & (row.imag > 1e-6 * np.abs(row))] for row in every]
    # Error of a state that Newton's method has found, over its size.
    error = 2.0**-50
    states = Intervals(ends_around(z, error * scale_of(z)))
    with quiet():
        tested = system.residuals(states, system.fixed(z.shape[1]))[-1]
    finite = np.isfinite(tested.middle)
    values = np.where(finite & tested.holds_zero(), 0.0, tested.middle).astype(complex)
    return [values[[k]] if finite[k] else values[:0] for k in range(values.size)]


def of_forms(forms: Sequence[Any], name: str, missing: float) -> FloatArray:
    """A column of normal forms, of points that have one."""
    return np.array([missing if isinstance(form, str) else getattr(form, name) for form in forms])


def _column(name: str, missing: float) -> cached_property[FloatArray]:
    return cached_property(lambda found: of_forms(found.normal_forms, name, missing))


@dataclass(frozen=True, eq=False)
class Onsets(Points):
    """Onsets of flutter along one parameter, of the kind ``"hopf"`` or ``"flutter"``, with their
    normal forms.

    What follows is computed when it is first asked for; with all that :class:`Points` has,
    ``omega`` the frequency.

    Attributes
    ----------
    criticality : ndarray of str
        ``"supercritical"`` where l₁ < 0 is proved (the cycle that is born attracts within the plane
        of the pair, and grows from nothing), ``"subcritical"`` where l₁ > 0 is (an unstable cycle
        shrinks onto the state, and beyond the onset motions go far), else ``"undecided"``, also
        where l₁ comes from the tail of a law smoothed at rest alone.
    lyapunov, lyapunov_error : ndarray
        The first Lyapunov coefficient l₁ and a bound on its error that is proved; NaN and inf where
        ``why`` says that there is none. The state is coordinates, then rates, in the model's units,
        and ⟨q, q⟩ = ⟨p, q⟩ = 1.
    crossing, crossing_error : ndarray
        d Re λ / d parameter of the pair: where it is positive, the state is unstable for larger
        values.
    when : ndarray of str
        What the sign of that says, where its bound leaves it: as the parameter goes ``"up"`` or
        ``"down"``, this pair makes the state unstable; else empty.
    why : tuple of str
        Why an onset is undecided; empty for the others.
    """

    schema = (
        *(each for each in Points.schema if each.name not in ("ends", "when")),
        Column("omega", "1/s", "frequency of the onset", row="behind"),
        Column("branch", "1", "number of the state from below in theta"),
        Column("count", "1", "number of states at this point"),
        Column("side", "1", "side on which flutter is"),
        Column("criticality", "1", "supercritical, subcritical or undecided", row="behind"),
        Column("when", "1", "direction of the parameter in which it sets in", row="behind"),
        Column("lyapunov", "", "first Lyapunov coefficient", row="beside"),
        Column("lyapunov_error", "", "bound on its error", row="beside"),
        Column("crossing", "", "derivative of the growth by the parameter", row="beside"),
        Column("crossing_error", "", "bound on its error"),
        Column("why", "1", "why the criticality is undecided", row="beside"),
    )

    @property
    def _of_each(self) -> tuple[str, ...]:
        """The frequency, what closed forms know, and the criticality of each."""
        more = ("omega", "branch", "count", "side")
        columns = (name for name in more if self._own(name) in self._values)
        return (*columns, "kind", "criticality")

    @cached_property
    def normal_forms(self) -> tuple[Any, ...]:
        """The :class:`~spragsym.bifurcation.normal_forms.NormalForm` of each, or why it has
        none.
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

    @cached_property
    def criticality(self) -> NDArray[np.str_]:
        """supercritical, subcritical or undecided."""
        return np.array([criticality_of(form)[0] for form in self.normal_forms], dtype=str)

    @cached_property
    def why(self) -> tuple[str, ...]:
        """Why an onset is undecided."""
        return tuple(criticality_of(form)[1] for form in self.normal_forms)

    def _normal_form(self, row: int) -> NormalForm | str:
        if self.kind[row] != "hopf":
            return (
                "without damping two frequencies meet there, and all eigenvalues stay on the "
                "imaginary axis up to it: no generic Hopf point; ask for the onsets of the "
                "damped model, damping=True, or give what oscillates a damper"
            )
        state = self.state(row)
        # The error is relative to max(1, |value|), and its product with that is rounded.
        radii = self.error[row] * scale_of([*state, self[self.vary[0]][row]]) * (1 + 2.0**-50)
        return form_or_why(self.balance(row), self.given(row), state, self.vary, radii)

    def balance(self, row: int, law: str = "friction_at_rest") -> Balance:
        """The balance of forces of the contacts that touch at one of them.

        Parameters
        ----------
        row : int
            Number of the onset, from 0.
        law : str
            The friction, of rest or at the speed of the belt, by its generated function.

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
        """Parameters of one of them, in the order of the model.

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
        """Coordinates of one of them.

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
    """The normal form of a point, arguments as of :func:`.normal_forms.normal_form`, or why it has
    none.
    """
    from .normal_forms import normal_form  # many who ask for onsets never ask for this

    try:
        return normal_form(*point)
    except UndecidedSign as reason:
        return str(reason)


def criticality_of(form: NormalForm | Coefficient | str) -> tuple[str, str]:
    """Criticality by the sign of the coefficient, and why it is undecided; of a normal form, or of
    why there is none.
    """
    if isinstance(form, str):
        return "undecided", form
    if not abs(form.lyapunov) > form.lyapunov_error:
        return "undecided", "the first Lyapunov coefficient is not told from 0 by its bound"
    # Change of the growth rate over ω below which a coefficient is the tail of a smoothed
    # law.
    meant = 1e-9
    if abs(form.lyapunov) * form.reach**2 < meant:
        return "undecided", (
            "the first Lyapunov coefficient is below the smoothing of the friction law: up to "
            "amplitudes at which sliding stops it "
            f"changes the growth rate by less than {meant:.0e} ω; what happens there decides"
        )
    return "supercritical" if form.lyapunov < 0 else "subcritical", ""
