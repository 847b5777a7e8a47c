"""Curves of flutter onsets in the plane of two parameters.

With damping they consist of Hopf points, each super- or subcritical, and end or change at points of
codimension two. Without damping, two modes meet on them.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..core.questions import Method, model_of, question
from ..core.remarks import Remark
from ..display import own_name
from ..models.model import Model
from ..models.parameters import ParameterSet, Ranges, as_count
from ..numerics import contractors
from ..numerics.interval_arrays import (
    BoolArray,
    ComplexArray,
    FloatArray,
    IntArray,
    Intervals,
)
from ..results import Curve, Points, Result
from ..results.points import UNSTABLE, joined_curves
from ..statics import stability
from ..statics.stability import slope_over
from .bifurcation_sets import FoldCurves, OnLines, any_pair, on_lines
from .borders import with_numbers
from .defining_systems import (
    FOLD,
    NO_SLOPE,
    Condition,
    Family,
    both,
    fold_of,
    no_damping,
    of_kind,
    within_block,
)
from .flutter import (
    OnsetSystems,
    Sought,
    criticality_of,
    every,
    form_or_why,
    frequencies,
    of_forms,
    onset_of,
    unstable_beside,
)
from .normal_forms import Coefficient, NormalForm, coefficients
from .options import ContinuationOptions
from .points import (
    OTHERS_IN_LIFT_OFF,
    Found,
    all_of,
    arranged,
    matrices,
    nothing,
    search,
    together,
    which,
)

#: Columns of generalized Hopf points, beside where they are.
_OF_CHANGES = ("error", *UNSTABLE)
#: Reason why a point has no normal form.
UNPROVED = "no generic Hopf point is proved there"


#: A normal form, or the reason why there is none, for each of some points.
Forms: TypeAlias = list[NormalForm | Coefficient | str]


@dataclass(frozen=True, eq=False)
class OnsetCurves(Result):
    """Onsets on lines of the plane, joined to curves, and points at which these end or change.

    Attributes
    ----------
    vary : tuple of str
        The two parameters.
    damping : bool
        True for Hopf points with all damping. False for (27), without damping: two modes meet on
        the curves, which have no ``lyapunov``.
    between : mapping
        Ranges of the two.
    curves : tuple of Curve
        Onsets in order along each curve. Each point is proved; that neighbours lie on one curve is
        not. Columns: the two parameters, the coordinates, ``omega``, ``lyapunov`` with its bound
        ``lyapunov_error``, NaN and inf where there is no coefficient, ``criticality``,
        ``unstable_before`` and ``unstable_after`` along the first parameter, and ``onset`` as in
        :class:`spragsym.results.Onsets`, and ``touching`` with several contacts.
    points : Points
        All points of the kinds ``"BT"`` (Bogdanov–Takens: a curve ends on a fold), ``"ZH"``
        (zero–Hopf: it meets a fold) and ``"HH"`` (double Hopf: two curves meet; only for two
        coordinates, and for parts of a model that do not act on each other), proved.
        ``unstable_before`` and ``unstable_after`` are the least and the largest number of λ that
        grow in states beside a point.
    changes : mapping
        Generalized Hopf points (GH), where l₁ changes its sign along a curve. Columns: the two
        parameters, the coordinates, ``error``, the distance of the two proved points with opposite
        signs between which it lies, and ``unstable_before`` and ``unstable_after`` of these.
    lines : mapping
        For each parameter, the values at which all onsets along the other parameter are searched;
        of closed forms, frictions alone.
    complete : bool
        Whether all onsets on all lines, and all points, are decided.
    undecided : ndarray
        Lower and upper ends of undecided boxes on lines, shape (boxes, unknowns, 2): coordinates,
        then parameters.
    remarks : tuple of str
        Why the result is not complete: what is known of undecided boxes, and what was not searched.
    """

    vary: tuple[str, ...]
    damping: bool
    between: Ranges
    curves: tuple[Curve, ...]
    points: Points
    changes: Mapping[str, FloatArray]
    lines: Mapping[str, FloatArray] = field(repr=False)
    complete: bool
    undecided: FloatArray
    remarks: tuple[str, ...]

    @property
    def _of_model(self) -> Model | None:
        return self.points.parameters.model

    def data(self) -> dict[str, NDArray[Any]]:
        """The points of all curves, one curve after the other, and of each the number of its
        ``curve``.

        Returns
        -------
        dict of str to array
            Columns of one length, angles in radians; empty without curves.

        Examples
        --------
        >>> import spragsym as ss
        >>> p = ss.load("stick_slip").Parameters()
        >>> found = ss.onset_curves(p, ("V", "zeta"), between={"V": (0, 1), "zeta": (0, 2)})
        >>> len(found.data()["V"]) == sum(map(len, found.curves))
        True
        """
        return joined_curves(self.curves)

    def _parts(self) -> dict[str, dict[str, NDArray[Any]]]:
        return {**super()._parts(), "changes": dict(self.changes)}

    def __len__(self) -> int:
        return len(self.curves)


@question
def onset_curves(
    p: ParameterSet,
    vary: Sequence[str] | None = None,
    n: int = 30,
    *,
    damping: bool | None = None,
    between: Ranges | None = None,
    options: ContinuationOptions | None = None,
    method: Method = "auto",
) -> OnsetCurves:
    """Curves of Hopf points in the plane of two parameters, each point super- or subcritical.

    Where several contacts can all open, remarks count those of states in which none touches.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; the values of those that vary are not used.
    vary : pair of str, optional
        Two parameters, by default ``theta0`` and ``mu0``.
    n : int
        Number of lines of either parameter, on which all Hopf points are found and proved.
    damping : bool, optional
        True for all damping, with that of the friction law; False for (27), without damping: curves
        on which two modes meet. By default True unless C is 0, for each combination of touching
        contacts.
    between : mapping, optional
        Ranges of the two, as ``{"mu0": (0, 1)}``.
    options : ContinuationOptions, optional
        Tolerances and limits of the curves, and of the search below them.
    method
        As for :func:`spragsym.folds`; a closed form is there for Hopf points over θ₀ and μ₀.

    Returns
    -------
    OnsetCurves
        ``curves``, each point with its ``criticality``; ``points``, all of the kinds BT, ZH and HH,
        proved; and ``changes``, where l₁ passes 0 along a curve (GH).

    Raises
    ------
    ParameterError
        For unknown parameters, or ranges that leave those allowed.

    Notes
    -----
    Source: F = 0 and Hurwitz's determinant along 2 n lines, as for
    :func:`spragsym.bifurcation.flutter.flutter_onsets`. Two points can be neighbours only if no
    line separates them. A closed curve between two lines is missed. The article's model:
    :mod:`spragsym.kang_nam.hopf_curves`. If the damping of the only
    damped coordinate vanishes, as by a falling friction law against a damper, every pair crosses,
    and each is a curve without l₁.

    Examples
    --------
    >>> import spragsym as ss
    >>> p = ss.load("stick_slip").Parameters()
    >>> found = ss.onset_curves(p, ("V", "zeta"), between={"V": (0.0, 1.0), "zeta": (0.0, 2.0)})
    >>> len(found), sorted(set(found.curves[0].criticality.tolist()))
    (1, ['subcritical', 'supercritical'])
    >>> found.changes["V"].round(4).tolist()  # where F‴ = 0, at (1 + √2) v_s
    [0.2414]
    """
    vary = model_of(p).two(vary)
    as_count("n", n, 2)
    options = options or ContinuationOptions()
    planes = Plane.every(p, vary, between, options=options.given_search)
    first, *others = (plane.curves(n, damping, options) for plane in planes)
    found = _joined(first, others) if others else first
    more = list[str]()
    for plane in planes[0].in_lift_off(between, None):
        apart = plane.curves(n, damping, options)
        if len(apart):
            more.append(
                f"onsets where no contact touches form curves, {len(apart)} in number, which are "
                "not listed; flutter_onsets names their points along one parameter"
            )
        if not apart.complete:
            more.append(OTHERS_IN_LIFT_OFF)
    return replace(found, remarks=(*found.remarks, *more))


def _joined(first: OnsetCurves, others: Sequence[OnsetCurves]) -> OnsetCurves:
    """The results of all combinations of touching contacts, as one."""
    parts = [first, *others]
    return replace(
        first,
        damping=any(part.damping for part in parts),
        curves=tuple(curve for part in parts for curve in part.curves),
        points=together([part.points for part in parts]),
        changes={
            name: np.concatenate([part.changes[name] for part in parts]) for name in first.changes
        },
        lines={name: values for part in parts for name, values in part.lines.items()},
        complete=all(part.complete for part in parts),
        undecided=np.concatenate([part.undecided for part in parts]),
        remarks=tuple(dict.fromkeys(remark for part in parts for remark in part.remarks)),
    )


_GROWING = (
    "without damping some λ grows at almost every state, since gyroscopic terms act beside "
    "friction or another force without a potential: flutter_onsets tells where none does; "
    "damping=True asks for the curves of the damped model"
)


@dataclass(frozen=True)
class Plane(Family):
    """The plane of two parameters; states there have the shape (n + 2, N): coordinates, then
    parameters.
    """

    def curves(self, n: int, damping: bool | None, options: ContinuationOptions) -> OnsetCurves:
        """Curves of Hopf points or, without damping, curves on which two modes meet."""
        systems = self.systems(damping)
        damping, said = systems.damping, tuple[str, ...]()
        points, ends = self.points(systems)
        whole, lines = True, dict[str, FloatArray]()
        undecided = np.empty((0, self.balance.n + 2, 2))
        curves, changes = list[Curve](), list[list[float]]()
        for sought, own_ends in zip(systems.sought, ends, strict=True):
            if sought.condition is NO_SLOPE:
                said, whole = (*said, *self.of_slope()), False
                continue
            if sought.leaves_pairs:
                said, whole = (*said, _GROWING), False
                continue
            found = self.traced(sought, n, own_ends, options)
            for chain in found.chains:
                for curve, of_curve in self.along(sought, found.curves, chain, own_ends):
                    curves.append(curve)
                    changes += of_curve
            undecided = np.concatenate([undecided, found.undecided])
            whole = whole and found.whole
            said = said + found.remarks
            lines = found.lines
        if damping and len(undecided):
            said += self.of_damping(undecided, options.undamped)
        if not points.complete:
            where = "of points: {}" if damping else "of states: {}"
            said += tuple(Remark(where, remark) for remark in points.remarks)
        own = (own_name(self.balance.model, name) for name in _OF_CHANGES)
        names = (*self.vary, *self.balance.coordinates, *own)
        rows = dict(zip(names, np.array(changes).reshape(-1, len(names)).T, strict=True))
        rows |= {name: rows[name].astype(int) for name in names[-len(UNSTABLE) :]}
        between = dict(zip(self.vary, map(tuple, self.spans.tolist()), strict=True))
        complete = (points.complete or not damping) and whole and not len(undecided)
        return OnsetCurves(
            self.vary,
            damping,
            between,
            tuple(curves),
            points,
            rows,
            lines,
            complete,
            undecided,
            said,
        )

    def systems(self, damping: bool | None) -> OnsetSystems:
        """The conditions of onsets in this plane."""
        return OnsetSystems.of(self, damping)

    def traced(
        self, sought: Sought, n: int, ends: FloatArray, options: ContinuationOptions
    ) -> OnLines:
        """All onsets of one kind on ``n`` lines of either parameter, joined to curves, which may
        end at ``ends``.
        """
        alike = self.alike if sought.has_simple_pair else any_pair
        return on_lines(self, sought.condition, n, ends, options=options, alike=alike)

    def along(
        self, sought: Sought, on: FoldCurves, chain: FloatArray, ends: FloatArray
    ) -> Iterator[tuple[Curve, list[list[float]]]]:
        """Curves of a chain of states, cut where the frequencies of a pair end, and for each the
        rows of :meth:`changes`.
        """
        at_end = _at_ends(on, chain, ends).tolist()
        linearizations = matrices(self, chain, damping=sought.kind == "hopf")
        modes = [_modes(sought, *state) for state in zip(at_end, *linearizations, strict=True)]
        for states, omega in _pieces(chain, modes):
            forms: Forms = [UNPROVED] * len(omega)
            if sought.has_simple_pair:
                forms = self.forms(on, states)
            curve = self.curve(states, omega, forms)
            beside = unstable_beside(forms)
            yield curve, self.changes(on, states, curve.criticality.tolist(), beside)

    def of_damping(self, undecided: FloatArray, share: float) -> tuple[str, ...]:
        """A remark if C is at most this share of K in the middle of some undecided boxes."""
        states = undecided.mean(axis=2).T
        (_, C, K), (_, G, _) = (matrices(self, states, damping) for damping in (True, False))
        largest_C, largest_K = (np.abs(matrix).max(axis=(1, 2)) for matrix in (C - G, K))
        count = np.count_nonzero(largest_C <= share * largest_K)
        if not count:
            return ()
        return (
            f"on lines: in {count} of {len(undecided)} undecided boxes C is at most "
            f"{share:g} times K: where it vanishes every pair crosses at once, and "
            "such onsets are not isolated",
        )

    def of_slope(self) -> tuple[str, ...]:
        """A remark if the slope of the friction law changes its sign, which is not searched
        here.
        """
        slope = slope_over(self.balance, self.over)
        low, high = float(slope.low[0]), float(slope.high[0])
        if not low < 0 < high:  # also where it is 0 at an end, as without friction
            return ()
        return (
            "where the slope of the friction law is 0 nothing damps and every pair crosses: "
            "flutter_onsets lists these onsets; the slope is between "
            f"{low:.3g} and {high:.3g} here",
        )

    def points(self, systems: OnsetSystems) -> tuple[Points, list[FloatArray]]:
        """All points at which curves end or change, and for each of the systems the points at which
        its curves end.
        """
        kinds, parts = list[str](), list[Found]()
        ends = [np.empty((self.balance.n + 2, 0))] * len(systems.sought)
        for kind, condition, row in _of_points(systems):
            found = search(self, condition)
            roots = self.roots(found.roots.middle)
            # A pair with the sum 0 may also be real. A double Hopf point needs two imaginary pairs.
            imaginary = (np.abs(roots.real) < 1e-5 * np.abs(roots.imag)).sum(axis=1)
            kept = (imaginary >= (4 if kind == "HH" else 2)) | (kind == "BT")
            parts.append(replace(found, roots=found.roots.select(kept)))
            kinds += [kind] * int(kept.sum())
            if kind == "BT":
                middle = parts[-1].roots.middle
                ends[row] = np.concatenate([ends[row], middle], axis=1)
        found = all_of(parts or [nothing(self)])
        points = arranged(self, found, np.array(kinds, dtype=str))
        return replace(points, _ended=with_numbers), ends

    def roots(self, states: FloatArray) -> ComplexArray:
        """All λ, shape (N, 2 n)."""
        return stability.roots(*matrices(self, states))

    def alike(self, one: FloatArray, two: FloatArray) -> BoolArray:
        """Mask of pairs of Hopf points whose imaginary λ are the nearest to each other of all. Near
        double Hopf points two curves are close together, but in their frequencies.
        """
        first, second = self.roots(one), self.roots(two)
        return _nearest_is_imaginary(first, second) & _nearest_is_imaginary(second, first)

    def forms(self, curves: FoldCurves, states: FloatArray) -> Forms:
        """For each point its normal form or coefficient, over a box that is proved to hold it, or
        the reason why there is none.

        Intervals are tried first, ball arithmetic where they do not decide.
        """
        ends, good = curves.enclosed(states, np.abs(curves.tangents(states)).argmax(axis=0))
        middle, n = Intervals(ends).middle, self.balance.n
        radii, given = contractors.distance(ends, middle), self.at(middle[n:])
        out: Forms = [UNPROVED] * good.size
        rows = np.flatnonzero(good)
        by_intervals = coefficients(self.balance, given[:, rows], ends[:, :, rows], self.vary)
        for k, form in zip(rows.tolist(), by_intervals, strict=True):
            out[k] = form or form_or_why(
                self.balance, given[:, k], middle[:n, k], self.vary, radii[:, k]
            )
        return out

    def curve(self, states: FloatArray, omega: FloatArray, forms: Forms) -> Curve:
        """The states as a curve, with frequencies and criticality as columns."""
        before, after = unstable_beside(forms)
        ours = {
            "omega": omega,
            "lyapunov": of_forms(forms, "lyapunov", np.nan),
            "lyapunov_error": of_forms(forms, "lyapunov_error", np.inf),
            "criticality": np.array([criticality_of(form)[0] for form in forms], dtype=str),
            **dict(zip(UNSTABLE, (before, after), strict=True)),
            "onset": onset_of(before, after),
        }
        own = {own_name(self.balance.model, name): column for name, column in ours.items()}
        return Curve({**self.named(states), **own, **which(self.balance, omega.size)})

    def changes(
        self, curves: FoldCurves, states: FloatArray, kinds: Sequence[str], beside: IntArray
    ) -> list[list[float]]:
        """Points between neighbours with opposite signs of l₁, by bisection; a row of numbers for
        each. ``beside`` are the numbers of λ that grow on both sides of each state.
        """
        decided = [k for k, kind in enumerate(kinds) if kind != "undecided"]
        # l₁ also changes its sign at a pole, a zero–Hopf point, where det K does too.
        side = np.prod(self.roots(states), axis=1).real > 0
        pairs = [
            (one, two)
            for one, two in itertools.pairwise(decided)
            if kinds[one] != kinds[two] and side[one] == side[two]
        ]
        if not pairs:
            return []
        first, last = np.array(pairs).T
        one, two = states[:, first], states[:, last]
        numbers = np.where((beside[:, first] == beside[:, last]).all(axis=0), beside[:, first], -1)
        self._halve(curves, one, two, np.array(kinds)[first])
        middle, n = 0.5 * (one + two), self.balance.n
        return np.concatenate(
            [middle[n:], middle[:n], np.abs(two - one).max(axis=0)[None], numbers]
        ).T.tolist()

    def _halve(
        self, curves: FoldCurves, one: FloatArray, two: FloatArray, kinds: NDArray[np.str_]
    ) -> None:
        """Move the points of pairs towards each other in place, as long as the criticality half-way
        is decided.

        ``kinds`` are the criticalities of ``one``.
        """
        rows = np.arange(kinds.size)
        for _ in range(30):  # halvings
            chord = (two - one)[:, rows] / curves.scale[:, None]
            length = np.linalg.norm(chord, axis=0)
            found, good = curves.on_curve(0.5 * (one + two)[:, rows], chord / length, length)
            found, rows = found[:, good], rows[good]
            between = np.array([criticality_of(form)[0] for form in self.forms(curves, found)])
            decided = between != "undecided"
            found, rows, between = found[:, decided], rows[decided], between[decided]
            if not rows.size:
                break
            same = between == kinds[rows]
            one[:, rows[same]], two[:, rows[~same]] = found[:, same], found[:, ~same]


def _nearest_is_imaginary(roots: ComplexArray, others: ComplexArray) -> BoolArray:
    """For each row whether the nearest of ``others`` to the imaginary one of the roots is
    imaginary.
    """
    ours, theirs = (
        each[
            np.arange(len(each)), np.where(each.imag < 0, np.inf, np.abs(each.real)).argmin(axis=1)
        ]
        for each in (roots, others)
    )
    nearest: FloatArray = np.abs(others - ours[:, None]).min(axis=1)
    return nearest == np.abs(theirs - ours)


def _of_points(systems: OnsetSystems) -> Iterator[tuple[str, Condition, int]]:
    """Kinds of points, their conditions, and the index of the system whose curves they lie on.

    With several blocks of coordinates, the pair and the root 0 of a zero–Hopf point, or the two
    pairs of a double Hopf point, may belong to two blocks.
    """
    only, blocks = systems.only, systems.blocks
    crossed = [
        (row, one)
        for row, one in enumerate(systems.sought)
        if one.kind == "hopf" and one.condition is not NO_SLOPE
    ]
    for row, one in crossed:
        if only is not None and one.frequencies is every:
            yield "BT", both(FOLD, no_damping(only)), row
            continue
        block = one.block or blocks[0]
        along = None if only is None else block.index(only)
        kinds = ["BT", *(["ZH"] if len(block) > 1 else [])]
        # With one damped coordinate the coefficient of λ³ is its damping times a mass, never 0.
        kinds += ["HH"] if len(block) == 2 and only is None else []
        for kind in kinds:
            yield kind, within_block(of_kind(kind, along), one.block), row
        for other in blocks:
            if other != block:
                yield "ZH", both(one.condition, fold_of(other)), row
        for later, another in crossed:
            if later > row and only is None:
                yield "HH", both(one.condition, another.condition), row


def _modes(sought: Sought, end: bool, *state: FloatArray) -> list[float]:
    """Frequencies ω of a state.

    At a Bogdanov–Takens point (``end``), where two λ are 0 but for rounding, the first is 0.
    """
    if not end:
        return sought.omega(*state)
    if sought.frequencies is not every:
        return [0.0]
    roots = stability.roots(*state)
    return [0.0, *frequencies(roots[np.argsort(np.abs(roots))[2:]])]


def _pieces(
    chain: FloatArray, modes: Sequence[Sequence[float]]
) -> Iterator[tuple[FloatArray, FloatArray]]:
    """Pieces of a chain with an equal number of frequencies: each piece once for each frequency,
    with its values.
    """
    cuts = np.flatnonzero(np.diff([len(each) for each in modes])) + 1
    for part in np.split(np.arange(len(modes)), cuts):
        for mode in range(len(modes[part[0]]) if len(part) else 0):
            yield chain[:, part], np.array([modes[row][mode] for row in part])


def _at_ends(curves: FoldCurves, states: FloatArray, ends: FloatArray) -> BoolArray:
    """Mask of the states of a chain that are among the Bogdanov–Takens points ``ends``."""
    off = np.abs(states[:, :, None] - ends[:, None]) / curves.scale[:, None, None]
    return (off.max(axis=0) < 1e-9).any(axis=1)
