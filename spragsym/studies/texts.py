"""A report in words: the verdict, the text and JSON."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from ..statics.points import Points
from .facts import Facts
from .redesigns import Change
from .states import State
from .study import Study
from .tolerances import Chance
from .units import ENDS

#: Sobol' indices whose 95 % interval is wider to either side are not told.
RESOLVED = 0.2

if TYPE_CHECKING:
    from .reports import Report


def verdict(study: Study, parts: Mapping[str, Any]) -> str:
    """One sentence: whether it sprags, at what friction, and how far that is."""
    so: Facts = parts["facts"]
    (low, _, high), full, jump = so.working, so.full[2], so.jump
    angle = study.shown("theta0", study.values["theta0"])
    if so.reach in ("never", "beyond"):
        if so.reach == "never":
            what = "has no jump at any friction" if math.isinf(parts["mu_lowest"]) else "has no jump at this angle"
        else:
            above = f", {100 * (jump / full - 1):.0f} % above the largest that you have, {full:.3g}" if full > 0 else ""
            what = f"jumps at a friction of {jump:.4g}{above}"
        begin = "As drawn it does not sprag" if so.within == "refuted" or so.hits else "It does not sprag"
        return f"{begin}: at {angle} the state of small deformation {what}{_within(study, parts)}."
    if so.reach == "faster":
        speed = study.shown("V", study.values["V"], 3)
        return (
            f"It sprags above V = {study.shown('V', so.speed, 3)}: at {angle} the state of small deformation jumps at a friction "
            f"of {jump:.4g}; at {speed} only {high:.3g} of your {full:.3g} works, and it does not jump{_within(study, parts)}."
        )
    friction = f"{low:.3g} to {high:.3g}" if high > low else f"{high:.3g}"
    where = "below your" if high == low else "already below all of your range of" if jump < low else "within your range of"
    return (
        f"It sprags: at {angle} the state of small deformation jumps at a friction of {jump:.4g}, {where} friction {friction}"
        f"{_within(study, parts)}."
    )


def _within(study: Study, parts: Mapping[str, Any]) -> str:
    """What follows within the tolerances, at the belt's speed."""
    so: Facts = parts["facts"]
    odds: Chance | None = parts["probability"]
    speed = " at this speed" if so.reach == "faster" else ""
    if so.within == "proved" and not study.tolerances:
        return f"; proved{speed}"
    if so.within == "proved":
        return f"; proved{speed} for everything within {box(so.unbounded)}"
    if odds is None:
        return "; a proof was not found" if so.within == "undecided" else ""
    but = "; within" if so.reach in ("within", "jumped") else "; but within"
    if so.within == "refuted":
        also = "" if so.hits else ", and at least one does"
        return f"{but} the tolerances{speed} {share(odds)} of all brakes do{also}"
    if so.hits:
        return f"{but} the tolerances{speed} {share(odds)} of all brakes do"
    return f"; of {odds.n} brakes within the tolerances none does, and a proof for all of them was not found"


def box(unbounded: Sequence[str]) -> str:
    """What a certificate is about, if a part of the distribution of some quantities lies beyond it."""
    beyond = f", and {ENDS:g} standard deviations of {' and '.join(unbounded)}" if unbounded else ""
    return f"the tolerances{beyond}"


def share(odds: Chance) -> str:
    """The share of all brakes that jump, which a sample without one, or with nothing else, only bounds."""
    if odds.probability == 0:
        return f"fewer than {_percent(odds.high)}"
    return _percent(odds.probability) if odds.probability < 1 else f"more than {_percent(odds.low)}"


def _percent(number: float) -> str:
    """A share in percent with three digits, or as many as tell it from all or nothing."""
    text = f"{100 * number:.3g}"
    return f"{100 * number:.6g} %" if text == "100" and number < 1 else f"{text} %"


# ------------------------------------------------------------------------------------------------------------------ text


def as_text(report: Report) -> str:
    """The verdict, then numbers under headings."""
    blocks = [[report.verdict]]
    if report.warnings:
        blocks.append([f"warning: {one}" for one in report.warnings])
    for title, rows in sections(report):
        body = lines(rows, 32)
        if body:
            blocks.append([title, *body])
    return "\n\n".join("\n".join(block) for block in blocks)


def lines(rows: Iterable[tuple[str, str]], width: int) -> list[str]:
    """Rows of a name and a value, under each other where the name is long."""
    return [f"  {name:<{width}}{value}" if len(name) < width else f"  {name}\n  {'':<{width}}{value}" for name, value in rows]


def sections(report: Report) -> Iterator[tuple[str, list[tuple[str, str]]]]:
    """Headings, each with rows of a name and a value."""
    for title, rows in (
        ("Jump", _jump(report)), ("The jump as a motion", _peak(report)), ("State", _state(report)), ("Folds", _folds(report)),
        ("Tolerances", _tolerances(report)),
        ("Oscillation", _oscillation(report)), (_aim(report), _changes(report)),
    ):  # fmt: skip
        yield title, list(rows)


