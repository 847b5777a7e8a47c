"""``spragsym equilibria``, ``path`` and ``critical``: all equilibria of points, and a state that is
followed along one parameter.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import click
import numpy as np

import spragsym as ss

from ..bifurcation.critical import lowest_of_followed
from ..bifurcation.defining_systems import ranges
from ..core.errors import ConvergenceError, ParameterError, SpragsymError
from ..core.progress import show_progress
from ..core.remarks import At, Remark
from ..core.type_variables import T
from ..design.jumps import first_limit_points, require_known, verb_of
from ..display import own_name
from ..models.parameters import INSIDE, ParameterSet
from ..results.equilibria import Equilibria
from . import options as o
from .bifurcation import left_out_first, summed
from .case import Case, Row, Span
from .output import drawn, print_rows


@o.of_model(kind=o.NumberList, statics=True)
@o.vary(
    "What varies, with its ends: a parameter, or with --data a quantity of the file, as "
    "k_x=5:20 or mu0=0:1:11 for 11 values."
)
@o.within
@o.method
@o.plot("frequencies and growth rates in contact over what varies, with damping and without")
@o.force
@o.as_json
def equilibria(case: Case, plot: Path | None) -> object:
    """All equilibria at one point, in contact and in lift-off, stable and unstable; or at many.

    Every parameter may be a number, numbers a,b,c, or start:stop:count; of several, all
    combinations.

    \b
    Examples:
      spragsym equilibria --theta0 49
      spragsym equilibria --theta0 30 --mu0 0.7 --json
      spragsym equilibria --theta0 49 --mu0 0:1:11
      spragsym equilibria --data brake.toml --vary k_x=5:20
      spragsym equilibria --model cubic_contact --theta0 49
      spragsym equilibria --model mode_coupling --vary mu0=0:1 --plot modes.pdf
    """
    titles = {name: case.parameter(name) for name in case.model.parameters}
    values = dict(case.values)
    if case.spans:
        case.require_ends()
        values[case.span.name], titles[case.span.name] = (
            case.span.values,
            (case.span.title, case.span.unit),
        )
    case.require(values)
    many = [name for name, value in values.items() if np.ndim(value)]
    if plot is not None:
        _draw(case, plot, many)
    lists = [np.ravel(value).tolist() for value in values.values()]
    size = math.prod(map(len, lists))
    most_points = 10_000
    if size > most_points:
        raise click.UsageError(
            f"{size} points are more than the {most_points} of a table; in Python ss.equilibria "
            "takes any number"
        )
    with show_progress(
        f"searching for equilibria of {size} points" if many else "searching for equilibria"
    ):
        combinations = [
            dict(zip(values, combination, strict=True)) for combination in itertools.product(*lists)
        ]
        named = [
            {title: unit * at[name] for name, (title, unit) in titles.items()}
            for at in combinations
        ]
        points = [
            {"parameters": at, **one}
            for at, one in zip(named, _all_states(case, combinations), strict=True)
        ]
    return {"points": points} if many else points[0], lambda: _print(
        case, points, [titles[name][0] for name in many]
    )


def _print(case: Case, points: list[Row], many: list[str]) -> None:
    rows = [
        {title: point["parameters"][title] for title in many} | case.without_beside(row, Equilibria)
        for point in points
        for row in point["equilibria"]
    ]
    if rows:
        print_rows("", rows, left_out_first(case, rows[0]), case.formats)
    elif all(point["complete"] for point in points):
        click.echo("none, proved")
    for state in case.model.regimes.values():
        unknown = [one for point in points for one in point["undecided"] if one["state"] == state]
        if boxes := [one for one in unknown if len(one) > len(("state", "reason"))]:
            click.echo(f"{state}: not complete, {summed(boxes)}")
        for reason in dict.fromkeys(one["reason"] for one in unknown if one not in boxes):
            click.echo(f"{state}, undecided: {reason}")
    for remark in dict.fromkeys(remark for point in points for remark in point["remarks"]):
        click.echo(remark)


def _draw(case: Case, plot: Path, many: list[str]) -> None:
    """Draw eigenvalues over one parameter, in units of the answer."""
    if not case.spans or many != [case.span.name]:
        raise click.UsageError(
            "--plot shows eigenvalues over one parameter: give it as --vary NAME=FROM:TO, and "
            "numbers for others"
        )
    name = case.span.name
    p, axes = case.set(name, **{name: None}), []
    if case.study is not None:
        rate = 1 / case.time
        words = ("frequency (Hz)", rate / (2 * math.pi)), (r"growth Re $\lambda$ (1/s)", rate)
        axes = [(case.axis(name), word) for word in words]
    figure = partial(ss.figures.eigenvalue_figure, p, name, between=case.between)
    drawn(plot, f"drawing eigenvalues over {name}", figure, lambda: axes)


def _all_states(case: Case, points: list[dict[str, float]]) -> Iterator[Row]:
    """For every point the rows of its equilibria, whether these are all, and what is undecided.

    Many points are asked in one call, and those without a complete answer again one by one.
    """
    p = case.model.Parameters(
        **{name: np.array([point[name] for point in points]) for name in points[0]}
    )
    at_once = {
        contact: ss.equilibria(p, contact=contact, **case.ask)
        for contact in case.model.regimes
        if len(points) > 1
    }
    for at, point in enumerate(points):
        answer: Row = {"equilibria": [], "complete": True, "undecided": [], "remarks": []}
        for contact, state in case.model.regimes.items():
            if at_once and (at_once[contact].decided & at_once[contact].whole)[at]:
                answer["equilibria"] += _rows(case, at_once[contact], (at,))
                continue
            try:
                eq = ss.equilibria(case.model.Parameters(**point), contact=contact, **case.ask)
            except ConvergenceError as reason:  # the other regime may be decided
                answer["undecided"].append({"state": state, "reason": str(reason)})
                answer["complete"] = False
                continue
            answer["equilibria"] += _rows(case, eq)
            answer["complete"] &= eq.complete
            for one in eq.undecided:
                box = zip(one.low, one.high, strict=True)
                answer["undecided"] += case.boxes(
                    [box], case.model.coordinates, state=state, reason=one.reason
                )
            answer["remarks"] += [f"{state}: {text}" for text in case.said(eq.remarks)]
        yield answer


def _rows(case: Case, eq: Equilibria, point: tuple[int, ...] = ()) -> list[Row]:
    """Rows of the equilibria of a point: regime, stability, state, and the columns beside it."""
    count = int(eq.count[point])
    before, behind = eq.row_columns("before"), eq.row_columns("behind", "beside")
    names = (*before, *eq.state_columns, *behind)
    columns = {name: eq[name][point][:count] for name in names}
    return case.rows({own_name(case.model, "state"): [eq.regime] * count, **columns})


@o.of_model(statics=True)
@o.vary(
    "What moves, and from where to where, as mu0=0:0.9, or mu0=0.9:0:19 for 19 values; with "
    "--data a quantity of the file too."
)
@o.followed
@o.method
@o.as_json
def path(case: Case, near: tuple[str, ...]) -> object:
    """The reference state, followed as one parameter moves: where it goes and where it jumps.

    \b
    Examples:
      spragsym path --theta0 40 --vary mu0=0:0.9
      spragsym path --data brake.toml --vary theta0=10:80
      spragsym path --model two_springs --vary theta0=10:80:8
      spragsym path --model sprag_rod --theta0 30 --vary mu0=0:0.7 --state phi=-28
    """
    case.require_ends()
    along = case.span
    with show_progress(f"following a state along {along.name}"):
        found = ss.quasi_static_path(
            case.following(case.set(along.name), near), along.name, along.values, **case.ask
        )
    ours = ("stability", "undamped", "growth")
    own = partial(own_name, case.model)
    words = {own(name): getattr(found, name) for name in ours}
    states = case.rows({along.name: found.values, **words, **found.places}, ss.results.Path)
    jumps = [
        case.row({along.name: jump.value, own("kind"): jump.kind})
        | case.row(jump.before, end="_before")
        | case.row(jump.after, end="_after")
        | {own("error"): jump.error}
        for jump in found.jumps
    ]

    def tables() -> None:
        for title, rows in (("States", states), ("Jumps", jumps)):
            if rows:
                print_rows(title, rows, left_out_first(case, rows[0]), case.formats)
        if not jumps:
            click.echo("No jumps")

    return {"vary": along.title, "states": states, "jumps": jumps}, tables


@o.of_model(varies=1, statics=True)
@o.vary(
    "What moves: a parameter, with --data a quantity of the file too; with a range, from its "
    "first end on. Default: {last}."
)
@o.followed
@o.method
@o.as_json
def critical(case: Case, near: tuple[str, ...]) -> object:
    """Value at which the reference state jumps first as one parameter moves, and the frictions that
    decide whether it can.

    Friction and inclination rise from their lower end; the others move up and down from their
    value, at a friction at which nothing has jumped.

    \b
    Examples:
      spragsym critical --theta0 40
      spragsym critical --data brake.toml --vary theta0
      spragsym critical --model two_springs --theta0 40 --vary mu0=0:1
    """
    along = case.span
    from_end = along.name in case.model.axes or along.ends is not None
    p = case.following(case.set(*([along.name] if from_end else [])), near)
    with show_progress(f"following the state along {along.name}"):
        frictions, remarks = _frictions(case, p)
        own = None if from_end else case.model.coefficient
        jump = frictions["mu0_jump"] or math.inf
        jumped = own is not None and bool(jump <= float(case.values[own]))
        ways = ["range"] if along.ends else ["up"] if from_end else ["up", "down"]
        jumps = [{"way": way, **_first(case, p, along, way, jumped)} for way in ways]

    def tables() -> None:
        rows: list[Row] = []
        for jump in jumps:
            low, high = jump["searched"]
            where = f"from {low:g} to {high:g}" if math.isfinite(high - low) else jump["way"]
            never = "it has jumped already" if jumped else "never"
            verb = verb_of(jump[own_name(case.model, "kind")]).does
            first = "at the first jump" if verb == "jumps" else f"where it {verb}"
            rows.append(
                {
                    "": f"{along.title} {first}, {where}",
                    "value": _or(jump[along.title], never),
                }
            )
        shown = _meanings(case, frictions, along.name)
        for name, text in shown.items():
            rows.append(
                {
                    "": text,
                    "value": _or(frictions[name], "unknown" if frictions[name] is None else "none"),
                }
            )
        print_rows("", rows)
        for remark in remarks:
            if remark.partition(":")[0] not in {*frictions} - {*shown}:
                click.echo(remark)

    return {
        "vary": along.title,
        "jumps": jumps,
        "jumped": jumped,
        **frictions,
        "remarks": remarks,
    }, tables


def _or(value: float | None, word: str) -> float | str:
    return value if value is not None and math.isfinite(value) else word


def _first(case: Case, p: ParameterSet, along: Span, way: str, jumped: bool) -> Row:
    """The first value at which the state ends; ``searched`` has both ends of the range, which are
    infinite if all values were searched.
    """
    name = along.name
    ends = along.ends
    searched = (math.nan, math.nan)
    at = math.nan
    error = math.nan
    kind, before = None, dict.fromkeys(case.model.coordinates, math.nan)
    if not jumped:
        lowest = (
            p.ranges[name].reached(float(ranges(p, (name,), {})[0, 0]))
            if name in case.model.axes
            else None
        )
        begin, until = ends or (lowest, None)
        falls = way == "down" if ends is None else ends[1] < ends[0]
        found = require_known(
            first_limit_points(
                p, name, direction="down" if falls else "up", begin=begin, until=until, **case.ask
            )
        )
        searched = (float(p[name]) if begin is None else begin, float(found.until))
        at = float(found.value)
        if not math.isnan(at):
            kind = "fold"
            before = dict(zip(before, found.state.tolist(), strict=True))
            error = float(found.error)
        for end in found.others.values():
            kind, before = end.kind, {name: float(end.before[name]) for name in before}
    row = {"searched": [0.0 if abs(end) <= INSIDE else along.unit * end for end in searched]}
    own = partial(own_name, case.model)
    more = {own("kind"): kind, **case.row(before), own("error"): error}
    return row | {along.title: along.unit * at, **more}


def _frictions(case: Case, p: Any) -> tuple[Row, list[str]]:
    """The critical frictions, None for those without an answer; and remarks with the reasons."""
    model, remarks = case.model, list[str]()
    own, angle = model.coefficient, model.inclination
    labels = {"inclination": angle, "friction coefficient": own}

    def answer(name: str, question: Callable[[], T], *needed: str) -> T | None:
        try:
            if missing := [one for one in needed if labels[one] is None]:
                raise ParameterError(f"{model.name} has no {' and no '.join(missing)}")
            return question()
        except SpragsymError as reason:
            remarks.append(Remark("{}: {}", name, next(iter(reason.args), "")))
            return None

    def jump() -> float:
        found = require_known(first_limit_points(p, str(own)))
        if math.isnan(found.value) and math.isfinite(found.until):
            end = At(str(own), (float(found.until),), "g")
            remarks.append(Remark("mu0_jump: followed up to {}; beyond that it is not known", end))
        return float(found.value)

    def fold() -> tuple[float, float, str | None] | None:
        found = lowest_of_followed(p, **case.ask)
        remarks.extend(Remark("mu0_lowest: {}", text) for text in found.remarks)
        if found.complete:
            return (float(found), math.degrees(found.where), found.kind or None)
        return None

    lowest, at_deg, kind = answer("mu0_lowest", fold, *labels) or (None, None, None)
    varies = None in case.values.values()
    return {
        "mu0_jump": None if varies else answer("mu0_jump", jump, "friction coefficient"),
        "mu0_lowest": lowest,
        "theta0_lowest_deg": at_deg,
        "kind_lowest": kind,
        "mu0_cusp": answer("mu0_cusp", lambda: float(ss.cusp_friction(p, **case.ask)), *labels),
        "mu_cr": answer("mu_cr", lambda: float(ss.kang_nam.linear_critical_friction(p))),
    }, case.said(remarks)


def _meanings(case: Case, frictions: Row, vary: str) -> dict[str, str]:
    """Texts for those critical frictions that the model has."""
    kind, own, angle = frictions["kind_lowest"], case.model.coefficient, case.model.inclination
    where = (
        f" ({'to' if kind == 'infinity' else 'a'} {kind}, at "
        f"{frictions['theta0_lowest_deg']:.6g} deg)"
        if kind
        else ""
    )
    if own is None or angle is None:
        return {} if vary == own or own is None else {"mu0_jump": f"mu0_jump: {own} of the jump"}
    jump = {} if vary == angle else {"mu0_jump": f"mu0_jump: {own} of the jump at this angle"}
    linear = (
        {"mu_cr": "mu_cr, linear sprag model: poles above it"}
        if frictions["mu_cr"] is not None
        else {}
    )
    lowest = {
        "mu0_lowest": f"mu0_lowest: no jump below this {own}{where}",
        "mu0_cusp": f"mu0_cusp: {own} of the lowest cusp",
    }
    return jump | lowest | linear
