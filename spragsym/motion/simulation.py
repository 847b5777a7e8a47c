"""Motion in time: :func:`simulate` integrates a model from an initial state and returns a
:class:`Trajectory`, from which averages, forces, energy, events, spectrum and the long-run limit
are computed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from ..core.error_states import in_usual_state
from ..core.errors import ConvergenceError, ParameterError, ParameterTypeError, hint, one_of
from ..core.questions import model_of, require_answered
from ..display import Column, Table, caption
from ..files import storage
from ..models import forces
from ..models.field import Field
from ..models.parameters import (
    NOT_NEGATIVE,
    POSITIVE,
    FloatArray,
    ParameterSet,
    as_count,
    as_number,
    as_numbers,
    degrees,
)
from ..numerics.interval_arrays import BoolArray, IndexArray
from ..numerics.vectors import magnitude
from ..results.result import Named
from ..statics.search import rest_index
from . import integrators
from .classify import classify
from .lobatto import PiecewisePolynomial
from .measures import MotionStatistics, Spectrum, harmonics_of, spectrum_of, statistics_of
from .options import MotionOptions
from .problem import MAX_STEPS, RELATIVE_TOLERANCE, Event, Problem, prepare
from .regimes import Outcome, Regime
from .return_map import Onward
from .solution import Events, events_of
from .with_heyoka import TOLERANCE as TIGHTEST
from .with_scipy import RTOL

if TYPE_CHECKING:
    from xarray import Dataset

    from ..models.model import Model

#: A state: all of its numbers in order, or some by their names, the others 0.
Start: TypeAlias = "ArrayLike | Mapping[str, ArrayLike]"


@in_usual_state
def simulate(
    p: ParameterSet,
    *,
    start: Start | None = None,
    t_end: float = 2000.0,
    rtol: float = 1e-10,
    events: bool = True,
    estimate_error: bool = False,
    backend: str | None = None,
    max_steps: int = MAX_STEPS,
    **values: float | None,
) -> Trajectory:
    """Integrate the equations of motion of a model from an initial state; for the article's model
    these are (8)–(11).

    The integrator is restarted at every kink of the field, whether or not the events are kept. The
    kinks of the article's model are y = 0 and x' = V.

    Parameters
    ----------
    p : Parameters of any model
        Scalars.
    start : array_like, shape (2 n,), or mapping, optional
        Initial coordinates, then initial rates; or some of them by name, ``{"x": 0.1}``, the others
        0.
    t_end : float
        Duration in the model's unit of time; for the article's model sqrt(m/k_c).
    rtol : float
        Relative tolerance of a step, in [1e-13, 1e-2]. The absolute tolerance is a thousandth of
        it, in the motion's own units (:mod:`spragsym.motion.scales`). More than the default is
        refused where a curved border fixes the steps.
    events : bool
        Keep the events.
    estimate_error : bool
        Integrate a second time, from a start that differs by rounding and with the tightest
        tolerance there is, by heyoka if it is installed. The difference is kept as ``error``.
    backend : {"heyoka", "compiled", "scipy"}, optional
        Taylor series (extra ``fast``), or DOP853 in compiled code (the article's model only) or in
        Python. The default is the first of these that is installed. They agree to the tolerance.
    max_steps : int
        Maximum number of steps. A smooth motion takes a few steps per time unit. A stiff motion,
        with large d, takes up to d times the friction, as it creeps. Ten million steps take heyoka
        some ten seconds to a minute, and several GB of memory.
    **values : float, optional
        Values of parameters that replace those of ``p``, as ``V=0.5, d=10.0``. Also single numbers
        of the initial state, by the names of the model's coordinates and rates followed by 0, as
        ``x0, y0, vx0, vy0``; they are 0 unless given. For the article's model that is rest at
        x = y = 0, which lies on a kink.

    Returns
    -------
    Trajectory

    Raises
    ------
    ParameterError, ParameterTypeError
        For invalid arguments, and for a start at which a spring has length 0: there its direction
        is undefined, and (8) is singular.
    ConvergenceError
        When the integrator fails, or has made ``max_steps``.
    MissingExtraError
        When the requested backend is not installed.

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
    require_answered("simulate", p)
    model = model_of(p)
    p, initial = started(p, values)
    problem = prepare(
        model,
        p,
        start=tuple(state_of(model, start, initial, p).tolist()),
        t_end=t_end,
        rtol=rtol,
        max_steps=max_steps,
    )
    chosen = integrators.choose(backend, integrators.offered_for(model))
    integrators.check_rtol(model.field, problem.rtol, chosen)
    trajectory = _run(model, p, problem, chosen)
    if estimate_error:
        trajectory = replace(trajectory, error=_error(trajectory, problem))
    return trajectory if events else replace(trajectory, events=None)


@dataclass(frozen=True, eq=False)
class Trajectory(Named):
    """A motion in time: samples, and the polynomial of each step through them.

    The samples are the Gauss–Lobatto points of every step of the integrator: ``degree + 1`` points
    per step, the ends of the step and all events among them; neighbouring steps share a point.
    Values between the samples, and integrals, are as accurate as the integration itself. Each
    coordinate and rate is an attribute by its name, as ``tr.x`` and ``tr.vx``.

    Attributes
    ----------
    model : Model
        The model, whose page states the units. The article's are sqrt(m/k_c) for times, L_0 for
        lengths, k_c L_0 for forces.
    p : Parameters of the model
        Scalars.
    t : ndarray, shape (k,)
        Time in the model's unit.
    state : ndarray, shape (2 n, k)
        The n coordinates, then their rates; x, y, x', y' for the article's model.
    events : Events or None
        Contact lost and regained, slip reversed, sticking begun and ended; None if not requested.
    rtol : float
        The relative tolerance of a step that was used. It is smaller than the requested one for a
        field with curved borders, and at least 1e-12 if ``implicit``.
    backend : str
        The integrator that was used.
    error : ndarray, shape (k,), or None
        Estimated error: the largest difference, of all components and up to each time, to a second
        run with the tightest tolerance and a start that differs by rounding; divided by 0.75,
        because that run has an error too. NaN if no second run was possible: it must have a
        tolerance at least a hundred times smaller, or be by another method. None if not requested.
    implicit : bool
        True if the motion is stiff: the steps of ``backend`` collapsed, and SciPy's Radau
        integrated it.
    periods : int
        Number of periods of a cycle that it consists of, as of ``cycle.trajectory()``; 0 for other
        motions.
    """

    schema = (
        Column("t", "s", "time"),
        Column("error", "{x}", "largest difference of the state to a run at a tighter tolerance"),
        Column("rms", "{x}", "root mean square of {x} about zero"),
        Column("rms_about_mean", "{x}", "root mean square of {x} about its mean"),
        Column("mean", "{x}", "mean of {x}"),
        Column("largest", "{x}", "largest |{x}|"),
        Column("period", "s", "period of the cycle that it has settled to"),
        Column("event_t", "s", "time of an event"),
        Column("event", "1", "what happened", Event),
        Column("event_contact", "1", "of which contact, where there are several"),
    )

    model: Any
    p: Any
    t: FloatArray
    state: FloatArray
    events: Events | None
    rtol: float
    backend: str
    error: FloatArray | None = None
    implicit: bool = False
    periods: int = 0

    @property
    def components(self) -> tuple[str, ...]:
        return self.model.components

    def data(self) -> dict[str, Any]:
        """Time and every component, at the samples.

        Returns
        -------
        dict
            Arrays of shape (n,) by ``"t"`` and the names of the components.

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> list(tr.data())
        ['t', 'x', 'vx']
        """
        return {self._own("t"): self.t, **dict(zip(self.components, self.state, strict=True))}

    @property
    def _items(self) -> dict[str, Any]:
        return self.data()

    def as_table(self) -> Table:
        """First, smallest, largest and last value of each coordinate and rate.

        Returns
        -------
        Table
            Titles, units, and a row for each coordinate and rate.

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> len(tr.as_table().rows)
        2
        """
        schema, t = self._schema, self.t
        rows = []
        for name, values in zip(self.components, self.state, strict=True):
            row = values[0], values.min(), values.max(), values[-1]
            rows.append((schema.heading(name), *(schema.cell(name, value) for value in row)))
        shown = {"model": self.model.name, "p": self.p, "rtol": self.rtol}
        shown["backend"] = "SciPy's Radau" if self.implicit else self.backend
        if self.events is not None:
            shown["events"] = len(self.events)
        title = caption(
            schema,
            f"Trajectory, t = {schema.cell('t', t[0])} to {schema.cell('t', t[-1])}",
            shown,
            f"{len(t)} samples",
        )
        return Table(title, ("", "first", "smallest", "largest", "last"), tuple(rows))

    @cached_property
    def samples(self) -> PiecewisePolynomial:
        """The motion as a piecewise polynomial."""
        return PiecewisePolynomial(self.t, self.state)

    @cached_property
    def weights(self) -> FloatArray:
        """Quadrature weights, shape (n,): ``(weights * f).sum()`` is the integral of f over
        time.
        """
        return self.samples.weights()

    def integral(self, values: ArrayLike) -> float:
        """Integral over time of a quantity that is given at the samples.

        Parameters
        ----------
        values : array_like, shape (n,)
            The quantity at the n samples.

        Returns
        -------
        float

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> change = tr.energy()[-1] - tr.energy()[0]
        >>> bool(abs(tr.integral(tr.power()) - change) < 1e-8)
        True
        """
        return float(np.sum(self.weights * np.asarray(values)))

    def __call__(self, t: ArrayLike) -> FloatArray:
        """Interpolate: coordinates, then rates, at times within the trajectory, shape (2 n, …)."""
        times = as_numbers("t", t)
        if times.size and not (self.t[0] <= times.min() and times.max() <= self.t[-1]):
            raise ParameterError(
                f"t = {times.min():g} … {times.max():g} is not within the trajectory, "
                f"[{self.t[0]:g}, {self.t[-1]:g}]; simulate with a larger t_end"
            )
        return self.samples(times)

    def after(self, transient: float | None) -> Trajectory:
        """The part of the trajectory after the time ``transient``.

        Raises ParameterError if the trajectory ends before.

        Parameters
        ----------
        transient : float or None
            Time at which the part begins; None for three quarters of the end time.

        Returns
        -------
        Trajectory

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> bool(tr.after(150.0).t[0] >= 150.0)
        True
        """
        transient = (
            0.75 * float(self.t[-1])
            if transient is None
            else as_number("transient", transient, NOT_NEGATIVE)
        )
        if transient >= self.t[-1]:
            raise ParameterError(
                f"transient = {transient:g} leaves nothing of a trajectory that ends at "
                f"{self.t[-1]:g}; "
                "give a smaller transient, or simulate with a larger t_end"
            )
        if transient <= self.t[0]:
            return self
        late = self.samples.after(transient)
        error = None if self.error is None else np.interp(late.t, self.t, self.error)
        events = self.events
        if events is not None:
            events = events.select(events.t >= transient)
        periods = 0 if transient else self.periods
        return replace(
            self, t=late.t, state=late.states, events=events, error=error, periods=periods
        )

    def mean(self, transient: float | None = None, *, of: str | None = None) -> float:
        """Time average of a coordinate or rate after ``transient``.

        Parameters
        ----------
        transient : float, optional
            Time before which the motion is ignored, by default three quarters of its end time.
        of : str, optional
            A coordinate or its rate, as ``"y"`` or ``"vx"``; by default the first coordinate.

        Returns
        -------
        float

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> round(tr.mean(), 4)
        0.2501
        """
        late = self.after(transient)
        return late.integral(late._values(of)) / float(late.t[-1] - late.t[0])

    def rms(
        self, transient: float | None = None, *, of: str | None = None, about: str = "zero"
    ) -> float:
        """Root mean square of a coordinate or rate after ``transient``, about zero or about its
        mean.

        The article's Figure 7b shows the root mean square of x about zero.

        Parameters
        ----------
        transient : float, optional
            Time before which the motion is ignored, by default three quarters of its end time.
        of : str, optional
            A coordinate or its rate, as ``"y"`` or ``"vx"``; by default the first coordinate.
        about : str
            ``"zero"`` or ``"mean"``.

        Returns
        -------
        float

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> round(tr.rms(about="mean"), 4)
        0.2694
        """
        late = self.after(transient)
        deviation = late._values(of) - late._centre(of, about)
        return float(np.sqrt(late.integral(deviation**2) / (late.t[-1] - late.t[0])))

    def largest(
        self, transient: float | None = None, *, of: str | None = None, about: str = "zero"
    ) -> float:
        """Largest absolute value of a coordinate or rate after ``transient``, or with
        ``about="mean"`` its largest distance from the mean.

        Parameters
        ----------
        transient : float, optional
            Time before which the motion is ignored, by default three quarters of its end time.
        of : str, optional
            A coordinate or its rate, as ``"y"`` or ``"vx"``; by default the first coordinate.
        about : str
            ``"zero"`` or ``"mean"``.

        Returns
        -------
        float

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> round(tr.largest(of="vx"), 4)
        0.3996
        """
        late, row = self.after(transient), row_of(of, self.components)
        extrema = late.samples(np.append(late._extrema_t(row), late.t[[0, -1]]))[row]
        return magnitude(extrema - late._centre(of, about))

    def outcome(
        self,
        transient: float | None = None,
        *,
        tol: float | None = None,
        options: MotionOptions | None = None,
    ) -> Outcome:
        """The limit that the motion settles to or approaches, the rate of approach and the
        remaining distance, judged by the motion after ``transient``.

        A :class:`~spragsym.results.Sweep` gives the same. A cycle is computed by Newton's method
        (shooting), which integrates a few more periods.

        Parameters
        ----------
        transient : float, optional
            Time before which the motion is ignored, by default three quarters of its end time.
        tol : float, optional
            Largest distance to the limit of a motion that has settled, relative to the extent of
            the motion; by default 1e-4.
        options : MotionOptions, optional
            Tolerances by which a limit is recognized.

        Returns
        -------
        Outcome

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> tr.outcome().regime.name
        'LIMIT_CYCLE'
        """
        late = self.after(transient)
        # In units of the whole motion, in which it has been integrated: it may end as their noise.
        problem = prepare(
            self.model,
            self.p,
            start=tuple(self.state[:, 0].tolist()),
            t_end=float(late.t[-1] - late.t[0]),
            rtol=max(self.rtol, RELATIVE_TOLERANCE.low),
        )
        options = options or MotionOptions()
        if tol is not None:
            options = replace(options, settled=as_number("tol", tol, POSITIVE))
        problem = replace(problem, options=options)
        found = classify(late.statistics(), Onward(problem, self.backend))
        if found.rest and not self.model.clock:
            return replace(found, equilibrium=int(rest_index(self.p, np.array(found.rest))))
        return found

    def period(self, transient: float | None = None, *, tol: float | None = None) -> float:
        """Period of the cycle to which the motion after ``transient`` has settled.

        NaN at rest, and if the motion has not settled. For a cycle that the motion only approaches
        see :meth:`outcome`. The period is that of the cycle, whatever the distance to it.

        Parameters
        ----------
        transient : float, optional
            Time before which the motion is ignored, by default three quarters of its end time.
        tol : float, optional
            Largest distance to the limit of a motion that has settled, relative to the extent of
            the motion; by default 1e-4.

        Returns
        -------
        float
            In the model's unit of time.

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> round(tr.period(), 4)
        8.6233
        """
        outcome = self.outcome(transient, tol=tol)
        return outcome.period if outcome.regime == Regime.LIMIT_CYCLE else float("nan")

    def converged(self, transient: float | None = None, *, tol: float | None = None) -> bool:
        """True if the motion after ``transient`` has settled to rest or to a cycle, within ``tol``
        (see :meth:`outcome`).

        Parameters
        ----------
        transient : float, optional
            Time before which the motion is ignored, by default three quarters of its end time.
        tol : float, optional
            Largest distance to the limit of a motion that has settled, relative to the extent of
            the motion; by default 1e-4.

        Returns
        -------
        bool

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> tr.converged()
        True
        """
        return self.outcome(transient, tol=tol).regime in (Regime.EQUILIBRIUM, Regime.LIMIT_CYCLE)

    def statistics(self) -> MotionStatistics:
        """Maxima, minima, integrals and event counts of the motion, as
        :func:`~spragsym.motion.integrators.measure` accumulates them during an integration.

        Returns
        -------
        MotionStatistics

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> len(tr.statistics().maxima) > 10
        True
        """
        counts = (
            self._event_counts()
            if self.events is None
            else np.bincount(self.events.which, minlength=len(Event))
        )
        return statistics_of(self.samples, counts, self.model.field)

    def energy(self) -> FloatArray:
        """Energy at the samples: kinetic energy and the potentials of springs, contacts and applied
        forces. If the kinetic energy has terms that are linear in the rates, or without rates, this
        is Jacobi's integral.

        Returns
        -------
        ndarray, shape (n,)

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> tr.energy().shape == tr.t.shape
        True
        """
        algebra, given = self.model.algebra, self._arguments()
        position = np.split(self.state, 2)[0]
        strain = algebra.strain_energy(*position, *given, *self._in_contact())
        return strain + algebra.energy_besides_strain(*self.state, *given)

    def friction_power(self) -> FloatArray:
        """Power of friction at the samples: the rate at which it changes :meth:`energy`, positive
        while it drives the motion.

        Returns
        -------
        ndarray, shape (n,)

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> bool(tr.friction_power().max() > 0 > tr.friction_power().min())
        True
        """
        position, rates = np.split(self.state, 2)
        # A sliding speed is linear in the rates: its rate for zero rates and the accelerations
        # equal to the rates is minus the speed at which the mass itself slides.
        slides = self.model.algebra.border_rates(
            *position, *(0.0 * rates), *rates, *self._arguments()
        )[len(self.model.contacts) :]
        power = np.zeros(self.t.shape)
        for entry, slide in zip(self.model.frictions, slides, strict=False):
            power = power + self.friction_force(entry["name"]) * -slide
        return power

    @property
    def friction(self) -> FloatArray:
        """Friction force at the samples, for one friction: see :meth:`friction_force`."""
        return self.friction_force()

    def friction_force(self, contact: str | None = None) -> FloatArray:
        """Friction force at the samples, positive in the belt's direction; while the mass sticks,
        the force that holds it.

        At a sample where the force jumps, the value is the mean of both sides, weighted with the
        lengths of the steps before and after, so that integrals are right.

        Parameters
        ----------
        contact : str, optional
            Name of the contact, if the model has several with friction.

        Returns
        -------
        ndarray, shape (n,)

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("coulomb_stick_slip").Parameters(V=0.1), t_end=50.0)
        >>> round(float(tr.friction_force().max()), 4)
        0.5907
        """
        rubbing = self.model.rubbing
        name = rubbing[forces.contact_named(self.model, contact, rubbing)]
        force = getattr(self.model.algebra, forces.named("friction_force", name))
        in_contact = self._in_contact()
        in_layers = [1] * self.model.about["layers"]
        names = [entry["name"] for entry in self.model.contacts]
        pressed = in_contact.copy()
        pressed[self._two_faced] = 1  # on either face
        pressed = pressed[[names.index(one) for one in rubbing]]
        # A contact that is open has no friction. While it is open, its sliding speed may change
        # sign far from 0 between two samples, where the law of the other sign overflows.
        closed = pressed[rubbing.index(name)] != 0

        def with_signs(signs: IndexArray) -> FloatArray:
            signs = np.where(pressed | (signs != 0), signs, 1)
            values = force(*self.state, *self._arguments(), *in_contact, *signs, *in_layers)
            return np.where(closed, values, 0.0)

        after = self._slip_signs()
        before = np.concatenate([after[:, :1], after[:, :-1]], axis=1)
        with np.errstate(over="ignore", invalid="ignore"):
            values, limits_before = with_signs(after), with_signs(before)
        steps = np.diff(self.t)
        weight_before = np.divide(steps[:-1], steps[:-1] + steps[1:])
        jumps = (after != before).any(axis=0)
        values[1:-1] += np.where(jumps, limits_before - values, 0.0)[1:-1] * weight_before
        return values

    @property
    def sticking(self) -> float:
        """Share of time in which the mass sticks to the belt, of a model with one friction; 0 if
        its friction law cannot hold (see ``page.friction``). See :meth:`sticking_share`.
        """
        return self.sticking_share()

    def sticking_share(self, contact: str | None = None) -> float:
        """Share of time in which the mass sticks at a contact.

        Parameters
        ----------
        contact : str, optional
            Name of the contact, if the model has several with friction.

        Returns
        -------
        float
            Between 0 and 1.

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("coulomb_stick_slip").Parameters(V=0.1), t_end=50.0)
        >>> 0 < tr.sticking_share() < 1
        True
        """
        signs = self._slip_signs()[forces.contact_named(self.model, contact, self.model.rubbing)]
        return float(np.diff(self.t)[signs[:-1] == 0].sum() / (self.t[-1] - self.t[0]))

    def power(self) -> FloatArray:
        """Rate of change of :meth:`energy` at the samples: the power of friction, dampers and
        forces without a potential.

        Returns
        -------
        ndarray, shape (n,)

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> tr.power().shape == tr.t.shape
        True
        """
        in_contact = self._in_contact() if self.model.clock else ()
        return self.friction_power() + self.model.algebra.power_besides_friction(
            *self.state, *self._arguments(), *in_contact
        )

    def spring_force(self, spring: str | None = None) -> FloatArray:
        """Tension of an inclined spring at the samples, negative in compression.

        Parameters
        ----------
        spring : str, optional
            Name of the spring, if the model has several inclined ones.

        Returns
        -------
        ndarray, shape (n,)

        Examples
        --------
        >>> import numpy as np
        >>> import spragsym as ss
        >>> p = ss.Parameters.article(theta0=np.radians(49))
        >>> tr = ss.simulate(p, V=0.5, d=10.0, t_end=100.0)
        >>> bool(tr.spring_force().min() < 0)
        True
        """
        name = forces.spring_named(self.model, spring)
        return forces.forces_of(self.model)[name](self.state, self._arguments())

    def contact_force(self, contact: str | None = None) -> FloatArray:
        """Normal force of a contact at the samples, 0 while the mass has lifted off.

        Parameters
        ----------
        contact : str, optional
            Name of the contact, if the model has several.

        Returns
        -------
        ndarray, shape (n,)

        Examples
        --------
        >>> import numpy as np
        >>> import spragsym as ss
        >>> p = ss.Parameters.article(theta0=np.radians(49))
        >>> tr = ss.simulate(p, V=0.5, d=10.0, t_end=100.0)
        >>> bool(tr.contact_force().min() >= 0)
        True
        """
        names = [entry["name"] for entry in self.model.contacts]
        index = forces.contact_named(self.model, contact, names)
        return forces.contact_force(self.model, self.state, self._arguments(), index)

    def spectrum(
        self, transient: float | None = None, *, of: str | None = None, points: int = 4096
    ) -> Spectrum:
        """Amplitude spectrum of a coordinate or rate after ``transient``, through a Hann window;
        of whole periods of a cycle the Fourier coefficients. Frequencies are in cycles per unit of
        time.

        Parameters
        ----------
        transient : float, optional
            Time before which the motion is ignored, by default three quarters of its end time, or
            of whole periods 0.
        of : str, optional
            A coordinate or its rate, as ``"y"`` or ``"vx"``; by default the first coordinate.
        points : int
            Number of equidistant points of which the spectrum is taken; of whole periods there are
            ``points`` // 64 harmonics.

        Returns
        -------
        Spectrum

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> round(tr.spectrum().peak(), 3), tr.spectrum().window
        (0.116, 'Hann')
        """
        row = row_of(of, self.components)
        if self.periods and not transient:
            count = as_count("points", points, 64, 2**20) // 64
            return harmonics_of(self.samples, row, self.periods, count)
        return spectrum_of(self.after(transient).samples, row, points)

    def decay_rate(self, transient: float = 0.0, *, of: str | None = None) -> float:
        """Exponential decay rate of the swings of a coordinate after ``transient``, negative if
        they grow.

        The logarithm of the swings, from each extremum to the next, is fitted linearly in time. NaN
        for fewer than two swings. For motions that decay to rest; towards a cycle see
        :meth:`outcome`.

        Parameters
        ----------
        transient : float
            Time before which the motion is ignored.
        of : str, optional
            A coordinate or its rate, as ``"y"`` or ``"vx"``; by default the first coordinate.

        Returns
        -------
        float
            In 1 over the unit of time.

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=2.0), t_end=200.0)
        >>> round(tr.decay_rate(), 4)
        0.0126
        """
        row, late = row_of(of, self.model.coordinates), self.after(transient)
        times = np.sort(late._extrema_t(row))
        extrema, middles = late.samples(times)[row], (times[1:] + times[:-1]) / 2
        swings = np.abs(np.diff(extrema))
        above_rounding = swings > 1e-13 * max(np.abs(extrema).max(initial=0.0), 1e-300)
        swings, middles = swings[above_rounding], middles[above_rounding]
        if len(swings) < 2:
            return float("nan")
        slope, _ = np.polyfit(middles - middles[0], np.log(swings), 1)
        return -float(slope)

    def to_xarray(self) -> Dataset:
        """An ``xarray.Dataset`` with units and provenance (extra ``sweep``).

        Returns
        -------
        xarray.Dataset

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> list(tr.to_xarray().dims)
        ['t', 'event_t']
        """
        t, at, error, event, contact = map(
            self._own, ("t", "event_t", "error", "event", "event_contact")
        )
        data = {name: (t, self[name]) for name in self.components}
        if self.error is not None:
            data[error] = (t, self.error)
        coords = {t: self.t}
        if self.events is not None:
            coords[at] = self.events.t
            data[event] = (at, self.events.which.astype(np.int8))
            if self.events.contact:
                data[contact] = (at, np.array(self.events.contact))
        return storage.dataset(data, coords, self._attributes() | self._facts, self._in_model_units)

    def _values(self, of: str | None) -> FloatArray:
        return self.state[row_of(of, self.components)]

    def _centre(self, of: str | None, about: str) -> float:
        return self.mean(0.0, of=of) if one_of("about", about, ("zero", "mean")) == "mean" else 0.0

    def _extrema_t(self, row: int) -> FloatArray:
        """Times of all local extrema of a component: of a coordinate, the zeros of its rate."""
        n = len(self.components) // 2
        if row >= n:
            return self.samples.turns(row)
        return PiecewisePolynomial(self.t, self.state[[row + n]]).zeros()

    def _arguments(self) -> list[float]:
        return [float(value) for value in self.model.arguments(self.p, "motion")]

    def _levels(self) -> tuple[FloatArray, FloatArray]:
        """Gap of each contact, and sliding speed of each friction, at the samples: a row each.

        The gap of a contact that never opens is −1.
        """
        levels = self.model.algebra.borders(*self.state, *self._arguments())
        gaps = [
            gap if entry["border"] else np.full(self.t.shape, -1.0)
            for gap, entry in zip(levels, self.model.contacts, strict=False)
        ]
        return np.array(gaps), np.array(levels[len(gaps) :])

    def _slip_signs(self) -> IndexArray:
        """Sign of each sliding speed at the samples, 0 while it sticks: a row per friction."""
        field, constants = self.model.field, self._arguments()
        speeds = self._levels()[1]
        if not field.sticking_borders:
            return np.where(speeds >= 0, 1, -1)
        first = len(self.model.contacts)
        slots = slice(first, first + len(speeds))
        modes = [field.initial_mode(state, constants) for state in self.state.T.tolist()]
        return np.array([mode[slots] for mode in modes]).T

    @property
    def _two_faced(self) -> BoolArray:
        """True for each contact that presses on either of two faces."""
        return np.array([forces.presses_either(entry) for entry in self.model.contacts])

    def _in_contact(self) -> IndexArray:
        """1 for each contact and sample in contact, 0 in lift-off."""
        return (self._levels()[0] < 0).astype(int)

    def _event_counts(self) -> IndexArray:
        """Number of events of each kind, in the order of :class:`Event`, from the samples, which
        include all events.
        """
        signs = self._slip_signs()
        opened = np.diff((self._levels()[0] > 0).astype(int))
        stuck = np.diff((signs == 0).astype(int))
        faces, reversals = self._two_faced, np.diff(signs) / -2
        changes = opened[~faces], reversals, stuck, opened[faces]
        return np.array([np.count_nonzero(each == step) for each in changes for step in (1, -1)])

    def _attributes(self) -> dict[str, Any]:
        values = dict(
            zip(self.model.parameters, self.p.scalars(*self.model.parameters), strict=True)
        )
        angles = {f"{name}_deg": degrees(values[name]) for name in self.model.about["angles"]}
        settings = {"rtol": self.rtol, "backend": self.backend}
        return {**storage.provenance(), "model": self.model.name, **values, **angles, **settings}


def row_of(of: str | None, offered: tuple[str, ...]) -> int:
    """Index of the component named ``of``, 0 for None; raises ParameterError for other names."""
    return 0 if of is None else offered.index(one_of("of", of, offered))


def started(
    p: ParameterSet, values: Mapping[str, ArrayLike | None]
) -> tuple[ParameterSet, dict[str, ArrayLike]]:
    """Split keyword values into ``p`` with new parameters, and numbers of the initial state."""
    given = {name: value for name, value in values.items() if value is not None}
    initial = {f"{name}0" for name in p.model.components} | {*given} - {*p.ranges}
    return (
        p.given(**{name: value for name, value in given.items() if name not in initial}),
        {name: value for name, value in given.items() if name in initial},
    )


def named_state(start: Mapping[str, ArrayLike], names: Sequence[str]) -> dict[str, ArrayLike]:
    """The numbers of a state by name, which has to be one of ``names``."""
    if unknown := [name for name in start if name not in names]:
        raise ParameterError(
            f"start has {unknown[0]!r}{hint(unknown[0], names)}; the state is {', '.join(names)}"
        )
    return dict(start)


def initial_state(
    model: Model,
    start: Start | None,
    initial: Mapping[str, ArrayLike],
    p: ParameterSet | None = None,
) -> dict[str, FloatArray]:
    """The initial state by names, ``x0`` for ``x`` and ``vx0`` for ``vx``; 0 unless given.

    ``start`` has all numbers or single ones by name, ``initial`` single ones. The rate of a clock
    is that at ``p``; ``start`` may lack it, or both it and the clock's phase, which is then 0.
    """
    names = [f"{name}0" for name in model.components]
    values: dict[str, ArrayLike] = dict.fromkeys(names, 0.0)
    if model.clock:
        values[names[-1]] = rate = (
            np.zeros(()) if p is None else model.algebra.clock(*model.arguments(p, "motion"))
        )
    if isinstance(start, Mapping):
        named = named_state(start, model.components)
        initial = {f"{name}0": value for name, value in named.items()} | dict(initial)
    elif start is not None:
        given = as_numbers("start", start)
        if model.clock and given.shape == (len(names) - 2,):
            given = np.insert(given, len(names) // 2 - 1, 0.0)
        if given.shape not in {(len(names),), (len(names) - bool(model.clock),)}:
            raise ParameterError(f"start has the shape {given.shape}; it is {', '.join(names)}")
        values |= zip(names, given, strict=False)
    for name, value in initial.items():
        if name not in values:
            remedy = hint(name, [*names, *model.parameters]) or (
                f"; the initial state is {', '.join(names)}, and the parameters are "
                f"{', '.join(model.parameters)}"
            )
            raise ParameterTypeError(f"{name} is no argument{remedy}")
        values[name] = value
    if model.clock and not np.all(np.abs(np.asarray(values[names[-1]]) - rate) <= 1e-9 * rate):
        raise ParameterError(
            f"{names[-1]} is the rate of the clock, which keeps it; leave it out, and give "
            f"the phase at which the motion begins, as {model.clock}0=1.57"
        )
    return {
        name: as_numbers(name, value, model.any_of(name.removesuffix("0")))
        for name, value in values.items()
    }


def state_of(
    model: Model,
    start: Start | None,
    initial: Mapping[str, ArrayLike] | None = None,
    p: ParameterSet | None = None,
) -> FloatArray:
    """:func:`initial_state` as an array of shape (2 n,), for scalar values."""
    return np.array(
        [
            as_number(name, value)
            for name, value in initial_state(model, start, initial or {}, p).items()
        ]
    )


def motion_of(
    field: Field, values: Sequence[float], state: FloatArray, t_end: float, **options: Any
) -> Trajectory:
    """Simulate the model of a field, with the values of its parameters in order."""
    p = field.parameter_set(**dict(zip(field.parameters, values, strict=True)))
    return simulate(p, start=np.asarray(state), t_end=t_end, **options)


def _error(found: Trajectory, problem: Problem) -> FloatArray:
    """Estimated error of a trajectory, as :attr:`Trajectory.error`, by a second run with the
    tightest tolerance, by heyoka if it is installed.
    """
    offered = integrators.offered_for(found.model)
    rounded_start = tuple(value * (1.0 + np.finfo(float).eps) for value in problem.start)
    for backend in dict.fromkeys(("heyoka", found.backend, *offered)):
        if not integrators.is_there(backend):
            continue
        tightest = TIGHTEST if backend == "heyoka" else RTOL
        tight = replace(problem, rtol=tightest, start=rounded_start)
        try:
            other = _run(found.model, found.p, tight, backend)
        except ConvergenceError:
            continue
        same_method = other.implicit == found.implicit and (
            found.implicit or backend == found.backend
        )
        # A run by the same method shows the error if its tolerance is a hundred times smaller.
        if not same_method or other.rtol <= 0.0101 * found.rtol:
            states = other(np.minimum(found.t, other.t[-1]))
            # The second run's own error is at most a quarter of this one's. (Of SciPy's tightest
            # run it is up to a ninth, as its interpolant's error does not fall with the tolerance.)
            difference = np.abs(found.state - states).max(axis=0) / (1.0 - 0.25)
            rates = [found.samples.slopes(row) for row in range(len(states))]
            # Times are rounded, too: of the samples, and of the steps that they belong to.
            error = difference + 2 * np.spacing(found.t) * np.abs(rates).max(axis=0)
            if found.events:  # from a border to the step's end, samples are of the mode before
                steps, begins = found.samples.steps, found.events.t
                ends = steps[np.minimum(np.searchsorted(steps, begins), len(steps) - 1)]
                late = np.abs(found(ends).T - found.events.state).max(axis=1)
                np.maximum.at(error, np.searchsorted(found.t, begins, side="right") - 1, late)
            return np.maximum.accumulate(error)
    return np.full(found.t.shape, np.nan)


def _run(model: Model, p: ParameterSet, problem: Problem, backend: str) -> Trajectory:
    """Integrate a problem with a backend."""
    solution = integrators.integrate(problem, backend)
    events = events_of(problem.field, solution.crossings)
    return Trajectory(
        model,
        p,
        solution.samples.t,
        solution.samples.states,
        events,
        solution.rtol,
        backend,
        implicit=solution.implicit,
    )
