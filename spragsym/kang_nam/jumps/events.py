"""Test of whether the reference state has jumped at the friction of each of many points, without the place of the jump.

Along the surface f = 0 is μ₀ a function of θ, since f is linear in it, and a fold is where that has no slope. Let θ₁ be the
first equilibrium at μ₀ beyond the state without friction. If nothing has jumped, μ₀(θ) rises all the way between the two; and if
it rises all the way, nothing has. So one polynomial's signs between two directions decide, and no fold need be found.
"""

import math
from collections.abc import Mapping

import numpy as np

from ...design.jumps import FROM_LOWER_END
from ...models.parameters import NAMES, FloatArray, Parameters
from ...numerics import bernstein
from ...numerics.affine import UNIT
from ...numerics.interval_arrays import IndexArray
from ...questions import NotInClosedForm
from ...results.equilibria import Stability
from ..folds.fold_arrays import friction_sextic
from ..quartic.solver import equilibria
from .jump_values import BLOCK, first_jumps, require_usual, small

#: Radians between an equilibrium and the state without friction below which float64 does not say which comes first.
_NEAR = 1e-9


def have_jumped(
    p: Parameters, vary: str | None = None, begin: float | FloatArray | None = None, *, hasty: bool = False
) -> FloatArray:
    """The closed form of :func:`spragsym.design.jumps.have_jumped` as friction or inclination rises; quick everywhere.

    Notes
    -----
    Source: f′ f_μ₀ − f f_μ₀′, in which μ₀ cancels; it is negative where μ₀(θ) rises. Points that its signs do not decide, and
    all along θ₀, are asked by :func:`spragsym.kang_nam.jumps.jump_values.first_jumps`.
    """
    vary = vary or "mu0"
    require_usual(p, vary, begin)
    if vary not in FROM_LOWER_END:
        raise NotInClosedForm
    p.require("theta0", "mu0")
    if vary == "theta0":
        limit = np.broadcast_to(p.theta0, p.shape)
        found = first_jumps(p, vary, apart_from=limit)
        out = np.where(found.value <= limit, 1.0, 0.0)
        out.reshape(-1)[list(found.reasons)] = np.nan
        return out
    size = math.prod(p.shape)
    given = {name: np.broadcast_to(getattr(p, name), p.shape).reshape(-1) for name in NAMES}
    out = np.zeros(size)
    for begin in range(0, size, BLOCK):
        part = {name: column[begin : begin + BLOCK] for name, column in given.items()}
        yes, left = _decided(part)
        if left.size:
            some = {name: column[left] for name, column in part.items()}
            found = first_jumps(Parameters(**some), "mu0", apart_from=some["mu0"])
            yes[left] = found.value <= some["mu0"]
            yes[left[list(found.reasons)]] = np.nan
        out[begin : begin + BLOCK] = yes
    return out.reshape(p.shape)


def _decided(given: Mapping[str, FloatArray]) -> tuple[FloatArray, IndexArray]:
    """1 for points that have jumped, else 0, and those of which the signs do not tell."""
    bare = equilibria(Parameters(**{**given, "mu0": np.zeros_like(given["mu0"])}))
    full = equilibria(Parameters(**given))
    slot = small(bare)[:, None]
    first, error = (np.take_along_axis(one, slot, axis=-1) for one in (bare.theta, bare.error))
    kind = np.take_along_axis(bare.stability, slot, axis=-1)
    off = full.theta - first
    with np.errstate(invalid="ignore"):
        later = np.where(off > 0, full.theta, np.inf).min(axis=-1)
        near = (np.abs(off) <= _NEAR).any(axis=-1)
        clear = ~near & (kind[:, 0] == Stability.STABLE)
    clear &= np.isfinite(later) & bare.decided & full.decided & ~bare.fold & ~full.fold
    ends = [_place(np.where(clear, angle, 1.0)) for angle in (first[:, 0], later)]
    # An error is one over max(1, θ), and dw/dθ is less than 1; a few units in the last place are the rounding of w.
    off = np.where(clear, 4.0 * np.maximum(error[:, 0], np.nan_to_num(full.error, nan=0.0).max(axis=-1)), 0.0) + 8 * UNIT
    signs = bernstein.signs_between(friction_sextic(given), ends[0], np.maximum(*ends), off)
    # Where it falls at the beginning the state moves the other way as the friction rises.
    clear &= signs.at_low < 0
    left = ~(clear & (signs.negative | signs.positive)) & (given["mu0"] > 0)
    return np.where(clear & signs.positive, 1.0, 0.0), np.flatnonzero(left)


def _place(theta: FloatArray) -> FloatArray:
    """w = t/(t + τ) with t = tan(θ/2)."""
    s, c = np.sin(0.5 * theta), np.cos(0.5 * theta)
    return np.asarray(s / (s + bernstein.SCALE * c))
