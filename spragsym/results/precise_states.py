"""Results to any number of digits: equilibria and cusps, with their numbers in decimals."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from fractions import Fraction
from typing import Any

import mpmath

from ..models.parameters import Ranges
from ..numerics.decimals import Decimal, exactly, rounded_decimal
from .equilibria import EquilibriumType


@dataclass(frozen=True, repr=False)
class Written(ABC):
    """Numbers by name, which are attributes too; ``repr`` writes them in decimals."""

    numbers: Mapping[str, mpmath.mpf]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the numbers."""
        return tuple(self.numbers)

    def __getattr__(self, name: str) -> mpmath.mpf:
        if name == "numbers" or name not in self.numbers:  # the first while it is being unpickled
            raise AttributeError(name)
        return self.numbers[name]

    @abstractmethod
    def _bound(self, value: mpmath.mpf) -> Fraction:
        """A bound on the error of a number."""

    def decimals(self, digits: int | None = None) -> dict[str, Decimal]:
        """The numbers in decimals, each with a bound on its error that includes the rounding.

        ``digits`` is the number of significant digits, by default as many as are proved.
        """
        return {
            name: rounded_decimal(value, self._bound(value), digits)
            for name, value in self.numbers.items()
        }

    def __repr__(self) -> str:
        numbers = [f"{name}={decimal}" for name, decimal in self.decimals().items()]
        others = [
            f"{field.name}={getattr(self, field.name)!r}"
            for field in fields(self)
            if field.name not in ("numbers", "error", "radius") and getattr(self, field.name) != ""
        ]
        return f"{type(self).__name__}({', '.join([*numbers, *others])})"


@dataclass(frozen=True, repr=False)
class PreciseEquilibrium(Written):
    """One equilibrium; ``error`` is a proved bound on |error| / max(1, |value|) of all of its
    numbers as they stand.

    ``numbers`` are mpmath numbers by name, each an attribute too: angle in radians and length of
    each inclined spring, ``theta`` and ``L`` where there is one, ``theta_1``, ``L_1``, … where
    there are several, then the coordinates. ``print`` writes decimals with bounds that hold for
    these digits, and so does :meth:`decimals`. ``fold`` says that it is a fold to the last digit
    that could be tried; only then may ``error`` be above 10^−dps. ``touching`` names the contacts
    that touch, of several.
    """

    undamped: EquilibriumType
    error: mpmath.mpf
    fold: bool = False
    touching: str = ""

    def _bound(self, value: mpmath.mpf) -> Fraction:
        return exactly(self.error) * max(Fraction(1), abs(exactly(value)))


@dataclass(frozen=True)
class PreciseEquilibria(Sequence[PreciseEquilibrium]):
    """All equilibria of one point, a sequence of them.

    Attributes
    ----------
    states : tuple of PreciseEquilibrium
        Ascending in ``theta`` by the article's closed forms, in the first coordinate by search.
    complete : bool
        Whether it is proved that these are all.
    region : mapping of str to (float, float)
        The box that was searched, by coordinate; empty where no box is needed.
    """

    states: tuple[PreciseEquilibrium, ...]
    complete: bool
    region: Ranges

    def __getitem__(self, index: int | slice) -> Any:
        return self.states[index]

    def __len__(self) -> int:
        return len(self.states)


@dataclass(frozen=True, repr=False)
class PreciseCusp(Written):
    """One cusp; ``radius`` bounds |error| of each of its numbers as they stand, angles in radians.

    ``numbers`` are the two parameters that vary and then those of an equilibrium, each an attribute
    too. ``versal`` says that it is one in the sense of catastrophe theory: of third order, and
    unfolded by the two parameters, both proved.
    """

    radius: mpmath.mpf
    versal: bool

    def _bound(self, _: mpmath.mpf) -> Fraction:
        return exactly(self.radius)


@dataclass(frozen=True)
class CuspProof(Sequence[PreciseCusp]):
    """Cusps, and why there are no more.

    Attributes
    ----------
    cusps : tuple of PreciseCusp
        Those in contact with L > 0, sorted by the second of the parameters that vary, ``mu0``
        unless told otherwise.
    complete : bool
        Whether it is proved that these are all: everywhere by the polynomial, in ``region`` by
        search.
    region : mapping of str to (float, float)
        The box that was searched, by coordinate and parameter; empty where the polynomial answers.
    polynomial : tuple of Fraction
        Lowest power first; its roots s = sin θ in [−1, 1] (without ±1 for α = 0) are all cusps.
        Empty for α = 1 + β, where 3 s² = 2 instead, and by search.
    sines : tuple of (Fraction, Fraction)
        Disjoint intervals, each proved to hold one of its real roots.
    count : int or None
        Number of different real roots there by Descartes' rule of signs: the proof. None without a
        polynomial.
    """

    cusps: tuple[PreciseCusp, ...]
    complete: bool
    region: Ranges
    polynomial: tuple[Fraction, ...] = ()
    sines: tuple[tuple[Fraction, Fraction], ...] = ()
    count: int | None = None  # type: ignore[assignment]  # not Sequence's count

    def __getitem__(self, index: int | slice) -> Any:
        return self.cusps[index]

    def __len__(self) -> int:
        return len(self.cusps)
