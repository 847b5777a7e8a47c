"""A page's functions in another language, on demand: what ``generated/models`` has in Python, as a
library of the model's name.
"""

import math
import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import TypeAlias

import sympy as sp

from . import folder, motion, pages, units
from .emit import definitions, targets
from .emit.function import Function, renamed
from .emit.python import algebra
from .emit.quantities import Quantity, interval
from .emit.targets.c.layout import WIDTH, broken
from .mechanics import Mechanics, NormalForce, number
from .model import Datum, PageError

#: Of a page's quantities by their names: a value, its unit if it is not the page's, and what one of
#: it is in SI.
Data: TypeAlias = Mapping[str, tuple[float, str, float]]

#: What the explorer's page of a model asks its algebra for: all that ``explorer/src`` calls.
EXPLORED = frozenset(
    {
        "border_rates",
        "borders",
        "contact_force",
        "contact_gap",
        "damping",
        "forces",
        "forces_jacobian",
        "friction_at_rest",
        "geometry",
        "grip",
        "gyroscopic",
        "mass_matrix",
        "regime_rhs",
        "spring_forces",
        "turning_borders",
        "turnings",
    }
)


class UnknownInput(LookupError):
    """An input that is no quantity of the page."""


#: Of forces, energy and power: what each is, its unit in SI, and the order of its derivative.
_OUTPUTS = {
    "force.normal": ("normal force of the contact", "N", 0),
    "force.friction": ("force of friction, positive in the belt's direction", "N", 0),
    "energy": ("kinetic and stored energy, contact and applied forces included", "J", 0),
    "power": (
        "rate at which friction, dampers and forces without a potential change the energy",
        "J",
        1,
    ),
}
_TENSION = ("tension of a spring, negative where it pushes", "N", 0)


def export(
    page: Path,
    name: str,
    written_in: str,
    data: Data | None = None,
    inputs: Collection[str] = (),
) -> dict[str, str]:
    """The files of a page's library in a language, by their names.

    It has the model's ``name``, and data if there are any. Of an FMU, ``inputs`` are the quantities
    that other models drive; the others are parameters.
    """
    model = pages.read(page, name)
    _refuse_frictions_that_hold_together(model.mechanics)
    whole = targets.packer(written_in) is not None
    moves = _motion(model, data, inputs) if whole else None
    made = material(model, in_python=targets.in_python(written_in), moving=whole)
    return targets.render(written_in, replace(made, motion=moves))


def _refuse_frictions_that_hold_together(it: Mechanics) -> None:
    """An error of several frictions of which some hold: which of them stick at rest no formula
    tells.
    """
    holding = [friction for friction in it.frictions if friction.holds is not None]
    if holding and len(it.frictions) > 1:
        raise PageError(
            holding[-1].line,
            "of several frictions some hold where nothing slides, and which of them do at one "
            "instant is found step by step, by spragsym.simulate: an export takes laws that are "
            "steep at rest, as mu0*tanh(d*v), in their place",
        )


def for_the_browser(model: pages.Model, header: str) -> str:
    """The functions of a page that the explorer calls, as an ES module."""
    files = targets.render("javascript", material(model, header, EXPLORED))
    return files[f"{library(model.name)}.mjs"]


def material(
    model: pages.Model,
    header: str | None = None,
    only: Collection[str] | None = None,
    in_python: bool = False,
    moving: bool = False,
) -> targets.Material:
    """What a target prints of a page: all functions that have a result, or those of them that
    ``only`` names.

    With ``moving``, forces, energy and power of a motion as one function too. In Python names are
    as on the page, and directions of springs follow from the place, so that derivatives by it are
    whole.
    """
    it = model.mechanics
    named: Callable[[object], str] = str if in_python else spelled

    def given(function: Function) -> Function:
        return _following(it, function) if in_python else renamed(function, spelled)

    modules = tuple(
        tuple(
            read
            for function in module.functions
            if only is None or function.name in only
            if (read := definitions.definition(algebra.definition(given(function)))).leaves
        )
        for module in (*folder.modules(it), *([motion.outputs(it)] if moving else []))
    )
    meanings = dict(folder.meanings(it)) | {
        datum.becomes: f"{datum.meaning}, radians" for datum in it.parameters if datum.unit == "rad"
    }
    quantities = {
        datum.becomes: Quantity(number(datum), "", meanings[datum.becomes], domain=datum.domain)
        for datum in it.parameters
    }
    return targets.Material(
        modules=modules,
        quantities=quantities
        | {
            named(name): Quantity(sp.Symbol(name), "", meaning)
            for name, meaning in meanings.items()
        },
        parameters=tuple(datum.becomes for datum in it.parameters),
        base_values={
            datum.becomes: datum.base for datum in it.parameters if datum.base is not None
        },
        public=tuple(function.name for module in modules for function in module),
        digest=model.digest,
        header=header
        or f"Generated by ``spragsym export`` from {model.name}.py with SymPy {sp.__version__}. "
        "Do not edit.",
        library=library(model.name),
        summary=model.page.summary,
        runtime=_examples(model),
        angles={named(angle.symbol): tuple(map(named, angle.parts)) for angle in it.angles},
        of_a_page=True,
    )


