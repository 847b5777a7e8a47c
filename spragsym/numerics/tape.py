"""Tapes: functions of intervals, recorded once as a list of operations and then run on many boxes
by compiled code.

A generated function is called with :class:`Recorded` intervals. They compute nothing, but record
each operation; equal operations are recorded once (common subexpressions). The list is a
:class:`Tape`. ``_tape.c`` runs it on all boxes, block after block. Intermediate results share slots
as variables share registers, so that a block stays in the cache.

Each operation gives the same bits as :mod:`.interval_arrays`, except for functions of the C
library. Functions are evaluated by NumPy if the extension was not built, or if they can't be
recorded because they look at the values of boxes.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Hashable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partialmethod
from typing import Any, NoReturn, TypeAlias

import numpy as np

from ..core.extensions import extension
from .arithmetic import Number
from .interval_arrays import FloatArray, Intervals, Shape, exactly, stacked

compiled: Any = extension("numerics._tape")  # or None

#: Name of an operation and its two arguments: indices of results that it reads, then constants.
Operation: TypeAlias = tuple[str, int, int]
#: A function of several inputs, each a sequence of rows; it returns the entries of its result.
Rows: TypeAlias = Callable[..., Sequence[Any]]

#: Operation of an angle, by the side of the ray where it jumps from π to −π; 0 is any side.
ANGLES = {None: "angle", 0: "any_angle", 1: "angle_above", -1: "angle_below"}


def available() -> bool:
    """Whether the extension module was built."""
    return compiled is not None


class NotRecorded(Exception):
    """A function looks at the values of its intervals and so can't be recorded."""


@dataclass
class Recording:
    """Distinct operations in the order of evaluation, and distinct constants, each with its
    index.
    """

    operations: dict[Operation, int] = field(default_factory=dict)
    constants: dict[tuple[float, bool], int] = field(default_factory=dict)

    def operation(self, name: str, one: int = 0, other: int = 0) -> int:
        """Index of the result of an operation, which is recorded unless it is already."""
        return self.operations.setdefault((name, one, other), len(self.operations))

    def constant(self, value: float) -> int:
        """Index of a constant; −0 and 0 are different constants."""
        return self.constants.setdefault((value, bool(np.signbit(value))), len(self.constants))


class Recorded(Intervals):
    """Intervals that are known only as the result of a recorded operation, by its ``index``.

    ``vanishes`` says whether an input is 0 in all boxes; it is None if that is unknown.
    """

    __slots__ = ("index", "recording", "size", "vanishes")

    def __init__(
        self, recording: Recording, index: int, size: Shape, vanishes: bool | None = None
    ) -> None:
        self.recording, self.index, self.size, self.vanishes = recording, index, size, vanishes

    @property
    def ends(self) -> NoReturn:  # type: ignore[override]  # there are no values while recording
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

    def _apply(self, name: str, argument: int = 0) -> Recorded:
        index = self.recording.operation(name, self.index, argument)
        return Recorded(self.recording, index, self.size)

    def _operand(self, value: Number) -> Recorded | None:
        """``value`` as a recorded interval, None if it is no number.

        A number, or an interval that is the same in all boxes, becomes a constant.
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
        low, high = (self.recording.constant(float(end)) for end in ends)
        return Recorded(self.recording, self.recording.operation("constant", low, high), self.size)

    def _combine(self, name: str, other: Number) -> Recorded:
        operand = self._operand(other)
        return NotImplemented if operand is None else self._apply(name, operand.index)

    def __add__(self, other: Number) -> Recorded:
        if isinstance(other, int | float) and other == 0:
            return self
        return self._combine("sum", other)

    # With an interval on the left, Python calls these first: they override those of Intervals.
    def __radd__(self, other: Number) -> Recorded:
        return self.__add__(other)

    def __mul__(self, other: Number) -> Recorded:
        if other is self:
            return self._apply("square")
        if isinstance(other, int | float):
            return self._apply("scaled", self.recording.constant(exactly(other)))
        return self._combine("product", other)

    def __rmul__(self, other: Number) -> Recorded:
        return self.__mul__(other)

    def __truediv__(self, other: Number) -> Recorded:
        return self._combine("quotient", other)

    def __rtruediv__(self, other: Number) -> Recorded:
        operand = self._operand(other)
        return NotImplemented if operand is None else operand._apply("quotient", self.index)

    def __pow__(self, power: Number) -> Any:
        if isinstance(power, int) and power == 0:
            return self._operand(1)
        if isinstance(power, int) and power > 2 and power % 2:
            return self._apply("odd_power", power)
        return super().__pow__(power)

    def component(self, across: Intervals) -> Recorded:
        """x/√(x² + y²) for the vector (x, y), where y is ``across``."""
        return self._combine("component", across)

    def angle(self, cosine: Intervals, side: int | None) -> Recorded:
        """The angle of a vector with this sine and the given cosine."""
        return self._combine(ANGLES[side], cosine)


for _method, _operation in {
    "__neg__": "negative",
    "__abs__": "absolute",
    "squared": "square",
    **{
        name: name
        for name in ("sqrt", "exp", "log", "tanh", "atan", "cos", "sin", "sign", "not_negative")
    },
}.items():
    setattr(Recorded, _method, partialmethod(Recorded._apply, _operation))


class RecordedRows:
    """One input of a function that is recorded: unknowns or parameters, by row."""

    def __init__(self, rows: Sequence[Recorded], shape: Shape) -> None:
        self.rows, self.shape = rows, (len(rows), *shape)

    def __getitem__(self, row: int) -> Recorded:
        return self.rows[row]

    def __iter__(self) -> Iterator[Recorded]:
        return iter(self.rows)


@dataclass(frozen=True)
class Tape:
    """A recorded function: operations on slots, as ``_operations.h`` reads them.

    ``code`` holds four integers for each operation: its code, the slot of the result, and two
    arguments. ``numbers`` holds the constants, ``outputs`` is the number of results, and ``slots``
    the number of intermediate results that are needed at once.
    """

    code: bytes
    numbers: bytes
    outputs: int
    slots: int

    def __call__(self, *given: Intervals) -> Intervals:
        """Results, shape (outputs, N), of inputs of shape (rows, N) each."""
        out = np.empty((2, self.outputs, given[0].shape[1]))
        compiled.run(self.code, self.numbers, tuple(part.ends for part in given), out, self.slots)
        return Intervals(out)

    def affine(
        self, values: FloatArray, terms: FloatArray, errors: FloatArray, intervals: Intervals
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Results in affine arithmetic, see :mod:`.affine`: values, terms and errors.

        The first input is given by values and errors of shape (rows, N) and terms of shape (terms,
        rows, N); the second input are intervals.
        """
        given = [np.ascontiguousarray(part) for part in (values, terms, errors)]
        shape = self.outputs, values.shape[1]
        out = np.empty(shape), np.empty((len(terms), *shape)), np.empty(shape)
        compiled.affine(self.code, self.numbers, *given, intervals.ends, *out, self.slots)
        return out


