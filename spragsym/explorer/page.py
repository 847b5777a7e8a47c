"""The explorer of a model as one HTML file: the template filled in with the bundled libraries, the
drawing, the exported module, and the model's data as JSON.
"""

from __future__ import annotations

import html
import json
import math
import re
import shlex
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from importlib import resources
from typing import Any
from urllib.parse import quote

from .._version import __version__
from ..command_line import options_of
from ..core.errors import MissingExtraError
from ..core.questions import model_of
from ..derive.kang_nam.library import exported
from ..models.load import USUAL, WITH_DAMPERS, load, mechanism, page_of
from ..models.model import Model, Touching, label_of, title_drawing_words
from ..models.parameters import ParameterSet

_ASSETS = resources.files("spragsym.explorer") / "assets"
_GENERATED = resources.files("spragsym.generated")


@dataclass(frozen=True)
class ExplorerPage:
    """A page that computes in the browser; a notebook shows it."""

    text: str = field(repr=False)

    def _repr_html_(self) -> str:
        return (
            f'<iframe srcdoc="{html.escape(self.text)}" '
            'style="width:100%;height:48em;border:0"></iframe>'
        )


def explore(p: ParameterSet | None = None) -> ExplorerPage:
    """The explorer in a notebook, beginning at ``p``: the mechanism, its states and its motion.
    ``spragsym explore`` writes the same page to a file.

    Parameters
    ----------
    p : Parameters, optional
        One point, by default the article's; of another model the extra ``derive`` is needed.

    Returns
    -------
    ExplorerPage
        A notebook shows it; ``text`` is the HTML file.

    Raises
    ------
    ParameterError, ParameterTypeError
        If a parameter is missing or an array.

    Examples
    --------
    >>> import spragsym as ss
    >>> page = ss.explore(ss.Parameters.article(theta0=0.8, V=0.5, d=10.0))
    >>> "<!DOCTYPE html>" in page.text
    True
    """
    if p is None:
        return ExplorerPage(explorer_page())
    return ExplorerPage(explorer_page(model_of(p), [("yours", p)]))


def explorer_page(
    model: Model | None = None,
    presets: Sequence[tuple[str, ParameterSet]] = (),
    *,
    units: Mapping[str, Any] | None = None,
    source: str = "",
    onsets: tuple[str, str] = ("", ""),
) -> str:
    """The explorer as one HTML page that needs no network: mechanism, plane, states, and the motion
    in time.

    The page says whether its states are proved, by the solver that a model of closed forms has in
    JavaScript, or searched.

    Parameters
    ----------
    model : Model, optional
        As :func:`spragsym.load` gives it; the article's by default.
    presets : sequence of (str, Parameters)
        Points of the user's own, each with its title in the page's list. The page begins at the
        first; the model's cases follow.
    units : mapping of str to tuple, optional
        Units of the user's own, in which all numbers are typed and shown. ``length``, ``time`` and
        ``force`` are each the value of the model's 1 and the unit; ``parameters`` maps a
        parameter's name to the name of the quantity that is shown for it, the value of the
        parameter's 1, and the unit.
    source : str
        Where the units are from; the page shows this sentence.
    onsets : pair of str
        The map of stability as SVG, and the command that prints its numbers; empty without a map.

    Returns
    -------
    str
        The HTML file, the same for the same arguments.

    Raises
    ------
    MissingExtraError
        Without the extra ``derive``, for a model whose functions the package does not hold in
        JavaScript.

    Examples
    --------
    >>> page = explorer_page()
    >>> page.startswith("<!DOCTYPE html>"), len(page.encode()) < 2_000_000
    (True, True)
    """
    model = model or load(USUAL)
    model.require_answered("explore")
    module, scene = _derived(model)
    names, shown = model.parameters, [*presets, *model.cases()]
    points = [dict(zip(names, p.scalars(*names), strict=True)) for _, p in shown]
    data = {
        "model": described(model, points) | {"scene": scene},
        "presets": [
            {"name": name, "point": point} for (name, _), point in zip(shown, points, strict=True)
        ],
        "units": units,
    }
    beside = f'<p class="note" id="units">{_escaped(source)}</p>' if units else ""
    lines = map(
        " ".join, zip(model.coordinates, ("solid", "dashed", "dotted", "dash-dotted"), strict=False)
    )
    return _filled(
        "page.html",
        {
            "TITLE": _escaped(f"{model.name} explorer"),
            "STYLE": _in_a_script(_asset("style.css")),
            "DRAWING": mechanism(model),
            "WORDS": _words(title_drawing_words(model.about)[2]),
            "UNITS": beside,
            "LINES": _escaped(", ".join(lines)),
            "ONSETS": _filled(
                "onsets.html", {"DRAWING": quote(onsets[0]), "COMMAND": _escaped(onsets[1])}
            )
            if onsets[0]
            else "",
            "VERSION": _escaped(__version__),
            "SOURCE": _escaped(f"Model: {model.about['summary']}"),
            "LICENCES": _escaped(_asset("licences.txt")),
            "DATA": json.dumps(data, ensure_ascii=False).replace("<", "\\u003c"),
            "TRANSITION": _in_a_script((_GENERATED / "transition.mjs").read_text(encoding="utf-8")),
            "MODULE": _in_a_script(module),
            **_solver(model),
        },
    )


