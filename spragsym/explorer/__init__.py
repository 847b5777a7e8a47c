"""The explorer: a page of any model that computes in the browser, by exported JavaScript."""

from .page import Page, explore, explorer_page
from .presets import Preset, Units

__all__ = ["Page", "Preset", "Units", "explore", "explorer_page"]
