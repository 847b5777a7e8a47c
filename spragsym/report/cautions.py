"""Warnings where an answer would mislead, each in one sentence with what to do."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from .brake_files import example_of
from .facts import Facts
from .states import State
from .study import Study

#: Penetration over the length of the spring beyond which a linear contact means nothing.
DEEP = 0.05
#: Displacement over the length of the spring beyond which a state is none of small deformation.
FAR = 0.5
#: Share of μ₀ below which the friction at the speed of the belt is worth a warning.
FULL = 0.95
#: Rms of what a fitted friction law leaves, over μ₀, from which on another law is needed.
POOR = 0.1
#: d times the slowest measured speed from which on no measurement is on the rising part of the friction law, and d times the
#: fastest one up to which none is on its level part.
STEEP, FULL_AT = 8.0, 0.1
#: A friction coefficient that no brake has.
FRICTION = 2.0
#: Speeds in m/s that no belt has: the number was probably meant in mm/s.
FAST = 100.0
#: Degrees up to which an inclination looks like radians.
FLAT = 3.15


def cautions(facts: Facts) -> tuple[str, ...]:
    """All warnings for a study and the states that were found."""
    study, found = facts.study, facts.states
    return (
        *_contact(study, found),
        *(() if facts.jumped else _far(study, found)),
        *_stiffness(study),
        *_friction(study),
        *of_data(study),
        *_damping(study, found),
    )


def _has(study: Study, *names: str) -> bool:
    """Whether the brake has some quantities: a caution about others is none of it."""
    return set(names) <= set(study.quantities)


def _data(study: Study, *names: str) -> str:
    """Quantities with their values."""
    return " and ".join(f"{name} = {study.shown(name)}" for name in names)


def _contact(study: Study, found: Sequence[State]) -> Iterator[str]:
    if not _has(study, "L_0", "F_L", "k_c") or not all("y_mm" in state.places for state in found):
        return
    length = 1e3 * study.values["L_0"]
    for current, which in ((True, "the contact is"), (False, "in another state of sliding the contact is")):
        deepest = max((-state.y_mm for state in found if state.current == current), default=0.0)
        if deepest > DEEP * length:
            yield (
                f"{which} {deepest:.3g} mm deep, {deepest / length:.2g} of the length of the spring: a linear contact means "
                f"nothing there; check {_data(study, 'F_L', 'k_c')}"
            )


def _far(study: Study, found: Sequence[State]) -> Iterator[str]:
    if not _has(study, "L_0") or not all("x_mm" in state.places for state in found):
        return
    length = 1e3 * study.values["L_0"]
    for state in found:
        if state.current and abs(state.x_mm) > FAR * length:
            yield (
                f"the state that is reached as {'friction' if study.rise is None else study.rise.word} rises has not jumped, and "
                f"its mass is displaced by {state.x_mm:.3g} mm all the same, {abs(state.x_mm) / length:.2g} of the length of the "
                "spring: that is no small deformation"
            )


def _stiffness(study: Study) -> Iterator[str]:
    if not _has(study, "k_c") or not study.kind.about["contact"]["unilateral"]:
        return
    for name in (name for name in ("k", "k_x", "k_y") if _has(study, name)):
        ratio = study.values[name] / study.values["k_c"]
        if ratio > 0.5:
            yield (
                f"{_data(study, name)} is {ratio:.3g} times the stiffness of the contact, {_data(study, 'k_c')}: the contact "
                "should be the stiffest part; check both units"
            )
    sigma = study.values.get("k", math.inf) / study.values["k_c"]
    if sigma < 1e-4:
        yield (
            f"{_data(study, 'k')} is {sigma:.1g} of the stiffness of the contact: a spring as soft as that hardly leans on the "
            "mass; check its unit"
        )


def _friction(study: Study) -> Iterator[str]:
    missing = [name for name in study.kind.of_the_law if not _has(study, name)]
    if missing:
        write = " and ".join(f'{name} = "{example_of(name, study.kind.units[name])}"' for name in missing)
        yield (
            f"{' and '.join(missing)} {'is' if len(missing) == 1 else 'are'} not given: friction is taken at full slip, the "
            "friction law's damping is left out of what is called stable, and no oscillation is looked for; add "
            f"{write}"
        )
    elif study.kind.law["at_rest"] == "other" and _has(study, "mu0"):
        yield (
            "the friction law is not proportional to mu0, or not mu0 at full slip: friction is taken as statics has it, and "
            "not at the speed of the belt"
        )
    yield from _fit(study)
    if _has(study, "mu0") and study.fraction < FULL:
        both = _has(study, "d", "V")
        since = f"since d V = {study.values['d'] * abs(study.values['V']):.3g}; check d and V" if both else f"check {study.belt}"
        yield (
            f"the belt is so slow that friction works at {100 * study.fraction:.3g} % of mu0: {study.friction[1]:.4g} in place "
            f"of {study.values['mu0']:.4g}, {since}"
        )


def _fit(study: Study) -> Iterator[str]:
    fit = study.fit
    if fit is None:
        return
    if fit.rms > POOR * fit.mu0:
        yield (
            f"the law mu0 (1 - exp(-d v)) is {100 * fit.rms / fit.mu0:.0f} % off the measured friction on average: it rises with "
            "speed and levels off; if what was measured falls with speed, the model kang_nam has no such law"
        )
    elif fit.d * fit.slowest > STEEP:
        yield (
            f"the measured friction is level from {fit.slowest:.3g} m/s on: any d above {STEEP / fit.slowest:.3g} s/m fits, and "
            f"d = {fit.d:.3g} s/m is one of them; measure at slower sliding"
        )
    if fit.points == 2:
        yield "two measurements are met exactly by mu0 and d, so that how far those are off is not known; measure at more speeds"
    if fit.d * fit.fastest < FULL_AT:
        yield (
            f"the measured friction still rises in proportion to the speed at {fit.fastest:.3g} m/s: only mu0 d = "
            f"{fit.mu0 * fit.d:.3g} s/m is known, not each of the two; measure at faster sliding, and check their unit"
        )


def of_data(study: Study) -> Iterator[str]:
    """What the numbers alone say, whatever is asked of them: a unit that was probably meant otherwise."""
    friction, angle, belt = study.quantities.get("mu0"), study.quantities.get("theta0"), study.belt
    if friction is not None and friction.high > FRICTION:
        yield f"mu0 = {friction.high:g} is more than any brake has; write 45 % or 0.45 for 0.45"
    if belt is not None and _has(study, belt) and abs(speed := study.values[belt]) > FAST:
        yield f"{study.shown_speed(speed)} is {speed:.4g} m/s, which looks like mm/s; write {speed:g} mm/s if that is meant"
    if angle is not None and angle.unit in ("deg", "°", "degree", "degrees") and math.degrees(angle.value) < FLAT:
        number = f"{study.in_file('theta0', angle.value):g}"
        yield f"{_data(study, 'theta0')} looks like radians; write {number} rad if that is meant"
    length = study.values.get("L_0", 1.0)
    if not 1e-4 < length < 10:
        yield f"{_data(study, 'L_0')} is {length:.3g} m: an odd length for a part of a brake; check its unit"


def _damping(study: Study, found: Sequence[State]) -> Iterator[str]:
    for state in found:
        if not study.moves or not state.current or state.statics != "stable" or state.settles is not None:
            continue
        least = min(state.damping_ratio, default=0.0)
        if state.growth_per_s == 0:
            yield (
                "nothing damps here: whether a disturbance dies out is up to the damping of the real brake, which the model "
                "leaves out"
            )
            continue
        what = "and it settles slowly" if least > 0 else "which is negative: a disturbance grows slowly"
        law = "the friction law alone gives"
        whose = "the dampers and the friction law together leave" if study.kind.about["dampers"] else law
        yield (
            f"{whose} one motion a damping ratio of {least:.1g}, {what}; the state is practically neutral: the damping "
            "of the real brake, which the model leaves out, decides"
        )
