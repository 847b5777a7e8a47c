"""How probable a jump is when parameters, or the quantities of a brake, are known within tolerances only."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from ...design.dependence import Correlation
from ...design.design_space import PHYSICAL, dimensionless
from ...design.probability import POINTS, Distribution, JumpProbability, checked, estimated, sides
from ...errors import ParameterError
from ...parameters import NAMES, RANGES, FloatArray, Parameters, PhysicalParameters, range_of
from ...sweeps.workers import Workers
from ..catastrophe.sliding import sliding_friction
from .events import have_jumped

#: Of the belt: its speed and the steepness of the friction law.
BELT = ("V", "d")


def jump_probability(
    distribution: Distribution,
    *,
    correlation: Correlation | None = None,
    n: int = POINTS,
    rng: int | np.random.Generator | None = None,
    confidence: float = 0.95,
    sobol: bool = True,
    replicates: int = 16,
    workers: Workers = 1,
    progress: bool = False,
    store: str | os.PathLike[str] | None = None,
) -> JumpProbability:
    """The probability of a jump from tolerances, by quasi-Monte Carlo, with an interval and Sobol' indices.

    Parameters
    ----------
    distribution : mapping, or two corners of a box
        For each dimensionless parameter, or for each of the physical quantities k, k_x, k_y, k_c, F_L, L_0, theta0 and mu0: a
        number, a range ``(low, high)`` in which all values are as probable, or a frozen distribution of ``scipy.stats``. With V
        and d, both, beside the physical ones the friction is that at the speed of the belt. Two :class:`~spragsym.Parameters`
        or :class:`~spragsym.PhysicalParameters` are the corners of a box.
    correlation : mapping of pairs of names to float, optional
        Of the normal scores behind the distributions (a Gaussian copula), which are the quantities' own where they are normal;
        1 where one decides the other. Those that are not named are independent.
    n : int
        Points, rounded up to a power of two for each replicate.
    rng : int or numpy.random.Generator, optional
        An int gives the same points each time.
    confidence : float
        Of the intervals.
    sobol : bool
        Also estimate the indices, which costs half as many evaluations more for each quantity that varies.
    replicates : int
        Independent scramblings, from whose spread the intervals follow.
    workers : int or map-like callable
        Processes, −1 for one a core; or ``map(function, chunks)`` of an engine, such as a dask client's. The result is the same.
    progress : bool
        Show a bar on stderr.
    store : path, optional
        Finished chunks go to ``<store>.partial``; the same call goes on from there after a kill, and reads the file when it is
        done. Needs an int as ``rng``.

    Returns
    -------
    JumpProbability

    Raises
    ------
    ParameterError
        For quantities that are missing or unknown, and distributions that reach out of a range.

    Notes
    -----
    Source: f = f′ = 0; an event is a jump at a friction up to μ₀. Interval by Student's distribution over the
    replicates, or by Clopper and Pearson where fewer than 50 points jump, or don't.

    Examples
    --------
    >>> import numpy as np
    >>> base = Parameters.article(theta0=np.radians(40.0), mu0=0.55)
    >>> box = base.replace(mu0=0.5, sigma=0.09), base.replace(mu0=0.65, sigma=0.11)
    >>> found = jump_probability(box, n=4096, rng=1)
    >>> round(found.probability, 2), found.high - found.low < 0.01, max(found.total, key=found.total.get)
    (0.39, True, 'mu0')
    """
    return estimated(
        _variables(distribution), _has_jumped, correlation=correlation, n=n, rng=rng, confidence=confidence, sobol=sobol,
        replicates=replicates, workers=workers, progress=progress, store=store,
    )  # fmt: skip


def _variables(distribution: Distribution) -> dict[str, Any]:
    """Each quantity as a float, or as something with a quantile function ``ppf``."""
    given = _box(*distribution) if isinstance(distribution, tuple) else dict(distribution)
    names: tuple[str, ...] = PHYSICAL if set(given) & (set(PHYSICAL) - set(NAMES)) else NAMES
    if names is PHYSICAL and set(given) & set(BELT):
        names = (*PHYSICAL, *BELT)
    return checked(given, {name: RANGES[name] if name in RANGES else range_of(name) for name in names}, "a quantity here")


def _box(low: Any, high: Any) -> dict[str, Any]:
    if type(low) is not type(high) or not isinstance(low, Parameters | PhysicalParameters):
        raise ParameterError("distribution: the corners of a box are two Parameters or two PhysicalParameters")
    return sides(low, high, NAMES if isinstance(low, Parameters) else PHYSICAL)


def _has_jumped(values: dict[str, Any]) -> FloatArray:
    """1 where the state jumps, 0 where it does not, NaN where that is unknown."""
    if "V" in values:
        values["mu0"] = sliding_friction(
            *(values[name] for name in ("mu0", *BELT))
        )  # d V has no dimension, in SI as without units
    return have_jumped(Parameters(**dimensionless(values)))
