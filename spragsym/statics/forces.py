"""The generated functions of a model at a state, with arguments of any number type."""

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
from ..numerics import jets
from ..numerics.arithmetic import Matrix, Number, is_zero, part_of
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
#: 1 for a contact that touches, else 0, or any number beside: of every contact.
Pushing: TypeAlias = Sequence[Any]
#: Where an angle is searched that comes around after a turn: beyond π to either side, so that no
#: state is near the border.
SEARCHED_ANGLE = np.pi + 0.02


class Forces:
    """Forces of a model in contact or in lift-off, and all else that is generated for it.

    Parameters of the search are those of the model, in its order; :meth:`prepared` turns them into
    the arguments of the generated functions, once for each node of the tree of points.
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
        #: The generated function that gives μ; ``"friction_at_speed"`` is for a motion that has
        #: come to rest.
        self.law = law
        self.model, self.contact = model, contact
        #: As a system of states it is its own balance.
        self.balance: Any = self
        self.coordinates: list[str] = list(model.coordinates)
        self.parameters: list[str] = list(model.parameters)
        self.angles: dict[str, Sequence[str]] = dict(about["angles"])
        #: Parameters on which the balance depends, and not the motion alone.
        self.balanced = model.balanced
        #: Parameters that may be 0.
        self.may_vanish = [
            entry["name"]
            for entry in about["parameters"]
            if entry["name"] not in self.angles and not (entry["low"] == 0 and entry["low_open"])
        ]
        #: Arguments of the functions: cosines and sines of angles, and these too where they stand
        #: by themselves.
        self.codes: list[str] = list(
            dict.fromkeys(itertools.chain(*reversed(about["arguments"].values())))
        )
        self.n = len(self.coordinates)
        #: Boxes of a point after which it is given up: of three coordinates these are more.
        self.usual_budget = 20_000 if self.n < 3 else 200_000
        self.springs = len(about["springs"])
        #: Of each torsion spring the number of the spring that it turns with.
        self.torsions: list[int] = [entry["spring"] for entry in about["torsions"]]
        #: Whether the kinetic energy has terms linear in the rates.
        self.gyroscopic = hasattr(model.algebra, "gyroscopic")
        #: Names of contacts, and of those that rub.
        self.contacts = [entry["name"] for entry in model.contacts]
        self.rubbing = model.rubbing
        #: Of every contact whether it touches; one that does not open always does.
        self.pushing = [
            int(
                not entry["border"]
                or (label_of(entry) in contact if isinstance(contact, tuple) else contact)
            )
            for entry in model.contacts
        ]
        #: Numbers of the contacts that open or press on either face, and which of them touch.
        self.opens = [k for k, entry in enumerate(model.contacts) if entry["border"]]
        self.closed = [bool(self.pushing[k]) for k in self.opens]
        #: How far beyond the borders of contacts states count, too, or beyond that of number
        #: ``beyond``.
        self.room, self.rooms = 0.0, [0.0] * len(self.opens)
        self.beyond: int | None = None
        #: Whether a state on a border does not count where that contact is open.
        self.apart = False
        #: −low and high of each coordinate: on which side of the border a contact's gap is, where
        #: that is a coordinate.
        self.border = np.full((2, self.n), np.inf)
        for k in self.opens:
            if (gap := model.contacts[k]["border"]) in self.coordinates:
                self.border[self.pushing[k], self.coordinates.index(gap)] = 0.0
        #: Turns of angles after which all is as before: one turn of each that makes one is
        #: searched.
        self.periodic = model.whole_turns
        self.border[:, list(self.periodic)] = SEARCHED_ANGLE
        #: Beyond them the forces are not asked for.
        self.limits = (
            np.full((2, self.n), np.inf)
            if all(entry["polynomial"] for entry in model.contacts)
            else self.border.copy()
        )
        #: Sums of rows without forces between coordinates or of contacts that turn, where there
        #: are such: they vanish together with the forces, and what cancels in them is not lost in
        #: boxes.
        self.sums = (
            {"forces": "balance", "forces_jacobian": "balance_jacobian"}
            if hasattr(model.algebra, "balance")
            else {}
        )
        #: The rows that are followed along a parameter: these, where their slopes by it are known.
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
        """Prepared parameters of which some have ``moved`` from ``fixed`` ones, whose prepared ends
        are ``prepared``.
        """
        ends = prepared.copy()
        with quiet():
            for code, part in self.with_angles(moved, XP).items():
                if code in self.codes:
                    ends[:, self.codes.index(code)] = part.ends
        return Intervals(ends)

    def with_angles(self, values: Values, xp: Any) -> dict[str, Any]:
        """Some parameters with cosine and sine of those that are angles."""
        found = dict(values)
        for name, (cosine, sine) in self.angles.items():
            if name in values:
                found |= {cosine: xp.cos(values[name]), sine: xp.sin(values[name])}
        return found

    #: Arguments by name, from all parameters of any number type.
    arguments_of = with_angles

    def floats(self, columns: Iterable[FloatArray]) -> dict[str, Any]:
        """Arguments as floats, shape (parameters, N)."""
        return self.arguments_of(dict(zip(self.parameters, columns, strict=True)), np)

    def arguments(self, prepared: Intervals) -> dict[str, Any]:
        """By name.

        A parameter that is 0 everywhere, and may be, is the number 0: products with it and
        exponentials of it are exact.
        """
        values = dict(zip(self.codes, prepared, strict=False))
        return values | {name: 0 for name in self.may_vanish if values[name].is_nothing()}

    def over(self, bounds: Intervals) -> dict[str, Any]:
        """:meth:`arguments` from parameters of shape (P, N)."""
        return self.arguments(self.prepared(bounds))

    def at(
        self, q: Sequence[Any], values: Values, shape: Shape = (), xp: object = XP
    ) -> Evaluation:
        """The evaluation at coordinates, which functions of parameters alone do not need."""
        return Evaluation(self, q if len(q) else [0] * self.n, values, shape, xp)

    def sides(self, gaps: Sequence[Intervals]) -> tuple[BoolArray, BoolArray]:
        """Mask of points where gaps are on this side of their contacts' borders or on them, and
        where one is beyond; all on this side where none opens.
        """
        inside = np.ones(gaps[0].shape, dtype=bool)
        beyond = ~inside
        for gap, closed, room in zip(gaps, self.closed, self.rooms, strict=False):
            if closed:
                here, there = gap.high <= room, gap.low > room
            elif self.apart:
                here, there = gap.low > 0, gap.high <= 0
            else:
                here, there = gap.low >= -room, gap.high < -room
            inside, beyond = inside & here, beyond | there
        return inside, beyond

    def by_parameters(
        self, at: Evaluation, names: Sequence[str], rows: str = "forces_by_parameters"
    ) -> list[list[Any]]:
        """Derivatives of the forces along each coordinate, or of other ``rows``, by parameters,
        through the friction law too; an angle as the angle.
        """
        laws, own = at.of_frictions("friction_by_parameters"), self.model.about["by_parameters"]

        def slope(row: Sequence[Any], name: str) -> Number:
            index, found = self.parameters.index(name), row[own.index(name)] if name in own else 0
            for by_mu, law in zip(row[-len(laws) :], laws, strict=True):
                found = found + by_mu * law[index]
            return found

        return [[slope(row, name) for name in names] for row in at.rows(rows)]


@dataclass
class Evaluation:
    """Coordinates and arguments of one evaluation, all of one number type, and what follows from
    them.

    ``upright`` are springs with dx = 0. ``sides`` tell for each torsion spring what its turning is
    in boxes that meet the ray where it jumps: NaN without it, with 1 or −1 that on one side of the
    ray, with 0 anything from −π to π.
    """

    balance: Forces
    q: Sequence[Any]
    values: Values
    shape: Shape = ()
    xp: Any = XP
    upright: Sequence[int] = ()
    sides: Sequence[int] | None = None
    #: Directions and turnings, or turnings alone, where these do not follow from the coordinates.
    fixed: Sequence[Any] | None = None
    turnings: Sequence[Any] | None = None
    #: Coordinates whose rows and columns M, C + G, G and K have; None of all.
    part: Sequence[int] | None = None

    @cached_property
    def box(self) -> Intervals:
        """Boxes of coordinates as one array."""
        return stacked(self.q, self.shape)

    def call(self, name: str, first: Iterable[Any], *last: Any, kind: str = "motion") -> Any:
        """A generated function of coordinates, and directions perhaps, of arguments of a kind, and
        of what comes behind these.
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
        """Vector and undeformed length of every line."""
        return self.call("geometry", self.q, kind="statics")

    def of_springs(self, name: str) -> Sequence[Any]:
        """A function of parameters only: ``"stiffnesses"`` of springs, ``"torsions"`` of
        turning.
        """
        return self.call(name, self.q, kind="statics")

    @property
    def at_rest(self) -> list[tuple[Any, Any]]:
        """Cosine and sine of the direction in which each torsion spring rests: a line along x has
        turned by minus its angle.
        """
        pairs = self.call("turnings", [*self.q, *[1, 0, 1] * self.balance.springs], kind="statics")
        return [(cosine, -sine) for cosine, sine in pairs]

    @cached_property
    def anchors(self) -> list[tuple[Intervals, Intervals]]:
        """The vectors from the mass to the anchors of all springs, over boxes."""
        return [
            (as_intervals(dx, self.shape), as_intervals(dy, self.shape))
            for dx, dy, _ in self.geometry
        ]

    @cached_property
    def directions(self) -> list[Any]:
        """Cosine, sine and length of every spring, then the turning of every torsion spring."""
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
        """Cosine, sine and length of a vector: of boxes sharp enclosures, of narrow numbers
        quotients.
        """
        if self.xp is XP:
            return direction(dx, dy, self.shape)
        size = self.xp.sqrt(dx**2 + dy**2)
        return dx / size, dy / size, size

    def _turnings(self, steps: Sequence[tuple[Any, Any]], directions: Sequence[Any]) -> list[Any]:
        """φ of every torsion spring; over boxes 0 where its stiffness is."""
        if self.xp is not XP:
            pairs = self.call("turnings", [*self.q, *directions], kind="statics")
            return [self.xp.atan2(sine, cosine) for cosine, sine in pairs]
        still = replace(
            self, values={name: jets.constant(value) for name, value in self.values.items()}
        )
        turned = still.call("turnings", map(jets.constant, [*self.q, *directions]), kind="statics")
        springs, stiffnesses = self.balance.torsions, self.of_springs("torsions")
        sides: Sequence[int | None] = self.sides or [None] * len(springs)
        each = zip(turned, stiffnesses, springs, self.at_rest, sides, strict=True)
        return [
            Intervals(np.zeros((2, *self.shape)))
            if _is_none(k)
            else turning(value, steps[spring], rest, self.shape, side)
            for value, k, spring, rest, side in each
        ]

    # ---------------------------------------------------------------------------------------------
    # forces

    def rows(self, name: str = "forces", pushing: Pushing | None = None) -> Sequence[Any]:
        """Rows by coordinate of a function that has the arguments of ``forces``; with ``pushing`` 0
        as where a contact is open.
        """
        pushing = self.balance.pushing if pushing is None else pushing
        first = [*self.q, *self.directions]
        return self.call(name, first, *self.frictions, *pushing, kind="statics")

    def followed(self, name: str) -> Sequence[Any]:
        """Rows as :meth:`rows` has them, of the balance that is followed along a parameter."""
        return self.rows(self.balance.followed.get(name, name))

    def forces(self) -> Sequence[Any]:
        """Rows of the balance."""
        return self.rows(self.balance.sums.get("forces", "forces"))

    @cached_property
    def slopes(self) -> Matrix:
        """Derivatives of the rows of the balance: det K is their determinant, and K v is 0 where
        theirs is.
        """
        return self.rows(self.balance.sums.get("forces_jacobian", "forces_jacobian"))

    def stiffness(self) -> Matrix:
        """The stiffness matrix K."""
        return self._parted(self.rows("forces_jacobian") if self.balance.sums else self.slopes)

    def _parted(self, A: Matrix) -> Matrix:
        return A if self.part is None else part_of(A, self.part)

    def contact_force(self, contact: int, pushing: Any) -> Number:
        """The normal force of a contact, by its number."""
        return self.call(named("contact_force", self.balance.contacts[contact]), self.q, pushing)

    def of_frictions(self, name: str) -> list[Any]:
        """A function of parameters alone, of every friction."""
        return [self.call(named(name, one), ()) for one in self.balance.rubbing]

    @cached_property
    def frictions(self) -> list[Any]:
        """The friction coefficients at steady sliding."""
        return self.of_frictions(self.balance.law)

    @property
    def circulatory_frictions(self) -> list[Any]:
        """Friction coefficients of the contacts that touch with which K is not symmetric."""
        balance = self.balance
        return [
            mu
            for mu, name, circulatory in zip(
                self.frictions, balance.rubbing, balance.model.about["circulatory"], strict=True
            )
            if circulatory and balance.pushing[balance.contacts.index(name)]
        ]

    def mass(self) -> Matrix:
        """M of the kinetic energy."""
        return self._parted(self.call("mass_matrix", self.q))

    def damping(self, pushing: Pushing | None = None) -> Matrix:
        """C of dampers and of the slopes of the friction laws."""
        pushing = self.balance.pushing if pushing is None else pushing
        return self.call(
            "damping", [*self.q, *self.directions[: 3 * self.balance.springs]], *pushing
        )

    def gyroscopic(self) -> Matrix:
        """G of a kinetic energy with terms linear in the rates; 0 of a model without."""
        if self.balance.gyroscopic:
            return self._parted(self.call("gyroscopic", self.q))
        return [[0] * len(self.q) for _ in self.q]

    def circulatory(self) -> Matrix:
        """K − Kᵀ, of a model with G; of another it is not asked for, and 0."""
        if self.balance.gyroscopic:
            return self.rows("circulatory")
        return self.gyroscopic()

    def by_rates(self) -> Matrix:
        """C + G: what the rates bring."""
        C = self._parted(self.damping())
        if not self.balance.gyroscopic:
            return C
        rows = zip(C, self.gyroscopic(), strict=True)
        return [[c + g for c, g in zip(*row, strict=True)] for row in rows]

    def slopes_of_friction(self) -> list[Any]:
        """Slopes of the friction laws at steady sliding."""
        return self.of_frictions("friction_slope")

    def slope_has_a_sign(self) -> BoolArray:
        """Whether the slope of one friction law is shown not to be 0, over one of its exponentials:
        also where that is too small for floats.
        """
        out = np.zeros(self.shape, dtype=bool)
        sizes = self.of_frictions("friction_slope_by_sizes")
        for terms in itertools.chain(*sizes):
            kept = [
                (factor, power)
                for factor, power in terms
                if as_intervals(factor, self.shape).ends.any()
            ]
            total = sum(
                (factor * XP.exp(power) for factor, power in kept),
                Intervals.point(np.zeros(self.shape)),
            )
            out |= ~total.holds_zero()
        return out

    def gap(self, contact: int) -> Number:
        """The gap of a contact, by its number."""
        name = named("contact_gap", self.balance.contacts[contact])
        return self.call(name, self.q, kind="statics")

    def gaps(self) -> list[Any]:
        """The gaps of the contacts that open."""
        return [self.gap(contact) for contact in self.balance.opens]

    def beside_border(self) -> tuple[BoolArray, BoolArray]:
        """Boxes on this side of the contacts' borders or on them, and boxes beyond one."""
        return self.balance.sides([as_intervals(gap, self.shape) for gap in self.gaps() or [0]])

    def mirrored(self) -> Sequence[Any]:
        """The image of the state in the model's mirror."""
        return self.call("mirror", self.q, kind="statics")


