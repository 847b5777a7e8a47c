"""The general algorithm beside AUTO-07p, Ibex and SciPy, at the same questions of cubic_contact.

``python -m benchmarks.bench_peers``: processor time here and of SciPy, AUTO's and Ibex's own
clocks. AUTO and SciPy follow or find what lies near a start, without proof; Ibex (``ibexsolve``, on
the PATH) searches the same box as is searched here. Debian has AUTO as ``auto-07p``, which needs
``gfortran`` too. What is not installed is said, and not measured.
"""

import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
import scipy.optimize

import spragsym as ss
from benchmarks.bench_auto import installed, run
from benchmarks.bench_general import ANGLE, from_near
from benchmarks.bench_models import seconds
from spragsym.statics.balance import Balance

#: Tool, seconds, and what it found; no time where the tool is not there.
Row: TypeAlias = tuple[str, float | None, str]

_FIELD = """\
  DOUBLE PRECISION :: X, Y, MU, C0, S0, L
  X = U(1)
  Y = U(2)
  MU = PAR(1)
  C0 = COS(PAR(2))
  S0 = SIN(PAR(2))
  L = SQRT((C0 - X)**2 + (S0 - Y)**2)
  F(1) = -({sigma}d0*((C0 - X)/L - C0 + X) + {alpha}d0*X + MU*({gamma}d0*Y**3 + Y))
  F(2) = -({sigma}d0*((S0 - Y)/L - S0 + Y) + {beta}d0*Y + {kappa}d0 + {gamma}d0*Y**3 + Y)
"""
_START = """\
  PAR(1) = 0d0
  PAR(2) = {angle}d0
  U(1) = {x}d0
  U(2) = {y}d0
"""
_SCRIPT = """\
shared = dict(NDIM=2, IPS=1, parnames={1: "mu0", 2: "theta0"}, DSMIN=1e-8, JAC=0, NPR=1000,
              EPSL=1e-10, EPSU=1e-10, EPSS=1e-9)
branch = run(e="peer", ICP=["mu0"], ISP=1, NMX=400, DS=0.01, DSMAX=0.05, UZSTOP={"mu0": 1.0},
             **shared)
save(branch, "branch")
curve = run(branch("LP1"), ICP=["theta0", "mu0"], ISW=2, ISP=0, NMX=200, DS=0.01, DSMAX=0.05,
            UZSTOP={"theta0": [0.01, 3.1], "mu0": 10.0})
save(curve, "curve")
"""
_BOX = """\
variables
{variables}
constraints
  {sigma}*((cos({angle})-x)/{L}-cos({angle})+x)+{alpha}*x+{mu}*({gamma}*y^3+y)=0;
  {sigma}*((sin({angle})-y)/{L}-sin({angle})+y)+{beta}*y+{kappa}+{gamma}*y^3+y=0;
{more}end
"""
_FOLD = """\
  ({alpha}+{sigma}*(1-(sin({angle})-y)^2/{L}^3))*({beta}+3*{gamma}*y^2+1
  +{sigma}*(1-(cos({angle})-x)^2/{L}^3))-({mu}*(3*{gamma}*y^2+1)
  +{sigma}*(cos({angle})-x)*(sin({angle})-y)/{L}^3)*({sigma}*(cos({angle})-x)*(sin({angle})-y)/{L}^3)=0;
"""


def main() -> None:
    """Print the table."""
    model = ss.load("cubic_contact")
    p = model.Parameters(theta0=ANGLE)
    print("| question | by | ms | found |\n|---|---|---|---|")
    for question, rows in (
        ("equilibria of one point", equilibria(p.replace(mu0=0.5))),
        ("folds along mu0", folds(p)),
        ("curve of folds", curves(p)),
    ):
        for name, spent, found in rows:
            time = "not installed" if spent is None else f"{1e3 * spent:.2g}"
            print(f"| {question} | {name} | {time} | {found} |", flush=True)


