"""Apply a function to many points: in this process, in worker processes, or by the user's map-like
callable. Results are stored as soon as they are computed.

The worker processes are not those of ``multiprocessing``. They import spragsym only, not the user's
script, so the script needs no ``if __name__ == "__main__":`` and cannot start itself again. Each
worker has pipes of its own, and workers share no locks: the end of its pipe shows at once that a
worker was killed, and to a worker that its parent was.
"""

from __future__ import annotations

import base64
import os
import pickle
import queue
import signal
import subprocess
import sys
import threading
import traceback
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from typing import Any, Generic, TypeAlias, TypeVar

import numpy as np

from ...core.errors import DamagedError, ParameterError, ParameterTypeError, SweepError
from ...core.interrupts import heard
from ...core.progress import advance
from ...files import storage
from ...files.journal import Record, clear, journal
from ...files.storage import resolved
from ...models.parameters import FloatArray, common_shape
from ...results.result import Result

Map: TypeAlias = Callable[[Callable[[Any], Any], Iterable[Any]], Iterable[Any]]

#: An int, or a map-like callable such as ``pool.imap`` or the ``map`` of a dask.distributed client.
Workers: TypeAlias = int | Map

#: A point with its number; and its outcome: the number, the result, and the error if there is no
#: result.
Task: TypeAlias = tuple[int, Any]
Answer: TypeAlias = tuple[int, Any, str]

R = TypeVar("R", bound=Result)
Point: TypeAlias = tuple[float, ...]
Work: TypeAlias = Callable[[Sequence[Point]], list[Record]]


@dataclass(frozen=True)
class Computation(Generic[R]):
    """How to compute a result over a broadcast of ``inputs``, point by point.

    ``work(points)`` gives a record per point; it must be picklable. ``names`` are the columns of
    the numbers in a record, ``text`` that of its text. ``made(columns, known)`` makes the result of
    all columns; ``known`` are those of the file, if the result is loaded. ``key()`` is a hash of
    everything that determines the bits of the result. ``together(points, workers)`` gives the
    number of points in a task.
    """

    inputs: Mapping[str, FloatArray]
    work: Work
    made: Callable[[dict[str, Any], Mapping[str, Any]], R]
    names: Sequence[str]
    text: str
    key: Callable[[], str]
    together: Callable[[int, int], int] = lambda *_: 1


def made_or_loaded(
    of: Computation[R], workers: Workers, progress: bool, store: str | os.PathLike[str] | None
) -> R:
    """The result of a computation: loaded if its file exists, else resumed from a journal or
    computed from the beginning.
    """
    inputs, names, text = of.inputs, of.names, of.text
    shape = common_shape({name: values.shape for name, values in inputs.items()})
    columns = [np.broadcast_to(values, shape).ravel().tolist() for values in inputs.values()]
    points = list(zip(*columns, strict=True))
    parallel = 1 if callable(workers) else count(workers)  # before there is a journal

    def assembled(
        numbers: Sequence[Any] | FloatArray, words: Iterable[str], columns: Mapping[str, Any]
    ) -> R:
        table = np.asarray(numbers, dtype=float).reshape(len(names), *shape)
        return of.made(
            {
                **dict(zip(names, table, strict=True)),
                text: np.array([*words], dtype=str).reshape(shape),
            },
            columns,
        )

    def compute(done: dict[int, Record], keep: Callable[[int, Record], None]) -> R:
        missing = [i for i in range(len(points)) if i not in done]
        size = of.together(len(missing), parallel)
        parts = [missing[begin : begin + size] for begin in range(0, len(missing), size)]
        tasks = {number: tuple(points[i] for i in part) for number, part in enumerate(parts)}
        found = results(workers, of.work, tasks, partial(_values_of, inputs))
        with advance(progress, len(points), len(done)) as step, closing(found):
            for number, records in found:
                for i, record in zip(parts[number], records, strict=True):
                    keep(i, record)
                    step()
        records = [done[i] for i in range(len(points))]
        table = np.array([values or [np.nan] * len(names) for values, _ in records])
        return assembled(table.T, (storage.plain(words) for _, words in records), {})

    if store is None:
        kept: dict[int, Record] = {}
        return compute(kept, kept.__setitem__)
    target, hashed, total = resolved(store), of.key(), len(points)

    def loaded() -> R | None:
        if not target.is_file() or storage.OVERWRITING.get():
            return None
        columns = storage.read_own(target, hashed)
        try:
            return assembled([columns[name] for name in names], columns[text], columns)
        except (LookupError, ValueError) as error:
            raise DamagedError(
                f"{target} has other columns than were written ({error!r:.60}); remove it to "
                "compute it again, or give another path"
            ) from error

    if (result := loaded()) is not None:
        clear(target, hashed, total)
        return result
    storage.check_target(target, 100_000 + 1000 * total)
    with journal(target, hashed, total, len(names)) as (done, keep):
        if (result := loaded()) is None:  # else another process has finished it in the meantime
            result = compute(done, keep)
            result.save(target)
    return result


