"""A loaded model: names, parameters, generated functions, and what ``model.json`` says of
its page.
"""

from __future__ import annotations

import itertools
import math
import textwrap
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache, cached_property
from importlib import import_module
from inspect import Parameter, Signature
from types import ModuleType
from typing import Any, TypeAlias

import numpy as np

from ..core.errors import ModelError, ParameterError
from ..core.questions import FORCED
from ..display import Column, aligned
from ..numerics.vectors import WholeTurns
from . import forces
from .field import FELT_EXPONENT, Field, field_of
from .parameters import ANGLE, FINITE, FloatArray, ParameterSet, Range, as_numbers

#: Combination of touching contacts: True for all, False for none that can open, or the names of
#: those that can open and touch.
Touching: TypeAlias = bool | tuple[str, ...]


#: The second face of a contact that presses on either of two, where N is negative.
OPPOSITE = "opposite face"


def label_of(contact: Mapping[str, Any]) -> str:
    """The name of a contact; ``"face"`` if it has none."""
    return contact["name"] or "face"


class Model:
    """A loaded model: its names, parameters, generated functions and closed forms.

    Attributes
    ----------
    name : str
        Its name.
    where : str
        The argument of :func:`spragsym.load`: the name of a shipped model, or a folder.
    about : mapping
        The content of ``model.json``: coordinates, parameters, laws and springs of the page.
    algebra : module
        Generated functions of the balance of forces, the linearization and the motion.
    search : Model
        The same model without closed forms.
    Parameters : type
        The class of its sets of parameters: ``model.Parameters(**changes_of_base)``.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> model = ss.load("cubic_contact")
    >>> eq = ss.equilibria(model.Parameters(theta0=np.radians([30.0, 60.0])))
    >>> eq.count.tolist(), eq.complete
    ([3, 1], True)
    >>> found = ss.folds(model.Parameters(), vary="theta0", between={"theta0": (0.5, 1.5)})
    >>> np.degrees(found.theta0).round(2).tolist(), found.complete
    ([44.59], True)
    """

    def __init__(
        self,
        where: str,
        about: Mapping[str, Any],
        module: Callable[[], ModuleType],
        parameters: type[ParameterSet],
        closed: Mapping[str, str] | None = None,
    ) -> None:
        self.name: str = about["name"]
        self.where = where
        self.about = about
        self.Parameters = parameters
        self.closed = closed or {}
        self._module = module
        #: The model with its closed forms.
        self.whole: Model = self

    @cached_property
    def algebra(self) -> ModuleType:
        """Generated functions of the balance of forces, the linearization and the motion."""
        return self._module()

    @cached_property
    def search(self) -> Model:
        """The model without its closed forms: general algorithms answer every question, as with
        ``method="search"``.
        """
        if not self.closed:
            return self
        own: Any = type(self.Parameters.__name__, (self.Parameters,), {})
        other: Model = Model(self.where, self.about, self._module, own)
        own._model, other.whole = other, self
        return other

    def closed_form(self, name: str) -> Callable[..., Any] | None:
        """The function that answers a question in closed form, or None."""
        return _imported(self.closed[name], name) if name in self.closed else None

    @cached_property
    def field(self) -> Field:
        """The vector field of the motion; friction exponentials far below rounding are left out."""
        return field_of(self, FELT_EXPONENT)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the coordinates."""
        return _names(self.about["coordinates"])

    def column(self, name: str) -> Column:
        """The column of a quantity of the model; a plain number for any other name."""
        return self.columns.get(name) or Column(name)

    def is_angle(self, name: str) -> bool:
        """Whether a parameter, a component of a state, or the direction of a spring is an angle."""
        return self.column(name).is_angle

    def any_of(self, name: str) -> Range:
        """The range of all finite numbers, in the unit of a parameter or of a component of
        a state.
        """
        return ANGLE if self.is_angle(name) else FINITE

    @property
    def rates(self) -> tuple[str, ...]:
        """Names of the rates of the coordinates."""
        return tuple(entry["rate"] for entry in self.about["coordinates"])

    @property
    def components(self) -> tuple[str, ...]:
        """Names of the numbers in a state: the coordinates, then their rates."""
        return (*self.coordinates, *self.rates)

    @property
    def starting(self) -> tuple[str, ...]:
        """Names of the components that a motion may start with: all but the rate of a clock, which
        is given.
        """
        return self.components[: -1 if self.clock else None]

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the parameters, in order."""
        return _names(self.about["parameters"])

    @property
    def contacts(self) -> Sequence[Mapping[str, Any]]:
        """The contacts as the page describes them; a single one without name and gap stands for
        none.
        """
        return self.about["contacts"]

    @property
    def frictions(self) -> Sequence[Mapping[str, Any]]:
        """The frictions as the page describes them, each with the name of its contact."""
        return self.about["frictions"]

    @property
    def rubbing(self) -> tuple[str, ...]:
        """Names of the contacts with friction.

        A model without friction has that of its first contact, with the friction 0.
        """
        return _names(self.frictions or self.contacts[:1])

    @cached_property
    def clock(self) -> str:
        """The coordinate, the last, that is the phase of a clock; empty if the page has none."""
        return self.coordinates[-1] if hasattr(self.algebra, "clock") else ""

    @cached_property
    def whole_turns(self) -> WholeTurns:
        """Whole turns of angles under which the model is invariant, by the index of the angle.

        Each is the number of turns of every coordinate, by index, that go with one turn of the
        angle.
        """
        found = WholeTurns()
        for index, entry in enumerate(self.about["coordinates"]):
            turns = entry.get("comes_around")
            if turns:
                others = {} if turns is True else turns
                counts = {self.coordinates.index(name): count for name, count in others.items()}
                found[index] = {index: 1, **counts}
        return found

    def require_answered(self, question: str) -> None:
        """Raise ModelError for a question that is not answered for the model, with the reason."""
        if why := self.refusal(question):
            raise ModelError(f"{question} is not answered yet of {self.name}, {why}")

    def refusal(self, question: str) -> str:
        """The reason why a question is not answered for a page with a clock, and what to ask; else
        empty.
        """
        if self.clock and question not in FORCED:
            return (
                f"whose page has a clock ({self.clock}): nothing rests there; ask "
                f"{', '.join(FORCED)}, or hold the clock still with a parameter in its place"
            )
        return ""

    @cached_property
    def regimes(self) -> dict[Touching, str]:
        """The values that ``contact`` may have for equilibria, and the name of each.

        True means that all contacts touch, False that none touches of those that can open, and
        names that just these touch of those that can open. A contact that presses on either of two
        faces, as in a slot, "touches" on its own face, where N ≥ 0.
        """
        if all(entry["gap"] is None and not entry["border"] for entry in self.contacts):
            return {True: "sliding" if self.frictions else "rest"}
        opening = [label_of(entry) for entry in self.contacts if entry["border"]]
        found: dict[Touching, str] = {True: "contact"}
        for count in reversed(range(1, len(opening))):
            for some in itertools.combinations(opening, count):
                found[some] = f"contact of {', '.join(some)} alone"
        apart = "lift-off" if any(entry["unilateral"] for entry in self.contacts) else OPPOSITE
        return found | ({False: apart} if opening else {})

    @property
    def lifts_off(self) -> bool:
        """Whether there may be states in which no contact touches; a contact that never opens does
        in all of them.
        """
        return False in self.regimes and all(entry["unilateral"] for entry in self.contacts)

    @property
    def has_regimes(self) -> bool:
        """Whether equilibria may have several combinations of touching contacts: with several
        contacts, or with one that presses on either of two faces.
        """
        return len(self.contacts) > 1 or forces.presses_either(self.contacts[0])

    @property
    def base(self) -> dict[str, float]:
        """Base values by name, without parameters that have none, as the article's θ₀."""
        return {
            entry["name"]: entry["base"]
            for entry in self.about["parameters"]
            if entry["base"] is not None
        }

    @property
    def coefficient(self) -> str | None:
        """The parameter that is the friction coefficient, the usual loading parameter, or None."""
        name: str | None = self.about["roles"]["friction"]
        return name

    @property
    def inclination(self) -> str | None:
        """The parameter that is the inclination of the mechanism, or None."""
        name: str | None = self.about["roles"]["inclination"]
        return name

    @property
    def axes(self) -> tuple[str, ...]:
        """Parameters that vary by default: inclination and friction coefficient, else the first
        parameter of the balance.
        """
        named = (name for name in (self.inclination, self.coefficient) if name is not None)
        return tuple(named) or self.plane[:1] or self.parameters[:1]

    @property
    def balanced(self) -> tuple[str, ...]:
        """Parameters on which the balance of forces depends; others matter to the motion alone."""
        return _names(entry for entry in self.about["parameters"] if entry["role"] == "both")

    @property
    def plane(self) -> tuple[str, ...]:
        """Two parameters for a picture by default: inclination and friction coefficient if the
        balance depends on them, then other parameters of the balance.
        """
        named = [name for name in (self.inclination, self.coefficient) if name in self.balanced]
        return tuple(dict.fromkeys([*named, *self.balanced]))[:2]

    @cached_property
    def columns(self) -> Mapping[str, Column]:
        """Columns of the model's own quantities by name.

        These are coordinates, rates, parameters, and directions, lengths and forces of springs and
        contacts. The column of time is ``t``.
        """
        found = [
            *forces.columns(self),
            *(
                Column(entry["name"], entry.get("quantity_unit", "1"), entry["meaning"])
                for entry in self.about["parameters"]
            ),
        ]
        for entry in self.about["coordinates"]:
            rate = "1/s" if entry["unit"] == "rad" else f"{entry['unit']}/s"
            found += [
                Column(entry["name"], entry["unit"], entry["meaning"]),
                Column(entry["rate"], rate, f"rate of {entry['name']}", rate_of=entry["name"]),
            ]
        return {column.name: column for column in found}

    @cached_property
    def places(self) -> tuple[str, ...]:
        """Names of columns that locate a state: direction and length of each inclined spring, and
        the coordinates.
        """
        return forces.columns_of(self)

    @cached_property
    def _units(self) -> Mapping[str, str]:
        scales, found = self.about["scales"], {"1": "1", "rad": "rad", "degree": "degree"}
        for entry in self.about["parameters"]:
            found.setdefault(entry.get("quantity_unit", "1"), entry.get("scale") or "1")
        for entry in self.about["coordinates"]:
            found.setdefault(entry["unit"], entry["scale"] or "1")
            found.setdefault(self.columns[entry["rate"]].dimension, entry["rate_scale"])
        scale = {"m": "length", "s": "time", "N": "force", "1/s": "rate"}
        return found | {unit: scales[name] for unit, name in scale.items()}

    def unit(self, dimension: str) -> str:
        """The model's own unit of a dimension, as ``k_c*L_0`` for ``"N"``; empty if it has none."""
        return self._units.get(dimension, "")

    def describe(self) -> str:
        """The drawing, the coordinates and the parameters, as text."""

        def meaning(entry: Mapping[str, Any]) -> str:
            own = entry.get("quantity", entry["name"])
            symbol = "" if own == entry["name"] else f" ({own}, dimensionless)"
            return entry["meaning"] + (", radians" if entry["unit"] == "rad" else symbol)

        about, roles = self.about, {"both": "statics and motion", "motion": "motion"}
        coordinates = [
            ("coordinate", "meaning"),
            *((entry["name"], meaning(entry)) for entry in about["coordinates"]),
        ]
        parameters = [("parameter", "base", "allowed", "of", "meaning")]
        for entry in about["parameters"]:
            base = "" if entry["base"] is None else f"{entry['base']:g}"
            parameters.append(
                (entry["name"], base, entry["domain"], roles[entry["role"]], meaning(entry))
            )
        tables = ("\n".join(aligned(rows)) for rows in (coordinates, parameters))
        units = ", ".join(
            f"{name} {about['scales'][name].replace('**', '^')}"
            for name in ("length", "time", "force")
        )
        return "\n\n".join(
            [
                f"{self.name}: {about['summary']}",
                about["drawing"].strip(),
                *tables,
                f"measured in: {units}",
            ]
        )

    def arguments(self, p: ParameterSet, kind: str = "statics") -> tuple[FloatArray, ...]:
        """The parameters as generated functions take them, with cosine and sine of angles, each of
        the common shape.

        ``kind`` is ``"statics"`` for functions of the balance of forces, ``"motion"`` for all
        others.
        """
        angles = {
            name: (angle, part)
            for angle, pair in self.about["angles"].items()
            for part, name in enumerate(pair)
        }
        values = []
        for name in self.about["arguments"][kind]:
            angle, part = angles.get(name, (name, None))
            (value,) = p.broadcast(angle)
            values.append(value if part is None else (np.cos, np.sin)[part](value))
        return tuple(values)

    def rising_over(
        self, vary: str | None, over: str | None, called: str = "vary"
    ) -> tuple[str, str]:
        """The loading parameter, and the parameter over whose range it is asked; defaults replace
        None.

        ``called`` is the name of the first argument, for messages.
        """
        if vary is None or over is None:
            first, second = self.two(None, f"{called} and over")
            vary, over = (
                vary or (second if over != second else first),
                over or (first if vary != first else second),
            )
        return vary, over

    def cases(self) -> tuple[tuple[str, ParameterSet], ...]:
        """Named sets of all parameters to begin with: the model's own, or its base values.

        Without a base value an angle is 30°, as in the article, and another parameter the middle of
        its range, or 1.
        """
        if own := self.closed_form("cases"):
            return own()

        def value(entry: Mapping[str, Any]) -> float:
            low, high = entry["low"], entry["high"]
            if entry["base"] is not None:
                return entry["base"]
            if entry["name"] in self.about["angles"]:
                return math.radians(30.0)
            return 1.0 if low is None or high is None else 0.5 * (low + high)

        values = {entry["name"]: value(entry) for entry in self.about["parameters"]}
        return (("Base values", self.Parameters(**values)),)

    def friction(
        self, p: ParameterSet, law: str = "friction_at_speed", contact: str | None = None
    ) -> FloatArray:
        """The friction coefficient of steady sliding, of the shape of ``p``; source: the law of the
        page.

        ``law`` is ``"friction_at_speed"``, at the speed of the belt, or ``"friction_at_rest"``,
        which statics takes. ``contact`` names one of several contacts. Angles that the law does not
        depend on may be missing.
        """
        if law not in ("friction_at_speed", "friction_at_rest") or not self.frictions:
            raise ParameterError(
                f"law = {law!r} of {self.name}: give friction_at_speed or friction_at_rest, "
                "where there is friction"
            )
        friction = self.frictions[forces.contact_named(self, contact, self.rubbing)]
        of_law = friction["quantities"]
        missing = {
            name: 1.0 for name in self.about["angles"] if name not in of_law and p[name] is None
        }
        coefficient = getattr(self.algebra, forces.named(law, friction["name"]))
        return np.asarray(coefficient(*self.arguments(p.replace(**missing), "motion")), dtype=float)

    def one(self, vary: str | None) -> str:
        """The parameter that varies, by default the first of :attr:`axes`."""
        if not self.parameters:
            raise ParameterError(f"{self.name} has no parameters, so that nothing can vary")
        return self.axes[0] if vary is None else vary

    def rising(self, vary: str | None, begin: float | FloatArray | None) -> tuple[str, Any]:
        """The loading parameter, by default the friction coefficient, and the value from which it
        rises.
        """
        name = vary or self.coefficient
        if name is None:
            raise ParameterError(
                f"{self.name} has no friction that rises; give vary, the parameter that does, one "
                f"of {', '.join(self.parameters)}"
            )
        self.require_parameter(name)
        allowed = self.Parameters.ranges[name]
        if begin is None and not allowed.contains(allowed.low):
            raise ParameterError(
                f"{name} has no least value in {allowed}; give begin, from where it rises"
            )
        if begin is None:
            return name, allowed.low
        given = as_numbers("begin", begin, self.any_of(name))
        return name, given if given.ndim else given.item()

    def require_parameter(self, name: str) -> None:
        """Raise ParameterError unless the name is that of a parameter."""
        if name not in self.parameters:
            raise ParameterError(
                f"vary = {name!r} is not a parameter of {self.name}; choose one of "
                f"{', '.join(self.parameters)}"
            )

    def two(self, vary: Sequence[str] | None, called: str = "vary") -> Sequence[str]:
        """The two parameters that vary: inclination and friction coefficient if ``vary`` is
        None.
        """
        if vary is None and len(self.axes) < 2:
            raise ParameterError(
                f"{self.name} has not both an inclination and a friction; give {called}, two of "
                f"{', '.join(self.parameters)}"
            )
        if vary is None:
            return self.axes
        if (
            isinstance(vary, str)
            or not isinstance(vary, Sequence)
            or len(vary) != 2
            or vary[0] == vary[1]
        ):
            raise ParameterError(f"vary = {vary!r}; give two different parameters")
        for name in vary:
            self.require_parameter(name)
        return vary

    def __repr__(self) -> str:
        return f"load({self.where!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        from .load import load

        return (load, (self.where,)) if self.whole is self else (getattr, (self.whole, "search"))


