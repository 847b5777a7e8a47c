"""Random brakes as matrices, and what grows in them by other programs."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np

Array = np.ndarray[Any, Any]


def brake(n: int, seed: int, *, kind: str = "plain") -> dict[str, Array]:
    """Two elastic bodies of n coordinates together, pressed on each other by pairs of springs that
    carry friction.

    ``kind`` is ``"plain"``, ``"near"``, whose frequencies come in near pairs, ``"weak"``, with hardly
    any damping, or ``"soft"``, where one body can diverge.
    """
    rng = np.random.default_rng(seed)
    half = n // 2
    M, K, C = np.zeros((n, n)), np.zeros((n, n)), np.zeros((n, n))
    spectrum = np.sort(rng.uniform(1.0, 10.0, half)) * 1e3
    for body, size in ((slice(0, half), half), (slice(half, n), n - half)):
        A = rng.standard_normal((size, size))
        mass = A @ A.T / size + np.eye(size)
        R = np.linalg.cholesky(mass)
        Q = np.linalg.qr(rng.standard_normal((size, size)))[0]
        own = np.resize(spectrum, size) * (
            1.0 + rng.uniform(-1, 1, size) * (1e-3 if kind == "near" else 0.3)
        )
        if kind == "soft" and body.start:
            own[0] *= 0.02
        V = R @ Q
        M[body, body] = mass
        K[body, body] = (V * own**2) @ V.T
        ratio = 1e-4 if kind == "weak" else 3e-3
        C[body, body] = (V * (2 * ratio * rng.uniform(0.3, 1.0, size) * own)) @ V.T
    pairs = max(1, n // 5)
    friction = np.zeros((n, n))
    stiffness = np.median(np.abs(np.diagonal(K))) * (0.15 if kind != "soft" else 0.4)
    for _ in range(pairs):
        across, along = (
            np.concatenate(
                [
                    rng.standard_normal(half) / np.sqrt(half),
                    -rng.standard_normal(n - half) / np.sqrt(n - half),
                ]
            )
            for _ in range(2)
        )
        K += stiffness * np.outer(across, across)
        friction += stiffness * np.outer(along, across)
    return {"M": 0.5 * (M + M.T), "C": 0.5 * (C + C.T), "K": 0.5 * (K + K.T), "friction": friction}


def eigenvalues(of: dict[str, Array], mu: float) -> Array:
    """All eigenvalues at a friction, by LAPACK."""
    n = len(of["M"])
    stiffness = of["K"] + mu * of["friction"]
    A = np.zeros((2 * n, 2 * n))
    A[:n, n:] = np.eye(n)
    A[n:] = -np.linalg.solve(of["M"], np.hstack([stiffness, of["C"]]))
    return np.linalg.eigvals(A)


def counts(of: dict[str, Array], values: Array, growth: float) -> Array:
    """How many eigenvalues grow faster, at each friction, by LAPACK."""
    return np.array([int((eigenvalues(of, mu).real > growth).sum()) for mu in values])


def precise_onset(
    of: dict[str, Array], mu: float, omega: float, growth: float, digits: int = 40
) -> tuple[mpmath.mpf, mpmath.mpf]:
    """Friction and frequency of an onset nearby, by Newton's method with many digits."""
    with mpmath.workdps(digits):
        M, C, K, F = (mpmath.matrix(of[name].tolist()) for name in ("M", "C", "K", "friction"))
        n = len(of["M"])
        start = complex(growth, omega)
        matrix = start**2 * of["M"] + start * of["C"] + of["K"] + mu * of["friction"]
        _, _, right = np.linalg.svd(matrix)
        q = mpmath.matrix([mpmath.mpc(z) for z in right[-1].conj()])
        c = q.H
        value, w = mpmath.mpf(mu), mpmath.mpf(omega)
        for _ in range(6):
            s = mpmath.mpc(growth, w)
            A = s * s * M + s * C + K + value * F
            r = A * q
            by_w, by_mu = mpmath.mpc(0, 1) * (2 * s * M + C) * q, F * q
            big = mpmath.matrix(2 * n + 2, 2 * n + 2)
            right_side = mpmath.matrix(2 * n + 2, 1)
            for i in range(n):
                for k in range(n):
                    a = A[i, k]
                    big[i, k], big[i, n + k] = a.real, -a.imag
                    big[n + i, k], big[n + i, n + k] = a.imag, a.real
                big[i, 2 * n], big[n + i, 2 * n] = by_w[i].real, by_w[i].imag
                big[i, 2 * n + 1], big[n + i, 2 * n + 1] = by_mu[i].real, by_mu[i].imag
                big[2 * n, i], big[2 * n, n + i] = c[i].real, -c[i].imag
                big[2 * n + 1, i], big[2 * n + 1, n + i] = c[i].imag, c[i].real
                right_side[i], right_side[n + i] = -r[i].real, -r[i].imag
            norm = (c * q)[0] - 1
            right_side[2 * n], right_side[2 * n + 1] = -norm.real, -norm.imag
            step = mpmath.lu_solve(big, right_side)
            q = mpmath.matrix([q[i] + mpmath.mpc(step[i], step[n + i]) for i in range(n)])
            w, value = w + step[2 * n], value + step[2 * n + 1]
        return value, w
