"""Pages whose gap is an expression against mechanics written by hand: states, their gaps and kinds, folds, onsets.

``python -m validation.gaps [SETS] [JOURNAL] [PAGE ...]``: SETS random sets of each page of tests/oracles/gap_pages.py, from
what is not in JOURNAL yet, which holds one line for each. Independent of the search: SciPy's hybrid method from random starts,
slopes by complex steps, roots λ of the pencil as eigenvalues, folds and onsets as roots of determinants of these.
Exits with 1 if something that is listed is wrong, if something is missed, or if what is called complete is not.
"""

from __future__ import annotations

import itertools
import json
import sys
import tempfile
import time
from collections import Counter
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import fsolve

import spragsym as ss
from tests.oracles.gap_pages import HANDS, Hand, Values, push

#: Starts for the states, for the folds and for the onsets of each set.
STARTS = 60
#: Residual of a state that is listed, of one that counts as missed, and its distance from all that are listed.
RIGHT, FOUND, NEAR = 1e-9, 1e-12, 1e-5
#: How far from the border something has to be to count as missed, and how much an onset has to be damped.
CLEAR, DAMPED = 1e-9, 1e-5
#: Speeds and steepnesses of friction laws for which these damp as much as eigenvalues show.
SPEEDS = {"V": (0.05, 0.5), "d": (1.0, 12.0)}


def load(folder: Path, name: str) -> Any:
    """The model of a page, derived."""
    from spragsym.derive import folder as derived

    (folder / f"{name}.py").write_text(HANDS[name].page, encoding="utf-8")
    derived.write_page(folder / f"{name}.py", folder / name)
    return ss.load(folder / name)


def draw(model: Any, hand: Hand, rng: np.random.Generator) -> dict[str, float]:
    """One set: within a decade of the base values, others over their ranges; a tenth of all without friction."""
    values = {name: float(base * 10 ** rng.uniform(-1, 1)) for name, base in model.base.items()}
    values |= {name: float(rng.uniform(*ends)) for name, ends in {**SPEEDS, **hand.ranges}.items() if name in values}
    return values | ({"mu0": 0.0} if rng.random() < 0.1 else {})


# ------------------------------------------------------------------------------------------------- written by hand


def stiffness(hand: Hand, q: Any, p: Values, contact: int) -> np.ndarray:
    """Slopes of the forces by complex steps."""
    n, h = len(q), 1e-30
    columns = [np.imag(hand.forces(np.asarray(q, complex) + 1j * h * np.eye(n)[i], p, contact)) / h for i in range(n)]
    return np.array(columns, dtype=float).T


def pencil(hand: Hand, q: Any, p: Values, contact: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """M, C and K."""
    N = float(np.real(push(hand, q, p, contact)))
    return np.array(hand.mass(q, p)), np.array(hand.damping(q, p, N)), stiffness(hand, q, p, contact)


def roots(M: np.ndarray, C: np.ndarray, K: np.ndarray) -> np.ndarray:
    """λ of det(λ² M + λ C + K)."""
    n = len(M)
    return np.linalg.eigvals(np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]]))


def test_function(hand: Hand, kind: str, q: Any, p: Values) -> float:
    """What vanishes at a fold or at an onset: det K, or the product of all sums of two λ (scaled)."""
    M, C, K = pencil(hand, q, p, 1)
    if not (np.isfinite(C).all() and np.isfinite(K).all()):
        return 1.0  # beyond where the laws are defined
    if kind == "folds":
        return float(np.linalg.det(K))
    values = roots(M, C, K)
    sums = [values[i] + values[j] for i in range(len(values)) for j in range(i)]
    return float(np.real(np.prod(sums)))


def multistart(function: Any, starts: np.ndarray) -> list[np.ndarray]:
    """Different roots."""
    found: list[np.ndarray] = []
    for start in starts:
        with np.errstate(all="ignore"):
            z, _, ended, _ = fsolve(function, start, full_output=True, xtol=1e-13)
            good = ended == 1 and np.abs(function(z)).max() < FOUND
        if good and all(np.abs(z - other).max() > NEAR * (1 + np.abs(z).max()) for other in found):
            found.append(z)
    return found


# -------------------------------------------------------------------------------------------------------- compared


def word(values: np.ndarray) -> str:
    """What grows by roots λ; empty where floats do not tell."""
    first, size = values[values.real.argmax()], np.abs(values).max()
    if abs(first.real) <= CLEAR * size:
        return ""
    return "stable" if first.real < 0 else "flutter" if abs(first.imag) > 1e-6 * size else "divergent"


