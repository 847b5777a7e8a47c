"""Cycles that stick: their phases, and sliding bifurcations on their branches, seen by motions on
both sides.
"""

import math
from collections import Counter
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from tests.oracles import dry_friction, tangent_arrivals
from tests.oracles.user_pages import model_of, shipped_page

#: M. di Bernardo, P. Kowalczyk, A. Nordmark 2003: the push, and friction that falls with the speed.
FALLING = {"P": 0.1, "mu0": 1.5, "fall": 1.0, "V": 1.0, "w": 1.7095}

#: J. P. Den Hartog 1931: the friction from which on the motion under w = 1.5 stops in between.
STOPS = 1.5**2 / (1.5**2 - 1) / math.hypot(1, 1.5 * math.tan(math.pi / 3))

#: Friction of 0.4 on a belt that stands holds the mass at x = 0.6 until the push has fallen to 0.2,
#: and then at x = -0.6: its harmonic motion comes there at this speed of the rotor.
ADDS = 0.207334408814384165

#: Model, values, parameter with its range, and what happens there: kind, value and how often at
#: once.
BRANCHES: dict[str, Any] = {
    "fast": (
        "forced",
        {"w": 0.5, "V": 0.05},
        "w",
        (0.5, 0.6),
        [
            ("switching-sliding", 0.5111678113, 1),
            ("grazing-sliding", 0.5112280013, 1),
            ("crossing-sliding", 0.5808635965, 1),
        ],
    ),
    "slow": (
        "forced",
        {"w": 0.3},
        "w",
        (0.26, 0.33),
        [("grazing-sliding", 0.2677148959, 1), ("adding-sliding", 0.3229218441, 1)],
    ),
    "push": ("forced", {"w": 0.5}, "P", (1.0, 1.18), [("switching-sliding", 1.0995096852, 1)]),
    "brake": (
        "coulomb",
        {"theta0": math.radians(42)},
        "V",
        (0.412, 0.5),
        [("grazing", 0.4161207539, 1), ("crossing-sliding", 0.4348565518, 1)],
    ),  # it touches in lift-off
    "falling": ("forced", FALLING, "w", (1.7068, 1.7105), [("grazing-sliding", 1.7077997149, 1)]),
    "still": (
        "forced",
        {"w": 0.19, "V": 0.0},
        "w",
        (0.19, 0.22),
        [("adding-sliding", ADDS, 2)] * 2,
    ),
    "stops": (
        "forced",
        {"w": 1.5, "V": 0.0, "mu0": 0.6},
        "mu0",
        (0.58, 0.7),
        [("crossing-sliding", STOPS, 2)] * 2,
    ),
}

#: The forced mass with its own place first: cycles begin where x is largest.
ROTOR = 'phi = page.coordinate("phi", "rad", "angle of the rotor")\n'
PUSHED = dry_friction.FORCED.replace(ROTOR, "").replace(
    "\npage.kinetic", f"\n{ROTOR}page.kinetic", 1
)

#: How often a cycle sticks and overtakes more on one side of each than on the other, and what the
#: phase is that is short there.
NAMES = {
    "grazing-sliding": (1, 0, "STICK"),
    "crossing-sliding": (1, -1, "STICK"),
    "switching-sliding": (0, 1, "OVERTAKES"),
    "adding-sliding": (1, 0, "SLIP"),
    "grazing": (0, 2, None),
}


def seen(events: list[tuple[float, str]], period: float) -> tuple[Counter[str], str]:
    """How often a cycle sticks, slips and overtakes, and with which the shortest of the phases
    between begins.
    """
    own = [(t, name.split("_")[-1]) for t, name in events if "CONTACT" not in name]
    ends = [t for t, _ in own[1:]] + [t + period for t, _ in own[:1]]
    short = min(
        ((end - t, name) for (t, name), end in zip(own, ends, strict=True)), default=(0.0, "")
    )
    return Counter(name for _, name in own), short[1]


