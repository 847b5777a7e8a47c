"""A brake as a report sees it (:class:`Study`): its quantities with units and tolerances, the
loading parameter, and the friction in use.
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

from ..core.errors import ParameterError, ParameterTypeError, hint, one_of
from ..core.progress import doing, show_progress
from ..core.remarks import Remark
from ..design.sampling import Correlation, Dependence, dependence
from ..models.load import USUAL, WITH_DAMPERS
from ..models.parameters import (
    FINITE,
    POSITIVE,
    Carried,
    ParameterSet,
    Range,
    Ranges,
    Span,
    as_mapping,
    as_number,
    as_range,
)
from ..models.quantities import (
    Quantities,
    QuantityValues,
    Scales,
    factor,
    in_si,
    quantities,
    share,
)
from ..results.result import in_unit
from .damping import RATIO, modal_dampers
from .friction_fit import FrictionFit
from .units import Measured, Numbers, plain_unit, read, shown_in

if TYPE_CHECKING:
    from ..design.jumps import Ends
    from .reports import Report

#: Smallest value within the tolerances, value as drawn, largest value within the tolerances.
Spread: TypeAlias = tuple[float, float, float]


@dataclass(frozen=True)
class LoadParameter:
    """The loading parameter: name of the quantity in the file, name of the parameter in the model,
    and the value, in SI, from which it rises.
    """

    quantity: str
    name: str
    begin: float
    #: True if it is the friction at full slip.
    is_friction: bool

    @property
    def word(self) -> str:
        """Name of the load parameter in a sentence."""
        return "friction" if self.is_friction else self.quantity

    def check(self, values: Numbers, si: str) -> LoadParameter:
        """Return itself; ParameterError if its value in ``values`` is below ``begin``."""
        if self.begin > values[self.quantity]:
            begin, value = (
                shown_in(one, plain_unit(si), si) for one in (self.begin, values[self.quantity])
            )
            above = f"begin = {begin} is above {self.quantity} = {value}"
            raise ParameterError(f"{above}; begin where it is lower")
        return self


def check_load(kind: Quantities, vary: object) -> None:
    """Raise ParameterError for a loading parameter ``vary`` on which no state depends."""
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
    """The loading parameter: the quantity ``vary``, by default the friction at full slip; None if
    the model has no such friction.

    ``begin`` and ``values`` are in SI; the default of ``begin`` is the smallest allowed value.
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
    """The range in which a quantity may change, in SI; ParameterError if it is invalid."""
    if name not in kind.balanced:
        cure = hint(name, kind.balanced) or f"; give some of {', '.join(kind.balanced)}"
        raise ParameterError(f"may_change: no state depends on {name}{cure}")
    return as_range(f"may_change of {name}", ends, kind.ranges()[name])


