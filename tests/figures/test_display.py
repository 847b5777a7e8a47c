"""Results as tables: in a notebook, in print, and on the axes of a figure."""

from __future__ import annotations

import copy
import dataclasses
import functools
from collections.abc import Callable
from html.parser import HTMLParser
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.results.result import Result
from tests.support import LONG_MOTIONS_TAKE_MINUTES, few

P = ss.Parameters.article(theta0=np.radians([30.0, 49.0]))
ONE = ss.Parameters.article(theta0=0.5)
BELT: dict[str, Any] = {"V": 0.5, "d": 10.0, "backend": "scipy"}


def _basin() -> ss.Basin:
    return ss.basin(ONE, x=[0.0, 1.0], vx=[0.0, 0.1, 0.2], t_end=20.0, transient=10.0, **BELT)


SLIDING = ss.Parameters.article(theta0=np.radians(42.0))
SPEED: dict[str, float] = {"V": 0.5, "d": 10.0}


@functools.cache
def _cycle() -> ss.Cycle:
    return ss.cycle(SLIDING, **SPEED)


@functools.cache
def _branch() -> ss.CycleBranch:
    """From 42° over its doubling at 43.1°."""
    return ss.cycle_branch(_cycle(), vary="theta0", to=tuple(np.radians([41.9, 43.3])))


def _doubling() -> ss.CycleEvent:
    return next(event for event in _branch().events if event.kind == "period_doubling")


def _fate() -> ss.FateBoundary:
    return ss.fate_boundary(ss.Parameters.article(), vary="theta0", bracket=(0.7208, 0.7212), **SPEED)


def _study() -> ss.Study:
    return ss.Study(ss.PhysicalParameters(m=0.35, k=180e3, L_0=0.038, theta0=0.9, k_x=9e3, k_y=0, k_c=1.5e6, F_L=420, mu0=0.45))


MODEL = ss.load("kang_nam").search


@functools.cache
def _folds_of_a_model() -> Any:
    return ss.folds(MODEL.Parameters(), vary="theta0")


#: What gives each kind of result.
RESULTS: dict[str, Callable[[], Any]] = {
    "Parameters": lambda: P,
    "PhysicalParameters": lambda: ss.PhysicalParameters(1, 1, 1, 1, 1, 1, 1, 1, 1),
    "Scales": lambda: ss.PhysicalParameters(1, 1, 1, 1, 1, 1, 1, 1, 1).scales,
    "Equilibria": lambda: ss.equilibria(P),
    "Surface": lambda: ss.surface(ONE, 1.0, [[0.5], [0.6]]),
    "Points": lambda: ss.folds(ONE),
    "Points of two parameters": lambda: ss.cusps(ONE),
    "LowestEnd": lambda: ss.critical_friction(ONE.replace(beta=[0.0, 1.0])),
    "BifurcationSet": lambda: ss.bifurcation_set(ONE, n=600),
    "Curve": lambda: ss.bifurcation_set(ONE, n=600).curves[0],
    "FlutterBoundary": lambda: ss.flutter_boundary(ONE.replace(alpha=0.7), 50),
    "Onsets in closed form": lambda: ss.flutter_onsets(ONE.replace(alpha=0.7), damping=False),
    "LinearSprag": lambda: ss.linear_sprag(P),
    "Path": lambda: ss.quasi_static_path(ss.Parameters.article(mu0=0.7), "theta0", np.radians(np.arange(1.0, 180.0))),
    "Jump": lambda: ss.quasi_static_path(ss.Parameters.article(mu0=0.7), "theta0", [0.5, 1.0]).jumps[0],
    "Trajectory": lambda: ss.simulate(ONE, t_end=20.0, events=False, **BELT),
    "Outcome": lambda: ss.simulate(ONE, t_end=20.0, **BELT).outcome(),
    "Events": lambda: ss.simulate(ONE.replace(theta0=0.9), t_end=40.0, **BELT).events,
    "Sweep": lambda: ss.rms_sweep(P, t_end=20.0, **BELT),
    "Basin": _basin,
    "JumpGradient": lambda: ss.jump_gradient(P),
    "JumpMargin": lambda: ss.jump_margin(ONE, {"mu0": 0.05}),
    "JumpProbability": lambda: ss.jump_probability((ONE, ONE.replace(mu0=0.9)), n=256, rng=1),
    "Certificate": lambda: ss.certify(ONE, ONE, "no jump"),
    "Redesign": lambda: ss.redesign(ONE, "theta0", {"mu0": 0.8}),
    "Cycle": _cycle,
    "CycleBranch": _branch,
    "CycleEvent": _doubling,
    "EventCurve": lambda: ss.cycle_events(_doubling(), vary=("theta0", "mu0"), points=1),
    "Fate": lambda: ss.fate(SLIDING, **SPEED),
    "FateBoundary": _fate,
    "FateMap": lambda: ss.fate_map(ss.Parameters.article(theta0=np.radians([30.0, 35.0])), **SPEED),
    "BasinBoundary": lambda: ss.basin_boundary(ss.Parameters.article(theta0=np.radians(40.0)), **SPEED, step=0.05, points=1),
    "Lyapunov": lambda: ss.lyapunov(SLIDING, **SPEED, start=_cycle().state, t_end=2 * _cycle().period),
    "Report": lambda: _study().report(probability=False, redesign=False, oscillation=False),
    "Points of a search": lambda: _folds_of_a_model(),
    "Onsets": lambda: ss.flutter_onsets(ss.load("stick_slip").Parameters(), vary="V"),
    "Path of a search": lambda: ss.quasi_static_path(MODEL.Parameters(), "theta0", [0.5, 0.6]),
    "Diagram": lambda: ss.diagram(ss.load("stick_slip").Parameters(), "V", (0.05, 0.3), points=60),
    "Sensitivity": lambda: ss.sensitivity(P, [0.5], [10.0], refine=1, t_end=20.0, backend="scipy"),
}


