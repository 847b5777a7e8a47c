"""A page from SymPy's mechanics: the energies and loads of a LagrangesMethod, KanesMethod or System
as statements of a page.
"""

from __future__ import annotations

import functools
import itertools
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, TypeAlias

import sympy as sp
from sympy import Add, Dummy, Expr, Matrix, S, expand

from . import units
from .algebra import quotients
from .limits import Limit
from .page_errors import refused

if TYPE_CHECKING:
    from sympy.physics.mechanics import KanesMethod, LagrangesMethod, System

    from .model import Page

#: SymPy's classes for the mechanics of a system.
Method: TypeAlias = "LagrangesMethod | KanesMethod | System"


def page_from(
    method: Method,
    page: Page,
    coordinates: Mapping[Expr, tuple[str, str]],
    contact: tuple[Any, ...] | Mapping[str, Any] | None = None,
    friction: tuple[Any, ...] | Mapping[str, Any] | None = None,
) -> Page:
    """Add to a page the statements for a system of SymPy's mechanics.

    A symbol of the system with the name of a quantity of the page is that quantity.

    Parameters
    ----------
    method : LagrangesMethod, KanesMethod or System
        Without constraints; a System whose equations are formed. Of Kane's the bodies have the
        kinetic energy, and all forces are loads or, in a System, those of springs and dampers
        among its actuators.
    page : Page
        With its units and parameters.
    coordinates : mapping
        Unit and meaning of each coordinate of the method: ``{x: ("m", "displacement along the
        belt")}``.
    contact : tuple or mapping, optional
        The symbol that stands for the normal force in the method, the gap in its coordinates, and
        the law; by name ``normal``, ``gap``, ``law`` and ``unilateral`` as ``page.contact`` has
        them, or ``normal`` and ``force``, a given normal force.
    friction : tuple or mapping, optional
        The symbol that stands for the friction coefficient, the displacement that friction opposes,
        the belt's speed, the law, and what statics takes for it, if not the law at that speed; by
        name ``coefficient``, ``along``, ``belt`` and as ``page.friction`` has them ``law`` and
        ``at_rest``, or ``slip`` and ``holds``, dry friction. Where the loads have the law, as those
        of CoulombKineticFriction with the symbol of the normal force, ``belt`` and ``holds`` are
        left: the speed of what the loads take for the ground, and what is held, if not the law at
        speed 0.

    Returns
    -------
    Page
        The same page.

    Raises
    ------
    PageError
        If the system has something that a page can't state, which the text names: a constraint, a
        gyroscopic force, a force that varies in time, or one that is no spring, damper, contact or
        friction.
    """
    if hasattr(method, "eom_method"):
        if method.eom_method is None:
            raise refused("the System has no equations yet; call its form_eoms() before page_from")
        method = method.eom_method
    reader = _MethodReader(method, page, coordinates)
    page.kinetic(reader.kinetic)
    of_contact = ("normal", "gap", "law", "unilateral", "force")
    of_friction = ("coefficient", "along", "belt", "law", "at_rest", "slip", "holds")
    forces = reader.split(
        reader.named("contact", contact, of_contact),
        reader.named("friction", friction, of_friction),
    )
    at_rest = dict.fromkeys(reader.rates, 0)
    reader.dampers((forces - forces.subs(at_rest)).applyfunc(reader.expanded))
    reader.springs(
        (forces.subs(at_rest) - reader.gradient(reader.stored)).applyfunc(reader.expanded)
    )
    return page


