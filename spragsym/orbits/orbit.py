"""A cycle: a closed orbit with its multipliers, its events, and what is measured over one
period.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..core.errors import ConvergenceError, ParameterError, ParameterTypeError
from ..display import Column
from ..files import storage
from ..models.field import Field, Values
from ..models.model import Model
from ..models.parameters import FloatArray
from ..motion.lobatto import PiecewisePolynomial
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
from ..numerics.vectors import apart, magnitude
from ..results.result import Result

if TYPE_CHECKING:
    from xarray import Dataset


@dataclass(frozen=True, eq=False)
class Cycle(Result):
    """A cycle: a motion that repeats itself.

    ``spring_force`` and ``contact_force`` are ranges over one period, computed when they are asked
    for.

    Attributes
    ----------
    period : float
        The least one.
    state : ndarray, shape (m,)
        Where the first coordinate that moves is largest; for the article's model x, y, x' = 0, y'.
        Anywhere if it only turns around, or where dry friction turns around just then, as on a belt
        that stands still.
    multipliers : ndarray of complex, shape (m,)
        Eigenvalues of the monodromy matrix: the trivial one first, which is 1 but for rounding;
        then by size. Of a page with a clock those of the stroboscopic map follow the trivial one,
        m − 2 of them.
    multiplier_errors : ndarray, shape (m − 1,)
        Estimated errors of all but the trivial one: how far they move if the derivatives err as
        much as they do along the flow.
    stable : bool
        Whether all others are inside of the unit circle, by more than their errors.
    error : float
        Estimated error of state and period: the orbit's sensitivity times what does not close, or
        by what the flow without derivatives ends elsewhere; no less than what the trivial
        multiplier lacks to 1.
    residual : float
        By how much the orbit does not close.
    events : Events
        Where it passes a kink: ``t`` from ``state`` on.
    rms, mean, amplitude : float
        Of the first coordinate over one period: root mean square about zero, mean, half of its
        range. Where it turns around the first two are NaN, and the last one is π.
    backend : str
        The integrator.
    orbit : Orbit
        The orbit as it was solved for, with its derivatives.
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
        """The model."""
        return self.orbit.field

    @property
    def _of_model(self) -> Model | None:
        return self.field.model

    def require(self, field: Field, name: str) -> None:
        """Raise unless this is a cycle of that field: another's would be taken for what it is
        not.

        Parameters
        ----------
        field : Field
            That of the model with its parameters' names.
        name : str
            What the cycle is called in the error.

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

    @cached_property
    def samples(self) -> PiecewisePolynomial:
        """One period by the polynomials through its samples."""
        return self.orbit.samples()

    @cached_property
    def phases(self) -> Phases:
        """The modes that one period passes through."""
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
        """Least and largest tension of the inclined spring, over k_c L_0."""
        return self._force("spring_force")

    @property
    def contact_force(self) -> tuple[float, float]:
        """Least and largest force of the contact, over k_c L_0."""
        return self._force("contact_force")

    @cached_property
    def forces(self) -> dict[str, tuple[float, float]]:
        """Least and largest of every force of the model: of its contact, and of its springs,
        ``spring_force_1``, … of several.
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
        """The motion over one period, or more of them, as :func:`~spragsym.simulate` gives it.

        Parameters
        ----------
        periods : float
            How many of them.
        **options
            Those of :func:`spragsym.simulate`.

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
        return motion_of(self.field, self.values, self.state, periods * self.period, **chosen)

    def to_dataset(self) -> Dataset:
        """An ``xarray.Dataset``: the samples of one period, with everything else as attributes
        (extra ``sweep``).

        Returns
        -------
        xarray.Dataset

        Examples
        --------
        >>> import spragsym as ss
        >>> cycle = ss.cycle(ss.load("stick_slip").Parameters(V=0.2))
        >>> cycle.to_dataset().sizes["t"] > 10
        True
        """
        dataset = self.trajectory().to_dataset()
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
            path, self.to_dataset, motion.data(), motion._attributes(), motion._in_model_units
        )

    def __repr__(self) -> str:
        return (
            f"Cycle(period={self.period:.10g}, state={np.round(self.state, 8).tolist()}, "
            f"stable={self.stable}, "
            f"largest multiplier={magnitude(self.multipliers[1:]):.6g})"
        )


def cycle_of(orbit: Orbit) -> Cycle:
    """The cycle that a closed orbit is, begun anew where the first coordinate that moves is
    largest.
    """
    orbit = least_period(in_scales(orbit).bound().with_lead())
    orbit = refined(orbit, orbit.top.t if orbit.top else 0.0)
    aside = off_jumps(orbit)
    if aside is not orbit:
        orbit = refined(aside, offset_from_jumps(aside))
    found = orbit.multipliers
    lost = abs(found.trivial - 1)
    if not lost < orbit.options.trivial:
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
        multiplier_errors=found.errors,
        stable=is_stable(orbit),
        error=max(unit * error_of(orbit, difference(orbit)), lost),
        residual=size * orbit.largest_gap,
        events=events_of(own.field, own.crossings()),
        rms=rms,
        mean=mean,
        amplitude=(highest - lowest) / 2,
        backend=own.flow.backend,
        orbit=own,
    )


def same_cycle(one: Cycle, other: Cycle) -> bool:
    """Whether two cycles at the same values of the parameters are one."""
    units = units_of(one)
    size = max(extent(one.orbit, units), extent(other.orbit, units))
    averages = np.abs([one.rms - other.rms, one.mean - other.mean]) / units[0]
    # Periods, and averages as shares of the extent, that differ by less may be of one cycle.
    alike = 1e-6
    if abs(one.period / other.period - 1) >= alike or averages.max() >= alike * size:
        return False
    # They are if the state of one lies as near the other's samples, as a share of the
    # extent.
    return distance(one, other.state) < 0.05 * size


def units_of(cycle: Cycle) -> FloatArray:
    """Units of the motion on a cycle, (m,)."""
    return scales_of(cycle.field, cycle.orbit.constants, cycle.orbit.state.tolist()).states


def distance(cycle: Cycle, state: FloatArray) -> float:
    """Distance of a state to the nearest sample of a cycle, but for whole turns, in units of the
    motion.
    """
    off = apart(cycle.samples.states.T, state, cycle.field.periodic) / units_of(cycle)
    return float(np.abs(off).max(axis=1).min())


@dataclass(frozen=True, eq=False)
class Phases(Result):
    """The modes of one period, in order of time.

    Attributes
    ----------
    t, duration : ndarray, shape (k,)
        When each begins, from the state of the cycle on, and how long it lasts.
    contact : ndarray of int, shape (k,)
        1 in contact, 0 in lift-off; of a contact that presses on either of two faces 1 where N is
        not negative, 0 on the opposite one.
    side : ndarray of int, shape (k,)
        1 where the belt is ahead, −1 where the mass is, 0 where it sticks.
        Of several contacts both have a column for each.
    contacts, rubbing : tuple of str
        Names of the contacts, and of those with friction, where there are several.
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
        """The columns of its table: of several contacts one for each."""
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
    """The cycles that closed orbits are, each made when it is asked for first."""

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
    """Whether all multipliers but the trivial one are inside of the unit circle, by more than their
    errors.
    """
    found = orbit.multipliers
    return bool((np.abs(found.others) + found.errors < 1 - orbit.options.neutral).all())


