"""Reports of random brakes: all pairs of their statements for contradictions, and every change
against corners and samples.

It guards the claim that no two statements of a report contradict each other, beyond the brakes that
tests ask for.
"""

import itertools
import math
import re
from collections.abc import Iterator
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.report.redesigns import changes
from spragsym.report.tolerances import ending, values_at, varied

CASES = 300
#: A proposition → what follows from it; both with their truth values.
IMPLIES: dict[tuple[str, bool], list[tuple[str, bool]]] = {
    ("it has jumped", True): [("it jumps at the largest friction", True)],
    ("it jumps at the largest friction", True): [
        ("it jumps at full slip", True),
        ("a brake within the tolerances jumps", True),
    ],
    ("it jumps at full slip", True): [("there is a jump", True)],
    ("there is a jump", False): [("it jumps at full slip", False)],
    ("it jumps at full slip", False): [("it jumps at the largest friction", False)],
    ("it jumps at the largest friction", False): [("it has jumped", False)],
    ("a brake within the tolerances jumps", False): [("it jumps at the largest friction", False)],
    ("there is an oscillation", False): [("there is an amplitude", False)],
    ("there is an amplitude", True): [("there is an oscillation", True)],
}
JUMPED, LARGEST, FULL, EXISTS, SOME = (
    "it has jumped",
    "it jumps at the largest friction",
    "it jumps at full slip",
    "there is a jump",
    "a brake within the tolerances jumps",
)
SETTLES, UP_TO_DAMPING = "its state settles", "its state is up to the damping"
LIVES, AMPLITUDE, LIFTS = (
    "there is an oscillation",
    "there is an amplitude",
    "it lifts off in the oscillation",
)
#: A sentence anywhere → propositions.
SENTENCES: list[tuple[str, list[tuple[str, bool]]]] = [
    (r"^It sprags: ", [(LARGEST, True)]),
    (r"^It sprags above V = ", [(LARGEST, False), (FULL, True)]),
    (r"does not sprag: ", [(FULL, False)]),
    (r"has no jump at", [(EXISTS, False)]),
    (r"reference state jumps at a friction of ", [(EXISTS, True)]),
    (r"^Proved.*sprags\.$|^That it does not sprag is proved", [(SOME, False)]),
    (r"% of all brakes sprag", [(SOME, True)]),
    (r"a proof for all of them was not found", [("it is proved", False)]),
]
#: Heading, name of a row, its value → propositions.
ROWS: list[tuple[str, str, str, list[tuple[str, bool]]]] = [
    ("Jump", "jump at this angle", "never", [(EXISTS, False)]),
    ("Jump", "jump at this angle", "at friction", [(EXISTS, True)]),
    ("Jump", "margin to the largest friction", r"\+", [(LARGEST, False)]),
    ("Jump", "margin to the largest friction", r"-", [(LARGEST, True)]),
    ("Jump", "the same at full slip", r"\+", [(FULL, False), ("friction falls short", True)]),
    ("Jump", "the same at full slip", r"-", [(FULL, True)]),
    ("Jump", "speed at which it begins to jump", "at no speed", [(FULL, False)]),
    ("Jump", "speed at which it begins to jump", r"[\d.]", [(FULL, True)]),
    ("Jump", "least friction at which it ends", "there is none", [(EXISTS, False)]),
    ("Jump", "tolerances to the nearest jump", "0, it has jumped already", [(JUMPED, True)]),
    ("Jump", "tolerances to the nearest jump", "(?!0, it)", [(JUMPED, False)]),
    ("State", "the state it jumped to", "", [(JUMPED, True)]),
    ("State", "the reference state", "", [(JUMPED, False)]),
    (
        "State",
        "the (state it jumped to|reference state)",
        "stable",
        [(SETTLES, True), (UP_TO_DAMPING, False)],
    ),
    (
        "State",
        "the (state it jumped to|reference state)",
        "neutral",
        [(UP_TO_DAMPING, True)],
    ),
    (
        "State",
        "the (state it jumped to|reference state)",
        "unstable",
        [(SETTLES, False), (UP_TO_DAMPING, False)],
    ),
    ("Warnings", "", "the followed state lies", [(JUMPED, False)]),
    ("Warnings", "", "the belt is so slow", [("friction falls short", True)]),
    ("Warnings", "", ".*no oscillation is looked for", [(LIVES, False)]),
    ("Warnings", "", ".*the damping of the real brake decides", [(UP_TO_DAMPING, True)]),
    ("The jump as a motion", "then", "", [(FULL, True)]),
    ("Tolerances", "no jump within", "proved", [(SOME, False), ("it is proved", True)]),
    ("Tolerances", "no jump within", "refuted", [(SOME, True), ("it is proved", False)]),
    ("Tolerances", "no jump within", "undecided", [("it is proved", False)]),
    ("Tolerances", "a brake within them that jumps", "", [(SOME, True)]),
    ("Tolerances", "probability of a jump", "0, as is proved", [(SOME, False)]),
    ("Tolerances", "probability of a jump", r"[\d.e-]+ %", [(SOME, True)]),
    ("Oscillation", "from (rest|far out)", "(a cycle|a motion)", [(LIVES, True)]),
    ("Oscillation", "from (rest|far out)", "none", [(LIVES, False)]),
    ("Oscillation", "amplitude", "", [(AMPLITUDE, True)]),
    ("Oscillation", "force of", "", [(AMPLITUDE, True)]),
    ("Oscillation", "frequency", "", [(AMPLITUDE, True)]),
    ("Oscillation", "lifts off", "yes", [(LIFTS, True)]),
    ("Oscillation", "lifts off", "no", [(LIFTS, False)]),
    ("Oscillation", "force of the contact", r"0 N to", [(LIFTS, True)]),
    ("Oscillation", "force of the contact", r"(?!0 N)", [(LIFTS, False)]),
    ("Oscillation", "coexists with", "yes", [(SETTLES, True)]),
    ("Oscillation", "coexists with", "no", [(SETTLES, False), (UP_TO_DAMPING, False)]),
    ("Oscillation", "coexists with", "up to", [(UP_TO_DAMPING, True)]),
]
NUMBER = r"([-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?)"


