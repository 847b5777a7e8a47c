"""The model's names, meanings, units and ranges: written once, true, and read by everything that says them."""

from __future__ import annotations

import ast
import math
import re
from pathlib import Path

import pytest
from click.testing import CliRunner

import spragsym as ss
from spragsym.cli import cli
from spragsym.files import storage
from spragsym.generated import scales
from spragsym.generated.quantities import BASE_VALUES, PARAMETERS, QUANTITIES
from spragsym.models.load import shipped
from spragsym.parameters import RANGES, range_of
from tests.support import ROOT


def literals(path: Path) -> set[str]:
    """Strings of a module that are not docstrings."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    docstrings = {
        id(node.body[0].value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Module | ast.FunctionDef | ast.ClassDef) and isinstance(node.body[0], ast.Expr)
    }
    return {
        node.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docstrings
    }


def test_no_meaning_is_typed_again() -> None:
    """A phrase of the nomenclature stands in no string of the runtime, so that a change of it is seen everywhere."""
    phrases = {quantity.meaning.lower() for quantity in QUANTITIES.values() if " " in quantity.meaning}
    assert "friction coefficient at full slip" in phrases
    folders = [path for path in (ROOT / "spragsym").iterdir() if not path.is_symlink()]
    files = [file for path in folders for file in (path.rglob("*.py") if path.is_dir() else [path]) if file.suffix == ".py"]
    assert len(files) > 50
    for file in files:
        # Parsed where a phrase may be in it, strings that are joined taken as one.
        joined = re.sub(r'"\s*f?"', "", file.read_text(encoding="utf-8").lower())
        for text in literals(file) if any(phrase in joined for phrase in phrases) else ():
            assert text.lower().rstrip(".") not in phrases, f"{file.relative_to(ROOT)}: {text!r}"


def test_help_and_files_say_what_the_nomenclature_says() -> None:
    assert "Friction coefficient at full slip." in CliRunner().invoke(cli, ["equilibria", "--help"]).output
    said = ss.load("kang_nam").quantities
    assert storage.attributes("y", said) == {"units": "L_0", "long_name": "displacement across the belt, negative into the belt"}
    assert storage.attributes("kappa", said) == {"units": "L_0*k_c", "long_name": "preload that presses the mass on the belt"}


@pytest.mark.parametrize("name", shipped())
def test_files_say_what_one_of_each_number_is(name: str) -> None:
    """Of parameters by the quantities of the page, in any units of measure; of results by those of what they are made of."""
    from spragsym.studies import brake_quantities

    model = ss.load(name)
    about, said = model.about, model.quantities
    bases = dict(zip((entry["name"] for entry in about["units"]), (0.3, 7.0e5, 0.05), strict=False))
    sizes = {**bases, "sqrt": math.sqrt, "rad": 1.0}
    given = {entry["quantity"]: 0.1 * (place + 1) for place, entry in enumerate(about["parameters"])}
    p, _ = brake_quantities.dimensionless(name, {**given, **bases})

    def one_of(key: str) -> float:
        return float(eval(said[key][0], {}, sizes))  # noqa: S307  # written by the derivation

    for entry in about["parameters"]:
        assert float(getattr(p, entry["name"])) * one_of(entry["name"]) == pytest.approx(given[entry["quantity"]], rel=1e-12)
    first = model.coordinates[0]
    assert {said[key][0] for key in ("rms", "mean", f"cycle_{first}", f"rest_{first}", first, f"{first}0")} == {said["rms"][0]}
    assert one_of("period") * one_of("rate") == pytest.approx(1.0)
    assert all(first in said[key][1] for key in ("rms", "largest", f"cycle_{first}"))


@pytest.mark.parametrize("name", ["x", "y", "L", "vx", "vy", "V", "d", "tau"])
def test_units_are_the_scales_of_the_model(name: str) -> None:
    """What a unit says, computed, is the product of the scales of length and time that were derived."""
    m, k_c, L_0 = 0.3, 7.0e5, 0.05
    length, time, _ = scales.scales(m, k_c, L_0)
    derived = {"x": length, "y": length, "L": length, "vx": length / time, "vy": length / time, "V": length / time,
               "d": time / length, "tau": time}[name]  # fmt: skip
    said = QUANTITIES[name].unit.replace("L_0 sqrt", "L_0 * sqrt")
    value = eval(said, {"L_0": L_0, "m": m, "k_c": k_c, "sqrt": math.sqrt})  # noqa: S307  # our own table
    assert value == pytest.approx(derived, rel=1e-15)


def test_ranges_keep_out_what_has_no_meaning() -> None:
    """The ends of each range, tried: the equations need 0 < θ₀ < π, κ, σ > 0 and allow α = β = μ₀ = 0."""
    base = {"theta0": 1.0, **BASE_VALUES}
    assert tuple(base) == PARAMETERS
    for name in ("alpha", "beta", "mu0"):
        ss.Parameters(**{**base, name: 0.0})
    for name, value in {"theta0": 0.0, "kappa": 0.0, "sigma": 0.0, "mu0": -1e-300, "alpha": -1e-300, "beta": -1e-300}.items():
        with pytest.raises(ss.ParameterError, match=name):
            ss.Parameters(**{**base, name: value})
    with pytest.raises(ss.ParameterError, match="theta0"):
        ss.Parameters(**{**base, "theta0": math.pi})
    assert str(RANGES["theta0"]) == "(0, pi)"
    assert str(range_of("V_dim")) == "(-inf, inf)"


def test_a_domain_that_is_not_one_is_refused() -> None:
    pytest.importorskip("sympy")
    from spragsym.derive.emit.quantities import Interval, interval

    assert interval(">= 0") == Interval(0.0, low_open=False)
    assert interval("(0, pi)") == Interval(0.0, math.pi)
    assert interval("[-1, 1]") == Interval(-1.0, 1.0, False, False)
    with pytest.raises(ValueError, match="is not a domain"):
        interval("positive")


def test_a_name_is_given_once() -> None:
    pytest.importorskip("sympy")
    from spragsym.derive.kang_nam import nomenclature

    with pytest.raises(ValueError, match="kappa stands in the nomenclature twice"):
        nomenclature._define("kappa", "k", "another preload")
