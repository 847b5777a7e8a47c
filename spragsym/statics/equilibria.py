"""All equilibria of any model, and how many there are: the public functions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..core.errors import ConvergenceError
from ..core.questions import Method, question
from ..models.parameters import ParameterSet, Ranges
from ..numerics.interval_arrays import Int8Array
from ..results import Equilibria

if TYPE_CHECKING:
    from .options import SearchOptions


@question
def equilibria(
    p: ParameterSet,
    contact: bool | Sequence[str] | None = None,
    within: Ranges | None = None,
    *,
    options: SearchOptions | None = None,
    method: Method = "auto",
) -> Equilibria:
    """All equilibria: steady sliding in contact, or at rest in lift-off, each proved, with its
    stability.

    Parameters
    ----------
    p : Parameters
        Of any model, of any shape; θ₀ and μ₀ of the article's model are needed.
    contact : bool or sequence of str, optional
        True for states with a gap ≤ 0, False for states with a gap ≥ 0 without the contact's force:
        n̄ = 1 and n̄ = 0 of the article. Of several contacts, that open, True is for all of them,
        False for none, and names are for these and no others, as ``("front",)``. Left out, states
        in which at least one touches: each combination is searched and proved on its own, and the
        column ``touching`` says which it is. A contact that presses on either of two faces, as in
        a slot, rubs with the size of N: True is for states with N ≥ 0, False for those with N ≤ 0,
        left out both are searched.
    within : mapping, optional
        Ranges of coordinates that are searched, as ``{"x": (-5.0, 5.0)}``. Without it a box that is
        proved to hold all of them; where there is no such proof, ten times the largest length that
        the model has at these parameters, or that Newton's method comes to rest at.
    options : SearchOptions, optional
        Tolerances and limits of the search, which asks for it where a closed form would answer.
    method : {"auto", "closed", "search"}
        A closed form if the model brings one, the closed form only, or the search.

    Returns
    -------
    Equilibria
        Of the article's model one or three in contact, up to four in lift-off, with |error| ≤ 1e-12
        max(1, |value|). Points of an array that have no answer are not ``decided``. On a belt that
        stands still nothing slides: where friction holds the mass, :func:`spragsym.sticking_states`
        has all states of rest.

    Raises
    ------
    ParameterError, ParameterTypeError
        For arguments that make no sense.
    ConvergenceError
        For a single point of the article's model on a border that no number of digits can settle,
        as where L = 0, or whose length or displacement float64 can't carry.

    Notes
    -----
    Source: branch and prune over boxes of coordinates and of parameters, see
    :mod:`spragsym.numerics.boxes`, in a region with all equilibria since the springs pull back
    harder than all else pushes, see :mod:`spragsym.statics.regions`. A stiff spring is looked at in
    its angle and tension, see :mod:`spragsym.statics.polar`. What float64 does not decide is
    reduced to one unknown and decided with many digits, see :mod:`spragsym.numerics.precise_roots`.
    Of the article's model: the quartic in t = tan(θ/2) of f(θ) = q sin θ F_x, (12)–(13) eliminated,
    and stability by (27)–(28), see :mod:`spragsym.kang_nam.quartic.solver`.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> eq = ss.equilibria(ss.Parameters.article(theta0=np.radians([30.0, 49.0])))
    >>> eq.count
    array([3, 1], dtype=int8)
    >>> eq.undamped[0]
    array([1, 2, 1], dtype=int8)
    >>> print(np.round(eq.x[1], 6))
    [1.217424      nan      nan]
    >>> eq = ss.equilibria(ss.load("cubic_contact").Parameters(theta0=np.radians([30.0, 60.0])))
    >>> eq.count.tolist(), eq.complete
    ([3, 1], True)
    """
    from .search import equilibria_by_search  # where a closed form answers nothing of it is loaded

    return equilibria_by_search(p, contact, within, options)


@question
def count(p: ParameterSet, *, method: Method = "auto") -> Int8Array:
    """The number of equilibria in contact of every point; for the article's model without solving
    for the states.

    Parameters
    ----------
    p : Parameters
        Of any model, of any shape.
    method
        As for :func:`equilibria`.

    Returns
    -------
    ndarray
        Of the shape of ``p``.

    Raises
    ------
    ConvergenceError
        Where a point is not decided.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> ss.count(ss.Parameters.article(theta0=np.radians([30.0, 49.0])))
    array([3, 1], dtype=int8)
    """
    found = equilibria(p)
    if not found.complete:
        raise ConvergenceError(
            f"how many there are is not known: {'; '.join(found.remarks)}; equilibria(p) has "
            "those that are"
        )
    return found.count
