"""Export of a page's model to another language: the functions that ``generated/models`` has in
Python, as a library.
"""

import itertools
import math
from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import TypeAlias

import sympy as sp

from . import drawing, folder, mechanics, motion, pages, scene, units
from .emit import definitions, targets
from .emit.names import apart, library, spelled
from .emit.function import Function, Module, renamed
from .emit.python import algebra
from .emit.quantities import Quantity, interval
from .emit.targets.c.layout import broken
from .mechanics import Mechanics, NormalForce, number
from .model import Datum

#: Data of a page's quantities by name: value, unit if it is not the page's, and the unit in SI.
Data: TypeAlias = Mapping[str, tuple[float, str, float]]


class UnknownInput(LookupError):
    """An input that is no quantity of the page."""


def export(
    page: Path,
    name: str,
    written_in: str,
    data: Data | None = None,
    inputs: Collection[str] = (),
    starts: tuple[targets.Start, ...] = (),
) -> dict[str, str]:
    """The files of a page's library in a language, by name.

    ``name`` is that of the model. ``data`` and ``inputs`` are for an FMU: values with units, and
    the quantities that other models drive; all others are parameters. ``starts`` are for languages
    that continue branches.
    """
    model = pages.read(page, name)
    is_packed = targets.packer(written_in) is not None
    motion_material = None
    if targets.moves(written_in):
        motion_material = replace(_motion(model, data, inputs), starts=starts)
    beside = (motion.outputs(model.mechanics),) if is_packed else ()
    page_material = material(model, written_in, beside=beside)
    return targets.render(written_in, replace(page_material, motion=motion_material))


def for_the_browser(model: pages.PageModel, header: str) -> str:
    """The functions of a page that the explorer calls, as an ES module; with the places of its
    drawing, unless it is a mass on a belt.
    """
    # The functions that ``explorer/src`` calls.
    explored = {
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
        "places",
        "regime_rhs",
        "spring_forces",
        "turning_borders",
        "turnings",
    }
    it = model.mechanics
    explored |= {
        mechanics.named(f"contact_{part}", one) for one in it.contacts for part in ("force", "gap")
    }
    explored |= {mechanics.named("friction_at_rest", one) for one in it.frictions}
    drawn = () if drawing.is_drawn(model.page) else (scene.Scene(it).module(),)
    page_material = material(model, "javascript", header, explored, drawn)
    return targets.render("javascript", page_material)[f"{page_material.library}.mjs"]


def material(
    model: pages.PageModel,
    written_in: str,
    header: str | None = None,
    only: Collection[str] | None = None,
    beside: tuple[Module, ...] = (),
) -> targets.Material:
    """The material of a page that a target prints: all functions with a result, or those named in
    ``only``, and those of the modules ``beside``.

    For Python, names are those of the page, and functions compute the directions of springs
    themselves, so that they can be differentiated.
    """
    it, in_python = model.mechanics, targets.in_python(written_in)
    named: Callable[[object], str] = str if in_python else spelled
    prefix = library(model.name, targets.reserved(written_in))

    def given(function: Function) -> Function:
        return _following(it, function) if in_python else renamed(function, spelled)

    modules = tuple(
        tuple(
            read
            for function in module.functions
            if only is None or function.name in only
            if (read := definitions.definition(algebra.definition(given(function)))).leaves
        )
        for module in (*folder.modules(it), *beside)
    )
    meanings = dict(folder.meanings(it)) | {
        datum.becomes: f"{datum.meaning}, radians" for datum in it.parameters if datum.unit == "rad"
    }
    quantities = {
        datum.becomes: Quantity("", meanings[datum.becomes], domain=datum.domain)
        for datum in it.parameters
    }
    return targets.Material(
        modules=modules,
        quantities=quantities
        | {named(name): Quantity("", meaning) for name, meaning in meanings.items()},
        parameters=tuple(datum.becomes for datum in it.parameters),
        base_values={
            datum.becomes: datum.base for datum in it.parameters if datum.base is not None
        },
        public=tuple(function.name for module in modules for function in module),
        digest=model.digest,
        header=header
        or f"Generated by ``spragsym export`` from {model.name}.py with SymPy {sp.__version__}. "
        "Do not edit.",
        library=prefix,
        summary=model.page.summary,
        runtime={written_in: _examples(model, written_in, prefix)},
        angles={named(angle.symbol): tuple(map(named, angle.parts)) for angle in it.angles},
        of_a_page=True,
    )


