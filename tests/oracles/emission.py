"""Generated functions of a model in floats, intervals and 50 digits: each held against the 50
digits; and their exports in C.
"""

import inspect
import math
import subprocess
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import mpmath as mp
import numpy as np

from spragsym.numerics.interval_arrays import Intervals
from spragsym.statics.namespaces import XP
from tests.oracles.by_hand import load

DIGITS = 50
WIDE = SimpleNamespace(sqrt=mp.sqrt, exp=mp.exp, log=mp.log, sign=mp.sign, atan2=mp.atan2, pi=mp.pi)


def functions(model: Any) -> Iterator[tuple[str, Any]]:
    """All of the generated functions of a model, by name."""
    for name in model.algebra.__all__:
        yield name, getattr(model.algebra, name)


def arguments(names: Sequence[str], rng: np.random.Generator) -> list[float]:
    """A number for each name, as it may be: switches 0 or 1, sides ±1, lengths and parameters
    positive, cosines and sines of angles.

    Coordinates and rates are small or large, so that springs turn a little, or around.
    """
    angles: dict[str, float] = {}
    spread, values = rng.choice([0.3, 1.5]), []
    for name in (one.lstrip("_") for one in names):
        if name.startswith(("pushing", "near")):
            values.append(float(rng.integers(2)))
        elif name.startswith(("side", "way")):
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
    return (
        [entry for part in value for entry in flat(part)]
        if isinstance(value, tuple | list)
        else [value]
    )


def with_angles(
    model: Any, function: Callable[..., Any], given: Sequence[float]
) -> dict[str, float]:
    """Arguments of a generated function by their names, an angle in the place of its cosine and
    sine, as exports take them.
    """
    code = inspect.unwrap(function).__code__
    values = dict(zip(code.co_varnames[: code.co_argcount], given, strict=True))
    named: dict[str, float] = {}
    angle_of = {
        part: (angle, pair) for angle, pair in model.about["angles"].items() for part in pair
    }
    for name, value in values.items():
        angle, (cosine, sine) = angle_of.get(name, (name, ("", "")))
        named.setdefault(
            angle, value if angle == name else math.atan2(values[sine], values[cosine])
        )
    return named


def results_of_c(
    folder: Path,
    library: str,
    calls: Iterable[tuple[str, Sequence[float], int]],
    optimized: str = "-O0",
) -> list[float]:
    """Compile an exported library without a warning, call functions by their names with numbers,
    and read all they write.

    A call is the name of a function, its arguments, and how many numbers it writes.
    """
    lines = []
    for function, given, size in calls:
        listed = ", ".join(float(value).hex() for value in given)
        lines.append(
            f"{{ double r[{size}]; if ({library}_{function}({listed}, r)) return 1; "
            f'for (int i = 0; i < {size}; i++) printf("%.17g\\n", r[i]); }}'
        )
    program = (
        f'#include <stdio.h>\n#include "{library}.h"\nint main(void) {{\n'
        + "\n".join(lines)
        + "\nreturn 0;\n}\n"
    )
    (folder / "try.c").write_text(program, encoding="utf-8")
    build = [
        "cc",
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Werror",
        optimized,
        "try.c",
        f"{library}.c",
        "-lm",
        "-o",
        "try",
    ]
    subprocess.run(build, cwd=folder, check=True, timeout=120)
    shown = subprocess.run(
        ["./try"], cwd=folder, check=True, capture_output=True, text=True, timeout=60
    ).stdout
    return [float(line) for line in shown.split()]


def compare(name: str, count: int, seed: int, folder: Path) -> list[str]:
    """What is off with the functions of one model."""
    model = load(name, folder)
    rng, wrong = np.random.default_rng([seed, *name.encode()]), []
    for called, function in functions(model):
        plain = inspect.unwrap(function)
        names = [
            key
            for key, it in inspect.signature(plain).parameters.items()
            if it.kind is it.POSITIONAL_OR_KEYWORD
        ]
        taken = {"xp"} & set(inspect.signature(plain).parameters)
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
                wrong.append(
                    f"{name}.{called}: floats {floats} and 50 digits {exact} at "
                    f"{dict(zip(names, given, strict=True))}"
                )
            wrong += enclosed(f"{name}.{called}", plain, given, wide, {"xp": XP} if taken else {})
    return wrong


def enclosed(
    place: str, plain: Any, given: Sequence[float], wide: Sequence[Any], namespace: dict[str, Any]
) -> list[str]:
    """Whether intervals, of points, hold the results in many digits."""
    try:
        results = flat(plain(*(Intervals.point(np.array([value])) for value in given), **namespace))
    except (AttributeError, TypeError, ValueError) as error:
        return [] if "energy" in place else [f"{place}: no intervals: {error}"]
    return [
        f"{place}: {part} is not in [{bound.low[0]!r}, {bound.high[0]!r}]"
        for part, bound in zip(wide, results, strict=True)
        if isinstance(bound, Intervals)
        and not mp.mpf(float(bound.low[0])) <= part <= mp.mpf(float(bound.high[0]))
    ]
