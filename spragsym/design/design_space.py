"""Designs as vectors: which quantities may change, in units of their tolerances, and the parameters of the model that follow."""

from __future__ import annotations

import inspect
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from ..errors import ParameterError
from ..generated import scales as _scales
from ..parameters import (
    NAMES,
    POSITIVE,
    RANGES,
    FloatArray,
    Parameters,
    ParameterSet,
    PhysicalParameters,
    Range,
    as_number,
    range_of,
)

_groups = inspect.unwrap(_scales.dimensionless_groups)

#: Physical quantities that the dimensionless parameters depend on.
PHYSICAL = ("k", "k_x", "k_y", "k_c", "F_L", "L_0", "theta0", "mu0")
#: How close to an end of its range, over its value or its tolerance, a quantity is taken.
_CLEAR = 1e-9


@dataclass(frozen=True)
class Space:
    """Designs around one: z = 0 is ``origin``, and a quantity changes by z times its ``scale``."""

    base: ParameterSet | PhysicalParameters
    names: tuple[str, ...]
    origin: FloatArray
    scale: FloatArray

    def quantities(self, z: FloatArray) -> dict[str, Any]:
        """All quantities of designs z, of shape (…, number of names); those that don't change as they are."""
        values = self.origin + z * self.scale
        if not np.iscomplexobj(values):  # z at a limit, rounded
            low, high = self.limits()
            values = np.clip(values, self.origin + low * self.scale, self.origin + high * self.scale)
            values = np.maximum(
                np.where((z <= low) & (low * self.scale == -self.origin), 0.0, values), 0.0
            )  # no lower end is less
        return _given(self.base) | {name: values[..., j] for j, name in enumerate(self.names)}

    def parameters(self, z: FloatArray) -> dict[str, Any]:
        """Parameters of the model of designs z."""
        quantities = self.quantities(z)
        return dimensionless(quantities) if isinstance(self.base, PhysicalParameters) else quantities

    def sets(self, z: FloatArray) -> ParameterSet:
        """The same as a set of the model, of the shape of z without its last axis."""
        kind = Parameters if isinstance(self.base, PhysicalParameters) else type(self.base)
        return kind(**{name: np.broadcast_to(value, z.shape[:-1]) for name, value in self.parameters(z).items()})

    def slopes(self, z: FloatArray) -> dict[str, FloatArray]:
        """Slopes of each parameter by z at one design: by a complex step, exact to rounding."""
        step, out = 1e-100, {name: np.zeros(len(self.names)) for name in self.parameters(z)}
        for j in range(len(self.names)):
            moved = z.astype(complex)
            moved[j] += 1j * step
            for name, value in self.parameters(moved).items():
                out[name][j] = np.imag(value) / step
        return out

    def made(self, z: FloatArray) -> ParameterSet | PhysicalParameters:
        """One design, of the kind of ``base``."""
        values = {name: float(value) for name, value in self.quantities(z).items() if name in self.names}
        if isinstance(self.base, ParameterSet):
            return self.base.replace(**values)
        return PhysicalParameters(**{**_all_given(self.base), **values})

    def limits(self) -> tuple[FloatArray, FloatArray]:
        """The smallest and the largest z that each quantity allows."""
        low, high = np.empty(len(self.names)), np.empty(len(self.names))
        for j, name in enumerate(self.names):
            allowed = _range(self.base, name)
            clear = _CLEAR * max(abs(float(self.origin[j])), float(self.scale[j]))
            low[j] = (allowed.low + (clear if allowed.open_low else 0.0) - self.origin[j]) / self.scale[j]
            high[j] = (allowed.high - clear - self.origin[j]) / self.scale[j]
        return np.minimum(low, 0.0), np.maximum(high, 0.0)


def space(
    base: ParameterSet | PhysicalParameters, scale: Mapping[str, float] | None, change: Iterable[str] | None, what: str = "scale"
) -> Space:
    """The quantities named in ``change``, or all that have a scale; without a scale each is measured by its own value."""
    known = _names(base)
    tolerances = dict(scale or {})
    names = tuple(tolerances if change is None else ([change] if isinstance(change, str) else change))
    for name in (*names, *tolerances):
        if name not in known:
            place = "scale" if name in tolerances else what
            raise ParameterError(f"{name!r} in {place} is not a quantity here; the quantities are {', '.join(known)}")
    if not names:
        raise ParameterError(f"{what} names no quantity that may change; name at least one of {', '.join(known)}")
    given = _given(base)
    origin = np.array([as_number(name, given[name]) for name in names])
    if scale is None and (origin == 0).any():
        zero = names[int(np.flatnonzero(origin == 0)[0])]
        raise ParameterError(f"{zero} = 0 has no relative change; give scale with a tolerance for it")
    missing = [name for name in names if scale is not None and name not in tolerances]
    if missing:
        raise ParameterError(f"scale has no entry for {missing[0]!r}, which is to change; give its tolerance")
    sizes = [as_number(f"scale[{name!r}]", tolerances[name], POSITIVE) for name in names] if scale is not None else np.abs(origin)
    return Space(base, names, origin, np.asarray(sizes, dtype=float))


def _names(base: ParameterSet | PhysicalParameters) -> tuple[str, ...]:
    """Quantities that the jump depends on: of the article's model with friction that works fully."""
    if isinstance(base, PhysicalParameters):
        return PHYSICAL
    return NAMES if isinstance(base, Parameters) else tuple(base.ranges)


def _given(base: ParameterSet | PhysicalParameters) -> dict[str, Any]:
    if isinstance(base, ParameterSet):
        names = _names(base)
        return dict(zip(names, base.scalars(*names), strict=True))
    return {name: getattr(base, name) for name in PHYSICAL}


def _all_given(base: PhysicalParameters) -> dict[str, Any]:
    return {field.name: getattr(base, field.name) for field in fields(base)}


def _range(base: ParameterSet | PhysicalParameters, name: str) -> Range:
    if isinstance(base, ParameterSet):
        return base.ranges[name]
    return RANGES[name] if name in RANGES else range_of(name)


def dimensionless(values: Mapping[str, Any]) -> dict[str, Any]:
    """The six parameters from themselves, or from physical quantities, which the name of the contact's stiffness shows."""
    if "k_c" not in values:
        return {name: values[name] for name in NAMES}
    # Mass, speed and creep enter their own groups only.
    kappa, alpha, sigma, beta, *_ = _groups(
        1.0, values["k_c"], values["L_0"], values["F_L"], values["k_x"], values["k"], values["k_y"], 0.0, 0.0
    )
    return dict(zip(NAMES, (values["theta0"], values["mu0"], kappa, alpha, sigma, beta), strict=True))
