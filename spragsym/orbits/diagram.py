"""The bifurcation diagram of one parameter: equilibria and cycles of the motion in one result,
labelled as AUTO and MatCont do.

Equilibria are those of the motion, with friction at the belt's own speed: followed by
pseudo-arclength from all that the statics prove at some values of the parameter, so that a branch
is left out only if it begins and ends between two of these. Cycles are followed from every Hopf
point along the parameter, from starts that are given, and from period doublings; there may be
others.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import combinations, islice, pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..bifurcation.branches import joined, undecided_parts, undecided_points
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
from ..numerics.interval_arrays import BoolArray
from ..numerics.vectors import apart, magnitude
from ..results import Equilibria
from ..results.result import Result
from ..statics.equilibria import equilibria
from . import Cycle, CycleBranch, cycle, cycle_branch
from .arclength import BranchPoint, between, placed, steps, turning, within, zero_of
from .events import SLIDING
from .finding import cycle_near
from .options import BranchOptions
from .orbit import same_cycle
from .system import FixedPoints, System

#: Options of branches of equilibria, whose steps are in units of the motion and halves of the
#: range.
OF_EQUILIBRIA = BranchOptions(first_step=0.0025, longest_step=0.02, shortest_step=1e-7, kink=0.0)


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
        ``"contact"`` or ``"lift-off"``; of a contact that presses on either of two faces
        ``"opposite face"``; of several contacts which of them touch alone.
    """

    values: FloatArray
    states: FloatArray
    stable: BoolArray
    mode: str


@dataclass(frozen=True, eq=False)
class Label(Result):
    """A point of a diagram: LP fold, H Hopf point (of equilibria); LPC fold, PD doubling, NS torus,
    BPC crossing, GR grazing, HC; GS, CS, SS, AS grazing-, crossing-, switching- and adding-sliding;
    CT catastrophic-sliding.

    ``height`` is the first coordinate there, the largest one of a cycle; ``branch`` the number of
    the branch among its kind.
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
        """The points of all branches, one branch after the other: what they are ``of``, the number
        of the ``branch`` among its kind, the parameter, the lowest and highest first coordinate,
        the period (NaN of equilibria), and whether they are stable.

        Returns
        -------
        dict of str to array
            Columns of one length, a row a point.

        Examples
        --------
        >>> import spragsym as ss
        >>> model = ss.load("stick_slip")
        >>> found = ss.diagram(model.Parameters(), "V", between={"V": (0.05, 0.3)}, points=60)
        >>> sorted(set(found.data()["of"].tolist()))
        ['cycles', 'equilibria']
        """
        parts = [
            ("equilibria", at, one, one.states[:, 0], one.states[:, 0], 0 * one.values + np.nan)
            for at, one in enumerate(self.equilibria)
        ] + [
            ("cycles", at, one, one.lowest, one.highest, one.periods)
            for at, one in enumerate(self.cycles)
        ]
        if not parts:
            return {}
        kinds, at, branches, lowest, highest, periods = zip(*parts, strict=True)
        sizes = [one.values.size for one in branches]
        return {
            self._own("of"): np.repeat(kinds, sizes),
            self._own("branch"): np.repeat(at, sizes),
            self.vary: np.concatenate([one.values for one in branches]),
            self._own("lowest"): np.concatenate(lowest),
            self._own("highest"): np.concatenate(highest),
            self._own("period"): np.concatenate(periods),
            self._own("stable"): np.concatenate([one.stable for one in branches]),
        }


@in_usual_state
def diagram(
    p: ParameterSet,
    vary: str,
    *,
    between: Ranges,
    starts: Sequence[Any] = (),
    doublings: int = 1,
    points: int = 100,
) -> Diagram:
    """Equilibria and cycles of one parameter over a range.

    Parameters
    ----------
    p : ParameterSet
        Scalars; the one that varies is where ``starts`` hold.
    vary : str
        The parameter.
    between : mapping
        Its range, by its name.
    starts : sequence
        States near cycles at ``p``, or cycles of the model at ``p`` but for the parameter that
        varies; with ``None`` among them, what the motion from rest winds onto.
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
        For a parameter that the model does not have, a range that is none, or a cycle at other
        parameters.

    Notes
    -----
    Hopf points from which cycles are followed are those of
    :func:`spragsym.bifurcation.flutter.flutter_onsets`, proved; labels are located on the branches
    by their test functions.

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
    rests = list(_equilibria(p, vary, (low, high), seeds))
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
    # A Hopf point is located to this, in ranges of the parameter.
    remarks += _left_alone(vary, labels, born_at, 1e-6 * (high - low))
    spans = [undecided_points(eq, vary, (low, high)) for _, eq in seeds]
    undecided = joined(np.concatenate([undecided_parts(onsets, (low, high)), *spans]))
    remarks += [
        Remark("equilibria or Hopf points may be missing for {}", At(vary, (start, end)))
        for start, end in undecided.tolist()
    ]
    lines = tuple(branch for branch, _ in rests)
    return Diagram(
        vary,
        (low, high),
        lines,
        tuple(branches),
        tuple(labels),
        tuple(remarks),
        model.coordinates[0],
        model,
        tuple((start, end) for start, end in undecided.tolist()),
    )


