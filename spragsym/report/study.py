"""A study: the data of one brake with tolerances, and what can be said of it."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..design.dependence import Correlation, Dependence, dependence
from ..errors import ParameterError
from ..models.load import USUAL
from ..models.parameters import POSITIVE, PhysicalParameters, Range, Scales, as_number
from ..names import hint
from . import brake_quantities, rises
from .brake_files import BrakeFile, read_brake
from .measurements import FrictionFit
from .rises import Rise
from .units import Measured, factor, read, shown_in

if TYPE_CHECKING:
    from .reports import Report

#: Units of the report where the data came as plain numbers in SI.
PLAIN_UNITS: Mapping[str, str] = {
    "kg": "kg", "N/m": "N/mm", "m": "mm", "rad": "deg", "N": "N", "m/s": "m/s", "s/m": "s/m", "1": "",
}  # fmt: skip


class Study:
    """The data of one brake with tolerances: ask for a report.

    Parameters
    ----------
    parameters : PhysicalParameters or mapping of str to float
        Single numbers in SI: of the article's model, or the quantities of ``model`` by name; V and d may be left out.
    tolerance : mapping, optional
        For each quantity that is known within limits only: how far it may be off, as a number in SI; its two ends, as a tuple; or
        text such as ``"15 %"``, ``"1 deg"``, ``"[150, 210] N/mm"`` or, for a standard deviation, ``"sd 5 %"``. Where two ends do
        not hold the value their middle takes its place.
    correlation : mapping of pairs of names to float, optional
        Quantities that vary together, see :func:`spragsym.jump_probability`.
    model : str, optional
        Name or folder of the model.
    vary : str, optional
        The quantity that rises until the state jumps, where that is not the friction: a load, a stiffness, an angle.
    begin : float, optional
        From where it rises, in SI, instead of its least value.
    state : mapping of str to float, optional
        Coordinates in SI near which the state begins that is followed, in place of the reference state, as ``{"phi": -0.5}``.

    Attributes
    ----------
    quantities : dict of str to Measured
        Every quantity with its ends in SI, and the unit in which it came.
    model : str
        Name of the model.
    fit : FrictionFit or None
        The fit of the friction law, if it was measured.
    rise : Rise or None
        What rises until the state jumps; None for a model without mu0 of which that is not said.

    Examples
    --------
    >>> from math import radians
    >>> brake = PhysicalParameters(m=0.35, k=1.8e5, k_x=9e3, k_y=0, k_c=1.5e6, F_L=420, L_0=0.038, theta0=radians(52), mu0=0.3)
    >>> study = Study(brake, tolerance={"k": "15 %", "mu0": (0.28, 0.32)})
    >>> round(study.report(probability=False, redesign=False).mu_jump, 4)
    0.3663
    """

    def __init__(
        self, parameters: PhysicalParameters | Mapping[str, float], tolerance: Mapping[str, Any] | None = None,
        correlation: Correlation | None = None, *, model: str = USUAL, vary: str | None = None, begin: float | None = None,
        state: Mapping[str, float] | None = None,
    ) -> None:  # fmt: skip
        units, ranges = brake_quantities.quantity_units(model), brake_quantities.ranges(model)
        given = _given(parameters, model, ranges)
        off = dict(tolerance or {})
        for name in off:
            if name not in given:
                raise ParameterError(f"tolerance of {name!r}: no such quantity{hint(name, units)}; leave it out")
        self.quantities: Mapping[str, Measured] = {
            name: _measured(name, given[name], off.get(name), units[name], ranges[name]) for name in units if name in given
        }
        self.model, self.source, self.fit, self.correlation = model, "", None, dict(correlation or {})
        self.rise = rises.rise_of(model, vary, begin, self.values)
        self.state = dict(state or {})
        self.placed(self.dimensionless)
        dependence([name for name, one in self.quantities.items() if one.high > one.low], self.correlation)

    @classmethod
    def from_file(cls, path: str | os.PathLike[str], *, trust: bool | str = False) -> Study:
        """The study of a file such as ``brake.toml``; see :func:`spragsym.report.brake_files.read_brake`.

        A file may name the folder of a model, whose code runs: ``trust`` says that it may.
        """
        return cls.of(read_brake(path, trust))

    @classmethod
    def of(cls, data: BrakeFile) -> Study:
        """The study of what was read from a file."""
        study = cls.__new__(cls)
        study.quantities, study.model, study.source = data.quantities, data.model, Path(data.path).name
        study.fit, study.correlation, study.rise, study.state = data.fit, data.correlation, data.rise, data.state
        return study

    def changed(self, after: Mapping[str, float]) -> Study:
        """The study of another design: a quantity that changes keeps its tolerance as a share of its value, an angle as it is."""
        new = {name: self.quantities[name].scaled(value, self.si(name) != "rad") for name, value in after.items()}
        return self.with_quantities({**self.quantities, **new})

    def with_quantities(self, quantities: Mapping[str, Measured]) -> Study:
        """The study of the same file with other quantities."""
        study = Study.__new__(Study)
        study.quantities = quantities
        study.model, study.source, study.fit, study.correlation = self.model, self.source, self.fit, self.correlation
        study.rise, study.state = self.rise, self.state
        if study.rise is not None:
            rises.check(study.rise, study.values)
        return study

    source: str
    model: str
    fit: FrictionFit | None
    correlation: Correlation
    rise: Rise | None
    state: Mapping[str, float]

    @property
    def unbounded(self) -> tuple[str, ...]:
        """Quantities of whose distribution a part lies beyond ``low`` and ``high``."""
        return tuple(name for name in self.tolerances if not self.quantities[name].cut)

    # ------------------------------------------------------------------------------------------------- the operating point

    @property
    def about(self) -> Mapping[str, Any]:
        """``model.json`` of the model."""
        return brake_quantities.about(self.model)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the model's coordinates."""
        return tuple(entry["name"] for entry in self.about["coordinates"])

    @cached_property
    def scales(self) -> Scales:
        """Scales of length, time and force."""
        return Scales(**brake_quantities.dimensionless(self.model, self.values)[1])

    @property
    def values(self) -> dict[str, float]:
        """The values in SI by name."""
        return {name: one.value for name, one in self.quantities.items()}

    @cached_property
    def dimensionless(self) -> Any:
        """The dimensionless parameters at the operating point, with the friction μ₀."""
        return self.placed(brake_quantities.dimensionless(self.model, self.values)[0])

    def placed(self, p: Any) -> Any:
        """A set of parameters that follows the state that was chosen, if one was."""
        units = brake_quantities.bases(self.model, self.values)
        si = {entry["name"]: entry["unit"] for entry in self.about["coordinates"]}
        near = {name: value / brake_quantities.scale_of(si.get(name, "1"), units) for name, value in self.state.items()}
        return p.following(**near) if near else p

    @cached_property
    def at_work(self) -> Any:
        """The same with the μ₀ with which statics has the friction that works, where the model has one."""
        p = self.dimensionless
        return p.replace(mu0=self.fraction * p.mu0) if "mu0" in p.model.parameters else p

    @cached_property
    def moves(self) -> bool:
        """Whether all that the motion in time depends on is known; a file may leave out V and d."""
        return {entry["quantity"] for entry in self.about["parameters"]} <= set(self.quantities)

    @property
    def belt(self) -> str | None:
        """The quantity that is the speed of the belt, whatever the page calls it; None where none alone is that."""
        law = self.about["friction"]
        names = {entry["name"]: entry["quantity"] for entry in self.about["parameters"]}
        return names.get(law["belt"]) if law else None

    @cached_property
    def fraction(self) -> float:
        """The share of μ₀ at which friction works at the speed of the belt; 1 where that is not known."""
        from . import friction

        return friction.share(self)

    @cached_property
    def friction(self) -> tuple[float, float, float]:
        """The friction that works: least, at the operating point, and largest within the tolerances; by the model's law."""
        from . import friction

        return friction.working(self)

    @property
    def tolerances(self) -> dict[str, float]:
        """Half of the width of every quantity that has one, in SI."""
        return {name: one.tolerance for name, one in self.quantities.items() if one.high > one.low}

    def at_full_slip(self) -> Study:
        """The study without the belt's speed: friction is μ₀."""
        left_out = brake_quantities.of_the_law(self.model)
        return self.with_quantities({name: one for name, one in self.quantities.items() if name not in left_out})

    def together(self, names: Sequence[str]) -> Dependence:
        """How some of the quantities vary together."""
        return dependence(names, {pair: value for pair, value in self.correlation.items() if set(pair) <= set(names)})

    def shown(self, name: str, value: float, digits: int = 4) -> str:
        """A value of a quantity as text, in the unit in which it came."""
        return shown_in(value, self.quantities[name].unit, self.si(name), digits)

    def shown_speed(self, speed: float, digits: int = 4) -> str:
        """A speed of the belt as text, by the name of the page: ``V = 1.2 m/s``."""
        return (
            f"a speed of {speed:.{digits}g} m/s" if self.belt is None else f"{self.belt} = {self.shown(self.belt, speed, digits)}"
        )

    def in_file(self, name: str, value: float) -> float:
        """A value of a quantity in the unit in which it came."""
        return value / factor(self.quantities[name].unit, self.si(name))

    def unit_of(self, si: str, name: str = "") -> tuple[str, float]:
        """The unit of this file for an SI unit, that of a quantity if it is there, and what one of the model's is in it."""
        here = name if name in self.quantities else next((other for other in self.quantities if self.si(other) == si), "")
        unit = self.quantities[here].unit if here else PLAIN_UNITS.get(si, si)
        return unit, brake_quantities.scale_of(si, brake_quantities.bases(self.model, self.values)) / factor(unit, si)

    @property
    def si_units(self) -> Mapping[str, str]:
        """The SI unit of each quantity that the model takes."""
        return brake_quantities.quantity_units(self.model)

    def si(self, name: str) -> str:
        """The SI unit of a quantity."""
        return self.si_units[name]

    # ---------------------------------------------------------------------------------------------------------- the answers

    def report(
        self, *, probability: bool = True, redesign: bool = True, oscillation: bool = True, safety: float = 1.2,
        n: int | None = None, progress: bool = False,
    ) -> Report:  # fmt: skip
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
        from . import reports

        safety = as_number("safety", safety, POSITIVE)
        return reports.report(
            self, probability=probability, redesign=redesign, oscillation=oscillation, safety=safety, n=n, progress=progress
        )

    def to_html(self, path: str | os.PathLike[str], report: Report | None = None) -> None:
        """Write the report as one page with its pictures, which needs no other file (extra ``plot``)."""
        from .pages import write_page

        write_page(self, self.report() if report is None else report, Path(path))

    def __repr__(self) -> str:
        return f"Study({', '.join(f'{name}={self.shown(name, one.value)}' for name, one in self.quantities.items())})"