def _jump(report: Report) -> Iterator[tuple[str, str]]:
    study, so = report.study, report.facts
    low, working, high = so.working
    yield ("friction at the belt's speed", f"{working:.4g}" + (f", {low:.4g} to {high:.4g}" if high > low else ""))
    if so.slow:
        yield ("friction at full slip", f"{so.full[1]:.4g}" + (f", up to {so.full[2]:.4g}" if so.full[2] > so.full[1] else ""))
    yield ("jump at this angle", "never" if math.isnan(report.mu_jump) else f"at friction {report.mu_jump:.6g}")
    if not math.isnan(report.mu_jump) and high > 0:
        yield ("margin to the largest friction", f"{report.margin_percent:+.1f} %")
        if so.slow:
            yield ("the same at full slip", f"{100 * (report.mu_jump / so.full[2] - 1):+.1f} %")
    if study.moves:
        begins = "at no speed" if math.isnan(so.speed) else f"{study.shown('V', so.speed)}, with the largest friction"
        yield ("speed at which it begins to jump", begins)
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
    here = "the state it jumped to" if report.facts.jumped else "the state of small deformation"
    return here if state.current else "another state"


def _described(state: State) -> str:
    word = "stable" if state.stable else f"unstable ({state.statics})"
    if state.settles is None:
        word = "stable without damping, and whether it settles is up to the damping of the real brake"
    elif not state.stable and state.statics == "stable":
        word = "unstable by the friction law's own damping"
    return f"{word}; spring at {state.direction_deg:.4g} deg, x = {state.x_mm:.4g} mm"


def _peak(report: Report) -> Iterator[tuple[str, str]]:
    found = report.peak
    if found is None:
        return
    places = f"from x = {found.from_mm:.4g} mm to {found.to_mm:.4g} mm"
    yield ("the states before and after", f"at friction {found.friction:.4g}, {places}")
    yield ("range of x", f"{found.x_mm[0]:.4g} mm to {found.x_mm[1]:.4g} mm")
    yield ("range of y", f"{found.y_mm[0]:.4g} mm to {found.y_mm[1]:.4g} mm")
    for name, ends in (("force of the spring", found.spring_force_N), ("force of the contact", found.contact_force_N)):
        yield (name, f"{ends[0]:.5g} N to {ends[1]:.5g} N")
    ends_in = {
        "rest": "it settles at rest", "cycle": "it goes over into an oscillation", "lift-off": "it lifts off for good",
        "unsettled": f"it still swings after {found.seconds:.3g} s",
    }  # fmt: skip
    yield ("then", ends_in[found.settles])


