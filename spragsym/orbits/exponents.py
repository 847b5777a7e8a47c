"""Lyapunov exponents of a motion: what it is, as far as they, or the attractor that it comes to, prove it."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..errors import ConvergenceError
from ..models.parameters import POSITIVE, FloatArray, ParameterSet, as_number
from ..motion.simulation import state_of
from ..numerics.interval_arrays import BoolArray
from ..results.result import Result
from .attractors import judged, settled
from .growth_rates import PROVED, rates_along
from .system import System


@dataclass(frozen=True, eq=False)
class Lyapunov(Result):
    """Lyapunov exponents of a motion.

    Attributes
    ----------
    exponents : ndarray, shape (m,)
        Largest first, over the second half of the motion.
    error : ndarray, shape (m,)
        Half-widths of their 95 % intervals, by the scatter among parts of that half; of the trivial exponent a bound.
    zero : ndarray of bool, shape (m,)
        Whether an exponent is the trivial one, that of the flow's own direction, or is not told from 0 by twice its error.
    trivial : int
        Which one is the trivial one; −1 at rest, where there is none.
    trace : float
        Mean divergence of the field, which the exponents add up to.
    t : ndarray, shape (n,)
        Times.
    running : ndarray, shape (n, m)
        The means from the middle of the motion to these times: how they converge.
    kind : str
        "rest", "cycle", "lift-off", "chaotic" or "undecided".
    why : str
        What decides that, or would.
    limit : ndarray, shape (m,)
        Exponents of the equilibrium or cycle that the motion comes to, from its eigenvalues or multipliers; NaN where none is
        found.
    end : ndarray, shape (m,)
        Where the motion ends.
    """

    exponents: FloatArray
    error: FloatArray
    zero: BoolArray
    trivial: int
    trace: float
    t: FloatArray
    running: FloatArray
    kind: str
    why: str
    limit: FloatArray
    end: FloatArray


def lyapunov(
    p: ParameterSet, *, V: float | None = None, d: float | None = None, start: Any = None, t_end: float = 4000.0,
    backend: str | None = None,
) -> Lyapunov:  # fmt: skip
    """The Lyapunov exponents of a motion with their errors, and what they prove.

    The first half of the motion is left out. Where the motion comes to an equilibrium or to a cycle, the eigenvalues or
    multipliers of that decide what it is. It is chaotic if an exponent is positive, every other one but the trivial one is told
    from 0, and the motion has settled; else it is undecided, and ``why`` says what would decide it.

    Parameters
    ----------
    p : Parameters of any model
        Scalars.
    V, d : float, optional
        In place of those of ``p``.
    start : array_like, optional
        Coordinates, then rates, of the article's model x, y, x', y'; 0 where it is left out.
    t_end : float
        Until when.
    backend : {"heyoka", "scipy"}, optional

    Returns
    -------
    Lyapunov

    Raises
    ------
    ParameterError, ParameterTypeError
        For arguments that make no sense, and parameters that are no scalars.

    Notes
    -----
    Source: Benettin's method on (8)–(11), the flow itself as the first direction; the field is continuous, so that its kinks need
    nothing special. A chaotic transient that lasts longer than the motion was followed is not told from a chaotic attractor.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> found = ss.lyapunov(ss.Parameters.article(theta0=np.radians(30)), V=0.5, d=4.0, start=(0.1, 0, 0, 0), t_end=2000)
    >>> bool(abs(found.exponents.sum() - found.trace) < 1e-9)
    True
    """
    system, state = System.of(p, backend, V=V, d=d), state_of(p.model, start)
    t_end = as_number("t_end", t_end, POSITIVE)
    whole = rates_along(system, state, t_end)
    late = whole.part(len(whole.logs) // 2)
    times = late.stretch * np.arange(1, len(late.logs) + 1)
    order = late.order
    zero = np.abs(late.exponents) <= PROVED * late.error
    zero[0] |= late.moves
    kind, why, limit = _kind(system, state, t_end)
    if not kind:
        why = late.undecided(t_end - late.span)
        kind = "undecided" if why else "chaotic"
        why = why or "every exponent but the trivial one is told from 0, and one at least is positive"
    return Lyapunov(
        late.exponents[order], late.error[order], zero[order], late.trivial,
        float(late.volumes.sum() / late.span), np.asarray(t_end - late.span + times),
        np.asarray(np.cumsum(late.logs, axis=0) / times[:, None])[:, order], kind, why, limit, late.end,
    )  # fmt: skip


def _kind(system: System, state: FloatArray, t_end: float) -> tuple[str, str, FloatArray]:
    """What a motion is by the attractor that it comes to, why, and the exponents of that; empty where none is found."""
    verdict = judged(system, state, times=(t_end,))
    if verdict.decided:
        with suppress(ConvergenceError):
            kind, limit, _ = settled(system, verdict)
            return kind, f"it comes to {verdict.told()}", limit
    return "", "", np.full(state.size, np.nan)
