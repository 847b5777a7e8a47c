"""Functions of intervals, recorded once as a list of operations and run on many boxes by compiled
code.

A generated function is called with :class:`Recorded` intervals, which do nothing but note each
operation; what two results have in common is noted once. The list, a :class:`Tape`, is run by
``_tape.c`` on all boxes, block after block, with as many intermediate results as are alive at once.
There each operation gives the bits that :mod:`.interval_arrays` gives, but for functions of the C
library. So nothing but time depends on whether the extension was built: without it, and for what
looks at the values of boxes and can't be recorded, functions are evaluated as they stand.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Hashable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partialmethod
from typing import Any, NoReturn, TypeAlias

import numpy as np

from .arithmetic import Number
from .interval_arrays import FloatArray, Intervals, Shape, exactly, stacked

try:
    from . import _tape as compiled
except ImportError:  # there was no compiler
    compiled = None  # type: ignore[assignment]  # a module or nothing

#: What an operation is, and the two things that it is done to: results by their numbers, or what
#: the operation needs beside them.
Operation: TypeAlias = tuple[str, int, int]
#: Rows of a function of rows of unknowns and of parameters.
Rows: TypeAlias = Callable[..., Sequence[Any]]

#: An angle, by the side of the ray where it jumps.
ANGLES = {None: "angle", 0: "any_angle", 1: "angle_above", -1: "angle_below"}


def available() -> bool:
    """Whether the extension module was built."""
    return compiled is not None


class NotRecorded(Exception):
    """A step of a function that looks at the values of its intervals."""


@dataclass
class Recording:
    """Operations in the order in which they were noted, each once, and the numbers in them."""

    operations: dict[Operation, int] = field(default_factory=dict)
    numbers: dict[tuple[float, bool], int] = field(default_factory=dict)

    def noted(self, name: str, one: int = 0, other: int = 0) -> int:
        """The number of the result of an operation."""
        return self.operations.setdefault((name, one, other), len(self.operations))

    def number(self, value: float) -> int:
        """The place of a number; −0 is another one than 0."""
        return self.numbers.setdefault((value, bool(np.signbit(value))), len(self.numbers))


class Recorded(Intervals):
    """An interval of each box of which only the operations are noted.

    ``vanishes`` says of an input whether it is 0 in all boxes, where that may be asked.
    """

    __slots__ = ("place", "recording", "size", "vanishes")

    def __init__(
        self, recording: Recording, place: int, size: Shape, vanishes: bool | None = None
    ) -> None:
        self.recording, self.place, self.size, self.vanishes = recording, place, size, vanishes

    @property
    def ends(self) -> NoReturn:  # type: ignore[override]  # it has none yet
        raise NotRecorded

    @property
    def shape(self) -> Shape:
        """Shape of the boxes for which the function is recorded."""
        return self.size

    def is_nothing(self) -> bool:
        """Whether it is 0 in all boxes."""
        if self.vanishes is None:
            raise NotRecorded
        return self.vanishes

    def __getitem__(self, index: object) -> NoReturn:
        raise NotRecorded

    def __iter__(self) -> NoReturn:
        raise NotRecorded

    def _noted(self, name: str, other: int = 0) -> Recorded:
        return Recorded(self.recording, self.recording.noted(name, self.place, other), self.size)

    def _of(self, value: Number) -> Recorded | None:
        """An operand: a recorded interval, or a number or interval that is the same in all
        boxes.
        """
        if isinstance(value, Recorded):
            return value
        if isinstance(value, int | float):
            ends = np.array([-exactly(value), exactly(value)])
        elif isinstance(value, Intervals):
            ends = value.ends.reshape(2, -1)
            if ends.shape[1] < 1 or not (ends == ends[:, :1]).all():
                raise NotRecorded
            ends = ends[:, 0]
        elif isinstance(value, np.ndarray):
            raise NotRecorded
        else:
            return None
        low, high = (self.recording.number(float(end)) for end in ends)
        return Recorded(self.recording, self.recording.noted("constant", low, high), self.size)

    def _with(self, name: str, other: Number) -> Recorded:
        operand = self._of(other)
        return NotImplemented if operand is None else self._noted(name, operand.place)

    def __add__(self, other: Number) -> Recorded:
        if isinstance(other, int | float) and other == 0:
            return self
        return self._with("sum", other)

    # An interval on the left asks these first, because they are not those of Intervals.
    def __radd__(self, other: Number) -> Recorded:
        return self.__add__(other)

    def __mul__(self, other: Number) -> Recorded:
        if other is self:
            return self._noted("square")
        if isinstance(other, int | float):
            return self._noted("scaled", self.recording.number(exactly(other)))
        return self._with("product", other)

    def __rmul__(self, other: Number) -> Recorded:
        return self.__mul__(other)

    def __truediv__(self, other: Number) -> Recorded:
        return self._with("quotient", other)

    def __rtruediv__(self, other: Number) -> Recorded:
        operand = self._of(other)
        return NotImplemented if operand is None else operand._noted("quotient", self.place)

    def __pow__(self, power: Number) -> Any:
        if isinstance(power, int) and power == 0:
            return self._of(1)
        if isinstance(power, int) and power > 2 and power % 2:
            return self._noted("odd_power", power)
        return super().__pow__(power)

    def component(self, across: Intervals) -> Recorded:
        """x/√(x² + y²)."""
        return self._with("component", across)

    def angle(self, cosine: Intervals, side: int | None) -> Recorded:
        """The angle of a vector."""
        return self._with(ANGLES[side], cosine)


for _method, _operation in {
    "__neg__": "negative",
    "__abs__": "absolute",
    "squared": "square",
    **{
        name: name
        for name in ("sqrt", "exp", "log", "tanh", "atan", "cos", "sin", "sign", "not_negative")
    },
}.items():
    setattr(Recorded, _method, partialmethod(Recorded._noted, _operation))


class RecordedRows:
    """Rows of recorded intervals: what a function takes as unknowns or parameters."""

    def __init__(self, rows: Sequence[Recorded], shape: Shape) -> None:
        self.rows, self.shape = rows, (len(rows), *shape)

    def __getitem__(self, row: int) -> Recorded:
        return self.rows[row]

    def __iter__(self) -> Iterator[Recorded]:
        return iter(self.rows)


@dataclass(frozen=True)
class Tape:
    """Operations with the places of their results; ``slots`` of these are alive at once."""

    code: bytes
    numbers: bytes
    outputs: int
    slots: int

    def __call__(self, *given: Intervals) -> Intervals:
        """Results of shape (outputs, N) from inputs of shape (rows, N) each."""
        out = np.empty((2, self.outputs, given[0].shape[1]))
        compiled.run(self.code, self.numbers, tuple(part.ends for part in given), out, self.slots)
        return Intervals(out)

    def affine(
        self, values: FloatArray, terms: FloatArray, errors: FloatArray, intervals: Intervals
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Values, terms and errors of results of affine numbers of shape (rows, N), terms (sides,
        rows, N), see :mod:`.affine`, and of intervals as the second input.
        """
        given = [np.ascontiguousarray(part) for part in (values, terms, errors)]
        sides, count = len(terms), values.shape[1]
        alone = self.outputs, count
        out = np.empty(alone), np.empty((sides, *alone)), np.empty(alone)
        compiled.affine(self.code, self.numbers, *given, intervals.ends, *out, self.slots)
        return out