def code(M: np.ndarray, K: np.ndarray) -> str:
    """The word of (27), of the roots κ = −λ² of det(K − κ M); empty where floats do not tell."""
    squares = np.linalg.eigvals(np.linalg.solve(M, K)).astype(complex)
    size = np.abs(squares).max()
    apart = min((abs(a - b) for i, a in enumerate(squares) for b in squares[:i]), default=size)
    if np.abs(squares).min() <= CLEAR * size or apart <= 1e-6 * size:
        return ""
    if (np.abs(squares.imag) > 1e-6 * size).any():
        return "" if (squares.real[np.abs(squares.imag) <= 1e-6 * size] < 0).any() else "flutter"
    return "divergent" if (squares.real < 0).any() else "stable"


def states(model: Any, hand: Hand, p: Values, contact: int, rng: np.random.Generator, starts: int) -> Counter[str]:
    """States of one set: residual, gap, growth; and whether one is missed."""
    eq = ss.equilibria(model.Parameters(**p), contact=bool(contact))
    listed = np.array([eq.coordinates[name][: int(eq.count)] for name in model.coordinates]).T
    counts = Counter(
        sets=1,
        states=len(listed),
        kinds=0,
        **{"not complete": int(not eq.complete), "undecided": int(not eq.decided.all())},
        missed=0,
        wrong=0,
    )
    counts["without a reason"] = int(not eq.complete and not eq.remarks)
    scale = 1 + max(map(abs, p.values()))
    for slot, q in enumerate(listed):
        off = np.abs(np.real(hand.forces(q, p, contact))).max() > RIGHT * scale
        open_ = (2 * contact - 1) * float(hand.gap(q, p)) > 0
        M, C, K = pencil(hand, q, p, contact)
        every = roots(M, C, K)
        growth, kind, undamped = float(every.real.max()), word(every), code(M, K)
        other = abs(growth - float(eq.growth[slot])) > 1e-6 * scale
        other |= bool(kind) and (str(eq.kind[slot]) != kind or bool(eq.stable[slot]) != (kind == "stable"))
        other |= bool(undamped) and ss.Stability(int(eq.stability[slot])).name.lower() != undamped
        counts["kinds"] += bool(kind)
        counts["wrong"] += _told(
            off or open_ or other,
            f"wrong: {q.tolist()}, gap {hand.gap(q, p)}, growth {growth}, {kind or '?'} ({eq.kind[slot]}), undamped {undamped or '?'} "
            f"({eq.stability[slot]})", p, contact,
        )  # fmt: skip
    begin = rng.uniform(-hand.reach, hand.reach, (starts, len(model.coordinates)))
    for q in multistart(lambda q: np.real(hand.forces(q, p, contact)), begin) if eq.decided.all() else ():
        regular = abs(np.linalg.det(stiffness(hand, q, p, contact))) > 1e-5
        regular &= eq.complete or bool(((eq.region[:, 0] <= q) & (q <= eq.region[:, 1])).all())
        inside = (1 - 2 * contact) * float(hand.gap(q, p)) > CLEAR
        far = not len(listed) or np.abs(listed - q).max(axis=1).min() > NEAR * (1 + np.abs(q).max())
        counts["missed"] += _told(regular and inside and far, f"missed: {q.tolist()}", p, contact)
    return counts


