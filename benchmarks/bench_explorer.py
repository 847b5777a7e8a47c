"""How fast the explorer is: first picture from a file, and pictures a second while the point is dragged, with and without
3D, and while the surface is turned.

``python -m benchmarks.bench_explorer [SECONDS]``. Without a graphics card 3D is drawn by software. Beside pictures a second stands
the processor time of the page's own thread for each, which other programs on the machine hardly change.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import Any

from spragsym.explorer import explorer_page
from tests.explorer_pages import WITHOUT_WEBGL, chromium

#: Drags the point along a closed curve over both folds for the given milliseconds, one step a picture.
DRAG = """async length => {
  const over = document.querySelector("#plane .u-over"), box = over.getBoundingClientRect();
  const send = (type, u, v) => over.dispatchEvent(new PointerEvent(type, {
    clientX: box.left + u * box.width, clientY: box.top + v * box.height, pointerId: 1, bubbles: true }));
  over.setPointerCapture = () => {};
  over.hasPointerCapture = () => true;
  const begun = performance.now(), gaps = [];
  let last = begun;
  send("pointerdown", 0.2, 0.5);
  while (last - begun < length) {
    await new Promise(requestAnimationFrame);
    const now = performance.now(), share = (now - begun) / 4000;
    gaps.push(now - last);
    last = now;
    send("pointermove", 0.2 + 0.5 * Math.abs(Math.sin(6 * share)), 0.5 - 0.2 * Math.sin(9 * share));
  }
  send("pointerup", 0.3, 0.5);
  return gaps.sort((a, b) => a - b);
}"""


#: Turns the surface for the given milliseconds.
TURN = """async length => {
  const canvas = document.querySelector("#space canvas[role=img]"), box = canvas.getBoundingClientRect();
  const send = (type, at) => canvas.dispatchEvent(new PointerEvent(type, {
    clientX: box.left + 200 + at, clientY: box.top + 200, pointerId: 1, bubbles: true, pointerType: "mouse", button: 0 }));
  canvas.setPointerCapture = () => {};
  canvas.releasePointerCapture = () => {};
  const begun = performance.now(), gaps = [];
  let last = begun;
  send("pointerdown", 0);
  while (last - begun < length) {
    await new Promise(requestAnimationFrame);
    const now = performance.now();
    gaps.push(now - last);
    last = now;
    send("pointermove", 100 * Math.sin((now - begun) / 500));
  }
  send("pointerup", 0);
  return gaps.sort((a, b) => a - b);
}"""


def measured(browser: Any, url: str, seconds: float, three: bool, what: str = "dragging") -> str:
    """One line about a page."""
    context = browser.new_context(viewport={"width": 1300, "height": 1000})
    if not three:
        context.add_init_script(WITHOUT_WEBGL)
    page = context.new_page()
    page.goto(url)
    page.wait_for_timeout(2000)
    first = page.evaluate("performance.getEntriesByType('paint')[0].startTime")
    session = context.new_cdp_session(page)
    session.send("Performance.enable", {"timeDomain": "threadTicks"})

    def busy() -> float:
        metrics = session.send("Performance.getMetrics")["metrics"]
        return float(next(entry["value"] for entry in metrics if entry["name"] == "TaskDuration"))

    before = busy()
    gaps = page.evaluate(DRAG if what == "dragging" else TURN, 1000 * seconds)
    spent = 1000 * (busy() - before) / len(gaps)
    context.close()
    return (
        f"{what:8} {'with 3D' if three else 'without 3D':11} first picture {first:5.0f} ms   {len(gaps) / seconds:5.1f} pictures a second   "
        f"median {gaps[len(gaps) // 2]:5.1f} ms   95 % {gaps[int(0.95 * len(gaps))]:5.1f} ms   processor {spent:4.1f} ms a picture"
    )


def main(seconds: float = 4.0) -> None:
    """Print the lines."""
    with tempfile.TemporaryDirectory() as folder, chromium() as browser:
        path = Path(folder) / "explorer.html"
        path.write_text(explorer_page(), encoding="utf-8")
        for three in (False, True):
            print(measured(browser, path.as_uri(), seconds, three))
        print(measured(browser, path.as_uri(), seconds, True, "turning"))


if __name__ == "__main__":
    main(*(float(text) for text in sys.argv[1:]))
