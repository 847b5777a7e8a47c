"""A branch of cycles against AUTO-07p, the standard continuation code: the Hopf point where it
begins, and cycles on it.

``python -m benchmarks.bench_auto`` prints both, and the time of a point of either branch: processor
time here, AUTO's own clock there. AUTO finds cycles by orthogonal collocation, without integrating;
Debian has it as ``auto-07p``, which also needs ``gfortran``. The model is the shipped
``stick_slip``: no contact is lost, and the friction law is smooth; between the Hopf point and V =
0.159 the slip keeps its sign.
"""

import math
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import spragsym as ss

#: Belt speeds at which cycles are compared; at the last one the slip changes its sign.
SPEEDS = (0.105, 0.11, 0.13, 0.2)

#: What AUTO compiles: the field, and where it begins.
_PROGRAM = """\
SUBROUTINE FUNC(NDIM,U,ICP,PAR,IJAC,F,DFDU,DFDP)
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM, IJAC, ICP(*)
  DOUBLE PRECISION, INTENT(IN) :: U(NDIM), PAR(*)
  DOUBLE PRECISION, INTENT(OUT) :: F(NDIM)
  DOUBLE PRECISION, INTENT(INOUT) :: DFDU(NDIM,*), DFDP(NDIM,*)
{field}END SUBROUTINE FUNC
SUBROUTINE STPNT(NDIM,U,PAR,T)
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM
  DOUBLE PRECISION, INTENT(INOUT) :: U(NDIM), PAR(*)
  DOUBLE PRECISION, INTENT(IN) :: T
{start}END SUBROUTINE STPNT
SUBROUTINE BCND
END SUBROUTINE BCND
SUBROUTINE ICND
END SUBROUTINE ICND
SUBROUTINE FOPT
END SUBROUTINE FOPT
SUBROUTINE PVLS
END SUBROUTINE PVLS
"""
_FIELD = """\
  DOUBLE PRECISION :: S
  S = PAR(1) - U(2)
  F(1) = U(2)
  F(2) = 2d0*{mu_s}d0*S*{v_s}d0/(S*S + {v_s}d0**2) - {zeta}d0*U(2) - U(1)
"""
_START = """\
  PAR(1) = 0.09d0
  U(1) = 2d0*{mu_s}d0*PAR(1)*{v_s}d0/(PAR(1)**2 + {v_s}d0**2)
  U(2) = 0d0
"""

_SCRIPT = """\
steady = run(e="peer", NDIM=2, IPS=1, ICP=["V"], parnames={{1: "V", 11: "T"}}, ISP=2, NMX=60, DS=0.005, DSMAX=0.01, DSMIN=1e-8,
             EPSL=1e-11, EPSU=1e-11, EPSS=1e-10, UZSTOP={{"V": 0.12}}, JAC=0, NPR=1000)
save(steady, "steady")
cycles = run(steady("HB1"), IPS=2, ICP=["V", "T"], NTST={intervals}, NCOL=7, NMX=400, DS=1e-3, DSMAX=0.02, ISP=0, IADS=1,
             UZR={{"V": {speeds}}}, UZSTOP={{"V": 0.21}}, NPR=1000)
save(cycles, "cycles")
"""


def installed() -> bool:
    """Whether AUTO is there."""
    return shutil.which("auto-07p") is not None and shutil.which("gfortran") is not None


