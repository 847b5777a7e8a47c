"""Single faults in C, of the solver or of the extension module: operators and numbers in functions, one build each.

A build is killed if it vouches for what is not so over points of every family: a wrong count, kind or order, an error beyond its
bound; if it refuses a point that the sound one answers; if it crashes or does not end. The truth is interval arithmetic's.
"""

from __future__ import annotations

import ctypes
import mmap
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from spragsym.kang_nam.statics import adaptive_precision
from tests.oracles import c_target
from tests.oracles.families import EXTREMES, FAMILIES

from .verdicts import Definitions, Journal, report, stamp

ROOT = Path(__file__).resolve().parents[2]
SOURCE = ROOT / "generated" / "c"
#: What becomes what, outside of comments and declarations; a number is made half as large again, or a third smaller.
_SWAPS = {
    " + ": [" - "], " - ": [" + "], " * ": [" / "], " / ": [" * "], " < ": [" <= ", " >= "], " <= ": [" < ", " > "],
    " > ": [" >= ", " <= "], " >= ": [" > ", " < "], " == ": [" != "], " != ": [" == "], " & ": [" | "], " | ": [" & "],
    " && ": [" || "], " || ": [" && "], "larger(": ["smaller("], "smaller(": ["larger("], "fabs(": ["("],
}  # fmt: skip
_TOKENS = "|".join(re.escape(token) for token in sorted(_SWAPS, key=len, reverse=True))
_TOKEN = re.compile(_TOKENS + r"|(?<![\w.\[])\d+\.\d+(?!\w)")
_FUNCTION = re.compile(r"^(?:INLINE|CLONED|static|spragsym_status)\s[^;{}]*?(\w+)\([^;{}]*\)\s*\{.*?(?:^\}|\}$)", re.M | re.S)
SECONDS = 20
OK, UNSURE, REFUSED, TOO_LARGE = range(4)
#: So far apart that double-double arithmetic is not what its bounds say; and of such numbers double settles none.
IMMODERATE = (
    (1.2327756113845494, 4.53e21, 7.32e-53, 6.145e51, 2.6e-32, 1.748e49),
    (1.7472274646865769, 2.618e-14, 7396.0, 1.605e-07, 1.298e-97, 9.32e-64),
    (1.3664280351761058, 3.45e90, 1.433e12, 3.5579e34, 1.27e29, 9.49e41),
)
#: What is no parameter: place in the row, and value.
BAD = (
    *((0, value) for value in (0.0, -1.0, np.pi, 3.5, np.nan, np.inf)),
    *((place, value) for place in (1, 3, 5) for value in (-1e-9, -1.0, np.nan, np.inf, -np.inf)),
    *((place, value) for place in (2, 4) for value in (0.0, -1.0, np.nan, np.inf)),
)
#: Parameters whose products double can't carry.
LARGE = np.array([[1.0, 0.5, 1e200, 1e200, 1e200, 1.0], [1.0, 1e300, 0.1, 1e300, 1e300, 1e300]])
#: What kills: all points at once.
_JUDGE = "judge"
#: An index beyond an array ends the process, and what was not written is no 0. Not optimized, for one processor, with functions
#: that are called: a build takes a sixth of the time, and no result depends on it.
FLAGS = (
    "-O0", "-w", "-DSPRAGSYM_ONE_BUILD", "-Dalways_inline=unused", "-fsanitize=bounds", "-fsanitize-undefined-trap-on-error",
    "-ftrivial-auto-var-init=pattern",
)  # fmt: skip
#: Next to folds, three equilibria of which double precision sees one root and a pair that is just not real.
UNCERTAIN = (
    (1.2583725526692275, 0.9727285282098654, 0.0014415578928869272, 0.027528229942740796, 0.711415357262657, 1.538440875454435),
    (
        1.208299505033335,
        0.026185148164344228,
        0.08808921239277893,
        0.0034529035552188516,
        0.18620697240360706,
        0.9564124508434441,
    ),
)


def mutants(text: str, functions: list[str]) -> Iterator[tuple[str, int, str]]:
    """Key, line and text of every fault in the named functions."""
    seen: Counter[str] = Counter()
    for function in _FUNCTION.finditer(text):
        for token in _TOKEN.finditer(text, function.start(), function.end()) if function[1] in functions else ():
            if text.rfind("/*", 0, token.start()) > text.rfind("*/", 0, token.start()):
                continue
            number = re.fullmatch(r"[\d.]+", token[0]) and float(token[0])
            others = _SWAPS[token[0]] if number is None else [repr(number * 1.5), repr(number / 1.5)] if number else ["1.0"]
            start = text.rfind("\n", 0, token.start()) + 1
            line = text[start : text.find("\n", token.start())].strip()
            for other in others:
                key = f"{function[1]}: {line} : {token[0].strip()} -> {other.strip()}"
                seen[key] += 1
                name = key if seen[key] == 1 else f"{key} #{seen[key]}"
                yield name, text.count("\n", 0, start) + 1, text[: token.start()] + other + text[token.end() :]