def _motion(model: pages.Model, data: Data | None, inputs: Collection[str]) -> targets.Motion:
    """What moves: with data in their units and else in SI, without any in none."""
    it, page = model.mechanics, model.page
    measures = page.units if data is not None else []
    kinds = tuple(units.read(measure.unit) for measure in measures)
    sizes = [math.prod((data or {})[str(measure.symbol)][::2]) for measure in measures]

    def variable(
        name: str, meaning: str, unit: str, order: int = 0, quantity: str = ""
    ) -> targets.Variable:
        """The derivative of this order of what is in the unit, by time."""
        radians, dimension = (
            Fraction(unit == "rad"),
            units.times(units.read(unit), units.TIME, -order),
        )
        if data is None:
            return targets.Variable(
                name, meaning, "rad" if radians and not order else "", (*units.NONE, radians)
            )
        _, given_in, factor = data.get(quantity, (0.0, "", 1.0))
        unit = given_in or unit + ("", "/s", "/s^2")[order]
        powers = tuple(map(float, units.powers(dimension, kinds) or ()))
        nominal = math.prod(map(pow, sizes, powers)) / factor
        return targets.Variable(
            name,
            meaning,
            unit if unit != "1" else "",
            (*dimension, radians),
            factor,
            powers,
            nominal,
        )

    def given(datum: Datum) -> targets.Variable:
        name = str(datum.symbol)
        one = variable(
            datum.becomes if data is None else name, datum.meaning, datum.unit, quantity=name
        )
        start = data[name][0] if data and name in data else _base(it, datum) * one.nominal
        ends = interval(datum.domain)
        return replace(
            one,
            start=start,
            allowed=replace(ends, low=ends.low * one.nominal, high=ends.high * one.nominal),
            input="" if one.name not in inputs else "discrete" if jumps(datum) else "continuous",
        )

    def jumps(datum: Datum) -> bool:
        """Whether a mode may end where the quantity changes: a border has it, or all numbers."""
        return datum in page.units or bool({*it.parts(number(datum))} & bordering)

    moves = motion.Motion(it)
    bordering = sp.Tuple(*moves.borders).free_symbols
    time, places = variable("time", "time", "s" if data is not None else "1"), page.coordinates
    known = [str(datum.symbol if data is not None else datum.becomes) for datum in it.parameters]
    known += [str(measure.symbol) for measure in measures]
    if unknown := sorted(set(inputs) - set(known)):
        raise UnknownInput(
            f"{', '.join(unknown)} is no quantity of {model.name}; give {', '.join(known)}"
        )
    return targets.Motion(
        time=time,
        states=(
            *(variable(str(place.symbol), place.meaning, place.unit) for place in places),
            *(
                replace(
                    variable(str(place.rate), f"rate of {place.symbol}", place.unit, 1),
                    reset=it.holds and moves.borders[1].has(rate),
                )
                for place, rate in zip(places, it.rates, strict=True)
            ),
        ),
        accelerations=tuple(
            variable("", f"acceleration of {place.symbol}", place.unit, 2) for place in places
        ),
        given=tuple(map(given, (*it.parameters, *measures))),
        step=float(f"{0.1 * time.nominal:.0e}"),
        borders=(
            *(["gap"] if it.contact.unilateral else []),
            *(["face"] if it.contact.either_face else []),
            *(["slip"] if it.friction.along is not None else []),
            *(["ahead", "behind"] if it.holds else []),
            *(f"turning{count}" for count, _ in enumerate(it.torsions, 1)),
        ),
        rooted=not it.contact.polynomial,
        outputs=tuple(variable(name, *_OUTPUTS.get(name, _TENSION)) for name in moves.outputs),
    )


def _following(it: Mechanics, function: Function) -> Function:
    """The function without the directions and turnings of springs among its arguments."""
    known = motion.directions(it)
    arguments = tuple(symbol for symbol in function.arguments if symbol not in known)
    return replace(function, arguments=arguments, shorthands={**known, **function.shorthands})


