"""Common parts of captions and axes: the paths shown, the article's letters, and sentences."""

from ..models.load import USUAL, load
from ..models.parameters import ARTICLE

#: The article's model.
MODEL = load(USUAL)

#: θ₀ of the paths a–a′ and b–b′.
PATHS_DEG = {"a": 60.0, "b": 40.0}

#: Parameters that the captions repeat, in the article's letters.
LETTERS = {"alpha": "α", "beta": "β", "kappa": "κ", "mu0": "μ₀", "sigma": "σ", "theta0": "θ₀"}

BASE_TEXT = ", ".join(f"{LETTERS[name]} = {ARTICLE[name]:g}" for name in ("kappa", "alpha", "sigma", "beta"))

LINES_TEXT = "Stable solid, divergent dashed, flutter dash-dotted; dots are folds."

RANGE_TEXT = "The ranges of the axes are our choice."

HIDDEN_TEXT = "Thin dashes lie behind a sheet."
