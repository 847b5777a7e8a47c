"""The cycle that is born at a Hopf point: from its normal form to a closed orbit of the motion."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..bifurcation.normal_forms import NormalForm, normal_form
from ..bifurcation.onsets import Onsets
from ..errors import ConvergenceError, ParameterError, ParameterTypeError
from ..models.parameters import POSITIVE, as_number
from ..motion.flows import Flow
from ..motion.shooting import Guess, Loop, solved, split
from ..numerics.balls import Undecided
from ..numerics.interval_arrays import FloatArray
from .orbit import Cycle, cycle_of
from .system import differences

if TYPE_CHECKING:
    from ..models.model import Model

#: Least half-width of the box that is taken around the Hopf point of the motion, over the larger of 1 and its numbers.
AROUND = 1e-13
#: Share of the amplitude at which a motion first comes to a border of the field; the amplitude where it has none.
SHARE, FREE = 0.1, 0.01
#: How closely an amplitude is met, relatively; by how many steps, and the longest of them, as a factor.
MET, ROUNDS, FARTHEST = 1e-3, 20, 2.0


def born_at(onsets: Onsets, index: int, amplitude: float | None, backend: str | None) -> Cycle:
    """The cycle of an amplitude in the family that is born at one of the onsets, along their first parameter.

    The motion takes friction at its sliding speed. Where statics takes its limit at fast sliding (``at_rest`` on the page), the
    Hopf point of the motion is sought beside the one that is proved. From there the normal form u = u* + 2 Re(z q) + …, with
    |z|² = −(d Re λ/dp) (p − p*)/(ω l₁), is corrected by Newton's method on the closed orbit, its period and the parameter.
    Without an amplitude it is a tenth of that at which the motion would come to a border of the field.
    """
    if not isinstance(index, int | np.integer) or isinstance(index, bool):
        raise ParameterTypeError(f"index = {index!r:.60} is no number of an onset; give an integer")
    if not 0 <= index < len(onsets):
        remedy = f"give a number from 0 to {len(onsets) - 1}" if len(onsets) else "search where there is one to begin from"
        raise ParameterError(f"index = {index}: there are {len(onsets)} onsets; {remedy}")
    row, model, vary = int(index), onsets.parameters.model, onsets.vary[0]
    form = onsets.normal_forms[row]
    if isinstance(form, str):
        raise ParameterError(f"index = {index}: no cycle is known to be born there, for {form}")
    place = model.parameters.index(vary)
    if amplitude is not None:
        amplitude = as_number("amplitude", amplitude, POSITIVE)
    given, state, radius = _of_the_motion(model, onsets.given(row), onsets.state(row), place, form)
    flow = Flow.of(model.field, backend)
    try:
        form = normal_form(model, given, state, vary, np.full(state.size + 1, radius), law="friction_at_speed")
    except Undecided as reason:
        raise ConvergenceError(f"the motion has no generic Hopf point beside the onset: {reason}") from reason
    most = int(np.abs(form.q[: len(state)]).argmax())
    size = float(np.abs(form.q[most]))
    border, reach = _first_border(model, given, state, form)
    if amplitude is None:
        z = min(SHARE * reach, 1.0) if border else FREE
        z = min(z, _within(model, given, place, form))
    else:
        z = amplitude / 2 / size

    def smaller(asked: float) -> str:
        least = 2 * reach * size
        beyond = f"; to first order only amplitudes below {least:.3g} do not come to {border}" if asked > least else ""
        return f"give a smaller one, and go on from it with cycle_branch{beyond}"

    for _ in range(ROUNDS):
        try:
            found = _along(flow, given, state, place, form, z)
        except ConvergenceError as error:
            asked = 2 * z * size if amplitude is None else amplitude
            raise ConvergenceError(f"no cycle of the amplitude {asked:.3g} was found: {error}; {smaller(asked)}") from error
        reached = float(np.ptp(found.samples.states[most])) / 2
        if amplitude is None or abs(reached / amplitude - 1) < MET:
            return found
        z *= min(max(amplitude / reached, 1 / FARTHEST), FARTHEST)
    told = f"the last one has {reached:.6g}; {smaller(float(amplitude or 0.0))}"
    raise ConvergenceError(f"no cycle of the amplitude {amplitude:g} was found: {told}")


def _along(flow: Flow, given: FloatArray, state: FloatArray, place: int, form: NormalForm, z: float) -> Cycle:
    """The cycle whose largest state has the part 2 |z| along q, as the normal form has it to first order."""
    n = len(state)
    known = abs(form.lyapunov) > form.lyapunov_error
    aside = -form.omega * form.lyapunov * z**2 / form.crossing if known else 0.0
    rest = np.append(state, np.zeros(n))
    first = rest + form.along * aside + 2 * z * form.q.real + z**2 * (form.square.real + form.mean)
    start = given.copy()
    start[place] += aside

    def conditions(loop: Loop) -> tuple[FloatArray, FloatArray]:
        seen = form.p.conjugate() @ (loop.states[0] - rest)
        wide = np.zeros((2, loop.states.size + 2))
        wide[:, : 2 * n] = form.p.conjugate().real, form.p.conjugate().imag
        return np.array([seen.real - wanted, seen.imag]), wide

    guess = Guess(first[None], 2 * math.pi / form.omega, tuple(start.tolist()))
    # What is asked of the first state: its part along q, as the normal form has it.
    wanted = float((form.p.conjugate() @ (first - rest)).real)
    guess = split(flow, guess, (place,)).guess
    return cycle_of(solved(flow, guess, conditions, (place,), reach=4 * z))


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

    from scipy.optimize import root

    found = root(residual, np.append(state, given[place]), tol=1e-15)
    scale = 1 + float(np.abs(found.x).max())
    slopes = differences(residual, found.x, 1e-6 * scale)
    width = float(np.abs(np.linalg.lstsq(slopes, found.fun)[0]).max())
    if not width <= 1e-7 * scale:
        raise ConvergenceError("the motion's own Hopf point was not found beside the onset")
    there = given.copy()
    there[place] = found.x[n]
    return there, found.x[:n], 4 * max(width, AROUND * scale)


def _first_border(model: Model, given: FloatArray, state: FloatArray, form: NormalForm) -> tuple[str, float]:
    """The border that gap or sliding speed would come to first, and the |z| at which they do, to first order; none, infinity."""
    field = model.field
    constants, rest = field.constants(given.tolist()), np.append(state, np.zeros(len(state)))
    borders = [border for border in field.borders if any(border.crossings)]
    if not borders:
        return "", math.inf

    mode = field.mode_at_rest(rest.tolist(), constants)

    def levels(u: FloatArray) -> FloatArray:
        return np.array([border.level(u.tolist(), constants, mode) for border in borders])

    with np.errstate(divide="ignore"):
        reach = np.abs(levels(rest)) / (2 * np.abs(differences(levels, rest, 1e-6) @ form.q))
    return borders[int(reach.argmin())].name, float(reach.min())


def _within(model: Model, given: FloatArray, place: int, form: NormalForm) -> float:
    """|z| up to which the parameter stays within a share of its range, to first order."""
    entry, value = model.about["parameters"][place], given[place]
    ahead = -form.omega * form.lyapunov / form.crossing
    end = entry["high"] if ahead > 0 else entry["low"]
    return np.inf if end is None or not ahead else math.sqrt(SHARE * abs(end - value) / abs(ahead))
