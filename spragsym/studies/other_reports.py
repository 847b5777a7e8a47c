"""The report of a study with another model than the article's: all that its states, folds, paths and cycles answer."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..catastrophe import sliding_friction
from ..display import Result
from ..errors import ConvergenceError, SpragsymError
from ..models.load import load
from . import other_models
from .model_states import model_states
from .study import Study

#: Angles in degrees between which a jump is looked for.
_ANGLES = (0.5, 179.0)
#: Keys of a report that are computed for the article's model only, with the reason.
_ONLY = ("certificate", "probability", "sobol", "redesign")


@dataclass(frozen=True)
class ModelReport(Result):
    """What can be said of a brake with any model; None where there is no answer, with the reason among ``warnings``.

    Attributes
    ----------
    mu_jump, theta0_jump_deg : float or None
        Friction and angle at which the state of small deformation jumps, followed on a path with proved folds; NaN for never.
    mu_cusp : float or None
        Friction of the lowest cusp; that nothing jumps below it is not shown.
    mu_effective : float
        The friction that works at the speed of the belt.
    margin_percent : float or None
        By how much ``mu_jump`` exceeds the largest friction within the tolerances.
    states : tuple of dict
        Each with ``current``, ``stable``, ``statics``, forces, ``frequencies_hz``, ``damping_ratio``, ``growth_per_s`` and its
        coordinates, lengths in millimetres.
    folds : tuple of float
        Friction coefficients at which states meet.
    oscillation : dict or None
    complete : bool
        Whether states and folds are proved to be all there are.
    warnings : tuple of str
    verdict : str
    """

    mu_jump: float | None
    theta0_jump_deg: float | None
    mu_cusp: float | None
    mu_effective: float
    margin_percent: float | None
    states: tuple[dict[str, Any], ...]
    folds: tuple[float, ...]
    oscillation: dict[str, Any] | None
    complete: bool
    warnings: tuple[str, ...]
    verdict: str

    def to_dict(self) -> dict[str, Any]:
        """The keys of a report; None for what is not computed for this model."""
        here: Mapping[str, Any] = next((state for state in self.states if state["current"]), {})
        return {
            "mu_jump": self.mu_jump, "theta0_jump_deg": self.theta0_jump_deg, "mu_cusp": self.mu_cusp,
            "mu_effective": self.mu_effective, "margin_percent": self.margin_percent, "states": list(self.states),
            "frequencies_hz": here.get("frequencies_hz"),
            "spring_force_N": {"rest": here.get("spring_force_N"), "oscillation": None},
            "contact_force_N": {"rest": here.get("contact_force_N"), "oscillation": None},
            "displacement_mm": {
                "rest": [here.get("x_mm"), here.get("y_mm")] if here else None,
                "oscillation_amplitude": self.oscillation["amplitude_mm"] if self.oscillation else None,
            },
            "oscillation": self.oscillation, "certificate": None, "probability": None, "sobol": None, "redesign": [],
            "warnings": list(self.warnings),
        }  # fmt: skip

    def text(self) -> str:
        """The verdict, the warnings, the numbers and the states."""
        numbers = {
            "jump at friction": self.mu_jump, "jump at angle, deg": self.theta0_jump_deg, "lowest cusp at friction": self.mu_cusp,
            "friction at the belt's speed": self.mu_effective, "margin to the largest friction, %": self.margin_percent,
        }  # fmt: skip
        jump = [f"  {name:<34}{'unknown' if value is None else _shown(value)}" for name, value in numbers.items()]
        blocks = [self.verdict, *(f"warning: {one}" for one in self.warnings), "\n".join(["Jump", *jump])]
        rows = [", ".join(f"{name} = {_shown(value)}" for name, value in state.items()) for state in self.states]
        blocks.append("\n".join(["States", *rows]))
        if self.oscillation:
            blocks.append("\n".join(["Oscillation", *(f"  {name:<34}{_shown(one)}" for name, one in self.oscillation.items())]))
        return "\n\n".join(blocks)

    def __str__(self) -> str:
        return self.text()


def _shown(value: Any) -> str:
    if isinstance(value, float):
        return "never" if math.isnan(value) else f"{value:.5g}"
    return "[" + ", ".join(_shown(one) for one in value) + "]" if isinstance(value, list) else str(value)


def model_report(study: Study, oscillation: bool = True) -> ModelReport:
    """All states in contact at the friction that works, where the state of small deformation jumps, and the cycle."""
    model = load(study.model)
    p, scales = other_models.dimensionless(study.model, study.values)
    warnings: list[str] = []
    full = float(model.statics.friction_at_rest(*model.arguments(p, "motion")))
    fraction = float(sliding_friction(1.0, float(p.V), float(p.d))) if {"mu0", "V", "d"} <= _known(study) else 1.0
    if "V" not in _known(study):
        warnings.append("V is not given: friction is taken at full slip, and no oscillation is looked for")
    elif fraction < 0.95:
        warnings.append(f"the belt is so slow that friction works at {100 * fraction:.3g} % of {full:.4g}; check d and V")
    at = p.replace(mu0=fraction * full) if "mu0" in model.parameters else p
    turns, complete = _folds(model, p)
    jump = _jump(model, p, "mu0", (0.0, 1.1 * max(turns, default=1.0)), warnings)
    angle = _jump(model, at, "theta0", tuple(map(math.radians, _ANGLES)), warnings)
    high = study.quantities["mu0"].high * fraction if "mu0" in study.quantities else math.nan
    current = _current(model, at, warnings)
    states = tuple(model_states(model, at, scales, current))
    cycle = _oscillation(model, p, scales, warnings) if oscillation and {"V", "d"} <= _known(study) else None
    if not complete:
        warnings.append("that these are all states and folds is not proved here")
    warnings.append(f"{', '.join(_ONLY)} are computed for the model kang_nam only, and are null here")
    return ModelReport(
        jump, None if angle is None else math.degrees(angle), _cusp(model, p, warnings), fraction * full,
        100 * (jump / high - 1) if jump is not None and high > 0 else None, states, turns, cycle, complete, tuple(warnings),
        _verdict(study, jump, high, states),
    )  # fmt: skip


def _known(study: Study) -> set[str]:
    return set(study.quantities)


def _verdict(study: Study, jump: float | None, high: float, states: tuple[dict[str, Any], ...]) -> str:
    stable = sum(state["stable"] for state in states)
    count = f"there {'is one state' if len(states) == 1 else f'are {len(states)} states'} of sliding in contact, {stable} stable"
    if jump is None or math.isnan(high):
        return f"With the model {study.model} {count}; whether it sprags is not known."
    if math.isnan(jump):
        return f"It does not sprag with the model {study.model}: the state of small deformation never jumps; {count}."
    word = "It sprags" if jump <= high else "It does not sprag"
    return (
        f"{word} with the model {study.model}: the state of small deformation jumps at a friction of {jump:.4g}, and the largest "
        f"that you have is {high:.3g}; {count}."
    )


def _jump(model: Any, p: Any, vary: str, ends: tuple[float, ...], warnings: list[str]) -> float | None:
    """The first jump of the state of small deformation; NaN for none, and None where that is not known."""
    if vary not in model.parameters:
        warnings.append(f"the model has no {vary}: a jump along it is not defined")
        return None
    try:
        found = model.quasi_static_path(p, vary, list(ends))
    except SpragsymError as reason:
        warnings.append(f"the jump along {vary} is not known: {reason}")
        return None
    return next((float(jump.value) for jump in found.jumps), math.nan)


def _current(model: Any, p: Any, warnings: list[str]) -> dict[str, float] | None:
    """The coordinates of the state that is reached as the friction rises from 0; without μ₀, of the only one if there is one."""
    if "mu0" in model.parameters and float(p.mu0) > 0:
        try:
            found = model.quasi_static_path(p, "mu0", [0.0, float(p.mu0)])
        except SpragsymError as reason:
            warnings.append(f"which state the brake is in is not known: {reason}")
            return None
        return {name: float(found.coordinates[name][-1]) for name in model.coordinates}
    eq = model.equilibria(p)
    if int(eq.count) != 1:
        warnings.append("which of the states the brake is in is not known: the model has no mu0 that could rise from 0")
        return None
    return {name: float(eq.coordinates[name][0]) for name in model.coordinates}


def _cusp(model: Any, p: Any, warnings: list[str]) -> float | None:
    if not {"theta0", "mu0"} <= set(model.parameters):
        return None
    try:
        found = model.cusps(p)
    except SpragsymError as reason:
        warnings.append(f"cusps are not known: {reason}")
        return None
    positive = np.asarray(found.values["mu0"])
    positive = positive[positive > 0]
    if not positive.size:
        warnings.append("no cusp was found with this model")
        return None
    warnings.append("mu_cusp is the lowest cusp that was found; that nothing jumps below it is not proved for this model")
    return float(positive.min())


def _oscillation(model: Any, p: Any, scales: Mapping[str, float], warnings: list[str]) -> dict[str, Any] | None:
    """The cycle that the motion comes to from rest or from far out, if there is one."""
    size = len(model.coordinates)
    reason: Exception | None = None
    for word, start in (("rest", [0.0] * (2 * size)), ("far out", [1.5, 0.5, *[0.0] * (2 * size - 2)][: 2 * size])):
        try:
            found = model.cycle(p, near=start, patient=False)
        except (ConvergenceError, SpragsymError) as error:
            reason = reason or error
            continue
        return {
            "kind": "cycle", "stable": bool(found.stable), "frequency_hz": 1 / (float(found.period) * scales["time"]),
            "amplitude_mm": float(found.amplitude) * 1e3 * scales["length"], "start": word,
        }  # fmt: skip
    warnings.append(f"no oscillation was found: {reason}")
    return None


def _folds(model: Any, p: Any) -> tuple[tuple[float, ...], bool]:
    if "mu0" not in model.parameters:
        return (), False
    try:
        found = model.folds(p, "mu0")
    except SpragsymError:
        return (), False
    return tuple(sorted(float(value) for value in found.values["mu0"])), bool(found.complete)
