"""The cycle that is born at a Hopf point: from its normal form to a closed orbit of the motion."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ..bifurcation.normal_forms import NormalForm, normal_form
from ..bifurcation.onsets import Onsets
from ..errors import ConvergenceError, ParameterError, ParameterTypeError
from ..models.parameters import POSITIVE, as_number
from ..motion.flows import carrier
from ..motion.shooting import Guess, Loop, solved, split
from ..numerics.balls import Undecided
from ..numerics.interval_arrays import FloatArray
from .orbit import Cycle, cycle_of

if TYPE_CHECKING:
    from ..models.model import Model

#: Least half-width of the box that is taken around the Hopf point of the motion, over the larger of 1 and its numbers.
AROUND = 1e-13
#: Share of the amplitude at which a motion first comes to a border of the field; the amplitude where it has none.
SHARE, FREE = 0.1, 0.01
#: How closely an amplitude is met, relatively; by how many steps, and the longest of them, as a factor.
MET, ROUNDS, FARTHEST = 1e-3, 20, 2.0
#: What to do where none is met.
SMALLER = "give a smaller one, and go on from it with cycle_branch"


def born_at(onsets: Onsets, index: int, amplitude: float | None, backend: str | None) -> Cycle:
    """The cycle that is born at one of the onsets, see :func:`born`."""
    if not isinstance(index, int | np.integer) or isinstance(index, bool):
        raise ParameterTypeError(f"index = {index!r:.60} is no number of an onset; give an integer")
    if not 0 <= index < len(onsets):
        remedy = f"give a number from 0 to {len(onsets) - 1}" if len(onsets) else "search where there is one to begin from"
        raise ParameterError(f"index = {index}: there are {len(onsets)} onsets; {remedy}")
    row = int(index)
    form = onsets.normal_forms[row]
    if isinstance(form, str):
        raise ParameterError(f"index = {index}: no cycle is known to be born there, for {form}")
    return born(onsets.parameters.model, onsets.given(row), onsets.state(row), onsets.vary[0], form, amplitude, backend)


def born(
    model: Model, given: FloatArray, state: FloatArray, vary: str, form: NormalForm, amplitude: float | None = None,
    backend: str | None = None,
) -> Cycle:  # fmt: skip
    """The cycle of an amplitude in the family that is born at a Hopf point.

    Parameters
    ----------
    model : Model
    given, state, vary : ndarray, ndarray, str
        Parameters in the order of the page, coordinates, and the parameter of the onset, which is free: the cycle says its value.
    form : NormalForm
        Of the onset.
    amplitude : float, optional
        Half of the range of the coordinate that moves most at the onset, to a thousandth, in the units of the page. Without it a
        tenth of that at which the motion would leave the contact or come up with the belt.
    backend : {"heyoka", "scipy"}, optional
        As for :func:`spragsym.cycle`.

    Notes
    -----
    The motion takes friction at its sliding speed. Where statics takes its limit at fast sliding (``at_rest`` on the page), the
    Hopf point of the motion is sought beside the one that is proved. From there the normal form u = u* + 2 Re(z q) + …, with
    |z|² = −(d Re λ/dp) (p − p*)/(ω l₁), is corrected by Newton's method on the closed orbit, its period and the parameter.

    Raises
    ------
    ConvergenceError
        Where Newton's method finds no such cycle.
    """
    place = model.parameters.index(vary)
    if amplitude is not None:
        amplitude = as_number("amplitude", amplitude, POSITIVE)
    given, state, radius = _of_the_motion(model, given, state, place, form)
    try:
        form = normal_form(model, given, state, vary, np.full(state.size + 1, radius), law="friction_at_speed")
    except Undecided as reason:
        raise ConvergenceError(f"the motion has no generic Hopf point beside the onset: {reason}") from reason
    most = int(np.abs(form.q[: len(state)]).argmax())
    size = float(np.abs(form.q[most]))
    if amplitude is None:
        z = min(_default(model, given, state, form), _within(model, given, place, form))
    else:
        z = amplitude / 2 / size
    for _ in range(ROUNDS):
        try:
            found = _along(model, given, state, place, form, z, backend)
        except ConvergenceError as error:
            asked = 2 * z * size if amplitude is None else amplitude
            more = _beyond(model, given, state, form, asked, size)
            raise ConvergenceError(f"no cycle of the amplitude {asked:.3g} was found: {error}; {SMALLER}{more}") from error
        reached = float(np.ptp(found.samples.states[most])) / 2
        if amplitude is None or abs(reached / amplitude - 1) < MET:
            return found
        z *= min(max(amplitude / reached, 1 / FARTHEST), FARTHEST)
    more = _beyond(model, given, state, form, float(amplitude or 0.0), size)
    raise ConvergenceError(f"no cycle of the amplitude {amplitude:g} was found: the last one has {reached:.6g}; {SMALLER}{more}")


def _along(
    model: Model, given: FloatArray, state: FloatArray, place: int, form: NormalForm, z: float, backend: str | None
) -> Cycle:  # fmt: skip
    """The cycle whose largest state has the part 2 |z| along q, as the normal form has it to first order."""
    field, n = model.field, len(state)
    known = abs(form.lyapunov) > form.lyapunov_error
    aside = -form.omega * form.lyapunov * z**2 / form.crossing if known else 0.0
    rest = np.append(state, np.zeros(n))
    first = rest + form.along * aside + 2 * z * form.q.real + z**2 * (form.square.real + form.mean)
    start = given.copy()
    start[place] += aside
    fly, name = carrier(field, backend)
    rows = np.zeros((2, 2 * n + 2))
    rows[:, : 2 * n] = form.p.conjugate().real, form.p.conjugate().imag

    def conditions(loop: Loop) -> tuple[FloatArray, FloatArray]:
        seen = form.p.conjugate() @ (loop.guess.states[0] - rest)
        wide = np.zeros((2, loop.guess.states.size + 2))
        wide[:, : 2 * n] = rows[:, : 2 * n]
        return np.array([seen.real - wanted, seen.imag]), wide

    guess = Guess(first[None], 2 * math.pi / form.omega, tuple(start.tolist()))
    # What is asked of the first state: its part along q, as the normal form has it.
    wanted = float((form.p.conjugate() @ (first - rest)).real)
    guess = split(field, fly, guess, (place,)).guess
    return cycle_of(solved(field, fly, guess, conditions, (place,), reach=4 * z), fly, name)


def _of_the_motion(
    model: Model, given: FloatArray, state: FloatArray, place: int, form: NormalForm
) -> tuple[FloatArray, FloatArray, float]:  # fmt: skip
    """Parameters and coordinates at the Hopf point of the motion itself, and how well they are known, by Newton's method."""
    field, n = model.field, len(state)

    def residual(unknowns: FloatArray) -> FloatArray:
        values = given.copy()
        values[place] = unknowns[n]
        constants = field.constants(values.tolist())
        u = [*unknowns[:n].tolist(), *[0.0] * n]
        mode = field.exact(field.mode_at_rest(u, constants))
        accelerations = field.acceleration(u, constants, mode, math)
        roots = np.linalg.eigvals(field.matrix(u, constants, mode))
        near = roots[np.abs(roots - 1j * form.omega).argmin()]
        return np.array([*accelerations, near.real / form.crossing])

    x, before = np.append(state, given[place]), np.inf
    for _ in range(20):
        now = residual(x)
        steps = 1e-6 * np.maximum(1.0, np.abs(x))
        slopes = np.column_stack([
            (residual(x + step) - residual(x - step)) / (2 * step[k]) for k, step in enumerate(np.diag(steps))
        ])  # fmt: skip
        try:
            change = np.linalg.solve(slopes, -now)
        except np.linalg.LinAlgError:
            break
        x, width, scale = x + change, float(np.abs(change).max()), 1 + float(np.abs(x).max())
        if width <= AROUND * scale or (width <= 1e-7 * scale and width > 0.2 * before):
            there = given.copy()
            there[place] = x[n]
            return there, x[:n], 4 * max(width, AROUND * scale)
        before = width
    raise ConvergenceError("the motion's own Hopf point was not found beside the onset")


