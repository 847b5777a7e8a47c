"""``spragsym critical``: where the state of small deformation jumps first, and the frictions that decide whether it can."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import click
import numpy as np

import spragsym as ss

from ..bifurcation.paths import first_end
from ..bifurcation.points import ranges
from ..errors import ParameterError, SpragsymError
from ..progress import show_progress
from .of_model import Case, followed, following, method, of_model
from .options import as_json
from .spans import Span, Typed, span, vary
from .states import placed
from .tables import print_json, print_table

#: What is nearer to 0 than all normal floats is printed as 0.
LEAST = 2.0**-1022


@of_model(statics=True)
@vary("What moves: a parameter, with --data a quantity of the file too; with a range, from its first end on. Default: {last}.")
@followed
@method
@as_json
def critical(case: Case, vary: Typed | None, near: tuple[str, ...], json_output: bool) -> None:
    """Where the state of small deformation jumps first as one parameter moves, and the frictions that decide whether it can.

    Friction and inclination rise from their lower end; the others move up and down from their value, at a friction at which
    nothing has jumped.

    \b
    Examples:
      spragsym critical --theta0 40
      spragsym critical --data brake.toml --vary theta0
      spragsym critical --model two_springs --theta0 40 --vary mu0=0:1

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    along = span(case, vary, case.model.axes[-1])
    from_end = along.name in case.model.axes or along.ends is not None
    p = following(case, case.set(*([along.name] if from_end else [])), near)
    with show_progress(f"following the state along {along.name}"):
        frictions, remarks = _frictions(case, p)
        jumped = (
            not from_end
            and "mu0" in case.model.parameters
            and bool((frictions["mu0_jump"] or math.inf) <= float(case.values["mu0"]))
        )
        ways = ["range"] if along.ends else ["up"] if from_end else ["up", "down"]
        jumps = [{"way": way, **_first(case, p, along, way, jumped)} for way in ways]
    if json_output:
        told = {"model": case.model.name, "vary": along.title, "jumps": jumps, "jumped": jumped}
        print_json({**told, **frictions, "remarks": remarks})
        return
    none = "it has jumped already" if jumped else "never"
    rows = [(f"{along.title} at the first jump, {_where(jump)}", _or(jump[along.title], none)) for jump in jumps]
    shown = _meanings(case, frictions, along.name)
    for name, text in shown.items():
        rows.append((text, _or(frictions[name], "unknown" if frictions[name] is None else "none")))
    print_table("", ("", "value"), rows)
    for remark in remarks:
        if remark.partition(":")[0] not in {*frictions} - {*shown}:
            click.echo(remark)


def _where(jump: dict[str, Any]) -> str:
    low, high = jump["searched"]
    return f"from {low:g} to {high:g}" if math.isfinite(high - low) else str(jump["way"])


def _or(value: float | None, word: str) -> float | str:
    return value if value is not None and math.isfinite(value) else word


def _first(case: Case, p: Any, along: Span, way: str, jumped: bool) -> dict[str, Any]:
    """Where the state ends first, by closed forms where the model has them; ``searched`` says up to where."""
    ends = _ends(case, p, along, way)
    name, searched = along.name, tuple(along.unit * end if abs(end) >= LEAST else 0.0 for end in ends)
    (entry,) = [entry for entry in case.model.about["parameters"] if entry["name"] == name]
    found: tuple[float, str, Mapping[str, float], float] | None = None
    if jumped:
        searched = (math.nan, math.nan)
    elif case.has_closed("first_ends") and p.followed is None and along.ends is None and entry["role"] == "both":
        searched = (-math.inf, math.inf)
        at = float(ss.jump_value(p, name, direction=way))
        if math.isfinite(at):
            folds = ss.folds(p, name)
            row = int(np.abs(getattr(folds, name) - at).argmin())
            before = {key: float(column[row]) for key, column in folds.coordinates.items()}
            found = at, str(folds.kind[row]), before, float(folds.error[row])
    elif (end := first_end(p.of(case.model.search), name, ends)) is not None:
        found = end.value, end.kind, end.before, end.error
    value, kind, places, error = found or (math.nan, None, dict.fromkeys(case.model.coordinates, math.nan), math.nan)
    return {
        "searched": list(searched), along.title: along.unit * value if found else None, "kind": kind,
        **placed(case.units, case.model.coordinates, lambda key: places[key]), "error": error,
    }  # fmt: skip


