"""The JavaScript module: the bits of C over all families, Python's folds and motion, errors that say what is wrong."""

from __future__ import annotations

import ctypes
import math
import re
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import spragsym as ss
from spragsym.cli import cli
from spragsym.parameters import NAMES
from tests.oracles import article_motion, languages
from tests.oracles.languages import NODE, values
from tests.shown import fenced
from tests.support import ROOT, few, in_python, leaves, lowest_sets

MODULE = ROOT / "generated" / "javascript" / "spragsym.mjs"
PAGE = ROOT / "docs" / "howto_javascript.md"
POINT = {"theta0": math.radians(49.0), "mu0": 0.5, "kappa": 0.007, "alpha": 0.007, "sigma": 0.1, "beta": 0.0}
DRIVE = {"V": 0.5, "d": 10.0}
START = [0.0, 0.0, 0.0, 0.0]
#: Changes to the article's values that give sets of other shapes: symmetric, one curve, a = 0 and all but 0, none.
SETS: tuple[dict[str, float], ...] = (
    {}, {"alpha": 0.0}, {"alpha": 0.7}, {"alpha": 1.0}, {"alpha": 1.02, "sigma": 0.03}, {"alpha": 1.0001}, {"beta": 0.3},
    {"kappa": 0.05, "sigma": 0.4}, {"kappa": 0.3, "alpha": 0.02, "sigma": 3.0},
)  # fmt: skip

pytestmark = pytest.mark.skipif(NODE is None, reason="node is not on this machine")


# -------------------------------------------------------------------------------------------------- equilibria


@pytest.fixture(scope="module")
def everything() -> dict[bool, tuple[ss.Parameters, languages.Found]]:
    """Points of all families and what the module says about them, in contact and in lift-off."""
    p = languages.adversarial(120)
    return {contact: (p, languages.in_node(p, contact)) for contact in (True, False)}


@pytest.mark.thorough
@pytest.mark.parametrize("contact", few([True, False], True))
def test_what_is_vouched_for_is_what_python_proves(everything: Any, contact: bool) -> None:
    """Counts, kinds and errors within the bounds of both, against the ladder's digits; and most points are vouched for."""
    p, found = everything[contact]
    assert np.mean(found.status == 0) > 0.999
    assert languages.against_python(found, p, contact).wrong == 0
    assert 0 < languages.against_python(found, p, contact).largest <= 1


@pytest.mark.thorough
def test_every_bit_is_that_of_c(everything: Any, c_library: ctypes.CDLL) -> None:
    """Statuses, counts, states and bounds of all points, vouched for or not: one kernel, no operation of it different."""
    for contact, (p, found) in everything.items():
        assert not languages.unlike_c(found, c_library, p, contact).any()


# ------------------------------------------------------------------------------------------------------ algebra


def test_algebra_is_that_of_python() -> None:
    """Every generated function at random arguments; exp may be rounded otherwise by an engine."""
    rng = np.random.default_rng(18)
    calls, expected = [], []
    types = MODULE.with_suffix(".d.ts").read_text(encoding="utf-8")
    declared = re.findall(r"^  (\w+)\(((?:\w+: number(?:, )?)+)\): ", types, re.MULTILINE)
    assert len(declared) > 60
    for name, arguments in declared:
        names = re.findall(r"(\w+): number", arguments)
        given = [float(value) for value in rng.uniform(0.2, 0.9, len(names))]
        calls.append((f"algebra.{name}", *given))
        expected.append(in_python(name, names)(*given))
    for (name, *_), ours, theirs in zip(calls, values(calls), expected, strict=True):
        assert np.array(leaves(ours)) == pytest.approx(np.array(leaves(theirs), dtype=float), rel=1e-14, abs=1e-15), name


# --------------------------------------------------------------------------------------- surface, folds and cusps