def _values_of(names: Iterable[str], points: Sequence[Point]) -> str:
    first = ", ".join(
        f"{name} = {value:.17g}" for name, value in zip(names, points[0], strict=True)
    )
    return (
        first if len(points) == 1 else f"one of {len(points)} points, of which the first is {first}"
    )


def count(workers: int) -> int:
    """Number of processes."""
    if isinstance(workers, bool) or not isinstance(workers, int):
        raise ParameterTypeError(f"workers = {workers!r} is neither an int nor a map-like callable")
    if workers == -1:
        return os.cpu_count() or 1
    if workers < 1:
        raise ParameterError(
            f"workers = {workers} is neither positive nor -1, which stands for one a core"
        )
    return workers


def results(
    workers: Workers,
    function: Callable[[Any], Any],
    points: Mapping[int, Any],
    assembled: Callable[[Any], str],
) -> Generator[tuple[int, Any], None, None]:
    """Apply a function to numbered points: each number with its result, in the order in which they
    are computed. ``assembled`` describes a point in an error message.

    The generator must be closed, also after an error: that ends the processes and restores the
    handling of Ctrl-C.

    Raises
    ------
    SweepError
        When the function raises an error, a process ends, or the user's map misbehaves.
    KeyboardInterrupt
        After Ctrl-C, also where a library turned it into another error or into none.
    """
    missing = set(points)
    with heard() as check:
        for answer in _answers(workers, partial(_attempt, function), list(points.items())):
            check()
            index, result, trouble = _checked(answer, missing)
            if trouble:
                raise _failed(assembled(points[index]), trouble)
            missing.discard(index)
            yield index, result
        check()
    if missing:
        raise SweepError(
            f"the map given as workers left out {len(missing)} of {len(points)} points; give "
            "one that maps all"
        )


def _attempt(function: Callable[[Any], Any], task: Task) -> Answer:
    """The result of a task, or its error as text: not every error can be sent between processes."""
    index, point = task
    try:
        return index, function(point), ""
    except Exception as error:
        return (
            index,
            None,
            f"{type(error).__name__}: {' '.join(str(error).split())}\n{traceback.format_exc()}",
        )


def _failed(point: str, trouble: str) -> SweepError:
    what, _, trouble = trouble.partition("\n")
    error = SweepError(
        f"stopped at {point}: {what}; no motion fails so: it is the machine, what is "
        "installed, or a mistake in spragsym"
    )
    error.add_note(trouble)
    return error


def _checked(answer: object, missing: set[int]) -> Answer:
    if not (
        isinstance(answer, tuple)
        and len(answer) == 3
        and isinstance(answer[0], int)
        and answer[0] in missing
    ):
        raise SweepError(
            f"the map given as workers gave {answer!r:.80}, which the function that it was "
            "given did not return, "
            "or returned once only; give a map that returns every result"
        )
    return answer


def _answers(
    workers: Workers, function: Callable[[Task], Answer], tasks: list[Task]
) -> Iterator[Any]:
    if not callable(workers) and (size := min(count(workers), len(tasks))) > 1:
        with pool(size) as own:
            yield from own(function, tasks)
        return
    try:
        for item in (workers if callable(workers) else map)(function, tasks):
            yield item.result() if hasattr(item, "result") else item
    except SweepError:
        raise
    except Exception as error:
        raise SweepError(
            f"the map given as workers stopped with {type(error).__name__}: {error}"
        ) from error


# ----------------------------------------------------------------------------------------------
# processes: parent

#: First byte of a line that is a message (RFC 7464); other lines are output of a library.
_MARK = b"\x1e"


@contextmanager
def pool(size: int) -> Iterator[Map]:
    """A map over worker processes, which end with the context. Only one map may run at a time."""
    children: list[subprocess.Popen[bytes]] = []
    try:
        try:
            for _ in range(size):
                children.append(_begun())
        except OSError as error:
            raise SweepError(
                f"a worker process cannot be started: {error}; use fewer workers"
            ) from error
        yield partial(_map, children)
    finally:
        _end(children)


