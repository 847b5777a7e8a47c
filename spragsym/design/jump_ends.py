"""Where followed states end, of many points: what jump values and their gradients are told from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ..models.parameters import FloatArray


@dataclass(frozen=True)
class Ends:
    """Where the states of many points end: the value, NaN where they don't, a bound on its error, and the coordinates at a fold.

    ``value`` and ``error`` have the shape of the points, ``state`` has (n, …); ``reasons`` says of which points, by their
    position in ``value.flat``, nothing is known, and why.
    """

    value: FloatArray
    error: FloatArray
    state: FloatArray
    reasons: Mapping[int, str]
