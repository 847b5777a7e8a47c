"""One motion: over time, in the plane of x and x′, and its spectrum."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes

from ..dynamics import Trajectory
from .style import BLUE, own_axes

#: What an axis says.
_LABELS = {"x": r"$x$ / $L_0$", "y": r"$y$ / $L_0$", "vx": r"$x'$ / $L_0\sqrt{k_c/m}$", "vy": r"$y'$ / $L_0\sqrt{k_c/m}$"}


def draw_motion(motion: Trajectory, of: str = "x", ax: Axes | None = None, *, length: float = 1.0, time: float = 1.0,
                labels: tuple[str, str] | None = None) -> Any:  # fmt: skip
    """A component of a motion over time; returns the line.

    Parameters
    ----------
    motion : Trajectory
    of : str
        ``"x"``, ``"y"``, ``"vx"`` or ``"vy"``.
    ax : Axes, optional
    length, time : float
        What one unit of the component and of time is in the units of the axes.
    labels : (str, str), optional
        Of the axes.
    """
    ax = own_axes(ax)
    t = np.linspace(motion.t[0], motion.t[-1], 4000)
    (line,) = ax.plot(time * t, length * motion(t)[("x", "y", "vx", "vy").index(of)], color=BLUE, linewidth=0.8)
    across, up = labels or (r"$t$ / $\sqrt{m/k_c}$", _LABELS[of])
    ax.set(xlabel=across, ylabel=up)
    return line


def draw_phase(motion: Trajectory, ax: Axes | None = None, *, length: float = 1.0, speed: float = 1.0,
               labels: tuple[str, str] | None = None) -> Any:  # fmt: skip
    """x′ over x, and the speed of the belt as a line; returns the curve."""
    ax = own_axes(ax)
    t = np.linspace(motion.t[0], motion.t[-1], 6000)
    x, _, vx, _ = motion(t)
    (line,) = ax.plot(length * x, speed * vx, color=BLUE, linewidth=0.8)
    ax.axhline(speed * motion.V, color="#6b6b6b", linewidth=0.6, linestyle=":")
    across, up = labels or (_LABELS["x"], _LABELS["vx"])
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
    across, up = labels or (r"frequency $\times\ \sqrt{m/k_c}$", f"amplitude of {_LABELS[of]}")
    ax.set(xlabel=across, ylabel=up)
    return line
