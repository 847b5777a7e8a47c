"""Motion in time: a model integrated from an initial state."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ..core.error_states import in_usual_state
from ..core.errors import ConvergenceError, ParameterError, ParameterTypeError, hint, one_of
from ..core.questions import model_of
from ..display import Column, Table, caption
from ..files import storage
from ..models import forces
from ..models.field import Field
from ..models.parameters import (
    NOT_NEGATIVE,
    POSITIVE,
    FloatArray,
    ParameterSet,
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
from .measures import MotionStatistics, Spectrum, spectrum_of, statistics_of
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


@in_usual_state
def simulate(
    p: ParameterSet,
    *,
    start: ArrayLike | None = None,
    t_end: float = 2000.0,
    rtol: float = 1e-10,
    events: bool = True,
    estimate_error: bool = False,
    backend: str | None = None,
    max_steps: int = MAX_STEPS,
    **values: float | None,
) -> Trajectory:
    """Integrate the motion of a model from an initial state, the article's (8)–(11) among them.

    The integrator is restarted at every kink of the field, y = 0 and x' = V for the article's
    model, whether or not the events are kept.

    Parameters
    ----------
    p : Parameters of any model
        Scalars.
    start : array_like, shape (2 n,), optional
        Coordinates, then rates.
    t_end : float
        Until when, in the model's unit of time: sqrt(m/k_c).
    rtol : float
        Relative tolerance of a step, in [1e-13, 1e-2]; the absolute one is a thousandth of it, in
        units of the motion's own (:mod:`spragsym.motion.scales`).
    events : bool
        Keep the events.
    estimate_error : bool
        Run again, from a start within rounding of this one and at the tightest tolerance there is,
        by heyoka where it is installed, and keep the difference as ``error``.
    backend : {"heyoka", "compiled", "scipy"}, optional
        Taylor series (extra ``fast``), or DOP853 in compiled code (the article's model) or in
        Python; by default the first of these that is installed. They agree to the tolerance.
    max_steps : int
        Where to give up. A smooth motion takes a few steps per time unit; a stiff one, of large d,
        up to d times the friction, as it creeps. Ten million take heyoka some ten seconds to a
        minute, and several GB to keep.
    **values : float, optional
        Parameters in place of those of ``p``, as ``V=0.5, d=10.0``, and the initial state number
        by number, by the names of the model's coordinates and rates, as ``x0, y0, vx0, vy0``; 0
        where nothing is given. For the article's model that is rest at x = y = 0, which lies on a
        kink.

    Returns
    -------
    Trajectory

    Raises
    ------
    ParameterError, ParameterTypeError
        For arguments that make no sense, and a start at which a spring has no length: at the
        article's anchor (8) is singular.
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
    trajectory = _run(model, p, problem, chosen)
    if estimate_error:
        trajectory = replace(trajectory, error=_error(trajectory, problem))
    return trajectory if events else replace(trajectory, events=None)


@dataclass(frozen=True, eq=False)
class Trajectory(Named):
    """A motion in time, as accurate between the samples as on them.

    The samples are the Gauss–Lobatto points of every step that the integrator took, its ends and
    all events among them: ``degree + 1`` to a step, consecutive steps sharing one. The motion is
    the polynomial through them, so that integrals and values in between lose nothing against the
    integration. A coordinate or its rate is an attribute of its name, as ``tr.x`` and ``tr.vx``.

    Attributes
    ----------
    model : Model
        Its page says the units; the article's are sqrt(m/k_c) for times, L_0 for lengths, k_c L_0
        for forces.
    p : Parameters of the model
        Scalars.
    t : ndarray, shape (k,)
        Time in the model's unit.
    state : ndarray, shape (2 n, k)
        The n coordinates, then their rates; x, y, x', y' for the article's model.
    events : Events or None
        Contact lost and regained, slip reversed, sticking begun and ended; None when not asked for.
    rtol : float
        The relative tolerance of a step that was used: less than what was asked for where a border
        is curved, and at least 1e-12 where ``implicit``.
    backend : str
        Which integrator ran.
    error : ndarray, shape (k,), or None
        Estimated: largest of the 2 n |differences| up to this time to a second run, as tight as
        there is and from a start within rounding, over 0.9, as that run has an error too; NaN where
        none of the same method is a hundred times as tight, nor one of another there, so that the
        error is not known; None when not asked for.
    implicit : bool
        Whether the motion is stiff, and SciPy's Radau carried it, as the steps of ``backend``
        collapsed.
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
        """First, smallest, largest and last value of each coordinate and rate, in place of all
        samples.

        Returns
        -------
        Table
            Titles, units, and a row for each extreme.

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> len(tr.as_table().rows)
        2
        """
        said, t = self._schema, self.t
        rows = [
            (
                said.heading(key),
                *(
                    said.cell(key, value)
                    for value in (values[0], values.min(), values.max(), values[-1])
                ),
            )
            for key, values in zip(self.components, self.state, strict=True)
        ]
        shown = {"model": self.model.name, "p": self.p, "rtol": self.rtol}
        shown["backend"] = "SciPy's Radau" if self.implicit else self.backend
        if self.events is not None:
            shown["events"] = len(self.events)
        title = caption(
            said,
            f"Trajectory, t = {said.cell('t', t[0])} to {said.cell('t', t[-1])}",
            shown,
            f"{len(t)} samples",
        )
        return Table(title, ("", "first", "smallest", "largest", "last"), tuple(rows))

    @cached_property
    def samples(self) -> PiecewisePolynomial:
        """The polynomials through the samples."""
        return PiecewisePolynomial(self.t, self.state)

    @cached_property
    def weights(self) -> FloatArray:
        """Quadrature weights, shape (n,): ``(weights * f).sum()`` is the integral of f over
        time.
        """
        return self.samples.weights()

    def integral(self, values: ArrayLike) -> float:
        """Integral over time of ``values``, given at the samples.

        Parameters
        ----------
        values : array_like, shape (n,)
            Numbers at the samples.

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
        """Coordinates, then their rates, at any times within the trajectory, shape (2 n, …)."""
        times = as_numbers("t", t)
        if times.size and not (self.t[0] <= times.min() and times.max() <= self.t[-1]):
            raise ParameterError(
                f"t = {times.min():g} … {times.max():g} is not within the trajectory, "
                f"[{self.t[0]:g}, {self.t[-1]:g}]; simulate with a larger t_end"
            )
        return self.samples(times)

    def after(self, transient: float | None) -> Trajectory:
        """Motion after the time ``transient``, three quarters of the end if None, as a trajectory;
        an error if nothing is left.

        Parameters
        ----------
        transient : float or None
            Time at which the part begins.

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
        return replace(self, t=late.t, state=late.states, events=events, error=error)

    def mean(self, transient: float | None = None, *, of: str | None = None) -> float:
        """Time average of x, a model's first coordinate, (or ``of="y"``, ``"vx"``, ``"vy"``) after
        ``transient``.

        Parameters
        ----------
        transient : float, optional
            Time before which nothing counts, by default three quarters of the motion.
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
        """Root mean square after ``transient``: about zero, or with ``about="mean"`` about the
        mean.

        The article's Figure 7b shows the root mean square of x, from zero.

        Parameters
        ----------
        transient : float, optional
            Time before which nothing counts, by default three quarters of the motion.
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
        """Largest |x| after ``transient``: from zero, or with ``about="mean"`` from the mean.

        Parameters
        ----------
        transient : float, optional
            Time before which nothing counts, by default three quarters of the motion.
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
        extrema = late.samples(np.append(late._turns(row), late.t[[0, -1]]))[row]
        return magnitude(extrema - late._centre(of, about))

    def outcome(
        self,
        transient: float | None = None,
        *,
        tol: float | None = None,
        options: MotionOptions | None = None,
    ) -> Outcome:
        """Limit that the motion settles to or approaches, how fast, and what is left, judged by
        what follows ``transient``.

        The same as a :class:`~spragsym.results.Sweep` tells of it. A cycle is found by Newton's
        method on the flow and its derivatives, which integrates a few periods more.

        Parameters
        ----------
        transient : float, optional
            Time before which nothing counts, by default three quarters of the motion.
        tol : float, optional
            Share of the motion's reach that may be left, 1e-4 where it is left out.
        options : MotionOptions, optional
            Numbers by which a limit is told.

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
        start, length = tuple(late.state[:, 0].tolist()), float(late.t[-1] - late.t[0])
        problem = prepare(
            self.model,
            self.p,
            start=start,
            t_end=length,
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
        """Period of the cycle that the motion after ``transient`` has settled to; NaN if it has
        not, and at rest.

        It has settled when what is left to the cycle is at most ``tol`` of the motion's reach. The
        period is the cycle's own, whatever is left. For what a motion only approaches see
        :meth:`outcome`.

        Parameters
        ----------
        transient : float, optional
            Time before which nothing counts, by default three quarters of the motion.
        tol : float, optional
            Share of the motion's reach that may be left, 1e-4 where it is left out.

        Returns
        -------
        float
            In units of time; NaN where there is none.

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
        """Whether the motion after ``transient`` has settled to rest or to a cycle, within ``tol``
        (see :meth:`outcome`).

        Parameters
        ----------
        transient : float, optional
            Time before which nothing counts, by default three quarters of the motion.
        tol : float, optional
            Share of the motion's reach that may be left, 1e-4 where it is left out.

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
        """Measures on the way by :func:`~spragsym.motion.integrators.measure`, from the samples.

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
        """Kinetic and stored energy, contact and applied forces included, at the samples; with
        terms of the kinetic energy linear in the rates, or without them, Jacobi's integral.

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
        places = np.split(self.state, 2)[0]
        strain = algebra.strain_energy(*places, *given, *self._pushing())
        return strain + algebra.energy_besides_strain(*self.state, *given)

    def friction_power(self) -> FloatArray:
        """Rate at which friction changes that energy, at the samples: positive where it drives the
        motion.

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
        rates = np.split(self.state, 2)[1]
        slides = self.model.algebra.border_rates(
            *self.state[: len(rates)], *(0.0 * rates), *rates, *self._arguments()
        )[len(self.model.contacts) :]
        return sum(
            (
                self.friction_force(entry["name"]) * -slide
                for entry, slide in zip(self.model.frictions, slides, strict=False)
            ),
            np.zeros(self.t.shape),
        )

    @property
    def friction(self) -> FloatArray:
        """The force of the only friction at the samples: see :meth:`friction_force`."""
        return self.friction_force()

    def friction_force(self, contact: str | None = None) -> FloatArray:
        """The force of friction at the samples, positive in the belt's direction; while it sticks,
        what holds the mass. ``contact`` names one of several.

        Where it jumps, between both sides: so that integrals over the steps before and after are
        right.

        Parameters
        ----------
        contact : str, optional
            Name of one of several contacts.

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
        sides = self._sides()
        felt = [1] * self.model.about["layers"]
        pushing = self._pushing()
        gaps = np.diff(self.t)
        before = np.concatenate([sides[:, :1], sides[:, :-1]], axis=1)
        names = [entry["name"] for entry in self.model.contacts]
        rubs = pushing.copy()
        rubs[self._faces] = 1  # on the other face too
        presses = rubs[[names.index(one) for one in rubbing]]
        # What is not pressed has no friction. In lift-off a sliding speed may change its sign far
        # from 0 between samples, where the law of the other side overflows.
        pressed = presses[rubbing.index(name)] != 0
        with np.errstate(over="ignore", invalid="ignore"):
            own, last = (
                np.where(
                    pressed,
                    getattr(self.model.algebra, forces.named("friction_force", name))(
                        *self.state,
                        *self._arguments(),
                        *pushing,
                        *np.where(presses | (side != 0), side, 1),
                        *felt,
                    ),
                    0.0,
                )
                for side in (sides, before)
            )
        share = np.divide(gaps[:-1], gaps[:-1] + gaps[1:])
        jumps = (sides != before).any(axis=0)
        own[1:-1] += np.where(jumps, last - own, 0.0)[1:-1] * share
        return own

    @property
    def sticking(self) -> float:
        """The share of time in which the mass sticks to the belt: 0 where friction does not hold
        (see ``page.friction``). Of several contacts :meth:`sticking_share` tells it of one.
        """
        return self.sticking_share()

    def sticking_share(self, contact: str | None = None) -> float:
        """The share of time in which friction sticks; ``contact`` names one of several.

        Parameters
        ----------
        contact : str, optional
            Name of one of several contacts.

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
        sides = self._sides()[forces.contact_named(self.model, contact, self.model.rubbing)]
        return float(np.diff(self.t)[sides[:-1] == 0].sum() / (self.t[-1] - self.t[0]))

    def power(self) -> FloatArray:
        """Rate at which friction, dampers and forces without a potential change that energy, at the
        samples.

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
        pushing = self._pushing() if self.model.clock else ()
        return self.friction_power() + self.model.algebra.power_besides_friction(
            *self.state, *self._arguments(), *pushing
        )

    def spring_force(self, spring: str | None = None) -> FloatArray:
        """Tension of an inclined spring at the samples, negative where it pushes; ``spring`` names
        one of several.

        Parameters
        ----------
        spring : str, optional
            Name of one of several inclined springs.

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
        """Normal force of the contact at the samples: 0 where the mass has lifted off; ``contact``
        names one of several.

        Parameters
        ----------
        contact : str, optional
            Name of one of several contacts.

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
        """Amplitudes over frequency, in cycles per unit of time, of the motion after
        ``transient``.

        Parameters
        ----------
        transient : float, optional
            Time before which nothing counts, by default three quarters of the motion.
        of : str, optional
            A coordinate or its rate, as ``"y"`` or ``"vx"``; by default the first coordinate.
        points : int
            Points at equal steps from which it is taken.

        Returns
        -------
        Spectrum

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> round(tr.spectrum().peak(), 3)
        0.116
        """
        return spectrum_of(self.after(transient).samples, row_of(of, self.components), points)

    def decay_rate(self, transient: float = 0.0, *, of: str | None = None) -> float:
        """The rate at which the swings of a coordinate shrink after ``transient``, by least
        squares; negative where they grow.

        NaN where there are fewer than two swings. For motions that decay to rest; towards a cycle
        see :meth:`outcome`.

        Parameters
        ----------
        transient : float
            Time before which nothing counts.
        of : str, optional
            A coordinate or its rate, as ``"y"`` or ``"vx"``; by default the first coordinate.

        Returns
        -------
        float
            In one over the unit of time.

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=2.0), t_end=200.0)
        >>> round(tr.decay_rate(), 4)
        0.0126
        """
        row, late = row_of(of, self.model.coordinates), self.after(transient)
        turns = np.sort(late._turns(row))
        extrema, middle = late.samples(turns)[row], (turns[1:] + turns[:-1]) / 2
        swings = np.abs(np.diff(extrema))
        kept = swings > 1e-13 * max(np.abs(extrema).max(initial=0.0), 1e-300)
        if np.count_nonzero(kept) < 2:
            return float("nan")
        slope, _ = np.polyfit(middle[kept] - middle[kept][0], np.log(swings[kept]), 1)
        return -float(slope)

    def to_dataset(self) -> Dataset:
        """An ``xarray.Dataset`` with units and provenance (extra ``sweep``).

        Returns
        -------
        xarray.Dataset

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> list(tr.to_dataset().dims)
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
        return storage.dataset(data, coords, self._attributes(), self._in_model_units)

    # --------------------------------------------------------------------------------------------
    # inner parts

    def _values(self, of: str | None) -> FloatArray:
        return self.state[row_of(of, self.components)]

    def _centre(self, of: str | None, about: str) -> float:
        return self.mean(0.0, of=of) if one_of("about", about, ("zero", "mean")) == "mean" else 0.0

    def _turns(self, row: int) -> FloatArray:
        """Times of all local extrema: of a coordinate, where its rate passes 0."""
        n = len(self.components) // 2
        if row >= n:
            return self.samples.turns(row)
        return PiecewisePolynomial(self.t, self.state[[row + n]]).zeros()

    def _arguments(self) -> list[float]:
        return [float(value) for value in self.model.arguments(self.p, "motion")]

    def _levels(self) -> tuple[FloatArray, FloatArray]:
        """The contacts' borders, negative where there are none, and the sliding speeds at the
        samples: a row for each.
        """
        levels = self.model.algebra.borders(*self.state, *self._arguments())
        gaps = [
            gap if entry["border"] else np.full(self.t.shape, -1.0)
            for gap, entry in zip(levels, self.model.contacts, strict=False)
        ]
        return np.array(gaps), np.array(levels[len(gaps) :])

    def _sides(self) -> IndexArray:
        """The signs of the sliding speeds at the samples, 0 where the mass sticks: a row for each
        friction.
        """
        field, constants = self.model.field, self._arguments()
        slips = self._levels()[1]
        if not field.sticking_borders:
            return np.where(slips >= 0, 1, -1)
        first = len(self.model.contacts)
        sides = slice(first, first + len(slips))
        return np.array(
            [field.initial_mode(state, constants)[sides] for state in self.state.T.tolist()]
        ).T

    @property
    def _faces(self) -> BoolArray:
        """Contacts that press on either of two faces."""
        return np.array([forces.presses_either(entry) for entry in self.model.contacts])

    def _pushing(self) -> IndexArray:
        return (self._levels()[0] < 0).astype(int)

    def _event_counts(self) -> IndexArray:
        """Number of events of each kind, from the samples alone, which include all events."""
        sides = self._sides()
        lifted, stuck = (np.diff(part.astype(int)) for part in (self._levels()[0] > 0, sides == 0))
        opens, turns = lifted[~self._faces], lifted[self._faces]
        changes = (opens, 1), (np.diff(sides), -2), (stuck, 1), (turns, 1)
        return np.array(
            [
                np.count_nonzero(change == way * first)
                for change, first in changes
                for way in (1, -1)
            ]
        )

    def _attributes(self) -> dict[str, Any]:
        values = dict(
            zip(self.model.parameters, self.p.scalars(*self.model.parameters), strict=True)
        )
        angles = {f"{name}_deg": degrees(values[name]) for name in self.model.about["angles"]}
        settings = {"rtol": self.rtol, "backend": self.backend}
        return {**storage.provenance(), "model": self.model.name, **values, **angles, **settings}