def points(model: Any, hand: Hand, p: Values, kind: str, rng: np.random.Generator, starts: int) -> Counter[str]:
    """Folds or onsets of one set along the page's parameter."""
    vary, span = hand.vary
    search = ss.folds if kind == "folds" else ss.flutter_onsets
    found = search(model.Parameters(**p), vary, between={vary: span})
    listed = np.array([getattr(found, name) for name in (*model.coordinates, vary)]).reshape(len(model.coordinates) + 1, -1).T
    counts = Counter(
        sets=1,
        points=len(listed),
        **{"not complete": int(not found.complete), "undecided": int(not found.decided)},
        missed=0,
        wrong=0,
    )
    counts["without a reason"] = int(not found.complete and not found.remarks)

    def rows(z: np.ndarray) -> np.ndarray:
        at = {**p, vary: z[-1]}
        return np.array([*np.real(hand.forces(z[:-1], at, 1)), test_function(hand, kind, z[:-1], at)])

    def crosses(z: np.ndarray) -> bool:
        """Whether a pair of complex λ lies on the imaginary axis, and not since nothing damps."""
        if kind == "folds":
            return True
        M, C, K = pencil(hand, z[:-1], {**p, vary: z[-1]}, 1)
        values = roots(M, C, K)
        return bool(
            np.abs(C).max() > DAMPED and (np.abs(values.real) < 1e-7 * np.abs(values).max() * (np.abs(values.imag) > 1e-3)).any()
        )

    scale = 1 + max(map(abs, p.values()))
    for z in listed:
        at = {**p, vary: z[-1]}
        off = np.abs(rows(z)[:-1]).max() > RIGHT * scale or float(hand.gap(z[:-1], at)) > 0
        off = off or not span[0] <= z[-1] <= span[1] or (kind == "folds" and _singular(hand, z, at) > 1e-6)
        damped = np.abs(pencil(hand, z[:-1], at, 1)[1]).max() > DAMPED
        counts["wrong"] += _told(off or (damped and not crosses(z)), f"wrong of {kind}: {z.tolist()}", p, 1)
    begin = rng.uniform(-hand.reach, hand.reach, (starts, len(model.coordinates) + 1))
    begin[:, -1] = rng.uniform(*span, starts)
    for z in multistart(rows, begin) if found.decided else ():
        at = {**p, vary: z[-1]}
        if not (found.whole or ((found.region[:, 0] <= z) & (z <= found.region[:, 1])).all()):
            continue
        inside = span[0] + CLEAR < z[-1] < span[1] - CLEAR and float(hand.gap(z[:-1], at)) < -CLEAR
        near = len(listed) and np.abs(listed - z).max(axis=1).min() <= NEAR * (1 + np.abs(z).max())
        real = inside and not near and crosses(z) and _is_regular(rows, z)
        counts["missed"] += _told(real, f"missed of {kind}: {z.tolist()}", p, 1)
    return counts


def _singular(hand: Hand, z: np.ndarray, p: Values) -> float:
    """The least singular value of K over the largest one."""
    values = np.linalg.svd(stiffness(hand, z[:-1], p, 1), compute_uv=False)
    return float(values[-1] / max(values[0], 1e-300)) if len(values) > 1 else float(values[0])


def _is_regular(rows: Any, z: np.ndarray) -> bool:
    """Whether the slopes are such that a small residual means a root nearby."""
    steps = 1e-6 * np.eye(z.size)
    slopes = np.array([(rows(z + h) - rows(z - h)) / 2e-6 for h in steps])
    sizes = np.linalg.norm(slopes, axis=0)
    return bool((sizes > 0).all() and abs(np.linalg.det(slopes / sizes)) > 1e-4)


def _told(is_so: Any, text: str, p: Values, contact: int) -> int:
    if is_so:
        print(f"{text} at {dict(p)}, contact {contact}", flush=True)
    return int(bool(is_so))


def compared(model: Any, hand: Hand, seed: int, starts: int = STARTS) -> dict[str, dict[str, Any]]:
    """All that is compared of one set."""
    rng = np.random.default_rng(seed)
    p = draw(model, hand, rng)
    asked = {f"states, contact {contact}": partial(states, model, hand, p, contact, rng, starts) for contact in (1, 0)}
    asked |= {kind: partial(points, model, hand, p, kind, rng, starts) for kind in ("folds", "onsets")}
    out = {}
    for what, ask in asked.items():
        begin = time.process_time()
        out[what] = dict(ask()) | {"seconds": round(time.process_time() - begin, 2)}
    return out


def main() -> int:
    """All pages that are asked for, from where the journal ends."""
    sets, journal = int((sys.argv[1:] or ["20"])[0]), Path(sys.argv[2]) if len(sys.argv) > 2 else None
    names = sys.argv[3:] or list(HANDS)
    totals: dict[tuple[str, str], Counter[str]] = {}
    lines = journal.read_text(encoding="utf-8").splitlines() if journal and journal.exists() else []
    done = {(entry["page"], entry["seed"]): entry["found"] for entry in map(json.loads, lines)}
    models: dict[str, Any] = {}
    with tempfile.TemporaryDirectory() as out:
        for seed, name in itertools.product(range(sets), names):
            if (name, seed) not in done:
                if name not in models:
                    models[name] = load(Path(out), name)
                done[name, seed] = compared(models[name], HANDS[name], seed)
                if journal:
                    with journal.open("a", encoding="utf-8") as file:
                        file.write(json.dumps({"page": name, "seed": seed, "found": done[name, seed]}) + "\n")
            for what, counts in done[name, seed].items():
                totals.setdefault((name, what), Counter()).update(counts)
    for (name, what), counts in totals.items():
        print(f"{name}, {what}: {', '.join(f'{n:g} {word}' for word, n in counts.items())}")
    return int(any(counts["wrong"] + counts["missed"] for counts in totals.values()))


if __name__ == "__main__":
    sys.exit(main())