@pytest.mark.parametrize("changes", few(SETS, SETS[3]))
def test_bifurcation_set_is_that_of_python(changes: dict[str, float]) -> None:
    """As many curves, with their ends, and every point on a fold: f = f′ = 0 there to rounding."""
    p = ss.Parameters.article(**changes)
    fixed = {name: float(getattr(p, name)) for name in NAMES[2:]}
    (found,) = values([("bifurcation_set", fixed)])
    theirs = ss.bifurcation_set(p)
    assert len(found["curves"]) == len(theirs.curves)
    assert _ends(found["curves"]) == pytest.approx(_ends([curve.values for curve in theirs.curves]), abs=1e-3)
    for curve in found["curves"]:
        theta, theta0, mu0 = (np.array(curve[name]) for name in ("theta", "theta0", "mu0"))
        a, b, d, m = generated_f(theta0, mu0, fixed)
        c, s = np.cos(theta), np.sin(theta)
        size = abs(a * s * c) + abs(b * c) + abs(d * s) + abs(m * s * s)
        assert np.all(abs(a * s * c + b * c + d * s - m * s * s) < 1e-11 * size)
        slope = a * (c * c - s * s) - b * s + d * c - 2 * m * s * c
        assert np.all(abs(slope) < 1e-9 * (abs(a) + abs(b * s) + abs(d * c) + abs(m)))
    assert [cusp["mu0"] for cusp in found["cusps"]] == pytest.approx(theirs.cusps.mu0, rel=1e-12, abs=1e-12)
    assert [cusp["theta0"] for cusp in found["cusps"]] == pytest.approx(theirs.cusps.theta0, abs=1e-12)


def generated_f(theta0: Any, mu0: Any, fixed: dict[str, float]) -> tuple[Any, ...]:
    """Coefficients of f in contact, written out: (12), (13) eliminated by hand."""
    kappa, alpha, sigma, beta = (fixed[name] for name in ("kappa", "alpha", "sigma", "beta"))
    stiff, c0, s0 = beta + 1, np.cos(theta0), np.sin(theta0)
    a, b = sigma * (stiff - alpha), -(alpha + sigma) * (stiff * s0 + kappa)
    return a, b, mu0 * (sigma * s0 - kappa) + alpha * c0 * (stiff + sigma), mu0 * sigma


def _ends(curves: Sequence[Any]) -> list[float]:
    """θ₀ and μ₀/(1 + μ₀) of both ends of every curve, in an order that rounding does not decide."""
    ends = [
        tuple(sorted((round(curve["theta0"][k], 3), curve["mu0"][k] / (1 + curve["mu0"][k])) for k in (0, -1)))
        for curve in curves
    ]
    return [float(number) for curve in sorted(ends) for end in curve for number in end]


@pytest.mark.parametrize("changes", few([{"alpha": 0.7}, {"alpha": 1.0}, {"beta": 0.3}], {"alpha": 0.7}))
def test_flutter_onsets_are_those_of_python(changes: dict[str, float]) -> None:
    """The onsets at some frictions, which Python proves complete, lie on the curves, and no others do."""
    p = ss.Parameters.article(**changes)
    (curves,) = values([("flutter_boundary", {name: float(getattr(p, name)) for name in NAMES[2:]})])
    for mu0 in (4.0, 30.0):
        crossed = []
        for curve in curves:
            off = np.array(curve["mu0"]) - mu0
            theta0 = np.array(curve["theta0"])
            at = np.flatnonzero(off[:-1] * off[1:] < 0)
            crossed += list(theta0[at] - off[at] * (theta0[at + 1] - theta0[at]) / (off[at + 1] - off[at]))
        exact = ss.flutter_onsets(p.replace(mu0=mu0), damping=False).theta0
        assert sorted(crossed) == pytest.approx(exact, abs=5e-3)


@pytest.mark.parametrize("vary", few(NAMES, "sigma"))
def test_folds_are_those_that_python_proves(vary: str) -> None:
    """Along each parameter: alpha = 0, all but 0 and close to 1 + beta; without friction, pitchforks too."""
    sets = languages.fold_sets(24)
    # The polynomial for theta0 has lost these two: with less alpha folds all but coincide with those of the mirror image.
    sets.append({"theta0": 1.0, "mu0": 0.0, "kappa": 0.0069, "alpha": 1e-8, "sigma": 7.66, "beta": 0.45})
    sets.append({"theta0": 0.4, "mu0": 1e-4, "kappa": 1.6e-4, "alpha": 4.7e-9, "sigma": 3.3, "beta": 0.06})
    total = 0
    for given, found in zip(sets, values([("folds", given, {"vary": vary}) for given in sets]), strict=True):
        theirs = ss.folds(ss.Parameters(**given), vary)
        total += len(theirs.theta)
        for name in (*NAMES, "theta", "L", "x", "y"):
            assert [fold[name] for fold in found] == pytest.approx(getattr(theirs, name), rel=1e-10, abs=1e-10), given
    assert total > 3


