"""True errors of equilibria, beside the bounds that are said of them: in floats, and to any number
of digits.
"""

from collections.abc import Iterable, Iterator

import mpmath
import numpy as np

import spragsym as ss
from spragsym import precise
from spragsym.generated.quantities import PARAMETERS
from spragsym.results.precise_states import PreciseEquilibrium
from tests.oracles import reference
from tests.oracles.families import FAMILIES

#: Precisions that a caller may have set.
CALLERS = (1, 15, 50, 400)
#: Digits of the reference beyond the bits that results carry, of which there are 64 more than were
#: asked for.
MORE_DIGITS = 100


def points(number: int, seed: int = 0) -> Iterator[tuple[float, ...]]:
    """Points of every family in turn."""
    rng = np.random.default_rng(seed)
    each = -(-number // len(FAMILIES))
    columns = [
        np.stack(family(rng, each).broadcast(*PARAMETERS), axis=-1) for family in FAMILIES.values()
    ]
    rows = np.stack(columns, axis=1).reshape(-1, len(PARAMETERS))[:number]
    return (tuple(map(float, row)) for row in rows)


def worst_shares(
    point: tuple[float, ...], precisions: Iterable[int], *, contact: bool = True
) -> dict[int, float]:
    """For each precision the largest true error of any number of any state, over its bound; ``inf``
    for a wrong count.
    """
    results, given = {}, dict(zip(PARAMETERS, point, strict=True))
    for i, dps in enumerate(precisions):
        with mpmath.workdps(CALLERS[i % len(CALLERS)]):
            results[dps] = precise.equilibria(**given, contact=contact, dps=dps)
    digits = max(results) + MORE_DIGITS
    # Where to begin is all that the reference takes from the results.
    begin = precise.equilibria(**given, contact=contact, dps=60)
    truth = [reference.refine(state.x, state.y, *point, contact, digits=digits) for state in begin]
    with mpmath.workdps(digits):
        return {
            dps: max((_share(*pair, dps) for pair in zip(found, truth, strict=True)), default=0.0)
            if len(found) == len(truth)
            else float("inf")
            for dps, found in results.items()
        }


def _share(state: PreciseEquilibrium, truth: tuple[mpmath.mpf, ...], dps: int) -> float:
    """The true error over the bound, or over what was asked for where the bound is larger."""
    bound = min(state.error, mpmath.mpf(10) ** -dps)
    values = (state.theta, state.L, state.x, state.y)
    gaps = [
        abs(value - exact) / max(1, abs(exact)) for value, exact in zip(values, truth, strict=True)
    ]
    return float(max(gaps) / bound) if state.error <= mpmath.mpf(10) ** -dps else float("inf")


def wrong_counts(p: ss.Parameters, eq: ss.results.Equilibria) -> int:
    """Points whose number of equilibria in contact is not the reference's."""
    columns = p.broadcast(*PARAMETERS)
    return sum(
        reference.count_contact(*map(float, point)) != count
        for point, count in zip(zip(*columns, strict=True), eq.count.tolist(), strict=True)
    )


def worst_errors(
    p: ss.Parameters, eq: ss.results.Equilibria, rng: np.random.Generator, checked: int
) -> tuple[float, float]:
    """Largest |error| / max(1, |value|) of a subsample, and the largest share of the bound that one
    reaches.
    """
    columns = p.broadcast(*PARAMETERS)
    worst = ratio = 0.0
    for row in rng.choice(eq.count.size, min(checked, eq.count.size), replace=False):
        point = [float(column[row]) for column in columns]
        for slot in range(int(eq.count[row])):
            exact = reference.refine(
                float(eq.x[row, slot]), float(eq.y[row, slot]), *point, contact=eq.contact
            )
            found = (eq.theta[row, slot], eq.L[row, slot], eq.x[row, slot], eq.y[row, slot])
            error = max(
                float(abs(value - float(got)) / max(1, abs(value)))
                for value, got in zip(exact, found, strict=True)
            )
            worst, ratio = max(worst, error), max(ratio, error / float(eq.error[row, slot]))
    return worst, ratio
