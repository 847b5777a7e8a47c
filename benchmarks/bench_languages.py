"""JavaScript and MATLAB beside C and Python: speed, and every family against NumPy with its ladder
and against C, bit for bit.

``python -m benchmarks.bench_languages [N]``: N points of each family and regime, 10 000 by default;
Markdown tables.
"""

import os
import sys

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import ctypes
from collections.abc import Callable
from functools import cache, partial

import numpy as np

import spragsym as ss
from benchmarks.timing import best, on_backend
from tests.oracles import c_target, languages
from tests.oracles.families import FAMILIES, random

_WAYS: dict[str, tuple[str | None, Callable[[ss.Parameters, bool], languages.Found]]] = {
    "JavaScript, node": (languages.NODE, languages.in_node),
    "MATLAB, Octave": (languages.OCTAVE, languages.in_octave),
}


def main(n: int = 10_000) -> None:
    """Print both tables."""
    ways = {title: run for title, (there, run) in _WAYS.items() if there}
    print(
        "".join(
            f"{title.split(', ')[1]} is not on this machine.\n\n"
            for title, (there, _) in _WAYS.items()
            if not there
        ),
        end="",
    )
    speed(ways, 10 * n)
    print()
    trust(ways, n)


def speed(ways: dict[str, Callable[[ss.Parameters, bool], languages.Found]], n: int) -> None:
    """Nanoseconds a point, from the parameters to states, stability and error bounds."""
    p = random(np.random.default_rng(1), n)
    taken = {title: run(p, True).nanoseconds for title, run in ways.items()}
    taken["NumPy"] = 1e9 * best(partial(on_backend, "numpy", 1, ss.equilibria, p)) / n
    if compiler := c_target.compiler():
        rows, out = c_target.table(p), c_target.room(n)
        for title, batch in (("C, one point a call", False), ("C, batch", True)):
            library = c_target.build(compiler, c_target.FAST)
            taken[title] = 1e9 * best(partial(c_target.solve, library, rows, out, batch=batch)) / n
    print(
        f"{n:,} random points in contact, one thread, from the parameters to states, "
        "stability and error bounds.\n"
    )
    print("| method | ns a point | time over the fastest |\n|---|---|---|")
    for title, nanoseconds in taken.items():
        print(f"| {title} | {nanoseconds:,.0f} | {nanoseconds / min(taken.values()):.1f} |")


def trust(ways: dict[str, Callable[[ss.Parameters, bool], languages.Found]], n: int) -> None:
    """What each language vouches for in each family, and where it differs from C."""
    print(
        f"{n:,} points of each family. Against NumPy with its ladder: the share that is "
        "vouched for; among these wrong counts or kinds, "
        "and the largest error over both error bounds together. Against C: points at which a "
        "bit of the results differs.\n"
    )
    print(
        "| family | regime | language | vouched for | wrong | largest / bounds | not as C "
        "|\n|---|---|---|---|---|---|---|"
    )
    for place, (family, points) in enumerate(FAMILIES.items()):
        p = points(np.random.default_rng([6, place]), n)
        for contact in (True, False):
            for title, run in ways.items():
                print(
                    f"| {family} | {'contact' if contact else 'lift-off'} | {title} "
                    f"|{compared(run(p, contact), p, contact)}",
                    flush=True,
                )


def compared(found: languages.Found, p: ss.Parameters, contact: bool) -> str:
    """The rest of a row."""
    agreement = languages.against_python(found, p, contact)
    library = _library()
    unlike = (
        np.count_nonzero(languages.unlike_c(found, library, p, contact))
        if library
        else "no compiler"
    )
    return (
        f" {np.mean(found.status == 0):.3%} | {agreement.wrong} | {agreement.largest:.2f} | "
        f"{unlike} |"
    )


@cache
def _library() -> ctypes.CDLL | None:
    compiler = c_target.compiler()
    return c_target.build(compiler, ("-O1",)) if compiler else None


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
