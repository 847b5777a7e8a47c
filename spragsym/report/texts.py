"""A report in words: the verdict and the text."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ..models.load import USUAL, load
from . import rises
from .facts import Facts, percent_beyond
from .fold_rows import fold_rows
from .jump_verdicts import Chance
from .jumps import AWAY
from .oscillations import Oscillation
from .states import State
from .study import Study
from .units import ENDS

#: Sobol' indices whose 95 % interval is wider to either side are not told.
RESOLVED = 0.2
#: Of the names of rows.
WIDTH = 32
#: Digits of a sentence at most.
MOST_DIGITS = 8

if TYPE_CHECKING:
    from .reports import Report


def verdict(study: Study, parts: Mapping[str, Any]) -> str:
    """Whether it sprags, at what friction, and how far that is; then, where it swings or grows, a sentence on that."""
    return f"{_on_the_jump(study, parts)}{_on_others(study, parts)}{_on_the_motion(parts)}"


def _on_others(study: Study, parts: Mapping[str, Any]) -> str:
    """Which other states are stable at the design, and where each ends."""
    told = []
    for place, end in parts["others"]:
        where = ", ".join(f"{name.rpartition('_')[0]} = {value:.4g} {name.rpartition('_')[2]}" for name, value in place.items())
        until = "" if end is None or study.rise is None else (
            f", at any {rises.looked(study)}" if math.isnan(end) else f", until {rises.named(study, end)}"
        )  # fmt: skip
        told.append(where + until)
    return f" At the design another state is stable: {'; and '.join(told)}." if told else ""


def followed_state(study: Study) -> str:
    """What the state is called that is followed."""
    if not study.state:
        return "the state of small deformation"
    units = {entry["name"]: entry["unit"] for entry in study.about["coordinates"]}
    near = ", ".join(
        f"{name} = {math.degrees(value):.4g} deg" if units[name] == "rad" else f"{name} = {1e3 * value:.4g} mm"
        for name, value in study.state.items()
    )
    return f"the state chosen near {near}"


def _on_the_motion(parts: Mapping[str, Any]) -> str:
    """What steady sliding does not say of the brake as drawn; nothing, where it comes to rest or is not known to move."""
    found: Oscillation | None = parts["oscillation"]
    here = [state for state in parts["states"] if state.current] or parts["states"]
    unstable = bool(here) and all(state.settles is False for state in here)
    if found is None or not (found.alive or found.kind == "lift-off"):
        return " Steady sliding is unstable: small disturbances grow." if unstable else ""
    beside = ", beside stable sliding" if found.coexists else ""
    if found.kind == "lift-off":
        return " From rest it lifts off the belt for good."
    if found.kind == "motion":
        return f" From rest it goes on swinging, and had not repeated itself when it was left{beside}."
    at = f"{found.frequency_hz:.4g} Hz"
    if found.start == "rest":
        return f" From rest it comes to an oscillation of {at}{beside}."
    return f" If it is disturbed far enough it oscillates at {at}{beside}."


def _on_the_jump(study: Study, parts: Mapping[str, Any]) -> str:
    so: Facts = parts["facts"]
    (low, _, high), full, jump = so.working, so.full[2], so.jump
    rise = study.rise
    model = "" if study.model == USUAL else f" with the model {study.about['name']}"
    state = followed_state(study)
    if "theta0" in study.quantities and (rise is None or rise.name != "theta0"):
        state = f"at {study.shown('theta0', study.values['theta0'])} {state}"
    if jump is None or rise is None:
        return _unknown(study, parts)
    digits = _apart(study, jump, (low, high, full))
    if so.reach in ("never", "beyond"):
        if so.reach == "never":
            what = "has no jump at this angle"
            if parts["mu_lowest"] is None or math.isinf(parts["mu_lowest"]):
                what = f"has no jump at any {so.looked}"
        else:
            what = f"jumps at {rises.named(study, jump, digits)}"
            if full:
                what += (
                    f", {percent_beyond(jump, full):.0f} % above the largest that you have, {rises.amount(study, full, digits)}"
                )
        begin = "As drawn it does not sprag" if so.within == "refuted" or so.hits else "It does not sprag"
        return f"{begin}{model}: {state} {what}{_within(study, parts)}."
    if so.reach == "faster":
        at = "the belt's speed" if study.belt is None else study.shown(study.belt, study.values[study.belt], 3)
        above = "at a higher speed" if math.isnan(so.speed) else f"above {study.shown_speed(so.speed, 3)}"
        works = f"only {high:.{digits}g} of your {full:.{digits}g}" if high < full else f"{high:.{digits}g}"
        if study.belt is not None and so.speed < study.values[study.belt]:
            above = f"at lower speeds, from {study.shown_speed(so.speed, 3)} on"
        return (
            f"It sprags{model} {above}: {state} jumps at {rises.named(study, jump, digits)}; at {at} {works} "
            f"works, and it does not jump{_within(study, parts)}."
        )
    ends = [rises.amount(study, end, digits) for end in ((low, high) if high > low else (high,))]
    where = "below your" if high == low else "already below all of your range of" if jump < low else "within your range of"
    yours = f"{where} {rise.word} {' to '.join(ends)}"
    return f"It sprags{model}: {state} jumps at {rises.named(study, jump, digits)}, {yours}{_within(study, parts)}."


def _apart(study: Study, jump: float, ends: Sequence[float]) -> int:
    """The digits, from four on, in which the jump and what it is compared with are told apart."""
    others = [end for end in ends if end != jump]
    for digits in range(4, MOST_DIGITS):
        if rises.amount(study, jump, digits) not in {rises.amount(study, end, digits) for end in others}:
            return digits
    return MOST_DIGITS


def _unknown(study: Study, parts: Mapping[str, Any]) -> str:
    """The verdict where nothing is known of a jump."""
    states: Sequence[State] = parts["states"]
    about = study.about
    where = (" of sliding" if about["friction"] else "") + (" in contact" if about["contact"]["gap"] is not None else "")
    stable = sum(state.stable for state in states)
    there = f"are {len(states)} states{where}, {stable} stable"
    if len(states) == 1:
        there = f"is one state{where}, {'stable' if stable else 'unstable'}"
    why = "whether it sprags is not known"
    if study.rise is None:
        why = "nothing is said to rise until it jumps"
    return f"With the model {about['name']} there {there}; {why}."


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
        body = lines(rows)
        if body:
            blocks.append([title, *body])
    return "\n\n".join("\n".join(block) for block in blocks)


def lines(rows: Iterable[tuple[str, str]]) -> list[str]:
    """Rows of a name and a value, under each other where the name is long."""
    return [f"  {name:<{WIDTH}}{value}" if len(name) < WIDTH else f"  {name}\n  {'':<{WIDTH}}{value}" for name, value in rows]


def sections(report: Report) -> Iterator[tuple[str, list[tuple[str, str]]]]:
    """Headings, each with rows of a name and a value."""
    for title, rows in (
        ("Jump", itertools.chain(_friction(report), _rise(report))),
        ("The jump as a motion", _peak(report)), ("State", _state(report)), ("Folds", _folds(report)),
        ("Tolerances", _tolerances(report)),
        ("Oscillation", _oscillation(report)), (_aim(report), _changes(report)),
    ):  # fmt: skip
        yield title, list(rows)


def _friction(report: Report) -> Iterator[tuple[str, str]]:
    low, working, high = report.study.friction
    if not report.study.about["friction"]:
        return
    yield ("friction at the belt's speed", f"{working:.4g}" + (f", {low:.4g} to {high:.4g}" if high > low else ""))


def _rise(report: Report) -> Iterator[tuple[str, str]]:
    """Where it jumps as what rises does, and how far that is."""
    study, so, rise = report.study, report.facts, report.study.rise
    if rise is None:
        return
    if so.slow:
        yield ("friction at full slip", f"{so.full[1]:.4g}" + (f", up to {so.full[2]:.4g}" if so.full[2] > so.full[1] else ""))
    jump, high = math.nan if report.jump_at is None else report.jump_at, so.working[2]
    never = "never" if math.isinf(so.top) else f"at no {so.looked}"
    own = "" if report.mu0_jump == report.mu_jump else f", mu0 = {report.mu0_jump:.6g}"
    at = "at this angle" if rise.is_friction else f"as {rise.word} rises"
    yield (f"jump {at}", _or_unknown(report.jump_at, lambda value: f"at {rise.word} {rises.amount(study, value, 6)}{own}", never))
    if not math.isnan(jump) and high:
        yield (f"margin to the largest {rise.word}", f"{report.margin_percent:+.1f} %")
        if so.slow:
            yield ("the same at full slip", f"{percent_beyond(jump, so.full[2]):+.1f} %")
    if study.moves and report.mu_jump is not None:
        begins = "at no speed" if math.isnan(so.speed) else f"{study.shown(str(study.belt), so.speed)}, with the largest friction"
        yield ("speed at which it begins to jump", begins)
    if "theta0" in study.quantities and rise.name != "theta0":
        yield ("jump at this friction", _or_unknown(report.theta0_jump_deg, "at {:.6g} deg".format, "never"))
    if "theta0" in study.quantities and rise.is_friction:
        lowest = _or_unknown(report.mu_lowest, "friction {:.6g}".format, "there is none")
        if report.kind_lowest:
            what = "to infinity" if report.kind_lowest == "infinity" else f"a {report.kind_lowest}"
            lowest += f", {what} at {report.theta0_lowest_deg:.6g} deg; below it it jumps at no angle"
        yield ("its lowest fold at any angle", lowest)
        if report.kind_lowest != "cusp":  # it would be said twice
            yield ("friction of the cusp", _or_unknown(report.mu_cusp, "{:.6g}".format, "there is none"))
    if not math.isnan(report.distance):
        where = "0, it has jumped already" if report.distance == 0 else "none found" if math.isinf(report.distance) else (
            f"{report.distance:.3g}, as the root of the sum of squares"
        )  # fmt: skip
        yield ("tolerances to the nearest jump", where)


def _or_unknown(value: float | None, shown: Callable[[float], str], never: str) -> str:
    """A number as it is shown, or words where there is none, or none is known."""
    if value is None:
        return "unknown"
    return shown(value) if math.isfinite(value) else never


def _springs(told: Any, shown: Callable[[Any], str]) -> Iterator[tuple[str, str]]:
    """Rows of a number of the spring, or of several by their names; none where there is no spring."""
    named = told if isinstance(told, Mapping) else {"the spring": told}
    for name, value in named.items():
        if value is not None:
            yield name, shown(value)


def _pulling(force: float) -> str:
    return f"{force:.5g} N" + (", it pushes" if force < 0 else ", it pulls" if force > 0 else "")


def _ends(ends: tuple[float, float]) -> str:
    return f"{ends[0]:.5g} N to {ends[1]:.5g} N"


def _places(places: Mapping[str, float]) -> str:
    """Coordinates with their units."""
    named = (key.rpartition("_") for key in places)
    return ", ".join(f"{name} = {value:.4g} {unit}" for (name, _, unit), value in zip(named, places.values(), strict=True))


def _state(report: Report) -> Iterator[tuple[str, str]]:
    for state in report.states:
        yield (_name(report, state), _described(state))
    here = report.current
    if here is None:
        return
    yield ("place of the mass", _places(here.places))
    for name, force in _springs(here.spring_force_N, _pulling):
        yield (f"force of {name}", force)
    if here.contact_force_N is not None:
        yield ("force of the contact", f"{here.contact_force_N:.5g} N")
    ratios = here.damping_ratio
    yield ("frequencies", ", ".join(
        f"{f:.4g} Hz (damping ratio {ratio:.2g})" if report.study.moves else f"{f:.4g} Hz"
        for f, ratio in zip(here.frequencies_hz, ratios, strict=True)
    ) or "none")  # fmt: skip


def _name(report: Report, state: State) -> str:
    here = "the state it jumped to" if report.facts.jumped else followed_state(report.study)
    if report.jump_at is None:
        here = "the state"
    return here if state.current else "another state"


def _described(state: State) -> str:
    word = "stable" if state.stable else f"unstable ({state.statics})"
    if state.settles is None:
        word = "stable but for damping, which is next to nothing: whether it settles is up to that of the real brake"
    elif not state.stable and state.statics == "stable":
        word = "unstable by the friction law's own damping"
    springs = "".join(
        f"; {name.removeprefix('the ')} at {at}" for name, at in _springs(state.direction_deg, lambda at: f"{at:.4g} deg")
    )
    first = dict(list(state.places.items())[:1])
    return f"{word}{springs}, {_places(first)}" if springs else f"{word}; {_places(first)}"


def _peak(report: Report) -> Iterator[tuple[str, str]]:
    found = report.peak
    if found is None:
        return
    first = next(iter(found.before))
    unit = first.rpartition("_")[2]
    places = f"from {_places({first: found.before[first]})} to {found.after[first]:.4g} {unit}"
    study = report.study
    faster = f" and {study.shown_speed(report.facts.speed, 3)}" if report.facts.reach == "faster" else ""
    at = f"{rises.of(study).word} {rises.amount(study, found.at)}"
    yield ("the states before and after", f"at {at}{faster}, {places}")
    yield ("let go at rest", f"{100 * AWAY:g} % of the way beyond the fold")
    for key, (least, most) in found.ranges.items():
        name, _, unit = key.rpartition("_")
        yield (f"range of {name}", f"{least:.4g} {unit} to {most:.4g} {unit}")
    for name, force in _springs(found.spring_force_N, _ends):
        yield (f"force of {name}", force)
    if found.contact_force_N is not None:
        yield ("force of the contact", _ends(found.contact_force_N))
    ends_in = {
        "rest": "it settles at rest", "cycle": "it goes over into an oscillation", "lift-off": "it lifts off for good",
        "unsettled": f"it still swings after {found.followed_s:.3g} s",
    }  # fmt: skip
    yield ("then", ends_in[found.settles])


def _folds(report: Report) -> Iterator[tuple[str, str]]:
    for row in fold_rows(report):
        if row.value is not None:
            name = f"{report.vary} {rises.amount(report.study, row.value, 5)}"
        elif row.friction is not None:
            name = f"friction {row.friction:.5g}"
        else:
            name = f"inclination {row.inclination_deg:.5g} deg"
        if row.kind != "fold":
            yield (name, f"a {row.kind}")
            continue
        if row.ends in ("", "undecided") or row.when == "undecided":
            open_ = "which of them ends, and when, is not decided"
            yield (name, f"two states meet; {open_}" if row.ends else "two states meet, neither of them stable")
            continue
        key = next(iter(row.before))
        coordinate, _, unit = key.rpartition("_")
        goes = f"{coordinate} goes from {row.before[key]:.4g} {unit} to {row.after[key]:.4g} {unit}"
        nothing = "nothing is left in contact" if load(report.study.model).about["contact"]["unilateral"] else "nothing is left"
        left = nothing if math.isnan(row.after[key]) else goes
        yield (name, f"the {row.ends} state ends as it {'rises' if row.when == 'up' else 'falls'}; {left}")


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
        yield from _chance(odds, ", and at least one brake" if _one_corner(so) else "")


def no_jump(unbounded: Sequence[str]) -> str:
    """The claim of a certificate, as a row's name."""
    return f"no jump within {box(unbounded)}" if unbounded else "no jump within all of them"


