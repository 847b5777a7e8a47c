"""Probability that the followed state ends within tolerances, for any model: sampled, and with
proved bounds.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, fields, replace
from functools import partial
from typing import Any, Protocol, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike

from ..core.error_states import in_usual_state
from ..core.errors import ConvergenceError, ParameterError, ParameterTypeError, one_of, require_kind
from ..core.progress import advance
from ..core.questions import Method, model_of
from ..display import Table
from ..models import Model
from ..models.load import USUAL, load
from ..models.parameters import ParameterSet, Range, Span, as_count, as_number
from ..models.quantities import Quantities, QuantityValues, quantities
from ..motion.sweeps import workers as processes
from ..motion.sweeps.workers import Workers
from ..numerics.columns import selected_rows
from ..numerics.interval_arrays import FloatArray
from ..results import Result
from .jumps import limit_point_passed
from .proved_jumps import ProvedJumps, proved_jumps
from .sampling import Chunk, Correlation, Dependence, chunks, dependence, sums
from .tube_certificates import Pieces, Splitting

#: Quantities by name, each a number, a uniform range or a frozen distribution of SciPy; or two
#: corners of a box.
Distribution: TypeAlias = (
    Mapping[str, Any] | tuple[ParameterSet, ParameterSet] | tuple[QuantityValues, QuantityValues]
)


class Quantiles(Protocol):
    """A distribution given by its quantile function."""

    def ppf(self, share: ArrayLike, /) -> FloatArray:
        """Quantiles of one share or of an array of shares."""


#: An event at many points: from arrays of quantities by name, 1 or 0, or NaN where undecided.
Event: TypeAlias = Callable[[dict[str, Any]], FloatArray]


#: With at least so many points, proved parts of the box are computed first.
MANY = 1 << 12


@dataclass(frozen=True)
class JumpProbability(Result):
    """The probability that the followed state jumps as the loading parameter rises to its value.

    Attributes
    ----------
    probability, low, high : float
        The estimate and its confidence interval.
    confidence : float
        Confidence level of the interval.
    n : int
        Number of sample points.
    undecided : float
        Share of the points without an answer, which widens the interval.
    first, total : dict of str to float
        Sobol' indices of the event "it jumps", for each quantity that varies or each group of
        correlated ones: the share of the variance by it alone, and by it together with all its
        interactions. NaN if all points jump or none does; empty if not asked for.
    first_error, total_error : dict of str to float
        Half-widths of their confidence intervals.
    proved : tuple of float
        Proved bounds of the probability: that of the parts of the box where the state is proved to
        jump, and one minus that of the parts where it is proved not to. (0, 1) without a proof.
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

    def _shown(self) -> dict[str, Any]:
        indices = ("first", "first_error", "total", "total_error")
        ends = dict(zip(("proved_low", "proved_high"), self.proved, strict=True))
        held = {each.name: getattr(self, each.name) for each in fields(self)}
        numbers = {name: one for name, one in held.items() if name not in (*indices, "proved")}
        by_name = {f"{index}_{name}": one for index in indices for name, one in held[index].items()}
        return numbers | ends | by_name

    @property
    def sobol(self) -> dict[str, tuple[float, float, float]]:
        """For each quantity the first-order index, the total index and its half-width, sorted by
        falling total index.
        """
        names = sorted(self.total, key=lambda name: -np.nan_to_num(self.total[name]))
        return {
            name: (self.first[name], self.total[name], self.total_error[name]) for name in names
        }

    def as_table(self) -> Table:
        """The probability on the line above, and the indices.

        Returns
        -------
        Table
            Title, header and rows of text.

        Examples
        --------
        >>> indices = {"k": 0.25}, {"k": 0.75}, {"k": 0.01}, {"k": 0.02}
        >>> found = JumpProbability(0.1, 0.09, 0.11, 0.95, 4096, 0.0, *indices)
        >>> found.as_table().rows
        (('of k', '0.2500', '0.0100', '0.7500', '0.0200'),)
        """
        columns = (self.first, self.first_error, self.total, self.total_error)
        rows = tuple(
            (f"of {name}", *(f"{column[name]:.4f}" for column in columns)) for name in self.first
        )
        ends = f"{self.low:.4g} to {self.high:.4g} with confidence {self.confidence:.4g}"
        low, high = math.floor(1e4 * self.proved[0]) / 1e4, math.ceil(1e4 * self.proved[1]) / 1e4
        proved = f", proved {low:g} to {high:g}" if self.proved != (0.0, 1.0) else ""
        header = ("", "first order", "±", "total", "±") if rows else ()
        return Table(
            f"JumpProbability {self.probability:.4g}, {ends}, n = {self.n}{proved}", header, rows
        )


