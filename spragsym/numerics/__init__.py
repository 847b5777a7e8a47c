"""Exact and enclosed numbers: interval arithmetic of any precision, polynomials, their real roots."""
