"""Generated functions of a model in floats, intervals, 50 digits and C: each held against the 50 digits."""

from __future__ import annotations

import ctypes
import inspect
import subprocess
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import mpmath as mp
import numpy as np

from spragsym.cli import main as command
from spragsym.numerics.interval_arrays import Intervals
from spragsym.statics.mechanics.laws import XP
from tests.oracles.by_hand import load
from tests.support import with_angles

DIGITS = 50
WIDE = SimpleNamespace(sqrt=mp.sqrt, exp=mp.exp, log=mp.log, sign=mp.sign, atan2=mp.atan2, pi=mp.pi)
#: What C may differ from Python by, over the size of the numbers that a result is made of.
CLOSE = 1e-12


def functions(model: Any) -> Iterator[tuple[str, Any]]:
    """All of the generated functions of a model, by name."""
    for name in model.algebra.__all__:
        yield name, getattr(model.algebra, name)


def arguments(names: Sequence[str], rng: np.random.Generator) -> list[float]:
    """A number for each name, as it may be: switches 0 or 1, sides ±1, lengths and parameters positive, cosines and sines of angles.

    Coordinates and rates are small or large, so that springs turn a little, or around.
    """
    angles: dict[str, float] = {}
    spread, values = rng.choice([0.3, 1.5]), []
    for name in names:
        if name == "pushing" or name.startswith("near"):
            values.append(float(rng.integers(2)))
        elif name == "side" or name.startswith("way"):
            values.append(float(rng.choice([-1.0, 1.0])))
        elif name.startswith(("cos", "sin")) or (name[0] in "cs" and name[1:].isdigit()):
            angle = angles.setdefault(name.lstrip("cosin"), rng.uniform(-3.1, 3.1))
            values.append(float((np.cos if name[0] == "c" else np.sin)(angle)))
        elif name[0] in "xyv" and name not in ("v_s",):
            values.append(float(rng.normal(0, spread)))
        else:
            values.append(float(10 ** rng.uniform(-2, 1)))
    if "y" in names:
        at = names.index("y")
        values[at] = -abs(values[at])  # in contact, where a law that is no polynomial has a value
    return values


def flat(value: Any) -> list[Any]:
    """Results in a row."""
    return [entry for part in value for entry in flat(part)] if isinstance(value, tuple | list) else [value]


def library(name: str, model: Any, folder: Path) -> Any:
    """The model in C, compiled."""
    try:
        command(["export", "--model", model.where, "--out", str(folder)])
    except SystemExit as ended:
        if ended.code:
            raise
    (source,) = (path for path in folder.glob("*.c") if path.name != "main.c")
    build = [
        *["cc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-O1", "-shared", "-fPIC"],
        str(source),
        "-lm",
        "-o",
        str(folder / "model.so"),
    ]
    subprocess.run(build, check=True, timeout=300)
    return ctypes.CDLL(str(folder / "model.so")), source.stem


def compare(name: str, count: int, seed: int, folder: Path) -> list[str]:
    """What is off with the functions of one model."""
    model = load(name, folder)
    code, prefix = library(name, model, folder / f"{name}_c")
    rng, wrong = np.random.default_rng([seed, *name.encode()]), []
    for called, function in functions(model):
        plain = inspect.unwrap(function)
        names = [key for key, it in inspect.signature(plain).parameters.items() if it.kind is not it.KEYWORD_ONLY]
        taken = {"xp"} & set(inspect.signature(plain).parameters)
        in_c = getattr(code, f"{prefix}_{called}", None)
        for _ in range(count):
            given = arguments(names, rng)
            floats = np.array([float(part) for part in flat(function(*given))])
            if not floats.size:
                continue
            with mp.workdps(DIGITS):
                wide = flat(plain(*map(mp.mpf, given), **({"xp": WIDE} if taken else {})))
            exact = np.array([float(part) for part in wide])
            size = 1.0 + np.abs(exact).max()
            if not np.abs(floats - exact).max() <= 1e-9 * size:
                wrong.append(f"{name}.{called}: floats {floats} and 50 digits {exact} at {dict(zip(names, given, strict=True))}")
            if in_c is not None:
                room = (ctypes.c_double * floats.size)()
                in_c(*map(ctypes.c_double, with_angles(model, function, given)), room)
                if not np.abs(np.array(room[:]) - floats).max() <= CLOSE * size:
                    wrong.append(f"{name}.{called}: C {room[:]} and Python {floats} at {dict(zip(names, given, strict=True))}")
            wrong += enclosed(f"{name}.{called}", plain, given, wide, {"xp": XP} if taken else {})
    return wrong


def enclosed(place: str, plain: Any, given: Sequence[float], wide: Sequence[Any], namespace: dict[str, Any]) -> list[str]:
    """Whether intervals, of points, hold the results in many digits."""
    try:
        results = flat(plain(*(Intervals.point(np.array([value])) for value in given), **namespace))
    except (AttributeError, TypeError, ValueError) as error:
        return [] if "energy" in place else [f"{place}: no intervals: {error}"]
    return [
        f"{place}: {part} is not in [{bound.low[0]!r}, {bound.high[0]!r}]"
        for part, bound in zip(wide, results, strict=True)
        if isinstance(bound, Intervals) and not mp.mpf(float(bound.low[0])) <= part <= mp.mpf(float(bound.high[0]))
    ]