class _MethodReader:
    """Energies and loads of a method, written in a page's symbols."""

    def __init__(
        self, method: Method, page: Page, coordinates: Mapping[Expr, tuple[str, str]]
    ) -> None:
        from sympy.physics.vector import dynamicsymbols

        self.page = page
        self.loads = [*(method.loads or ())]
        self.time = dynamicsymbols._t
        kane = hasattr(method, "kindiffdict")
        if any(map(len, (method._qdep, method._udep) if kane else (method.coneqs,))):
            raise refused(
                "the method has constraints; eliminate them, so that its coordinates are "
                "independent"
            )
        if set(coordinates) != set(method.q):
            raise refused(
                f"the coordinates are {', '.join(map(str, method.q))}; give unit and meaning "
                "of each of these"
            )
        self.places = [page.coordinate(q.func.__name__, *coordinates[q]) for q in method.q]
        self.rates = [page.rate(coordinate) for coordinate in self.places]
        by_speeds = [rate - value for rate, value in method.kindiffdict().items()] if kane else []
        self.names = [
            sp.solve(by_speeds, [*method.u], dict=True)[0] if kane else {},
            {q.diff(self.time): rate for q, rate in zip(method.q, self.rates, strict=True)},
            dict(zip(method.q, self.places, strict=True)),
        ]
        self.frame = method._inertial if kane else method.inertial
        if self.frame is None and self.loads:
            raise refused(
                "the LagrangesMethod was made without the frame in which its loads act; "
                "give it that, as LagrangesMethod(L, [x, y], forcelist=loads, frame=frame)"
            )
        whole = self.plain(
            sum(body.kinetic_energy(self.frame) for body in method.bodies) if kane else method._L[0]
        )
        still = dict.fromkeys(self.rates, 0)
        self.stored = -whole.subs(still)
        self.kinetic = expand(whole + self.stored)

    def plain(self, expression: Expr) -> Expr:
        """An expression in the page's symbols, of which time is none: what a turning frame brings
        in has to cancel.
        """
        value = self.read(expression)
        if value.has(self.time):
            value = sp.trigsimp(expand(value))
        if value.has(self.time):
            raise refused(f"{value} varies in time by itself: {Limit.FORCING}")
        return value

    def read(self, expression: Expr) -> Expr:
        """An expression in the page's symbols, and time."""
        value = sp.sympify(expression)
        entries = (*self.page.units, *self.page.parameters)
        ours = {str(entry.symbol): entry.symbol for entry in entries}
        value = value.xreplace({one: ours.get(one.name, one) for one in value.atoms(sp.Symbol)})
        for names in self.names:
            value = value.subs(names)
        return value

    def gradient(self, expression: Expr) -> Matrix:
        """Derivatives by the coordinates, as a column."""
        return Matrix([expression]).jacobian(self.places).T

    def named(
        self, what: str, given: tuple[Any, ...] | Mapping[str, Any] | None, names: tuple[str, ...]
    ) -> dict[str, Any]:
        """The arguments of a contact or friction by name, in the page's symbols.

        Raises
        ------
        PageError
            If one is unknown or missing.
        """
        said = dict(given if isinstance(given, Mapping) else zip(names, given or (), strict=False))
        needed = {"contact": ("normal",), "friction": ("coefficient", "along", "belt")}[what]
        # The law itself may be in the loads, as of CoulombKineticFriction.
        if what == "friction" and said.keys() <= {"belt", "holds"}:
            needed = ()
        if said and (wrong := [*(said.keys() - {*names}), *({*needed} - said.keys())]):
            raise refused(
                f"{what}= has {', '.join(map(str, said))}, and {', '.join(map(str, wrong))} is "
                f"unknown or missing; its names are {', '.join(names)}"
            )
        return {name: self.of_page(value) for name, value in said.items()}

    def of_page(self, value: object) -> Any:
        """An expression, or the values of a law, in the page's symbols; anything else as it is."""
        if isinstance(value, sp.Basic):
            return self.plain(value)
        if not callable(value):
            return value

        @functools.wraps(value)
        def law(*given: object) -> object:
            return self.of_page(value(*given))

        return law

    def split(self, contact: dict[str, Any], friction: dict[str, Any]) -> Matrix:
        """State contact and friction, and return the generalized forces of all other loads."""
        if friction and not contact:
            raise refused(
                "there is friction and no normal force; give contact=(N, gap, law), or a given "
                'one as contact={"normal": N, "force": F_L}'
            )
        forces = sp.zeros(len(self.places), 1)
        for point, vector in self.loads:
            velocity = (
                point.vel(self.frame) if hasattr(point, "vel") else point.ang_vel_in(self.frame)
            )
            velocities, components = (
                part.to_matrix(self.frame).applyfunc(self.read) for part in (velocity, vector)
            )
            forces += velocities.jacobian(self.rates).T * components
        normal = contact.pop("normal", None)
        forces = forces.applyfunc(self.plain).applyfunc(self.on_both_sides)
        if any(one.has(*self.rates) for one in forces.atoms(sp.sign)):
            forces, friction = self.dry(forces, normal, friction)
        coefficient = friction.pop("coefficient", 0)
        if "force" in contact:
            self.page.normal_force(**contact)
        elif contact:
            self.page.contact(**contact)
            forces -= normal * self.gradient(contact["gap"])
        if friction:
            self.page.friction(**friction)
            forces -= normal * coefficient * self.gradient(friction["along"])
        forces = forces.applyfunc(self.expanded)
        allowed = {
            *self.places,
            *self.rates,
            *(entry.symbol for entry in (*self.page.units, *self.page.parameters)),
        }
        for coordinate, force in zip(self.places, forces, strict=True):
            if unknown := sorted(map(str, force.free_symbols - allowed)):
                raise refused(
                    f"the force along {coordinate} holds {', '.join(unknown)} beside contact and "
                    "friction, which act along the slope of the "
                    "gap and of the displacement; give contact=(N, gap, law) and "
                    "friction=(mu, along, belt, law) as the loads have them"
                )
        return forces

    def on_both_sides(self, force: Expr) -> Expr:
        """A force without signs and absolute values of coordinates, if its expressions for either
        sign agree, as along a pathway of length |x|.
        """
        for coordinate in self.places:
            if any(one.has(coordinate) for one in force.atoms(sp.sign, sp.Abs)):
                far = Dummy(positive=True)
                one, other = (
                    force.subs(coordinate, side * far).subs(far, side * coordinate)
                    for side in (1, -1)
                )
                force = one if self.expanded(one - other) == 0 else force
        return force

    def dry(
        self, forces: Matrix, normal: Expr, friction: dict[str, Any]
    ) -> tuple[Matrix, dict[str, Any]]:
        """Split the loads into those without friction, and the arguments of its statement.

        Friction in loads is a law of a speed r times N times sign(r), along r, which is a sum of
        rates minus the speed of the belt.
        """
        jumps = sorted(forces.atoms(sp.sign), key=sp.default_sort_key)
        r, side, speed = expand(jumps[0].args[0]), Dummy(), Dummy(real=True)
        belt = -r.subs(dict.fromkeys(self.rates, 0))
        if belt.could_extract_minus_sign():
            r, belt = -r, -belt
        slopes = Matrix([r]).jacobian(self.rates).T
        row = next(row for row, slope in enumerate(slopes) if slope != 0)
        signs = {one: side * sp.cancel(one.args[0] / r) for one in jumps}
        by_side = forces.xreplace(signs).applyfunc(expand)
        friction_force = by_side.applyfunc(lambda force: force.coeff(side))
        rate = self.rates[row] + (speed - r) / slopes[row]
        law_times_normal = expand(-friction_force[row].subs(self.rates[row], rate) / slopes[row])
        law = S.Zero if normal is None else law_times_normal.coeff(normal)
        law = sp.collect(law, sorted(law.atoms(sp.exp), key=sp.default_sort_key))
        zeros = [
            law - law.subs(speed, -speed),
            *(friction_force * slopes[row] - slopes * friction_force[row]),
        ]
        is_read = (
            law != 0
            and law_times_normal == expand(law * normal)
            and {*signs.values()} <= {side, -side}
            and not sp.Tuple(law, *slopes).has(*self.rates, *self.places)
            and all(self.expanded(one) == 0 for one in zeros)
        )
        if not is_read or not friction.keys() <= {"belt", "holds"}:
            advice = (
                "of loads with a sign, as those of CoulombKineticFriction, all friction is read; "
                'let their normal force be a symbol N, and give contact={"normal": N, "force": W} '
                'and friction={"belt": V}'
            )
            raise refused(f"the loads hold {jumps[0]}: {advice}")
        return by_side.subs(side, 0), {
            "along": sum(
                slope * coordinate for slope, coordinate in zip(slopes, self.places, strict=True)
            ),
            "belt": belt,
            "slip": lambda v: law.subs(speed, v) * sp.sign(v),
            "holds": law.subs(speed, 0),
            **friction,
        }

    def bases(self, expression: Expr) -> set[Expr]:
        """Bases of roots and denominators that depend on coordinates."""
        return {node.base for node in quotients(expression) if node.base.has(*self.places)}

    def expanded(self, expression: Expr) -> Expr:
        """An expression multiplied out, except for roots and denominators of coordinates."""
        placeholders = {base: Dummy(positive=True) for base in self.bases(expression)}
        with_placeholders = expression.replace(
            lambda it: isinstance(it, sp.Pow) and it.base in placeholders,
            lambda it: placeholders[it.base] ** it.exp,
        )
        return expand(with_placeholders).xreplace(
            {dummy: base for base, dummy in placeholders.items()}
        )

    def lines(self, forces: Matrix) -> Iterator[tuple[Expr, Matrix, int, tuple[Any, Any]]]:
        """The lines whose lengths are in the forces: l², half its gradient, the index of a
        coordinate that changes it, and the ends.
        """
        for base in sorted(
            {base for force in forces for base in self.bases(force)}, key=sp.default_sort_key
        ):
            parts = [part.base for part in Add.make_args(base) if part.is_Pow and part.exp == 2]
            if len(parts) != 2 or expand(sum(part**2 for part in parts) - base) != 0:
                raise refused(
                    f"the root of {base} is no length between two points; write it as "
                    "sqrt(dx**2 + dy**2)"
                )
            # The part along the first coordinate comes first; both parts point from the mass to the
            # anchor, so that they decrease with the coordinates.
            parts.sort(
                key=lambda part: next(
                    (row for row, coordinate in enumerate(self.places) if part.has(coordinate)),
                    len(self.places),
                )
            )
            ends = []
            for part in parts:
                slopes = {
                    sp.diff(part, coordinate): coordinate for coordinate in reversed(self.places)
                }
                falling = part if -1 in slopes or 1 not in slopes else -part
                start = slopes.get(-1, slopes.get(1, S.Zero))
                ends.append((start, expand(falling + start)))
            half = (self.gradient(base) / 2).applyfunc(expand)
            row = next(row for row, slope in enumerate(half) if slope != 0)
            yield base, half, row, tuple(zip(*ends, strict=True))

    def dampers(self, forces: Matrix) -> None:
        """State dampers for forces linear in the rates, given as a column."""
        C = -forces.jacobian(self.rates).applyfunc(self.expanded)
        if C.has(*self.rates):
            raise refused(
                f"{', '.join(str(one) for one in forces if one != 0)} is no damper of a page: "
                f"{Limit.NONLINEAR_DAMPER}"
            )
        if not (C - C.T).applyfunc(self.expanded).is_zero_matrix:
            raise refused(
                f"the forces {', '.join(map(str, forces))} are no dampers; if they are gyroscopic, "
                "let the kinetic energy have them, as m*((x′ − W*y)**2 + (y′ + W*x)**2)/2 in a "
                "frame that turns at W"
            )
        for base, half, row, ends in self.lines(C):
            square = Add(*(term for term in Add.make_args(C[row, row]) if base in self.bases(term)))
            coefficient = sp.simplify(square * base / half[row] ** 2)
            self.page.damper(coefficient, *ends)
            C = (C - coefficient / base * half * half.T).applyfunc(self.expanded)
        for i, j in itertools.combinations(range(len(self.places)), 2):
            if C[i, j] != 0:
                self.page.damper(-C[i, j], along=self.places[i] - self.places[j])
        for row, index in enumerate(self.places):  # what is left of the diagonal
            if (coefficient := expand(sum(C.row(row)))) != 0:
                self.page.damper(coefficient, along=index)

    def springs(self, forces: Matrix) -> None:
        """State springs, potentials and applied forces for the forces at rest, given as a
        column.
        """
        for base, half, row, ends in self.lines(forces):
            product = sp.simplify(
                forces[row].subs(1 / sp.sqrt(base), length := Dummy()).coeff(length) / half[row]
            )
            remainders = {
                stiffness: (forces + (stiffness - product / sp.sqrt(base)) * half).applyfunc(
                    self.expanded
                )
                for stiffness in self.stiffnesses(product)
            }
            if not remainders or any(
                base in self.bases(force) for force in next(iter(remainders.values()))
            ):
                raise refused(
                    f"the force {forces[row]} depends on {sp.sqrt(base)}, and is no k (l - "
                    "r): it is no spring of a page"
                )
            # Of the factors of k r, as k_2 λ_2 L_0, the stiffness is the one that leaves the fewest
            # terms.
            stiffness = min(
                remainders,
                key=lambda one: sum(len(Add.make_args(force)) for force in remainders[one]),
            )
            self.page.spring(stiffness, *ends, length=product / stiffness)
            forces = remainders[stiffness]
        potential = S.Zero
        for coordinate, force in zip(self.places, forces, strict=True):
            potential -= expand(
                sp.integrate(expand(force + sp.diff(potential, coordinate)), coordinate)
            )
        for coordinate, force in zip(
            self.places, (forces + self.gradient(potential)).applyfunc(expand), strict=True
        ):
            pull, square = (potential.coeff(coordinate, power) for power in (1, 2))
            pull, square = (S.Zero if part.has(*self.places) else part for part in (pull, square))
            if force != pull:
                self.page.force(force - pull, along=coordinate)
            if square != 0:
                self.page.spring(2 * square, along=coordinate)
            potential -= pull * coordinate + expand(square * coordinate**2)
        if potential != 0:
            self.page.potential(potential)

    def stiffnesses(self, product: Expr) -> Iterator[Expr]:
        """Products of factors of k r, stiffness times undeformed length, with the unit of a
        stiffness.
        """
        dimensions = {
            it.symbol: units.read(it.unit) for it in (*self.page.units, *self.page.parameters)
        }
        factors = sp.Mul.make_args(product) if product.free_symbols <= dimensions.keys() else ()
        for size in range(1, len(factors)):
            for part in map(sp.prod, itertools.combinations(factors, size)):
                if units.of(part, dimensions) == units.read("N/m"):
                    yield part
