"""Sensitivity of the article's Figure 7b to V and d, which it does not state."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...core.error_states import in_usual_state
from ...core.errors import ModelError, ParameterError
from ...core.questions import model_of, require_answered
from ...display import Column
from ...models.parameters import FloatArray, ParameterSet, as_numbers
from ...results.result import Result
from .many import Sweep, rms_sweep


@dataclass(frozen=True, eq=False)
class Sensitivity(Result):
    """The angle θ₀ at which the RMS of x jumps, for every V (first axis) and every d (second).

    Attributes
    ----------
    V, d : ndarray
        Belt speeds; steepnesses of the friction law.
    theta0 : ndarray, shape (len(V), len(d))
        Angle of the jump, radians: midpoint of an interval of half-width ``width``.
    before, after : ndarray, shape (len(V), len(d))
        RMS at the two ends of this interval.
    width : float
        Half-width of the interval, radians.
    sweep : Sweep
        The sweep in which the jumps were bracketed, shape (len(V), len(d), number of angles).
    """

    schema = (
        Column("before", "{x}", "root mean square of {x} before the jump"),
        Column("after", "{x}", "root mean square of {x} after the jump"),
        Column("width", "rad", "half-width of the interval of the jump"),
    )

    V: FloatArray
    d: FloatArray
    theta0: FloatArray
    before: FloatArray
    after: FloatArray
    width: float
    sweep: Sweep


@in_usual_state
def sensitivity(
    p: ParameterSet,
    V: ArrayLike | None = None,
    d: ArrayLike | None = None,
    *,
    refine: int = 6,
    **options: Any,
) -> Sensitivity:
    """Sensitivity of the jump in the article's Figure 7b to V and d, which it does not state.

    Parameters
    ----------
    p : Parameters
        Of a model with ``theta0``, V and d. ``theta0`` is an ascending axis of at least two angles;
        the others are scalars.
    V, d : array_like, one axis each, optional
        Belt speeds and steepnesses; by default those of ``p``.
    refine : int
        Number of bisections of the interval with the jump.
    **options
        Options of :func:`rms_sweep` except ``store``.

    Returns
    -------
    Sensitivity

    Raises
    ------
    ParameterError, ParameterTypeError
        For invalid arguments, as a ``theta0`` that is not an ascending axis.

    Notes
    -----
    The jump is between the two neighbouring angles with the largest ratio of RMS; bisection keeps
    the half with the larger ratio.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> from spragsym.motion.sweeps import sensitivity
    >>> p = ss.Parameters.article(theta0=np.radians([38, 42, 46]))
    >>> table = sensitivity(p, V=[0.5], d=[10.0], refine=3)
    >>> np.round(np.degrees([table.theta0[0, 0], table.width]), 2)
    array([41.25,  0.25])
    """
    require_answered("sensitivity", p)
    model = model_of(p)
    missing = [name for name in ("theta0", "V", "d") if name not in model.parameters]
    if missing:
        raise ModelError(
            f"{model.name} has no {missing[0]}, along which sensitivity looks; rms_sweep(p) "
            "takes any axes"
        )
    p.require("theta0")
    angles = p["theta0"]
    if angles.ndim != 1 or len(angles) < 2 or (np.diff(angles) <= 0).any():
        raise ParameterError(
            "theta0 must be an ascending axis of two angles or more; use "
            "p.replace(theta0=numpy.linspace(...))"
        )
    p.require(*(name for name, value in (("V", V), ("d", d)) if value is None))
    speeds, creeps = np.atleast_1d(
        p["V"] if V is None else as_numbers("V", V), p["d"] if d is None else as_numbers("d", d)
    )
    p = p.replace(V=speeds[:, None, None], d=creeps[None, :, None])
    sweep = rms_sweep(p, **options)
    ratio = sweep.rms[..., 1:] / sweep.rms[..., :-1]
    at = np.argmax(np.where(np.isnan(ratio), 0.0, ratio), axis=-1)[..., None]
    low, high = angles[at], angles[at + 1]
    before, after = (np.take_along_axis(sweep.rms, at + k, axis=-1) for k in (0, 1))
    for _ in range(refine):
        middle = (low + high) / 2
        between = rms_sweep(p.replace(theta0=middle), **options).rms
        upper = after * before > between**2
        low, before = np.where(upper, middle, low), np.where(upper, between, before)
        high, after = np.where(upper, high, middle), np.where(upper, after, between)
    theta0, width = (low + high)[..., 0] / 2, float(np.max(high - low)) / 2
    return Sensitivity(speeds, creeps, theta0, before[..., 0], after[..., 0], width, sweep)
