"""Papers that name no page: the energies and forces that they print are premises, from which a page
is made, and everything else is held against it.

A premise is what the paper says first, and is never confirmed: Lagrange's equations of the printed
T and V are.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import sympy as sp
from sympy import Expr, S, Symbol

from .. import mechanics
from ..model import Page, PageError
from ..pages import PageModel
from .alone import moving_names, read_alone
from .book import TOO_LARGE, by_name
from .papers import Paper, PaperError, Statement
from .tree import Equation, Unread, nodes, symbols, to_sympy
from .verdicts import Checked, check

#: What a user may do instead.
_REMEDY = 'add model = "page.py" to it, or give model'


@dataclass(frozen=True)
class _Prints:
    """A paper's statements, read without a page."""

    equations: Mapping[str, Sequence[Equation]]  #: by the statement's id
    coordinates: tuple[str, ...]
    values: Mapping[str, Expr]  #: of defined names, and of the rates of those that move


def check_premises(paper: Paper) -> Checked:
    """Verdicts on a paper without a page.

    Raises
    ------
    PaperError
        If no energies are printed, or no page can be made of them.
    """
    prints = _read(paper)
    first = _premises(paper, prints)
    model = _page(prints, first)
    judged = [
        replace(it, form="scaled", about="definition" if it.word == "force" else it.about)
        for it in paper.statements
    ]
    found = check(replace(paper, statements=tuple(judged)), model)
    ids = {it.id for it in first.values()}
    rows = []
    for row, it in zip(found.rows, paper.statements, strict=True):
        row = replace(row, about=it.about, form="")
        if row.id in ids and row.status in ("confirmed", "definition"):
            said = "taken as printed; what follows is held against it"
            row = replace(row, status="premise", derived="", derived_by="", evidence=said)
        rows.append(row)
    return replace(found, model="", rows=tuple(rows))


def _read(paper: Paper) -> _Prints:
    """The statements of a paper without a page, and what they define."""
    kept = [it for it in paper.statements if it.about not in ("other", "notation")]
    moving = moving_names((it.judged for it in kept if it.is_latex), paper.renamed)
    equations: dict[str, Sequence[Equation]] = {}
    for it in kept:
        is_latex = it.is_latex and not it.transcribed
        try:
            equations[it.id] = read_alone(it.judged, moving, paper.renamed, is_latex=is_latex)
        except (Unread, *TOO_LARGE):
            continue
    defining = ("definition", "identity", "energy", "force")
    defined: dict[str, Equation] = {}
    for it in kept:
        for one in equations.get(it.id, ()) if it.word in defining else ():
            solved = by_name(one, set())
            name, inside = solved.left.value, symbols(solved.right)
            is_plain = not any(part.startswith("diff(") for part in (name, *inside))
            if solved.left.kind == "symbol" and is_plain and name not in inside:
                defined.setdefault(name, solved)
    names = {
        name: Symbol(name, real=True)
        for held in equations.values()
        for one in held
        for name in symbols(one.left) | symbols(one.right)
    }
    rates = {f"v{it}": it for it in moving}
    places = {
        it
        for it in moving
        for name in (it, f"v{it}")
        if name in defined
        and {rates.get(part, part) for part in symbols(defined[name].right)} & (moving - {it})
    }
    values = {
        name: to_sympy(one.right, names)
        for name, one in defined.items()
        if name not in moving - places and rates.get(name, name) not in moving - places
    }
    chain = {Symbol(it, real=True): Symbol(f"v{it}", real=True) for it in moving}
    for name in places & values.keys():
        slopes = (values[name].diff(place) * rate for place, rate in chain.items())
        values[f"v{name}"] = sp.Add(*slopes)
    printed = (
        rates.get(part.value, part.value)
        for held in equations.values()
        for one in held
        for part in (*nodes(one.left), *nodes(one.right))
    )
    in_order = dict.fromkeys(it for it in printed if it in moving - places)
    return _Prints(equations, tuple(in_order), values)