def motion(
    name: str, p: dict[str, float], near: ss.results.Cycle, _: float
) -> tuple[list[tuple[float, str]], float]:
    """Events of a motion over one period of a cycle, begun on it, and the period; by SciPy, which
    did not find it.
    """
    given = dry_friction.model(name).Parameters(**p)
    cycle = ss.cycle(given, near=near)
    events = ss.simulate(
        given, start=cycle.state, t_end=cycle.period, rtol=1e-12, backend="scipy"
    ).events
    return [
        (t, ss.Event(kind).name)
        for t, kind in zip(events.t.tolist(), events.which.tolist(), strict=True)
    ], cycle.period


@pytest.mark.parametrize(
    ("branch", "longest", "off"),
    [
        *(
            pytest.param(branch, 0.2 * (branch != "brake"), 1e-5, marks=pytest.mark.thorough)
            for branch in list(BRANCHES)[:4]
        ),
        *(pytest.param(branch, 0.02, 1e-6, marks=pytest.mark.validate) for branch in BRANCHES),
    ],
)
def test_sliding_bifurcations_are_where_and_what_their_names_say(
    branch: str, longest: float, off: float
) -> None:
    """Cycles on either side differ by that and by nothing else, by simulation and by the other
    driver in short steps.
    """
    pytest.importorskip("heyoka")
    name, values, vary, to, expected = BRANCHES[branch]
    p = dry_friction.model(name).Parameters(**values)
    begun = (
        None
        if name == "coulomb"
        else ss.simulate(p, start=(0.0, 1.5, values["w"], 0.9), t_end=700.0)
    )
    events = ss.cycle_branch(ss.cycle(p, near=begun), vary, between={vary: to}).of(*NAMES)
    for event, (kind, value, times) in zip(events, expected, strict=True):
        assert event.kind == kind
        assert abs(event.value - value) <= event.error + 1e-10 * (branch not in ("still", "stops"))
        assert event.error < 1e-10
        sticks, overtakes, short = NAMES[kind]
        for driver in (motion, dry_friction.along) if longest else (motion,):
            beside = (event.cycle.parameters | {vary: value + way * off} for way in (-1, 1))
            sides = (seen(*driver(name, given, event.cycle, longest)) for given in beside)
            (fewer, _), (more, begins) = sorted(sides, key=lambda side: side[0].total())
            more.subtract(fewer)
            assert more == Counter(
                {"STICK": sticks * times, "SLIP": sticks * times, "OVERTAKES": overtakes * times}
            ), event.value
            assert short in (begins, None), event.value


@pytest.mark.parametrize(("mu_k", "V"), [(0.4, 0.5), (0.59, 2.0)])
def test_a_branch_that_joins_a_family_ends_where_sticking_does(mu_k: float, V: float) -> None:
    """The mass sticks for 2 (mu_s - mu_k) / V; at equal coefficients it slides for ever on any
    circle below x' = V.
    """
    pytest.importorskip("heyoka")
    found = ss.cycle(
        ss.load("coulomb_stick_slip").Parameters(mu_s=0.6, mu_k=mu_k, V=V), near=(1.0, 1.2 * V)
    )
    for vary, to, value in (("mu_k", (0.1, 0.7), 0.6), ("mu_s", (0.1, 0.7), mu_k)):
        events = ss.cycle_branch(found, vary, between={vary: to}).events[
            :: 1 if vary == "mu_k" else -1
        ]
        assert [event.kind for event in events] == ["end", "grazing-sliding", "end"]
        assert events[1].how == "x' = V"
        assert "whole family" in events[2].how
        for event in events[1:]:
            assert abs(event.value - value) <= event.error < 1e-7


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("vary", "to", "value"), [("mu0", (0.2, 0.5), 1 / 3), ("P", (0.8, 1.4), 1.2)]
)
def test_a_branch_that_joins_a_family_in_resonance_ends_where_sticking_does(
    vary: str, to: tuple[float, float], value: float
) -> None:
    """Den Hartog's limit under w = 1/2, P = 3 mu0: beyond, the free oscillation is in resonance,
    and cycles are no more alone.
    """
    pytest.importorskip("heyoka")
    p = dry_friction.model("forced").Parameters(w=0.5, V=0.0)
    branch = ss.cycle_branch(
        ss.cycle(p, near=ss.simulate(p, start=(0.0, 1.5, 0.5, 0.9), t_end=700.0)),
        vary,
        between={vary: to},
    )
    end, event = (event for event in branch.events if event.how != "the range ends")
    if event.kind == "end":
        end, event = event, end
    assert (event.kind, event.how) == ("crossing-sliding", "x' = V")
    assert "whole family" in end.how
    assert end.value == event.value
    assert abs(event.value - value) <= event.error == end.error < 1e-8


