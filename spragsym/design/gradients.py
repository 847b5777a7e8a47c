"""Gradient of a jump value with respect to each parameter, as a result."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..display import Table
from ..models.parameters import FloatArray
from ..results.named_columns import Columns


@dataclass(frozen=True, eq=False)
class JumpGradient(Columns, held_in="slopes"):
    """A jump value and its derivatives by the parameters, each of the shape of the points; NaN where nothing jumps.

    The derivative by the parameter that varies is 0: where it jumps does not depend on where it started. Each derivative is an
    attribute under the name of its parameter.
    """

    vary: str
    value: FloatArray
    slopes: Mapping[str, FloatArray]

    def as_table(self) -> Table:
        """The value and its slopes; of many points the smallest and the largest."""
        rows = []
        for name, values in {"value": self.value, **self.slopes}.items():
            known = np.asarray(values)[~np.isnan(self.value)]
            ends = (f"{known.min():.10g}", f"{known.max():.10g}") if known.size else ("nan", "nan")
            rows.append((self.vary if name == "value" else f"slope by {name}", *ends))
        return Table(f"JumpGradient, vary = {self.vary}, radians", ("", "smallest", "largest"), tuple(rows))
