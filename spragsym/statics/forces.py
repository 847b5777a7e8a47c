"""Forces, stiffness, mass and damping of a model at a state, from its generated functions.

:class:`Forces` is a model with its combination of touching contacts: its arguments and borders.
:class:`Evaluation` is one evaluation of it, at coordinates and arguments of any number type:
floats, intervals over boxes, balls, or jets of these.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np

from ..models.forces import named, undecorated
from ..models.model import Model, Touching, label_of
from ..models.parameters import ParameterSet
from ..numerics import jets
from ..numerics.arithmetic import Matrix, Number, is_zero, odd_coefficients, part_of
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    Intervals,
    Shape,
    atan2,
    length,
    quiet,
    stacked,
    unit_vector,
)
from ..numerics.jets import argument, binomial_series, change_along, constant, order_of, rotation
from .namespaces import XP
from .options import SearchOptions

#: Arguments of generated functions by name, of any number type.
Values: TypeAlias = Mapping[str, Any]
#: Indicator of every contact: 1 where it touches, 0 where it is open; a jet may lie between.
Indicators: TypeAlias = Sequence[Any]
#: A periodic angle is searched from −this to this: beyond π, so that no image of a state is near
#: the border of the search.
SEARCHED_ANGLE = np.pi + 0.02


class Forces:
    """A model with the contacts that touch: arguments of its generated functions and its borders.

    Parameters of the search are those of the model, in the model's order. :meth:`prepared` turns
    them into the arguments of the generated functions, once for each node of the tree of points.
    """

    def __init__(
        self,
        model: Model,
        contact: Touching = True,
        law: str = "friction_at_rest",
        options: SearchOptions | None = None,
    ) -> None:
        model.require_answered("rest")
        about = model.about
        self.search_options = options or SearchOptions()
        #: Name of the generated function that gives μ; ``"friction_at_speed"`` is μ(V), which a
        #: motion that has come to rest feels.
        self.law = law
        self.model, self.contact = model, contact
        #: Itself, since other systems of states refer to their balance by this name.
        self.balance: Any = self
        self.coordinates: list[str] = list(model.coordinates)
        self.parameters: list[str] = list(model.parameters)
        self.angles: dict[str, Sequence[str]] = dict(about["angles"])
        #: Names of parameters that the forces depend on; others matter to the motion alone.
        self.balanced = model.balanced
        #: Names of parameters that may be 0.
        self.may_vanish = [
            entry["name"]
            for entry in about["parameters"]
            if entry["name"] not in self.angles and not (entry["low"] == 0 and entry["low_open"])
        ]
        #: Names of all arguments: parameters, cosines and sines of angles, and an angle itself
        #: only where a function depends on it directly.
        self.codes: list[str] = list(
            dict.fromkeys(itertools.chain(*reversed(about["arguments"].values())))
        )
        self.n = len(self.coordinates)
        self.springs = len(about["springs"])
        #: For each torsion spring, the number of the spring whose direction turns it.
        self.torsions: list[int] = [entry["spring"] for entry in about["torsions"]]
        #: Whether the kinetic energy has terms linear in the rates.
        self.gyroscopic = hasattr(model.algebra, "gyroscopic")
        #: Names of contacts, and of contacts with friction.
        self.contacts = [entry["name"] for entry in model.contacts]
        self.rubbing = model.rubbing
        #: For each contact, 1 if it touches, else 0; one that can't open always touches.
        self.indicators = [
            int(
                not entry["border"]
                or (label_of(entry) in contact if isinstance(contact, tuple) else contact)
            )
            for entry in model.contacts
        ]
        #: Numbers of the contacts with a border, which open or press on either face; for each of
        #: these, whether it touches.
        self.opens = [k for k, entry in enumerate(model.contacts) if entry["border"]]
        self.closed = [bool(self.indicators[k]) for k in self.opens]
        #: States up to ``slack`` beyond a border are accepted: of the contacts ``beyond``, by their
        #: numbers, or of all where there are none. ``slacks`` are the values by contact.
        self.slack, self.slacks = 0.0, [0.0] * len(self.opens)
        self.beyond: tuple[int, ...] = ()
        #: Whether states on the border of an open contact are excluded, since another combination
        #: of contacts has them.
        self.apart = False
        #: −low and high of each coordinate that borders allow: a bound where the gap of a contact
        #: is a coordinate itself.
        self.border = np.full((2, self.n), np.inf)
        for k in self.opens:
            if (gap := model.contacts[k]["border"]) in self.coordinates:
                self.border[self.indicators[k], self.coordinates.index(gap)] = 0.0
        #: Numbers of coordinates that are periodic angles: one turn of each is searched.
        self.periodic = model.whole_turns
        self.border[:, list(self.periodic)] = SEARCHED_ANGLE
        #: −low and high of each coordinate between which the forces are evaluated: the laws of
        #: contacts that are polynomials are valid beyond their borders.
        self.limits = (
            np.full((2, self.n), np.inf)
            if all(entry["polynomial"] for entry in model.contacts)
            else self.border.copy()
        )
        #: Generated names of the balance in another basis of rows, if the model has one. It
        #: vanishes where the forces do; internal forces have been cancelled in it symbolically, so
        #: that they do not widen intervals.
        self.sums = (
            {"forces": "balance", "forces_jacobian": "balance_jacobian"}
            if hasattr(model.algebra, "balance")
            else {}
        )
        #: Generated names of the rows that continuation along a parameter follows: those of
        #: ``sums``, if their derivatives by parameters are generated too.
        self.followed = (
            {**self.sums, "forces_by_parameters": "balance_by_parameters"}
            if hasattr(model.algebra, "balance_by_parameters")
            else {}
        )

    # -------------------------------------------------------------------------------------------
    # arguments

    def prepared(self, bounds: Intervals) -> Intervals:
        """Arguments of the generated functions, shape (arguments, N), from parameters of shape (P,
        N).
        """
        with quiet():
            values = self.arguments_of(dict(zip(self.parameters, bounds, strict=True)), XP)
        return stacked([values[code] for code in self.codes], bounds.shape[1:])

    def prepared_beside(
        self, prepared: FloatArray, fixed: FloatArray, moved: Mapping[str, Intervals]
    ) -> Intervals:
        """Prepared arguments after the parameters ``moved`` have left their values in ``fixed``.

        ``prepared`` are the ends of the arguments at ``fixed``.
        """
        ends = prepared.copy()
        with quiet():
            for code, part in self.with_angles(moved, XP).items():
                if code in self.codes:
                    ends[:, self.codes.index(code)] = part.ends
        return Intervals(ends)

    def with_angles(self, values: Values, xp: Any) -> dict[str, Any]:
        """The values, with cosine and sine of each parameter that is an angle."""
        found = dict(values)
        for name, (cosine, sine) in self.angles.items():
            if name in values:
                found |= {cosine: xp.cos(values[name]), sine: xp.sin(values[name])}
        return found

    #: Arguments of the generated functions by name, from all parameters, of any number type.
    arguments_of = with_angles

    def floats(self, columns: Iterable[FloatArray]) -> dict[str, Any]:
        """Arguments by name, as floats, from parameters of shape (parameters, N)."""
        return self.arguments_of(dict(zip(self.parameters, columns, strict=True)), np)

    def arguments(self, prepared: Intervals) -> dict[str, Any]:
        """Arguments by name, from the prepared array.

        A parameter that is 0 in all boxes, and may be 0, becomes the exact number 0, so that
        products with it and exponentials of it are exact.
        """
        values = dict(zip(self.codes, prepared, strict=False))
        return values | {name: 0 for name in self.may_vanish if values[name].is_nothing()}

    def over(self, bounds: Intervals) -> dict[str, Any]:
        """Arguments by name, from parameters of shape (P, N)."""
        return self.arguments(self.prepared(bounds))

    def at(
        self, q: Sequence[Any], values: Values, shape: Shape = (), xp: object = XP
    ) -> Evaluation:
        """The evaluation at coordinates ``q``; an empty one serves functions of parameters
        alone.
        """
        return Evaluation(self, q if len(q) else [0] * self.n, values, shape, xp)

    def sides(self, gaps: Sequence[Intervals]) -> tuple[BoolArray, BoolArray]:
        """Masks of the points that lie on the required side of all borders, and of those beyond any
        border.

        A point is in neither mask if its gap is not known well enough. Without contacts that open,
        all points are on the required side.
        """
        inside = np.ones(gaps[0].shape, dtype=bool)
        beyond = ~inside
        for gap, closed, slack in zip(gaps, self.closed, self.slacks, strict=False):
            if closed:
                on_side, off_side = gap.high <= slack, gap.low > slack
            elif self.apart:
                on_side, off_side = gap.low > 0, gap.high <= 0
            else:
                on_side, off_side = gap.low >= -slack, gap.high < -slack
            inside, beyond = inside & on_side, beyond | off_side
        return inside, beyond

    def by_parameters(
        self, at: Evaluation, names: Sequence[str], rows: str = "forces_by_parameters"
    ) -> list[list[Any]]:
        """Derivatives of ``rows`` by the named parameters, one list for each row.

        Includes the dependence of the friction coefficients on parameters, by the chain rule. The
        derivative by an angle is by the angle itself, not by its cosine and sine.
        """
        laws = at.of_frictions("friction_by_parameters")
        direct = self.model.about["by_parameters"]

        def slope(row: Sequence[Any], name: str) -> Number:
            index = self.parameters.index(name)
            found = row[direct.index(name)] if name in direct else 0
            for by_mu, law in zip(row[-len(laws) :], laws, strict=True):
                found = found + by_mu * law[index]
            return found

        return [[slope(row, name) for name in names] for row in at.rows(rows)]


@dataclass
class Evaluation:
    """One evaluation of a model's generated functions, at coordinates ``q`` and arguments
    ``values``.

    All numbers are of one type, whose functions are ``xp``; ``shape`` is that of arrays of boxes.
    ``upright`` are the numbers of springs with dx = 0. ``sides`` say, for each torsion spring,
    which angle boxes get that meet the ray where it jumps: NaN if not given, the value on one side
    of the ray for 1 and −1, and [−π, π] for 0.
    """

    balance: Forces
    q: Sequence[Any]
    values: Values
    shape: Shape = ()
    xp: Any = XP
    upright: Sequence[int] = ()
    sides: Sequence[int] | None = None
    #: Given directions and torsion angles, or torsion angles alone, that replace those that follow
    #: from the coordinates.
    fixed: Sequence[Any] | None = None
    turnings: Sequence[Any] | None = None
    #: Coordinates to which M, C + G, G, K and K − Kᵀ are restricted; None for all.
    part: Sequence[int] | None = None

    @cached_property
    def box(self) -> Intervals:
        """The coordinates as one array of intervals."""
        return stacked(self.q, self.shape)

    def call(self, name: str, first: Iterable[Any], *last: Any, kind: str = "motion") -> Any:
        """The value of a generated function.

        Its arguments are ``first`` (coordinates, and perhaps directions), then the parameters that
        the function takes (those of ``kind``, unless the model lists its own), then ``last``.
        """
        arguments = self.balance.model.about["arguments"]
        listed = [self.values[code] for code in arguments.get(name, arguments[kind])]
        return undecorated(getattr(self.balance.model.algebra, name))(
            *first, *listed, *last, xp=self.xp
        )

    # ------------------------------------------------------------------------------------------
    # directions

    @cached_property
    def geometry(self) -> Sequence[Any]:
        """(dx, dy, undeformed length) of every spring, from the mass to the anchor."""
        return self.call("geometry", self.q, kind="statics")

    def of_springs(self, name: str) -> Sequence[Any]:
        """A function of parameters alone: ``"stiffnesses"`` of springs or ``"torsions"``, the
        stiffnesses of torsion springs.
        """
        return self.call(name, self.q, kind="statics")

    @property
    def at_rest(self) -> list[tuple[Any, Any]]:
        """Cosine and sine of the direction of each torsion spring without torque.

        The turning of a line along x is minus the angle of rest, hence the sign of the sine.
        """
        pairs = self.call("turnings", [*self.q, *[1, 0, 1] * self.balance.springs], kind="statics")
        return [(cosine, -sine) for cosine, sine in pairs]

    @cached_property
    def anchors(self) -> list[tuple[Intervals, Intervals]]:
        """The vectors from the mass to the anchors of all springs, as intervals."""
        return [
            (as_intervals(dx, self.shape), as_intervals(dy, self.shape))
            for dx, dy, _ in self.geometry
        ]

    @cached_property
    def directions(self) -> list[Any]:
        """Cosine, sine and length of every spring, then the angle of every torsion spring."""
        if self.fixed is not None:
            return list(self.fixed)
        steps = [
            (0 if index in self.upright else dx, dy)
            for index, (dx, dy, _) in enumerate(self.geometry)
        ]
        parts = [part for step in steps for part in self.direction(*step)]
        if self.turnings is not None or not self.balance.torsions:
            return [*parts, *(self.turnings or ())]
        return parts + self._turnings(steps, parts)

    def direction(self, dx: Number, dy: Number) -> tuple[Any, Any, Any]:
        """Cosine, sine and length of a vector; sharp enclosures over boxes, quotients for other
        numbers.
        """
        if self.xp is XP:
            return direction(dx, dy, self.shape)
        size = self.xp.sqrt(dx**2 + dy**2)
        return dx / size, dy / size, size

    def _turnings(self, steps: Sequence[tuple[Any, Any]], directions: Sequence[Any]) -> list[Any]:
        """The angle φ of every torsion spring; over boxes, 0 for a spring without stiffness."""
        if self.xp is not XP:
            pairs = self.call("turnings", [*self.q, *directions], kind="statics")
            return [self.xp.atan2(sine, cosine) for cosine, sine in pairs]
        constants = {name: jets.constant(value) for name, value in self.values.items()}
        point = map(jets.constant, [*self.q, *directions])
        turned = replace(self, values=constants).call("turnings", point, kind="statics")
        springs, stiffnesses = self.balance.torsions, self.of_springs("torsions")
        sides: Sequence[int | None] = self.sides or [None] * len(springs)
        each = zip(turned, stiffnesses, springs, self.at_rest, sides, strict=True)
        return [
            Intervals(np.zeros((2, *self.shape)))
            if is_zero(k) or (isinstance(k, Intervals) and k.is_nothing())
            else turning(value, steps[spring], rest, self.shape, side)
            for value, k, spring, rest, side in each
        ]

    # ---------------------------------------------------------------------------------------------
    # forces

    def rows(self, name: str = "forces", indicators: Indicators | None = None) -> Sequence[Any]:
        """Rows by coordinate of a generated function with the arguments of ``forces``.

        ``indicators`` replaces the contact indicators of the balance.
        """
        indicators = indicators or self.balance.indicators
        first = [*self.q, *self.directions]
        return self.call(name, first, *self.frictions, *indicators, kind="statics")

    def followed(self, name: str) -> Sequence[Any]:
        """Rows as :meth:`rows` gives them, in the basis that continuation along a parameter
        follows.
        """
        return self.rows(self.balance.followed.get(name, name))

    def forces(self) -> Sequence[Any]:
        """Residuals of the balance of forces."""
        return self.rows(self.balance.sums.get("forces", "forces"))

    @cached_property
    def slopes(self) -> Matrix:
        """Jacobian of :meth:`forces` by the coordinates.

        Its determinant is det K, and its null vectors are those of K.
        """
        return self.rows(self.balance.sums.get("forces_jacobian", "forces_jacobian"))

    def stiffness(self) -> Matrix:
        """The stiffness matrix K."""
        return self._parted(self.rows("forces_jacobian") if self.balance.sums else self.slopes)

    def _parted(self, A: Matrix) -> Matrix:
        """The matrix restricted to the coordinates ``part``."""
        return A if self.part is None else part_of(A, self.part)

    def contact_force(self, contact: int, indicator: Any) -> Number:
        """The normal force of contact number ``contact``, for its contact ``indicator``."""
        return self.call(named("contact_force", self.balance.contacts[contact]), self.q, indicator)

    def of_frictions(self, name: str) -> list[Any]:
        """A generated function of parameters alone, for every contact with friction."""
        return [self.call(named(name, one), ()) for one in self.balance.rubbing]

    @cached_property
    def frictions(self) -> list[Any]:
        """The friction coefficient μ of every contact with friction, in steady sliding."""
        return self.of_frictions(self.balance.law)

    @property
    def circulatory_frictions(self) -> list[Any]:
        """Friction coefficients of the touching contacts whose friction makes K unsymmetric."""
        balance = self.balance
        return [
            mu
            for mu, name, circulatory in zip(
                self.frictions, balance.rubbing, balance.model.about["circulatory"], strict=True
            )
            if circulatory and balance.indicators[balance.contacts.index(name)]
        ]

    def mass(self) -> Matrix:
        """The mass matrix M."""
        return self._parted(self.call("mass_matrix", self.q))

    def damping(self, indicators: Indicators | None = None) -> Matrix:
        """The damping matrix C, of dampers and of the slopes of the friction laws."""
        first = [*self.q, *self.directions[: 3 * self.balance.springs]]
        return self.call("damping", first, *(indicators or self.balance.indicators))

    def gyroscopic(self) -> Matrix:
        """The gyroscopic matrix G; 0 if the kinetic energy has no terms linear in the rates."""
        if self.balance.gyroscopic:
            return self._parted(self.call("gyroscopic", self.q))
        return [[0] * len(self.q) for _ in self.q]

    def circulatory(self) -> Matrix:
        """K − Kᵀ of a gyroscopic model. Other models do not need it and get 0."""
        if self.balance.gyroscopic:
            return self._parted(self.rows("circulatory"))
        return self.gyroscopic()

    def unpaired(self, block: Sequence[int] | None = None) -> list[Any]:
        """Numbers that are all 0 exactly if the λ of det(λ² M + λ G + K), or of a block of it, come
        in pairs ± λ: its odd coefficients.
        """
        every = (self.stiffness(), self.gyroscopic(), self.mass(), self.circulatory())
        return odd_coefficients(*(A if block is None else part_of(A, block) for A in every))

    def by_rates(self) -> Matrix:
        """C + G, the derivative of the forces by the rates."""
        C = self._parted(self.damping())
        if not self.balance.gyroscopic:
            return C
        rows = zip(C, self.gyroscopic(), strict=True)
        return [[c + g for c, g in zip(*row, strict=True)] for row in rows]

    def slopes_of_friction(self) -> list[Any]:
        """dμ/dv of every friction law, in steady sliding."""
        return self.of_frictions("friction_slope")

    def slope_has_a_sign(self) -> BoolArray:
        """Whether dμ/dv of at least one friction law is proved to be nonzero.

        The sum of terms factor · exp(power) is scaled by one exponential, so that the proof also
        works where the slope underflows.
        """
        out = np.zeros(self.shape, dtype=bool)
        sizes = self.of_frictions("friction_slope_by_sizes")
        for terms in itertools.chain(*sizes):
            total = Intervals.point(np.zeros(self.shape))
            for factor, power in terms:
                if as_intervals(factor, self.shape).ends.any():
                    total = total + factor * XP.exp(power)
            out |= ~total.holds_zero()
        return out

    def gap(self, contact: int) -> Number:
        """The gap of contact number ``contact``."""
        name = named("contact_gap", self.balance.contacts[contact])
        return self.call(name, self.q, kind="statics")

    def gaps(self) -> list[Any]:
        """The gaps of the contacts that open."""
        return [self.gap(contact) for contact in self.balance.opens]

    def beside_border(self) -> tuple[BoolArray, BoolArray]:
        """Masks of boxes on the required side of all borders, and of boxes beyond any border."""
        return self.balance.sides([as_intervals(gap, self.shape) for gap in self.gaps() or [0]])

    def mirrored(self) -> Sequence[Any]:
        """The mirror image of the state."""
        return self.call("mirror", self.q, kind="statics")


def direction(dx: Number, dy: Number, shape: Shape) -> tuple[Any, Any, Any]:
    """Cosine, sine and length of the vector (dx, dy), as intervals of that shape or jets of them.

    Let u + i v be the relative change of the vector, seen in its own direction: the changed vector
    is (c + i s) (1 + u + i v) l. All derivatives then follow from the sharp enclosures of c, s and
    l, and not from quotients of intervals.
    """
    c, s, L = _at(dx, dy, shape)
    order = order_of(dx, dy)
    if not order:
        return c, s, L
    u, v = change_along(dx, dy, c, s, L)
    w = u * 2 + u**2 + v**2
    root, inverse = (w.composed(binomial_series(Fraction(sign, 2), order)) for sign in (1, -1))
    cosine, sine = (u + 1) * inverse, v * inverse
    return cosine * c - sine * s, cosine * s + sine * c, root * L


def turning(
    value: tuple[Any, Any],
    vector: tuple[Any, Any],
    rest: tuple[Any, Any],
    shape: Shape,
    side: int | None,
) -> Number:
    """The torsion angle φ in [−π, π], as intervals or a jet of them; NaN in boxes that meet φ = ±π.

    ``value`` holds cosine and sine of φ, ``vector`` that of its spring, and ``rest`` cosine and
    sine of the direction at rest. ``side`` chooses the value in boxes that meet the ray φ = ±π, see
    :func:`spragsym.numerics.interval_arrays.atan2`. Derivatives are those of the spring's direction
    minus those of the direction at rest. They hold on either side of the ray, but the mean value
    theorem does not hold across it.
    """
    cosine, sine = (as_intervals(part, shape) for part in value)
    phi: Any = atan2(sine, cosine, side)
    if order_of(*vector):
        phi = argument(*change_along(*vector, *_at(*vector, shape))) + phi
    if order_of(*rest):
        phi = -argument(*rotation(rest[1], rest[0])) + phi
    return phi


def _at(dx: Number, dy: Number, shape: Shape) -> tuple[Intervals, Intervals, Intervals]:
    """Direction and length at the point itself, of jets their constant terms."""
    along, across = (as_intervals(constant(part), shape) for part in (dx, dy))
    return *unit_vector(along, across), length(along, across)


def as_intervals(value: Number, shape: Shape) -> Intervals:
    """A number, or intervals of any shape, as intervals of the given shape."""
    if isinstance(value, Intervals) and value.shape == shape:
        return value
    return stacked([value], shape)[0]


def filled(rows: Matrix, shape: Shape) -> FloatArray:
    """A matrix of numbers and arrays as one float array, shape (rows, columns, *shape)."""
    found = np.empty((len(rows), len(rows[0]) if rows else 0, *shape))
    for i, row in enumerate(rows):
        for j, entry in enumerate(row):
            found[i, j] = entry
    return found


def belt_speeds(p: ParameterSet) -> Sequence[Any]:
    """Sliding speeds of a mass at rest, for all frictions."""
    model = p.model
    levels = model.algebra.borders(
        *np.zeros(2 * len(model.coordinates)), *model.arguments(p, "motion")
    )
    return levels[len(model.contacts) :]


def resting(p: ParameterSet) -> list[str]:
    """Names of the contacts on which friction holds, with belts that stand still."""
    each = zip(p.model.frictions, belt_speeds(p), strict=False)
    return [entry["name"] for entry, speed in each if entry["holds"] and not np.any(speed)]