class Tapes:
    """Cache of the tapes of functions by keys; a function is recorded when it is first used."""

    def __init__(self) -> None:
        self.known: dict[Hashable, Tape | None] = {}
        #: Cache of plans, which combine several tapes.
        self.plans: dict[Hashable, Any] = {}

    def tape(
        self, key: Hashable, rows: Rows, given: Sequence[int], vanishing: Sequence[bool] = ()
    ) -> Tape:
        """The tape of a function whose inputs have ``given`` numbers of rows.

        Raises NotRecorded if it can't be recorded.
        """
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
        """``rows(*given)`` as one array of shape (entries, N), by its tape if there is one.

        Inputs have the shape (…, N). ``vanishing`` says for the first rows of the last input
        whether they are 0 in all boxes. The function may branch on that, so each pattern has a tape
        of its own.
        """
        shape = given[0].shape[1:]
        recordable = compiled is not None and shape != (0,)
        tape = self._found(key, rows, given, vanishing) if recordable else None
        return stacked(rows(*given), shape) if tape is None else tape(*given)


def recorded(rows: Rows, *given: Intervals, vanishing: Sequence[bool] = ()) -> Tape | None:
    """The tape of a function; None if it looks at the values of its intervals."""
    recording, shape = Recording(), given[0].shape[1:]
    inputs = [
        RecordedRows(
            [
                Recorded(recording, recording.operation("load", number, row), shape, vanishes)
                for row, vanishes in itertools.zip_longest(
                    range(part.shape[0]), vanishing if part is given[-1] else ()
                )
            ],
            shape,
        )
        for number, part in enumerate(given)
    ]
    try:
        found = [_index(recording, entry, shape) for entry in rows(*inputs)]
    except NotRecorded:
        return None
    return _assembled(recording, found)


def _index(recording: Recording, entry: Number, shape: Shape) -> int:
    """Index of an entry of a result, which may be a constant."""
    operand = Recorded(recording, 0, shape)._operand(entry)
    assert operand is not None
    return operand.index


def _operands(operation: Operation) -> tuple[int, ...]:
    """Indices of the results that an operation reads."""
    name, one, other = operation
    if name in ("load", "constant"):
        return ()
    of_two = name in ("sum", "product", "quotient", "component", *ANGLES.values())
    return (one, other) if of_two else (one,)


def _assembled(recording: Recording, found: Sequence[int]) -> Tape:
    """The tape of the operations on which the results ``found`` depend.

    A slot is used again after the last operation that reads it.
    """
    operations = list(recording.operations)
    last_use = dict.fromkeys(found, len(operations))
    for index in reversed(range(len(operations))):
        if index in last_use:
            for operand in _operands(operations[index]):
                last_use.setdefault(operand, index)
    codes = {name: code for code, name in enumerate(compiled.OPERATIONS)}
    slots: dict[int, int] = {}
    free: list[int] = []
    lines: list[tuple[int, int, int, int]] = []
    count = 0
    for index, operation in enumerate(operations):
        if index not in last_use:
            continue
        operands = _operands(operation)
        slot = free.pop() if free else count
        count = max(count, slot + 1)
        first, second = operation[1:]
        if operands:
            first = slots[operands[0]]
        if len(operands) == 2:
            second = slots[operands[1]]
        lines.append((codes[operation[0]], slot, first, second))
        slots[index] = slot
        free += [slots[operand] for operand in set(operands) if last_use[operand] == index]
    lines += [(codes["store"], row, slots[index], 0) for row, index in enumerate(found)]
    numbers = np.array([value for value, _ in recording.constants], dtype=float)
    return Tape(
        np.array(lines, dtype=np.int32).tobytes(), numbers.tobytes(), len(found), max(count, 1)
    )
