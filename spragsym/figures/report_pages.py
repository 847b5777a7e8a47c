"""A report as a self-contained HTML page, with pictures as SVG. The same report gives the same
bytes.
"""

from __future__ import annotations

import hashlib
import math
import re
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any
from urllib.parse import quote

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle
from matplotlib.style import context

import spragsym as ss

from ..bifurcation.defining_systems import ranges
from ..bifurcation.flutter import ON_UNSTABLE
from ..bifurcation.hopf_curves import OnsetCurves
from ..core.errors import ConvergenceError, SpragsymError
from ..files.text import filled
from ..models.load import mechanism
from ..models.parameters import ParameterSet, Ranges, Span
from ..report.advice import Rows, warnings
from ..report.batch import BatchReport
from ..report.facts import Facts
from ..report.states import Oscillation, unit_of
from ..report.study import Study
from ..report.texts import about as about_of
from ..report.texts import sections, verdict
from ..results import BifurcationSet, Points
from ..statics.stability import NEUTRAL_GROWTH
from .curves import curves_between, draw_branches, draw_path, mark_folds
from .motions import draw_phase, draw_spectrum, steady_belts
from .planes import draw_onset_curves, draw_plane, growth_of_oscillations, on_undecided
from .style import (
    BLACK,
    BLUE,
    GREY,
    SKY,
    VERMILION,
    Shown,
    house_style,
    in_units,
    single,
    symbol,
)
from .style import picture as content


def report_page(report: Facts) -> str:
    """Text of a self-contained HTML page with a report (extra ``plot``)."""
    study, about = report.study, about_of(report)
    data = [
        (
            f"{name}, {study.kind.meanings[name]}",
            study.shown(name)
            + f", {study.shown(name, one.low)} to {study.shown(name, one.high)}" * one.varies,
        )
        for name, one in study.quantities.items()
    ]
    headed = dict(sections(report))
    del headed["Warnings"]
    steps = headed.pop("What to do next")
    title = about.pop("title") or "Sprag-slip report"
    return filled(
        "spragsym.figures",
        "report.html",
        "the page of a report",
        title=title,
        about=", ".join(filter(None, about.values())),
        verdict=" ".join(verdict(report)),
        at_risk=report.at_risk,
        steps=steps,
        warnings=warnings(report),
        drawn=pictures(report),
        headed=(headed | {"Data": data}).items(),
        mechanism=quote(mechanism(study.kind.model)),
        drawing=study.kind.drawing,
    )


def pictures(report: Facts) -> Rows:
    """The pictures of a report as SVG, with captions; without those that the model does not
    have.
    """
    study, odds = report.study, report.probability
    if study.load is not None:
        yield from _planes(report)
    if study.of_friction:
        yield from _stability_map(report)
    if odds is not None and not all(np.isnan(one[1]) for one in odds.sobol.values()):
        caption = (
            "Which tolerance decides whether it jumps: Sobol' indices, inner bars alone, "
            "outer ones with interactions; lines: 95 % intervals."
        )
        yield picture(partial(draw_shares, odds.sobol)), caption
    if report.oscillation is not None and report.oscillation.alive:
        yield from _of_motion(report, report.oscillation)


def _planes(report: Facts) -> Rows:
    """The brake in the plane of angle and friction, if the model has these and something is in the
    plane; and its states over the loading parameter.
    """
    study, p = report.study, report.study.operating_point
    lowest = math.nan if report.mu_lowest is None else report.mu_lowest
    jump = math.nan if report.mu_jump is None else report.mu_jump
    has_axes = p.model.inclination is not None and p.model.coefficient is not None
    if study.of_friction and has_axes and not lowest > _top(study.in_use[2], jump):
        with suppress(SpragsymError):
            yield _bifurcation_plane(study, jump)
    yield _states_over_load(report)


def _bifurcation_plane(study: Study, jump: float) -> tuple[str, str]:
    """Picture and caption: bifurcation set, the brake and the friction ``jump`` at which its state
    jumps, which may be NaN.
    """
    p, (low, _, high) = study.operating_point, study.in_use
    angle, friction = p.model.axes
    angles = study.quantities[str(study.kind.inclination)]
    box = {angle: (angles.low, angles.high), friction: (low, high)}
    plane = list[tuple[BifurcationSet, bool]]()

    def draw(ax: Axes) -> None:
        plane.append(draw_plane(ax, p, {friction: (0.0, _top(high, jump))}, n=40))
        mark_brake(ax, p, box, jump)

    image = picture(draw)
    found, shaded = plane[0]
    caption = "Where the brake works (dot)"
    if _varies(box):
        caption += " and its tolerances (box)"
    caption += ". On the lines two states of sliding meet"
    if shaded:
        caption += "; where it is shaded there are three"
    caption += f".{on_undecided(found)}"
    if jump < math.inf:
        caption += " Cross: the friction at which the reference state jumps at this angle."
    return image, caption


