"""Two masses that are the same, on one belt and tied to one another."""

import hashlib
import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.user_pages import derived

pytest.importorskip("sympy")

#: k x + t (x − z) = μ F e^(2x), and the same with x and z in each other's place.
TWINS = r'''r"""Two equal masses on a belt, tied to one another; each presses the harder the farther it is."""
from spragsym.derive.model import Abs, Page, exp, sgn

page = Page("Two equal masses on a belt, tied to one another.")
m, K, L = page.unit("m", "kg", "each mass"), page.unit("K", "N/m", "stiffness"), page.unit("L", "m", "length")
mu = page.parameter("mu", "1", "friction coefficient", ">= 0", 0.3)
F = page.parameter("F", "N", "load of each", "> 0", 0.01)
k = page.parameter("k", "N/m", "stiffness along", "> 0", 0.02)
t = page.parameter("t", "N/m", "tie", ">= 0", 0.005)
V, d = page.parameter("V", "m/s", "speed of the belt", ">= 0", 0.5), page.parameter("d", "s/m", "steepness", "> 0", 10.0)
x, z = page.coordinate("x", "m", "first"), page.coordinate("z", "m", "second")
page.kinetic(m * (page.rate(x) ** 2 + page.rate(z) ** 2) / 2)
page.spring(k, along=x)
page.spring(k, along=z)
page.spring(t, along=x - z)
law = lambda v: mu * (1 - exp(-d * Abs(v))) * sgn(v)
one = page.normal_force(F * exp(2 * x / L), name="one")
two = page.normal_force(F * exp(2 * z / L), name="two")
page.friction(x, V, law, at_rest=mu, on=one)
page.friction(z, V, law, at_rest=mu, on=two)
'''


def test_friction_that_feels_its_own_coordinate_alone_brings_no_flutter() -> None:
    """K is symmetric with it, also where two λ are the same."""
    p = ss.load(derived(TWINS, "twins")).Parameters()
    around = {"mu": (0.0, 0.3), "t": (0.0049, 0.0051)}
    assert ss.certify(p, "no flutter", between=around).outcome == "proved"
    eq = ss.equilibria(p)
    x, z = eq["x"][0], eq["z"][0]
    K = np.diag([0.025 - 0.006 * np.exp(2 * x), 0.025 - 0.006 * np.exp(2 * z)])
    K -= 0.005 * (1 - np.eye(2))
    frequencies = np.sort(np.abs(eq.eigenvalues[0].imag))[::2]
    np.testing.assert_allclose(frequencies**2, np.linalg.eigvalsh(K), rtol=1e-12)


def test_a_folder_of_another_version_says_so(tmp_path: Path) -> None:
    folder = shutil.copytree(derived(TWINS, "twins"), tmp_path / "twins")
    about = json.loads((folder / "model.json").read_text())
    del about["circulatory"]
    text = json.dumps(about | {"digest": "<digest-of-all>".ljust(64, "-")})
    digest = hashlib.sha256(text.encode()).hexdigest()
    (folder / "model.json").write_text(re.sub("<digest-of-all>-*", digest, text))
    with pytest.raises(
        ss.errors.StoreError, match=r"another version .* not say circulatory; derive"
    ):
        ss.load(folder)
