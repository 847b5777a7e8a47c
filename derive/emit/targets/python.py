"""Python for a library that differentiates, JAX or CasADi: one module, whose functions have the
statements of those for NumPy; results are lists.
"""

import keyword
import re
import sys
import textwrap
from collections.abc import Mapping

from ..definitions import WIDTH, Definition, nested, ported
from . import Angles, Material, taken

#: Modules that a library of Python imports, and words that are no names.
RESERVED = frozenset(
    map(
        str.casefold,
        (
            *sys.stdlib_module_names,
            *keyword.kwlist,
            *["casadi", "jax", "jaxlib", "ml_dtypes", "numpy", "opt_einsum", "scipy"],
        ),
    )
)
#: Functions with kinks choose one of two sides, so that the library takes the derivative of that
#: side.
_HEAD = """
import {module} as xp

PARAMETERS = {parameters}
BASE = {base}


def _sign(u):
    return xp.{where}(u > 0, 1.0, xp.{where}(u < 0, -1.0, 0.0))


def _abs(u):
    return xp.{where}(u < 0, -u, u)


"""


def render(material: Material, module: str, where: str, names: Mapping[str, str]) -> dict[str, str]:
    """The module, written with ``module``'s functions under ``xp``: ``where`` is its choice, and
    ``names`` says which of its functions have other names than NumPy's.
    """
    functions = material.algebra.values()
    meanings = {
        name: material.quantities[name].meaning
        for it in functions
        for name in taken(it, material.angles)
    }
    table = "\n".join(
        textwrap.fill(f"{name} : {meanings[name]}", WIDTH, subsequent_indent="    ")
        for name in sorted(meanings)
    )
    said = f"{material.summary}\n\n{table}\n\n{material.header}".replace("\\", r"\\").replace(
        '""', r'"\"'
    )
    head = _HEAD.format(
        module=module, where=where, parameters=material.parameters, base=dict(material.base_values)
    )
    ports = {"abs": "_abs", "sign": "_sign", **names}
    body = "\n\n\n".join(_function(function, material.angles, ports) for function in functions)
    language = "jax" if where == "where" else "casadi"
    own = material.runtime.get(language, {})
    return {**own, f"{material.library}.py": f'"""{said}\n"""\n{head}{body}\n'}


def _expression(text: str, ports: Mapping[str, str]) -> str:
    """An expression with the library's functions; integers that do not fit into JAX's 32 bits are
    floats.
    """
    return re.sub(r"(?<![\w.])\d{10,}(?![\w.])", r"\g<0>.0", ported(text, ports, "xp."))


def _function(function: Definition, angles: Angles, ports: Mapping[str, str]) -> str:
    names = taken(function, angles)
    given = [*names, *(f"{name}=0" for name in function.further)]
    said = f'"""{function.summary} Returns {function.returns}. {function.origin}"""'
    turned = [
        (parts[-2:], angle)
        for angle, parts in angles.items()
        if angle in names and {*parts[-2:]} & function.read
    ]
    lines = [
        f"def {function.name}({', '.join(given)}):",
        textwrap.indent(
            textwrap.fill(said, WIDTH, break_long_words=False, break_on_hyphens=False), "    "
        ),
        *(
            f"    {cosine}, {sine} = xp.cos({angle}), xp.sin({angle})"
            for (cosine, sine), angle in turned
        ),
        *(f"    {name} = {_expression(value, ports)}" for name, value in function.statements),
        f"    return {nested(function.results, '[]', lambda leaf: _expression(leaf, ports))}",
    ]
    return "\n".join(lines)
