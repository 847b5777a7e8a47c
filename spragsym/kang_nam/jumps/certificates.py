"""A claim about every point of a box of parameters: proved, refuted by a point, or left open in a share of the volume."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ...bifurcation.tubes.tube_regions import halves
from ...design.certificates import Certificate
from ...design.state_certificates import corner_values
from ...errors import ParameterError
from ...models.parameters import NAMES, FloatArray, Parameters, as_count
from ...models.parameters.units import Unit, checked_units
from ...questions import NotInClosedForm
from .cells import Boxes
from .claims import CLAIMS, Claim
from .jump_values import require_usual

#: Boxes at a time.
_BATCH = 2048


def certify(
    low: Parameters, high: Parameters, claim: str = "no jump", *, vary: str | None = None, begin: float | None = None,
    max_boxes: int | None = None, refute: bool = True, units: Mapping[str, Unit] | None = None,
) -> Certificate:  # fmt: skip
    """The closed form of :func:`spragsym.certify`, for friction that rises.

    Notes
    -----
    Source: f, f′ and the eigenvalues of K over boxes, in affine arithmetic with every rounding bounded; boxes are halved until
    they are decided. A box that touches the border of the claim, a fold or an onset of flutter, can't be decided there: it ends
    after ``max_boxes``.
    """
    require_usual(low, "mu0", begin)
    if claim not in CLAIMS or not (vary is None or (vary == "mu0" and claim == "no jump")):
        raise NotInClosedForm
    max_boxes = as_count("max_boxes", 20_000 if max_boxes is None else max_boxes)
    chosen = CLAIMS[claim]
    pending = _whole(low, high, chosen, checked_units(units, tuple(Parameters.ranges), ("theta0",)))
    seen, open_share = 0, 0.0
    while pending.share.size:
        batch, rest = pending[:_BATCH], pending[_BATCH:]
        seen += batch.share.size
        point = chosen.refute(batch) if refute else None
        if point is not None:
            return Certificate(claim, "refuted", point, float(batch.share.sum() + rest.share.sum()), seen)
        proved, weight = chosen.prove(batch)
        open_ones = np.flatnonzero(~proved)
        if seen + rest.share.size >= max_boxes:
            open_share = float(batch.share[open_ones].sum() + rest.share.sum())
            break
        pending = rest.then(halved(batch[open_ones], weight[:, open_ones]))
    return Certificate(claim, "undecided" if open_share else "proved", None, open_share, seen)


def _whole(low: Parameters, high: Parameters, chosen: Claim, units: Mapping[str, Unit]) -> Boxes:
    """The box of parameters and units, one box."""
    ends = [end[:, None] for end in corner_values(NAMES, low, high)]
    for name in chosen.from_above:
        ends[0][NAMES.index(name)] = ends[1][NAMES.index(name)]
    matter = [unit for unit in units.values() if set(unit.powers) & set(NAMES)]
    powers: dict[str, list[tuple[int, int]]] = {name: [] for name in NAMES}
    for side, unit in enumerate(matter, len(NAMES)):
        for name, power in unit.powers.items():
            if name in powers:
                powers[name].append((side, _whole_number(name, power)))
    low_ends, high_ends = (
        np.concatenate([end, [[getattr(unit, what)] for unit in matter]]) if matter else end
        for end, what in zip(ends, ("low", "high"), strict=True)
    )
    return Boxes(low_ends, high_ends, np.ones(1), {name: tuple(found) for name, found in powers.items() if found})


def _whole_number(name: str, power: float) -> int:
    if int(power) != power or name == "mu0":
        raise ParameterError(f"units: {name} has the power {power:g} of one; closed forms take whole numbers, and none for mu0; "
                             "method='search' takes others")  # fmt: skip
    return int(power)


def halved(boxes: Boxes, weight: FloatArray) -> Boxes:
    """Each box cut across the side that matters most; one without width is not cut, and where none is known the widest is.

    A box that is a point, or as thin as floats are, has no halves: both are the same, and it stays open.
    """
    width = boxes.high - boxes.low
    known = ((width > 0) & (weight > 0)).any(axis=0)
    _, high, low = halves(boxes.low, boxes.high, np.where(known, weight, width / np.maximum(boxes.high, 1e-300)))
    half = replace(boxes, share=boxes.share / 2)
    return replace(half, high=high).then(replace(half, low=low))
