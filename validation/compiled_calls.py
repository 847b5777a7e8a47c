"""Calls of compiled code with damaged arguments, under the sanitizers of addresses and of undefined
behaviour.

All extension modules are built with both. Each case asks some questions with them; before each call
of compiled code come calls with one argument damaged: of another kind, size or layout, or a number
that no product can hold. These are refused by an exception, or computed. Last found: nothing in
4,500 calls; without the check of sizes, writes beyond the heap in the first case.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.core.extensions import extension
from spragsym.numerics import tape
from spragsym.numerics.interval_arrays import Intervals

CASES = 20
ROOT = Path(__file__).parent.parent
SANITIZED = "-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all"
MODULES = (
    "kang_nam.quartic._compiled",
    "motion._carried",
    "numerics._contractors",
    "numerics._search",
    "numerics._tape",
)
REFUSED = (ValueError, TypeError, BufferError, MemoryError, OverflowError)


@cache
def built() -> str | None:
    """A folder with the package as links and its sanitized modules; None without gcc."""
    if not shutil.which("gcc"):
        return None
    home = Path(tempfile.mkdtemp())
    skipped = shutil.ignore_patterns("*.so", "__pycache__")
    shutil.copytree(ROOT / "spragsym", home / "spragsym", copy_function=os.symlink, ignore=skipped)
    compiler = home / "compiler"  # the last -O counts
    compiler.write_text(f'#!/bin/sh\nexec gcc "$@" {SANITIZED}\n', encoding="utf-8")
    compiler.chmod(0o755)
    command = [sys.executable, "setup.py", "-q", "build_ext", "-b", home, "-t", home / "temporary"]
    subprocess.run(command, cwd=ROOT, env=os.environ | {"CC": str(compiler)}, check=True)
    return str(home)


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """Some questions in a process of their own."""
    home = built()
    if home is None:
        return {"kind": "gcc is missing", "wrong": []}
    library = subprocess.run(
        ["gcc", "-print-file-name=libasan.so"], capture_output=True, text=True, check=True
    ).stdout.strip()
    more = {
        "PYTHONPATH": f"{home}{os.pathsep}{ROOT}",
        "LD_PRELOAD": library,
        "ASAN_OPTIONS": "detect_leaks=0:allocator_may_return_null=1",
        "PYTHONMALLOC": "malloc",
    }
    asked = f"from validation import compiled_calls as it; it.ask({rng.integers(2**31)})"
    done = subprocess.run(
        [sys.executable, "-P", "-c", asked],
        env=os.environ | more,
        capture_output=True,
        text=True,
        timeout=600,
    )
    if done.returncode:
        return {"kind": "ended", "wrong": [done.stderr[-2000:]]}
    return {"kind": "refused or computed", "wrong": [], **json.loads(done.stdout)}


def ask(seed: int) -> None:
    """Questions that call every function, each call after damaged ones; prints their number."""
    rng, made = np.random.default_rng(seed), Counter[str]()
    for name in MODULES:
        module: Any = extension(name)
        for called, function in list(vars(module).items()):
            if callable(function) and not called.startswith("_"):
                setattr(module, called, partial(attacked, function, rng, made))
    point = ss.Parameters.article(theta0=rng.uniform(0.2, 1.4), mu0=rng.uniform(0.2, 0.7))
    ss.equilibria(point)
    ss.equilibria(point, method="search")
    ss.count(point)
    ss.certify(point, between={"mu0": (0.1, 0.11), "sigma": (0.4, 0.42)})
    ss.simulate(point, t_end=5.0, backend="compiled")
    for name in ("kang_nam", "two_springs"):
        model = ss.load(name)
        free = [one for one in model.parameters if one not in model.base]
        p = model.Parameters(**dict(zip(free, rng.uniform(0.3, 0.9, (len(free), 2)), strict=True)))
        ss.equilibria(p, method="search")
        ss.jump_value(p, method="search")
    given = Intervals(np.ones((2, 2, 5)))
    whole: Any = tape.recorded(lambda rows, _: [rows[0] + rows[1]], given, given)
    whole.affine(np.ones((2, 5)), np.ones((3, 2, 5)), np.ones((2, 5)), given)
    print(json.dumps(made))


def attacked(function: Any, rng: np.random.Generator, made: Counter[str], *given: Any) -> Any:
    """The result of a call, after calls of damaged copies of its arguments while it is new."""
    made[function.__name__] += 1
    for _ in range(8 if made[function.__name__] < 20 else 0):
        made["damaged"] += 1
        try:
            function(*damaged(copied(given), rng))
        except REFUSED:
            made["refused"] += 1
    return function(*given)


def copied(value: Any) -> Any:
    """A copy of arrays, also of those in tuples."""
    if isinstance(value, tuple):
        return tuple(map(copied, value))
    return value.copy() if isinstance(value, np.ndarray) else value


def damaged(value: Any, rng: np.random.Generator) -> Any:
    """A value with one fault."""
    if isinstance(value, tuple) and value:
        at = int(rng.integers(len(value)))
        return (*value[:at], damaged(value[at], rng), *value[at + 1 :])
    if isinstance(value, bytes) and value:
        whole = bytearray(value)
        at = int(rng.integers(len(whole) // 4)) * 4
        whole[at : at + 4] = int(rng.choice([-1, 0, 1, 7, 10**6])).to_bytes(
            4, "little", signed=True
        )
        return rng.choice(np.array([bytes(whole), value[:-8], b"", None], object))
    if isinstance(value, np.ndarray):
        others = [value.astype(kind) for kind in (object, np.float32, ">f8", np.int64, np.int8)]
        others += [value[..., :-1], value[..., ::2], value.T, value[:0], value.ravel()[1:]]
        value.flags.writeable = False
        return [*others, value][rng.integers(11)]
    return rng.choice(np.array([-1, 0, 9, 2**31 - 1, 2**54, 2**62, None, b"x"], object))
