"""What long work says of itself, and to whom."""

import time
from collections.abc import Callable
from typing import Any

import pytest

import spragsym as ss
from spragsym import article as claims
from spragsym.core import progress

BELT = ss.load("inclined_belt")
P = BELT.Parameters(theta0=1.0, mu0=0.3)
FLAT = {"between": {"mu0": (0.0, 0.5)}}


def said_by(ask: Callable[[], Any]) -> list[str]:
    """All texts that a call tells."""
    told: list[str] = []
    with ss.show_progress(to=told.append):
        ask()
    return told


@pytest.mark.by_hand("<lambda>-whether the state", "<lambda>-3 lines")
@pytest.mark.parametrize(
    ("ask", "expected"),
    [
        pytest.param(
            lambda: ss.critical_friction(P, **FLAT),
            "whether the state ends at the cusp at mu0 = 0.207376",
            marks=pytest.mark.thorough,
        ),
        (
            lambda: ss.certify(P, between={"mu0": (0.0, 0.01), "theta0": (1.0, 1.01)}),
            "parts of the box looked at",
        ),
        pytest.param(
            lambda: ss.bifurcation_set(P, n=3), "3 lines along mu0", marks=pytest.mark.thorough
        ),
        (
            lambda: ss.jump_margin(ss.Parameters.article(theta0=0.7), {"mu0": 0.05}),
            "tolerances away",
        ),
        (
            lambda: claims.run([one for one in claims.STATEMENTS if one.id == "claim-mu-cr"]),
            "claim-mu-cr",
        ),
        (lambda: ss.rms_sweep(P, V=[0.4, 0.5], t_end=20.0, transient=10.0), "2 of 2 points"),
    ],
)
def test_what_takes_long_says_what_it_is_at(ask: Callable[[], Any], expected: str) -> None:
    assert any(expected in text for text in said_by(ask))


def test_what_takes_long_says_again_how_long(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(progress, "LONG", 0.01)
    with ss.show_progress("work"):
        time.sleep(0.3)
    first, second, *_ = capsys.readouterr().err.splitlines()
    assert first == second == "work: 0 s so far"


@pytest.mark.thorough
def test_a_notebook_shows_within_a_second_what_it_is_at() -> None:
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    shown = []

    class Client(nbclient.NotebookClient):  # type: ignore[misc]  # of any class
        def process_message(self, message: Any, cell: Any, index: int) -> Any:
            if message["msg_type"].endswith("display_data"):
                shown.append((cell.source, message["content"]["data"]["text/plain"]))
            return super().process_message(message, cell, index)

    begin = "import time\nimport spragsym as ss\nfrom spragsym.core.progress import advance, doing, tell"
    block = "with ss.show_progress('work'), doing('half'):\n    time.sleep(0.3)\n    tell('whole')"
    bar = "with advance(True, 2, 0) as step:\n    time.sleep(0.3)\n    step()"
    cells = [nbformat.v4.new_code_cell(it) for it in (begin, block, bar)]
    Client(nbformat.v4.new_notebook(cells=cells), timeout=60, kernel_name="python3").execute()
    assert [text for cell, text in shown if cell == block] == [
        "work",
        "work: half",
        "work: whole",
        "",
    ]
    assert [text for cell, text in shown if cell == bar] == [
        "",
        "0 of 2 points",
        "1 of 2 points",
        "",
    ]
