"""A report as one page of HTML that needs no other file: its pictures are SVG within it. The same bytes every time."""

from __future__ import annotations

import hashlib
import io
import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib import rc_context

import spragsym as ss

from ..errors import SpragsymError
from ..files.text import filled
from ..questions import has_closed_form
from ..report.states import unit_of
from ..report.texts import sections
from . import brakes, motion_pictures
from .files import FORMATS
from .planes import draw_onset_curves
from .style import Sheet, house_style

if TYPE_CHECKING:
    from ..report.reports import Report
    from ..report.study import Study

#: Letters of a picture in a page: text in the page's own family, 13.6 pixels as its captions.
_AS_TEXT: Any = {"svg.fonttype": "none", "font.family": "sans-serif", "mathtext.fontset": "dejavusans"} | dict.fromkeys(
    ("font.size", "axes.labelsize", "axes.titlesize", "xtick.labelsize", "ytick.labelsize", "legend.fontsize"), 10.2
)
#: Lines on which onsets of oscillation are looked for.
_ONSETS = 12
#: Lines of a bifurcation set, and values along the friction.
_LINES, _VALUES = 40, 80


def report_page(report: Report) -> str:
    """A report as one page of HTML, which needs no other file (extra ``plot``): the text of it."""
    study, about = report.study, report.about
    data = [(f"{name}, {study.kind.meanings[name]}", study.shown(name) + _ends(study, name)) for name in study.quantities]
    headed = {title: rows for title, rows in sections(report) if title != "Warnings"}
    last = {"What to do next": headed.pop("What to do next")}
    title = about.pop("title") or "Sprag-slip report"
    return document(
        title, ", ".join(filter(None, about.values())), report.verdict, report.warnings, pictures(report),
        (headed | {"Data": data} | last).items(), study.kind.drawing,
    )  # fmt: skip


def _ends(study: Study, name: str) -> str:
    """The tolerance of a quantity, where it has one."""
    one = study.quantities[name]
    return f", {study.shown(name, one.low)} to {study.shown(name, one.high)}" if one.varies else ""


def document(
    title: str, about: str, verdict: str, warnings: Iterable[str], drawn: Iterable[tuple[str, str]],
    headed: Iterable[tuple[str, Iterable[tuple[str, str]]]], mechanism: str = "",
) -> str:  # fmt: skip
    """A page from its title, what it is about, verdict and warnings, pictures as SVG with captions, headings with rows of a name
    and a value, and the mechanism drawn in characters."""
    values: dict[str, Any] = dict(title=title, about=about, verdict=verdict, warnings=warnings, drawn=drawn, headed=headed)
    return filled("spragsym.figures", "report.html", "the page of a report", mechanism=mechanism, **values)


def pictures(report: Report) -> Iterator[tuple[str, str]]:
    """Each picture as SVG, with its caption; none of a plane that the model does not have."""
    study, odds = report.study, report.probability
    if study.rise is not None:
        yield from _planes(report)
    if study.of_friction:
        yield from _stability_map(report)
    if odds is not None and not all(np.isnan(one[1]) for one in odds.sobol.values()):
        caption = (
            "Which tolerance decides whether it jumps: Sobol' indices, dark alone, light with interactions; bars: 95 % intervals."
        )
        yield picture(lambda ax: brakes.draw_shares(odds.sobol, ax=ax)), caption
    if report.oscillation is not None and report.oscillation.alive:
        yield from _of_motion(report, report.oscillation)