def equilibria(p: Any) -> list[Row]:
    """All states of one point."""
    spent, eq = seconds(ss.equilibria, p, method="search")
    balance = Balance(p.model)
    values = balance.floats(np.array([float(p[name]) for name in balance.parameters]))

    def forces(q: Any) -> Any:
        return balance.at(list(q), values, xp=np).rows("forces")

    near, root = seconds(scipy.optimize.fsolve, forces, [1.01 * eq.x[0], 1.01 * eq.y[0]])
    off = np.abs(root - [eq.x[0], eq.y[0]]).max()
    return [
        ("spragsym", spent, f"all {eq.count}, proved"),
        ("SciPy, `fsolve` from near", near, f"1, off by {off:.0e}"),
        by_ibex(p, eq.region),
    ]


def folds(p: Any) -> list[Row]:
    """All folds along the friction."""
    spent, found = seconds(ss.folds, p, "mu0", method="search")
    fold = np.array([found.x[0], found.y[0], found.mu0[0]])
    near, root = seconds(from_near, p.model, p, fold)
    off = np.abs(root - fold).max()
    return [
        ("spragsym", spent, f"all {len(found)}, proved"),
        ("SciPy, `fsolve` from near", near, f"1, off by {off:.0e}"),
        by_auto(p, "branch", found.mu0),
        by_ibex(p, found.region, fold=True),
    ]


def curves(p: Any) -> list[Row]:
    """Folds in the plane of inclination and friction."""
    spent, found = seconds(ss.bifurcation_set, p, method="search")
    points = sum(len(curve.mu0) for curve in found.curves)
    what = f"{len(found.curves)} curves of {points} points, cusps proved"
    return [("spragsym, `bifurcation_set`", spent, what), by_auto(p, "curve", None)]


def by_auto(p: Any, which: str, folds: Any) -> Row:
    """The branch along the friction from 0, or the curve of folds from the first on it."""
    name = "AUTO-07p, the branch from 0" if which == "branch" else "AUTO-07p, one curve from a fold"
    if not installed():
        return name, None, ""
    start = ss.equilibria(p.replace(mu0=0.0))
    numbers = {**p.model.base, "angle": ANGLE, "x": float(start.x[0]), "y": float(start.y[0])}
    (rows,), spent = run(_FIELD.format(**numbers), _START.format(**numbers), _SCRIPT, which)
    if which == "curve":
        return name, spent[1], f"{len(rows)} points"
    turn = next(row[4] for row in rows if abs(row[2]) in (2, 5))  # a limit point, by its kind
    return name, spent[0], f"1, off by {np.abs(turn - folds).min():.0e}"


def by_ibex(p: Any, region: Any, fold: bool = False) -> Row:
    """All roots in a box by interval Newton, HC4 and bisection."""
    if shutil.which("ibexsolve") is None:
        return "Ibex", None, ""
    names = ("x", "y", "mu") if fold else ("x", "y")
    sides = zip(names, np.asarray(region).tolist(), strict=True)
    variables = "\n".join(f"  {name} in [{low!r},{high!r}];" for name, (low, high) in sides)
    angle = repr(ANGLE)
    numbers = {
        **p.model.base,
        "angle": angle,
        "mu": "mu" if fold else float(p["mu0"]),
        "L": f"sqrt((cos({angle})-x)^2+(sin({angle})-y)^2)",
        "variables": variables,
    }
    more = _FOLD.format(**numbers) if fold else ""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "peer.mbx"
        path.write_text(_BOX.format(**numbers, more=more), encoding="utf-8")
        done = subprocess.run(
            ["ibexsolve", str(path)], capture_output=True, text=True, check=False
        ).stdout
    spent, boxes, roots = (
        re.findall(rf"{what}[^\d]*([\d.e+-]+)", done)
        for what in ("cpu time used", "number of cells", "number of solution boxes")
    )
    if not (spent and boxes and roots):
        raise RuntimeError(f"Ibex did not end as it should:\n{done[-2000:]}")
    unknown = re.findall(r"number of (?:unknown|undecided) boxes[^\d]*(\d+)", done)
    left = f", {unknown[0]} undecided" if unknown and int(unknown[0]) else ""
    return "Ibex", float(spent[0].rstrip("s")), f"{roots[0]} proved{left}, {boxes[0]} boxes"


if __name__ == "__main__":
    main()
