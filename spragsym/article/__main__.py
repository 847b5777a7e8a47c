"""``python -m spragsym.article`` writes the record of the claims anew; with ``measure``, that of time and memory."""

import sys
from pathlib import Path

from . import STATEMENTS, record_text, run

if sys.argv[1:] == ["measure"]:
    from .measure import write

    write()
elif not sys.argv[1:]:
    text = record_text(run(STATEMENTS))
    Path(__file__).with_name("record.json").write_text(text, encoding="utf-8", newline="\n")
else:
    sys.exit("usage: python -m spragsym.article [measure]")
