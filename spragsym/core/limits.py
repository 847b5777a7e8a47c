"""Limits of this process, for work that whoever started it ends and does without."""

from __future__ import annotations

import faulthandler
import signal
import sys
from pathlib import Path


def limit_time(seconds: float) -> None:
    """End this process after seconds of processor time from now, also inside of one operation; 0
    takes that back. On Windows they are those of the clock.
    """
    if sys.platform != "win32":
        signal.setitimer(signal.ITIMER_PROF, seconds)  # SIGPROF ends a process that ignores it not
    elif seconds:
        faulthandler.dump_traceback_later(seconds, exit=True)
    else:
        faulthandler.cancel_dump_traceback_later()


def limit_memory(more: int = 1 << 30) -> None:
    """Let this process take so many bytes more, where the system can hold it to that (Linux)."""
    sizes = Path("/proc/self/statm")
    if sys.platform != "win32" and sizes.is_file():
        import resource

        pages = int(sizes.read_text(encoding="ascii").split()[0])
        allowed = pages * resource.getpagesize() + more
        _, most = resource.getrlimit(resource.RLIMIT_AS)
        allowed = allowed if most == resource.RLIM_INFINITY else min(allowed, most)
        resource.setrlimit(resource.RLIMIT_AS, (allowed, most))
