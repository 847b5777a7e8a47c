"""A report as JSON has it: numbers, texts, lists and dictionaries, quantities in the units of the file."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .reports import Report

#: Attributes of a report, of a state, and of the jump as a motion that stand in JSON as they are.
_PLAIN = (
    "mu_jump", "theta0_jump_deg", "mu0_jump", "mu_lowest", "theta0_lowest_deg", "kind_lowest", "mu_cusp", "mu_effective",
    "margin_percent",
)  # fmt: skip
_STATE = (
    "current", "stable", "settles", "statics", "direction_deg", "spring_length_mm", "spring_force_N", "contact_force_N",
    "frequencies_hz", "damping_ratio", "growth_per_s",
)  # fmt: skip
_PEAK = ("spring_force_N", "contact_force_N", "lifts_off", "settles", "followed_s")


def as_json(report: Report) -> dict[str, Any]:
    """The keys of the report; numbers that don't exist are NaN, which the command writes as null."""
    study, state, lives, odds, reached = report.study, report.current, report.oscillation, report.probability, report.certificate
    alive = lives if lives is not None and lives.alive else None
    lengths = [value for key, value in state.places.items() if key.endswith("_mm")] if state else None

    def one(name: str, value: float) -> dict[str, Any]:
        return {"value": study.in_file(name, value), "unit": study.quantities[name].unit}

    def all_of(values: Mapping[str, float]) -> dict[str, Any]:
        return {name: one(name, value) for name, value in values.items()}

    def told(value: float | None) -> Any:
        if value is None or report.vary is None:
            return None
        return {"value": value, "unit": ""} if study.of_friction else one(report.vary, value)

    def both(name: str) -> dict[str, Any]:
        return {"rest": getattr(state, name, None), "oscillation": getattr(alive, name, None)}

    def peak() -> dict[str, Any] | None:
        found = report.peak
        if found is None:
            return None
        first = next(iter(found.before))
        unit = first.rpartition("_")[2]
        at = {"friction": found.at if study.of_friction else None, "at": told(found.at)}
        return at | {f"from_{unit}": found.before[first], f"to_{unit}": found.after[first], **found.ranges, **_some(found, _PEAK)}

    return _some(report, _PLAIN) | {
        "states": [{**_some(each, _STATE), **each.places} for each in report.states],
        "frequencies_hz": list(state.frequencies_hz) if state else None,
        "spring_force_N": both("spring_force_N"),
        "contact_force_N": both("contact_force_N"),
        "displacement_mm": {"rest": lengths or None, "oscillation_amplitude": getattr(alive, "amplitude_mm", None)},
        "oscillation": lives and {
            **_some(lives, ("kind", "frequency_hz", "start", "lifts_off")), "stable": lives.kind == "cycle",
            f"amplitude_{lives.unit}": lives.amplitude, "coexists_with_stable_sliding": lives.coexists,
        },
        "certificate": reached and {
            **_some(reached, ("claim", "outcome", "undecided", "boxes")),
            "counterexample": reached.counterexample and all_of(reached.counterexample),
        },
        "probability": odds and {
            "value": odds.probability, **_some(odds, ("low", "high", "confidence", "n")),
            "proved": None if odds.proved == (0.0, 1.0) else list(odds.proved),
        },
        "sobol": odds and {
            name: dict(zip(("first", "total", "total_error"), shares, strict=True)) for name, shares in odds.sobol.items()
        },
        "redesign": [
            {
                "from": all_of(change.before), "to": all_of(change.after), "jump_at": told(change.jump_at),
                "mu_jump": change.jump_at if study.of_friction else None, "target": told(report.target)["value"],
                **_some(change, ("distance", "probability", "outcome")),
            }
            for change in report.redesign
        ],
        "warnings": list(report.warnings),
        "reach": report.reach or None,
        "speed_jump": None if study.belt is None or math.isnan(report.speed) else one(study.belt, report.speed),
        "jump": peak(),
        "verdict": report.verdict,
        "folds": [
            {**vars(row), "value": told(row.value), "ends": row.ends or None, "when": row.when or None}
            for row in report.fold_rows
        ],
        "vary": report.vary,
        "jump_at": told(report.jump_at),
        "other_states": [place | {"ends_at": told(end)} for place, end in report.others],
        "next_steps": list(report.next_steps),
        "about": report.about,
    }  # fmt: skip


def _some(thing: Any, names: tuple[str, ...]) -> dict[str, Any]:
    """Some attributes by name; no word is None."""
    found = {name: getattr(thing, name) for name in names}
    return {name: None if value == "" else list(value) if isinstance(value, tuple) else value for name, value in found.items()}
