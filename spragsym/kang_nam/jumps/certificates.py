"""Claims about every point of a box of parameters, and of units of measure that have tolerances too, by closed forms."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ...design.certificates import Claim, corner_values
from ...errors import ParameterError
from ...models.parameters import NAMES, FloatArray, Parameters
from ...models.quantities import Unit, checked_units
from ...questions import NotInClosedForm
from .cells import Boxes
from .claims import CLAIMS
from .jump_values import require_usual


def claims(
    low: Parameters, high: Parameters, claim: str, *, vary: str | None = None, begin: float | None = None,
    units: Mapping[str, Unit] | None = None,
) -> Claim:  # fmt: skip
    """The closed form of :func:`spragsym.design.tube_certificates.claims`, for friction that rises.

    Notes
    -----
    Source: f, f′ and the eigenvalues of K over boxes, in affine arithmetic with every rounding bounded. A box that touches the
    border of the claim, a fold or an onset of flutter, can't be decided there.
    """
    require_usual(low, "mu0", begin)
    if claim not in CLAIMS or not (vary is None or (vary == "mu0" and claim == "no jump")):
        raise NotInClosedForm
    return _Closed(low, high, claim, checked_units(units, tuple(Parameters.ranges), ("theta0",)))


class _Closed(Claim):
    """One of the claims of :data:`CLAIMS`."""

    batch, most, corners = 2048, 20_000, 512
    whole: Boxes

    def __init__(self, low: Parameters, high: Parameters, claim: str, units: Mapping[str, Unit]) -> None:
        self.prove, self.false = CLAIMS[claim]
        matter = {name: unit for name, unit in units.items() if set(unit.powers) & set(NAMES)}
        self.sides = (*NAMES, *matter)
        powers: dict[str, list[tuple[int, int]]] = {name: [] for name in NAMES}
        for side, unit in enumerate(matter.values(), len(NAMES)):
            for name in (one for one in NAMES if one in unit.powers):
                powers[name].append((side, _whole_number(name, unit.powers[name])))
        ends = [
            np.array([*end, *(getattr(unit, what) for unit in matter.values())])[:, None]
            for end, what in zip(corner_values(NAMES, low, high), ("low", "high"), strict=True)
        ]
        if claim == "no jump":  # what goes on to the largest friction goes on to every other
            ends[0][NAMES.index("mu0")] = ends[1][NAMES.index("mu0")]
        kept = {name: tuple(found) for name, found in powers.items() if found}
        self.whole = Boxes(ends[0], ends[1], np.zeros(1, dtype=np.bool_), kept)

    def settled(self, parts: Boxes, sharp: bool = False) -> tuple[Boxes, FloatArray]:
        holds, weight = self.prove(parts)
        width = parts.high - parts.low
        known = ((width > 0) & (weight > 0)).any(axis=0)
        # The widest where none is known to matter.
        return replace(parts, holds=holds), np.where(known, weight, width / np.maximum(parts.high, 1e-300))

    def point(self, values: FloatArray) -> Parameters:
        return Parameters(**self.whole.parameters(values))

    def refuted(self, points: FloatArray) -> Parameters | None:
        fails = np.flatnonzero(self.false(self.point(points)))
        return self.point(points[:, fails[0]]) if fails.size else None


def _whole_number(name: str, power: float) -> int:
    if int(power) != power or name == "mu0":
        raise ParameterError(f"units: {name} has the power {power:g} of one; closed forms take whole numbers, and none for mu0; "
                             "method='search' takes others")  # fmt: skip
    return int(power)
