"""Every public question is asked of every model near its base values, and each answer is held
against another question.

A model that has no answer says so by an error that the question documents.
"""

import inspect
import os
from collections.abc import Callable
from functools import cache, cached_property
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.design.jumps import limit_point_passed
from tests.conformance import models
from tests.conformance.models import ALIKE, MODELS, a_set, answers
from tests.support import few

#: Belt speeds at which a motion from 0 comes to a cycle; elsewhere, on a belt so slow that friction
#: damps, it comes to rest.
CYCLES = {
    "hertz_contact": 1.0,
    "inclined_belt": 1.0,
    "stribeck": 1.0,
    "stick_slip": 0.2,
    "coulomb_stick_slip": 0.2,
    "two_blocks": 0.2,
}
SLOW = 0.1
#: Models with one equilibrium that grows in one direction only, at these speeds.
SADDLES = (
    "coulomb",
    "cubic_contact",
    "damped",
    "hertz_contact",
    "kang_nam",
    "pad_on_disc",
    "sprag_rod",
    "trolley",
)


def refused(error: Any, words: str, question: Callable[..., Any], *given: Any, **more: Any) -> None:
    """The answer of a model that has none."""
    with pytest.raises(error, match=words):
        question(*given, **more)


class Asked:
    """How questions are asked of a model, and what holds of the answers."""

    def __init__(self, name: str) -> None:
        self.name, self.p = name, a_set(name)
        self.model, self.first = self.p.model, self.p.model.coordinates[0]
        self.planar = {"theta0", "mu0"} <= {*self.model.parameters}
        #: What rises, another parameter, and the plane of two.
        self.vary = self.model.axes[-1]
        self.other = next(one for one in self.model.parameters if one not in (self.vary, "V"))
        self.plane = (self.other, self.vary)
        self.own = float(self.p[self.vary])
        self.begin = 0.9 * self.own
        #: What motions vary, the speed of the belt where there is one, and its value.
        self.pace = "V" if "V" in self.p.ranges else self.other
        self.speed = CYCLES.get(name, SLOW) if self.pace == "V" else float(self.p[self.pace])
        self.moving = self.p.replace(**{self.pace: self.speed})

    @cached_property
    def jump(self) -> float:
        """From a tenth below its value on, where the followed state ends first; NaN if it
        doesn't.
        """
        return float(ss.jump_value(self.p, self.vary, begin=self.begin, until=2.5 * self.own))

    def near(self, *names: str, share: float = 0.02) -> dict[str, tuple[float, float]]:
        """Ranges about values of parameters."""
        values = {name: float(self.p[name]) for name in names}
        return {name: (value * (1 - share), value * (1 + share)) for name, value in values.items()}

    def folds(self, low: float, high: float, **changes: Any) -> Any:
        """Folds along what rises."""
        return getattr(
            ss.folds(self.p.replace(**changes), self.vary, between={self.vary: (low, high)}),
            self.vary,
        )

    def answers(self, question: Callable[..., Any], *given: Any, **more: Any) -> bool:
        """Whether the model answers a question; else it is refused by its name."""
        return answers(self.model, question.__name__, lambda: question(*given, **more))

    def equilibria(self) -> None:
        """Each is found again, alone, in a box around it."""
        eq = ss.equilibria(self.p)
        assert int(ss.count(self.p)) == int(eq.count) > 0
        for slot in range(int(eq.count)):
            place = {name: float(column[slot]) for name, column in eq.coordinates.items()}
            again = ss.equilibria(
                self.p, within={name: (value - 1e-3, value + 1e-3) for name, value in place.items()}
            )
            assert int(again.count) == 1
            assert [column[0] for column in again.coordinates.values()] == pytest.approx(
                [*place.values()], abs=1e-11
            )

    def points(self) -> None:
        """Two states end at a fold, or begin, and go to an equilibrium; two folds are on one side
        of a cusp.
        """
        between = self.near(self.vary, share=0.3)
        found = ss.folds(self.p, self.vary, between=between)
        counts = ss.count(self.p.replace(**{self.vary: [*between[self.vary]]}))
        assert counts[1] - counts[0] == 2 * (
            (found.when == "down").sum() - (found.when == "up").sum()
        )
        for row in np.flatnonzero(found.ends != ""):
            here = ss.equilibria(self.p.replace(**{self.vary: found[self.vary][row]}))
            away = [
                np.nanmin(np.abs(here[name] - column[row])) for name, column in found.after.items()
            ]
            assert np.isnan(found.after[self.first][row]) or max(away) < 1e-6
        plane = (
            {"theta0": (1.1, 1.3), "mu0": (0.15, 0.3)} if self.planar else self.near(*self.plane)
        )
        if not self.answers(ss.cusps, self.p, self.plane, between=plane):
            return
        for cusp in ss.cusps(self.p, self.plane, between=plane):
            beside = [cusp["theta0"] + side for side in (-0.01, 0.01)]
            assert {
                len(self.folds(cusp["mu0"] - 0.02, cusp["mu0"] + 0.02, theta0=one))
                for one in beside
            } == {0, 2}
        around = self.near(*self.plane)
        if not self.answers(ss.bifurcation_set, self.p, self.plane, 2, between=around):
            return
        for curve in ss.bifurcation_set(self.p, self.plane, 2, between=around).curves:
            at, value = (float(curve[name][0]) for name in self.plane)
            assert (
                np.abs(self.folds(0.9 * value, 1.1 * value, **{self.other: at}) - value).min()
                < 1e-6
            )

    def onsets(self) -> None:
        """Two λ of an equilibrium there are ±iω, with all damping or without."""
        single = ss.flutter_onsets(self.p, self.vary, between=self.near(self.vary, share=0.3))
        places = [({self.vary: row[self.vary]}, row["omega"]) for row in single]
        asked, around = (self.p, self.plane, 2), self.near(*self.plane)
        known = self.answers(ss.onset_curves, *asked, between=around)
        for curve in ss.onset_curves(*asked, between=around).curves if known else ():
            places.append(({name: float(curve[name][0]) for name in self.plane}, curve.omega[0]))
        for at, omega in places:
            eq = ss.equilibria(self.p.replace(**at))
            every = np.concatenate([eq.damped_eigenvalues[eq.states], eq.eigenvalues[eq.states]])
            assert np.abs(every - 1j * omega).min() < 1e-4

    def modes(self) -> None:
        """They are asked of matrices; a page is refused, with what to ask in their place."""
        refused(ss.errors.ModelError, "growth and stability", ss.modes, self.p)

    def sticking(self) -> None:
        """The states hold the equilibria of a belt that stands still."""
        still = self.p.replace(V=0.0) if self.pace == "V" else self.p
        if not hasattr(self.model.algebra, "grip"):
            return refused(
                ss.errors.ModelError,
                f"in {self.name} friction holds nothing",
                ss.sticking_states,
                still,
            )
        found, states = ss.sticking_states(still).data(), ss.equilibria(still)[self.first]
        low, high = (found[f"{self.first}_{end}"][:, None] for end in ("low", "high"))
        assert (
            ((low - 1e-9 <= states) & (states <= high + 1e-9)).any(axis=0) | np.isnan(states)
        ).all()

    def jumps(self) -> None:
        """A jump is at a fold, moves with a parameter as folds do, and is where a path jumps."""
        known, (low, high) = (
            self.folds(self.begin, 2.5 * self.own),
            self.near(self.other, share=1e-5)[self.other],
        )
        ends = {"begin": self.begin, "until": 2.5 * self.own}
        differs = self.answers(ss.jump_gradient, self.p, self.vary, **ends)
        slope = np.nan
        if differs:
            slope = ss.jump_gradient(self.p, self.vary, **ends).slopes[self.other]
        path = ss.quasi_static_path(
            self.p, self.vary, [self.begin, np.nanmax([self.own, 1.01 * self.jump])]
        )
        if np.isnan(self.jump):
            assert (len(known), len(path.jumps)) == (0, 0)
            assert np.isnan(slope)
            return
        assert np.abs(known - self.jump).min() < 1e-9
        assert [end.value for end in path.jumps] == [pytest.approx(self.jump, rel=1e-9)]
        if not differs:
            return
        below, above = (
            self.folds(0.98 * self.jump, 1.02 * self.jump, **{self.other: end})[0]
            for end in (low, high)
        )
        assert slope == pytest.approx((above - below) / (high - low), rel=1e-3)

    def lowest(self) -> None:
        """Over θ₀ and μ₀ near the first jump: it is a fold, and below it there is none at other θ₀;
        the article's critical β.
        """
        asked, between = (self.p, self.other), {self.other: (0.1, 0.2)}
        known = [
            self.answers(ss.critical_friction, self.p),
            self.answers(ss.cusp_friction, self.p),
            self.answers(ss.critical_value, *asked, between=between),
        ]
        if not all(known):
            return None
        if not self.planar:
            words = f"{self.name} has not both an inclination and a friction"
            refused(ss.errors.ParameterError, words, ss.critical_friction, self.p)
            refused(ss.errors.ParameterError, words, ss.cusp_friction, self.p)
            return refused(
                ss.errors.ParameterError, words, ss.critical_value, *asked, between=between
            )
        least, most = 0.9 * self.jump, 1.1 * self.jump
        between = self.near("theta0") | {"mu0": (least, most)}
        found = ss.critical_friction(self.p, between=between)
        assert np.abs(self.folds(least, most, theta0=found.where) - found.value).min() < 1e-9
        for theta0 in between["theta0"]:
            assert min(self.folds(least, most, theta0=theta0), default=np.inf) >= found.value - 1e-9
        assert ss.cusp_friction(self.p, between=between) == min(
            ss.cusps(self.p, between=between).mu0, default=np.inf
        )
        if self.name == "kang_nam":
            value = ss.critical_value(self.p, "beta", between={"beta": (1.0, 2.0)})
            assert float(ss.critical_friction(self.p.replace(beta=value))) == pytest.approx(
                0.5, rel=1e-9
            )
        else:
            given = self.p.replace(mu0=0.1), "kappa"
            between = {"kappa": (0.007, 0.008), "theta0": (0.69, 0.7), "mu0": (0.1, 0.2)}
            refused(
                ss.errors.ParameterError,
                "both on one side of mu0",
                ss.critical_value,
                *given,
                between=between,
            )

    def odds(self) -> None:
        """The margin is how far the jump is; bounds of a probability hold the share of the interval
        beyond the jump.
        """
        rises: dict[str, Any] = {"vary": self.vary, "begin": self.begin}
        ends = {self.vary: (self.begin, 1.5 * self.own)}
        known = [
            self.answers(ss.jump_margin, self.p, {self.vary: 0.1}, **rises),
            self.answers(ss.jump_probability, ends, model=self.model, **rises),
        ]
        if not all(known):
            return
        margin = ss.jump_margin(self.p, {self.vary: 0.1}, **rises)
        away = np.inf if np.isnan(self.jump) else max(self.jump - self.own, 0.0) / 0.1
        assert margin.distance == pytest.approx(away, rel=1e-6)
        high, fixed = (
            1.5 * self.own,
            {name: float(self.p[name]) for name in self.model.parameters},
        )
        how: dict[str, Any] = {
            "n": 32,
            "rng": 1,
            "sobol": False,
            "replicates": 2,
            **rises,
        }
        found = ss.jump_probability(
            fixed | {self.vary: (self.begin, high)}, model=self.model, **how
        )
        assert (
            found.low
            <= np.clip(np.nan_to_num((high - self.jump) / (high - self.begin)), 0.0, 1.0)
            <= found.high
        )

    def certificates(self) -> None:
        """What is proved of a box is true at random points of it, and what is refuted is not true
        at the counterexample.
        """
        low = self.p.replace(**{self.vary: 0.995 * self.own})
        sides = {self.vary: (0.995 * self.own, 1.005 * self.own)}
        if not self.answers(ss.certify, low, between=sides):
            return
        points = self.p.replace(
            **{self.vary: self.own * np.random.default_rng(1).uniform(0.995, 1.005, 4)}
        )
        fails: dict[str, Callable[[Any], Any]] = {
            "no jump": lambda p: limit_point_passed(p, self.vary, begin=self.begin) == 1,
            "one equilibrium": lambda p: ss.count(p) != 1,
            "no flutter": lambda p: (ss.equilibria(p).undamped == ss.EquilibriumType.FLUTTER).any(
                axis=-1
            ),
        }
        for claim, is_false in fails.items():
            rises = {"vary": self.vary, "begin": self.begin} if claim == "no jump" else {}
            begun = ss.equilibria(self.p.replace(**{self.vary: self.begin}))
            if rises and not (begun.undamped == ss.EquilibriumType.STABLE).any():
                refused(
                    ss.errors.ConvergenceError,
                    "is known to be stable",
                    ss.certify,
                    low,
                    claim,
                    between=sides,
                    **rises,
                )
                continue
            found = ss.certify(low, claim, between=sides, max_boxes=60, **rises)
            if claim == "no flutter" and found.outcome == "undecided":
                continue  # of several coordinates, in so few boxes
            assert is_false(
                points if found.outcome == "proved" else found.counterexample
            ).any() == (found.outcome == "refuted")

    def designs(self) -> None:
        """A new design jumps where it should."""
        given = (self.p, self.other, {self.vary: 1.01 * self.jump})
        if not self.answers(ss.redesign, *given, begin=self.begin):
            return None
        if np.isnan(self.jump):
            return refused(
                ss.errors.ParameterError,
                rf"target\['{self.vary}'\] = nan"
                if self.other in self.model.balanced
                else f"'{self.other}' in change is not a quantity here",
                ss.redesign,
                *given,
                begin=self.begin,
            )
        found = ss.redesign(*given, begin=self.begin)
        assert float(ss.jump_value(found.parameters, self.vary, begin=self.begin)) == pytest.approx(
            1.01 * self.jump, rel=1e-6
        )

    def motions(self) -> None:
        """From half-way the same motion goes on; a sweep says the same of it; its exponents
        together are the trace.
        """
        whole = ss.simulate(self.p, t_end=8.0)
        assert ss.simulate(self.p, t_end=4.0, start=whole(4.0)).state[:, -1] == pytest.approx(
            whole.state[:, -1], abs=1e-7
        )
        sweep = ss.rms_sweep(self.p, t_end=8.0)
        assert float(sweep.rms) == pytest.approx(whole.rms(), abs=1e-9)
        assert (sweep.regime, sweep.equilibrium) == (
            whole.outcome().regime,
            whole.outcome().equilibrium,
        )
        exponents = ss.lyapunov(self.p, t_end=20.0)
        assert exponents.exponents.sum() == pytest.approx(exponents.trace, abs=1e-3)

    def steps(self) -> None:
        """The inclination at which the root mean square grows most, as a ratio."""
        at, axes = (
            self.p.replace(theta0=[0.3, 0.4, 0.5]) if "theta0" in self.p.ranges else self.p,
            {"V": [0.1], "d": [10.0]},
        )
        if not self.answers(ss.sensitivity, at, **axes):
            return None
        if not {"theta0", "d"} <= {*self.model.parameters}:
            return refused(ss.errors.ModelError, "has no (d|theta0)", ss.sensitivity, at, **axes)
        found, rms = (
            ss.sensitivity(at, **axes, refine=0, t_end=8.0),
            ss.rms_sweep(at, V=0.1, d=10.0, t_end=8.0).rms,
        )
        assert found.theta0[0, 0] == pytest.approx(0.35 + 0.1 * int((rms[1:] / rms[:-1]).argmax()))

    def fates(self) -> None:
        """A map and a basin of one motion say what is said of it, and where its fate does not
        change there is no boundary.
        """
        found = ss.fate(self.moving)
        sheet = ss.fate_map(self.moving.replace(**{self.pace: [self.speed]}))
        # A disc begins in its state of rest, which is not stable.
        open_ = self.name in ("coulomb", "wobbling_disc", "disc_between_pads")
        driven = self.name in CYCLES or self.model.clock
        assert found.kind == ("cycle" if driven else "undecided" if open_ else "rest")
        assert sheet.count()[found.kind] == 1
        assert sheet.period[0] == pytest.approx(found.outcome.period, nan_ok=True)
        one, other = self.model.components[:2]
        basin = ss.basin(self.moving, **{one: [0.0, 0.0], other: [0.0]}, t_end=100.0)
        assert basin.attractor.tolist() == [[0], [0]]
        assert basin.attractors[0][0] == basin.sweep.outcome((0, 0)).limit
        words = (
            "to nothing that is decided" if found.kind == "undecided" else "which is one attractor"
        )
        errors = (ss.errors.ParameterError, ss.errors.ConvergenceError)
        along: dict[str, Any] = {
            "vary": self.pace,
            "between": {self.pace: (0.99 * self.speed, self.speed)},
        }
        if self.answers(ss.fate_boundary, self.moving, **along):
            refused(errors, words, ss.fate_boundary, self.moving, **along)

    def boundary(self) -> None:
        """It passes by the saddle, without which there is none."""
        how: dict[str, Any] = {"points": 1, "step": 0.01}
        if not self.answers(ss.basin_boundary, self.moving, **how):
            return None
        if self.name not in SADDLES:
            return refused(
                ss.errors.ParameterError,
                "one divergent equilibrium is needed",
                ss.basin_boundary,
                self.moving,
                **how,
            )
        found = ss.basin_boundary(self.moving, **how)
        assert found.growth > 0
        assert np.abs(found.points[:, 0] - found.saddle[0]).max() < 0.1

    def cycles(self) -> None:
        """A cycle returns to itself; the one at the end of a branch is found by itself; the curve
        of an event holds the event.
        """
        if self.name not in CYCLES and not self.model.clock:
            return refused(
                ss.errors.ConvergenceError,
                "no cycle was found near the motion",
                ss.cycle,
                self.moving,
                patient=False,
            )
        found = ss.cycle(self.moving, patient=False)
        around = ss.simulate(self.moving, start=found.state, t_end=found.period)
        turned = [2 * np.pi * (name == self.model.clock) for name in self.model.components]
        assert around.state[:, -1] == pytest.approx(found.state + turned, abs=1e-6)
        over, along = "V", {"V": (0.5 * self.speed, self.speed)}
        if over not in self.model.parameters:
            over, along = self.other, self.near(self.other)
        branch = ss.cycle_branch(found, over, between=along, points=40)
        last = ss.cycle(
            self.moving.replace(**{over: branch.values[0]}),
            near=branch.cycles[0].state,
            patient=False,
        )
        assert last.period == pytest.approx(branch.periods[0], rel=1e-9)
        for event in branch.of("grazing", "torus")[:1]:
            curve = ss.cycle_events(event, (over, self.other), points=2)
            assert np.abs(curve.values[:, 0] - event.value).min() < 1e-9
        refused(
            ss.errors.ParameterError,
            "end is not followed",
            ss.cycle_events,
            branch.events[-1],
            ("V", self.other),
        )

    def curves(self) -> None:
        """A motion that begins on a curve of rest stays there."""
        for rest in ss.diagram(
            self.moving, self.pace, between={self.pace: (0.99 * self.speed, self.speed)}, points=2
        ).equilibria:
            start = [*rest.states[-1], *[0.0] * len(self.model.coordinates)][
                : len(self.model.components)
            ]
            assert ss.simulate(self.moving, start=start, t_end=1.0).state[:, -1] == pytest.approx(
                start, abs=1e-6
            )

    def page(self) -> None:
        """It names the model."""
        pytest.importorskip("sympy")
        if not self.answers(ss.explore, self.p):
            return
        assert self.name in ss.explore(self.p)._repr_html_()

    def article(self) -> None:
        """Only the article's model has a surface, a flutter boundary, and a linear model with
        poles.
        """
        of_article = {
            ss.kang_nam.surface: (0.8, 0.7),
            ss.kang_nam.flutter_boundary: (200,),
            ss.kang_nam.linear_sprag: (),
            ss.kang_nam.linear_critical_friction: (),
        }
        for question, more in of_article.items() if self.name != "kang_nam" else ():
            refused(
                ss.errors.ModelError,
                f"{question.__name__} is not there yet for the model {self.name}; ",
                question,
                self.p,
                *more,
            )
        if self.name == "kang_nam":
            place, boundary = (
                ss.kang_nam.surface(self.p, 0.8, 0.7),
                ss.kang_nam.flutter_boundary(self.p, 200),
            )
            assert (
                np.nanmin(
                    np.abs(ss.equilibria(self.p.replace(mu0=place.mu0, theta0=0.7)).theta - 0.8)
                )
                < 1e-12
            )
            known = ss.flutter_onsets(
                self.p.replace(mu0=boundary.mu0[9]), "theta0", damping=False
            ).theta0
            assert np.abs(known - boundary.theta0[9]).min() < 1e-6
            beside = self.p.replace(
                mu0=ss.kang_nam.linear_critical_friction(self.p) * np.array([0.99, 1.01])
            )
            assert np.isfinite(ss.kang_nam.linear_sprag(beside).poles).any(axis=-1).tolist() == [
                False,
                True,
            ]


