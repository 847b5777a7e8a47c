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
    any damping, ``"soft"``, where one body can diverge, or ``"cluster"``, whose frequencies are few.
    """
    rng = np.random.default_rng(seed)
    half = n // 2
    M, K, C = np.zeros((n, n)), np.zeros((n, n)), np.zeros((n, n))
    spectrum = np.sort(rng.uniform(1.0, 10.0, half)) * 1e3
    if kind == "cluster":
        spectrum = np.resize(spectrum[: max(2, half // 5)], half)
    for body, size in ((slice(0, half), half), (slice(half, n), n - half)):
        A = rng.standard_normal((size, size))
        mass = A @ A.T / size + np.eye(size)
        R = np.linalg.cholesky(mass)
        Q = np.linalg.qr(rng.standard_normal((size, size)))[0]
        own = np.resize(spectrum, size) * (
            1.0 + rng.uniform(-1, 1, size) * ({"near": 1e-3, "cluster": 1e-2}.get(kind, 0.3))
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
    """Friction and frequency of an onset nearby: residuals have all digits, their corrections those
    of floats.
    """
    M, C, K, F = (of[name] for name in ("M", "C", "K", "friction"))
    s, size = complex(growth, omega), abs(omega) or 1.0
    A = s * s * M + s * C + K + mu * F
    first = np.linalg.svd(A)[2][-1].conj()
    by_rate = size * 1j * (2 * s * M + C) @ first
    rows = np.hstack([A, 1j * A, np.array([by_rate, F @ first]).T])
    norm = np.hstack([first.conj(), 1j * first.conj(), [0.0, 0.0]])
    complete = np.vstack([rows, norm])
    inverse = np.linalg.inv(np.vstack([complete.real, complete.imag]))
    with mpmath.workdps(digits):
        M, C, K, F = (one + mpmath.mpf(0) for one in (M, C, K, F))
        q, value, w = first + mpmath.mpc(0), mpmath.mpf(mu), mpmath.mpf(omega)
        for _ in range(40):
            s = mpmath.mpc(growth, w)
            rest = [*(s * (s * (M @ q) + C @ q) + K @ q + value * (F @ q)), first.conj() @ q - 1]
            parts = np.array([float(z.real) for z in rest] + [float(z.imag) for z in rest])
            step = -inverse @ parts
            real, imaginary, (by_w, by_mu) = np.split(step, [len(q), 2 * len(q)])
            q = q + (real + 1j * imaginary)
            w, value = w + size * by_w, value + by_mu
            if abs(by_mu) < 10.0 ** (3 - digits):
                return value, w
    raise ArithmeticError("no convergence")


def held_block(n: int, pairs: int, rng: np.random.Generator) -> tuple[Array, list[Any]]:
    """A definite stiffness, and contact pairs on coordinates of it."""
    from spragsym import ContactPair

    A = rng.standard_normal((n, n))
    K = A @ A.T / n + 0.2 * np.eye(n)
    ends = rng.permutation(n)[: 2 * pairs].reshape(pairs, 2)
    signs = rng.choice([-1, 1], pairs)
    return K, [
        ContactPair(across=(int(a),), along=(int(b),), stiffness=2.0, direction=int(sign))
        for (a, b), sign in zip(ends, signs, strict=True)
    ]
