"""Probability of a jump when parameters are known within tolerances, and the sensitivity to each."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from typing import Any, TypeAlias

import numpy as np

from ..display import Table
from ..errors import ParameterError
from ..models.parameters import FloatArray, Parameters, PhysicalParameters, Range, as_count, as_number
from ..motion.sweeps import workers as processes
from ..motion.sweeps.workers import Workers
from ..progress import advance
from ..results.result import Result
from . import sampling
from .dependence import Correlation, Dependence, dependence

#: Variables by name: a number, a range of equal probability, or a frozen distribution of SciPy; or corners of a box.
Distribution: TypeAlias = Mapping[str, Any] | tuple[Parameters, Parameters] | tuple[PhysicalParameters, PhysicalParameters]

#: What may happen at many points: quantities by name → 1 or 0, or NaN where that is unknown.
Event: TypeAlias = Callable[[dict[str, Any]], FloatArray]

#: Points by default, of which the indices take as many again for every two variables.
POINTS = 1 << 16


@dataclass(frozen=True)
class JumpProbability(Result):
    """The probability that the reference state jumps as the friction, or another parameter, rises to its value.

    Attributes
    ----------
    probability, low, high : float
        The estimate and its interval.
    confidence : float
        Of the interval.
    n : int
        Points that it was estimated from.
    undecided : float
        Share of the points without an answer, which the interval takes in.
    first, total : dict of str to float
        Sobol' indices of every quantity that varies, or of several that are correlated, together: the share of the variance of
        "it jumps" that goes with it alone, and with it and all that it does together with others. NaN where everything jumps,
        or nothing, and empty if not asked for.
    first_error, total_error : dict of str to float
        Half-widths of their intervals.
    proved : tuple of float
        Bracket of the probability by proof, not by samples: the probability of what is proved to jump, and one minus that of what
        is proved not to; (0, 1) where nothing was asked to be proved.
    """

    probability: float
    low: float
    high: float
    confidence: float
    n: int
    undecided: float
    first: Mapping[str, float]
    total: Mapping[str, float]
    first_error: Mapping[str, float]
    total_error: Mapping[str, float]
    proved: tuple[float, float] = (0.0, 1.0)

    @property
    def sobol(self) -> dict[str, tuple[float, float, float]]:
        """Of each quantity the index of first order, the total one and its half-width; that with the largest total first."""
        names = sorted(self.total, key=lambda name: -np.nan_to_num(self.total[name]))
        return {name: (self.first[name], self.total[name], self.total_error[name]) for name in names}

    def as_table(self) -> Table:
        """The probability on the line above, and the indices."""
        columns = (self.first, self.first_error, self.total, self.total_error)
        rows = tuple((f"of {name}", *(f"{column[name]:.4f}" for column in columns)) for name in self.first)
        return probability_table("JumpProbability", self, ("", "first order", "±", "total", "±"), rows)


def probability_table(name: str, found: Any, header: tuple[str, ...], rows: tuple[tuple[str, ...], ...]) -> Table:
    """A probability with its interval and its proved bounds on the line above a table of its indices."""
    ends = f"{found.low:.4g} to {found.high:.4g} with confidence {found.confidence:.4g}"
    low, high = math.floor(1e4 * found.proved[0]) / 1e4, math.ceil(1e4 * found.proved[1]) / 1e4
    proved = f", proved {low:g} to {high:g}" if found.proved != (0.0, 1.0) else ""
    return Table(f"{name} {found.probability:.4g}, {ends}, n = {found.n}{proved}", header if rows else (), rows)


def estimated(
    variables: Mapping[str, Any],
    event: Event,
    *,
    correlation: Correlation | None,
    n: int,
    rng: int | np.random.Generator | None,
    confidence: float,
    sobol: bool,
    replicates: int,
    workers: Workers,
    progress: bool,
) -> JumpProbability:
    """The probability of any event, 1 or 0 of many points or NaN."""
    varied = tuple(name for name, one in variables.items() if not isinstance(one, float))
    if not varied:
        raise ParameterError("no quantity of distribution varies; give a range or a distribution for one, or use jump_value")
    together = dependence(varied, correlation)
    as_count("n", n, 2)
    as_count("replicates", replicates, 2)
    if not 0 < confidence < 1:
        raise ParameterError(f"confidence = {confidence!r} is not between 0 and 1; give 0.95 for 95 %")
    if isinstance(rng, int | np.integer) and (rng < 0 or isinstance(rng, bool)):
        raise ParameterError(f"rng = {rng!r} is no seed; give an integer of 0 or more, a numpy.random.Generator, or leave it out")
    seeds = np.random.default_rng(rng).integers(0, 2**63 - 1, replicates).tolist()
    tasks = sampling.chunks(n, replicates, seeds)
    work = partial(sampling.sums, partial(_at_points, variables, together, event), together.groups, sobol)
    done: dict[int, list[float]] = {}
    results = processes.results(workers, work, dict(enumerate(tasks)), _told)
    with advance(progress, len(tasks), 0) as step, closing(results):
        for i, sums in results:
            done[i] = sums
            step()
    found = sampling.estimate([done[i] for i in range(len(tasks))], [task.replicate for task in tasks], confidence, True)
    first, total, first_error, total_error = (
        dict(zip(together.titles, part.tolist(), strict=True)) if sobol else {}
        for part in (found.first, found.total, found.first_error, found.total_error)
    )
    return JumpProbability(
        found.mean, found.low, found.high, confidence, found.n, found.undecided, first, total, first_error, total_error
    )


# ------------------------------------------------------------------------------------------------------ variables


def sides(low: Any, high: Any, names: Iterable[str]) -> dict[str, Any]:
    """A box from two corners: a number where they agree, else the ends of a range."""
    ends = ((name, as_number(name, getattr(low, name)), as_number(name, getattr(high, name))) for name in names)
    return {name: one if one == other else (one, other) for name, one, other in ends}


def checked(given: Mapping[str, Any], ranges: Mapping[str, Range], what: str) -> dict[str, Any]:
    """A variable for each quantity, where just these are given; ``what`` an unknown one is not, in an error."""
    for name in given:
        if name not in ranges:
            raise ParameterError(f"{name!r} in distribution is not {what}; there are {', '.join(ranges)}")
    missing = [name for name in ranges if name not in given]
    if missing:
        raise ParameterError(f"distribution has nothing for {', '.join(missing)}; give a number where nothing varies")
    return {name: variable(name, given[name], allowed) for name, allowed in ranges.items()}


def variable(name: str, given: Any, allowed: Range) -> Any:
    """A quantity as a float, or as something with a quantile function ``ppf``, within what is allowed."""
    if hasattr(given, "ppf"):
        _check_reach(name, float(given.ppf(0.0)), float(given.ppf(1.0)), allowed)
        return given
    if isinstance(given, Sequence) and not isinstance(given, str):
        if len(given) != 2:
            raise ParameterError(f"{name} has {len(given)} numbers in distribution; a range has two, low and high")
        low, high = (as_number(f"{name}[{i}]", value, allowed) for i, value in enumerate(given))
        if low > high:
            raise ParameterError(f"{name} = ({low:g}, {high:g}) goes down; give the smaller end first")
        from scipy.stats import uniform

        return uniform(low, high - low) if low < high else low
    return as_number(name, given, allowed)


def _check_reach(name: str, low: float, high: float, allowed: Range) -> None:
    below = low < allowed.low
    if below or not high <= allowed.high:
        end = f"{low:g}" if below else f"{high:g}"
        raise ParameterError(
            f"the distribution of {name} reaches {end}, and {name} must be in {allowed}; truncate it, as by scipy.stats.truncnorm"
        )


def _at_points(variables: Mapping[str, Any], together: Dependence, event: Event, points: FloatArray) -> FloatArray:
    """The event at points of the unit cube."""
    points = together.shares(points)
    values: dict[str, Any] = {}
    column = 0
    for name, one in variables.items():
        if isinstance(one, float):
            values[name] = np.full(len(points), one)
        else:
            values[name] = one.ppf(points[:, column])
            column += 1
    return event(values)


def _told(chunk: sampling.Chunk) -> str:
    return f"points {chunk.begin} to {chunk.begin + chunk.size} of replicate {chunk.replicate}"