@pytest.mark.thorough
def test_a_branch_ends_where_what_moves_comes_to_rest_for_good() -> None:
    """From μ_s N_0 on friction holds the mass against half the range of the force, which reaches
    from −1/6.4 − 1.6 (1 − 1/20.48) to 2.6.
    """
    pytest.importorskip("heyoka")
    both = ("P * cos(phase)", "P * (cos(phase) + 8 * cos(2 * phase) / 5)")
    p = model_of(shipped_page("forced_oscillator", both), "harmonics").Parameters(omega=0.8)
    branch = ss.cycle_branch(ss.cycle(p, kappa=5.0, turns=1), "kappa", between={"kappa": (5, 6)})
    _, *events = branch.events
    assert [event.kind for event in events] == ["grazing-sliding", "end"]
    for event in events:
        assert abs(event.value - (2.6 + 1.678125) / 2 / 0.4) <= event.error < 1e-6


@pytest.mark.parametrize(("w", "value"), [(0.6, 0.1 * 0.64 / 0.6), (2.0, 0.15)])
def test_a_branch_ends_where_a_touch_makes_it_stick_and_jump(w: float, value: float) -> None:
    """Kinetic friction is half of the static one: harmonic motion of the speed P w / |1 - w^2|
    comes to that of the belt.
    """
    p = model_of(PUSHED.replace("mu_s * (sgn(v)", "mu_s / 2 * (sgn(v)"), "weaker").Parameters(
        w=w, V=0.1, P=0.8 * value
    )
    found = ss.cycle(p, near=(0.2 + 0.8 * value / (1 - w**2), 0.0, 0.0, w))
    (event,) = (
        event
        for event in ss.cycle_branch(found, "P", between={"P": (0.5 * value, 1.3 * value)}).of(
            "end"
        )
        if event.value > value / 2
    )
    assert "touches a border" in event.how
    assert abs(event.value - value) <= event.error < 1e-9


@pytest.mark.parametrize(("w", "mu0"), [(1.3, 0.4), (1.5, 0.6)])
def test_a_cycle_is_found_where_friction_turns_around_as_x_is_largest(w: float, mu0: float) -> None:
    """On a belt that stands: amplitude by J. P. Den Hartog 1931, multipliers of the same cycle
    begun elsewhere.
    """
    pytest.importorskip("heyoka")
    values = {"w": w, "mu0": mu0, "V": 0.0}
    p, rotor = (
        model_of(PUSHED, "pushed").Parameters(**values),
        dry_friction.model("forced").Parameters(**values),
    )
    turned = math.sin(math.pi / w) / (w * (1 + math.cos(math.pi / w)))
    other = ss.cycle(rotor, near=ss.simulate(rotor, start=(0.0, 1.5, w, 0.9), t_end=300.0))
    for near in ((1.5, 0.0, 0.9, w), ss.simulate(p, start=(1.5, 0.0, 0.9, w), t_end=300.0)):
        found = ss.cycle(p, near=near)
        assert found.amplitude == pytest.approx(
            math.sqrt(1 / (1 - w**2) ** 2 - (mu0 * turned) ** 2), abs=1e-10
        )
        assert found.multipliers == pytest.approx(other.multipliers, abs=1e-8)


