"""A loaded model: its names, parameters and generated functions."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from functools import cache, cached_property
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import ParameterError
from . import parameter_class as _parameters
from .describe import described, explained
from .parameters import FloatArray, ParameterSet

if TYPE_CHECKING:
    from .field import Field


class Model:
    """A loaded model: its names, parameters, generated functions and closed forms.

    Attributes
    ----------
    name : str
        Its name.
    where : str
        What :func:`spragsym.load` takes for it: the name of a shipped model, or a folder.
    about : mapping
        ``model.json``: coordinates, parameters, laws, springs, as the page says them.
    algebra : module
        Generated functions: the balance of forces, small deviations from it, the motion.
    search : Model
        The same without closed forms.
    Parameters : type
        The class of its parameters: ``model.Parameters(**changes_of_base)``.

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
        self, where: str, about: Mapping[str, Any], module: Callable[[], ModuleType], parameters: Any,
        closed: Mapping[str, str] | None = None,
    ) -> None:  # fmt: skip
        self.name: str = about["name"]
        self.where, self.about, self.Parameters, self.closed = where, about, parameters, closed or {}
        self._module = module
        #: The model with its closed forms.
        self.whole: Model = self

    @cached_property
    def algebra(self) -> Any:
        """Generated functions: the balance of forces, small deviations from it, the motion."""
        return self._module()

    @cached_property
    def search(self) -> Model:
        """The model without its closed forms: every question by the general algorithm, as with ``method="search"``."""
        if not self.closed:
            return self
        own: Any = type(self.Parameters.__name__, (self.Parameters,), {"searched": True})
        other: Model = Model(self.where, self.about, self._module, own)
        own._model, other.whole = other, self
        return other

    def closed_form(self, name: str) -> Callable[..., Any] | None:
        """The closed form of a question, if the model brings one."""
        return _found(self.closed[name], name) if name in self.closed else None

    @cached_property
    def field(self) -> Field:
        """The field of its motion, with exponentials of the friction law left out far below rounding."""
        from .field import REACH
        from .model_field import field_of

        return field_of(self, REACH)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the coordinates."""
        return tuple(entry["name"] for entry in self.about["coordinates"])

    def is_angle(self, name: str) -> bool:
        """Whether a parameter, a coordinate, the direction of a spring, or what is told of them after a jump, is an angle."""
        name = re.sub(r"^(rest|mean|cycle)_|_(before|after)$", "", name)
        turning = {entry["name"] for entry in self.about["coordinates"] if entry["unit"] == "rad"}
        if name in (*self.parameters, *self.coordinates):
            return name in self.about["angles"] or name in turning
        return name.partition("_")[0] == "theta"

    @property
    def rates(self) -> tuple[str, ...]:
        """Names of their rates."""
        return tuple(entry["rate"] for entry in self.about["coordinates"])

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the parameters, in order."""
        return tuple(entry["name"] for entry in self.about["parameters"])

    @property
    def regimes(self) -> dict[bool, str]:
        """What ``contact`` may be for equilibria, and what each is called."""
        contact, friction = self.about["contact"], self.about["friction"]
        if contact["gap"] is None:
            return {True: "sliding" if friction else "rest"}
        return {True: "contact", False: "lift-off"} if contact["unilateral"] else {True: "contact"}

    @property
    def base(self) -> dict[str, float]:
        """Base values; a parameter without one, as the article's θ₀, is not among them."""
        return _parameters.base(self.about)

    @property
    def axes(self) -> tuple[str, ...]:
        """What varies unless told otherwise: θ₀ and μ₀ where the model has them, else its first parameter of the balance."""
        return tuple(name for name in self.plane if name in ("theta0", "mu0")) or self.plane[:1] or self.parameters[:1]

    @property
    def plane(self) -> tuple[str, ...]:
        """Two parameters for a picture whose reader may choose others: the same, then what else of the balance stands first."""
        balanced = [entry["name"] for entry in self.about["parameters"] if entry["role"] == "both"]
        known = [name for name in ("theta0", "mu0") if name in self.parameters]
        return tuple(dict.fromkeys([*known, *balanced]))[:2]

    @cached_property
    def quantities(self) -> Mapping[str, tuple[str, str]]:
        """Unit and meaning of everything that files of motions hold, by its name."""
        return explained(self.about)

    def describe(self) -> str:
        """The drawing, the coordinates and the parameters, as text."""
        return described(self.about)

    def arguments(self, p: ParameterSet, kind: str = "statics") -> tuple[FloatArray, ...]:
        """The parameters as generated functions take them, angles as cosine and sine, each with the common shape.

        ``kind`` is ``"statics"`` for functions of the balance of forces, ``"motion"`` for all others.
        """
        angles = {name: (angle, part) for angle, pair in self.about["angles"].items() for part, name in enumerate(pair)}
        values = []
        for name in self.about["arguments"][kind]:
            angle, part = angles.get(name, (name, None))
            (value,) = p.broadcast(angle)
            values.append(value if part is None else (np.cos, np.sin)[part](value))
        return tuple(values)

    def rising_over(self, vary: str | None, over: str | None, called: str = "vary") -> tuple[str, str]:
        """The loading parameter, and over the range of what; ``called`` is the argument that says the first."""
        if vary is None or over is None:
            if len(self.axes) < 2:
                text = f"{self.name} has not both theta0 and mu0; give {called} and over, two of {', '.join(self.parameters)}"
                raise ParameterError(text)
            first, second = self.two(None)
            vary, over = vary or (second if over != second else first), over or (first if vary != first else second)
        return vary, over

    def cases(self) -> tuple[tuple[str, ParameterSet], ...]:
        """Named points of all parameters, to begin at: those that the model brings, or the base values."""
        own = self.closed_form("cases")
        return own() if own else _parameters.base_case(self.about, self.Parameters)

    def friction(self, p: ParameterSet, law: str = "friction_at_speed") -> FloatArray:
        """The friction coefficient of steady sliding at the speed of the belt, or ``"friction_at_rest"``, which statics takes.

        Of the shape of ``p``, of which angles that the law does not depend on may be missing; source: the law of the page.
        """
        if law not in ("friction_at_speed", "friction_at_rest") or not self.about["friction"]:
            raise ParameterError(
                f"law = {law!r} of {self.name}: give friction_at_speed or friction_at_rest, where there is friction"
            )
        of_law = self.about["friction"]["quantities"]
        missing = {name: 1.0 for name in self.about["angles"] if name not in of_law and getattr(p, name) is None}
        return np.asarray(getattr(self.algebra, law)(*self.arguments(p.replace(**missing), "motion")), dtype=float)

    def one(self, vary: str | None) -> str:
        if not self.parameters:
            raise ParameterError(f"{self.name} has no parameters, so that nothing can vary")
        return self.axes[0] if vary is None else vary

    def rising(self, vary: str | None, begin: float | FloatArray | None) -> tuple[str, Any]:
        """The loading parameter unless told otherwise, the friction at full slip, and from where."""
        if vary is None and "mu0" not in self.parameters:
            raise ParameterError(
                f"{self.name} has no mu0; give vary, the parameter that rises, one of {', '.join(self.parameters)}"
            )
        name = vary or "mu0"
        self.require_parameter(name)
        allowed = self.Parameters.ranges[name]
        if begin is None and not allowed.contains(allowed.low):
            raise ParameterError(f"{name} has no least value in {allowed}; give begin, from where it rises")
        return name, allowed.low if begin is None else begin

    def require_parameter(self, name: str) -> None:
        """An error unless what varies is a parameter of the model."""
        if name not in self.parameters:
            raise ParameterError(f"vary = {name!r} is not a parameter of {self.name}; choose one of {', '.join(self.parameters)}")

    def two(self, vary: Sequence[str] | None) -> Sequence[str]:
        """The two parameters that vary: theta0 and mu0 unless told otherwise."""
        if vary is None and len(self.axes) < 2:
            raise ParameterError(f"{self.name} has not both theta0 and mu0; give vary, two of {', '.join(self.parameters)}")
        if vary is None:
            return self.axes
        if isinstance(vary, str) or not isinstance(vary, Sequence) or len(vary) != 2 or vary[0] == vary[1]:
            raise ParameterError(f"vary = {vary!r}; give two different parameters")
        for name in vary:
            self.require_parameter(name)
        return vary

    def __repr__(self) -> str:
        return f"load({self.where!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        from .load import load

        return (load, (self.where,)) if self.closed or load(self.where) is self else (_searching, (self.where,))


@cache
def _found(room: str, name: str) -> Callable[..., Any]:
    return getattr(import_module(room, "spragsym"), name)


def _searching(where: str) -> Model:
    from .load import load

    return load(where).search
