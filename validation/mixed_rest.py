"""Chains of blocks on belts, some of which stand still: what friction holds beside what slides, against
linear programming.
"""

from functools import cache
from typing import Any

import numpy as np
from scipy.optimize import linprog

import spragsym as ss
from tests.oracles.user_pages import model_of

CASES = 60


@cache
def chain(n: int) -> Any:
    """n blocks, each tied to the ground, to the next one, and rubbing on a belt of its own or on
    the one before it.
    """
    lines = [
        'r"""Blocks.\n\n::\n\n    x\n"""\n',
        "from spragsym.derive.model import Page, sgn\n",
        'page = Page("Blocks that rub on belts and on each other.")',
        'm = page.unit("m", "kg", "mass")',
        'k = page.unit("k", "N/m", "stiffness")',
        'L = page.unit("L", "m", "length")',
        'c = page.parameter("c", "N/m", "spring between blocks", ">= 0", 0.3)',
        *(f'x_{i} = page.coordinate("x_{i}", "m", "block")' for i in range(n)),
        f"page.kinetic(m * ({' + '.join(f'page.rate(x_{i})**2' for i in range(n))}) / 2)",
    ]
    for i in range(n):
        along = f"x_{i} - x_{i - 1}" if i == 1 else f"x_{i}"
        lines += [
            f'k_{i} = page.parameter("k_{i}", "N/m", "spring", "> 0", 1.0)',
            f'N_{i} = page.parameter("N_{i}", "N", "load", "> 0", 1.0)',
            f'P_{i} = page.parameter("P_{i}", "N", "force", "real", 0.0)',
            f's_{i} = page.parameter("s_{i}", "1", "static", ">= 0", 0.5)',
            f'r_{i} = page.parameter("r_{i}", "1", "kinetic", ">= 0", 0.5)',
            f'V_{i} = page.parameter("V_{i}", "m/s", "belt", ">= 0", 0.0)',
            f"page.spring(k_{i}, along=x_{i})",
            f"page.force(P_{i}, along=x_{i})",
            f"page.friction({along}, V_{i}, slip=lambda v: r_{i} * sgn(v), holds=s_{i}, "
            f'on=page.normal_force(N_{i}, name="block_{i}"))',
            *([f"page.spring(c, along=x_{i} - x_{i - 1})"] if i else []),
        ]
    return model_of("\n".join(lines) + "\n", f"chain_{n}")


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One random chain: the least and the largest place of each block."""
    n = 2 + number % 2
    rests = rng.permutation([True] * (1 + number // 2 % (n - 1)) + [False] * n)[:n]
    rests[rng.integers(n)] = True
    v: dict[str, float] = {"c": float(rng.uniform(0.0, 1.0))}
    for i in range(n):
        v |= {f"{name}_{i}": float(rng.uniform(0.2, 2.0)) for name in "kN"}
        v |= {f"P_{i}": float(rng.uniform(-1, 1)), f"s_{i}": float(rng.uniform(0.2, 0.9))}
        v |= {f"r_{i}": v[f"s_{i}"] * float(rng.uniform(0.3, 1.0))}
        v |= {f"V_{i}": 0.0 if rests[i] else float(rng.uniform(0.1, 1.0))}
    p = chain(n).Parameters(**v)
    found = ss.sticking_states(p)
    K, A = np.diag([v[f"k_{i}"] for i in range(n)]), np.eye(n)
    for i in range(1, n):
        step = np.eye(n)[i] - np.eye(n)[i - 1]
        K += v["c"] * np.outer(step, step)
    A[1, 0] = -1.0  # block 1 rubs on block 0
    # K x = P + Aᵀ T, with |T_i| ≤ s_i N_i of what rests and T_i = r_i N_i of what slides.
    most = np.array([v[f"s_{i}"] * v[f"N_{i}"] for i in range(n)])
    slides = np.array([v[f"r_{i}"] * v[f"N_{i}"] for i in range(n)])
    bounds = [(None, None)] * n + [
        (-most[i], most[i]) if rests[i] else (slides[i], slides[i]) for i in range(n)
    ]
    equal = np.hstack([K, -A.T])
    right = np.array([v[f"P_{i}"] for i in range(n)])
    wrong, off = list[str](), 0.0
    for i in range(n):
        for sign, end in ((1, "low"), (-1, "high")):
            cost = sign * np.eye(2 * n)[i]
            known = sign * linprog(cost, A_eq=equal, b_eq=right, bounds=bounds).fun
            told = found[f"x_{i}_{end}"]
            if len(told) != 1 or abs(told[0] - known) > 1e-9:
                wrong.append(f"x_{i} {end}: {told}, {known}")
            else:
                off = max(off, abs(told[0] - known))
    eq = ss.equilibria(p)
    if eq.complete or "sticking_states" not in " ".join(eq.remarks):
        wrong.append("equilibria are told to be all")
    return {"kind": f"{n} blocks, {rests.sum()} rest", "wrong": wrong, "off": float(off)}
