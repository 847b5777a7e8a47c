"""The kernel in Python: its own text, with names bound to NumPy's functions and to the generated algebra."""

from __future__ import annotations

import ast

from ...language import Kinds
from .. import Material


#: What the language's primitives are for arrays.
_PRIMITIVES = {
    "where": "where", "maximum": "maximum", "minimum": "minimum", "absolute": "abs", "sqrt": "sqrt", "cube_root": "cbrt",
}  # fmt: skip


def render(material: Material, header: str) -> str:
    """``generated/kernel.py``: functions of floats and of arrays of any float type."""
    source = material.kernel
    tree = ast.parse(source.text)
    kinds = Kinds(source)
    called = {name for it in source.routines.values() for name in kinds.calls(it)}
    homes = {function.name: module.name for module in material.modules for function in module.functions}
    used = sorted((homes[name], name) for name in called if name in homes)
    docstring = ast.get_docstring(tree) or ""
    first, rest = docstring.split("\n\n", 1)
    explained = rest.split("\n\n", 1)[1]
    bound = "\n".join(f"{name} = inspect.unwrap(_{home}.{name})" for home, name in used)
    primitives = "\n".join(f"{name}: Any = numpy.{function}" for name, function in _PRIMITIVES.items())
    imports = "\n".join(f"from . import {home} as _{home}" for home in sorted({home for home, _ in used}))
    counts = "\n".join(f"{name} = {value!r}" for name, value in material.counts.items())
    constants_and_code = "\n".join(source.lines[source.first_line - 1 :]) + "\n"
    return (
        f'"""{first}\n\n{explained}\n\n{header}\n"""\n\n'
        "from __future__ import annotations\n\nimport inspect\nfrom typing import Any, NamedTuple, TypeAlias\n\nimport numpy\n\n"
        f"{imports}\n\n"
        "#: A float, or an array of any float type.\nReal: TypeAlias = Any\n#: A truth value, or an array of such.\nFlag: TypeAlias = Any\n\n"
        f"{primitives}\n"
        f"{bound}\n\n"
        "# Counts of roundings, derived from the statements of this file and of the algebra.\n"
        f"{counts}\n\n{constants_and_code}"
    )
