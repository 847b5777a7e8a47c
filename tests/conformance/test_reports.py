"""The report of a brake with every model: the same keys, what Python says in the file's units, and
exports of every page.
"""

import math
from functools import cache, partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from click.testing import CliRunner

import spragsym as ss
from spragsym.cli.pages import explore, report
from spragsym.models.quantities import quantities
from tests.conformance.models import ALIKE, MODELS, a_set, answers, load, place
from tests.support import few

#: What one of each unit of the models is in the files.
SIZE = {"kg": 0.5, "N/m": 1.6e6, "m": 0.04}
#: What reports take longest for is left out of these.
LESS = {"oscillation": False, "probability": False, "redesign": False}


def a_brake(name: str, folder: Path) -> tuple[Path, Any, float]:
    """A file with the base values of a model, 40 degrees where there is none; the same set; and a
    unit of length in metres.
    """
    model, p, kind = load(name), a_set(name), quantities(place(name))
    units = {entry["name"]: SIZE.get(entry["unit"], 800.0) for entry in model.about["units"]}
    bases = {entry["name"]: (units[entry["name"]], entry["unit"]) for entry in model.about["units"]}
    lines = [f'{name} = "{value!r} {unit}"' for name, (value, unit) in bases.items()]
    for entry in model.about["parameters"]:
        unit = entry["quantity_unit"]
        scale = 1.0 if unit in ("1", "rad") else kind.scale(unit, units)
        value = float(p[entry["name"]]) * scale
        lines.append(
            f"{entry['quantity']} = {value!r}"
            if unit == "1"
            else f'{entry["quantity"]} = "{value!r} {unit}"'
        )
    file = folder / "brake.toml"
    file.write_text(
        f'[brake]\nmodel = "{Path(place(name)).as_posix()}"\n' + "\n".join(lines) + "\n",
        encoding="utf-8",
    )
    return file, p, kind.scale("m", units)


@cache
def keys_of_the_article() -> list[str]:
    """Those of the report on a brake with the article's model."""
    with TemporaryDirectory() as folder:
        return list(
            ss.Study.from_file(a_brake("kang_nam", Path(folder))[0]).report(**LESS).to_dict()
        )


@pytest.mark.by_hand("soft_brake", "two_springs", "sprag_rod", *ALIKE)
@pytest.mark.parametrize("name", few(MODELS, "stick_slip", "mode_coupling"))
def test_reports_have_the_same_keys_and_say_what_python_says(name: str, tmp_path: Path) -> None:
    file, p, length = a_brake(name, tmp_path)
    study = ss.Study.from_file(file, trust=True)
    if not answers(p.model, "report", lambda: study.report(**LESS)):
        return
    told = study.report(**LESS).to_dict()
    assert list(told) == keys_of_the_article()
    if p.model.coefficient is not None:
        works = float(p.model.friction(p, contact=p.model.rubbing[0]))
        assert told["mu_effective"] == pytest.approx(works, rel=1e-12)
        if (
            p.model.frictions[0]["at_rest"] == "full"
        ):  # else equilibria take the law at the belt's speed by themselves
            p = p.replace(**{p.model.coefficient: works})
    eq = ss.equilibria(p)
    said = [state["stability"] for state in told["states"]]
    assert said == eq.stability[: int(eq.count)].tolist()
    coordinate = p.model.about["coordinates"][0]
    key, unit = (
        (f"{coordinate['name']}_mm", 1e3 * length)
        if coordinate["unit"] == "m"
        else (f"{coordinate['name']}_deg", 180 / math.pi)
    )
    for slot, state in enumerate(told["states"]):
        assert state[key] == pytest.approx(
            unit * float(getattr(eq, coordinate["name"])[slot]), rel=1e-9
        )


@pytest.mark.by_hand(*ALIKE)
@pytest.mark.parametrize("name", few(MODELS, "stick_slip", "kang_nam"))
def test_every_model_has_a_file_to_begin_with(name: str, tmp_path: Path) -> None:
    file = tmp_path / "brake.toml"
    done = CliRunner().invoke(report, ["--example", "--model", place(name)])
    assert done.exit_code == 0, done.exception
    file.write_text(done.stdout, encoding="utf-8")
    study = ss.Study.from_file(file, trust=True)
    assert study.model == place({"kang_nam": "damped"}.get(name, name))  # it has a damping ratio
    model = study.kind.model
    assert list(study.quantities) == [one["name"] for one in model.about["units"]] + [
        one["quantity"] for one in model.about["parameters"]
    ]
    out = tmp_path / "page.html"
    words = ["--data", str(file), "--trust", "--out", str(out), "--no-open"]
    drawn = partial(CliRunner().invoke, explore, words, catch_exceptions=False)
    if answers(model, "explore", drawn):
        assert drawn().exit_code == 0
    assert isinstance(CliRunner().invoke(report, ["--model", place(name)]).exception, SystemExit)
