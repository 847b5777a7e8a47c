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
        n̄ = 1 and n̄ = 0 of the article. With several contacts that open, True means that all
        touch, False that none does, and names, as ``("front",)``, that these touch and no others.
        Left out, all states in which some contact touches: each combination is searched and
        proved on its own, and the column ``touching`` names it. A contact that presses on either of
        two faces, as in a slot, has friction μ |N|: True is for states with N ≥ 0, False for those
        with N ≤ 0; left out, both are searched.
    within : mapping, optional
        Ranges of coordinates to search, as ``{"x": (-5.0, 5.0)}``. By default a box that is proved
        to hold all equilibria or, where there is no such proof, ten times the largest length of the
        model at these parameters or of a state to which Newton's method converges.
    options : SearchOptions, optional
        Tolerances and limits of the search. If given, the search answers instead of a closed form.
    method : {"auto", "closed", "search"}
        A closed form if the model has one and else the search; only the closed form; or only the
        search.

    Returns
    -------
    Equilibria
        The article's model has one or three in contact, up to four in lift-off, with |error| ≤
        1e-12 max(1, |value|). Points of an array without an answer are not ``decided``. On a belt
        at rest nothing slides: where friction holds the mass, :func:`spragsym.sticking_states` has
        all states of rest.

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
    :mod:`spragsym.numerics.boxes`, in a region that is proved to hold all equilibria, see
    :mod:`spragsym.statics.regions`. Near a stiff spring, its angle and tension are the unknowns,
    see :mod:`spragsym.statics.polar`. Clusters that float64 does not decide are reduced to one
    unknown and decided in ball arithmetic, see :mod:`spragsym.numerics.precise_roots`. The
    article's model: the quartic in t = tan(θ/2) of f(θ) = q sin θ F_x, with (12)–(13) eliminated,
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
    from .search import equilibria_by_search  # not loaded where a closed form answers

    return equilibria_by_search(p, contact, within, options)


@question
def count(p: ParameterSet, *, method: Method = "auto") -> Int8Array:
    """The number of equilibria in contact at every point.

    The article's model needs no solution for it.

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
