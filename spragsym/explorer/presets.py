"""Points that the explorer starts from."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..errors import ParameterError
from ..parameters import ARTICLE, NAMES, Parameters


@dataclass(frozen=True)
class Preset:
    """A named point of all six parameters.

    Attributes
    ----------
    name : str
        What the page's list says.
    point : dict of str to float
        θ₀ in radians, μ₀, κ, α, σ, β.
    """

    name: str
    point: dict[str, float]

    @classmethod
    def of(cls, name: str, parameters: Parameters) -> Preset:
        """A preset at one point.

        Raises
        ------
        ParameterError
            If θ₀ is missing, or the parameters are not single numbers.
        """
        values = {key: getattr(parameters, key) for key in NAMES}
        for key, value in values.items():
            if value is None or np.ndim(value):
                raise ParameterError(f"{key} = {value!r} is not one number; a preset of the explorer is one point")
        return cls(name, {key: float(value) for key, value in values.items()})


#: The article's cases: name, θ₀ in degrees, and what differs from its base values.
_CASES: tuple[tuple[str, float, dict[str, float]], ...] = (
    ("Article, base values, before the fold: θ₀ = 30°", 30.0, {}),
    ("Article, past the fold: θ₀ = 49°", 49.0, {}),
    ("Article, friction below the cusp: μ₀ = 0.15", 49.0, {"mu0": 0.15}),
    ("Article, Figure 8: β = 1", 30.0, {"beta": 1.0}),
    ("Article, Figure 8: β = 2, no jump", 30.0, {"beta": 2.0}),
    ("Article, Figure 9: α = 0.07", 30.0, {"alpha": 0.07}),
    ("Article, Figure 9: α = 0.7, flutter at θ₀ = 150°", 150.0, {"alpha": 0.7}),
    ("Article, Figure 10: σ = 0.01", 30.0, {"sigma": 0.01}),
    ("Article, Figure 10: σ = 1", 30.0, {"sigma": 1.0}),
)


def article_presets() -> tuple[Preset, ...]:
    """The article's cases, its base values first.

    Examples
    --------
    >>> article_presets()[0].point["mu0"]
    0.5
    """
    return tuple(Preset(name, {"theta0": math.radians(angle), **ARTICLE, **changed}) for name, angle, changed in _CASES)
