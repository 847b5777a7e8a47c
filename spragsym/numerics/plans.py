"""Plans by which compiled code looks at the boxes of a search: the tapes of all that is asked of a
box.

``_search.c`` does what :mod:`.boxes` does by NumPy, with the same tests in the same order, so that
both drop, prove and cut the same boxes and give the same bits, but where NumPy's exp, log, tanh and
atan are not the C library's, as with AVX-512. Without the extension, and for systems with a step
that no tape holds, NumPy serves.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import IntEnum, auto
from types import ModuleType
from typing import Any, TypeAlias

import numpy as np

from ..core.errors import BackendError
from . import contractors, tape
from .interval_arrays import BoolArray, FloatArray, Intervals
from .tape import Tape
from .verdicts import Judged, Rules

try:
    from . import _search as compiled
except ImportError:  # there was no compiler
    compiled = None  # type: ignore[assignment]  # a module or nothing
else:
    needed = {"plan", "kept", "decided", "rounds", "tubes", "corrected", "tangents"}
    if lacking := needed - set(dir(compiled)):
        raise BackendError(
            f"{compiled.__file__} was compiled from older sources and has no "
            f"{' and no '.join(sorted(lacking))}; rebuild it: install spragsym again"
        )

#: A border of a contact: which side of it holds no state, and how far beyond it states count.
Border: TypeAlias = tuple[int, float]


class Side(IntEnum):
    """Where a contact has no state, in the order of ``_search.c``: beyond its border, where it
    touches; before it, where it is open, or on it as well.
    """

    TOUCHING = 0
    OPEN = auto()
    OPEN_AND_OFF = auto()


def available() -> bool:
    """Whether the extension module was built."""
    return compiled is not None


def compiled_for(n: int) -> ModuleType | None:
    """The extension module for so many unknowns, if it and those of its parts were built."""
    return compiled if tape.available() and contractors.compiled_for(n) is not None else None


@dataclass(frozen=True)
class LineTapes:
    """Tapes of a line for boxes at its anchor, where its direction is not known.

    ``forces`` by the components of the direction, the ``direction`` over the box, and the
    ``determinant`` of slopes times the length for directions on an arc.
    """

    forces: Tape | None = None
    direction: Tape | None = None
    determinant: Tape | None = None


@dataclass(frozen=True)
class Exclusions:
    """Tests that a box holds no root, beside values other than 0.

    ``gaps`` lie beyond their ``borders``; of ``lines``, where ``anchors`` are near, no direction
    balances the forces, or all of them on the ``arcs``, shape (2, 2, arcs), leave the determinant
    regular; and where ``turnings`` jump, values on all ``sides`` are not 0.
    """

    gaps: Tape | None = None
    borders: Sequence[Border] = ()
    anchors: Tape | None = None
    lines: Sequence[LineTapes] = ()
    arcs: FloatArray = field(default_factory=lambda: np.zeros((2, 2, 0)))
    turnings: Tape | None = None
    sides: Sequence[Tape] = ()


@dataclass(frozen=True)
class Plan:
    """Tapes of a system of n equations, as compiled code holds them."""

    n: int
    held: Any

    def kept(
        self, given: FloatArray, parameters: Intervals, margin: float
    ) -> tuple[FloatArray, BoolArray]:
        """Contracted boxes, shape (2, n, N), and which of them may hold a root."""
        boxes, keep = np.empty(given.shape), np.empty(given.shape[2], np.bool_)
        ends = np.ascontiguousarray(given)
        compiled.kept(self.held, ends, parameters.ends, margin, boxes, keep)
        return boxes, keep

    def decided(
        self,
        both: tuple[FloatArray, FloatArray],
        parameters: Intervals,
        limits: FloatArray,
        marks: tuple[BoolArray, BoolArray],
        rules: Rules,
    ) -> tuple[FloatArray, Judged]:
        """Boxes with room around, and what becomes of them: ``both`` before and after they were
        contracted; ``marks`` are those of nodes with one point, and those whose work is spent.
        """
        given, boxes = both
        count = given.shape[2]
        wide, step, left = np.empty((3, *given.shape))
        verdicts, along = np.empty(count, dtype=np.int8), np.empty(count, dtype=int)
        compiled.decided(
            self.held,
            np.ascontiguousarray(given),
            np.ascontiguousarray(boxes),
            parameters.ends,
            self._limits(limits),
            *marks,
            rules.sharp,
            rules.compiled,
            wide,
            step,
            left,
            verdicts,
            along,
        )
        return wide, Judged(step, left, verdicts, along)

    def _limits(self, limits: FloatArray) -> FloatArray:
        return np.array(np.broadcast_to(limits[..., 0], (2, self.n)))

    def rounds(
        self,
        given: FloatArray,
        parameters: Intervals,
        limits: FloatArray,
        rules: Rules,
        most: tuple[int, int],
    ) -> tuple[int, list[FloatArray]]:
        """A search at one point until no box is left, or ``most`` are: of those looked at in all,
        and of those left. How many were looked at, and boxes with a root, where it is, undecided
        and further ones.
        """
        looks, *found = compiled.rounds(
            self.held,
            np.ascontiguousarray(given),
            parameters.ends,
            self._limits(limits),
            rules.sharp,
            rules.compiled,
            *most,
        )
        piles = (np.frombuffer(part).reshape(-1, 2, self.n) for part in found)
        return looks, [np.ascontiguousarray(np.moveaxis(pile, 0, 2)) for pile in piles]


def planned(
    n: int,
    coordinates: int,
    parameters: int,
    equations: tuple[Tape, Tape, Tape | None],
    besides: Exclusions,
) -> Plan | None:
    """The plan of a system, by the tapes of its values, slopes and own contraction, if it has one;
    None where compiled code has no room for it.
    """
    sizes = len(besides.lines), len(besides.borders), len(besides.sides), besides.arcs.shape[2]
    # As many lines, borders, sides and arcs as compiled code has room for.
    if np.greater(sizes, (8, 8, 16, 64)).any():
        return None
    tapes = *equations, besides.gaps, besides.anchors, besides.turnings
    lines = tuple(
        (given(line.forces), given(line.direction), given(line.determinant))
        for line in besides.lines
    )
    held = compiled.plan(
        n,
        coordinates,
        parameters,
        *map(given, tapes),
        tuple(besides.borders),
        lines,
        besides.arcs,
        tuple(map(given, besides.sides)),
    )
    return Plan(n, held)


def given(of: Tape | None) -> tuple[bytes, bytes, int, int] | None:
    """A tape as compiled code takes it."""
    return None if of is None else (of.code, of.numbers, of.outputs, of.slots)
