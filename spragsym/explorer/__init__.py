"""The explorer: a page of any model that computes in the browser, by exported JavaScript."""

from .page import explorer_page
from .presets import Preset
from .units import Units

__all__ = ["Preset", "Units", "explorer_page"]
