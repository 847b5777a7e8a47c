"""Remarks on what a report can't answer, and captions of its pictures: each in full, of answers
that are set by hand.
"""

import copy
import dataclasses
import math
import re
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from unittest.mock import Mock

import numpy as np
import pytest

import spragsym as ss
from spragsym.core.errors import ConvergenceError
from spragsym.core.remarks import At, Remark
from spragsym.report import facts
from spragsym.report.example import example
from spragsym.report.study import Study
from tests.conftest import Run
from tests.oracles.mistakes import BRAKE
from tests.report.test_sentences import (
    DAMPED,
    EXACT,
    LOAD,
    LOOSE,
    SLOW,
    STRIBECK,
    named,
    odds,
    oscillation,
    said_of,
    state,
)
from tests.support import written_brake

FAR = named(LOAD, ends=SimpleNamespace(until=1e-3), jump=lambda: math.nan)


def refused(*_: Any, **__: Any) -> Any:
    raise ConvergenceError("the search did not end; take another")


def lowest(kind: str, value: float, complete: bool = True) -> Callable[..., Any]:
    return lambda p: SimpleNamespace(
        kind=kind, value=value, where=1.0, complete=complete, remarks=("a region is open; look",)
    )


@pytest.mark.parametrize(
    ("question", "study", "answers", "remark"),
    [
        (
            "_jump",
            STRIBECK,
            {},
            "the model has no friction coefficient: say which quantity rises until the state "
            'jumps, as vary = "theta0"',
        ),
        (
            "_jump",
            FAR,
            {},
            "the jump along F_L is not known: there is none up to 57 N, where the search ends",
        ),
        (
            "_lowest",
            EXACT,
            {"lowest_of_followed": lowest("undecided", 0.2)},
            "below a friction of 0.2 it cannot jump at any angle; above that is not decided",
        ),
        (
            "_lowest",
            EXACT,
            {"lowest_of_followed": lowest("undecided", 0.0)},
            "whether some friction is too small for a jump at any angle is not decided",
        ),
        (
            "_lowest",
            EXACT,
            {"lowest_of_followed": lowest("fold", 0.2, complete=False)},
            "that nothing jumps below mu_lowest is not proved: a region is open",
        ),
        (
            "_lowest",
            EXACT,
            {"lowest_of_followed": refused},
            "the friction below which it jumps at no angle is not known: the search did not end",
        ),
        (
            "_jump_along_the_inclination",
            EXACT,
            {"first_limit_points": refused},
            "the jump along theta0 is not known: the search did not end",
        ),
    ],
)
def test_a_remark(
    question: str,
    study: Study,
    answers: dict[str, Any],
    remark: str,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for name, answer in answers.items():
        monkeypatch.setattr(facts, name, answer)
    asked = facts._Answers(study)
    getattr(facts, question)(asked)
    assert asked.remarks == [remark]


def test_changes_beyond_nothing_are_not_looked_for() -> None:
    asked = facts._Answers(EXACT)
    assert not facts._changes_are_searched(asked, 0.0, -0.1, 1.2, fails=True)
    assert asked.remarks == [
        "changes are not looked for: 1.2 times a friction of 0.3 does not lie beyond it"
    ]


def test_what_no_search_answers_is_remarked_in_the_order_of_asking(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    open_one = copy.copy(ss.equilibria(LOOSE.operating_point))
    undecided = type("Undecided", (type(open_one),), {"complete": False})
    object.__setattr__(open_one, "__class__", undecided)
    object.__setattr__(open_one, "remarks", ("a box is undecided; look",))
    monkeypatch.setattr(facts, "equilibria", lambda p: open_one)
    monkeypatch.setattr(facts, "_slides", lambda study: None)
    monkeypatch.setattr(facts, "chance", lambda study, n: odds(0.1, 0.05, 0.2))
    questions = "current oscillation_of certificate bracket folds distance jump_peak changes"
    for name in questions.split():
        monkeypatch.setattr(facts, name, refused)
    found = facts.facts(LOOSE, facts.ReportOptions(redesign=False))
    why = "not known: the search did not end"
    assert found.remarks == (
        f"the state that the brake is in is {why}",
        "states may be missing: a box is undecided",
        f"the oscillation is {why}",
        f"whether nothing within the tolerances jumps is {why}",
        f"bounds of the probability are {why}",
        f"folds along mu0 are {why}",
        f"folds along theta0 are {why}",
        f"the nearest jump is {why}",
        f"the jump as a motion is {why}",
    )


def test_a_remark_is_told_in_the_units_of_the_file(tmp_path: Path) -> None:
    """By hand: a length of 1 is 38 mm, and a force of 1 is 1500 N/mm times that, 57 kN."""
    study = ss.Study.from_file(written_brake(tmp_path, {**BRAKE, "F_L": "0.42 kN"}))
    force, angle = At("kappa", (0.01,)), At("theta0", (math.pi / 4, math.pi / 2), unit="rad")
    remark = Remark("for {}: {}; look", force, Remark("{}, {}", At("x", (-2.0, 2.0)), angle))
    told = "for F_L = 0.57 kN: x in [-76, 76] mm, theta0 in [45, 90] deg"
    answers, error = facts._Answers(study), ConvergenceError(Remark("nothing at {}; look", force))
    assert (study.said(remark), answers.brief(remark)) == (f"{told}; look", told)
    assert answers.known("the jump is", Mock(side_effect=error)) is None
    assert answers.remarks == ["the jump is not known: nothing at F_L = 0.57 kN"]


@pytest.mark.thorough
def test_a_model_in_which_nothing_rises_is_asked_for_its_state(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    options = facts.ReportOptions(probability=False, redesign=False, oscillation=False)
    monkeypatch.setattr(facts, "current", lambda study, eq: None)
    found = facts.facts(STRIBECK, options)
    assert found.remarks[1] == (
        "which state the brake is in is not known, since nothing is said to rise: "
        "name it with state"
    )


# ------------------------------------------------------------------------------------------------
# captions of a page


@pytest.fixture
def pages(monkeypatch: pytest.MonkeyPatch) -> Any:
    """The pictures of a page, of which nothing is drawn but a path."""
    pytest.importorskip("matplotlib")
    from spragsym.figures import report_pages

    for name in ("mark_brake", "draw_onset_curves", "draw_phase", "draw_shares", "draw_spectrum"):
        monkeypatch.setattr(report_pages, name, Mock())
    monkeypatch.setattr(report_pages, "draw_plane", Mock(return_value=(Mock(undecided=[]), True)))
    monkeypatch.setattr(report_pages, "draw_rising", Mock(return_value=(["path"], False)))
    monkeypatch.setattr(report_pages, "picture", lambda draw: draw(None) and "")
    return report_pages


def captions(rows: Any) -> list[str]:
    return [caption for _, caption in rows]


def test_captions_of_the_planes(pages: Any) -> None:
    folds: Any = {"mu0": [0.366]}
    brake_in_the_plane, rising = captions(pages._planes(said_of(LOOSE, folds=folds)))
    assert brake_in_the_plane == (
        "Where the brake works (dot) and its tolerances (box). On the lines two states of sliding "
        "meet; where it is shaded there are three. Cross: the friction at which the reference "
        "state jumps at this angle."
    )
    assert rising == (
        "Displacement along the belt as the friction rises (orange, with its jumps); grey: all "
        "states, full where stable. Dots: folds, where two states meet and end. Shaded: the "
        "friction within its tolerances."
    )
    sure = captions(pages._planes(said_of(EXACT)))
    assert "tolerances" not in "".join(sure)
    assert sure[1].endswith("rises (orange); grey: all states, full where stable.")
    never = said_of(LOOSE, jump_at=math.inf, jump_parameter=math.inf, reach="never")
    assert captions(pages._planes(never))[0].endswith("where it is shaded there are three.")
    pages.draw_plane.return_value = Mock(undecided=[1, 2]), False
    assert captions(pages._planes(never))[0].endswith(
        "states of sliding meet. 2 boxes on its lines are undecided."
    )
    assert len(captions(pages._planes(said_of(LOOSE, mu_lowest=math.inf)))) == 1
    assert "as F_L rises (orange" in captions(pages._planes(said_of(LOAD)))[0]
    pages.draw_rising.return_value = [], True
    searched = captions(pages._planes(said_of(LOAD)))[0]
    assert "as F_L rises, where it is not followed; grey" in searched
    assert "full where stable. Hatched: where states or folds may be missing." in searched


@pytest.mark.parametrize(
    ("growth", "stability", "words"),
    [
        (1.0, "unstable", "grow: it squeals or judders"),
        (-1.0, "neutral", "hardly grow or die out, as next to nothing damps"),
        (-1.0, "stable", "die out"),
    ],
)
def test_the_caption_of_the_map(
    growth: float, stability: str, words: str, pages: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    kinds = np.array(["supercritical", "subcritical", "undecided"])
    curve = {"theta0": np.array([0.8, 0.9]), "mu0": np.array([0.2, 0.4])}
    onset = np.array(["of instability", "on an unstable state", "undecided"])
    found = SimpleNamespace(
        curves=[type("Curve", (dict,), {"criticality": kinds, "onset": onset})(curve)],
        undecided=(),
        vary=("theta0", "mu0"),
        between={"theta0": (0.1, 3.0), "mu0": (0.0, 1.0)},
        changes={"error": [0.0]},
        points=SimpleNamespace(kind=["BT", "ZH", "HH"]),
    )
    monkeypatch.setattr(pages.ss, "onset_curves", lambda *_, **__: found)
    monkeypatch.setattr(pages, "growth_of_oscillations", lambda eq: growth)
    known = said_of(DAMPED, states=(state(stability=stability),))
    assert captions(pages._stability_map(known)) == [
        f"The map of stability. The brake (dot) works where small oscillations {words}; they grow "
        "in a state at least where it is shaded, hardly where lightly. Full line: it begins with a small amplitude "
        "(supercritical); dashed: with a large one at once (subcritical); dotted: which of the two "
        "is not decided; grey: of a state that is unstable on both sides; GH: where that changes; "
        "BT: a line ends where two states meet; ZH: a line touches one on which two states meet; "
        "HH: two lines cross, and two frequencies set in."
    ]


def test_captions_of_the_motion(pages: Any) -> None:
    cycle = oscillation(motion=SimpleNamespace(trajectory=lambda rounds: None))
    phase, stems = captions(pages._of_motion(said_of(SLOW), cycle))
    assert phase == (
        "The oscillation: speed along the belt over x, one closed curve a cycle. Dotted: the speed "
        "of the belt."
    )
    assert stems == "Its spectrum: x moves at multiples of 41.23 Hz alone."
    # The friction of a pad on legs acts along x + h φ, of which a picture over x shows no belt.
    si = {"m": 1.0, "k_c": 9.0, "a": 1.0, "mu0": 0.5, "F": 1.0, "k_x": 4.0, "k_t": 3.0, "h": 0.8}
    legs = said_of(ss.Study(si | {"J": 0.3, "c": 1.0, "V": 5.0, "d": 1.0}, model="pad_on_legs"))
    assert captions(pages._of_motion(legs, cycle))[0] == (
        "The oscillation: rate of x over x, one closed curve a cycle."
    )
    fast = dataclasses.replace(cycle, frequency_hz=2345.6)
    assert captions(pages._of_motion(said_of(SLOW), fast))[1] == (
        "Its spectrum: x moves at multiples of 2.346 kHz alone."
    )
    other = dataclasses.replace(cycle, kind="motion", frequency_hz=math.nan)
    assert captions(pages._of_motion(said_of(SLOW), other))[1] == (
        "Its spectrum: the amplitude of x at each frequency, through a Hann window."
    )


def test_the_caption_and_the_words_of_the_shares(
    pages: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pages, "_stability_map", lambda known: ())
    told = said_of(LOOSE, probability=odds(0.1, 0.05, 0.2))
    assert captions(pages.pictures(told))[-1] == (
        "Which tolerance decides whether it jumps: Sobol' indices, inner bars alone, outer ones "
        "with interactions; lines: 95 % intervals."
    )


def test_a_page_without_a_title_is_a_sprag_slip_report(
    pages: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("jinja2")
    monkeypatch.setattr(pages, "_stability_map", lambda known: ())
    page = pages.report_page(said_of(EXACT))
    assert re.findall("<title>(.*?)</title>", page) == ["Sprag-slip report"]


@pytest.mark.thorough
def test_a_motion_without_a_cycle_is_told_in_the_units_of_the_file(
    tmp_path: Path, run: Run
) -> None:
    """A strong damper, with which sliding is stable: the spring carries the friction."""
    text = example(ss.load("stick_slip"))
    data = tmp_path / "brake.toml"
    data.write_text(re.sub(r'\nc = "[^"]*"', '\nc = "500 N s/m"', text), encoding="utf-8")
    said = run("cycles", "--data", str(data), code=1)
    given = {name: one.value for name, one in ss.Study.from_file(data).quantities.items()}
    V, v_s = given["V"], given["v_s"]
    friction = given["mu_s"] * 2 * V * v_s / (V**2 + v_s**2) * given["N_0"]
    assert f"it comes to rest at x = {1e3 * friction / given['k']:.6g} mm; give" in said
