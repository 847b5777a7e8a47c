"""The article as printed, with its mistakes: every numbered equation, appendix coefficient and
definition, and the base values.

J. Kang and J. Nam, "Minimal Model for Sprag-Slip Oscillation as Catastrophe-Type Behavior", Applied
Sciences 10 (2020) 2748. Nothing of the file ``article.toml`` is derived or corrected.
"""

from functools import cache
from pathlib import Path

import sympy as sp
from sympy import Rational

from ..statements import papers
from ..statements.papers import Paper
from .nomenclature import alpha, beta, kappa, mu0, sigma


@cache
def printed() -> Paper:
    """The printed statements, in the order of the article."""
    return papers.read(Path(__file__).with_name("article.toml"))


#: The article's base values (Section 3), exactly.
BASE = {
    mu0: Rational(1, 2),
    kappa: Rational(7, 1000),
    alpha: Rational(7, 1000),
    sigma: Rational(1, 10),
    beta: sp.Integer(0),
}
