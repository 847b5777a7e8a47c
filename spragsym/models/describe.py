"""A model in words: its drawing, coordinates and parameters."""

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

#: Name, unit, name of the rate, and its unit.
Place: TypeAlias = tuple[str, str, str, str]


def described(about: Mapping[str, Any]) -> str:
    """Summary, drawing and tables of a ``model.json``."""
    parts = [f"{about['name']}: {about['summary']}", about["drawing"].strip()]
    coordinates = [("coordinate", "meaning")]
    coordinates += [
        (entry["name"], entry["meaning"] + (", radians" if entry["unit"] == "rad" else "")) for entry in about["coordinates"]
    ]
    parameters = [("parameter", "base", "allowed", "of", "meaning")]
    parameters += [
        (
            entry["name"],
            "" if entry["base"] is None else f"{entry['base']:g}",
            entry["domain"],
            {"both": "statics and motion", "motion": "motion"}[entry["role"]],
            entry["meaning"] + (", radians" if entry["unit"] == "rad" else _behind(entry)),
        )
        for entry in about["parameters"]
    ]
    return "\n\n".join([*parts, _table(coordinates), _table(parameters), f"measured in: {units_of(about)}"])


def title_and_words(about: Mapping[str, Any]) -> tuple[str, list[str]]:
    """What a page says above its drawing, and the blocks below it; formulas that are set apart are indented."""
    title, _, rest = about["drawing"].partition("\n\n::\n\n")
    drawn, *blocks = rest.split("\n\n")
    while drawn.startswith(" ") and blocks and blocks[0].startswith("    "):  # a drawing with blank lines
        del blocks[0]
    return title, blocks


def units_of(about: Mapping[str, Any]) -> str:
    """What lengths, times and forces are measured in, in the quantities of the page."""
    return ", ".join(f"{name} {about['scales'][name].replace('**', '^')}" for name in ("length", "time", "force"))


def explained(about: Mapping[str, Any]) -> dict[str, tuple[str, str]]:
    """Unit and meaning of everything that files of motions hold, by its name: of the model, and of what is computed of it."""
    time, rate = about["scales"]["time"], about["scales"]["rate"]
    found = {"t": (time, "time"), "event_t": (time, "time of an event"), "event": ("1", "what happened")}
    places = []
    for entry in about["coordinates"]:
        name, of_rate, unit = entry["name"], entry["rate"], "rad" if entry["unit"] == "rad" else entry["scale"]
        places.append((name, unit, of_rate, entry["rate_scale"]))
        found |= {name: (unit, entry["meaning"]), of_rate: (entry["rate_scale"], f"rate of {name}")}
        found |= {f"{name}0": (unit, f"initial {name}"), f"{of_rate}0": (entry["rate_scale"], f"initial {of_rate}")}
    for entry in about["parameters"]:
        found[entry["name"]] = ("rad" if entry["unit"] == "rad" else entry["scale"] or "1", entry["meaning"])
    for name in about["angles"]:
        found[f"{name}_deg"] = ("degree", found[name][1])
    return found | _of_motions(places, time, rate)


def _of_motions(places: Sequence[Place], time: str, rate: str) -> dict[str, tuple[str, str]]:
    """Quantities of motions, by the coordinates."""
    (x, unit, *_), *others = places
    after, top = "after the transient", f"of the cycle where its {x} is largest"
    found = {f"mean_{y}": (across, f"mean of {y} {after}") for y, across, *_ in others}
    for y, across, vy, speed in places:
        found |= {f"rest_{y}": (across, f"{y} of the equilibrium that it settles to or approaches; NaN for none")}
        found |= {f"cycle_{y}": (across, f"{y} {top}"), f"cycle_{vy}": (speed, f"{vy} {top}")}
    return found | {
        "error": ("1", "largest difference of the state to a run at a tighter tolerance"),
        "rms": (unit, f"root mean square of {x} about zero, {after}"),
        "spread": (unit, f"root mean square of {x} about its mean, {after}"),
        "largest": (unit, f"largest |{x}| {after}"),
        "mean": (unit, f"mean of {x} {after}"),
        "period": (time, "period of the cycle that the motion is on or approaches; NaN for none"),
        "rate": (rate, "rate at which what the motion settles to or approaches attracts"),
        "distance": ("1", f"what is left of the way there: of the reach of a cycle, over {unit} for rest"),
        "cycle_mean": (unit, f"mean of {x} over one period of the cycle"),
        "cycle_rms": (unit, f"root mean square of {x} about zero over one period of the cycle"),
        "contact_lost": ("1", f"times contact was lost {after}"),
        "slip_reversed": ("1", f"times the sliding speed changed its sign {after}"),
        "regime": ("1", "what the motion settles to or approaches"),
        "equilibrium": ("1", "index of the equilibrium that it settles to or approaches; -1 for none"),
        "reason": ("1", "why a point has no result"),
        "kind": ("1", "0 undecided, 1 rest, 2 cycle, 3 lift-off, 4 chaotic"),
        "exponent": (rate, "largest Lyapunov exponent but the trivial one"),
        "exponent_error": (rate, "half-width of its 95 % interval; 0 where eigenvalues or multipliers give it"),
        "time_scale": (time, "on which the slowest deviations from steady sliding die out"),
        "why": ("1", "what decides the kind, or would"),
    }


def _behind(entry: Mapping[str, Any]) -> str:
    """The quantity with a unit behind a dimensionless one."""
    return "" if entry["quantity"] == entry["name"] else f" ({entry['quantity']}, dimensionless)"


def _table(rows: Sequence[Sequence[str]]) -> str:
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows)
