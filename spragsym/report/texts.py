"""The texts of a report, from its facts: the verdict in sentences (:func:`verdict`), sections with
rows of name and value (:func:`sections`), the whole as text (:func:`blocks`) and as JSON
(:func:`as_json`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import fields
from typing import Any, TypeAlias

from .._version import __version__
from ..design.jumps import verb_of
from ..design.probability import JumpProbability
from ..models.load import USUAL, WITH_DAMPERS
from .advice import Rows, next_steps, steps, warnings
from .facts import Facts, percent_beyond
from .redesigns import LARGEST_FACTOR
from .states import SHARE_BEYOND_FOLD, JumpPeak, Oscillation, State, in_units, is_negligible
from .study import Study
from .units import SIGMAS_AT_ENDS, Numbers, hertz

#: An object in JSON.
Json: TypeAlias = dict[str, Any]


def verdict(report: Facts) -> Iterator[str]:
    """The verdict, sentence by sentence: the jump and the margin to it, other stable states, the
    motion, the tolerances.
    """
    for line in (_on_the_jump, _on_others, _on_the_motion, _on_the_tolerances):
        if text := line(report):
            yield text


def _on_others(report: Facts) -> str:
    """Sentence about other stable states, and where each ends."""
    study, states = report.study, []
    for state, end in report.others:
        until = ""
        if end is not None:
            until = f", until {study.named(end)}"
            if math.isnan(end):
                until = f", at any {study.search_range}"
        states.append(_places(state) + until)
    return f"At the design another state is stable: {'; and '.join(states)}." if states else ""


def followed_state(study: Study) -> str:
    """Name of the state that is followed."""
    if study.state:
        return f"the state chosen near {_places(in_units(study, study.near))}"
    return "the reference state"


def _on_the_motion(report: Facts) -> str:
    """Sentence about an oscillation, lift-off or instability; empty if the brake comes to rest or
    its motion is not known.
    """
    found = report.oscillation
    here = [state for state in report.states if state.current] or report.states
    sliding = report.study.slides
    if found is None or not (found.alive or found.kind == "lift-off"):
        if here and all(state.stability == "unstable" for state in here):
            what = "Steady sliding" if sliding else "Rest"
            return f"{what} is unstable: small disturbances grow."
        return ""
    if found.kind == "lift-off":
        return f"From {found.start} it lifts off the belt for good."
    beside = f", beside stable {'sliding' if sliding else 'rest'}" if found.coexists else ""
    at = hertz(found.frequency_hz)
    if found.kind == "motion":
        return (
            f"From {found.start} it goes on swinging, and had not repeated itself when it was "
            f"left{beside}."
        )
    if found.start == "rest":
        return f"From rest it comes to an oscillation of {at}{beside}."
    if found.coexists is False:
        return f"Small disturbances grow; from far out it comes to an oscillation of {at}."
    return f"If it is disturbed far enough it oscillates at {at}{beside}."


def _on_the_jump(report: Facts) -> str:
    """Sentence about the jump of the followed state, against the friction (or load) in use."""
    study, jump, load = report.study, report.jump_at, report.study.loading
    if jump is None:
        return _unknown(report)
    (low, _, high), full = study.in_use, study.full_slip[2]
    usual = study.model in (USUAL, WITH_DAMPERS[USUAL])  # their states are the same
    model = "" if usual else f" with the model {study.kind.about['name']}"
    state = followed_state(study)
    angle = study.kind.inclination
    if angle is not None and angle in study.quantities and load.quantity != angle:
        state = f"at {study.shown(angle)} {state}"
    digits = _distinct_digits(study, jump, (low, high, full))
    jumps = f"{verb_of(report.kind_jump).does} at {study.named(jump, digits)}"
    sprags, does = "sprags", "jump"
    if report.kind_jump == "border":
        sprags, does = "loses its contact", "lose it"
    if report.reach in ("never", "beyond"):
        what = f"has no jump at any {study.search_range}" if report.reach == "never" else jumps
        if report.reach == "beyond" and full:
            what += (
                f", {percent_beyond(jump, full):.0f} % above the largest that you have, "
                f"{study.load_text(full, digits)}"
            )
        it = "As drawn it" if study.tolerances else "It"
        return f"{it} does not sprag{model}: {state} {what}."
    if report.reach == "faster":
        at = "the belt's speed" if study.belt is None else study.shown(study.belt, digits=3)
        above = "at a higher speed"
        if not math.isnan(report.speed):
            above = f"above {study.shown_speed(report.speed, 3)}"
        if study.belt is not None and report.speed < study.values[study.belt]:
            above = f"at lower speeds, from {study.shown_speed(report.speed, 3)} on"
        works = f"{high:.{digits}g}"
        if high < full:
            works = f"only {works} of your {full:.{digits}g}"
        return (
            f"It {sprags}{model} {above}: {state} {jumps}; at {at} {works} works, and it does not "
            f"{does}."
        )
    where, ends = "below your", study.load_text(high, digits)
    if high > low:
        ends = f"{study.load_text(low, digits)} to {ends}"
    if high != low:
        where = "already below all of your range of" if jump < low else "within your range of"
    return f"It {sprags}{model}: {state} {jumps}, {where} {load.word} {ends}."


def _distinct_digits(study: Study, jump: float, ends: Sequence[float]) -> int:
    """Number of digits, 4 to 8, with which the jump differs in print from the values in
    ``ends``.
    """
    for digits in range(4, 8):
        others = {study.load_text(end, digits) for end in ends if end != jump}
        if study.load_text(jump, digits) not in others:
            return digits
    return 8


def _unknown(report: Facts) -> str:
    """Sentence about the states, if the jump is not known."""
    study, states = report.study, report.states
    where = " of sliding" if study.slides else ""
    if any(contact["gap"] is not None for contact in study.kind.about["contacts"]):
        where += " in contact"
    unstable = sum(state.stability == "unstable" for state in states)
    found = f"are {len(states)} states{where}, {unstable} unstable"
    if len(states) == 1:
        found = f"is one state{where}, {states[0].stability}"
    why = "whether it sprags is not known"
    if study.load is None:
        why = "nothing is said to rise until it jumps"
    return f"With the model {study.kind.about['name']} there {found}; {why}."


def _on_the_tolerances(report: Facts) -> str:
    """Sentence about all brakes within the tolerances."""
    odds, speed = report.probability, " at this speed" if report.reach == "faster" else ""
    if report.within == "proved":
        if report.study.tolerances:
            return f"Proved{speed}: nothing within {box(report.unbounded)} sprags."
        return "That it does not sprag is proved."
    if odds is None:
        return "A proof was not found." if report.within == "undecided" else ""
    if report.within != "refuted" and not report.hits:
        return (
            f"Of {odds.n} brakes within the tolerances none sprags; a proof for all of them was "
            "not found."
        )
    also = "" if report.hits else ", and at least one does"
    return f"Within the tolerances{speed} {share(odds)} of all brakes sprag{also}."


def box(unbounded: Sequence[str]) -> str:
    """Name of the box of a certificate; ``unbounded`` are quantities whose distribution extends
    beyond it.
    """
    if not unbounded:
        return "the tolerances"
    names = " and ".join(unbounded)
    return f"the tolerances, and {SIGMAS_AT_ENDS:g} standard deviations of {names}"


def share(odds: JumpProbability) -> str:
    """The share of brakes that jump, in percent; only a bound if none or all of a sample do."""
    if odds.probability == 0:
        return f"fewer than {_percent(odds.high)}"
    return _percent(odds.probability) if odds.probability < 1 else f"more than {_percent(odds.low)}"


def _percent(number: float) -> str:
    """A share in percent with three digits, or six if these would make it 100 %."""
    text = f"{100 * number:.3g}"
    return f"{100 * number:.6g} %" if text == "100" and number < 1 else f"{text} %"


def about(report: Facts) -> dict[str, str]:
    """Title, date, file, model and version of spragsym."""
    study = report.study
    return {
        "title": study.title,
        "date": study.date,
        "file": study.source,
        "model": f"model {study.kind.about['name']}",
        "version": f"spragsym {__version__}",
    }


def blocks(report: Facts) -> Iterator[str]:
    """The text of a report, block by block: verdict, sections, origin."""
    yield from verdict(report)
    for title, rows in sections(report):
        if rows:
            yield "\n".join(["", title, *lines(rows)])
    yield "\n" + ", ".join(filter(None, about(report).values()))


def lines(rows: Sequence[tuple[str, str]]) -> list[str]:
    """Rows as lines with aligned values; a value follows below a name that is too long."""
    short = 8
    wide = 32 if any(len(name) >= short for name, _ in rows) else short
    return [
        f"  {name:<{wide}}{value}" if len(name) < wide else f"  {name}\n  {'':<{wide}}{value}"
        for name, value in rows
    ]


def sections(report: Facts) -> Iterator[tuple[str, list[tuple[str, str]]]]:
    """Each heading with its rows of name and value."""
    parts = {
        "What to do next": next_steps,
        "Warnings": _warnings,
        "State": _state,
        "Folds": _folds,
        "Jump": _jump,
        "The jump as a motion": _peak,
        "Oscillation": _oscillation,
        "Tolerances": _tolerances,
        "Changes": _changes,
    }
    for title, rows in parts.items():
        yield title, list(rows(report))


def _jump(report: Facts) -> Rows:
    study, load, (low, works, high) = report.study, report.study.load, report.study.friction
    if study.slides:
        yield (
            "friction at the belt's speed",
            f"{works:.4g}" + (f", {low:.4g} to {high:.4g}" if high > low else ""),
        )
        for name, other in study.other_frictions.items():
            yield f"friction of the contact {name}", f"{other:.4g}"
    if load is None:
        return
    full, most = study.full_slip, study.in_use[2]
    if report.slow:
        yield (
            "friction at full slip",
            f"{full[1]:.4g}" + (f", up to {full[2]:.4g}" if full[2] > full[1] else ""),
        )
    never = "never" if math.isinf(study.upper_limit) else f"at no {study.search_range}"
    own = "" if report.mu0_jump == report.mu_jump else f", {load.quantity} = {report.mu0_jump:.6g}"
    angle = study.kind.inclination
    at = f" as {load.word} rises"
    if load.is_friction:
        at = " at this angle" if angle in study.quantities else ""
    end = _without_jump(report.kind_jump)
    yield (
        f"jump{at}",
        _or_unknown(
            report.jump_at,
            lambda value: f"{end}at {load.word} {study.load_text(value, 6)}{own}",
            never,
        ),
    )
    if report.jump_at is not None and not math.isnan(report.jump_at) and most:
        yield f"margin to the largest {load.word}", f"{report.margin_percent:+.1f} %"
        if report.slow:
            yield "the same at full slip", f"{percent_beyond(report.jump_at, full[2]):+.1f} %"
    if study.moves and report.mu_jump is not None:
        speed = report.speed
        begins = (
            "at no speed"
            if math.isnan(speed)
            else f"{study.shown(str(study.belt), speed)}, with the largest friction"
        )
        yield "speed at which it begins to jump", begins
    if angle in study.quantities and load.quantity != angle:
        yield (
            "jump at this friction",
            _or_unknown(
                report.theta0_jump_deg,
                f"{_without_jump(report.kind_theta0_jump)}at {{:.6g}} deg".format,
                "never",
            ),
        )
    if angle in study.quantities and load.is_friction:
        lowest = _or_unknown(report.mu_lowest, "friction {:.6g}".format, "there is none")
        if report.kind_lowest:
            what = "to infinity" if report.kind_lowest == "infinity" else f"a {report.kind_lowest}"
            lowest += (
                f", {what} at {report.theta0_lowest_deg:.6g} deg; below this friction it "
                "ends at no angle"
            )
        yield "least friction at which it ends", lowest
        if report.kind_lowest != "cusp":  # it would be said twice
            yield (
                "friction of the cusp",
                _or_unknown(report.mu_cusp, "{:.6g}".format, "there is none"),
            )
    if not math.isnan(report.distance):
        where = (
            "none found"
            if math.isinf(report.distance)
            else f"{report.distance:.3g}, as the root of the sum of squares"
        )
        yield (
            "tolerances to the nearest jump",
            where if report.distance else "0, it has jumped already",
        )


def _without_jump(kind: str) -> str:
    """Text before the value at which a state ends, if it does not jump there."""
    does = verb_of(kind).does
    return "" if does == "jumps" else f"none: it {does} "


def _or_unknown(value: float | None, shown: Callable[[float], str], never: str) -> str:
    """Text of a value, which may be None for unknown, or not finite for ``never``."""
    if value is None:
        return "unknown"
    return shown(value) if math.isfinite(value) else never


def _of_each(numbers: object, shown: Callable[[Any], str], of: str, alone: str = "") -> Rows:
    """Rows of several numbers by name, or the row of one number, called ``alone``; none for
    None.
    """
    for name, value in (numbers if isinstance(numbers, Mapping) else {alone: numbers}).items():
        if value is not None:
            yield f"{of} {name}".strip(), shown(value)


def _forces(found: JumpPeak | Oscillation) -> Rows:
    """Rows of the ranges of spring and contact forces."""

    def ends(force: tuple[float, float]) -> str:
        return f"{force[0]:.5g} N to {force[1]:.5g} N"

    yield from _of_each(found.spring_force_N, ends, "force of", "the spring")
    yield from _of_each(found.contact_force_N, ends, "force of the contact")


def _pulling(force: float) -> str:
    """Text of a spring force with its direction."""
    direction = ""
    if force:
        direction = ", it pushes" if force < 0 else ", it pulls"
    return f"{force:.5g} N{direction}"


def _places(places: Numbers) -> str:
    """Text of coordinates with units."""
    named = ((*key.rpartition("_"), value) for key, value in places.items())
    return ", ".join(f"{name} = {value:.4g} {unit}" for name, _, unit, value in named)


def _state(report: Facts) -> Rows:
    followed = "the state it jumped to" if report.jumped else followed_state(report.study)
    followed = "the state" if report.jump_at is None else followed
    for state in report.states:
        yield followed if state.current else "another state", _described(state)
    here = report.current
    if here is None:
        return
    yield "place of the mass", _places(here.places)
    yield from _of_each(here.spring_force_N, _pulling, "force of", "the spring")
    if here.touching:
        yield "touching", here.touching
    yield from _of_each(here.contact_force_N, "{:.5g} N".format, "force of the contact")
    roots = zip(here.frequencies_hz, here.damping_ratio, strict=True)
    damped, study = report.study.moves, report.study
    yield (
        "frequencies",
        ", ".join(hertz(f) + f" ({_ratio(ratio)})" * damped for f, ratio in roots) or "none",
    )
    if study.damping_ratio is not None:
        dampers = ", ".join(f"{name} = {study.shown(name)}" for name in study.kind.dampers)
        yield f"dampers, for a ratio of {_percent(study.damping_ratio)}", dampers


def _ratio(ratio: float) -> str:
    """A damping ratio; one that decides nothing has no number."""
    return "next to no damping" if is_negligible(ratio) else f"damping ratio {ratio:.2g}"


def _described(state: State) -> str:
    """Text of a state: stability, directions of its springs, first coordinate."""
    word = state.stability
    if word == "neutral":
        word += ": the damping of the real brake decides whether it settles"
    elif word != state.undamped:
        word += f" ({state.undamped} without damping)"
    springs = [
        f"; {name.removeprefix('the ')} at {at}"
        for name, at in _of_each(state.direction_deg, "{:.4g} deg".format, "", "the spring")
    ]
    return (
        f"{word}{''.join(springs)}{',' if springs else ';'} "
        f"{_places(dict(list(state.places.items())[:1]))}"
    )


def _peak(report: Facts) -> Rows:
    found, study = report.peak, report.study
    if found is None:
        return
    first = next(iter(found.before))
    places = (
        f"from {_places({first: found.before[first]})} to {found.after[first]:.4g} "
        f"{first.rpartition('_')[2]}"
    )
    faster = f" and {study.shown_speed(report.speed, 3)}" if report.reach == "faster" else ""
    yield (
        "the states before and after",
        f"at {study.loading.word} {study.load_text(found.at)}{faster}, {places}",
    )
    yield "let go at rest", f"{100 * SHARE_BEYOND_FOLD:g} % of the way beyond the fold"
    for key, (least, most) in found.ranges.items():
        name, _, unit = key.rpartition("_")
        yield f"range of {name}", f"{least:.4g} {unit} to {most:.4g} {unit}"
    yield from _forces(found)
    ends_in = {
        "rest": "it settles at rest",
        "cycle": "it goes over into an oscillation",
        "lift-off": "it lifts off for good",
        "unsettled": f"it still swings after {found.followed_s:.3g} s",
    }
    yield "then", ends_in[found.settles]


def _warnings(report: Facts) -> Rows:
    yield from ((f"{number}.", one) for number, one in enumerate(warnings(report), 1))


def _folds(report: Facts) -> Rows:
    study = report.study
    nothing = "nothing is left in contact" if study.kind.opens else "nothing is left"
    for row in report.fold_rows:
        if row.inclination_deg is None:
            name = f"{study.loading.word} {study.load_text(row.friction or row.value or 0.0, 5)}"
        else:
            name = f"inclination {row.inclination_deg:.5g} deg"
        at_border = {
            "passes": "the state passes, where a contact is lost or regained",
            "border_fold": "two states end where a contact is lost or regained",
        }
        if row.kind != "fold":
            yield name, at_border.get(row.kind, f"a {row.kind}")
        elif not row.ends:
            yield name, "two states meet, neither of them stable"
        elif "undecided" in (row.ends, row.when):
            yield name, "two states meet; which of them ends, and when, is not decided"
        else:
            key = next(iter(row.before))
            coordinate, _, unit = key.rpartition("_")
            goes = (
                f"{coordinate} goes from {row.before[key]:.4g} {unit} to {row.after[key]:.4g} "
                f"{unit}"
            )
            left = nothing if math.isnan(row.after[key]) else goes
            state = f"{row.ends} state" + ", unstable with damping," * (row.unstable > 0)
            yield (
                name,
                f"the {state} ends as it {'rises' if row.when == 'up' else 'falls'}; {left}",
            )


def _tolerances(report: Facts) -> Rows:
    study, reached, odds = report.study, report.certificate, report.probability
    if reached is not None:
        within = box(report.unbounded) if report.unbounded else "all of them"
        yield f"no jump within {within}", reached.outcome
        if reached.counterexample:
            off = (
                (name, value)
                for name, value in reached.counterexample.items()
                if name in study.tolerances
            )
            values = ", ".join(f"{name} = {study.shown(name, value)}" for name, value in off)
            yield "a brake within them that jumps", values or "the brake itself"
    if odds is None:
        return
    if report.within == "proved" and not report.unbounded:
        yield "probability of a jump", "0, as is proved"
    else:
        more = (
            ", and at least one brake"
            if report.within == "refuted" and report.hits is False
            else ""
        )
        ends = f"{_percent(odds.low)} to {_percent(odds.high)} with confidence {odds.confidence:g}"
        yield "probability of a jump", f"{share(odds)}, {ends}{more}"
        if odds.proved != (0.0, 1.0):
            low = math.floor(1e4 * odds.proved[0]) / 1e2
            high = math.ceil(1e4 * odds.proved[1]) / 1e2
            rest = "no sampling can leave that"
            if high - low > 50.0:
                rest = "most of the brakes within the tolerances are not decided"
            what = f"what is proved to jump, and all but what is proved not to; {rest}"
            yield "the same by proof", f"{low:g} % to {high:g} %: {what}"
    known_indices = {
        name: indices for name, indices in odds.sobol.items() if not math.isnan(indices[1])
    }
    # If almost no brake jumps, or almost all do, samples do not resolve Sobol' indices.
    if any(not error <= 0.2 for *_, error in known_indices.values()):
        yield (
            "how much each of them decides",
            f"not told by {odds.n} samples, of which too few differ",
        )
        return
    for name, indices in known_indices.items():
        # Estimates may be negative, shares are not.
        alone, all_of_it = (max(0.0, 100 * part) for part in indices[:2])
        shares = (
            f"{alone:.0f} % of the variance alone, {all_of_it:.0f} % with interactions (Sobol')"
        )
        yield f"how much {name} decides", shares


def _oscillation(report: Facts) -> Rows:
    found = report.oscillation
    if found is None:
        return
    if found.start != "rest":
        yield "from rest", "no cycle was reached in the time that was looked at"
    what = {
        "cycle": "a cycle, stable",
        "motion": "a motion that has not repeated itself",
        "rest": "none: it decays to rest",
        "grows": "none was found: the motion grew larger and larger, and was not followed further",
        "falls": (
            "none was found: the motion became smaller and smaller, and was not followed to its end"
        ),
        "lift-off": "none: it lifts off the belt for good",
    }
    yield "from rest" if found.start == "rest" else "from far out", what[found.kind]
    if not found.alive:
        return
    if found.kind == "cycle":
        yield "frequency", hertz(found.frequency_hz, 5)
    sliding = report.study.slides
    yield (
        "amplitude along the belt" if found.unit == "mm" and sliding else "amplitude",
        f"{found.amplitude:.4g} {found.unit}",
    )
    yield from _forces(found)
    if report.study.kind.opens:
        yield "lifts off the belt", "yes" if found.lifts_off else "no"
    beside = {True: "yes", False: "no", None: "up to the damping of the real brake"}[found.coexists]
    yield f"coexists with stable {'sliding' if sliding else 'rest'}", beside


def _changes(report: Facts) -> Rows:
    study, largest = report.study, report.largest
    if report.searched:
        factor = (
            f" = {report.target / largest:.3g} x {study.load_text(largest)}" if largest > 0 else ""
        )
        limits = (
            "as far as may_change allows"
            if study.may_change
            else f"by up to a factor of {LARGEST_FACTOR:g}"
        )
        slip = " at full slip" if report.reach == "faster" else ""
        kept = f"the jump at {study.load_text(report.target)}{factor}{slip}"
        yield "each of them keeps", f"{kept}, and all within the tolerances from jumping; {limits}"
    if report.searched and not report.redesign:
        yield "none", "no change of one quantity or of several was found that does it"
    for one in report.redesign:
        values = "; ".join(steps(study, one))
        then = f"then it jumps at {study.load_text(one.jump_at)}"
        if math.isnan(one.jump_at):
            looked = study.changed(one.after).search_range  # up to where depends on its units
            then = (
                "then it never jumps"
                if looked == study.loading.word
                else f"then it jumps at no {looked}"
            )
        certainty = "undecided within the tolerances: of the brakes that were tried none jumps"
        if one.outcome == "proved":
            certainty = f"proved for everything within {box(report.unbounded)}"
        yield values, f"{then}; {certainty}"


def as_json(report: Facts) -> Json:
    """The report as JSON data. Numbers that do not exist are NaN, which the command writes as
    null.
    """
    study = report.study
    state = report.current
    lives = report.oscillation
    odds = report.probability
    reached = report.certificate
    alive, jump = lives if lives and lives.alive else None, report.peak
    first = next(iter(jump.before)) if jump else ""
    unit = first.rpartition("_")[2]
    lengths = state and [value for key, value in state.places.items() if key.endswith("_mm")]

    def one(name: str, value: float) -> Json:
        return {"value": study.in_file(name, value), "unit": study.quantities[name].unit}

    def all_of(values: Numbers) -> Json:
        return {name: one(name, value) for name, value in values.items()}

    def told(value: float | None) -> Any:
        if value is None:
            return None
        if study.of_friction:
            return {"value": value, "unit": ""}
        return one(study.loading.quantity, value)

    def both(name: str) -> Json:
        return {"rest": getattr(state, name, None), "oscillation": getattr(alive, name, None)}

    plain = (
        "mu_jump",
        "theta0_jump_deg",
        "mu0_jump",
        "mu_lowest",
        "theta0_lowest_deg",
        "kind_lowest",
        "mu_cusp",
        "mu_effective",
        "margin_percent",
    )
    peak = ("spring_force_N", "contact_force_N", "lifts_off", "settles", "followed_s")
    named_apart = {"places"} if study.kind.model.has_regimes else {"places", "touching"}
    of_state = [one.name for one in fields(State) if one.name not in named_apart]
    return _some(report, plain) | {
        "states": [{**_some(each, of_state), **each.places} for each in report.states],
        "frequencies_hz": state and list(state.frequencies_hz),
        "spring_force_N": both("spring_force_N"),
        "contact_force_N": both("contact_force_N"),
        "displacement_mm": {
            "rest": lengths or None,
            "oscillation_amplitude": getattr(alive, "amplitude_mm", None),
        },
        "oscillation": lives
        and {
            **_some(lives, ("kind", "frequency_hz", "start", "lifts_off")),
            "stable": lives.kind == "cycle",
            f"amplitude_{lives.unit}": lives.amplitude,
            "coexists_with_stable_sliding": lives.coexists,
        },
        "certificate": reached
        and {
            **_some(reached, ("claim", "outcome", "undecided", "boxes")),
            "counterexample": reached.counterexample and all_of(reached.counterexample),
        },
        "probability": odds
        and {
            "value": odds.probability,
            **_some(odds, ("low", "high", "confidence", "n")),
            "proved": None if odds.proved == (0.0, 1.0) else list(odds.proved),
        },
        "sobol": odds
        and {
            name: dict(zip(("first", "total", "total_error"), shares, strict=True))
            for name, shares in odds.sobol.items()
        },
        "redesign": [
            {
                "from": all_of(change.before),
                "to": all_of(change.after),
                "jump_at": told(change.jump_at),
                "mu_jump": change.jump_at if study.of_friction else None,
                "target": told(report.target)["value"],
                **_some(change, ("distance", "probability", "outcome")),
            }
            for change in report.redesign
        ],
        "warnings": list(warnings(report)),
        "reach": report.reach or None,
        "speed_jump": None
        if study.belt is None or math.isnan(report.speed)
        else one(study.belt, report.speed),
        "jump": jump
        and {
            "friction": jump.at if study.of_friction else None,
            "at": told(jump.at),
            f"from_{unit}": jump.before[first],
            f"to_{unit}": jump.after[first],
            **jump.ranges,
            **_some(jump, peak),
        },
        "verdict": " ".join(verdict(report)),
        "folds": [
            {
                **vars(row),
                "value": told(row.value),
                "ends": row.ends or None,
                "when": row.when or None,
            }
            for row in report.fold_rows
        ],
        "vary": report.vary,
        "jump_at": told(report.jump_at),
        "other_states": [{**at, "ends_at": told(end)} for at, end in report.others],
        "next_steps": [f"{verb} {what}" for verb, what in next_steps(report)],
        "about": about(report),
    }


def _some(thing: object, names: Sequence[str]) -> Json:
    """Attributes by name as JSON data: empty texts are None, tuples lists."""
    found = {}
    for name in names:
        value = getattr(thing, name)
        if isinstance(value, tuple):
            value = list(value)
        found[name] = None if value == "" else value
    return found
