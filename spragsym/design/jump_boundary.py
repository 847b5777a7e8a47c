"""A point on the border of what jumps, brought to the nearest one of its sheet of folds, to the last digits."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.optimize import minimize

from ..generated import catastrophe as _catastrophe
from ..parameters import NAMES, FloatArray
from ..statics import kernel
from .design_space import Space


def on_fold(space: Space, z: FloatArray, theta: float, fixed: dict[str, float]) -> FloatArray | None:
    """The z of smallest size with f = f′ = 0 near a given one; ``fixed`` parameters stay at their values. None if there is none.

    Sequential quadratic programming (SciPy's SLSQP) with exact derivatives of f and f′, over z and θ.
    """

    def here(v: FloatArray) -> tuple[dict[str, Any], FloatArray]:
        return space.parameters(v[:-1]) | fixed, np.array([np.cos(v[-1]), np.sin(v[-1])])

    def residuals(v: FloatArray) -> FloatArray:
        values, (c, s) = here(v)
        trig = _trig(values)
        return np.array([kernel.f(c, s, *trig), kernel.f_slope(c, s, *trig)], dtype=float) * weight

    def slopes(v: FloatArray) -> FloatArray:
        values, (c, s) = here(v)
        trig = _trig(values)
        along = space.slopes(v[:-1])
        for name in fixed:
            along[NAMES.index(name)] = 0.0
        pairs = np.array(
            _catastrophe.unfolding(c, s, np.cos(values["theta0"]), np.sin(values["theta0"]), *(values[n] for n in NAMES[1:])),
            dtype=float,
        )
        by_theta = np.array([kernel.f_slope(c, s, *trig), kernel.f_curvature(c, s, *trig)], dtype=float)
        return np.column_stack([pairs.T @ along, by_theta]) * weight

    start = np.append(z, theta)
    weight = 1.0
    weight = 1.0 / max(float(np.abs(slopes(start)).max()), 1e-300)
    low, high = space.limits()
    bounds = [*zip(low, high, strict=True), (1e-9, np.pi - 1e-9)]
    with np.errstate(all="ignore"):
        found = minimize(
            lambda v: 0.5 * float(v[:-1] @ v[:-1]), start, jac=lambda v: np.append(v[:-1], 0.0), method="SLSQP", bounds=bounds,
            constraints=[{"type": "eq", "fun": residuals, "jac": slopes}], options={"maxiter": 100, "ftol": 1e-15},
        )  # fmt: skip
    good = np.isfinite(found.x).all() and float(np.abs(residuals(found.x)).max()) < 1e-9
    return np.asarray(found.x[:-1]) if good else None


def _trig(values: dict[str, Any]) -> tuple[Any, ...]:
    others = (values[name] for name in NAMES[1:])
    return tuple(kernel.f_coefficients(np.cos(values["theta0"]), np.sin(values["theta0"]), *others, 1))
