"""Equilibria of any model: all of them by search, each proved, with its type of stability."""

#: Modules that other rooms ask; each is loaded when it is imported.
__all__ = [
    "balance",
    "equilibria",
    "forces",
    "namespaces",
    "polar",
    "precise_balance",
    "reference_state",
    "regions",
    "search",
    "stability",
    "states",
]
