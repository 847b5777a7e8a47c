"""A report as one page of HTML that needs no other file: its pictures are SVG within it. The same bytes every time."""

from __future__ import annotations

import io
import math
import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

import spragsym as ss

from ..errors import MissingExtraError, SpragsymError
from ..files.writing import put
from . import rises
from .oscillations import first_unit
from .reports import Report
from .study import Study
from .texts import sections

#: Lines on which onsets of oscillation are looked for.
_ONSETS = 12
#: Lines of a bifurcation set, and values along the friction.
_LINES, _VALUES = 40, 80


def write_page(study: Study, report: Report, path: Path) -> None:
    """Write the page."""
    put(path, page(study, report))


def page(study: Study, report: Report) -> str:
    """The page as text."""
    return document(study, report, pictures(study, report), sections(report))


#: A heading with rows of a name and a value.
Section: TypeAlias = tuple[str, Iterable[tuple[str, str]]]


def document(study: Study, report: Report, drawn: Iterable[tuple[str, str]], headed: Iterable[Section]) -> str:
    """A page from its verdict and warnings, pictures as SVG with captions, and sections."""
    try:
        from jinja2 import Environment, StrictUndefined
    except ModuleNotFoundError as error:
        raise MissingExtraError("the page of a report", "jinja2", "plot") from error
    template = Path(__file__).with_name("report.html").read_text(encoding="utf-8")
    made = Environment(autoescape=True, undefined=StrictUndefined, trim_blocks=True, keep_trailing_newline=True)
    title = f"Sprag-slip report{': ' + study.source if study.source else ''}"
    return made.from_string(template).render(title=title, report=report, drawn=drawn, headed=[*headed, ("Data", _data(study))])


def _data(study: Study) -> Iterator[tuple[str, str]]:
    for name, one in study.quantities.items():
        ends = f", {study.shown(name, one.low)} to {study.shown(name, one.high)}" if one.high > one.low else ""
        yield name, study.shown(name, one.value) + ends


def pictures(study: Study, report: Report) -> Iterator[tuple[str, str]]:
    """Each picture as SVG, with its caption; none of a plane that the model does not have."""
    from ..figures import brakes

    if study.rise is not None:
        yield from planes(study, report)
    if study.rise is not None and study.rise.is_friction:
        low, _, high = study.friction
        known = (value for value in report.folds["mu0"].mu0.tolist() if value < 3) if "mu0" in report.folds else ()
        top = max(1.0, 1.15 * high, *(1.15 * value for value in known))
        yield from stability_map(study, study.at_work, (low, high), top)
    if report.probability is not None and not all(np.isnan(one[1]) for one in report.probability.sobol.values()):
        shares = report.probability.sobol
        yield (
            picture(lambda ax: brakes.draw_shares(shares, ax=ax)),
            "Which tolerance decides whether it jumps: Sobol' indices with their 95 % intervals.",
        )
    if report.oscillation is not None and report.oscillation.alive:
        yield from _of_motion(study, report)


def planes(study: Study, report: Report) -> Iterator[tuple[str, str]]:
    """The brake in the plane of angle and friction, where that rises and there is an angle, and its states as what rises does."""
    from ..figures import brakes

    (low, _, high), p, first = rises.working(study), study.at_work, study.about["coordinates"][0]
    rise = rises.of(study)
    unit, size = ("mm", 1e3 * study.scales.length) if first["unit"] == "m" else ("deg", 1.0)
    jump = math.nan if report.mu_jump is None else report.mu_jump
    if "theta0" in p.model.parameters and rise.is_friction:
        angles = study.quantities["theta0"]
        shaded = (
            "Shaded: three states of sliding; on the lines two of them meet."
            if "count" in p.model.closed
            else ("On the lines two states of sliding meet.")
        )
        with suppress(SpragsymError):
            yield (
                picture(lambda ax: brakes.draw_operating_point(p, (angles.low, angles.high), (low, high), jump, ax=ax, n=_LINES)),
                f"Where the brake works (dot) and its tolerances (box). {shaded}"
                + (
                    " Cross: the friction at which the state of small deformation jumps at this angle." if jump < math.inf else ""
                ),
            )
    options: dict[str, Any] = dict(length=size, label=f"{first['name']} in {unit}", n=_VALUES)
    if not rise.is_friction:
        one, scale = study.quantities[rise.quantity], rises.scale(study)
        low, high = low / scale, high / scale
        across = f"{rise.quantity} in {one.unit}" if one.unit else rise.quantity
        drawn = math.radians(1.0) if study.si(rise.quantity) == "rad" else 1.0
        options |= {**rises.along(study), "size": study.in_file(rise.quantity, drawn * scale), "across": across}
    yield (
        picture(lambda ax: brakes.draw_rising(p, (low, high), ax=ax, **options)),
        f"{_capital(first['meaning'])} as {_what(rise)} rises (red, with its jumps); grey: all states, full where stable. "
        f"Shaded: {_what(rise)} within its tolerances.",
    )


