"""Equilibria of pages with bells, steps and forces that fall with distance, against SciPy from many
starts.

A case is ten sets of parameters of a page at random, asked as one grid;
``python -m validation bell_pages`` draws 200 of each of the four pages. It guards the claims that
every point is answered, that no state is lost where a point is decided, and that whatever is
undecided is said.
"""

from typing import Any

import numpy as np

import spragsym as ss
from tests.oracles.bell_pages import CASES as PAGES
from tests.oracles.bell_pages import drawn, missed
from tests.oracles.user_pages import model_of

CASES = 20 * len(PAGES)
POINTS, STARTS = 10, 60


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One grid of a page."""
    name = list(PAGES)[number % len(PAGES)]
    case = PAGES[name]
    model = model_of(case.hand.page, name)
    p = drawn(case, rng, POINTS)
    eq = ss.equilibria(model.Parameters(**p))
    states, wrong = missed(case, model, p, eq, rng, STARTS)
    wrong += [f"{name}: a region that is open, and no remark"] * (
        not eq.whole.all() and not eq.remarks
    )
    return {
        "kind": name,
        "wrong": wrong,
        "points": POINTS,
        "states": states,
        "undecided": int((~eq.decided).sum()),
        "open": int((~eq.whole).sum()),
    }
