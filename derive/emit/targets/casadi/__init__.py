"""CasADi: a module of functions of numbers, SX and MX, which CasADi differentiates and passes to
its optimizers and integrators.
"""

from .. import Material, python

#: What stands for ``numpy``; a target that has it is one of Python.
NAMESPACE = "casadi"
RESERVED = python.RESERVED


def render(material: Material) -> dict[str, str]:
    """The module."""
    return python.render(material, NAMESPACE, "if_else", {})