def _states_over_load(report: Facts) -> tuple[str, str]:
    """Picture and caption: states over the loading parameter, and the path of the followed one."""
    study, vary = report.study, report.study.loading.name
    low, _, high = study.in_use
    if study.of_friction:
        load, begin = "the friction", 0.0
        x_axis: Shown = r"friction $\mu$", 1.0
    else:
        load, begin, scale = study.loading.quantity, study.start(), study.load_scale
        low, high, unit = low / scale, high / scale, study.quantities[load].unit
        # Angles are drawn in degrees.
        drawn = math.radians(1.0) if study.kind.units[load] == "rad" else 1.0
        x_axis = f"{load} in {unit}" if unit else load, study.in_file(load, drawn * scale)
    coordinate, (unit, size) = study.kind.about["coordinates"][0], unit_of(study)
    y_axis = f"{coordinate['name']} in {unit}", size if unit == "mm" else 1.0
    drawing = list[tuple[list[Any], bool]]()
    image = picture(
        lambda ax: drawing.append(
            draw_rising(ax, study.operating_point, vary, (low, high), begin, (x_axis, y_axis))
        )
    )
    path, hatched = drawing[0]
    has_folds = vary in report.folds and len(report.folds[vary]) > 0
    followed = ", where it is not followed"
    if path:
        followed = " (orange, with its jumps)" if has_folds else " (orange)"
    meaning = coordinate["meaning"].partition(",")[0]
    caption = f"{meaning[:1].upper()}{meaning[1:]} as {load} rises{followed}; grey: all states, "
    caption += "full where stable."
    if hatched:
        caption += " Hatched: where states or folds may be missing."
    if has_folds:
        caption += " Dots: folds, where two states meet and end."
    if high > low:
        caption += f" Shaded: {load} within its tolerances."
    return image, caption


def _stability_map(report: Facts) -> Rows:
    """Onsets of oscillation over angle and friction; nothing if the belt or the friction law is not
    known.
    """
    study, p = report.study, report.study.operating_point
    angle, friction = p.model.inclination, p.model.coefficient
    if angle is None or friction is None or not study.moves:
        return
    angles, between = study.quantities[str(study.kind.inclination)], study.friction[::2]
    folds = report.folds[friction][friction].tolist() if friction in report.folds else []
    top = max(_TOP, 1.15 * between[1], *(1.15 * value for value in folds if value < _FAR))
    with suppress(SpragsymError):
        # 12 lines on which onsets of oscillation are searched for.
        onsets = ss.onset_curves(p, (angle, friction), 12, between={friction: (0.0, top)})
        if not onsets.curves and not len(onsets.undecided):  # the plane would be empty
            return
        box = {angle: (angles.low, angles.high), friction: between}
        shown = {name: _around(onsets, name, box[name]) for name in onsets.vary}

        def draw(ax: Axes) -> None:
            draw_onset_curves(onsets, ax, shown=shown)
            mark_brake(ax, p, box)

        if float(growth_of_oscillations(ss.equilibria(p))) > NEUTRAL_GROWTH:
            what = "grow: it squeals or judders"
        elif report.current is not None and report.current.stability == "neutral":
            what = "hardly grow or die out, as next to nothing damps"
        else:
            what = "die out"
        yield (
            picture(draw),
            f"The map of stability. The brake (dot) works where small oscillations {what}; they "
            f"grow in a state at least where it is shaded, hardly where lightly. "
            f"{'Box: its tolerances. ' * _varies(box)}{_kinds_of(onsets)}",
        )


def _varies(box: Ranges) -> bool:
    """True if a box of tolerances has an extent."""
    return any(high > low for low, high in box.values())


def _around(onsets: OnsetCurves, name: str, ends: Span) -> Span:
    """Range of an axis that contains the curves and the brake, with a margin."""
    values = np.concatenate([*(curve[name] for curve in onsets.curves), ends])
    low, high = onsets.between[name]
    # At least this share of the range of the search.
    margin = max(_MORE * float(np.ptp(values)), 0.03 * (high - low))
    return max(low, float(values.min()) - margin), min(high, float(values.max()) + margin)


