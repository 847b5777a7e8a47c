"""Curves of Hopf points of a damped model in the plane of two parameters, and the points at which their kind changes."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..display import Result
from ..exact import contractors
from ..exact.certified_roots import concatenated
from ..exact.interval_arrays import FloatArray, Intervals
from ..exact.polynomials import Undecided
from ..results.named_columns import Columns
from ..results.onsets import criticality
from ..results.points import Points
from . import stability
from .balance import Balance
from .bifurcation import on_lines, require_lines, rows_of
from .bifurcation_conditions import BogdanovTakens, Damped, DoubleHopf, FrictionHopf, Hopf, ZeroHopf
from .defining_systems import Condition
from .fold_curves import FoldCurves
from .normal_forms import NormalForm, normal_form
from .points import arranged, given_column, picked, ranges, search

if TYPE_CHECKING:
    from .model import Model

#: Points of the plane that are nearer than this share of its scales are one.
SAME = 1e-9
#: Halvings by which a point with l₁ = 0 is enclosed.
HALVINGS = 30
#: Kinds of points in the plane, as MatCont calls them, with what is asked of a state there.
KINDS: Mapping[str, type[Damped]] = {"BT": BogdanovTakens, "ZH": ZeroHopf, "HH": DoubleHopf}


@dataclass(frozen=True, eq=False)
class OnsetCurve(Columns, held_in="values"):
    """Hopf points in order along a curve, their columns attributes under their names.

    Those are the parameters that vary, the coordinates, ``omega``, and ``lyapunov`` with its bound ``lyapunov_error``, NaN and
    inf where there is no coefficient.
    """

    values: Mapping[str, FloatArray] = field(repr=False)

    @property
    def criticality(self) -> NDArray[np.str_]:
        """As of :class:`spragsym.Onsets`, of every point."""
        return criticality(self.lyapunov, self.lyapunov_error)


@dataclass(frozen=True, eq=False)
class OnsetCurves(Result):
    """Hopf points on lines of the plane, joined to curves, and the points at which they end or change.

    Attributes
    ----------
    vary : tuple of str
        The two parameters.
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
    """

    vary: tuple[str, ...]
    curves: tuple[OnsetCurve, ...]
    points: Points
    changes: Mapping[str, FloatArray]
    lines: Mapping[str, FloatArray] = field(repr=False)
    complete: bool
    undecided: FloatArray

    def __len__(self) -> int:
        return len(self.curves)


def onset_curves(
    model: Model,
    p: Any,
    vary: Sequence[str],
    n: int = 30,
    *,
    between: Mapping[str, tuple[float, float]] | None = None,
) -> OnsetCurves:
    """All Hopf points of a damped model on ``n`` lines of either parameter, joined to curves, with the points that end them.

    Parameters
    ----------
    model : Model
    p : Parameters
        Of the model, scalars; those that vary are not used.
    vary : pair of str
        Two parameters.
    n : int
        Lines in each direction.
    between : mapping, optional
        Ranges of the two, as for :func:`spragsym.models.folds.folds`.

    Returns
    -------
    OnsetCurves

    Notes
    -----
    Source: F = 0 and Hurwitz's determinant along 2 n lines, as for :func:`spragsym.models.flutter.flutter_onsets`; two points are
    neighbours only if no line separates them. A curve that closes between two lines is not seen.
    """
    require_lines(n)
    balance = Balance(model, contact=True)
    spans = ranges(model, vary, between or {})
    given = given_column(p, balance.parameters, vary)
    condition = _condition(balance)
    points = _points(balance, p, vary, given, spans)
    ends = rows_of(balance, vary, points)[:, points.kind == "BT"]
    found = on_lines(balance, vary, condition, given, spans, n, ends)
    lines = _Lines(model, balance, tuple(vary), given, found.curves, ends)
    curves, changes = [], []
    for chain in found.chains:
        for states in lines.oscillating(chain):
            forms = lines.forms(states)
            curves.append(lines.curve(states, forms))
            changes += lines.changes(states, forms)
    names = (*vary, *balance.coordinates, "error")
    rows = np.array(changes).reshape(-1, len(names)).T
    complete = points.complete and not found.undecided.shape[0]
    return OnsetCurves(
        tuple(vary), tuple(curves), points, dict(zip(names, rows, strict=True)), found.lines, complete, found.undecided
    )  # fmt: skip


def _condition(balance: Balance) -> Condition:
    """Where a pair crosses: without the slope of the friction law as a factor where that is all that damps."""
    along = _damped_by_friction(balance)
    return Hopf() if along is None else FrictionHopf(along)


def _damped_by_friction(balance: Balance) -> int | None:
    """The coordinate along which the friction law damps, where nothing else damps any of several."""
    friction = balance.model.about["friction"]
    alone = friction is not None and friction["along"] in balance.coordinates and not balance.model.about["dampers"]
    return balance.coordinates.index(friction["along"]) if alone and balance.n > 1 else None


def _points(balance: Balance, p: Any, vary: Sequence[str], given: FloatArray, spans: FloatArray) -> Points:
    """All points of all kinds."""
    kinds, parts, along = [], [], _damped_by_friction(balance)
    for kind, condition in KINDS.items():
        # With friction's damping alone the coefficient of λ³ is its slope times a mass.
        if (kind == "HH" and (balance.n != 2 or along is not None)) or (kind == "ZH" and balance.n < 2):
            continue
        found = search(balance, vary, condition(along), given, spans)
        middle = found.roots.middle
        kept = np.array([kind == "BT" or _oscillates(balance, given, vary, state, kind) for state in middle.T], dtype=np.bool_)
        parts.append(replace(found, roots=picked(found.roots, kept)))
        kinds += [kind] * int(kept.sum())
    every = concatenated([part.roots for part in parts], balance.n + 2)
    return arranged(balance, p, vary, given, replace(parts[0], roots=every), np.array(kinds, dtype=np.str_))


def _roots(balance: Balance, given: FloatArray, vary: Sequence[str], state: FloatArray) -> NDArray[np.complex128]:
    point = given.copy()
    point[[balance.parameters.index(name) for name in vary], 0] = state[balance.n :]
    M, C, K = (part[:, :, 0] for part in stability.linearization(balance, state[: balance.n, None], point))
    return stability.roots(M, C, K)


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
        omega = np.array([self.omega(state) for state in states.T])
        off = np.abs(states[:, :, None] - self.ends[:, None]) / self.curves.scale[:, None, None]
        kept = (omega > 0) | (off.max(axis=0) < SAME).any(axis=1)
        cuts = np.flatnonzero(np.diff(kept)) + 1
        return [part for part, on in zip(np.split(states, cuts, axis=1), np.split(kept, cuts), strict=True) if on[0]]

    def omega(self, state: FloatArray) -> float:
        """ω of the pair whose sum is the nearest to 0; 0 if it is real."""
        roots = _roots(self.balance, self.given, self.vary, state)
        sums = np.abs(roots[:, None] + roots[None]) + np.where(np.eye(roots.size), np.inf, 0.0)
        one = roots[np.unravel_index(sums.argmin(), sums.shape)[0]]
        return float(abs(one.imag)) if abs(one.imag) > abs(one.real) else 0.0

    def forms(self, states: FloatArray) -> list[NormalForm | None]:
        """The normal form at each point, over a box that is proved to hold one."""
        if not states.shape[1]:
            return []
        ends, good = self.curves.enclosed(states, np.abs(self.curves.tangents(states)).argmax(axis=0))
        middle = Intervals(ends).middle
        radii = contractors.distance(ends, middle)
        return [
            self._form(state, radius) if known else None for state, radius, known in zip(middle.T, radii.T, good, strict=True)
        ]

    def _form(self, state: FloatArray, radii: FloatArray) -> NormalForm | None:
        n, point = self.balance.n, self.given[:, 0].copy()
        point[[self.balance.parameters.index(name) for name in self.vary]] = state[n:]
        try:
            return normal_form(self.model, point, state[:n], self.vary, radii)
        except Undecided:
            return None

    def curve(self, states: FloatArray, forms: Sequence[NormalForm | None]) -> OnsetCurve:
        """The points with what is known of them."""
        n = self.balance.n
        values = dict(zip((*self.vary, *self.balance.coordinates), [*states[n:], *states[:n]], strict=True))
        values["omega"] = np.array([self.omega(state) for state in states.T])
        values["lyapunov"] = np.array([np.nan if form is None else form.lyapunov for form in forms])
        values["lyapunov_error"] = np.array([np.inf if form is None else form.lyapunov_error for form in forms])
        return OnsetCurve(values)

    def changes(self, states: FloatArray, forms: Sequence[NormalForm | None]) -> list[list[float]]:
        """Points between neighbours whose coefficients have opposite signs, halved down; a row each."""
        known = [k for k, form in enumerate(forms) if told(form) != "undecided"]
        rows = []
        for one, two in itertools.pairwise(known):
            # At a zero–Hopf point, where det K changes its sign, l₁ has a pole.
            if told(forms[one]) != told(forms[two]) and self._side(states[:, one]) == self._side(states[:, two]):
                rows.append(self._between(states[:, one], states[:, two], told(forms[one])))
        return rows

    def _side(self, state: FloatArray) -> bool:
        return bool(np.prod(_roots(self.balance, self.given, self.vary, state)).real > 0)

    def _between(self, one: FloatArray, two: FloatArray, first: str) -> list[float]:
        for _ in range(HALVINGS):
            chord = (two - one) / self.curves.scale
            length = float(np.linalg.norm(chord))
            found, good = self.curves.on_curve((0.5 * (one + two))[:, None], (chord / length)[:, None], np.array([length]))
            kind = told(self.forms(found)[0]) if good[0] else "undecided"
            if kind == "undecided":
                break
            one, two = (found[:, 0], two) if kind == first else (one, found[:, 0])
        middle, n = 0.5 * (one + two), self.balance.n
        return [*middle[n:], *middle[:n], float(np.abs(two - one).max())]


def told(form: NormalForm | None) -> str:
    """gentle, dangerous or undecided."""
    return "undecided" if form is None else str(criticality(form.lyapunov, form.lyapunov_error))
