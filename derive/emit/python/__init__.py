"""Python: plain algebra for any number type, the kernel for arrays, and the table of quantities."""

from __future__ import annotations

import ast
import textwrap
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from ..function import Module
from ..language import Source
from ..quantities import Quantity
from . import algebra, kernel, quantities

_RUNTIME = Path(__file__).parent / "runtime"


@dataclass(frozen=True)
class Material:
    """What the package holds."""

    modules: tuple[Module, ...]
    kernel: Source
    arithmetic: Source  #: double-double numbers, for the kernel to run on
    counts: Mapping[str, float]  #: counts of roundings that the kernel's error bounds name
    quantities: Mapping[str, Quantity]  #: by their names in code
    parameters: tuple[str, ...]  #: of the dimensionless model, in the order in which functions take them
    base_values: Mapping[str, float]
    digest: str
    header: str  #: one sentence for the head of every file: where it comes from


def render(material: Material) -> dict[str, str]:
    """A package: one module for each of the catalogue's, ``kernel.py``, and ``quantities.py``."""
    header = textwrap.fill(material.header, 110)
    return {
        "__init__.py": _package(material),
        "py.typed": "",
        **{f"{module.name}.py": algebra.render(module, material.quantities, material.header) for module in material.modules},
        **{name: beside(name, material.header) for name in ("_broadcast.py", "_cube_root.py", "_where.py")},
        "kernel.py": kernel.render(material.kernel, material.counts, material.modules, header),
        "double_double.py": kernel.arithmetic(material.arithmetic, header),
        "quantities.py": quantities.render(material.quantities, material.parameters, material.base_values, header),
    }


def beside(name: str, header: str) -> str:
    """A file of ``runtime/``."""
    return (_RUNTIME / name).read_text(encoding="utf-8").replace("@header@", header)


def _package(material: Material) -> str:
    """The package's docstring, which lists its modules, and the hash by which results say what they were computed with."""
    summaries = {module.name: module.summary for module in material.modules}
    for name, source in (("kernel", material.kernel), ("double_double", material.arithmetic)):
        summaries[name] = (ast.get_docstring(ast.parse(source.text)) or "").partition("\n")[0]
    summaries["quantities"] = "What every name stands for, its unit, its allowed values and its value in the article."
    listed = "\n".join(f"- :mod:`{name}`: {summary}" for name, summary in summaries.items())
    return (
        f'"""Plain algebra, derived from first principles and checked against the article.\n\n{listed}\n\n{material.header}\n"""\n\n'
        f'#: SHA-256 over all files that were generated with this one.\nSOURCE_HASH = "{material.digest}"\n'
    )
