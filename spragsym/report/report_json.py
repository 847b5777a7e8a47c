"""A report as JSON has it: numbers, texts, lists and dictionaries, quantities in the units of the file."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from . import rises
from .fold_rows import FoldRow, fold_rows
from .jump_verdicts import Chance
from .jumps import JumpPeak
from .redesigns import Change
from .states import State
from .study import Study

if TYPE_CHECKING:
    from .reports import Report


def as_json(report: Report) -> dict[str, Any]:
    """The keys of the report; numbers that don't exist are NaN, which the command writes as null."""
    state, lives, odds = report.current, report.oscillation, report.probability
    alive = lives if lives is not None and lives.alive else None

    def both(name: str) -> dict[str, Any]:
        return {"rest": getattr(state, name, None), "oscillation": getattr(alive, name, None)}

    lengths = None if state is None else [value for key, value in state.places.items() if key.endswith("_mm")]
    return {
        "mu_jump": report.mu_jump,
        "theta0_jump_deg": report.theta0_jump_deg,
        "mu0_jump": report.mu0_jump,
        "mu_lowest": report.mu_lowest,
        "theta0_lowest_deg": report.theta0_lowest_deg,
        "kind_lowest": report.kind_lowest or None,
        "mu_cusp": report.mu_cusp,
        "mu_effective": report.mu_effective,
        "margin_percent": report.margin_percent,
        "states": [_state_json(one) for one in report.states],
        "frequencies_hz": None if state is None else list(state.frequencies_hz),
        "spring_force_N": both("spring_force_N"),
        "contact_force_N": both("contact_force_N"),
        "displacement_mm": {"rest": lengths or None, "oscillation_amplitude": None if alive is None else alive.amplitude_mm},
        "oscillation": None if lives is None else {
            "kind": lives.kind, "stable": lives.kind == "cycle", "frequency_hz": lives.frequency_hz,
            f"amplitude_{lives.unit}": lives.amplitude, "start": lives.start, "lifts_off": lives.lifts_off,
            "coexists_with_stable_sliding": lives.coexists,
        },
        "certificate": _certificate_json(report),
        **_chance_json(odds),
        "redesign": [_change_json(report, one) for one in report.redesign],
        "warnings": list(report.warnings),
        "reach": report.facts.reach or None, "speed_jump": _speed_json(report),
        "jump": None if report.peak is None else _peak_json(report, report.peak),
        "verdict": report.verdict, "folds": [_fold_json(report, row) for row in fold_rows(report)],
        "vary": report.vary, "jump_at": _told(report, report.jump_at),
        "other_states": [place | {"ends_at": _told(report, end)} for place, end in report.others],
    }  # fmt: skip


def _chance_json(odds: Chance | None) -> dict[str, Any]:
    """The keys of the probability and of what decides; None where nothing varies."""
    return {
        "probability": None if odds is None else {
            "value": odds.probability, "low": odds.low, "high": odds.high, "confidence": odds.confidence, "n": odds.n,
            "proved": None if odds.proved == (0.0, 1.0) else list(odds.proved),
        },
        "sobol": None if odds is None else {
            name: {"first": first, "total": total, "total_error": error} for name, (first, total, error) in odds.sobol.items()
        },
    }  # fmt: skip


def _state_json(state: State) -> dict[str, Any]:
    return {
        "current": state.current, "stable": state.stable, "settles": state.settles, "statics": state.statics,
        "direction_deg": state.direction_deg, **state.places, "spring_length_mm": state.spring_length_mm,
        "spring_force_N": state.spring_force_N,
        "contact_force_N": state.contact_force_N, "frequencies_hz": list(state.frequencies_hz),
        "damping_ratio": list(state.damping_ratio), "growth_per_s": state.growth_per_s,
    }  # fmt: skip


def _told(report: Report, value: float | None) -> dict[str, Any] | None:
    """A value of what rises, in the unit of the file; friction as a number."""
    if value is None or report.vary is None:
        return None
    rise = rises.of(report.study)
    return {"value": value, "unit": ""} if rise.is_friction else _in_file(report.study, {rise.quantity: value})[rise.quantity]


def _of_friction(report: Report, value: float) -> float | None:
    """A value of what rises, if that is the friction."""
    return value if report.study.rise is not None and report.study.rise.is_friction else None


def _peak_json(report: Report, peak: JumpPeak) -> dict[str, Any]:
    first = next(iter(peak.before))
    unit = first.rpartition("_")[2]
    return {
        "friction": _of_friction(report, peak.at), "at": _told(report, peak.at),
        f"from_{unit}": peak.before[first], f"to_{unit}": peak.after[first], **peak.ranges,
        "spring_force_N": peak.spring_force_N, "contact_force_N": peak.contact_force_N, "lifts_off": peak.lifts_off,
        "settles": peak.settles, "followed_s": peak.followed_s,
    }  # fmt: skip


def _fold_json(report: Report, row: FoldRow) -> dict[str, Any]:
    return {**asdict(row), "value": _told(report, row.value), "ends": row.ends or None, "when": row.when or None}


def _in_file(study: Study, values: Mapping[str, float]) -> dict[str, Any]:
    units = {name: study.quantities[name].unit for name in values}
    return {name: {"value": study.in_file(name, value), "unit": units[name]} for name, value in values.items()}


def _certificate_json(report: Report) -> dict[str, Any] | None:
    reached = report.certificate
    if reached is None:
        return None
    example = reached.counterexample
    return {
        "claim": reached.claim, "outcome": reached.outcome, "undecided": reached.undecided, "boxes": reached.boxes,
        "counterexample": None if example is None else _in_file(report.study, example),
    }  # fmt: skip


def _change_json(report: Report, one: Change) -> dict[str, Any]:
    study = report.study
    return {
        "from": _in_file(study, one.before), "to": _in_file(study, one.after), "jump_at": _told(report, one.jump_at),
        "mu_jump": _of_friction(report, one.jump_at), "target": (_told(report, report.target) or {})["value"],
        "distance": one.distance, "probability": one.probability, "outcome": one.outcome,
    }  # fmt: skip


def _speed_json(report: Report) -> dict[str, Any] | None:
    belt = report.study.belt
    return None if belt is None or math.isnan(report.facts.speed) else _in_file(report.study, {belt: report.facts.speed})[belt]
