"""Polynomials step by step, each by its values at the Gauss–Lobatto points of its step: values,
integrals, zeros.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.polynomial import legendre

from ..models.parameters import FloatArray
from ..numerics.interval_arrays import IndexArray

#: Polynomial degree of a stored step: 12 holds a Taylor step of order 20 to rounding; DOP853's is
#: 7.
DEGREE = 12


@cache
def lobatto() -> tuple[FloatArray, FloatArray]:
    """Gauss–Lobatto points in [−1, 1], ends included, and their weights."""
    basis = legendre.Legendre.basis(DEGREE)
    points = np.concatenate([[-1.0], np.sort(basis.deriv().roots().real), [1.0]])
    weights = 2 / (DEGREE * (DEGREE + 1) * basis(points) ** 2)
    return points, weights


@cache
def unit_points() -> FloatArray:
    """The Lobatto points in [0, 1]."""
    return (lobatto()[0] + 1) / 2


def sample_times(begin: FloatArray | float, end: FloatArray | float) -> FloatArray:
    """The Lobatto points of a step, or of each of many."""
    t: FloatArray = (
        np.asarray(end - begin)[..., None] * unit_points() + np.asarray(begin)[..., None]
    )
    t[..., -1] = end
    return t


@dataclass(frozen=True)
class PiecewisePolynomial:
    """States over time, polynomials by ``states`` (2 n, k) at the Lobatto points ``t`` of all
    steps; steps share a sample.
    """

    t: FloatArray
    states: FloatArray

    @property
    def steps(self) -> FloatArray:
        """Ends of the steps."""
        return self.t[::DEGREE]

    def __call__(self, times: FloatArray) -> FloatArray:
        """States at times, which are not checked, shape (4, …)."""
        return self.at(self.step_of(times), times)

    def step_of(self, times: FloatArray) -> IndexArray:
        """Indices of the steps that contain these times."""
        return np.clip(np.searchsorted(self.steps, times, side="right") - 1, 0, len(self.steps) - 2)

    def at(self, step: IndexArray, times: FloatArray) -> FloatArray:
        """States at times within given steps, by Lagrange's polynomials in barycentric form."""
        points, weights = lobatto()
        index = step[..., None] * DEGREE + np.arange(DEGREE + 1)
        begin, end = self.t[index[..., 0]], self.t[index[..., -1]]
        distance = (2 * (times - begin) / (end - begin) - 1)[..., None] - points
        hit = distance == 0
        share = np.sqrt(weights) * (-1.0) ** np.arange(len(points)) / np.where(hit, 1.0, distance)
        share = np.where(hit.any(axis=-1, keepdims=True), hit, share)
        return (self.states[:, index] * (share / share.sum(axis=-1, keepdims=True))).sum(axis=-1)

    def slopes(self, row: int) -> FloatArray:
        """Derivative of a component at the samples; where two steps meet that of the later one."""
        points, _ = lobatto()
        derivatives = legendre.legval(
            points, legendre.legder(np.linalg.inv(legendre.legvander(points, DEGREE)))
        )
        inside = self.states[
            row, np.arange(len(self.steps) - 1)[:, None] * DEGREE + np.arange(DEGREE + 1)
        ]
        slopes = inside @ derivatives * (2 / np.diff(self.steps))[:, None]
        return np.append(slopes[:, :-1].ravel(), slopes[-1, -1])

    def after(self, begin: float) -> PiecewisePolynomial:
        """The part after a given time; the step that contains this time is shortened."""
        step = int(self.step_of(np.array(begin)))
        end = (step + 1) * DEGREE
        t = sample_times(begin, self.t[end])
        states = np.concatenate(
            [self.at(np.full(t.shape, step), t)[:, :-1], self.states[:, end:]], axis=1
        )
        return PiecewisePolynomial(np.concatenate([t[:-1], self.t[end:]]), states)

    def passages(self, row: int, sign: int) -> FloatArray:
        """Times where a component, times a sign, ceases to be negative: Illinois method."""
        values = sign * self.states[row]
        (first,) = np.nonzero((values[:-1] < 0) & (values[1:] >= 0))
        step, low, high = first // DEGREE, self.t[first], self.t[first + 1]
        below, above = values[first], values[first + 1]
        root, side = high, np.zeros(len(high))
        for _ in range(60):
            height = above - below  # 0 where values underflow, as of what decays to rest
            share = np.divide(above, height, out=np.zeros_like(height), where=height > 0)
            last, root = root, high - share * (high - low)
            value = sign * self.at(step, root)[row]
            left, before = value < 0, side
            side = np.where(left, -1.0, 1.0)
            # Where an end of the interval stays twice in a row, its value is halved: that draws the
            # next root to its side.
            halved = np.where(side == before, 0.5, 1.0)
            above = np.where(left, halved * above, value)
            below = np.where(left, value, halved * below)
            low, high = np.where(left, root, low), np.where(left, high, root)
            if np.all(np.abs(root - last) <= 1e-15 * (1 + np.abs(root))):
                break
        return root

    def zeros(self) -> FloatArray:
        """Times where the first component passes 0, first those at which it ceases to be
        negative.
        """
        return np.concatenate([self.passages(0, sign) for sign in (1, -1)])

    def turns(self, row: int) -> FloatArray:
        """Times of all local extrema of a component."""
        return PiecewisePolynomial(self.t, self.slopes(row)[None]).zeros()

    def weights(self) -> FloatArray:
        """Quadrature weights, shape (n,): ``(weights * f).sum()`` is the integral of f over
        time.
        """
        weights = np.zeros_like(self.t)
        for j, weight in enumerate(lobatto()[1]):
            weights[j : len(self.t) - DEGREE + j : DEGREE] += weight * np.diff(self.steps) / 2
        return weights
