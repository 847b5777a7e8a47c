"""Extension modules: what was compiled from other sources is not used, and no call writes beyond
its arrays.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.core.extensions import extension

NAMES = (
    "kang_nam.quartic._compiled",
    "motion._carried",
    "numerics._contractors",
    "numerics._search",
    "numerics._tape",
)
pytestmark = pytest.mark.skipif(
    None in map(extension, NAMES), reason="no C compiler on installation"
)


@pytest.mark.thorough
@pytest.mark.parametrize("change", ["build", "header"])
def test_what_was_built_from_other_sources_is_refused_and_numpy_serves(
    change: str, tmp_path: Path
) -> None:
    here, package = Path(ss.__file__).parent, tmp_path / "spragsym"
    shutil.copytree(
        here, package, copy_function=os.symlink, ignore=shutil.ignore_patterns("__pycache__")
    )
    changed = [Path(str(extension(name).__file__)) for name in NAMES]
    if change == "header":
        changed = [here / "numerics/_arrays.h"]
    for path in changed:
        copy = package / path.relative_to(here)
        copy.unlink()
        content = path.read_bytes()
        for name in NAMES:
            content = content.replace(vars(extension(name))["DIGEST"].encode(), b"0" * 64)
        copy.write_bytes(content + b"\n" * (change == "header"))
    code = (
        "import spragsym as ss\n"
        f"from spragsym.core.extensions import extension\nprint([*map(extension, {NAMES})])\n"
        "print(ss.equilibria(ss.Parameters.article(theta0=0.52, mu0=0.5)).count)"
    )
    done = subprocess.run(
        [sys.executable, "-P", "-c", code],
        env=os.environ | {"PYTHONPATH": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.stdout == f"{[None] * 5}\n3\n", done.stderr
    for name in NAMES:
        assert f"{name.rpartition('.')[2]}.c and what that includes, and is not used" in done.stderr
    assert "pip install --force-reinstall --no-deps spragsym" in done.stderr


@pytest.mark.parametrize("name", NAMES)
def test_arrays_of_another_kind_or_size_are_refused(name: str) -> None:
    """Also sizes of which a product is beyond what a computer counts with."""
    one, ends, objects, byte = (
        np.zeros(1),
        np.zeros((2, 1, 1)),
        np.zeros(2, object),
        np.zeros(1, "b"),
    )
    code = np.array([[0, 0, 0, 0], [2, 0, 0, 0], [2, 1, 0, 0]], np.int32).tobytes()  # load, store
    tape, two, vast = (code[:32], b"", 1, 1), (code, b"", 2, 1), (code[:32], b"", 2**58, 1)
    sizes = 9, 6, 5, 309, 0, 4, 2, 10, 40
    motion = [np.zeros(size) for size in sizes]
    first, further = (one,) * 5, (np.zeros(2),) * 5
    newton = ends, ends, one, one
    calls: dict[str, list[tuple[str, tuple[Any, ...]]]] = {
        "kang_nam.quartic._compiled": [
            ("count", (*[np.zeros(2)] * 5, objects, np.zeros(2, "b"))),
            (
                "solve",
                (*[one] * 6, 1, byte, byte, (*first, byte), (objects[1:], *further, byte[[0, 0]])),
            ),
        ],
        "motion._carried": [
            ("carry", tuple(motion)),
            ("carry", (*motion[:4], byte, *motion[5:])),
        ],
        "numerics._contractors": [
            ("newton", (*newton, 2**30, 0, ends, one, byte)),
            ("newton", (*newton, 1, 0, objects, one, byte)),
            ("inverse", (one, 2**31 - 1, one)),
        ],
        "numerics._search": [
            ("plan", (1, 1, 0, tape, tape, *[None] * 3, vast, (), (), np.zeros((2, 2, 1)), ())),
            ("corrected", ((tape, vast), ends, 0, 1, np.zeros(2))),
            ("tangents", ((tape, two), ends, 0, np.zeros(2), objects, objects[:0])),
        ],
        "numerics._tape": [
            ("run", (code[:32], b"", (ends,), ends, 2**54)),
            ("affine", (code[:32], b"", one, one, one, ends, one, one, one, 2**58)),
            ("affine", (code[:32], b"", one, one, one, ends, one, one, objects[1:], 1)),
        ],
    }
    for called, arguments in calls[name]:
        with pytest.raises((ValueError, TypeError)):
            getattr(extension(name), called)(*arguments)
