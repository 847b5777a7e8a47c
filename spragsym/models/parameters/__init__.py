"""Parameters of the model, dimensionless and in newtons, metres and seconds, validated once."""

from .dimensionless import ARTICLE, BELT_SPEED, CREEP, NAMES, RANGES, Parameters
from .physical import PhysicalParameters, Scales
from .ranges import FINITE, NOT_NEGATIVE, POSITIVE, FloatArray, Range, as_count, as_number, as_numbers, degrees, range_of, shown
from .sets import ParameterSet, common_shape, named

__all__ = [
    "ARTICLE",
    "BELT_SPEED",
    "CREEP",
    "FINITE",
    "NAMES",
    "NOT_NEGATIVE",
    "POSITIVE",
    "RANGES",
    "FloatArray",
    "ParameterSet",
    "Parameters",
    "PhysicalParameters",
    "Range",
    "Scales",
    "as_count",
    "as_number",
    "as_numbers",
    "common_shape",
    "degrees",
    "named",
    "range_of",
    "shown",
]
