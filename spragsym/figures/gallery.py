"""Pictures of the documentation's gallery: of each shipped model where its equilibria change, or where oscillation begins.

``python -m spragsym.figures.gallery docs/images/models`` draws them anew.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path

from ..bifurcation.hopf_curves import onset_curves
from ..files.writing import put
from ..models import Model, load
from ..models.load import shipped
from .files import picture
from .labels import Between
from .planes import bifurcation_figure, stability_figure
from .style import Sheet, house_style, styled

#: What the gallery shows of a model: the plane and its ranges; curves of onsets with damping ("hopf") and without ("flutter").
GALLERY: Mapping[str, tuple[str, str, str, Between]] = {
    "two_springs": ("folds", "theta0", "mu0", {"mu0": (0.0, 1.4)}),
    "stribeck": ("folds", "theta0", "mu_s", {"mu_s": (0.0, 1.5)}),
    "mode_coupling": ("flutter", "sigma", "mu0", {"sigma": (0.05, 2.0), "mu0": (0.0, 2.0)}),
    "stick_slip": ("hopf", "V", "zeta", {"V": (0.01, 1.5), "zeta": (0.0, 2.0)}),
}


@styled
def gallery_figure(model: Model) -> Sheet:
    """What the gallery shows of a shipped model: on fewer lines where a line takes seconds."""
    n = 60 if len(model.coordinates) < 3 else 24
    kind, *vary, between = GALLERY.get(model.name, ("folds", "theta0", "mu0", {"mu0": (0.0, 1.0)}))
    p = model.Parameters(**dict.fromkeys(set(vary) & {"theta0"}, 1.0))
    if kind == "folds":
        return bifurcation_figure(p, vary, between=between, n=n)
    return stability_figure(onset_curves(p, vary, n, damping=kind == "hopf", between=between))


def main() -> None:
    """All pictures of the gallery, or of the models that are named."""
    folder, *names = sys.argv[1:]
    for name in names or shipped():
        with house_style():
            put(Path(folder) / f"{name}_set.svg", picture(gallery_figure(load(name)), "svg"))
        print(name, flush=True)


if __name__ == "__main__":
    main()
