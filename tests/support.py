"""What several test modules share: numbers in other forms, and generated modules by name."""

from __future__ import annotations

import importlib
from fractions import Fraction
from types import ModuleType

import mpmath

import spragsym.generated as generated_package


def as_fraction(value: mpmath.mpf) -> Fraction:
    """The rational that a number of mpmath is."""
    negative, mantissa, exponent, _ = value._mpf_
    return (-1) ** negative * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def as_mpf(value: Fraction) -> mpmath.mpf:
    """A rational to mpmath's precision."""
    return mpmath.mpf(value.numerator) / value.denominator


def generated(name: str) -> ModuleType:
    """A module of generated algebra."""
    return importlib.import_module(f"{generated_package.__name__}.{name}")
