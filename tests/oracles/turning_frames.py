"""A rotor in its own turning frame, a page as a user writes it, and the quadratic pencils of pages by hand."""

from typing import Any

import numpy as np
from scipy.linalg import eigvals

from tests.oracles.user_pages import model_of

#: With damping of the shaft, c_i, which turns, and of the ground, c_e, which stands: in the frame
#: c_e (q′ + Ω × q). The force p follows the displacement, turned by a right angle.
ROTOR = '''r"""A disc on a shaft.

::

    turns at W
"""

from spragsym.derive.model import Page

page = Page("A disc on a shaft, in the frame of the shaft.")

m = page.unit("m", "kg", "mass")
T = page.unit("T", "s", "unit of time")
L = page.unit("L", "m", "unit of length")
k_x = page.parameter("k_x", "N/m", "stiffness along x", "> 0", 1.0)
k_y = page.parameter("k_y", "N/m", "stiffness along y", "> 0", 2.25)
c_i = page.parameter("c_i", "N s/m", "damping of the shaft", ">= 0", 0.0)
c_e = page.parameter("c_e", "N s/m", "damping of the ground", ">= 0", 0.0)
g = page.parameter("g", "N/m^3", "hardening of the shaft", "real", 0.0)
f = page.parameter("f", "N/m", "force across the displacement", "real", 0.0)
W = page.parameter("W", "1/s", "speed of the frame", "real", 0.5)

x = page.coordinate("x", "m", "displacement")
y = page.coordinate("y", "m", "displacement across")
v, w = page.rate(x), page.rate(y)

page.kinetic(m * ((v - W * y) ** 2 + (w + W * x) ** 2) / 2)
page.spring(k_x, along=x)
page.spring(k_y, along=y)
page.potential(g * (x**2 + y**2) ** 2 / 4)
page.damper(c_i + c_e, along=x)
page.damper(c_i + c_e, along=y)
page.force((c_e * W - f) * y, along=x)
page.force((f - c_e * W) * x, along=y)
'''

#: Three coordinates with every gyroscopic term that there is, and a part without rates.
GYROSTAT = '''r"""Three masses that turn.

::

    g_1, g_2, g_3
"""

from spragsym.derive.model import Page

page = Page("Three masses with gyroscopic forces between all of them.")

m = page.unit("m", "kg", "mass")
T = page.unit("T", "s", "unit of time")
L = page.unit("L", "m", "unit of length")
k = [page.parameter(f"k_{i}", "N/m", "stiffness", "> 0", 1.0 + i) for i in (1, 2, 3)]
c = [page.parameter(f"c_{i}", "N s/m", "damping", ">= 0", 0.0) for i in (1, 2, 3)]
g = [page.parameter(f"g_{i}", "kg/s", "gyroscopic", "real", 0.5) for i in (1, 2, 3)]
f = page.parameter("f", "N/m", "force across the displacement", "real", 0.0)
h = page.parameter("h", "N/m", "what the speed of the frame takes from stiffness", ">= 0", 0.0)

q = [page.coordinate(name, "m", "displacement") for name in ("x", "y", "z")]
v = [page.rate(one) for one in q]

page.kinetic(
    m * (v[0] ** 2 + 2 * v[1] ** 2 + v[2] ** 2 + v[0] * v[1]) / 2
    + g[0] * (q[1] * v[2] - q[2] * v[1]) / 2 + g[1] * q[2] * v[0] + g[2] * q[0] * v[1]
    + h * (q[0] ** 2 + q[1] ** 2) / 2
)
for place, rate in enumerate(q):
    page.spring(k[place], along=rate)
    page.damper(c[place], along=rate)
page.force(-f * q[1], along=q[0])
page.force(f * q[0], along=q[1])
'''


def rotor() -> Any:
    """The model of the rotor."""
    return model_of(ROTOR, "rotor")


def gyrostat() -> Any:
    """The model of the three masses."""
    return model_of(GYROSTAT, "gyrostat")


def of_rotor(p: dict[str, Any]) -> list[np.ndarray]:
    """M, C, G and K of sets of the rotor, where it rests."""
    one = np.ones_like(p["W"])
    zero, c = 0 * one, p["c_i"] + p["c_e"]
    across = p["f"] - p["c_e"] * p["W"]
    return [
        np.moveaxis(np.array(rows), -1, 0)
        for rows in (
            [[one, zero], [zero, one]],
            [[c, zero], [zero, c]],
            [[zero, -2 * p["W"]], [2 * p["W"], zero]],
            [[p["k_x"] - p["W"] ** 2, across], [-across, p["k_y"] - p["W"] ** 2]],
        )
    ]


def of_gyrostat(p: dict[str, Any]) -> list[np.ndarray]:
    """M, C, G and K of sets of the three masses."""
    one = np.ones_like(p["f"])
    zero, f, h = 0 * one, p["f"], p["h"]
    g = [p[f"g_{i}"] for i in (1, 2, 3)]
    k, c = ([p[f"{name}_{i}"] for i in (1, 2, 3)] for name in "kc")
    M = [[one, one / 2, zero], [one / 2, 2 * one, zero], [zero, zero, one]]
    # a = (g_2 z, g_3 x − g_1 z/2, g_1 y/2), and G_ij = ∂a_i/∂q_j − ∂a_j/∂q_i.
    G = [[zero, -g[2], g[1]], [g[2], zero, -g[0]], [-g[1], g[0], zero]]
    C = [[c[0], zero, zero], [zero, c[1], zero], [zero, zero, c[2]]]
    K = [[k[0] - h, f, zero], [-f, k[1] - h, zero], [zero, zero, k[2]]]
    return [np.moveaxis(np.array(rows), -1, 0) for rows in (M, C, G, K)]


def polyeig(M: np.ndarray, B: np.ndarray, K: np.ndarray) -> np.ndarray:
    """λ of λ² M + λ B + K, by the generalized eigenvalues of its first companion form."""
    n = len(M)
    zero, unit = np.zeros((n, n)), np.eye(n)
    return eigvals(np.block([[zero, unit], [-K, -B]]), np.block([[unit, zero], [zero, M]]))


def drawn(
    model: Any, number: int, rng: np.random.Generator, still: str = ""
) -> dict[str, np.ndarray]:
    """Random sets, in which quantities whose names begin with a letter of ``still`` are 0."""
    spread = dict[str, np.ndarray]()
    for entry in model.about["parameters"]:
        values = rng.uniform(0.1, 3.0, number)
        if entry["low"] is None:
            values *= rng.choice([-1.0, 1.0], number)
        spread[entry["name"]] = 0 * values if entry["name"][0] in still else values
    return spread
