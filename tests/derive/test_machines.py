"""Other machines: the C target's bits on each that can be built for here."""

from pathlib import Path

import pytest

from tests.oracles.machines import MACHINES, PROGRAM, SOURCES, Machine, points

POINTS = points(60)


def _results(machine: Machine, folder: Path) -> str:
    if reason := machine.missing():
        pytest.skip(reason)
    program = machine.built(folder, [PROGRAM, SOURCES / "spragsym.c"])
    assert program, f"{machine.name}: not compiled without a warning"
    return machine.results(program, POINTS)


@pytest.fixture(scope="module")
def expected(tmp_path_factory: pytest.TempPathFactory) -> str:
    """What the first machine prints, which is checked to be something."""
    found = _results(MACHINES[0], tmp_path_factory.mktemp("first"))
    lines = found.splitlines()
    assert len(lines) == POINTS.count("\n")
    assert {line.split()[0] for line in lines} <= {"0", "1"}
    return found


@pytest.mark.by_hand("x86_64, gcc with extensions", "x86_64, as C++")
@pytest.mark.thorough
@pytest.mark.parametrize("machine", MACHINES[1:], ids=lambda machine: machine.name)
def test_the_same_bits(machine: Machine, expected: str, tmp_path: Path) -> None:
    assert _results(machine, tmp_path) == expected
