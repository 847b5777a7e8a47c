"""Advice that follows from the facts of a report: warnings where an answer would mislead, and at
most five next steps.
"""

from __future__ import annotations

import math
import shlex
from collections.abc import Iterator, Sequence
from typing import TypeAlias

from .damping import remedy
from .example import example_of
from .facts import FRICTION, Facts
from .redesigns import Change
from .states import State, comes_from_near, is_negligible
from .study import Study
from .tolerances import deciding
from .units import hertz

#: Pairs of texts: a name and a value, or a picture and its caption.
Rows: TypeAlias = Iterator[tuple[str, str]]


def warnings(report: Facts) -> tuple[str, ...]:
    """Sentences on where an answer would mislead, or is not known."""
    study = report.study
    return (
        *_contact(study, report.states),
        *_far(report),
        *_stiffness(study),
        *_friction_caution(study),
        *of_data(study),
        *_damping(report),
        *report.remarks,
    )


def _contact(study: Study, found: Sequence[State]) -> Iterator[str]:
    if not {"L_0", "F_L", "k_c"} <= set(study.values):
        return
    length = 1e3 * study.values["L_0"]
    # The linear contact is valid up to this penetration, relative to the length of the spring.
    deep = 0.05
    for current, where in ((True, ""), (False, " in another state")):
        deepest = max(
            (-state.places.get("y_mm", 0.0) for state in found if state.current == current),
            default=0.0,
        )
        if deepest > deep * length:
            yield (
                f"the contact is {deepest:.3g} mm deep{where}; it is linear up to {deep:.0%} of "
                "L_0: check F_L and k_c"
            )


def _far(report: Facts) -> Iterator[str]:
    length, here = 1e3 * report.study.values.get("L_0", math.inf), report.current
    x = here.places.get("x_mm", 0.0) if here and not report.jumped else 0.0
    # With a displacement above half the length of the spring the deformation is not small.
    if abs(x) > 0.5 * length:
        yield (
            f"the followed state lies at x = {x:.3g} mm without a jump, {abs(x) / length:.0%} of "
            "L_0: it is no small deformation"
        )


def _stiffness(study: Study) -> Iterator[str]:
    if "k_c" not in study.values or not study.kind.opens:
        return
    for name in ("k", "k_x", "k_y"):
        ratio = study.values.get(name, 0.0) / study.values["k_c"]
        if ratio > 0.5:
            yield (
                f"{name} = {study.shown(name)} is {ratio:.3g} times k_c, and the contact should be "
                "the stiffest part: check both units"
            )
    sigma = study.values.get("k", math.inf) / study.values["k_c"]
    if sigma < 1e-4:
        yield f"k = {study.shown('k')} is only {sigma:.1g} times k_c: check its unit"


def _friction_caution(study: Study) -> Iterator[str]:
    missing = [name for name in study.kind.of_the_law if name not in study.values]
    if missing:
        yield (
            f"without {' and '.join(missing)} friction is taken at full slip, and no oscillation "
            "is looked for"
        )
    elif study.kind.law["at_rest"] == "other" and study.kind.friction in study.values:
        yield (
            f"the friction law is not proportional to {study.kind.friction}: friction is taken at "
            "rest, not at the belt's speed"
        )
    yield from _fit(study)
    name, own = study.kind.friction, study.kind.model.coefficient
    full = study.values.get(name, 0.0) if name else 0.0
    works = float(study.operating_point[own]) if full and own else 0.0
    # A warning if the friction at the belt's speed is below this share of μ₀.
    if works < 0.95 * full:
        share = f"{works / full:.3g} of {name}, {study.friction[1]:.3g} in place of {full:.3g}"
        cause = "d and V" if {"d", "V"} <= set(study.values) else study.belt
        yield f"the belt is so slow that friction is {share}: check {cause}"


def _fit(study: Study) -> Iterator[str]:
    fit = study.fit
    if fit is None:
        return
    # Above this d times the slowest measured speed, all measurements are on the law's level part.
    steep = 8.0
    if fit.rms > 0.1 * fit.mu0:
        yield (
            f"the law mu0 (1 - exp(-d v)) is {fit.rms / fit.mu0:.0%} off the measured friction: "
            "choose a model with another law"
        )
    elif fit.d * fit.slowest > steep:
        yield (
            f"friction is level from {fit.slowest:.3g} m/s on, so any d above "
            f"{steep / fit.slowest:.3g} s/m fits: measure at slower sliding"
        )
    if fit.points == 2:
        yield (
            "two measurements are met exactly by mu0 and d, whose errors are not known: measure "
            "at more speeds"
        )
    # Then no measurement is on the law's level part.
    if fit.d * fit.fastest < 0.1:
        yield (
            f"friction still rises at {fit.fastest:.3g} m/s, and only mu0 d = "
            f"{fit.mu0 * fit.d:.3g} s/m is known: measure at faster sliding, and check the unit"
        )


