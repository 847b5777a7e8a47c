"""Curves of the linear sprag model, whose spring keeps its angle: broken at its poles."""

from __future__ import annotations

import itertools

import numpy as np
from matplotlib.axes import Axes

import spragsym as ss

from ..models.parameters import FloatArray, Parameters
from .style import BLUE, Table


def linear_curves(p: Parameters) -> tuple[list[FloatArray], FloatArray]:
    """θ₀ in degrees between the poles of the linear model, piece by piece, and the poles."""
    poles = np.degrees(ss.linear_sprag(p.replace(theta0=1.0)).poles)
    poles = np.sort(poles[np.isfinite(poles)])
    ends = [0.05, *poles, 179.95]
    pieces = []
    for begin, end in itertools.pairwise(ends):
        pieces.append(begin + (end - begin) * (0.5 - 0.5 * np.cos(np.pi * np.linspace(2e-3, 1 - 2e-3, 400))))
    return pieces, poles


def draw_linear(ax: Axes, p: Parameters, name: str, color: str = BLUE) -> Table:
    """Curves of the linear model, broken at its poles, which are marked."""
    pieces, poles = linear_curves(p)
    for piece in pieces:
        ax.plot(
            piece,
            getattr(ss.linear_sprag(p.replace(theta0=np.radians(piece))), name),
            color=color,
            linewidth=1.0,
        )
    for pole in poles:
        ax.axvline(pole, color=color, linewidth=0.6, linestyle=":")
    along = np.concatenate(pieces)
    model = ss.linear_sprag(p.replace(theta0=np.radians(along)))
    return {"theta0_deg": along, "x_linear": model.x, "y_linear": model.y}
