"""The derivation of a page as a text: its nomenclature, energies, laws, equations of motion with
units and scaled, equilibrium and linearization, as an appendix has them.

Every equation is an object of :mod:`derive.statements.objects`, with the words by which a file of
statements names it, so that what is written here can be read back and judged.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
import re
from dataclasses import dataclass

import sympy as sp
from sympy import Expr, Matrix, Symbol

from . import drawing, physical_checks, units
from .emit.names import latex
from .mechanics import NormalForce
from .model import Element, expression_of
from .pages import PageModel
from .statements.objects import Derivation, derivation_of, derived


@dataclass(frozen=True)
class Formula:
    """A numbered equation: a residual that is 0, or the value of a name.

    ``about`` names the object for a file of statements; it is empty for what is not judged.
    """

    label: str
    about: str
    left: str  #: LaTeX
    right: str  #: LaTeX
    form: str = "units"
    relation: str = "="

    @property
    def latex(self) -> str:
        """The whole equation."""
        return f"{self.left} {self.relation} {self.right}"


@dataclass(frozen=True)
class Listing:
    """A table."""

    titles: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class Section:
    """A section: paragraphs, of which formulas are parts, and tables. Texts hold LaTeX between
    dollar signs.
    """

    title: str
    parts: tuple[str | Formula | Listing, ...]


@dataclass(frozen=True)
class Manuscript:
    """A page's derivation, to be read."""

    title: str
    name: str
    picture: str  #: SVG
    typed: tuple[str, ...]  #: the drawing in characters, where there is no other
    sections: tuple[Section, ...]
    symbols: Mapping[str, str]  #: letters of the text that are no names of the page

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """All numbered equations."""
        parts = (part for section in self.sections for part in section.parts)
        return tuple(part for part in parts if isinstance(part, Formula))


def manuscript(model: PageModel) -> Manuscript:
    """The derivation of a page, section by section."""
    measured = derivation_of(model.page, model.mechanics, "units")
    scaled = derivation_of(model.page, model.mechanics, "scaled")
    sections = [
        Section("Nomenclature", tuple(_nomenclature(measured))),
        Section("Energies", tuple(_energies(measured))),
        Section("Contact and friction", tuple(_laws(measured))),
        Section("Equations of motion", tuple(_motion(measured))),
        Section("Dimensionless equations", (*_scales(measured), *_laws(scaled), *_motion(scaled))),
    ]
    if model.mechanics.clock is None:
        sections.append(Section("Equilibrium", tuple(_equilibrium(scaled))))
    sections.append(Section("Small deviations", tuple(_linearization(scaled))))
    return Manuscript(
        model.page.summary.rstrip("."),
        model.name,
        drawing.render(model.page, model.docstring),
        () if drawing.is_drawn(model.page) else tuple(drawing.typed(model.docstring)),
        tuple(it for it in sections if it.parts),
        _symbols(measured) | _symbols(scaled),
    )


def _latex(derivation: Derivation, expression: Expr) -> str:
    """LaTeX in the letters of the page."""
    found = {it: derivation.letters.get(str(it), "") for it in expression.free_symbols}
    letters = {it: to for it, to in found.items() if to}
    shown = expression.replace(sp.atan2, sp.Function(r"\operatorname{atan2}"))
    return str(sp.latex(shown, symbol_names=letters, ln_notation=True))


def _symbols(derivation: Derivation) -> dict[str, str]:
    """Letters that are read as other names, or not at all."""
    own = (*derivation.parameters, *map(str, (*derivation.model.coordinates, *derivation.switches)))
    return {derivation.letters[it]: it for it in own if derivation.letters[it] != latex(it)}


def _formula(derivation: Derivation, about: str, left: str, entry: Expr) -> Formula:
    """The formula of a value with a name."""
    right = _latex(derivation, _turned(derivation, entry))
    return Formula(_label(derivation, about), about, left, right, derivation.form)


def _label(derivation: Derivation, about: str) -> str:
    """A label for references: the form and the object."""
    return "-".join(re.findall(r"\w+", f"{derivation.form} {about}"))


def _below(name: str) -> str:
    return name and rf"_{{\mathrm{{{name}}}}}"


# ------------------------------------------------------------------------------------------------
# quantities


def _nomenclature(it: Derivation) -> Iterator[str | Formula | Listing]:
    page = it.page
    quantities = (*page.coordinates, *page.units, *page.parameters)
    rows = ((f"${datum.latex}$", datum.meaning, datum.unit) for datum in quantities)
    yield Listing(("symbol", "meaning", "unit"), tuple(rows))
    if it.geometry:
        yield "Length and inclination of a straight element, from its first end to its second, are"
    for length, angle, dx, dy in it.lines:
        if {length, angle} <= it.geometry.keys():
            L, theta = _latex(it, Symbol(length)), _latex(it, Symbol(angle))
            for function, entry in (("cos", dx), ("sin", dy)):
                left = rf"{L} \{function}\left({theta}\right)"
                yield Formula(f"{length}-{function}", "identity", left, _latex(it, entry))
    yield from _angles(it)


