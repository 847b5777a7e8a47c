"""Python: plain algebra for any number type, and the kernel for arrays."""

from __future__ import annotations

import textwrap

from .. import Material, Target, runtime
from . import algebra, kernel


def render(material: Material) -> dict[str, str]:
    """One module for each of the catalogue's, and ``kernel.py``."""
    header = textwrap.fill(material.header, 110)
    return {
        "_broadcast.py": runtime(__file__, "_broadcast.py").replace("@header@", material.header),
        **{f"{module.name}.py": algebra.render(module, material.header) for module in material.modules},
        "kernel.py": kernel.render(material, header),
    }


TARGET = Target("python", "Python", "", render, further=True)
