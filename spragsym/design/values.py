"""Values of many points, of some of which nothing is known, and from where parameters rise."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from typing import Protocol, TypeVar

from ..errors import ConvergenceError, UndecidedWarning
from ..models.parameters import FloatArray

#: Where θ₀ begins to rise; folds below it are looked for exactly.
FIRST_ANGLE = 2.0**-40


#: Parameters that rise from their lower end; the others move from the value that they have.
FROM_LOWER_END = {"theta0": FIRST_ANGLE, "mu0": 0.0}


class Values(Protocol):
    """Values of many points, NaN where there is none, and of which points nothing is known, and why."""

    @property
    def value(self) -> FloatArray: ...

    @property
    def reasons(self) -> Mapping[int, str]: ...


Known = TypeVar("Known", bound=Values)


def told(found: Known) -> Known:
    """The values themselves; an error if nothing is known of a single point, a warning if nothing is known of some of many."""
    for reason in found.reasons.values():
        if not found.value.shape:
            raise ConvergenceError(reason)
        what = f"{len(found.reasons)} points have no answer and are NaN; the first: {reason}"
        warnings.warn(what, UndecidedWarning, stacklevel=3)
        break
    return found
