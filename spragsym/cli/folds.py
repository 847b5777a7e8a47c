"""``spragsym folds``: where states meet along one parameter."""

from __future__ import annotations

import spragsym as ss

from ..progress import show_progress
from .of_model import Case, method, of_model
from .options import as_json
from .points import points_of, print_points
from .spans import Typed, box, span, vary, within
from .tables import print_json


@of_model(statics=True)
@vary("What varies: a parameter, with --data a quantity of the file too; with a range as mu0=0:1. Default: {last}.")
@within
@method
@as_json
def folds(case: Case, vary: Typed | None, within: tuple[Typed, ...], json_output: bool) -> None:
    """All folds along one parameter, proved: which state ends there, when, and where it jumps to.

    \b
    Examples:
      spragsym folds --theta0 40
      spragsym folds --data brake.toml --vary k_x
      spragsym folds --model two_springs --theta0 40 --vary mu0=0:1

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    along = span(case, vary, case.model.axes[-1])
    with show_progress(f"searching for folds along {along.name}"):
        found = ss.folds(case.set(along.name), along.name, **case.searching(along.between, box(case, within)))
    told = points_of(case, found, [along])
    if json_output:
        print_json({"model": case.model.name, "vary": along.title, **told})
    else:
        print_points("Folds", told, [along])
