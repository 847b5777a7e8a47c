"""Parameters of the model, dimensionless and in newtons, metres and seconds, validated once."""

from ...numerics.interval_arrays import FloatArray
from .dimensionless import ARTICLE, NAMES, RANGES, Parameters
from .physical import PhysicalParameters, Scales
from .ranges import FINITE, NOT_NEGATIVE, POSITIVE, Range, as_count, as_number, as_numbers, degrees, shown
from .sets import ParameterSet, common_shape, named

__all__ = [
    "ARTICLE",
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
    "shown",
]
