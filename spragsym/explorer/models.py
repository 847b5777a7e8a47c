"""The page of any model that has a page of its own in Python: its states are searched in the browser, and the page says so."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import ParameterError
from ..models.parameters import options_of
from .page import asset, escaped, filled, motion_part, onsets_part, page, parameter_part, points
from .presets import Preset
from .units import Units

if TYPE_CHECKING:
    from ..models import Model

#: Where a parameter without a base value begins: an inclination as in the article's cases, any other in the middle of its range.
_INCLINATION = math.radians(30.0)
#: How far a slider reaches beyond a base value, and where there is none or it is 0.
_REACH, _PLAIN = 4.0, 3.0
#: Share of a range that a slider keeps from ends that are not allowed.
_INWARD = 0.003
_LINES = ("solid", "dashed", "dotted", "dash-dotted")


@dataclass(frozen=True)
class Derived:
    """What is derived from a model's page for the browser; the extra derive makes it.

    Attributes
    ----------
    module : str
        The model's algebra and motion as an ES module.
    drawing : str
        The mechanism as SVG.
    drawn : bool
        Whether it is a mass on a belt, which the page draws to scale and lets move; of others it shows the drawing.
    ties : tuple of tuple of str
        For each of the first two coordinates the stiffnesses of springs that tie it to the ground: parameters, or ``"1"`` for
        one that is a unit of the model.
    """

    module: str
    drawing: str
    drawn: bool
    ties: tuple[tuple[str, ...], tuple[str, ...]]


def model_page(
    model: Model, derived: Derived, presets: Sequence[Preset] = (), units: Units | None = None, onsets: tuple[str, str] = ("", "")
) -> str:
    """A page that shows a model: mechanism, states along a parameter, states at a point, motion in time.

    Parameters
    ----------
    model : Model
        As :func:`spragsym.load` gives it.
    derived : Derived
        Its algebra in JavaScript, and its drawing.
    presets : sequence of Preset
        Points of the user's own; the page begins at the first of them, and the base values follow.
    units : Units, optional
        Units of the user's own.
    onsets : pair of str
        The map of stability as SVG, and the command that prints its numbers.

    Returns
    -------
    str
        The page. Same arguments, same text.
    """
    about = model.about
    lines = ", ".join(f"{name} {look}" for name, look in zip(model.coordinates, _LINES, strict=False))
    body = {
        "TITLE": escaped(model.name),
        "SUMMARY": escaped(about["summary"]),
        "WORDS": _words(about["drawing"]),
        "DRAWING": derived.drawing,
        "PARAMETERS": parameter_part(units),
        "MOTION": motion_part(f"Lines: {lines}.", ""),
        "ONSETS": onsets_part(*onsets),
    }
    return page(
        f"{model.name} explorer",
        f"Model: {about['summary']}",
        filled(asset("model.html"), body),
        "model.js",
        derived.module,
        "explorer.start({ algebra });",
        {
            "model": _described(model, derived),
            "presets": points((*presets, _base(model))),
            "units": units and units.data(),
        },
    )


def model_preset(name: str, model: Model, values: Mapping[str, Any]) -> Preset:
    """A point of all parameters of a model.

    Raises
    ------
    ParameterError
        If a value is missing, or no single number.
    """
    for key in model.parameters:
        if values.get(key) is None or np.ndim(values[key]):
            raise ParameterError(f"{key} = {values.get(key)!r} is not one number; a preset of the explorer is one point")
    return Preset(name, {key: float(values[key]) for key in model.parameters})


def _base(model: Model) -> Preset:
    """The base values."""
    values = {}
    for entry in model.about["parameters"]:
        low, high = entry["low"], entry["high"]
        angle = entry["name"] in model.about["angles"]
        middle = _INCLINATION if angle else 0.5 * (low + high) if low is not None and high is not None else 1.0
        values[entry["name"]] = middle if entry["base"] is None else entry["base"]
    return model_preset("Base values", model, values)


def _words(text: str) -> str:
    """What a page says below its drawing as HTML, formulas that are set apart too."""
    blocks = text.partition("\n\n::\n\n")[2].split("\n\n")
    while blocks and blocks[0].startswith(" "):  # the drawing, which may have blank lines
        del blocks[0]
    elements = ["pre" if block.startswith(" ") else "p" for block in blocks]
    return "\n".join(f"<{name}>{escaped(block)}</{name}>" for name, block in zip(elements, blocks, strict=True))


def _described(model: Model, derived: Derived) -> dict[str, Any]:
    """What the page's script is told of the model."""
    about = model.about
    return {
        "name": model.name,
        "where": model.where,
        "coordinates": [{"name": one["name"], "turns": bool(one.get("comes_around"))} for one in about["coordinates"]],
        "parameters": [
            {
                "name": entry["name"],
                "meaning": entry["meaning"],
                "role": entry["role"],
                "angle": entry["name"] in about["angles"],
                "flag": options_of(about, entry["name"])[0],
                "range": {key: entry[key] for key in ("low", "high", "low_open", "high_open") if entry[key] is not None},
                **_slider(entry, entry["name"] in about["angles"]),
            }
            for entry in about["parameters"]
        ],
        "angles": about["angles"],
        "arguments": about["arguments"],
        "gap": about["contact"]["gap"],
        "unilateral": about["contact"]["unilateral"],
        "polynomial": about["contact"]["polynomial"],
        "layers": about["layers"],
        "torsions": len(about.get("torsions", ())),
        "belt": about["friction"] and about["friction"]["belt"],
        "ties": derived.ties,
        "drawn": derived.drawn,
    }


def _slider(entry: Mapping[str, Any], angle: bool) -> dict[str, float]:
    """What a slider spans, angles in degrees: the allowed range where it ends, else several times the base value."""
    low, high, base = entry["low"], entry["high"], entry["base"]
    reach = _REACH * abs(base) if base else _PLAIN
    first = -reach if low is None else low
    last = reach if high is None else high
    room = _INWARD * (last - first)
    first, last = first + room * bool(entry["low_open"]), last - room * (high is not None and bool(entry["high_open"]))
    return {"low": math.degrees(first), "high": math.degrees(last)} if angle else {"low": first, "high": last}
