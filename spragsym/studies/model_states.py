"""The states of any model in newtons, millimetres and hertz, from its generated functions."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..dynamics import forces
from ..models.balance import Balance
from ..models.stability import linearization, roots
from ..parameters import FloatArray
from ..statics.results import Stability


def model_states(model: Any, p: Any, scales: Mapping[str, float], current: Mapping[str, float] | None) -> list[dict[str, Any]]:
    """Every state in contact, each with its forces; ``current`` are the coordinates of the one that the system is in."""
    eq = model.equilibria(p)
    units = {entry["name"]: entry["unit"] for entry in model.about["coordinates"]}
    found = []
    for slot in range(int(eq.count)):
        place = {name: float(eq.coordinates[name][slot]) for name in units}
        here = current is not None and all(abs(place[name] - current[name]) < 1e-6 for name in units)
        kind = Stability(int(eq.stability[slot]))
        rates = _rates(model, p, place) / scales["time"]
        upper = sorted((rate for rate in rates if rate.imag > 1e-9 * np.abs(rates).max()), key=lambda rate: float(rate.imag))
        growth = float(eq.growth[slot]) / scales["time"]
        found.append({
            "current": here, "stable": bool(eq.stable[slot]), "statics": kind.name.lower(),
            **{f"{name}_{'mm' if unit == 'm' else 'deg'}": value * (1e3 * scales["length"] if unit == "m" else math.degrees(1.0))
               for (name, unit), value in zip(units.items(), place.values(), strict=True)},
            "spring_force_N": spring_force(model, p, place, scales["force"]),
            "contact_force_N": contact_force(model, p, place, scales["force"]),
            "frequencies_hz": [float(rate.imag) / (2 * math.pi) for rate in upper],
            "damping_ratio": [float(-rate.real / abs(rate)) for rate in upper], "growth_per_s": growth,
        })  # fmt: skip
    return found


def _rates(model: Any, p: Any, place: Mapping[str, float]) -> FloatArray:
    """Roots of the motion linearized about a state, the damping of dampers and of the friction law included."""
    given = np.array([[float(value)] for value in p.scalars(*model.parameters)])
    states = np.array([[value] for value in place.values()])
    M, C, K = (np.moveaxis(part, -1, 0) for part in linearization(Balance(model, True), states, given))
    return np.asarray(roots(M, C, K)[0])


def contact_force(model: Any, p: Any, place: Mapping[str, float], unit: float) -> float | None:
    """The normal force of the contact; 0 where it is lifted off, None where there is no contact."""
    found = _told(model, p, place).get("contact_force")
    return None if found is None else found * unit


def spring_force(model: Any, p: Any, place: Mapping[str, float], unit: float) -> float | dict[str, float] | None:
    """Tension of the inclined spring, negative where it pushes; of several by their names; None where there is none."""
    told = [value * unit for name, value in _told(model, p, place).items() if name.startswith("spring_force")]
    if len(told) < 2:
        return next(iter(told), None)
    return dict(zip((entry["name"] for entry in model.about["springs"]), told, strict=True))


def _told(model: Any, p: Any, place: Mapping[str, float]) -> dict[str, float]:
    """The forces of the model at a place, by their names."""
    constants = [float(value) for value in model.arguments(p, "motion")]
    return {name: float(force(list(place.values()), constants)) for name, force in forces.told_of(model).items()}
