"""Every computable statement of the article's text, computed: what is stated, and what comes out.

:func:`run` computes the row of every statement; :func:`drifted` compares the rows with the
committed record, which ``python -m spragsym.article`` writes anew.
"""

from .ledger import STATEMENTS, ArticleStatement, drifted, record_text, recorded, run

__all__ = ["STATEMENTS", "ArticleStatement", "drifted", "record_text", "recorded", "run"]
