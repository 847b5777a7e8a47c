"""Handling of Ctrl-C (SIGINT), also where libraries swallow the KeyboardInterrupt: in imports and
in callbacks of compiled code.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from types import FrameType
from typing import Any, ClassVar

#: Exit code of a command that Ctrl-C ends.
INTERRUPTED = 130


def _handler() -> Callable[[int, FrameType | None], object] | None:
    """The present handler of Ctrl-C; None in another thread, or if Ctrl-C is ignored."""
    handler = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is threading.main_thread() and callable(handler):
        return handler
    return None


@contextmanager
def heard() -> Iterator[Callable[[], None]]:
    """Give a function that raises KeyboardInterrupt if there was a Ctrl-C within the body.

    It is raised at the end of the body too, even if the body ends with another exception.
    """
    seen: list[int] = []
    former = _handler()
    if former is None:
        yield lambda: None
        return

    def handler(number: int, frame: FrameType | None) -> None:
        try:
            former(number, frame)
        except KeyboardInterrupt:
            seen.append(number)
            raise

    def check() -> None:
        if seen:
            raise KeyboardInterrupt

    signal.signal(signal.SIGINT, handler)
    try:
        yield check
        check()
    except Exception:
        check()
        raise
    finally:
        if signal.getsignal(signal.SIGINT) is handler:
            signal.signal(signal.SIGINT, former)


@contextmanager
def held() -> Iterator[None]:
    """Delay Ctrl-C to the end of the body, as for the import of a library."""
    waiting: list[Any] = []
    former = _handler()
    if former is None:
        yield
        return

    def handler(number: int, frame: FrameType | None) -> None:
        waiting.append(frame)
        if _Ending.installed is not None:
            _Ending.installed.count_down()

    signal.signal(signal.SIGINT, handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, former)
        if waiting:
            former(signal.SIGINT, waiting[0])


class _Ending:
    """The handler of Ctrl-C of a command: raises KeyboardInterrupt, and ends the process 0.7 s
    later if it has not ended by itself.
    """

    installed: ClassVar[_Ending | None] = None

    def __init__(self) -> None:
        self.under_way = False
        self.timer: threading.Timer | None = None

    def __call__(self, number: int, frame: object) -> None:
        if not self.under_way:
            cut()
        self.count_down()
        raise KeyboardInterrupt

    def count_down(self) -> None:
        if self.timer is None:
            # Seconds that a command has, once interrupted, to say what is kept.
            self.timer = threading.Timer(0.7, cut)
            self.timer.daemon = True
            self.timer.start()


def cut() -> None:
    """End the process immediately, without cleaning up."""
    with suppress(OSError):
        os.write(2, b"spragsym: interrupted\n")
    os._exit(INTERRUPTED)


@contextmanager
def ending() -> Iterator[None]:
    """Run a command so that after Ctrl-C the process ends within a second.

    KeyboardInterrupt is raised at the end of the body at the latest. Where Python can't raise it,
    as in a callback of an import lock, nothing is printed.
    """
    if (
        threading.current_thread() is not threading.main_thread()
        or signal.getsignal(signal.SIGINT) == signal.SIG_IGN
    ):
        yield
        return
    own = _Ending.installed or begun()
    own.under_way = True
    former = sys.unraisablehook

    def unraisable(lost: sys.UnraisableHookArgs) -> None:
        if not isinstance(lost.exc_value, KeyboardInterrupt):  # that is raised at the end
            former(lost)

    sys.unraisablehook = unraisable
    try:
        with heard():
            yield
    finally:
        sys.unraisablehook = former
        if own.timer is not None:
            own.timer.cancel()
        own.timer, _Ending.installed = None, None
        if signal.getsignal(signal.SIGINT) is own:
            signal.signal(signal.SIGINT, signal.default_int_handler)


def begun() -> _Ending:
    """Install the handler: until a command begins, Ctrl-C ends the process immediately, unless
    Ctrl-C is ignored.
    """
    own = _Ending.installed = _Ending()
    if signal.getsignal(signal.SIGINT) != signal.SIG_IGN:
        signal.signal(signal.SIGINT, own)
    return own
