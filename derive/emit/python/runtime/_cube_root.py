"""The cube root that the C target has, bit for bit: libraries' differ from machine to machine.

@header@
"""

from typing import Any

import numpy
import numpy.typing as npt

__all__ = ["cube_root"]


def cube_root(x: npt.ArrayLike) -> npt.NDArray[Any]:
    """Cube root of x > 0, 0 of 0: of doubles a third of the exponent by the bits, then Halley's
    method; of others NumPy's.
    """
    given = numpy.asarray(x)
    if given.dtype != numpy.float64:
        return numpy.cbrt(x)
    third = given.view(numpy.uint64) >> 2
    third = third + (third >> 2)
    third = third + (third >> 4)
    third = third + (third >> 8)
    root = (third + numpy.uint64(3071306043645493248)).view(numpy.float64)
    for _ in range(3):
        cube = root * root * root
        root = root * ((cube + 2.0 * given) / (2.0 * cube + given))
    return numpy.where(given > 0.0, root, 0.0)
