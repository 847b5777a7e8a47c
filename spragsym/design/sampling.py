"""Quasi-Monte Carlo points, sums of function values over them, and dependence of the quantities.

Points are several independent scramblings of one Sobol' sequence. For Sobol' indices a second set
of points and mixtures of both are added. Of each chunk of points only sums are kept. Dependence of
quantities is a Gaussian copula: correlations of normal scores, whatever the distributions are.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import NamedTuple, TypeAlias

import numpy as np

from ..core.errors import ParameterError
from ..models.parameters import FloatArray, Range, as_number

#: A function of points of the unit cube, shape (points, variables); NaN where it has no value.
Function = Callable[[FloatArray], FloatArray]


class Chunk(NamedTuple):
    """A part of one scrambled sequence."""

    replicate: int
    seed: int
    begin: int
    size: int


def chunks(n: int, seeds: Sequence[int]) -> list[Chunk]:
    """Chunks of at least ``n`` points: one sequence for each seed, of a power of two points."""
    each = 1 << max(int(np.ceil(np.log2(max(n / len(seeds), 2)))), 1)
    size = min(each, max(1 << 12, min(1 << 15, each // 8)))
    return [
        Chunk(i, seed, begin, size)
        for i, seed in enumerate(seeds)
        for begin in range(0, each, size)
    ]


def sums(
    function: Function, groups: Sequence[Sequence[int]], indices: bool, together: Sequence[Chunk]
) -> list[list[float]]:
    """For each chunk the number of values, that of NaN, Σf and Σf² over both sets, then two sums
    for the indices of each group of variables.
    """
    sets = [_sets(groups, indices, chunk) for chunk in together]
    # All points at once, since following states takes as long for few as for many.
    values = np.split(function(np.concatenate(sets)), np.cumsum([len(one) for one in sets])[:-1])
    return [
        _sums(np.reshape(one, (-1, chunk.size)), 2 if indices else 1)
        for one, chunk in zip(values, together, strict=True)
    ]


def _sets(groups: Sequence[Sequence[int]], indices: bool, chunk: Chunk) -> FloatArray:
    """Points of a chunk: its set and, for indices, the second set and one mixture for each
    group.
    """
    from scipy.stats import qmc

    variables = sum(map(len, groups))
    # SciPy goes forward in sequences of up to 32 bits only.
    sequence = qmc.Sobol(
        (2 if indices else 1) * variables, rng=np.random.default_rng(chunk.seed), bits=32
    )
    if chunk.begin:
        sequence.fast_forward(chunk.begin)
    points = sequence.random(chunk.size)
    sets = np.split(points, 2 if indices else 1, axis=1)
    for group in groups if indices else ():
        sets.append(sets[0].copy())
        sets[-1][:, group] = sets[1][:, group]
    return np.concatenate(sets)


def _sums(values: FloatArray, own: int) -> list[float]:
    """Sums of the values of a chunk, shape (sets, points); the first ``own`` sets are its
    points.
    """
    unknown, values = np.isnan(values), np.nan_to_num(values)
    result = [
        float(own * values.shape[1]),
        float(unknown[:own].sum()),
        float(values[:own].sum()),
        float((values[:own] ** 2).sum()),
    ]
    for value in values[own:]:
        result += [float(values[1] @ (value - values[0])), float(((values[0] - value) ** 2).sum())]
    return result


#: Correlation coefficients in [−1, 1], by pairs of quantities.
Correlation: TypeAlias = Mapping[tuple[str, str], float]

#: Eigenvalues of a correlation matrix down to minus this count as 0.
_SINGULAR = 1e-12


@dataclass(frozen=True)
class Dependence:
    """A Gaussian copula: for each group of correlated ``names``, by index, a factor F of the
    correlation matrix.

    Normal scores of the group are F g with independent g.
    """

    names: tuple[str, ...]
    factors: Mapping[tuple[int, ...], FloatArray]

    def shares(self, points: FloatArray) -> FloatArray:
        """Points of the unit cube, shape (n, names), transformed to the correlated distribution."""
        from scipy.special import ndtr, ndtri

        result = np.array(points)
        least = 2.0**-40  # normal scores stay finite
        for group, factor in self.factors.items():
            if len(group) > 1:
                scores = ndtri(np.clip(points[:, group], least, 1 - least))
                result[:, group] = ndtr(scores @ factor.T)
        return result

    def corners(self) -> FloatArray:
        """Corners of the unit cube that can occur: not all, if some quantities determine others."""
        parts = []
        for group, factor in self.factors.items():
            kept = factor[:, np.abs(factor).max(axis=0) > _SINGULAR**0.5]
            kept = kept if kept.shape[1] < len(group) else np.eye(len(group))
            scores = np.array(list(product((-1.0, 1.0), repeat=kept.shape[1]))) @ kept.T
            parts.append(
                np.unique(0.5 + 0.5 * np.sign(np.where(np.abs(scores) < 1e-9, 0.0, scores)), axis=0)
            )
        order = np.argsort([i for group in self.factors for i in group])
        return np.array([np.concatenate([[], *choice])[order] for choice in product(*parts)])

    @property
    def titles(self) -> tuple[str, ...]:
        """Names of the groups."""
        return tuple(", ".join(self.names[i] for i in group) for group in self.factors)


def dependence(names: Sequence[str], correlation: Correlation | None) -> Dependence:
    """Dependence of some quantities on each other.

    Examples
    --------
    >>> found = dependence(("k", "k_x", "mu0"), {("k", "k_x"): 1.0})
    >>> found.titles, found.corners()[:, :2].tolist()
    (('k, k_x', 'mu0'), [[0.0, 0.0], [0.0, 0.0], [1.0, 1.0], [1.0, 1.0]])
    """
    matrix = np.eye(len(names))
    allowed = Range(
        -1.0,
        1.0,
        closed_high=True,
        remedy="1 where one decides the other, 0 where they have nothing in common",
    )
    for pair, given in (correlation or {}).items():
        if not (
            isinstance(pair, tuple)
            and len(pair) == 2
            and pair[0] != pair[1]
            and set(pair) <= set(names)
        ):
            raise ParameterError(
                f"correlation of {pair!r}: give two of the quantities that vary, "
                f"{', '.join(names) or 'of which there are none'}"
            )
        i, j = (names.index(name) for name in pair)
        if matrix[i, j]:
            raise ParameterError(f"correlation of {pair!r} is there twice; keep one of the two")
        matrix[i, j] = matrix[j, i] = as_number(f"correlation of {', '.join(pair)}", given, allowed)
    together = np.linalg.matrix_power(matrix != 0, len(names))  # by chains of pairs
    factors = {}
    for group in dict.fromkeys(tuple(np.flatnonzero(row).tolist()) for row in together):
        values, vectors = np.linalg.eigh(matrix[np.ix_(group, group)])
        if values[0] < -_SINGULAR:
            listed = ", ".join(names[i] for i in group)
            raise ParameterError(
                f"the correlations of {listed} can't all be true at once (their matrix has "
                f"the eigenvalue {values[0]:.3g}); "
                "give smaller ones, or those of all pairs"
            )
        factors[group] = vectors * np.sqrt(np.where(values > _SINGULAR, values, 0.0))
    return Dependence(tuple(names), factors)
