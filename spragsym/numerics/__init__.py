"""Exact and enclosed numbers: interval arithmetic of any precision, polynomials, their real roots."""

#: Modules that other rooms ask; each is loaded when it is imported.
__all__ = [
    "adaptive_bits", "affine", "arithmetic", "ball_functions", "balls", "bernstein", "boxes", "certified_roots", "chains",
    "companion_roots", "complex_numbers", "contractors", "decimals", "descartes", "determinants", "double_double",
    "half_angle", "interval_arrays", "interval_functions", "jets", "krawczyk", "polynomials", "reduction", "rounded",
]  # fmt: skip
