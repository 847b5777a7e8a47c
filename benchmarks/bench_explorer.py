"""The explorer in a browser: first picture, and pictures while the point is dragged. Needs chromium and playwright."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from spragsym.explorer import explorer_page

FRAMES = 120
#: Drags the point over folds and around the cusp, one step a picture; times from picture to picture, milliseconds.
_DRAG = """async (frames) => {
  const over = document.querySelector("#plane .u-over"), box = over.getBoundingClientRect();
  over.setPointerCapture = () => {};
  over.hasPointerCapture = () => true;
  const send = (type, u, v) => over.dispatchEvent(new PointerEvent(type, {
    pointerId: 1, bubbles: true, clientX: box.left + u * box.width, clientY: box.top + v * box.height }));
  send("pointerdown", 0.1, 0.5);
  const gaps = [];
  let last = performance.now();
  for (let i = 0; i < frames; i++) {
    const now = await new Promise(requestAnimationFrame);
    gaps.push(now - last);
    last = now;
    send("pointermove", 0.3 + 0.25 * Math.sin(i / 10), 0.5 + 0.3 * Math.cos(i / 7));
  }
  return gaps.slice(1).sort((a, b) => a - b);
}"""


def measured() -> dict[str, float]:
    """First picture from a file, frames a second while dragging, and what a frame costs the page's own thread."""
    from playwright.sync_api import sync_playwright

    with TemporaryDirectory() as folder, sync_playwright() as tool:
        path = Path(folder) / "explorer.html"
        path.write_text(explorer_page(), encoding="utf-8")
        browser = tool.chromium.launch(
            executable_path=shutil.which("chromium"), args=["--no-sandbox", "--enable-unsafe-swiftshader"]
        )
        page = browser.new_page(viewport={"width": 1300, "height": 1000})
        page.goto(path.as_uri())
        page.wait_for_timeout(3000)
        (first, *_) = page.evaluate("performance.getEntriesByType('paint').map(paint => paint.startTime)")
        session = page.context.new_cdp_session(page)
        session.send("Performance.enable", {"timeDomain": "threadTicks"})
        before = _busy(session)
        gaps = page.evaluate(_DRAG, FRAMES)
        busy = (_busy(session) - before) / FRAMES
        browser.close()
    return {"first_ms": first, "median_fps": 1000 / gaps[len(gaps) // 2], "cpu_ms_per_frame": 1000 * busy}


def _busy(session: Any) -> float:
    """Seconds that the page's thread has worked."""
    metrics = {one["name"]: one["value"] for one in session.send("Performance.getMetrics")["metrics"]}
    return float(metrics["TaskDuration"])


if __name__ == "__main__":
    if shutil.which("chromium") is None:
        sys.exit("chromium is not installed")
    for name, value in measured().items():
        print(f"{name:18} {value:.1f}")
