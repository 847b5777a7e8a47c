"""Motion of any model: accelerations in each regime in which they are smooth, their derivatives,
borders, energy and powers.
"""

from dataclasses import dataclass
from functools import cached_property, partial

import sympy as sp

from . import laws
from .algebra import Names, Row, Symbols, difference, expanded, reached
from .emit.function import Function, Module, Results, of_page
from .mechanics import MU, PUSHING, SIDE, Mechanics, NormalForce, elastic, number, waves
from .model import acceleration_of

#: 1 while friction holds the mass to the belt, 0 while it slips; the force of a friction that
#: holds.
STUCK, FRICTION = sp.symbols("_stuck _friction", real=True)


@dataclass(frozen=True)
class Motion:
    """The equations of motion M q″ = forces, solved for q″."""

    model: Mechanics

    @cached_property
    def friction(self) -> sp.Expr:
        """μ on either SIDE."""
        return laws.smooth_friction(self.model.friction)

    @cached_property
    def along(self) -> Row:
        """Derivatives of the displacement that friction opposes."""
        return tuple(
            sp.diff(self.model.friction.along, symbol) for symbol in self.model.coordinates
        )

    @cached_property
    def mobility(self) -> sp.Expr:
        """Jᵀ M⁻¹ J of the displacement that friction opposes: by how much a unit of friction slows
        the sliding.
        """
        return sum(
            (a * b for a, b in zip(self.along, self.accelerated(self.along), strict=True)),
            sp.S.Zero,
        )

    @cached_property
    def holding(self) -> sp.Expr:
        """The force that keeps the sliding speed from changing: the constraint force of
        sticking.
        """
        return self.rate(self.borders[1], self.accelerations).subs(FRICTION, 0) / self.mobility

    @cached_property
    def dry_friction(self) -> Names:
        """What STUCK and FRICTION are; nothing of a friction that does not hold.

        Sticking or not, the force is a sum and no coefficient times a normal force that goes to 0
        where the contact is lost.
        """
        if not self.model.holds:
            return {}
        force = (1 - STUCK) * MU * self.model.contact.rubbing + STUCK * self.holding
        return {**self.inverted, STUCK: 1 - SIDE**2, MU: self.friction, FRICTION: force}

    def margins(self, force: sp.Expr) -> Row:
        """How far a force of friction is from its limit with the belt, and from that against it:
        positive while friction holds.
        """
        ahead, behind = (
            coefficient * self.model.contact.rubbing
            for coefficient in laws.static_coefficients(self.model.friction)
        )
        return ahead - force, behind + force

    @cached_property
    def side(self) -> sp.Expr:
        """The sign of the sliding speed; where nothing slides 1, or of a friction that holds
        that of the mode in which the motion goes on.
        """
        if not self.model.holds:
            return reached(self.borders[1])
        sliding = sp.sign(self.borders[1])
        within_ahead, within_behind = map(reached, self.margins(self.holding))
        return sliding + (1 - sliding**2) * (within_behind - within_ahead) / 2

    @cached_property
    def centrifugal(self) -> Row:
        """The terms of Lagrange's equations besides M q″ where the mass matrix depends on the
        place: d(∂T/∂v)/dt − ∂T/∂q at q″ = 0.
        """
        it = self.model
        momenta = [sp.diff(it.kinetic, rate) for rate in it.rates]
        return tuple(
            expanded(it.page.rate(momentum) - sp.diff(it.kinetic, symbol))
            for momentum, symbol in zip(momenta, it.coordinates, strict=True)
        )

    @cached_property
    def pull(self) -> Row:
        """The right side of M q″ = …, in MU, PUSHING, directions and rates."""
        it = self.model
        rows = zip(it.residuals, it.resistance, self.centrifugal, strict=True)
        return tuple(-static - damped - turned for static, damped, turned in rows)

    def balance(self, contact: sp.Expr) -> Row:
        """M q″ less all forces, of which the contact's is ``contact``, in MU and the symbols of the
        accelerations.
        """
        it = self.model
        rows = []
        for symbol, inertia, pull in zip(
            it.coordinates, it.mass * sp.Matrix(self.named), self.pull, strict=True
        ):
            share = sp.S.Zero if it.contact.gap is None else sp.diff(it.contact.gap, symbol)
            if it.friction.along is not None:
                share += MU * sp.diff(it.friction.along, symbol)
            rows.append(expanded(inertia - pull + (it.contact.force - contact) * share))
        return tuple(rows)

    @cached_property
    def accelerations(self) -> Row:
        """q″ in MU, or in the FRICTION that holds, and in the entries of the inverse of M where
        these are no quotients of parameters.
        """
        return self.accelerated(self.forces)

    @cached_property
    def forces(self) -> Row:
        """M q″, in MU or in the FRICTION that holds."""
        if not self.model.holds:
            return self.pull
        return tuple(
            row.subs(MU, 0) + FRICTION * share
            for row, share in zip(self.pull, self.along, strict=True)
        )

    def accelerated(self, forces: Row) -> Row:
        """M⁻¹ times forces."""
        if not self.is_coupled:
            return tuple(row / self.model.mass[i, i] for i, row in enumerate(forces))
        return tuple(self.inverse * sp.Matrix(forces))

    @cached_property
    def is_coupled(self) -> bool:
        """Whether M has entries beside its diagonal, or depends on the place."""
        it = self.model
        return not it.mass.is_diagonal() or it.mass.has(*it.coordinates)

    @cached_property
    def inverse(self) -> sp.Matrix:
        """Symbols of the entries of the inverse of M."""
        n = len(self.model.coordinates)
        return sp.Matrix(
            n, n, lambda i, j: sp.Symbol(f"_inverse_{min(i, j) + 1}{max(i, j) + 1}", real=True)
        )

    @cached_property
    def named(self) -> Symbols:
        """Symbols of the accelerations."""
        return tuple(
            sp.Symbol(acceleration_of(symbol), real=True) for symbol in self.model.coordinates
        )

    @cached_property
    def solved(self) -> Names:
        """The accelerations by their symbols, where derivatives take them."""
        named = dict(zip(self.named, self.accelerations, strict=True))
        return {**self.inverted, **named} if self.is_coupled or self.model.holds else {}

    @cached_property
    def inverted(self) -> Names:
        """What the entries of the inverse of M are: M is inverted in numbers once, and never
        differentiated.
        """
        if not self.is_coupled:
            return {}
        determinant = sp.Symbol("_determinant", positive=True)
        M, tidy = self.model.mass, self.model.tidy
        entries = zip(self.inverse, M.adjugate(), strict=True)
        return {
            determinant: tidy(M.det(method="berkowitz")),
            **{symbol: tidy(entry) / determinant for symbol, entry in entries},
        }

    def slopes(self, symbol: sp.Symbol, turn: sp.Expr | None = None) -> Row:
        """Derivatives of the accelerations by a coordinate, a rate or a parameter: M ∂q″ = ∂forces
        − ∂M q″; ``turn`` is friction's.
        """
        turn = self.friction_slope(symbol) if turn is None else turn
        if not self.is_coupled:
            return tuple(self.derivative(row, symbol, turn) for row in self.accelerations)
        it = self.model
        changes = it.mass.applyfunc(
            lambda entry: it.tidy(it.derivative(entry, symbol))
        ) * sp.Matrix(self.named)
        pulls = sp.Matrix([self.derivative(row, symbol, turn) for row in self.forces])
        return tuple(self.inverse * (pulls - changes))

    def friction_slope(self, symbol: sp.Symbol) -> sp.Expr:
        """The derivative of μ; or that of a force that holds, which keeps the sliding speed from
        changing.
        """
        if not self.model.holds:
            return self.model.derivative(self.friction, symbol)
        slipping = self.model.derivative(self.friction * self.model.contact.rubbing, symbol)
        changes = zip(self.along, self.slopes(symbol, sp.S.Zero), strict=True)
        change = self.model.derivative(self.rate(self.borders[1], self.named), symbol) - sum(
            a * b for a, b in changes
        )
        return (1 - STUCK) * slipping + STUCK * change / self.mobility

    def derivative(self, expression: sp.Expr, symbol: sp.Symbol, turn: sp.Expr) -> sp.Expr:
        """By a coordinate, a rate or a parameter, with ``turn`` for that of MU, or of FRICTION."""
        it = self.model
        return it.tidy(
            it.derivative(expression, symbol)
            + sp.diff(expression, FRICTION if self.model.holds else MU) * turn
        )

    # ---------------------------------------------------------------------------------------------
    # energy

    @cached_property
    def stored(self) -> sp.Expr:
        """Kinetic and stored energy, with the work of the applied forces and, where it pushes, the
        contact's.
        """
        springs = zip(self.model.lines, self.model.stiffnesses, strict=True)
        return self._apart + sum(
            (elastic(line, k) + k * line.rest**2 / 2 for line, k in springs), sp.S.Zero
        )

    @cached_property
    def energy(self) -> sp.Expr:
        """The same with the springs' as k (l − r)²/2, which loses no digits where they are hardly
        deformed: l² is dx² + dy².
        """
        springs = zip(self.model.lines, self.model.stiffnesses, strict=True)
        return self._apart + sum(
            (k * (line.l - line.rest) ** 2 / 2 for line, k in springs), sp.S.Zero
        )

    @cached_property
    def strain_energy(self) -> sp.Expr:
        """Energy of springs, torsion springs, contact and the page's potentials, without the
        applied forces.
        """
        return self.energy - self.model.kinetic + self.work

    @cached_property
    def _apart(self) -> sp.Expr:
        """Without the springs along lines."""
        it = self.model
        contacts = sum((self._stored_in(contact) for contact in it.contacts), sp.S.Zero)
        springs = (elastic(line, k) for line, k in zip(it.lines, it.stiffnesses, strict=True))
        potential = expanded(it.potential - sum(springs, sp.S.Zero))
        return it.kinetic + potential - self.work + contacts

    def _stored_in(self, contact: NormalForce) -> sp.Expr:
        """The energy of a contact on the contact's side, with PUSHING."""
        if contact.gap is None:
            return sp.S.Zero
        energy = contact.energy
        if contact.in_coordinates:
            energy = expanded(energy.subs(contact.depth, -contact.gap))
        return (contact.pushing if contact.unilateral else 1) * energy

    @cached_property
    def work(self) -> sp.Expr:
        """A potential of the applied forces: the sum over coordinates of what is not counted
        yet.
        """
        it = self.model
        total = sp.S.Zero
        for symbol, force in zip(it.coordinates, it.applied, strict=True):
            integral = sp.integrate(expanded(force - sp.diff(total, symbol)), symbol)
            # What has none in one form for all parameters, as sin(η b) for η = 0 too, is power.
            total += sp.S.Zero if integral.has(sp.Piecewise, sp.Integral) else integral
        return expanded(total)

    @cached_property
    def applied_power(self) -> sp.Expr:
        """Power of applied forces that have no potential; zero for those that have one."""
        it = self.model
        rows = zip(it.coordinates, it.rates, it.applied, strict=True)
        return expanded(
            sum(
                ((force - sp.diff(self.work, symbol)) * rate for symbol, rate, force in rows),
                sp.S.Zero,
            )
        )

    @cached_property
    def friction_force(self) -> sp.Expr:
        """In MU."""
        return sp.S.Zero if self.model.friction.along is None else MU * self.model.contact.rubbing

    @cached_property
    def damper_power(self) -> sp.Expr:
        """Of all dampers: never positive."""
        return -2 * self.model.dissipation

    @cached_property
    def outputs(self) -> dict[str, sp.Expr]:
        """Forces, energy and power in a smooth regime, by name; in MU, or the FRICTION that
        holds.
        """
        it = self.model
        force = FRICTION if it.holds else self.friction_force
        sliding = it.friction.rate
        powers = force * sliding + self.damper_power + self.applied_power
        springs = enumerate(zip(it.lines, it.stiffnesses, strict=True), 1)
        return {
            **(
                {}
                if it.contact.gap is None and it.friction.along is None
                else {"force.normal": it.contact.force}
            ),
            **({} if it.friction.along is None else {"force.friction": force}),
            **{f"force.spring{n}": k * (line.l - line.rest) for n, (line, k) in springs if k != 0},
            "energy": self.energy,
            "power": powers,
        }

    def balances(self) -> bool:
        """Whether the energy changes by the powers and by nothing else, as exact algebra for every
        state.
        """
        it = self.model
        change = sp.S.Zero
        for symbol, rate, pull in zip(it.coordinates, it.rates, self.pull, strict=True):
            change += it.derivative(self.stored, symbol) * rate + rate * pull  # vᵀ M q″
        rubbing = sum((one.mu * one.normal.rubbing * one.rate for one in it.frictions), sp.S.Zero)
        powers = rubbing + self.damper_power + self.applied_power
        turned = {
            node: sp.Dummy(real=True) for pair in waves(sp.Tuple(change, powers)) for node in pair
        }
        circles = [(line.c, line.s) for line in it.lines] + [
            (turned[c], turned[s]) for c, s in waves(sp.Tuple(*turned))
        ]
        return difference(change.xreplace(turned), powers.xreplace(turned), tuple(circles)) == 0

    # ---------------------------------------------------------------------------------------------
    # borders

    @cached_property
    def borders(self) -> Row:
        """What is zero on a kink of the field: the border of every contact, every sliding speed."""
        it = self.model
        return (
            *(sp.S.One if contact.border is None else contact.border for contact in it.contacts),
            *(
                laws.slip(friction) if friction.along is not None else sp.S.One
                for friction in it.frictions
            ),
        )

    @cached_property
    def curved(self) -> bool:
        """Whether a border is no linear function of the coordinates and rates."""
        it = self.model
        return any(
            not sp.hessian(border, (*it.coordinates, *it.rates)).is_zero_matrix
            for border in self.borders
        )

    def rate(self, expression: sp.Expr, accelerations: Symbols) -> sp.Expr:
        """d/dt of an expression in coordinates and rates."""
        it = self.model
        changes = zip((*it.coordinates, *it.rates), (*it.rates, *accelerations), strict=True)
        return sp.Add(*(it.derivative(expression, symbol) * value for symbol, value in changes))