def _what(rise: rises.Rise) -> str:
    return "the friction" if rise.is_friction else rise.quantity


def _capital(text: str) -> str:
    """A sentence begins with a capital letter."""
    return text[:1].upper() + text[1:].partition(",")[0]


def stability_map(study: Study, p: Any, friction: tuple[float, float], top: float) -> Iterator[tuple[str, str]]:
    """Where oscillation sets in, over angle and friction up to ``top``; nothing where the belt or its law is not known."""
    from ..figures import brakes
    from ..figures.planes import draw_onset_curves

    if "theta0" not in p.model.parameters or not study.moves:
        return
    with suppress(SpragsymError):
        onsets = ss.onset_curves(p, ("theta0", "mu0"), _ONSETS, between={"mu0": (0.0, top)})
        angles = study.quantities["theta0"]

        def draw(ax: Any) -> None:
            draw_onset_curves(onsets, ax)
            brakes.mark_brake(ax, p, (angles.low, angles.high), friction)

        yield (
            picture(draw),
            "The map of stability. On the lines oscillation sets in: gently where they are full, with a knock where they are "
            "dashed; where they are dotted it is not known which.",
        )


def _of_motion(study: Study, report: Report) -> Iterator[tuple[str, str]]:
    from ..figures import motion_pictures

    assert report.oscillation is not None
    found, (unit, size), time = report.oscillation.motion, first_unit(study), study.scales.time
    motion = found.trajectory(8) if report.oscillation.kind == "cycle" else found
    name = study.coordinates[0]
    up, speed = ("speed along the belt in m/s", 1e-3 * size / time) if unit == "mm" else (f"rate of {name} in deg/s", size / time)
    yield (
        picture(lambda ax: motion_pictures.draw_phase(motion, ax=ax, length=size, speed=speed, labels=(f"{name} in {unit}", up))),
        "The oscillation: speed over place along the belt. Dotted: the speed of the belt.",
    )
    yield (
        picture(lambda ax: motion_pictures.draw_spectrum(motion, name, ax=ax, length=size, frequency=1 / time,
                                                      labels=("frequency in Hz", f"amplitude of {name} in {unit}"))),
        "Its spectrum.",
    )  # fmt: skip


def picture(draw: Callable[[Any], Any]) -> str:
    """A picture of one panel, without the head of a file, its ids its own."""
    from ..figures import FORMATS
    from ..figures.style import Sheet, house_style

    stream = io.StringIO()
    with house_style():
        figure = Sheet(figsize=(4.2, 3.0), layout="constrained")
        draw(figure.add_subplot())
        figure.savefig(stream, format="svg", metadata=FORMATS["svg"])
    text = stream.getvalue()
    return _own_ids(text[text.index("<svg") :].strip())


def _own_ids(text: str) -> str:
    """Ids that no other picture of the page has, from the picture itself."""
    import hashlib

    mark = hashlib.sha256(text.encode()).hexdigest()[:8]
    text = re.sub(r'\bid="', f'id="{mark}-', text)
    text = re.sub(r'(href="#|url\(#)', rf"\g<1>{mark}-", text)
    return re.sub(r"<!--.*?-->|<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
