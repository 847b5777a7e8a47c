"""Points that the explorer starts from."""

from __future__ import annotations

from dataclasses import dataclass

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
