"""Which functions are generated: name, arguments, results, and the algebra of each, taken from the
derivation.
"""

from ...emit.function import Function, Module
from . import catastrophe, equilibrium, laws, linear_sprag, stability

__all__ = ["Function", "Module", "modules"]


def modules() -> tuple[Module, ...]:
    """Everything that is generated."""
    return tuple(
        part.module() for part in (equilibrium, stability, catastrophe, linear_sprag, laws)
    )
