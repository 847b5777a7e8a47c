"""Comments in C: ASCII, wrapped."""

from __future__ import annotations

import textwrap

WIDTH = 124
#: Greek letters and signs as C sources have them.
_SPELLED = {
    "θ₀": "theta0", "θ": "theta", "μ₀": "mu0", "μ": "mu", "κ": "kappa", "α": "alpha", "σ": "sigma", "β": "beta", "n̄": "nbar",
    "π": "pi", "λ": "lambda", "τ": "tau", "√": "sqrt ", "²": "^2", "³": "^3", "⁴": "^4", "≤": "<=", "≥": ">=", "−": "-", "′": "'",
    "″": "''", "ℓ": "l", "φ": "phi", "P̃": "P~", "Q̃": "Q~", "×": "*", "ω": "omega", "``": "`", "–": "-", "δ": "delta", "∂": "d", "…": "...",
}  # fmt: skip


def comment(text: str) -> str:
    """A comment of its own, paragraph by paragraph."""
    paragraphs = [textwrap.fill(plain(paragraph), WIDTH - 6, subsequent_indent=" * ") for paragraph in text.split("\n\n")]
    return "/* " + "\n *\n * ".join(paragraphs) + " */\n"


def plain(text: str) -> str:
    """The words with letters and signs that every compiler reads."""
    for sign, words in _SPELLED.items():
        text = text.replace(sign, words)
    if not text.isascii():
        strange = "".join(sorted({letter for letter in text if not letter.isascii()}))
        raise ArithmeticError(f"C comments are ASCII, and {strange!r} has no spelling yet; add one in {__name__}: {text!r}")
    return text
