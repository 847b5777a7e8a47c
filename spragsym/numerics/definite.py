"""The main inertia theorem for pencils of matrices that depend on a parameter, proved in floats.

Of M q″ + D(t) q′ + S(t) q = 0, or E x′ = F(t) x with x = (q, q′), it tells how many eigenvalues
have real parts above η. If H is symmetric and Q = Eᵀ H F + Fᵀ H E − 2 η Eᵀ H E positive definite,
no real part is η, and as many exceed it as H has positive eigenvalues (A. Ostrowski and
H. Schneider, J. Math. Anal. Appl. 4 (1962) 72). Here H = Yᵀ P(τ) Y, with Y and X the inverse and
the eigenbasis at a middle t₀ and P a power series in τ = t − t₀ that makes Xᵀ Q X diagonal but for
a remainder τ^d R. One float Cholesky decomposition for each sign of R shows it definite over a
whole stretch
(S. M. Rump, BIT 46 (2006) 433). Pairs of eigenvalues are 2 × 2 blocks, so that all matrices are
real. Roundings are bounded a priori, element by element, those of the given sums of matrices
included; the matrices themselves are taken as they are, as floats.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from math import comb
from typing import TypeAlias

import numpy as np

from .interval_arrays import BoolArray, ComplexArray, FloatArray

#: Coefficients and matrices whose exact sum is meant.
Terms: TypeAlias = tuple[tuple[float, FloatArray], ...]

# Covers the roundings of bounds, which are sums of positive numbers; and products that underflow.
_COVER = 1.0 + 2.0**-20
_TINY = 1e-280


def gamma(count: int) -> float:
    """Bound on the relative error of ``count`` roundings in a row."""
    return count * 2.0**-53 / (1.0 - count * 2.0**-53)


def exceeds(symmetric: FloatArray, margin: float) -> bool:
    """Whether all eigenvalues of I + A and of I − A exceed ``margin``, for a symmetric A: proved if
    True.
    """
    unit = np.eye(len(symmetric))
    return all(is_definite(unit + signed, margin) for signed in (symmetric, -symmetric))


def is_definite(symmetric: FloatArray, margin: float = 0.0) -> bool:
    """Whether all eigenvalues of a symmetric matrix exceed ``margin``: proved if True. ``margin``
    may be any bound on the norm of what is neglected; the diagonal is of the order of 1.
    """
    n = len(symmetric)
    # The decomposition is that of a matrix nearer than γ times the trace.
    size = n + float(np.abs(np.diagonal(symmetric)).sum())
    shifted = symmetric - np.eye(n) * (margin + 2.0 * gamma(n + 8) * size)
    try:
        np.linalg.cholesky(shifted)
    except np.linalg.LinAlgError:
        return False
    return True


@dataclass(frozen=True)
class Pencil:
    """M q″ + D(t) q′ + S(t) q, where D and S are sums of terms, and of t times a slope."""

    mass: FloatArray
    damping: Terms
    stiffness: Terms
    damping_slope: FloatArray
    stiffness_slope: FloatArray

    def at(self, t: float) -> tuple[FloatArray, FloatArray]:
        """D and S, rounded."""
        return (
            _sum((*self.damping, (t, self.damping_slope))),
            _sum((*self.stiffness, (t, self.stiffness_slope))),
        )

    def sizes(self, t: float) -> tuple[FloatArray, FloatArray]:
        """Sums of the moduli of all terms of D and S."""
        return (
            _size((*self.damping, (t, self.damping_slope))),
            _size((*self.stiffness, (t, self.stiffness_slope))),
        )

    def dynamic_stiffness(self, s: complex, t: float) -> ComplexArray:
        """s² M + s D + S, rounded."""
        D, S = self.at(t)
        return (s * s * self.mass + s * D + S).astype(complex)

    @property
    def transposed(self) -> Pencil:
        """That of the left vectors."""
        return self._each(lambda one: one.T)

    def within(self, space: FloatArray) -> Pencil:
        """Its projection on the columns of an array."""
        return self._each(lambda one: space.T @ (one @ space))

    def _each(self, change: Callable[[FloatArray], FloatArray]) -> Pencil:
        damping, stiffness = (
            tuple((of, change(one)) for of, one in part) for part in (self.damping, self.stiffness)
        )
        slopes = change(self.damping_slope), change(self.stiffness_slope)
        return Pencil(change(self.mass), damping, stiffness, *slopes)

    def nearest(self, t: float, s: complex) -> tuple[ComplexArray, ComplexArray]:
        """The two eigenvalues that are nearest to s, and their vectors as rows."""
        values, vectors = self.eigenbasis(t)
        two = np.abs(values - s).argsort()[:2]
        return values[two], vectors.T[two]

    @property
    def order(self) -> int:
        """Number of eigenvalues."""
        return 2 * len(self.mass)

    @property
    def roundings(self) -> int:
        """Most roundings of an element of D or S."""
        return 2 * max(len(self.damping), len(self.stiffness)) + 4

    def companion(self, t: float, scale: float = 1.0) -> FloatArray:
        """The matrix A of x′ = A x, in floats, with x = (q, q′/scale)."""
        N, (D, S) = len(self.mass), self.at(t)
        A = np.zeros((2 * N, 2 * N))
        A[:N, N:] = scale * np.eye(N)
        A[N:] = -np.linalg.solve(self.mass, np.hstack([S / scale, D]))
        return A

    def eigenbasis(self, t: float) -> tuple[ComplexArray, ComplexArray]:
        """Eigenvalues λ and vectors q as columns, in floats: of each pair the one with Im λ > 0,
        then real ones.
        """
        scale = float(np.sqrt(np.abs(self.at(t)[1]).max() / np.abs(self.mass).max())) or 1.0
        values, vectors = np.linalg.eig(self.companion(t, scale))
        values, vectors = values.astype(complex), vectors.astype(complex)
        kept = np.concatenate([np.flatnonzero(values.imag > 0), np.flatnonzero(values.imag == 0)])
        return values[kept], vectors[: len(self.mass), kept]


def _sum(terms: Terms) -> FloatArray:
    (of, first), *others = terms
    total = of * first
    for of, one in others:
        total = total + of * one
    return total


def _size(terms: Terms) -> FloatArray:
    return _sum(tuple((abs(of), np.abs(one)) for of, one in terms))


class Middle:
    """The eigenbasis at a middle t₀, and bounds on all roundings with it.

    With Δ, R₀, R₁ whose elements are at most ``delta``, ``rest`` and ``slope_rest``, exactly
    Y E X = I + Δ and Y (F(t₀ + τ) − η E) X = Λ − η I + R₀ + τ (B + R₁).

    Attributes
    ----------
    t : float
    values : ndarray
        Eigenvalues less η: of each pair the one with Im λ > 0, then real ones.
    pairs : int
    slope : ndarray
        B, in the real basis √2 Re x of all pairs, −√2 Im x of all pairs, real x.
    """

    def __init__(self, pencil: Pencil, t: float, growth: float) -> None:
        self.t = t
        values, vectors = pencil.eigenbasis(t)
        M, (D, S), (D_size, S_size) = pencil.mass, pencil.at(t), pencil.sizes(t)
        p = self.pairs = int((values.imag > 0).sum())
        rates = vectors * values
        with np.errstate(over="ignore", invalid="ignore"):
            size = np.abs(np.einsum("ij,ij->j", rates.conj(), M @ rates))
            size += np.abs(np.einsum("ij,ij->j", vectors.conj(), S @ vectors))
        basis = np.vstack([vectors, rates]) / np.sqrt(np.where(size > 0, size, 1.0))
        root = np.sqrt(2.0)
        X = np.hstack([root * basis.real[:, :p], -root * basis.imag[:, :p], basis.real[:, p:]])
        N, n = len(M), len(X)
        x, v = X[:N], X[N:]
        Mv = M @ v
        Y = np.linalg.inv(np.vstack([x, Mv]))
        y, w = Y[:, :N], Y[:, N:]
        self.values = values - growth
        force = S @ x + D @ v
        force_slope = pencil.stiffness_slope @ x + pencil.damping_slope @ v
        E = y @ x + w @ Mv
        self.slope = -(w @ force_slope)
        self.block = np.zeros((n, n))  # Λ − η I
        a, b, c = self.values.real[:p], self.values.imag[:p], np.arange(p)
        self.block[c, c] = self.block[c + p, c + p] = a
        self.block[c, c + p], self.block[c + p, c] = -b, b
        real = np.arange(2 * p, n)
        self.block[real, real] = self.values.real[p:]
        # What is bounded: sums of at most n products of at most n products, and a few more.
        lost = _COVER * gamma(2 * n + pencil.roundings + 8)
        y, w, x, v = (np.abs(one) for one in (y, w, x, v))
        E_size = y @ x + w @ (np.abs(M) @ v)
        F_size = y @ v + w @ (S_size @ x + D_size @ v)
        slope_size = w @ (np.abs(pencil.stiffness_slope) @ x + np.abs(pencil.damping_slope) @ v)
        self.delta = _COVER * np.abs(E - np.eye(n)) + lost * E_size + _TINY
        rest = Y[:, :N] @ X[N:] - Y[:, N:] @ force - growth * E - self.block
        size = F_size + abs(growth) * E_size + np.abs(self.block)
        self.rest = _COVER * np.abs(rest) + lost * size + _TINY
        self.slope_rest = lost * (slope_size + np.abs(self.slope)) + _TINY

    @property
    def is_finite(self) -> bool:
        """Whether all of it is: no overflow, no singular matrix."""
        every = (self.delta, self.rest, self.slope_rest, self.slope)
        return all(bool(np.isfinite(one).all()) for one in every)

    def rows(self, index: int) -> list[int]:
        """Rows of an eigenvalue in the real basis."""
        p = self.pairs
        return [index, index + p] if index < p else [index + p]

    @cached_property
    def reciprocals(self) -> tuple[ComplexArray, ComplexArray]:
        """−1/(λ_k + λ̄_j), and −1/(λ̄_k + λ̄_j) between pairs; 0 where the sum is."""
        own = self.values.conj()[:, None]
        small = 1e-13 * np.abs(self.values).max()
        sums = own + self.values, own[: self.pairs] + self.values[: self.pairs].conj()
        first, second = (
            np.where(np.abs(one) > small, -1.0 / np.where(one == 0, 1.0, one), 0.0) for one in sums
        )
        return first, second

    def solved(self, W: FloatArray, free: BoolArray) -> FloatArray:
        """A symmetric P for which P Λ + Λᵀ P + W is 0 up to roundings, but on the diagonal of the
        eigenvalues that are ``free``.
        """
        p, (first, second) = self.pairs, self.reciprocals
        first = np.where(np.diag(free), 0.0, first)
        P = np.empty_like(W)
        c, s, r = slice(p), slice(p, 2 * p), slice(2 * p, None)
        A, B, D = W[c, c], W[c, s], W[s, s]
        H = 0.5 * (A + D + 1j * (B.T - B)) * first[:p, :p]
        Z = 0.5 * (A - D + 1j * (B.T + B)) * second
        P[c, c], P[s, s] = (H + Z).real, (H - Z).real
        P[c, s] = (Z - H).imag
        P[s, c] = P[c, s].T
        mixed = (W[c, r] + 1j * W[s, r]) * first[:p, p:]
        P[c, r], P[s, r] = mixed.real, mixed.imag
        P[r, c], P[r, s] = P[c, r].T, P[s, r].T
        P[r, r] = W[r, r] * first[p:, p:].real
        return 0.5 * (P + P.T)

    def times_block(self, P: FloatArray) -> FloatArray:
        """P (Λ − η I), each element of at most two products."""
        p, out = self.pairs, np.empty_like(P)
        a, b = self.values.real, self.values.imag[: self.pairs]
        out[:, :p] = P[:, :p] * a[:p] + P[:, p : 2 * p] * b
        out[:, p : 2 * p] = P[:, p : 2 * p] * a[:p] - P[:, :p] * b
        out[:, 2 * p :] = P[:, 2 * p :] * a[p:]
        return out

    @cached_property
    def paths(self) -> ComplexArray:
        """λ(τ) − η of each eigenvalue to second order: its coefficients, in floats."""
        p, B = self.pairs, self.in_pairs(self.slope)
        values = np.concatenate([self.values[:p], self.values[:p].conj(), self.values[p:]])
        away = values[:, None] - values
        np.fill_diagonal(away, np.inf)
        bends = (B * B.T / np.where(away == 0, np.inf, away)).sum(axis=1)
        rows = np.r_[:p, 2 * p : len(values)]
        return np.array([self.values, np.diagonal(B)[rows], bends[rows]])

    def is_neutral(self, reach: float) -> bool:
        """Whether an eigenvalue stays at η up to roundings as far as ±``reach``, by floats."""
        paths = np.abs(self.paths.real)
        small = 1e-12 * float(np.abs(self.values).max())
        return bool((reach ** np.arange(3) @ paths <= small).any())

    def in_pairs(self, matrix: FloatArray) -> ComplexArray:
        """A matrix of the real basis in the basis of all pairs x, their conjugates, and real x."""
        half = _to_complex(matrix, self.pairs, 1j)
        return _to_complex(half.T, self.pairs, -1j).T

    def bound_in_pairs(self, bound: FloatArray) -> FloatArray:
        """A bound on the moduli of the elements, in the same basis."""
        half = _to_complex(bound, self.pairs, 1.0)
        half[self.pairs : 2 * self.pairs] = half[: self.pairs]
        whole = _to_complex(half.T, self.pairs, 1.0)
        whole[self.pairs : 2 * self.pairs] = whole[: self.pairs]
        return _COVER * np.abs(whole.T)


def _to_complex(matrix: FloatArray | ComplexArray, p: int, unit: complex) -> ComplexArray:
    """Rows (c, s) as (c + unit s)/√2 and (c − unit s)/√2."""
    out = np.array(matrix, dtype=complex)
    c, s = matrix[:p], matrix[p : 2 * p]
    out[:p], out[p : 2 * p] = (c + unit * s) / np.sqrt(2.0), (c - unit * s) / np.sqrt(2.0)
    return out


class Series:
    """The power series of P for signs of the eigenvalues, and the stretches on which it proves.

    ``signs`` are positive for an eigenvalue whose real part exceeds η. Of those that are
    ``free``, because they are near η, the growth in Q varies; of all others it stays.
    """

    def __init__(self, middle: Middle, signs: FloatArray, terms: int, free: BoolArray) -> None:
        self.middle = middle
        signs = np.where(signs > 0, 1.0, -1.0)
        p = middle.pairs
        whole = np.concatenate([signs[:p], signs])
        P = np.diag(whole)
        P = P.astype(float)
        self.sizes, self.off, self.growth = [np.abs(P)], list[FloatArray](), list[FloatArray]()
        self._add(P, np.zeros_like(P))
        for _ in range(terms):
            V = P @ middle.slope
            W = V + V.T
            P = middle.solved(W, free)
            self.sizes.append(np.abs(P))
            self._add(P, W)
        V = P @ middle.slope
        self.last = V + V.T
        self.count = int(np.sum(signs[:p] > 0)) * 2 + int(np.sum(signs[p:] > 0))

    def _add(self, P: FloatArray, W: FloatArray) -> None:
        product = self.middle.times_block(P)
        T = product + product.T + W
        self.growth.append(np.diagonal(T).copy())
        np.fill_diagonal(T, 0.0)
        self.off.append(np.abs(T))

    @cached_property
    def _directed(self) -> FloatArray:
        return np.array(self.growth)

    def reach(self, side: int, limit: float, least: float, touching: int | None = None) -> float:
        """The largest h found up to ``limit`` for which no real part is η, and ``count`` exceed it,
        at side τ in [0, h]; 0 if none is as large as ``least``.

        With ``touching``, the eigenvalue that has the real part η near τ = 0, it is so for side τ
        in [``least``, h].
        """
        growth = self._directed * (float(side) ** np.arange(len(self.growth)))[:, None]
        if touching is not None and not self._starts(least):
            return 0.0
        ratio = 2.0**-0.5
        steps = int(max(np.log(max(limit / least, 1.0)) / -np.log(ratio), 0.0)) + 1
        tries = 0
        for h in limit * ratio ** np.arange(steps):
            scales = self._scales(growth, float(h), least, touching)
            if scales is None:
                continue
            near, far = scales
            order = len(growth)
            K = (far[:, None] * self.last) * far * h**order
            if not np.isfinite(K).all() or _norm(K) > 0.9:
                continue
            tries += 1
            lost = self._lost(near, float(h))
            rounded = gamma(8) * float(np.abs(K).sum(axis=1).max())
            if lost < 0.5 and exceeds(0.5 * (K + K.T), _COVER * (lost + rounded)):
                return float(h)
            if tries > 8:
                break
        return 0.0

    def _starts(self, tau: float) -> bool:
        """Whether P(±τ) is nearer to the signs than 1, so that it has as many of each."""
        away = sum(tau**m * size for m, size in enumerate(self.sizes[1:], 1))
        return bool(_COVER * np.sum(away, axis=1).max() < 1.0)

    def _scales(
        self, growth: FloatArray, h: float, least: float, touching: int | None
    ) -> tuple[FloatArray, FloatArray] | None:
        """Scales s of rows for which s² times the growth is 1 or more on the stretch: at its near
        end, where roundings weigh most, and at its far end, where the remainder does.

        Of ``touching`` growth over τ is taken, so that s falls as τ^-1/2. None if a growth is not
        positive.
        """
        low = _least_on(growth, h)
        rows = [] if touching is None else self.middle.rows(touching)
        if rows:
            over = _least_on(growth[1:, rows], h)
            low[rows] = over - _COVER * np.abs(growth[0, rows]) / least
        if not (low > 0).all():
            return None
        near = (1.0 + 2.0**-40) / np.sqrt(low)
        far = near.copy()
        near[rows] *= (1.0 + 2.0**-40) / np.sqrt(least)
        far[rows] *= (1.0 + 2.0**-40) / np.sqrt(h)
        return near, far

    def _lost(self, scale: FloatArray, h: float) -> float:
        """Bound on the norm of all that is neglected, scaled, on the stretch."""
        middle, n = self.middle, len(scale)
        P, off = np.zeros((n, n)), np.zeros((n, n))
        for power, (size, rest) in enumerate(zip(self.sizes, self.off, strict=True)):
            P += h**power * size
            off += h**power * rest
        more = _COVER * gamma(n + 12)
        block, slope = np.abs(middle.block), np.abs(middle.slope)
        rest = middle.rest + h * middle.slope_rest + more * (block + h * slope)
        whole = block + h * slope + rest
        error = off @ scale + P @ (rest @ scale) + rest.T @ (P @ scale)
        error += middle.delta.T @ (P @ (whole @ scale)) + whole.T @ (P @ (middle.delta @ scale))
        return float(_COVER * (scale * error).max())


def _least_on(coefficients: FloatArray, h: float) -> FloatArray:
    """Lower bounds of polynomials Σ a_m τ^m, rows of coefficients, on [0, h]."""
    order = len(coefficients)
    scaled = coefficients * (h ** np.arange(order))[:, None]
    lost = gamma(4 * order + 8) * np.abs(scaled).sum(axis=0)
    return (_bernstein(order) @ scaled).min(axis=0) - _COVER * lost


def _bernstein(order: int) -> FloatArray:
    """The matrix from coefficients of powers on [0, 1] to those of Bernstein's polynomials."""
    return np.array([[comb(i, m) / comb(order - 1, m) for m in range(order)] for i in range(order)])


