"""Curves of onsets of flutter in the plane of two parameters: Hopf points and where their kind
changes, or modes that meet.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from ..core.error_states import in_usual_state
from ..core.questions import model_of
from ..core.remarks import Remark
from ..display import own_name
from ..models.model import Model
from ..models.parameters import ParameterSet, Ranges, as_count
from ..numerics import contractors
from ..numerics.interval_arrays import BoolArray, ComplexArray, FloatArray, Intervals
from ..results import Curve, Points, Result
from ..statics import stability
from ..statics.stability import slope_over
from .bifurcation_sets import FoldCurves, on_lines
from .borders import joined
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
)
from .normal_forms import Coefficient, NormalForm, coefficients
from .options import ContinuationOptions
from .points import Found, all_of, arranged, matrices, nothing, search, which

#: Why a point has no normal form that is not proved to be a generic Hopf point.
UNPROVED = "no generic Hopf point is proved there"


@dataclass(frozen=True, eq=False)
class OnsetCurves(Result):
    """Onsets on lines of the plane, joined to curves, and points at which these end or change.

    Attributes
    ----------
    vary : tuple of str
        The two parameters.
    damping : bool
        Whether with all damping, or by (27), without: then curves are where two modes meet, and
        have no ``lyapunov``.
    between : mapping
        Ranges of the two.
    curves : tuple of Curve
        Hopf points in the order in which they follow each other. Each is proved; that they are
        joined in the right order is not. Their columns: the parameters that vary, the coordinates,
        ``omega``, ``lyapunov`` with its bound ``lyapunov_error``, NaN and inf where there is no
        coefficient, and ``criticality``, as of :class:`spragsym.results.Onsets`; of several
        contacts ``touching``.
    points : Points
        All points of the kinds ``"BT"`` (Bogdanov–Takens: a curve ends on a fold), ``"ZH"``
        (zero–Hopf: it meets a fold) and ``"HH"`` (double Hopf: two curves meet; sought with two
        coordinates, and of parts of a model that do not act on each other), proved.
    changes : mapping
        Generalized Hopf points (GH), where l₁ changes its sign along a curve: columns of the two
        parameters, of the coordinates, and ``error``, the distance of the two proved points with
        opposite signs between which it lies.
    lines : mapping
        For each parameter the values at which all Hopf points along the other one are known.
    complete : bool
        Whether all onsets on all lines, and all points, are decided.
    undecided : ndarray
        Lower and upper ends of the boxes on lines that are not, shape (boxes, unknowns, 2):
        coordinates, then parameters.
    remarks : tuple of str
        Why the result is not complete: what is known of these boxes, and what was not searched.
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

    def __len__(self) -> int:
        return len(self.curves)


