"""What to do next: at most five steps that follow from the facts of a report."""

from __future__ import annotations

import math
import shlex
from collections.abc import Iterator
from typing import TYPE_CHECKING

from .brake_files import example_of
from .tolerances import deciding

if TYPE_CHECKING:
    from .reports import Report

#: Steps at most, and quantities that one of them names.
MOST, NAMED = 5, 4


def next_steps(report: Report) -> Iterator[tuple[str, str]]:
    """Verb and object of each step, the most useful first, the command to go on with last."""
    study, steps = report.study, [*_changes(report), *_ranges(report), *_measurements(report), *_other_state(report)]
    command = f"spragsym explore --data {shlex.quote(study.source)}, to walk over the folds and let it move"
    run = [("run", command)] if study.source else []
    yield from (*steps[: MOST - len(run)], *run)


def _changes(report: Report) -> Iterator[tuple[str, str]]:
    study = report.study
    if study.rise is None and study.kind.rises:
        yield "name", f'what rises until it jumps, in the file, as vary = "{study.kind.rises}"'
    for one in report.redesign[:1]:
        values = " and ".join(f"{name} from {study.shown(name, old)} to {study.shown(name, one.after[name])}"
                              for name, old in one.before.items())  # fmt: skip
        then = "it does not jump" if math.isnan(one.jump_at) else f"it jumps at {study.amount(one.jump_at)}"
        yield "change", f"{values}: then {then}{', proved for all tolerances' if one.outcome == 'proved' else ''}"
    if report.needed and not report.redesign:
        yield (
            "allow",
            "wider ranges in may_change, or smaller tolerances: no change within them was found that keeps it from jumping",
        )


def _ranges(report: Report) -> Iterator[tuple[str, str]]:
    study, jump, odds = report.study, report.jump_at, report.probability
    low, _, high = study.working
    if jump is not None and low < jump <= high and low < high:
        yield "narrow", f"the {study.rises.word}, {study.amount(low)} to {study.amount(high)}, to less than {study.amount(jump)}"
        return
    totals = {name: total for name, (_, total, _) in (odds.sobol if odds and odds.probability else {}).items()}
    most = max(totals, key=lambda name: totals[name] if totals[name] > 0 else 0.0, default=None)
    if most is not None and totals[most] > 0:
        yield (
            "narrow",
            f"the tolerance of {most}: it decides most, {min(1.0, totals[most]):.0%} of the variance with interactions",
        )


def _measurements(report: Report) -> Iterator[tuple[str, str]]:
    study, here = report.study, report.current
    missing = [name for name in study.kind.of_the_law if name not in study.quantities]
    if missing:
        write = " and ".join(f'{name} = "{example_of(name, study.kind.units[name])}"' for name in missing)
        yield "measure", f"{' and '.join(missing)}, and add {write}: then its motion is followed too"
    elif here is not None and here.settles is None:
        at = " and ".join(f"{frequency:.4g} Hz" for frequency in here.frequencies_hz)
        yield "measure", f"the damping of the real brake{f' at {at}' if at else ''}: the model has next to none"
    elif here is not None and not here.settles and study.belt and study.source:
        command = f"spragsym bifurcation --data {shlex.quote(study.source)} --vary {study.belt}"
        yield "find", f"the {study.belt} at which sliding becomes stable: {command}"
    exact = [name for name in deciding(study) if not study.quantities[name].varies and study.values[name]]
    if exact:
        more = f" and {len(exact) - NAMED} more" if len(exact) > NAMED else ""
        yield "measure", f"how far {', '.join(exact[:NAMED])}{more} may be off: without a tolerance they are taken as exact"


def _other_state(report: Report) -> Iterator[tuple[str, str]]:
    for place, _ in report.others[:1]:
        name, _, unit = next(iter(place)).rpartition("_")
        text = f'state = {{ {name} = "{place[f"{name}_{unit}"]:.3g} {unit}" }}'
        yield "decide", f"which stable state the brake works in; for the other one write {text}"
