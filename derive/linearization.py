"""Generated linearization of a model about steady sliding: M q″ + (C + G) q′ + K q = 0."""

import sympy as sp
from sympy import Matrix

from . import laws
from .emit.function import Module, of_page, rows
from .mechanics import Mechanics, named, on


def damping(model: Mechanics) -> Matrix:
    """The damping matrix C: the dampers, and the slope of the friction law at the sliding speed of
    the belt.
    """
    still = dict.fromkeys(model.rates, sp.S.Zero)
    C = Matrix(model.resistance).jacobian(model.rates)
    for friction in model.frictions:
        mu = laws.smooth_friction(friction, felt=True).subs(friction.side, 1)
        slopes = Matrix([friction.along]).jacobian(model.coordinates).T
        C -= friction.normal.rubbing * slopes * Matrix([mu]).jacobian(model.rates)
    return C.subs(still).applyfunc(model.tidy)


def module(model: Mechanics) -> Module:
    """The generated module of the linearization."""
    places = (*model.coordinates, *model.arguments)
    state = (*model.coordinates, *model.directions, *model.arguments, *model.pushings)
    functions = [
        of_page(
            "mass_matrix", "M of the kinetic energy.", places, rows(model.mass), "((M_11, …), …)"
        ),
        of_page(
            "damping",
            "C: dampers, and the slope of the friction law at steady sliding.",
            state,
            rows(damping(model)),
            "((C_11, …), …)",
            model.depths,
        ),
    ]
    if not model.gyroscopic.is_zero_matrix:
        functions.append(
            of_page(
                "gyroscopic",
                "G of a kinetic energy with terms linear in the rates: antisymmetric.",
                places,
                rows(model.gyroscopic),
                "((G_11, …), …)",
            )
        )
    for friction in model.frictions:
        functions += [
            of_page(
                named("friction_slope", friction),
                f"Slope of the friction law{on(friction)} at steady sliding, by the sliding speed.",
                model.arguments,
                laws.slope_at_rest(friction),
                "dμ/dv",
            ),
            of_page(
                named("friction_slope_by_sizes", friction),
                "The slope as a sum of c exp(a), over each of its exponentials.",
                model.arguments,
                laws.slope_by_sizes(friction),
                "(((c, a), …), …)",
            ),
        ]
    return Module(
        "linearization",
        "Small deviations from steady sliding: mass matrix and damping; the stiffness is "
        "statics.forces_jacobian.",
        tuple(functions),
    )