class Study:
    """The data of one brake with tolerances, of which :meth:`report` computes a report.

    Parameters
    ----------
    parameters : PhysicalParameters or mapping of str to float
        Single numbers in SI: those of the article's model, or the quantities of ``model`` by name.
        V and d may be missing.
    tolerance : mapping, optional
        Tolerances of quantities by name: the largest deviation, as a number in SI; the two ends, as
        a tuple; or text such as ``"15 %"``, ``"1 deg"``, ``"[150, 210] N/mm"`` or, for a standard
        deviation, ``"sd 5 %"``. If the value is not between two given ends, their midpoint replaces
        it. Where ``parameters`` have units, tolerances of quantities with a dimension have too.
    correlation : mapping of pairs of names to float, optional
        Correlated quantities, see :func:`spragsym.jump_probability`.
    model : str, optional
        Name or folder of the model.
    vary : str, optional
        The quantity that rises until the state jumps, by default the friction: a load, a stiffness,
        an angle.
    begin : float, optional
        Value in SI from which it rises, by default its smallest allowed value.
    may_change : mapping of str to (float, float), optional
        Quantities that a redesign may change, with their ranges in SI; by default all, by up to a
        factor of 3.
    state : mapping of str to float, optional
        Coordinates in SI near those of the state that is followed, as ``{"phi": -0.5}``; by default
        the reference state.
    damping_ratio : float, optional
        Damping ratio of every mode of the unloaded mechanism, from which the dampers are computed:
        see :func:`spragsym.report.damping.modal_dampers`. For the article's model, the model with
        dampers, ``damped``, is used.

    Attributes
    ----------
    quantities : dict of str to Measured
        Every quantity with its ends in SI, and the unit in which it was given.
    model : str
        Name of the model.
    fit : FrictionFit or None
        The fit of the friction law, if measurements were given.
    load : LoadParameter or None
        The loading parameter; None for a model without mu0, if ``vary`` is not given.

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
        kind = quantities(model)
        off = as_mapping("tolerance", tolerance, '{"mu0": "10 %"}')
        (given, have_units), allowed = _given(parameters, kind, self.damping_ratio), kind.ranges()
        for name, given_off in off.items():
            if name not in given:
                raise ParameterError(
                    f"tolerance of {name!r}: no such quantity{hint(name, kind.units)}; leave it out"
                )
            if have_units and kind.units[name] not in ("1", "rad"):
                _require_units(name, given_off, kind.units[name])
        self.model = model
        self.correlation = as_mapping("correlation", correlation, '{("k", "k_x"): 0.9}')
        self.state = {
            one_of("state", name, kind.coordinates): as_number(f"state[{name!r}]", value)
            for name, value in as_mapping("state", state, '{"x": 0.06}, in SI').items()
        }
        self.quantities = {
            name: _measured(name, given[name], off.get(name), si, allowed[name])
            for name, si in kind.units.items()
            if name in given
        }
        if self.damping_ratio is not None:
            self.quantities |= modal_dampers(kind, self.quantities, self.damping_ratio)
        self.load = load_parameter_of(kind, vary, begin, self.values)
        self.may_change = {
            name: spanned(kind, name, ends)
            for name, ends in as_mapping(
                "may_change", may_change, '{"mu0": (0.1, 0.5)}, in SI'
            ).items()
        }
        self.dimensionless  # noqa: B018  # an error for a state that is none here, not later
        dependence(list(self.tolerances), self.correlation)

    @staticmethod
    def from_file(path: str | os.PathLike[str], *, trust: bool | str = False) -> Study:
        """The study of a file such as ``brake.toml``; see :func:`spragsym.report.data.read_brake`.

        Warns (UserWarning) about numbers that probably have the wrong unit.
        """
        from .data import read_brake  # it makes studies

        return read_brake(path, trust).with_warnings()

    @classmethod
    def of(cls, **data: Any) -> Self:
        """The study with given attributes, which are not checked."""
        study = cls.__new__(cls)
        study.__dict__.update(data)
        return study

    def with_data(self, **changed: Any) -> Self:
        """The study with some of its attributes replaced; they are not checked."""
        held = {name: value for name, value in vars(self).items() if name in Study.__annotations__}
        return type(self).of(**held | changed)

    def with_quantities(self, changed: Mapping[str, Measured]) -> Self:
        """The study of the same file with other quantities."""
        study = self.with_data(quantities=changed)
        if study.load is not None:
            study.load.check(study.values, study.kind.units[study.load.quantity])
        return study

    def changed(self, after: Numbers) -> Self:
        """The study of another design, with new values in SI. A changed quantity keeps its relative
        tolerance, an angle its absolute one.
        """
        new = {
            name: self.quantities[name].scaled(value, self.kind.units[name] != "rad")
            for name, value in after.items()
        }
        return self.with_quantities({**self.quantities, **new})

    def undamped(self) -> Self:
        """The study with the model without dampers, which has the same states; itself if there is
        no such model.
        """
        without = {damped: plain for plain, damped in WITH_DAMPERS.items()}.get(self.model)
        if without is None:
            return self
        others = {k: v for k, v in self.quantities.items() if k not in self.kind.dampers}
        return self.with_data(model=without, quantities=others)

    def at_full_slip(self) -> Self:
        """The study without the belt's speed, so that the friction is μ₀."""
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
        """Half-width of every quantity with a tolerance, in SI."""
        return {
            name: 0.5 * (one.high - one.low) for name, one in self.quantities.items() if one.varies
        }

    @cached_property
    def scales(self) -> Scales:
        """Scales of length, time and force."""
        return self.kind.scales(self.values)

    def scale(self, si: str) -> float:
        """The model's unit of a quantity with the SI unit ``si``, in that unit."""
        return float(self.kind.scale(si, self.values))

    @cached_property
    def dimensionless(self) -> ParameterSet:
        """The dimensionless parameters at the operating point, with the friction μ₀."""
        return self.placed(self.kind.parameter_set(self.values))

    def placed(self, p: ParameterSet) -> ParameterSet:
        """The parameters, set to follow the chosen state, if there is one."""
        return p.following(**self.near) if self.near else p

    @property
    def near(self) -> Numbers:
        """Coordinates near the chosen state, in the model's units."""
        return {
            name: value / self.scale(self.kind.coordinates.get(name, "1"))
            for name, value in self.state.items()
        }

    @cached_property
    def operating_point(self) -> ParameterSet:
        """The parameters at the belt's speed: with the μ₀ for which statics has the friction in
        use.
        """
        return self.loaded(self.values, None)

    @cached_property
    def moves(self) -> bool:
        """True if all quantities of the motion are known; a file may lack V and d."""
        return set(self.kind.parameters) <= set(self.quantities)

    @property
    def belt(self) -> str | None:
        """The quantity that is the speed of the belt; None if no single quantity is."""
        belt = self.kind.law["belt"]
        return next(
            (quantity for quantity, name in self.kind.parameters.items() if name == belt), None
        )

    @cached_property
    def law(self) -> str:
        """Name of the friction law in use: that at the belt's speed, if the speed is known and some
        value of μ₀ gives the same friction; else that at rest.
        """
        law, laws = self.kind.law, self.kind.about["frictions"]
        asked = {name for one in laws for name in one["quantities"]}
        applies = law["belt"] != "0" and asked <= set(self.quantities)
        return "friction_at_speed" if applies and law["at_rest"] != "other" else "friction_at_rest"

    @property
    def slides(self) -> bool:
        """True if the model has friction."""
        return bool(self.kind.about["frictions"])

    @cached_property
    def friction(self) -> Spread:
        """The friction in use by the law in use; 0 without friction."""
        # Imported here, because the solvers are slow to import.
        from ..statics.balance import NEGLIGIBLE
        from .friction_law import friction_bounds, friction_depends_on

        p = self.dimensionless
        if not self.slides:
            return 0.0, 0.0, 0.0
        here = float(p.model.friction(p, self.law, self.kind.law["name"]))
        if not set(friction_depends_on(self)) & set(self.tolerances):
            return here, here, here
        low, high = friction_bounds(self)
        # The upper bound of a friction of 0 is slightly above it.
        return low, here, high if high > here + NEGLIGIBLE else here

    @property
    def other_frictions(self) -> Numbers:
        """Frictions of other contacts by name, as drawn, that differ from the main one."""
        p = self.dimensionless
        names = p.model.rubbing if self.slides else ()
        every = {name: float(p.model.friction(p, self.law, name)) for name in names}
        return {name: one for name, one in every.items() if one != self.friction[1]}

    def of_statics(self, mu0: float) -> float:
        """The friction in statics for a value of μ₀."""
        if not mu0 < math.inf:
            return mu0
        p, contact = self.dimensionless.replace(**{self.loading.name: mu0}), self.kind.law["name"]
        return float(p.model.friction(p, "friction_at_rest", contact))

    @property
    def loading(self) -> LoadParameter:
        """The loading parameter; one with an empty name if there is none."""
        return self.load or LoadParameter("", "", math.nan, False)

    @property
    def of_friction(self) -> bool:
        """True if the loading parameter is the friction."""
        return self.loading.is_friction

    @property
    def in_use(self) -> Spread:
        """The loading parameter in use: for friction that at the belt's speed."""
        if self.load is None or self.of_friction:
            return self.friction
        one = self.quantities[self.load.quantity]
        return one.low, one.value, one.high

    @property
    def full_slip(self) -> Spread:
        """The loading parameter, for friction that at full slip."""
        if not self.of_friction:
            return self.in_use
        one = self.quantities[self.loading.quantity]
        return self.of_statics(one.low), self.of_statics(one.value), self.of_statics(one.high)

    @property
    def load_scale(self) -> float:
        """The model's unit of the load parameter in SI, for the brake as drawn."""
        return self.scale(self.kind.units[self.loading.quantity])

    def displayed(self, value: float) -> float:
        """A value of the model's load parameter as reported: a friction of the law, or in SI."""
        return self.of_statics(value) if self.of_friction else value * self.load_scale

    def start(self, values: Mapping[str, Any] | None = None) -> Any:
        """First value of the model's load parameter; for other brakes with these ``values``, each
        with the same first value in SI.
        """
        load = self.loading
        allowed = self.kind.model.Parameters.ranges[load.name]
        scale = self.kind.scale(self.kind.units[load.quantity], values or self.values)
        return np.maximum(load.begin / scale, allowed.reached(allowed.low))

    def along(self, values: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """The loading parameter and its first value as keyword arguments of questions."""
        return {"vary": self.loading.name, "begin": self.start(values)}

    @cached_property
    def ends(self) -> Ends:
        """Where the followed state ends as the load parameter rises, and how far that was
        searched.
        """
        from ..design.jumps import first_limit_points  # slow to import

        return first_limit_points(self.operating_point, **self.along())

    def jump(self) -> float:
        """Value of the model's load parameter at which the state jumps; NaN if it does not."""
        from ..design.jumps import require_known  # slow to import

        return float(require_known(self.ends).value)

    def loaded(self, values: Mapping[str, Any], target: float | None) -> ParameterSet:
        """Parameters of brakes with given quantities in SI, and the loading parameter at
        ``target``, by default at its value in use.
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
        """Largest value of the loading parameter up to which a jump is searched, as reported."""
        return self.displayed(float(self.ends.until))

    def shown(self, name: str, value: float | None = None, digits: int = 4) -> str:
        """A value of a quantity, by default its own, as text in the unit of the file."""
        one = self.quantities[name]
        return shown_in(
            one.value if value is None else value, one.unit, self.kind.units[name], digits
        )

    def unit_size(self, name: str) -> float:
        """The unit of a quantity in the file, in SI."""
        return factor(self.quantities[name].unit, self.kind.units[name])

    def in_file(self, name: str, value: float) -> float:
        """A value of a quantity in the unit of the file."""
        return value / self.unit_size(name)

    def in_units(self) -> dict[str, tuple[float, str, float]]:
        """Every quantity as given: value, unit, and size of the unit in SI."""
        return {
            name: (self.in_file(name, one.value), one.unit, self.unit_size(name))
            for name, one in self.quantities.items()
        }

    def shown_speed(self, speed: float, digits: int = 4) -> str:
        """A speed of the belt as text, with the page's name: ``V = 1.2 m/s``."""
        if self.belt is None:
            return f"a speed of {speed:.{digits}g} m/s"
        return f"{self.belt} = {self.shown(self.belt, speed, digits)}"

    def load_text(self, value: float, digits: int = 4) -> str:
        """A value of the loading parameter as text: a plain friction, or a number with unit."""
        if self.of_friction:
            return f"{value:.{digits}g}"
        return self.shown(self.loading.quantity, value, digits)

    def named(self, value: float, digits: int = 4) -> str:
        """A value of the loading parameter in a sentence: ``a friction of 0.4`` or ``P = 20 N``."""
        name = "a friction of" if self.of_friction else f"{self.loading.quantity} ="
        return f"{name} {self.load_text(value, digits)}"

    @property
    def search_range(self) -> str:
        """The range in which a jump is searched, in a sentence: ``friction`` or ``P up to 20
        N``.
        """
        word = self.loading.word
        if math.isinf(self.upper_limit):
            return word
        return f"{word} up to {self.load_text(self.upper_limit)}"

    def unit_of(self, si: str, name: str = "") -> tuple[str, float]:
        """The file's unit for the SI unit ``si``, that of the quantity ``name`` if there is one;
        and the model's unit expressed in it.
        """
        same_kind = (other for other in self.quantities if self.kind.units[other] == si)
        quantity = name if name in self.quantities else next(same_kind, "")
        unit = self.quantities[quantity].unit if quantity else plain_unit(si)
        return unit, self.scale(si) / factor(unit, si)

    def said(self, remark: str) -> str:
        """A remark as text, with quantities in place of the model's parameters, and numbers in the
        units of the file.
        """

        def units(name: str, si: str) -> tuple[str, str, float]:
            quantity, columns = quantity_of.get(name, name), self.kind.model.columns
            return quantity, *in_unit(si or columns[name].dimension, self, quantity)

        quantity_of = {name: quantity for quantity, name in self.kind.parameters.items()}
        return remark.in_units(units) if isinstance(remark, Remark) else str(remark)

    def pairs(self, names: Sequence[str]) -> dict[tuple[str, str], float]:
        """Correlations between given quantities."""
        return {pair: value for pair, value in self.correlation.items() if set(pair) <= set(names)}

    def together(self, names: Sequence[str]) -> Dependence:
        """Joint dependence of given quantities."""
        return dependence(names, self.pairs(names))

    def with_warnings(self) -> Self:
        """Return itself, after a UserWarning for each number that probably has the wrong unit."""
        from .advice import of_data  # slow to import

        for text in of_data(self):
            warnings.warn(f"{self.source}: {text}", stacklevel=3)
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
        """Compute the report of this brake.

        Parameters
        ----------
        probability : bool
            Compute the certificate, the probability of a jump, and the effect of each tolerance.
        redesign : bool
            Search for changes that avoid the jump.
        oscillation : bool
            Follow the motion to its cycle, if V and d are known, which takes about a second.
        safety : float
            Factor by which changes keep the jump above the largest friction.
        n : int, optional
            Number of samples for the probability; by default 4096 with closed forms, else 2048.
        progress : bool
            Print on stderr what is being computed.

        Returns
        -------
        Report
            Facts that the model does not answer are None, with the reason among the warnings.
        """
        from .facts import ReportOptions, facts  # slow to import
        from .reports import Report

        options = ReportOptions(
            probability, redesign, oscillation, as_number("safety", safety, POSITIVE), n
        )
        with show_progress() if progress else nullcontext(), doing(""):
            return Report(**vars(facts(self, options)))

    def __repr__(self) -> str:
        words = ", ".join(f"{name}={self.shown(name)}" for name in self.quantities)
        return f"{type(self).__name__}({words})"


def _given(
    parameters: object, kind: Quantities, damping_ratio: float | None
) -> tuple[Numbers, bool]:
    """The given quantities in SI, checked, and whether they have units; ParameterError for unknown
    or missing ones.
    """
    allowed, model = kind.ranges(), kind.model.where
    had_units = getattr(parameters, "has_units", False)
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
    found, has_units = in_si(parameters, allowed)
    numbers = {name: as_number(name, array) for name, array in found.items()}
    return numbers, had_units or has_units


def _require_units(name: str, off: object, si: str) -> None:
    """Raise for a tolerance that is a bare number beside data that have units, as their values
    are.
    """
    for end in off if isinstance(off, tuple) else (off,):
        carried = Carried(f"tolerance of {name}", si)
        if not isinstance(end, str) and np.any(carried.numbers(end)) and not carried.units - {""}:
            raise ParameterTypeError(
                f"tolerance of {name} = {off!r:.60} has no unit, and the data have; give it one, "
                f'as in "1 {plain_unit(si)}", a share, as "10 %", or a quantity with a unit'
            )


def _measured(name: str, value: float, off: ArrayLike | None, si: str, allowed: Range) -> Measured:
    """A value with a tolerance as in :class:`Study`, which is converted to the text of a file and
    read like that.
    """
    title, unit, in_si = f"tolerance of {name}", plain_unit(si), "" if si == "1" else si
    if off is None:
        return Measured(value, value, value, unit)
    if isinstance(off, tuple):
        if len(off) != 2:
            raise ParameterError(f"{title} = {off!r}; give two ends, the smaller first")
        off = f"[{', '.join(repr(as_number(title, end, allowed)) for end in off)}] {in_si}"
    elif not isinstance(off, str):
        off = f"{abs(as_number(title, off, replace(FINITE, unit=si)))!r} {in_si}"
    if not off.lstrip().startswith("["):
        sign = "" if off.lstrip().startswith(("±", "+-", "+/-", "+\N{MINUS SIGN}", "sd ")) else "± "
        off = f"{value!r} {in_si} {sign}{off}"
    try:
        ends = read(off, si, allowed)
    except ParameterError as error:
        raise ParameterError(f"{title}: {error}") from error
    return replace(ends, value=value if ends.low <= value <= ends.high else ends.value, unit=unit)