#: Those that take long motions.
LONG_MOTIONS = (
    "Cycle", "CycleBranch", "CycleEvent", "Diagram", "EventCurve", "Fate", "FateMap", "FateBoundary", "BasinBoundary",
    "Lyapunov",
)  # fmt: skip


class Tables(HTMLParser):
    """Rows of cells; an error for tags that do not match."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.rows: list[list[str]] = []
        self.feed(text)
        assert not self.open

    def handle_starttag(self, tag: str, attrs: Any) -> None:
        self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        elif tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if self.open and self.open[-1] in ("td", "th"):
            self.rows[-1][-1] += data


def test_every_result_is_known_here() -> None:
    """All public dataclasses have a table."""
    kinds = {name for name in ss.__all__ if dataclasses.is_dataclass(getattr(ss, name))}
    assert kinds <= set(RESULTS)


@pytest.mark.by_hand("BasinBoundary", "FateBoundary")
@pytest.mark.parametrize(
    "kind",
    few(RESULTS, "Equilibria", "Points", "BifurcationSet", "Jump", "Trajectory", "Sweep", "JumpProbability"),
)
def test_a_notebook_gets_a_table(kind: str) -> None:
    if kind in LONG_MOTIONS and LONG_MOTIONS_TAKE_MINUTES:
        pytest.skip(LONG_MOTIONS_TAKE_MINUTES)
    result = RESULTS[kind]()
    text = result._repr_html_()
    assert text == copy.deepcopy(result)._repr_html_()  # of equal results
    rows = Tables(text).rows
    assert 2 <= len(rows) < 100
    assert all(cell for cell in rows[0][1:])
    assert "array(" not in text
    assert not any("\n" in cell for row in rows for cell in row)
    # Radians stand under no heading: every angle is in degrees, and says so.
    headings = [cell for row in rows for cell in row if cell.split(" ")[0].startswith(("theta", "poles"))]
    assert all(heading.split(" ")[0].endswith("_deg") for heading in headings)
    if type(result).__str__ is Result.__str__:
        assert all(cell in str(result) for row in rows for cell in row)
    assert repr(result).startswith(f"{kind.split()[0]}(")
