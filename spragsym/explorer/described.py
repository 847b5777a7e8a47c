"""Description of a model for the explorer's script."""

from __future__ import annotations

import math
import shlex
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ..models.parameter_class import options_of
from .presets import Preset

if TYPE_CHECKING:
    from ..models import Model

#: How far a slider reaches: times the base value, where there is none or it is 0, and times the largest value of a preset.
_REACH, _PLAIN, _ROOM = 2.0, 3.0, 1.2
#: Share of a range that a slider keeps from ends that are not allowed.
_INWARD = 0.003


def described(model: Model, presets: Sequence[Preset]) -> dict[str, Any]:
    """Names, ranges, sliders that reach all presets, and what its functions take."""
    about, contact = model.about, model.about["contact"]
    return {
        "name": model.name,
        "quoted": shlex.quote(model.where),
        "coordinates": [
            {"name": one["name"], "turns": bool(one.get("comes_around")), "angle": one["unit"] == "rad"}
            for one in about["coordinates"]
        ],
        "parameters": [
            {key: entry[key] for key in ("name", "meaning", "role")}
            | {
                "angle": entry["name"] in about["angles"], "flag": options_of(about, entry["name"])[0],
                "range": {key: entry[key] for key in ("low", "high", "low_open", "high_open") if entry[key] is not None},
                **_slider(entry, entry["name"] in about["angles"], [preset.point[entry["name"]] for preset in presets]),
            }
            for entry in about["parameters"]
        ],
        "axes": list(model.plane),
        **{key: about[key] for key in ("angles", "arguments", "layers", "ties", "drawn")},
        **{key: contact[key] for key in ("gap", "unilateral", "polynomial")},
        "torsions": len(about.get("torsions", ())),
        "belt": about["friction"] and about["friction"]["belt"],
    }  # fmt: skip


def _slider(entry: Mapping[str, Any], angle: bool, values: Sequence[float]) -> dict[str, float]:
    """What a slider spans, angles in degrees: the allowed range where it ends, else what holds base value and presets."""
    low, high, base = entry["low"], entry["high"], entry["base"]
    reach = max([_REACH * abs(base) if base else _PLAIN, *(_ROOM * abs(value) for value in values)])
    first = -reach if low is None else low
    last = reach if high is None else high
    room = _INWARD * (last - first)
    first, last = first + room * bool(entry["low_open"]), last - room * (high is not None and bool(entry["high_open"]))
    return {"low": math.degrees(first), "high": math.degrees(last)} if angle else {"low": first, "high": last}
