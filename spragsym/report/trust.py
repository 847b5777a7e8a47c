"""The model that a file names, whose code may run only where its user trusts it."""

from __future__ import annotations

import os

from ..core.errors import ParameterError
from ..models.load import shipped
from ..models.quantities import quantities


def trusted_model(name: object, trust: bool | str) -> str:
    """The name of a model; a folder whose code is not trusted is refused."""
    if not isinstance(name, str):
        raise ParameterError(f'{name!r} is no name; write model = "kang_nam"')
    if (
        name not in shipped()
        and trust is not True
        and trust != name
        and os.path.isdir(name[:4096].replace("\0", ""))
    ):
        cure = f"if you trust it, give --trust or --model {name}, in Python trust=True"
        raise ParameterError(f"{name!r} is a folder, whose code runs; {cure}")
    quantities(name)
    return name
