"""Looks at boxes by compiled code against those of NumPy: searches drop, prove and cut the same
boxes and give the same bits.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.defining_systems import (
    FOLD,
    NO_SLOPE,
    Augmented,
    Family,
    both,
    of_kind,
    touch,
    touch_turn,
    turn,
)
from spragsym.bifurcation.points import Logarithmic
from spragsym.bifurcation.singularities import cusp_off_mirrors
from spragsym.numerics import boxes, certified_roots, plans, tape
from spragsym.numerics.interval_arrays import FloatArray, Intervals, quiet
from spragsym.statics.balance import Balance
from spragsym.statics.systems import StateSystem
from tests.conformance.models import RESTING, load
from tests.numerics.test_tape import systems

pytestmark = pytest.mark.skipif(not plans.available(), reason="no C compiler on installation")

#: What a search ends with.
PARTS = ("unique", "where", "undecided")


def same(one: boxes.SearchOutcome, other: boxes.SearchOutcome, key: str) -> None:
    assert one.looks == other.looks, key
    for name in PARTS:
        found, expected = getattr(one, name), getattr(other, name)
        np.testing.assert_array_equal(found.ends, expected.ends, err_msg=f"{key}, {name}")
        np.testing.assert_array_equal(found.nodes, expected.nodes, err_msg=f"{key}, {name}")


def compared(
    key: str, monkeypatch: pytest.MonkeyPatch, system: StateSystem, *given: FloatArray, **how: Any
) -> boxes.SearchOutcome:
    with quiet():
        assert system.plan(system.prepared(Intervals.between(*given[1:]))) is not None, key
    found = boxes.search(system, *given, **how)
    with monkeypatch.context() as without:
        without.setattr(plans, "compiled", None)
        same(found, boxes.search(system, *given, **how), key)
    return found


def further(name: str) -> Iterator[tuple[str, StateSystem, FloatArray]]:
    """Systems of a model beside those of other tests: of two parameters, by logarithms, and where
    states on a border do not count.
    """
    for contact, apart in ((True, False), (False, True), (False, False)):
        balance = Balance(load(name), contact).extended(slack=0.125)
        balance.apart = apart
        values = [getattr(load(name).Parameters(), code) for code in balance.parameters]
        column = np.array([[0.3 if value is None else float(value)] for value in values])
        yield f"contact {contact}, {apart}", balance, column
    vary = tuple(code for code in balance.parameters if code in balance.balanced)
    family = Family.of(load(name).Parameters(), vary[:1])
    if len(load(name).frictions) == 1:  # of several there are more equations than unknowns
        yield "no slope", Augmented(family, NO_SLOPE), family.begin
    if len(vary) < 2:
        return
    family = Family.of(load(name).Parameters(), vary[:2])
    conditions = {"turn": turn(0), "BT": of_kind("BT", None)}
    for contact in balance.opens:
        conditions[f"touch turns, {contact}"] = touch_turn(contact)
        conditions[f"fold on border, {contact}"] = both(FOLD, touch(contact))
    if balance.n < 3:
        conditions["cusp off mirrors"] = cusp_off_mirrors(family)
    for key, condition in conditions.items():
        yield key, Augmented(family, condition), family.begin


@pytest.mark.thorough
@pytest.mark.parametrize("name", RESTING)
def test_every_system_is_searched_as_by_numpy(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    every = [(key, *given) for key, given in systems(name).items()]
    looks = 0
    for key, system, column in [*every, *further(name)]:
        region = np.full((2, system.n, 1), 1.25)
        found = compared(f"{name}, {key}", monkeypatch, system, region, column, column, budget=60)
        looks += found.looks
    assert looks > 100


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["kang_nam", "cubic_contact", "two_springs"])
def test_a_question_is_searched_as_by_numpy(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Over whole regions, with the anchors of springs in them."""
    found: list[boxes.SearchOutcome] = []
    search = boxes.search

    def noted(*given: Any, **how: Any) -> boxes.SearchOutcome:
        found.append(search(*given, **how))
        return found[-1]

    monkeypatch.setattr(boxes, "search", noted)
    p = load(name).Parameters(mu0=0.7)
    ss.folds(p, vary="theta0", method="search")
    with monkeypatch.context() as without:
        without.setattr(plans, "compiled", None)
        ss.folds(p, vary="theta0", method="search")
    half = len(found) // 2
    assert sum(one.looks for one in found[:half]) > 500
    for one, other in zip(found[:half], found[half:], strict=True):
        same(one, other, name)


