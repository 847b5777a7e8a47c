"""Quantities that vary together: a Gaussian copula, the correlations of normal scores behind whatever distributions they have."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import TypeAlias

import numpy as np

from ..errors import ParameterError
from ..models.parameters import FloatArray, Range, as_number

#: Pairs of quantities → how they are correlated, from −1 to 1.
Correlation: TypeAlias = Mapping[tuple[str, str], float]

_ALLOWED = Range(-1.0, 1.0, closed_high=True, remedy="1 where one decides the other, 0 where they have nothing in common")
#: Eigenvalue of a correlation matrix that counts as 0.
_SINGULAR = 1e-12
#: The least share that has a normal score to speak of.
_LEAST = 2.0**-40


@dataclass(frozen=True)
class Dependence:
    """``groups`` of positions in ``names`` that are correlated among each other, and for each a factor F: scores are F g."""

    names: tuple[str, ...]
    groups: tuple[tuple[int, ...], ...]
    factors: tuple[FloatArray, ...]

    def shares(self, points: FloatArray) -> FloatArray:
        """Points of the unit cube, of shape (n, names), as shares of distributions that are correlated so."""
        from scipy.special import ndtr, ndtri

        result = np.array(points)
        for group, factor in zip(self.groups, self.factors, strict=True):
            if len(group) > 1:
                scores = ndtri(np.clip(points[:, group], _LEAST, 1 - _LEAST))
                result[:, group] = ndtr(scores @ factor.T)
        return result

    def corners(self) -> FloatArray:
        """Shares of 0 and 1 that may occur together: all of them, but where some quantities decide others."""
        parts = []
        for group, factor in zip(self.groups, self.factors, strict=True):
            kept = factor[:, np.abs(factor).max(axis=0) > _SINGULAR**0.5]
            scores = np.array(list(product((-1.0, 1.0), repeat=kept.shape[1]))) @ kept.T
            singular = kept.shape[1] < len(group)
            parts.append(np.unique(np.where(np.abs(scores) < 1e-9, 0.5, np.where(scores > 0, 1.0, 0.0)), axis=0) if singular
                         else np.array(list(product((0.0, 1.0), repeat=len(group)))))  # fmt: skip
        result = np.empty((int(np.prod([len(part) for part in parts])), len(self.names)))
        for row, choice in enumerate(product(*parts)):
            for group, values in zip(self.groups, choice, strict=True):
                result[row, list(group)] = values
        return result

    @property
    def titles(self) -> tuple[str, ...]:
        """A name for each group."""
        return tuple(", ".join(self.names[i] for i in group) for group in self.groups)


def dependence(names: Sequence[str], correlation: Correlation | None = None) -> Dependence:
    """How some quantities vary together.

    Examples
    --------
    >>> found = dependence(("k", "k_x", "mu0"), {("k", "k_x"): 1.0})
    >>> found.titles, found.corners()[:, :2].tolist()
    (('k, k_x', 'mu0'), [[0.0, 0.0], [0.0, 0.0], [1.0, 1.0], [1.0, 1.0]])
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    matrix = np.eye(len(names))
    for pair, given in (correlation or {}).items():
        if not (isinstance(pair, tuple) and len(pair) == 2 and pair[0] != pair[1] and set(pair) <= set(names)):
            raise ParameterError(
                f"correlation of {pair!r}: give two of the quantities that vary, {', '.join(names) or 'of which there are none'}"
            )
        i, j = (names.index(name) for name in pair)
        if matrix[i, j]:
            raise ParameterError(f"correlation of {pair!r} is there twice; keep one of the two")
        matrix[i, j] = matrix[j, i] = as_number(f"correlation of {', '.join(pair)}", given, _ALLOWED)
    _, label = connected_components(coo_array(matrix != 0), directed=False)
    groups = tuple(tuple(np.flatnonzero(label == one).tolist()) for one in dict.fromkeys(label.tolist()))
    factors = []
    for group in groups:
        values, vectors = np.linalg.eigh(matrix[np.ix_(group, group)])
        if values[0] < -_SINGULAR:
            together = ", ".join(names[i] for i in group)
            raise ParameterError(
                f"the correlations of {together} can't all be true at once (their matrix has the eigenvalue {values[0]:.3g}); "
                "give smaller ones, or those of all pairs"
            )
        factors.append(vectors * np.sqrt(np.where(values > _SINGULAR, values, 0.0)))
    return Dependence(tuple(names), groups, tuple(factors))