def row_of(of: str | None, offered: tuple[str, ...]) -> int:
    """Row of a component that is asked for; of the first unless told otherwise."""
    return 0 if of is None else offered.index(one_of("of", of, offered))


def started(
    p: ParameterSet, values: Mapping[str, ArrayLike | None]
) -> tuple[ParameterSet, dict[str, ArrayLike]]:
    """Parameters with those among values by name, and the other values, of the initial state."""
    given = {name: value for name, value in values.items() if value is not None}
    initial = {f"{name}0" for name in p.model.components} | {*given} - {*p.ranges}
    return (
        p.given(**{name: value for name, value in given.items() if name not in initial}),
        {name: value for name, value in given.items() if name in initial},
    )


def initial_state(
    model: Model,
    start: ArrayLike | None,
    initial: Mapping[str, ArrayLike],
    p: ParameterSet | None = None,
) -> dict[str, FloatArray]:
    """The initial state by names, ``x0`` for ``x`` and ``vx0`` for ``vx``; 0 where nothing is
    given, of a clock the rate that it has at ``p``; ``start`` may be without that rate, and without
    the phase too.
    """
    names = [f"{name}0" for name in model.components]
    values: dict[str, ArrayLike] = dict.fromkeys(names, 0.0)
    if model.clock:
        values[names[-1]] = rate = (
            np.zeros(()) if p is None else model.algebra.clock(*model.arguments(p, "motion"))
        )
    if start is not None:
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
    start: ArrayLike | None,
    initial: Mapping[str, ArrayLike] | None = None,
    p: ParameterSet | None = None,
) -> FloatArray:
    """One initial state as an array; rest where nothing is given."""
    return np.array(
        [
            as_number(name, value)
            for name, value in initial_state(model, start, initial or {}, p).items()
        ]
    )


