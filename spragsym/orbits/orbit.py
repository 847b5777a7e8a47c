"""A cycle as users see it: a closed orbit with its Floquet multipliers, stability, events, modes
and averages over one period.

:func:`cycle_of` makes it of an orbit from shooting: reduced to the least period, in a standard
phase, on a refined mesh, with error estimates.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..core.errors import ConvergenceError, ParameterError, ParameterTypeError
from ..core.remarks import At, Remark
from ..display import Column
from ..files import storage
from ..models.field import Field, Values
from ..models.model import Model
from ..models.parameters import FloatArray, as_count
from ..motion.lobatto import PiecewisePolynomial
from ..motion.measures import Spectrum
from ..motion.scales import scales_of
from ..motion.shooting import (
    Iterate,
    Orbit,
    closed_orbit,
    difference,
    error_of,
    extent,
    in_scales,
    integrated,
    least_period,
    natural,
    off_jumps,
    offset_from_jumps,
    phase,
    refined_mesh,
    remeshed,
)
from ..motion.simulation import Trajectory, motion_of
from ..motion.solution import Events, events_of
from ..numerics.interval_arrays import ComplexArray, Int8Array
from ..numerics.vectors import magnitude, state_difference
from ..results.result import Result

if TYPE_CHECKING:
    from xarray import Dataset

#: Cycles whose states differ by less than this share of their extent are the same.
SAME_STATES = 1e-5


@dataclass(frozen=True, eq=False)
class Cycle(Result):
    """A cycle: a periodic motion.

    ``spring_force`` and ``contact_force`` are ranges over one period, computed on access.

    Attributes
    ----------
    period : float
        The least period.
    state : ndarray, shape (m,)
        State of the cycle at which the first coordinate that moves is largest; for the article's
        model x, y, x' = 0, y'. Any state if that coordinate only rotates, or if dry friction
        changes its direction at the maximum, as on a belt at rest.
    multipliers : ndarray of complex, shape (m,)
        Floquet multipliers (eigenvalues of the monodromy matrix): first the trivial one, which is 1
        up to rounding, then a 1 for each direction in which friction holds the mass all the time,
        as of a block at rest beside another that moves, then the others by modulus. For a page with
        a clock these are the multipliers of the stroboscopic map.
    multiplier_errors : ndarray, shape (m − 1,)
        Estimated errors of all but the trivial one: their changes if the derivatives of the flow
        have errors as large as along the flow.
    stable : bool
        True if all others are inside the unit circle by more than their errors. Where friction
        holds the mass all the time there is such a cycle at each place that it holds.
    error : float
        Estimated error of state and period: the sensitivity of the orbit times its largest gap, or
        times the difference to the flow without derivatives; at least the error of the trivial
        multiplier.
    residual : float
        Largest gap of the orbit.
    events : Events
        Events over one period; ``t`` is counted from ``state``.
    rms, mean, amplitude : float
        Root mean square about zero, mean, and half the range of the first coordinate over one
        period. If it rotates, the first two are NaN, and the last is π; if it may be shifted, as of
        what is tied to no place, they are NaN.
    backend : str
        The integrator.
    orbit : Orbit
        The solution of shooting, with derivatives.
    """

    schema = (
        Column("period", "s", "period of the cycle"),
        Column("error", "{x}", "estimated error of state and period"),
        Column("residual", "", "by how much the orbit does not close"),
        Column("rms", "{x}", "root mean square of {x} about zero over one period"),
        Column("mean", "{x}", "mean of {x} over one period"),
        Column("amplitude", "{x}", "half of the range of {x}"),
    )

    period: float
    state: FloatArray
    multipliers: ComplexArray
    multiplier_errors: FloatArray
    stable: bool
    error: float
    residual: float
    events: Events
    rms: float
    mean: float
    amplitude: float
    backend: str
    orbit: Orbit = dataclasses.field(repr=False)

    @property
    def field(self) -> Field:
        """The field of the motion."""
        return self.orbit.field

    @property
    def _of_model(self) -> Model | None:
        return self.field.model

    def require(self, field: Field, name: str) -> None:
        """Raise ParameterTypeError unless this is a cycle of the model of ``field``.

        Parameters
        ----------
        field : Field
            Field of the required model.
        name : str
            Name of the argument, for the error message.

        Examples
        --------
        >>> import spragsym as ss
        >>> cycle = ss.cycle(ss.load("stick_slip").Parameters(V=0.2))
        >>> cycle.require(cycle.field, "cycle")
        >>> cycle.period > 0
        True
        """
        own = self.field
        if own.with_lead(field.lead) != field and not (own.where and own.where == field.where):
            one, other = (each.name.partition(":")[0] for each in (own, field))
            raise ParameterTypeError(
                f"{name} is a cycle of {one}, not of {other}; give one of the same model"
            )

    @property
    def values(self) -> tuple[float, ...]:
        """The parameters, in the order of ``field.parameters``."""
        return self.orbit.values

    @property
    def drift(self) -> FloatArray:
        """By how much a period shifts each coordinate, shape (n,), 0 without such shifts.

        A cycle that closes up to a shift is a *relative periodic orbit*: it has one more
        multiplier 1 for each direction of a shift, after the trivial one.
        """
        return self.orbit.drift

    @property
    def moves_on(self) -> Remark | str:
        """Text to follow a cycle that closes up to a shift; empty for others."""
        moved = [
            At(name, (float(shift),), ".6g", "rad" * self.field.column(name).is_angle)
            for name, shift in zip(self.field.coordinates, self.drift, strict=True)
            if abs(shift) > 10 * self.error
        ]
        if not moved:
            return ""
        text = ", a relative periodic orbit: it shifts by " + ", ".join(["{}"] * len(moved))
        return Remark(text + " in each period", *moved)

    @cached_property
    def samples(self) -> PiecewisePolynomial:
        """One period as a piecewise polynomial."""
        return self.orbit.samples()

    @cached_property
    def phases(self) -> Phases:
        """The sequence of modes in one period."""
        t = np.array([0.0, *self.events.t, self.period])
        states = self.samples((t[1:] + t[:-1]) / 2).T
        modes = np.array([self.orbit.mode(state) for state in states], dtype=np.int8)
        model = self.field.model
        if model is None or len(model.contacts) == 1:
            return Phases(t[:-1], np.diff(t), *modes[:, :2].T)
        names, rubbing = tuple(entry["name"] for entry in model.contacts), model.rubbing
        first, last = len(names), len(names) + len(rubbing)
        contact, side = np.split(modes[:, :last], [first], axis=1)
        return Phases(t[:-1], np.diff(t), contact, side, names, rubbing)

    @property
    def spring_force(self) -> tuple[float, float]:
        """Smallest and largest tension of the inclined spring, over k_c L_0."""
        return self._force("spring_force")

    @property
    def contact_force(self) -> tuple[float, float]:
        """Smallest and largest normal force of the contact, over k_c L_0."""
        return self._force("contact_force")

    @cached_property
    def forces(self) -> dict[str, tuple[float, float]]:
        """Smallest and largest value over one period of every force of the model, by name; several
        springs have ``spring_force_1``, ….
        """
        return {
            name: _range(self.samples, force, self.orbit.constants)
            for name, force in self.field.forces
        }

    def _force(self, name: str) -> tuple[float, float]:
        if name not in self.forces:
            raise ParameterError(
                f"{name} is no force of this model, which has "
                f"{', '.join(self.forces) or 'none'}; see forces"
            )
        return self.forces[name]

    @cached_property
    def parameters(self) -> dict[str, float]:
        """The parameters by name."""
        return dict(zip(self.field.parameters, self.values, strict=True))

    def trajectory(self, periods: float = 1.0, **options: Any) -> Trajectory:
        """The motion over a number of periods, as :func:`~spragsym.simulate` gives it.

        Parameters
        ----------
        periods : float
            Number of periods.
        **options
            Options of :func:`spragsym.simulate`.

        Returns
        -------
        Trajectory

        Examples
        --------
        >>> import spragsym as ss
        >>> cycle = ss.cycle(ss.load("stick_slip").Parameters(V=0.2))
        >>> tr = cycle.trajectory(2.0)
        >>> round(float(tr.t[-1] / cycle.period), 9)
        2.0
        """
        chosen = {"rtol": 1e-13, "backend": self.backend} | options
        motion = motion_of(self.field, self.values, self.state, periods * self.period, **chosen)
        return replace(motion, periods=int(periods) if periods == int(periods) else 0)

    def spectrum(self, *, of: str | None = None, harmonics: int = 64) -> Spectrum:
        """Fourier coefficients of a coordinate or rate: amplitudes and phases of its harmonics,
        without a window.

        Parameters
        ----------
        of : str, optional
            A coordinate or its rate, as ``"y"`` or ``"vx"``; by default the first coordinate.
        harmonics : int
            Number of harmonics.

        Returns
        -------
        Spectrum

        Examples
        --------
        >>> import spragsym as ss
        >>> cycle = ss.cycle(ss.load("stick_slip").Parameters(V=0.2))
        >>> cycle.spectrum().amplitude[1:4].round(4)
        array([0.3662, 0.088 , 0.017 ])
        """
        points = 64 * as_count("harmonics", harmonics, 1, 2**14)
        return self.trajectory().spectrum(of=of, points=points)

    def to_xarray(self) -> Dataset:
        """An ``xarray.Dataset`` of the samples of one period, with all other results as attributes
        (extra ``sweep``).

        Returns
        -------
        xarray.Dataset

        Examples
        --------
        >>> import spragsym as ss
        >>> cycle = ss.cycle(ss.load("stick_slip").Parameters(V=0.2))
        >>> cycle.to_xarray().sizes["t"] > 10
        True
        """
        dataset = self.trajectory().to_xarray()
        dataset.attrs |= {
            "cycle_period": self.period,
            "cycle_stable": int(self.stable),
            "cycle_error": self.error,
            "cycle_residual": self.residual,
            "cycle_multipliers_real": self.multipliers.real,
            "cycle_multipliers_imaginary": self.multipliers.imag,
            "cycle_rms": self.rms,
            "cycle_mean": self.mean,
        }
        return dataset

    def _save_columns(self, path: Path) -> None:
        """Write one period to ``*.nc`` (extra ``sweep``), or its samples alone to ``*.csv``."""
        motion = self.trajectory()
        storage.write(
            path, self.to_xarray, motion.data(), motion._attributes(), motion._in_model_units
        )

    def __repr__(self) -> str:
        return (
            f"Cycle(period={self.period:.10g}, state={np.round(self.state, 8).tolist()}, "
            f"stable={self.stable}, "
            f"largest multiplier={magnitude(self.multipliers[1:]):.6g})"
        )


def cycle_of(orbit: Orbit) -> Cycle:
    """The cycle of a closed orbit, starting where the first coordinate that moves is largest.

    Raises ConvergenceError if the trivial multiplier is not 1, which shows that the derivatives of
    the flow are inaccurate.
    """
    orbit = least_period(in_scales(orbit).bound().with_lead())
    orbit = refined(orbit, orbit.top.t if orbit.top else 0.0)
    shifted = off_jumps(orbit)
    if shifted is not orbit:
        orbit = refined(shifted, offset_from_jumps(shifted))
    found = orbit.multipliers
    trivial_error = abs(found.trivial - 1)
    if not trivial_error < orbit.options.trivial:
        raise ConvergenceError(
            "the derivatives of the flow are not resolved: the trivial multiplier is "
            f"{found.trivial:.6g} instead of 1; "
            "use another backend, or a less steep friction law"
        )
    own, scales = natural(orbit), orbit.field.scales
    (mean, rms), (lowest, highest) = own.moments(), range_of(own)
    size = max(scales.states.tolist()) if scales else 1.0
    unit = max(orbit.field.time, size)
    return Cycle(
        period=own.period,
        state=own.state.copy(),
        multipliers=found.values,
        multiplier_errors=np.append(np.zeros(found.held), found.errors),
        stable=is_stable(orbit),
        error=max(unit * error_of(orbit, difference(orbit)), trivial_error),
        residual=size * orbit.largest_gap,
        events=events_of(own.field, own.crossings()),
        rms=rms,
        mean=mean,
        amplitude=(highest - lowest) / 2,
        backend=own.flow.backend,
        orbit=own,
    )


def same_cycle(one: Cycle, other: Cycle) -> bool:
    """True if two cycles at the same values of the parameters are the same.

    Period and averages must agree to 1e-6, and the state of one must lie on the other, within
    :data:`SAME_STATES` of the extent.
    """
    units, tolerance = units_of(one), 1e-6
    size = max(extent(one.orbit, units), extent(other.orbit, units))
    averages = np.abs([one.rms - other.rms, one.mean - other.mean]) / units[0]
    if abs(one.period / other.period - 1) >= tolerance or averages.max() >= tolerance * size:
        return False
    return apart(one, other.state[None]) < SAME_STATES * size


def apart(cycle: Cycle, states: FloatArray) -> float:
    """The largest distance of states, (k, m), from a cycle as a curve, modulo whole turns, in units
    of the motion: from the nearest sample along the flow to where the rest is normal to it.
    """
    samples, units = cycle.samples, units_of(cycle)

    def off(places: FloatArray) -> FloatArray:
        found: FloatArray = state_difference(states, places, cycle.field.periodic) / units
        return found

    nearest = [
        np.square(state_difference(samples.states.T, state, cycle.field.periodic) / units)
        .sum(axis=1)
        .argmin()
        for state in states
    ]
    t = samples.t[nearest]
    for _ in range(4):
        places = samples(t).T
        flow = np.array([cycle.orbit.rate(place) for place in places]) / units
        square = np.square(flow).sum(axis=1)
        along = (off(places) * flow).sum(axis=1)
        t = (t + np.divide(along, square, np.zeros_like(t), where=square > 0)) % cycle.period
    return float(np.abs(off(samples(t).T)).max())


def units_of(cycle: Cycle) -> FloatArray:
    """Units of the motion on a cycle, (m,)."""
    return scales_of(cycle.field, cycle.orbit.constants, cycle.orbit.state.tolist()).states


def distance(cycle: Cycle, state: FloatArray) -> float:
    """Distance of a state from the nearest sample of a cycle, modulo whole turns, in units of the
    motion.
    """
    off = state_difference(cycle.samples.states.T, state, cycle.field.periodic) / units_of(cycle)
    return float(np.abs(off).max(axis=1).min())


@dataclass(frozen=True, eq=False)
class Phases(Result):
    """The modes of one period, in order of time.

    Attributes
    ----------
    t, duration : ndarray, shape (k,)
        Begin of each mode, counted from the state of the cycle, and its duration.
    contact : ndarray of int, shape (k,) or (k, contacts)
        1 in contact, 0 in lift-off; for a contact that presses on either of two faces 1 if N is not
        negative, 0 on the opposite face.
    side : ndarray of int, shape (k,) or (k, frictions)
        1 if the belt is faster than the mass, −1 if the mass is, 0 while it sticks.
    contacts, rubbing : tuple of str
        Names of the contacts, and of those with friction, if there are several contacts.
    """

    schema = (
        Column("t", "s", "begin of the mode"),
        Column("duration", "s", "duration of the mode"),
        Column("contact", "1", "1 in contact, 0 in lift-off or on the opposite face"),
        Column("side", "1", "1 where the belt is ahead, -1 where the mass is, 0 where it sticks"),
    )

    t: FloatArray
    duration: FloatArray
    contact: Int8Array
    side: Int8Array
    contacts: tuple[str, ...] = dataclasses.field(default=(), repr=False)
    rubbing: tuple[str, ...] = dataclasses.field(default=(), repr=False)

    def _shown(self) -> dict[str, Any]:
        """Columns of the table, one for each of several contacts."""
        whole = {} if self.contacts else {"contact": self.contact, "side": self.side}
        return {
            "t": self.t,
            "duration": self.duration,
            **whole,
            **{f"contact_{name}": self.contact[:, k] for k, name in enumerate(self.contacts)},
            **{f"side_{name}": self.side[:, k] for k, name in enumerate(self.rubbing)},
        }


@dataclass(frozen=True, eq=False)
class Cycles(Sequence[Cycle]):
    """A sequence of cycles, each computed from its closed orbit on first access."""

    orbits: tuple[Orbit, ...]

    @cached_property
    def _known(self) -> dict[int, Cycle]:
        return {}

    def __len__(self) -> int:
        return len(self.orbits)

    def __getitem__(self, index: int | slice) -> Any:
        chosen = range(len(self))[index]
        if isinstance(chosen, range):
            return tuple(self[i] for i in chosen)
        if chosen not in self._known:
            self._known[chosen] = cycle_of(self.orbits[chosen])
        return self._known[chosen]


def is_stable(orbit: Orbit) -> bool:
    """True if all multipliers but the trivial one are inside the unit circle by more than their
    errors.
    """
    found = orbit.multipliers
    return bool((np.abs(found.others) + found.errors < 1 - orbit.options.neutral).all())


def range_of(orbit: Orbit) -> tuple[float, float]:
    """Smallest and largest value of the first coordinate, over its extrema and the mesh nodes; ∓π
    if it rotates, NaN if it may be shifted.
    """
    if orbit.winding:
        return -math.pi, math.pi
    if orbit.shifted[0]:
        return math.nan, math.nan
    values = [
        *(float(extremum.state[0]) for extremum in orbit.extrema() if extremum.border == -1),
        *orbit.states[:, 0].tolist(),
    ]
    return min(values), max(values)


def refined(orbit: Orbit, begin: float) -> Orbit:
    """The orbit with another starting time, on a mesh that is refined until deviations grow little
    per interval.

    Newton's method corrects it, by at most 1e-9. If it fails, as at a fold, where the Jacobian is
    singular, the orbit is accepted if its gaps are below 1e-10.
    """
    guess: Iterate | None = remeshed(orbit, len(orbit.states), begin)
    options = dataclasses.replace(orbit.options, steps=7, last_step=1e-15)
    while guess:
        at_guess = phase(orbit, guess)
        try:
            found = closed_orbit(orbit.flow, guess, at_guess, reach=1e-9, options=options)
        except ConvergenceError:
            found = integrated(orbit.flow, guess)
            if found.largest_gap > 1e-10:
                raise
        guess = refined_mesh(found)
    return found


def _range(
    samples: PiecewisePolynomial, force: Callable[..., FloatArray], constants: Values
) -> tuple[float, float]:
    """Smallest and largest value of a force, at the samples and at extrema between them."""
    values = force(samples.states, constants)
    extrema_t = PiecewisePolynomial(samples.t, values[None]).turns(0)
    values = np.append(values, force(samples(extrema_t), constants))
    return float(values.min()), float(values.max())
