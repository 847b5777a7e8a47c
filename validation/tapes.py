"""Operations of tapes against exact numbers, as the compiler of the installation builds them and as
others do.

Each case runs one operation on many operands of every size. What it gives of points inside of them
is compared with fractions, or with Arb where it is a function, and the ends with those that NumPy
gives. Builds are that of the installation, and of gcc and clang with ``-O3 -march=native``, where
they are installed. Last found: of vectors on the ray where angles jump, a sine of −0 gave the angle
−π where the least is π, by NumPy as by C, which is wide but no wrong bound.
"""

import importlib.machinery
import importlib.util
import shutil
import subprocess
import sysconfig
import tempfile
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import flint
import numpy as np

from spragsym.numerics import tape
from spragsym.numerics.interval_arrays import LARGEST_ANGLE, Intervals, quiet
from tests.oracles.operands import OF_THE_LIBRARY, ONE, TWO, operands

CASES = 3 * len([*ONE, *TWO])
#: Operands of a case, and those of which exact values are asked.
COUNT, EXACT = 1_000_000, 20_000
FLAGS = ("-std=c11", "-O3", "-march=native", "-ffp-contract=off", "-shared", "-fPIC")
#: What is exact: of points, by fractions.
EXACTLY: dict[str, Any] = {
    "negative": lambda a: -a,
    "absolute": abs,
    "square": lambda a: a * a,
    "cube": lambda a: a**3,
    "sum": lambda a, b: a + b,
    "difference": lambda a, b: a - b,
    "product": lambda a, b: a * b,
    "quotient": lambda a, b: a / b if b else None,
}
#: By Arb.
BY_ARB: dict[str, Any] = {
    "sqrt": lambda a: a.sqrt() if a >= 0 else None,
    "exp": lambda a: a.exp(),
    "log": lambda a: a.log() if a > 0 else None,
    "tanh": lambda a: a.tanh(),
    "atan": lambda a: a.atan(),
    "cos": lambda a: a.cos() if abs(a) <= LARGEST_ANGLE else None,
    "sin": lambda a: a.sin() if abs(a) <= LARGEST_ANGLE else None,
    "direction": lambda a, b: a / (a * a + b * b).sqrt() if a or b else None,
    "length": lambda a, b: (a * a + b * b).sqrt(),
    "angle None": lambda a, b: flint.arb.atan2(a, b) if a or b > 0 else None,
}


@cache
def built(compiler: str) -> Any:
    """The extension by a compiler; None where that is not installed."""
    if not shutil.which(compiler):
        return None
    source = Path(tape.__file__).with_name("_tape.c")
    place = Path(tempfile.mkdtemp()) / "_tape.so"
    include = sysconfig.get_paths()["include"]
    subprocess.run(
        [compiler, *FLAGS, f"-I{include}", str(source), "-o", str(place), "-lm"], check=True
    )
    loader = importlib.machinery.ExtensionFileLoader("_tape", str(place))
    spec = importlib.util.spec_from_loader("_tape", loader)
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module


def inside(rng: np.random.Generator, given: Intervals, rows: np.ndarray) -> np.ndarray:
    """A float in each interval: an end, or one between them."""
    low, high = given.low[0, rows], given.high[0, rows]
    share = rng.choice([0.0, 1.0, 0.5], rows.size)
    return np.clip(low + share * (high - low), low, high)


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One operation by one build."""
    every = [*ONE, *TWO]
    name, way = every[number % len(every)], number // len(every) % 3
    module = (tape.compiled, built("gcc"), built("clang"))[way]
    kind = ("installed", "gcc", "clang")[way]
    if module is None:
        return {"kind": f"{kind} is missing", "wrong": []}
    function = ONE.get(name, TWO.get(name))
    given = [Intervals(operands(rng, COUNT).ends[:, None]) for _ in range(1 if name in ONE else 2)]
    installed = tape.compiled
    tape.compiled = module
    try:
        made = tape.recorded(lambda *rows: [function(*(row[0] for row in rows))], *given)
        assert made is not None
        found = made(*given)[0]
    finally:
        tape.compiled = installed
    with quiet():
        expected = function(*(part[0] for part in given))
    wrong = []
    if name not in OF_THE_LIBRARY and not np.array_equal(found.ends, expected.ends, equal_nan=True):
        wrong.append(f"{name}: other ends than NumPy's")
    bounded = np.flatnonzero(
        np.logical_and.reduce([np.isfinite(p.ends[:, 0]).all(0) for p in given])
    )
    rows = rng.choice(bounded, EXACT)
    points = [inside(rng, part, rows) for part in given]
    for low, high, *point in zip(found.low[rows], found.high[rows], *points, strict=True):
        if outside(name, low, high, [float(value) for value in point]):
            wrong.append(f"{name} of {point} is not in [{low!r}, {high!r}]")
    return {"kind": kind, "wrong": wrong[:5], "operands": COUNT, "exact": EXACT}


def outside(name: str, low: float, high: float, point: list[float]) -> bool:
    """Whether a value is surely not in an interval; an end that is NaN bounds nothing."""
    if name in EXACTLY:
        value = EXACTLY[name](*map(Fraction, point))
        if value is None:
            return False
        above = not np.isnan(low) and low != -np.inf and (low == np.inf or Fraction(low) > value)
        below = (
            not np.isnan(high) and high != np.inf and (high == -np.inf or Fraction(high) < value)
        )
        return bool(above or below)
    if name not in BY_ARB:
        return False
    value = BY_ARB[name](*map(flint.arb, point))
    if value is None:
        return False
    return bool(flint.arb(low) > value or flint.arb(high) < value)
