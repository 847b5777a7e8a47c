"""The bifurcation diagram of one parameter: equilibria and cycles of the motion in one result, labelled as AUTO and MatCont do.

Equilibria are those of the motion, with friction at the belt's own speed: followed by pseudo-arclength from all that the statics
prove at some values of the parameter, so that a branch is left out only if it begins and ends between two of these. Cycles are
followed from every Hopf point along the parameter, from starts that are given, and from period doublings; there may be others.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from itertools import combinations, pairwise
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ..bifurcation.flutter import flutter_onsets
from ..errors import ConvergenceError, ParameterError, SpragsymError
from ..models.field import GAP, Field, Mode, apart
from ..models.parameters import FINITE, FloatArray, ParameterSet, as_count, as_number
from ..questions import model_of
from ..remarks import At, Remark
from ..results.result import Result
from ..statics.equilibria import equilibria
from . import Cycle, CycleBranch, CycleEvent, cycle, cycle_branch
from .finding import cycle_near
from .system import System

if TYPE_CHECKING:
    from ..models.model import Model

#: Values of the parameter at which the statics say where equilibria are.
SEEDS = 13

#: Longest and shortest step along a branch of equilibria, in coordinates and halves of the range; most steps each way.
LONGEST, SHORTEST, STEPS = 0.02, 1e-7, 2000

#: Equilibria closer than this are one.
ONE = 1e-7

#: A Hopf point is located to this, relatively.
LOCATED = 1e-6

#: Real parts below this are not growth.
NEUTRAL = 1e-10

#: A test function below this has lost its sign: without dampers every pair is on the imaginary axis.
LOST = 1e-11

#: A label for each kind of event: as AUTO and MatCont have them.
LABELS = {
    "fold": "LPC", "period_doubling": "PD", "torus": "NS", "grazing": "GR", "homoclinic": "HC", "crossing": "BPC",
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class EquilibriumBranch(Result):
    """A branch of equilibria of the motion, from one of its ends to the other.

    Attributes
    ----------
    values : ndarray, shape (n,)
        Of the parameter.
    states : ndarray, shape (n, coordinates)
    stable : ndarray of bool, shape (n,)
        Whether small deviations decay, or at least do not grow.
    mode : str
        ``"contact"`` or ``"lift-off"``.
    """

    values: FloatArray
    states: FloatArray
    stable: NDArray[np.bool_]
    mode: str


@dataclass(frozen=True, eq=False)
class Label(Result):
    """A point of a diagram: LP fold, H Hopf point (of equilibria); LPC fold, PD doubling, NS torus, BPC crossing, GR grazing, HC.

    ``height`` is the first coordinate there, the largest one of a cycle; ``branch`` the number of the branch among its kind.
    """

    label: str
    value: float
    height: float
    of: str
    branch: int


@dataclass(frozen=True, eq=False)
class Diagram(Result):
    """Equilibria and cycles over one parameter.

    Attributes
    ----------
    vary : str
    to : tuple of float
        The range.
    equilibria : tuple of EquilibriumBranch
    cycles : tuple of CycleBranch
        Those from Hopf points first, then from starts, then from doublings.
    labels : tuple of Label
    remarks : tuple of str
        What was looked for and not found.
    """

    table_varied: ClassVar[frozenset[str]] = frozenset({"to"})

    vary: str
    to: tuple[float, float]
    equilibria: tuple[EquilibriumBranch, ...]
    cycles: tuple[CycleBranch, ...]
    labels: tuple[Label, ...]
    remarks: tuple[str, ...] = ()
    name: str = field(default="x", repr=False)
    model: Any = field(default=None, repr=False)


def diagram(
    p: ParameterSet, vary: str, to: tuple[float, float], *, starts: Sequence[Any] = (), doublings: int = 1, points: int = 100
) -> Diagram:
    """Equilibria and cycles of one parameter over a range.

    Parameters
    ----------
    p : ParameterSet
        Scalars; the one that varies is where ``starts`` hold.
    vary : str
        The parameter.
    to : tuple of float
        Its range.
    starts : sequence
        States near cycles at ``p``, or cycles of the model at ``p`` but for the parameter that varies; with ``None`` among them,
        what the motion from rest winds onto.
    doublings : int
        How many doublings deep doubled cycles are followed.
    points : int
        Most points of a branch of cycles each way.

    Returns
    -------
    Diagram

    Raises
    ------
    ParameterError
        For a parameter that the model does not have, a range that is none, or a cycle at other parameters.

    Notes
    -----
    Hopf points from which cycles are followed are those of :func:`spragsym.bifurcation.flutter.flutter_onsets`, proved;
    labels are located on the branches by their test functions.

    Examples
    --------
    >>> import spragsym as ss
    >>> model = ss.load("stick_slip")
    >>> found = ss.diagram(model.Parameters(), "V", (0.05, 0.3), points=60)
    >>> [(label.label, round(float(label.value), 4)) for label in found.labels]
    [('H', 0.101), ('GR', 0.1591)]
    >>> len(found.equilibria), len(found.cycles), bool(found.cycles[0].stable.any())
    (1, 1, True)
    """
    model = model_of(p)
    model.require_parameter(vary)
    p.scalars(*(name for name in model.parameters if name != vary))
    points, doublings = as_count("points", points), as_count("doublings", doublings, 0)
    low, high = (as_number("to", value, FINITE) for value in to)
    if not low < high:
        raise ParameterError(f"to = ({low:g}, {high:g}) is no range; give its lower end first")
    motion, remarks = model.field, list[str]()
    for start in starts:
        if isinstance(start, Cycle):
            start.require(motion, "starts")
            for name, value in start.parameters.items():
                if name != vary and value != (own := float(getattr(p, name))):
                    raise ParameterError(f"starts: a cycle at {name} = {value:.10g}, the diagram at {own:.10g}; give cycles at p")
    for bound in (low, high):
        motion.check(vary, bound)
    rests = _equilibria(model, motion, p, vary, (low, high))
    branches: list[CycleBranch] = []
    onsets = _onsets(model, p, vary, (low, high), remarks)
    for born in _cycles(model, motion, p, vary, onsets, starts, remarks):
        if not _known(branches, born):
            try:
                branches.append(cycle_branch(born, vary, (low, high), points=points))
            except SpragsymError as error:
                at = At(vary, (float(born.parameters[vary]),), ".10g")
                remarks.append(Remark(f"the cycle of period {born.period:.6g} at {{}} was not followed: {{}}", at, error))
    _doubled(branches, vary, (low, high), doublings, points, remarks)
    labels = [*_of_equilibria(motion, p, vary, rests), *_of_cycles(branches)]
    remarks += _left_alone(vary, labels, onsets)
    return Diagram(vary, (low, high), tuple(rests), tuple(branches), tuple(labels), tuple(remarks), model.coordinates[0], model)


def _onsets(model: Model, p: ParameterSet, vary: str, to: tuple[float, float], remarks: list[str]) -> Any:
    """The Hopf points from which cycles are followed; None where they can't be looked for."""
    try:
        return flutter_onsets(p, vary, between={vary: to})
    except SpragsymError as error:
        remarks.append(f"Hopf points were not looked for: {error}")
        return None


