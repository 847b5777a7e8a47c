"""CasADi: a module of functions of numbers, SX and MX, to be differentiated and handed to its
optimizers and integrators.
"""

from .. import Material, python

#: What stands for ``numpy``.
NAMESPACE = "casadi"


def render(material: Material) -> dict[str, str]:
    """The module."""
    return python.render(material, NAMESPACE, "if_else", {})
