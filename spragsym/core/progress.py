"""Progress of long computations, for callers who ask: a line on stderr, or calls of a function."""

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

#: Seconds after which a line says that a computation goes on, if stderr is no terminal.
LONG = 10.0


class _Work:
    """What is being computed: nested parts, the outermost first."""

    def __init__(self, listener: Listener, part: str) -> None:
        self.listener, self.parts = listener, [part]

    def __str__(self) -> str:
        return ": ".join(part for part in self.parts if part)


#: The work of this thread or asyncio task; other threads do not report to its listener.
_work: ContextVar[_Work | None] = ContextVar("spragsym.core.progress", default=None)


@contextmanager
def show_progress(part: str = "", to: Listener | None = None) -> Iterator[None]:
    """Report the progress of long computations within a ``with`` block.

    Parameters
    ----------
    part : str, optional
        What the block as a whole is.
    to : callable, optional
        Called with each text. Without it a line on stderr, in a notebook an output of the cell,
        says the last one: there and on a terminal until all is done, elsewhere after ten seconds,
        and again each time that it has taken twice as long.

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
    """Report a part of the work, ``text.format(*values)``, while the body runs.

    Without a listener nothing is formatted.
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
    """Replace the text of the innermost part, and call the listener."""
    work = _work.get()
    if work is not None:
        work.parts[-1] = text.format(*values)
        work.listener(str(work))


def _line(work: _Work) -> AbstractContextManager[object]:
    """A line on stderr that shows the work: updated on a terminal, else printed now and then."""
    from rich.console import Console
    from rich.text import Text

    console = Console(stderr=True)
    if console.is_jupyter:
        return _cell(work)
    if not console.is_terminal:
        return _lines(work)
    status = console.status(Text(str(work)))
    work.listener = lambda text: status.update(Text(text))
    return status


@contextmanager
def _cell(work: _Work) -> Iterator[None]:
    """One output of a notebook's cell, written anew at most five times a second."""
    from IPython.display import display

    latest = 0.0

    def shown(text: str) -> dict[str, str]:
        return {"text/plain": text}

    def said(text: str) -> None:
        nonlocal latest
        if time.monotonic() - latest > 0.2:
            latest = time.monotonic()
            place.update(shown(text), raw=True)

    # IPython's function has no types.
    place = display(shown(str(work)), raw=True, display_id=True)  # type: ignore[no-untyped-call]
    work.listener = said
    try:
        yield
    finally:
        place.update(shown(""), raw=True)


@contextmanager
def _lines(work: _Work) -> Iterator[None]:
    """Print a line after :data:`LONG` seconds, and again each time the elapsed time has doubled."""
    begun, done = time.monotonic(), threading.Event()

    def say() -> None:
        wait = LONG
        while not done.wait(wait):
            elapsed = time.monotonic() - begun
            print(f"{work}: {elapsed:.0f} s so far", file=sys.stderr)
            wait = elapsed

    teller = threading.Thread(target=say, daemon=True)
    teller.start()
    try:
        yield
    finally:
        done.set()
        teller.join()


@contextmanager
def advance(progress: bool, total: int, done: int) -> Iterator[Callable[[], None]]:
    """Give a function to be called after every point: it advances a progress bar if ``progress``,
    in a notebook a text, else it reports to the listener.
    """
    if not progress:
        made = itertools.count(done + 1)
        with doing("{} of {} points", done, total):
            yield lambda: tell("{} of {} points", next(made), total)
        return
    from rich.console import Console

    console = Console(stderr=True)
    if console.is_jupyter:  # where rich draws bars with another library only
        with show_progress(), advance(False, total, done) as one_more:
            yield one_more
        return
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
    with Progress(*columns, console=console) as bar:
        task = bar.add_task("", total=total, completed=done)
        yield lambda: bar.advance(task)