def _given(parameters: Any, model: str, ranges: Mapping[str, Range]) -> dict[str, float]:
    """Quantities in SI by name, checked."""
    if isinstance(parameters, PhysicalParameters) and model == USUAL:
        if parameters.shape:
            raise ParameterError(f"parameters have the shape {parameters.shape}; a study is of one brake, so give single numbers")
        both = ((name, getattr(parameters, name)) for name in ranges)
        return {name: float(value) for name, value in both if value is not None}
    if not isinstance(parameters, Mapping):
        raise ParameterError(
            f"parameters = {type(parameters).__name__}(...): a study needs PhysicalParameters, in newtons and metres, or with "
            "model= a mapping; for dimensionless ones call jump_value, jump_margin, certify and jump_probability"
        )
    for name in parameters:
        if name not in ranges:
            remark = hint(name, ranges) or f"; it has {', '.join(ranges)}"
            raise ParameterError(f"parameters: {name!r} is no quantity of {model}{remark}")
    missing = [name for name in ranges if name not in parameters and name not in brake_quantities.of_the_law(model)]
    if missing:
        raise ParameterError(f"parameters are without {', '.join(missing)}; give them in SI units")
    return {name: as_number(name, value, ranges[name]) for name, value in parameters.items()}


def _measured(name: str, value: float, off: Any, si: str, allowed: Range) -> Measured:
    unit = PLAIN_UNITS.get(si, si)
    if off is None:
        low = high = value
    elif isinstance(off, str):
        if not off.lstrip().startswith("["):
            return replace(read(_around(value, off, si), si, allowed), value=value, unit=unit)
        ends = read(off, si, allowed)
        return replace(ends, value=value if ends.low <= value <= ends.high else ends.value, unit=unit)
    elif isinstance(off, tuple):
        if len(off) != 2:
            raise ParameterError(f"tolerance of {name} = {off!r}; give two ends, the smaller first")
        low, high = (as_number(f"tolerance of {name}", end, allowed) for end in off)
        if not low <= high:
            raise ParameterError(f"tolerance of {name} = {off!r} begins above its end; give the smaller first")
        value = 0.5 * low + 0.5 * high if not low <= value <= high else value
    else:
        width = abs(as_number(f"tolerance of {name}", off))
        low, high = value - width, value + width
    for end in (low, high):
        if not allowed.contains(end):
            raise ParameterError(f"tolerance of {name} = {off!r} reaches {end:g}, which is not in {allowed}; give a smaller one")
    return Measured(value, low, high, unit)


def _around(value: float, off: str, si: str) -> str:
    """``value ± off`` as :func:`spragsym.report.units.read` takes it."""
    sign = "" if off.lstrip().startswith(("±", "+-", "+/-", "+\N{MINUS SIGN}", "sd ")) else "± "
    return f"{np.format_float_positional(value, trim='0')} {'' if si == '1' else si} {sign}{off}"
