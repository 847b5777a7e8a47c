"""The frame of every page: template, bundled libraries and drawings, an exported module, and what the page starts from."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from importlib import resources
from typing import Any

from .._version import __version__
from .presets import Preset
from .units import Units

_ASSETS = resources.files("spragsym.explorer") / "assets"


def asset(name: str) -> str:
    """The text of a file of the bundle, or of a template."""
    return (_ASSETS / name).read_text(encoding="utf-8")


def filled(template: str, parts: Mapping[str, str]) -> str:
    """A template with its parts in the places of ``@NAME@``; what stands in a part is not looked at again."""
    return re.sub(r"@([A-Z]+)@", lambda found: parts[found[1]], template)


def page(title: str, source: str, body: str, bundle: str, module: str, start: str, data: Any, worker: str = "") -> str:
    """A whole page.

    Parameters
    ----------
    title, source : str
        Title, and where the model is from, as plain text.
    body : str
        The page's own HTML, without the footer.
    bundle, worker : str
        Names of the bundled scripts, the second one for pages that draw in a worker.
    module, start : str
        Text of the exported module, and the statement that starts the page behind it.
    data : object
        What the page's script finds in the element ``data``, in JSON.
    """
    code = f'<script type="text/plain" id="worker">{in_a_script(asset(worker))}</script>\n' if worker else ""
    return filled(
        asset("page.html"),
        {
            "TITLE": escaped(title),
            "STYLE": in_a_script(asset("style.css")),
            "BODY": body.strip(),
            "VERSION": escaped(__version__),
            "SOURCE": escaped(source),
            "LICENCES": escaped(asset("licences.txt")),
            "DATA": json.dumps(data, ensure_ascii=False).replace("<", "\\u003c"),
            "WORKER": code,
            "BUNDLE": in_a_script(asset(bundle)),
            "MODULE": in_a_script(module),
            "START": start,
        },
    )


def in_a_script(text: str) -> str:
    """Text that ends no element early: in JavaScript and JSON ``<\\/`` means the same as ``</``."""
    return re.sub(r"</(?=script|style)", r"<\\/", text, flags=re.IGNORECASE).replace("<!--", r"<\!--").strip()


def escaped(text: str) -> str:
    """Plain text as HTML."""
    return text.strip().replace("&", "&amp;").replace("<", "&lt;")


def points(presets: Sequence[Preset]) -> list[dict[str, Any]]:
    """Presets as the page takes them."""
    return [{"name": preset.name, "point": dict(preset.point)} for preset in presets]


def parameter_part(units: Units | None) -> str:
    """The part of a page with parameters, presets and the link, and a paragraph on the units of the reader's own, if any."""
    about = f'<p class="note" id="units">Beside the dimensionless numbers: {escaped(units.source)}</p>' if units else ""
    return filled(asset("parameters.html"), {"UNITS": about}).rstrip()


def onsets_part(drawing: str, command: str) -> str:
    """The part of a page with the map of stability as SVG, and the command that prints its numbers; nothing without a map."""
    if not drawing:
        return ""
    return f"""<section aria-labelledby="onsets_title">
<h2 id="onsets_title">Where oscillation sets in</h2>
<div class="drawing" style="background: white; max-width: 34rem">{drawing}</div>
<p class="note">The map of stability at the values that this page begins with, drawn when it was made: gently on full lines,
with a knock on dashed ones; which of the two is not known on dotted ones. Dots: this changes (GH);
squares: curves end on folds (BT, ZH) or cross (HH). Its numbers:</p>
<pre class="scroll" tabindex="0" aria-label="Command that computes the onsets">{escaped(command)}</pre>
</section>"""


def motion_part(lines: str, assumed: str) -> str:
    """The part of a page on the motion in time, with words on its lines and on what is assumed."""
    return filled(asset("motion.html"), {"LINES": lines, "ASSUMED": assumed})