def run(name: str, subject: dict[str, Any], results: Path, only: set[str], listed: set[str], quick: bool) -> int:
    """All mutants without a verdict that holds; 1 if one survives that nobody has explained."""
    from .extension import Extension

    text = (ROOT / subject["source"]).read_text(encoding="utf-8")
    judge = (Extension if subject.get("extension") else Judge)(40)
    stamps = {
        _JUDGE: stamp(re.sub(r"/\*.*?\*/", "", text, flags=re.S), *(_text(one) for one in dict.fromkeys((Judge, type(judge)))))
    }
    journal = Journal(results / f"{name}.jsonl")
    every = list(mutants(text, subject["in_c"]))

    def known(key: str) -> bool:
        return journal.killed(key, stamps) or stamps[_JUDGE] in journal.survived(key)

    waiting = [mutant for mutant in every if (mutant[0] in only if only else not known(mutant[0]))]
    waiting = [mutant for mutant in waiting if not (quick and mutant[0] in listed)]
    try:
        judge.answered = judge.count(text) if waiting else 0
        print(f"{subject['source']}: {judge.answered} answers by the sound build", flush=True)
        for key, _, changed in waiting:
            begun = time.monotonic()
            why = judge.verdict(changed)
            journal.add(key, _JUDGE if why else "", stamps.values(), time.monotonic() - begun)
    finally:
        keys = {key for key, _, _ in every}
        killed = {key for key in keys if journal.killed(key, stamps)}
        left = report(name, {key: line for key, line, _ in every}, killed, set(filter(known, keys)), listed)
    return min(left, 1)


def _filled(points: int) -> c_target.Solved:
    """Room in which nothing is 0 before."""
    out = c_target.room(points)
    for part in (out.equilibria, out.count, out.status):
        part.view(np.uint8)[...] = 7
    return out


def _leaves_nothing(out: c_target.Solved) -> None:
    """Beyond the count all is 0; hints ascend in θ, and stand where the mass can be."""
    for status, count, states in zip(out.status, out.count, out.equilibria, strict=True):
        if status in (OK, UNSURE):
            assert not any(state[name] for state in states[count:] for name in states.dtype.names), "beyond the count"
            assert (np.diff(states["theta"][:count]) >= 0).all(), "order"
            assert (states["L"][:count] > 0).all(), "length"


def _refuses(library: Any, rows: Any, out: c_target.Solved, contact: bool, batch: bool) -> None:
    """What is no parameter is refused, what double can't carry as well; points beside them are as before."""
    places = np.arange(len(BAD) + len(LARGE)) * 2
    some = np.repeat(rows[: len(places)], 2, axis=0)
    for place, (parameter, value) in zip(places, BAD, strict=False):
        some[place, parameter] = value
    some[places[len(BAD) :]] = LARGE
    again = _filled(len(some))
    c_target.solve(library, some, again, contact, batch)
    assert (again.status[places[: len(BAD)]] == REFUSED).all(), "no parameter"
    assert (again.status[places[len(BAD) :]] == TOO_LARGE).all(), "out of range"
    assert (again.status[places + 1] == out.status[: len(places)]).all(), "status of neighbours"
    assert (again.equilibria[places + 1] == out.equilibria[: len(places)]).all(), "neighbours"
    if batch:
        assert not again.count[places].any(), "count of what is refused"
        assert not any(again.equilibria[name][places].any() for name in again.equilibria.dtype.names or ()), "what is refused"
    at_the_edge = np.full((7, 6), 0.5)
    at_the_edge[:2] = [1.0, 0.0, 0.1, 0.0, 0.5, 0.0], [np.nextafter(np.pi, 0), 0.5, 0.1, 0.1, 0.5, 0.1]
    at_the_edge[range(2, 7), range(1, 6)] = np.finfo(float).max
    c_target.solve(library, at_the_edge, again, contact, batch)
    assert (again.status[:7] != REFUSED).all(), "a parameter at its limit"