@pytest.mark.parametrize("name", ["cubic_contact", "two_springs", "sprag_rod"])
def test_many_points_are_searched_as_by_numpy(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(83)
    system, column = systems(name)["contact True"]
    points = np.repeat(column, 12, axis=1) * rng.uniform(0.9, 1.1, (len(column), 12))
    region = np.full((2, system.n, 12), 1.0) * rng.uniform(1.0, 2.0, 12)
    found = compared(name, monkeypatch, system, region, points, points, budget=40)
    assert np.unique(found.unique.nodes).size > 1
    # Over boxes of parameters.
    compared(name, monkeypatch, system, region, points, points + 1e-3, budget=40)
    # Where one is 0 at all points, with a plan, though some nodes are of no points.
    gone = points.copy()
    gone[system.balance.parameters.index(system.balance.may_vanish[-1])] = 0.0
    compared(name, monkeypatch, system, region, gone, gone, budget=40)
    with quiet():
        assert system.plan(system.prepared(boxes.tree(gone, gone).bounds)) is not None
    # Where it is 0 at some points only, the roots are those of each point alone.
    mixed = np.where(np.arange(12) % 2, points, gone)
    with quiet():
        assert system.plan(system.prepared(boxes.tree(mixed, mixed).bounds)) is not None
    roots = certified_roots.search(system, region, mixed, mixed)
    alone = [
        certified_roots.search(system, *(part[..., k : k + 1] for part in (region, mixed, mixed)))
        for k in range(12)
    ]
    assert not roots.undecided_point.size
    assert np.bincount(roots.point, minlength=12).tolist() == [one.point.size for one in alone]
    off = np.abs(roots.middle - np.concatenate([one.middle for one in alone], axis=1))
    assert (off <= 1e-12 * (1 + np.abs(roots.middle))).all()


def test_logarithms_are_searched_as_by_numpy(monkeypatch: pytest.MonkeyPatch) -> None:
    p = load("cubic_contact").Parameters(theta0=0.7)
    family = Family.of(p, ("mu0",))
    condition = Augmented(family, NO_SLOPE).condition
    system = Logarithmic(family, replace(condition, equations=lambda at: (at.gap(0),)))
    region = np.full((2, system.n, 1), 1.25)
    compared("logarithm", monkeypatch, system, region, family.begin, family.begin, budget=80)


def test_tapes_of_other_systems_are_refused() -> None:
    system, column = systems("cubic_contact")["contact True"]
    made = tape.recorded(
        lambda unknowns, parameters: [unknowns[0] * parameters[0], unknowns[1]],
        *(Intervals(np.zeros((2, rows, 1))) for rows in (2, 3)),
    )
    assert made is not None
    for slopes, parameters in ((made, 3), (replace(made, outputs=4), 0)):
        with pytest.raises(ValueError, match="not as its system is"):
            plans.planned(2, 2, parameters, (made, slopes, None), plans.Exclusions())
    with quiet():
        plan = system.plan(system.prepared(Intervals.point(column)))
    assert plan is not None
    with pytest.raises(ValueError, match="do not have the shape"):
        plan.kept(np.zeros((2, 3, 5)), Intervals(np.zeros((2, len(column), 5))), 0.05)
    with pytest.raises(ValueError, match="do not have the shape"):
        plan.kept(np.zeros((2, 2, 5)), Intervals(np.zeros((2, 1, 5))), 0.05)
