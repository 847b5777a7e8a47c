"""One motion: over time, in the plane of x and x′, and its spectrum."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from ..dynamics import Trajectory
from ..dynamics.pictures import axis_label, course_over_time
from ..errors import ParameterError
from .style import BLUE, DOUBLE, GREY, Sheet, own_axes, panels, styled


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
    return course_over_time(
        motion, of, own_axes(ax), scale=(time, length), labels=labels, style={"color": BLUE, "linewidth": 0.8}
    )


def draw_phase(motion: Trajectory, ax: Axes | None = None, *, length: float = 1.0, speed: float = 1.0,
               labels: tuple[str, str] | None = None) -> Any:  # fmt: skip
    """x′ over x, the first coordinate, and the speed of the belt along it as a line; returns the curve."""
    ax = own_axes(ax)
    t = np.linspace(motion.t[0], motion.t[-1], 6000)
    states, (name, *_), (rate, *_) = motion(t), motion.model.coordinates, motion.model.rates
    x, vx = states[0], states[len(states) // 2]
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
    ax.set(xlim=(0, frequency * found.frequency[min(2 * int(large[-1]) + 8, found.frequency.size - 1)]), ylim=(0, None))
    across, up = labels or (r"frequency $\times\ \sqrt{m/k_c}$", f"amplitude of {axis_label(motion.model, of)}")
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
    """x over time; what follows the transient in the plane of x and x′, and its spectrum; with ``units`` not dimensionless."""
    figure, (axes,) = panels(1, 3, DOUBLE, 2.4)
    late = motion.after(transient)
    length, time = (1.0, 1.0) if units is None else (units.length, units.time)
    over_time = phase = spectrum = None
    V, d = motion.p.scalars("V", "d")
    belt, after = f"belt speed V = {V:g}, steepness d = {d:g}", f"{transient:g}"
    if units is not None:
        x, t = f"$x$ ({units.length_name})", units.time_name
        over_time, phase = (f"$t$ ({t})", x), (x, f"$x'$ ({units.length_name}/{t})")
        spectrum = "frequency (Hz)" if t == "s" else f"frequency (1/{t})", f"amplitude of {x}"
        belt, after = f"belt speed {V * length / time:.4g} {units.length_name}/{t}", f"{transient * time:.4g} {t}"
    draw_motion(motion, ax=axes[0], length=length, time=time, labels=over_time)
    draw_phase(late, ax=axes[1], length=length, speed=length / time, labels=phase)
    draw_spectrum(late, ax=axes[2], length=length, frequency=1 / time, labels=spectrum)
    found = late.spectrum(0.0)
    return figure.describe(
        f"""A motion, {belt}. (a) Displacement along the belt over time. (b)
        Speed over displacement and (c) spectrum, both after the time {after}. Dotted: the speed of the belt.""",
        a={"t": time * motion.t, "x": length * motion.x}, b={"x": length * late.x, "vx": length / time * late.vx},
        c={"frequency": found.frequency / time, "amplitude": length * found.amplitude},
    )  # fmt: skip
