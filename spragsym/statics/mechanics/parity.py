"""Mirror symmetries: coordinates that may change sign with all forces following; parity as a number type of the algebra."""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import Any

from .balance import Balance
from .forces import Values

#: Functions that are even, and functions that are odd.
EVEN, ODD = ("cos", "cosh"), ("sin", "sinh", "tanh", "atan")


class Parity:
    """A number that changes its sign (``odd``), does not, or does neither (None); numbers beside it are even, and 0 is both."""

    __slots__ = ("odd",)
    __array_ufunc__ = None

    def __init__(self, odd: bool | None) -> None:
        self.odd = odd

    def _with(self, other: Any) -> Parity:
        if not isinstance(other, Parity):
            return self if other == 0 or self.odd is False else Parity(None)
        return self if self.odd == other.odd else Parity(None)

    __add__ = __radd__ = __sub__ = __rsub__ = _with

    def __neg__(self) -> Parity:
        return self

    def __mul__(self, other: Any) -> Any:
        if not isinstance(other, Parity):
            return self if other != 0 else 0
        return Parity(None if None in (self.odd, other.odd) else self.odd != other.odd)

    __rmul__ = __mul__
    __truediv__ = __mul__

    def __rtruediv__(self, other: Any) -> Any:
        return self * other

    def __pow__(self, power: int) -> Parity:
        return Parity(self.odd and power % 2 == 1) if self.odd is not None else self


class _Functions:
    pi = 3

    def __getattr__(self, name: str) -> Callable[..., Parity]:
        def parity(*values: Any) -> Parity:
            known = [value.odd if isinstance(value, Parity) else False for value in values]
            if None in known or len(known) > 1 or (known[0] and name not in EVEN + ODD):
                return Parity(False if not any(odd is not False for odd in known) else None)
            return Parity(known[0] and name in ODD)

        return parity


def follows(balance: Balance, values: Values, odd: Collection[int]) -> bool:
    """Whether the rows of these coordinates, and no others, change their signs with them; the gap does not."""
    xp: Any = _Functions()
    q = [Parity(i in odd) for i in range(balance.n)]
    given = {name: 0 if isinstance(value, int) and value == 0 else Parity(False) for name, value in values.items()}
    rows = balance.by_coordinate("forces", q, balance.plain_directions(q, given, xp), given, xp)
    gap = balance.gap(q, given, xp) if balance.opens else 0
    wanted = [*((row, i in odd) for i, row in enumerate(rows)), (gap, False)]
    return all((row.odd is side) if isinstance(row, Parity) else (row == 0 or not side) for row, side in wanted)
