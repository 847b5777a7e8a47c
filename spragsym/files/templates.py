"""Pages that come with the package as templates, filled in."""

from importlib import resources
from typing import Any

from ..errors import MissingExtraError


def filled(package: str, name: str, what: str, **values: Any) -> str:
    """The template of this name with values in it, text escaped in HTML; ``what`` it is needs the extra ``plot``."""
    try:
        from jinja2 import Environment, StrictUndefined
    except ModuleNotFoundError as error:
        raise MissingExtraError(what, "jinja2", "plot") from error
    text = (resources.files(package) / name).read_text(encoding="utf-8")
    made = Environment(autoescape=name.endswith(".html"), undefined=StrictUndefined, trim_blocks=True, keep_trailing_newline=True)
    return made.from_string(text).render(values)