def _ends(case: Case, p: Any, along: Span, way: str) -> tuple[float, float]:
    """From where to where the parameter moves: to an end of its range, or to 10 base values where that has none."""
    if along.ends is not None:
        return along.ends
    name, (entry,) = along.name, [entry for entry in case.model.about["parameters"] if entry["name"] == along.name]
    low, high = ranges(case.model, (name,), {})[0].tolist()
    # An end that does not belong to the range: the next float does, and there is none between them.
    low = math.nextafter(low, math.inf) if entry["low_open"] else low
    high = math.nextafter(high, -math.inf) if entry["high_open"] and entry["high"] is not None else high
    if name in case.model.axes:
        return low, high
    return float(getattr(p, name)), high if way == "up" else low


def _frictions(case: Case, p: Any) -> tuple[dict[str, Any], list[str]]:
    """The frictions that decide; None for what can't be told, with the reason."""
    model, ask, remarks = case.model, case.ask, []
    with_mu0, plane = _has(case)

    def told(name: str, question: Callable[[], Any]) -> Any:
        try:
            return question()
        except SpragsymError as reason:
            remarks.append(f"{name}: {reason}")
            return None

    def jump() -> float | None:
        if None in case.values.values():  # of one that varies
            return None
        if not with_mu0:
            raise ParameterError(f"{model.name} has no mu0")
        value = float(ss.jump_value(p, "mu0"))
        if math.isnan(value) and not case.has_closed("first_ends"):
            remarks.append(f"mu0_jump: followed up to mu0 = {ranges(model, ('mu0',), {})[0, 1]:g}; beyond that it is not known")
        return value

    def cusp() -> float | None:
        if not plane:
            raise ParameterError(f"{model.name} has not both theta0 and mu0")
        return float(ss.cusp_friction(p, **ask))

    def fold() -> Any:
        if not plane:
            raise ParameterError(f"{model.name} has not both theta0 and mu0")
        found = ss.critical_friction(p, **ask)
        remarks.extend(f"mu0_lowest: {text}" for text in found.remarks)
        return found if found.complete else None

    lowest = told("mu0_lowest", fold)
    return {
        "mu0_jump": told("mu0_jump", jump), "mu0_lowest": None if lowest is None else float(lowest),
        "theta0_lowest_deg": None if lowest is None else math.degrees(lowest.theta0),
        "kind_lowest": None if lowest is None else lowest.kind or None, "mu0_cusp": told("mu0_cusp", cusp),
        "mu_cr": told("mu_cr", lambda: float(ss.linear_critical_friction(p))),
    }, case.units.said(remarks)  # fmt: skip


def _has(case: Case) -> tuple[bool, bool]:
    """Whether the model has μ₀, and both μ₀ and θ₀."""
    return "mu0" in case.model.parameters, {"mu0", "theta0"} <= set(case.model.parameters)


def _meanings(case: Case, frictions: dict[str, Any], vary: str) -> dict[str, str]:
    """What each friction is, of those that the model has."""
    kind = frictions["kind_lowest"]
    place = f" ({'to' if kind == 'infinity' else 'a'} {kind}, at {frictions['theta0_lowest_deg']:.6g} deg)" if kind else ""
    with_mu0, both = _has(case)
    if not both:
        return {"mu0_jump": "mu0_jump: mu0 of the jump"} if with_mu0 and vary != "mu0" else {}
    known = {} if vary == "theta0" else {"mu0_jump": "mu0_jump: mu0 of the jump at this angle"}
    linear = {"mu_cr": "mu_cr, linear sprag model: poles above it"} if case.has_closed("linear_critical_friction") else {}
    lowest = {"mu0_lowest": f"mu0_lowest: no jump below this mu0{place}", "mu0_cusp": "mu0_cusp: mu0 of the lowest cusp"}
    return known | lowest | linear
