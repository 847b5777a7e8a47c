"""Every sentence of a report, said of facts that are set by hand."""

import copy
import dataclasses
import math
from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np
import pytest
import scipy.optimize

import spragsym as ss
from spragsym.design.probability import JumpProbability
from spragsym.models.quantities import quantities
from spragsym.report import facts, texts
from spragsym.report.damping import remedy
from spragsym.report.facts import Facts, FoldRow
from spragsym.report.friction_fit import FrictionFit, fit_friction
from spragsym.report.redesigns import Change
from spragsym.report.states import JumpPeak, Oscillation, State, states
from spragsym.report.study import Study

#: The quantities of a brake in SI.
BRAKE: Mapping[str, float] = {
    "m": 0.35,
    "k": 180e3,
    "k_x": 9e3,
    "k_y": 0.0,
    "k_c": 1.5e6,
    "F_L": 420.0,
    "L_0": 0.038,
    "theta0": math.radians(52),
    "mu0": 0.3,
    "V": 1.2,
    "d": 10.0,
}


def brake(tolerance: Mapping[str, Any] = {}, **changes: Any) -> ss.Study:  # read only
    """A study of the brake with other quantities; those that are None are left out."""
    options = {key: changes.pop(key) for key in ("vary", "begin", "state") if key in changes}
    values = {name: value for name, value in {**BRAKE, **changes}.items() if value is not None}
    return ss.Study(values, tolerance, **options)


def named(study: ss.Study, **about: Any) -> ss.Study:
    """The study of a file: with a title, a date, a fit."""
    return ss.Study.of(**vars(study) | about)


EXACT = brake()
#: Of a law of friction without mu0.
STRIBECK = ss.Study(
    {
        **{name: BRAKE[name] for name in BRAKE if name != "mu0"},
        "mu_s": 0.45,
        "mu_k": 0.3,
        "v_s": 0.5,
    },
    model="stribeck",
)
DAMPED = ss.Study(BRAKE, model="damped", damping_ratio=0.005)
LOOSE = brake({"k": "15 %", "mu0": (0.28, 0.32)})
SPREAD = brake({"k": "sd 5 %", "mu0": (0.28, 0.32)})
SLOW = brake(V=0.2)
UNKNOWN = brake(V=None, d=None)
# Where a search for their jumps would end is that of the brake as drawn: without an end.
LOAD = named(brake(vary="F_L", begin=50.0), ends=EXACT.ends)
CHOSEN = named(brake(state={"x": 0.05}), ends=EXACT.ends)
FILE = named(EXACT, source="brake.toml", title="Front brake", date="2026-03-01")
FRAME = ss.Study(
    {"m": 1.0, "k": 100.0, "k_c": 100.0, "k_x": 80.0, "k_y": 0.0, "F_L": 1.0, "mu0": 0.2},
    model="mode_coupling",
)


def otherwise(study: ss.Study, **said: Any) -> ss.Study:
    """A study of whose model the page says something else."""
    kind = copy.copy(study.kind)
    vars(kind).update(said)
    return named(study, kind=kind)


#: A brake on whose page is no friction, and one whose law is not proportional to mu0.
RESTS = otherwise(EXACT, about={**EXACT.kind.about, "frictions": []})
OTHER = otherwise(EXACT, law={**EXACT.kind.law, "at_rest": "other"})
#: Of quantities with tolerances that are not cut off.
BOTH = brake({"k": "sd 5 %", "k_x": "sd 5 %"})


#: The state that the brake is in.
state = partial(
    dataclasses.replace,
    State(
        current=True,
        stability="stable",
        undamped="stable",
        direction_deg=57.04,
        places={"x_mm": 3.68, "y_mm": -0.4577},
        spring_length_mm=36.0,
        spring_force_N=-317.66,
        contact_force_N=686.53,
        frequencies_hz=(44.35, 345.9),
        damping_ratio=(0.021, 0.003),
        growth_per_s=-1.0,
    ),
)


#: A cycle from rest.
oscillation = partial(
    dataclasses.replace,
    Oscillation(
        kind="cycle",
        frequency_hz=41.234567,
        amplitude=2.5,
        unit="mm",
        spring_force_N=(-400.0, 120.0),
        contact_force_N=(0.0, 900.0),
        coexists=True,
        start="rest",
        motion=None,
    ),
)


def odds(probability: float, low: float, high: float, **changes: Any) -> JumpProbability:
    """A probability by samples; by default k decides most."""
    given: dict[str, Any] = {
        "first": {"k": 0.25},
        "total": {"k": 0.75},
        "first_error": {"k": 0.01},
        "total_error": {"k": 0.02},
    }
    return JumpProbability(probability, low, high, 0.95, 4096, 0.0, **given | changes)


def proof(
    outcome: str, counterexample: Mapping[str, float] | None = None
) -> ss.results.Certificate:
    return ss.results.Certificate("no jump", outcome, counterexample, 0.0, 0)


#: A change that is proved.
change = partial(
    dataclasses.replace,
    Change(
        before={"k": 180e3},
        after={"k": 150e3},
        jump_at=0.41,
        distance=1.0,
        probability=0.0,
        outcome="proved",
    ),
)


#: A fold at which the lower state ends.
fold = partial(
    dataclasses.replace,
    FoldRow(
        kind="fold",
        friction=0.36627,
        inclination_deg=None,
        value=None,
        ends="lower",
        when="up",
        before={"x_mm": 7.797},
        after={"x_mm": 43.55},
        unstable=0,
    ),
)


#: The jump as a motion.
peak = partial(
    dataclasses.replace,
    JumpPeak(
        at=0.3663,
        before={"x_mm": 7.797},
        after={"x_mm": 43.55},
        ranges={"x_mm": (7.5, 80.25)},
        spring_force_N=(-300.5, 200.25),
        contact_force_N=(0.0, 1500.0),
        lifts_off=True,
        settles="rest",
        followed_s=0.75,
    ),
)


