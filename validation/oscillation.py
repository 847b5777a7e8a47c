"""The numbers of docs/oscillation.md by the commands that stand beside them, those that take long
and proofs included.

Last found: a row whose command did not print its number (013b47dd).
"""

import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from tests.oracles import oscillation_page

ASKED = [("row", row) for row in oscillation_page.rows() if not row.command.startswith("python")]
# a row, or a command and its lines
ASKED += [("proof", pair) for pair in oscillation_page.proofs().items()]  # type: ignore[misc]
CASES = len(ASKED)


def judge(number: int, _: np.random.Generator) -> dict[str, Any]:
    """One row of the table, or one proof."""
    kind, asked = ASKED[number]
    with tempfile.TemporaryDirectory() as folder:
        wrong = (
            oscillation_page.differences(asked, Path(folder))
            if kind == "row"
            else oscillation_page.unproved(*asked)
        )  # type: ignore[misc]
    return {"kind": kind, "wrong": wrong}