def _is_none(stiffness: Number) -> bool:
    """0 everywhere, and no unknown."""
    return is_zero(stiffness) or (isinstance(stiffness, Intervals) and stiffness.is_nothing())


def direction(dx: Number, dy: Number, shape: Shape) -> tuple[Any, Any, Any]:
    """Cosine, sine and length of the vector (dx, dy): arrays of intervals of that shape, or jets of
    them.

    With the turned and scaled change u + i v of the vector, (c + i s) (1 + u + i v) l is the
    vector. So all derivatives come from the sharp enclosures of c, s and l, not from quotients of
    intervals.
    """
    c, s, L = _at(dx, dy, shape)
    order = order_of(dx, dy)
    if not order:
        return c, s, L
    u, v = change_along(dx, dy, c, s, L)
    w = u * 2 + u**2 + v**2
    root, inverse = (w.composed(binomial_series(Fraction(way, 2), order)) for way in (1, -1))
    cosine, sine = (u + 1) * inverse, v * inverse
    return cosine * c - sine * s, cosine * s + sine * c, root * L


def turning(
    value: tuple[Any, Any],
    vector: tuple[Any, Any],
    rest: tuple[Any, Any],
    shape: Shape,
    side: int | None,
) -> Number:
    """The turning φ of a spring in [−π, π], an array of intervals or a jet of them; NaN where boxes
    meet the ray φ = ±π.

    ``value`` holds cosine and sine of φ without their changes, ``rest`` those of the inclination at
    rest; ``side`` says what is given on the ray instead, see
    :func:`spragsym.numerics.interval_arrays.atan2`. Its derivatives are those of the spring's angle
    less those of the angle at rest: algebra in sharp enclosures of direction and length. They hold
    at every point off the ray, and so on either side of it, but no mean value theorem holds across
    it.
    """
    cosine, sine = (as_intervals(part, shape) for part in value)
    phi: Any = atan2(sine, cosine, side)
    if order_of(*vector):
        phi = argument(*change_along(*vector, *_at(*vector, shape))) + phi
    if order_of(*rest):
        phi = -argument(*rotation(rest[1], rest[0])) + phi
    return phi


def _at(dx: Number, dy: Number, shape: Shape) -> tuple[Intervals, Intervals, Intervals]:
    """Direction and length without their changes."""
    along, across = (as_intervals(constant(part), shape) for part in (dx, dy))
    return *unit_vector(along, across), length(along, across)


def as_intervals(value: Number, shape: Shape) -> Intervals:
    """A number, or intervals of some shape, as an array of intervals of that shape."""
    if isinstance(value, Intervals) and value.shape == shape:
        return value
    return stacked([value], shape)[0]


def filled(rows: Matrix, shape: Shape) -> FloatArray:
    """A matrix of numbers and arrays as an array, each entry of one shape."""
    found = np.empty((len(rows), len(rows[0]) if rows else 0, *shape))
    for i, row in enumerate(rows):
        for j, entry in enumerate(row):
            found[i, j] = entry
    return found
