"""The page's text: template, bundled libraries and drawings, the exported module, and what it starts from."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from importlib import resources

from .._version import __version__
from ..assumed import D, V
from ..parameters import NAMES
from .presets import Preset, article_presets

#: What the template has in place of each part, and the file that the part is in.
_FILES = {"STYLE": "style.css", "EXPLORER": "explorer.js", "WORKER": "worker.js"}


def explorer_page(presets: Sequence[Preset] = (), *, V: float = V, d: float = D) -> str:
    """The explorer as one HTML page that needs no network.

    Parameters
    ----------
    presets : sequence of Preset
        Points of the user's own. The page begins at the first of them; the article's follow.
    V, d : float
        Belt speed and steepness of the friction law that the motion begins with.

    Returns
    -------
    str
        The page. Same arguments, same text.

    Examples
    --------
    >>> page = explorer_page()
    >>> page.startswith("<!DOCTYPE html>"), len(page.encode()) < 2_000_000
    (True, True)
    """
    assets = resources.files("spragsym.explorer") / "assets"
    module = resources.files("spragsym.generated") / "javascript" / "spragsym.mjs"
    parts = {key: _in_a_script((assets / name).read_text(encoding="utf-8")) for key, name in _FILES.items()}
    parts["MODULE"] = _in_a_script(module.read_text(encoding="utf-8"))
    parts["DATA"] = _data((*presets, *article_presets()), V, d)
    parts["LICENCES"] = _escaped((assets / "licences.txt").read_text(encoding="utf-8"))
    parts["VERSION"] = _escaped(__version__)
    template = (assets / "page.html").read_text(encoding="utf-8")
    return re.sub(r"@([A-Z]+)@", lambda found: parts[found[1]], template)


def _in_a_script(text: str) -> str:
    """Text that ends no element early: in JavaScript and JSON ``<\\/`` means the same as ``</``."""
    return re.sub(r"</(?=script|style)", r"<\\/", text, flags=re.IGNORECASE).replace("<!--", r"<\!--").strip()


def _escaped(text: str) -> str:
    return text.strip().replace("&", "&amp;").replace("<", "&lt;")


def _data(presets: Sequence[Preset], V: float, d: float) -> str:
    points = [{"name": preset.name, "point": {name: preset.point[name] for name in NAMES}} for preset in presets]
    text = json.dumps({"drive": {"V": V, "d": d}, "presets": points}, ensure_ascii=False)
    return text.replace("<", "\\u003c")
