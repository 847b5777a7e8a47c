"""``python -m spragsym``, and the command ``spragsym``: Ctrl-C is heard before anything else is
imported.
"""

import os
import signal

from .core.interrupts import INTERRUPTED, begun


def run() -> None:
    """The command line, as a process of its own."""
    begun()
    from .cli import main

    try:
        main()
    except SystemExit as stop:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # all is said
        if (
            stop.code == INTERRUPTED
        ):  # the interpreter would end as one that was killed, had Ctrl-C come while a text was run
            os._exit(INTERRUPTED)
        raise


if __name__ == "__main__":
    run()