def motion_of(
    field: Field, values: Sequence[float], state: FloatArray, t_end: float, **options: Any
) -> Trajectory:
    """The motion of the model of a field, by the values of its parameters in order."""
    p = field.parameter_set(**dict(zip(field.parameters, values, strict=True)))
    return simulate(p, start=np.asarray(state), t_end=t_end, **options)


def _error(found: Trajectory, problem: Problem) -> FloatArray:
    """Largest difference so far to a motion from within rounding of the start, as tight as there
    is, by heyoka where that is installed; NaN where no run is tight enough.
    """
    offered = integrators.offered_for(found.model)
    beside = tuple(value * (1.0 + np.finfo(float).eps) for value in problem.start)
    for backend in dict.fromkeys(("heyoka", found.backend, *offered)):
        if not integrators.is_there(backend):
            continue
        tightest = TIGHTEST if backend == "heyoka" else RTOL
        try:
            other = _run(
                found.model, found.p, replace(problem, rtol=tightest, start=beside), backend
            )
        except ConvergenceError:
            continue
        alike = other.implicit == found.implicit and (found.implicit or backend == found.backend)
        # Share of a tolerance up to which another one of the same method tells its
        # error, rounding aside.
        if not alike or other.rtol <= 0.0101 * found.rtol:
            at = other(np.minimum(found.t, other.t[-1]))
            # Share of that error which the tighter run has, at most: of SciPy's
            # finest run up to a ninth, as the error of its interpolant does not fall
            # as the tolerance does.
            difference = np.abs(found.state - at).max(axis=0) / (1.0 - 0.25)
            return np.maximum.accumulate(difference)
    return np.full(found.t.shape, np.nan)


def _run(model: Model, p: ParameterSet, problem: Problem, backend: str) -> Trajectory:
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
