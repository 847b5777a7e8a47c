"""Generated statics of a model: the balance of forces F(q) = 0 at steady sliding or in lift-off,
with its derivatives by coordinates and parameters.
"""

from functools import partial

import sympy as sp
from sympy import Matrix

from .algebra import Row, Symbols, expanded
from . import laws, balance_rows, symmetry
from .emit.function import Function, Module, of_page, rows
from .mechanics import FrictionForce, Mechanics, NormalForce, named, number, on


def parameters(model: Mechanics) -> Symbols:
    """The parameters in the balance of forces."""
    parts = [part for line in model.lines for part in (line.dx, line.dy, line.rest)]
    parts += model.depths.values()
    parts += [
        part
        for torsion in model.torsions
        for part in (torsion.cosine, torsion.sine, torsion.stiffness)
    ]
    used = sp.Tuple(*model.residuals, *parts).free_symbols
    return tuple(
        symbol for symbol in map(number, model.parameters) if used & set(model.parts(symbol))
    )


def arguments(model: Mechanics) -> Symbols:
    """Arguments of functions for these parameters, an angle as cosine and sine."""
    return tuple(part for symbol in parameters(model) for part in model.parts(symbol))


def jacobian(model: Mechanics) -> tuple[Row, ...]:
    """The stiffness matrix K: derivatives of the residuals by the coordinates."""
    return tuple(
        tuple(model.tidy(model.derivative(row, symbol)) for symbol in model.coordinates)
        for row in model.residuals
    )


def by_parameters(model: Mechanics, residuals: Row) -> tuple[Row, ...]:
    """Derivatives of rows by the parameters, then by the friction coefficients."""
    return tuple(
        tuple(
            _shortest(model, model.tidy(model.derivative(row, symbol)))
            for symbol in (*parameters(model), *model.coefficients)
        )
        for row in residuals
    )


def _shortest(model: Mechanics, expression: sp.Expr) -> sp.Expr:
    """An expression with dx = c l and dy = s l inserted where that makes it shorter, so that its
    intervals are narrower.
    """
    for line in model.lines:
        for part, along in ((line.dx, line.c * line.l), (line.dy, line.s * line.l)):
            other = sp.factor_terms(sp.expand(expression).subs(sp.expand(part), along))
            expression = min(expression, other, key=lambda form: len(form.free_symbols))
    return expression


