"""The flow of a field: states carried on by an integrator, with derivatives and without."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..models.field import Field
from ..models.parameters import FloatArray
from . import integrators
from .lobatto import PiecewisePolynomial
from .problem import StiffError
from .segment import Fly, Passage
from .solution import Solution
from .with_heyoka import taylor_of
from .with_scipy import IMPLICIT, Flight

#: Tolerance by which SciPy follows a motion to where Newton's method can begin.
LOOSE = 1e-9


@dataclass(frozen=True)
class Flow:
    """A field and an integrator; ``other`` carries derivatives in the integrator's place."""

    field: Field
    backend: str
    other: Fly | None = None

    @classmethod
    def of(cls, field: Field, backend: str | None) -> Flow:
        """The flow of a field by a backend that takes any model."""
        return cls(field, integrators.choose(backend, integrators.OF_ANY_MODEL))

    def _by(self, derivatives: bool) -> Any:
        return taylor_of(self.field, derivatives) if self.backend == "heyoka" else Flight(self.field, derivatives)

    def fly(
        self, state: FloatArray, constants: tuple[float, ...], duration: float, directions: FloatArray | None = None
    ) -> Passage:  # fmt: skip
        """Carry a state on for a while, with derivatives by it and along ``directions`` of the parameters, shape (2, P)."""
        if directions is None:
            directions = np.zeros((2, len(self.field.parameters)))
        return (self.other or self._by(True).fly)(state, constants, duration, directions)

    def plain(
        self, state: FloatArray, constants: tuple[float, ...], duration: float, _: object = None, *, loose: bool = False
    ) -> Passage:  # fmt: skip
        """Carry a state on without derivatives; ``loose``: only as accurately as Newton's method needs to begin."""
        carrier = Flight(self.field, False, rtol=LOOSE) if loose and self.backend == "scipy" else self._by(False)
        return carrier.fly(state, constants, duration, np.zeros((2, len(self.field.parameters))))

    @property
    def without(self) -> Flow:
        """This flow without derivatives."""
        return replace(self, other=self.plain)

    def samples(self, start: FloatArray, constants: tuple[float, ...], t_end: float) -> PiecewisePolynomial:
        """A motion by its samples; by an implicit method where steps collapse."""
        try:
            solution: Solution = self._by(False).motion(start, constants, t_end)
        except StiffError:
            solution = Flight(self.field, False, 0, IMPLICIT, stiff=True).motion(start, constants, t_end)
        return solution.samples
