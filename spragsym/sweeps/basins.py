"""Basins of attraction: which attractor is reached from a grid of initial states."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..display import Result
from ..dynamics.cycles import same_orbit
from ..dynamics.regimes import ATTRACTOR, Outcome, Regime
from ..errors import ParameterTypeError
from ..parameters import FloatArray, Parameters, as_numbers
from .measure import LIMITS
from .result import Sweep


@dataclass(frozen=True, eq=False)
class Basin(Result):
    """Which attractor each initial state reaches: arrays of shape (len(x), len(vx)).

    Attributes
    ----------
    x, vx : ndarray
        Initial displacements and speeds along the belt.
    attractor : ndarray of int
        Row of ``attractors`` that the motion reaches; −1 where it failed.
    attractors : tuple of (Regime, int, float, float)
        EQUILIBRIUM, LIMIT_CYCLE, LIFT_OFF or UNSETTLED, whether reached or approached; index of the equilibrium or −1; for
        a limit cycle its mean and its RMS of x about that over one period, else NaN.
    sweep : Sweep
        Everything that was measured.
    """

    x: FloatArray
    vx: FloatArray
    attractor: NDArray[np.int64]
    attractors: tuple[tuple[Regime, int, float, float], ...]
    sweep: Sweep


def basin(
    p: Parameters,
    V: float | None = None,
    d: float | None = None,
    *,
    x: ArrayLike,
    vx: ArrayLike,
    y0: float = 0.0,
    vy0: float = 0.0,
    **options: Any,
) -> Basin:
    """Which attractor is reached from a grid of initial displacements and speeds along the belt.

    Parameters
    ----------
    p : Parameters
        Scalars; of any model with a coordinate x.
    V, d : float, optional
        In place of those of ``p``.
    x, vx : array_like, one axis each
        Initial states: every x with every vx.
    y0, vy0 : float
        Initial state across the belt.
    **options
        As for :func:`rms_sweep`. A motion that by ``t_end`` approaches nothing is ``Regime.UNSETTLED``: deviations die
        out at a rate of μ₀ d exp(−d V) n, n the contact force, so that it can take tens of thousands of time units.

    Returns
    -------
    Basin

    Raises
    ------
    ParameterError, ParameterTypeError
        For arguments that make no sense, and parameters that are no scalars.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> from spragsym.sweeps import basin
    >>> p = ss.Parameters.article(theta0=np.radians(30))
    >>> found = basin(p, V=0.5, d=4.0, x=[0.0, 0.1, 1.6], vx=[0.0], t_end=2e4, transient=1.9e4)
    >>> [(regime.name, which) for regime, which, *_ in found.attractors]
    [('EQUILIBRIUM', 0), ('UNSETTLED', -1)]
    >>> found.attractor[:, 0]
    array([0, 0, 1])
    """
    p = p.given(V=V, d=d)
    p.scalars(*p.ranges)
    starts = [np.atleast_1d(as_numbers(name, values)) for name, values in (("x", x), ("vx", vx))]
    for name, values in zip(("x", "vx"), starts, strict=True):
        if values.ndim != 1:
            raise ParameterTypeError(f"{name} has the shape {values.shape}; give one axis of numbers")
    own = (*p.model.coordinates, *p.model.rates)
    across = {name: value for name, value in (("y0", y0), ("vy0", vy0)) if name[:-1] in own or np.any(np.asarray(value) != 0)}
    sweep = p.model.rms_sweep(p, x0=starts[0][:, None], vx0=starts[1], **across, **options)
    labels, attractors = _attractors(sweep)
    return Basin(starts[0], starts[1], labels, attractors, sweep)


def _attractors(sweep: Sweep) -> tuple[NDArray[np.int64], tuple[tuple[Regime, int, float, float], ...]]:
    """Group motions by what they settle to or approach: cycles by their orbits, which know no phase."""
    labels = np.full(sweep.rms.shape, -1)
    attractors: list[tuple[Regime, int, Outcome]] = []
    for index in np.ndindex(sweep.rms.shape):
        code = Regime(int(sweep.regime[index]))
        if code == Regime.FAILED:
            continue
        regime, which = ATTRACTOR.get(code, code), int(sweep.equilibrium[index])
        outcome = Outcome(code, which, **{name: float(getattr(sweep, name)[index]) for name in LIMITS})
        same = (
            i for i, known in enumerate(attractors)
            if known[:2] == (regime, which) and (regime != Regime.LIMIT_CYCLE or same_orbit(known[2], outcome))
        )  # fmt: skip
        label = next(same, len(attractors))
        if label == len(attractors):
            attractors.append((regime, which, outcome))
        labels[index] = label
    return labels, tuple((regime, which, one.cycle_mean, one.cycle_spread) for regime, which, one in attractors)
