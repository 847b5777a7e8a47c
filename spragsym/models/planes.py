"""What is asked of any model in the plane of two of its parameters, by its parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from ..parameters import ParameterSet

if TYPE_CHECKING:
    from .catastrophe.hopf_curves import OnsetCurves


def onset_curves(
    p: ParameterSet,
    vary: Sequence[str] = ("theta0", "mu0"),
    n: int = 30,
    *,
    between: Mapping[str, tuple[float, float]] | None = None,
) -> OnsetCurves:
    """Curves of Hopf points in the plane of two parameters, each point gentle or dangerous, and where curves end and change.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; those that vary are not used.
    vary : pair of str
        Two parameters.
    n : int
        Lines of either parameter on which all Hopf points are found and proved.
    between : mapping, optional
        Ranges of the two, as ``{"mu0": (0, 1)}``.

    Returns
    -------
    OnsetCurves
        ``curves``, each point with ``criticality``; ``points``, all those of the kinds BT, ZH and HH, proved; and ``changes``,
        where l₁ passes 0 along a curve (GH).

    Raises
    ------
    ParameterError
        For parameters that the model has not, or ranges that leave theirs.

    Notes
    -----
    Source: F = 0 and Hurwitz's determinant along 2 n lines; see :mod:`spragsym.models.catastrophe.hopf_curves`. A curve that
    closes between two lines is not seen.

    Examples
    --------
    >>> import spragsym as ss
    >>> p = ss.load("stick_slip").Parameters()
    >>> found = ss.onset_curves(p, ("V", "zeta"), between={"V": (0.0, 1.0), "zeta": (0.0, 2.0)})
    >>> len(found), sorted(set(found.curves[0].criticality.tolist()))
    (1, ['dangerous', 'gentle'])
    >>> found.changes["V"].round(4).tolist()  # where F‴ = 0, at (1 + √2) v_s
    [0.2414]
    """
    found: OnsetCurves = p.model.onset_curves(p, vary, n, between=between)
    return found
