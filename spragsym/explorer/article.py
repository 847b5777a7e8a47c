"""The page of the article's model, which solves with the exported solver."""

from __future__ import annotations

from collections.abc import Sequence
from importlib import resources

from ..assumed import D, V
from .page import asset, filled, motion_part, onsets_part, page, parameter_part, points
from .presets import Preset, article_presets
from .units import Units

_START = """explorer.start({
  BASE, NAMES, RANGES, algebra, equilibria, surface, cusps, bifurcation_set, critical_friction, flutter_boundary, folds, motion,
});"""
_SOURCE = "Model: J. Kang and J. Nam, Applied Sciences 10 (2020) 2748."


def explorer_page(
    presets: Sequence[Preset] = (), *, V: float = V, d: float = D, units: Units | None = None, onsets: tuple[str, str] = ("", "")
) -> str:
    """The explorer as one HTML page that needs no network.

    Parameters
    ----------
    presets : sequence of Preset
        Points of the user's own. The page begins at the first of them; the article's follow.
    V, d : float
        Belt speed and steepness of the friction law that the motion begins with.
    units : Units, optional
        Units of the user's own, in which states, forces and motion are shown.
    onsets : pair of str
        The map of stability as SVG, and the command that prints its numbers.

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
    module = resources.files("spragsym.generated") / "javascript" / "spragsym.mjs"
    assumed = (
        "V and d are assumptions; the article states neither."
        if units is None
        else "The numbers that a motion starts from are in units of the model."
    )
    parts = {
        "MOTION": motion_part("Solid: x; dashed: y.", assumed),
        "ONSETS": onsets_part(*onsets),
        "PARAMETERS": parameter_part(units),
        "SCALES": "Lengths in units of L₀, forces in k_c L₀."
        if units is None
        else "Error bounds are those of the model's own numbers.",
    }
    return page(
        "Sprag-slip explorer",
        _SOURCE,
        filled(asset("article.html"), parts),
        "explorer.js",
        module.read_text(encoding="utf-8"),
        _START,
        {"drive": {"V": V, "d": d}, "presets": points((*presets, *article_presets())), "units": units and units.data()},
        worker="worker.js",
    )
