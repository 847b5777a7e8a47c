"""Verdicts of random files of five models against their states, stepped through by hand as friction
rises.

At each friction the state that lies nearest to the last one is taken up; where none lies near, the
step is halved, and the state has ended where that goes on. It guards the claim that no report says
"does not sprag" while the state at work ends within the range.
"""

import math
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.models.load import load
from spragsym.report.example import example

CASES = 200
MODELS = ("kang_nam", "sprag_rod", "two_springs", "cubic_contact", "damped")
#: How far the next state may lie; the first and the least step; and how closely the two ends agree.
NEAR, STEP, LEAST, CLOSE = 0.02, 0.02, 1e-6, 1e-3


def end_by_hand(p: Any, most: float) -> float:
    """The friction at which the state that is followed ends, NaN where it does not up to
    ``most``.
    """
    path = ss.quasi_static_path(p, "mu0", [0.0])
    here, mu, step = (
        np.array([path.coordinates[name][0] for name in p.model.coordinates]),
        0.0,
        STEP,
    )
    while mu < most:
        at = min(mu + step, most)
        eq = ss.equilibria(p.replace(mu0=at), method="search")
        states = np.array(
            [eq.coordinates[name][: int(eq.count)] for name in p.model.coordinates]
        ).reshape(here.size, -1)
        off = (
            np.abs(states - here[:, None]).max(axis=0, initial=0.0)
            if states.size
            else np.array([math.inf])
        )
        if off.min() < NEAR:
            here, mu, step = states[:, off.argmin()], at, min(STEP, 2 * step)
        elif step < LEAST:
            return mu
        else:
            step /= 2
    return math.nan


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One file: the example of a model with its numbers changed at random."""
    name = MODELS[number % len(MODELS)]
    lines = []
    for line in example(load(name)).splitlines():
        key, _, rest = line.partition(" = ")
        value, _, unit = rest.partition("#")[0].strip(' "').partition(" +-")[0].partition(" ")
        if key in ("theta0", "mu0"):
            drawn = (
                rng.uniform(10.0, 60.0 if name == "sprag_rod" else 110.0)
                if key == "theta0"
                else rng.uniform(0.05, 0.8)
            )
            rest = f'"{drawn:.6g} {"deg" if key == "theta0" else ""}"'
        elif key in ("k", "k_x", "k_t", "F_L", "psi", "k_2", "k_3"):
            rest = f'"{float(value) * 3 ** rng.uniform(-1, 1):.6g} {unit}"'
        lines.append(f"{key} = {rest}" if rest else line)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "brake.toml"
        file.write_text("\n".join(lines), encoding="utf-8")
        study = ss.Study.from_file(file)
    report = study.report(probability=False, redesign=False, oscillation=False)
    verdict = report.verdict
    end = end_by_hand(study.dimensionless, study.full_slip[2])
    spared, wrong = "does not sprag" in verdict, []
    if spared == (end < math.inf) and abs(end - study.full_slip[2]) > CLOSE:
        wrong = [f"file {number} of {name}: ends at {end:.6g} by hand; {verdict}"]
    if end < study.full_slip[2] and not math.isclose(
        report.jump_at or math.nan, end, abs_tol=CLOSE
    ):
        wrong = [f"file {number} of {name}: jumps at {report.jump_at}, by hand at {end:.6g}"]
    return {"kind": f"{name}, {'does not' if spared else 'sprags'}", "wrong": wrong}