def _left_alone(
    vary: str, labels: Sequence[Label], marked: FloatArray, near: float
) -> Iterator[str]:
    """Hopf points of the motion that are none of the statics', whose friction may be another: none
    is followed from there.
    """
    for value in (label.value for label in labels if label.label == "H"):
        if not (np.abs(marked - value) < near).any():
            yield Remark(
                "no cycles were followed from the Hopf point {}: it is the motion's, not the "
                "statics'",
                _at(vary, value),
            )


def _at(vary: str, value: float) -> At:
    return At(vary, (float(value),), ".10g")


# ------------------------------------------------------------------------------------------------
# equilibria


def _followed(rest: FixedPoints, point: BranchPoint, to: Span) -> Iterator[BranchPoint]:
    """Points ahead, to the end of the range, of the mode, or of the steps."""

    def ahead(point: BranchPoint, length: float) -> BranchPoint:
        found = within(point, length, to, reach=0.5)
        if not rest.inside(found):
            raise ConvergenceError("the mode ends")
        return found

    with suppress(ConvergenceError):
        # Most steps each way.
        for found in islice(steps(point, ahead, OF_EQUILIBRIA), 2000):
            if (
                found.coordinates != point.coordinates
            ).any():  # as it is where the range ends at the first point
                yield found
            if found.value in to:
                return


def _located(
    one: BranchPoint, other: BranchPoint, test: Callable[[BranchPoint], float]
) -> BranchPoint | None:
    """The point between two where a test function changes its sign; None if it does not."""
    first, last = test(one), test(other)
    # A test function below this has lost its sign: without dampers every pair is on the
    # imaginary axis.
    if (first < 0) == (last < 0) or min(abs(first), abs(last)) < 1e-11:
        return None
    with suppress(ConvergenceError, ValueError):
        return zero_of(test, one, other, between(one, other), xtol=1e-15)
    return None


def _labels(rest: FixedPoints, line: Sequence[BranchPoint], number: int) -> Iterator[Label]:
    """Folds, where the parameter turns back, and Hopf points, where a pair crosses the imaginary
    axis.
    """
    for one, other in pairwise(line):
        fold, hopf = (_located(one, other, test) for test in (turning, rest.pairs))
        if hopf is not None:
            total, pair = min(
                (abs(a + b), abs(a.imag)) for a, b in combinations(rest.eigenvalues(hopf), 2)
            )
            hopf = hopf if pair > 1e-6 > total else None
        for label, point in (("LP", fold), ("H", hopf)):
            if point is not None:
                x = float(natural(point.orbit).state[0])
                yield Label(label, point.value, x, "equilibria", number)


def _passes(line: Sequence[BranchPoint], point: BranchPoint) -> bool:
    """Whether a branch passes through a point."""
    state, periodic = point.orbit.state, point.orbit.field.periodic
    for end in (line[0], line[-1]):  # it ends within a step of a border, which the point may be on
        off = abs(end.value - point.value) / point.setting.spans[0]
        if (
            max(off, magnitude(apart(state, end.orbit.state, periodic)))
            <= 2 * OF_EQUILIBRIA.shortest_step
        ):
            return True
    for one, other in pairwise(line):
        near = magnitude(apart(state, one.orbit.state, periodic)) < 2 * OF_EQUILIBRIA.longest_step
        if (
            near
            and (one.value - point.value) * (other.value - point.value) <= 0
            and one.value != other.value
        ):
            with suppress(ConvergenceError):
                met = placed(one, point.value, other.coordinates - one.coordinates).orbit.state
                # Equilibria closer than this, in units of the motion, are one.
                if magnitude(apart(state, met, periodic)) < 1e-7:
                    return True
    return False


