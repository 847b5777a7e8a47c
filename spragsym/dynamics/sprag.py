"""The field of the article's model, (8)–(11), over the modes (contact, side, near).

``contact`` is 1 in contact and 0 without; ``side`` is 1 where the belt is ahead of the mass and −1 where it is behind;
``near`` is 1 where the exponential of (10) is felt and 0 where it is left out.
"""

from __future__ import annotations

import inspect
import itertools
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

from ..generated import motion
from .field import GAP, WIDTH, Border, Field, Mode

#: Accelerations and their derivatives in one mode, continued beyond its borders: for scalars, without checks.
acceleration: Any = inspect.unwrap(motion.regime_rhs)
jacobian: Any = inspect.unwrap(motion.regime_jacobian)
_by_parameters: Any = inspect.unwrap(motion.regime_by_parameters)


class Damped:
    """A namespace whose exponential is multiplied by the mode's ``near``."""

    def __init__(self, xp: Any, near: Any) -> None:
        self.sqrt, self.exp = xp.sqrt, lambda z: near * xp.exp(z)


def _call(function: Any, state: Sequence[Any], constants: Sequence[Any], mode: Sequence[Any], xp: Any) -> Any:
    nbar, side, near = mode
    return function(*state, *constants, nbar, side, xp=Damped(xp, near))


def _layer(reach: float) -> Border:
    """The layer about x' = V in which the exponential of (10) is felt."""

    def depth(state: Any, constants: Any, mode: Any) -> Any:
        return constants[8] * mode[1] * (constants[7] - state[2])

    return Border(
        "layer",
        lambda q, c, mode: depth(q, c, mode) - reach - WIDTH * mode[2],
        lambda _, a, c, mode: -c[8] * mode[1] * a[0],
        lambda mode: 1 - 2 * mode[2],
        lambda mode: (*mode[:2], 1 - mode[2]),
        kink=False,
        # heyoka's error is relative to the largest of the states and of these: it must not be one of these.
        watched=lambda q, c, mode: 1e-3 * ((depth(q, c, mode) - WIDTH * mode[2]) / reach - 1),
    )


def _initial_mode(reach: float) -> Callable[..., Mode]:
    def mode(state: Sequence[Any], constants: Sequence[Any]) -> Any:
        _, y, vx, _ = state
        V, d = constants[-2:]
        return 1 * (y <= 0), 2 * (vx <= V) - 1, 1 * (d * abs(V - vx) <= reach)

    return mode


_CONTACT = Border(
    "y = 0", lambda q, *_: q[1], lambda q, *_: q[3], lambda mode: 1 - 2 * mode[0], lambda mode: (1 - mode[0], *mode[1:]),
    crossings=("contact_lost", "contact_regained"), watched=lambda q, _, mode: q[1] + GAP * (1 - 2 * mode[0]),
)  # fmt: skip
_SLIP = Border(
    "x' = V", lambda q, c, _: c[7] - q[2], lambda _, a, *__: -a[0], lambda mode: mode[1],
    lambda mode: (mode[0], -mode[1], mode[2]),
    crossings=("belt_overtakes", "mass_overtakes"), watched=lambda q, c, mode: 1e-3 * (c[7] - q[2] + GAP * mode[1]),
)  # fmt: skip


def _no_check(name: str, value: float) -> None:
    """Arguments are checked where problems are made."""


@cache
def field(reach: float) -> Field:
    """The field whose exponential is left out where it is below exp(−reach)."""
    return Field(
        "kang_nam", ("x", "y"), ("theta0", "mu0", "kappa", "alpha", "sigma", "beta", "V", "d"), tuple,
        lambda q, c, mode, xp: _call(acceleration, q, c, mode, xp),
        lambda q, c, mode, xp: _call(jacobian, q, c, mode, xp),
        lambda q, c, mode, xp: _call(_by_parameters, q, c, mode, xp),
        (_CONTACT, _SLIP, _layer(reach)), _initial_mode(reach),
        tuple(itertools.product((1, 0), (1, -1), (1, 0))), _no_check, lambda *_: None, columns=True,
    )  # fmt: skip
