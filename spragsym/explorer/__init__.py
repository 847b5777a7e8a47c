"""The explorer: a page of any model that computes in the browser, by exported JavaScript."""

from .cell import Page, explore
from .page import explorer_page
from .presets import Preset, Units

__all__ = ["Page", "Preset", "Units", "explore", "explorer_page"]
