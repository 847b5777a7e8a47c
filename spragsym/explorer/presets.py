"""Points that the explorer starts from, and units of the user: what one of the model's dimensionless numbers is."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..errors import ParameterError
from ..models.parameters import ParameterSet


@dataclass(frozen=True)
class Preset:
    """A named point of all parameters.

    Attributes
    ----------
    name : str
        What the page's list says.
    point : dict of str to float
        The parameters of the model by their names, angles in radians.
    """

    name: str
    point: dict[str, float]

    @classmethod
    def of(cls, name: str, parameters: ParameterSet) -> Preset:
        """A preset at one point.

        Raises
        ------
        ParameterError
            If a parameter is missing, or is not a single number.
        """
        values = {key: getattr(parameters, key) for key in parameters.model.parameters}
        for key, value in values.items():
            if value is None or np.ndim(value):
                raise ParameterError(f"{key} = {value!r} is not one number; a preset of the explorer is one point")
        return cls(name, {key: float(value) for key, value in values.items()})


@dataclass(frozen=True)
class Units:
    """Units of the data that a page begins at.

    Attributes
    ----------
    source : str
        Where they are from, in words that the page shows.
    length, time, force : tuple of (float, str)
        What 1 is in the unit that is named.
    parameters : dict of str to tuple of (str, float, str)
        For dimensionless parameters that have a quantity with a unit: its name, what 1 is, and the unit.
    """

    source: str
    length: tuple[float, str]
    time: tuple[float, str]
    force: tuple[float, str]
    parameters: dict[str, tuple[str, float, str]] = field(default_factory=dict)
