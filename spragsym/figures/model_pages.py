"""The gallery of the documentation: every shipped model with its drawing, its equations and where its equilibria change.

``python -m spragsym.figures.model_pages > docs/models.md`` writes the page anew.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..bifurcation.cusps import cusps
from ..bifurcation.folds import folds
from ..models.load import load, shipped
from ..models.model import Model

_HEAD = """# Models

Each of these models is a page of some 40 lines in `derive/models/`; [](howto_model.md) says how to write another one. All are
loaded by their names, `model = ss.load("two_springs")`, and take the same functions and the same commands, with `--model`. In the
equations n̄ is 1 where the mass touches the belt and 0 elsewhere, and a dot is the rate in the model's unit of time.
"""

#: Below the pictures that ``python -m spragsym.figures.gallery docs/images/models`` draws.
_SET = "Two equilibria in contact meet on the lines; the dot is the cusp."
_CAPTIONS = {
    "stribeck": "Two equilibria in contact meet on the lines.",
    "mode_coupling": "Flutter without damping begins on the curve: at the friction that the closed form above gives.",
    "sprag_rod": "Two equilibria in contact meet on the lines; the stiffer the wall, the closer the upper one to tan θ₀ = μ₀.",
    "stick_slip": "Sliding is unstable below the curve of Hopf points, gentle where it is full and dangerous where it is dashed.",
}


def page(names: tuple[str, ...] | None = None, points: bool = True) -> str:
    """The page as Markdown; without ``points``, nothing is computed."""
    chosen = names or shipped()
    order = sorted(chosen, key=lambda name: (name != "kang_nam", name))
    return "\n".join([_HEAD, *(_section(load(name), points) for name in order)])


def _section(model: Model, points: bool) -> str:
    about = model.about
    title, _, rest = about["drawing"].partition("\n\n::\n\n")
    blocks = rest.split("\n\n")
    while len(blocks) > 1 and blocks[1].startswith("    "):  # a drawing with blank lines
        blocks[:2] = ["\n\n".join(blocks[:2])]
    words = "\n\n".join(blocks[1:])
    formulas = r" \\ ".join(f"& {line}" for line in about["equations"])
    lines = [
        f"## {model.name}",
        "",
        title,
        "",
        f"![The mechanism of {model.name}](images/models/{model.name}.svg)",
        "",
        f'<a href="explorer_{model.name}.html">Let it move, and walk through its states, in the browser.</a>',
        "",
        _words(words),
        "",
    ]
    lines += ["$$", rf"\begin{{aligned}} {formulas} \end{{aligned}}", "$$", "", *_table(model)]
    lines += [
        "",
        f"![Where the equilibria of {model.name} change](images/models/{model.name}_set.svg)",
        "",
        _CAPTIONS.get(model.name, _SET),
    ]
    if points:
        lines += ["", *_points(model)]
    return "\n".join(lines) + "\n"


def _words(text: str) -> str:
    """Indented formulas as code."""
    return "\n\n".join(f"```text\n{block}\n```" if block.startswith("    ") else block for block in text.split("\n\n"))


def _table(model: Model) -> list[str]:
    rows = ["| parameter | base | allowed | meaning | in brake.toml |", "|---|---|---|---|---|"]
    for entry in model.about["parameters"]:
        base = "" if entry["base"] is None else f"{entry['base']:g}"
        rows.append(f"| `{entry['name']}` | {base} | {entry['domain']} | {entry['meaning']} | {_quantity(entry)} |")
    units = (f"`{entry['name']}` in {entry['unit']}, the {entry['meaning']}" for entry in model.about["units"])
    return [*rows, "", f"In `brake.toml` stand also {'; '.join(units)}: they are the units of the others."]


def _quantity(entry: Mapping[str, Any]) -> str:
    """The name of a quantity in the file of a brake, and its unit."""
    unit = {"1": "", "rad": " in deg"}.get(entry["quantity_unit"], f" in {entry['quantity_unit']}")
    return f"`{entry['quantity']}`{unit}"


def _points(model: Model) -> list[str]:
    """Folds and cusps at the base values."""
    known = model.parameters
    if not {"theta0", "mu0"} <= set(known):
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
        found += [f"{what}: {listed or 'none'}{more}.", ""]
    return found


if __name__ == "__main__":
    print(page(), end="")
