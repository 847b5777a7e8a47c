"""Models from pages against closed forms and other formulations, at many points.

``python -m validation.models [POINTS] [SEED] [FILE]``: POINTS of each family for the article's model (10⁵ in all with
10 000), POINTS // 500 random points of each other page in 50 digits, POINTS // 30 of a page with a torsion spring, and
POINTS // 1000 searches for folds along each parameter and for cusps. With FILE the families alone, in parts that are kept in that
file: what was interrupted goes on where it was.
"""

from __future__ import annotations

import json
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np

import spragsym as ss
from tests.oracles import model_references as references
from tests.oracles.families import FAMILIES

#: Points looked at together.
PART = 1000
NAMES = ("theta0", "mu0", "kappa", "alpha", "sigma", "beta")


def article(points: int, seed: int, store: Path | None = None) -> None:
    """Counts and states of the article's model through the general way, family by family, in parts; done ones are kept in a file."""
    done = {} if store is None or not store.exists() else dict(map(_entry, store.read_text(encoding="utf-8").splitlines()))
    print(f"{'family':24}{'points':>8}{'undecided':>11}{'other count':>13}{'largest error':>15}{'bound':>10}{'ms/point':>10}")
    for name in FAMILIES:
        rows = []
        for number in range(-(-points // PART)):
            key = f"{name} {seed} {number} {min(PART, points - number * PART)}"
            if key not in done:
                done[key] = _part(name, [seed, number], min(PART, points - number * PART))
                if store is not None:
                    with store.open("a", encoding="utf-8") as file:
                        file.write(json.dumps([key, done[key]]) + "\n")
            rows.append(done[key])
        size, undecided, other, error, bound, spent = (list(column) for column in zip(*rows, strict=True))
        print(
            f"{name:24}{sum(size):8.0f}{sum(undecided):11.0f}{sum(other):13.0f}{max(error):15.1e}{max(bound):10.1e}"
            f"{1e3 * sum(spent) / sum(size):10.3f}",
            flush=True,
        )


def _entry(line: str) -> tuple[str, list[float]]:
    key, row = json.loads(line)
    return key, row


def _part(name: str, seed: list[int], points: int) -> list[float]:
    """Points, undecided ones, other counts, largest error and bound, seconds."""
    model = ss.load("kang_nam").search
    p = FAMILIES[name](np.random.default_rng(seed), points)
    begin = time.process_time()
    eq = ss.equilibria(model.Parameters(**{key: getattr(p, key) for key in NAMES}))
    spent = time.process_time() - begin
    known = ss.equilibria(p)
    settled = eq.decided & known.decided & ~known.fold
    other = settled & (eq.count != known.count)
    same = settled & ~other
    slots = min(eq.x.shape[-1], known.x.shape[-1])
    order = np.argsort(known.x, axis=-1)
    errors = [
        np.abs(getattr(eq, key)[same][:, :slots] - want) / np.maximum(1, np.abs(want))
        for key in ("x", "y")
        for want in [np.take_along_axis(getattr(known, key), order, axis=-1)[same][:, :slots]]
    ]
    undecided = float((~eq.decided).sum())
    return [float(eq.count.size), undecided, float(other.sum()), float(np.nanmax(errors)), float(np.nanmax(eq.error)), spent]


def folds_and_cusps(points: int, seed: int) -> None:
    """Folds along each parameter, and cusps, of the article's model at random parameters, μ₀ and α at 0 among them."""
    rng = np.random.default_rng(seed)
    model = ss.load("kang_nam").search
    print(
        f"{'points of change':24}{'searches':>9}{'points':>8}{'undecided':>11}{'other count':>13}{'largest error':>15}{'s each':>10}"
    )
    for vary in (*NAMES, "cusps"):
        found_all, wrong, undecided, worst, spent = 0, 0, 0, 0.0, 0.0
        for _ in range(points):
            p = ss.Parameters(
                rng.uniform(0.1, 3.0), rng.uniform(0.0, 1.5) * (rng.random() < 0.9), 10.0 ** rng.uniform(-2.5, -0.5),
                10.0 ** rng.uniform(-2.5, -0.5) * (rng.random() < 0.9), 10.0 ** rng.uniform(-1.5, 0.5), rng.choice([0.0, 0.3]),
            )  # fmt: skip
            begin = time.process_time()
            found = _changes(model, model.Parameters(**{key: getattr(p, key) for key in NAMES}), vary)
            spent += time.process_time() - begin
            known = _changes(ss, p, vary)
            undecided += not found.complete
            first = "theta0" if vary == "cusps" else vary
            span = dict(zip(found.vary, found.region[2:], strict=True))
            inside = np.logical_and.reduce(
                [(getattr(known, k) > low) & (getattr(known, k) < high) for k, (low, high) in span.items()]
            )
            pairs = [np.sort(values) for values in (getattr(found, first), getattr(known, first)[inside])]
            if pairs[0].size != pairs[1].size:
                wrong += found.complete
            elif pairs[0].size:
                found_all += pairs[0].size
                worst = max(worst, float((np.abs(pairs[0] - pairs[1]) / np.maximum(1, np.abs(pairs[1]))).max()))
        name = "cusps" if vary == "cusps" else f"folds along {vary}"
        print(f"{name:24}{points:9}{found_all:8}{undecided:11}{wrong:13}{worst:15.1e}{spent / points:10.2f}", flush=True)


def _changes(of: Any, p: Any, vary: str) -> Any:
    """Folds along a parameter, or cusps, of a loaded model or of the article's."""
    if vary != "cusps":
        return ss.folds(p, vary)
    return ss.cusps(p) if of is ss else ss.cusps(p, ("theta0", "mu0"), between={"mu0": (1e-6, 2.0)})


def loads(p: Any) -> tuple[Any, Any]:
    """Weight on an inclined belt."""
    weight, psi = mp.mpf(float(p.gamma_g)), mp.mpf(float(p.psi))
    return weight * mp.sin(psi), weight * mp.cos(psi)


#: For each page its states in 50 digits.
PAGES: dict[str, Callable[[Any], list[tuple[Any, ...]]]] = {
    "cubic_contact": lambda p: references.one_spring(p, references.cubic(float(p.gamma))),
    "hertz_contact": lambda p: references.one_spring(p, references.hertz),
    "inclined_belt": lambda p: references.one_spring(p, references.linear, loads(p)),
    "trolley": lambda p: references.one_spring(p, references.linear, anchor=mp.mpf(float(p.alpha_a))),
    "two_springs": references.two_springs,
}


def compare(name: str, p: Any) -> tuple[bool, float]:
    """Whether the number of states is the same, and the largest error over its bound."""
    eq = ss.equilibria(p, method="search")
    with mp.workdps(50):
        want = PAGES[name](p)
        if not eq.complete or int(eq.count) != len(want):
            return False, np.inf
        got = [eq.coordinates[key] for key in eq.coordinates]
        ratios = [
            float(abs(mp.mpf(float(column[slot])) - value) / max(1, abs(value)) / mp.mpf(float(eq.error[slot])))
            for slot, state in enumerate(want)
            for column, value in zip(got, state, strict=True)
        ]
    return True, max(ratios, default=0.0)


def pages(points: int, seed: int) -> None:
    """All other pages with a scalar equation or a polynomial."""
    for name in PAGES:
        rng = np.random.default_rng(seed)
        model = ss.load(name).search
        results = [
            compare(name, model.Parameters(theta0=rng.uniform(0.1, 3.0), **({"mu0": rng.uniform(0, 1.5)}))) for _ in range(points)
        ]
        wrong = sum(not same for same, _ in results)
        worst = max((ratio for same, ratio in results if same), default=np.nan)
        print(
            f"{name:16}{points:6} points, {wrong} other counts or undecided, largest error over its bound {worst:.2g}", flush=True
        )


def torsion(points: int, seed: int) -> None:
    """The page of tests with a torsion spring at the anchor, in contact and in lift-off, four decades of every parameter."""
    from spragsym.derive import folder

    rng = np.random.default_rng(seed)
    with tempfile.TemporaryDirectory() as out:
        folder.write_page(Path(__file__).resolve().parent.parent / "tests/soft_brake.py", Path(out) / "soft_brake")
        model = ss.load(str(Path(out) / "soft_brake"))
        sets = {
            name: model.base[name] * 10.0 ** rng.uniform(-2, 2, points) for name in ("kappa", "alpha", "sigma", "tau", "gamma")
        }
        sets |= {"theta0": rng.uniform(0.05, 3.1, points), "mu0": rng.uniform(0, 1, points) * (rng.random(points) < 0.9)}
        for contact in (True, False):
            begin = time.process_time()
            eq = ss.equilibria(model.Parameters(**sets), contact=contact)
            spent = time.process_time() - begin
            wrong, worst = 0, 0.0
            for i in range(points):
                with mp.workdps(50):
                    want = references.turned_spring(model.Parameters(**{key: values[i] for key, values in sets.items()}), contact)
                    wrong += int(eq.count[i]) != len(want)
                    got = list(zip(eq.x[i], eq.y[i], strict=True))[: len(want)] if eq.count[i] == len(want) else []
                    for slot, state in enumerate(got):
                        for value, exact in zip(state, want[slot], strict=True):
                            away = abs(mp.mpf(float(value)) - exact) / max(1, abs(exact))
                            worst = max(worst, float(away / mp.mpf(float(eq.error[i, slot]))))
            print(
                f"torsion, {'contact' if contact else 'lift-off'}{points:6} points, {wrong} other counts, {int((~eq.decided).sum())} undecided, "
                f"{1e3 * spent / points:.2f} ms each, largest error {np.nanmax(eq.error, initial=0.0):.1e}, over its bound {worst:.2g}",
                flush=True,
            )


def main() -> None:
    """All of them."""
    points, seed = (int(sys.argv[i]) if len(sys.argv) > i else default for i, default in ((1, 10_000), (2, 1)))
    store = Path(sys.argv[3]) if len(sys.argv) > 3 else None
    if store is None:
        pages(max(1, points // 500), seed)
        torsion(max(1, points // 30), seed)
        folds_and_cusps(max(1, points // 1000), seed)
    article(points, seed, store)


if __name__ == "__main__":
    main()
