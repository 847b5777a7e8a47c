"""The explorer in a notebook's cell."""

from __future__ import annotations

import html
from dataclasses import dataclass, field

from ..models.parameters import ParameterSet
from .page import explorer_page
from .presets import Preset


@dataclass(frozen=True)
class Page:
    """A page that computes in the browser; a notebook shows it."""

    text: str = field(repr=False)

    def _repr_html_(self) -> str:
        return f'<iframe srcdoc="{html.escape(self.text)}" style="width:100%;height:48em;border:0"></iframe>'


def explore(p: ParameterSet) -> Page:
    """The explorer, beginning at ``p``: the mechanism, its states and its motion; as a file, ``spragsym explore``.

    Parameters
    ----------
    p : Parameters
        One point; of another model than the article's the extra ``derive`` is needed.

    Returns
    -------
    Page
        A notebook shows it.

    Raises
    ------
    ParameterError
        If a parameter is missing or an array.

    Examples
    --------
    >>> import spragsym as ss
    >>> page = ss.explore(ss.Parameters.article(theta0=0.8, V=0.5, d=10.0))
    >>> "<!DOCTYPE html>" in page.text
    True
    """
    return Page(explorer_page(p.model, [Preset.of("yours", p)]))
