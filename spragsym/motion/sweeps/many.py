"""Many motions: RMS and final regime over parameters and initial states, resumable, on all cores."""

from __future__ import annotations

import os
from functools import partial

from numpy.typing import ArrayLike

from ...errors import ParameterError
from ...models.parameters import NOT_NEGATIVE, POSITIVE, ParameterSet, as_count, as_number
from ...questions import model_of
from .. import batch_heyoka, integrators
from ..problem import MAX_STEPS, RELATIVE_TOLERANCE
from ..simulation import initial_state
from .measure import Settings, measured, reported
from .points import made_or_loaded
from .result import Sweep, fingerprint, made_of
from .workers import Workers

#: Motions of one task at most, and their time in all; a few points are one task each.
TOGETHER, TOGETHER_FOR = 1024, 2e5

#: Tasks that every worker gets at least, where there are points enough.
PARTS = 16


def rms_sweep(
    p: ParameterSet,
    V: ArrayLike | None = None,
    d: ArrayLike | None = None,
    *,
    t_end: float = 2000.0,
    transient: float | None = None,
    rtol: float = 1e-10,
    backend: str | None = None,
    max_steps: int = MAX_STEPS,
    workers: Workers = 1,
    progress: bool = False,
    store: str | os.PathLike[str] | None = None,
    **initial: ArrayLike,
) -> Sweep:
    """Simulate every point of a broadcast of parameters and initial states, and tell what each comes to.

    Parameters
    ----------
    p : Parameters of any model
        Any shape.
    V, d : array_like, optional
        In place of those of ``p``, for models that have them. The article states neither.
    x0, y0, vx0, vy0, … : array_like, optional
        As for :func:`~spragsym.simulate`; they broadcast with ``p``.
    t_end, transient : float
        Until when to integrate, and what to leave out of every result, by default three quarters of it.
    rtol : float
        Relative tolerance.
    backend : {"heyoka", "compiled", "scipy"}, optional
        As for :func:`~spragsym.simulate`.
    max_steps : int
        As for :func:`~spragsym.simulate`; a motion that needs more has failed.
    workers : int or map-like callable
        Processes, −1 for one a core; or ``map(function, tasks)`` of an engine, which may give results or
        futures with a ``result()``, in any order. A task is a point; of many points that heyoka integrates, up to 1024 of them.
        Results are the same to the last bit for any.
    progress : bool
        Show a bar with the estimated end on stderr.
    store : path, optional
        ``*.nc`` or ``*.csv``. Finished points go to ``<store>.partial`` task by task. The same call resumes
        from there after a kill, and loads the file when it is finished. One process at a time may write to it.

    Returns
    -------
    Sweep
        x stands for the model's first coordinate, and y for the second.

    Raises
    ------
    ParameterError, ParameterTypeError
        Before the work starts, for arguments that make no sense and files that cannot be written. A motion
        that fails is NaN, with its reason, and stops nothing.
    SweepError
        For any failure that is not the motion's: memory, a package that is missing, a worker that was killed.
        The store keeps what is finished.
    StoreError
        When the store is damaged, full, or being written by another process.

    Notes
    -----
    Source: (8)–(11); the article's Figure 7b. Which equilibrium: with μ(V), (10), for μ₀, which is where the
    motion can rest.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> from spragsym.motion.sweeps import Regime, rms_sweep
    >>> sweep = rms_sweep(ss.Parameters.article(theta0=np.radians([40, 41, 44])), V=0.5, d=10.0)
    >>> np.round(sweep.rms, 1)
    array([0.1, 0.2, 1.7])
    >>> [Regime(code).name for code in sweep.regime]
    ['APPROACHES_EQUILIBRIUM', 'APPROACHES_EQUILIBRIUM', 'UNSETTLED']
    """
    model, p = model_of(p), p.given(V=V, d=d)
    p.require(*model.parameters)
    inputs = {**{name: getattr(p, name) for name in model.parameters}, **initial_state(model, None, initial)}
    t_end = as_number("t_end", t_end, POSITIVE)
    transient = 0.75 * t_end if transient is None else as_number("transient", transient, NOT_NEGATIVE)
    if transient >= t_end:
        raise ParameterError(f"transient = {transient:g} is not below t_end = {t_end:g}; nothing would be left to measure")
    tolerance, steps = as_number("rtol", rtol, RELATIVE_TOLERANCE), as_count("max_steps", max_steps)
    settings = Settings(t_end, transient, tolerance, integrators.choose(backend, integrators.offered_for(model)), steps)
    work, together = partial(measured, model, settings), partial(_together, settings)
    made, key = partial(made_of, model, inputs, settings), partial(fingerprint, model, inputs, vars(settings))
    columns = (*reported(model.coordinates, model.rates), "regime")
    return made_or_loaded(inputs, work, made, columns, "reason", key, Sweep.save, workers, progress, store, together)


def _together(settings: Settings, count: int, workers: int) -> int:
    """How many motions are one task: what a kill loses, and what every worker gets many of. No result depends on it."""
    if settings.backend != "heyoka":  # which alone carries many at a time
        return 1
    lasting = max(batch_heyoka.LANES, int(TOGETHER_FOR / settings.t_end))
    return max(1, min(TOGETHER, lasting, count // (PARTS * workers)))
