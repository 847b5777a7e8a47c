"""Piecewise polynomials, one per step of an integrator, given by their values at the step's
Gauss–Lobatto points: interpolation, quadrature, zeros.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.polynomial import legendre

from ..models.parameters import FloatArray
from ..numerics.interval_arrays import ComplexArray, IndexArray

#: Degree of the polynomial of a step: 12 represents a Taylor step of order 20 up to rounding, and
#: DOP853's dense output has degree 7.
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


@cache
def _to_coefficients() -> FloatArray:
    """Matrix from values at the Lobatto points to Legendre coefficients."""
    found = np.linalg.inv(legendre.legvander(lobatto()[0], DEGREE))
    return np.asarray(found, dtype=float)


def sample_times(begin: FloatArray | float, end: FloatArray | float) -> FloatArray:
    """Lobatto points of the step from ``begin`` to ``end``, or of many steps: (…, DEGREE + 1)."""
    t: FloatArray = (
        np.asarray(end - begin)[..., None] * unit_points() + np.asarray(begin)[..., None]
    )
    t[..., -1] = end
    return t


@dataclass(frozen=True)
class PiecewisePolynomial:
    """A vector function of time, given by samples ``states`` (2 n, k) at the Lobatto points ``t``
    of all steps; neighbouring steps share a sample.
    """

    t: FloatArray
    states: FloatArray

    @property
    def steps(self) -> FloatArray:
        """Ends of the steps."""
        return self.t[::DEGREE]

    def __call__(self, times: FloatArray) -> FloatArray:
        """Values at times, shape (2 n, …); times outside are extrapolated."""
        return self.at(self.step_of(times), times)

    def step_of(self, times: FloatArray) -> IndexArray:
        """Indices of the steps that contain these times."""
        return np.clip(np.searchsorted(self.steps, times, side="right") - 1, 0, len(self.steps) - 2)

    def at(self, step: IndexArray, times: FloatArray) -> FloatArray:
        """Values at times within given steps, by barycentric Lagrange interpolation."""
        points, weights = lobatto()
        index = step[..., None] * DEGREE + np.arange(DEGREE + 1)
        begin, end = self.t[index[..., 0]], self.t[index[..., -1]]
        distance = (2 * (times - begin) / (end - begin) - 1)[..., None] - points
        hit = distance == 0
        # Barycentric weights of Gauss–Lobatto points: ±√(quadrature weight).
        share = np.sqrt(weights) * (-1.0) ** np.arange(len(points)) / np.where(hit, 1.0, distance)
        share = np.where(hit.any(axis=-1, keepdims=True), hit, share)
        return (self.states[:, index] * (share / share.sum(axis=-1, keepdims=True))).sum(axis=-1)

    def _by_steps(self, row: int) -> FloatArray:
        """A component at the points of each step, (steps, DEGREE + 1)."""
        of_steps = np.arange(len(self.steps) - 1)[:, None] * DEGREE + np.arange(DEGREE + 1)
        return self.states[row, of_steps]

    def slopes(self, row: int) -> FloatArray:
        """Time derivative of a component at the samples; at the end of a step that of the next."""
        to_derivatives = legendre.legval(lobatto()[0], legendre.legder(_to_coefficients()))
        slopes = self._by_steps(row) @ to_derivatives * (2 / np.diff(self.steps))[:, None]
        return np.append(slopes[:, :-1].ravel(), slopes[-1, -1])

    def fourier(self, row: int, rates: FloatArray) -> ComplexArray:
        """Integrals over time of a component times exp(−i rate (t − t_0)), at each of the rates.

        Of Legendre's polynomial P_n over [−1, 1] times exp(−i κ s) that is 2 (−i)^n j_n(κ).
        """
        from scipy.special import spherical_jn  # slow to import

        coefficients = self._by_steps(row) @ _to_coefficients().T
        middles = (self.steps[1:] + self.steps[:-1]) / 2 - self.t[0]
        halves, found = np.diff(self.steps) / 2, np.zeros(len(rates), dtype=complex)
        shifts = np.exp(-1j * rates[:, None] * middles)
        for n, factor in enumerate(2 * (-1j) ** np.arange(DEGREE + 1)):
            waves = shifts * spherical_jn(n, rates[:, None] * halves)
            found += factor * waves @ (halves * coefficients[:, n])
        return found

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
        """Times at which sign × component becomes non-negative, by the Illinois method (regula
        falsi) in all brackets at once.
        """
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
            # If an end of the bracket stays twice in a row, its value is halved, which moves the
            # next iterate towards it.
            halved = np.where(side == before, 0.5, 1.0)
            above = np.where(left, halved * above, value)
            below = np.where(left, value, halved * below)
            low, high = np.where(left, root, low), np.where(left, high, root)
            if np.all(np.abs(root - last) <= 1e-15 * (1 + np.abs(root))):
                break
        return root

    def zeros(self) -> FloatArray:
        """Times at which the first component passes 0: first all upward, then all downward."""
        return np.concatenate([self.passages(0, sign) for sign in (1, -1)])

    def turns(self, row: int) -> FloatArray:
        """Times of all local extrema of a component."""
        return PiecewisePolynomial(self.t, self.slopes(row)[None]).zeros()

    def weights(self) -> FloatArray:
        """Quadrature weights, (k,): the integral of f over time is ``(weights * f).sum()``."""
        weights = np.zeros_like(self.t)
        for j, weight in enumerate(lobatto()[1]):
            weights[j : len(self.t) - DEGREE + j : DEGREE] += weight * np.diff(self.steps) / 2
        return weights
