"""An exported page whose quantities bear names of languages: every function gives the numbers of
Python in each of them.
"""

import subprocess
from pathlib import Path
from typing import Any

import numpy as np

from spragsym.derive import export, pages
from spragsym.models.load import page_of
from tests.oracles import exports

#: Roles of names: a coordinate, an angle, and parameters in every function that pages have.
PAGE = '''r"""A block."""
from spragsym.derive.model import Abs, Page, atan, cos, cosh, exp, log, pi as PI, sin, sinh, sqrt, tanh
page = Page("A block on a belt.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
L = page.unit("L", "m", "length")
q = page.coordinate({0!r}, "m", "displacement")
t = page.parameter({1!r}, "rad", "angle", "(0, pi/2)", 0.4)
a = page.parameter({2!r}, "1", "friction", "> 0", 0.3)
b = page.parameter({3!r}, "s/m", "steepness", "> 0", 0.3)
c = page.parameter({4!r}, "N s/m", "damping", "> 0", 0.3)
d = page.parameter({5!r}, "1", "share", "real", 0.3)
f = page.parameter("force", "N", "force", "> 0", 0.3, becomes={6!r})
V = page.parameter({7!r}, "m/s", "belt speed", ">= 0", 0.3)
page.kinetic(m * page.rate(q)**2 / 2)
page.potential(k * q**2 / 2 * (1 + d**2 * sin(q / L)**2 + tanh(d) + log(2 + Abs(d)) + sqrt(1 + d**2)))
page.damper(c * (1 + q**2 / L**2), along=q)
page.force(f * cos(t) * (PI + atan(q / L)), along=q)
page.normal_force(k * L)
page.friction(q, V, lambda v: a * tanh(v / V) * (1 + exp(-b * Abs(v))))
'''


#: Every role of names on one page: coordinates, units, contacts with friction, springs, parameters.
ROLES = '''r"""Two contacts."""
from spragsym.derive.model import Page, sgn, tanh
page = Page("A block between two others.")
coordinates, units, contacts, parameters = {0!r}
x, y = (page.coordinate(name, "m", "displacement") for name in coordinates)
m, k, L = (page.unit(name, unit, "scale") for name, unit in zip(units, ("kg", "N/m", "m")))
a, V, c, *others = [
    page.parameter(name, unit, "number", "> 0", 0.1)
    for name, unit in zip(parameters, ("1", "m/s", "N s/m", *["N/m"] * len(parameters)))
]
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
for stiffness in others:
    page.spring(stiffness, along=x)
page.spring(k, along=x)
page.spring(k, along=y)
page.damper(c, along=x)
page.force(a * c * V, along=x)
for name, gap in zip(contacts, (y - L, -y - L)):
    touching = page.contact(gap, lambda depth: k * depth, name=name)
    if name == contacts[0]:
        page.friction(x, V, slip=lambda v: a * sgn(v), holds=a, on=touching)
    else:
        page.friction(x, V, lambda v: a * tanh(v / V), on=touching)
'''


def compare(model: Any, home: Path, rng: np.random.Generator, names: list[str]) -> list[str]:
    """What is off in each language that is on this machine."""

    def values(asked: tuple[str, ...]) -> dict[str, float]:
        given = {key: float(rng.uniform(0.2, 0.9)) for key in asked}
        for angle, (cosine, sine) in model.about["angles"].items():
            turn = given.get(angle, 0.5)
            given |= {
                key: value
                for key, value in ((cosine, np.cos(turn)), (sine, np.sin(turn)))
                if key in given
            }
        return given

    calls, wrong = exports.calls(model, values), []
    exact = np.concatenate([call.results for call in calls])
    for language, (_, there, run) in exports.RUN.items():
        if there is None:
            continue
        out = home / language
        for name, text in export.export(
            page_of(model, pages.SHIPPED), model.name, language
        ).items():
            (out / name).parent.mkdir(parents=True, exist_ok=True)
            (out / name).write_text(text, encoding="utf-8")
        try:
            off = np.abs(np.array(run(out, calls)) - exact).max()
        except (subprocess.SubprocessError, RuntimeError) as error:
            off = f"{error} {getattr(error, 'stderr', '')}"
        if isinstance(off, str) or not off <= 1e-13 * np.abs(exact).max():
            wrong.append(f"{language} of {model.name} with {names}: {off}")
    return wrong