def _motion(
    model: pages.PageModel, data: Data | None, inputs: Collection[str]
) -> targets.MotionMaterial:
    """The variables of a motion for an FMU: in the units of the data, else in SI; dimensionless
    without data.
    """
    it, page = model.mechanics, model.page
    measures = page.units if data is not None else []
    kinds = tuple(units.read(measure.unit) for measure in measures)
    sizes = [math.prod((data or {})[str(measure.symbol)][::2]) for measure in measures]

    def variable(
        name: str, meaning: str, unit: str, order: int = 0, quantity: str = ""
    ) -> targets.Variable:
        """A variable: the time derivative of an order of a quantity with a unit."""
        radians = Fraction(unit == "rad")
        dimension = units.times(units.read(unit), units.read("s"), -order)
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
        start = data[name][0] if data and name in data else _base(datum) * one.nominal
        ends = interval(datum.domain)
        return replace(
            one,
            start=start,
            allowed=replace(ends, low=ends.low * one.nominal, high=ends.high * one.nominal),
            input="" if one.name not in inputs else "discrete" if jumps(datum) else "continuous",
        )

    def jumps(datum: Datum) -> bool:
        """Whether a change of the quantity may end a mode: a border depends on it, or it is a unit
        of measure, on which all numbers depend.
        """
        return datum in page.units or bool({*it.parts(number(datum))} & bordering)

    equations = motion.Motion(it)
    bordering = sp.Tuple(*equations.borders).free_symbols
    time, places = variable("time", "time", "s" if data is not None else "1"), page.coordinates
    quantities = tuple(map(given, (*it.parameters, *measures)))
    available = [one.name for one in quantities]
    if unknown := sorted(set(inputs) - set(available)):
        raise UnknownInput(
            f"{', '.join(unknown)} is no quantity of {model.name}; give {', '.join(available)}"
        )
    with_sticking = [equations.slip(friction) for friction in equations.with_sticking]
    states = (
        *(
            variable(str(coordinate.symbol), coordinate.meaning, coordinate.unit)
            for coordinate in places
        ),
        *(
            replace(
                variable(str(coordinate.rate), f"rate of {coordinate.symbol}", coordinate.unit, 1),
                reset=any(level.has(rate) for level in with_sticking),
            )
            for coordinate, rate in zip(places, it.rates, strict=True)
        ),
    )
    outputs = [variable(name, *_output(name)) for name in equations.outputs]
    # The page's names first: what follows from it, and what an FMU has itself, gives way.
    every = [*quantities, *states, time, *outputs]
    distinct = iter(
        replace(one, name=name)
        for one, name in zip(every, apart(one.name for one in every), strict=True)
    )
    return targets.MotionMaterial(
        given=tuple(itertools.islice(distinct, len(quantities))),
        states=tuple(itertools.islice(distinct, len(states))),
        time=next(distinct),
        outputs=tuple(distinct),
        accelerations=tuple(
            variable("", f"acceleration of {coordinate.symbol}", coordinate.unit, 2)
            for coordinate in places
        ),
        step=float(f"{0.1 * time.nominal:.0e}"),
        borders=_edges(it),
        turnings=len(it.torsions),
        rooted=tuple(not contact.polynomial for contact in it.contacts),
        of_place=tuple(len(it.contacts) > 1 and contact.unilateral for contact in it.contacts),
        rubbing=tuple(it.contacts.index(friction.normal) for friction in it.frictions),
    )


def _output(name: str) -> tuple[str, str, int]:
    """Meaning, unit in SI and order of the derivative of an output, which may end in the name of a
    contact.
    """
    outputs = {
        "force.normal": ("normal force of the contact", "N", 0),
        "force.friction": ("force of friction, positive in the belt's direction", "N", 0),
        "energy": ("kinetic and stored energy, contact and applied forces included", "J", 0),
        "power": (
            "rate at which friction, dampers and forces without a potential change the energy",
            "J",
            1,
        ),
    }
    spring = "tension of a spring, negative where it pushes", "N", 0
    kind, what, *contact = name.split(".") if "." in name else (name, "")
    meaning, unit, order = outputs.get(f"{kind}.{what}" if what else kind, spring)
    return ", ".join((meaning, *contact)), unit, order


