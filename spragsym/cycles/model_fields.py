"""The field of a loaded model, from the functions that were generated for it."""

from __future__ import annotations

import inspect
import itertools
import math
from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np

from ..errors import ConvergenceError
from ..models.model import Model
from ..parameters import FloatArray, as_number
from .field import Border, Field, Mode
from .sprag import REACH

#: Between leaving out an exponential of the friction law and taking it in again, in units of its exponent.
WIDTH = 5.0


@cache
def field_of(model: Model) -> Field:
    """The field of a model: (contact, side of the belt, one for each exponential of the friction law)."""
    motion, n = model.motion, len(model.coordinates)
    acceleration, jacobian, slopes, levels, rates, layers, layer_rates = (
        inspect.unwrap(getattr(motion, name))
        for name in ("regime_rhs", "regime_jacobian", "regime_by_parameters", "borders", "border_rates", "layers", "layer_rates")
    )
    has_gap = model.about["contact"] is not None and bool(model.about["contact"].get("unilateral"))
    count = int(model.about["layers"])
    angles = {name: (angle, part) for angle, pair in model.about["angles"].items() for part, name in enumerate(pair)}
    order = model.about["arguments"]["motion"]

    def constants(values: Sequence[Any], xp: Any = None) -> tuple[Any, ...]:
        given = dict(zip(model.parameters, values, strict=True))
        functions = (np.cos, np.sin) if xp is None else (xp.cos, xp.sin)
        return tuple(
            (float(functions[angles[name][1]](given[angles[name][0]])) if xp is None else functions[angles[name][1]](
                given[angles[name][0]])) if name in angles else given[name]
            for name in order
        )  # fmt: skip

    def layer(i: int) -> Border:
        def level(q: Any, c: Any, mode: Any) -> Any:
            return (layers(*q, *c, mode[1])[i] - WIDTH * mode[2 + i]) / REACH - 1

        def rate(q: Any, a: Any, c: Any, mode: Any) -> Any:
            return layer_rates(*q, *a, *c, mode[1])[i] / REACH

        def beyond(mode: Mode) -> Mode:
            return (*mode[: 2 + i], 1 - mode[2 + i], *mode[3 + i :])

        return Border(f"layer {i + 1}", level, rate, lambda mode: 1 - 2 * mode[2 + i], beyond, kink=False)

    gap = Border(
        "contact", lambda q, c, _: levels(*q, *c)[0], lambda q, a, c, _: rates(*q, *a, *c)[0], lambda mode: 1 - 2 * mode[0],
        lambda mode: (1 - mode[0], *mode[1:]), crossings=("contact_lost", "contact_regained"),
    )  # fmt: skip
    slip = Border(
        "slip", lambda q, c, _: levels(*q, *c)[1], lambda q, a, c, _: rates(*q, *a, *c)[1], lambda mode: mode[1],
        lambda mode: (mode[0], -mode[1], *mode[2:]), crossings=("belt_overtakes", "mass_overtakes"),
    )  # fmt: skip

    def initial_mode(q: Sequence[float], c: Sequence[float]) -> Mode:
        at = levels(*q, *c)
        contact, side = (int(at[0] <= 0) if has_gap else 1), (1 if at[1] >= 0 else -1)
        return (contact, side, *(int(z <= REACH) for z in layers(*q, *c, side)))

    def check(name: str, value: float) -> None:
        as_number(name, value, model.Parameters.ranges[name])

    def simulate(values: Sequence[float], state: FloatArray, t_end: float, **options: Any) -> Any:
        if not hasattr(model, "simulate"):
            raise ConvergenceError(f"motions of {model.name} are not followed in this version")
        p = model.Parameters(**dict(zip(model.parameters, values, strict=True)))
        start = {f"{name}0": float(value) for name, value in zip((*model.coordinates, *model.rates), state, strict=True)}
        return model.simulate(p, t_end=t_end, **start, **options)

    modes = itertools.product((1, 0) if has_gap else (1,), (1, -1), *[(1, 0)] * count)
    return Field(
        f"model {model.where} {model.about['source']}", model.coordinates, model.parameters, constants,
        lambda q, c, mode, xp=math: acceleration(*q, *c, *mode, xp=xp),
        lambda q, c, mode, xp=math: _rows(jacobian(*q, *c, *mode, xp=xp), n),
        lambda q, c, mode, xp=math: _rows(slopes(*q, *c, *mode, xp=xp), n),
        (*((gap,) if has_gap else ()), slip, *(layer(i) for i in range(count))), initial_mode, tuple(modes), check, simulate,
        lambda mode: (*mode[:2], *[1] * count),
    )  # fmt: skip


def _rows(values: Any, n: int) -> Any:
    """Rows of a matrix."""
    return values if len(values) == n else (values,)
