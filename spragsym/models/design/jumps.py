"""Jump values of any model: where the followed state ends as a parameter moves, and their gradients; many points at once."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...design.gradients import JumpGradient
from ...design.values import FROM_LOWER_END, told
from ...errors import ConvergenceError, ParameterError
from ...exact.interval_arrays import FloatArray
from ...parameters import Range, as_numbers
from ..catastrophe.paths import first_end
from ..catastrophe.points import FAR
from ..mechanics.balance import Balance
from ..statics.equilibria import equilibria
from ..statics.reference_state import reference_state
from ..statics.stability import filled
from ..tubes.tube_regions import Parts, Place
from ..tubes.tubes import Tubes
from ..tubes.turning_points import SEGMENTS, past, turned

#: Points at a time.
BLOCK = 4096
#: The least step of a tube, over the whole way.
THIN = 2.0**-14
#: How often a state that is steep and does not turn back is carried past there, and how far, over the whole way.
ROUNDS, PAST = 4, 2.0**-8
#: Segments towards a fold where an answer in haste is asked for: beside a cusp more are needed.
HASTY = 60


@dataclass(frozen=True)
class Ends:
    """Where the states of many points end: the value, NaN where they don't, a bound on its error, and the coordinates at a fold.

    ``value`` and ``error`` have the shape of the points, ``state`` has (n, …); ``reasons`` says of which points, by their
    position in ``value.flat``, nothing is known, and why.
    """

    value: FloatArray
    error: FloatArray
    state: FloatArray
    reasons: Mapping[int, str]


def jump_value(
    model: Any, p: Any, vary: str, *, direction: str = "up", begin: float | None = None, until: float | None = None
) -> float | FloatArray:
    """Where the followed state ends first as one parameter moves.

    Parameters
    ----------
    p : Parameters
        Of the model, of any shape.
    vary : str
        What moves: ``mu0`` and ``theta0`` from the lower end of their range, and are not used; others from the value in ``p``.
    direction : {"up", "down"}
        Which way; ``mu0`` and ``theta0`` rise.
    begin, until : float, optional
        From where to where instead. Without ``until`` to the end of the range; where that has no end up to 10 times the base
        value, 10 at least.

    Returns
    -------
    float or ndarray
        NaN where the state is proved to go on, up to a fold that lies within its error of ``until``, if there is one.

    Raises
    ------
    ParameterError
        For a parameter that the model does not have, a direction or an end that it can't take.
    ConvergenceError
        For a single point of which this is not decided; in an array such a point is NaN, with an
        :class:`~spragsym.errors.UndecidedWarning`.

    Notes
    -----
    Source: tubes around curves of states up to the fold, and through it, see :mod:`spragsym.models.tubes.turning_points`, from
    the reference state at the first value, see :mod:`spragsym.models.statics.reference_state`. What tubes don't decide is
    followed between all folds that are found by search, see :func:`spragsym.models.catastrophe.paths.first_end`; an end there
    may also be where the state leaves the contact.
    """
    found = told(Followed(model, p, vary, direction, begin, until).ends()).value
    return found if found.ndim else float(found)


def jump_gradient(
    model: Any, p: Any, vary: str, *, direction: str = "up", begin: float | None = None, until: float | None = None
) -> JumpGradient:
    """Derivatives of :func:`jump_value` by all parameters.

    Notes
    -----
    Source: F = 0, w K = 0 at the fold, differentiated: since w ∂F/∂q = 0, dv/dp = −(w · ∂F/∂p)/(w · ∂F/∂v). NaN where the state
    goes on or leaves the contact.
    """
    asked = Followed(model, p, vary, direction, begin, until)
    found = told(asked.ends())
    return JumpGradient(vary, found.value, asked.slopes(found))


def have_jumped(model: Any, p: Any, vary: str, begin: float | FloatArray, *, hasty: bool = False) -> FloatArray:
    """1 where the state has ended as ``vary`` rises to its value in ``p``, 0 where not, NaN where tubes don't decide it.

    It rises from ``begin``, one value for all points or one for each. A ``hasty`` answer is NaN beside cusps too, which take
    longest.

    Returns
    -------
    ndarray
        Of the shape of the points.
    """
    names = [name for name in model.parameters if getattr(p, name) is not None]
    p = p.replace(**dict(zip(names, p.broadcast(*names), strict=True)))  # each of the shape of all, without mu0 too
    return Followed(model, p, vary, "up", begin, np.maximum(begin, getattr(p, vary))).have_ended(hasty=hasty)


class Followed:
    """States of many points, followed as one parameter moves, up or down, from where to where: see :func:`jump_value`."""

    def __init__(
        self, model: Any, p: Any, vary: str, direction: str, begin: float | FloatArray | None, until: float | FloatArray | None
    ) -> None:
        if direction not in ("up", "down"):
            raise ParameterError(f"direction = {direction!r}; give 'up' or 'down'")
        self.model, self.vary, self.forward = model, vary, 1 if direction == "up" else -1
        allowed = model.Parameters.ranges[vary]
        if begin is None and vary in FROM_LOWER_END:
            if self.forward < 0:
                raise ParameterError(f"direction = 'down': {vary} rises from its lower end; give begin, or direction = 'up'")
            begin = allowed.reached(allowed.low)
        if begin is not None:
            p = p.replace(**{vary: as_numbers("begin", begin, allowed)})
        # Where the parameter that moves is the only one of several values, its ends alone say of how many points it is.
        self.shape = np.broadcast_shapes(p.shape, () if until is None else np.shape(until))
        self.balance = Balance(model, contact=True)
        columns = p.broadcast(*self.balance.parameters)
        self.fixed = np.stack([np.broadcast_to(column, self.shape).reshape(-1) for column in columns])
        self.begin = self.fixed[self.balance.parameters.index(vary)]
        self.until = self._until(allowed, until)
        self.tubes = Tubes(self.balance, vary)

    def _until(self, allowed: Range, until: float | FloatArray | None) -> FloatArray:
        if until is None:
            far = FAR * max(1.0, abs(self.model.base.get(self.vary) or 0.0))
            end = allowed.high if self.forward > 0 else allowed.low
            until = (
                allowed.reached(end) if np.isfinite(end) else self.forward * max(far, float(np.abs(self.begin).max(initial=0.0)))
            )
        ends = np.broadcast_to(as_numbers("until", until, allowed), self.shape).reshape(-1)
        if ((ends - self.begin) * self.forward < 0).any():
            way = "below" if self.forward > 0 else "above"
            raise ParameterError(
                f"until = {ends.min():g} is {way} where {self.vary} begins; give one beyond it, or another direction"
            )
        return ends

    def have_ended(self, *, hasty: bool = False) -> FloatArray:
        """1 where the state of a point has ended, 0 where it has not, NaN where tubes don't decide it, in haste beside cusps too.

        Tubes over a coordinate pass a fold without coming near to it. Where they decide nothing, the fold itself is asked for.
        """
        found, out = np.full(self.begin.size, np.nan), self._nothing()
        for rows in self._blocks():
            parts, start, goal = self._start(rows)
            safe, top, _ = self.tubes.passed(parts, start, goal)
            ended = np.where(start.sure & (safe >= goal), 0.0, np.where(start.sure & (top <= goal), 1.0, np.nan))
            left = np.flatnonzero(np.isnan(ended))
            left = left[self._block(rows[left], (parts[left], start[left], goal[left]), out, hasty=hasty)]
            ended[left] = np.isfinite(out.value[rows[left]])
            found[rows] = ended
        return found.reshape(self.shape)

    def _blocks(self) -> Iterator[Any]:
        count = self.begin.size
        return (np.arange(first, min(first + BLOCK, count)) for first in range(0, count, BLOCK))

    def _nothing(self) -> Ends:
        count = self.begin.size
        return Ends(np.full(count, np.nan), np.zeros(count), np.full((self.balance.n, count), np.nan), {})

    def ends(self) -> Ends:
        """Where the state of each point ends."""
        n, out, reasons = self.balance.n, self._nothing(), dict[int, str]()
        for rows in self._blocks():
            for i in rows[~self._block(rows, self._start(rows), out)].tolist():
                span = float(self.begin[i]), float(self.until[i])
                try:
                    end = first_end(self.model, self._point(i), self.vary, span) if span[0] != span[1] else None
                except ConvergenceError as error:
                    reasons[i] = str(error)
                    continue
                if end is not None:
                    out.value[i], out.error[i] = end.value, end.error
                    if end.kind == "fold":
                        out.state[:, i] = [end.before[name] for name in self.balance.coordinates]
        return Ends(out.value.reshape(self.shape), out.error.reshape(self.shape), out.state.reshape(n, *self.shape), reasons)

    def _point(self, i: int) -> Any:
        return self.model.Parameters(**dict(zip(self.balance.parameters, self.fixed[:, i].tolist(), strict=True)))

    def _start(self, rows: Any) -> tuple[Parts, Place, FloatArray]:
        """Some points, the reference states from which they are followed, where these are known, and up to where."""
        n, begin = self.balance.n, self.begin[rows]
        p = self.model.Parameters(**dict(zip(self.balance.parameters, self.fixed[:, rows], strict=True)))
        eq = equilibria(p)
        slot = reference_state(self.model, eq)
        z = np.array([*(getattr(eq, name)[np.arange(rows.size), slot] for name in self.balance.coordinates), begin])
        known = eq.decided & np.isfinite(z).all(axis=0)
        z[:, ~known] = 0.0
        none = np.zeros((0, rows.size))
        parts = Parts(self.fixed[:, rows], none, none)
        start = self.tubes.place(parts, z, n)
        start.sure[~known] = False
        return parts, start, self.until[rows]

    def _block(self, rows: Any, started: tuple[Parts, Place, FloatArray], out: Ends, *, hasty: bool = False) -> Any:
        """Fold or no fold by tubes, for some points; of which of them that is decided."""
        n, tubes, begin = self.balance.n, self.tubes, self.begin[rows]
        parts, start, goal = started
        rounds, segments = (1, HASTY) if hasty else (ROUNDS, SEGMENTS)
        left = np.arange(rows.size)
        decided, at = np.zeros(rows.size, dtype=np.bool_), start
        for _ in range(rounds):
            at = tubes.followed(parts[left], at, goal[left], THIN)
            arrived = at.sure & (at.z[n] == goal[left])
            decided[left[arrived]] = True
            left, at = left[at.sure & ~arrived], at[at.sure & ~arrived]
            if not left.size:
                break
            fold = turned(tubes, parts[left], at, self.forward, segments)
            found = fold.sure & (fold.high <= goal[left] if self.forward > 0 else fold.low >= goal[left])
            to = rows[left[found]]
            out.value[to], out.state[:, to] = fold.z[n, found], fold.z[:n, found]
            out.error[to] = np.maximum(fold.high - fold.z[n], fold.z[n] - fold.low)[found]
            # What turns back beyond the goal has come to it.
            known = found | (fold.sure & (fold.low > goal[left] if self.forward > 0 else fold.high < goal[left]))
            decided[left[known]] = True
            left, at = left[~known], at[~known]
            at = past(tubes, parts[left], at, self.forward, PAST * np.abs(goal[left] - begin[left]))
        return decided

    def slopes(self, found: Ends) -> dict[str, FloatArray]:
        """dv/dp by name at the folds that were found."""
        names = list(self.balance.parameters)
        value, state = found.value.reshape(-1), found.state.reshape(self.balance.n, -1)
        out = {name: np.full(value.shape, np.nan) for name in names}
        rows = np.flatnonzero(np.isfinite(state).all(axis=0))
        columns = self.fixed[:, rows]
        columns[names.index(self.vary)] = value[rows]
        values, q = self.balance.floats(columns), list(state[:, rows])
        directions = self.balance.plain_directions(q, values, np)
        K, moved = (
            np.moveaxis(filled(matrix, rows.shape), -1, 0)
            for matrix in (
                self.balance.by_coordinate("forces_jacobian", q, directions, values, np),
                self.balance.by_parameters(names, q, directions, values, np),
            )
        )
        if rows.size:
            w = np.linalg.svd(K)[0][:, :, -1]
            along = np.einsum("Ni,Nij->jN", w, moved)
            with np.errstate(all="ignore"):
                for name, one in zip(names, along, strict=True):
                    out[name][rows] = 0.0 if name == self.vary else -one / along[names.index(self.vary)]
        return {name: one.reshape(self.shape) for name, one in out.items()}
