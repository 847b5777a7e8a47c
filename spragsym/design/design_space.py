"""Designs as vectors: which quantities may change, in units of their tolerances, and the parameters of the model that follow."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..errors import ParameterError
from ..models.parameters import (
    NAMES,
    POSITIVE,
    FloatArray,
    Parameters,
    ParameterSet,
    PhysicalParameters,
    Range,
    as_number,
)

#: How close to an end of its range, over its value or its tolerance, a quantity is taken.
_CLEAR = 1e-9


@dataclass(frozen=True)
class Design:
    """One design, whatever its quantities are: ``given`` by name with their ``ranges``, and what they are for the model.

    ``parameters`` gives the model's own from the quantities, of any number type; ``made`` another design, of the caller's kind,
    from those that changed; ``of_model`` is the class of the model's sets. ``begins``, from the quantities, is where what rises
    begins in the model's units, if that differs among designs.
    """

    given: Mapping[str, Any]
    ranges: Mapping[str, Range]
    parameters: Callable[[Mapping[str, Any]], dict[str, Any]]
    made: Callable[[Mapping[str, float]], Any]
    of_model: type[ParameterSet]
    begins: Callable[[Mapping[str, Any]], Any] | None = None
    followed: Mapping[str, float] | None = None  #: coordinates near which the followed state begins

    def of(self, model: Any) -> Design:
        """The same design for the model without closed forms, or for the one that has them."""
        return replace(self, of_model=model.Parameters)


@dataclass(frozen=True)
class Space:
    """Designs around one: z = 0 is ``origin``, and a quantity changes by z times its ``scale``."""

    design: Design
    names: tuple[str, ...]
    origin: FloatArray
    scale: FloatArray

    @property
    def of_model(self) -> type[ParameterSet]:
        """The class of the model's sets."""
        return self.design.of_model

    @property
    def followed(self) -> Mapping[str, float] | None:
        """Coordinates near which the followed state begins; None for the reference state."""
        return self.design.followed

    def of(self, model: Any) -> Space:
        """The same designs for the model without closed forms, or for the one that has them."""
        return replace(self, design=self.design.of(model))

    def quantities(self, z: FloatArray) -> dict[str, Any]:
        """All quantities of designs z, of shape (…, number of names); those that don't change as they are."""
        values = self.origin + z * self.scale
        if not np.iscomplexobj(values):  # z at a limit, rounded
            low, high = self.limits()
            values = np.clip(values, self.origin + low * self.scale, self.origin + high * self.scale)
            least = [self.design.ranges[name].low for name in self.names]
            values = np.maximum(np.where((z <= low) & (low * self.scale == -self.origin), 0.0, values), least)
        return {**self.design.given, **{name: values[..., j] for j, name in enumerate(self.names)}}

    def parameters(self, z: FloatArray) -> dict[str, Any]:
        """Parameters of the model of designs z."""
        return self.design.parameters(self.quantities(z))

    def sets(self, z: FloatArray) -> ParameterSet:
        """The same as a set of the model, of the shape of z without its last axis."""
        p = self.design.of_model(**{name: np.broadcast_to(value, z.shape[:-1]) for name, value in self.parameters(z).items()})
        return p if self.followed is None else p.following(**self.followed)

    def begin(self, z: FloatArray, usual: float) -> Any:
        """Where what rises begins in designs z: as the design says, or as usual."""
        return usual if self.design.begins is None else self.design.begins(self.quantities(z))

    def slopes(self, z: FloatArray) -> dict[str, FloatArray]:
        """Slopes of each parameter by z at one design: by a complex step, exact to rounding."""
        step, out = 1e-100, {name: np.zeros(len(self.names)) for name in self.parameters(z)}
        for j in range(len(self.names)):
            moved = z.astype(complex)
            moved[j] += 1j * step
            for name, value in self.parameters(moved).items():
                out[name][j] = np.imag(value) / step
        return out

    def made(self, z: FloatArray) -> Any:
        """One design, of the kind of the first."""
        return self.design.made({name: float(value) for name, value in self.quantities(z).items() if name in self.names})

    def limits(self) -> tuple[FloatArray, FloatArray]:
        """The smallest and the largest z that each quantity allows."""
        low, high = np.empty(len(self.names)), np.empty(len(self.names))
        for j, name in enumerate(self.names):
            allowed = self.design.ranges[name]
            clear = _CLEAR * max(abs(float(self.origin[j])), float(self.scale[j]))
            low[j] = (allowed.low + (clear if allowed.open_low else 0.0) - self.origin[j]) / self.scale[j]
            high[j] = (allowed.high - clear - self.origin[j]) / self.scale[j]
        return np.minimum(low, 0.0), np.maximum(high, 0.0)


def space(
    base: ParameterSet | PhysicalParameters | Design, scale: Mapping[str, float] | None, change: Iterable[str] | None,
    what: str = "scale",
) -> Space:  # fmt: skip
    """The quantities named in ``change``, or all that have a scale; without a scale each is measured by its own value."""
    design = base if isinstance(base, Design) else _design(base)
    tolerances = dict(scale or {})
    names = tuple(tolerances if change is None else ([change] if isinstance(change, str) else change))
    for name in (*names, *tolerances):
        if name not in design.given:
            place = "scale" if name in tolerances else what
            raise ParameterError(f"{name!r} in {place} is not a quantity here; the quantities are {', '.join(design.given)}")
    if not names:
        raise ParameterError(f"{what} names no quantity that may change; name at least one of {', '.join(design.given)}")
    origin = np.array([as_number(name, design.given[name]) for name in names])
    if scale is None and (origin == 0).any():
        zero = names[int(np.flatnonzero(origin == 0)[0])]
        raise ParameterError(f"{zero} = 0 has no relative change; give scale with a tolerance for it")
    missing = [name for name in names if scale is not None and name not in tolerances]
    if missing:
        raise ParameterError(f"scale has no entry for {missing[0]!r}, which is to change; give its tolerance")
    sizes = [as_number(f"scale[{name!r}]", tolerances[name], POSITIVE) for name in names] if scale is not None else np.abs(origin)
    return Space(design, names, origin, np.asarray(sizes, dtype=float))


def _design(base: ParameterSet | PhysicalParameters) -> Design:
    """Design variables: the parameters of a set; of a brake all on which the jump depends where friction works fully."""
    if isinstance(base, PhysicalParameters):
        kind = base.kind
        return Design(base.known, kind.ranges(), kind.groups, lambda changed: replace(base, **changed), Parameters)
    names = NAMES if isinstance(base, Parameters) else tuple(base.ranges)
    given = dict(zip(names, base.scalars(*names), strict=True))
    return Design(given, base.ranges, dict, lambda changed: base.replace(**changed), type(base), followed=base.followed)
