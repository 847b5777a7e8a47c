"""``python -m spragsym.article`` computes every statement and writes record.json anew."""

from pathlib import Path

from . import STATEMENTS, record_text, run

text = record_text(run(STATEMENTS))
Path(__file__).with_name("record.json").write_text(text, encoding="utf-8", newline="\n")
