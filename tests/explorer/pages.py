"""A page of the explorer in a browser: what a reader does on it, and what it says; the browser of
this machine; and the motion of a page in node.
"""

import json
import re
import shutil
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

import pytest

from spragsym.generated.quantities import PARAMETERS

CHROMIUM = shutil.which("chromium")
#: Drawing in 3D by software takes most of a test's time: one test has it.
WITHOUT_WEBGL = """
const get = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
  return kind === "webgl2" ? null : get.call(this, kind, ...more);
};
"""


def moved(
    page: str, point: Mapping[str, float], start: Sequence[float], step: float, count: int
) -> list[float]:
    """The state after steps of a page's motion, by the scripts of the page in node."""
    scripts = re.findall(r"<script([^>]*)>\n?(.*?)</script>", page, flags=re.DOTALL)
    (data,) = (text for kind, text in scripts if 'id="data"' in kind)
    bundle, module = (
        next(text for kind, text in scripts if kind == wanted and mark in text)
        for wanted, mark in (("", "var explorer"), (' type="module"', "export const algebra"))
    )
    program = (
        f"import vm from 'node:vm';\nvm.runInThisContext({json.dumps(bundle)});\n{module}\n"
        f"const about = {data}.model;\n"
        f"const at = explorer.balanceAt(algebra, about, {json.dumps(point)});\n"
        "const field = explorer.fieldOf(algebra, transition, about, at);\n"
        f"let state = {json.dumps([*start])};\n"
        f"for (let i = 0; i < {count}; i++) state = field.step(state, {step});\n"
        "console.log(JSON.stringify(state));\n"
    )
    command = ["node", "--input-type=module", "-"]
    done = subprocess.run(command, input=program, capture_output=True, text=True, check=True)
    return list(map(float, json.loads(done.stdout)))


@contextmanager
def chromium() -> Iterator[Any]:
    """Debian's Chromium, drawing in 3D by software as on a machine without a graphics card."""
    if CHROMIUM is None:
        pytest.skip("no chromium on this machine")
    playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    with playwright.sync_playwright() as tool:
        browser = tool.chromium.launch(
            executable_path=CHROMIUM, args=["--no-sandbox", "--enable-unsafe-swiftshader"]
        )
        yield browser
        browser.close()


def window(browser: Any, **options: Any) -> Any:
    """A window of a screen's size, without drawing in 3D."""
    context = browser.new_context(viewport={"width": 1300, "height": 1000}, **options)
    context.add_init_script(WITHOUT_WEBGL)
    return context


class Explorer:
    """One open page."""

    def __init__(self, page: Any, url: str) -> None:
        self.page, self.url, self.opened = page, url, 0
        self.errors: list[str] = []
        page.set_default_timeout(10_000)
        page.on(
            "console",
            lambda message: (
                message.type in ("error", "warning")
                and not message.text.startswith("[.WebGL")
                and self.errors.append(message.text)
            ),
        )
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.on(
            "request",
            lambda request: (
                request.url.startswith(("file:", "blob:", "data:"))
                or self.errors.append(request.url)
            ),
        )

    def open(self, hash: str = "") -> None:
        if self.page.url.startswith("about:"):
            self.page.goto(self.url)
        else:  # as a link that is followed on the page
            self.opened += 1
            self.page.evaluate("hash => { location.hash = hash; }", f"{hash}&opened={self.opened}")
        self.settle()

    def settle(self) -> None:
        """Wait for two pictures: what was dragged is taken up once for each."""
        self.page.evaluate(
            "new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"
        )

    def at(self, theta0: float, mu0: float) -> tuple[float, float]:
        """Where a point of the plane is on the screen."""
        box = self.page.locator("#plane .u-over").bounding_box()
        return box["x"] + box["width"] * theta0 / 180, box["y"] + box["height"] * (1 - mu0)

    def drag(self, *way: tuple[float, float]) -> None:
        """With the mouse, along corners."""
        self.page.locator("#plane").scroll_into_view_if_needed()
        self.page.mouse.move(*self.at(*way[0]))
        self.page.mouse.down()
        for corner in way[1:]:
            self.page.mouse.move(*self.at(*corner), steps=6)
            self.settle()
        self.page.mouse.up()
        self.settle()

    def theta(self) -> float:
        """Direction of the state that the mass is on, degrees, as the table says it."""
        text = self.page.locator("#states tr[aria-current] td").nth(3).inner_text()
        return float(text.replace("−", "-"))

    def point(self) -> dict[str, float]:
        names = ("theta0_deg", *PARAMETERS[1:])
        return {name: float(self.page.input_value(f"#{name}")) for name in names}

    def says(self) -> str:
        return str(self.page.inner_text("#story"))