class Tapes:
    """Functions of boxes by the tapes that are recorded of them at first."""

    def __init__(self) -> None:
        self.known: dict[Hashable, Tape | None] = {}
        #: What is made of several of them.
        self.plans: dict[Hashable, Any] = {}

    def tape(
        self, key: Hashable, rows: Rows, given: Sequence[int], vanishing: Sequence[bool] = ()
    ) -> Tape:
        """The tape of a function of inputs with so many rows each; NotRecorded if it has none."""
        inputs = [Intervals(np.zeros((2, number, 1))) for number in given]
        if (found := self._found(key, rows, inputs, vanishing)) is None:
            raise NotRecorded
        return found

    def _found(
        self, key: Hashable, rows: Rows, given: Sequence[Intervals], vanishing: Sequence[bool]
    ) -> Tape | None:
        key = (key, *vanishing)
        if key not in self.known:
            self.known[key] = recorded(rows, *given, vanishing=vanishing)
        return self.known[key]

    def evaluated(
        self,
        key: Hashable,
        rows: Rows,
        *given: Intervals,
        vanishing: Sequence[bool] = (),
    ) -> Intervals:
        """``rows(*given)``, inputs of shape (…, N) each, as one array of shape (entries, N).

        ``vanishing`` says of the first rows of the last input whether they are 0 in all boxes,
        which may be asked of these alone; a tape holds for one such pattern.
        """
        shape = given[0].shape[1:]
        recordable = compiled is not None and shape != (0,)
        tape = self._found(key, rows, given, vanishing) if recordable else None
        return stacked(rows(*given), shape) if tape is None else tape(*given)