#: A fit of many measurements.
fit = partial(
    dataclasses.replace,
    FrictionFit(
        mu0=0.4,
        d=8.0,
        mu0_error=0.01,
        d_error=0.2,
        correlation=-0.8,
        rms=0.001,
        points=30,
        slowest=0.02,
        fastest=1.5,
    ),
)


FACTS = Facts(
    study=EXACT,
    jump_parameter=0.3663,
    jump_at=0.3663,
    speed=math.nan,
    reach="beyond",
    states=(state(),),
    states_complete=True,
    others=(),
    oscillation=None,
    certificate=None,
    probability=None,
    folds={},
    fold_rows=(),
    theta0_jump_deg=56.49842,
    mu_lowest=0.1567901,
    theta0_lowest_deg=70.59712,
    kind_lowest="cusp",
    mu_cusp=0.1567901,
    distance=math.nan,
    peak=None,
    largest=0.3,
    target=0.36,
    searched=False,
    redesign=(),
    remarks=(),
)


def said_of(study: Study = EXACT, **known: Any) -> Facts:
    """Facts of a brake that jumps at more friction than it has, with some of them replaced."""
    return dataclasses.replace(FACTS, study=study, **known)


def lying(**changes: Any) -> Facts:
    """Facts with another state."""
    return said_of(states=(state(**changes),))


def moving(**changes: Any) -> Facts:
    """Facts with a motion, by default a cycle from rest."""
    return said_of(oscillation=oscillation(**changes))


def jumping(**changes: Any) -> Facts:
    """Facts with the jump as a motion."""
    return said_of(peak=peak(**changes))


def folded(**changes: Any) -> Facts:
    """Facts with a fold."""
    return said_of(fold_rows=(fold(**changes),))


NEVER: Any = {"jump_at": math.nan, "jump_parameter": math.nan, "reach": "never"}
JUMPED: Any = {"jump_at": 0.25, "jump_parameter": 0.25, "reach": "jumped"}
FASTER: Any = {"jump_at": 0.29, "jump_parameter": 0.29, "reach": "faster"}
NOTHING: Any = {"jump_at": None, "jump_parameter": None, "reach": ""}
LIVES: Any = {"oscillation": oscillation()}

