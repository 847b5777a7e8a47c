"""Certificates that the followed state does not jump, over boxes of parameters of any model.

A part of the box is proved where a tube shows that the state of each of its points goes on to the
upper end of the parameter that moves, and refuted where the state is proved to end below.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from ..bifurcation.crossings import border_arrivals
from ..bifurcation.tubes import Place, Tubes, in_turn
from ..bifurcation.turning_points import passed, size_of
from ..core.error_states import in_usual_state
from ..core.errors import ParameterError, one_of
from ..core.questions import Method, model_of, question
from ..models.parameters import ParameterSet, Ranges, as_count, as_number, as_ranges
from ..models.quantities import Unit, checked_units
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray
from ..statics.balance import BalanceInUnits
from ..statics.equilibria import equilibria
from ..statics.reference_state import reference_place
from ..statics.search import balances_of, number_of
from .certificates import (
    STATES,
    BoxParts,
    Certificate,
    Claim,
    ClaimOfStates,
    Decision,
    corner_values,
)


@dataclass(frozen=True)
class Pieces(BoxParts):
    """Parts of a box, each with a proved place at which the followed state begins.

    The last side is the parameter that moves. ``base`` is proved for the free parameters between
    the ends ``of``, shape (2, free, N), which contain those of the part. For all points of a part
    the state is proved to exist up to ``safe`` and to have ended above ``top``; −inf and inf if
    nothing is known.
    """

    few = 256

    base: Place
    of: FloatArray
    safe: FloatArray
    top: FloatArray

    @property
    def outcome(self) -> IntArray:
        """Proved if the state exists up to the upper end of the moving parameter, refuted if it has
        ended below the lower end.
        """
        return np.select(
            [self.safe >= self.high[-1], self.top < self.low[-1]],
            [Decision.PROVED, Decision.REFUTED],
            Decision.OPEN,
        )

    def weight(self, place: Place) -> FloatArray:
        """Weight of each free side for halving: how far it moves the state of a place."""
        moves = (np.abs(place.by_p) / size_of(place.z)[:, None]).max(axis=0)
        moves = np.where(np.isfinite(moves), moves, 0.0)
        return self.slight[:-1] + moves * (self.high - self.low)[:-1]

    def divisible(self) -> BoolArray:
        """Mask of the free sides with floats between their ends."""
        return super().divisible()[:-1]


class Splitting(Claim):
    """A state followed over a box of parameters, from ``begin`` to the values of ``vary`` in the
    box.
    """

    batch, early = 1024, False
    #: Whether ``safe`` and ``top`` should be as close as possible; otherwise they only decide on
    #: which side of a part's ends the state ends.
    sharp = False
    whole: Pieces

    def __init__(
        self,
        low: ParameterSet,
        high: ParameterSet,
        vary: str,
        begin: float,
        units: Mapping[str, Unit] | None = None,
    ) -> None:
        model = low.model
        self.model, self.vary, self.begin, self.near = model, vary, begin, low.followed
        self.balance = BalanceInUnits(model, units or {})
        names = self.balance.parameters
        ends = corner_values(model.parameters, low, high, self.balance.units)
        least = ends[0][names.index(vary), 0]
        if begin > least:
            raise ParameterError(
                f"begin = {begin:g} is above low.{vary} = {least:g}; begin where {vary} is lower"
            )
        relevant = {*self.balance.balanced, *self.balance.scaling} - {vary}
        self.free = tuple(
            name
            for name, *end in zip(names, *ends, strict=True)
            if name in relevant and end[0] != end[1]
        )
        self.sides = (*self.free, vary)
        self.tubes = Tubes.of_points(self.balance, vary, ends[0], self.free)
        self.rows = self.tubes.moving
        one, other = (end[self.rows] for end in ends)
        middle = 0.5 * (one + other)[:-1]
        balances = balances_of(model)
        touching = self._reference(np.append(middle[:, 0], begin))[1]
        contact = balances[number_of(balances, touching)].contact
        # Tubes follow one combination of touching contacts, and end at a border.
        self.balance = BalanceInUnits(model, units or {}, contact=contact)
        self.tubes = replace(self.tubes, balance=self.balance)
        start = self._beginning(middle[:, 0])
        start = replace(start, by_p=self._over(one, other).tangents(start.z)[1])
        self.whole = Pieces(
            one, other, start, np.stack([middle, middle]), np.full(1, -np.inf), np.full(1, np.inf)
        )

    def _over(self, low: FloatArray, high: FloatArray) -> Tubes:
        """Tubes for parts of the box."""
        centre = 0.5 * (low[:-1] + high[:-1])
        half = np.maximum(high[:-1] - centre, centre - low[:-1])
        return replace(self.tubes[np.zeros(low.shape[1], dtype=int)], centre=centre, half=half)

    def _reference(self, at: FloatArray) -> tuple[FloatArray, str, float]:
        """The reference state at one point of the free and the moving parameters, its touching
        contacts, and a bound on its error.
        """
        where = f"in the middle of the box is known to be stable at {self.vary} = {self.begin:g}"
        return reference_place(self.point(at), self.near, where)

    def _beginning(self, free: FloatArray) -> Place:
        """The proved place of the reference state where the moving parameter begins, at one point
        of the free parameters.
        """
        at = np.append(free, self.begin)
        q, _, error = self._reference(at)
        z = np.append(q, self.begin)[:, None]
        return self._over(at[:, None], at[:, None]).place(z, error=error)

    def begins_alike(self, one: FloatArray, other: FloatArray) -> bool:
        """Whether the reference state at one point becomes that at another while the free
        parameters move.
        """
        before, after = self._beginning(one), self._beginning(other)
        return bool(self._linked(one[:, None], before, other[:, None], after)[0])

    def point(self, values: FloatArray) -> ParameterSet:
        """The parameters at points of the box, shape (free + 1, …)."""
        fixed = np.multiply.outer(self.tubes.fixed[:, 0], np.ones(values.shape[1:]))
        fixed[self.rows] = values
        found = self.balance.scaled(dict(zip(self.balance.parameters, fixed, strict=True)))
        return self.model.Parameters(**{name: found[name] for name in self.model.parameters})

    def points(self, values: FloatArray) -> Pieces:
        """Points of the box, shape (free + 1, N), as parts without width."""
        return replace(self.whole[np.zeros(values.shape[1], dtype=int)], low=values, high=values)

    # ---------------------------------------------------------------------------------------------
    # decisions

    def settled(self, pieces: Pieces) -> tuple[Pieces, FloatArray]:
        """The parts with what is proved of them and with their own beginnings, and weights of the
        free sides.
        """
        tubes, start = self._begun(pieces)
        goal = pieces.high[-1]
        # Halving a wide part is better than smaller steps.
        least = None if (pieces.low == pieces.high).all() else 2.0**-6
        reached = tubes.followed(start, goal, least)
        safe, top = np.where(reached.proved, reached.v, -np.inf), np.full(goal.size, np.inf)
        weight, width = pieces.weight(reached), (pieces.high - pieces.low)[:-1]
        rows = np.flatnonzero(reached.proved & (safe < goal) & (safe != start.v))
        if rows.size:
            safe[rows], top[rows], moves = passed(
                tubes[rows], reached[rows], goal[rows], self.sharp
            )
            weight[:, rows] = width[:, rows] * moves
        base = pieces.base[np.arange(len(pieces))]
        base.scatter(start.proved, start[start.proved])
        of = np.where(start.proved, np.stack([pieces.low[:-1], pieces.high[:-1]]), pieces.of)
        # What is proved for a part holds for its halves.
        safe, top = np.maximum(pieces.safe, safe), np.minimum(pieces.top, top)
        return replace(pieces, base=base, of=of, safe=safe, top=top), weight

    def _begun(self, pieces: Pieces) -> tuple[Tubes, Place]:
        """Tubes of the parts, and their places where the moving parameter begins, proved to be of
        the followed state; not proved where that fails.
        """
        tubes, middle = self._over(pieces.low, pieces.high), 0.5 * (pieces.of[0] + pieces.of[1])
        shift = np.einsum("ikN,kN->iN", pieces.base.by_p, tubes.centre - middle)
        place = tubes.place(pieces.base.z + shift)
        spread = (np.abs(place.by_p - pieces.base.by_p) * tubes.apart()).sum(axis=1)
        inside = ((pieces.of[0] <= pieces.low[:-1]) & (pieces.high[:-1] <= pieces.of[1])).all(
            axis=0
        )
        same = inside & place.lies_in(pieces.base, shift, spread)
        rows = np.flatnonzero(place.proved & pieces.base.proved & ~same)
        same[rows] = self._linked(
            middle[:, rows], pieces.base[rows], tubes.centre[:, rows], place[rows]
        )
        return tubes, replace(place, proved=same)

    def _linked(self, one: FloatArray, before: Place, other: FloatArray, after: Place) -> BoolArray:
        """Whether the states of a place become those of another, while one free parameter after the
        other moves from ``one`` to ``other``.
        """
        at = np.repeat(self.tubes.fixed, one.shape[1], axis=1)
        at[self.rows[:-1]], at[self.rows[-1]] = one, self.begin
        last, proved = in_turn(self.balance, zip(self.free, other, strict=True), at, before)
        return proved & last.lies_in(after)

    def fails(self, points: FloatArray) -> BoolArray:
        found = self.settled(self.points(points))[0]
        ends = found.outcome == Decision.REFUTED
        begun = found.base.proved & (found.of == points[:-1]).all(axis=(0, 1))
        rows = np.flatnonzero(begun & (found.outcome == Decision.OPEN))
        fixed = np.repeat(self.tubes.fixed, rows.size, axis=1)
        fixed[self.rows] = points[:, rows]
        # Where a tube ends at a contact's border, the state passes it or ends there.
        tubes, start = Tubes.of_points(self.balance, self.vary, fixed), found.base[rows]
        start, goal = replace(start, by_p=start.by_p[:, :0]), points[-1, rows]
        for part in border_arrivals(tubes, tubes.followed(start, goal), goal):
            over = (part.kind != "passes") & (part.z[-1] + part.error < goal[part.rows])
            ends[rows[part.rows]] = over
        open_ = np.flatnonzero(~ends & (found.outcome == Decision.OPEN))
        if open_.size:  # a state that runs to infinity ends at no fold or border
            eq = equilibria(self.point(points[:, open_]))
            ends[open_] = (eq.count == 0) & eq.decided & eq.whole
        return ends


@question
def claims(
    corners: tuple[ParameterSet, ParameterSet],
    claim: str,
    *,
    vary: str | None,
    begin: float | None,
    units: Mapping[str, Unit] | None = None,
    method: Method = "auto",
) -> Claim:
    """The claim of :func:`certify` about the box between two corners."""
    low, high = corners
    model = low.model
    one_of("claim", claim, ("no jump", *STATES))
    if claim in STATES:
        if vary is not None:
            raise ParameterError(
                f"vary = {vary!r}: {claim!r} is about all states of the box, and nothing "
                "rises; leave vary out"
            )
        if units:
            raise ParameterError(
                f"units: a search takes them for 'no jump' only; for {claim!r} give corners "
                "that hold them"
            )
        return ClaimOfStates(low, high, claim)
    vary, begin = model.rising(vary, begin)
    begin = as_number("begin", begin)
    box = Splitting(
        low, high, vary, begin, checked_units(units, model.parameters, model.about["angles"])
    )
    # A state that exists at the upper end of vary exists at every value below.
    box.whole.low[-1] = box.whole.high[-1]
    return box


@in_usual_state
def certify(
    p: ParameterSet,
    claim: str = "no jump",
    *,
    between: Ranges | None = None,
    vary: str | None = None,
    begin: float | None = None,
    max_boxes: int | None = None,
    refute: bool = True,
    method: Method = "auto",
) -> Certificate:
    """Prove a claim for every point of a box of parameters, or find a point at which it is false.

    Parameters
    ----------
    p : Parameters
        Scalars, of any model.
    claim : {"no jump", "one equilibrium", "no flutter", "stable"}
        ``"no jump"``: take the reference state in the middle of the box where ``vary`` begins, and
        the states that it becomes over the box. Each goes on as ``vary`` rises from ``begin`` to
        its value in the box: it stays in contact, and meets no other state. ``"one equilibrium"``:
        there is exactly one in contact. ``"no flutter"``: no equilibrium in contact has a λ of
        det(λ² M + K) = 0 with both a real and an imaginary part, as in (27). That is without
        dampers and slopes of friction laws, by which a state may still grow. ``"stable"``: small
        deviations from every equilibrium in contact decay, with dampers and slopes of friction
        laws: all λ of det(λ² M + λ (C + G) + K) = 0 have negative real parts.
    between : mapping, optional
        Ranges of parameters by name, which replace their values in ``p``: the sides of the box.
        Without it the box is a point.
    vary : str, optional
        The parameter that rises, for ``"no jump"`` only; by default mu0.
    begin : float, optional
        The value of ``vary`` at which the state is chosen; by default the lower end of its range.
    max_boxes : int, optional
        Most parts of the box to decide; the rest is undecided. By default 20 000 with closed forms,
        else 2000.
    refute : bool
        Also look for a point where the claim is false.
    method : {"auto", "closed", "search"}
        A closed form if the model has one for these arguments, else tubes and boxes of states; only
        the closed form; or only tubes and boxes.

    Returns
    -------
    Certificate
        ``boxes`` counts the parts.

    Raises
    ------
    ParameterError
        For parameters that are not scalars, ranges that leave theirs, or another claim.

    Notes
    -----
    Source: tubes around curves of states, see :mod:`spragsym.bifurcation.tubes`. A part is proved
    if the tube of all its points reaches the upper end of ``vary``. At a counterexample the tube of
    the point passes a fold below. A part that a fold crosses is halved; where the box touches the
    boundary of the claim, it stays undecided. Where states reach the border of a contact, the claim
    is refuted by a point at which the state is proved to end there; it is not proved where states
    pass the border. The other claims: :mod:`spragsym.design.certificates`. ``"stable"``: Hurwitz's
    determinants over boxes. The article's model: f, f′ and the eigenvalues of K over boxes, in
    affine arithmetic, see :mod:`spragsym.kang_nam.certificates`.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> base = ss.Parameters.article(theta0=np.radians(30.0), mu0=0.6)
    >>> ss.certify(base, between={"theta0": np.radians([30.0, 32.0]), "mu0": (0.6, 0.7)}).outcome
    'proved'
    >>> ss.certify(base, between={"mu0": (0.6, 0.9)}).outcome
    'refuted'
    >>> ss.certify(base.replace(theta0=1.6), "stable", between={"mu0": (0.1, 0.5)}).outcome
    'refuted'
    >>> p = ss.load("two_springs").Parameters()
    >>> sides = {"theta0": (0.5, 0.52), "mu0": (0.2, 0.3), "sigma": (0.1, 0.11)}
    >>> ss.certify(p, between=sides).outcome
    'proved'
    """
    model = model_of(p)
    model.require_answered("certify")
    sides = as_ranges("between", between, p.ranges)
    low, high = (p.replace(**{name: ends[side] for name, ends in sides.items()}) for side in (0, 1))
    box = claims((low, high), claim, vary=vary, begin=begin, method=method)
    return box.certificate(
        claim, box.most if max_boxes is None else as_count("max_boxes", max_boxes), refute
    )
