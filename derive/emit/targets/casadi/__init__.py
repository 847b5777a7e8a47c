"""CasADi: a module of functions of numbers, SX and MX, which CasADi differentiates and passes to
its optimizers and integrators.
"""

from .. import Material, python


def render(material: Material) -> dict[str, str]:
    """The module."""
    # What stands for ``numpy``.
    return python.render(material, "casadi", "if_else", {})