def _default(model: Model, given: FloatArray, state: FloatArray, form: NormalForm) -> float:
    """|z| of a share of the amplitude at which gap or sliding speed would come to 0."""
    name, reach = _first_border(model, given, state, form)
    return min(SHARE * reach, 1.0) if name else FREE


def _beyond(model: Model, given: FloatArray, state: FloatArray, form: NormalForm, asked: float, size: float) -> str:
    """Error: an amplitude takes the motion past a border of the field; nothing where it does not."""
    name, reach = _first_border(model, given, state, form)
    least = 2 * reach * size
    return f"; to first order only amplitudes below {least:.3g} do not come to {name}" if asked > least else ""


def _first_border(model: Model, given: FloatArray, state: FloatArray, form: NormalForm) -> tuple[str, float]:
    """The border that gap or sliding speed would come to first, and the |z| at which they do, to first order; none, infinity."""
    field = model.field
    constants, rest, step = field.constants(given.tolist()), [*state.tolist(), *[0.0] * len(state)], 1e-6
    borders = [border for border in field.borders if any(border.crossings)]
    if not borders:
        return "", math.inf

    def levels(u: Any) -> FloatArray:
        mode = field.mode_at_rest(rest, constants)
        return np.array([border.level(list(u), constants, mode) for border in borders])

    by_state = np.column_stack([(levels(rest + e) - levels(rest - e)) / (2 * step) for e in step * np.eye(len(rest))])
    with np.errstate(divide="ignore"):
        reach = np.abs(levels(rest)) / (2 * np.abs(by_state @ form.q))
    return borders[int(reach.argmin())].name, float(reach.min())


def _within(model: Model, given: FloatArray, place: int, form: NormalForm) -> float:
    """|z| up to which the parameter stays within a share of its range, to first order."""
    entry, value = model.about["parameters"][place], given[place]
    ahead = -form.omega * form.lyapunov / form.crossing
    end = entry["high"] if ahead > 0 else entry["low"]
    return np.inf if end is None or not ahead else math.sqrt(SHARE * abs(end - value) / abs(ahead))
