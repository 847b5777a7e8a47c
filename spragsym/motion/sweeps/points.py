"""One record for every point of a broadcast of numbers: on all cores, kept as they are done, and gone on with after a kill."""

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import closing
from functools import partial
from pathlib import Path
from typing import Any, TypeAlias, TypeVar

import numpy as np

from ...files import storage
from ...files.journal import Record, clear, journal
from ...files.writing import resolved
from ...models.parameters import FloatArray, common_shape
from ...progress import advance
from . import workers as processes
from .workers import Workers

T = TypeVar("T")


Point: TypeAlias = tuple[float, ...]
Work: TypeAlias = Callable[[Sequence[Point]], list[Record]]


def made_or_loaded(
    inputs: Mapping[str, FloatArray], work: Work, made: Callable[[list[Record], Mapping[str, Any]], T], names: Sequence[str],
    text: str, key: Callable[[], str], save: Callable[[T, Path], None], workers: Workers, progress: bool,
    store: str | os.PathLike[str] | None, together: Callable[[int, int], int] = lambda *_: 1,
) -> T:  # fmt: skip
    """The result for a broadcast of ``inputs``: computed, or gone on with, or loaded, if its file is there.

    ``work(points)`` gives a record each, in other processes too, ``made(records, columns)`` the result, with the columns of the
    file if it is loaded: ``names`` for the numbers of a record, ``text`` for its words. ``key()`` is a hash of everything that
    decides the bits of the result; ``together(points, workers)`` says how many are one task.
    """
    shape = common_shape({name: values.shape for name, values in inputs.items()})
    columns = [np.broadcast_to(values, shape).ravel().tolist() for values in inputs.values()]
    points = list(zip(*columns, strict=True))
    parallel = 1 if callable(workers) else processes.count(workers)  # before there is a journal

    def compute(done: dict[int, Record], keep: Callable[[int, Record], None]) -> T:
        left = [i for i in range(len(points)) if i not in done]
        size = together(len(left), parallel)
        parts = [left[begin : begin + size] for begin in range(0, len(left), size)]
        tasks = {number: tuple(points[i] for i in part) for number, part in enumerate(parts)}
        found = processes.results(workers, work, tasks, partial(_told, inputs))
        with advance(progress, len(points), len(done)) as step, closing(found):
            for number, records in found:
                for i, record in zip(parts[number], records, strict=True):
                    keep(i, record)
                    step()
        return made([done[i] for i in range(len(points))], {})

    def loaded(path: Path) -> T:
        known = storage.read_own(path, hashed)
        numbers = np.array([np.asarray(known[name], dtype=float) for name in names]).T.tolist()
        return made(list(zip(numbers, map(str, known[text]), strict=True)), known)

    if store is None:
        records: dict[int, Record] = {}
        return compute(records, records.__setitem__)
    target, hashed, count = resolved(store), key(), len(points)
    if target.is_file() and not storage.OVERWRITING.get():
        result = loaded(target)
        clear(target, hashed, count)
        return result
    storage.check_target(target, 100_000 + 1000 * count)
    with journal(target, hashed, count) as (done, keep):
        if target.is_file() and not storage.OVERWRITING.get():  # another process has finished it in the meantime
            return loaded(target)
        result = compute(done, keep)
        save(result, target)
    return result


def _told(names: Iterable[str], points: Sequence[Point]) -> str:
    first = ", ".join(f"{name} = {value:.17g}" for name, value in zip(names, points[0], strict=True))
    return first if len(points) == 1 else f"one of {len(points)} points, of which the first is {first}"
