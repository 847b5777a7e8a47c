"""What the explorer takes from a page's derivation: its functions as an ES module, and its drawing."""

from __future__ import annotations

from importlib import resources

from ..errors import ParameterError
from ..models import Model


def shipped(model: Model) -> tuple[str, str] | None:
    """The module and the drawing, as SVG, that come with the package; None for a model that has none there."""
    folder = resources.files("spragsym.generated") / "models" / model.name
    files = [folder / f"{model.name}.{ending}" for ending in ("mjs", "svg")]
    if model.where != model.name or not files[0].is_file():
        return None
    module, drawing = (file.read_text(encoding="utf-8") for file in files)
    return module, drawing


def required(model: Model) -> tuple[str, str]:
    """The same.

    Raises
    ------
    ParameterError
        If the package has none.
    """
    found = shipped(model)
    if found is None:
        raise ParameterError(f"derived = None: {model.name} is derived for the browser by spragsym explore --model {model.where}")
    return found
