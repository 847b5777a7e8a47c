"""The explorer: a page of any model that computes in the browser, by exported JavaScript."""

from .page import Page, Preset, Units, explore, explorer_page

__all__ = ["Page", "Preset", "Units", "explore", "explorer_page"]
