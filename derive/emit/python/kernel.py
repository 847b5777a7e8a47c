"""The kernel in Python: its own text, with names bound to NumPy's functions and to the generated
algebra.
"""

import ast
from collections.abc import Iterable, Mapping

from ..function import Module
from ..language import ROUGH, Source, definitions


#: What the language's primitives are for arrays; the cube root and the choice have files of their
#: own.
_PRIMITIVES = {"maximum": "maximum", "minimum": "minimum", "absolute": "abs", "sqrt": "sqrt"}


def render(
    source: Source, counts: Mapping[str, float], modules: Iterable[Module], header: str
) -> str:
    """``generated/kernel.py``: functions of floats and of arrays of any float type."""
    tree = ast.parse(source.text)
    homes = {function.name: module.name for module in modules for function in module.functions}
    used = sorted((homes[name], name) for name in source.called & homes.keys())
    bound = "\n".join(f"{name} = inspect.unwrap(_{home}.{name})" for home, name in used)
    imports = "\n".join(
        f"from . import {home} as _{home}" for home in sorted({home for home, _ in used})
    )
    counted = "\n".join(f"{name} = {value!r}" for name, value in counts.items())
    leading = ast.unparse(source.routines[ROUGH].body[-1])
    code = definitions(source.text).replace(
        f"    {leading}\n", '    return getattr(x, "high", x)\n', 1
    )
    return (
        f"{_docstring(tree, header)}"
        "from __future__ import annotations\n\nimport inspect\nfrom typing import Any, "
        "NamedTuple, TypeAlias\n\n"
        f"import numpy\n\n{imports}\nfrom ._cube_root import cube_root\nfrom ._where import "
        "where\n\n"
        f"{_TYPES}{_primitives(_PRIMITIVES)}\n"
        f"{bound}\n\n"
        "# Counts of roundings, derived from the statements of this file and of the algebra.\n"
        f"{counted}\n\n{code}"
    )


def arithmetic(source: Source, header: str) -> str:
    """``generated/double_double.py``: operations on numbers of two floats each, or arrays of
    such.
    """
    used = [name for name in _PRIMITIVES if name in source.called]
    return (
        f"{_docstring(ast.parse(source.text), header)}"
        "from __future__ import annotations\n\nfrom typing import Any, NamedTuple, "
        "TypeAlias\n\nimport numpy\n\n"
        f"from ._where import where\n\n{_TYPES}{_primitives(used)}\n\n{definitions(source.text)}"
    )


def of_floats(source: Source, header: str) -> str:
    """A module of functions of single floats, which call no algebra."""
    return (
        f"{_docstring(ast.parse(source.text), header)}"
        f"from __future__ import annotations\n\nfrom typing import Any, TypeAlias\n\n{_TYPES}"
        "absolute = abs\n\n\ndef where(condition: Flag, yes: Any, no: Any) -> Any:\n"
        '    """A choice."""\n    return yes if condition else no\n\n\n'
        f"{definitions(source.text)}"
    )


_TYPES = (
    "#: A float, or an array of any float type.\nReal: TypeAlias = Any\n#: A truth value, or an "
    "array of such.\nFlag: TypeAlias = Any\n\n"
)


def _docstring(tree: ast.Module, header: str) -> str:
    """The source's own, without the paragraph on how it is read."""
    first, rest = (ast.get_docstring(tree) or "").split("\n\n", 1)
    explained = rest.split("\n\n", 1)[1]
    return f'"""{first}\n\n{explained}\n\n{header}\n"""\n\n'


def _primitives(names: Iterable[str]) -> str:
    return "\n".join(f"{name}: Any = numpy.{_PRIMITIVES[name]}" for name in names)
