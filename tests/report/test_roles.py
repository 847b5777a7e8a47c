"""A page whose friction and inclination have other names is asked and reported as the article's."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.report.example import example
from tests.oracles.user_pages import derived

PAGE = Path(__file__).parents[2] / "derive/models/kang_nam.py"


def renamed(text: str) -> str:
    """With ``mu`` for ``mu0`` and ``lean`` for ``theta0``."""
    return re.sub(r"\btheta0\b", "lean", re.sub(r"\bmu0\b", "mu", text))


@pytest.fixture(scope="module")
def page() -> Any:
    """The article's page with other names, and its model without closed forms."""
    pytest.importorskip("sympy")
    text = renamed(PAGE.read_text(encoding="utf-8")).replace("from ..model", "from derive.model")
    text = text.replace("from derive.model", "from spragsym.derive.model")
    return derived(text, "renamed")


def test_names_of_friction_and_inclination_do_not_matter(page: Any) -> None:
    """Defaults of what varies and rises are those of the article's page."""
    model, own = ss.load(page), ss.load("kang_nam").search
    assert (model.coefficient, model.inclination) == ("mu", "lean")
    assert model.axes == ("lean", "mu")
    assert model.frictions[0]["at_rest"] == own.frictions[0]["at_rest"] == "full"
    p, q = model.Parameters(lean=0.7), own.Parameters(theta0=0.7)
    assert float(ss.jump_value(p)) == pytest.approx(float(ss.jump_value(q)), rel=1e-9)
    assert ss.folds(p).vary == ("lean",)
    assert np.allclose(ss.folds(p)["lean"], ss.folds(q)["theta0"], rtol=1e-12)


@pytest.mark.validate
def test_the_report_is_the_same_but_for_the_names(page: Any, tmp_path: Path) -> None:
    """Every fact and every sentence."""
    texts = []
    for name, data in (("kang_nam", str), ("lean", renamed)):
        file = tmp_path / f"{name}.toml"
        said = re.sub("damping_ratio.*\n", "", data(example(ss.load("kang_nam"))))
        where = "kang_nam" if name == "kang_nam" else str(page)
        file.write_text(re.sub(r'model = ".*"', f"model = '{where}'", said), encoding="utf-8")
        study = ss.Study.from_file(file, trust=True)
        texts.append(study.report(oscillation=False, probability=False, redesign=False).to_dict())
    one, other = texts
    plain = {key for key, value in one.items() if isinstance(value, float | str | bool)}
    assert {"mu0_jump", "theta0_jump_deg", "mu_lowest", "mu_cusp"} <= plain
    for key in plain - {"model", "source"}:
        told = other[key]
        told = told.replace(" with the model renamed", "") if isinstance(told, str) else told
        if isinstance(told, float):
            assert told == pytest.approx(one[key], rel=1e-6, nan_ok=True), key
        else:
            known = renamed(one[key]) if isinstance(told, str) else one[key]
            assert told == known, key