def _rows(motion: Motion, symbols: Symbols) -> tuple[Row, ...]:
    """Derivatives of the accelerations, a row for each."""
    columns = [motion.slopes(symbol) for symbol in symbols]
    return tuple(
        tuple(column[row] for column in columns) for row in range(len(motion.accelerations))
    )


def _slopes(motion: Motion, symbols: Symbols) -> tuple[Row, ...]:
    """Derivatives of the sliding speed and, while it sticks, of the margins of the force of
    friction.
    """
    rows = motion.borders[1], *motion.margins(FRICTION)
    turns = {symbol: motion.friction_slope(symbol).subs({STUCK: 1, SIDE: 0}) for symbol in symbols}
    return tuple(
        tuple(motion.derivative(row, symbol, turn) for symbol, turn in turns.items())
        for row in rows
    )


def directions(model: Mechanics) -> Names:
    """Lengths and directions of all lines, and turnings of torsion springs, by the place."""
    found: Names = {}
    for line in model.lines:
        found |= {line.l: line.length, line.c: line.dx / line.l, line.s: line.dy / line.l}
    return found | {torsion.phi: torsion.least for torsion in model.torsions}


def outputs(model: Mechanics) -> Module:
    """Forces, energy and power of a motion with their derivatives, for an export as a whole."""
    motion = Motion(model)
    place = (*model.coordinates, *model.rates)
    regime = (*place, *model.arguments, PUSHING, SIDE, *laws.near(len(laws.layers(model.friction))))
    taken = (*regime, *(torsion.way for torsion in model.torsions))
    shorthands = {
        **directions(model),
        **model.depths,
        MU: motion.friction,
        **motion.dry_friction,
        **motion.solved,
        **{torsion.phi: torsion.continued for torsion in model.torsions},
    }
    rows = tuple(motion.outputs.values())
    symbols = (*place, *map(number, model.parameters))
    turns = [motion.friction_slope(symbol) for symbol in symbols]
    slopes = tuple(
        tuple(
            motion.derivative(row, symbol, turn)
            for symbol, turn in zip(symbols, turns, strict=True)
        )
        for row in rows
    )
    return Module(
        "outputs",
        "Forces, energy and power of a motion.",
        (
            of_page(
                "outputs",
                "Forces, energy and power in a smooth regime.",
                taken,
                rows,
                f"({', '.join(motion.outputs)})",
                shorthands,
            ),
            of_page(
                "output_slopes",
                "Their derivatives by coordinates, rates and parameters, an angle as the angle.",
                taken,
                slopes,
                "((∂out_1/∂q_1, …, ∂out_1/∂v_1, …, ∂out_1/∂p_1, …), …)",
                shorthands,
            ),
        ),
    )


