"""The choice between numbers by a flag, without a branch: NumPy's own takes four times as long
where flags are hard to guess.

@header@
"""

from typing import Any

import numpy

__all__ = ["where"]

#: Of so few numbers, or so few by either flag in every number, NumPy's own choice is faster.
_MANY, _RARE = 1024, 1 / 16


def where(flag: Any, one: Any, other: Any) -> Any:
    """As ``numpy.where``, bit for bit; of many doubles with mixed flags by their bits, ((one ^
    other) & mask) ^ other.
    """
    if (
        _is_mixed(flag)
        and (ones := _bits(one)) is not None
        and (others := _bits(other)) is not None
    ):
        mask, change = (
            numpy.negative(flag.view(numpy.int8)).astype(numpy.int64),
            ones ^ others,
        )  # all bits set, or none
        chosen = numpy.bitwise_and(mask, change, out=mask if mask.shape == change.shape else None)
        chosen ^= others
        return chosen.view(numpy.float64)
    return numpy.where(flag, one, other)


def _is_mixed(flag: Any) -> bool:
    if not isinstance(flag, numpy.ndarray) or flag.size < _MANY:
        return False
    share = float(numpy.count_nonzero(flag)) / flag.size
    return _RARE < share < 1 - _RARE


def _bits(value: Any) -> Any:
    """Doubles as integers of 64 bits; None of anything else."""
    if isinstance(value, float):
        return numpy.float64(value).view(numpy.int64)
    if isinstance(value, numpy.ndarray) and value.dtype == numpy.float64:
        return value.view(numpy.int64)
    return None
