"""Equilibria of any model: all of them by search, each proved, with its type of stability."""

#: Modules that other rooms ask; each is loaded when it is imported.
__all__ = [
    "damping", "equilibria", "mechanics", "reference_state", "regions", "remarks", "search", "spectrum", "stability",
    "states", "tie_breaking",
]  # fmt: skip
