"""A cell with one root of a polynomial, narrowed to as many bits as wanted: each step doubles the digits that are right."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple


class Cell(NamedTuple):
    """One root in the open interval (n, m)/2^k, or at n/2^k = m/2^k.

    ``above`` is the polynomial's sign between the root and m/2^k; of a root that is known it is not asked.
    """

    n: int
    m: int
    k: int
    above: int = 0


def refine(
    cell: Cell,
    value: Callable[[int, int], Any],
    sign: Callable[[Any], int],
    share: Callable[[Any, Any, int], int],
    lacking: Callable[[int, int], int],
) -> Cell:
    """The same root in a cell that lacks nothing and whose ends are no roots, or the root itself.

    The secant's guess is tried on a grid of 2^j parts of the cell, j twice as large where it is right, else half.

    Parameters
    ----------
    cell : Cell
        With m = n + 1; one of a root that is known is returned as it is.
    value : callable
        Of n and k: the polynomial at n/2^k, up to a positive factor that depends on k only.
    sign : callable
        Of a value. Only an exact one may be 0; for others this raises.
    share : callable
        Of values at both ends, and j: about the part of 2^j, from 0 to 2^j − 1, in which the chord crosses zero.
    lacking : callable
        Of n and k: how many times (n, n + 1)/2^k has to be halved yet; at most 0 if never.

    Notes
    -----
    Source: quadratic interval refinement, J. Abbott (2006).
    """
    n, m, k, above = cell
    if n == m:
        return cell
    low, high = value(n, k), value(n + 1, k)
    j = 1
    while True:
        open_ends = sign(low) != 0 and sign(high) != 0  # else another root sits on an end
        wanted = lacking(n, k)
        if wanted <= 0 and open_ends:
            return Cell(n, n + 1, k, above)
        j = min(j, wanted) if open_ends else 1
        guess = (n << j) + (1 if j == 1 else share(low, high, j))
        middle = value(guess, k + j)
        side = sign(middle)
        if side == 0:
            return Cell(guess, guess, k + j)
        left = side == above
        other = value(guess - 1 if left else guess + 1, k + j)
        if j == 1 or sign(other) == -side:
            n, k, j = guess - 1 if left else guess, k + j, 2 * j
            low, high = (other, middle) if left else (middle, other)
        else:
            j //= 2