def _map(
    children: list[subprocess.Popen[bytes]], function: Callable[[Any], Any], items: Iterable[Any]
) -> Iterator[Any]:
    """Results of a function, in the order of completion; a free process takes the next item."""
    free = [*children]
    left = iter(items)
    asked = dict[Future[Any], subprocess.Popen[bytes]]()
    found = list[Future[Any]]()
    with ThreadPoolExecutor(len(children)) as threads:
        try:
            while True:
                for child, item in zip(free.copy(), left, strict=False):
                    free.remove(child)
                    asked[threads.submit(_asked, child, _packed((function, item)))] = child
                for each in sorted(found, key=lambda each: each.exception() is not None):
                    yield each.result()
                if not asked:
                    return
                # Windows notices Ctrl-C only between calls.
                found = list(wait(asked, timeout=1.0, return_when=FIRST_COMPLETED).done)
                free += map(asked.pop, found)
        except BaseException:
            _end(children)
            raise


def _asked(child: subprocess.Popen[bytes], message: bytes) -> object:
    """Send a message to a process and wait for its answer."""
    assert child.stdin is not None
    assert child.stdout is not None
    if child.stdin.closed:
        raise SweepError("the processes of this map have ended; start another")
    said = deque[bytes](maxlen=20)
    with suppress(OSError):  # it has ended; its output is still to be read
        child.stdin.write(message)
        child.stdin.flush()
    for line in child.stdout:
        if line.startswith(_MARK) and line.endswith(b"\n"):
            return _unpacked(line)
        said.append(line)
    raise SweepError(_epitaph(child.wait(), b"".join(said).decode(errors="replace")))


def _end(children: list[subprocess.Popen[bytes]]) -> None:
    """Kill the processes; their finished results have been received."""
    for child in children:
        child.kill()
        child.wait()
        for pipe in (child.stdin, child.stdout):
            assert pipe is not None
            with suppress(OSError):  # what was still to be sent is dropped
                pipe.close()


def _begun() -> subprocess.Popen[bytes]:
    """Start a worker process."""
    if not sys.executable:
        raise SweepError(
            "this Python does not know its own executable, so it starts no others; use workers=1"
        )
    # Run by every process, with the import path of its parent.
    boot = (
        "import signal; signal.signal(signal.SIGINT, signal.SIG_IGN); import ast, sys; "
        "sys.path[:] = ast.literal_eval(sys.stdin.buffer.readline().decode('ascii')); "
        "from spragsym.motion.sweeps.workers import serve; serve()"
    )
    call, pipe = [sys.executable, "-P", "-c", boot], subprocess.PIPE
    # A terminal sends Ctrl-C to all processes of its group: workers get a group of their own, and
    # the parent ends them.
    group: dict[str, Any] = {"process_group": 0}
    if sys.platform == "win32":
        group = {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP}
    child = subprocess.Popen(call, stdin=pipe, stdout=pipe, stderr=subprocess.STDOUT, **group)
    assert child.stdin is not None
    with suppress(OSError):  # it has ended already, which the reader notices
        child.stdin.write(ascii([str(path) for path in sys.path]).encode() + b"\n")
        child.stdin.flush()
    return child


def _epitaph(code: int, said: str) -> str:
    """Message about the exit of a process, with its last output."""
    lines = [line for line in said.splitlines() if line.strip()]
    words = f", and its last words were {lines[-1].strip()!r}" if lines else ""
    if code >= 0:
        return f"a worker process ended with exit code {code}{words}; its work is not done"
    try:
        name = signal.Signals(-code).name
    except ValueError:
        name = f"signal {-code}"
    why = ", as the system does when memory is short" if name == "SIGKILL" else ""
    return (
        f"a worker process was ended by {name}{why}{words}; with fewer workers each has more memory"
    )


def _packed(message: object) -> bytes:
    return _MARK + base64.b64encode(pickle.dumps(message)) + b"\n"


def _unpacked(line: bytes) -> Any:
    """Decode a message of our own process at the other end of the pipe, never a file."""
    return pickle.loads(base64.b64decode(line[1:-1]))  # noqa: S301 -- see above


# -----------------------------------------------------------------------------------------------
# processes: child


def serve() -> None:
    """Main loop of a worker process: read tasks from stdin, write results to stdout, until stdin
    ends because the parent has.
    """
    asked: queue.SimpleQueue[bytes] = queue.SimpleQueue()
    threading.Thread(target=_listen, args=(asked,), daemon=True).start()
    while True:
        function, item = _unpacked(asked.get())
        _say(_packed(function(item)))


def _listen(asked: queue.SimpleQueue[bytes]) -> None:
    """Read stdin in a thread, so that this process ends with its parent even during a task."""
    for line in sys.stdin.buffer:
        asked.put(line)
    os._exit(0)


def _say(message: bytes) -> None:
    """Write a message on a new line, in case a library has printed without one."""
    data = memoryview(b"\n" + message)
    try:
        while data:
            data = data[os.write(1, data) :]
    except OSError:
        os._exit(0)