def _angles(it: Derivation) -> Iterator[str | Formula]:
    """The definitions of the turnings of torsion springs."""
    for name, least in _turnings(it).items():
        yield "A torsion spring is turned by"
        yield Formula(f"{it.form}-{name}", "definition", latex(name), _latex(it, least), it.form)


def _energies(it: Derivation) -> Iterator[str | Formula]:
    yield "Kinetic energy, and potential energy of springs and weights, are"
    yield _formula(it, "energy T", "T", derived(it, "energy T").entries[0])
    elastic = [_elastic(it, spring) for spring in it.page.springs]
    elastic += [_turned(it, it.spelled(torsion.energy)) for torsion in it.model.torsions]
    given = [it.in_form(energy) for energy, _ in it.page.energies]
    yield _formula(it, "energy V", "V", sp.Add(*elastic, *given))
    if it.page.forces:
        yield "Applied forces are no part of it; they stand in the equations of motion."


def _elastic(it: Derivation, spring: Element) -> Expr:
    """The energy k (l − r)²/2 of a spring, l by the name that the text has for it."""
    along = it.in_form(spring.along or sp.S.Zero)
    if spring.ends is not None:
        (ax, ay), (bx, by) = spring.ends
        vector = it.in_form(expression_of(bx - ax)), it.in_form(expression_of(by - ay))
        named = (length for length, _, *ends in it.lines if tuple(ends) == vector)
        length = next((one for one in named if one in it.geometry), "")
        along = Symbol(length) if length else sp.sqrt(vector[0] ** 2 + vector[1] ** 2)
    return it.in_form(spring.strength) * (along - it.in_form(spring.rest)) ** 2 / 2


def _laws(it: Derivation) -> Iterator[str | Formula]:
    """Normal forces and friction coefficients."""
    for contact in it.model.contacts:
        if it.page.contacts:
            yield from _contact(it, contact)
    for index, friction in enumerate(it.page.frictions):
        name = it.model.frictions[index].name
        mu, speed = r"\mu" + _below(name), _latex(it, it.speeds[index])
        yield f"The friction coefficient, at the sliding speed ${speed}$, is"
        entry = it.friction[it.coefficients[index]]
        yield _formula(it, f"friction {name}".strip(), mu, entry)
        if friction.holds is not None:
            held = _latex(it, it.in_form(friction.holds))
            normal = f"N{_below(name)}"
            yield (
                "Where the sliding speed is 0 it sticks, as long as the force of friction "
                rf"that this takes is at most ${held}\,{normal}$ in size."
            )


def _contact(it: Derivation, contact: NormalForce) -> Iterator[str | Formula]:
    below = _below(contact.name)
    named = contact.name and f" of {contact.name}"
    if contact.gap is not None:
        gap = _latex(it, it.spelled(contact.gap))
        yield f"The contact{named} touches where its gap ${gap}$ is not positive; its force is"
    else:
        yield f"The normal force{named} is"
    push, about = it.spelled(contact.push), f"normal {contact.name}".strip()
    if not contact.unilateral:
        yield _formula(it, about, f"N{below}", push)
    else:
        force = rf"\left({_latex(it, push)}\right) \overline{{n}}{below}"
        about = f"{about}, both"
        yield Formula(_label(it, about), about, f"N{below}", force, it.form)
        yield rf"with $\overline{{n}}{below} = 1$ in contact, and 0 where it is open."


# ------------------------------------------------------------------------------------------------
# equations


def _residual(it: Derivation, entry: Expr) -> str:
    """LaTeX of a sum that is 0: inertia first, then what moves, then the rest."""
    moving = (*it.accelerations, *it.model.rates, *it.model.coordinates)
    parts = sp.collect(sp.expand(_turned(it, entry)), moving, evaluate=False)
    rest = parts.pop(sp.S.One, sp.S.Zero)
    ordered = sorted(parts, key=lambda key: [-sp.degree(key, one) for one in moving])
    texts = [_product(it, parts[key], key) for key in ordered]
    texts += [_latex(it, rest)] if rest != 0 or not texts else []
    joined = (text if text.startswith("-") else f"+ {text}" for text in texts[1:])
    return " ".join([texts[0], *joined])


def _product(it: Derivation, factor: Expr, moving: Expr) -> str:
    """LaTeX of a factor times what moves, which stands last."""
    text, factors = _latex(it, factor), {sp.S.One: "", sp.S.NegativeOne: "-"}
    text = rf"\left({text}\right)" if factor.is_Add else text
    return f"{factors.get(factor, text)} {_latex(it, moving)}".strip()


