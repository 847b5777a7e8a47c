"""What the tolerances leave possible with any model: a brake within them that jumps, if one is found."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..catastrophe import sliding_friction
from ..errors import SpragsymError
from ..models.load import load
from . import other_models
from .study import Study


def certificate_of(study: Study) -> dict[str, Any]:
    """Whether a brake within the tolerances jumps: the one of the file, then the corner to which the jump comes down fastest.

    ``outcome`` is ``"refuted"``, with the brake in the file's units, or ``"undecided"``: nothing is proved.

    Notes
    -----
    Source: the first jump of a path with proved folds, at the largest friction. The corner is that of the ends at which, one
    quantity at a time, the jump comes at a smaller friction than at the other end.
    """
    ends = {name: (one.low, one.high) for name, one in study.quantities.items()}
    high = dict(study.values) | {name: ends[name][1] for name in ("mu0", "V", "d") if name in ends}
    wide = [name for name, (low, up) in ends.items() if low < up and name not in ("mu0", "V", "d", "m")]
    tried = high
    example = high if _jumps(study, high) else None
    if example is None and wide:
        tried = high | {name: _worse(study, high, name, ends[name]) for name in wide}
        example = tried if _jumps(study, tried) else None
    shown = None if example is None else {
        name: {"value": study.in_file(name, example[name]), "unit": study.quantities[name].unit}
        for name in example if ends[name][0] < ends[name][1]
    }  # fmt: skip
    return {
        "claim": "no jump", "outcome": "undecided" if example is None else "refuted", "undecided": float(example is None),
        "boxes": 0, "counterexample": shown,
    }  # fmt: skip


def _path(study: Study, values: Mapping[str, float], friction: float) -> Any:
    model = load(study.model)
    p, _ = other_models.dimensionless(study.model, values)
    return model.quasi_static_path(p, "mu0", [0.0, friction]).jumps


def _jumps(study: Study, values: Mapping[str, float]) -> bool:
    """Whether the state of small deformation jumps at the friction that works; False where that is not known."""
    friction = values["mu0"]
    if {"V", "d"} <= set(values):
        friction = float(sliding_friction(friction, values["V"], values["d"]))
    try:
        return friction > 0 and bool(_path(study, values, friction))
    except SpragsymError:
        return False


def _worse(study: Study, values: Mapping[str, float], name: str, ends: tuple[float, float]) -> float:
    """The end of a quantity at which the jump comes first."""
    found = []
    for end in ends:
        try:
            jumps = _path(study, {**values, name: end}, 10.0 * max(values["mu0"], 0.1))
        except SpragsymError:
            jumps = ()
        found.append((min((float(jump.value) for jump in jumps), default=float("inf")), end))
    return min(found)[1]
