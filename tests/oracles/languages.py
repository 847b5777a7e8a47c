"""The JavaScript and MATLAB targets for tests and benchmarks: called on whole tables of points, in
node and in Octave.
"""

import atexit
import ctypes
import json
import math
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, partial
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import spragsym as ss
from benchmarks.timing import on_backend
from spragsym.derive.kang_nam.library import exported
from spragsym.generated.quantities import PARAMETERS
from tests.oracles import c_target
from tests.oracles.families import FAMILIES

NODE = shutil.which("node")
OCTAVE = shutil.which("octave-cli") or shutil.which("octave")
STATUS = {"ok": 0, "uncertain": 1, "out_of_range": 3}
STABILITY = ("none", "stable", "divergent", "flutter")
#: Columns of results, in the order in which the MATLAB driver writes them.
COLUMNS = ("theta", "L", "x", "y", "stability", "error")
_RUNTIME = Path(str(resources.files("spragsym.derive"))) / "kang_nam" / "runtime"


@dataclass(frozen=True)
class Found:
    """Equilibria of n points: status and count of each, and columns (n, 4), NaN beyond the
    count.
    """

    status: NDArray[np.int64]
    count: NDArray[np.int64]
    columns: Any  #: by their names
    nanoseconds: float  #: a point, without start-up and without reading and writing


