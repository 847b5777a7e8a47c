"""A motion over time, drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from .recorded import Recorded

#: What an axis says of a component.
LABELS = {"x": r"$x$ / $L_0$", "y": r"$y$ / $L_0$", "vx": r"$x'$ / $L_0\sqrt{k_c/m}$", "vy": r"$y'$ / $L_0\sqrt{k_c/m}$"}
TIME = r"$t$ / $\sqrt{m/k_c}$"


def course_over_time(
    motion: Recorded, of: str, ax: Any, *, scale: tuple[float, float] = (1.0, 1.0), labels: tuple[str, str] | None = None,
    style: dict[str, Any] | None = None,
) -> Any:  # fmt: skip
    """A component over time, both times their scale, with labels on the axes; returns the line."""
    t = np.linspace(motion.t[0], motion.t[-1], 4000)
    (line,) = ax.plot(scale[0] * t, scale[1] * motion(t)[motion.components.index(of)], **(style or {}))
    across, up = labels or (TIME, LABELS.get(of, of))
    ax.set(xlabel=across, ylabel=up)
    return line
