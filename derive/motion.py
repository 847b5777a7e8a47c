"""Motion of any model: accelerations in each regime in which they are smooth, their derivatives,
borders, energy and powers.
"""

import itertools
from dataclasses import dataclass
from functools import cached_property, partial

import sympy as sp
from sympy import Add, Expr, Matrix, S, Symbol, diff

from . import laws
from .algebra import Names, Row, Symbols, equal, expanded, reached
from .emit.function import Function, Module, Results, of_page
from .mechanics import (
    FrictionForce,
    Mechanics,
    NormalForce,
    named,
    number,
    on,
)
from .model import acceleration_of


@dataclass(frozen=True)
class Motion:
    """The equations of motion M q″ = forces, solved for q″."""

    model: Mechanics

    @cached_property
    def coefficients(self) -> Names:
        """μ of every friction, on either side."""
        return {it.mu: laws.smooth_friction(it) for it in self.model.frictions}

    @cached_property
    def holding(self) -> tuple[FrictionForce, ...]:
        """The frictions that hold where nothing slides."""
        return tuple(it for it in self.model.frictions if it.holds is not None)

    def along(self, friction: FrictionForce) -> Row:
        """Derivatives of the displacement that a friction opposes."""
        return tuple(diff(friction.along, symbol) for symbol in self.model.coordinates)

    def slip(self, friction: FrictionForce) -> Expr:
        """The sliding speed of a friction, among the borders."""
        return self.borders[len(self.model.contacts) + self.model.frictions.index(friction)]

    @cached_property
    def mobility(self) -> Matrix:
        """Jᵀ M⁻¹ J of the displacements that frictions which hold oppose: by how much a unit of
        each slows the sliding of each.
        """
        along = [self.along(it) for it in self.holding]
        return Matrix(along) * Matrix([self.over_mass(row) for row in along]).T

    def _coupled(self, index: int) -> list[int]:
        """The frictions that hold whose forces a constraint depends on: its own, and those that the
        mobility couples with it, one after another.
        """
        found = [index]
        for row in found:
            coupled = (i for i, entry in enumerate(self.mobility.row(row)) if entry != 0)
            found += [i for i in coupled if i not in found]
        return sorted(found)

    def _in_symbols(self, name: str, entries: Matrix) -> tuple[Matrix, Names]:
        """Entries of a system, and by what symbols they stand in its determinants; by themselves
        where they are numbers, or a friction is coupled with no other, and has no determinant.
        """
        symbols = entries.copy()
        for i, j in itertools.product(*map(range, entries.shape)):
            if not entries[i, j].is_number and len(self._coupled(i)) > 1:
                symbols[i, j] = Symbol(f"_{name}_{i + 1}{j + 1}", real=True)
        pairs = zip(symbols, entries, strict=True)
        return symbols, {symbol: entry for symbol, entry in pairs if symbol != entry}

    def held(self, friction: FrictionForce, stuck: Row, slipping: Row) -> Expr:
        """The solution f of mobility f = stuck for one friction where it holds, the others hold or
        have the values ``slipping``: by Cramer's rule.
        """
        own = self.holding.index(friction)
        places = self._coupled(own)
        mobility, _ = self._in_symbols("mobility", self.mobility)
        system, right = sp.zeros(len(places)), sp.zeros(len(places), 1)
        for row, index in enumerate(places):
            share = S.One if index == own else self.holding[index].stuck
            for column, other in enumerate(places):
                none = S.One if row == column else S.Zero
                system[row, column] = none + share * (mobility[index, other] - none)
            right[row] = share * stuck[index] + (1 - share) * slipping[index]
        whole = system.det(method="berkowitz")
        system[:, places.index(own)] = right
        return system.det(method="berkowitz") / whole

    @cached_property
    def free(self) -> tuple[Row, Names]:
        """Rates of the sliding speeds without the frictions that hold."""
        free = dict.fromkeys((it.unknown for it in self.holding), S.Zero)
        rates = [self.rate(self.slip(it), self.accelerations).subs(free) for it in self.holding]
        symbols, names = self._in_symbols("free", Matrix(rates))
        return tuple(symbols), names

    def constraint(self, friction: FrictionForce) -> Expr:
        """The force that keeps the sliding speed from changing while the other frictions hold or
        slip: the constraint force of sticking.
        """
        slipping = tuple(it.mu * it.normal.rubbing for it in self.holding)
        return self.held(friction, self.free[0], slipping)

    @cached_property
    def dry_friction(self) -> Names:
        """Expressions for the symbols of frictions that hold.

        Sticking or not, the force is a sum and no coefficient times a normal force that goes to 0
        where the contact is lost.
        """
        if not self.holding:
            return {}
        _, mobility = self._in_symbols("mobility", self.mobility)
        forces = {
            it.unknown: (1 - it.stuck) * it.mu * it.normal.rubbing + it.stuck * self.constraint(it)
            for it in self.holding
        }
        sticking = {it.stuck: 1 - it.side**2 for it in self.holding}
        return {**self.inverted, **sticking, **mobility, **self.free[1], **forces}

    def margins(self, friction: FrictionForce, force: Expr) -> Row:
        """Distances of a force of friction from its limit with the belt, and from that against it:
        positive while friction holds.
        """
        ahead, behind = (
            coefficient * friction.normal.rubbing
            for coefficient in laws.static_coefficients(friction)
        )
        return ahead - force, behind + force

    def side(self, friction: FrictionForce) -> Expr:
        """The sign of the sliding speed; where nothing slides 1, or of friction that holds that of
        the mode in which the motion goes on, while others at rest hold.
        """
        if friction.holds is None:
            return reached(self.slip(friction))
        sliding = sp.sign(self.slip(friction))
        others = Names()
        for it in self.holding:
            side = sp.sign(self.slip(it))
            others |= {it.stuck: 1 - side**2, it.mu: self.coefficients[it.mu].subs(it.side, side)}
        constraint = self.constraint(friction).xreplace(others)
        within_ahead, within_behind = map(reached, self.margins(friction, constraint))
        return sliding + (1 - sliding**2) * (within_behind - within_ahead) / 2

    @cached_property
    def centrifugal(self) -> Row:
        """The terms of Lagrange's equations besides M q″ where the mass matrix depends on the
        place, or the energy has terms linear in the rates: d(∂T/∂v)/dt − ∂T/∂q at q″ = 0.
        """
        it = self.model
        energy = it.kinetic + it.linear
        momenta = [diff(energy, rate) for rate in it.rates]
        return tuple(
            expanded(it.page.rate(momentum) - diff(energy, symbol))
            for momentum, symbol in zip(momenta, it.coordinates, strict=True)
        )

    @cached_property
    def pull(self) -> Row:
        """The right side of M q″ = …, in MU, PUSHING, directions and rates."""
        it = self.model
        rows = zip(it.residuals, it.resistance, self.centrifugal, strict=True)
        return tuple(-static - damped - turned for static, damped, turned in rows)

    def balance(self, *normal: Expr) -> Row:
        """M q″ less all forces, of which those of the contacts are ``normal``, in MU and the
        symbols of the accelerations.
        """
        it = self.model
        rows = []
        for symbol, inertia, pull in zip(
            it.coordinates, it.mass * Matrix(self.named), self.pull, strict=True
        ):
            row = inertia - pull
            for contact, force in zip(it.contacts, normal, strict=True):
                share = S.Zero if contact.gap is None else diff(contact.gap, symbol)
                for friction in it.frictions:
                    if friction.normal is contact and friction.along is not None:
                        share += friction.mu * diff(friction.along, symbol)
                row += (contact.force - force) * share
            rows.append(expanded(row))
        return tuple(rows)

    @cached_property
    def accelerations(self) -> Row:
        """q″ in μ, or in the frictions that hold, and in the entries of the inverse of M where
        these are no quotients of parameters.
        """
        return self.over_mass(self.forces)

    @cached_property
    def forces(self) -> Row:
        """M q″, in μ or in the frictions that hold."""
        rows = list(self.pull)
        for it in self.holding:
            rows = [
                row.subs(it.mu, 0) + it.unknown * share
                for row, share in zip(rows, self.along(it), strict=True)
            ]
        return tuple(rows)

    def over_mass(self, forces: Row) -> Row:
        """M⁻¹ times forces."""
        if not self.is_coupled:
            return tuple(row / self.model.mass[i, i] for i, row in enumerate(forces))
        return tuple(self.inverse * Matrix(forces))

    @cached_property
    def is_coupled(self) -> bool:
        """Whether M has entries beside its diagonal, or depends on the place."""
        it = self.model
        return not it.mass.is_diagonal() or it.mass.has(*it.coordinates)

    @cached_property
    def inverse(self) -> Matrix:
        """Symbols of the entries of the inverse of M."""
        n = len(self.model.coordinates)
        return Matrix(
            n, n, lambda i, j: Symbol(f"_inverse_{min(i, j) + 1}{max(i, j) + 1}", real=True)
        )

    @cached_property
    def named(self) -> Symbols:
        """Symbols of the accelerations."""
        return tuple(
            Symbol(acceleration_of(symbol), real=True) for symbol in self.model.coordinates
        )

    @cached_property
    def solved(self) -> Names:
        """The accelerations by their symbols, where derivatives take them."""
        named = dict(zip(self.named, self.accelerations, strict=True))
        return {**self.inverted, **named} if self.is_coupled or self.model.holds else {}

    @cached_property
    def inverted(self) -> Names:
        """Expressions for the entries of the inverse of M: M is inverted in numbers once, and never
        differentiated.
        """
        if not self.is_coupled:
            return {}
        determinant = Symbol("_determinant", positive=True)
        M, tidy = self.model.mass, self.model.tidy
        entries = zip(self.inverse, M.adjugate(), strict=True)
        return {
            determinant: tidy(M.det(method="berkowitz")),
            **{symbol: tidy(entry) / determinant for symbol, entry in entries},
        }

    def slopes(self, symbol: Symbol, turns: Row | None = None) -> Row:
        """Derivatives of the accelerations by a coordinate, a rate or a parameter: M ∂q″ = ∂forces
        − ∂M q″; ``turns`` are those of the frictions.
        """
        turns = self.turns(symbol) if turns is None else turns
        if not self.is_coupled:
            return tuple(self.derivative(row, symbol, turns) for row in self.accelerations)
        it = self.model
        changes = it.mass.applyfunc(lambda entry: it.tidy(it.derivative(entry, symbol))) * Matrix(
            self.named
        )
        pulls = Matrix([self.derivative(row, symbol, turns) for row in self.forces])
        return tuple(self.inverse * (pulls - changes))

    def turns(self, symbol: Symbol) -> Row:
        """Derivatives of μ of every friction, or of the force of one that holds: of several by
        their names where they are not 0.
        """
        slopes = tuple(self.friction_slope(it, symbol) for it in self.model.frictions)
        if len(slopes) < 2:
            return slopes
        return tuple(
            slope if slope == 0 else self._turn(it, symbol)
            for it, slope in zip(self.model.frictions, slopes, strict=True)
        )

    def _turn(self, friction: FrictionForce, symbol: Symbol) -> Symbol:
        return Symbol(f"_turn_{friction.name}_{symbol}", real=True)

    def turned(self, symbols: Symbols) -> Names:
        """Derivatives of several frictions, by their names."""
        if len(self.model.frictions) < 2:
            return {}
        return {
            self._turn(it, symbol): self.friction_slope(it, symbol)
            for symbol in symbols
            for it in self.model.frictions
        }

    def friction_slope(self, friction: FrictionForce, symbol: Symbol) -> Expr:
        """The derivative of μ; or that of a force that holds, which keeps the sliding speed from
        changing.
        """
        mu = self.coefficients[friction.mu]
        if friction.holds is None:
            return self.model.derivative(mu, symbol)
        slipping = self.model.derivative(mu * friction.normal.rubbing, symbol)
        return (1 - friction.stuck) * slipping + friction.stuck * self.held_slope(friction, symbol)

    def held_slope(self, friction: FrictionForce, symbol: Symbol) -> Expr:
        """The derivative of the force that keeps a sliding speed from changing."""
        still = tuple(
            S.Zero
            if it in self.holding
            else self.model.derivative(self.coefficients[it.mu], symbol)
            for it in self.model.frictions
        )
        slopes = self.slopes(symbol, still)
        changes = tuple(
            self.model.derivative(self.rate(self.slip(it), self.named), symbol)
            - sum(a * b for a, b in zip(self.along(it), slopes, strict=True))
            for it in self.holding
        )
        slipping = tuple(
            self.model.derivative(self.coefficients[it.mu] * it.normal.rubbing, symbol)
            for it in self.holding
        )
        return self.held(friction, changes, slipping)

    def derivative(self, expression: Expr, symbol: Symbol, turns: Row) -> Expr:
        """By a coordinate, a rate or a parameter, with ``turns`` for those of μ, or of the forces
        that hold.
        """
        it = self.model
        follow = (
            diff(expression, one.unknown if one in self.holding else one.mu) * turn
            for one, turn in zip(it.frictions, turns, strict=True)
        )
        return it.tidy(it.derivative(expression, symbol) + Add(*follow))

    # ---------------------------------------------------------------------------------------------
    # energy

    @cached_property
    def stored(self) -> Expr:
        """Kinetic and stored energy, with the work of the applied forces and, where it pushes, the
        contact's.
        """
        it = self.model
        springs = zip(it.lines, it.stiffnesses, strict=True)
        at_rest = Add(*(k * line.rest**2 / 2 for line, k in springs))
        return it.kinetic + it.potential + at_rest - self.work + self._stored_in_contacts

    @cached_property
    def energy(self) -> Expr:
        """The same with the springs' as k (l − r)²/2, which loses no digits where they are hardly
        deformed: l² is dx² + dy².
        """
        it = self.model
        springs = zip(it.lines, it.stiffnesses, strict=True)
        strained = Add(*(k * (line.l - line.rest) ** 2 / 2 for line, k in springs))
        without = expanded(it.potential - it.elastic_energy)
        return it.kinetic + without + strained - self.work + self._stored_in_contacts

    @cached_property
    def strain_energy(self) -> Expr:
        """Energy of springs, torsion springs, contact and the page's potentials, without the
        applied forces.
        """
        return self.energy - self.model.kinetic + self.work

    @cached_property
    def _stored_in_contacts(self) -> Expr:
        """The energy of all contacts, each on its own side, with PUSHING."""
        stored = S.Zero
        for contact in self.model.contacts:
            if contact.gap is not None:
                energy = contact.energy
                if contact.in_coordinates:
                    energy = expanded(energy.subs(contact.depth, -contact.gap))
                stored += (contact.pushing if contact.unilateral else 1) * energy
        return stored

    @cached_property
    def work(self) -> Expr:
        """A potential of the applied forces: the sum over coordinates of what is not counted
        yet.
        """
        it = self.model
        total = S.Zero
        for symbol, _, force in it.moved:
            integral = sp.integrate(expanded(force - diff(total, symbol)), symbol)
            # What has none in one form for all parameters, as sin(η b) for η = 0 too, is power.
            total += S.Zero if integral.has(sp.Piecewise, sp.Integral) else integral
        return expanded(total)

    @cached_property
    def applied_power(self) -> Expr:
        """Power of applied forces that have no potential; zero for those that have one."""
        work = self.work
        powers = ((force - diff(work, q)) * rate for q, rate, force in self.model.moved)
        return expanded(Add(*powers))

    @cached_property
    def clock_power(self) -> Expr:
        """Rate at which the clock changes what is stored, by ends, gaps and forces that follow
        it.
        """
        it = self.model
        return S.Zero if it.clock is None else it.derivative(self.stored, it.clock) * it.rates[-1]

    def friction_force(self, friction: FrictionForce) -> Expr:
        """In μ, or what it holds."""
        if friction.along is None:
            return S.Zero
        return (
            friction.unknown if friction in self.holding else friction.mu * friction.normal.rubbing
        )

    @cached_property
    def damper_power(self) -> Expr:
        """Of all dampers: never positive, but where the clock moves an end of one."""
        it = self.model
        if it.clock is None:
            return -2 * it.dissipation
        return -Add(*(diff(it.dissipation, rate) * rate for _, rate, _ in it.moved))

    @cached_property
    def outputs(self) -> dict[str, Expr]:
        """Forces, energy and power in a smooth regime, by name; in μ, or the friction that
        holds.
        """
        it = self.model
        frictions = [friction for friction in it.frictions if friction.along is not None]
        forces = [self.friction_force(friction) for friction in frictions]
        rubbing = Add(*(f * one.rate for f, one in zip(forces, frictions, strict=True)))
        powers = rubbing + self.damper_power + self.applied_power + self.clock_power
        springs = enumerate(zip(it.lines, it.stiffnesses, strict=True), 1)
        pressed = [friction.normal for friction in frictions]

        def of(what: str, contact: NormalForce) -> str:
            return f"{what}.{contact.name}" if contact.name else what

        return {
            **{
                of("force.normal", contact): contact.force
                for contact in it.contacts
                if contact.gap is not None or contact in pressed
            },
            **{
                of("force.friction", friction.normal): force
                for friction, force in zip(frictions, forces, strict=True)
            },
            **{f"force.spring{n}": k * (line.l - line.rest) for n, (line, k) in springs if k != 0},
            "energy": self.energy,
            "power": powers,
        }

    def balances(self) -> bool:
        """Whether the energy changes by the powers and by nothing else, as exact algebra for every
        state.
        """
        it = self.model
        change = S.Zero
        for symbol, rate, pull in zip(it.coordinates, it.rates, self.pull, strict=True):
            if symbol != it.clock:
                change += it.derivative(self.stored, symbol) * rate + rate * pull  # vᵀ M q″
        rubbing = Add(*(one.mu * one.normal.rubbing * one.rate for one in it.frictions))
        powers = rubbing + self.damper_power + self.applied_power
        turned, circles = it.circles(sp.Tuple(change, powers))
        return equal(change.xreplace(turned), powers.xreplace(turned), circles)

    # ---------------------------------------------------------------------------------------------
    # borders

    @cached_property
    def borders(self) -> Row:
        """Levels that are zero on a kink of the field: the border of every contact, every sliding
        speed.
        """
        it = self.model
        return (
            *(S.One if contact.border is None else contact.border for contact in it.contacts),
            *(
                laws.slip(friction) if friction.along is not None else S.One
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

    def rate(self, expression: Expr, accelerations: Symbols) -> Expr:
        """d/dt of an expression in coordinates and rates."""
        it = self.model
        changes = zip((*it.coordinates, *it.rates), (*it.rates, *accelerations), strict=True)
        return Add(*(it.derivative(expression, symbol) * value for symbol, value in changes))

    # ---------------------------------------------------------------------------------------------
    # what functions take

    @property
    def variables(self) -> Symbols:
        """Coordinates and rates."""
        return (*self.model.coordinates, *self.model.rates)

    @property
    def moving(self) -> Symbols:
        """These and the parameters."""
        return (*self.variables, *self.model.arguments)

    @property
    def accelerated(self) -> Symbols:
        """The same with the accelerations."""
        return (*self.variables, *self.named, *self.model.arguments)

    @property
    def sides(self) -> Symbols:
        """SIDE of every friction."""
        return tuple(friction.side for friction in self.model.frictions)

    @property
    def ways(self) -> Symbols:
        """The ways on which torsion springs are counted."""
        return tuple(torsion.way for torsion in self.model.torsions)

    @property
    def regime(self) -> Symbols:
        """What smooth functions take: the numbers of a mode too, what pushes, the sides, and what
        of the laws is felt.
        """
        near = (factor for friction in self.model.frictions for factor in laws.near(friction))
        return (*self.moving, *self.model.pushings, *self.sides, *near)

    @cached_property
    def shorthands(self) -> Names:
        """What stands in the accelerations, by its symbols."""
        own = {**directions(self.model), **self.model.depths}
        return {**own, **self.coefficients, **self.dry_friction, **self.solved}

    def smooth(
        self, name: str, summary: str, results: Results, returns: str, by: Symbols = ()
    ) -> Function:
        """A function in a smooth regime, continued beyond its borders."""
        continued = {torsion.phi: torsion.continued for torsion in self.model.torsions}
        names = self.shorthands | continued | self.turned(by)
        return of_page(name, summary, (*self.regime, *self.ways), results, returns, names)

    def rows_by(self, rows: Row, symbols: Symbols) -> tuple[Row, ...]:
        """Derivatives of rows in a regime, each by all symbols."""
        turns = [(symbol, self.turns(symbol)) for symbol in symbols]
        return tuple(
            tuple(self.derivative(row, symbol, turn) for symbol, turn in turns) for row in rows
        )


def _rows(motion: Motion, symbols: Symbols) -> tuple[Row, ...]:
    """Derivatives of the accelerations, a row for each."""
    columns = [motion.slopes(symbol) for symbol in symbols]
    count = len(motion.accelerations)
    return tuple(tuple(column[row] for column in columns) for row in range(count))


def _slopes(motion: Motion, symbols: Symbols) -> tuple[Row, ...]:
    """Derivatives of every sliding speed that friction holds and, while it sticks, of the margins
    of the force of friction.
    """
    found = []
    for it in motion.holding:
        rows = motion.slip(it), *motion.margins(it, it.unknown)
        turns = {
            symbol: tuple(
                motion.held_slope(it, symbol) if one is it else S.Zero
                for one in motion.model.frictions
            )
            for symbol in symbols
        }
        found += [
            tuple(motion.derivative(row, symbol, turn) for symbol, turn in turns.items())
            for row in rows
        ]
    return tuple(found)


def directions(model: Mechanics) -> Names:
    """Lengths and directions of all lines, and turnings of torsion springs, by the place."""
    found: Names = {}
    for line in model.lines:
        found |= {line.l: line.length, line.c: line.dx / line.l, line.s: line.dy / line.l}
    return found | {torsion.phi: torsion.least for torsion in model.torsions}


def outputs(model: Mechanics) -> Module:
    """Forces, energy and power of a motion with their derivatives, for an export as a whole."""
    motion = Motion(model)
    rows = tuple(motion.outputs.values())
    symbols = (*motion.variables, *map(number, model.parameters))
    return Module(
        "outputs",
        "Forces, energy and power of a motion.",
        (
            motion.smooth(
                "outputs",
                "Forces, energy and power in a smooth regime.",
                rows,
                f"({', '.join(motion.outputs)})",
            ),
            motion.smooth(
                "output_slopes",
                "Their derivatives by coordinates, rates and parameters, an angle as the angle.",
                motion.rows_by(rows, symbols),
                "((∂out_1/∂q_1, …, ∂out_1/∂v_1, …, ∂out_1/∂p_1, …), …)",
                symbols,
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
    function, smooth = partial(of_page, shorthands=motion.shorthands), motion.smooth
    parameters = tuple(map(number, model.parameters))
    layers = tuple(layer for friction in model.frictions for layer in laws.layers(friction))
    functions = [
        _everywhere(motion),
        smooth(
            "regime_rhs",
            "Accelerations in a smooth regime, continued beyond its borders.",
            motion.accelerations,
            "(q_1″, …)",
        ),
        smooth(
            "regime_jacobian",
            "Derivatives of regime_rhs by the coordinates and the rates.",
            _rows(motion, motion.variables),
            "((∂q_1″/∂q_1, …, ∂q_1″/∂v_1, …), …)",
            motion.variables,
        ),
        smooth(
            "regime_by_parameters",
            "Derivatives of regime_rhs by all parameters, an angle as the angle.",
            _rows(motion, parameters),
            "((∂q_1″/∂p_1, …), …)",
            parameters,
        ),
        *_kinks(motion),
        function(
            "layers",
            "Minus the exponents of the sliding speed in the friction law: large where "
            "they are not felt.",
            (*motion.moving, *motion.sides),
            layers,
            "(z_1, …)",
        ),
        function(
            "layer_rates",
            "How they change along a motion with the given accelerations.",
            (*motion.accelerated, *motion.sides),
            tuple(motion.rate(layer, motion.named) for layer in layers),
            "rates of (z_1, …)",
        ),
    ]
    if model.torsions:
        turnings = tuple(torsion.border for torsion in model.torsions)
        functions += [
            function(
                "turning_borders",
                "Positive where a turning is counted on its way, from −0.93 to π times it.",
                (*motion.moving, *motion.ways),
                turnings,
                "(b_1, …)",
            ),
            function(
                "turning_rates",
                "How they change along a motion.",
                (*motion.accelerated, *motion.ways),
                tuple(motion.rate(border, motion.named) for border in turnings),
                "rates of (b_1, …)",
            ),
        ]
    if model.holds:
        margins = (motion.margins(it, motion.constraint(it)) for it in motion.holding)
        functions += [
            smooth(
                "grip",
                "How far the force of friction that holds is from its limits, with the belt and "
                "against it: positive while it sticks.",
                tuple(itertools.chain.from_iterable(margins)),
                "(ahead, behind)" if len(motion.holding) < 2 else "(ahead_1, behind_1, …)",
            ),
            smooth(
                "grip_slopes",
                "Derivatives of the sliding speed, and of these while it sticks, by coordinates, "
                "rates and all parameters.",
                _slopes(motion, (*motion.variables, *parameters)),
                "((∂slip/∂q_1, …, ∂slip/∂v_1, …, ∂slip/∂p_1, …), …)",
            ),
        ]
    functions += _stored(motion)
    functions += [
        function(
            named("friction_force", friction),
            f"The force of friction{on(friction)}, along what it opposes.",
            motion.regime,
            motion.friction_force(friction),
            "force",
        )
        for friction in model.frictions
    ]
    functions.append(
        function(
            "power_besides_friction",
            "Rate at which dampers, and applied forces without a potential, change the energy.",
            motion.moving if model.clock is None else (*motion.moving, *model.pushings),
            motion.damper_power + motion.applied_power + motion.clock_power,
            "power",
        )
    )
    if model.clock is not None:
        rate = "The rate of the clock."
        functions.append(of_page("clock", rate, model.arguments, model.speed, "rate"))
    return Module(
        "motion",
        "The equations of motion: everywhere, and in each regime in which they are smooth.",
        tuple(functions),
    )


def _everywhere(motion: Motion) -> Function:
    """The kinked right-hand side."""
    model, signs = motion.model, Names()
    for contact, border in zip(model.contacts, motion.borders, strict=False):
        below = Symbol(f"_below{contact.name and '_'}{contact.name}", real=True)
        # A law with a root has no slope at its border, which is then lift-off's.
        signs[below] = 1 + reached(-border) if contact.polynomial else 1 - reached(border)
        signs[contact.pushing] = S.One if contact.border is None else below / 2
    signs |= {friction.side: motion.side(friction) for friction in model.frictions}
    felt = {factor: S.One for it in model.frictions for factor in laws.near(it)}
    touches = all(contact.polynomial for contact in model.contacts)
    return of_page(
        "rhs",
        "Accelerations, kinked where a border is zero: there those of "
        f"{'contact' if touches else 'lift-off'}, and of the belt ahead.",
        motion.moving,
        motion.accelerations,
        "(q_1″, …)",
        {**signs, **felt, **motion.shorthands},
    )


def _stored(motion: Motion) -> tuple[Function, ...]:
    model = motion.model
    function = partial(of_page, shorthands={**directions(model), **model.depths})
    return (
        function(
            "energy",
            "Kinetic and stored energy, applied forces and contact included."
            if model.gyroscopic.is_zero_matrix and model.still == 0
            else "Jacobi's integral: the part of the kinetic energy quadratic in the rates, less "
            "that without rates, and stored energy, applied forces and contact included.",
            (*motion.moving, *model.pushings),
            motion.energy,
            "energy",
        ),
        function(
            "strain_energy",
            "Energy stored in springs, contact and potentials, without the applied forces.",
            (*model.coordinates, *model.arguments, *model.pushings),
            motion.strain_energy,
            "energy",
        ),
        function(
            "energy_besides_strain",
            "What the energy has besides strain_energy: of the rates, and of the applied forces.",
            motion.moving,
            model.kinetic - motion.work,
            "energy",
        ),
    )


def _kinks(motion: Motion) -> tuple[Function, ...]:
    """Every contact's border and every sliding speed."""
    gaps, slips = ("gap, slip", "gap and the sliding speed")
    if len(motion.model.contacts) > 1:
        gaps, slips = "gap_1, …, slip_1, …", "gaps and the sliding speeds"
    function = partial(of_page, shorthands=directions(motion.model))
    return (
        function(
            "borders",
            f"The {slips}, each zero on a kink of the field; 1 where there is none.",
            motion.moving,
            motion.borders,
            gaps,
        ),
        function(
            "border_rates",
            "How the borders change along a motion with the given accelerations.",
            motion.accelerated,
            tuple(motion.rate(border, motion.named) for border in motion.borders),
            f"rates of {gaps}",
        ),
    )