def _premises(paper: Paper, prints: _Prints) -> dict[str, Statement]:
    """The statements that are premises, by what they are about: the first about each energy and
    each force.

    Raises
    ------
    PaperError
        If there is no kinetic energy.
    """
    first: dict[str, Statement] = {}
    for it in paper.statements:
        if it.word in ("energy", "force") and prints.equations.get(it.id):
            first.setdefault(it.about, it)
    if "energy T" in first:
        first.pop("energy L", None)
    elif "energy L" in first:
        first.pop("energy V", None)
    else:
        said = f"names no model; {_REMEDY}, or print an energy: about energy T, V or L"
        raise PaperError(said)
    for about in first:
        if about.startswith("force ") and about[6:] not in prints.coordinates:
            listed = ", ".join(prints.coordinates)
            raise PaperError(f"{first[about].id}: {about} is of no coordinate; these are {listed}")
    return first


def _page(prints: _Prints, first: Mapping[str, Statement]) -> PageModel:
    """The page that premises make."""

    def value_of(about: str) -> Expr:
        """The right side of a premise in coordinates, rates and parameters."""
        if about not in first:
            return S.Zero
        chain = [*prints.equations[first[about].id]]
        while len(chain) > 1 and chain[1].left not in (chain[0].left, chain[0].right):
            del chain[1]  # of another name, printed beside it
        one = by_name(replace(chain[-1], left=chain[0].left), set())
        names = {it: Symbol(it, real=True) for it in symbols(one.right)}
        values = {it: value for it, value in prints.values.items() if it != one.left.value}
        return _written_out(to_sympy(one.right, names), values)

    T, V = value_of("energy T"), value_of("energy V")
    if whole := value_of("energy L"):
        V = -whole.subs({Symbol(f"v{it}", real=True): 0 for it in prints.coordinates})
        T = sp.expand(whole + V)
    if not T.has(*(Symbol(f"v{it}", real=True) for it in prints.coordinates)):
        raise PaperError(f"energy T, as it is printed first, holds no rates: {T}; {_REMEDY}")
    forces = {it[6:]: value_of(it) for it in first if it.startswith("force ")}
    page = Page("What the paper prints first.")
    moving = {
        f"{mark}{it}" for it in prints.coordinates for mark in ("", "v", "a")
    } | prints.values.keys()
    used = [T, V, *forces.values(), *prints.values.values()]
    free = {str(it) for value in used for it in value.free_symbols} - moving - {"t", "lam"}
    try:
        known = {it: page.coordinate(it, "1", it) for it in prints.coordinates}
        known |= {f"v{it}": page.rate(known[it]) for it in prints.coordinates}
        known |= {it: page.parameter(it, "1", it, "> 0") for it in sorted(free)}
        meant = {Symbol(it, real=True): value for it, value in known.items()}
        page.kinetic(T.xreplace(meant))
        page.potential(V.xreplace(meant))
        still = dict.fromkeys(page.rates, S.Zero)
        power = S.Zero  # of the forces that depend on rates, as dampers
        for place, force in forces.items():
            whole = force.xreplace(meant)
            page.force(whole.subs(still), along=known[place])
            power += (whole.subs(still) - whole) * known[f"v{place}"]
        for place, rate in zip(page.places, page.rates, strict=True):
            whole = forces.get(str(place), S.Zero).xreplace(meant)
            if sp.expand(power.diff(rate) / 2 - whole.subs(still) + whole) != 0:
                said = f"force {place} depends on rates in another way than linear dampers do"
                raise PaperError(f"{said}; {_REMEDY}")
        model = replace(mechanics.of(page), dissipation=sp.expand(power / 2))
        text = repr((T, V, forces, prints.coordinates))
        return PageModel("premises", text, "", page, model)
    except (PageError, ArithmeticError, ValueError) as error:
        said = f"no page can be made of the printed energies: {error}; {_REMEDY}"
        raise PaperError(said) from error


def _written_out(value: Expr, values: Mapping[str, Expr]) -> Expr:
    """An expression without the names that definitions give.

    Raises
    ------
    PaperError
        If these go round in a circle.
    """
    known = {Symbol(name, real=True): it for name, it in values.items()}
    for _ in range(len(known) + 1):
        inside = {it: known[it] for it in value.free_symbols if it in known}
        if not inside:
            return value
        value = value.xreplace(inside)
    raise PaperError("definitions go round in a circle; write one of them out")
