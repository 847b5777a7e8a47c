"""Single faults in C, of the solver or of the extension module: operators and numbers in functions, one build each.

A build is killed if it vouches for what is not so over points of every family: a wrong count, kind or order, an error beyond its
bound; if it refuses a point that the sound one answers; if it crashes or does not end. The truth is interval arithmetic's.
"""

from __future__ import annotations

import os
import re
import shutil
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks import c_target
from benchmarks.families import EXTREMES, FAMILIES
from spragsym.statics import ladder

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


def _text(judge: type) -> str:
    return Definitions(sys.modules[judge.__module__].__file__ or "").text([judge.__name__, "mutants"])


class Judge:
    """Points, the truth about them, and how many the sound build answers."""

    def __init__(self, each: int) -> None:
        sets = [family(np.random.default_rng([71, k]), each) for k, family in enumerate(FAMILIES.values())]
        self.rows = np.concatenate([*map(c_target.table, sets), np.array([*UNCERTAIN, *EXTREMES])])
        self.truth = [[ladder.equilibria(*map(float, row), contact=contact) for row in self.rows] for contact in (False, True)]
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
                out = c_target.room(len(self.rows))
                c_target.solve(library, self.rows, out, contact, batch)
                good = out.status == 0
                answered += int(good.sum()) if batch else 0
                for i in np.flatnonzero(good):
                    self.check(self.truth[contact][i], out.equilibria[i, : out.count[i]])
        return answered

    @staticmethod
    def check(true: ladder.Settled, found: Any) -> None:
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
                by = "" if answered >= self.answered else f"{self.answered - answered} points refused"
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
        return by or (f"signal {os.WTERMSIG(status)}" if os.WIFSIGNALED(status) else "")
