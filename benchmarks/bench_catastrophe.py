"""The whole bifurcation set against a continuation as one would write it with SciPy; a Markdown
table.

``python -m benchmarks.bench_catastrophe``
"""

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import math

import numpy as np
from scipy.optimize import fsolve

import spragsym as ss
from benchmarks.timing import best
from spragsym.generated.equilibrium import f, f_coefficients, f_slope
from spragsym.kang_nam.kernel import Fixed

BASE = ss.Parameters.article()
_FIXED = Fixed(0.007, 0.007, 0.1, 0.0)


def main() -> None:
    """Print the table."""
    points = sum(curve.theta.size for curve in ss.bifurcation_set(BASE, n=5000).curves)
    found = continuation()
    rows: list[tuple[str, int, float]] = [
        (
            "ours: fold curves and cusps, proved",
            points,
            best(lambda: ss.bifurcation_set(BASE, n=5000)),
        ),
        ("ours: all folds at one friction, proved", 2, best(lambda: ss.folds(BASE))),
        ("ours: all cusps, proved", 4, best(lambda: ss.cusps(BASE))),
        (
            "ours: flutter boundary (sigma = 1)",
            2000,
            best(lambda: ss.kang_nam.flutter_boundary(ss.Parameters.article(sigma=1.0))),
        ),
        ("ours: the complete set", points, best(_everything)),
        ("SciPy: fsolve along one fold curve from a given fold", len(found), best(continuation, 3)),
    ]
    print("| what | points | ms | µs a point |")
    print("|---|---|---|---|")
    for name, number, seconds in rows:
        print(f"| {name} | {number:,} | {1e3 * seconds:.1f} | {1e6 * seconds / number:.1f} |")
    print(
        f"\nThe continuation follows one curve of two, through the cusp, in {len(found)} "
        "points; it says nothing of others."
    )


def _everything() -> None:
    p = ss.Parameters.article(sigma=1.0)
    ss.bifurcation_set(p, n=5000)
    ss.kang_nam.flutter_boundary(p)
    ss.critical_friction(p)


def continuation(steps: int = 1000, step: float = 0.01) -> list[tuple[float, float, float]]:
    """Pseudo-arclength on f = f′ = 0 in (θ, θ₀, μ₀) from the left fold at μ₀ = 0.5, through the
    cusp.
    """
    kappa, alpha, sigma, beta = _FIXED

    def residual(z: np.ndarray) -> tuple[float, float]:
        abdm = f_coefficients(math.cos(z[1]), math.sin(z[1]), z[2], kappa, alpha, sigma, beta, 1)
        c, s = math.cos(z[0]), math.sin(z[0])
        return f(c, s, *abdm), f_slope(c, s, *abdm)

    point = np.array([0.9776286848725, math.radians(44.5593177025653), 0.5])
    tangent = np.array([0.3, 0.6, -0.7])
    found = [(float(point[0]), float(point[1]), float(point[2]))]
    for _ in range(steps):
        guess = point + step * tangent

        def closed(
            z: np.ndarray, guess: np.ndarray = guess, tangent: np.ndarray = tangent
        ) -> list[float]:
            return [*residual(z), float(np.dot(z - guess, tangent))]

        new = fsolve(closed, guess, xtol=1e-13)
        tangent = (new - point) / np.linalg.norm(new - point)
        point = new
        found.append((float(point[0]), float(point[1]), float(point[2])))
        if not 0 < point[1] < math.pi or point[2] < 0:
            break
    return found


if __name__ == "__main__":
    main()
