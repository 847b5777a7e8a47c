"""Every computable statement of the article's text, computed: what is stated, what comes out, how
far apart they are.

:func:`run` computes all rows; :func:`drifted` holds them against the committed record, which
``python -m spragsym.article`` writes anew.
"""

from .ledger import STATEMENTS, ArticleStatement, drifted, record_text, recorded, run

__all__ = ["STATEMENTS", "ArticleStatement", "drifted", "record_text", "recorded", "run"]