def spelled(name: object) -> str:
    """A page's name in another language, where no word, function or constant ends with an
    underscore; our own without the first one.
    """
    return str(name)[1:] if str(name).startswith("_") else f"{name}_"


def library(name: str) -> str:
    """What files and functions of an export begin with: a page's name as far as it has letters and
    digits of ASCII; the example is ``main``.
    """
    tidy = re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_")
    return tidy if tidy[:1].isalpha() and tidy != "main" else f"page_{tidy}"


def _base(it: Mechanics, datum: Datum) -> float:
    """The base value of a parameter, of an angle that has none 45 degrees, of any other 1."""
    angles = {str(angle.symbol) for angle in it.angles}
    return datum.base if datum.base is not None else math.pi / 4 if datum.becomes in angles else 1.0


#: Files of examples, and how each language says a cosine and a sine, a text, a choice by a border,
#: a border by its place, and several texts as one.
_EXAMPLES = {
    "c": ("main.c", "", '"{}"', "{} <= 0.0 ? {} : {}", "border[{}]", "{}"),
    "javascript": (
        "example.mjs",
        "Math.",
        '"{}"',
        "{} <= 0 ? {} : {}",
        "border[{}]",
        "[{}].join(' ')",
    ),
    # MATLAB has no choice in an expression: an element of both
    "matlab": ("example.m", "", "'{}'", "{{{1}, {2}}}{{1 + ({0} > 0)}}", "border{{1 + {}}}", "{}"),
    "jax": ("example.py", "", '"{}"', "{1} if {0} <= 0 else {2}", "border[{}]", "' '.join([{}])"),
}
_EXAMPLES["casadi"] = _EXAMPLES["jax"]


def _examples(model: pages.Model) -> dict[str, dict[str, str]]:
    """By language, an example: a motion at the base values."""
    it = model.mechanics
    count = len(it.coordinates)
    values = {number(datum): repr(_base(it, datum)) for datum in it.parameters}
    common = {
        "count": str(count),
        "borders": str(len(it.contacts) + len(it.frictions)),
        "library": library(model.name),
        "LIBRARY": library(model.name).upper(),
        "values": ", ".join(values.values()) or "0.0",
        "names": ", ".join(map(str, values)) or "none",
        "state": ", ".join(f"state[{place}]" for place in range(2 * count)),
        "given": ", ".join(f"p[{place}]" for place in range(len(values))),
        "shown": "  ".join(f"{name} %+.9f" for name in (*it.coordinates, *it.rates)),
        "texts": " ".join("%s" for _ in it.contacts),
    }

    def filled(language: str) -> str:
        name, of, text, choice, border, joined = _EXAMPLES[language]

        def chosen(touches: Callable[[NormalForce], str], lifted: str) -> str:
            """What is said of each contact, by its border where it opens."""
            return ", ".join(
                choice.format(border.format(place), touches(one), lifted)
                if one.unilateral
                else touches(one)
                for place, one in enumerate(it.contacts)
            )

        taken = [
            f"{of}{'cos' if place else 'sin'}({values[symbol]})"
            if part != symbol
            else values[symbol]
            for symbol in values
            for part, place in _placed(it.parts(symbol))
        ]
        words = common | {
            "arguments": ", ".join(taken),
            "shown_names": ", ".join(text.format(name) for name in (*it.coordinates, *it.rates)),
            "pushing": chosen(lambda _: "1.0", "0.0"),
            "touching": joined.format(
                chosen(
                    lambda one: text.format(
                        (one.name or "contact") if one.unilateral else one.name
                    ),
                    text.format("lift-off"),
                )
            ),
        }
        if language == "matlab":
            words["library"] += "_"
        template = name.replace(".py", ".txt")  # no Python until it is filled in
        whole = targets.spoken(targets.runtime(__file__, f"{language}/{template}"), words)
        return "\n".join(
            broken(line) if language == "c" and len(line) > WIDTH else line
            for line in whole.split("\n")
        )

    own = f"example_{library(model.name)}."
    named = {
        language: name if language == "c" else own + name.partition(".")[2]
        for language, (name, *_) in _EXAMPLES.items()
    }
    return {language: {name: filled(language)} for language, name in named.items()}


def _placed(parts: tuple[sp.Symbol, ...]) -> list[tuple[sp.Symbol, bool]]:
    """Arguments that stand for a parameter, and whether each is the cosine of an angle."""
    return [(part, part is parts[-2]) if len(parts) > 1 else (part, False) for part in parts]
