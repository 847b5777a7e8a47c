"""The gallery of models: ``python docs/gallery.py [MODEL …]`` writes docs/models.md, and draws
pictures in docs/images/models.
"""

from __future__ import annotations

import sys
from pathlib import Path

import jinja2
import numpy as np

import spragsym as ss
from spragsym.figures.planes import bifurcation_figure, stability_figure
from spragsym.figures.style import Sheet, house_style, picture, styled
from spragsym.models import Model
from spragsym.models.load import USUAL, shipped
from spragsym.models.model import title_drawing_words

HERE = Path(__file__).parent
#: What is shown of a model: the plane and its ranges; curves of onsets with damping ("hopf") and
#: without ("flutter").
GALLERY = {
    "two_springs": ("folds", "theta0", "mu0", {"mu0": (0.0, 1.4)}),
    "stribeck": ("folds", "theta0", "mu_s", {"mu_s": (0.0, 1.5)}),
    "mode_coupling": ("flutter", "sigma", "mu0", {"sigma": (0.05, 2.0), "mu0": (0.0, 2.0)}),
    "wobbling_disc": ("hopf", "Omega", "mu0", {"Omega": (0.02, 1.0), "mu0": (0.0, 3.0)}),
    "disc_between_pads": ("flutter", "beta", "mu0", {"beta": (0.0, 1.0), "mu0": (0.0, 1.0)}),
    "stick_slip": ("hopf", "V", "zeta", {"V": (0.01, 1.5), "zeta": (0.0, 2.0)}),
}

#: Models whose one equilibrium meets no other.
ALONE = ("coulomb_stick_slip", "pad_on_legs", "two_blocks")


def undrawn() -> list[str]:
    """Models of which nothing is drawn beside their mechanism."""
    return [
        name
        for name in shipped()
        if name in ALONE or any(map(ss.load(name).refusal, ("bifurcation_set", "onset_curves")))
    ]


def explored() -> list[str]:
    """Models that the explorer shows."""
    return [name for name in shipped() if not ss.load(name).refusal("explore")]


def page(points: bool = True) -> str:
    """The page as Markdown; without ``points``, nothing is computed."""
    models = [ss.load(name) for name in sorted(shipped(), key=lambda name: (name != USUAL, name))]
    rows = [
        (model.about, *title_drawing_words(model.about)[::2], computed(model) if points else [])
        for model in models
    ]
    made = jinja2.Environment(
        undefined=jinja2.StrictUndefined, trim_blocks=True, keep_trailing_newline=True
    )
    return made.from_string((HERE / "models.jinja").read_text(encoding="utf-8")).render(
        models=rows, undrawn=undrawn(), explored=explored()
    )


def computed(model: Model) -> list[str]:
    """Folds and cusps at the base values."""
    if not {"theta0", "mu0"} <= set(model.parameters):
        return []
    turns = ss.folds(model.Parameters(), "theta0", method="search")
    peaks = ss.cusps(model.Parameters(mu0=None), ("theta0", "mu0"), method="search")
    found = []
    for what, points in (("Folds at the base values", turns), ("Cusps", peaks)):
        listed = ", ".join(
            f"θ₀ = {np.degrees(points.theta0[row]):.4f}°"
            + (f", μ₀ = {points.mu0[row]:.6f}" if what == "Cusps" else "")
            for row in range(len(points))
        )
        more = "" if points.complete else f" ({'; '.join(points.remarks)})"
        found.append(f"{what}: {listed or 'none'}{more}.")
    return found


@styled
def drawn(model: Model) -> Sheet:
    """Where equilibria change, or oscillation begins: on fewer lines where a line takes seconds."""
    n = 60 if len(model.coordinates) < 3 else 24
    kind, *vary, between = GALLERY.get(model.name, ("folds", "theta0", "mu0", {"mu0": (0.0, 1.0)}))
    p = model.Parameters(**dict.fromkeys(set(vary) & {"theta0"}, 1.0))
    if kind == "folds":
        return bifurcation_figure(p, vary, between=between, n=n)
    return stability_figure(ss.onset_curves(p, vary, n, damping=kind == "hopf", between=between))


if __name__ == "__main__":
    (HERE / "models.md").write_text(page(), encoding="utf-8")
    for name in sys.argv[1:] or [name for name in shipped() if name not in undrawn()]:
        with house_style():
            (HERE / f"images/models/{name}_set.svg").write_bytes(
                picture(drawn(ss.load(name)), "svg")
            )
        print(name, flush=True)
