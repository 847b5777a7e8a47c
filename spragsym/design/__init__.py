"""From a brake to a verdict: how sure a jump is, how far it is, and what to change, for every
model.
"""

#: Modules that other rooms ask; each is loaded when it is imported.
__all__ = [
    "certificates",
    "design_space",
    "jumps",
    "margins",
    "probability",
    "sampling",
    "tube_certificates",
]
