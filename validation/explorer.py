"""The search on the explorer's pages of models against Python's proofs: ``python -m validation.explorer [SECONDS]`` a model.

Random points about the base values, in contact and in lift-off; the number of states of the page is held against the number that is
proved. Points that Python does not decide are counted apart.
"""

from __future__ import annotations

import sys
import tempfile
import time
from pathlib import Path

from click.testing import CliRunner

import spragsym as ss
from spragsym.cli.explore import explore
from tests.conformance.test_explorer_pages import points
from tests.explorer_pages import chromium

MODELS = ("two_springs", "trolley", "hertz_contact", "cubic_contact", "inclined_belt")


def main(seconds: float = 30.0) -> None:
    """Print a line for each model."""
    with tempfile.TemporaryDirectory() as folder, chromium() as browser:
        for name in MODELS:
            model, out = ss.load(name), Path(folder) / f"{name}.html"
            CliRunner().invoke(explore, ["--model", name, "--out", str(out), "--no-open"], catch_exceptions=False)
            page = browser.new_page()
            page.goto(out.as_uri())
            compared = different = undecided = 0
            end = time.monotonic() + seconds
            for point in points(model, 10_000):
                for contact in (True, False):
                    proved = ss.equilibria(model.Parameters(**point), contact=contact)
                    found = page.evaluate("p => window.spragsym.equilibria(p)", {**point, "contact": contact})
                    compared += 1
                    undecided += not proved.complete
                    different += bool(proved.complete) and found["count"] != int(proved.count)
                if time.monotonic() > end:
                    break
            page.close()
            print(f"{name:14} {compared:5} compared, {different} different, {undecided} undecided in Python", flush=True)


if __name__ == "__main__":
    main(*(float(text) for text in sys.argv[1:]))
