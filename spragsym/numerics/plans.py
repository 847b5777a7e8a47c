"""Plans: all tapes by which compiled code examines the boxes of a branch-and-prune search.

``_search.c`` performs the tests of :mod:`.boxes` in the same order. So both exclude, prove and
bisect the same boxes, with the same bits, except where NumPy's exp, log, tanh and atan differ from
those of the C library, as with AVX-512. NumPy is used if the extension was not built, or if a
function of the system can't be recorded on a tape.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import IntEnum, auto
from types import ModuleType
from typing import Any, TypeAlias

import numpy as np

from ..core.extensions import extension
from . import contractors, tape
from .interval_arrays import BoolArray, FloatArray, Intervals
from .tape import Tape
from .verdicts import Judged, Rules

compiled: Any = extension("numerics._search")  # or None

#: A border of a contact: a :class:`Side`, and how far beyond the border states are accepted.
Border: TypeAlias = tuple[int, float]


class Side(IntEnum):
    """Whether a contact touches or is open, in the numbers of ``_search.c``.

    A contact that touches has no state where its gap is positive, an open one none where its gap is
    negative, and one that is ``OPEN_AND_OFF`` none where it is 0 either.
    """

    TOUCHING = 0
    OPEN = auto()
    OPEN_AND_OFF = auto()


def available() -> bool:
    """Whether the extension module was built."""
    return compiled is not None


def compiled_for(n: int) -> ModuleType | None:
    """The extension module, if it and those that it needs were built and take n unknowns."""
    return compiled if tape.available() and contractors.compiled_for(n) is not None else None


@dataclass(frozen=True)
class LineTapes:
    """Tapes of one spring for boxes near its anchor, where its direction is unknown.

    ``forces`` gives the forces and their derivatives by the components of the direction,
    ``direction`` the direction over the box, and ``determinant`` the length times det K for
    directions on an arc.
    """

    forces: Tape | None = None
    direction: Tape | None = None
    determinant: Tape | None = None


@dataclass(frozen=True)
class Exclusions:
    """Tests that exclude a box, in addition to residuals that are not 0. A box has no root if

    - one of its ``gaps`` lies beyond the border of its contact, in ``borders``,
    - it is near the anchor of a spring, by ``anchors``, and by the tapes in ``lines`` no direction
      of that spring balances the forces, or det K is regular for directions on each of the
      ``arcs``, shape (2, 2, arcs),
    - it holds the jump of a torsion angle, by ``turnings``, and the residuals on all ``sides`` of
      the jumps are not 0.
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
    """Compiled plan of a system of n equations; ``handle`` is that of ``_search.c``."""

    n: int
    handle: Any

    def kept(
        self, given: FloatArray, parameters: Intervals, margin: float
    ) -> tuple[FloatArray, BoolArray]:
        """Contracted boxes, shape (2, n, N), and the mask of those that may hold a root."""
        boxes, keep = np.empty(given.shape), np.empty(given.shape[2], np.bool_)
        ends = np.ascontiguousarray(given)
        compiled.kept(self.handle, ends, parameters.ends, margin, boxes, keep)
        return boxes, keep

    def decided(
        self,
        contraction: tuple[FloatArray, FloatArray],
        parameters: Intervals,
        limits: FloatArray,
        marks: tuple[BoolArray, BoolArray],
        rules: Rules,
    ) -> tuple[FloatArray, Judged]:
        """Boxes widened by a margin, and the verdicts on them.

        ``contraction`` are the boxes before and after it, shape (2, n, N), and ``limits`` the
        region. ``marks`` are masks of the boxes of a single point, and of those whose budget is
        spent.
        """
        given, boxes = contraction
        count = given.shape[2]
        wide, step, left = np.empty((3, *given.shape))
        verdicts, along = np.empty(count, dtype=np.int8), np.empty(count, dtype=int)
        compiled.decided(
            self.handle,
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
        """Search at one point until no box is left, or a limit in ``most`` is reached.

        The limits are the number of boxes examined in all, and of boxes left. Returns the number of
        boxes examined, and four arrays of boxes: those in which a root is unique, smaller ones that
        hold these roots, undecided ones, and those left.
        """
        looks, *found = compiled.rounds(
            self.handle,
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
    tests: Exclusions,
) -> Plan | None:
    """The plan of a system; None if it exceeds the sizes of the arrays in compiled code.

    ``n``, ``coordinates`` and ``parameters`` are numbers of rows. ``equations`` are the tapes of
    residuals and Jacobian, and of the contraction with frozen directions, if there is one.
    """
    sizes = len(tests.lines), len(tests.borders), len(tests.sides), tests.arcs.shape[2]
    most = 8, 8, 16, 64  # MAX_LINES, MAX_BORDERS, MAX_SIDES and MAX_ARCS of _search.c
    if np.greater(sizes, most).any():
        return None
    tapes = *equations, tests.gaps, tests.anchors, tests.turnings
    lines = tuple(
        (packed(line.forces), packed(line.direction), packed(line.determinant))
        for line in tests.lines
    )
    handle = compiled.plan(
        n,
        coordinates,
        parameters,
        *map(packed, tapes),
        tuple(tests.borders),
        lines,
        tests.arcs,
        tuple(map(packed, tests.sides)),
    )
    return Plan(n, handle)


def packed(tape: Tape | None) -> tuple[bytes, bytes, int, int] | None:
    """A tape as compiled code takes it."""
    return None if tape is None else (tape.code, tape.numbers, tape.outputs, tape.slots)
