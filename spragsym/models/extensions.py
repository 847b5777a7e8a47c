"""Extension modules compiled on installation from the generated C library, and whether they are of the one that is here."""

import importlib
import warnings
from functools import cache

from ..generated import C_SOURCE


@cache
def fits(name: str) -> bool:
    """Whether an extension module was built, from the C library that was generated with the rest; one of another is a warning."""
    try:
        source = importlib.import_module(name).SOURCE
    except ImportError:
        return False
    if source != C_SOURCE:
        warnings.warn(
            f"{name} was compiled from another derivation and is not used: many points and motions take several times longer; "
            "install spragsym again",
            stacklevel=3,
        )
    return bool(source == C_SOURCE)
