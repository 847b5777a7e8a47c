"""A page whose parameter has a name of the generated functions' own, as μ, held against a page that
calls it otherwise.
"""

import subprocess
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("sympy")

from scipy.integrate import solve_ivp

import spragsym as ss
from spragsym.cli import main
from tests.oracles.exports import CC
from tests.oracles.user_pages import derived, model_of

PAGE = '''r"""A mass on a belt, on a spring that is stiffer by the same number.

::

    m
"""

from spragsym.derive.model import Abs, Page, exp, sgn

page = Page("A mass on a belt.")

m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
N = page.unit("N", "N", "normal force")
own = page.parameter("NAME", "1", "friction coefficient", "DOMAIN", 0.4)
d = page.parameter("d", "s/m", "steepness", "> 0", 3.0)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)

x = page.coordinate("x", "m", "displacement")

page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.potential(own * k * x**2)
page.normal_force(N)
page.friction(x, V, lambda v: own * (1 - exp(-d * Abs(v))) * sgn(v))
'''


def field(_: float, u: np.ndarray) -> list[float]:
    """The motion at the base values, by hand."""
    slip = 0.5 - u[1]
    return [u[1], 0.4 * np.sign(slip) * (1 - np.exp(-3 * abs(slip))) - 1.8 * u[0]]


@pytest.mark.parametrize("domain", [">= 0", "real"])
@pytest.mark.parametrize("name", ["mu", "side", "pushing", "other"])
def test_a_parameter_may_be_called_as_what_functions_take(name: str, domain: str) -> None:
    """Equilibrium 0.4 (1 − exp(−1.5))/1.8, and the motion by SciPy."""
    text = PAGE.replace("NAME", name).replace("DOMAIN", domain)
    p = model_of(text, "own").Parameters()
    assert float(ss.equilibria(p)["x"][0]) == pytest.approx(
        0.4 * (1 - np.exp(-1.5)) / 1.8, rel=1e-12
    )
    run = solve_ivp(field, (0.0, 5.0), [0.1, 0.0], "DOP853", rtol=1e-11, atol=1e-12)
    found = ss.simulate(p, x0=0.1, t_end=5.0).state[:, -1]
    np.testing.assert_allclose(found, run.y[:, -1], atol=1e-9)


@pytest.mark.thorough
@pytest.mark.skipif(CC is None, reason="there is no C compiler")
def test_its_export_to_c_is_compiled_and_moves(tmp_path: Path) -> None:
    text = PAGE.replace("NAME", "mu").replace("DOMAIN", ">= 0")
    with pytest.raises(SystemExit, match="0"):
        main(["export", "--model", str(derived(text, "own")), "--out", str(tmp_path)])
    subprocess.run(["make", "-s"], cwd=tmp_path, check=True, timeout=120)
    done = subprocess.run(["./example"], cwd=tmp_path, check=True, capture_output=True, text=True)
    said = done.stdout.splitlines()[2].split()
    assert said[:2] == ["time", "8.0"]
    run = solve_ivp(field, (0.0, 8.0), [0.0, 0.0], "DOP853", rtol=1e-11, atol=1e-12)
    assert float(said[said.index("x") + 1]) == pytest.approx(run.y[0, -1], abs=1e-7)
