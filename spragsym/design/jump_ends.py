"""Ends of followed states at many points, from which jump values and their gradients are taken."""

import warnings
from collections.abc import Mapping
from dataclasses import dataclass

from ..errors import ConvergenceError, UndecidedWarning
from ..models.parameters import FloatArray

#: Where θ₀ begins to rise; folds below it are looked for exactly.
FIRST_ANGLE = 2.0**-40
#: Parameters that rise from their lower end; the others move from the value that they have.
FROM_LOWER_END = {"theta0": FIRST_ANGLE, "mu0": 0.0}


@dataclass(frozen=True)
class Ends:
    """Where the states of many points end: the value, NaN where they don't, a bound on its error, and the coordinates at a fold.

    ``value`` and ``error`` have the shape of the points, ``state`` has (n, …); ``reasons`` says of which points, by their
    position in ``value.flat``, nothing is known, and why.
    """

    value: FloatArray
    error: FloatArray
    state: FloatArray
    reasons: Mapping[int, str]


def told(found: Ends) -> Ends:
    """The values themselves; an error if nothing is known of a single point, a warning if nothing is known of some of many."""
    for reason in found.reasons.values():
        if not found.value.shape:
            raise ConvergenceError(reason)
        what = f"{len(found.reasons)} points have no answer and are NaN; the first: {reason}"
        warnings.warn(what, UndecidedWarning, stacklevel=3)
        break
    return found
