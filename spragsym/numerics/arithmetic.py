"""What every number type makes of its sum, its product and its change of sign."""

from collections.abc import Sequence
from typing import Any, Self, TypeAlias

#: Rows of entries of any number type.
Matrix: TypeAlias = Sequence[Sequence[Any]]


class Arithmetic:
    """A base of number types: operations with what stands on the left, and differences.

    Each type says the first three itself. It is no abstract class: ``isinstance`` of one takes three times as long, and stands
    in every operation.
    """

    __slots__ = ()

    def __neg__(self) -> Self:
        raise NotImplementedError

    def __add__(self, other: Any) -> Self:
        raise NotImplementedError

    def __mul__(self, other: Any) -> Self:
        raise NotImplementedError

    def __pos__(self) -> Self:
        return self

    def __radd__(self, other: Any) -> Self:
        return self.__add__(other)

    def __rmul__(self, other: Any) -> Self:
        return self.__mul__(other)

    def __sub__(self, other: Any) -> Self:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> Self:
        return (-self).__add__(other)
