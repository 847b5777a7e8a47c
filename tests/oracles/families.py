"""Seeded families of parameter points that are hard to solve, for the tests and the benchmarks.

Folds, cusps and the false double root are reached through their closed forms, then left by relative
distances of 1e-3 to 1e-15.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from benchmarks.rivals import companion_roots, real_parts
from spragsym import Parameters
from spragsym.generated import catastrophe, equilibrium

Array = NDArray[np.float64]


def _log(rng: np.random.Generator, n: int, low: float, high: float) -> Array:
    """Log-uniform between powers of ten."""
    return np.asarray(10.0 ** rng.uniform(low, high, n))


def _stiffnesses(rng: np.random.Generator, n: int) -> tuple[Array, Array, Array, Array]:
    """κ, α, σ, β over several decades, β = 0 in a fifth of the points."""
    beta = np.where(rng.random(n) < 0.2, 0.0, _log(rng, n, -2, 1))
    return _log(rng, n, -3, 0), _log(rng, n, -3, 0), _log(rng, n, -2, 1), beta


def random(rng: np.random.Generator, n: int) -> Parameters:
    """Random points over several decades."""
    return Parameters(
        np.pi * rng.uniform(1e-9, 1 - 1e-9, n), 2 * rng.random(n), *_stiffnesses(rng, n)
    )


def near_folds(rng: np.random.Generator, n: int) -> Parameters:
    """Within a relative 1e-3 to 1e-15 of a fold, in θ₀ or in μ₀."""
    theta0, mu0, fixed = _folds(rng, n)
    off = rng.choice([-1.0, 1.0], n) * _log(rng, n, -15, -3)
    in_angle = rng.random(n) < 0.5
    moved = theta0 * np.where(in_angle, 1 + off, 1.0)
    moved = np.where(moved < np.pi, moved, theta0)
    return Parameters(moved, mu0 * np.where(in_angle, 1.0, 1 + off), *fixed)


def _folds(rng: np.random.Generator, n: int) -> tuple[Array, Array, tuple[Array, ...]]:
    """Points on folds in contact with μ₀ > 0: θ random, a root of the fold quartic."""
    found: list[Array] = []
    have = 0
    while have < n:
        kappa, alpha, sigma, beta = _stiffnesses(rng, 4 * n)
        theta = np.pi * rng.random(4 * n)
        c, s = np.cos(theta), np.sin(theta)
        coefficients = np.stack(catastrophe.fold_quartic(c, s, kappa, alpha, sigma, beta), axis=-1)
        roots, real = real_parts(companion_roots(coefficients))
        mu0 = np.where(real & (roots > 1e-3) & (roots < 1e3), roots, np.nan)
        mu0 = np.take_along_axis(mu0, rng.integers(0, 4, (4 * n, 1)), axis=1)[:, 0]
        s0, c0 = catastrophe.fold_angles(c, s, mu0, kappa, alpha, sigma, beta)
        theta0 = np.arctan2(s0, c0)
        in_contact = sigma * (np.sin(theta0) - s) < kappa
        keep = np.isfinite(mu0) & (s0 > 1e-6) & in_contact & (np.abs(np.hypot(s0, c0) - 1) < 1e-9)
        found.append(np.stack([theta0, mu0, kappa, alpha, sigma, beta])[:, keep])
        have += int(keep.sum())
    theta0, mu0, *fixed = np.concatenate(found, axis=1)[:, :n]
    return theta0, mu0, tuple(fixed)


def cusp_wedge(rng: np.random.Generator, n: int) -> Parameters:
    """In and about the wedge between the two folds next to a cusp, at distances of 1e-1 to 1e-8 in
    θ.
    """
    rows: list[Array] = []
    have = 0
    while have < n:
        kappa, alpha, sigma, beta = (float(value[0]) for value in _stiffnesses(rng, 1))
        polynomial = np.array(catastrophe.cusp_polynomial(kappa, alpha, sigma, beta))
        for root in np.roots(polynomial[::-1]):
            s = root.real
            if abs(root.imag) > 1e-9 or not 0 < s < 1:
                continue
            s0, ratio, friction = catastrophe.cusp_point(s, kappa, alpha, sigma, beta)
            c = np.copysign(np.sqrt(1 - s * s), friction)
            if s0 <= 0 or sigma * (s0 - s) >= kappa:
                continue
            k = 200
            theta = np.arctan2(s, c)
            step = _log(rng, k, -8, -1)
            ends = []
            for side in (-1, 1):
                near = theta + side * step * rng.uniform(0.5, 1.0, k)
                e0, e1, e2, ec = catastrophe.fold_conic(
                    np.cos(near), np.sin(near), kappa, alpha, sigma, beta
                )
                # The fold of the cusp's own curve: follow θ₀ by Newton from the cusp.
                angle = np.full(k, np.arctan2(s0, ratio * c))
                for _ in range(30):
                    sine, cosine = np.sin(angle), np.cos(angle)
                    value = e0 + e1 * sine + e2 * sine**2 + ec * cosine
                    angle = angle - value / (e1 * cosine + 2 * e2 * sine * cosine - ec * sine)
                u1, w1, u2, w2 = catastrophe.fold_lines_mu0(
                    np.cos(near),
                    np.sin(near),
                    np.cos(angle),
                    np.sin(angle),
                    kappa,
                    alpha,
                    sigma,
                    beta,
                )
                ends.append((angle, np.where(abs(np.cos(near)) > 0.3, -u1 / w1, -u2 / w2)))
            part = rng.uniform(-0.5, 1.5, k)  # two thirds lie between the folds
            theta0, mu0 = (one + part * (two - one) for one, two in zip(*ends, strict=True))
            keep = (theta0 > 0) & (theta0 < np.pi) & (mu0 >= 0) & np.isfinite(mu0)
            rows.append(
                np.stack(
                    [theta0, mu0, *(np.full(k, value) for value in (kappa, alpha, sigma, beta))]
                )[:, keep]
            )
            have += int(keep.sum())
    return Parameters(*np.concatenate(rows, axis=1)[:, :n])


def false_double_root(rng: np.random.Generator, n: int) -> Parameters:
    """Within a relative 1e-3 to 1e-15 of a point where θ and π − θ are equilibria together, at L =
    σ/(σ + α).
    """
    kappa, alpha, sigma, beta = _stiffnesses(rng, n)
    alpha = alpha * 0.5 * (1 + beta) / (alpha + 1)
    theta0 = np.pi * rng.random(n)
    s0, c0 = np.sin(theta0), np.cos(theta0)

    def at(mu0: float) -> tuple[Array, ...]:
        return equilibrium.f_coefficients(c0, s0, mu0, kappa, alpha, sigma, beta, 1)

    a, b, d, m = at(0.0)
    s = -b / a
    # Both mirror images are roots where d = m s as well, which is linear in the friction.
    _, _, d_at_1, m_at_1 = at(1.0)
    mu0 = (m * s - d) / (d_at_1 - d - (m_at_1 - m) * s)
    mu0 = np.where((s < 1) & (mu0 > 0), mu0, rng.random(n))
    return Parameters(
        theta0,
        mu0 * (1 + rng.choice([-1.0, 1.0], n) * _log(rng, n, -15, -3)),
        kappa,
        alpha,
        sigma,
        beta,
    )


def right_angle(rng: np.random.Generator, n: int) -> Parameters:
    """θ₀ = 90° and within 1e-16 to 1e-3 of it, α down to 0."""
    theta0 = 0.5 * np.pi + rng.choice([-1.0, 0.0, 1.0], n) * _log(rng, n, -16, -3)
    p = random(rng, n)
    return p.replace(theta0=theta0, alpha=np.where(rng.random(n) < 0.2, 0.0, p.alpha))


def ends(rng: np.random.Generator, n: int) -> Parameters:
    """θ₀ within 1e-12 to 1e-2 of 0 and of π."""
    off = _log(rng, n, -12, -2)
    return random(rng, n).replace(theta0=np.where(rng.random(n) < 0.5, off, np.pi - off))


def light_preload(rng: np.random.Generator, n: int) -> Parameters:
    """κ down to 1e-12."""
    return random(rng, n).replace(kappa=_log(rng, n, -12, -3))


def equal_stiffness(rng: np.random.Generator, n: int) -> Parameters:
    """α = 1 + β, where a = 0, and within a relative 1e-15 of it."""
    p = random(rng, n)
    return p.replace(
        alpha=(1 + p.beta) * (1 + rng.choice([-1.0, 0.0, 1.0], n) * _log(rng, n, -15, -6))
    )


def frictionless(rng: np.random.Generator, n: int) -> Parameters:
    """μ₀ = 0 and α = 0, alone and together."""
    p = random(rng, n)
    kind = rng.integers(0, 3, n)
    return p.replace(mu0=np.where(kind != 1, 0.0, p.mu0), alpha=np.where(kind != 0, 0.0, p.alpha))


def no_stiffness_across(rng: np.random.Generator, n: int) -> Parameters:
    """β = 0, for lift-off, where B vanishes."""
    return random(rng, n).replace(beta=0.0)


FAMILIES: dict[str, Callable[[np.random.Generator, int], Parameters]] = {
    "random": random,
    "near folds": near_folds,
    "cusp wedge": cusp_wedge,
    "false double root": false_double_root,
    "right angle": right_angle,
    "ends": ends,
    "light preload": light_preload,
    "alpha = 1 + beta": equal_stiffness,
    "no friction or alpha": frictionless,
    "beta = 0": no_stiffness_across,
}

#: Points found by search at the ends of scale: factors whose signs drown in rounding, and digits
#: lost to underflow.
EXTREMES: tuple[tuple[float, ...], ...] = tuple(
    tuple(map(float.fromhex, line.split()))
    for line in (
        "0x1.194edf1fbb437p-35 0x1.22c21aa91e6f1p+2 0x1.d0cf45d642307p-37 "
        "0x1.f502d7de5902cp+0 0x1.8341a5de04f3ap-1 0x0p+0",
        "0x1.80828afeba655p+0 0x1.16ccdf5a955b8p+45 0x1.fc2edddc25e1cp-16 "
        "0x1.fba25e690fff0p+9 0x1.4c0dd29144266p+7 0x0p+0",
        "0x1.d7cf5a257d721p-24 0x1.6e8677a453b4cp+20 0x1.387eba489bbccp-26 "
        "0x1.6e878239b5451p+20 0x1.129e30ea11167p+19 0x1.c7da14a10ac30p-7",
        "0x1.921fb54442970p+0 0x1.cb9b094c28374p+450 0x1.69da9dcb46b63p-52 "
        "0x1.417b918e9909ap+257 0x1.e49058cf1d7edp-55 0x1.3a6db5a8592c1p-244",
        "0x1.51faaaf17df26p+0 0x0p+0 0x1.1a181e66273e7p+506 0x0.0000000000002p-1022 "
        "0x0.0000000000004p-1022 0x1.b5530d2b69725p+508",
        "0x1.53a884ba60604p-53 0x1.8e27de7964698p+41 0x1.17b395b28b0c1p-30 "
        "0x1.b8bbd675c51c0p-37 0x1.7458a9f0311b2p-16 0x1.79dff667a66fcp+64",
        "0x1.2944e036203fbp-19 0x1.49c7618598a12p+13 0x1.c7544b9fdcf7bp-203 "
        "0x1.51d57ea7c3dffp-192 0x1.7f08819b6bde3p-184 0x1.c175fd70faa20p-7",
        "0x1.961f019acdcfbp-35 0x1.7764155fae4a7p+28 0x1.bb9d28d3c24aap-233 0x0p+0 "
        "0x1.6dcc1e9036bd0p-199 0x1.11db8abc7719cp-10",
        "0x1.82b6ce8d986d5p-47 0x1.3085104971523p+39 0x1.2d7ba4672409ap-255 "
        "0x1.fdd052a3e3ba1p-216 0x1.c0a09a36b9c73p-210 0x1.3a77e6d381df8p-9",
        "0x0.0000000000004p-1022 0x1.d6f80fdc60a51p+1020 0x0.0000000004b08p-1022 0x0p+0 "
        "0x1.1413013df6e18p-39 0x0p+0",
        "0x0.000000000019cp-1022 0x1.371568c560d7ep+1017 0x0.0000001c31e2fp-1022 0x0p+0 "
        "0x1.121a257825d72p-32 0x0p+0",
    )
)


def random_fixed(rng: np.random.Generator) -> Parameters:
    """κ, α, σ, β over several decades, β = 0 in half of the cases."""
    return Parameters(
        kappa=10 ** rng.uniform(-3, -0.5),
        alpha=10 ** rng.uniform(-3, 0),
        sigma=10 ** rng.uniform(-2, 0.5),
        beta=rng.choice([0.0, 10 ** rng.uniform(-2, 0.5)]),
    )


def random_fluttering(rng: np.random.Generator) -> Parameters:
    """Parameters over several decades, half of them where flutter is common: α near 1 + β, σ of its
    order.
    """
    beta = rng.choice([0.0, 10 ** rng.uniform(-2, 0.5)])
    if rng.random() < 0.5:
        alpha, sigma = (1 + beta) * rng.uniform(0.1, 1.5), 10 ** rng.uniform(-1, 0.5)
    else:
        alpha, sigma = 10 ** rng.uniform(-4, 0.5), 10 ** rng.uniform(-2, 1)
    return Parameters(
        mu0=10 ** rng.uniform(-1, 1),
        kappa=10 ** rng.uniform(-5, 0),
        alpha=alpha * (rng.random() > 0.25),
        sigma=sigma,
        beta=beta,
    )
