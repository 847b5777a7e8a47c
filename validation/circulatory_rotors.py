"""Systems of two to five coordinates with gyroscopic terms beside forces without a potential: types of
states without damping and onsets of flutter, against eigenvalues of their quadratic pencils.

Let D be a diagonal matrix of signs. Where M and K couple coordinates of one sign and G those of
different signs, D (λ² M + λ G + K) D is the same with −λ: all λ come in pairs ± λ. Systems of five
coordinates, more than a page may have, are asked as matrices, for growth above a threshold.
"""

from functools import cache
from itertools import combinations, pairwise
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.results import EquilibriumType
from tests.oracles.turning_frames import polyeig
from tests.oracles.user_pages import model_of

CASES = 36


@cache
def model(n: int) -> Any:
    """Linear forces between n coordinates: every gyroscopic and every circulatory term, times f."""
    units = (("m", "kg"), ("T", "s"), ("L", "m"))
    lines = [f'{name} = page.unit("{name}", "{unit}", "unit")' for name, unit in units]
    lines.append('f = page.parameter("f", "1", "share of circulatory forces", ">= 0", 1.0)')
    kinetic = list[str]()
    for i in range(n):
        lines += [
            f'm_{i} = page.parameter("m_{i}", "kg", "mass", "> 0", 1.0)',
            f'k_{i} = page.parameter("k_{i}", "N/m", "stiffness", "real", 1.0)',
            f'x_{i} = page.coordinate("x_{i}", "m", "displacement")',
            f"page.potential(k_{i} * x_{i}**2 / 2)",
        ]
        kinetic.append(f"m_{i} * page.rate(x_{i})**2 / 2")
    for i, j in combinations(range(n), 2):
        lines += [
            f'g_{i}{j} = page.parameter("g_{i}{j}", "kg/s", "gyroscopic", "real", 0.1)',
            f'n_{i}{j} = page.parameter("n_{i}{j}", "N/m", "circulatory", "real", 0.1)',
            f"page.force(-f * n_{i}{j} * x_{j}, along=x_{i})",
            f"page.force(f * n_{i}{j} * x_{i}, along=x_{j})",
        ]
        kinetic.append(f"g_{i}{j} * x_{i} * page.rate(x_{j})")
    lines.append(f"page.kinetic({' + '.join(kinetic)})")
    head = (
        'r"""Masses.\n\n::\n\n    x\n"""\n\nfrom spragsym.derive.model import Page\n\n'
        'page = Page("Masses with gyroscopic and circulatory forces between them.")\n'
    )
    return model_of(head + "\n".join(lines) + "\n", f"rotor_{n}")


def matrices(values: dict[str, float], n: int) -> tuple[np.ndarray, ...]:
    """M, G, and the symmetric and the skew part of K."""
    G, N = np.zeros((2, n, n))
    for i, j in combinations(range(n), 2):
        G[j, i], G[i, j] = values[f"g_{i}{j}"], -values[f"g_{i}{j}"]
        N[i, j], N[j, i] = values[f"n_{i}{j}"], -values[f"n_{i}{j}"]
    M, S = (np.diag([values[f"{name}_{i}"] for i in range(n)]) for name in "mk")
    return M, G, S, N


def grows(roots: np.ndarray) -> np.ndarray:
    """The λ that grow."""
    return roots[roots.real > 1e-6 * np.abs(roots).max()]


def of_matrices(kind: str, *given: np.ndarray) -> dict[str, Any]:
    """Onsets of growth above a threshold, and how many λ grow more on both sides."""
    M, G, S, N = given
    span, threshold = (0.05, 2.0), 1e-3

    def above(f: float) -> int:
        return int((polyeig(M, G, S + f * N).real > threshold).sum())

    p = ss.matrices(M=M, K=S, friction=N, G=G).Parameters(Omega=1.0)
    onsets = ss.flutter_onsets(p, "mu", between={"mu": span}, threshold=threshold)
    values, wrong = np.sort(onsets.mu), list[str]()
    for low, high in pairwise(np.linspace(*span, 400)):
        if above(low) != above(high) and not ((values >= low) & (values <= high)).any():
            wrong.append(f"no onset between {low} and {high}")
    for value, way in zip(onsets.mu, onsets.direction, strict=True):
        before, after = above(value - 1e-6), above(value + 1e-6)
        wrong += [f"{before}, {after} at {value}, {way}"] * ((after > before) != (way == "up"))
    return {
        "kind": f"5 {kind}",
        "wrong": wrong,
        "onsets": len(values),
        "changes": len(values),
        "undecided": len(onsets.undecided),
    }


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One random set: its type, and all values of f at which it begins or ceases to flutter."""
    n = 2 + number % 4
    kind = ("pairs", "any", "no force")[number // 4 % 3]
    side = rng.permutation([1] * ((n + 1) // 2) + [-1] * (n // 2))
    values = {f"{name}_{i}": float(rng.uniform(0.5, 3.0)) for name in "mk" for i in range(n)}
    for i, j in combinations(range(n), 2):
        g, f = rng.uniform(-1.0, 1.0, 2)
        across = side[i] != side[j]
        values[f"g_{i}{j}"] = float(g) if across or kind != "pairs" else 0.0
        values[f"n_{i}{j}"] = float(f) if not across or kind != "pairs" else 0.0
        if kind == "no force":
            values[f"n_{i}{j}"] = 0.0
    M, G, S, N = matrices(values, n)
    if n > 4:
        return of_matrices(kind, M, G, S, N)
    wrong, here = list[str](), float(rng.uniform(0.1, 2.0))
    within = {f"x_{i}": (-1.0, 1.0) for i in range(n)}
    p = model(n).Parameters(f=here, **values)
    eq = ss.equilibria(p, within=within)
    roots = grows(polyeig(M, G, S + here * N))
    expected = EquilibriumType.STABLE
    if roots.size:
        single = (np.abs(roots.imag) < 1e-7 * np.abs(roots)).all()
        expected = EquilibriumType.DIVERGENT if single else EquilibriumType.FLUTTER
    if eq.undamped[0] != expected or eq.marginal[0]:
        wrong.append(f"{EquilibriumType(eq.undamped[0]).name}, marginal {eq.marginal[0]}")

    def stable(f: float) -> bool:
        return not grows(polyeig(M, G, S + f * N)).size

    onsets = ss.flutter_onsets(p, "f", damping=False, between={"f": (0.05, 2.0)}, within=within)
    changes = []
    for low, high in pairwise(np.linspace(0.05, 2.0, 400)):
        if stable(low) != stable(high):
            below = stable(low)
            while high - low > 1e-10:
                middle = (low + high) / 2
                low, high = (middle, high) if stable(middle) == below else (low, middle)
            changes.append(low)
    lost = [f for f in changes if not (np.abs(onsets.f - f) < 1e-4).any()]
    wrong += [f"no onset at {f}" for f in lost]
    for f in onsets.f[onsets.kind != "detected"]:
        roots = polyeig(M, G, S + f * N)
        upper = roots[roots.imag > 1e-9 * np.abs(roots).max()]
        apart = np.abs(upper[:, None] - upper) + 9 * np.eye(len(upper))
        if apart.min() > 1e-4 * np.abs(upper).max():
            wrong.append(f"frequencies do not meet at {f}")
    never = any("some λ grows in every state" in one for one in onsets.remarks)
    if never and (expected == EquilibriumType.STABLE or changes):
        wrong.append("said to grow in every state")
    return {
        "kind": f"{n} {kind}",
        "wrong": wrong,
        "onsets": len(onsets.f),
        "changes": len(changes),
        "undecided": len(onsets.undecided),
    }
