"""Equations of motion of any model: M(q) q″ = forces, piecewise smooth.

A regime is a combination of touching contacts and slip directions in which the forces are smooth;
its borders are zeros of gaps and sliding speeds. For every regime the module gives accelerations,
their derivatives by state and parameters, borders, energy and powers. Dry friction that sticks has
the constraint force that keeps the sliding speed constant.
"""

import itertools
from dataclasses import dataclass
from functools import cached_property, partial

import sympy as sp
from sympy import Add, Expr, Matrix, S, Symbol, diff

from . import laws
from .algebra import Names, Row, Symbols, equal, expanded, reached
from .emit.function import Function, Module, Results, of_page
from .mechanics import FrictionForce, Mechanics, named, number, on
from .model import acceleration_of


@dataclass(frozen=True)
class Motion:
    """The equations of motion M q″ = forces, solved for q″, and what follows from them."""

    model: Mechanics

    @cached_property
    def coefficients(self) -> Names:
        """The smooth law of every friction coefficient, by its symbol."""
        return {it.mu: laws.smooth_friction(it) for it in self.model.frictions}

    @cached_property
    def with_sticking(self) -> tuple[FrictionForce, ...]:
        """The dry frictions: those that stick at sliding speed 0."""
        return tuple(it for it in self.model.frictions if it.holds is not None)

    def along(self, friction: FrictionForce) -> Row:
        """Derivatives by the coordinates of the displacement that a friction opposes."""
        return tuple(diff(friction.along, symbol) for symbol in self.model.coordinates)

    def slip(self, friction: FrictionForce) -> Expr:
        """The sliding speed of a friction, which is one of the borders."""
        return self.borders[len(self.model.contacts) + self.model.frictions.index(friction)]

    @cached_property
    def mobility(self) -> Matrix:
        """Jᵀ M⁻¹ J of the dry frictions, with the columns of J from :meth:`along`: entry (i, j) is
        by how much a unit of force j changes the rate of sliding speed i.
        """
        along = [self.along(it) for it in self.with_sticking]
        return Matrix(along) * Matrix([self.over_mass(row) for row in along]).T

    def _coupled(self, index: int) -> list[int]:
        """Indices of the dry frictions that the mobility couples with one, directly or through
        others, itself included.
        """
        found = [index]
        for row in found:
            coupled = (i for i, entry in enumerate(self.mobility.row(row)) if entry != 0)
            found += [i for i in coupled if i not in found]
        return sorted(found)

    def _in_symbols(self, name: str, entries: Matrix) -> tuple[Matrix, Names]:
        """Entries replaced by symbols, and the meanings of these, so that determinants stay short.

        Numbers, and rows of frictions that are coupled with no other, stay as they are.
        """
        symbols = entries.copy()
        for i, j in itertools.product(*map(range, entries.shape)):
            if not entries[i, j].is_number and len(self._coupled(i)) > 1:
                symbols[i, j] = Symbol(f"_{name}_{i + 1}{j + 1}", real=True)
        pairs = zip(symbols, entries, strict=True)
        return symbols, {symbol: entry for symbol, entry in pairs if symbol != entry}

    def sticking_force(self, friction: FrictionForce, stuck: Row, slipping: Row) -> Expr:
        """The force of a friction that sticks, by Cramer's rule.

        The forces f of the frictions that stick solve the rows of mobility · f = stuck; each of
        the other frictions may stick or slip with the force in ``slipping``, as its symbol
        ``FrictionForce.stuck`` says.
        """
        number = self.with_sticking.index(friction)
        coupled = self._coupled(number)
        mobility, _ = self._in_symbols("mobility", self.mobility)
        system, right = sp.zeros(len(coupled)), sp.zeros(len(coupled), 1)
        for row, index in enumerate(coupled):
            sticks = S.One if index == number else self.with_sticking[index].stuck
            for column, other in enumerate(coupled):
                identity = S.One if row == column else S.Zero
                system[row, column] = identity + sticks * (mobility[index, other] - identity)
            right[row] = sticks * stuck[index] + (1 - sticks) * slipping[index]
        determinant = system.det(method="berkowitz")
        system[:, coupled.index(number)] = right
        return system.det(method="berkowitz") / determinant

    @cached_property
    def free(self) -> tuple[Row, Names]:
        """Rates of the sliding speeds without the dry frictions, in symbols, and their meanings."""
        free = dict.fromkeys((it.unknown for it in self.with_sticking), S.Zero)
        rates = [
            self.rate(self.slip(it), self.accelerations).subs(free) for it in self.with_sticking
        ]
        symbols, names = self._in_symbols("free", Matrix(rates))
        return tuple(symbols), names

    def constraint(self, friction: FrictionForce) -> Expr:
        """The constraint force of sticking: with it the sliding speed stays constant."""
        slipping = tuple(it.mu * it.normal.rubbing for it in self.with_sticking)
        return self.sticking_force(friction, self.free[0], slipping)

    @cached_property
    def dry_friction(self) -> Names:
        """Expressions of the forces and modes of dry friction, by their symbols.

        The force of sticking is not written as a coefficient times the normal force: that would
        divide by a normal force that goes to 0 where the contact is lost.
        """
        if not self.with_sticking:
            return {}
        _, mobility = self._in_symbols("mobility", self.mobility)
        forces = {
            it.unknown: (1 - it.stuck) * it.mu * it.normal.rubbing + it.stuck * self.constraint(it)
            for it in self.with_sticking
        }
        sticking = {it.stuck: 1 - it.side**2 for it in self.with_sticking}
        return {**self.inverted, **sticking, **mobility, **self.free[1], **forces}

    def margins(self, friction: FrictionForce, force: Expr) -> Row:
        """Distances of a friction force from its two limits, with the belt and against it; both are
        positive while friction sticks.
        """
        limit_ahead, limit_against = (
            coefficient * friction.normal.rubbing
            for coefficient in laws.static_coefficients(friction)
        )
        return limit_ahead - force, limit_against + force

    def side(self, friction: FrictionForce) -> Expr:
        """The slip direction, ±1, or 0 for sticking.

        At sliding speed 0 it is 1 for friction without sticking. Dry friction sticks there, or
        slips in the direction of the limit that its constraint force exceeds while all other
        frictions at rest stick.
        """
        if friction.holds is None:
            return reached(self.slip(friction))
        sliding = sp.sign(self.slip(friction))
        others = Names()
        for it in self.with_sticking:
            side = sp.sign(self.slip(it))
            others |= {it.stuck: 1 - side**2, it.mu: self.coefficients[it.mu].subs(it.side, side)}
        constraint = self.constraint(friction).xreplace(others)
        within_ahead, within_behind = map(reached, self.margins(friction, constraint))
        return sliding + (1 - sliding**2) * (within_behind - within_ahead) / 2

    @cached_property
    def centrifugal(self) -> Row:
        """Inertia forces besides M q″: d(∂T/∂v)/dt − ∂T/∂q at q″ = 0, of a mass matrix that depends
        on the coordinates and of kinetic energy linear in the rates.
        """
        model = self.model
        energy = model.kinetic + model.linear
        momenta = [diff(energy, rate) for rate in model.rates]
        return tuple(
            S.Zero
            if symbol == model.clock
            else expanded(model.page.rate(momentum) - diff(energy, symbol))
            for momentum, symbol in zip(momenta, model.coordinates, strict=True)
        )

    @cached_property
    def pull(self) -> Row:
        """The right side of M q″ = …, in the symbols MU, PUSHING, directions and rates."""
        model = self.model
        rows = zip(model.residuals, model.resistance, self.centrifugal, strict=True)
        return tuple(-static - damping - inertia for static, damping, inertia in rows)

    def balance(self, *normal: Expr) -> Row:
        """The residuals M q″ − forces, in MU and the symbols of the accelerations, with given
        expressions ``normal`` for the contact forces.
        """
        model = self.model
        rows = []
        for symbol, inertia, pull in zip(
            model.coordinates,
            model.mass * Matrix(self.acceleration_symbols),
            self.pull,
            strict=True,
        ):
            row = inertia - pull
            for contact, force in zip(model.contacts, normal, strict=True):
                lever = S.Zero if contact.gap is None else diff(contact.gap, symbol)
                for friction in model.frictions:
                    if friction.normal is contact:
                        lever += friction.mu * diff(friction.along, symbol)
                row += (contact.force - force) * lever
            rows.append(expanded(row))
        return tuple(rows)

    @cached_property
    def accelerations(self) -> Row:
        """q″ in the symbols of friction coefficients or dry friction forces, and of the entries of
        M⁻¹ if M is not constant and diagonal.
        """
        return self.over_mass(self.forces)

    @cached_property
    def forces(self) -> Row:
        """M q″, in the symbols of friction coefficients or dry friction forces."""
        rows = list(self.pull)
        for it in self.with_sticking:
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
        """Whether M has entries off its diagonal, or depends on the coordinates."""
        model = self.model
        return not model.mass.is_diagonal() or model.mass.has(*model.coordinates)

    @cached_property
    def inverse(self) -> Matrix:
        """M⁻¹ as a symmetric matrix of symbols."""
        n = len(self.model.coordinates)
        return Matrix(
            n, n, lambda i, j: Symbol(f"_inverse_{min(i, j) + 1}{max(i, j) + 1}", real=True)
        )

    @cached_property
    def acceleration_symbols(self) -> Symbols:
        """Symbols of the accelerations."""
        return tuple(
            Symbol(acceleration_of(symbol), real=True) for symbol in self.model.coordinates
        )

    @cached_property
    def solved(self) -> Names:
        """Meanings of the symbols of accelerations and of M⁻¹, if derivatives use these symbols."""
        named = dict(zip(self.acceleration_symbols, self.accelerations, strict=True))
        return {**self.inverted, **named} if self.is_coupled or self.model.holds else {}

    @cached_property
    def inverted(self) -> Names:
        """Meanings of the symbols of M⁻¹: cofactors over the determinant.

        Derivatives are written with M⁻¹, so that the inverse is never differentiated.
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

    def slopes(self, symbol: Symbol, friction_slopes: Row | None = None) -> Row:
        """Derivatives of the accelerations by a coordinate, a rate or a parameter.

        M ∂q″ = ∂forces − ∂M q″, with given ``friction_slopes`` or those of
        :meth:`friction_slopes`.
        """
        friction_slopes = friction_slopes or self.friction_slopes(symbol)
        if not self.is_coupled:
            return tuple(
                self.derivative(row, symbol, friction_slopes) for row in self.accelerations
            )
        model = self.model
        mass_change = model.mass.applyfunc(
            lambda entry: model.tidy(model.derivative(entry, symbol))
        ) * Matrix(self.acceleration_symbols)
        pulls = Matrix([self.derivative(row, symbol, friction_slopes) for row in self.forces])
        return tuple(self.inverse * (pulls - mass_change))

    def friction_slopes(self, symbol: Symbol) -> Row:
        """Derivatives of every friction coefficient, or dry friction force, by a symbol.

        Of several frictions those that are not 0 are symbols; :meth:`slope_names` has their
        meanings.
        """
        slopes = tuple(self.friction_slope(it, symbol) for it in self.model.frictions)
        if len(slopes) < 2:
            return slopes
        return tuple(
            slope if slope == 0 else self._slope_symbol(it, symbol)
            for it, slope in zip(self.model.frictions, slopes, strict=True)
        )

    def _slope_symbol(self, friction: FrictionForce, symbol: Symbol) -> Symbol:
        return Symbol(f"_turn_{friction.name}_{symbol}", real=True)

    def slope_names(self, symbols: Symbols) -> Names:
        """Meanings of the symbols in :meth:`friction_slopes`."""
        if len(self.model.frictions) < 2:
            return {}
        return {
            self._slope_symbol(it, symbol): self.friction_slope(it, symbol)
            for symbol in symbols
            for it in self.model.frictions
        }

    def friction_slope(self, friction: FrictionForce, symbol: Symbol) -> Expr:
        """The derivative of a friction coefficient, or of a dry friction force, by a symbol."""
        mu = self.coefficients[friction.mu]
        if friction.holds is None:
            return self.model.derivative(mu, symbol)
        slipping = self.model.derivative(mu * friction.normal.rubbing, symbol)
        return (1 - friction.stuck) * slipping + friction.stuck * self.sticking_slope(
            friction, symbol
        )

    def sticking_slope(self, friction: FrictionForce, symbol: Symbol) -> Expr:
        """The derivative of the constraint force of sticking by a symbol."""
        without_sticking = tuple(
            S.Zero
            if it in self.with_sticking
            else self.model.derivative(self.coefficients[it.mu], symbol)
            for it in self.model.frictions
        )
        accelerations = self.slopes(symbol, without_sticking)
        changes = tuple(
            self.model.derivative(self.rate(self.slip(it), self.acceleration_symbols), symbol)
            - sum(a * b for a, b in zip(self.along(it), accelerations, strict=True))
            for it in self.with_sticking
        )
        slipping = tuple(
            self.model.derivative(self.coefficients[it.mu] * it.normal.rubbing, symbol)
            for it in self.with_sticking
        )
        return self.sticking_force(friction, changes, slipping)

    def derivative(self, expression: Expr, symbol: Symbol, friction_slopes: Row) -> Expr:
        """The derivative of an expression by a coordinate, a rate or a parameter, with given
        derivatives of the friction coefficients or dry friction forces.
        """
        model = self.model
        through_friction = (
            diff(expression, one.unknown if one in self.with_sticking else one.mu) * turn
            for one, turn in zip(model.frictions, friction_slopes, strict=True)
        )
        return model.tidy(model.derivative(expression, symbol) + Add(*through_friction))

    # ---------------------------------------------------------------------------------------------
    # energy

    @cached_property
    def stored(self) -> Expr:
        """Total energy: kinetic energy, potential, applied forces with a potential, and contacts.

        It is differentiated; :meth:`energy` has the same value and is evaluated.
        """
        model = self.model
        springs = zip(model.lines, model.stiffnesses, strict=True)
        at_rest = Add(*(k * line.rest**2 / 2 for line, k in springs))
        return model.kinetic + model.potential + at_rest - self.work + self._stored_in_contacts

    @cached_property
    def energy(self) -> Expr:
        """Total energy, with springs as k (l − r)²/2: this loses no digits where they are hardly
        deformed, as terms of l² = dx² + dy² and l would.
        """
        model = self.model
        springs = zip(model.lines, model.stiffnesses, strict=True)
        strained = Add(*(k * (line.l - line.rest) ** 2 / 2 for line, k in springs))
        without = expanded(model.potential - model.elastic_energy)
        return model.kinetic + without + strained - self.work + self._stored_in_contacts

    @cached_property
    def strain_energy(self) -> Expr:
        """Energy of springs, torsion springs, contact and the page's potentials, without the
        applied forces.
        """
        return self.energy - self.model.kinetic + self.work

    @cached_property
    def _stored_in_contacts(self) -> Expr:
        """The energy of all contacts that touch, with PUSHING."""
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
        """Minus a potential of the applied forces: integrals over one coordinate after the other,
        each of the force that earlier ones do not give.
        """
        model = self.model
        total = S.Zero
        for symbol, _, force in model.moved:
            integral = sp.integrate(expanded(force - diff(total, symbol)), symbol)
            # A force without one integral for all parameters, as sin(η b), whose integral has
            # another form at η = 0, is counted in applied_power.
            if not integral.has(sp.Piecewise, sp.Integral):
                total += integral
        return expanded(total)

    @cached_property
    def applied_power(self) -> Expr:
        """Power of the applied forces that have no potential."""
        work = self.work
        powers = ((force - diff(work, q)) * rate for q, rate, force in self.model.moved)
        return expanded(Add(*powers))

    @cached_property
    def clock_power(self) -> Expr:
        """Rate at which the clock changes the energy, by spring ends, gaps and forces that follow
        it; 0 without a clock.
        """
        model = self.model
        return (
            S.Zero
            if model.clock is None
            else model.derivative(self.stored, model.clock) * model.rates[-1]
        )

    def friction_force(self, friction: FrictionForce) -> Expr:
        """The force of a friction, in its coefficient; for dry friction its symbol."""
        if friction.along == 0:
            return S.Zero
        return (
            friction.unknown
            if friction in self.with_sticking
            else friction.mu * friction.normal.rubbing
        )

    @cached_property
    def damper_power(self) -> Expr:
        """Power of all dampers; never positive, unless the clock moves an end of one."""
        model = self.model
        if model.clock is None:
            return -2 * model.dissipation
        return -Add(*(diff(model.dissipation, rate) * rate for _, rate, _ in model.moved))

    @cached_property
    def outputs(self) -> dict[str, Expr]:
        """Forces, energy and power in a regime, by name, in the symbols of friction coefficients or
        dry friction forces.
        """
        model = self.model
        forces = {it: self.friction_force(it) for it in model.frictions if it.along != 0}
        rubbing = Add(*(force * it.rate for it, force in forces.items()))
        powers = rubbing + self.damper_power + self.applied_power + self.clock_power
        pressed = [it.normal for it in forces]
        found: dict[str, Expr] = {}
        for contact in model.contacts:
            if contact.gap is not None or contact in pressed:
                found[f"force.normal{contact.name and f'.{contact.name}'}"] = contact.force
        for it, force in forces.items():
            found[f"force.friction{it.name and f'.{it.name}'}"] = force
        for count, (line, k) in enumerate(zip(model.lines, model.stiffnesses, strict=True), 1):
            if k != 0:
                found[f"force.spring{count}"] = k * (line.l - line.rest)
        return found | {"energy": self.energy, "power": powers}

    def balances(self) -> bool:
        """Whether the rate of the energy is the sum of the powers, by exact algebra for all states:
        a check of the equations of motion.
        """
        model = self.model
        change = S.Zero
        for symbol, rate, pull in zip(model.coordinates, model.rates, self.pull, strict=True):
            if symbol != model.clock:
                change += model.derivative(self.stored, symbol) * rate + rate * pull  # vᵀ M q″
        rubbing = Add(*(one.mu * one.normal.rubbing * one.rate for one in model.frictions))
        powers = rubbing + self.damper_power + self.applied_power
        waves, circles = model.circles(sp.Tuple(change, powers))
        return equal(change.xreplace(waves), powers.xreplace(waves), circles)

    # ---------------------------------------------------------------------------------------------
    # borders

    @cached_property
    def borders(self) -> Row:
        """Functions whose zeros are the kinks of the field: the border of every contact, then every
        sliding speed; 1 where there is none.
        """
        contacts = [S.One if it.border is None else it.border for it in self.model.contacts]
        slips = [S.One if it.along == 0 else laws.slip(it) for it in self.model.frictions]
        return (*contacts, *slips)

    @cached_property
    def curved(self) -> bool:
        """Whether a border is a nonlinear function of the coordinates and rates."""
        model = self.model
        return any(
            not sp.hessian(border, (*model.coordinates, *model.rates)).is_zero_matrix
            for border in self.borders
        )

    def rate(self, expression: Expr, accelerations: Symbols) -> Expr:
        """The derivative by time of an expression in coordinates and rates."""
        model = self.model
        changes = zip(
            (*model.coordinates, *model.rates), (*model.rates, *accelerations), strict=True
        )
        return Add(*(model.derivative(expression, symbol) * value for symbol, value in changes))

    # ---------------------------------------------------------------------------------------------
    # arguments of the generated functions

    @property
    def variables(self) -> Symbols:
        """Coordinates and rates."""
        return (*self.model.coordinates, *self.model.rates)

    @property
    def moving(self) -> Symbols:
        """Coordinates, rates and parameters."""
        return (*self.variables, *self.model.arguments)

    @property
    def accelerated(self) -> Symbols:
        """Coordinates, rates, accelerations and parameters."""
        return (*self.variables, *self.acceleration_symbols, *self.model.arguments)

    @property
    def sides(self) -> Symbols:
        """The symbols SIDE of all frictions."""
        return tuple(friction.side for friction in self.model.frictions)

    @property
    def ways(self) -> Symbols:
        """Symbols that say on which branch each torsion angle is continued."""
        return tuple(torsion.way for torsion in self.model.torsions)

    @property
    def regime(self) -> Symbols:
        """Arguments of functions in a regime: state, parameters, contact indicators, slip
        directions and the switches of exponential layers (:func:`.laws.near`).
        """
        near = (factor for friction in self.model.frictions for factor in laws.near(friction))
        return (*self.moving, *self.model.pushings, *self.sides, *near)

    @cached_property
    def shorthands(self) -> Names:
        """Meanings of the symbols in the accelerations."""
        own = {**directions(self.model), **self.model.depths}
        return {**own, **self.coefficients, **self.dry_friction, **self.solved}

    def smooth(
        self, name: str, summary: str, results: Results, returns: str, by: Symbols = ()
    ) -> Function:
        """A generated function in a regime, which is smooth beyond the borders too.

        ``by`` has the symbols by which the results are derivatives.
        """
        continued = {torsion.phi: torsion.continued for torsion in self.model.torsions}
        names = self.shorthands | continued | self.slope_names(by)
        return of_page(name, summary, (*self.regime, *self.ways), results, returns, names)

    def rows_by(self, rows: Row, symbols: Symbols) -> tuple[Row, ...]:
        """Derivatives of rows in a regime: one tuple a row, with an entry for each symbol."""
        by_friction = [(symbol, self.friction_slopes(symbol)) for symbol in symbols]
        return tuple(
            tuple(self.derivative(row, symbol, turn) for symbol, turn in by_friction)
            for row in rows
        )


def _jacobian(motion: Motion, symbols: Symbols) -> tuple[Row, ...]:
    """Derivatives of the accelerations: one tuple an acceleration, with an entry a symbol."""
    return tuple(zip(*(motion.slopes(symbol) for symbol in symbols), strict=True))


def _sticking_slopes(motion: Motion, symbols: Symbols) -> tuple[Row, ...]:
    """Derivatives, for every dry friction, of the sliding speed and of both margins while it
    sticks.
    """
    found = []
    for it in motion.with_sticking:
        rows = motion.slip(it), *motion.margins(it, it.unknown)
        friction_slopes = {
            symbol: tuple(
                motion.sticking_slope(it, symbol) if one is it else S.Zero
                for one in motion.model.frictions
            )
            for symbol in symbols
        }
        found += [
            tuple(motion.derivative(row, symbol, turn) for symbol, turn in friction_slopes.items())
            for row in rows
        ]
    return tuple(found)


def directions(model: Mechanics) -> Names:
    """Lengths and directions of all lines, and torsion angles, in coordinates."""
    found: Names = {}
    for line in model.lines:
        found |= {line.l: line.length, line.c: line.dx / line.l, line.s: line.dy / line.l}
    return found | {torsion.phi: torsion.least for torsion in model.torsions}


def outputs(model: Mechanics) -> Module:
    """The generated module of forces, energy and power of a motion, with their derivatives."""
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
    """The generated module of the equations of motion.

    Raises
    ------
    ArithmeticError
        If the energy does not balance: the derivation contradicts itself.
    """
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
            _jacobian(motion, motion.variables),
            "((∂q_1″/∂q_1, …, ∂q_1″/∂v_1, …), …)",
            motion.variables,
        ),
        smooth(
            "regime_by_parameters",
            "Derivatives of regime_rhs by all parameters, an angle as the angle.",
            _jacobian(motion, parameters),
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
            tuple(motion.rate(layer, motion.acceleration_symbols) for layer in layers),
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
                tuple(motion.rate(border, motion.acceleration_symbols) for border in turnings),
                "rates of (b_1, …)",
            ),
        ]
    if model.holds:
        margins = (motion.margins(it, motion.constraint(it)) for it in motion.with_sticking)
        functions += [
            smooth(
                "grip",
                "How far the force of friction that holds is from its limits, with the belt and "
                "against it: positive while it sticks.",
                tuple(itertools.chain.from_iterable(margins)),
                "(ahead, behind)" if len(motion.with_sticking) < 2 else "(ahead_1, behind_1, …)",
            ),
            smooth(
                "grip_slopes",
                "Derivatives of the sliding speed, and of these while it sticks, by coordinates, "
                "rates and all parameters.",
                _sticking_slopes(motion, (*motion.variables, *parameters)),
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
    """The right-hand side at any state, kinked at the borders."""
    model = motion.model
    signs = Names()
    for contact, border in zip(model.contacts, motion.borders, strict=False):
        below = Symbol(f"_below{contact.name and '_'}{contact.name}", real=True)
        # A law that is no polynomial may have no slope at its border, as a root: that is lift-off.
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
    """The generated functions of the borders and of their rates."""
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
            tuple(motion.rate(border, motion.acceleration_symbols) for border in motion.borders),
            f"rates of {gaps}",
        ),
    )
