"""A loaded model: its names, parameters and generated functions."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from functools import cached_property
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..door import closed_form, part, question
from ..errors import ModelError, ParameterError
from ..parameters import FloatArray, ParameterSet
from . import parameters as _parameters
from .describe import described, explained

if TYPE_CHECKING:
    from ..cycles import Cycle
    from ..dynamics.field import Field
    from ..dynamics.motions import Motions
    from ..dynamics.problem import Problem
    from ..dynamics.solution import Solution
    from ..exact.intervals import Arithmetic
    from ..results.equilibria import Equilibria
    from ..results.points import Ended, Points
    from ..results.precise_states import CuspProof, PreciseEquilibria
    from ..sweeps.measure import Settings
    from .catastrophe.normal_forms import NormalForm
    from .statics.stability import Linearized


class Model:
    """A model from a page.

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
        closed: Mapping[str, tuple[str, Collection[Any]]] | None = None,
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
        """The same model without its closed forms: every question by the general way, as with ``method="search"``."""
        if not self.closed:
            return self
        own: Any = type(self.Parameters.__name__, (self.Parameters,), {"searched": True})
        other: Model = Model(self.where, self.about, self._module, own)
        own._model, other.whole = other, self
        return other

    def closed_form(self, name: str) -> Callable[..., Any] | None:
        """The closed form of a question, if the model brings one."""
        return closed_form(self.closed[name][0], name) if name in self.closed else None

    @cached_property
    def field(self) -> Field:
        """The field of its motion, with exponentials of the friction law left out far below rounding."""
        from ..dynamics.field import REACH
        from .field import field_of

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

    @property
    def backends(self) -> tuple[str, ...]:
        """Integrators that take its motion: what is compiled on installation is that of a model that brings its own."""
        from ..dynamics.integrators import BACKENDS, OF_ANY_MODEL

        return BACKENDS if "integrate" in self.closed else OF_ANY_MODEL

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
        """What rises, and over the range of what; ``called`` is the argument that says the first."""
        if vary is None or over is None:
            if len(self.axes) < 2:
                text = f"{self.name} has not both theta0 and mu0; give {called} and over, two of {', '.join(self.parameters)}"
                raise ParameterError(text)
            first, second = self.two(None)
            vary, over = vary or (second if over != second else first), over or (first if vary != first else second)
        return vary, over

    def prepare(self, p: ParameterSet, **options: Any) -> Problem:
        """A motion as a problem for an integrator."""
        from .problems import prepare

        return prepare(self, p, **options)

    def motions(self, settings: Settings, points: Sequence[tuple[float, ...]]) -> tuple[Motions | None, dict[int, Exception]]:
        """The motions of points of a sweep, parameters and initial state each, and why points have none."""
        from .problems import motions

        return motions(self, settings, points)

    @part
    def cases(self) -> tuple[tuple[str, ParameterSet], ...]:
        """Named points of all parameters, to begin at: the base values, or what a model brings."""
        from .cases import cases

        return cases(self)

    @part
    def integrate(self, problem: Problem) -> Solution:
        """A motion by code that was compiled on installation."""
        raise ModelError(f"{self.name} has no compiled motion; give backend='heyoka' or 'scipy'")

    @part
    def aloft(self, constants: FloatArray, states: FloatArray) -> NDArray[np.bool_]:
        """For each of many motions, constants and states in rows, whether it stays above the belt for good from its state."""
        from ..dynamics.field import never

        return never(constants, states)

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

    @question
    def precise_equilibria(
        self, exact: Mapping[str, Any], contact: bool, digits: int, arith: Arithmetic | None
    ) -> PreciseEquilibria:  # fmt: skip
        """Equilibria to a number of digits, from exact parameters by name: see :func:`spragsym.precise.equilibria`."""
        from .digits import precise_equilibria

        return precise_equilibria(self, exact, contact, digits, arith)

    @question
    def precise_cusps(
        self, exact: Mapping[str, Any], vary: Sequence[str], digits: int, arith: Arithmetic | None, **options: Any
    ) -> CuspProof:  # fmt: skip
        """Cusps to a number of digits, from exact parameters by name: see :func:`spragsym.precise.cusps`."""
        from .digits import precise_cusps

        return precise_cusps(self, exact, vary, digits, arith, **options)

    def normal_form(self, given: FloatArray, state: FloatArray, vary: str, radii: FloatArray) -> NormalForm:
        """Of a Hopf point among :class:`~spragsym.Onsets`: see :func:`spragsym.models.catastrophe.normal_forms.normal_form`."""
        from .catastrophe.normal_forms import normal_form

        return normal_form(self, given, state, vary, radii)

    def born(
        self, given: FloatArray, state: FloatArray, vary: str, form: NormalForm, amplitude: float | None, backend: str | None
    ) -> Cycle:
        """The cycle that is born at one of them: see :func:`spragsym.models.catastrophe.births.born`."""
        from .catastrophe.births import born

        return born(self, given, state, vary, form, amplitude, backend)

    def ended(self, points: Points) -> Ended:
        """What happens at :class:`~spragsym.Points`: see :func:`spragsym.models.catastrophe.fold_outcomes.ended`."""
        from .catastrophe.fold_outcomes import ended

        return ended(points)

    def columns(self, eq: Equilibria) -> dict[str, FloatArray]:
        """What follows from where equilibria are: directions, lengths and tensions of inclined springs, the contact's force."""
        from ..dynamics.forces import told_of
        from .statics.stability import springs

        q = [getattr(eq, name) for name in self.coordinates]
        given = [value[..., None] for value in self.arguments(eq.parameters, "motion")]
        with np.errstate(all="ignore"):  # beyond ``count`` there are no numbers
            forces = {name: np.where(np.isnan(q[0]), np.nan, force(q, given)) for name, force in told_of(self).items()}
        return {**springs(eq), **forces}

    def linearized(
        self, eq: Equilibria, states: tuple[NDArray[np.int64], ...], around: tuple[FloatArray, FloatArray] | None
    ) -> Linearized:
        """What grows at equilibria: see :func:`spragsym.models.statics.stability.linearized`."""
        from .statics.stability import linearized

        return linearized(eq, states, around)

    def one(self, vary: str | None) -> str:
        if not self.parameters:
            raise ParameterError(f"{self.name} has no parameters, so that nothing can vary")
        return self.axes[0] if vary is None else vary

    def rising(self, vary: str | None, begin: float | FloatArray | None) -> tuple[str, Any]:
        """What rises unless told otherwise, the friction at full slip, and from where."""
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


def _searching(where: str) -> Model:
    from .load import load

    return load(where).search