def _norm(symmetric: FloatArray) -> float:
    """An estimate of the spectral norm, by some steps of the power method."""
    vector = np.abs(symmetric).sum(axis=1)
    norm = 0.0
    for _ in range(6):
        size = float(np.linalg.norm(vector))
        if size == 0.0:
            return 0.0
        following = symmetric @ (vector / size)
        norm, vector = float(np.linalg.norm(following)), following
    return norm


@dataclass(frozen=True)
class Window:
    """One eigenvalue alone crosses the real part η within τ in [−``half``, ``half``], once.

    It does so at t₀ up to ``error``, upwards where ``direction`` is 1, with |Im λ| = ``frequency``
    up to ``frequency_error``.
    """

    half: float
    error: float
    direction: int
    frequency: float
    frequency_error: float


def _apart(
    values: ComplexArray, slopes: ComplexArray, r: float, radii: FloatArray, some: set[int]
) -> bool:
    """Whether the discs of some eigenvalues lie apart from all others for \\|τ\\| ≤ r, those of a
    pair from the real axis as well.
    """
    moved = radii + r * np.abs(slopes)
    for one in some:
        room = np.abs(values - values[one]) - _COVER * (moved + moved[one])
        room[one] = abs(values[one].imag) - _COVER * moved[one] if values[one].imag else np.inf
        if not (room > 0).all():
            return False
    return True


