"""The C target for the benchmarks: built as a user would, called on whole arrays."""

import ctypes
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import spragsym as ss
from spragsym.generated.quantities import PARAMETERS

#: Options with which gcc and clang make vector instructions of the loops; none changes a result.
FAST = ("-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math")
EQUILIBRIUM = np.dtype(
    [*((name, np.float64) for name in ("theta", "L", "x", "y", "error")), ("stability", np.intc)],
    align=True,
)
# One point a call, as a control loop asks.
_LOOP = """
#include "spragsym.h"
void one_by_one(size_t points, const spragsym_parameters given[], spragsym_regime regime,
                spragsym_equilibrium found[][SPRAGSYM_MAX_EQUILIBRIA], int counts[], spragsym_status statuses[]);
void one_by_one(size_t points, const spragsym_parameters given[], spragsym_regime regime,
                spragsym_equilibrium found[][SPRAGSYM_MAX_EQUILIBRIA], int counts[], spragsym_status statuses[]) {
    for (size_t i = 0; i < points; i++) {
        spragsym_model model;
        statuses[i] = spragsym_prepare(&given[i], &model);
        if (statuses[i] == SPRAGSYM_OK) {
            statuses[i] = spragsym_equilibria(&model, regime, found[i], &counts[i]);
        }
    }
}
"""


@dataclass(frozen=True)
class Solved:
    """Equilibria of n points: (n, 4) records, of which the first ``count`` of each point are
    written; 0 in status is vouched for.
    """

    equilibria: NDArray[Any]
    count: NDArray[np.intc]
    status: NDArray[np.intc]


def compiler() -> str | None:
    """The first C compiler on this machine, if any."""
    return next(filter(shutil.which, ("gcc", "clang", "cc")), None)


def build(compiler: str, flags: tuple[str, ...], source: Path | None = None) -> ctypes.CDLL:
    """The C target, from the installed package or from another folder, as a shared library."""
    return load(compiled(compiler, flags, source))


def load(library: bytes) -> ctypes.CDLL:
    """A shared library from its content."""
    with tempfile.TemporaryDirectory() as name:
        (file := Path(name) / "lib.so").write_bytes(library)
        return ctypes.CDLL(str(file))


def compiled(compiler: str, flags: tuple[str, ...], source: Path | None = None) -> bytes:
    """The shared library that a compiler makes of the C target."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file in ("spragsym.h", "spragsym.c"):
            place = source or resources.files("spragsym.generated").joinpath("c")
            (folder / file).write_bytes(place.joinpath(file).read_bytes())
        (folder / "loop.c").write_text(_LOOP, encoding="utf-8")
        command = [
            compiler,
            "-std=c99",
            *flags,
            "-shared",
            "-fPIC",
            "-o",
            "lib.so",
            "loop.c",
            "spragsym.c",
            "-lm",
        ]
        subprocess.run(command, cwd=folder, check=True)
        return (folder / "lib.so").read_bytes()


def table(p: ss.Parameters) -> NDArray[np.float64]:
    """Parameters in the rows that C takes."""
    return np.ascontiguousarray(np.stack(p.broadcast(*PARAMETERS), axis=-1).reshape(-1, 6))


def room(points: int) -> Solved:
    """Arrays for the results of this many points."""
    return Solved(
        np.zeros((points, 4), EQUILIBRIUM), np.zeros(points, np.intc), np.zeros(points, np.intc)
    )


def solve(
    library: ctypes.CDLL,
    rows: NDArray[np.float64],
    out: Solved,
    contact: bool = True,
    batch: bool = True,
) -> None:
    """All points into ``out``, in one call of the batch or one by one."""
    function = library.spragsym_equilibria_batch if batch else library.one_by_one
    pointers = (
        array.ctypes.data_as(ctypes.c_void_p) for array in (out.equilibria, out.count, out.status)
    )
    function(
        ctypes.c_size_t(len(rows)),
        rows.ctypes.data_as(ctypes.c_void_p),
        ctypes.c_int(contact),
        *pointers,
    )


def in_contact(library: ctypes.CDLL, out: Solved, p: ss.Parameters, batch: bool = True) -> Solved:
    """All points in contact into the first rows of ``out``, from parameters as Python has them."""
    rows = table(p)
    some = Solved(*(part[: len(rows)] for part in (out.equilibria, out.count, out.status)))
    solve(library, rows, some, batch=batch)
    return some
