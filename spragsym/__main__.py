"""``python -m spragsym``, and the command ``spragsym``: Ctrl-C is heard before anything else is
imported.
"""

import os
import signal

from .core.interrupts import INTERRUPTED, begun


def run() -> None:
    """The command line, as a process of its own."""
    # Matrices are small here: more threads of BLAS would only wait, and count as processor time.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
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
