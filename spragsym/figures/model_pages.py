"""The gallery of the documentation: every shipped model with its drawing, its equations and where its equilibria change.

``python -m spragsym.figures.model_pages > docs/models.md`` writes the page anew; ``python -m spragsym.figures.gallery
docs/images/models`` draws its pictures.
"""

from __future__ import annotations

import numpy as np

from ..bifurcation.cusps import cusps
from ..bifurcation.folds import folds
from ..files.templates import filled
from ..models.describe import title_and_words
from ..models.load import USUAL, load, shipped
from ..models.model import Model


def page(points: bool = True) -> str:
    """The page as Markdown; without ``points``, nothing is computed."""
    models = [load(name) for name in sorted(shipped(), key=lambda name: (name != USUAL, name))]
    rows = [(model.about, *title_and_words(model.about), _points(model) if points else []) for model in models]
    return filled("spragsym.figures", "models.md", "the gallery of models", models=rows)


def _points(model: Model) -> list[str]:
    """Folds and cusps at the base values."""
    if not {"theta0", "mu0"} <= set(model.parameters):
        return []
    turns = folds(model.Parameters(), "theta0", method="search")
    peaks = cusps(model.Parameters(mu0=None), ("theta0", "mu0"), method="search")
    found = []
    for what, points in (("Folds at the base values", turns), ("Cusps", peaks)):
        listed = ", ".join(
            f"θ₀ = {np.degrees(points.theta0[row]):.4f}°" + (f", μ₀ = {points.mu0[row]:.6f}" if what == "Cusps" else "")
            for row in range(len(points))
        )
        more = "" if points.complete else f" ({'; '.join(points.remarks)})"
        found.append(f"{what}: {listed or 'none'}{more}.")
    return found


if __name__ == "__main__":
    print(page(), end="")