def _edges(it: Mechanics) -> tuple[targets.Edge, ...]:
    """The borders of all contacts, then of all frictions."""
    found = list[targets.Edge]()
    for index, contact in enumerate(it.contacts):
        kinds = ["gap"] * contact.unilateral + ["face"] * contact.either_face
        found += [targets.Edge(kind, index, contact.name) for kind in kinds]
    holding = motion.Motion(it).with_sticking
    for index, friction in enumerate(it.frictions, len(it.contacts)):
        row = holding.index(friction) if friction in holding else -1
        kinds = ["slip"] * (friction.along != 0) + ["ahead", "behind"] * (row >= 0)
        found += [targets.Edge(kind, index, friction.normal.name, row) for kind in kinds]
    return tuple(found)


def _following(it: Mechanics, function: Function) -> Function:
    """A function that computes the directions and torsion angles of springs from coordinates."""
    directions = motion.directions(it)
    arguments = tuple(symbol for symbol in function.arguments if symbol not in directions)
    return replace(function, arguments=arguments, shorthands={**directions, **function.shorthands})


def _base(datum: Datum) -> float:
    """The base value of a parameter; without one π/4 for an angle and 1 for any other."""
    if datum.base is not None:
        return datum.base
    return math.pi / 4 if datum.unit == "rad" else 1.0


#: For each language the file of its example, the prefix of functions, and formats of a text, a
#: choice by a border, a border, and joined texts.
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


def _examples(model: pages.PageModel, written_in: str, prefix: str) -> dict[str, str]:
    """The file of an example, if the language has one: a motion at the base values."""
    if written_in not in _EXAMPLES:
        return {}
    it = model.mechanics
    count = len(it.coordinates)
    values = {number(datum): repr(_base(datum)) for datum in it.parameters}
    shown = [*map(str, (*it.coordinates, *it.rates))]
    # At rest, except that the clock, the last coordinate, has its rate.
    start = [*[0.0] * (2 * count - 1), float(it.speed.subs(values))]
    common = {
        "count": str(count),
        "borders": str(len(it.contacts) + len(it.frictions)),
        "library": prefix,
        "LIBRARY": prefix.upper(),
        "values": ", ".join(values.values()) or "0.0",
        "names": ", ".join(map(str, values)) or "none",
        "state": ", ".join(f"state[{index}]" for index in range(2 * count)),
        "given": ", ".join(f"p[{index}]" for index in range(len(values))),
        "start": ", ".join(map(repr, start)),
        "shown": "  ".join(f"{name} %+.9f" for name in shown),
        "texts": " ".join("%s" for _ in it.contacts),
    }

    name, of, text, choice, border, joined = _EXAMPLES[written_in]

    def chosen(touches: Callable[[NormalForce], str], lifted: str) -> str:
        """A text for each contact, by its border if it can open."""
        return ", ".join(
            choice.format(border.format(index), touches(one), lifted)
            if one.unilateral
            else touches(one)
            for index, one in enumerate(it.contacts)
        )

    taken = dict(values)
    for angle in it.angles:
        value = values[angle.symbol]
        taken |= {angle.c: f"{of}cos({value})", angle.s: f"{of}sin({value})"}
    words = common | {
        "arguments": ", ".join(taken[part] for part in it.arguments),
        "shown_names": ", ".join(map(text.format, shown)),
        "pushing": chosen(lambda _: "1.0", "0.0"),
        "touching": joined.format(
            chosen(
                lambda one: text.format((one.name or "contact") if one.unilateral else one.name),
                text.format("lift-off"),
            )
        ),
    }
    if written_in == "matlab":
        words["library"] += "_"
    template = name.replace(".py", ".txt")  # which is no Python until it is filled in
    whole = targets.spoken(targets.runtime(__file__, f"{written_in}/{template}"), words)
    if written_in == "c":
        return {name: "\n".join(map(broken, whole.split("\n")))}
    return {f"example_{prefix}.{name.partition('.')[2]}": whole}
