"""Lyapunov exponents of a motion: whether it is periodic, quasi-periodic or chaotic, and how far that is settled."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..display import Result
from ..dynamics.field import Field
from ..dynamics.flows import carrier
from ..dynamics.shooting import rate
from ..errors import ConvergenceError, ParameterError
from ..parameters import FINITE, POSITIVE, FloatArray, Parameters, as_number
from .sprag import SPRAG

#: Time between two orthonormalizations.
STRETCH = 5.0

#: Deviations of which one is smaller than another by more than this in a stretch are lost in rounding: it is halved.
LOST = 1e-10

#: Most often.
HALVINGS = 12

#: Blocks of the second half of the motion, by whose scatter the error is judged.
BLOCKS = 8

#: Standard errors within which an exponent counts as 0.
DOUBT = 4.0


@dataclass(frozen=True, eq=False)
class Lyapunov(Result):
    """Lyapunov exponents of a motion.

    Attributes
    ----------
    exponents : ndarray, shape (m,)
        Largest first, over the second half of the motion.
    error : ndarray, shape (m,)
        Standard error by the scatter among eight equal parts of that half; no bound: what a motion does later is not known.
    zero : ndarray of bool, shape (m,)
        Whether an exponent can't be told from 0: it is below four standard errors, or below that of a growth by e over that half.
    trace : float
        Mean divergence of the field, which the exponents add up to.
    t : ndarray, shape (n,)
        Times.
    running : ndarray, shape (n, m)
        The means from the middle of the motion to these times: how they converge.
    kind : str
        "periodic or at rest", "quasi-periodic", "chaotic" or "undecided", as far as it is settled.
    end : ndarray, shape (m,)
        Where the motion ends.
    """

    exponents: FloatArray
    error: FloatArray
    zero: FloatArray
    trace: float
    t: FloatArray
    running: FloatArray
    kind: str
    end: FloatArray


def lyapunov(
    p: Parameters, *, V: float | None = None, d: float | None = None, start: Any = (0.0, 0.0, 0.0, 0.0), t_end: float = 4000.0,
    backend: str | None = None,
) -> Lyapunov:  # fmt: skip
    """The Lyapunov exponents of a motion, with their convergence.

    The variational equations are carried along and orthonormalized every five time units; the first half of the motion is
    left out.

    Parameters
    ----------
    p : Parameters
        Scalars.
    V, d : float, optional
        In place of those of ``p``.
    start : array_like of 4 numbers
        x, y, x', y'.
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
    Source: Benettin's method on (8)–(11); the field is continuous, so that its kinks need nothing special.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> found = ss.lyapunov(ss.Parameters.article(theta0=np.radians(30)), V=0.5, d=4.0, start=(0.1, 0, 0, 0), t_end=2000)
    >>> bool(abs(found.exponents.sum() - found.trace) < 1e-9)
    True
    """
    values = p.given(V=V, d=d).scalars(*p.ranges)
    state = np.array([as_number("start", value, FINITE) for value in start])
    return exponents_of(SPRAG, values, state, as_number("t_end", t_end, POSITIVE), backend)


def exponents_of(
    field: Field, values: tuple[float, ...], state: FloatArray, t_end: float, backend: str | None = None
) -> Lyapunov:
    """As :func:`lyapunov`, of any field."""
    fly, _ = carrier(field, backend)
    constants, none = field.constants(values), np.zeros((2, len(field.parameters)))
    m, count = field.size, max(2 * BLOCKS, math.ceil(t_end / STRETCH))
    stretch = t_end / count
    frame, logs, volumes = np.eye(m), np.empty((count, m)), np.empty(count)
    if not np.isfinite(rate(field, state, constants)).all():
        raise ParameterError(f"start = {state.tolist()}: the motion is not defined there; start anywhere else")

    def carried(
        state: FloatArray, frame: FloatArray, span: float, halvings: int
    ) -> tuple[FloatArray, FloatArray, FloatArray, float]:
        """State and frame after a while, with the logarithms of growth along the frame and of volumes."""
        passage = fly(state, constants, span, none)
        turned, triangle = np.linalg.qr(passage.by_state @ frame)
        sizes = np.abs(np.diag(triangle))
        if sizes.min() > LOST * sizes.max():
            return passage.state, turned, np.log(sizes), float(np.linalg.slogdet(passage.by_state)[1])
        if halvings == 0:
            raise ConvergenceError(f"small deviations shrink by more than {1 / LOST:g} in {span:g} time units: too stiff")
        middle, frame, first, shrunk = carried(state, frame, span / 2, halvings - 1)
        end, frame, second, more = carried(middle, frame, span / 2, halvings - 1)
        return end, frame, first + second, shrunk + more

    for i in range(count):
        state, frame, logs[i], volumes[i] = carried(state, frame, stretch, HALVINGS)
    late = logs[count // 2 :]
    times = stretch * np.arange(1, len(late) + 1)
    running = np.cumsum(late, axis=0) / times[:, None]
    parts = np.array([block.sum(axis=0) / (len(block) * stretch) for block in np.array_split(late, BLOCKS)])
    error = parts.std(axis=0, ddof=1) / math.sqrt(BLOCKS)
    exponents = running[-1]
    zero = np.abs(exponents) <= np.maximum(DOUBT * error, 1 / times[-1])
    order = np.argsort(-exponents)
    return Lyapunov(
        exponents[order], error[order], zero[order], float(volumes[count // 2 :].sum() / times[-1]),
        t_end - times[-1] + times, running[:, order], _kind(exponents[order], zero[order]), state,
    )  # fmt: skip


def _kind(exponents: FloatArray, zero: FloatArray) -> str:
    if exponents[0] > 0 and not zero[0]:
        return "chaotic"
    return {0: "periodic or at rest", 1: "periodic or at rest", 2: "quasi-periodic"}.get(int(zero.sum()), "undecided")
