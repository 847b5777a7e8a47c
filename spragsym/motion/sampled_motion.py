"""A motion by its samples: values in between, averages, extrema, and what it comes to, for any model."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from ..errors import ParameterError
from ..models.field import SETTLED
from ..models.parameters import NOT_NEGATIVE, POSITIVE, FloatArray, as_number, as_numbers
from ..results.result import Result
from . import flows
from .classify import classify
from .events import Events
from .lobatto import PiecewisePolynomial
from .measures import Course, course_of
from .problem import Event, Problem
from .regimes import Outcome, Regime


class Recorded(Result):
    """What trajectories of every model share. A subclass has the time ``t``, the ``components``, and the fields of a motion."""

    t: FloatArray
    #: Coordinates and rates at the samples, shape (2 n, samples).
    state: Any
    events: Events | None
    rtol: float
    backend: str
    error: FloatArray | None

    @property
    def components(self) -> tuple[str, ...]:
        """Names of the coordinates, then of their rates."""
        raise NotImplementedError

    def _with(self, t: FloatArray, state: FloatArray, events: Events | None, error: FloatArray | None) -> Self:
        """The same motion with other samples."""
        raise NotImplementedError

    def _problem(self, start: tuple[float, ...], length: float) -> Problem:
        """The motion that begins at ``start``."""
        raise NotImplementedError

    def _identified(self, found: Outcome) -> Outcome:
        """An outcome with the index of its equilibrium."""
        raise NotImplementedError

    def _event_counts(self) -> Any:
        """How often each kind of event happened, where events were not kept."""
        raise NotImplementedError

    @cached_property
    def samples(self) -> PiecewisePolynomial:
        """The polynomials through the samples."""
        return PiecewisePolynomial(self.t, self.state)

    @cached_property
    def weights(self) -> FloatArray:
        """Quadrature weights, shape (n,): ``(weights * f).sum()`` is the integral of f over time."""
        return self.samples.weights()

    def integral(self, values: ArrayLike) -> float:
        """Integral over time of ``values``, given at the samples."""
        return float(np.sum(self.weights * np.asarray(values)))

    def __call__(self, t: ArrayLike) -> FloatArray:
        """x, y, x', y' at any times within the trajectory, shape (4, …)."""
        times = as_numbers("t", t)
        if times.size and not (self.t[0] <= times.min() and times.max() <= self.t[-1]):
            raise ParameterError(
                f"t = {times.min():g} … {times.max():g} is not within the trajectory, "
                f"[{self.t[0]:g}, {self.t[-1]:g}]; simulate with a larger t_end"
            )
        return self.samples(times)

    def after(self, transient: float | None) -> Self:
        """What follows the time ``transient``, three quarters of the end if None, as a trajectory; an error if nothing does."""
        transient = 0.75 * float(self.t[-1]) if transient is None else as_number("transient", transient, NOT_NEGATIVE)
        if transient >= self.t[-1]:
            raise ParameterError(
                f"transient = {transient:g} leaves nothing of a trajectory that ends at {self.t[-1]:g}; "
                "give a smaller transient, or simulate with a larger t_end"
            )
        if transient <= self.t[0]:
            return self
        late = self.samples.after(transient)
        error = None if self.error is None else np.interp(late.t, self.t, self.error)
        events = self.events
        if events is not None:
            events = events.select(events.t >= transient)
        return self._with(late.t, late.states, events, error)

    def mean(self, transient: float | None = None, *, of: str | None = None) -> float:
        """Time average of x, a model's first coordinate, (or ``of="y"``, ``"vx"``, ``"vy"``) after ``transient``."""
        late = self.after(transient)
        return late.integral(late._values(of)) / float(late.t[-1] - late.t[0])

    def rms(self, transient: float | None = None, *, of: str | None = None, about: str = "zero") -> float:
        """Root mean square after ``transient``: about zero, or with ``about="mean"`` about the mean.

        The article's Figure 7b shows the root mean square of x, from zero.
        """
        late = self.after(transient)
        deviation = late._values(of) - late._centre(of, about)
        return float(np.sqrt(late.integral(deviation**2) / (late.t[-1] - late.t[0])))

    def largest(self, transient: float | None = None, *, of: str | None = None, about: str = "zero") -> float:
        """Largest |x| after ``transient``: from zero, or with ``about="mean"`` from the mean."""
        late = self.after(transient)
        return float(np.abs(late._extrema(of) - late._centre(of, about)).max())

    def outcome(self, transient: float | None = None, *, tol: float = SETTLED) -> Outcome:
        """What the motion settles to or approaches, how fast, and what is left, judged by what follows ``transient``.

        The same as a :class:`~spragsym.Sweep` tells of it. A cycle is found by Newton's method on the flow and its
        derivatives, which integrates a few periods more.
        """
        late = self.after(transient)
        start, length = tuple(late.state[:, 0].tolist()), float(late.t[-1] - late.t[0])
        problem = self._problem(start, length)
        onward = flows.onward(problem, self.backend)
        return self._identified(classify(late.course(), problem, onward, as_number("tol", tol, POSITIVE)))

    def period(self, transient: float | None = None, *, tol: float = SETTLED) -> float:
        """Period of the cycle that the motion after ``transient`` has settled to; NaN if it has not, and at rest.

        It has settled when what is left to the cycle is at most ``tol`` of the motion's reach. The period is the cycle's
        own, whatever is left. For what a motion only approaches see :meth:`outcome`.
        """
        outcome = self.outcome(transient, tol=tol)
        return outcome.period if outcome.regime == Regime.LIMIT_CYCLE else float("nan")

    def converged(self, transient: float | None = None, *, tol: float = SETTLED) -> bool:
        """Whether the motion after ``transient`` has settled to rest or to a cycle, within ``tol`` (see :meth:`outcome`)."""
        return self.outcome(transient, tol=tol).regime in (Regime.EQUILIBRIUM, Regime.LIMIT_CYCLE)

    # -------------------------------------------------------------------------------------------- inner parts

    def _values(self, of: str | None) -> FloatArray:
        of = self.components[0] if of is None else of
        if of not in self.components:
            raise ParameterError(f"of = {of!r} is not one of {', '.join(self.components)}")
        values: FloatArray = self.state[self.components.index(of)]
        return values

    def _centre(self, of: str | None, about: str) -> float:
        if about not in ("zero", "mean"):
            raise ParameterError(f"about = {about!r} is neither 'zero' nor 'mean'")
        return self.mean(0.0, of=of) if about == "mean" else 0.0

    def _extrema(self, of: str | None) -> FloatArray:
        """Values at the ends and at all local extrema: of a rate, where its own rate passes 0."""
        values = self._values(of)
        row, n = 0 if of is None else self.components.index(of), len(self.components) // 2
        speed = self.state[row + n] if row < n else self.samples.slopes(row)
        both = PiecewisePolynomial(self.t, np.array([values, speed]))
        lowest, highest = both.passages(speed, lambda state: state[1]), both.passages(-speed, lambda state: -state[1])
        return np.concatenate([values[[0, -1]], both(lowest)[0], both(highest)[0]])

    def course(self) -> Course:
        """What :func:`~spragsym.motion.integrators.measure` measures on the way, from the samples."""
        if self.events is None:
            return course_of(self.samples, self._event_counts())
        return course_of(self.samples, np.bincount(self.events.which, minlength=len(Event)))
