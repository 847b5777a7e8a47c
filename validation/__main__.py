"""``python -m validation``: the campaigns by name, and what each holds against what; ``python -m validation NAME ...`` runs one.

``python -m validation.NAME ...`` is the same.
"""

from __future__ import annotations

import ast
import runpy
import sys
from pathlib import Path

#: Modules that campaigns share.
_PARTS = ("parts", "motions_by_hand")


def main() -> int:
    """Run what is named, with the other words as its arguments."""
    here = Path(__file__).parent
    names = sorted(path.stem for path in here.glob("*.py") if not path.stem.startswith("_") and path.stem not in _PARTS)
    if len(sys.argv) == 1 or sys.argv[1] in ("-h", "--help"):
        for name in names:
            text = ast.get_docstring(ast.parse((here / f"{name}.py").read_text(encoding="utf-8"))) or ""
            print(f"{name:14} {text.splitlines()[0]}")
        return 0
    if sys.argv[1] not in names:
        print(f"{sys.argv[1]} is no campaign; they are {', '.join(names)}", file=sys.stderr)
        return 2
    name = sys.argv.pop(1)
    sys.argv[0] = f"python -m validation.{name}"
    runpy.run_module(f"validation.{name}", run_name="__main__")
    return 0


if __name__ == "__main__":
    sys.exit(main())
