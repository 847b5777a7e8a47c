"""Files of ``validation/papers`` and the article's own: every verdict is the expected one.

A case is one file. What its misprints are was confirmed by a second derivation, which the file
names; here they are found again, and a paper with them repaired holds without a repair.
"""

from typing import Any

import numpy as np

from spragsym.derive.statements import verdicts

from .printed_faults import FOLDER, files

CASES = len([*FOLDER.rglob("*.toml")]) + 1


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One file."""
    path, paper, model = files()[number % CASES]
    rows = verdicts.check(paper, model).rows
    wrong = [f"{path.parent.name}, {it.id}: {it.status}" for it in rows if not it.is_expected]
    again = verdicts.check(verdicts.repaired(paper, model), model, repair=False).rows
    wrong += [
        f"{path.parent.name}, {it.id}, repaired: {it.status}"
        for it in again
        if it.status == "failed"
    ]
    misprints = sum(it.status == "misprint" for it in rows)
    return {"kind": path.parent.name, "wrong": wrong, "misprints": misprints, "rows": len(rows)}
