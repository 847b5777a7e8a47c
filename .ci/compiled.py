"""One line for each extension module that an installation left out: they are optional, so pip says
nothing when one fails.

``python .ci/compiled.py``, after an installation, as the Makefile does.
"""

from __future__ import annotations

import shutil
import sys
import sysconfig

from spragsym.kang_nam.quartic import compiled
from spragsym.motion import with_compiled
from spragsym.numerics import contractors, plans, tape

#: Source file, whether its module is there, and what serves without it.
EXTENSIONS = (
    ("spragsym/kang_nam/quartic/_compiled.c", compiled.available, "equilibria are solved by NumPy"),
    (
        "spragsym/motion/_carried.c",
        with_compiled.available,
        "motion is integrated by heyoka or SciPy",
    ),
    ("spragsym/numerics/_tape.c", tape.available, "boxes are searched by NumPy"),
    ("spragsym/numerics/_contractors.c", contractors.available, "boxes are judged by NumPy"),
    ("spragsym/numerics/_search.c", plans.available, "boxes are looked at by NumPy"),
)


def main() -> None:
    """Say on stderr what was not compiled, why as far as is known, and what serves instead."""
    compiler = (sysconfig.get_config_var("CC") or "cc").split()[0]
    why = (
        "its compilation failed"
        if shutil.which(compiler)
        else f"no C compiler {compiler} was found"
    )
    for source, available, instead in EXTENSIONS:
        if not available():
            print(
                f"{source}: {why}; {instead}, right but slower. The compiler's words: pip "
                "install -v -e .",
                file=sys.stderr,
            )


if __name__ == "__main__":
    main()