def lines(text: str) -> Iterator[tuple[str, str, str]]:
    """Heading, name and value of every row of a report, and every other line as a value alone."""
    heading, name, wide = "", "", 34
    for line in text.splitlines():
        if line.startswith(" " * wide):
            yield heading, name, line.strip()
        elif line.startswith("  "):
            name = line[2:wide].strip()
            if len(line) > wide and line[wide - 1] == " ":
                yield heading, name, line[wide:]
        elif line:
            heading, wide = line, 10 if line in ("Warnings", "What to do next") else 34
            yield "", "", line


def statements(text: str) -> list[tuple[str, dict[str, bool]]]:
    """The statements of a report, each with all that follows from it."""
    found = []
    for heading, name, value in lines(text):
        for pattern, said in SENTENCES:
            if not name and re.search(pattern, value):
                found.append((value, closed(said)))
        for title, row, content, said in ROWS:
            if heading == title and re.match(row, name) and re.match(content, value):
                found.append((f"{name}: {value}", closed(said)))
    return found


def closed(said: list[tuple[str, bool]]) -> dict[str, bool]:
    """A statement's propositions with all that follow."""
    left, result = list(said), {}
    while left:
        name, value = left.pop()
        result[name] = value
        left += [one for one in IMPLIES.get((name, value), []) if one[0] not in result]
    return result


def contradictions(text: str) -> list[str]:
    """Pairs of statements that can't both be true, and numbers that do not agree."""
    found = []
    for (one, said), (other, also) in itertools.combinations(statements(text), 2):
        for name in said.keys() & also.keys():
            if said[name] != also[name]:
                found.append(f"{name}: {one!r} / {other!r}")
    jumps = [
        float(value)
        for value in re.findall(
            rf"jumps at a friction of {NUMBER}|jump at this angle\s+at friction {NUMBER}", text
        )
        for value in value
        if value
    ]
    if jumps and max(jumps) > 1.002 * min(jumps):
        found.append(f"frictions of the jump {jumps}")
    if above := re.search(
        rf"friction of {NUMBER}, {NUMBER} % above the largest that you have, {NUMBER}", text
    ):
        jump, percent, largest = map(float, above.groups())
        if abs(100 * (jump / largest - 1) - percent) > 0.5 + 0.006 * (100 + percent):
            found.append(f"margins {above[0]}")
    if (
        (low := re.search(rf"least friction at which it ends\s+friction {NUMBER}", text))
        and jumps
        and max(jumps) < float(low[1]) * 0.998
    ):
        found.append(f"a jump at {jumps} below the critical friction {low[0]}")
    if peak := re.search(
        rf"from x = {NUMBER} mm to {NUMBER} mm\n.*\n  range of x\s+{NUMBER} mm to {NUMBER} mm", text
    ):
        before, after, least, most = map(float, peak.groups())
        if not (
            least <= most
            and min(after, before) >= least - 0.1 * abs(after - before)
            and max(after, before) <= most * 1.5 + 1
        ):
            found.append(f"peaks {peak[0]}")
    if aim := re.search(rf"each of them keeps +the jump at {NUMBER}", text):
        for value in re.findall(rf"then it jumps at {NUMBER}", text):
            if float(value) < float(aim[1]) * 0.9995:
                found.append(f"a change that jumps at {value} for {aim[0]}")
    return found