def _seeds(p: ParameterSet, vary: str, to: Span) -> list[tuple[Touching, Equilibria]]:
    """The equilibria at some values of the parameter, of every combination of contacts that
    touch.
    """
    # Values of the parameter at which the statics say where equilibria are.
    grid = p.replace(**{vary: np.linspace(*to, 13)})
    return [
        (contact, equilibria(grid, contact=contact, method="search")) for contact in p.model.regimes
    ]


def _scales_of_all(p: ParameterSet, seeds: Sequence[tuple[Touching, Equilibria]]) -> MotionScales:
    """Units of the motion at rest at the largest of all coordinates."""
    names = p.model.coordinates
    most = [
        max(
            (magnitude([0.0, *eq.coordinates[name][eq.states]]) for _, eq in seeds),
            default=0.0,
        )
        for name in names
    ]
    return System.of(p, None).scales(np.array([*most, *np.zeros(len(names))]))


def _equilibria(
    p: ParameterSet, vary: str, to: Span, seeds: Sequence[tuple[Touching, Equilibria]]
) -> Iterator[tuple[EquilibriumBranch, list[Label]]]:
    """All branches on which there is one of the equilibria known, with their labels."""
    model, found = p.model, list[tuple[Touching, list[BranchPoint]]]()
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
            own = system.scaled(scales)
            rest = FixedPoints(own.field, system.field.exact(system.mode(state)))
            point = rest.started(own, state / scales.states, index, span)
            if any(pushed == contact and _passes(line, point) for pushed, line in found):
                continue
            back, forth = (list(_followed(rest, point.oriented(sign), to)) for sign in (-1.0, 1.0))
            line = [*(each.oriented(-1.0) for each in reversed(back)), point, *forth]
            states = np.array([each.orbit.state[: len(model.coordinates)] for each in line])
            # Real parts below this are not growth.
            stable = np.array(
                [max(value.real for value in rest.eigenvalues(each)) < 1e-10 for each in line]
            )
            values = np.array([each.value for each in line])
            branch = EquilibriumBranch(
                values,
                states * scales.places,
                stable,
                "contact" if contact is True else model.regimes[contact],
            )
            yield branch, list(_labels(rest, line, len(found)))
            found.append((contact, line))


# ------------------------------------------------------------------------------------------------
# cycles


def _cycles(
    p: ParameterSet,
    vary: str,
    onsets: Onsets | None,
    born_at: FloatArray,
    starts: Sequence[Any],
    remarks: list[str],
) -> Iterator[Cycle]:
    """A cycle of each family that is known of: born at a Hopf point, or near a start."""
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
    """Whether a cycle is on a branch that is there: that branch's own cycle at the same value of
    the parameter is it.
    """
    for branch in branches:
        value = cycle.parameters[branch.vary]
        for i in np.flatnonzero(
            (branch.values[:-1] - value) * (branch.values[1:] - value) <= 0
        ).tolist():
            with suppress(ConvergenceError):
                if same_cycle(
                    cycle_near(System(cycle.orbit.flow, cycle.values), branch.cycles[i]), cycle
                ):
                    return True
    return False


def _doubled(
    branches: list[CycleBranch], vary: str, to: Span, depth: int, points: int, remarks: list[str]
) -> None:
    """Branches of doubled cycles, added to the others, so many doublings deep."""
    begin = 0
    for _ in range(depth):
        now, begin = branches[begin:], len(branches)
        for branch in now:
            for event in branch.of("period_doubling"):
                try:
                    doubled = branch.switch(event)
                    if to[0] <= doubled.parameters[vary] <= to[1] and not _is_known_cycle(
                        branches[begin:], doubled
                    ):
                        branches.append(
                            cycle_branch(doubled, vary, between={vary: to}, points=points)
                        )
                except SpragsymError as error:
                    remarks.append(
                        Remark(
                            "the doubled cycle at {} was not found: {}",
                            _at(vary, event.value),
                            error,
                        )
                    )


def _of_cycles(branches: Sequence[CycleBranch]) -> Iterator[Label]:
    # A label for each kind of event: as AUTO and MatCont have them.
    labels = {
        "fold": "LPC",
        "period_doubling": "PD",
        "torus": "NS",
        "grazing": "GR",
        "homoclinic": "HC",
        "catastrophic-sliding": "CT",
        "crossing": "BPC",
        **dict(zip(SLIDING, ("GS", "CS", "SS", "AS"), strict=True)),
    }
    for number, branch in enumerate(branches):
        for event in branch.events:
            kind = "crossing" if event.found.crossed is not None else event.kind
            if kind in labels:
                yield Label(
                    labels[kind], event.value, float(event.cycle.state[0]), "cycles", number
                )