def module(model: Mechanics) -> Module:
    """The generated module."""
    motion = Motion(model)
    if not motion.balances():
        raise ArithmeticError(
            "the energy does not balance: the equations of motion are not those of the energies"
        )
    place = (*model.coordinates, *model.rates)
    moving = (*place, *model.arguments)
    stored = _stored(motion, moving)
    if len(model.contacts) > 1:
        return Module("motion", "Borders of a motion, and what it stores.", _kinks(motion) + stored)
    felt = laws.near(len(laws.layers(model.friction)))
    regime = (*moving, PUSHING, SIDE, *felt)
    ways = tuple(torsion.way for torsion in model.torsions)
    shorthands = {
        **directions(model),
        **model.depths,
        MU: motion.friction,
        **motion.dry_friction,
        **motion.solved,
    }
    accelerations, borders, layers = motion.named, motion.borders, laws.layers(model.friction)
    accelerated = (*place, *accelerations, *model.arguments)
    function = partial(of_page, shorthands=shorthands)

    def smooth(name: str, summary: str, results: Results, returns: str) -> Function:
        continued = shorthands | {torsion.phi: torsion.continued for torsion in model.torsions}
        return of_page(name, summary, (*regime, *ways), results, returns, continued)

    below = sp.Symbol("_below", real=True)
    signs = {
        # A law with a root has no slope at its border, which is then lift-off's.
        below: 1 + reached(-borders[0]) if model.contact.polynomial else 1 - reached(borders[0]),
        PUSHING: below / 2 if model.contact.border is not None else sp.S.One,
        SIDE: motion.side,
    }
    kinked = {**signs, **dict.fromkeys(felt, sp.S.One), **shorthands}
    jacobian = _rows(motion, place)
    by_parameters = _rows(motion, tuple(map(number, model.parameters)))
    turnings = tuple(torsion.border for torsion in model.torsions)
    turns = (
        ()
        if not ways
        else (
            function(
                "turning_borders",
                "Positive where a turning is counted on its way, from −0.93 to π times it.",
                (*moving, *ways),
                turnings,
                "(b_1, …)",
            ),
            function(
                "turning_rates",
                "How they change along a motion.",
                (*accelerated, *ways),
                tuple(motion.rate(border, accelerations) for border in turnings),
                "rates of (b_1, …)",
            ),
        )
    )
    grips = (
        (
            smooth(
                "grip",
                "How far the force of friction that holds is from its limits, with the belt "
                "and against it: positive while "
                "it sticks.",
                motion.margins(motion.holding),
                "(ahead, behind)",
            ),
            smooth(
                "grip_slopes",
                "Derivatives of the sliding speed, and of these while it sticks, by "
                "coordinates, rates and all parameters.",
                _slopes(motion, (*place, *map(number, model.parameters))),
                "((∂slip/∂q_1, …, ∂slip/∂v_1, …, ∂slip/∂p_1, …), …)",
            ),
        )
        if model.holds
        else ()
    )
    return Module(
        "motion",
        "The equations of motion: everywhere, and in each regime in which they are smooth.",
        (
            of_page(
                "rhs",
                "Accelerations, kinked where a border is zero: there those of "
                f"{'contact' if model.contact.polynomial else 'lift-off'}, and of the belt ahead.",
                moving,
                motion.accelerations,
                "(q_1″, …)",
                kinked,
            ),
            smooth(
                "regime_rhs",
                "Accelerations in a smooth regime, continued beyond its borders.",
                motion.accelerations,
                "(q_1″, …)",
            ),
            smooth(
                "regime_jacobian",
                "Derivatives of regime_rhs by the coordinates and the rates.",
                jacobian,
                "((∂q_1″/∂q_1, …, ∂q_1″/∂v_1, …), …)",
            ),
            smooth(
                "regime_by_parameters",
                "Derivatives of regime_rhs by all parameters, an angle as the angle.",
                by_parameters,
                "((∂q_1″/∂p_1, …), …)",
            ),
            *_kinks(motion),
            function(
                "layers",
                "Minus the exponents of the sliding speed in the friction law: large where "
                "they are not felt.",
                (*moving, SIDE),
                layers,
                "(z_1, …)",
            ),
            function(
                "layer_rates",
                "How they change along a motion with the given accelerations.",
                (*accelerated, SIDE),
                tuple(motion.rate(layer, accelerations) for layer in layers),
                "rates of (z_1, …)",
            ),
            *turns,
            *grips,
            *stored,
            function(
                "friction_force",
                "The force of friction, along what it opposes.",
                regime,
                FRICTION if model.holds else motion.friction_force,
                "force",
            ),
            function(
                "power_besides_friction",
                "Rate at which dampers, and applied forces without a potential, change the energy.",
                moving,
                motion.damper_power + motion.applied_power,
                "power",
            ),
        ),
    )