def range_of(orbit: Orbit) -> tuple[float, float]:
    """Least and largest first coordinate, ∓π where it turns around; an extremum between mesh
    intervals is in a state only.
    """
    if orbit.winding:
        return -math.pi, math.pi
    # The first coordinate stands still where another one leads.
    values = [
        *(float(extremum.state[0]) for extremum in orbit.extrema() if extremum.border == -1),
        *orbit.states[:, 0].tolist(),
    ]
    return min(values), max(values)


def refined(orbit: Orbit, begin: float) -> Orbit:
    """The orbit from a time on, in as many mesh intervals as its growth asks for."""
    cut: Iterate | None = remeshed(orbit, len(orbit.states), begin)
    shortest = dataclasses.replace(orbit.options, steps=7, last_step=1e-15)
    while cut:
        try:
            # A closed orbit that is begun elsewhere moves by less: where Newton's
            # method goes farther, as at a fold, its shortest steps do.
            found = closed_orbit(orbit.flow, cut, phase(orbit, cut), reach=1e-9, options=shortest)
        except ConvergenceError:  # as at a fold, where Newton's matrix is singular
            found = integrated(orbit.flow, cut)
            # An orbit on which Newton's method fails as it is begun anew is told as
            # it is if it is no more open than this.
            if found.largest_gap > 1e-10:
                raise
        cut = refined_mesh(found)
    return found


def _range(
    samples: PiecewisePolynomial, force: Callable[..., FloatArray], constants: Values
) -> tuple[float, float]:
    """Least and largest value, at a sample or where the values turn between two."""
    values = force(samples.states, constants)
    turns = PiecewisePolynomial(samples.t, values[None]).turns(0)
    values = np.append(values, force(samples(turns), constants))
    return float(values.min()), float(values.max())
