"""How probable it is that the followed state of any model ends, from tolerances: by samples, and between proved bounds."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from typing import Any, TypeAlias

import numpy as np

from ...design.dependence import Correlation
from ...design.probability import JumpProbability, checked, estimated, sides
from ...errors import ParameterError, ParameterTypeError
from ...exact.interval_arrays import FloatArray
from ...parameters import ParameterSet
from .certificates import ENDS, OPEN, POINTS, THIN, Pieces, Splitting

#: The share of a distribution up to some values.
Shares: TypeAlias = Callable[[FloatArray], Any]
#: Samples by default: each is followed.
SAMPLES = 1 << 12
#: Share of a distribution without an end that is left out of the proof on either side, and counts as not decided.
TAIL = 1e-9
#: What sums of shares are rounded outward by.
ROUNDING = 1e-12


def jump_probability(
    model: Any,
    distribution: Any,
    *,
    vary: str,
    begin: float,
    max_boxes: int = 0,
    correlation: Correlation | None = None,
    n: int = SAMPLES,
    rng: int | np.random.Generator | None = None,
    confidence: float = 0.95,
    sobol: bool = False,
    replicates: int = 16,
    workers: Any = 1,
    progress: bool = False,
    store: Any = None,
) -> JumpProbability:
    """The probability that the followed state ends before ``vary`` has risen to its value.

    Parameters
    ----------
    distribution : mapping, or two sets of parameters
        For parameters by name a number, a range ``(low, high)`` in which all values are as probable, or a frozen distribution of
        ``scipy.stats``; those that are left out have their base values. Two sets are the corners of a box.
    vary, begin
        As for :func:`spragsym.models.design.certificates.certify`: the parameter that rises, and from where.
    max_boxes : int
        Parts of the box to look at for ``proved``, which is (0, 1) without.
    correlation, n, rng, confidence, sobol, replicates, workers, progress, store
        As for :func:`spragsym.jump_probability`.

    Notes
    -----
    Source: tubes around curves of states, see :mod:`spragsym.models.tubes.tubes`, about each sample; and about parts of the box,
    whose probability is the product of that of their sides.
    """
    variables = _variables(model, distribution)
    model.require_parameter(vary)
    base = model.Parameters(**{name: one for name, one in variables.items() if isinstance(one, float)})
    event = partial(_ends, base, vary, begin)
    found = estimated(
        variables, event, of=f"{model.name}, {vary} from {begin!r}", correlation=correlation, n=n, rng=rng, confidence=confidence,
        sobol=sobol, replicates=replicates, workers=workers, progress=progress, store=store,
    )  # fmt: skip
    if not max_boxes:
        return found
    if correlation:
        raise ParameterError("correlation: a bracket is proved for independent parameters only; leave max_boxes out")
    return replace(found, proved=bracket(base, variables, vary, begin, max_boxes))


def bracket(base: Any, variables: Mapping[str, Any], vary: str, begin: float, max_boxes: int) -> tuple[float, float]:
    """Probability of what is proved to end, and one minus that of what is proved not to."""
    laws = {name: one for name, one in variables.items() if not isinstance(one, float)}
    ends = ({name: _end(one, share) for name, one in laws.items()} for share in (0.0, 1.0))
    low, high = (base.replace(**end) for end in ends)
    goal = float(getattr(high, vary))
    up_to = laws[vary].cdf if vary in laws else lambda value: 1.0 * (value >= goal)
    return measured(Splitting(low, high, vary, begin), {name: law.cdf for name, law in laws.items()}, (up_to, up_to), max_boxes)


def measured(box: Splitting, laws: Mapping[str, Shares], up_to: tuple[Shares, Shares], max_boxes: int) -> tuple[float, float]:
    """The bracket over a box; ``laws`` are shares up to a value of each side, and ``up_to`` bounds of those of what moves."""
    rows = [(place, laws[name]) for place, name in enumerate(box.free) if name in laws]

    def of_free(pieces: Pieces) -> FloatArray:
        parts = [law(pieces.high[place]) - law(pieces.low[place]) for place, law in rows]
        return np.asarray(np.prod([np.ones(len(pieces)), *parts], axis=0))

    def open_(pieces: Pieces) -> FloatArray:
        return np.asarray(of_free(pieces) * (up_to[1](pieces.top) - up_to[0](pieces.safe)))

    least, most = 0.0, 1.0
    for pieces, last, _ in box.run(open_, max_boxes, sharp=True):
        done = pieces[last]
        least += float((of_free(done) * (1.0 - up_to[1](done.top))).sum())
        most -= float((of_free(done) * up_to[0](done.safe)).sum())
    return max(0.0, least - ROUNDING), min(1.0, most + ROUNDING)


def _end(law: Any, share: float) -> float:
    end = float(law.ppf(share))
    return end if np.isfinite(end) else float(law.ppf(TAIL if share == 0 else 1 - TAIL))


def _variables(model: Any, distribution: Any) -> dict[str, Any]:
    if isinstance(distribution, tuple):
        if len(distribution) != 2 or not all(isinstance(p, model.Parameters) for p in distribution):
            raise ParameterTypeError(f"distribution: the corners of a box are two sets of parameters of {model.name}")
        given = sides(*distribution, model.parameters)
    else:
        given = {**model.base, **distribution}
    ranges = {name: model.Parameters.ranges[name] for name in model.parameters}
    return checked(given, ranges, f"a parameter of {model.name}")


def _ends(base: ParameterSet, vary: str, begin: float, values: Mapping[str, Any]) -> FloatArray:
    """1 where the state ends, 0 where it does not, NaN where that is not proved."""
    varied = {name: np.asarray(value) for name, value in values.items() if np.ptp(value)}
    low, high = (base.replace(**{name: float(end(value)) for name, value in values.items()}) for end in (np.min, np.max))
    box = Splitting(low, high, vary, begin)
    rows = np.stack([np.broadcast_to(varied.get(name, values[name]), len(values[vary])) for name in (*box.free, vary)])
    some = (box.points(rows[:, i : i + POINTS]) for i in range(0, rows.shape[1], POINTS))
    out = np.concatenate([box.settled(points, THIN)[0].outcome for points in some])
    return np.where(out == OPEN, np.nan, np.where(out == ENDS, 1.0, 0.0))
