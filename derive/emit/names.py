"""Names of a page in what is made of it: code and files of other languages, variables, formulas.

Every target has a table of names that are its own. Where one of a page's would be the same, it has
an underscore behind it.
"""

import re
from collections.abc import Callable, Collection, Iterable

import sympy as sp
from sympy.core.alphabets import greeks


def spelled(name: object) -> str:
    """A page's name in another language, with an underscore behind it so that it is none of the
    language's own names; an internal name without the underscore before it.
    """
    return str(name)[1:] if str(name).startswith("_") else f"{name}_"


def free(name: str, taken: Collection[str]) -> str:
    """A name, with underscores behind it until it is none of those taken, in any case of letters:
    files of some systems have one.
    """
    while name.casefold() in taken:
        name += "_"
    return name


def apart(names: Iterable[str], same: Callable[[str], str] = str) -> list[str]:
    """Names of which none is the same as another: those that come later have underscores behind
    them. Two are the same if ``same`` gives one text of both.
    """
    found = dict[str, str]()
    for name in names:
        while same(name) in found:
            name += "_"
        found[same(name)] = name
    return list(found.values())


def library(name: str, taken: Collection[str]) -> str:
    """The prefix of files and functions of an export: a page's name in ASCII letters and digits;
    ``taken`` is the table of the target.
    """
    tidy = re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_")
    return free(tidy if tidy[:1].isalpha() else f"page_{tidy}", taken)


def latex(name: str) -> str:
    """A name in LaTeX: Greek letters by their names, words upright, digits and what follows an
    underscore as an index.
    """
    found = re.fullmatch(r"(.+?)(\d*)((?:_.*)?)", name)
    if found is None:
        return sp.latex(sp.Symbol(name))
    letter, *below = (part for part in (found[1], found[2], *found[3].split("_")) if part)
    index = " ".join(map(_word, below))
    return _word(letter) + (f"_{{{index}}}" if index else "")


def _word(text: str) -> str:
    if len(text) == 1 or text.isdigit():
        return text
    is_greek = text in greeks or text in map(str.capitalize, greeks)
    return str(sp.latex(sp.Symbol(text))) if is_greek else rf"\mathrm{{{text}}}"
