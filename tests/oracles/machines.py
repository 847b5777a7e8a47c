"""Every bit of the C target on other machines: builds for each that has a compiler here, and the
same points through all of them.

``python -m tests.oracles.machines [N]``: N points of each family, 10 000 by default; a Markdown
table of the builds, each with the head of a hash over all results. On a machine that is not in the
table, build ``bits.c`` of the C target's tests with its compiler and compare.
"""

import hashlib
import platform
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import spragsym as ss
from spragsym.generated.quantities import PARAMETERS
from tests.oracles.families import FAMILIES

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ROOT / "generated" / "c"
PROGRAM = ROOT / "derive" / "kang_nam" / "runtime" / "c" / "tests" / "bits.c"


@dataclass(frozen=True)
class Machine:
    """A compiler with its flags, and the command that runs what it builds where that is not this
    machine.
    """

    name: str
    compiler: str
    flags: tuple[str, ...]
    runner: tuple[str, ...] = ()

    def missing(self) -> str:
        """What keeps this machine from being tried here; empty if nothing does."""
        needed = [name for name in (self.compiler, *self.runner[:1]) if not shutil.which(name)]
        if needed:
            return f"{' and '.join(needed)} not installed"
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "empty.c").write_text(
                "#include <math.h>\nint main(void) { return 0; }\n", encoding="utf-8"
            )
            if self.built(Path(folder), [Path(folder) / "empty.c"]) is None:
                return f"{self.compiler} {' '.join(self.flags)} builds nothing here"
        return ""

    def built(self, folder: Path, sources: list[Path]) -> Path | None:
        """The program, or nothing where the compiler refuses."""
        target = folder / "program.exe"
        command = [
            self.compiler,
            *self.flags,
            "-Wall",
            "-Wextra",
            "-Werror",
            f"-I{SOURCES}",
            "-o",
            target,
            *sources,
            "-lm",
        ]
        return (
            None
            if subprocess.run(command, capture_output=True, timeout=1800).returncode
            else target
        )

    def results(self, program: Path, points: str) -> str:
        """What the program prints for points."""
        done = subprocess.run(
            [*self.runner, program],
            input=points,
            capture_output=True,
            text=True,
            timeout=1200,
            check=True,
        )
        return done.stdout


HERE = platform.machine()
#: What the makefile of an export puts behind whatever flags it is given.
BEHIND = (
    (ROOT / "derive/emit/targets/c/runtime/Makefile")
    .read_text(encoding="utf-8")
    .split("$(ARCH) ")[1]
    .split("\n")[0]
    .split()
)
CPP = ("-x", "c++", "-std=c++11", "-O2", "-march=native")
#: The first is what the others are compared with.
MACHINES = (
    Machine(f"{HERE}, gcc", "gcc", ("-std=c99", "-O2")),
    Machine(
        f"{HERE}, gcc with extensions and fused operations at hand",
        "gcc",
        ("-std=gnu17", "-O3", "-march=native"),
    ),
    Machine(
        f"{HERE}, clang told to fuse",
        "clang",
        ("-O3", "-march=native", "-ffp-contract=fast", *BEHIND),
    ),
    Machine(f"{HERE}, as C++", "g++", CPP),
    Machine(f"{HERE}, as C++, clang", "clang++", CPP),
    Machine("32 bits with SSE2", "gcc", ("-std=c99", "-O2", "-m32", "-msse2", "-mfpmath=sse")),
    Machine("aarch64", "aarch64-linux-gnu-gcc", ("-O3", "-static"), ("qemu-aarch64",)),
    Machine(
        "aarch64, clang, as Macs have it",
        "clang",
        ("--target=aarch64-linux-gnu", "-O3", "-static"),
        ("qemu-aarch64",),
    ),
    Machine("s390x, big-endian", "s390x-linux-gnu-gcc", ("-O3", "-static"), ("qemu-s390x",)),
    Machine(
        "Windows, x86-64, MinGW",
        "x86_64-w64-mingw32-gcc",
        ("-std=c99", "-O2", "-static"),
        ("wine",),
    ),
)


def points(each: int) -> str:
    """Points of every family, as the bits of six doubles a line."""
    return "".join(_lines(each))


def _lines(each: int) -> Iterator[str]:
    for number, family in enumerate(FAMILIES.values()):
        p: ss.Parameters = family(np.random.default_rng([7, number]), each)
        bits = np.ascontiguousarray(np.stack(p.broadcast(*PARAMETERS), axis=-1)).view(np.uint64)
        for row in bits.tolist():
            yield " ".join(f"{value:016x}" for value in row) + "\n"


def main(each: int = 10_000) -> int:
    """Print the table; the number of builds that differ is the exit code's."""
    given = points(each)
    expected, differing = "", 0
    print(
        f"{each * len(FAMILIES)} points, in contact and in lift-off; "
        f"{platform.platform()}.\n\n| build | flags | hash of all bits | s "
        "|\n|---|---|---|---:|"
    )
    for machine in MACHINES:
        if reason := machine.missing():
            print(
                f"| {machine.name} | `{' '.join(machine.flags)}` | skipped: {reason} | |",
                flush=True,
            )
            continue
        with tempfile.TemporaryDirectory() as folder:
            program = machine.built(Path(folder), [PROGRAM, SOURCES / "spragsym.c"])
            begin = time.perf_counter()
            found = (
                hashlib.sha256(machine.results(program, given).encode()).hexdigest()
                if program
                else "refused"
            )
        expected = expected or found
        differing += found != expected
        spent = time.perf_counter() - begin
        print(
            f"| {machine.name} | `{' '.join(machine.flags)}` | {found[:16]} | {spent:.1f} |",
            flush=True,
        )
    return differing


if __name__ == "__main__":
    sys.exit(main(*(int(argument) for argument in sys.argv[1:2])))