#: Facts, and a sentence of the verdict on them.
VERDICTS: list[tuple[Facts, str]] = [
    (
        said_of(),
        "It does not sprag: at 52 deg the reference state jumps at a friction of 0.3663, 22 % "
        "above the largest that you have, 0.3.",
    ),
    (
        said_of(LOOSE),
        "As drawn it does not sprag: at 52 deg the reference state jumps at a friction of "
        "0.3663, 14 % above the largest that you have, 0.32.",
    ),
    (
        said_of(**NEVER),
        "It does not sprag: at 52 deg the reference state has no jump at any friction.",
    ),
    (
        said_of(CHOSEN, **NEVER),
        "It does not sprag: at 52 deg the state chosen near x = 50 mm has no jump at any friction.",
    ),
    (
        said_of(**JUMPED),
        "It sprags: at 52 deg the reference state jumps at a friction of 0.25, below your "
        "friction 0.3.",
    ),
    (
        said_of(SLOW, kind_jump="border", speed=0.34, **FASTER),
        "It loses its contact above V = 0.34 m/s: at 52 deg the reference state leaves the contact at a "
        "friction of 0.29; at 0.2 m/s only 0.2594 of your 0.3 works, and it does not lose it.",
    ),
    (
        said_of(jump_at=0.2999981, reach="jumped"),
        "It sprags: at 52 deg the reference state jumps at a friction of 0.2999981, below your"
        " friction 0.2999982.",
    ),
    (
        said_of(LOOSE, **JUMPED),
        "It sprags: at 52 deg the reference state jumps at a friction of 0.25, already below "
        "all of your range of friction 0.28 to 0.32.",
    ),
    (
        said_of(LOOSE, jump_at=0.31, reach="within"),
        "It sprags: at 52 deg the reference state jumps at a friction of 0.31, within your "
        "range of friction 0.28 to 0.32.",
    ),
    (
        said_of(LOOSE, jump_at=0.319999, reach="within"),
        "It sprags: at 52 deg the reference state jumps at a friction of 0.319999, within your"
        " range of friction 0.279998 to 0.319998.",
    ),
    (
        said_of(LOAD, jump_at=400.0, reach="jumped"),
        "It sprags: at 52 deg the reference state jumps at F_L = 400 N, below your F_L 420 N.",
    ),
    (
        said_of(SLOW, **FASTER, speed=0.34),
        "It sprags above V = 0.34 m/s: at 52 deg the reference state jumps at a friction of "
        "0.29; at 0.2 m/s only 0.2594 of your 0.3 works, and it does not jump.",
    ),
    (
        said_of(SLOW, **FASTER, speed=0.1),
        "It sprags at lower speeds, from V = 0.1 m/s on: at 52 deg the reference state jumps "
        "at a friction of 0.29; at 0.2 m/s only 0.2594 of your 0.3 works, and it does not "
        "jump.",
    ),
    (
        said_of(SLOW, **FASTER),
        "It sprags at a higher speed: at 52 deg the reference state jumps at a friction of "
        "0.29; at 0.2 m/s only 0.2594 of your 0.3 works, and it does not jump.",
    ),
    (
        said_of(**NOTHING),
        "With the model kang_nam there is one state of sliding in contact, stable; whether it "
        "sprags is not known.",
    ),
    (
        said_of(**NOTHING, states=(state(), state(current=False, stability="unstable"))),
        "With the model kang_nam there are 2 states of sliding in contact, 1 unstable; whether "
        "it sprags is not known.",
    ),
    (
        said_of(named(EXACT, load=None), **NOTHING, states=(state(stability="unstable"),)),
        "With the model kang_nam there is one state of sliding in contact, unstable; nothing "
        "is said to rise until it jumps.",
    ),
    (
        said_of(FRAME, **NEVER),
        "It does not sprag with the model mode_coupling: the reference state has no jump at "
        "any friction up to 10.",
    ),
    (
        said_of(others=(({"x_mm": 42.99}, None),)),
        "At the design another state is stable: x = 42.99 mm.",
    ),
    (
        said_of(others=(({"x_mm": 42.99}, math.nan), ({"x_mm": 5.0}, 0.4))),
        "At the design another state is stable: x = 42.99 mm, at any friction; and x = 5 mm, "
        "until a friction of 0.4.",
    ),
    (
        lying(stability="unstable", growth_per_s=5.0, damping_ratio=(-0.1, 0.003)),
        "Steady sliding is unstable: small disturbances grow.",
    ),
    (
        moving(kind="lift-off"),
        "From rest it lifts off the belt for good.",
    ),
    (
        moving(kind="lift-off", start="far out"),
        "From far out it lifts off the belt for good.",
    ),
    (said_of(**LIVES), "From rest it comes to an oscillation of 41.23 Hz, beside stable sliding."),
    (
        moving(coexists=False),
        "From rest it comes to an oscillation of 41.23 Hz.",
    ),
    (
        moving(kind="motion", start="far out"),
        "From far out it goes on swinging, and had not repeated itself when it was left, "
        "beside stable sliding.",
    ),
    (
        moving(start="far out", coexists=False),
        "Small disturbances grow; from far out it comes to an oscillation of 41.23 Hz.",
    ),
    (
        moving(start="far out"),
        "If it is disturbed far enough it oscillates at 41.23 Hz, beside stable sliding.",
    ),
    (
        moving(start="far out", coexists=None),
        "If it is disturbed far enough it oscillates at 41.23 Hz.",
    ),
    (said_of(certificate=proof("proved")), "That it does not sprag is proved."),
    (said_of(LOOSE, certificate=proof("proved")), "Proved: nothing within the tolerances sprags."),
    (
        said_of(SPREAD, certificate=proof("proved")),
        "Proved: nothing within the tolerances, and 3 standard deviations of k sprags.",
    ),
    (
        said_of(brake({"k": "1 %"}, V=0.2), **FASTER, certificate=proof("proved")),
        "Proved at this speed: nothing within the tolerances sprags.",
    ),
    (said_of(certificate=proof("undecided")), "A proof was not found."),
    (
        said_of(LOOSE, certificate=proof("undecided"), probability=odds(0.0, 0.0, 0.001)),
        "Of 4096 brakes within the tolerances none sprags; a proof for all of them was not found.",
    ),
    (
        said_of(LOOSE, probability=odds(0.1234, 0.11, 0.14)),
        "Within the tolerances 12.3 % of all brakes sprag.",
    ),
    (
        said_of(LOOSE, probability=odds(1.0, 0.9987, 1.0)),
        "Within the tolerances more than 99.9 % of all brakes sprag.",
    ),
    (
        said_of(LOOSE, probability=odds(0.99999, 0.99, 1.0)),
        "Within the tolerances 99.999 % of all brakes sprag.",
    ),
    (
        said_of(LOOSE, certificate=proof("refuted"), probability=odds(0.0, 0.0, 0.00123)),
        "Within the tolerances fewer than 0.123 % of all brakes sprag, and at least one does.",
    ),
    (
        said_of(SLOW, **FASTER, probability=odds(0.2, 0.1, 0.3)),
        "Within the tolerances at this speed 20 % of all brakes sprag.",
    ),
    (
        said_of(
            RESTS,
            states=(state(stability="unstable", growth_per_s=5.0, damping_ratio=(-0.1, 0.003)),),
        ),
        "Rest is unstable: small disturbances grow.",
    ),
    (
        said_of(RESTS, **LIVES),
        "From rest it comes to an oscillation of 41.23 Hz, beside stable rest.",
    ),
    (
        said_of(BOTH, certificate=proof("proved")),
        "Proved: nothing within the tolerances, and 3 standard deviations of k_x and k sprags.",
    ),
]


#: A brake on whose page is no friction, and one whose law is not proportional to mu0.

