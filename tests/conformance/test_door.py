"""Every set of parameters knows its model, and a function asked for one model never answers for another."""

from __future__ import annotations

import copy
import inspect
import math
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym import door
from spragsym.models.load import shipped
from spragsym.parameters import NAMES

OTHERS = [name for name in shipped() if name != "kang_nam"]


def a_set(name: str) -> Any:
    """Base values of a model; an angle of 40 degrees where there is none."""
    model = ss.load(name)
    return model.Parameters(**({"theta0": math.radians(40.0)} if "theta0" in model.parameters else {}))


# ------------------------------------------------------------------------------------------- sets and their models


def test_the_articles_parameters_are_those_of_its_model() -> None:
    model = ss.load("kang_nam")
    assert ss.Parameters is model.Parameters
    assert model.parameters == (*NAMES, "V", "d") == tuple(ss.Parameters.ranges)
    assert ss.Parameters() == ss.Parameters.article() == ss.Parameters(**model.base)
    assert {name: float(getattr(ss.Parameters(), name)) for name in model.base} == model.base


@pytest.mark.parametrize("name", shipped())
def test_a_set_knows_its_model(name: str) -> None:
    p, model = a_set(name), ss.load(name)
    for other in (p, p.replace(**{model.parameters[1]: 0.1}), copy.deepcopy(p), pickle.loads(pickle.dumps(p))):  # noqa: S301
        assert other.model is model
        assert type(other) is model.Parameters
    assert pickle.loads(pickle.dumps(p)) == p  # noqa: S301  # our own bytes


def test_a_set_of_another_process_knows_its_model() -> None:
    """There the model is loaded by the set alone."""
    program = "import pickle, sys; p = pickle.load(sys.stdin.buffer); print(p.model.name, p.model.parameters == tuple(p.ranges))"
    for name in ("kang_nam", "two_springs"):
        done = subprocess.run([sys.executable, "-c", program], input=pickle.dumps(a_set(name)), capture_output=True, check=True)
        assert done.stdout.split() == [name.encode(), b"True"]


@pytest.mark.parametrize("shape", [(), (3,), (2, 1)])
def test_V_and_d_are_parameters_like_others(shape: tuple[int, ...]) -> None:
    p = ss.Parameters.article(theta0=0.7, V=np.full(shape, 0.25), d=4.0)
    assert p.shape == shape
    assert np.array_equal(ss.equilibria(p).count, np.broadcast_to(ss.equilibria(p.replace(V=0.5, d=10.0)).count, shape))
    assert ss.rms_sweep(p, t_end=1.0).rms.shape == shape


# ------------------------------------------------------------------------------------- answers that two worlds gave


def test_equilibria_of_two_springs_are_not_those_of_one() -> None:
    q = ss.load("two_springs").Parameters(theta0=math.radians(40.0), sigma_2=0.3)
    assert int(ss.count(q)) == int(ss.equilibria(q).count) == 1
    assert int(ss.count(ss.Parameters(*(getattr(q, name) for name in NAMES)))) == 3


def test_folds_of_a_cubic_contact_are_not_those_of_a_linear_one() -> None:
    p = a_set("cubic_contact").replace(gamma=3000.0)
    assert ss.folds(p, "mu0").mu0.round(4).tolist() == [0.5998]
    with pytest.raises(ss.ModelError, match=r"jump_value is not there yet for the model cubic_contact; ss\.quasi_static_path"):
        ss.jump_value(p)
    assert round(ss.quasi_static_path(p, "mu0", [0.0, 1.0]).jumps[0].value, 4) == 0.5998


@pytest.mark.parametrize("function", [name for name, instead in door.INTERFACE.items() if instead])
def test_what_a_model_cannot_answer_is_one_error(function: str) -> None:
    p, public = a_set("two_springs"), getattr(ss, function)
    if hasattr(p.model, function):
        pytest.skip("answered")
    taken = [one.name for one in inspect.signature(public).parameters.values() if one.default is one.empty]
    arguments = {name: (p, p) if name == "distribution" else p for name in taken if name in ("p", "low", "high", "distribution")}
    with pytest.raises(ss.ModelError, match=rf"^{function} is not there yet for the model two_springs; ss\."):
        public(**arguments)


def test_two_models_in_one_question_are_refused() -> None:
    with pytest.raises(ss.ParameterTypeError, match="the sets are of two models"):
        ss.certify(a_set("two_springs"), a_set("damped"), "no jump")
    with pytest.raises(ss.ParameterTypeError, match="the sets are of two models, two_springs and kang_nam"):
        ss.certify(ss.Parameters(theta0=1.0), a_set("two_springs"), "no jump")


@pytest.mark.thorough
def test_the_friction_that_works_is_the_models_own_law(tmp_path: Path) -> None:
    """μ₀ tanh(d V), where the article's law would give μ₀ (1 − exp(−d V))."""
    pytest.importorskip("sympy")
    from spragsym.derive import folder, pages

    text = (pages.SHIPPED / "kang_nam.py").read_text(encoding="utf-8")
    text = text.replace(
        "from ..model import Abs, Page, cos, exp, sgn, sin", "from spragsym.derive.model import Page, cos, sin, tanh"
    )
    text = text.replace("mu0 * (1 - exp(-d * Abs(v))) * sgn(v)", "mu0 * tanh(d * v)")
    page = tmp_path / "page.py"
    page.write_text(text, encoding="utf-8")
    folder.write_page(page, tmp_path / "model")
    brake = tmp_path / "brake.toml"
    rows = {
        "model": f'"{tmp_path / "model"}"', "m": '"1 kg"', "k_c": '"1 N/m"', "L_0": '"1 m"', "theta0": '"40 deg"', "mu0": '"0.5"',
        "F_L": '"0.007 N"', "k_x": '"0.007 N/m"', "k": '"0.1 N/m"', "k_y": '"0 N/m"', "V": '"0.05 m/s"', "d": '"10 s/m"',
    }  # fmt: skip
    brake.write_text("\n".join(["[brake]", *(f"{name} = {value}" for name, value in rows.items())]), encoding="utf-8")
    report = ss.Study.from_file(brake).model_report(oscillation=False, certificate=False)
    assert report.mu_effective == pytest.approx(0.5 * math.tanh(0.5), rel=1e-14)
