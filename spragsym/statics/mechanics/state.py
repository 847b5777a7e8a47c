"""One evaluation of a model at a state, of any number type: forces, matrices of the linearization, and the gap."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from ...numerics.arithmetic import Matrix
from ...numerics.interval_arrays import Shape
from .balance import Balance
from .forces import Values
from .laws import XP


@dataclass
class State:
    """Coordinates, directions, arguments of one evaluation, all of one number type, and what follows from them."""

    balance: Balance
    q: Sequence[Any]
    values: Values
    shape: Shape
    upright: Sequence[int] = ()
    xp: Any = XP
    sides: Sequence[int] | None = None

    @cached_property
    def directions(self) -> list[Any]:
        """Cosine, sine and length of every spring, and turnings."""
        if self.xp is XP:
            return self.balance.directions(self.q, self.values, self.shape, self.upright, self.sides)
        return self.balance.plain_directions(self.q, self.values, self.xp)

    def forces(self) -> Sequence[Any]:
        """Rows of the balance."""
        return self.balance.call("forces", self.q, self.directions, self.values, self.xp)

    def slopes(self) -> Matrix:
        """Derivatives of the rows of the balance: det K is their determinant, and K v is 0 where theirs is."""
        return self._slopes

    @cached_property
    def _slopes(self) -> Matrix:
        return self.balance.call("forces_jacobian", self.q, self.directions, self.values, self.xp)

    def stiffness(self) -> Matrix:
        """The stiffness matrix K."""
        if not self.balance.sums:
            return self._slopes
        return self.balance.by_coordinate("forces_jacobian", self.q, self.directions, self.values, self.xp)

    def gap(self) -> Any:
        """The gap of the contact."""
        return self.balance.gap(self.q, self.values, self.xp)

    def mass(self) -> Matrix:
        """The mass matrix M."""
        return self.balance.mass(self.q, self.values, self.xp)

    def damping(self) -> Matrix:
        """C: dampers and slope of the friction law."""
        return self.balance.damping(self.q, self.directions, self.values, xp=self.xp)

    def slope(self) -> Any:
        """Slope of the friction law."""
        return self.balance.slope(self.values, self.xp)
