"""The report of a brake with every model: the same keys, what Python says in the file's units, and exports of every page."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

import spragsym as ss
from spragsym.models.load import shipped
from spragsym.studies.brake_quantities import scale_of
from tests.support import few

MODELS = shipped()
#: What one of each unit of the models is in the files.
SIZE = {"kg": 0.5, "N/m": 1.6e6, "m": 0.04}


def a_brake(name: str, folder: Path) -> tuple[Path, Any, float]:
    """A file with the base values of a model, 40 degrees where there is none; the same set; and a unit of length in metres."""
    model = ss.load(name)
    base = {**dict.fromkeys(model.parameters, math.radians(40.0)), **model.base}
    units = {entry["name"]: SIZE.get(entry["unit"], 800.0) for entry in model.about["units"]}
    bases = {entry["name"]: (units[entry["name"]], entry["unit"]) for entry in model.about["units"]}
    lines = [f'{name} = "{value!r} {unit}"' for name, (value, unit) in bases.items()]
    for entry in model.about["parameters"]:
        unit = entry["quantity_unit"]
        scale = 1.0 if unit in ("1", "rad") else scale_of(unit, bases)
        value = base[entry["name"]] * scale
        lines.append(f"{entry['quantity']} = {value!r}" if unit == "1" else f'{entry["quantity"]} = "{value!r} {unit}"')
    file = folder / "brake.toml"
    file.write_text(f'[brake]\nmodel = "{name}"\n' + "\n".join(lines) + "\n", encoding="utf-8")
    return file, model.Parameters(**base), scale_of("m", bases)


@pytest.mark.parametrize("name", few(MODELS, "two_springs", "stick_slip", "sprag_rod", "mode_coupling"))
def test_reports_have_the_same_keys_and_say_what_python_says(name: str, tmp_path: Path) -> None:
    file, p, length = a_brake(name, tmp_path)
    less = {"oscillation": False, "probability": False, "redesign": False}
    told = ss.Study.from_file(file).report(**less).to_dict()
    article = ss.Study.from_file(a_brake("kang_nam", tmp_path)[0]).report(**less).to_dict()
    assert list(told) == list(article)
    share = 1.0
    if "mu0" in p.model.parameters:
        share = told["mu_effective"] / float(p.mu0)
        assert 0.9 < share <= 1.0 + 1e-12
    eq = ss.equilibria(p.replace(mu0=share * p.mu0) if share < 1.0 else p)
    assert [state["stable"] for state in told["states"]] == eq.stable[: int(eq.count)].tolist()
    coordinate = p.model.about["coordinates"][0]
    key, unit = (
        (f"{coordinate['name']}_mm", 1e3 * length) if coordinate["unit"] == "m" else (f"{coordinate['name']}_deg", 180 / math.pi)
    )
    for slot, state in enumerate(told["states"]):
        assert state[key] == pytest.approx(unit * float(getattr(eq, coordinate["name"])[slot]), rel=1e-9)


def test_a_study_is_the_same_from_python_and_from_a_file(tmp_path: Path) -> None:
    for name in ("two_springs", "kang_nam"):
        file, _, _ = a_brake(name, tmp_path)
        read = ss.Study.from_file(file)
        made = ss.Study(read.values, model=name)
        assert made.dimensionless == read.dimensionless
        assert list(made.quantities) == list(read.quantities)
        less = {"oscillation": False, "probability": False, "redesign": False}
        assert made.report(**less).states == read.report(**less).states
    with pytest.raises(ss.ParameterError, match="'k_q' is no quantity of two_springs; it has m, k_c"):
        ss.Study({**read.values, "k_q": 1.0}, model="two_springs")
    with pytest.raises(ss.ParameterError, match="parameters are without theta0_2, k_2"):
        ss.Study(read.values, model="two_springs")
    with pytest.raises(ss.ParameterError, match="a study needs PhysicalParameters"):
        ss.Study(ss.load("two_springs").Parameters(), model="two_springs")


def test_two_springs_have_forces_lengths_and_directions(tmp_path: Path) -> None:
    """By hand: the tension of a spring is its stiffness times what it is longer than without load."""
    file, p, length = a_brake("two_springs", tmp_path)
    (state,) = ss.Study.from_file(file).report(oscillation=False, probability=False, redesign=False).states
    x, y = (state.places[name] / (1e3 * length) for name in ("x_mm", "y_mm"))
    assert list(state.spring_force_N) == list(state.spring_length_mm) == list(state.direction_deg) == ["spring 1", "spring 2"]
    for name, angle, stiffness, at_rest in (
        ("spring 1", p.theta0, p.sigma, 1.0), ("spring 2", p.theta0_2, p.sigma_2, float(p.lambda_2)),
    ):  # fmt: skip
        along, up = at_rest * math.cos(angle) - x, at_rest * math.sin(angle) - y
        assert state.spring_length_mm[name] == pytest.approx(1e3 * length * math.hypot(along, up))
        assert state.direction_deg[name] == pytest.approx(math.degrees(math.atan2(up, along)))
        force = SIZE["N/m"] * length * float(stiffness) * (math.hypot(along, up) - at_rest)
        assert state.spring_force_N[name] == pytest.approx(force)
