"""One record for every point of a broadcast of numbers: on all cores, kept as they are done, and gone on with after a kill."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Generic, TypeVar

import numpy as np

from ...files import storage
from ...files.journal import Record
from ...files.stored import stored
from ...models.parameters import FloatArray, common_shape
from ...progress import advance
from . import workers as processes
from .workers import Workers

T = TypeVar("T")


@dataclass(frozen=True)
class Points(Generic[T]):
    """Work on points before it is done.

    Attributes
    ----------
    inputs : dict of str to ndarray
        What broadcasts together to the points.
    work : callable
        ``work(points)``: a record each; it is sent to other processes.
    made : callable
        ``made(records, columns)``: the result; with the columns of the file if it is loaded.
    names, text : tuple of str, str
        Columns of a file that hold the numbers of a record, and its words.
    key : callable
        ``key()``: a hash of everything that decides the bits of the result.
    together : callable
        ``together(points, workers)``: how many are one task.
    """

    inputs: Mapping[str, FloatArray]
    work: Callable[[Sequence[tuple[float, ...]]], list[Record]]
    made: Callable[[list[Record], Mapping[str, Any]], T]
    names: tuple[str, ...]
    text: str
    key: Callable[[], str]
    together: Callable[[int, int], int] = lambda *_: 1

    def done(
        self, workers: Workers, progress: bool, store: str | os.PathLike[str] | None, save: Callable[[T, Path], None]
    ) -> T:  # fmt: skip
        """The result: computed, or gone on with, or loaded, if its file is there."""
        shape = common_shape({name: values.shape for name, values in self.inputs.items()})
        columns = [np.broadcast_to(values, shape).ravel().tolist() for values in self.inputs.values()]
        points = list(zip(*columns, strict=True))
        if not callable(workers):
            processes.count(workers)  # before there is a journal

        def compute(done: dict[int, Record], keep: Callable[[int, Record], None]) -> T:
            return self.made(self._records(points, workers, progress, done, keep), {})

        if store is None:
            records: dict[int, Record] = {}
            return compute(records, records.__setitem__)
        key, size = self.key(), len(points)
        return stored(store, key, size, 100_000 + 1000 * size, lambda path: self._loaded(path, key), compute, save)

    def _records(
        self, points: list[tuple[float, ...]], workers: Workers, progress: bool, done: dict[int, Record],
        keep: Callable[[int, Record], None],
    ) -> list[Record]:  # fmt: skip
        """Every record: those that are done, and the others, stored as they are computed."""
        left = [i for i in range(len(points)) if i not in done]
        size = self.together(len(left), 1 if callable(workers) else processes.count(workers))
        parts = [left[begin : begin + size] for begin in range(0, len(left), size)]
        tasks = {number: tuple(points[i] for i in part) for number, part in enumerate(parts)}
        found = processes.results(workers, self.work, tasks, self._told)
        with advance(progress, len(points), len(done)) as step, closing(found):
            for number, records in found:
                for i, record in zip(parts[number], records, strict=True):
                    keep(i, record)
                    step()
        return [done[i] for i in range(len(points))]

    def _told(self, points: tuple[tuple[float, ...], ...]) -> str:
        first = ", ".join(f"{name} = {value:.17g}" for name, value in zip(self.inputs, points[0], strict=True))
        return first if len(points) == 1 else f"one of {len(points)} points, of which the first is {first}"

    def _loaded(self, path: Path, key: str) -> T:
        """What a file holds, if it is this one."""
        columns = storage.read_own(path, key)
        numbers = np.array([np.asarray(columns[name], dtype=float) for name in self.names]).T.tolist()
        return self.made(list(zip(numbers, map(str, columns[self.text]), strict=True)), columns)