def _kinds_of(onsets: OnsetCurves) -> str:
    """Legend of the lines and points of the map, in words."""
    kinds = {str(kind) for curve in onsets.curves for kind in curve.criticality}
    # For each kind of onset the style of its line, and an explanation.
    looks = {
        "supercritical": ("full line", "it begins with a small amplitude (supercritical)"),
        "subcritical": ("dashed", "with a large one at once (subcritical)"),
        "undecided": ("dotted", "which of the two is not decided"),
    }
    lines = [f"{line}: {words}" for kind, (line, words) in looks.items() if kind in kinds]
    if any((curve.onset == ON_UNSTABLE).any() for curve in onsets.curves):
        lines.append("grey: of a state that is unstable on both sides")
    if len(onsets.changes["error"]):
        lines.append("GH: where that changes")
    # Explanations of points of codimension two.
    meetings = {
        "BT": "BT: a line ends where two states meet",
        "ZH": "ZH: a line touches one on which two states meet",
        "HH": "HH: two lines cross, and two frequencies set in",
    }
    lines += [text for kind, text in meetings.items() if kind in onsets.points.kind]
    text = "; ".join(lines)
    return f"{text[:1].upper()}{text[1:]}." if text else ""


def _of_motion(report: Facts, lives: Oscillation) -> Rows:
    """Phase plane and spectrum of the oscillation."""
    unit, size = unit_of(report.study)
    time = report.study.scales.time
    name = report.study.kind.model.coordinates[0]
    motion = lives.motion.trajectory(8) if lives.kind == "cycle" else lives.motion
    belt = bool(steady_belts(report.study.dimensionless, name))
    what = "speed along the belt" if belt and unit == "mm" else f"rate of {name}"
    in_si, share = ("m/s", 1e-3) if unit == "mm" else ("deg/s", 1.0)
    speed = f"{what} in {in_si}", share * size / time
    place = f"{name} in {unit}", size
    yield (
        picture(partial(draw_phase, motion, shown=(place, speed))),
        f"The oscillation: {what} over {name}, one closed curve a cycle."
        + " Dotted: the speed of the belt." * belt,
    )
    unit_of_rate, hertz = ("kHz", 1e-3) if lives.frequency_hz >= 1e3 else ("Hz", 1.0)
    shown = (f"frequency in {unit_of_rate}", hertz / time), (f"amplitude of {place[0]}", size)
    what = f"the amplitude of {name} at each frequency, through a Hann window"
    if lives.kind == "cycle":
        what = f"{name} moves at multiples of {lives.frequency_hz * hertz:.4g} {unit_of_rate} alone"
    yield picture(partial(draw_spectrum, motion, name, shown=shown)), f"Its spectrum: {what}."


def picture(draw: Callable[[Any], Any]) -> str:
    """A picture of one panel as SVG for a page. Its ids get a prefix from a hash of the picture, so
    that they are unique in the page.
    """
    letters = Path(__file__).with_name("page.mplstyle")  # fonts of the page
    with house_style(), context(letters):
        figure, ax = single(4.6, 3.3)
        draw(ax)
        text = content(figure, "svg").decode()
    text = text[text.index("<svg") :].strip()
    mark = hashlib.sha256(text.encode()).hexdigest()[:8]
    text = re.sub(r'\bid="', f'id="{mark}-', text)
    text = re.sub(r'(href="#|url\(#)', rf"\g<1>{mark}-", text)
    return re.sub(r"<!--.*?-->|<metadata>.*?</metadata>", "", text, flags=re.DOTALL)


#: Smallest upper end of an axis of friction.
_TOP = 1.0
#: Largest friction for which folds are searched; of another loading, times its value.
_FAR = 3.0
#: Margin of an axis, relative to the largest value.
_MORE = 0.15


def _top(most: float, jump: float) -> float:
    """Upper end of an axis of friction: above that in use, and above the jump if there is one."""
    return max(_TOP, 1.15 * most, 1.15 * jump if jump < _FAR else 0.0)


def mark_brake(ax: Axes, p: ParameterSet, box: Ranges, jump: float = float("nan")) -> None:
    """Mark a brake in the plane of inclination in degrees and friction: a dot, the box of its
    tolerances, and the jump, if there is one.
    """
    radians, friction = p.scalars(*p.model.axes)
    angle = np.degrees(radians)
    (left, right), (low, high) = (box[name] for name in p.model.axes)
    corner, width = (np.degrees(left), low), np.degrees(right) - np.degrees(left)
    ax.add_patch(
        Rectangle(
            corner,
            width,
            high - low,
            facecolor=SKY,
            edgecolor=BLUE,
            linewidth=0.8,
            alpha=0.6,
            zorder=3,
        )
    )
    ax.plot(angle, friction, "o", color=BLUE, markersize=4.5, zorder=5)
    if np.isfinite(jump):
        ax.plot(angle, jump, marker="x", color=BLACK, markersize=5, zorder=5)
        ax.annotate(
            f"jump at {jump:.3f}", (angle, jump), (6, -2), textcoords="offset points", va="top"
        )


