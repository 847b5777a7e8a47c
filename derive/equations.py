"""The equations of motion of a model as LaTeX, for people."""

import sympy as sp

from . import laws
from .mechanics import DEPTH, MU, PUSHING, Mechanics, number
from .motion import Motion


def equations(model: Mechanics) -> list[str]:
    """One line a coordinate, M q″ + forces = 0, then the definitions of directions and of μ, and of
    a contact law that is no polynomial.
    """
    names = _names(model)
    motion = Motion(model)
    accelerations = sp.Matrix(model.coordinates).applyfunc(
        lambda symbol: sp.Symbol(rf"\ddot{{{names[symbol]}}}")
    )
    directions = (*(line.c for line in model.lines), *(line.s for line in model.lines))
    lines = []
    for row, inertia in enumerate(model.mass * accelerations):
        force = sp.expand(-motion.pull[row])
        text = _latex(sp.collect(force, (*model.coordinates, *model.rates, *directions)), names)
        lines.append(
            f"{_latex(inertia, names)} {text if text.startswith('-') else f'+ {text}'} = 0"
        )
    for line in model.lines:
        for cosine, vector in ((line.c, line.dx), (line.s, line.dy)):
            lines.append(f"{names[line.l]} {names[cosine]} = {_latex(vector, names)}")
    for torsion in model.torsions:
        theta = names[torsion.line.c].removeprefix(r"(\cos").removesuffix(")")
        phi, rest = names[torsion.phi], _latex(torsion.rest, names)
        lines.append(
            rf"{phi} = {theta} - {rest if torsion.rest.is_Symbol else f'({rest})'}, \quad "
            rf"-\pi < {phi} \le \pi"
        )
    if model.slide is not None:
        speed = sp.Symbol("v", positive=True)
        assert model.page.sliding is not None
        law = model.scaled(sp.sympify(model.page.sliding.law(speed)))
        lines.append(
            rf"\mu(v) = {_latex(law, names)}, \quad v = {_latex(laws.slip(model), names)} > 0"
        )
    if not model.in_coordinates and model.gap is not None:
        lines.append(rf"\delta = {_latex(-model.gap, names)}")
    return lines


def _names(model: Mechanics) -> dict[sp.Symbol, str]:
    names = {entry.symbol: entry.latex for entry in model.page.coordinates}
    names |= {entry.rate: rf"\dot{{{entry.latex}}}" for entry in model.page.coordinates}
    names |= {number(datum): sp.latex(number(datum)) for datum in model.parameters}
    for angle in model.angles:
        letter = next(datum.latex for datum in model.parameters if number(datum) == angle.symbol)
        names |= {angle.c: rf"(\cos{{{letter}}})", angle.s: rf"(\sin{{{letter}}})"}
    for count, line in enumerate(model.lines, 1):
        mark = "" if len(model.lines) == 1 else f"_{count}"
        names |= {
            line.c: rf"(\cos\theta{mark})",
            line.s: rf"(\sin\theta{mark})",
            line.l: f"L{mark}",
        }
    for count, torsion in enumerate(model.torsions, 1):
        names[torsion.phi] = r"\varphi" if len(model.torsions) == 1 else rf"\varphi_{count}"
    return names | {MU: r"\mu", PUSHING: r"\overline{n}", DEPTH: r"\delta"}


def _latex(expression: sp.Expr, names: dict[sp.Symbol, str]) -> str:
    return str(sp.latex(expression, symbol_names=names))