# ------------------------------------------------------------------------------------------------
# brakes


def brake(seed: int, i: int) -> ss.Study:
    """A random brake: stiff or soft, steep or flat, fast, slow or without a belt, with tolerances
    of any kind or none.
    """
    rng = np.random.default_rng([seed, i])
    k_c, L_0 = 10 ** rng.uniform(5, 7), 10 ** rng.uniform(-2, -0.7)
    values: dict[str, Any] = {
        "m": 10 ** rng.uniform(-1.5, 1),
        "k_c": k_c,
        "L_0": L_0,
        "k": k_c * 10 ** rng.uniform(-2, -0.4),
        "k_x": k_c * 10 ** rng.uniform(-3, -1),
        "k_y": rng.choice([0.0, k_c * 10 ** rng.uniform(-3, -1)]),
        "F_L": k_c * L_0 * 10 ** rng.uniform(-3, -1.5),
        "theta0": math.radians(rng.uniform(15, 125)),
        "mu0": rng.uniform(0.05, 0.9),
    }
    if rng.random() < 0.85:
        time = math.sqrt(values["m"] / k_c)
        values |= {
            "V": L_0 / time * 10 ** rng.uniform(-2, 0.5),
            "d": time / L_0 * 10 ** rng.uniform(0, 1.5),
        }
    if rng.random() < 0.5:  # near the jump, where sentences are hard to get right
        jump = float(ss.jump_value(ss.PhysicalParameters(**values).dimensionless()))
        if math.isfinite(jump) and jump < 2:
            values["mu0"] = jump * rng.uniform(0.85, 1.15)
    names = rng.choice(
        ["k", "k_x", "k_c", "F_L", "L_0", "mu0", "theta0"], rng.integers(0, 4), replace=False
    )
    off = {}
    for name in names.tolist():
        size = rng.choice([0.5, 2.0, 6.0])
        off[name] = (
            "1 deg" if name == "theta0" else f"{'sd ' if rng.random() < 0.3 else ''}{size:g} %"
        )
    return ss.Study(ss.PhysicalParameters(**values), tolerance=off)


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One report, which is asked for an oscillation now and then; or, of every sixth brake, its
    changes.
    """
    if number % 6 == 5:
        return changed(number, rng)
    text = (
        brake(1, number)
        .report(n=256, oscillation=number % 4 == 0, redesign=number % 25 == 0)
        .text()
    )
    found = statements(text)
    wrong = [f"brake {number}: {one}" for one in contradictions(text)]
    return {"kind": "statements", "wrong": wrong, "pairs": len(found) * (len(found) - 1) // 2}


def changed(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """The changes of one brake: how many within their tolerances jump, of all corners and
    samples.
    """
    study = brake(1, number)
    names = ["k", "k_x", "k_c", "F_L", "L_0"]
    off = {
        name: f"{rng.choice([2, 5]):g} %"
        for name in rng.choice(names, rng.integers(1, 6), replace=False).tolist()
    }
    study = ss.Study(study.values, tolerance=off | {"theta0": "0.5 deg"})
    jump = float(ss.jump_value(study.dimensionless))
    if not jump < 2:
        return {"kind": "no jump", "wrong": []}
    found, wrong = changes(study.at_full_slip(), jump * rng.uniform(1.05, 1.3)), []
    for one in found:
        new = study.at_full_slip().changed(one.after)
        size = len(varied(new))
        corners = np.array(list(itertools.product((0.0, 1.0), repeat=size)))
        if any(
            (ending(new, values_at(new, shares)) == 1).any()
            for shares in (corners, rng.random((100_000, size)))
        ):
            wrong.append(f"brake {number}, changed to {one.after}: one within its tolerances jumps")
    return {"kind": "changes", "wrong": wrong, "changes": len(found)}
