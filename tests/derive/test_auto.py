"""What AUTO-07p finds from an exported file: folds and Hopf points, against the searches here; and
what Julia would read.
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("sympy")

import spragsym as ss
from benchmarks import bench_auto
from spragsym.cli import main
from spragsym.derive.emit.targets.auto import fortran

#: Types of special points in AUTO's files.
FOLD, HOPF = 2, 3


def exported(name: str, folder: Path) -> list[str]:
    """The files of a model, and the names of its starts."""
    with pytest.raises(SystemExit, match="0"):
        main(["export", "--model", name, "--language", "auto", "--out", str(folder)])
    return [path.name.split(".", 2)[2] for path in sorted(folder.glob(f"c.{name}.*"))]


def special_points(name: str, folder: Path) -> dict[int, list[float]]:
    """Values of the parameter at folds and Hopf points on all branches, each once."""
    starts = exported(name, folder)
    subprocess.run(
        [str(shutil.which("auto-07p")), f"example_{name}.auto"],
        cwd=folder,
        check=True,
        capture_output=True,
        timeout=120,
    )
    found: dict[int, list[float]] = {FOLD: [], HOPF: []}
    for start in starts:
        for row in bench_auto.rows(folder / f"b.{name}.{start}"):
            known = found.get(int(row[2]), [row[4]])
            if not np.isclose(known, row[4], rtol=1e-6).any():
                known.append(row[4])
    return found


def share(model: ss.Model, p: ss.Parameters) -> float:
    """The friction of a motion over that of statics, which has a law's limit at fast sliding."""
    at_rest = float(model.friction(p, "friction_at_rest"))
    return float(model.friction(p)) / at_rest


def as_at_rest(model: ss.Model) -> ss.Parameters:
    """Base values at which statics has the friction, and its slope, that a motion has at the
    belt's speed.
    """
    p = model.cases()[0][1]
    if model.frictions[0]["at_rest"] != "full":
        return p
    part = share(model, p)
    slope = np.exp(-p["V"] * p["d"]) / part
    return p.replace(mu0=part * p["mu0"], V=-np.log(slope) / p["d"])


@pytest.mark.validate
@pytest.mark.skipif(
    not bench_auto.installed(), reason="there is no auto-07p or no gfortran on this machine"
)
@pytest.mark.parametrize(
    ("name", "folds", "hopf_points"),
    [
        ("kang_nam", 1, 0),
        ("hertz_contact", 1, 0),
        ("sprag_rod", 1, 0),
        ("trolley", 1, 3),
        ("stick_slip", 0, 1),
        ("mode_coupling", 0, 1),
    ],
)
def test_auto_finds_our_folds_and_hopf_points(
    name: str, folds: int, hopf_points: int, tmp_path: Path
) -> None:
    """To eight digits, each of AUTO's among ours, which has those of other states too."""
    found, model = special_points(name, tmp_path), ss.load(name)
    assert (len(found[FOLD]), len(found[HOPF])) == (folds, hopf_points)
    p, along = as_at_rest(model), model.inclination or model.coefficient or model.parameters[0]
    factor = share(model, model.cases()[0][1]) if along == "mu0" else 1.0
    ours = {FOLD: ss.folds, HOPF: ss.flutter_onsets}
    for kind, values in found.items():
        if values:
            exact = ours[kind](p, vary=along)[along]
            off = np.abs(exact - factor * np.array(values)[:, None]).min(axis=1)
            assert (off <= 1e-8 * np.abs(values)).all(), (values, exact)


def test_names_in_fortran_differ_in_more_than_their_case() -> None:
    """Letters that Fortran does not have are spelled, long names are cut, and stay apart."""
    names = ["V_", "v_", "κ_", "ö", "a" * 70, "a" * 71, "_x", "2"]
    made = list(fortran.distinct(names).values())
    assert made[:4] == ["V_", "v__", "kappa_", "o"]
    assert len({name.casefold() for name in made}) == len(names)
    assert all(re.fullmatch(r"[A-Za-z]\w{0,62}", name, re.ASCII) for name in made)


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["coulomb_stick_slip", "forced_oscillator"])
def test_files_of_julia_are_julia(name: str, tmp_path: Path) -> None:
    """By the linter fatou, since Julia is in no package registry that tests install from."""
    if (fatou := shutil.which("fatou", path=Path(sys.executable).parent)) is None:
        pytest.skip("fatou is not installed")
    with pytest.raises(SystemExit, match="0"):
        main(["export", "--model", name, "--language", "julia", "--out", str(tmp_path)])
    files = sorted(map(str, tmp_path.glob("*.jl")))
    assert len(files) == 3
    done = subprocess.run([fatou, "lint", *files], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stdout + done.stderr
