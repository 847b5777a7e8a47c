"""The rule by which dry frictions go on from one instant, written once for every target language.

In the small language of :mod:`.language`.

A target adds the candidates, in the order in which they are tried: those first in which fewest
frictions slip, and of each the sides 0 (it sticks), 1 and −1, that of the last on the page changing
fastest. Of two that are alike the earlier one is chosen.
"""

from .language import Flag, Real, absolute, where

#: Changes of the accelerations that differ by less than this share are equal.
TIE = 1e-9
INFINITY = float("inf")


def lacks(side: Real, ahead: Real, behind: Real, rate: Real) -> Real:
    """The share of its limit that a friction lacks for a mode to agree with its own accelerations;
    0 where it agrees.

    One that sticks, side 0, must be within its limits; margins to these are ``ahead`` and
    ``behind``. One that slips must be unable to stick, or be driven the way it slips: ``rate`` is
    the derivative of its sliding speed in time.
    """
    nearer = where(ahead < behind, ahead, behind)
    farther = where(ahead < behind, behind, ahead)
    driven = where(ahead < behind, 1.0, -1.0)
    # in lift-off these are -F and F
    sticks = (nearer >= 0.0) & (farther > 0.0)
    agrees = (side == where(sticks, 0.0, driven)) | (sticks & (side * rate > 0.0))
    missing = absolute(where(side == -driven, farther, nearer))
    width = ahead + behind
    share = where(width > 0.0, missing / where(width > 0.0, width, 1.0), INFINITY)
    return where(agrees, 0.0, share)


def displaces(
    slips: Real, lack: Real, change: Real, of_slips: Real, of_lack: Real, of_change: Real
) -> Flag:
    """Whether a mode is chosen in place of an earlier one, of which the last three numbers are.

    One that agrees is; of two that agree that in which fewer frictions slip, then that in which the
    accelerations change less; of two that do not that which lacks less. ``change`` is ΔᵀM Δ of the
    change Δ of the accelerations from the mode before, at the start of a motion from 0.
    """
    agrees = lack == 0.0
    closer = (slips == of_slips) & (change * (1.0 + TIE) < of_change)
    return where(of_lack == 0.0, agrees & ((slips < of_slips) | closer), lack < of_lack)
