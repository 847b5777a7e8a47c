"""The report of a study with another model than the article's: all that its states, folds, paths and cycles answer."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..display import Result
from ..errors import ConvergenceError, SpragsymError
from ..models.load import load
from ..models.points import ranges
from . import other_models
from .model_states import contact_force, model_states, spring_force
from .other_tolerances import tolerated
from .redesigns import Change, changes
from .reports import Tell, teller
from .study import Study
from .texts import box, chance_json, chance_rows, change_json, change_rows, lines, no_jump
from .tolerances import Chance

#: Angles in degrees between which a jump is looked for.
_ANGLES = (0.5, 179.0)
#: Points that a probability is estimated from.
POINTS = 2048
#: What the names of numbers are called in the text.
_WORDS = {
    "statics": "without damping", "x_mm": "x, mm", "y_mm": "y, mm", "spring_force_N": "force of the spring, N",
    "contact_force_N": "force of the contact, N", "frequencies_hz": "frequencies, Hz", "damping_ratio": "damping ratios",
    "growth_per_s": "growth, 1/s", "frequency_hz": "frequency, Hz", "amplitude_mm": "amplitude along the belt, mm",
}  # fmt: skip


@dataclass(frozen=True)
class ModelReport(Result):
    """What can be said of a brake with any model; None where there is no answer, with the reason among ``warnings``.

    Attributes
    ----------
    mu_jump, theta0_jump_deg : float or None
        Friction and angle at which the state of small deformation jumps, followed on a path with proved folds; NaN for never.
    mu_lowest, theta0_lowest_deg : float or None
        The friction below which that state jumps at no angle, and its angle; infinite and NaN where it never does.
    kind_lowest : str or None
        What happens there, see :class:`spragsym.LowestEnd`; empty where it never jumps.
    mu_cusp : float or None
        Friction of the lowest cusp; folds may lie below it.
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
    certificate : dict or None
        Of "no jump" for everything within the tolerances: proved, refuted by a brake within them, or undecided.
    probability : Chance or None
    redesign : tuple of Change or None
        What to change so that the jump lies at ``target`` or beyond, single quantities and the least joint change; None where
        nothing has to, or it was not asked for.
    target : float
    complete : bool
        Whether states and folds are proved to be all there are.
    warnings : tuple of str
    verdict : str
    """

    mu_jump: float | None
    theta0_jump_deg: float | None
    mu_lowest: float | None
    theta0_lowest_deg: float | None
    kind_lowest: str | None
    mu_cusp: float | None
    mu_effective: float
    margin_percent: float | None
    states: tuple[dict[str, Any], ...]
    folds: tuple[float, ...]
    oscillation: dict[str, Any] | None
    certificate: dict[str, Any] | None
    probability: Chance | None
    redesign: tuple[Change, ...] | None
    target: float
    complete: bool
    warnings: tuple[str, ...]
    verdict: str
    study: Study

    def to_dict(self) -> dict[str, Any]:
        """The keys of a report; None for what is not computed for this model."""
        lives = self.oscillation or {}
        here: Mapping[str, Any] = next((state for state in self.states if state["current"]), {})
        return {
            "mu_jump": self.mu_jump, "theta0_jump_deg": self.theta0_jump_deg,
            "mu_lowest": self.mu_lowest, "theta0_lowest_deg": self.theta0_lowest_deg, "kind_lowest": self.kind_lowest,
            "mu_cusp": self.mu_cusp,
            "mu_effective": self.mu_effective, "margin_percent": self.margin_percent, "states": list(self.states),
            "frequencies_hz": here.get("frequencies_hz"),
            "spring_force_N": {"rest": here.get("spring_force_N"), "oscillation": lives.get("spring_force_N")},
            "contact_force_N": {"rest": here.get("contact_force_N"), "oscillation": lives.get("contact_force_N")},
            "displacement_mm": {
                "rest": [here.get("x_mm"), here.get("y_mm")] if here else None,
                "oscillation_amplitude": self.oscillation["amplitude_mm"] if self.oscillation else None,
            },
            "oscillation": self.oscillation, "certificate": self.certificate, **chance_json(self.probability),
            "redesign": [change_json(self.study, self.target, one) for one in self.redesign or ()],
            "warnings": list(self.warnings), "reach": None, "speed_jump": None, "jump": None,
        }  # fmt: skip

    def text(self) -> str:
        """The verdict, the warnings, the numbers and the states."""
        blocks = [self.verdict, *(f"warning: {one}" for one in self.warnings)]
        for heading, rows in self.sections():
            blocks.append("\n".join([heading, *lines(rows, 34)]))
        return "\n\n".join(blocks)

    def sections(self) -> Iterator[tuple[str, list[tuple[str, str]]]]:
        """Headings, each with rows of a name and a value."""
        numbers = {
            "jump at friction": self.mu_jump, "jump at angle, deg": self.theta0_jump_deg,
            "no jump at any angle below": self.mu_lowest, "lowest cusp at friction": self.mu_cusp,
            "friction at the belt's speed": self.mu_effective, "margin to the largest friction, %": self.margin_percent,
        }  # fmt: skip
        if "mu0" in load(self.study.model).parameters:
            yield "Jump", [(name, "unknown" if value is None else _shown(value)) for name, value in numbers.items()]
        for state in self.states:
            heading = "State" if state["current"] else "Another state"
            told = {name: value for name, value in state.items() if name != "current" and value is not None}
            yield heading, [(_WORDS.get(name, name), _shown(value)) for name, value in told.items()]
        if self.certificate:
            rows = [(no_jump(self.study.unbounded), self.certificate["outcome"])]
            for name, one in (self.certificate["counterexample"] or {}).items():
                rows.append((f"a brake that jumps: {name}", f"{one['value']:.5g} {one['unit']}".strip()))
            odds = self.probability
            none = odds is not None and odds.confidence == 1.0
            yield "Tolerances", [*rows, *([("probability of a jump", "0, as is proved")] if none else chance_rows(odds))]
        if self.redesign is not None:
            ((_, top),) = ranges(load(self.study.model), ("mu0",), {})
            never = f"then it jumps at no friction up to {top:g}"
            rows = list(change_rows(self.study, self.redesign, box(self.study.unbounded), never))
            nothing = [("nothing", "no change of one quantity or of several was found that does it")]
            yield f"To keep the jump at {self.target:.4g}, and all within the tolerances from jumping, change", rows or nothing
        if self.oscillation:
            yield "Oscillation", [(_WORDS.get(name, name), _shown(one)) for name, one in self.oscillation.items()]

    def __str__(self) -> str:
        return self.text()


def _shown(value: Any) -> str:
    if isinstance(value, float):
        return "never" if math.isnan(value) else f"{value:.5g}"
    if isinstance(value, dict):
        return ", ".join(f"{name}: {_shown(one)}" for name, one in value.items())
    return "[" + ", ".join(_shown(one) for one in value) + "]" if isinstance(value, list) else str(value)


def model_report(
    study: Study, *, probability: bool = True, redesign: bool = True, oscillation: bool = True, safety: float = 1.2,
    n: int = POINTS, progress: bool = False,
) -> ModelReport:  # fmt: skip
    """All states at the friction that works, where the state of small deformation jumps, and the cycle."""
    tell = teller(progress)
    try:
        return _report(study, probability, redesign, oscillation, safety, n, tell)
    finally:
        tell("")


def _report(study: Study, probability: bool, redesign: bool, oscillation: bool, safety: float, n: int, tell: Tell) -> ModelReport:
    model = load(study.model)
    p, scales = other_models.dimensionless(study.model, study.values)
    warnings: list[str] = []
    law = "friction_at_speed" if "V" in _known(study) else "friction_at_rest"
    full, works = other_models.friction(model, p, "friction_at_rest"), other_models.friction(model, p, law)
    fraction = works / full if full else 1.0
    if "V" in model.parameters and "V" not in _known(study):
        warnings.append("V is not given: friction is taken at full slip, and no oscillation is looked for")
    elif fraction < 0.95:
        warnings.append(f"the belt is so slow that friction works at {100 * fraction:.3g} % of {full:.4g}; check d and V")
    at = p.replace(mu0=fraction * p.mu0) if "mu0" in model.parameters else p
    tell("folds, jumps and states")
    turns, complete = _folds(model, p, warnings)
    jump = _jump(model, p, "mu0", (0.0, 1.1 * max(turns, default=1.0)), warnings)
    angle = _jump(model, at, "theta0", tuple(map(math.radians, _ANGLES)), warnings)
    lowest = _lowest(model, p, warnings)
    high = (
        other_models.friction(model, p.replace(mu0=study.quantities["mu0"].high), law) if "mu0" in study.quantities else math.nan
    )
    current = _current(model, at, warnings)
    states = tuple(model_states(model, at, scales, current))
    eq = model.equilibria(at)
    if not eq.complete:
        warnings.append(f"that these are all states is not proved: {'; '.join(eq.remarks)}")
    moving = oscillation and {"V", "d"} <= _known(study)
    tell("the oscillation (--no-oscillation leaves it out)" if moving else "")
    cycle = _oscillation(model, p, scales, warnings) if moving else None
    tell("the proof for all within the tolerances, and the probability of a jump")
    reached, odds = tolerated(study, n) if probability and "mu0" in model.parameters else (None, None)
    target = safety * high if high > 0 else math.nan
    sprags = jump is not None and (jump < target or (reached is not None and reached["outcome"] == "refuted"))
    tell("what to change (--no-redesign leaves it out)" if redesign else "")
    proposed = changes(study, target) if redesign and sprags else None
    return ModelReport(
        jump, None if angle is None else math.degrees(angle), *lowest, _cusp(model, p, warnings), works,
        100 * (jump / high - 1) if jump is not None and not math.isnan(jump) and high > 0 else None,
        states, turns, cycle, reached, odds, proposed, target, complete, tuple(warnings),
        _verdict(study, model, jump, high, states, complete), study,
    )  # fmt: skip


def _known(study: Study) -> set[str]:
    return set(study.quantities)


def _verdict(
    study: Study, model: Any, jump: float | None, high: float, states: tuple[dict[str, Any], ...], complete: bool
) -> str:
    stable = sum(state["stable"] for state in states)
    about = model.about
    where = " of sliding" if about["friction"] else ""
    where += " in contact" if about["contact"]["gap"] is not None else ""
    count = f"there {'is one state' if len(states) == 1 else f'are {len(states)} states'}{where}, {stable} stable"
    if "mu0" not in model.parameters:
        return f"With the model {study.model} {count}; it has no mu0 along which a jump would be looked for."
    if jump is None or math.isnan(high):
        return f"With the model {study.model} {count}; whether it sprags is not known."
    if math.isnan(jump) and not complete:
        return (
            f"No jump of the state of small deformation was found with the model {study.model}, and that there is none is not "
            f"proved; {count}."
        )
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


def _lowest(model: Any, p: Any, warnings: list[str]) -> tuple[float | None, float | None, str | None]:
    """Friction, angle in degrees and kind of the lowest end over all angles; None where that is not known."""
    if not {"theta0", "mu0"} <= set(model.parameters):
        return None, None, None
    try:
        found = model.critical_friction(p)
    except SpragsymError as reason:
        warnings.append(f"the friction below which it jumps at no angle is not known: {reason}")
        return None, None, None
    if found.kind == "undecided":
        why = "; ".join(found.remarks)
        warnings.append(
            f"below a friction of {found.value:.4g} it jumps at no angle; whether it does above is not decided: {why}"
        )
        return None, None, None
    if not found.complete:
        warnings.append(f"that nothing jumps below mu_lowest is not proved for all: {'; '.join(found.remarks)}")
    return float(found.value), math.degrees(float(found.where)), str(found.kind)


def _cusp(model: Any, p: Any, warnings: list[str]) -> float | None:
    if not {"theta0", "mu0"} <= set(model.parameters):
        return None
    try:
        found = model.cusps(p)
    except SpragsymError as reason:
        warnings.append(f"cusps are not known: {reason}")
        return None
    positive = np.asarray(found.mu0)
    positive = positive[positive > 0]
    if not positive.size:
        warnings.append("no cusp was found with this model")
        return None
    warnings.append("mu_cusp is the lowest cusp that was found; folds may lie below it")
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
        spring, contact = _forces(model, p, found.trajectory(), scales["force"])
        return {
            "kind": "cycle", "stable": bool(found.stable), "frequency_hz": 1 / (float(found.period) * scales["time"]),
            "amplitude_mm": float(found.amplitude) * 1e3 * scales["length"], "spring_force_N": spring, "contact_force_N": contact,
            "start": word, "lifts_off": contact is not None and contact[0] <= 0,
        }  # fmt: skip
    warnings.append(f"no oscillation was found: {reason}")
    return None


def _forces(model: Any, p: Any, motion: Any, unit: float) -> tuple[Any, list[float] | None]:
    """Least and largest force of the spring, or of several by their names, and of the contact over the samples of a motion."""
    places = [
        dict(zip(model.coordinates, column, strict=True)) for column in zip(*motion.state[: len(model.coordinates)], strict=True)
    ]
    springs: list[Any] = [spring_force(model, p, place, unit) for place in places]
    contact = [contact_force(model, p, place, unit) for place in places]
    if springs and isinstance(springs[0], dict):
        return {name: _ends_of([one[name] for one in springs]) for name in springs[0]}, _ends_of(contact)
    return _ends_of(springs), _ends_of(contact)


def _ends_of(values: list[Any]) -> list[float] | None:
    known = [value for value in values if value is not None]
    return [min(known), max(known)] if known else None


def _folds(model: Any, p: Any, warnings: list[str]) -> tuple[tuple[float, ...], bool]:
    """Folds along μ₀, and whether all of them are known up to where they are sought."""
    if "mu0" not in model.parameters:
        return (), False
    try:
        found = model.folds(p, "mu0")
    except SpragsymError as reason:
        warnings.append(f"folds along mu0 are not known: {reason}")
        return (), False
    if not found.complete:
        warnings.append(f"that these are all folds along mu0 is not proved: {'; '.join(found.remarks)}")
    return tuple(sorted(float(value) for value in found.mu0)), found.decided and found.whole