def _chance(odds: Chance | None, more: str = "") -> Iterator[tuple[str, str]]:
    """The probability with its interval and its proved bounds, and what decides."""
    if odds is not None:
        ends = f"{_percent(odds.low)} to {_percent(odds.high)} with confidence {odds.confidence:g}"
        yield ("probability of a jump", f"{share(odds)}, {ends}{more}")
        if odds.proved != (0.0, 1.0):
            low, high = (math.floor(1e4 * odds.proved[0]) / 1e2, math.ceil(1e4 * odds.proved[1]) / 1e2)
            yield (
                "the same by proof",
                f"{low:g} % to {high:g} %: what is proved to jump, and all but what is proved not to; no sampling can leave that",
            )
        yield from _indices(odds)


def _indices(odds: Chance) -> Iterator[tuple[str, str]]:
    """Sobol' indices, where the samples resolve all of them: next to a certainty too few differ."""
    told = {name: indices for name, indices in odds.sobol.items() if not math.isnan(indices[1])}
    if any(not error <= RESOLVED for *_, error in told.values()):
        yield ("how much each of them decides", f"not told by {odds.n} samples, of which too few differ")
        return
    for name, (first, total, _) in told.items():
        # A share is not negative; what is estimated from samples may be.
        alone, together = (max(0.0, 100 * share) for share in (first, total))
        shares = f"{alone:.0f} % by itself, {together:.0f} % with what it does together with others"
        yield (f"how much {name} decides", shares)


