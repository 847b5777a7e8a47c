"""JAX: a module of functions for ``jax.jit``, ``grad`` and ``vmap``, in whatever precision JAX is
set to.
"""

from .. import Material, python

#: What stands for ``numpy``; a target that has it is one of Python.
NAMESPACE = "jax.numpy"
RESERVED = python.RESERVED


def render(material: Material) -> dict[str, str]:
    """The module."""
    return python.render(material, NAMESPACE, "where", {"atan": "xp.arctan", "atan2": "xp.arctan2"})
