"""Fates at ten values of t_end after a motion has settled: the same verdict, the same limit.

A case is one motion of a page that ships, of drawn parameters and start. By then it is settled if
deviations have decayed by e⁻²⁰ at the rate of what it comes to by default, told by eigenvalues or
multipliers.
"""

from typing import Any

import numpy as np

import spragsym as ss

CASES = 100


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One motion."""
    draw = (_belt, _held, _forced, _article, _blocks)[number % 5]
    p, start = draw(rng)
    found = ss.fate(p, start=start)
    counted = {"kind": f"{p.model.name}, {found.kind}", "wrong": list[str]()}
    rate = float(found.outcome.rate)
    if found.kind not in {"rest", "cycle"} or not rate > 0:
        return counted | {"lengths": 0}
    begin = found.t if np.isinf(rate) else max(200.0, 20.0 / rate)
    if begin > 2e4:  # ten motions of that length take too long
        return counted | {"slow": 1, "lengths": 0}
    for t_end in begin * rng.uniform(1.0, 4.0, 10):
        again = ss.fate(p, start=start, t_end=t_end)
        one, other = (
            (each.kind, each.outcome.period, *each.outcome.rest) for each in (found, again)
        )
        same = one[0] == other[0] and len(one) == len(other)
        if not same or not np.allclose(one[1:], other[1:], rtol=1e-6, atol=1e-6, equal_nan=True):
            counted["wrong"].append(f"{p}, start {start}, t_end {t_end!r}: {other}, not {one}")
    return counted | {"lengths": 10}


def _belt(rng: np.random.Generator) -> tuple[Any, tuple[float, ...]]:
    model = ss.load("stick_slip")
    return model.Parameters(V=rng.uniform(0.05, 2.5)), (rng.uniform(-1, 1), rng.uniform(-1, 1))


def _held(rng: np.random.Generator) -> tuple[Any, tuple[float, ...]]:
    model = ss.load("coulomb_stick_slip")
    return model.Parameters(V=10 ** rng.uniform(-2, 0)), (rng.uniform(-1, 1), rng.uniform(-1, 1))


def _forced(rng: np.random.Generator) -> tuple[Any, tuple[float, ...]]:
    mu_k = rng.uniform(0.2, 1.0)
    p = ss.load("forced_oscillator").Parameters(
        mu_k=mu_k, mu_s=mu_k * rng.uniform(1.0, 1.5), omega=rng.uniform(0.3, 3.0)
    )
    return p, (rng.uniform(-1, 1), rng.uniform(-1, 1))


def _article(rng: np.random.Generator) -> tuple[Any, tuple[float, ...]]:
    p = ss.Parameters.article(theta0=np.radians(rng.uniform(20, 60)))
    return p.given(V=0.5, d=10.0), (rng.uniform(-0.5, 0.5), rng.uniform(-0.1, 0.1), 0.0, 0.0)


def _blocks(rng: np.random.Generator) -> tuple[Any, tuple[float, ...]]:
    p = ss.load("two_blocks").Parameters(V=rng.uniform(0.05, 1.0))
    return p, tuple(rng.uniform(-0.5, 0.5, 4))