@in_usual_state
def onset_curves(
    p: ParameterSet,
    vary: Sequence[str] | None = None,
    n: int = 30,
    *,
    damping: bool | None = None,
    between: Ranges | None = None,
    options: ContinuationOptions | None = None,
) -> OnsetCurves:
    """Curves of Hopf points in the plane of two parameters, each point supercritical or
    subcritical.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; those that vary are not used.
    vary : pair of str, optional
        Two parameters; without it ``theta0`` and ``mu0``.
    n : int
        Lines of either parameter on which all Hopf points are found and proved.
    damping : bool, optional
        With all damping, that of the friction law included; or by (27), without: curves on which
        two modes meet. Without it True, unless C is 0, of several contacts for each combination of
        those that touch.
    between : mapping, optional
        Ranges of the two, as ``{"mu0": (0, 1)}``.
    options : ContinuationOptions, optional
        Tolerances and limits of the curves, and of the search below them.

    Returns
    -------
    OnsetCurves
        ``curves``, each point with ``criticality``; ``points``, all those of the kinds BT, ZH and
        HH, proved; and ``changes``, where l₁ passes 0 along a curve (GH).

    Raises
    ------
    ParameterError
        For parameters that the model has not, or ranges that leave theirs.

    Notes
    -----
    Source: F = 0 and Hurwitz's determinant along 2 n lines, as for
    :func:`spragsym.bifurcation.flutter.flutter_onsets`; two points are neighbours only if no line
    separates them. A curve that closes between two lines is not seen. Where the only coordinate
    that is damped has no damping, by a falling friction law against a damper, every pair crosses,
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
    model = model_of(p)
    model.require_answered("onset_curves")
    vary = model.two(vary)
    as_count("n", n, 2)
    options = options or ContinuationOptions()
    planes = _Plane.every(p, vary, between, options=options.asked)
    first, *others = (plane.curves(n, damping, options) for plane in planes)
    return _joined(first, others) if others else first


def _joined(first: OnsetCurves, others: Sequence[OnsetCurves]) -> OnsetCurves:
    """Curves of all combinations of contacts that touch as one result."""
    parts = [first, *others]
    return replace(
        first,
        damping=any(part.damping for part in parts),
        curves=tuple(curve for part in parts for curve in part.curves),
        points=joined([part.points for part in parts]),
        changes={
            name: np.concatenate([part.changes[name] for part in parts]) for name in first.changes
        },
        lines={name: values for part in parts for name, values in part.lines.items()},
        complete=all(part.complete for part in parts),
        undecided=np.concatenate([part.undecided for part in parts]),
        remarks=tuple(dict.fromkeys(remark for part in parts for remark in part.remarks)),
    )


@dataclass(frozen=True)
class _Plane(Family):
    """The plane of two parameters, and what is asked of states there, shape (n + 2, N):
    coordinates, then both parameters.
    """

    def curves(self, n: int, damping: bool | None, options: ContinuationOptions) -> OnsetCurves:
        """Curves of Hopf points, or without damping those on which two modes meet."""
        systems = OnsetSystems.of(self, damping)
        damping, said = systems.damping, systems.said
        points, ends = self.points(systems)
        whole, lines = not said, dict[str, FloatArray]()
        undecided = np.empty((0, self.balance.n + 2, 2))
        curves, changes = list[Curve](), list[list[float]]()
        for sought, own_ends in zip(systems.sought, ends, strict=True):
            if sought.condition is NO_SLOPE:
                said, whole = (*said, *self.of_slope()), False
                continue
            found = on_lines(self, sought.condition, n, own_ends, options=options)
            for chain in found.chains:
                linearizations = zip(
                    _at_ends(found.curves, chain, own_ends).tolist(),
                    *matrices(self, chain, damping=sought.kind == "hopf"),
                    strict=True,
                )
                for states, omega in _pieces(
                    chain, [_modes(sought, *each) for each in linearizations]
                ):
                    forms = (
                        [UNPROVED] * len(omega)
                        if sought.kind == "flutter" or sought.frequencies is every
                        else self.forms(found.curves, states)
                    )
                    curve = self.curve(states, omega, forms)
                    curves.append(curve)
                    changes += self.changes(found.curves, states, curve.criticality.tolist())
            undecided = np.concatenate([undecided, found.undecided])
            whole = whole and found.whole
            said = said + found.remarks
            lines = found.lines
        hardly = (
            int(self.hardly_damped(undecided.mean(axis=2).T, options.undamped).sum())
            if damping and len(undecided)
            else 0
        )
        if hardly:
            said += (
                f"on lines: in {hardly} of {len(undecided)} undecided boxes C is at most "
                f"{options.undamped:g} times K: where it vanishes every pair crosses at once, and "
                "such onsets are not isolated",
            )
        where = "of points: {}" if damping else "of states: {}"
        said += () if points.complete else tuple(Remark(where, it) for it in points.remarks)
        own = own_name(self.balance.model, "error")
        names = (*self.vary, *self.balance.coordinates, own)
        rows = dict(zip(names, np.array(changes).reshape(-1, len(names)).T, strict=True))
        between = {
            name: (float(low), float(high))
            for name, (low, high) in zip(self.vary, self.spans, strict=True)
        }
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

    def of_slope(self) -> tuple[str, ...]:
        """What is not searched where friction alone damps, unless its slope keeps a sign."""
        slope = slope_over(self.balance, self.over)
        low, high = float(slope.low[0]), float(slope.high[0])
        # An end of the range at which friction vanishes is none.
        if not low < 0 < high:
            return ()
        return (
            "where the slope of the friction law is 0 nothing damps and every pair crosses: "
            "flutter_onsets lists these onsets; the slope is between "
            f"{low:.3g} and {high:.3g} here",
        )

    def points(self, systems: OnsetSystems) -> tuple[Points, list[FloatArray]]:
        """All points of all kinds at which curves end or change, and those at which the curves of
        each of the systems end.
        """
        kinds, parts = list[str](), list[Found]()
        ends = [np.empty((self.balance.n + 2, 0))] * len(systems.sought)
        for kind, condition, row in _of_points(systems):
            found = search(self, condition)
            roots = self.roots(found.roots.middle)
            # The pair with the sum 0 is imaginary, both of them at a double Hopf point.
            imaginary = (np.abs(roots.real) < 1e-5 * np.abs(roots.imag)).sum(axis=1)
            kept = (imaginary >= (4 if kind == "HH" else 2)) | (kind == "BT")
            parts.append(replace(found, roots=found.roots.select(kept)))
            kinds += [kind] * int(kept.sum())
            if kind == "BT":
                middle = parts[-1].roots.middle
                ends[row] = np.concatenate([ends[row], middle], axis=1)
        found = all_of(parts or [nothing(self)])
        return arranged(self, found, np.array(kinds, dtype=str)), ends

    def roots(self, states: FloatArray) -> ComplexArray:
        """All λ, shape (N, 2 n)."""
        return stability.roots(*matrices(self, states))

    def hardly_damped(self, states: FloatArray, share: float) -> BoolArray:
        """Mask of points where C is at most this share of K."""
        (_, C, K), (_, G, _) = (matrices(self, states, damping) for damping in (True, False))
        C = C - G
        return np.abs(C).max(axis=(1, 2)) <= share * np.abs(K).max(axis=(1, 2))

    def forms(self, curves: FoldCurves, states: FloatArray) -> list[NormalForm | Coefficient | str]:
        """What is known of l₁ at each point, over a box that is proved to hold one, or why there is
        none: by intervals of floats, and where these do not tell its sign by many digits.
        """
        ends, good = curves.enclosed(states, np.abs(curves.tangents(states)).argmax(axis=0))
        middle, n = Intervals(ends).middle, self.balance.n
        radii, given = contractors.distance(ends, middle), self.at(middle[n:])
        out: list[NormalForm | Coefficient | str] = [UNPROVED] * good.size
        rows = np.flatnonzero(good)
        quick = coefficients(self.balance, given[:, rows], ends[:, :, rows], self.vary)
        for k, form in zip(rows.tolist(), quick, strict=True):
            out[k] = (
                form_or_why(self.balance, given[:, k], middle[:n, k], self.vary, radii[:, k])
                if form is None
                else form
            )
        return out

    def curve(
        self, states: FloatArray, omega: FloatArray, forms: Sequence[NormalForm | Coefficient | str]
    ) -> Curve:
        """The points with what is known of them."""
        ours = {
            "omega": omega,
            "lyapunov": of_forms(forms, "lyapunov", np.nan),
            "lyapunov_error": of_forms(forms, "lyapunov_error", np.inf),
            "criticality": np.array([criticality_of(form)[0] for form in forms], dtype=str),
        }
        own = {own_name(self.balance.model, name): column for name, column in ours.items()}
        return Curve({**self.named(states), **own, **which(self.balance, omega.size)})

    def changes(
        self, curves: FoldCurves, states: FloatArray, kinds: Sequence[str]
    ) -> list[list[float]]:
        """Points between neighbours whose coefficients have opposite signs, halved down; a row
        each.
        """
        decided = [k for k, kind in enumerate(kinds) if kind != "undecided"]
        # At a zero–Hopf point, where det K changes its sign, l₁ has a pole.
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
        self._halve(curves, one, two, np.array(kinds)[first])
        middle, n = 0.5 * (one + two), self.balance.n
        return np.concatenate(
            [middle[n:], middle[:n], np.abs(two - one).max(axis=0)[None]]
        ).T.tolist()

    def _halve(
        self, curves: FoldCurves, one: FloatArray, two: FloatArray, kinds: NDArray[np.str_]
    ) -> None:
        """Move the points of pairs towards each other, as long as the criticality between them is
        known; ``kinds`` are those of ``one``.
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