#: Of each heading facts, the name of a row, and its value.
ROWS: dict[str, list[tuple[Facts, str, str]]] = {
    "State": [
        (said_of(), "the reference state", "stable; spring at 57.04 deg, x = 3.68 mm"),
        (said_of(**JUMPED), "the state it jumped to", "stable; spring at 57.04 deg, x = 3.68 mm"),
        (said_of(**NOTHING), "the state", "stable; spring at 57.04 deg, x = 3.68 mm"),
        (
            said_of(CHOSEN),
            "the state chosen near x = 50 mm",
            "stable; spring at 57.04 deg, x = 3.68 mm",
        ),
        (
            lying(current=False, stability="unstable", undamped="divergent", direction_deg=None),
            "another state",
            "unstable (divergent without damping); x = 3.68 mm",
        ),
        (
            lying(stability="neutral", damping_ratio=(1e-7, 0.003)),
            "the reference state",
            "neutral: the damping of the real brake decides whether it "
            "settles; spring at 57.04 deg, x = 3.68 mm",
        ),
        (
            lying(stability="unstable", growth_per_s=2.0, damping_ratio=(-0.1, 0.003)),
            "the reference state",
            "unstable (stable without damping); spring at 57.04 deg, x = 3.68 mm",
        ),
        (
            lying(direction_deg={"left": 40.0, "right": 50.0}),
            "the reference state",
            "stable; left at 40 deg; right at 50 deg, x = 3.68 mm",
        ),
        (said_of(), "place of the mass", "x = 3.68 mm, y = -0.4577 mm"),
        (said_of(), "force of the spring", "-317.66 N, it pushes"),
        (lying(spring_force_N=20.5), "force of the spring", "20.5 N, it pulls"),
        (lying(spring_force_N={"left": 0.0}), "force of left", "0 N"),
        (said_of(), "force of the contact", "686.53 N"),
        (
            said_of(),
            "frequencies",
            "44.35 Hz (damping ratio 0.021), 345.9 Hz (damping ratio 0.003)",
        ),
        (
            lying(frequencies_hz=(44.35, 2345.6), damping_ratio=(-3e-7, 0.003)),
            "frequencies",
            "44.35 Hz (next to no damping), 2.346 kHz (damping ratio 0.003)",
        ),
        (
            said_of(DAMPED),
            "dampers, for a ratio of 0.5 %",
            "c_x = 1.347 N s/m, c_y = 7.074 N s/m, c_s = 0.6913 N s/m",
        ),
        (said_of(UNKNOWN), "frequencies", "44.35 Hz, 345.9 Hz"),
        (lying(frequencies_hz=(), damping_ratio=()), "frequencies", "none"),
    ],
    "Folds": [
        (
            folded(),
            "friction 0.36627",
            "the lower state ends as it rises; x goes from 7.797 mm to 43.55 mm",
        ),
        (
            folded(when="down", after={"x_mm": math.nan}),
            "friction 0.36627",
            "the lower state ends as it falls; nothing is left in contact",
        ),
        (
            said_of(FRAME, fold_rows=(fold(after={"x_mm": math.nan}),)),
            "friction 0.36627",
            "the lower state ends as it rises; nothing is left",
        ),
        (
            folded(friction=None, inclination_deg=56.498),
            "inclination 56.498 deg",
            "the lower state ends as it rises; x goes from 7.797 mm to 43.55 mm",
        ),
        (
            said_of(LOAD, fold_rows=(fold(friction=None, value=400.0, kind="pitchfork"),)),
            "F_L 400 N",
            "a pitchfork",
        ),
        (
            folded(ends=""),
            "friction 0.36627",
            "two states meet, neither of them stable",
        ),
        (
            folded(when="undecided"),
            "friction 0.36627",
            "two states meet; which of them ends, and when, is not decided",
        ),
    ],
    "Jump": [
        (said_of(), "friction at the belt's speed", "0.3"),
        (said_of(LOOSE), "friction at the belt's speed", "0.3, 0.28 to 0.32"),
        (said_of(SLOW), "friction at full slip", "0.3"),
        (said_of(brake({"mu0": (0.28, 0.32)}, V=0.2)), "friction at full slip", "0.3, up to 0.32"),
        (said_of(), "jump at this angle", "at friction 0.3663"),
        (said_of(jump_parameter=0.4), "jump at this angle", "at friction 0.3663, mu0 = 0.4"),
        (said_of(**NEVER), "jump at this angle", "never"),
        (said_of(**NOTHING), "jump at this angle", "unknown"),
        (said_of(LOAD, jump_at=400.0), "jump as F_L rises", "at F_L 400 N"),
        (said_of(), "margin to the largest friction", "+22.1 %"),
        (said_of(LOOSE, **JUMPED), "margin to the largest friction", "-21.9 %"),
        (said_of(SLOW), "the same at full slip", "+22.1 %"),
        (said_of(), "speed at which it begins to jump", "at no speed"),
        (
            said_of(SLOW, **FASTER, speed=0.34),
            "speed at which it begins to jump",
            "0.34 m/s, with the largest friction",
        ),
        (said_of(), "jump at this friction", "at 56.4984 deg"),
        (said_of(theta0_jump_deg=math.nan), "jump at this friction", "never"),
        (
            said_of(kind_theta0_jump="border"),
            "jump at this friction",
            "none: it leaves the contact at 56.4984 deg",
        ),
        (
            said_of(kind_jump="infinity"),
            "jump at this angle",
            "none: it runs to infinity at friction 0.3663",
        ),
        (said_of(theta0_jump_deg=None), "jump at this friction", "unknown"),
        (
            said_of(),
            "least friction at which it ends",
            "friction 0.15679, a cusp at 70.5971 deg; below this friction it ends at no angle",
        ),
        (
            said_of(kind_lowest="infinity"),
            "least friction at which it ends",
            "friction 0.15679, to infinity at 70.5971 deg; below this friction it ends at no angle",
        ),
        (
            said_of(kind_lowest="", mu_lowest=math.inf),
            "least friction at which it ends",
            "there is none",
        ),
        (said_of(kind_lowest="turn", mu_cusp=0.2), "friction of the cusp", "0.2"),
        (said_of(kind_lowest="turn", mu_cusp=math.inf), "friction of the cusp", "there is none"),
        (said_of(distance=math.inf), "tolerances to the nearest jump", "none found"),
        (
            said_of(distance=2.3456),
            "tolerances to the nearest jump",
            "2.35, as the root of the sum of squares",
        ),
        (said_of(distance=0.0), "tolerances to the nearest jump", "0, it has jumped already"),
        (said_of(FRAME, **NEVER), "jump", "at no friction up to 10"),
    ],
    "The jump as a motion": [
        (
            jumping(),
            "the states before and after",
            "at friction 0.3663, from x = 7.797 mm to 43.55 mm",
        ),
        (
            said_of(SLOW, **FASTER, speed=0.34, peak=peak()),
            "the states before and after",
            "at friction 0.3663 and V = 0.34 m/s, from x = 7.797 mm to 43.55 mm",
        ),
        (jumping(), "let go at rest", "1 % of the way beyond the fold"),
        (jumping(), "range of x", "7.5 mm to 80.25 mm"),
        (jumping(), "force of the spring", "-300.5 N to 200.25 N"),
        (jumping(), "force of the contact", "0 N to 1500 N"),
        (jumping(), "then", "it settles at rest"),
        (jumping(settles="cycle"), "then", "it goes over into an oscillation"),
        (jumping(settles="lift-off"), "then", "it lifts off for good"),
        (jumping(settles="unsettled"), "then", "it still swings after 0.75 s"),
    ],
    "Oscillation": [
        (said_of(**LIVES), "from rest", "a cycle, stable"),
        (
            moving(start="far out"),
            "from rest",
            "no cycle was reached in the time that was looked at",
        ),
        (moving(start="far out"), "from far out", "a cycle, stable"),
        (
            moving(kind="motion"),
            "from rest",
            "a motion that has not repeated itself",
        ),
        (moving(kind="rest"), "from rest", "none: it decays to rest"),
        (
            moving(kind="grows"),
            "from rest",
            "none was found: the motion grew larger and larger, and was not followed further",
        ),
        (
            moving(kind="falls"),
            "from rest",
            "none was found: the motion became smaller and smaller, and was not followed to its end",
        ),
        (
            moving(kind="lift-off"),
            "from rest",
            "none: it lifts off the belt for good",
        ),
        (said_of(**LIVES), "frequency", "41.235 Hz"),
        (said_of(**LIVES), "amplitude along the belt", "2.5 mm"),
        (moving(unit="deg"), "amplitude", "2.5 deg"),
        (said_of(**LIVES), "force of the spring", "-400 N to 120 N"),
        (said_of(**LIVES), "lifts off the belt", "yes"),
        (moving(contact_force_N=(5.0, 9.0)), "lifts off the belt", "no"),
        (said_of(**LIVES), "coexists with stable sliding", "yes"),
        (moving(coexists=False), "coexists with stable sliding", "no"),
        (
            moving(coexists=None),
            "coexists with stable sliding",
            "up to the damping of the real brake",
        ),
        (said_of(RESTS, **LIVES), "coexists with stable rest", "yes"),
    ],
    "Tolerances": [
        (said_of(LOOSE, certificate=proof("proved")), "no jump within all of them", "proved"),
        (
            said_of(SPREAD, certificate=proof("undecided")),
            "no jump within the tolerances, and 3 standard deviations of k",
            "undecided",
        ),
        (
            said_of(LOOSE, certificate=proof("refuted", {"k": 170e3, "mu0": 0.32, "m": 1.0})),
            "a brake within them that jumps",
            "k = 170 N/mm, mu0 = 0.32",
        ),
        (
            said_of(certificate=proof("refuted", {"m": 0.35})),
            "a brake within them that jumps",
            "the brake itself",
        ),
        (
            said_of(LOOSE, certificate=proof("proved"), probability=odds(0.0, 0.0, 0.0)),
            "probability of a jump",
            "0, as is proved",
        ),
        (
            said_of(LOOSE, probability=odds(0.1234, 0.11, 0.14)),
            "probability of a jump",
            "12.3 %, 11 % to 14 % with confidence 0.95",
        ),
        (
            said_of(LOOSE, certificate=proof("refuted"), probability=odds(0.0, 0.0, 0.001)),
            "probability of a jump",
            "fewer than 0.1 %, 0 % to 0.1 % with confidence 0.95, and at least one brake",
        ),
        (
            said_of(LOOSE, probability=odds(0.12, 0.1, 0.14, proved=(0.10001, 0.15001))),
            "the same by proof",
            "10 % to 15.01 %: what is proved to jump, and all but what is proved not to; no "
            "sampling can leave that",
        ),
        (
            said_of(LOOSE, probability=odds(0.12, 0.1, 0.14, proved=(0.05, 0.997))),
            "the same by proof",
            "5 % to 99.7 %: what is proved to jump, and all but what is proved not to; most of the "
            "brakes within the tolerances are not decided",
        ),
        (
            said_of(LOOSE, probability=odds(0.12, 0.1, 0.14)),
            "how much k decides",
            "25 % of the variance alone, 75 % with interactions (Sobol')",
        ),
        (
            said_of(LOOSE, probability=odds(0.12, 0.1, 0.14, first={"k": -0.1})),
            "how much k decides",
            "0 % of the variance alone, 75 % with interactions (Sobol')",
        ),
        (
            said_of(LOOSE, probability=odds(0.12, 0.1, 0.14, total_error={"k": 0.3})),
            "how much each of them decides",
            "not told by 4096 samples, of which too few differ",
        ),
    ],
    "Changes": [
        (
            said_of(searched=True),
            "each of them keeps",
            "the jump at 0.36 = 1.2 x 0.3, and all within the tolerances from jumping; by up to a "
            "factor of 3",
        ),
        (
            said_of(SLOW, **FASTER, searched=True),
            "each of them keeps",
            "the jump at 0.36 = 1.2 x 0.3 at full slip, and all within the tolerances from "
            "jumping; by up to a factor of 3",
        ),
        (
            said_of(named(EXACT, may_change={"k": (1e5, 2e5)}), searched=True, largest=0.0),
            "each of them keeps",
            "the jump at 0.36, and all within the tolerances from jumping; as far as may_change allows",
        ),
        (
            said_of(searched=True),
            "none",
            "no change of one quantity or of several was found that does it",
        ),
        (
            said_of(searched=True, redesign=(change(),)),
            "k from 180 N/mm to 150 N/mm",
            "then it jumps at 0.41; proved for everything within the tolerances",
        ),
        (
            said_of(searched=True, redesign=(change(jump_at=math.nan, outcome="undecided"),)),
            "k from 180 N/mm to 150 N/mm",
            "then it never jumps; undecided within the tolerances: of the brakes that were tried "
            "none jumps",
        ),
        (
            said_of(FRAME, searched=True, redesign=(change(jump_at=math.nan),)),
            "k from 180 N/mm to 150 N/mm",
            "then it jumps at no friction up to 10; proved for everything within the tolerances",
        ),
        (
            said_of(
                searched=True,
                redesign=(
                    change(
                        before={"k": 180e3, "k_x": 9e3},
                        after={"k": 150e3, "k_x": 8e3},
                    ),
                ),
            ),
            "k from 180 N/mm to 150 N/mm; k_x from 9 N/mm to 8 N/mm",
            "then it jumps at 0.41; proved for everything within the tolerances",
        ),
    ],
    "Warnings": [
        (said_of(remarks=("a remark",)), "1.", "a remark"),
    ],
    "What to do next": [
        (
            said_of(FILE),
            "run",
            "spragsym explore --data brake.toml, to walk over the folds and let it move",
        ),
        (
            said_of(STRIBECK, **NOTHING),
            "name",
            'what rises until it jumps, in the file, as vary = "theta0"',
        ),
        (
            said_of(searched=True, redesign=(change(),)),
            "change",
            "k from 180 N/mm to 150 N/mm: then it jumps at 0.41, proved for all tolerances",
        ),
        (
            said_of(searched=True, redesign=(change(jump_at=math.nan, outcome="undecided"),)),
            "change",
            "k from 180 N/mm to 150 N/mm: then it does not jump",
        ),
        (
            said_of(searched=True),
            "allow",
            "wider ranges in may_change, or smaller tolerances: no change within them was found "
            "that keeps it from jumping",
        ),
        (
            said_of(LOOSE, jump_at=0.31, reach="within"),
            "narrow",
            "the friction, 0.28 to 0.32, to less than 0.31",
        ),
        (
            said_of(LOOSE, probability=odds(0.12, 0.1, 0.14)),
            "narrow",
            "the tolerance of k: it decides most, 75% of the variance with interactions",
        ),
        (
            said_of(UNKNOWN),
            "measure",
            'V and d, and add V = "1.2 m/s" and d = "10 s/m": then its motion is followed too',
        ),
        (
            lying(stability="neutral", damping_ratio=(1e-7, 0.003)),
            "measure",
            "the damping of the real brake at 44.35 Hz, of which the model has "
            'next to none: write damping_ratio = "0.5 %" or what you measured',
        ),
        (
            said_of(FILE, states=(state(stability="unstable", damping_ratio=(-0.1, 0.003)),)),
            "find",
            "the V at which sliding becomes stable: spragsym bifurcation --data brake.toml --vary V",
        ),
        (
            said_of(),
            "measure",
            "how far k_c, L_0, theta0, mu0 and 5 more may be off: without a tolerance they are "
            "taken as exact",
        ),
        (
            said_of(others=(({"x_mm": 42.99}, None),)),
            "decide",
            'which stable state the brake works in; for the other one write state = { x = "43 mm" }',
        ),
        (
            said_of(
                redesign=(
                    change(
                        before={"k": 180e3, "k_x": 9e3},
                        after={"k": 150e3, "k_x": 8e3},
                    ),
                ),
            ),
            "change",
            "k from 180 N/mm to 150 N/mm and k_x from 9 N/mm to 8 N/mm: then it jumps at 0.41, "
            "proved for all tolerances",
        ),
    ],
}