def _planes(report: Report) -> Iterator[tuple[str, str]]:
    """The brake in the plane of angle and friction, where there is an angle, and its states over the loading parameter."""
    study, jump = report.study, report.mu_jump
    (low, _, high), p, first = study.working, study.at_work, study.kind.about["coordinates"][0]
    if "theta0" in p.model.parameters and study.of_friction:
        angles, jump = study.quantities["theta0"], math.nan if jump is None else jump
        three = has_closed_form(ss.count, p)
        caption = "Shaded: three states of sliding; on the lines two of them meet." if three else (
            "On the lines two states of sliding meet."
        )  # fmt: skip
        caption += " Cross: the friction at which the reference state jumps at this angle." if jump < math.inf else ""
        with suppress(SpragsymError):
            yield (
                picture(lambda ax: brakes.draw_operating_point(p, (angles.low, angles.high), (low, high), jump, ax=ax, n=_LINES)),
                f"Where the brake works (dot) and its tolerances (box). {caption}",
            )
    unit, size = unit_of(study)
    # Angles are drawn in degrees by the picture itself.
    options: dict[str, Any] = dict(length=size if unit == "mm" else 1.0, label=f"{first['name']} in {unit}", n=_VALUES)
    if not study.of_friction:
        name, scale = study.rises.quantity, study.rise_scale
        low, high, one = low / scale, high / scale, study.quantities[name]
        drawn = math.radians(1.0) if study.kind.units[name] == "rad" else 1.0
        options |= {**study.along(), "size": study.in_file(name, drawn * scale)}
        options["across"] = f"{name} in {one.unit}" if one.unit else name
    rises = "the friction" if study.of_friction else study.rises.quantity
    meaning = first["meaning"].partition(",")[0]
    yield (
        picture(lambda ax: brakes.draw_rising(p, (low, high), ax=ax, **options)),
        f"{meaning[:1].upper()}{meaning[1:]} as {rises} rises (red, with its jumps); grey: all states, full where stable. "
        f"Dots: folds, where two states meet and end. Shaded: {rises} within its tolerances.",
    )


def _stability_map(report: Report) -> Iterator[tuple[str, str]]:
    """Where oscillation sets in, over angle and friction; nothing where the belt or its law is not known."""
    study, p = report.study, report.study.at_work
    if "theta0" not in p.model.parameters or not study.moves:
        return
    (low, _, high), angles = study.friction, study.quantities["theta0"]
    known = (value for value in report.folds["mu0"].mu0.tolist() if value < 3) if "mu0" in report.folds else ()
    top = max(1.0, 1.15 * high, *(1.15 * value for value in known))
    with suppress(SpragsymError):
        onsets = ss.onset_curves(p, ("theta0", "mu0"), _ONSETS, between={"mu0": (0.0, top)})
        if not onsets.curves and not len(onsets.undecided):  # an empty plane shows nothing
            return

        def draw(ax: Any) -> None:
            draw_onset_curves(onsets, ax)
            brakes.mark_brake(ax, p, (angles.low, angles.high), (low, high))

        yield (
            picture(draw),
            "The map of stability, with the brake (dot) and its tolerances (box). On the lines oscillation sets in: "
            "supercritical (gentle) where full, subcritical (dangerous) where dashed, undecided where dotted. Dots: that changes "
            "(GH). Squares: lines end on a fold (BT, ZH), or cross (HH).",
        )


def _of_motion(report: Report, lives: Any) -> Iterator[tuple[str, str]]:
    (unit, size), time, name = unit_of(report.study), report.study.scales.time, report.study.kind.model.coordinates[0]
    motion = lives.motion.trajectory(8) if lives.kind == "cycle" else lives.motion
    up, speed = ("speed along the belt in m/s", 1e-3 * size / time) if unit == "mm" else (f"rate of {name} in deg/s", size / time)
    phase: Mapping[str, Any] = dict(length=size, speed=speed, labels=(f"{name} in {unit}", up))
    caption = f"The oscillation: {up.partition(' in ')[0]} over {name}, one closed curve a cycle. Dotted: the speed of the belt."
    yield picture(lambda ax: motion_pictures.draw_phase(motion, ax=ax, **phase)), caption
    lines: Mapping[str, Any] = dict(length=size, frequency=1 / time, labels=("frequency in Hz", f"amplitude of {name} in {unit}"))
    yield (
        picture(lambda ax: motion_pictures.draw_spectrum(motion, name, ax=ax, **lines)),
        f"Its spectrum: the amplitude of {name} at each frequency.",
    )


def picture(draw: Callable[[Any], Any]) -> str:
    """A picture of one panel, without the head of a file; its ids are made from itself, so that no other has them."""
    stream = io.StringIO()
    with house_style(), rc_context(_AS_TEXT):
        figure = Sheet(figsize=(4.6, 3.3), layout="constrained")
        draw(figure.add_subplot())
        figure.savefig(stream, format="svg", metadata=FORMATS["svg"])
    text = stream.getvalue()
    text = text[text.index("<svg") :].strip()
    mark = hashlib.sha256(text.encode()).hexdigest()[:8]
    text = re.sub(r'\bid="', f'id="{mark}-', text)
    text = re.sub(r'(href="#|url\(#)', rf"\g<1>{mark}-", text)
    return re.sub(r"<!--.*?-->|<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
