"""Motion in time: a model integrated from an initial state."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..errors import ParameterError, ParameterTypeError
from ..models.field import Field
from ..models.parameters import FloatArray, ParameterSet, as_number, as_numbers
from ..names import hint
from ..questions import model_of
from . import integrators
from .events import events_of
from .problem import MAX_STEPS, Problem, prepare
from .trajectory import Trajectory
from .with_scipy import RTOL


def simulate(
    p: ParameterSet,
    *,
    V: float | None = None,
    d: float | None = None,
    start: ArrayLike | None = None,
    t_end: float = 2000.0,
    rtol: float = 1e-10,
    events: bool = True,
    estimate_error: bool = False,
    backend: str | None = None,
    max_steps: int = MAX_STEPS,
    **initial: float,
) -> Trajectory:
    """Integrate the motion of a model from an initial state, the article's (8)–(11) among them.

    The integrator is restarted at every kink of the field, y = 0 and x' = V for the article's model, whether or not the
    events are kept.

    Parameters
    ----------
    p : Parameters of any model
        Scalars.
    V, d : float, optional
        In place of those of ``p``, for models that have them. The article states neither: 0.5 and 10, unless they are given,
        are this package's assumption.
    start : array_like, shape (2 n,), optional
        Coordinates, then rates.
    x0, y0, vx0, vy0, … : float, optional
        The same one by one, by the names of the model's coordinates and rates; 0 where nothing is given. For the article's
        model that is rest at x = y = 0, which lies on a kink.
    t_end : float
        Until when, in the model's unit of time: sqrt(m/k_c).
    rtol : float
        Relative tolerance of a step, in [1e-13, 1e-2]; the absolute one is a thousandth of it.
    events : bool
        Keep the events.
    estimate_error : bool
        Run again, at rtol/100 or the tightest there is, and keep the difference as ``error``.
    backend : {"heyoka", "compiled", "scipy"}, optional
        Taylor series (extra ``fast``), or DOP853 in compiled code (the article's model) or in Python; by default the first of
        these that is installed. They agree to the tolerance.
    max_steps : int
        Where to give up. A smooth motion takes a few steps per time unit; a stiff one, of large d, up to d times the
        friction, as it creeps. Ten million take heyoka some ten seconds to a minute, and several GB to keep.

    Returns
    -------
    Trajectory

    Raises
    ------
    ParameterError, ParameterTypeError
        For arguments that make no sense, and a start at which a spring has no length: at the article's anchor (8) is singular.
    ConvergenceError
        When the integrator cannot go on, or has made ``max_steps``.
    MissingExtraError
        When the backend asked for is not installed.

    Notes
    -----
    Source: the page's equations of motion; (8)–(11).

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> tr = ss.simulate(ss.Parameters.article(theta0=np.radians(49)), V=0.5, d=10.0)
    >>> round(tr.rms(transient=1500.0), 4), len(tr.events)
    (1.8052, 259)
    >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
    >>> tr.components, round(tr.largest(), 2)
    (('x', 'vx'), 0.61)
    """
    model, p = model_of(p), p.given(V=V, d=d)
    problem = prepare(
        model, p, start=tuple(state_of(model, start, initial).tolist()), t_end=t_end, rtol=rtol, max_steps=max_steps
    )
    chosen = integrators.choose(backend, integrators.offered_for(model))
    trajectory = _run(model, p, problem, chosen)
    if estimate_error:
        reference = _run(model, p, replace(problem, rtol=max(problem.rtol / 100, RTOL)), chosen)
        difference = np.abs(trajectory.state - reference(np.minimum(trajectory.t, reference.t[-1]))).max(axis=0)
        trajectory = replace(trajectory, error=difference)
    return trajectory if events else replace(trajectory, events=None)


def initial_state(model: Any, start: ArrayLike | None, initial: Mapping[str, ArrayLike]) -> dict[str, FloatArray]:
    """The initial state by names, ``x0`` for ``x`` and ``vx0`` for ``vx``; 0 where nothing is given."""
    names = [f"{name}0" for name in (*model.coordinates, *model.rates)]
    values: dict[str, ArrayLike] = dict.fromkeys(names, 0.0)
    if start is not None:
        given = as_numbers("start", start)
        if given.shape != (len(names),):
            raise ParameterError(f"start has the shape {given.shape}; it is {', '.join(names)}")
        values |= zip(names, given, strict=True)
    for name, value in initial.items():
        if name not in values:
            remedy = hint(name, names) or "; the initial state is " + ", ".join(names)
            if name in model.parameters:
                remedy = f" but a parameter; give it within the first one, as p.replace({name}=...)"
            raise ParameterTypeError(f"{name} is no argument{remedy}")
        values[name] = value
    return {name: as_numbers(name, value) for name, value in values.items()}


def state_of(model: Any, start: ArrayLike | None, initial: Mapping[str, ArrayLike] | None = None) -> FloatArray:
    """One initial state as an array; rest where nothing is given."""
    return np.array([as_number(name, value) for name, value in initial_state(model, start, initial or {}).items()])


def motion_of(field: Field, values: Sequence[float], state: FloatArray, t_end: float, **options: Any) -> Trajectory:
    """The motion of the model of a field, by the values of its parameters in order."""
    p = field.parameter_set(**dict(zip(field.parameters, values, strict=True)))
    return simulate(p, start=np.asarray(state), t_end=t_end, **options)


def _run(model: Any, p: ParameterSet, problem: Problem, backend: str) -> Trajectory:
    solution = integrators.integrate(problem, backend)
    events = events_of(problem.field, solution.crossings)
    return Trajectory(
        model, p, solution.samples.t, solution.samples.states, events, problem.rtol, backend, implicit=solution.implicit
    )
