"""Sphinx: ``make docs``. Needs no network; pages with code cells are executed."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from spragsym import __version__  # noqa: E402  # after the path that it is found on

project = "spragsym"
author = copyright = "The spragsym developers"
version = release = __version__

extensions = [
    "myst_nb",
    "numpydoc",
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "sphinx-mathjax-offline",
]
exclude_patterns = ["_build", "jupyter_execute"]
nitpicky = False

# Code cells run at every build, and an error fails it.
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 300
nb_merge_streams = True

myst_enable_extensions = ["dollarmath", "colon_fence"]
myst_fence_as_directive = ["math"]  # as GitHub writes it
myst_heading_anchors = 4
suppress_warnings = ["myst.xref_missing"]

autodoc_typehints = "none"  # numpydoc says types
autodoc_member_order = "bysource"
numpydoc_show_class_members = False
numpydoc_xref_param_type = False

html_theme = "furo"
html_title = f"spragsym {__version__}"
# No fonts, scripts or formulas come from elsewhere.


def _bars(app: Any, what: str, name: str, item: Any, options: Any, lines: list[str]) -> None:
    """|x| in a docstring is an absolute value, not one of reStructuredText's substitutions."""
    lines[:] = [
        line if line.lstrip().startswith((">>>", "...")) else line.replace("|", r"\|")
        for line in lines
    ]


def setup(app: Any) -> None:
    app.connect("autodoc-process-docstring", _bars, priority=900)
