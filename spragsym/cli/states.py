"""States of any model as rows of a table and of JSON."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

#: What is printed of each state, in front of and behind the columns that say where it is.
WORDS, NUMBERS = ("state", "stability", "undamped"), ("growth", "error")


def rows_of(eq: Any) -> list[dict[str, Any]]:
    """A row for each equilibrium of one point: words, directions and lengths of springs, coordinates, and what is known of them.

    ``stability`` is that with dampers and the slope of the friction law; ``undamped`` is without, as (27).
    """
    import numpy as np

    from ..statics import Stability

    places = {_name(name): (_unit(name), getattr(eq, name)) for name in eq.columns}
    return [
        {
            "state": eq.regime,
            "stability": str(eq.kind[slot]),
            "undamped": Stability(int(eq.stability[slot])).name.lower(),
            **{name: float(unit * column[slot]) for name, (unit, column) in places.items()},
            "eigenvalues": [[float(np.real(value)), float(np.imag(value))] for value in eq.eigenvalues[slot]],
            "growth": float(eq.growth[slot]),
            "error": float(eq.error[slot]),
            "marginal": bool(eq.marginal[slot]),
        }
        for slot in range(int(eq.count))
    ]


def unless_room(columns: Sequence[str]) -> tuple[str, ...]:
    """Columns that a table without room for them leaves out: lengths of springs, which follow from coordinates, and errors."""
    return (*(name for name in columns if name == "L" or name.startswith("L_")), "error")


def columns_of(eq: Any) -> tuple[str, ...]:
    """The names of what says where a state is, as they stand in rows."""
    return tuple(map(_name, eq.columns))


def _is_direction(name: str) -> bool:
    return name == "theta" or name.startswith("theta_")


def _name(column: str) -> str:
    return f"{column}_deg" if _is_direction(column) else column


def _unit(column: str) -> float:
    return math.degrees(1.0) if _is_direction(column) else 1.0


def words_of(path: Any) -> list[dict[str, Any]]:
    """Of each state of a path what grows, with (27)'s word beside it, and how fast."""
    from ..statics import Stability

    return [
        {"stability": str(kind), "undamped": Stability(int(code)).name.lower(), "growth": float(growth)}
        for kind, code, growth in zip(path.kind, path.stability, path.growth, strict=True)
    ]