@pytest.mark.thorough
def test_the_lowest_fold_is_that_python_proves() -> None:
    sets = [{name: float(getattr(p, name)) for name in NAMES[2:]} for p in lowest_sets(24)]
    kinds = set()
    for given, found in zip(sets, values([("critical_friction", given) for given in sets]), strict=True):
        theirs = ss.critical_friction(ss.Parameters(**given))
        kinds.add(theirs.kind)
        if not theirs.kind:
            assert found["kind"] == ""
        else:
            assert found["kind"] == theirs.kind
            assert found["mu0"] == pytest.approx(float(theirs), rel=1e-9, abs=1e-12), given
            assert found["theta0"] == pytest.approx(theirs.theta0, rel=1e-5), given
    assert kinds == {"cusp", "turn", ""}


# ------------------------------------------------------------------------------------------------------- motion


def test_right_hand_side_and_energy() -> None:
    """The equations of motion by hand, in contact, in lift-off and ahead of the belt."""
    theta0, *rest = POINT.values()
    constants = (math.cos(theta0), math.sin(theta0), *rest, *DRIVE.values())
    for state in ([0.3, -0.02, 0.1, 0.2], [0.3, 0.05, 0.1, 0.2], [0.3, -0.02, 0.9, 0.2]):
        rate, regime, energy = values([("motion", method, POINT, DRIVE, state) for method in ("rhs", "regime", "energy")])
        assert rate == pytest.approx([*state[2:], *article_motion.everywhere(state, constants)], rel=1e-13, abs=1e-15)
        assert regime == {"contact": state[1] < 0, "side": 1 if state[2] < DRIVE["V"] else -1}
        assert energy == pytest.approx(article_motion.stored(state, constants), abs=1e-14)


@pytest.mark.parametrize(("V", "start"), [(0.2, START), (0.1, [0.0, -0.01, 0.3, 0.0])])
def test_step_is_of_fourth_order_across_the_kinks(V: float, start: list[float]) -> None:
    """The orbits leave the belt and come back, or overtake it; the reference is the other integrator at tight tolerance."""
    begun = dict(zip(("x0", "y0", "vx0", "vy0"), start, strict=True))
    exact = ss.simulate(ss.Parameters(**POINT), V=V, d=10.0, t_end=60.0, rtol=1e-12, **begun).state[:, -1]
    steps = (0.1, 0.05, 0.025, 0.0125)
    reached = values([("steps", POINT, {"V": V, "d": 10.0}, start, h, round(60.0 / h)) for h in steps])
    errors = [float(np.abs(np.array(state) - exact).max()) for state in reached]
    assert errors[-1] < 1e-8
    assert math.log2(errors[0] / errors[-1]) / 3 > 3.6


# ------------------------------------------------------------------------------------------------ export and page


@pytest.mark.thorough
def test_export_runs_as_the_page_prints(tmp_path: Path) -> None:
    """The module with its example, and every program of the page with what it prints."""
    assert CliRunner().invoke(cli, ["export", "--language", "javascript", "--out", str(tmp_path)]).exit_code == 0
    options: dict[str, Any] = {"cwd": tmp_path, "capture_output": True, "text": True, "timeout": 60}
    printed = subprocess.run([str(NODE), "example.mjs"], **options, check=True).stdout
    assert "contact: 1, ok\n  theta, L, x, y  2.203367573653  0.949501362252" in printed
    assert "2 curves of folds, cusps at friction 0.200931782\n" in printed
    shown = fenced(PAGE, "javascript"), fenced(PAGE, "text")
    assert len(shown[0]) == len(shown[1]) > 1
    for number, (program, output) in enumerate(zip(*shown, strict=True)):
        (tmp_path / f"page{number}.mjs").write_text(program, encoding="utf-8")
        done = subprocess.run([str(NODE), f"page{number}.mjs"], **options, check=False)
        assert (done.stdout, done.stderr) == (output, "")
