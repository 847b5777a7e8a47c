"""JAX: a module of functions for ``jax.jit``, ``grad`` and ``vmap``, in whatever precision JAX is
set to.
"""

from .. import Material, python


def render(material: Material) -> dict[str, str]:
    """The module."""
    # What stands for ``numpy``.
    return python.render(
        material, "jax.numpy", "where", {"atan": "xp.arctan", "atan2": "xp.arctan2"}
    )