#: Facts, and a warning of them.
WARNINGS: list[tuple[Facts, str]] = [
    (
        lying(places={"x_mm": 1.0, "y_mm": -2.5}),
        "the contact is 2.5 mm deep; it is linear up to 5% of L_0: check F_L and k_c",
    ),
    (
        said_of(states=(state(), state(current=False, places={"x_mm": 1.0, "y_mm": -2.5}))),
        "the contact is 2.5 mm deep in another state; it is linear up to 5% of L_0: check F_L "
        "and k_c",
    ),
    (
        lying(places={"x_mm": 20.0}),
        "the followed state lies at x = 20 mm without a jump, 53% of L_0: it is no small "
        "deformation",
    ),
    (
        said_of(brake(k=1.8e6)),
        "k = 1800 N/mm is 1.2 times k_c, and the contact should be the stiffest part: check "
        "both units",
    ),
    (said_of(brake(k=75.0)), "k = 0.075 N/mm is only 5e-05 times k_c: check its unit"),
    (
        said_of(UNKNOWN),
        "without V and d friction is taken at full slip, and no oscillation is looked for",
    ),
    (
        said_of(brake(V=0.05)),
        "the belt is so slow that friction is 0.393 of mu0, 0.118 in place of 0.3: check d and V",
    ),
    (
        said_of(named(EXACT, fit=fit(rms=0.06))),
        "the law mu0 (1 - exp(-d v)) is 15% off the measured friction: choose a model with "
        "another law",
    ),
    (
        said_of(named(EXACT, fit=fit(slowest=1.1))),
        "friction is level from 1.1 m/s on, so any d above 7.27 s/m fits: measure at slower "
        "sliding",
    ),
    (
        said_of(named(EXACT, fit=fit(points=2))),
        "two measurements are met exactly by mu0 and d, whose errors are not known: measure at"
        " more speeds",
    ),
    (
        said_of(named(EXACT, fit=fit(fastest=0.01))),
        "friction still rises at 0.01 m/s, and only mu0 d = 3.2 s/m is known: measure at "
        "faster sliding, and check the unit",
    ),
    (said_of(brake(mu0=45.0)), "mu0 = 45 is more than any brake has; write 45 % or 0.45 for 0.45"),
    (
        said_of(brake({"mu0": (0.3, 30.0)})),
        "mu0 = 30 is more than any brake has; write 45 % or 0.45 for 0.45",
    ),
    (
        said_of(ss.Study(BRAKE, model="damped", damping_ratio=0.8)),
        "damping_ratio = 0.8 is 80 %, more than any brake has; write 0.8 % if that is meant",
    ),
    (said_of(brake(V=1200.0)), "V = 1200 m/s looks like mm/s; write 1200 mm/s if that is meant"),
    (
        said_of(brake(theta0=math.radians(0.9))),
        "theta0 = 0.9 deg looks like radians; write 0.9 rad if that is meant",
    ),
    (said_of(brake(L_0=38.0)), "L_0 = 3.8e+04 mm is 38 m, outside 0.1 mm to 10 m: check its unit"),
    (
        lying(stability="neutral", growth_per_s=0.0, damping_ratio=(0.0, 0.0)),
        "nothing damps here, practically neutral: the real brake's damping decides; write "
        'damping_ratio = "0.5 %" or what you measured',
    ),
    (
        lying(stability="neutral", damping_ratio=(-2e-7, 0.003), growth_per_s=1e-9),
        "next to nothing damps here, practically neutral: the real brake's damping decides; "
        'write damping_ratio = "0.5 %" or what you measured',
    ),
    (
        said_of(OTHER),
        "the friction law is not proportional to mu0: "
        "friction is taken at rest, not at the belt's speed",
    ),
    *(
        (
            said_of(brake(**{name: 1.8e6})),
            f"{name} = 1800 N/mm is 1.2 times k_c, "
            "and the contact should be the stiffest part: check both units",
        )
        for name in ("k_x", "k_y")
    ),
]


