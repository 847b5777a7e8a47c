"""How the benchmarks measure time: the best of several turns, and processes of their own for what
happens once.
"""

import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np

import spragsym as ss

T = TypeVar("T")


def timed(work: Callable[[], T], clock: Callable[[], float] = time.perf_counter) -> tuple[float, T]:
    """Time of one call, and what it returns."""
    begin = clock()
    found = work()
    return clock() - begin, found


def best(work: Callable[[], object], repeats: int = 5) -> float:
    """The shortest of several calls, which other load on the machine disturbs least; the first call
    is not counted.
    """
    work()
    return min(timed(work)[0] for _ in range(repeats))


def best_in_turn(works: Mapping[str, Callable[[], object]], repeats: int = 7) -> dict[str, float]:
    """The shortest call of each; all take turns, so that other load on the machine meets all
    alike.
    """
    taken = dict.fromkeys(works, np.inf)
    for _ in range(repeats):
        for name, work in works.items():
            taken[name] = min(taken[name], timed(work)[0])
    return taken


@dataclass(frozen=True)
class Call:
    """Call of a function that was watched, by processor time."""

    begin: float
    end: float
    arguments: tuple[Any, ...]
    result: Any


@contextmanager
def watched(owner: Any, name: str) -> Iterator[list[Call]]:
    """Calls of a module's or a class's function, in the order in which they ended."""
    asked, calls = getattr(owner, name), list[Call]()

    def noted(*given: Any, **how: Any) -> Any:
        begin = time.process_time()
        found = asked(*given, **how)
        calls.append(Call(begin, time.process_time(), given, found))
        return found

    setattr(owner, name, noted)
    try:
        yield calls
    finally:
        setattr(owner, name, asked)


def on_backend(name: str, threads: int, work: Callable[[ss.Parameters], T], p: ss.Parameters) -> T:
    """``work(p)`` with a backend, which is set back to the default afterwards."""
    ss.kang_nam.set_backend(name, threads)
    try:
        return work(p)
    finally:
        ss.kang_nam.set_backend("auto")


def in_process(code: str) -> str:
    """What a new interpreter prints that runs ``code``."""
    return subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, text=True
    ).stdout
