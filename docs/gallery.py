"""The gallery of models: ``python docs/gallery.py [MODEL …]`` writes docs/models.md, and draws
pictures in docs/images/models.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass, field, replace
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


@dataclass(frozen=True)
class Shown:
    """What the page says of a model, and the plane that it draws: where states meet ("folds"), or
    oscillation begins with damping ("hopf") or without ("flutter").
    """

    text: str
    kind: str = ""
    vary: tuple[str, str] = ("", "")
    between: dict[str, tuple[float, float]] = field(default_factory=dict)


#: Of models with an inclination and a friction, unless they stand below.
USUALLY = Shown(
    "Two equilibria in contact meet on the lines; the dot is the cusp.",
    "folds",
    ("theta0", "mu0"),
    {"mu0": (0.0, 1.0)},
)
#: Of others nothing is said or drawn, unless they do.
GALLERY = {
    "sprag_rod": replace(
        USUALLY,
        text="Two equilibria in contact meet on the lines; the stiffer the wall, the closer the "
        "upper one to tan θ₀ = μ₀.",
    ),
    "two_springs": replace(USUALLY, between={"mu0": (0.0, 1.4)}),
    "stribeck": Shown(
        "Two equilibria in contact meet on the lines.",
        "folds",
        ("theta0", "mu_s"),
        {"mu_s": (0.0, 1.5)},
    ),
    "mode_coupling": Shown(
        "Flutter without damping begins on the curve: at the friction that the closed form above "
        "gives.",
        "flutter",
        ("sigma", "mu0"),
        {"sigma": (0.05, 2.0), "mu0": (0.0, 2.0)},
    ),
    "wobbling_disc": Shown(
        "Squeal sets in on the curve of Hopf points, supercritical where it is full: above it in "
        "friction, and the slower the disc turns\nthe later.",
        "hopf",
        ("Omega", "mu0"),
        {"Omega": (0.02, 1.0), "mu0": (0.0, 3.0)},
    ),
    "disc_between_pads": Shown(
        "The middle, y = φ = 0, begins to flutter without damping on the curve: at the friction "
        "that the closed form above gives.",
        "flutter",
        ("beta", "mu0"),
        {"beta": (0.0, 1.0), "mu0": (0.0, 1.0)},
    ),
    "stick_slip": Shown(
        "Sliding is unstable below the curve of Hopf points, supercritical where it is full, "
        "subcritical where it is dashed.",
        "hopf",
        ("V", "zeta"),
        {"V": (0.01, 1.5), "zeta": (0.0, 2.0)},
    ),
    "coulomb_stick_slip": Shown(
        "Its one equilibrium is x = μ_k in contact for every V > 0; what changes is the "
        "oscillation about it. From rest at x = 0 the mass sticks only\nif V ≤ μ_k: else it slides "
        "for ever, on one of many circles. `near=(mu_s, V)` of `ss.cycle` begins where it slips."
    ),
    "two_blocks": Shown(
        "Its one equilibrium slides for every V > 0, and falling friction makes it unstable: what "
        "changes is the oscillation about it, periodic or\nchaotic by the speed of the belt. "
        "`ss.diagram` has its cycles over V, `ss.sticking_states` where both blocks rest on a belt "
        "that\nstands still."
    ),
    "pad_on_legs": Shown(
        "Its one equilibrium passes at that friction from both legs to the front leg alone: "
        "`ss.folds` has it as a border point of the kind\n`passes`, and with k_t = 0 as a "
        "`border_fold`."
    ),
    "forced_oscillator": Shown(
        "Nothing rests but what friction holds in every phase: what is asked of it are cycles, "
        "`ss.cycle(p, turns=1)`, and their fates. `ss.basin`\ntells starts that stick for good "
        "from those that are driven."
    ),
}


def shown(model: Model) -> Shown:
    """What is shown of a model."""
    usual = {*USUALLY.vary} <= set(model.parameters)
    return GALLERY.get(model.name, USUALLY if usual else Shown(""))


def explored() -> list[str]:
    """Models that the explorer shows."""
    return [name for name in shipped() if not ss.load(name).refusal("explore")]


def page(points: bool = True) -> str:
    """The page as Markdown; without ``points``, nothing is computed."""
    models = [ss.load(name) for name in sorted(shipped(), key=lambda name: (name != USUAL, name))]
    rows = [
        (
            model.about,
            *title_drawing_words(model.about)[::2],
            shown(model),
            computed(model) if points else [],
        )
        for model in models
    ]
    made = jinja2.Environment(
        undefined=jinja2.StrictUndefined, trim_blocks=True, keep_trailing_newline=True
    )
    return made.from_string((HERE / "models.jinja").read_text(encoding="utf-8")).render(
        models=rows, explored=explored()
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
    plane = shown(model)
    p = model.Parameters(**dict.fromkeys(set(plane.vary) & {"theta0"}, 1.0))
    if plane.kind == "folds":
        return bifurcation_figure(p, plane.vary, between=plane.between, n=n)
    damping = plane.kind == "hopf"
    return stability_figure(
        ss.onset_curves(p, plane.vary, n, damping=damping, between=plane.between)
    )


if __name__ == "__main__":
    (HERE / "models.md").write_text(page(), encoding="utf-8")
    for name in sys.argv[1:] or shipped():
        if not shown(ss.load(name)).kind:
            continue
        with house_style():
            (HERE / f"images/models/{name}_set.svg").write_bytes(
                picture(drawn(ss.load(name)), "svg")
            )
        print(name, flush=True)
