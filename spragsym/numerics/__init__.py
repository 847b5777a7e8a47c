"""Exact and enclosed numbers: interval arithmetic of any precision, polynomials, their real roots;
sizes of vectors.
"""

#: Modules that other rooms ask; each is loaded when it is imported.
__all__ = [
    "affine",
    "arithmetic",
    "balls",
    "bernstein",
    "boxes",
    "certified_roots",
    "chains",
    "columns",
    "contractors",
    "decimals",
    "definite",
    "double_double",
    "interval_arrays",
    "jets",
    "polynomials",
    "precise_roots",
    "vectors",
]