def draw_rising(
    ax: Axes, p: ParameterSet, vary: str, ends: Span, begin: float, shown: tuple[Shown, Shown]
) -> tuple[list[Any], bool]:
    """Draw the states over the loading parameter, the state that is followed as it rises, and its
    tolerance, shaded; returns the artists of the path, and whether undecided ranges are hatched.

    Parameters
    ----------
    ax : Axes
    p : Parameters
        Scalars; the loading parameter is not used.
    vary : str
        The loading parameter.
    ends : pair of float
        Ends of its tolerance.
    begin : float
        Lower end of the axis.
    shown : pair of (str, float)
        Title of each axis, and the factor from the model's unit, for angles from degrees, to the
        unit of the axis: for the loading parameter, and for the first coordinate.
    """
    model, first = p.model, p.model.coordinates[0]
    turns, top = _folds_and_top(p, vary, begin, ends[1])
    n = 80
    curves = curves_between(p, vary, (begin, top), turns, True, n)
    draw_branches(curves, first, ax=ax, color=GREY, linewidth=0.8)
    artists: list[Any] = []
    with suppress(ConvergenceError):  # without a path if branches cannot be separated
        path = ss.quasi_static_path(p, vary, np.linspace(begin, top, 2 * n + 1))
        artists += draw_path(path, first, ax=ax, color=VERMILION)
    mark_folds(turns, first, ax=ax, between={vary: (begin, top)})
    size = model.column(vary).size
    tolerance = np.multiply(size, ends)
    ax.axvspan(*tolerance, color=SKY, alpha=0.25, linewidth=0, zorder=0)
    ax.set_xlim(size * begin, size * top)
    for axis, one in zip((ax.xaxis, ax.yaxis), shown, strict=True):
        in_units(axis, one)
    return artists, len(curves.undecided) > 0


def _folds_and_top(p: ParameterSet, vary: str, begin: float, most: float) -> tuple[Points, float]:
    """Folds along the loading parameter from ``begin`` on, and the upper end of its axis: above
    ``most``, the largest value in use, and above the folds that are not far beyond it.
    """
    allowed, default = p.ranges[vary], float(ranges(p, (vary,), {})[0, 1])
    largest, above = allowed.reached(allowed.high), most + _MORE * abs(most)
    if vary == p.model.coefficient:
        least, far = _TOP, _FAR
    else:
        least, far = above, _FAR * most if most > max(begin, 0.0) else default
    folds = ss.folds(p, vary, between={vary: (begin, min(max(far, above), largest))})
    marked = [value + _MORE * abs(value) for value in folds[vary].tolist() if begin < value < far]
    top = min(max(least, above, *marked), largest)
    return folds, top if top > begin else default  # without a load, and without folds


def draw_shares(indices: Mapping[str, tuple[float, float, float]], ax: Axes) -> None:
    """Draw Sobol' indices as bars: total indices with their intervals, and first-order indices
    inside.

    Parameters
    ----------
    indices : mapping of str to (float, float, float)
        First order, total, and half-width of the total's interval.
    ax : Axes
    """
    names = list(indices)[::-1]
    first, total, error = np.nan_to_num([indices[name] for name in names]).reshape(-1, 3).T
    places = np.arange(len(names))
    ax.barh(
        places,
        total,
        xerr=error,
        color=SKY,
        height=0.62,
        error_kw={"elinewidth": 0.8, "ecolor": GREY},
    )
    ax.barh(places, np.maximum(first, 0.0), color=BLUE, height=0.3)
    ax.set_yticks(places, [f"${symbol(name)}$" if name.isidentifier() else name for name in names])
    ax.set(xlabel="share of the variance of “it jumps”", xlim=(0, 1.05))


def batch_page(found: Sequence[BatchReport], title: str, about: str) -> str:
    """Text of the page with a row a brake, each with a link to its own page."""

    def shown(one: BatchReport) -> dict[str, Any]:
        row = one.columns()
        odds, ends = row["probability"], (row["low"], row["high"])
        return {
            "name": row["name"],
            "risk": one.at_risk,
            "link": quote(f"{one.brake.stem}.html") if one.told else "",
            "jump_at": _number(row["jump_at"], f" {row['unit'] or ''}"),
            "margin": _number(row["margin_percent"], " %"),
            "probability": _number(odds, "")
            + (f" ({ends[0]:.3g} to {ends[1]:.3g})" if None not in ends else ""),
            "verdict": one.verdict,
        }

    return filled(
        "spragsym.figures",
        "batch.html",
        "the page of a batch",
        title=title,
        about=about,
        rows=[shown(one) for one in found],
    )


def _number(value: float | None, unit: str) -> str:
    """A cell of the page; empty for what is not known."""
    return "" if value is None else f"{value:.4g}{unit}".rstrip()
