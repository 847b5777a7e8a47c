"""Warnings where an answer would mislead, each in one sentence with what to do."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from . import brake_quantities
from .brake_files import example_of
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


def cautions(study: Study, found: Sequence[State], jumped: bool) -> tuple[str, ...]:
    """All warnings for a study, the states that were found, and whether the one that the brake is in is behind a jump."""
    return (
        *_contact(study, found),
        *(() if jumped else _far(study, found)),
        *_stiffness(study),
        *_friction(study),
        *of_data(study),
        *_damping(study, found),
    )


def _has(study: Study, *names: str) -> bool:
    """Whether the brake has some quantities: a caution about others is none of it."""
    return set(names) <= set(study.quantities)


def _contact(study: Study, found: Sequence[State]) -> Iterator[str]:
    if not _has(study, "L_0", "F_L", "k_c") or not all("y_mm" in state.places for state in found):
        return
    length = 1e3 * study.values["L_0"]
    for which, states in (
        ("the contact is", [state for state in found if state.current]),
        ("in another state of sliding the contact is", [state for state in found if not state.current]),
    ):
        deepest = max((-state.y_mm for state in states), default=0.0)
        if deepest > DEEP * length:
            yield (
                f"{which} {deepest:.3g} mm deep, {deepest / length:.2g} of the length of the spring: a linear contact means "
                f"nothing there; check F_L = {study.shown('F_L', study.values['F_L'])} "
                f"and k_c = {study.shown('k_c', study.values['k_c'])}"
            )


def _far(study: Study, found: Sequence[State]) -> Iterator[str]:
    if not _has(study, "L_0") or not all("x_mm" in state.places for state in found):
        return
    length = 1e3 * study.values["L_0"]
    for state in found:
        if state.current and abs(state.x_mm) > FAR * length:
            yield (
                f"the state that is reached as {'friction' if study.rise is None else study.rise.word} rises has not jumped, and "
                "its mass is displaced by "
                f"{state.x_mm:.3g} mm all the same, {abs(state.x_mm) / length:.2g} of the length of the spring: that is "
                "no small deformation"
            )


def _stiffness(study: Study) -> Iterator[str]:
    if not _has(study, "k_c") or not study.about["contact"]["unilateral"]:
        return
    for name in (name for name in ("k", "k_x", "k_y") if _has(study, name)):
        ratio = study.values[name] / study.values["k_c"]
        if ratio > 0.5:
            yield (
                f"{name} = {study.shown(name, study.values[name])} is {ratio:.3g} times the stiffness of the contact, "
                f"k_c = {study.shown('k_c', study.values['k_c'])}: the contact should be the stiffest part; check both units"
            )
    sigma = study.values.get("k", math.inf) / study.values["k_c"]
    if sigma < 1e-4:
        yield (
            f"k = {study.shown('k', study.values['k'])} is {sigma:.1g} of the stiffness of the contact: a spring as soft as that "
            "hardly leans on the mass; check its unit"
        )


def _friction(study: Study) -> Iterator[str]:
    law = study.about["friction"]
    missing = [name for name in brake_quantities.of_the_law(study.model) if not _has(study, name)]
    also = f"{' and '.join(missing)} {'is' if len(missing) == 1 else 'are'} not given"
    write = " and ".join(f'{name} = "{example_of(name, study.si(name))}"' for name in missing)
    if missing:
        yield (
            f"{also}: friction is taken at full slip, the friction law's damping is left out of what is called stable, and no "
            f"oscillation is looked for; add {write}"
        )
    elif law and law["at_rest"] == "other" and _has(study, "mu0"):
        yield (
            "the friction law is not proportional to mu0, or not mu0 at full slip: friction is taken as statics has it, and "
            "not at the speed of the belt"
        )
    yield from _fit(study)
    if not _has(study, "mu0"):
        return
    if study.fraction < FULL:
        both = _has(study, "d") and _has(study, "V")
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
    friction = study.quantities.get("mu0")
    if friction is not None and friction.high > FRICTION:
        yield f"mu0 = {friction.high:g} is more than any brake has; write 45 % or 0.45 for 0.45"
    belt = study.belt
    if belt is not None and _has(study, belt) and abs(speed := study.values[belt]) > FAST:
        yield f"{study.shown_speed(speed)} is {speed:.4g} m/s, which looks like mm/s; write {speed:g} mm/s if that is meant"
    angle = study.quantities.get("theta0")
    if angle is not None and angle.unit in ("deg", "°", "degree", "degrees") and math.degrees(angle.value) < FLAT:
        yield (
            f"theta0 = {study.shown('theta0', angle.value)} looks like radians; write "
            f"{study.in_file('theta0', angle.value):g} rad if that is meant"
        )
    length = study.values.get("L_0", 1.0)
    if not 1e-4 < length < 10:
        yield f"L_0 = {study.shown('L_0', length)} is {length:.3g} m: an odd length for a part of a brake; check its unit"


def _damping(study: Study, found: Sequence[State]) -> Iterator[str]:
    for state in found:
        if study.moves and state.current and state.statics == "stable":
            least = min(state.damping_ratio, default=0.0)
            if state.growth_per_s == 0:
                yield (
                    "nothing damps here, since the friction does not change with the speed; whether a disturbance dies out is up "
                    "to the damping of the real brake, which the model leaves out"
                )
            elif state.settles is None:
                what = "and it settles slowly" if least > 0 else "which is negative: a disturbance grows slowly"
                whose = (
                    "the dampers and the friction law together leave"
                    if study.about["dampers"]
                    else "the friction law alone gives"
                )
                yield (
                    f"{whose} one motion a damping ratio of {least:.1g}, {what}; that is next to nothing, and the damping of the "
                    "real brake, which the model leaves out, decides"
                )
