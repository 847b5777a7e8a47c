"""Linearization of any model about steady sliding: M q″ + (C + G) q′ + K q = 0 for small
deviations.
"""

import sympy as sp

from . import laws
from .emit.function import Function, Module, of_page, rows
from .mechanics import FrictionForce, Mechanics, named, on


def damping(model: Mechanics) -> sp.Matrix:
    """C: the dampers, and the slope of the friction law where the belt is faster than the mass,
    which gives its sign.
    """
    still = dict.fromkeys(model.rates, sp.S.Zero)
    C = sp.Matrix(model.resistance).jacobian(model.rates)
    for friction in model.frictions:
        if friction.along is not None:
            mu = laws.smooth_friction(friction, felt=True).subs(friction.side, 1)
            slopes = sp.Matrix([friction.along]).jacobian(model.coordinates).T
            C -= friction.normal.rubbing * slopes * sp.Matrix([mu]).jacobian(model.rates)
    return C.subs(still).applyfunc(model.tidy)


def module(model: Mechanics) -> Module:
    """The generated module."""
    state = (*model.coordinates, *model.directions, *model.arguments)
    return Module(
        "linearization",
        "Small deviations from steady sliding: mass matrix and damping; the stiffness is "
        "statics.forces_jacobian.",
        (
            of_page(
                "mass_matrix",
                "M of the kinetic energy.",
                (*model.coordinates, *model.arguments),
                rows(model.mass),
                "((M_11, …), …)",
            ),
            of_page(
                "damping",
                "C: dampers, and the slope of the friction law at steady sliding.",
                (*state, *model.pushings),
                rows(damping(model)),
                "((C_11, …), …)",
                model.depths,
            ),
            *_gyroscopic(model),
            *(function for friction in model.frictions for function in _slopes(model, friction)),
        ),
    )


def _gyroscopic(model: Mechanics) -> tuple[Function, ...]:
    """G, of a model that has one."""
    if model.gyroscopic.is_zero_matrix:
        return ()
    return (
        of_page(
            "gyroscopic",
            "G of a kinetic energy with terms linear in the rates: antisymmetric.",
            (*model.coordinates, *model.arguments),
            rows(model.gyroscopic),
            "((G_11, …), …)",
        ),
    )


def _slopes(model: Mechanics, friction: FrictionForce) -> tuple[Function, ...]:
    return (
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
    )
