"""What questions of any model cost over one another, in one run; Markdown tables.

``OMP_NUM_THREADS=1 python -m benchmarks.bench_general [MODEL ...]``: processor time, the least of
two calls where they are short. Beside a time over another stands what the answer differs by from
another way to it.
"""

import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
import scipy.optimize

import spragsym as ss
from benchmarks.bench_models import seconds
from benchmarks.timing import watched
from spragsym.bifurcation.tubes import Tubes
from spragsym.models.load import shipped
from spragsym.numerics import boxes
from spragsym.statics.balance import Balance

#: Question, its measure, what it may be at most, and what the answer differs by.
Row: TypeAlias = tuple[str, float, float, str]

MODELS = ("cubic_contact", "hertz_contact", "inclined_belt", "two_springs")
REPORTS = ("kang_nam", "cubic_contact", "two_springs")
POINTS = 1000
#: Searches of fewer boxes have no time a box.
FEWEST = 500
ANGLE = float(np.radians(40.0))


def main(*names: str) -> None:
    """All tables."""
    print("| model | question, over what | measured | at most | answer |")
    print("|---|---|---|---|---|")
    for name in names or MODELS:
        model = ss.load(name)
        for question, measured, most, answer in (*probabilities(model), *searches(model)):
            print(f"| {name} | {question} | {measured:.2g} | {most:g} | {answer} |", flush=True)
    example, *others = map(report, REPORTS)
    for name, spent, most in zip(REPORTS[1:], others, (2, 3), strict=True):
        what = f"report, that of the example, {example:.1f} s"
        print(f"| {name} | {what} | {spent / example:.2g} | {most} | |", flush=True)
    print("\n| model | bifurcation_set, s | onset_curves, s | over it, at most 3 |")
    print("|---|---|---|---|")
    for name in names or shipped():
        print(f"| {name} | {curves(ss.load(name).search)} |", flush=True)


def probabilities(model: Any) -> list[Row]:
    """Probabilities over jump values of many points; shares are known by a jump value, or by
    those of the points.
    """
    jump = float(ss.jump_value(model.Parameters(theta0=ANGLE)))
    low, high = 0.5 * jump, 1.3 * jump
    sigma = model.base["sigma"]
    drawn = {
        "theta0": (0.95 * ANGLE, 1.05 * ANGLE),
        "mu0": (low, high),
        "sigma": (0.9 * sigma, 1.1 * sigma),
    }
    rng = np.random.default_rng(1)
    points = {name: rng.uniform(*ends, POINTS) for name, ends in drawn.items()}
    many, values = seconds(ss.jump_value, model.Parameters(**points))
    out = []
    for given, share, most in (
        ({"theta0": ANGLE, "mu0": (low, high)}, (high - jump) / (high - low), 3),
        (drawn, np.mean(values <= points["mu0"]), 10),
    ):
        spent, found = seconds(ss.jump_probability, given, model=model, rng=1)
        free = sum(isinstance(one, tuple) for one in given.values())
        what = f"jump_probability over {free}, jump_value of {POINTS} points, {many:.2f} s"
        out.append((what, spent / many, most, f"off by {abs(found.probability - share):.0e}"))
    return out


def searches(model: Any) -> list[Row]:
    """Searches over boxes, and what follows states by tubes."""
    p = model.Parameters(theta0=ANGLE)
    with watched(boxes, "search") as looked:
        folds, found = seconds(ss.folds, p, "mu0", method="search")
        cusps, _ = seconds(ss.cusps, p, method="search")
    state = np.array([found[name][0] for name in (*model.coordinates, "mu0")])
    near, root = seconds(from_near, model, p, state)
    each = dict[
        int, float
    ]()  # the least of the calls of a search, of which the first records tapes
    for call in looked:
        boxes_of, spent = call.result.looks, 1e6 * (call.end - call.begin)
        each[boxes_of] = min(each.get(boxes_of, np.inf), spent / boxes_of)
    dearest = max(spent for boxes_of, spent in each.items() if boxes_of > FEWEST)
    with watched(Tubes, "followed") as followed, watched(Tubes, "segment") as rounds:
        lowest, least = seconds(ss.critical_friction, p, method="search")
    lost = sum(
        call.begin <= one.begin <= call.end
        for call in followed
        if not (call.result.v == call.arguments[2]).any()
        for one in rounds
    )
    alone, jump = seconds(ss.jump_value, p, method="search")
    one, _ = seconds(ss.equilibria, p.replace(mu0=0.5), method="search")
    apart = np.abs(found.mu0 - jump).min()
    return [
        (
            "folds along mu0, fsolve from near",
            folds / near,
            60,
            f"off by {abs(root[-1] - state[-1]):.0e}",
        ),
        ("folds and cusps, µs a box", dearest, 2, ""),
        ("critical_friction, folds + cusps", lowest / (folds + cusps), 6, least.kind),
        (
            "its rounds of tubes that do not arrive",
            lost / len(rounds),
            0.1,
            f"{len(rounds)} rounds",
        ),
        ("jump_value, equilibria of one point", alone / one, 4, f"off a fold by {apart:.0e}"),
    ]


def from_near(model: Any, p: Any, fold: Any) -> Any:
    """The fold along mu0 by SciPy, of F = 0 and det K = 0, from 1 % beside it."""
    balance = Balance(model)
    column = np.array([np.nan_to_num(p[name]) for name in balance.parameters])
    mu0 = balance.parameters.index("mu0")

    def residuals(z: Any) -> Any:
        column[mu0] = z[-1]
        at = balance.at(list(z[:-1]), balance.floats(column), xp=np)
        K = np.array(at.stiffness())
        return *at.rows("forces"), np.linalg.det(K)

    return scipy.optimize.fsolve(residuals, 1.01 * fold, xtol=1e-12)


def curves(model: Any) -> str:
    """Times of the bifurcation set and of curves of onsets, and one over the other; over friction
    and another parameter where the model has no inclination.
    """
    p, spent = model.Parameters(), []
    others = [name for name in model.parameters if name != model.coefficient]
    plane = [] if model.inclination or not model.coefficient else [(others[0], model.coefficient)]
    for question in (ss.bifurcation_set, ss.onset_curves):
        try:
            spent.append(seconds(question, p, *plane)[0])
        except ss.errors.SpragsymError:
            return "not asked | |"
    return f"{spent[0]:.2f} | {spent[1]:.2f} | {spent[1] / spent[0]:.2g}"


def report(name: str) -> float:
    """Processor time of the report of a model's example, by the command."""
    command = [sys.executable, "-m", "spragsym", "report"]
    example = [*command, "--example", "--model", name]
    data = subprocess.run(example, capture_output=True, check=True).stdout
    with tempfile.NamedTemporaryFile(suffix=".toml") as file:
        Path(file.name).write_bytes(data)
        begin = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([*command, file.name], capture_output=True, check=True)
        end = resource.getrusage(resource.RUSAGE_CHILDREN)
    return end.ru_utime + end.ru_stime - begin.ru_utime - begin.ru_stime


if __name__ == "__main__":
    main(*sys.argv[1:])
