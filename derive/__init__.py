"""The derivation, one step of the article's argument a module: run it with ``make derive`` or ``python -m derive``."""
