"""One motion: over time, in the plane of a coordinate and its rate, and its spectrum."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from ..errors import ParameterError
from ..motion import Trajectory
from .labels import axis_label, in_letters, label
from .style import BLUE, DOUBLE, GREY, Sheet, Table, own_axes, panels, styled


def draw_motion(motion: Trajectory, of: str | None = None, ax: Axes | None = None, *, length: float = 1.0, time: float = 1.0,
                labels: tuple[str, str] | None = None) -> Any:  # fmt: skip
    """A component of a motion over time; returns the line.

    Parameters
    ----------
    motion : Trajectory
    of : str, optional
        One of its components, by default the first: ``"x"``, ``"y"``, ``"vx"`` or ``"vy"``, or a coordinate of the model or
        its rate.
    ax : Axes, optional
    length, time : float
        What one unit of the component and of time is in the units of the axes.
    labels : (str, str), optional
        Of the axes.
    """
    of = motion.components[0] if of is None else of
    if of not in motion.components:
        raise ParameterError(f"of = {of!r} is not one of {', '.join(motion.components)}")
    ax, t = own_axes(ax), np.linspace(motion.t[0], motion.t[-1], 4000)
    (line,) = ax.plot(time * t, length * motion(t)[motion.components.index(of)], color=BLUE, linewidth=0.8)
    across, up = labels or (axis_label(motion.model, "t"), axis_label(motion.model, of))
    ax.set(xlabel=across, ylabel=up)
    return line


def draw_phase(motion: Trajectory, ax: Axes | None = None, *, of: str | None = None, length: float = 1.0, speed: float = 1.0,
               labels: tuple[str, str] | None = None) -> Any:  # fmt: skip
    """x′ over x, the first coordinate or another, and the speed of the belt along it as a line; returns the curve."""
    ax, names = own_axes(ax), motion.model.coordinates
    name = names[0] if of is None else of
    if name not in names:
        raise ParameterError(f"of = {of!r} is not one of {', '.join(names)}")
    place = names.index(name)
    rate, states = motion.model.rates[place], motion(np.linspace(motion.t[0], motion.t[-1], 6000))
    x, vx = states[place], states[len(names) + place]
    (line,) = ax.plot(length * x, speed * vx, color=BLUE, linewidth=0.8)
    friction = motion.model.about["friction"]
    if friction is not None and friction["along"] == name and friction["belt"] is not None:
        ax.axhline(speed * float(getattr(motion.p, friction["belt"])), color=GREY, linewidth=0.6, linestyle=":")
    across, up = labels or (axis_label(motion.model, name), axis_label(motion.model, rate))
    ax.set(xlabel=across, ylabel=up)
    return line


def draw_spectrum(motion: Trajectory, of: str = "x", ax: Axes | None = None, *, length: float = 1.0, frequency: float = 1.0,
                  labels: tuple[str, str] | None = None) -> Any:  # fmt: skip
    """Amplitudes over frequency, as far as they matter; returns the line."""
    ax = own_axes(ax)
    found = motion.spectrum(0.0, of=of)
    (line,) = ax.plot(frequency * found.frequency, length * found.amplitude, color=BLUE, linewidth=0.9)
    large = np.flatnonzero(found.amplitude > 0.01 * found.amplitude.max())
    last = large[-1] if large.size else 0  # of a motion that stays at rest there is none
    ax.set(xlim=(0, frequency * found.frequency[min(2 * int(last) + 8, found.frequency.size - 1)]), ylim=(0, None))
    unit = in_letters(motion.model.quantities["t"][0])
    across, up = labels or (rf"frequency $\times\ {unit}$", f"amplitude of {axis_label(motion.model, of)}")
    ax.set(xlabel=across, ylabel=up)
    return line


@dataclass(frozen=True)
class Units:
    """What one unit of length and of time of a motion is in the units of a picture, and what those are called."""

    length: float
    time: float
    length_name: str
    time_name: str = "s"


@styled
def motion_figure(motion: Trajectory, transient: float = 0.0, units: Units | None = None) -> Sheet:
    """Each coordinate over time; what follows the transient in the plane of it and its rate, and its spectrum.

    Parameters
    ----------
    motion : Trajectory
        Of any model.
    transient : float
        Time that the planes and spectra leave out.
    units : Units, optional
        Of the axes, which are dimensionless without.
    """
    model, late = motion.model, motion.after(transient)
    figure, axes = panels(len(model.coordinates), 3, DOUBLE, 0.3 + 2.1 * len(model.coordinates))
    tables: dict[str, Table] = {}
    for row, (entry, rate) in enumerate(zip(model.about["coordinates"], model.rates, strict=True)):
        name, turns = entry["name"], entry["unit"] == "rad"
        size, time = (1.0, 1.0) if units is None else (180 / np.pi if turns else units.length, units.time)
        over_time = phase = spectrum = None
        if units is not None:
            unit, t = "deg" if turns else units.length_name, units.time_name
            here = f"{label(model, name).partition(' (')[0]} ({unit})"
            over_time, phase = (f"$t$ ({t})", here), (here, f"{label(model, rate)} ({unit}/{t})")
            spectrum = "frequency (Hz)" if t == "s" else f"frequency (1/{t})", f"amplitude of {here}"
        draw_motion(motion, name, axes[row, 0], length=size, time=time, labels=over_time)
        draw_phase(late, axes[row, 1], of=name, length=size, speed=size / time, labels=phase)
        draw_spectrum(late, name, axes[row, 2], length=size, frequency=1 / time, labels=spectrum)
        found = late.spectrum(0.0, of=name)
        columns: tuple[Table, ...] = (
            {"t": time * motion.t, name: size * getattr(motion, name)},
            {name: size * getattr(late, name), rate: size / time * getattr(late, rate)},
            {"frequency": found.frequency / time, "amplitude": size * found.amplitude},
        )
        tables |= dict(zip("abcdefghijkl"[3 * row : 3 * row + 3], columns, strict=False))
    after = f"{transient:g}" if units is None else f"{transient * units.time:.4g} {units.time_name}"
    return figure.describe(
        f"""A motion of {model.name}, {_belt(motion, units)}. Left: each coordinate over time; middle and right, after the time
        {after}: its rate over it, with the speed of the belt dotted, and its spectrum.""",
        **tables,
    )


def _belt(motion: Trajectory, units: Units | None) -> str:
    """What moves it, in words: its belt's speed, or all parameters of the motion."""
    friction = motion.model.about["friction"]
    if units is not None and friction is not None and friction["belt"] is not None:
        speed = float(getattr(motion.p, friction["belt"])) * units.length / units.time
        return f"belt speed {speed:.4g} {units.length_name}/{units.time_name}"
    entries = [entry for entry in motion.model.about["parameters"] if entry["role"] == "motion"]
    values = motion.p.scalars(*(entry["name"] for entry in entries))
    return ", ".join(f"{entry['meaning']} {entry['name']} = {value:g}" for entry, value in zip(entries, values, strict=True))
