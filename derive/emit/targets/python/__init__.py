"""Python: plain algebra for any number type, the kernel for arrays, and the table of quantities."""

from __future__ import annotations

import ast
import textwrap

from .. import Material, Target, runtime
from . import algebra, kernel, quantities


def render(material: Material) -> dict[str, str]:
    """A package: one module for each of the catalogue's, ``kernel.py`` if there is a kernel, and ``quantities.py``."""
    header = textwrap.fill(material.header, 110)
    return {
        "__init__.py": _package(material),
        "py.typed": "",
        "_broadcast.py": runtime(__file__, "_broadcast.py").replace("@header@", material.header),
        **{f"{module.name}.py": algebra.render(module, material.quantities, material.header) for module in material.modules},
        **(_kernel(material, header) if material.kernel.routines else {}),
        "quantities.py": quantities.render(material, header),
    }


def _kernel(material: Material, header: str) -> dict[str, str]:
    """The kernel, its cube root and its choice, and double-double numbers for it to run on."""
    own = ("_cube_root.py", "_where.py")
    files = {"kernel.py": kernel.render(material, header)}
    files |= {name: runtime(__file__, name).replace("@header@", material.header) for name in own}
    if material.arithmetic.routines:
        files["double_double.py"] = kernel.arithmetic(material.arithmetic, header)
    return files


def _package(material: Material) -> str:
    """The package's docstring, which lists its modules, and the hash by which results say what they were computed with."""
    summaries = {module.name: module.summary for module in material.modules}
    if material.kernel.routines:
        summaries["kernel"] = (ast.get_docstring(ast.parse(material.kernel.text)) or "").partition("\n")[0]
    if material.arithmetic.routines:
        summaries["double_double"] = (ast.get_docstring(ast.parse(material.arithmetic.text)) or "").partition("\n")[0]
    summaries["quantities"] = "What every name stands for, its unit, its allowed values and its value in the article."
    listed = "\n".join(f"- :mod:`{name}`: {summary}" for name, summary in summaries.items())
    return (
        f'"""Plain algebra, derived from first principles and checked against the article.\n\n{listed}\n\n{material.header}\n"""\n\n'
        f'#: SHA-256 over all files that were generated with this one.\nSOURCE_HASH = "{material.digest}"\n'
    )


TARGET = Target("python", "Python", "", render, variants=True)
