"""Progress of long work: a line on stderr, or a function that is called, for whoever asks."""

from __future__ import annotations

import itertools
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from contextvars import ContextVar

from .errors import ParameterTypeError

Listener = Callable[[str], object]

#: Seconds after which a computation is said to go on where no terminal shows it.
LONG = 10.0


class _Work:
    """Work that is being computed: each part within the one before it."""

    def __init__(self, listener: Listener, part: str) -> None:
        self.listener, self.parts = listener, [part]

    def __str__(self) -> str:
        return ": ".join(part for part in self.parts if part)


#: Of this thread, or of this task of asyncio: what other threads compute is not said.
_work: ContextVar[_Work | None] = ContextVar("spragsym.core.progress", default=None)


@contextmanager
def show_progress(part: str = "", to: Listener | None = None) -> Iterator[None]:
    """Report the progress of long computations within a ``with`` block.

    Parameters
    ----------
    part : str, optional
        What the block as a whole is.
    to : callable, optional
        Called with each text. Without it a line on stderr says the last one: on a terminal until
        all is done, elsewhere after ten seconds, and again each time that it has taken twice as
        long.

    Returns
    -------
    context manager

    Raises
    ------
    ParameterTypeError
        If ``part`` is no text, or ``to`` can't be called.

    Notes
    -----
    Only the thread that asked is listened to, and nothing that is computed depends on it. Within a
    block another one may stand: until its end it is that one which is told. Sweeps, fate maps and
    probabilities have a bar of their own, ``progress=True``.

    Examples
    --------
    >>> import spragsym as ss
    >>> model, told = ss.load("stick_slip"), []
    >>> cycle = ss.cycle(model.Parameters(V=0.2))
    >>> with ss.show_progress(to=told.append):
    ...     found = ss.cycle_branch(cycle, "V", between={"V": (0.19, 0.21)}, points=4)
    >>> told[0]
    'the branch of cycles beside 0.2'
    """
    if not isinstance(part, str) or not (to is None or callable(to)):
        raise ParameterTypeError(
            f"part = {part!r}, to = {to!r}; give a text, and a function of one text, as "
            "show_progress(to=print)"
        )
    work = _Work(to or str, part)  # a line listens for itself
    token = _work.set(work)
    try:
        if to is None:
            with _line(work):
                yield
        else:
            yield
    finally:
        _work.reset(token)


@contextmanager
def doing(text: str, *values: object) -> Iterator[None]:
    """A part of what is computed, ``text.format(*values)``; where nobody listens, nothing is
    formatted.
    """
    work = _work.get()
    if work is None:
        yield
        return
    work.parts.append("")
    try:
        tell(text, *values)
        yield
    finally:
        work.parts.pop()


def tell(text: str, *values: object) -> None:
    """Another text in place of the innermost part."""
    work = _work.get()
    if work is not None:
        work.parts[-1] = text.format(*values)
        work.listener(str(work))


def _line(work: _Work) -> AbstractContextManager[object]:
    """A line on stderr."""
    from rich.console import Console
    from rich.text import Text

    console = Console(stderr=True)
    if not console.is_terminal:
        return _lines(work)
    status = console.status(Text(str(work)))
    work.listener = lambda text: status.update(Text(text))
    return status


@contextmanager
def _lines(work: _Work) -> Iterator[None]:
    """A line after :data:`LONG` seconds, and further ones after twice the time each."""
    begun, done = time.monotonic(), threading.Event()

    def say() -> None:
        wait = LONG
        while not done.wait(wait):
            spent = time.monotonic() - begun
            print(f"{work}: {spent:.0f} s so far", file=sys.stderr)
            wait = spent

    teller = threading.Thread(target=say, daemon=True)
    teller.start()
    try:
        yield
    finally:
        done.set()
        teller.join()


@contextmanager
def advance(progress: bool, total: int, done: int) -> Iterator[Callable[[], None]]:
    """A function to call after every point, which moves a bar if one is wanted, and else tells who
    listens.
    """
    if not progress:
        made = itertools.count(done + 1)
        with doing("{} of {} points", done, total):
            yield lambda: tell("{} of {} points", next(made), total)
        return
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TimeElapsedColumn,
        TimeRemainingColumn,
    )

    columns = (
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        "ends in",
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=Console(stderr=True)) as bar:
        task = bar.add_task("", total=total, completed=done)
        yield lambda: bar.advance(task)