def _stored(motion: Motion, moving: Symbols) -> tuple[Function, ...]:
    model = motion.model
    shorthands = {**directions(model), **model.depths}
    return (
        of_page(
            "energy",
            "Kinetic and stored energy, applied forces and contact included.",
            (*moving, *model.pushings),
            motion.energy,
            "energy",
            shorthands,
        ),
        of_page(
            "strain_energy",
            "Energy stored in springs, contact and potentials, without the applied forces.",
            (*model.coordinates, *model.arguments, *model.pushings),
            motion.strain_energy,
            "energy",
            shorthands,
        ),
    )


def _kinks(motion: Motion) -> tuple[Function, ...]:
    """Every contact's border and every sliding speed."""
    model, accelerations = motion.model, motion.named
    place = (*model.coordinates, *model.rates)
    gaps, slips = ("gap, slip", "gap and the sliding speed")
    if len(model.contacts) > 1:
        gaps, slips = "gap_1, …, slip_1, …", "gaps and the sliding speeds"
    shorthands = directions(model)
    return (
        of_page(
            "borders",
            f"The {slips}, each zero on a kink of the field; 1 where there is none.",
            (*place, *model.arguments),
            motion.borders,
            gaps,
            shorthands,
        ),
        of_page(
            "border_rates",
            "How the borders change along a motion with the given accelerations.",
            (*place, *accelerations, *model.arguments),
            tuple(motion.rate(border, accelerations) for border in motion.borders),
            f"rates of {gaps}",
            shorthands,
        ),
    )