def _left_alone(vary: str, labels: Sequence[Label], onsets: Any) -> Iterator[str]:
    """Hopf points of the motion that are none of the statics', whose friction may be another: none is followed from there."""
    known = np.empty(0) if onsets is None else np.asarray(getattr(onsets, vary))
    for value in (label.value for label in labels if label.label == "H"):
        if not (np.abs(known - value) < LOCATED * (1 + abs(value))).any():
            at = At(vary, (float(value),), ".10g")
            yield Remark("no cycles were followed from the Hopf point {}: it is the motion's, not the statics'", at)


# -------------------------------------------------------------------------------------------------------------- equilibria


@dataclass(frozen=True)
class _Rest:
    """Equilibria of a field between its kinks, with one parameter free."""

    field: Field
    values: tuple[float, ...]
    index: int
    state: list[float]
    to: tuple[float, float]
    contact: bool = True

    @cached_property
    def mode(self) -> Mode:
        """The mode of the state, with all that is left out of motions where it is below rounding."""
        return self.field.exact(self.field.initial_mode(self.state, self.field.constants(self.values)))

    def at(self, point: FloatArray) -> tuple[tuple[float, ...], list[float], Mode]:
        """Constants, state and mode of a point: coordinates, then the parameter in halves of the range."""
        values = list(self.values)
        values[self.index] = self.value(point)
        constants, state = tuple(self.field.constants(values)), [*point[:-1].tolist(), *[0.0] * (len(point) - 1)]
        ways = len(self.mode) - self.field.ways
        return constants, state, self.mode[:ways] + self.field.initial_mode(state, constants)[ways:]

    def value(self, point: FloatArray) -> float:
        """The parameter."""
        return float(point[-1]) * (self.to[1] - self.to[0]) / 2

    def slopes(self, point: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Accelerations, and their derivatives by the point."""
        constants, state, mode = self.at(point)
        n = len(point) - 1
        force = np.array(self.field.acceleration(state, constants, mode, math), dtype=float)
        by_state = np.array(self.field.jacobian(state, constants, mode, math), dtype=float)[:, :n]
        by_value = np.array(self.field.by_parameters(state, constants, mode, math), dtype=float)[:, self.index]
        return force, np.column_stack([by_state, by_value * (self.to[1] - self.to[0]) / 2])

    def eigenvalues(self, point: FloatArray) -> NDArray[np.complex128]:
        """Eigenvalues of the linearized motion."""
        constants, state, mode = self.at(point)
        return np.asarray(np.linalg.eigvals(self.field.matrix(state, constants, mode)), dtype=complex)

    def pairs(self, point: FloatArray) -> float:
        """Product of the sums of all pairs of eigenvalues, each over its size: 0 where a pair is ± i ω."""
        pairs = combinations(self.eigenvalues(point).tolist(), 2)
        return float(math.prod((one + other) / (abs(one) + abs(other) or 1.0) for one, other in pairs).real)

    def turning(self, along: FloatArray, point: FloatArray) -> float:
        """How much of the parameter is in the direction of the branch: 0 where it turns back."""
        return float(self.tangent(point, along)[-1])

    def tangent(self, point: FloatArray, along: FloatArray) -> FloatArray:
        """Direction of the branch, of length 1."""
        tangent: FloatArray = np.linalg.svd(self.slopes(point)[1])[2][-1]
        return -tangent if tangent @ along < 0 else tangent

    def corrected(self, guess: FloatArray, row: FloatArray) -> FloatArray | None:
        """Newton's method from a guess within the plane across a row; None where it fails."""
        point = guess.copy()
        for _ in range(12):
            try:
                force, slopes = self.slopes(point)
                step = np.linalg.solve(np.vstack([slopes, row]), -np.append(force, row @ (point - guess)))
            except (np.linalg.LinAlgError, ArithmeticError):
                return None
            point = point + step
            if not np.abs(point - guess).max() < 0.5:
                return None
            if np.abs(step).max() < 1e-13 * (1 + np.abs(point).max()):
                return point
        return None

    def inside(self, point: FloatArray) -> bool:
        """Whether a state is on this side of all kinks; the field jumps at the end of a torsion spring, or is smooth."""
        constants, state, mode = self.at(point)
        kinks = (border for border in self.field.borders if border.kink and border.jumps is None)
        return all(border.sign(mode) * border.level(state, constants, mode) >= -2 * GAP for border in kinks)

    def follow(self, begin: FloatArray, sign: float) -> Iterator[FloatArray]:
        """Points in one direction, to the end of the range, of the mode, or of the steps."""
        point, length = begin, LONGEST / 8
        along = np.append(np.zeros(len(begin) - 1), sign)
        tangent = self.tangent(begin, along)
        for _ in range(STEPS):
            ahead = self.corrected(point + length * tangent, tangent)
            onward = None if ahead is None else self.tangent(ahead, tangent)
            if ahead is None or onward is None or onward @ tangent < 0.98:
                length /= 2
                if length < SHORTEST:
                    return
                continue
            value = self.value(ahead)
            if not self.to[0] <= value <= self.to[1]:
                bound = (self.to[0] if value < self.to[0] else self.to[1]) * 2 / (self.to[1] - self.to[0])
                share = (bound - point[-1]) / (ahead[-1] - point[-1])
                row = np.append(np.zeros(len(begin) - 1), 1.0)
                guess = point + share * (ahead - point)
                guess[-1] = bound
                last = self.corrected(guess, row)
                if last is not None and last[-1] != point[-1]:
                    yield last
                return
            if not self.inside(ahead):
                if length < 1e-4:
                    return
                length /= 4
                continue
            yield ahead
            point, tangent, length = ahead, onward, min(1.5 * length, LONGEST)


def _equilibria(model: Model, motion: Field, p: ParameterSet, vary: str, to: tuple[float, float]) -> list[EquilibriumBranch]:
    """All branches on which there is an equilibrium at one of some values of the parameter."""
    index, found = model.parameters.index(vary), list[tuple[_Rest, FloatArray]]()
    half = (to[1] - to[0]) / 2
    grid = np.linspace(*to, SEEDS)
    for contact in (True, False):
        try:
            known = equilibria(p.replace(**{vary: grid}), contact=contact, method="search")
        except SpragsymError:
            continue  # no unilateral contact
        places = np.stack([np.asarray(getattr(known, name)) for name in model.coordinates], axis=-1)
        for i, j in np.argwhere(np.isfinite(places).all(axis=-1)).tolist():
            values = p.replace(**{vary: float(grid[i])}).scalars(*model.parameters)
            try:
                state = System.of(p.replace(**{vary: float(grid[i])}), None).equilibrium(places[i, j])
            except ConvergenceError:
                continue
            rest = _Rest(motion, values, index, state.tolist(), to, contact)
            point = np.append(state[: len(model.coordinates)], grid[i] / half)
            if not any(other.contact == contact and _passes(other, line, point) for other, line in found):
                back, forth = (list(rest.follow(point, sign)) for sign in (-1.0, 1.0))
                found.append((rest, np.array([*reversed(back), point, *forth])))
    return [
        EquilibriumBranch(
            line[:, -1] * half, line[:, :-1],
            np.array([rest.eigenvalues(point).real.max() < NEUTRAL for point in line]), "contact" if rest.contact else "lift-off",
        )
        for rest, line in found
    ]  # fmt: skip


def _passes(rest: _Rest, line: FloatArray, point: FloatArray) -> bool:
    """Whether a branch passes through a point."""
    row = np.append(np.zeros(len(point) - 1), 1.0)
    for one, other in pairwise(line):
        point = one + apart(point, one, rest.field.around)
        if min(one[-1], other[-1]) - 1e-12 <= point[-1] <= max(one[-1], other[-1]) + 1e-12 and one[-1] != other[-1]:
            guess = one + (point[-1] - one[-1]) / (other[-1] - one[-1]) * (other - one)
            if np.abs(guess - point).max() < LONGEST:
                near = rest.corrected(guess, row)
                if near is not None and np.abs(near - point).max() < ONE:
                    return True
    return False


def _of_equilibria(motion: Field, p: ParameterSet, vary: str, rests: Sequence[EquilibriumBranch]) -> Iterator[Label]:
    """Folds, where the parameter turns back, and Hopf points, where a pair crosses the imaginary axis: located by bisection."""
    index = motion.parameters.index(vary)
    for number, branch in enumerate(rests):
        half = np.ptp(branch.values) / 2 or 1.0
        to = (0.0, 2 * half)
        for i in range(len(branch.values) - 1):
            one, other = (np.append(branch.states[j], branch.values[j] / half) for j in (i, i + 1))
            values = p.replace(**{vary: float(branch.values[i])}).scalars(*motion.parameters)
            rest = _Rest(motion, values, index, [*branch.states[i].tolist(), *[0.0] * branch.states.shape[1]], to)
            chord = (other - one) / np.linalg.norm(other - one)
            for label, test in (("LP", partial(rest.turning, chord)), ("H", rest.pairs)):
                place = _located(rest, one, other, chord, test)
                if place is not None and (label == "LP" or _is_pair(rest, place)):
                    yield Label(label, rest.value(place), float(place[0]), "equilibria", number)


def _is_pair(rest: _Rest, point: FloatArray) -> bool:
    values = rest.eigenvalues(point)
    sums = [(abs(values[i] + values[j]), abs(values[i].imag)) for i in range(len(values)) for j in range(i)]
    return bool(min(sums)[1] > 1e-6 and min(sums)[0] < 1e-6)


def _located(rest: _Rest, one: FloatArray, other: FloatArray, chord: FloatArray, test: Any) -> FloatArray | None:
    """The point between two where a test function changes its sign; None if it does not."""
    from scipy.optimize import brentq

    first, last = test(one), test(other)
    if (first < 0) == (last < 0) or min(abs(first), abs(last)) < LOST:
        return None

    def at(arc: float) -> FloatArray:
        point = rest.corrected(one + arc * chord, chord)
        if point is None:
            raise ConvergenceError("the branch is lost between two of its points")
        return point

    try:
        return at(float(brentq(lambda arc: test(at(arc)), 0.0, float(np.linalg.norm(other - one)), xtol=1e-15)))
    except (ConvergenceError, ValueError):
        return None


# ------------------------------------------------------------------------------------------------------------------ cycles


def _cycles(
    model: Model, motion: Field, p: ParameterSet, vary: str, onsets: Any, starts: Sequence[Any], remarks: list[str]
) -> Iterator[Cycle]:  # fmt: skip
    """A cycle of each family that is known of: born at a Hopf point, or near a start."""
    for i, value in enumerate([] if onsets is None else np.asarray(getattr(onsets, vary)).tolist()):
        try:
            yield cycle(onset=onsets, index=i)
        except SpragsymError as error:
            at = At(vary, (float(value),), ".10g")
            remarks.append(Remark("no cycle was found at the Hopf point {}: {}", at, error))
    for start in starts:
        try:
            yield start if isinstance(start, Cycle) else cycle_near(System.of(p, None), start)
        except ConvergenceError as error:
            remarks.append(f"no cycle was found from {start}: {error}")


def _known(branches: Sequence[CycleBranch], cycle: Cycle) -> bool:
    """Whether a cycle is on a branch that is there: that branch's own cycle at the same value of the parameter is it."""
    for branch in branches:
        value = cycle.parameters[branch.vary]
        for i in np.flatnonzero((branch.values[:-1] - value) * (branch.values[1:] - value) <= 0).tolist():
            close = min(abs(branch.periods[j] / cycle.period - 1) for j in (i, i + 1))
            apart = abs(branch.periods[i + 1] / branch.periods[i] - 1) + 1e-6
            if close < 2 * apart and min(abs(branch.amplitude[j] - cycle.amplitude) for j in (i, i + 1)) < 2 * abs(
                branch.amplitude[i + 1] - branch.amplitude[i]
            ) + 1e-6 * (1 + cycle.amplitude):
                return True
    return False


def _doubled(
    branches: list[CycleBranch], vary: str, to: tuple[float, float], depth: int, points: int, remarks: list[str]
) -> None:  # fmt: skip
    """Branches of doubled cycles, added to the others, so many doublings deep."""
    begin = 0
    for _ in range(depth):
        now, begin = branches[begin:], len(branches)
        for branch in now:
            for event in branch.of("period_doubling"):
                if any(_ends_at(other, event) for other in branches[begin:]):
                    continue
                try:
                    doubled = branch.switch(event)
                    if to[0] <= doubled.parameters[vary] <= to[1]:
                        branches.append(cycle_branch(doubled, vary, to, points=points))
                except SpragsymError as error:
                    at = At(vary, (float(event.value),), ".10g")
                    remarks.append(Remark("the doubled cycle at {} was not found: {}", at, error))


def _ends_at(branch: CycleBranch, event: CycleEvent) -> bool:
    """Whether a branch of doubled cycles ends at a doubling."""
    return any(
        abs(end.value - event.value) < 1e-6 * (1 + abs(event.value)) and abs(end.cycle.period / event.cycle.period - 1) < 1e-5
        for end in branch.of("end")
    )


def _of_cycles(branches: Sequence[CycleBranch]) -> Iterator[Label]:
    for number, branch in enumerate(branches):
        for event in branch.events:
            kind = "crossing" if event.kind == "fold" and event.how else event.kind
            if kind in LABELS:
                yield Label(LABELS[kind], event.value, float(event.cycle.state[0]), "cycles", number)
