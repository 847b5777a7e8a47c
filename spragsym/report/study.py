"""A brake: its data with units and tolerances, the loading parameter, and the effective
friction.
"""

from __future__ import annotations

import math
import os
import warnings
from collections.abc import Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, replace
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from ..core.errors import ParameterError, hint
from ..core.progress import doing, show_progress
from ..core.remarks import Remark
from ..design.sampling import Correlation, Dependence, dependence
from ..models.load import USUAL, WITH_DAMPERS
from ..models.parameters import POSITIVE, ParameterSet, Range, Ranges, Span, as_number, as_range
from ..models.quantities import Quantities, QuantityValues, Scales, factor, quantities, share
from ..results.result import in_unit
from .damping import RATIO, modal_dampers
from .friction_fit import FrictionFit
from .units import Measured, Numbers, plain_unit, read, shown_in

if TYPE_CHECKING:
    from ..design.jumps import Ends
    from .reports import Report

#: Least, as drawn, and largest within the tolerances.
Spread: TypeAlias = tuple[float, float, float]


@dataclass(frozen=True)
class LoadParameter:
    """The loading parameter: its quantity in the file, the parameter that it is in the model, and
    from where it rises, in SI.
    """

    quantity: str
    name: str
    begin: float
    #: Whether it is the friction at full slip.
    is_friction: bool

    @property
    def word(self) -> str:
        """Name of the load parameter in a sentence."""
        return "friction" if self.is_friction else self.quantity

    def check(self, values: Numbers, si: str) -> LoadParameter:
        """Itself; an error for a brake in which it is below where it begins."""
        if self.begin > values[self.quantity]:
            begin, value = (
                shown_in(one, plain_unit(si), si) for one in (self.begin, values[self.quantity])
            )
            above = f"begin = {begin} is above {self.quantity} = {value}"
            raise ParameterError(f"{above}; begin where it is lower")
        return self


def check_load(kind: Quantities, vary: object) -> None:
    """Refuse a loading parameter, if one is named, on which no state depends."""
    if not isinstance(vary, str | None):
        raise ParameterError(f'vary = {vary!r} is no name of a quantity; write vary = "F_L"')
    if vary is not None and vary not in kind.may_rise:
        cure = hint(vary, kind.may_rise) or f"; choose one of {', '.join(kind.may_rise)}"
        raise ParameterError(
            f"vary = {vary!r} does not move the states of {kind.model.where}, or is a unit{cure}"
        )


def load_parameter_of(
    kind: Quantities, vary: str | None, begin: float | None, values: Numbers
) -> LoadParameter | None:
    """The loading parameter: the quantity that is named, else the friction at full slip; None for a
    model without it.

    ``begin`` and the quantities are in SI; without it the quantity rises from its least value.
    """
    if vary is None:
        if begin is not None:
            raise ParameterError(
                f"begin = {begin!r} says from where a quantity rises; give vary, its name, too"
            )
        quantity, name = kind.friction, kind.model.coefficient
        return LoadParameter(quantity, name, 0.0, kind.has_friction) if quantity and name else None
    check_load(kind, vary)
    allowed = kind.ranges(values)[vary]
    if begin is None and not allowed.contains(allowed.low):
        raise ParameterError(
            f"vary = {vary!r} has no least value in {allowed}; give begin, from where it rises"
        )
    start = allowed.low if begin is None else as_number("begin", begin, allowed)
    of_friction = kind.has_friction and vary == kind.friction
    if of_friction and start != allowed.low:
        raise ParameterError(
            f"begin = {start:g}: friction rises from {allowed.low:g}; leave begin out"
        )
    load = LoadParameter(vary, kind.parameters[vary], start, of_friction)
    return load.check(values, kind.units[vary])


def spanned(kind: Quantities, name: str, ends: Span) -> Span:
    """The range in which a quantity may change, in SI; refused if it is none, or empty."""
    if name not in kind.balanced:
        cure = hint(name, kind.balanced) or f"; give some of {', '.join(kind.balanced)}"
        raise ParameterError(f"may_change: no state depends on {name}{cure}")
    return as_range(f"may_change of {name}", ends, kind.ranges()[name])