@cache
def library(language: str) -> Path:
    """A folder with the exported library, for as long as the process lives."""
    folder = Path(tempfile.mkdtemp(prefix="spragsym-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    for name, text in exported(language).items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return folder


def answers(calls: Sequence[tuple[Any, ...]]) -> list[dict[str, Any]]:
    """What the JavaScript module returns for calls (name, arguments …): ``value``, or ``error`` and
    ``message`` where it throws.
    """
    text = json.dumps([{"name": name, "given": _encoded(given)} for name, *given in calls])
    driver = _RUNTIME / "javascript" / "tests" / "driver.mjs"
    command = [str(NODE), str(driver), str(library("javascript") / "spragsym.mjs")]
    done = subprocess.run(
        command, input=text, capture_output=True, text=True, timeout=600, check=False
    )
    if done.returncode or done.stderr:
        raise RuntimeError(f"node failed: {done.stderr}")
    return list(json.loads(done.stdout, object_hook=_decoded))


def values(calls: Sequence[tuple[Any, ...]]) -> list[Any]:
    """What calls return that must not throw."""
    found = answers(calls)
    for answer in found:
        if "value" not in answer:
            raise RuntimeError(f"{answer['error']}: {answer['message']}")
    return [answer["value"] for answer in found]


def _encoded(value: Any) -> Any:
    """A value for the driver: what JSON has no number for becomes an object."""
    if isinstance(value, dict):
        return {name: _encoded(part) for name, part in value.items()}
    if isinstance(value, list | tuple):
        return [_encoded(part) for part in value]
    if isinstance(value, float) and not math.isfinite(value):
        return {"number": {math.inf: "Infinity", -math.inf: "-Infinity"}.get(value, "NaN")}
    return value


def _decoded(found: dict[str, Any]) -> Any:
    return (
        float(found["number"].replace("Infinity", "inf")) if found.keys() == {"number"} else found
    )


def in_node(p: ss.Parameters, contact: bool) -> Found:
    """All points by the JavaScript module."""
    points = [dict(zip(PARAMETERS, map(float, row), strict=True)) for row in c_target.table(p)]
    *found, speed = values(
        [
            *(("equilibria", point, {"contact": contact}) for point in points),
            ("speed", points, {"contact": contact}),
        ]
    )
    columns = {name: np.full((len(points), 4), np.nan) for name in COLUMNS}
    for i, answer in enumerate(found):
        for k, state in enumerate(answer["states"]):
            for name in COLUMNS:
                columns[name][i, k] = (
                    STABILITY.index(state[name]) if name == "stability" else state[name]
                )
    status, count = (
        [rule(answer) for answer in found]
        for rule in (lambda it: STATUS[it["status"]], lambda it: it["count"])
    )
    return Found(np.array(status), np.array(count), columns, speed["nanoseconds"])


def octave(folder: Path, program: str, *arguments: str) -> str:
    """What a program prints in Octave, started in a folder."""
    (folder / "program.m").write_text(program, encoding="utf-8")
    command = [str(OCTAVE), "--norc", "--no-history", "-q", "program.m", *arguments]
    done = subprocess.run(
        command, cwd=folder, capture_output=True, text=True, timeout=600, check=False
    )
    if "no graphics toolkits are available" in done.stderr:
        pytest.skip("Octave is installed without anything that draws")
    if done.returncode:
        raise RuntimeError(f"Octave failed: {done.stderr}")
    return done.stdout


def in_octave(p: ss.Parameters, contact: bool) -> Found:
    """All points by the MATLAB package."""
    program = (_RUNTIME / "matlab" / "tests" / "solve.m").read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        c_target.table(p).tofile(folder / "points")
        printed = octave(
            folder, program, str(library("matlab")), "points", str(int(contact)), "answers"
        )
        slots = 4 - contact
        table = np.fromfile(folder / "answers").reshape(-1, 2 + 6 * slots)
    columns = {name: np.full((len(table), 4), np.nan) for name in COLUMNS}
    for place, column in enumerate(columns.values()):
        column[:, :slots] = table[:, 2 + slots * place : 2 + slots * (place + 1)]
    beyond = np.arange(4) >= table[:, 1:2]
    columns["stability"][beyond] = np.nan
    return Found(table[:, 0].astype(int), table[:, 1].astype(int), columns, float(printed))


# ------------------------------------------------------------------------------------------------
# comparison


def adversarial(n: int) -> ss.Parameters:
    """``n`` points of every family, one after the other."""
    parts = [
        points(np.random.default_rng([18, place]), n)
        for place, points in enumerate(FAMILIES.values())
    ]
    return ss.Parameters(
        *np.concatenate([np.stack(part.broadcast(*PARAMETERS)) for part in parts], axis=1)
    )


def fold_sets(n: int) -> list[dict[str, float]]:
    """Parameters for folds: in turn alpha = 0, all but 0, of any size, and close to 1 + beta; every
    third set without friction.
    """
    rng = np.random.default_rng(181)
    found = []
    for place in range(n):
        beta = float(10 ** rng.uniform(-3, 1.5) * rng.integers(0, 2))
        near = (1 + beta) * (1 + 10 ** rng.uniform(-6, -0.5))
        alpha = (0.0, 10 ** rng.uniform(-8, -2), 10 ** rng.uniform(-2, 2), near)[place % 4]
        mu0 = 10 ** rng.uniform(-2, 1) if place % 3 else 0.0
        numbers = (
            rng.uniform(0.05, 3.09),
            mu0,
            10 ** rng.uniform(-5, 0.5),
            alpha,
            10 ** rng.uniform(-3, 1.5),
            beta,
        )
        found.append(dict(zip(PARAMETERS, map(float, numbers), strict=True)))
    return found


@dataclass(frozen=True)
class Agreement:
    """Among the points that are vouched for: wrong counts and kinds, and the largest error over
    both error bounds together.
    """

    wrong: int
    largest: float
    error: float  #: the largest over max(1, |value|)


def against_python(found: Found, p: ss.Parameters, contact: bool) -> Agreement:
    """NumPy with its ladder is the reference."""
    eq = on_backend("numpy", 1, partial(ss.equilibria, contact=contact), p)
    slots = eq.theta.shape[1]
    vouched = found.status == 0
    same = vouched & (found.count == eq.count)
    written = same[:, None] & (np.arange(slots) < eq.count[:, None])
    other = (found.columns["stability"][:, :slots] != eq.undamped) & written
    largest = worst = 0.0
    for name in ("theta", "L", "x", "y"):
        ours, exact = found.columns[name][:, :slots][written], getattr(eq, name)[written]
        error = np.abs(ours - exact) / np.maximum(1, np.abs(exact))
        largest = max(
            largest,
            float(
                (error / (found.columns["error"][:, :slots] + eq.error)[written]).max(initial=0.0)
            ),
        )
        worst = max(worst, float(error.max(initial=0.0)))
    return Agreement(int((vouched & ~same).sum() + other.sum()), largest, worst)


def unlike_c(
    found: Found, library: ctypes.CDLL, p: ss.Parameters, contact: bool
) -> NDArray[np.bool_]:
    """Points at which a bit of what the C library writes differs, whether it is vouched for or
    not.
    """
    out = c_target.room(p.shape[0])
    c_target.solve(library, c_target.table(p), out, contact, batch=False)
    differs = (found.status != out.status) | (found.count != out.count)
    filled = np.arange(4) < out.count[:, None]
    for name, column in found.columns.items():
        differs |= ((column != out.equilibria[name]) & filled).any(axis=-1)
    return np.asarray(differs)
