"""Motions in lanes: each as if it were alone, whatever runs beside it, ends before it, or breaks
off.
"""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.core.errors import ConvergenceError, SweepError
from spragsym.motion import Event, integrators, simulate, with_heyoka
from spragsym.motion.problem import Problem, prepare
from spragsym.motion.sweeps import rms_sweep
from spragsym.motion.with_heyoka import compiled

pytest.importorskip("heyoka")
BELT = {"V": 0.5, "d": 10.0}
RNG = np.random.default_rng(15)


def problems(
    count: int, t_end: float = 60.0, t_record: float = 20.0, **options: int
) -> list[Problem]:
    """Of different kinds and lengths in steps: some lift off, some stick, some slide."""
    found = []
    low, high = [0.1, 0.1, *[-0.3] * 4], [3.0, 1.0, *[0.3] * 4]
    for theta0, mu0, *start in RNG.uniform(low, high, (count, 6)).tolist():
        p = ss.Parameters.article(theta0=theta0, mu0=mu0)
        problem = prepare(
            p.model, p.replace(**BELT), start=tuple(start), t_end=t_end, rtol=1e-10, **options
        )
        found.append(replace(problem, t_record=t_record))
    return found


def broken(problem: Problem) -> Problem:
    """A motion whose numbers overflow."""
    return replace(problem, start=(0.1, 0.1, 1e200, 0.0))


def watched(some: list[Problem]) -> list[Any]:
    """What is measured while motions are integrated, or why there is nothing."""
    return with_heyoka.measured(some)[0]


def assert_same(left: Any, right: Any) -> None:
    """To the last bit, turning points and all."""
    for name in ("first", "last", "maxima_t", "maxima", "integrals", "minima", "events"):
        np.testing.assert_array_equal(getattr(left, name), getattr(right, name), err_msg=name)
    assert left.reach == right.reach


@pytest.mark.parametrize("burst", [5, with_heyoka.BURST])
def test_a_motion_is_the_same_alone_and_among_others(
    monkeypatch: pytest.MonkeyPatch, burst: int
) -> None:
    monkeypatch.setattr(
        with_heyoka, "BURST", burst
    )  # the shorter it is, the more often some have ended while others go on
    some = problems(21)  # more than two fillings, and a rest
    together = watched(some)
    order = RNG.permutation(len(some)).tolist()
    shuffled = watched([some[row] for row in order])
    for place, row in enumerate(order):
        assert_same(together[row], shuffled[place])
    for row in (0, 7, 20):
        assert_same(together[row], watched([some[row]])[0])


@pytest.mark.parametrize("burst", [5, with_heyoka.BURST])
def test_motions_that_break_off_cost_themselves_alone(
    monkeypatch: pytest.MonkeyPatch, burst: int
) -> None:
    monkeypatch.setattr(with_heyoka, "BURST", burst)
    good = problems(19)
    enough = (
        max(simulate_steps(problem) for problem in good) + 5
    )  # steps before a new beginning do not count
    good = [replace(problem, max_steps=enough) for problem in good]
    some = good.copy()
    for place in (0, 3, 4, 12, len(some)):
        some.insert(place, broken(good[0]))
    found, expected = watched(some), watched(good)
    bad = [row for row, problem in enumerate(some) if problem.start[2] == 1e200]
    assert all("left the range of numbers" in str(found[row]) for row in bad)
    for place, row in enumerate(row for row in range(len(some)) if row not in bad):
        assert_same(found[row], expected[place])
    short = replace(good[0], max_steps=5)
    with pytest.raises(ConvergenceError, match="5 steps were made") as alone:
        integrators.integrate(short, "heyoka")
    assert str(watched([short])[0]) == str(alone.value)


def test_a_missed_crossing_is_the_failure_of_its_motion() -> None:
    """A motion that begins in another mode than its own passes y = 0 in the wrong direction."""
    some = problems(9)
    some[4] = replace(some[4], start=(0.0, 0.2, 0.0, -0.3))
    expected, field = watched(some), some[4].field
    wrong = replace(field, initial_mode=lambda *of: (1, *field.initial_mode(*of)[1:]))
    found = watched([*some[:4], replace(some[4], field_of=lambda _: wrong), *some[5:]])
    assert "missed a kink" in str(found[4])
    for row in (0, 1, 2, 3, 5, 6, 7, 8):
        assert_same(found[row], expected[row])


def simulate_steps(problem: Problem) -> int:
    """Steps of the integrator of one motion."""
    carried = compiled(problem.field, problem.rtol).begun(problem)
    carried.motion()
    return carried.some[0].steps


@pytest.mark.thorough
def test_lanes_measure_what_the_samples_of_a_trajectory_give() -> None:
    some = problems(9, t_end=40.0, t_record=10.0)
    found = watched(some)
    for statistics, problem in zip(found, some, strict=True):
        p = ss.Parameters.article(
            theta0=np.arctan2(problem.constants[1], problem.constants[0]), mu0=problem.constants[2]
        )
        x0, y0, vx0, vy0 = problem.start
        tr = simulate(
            p, **BELT, x0=x0, y0=y0, vx0=vx0, vy0=vy0, t_end=40.0, rtol=1e-12, backend="scipy"
        ).after(10.0)
        np.testing.assert_allclose(statistics.last, tr.state[:, -1], atol=1e-7)
        assert statistics.means == pytest.approx([tr.mean(0.0), tr.mean(0.0, of="y")], abs=1e-8)
        assert max(map(abs, statistics.reach)) == pytest.approx(tr.largest(0.0), abs=1e-8)
        assert statistics.events.tolist() == [len(tr.events.of(kind)) for kind in Event]
        np.testing.assert_allclose(statistics.maxima, tr.statistics().maxima, atol=1e-7)


def test_a_failure_of_the_machine_names_the_task(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("spragsym.motion.sweeps.many._together", lambda *_: 5)

    def fails(*_: object) -> None:
        raise MemoryError

    monkeypatch.setattr(integrators, "measure", fails)
    p = ss.Parameters.article(theta0=np.linspace(0.5, 1.0, 7))
    with pytest.raises(
        SweepError,
        match=r"stopped at one of 5 points, of which the first is theta0 = 0\.5, .*: MemoryError",
    ):
        rms_sweep(p, **BELT, t_end=10.0)
