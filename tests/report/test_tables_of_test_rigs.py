"""Friction curves as test rigs write them: read where they have one meaning, refused where they have two."""

from pathlib import Path

import pytest

import spragsym as ss
from spragsym.report.brake_files import read_friction

PLAIN = "0.5;0.41\n1;0.43\n"


@pytest.mark.parametrize("text", [
    f"sep=;\nv [m/s];mu\n{PLAIN}", f"Test rig: X\nRun 7; 2.5 bar\nv [m/s];mu\n{PLAIN}", f"v [m/s];mu_k\n{PLAIN}",
    f"v [m/s];Friction coefficient µ\n{PLAIN}", f"Gleitgeschwindigkeit v, m/s;Reibwert µ\n{PLAIN}",
    "velocity_mm/s;mu\n500;0.41\n1000;0.43\n", "v / (mm/s);mu / 1\n500;0.41\n1'000;0.43\n",
    "v [m/s];mu\n−5.0D-01;0.41\n-1;0.43\n",
])  # fmt: skip
def test_what_has_one_meaning_is_read(text: str, tmp_path: Path) -> None:
    (tmp_path / "mu.csv").write_text(text, encoding="utf-8")
    speed, friction = read_friction(tmp_path / "mu.csv")
    assert (speed.tolist(), friction.tolist()) == ([0.5, 1.0], [0.41, 0.43])


@pytest.mark.parametrize(("text", "words"), [
    ("v [m/s];mu;mu_k\n0.5;0.41;0.3\n1;0.43;0.3\n", "named 2 times"), ("v [mm/s];mu\n1,000;0.41\n2,000;0.43\n", "thousands"),
    (f"Run 7; 2.5 bar\n{PLAIN}", "is no head"),
])  # fmt: skip
def test_what_has_two_meanings_is_refused(text: str, words: str, tmp_path: Path) -> None:
    (tmp_path / "mu.csv").write_text(text, encoding="utf-8")
    with pytest.raises(ss.ParameterError, match=words):
        read_friction(tmp_path / "mu.csv")