@dataclass(frozen=True)
class Sampling:
    """Options of the sampling, as arguments of :func:`jump_probability`."""

    correlation: Correlation | None
    n: int
    rng: int | np.random.Generator | None
    replicates: int
    confidence: float = 0.95
    sobol: bool = True
    workers: Workers = 1
    progress: bool = False


def estimated(variables: Mapping[str, Any], event: Event, sampling: Sampling) -> JumpProbability:
    """The probability of an event, by quasi-Monte Carlo."""
    varied = tuple(name for name, one in variables.items() if not isinstance(one, float))
    if not varied:
        raise ParameterError(
            "no quantity of distribution varies; give a range or a distribution for one, or "
            "use jump_value"
        )
    together, rng = dependence(varied, sampling.correlation), sampling.rng
    n = as_count("n", sampling.n, 2, 2**40)
    replicates = as_count("replicates", sampling.replicates, 2, 2**16)
    confidence = as_number("confidence", sampling.confidence)
    if not 0 < confidence < 1:
        raise ParameterError(
            f"confidence = {confidence!r} is not between 0 and 1; give 0.95 for 95 %"
        )
    whole = isinstance(rng, int | np.integer) and not isinstance(rng, bool)
    if rng is not None and not isinstance(rng, np.random.Generator) and not (whole and rng >= 0):
        raise ParameterError(
            f"rng = {rng!r:.60} is no seed; give an integer of 0 or more, a "
            "numpy.random.Generator, or leave it out"
        )
    seeds = np.random.default_rng(rng).integers(0, 2**63 - 1, replicates).tolist()
    parts = chunks(n, seeds)
    work = partial(
        sums, partial(_at_points, variables, together, event), [*together.factors], sampling.sobol
    )
    # A single process asks for several chunks at once, up to so many points.
    most_points = 2**16
    most = max(1, most_points // parts[0].size) if sampling.workers == 1 else 1
    tasks = [parts[first : first + most] for first in range(0, len(parts), most)]
    done: dict[int, list[list[float]]] = {}
    results = processes.results(sampling.workers, work, dict(enumerate(tasks)), _chunk_text)
    with advance(sampling.progress, len(tasks), 0) as step, closing(results):
        for i, records in results:
            done[i] = records
            step()
    every = [one for i in range(len(tasks)) for one in done[i]]
    titles = together.titles if sampling.sobol else ()
    return estimate(every, [part.replicate for part in parts], confidence, titles)


def estimate(
    records: Sequence[Sequence[float]],
    replicate: Sequence[int],
    confidence: float,
    titles: Sequence[str],
) -> JumpProbability:
    """The result from the sums of all chunks, of a function that is 0 or 1.

    ``replicate`` is the number of the replicate of each chunk, and ``titles`` names the indices.

    Source: the replicates are independent means of one distribution, and Student's interval follows
    from their spread; first-order indices by Saltelli et al. (2010), total ones by Jansen (1999).
    """
    from scipy.stats import binomtest
    from scipy.stats import t as student

    number = max(replicate) + 1
    table = np.zeros((number, len(records[0])))
    np.add.at(table, np.asarray(replicate), np.asarray(records))
    count, unknown, added, squares = table[:, :4].T
    means = added / count
    mean, n = float(added.sum() / count.sum()), float(count.sum())
    quantile = float(student.ppf(0.5 + confidence / 2, number - 1))
    half = quantile * float(means.std(ddof=1)) / number**0.5
    # Replicates may agree exactly, as with one variable: at least the interval of no event in n
    # points remains.
    half = math.hypot(half, math.log(2 / (1 - confidence)) / n)
    low, high = mean - half, mean + half
    hits, missing = float(added.sum()), float(unknown.sum() / n)
    if min(hits, n - hits) < 50:
        # Too few for normally distributed means. Independent points, which spread no less, have a
        # binomial interval.
        low, high = binomtest(int(hits), int(n), 0.5).proportion_ci(confidence, "exact")
    low, high = max(low, 0.0), min(high + missing, 1.0)  # an undecided point may jump
    variances = (squares - 2 * mean * added + mean * mean * count) / count
    alone, alone_error = _index(2 * table[:, 4::2] / count[:, None], variances, quantile)
    whole, whole_error = _index(table[:, 5::2] / count[:, None], variances, quantile)
    first, total, first_error, total_error = (
        dict(zip(titles, part.tolist(), strict=True))
        for part in (alone, whole, alone_error, whole_error)
    )
    return JumpProbability(
        mean, low, high, confidence, int(n), missing, first, total, first_error, total_error
    )


def _index(
    values: FloatArray, variances: FloatArray, quantile: float
) -> tuple[FloatArray, FloatArray]:
    """A ratio to the variance, with the half-width of its interval from the spread over the
    replicates (linearized).
    """
    with np.errstate(invalid="ignore", divide="ignore"):
        variance = variances.mean()
        ratio = values.mean(axis=0) / variance
        spread = (values - ratio * variances[:, None]).std(axis=0, ddof=1) / variance
    return ratio, quantile * spread / len(values) ** 0.5


# ------------------------------------------------------------------------------------------------
# variables


def variable(name: str, given: Any, allowed: Range) -> float | Quantiles:
    """A quantity as a float or a distribution with ``ppf``, checked against its allowed range."""
    if hasattr(given, "ppf"):
        low, high = float(given.ppf(0.0)), float(given.ppf(1.0))
        if low < allowed.low or not high <= allowed.high:
            reached = f"the distribution of {name} reaches {low if low < allowed.low else high:g}"
            raise ParameterError(
                f"{reached}, and {name} must be in {allowed}; truncate it, as by "
                "scipy.stats.truncnorm"
            )
        return given
    if isinstance(given, Sequence) and not isinstance(given, str):
        if len(given) != 2:
            raise ParameterError(
                f"{name} has {len(given)} numbers in distribution; a range has two, low and high"
            )
        low, high = (as_number(f"{name}[{i}]", value, allowed) for i, value in enumerate(given))
        if low > high:
            raise ParameterError(
                f"{name} = ({low:g}, {high:g}) goes down; give the smaller end first"
            )
        from scipy.stats import uniform

        return uniform(low, high - low) if low < high else low
    return as_number(name, given, allowed)


def _at_points(
    variables: Mapping[str, Any], together: Dependence, event: Event, points: FloatArray
) -> FloatArray:
    """The event at points of the unit cube, shape (points, variables)."""
    shares = iter(together.shares(points).T)
    return event(
        {
            name: np.full(len(points), one) if isinstance(one, float) else one.ppf(next(shares))
            for name, one in variables.items()
        }
    )


def _chunk_text(task: Sequence[Chunk]) -> str:
    """The points of a task, for the report of progress."""
    first, last = task[0], task[-1]
    to = f"{last.begin + last.size} of replicate {last.replicate}"
    between = "" if last.replicate == first.replicate else f" of replicate {first.replicate}"
    return f"points {first.begin}{between} to {to}"


#: A cumulative distribution function.
Shares: TypeAlias = Callable[[FloatArray], Any]


@in_usual_state
def jump_probability(
    distribution: Distribution,
    *,
    model: Model | str | None = None,
    vary: str | None = None,
    begin: float | None = None,
    max_boxes: int = 0,
    correlation: Correlation | None = None,
    n: int = 1 << 16,
    rng: int | np.random.Generator | None = None,
    confidence: float = 0.95,
    sobol: bool = True,
    replicates: int = 16,
    workers: Workers = 1,
    progress: bool = False,
    method: Method = "auto",
) -> JumpProbability:
    """The probability that the followed state ends as the loading parameter rises to its value.

    Estimated by quasi-Monte Carlo, with a confidence interval and Sobol' indices, and optionally
    with proved bounds.

    Parameters
    ----------
    distribution : mapping, or two corners of a box
        For each parameter by name, or for each quantity of a brake on which its states depend, as
        k, k_c and L_0: a number, a range ``(low, high)`` of uniform probability, or a frozen
        distribution of ``scipy.stats``. Parameters that are missing have their base values. With
        quantities of the friction law too, as V and d of the article's model, friction is that at
        the speed of the belt. Two :class:`~spragsym.Parameters` or
        :class:`~spragsym.PhysicalParameters` are the corners of a box.
    model : Model or str, optional
        The model to which the names of a mapping belong; by default the article's.
    vary, begin : str and float, optional
        The parameter that rises to its value, by default mu0, and the value from which it rises, by
        default the lower end of its range.
    max_boxes : int
        Most parts of the box to decide for ``proved``; with 0 nothing is proved.
    correlation : mapping of pairs of names to float, optional
        Correlations of the normal scores behind the distributions (a Gaussian copula); for normal
        distributions they are those of the quantities. With ±1 one quantity determines the other.
        Pairs that are not named are independent.
    n : int
        Number of points, rounded up to a power of two in each replicate. Without closed forms a
        point takes up to a millisecond; from 4,096 on, most are decided by proved parts of the box.
    rng : int or numpy.random.Generator, optional
        Source of randomness; an int gives the same points each time.
    confidence : float
        Confidence level of the intervals.
    sobol : bool
        Also estimate Sobol' indices, at the cost of half as many evaluations more for each quantity
        that varies.
    replicates : int
        Number of independent scramblings, from whose spread the intervals follow.
    workers : int or map-like callable
        Number of processes, −1 for one on each core; or ``map(function, chunks)`` of an engine,
        such as a dask client's. The result is the same.
    progress : bool
        Show a bar on stderr.
    method : {"auto", "closed", "search"}
        Whether closed forms may decide a point, must, or must not.

    Returns
    -------
    JumpProbability

    Raises
    ------
    ParameterError
        For missing or unknown quantities, and distributions that reach out of a range.

    Notes
    -----
    Source: the event is an end of the state up to the value of the loading parameter. Intervals are
    by Student's distribution over the replicates, or by Clopper and Pearson if fewer than 50 points
    jump or fewer than 50 do not; that one is nominal, since it takes the points as independent
    draws, and Sobol' points are not. Proved bounds: tubes around curves of states over parts of the
    box, see :mod:`spragsym.bifurcation.tubes`; the probability of a part is the product of those of
    its sides.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> base = ss.Parameters.article(theta0=np.radians(40.0), mu0=0.55)
    >>> box = base.replace(mu0=0.5, sigma=0.09), base.replace(mu0=0.65, sigma=0.11)
    >>> found = ss.jump_probability(box, n=4096, rng=1)
    >>> round(found.probability, 2), found.high - found.low < 0.01
    (0.39, True)
    >>> max(found.total, key=found.total.get)
    'mu0'
    >>> asked = {"theta0": 1.0, "mu0": (0.2, 0.4)}
    >>> few = {"n": 64, "rng": 1, "replicates": 2, "max_boxes": 64}
    >>> found = ss.jump_probability(asked, model="inclined_belt", **few)
    >>> found.low < found.proved[0] < found.proved[1] < found.high
    True
    >>> found.proved[1] - found.proved[0] < 0.01
    True
    """
    one_of("method", method, get_args(Method))
    require_kind("distribution", distribution, (tuple, Mapping), "values and ranges by name")
    if isinstance(distribution, tuple):
        subject, in_si = model_of(distribution), isinstance(distribution[0], QuantityValues)
    else:
        subject = model if isinstance(model, Model) else load(model or USUAL)
        in_si = not {*distribution}.isdisjoint(
            {*quantities(subject.where).units} - {*subject.parameters}
        )
    subject.require_answered("jump_probability")
    if not isinstance(sobol, bool | np.bool_):
        raise ParameterTypeError(f"sobol = {sobol!r:.60} is neither True nor False; give one")
    n = as_count("n", n, 2)
    subject = subject.search if method == "search" else subject
    kind = quantities(subject.where) if in_si else None
    variables = _variables(subject, kind, distribution)
    vary, begin = subject.rising(vary, None if begin is None else as_number("begin", begin))
    event = _JumpEvent(subject, kind, vary, begin, method)
    if max_boxes and (correlation or kind):
        said = "quantities in SI" if kind else "correlation"
        raise ParameterError(
            f"{said}: a bracket is proved for independent parameters of the model only; leave "
            "max_boxes out"
        )
    if kind is None and n >= MANY and subject.closed_form("limit_point_passed") is None:
        event = replace(event, proved=_proved(subject, variables, vary, begin))
    sampling = Sampling(correlation, n, rng, replicates, confidence, sobol, workers, progress)
    found = estimated(variables, event, sampling)
    if not max_boxes:
        return found
    proved = measured(*_split(subject, variables, vary, begin), max_boxes)
    return replace(found, proved=proved)


def _split(
    model: Model, variables: dict[str, Any], vary: str, begin: float
) -> tuple[Splitting, OpenShare]:
    """A box that holds all points up to tails of unbounded distributions, and the probability of
    its open parts.
    """
    laws = {name: one for name, one in variables.items() if not isinstance(one, float)}
    ends = ({name: _end(one, share) for name, one in laws.items()} for share in (0.0, 1.0))
    low, high = (model.Parameters(**variables | end) for end in ends)
    box, goal = Splitting(low, high, vary, begin), float(high[vary])
    shares: dict[str, Shares] = {name: law.cdf for name, law in laws.items()}
    up_to = shares.get(vary, lambda value: 1.0 * (value >= goal))
    return box, OpenShare(box.free, shares, (up_to, up_to))


def _proved(model: Model, variables: dict[str, Any], vary: str, begin: float) -> ProvedJumps | None:
    """Proved parts of the box of the variables, or None."""
    try:
        return proved_jumps(*_split(model, variables, vary, begin), Pieces.few)
    except (ConvergenceError, ParameterError):  # the points themselves may still be decided
        return None


@dataclass(frozen=True)
class OpenShare:
    """The probability of what is undecided in parts of a box.

    ``laws`` are the distribution functions of the ``free`` sides, and ``up_to`` lower and upper
    bounds of that of the moving parameter.
    """

    free: Sequence[str]
    laws: Mapping[str, Shares]
    up_to: tuple[Shares, Shares]

    def __call__(self, pieces: Pieces) -> FloatArray:
        """The undecided probability of each part."""
        return self.of_free(pieces) * (self.up_to[1](pieces.top) - self.up_to[0](pieces.safe))

    def of_free(self, pieces: Pieces) -> FloatArray:
        """The probability of the free sides of each part."""
        sides = zip(self.free, pieces.low[:-1], pieces.high[:-1], strict=True)
        parts = [self.laws[name](high) - self.laws[name](low) for name, low, high in sides]
        return np.prod([np.ones(len(pieces)), *parts], axis=0)


def measured(box: Splitting, share: OpenShare, max_boxes: int) -> Span:
    """The probability of what is proved to end, and one minus that of what is proved not to."""
    least, most = 0.0, 1.0
    box.sharp = True
    for pieces, last, _ in box.run(share, max_boxes):
        done = pieces[last]
        of_free = share.of_free(done)
        least += float((of_free * (1.0 - share.up_to[1](done.top))).sum())
        most -= float((of_free * share.up_to[0](done.safe)).sum())
    rounding = 1e-12  # more than the rounding of all sums
    return max(0.0, least - rounding), min(1.0, most + rounding)


def _end(law: Quantiles, share: float) -> float:
    """An end of a distribution; if it is infinite, that of a tail which the proof leaves
    undecided.
    """
    end = float(law.ppf(share))
    tail = 1e-9  # probability of the tail
    return end if np.isfinite(end) else float(law.ppf(tail if share == 0 else 1 - tail))


def _variables(model: Model, kind: Quantities | None, distribution: Distribution) -> dict[str, Any]:
    """Each parameter, or each quantity of ``kind``, as a float or a distribution with ``ppf``."""
    names: Sequence[str] = kind.of_statics if kind else model.parameters
    given: dict[str, Any]
    if isinstance(distribution, tuple):
        low, high, *more = distribution
        if more or type(low) is not type(high):
            raise ParameterError(
                "distribution: the corners of a box are two Parameters or two PhysicalParameters"
            )
        given = {name: (low[name], high[name]) for name in names}
    else:
        given = dict(distribution)
    if kind:
        names = (*names, *kind.of_the_law) if set(given) & set(kind.of_the_law) else names
        ranges: Mapping[str, Range] = {name: kind.ranges()[name] for name in names}
    else:
        given, ranges = {**model.base, **given}, model.Parameters.ranges
    for name in given:
        if name not in ranges:
            what = "a quantity here" if kind else f"a parameter of {model.name}"
            raise ParameterError(
                f"{name!r} in distribution is not {what}; there are {', '.join(ranges)}"
            )
    missing = [name for name in ranges if name not in given]
    if missing:
        raise ParameterError(
            f"distribution has nothing for {', '.join(missing)}; give a number where nothing varies"
        )
    return {name: variable(name, given[name], allowed) for name, allowed in ranges.items()}


@dataclass(frozen=True)
class _JumpEvent:
    """The event that the followed state ends as ``vary`` rises from ``begin`` to its value.

    ``kind`` has the quantities that replace the model's parameters, and ``proved`` parts of the
    box.
    """

    model: Model
    kind: Quantities | None
    vary: str
    begin: float
    method: Method
    proved: ProvedJumps | None = None

    def __call__(self, values: Mapping[str, Any]) -> FloatArray:
        """1 where the state ends, 0 where it does not, NaN where that is unknown; proved parts
        decide first, then points one by one.
        """
        model, kind = self.model, self.kind
        # Neither states nor friction depend on units that are missing, as the mass: any value does.
        units = {} if kind is None else dict.fromkeys(kind.bases, 1.0)
        p = model.Parameters(**(values if kind is None else kind.groups({**units, **values})))
        if kind is not None and {*kind.of_the_law} & {*values}:
            p = p.replace(**{str(model.coefficient): model.friction(p)})
        if self.proved is None:
            return self._passed(p)
        ended = self.proved.ended(p)
        open_ = np.isnan(ended)
        if open_.any():
            ended[open_] = self._passed(model.Parameters(**selected_rows(values, open_)))
        return ended

    def _passed(self, p: ParameterSet) -> FloatArray:
        """The event at each point.

        If none of the first 64 points is decided, the others are not tried: an undecided point
        takes as long as many decided ones.
        """
        columns = dict(zip(p.ranges, p.broadcast(*p.ranges), strict=True))

        def passed(rows: slice) -> FloatArray:
            own = p.model.Parameters(**selected_rows(columns, rows))
            return limit_point_passed(own, self.vary, self.begin, method=self.method)

        few = 64
        first = passed(slice(few))
        if np.isnan(first).all():
            return np.full(p.shape, np.nan)
        return np.concatenate([first, passed(slice(few, None))])
