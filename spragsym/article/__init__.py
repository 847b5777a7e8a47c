"""Every computable statement of the article's text, computed: what is stated, what comes out, how far apart they are.

:func:`run` computes all rows; :func:`drifted` holds them against the committed record, which ``python -m spragsym.article``
writes anew.
"""

from __future__ import annotations

from .ledger import Found, Row, Statement, Status, drifted, record_text, recorded, run
from .statements import STATEMENTS

__all__ = ["STATEMENTS", "Found", "Row", "Statement", "Status", "drifted", "record_text", "recorded", "run"]