def _one_corner(so: Facts) -> bool:
    return so.within == "refuted" and so.hits is False


def _never(report: Report, after: Mapping[str, float]) -> str:
    """Of a change where no jump was found: that depends on its units up to where one was looked for."""
    looked = rises.looked(report.study.changed(after))
    return "then it never jumps" if looked == rises.of(report.study).word else f"then it jumps at no {looked}"


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
    yield ("amplitude along the belt" if found.unit == "mm" else "amplitude", f"{found.amplitude:.4g} {found.unit}")
    for name, force in _springs(found.spring_force_N, _ends):
        yield (f"force of {name}", force)
    if found.contact_force_N is not None:
        yield ("force of the contact", _ends(found.contact_force_N))
    if report.study.about["contact"]["unilateral"]:
        yield ("lifts off the belt", "yes" if found.lifts_off else "no")
    beside = {True: "yes", False: "no", None: "up to the damping of the real brake"}[found.coexists]
    yield ("coexists with stable sliding", beside)


def _aim(report: Report) -> str:
    faster, study = report.facts.reach == "faster", report.study
    largest = report.facts.full[2] if faster else report.facts.working[2]
    factor = f" = {report.target / largest:.3g} x {rises.amount(study, largest)}" if largest > 0 else ""
    where = " at full slip" if faster else ""
    kept = f"the jump at {rises.amount(study, report.target)}{factor}"
    return f"To keep {kept}, and all within the tolerances from jumping{where}, change"


def _changes(report: Report) -> Iterator[tuple[str, str]]:
    if report.needed and not report.redesign:
        yield "nothing", "no change of one quantity or of several was found that does it"
    study, within = report.study, box(report.facts.unbounded)
    for one in report.redesign:
        values = "; ".join(
            f"{name} from {study.shown(name, one.before[name])} to {study.shown(name, one.after[name])}" for name in one.after
        )
        then = _never(report, one.after) if math.isnan(one.jump_at) else f"then it jumps at {rises.amount(study, one.jump_at)}"
        known = "undecided within the tolerances: of the brakes that were tried none jumps"
        if one.outcome == "proved":
            known = f"proved for everything within {within}"
        yield values, f"{then}; {known}"
