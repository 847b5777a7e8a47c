"""States as rows of a table and of JSON, and what is not known of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .of_model import Case
    from .units import Units


def rows_of(eq: Any, units: Units, point: tuple[int, ...] = ()) -> list[dict[str, Any]]:
    """A row for each equilibrium of one point: words, directions and lengths of springs, coordinates, and what is known of them.

    ``stability`` is that with dampers and the slope of the friction law; ``undamped`` and ``eigenvalues`` are without, as (27).
    """
    from ..results.equilibria import Stability

    growth, per = units.rate("growth")
    undamped, damped = (units.rate(name)[0] for name in ("eigenvalues", "damped_eigenvalues"))
    return [
        {
            "state": eq.regime,
            "stability": str(eq.kind[slot]),
            "undamped": Stability(int(eq.stability[slot])).name.lower(),
            **placed(units, eq.columns, lambda name, slot=slot: getattr(eq, name)[slot]),
            undamped: [[per * float(value.real), per * float(value.imag)] for value in eq.eigenvalues[slot]],
            damped: [[per * float(value.real), per * float(value.imag)] for value in eq.damped_eigenvalues[slot]],
            growth: per * float(eq.growth[slot]),
            "error": float(eq.error[slot]),
            "marginal": bool(eq.marginal[slot]),
        }
        for slot in ((*point, number) for number in range(int(eq.count[point])))
    ]


def placed(units: Units, names: Sequence[str], value: Any, end: str = "") -> dict[str, float]:
    """Where a state is, in the units of the answer: ``value(name)`` of each name."""
    titles = ((units.place(name, end), value(name)) for name in names)
    return {title: float(unit * one) for (title, unit), one in titles}


def unless_room(columns: Sequence[str]) -> tuple[str, ...]:
    """Columns that a table without room for them leaves out: lengths of springs, which follow from coordinates, and errors."""
    return (*(name for name in columns if name == "L" or name.startswith("L_")), "error")


def boxes_of(case: Case, boxes: Sequence[Any], names: Sequence[str], **about: Any) -> list[dict[str, Any]]:
    """Boxes that are not decided, each with the ends of what it says, in the units of the answer."""
    titles = [case.units.place(name) if name in case.model.coordinates else case.units.varied(name)[::-1][:2] for name in names]
    return [
        {**about, **{title: [unit * low, unit * high] for (title, unit), (low, high) in zip(titles, box, strict=True)}}
        for box in boxes
    ]


def summed(boxes: Sequence[dict[str, Any]]) -> str:
    """How many boxes are undecided, and what holds them all; ``--json`` lists each."""
    titles = [title for title, ends in boxes[0].items() if isinstance(ends, list)]
    hull = ", ".join(
        f"{title} in [{min(box[title][0] for box in boxes):.8g}, {max(box[title][1] for box in boxes):.8g}]" for title in titles
    )
    return f"{'1 box is' if len(boxes) == 1 else f'{len(boxes)} boxes are'} undecided, within {hull}"
