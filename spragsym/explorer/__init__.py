"""The explorer: a page of any model that computes in the browser, by exported JavaScript."""

from .page import Page, explore, explorer_page

__all__ = ["Page", "explore", "explorer_page"]
