"""The explorer: pages that compute in the browser, by exported JavaScript: the article's model, and any other."""

from .article import explorer_page
from .models import Derived, model_page, model_preset
from .presets import Preset, article_presets
from .units import Units

__all__ = ["Derived", "Preset", "Units", "article_presets", "explorer_page", "model_page", "model_preset"]