@pytest.mark.parametrize(("known", "sentence"), VERDICTS, ids=[one for _, one in VERDICTS])
def test_a_sentence_of_the_verdict(known: Facts, sentence: str) -> None:
    assert sentence in list(texts.verdict(known))
    assert texts.as_json(known)["verdict"] == " ".join(texts.verdict(known))


@pytest.mark.parametrize(
    ("title", "known", "name", "value"),
    [
        pytest.param(title, *row, id=f"{title} {row[1]}: {row[2]}")
        for title, rows in ROWS.items()
        for row in rows
    ],
)
def test_a_row_of_the_text(title: str, known: Facts, name: str, value: str) -> None:
    assert (name, value) in dict(texts.sections(known))[title]


@pytest.mark.parametrize(("known", "sentence"), WARNINGS, ids=[one for _, one in WARNINGS])
def test_a_warning(known: Facts, sentence: str) -> None:
    assert sentence in texts.as_json(known)["warnings"]
    assert len(sentence.split()) < 25
    assert sentence in [text for _, text in dict(texts.sections(known))["Warnings"]]
    assert sentence not in texts.as_json(said_of())["warnings"]


@pytest.mark.parametrize(
    ("model", "given", "advice"),
    [
        ("stick_slip", {"c": 0.0}, 'write c = "7 N s/m" or what you measured'),
        ("stick_slip", {"c": 1e-4}, "check c, or add a damper to the page"),
        ("trolley", {}, "add a damper to the page"),
        ("kang_nam", {}, 'write damping_ratio = "0.5 %" or what you measured'),
    ],
)
def test_the_remedy_for_missing_damping(model: str, given: dict[str, float], advice: str) -> None:
    assert remedy(quantities(model), given) == advice


