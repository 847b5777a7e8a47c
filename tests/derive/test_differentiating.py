"""JAX and CasADi: precisions of 32 and 64 bits, and one side of every border."""

import inspect
import sys
from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

pytest.importorskip("sympy")

from spragsym.derive import export, pages
from spragsym.models.load import shipped

Functions = Mapping[str, Callable[..., Any]]


def functions_of(page: Path, language: str) -> Functions:
    """The functions of a page's export."""
    pytest.importorskip(language)
    text = export.export(page, page.stem, language)[f"{page.stem}.py"]
    exec(text, space := {})
    own = {name: it for name, it in space.items() if inspect.isfunction(it)}
    return {name: it for name, it in own.items() if not name.startswith("_")}


def leaves(result: Any) -> list[Any]:
    if isinstance(result, list):
        return [leaf for item in result for leaf in leaves(item)]
    return [result]


@pytest.mark.thorough
@pytest.mark.parametrize("language", ["jax", "casadi"])
def test_springs_follow_the_place(language: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """With the page's names, by NumPy in the library's place: differences of the forces are their
    Jacobian.
    """
    numpy_instead = {"jax": SimpleNamespace(numpy=np), "jax.numpy": np, "casadi": np}
    for module, instead in numpy_instead.items():
        monkeypatch.setitem(sys.modules, module, instead)
    text = export.export(pages.SHIPPED / "kang_nam.py", "kang_nam", language)["kang_nam.py"]
    exec(text, brake := {})
    given = {"theta0": 0.9, "mu": 0.3, "kappa": 0.02, "alpha": 0.03, "sigma": 0.2, "beta": 0.1}

    def forces(x: float, y: float) -> Any:
        return np.array(brake["forces"](x, y, pushing=1.0, **given))

    x, y, step = 0.1, -0.04, 1e-5
    by_x = (forces(x + step, y) - forces(x - step, y)) / (2 * step)
    by_y = (forces(x, y + step) - forces(x, y - step)) / (2 * step)
    jacobian = brake["forces_jacobian"](x, y, pushing=1.0, **given)
    np.testing.assert_allclose(np.transpose([by_x, by_y]), jacobian, atol=1e-8)


@pytest.mark.by_hand(*shipped())
@pytest.mark.parametrize("name", shipped())
def test_all_functions_of_a_model_are_right_in_either_precision(name: str) -> None:
    pytest.importorskip("jax")
    check_precisions(functions_of(pages.SHIPPED / f"{name}.py", "jax"), np.random.default_rng(75))


def check_precisions(functions: Functions, rng: np.random.Generator) -> None:
    """All functions and derivatives under jit, grad and vmap; 32 bits are within rounding of 64."""
    jax = pytest.importorskip("jax")
    taken = {it: list(inspect.signature(function).parameters) for it, function in functions.items()}
    names = sorted({one for of in taken.values() for one in of})

    def whole(values: Any) -> Any:
        given = dict(zip(names, values, strict=True))
        results = [
            leaf
            for it, function in functions.items()
            for leaf in leaves(function(*(given[one] for one in taken[it])))
        ]
        return jax.numpy.stack([jax.numpy.asarray(one, values.dtype) for one in results])

    def told(values: Any) -> Any:
        return whole(values), jax.jacrev(whole)(values)

    given = rng.uniform(0.2, 0.9, (4, len(names))).astype(np.float32)
    flags = [one in ("pushing", "side") or one.startswith(("near", "way")) for one in names]
    given[:, flags] = 1.0
    given[:, [one == "y" for one in names]] *= -1.0  # the contact's side
    given[0, [one == "pushing" for one in names]] = 0.0
    found = {}
    for bits in (32, 64):
        with jax.enable_x64(bits == 64):
            result = jax.jit(jax.vmap(told))(given.astype(f"f{bits // 8}"))
            found[bits] = [np.asarray(part) for part in result]
        assert {part.dtype for part in found[bits]} == {np.dtype(f"f{bits // 8}")}
    for ours, theirs in zip(found[32], found[64], strict=True):
        assert np.isfinite(theirs).all()
        size = np.abs(theirs).reshape(4, -1).max(axis=1)
        error = np.abs(ours - theirs).reshape(4, -1).max(axis=1)
        assert (error <= 16 * 2.0**-23 * size).all()


PAGE = '''"""A mass that falls on a belt."""
from sympy import Rational
from spragsym.derive.model import Abs, Page, exp, log, sgn, sqrt, tanh
page = Page("A mass that falls on a belt.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
L_0 = page.unit("L_0", "m", "length")
P = page.parameter("P", "N", "load", "> 0", 0.1)
k_x = page.parameter("k_x", "N/m", "stiffness", "> 0", 0.2)
mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.5)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
v_s = page.parameter("v_s", "m/s", "speed of the friction law", "> 0", 0.3)
x = page.coordinate("x", "m", "along the belt")
y = page.coordinate("y", "m", "across the belt")
page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.spring(k_x, along=x)
page.force(0, -P, at=(x, y))
page.contact(y, lambda depth: {contact})
page.friction(x, V, {friction})
'''
RISES = "lambda v: mu0 * (1 - exp(-Abs(v) / v_s)) * sgn(v), at_rest=mu0"
HOLDS = "slip=lambda v: mu0 * exp(-Abs(v) / v_s) * sgn(v), holds=mu0"


def of_page(folder: Path, language: str, contact: str, friction: str) -> Functions:
    page = folder / "falling.py"
    page.write_text(PAGE.format(contact=contact, friction=friction), encoding="utf-8")
    return functions_of(page, language)


@pytest.mark.by_hand("1", "2", "3")
@pytest.mark.thorough
@pytest.mark.parametrize("seed", range(4))
def test_jax_takes_any_root_or_logarithm_in_the_contact(seed: int, tmp_path: Path) -> None:
    """Laws drawn at random; the depth in lift-off was a whole number beyond 32 bits."""
    rng = np.random.default_rng([75, seed])
    top, under = rng.integers(3, 8, 2)
    power = f"(depth / L_0) ** (1 + Rational({top}, {under}))"
    law = [power, "log(1 + depth / L_0)", "depth / L_0 * sqrt(depth / L_0)"][rng.integers(3)]
    check_precisions(of_page(tmp_path, "jax", f"k_c * L_0 * {law}", RISES), rng)


@pytest.mark.thorough
@pytest.mark.parametrize("language", ["jax", "casadi"])
@pytest.mark.parametrize(("friction", "side"), [(RISES, 1.0), (HOLDS, 0.0)], ids=["rises", "holds"])
def test_a_border_has_the_derivatives_of_contact_and_of_the_belt_ahead(
    friction: str, side: float, language: str, tmp_path: Path
) -> None:
    """At y = 0 and x' = V: of differences into that side, and of the regime."""
    pytest.importorskip(language)
    rng = np.random.default_rng(14)
    functions = of_page(tmp_path, language, "k_c * depth", friction)
    rhs, regime = functions["rhs"], functions["regime_jacobian"]
    given = dict(zip(inspect.signature(rhs).parameters, rng.uniform(0.2, 0.9, 9), strict=True))
    felt = [1.0] * (len(inspect.signature(regime).parameters) - len(given) - 2)

    def at(values: Mapping[str, float]) -> Any:
        with precisely(language):
            return np.array(leaves(rhs(*values.values())), dtype=float).ravel()

    for depth in (0.0, 0.3) if side else (0.3,):
        here = given | {"x": 0.01, "y": -depth, "vx": given["V"]}
        slopes = derivatives(language, rhs, list(here.values()))
        ways = [("x", 1e-6), ("y", -1e-6), ("vx", -1e-6), ("vy", 1e-6)]
        for place, (name, step) in enumerate(ways if side else ways[:2]):
            expected = (at(here | {name: here[name] + step}) - at(here)) / step
            np.testing.assert_allclose(slopes[:, place], expected, atol=1e-5, err_msg=name)
        with precisely(language):
            one_side = np.array(leaves(regime(*here.values(), 1.0, side, *felt)), dtype=float)
        np.testing.assert_allclose(slopes[:, :4], one_side.reshape(2, 4), rtol=1e-12, atol=1e-12)


def precisely(language: str) -> AbstractContextManager[Any]:
    """64 bits."""
    return pytest.importorskip("jax").enable_x64(True) if language == "jax" else nullcontext()


def derivatives(language: str, function: Any, given: list[float]) -> Any:
    """Of a function's results by all that it is given."""
    if language == "jax":
        import jax

        with precisely(language):
            return np.array(jax.jacfwd(lambda v: jax.numpy.array(function(*v)))(np.array(given)))
    import casadi

    values = casadi.SX.sym("v", len(given))
    slope = casadi.jacobian(casadi.vertcat(*function(*casadi.vertsplit(values))), values)
    return np.array(casadi.Function("slope", [values], [slope])(given))