def window(middle: Middle, index: int, half: float) -> Window | None:
    """The proof by Gershgorin's discs that an eigenvalue crosses within ±``half`` of the middle.

    Source: for all complex τ in a disc of the radius r = 2 ``half``, the eigenvalue's own disc lies
    apart from all others, so that λ(τ) is analytic. It differs by at most the radius ρ of its disc
    from its centre + B_jj τ, and by Cauchy its slope within r/2 by 2 ρ/r from B_jj. No other disc
    touches the axis.
    """
    p, r = middle.pairs, 2.0 * half
    values = np.concatenate([middle.values[:p], middle.values[:p].conj(), middle.values[p:]])
    j = index if index < p else index + p
    conjugate = j + p if j < p else j
    B = middle.in_pairs(middle.slope)
    slopes = np.diagonal(B).copy()
    size = _COVER * np.abs(B)
    np.fill_diagonal(size, 0.0)
    delta, rest, slope_rest = (
        middle.bound_in_pairs(one) for one in (middle.delta, middle.rest, middle.slope_rest)
    )
    # B in pairs is rounded too: it is off by some units of the elements that are added.
    slope_rest = slope_rest + gamma(8) * middle.bound_in_pairs(np.abs(middle.slope))
    apart = np.abs(values - values[j])
    others = np.arange(len(values)) != j
    moduli = np.abs(values)

    def radii(reach: float, weight: FloatArray) -> FloatArray:
        """Radii of the discs, with weights of the rows, for \\|τ\\| ≤ reach."""
        part = delta @ weight / weight
        small = (rest + reach * slope_rest) @ weight / weight
        size_of = moduli + reach * np.abs(slopes)
        away = (reach * (size @ weight) / weight + small + size_of * part) / (1.0 - part)
        return np.where(part < 0.5, _COVER * away, np.inf)

    # Weights by which the other discs have a quarter of their distance, and its own is smallest.
    even = np.ones(len(values))
    weight, apart[j] = np.where(others, 0.0, 1.0), 1.0
    coupled = r * (size + slope_rest) + rest + moduli[:, None] * delta
    for _ in range(8):
        weight = np.where(others, 1e-14 + 4.0 * (coupled @ weight) / apart, 1.0)
    if not weight.max() <= 1.0:
        return None
    wide, centre = radii(r, weight), float(radii(0.0, weight)[j])
    if not _apart(values, slopes, r, wide, {j}):
        return None
    # Discs with equal weights show that the others stay off the axis.
    plain = radii(r, even)
    stays = others & (np.arange(len(values)) != conjugate)
    off_axis = np.abs(values.real) > _COVER * (plain + r * np.abs(slopes.real))
    if not _apart(values, slopes, r, plain, {j, conjugate}) or not off_axis[stays].all():
        return None
    if not wide[j] <= plain[j]:  # the one eigenvalue is the same in both
        return None
    bend = _COVER * 2.0 * float(wide[j]) / r
    slope = float(slopes[j].real)
    least = abs(slope) - bend - float(slope_rest[j, j]) - 2.0**-50 * abs(slope)
    if not least > 0:
        return None
    error = _COVER * (abs(float(values[j].real)) + centre) / least + _TINY
    if not error < half:
        return None
    drift = _COVER * (centre + error * (abs(slopes[j]) + bend + float(slope_rest[j, j])))
    frequency = abs(float(values[j].imag)) if conjugate != j else 0.0
    return Window(half, error, 1 if slope > 0 else -1, frequency, float(drift))