class Study:
    """The data of one brake with tolerances: ask for a report.

    Parameters
    ----------
    parameters : PhysicalParameters or mapping of str to float
        Single numbers in SI: of the article's model, or the quantities of ``model`` by name; V and
        d may be left out.
    tolerance : mapping, optional
        For each quantity that is known within limits only: how far it may be off, as a number in
        SI; its two ends, as a tuple; or text such as ``"15 %"``, ``"1 deg"``, ``"[150, 210] N/mm"``
        or, for a standard deviation, ``"sd 5 %"``. Where two ends do not hold the value their
        middle takes its place.
    correlation : mapping of pairs of names to float, optional
        Quantities that vary together, see :func:`spragsym.jump_probability`.
    model : str, optional
        Name or folder of the model.
    vary : str, optional
        The quantity that rises until the state jumps, where that is not the friction: a load, a
        stiffness, an angle.
    begin : float, optional
        From where it rises, in SI, instead of its least value.
    may_change : mapping of str to (float, float), optional
        Quantities that a proposal may change, each with the two ends of its range in SI; without it
        all, by up to a factor of 3.
    state : mapping of str to float, optional
        Coordinates in SI near which the state begins that is followed, in place of the reference
        state, as ``{"phi": -0.5}``.
    damping_ratio : float, optional
        That of every mode of the unloaded mechanism, in place of the dampers, which follow from it;
        of the article's model by that with dampers, ``damped``. See
        :func:`spragsym.report.damping.modal_dampers`.

    Attributes
    ----------
    quantities : dict of str to Measured
        Every quantity with its ends in SI, and the unit in which it came.
    model : str
        Name of the model.
    fit : FrictionFit or None
        The fit of the friction law, if it was measured.
    load : LoadParameter or None
        The loading parameter until the state jumps; None for a model without mu0 of which that is
        not said.

    Examples
    --------
    >>> from math import radians
    >>> from spragsym import PhysicalParameters
    >>> brake = PhysicalParameters(
    ...     m=0.35, k=1.8e5, k_x=9e3, k_y=0, k_c=1.5e6, F_L=420, L_0=0.038,
    ...     theta0=radians(52), mu0=0.3,
    ... )
    >>> study = Study(brake, tolerance={"k": "15 %", "mu0": (0.28, 0.32)})
    >>> round(study.report(probability=False, redesign=False).mu_jump, 4)
    0.3663
    """

    quantities: Mapping[str, Measured]
    model: str
    source: str = ""
    fit: FrictionFit | None = None
    damping_ratio: float | None = None
    correlation: Correlation = MappingProxyType({})
    load: LoadParameter | None = None
    state: Numbers = MappingProxyType({})
    may_change: Ranges = MappingProxyType({})
    title: str = ""
    date: str = ""

    def __init__(
        self,
        parameters: QuantityValues | Numbers,
        tolerance: Mapping[str, Any] | None = None,
        correlation: Correlation | None = None,
        *,
        model: str = USUAL,
        vary: str | None = None,
        begin: float | None = None,
        state: Numbers | None = None,
        may_change: Ranges | None = None,
        damping_ratio: float | None = None,
    ) -> None:
        if damping_ratio is not None:
            model = WITH_DAMPERS.get(model, model)
            self.damping_ratio = as_number("damping_ratio", damping_ratio, RATIO)
        kind, off = quantities(model), dict(tolerance or {})
        given, allowed = _given(parameters, kind, self.damping_ratio), kind.ranges()
        for name in off:
            if name not in given:
                raise ParameterError(
                    f"tolerance of {name!r}: no such quantity{hint(name, kind.units)}; leave it out"
                )
        self.model, self.correlation, self.state = model, dict(correlation or {}), dict(state or {})
        self.quantities = {
            name: _measured(name, given[name], off.get(name), si, allowed[name])
            for name, si in kind.units.items()
            if name in given
        }
        if self.damping_ratio is not None:
            self.quantities |= modal_dampers(kind, self.quantities, self.damping_ratio)
        self.load = load_parameter_of(kind, vary, begin, self.values)
        self.may_change = {
            name: spanned(kind, name, (low, high))
            for name, (low, high) in (may_change or {}).items()
        }
        self.dimensionless  # noqa: B018  # an error for a state that is none here, not later
        dependence(list(self.tolerances), self.correlation)

    @staticmethod
    def from_file(path: str | os.PathLike[str], *, trust: bool | str = False) -> Study:
        """The study of a file such as ``brake.toml``; see :func:`spragsym.report.data.read_brake`.

        A number whose unit was probably meant otherwise is a UserWarning.
        """
        from .data import read_brake  # it makes studies

        return read_brake(path, trust).with_warnings()

    @classmethod
    def of(cls, **data: Any) -> Self:
        """The study of attributes that are known to fit together."""
        study = cls.__new__(cls)
        study.__dict__.update(data)
        return study

    def with_data(self, **changed: Any) -> Self:
        """The study with some of its attributes replaced, which are known to fit."""
        held = {name: value for name, value in vars(self).items() if name in Study.__annotations__}
        return type(self).of(**held | changed)

    def with_quantities(self, changed: Mapping[str, Measured]) -> Self:
        """The study of the same file with other quantities."""
        study = self.with_data(quantities=changed)
        if study.load is not None:
            study.load.check(study.values, study.kind.units[study.load.quantity])
        return study

    def changed(self, after: Numbers) -> Self:
        """The study of another design: a quantity that changes keeps its tolerance as a share of
        its value, an angle as it is.
        """
        new = {
            name: self.quantities[name].scaled(value, self.kind.units[name] != "rad")
            for name, value in after.items()
        }
        return self.with_quantities({**self.quantities, **new})

    def undamped(self) -> Self:
        """The study by the model without dampers, if it has the same states, else itself."""
        without = {damped: plain for plain, damped in WITH_DAMPERS.items()}.get(self.model)
        if without is None:
            return self
        kept = {k: v for k, v in self.quantities.items() if k not in self.kind.dampers}
        return self.with_data(model=without, quantities=kept)

    def at_full_slip(self) -> Self:
        """The study without the belt's speed: friction is μ₀."""
        return self.with_quantities(
            {name: one for name, one in self.quantities.items() if name not in self.kind.of_the_law}
        )

    @cached_property
    def kind(self) -> Quantities:
        """The quantities of the model."""
        return quantities(self.model)

    @cached_property
    def values(self) -> dict[str, float]:
        """The values in SI by name."""
        return {name: one.value for name, one in self.quantities.items()}

    @property
    def tolerances(self) -> Numbers:
        """Half of the width of every quantity that has one, in SI."""
        return {
            name: 0.5 * (one.high - one.low) for name, one in self.quantities.items() if one.varies
        }

    @cached_property
    def scales(self) -> Scales:
        """Scales of length, time and force."""
        return self.kind.scales(self.values)

    def scale(self, si: str) -> float:
        """Size of the model's own unit in an SI unit."""
        return float(self.kind.scale(si, self.values))

    @cached_property
    def dimensionless(self) -> ParameterSet:
        """The dimensionless parameters at the operating point, with the friction μ₀."""
        return self.placed(self.kind.parameter_set(self.values))

    def placed(self, p: ParameterSet) -> ParameterSet:
        """A set of parameters that follows the state that was chosen, if one was."""
        return p.following(**self.near) if self.near else p

    @property
    def near(self) -> Numbers:
        """Coordinates near which that lies, as the model has them."""
        return {
            name: value / self.scale(self.kind.coordinates.get(name, "1"))
            for name, value in self.state.items()
        }

    @cached_property
    def operating_point(self) -> ParameterSet:
        """The brake with the μ₀ with which statics has the friction that works, where the model has
        one.
        """
        return self.loaded(self.values, None)

    @cached_property
    def moves(self) -> bool:
        """Whether all that the motion in time depends on is known; a file may leave out V and d."""
        return set(self.kind.parameters) <= set(self.quantities)

    @property
    def belt(self) -> str | None:
        """The quantity that is the speed of the belt, whatever the page calls it; None where none
        alone is that.
        """
        belt = self.kind.law["belt"]
        return next(
            (quantity for quantity, name in self.kind.parameters.items() if name == belt), None
        )

    @cached_property
    def law(self) -> str:
        """Friction law at work: that at the belt's speed where it is known and a value of μ₀ stands
        for it, else that at rest.
        """
        law, laws = self.kind.law, self.kind.about["frictions"]
        asked = {name for one in laws for name in one["quantities"]}
        applies = law["belt"] != "0" and asked <= set(self.quantities)
        return "friction_at_speed" if applies and law["at_rest"] != "other" else "friction_at_rest"

    @property
    def slides(self) -> bool:
        """Whether there is friction."""
        return bool(self.kind.about["frictions"])

    @cached_property
    def friction(self) -> Spread:
        """The friction that works, by the law: least, as drawn, and largest within the tolerances;
        0 without friction.
        """
        # The solvers are heavy, and a refusal does not need them.
        from ..statics.balance import NEGLIGIBLE
        from .friction_law import friction_bounds, friction_depends_on

        p = self.dimensionless
        if not self.slides:
            return 0.0, 0.0, 0.0
        here = float(p.model.friction(p, self.law, self.kind.law["name"]))
        if not set(friction_depends_on(self)) & set(self.tolerances):
            return here, here, here
        low, high = friction_bounds(self)
        # Bounds of a friction that is 0 are a little above it.
        return (
            low,
            here,
            high if high > here + NEGLIGIBLE else here,
        )

    @property
    def other_frictions(self) -> Numbers:
        """Those of other contacts by their names, as drawn, where they are not the same."""
        p = self.dimensionless
        names = p.model.rubbing if self.slides else ()
        every = {name: float(p.model.friction(p, self.law, name)) for name in names}
        return {name: one for name, one in every.items() if one != self.friction[1]}

    def of_statics(self, mu0: float) -> float:
        """The friction that statics takes with a value of μ₀."""
        if not mu0 < math.inf:
            return mu0
        p, contact = self.dimensionless.replace(**{self.loading.name: mu0}), self.kind.law["name"]
        return float(p.model.friction(p, "friction_at_rest", contact))

    @property
    def loading(self) -> LoadParameter:
        """The loading parameter; one without a name where nothing is said to rise."""
        # The loading parameter where none is named.
        nothing = LoadParameter("", "", math.nan, False)
        return self.load or nothing

    @property
    def of_friction(self) -> bool:
        """Whether it is the friction that rises."""
        return self.loading.is_friction

    @property
    def in_use(self) -> Spread:
        """The loading parameter, where the brake works: least, as drawn, and largest within the
        tolerances.
        """
        if self.load is None or self.of_friction:
            return self.friction
        one = self.quantities[self.load.quantity]
        return one.low, one.value, one.high

    @property
    def full_slip(self) -> Spread:
        """The friction at full slip."""
        if not self.of_friction:
            return self.in_use
        one = self.quantities[self.loading.quantity]
        return self.of_statics(one.low), self.of_statics(one.value), self.of_statics(one.high)

    @property
    def load_scale(self) -> float:
        """Size of the model's own unit of the load parameter: in SI, in the units of the brake as
        drawn.
        """
        return self.scale(self.kind.units[self.loading.quantity])

    def displayed(self, value: float) -> float:
        """A value of the parameter that rises as it is told: the friction of the law, or in SI."""
        return self.of_statics(value) if self.of_friction else value * self.load_scale

    def start(self, values: Mapping[str, Any] | None = None) -> Any:
        """From where it rises, as its parameter; of other brakes in their own units, each at the
        same value in SI.
        """
        load = self.loading
        allowed = self.kind.model.Parameters.ranges[load.name]
        scale = self.kind.scale(self.kind.units[load.quantity], values or self.values)
        return np.maximum(load.begin / scale, allowed.reached(allowed.low))

    def along(self, values: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """The loading parameter as arguments of the model's questions."""
        return {"vary": self.loading.name, "begin": self.start(values)}

    @cached_property
    def ends(self) -> Ends:
        """End of the state as something rises, and how far that was looked for."""
        from ..design.jumps import first_limit_points  # heavy, and a refusal does not need it

        return first_limit_points(self.operating_point, **self.along())

    def jump(self) -> float:
        """Value of the load parameter at which the state jumps; NaN where it does not."""
        from ..design.jumps import require_known  # as above

        return float(require_known(self.ends).value)

    def loaded(self, values: Mapping[str, Any], target: float | None) -> ParameterSet:
        """Parameters of brakes, by their quantities in SI, with the loading parameter at a target,
        or at its own value.
        """
        if target is not None and not self.of_friction:
            values = {**values, self.loading.quantity: target}
        p = self.placed(self.kind.parameter_set(values))
        if (name := p.model.coefficient) is not None:
            works = p[name] * (share(p.model, p) if self.law == "friction_at_speed" else 1.0)
            loaded = works if target is None or not self.of_friction else target
            p = p.replace(**{name: np.broadcast_to(loaded, p.shape)})
        return p

    @property
    def upper_limit(self) -> float:
        """Up to which value a jump is looked for, as it is told: all, or the end of a search."""
        return self.displayed(float(self.ends.until))

    def shown(self, name: str, value: float | None = None, digits: int = 4) -> str:
        """A value of a quantity, by default its own, as text in the unit in which it came."""
        one = self.quantities[name]
        return shown_in(
            one.value if value is None else value, one.unit, self.kind.units[name], digits
        )

    def unit_size(self, name: str) -> float:
        """Size in SI of the unit in which a quantity came."""
        return factor(self.quantities[name].unit, self.kind.units[name])

    def in_file(self, name: str, value: float) -> float:
        """A value of a quantity in the unit in which it came."""
        return value / self.unit_size(name)

    def in_units(self) -> dict[str, tuple[float, str, float]]:
        """Every quantity as it came: its value, its unit, and what one of that is in SI."""
        return {
            name: (self.in_file(name, one.value), one.unit, self.unit_size(name))
            for name, one in self.quantities.items()
        }

    def shown_speed(self, speed: float, digits: int = 4) -> str:
        """A speed of the belt as text, by the name of the page: ``V = 1.2 m/s``."""
        if self.belt is None:
            return f"a speed of {speed:.{digits}g} m/s"
        return f"{self.belt} = {self.shown(self.belt, speed, digits)}"

    def load_text(self, value: float, digits: int = 4) -> str:
        """A value of the loading parameter: a friction as a number, a quantity with its unit."""
        if self.of_friction:
            return f"{value:.{digits}g}"
        return self.shown(self.loading.quantity, value, digits)

    def named(self, value: float, digits: int = 4) -> str:
        """The value in a sentence: ``a friction of 0.4`` or ``P = 20 N``."""
        return (
            f"{'a friction of' if self.of_friction else f'{self.loading.quantity} ='} "
            f"{self.load_text(value, digits)}"
        )

    @property
    def search_range(self) -> str:
        """Range in which a jump is looked for, in a sentence: ``friction`` at all, or ``P up to 20
        N``.
        """
        word = self.loading.word
        if math.isinf(self.upper_limit):
            return word
        return f"{word} up to {self.load_text(self.upper_limit)}"

    def unit_of(self, si: str, name: str = "") -> tuple[str, float]:
        """The unit of this file for an SI unit, that of a quantity if it is there, and what one of
        the model's is in it.
        """
        alike = (other for other in self.quantities if self.kind.units[other] == si)
        here = name if name in self.quantities else next(alike, "")
        unit = self.quantities[here].unit if here else plain_unit(si)
        return unit, self.scale(si) / factor(unit, si)

    def said(self, remark: str) -> str:
        """A remark with what it says of parameters, by their quantities, and of coordinates in the
        units of the file.
        """

        def units(name: str) -> tuple[str, str, float]:
            quantity = quantity_of.get(name, name)
            return quantity, *in_unit(self.kind.model.columns[name].dimension, self, quantity)

        quantity_of = {name: quantity for quantity, name in self.kind.parameters.items()}
        return remark.in_units(units) if isinstance(remark, Remark) else str(remark)

    def pairs(self, names: Sequence[str]) -> dict[tuple[str, str], float]:
        """Pairs that vary together, of some of the quantities."""
        return {pair: value for pair, value in self.correlation.items() if set(pair) <= set(names)}

    def together(self, names: Sequence[str]) -> Dependence:
        """Dependence of some of the quantities on each other."""
        return dependence(names, self.pairs(names))

    def with_warnings(self) -> Self:
        """Itself, and a UserWarning for each number whose unit was probably meant otherwise."""
        from .advice import of_data  # heavy, and a refusal does not need it

        for said in of_data(self):
            warnings.warn(f"{self.source}: {said}", stacklevel=3)
        return self

    def report(
        self,
        *,
        probability: bool = True,
        redesign: bool = True,
        oscillation: bool = True,
        safety: float = 1.2,
        n: int | None = None,
        progress: bool = False,
    ) -> Report:
        """Everything that can be said of this brake.

        Parameters
        ----------
        probability : bool
            Also the certificate, the probability of a jump, and which tolerance matters.
        redesign : bool
            Also what to change.
        oscillation : bool
            Also follow the motion to its cycle, if V and d are known; that takes about a second.
        safety : float
            What is changed keeps the jump at this many times the largest friction.
        n : int, optional
            Points for the probability: 4096 by closed forms, 2048 where each is followed.
        progress : bool
            Say on stderr what is being computed.

        Returns
        -------
        Report
            What is not answered for the model is None there, with the reason among the warnings.
        """
        from .facts import ReportOptions, facts  # heavy, and a refusal does not need it
        from .reports import Report

        options = ReportOptions(
            probability, redesign, oscillation, as_number("safety", safety, POSITIVE), n
        )
        with show_progress() if progress else nullcontext(), doing(""):
            return Report(**vars(facts(self, options)))

    def __repr__(self) -> str:
        words = ", ".join(f"{name}={self.shown(name)}" for name in self.quantities)
        return f"{type(self).__name__}({words})"


def _given(parameters: object, kind: Quantities, damping_ratio: float | None) -> Numbers:
    allowed, model = kind.ranges(), kind.model.where
    if isinstance(parameters, QuantityValues) and model in (USUAL, WITH_DAMPERS[USUAL]):
        parameters = parameters.known
    if not isinstance(parameters, Mapping):
        raise ParameterError(
            f"parameters = {type(parameters).__name__}(...): a study needs "
            "PhysicalParameters, in newtons and metres, or with "
            "model= a mapping; for dimensionless ones call jump_value, jump_margin, certify "
            "and jump_probability"
        )
    for name in parameters:
        if name not in allowed:
            remark = hint(name, allowed) or f"; it has {', '.join(allowed)}"
            raise ParameterError(f"parameters: {name!r} is no quantity of {model}{remark}")
    optional = kind.of_the_law + (() if damping_ratio is None else kind.dampers)
    missing = [name for name in allowed if name not in parameters and name not in optional]
    if missing:
        raise ParameterError(f"parameters are without {', '.join(missing)}; give them in SI units")
    return {name: as_number(name, value, allowed[name]) for name, value in parameters.items()}


def _measured(name: str, value: float, off: ArrayLike | None, si: str, allowed: Range) -> Measured:
    """A value with its tolerance as Python is told it: numbers become the text of a file."""
    title, unit, in_si = f"tolerance of {name}", plain_unit(si), "" if si == "1" else si
    if off is None:
        return Measured(value, value, value, unit)
    if isinstance(off, tuple):
        if len(off) != 2:
            raise ParameterError(f"{title} = {off!r}; give two ends, the smaller first")
        off = f"[{', '.join(repr(as_number(title, end, allowed)) for end in off)}] {in_si}"
    elif not isinstance(off, str):
        off = f"{abs(as_number(title, off))!r} {in_si}"
    if not off.lstrip().startswith("["):
        sign = "" if off.lstrip().startswith(("±", "+-", "+/-", "+\N{MINUS SIGN}", "sd ")) else "± "
        off = f"{value!r} {in_si} {sign}{off}"
    try:
        ends = read(off, si, allowed)
    except ParameterError as error:
        raise ParameterError(f"{title}: {error}") from error
    return replace(ends, value=value if ends.low <= value <= ends.high else ends.value, unit=unit)