def _of_points(systems: OnsetSystems) -> Iterator[tuple[str, Condition, int]]:
    """Kinds of points, conditions on them, and the number of the system whose curves they are on.

    Of blocks of coordinates the pair and the root 0 of a zero–Hopf point, or both pairs of a double
    one, may be those of two blocks.
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
        # With one coordinate damped the coefficient of λ³ is that damping times a mass.
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
    """ω of what oscillates at a state, 0 first at a Bogdanov–Takens point, which belongs to the
    curve.

    There two λ are 0, and rounding would say what they are.
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
    """The parts of a chain of states that have as many frequencies, once for each of these, with
    that frequency.
    """
    cuts = np.flatnonzero(np.diff([len(each) for each in modes])) + 1
    for part in np.split(np.arange(len(modes)), cuts):
        for mode in range(len(modes[part[0]]) if len(part) else 0):
            yield chain[:, part], np.array([modes[row][mode] for row in part])


def _at_ends(curves: FoldCurves, states: FloatArray, ends: FloatArray) -> BoolArray:
    """Mask of the states of a chain that are Bogdanov–Takens points, one a column."""
    off = np.abs(states[:, :, None] - ends[:, None]) / curves.scale[:, None, None]
    return (off.max(axis=0) < 1e-9).any(axis=1)
