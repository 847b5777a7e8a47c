"""The states of any model in newtons, millimetres and hertz, from its generated functions."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

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


def _values(model: Any, p: Any) -> dict[str, Any]:
    """The arguments of the generated functions, by name."""
    names = model.about["arguments"]["motion"]
    values = dict(zip(names, (float(one) for one in model.arguments(p, "motion")), strict=True))
    return values | dict(zip(model.about["arguments"]["statics"], (float(one) for one in model.arguments(p)), strict=True))


def _directions(model: Any, place: Mapping[str, float], values: Mapping[str, Any]) -> list[float]:
    """Cosine, sine and length of every spring, then turnings."""
    return [float(part) for part in Balance(model, True).plain_directions(list(place.values()), values, np)]


def _rates(model: Any, p: Any, place: Mapping[str, float]) -> FloatArray:
    """Roots of the motion linearized about a state, the damping of dampers and of the friction law included."""
    given = np.array([[float(value)] for value in p.scalars(*model.parameters)])
    states = np.array([[value] for value in place.values()])
    M, C, K = (np.moveaxis(part, -1, 0) for part in linearization(Balance(model, True), states, given))
    return np.asarray(roots(M, C, K)[0])


def contact_force(model: Any, p: Any, place: Mapping[str, float], unit: float) -> float | None:
    """The contact's share of the balance: with it less without it, and without friction; 0 where it is lifted off."""
    if model.about["contact"]["gap"] is None:
        return None
    values = _values(model, p)
    given = [values[name] for name in model.about["arguments"]["statics"]]
    if model.about["contact"]["unilateral"] and float(model.statics.contact_gap(*place.values(), *given)) > 0:
        return 0.0
    taken = [*place.values(), *_directions(model, place, values), *given]
    with_it, without = (np.array(model.statics.forces(*taken, 0.0, pushing), dtype=float) for pushing in (1, 0))
    return float(np.linalg.norm(with_it - without)) * unit


def spring_force(model: Any, p: Any, place: Mapping[str, float], unit: float) -> float | dict[str, float] | None:
    """Tension of the inclined spring, negative where it pushes; of several by their names; None where there is none.

    Notes
    -----
    Source: the share of the balance that is linear in a spring's stiffness acts along it, wherever it is.
    """
    if not model.about["springs"]:
        return None
    rows, directions, values = _shares(model, p, place)
    found = {}
    for j, (spring, name) in enumerate(zip(model.about["springs"], _stiffnesses(model, p), strict=True)):
        if name is not None:
            along = rows[:2, model.about["by_parameters"].index(name)] @ np.array(directions[3 * j : 3 * j + 2])
            found[spring["name"]] = float(-along * values[name] * unit)
    return found if len(found) > 1 else next(iter(found.values()), None)


def _shares(model: Any, p: Any, place: Mapping[str, float]) -> tuple[FloatArray, list[float], dict[str, Any]]:
    """Derivatives of the forces by the parameters in which they are linear, the springs' directions, and the arguments."""
    values = _values(model, p)
    directions = _directions(model, place, values)
    given = [values[name] for name in model.about["arguments"]["statics"]]
    rows = model.statics.forces_by_parameters(*place.values(), *directions, *given, 0.0, 1)
    return np.array(rows, dtype=float), directions, values


def _stiffnesses(model: Any, p: Any) -> list[str | None]:
    """The parameter that is the stiffness of each spring: its share of the balance acts along the spring at any place."""
    names = [entry["name"] for entry in model.about["parameters"]
             if entry["quantity_unit"] == "N/m" and entry["name"] in model.about["by_parameters"]]  # fmt: skip
    looked = [_shares(model, p, {name: size * (j + 1) for j, name in enumerate(model.coordinates)}) for size in (-0.013, -0.029)]

    def acts(name: str, j: int) -> bool:
        for rows, directions, _ in looked:
            c, s = directions[3 * j : 3 * j + 2]
            x, y = rows[:2, model.about["by_parameters"].index(name)]
            if not abs(x * s - y * c) < 1e-9 * math.hypot(x, y):
                return False
        return True

    return [next((name for name in names if acts(name, j)), None) for j in range(len(model.about["springs"]))]
