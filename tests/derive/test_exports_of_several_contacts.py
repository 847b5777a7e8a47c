"""Exports of pages with several contacts: the example against Python, and the kinked field against
the modes of a motion. Their functions are those of shipped pages, in ``tests/conformance``.
"""

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("sympy")

import spragsym as ss
from spragsym.cli import main
from tests.oracles.contact_pages import BLOCKS, PAD, PADS, TIED_BLOCKS
from tests.oracles.exports import CC
from tests.oracles.user_pages import derived


def exported(text: str, name: str, language: str, out: Path) -> Path:
    command = ["export", "--model", str(derived(text, name)), "--language", language]
    with pytest.raises(SystemExit, match="0"):
        main([*command, "--out", str(out)])
    return out


@pytest.mark.thorough
@pytest.mark.skipif(
    CC is None or shutil.which("make") is None, reason="there is no C compiler, or no make"
)
@pytest.mark.parametrize(("text", "name"), [(PAD, "pad_on_2"), (PADS, "pads")])
def test_the_example_in_c_is_built_and_moves_as_python_does(
    text: str, name: str, tmp_path: Path
) -> None:
    out = exported(text, name, "c", tmp_path)
    subprocess.run(["make", "-s"], cwd=out, check=True, timeout=120)
    done = subprocess.run(
        ["./example"], cwd=out, check=True, capture_output=True, text=True, timeout=60
    )
    tr = ss.simulate(ss.load(derived(text, name)).Parameters(), t_end=8.0)
    said = done.stdout.splitlines()[2].split()
    assert said[:2] == ["time", "8.0"]
    for component, value in zip(tr.components, tr(8.0), strict=True):
        assert float(said[said.index(component) + 1]) == pytest.approx(value, abs=2e-3)
    assert len(said[said.index("energy") + 2 :]) == 2  # which of both touch


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("text", "name"),
    [(BLOCKS, "blocks"), (TIED_BLOCKS, "tied")],
)
def test_the_field_of_frictions_that_hold_is_that_of_the_mode_of_a_motion(
    text: str, name: str
) -> None:
    """``rhs``, from which other languages move: where both slide, where one of them rides with the
    belt, and where both do, there of blocks that a mass ties, which changes what holds the other,
    while both stick.
    """
    p = ss.load(derived(text, name)).Parameters()
    model, rng, met = p.model, np.random.default_rng(79), set()
    given = [float(value) for value in model.arguments(p, "motion")]
    for _ in range(300):
        state = rng.uniform(-0.9, 0.9, 4)
        riding = rng.integers(2, size=2) == 1
        state[2:][riding] = float(p.V)
        mode = model.field.initial_mode(state.tolist(), given)
        sides = mode[2:4]
        if name == "tied" and riding.all() and any(sides):
            continue
        met.add((*riding.tolist(), *(side == 0 for side in sides)))
        known = model.algebra.regime_rhs(*state, *given, *mode)
        assert [float(one) for one in model.algebra.rhs(*state, *given)] == pytest.approx(
            [float(one) for one in known], abs=1e-14
        )
    assert {
        (True, True, True, True),
        (True, False, True, False),
        (False, True, False, False),
    } <= met