def module(model: Mechanics) -> Module:
    """The generated module of statics."""
    variables = (*model.coordinates, *arguments(model))
    state = (
        *model.coordinates,
        *model.directions,
        *model.turned,
        *arguments(model),
        *model.coefficients,
        *model.pushings,
    )
    shorthands = {**model.depths, **{line.l: line.length for line in model.lines}}
    mirror = symmetry.mirror(model)
    function = partial(of_page, shorthands=shorthands)
    K, T, F = Matrix(jacobian(model)), balance_rows.sums(model), Matrix(model.residuals)
    summed = tuple(map(expanded, T * F))
    constant = not T.has(*model.coordinates)
    changes = Matrix.hstack(*(T.diff(symbol) * F for symbol in model.coordinates))
    slopes = (T * K + changes).applyfunc(model.tidy)
    alone = balance_rows.without_coordinates(model, summed, slopes)
    cancelled = []
    if not T.is_Identity:
        cancelled.append("springs between coordinates" if constant else "contacts that turn")
    if alone:
        cancelled.append("coordinates, where none balances the rest,")
    others = [1 - sum(factor for factor, _ in alone.get(i, ())) for i in range(len(summed))]
    turned = " A torsion spring adds k φ (c ∂dy − s ∂dx)/l." if model.torsions else ""
    functions = [
        function(
            "geometry",
            "The vector from the mass's end of every spring to its anchor, and its "
            "undeformed length.",
            variables,
            tuple((line.dx, line.dy, line.rest) for line in model.lines),
            "((dx, dy, rest), …)",
        ),
        *(
            function(
                named("contact_gap", contact),
                _border(contact),
                variables,
                contact.border or contact.gap or sp.S.Zero,
                "minus N" if contact.either_face else "gap",
            )
            for contact in model.contacts
        ),
        function(
            "mirror",
            'The image of a state in the model\'s mirror, if it has one: see "mirror" in '
            "model.json.",
            variables,
            tuple(mirror.images.get(q, q) for q in model.coordinates),
            "image",
        ),
        *(it for friction in model.frictions for it in _friction(model, friction)),
    ]
    if model.torsions:
        functions += [
            function(
                "turnings",
                "Cosine and sine of the turning φ of every torsion spring: φ in (−π, π].",
                (*model.coordinates, *model.directions, *arguments(model)),
                tuple((torsion.cosine, torsion.sine) for torsion in model.torsions),
                "((cos φ_1, sin φ_1), …)",
            ),
            function(
                "torsions",
                "The stiffness of every torsion spring.",
                variables,
                tuple(torsion.stiffness for torsion in model.torsions),
                "(k_1, …)",
            ),
        ]
    functions += [
        function(
            "forces",
            "Minus the sum of forces along each coordinate.",
            state,
            model.residuals,
            "(F_1, …)",
        ),
        function(
            "stiffnesses",
            "The stiffness of every spring.",
            variables,
            model.stiffnesses,
            "(k_1, …)",
        ),
        function(
            "spring_forces",
            "The tension of every spring, negative where it pushes.",
            variables,
            tuple(
                k * (line.l - line.rest)
                for k, line in zip(model.stiffnesses, model.lines, strict=True)
            ),
            "(T_1, …)",
        ),
        *(
            function(
                named("contact_force", contact),
                f"The normal force of the contact{contact.name and f' {contact.name}'}.",
                (*model.coordinates, *model.arguments, contact.pushing),
                contact.force,
                "N",
            )
            for contact in model.contacts
        ),
        function(
            "forces_apart",
            "The forces without those springs; each adds its tension times (c ∂dx + s "
            f"∂dy).{turned}",
            state,
            model.residuals_apart,
            "(F_1, …)",
        ),
        function(
            "forces_jacobian",
            "K: derivatives of the forces by the coordinates, directions following.",
            state,
            rows(K),
            "((∂F_1/∂q_1, …), …)",
        ),
        function(
            "forces_by_parameters",
            "Derivatives of the forces by the parameters, an angle as the angle, and by mu.",
            state,
            by_parameters(model, model.residuals),
            "((∂F_1/∂p_1, …, ∂F_1/∂mu), …)",
        ),
    ]
    if cancelled:
        functions += [
            function(
                "balance",
                f"Sums of the forces, in which those of {' and of '.join(cancelled)} cancel.",
                state,
                tuple(
                    sum((factor * total for factor, total in alone.get(i, ())), others[i] * row)
                    for i, row in enumerate(summed)
                ),
                "(F_1, …)",
            ),
            function(
                "balance_jacobian",
                "Their derivatives by the coordinates: the same sums of the rows of K.",
                state,
                rows(sp.diag(*others) * slopes),
                "((∂F_1/∂q_1, …), …)",
            ),
        ]
    if not constant:
        # Continuation in a parameter uses these rows, in which no stiff terms cancel.
        functions.append(
            function(
                "balance_by_parameters",
                "Their derivatives by the parameters, an angle as the angle, and by mu.",
                state,
                by_parameters(model, summed),
                "((∂F_1/∂p_1, …, ∂F_1/∂mu), …)",
            )
        )
    if not model.gyroscopic.is_zero_matrix:
        # With gyroscopic forces, eigenvalues come in pairs ±λ if K is symmetric.
        functions.append(
            function(
                "circulatory",
                "K − Kᵀ: what friction and forces without a potential bring.",
                state,
                rows((K - K.T).applyfunc(model.tidy)),
                "((0, K_12 − K_21, …), …)",
            )
        )
    return Module(
        "statics",
        "The balance of forces at steady sliding (pushing = 1) and in lift-off (pushing = 0).",
        tuple(functions),
    )


def _border(contact: NormalForce) -> str:
    if contact.either_face:
        return f"Minus the normal force{on(contact)}: the mass is on the opposite face where > 0."
    return f"The gap{on(contact)}: contact where it is not positive."


def _friction(model: Mechanics, friction: FrictionForce) -> list[Function]:
    """The generated functions of one friction coefficient."""
    at_rest = laws.friction_at_rest(friction)
    slopes = (model.derivative(at_rest, symbol) for symbol in map(number, model.parameters))
    found = [
        of_page(
            named("friction_at_rest", friction),
            f"The friction coefficient{on(friction)} at steady sliding.",
            model.arguments,
            at_rest,
            "mu",
        ),
        of_page(
            named("friction_at_speed", friction),
            f"The friction coefficient{on(friction)} at the belt's speed: of a motion that has "
            "come to rest.",
            model.arguments,
            laws.friction_at_speed(friction),
            "mu",
        ),
        of_page(
            named("friction_by_parameters", friction),
            "Its derivatives by all parameters, an angle as the angle.",
            model.arguments,
            tuple(map(model.tidy, slopes)),
            "(∂mu/∂p_1, …)",
        ),
    ]
    if friction.holds is not None:
        found.append(
            of_page(
                named("friction_held", friction),
                "The friction coefficient while it sticks, by the share of the static one that is "
                "used.",
                (*model.arguments, friction.held),
                laws.friction_held(friction),
                "mu",
            )
        )
    return found
