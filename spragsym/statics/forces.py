"""The generated functions of a model by their names, with arguments of any number type."""

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any, Protocol, TypeAlias

import numpy as np

from ..models.field import undecorated
from ..numerics import jets
from ..numerics.interval_arrays import BoolArray, FloatArray, Intervals, Shape, atan2, length, stacked, unit_vector
from ..numerics.jets import Jet, argument, binomial_series, change, constant, turned
from .namespaces import XP

#: Arguments of generated functions by name, of any number type.
Values: TypeAlias = Mapping[str, Any]
#: Where an angle is searched that comes around after a turn: beyond π to either side, so that no state is near the border.
TURN = np.pi + 0.02
#: Of the cosine of an angle a width that is rounding.
ROUNDED = 1e-9


class Model(Protocol):
    """What is needed of a model: generated functions, and what its model page says."""

    about: Mapping[str, Any]

    @property
    def algebra(self) -> Any:
        """Generated functions of the balance of forces, and of small motions about it."""


class Forces:
    """Forces of a model in contact or in lift-off, and all else that is generated for it.

    Parameters of the search are those of the model, in its order; :meth:`prepared` turns them into the arguments of the
    generated functions, once for each node of the tree of points.
    """

    def __init__(self, model: Model, contact: bool, law: str = "friction_at_rest", room: float = 0.0) -> None:
        about = model.about
        #: How far beyond the contact's border states count, too: 0 but where those on it are looked for.
        self.room = room
        #: The generated function that gives μ; ``"friction_at_speed"`` is for a motion that has come to rest.
        self.law = law
        self.model, self.contact = model, contact
        self.coordinates: list[str] = [entry["name"] for entry in about["coordinates"]]
        self.parameters: list[str] = [entry["name"] for entry in about["parameters"]]
        self.angles: dict[str, Sequence[str]] = dict(about["angles"])
        #: Parameters on which the balance depends, and not the motion alone.
        self.balanced: list[str] = [entry["name"] for entry in about["parameters"] if entry["role"] == "both"]
        #: Parameters that may be 0.
        self.may_vanish = [
            entry["name"]
            for entry in about["parameters"]
            if entry["name"] not in self.angles and not (entry["low"] == 0 and entry["low_open"])
        ]
        #: Angles that the functions take by themselves too, beside their cosines and sines.
        self.alone = [name for name in self.angles if name in about["arguments"]["motion"]]
        self.codes = [
            code for name in self.parameters for code in (*self.angles.get(name, ()), *(() if self.only_turns(name) else (name,)))
        ]
        self.n = len(self.coordinates)
        self.springs = len(about["springs"])
        #: Of each torsion spring the number of the spring that it turns with.
        self.torsions: list[int] = [entry["spring"] for entry in about.get("torsions", ())]
        self.pushing = int(contact)
        #: −low and high of each coordinate: on which side of the border the contact's gap is, where that is a coordinate.
        self.border = np.full((2, self.n), np.inf)
        gap = about["contact"]["gap"]
        self.opens = bool(gap and about["contact"]["unilateral"])
        if self.opens and gap in self.coordinates:
            self.border[self.pushing, self.coordinates.index(gap)] = 0.0
        #: Numbers of coordinates that are angles after a turn of which all is as before: one turn of each is searched.
        self.around = [place for place, entry in enumerate(about["coordinates"]) if entry.get("comes_around")]
        self.border[:, self.around] = TURN
        #: Beyond them the forces are not asked for.
        self.limits = np.full((2, self.n), np.inf) if about["contact"].get("polynomial") else self.border.copy()
        self.border += room
        #: Sums of rows without forces between coordinates, where there are such: they vanish together with the forces, and what
        #: cancels in them is not lost in boxes.
        self.sums = {"forces": "balance", "forces_jacobian": "balance_jacobian"} if hasattr(model.algebra, "balance") else {}
        #: Whether the sign of the slope of the friction law can be told where that is too small for floats.
        self.slope_is_a_sum = hasattr(model.algebra, "friction_slope_by_sizes")

    # ------------------------------------------------------------------------------------------- arguments

    def prepared(self, bounds: Intervals) -> Intervals:
        """Arguments of the generated functions, shape (arguments, N), from parameters of shape (P, N)."""
        parts: list[Intervals] = []
        for place, name in enumerate(self.parameters):
            value = bounds[place]
            parts += [XP.cos(value), XP.sin(value)] if name in self.angles else []
            parts += [] if self.only_turns(name) else [value]
        return stacked(parts, bounds.shape[1:])

    def arguments_of(self, values: Values, xp: Any) -> dict[str, Any]:
        """Arguments by name, from parameters of any number type."""
        return self.with_angles(values, xp)

    def with_angles(self, values: Values, xp: Any) -> dict[str, Any]:
        """Some parameters with cosine and sine of those that are angles."""
        found = dict(values)
        for name, (cosine, sine) in self.angles.items():
            if name in values:
                found |= {cosine: xp.cos(values[name]), sine: xp.sin(values[name])}
        return found

    def floats(self, columns: Iterable[FloatArray]) -> dict[str, Any]:
        """Arguments as floats, shape (parameters, N)."""
        return self.arguments_of(dict(zip(self.parameters, columns, strict=True)), np)

    def only_turns(self, name: str) -> bool:
        """Whether a parameter is an angle of which the functions take cosine and sine, and not itself."""
        return name in self.angles and name not in self.alone

    def arguments(self, prepared: Intervals, changed: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """By name; ``changed`` are parameters that are unknowns, of any number type.

        A parameter that is 0 everywhere, and may be, is the number 0: products with it and exponentials of it are exact.
        """
        values: dict[str, Any] = {code: prepared[place] for place, code in enumerate(self.codes)}
        values |= {name: 0 for name in self.may_vanish if _is_nothing(values[name])}
        return values | self.with_angles(changed or {}, XP)

    def over(self, bounds: Intervals, changed: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """:meth:`arguments` from parameters of shape (P, N)."""
        with np.errstate(all="ignore"):
            return self.arguments(self.prepared(bounds), changed)

    def _listed(self, values: Values, kind: str) -> list[Any]:
        return [values[name] for name in self.model.about["arguments"][kind]]

    def _of(self, name: str, first: Iterable[Any], values: Values, *last: Any, kind: str = "motion", xp: Any) -> Any:
        """A generated function of coordinates, and directions perhaps, of arguments of a kind, and of what comes behind these."""
        return undecorated(getattr(self.model.algebra, name))(*first, *self._listed(values, kind), *last, xp=xp)

    # ---------------------------------------------------------------------------------------------- forces

    def geometry(self, q: Sequence[Any], values: Values, xp: Any = XP) -> Any:
        """Vector and undeformed length of every line."""
        return self._of("geometry", q, values, kind="statics", xp=xp)

    def of_no_place(self, name: str, values: Values, xp: Any = XP) -> Sequence[Any]:
        """A function that depends on parameters only: ``"stiffnesses"`` of springs, ``"torsions"`` of turning."""
        return self._of(name, [0] * self.n, values, kind="statics", xp=xp)

    def at_rest(self, values: Values, xp: Any = XP) -> list[tuple[Any, Any]]:
        """Cosine and sine of the direction in which each torsion spring rests: a line along x has turned by minus its angle."""
        pairs = self._of("turnings", [0] * self.n + [1, 0, 1] * self.springs, values, kind="statics", xp=xp)
        return [(cosine, -sine) for cosine, sine in pairs]

    def directions(
        self,
        q: Sequence[Any],
        values: Values,
        shape: Shape,
        upright: Sequence[int] = (),
        sides: Sequence[int] | None = None,
    ) -> list[Any]:
        """Cosine, sine and length of every spring, then the turning of every torsion spring; dx = 0 where ``upright``.

        ``sides`` tell for each torsion spring what its turning is in boxes that meet the ray where it jumps: NaN without it, with
        1 or −1 that on one side of the ray, with 0 anything from −π to π.
        """
        steps = [(0 if place in upright else dx, dy) for place, (dx, dy, _) in enumerate(self.geometry(q, values))]
        squares = self._squared_lengths(q, values)
        parts = [part for (dx, dy), square in zip(steps, squares, strict=True) for part in direction(dx, dy, shape, square)]
        return parts + self._turnings(q, values, shape, steps, parts, sides) if self.torsions else parts

    def _squared_lengths(self, q: Sequence[Any], values: Values) -> Sequence[Any]:
        """l² of every spring without its changes, where an angle is so wide that its form counts; else None."""
        if not any(_is_wide(values[code]) for parts in self.angles.values() for code in parts):
            return [None] * self.springs
        fixed = [jets.constant(part) for part in (*q, *self._listed(values, "statics"))]
        return undecorated(self.model.algebra.squared_lengths)(*fixed, xp=XP)

    def _turnings(
        self,
        q: Sequence[Any],
        values: Values,
        shape: Shape,
        steps: Sequence[tuple[Any, Any]],
        directions: Sequence[Any],
        sides: Sequence[int] | None,
    ) -> list[Any]:
        """φ of every torsion spring; 0 where its stiffness is."""
        fixed = [jets.constant(part) for part in (*q, *directions, *self._listed(values, "statics"))]
        turned = undecorated(self.model.algebra.turnings)(*fixed, xp=XP)
        rests, stiffnesses = self.at_rest(values), self.of_no_place("torsions", values)
        found = []
        for place, value in enumerate(turned):
            if _is_none(stiffnesses[place]):
                found.append(Intervals(np.zeros((2, *shape))))
                continue
            side = None if sides is None else sides[place]
            found.append(turning(value, steps[self.torsions[place]], rests[place], shape, side))
        return found

    def plain_directions(
        self, q: Sequence[Any], values: Values, xp: Any, turnings: Sequence[Any] = ()
    ) -> list[Any]:  # fmt: skip
        """Cosine, sine and length of every spring, then turnings if not given, for numbers that are narrow: quotients."""
        directions = [part for dx, dy, _ in self.geometry(q, values, xp) for part in quotients(dx, dy, xp)]
        if len(turnings) == len(self.torsions):
            return [*directions, *turnings]
        pairs = self._of("turnings", [*q, *directions], values, kind="statics", xp=xp)
        return directions + [xp.atan2(sine, cosine) for cosine, sine in pairs]

    def call(self, name: str, q: Sequence[Any], directions: Sequence[Any], values: Values, xp: Any = XP) -> Any:
        """A function that has the arguments of ``forces``; of ``forces`` and their slopes :attr:`sums`."""
        return self.by_coordinate(self.sums.get(name, name), q, directions, values, xp)

    def by_coordinate(
        self,
        name: str,
        q: Sequence[Any],
        directions: Sequence[Any],
        values: Values,
        xp: Any = XP,
        pushing: Any = None,
    ) -> Any:
        """Rows by coordinate; with ``pushing`` 0 as in lift-off."""
        pushing = self.pushing if pushing is None else pushing
        return self._of(name, [*q, *directions], values, self.friction(values, xp), pushing, kind="statics", xp=xp)

    def contact_force(self, q: Sequence[Any], values: Values, pushing: Any, xp: Any = XP) -> Any:
        """The normal force of the contact."""
        return self._of("contact_force", q, values, pushing, xp=xp)

    def by_parameters(
        self, names: Sequence[str], q: Sequence[Any], directions: Sequence[Any], values: Values, xp: Any = XP
    ) -> list[list[Any]]:
        """Derivatives of the forces along each coordinate by parameters, through the friction law too; an angle as the angle."""
        law = self._of("friction_by_parameters", (), values, xp=xp)
        own = self.model.about["by_parameters"]
        return [
            [(row[own.index(name)] if name in own else 0) + row[-1] * law[self.parameters.index(name)] for name in names]
            for row in self.by_coordinate("forces_by_parameters", q, directions, values, xp)
        ]

    def friction(self, values: Values, xp: Any = XP) -> Any:
        """The friction coefficient at steady sliding."""
        return self._of(self.law, (), values, xp=xp)

    def mass(self, q: Sequence[Any], values: Values, xp: Any = XP) -> Any:
        """M of the kinetic energy."""
        return self._of("mass_matrix", q, values, xp=xp)

    def damping(
        self, q: Sequence[Any], directions: Sequence[Any], values: Values, pushing: int | None = None, xp: Any = XP
    ) -> Any:
        """C of dampers and of the slope of the friction law."""
        pushing = self.pushing if pushing is None else pushing
        return self._of("damping", [*q, *directions[: 3 * self.springs]], values, pushing, xp=xp)

    def slope(self, values: Values, xp: Any = XP) -> Any:
        """Slope of the friction law at steady sliding."""
        return self._of("friction_slope", (), values, xp=xp)

    def slope_has_a_sign(self, values: Values, shape: Shape) -> BoolArray:
        """Whether the slope is shown not to be 0, over one of its exponentials: also where that is too small for floats."""
        out = np.zeros(shape, dtype=np.bool_)
        if not self.slope_is_a_sum:
            return out
        for terms in self._of("friction_slope_by_sizes", (), values, xp=XP):
            kept = [(factor, power) for factor, power in terms if stacked([factor], shape)[0].ends.any()]
            total = sum((factor * XP.exp(power) for factor, power in kept), Intervals.point(np.zeros(shape)))
            out |= ~total.holds_zero()
        return out

    def gap(self, q: Sequence[Any], values: Values, xp: Any = XP) -> Any:
        """The gap of the contact."""
        return self._of("contact_gap", q, values, kind="statics", xp=xp)

    def mirrored(self, q: Sequence[Any], values: Values) -> Sequence[Any]:
        """The image of a state in the model's mirror."""
        return self._of("mirror", q, values, kind="statics", xp=XP)


def _is_nothing(values: Intervals) -> bool:
    return values.ends.size > 0 and not values.ends.any()


def _is_wide(part: Any) -> bool:
    """Whether an argument, or what it is without its changes, is wider than by rounding."""
    value = jets.constant(part)
    return isinstance(value, Intervals) and bool(((value.ends[0] + value.ends[1]) > ROUNDED).any())


def _is_none(stiffness: Any) -> bool:
    """0 everywhere, and no unknown."""
    return not stiffness if isinstance(stiffness, int) else isinstance(stiffness, Intervals) and _is_nothing(stiffness)


def quotients(dx: Any, dy: Any, xp: Any) -> tuple[Any, Any, Any]:
    """Cosine, sine and length of the vector (dx, dy), of numbers that are narrow."""
    length = xp.sqrt(dx**2 + dy**2)
    return dx / length, dy / length, length


def direction(dx: Any, dy: Any, shape: Shape, square: Any = None) -> tuple[Any, Any, Any]:
    """Cosine, sine and length of the vector (dx, dy): arrays of intervals of that shape, or jets of them.

    ``square`` is the squared length without its changes, where another form of it is known that may be narrower. With the turned
    and scaled change u + i v of the vector, (c + i s) (1 + u + i v) l is the vector. So all derivatives come from the sharp
    enclosures of c, s and l, not from quotients of intervals.
    """
    c, s, L = _at(dx, dy, shape)
    if square is not None:
        L = Intervals(np.fmin(L.ends, as_intervals(square, shape).sqrt().ends))
    order = max((part.order for part in (dx, dy) if isinstance(part, Jet)), default=0)
    if not order:
        return c, s, L
    u, v = _turn(dx, dy, c, s, L, order)
    w = u * 2 + u**2 + v**2
    root, inverse = (Jet(w.terms, order).composed(binomial_series(Fraction(way, 2), order)) for way in (1, -1))
    cosine, sine = (u + 1) * inverse, v * inverse
    return cosine * c - sine * s, cosine * s + sine * c, root * L


def turning(value: tuple[Any, Any], vector: tuple[Any, Any], rest: tuple[Any, Any], shape: Shape, side: int | None) -> Any:
    """The turning φ of a spring in [−π, π], an array of intervals or a jet of them; NaN where boxes meet the ray φ = ±π.

    ``value`` holds cosine and sine of φ without their changes, ``rest`` those of the inclination at rest; ``side`` says what is
    given on the ray instead, see :func:`spragsym.numerics.interval_arrays.atan2`. Its derivatives are those of the spring's
    angle less those of the angle at rest: algebra in sharp enclosures of direction and length. They hold at every point off the
    ray, and so on either side of it, but no mean value theorem holds across it.
    """
    cosine, sine = (as_intervals(part, shape) for part in value)
    phi = atan2(sine, cosine, side)
    order = max((part.order for part in (*vector, *rest) if isinstance(part, Jet)), default=0)
    if not order:
        return phi
    moved: Any = phi
    if any(isinstance(part, Jet) for part in vector):
        moved = argument(*_turn(*vector, *_at(*vector, shape), order)) + moved
    if any(isinstance(part, Jet) for part in rest):
        moved = -argument(*turned(rest[1], rest[0])) + moved
    return moved


def _at(dx: Any, dy: Any, shape: Shape) -> tuple[Intervals, Intervals, Intervals]:
    """Direction and length without their changes."""
    along, across = (as_intervals(constant(part), shape) for part in (dx, dy))
    return *unit_vector(along, across), length(along, across)


def _turn(dx: Any, dy: Any, c: Intervals, s: Intervals, L: Intervals, order: int) -> tuple[Jet, Jet]:
    """The turned and scaled change of the vector."""
    hx, hy = (change(part, order) for part in (dx, dy))
    return (hx * c + hy * s) / L, (hy * c - hx * s) / L


def as_intervals(value: Any, shape: Shape) -> Intervals:
    return stacked([value], shape)[0]