def test_friction_short_of_full_slip_is_told_where_the_printed_digits_show_it() -> None:
    """Where one part in a hundred is missing, and one in a thousand."""
    for short, told in ((1e-2, True), (1e-3, False)):
        found = said_of(brake(V=-math.log(short) / BRAKE["d"]))
        assert ("friction at full slip" in dict(dict(texts.sections(found))["Jump"])) is told


def test_each_text_of_a_file_stands_below() -> None:
    told = texts.as_json(said_of(FILE))
    version = f"spragsym {ss.__version__}"
    assert told["about"] == {
        "title": "Front brake",
        "date": "2026-03-01",
        "file": "brake.toml",
        "model": "model kang_nam",
        "version": version,
    }
    assert len(told["next_steps"]) == 2
    assert told["next_steps"][-1].startswith("run spragsym explore --data brake.toml")
    assert [state["x_mm"] for state in told["states"]] == [3.68]
    assert told["frequencies_hz"] == [44.35, 345.9]
    last = list(texts.blocks(said_of(FILE)))[-1]
    assert last.startswith("\nFront brake, 2026-03-01, brake.toml, model kang_nam, spragsym ")


def test_errors_of_a_fit_are_those_of_least_squares_by_another_library() -> None:
    """A larger friction at full slip goes with a flatter law: errors correlate negatively."""
    speed = np.linspace(0.02, 0.6, 25)
    noise = np.random.default_rng(4).normal(0, 0.01, speed.size)
    measured = 0.4 * -np.expm1(-5.0 * speed) + noise
    found = fit_friction(speed, measured)

    def law(v: np.ndarray, mu0: float, d: float) -> np.ndarray:
        return mu0 * -np.expm1(-d * v)

    (mu0, d), covariance = scipy.optimize.curve_fit(law, speed, measured, (0.3, 3.0))
    errors = np.sqrt(np.diag(covariance))
    assert (found.mu0, found.d) == pytest.approx((mu0, d), rel=1e-5)
    assert (found.mu0_error, found.d_error) == pytest.approx(errors, rel=1e-3)
    assert found.correlation == pytest.approx(covariance[0, 1] / errors.prod(), rel=1e-3)
    assert found.correlation < -0.5
    assert (found.slowest, found.fastest) == (0.02, 0.6)


