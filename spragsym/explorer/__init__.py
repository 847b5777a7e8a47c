"""The explorer: a page of any model that computes in the browser, by exported JavaScript."""

from .page import ExplorerPage, explore, explorer_page

__all__ = ["ExplorerPage", "explore", "explorer_page"]