def _turned(it: Derivation, entry: Expr) -> Expr:
    """An expression with the names of turnings."""
    return entry.xreplace({least: Symbol(name) for name, least in _turnings(it).items()})


def _turnings(it: Derivation) -> dict[str, Expr]:
    """The turning of every torsion spring, by its name."""
    taken, torsions = {*it.names}, it.model.torsions
    free = next(name for name in ("chi", "eta", "xi", "zeta", "chi_t") if name not in taken)
    names = [f"{free}_{count}" if len(torsions) > 1 else free for count in range(len(torsions))]
    return {name: it.spelled(one.phi) for name, one in zip(names, torsions, strict=True)}


def _zero(it: Derivation, about: str, left: str) -> Formula:
    return Formula(_label(it, about), about, left, "0", it.form)


def _motion(it: Derivation) -> Iterator[str | Formula]:
    yield "The equations of motion are" if not it.scaled else "In these numbers the motion obeys"
    for place in it.places(""):
        name = it.model.coordinates[place]
        about = f"motion {name}, both" if len(it.sides) > 1 else f"motion {name}"
        yield _zero(it, about, _residual(it, derived(it, about).entries[place]))


def _scales(it: Derivation) -> Iterator[str | Formula]:
    """The products of quantities that become 1, and the numbers that are left."""
    measures = ", ".join(f"${unit.latex}$" for unit in it.page.units)
    if not measures:
        return
    yield f"With {measures} as units of measure, that is with the scales"
    for name, letter, unit in (("length", r"\ell", "m"), ("time", "t", "s"), ("force", "F", "N")):
        scale = physical_checks.scale(it.page, units.read(unit))
        if scale is not None and scale != 1:
            yield Formula(f"scale-{name}", "", f"{letter}_0", _latex(it, scale))
    groups = physical_checks.groups(it.page)
    changed = [datum for datum in it.page.parameters if groups[datum.becomes] != datum.symbol]
    if changed:
        yield "these numbers are left:"
    for datum in changed:
        letter = latex(datum.becomes)
        value = _latex(it, groups[datum.becomes])
        about = f"scale {datum.becomes}"
        relation = r"\to" if letter == datum.latex else "="
        yield Formula(_label(it, about), about, letter, value, it.form, relation)


def _equilibrium(it: Derivation) -> Iterator[str | Formula]:
    yield "At steady sliding, with friction as statics takes it, forces balance:"
    for side in it.sides:
        if len(it.sides) > 1:
            yield f"in {side}," if side in ("contact", "lift-off") else f"with {side},"
        for place in it.places(""):
            about = f"equilibrium {it.model.coordinates[place]}"
            about += f", {side}" if len(it.sides) > 1 else ""
            yield _zero(it, about, _residual(it, derived(it, about).entries[place]))


def _linearization(it: Derivation) -> Iterator[str | Formula]:
    matrices = {"mass": "M", "damping": "C", "gyroscopic": "G", "stiffness": "K"}
    if it.model.gyroscopic.is_zero_matrix:
        del matrices["gyroscopic"]
    moving = {"M": r"\ddot{\mathbf{q}}", "K": r"\mathbf{q}"}
    sums = _sum(matrices.values(), moving, r"\dot{\mathbf{q}}")
    yield rf"Small deviations $\mathbf{{q}}$ from steady sliding obey ${sums} = 0$ with"
    for word, letter in matrices.items():
        n = len(it.places(""))
        about = _on_side(it, word if n > 1 else f"{word} 1 1")
        tidy = sp.factor_terms if n > 1 else sp.expand
        entries = (tidy(_turned(it, one)) for one in derived(it, about).entries)
        matrix = Matrix(n, n, [*entries])
        left = rf"\mathbf{{{letter}}}"
        yield _formula(it, about, left, matrix if n > 1 else matrix[0])
    if it.model.clock is None:
        yield r"and grow as $e^{\lambda t}$, with every $\lambda$ for which"
        sums = _sum(matrices.values(), {"M": r"\lambda^2", "K": ""}, r"\lambda")
        left = rf"\det\left({sums}\right)" if len(it.places("")) > 1 else sums
        yield _zero(it, _on_side(it, "characteristic"), left)


def _sum(letters: Iterable[str], factors: Mapping[str, str], other: str) -> str:
    """The sum of matrices, each with its factor."""
    return " + ".join(rf"\mathbf{{{it}}} {factors.get(it, other)}".strip() for it in letters)


def _on_side(it: Derivation, about: str) -> str:
    """The object where all contacts touch that can touch together."""
    return f"{about}, {it.side_of('')}" if len(it.sides) > 1 else about
