"""A report in words: the verdict, the text and JSON."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from ..catastrophe.fold_points import Folds
from .redesigns import Change
from .states import State
from .study import Study

if TYPE_CHECKING:
    from .reports import Report


def verdict(study: Study, parts: Mapping[str, Any]) -> str:
    """One sentence: whether it sprags, at what friction, and how far that is."""
    low, _, high = study.friction
    jump, lowest = parts["mu_jump"], parts["mu_lowest"]
    angle = study.shown("theta0", study.values["theta0"])
    friction = f"{low:.3g} to {high:.3g}" if high > low else f"{high:.3g}"
    if not jump <= high:
        odds = parts["probability"]
        begin = "As drawn it does not sprag" if odds is not None and odds.probability > 0 else "It does not sprag"
        if math.isnan(jump):
            what = "has no jump at any friction" if math.isinf(lowest) else "has no jump at this angle"
        else:
            above = f", {parts['margin_percent']:.0f} % above the largest that you have, {high:.3g}" if high > 0 else ""
            what = f"jumps at a friction of {jump:.4g}{above}"
        return f"{begin}: at {angle} the state of small deformation {what}{_within(parts, jumps=False)}."
    where = "below your" if high == low else "already below all of your range of" if jump < low else "within your range of"
    return (
        f"It sprags: at {angle} the state of small deformation jumps at a friction of {jump:.4g}, {where} friction {friction}"
        f"{_within(parts)}."
    )


def _within(parts: Mapping[str, Any], jumps: bool = True) -> str:
    """What follows within the tolerances."""
    reached, odds = parts["certificate"], parts["probability"]
    if reached is None:
        return ""
    if reached.outcome == "proved":
        return "; proved for everything within the tolerances"
    if odds is None:
        return ""
    but = "; within" if jumps or not odds.probability else "; but within"
    share = f"{but} the tolerances {_percent(odds.probability)} of all brakes do"
    return share if reached.outcome == "refuted" else f"{share}, and a proof for all of them was not found"


def _percent(share: float) -> str:
    return f"{100 * share:.3g} %"


# ------------------------------------------------------------------------------------------------------------------ text


def as_text(report: Report) -> str:
    """The verdict, then numbers under headings."""
    blocks = [[report.verdict]]
    if report.warnings:
        blocks.append([f"warning: {one}" for one in report.warnings])
    for title, rows in sections(report):
        body = [f"  {name:<32}{value}" if len(name) < 32 else f"  {name}\n  {'':<32}{value}" for name, value in rows]
        if body:
            blocks.append([title, *body])
    return "\n\n".join("\n".join(block) for block in blocks)


def sections(report: Report) -> Iterator[tuple[str, list[tuple[str, str]]]]:
    """Headings, each with rows of a name and a value."""
    for title, rows in (
        ("Jump", _jump(report)), ("State", _state(report)), ("Folds", _folds(report)), ("Tolerances", _tolerances(report)),
        ("Oscillation", _oscillation(report)), (_aim(report), _changes(report)),
    ):  # fmt: skip
        yield title, list(rows)


def _jump(report: Report) -> Iterator[tuple[str, str]]:
    study = report.study
    low, working, high = study.friction
    yield ("friction at the belt's speed", f"{working:.4g}" + (f", {low:.4g} to {high:.4g}" if high > low else ""))
    yield ("jump at this angle", "never" if math.isnan(report.mu_jump) else f"at friction {report.mu_jump:.6g}")
    if not math.isnan(report.mu_jump) and high > 0:
        yield ("margin to the largest friction", f"{report.margin_percent:+.1f} %")
    at = "never" if math.isnan(report.theta0_jump_deg) else f"at {report.theta0_jump_deg:.6g} deg"
    yield ("jump at this friction", at)
    lowest = f"friction {report.mu_lowest:.6g}, a {report.kind_lowest} at {report.theta0_lowest_deg:.6g} deg"
    yield ("lowest fold of all angles", f"{lowest}; below it it jumps at no angle" if report.kind_lowest else "there is none")
    yield ("friction of the cusp", "there is none" if math.isinf(report.mu_cusp) else f"{report.mu_cusp:.6g}")
    if not math.isnan(report.distance):
        where = "0, it has jumped already" if report.distance == 0 else "none found" if math.isinf(report.distance) else (
            f"{report.distance:.3g}, as the root of the sum of squares"
        )  # fmt: skip
        yield ("tolerances to the nearest jump", where)


def _state(report: Report) -> Iterator[tuple[str, str]]:
    for state in report.states:
        yield (_name(report, state), _described(state))
    state = report.current
    yield ("place along and across the belt", f"{state.x_mm:.4g} mm, {state.y_mm:.4g} mm")
    yield ("force of the spring", f"{state.spring_force_N:.5g} N" + (", it pushes" if state.spring_force_N < 0 else ", it pulls"))
    yield ("force of the contact", f"{state.contact_force_N:.5g} N")
    ratios = state.damping_ratio
    yield ("frequencies", ", ".join(
        f"{f:.4g} Hz (damping ratio {ratio:.2g})" if report.study.moves else f"{f:.4g} Hz"
        for f, ratio in zip(state.frequencies_hz, ratios, strict=True)
    ) or "none")  # fmt: skip


def _name(report: Report, state: State) -> str:
    jumped = not math.isnan(report.mu_jump) and report.mu_jump <= report.mu_effective
    here = "the state it jumped to" if jumped else "the state of small deformation"
    return f"{here}" if state.current else "another state"


def _described(state: State) -> str:
    word = "stable" if state.stable else "unstable" if state.statics == "stable" else f"unstable ({state.statics})"
    return f"{word}, spring at {state.direction_deg:.4g} deg, x = {state.x_mm:.4g} mm"


def fold_rows(found: Folds, scale: float = 1.0) -> list[dict[str, Any]]:
    """Each fold: where, which state ends there, when, and where that jumps to."""
    value = getattr(found, found.vary)
    rows = []
    for i in range(value.size):
        at = math.degrees(value[i]) if found.vary == "theta0" else float(value[i])
        rows.append({
            "theta0_deg" if found.vary == "theta0" else found.vary: at, "kind": str(found.kind[i]), "ends": str(found.ends[i]),
            "when": str(found.when[i]), "theta_deg": math.degrees(found.theta[i]), "x": scale * float(found.x[i]),
            "theta_after_deg": math.degrees(found.theta_after[i]), "x_after": scale * float(found.x_after[i]),
        })  # fmt: skip
    return rows


def _folds(report: Report) -> Iterator[tuple[str, str]]:
    unit = 1e3 * report.study.scales.length
    for vary, word in (("mu0", "friction"), ("theta0", "inclination")):
        for row in fold_rows(report.folds[vary], unit):
            at = row["theta0_deg"] if vary == "theta0" else row[vary]
            name = f"{word} {at:.5g}{' deg' if vary == 'theta0' else ''}"
            if row["kind"] != "fold":
                yield (name, f"a {row['kind']}")
                continue
            way = "rises" if row["when"] == "up" else "falls"
            yield (name, f"the {row['ends']} state ends as it {way}; x goes from {row['x']:.4g} mm to {row['x_after']:.4g} mm")


def _tolerances(report: Report) -> Iterator[tuple[str, str]]:
    reached, odds = report.certificate, report.probability
    if reached is not None:
        yield ("no jump within all of them", reached.outcome)
        if reached.counterexample:
            wide = [name for name in reached.counterexample if name in report.study.tolerances]
            values = ", ".join(f"{name} = {report.study.shown(name, reached.counterexample[name])}" for name in wide)
            yield ("a brake within them that jumps", values or "the brake itself")
    if odds is not None:
        ends = f"{_percent(odds.low)} to {_percent(odds.high)} with confidence {odds.confidence:g}"
        yield ("probability of a jump", f"{_percent(odds.probability)}, {ends}")
        for name, (first, total, _) in odds.sobol.items():
            if not math.isnan(total):
                shares = f"{100 * first:.0f} % by itself, {100 * total:.0f} % with what it does together with others"
                yield (f"how much {name} decides", shares)


def _oscillation(report: Report) -> Iterator[tuple[str, str]]:
    found = report.oscillation
    if found is None:
        return
    word = {"cycle": "a cycle", "motion": "a motion that has not repeated itself", "none": "none: it comes to rest"}[found.kind]
    if found.start != "rest":
        yield ("from rest", "no cycle was reached in the time that was looked at")
    beginning = "from rest" if found.start == "rest" else "from far out"
    yield (beginning, word + ("" if found.kind != "cycle" else ", stable" if found.stable else ", unstable"))
    if found.kind == "none":
        return
    if found.kind == "cycle":
        yield ("frequency", f"{found.frequency_hz:.5g} Hz")
    yield ("amplitude along the belt", f"{found.amplitude_mm:.4g} mm")
    for name, ends in (("force of the spring", found.spring_force_N), ("force of the contact", found.contact_force_N)):
        yield (name, f"{ends[0]:.5g} N to {ends[1]:.5g} N")
    yield ("lifts off the belt", "yes" if found.lifts_off else "no")
    yield ("lives beside sliding that is stable", "yes" if found.coexists else "not shown")


def _aim(report: Report) -> str:
    largest = report.study.friction[2]
    factor = f" = {report.target / largest:.3g} x {largest:.3g}" if largest > 0 else ""
    return f"To keep the jump at {report.target:.3g}{factor}, and all within the tolerances from jumping, change"


def _changes(report: Report) -> Iterator[tuple[str, str]]:
    for one in report.redesign:
        values = "; ".join(
            f"{name} from {report.study.shown(name, one.before[name])} to {report.study.shown(name, one.after[name])}"
            for name in one.after
        )
        then = "then it never jumps" if math.isnan(one.mu_jump) else f"then it jumps at {one.mu_jump:.4g}"
        yield values, then + ("" if math.isnan(one.probability) else f"; within the tolerances {_percent(one.probability)} do")


# ------------------------------------------------------------------------------------------------------------------ JSON


def as_json(report: Report) -> dict[str, Any]:
    """The keys of the report; numbers that don't exist are NaN, which the command writes as null."""
    state, lives, odds = report.current, report.oscillation, report.probability
    alive = None if lives is None or lives.kind == "none" else lives
    return {
        "mu_jump": report.mu_jump,
        "theta0_jump_deg": report.theta0_jump_deg,
        "mu_lowest": report.mu_lowest,
        "theta0_lowest_deg": report.theta0_lowest_deg,
        "kind_lowest": report.kind_lowest or None,
        "mu_cusp": report.mu_cusp,
        "mu_effective": report.mu_effective,
        "margin_percent": report.margin_percent,
        "states": [_state_json(one) for one in report.states],
        "frequencies_hz": list(state.frequencies_hz),
        "spring_force_N": {"rest": state.spring_force_N, "oscillation": None if alive is None else list(alive.spring_force_N)},
        "contact_force_N": {"rest": state.contact_force_N, "oscillation": None if alive is None else list(alive.contact_force_N)},
        "displacement_mm": {
            "rest": [state.x_mm, state.y_mm], "oscillation_amplitude": None if alive is None else alive.amplitude_mm,
        },
        "oscillation": None if lives is None else {
            "kind": lives.kind, "stable": lives.stable, "frequency_hz": lives.frequency_hz, "amplitude_mm": lives.amplitude_mm,
            "start": lives.start, "lifts_off": lives.lifts_off, "coexists_with_stable_sliding": lives.coexists,
            "remark": lives.remark,
        },
        "certificate": _certificate_json(report),
        "probability": None if odds is None else {
            "value": odds.probability, "low": odds.low, "high": odds.high, "confidence": odds.confidence, "n": odds.n,
        },
        "sobol": None if odds is None else {
            name: {"first": first, "total": total, "total_error": error} for name, (first, total, error) in odds.sobol.items()
        },
        "redesign": [_change_json(report, one) for one in report.redesign],
        "warnings": list(report.warnings),
    }  # fmt: skip


def _state_json(state: State) -> dict[str, Any]:
    return {
        "current": state.current, "stable": state.stable, "statics": state.statics, "direction_deg": state.direction_deg,
        "x_mm": state.x_mm, "y_mm": state.y_mm, "spring_length_mm": state.spring_length_mm,
        "spring_force_N": state.spring_force_N,
        "contact_force_N": state.contact_force_N, "frequencies_hz": list(state.frequencies_hz),
        "damping_ratio": list(state.damping_ratio), "growth_per_s": state.growth_per_s,
    }  # fmt: skip


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
    return {
        "from": _in_file(report.study, one.before), "to": _in_file(report.study, one.after), "mu_jump": one.mu_jump,
        "target": report.target, "distance": one.distance, "probability": one.probability,
    }  # fmt: skip