def _solver(model: Model) -> dict[str, str]:
    """The parts of a page that differ with how states are found: by search, or by the exported
    solver of closed forms.
    """
    # Dampers move no state: the solver is that of the model without them.
    without = {damped: plain for plain, damped in WITH_DAMPERS.items()}
    folder = _ASSETS / without.get(model.name, model.name)
    bundle = _in_a_script(_asset("explorer.js"))
    words = {"TITLE": _escaped(model.name), "SUMMARY": _escaped(model.about["summary"])}
    parts = {
        "HEAD": _filled("head.html", words),
        "SURFACE": "",
        "LEGEND": "",
        "BUNDLES": bundle,
        "WORKER": "",
        "SOLVER": "",
    }
    if model.search is model or not folder.is_dir():
        return parts
    own = {path.name: path.read_text(encoding="utf-8") for path in folder.iterdir()}
    worker = _in_a_script(own["worker.js"])
    solver = f"{_in_a_script(exported('javascript')['spragsym.mjs'])}\n{own['start.js']}"
    return {name: own.get(f"{name.lower()}.html", part) for name, part in parts.items()} | {
        "BUNDLES": f"{bundle}\n{_in_a_script(own['closed_forms.js'])}",
        "WORKER": f'<script type="text/plain" id="worker">{worker}</script>',
        "SOLVER": f'<script type="module" id="code">\n{solver}</script>',
    }


def _asset(name: str) -> str:
    return (_ASSETS / name).read_text(encoding="utf-8")


def _filled(template: str, parts: Mapping[str, str]) -> str:
    """A template with every ``@NAME@`` replaced by its part; a part may contain such marks
    itself.
    """
    return re.sub(r"@([A-Z]+)@", lambda found: parts[found[1]].strip(), _asset(template))


def _in_a_script(text: str) -> str:
    """Text that ends no element early: in JavaScript and JSON ``<\\/`` means the same as ``</``."""
    return (
        re.sub(r"</(?=script|style)", r"<\\/", text, flags=re.IGNORECASE)
        .replace("<!--", r"<\!--")
        .strip()
    )


def _escaped(text: str) -> str:
    """Plain text as HTML."""
    return html.escape(text.strip(), quote=False)


def _words(blocks: Sequence[str]) -> str:
    """Paragraphs of a page's docstring as HTML, indented ones preformatted."""
    texts = ((_escaped(block), block.startswith(" ")) for block in blocks)
    return "\n".join(
        f"<pre>{text}</pre>" if formula else f"<p>{text}</p>" for text, formula in texts
    )


