"""The explorer: one page that computes the article's model in the browser, by the exported JavaScript."""

from .page import explorer_page
from .presets import Preset, article_presets

__all__ = ["Preset", "article_presets", "explorer_page"]
