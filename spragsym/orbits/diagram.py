"""The bifurcation diagram of one parameter: branches of equilibria and of cycles, with labels as in
AUTO and MatCont.

Equilibria are those of the motion, with the friction at the belt's speed. Their branches are
followed by pseudo-arclength continuation from all equilibria that statics proves at a grid of
values of the parameter; a branch can be missed only if it begins and ends between two of these
values. Cycles are followed from every Hopf point along the parameter, from the given starts, and
from period doublings; other cycles may exist.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import combinations, islice, pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..bifurcation.branches import undecided_parts, undecided_points
from ..bifurcation.flutter import Onsets, flutter_onsets
from ..core.error_states import in_usual_state
from ..core.errors import ConvergenceError, ParameterError, SpragsymError
from ..core.questions import model_of
from ..core.remarks import At, Remark
from ..display import Column
from ..models.model import Touching
from ..models.parameters import FloatArray, ParameterSet, Ranges, Span, as_count, varied_range
from ..motion.scales import MotionScales
from ..motion.shooting import natural
from ..numerics.interval_arrays import BoolArray, joined
from ..numerics.vectors import magnitude, state_difference
from ..results import Equilibria
from ..results.result import Result
from ..statics.equilibria import equilibria
from . import Cycle, CycleBranch, cycle, cycle_branch
from .arclength import BranchPoint, between, placed, steps, turning, within, zero_of
from .branch import all_followed
from .events import BRANCH_POINT, SLIDING
from .finding import cycle_near
from .options import BranchOptions
from .orbit import same_cycle
from .system import FixedPoints, System

#: Growth in units of the motion beyond which an equilibrium is unstable.
GROWS = 1e-10
#: Options of branches of equilibria, with steps in units of the motion and of half the range.
OF_EQUILIBRIA = BranchOptions(first_step=0.0025, longest_step=0.02, shortest_step=1e-7, kink=0.0)


@dataclass(frozen=True, eq=False)
class EquilibriumBranch(Result):
    """A branch of equilibria of the motion, from one of its ends to the other.

    Attributes
    ----------
    values : ndarray, shape (n,)
        Values of the parameter.
    states : ndarray, shape (n, coordinates)
        Coordinates.
    stable : ndarray of bool, shape (n,)
        True if small deviations do not grow.
    mode : str
        ``"contact"`` or ``"lift-off"``; ``"opposite face"`` for a contact that presses on either of
        two faces; with several contacts, which of them touch.
    """

    values: FloatArray
    states: FloatArray
    stable: BoolArray
    mode: str


@dataclass(frozen=True, eq=False)
class Label(Result):
    """A labelled point of a diagram.

    Labels of equilibria: LP fold, H Hopf point. Labels of cycles: LPC fold, PD period doubling, NS
    torus, BPC crossing of another branch, GR grazing, HC homoclinic orbit; GS grazing-sliding, CS
    crossing-sliding, SS switching-sliding, AS adding-sliding, CT catastrophic-sliding.

    ``height`` is the first coordinate, of a cycle its maximum. ``of`` is "equilibria" or "cycles",
    ``branch`` the index of the branch among these. ``unstable_before`` and ``unstable_after`` are
    how many λ grow in equilibria of the branch at smaller and at larger values of the parameter, at
    a fold the smaller and the larger number of its two sides; −1 of cycles.
    """

    label: str
    value: float
    height: float
    of: str
    branch: int
    unstable_before: int = -1
    unstable_after: int = -1


@dataclass(frozen=True, eq=False)
class Diagram(Result):
    """Equilibria and cycles over one parameter.

    Attributes
    ----------
    vary : str
    to : tuple of float
        Range of the parameter.
    equilibria : tuple of EquilibriumBranch
    cycles : tuple of CycleBranch
        First those from Hopf points, then those from starts, then those from doublings.
    labels : tuple of Label
    remarks : tuple of str
        What was searched for and not found.
    undecided : tuple of (float, float)
        Ranges of the parameter in which equilibria or Hopf points may be missing.
    """

    schema = (
        Column("of", "1", "equilibria or cycles"),
        Column("branch", "1", "number of the branch among its kind"),
        Column("lowest", "{x}", "least {x}"),
        Column("highest", "{x}", "largest {x}"),
        Column("period", "s", "period of the cycle; NaN of equilibria"),
        Column("stable", "1", "whether it attracts"),
    )

    vary: str
    to: tuple[float, float]
    equilibria: tuple[EquilibriumBranch, ...]
    cycles: tuple[CycleBranch, ...]
    labels: tuple[Label, ...]
    remarks: tuple[str, ...]
    name: str = field(repr=False)
    model: Any = field(repr=False)
    undecided: tuple[Span, ...] = ()

    def data(self) -> dict[str, NDArray[Any]]:
        """The points of all branches, branch by branch, as columns: kind (``of``), index of the
        ``branch``, parameter, minimum and maximum of the first coordinate, period (NaN for
        equilibria), stability.

        Returns
        -------
        dict of str to array
            Columns of equal length, one row per point.

        Examples
        --------
        >>> import spragsym as ss
        >>> model = ss.load("stick_slip")
        >>> found = ss.diagram(model.Parameters(), "V", between={"V": (0.05, 0.3)}, points=60)
        >>> sorted(set(found.data()["of"].tolist()))
        ['cycles', 'equilibria']
        """
        rows = list[tuple[Any, ...]]()
        for i, rest in enumerate(self.equilibria):
            x = rest.states[:, 0]
            rows.append(("equilibria", i, rest, x, x, np.full(x.size, np.nan)))
        for i, own in enumerate(self.cycles):
            rows.append(("cycles", i, own, own.lowest, own.highest, own.periods))
        if not rows:
            return {}
        kinds, indices, branches, lowest, highest, periods = zip(*rows, strict=True)
        sizes = [branch.values.size for branch in branches]
        return {
            self._own("of"): np.repeat(kinds, sizes),
            self._own("branch"): np.repeat(indices, sizes),
            self.vary: np.concatenate([branch.values for branch in branches]),
            self._own("lowest"): np.concatenate(lowest),
            self._own("highest"): np.concatenate(highest),
            self._own("period"): np.concatenate(periods),
            self._own("stable"): np.concatenate([branch.stable for branch in branches]),
        }


@in_usual_state
def diagram(
    p: ParameterSet,
    vary: str,
    *,
    between: Ranges,
    starts: Sequence[Any] = (),
    doublings: int = 1,
    points: int = 400,
) -> Diagram:
    """Branches of equilibria and cycles over the range of one parameter.

    Parameters
    ----------
    p : ParameterSet
        Scalars. The value of ``vary`` is used for ``starts`` only.
    vary : str
        The parameter.
    between : mapping
        Range of the parameter, by its name.
    starts : sequence
        States near cycles at ``p``; cycles, which may be at other values of ``vary``; or None for
        the cycle that the motion from rest approaches.
    doublings : int
        Number of successive period doublings after which doubled cycles are followed.
    points : int
        Maximum number of points of a branch of cycles in each direction.

    Returns
    -------
    Diagram

    Raises
    ------
    ParameterError
        For a parameter that the model does not have, an invalid range, or a cycle at other
        parameters.

    Notes
    -----
    The Hopf points from which cycles are followed are those proved by
    :func:`spragsym.bifurcation.flutter.flutter_onsets`. Labels are located on the branches by test
    functions.

    Examples
    --------
    >>> import spragsym as ss
    >>> model = ss.load("stick_slip")
    >>> found = ss.diagram(model.Parameters(), "V", between={"V": (0.05, 0.3)}, points=60)
    >>> [(label.label, round(float(label.value), 4)) for label in found.labels]
    [('H', 0.101), ('GR', 0.1591)]
    >>> len(found.equilibria), len(found.cycles), bool(found.cycles[0].stable.any())
    (1, 1, True)
    >>> found.data()["V"].size == found.equilibria[0].values.size + found.cycles[0].values.size
    True
    """
    model = model_of(p)
    model.require_answered("diagram")
    model.require_parameter(vary)
    p.scalars(*(name for name in model.parameters if name != vary))
    points, doublings = as_count("points", points), as_count("doublings", doublings, 0)
    low, high = varied_range(vary, between, p.ranges[vary])
    motion, remarks = model.field, list[str]()
    for start in starts:
        if isinstance(start, Cycle):
            start.require(motion, "starts")
            for name, value in start.parameters.items():
                if name != vary and value != (own := float(p[name])):
                    raise ParameterError(
                        f"starts: a cycle at {name} = {value:.10g}, the diagram at "
                        f"{own:.10g}; give cycles at p"
                    )
    seeds = _seeds(p, vary, (low, high))
    rests = list(_equilibria(p, vary, (low, high), seeds, remarks))
    branches: list[CycleBranch] = []
    onsets, born_at = None, np.empty(0)
    try:
        onsets = flutter_onsets(p, vary, between=between)
        born_at = onsets[vary]
    except SpragsymError as error:
        remarks.append(f"Hopf points were not looked for: {error}")
    for born in _cycles(p, vary, onsets, born_at, starts, remarks):
        if not _is_known_cycle(branches, born):
            try:
                branches.append(cycle_branch(born, vary, between=between, points=points))
            except SpragsymError as error:
                at = _at(vary, born.parameters[vary])
                remarks.append(
                    Remark(
                        f"the cycle of period {born.period:.6g} at {{}} was not followed: {{}}",
                        at,
                        error,
                    )
                )
    _doubled(branches, vary, (low, high), doublings, points, remarks)
    labels = [*(label for _, own in rests for label in own), *_of_cycles(branches)]
    remarks += _not_followed(vary, labels, born_at, 1e-6 * (high - low))
    for number, branch in enumerate(branches):
        for end in branch.of("end"):
            if end.how == all_followed(points):
                remarks.append(
                    Remark(
                        "the branch of cycles {} goes on beyond {}: {}; give more points",
                        number,
                        _at(vary, end.value),
                        end.how,
                    )
                )
    spans = [undecided_points(eq, vary, (low, high)) for _, eq in seeds]
    parts = joined(np.concatenate([undecided_parts(onsets, (low, high)), *spans]))
    undecided = [(start, end) for start, end in parts.tolist()]
    remarks += [
        Remark("equilibria or Hopf points may be missing for {}", At(vary, part))
        for part in undecided
    ]
    return Diagram(
        vary,
        (low, high),
        tuple(branch for branch, _ in rests),
        tuple(branches),
        tuple(labels),
        tuple(remarks),
        model.coordinates[0],
        model,
        tuple(undecided),
    )


def _not_followed(
    vary: str, labels: Sequence[Label], known: FloatArray, tolerance: float
) -> Iterator[str]:
    """Remarks on Hopf points of the motion that are not among the ``known`` ones of statics, whose
    friction may differ: no cycles are followed from these.
    """
    for value in (label.value for label in labels if label.label == "H"):
        if not (np.abs(known - value) < tolerance).any():
            yield Remark(
                "no cycles were followed from the Hopf point {}: it is the motion's, not the "
                "statics'",
                _at(vary, value),
            )


def _at(vary: str, value: float) -> At:
    """Text "parameter = value" of a remark."""
    return At(vary, (float(value),), ".10g")


def _followed(rest: FixedPoints, point: BranchPoint, to: Span) -> Iterator[BranchPoint]:
    """Points of a branch of equilibria beyond one, up to the end of the range or of the mode, 2000
    at most.
    """

    def ahead(point: BranchPoint, length: float) -> BranchPoint:
        found = within(point, length, to, reach=0.5)
        if not rest.inside(found):
            raise ConvergenceError("the mode ends")
        return found

    with suppress(ConvergenceError):
        for found in islice(steps(point, ahead, OF_EQUILIBRIA), 2000):
            # Equal if the first point is at the end of the range.
            if (found.coordinates != point.coordinates).any():
                yield found
            if found.value in to:
                return


def _located(
    one: BranchPoint, other: BranchPoint, test: Callable[[BranchPoint], float]
) -> BranchPoint | None:
    """The point between two at which a test function changes sign; None if it does not."""
    first, last = test(one), test(other)
    # Below 1e-11 the sign is rounding: without dampers all eigenvalues are imaginary.
    if (first < 0) == (last < 0) or min(abs(first), abs(last)) < 1e-11:
        return None
    with suppress(ConvergenceError, ValueError):
        return zero_of(test, one, other, between(one, other), xtol=1e-15)
    return None


def _labels(rest: FixedPoints, line: Sequence[BranchPoint], number: int) -> Iterator[Label]:
    """Labels of folds and Hopf points of a branch of equilibria with index ``number``."""
    for one, other in pairwise(line):
        fold, hopf = (_located(one, other, test) for test in (turning, rest.pairs))
        if hopf is not None:
            # Two real eigenvalues ± λ are a zero of the test function, too, but no Hopf point.
            total, frequency = min(
                (abs(a + b), abs(a.imag)) for a, b in combinations(rest.eigenvalues(hopf), 2)
            )
            hopf = hopf if frequency > 1e-6 > total else None
        for label, point in (("LP", fold), ("H", hopf)):
            if point is not None:
                x = float(natural(point.orbit).state[0])
                ends = sorted((one, other), key=lambda end: end.value)
                beside = [sum(z.real > GROWS for z in rest.eigenvalues(end)) for end in ends]
                beside = sorted(beside) if label == "LP" else beside
                yield Label(label, point.value, x, "equilibria", number, *beside)


def _passes(line: Sequence[BranchPoint], point: BranchPoint) -> bool:
    """True if a branch of equilibria passes through a point."""
    state, periodic = point.orbit.state, point.orbit.field.periodic
    for end in (line[0], line[-1]):  # a branch may end just before a border, and the point be on it
        in_parameter = abs(end.value - point.value) / point.setting.spans[0]
        in_state = magnitude(state_difference(state, end.orbit.state, periodic))
        if max(in_parameter, in_state) <= 2 * OF_EQUILIBRIA.shortest_step:
            return True
    for one, other in pairwise(line):
        near = (
            magnitude(state_difference(state, one.orbit.state, periodic))
            < 2 * OF_EQUILIBRIA.longest_step
        )
        contains = (one.value - point.value) * (other.value - point.value) <= 0
        if near and contains and one.value != other.value:
            with suppress(ConvergenceError):
                chord = other.coordinates - one.coordinates
                on_branch = placed(one, point.value, chord).orbit.state
                if magnitude(state_difference(state, on_branch, periodic)) < 1e-7:
                    return True
    return False


def _seeds(p: ParameterSet, vary: str, to: Span) -> list[tuple[Touching, Equilibria]]:
    """All equilibria at 13 values of the parameter, for every combination of touching contacts."""
    grid = p.replace(**{vary: np.linspace(*to, 13)})
    return [
        (contact, equilibria(grid, contact=contact, method="search")) for contact in p.model.regimes
    ]


def _scales_of_all(p: ParameterSet, seeds: Sequence[tuple[Touching, Equilibria]]) -> MotionScales:
    """Units of the motion at rest at the largest absolute value of each coordinate."""
    names = p.model.coordinates
    largest = [
        max((magnitude([0.0, *eq.coordinates[name][eq.states]]) for _, eq in seeds), default=0.0)
        for name in names
    ]
    return System.of(p, None).scales(np.array([*largest, *np.zeros(len(names))]))


def _equilibria(
    p: ParameterSet,
    vary: str,
    to: Span,
    seeds: Sequence[tuple[Touching, Equilibria]],
    remarks: list[str],
) -> Iterator[tuple[EquilibriumBranch, list[Label]]]:
    """All branches of equilibria through the seeds, with their labels; states that friction holds
    are remarks.
    """
    model, found = p.model, list[tuple[Touching, list[BranchPoint]]]()
    held = set[float]()
    index, span = model.parameters.index(vary), (to[1] - to[0]) / 2
    scales = _scales_of_all(p.replace(**{vary: sum(to) / 2}), seeds)
    for contact, eq in seeds:
        grid = np.asarray(eq.parameters[vary])
        places = np.stack([*eq.coordinates.values()], axis=-1)
        for i, j in np.transpose(eq.states).tolist():
            system = System.of(p.replace(**{vary: float(grid[i])}), None)
            try:
                state = system.equilibrium(places[i, j])
            except ConvergenceError:
                continue
            if system.field.friction_holds(state.tolist(), system.constants):
                held.add(float(grid[i]))
                continue
            own = system.scaled(scales)
            rest = FixedPoints(own.field, system.field.exact(system.mode(state)))
            point = rest.started(own, state / scales.states, index, span)
            if any(touching == contact and _passes(line, point) for touching, line in found):
                continue
            backward, forward = (
                list(_followed(rest, point.oriented(sign), to)) for sign in (-1.0, 1.0)
            )
            line = [*(each.oriented(-1.0) for each in reversed(backward)), point, *forward]
            states = np.array([each.orbit.state[: len(model.coordinates)] for each in line])
            growth = [max(value.real for value in rest.eigenvalues(each)) for each in line]
            branch = EquilibriumBranch(
                np.array([each.value for each in line]),
                states * scales.places,
                np.array(growth) <= GROWS,
                "contact" if contact is True else model.regimes[contact],
            )
            yield branch, list(_labels(rest, line, len(found)))
            found.append((contact, line))
    if held:
        ends = tuple(sorted({min(held), max(held)}))
        text = "friction on a belt at rest holds whole sets of states for {}, which are no branches"
        remarks.append(Remark(text, At(vary, ends)))


def _cycles(
    p: ParameterSet,
    vary: str,
    onsets: Onsets | None,
    born_at: FloatArray,
    starts: Sequence[Any],
    remarks: list[str],
) -> Iterator[Cycle]:
    """A cycle from each Hopf point and from each start; failures become remarks."""
    for i, value in enumerate(born_at.tolist()):
        try:
            yield cycle(onset=onsets, index=i)
        except SpragsymError as error:
            remarks.append(
                Remark("no cycle was found at the Hopf point {}: {}", _at(vary, value), error)
            )
    for start in starts:
        try:
            yield start if isinstance(start, Cycle) else cycle(p, start)
        except ConvergenceError as error:
            remarks.append(f"no cycle was found from {start}: {error}")


def _is_known_cycle(branches: Sequence[CycleBranch], cycle: Cycle) -> bool:
    """True if a cycle is on one of the branches, compared with the branch's cycle at the same value
    of the parameter.
    """
    for branch in branches:
        value = cycle.parameters[branch.vary]
        contains = (branch.values[:-1] - value) * (branch.values[1:] - value) <= 0
        for i in np.flatnonzero(contains).tolist():
            with suppress(ConvergenceError):
                system = System(cycle.orbit.flow, cycle.values)
                if same_cycle(cycle_near(system, branch.cycles[i]), cycle):
                    return True
    return False


def _doubled(
    branches: list[CycleBranch], vary: str, to: Span, depth: int, points: int, remarks: list[str]
) -> None:
    """Append branches of doubled cycles from all period doublings, then from those of the new
    branches, ``depth`` times.
    """
    begin = 0
    for _ in range(depth):
        latest, begin = branches[begin:], len(branches)
        for branch in latest:
            for event in branch.of("period_doubling"):
                try:
                    doubled = branch.switch(event)
                    if not to[0] <= doubled.parameters[vary] <= to[1]:
                        continue
                    if _is_known_cycle(branches[begin:], doubled):
                        continue
                    branches.append(cycle_branch(doubled, vary, between={vary: to}, points=points))
                except SpragsymError as error:
                    at = _at(vary, event.value)
                    remarks.append(Remark("the doubled cycle at {} was not found: {}", at, error))


def _of_cycles(branches: Sequence[CycleBranch]) -> Iterator[Label]:
    """Labels of the events on branches of cycles."""
    labels = {
        "fold": "LPC",
        "period_doubling": "PD",
        "torus": "NS",
        "grazing": "GR",
        "homoclinic": "HC",
        "catastrophic-sliding": "CT",
        BRANCH_POINT: "BPC",
        **dict(zip(SLIDING, ("GS", "CS", "SS", "AS"), strict=True)),
    }
    for number, branch in enumerate(branches):
        for event in branch.events:
            if event.kind in labels:
                x = float(event.cycle.state[0])
                yield Label(labels[event.kind], event.value, x, "cycles", number)