def _sizes(library: Any, rows: Any, out: c_target.Solved, contact: bool) -> None:
    """Batches that are full to the last, or by one more or less: the same, the worst status, and nothing beyond the last."""
    for size in (0, 1, 63, 64, 65, 129, len(rows)):
        given, again = at_the_end(rows[:size]) if size else rows, _filled(size + 1)
        worst = _batch(library, size, given.ctypes.data, int(contact), *(_pointer(part) for part in _parts(again)))
        for part, whole in zip(_parts(again), _parts(out), strict=True):
            assert (part[:size] == whole[:size]).all(), "size"
            assert (part[size:].view(np.uint8) == 7).all(), "beyond the last"
        assert worst == max(out.status[:size], default=OK), "worst status"


def at_the_end(values: Any) -> Any:
    """A copy that ends at the border of a page that may not be touched."""
    page = mmap.PAGESIZE
    pages = -(-values.nbytes // page)
    memory = mmap.mmap(-1, (pages + 1) * page)
    start = ctypes.addressof(ctypes.c_char.from_buffer(memory))
    if ctypes.CDLL(None).mprotect(ctypes.c_void_p(start + pages * page), ctypes.c_size_t(page), 0):
        raise OSError("mprotect")
    flat = np.frombuffer(memory, dtype=values.dtype, count=values.size, offset=pages * page - values.nbytes)
    copy = flat.reshape(values.shape)
    copy[...] = values
    return copy


def _pointers(library: Any, rows: Any, contact: bool) -> None:
    """Without a place to read from or write to, or a regime, nothing is done."""
    out, model = _filled(1), np.zeros(100)
    given, model_at, (states, count, status) = rows.ctypes.data, model.ctypes.data, map(_pointer, _parts(out))
    assert library.spragsym_prepare(_void(given), _void(model_at)) == OK, "prepare"
    for call in ((None, model_at), (given, None)):
        assert library.spragsym_prepare(*map(_void, call)) == REFUSED, "prepare without"
    for at, regime, places in (
        (None, contact, (states, count)), (model_at, contact, (None, count)), (model_at, contact, (states, None)),
        (model_at, 2, (states, count)), (model_at, -1, (states, count)),
    ):  # fmt: skip
        assert library.spragsym_equilibria(_void(at), ctypes.c_int(regime), *map(_void, places)) == REFUSED, "without"
    for k in range(4):
        places = [given, states, count, status]
        places[k] = None
        assert _batch(library, 1, places[0], int(contact), *places[1:]) == REFUSED, "batch without"
        assert _batch(library, 0, places[0], int(contact), *places[1:]) == OK, "batch of nothing"
    for regime in (2, -1):
        assert _batch(library, 1, given, regime, states, count, status) == REFUSED, "no regime"
    assert all((part.view(np.uint8) == 7).all() for part in _parts(out)), "written"


def _parts(out: c_target.Solved) -> tuple[Any, ...]:
    return out.equilibria, out.count, out.status


def _pointer(part: Any) -> int:
    return int(part.ctypes.data)


def _void(address: int | None) -> ctypes.c_void_p:
    return ctypes.c_void_p(address)


def _batch(library: Any, size: int, given: int | None, regime: int, *places: int | None) -> int:
    arguments = ctypes.c_size_t(size), _void(given), ctypes.c_int(regime), *map(_void, places)
    return int(library.spragsym_equilibria_batch(*arguments))


def _text(judge: type) -> str:
    return Definitions(sys.modules[judge.__module__].__file__ or "").text([judge.__name__, "mutants"])


#: Batches of several sizes and points one by one, in memory that ends where they do.
_PROGRAM = """
#include "spragsym.h"
#include <stdio.h>
#include <stdlib.h>
int main(void) {
    static spragsym_parameters all[4096];
    const size_t read = fread(all, sizeof all[0], 4096, stdin);
    const size_t sizes[] = {1, 63, 64, 65, 127, read};
    for (int regime = 0; regime < 2; regime++) {
        for (int k = 0; k < 6; k++) {
            const size_t n = sizes[k];
            spragsym_parameters *given = malloc(n * sizeof *given);
            spragsym_equilibrium(*found)[SPRAGSYM_MAX_EQUILIBRIA] = malloc(n * sizeof *found);
            int *counts = malloc(n * sizeof *counts);
            spragsym_status *statuses = malloc(n * sizeof *statuses);
            for (size_t i = 0; i < n; i++) {
                given[i] = all[i];
            }
            spragsym_equilibria_batch(n, given, (spragsym_regime)regime, found, counts, statuses);
            for (size_t i = 0; i < n && k == 5; i++) {
                spragsym_model model;
                if (spragsym_prepare(&given[i], &model) == SPRAGSYM_OK) {
                    spragsym_equilibria(&model, (spragsym_regime)regime, found[i], &counts[i]);
                }
            }
            free(given);
            free(found);
            free(counts);
            free(statuses);
        }
    }
    return 0;
}
"""


def trespass(text: str, rows: Any) -> str:
    """What an address sanitizer says of a build, if anything: what lies beyond an array may be harmless by chance."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "spragsym.h").write_text((SOURCE / "spragsym.h").read_text("utf-8"), "utf-8")
        (folder / "spragsym.c").write_text(text, "utf-8")
        (folder / "main.c").write_text(_PROGRAM, "utf-8")
        flags = [flag for flag in FLAGS if "sanitize" not in flag]
        command = [
            shutil.which("gcc") or "cc",
            "-std=c99",
            *flags,
            "-fsanitize=address",
            "main.c",
            "spragsym.c",
            "-lm",
            "-o",
            "main",
        ]
        subprocess.run(command, cwd=folder, check=True)
        done = subprocess.run([folder / "main"], input=rows.tobytes(), capture_output=True, check=False)
        return done.stderr.decode(errors="replace").partition("\n")[2].partition("\n")[0][:200] if done.returncode else ""


class Judge:
    """Points, the truth about them, and how many the sound build answers."""

    def __init__(self, each: int) -> None:
        sets = [family(np.random.default_rng([71, k]), each) for k, family in enumerate(FAMILIES.values())]
        self.rows = np.concatenate([*map(c_target.table, sets), np.array([*UNCERTAIN, *IMMODERATE, *EXTREMES])])
        self.truth = [
            [adaptive_precision.equilibria(*map(float, row), contact=contact) for row in self.rows] for contact in (False, True)
        ]
        self.answered = 0

    def count(self, text: str) -> int:
        """Points that a build answers; an error where one is wrong."""
        answered = 0
        with tempfile.TemporaryDirectory() as name:
            for file in ("spragsym.h", "spragsym.c"):
                (Path(name) / file).write_text(text if file.endswith(".c") else (SOURCE / file).read_text("utf-8"), "utf-8")
            library = c_target.build(shutil.which("gcc") or "cc", FLAGS, Path(name))
        for contact in (False, True):
            for batch in (False, True):
                out = _filled(len(self.rows))
                c_target.solve(library, self.rows, out, contact, batch)
                good = out.status == OK
                answered += int(good.sum())
                for i in np.flatnonzero(good):
                    self.check(self.truth[contact][i], out.equilibria[i, : out.count[i]])
                _leaves_nothing(out)
                _refuses(library, self.rows, out, contact, batch)
            _sizes(library, self.rows, out, contact)
            _pointers(library, self.rows, contact)
        return answered

    @staticmethod
    def check(true: adaptive_precision.Settled, found: Any) -> None:
        assert len(true.states) == len(found), "count"
        for state, one in zip(true.states, found, strict=True):
            assert state.stability == one["stability"], "stability"
            assert one["error"] <= 1e-12, "bound"
            for name in ("theta", "L", "x", "y"):
                value = float(getattr(state, name))
                assert abs(one[name] - value) <= (one["error"] + 1.2e-16) * max(1.0, abs(value)), f"error of {name}"

    def verdict(self, text: str) -> str:
        """Why a build is not the sound one, if that shows."""
        read, write = os.pipe()
        pid = os.fork()
        if pid == 0:
            signal.setitimer(signal.ITIMER_PROF, SECONDS)
            signal.signal(signal.SIGINT, signal.SIG_DFL)
            quiet = os.open(os.devnull, os.O_WRONLY)
            os.dup2(quiet, 2)
            try:
                answered = self.count(text)
                more = answered - self.answered
                by = f"{-more} points refused" if more < 0 else f"{more} points vouched for without proof" if more else ""
            except Exception as error:
                by = f"{type(error).__name__}: {error}"[:200]
            os.write(write, by.encode())
            os._exit(0)
        os.close(write)
        _, status = os.waitpid(pid, 0)
        with os.fdopen(read) as answer:
            by = answer.read()
        if os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGINT:
            raise KeyboardInterrupt
        by = by or (f"signal {os.WTERMSIG(status)}" if os.WIFSIGNALED(status) else "")
        return by or self.trespasses(text)

    def trespasses(self, text: str) -> str:
        """Whether a build that answers well touches what it must not."""
        return trespass(text, self.rows)
