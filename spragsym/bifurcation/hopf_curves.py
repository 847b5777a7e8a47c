"""Curves of onsets of flutter in the plane of two parameters: Hopf points and where their kind changes, or modes that meet."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..models.parameters import ParameterSet, as_count
from ..numerics import contractors
from ..numerics.balls import Undecided
from ..numerics.certified_roots import concatenated
from ..numerics.interval_arrays import FloatArray, Intervals
from ..questions import model_of
from ..remarks import Remark
from ..results.named_columns import Columns
from ..results.points import Points
from ..results.result import Result
from ..statics import stability
from ..statics.damping import is_conservative, only_damped, slope_ends
from ..statics.mechanics.balance import Balance
from .bifurcation import on_lines, rows_of
from .bifurcation_conditions import FLUTTER, HOPF, KINDS, no_damping, undamped_mode
from .defining_systems import Condition
from .flutter import meeting
from .fold_curves import FoldCurves
from .normal_forms import NormalForm, normal_form
from .onsets import told
from .points import arranged, given_column, nothing, ranges, search

if TYPE_CHECKING:
    from ..models.model import Model

#: Points of the plane that are nearer than this share of its scales are one.
SAME = 1e-9
#: Why a point has no normal form that is not proved to be a generic Hopf point.
UNPROVED = "no generic Hopf point is proved there"
#: Halvings by which a point with l₁ = 0 is enclosed.
HALVINGS = 30
#: C over K below which a state is as good as undamped.
UNDAMPED = 1e-6


@dataclass(frozen=True, eq=False)
class OnsetCurve(Columns, held_in="values"):
    """Hopf points in order along a curve, their columns attributes under their names.

    Those are the parameters that vary, the coordinates, ``omega``, ``lyapunov`` with its bound ``lyapunov_error``, NaN and inf
    where there is no coefficient, and ``criticality``, as of :class:`spragsym.Onsets`.
    """

    values: Mapping[str, NDArray[Any]] = field(repr=False)


@dataclass(frozen=True, eq=False)
class OnsetCurves(Result):
    """Onsets on lines of the plane, joined to curves, and points at which these end or change.

    Attributes
    ----------
    vary : tuple of str
        The two parameters.
    damping : bool
        Whether with all damping, or by (27), without: then curves are where two modes meet, and have no ``lyapunov``.
    between : mapping
        Ranges of the two.
    curves : tuple of OnsetCurve
        Hopf points in the order in which they follow each other. Each is proved; that they are joined in the right order is not.
    points : Points
        All points of the kinds ``"BT"`` (Bogdanov–Takens: a curve ends on a fold), ``"ZH"`` (zero–Hopf: it meets a fold) and
        ``"HH"`` (double Hopf: two curves meet; sought with two coordinates), proved.
    changes : mapping
        Generalized Hopf points (GH), where l₁ changes its sign along a curve: columns of the two parameters, of the coordinates,
        and ``error``, the distance of the two proved points with opposite signs between which it lies.
    lines : mapping
        For each parameter the values at which all Hopf points along the other one are known.
    complete : bool
        Whether all onsets on all lines, and all points, are decided.
    undecided : ndarray
        Lower and upper ends of the boxes on lines that are not, shape (boxes, unknowns, 2): coordinates, then parameters.
    remarks : tuple of str
        Why the result is not complete: what is known of these boxes, and what was not searched.
    """

    vary: tuple[str, ...]
    damping: bool
    between: Mapping[str, tuple[float, float]]
    curves: tuple[OnsetCurve, ...]
    points: Points
    changes: Mapping[str, FloatArray]
    lines: Mapping[str, FloatArray] = field(repr=False)
    complete: bool
    undecided: FloatArray
    remarks: tuple[str, ...]

    def __len__(self) -> int:
        return len(self.curves)


def onset_curves(
    p: ParameterSet,
    vary: Sequence[str] | None = None,
    n: int = 30,
    *,
    damping: bool = True,
    between: Mapping[str, tuple[float, float]] | None = None,
) -> OnsetCurves:
    """Curves of Hopf points in the plane of two parameters, each point gentle or dangerous, and where curves end and change.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; those that vary are not used.
    vary : pair of str, optional
        Two parameters; without it ``theta0`` and ``mu0``.
    n : int
        Lines of either parameter on which all Hopf points are found and proved.
    damping : bool
        With all damping, that of the friction law included; or by (27), without: curves on which two modes meet.
    between : mapping, optional
        Ranges of the two, as ``{"mu0": (0, 1)}``.

    Returns
    -------
    OnsetCurves
        ``curves``, each point with ``criticality``; ``points``, all those of the kinds BT, ZH and HH, proved; and ``changes``,
        where l₁ passes 0 along a curve (GH).

    Raises
    ------
    ParameterError
        For parameters that the model has not, or ranges that leave theirs.

    Notes
    -----
    Source: F = 0 and Hurwitz's determinant along 2 n lines, as for :func:`spragsym.bifurcation.flutter.flutter_onsets`;
    two points are neighbours only if no line separates them. A curve that closes between two lines is not seen. Where the only
    coordinate that is damped has no damping, by a falling friction law against a damper, every pair crosses, and each is a curve
    without l₁.

    Examples
    --------
    >>> import spragsym as ss
    >>> p = ss.load("stick_slip").Parameters()
    >>> found = ss.onset_curves(p, ("V", "zeta"), between={"V": (0.0, 1.0), "zeta": (0.0, 2.0)})
    >>> len(found), sorted(set(found.curves[0].criticality.tolist()))
    (1, ['dangerous', 'gentle'])
    >>> found.changes["V"].round(4).tolist()  # where F‴ = 0, at (1 + √2) v_s
    [0.2414]
    """
    model = model_of(p)
    vary = model.two(vary)
    as_count("n", n, 2)
    balance = Balance(model, contact=True)
    spans = ranges(model, vary, between or {})
    given = given_column(p, balance.parameters, vary)
    ranged = {name: (float(low), float(high)) for name, (low, high) in zip(vary, spans, strict=True)}
    if not damping:
        return _without_damping(model, balance, p, tuple(vary), given, spans, n, ranged)
    only = only_damped(balance, given, vary, spans) if balance.n > 1 else None
    dampers = bool(model.about["dampers"])
    points = _points(balance, p, vary, given, spans, only)
    ends = rows_of(balance, vary, points)[:, points.kind == "BT"]
    free = _hardly_damped(balance, vary, given, ends) & (only is not None)
    rest, ends = ends[:, free], ends[:, ~free]
    found = on_lines(balance, vary, HOPF if only is None else undamped_mode(only), given, spans, n, ends)
    lines = _Lines(model, balance, tuple(vary), given, found.curves, ends)
    curves, changes = [], []
    for chain in found.chains:
        for states in lines.oscillating(chain):
            forms = lines.forms(states)
            curves.append(lines.curve(states, lines.omegas(states), forms))
            changes += lines.changes(states, forms)
    undecided, whole, said = found.undecided, found.whole, found.remarks
    if only is not None and not dampers:
        low, high = slope_ends(balance, given, vary, spans)
        if low < 0 < high:  # an end of the range at which friction vanishes is none
            text = (
                "where the slope of the friction law is 0 nothing damps and every pair crosses: flutter_onsets lists these onsets"
            )
            whole, said = False, (*said, f"{text}; the slope is between {low:.3g} and {high:.3g} here")
    if only is not None and dampers:
        flat = on_lines(balance, vary, no_damping(only), given, spans, n, rest)
        lines = _Lines(model, balance, tuple(vary), given, flat.curves, rest)
        curves += [curve for chain in flat.chains for curve in lines.of_all_pairs(chain)]
        undecided, whole, said = np.concatenate([undecided, flat.undecided]), whole and flat.whole, said + flat.remarks
    names = (*vary, *balance.coordinates, "error")
    rows = np.array(changes).reshape(-1, len(names)).T
    complete = points.complete and whole and not len(undecided)
    remarks = (*said, *_undamped(balance, vary, given, undecided), *(Remark("of points: {}", it) for it in points.remarks))
    return OnsetCurves(
        tuple(vary), True, ranged, tuple(curves), points, dict(zip(names, rows, strict=True)), found.lines, complete, undecided,
        remarks,
    )  # fmt: skip


def _without_damping(
    model: Model, balance: Balance, p: ParameterSet, vary: tuple[str, ...], given: FloatArray, spans: FloatArray, n: int,
    ranged: Mapping[str, tuple[float, float]],
) -> OnsetCurves:  # fmt: skip
    """Curves on which two modes meet; none where there are not two, or where forces have a potential."""
    none, curves = np.empty((balance.n + 2, 0)), list[OnsetCurve]()
    points = arranged(balance, p, vary, given, nothing(balance, vary, given, spans), np.empty(0, dtype=np.str_))
    changes = {name: np.empty(0) for name in (*vary, *balance.coordinates, "error")}
    if balance.n < 2 or is_conservative(balance, given, spans):
        return OnsetCurves(vary, False, ranged, (), points, changes, {}, True, np.empty((0, balance.n + 2, 2)), ())
    found = on_lines(balance, vary, FLUTTER, given, spans, n, none)
    lines = _Lines(model, balance, vary, given, found.curves, none)
    for chain in found.chains:
        omega = np.array([sum(meeting(*lines.matrices(state))) for state in chain.T])
        parts = np.split(np.arange(omega.size), np.flatnonzero(np.diff(omega > 0)) + 1)
        curves += [lines.curve(chain[:, part], omega[part], [UNPROVED] * len(part)) for part in parts if omega[part].any()]
    complete = found.whole and not len(found.undecided)
    return OnsetCurves(vary, False, ranged, tuple(curves), points, changes, found.lines, complete, found.undecided, found.remarks)


def _hardly_damped(balance: Balance, vary: Sequence[str], given: FloatArray, states: FloatArray) -> NDArray[np.bool_]:
    """Where C is next to nothing beside K."""
    if not states.shape[1]:
        return np.zeros(0, dtype=np.bool_)
    point = np.repeat(given, states.shape[1], axis=1)
    point[[balance.parameters.index(name) for name in vary]] = states[balance.n :]
    with np.errstate(all="ignore"):
        _, C, K = stability.linearization(balance, states[: balance.n], point)
        hardly: NDArray[np.bool_] = np.abs(C).max(axis=(0, 1)) <= UNDAMPED * np.abs(K).max(axis=(0, 1))
    return hardly


def _undamped(balance: Balance, vary: Sequence[str], given: FloatArray, undecided: FloatArray) -> tuple[str, ...]:
    """Of boxes in whose middle hardly anything damps: where C is 0 every pair crosses at once, and no root is isolated."""
    number = int(_hardly_damped(balance, vary, given, undecided.mean(axis=2).T).sum()) if len(undecided) else 0
    if not number:
        return ()
    text = f"of {len(undecided)} undecided boxes C is at most {UNDAMPED:g} times K: where it vanishes every pair crosses at once"
    return (f"on lines: in {number} {text}, and such onsets are not isolated",)


def _points(
    balance: Balance, p: Any, vary: Sequence[str], given: FloatArray, spans: FloatArray, only: int | None
) -> Points:  # fmt: skip
    """All points of all kinds; ``only`` one coordinate is damped, if it is given."""
    kinds, parts = [], []
    sought: list[tuple[str, Condition]] = [(kind, condition(only)) for kind, condition in KINDS.items()]
    if only is not None and balance.model.about["dampers"]:
        sought.insert(1, ("BT", no_damping(only, on_fold=True)))
    for kind, condition in sought:
        # With one coordinate damped the coefficient of λ³ is that damping times a mass.
        if (kind == "HH" and (balance.n != 2 or only is not None)) or (kind == "ZH" and balance.n < 2):
            continue
        found = search(balance, vary, condition, given, spans)
        middle = found.roots.middle
        kept = np.array([kind == "BT" or _oscillates(balance, given, vary, state, kind) for state in middle.T], dtype=np.bool_)
        parts.append(replace(found, roots=found.roots.kept(kept)))
        kinds += [kind] * int(kept.sum())
    every = concatenated([part.roots for part in parts], balance.n + 2)
    return arranged(balance, p, vary, given, replace(parts[0], roots=every), np.array(kinds, dtype=np.str_))


def _matrices(balance: Balance, given: FloatArray, vary: Sequence[str], state: FloatArray) -> Iterator[FloatArray]:
    point = given.copy()
    point[[balance.parameters.index(name) for name in vary], 0] = state[balance.n :]
    return (part[:, :, 0] for part in stability.linearization(balance, state[: balance.n, None], point))


def _roots(balance: Balance, given: FloatArray, vary: Sequence[str], state: FloatArray) -> NDArray[np.complex128]:
    return stability.roots(*_matrices(balance, given, vary, state))


def frequencies(roots: NDArray[np.complex128]) -> list[float]:
    """ω of the pairs ± i ω among the roots of a state that nothing damps, ascending."""
    return sorted(abs(root.imag) for root in roots[roots.imag > 0] if abs(root.real) < 1e-5 * root.imag)


def _oscillates(balance: Balance, given: FloatArray, vary: Sequence[str], state: FloatArray, kind: str) -> bool:
    """Whether the pair with the sum 0 is imaginary: both of them at a double Hopf point."""
    roots = _roots(balance, given, vary, state)
    pairs = 2 if kind == "HH" else 1
    return int((np.abs(roots.real) < 1e-5 * np.abs(roots.imag)).sum()) >= 2 * pairs


@dataclass(frozen=True)
class _Lines:
    """What is asked of the points of curves."""

    model: Model
    balance: Balance
    vary: tuple[str, ...]
    given: FloatArray
    curves: FoldCurves
    ends: FloatArray  #: Bogdanov–Takens points, one a column

    def oscillating(self, states: FloatArray) -> list[FloatArray]:
        """The parts of a chain on which a pair is imaginary; on the others two real eigenvalues have the sum 0.

        At a Bogdanov–Takens point both are 0, and rounding would say what they are: it belongs to the curve that ends there.
        """
        if not states.shape[1]:
            return []
        omega = self.omegas(states)
        kept = (omega > 0) | self._at_ends(states)
        cuts = np.flatnonzero(np.diff(kept)) + 1
        return [part for part, on in zip(np.split(states, cuts, axis=1), np.split(kept, cuts), strict=True) if on[0]]

    def _at_ends(self, states: FloatArray) -> NDArray[np.bool_]:
        """Which states are Bogdanov–Takens points."""
        off = np.abs(states[:, :, None] - self.ends[:, None]) / self.curves.scale[:, None, None]
        here: NDArray[np.bool_] = (off.max(axis=0) < SAME).any(axis=1)
        return here

    def of_all_pairs(self, chain: FloatArray) -> list[OnsetCurve]:
        """A curve for each pair, on the parts of a chain of states without damping that have as many."""
        modes = []
        for state, ends in zip(chain.T, self._at_ends(chain), strict=True):
            roots = _roots(self.balance, self.given, self.vary, state)
            others = roots[np.argsort(np.abs(roots))[2:]]
            modes.append([0.0, *frequencies(others)] if ends else frequencies(roots))
        cuts = np.flatnonzero(np.diff([len(each) for each in modes])) + 1
        return [
            self.curve(chain[:, part], np.array([modes[row][mode] for row in part]), [UNPROVED] * len(part))
            for part in np.split(np.arange(len(modes)), cuts)
            for mode in range(len(modes[part[0]]) if len(part) else 0)
        ]

    def matrices(self, state: FloatArray) -> Iterator[FloatArray]:
        """M, C and K at a point."""
        return _matrices(self.balance, self.given, self.vary, state)

    def omegas(self, states: FloatArray) -> FloatArray:
        """ω at each point."""
        return np.array([self.omega(state) for state in states.T])

    def omega(self, state: FloatArray) -> float:
        """ω of the pair whose sum is the nearest to 0; 0 if it is real."""
        return stability.frequency(_roots(self.balance, self.given, self.vary, state))

    def forms(self, states: FloatArray) -> list[NormalForm | str]:
        """The normal form at each point, over a box that is proved to hold one, or why there is none."""
        if not states.shape[1]:
            return []
        ends, good = self.curves.enclosed(states, np.abs(self.curves.tangents(states)).argmax(axis=0))
        middle = Intervals(ends).middle
        radii = contractors.distance(ends, middle)
        return [
            self._form(state, radius) if known else UNPROVED for state, radius, known in zip(middle.T, radii.T, good, strict=True)
        ]

    def _form(self, state: FloatArray, radii: FloatArray) -> NormalForm | str:
        n, point = self.balance.n, self.given[:, 0].copy()
        point[[self.balance.parameters.index(name) for name in self.vary]] = state[n:]
        try:
            return normal_form(self.model, point, state[:n], self.vary, radii)
        except Undecided as reason:
            return str(reason)

    def curve(self, states: FloatArray, omega: FloatArray, forms: Sequence[NormalForm | str]) -> OnsetCurve:
        """The points with what is known of them."""
        n = self.balance.n
        values: dict[str, NDArray[Any]] = dict(
            zip((*self.vary, *self.balance.coordinates), [*states[n:], *states[:n]], strict=True)
        )
        values["omega"] = omega
        values["lyapunov"] = np.array([np.nan if isinstance(form, str) else form.lyapunov for form in forms])
        values["lyapunov_error"] = np.array([np.inf if isinstance(form, str) else form.lyapunov_error for form in forms])
        values["criticality"] = np.array([told(form)[0] for form in forms], dtype=np.str_)
        return OnsetCurve(values)

    def changes(self, states: FloatArray, forms: Sequence[NormalForm | str]) -> list[list[float]]:
        """Points between neighbours whose coefficients have opposite signs, halved down; a row each."""
        kinds = [told(form)[0] for form in forms]
        known = [k for k, kind in enumerate(kinds) if kind != "undecided"]
        rows = []
        for one, two in itertools.pairwise(known):
            # At a zero–Hopf point, where det K changes its sign, l₁ has a pole.
            if kinds[one] != kinds[two] and self._side(states[:, one]) == self._side(states[:, two]):
                rows.append(self._between(states[:, one], states[:, two], kinds[one]))
        return rows

    def _side(self, state: FloatArray) -> bool:
        return bool(np.prod(_roots(self.balance, self.given, self.vary, state)).real > 0)

    def _between(self, one: FloatArray, two: FloatArray, first: str) -> list[float]:
        for _ in range(HALVINGS):
            chord = (two - one) / self.curves.scale
            length = float(np.linalg.norm(chord))
            found, good = self.curves.on_curve((0.5 * (one + two))[:, None], (chord / length)[:, None], np.array([length]))
            kind = told(self.forms(found)[0])[0] if good[0] else "undecided"
            if kind == "undecided":
                break
            one, two = (found[:, 0], two) if kind == first else (one, found[:, 0])
        middle, n = 0.5 * (one + two), self.balance.n
        return [*middle[n:], *middle[:n], float(np.abs(two - one).max())]