def parameter_class(about: Mapping[str, Any], where: str) -> type[ParameterSet]:
    """The class of a model's sets of parameters, with their base values.

    ``where`` is the argument of :func:`spragsym.load` for the model. By it another process finds
    the class again.
    """
    names = _names(about["parameters"])
    base = {one["name"]: one["base"] for one in about["parameters"]}
    arguments = [
        Parameter(name, Parameter.POSITIONAL_OR_KEYWORD, default=base[name]) for name in names
    ]
    made = type(
        "Parameters",
        (ParameterSet,),
        {
            "__doc__": _documentation(about),
            "__signature__": Signature(arguments),
            "ranges": {entry["name"]: _range(about, entry) for entry in about["parameters"]},
            "spanned": frozenset(names),
            "origin": "model.Parameters(...)",
            "where": where,
            "base": base,
        },
    )
    return made


@cache
def _imported(module: str, name: str) -> Callable[..., Any]:
    """A function of a module; cached, since the import takes a tenth of the time of one point's
    equilibria.
    """
    return getattr(import_module(module, "spragsym"), name)


def _names(entries: Iterable[Mapping[str, Any]]) -> tuple[str, ...]:
    return tuple(entry["name"] for entry in entries)


def _range(about: Mapping[str, Any], entry: Mapping[str, Any]) -> Range:
    """The allowed range of a parameter, with advice for a value outside of it."""
    low, high = (
        default if entry[end] is None else entry[end]
        for end, default in (("low", -math.inf), ("high", math.inf))
    )
    belts = [one["belt"] for one in about["frictions"]]
    if entry["unit"] == "rad":
        remedy = "angles are radians; use numpy.radians for degrees"
    elif entry["name"] in (about["roles"]["friction"], *belts):
        remedy = "a belt that runs the other way is the mirror image of the mechanism"
    else:
        remedy = f"it is the {entry['meaning']}"
    return Range(
        low,
        high,
        entry["low_open"] and not math.isinf(low),
        remedy,
        not entry["high_open"],
        "rad" if entry["unit"] == "rad" else "1",
    )


def _documentation(about: Mapping[str, Any]) -> str:
    """The docstring of a class of parameters."""
    lines = [
        f"Parameters of the model {about['name']}, scalars or arrays that broadcast together.",
        "",
        "Parameters",
        "----------",
    ]
    for entry in about["parameters"]:
        default = "" if entry["base"] is None else f", default {entry['base']:g}"
        unit = ", radians" if entry["unit"] == "rad" else ""
        lines += [
            f"{entry['name']} : array_like{default}",
            f"    {entry['meaning']}{unit}; allowed: {entry['domain']}",
        ]
    return "\n".join(lines)


def title_drawing_words(about: Mapping[str, Any]) -> tuple[str, str, list[str]]:
    """Title of a page, its drawing in characters, and the paragraphs below; displayed formulas are
    indented.
    """
    title, _, rest = about["drawing"].partition("\n\n::\n\n")
    drawn, *blocks = rest.split("\n\n")
    # A drawing may contain blank lines.
    while drawn.startswith(" ") and blocks and blocks[0].startswith("    "):
        drawn += "\n\n" + blocks.pop(0)
    return title, textwrap.dedent(drawn).strip("\n"), blocks