def of_data(study: Study) -> Iterator[str]:
    """Remarks that the numbers alone call for, whatever is asked of them: a unit that was probably
    meant otherwise.
    """
    name, inclination, belt = study.kind.friction, study.kind.inclination, study.belt
    friction, angle = (study.quantities.get(str(one)) for one in (name, inclination))
    if friction is not None and friction.high > FRICTION:
        yield f"{name} = {friction.high:g} is more than any brake has; write 45 % or 0.45 for 0.45"
    # No belt is as fast as this in m/s: the number was probably meant in mm/s.
    if belt in study.values and abs(speed := study.values[belt]) > 100.0:
        yield f"{study.shown_speed(speed)} looks like mm/s; write {speed:g} mm/s if that is meant"
    # A number of degrees up to π looks like radians.
    if (
        angle is not None
        and angle.unit in ("deg", "°", "degree", "degrees")
        and math.degrees(angle.value) < 3.15
    ):
        number = f"{study.in_file(str(inclination), angle.value):g}"
        yield (
            f"{inclination} = {study.shown(str(inclination))} looks like radians; write {number} "
            "rad if that is meant"
        )
    # Such a large damping ratio was probably meant in percent.
    ratio = study.damping_ratio
    if ratio is not None and ratio >= 0.2:
        yield (
            f"damping_ratio = {ratio:g} is {100 * ratio:g} %, more than any brake has; write "
            f"{ratio:g} % if that is meant"
        )
    length = study.values.get("L_0", 1.0)
    if not 1e-4 < length < 10:
        yield (
            f"L_0 = {study.shown('L_0')} is {length:.3g} m, outside 0.1 mm to 10 m: check its unit"
        )


def _damping(report: Facts) -> Iterator[str]:
    here = report.current
    if here is None or here.stability != "neutral" or not report.study.moves:
        return
    less = "nothing" if here.growth_per_s == 0 else "next to nothing"
    yield (
        f"{less} damps here, practically neutral: the real brake's damping decides; "
        f"{remedy(report.study.kind, report.study.values)}"
    )


def next_steps(report: Facts) -> Rows:
    """Verb and object of each step, the most useful first, the command to go on with last."""
    study = report.study
    found = [*_changes(report), *_ranges(report), *_measurements(report), *_other_state(report)]
    command = (
        f"spragsym explore --data {shlex.quote(study.source)}, to walk over the folds and let it "
        "move"
    )
    run = [("run", command)] if study.source else []
    # At most five steps.
    yield from (*found[: 5 - len(run)], *run)


def _changes(report: Facts) -> Rows:
    study = report.study
    if study.load is None and study.kind.rises:
        yield "name", f'what rises until it jumps, in the file, as vary = "{study.kind.rises}"'
    for one in report.redesign[:1]:
        values = " and ".join(steps(study, one))
        then = (
            "it does not jump"
            if math.isnan(one.jump_at)
            else f"it jumps at {study.load_text(one.jump_at)}"
        )
        yield (
            "change",
            f"{values}: then "
            f"{then}{', proved for all tolerances' if one.outcome == 'proved' else ''}",
        )
    if report.searched and not report.redesign:
        yield (
            "allow",
            "wider ranges in may_change, or smaller tolerances: no change within them was "
            "found that keeps it from jumping",
        )


def steps(study: Study, change: Change) -> Iterator[str]:
    """Each quantity of a change with its old and its new value."""
    for name, old in change.before.items():
        yield f"{name} from {study.shown(name, old)} to {study.shown(name, change.after[name])}"


def _ranges(report: Facts) -> Rows:
    study, jump, odds = report.study, report.jump_at, report.probability
    low, _, high = study.in_use
    if jump is not None and low < jump <= high and low < high:
        yield (
            "narrow",
            f"the {study.loading.word}, {study.load_text(low)} to {study.load_text(high)}, to "
            f"less than {study.load_text(jump)}",
        )
        return
    # The first one has the largest total index.
    for name, (_, total, _) in [*(odds.sobol if odds and odds.probability else {}).items()][:1]:
        if total > 0:
            share = f"{min(1.0, total):.0%} of the variance with interactions"
            yield "narrow", f"the tolerance of {name}: it decides most, {share}"


def _measurements(report: Facts) -> Rows:
    study, here = report.study, report.current
    missing = [name for name in study.kind.of_the_law if name not in study.quantities]
    if missing:
        write = " and ".join(
            f'{name} = "{example_of(name, study.kind.units[name])}"' for name in missing
        )
        yield (
            "measure",
            f"{' and '.join(missing)}, and add {write}: then its motion is followed too",
        )
    elif here is not None and here.stability == "neutral":
        roots = zip(here.frequencies_hz, here.damping_ratio, strict=True)
        at = " and ".join(hertz(f) for f, ratio in roots if is_negligible(ratio))
        yield (
            "measure",
            f"the damping of the real brake{f' at {at}' if at else ''}, of which the model has "
            f"next to none: {remedy(study.kind, study.values)}",
        )
    elif here is not None and here.stability == "unstable" and study.belt and study.source:
        command = f"spragsym bifurcation --data {shlex.quote(study.source)} --vary {study.belt}"
        yield "find", f"the {study.belt} at which sliding becomes stable: {command}"
    exact = [
        name for name in deciding(study) if not study.quantities[name].varies and study.values[name]
    ]
    if exact:
        # The others are only counted.
        named = 4
        more = f" and {len(exact) - named} more" if len(exact) > named else ""
        yield (
            "measure",
            f"how far {', '.join(exact[:named])}{more} may be off: without a tolerance they "
            "are taken as exact",
        )


def _other_state(report: Facts) -> Rows:
    for state, _ in report.others[:1]:
        name, _, unit = next(iter(state)).rpartition("_")
        there = f"{state[f'{name}_{unit}']:.3g} {unit}"
        how = f'for the other one write state = {{ {name} = "{there}" }}'
        if not comes_from_near(report.study, state):
            how = f"the other one, {name} = {there}, comes by a jump or a push, not as "
            how += f"{report.study.loading.word} rises"
        yield "decide", f"which stable state the brake works in; {how}"
