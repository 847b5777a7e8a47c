"""The equations of motion of a model in LaTeX, to be read by people."""

import sympy as sp
from sympy import Symbol

from . import laws
from .emit.names import latex
from .mechanics import SLIP, Mechanics, NormalForce, number
from .motion import Motion


def equations(model: Mechanics) -> list[str]:
    """Lines of LaTeX: M q″ + forces = 0 for each coordinate, then the definitions of directions,
    torsion angles, friction coefficients, normal forces and penetrations.
    """
    names = _names(model)
    motion = Motion(model)
    accelerations = sp.Matrix(model.coordinates).applyfunc(
        lambda symbol: Symbol(rf"\ddot{{{names[symbol]}}}")
    )
    either = [contact for contact in model.contacts if contact.either_face]
    signs = {one.pushing: (1 + _sign(one)) / 2 for one in either}
    directions = (*(line.c for line in model.lines), *(line.s for line in model.lines))
    lines = []
    for row, inertia in enumerate(model.mass * accelerations):
        force = sp.expand(-motion.pull[row].subs(signs))
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
    for friction in model.frictions:
        if friction.along != 0:
            law = friction.ahead.subs(SLIP, Symbol("v", positive=True))
            mu, slip = names[friction.mu], _latex(laws.slip(friction), names)
            lines.append(rf"{mu}(v) = {_latex(law, names)}, \quad v = {slip} > 0")
    for contact in model.contacts:
        if contact.either_face and contact.border is not None:
            lines.append(f"N{_below(contact.name)} = {_latex(-contact.border, names)}")
    for contact in model.contacts:
        if not contact.in_coordinates and contact.gap is not None:
            lines.append(f"{names[contact.depth]} = {_latex(-contact.gap, names)}")
    return lines


def _names(model: Mechanics) -> dict[Symbol, str]:
    """LaTeX of all symbols."""
    names = {entry.symbol: entry.latex for entry in model.page.coordinates}
    names |= {entry.rate: rf"\dot{{{entry.latex}}}" for entry in model.page.coordinates}
    names |= {number(datum): latex(datum.becomes) for datum in model.parameters}
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
    for friction in model.frictions:
        names[friction.mu] = r"\mu" + _below(friction.name)
    for contact in model.contacts:
        below = _below(contact.name)
        names |= {contact.pushing: r"\overline{n}" + below, contact.depth: r"\delta" + below}
        names[_sign(contact)] = rf"(\operatorname{{sgn}} N{below})"
    return names


def _sign(contact: NormalForce) -> Symbol:
    """The symbol of the sign of a contact's force, which says on which face it presses."""
    return Symbol(f"_sign_{contact.name}", real=True)


def _below(name: str) -> str:
    """The name of a contact as a LaTeX index; empty if there is only one."""
    return rf"_{{\mathrm{{{name}}}}}" if name else ""


def _latex(expression: sp.Expr, names: dict[Symbol, str]) -> str:
    return str(sp.latex(expression, symbol_names=names))