def fold_rows(found: Points, scale: float = 1.0) -> list[dict[str, Any]]:
    """Each fold: where, which state ends there, when, and where that jumps to."""
    (vary,) = found.vary
    value, rows = getattr(found, vary), []
    for i in range(value.size):
        at = math.degrees(value[i]) if vary == "theta0" else float(value[i])
        rows.append({
            "theta0_deg" if vary == "theta0" else vary: at, "kind": str(found.kind[i]), "ends": str(found.ends[i]),
            "when": str(found.when[i]), "theta_deg": math.degrees(found.theta[i]), "x": scale * float(found.x[i]),
            "theta_after_deg": math.degrees(found.after["theta"][i]), "x_after": scale * float(found.after["x"][i]),
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
    reached, odds, so = report.certificate, report.probability, report.facts
    if reached is not None:
        yield (no_jump(so.unbounded), reached.outcome)
        if reached.counterexample:
            wide = [name for name in reached.counterexample if name in report.study.tolerances]
            values = ", ".join(f"{name} = {report.study.shown(name, reached.counterexample[name])}" for name in wide)
            yield ("a brake within them that jumps", values or "the brake itself")
    if odds is not None and so.within == "proved" and not so.unbounded:
        yield ("probability of a jump", "0, as is proved")
        yield from _indices(odds)
    else:
        yield from chance_rows(odds, ", and at least one brake" if _one_corner(so) else "")


def no_jump(unbounded: Sequence[str]) -> str:
    """The claim of a certificate, as a row's name."""
    return f"no jump within {box(unbounded)}" if unbounded else "no jump within all of them"


def chance_rows(odds: Chance | None, more: str = "") -> Iterator[tuple[str, str]]:
    """The probability with its interval, and what decides."""
    if odds is not None:
        ends = f"{_percent(odds.low)} to {_percent(odds.high)} with confidence {odds.confidence:g}"
        yield ("probability of a jump", f"{share(odds)}, {ends}{more}")
        yield from _indices(odds)


def _indices(odds: Chance) -> Iterator[tuple[str, str]]:
    """Sobol' indices, where the samples resolve all of them: next to a certainty too few differ."""
    told = {name: indices for name, indices in odds.sobol.items() if not math.isnan(indices[1])}
    if any(not error <= RESOLVED for *_, error in told.values()):
        yield ("how much each of them decides", f"not told by {odds.n} samples, of which too few differ")
        return
    for name, (first, total, _) in told.items():
        shares = f"{100 * first:.0f} % by itself, {100 * total:.0f} % with what it does together with others"
        yield (f"how much {name} decides", shares)


def _one_corner(so: Facts) -> bool:
    return so.within == "refuted" and so.hits is False


def _oscillation(report: Report) -> Iterator[tuple[str, str]]:
    found = report.oscillation
    if found is None:
        return
    if found.start != "rest":
        yield ("from rest", "no cycle was reached in the time that was looked at")
    what = {
        "cycle": "a cycle, stable", "motion": "a motion that has not repeated itself", "rest": "none: it decays to rest",
        "falls": "none was found: the motion became smaller and smaller, and was not followed to its end",
        "lift-off": "none: it lifts off the belt for good",
    }  # fmt: skip
    yield ("from rest" if found.start == "rest" else "from far out", what[found.kind])
    if not found.alive:
        return
    if found.kind == "cycle":
        yield ("frequency", f"{found.frequency_hz:.5g} Hz")
    yield ("amplitude along the belt", f"{found.amplitude_mm:.4g} mm")
    for name, ends in (("force of the spring", found.spring_force_N), ("force of the contact", found.contact_force_N)):
        yield (name, f"{ends[0]:.5g} N to {ends[1]:.5g} N")
    yield ("lifts off the belt", "yes" if found.lifts_off else "no")
    beside = {True: "yes", False: "no", None: "up to the damping of the real brake"}[found.coexists]
    yield ("coexists with stable sliding", beside)


def _aim(report: Report) -> str:
    faster = report.facts.reach == "faster"
    largest = report.facts.full[2] if faster else report.facts.working[2]
    factor = f" = {report.target / largest:.3g} x {largest:.4g}" if largest > 0 else ""
    where = " at full slip" if faster else ""
    return f"To keep the jump at {report.target:.4g}{factor}, and all within the tolerances from jumping{where}, change"


def _changes(report: Report) -> Iterator[tuple[str, str]]:
    if report.needed and not report.redesign:
        yield "nothing", "no change of one quantity or of several was found that does it"
    yield from change_rows(report.study, report.redesign, box(report.facts.unbounded))


def change_rows(
    study: Study, changes: Iterable[Change], within: str, never: str = "then it never jumps"
) -> Iterator[tuple[str, str]]:
    """What changes, and what is known of it; ``within`` is what a certificate covers, and ``never`` the words for no jump."""
    for one in changes:
        values = "; ".join(
            f"{name} from {study.shown(name, one.before[name])} to {study.shown(name, one.after[name])}" for name in one.after
        )
        then = never if math.isnan(one.mu_jump) else f"then it jumps at {one.mu_jump:.4g}"
        known = "undecided within the tolerances: of the brakes that were tried none jumps"
        if one.outcome == "proved":
            known = f"proved for everything within {within}"
        yield values, f"{then}; {known}"


# ------------------------------------------------------------------------------------------------------------------ JSON


def as_json(report: Report) -> dict[str, Any]:
    """The keys of the report; numbers that don't exist are NaN, which the command writes as null."""
    state, lives, odds = report.current, report.oscillation, report.probability
    alive = lives if lives is not None and lives.alive else None
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
            "kind": lives.kind, "stable": lives.kind == "cycle", "frequency_hz": lives.frequency_hz,
            "amplitude_mm": lives.amplitude_mm, "start": lives.start, "lifts_off": lives.lifts_off,
            "coexists_with_stable_sliding": lives.coexists, "remark": lives.remark,
        },
        "certificate": _certificate_json(report),
        **chance_json(odds),
        "redesign": [change_json(report.study, report.target, one) for one in report.redesign],
        "warnings": list(report.warnings),
        "reach": report.facts.reach, "speed_jump": _speed_json(report),
        "jump": None if report.peak is None else asdict(report.peak),
    }  # fmt: skip


def chance_json(odds: Chance | None) -> dict[str, Any]:
    """The keys of the probability and of what decides; None where nothing varies."""
    return {
        "probability": None if odds is None else {
            "value": odds.probability, "low": odds.low, "high": odds.high, "confidence": odds.confidence, "n": odds.n,
        },
        "sobol": None if odds is None else {
            name: {"first": first, "total": total, "total_error": error} for name, (first, total, error) in odds.sobol.items()
        },
    }  # fmt: skip


def _state_json(state: State) -> dict[str, Any]:
    return {
        "current": state.current, "stable": state.stable, "settles": state.settles, "statics": state.statics,
        "direction_deg": state.direction_deg,
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


def change_json(study: Study, target: float, one: Change) -> dict[str, Any]:
    """The keys of a change."""
    return {
        "from": _in_file(study, one.before), "to": _in_file(study, one.after), "mu_jump": one.mu_jump,
        "target": target, "distance": one.distance, "probability": one.probability, "outcome": one.outcome,
    }  # fmt: skip


def _speed_json(report: Report) -> dict[str, Any] | None:
    return None if math.isnan(report.facts.speed) else _in_file(report.study, {"V": report.facts.speed})["V"]
