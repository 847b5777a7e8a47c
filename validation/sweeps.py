"""Sweeps under attack: journals and result files damaged, disks filled, workers and their parents
killed.

It guards the claim that no kill, full disk or damaged byte makes a wrong number.
"""

import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from tests.oracles import sweep_attacks
from validation import machine_attacks

CASES = 40


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """Some attacks of one kind; what contradicts ends with an error."""
    kind = ("journals", "files", "disks", "workers")[number % 4]
    with tempfile.TemporaryDirectory() as name:
        try:
            if kind == "disks":
                outcomes = machine_attacks.attack_disks(rng, 4)
            else:
                attack, count = {
                    "journals": (sweep_attacks.attack_journals, 100),
                    "files": (sweep_attacks.attack_files, 200),
                    "workers": (machine_attacks.attack_workers, 4),
                }[kind]
                outcomes = attack(rng, Path(name), count)
        except PermissionError as error:
            return {"kind": f"{kind}: {error}", "wrong": []}
    return {
        "kind": kind,
        "wrong": [],
        **{f"{kind} {key}": value for key, value in outcomes.items()},
    }