case = cache(Asked)
#: Not those that ``python -m tests.conformance`` is asked for, of which nothing is known.
COMMITTED = () if models.ASKED in os.environ else MODELS
#: The table: which method asks which questions.
TABLE: dict[Callable[[Asked], None], str] = {
    Asked.equilibria: "equilibria count",
    Asked.points: "folds cusps bifurcation_set",
    Asked.onsets: "flutter_onsets onset_curves",
    Asked.sticking: "sticking_states",
    Asked.jumps: "jump_value jump_gradient quasi_static_path",
    Asked.odds: "jump_margin jump_probability",
    Asked.lowest: "critical_friction cusp_friction critical_value",
    Asked.certificates: "certify",
    Asked.designs: "redesign",
    Asked.motions: "simulate rms_sweep lyapunov",
    Asked.steps: "sensitivity",
    Asked.fates: "fate fate_map fate_boundary basin",
    Asked.boundary: "basin_boundary",
    Asked.cycles: "cycle cycle_branch cycle_events",
    Asked.curves: "diagram",
    Asked.page: "explore",
    Asked.modes: "modes",
    Asked.article: "surface flutter_boundary linear_sprag linear_critical_friction",
}
#: Those that follow long motions; and those that take seconds where states end and no closed form
#: says where.
LONG = (Asked.fates, Asked.boundary, Asked.cycles)
DEAR = ("jumps", "lowest", "odds", "designs", "page")
BY_HAND = [f"{name}-{ask}" for name in ("sprag_rod", "two_springs") for ask in DEAR]


