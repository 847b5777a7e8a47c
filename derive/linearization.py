"""Linearization of any model about steady sliding: M q″ + C q′ + K q = 0 for small deviations."""

import sympy as sp

from . import laws
from .emit.function import Module, of_page, rows
from .mechanics import DEPTH, PUSHING, SIDE, Mechanics


def damping(model: Mechanics) -> sp.Matrix:
    """C: the dampers, and the slope of the friction law where the belt is faster than the mass,
    which gives its sign.
    """
    still = dict.fromkeys(model.rates, sp.S.Zero)
    C = sp.Matrix(model.resistance).jacobian(model.rates)
    if model.slide is not None:
        friction = laws.smooth_friction(model, felt=True).subs(SIDE, 1)
        slopes = sp.Matrix([model.slide]).jacobian(model.coordinates).T
        C -= model.normal * slopes * sp.Matrix([friction]).jacobian(model.rates)
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
                (*state, PUSHING),
                rows(damping(model)),
                "((C_11, …), …)",
                {DEPTH: model.depth},
            ),
            of_page(
                "friction_slope",
                "Slope of the friction law at steady sliding, by the sliding speed.",
                model.arguments,
                laws.slope_at_rest(model),
                "dμ/dv",
            ),
            of_page(
                "friction_slope_by_sizes",
                "The slope as a sum of c exp(a), over each of its exponentials.",
                model.arguments,
                laws.slope_by_sizes(model),
                "(((c, a), …), …)",
            ),
        ),
    )