def run(
    field: str, start: str, script: str, *branches: str
) -> tuple[list[list[list[float]]], list[float]]:
    """Rows of each branch that AUTO saves under these names, and the times that it tells."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        program = _PROGRAM.format(field=field, start=start)
        (folder / "peer.f90").write_text(program, encoding="utf-8")
        (folder / "run.auto").write_text(script, encoding="utf-8")
        done = subprocess.run(
            ["auto-07p", "run.auto"],
            cwd=folder,
            capture_output=True,
            text=True,
            timeout=600,
            check=False,
        )
        if not (folder / f"b.{branches[-1]}").is_file():
            raise RuntimeError(
                f"AUTO did not end as it should:\n{done.stdout[-2000:]}{done.stderr[-2000:]}"
            )
        found = [rows(folder / f"b.{branch}") for branch in branches]
    return found, [float(one) for one in re.findall(r"Total Time\s+(\S+)", done.stdout)]


def by_auto(intervals: int = 60) -> tuple[float, dict[float, tuple[float, float]], float]:
    """V of the Hopf point; period and largest x of the cycles, by V; seconds a point of the
    branch.
    """
    base = ss.load("stick_slip").base
    script = _SCRIPT.format(intervals=intervals, speeds=list(SPEEDS))
    (steady, on_cycles), times = run(
        _FIELD.format(**base), _START.format(**base), script, "steady", "cycles"
    )
    hopf = next(row[4] for row in steady if row[2] == 3)  # type 3: Hopf point
    cycles = {
        row[4]: (row[8], row[6]) for row in on_cycles if row[2] == -4
    }  # type −4: as asked for
    spent = times[-1] / len(on_cycles)
    return (
        hopf,
        {
            speed: min((abs(speed - at), found) for at, found in cycles.items())[1]
            for speed in SPEEDS
        },
        spent,
    )


def rows(path: Path) -> list[list[float]]:
    """Branch, point, type, label, V, norm, maxima of x and v, period."""
    table = [line.split() for line in path.read_text(encoding="utf-8").splitlines()]
    return [[float(value) for value in row] for row in table if row and row[0] not in ("0", "-0")]


def hopf_exactly() -> float:
    """Where steady sliding loses its stability: ζ = 2 μ_s v_s (V² − v_s²)/(V² + v_s²)², the smaller
    V beyond v_s.
    """
    base = ss.load("stick_slip").base
    mu_s, v_s, zeta = base["mu_s"], base["v_s"], base["zeta"]
    # With w = V² + v_s²: ζ w² − 2 μ_s v_s w + 4 μ_s v_s³ = 0.
    half = mu_s * v_s / zeta
    return math.sqrt(half - math.sqrt(half**2 - 4 * mu_s * v_s**3 / zeta) - v_s**2)


def ours() -> tuple[float, dict[float, tuple[float, float]], float]:
    """The same by the branch of cycles."""
    model = ss.load("stick_slip")
    first = ss.cycle(model.Parameters(V=0.2))
    begin = time.process_time()
    branch = ss.cycle_branch(first, "V", between={"V": (0.08, 0.21)})
    spent = (time.process_time() - begin) / len(branch.values)
    found = {}
    for speed in SPEEDS:
        near = min(branch.cycles, key=lambda cycle: abs(cycle.parameters["V"] - speed))
        cycle = ss.cycle(model.Parameters(V=speed), near=near)
        found[speed] = (cycle.period, float(cycle.state[0]))
    return branch.of("end")[0].value, found, spent


def main() -> None:
    """Print the table."""
    if not installed():
        sys.exit("AUTO is not installed: apt-get install auto-07p gfortran")
    (their_hopf, theirs, their_time), (our_hopf, own, our_time) = by_auto(), ours()
    exact = hopf_exactly()
    print(
        f"Hopf point: exactly V = {exact:.12f}; AUTO {their_hopf - exact:+.1e}; the branch's "
        f"end here {our_hopf - exact:+.1e}\n"
    )
    print(
        "| V | period here | AUTO's less ours | largest x here | AUTO's less ours "
        "|\n|---|---|---|---|---|"
    )
    for speed in SPEEDS:
        (period, top), (their_period, their_top) = own[speed], theirs[speed]
        print(
            f"| {speed} | {period:.12f} | {their_period - period:+.1e} | {top:.12f} | "
            f"{their_top - top:+.1e} |"
        )
    print(
        f"\nA point of the branch: {1e3 * our_time:.1f} ms here, {1e3 * their_time:.1f} ms by "
        "AUTO's own clock"
    )


if __name__ == "__main__":
    main()