def recorded(rows: Rows, *given: Intervals, vanishing: Sequence[bool] = ()) -> Tape | None:
    """The tape of a function; None of one that looks at the values of its intervals."""
    recording, shape = Recording(), given[0].shape[1:]
    inputs = [
        RecordedRows(
            [
                Recorded(recording, recording.noted("load", number, row), shape, nothing)
                for row, nothing in itertools.zip_longest(
                    range(part.shape[0]), vanishing if part is given[-1] else ()
                )
            ],
            shape,
        )
        for number, part in enumerate(given)
    ]
    try:
        found = [_place(recording, entry, shape) for entry in rows(*inputs)]
    except NotRecorded:
        return None
    return _assembled(recording, found)


def _place(recording: Recording, entry: Number, shape: Shape) -> int:
    """The number of a result, or of an entry that is the same in all boxes."""
    operand = Recorded(recording, 0, shape)._of(entry)
    assert operand is not None
    return operand.place


def _operands(operation: Operation) -> tuple[int, ...]:
    """Numbers of the results that an operation reads."""
    name, one, other = operation
    if name in ("load", "constant"):
        return ()
    of_two = name in ("sum", "product", "quotient", "component", *ANGLES.values())
    return (one, other) if of_two else (one,)


def _assembled(recording: Recording, found: Sequence[int]) -> Tape:
    """Operations that the results need, each result in a slot that is free by then."""
    operations = list(recording.operations)
    last = dict.fromkeys(found, len(operations))
    for number in reversed(range(len(operations))):
        if number in last:
            for operand in _operands(operations[number]):
                last.setdefault(operand, number)
    codes = {name: code for code, name in enumerate(compiled.OPERATIONS)}
    slots: dict[int, int] = {}
    free: list[int] = []
    lines: list[tuple[int, int, int, int]] = []
    used = 0
    for number, (name, one, other) in enumerate(operations):
        if number not in last:
            continue
        operands = _operands((name, one, other))
        slot = free.pop() if free else used
        used = max(used, slot + 1)
        first, second = ([slots[operand] for operand in operands] + [one, other][len(operands) :])[
            :2
        ]
        lines.append((codes[name], slot, first, second))
        slots[number] = slot
        free += [slots[operand] for operand in set(operands) if last[operand] == number]
    lines += [(codes["store"], row, slots[index], 0) for row, index in enumerate(found)]
    numbers = np.array([value for value, _ in recording.numbers], dtype=float)
    return Tape(
        np.array(lines, dtype=np.int32).tobytes(), numbers.tobytes(), len(found), max(used, 1)
    )
