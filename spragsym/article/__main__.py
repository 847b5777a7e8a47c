"""``python -m spragsym.article`` writes the record of the claims anew."""

from pathlib import Path

from . import STATEMENTS, record_text, run

text = record_text(run(STATEMENTS))
Path(__file__).with_name("record.json").write_text(text, encoding="utf-8", newline="\n")