def test_frequencies_are_those_of_the_damped_motion() -> None:
    """A mass on a belt where friction is level: its damper lowers the frequency."""
    m, k, c, speed = 1.0, 100.0, 8.0, 0.2
    given = {"m": m, "k": k, "N_0": 20.0, "mu_s": 0.5, "v_s": speed, "c": c, "V": speed}
    study = ss.Study(given, model="stick_slip")
    (found,) = states(study, ss.equilibria(study.operating_point), None)
    ratio = c / (2 * math.sqrt(k * m))
    assert ratio == pytest.approx(0.4)
    assert found.damping_ratio == pytest.approx((ratio,), rel=1e-9)
    damped = math.sqrt(k / m) * math.sqrt(1 - ratio**2) / (2 * math.pi)
    assert found.frequencies_hz == pytest.approx((damped,), rel=1e-9)
    assert found.growth_per_s == pytest.approx(-c / (2 * m), rel=1e-9)


def test_json_tells_what_is_known_and_null_for_what_is_not() -> None:
    """Bounds in their order, yes as true, quantities in the units of the file, no word as none."""
    told = texts.as_json(
        said_of(
            LOOSE,
            **LIVES,
            peak=peak(),
            fold_rows=(fold(),),
            certificate=proof("refuted", {"k": 170e3}),
            probability=odds(0.12, 0.1, 0.14, proved=(0.05, 0.25)),
            redesign=(change(),),
            others=(({"x_mm": 42.99}, math.nan), ({"x_mm": 5.0}, None)),
        )
    )
    assert told["oscillation"] == {
        "kind": "cycle",
        "frequency_hz": 41.234567,
        "start": "rest",
        "lifts_off": True,
        "stable": True,
        "amplitude_mm": 2.5,
        "coexists_with_stable_sliding": True,
    }
    assert told["spring_force_N"] == {"rest": -317.66, "oscillation": (-400.0, 120.0)}
    assert told["contact_force_N"] == {"rest": 686.53, "oscillation": (0.0, 900.0)}
    assert told["displacement_mm"] == {"rest": [3.68, -0.4577], "oscillation_amplitude": 2.5}
    assert told["certificate"] == {
        "claim": "no jump",
        "outcome": "refuted",
        "undecided": 0.0,
        "boxes": 0,
        "counterexample": {"k": {"value": pytest.approx(170.0), "unit": "N/mm"}},
    }
    assert told["probability"] == {
        "value": 0.12,
        "low": 0.1,
        "high": 0.14,
        "confidence": 0.95,
        "n": 4096,
        "proved": [0.05, 0.25],
    }
    assert told["sobol"] == {"k": {"first": 0.25, "total": 0.75, "total_error": 0.02}}
    assert told["redesign"] == [
        {
            "from": {"k": {"value": pytest.approx(180.0), "unit": "N/mm"}},
            "to": {"k": {"value": pytest.approx(150.0), "unit": "N/mm"}},
            "jump_at": {"value": 0.41, "unit": ""},
            "mu_jump": 0.41,
            "target": 0.36,
            "distance": 1.0,
            "probability": 0.0,
            "outcome": "proved",
        }
    ]
    assert told["jump"] == {
        "friction": 0.3663,
        "at": {"value": 0.3663, "unit": ""},
        "from_mm": 7.797,
        "to_mm": 43.55,
        "x_mm": (7.5, 80.25),
        "spring_force_N": [-300.5, 200.25],
        "contact_force_N": [0.0, 1500.0],
        "lifts_off": True,
        "settles": "rest",
        "followed_s": 0.75,
    }
    assert told["folds"] == [vars(fold())]
    first, second = told["other_states"]
    assert math.isnan(first["ends_at"]["value"])
    assert second == {"x_mm": 5.0, "ends_at": None}
    assert (told["reach"], told["vary"], told["speed_jump"]) == ("beyond", "mu0", None)
    assert texts.as_json(said_of(SLOW, **FASTER, speed=0.34))["speed_jump"] == {
        "value": pytest.approx(0.34),
        "unit": "m/s",
    }
    load = texts.as_json(said_of(LOAD, jump_at=400.0))
    assert (load["mu_jump"], load["vary"]) == (None, "F_L")
    assert load["jump_at"] == {"value": 400.0, "unit": "N"}
    empty = texts.as_json(said_of(**NOTHING, kind_lowest=""))
    known = ("jump_at", "reach", "kind_lowest", "certificate", "probability", "sobol", "jump")
    assert [empty[name] for name in known] == [None] * len(known)


@pytest.mark.thorough
def test_what_a_report_warns_of_depends_on_no_earlier_question(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The facts are asked in one order, so text, JSON and attributes agree on a fresh report."""
    study = brake(V=None, d=None)
    left = dataclasses.replace(
        ss.folds(study.operating_point, "mu0"),
        undecided=np.zeros((1, 3, 2)),
        remarks=("one box is left",),
    )
    monkeypatch.setattr(facts, "folds", lambda p, vary: left)
    quickly: Any = {"oscillation": False, "probability": False, "redesign": False}
    fresh = study.report(**quickly)
    assert "folds along mu0 may be missing: one box is left" in fresh.to_dict()["warnings"]
    assert fresh.to_dict()["warnings"] == list(study.report(**quickly).warnings)
    assert fresh.warnings == tuple(text for _, text in dict(texts.sections(fresh))["Warnings"])
    with pytest.raises(dataclasses.FrozenInstanceError):
        fresh.remarks = ("another",)  # type: ignore[misc]  # that is what is tested