@pytest.mark.thorough
def test_a_cycle_that_begins_as_it_sticks_has_its_least_period() -> None:
    """On a belt that stands x is largest as long as the mass sticks."""
    p = model_of(PUSHED, "pushed").Parameters(w=0.3, mu0=0.6, V=0.0)
    assert ss.cycle(p, near=(1.5, 0.0, 0.9, 0.3), backend="scipy").period == pytest.approx(
        2 * math.pi / 0.3
    )


@pytest.mark.parametrize("w", [0.6, 2 / 3, 1.3, 2.0])
def test_nothing_happens_to_a_motion_that_nothing_damps(w: float) -> None:
    """Multipliers exp(±2πi/w): their product is 1 everywhere, and at w = 2/3 and 2 both come to -1
    and pass it.
    """
    pytest.importorskip("heyoka")
    found = ss.cycle(
        model_of(PUSHED, "pushed").Parameters(w=w, V=50.0), near=(0.4 + 1 / (1 - w**2), 0.0, 0.0, w)
    )
    assert [
        event.how for event in ss.cycle_branch(found, "w", between={"w": (0.9 * w, 1.1 * w)}).events
    ] == ["the range ends"] * 2


@pytest.mark.parametrize("vary", ["V", "zeta"])
def test_a_branch_ends_where_its_arrival_becomes_tangent(vary: str) -> None:
    """Damped stick-slip: beyond, the block does not come to the speed of the belt any more."""
    zeta, mu_s, mu_k = np.random.default_rng(5).uniform((0.05, 0.5, 0.3), (0.2, 0.7, 0.4))
    value = {"V": (mu_s - mu_k) * tangent_arrivals.ratio(zeta), "zeta": zeta}
    begin = value | {vary: 0.8 * value[vary]}
    p = tangent_arrivals.model().Parameters(mu_s=mu_s, mu_k=mu_k, **begin)
    cycle = ss.cycle(p, near=(mu_s - begin["zeta"] * begin["V"], begin["V"]))
    branch = ss.cycle_branch(cycle, vary, between={vary: (0.7 * value[vary], 1.2 * value[vary])})
    (end,) = (event for event in branch.events if event.how != "the range ends")
    assert end.kind == "catastrophic-sliding"
    assert "its arrival at x' = V becomes tangent" in end.how
    assert abs(end.value - value[vary]) <= end.error < 1e-9


@pytest.mark.validate
def test_a_branch_ends_where_the_force_comes_to_its_limit_at_a_tangent() -> None:
    """A mass that is pushed, on a belt at rest: beyond, it sticks for good."""
    pytest.importorskip("heyoka")
    w, mu0, fall = 0.4, 0.4, 0.4
    law = "mu_s * (sgn(v) - fall * (v / u - 3 * (v / u) ** 3 / 10))"
    assert law in dry_friction.FORCED
    page = dry_friction.FORCED.replace(law, "mu_s * (1 - fall) * sgn(v)")
    value = tangent_arrivals.largest_push(w, mu0, mu0 * (1 - fall))
    P = 1.1 * value
    p = model_of(page, "forced_weaker").Parameters(w=w, V=0.0, mu0=mu0, fall=fall, P=P)
    found = ss.cycle(p, near=ss.simulate(p, start=(0.0, 1.5 * (P - mu0), w, 0.0), t_end=300.0))
    branch = ss.cycle_branch(found, "P", between={"P": (0.8 * value, 1.15 * value)})
    (end,) = branch.of("catastrophic-sliding")
    assert "friction at its limit" in end.how
    assert abs(end.value - value) <= end.error < 1e-9
