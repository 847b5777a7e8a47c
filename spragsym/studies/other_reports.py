"""The report of a study with another model than the article's: states in the units of the file, and folds."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..display import Result
from ..errors import SpragsymError
from ..models.load import load
from ..statics.solver import Stability
from . import other_models
from .study import Study


@dataclass(frozen=True)
class ModelReport(Result):
    """States of sliding in contact, folds along the friction, and one sentence.

    Attributes
    ----------
    states : tuple of dict
        Each with ``stable``, ``statics``, ``growth_per_s``, ``frequencies_hz`` and its coordinates, lengths in millimetres.
    folds : tuple of float
        Friction coefficients at which states meet.
    complete : bool
        Whether states and folds are proved to be all there are.
    warnings : tuple of str
    verdict : str
    """

    states: tuple[dict[str, Any], ...]
    folds: tuple[float, ...]
    complete: bool
    warnings: tuple[str, ...]
    verdict: str

    def to_dict(self) -> dict[str, Any]:
        """The keys of a report; None for what is not computed for this model."""
        unknown = (
            "mu_jump", "theta0_jump_deg", "mu_cusp", "mu_effective", "margin_percent", "spring_force_N", "contact_force_N",
            "oscillation", "certificate", "probability", "sobol",
        )  # fmt: skip
        single = self.states[0] if len(self.states) == 1 else {}
        return dict.fromkeys(unknown) | {
            "states": list(self.states), "frequencies_hz": single.get("frequencies_hz"), "redesign": [],
            "displacement_mm": None if not single else {"rest": [single.get("x_mm"), single.get("y_mm")]},
            "warnings": list(self.warnings),
        }  # fmt: skip

    def text(self) -> str:
        """The verdict, the warnings and the states."""
        rows = [", ".join(f"{name} = {_shown(value)}" for name, value in state.items()) for state in self.states]
        return "\n\n".join([self.verdict, *(f"warning: {one}" for one in self.warnings), "\n".join(["State", *rows])])

    def __str__(self) -> str:
        return self.text()


def _shown(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.5g}"
    return "[" + ", ".join(f"{one:.5g}" for one in value) + "]" if isinstance(value, list) else str(value)


def model_report(study: Study) -> ModelReport:
    """All states in contact, and the folds along the friction, where the model has μ₀."""
    model = load(study.model)
    p, scales = other_models.dimensionless(study.model, study.values)
    eq = model.equilibria(p)
    units = {entry["name"]: entry["unit"] for entry in model.about["coordinates"]}
    found = tuple(_state(eq, slot, units, scales) for slot in range(int(eq.count)))
    turns, complete = _folds(model, p)
    complete = complete and bool(eq.complete)
    count = "one state" if len(found) == 1 else f"{len(found)} states"
    stable = sum(state["stable"] for state in found)
    meet = "states meet at the friction " + ", ".join(f"{mu:.4g}" for mu in turns) if turns else "no states meet at any friction"
    verdict = f"With the model {study.model} there is {count} of sliding in contact, {stable} of them stable; {meet}."
    warnings = [
        "which state the brake is in, margins and probabilities are computed for the model kang_nam only",
        "the states are those at full slip, where friction is largest: at a slow belt less of it works",
    ]
    if not complete:
        warnings.append("that these are all states and folds is not proved here")
    return ModelReport(found, turns, complete, tuple(warnings), verdict)


def _state(eq: Any, slot: int, units: dict[str, str], scales: dict[str, float]) -> dict[str, Any]:
    roots = np.asarray(eq.eigenvalues[slot])
    imaginary = sorted({round(abs(float(root.imag)), 12) for root in roots if abs(root.imag) > 1e-9})
    growth = float(eq.growth[slot])
    place = {}
    for name, unit in units.items():
        value = float(eq.coordinates[name][slot])
        place[f"{name}_mm" if unit == "m" else f"{name}_deg"] = (
            1e3 * scales["length"] * value if unit == "m" else math.degrees(value)
        )
    kind = Stability(int(eq.stability[slot]))
    return {
        "stable": kind == Stability.STABLE and growth <= 0, "statics": kind.name.lower(), **place,
        "growth_per_s": growth / scales["time"],
        "frequencies_hz": [value / (2 * math.pi * scales["time"]) for value in imaginary],
    }  # fmt: skip


def _folds(model: Any, p: Any) -> tuple[tuple[float, ...], bool]:
    if "mu0" not in model.parameters:
        return (), False
    try:
        found = model.folds(p, "mu0")
    except SpragsymError:
        return (), False
    return tuple(sorted(float(value) for value in found.values["mu0"])), bool(found.complete)