def questions() -> list[str]:
    """Public functions whose first argument is a set of parameters, or a cycle or an event of
    one.
    """
    functions = {
        name: getattr(room, name)
        for room in (ss, ss.kang_nam)
        for name in room.__all__
        if inspect.isfunction(getattr(room, name))
    }
    first = {
        name: next(iter(inspect.signature(one).parameters), "") for name, one in functions.items()
    }
    return [
        name for name in functions if first[name] in ("p", "low", "distribution", "cycle", "event")
    ]


def test_no_public_question_is_left_out() -> None:
    assert sorted(" ".join(TABLE.values()).split()) == sorted(questions())
    common = inspect.getsource(vars(Asked)["jump"].func)
    for ask, names in TABLE.items():
        source = common + inspect.getsource(ask)
        assert all(
            f"ss.{name}" in source or f"ss.kang_nam.{name}" in source for name in names.split()
        )


@pytest.mark.by_hand("soft_brake", "kang_nam-boundary", *BY_HAND, *ALIKE)
@pytest.mark.parametrize("ask", TABLE, ids=lambda ask: ask.__name__)
@pytest.mark.parametrize("name", few(COMMITTED, "stick_slip"))
def test_every_question_of_every_model(name: str, ask: Callable[[Asked], None]) -> None:
    if ask in LONG:
        pytest.importorskip("heyoka")  # they take SciPy minutes
    ask(case(name))