def _derived(model: Model) -> tuple[str, dict[str, object] | None]:
    """The model's functions in JavaScript, as the package holds them or derived now (extra
    ``derive``), and of a mechanism that is not one mass on a belt its scene.
    """
    folder = _GENERATED / "models" / model.name
    module = folder / f"{model.name}.mjs"
    if model.where == model.name and module.is_file():
        return module.read_text(encoding="utf-8"), None
    try:
        from ..derive import export, pages
        from ..derive.scene import Scene
    except ModuleNotFoundError as error:
        raise MissingExtraError(
            f"the explorer of {model.name}", error.name or "sympy", "derive"
        ) from error
    read = pages.read(page_of(model, pages.SHIPPED), model.name)
    text = export.for_the_browser(
        read, f"Generated by ``spragsym explore`` from {model.name}.py. Do not edit."
    )
    return text, None if model.about["drawn"] else Scene(read.mechanics).as_json()


def described(model: Model, points: Sequence[Mapping[str, float]]) -> dict[str, Any]:
    """The model as the page's scripts read it: coordinates, parameters with sliders that reach the
    given points, contacts, frictions, regimes, and the arguments of its functions.
    """
    about, turns = model.about, model.whole_turns
    contacts = [entry["name"] for entry in model.contacts]
    return {
        "name": model.name,
        "quoted": shlex.quote(model.where),
        "coordinates": [
            {
                "name": coordinate["name"],
                "turns": turns.get(index, {}),
                "angle": coordinate["unit"] == "rad",
            }
            for index, coordinate in enumerate(about["coordinates"])
        ],
        "parameters": [
            {key: entry[key] for key in ("name", "meaning", "role")}
            | {
                "angle": entry["unit"] == "rad",
                "flag": options_of(about, entry["name"])[0],
                "range": {
                    key: entry[key]
                    for key in ("low", "high", "low_open", "high_open")
                    if entry[key] is not None
                },
                **_slider(entry, [point[entry["name"]] for point in points]),
            }
            for entry in about["parameters"]
        ],
        "axes": list(model.plane),
        **{key: about[key] for key in ("angles", "arguments", "layers", "ties", "drawn")},
        "contacts": [
            {key: entry[key] for key in ("name", "border", "polynomial")}
            for entry in model.contacts
        ],
        "frictions": [
            {key: entry[key] for key in ("belt", "holds")}
            | {"contact": contacts.index(entry["name"])}
            for entry in model.frictions
        ],
        "regimes": [
            {"contact": contact, "says": says, "touching": _touching(model, contact)}
            for contact, says in model.regimes.items()
        ],
        "torsions": len(about["torsions"]),
    }


def _touching(model: Model, contact: Touching) -> list[int]:
    """Of every contact 1 if it touches in a regime, else 0; one that can't open always touches."""
    return [
        int(contact is True or not entry["border"] or label_of(entry) in (contact or ()))
        for entry in model.contacts
    ]


def _slider(entry: Mapping[str, Any], values: Sequence[float]) -> dict[str, float]:
    """Ends of a slider, angles in degrees: those of the allowed range, and where that is infinite
    twice the base value, or 3 without one, or 1.2 times the largest of some values.
    """
    low, high, base = entry["low"], entry["high"], entry["base"]
    reach = max([2.0 * abs(base) if base else 3.0, *(1.2 * abs(value) for value in values)])
    first = -reach if low is None else low
    last = reach if high is None else high
    # The slider keeps away from ends that are not allowed.
    room = 0.003 * (last - first)
    first = first + room * bool(entry["low_open"])
    last = last - room * (high is not None and bool(entry["high_open"]))
    shown = math.degrees if entry["unit"] == "rad" else float
    return {"low": shown(first), "high": shown(last)}
