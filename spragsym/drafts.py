"""Drafts of files of statements, from the source of a paper."""

from __future__ import annotations

import importlib.util
import os
from dataclasses import dataclass
from pathlib import Path

from .core.errors import MissingExtraError, ParameterError, require_kind
from .core.shown import visible
from .files.text import BY_HAND, json_of, text_of

#: The kinds of sources by the ends of their names, with the modules that read their structure.
_KINDS = {
    ".do.txt": ("do.txt", ("pylatexenc",)),
    ".tex": ("tex", ("pylatexenc",)),
    ".md": ("md", ("markdown_it", "mdit_py_plugins", "pylatexenc")),
    ".markdown": ("md", ("markdown_it", "mdit_py_plugins", "pylatexenc")),
    ".ipynb": ("ipynb", ("nbformat", "markdown_it", "mdit_py_plugins", "pylatexenc")),
}


@dataclass(frozen=True)
class PaperDraft:
    """The draft of a file of statements.

    Attributes
    ----------
    text : str
        The file, in TOML.
    equations, unread, judged : int
        Numbers of displayed equations, of those that can't be read without a page, and of those
        with a guess of what they are about.
    """

    text: str
    equations: int
    unread: int
    judged: int


def draft(source: str | os.PathLike[str]) -> PaperDraft:
    r"""Draft a file of statements from the source of a paper.

    Every displayed equation becomes a statement, with its label, its line and a guess of what it is
    about; the text is searched for what it says of each name.

    Parameters
    ----------
    source : str or path
        A file in TeX (.tex), Markdown (.md), doconce (.do.txt), or a notebook (.ipynb).

    Returns
    -------
    PaperDraft
        The text of the file, and what was read.

    Raises
    ------
    ParameterError
        If the source can't be read, or is of another kind.
    MissingExtraError
        If SymPy or a library that reads the structure of the source is not installed.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> from spragsym.drafts import draft
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = pathlib.Path(folder) / "notes.tex"
    ...     _ = file.write_text(r"\[ T = \frac12 m \dot x^2 \]")
    ...     found = draft(file)
    >>> print(found.equations, found.unread, 'about = "energy T"' in found.text)
    1 0 True
    """
    require_kind("source", source, (str, os.PathLike), "the path of a file")
    path = Path(source)
    end = next((it for it in _KINDS if path.name.lower().endswith(it)), None)
    if end is None:
        raise ParameterError(
            f"source = {path.name!r} is none of {', '.join(_KINDS)}; give the source of a paper, "
            "or write its statements by hand"
        )
    kind, modules = _KINDS[end]
    if importlib.util.find_spec("sympy") is None:
        raise MissingExtraError("a draft", "SymPy", "papers")
    for module in modules:
        if importlib.util.find_spec(module) is None:
            raise MissingExtraError(f"a draft from {end}", module, "papers")
    # Notebooks hold pictures.
    largest = BY_HAND << (6 if kind == "ipynb" else 3)
    text = text_of(path, largest, "the source of a paper", may_hold=None)
    from .derive.statements import documents, drafts

    try:
        found = drafts.drafted(documents.read(kind, text, json_of))
    except ValueError as error:
        raise ParameterError(f"{path.name} can't be read: {error}; give another file") from error
    written = "\n".join(map(visible, drafts.as_toml(found, path.name).split("\n")))
    return PaperDraft(written, len(found.rows), found.unread, found.judged)
