"""Displayed equations of a document, with their labels and lines, and its prose.

The structure of a document is read by libraries: pylatexenc for TeX, markdown-it-py for Markdown,
nbformat for notebooks. What an equation says is read elsewhere (:mod:`.latex`).
"""

from __future__ import annotations

import bisect
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any


@dataclass(frozen=True)
class Display:
    """A displayed equation: its LaTeX, without label and number, and where it stands."""

    latex: str
    line: int
    label: str = ""
    cell: int = 0  #: number of a notebook's cell, which begins at line 1


@dataclass(frozen=True)
class Document:
    """A document: its title, its displayed equations in order, and its prose without these."""

    title: str
    displays: tuple[Display, ...]
    prose: str


#: Environments whose lines are equations of their own, without a star.
_LINES = ("align", "alignat", "flalign", "gather", "eqnarray")
_ONE = ("equation", "displaymath", "multline", "math", "IEEEeqnarray", "dmath")
#: Environments inside an equation whose lines are equations of their own.
_INNER = ("aligned", "gathered", "split", "alignedat")
#: What is printed beside an equation, and is none of it.
_BESIDE = re.compile(
    r"\\(?:label|tag\*?|eqno|vspace\*?|hspace\*?|intertext|ref|eqref|cite)\s*\{[^{}]*\}"
    r"|\\(?:nonumber|notag|displaystyle|centering|allowdisplaybreaks|limits|boldmath)\b"
)
_COMMENT = re.compile(r"(?<!\\)%.*")
#: Deepest groups of a source, which the library reads by recursion.
_DEEPEST = 100


class DocumentError(ValueError):
    """A document that can't be read; the text says why."""


def read(kind: str, text: str, data_of: Callable[[str], Any]) -> Document:
    """The document in a text of a kind: "tex", "md", "ipynb" or "do.txt".

    ``data_of`` reads JSON.

    Raises
    ------
    DocumentError
        If it has no such structure.
    """
    try:
        match kind:
            case "ipynb":
                data_of(text)  # of few levels
                return _notebook(text)
            case "md":
                return _markdown(text)
            case "do.txt":
                return _tex(_between_marks(text), text)
        return _tex(text, text)
    except RecursionError as error:
        raise DocumentError(f"it has more than {_DEEPEST} levels of groups") from error


# ------------------------------------------------------------------------------------------------
# TeX


def _tex(text: str, prose: str) -> Document:
    """The document in a source of TeX; its own macros are written out in its equations."""
    macros, text = _macros(_COMMENT.sub("", text))
    for name, (_, body) in macros.items():
        if not re.search(r"\\(?:begin|end)\b", body):
            continue
        text = re.sub(rf"{re.escape(name)}(?![A-Za-z])", lambda _, it=body: it, text)
    title = re.search(r"\\title(?:\[[^\]]*\])?\s*\{([^{}]*)\}|^TITLE:\s*(.*)", prose, re.M)
    found, spans = [*_displays(text)], list[tuple[int, int]]()
    lines = [it.start() for it in re.finditer("\n", text)]
    displays = []
    for start, stop, display in found:
        spans.append((start, stop))
        latex = _tidied(_written_out(display.latex, macros))
        if latex:
            line = display.line + bisect.bisect_left(lines, start) + 1
            displays.append(replace(display, latex=latex, line=line))
    ends, begins = [stop for _, stop in spans], [start for start, _ in spans]
    gaps = zip([0, *ends], [*begins, len(text)], strict=True)
    left = "".join(text[one:other] for one, other in gaps if one <= other)
    head = " ".join((title[1] or title[2]).split()) if title else ""
    return Document(head, tuple(displays), _COMMENT.sub("", left))


def _displays(text: str) -> Iterator[tuple[int, int, Display]]:
    """The displayed equations in a source of TeX, with the range of characters of each; its line
    is that in the range, from 0.
    """
    from pylatexenc.latexwalker import LatexMathNode, LatexWalker

    _check_depth(text)

    def walk(nodes: Sequence[Any]) -> Iterator[tuple[int, int, Display]]:
        for node in nodes:
            name = getattr(node, "environmentname", "").rstrip("*")
            is_display = isinstance(node, LatexMathNode) and node.displaytype == "display"
            if is_display or name in (*_LINES, *_ONE):
                yield from inside(node, name)
            elif name in ("comment", "verbatim", "lstlisting", "minted", "tikzpicture"):
                continue
            else:
                yield from walk([it for it in getattr(node, "nodelist", None) or () if it])
                held = getattr(getattr(node, "nodeargd", None), "argnlist", None) or ()
                yield from walk([it for it in held if it])

    def inside(node: Any, name: str) -> Iterator[tuple[int, int, Display]]:
        whole = text[node.pos : node.pos + node.len]
        parts = [it for it in node.nodelist if it]
        label = _label(whole)
        plain = [it for it in parts if text[it.pos : it.pos + it.len].strip()]
        inner = [it for it in plain if not _BESIDE.fullmatch(text[it.pos : it.pos + it.len])]
        while len(inner) == 1 and getattr(inner[0], "environmentname", "").rstrip("*") in (
            *_INNER,
            *_LINES,
        ):
            name, parts = "align", [it for it in inner[0].nodelist if it]
            inner = parts if len(parts) == 1 else []
        rows = _rows(text, parts) if name in _LINES else [_range(parts)]
        begin = node.pos
        for number, (start, stop) in enumerate(rows):
            row, last = text[start:stop], number == len(rows) - 1
            lead = re.match(rf"(?:\s|{_BESIDE.pattern}|{_COMMENT.pattern})*", row)
            line = text.count("\n", begin, start + (lead.end() if lead else 0))
            own = _label(row) or (label if len(rows) == 1 else "")
            if label and len(rows) > 1 and not any(_label(text[a:b]) for a, b in rows):
                own = f"{label}-{number + 1}"
            yield begin, (node.pos + node.len if last else begin), Display(row, line, own)

    yield from walk(LatexWalker(text, tolerant_parsing=True).get_latex_nodes()[0])


def _check_depth(text: str) -> None:
    """Refuse a source with more levels of groups than any document has."""
    depth = 0
    for found in re.finditer(r"\\.|[{}]|\\begin\b|\\end\b", text):
        depth += {"{": 1, "}": -1}.get(found[0], 0)
        if depth > _DEEPEST:
            raise DocumentError(f"it has more than {_DEEPEST} levels of groups")


def _range(nodes: Sequence[Any]) -> tuple[int, int]:
    """The range of characters of nodes."""
    return (nodes[0].pos, nodes[-1].pos + nodes[-1].len) if nodes else (0, 0)


def _rows(text: str, nodes: Sequence[Any]) -> list[tuple[int, int]]:
    """Ranges of the lines of an environment; one that begins with an operator belongs to the line
    above it, as does one behind an operator.
    """
    groups: list[list[Any]] = [[]]
    for node in nodes:
        if getattr(node, "macroname", "") == "\\":
            groups.append([])
        else:
            groups[-1].append(node)
    rows: list[tuple[int, int]] = []
    for start, stop in (_range(it) for it in groups if it):
        row = _tidied(text[start:stop]).replace("&", "").strip()
        above = _tidied(text[slice(*rows[-1])]).rstrip("& ") if rows else ""
        goes_on = re.match(r"(?:\\quad|\\qquad|\\,|\s|\{\})*(?:[=+*/-]|\\(?:cdot|times|pm)\b)", row)
        if rows and (not row or goes_on or above.endswith(("=", "+", "-"))):
            rows[-1] = rows[-1][0], stop
        elif row:
            rows.append((start, stop))
    return rows


def _label(text: str) -> str:
    """The label of an equation, or its tag."""
    found = re.findall(r"\\(label|tag)\*?\s*\{([^{}]*)\}", text)
    return " ".join(min(found)[1].split()) if found else ""


def _tidied(latex: str) -> str:
    """An equation without comments, labels and the mark at its end."""
    plain = _BESIDE.sub(" ", _COMMENT.sub("", latex))
    plain = re.sub(r"\\(?:text|mbox|textrm)\s*\{\s*[.,;]?\s*\}", "", plain)
    plain = re.sub(r"(?:,|\\quad|\\qquad|\s)*\\forall(?![A-Za-z]).*$", "", plain, flags=re.S)
    if (held := re.match(r"\s*\\boxed\s*(?=\{)", plain)) and (group := _group(plain, held.end())):
        plain = group if plain.rstrip().endswith("}") and len(plain) - len(group) < 20 else plain
    plain = "\n".join(line.strip() for line in plain.splitlines() if line.strip())
    while (shorter := re.sub(r"(?:[.,;\s&~]|\\\\|\\[,;:!> ]|\\q?quad)+$", "", plain)) != plain:
        plain = shorter
    return plain


def _macros(text: str) -> tuple[dict[str, tuple[int, str]], str]:
    r"""The macros that a source defines by ``\newcommand`` and ``\def``, as the number of their
    arguments and what they stand for, and the source without these definitions.
    """
    found: dict[str, tuple[int, str]] = {}
    begin = re.compile(
        r"\\(?:(?:re)?newcommand|providecommand)\*?\s*\{?\s*(\\[A-Za-z]+)\s*\}?"
        r"\s*(?:\[(\d)\])?\s*(?=\{)"
        r"|\\g?def\s*(\\[A-Za-z]+)\s*((?:#\d)*)\s*(?=\{)"
        r"|\\DeclareMathOperator\*?\s*\{?(\\[A-Za-z]+)\}?\s*(?=\{)"
    )
    left, place = list[str](), 0
    for it in begin.finditer(text):
        body = _group(text, it.end()) if it.start() >= place else None
        if body is not None and len(body) <= 300:
            count = int(it[2]) if it[2] else len(it[4] or "") // 2
            name = it[1] or it[3] or it[5]
            found[name] = count, rf"\operatorname{{{body}}}" if it[5] else body
            stop = it.end() + len(body) + 2
            left += [text[place : it.start()], "\n" * text.count("\n", it.start(), stop)]
            place = stop
    return found, "".join([*left, text[place:]])


def _group(text: str, start: int) -> str | None:
    """What stands in the braces that begin at a place."""
    depth = 0
    for found in re.compile(r"\\.|[{}]", re.S).finditer(text, start):
        depth += {"{": 1, "}": -1}.get(found[0], 0)
        if depth == 0:
            return text[start + 1 : found.start()]
    return None


def _written_out(latex: str, macros: dict[str, tuple[int, str]]) -> str:
    """An equation with the macros of its source written out, those in macros too."""
    longest, deepest = 20_000, 8
    for _ in range(deepest):
        place, parts = 0, list[str]()
        for found in re.finditer(r"\\[A-Za-z]+", latex):
            is_long = sum(map(len, parts)) > longest
            if found.start() < place or found[0] not in macros or is_long:
                continue
            count, body = macros[found[0]]
            stop, given = found.end(), list[str]()
            for _ in range(count):
                stop += len(latex[stop:]) - len(latex[stop:].lstrip())
                held = _group(latex, stop) if latex[stop : stop + 1] == "{" else None
                given.append(latex[stop : stop + 1] if held is None else held)
                stop += 1 if held is None else len(held) + 2
            for number, one in enumerate(given, 1):
                body = body.replace(f"#{number}", one)
            parts += [latex[place : found.start()], body if count else f"{{{body}}}"]
            place = stop
        if not parts or len(latex) > longest:
            return latex
        latex = "".join([*parts, latex[place:]])
    return latex


# ------------------------------------------------------------------------------------------------
# other kinds


def _between_marks(text: str) -> str:
    """A source of doconce in which all but what stands between !bt and !et is blank."""
    is_inside, lines = False, list[str]()
    for line in text.split("\n"):
        is_mark = line.strip() in ("!bt", "!et")
        is_inside = line.strip() == "!bt" if is_mark else is_inside
        lines.append(line if is_inside and not is_mark else "")
    return "\n".join(lines)


@cache
def _parser() -> Any:
    """The parser of Markdown, with mathematics between dollars and in environments."""
    from markdown_it import MarkdownIt
    from mdit_py_plugins.amsmath import amsmath_plugin
    from mdit_py_plugins.dollarmath import dollarmath_plugin

    parser = MarkdownIt("commonmark").enable("table")
    return parser.use(dollarmath_plugin, double_inline=True).use(amsmath_plugin)


def _markdown(text: str) -> Document:
    r"""The document in a text of Markdown: display mathematics stands between two dollars, between
    \[ and \], in an environment, or in a block that is called math.
    """
    # Markdown itself reads \[ as a bracket.
    text = re.sub(r"^[ \t]*\\{1,2}\[(.*)\\{1,2}\][ \t]*$", r"$$\1$$", text, flags=re.M)
    text = re.sub(r"^[ \t]*\\{1,2}[\[\]][ \t]*$", "$$", text, flags=re.M)
    displays, title = list[Display](), ""
    lines, origin = _set_apart(text.split("\n"))
    text = "\n".join(lines)
    defined = "".join(re.findall(r"\\(?:g?def|newcommand).*?\}(?=\s*\$|\s*$)", text, re.M))

    def add(latex: str, line: int, label: str = "") -> None:
        """Add the equations of one display."""
        is_whole = re.match(rf"\s*\\begin\{{({'|'.join((*_LINES, *_ONE))})\*?\}}", latex)
        source = defined + (latex if is_whole else f"\\[{latex}\\]")
        source = source.replace(r"\_", "_")  # which is escaped in Markdown
        for one in _tex(source, "").displays:
            place = min(line + one.line - 1, len(origin))
            displays.append(replace(one, line=origin[place - 1], label=one.label or label))

    tokens = _parser().parse(text)
    prose: list[str] = []
    for number, it in enumerate(tokens):
        line = (it.map or [0])[0] + 1
        if it.type == "heading_open" and not title:
            title = " ".join(tokens[number + 1].content.split())
        if it.type in ("math_block", "math_block_label", "amsmath"):
            add(it.content, line, it.info if it.type == "math_block_label" else "")
        elif it.type == "fence" and re.match(r"\{?math\}?\b", it.info.strip()):
            add(re.sub(r"^:\w+:.*$", "", it.content, flags=re.M), line + 1)
        elif it.type == "inline":
            prose.append("".join(_shown(one) for one in it.children))
            for one, after in zip(it.children, [*it.children[1:], None], strict=False):
                is_environment = one.type == "math_inline" and r"\begin{" in one.content
                if one.type == "math_inline_double" or is_environment:
                    content = one.content.strip()
                    begin = content.split("\n")[0]
                    near = (at for at in range(line - 1, len(lines)) if begin in lines[at])
                    named = re.match(r"\s*\(([\w:.-]+)\)", after.content if after else "")
                    add(content, next(near, line - 1) + 1, named[1] if named else "")
    return Document(title, tuple(displays), "\n".join(prose))


def _set_apart(lines: Sequence[str]) -> tuple[list[str], list[int]]:
    """The lines of a text with empty ones around display mathematics, which may stand inside of a
    paragraph, and the number that each had.
    """
    found, origin, is_inside, fence = list[str](), list[int](), False, ""
    for number, line in enumerate(lines, 1):
        bare, before = line.strip(), found[-1:] == [""]
        mark = bare[:3] if bare[:3] in ("```", "~~~") else ""
        if mark and fence in ("", mark):
            fence = "" if fence else mark
        is_mark = bare == "$$" and not fence
        if is_mark and not is_inside and not before:
            found.append("")
            origin.append(number)
        found.append(line)
        origin.append(number)
        if is_mark and is_inside:
            found.append("")
            origin.append(number)
        is_inside ^= is_mark
    return found, origin


def _shown(token: Any) -> str:
    """The text of a part of a paragraph, with mathematics in dollars."""
    if token.type == "math_inline":
        return f"${token.content}$"
    return " " if token.type in ("softbreak", "hardbreak", "math_inline_double") else token.content


def _notebook(text: str) -> Document:
    """The document in the text of a notebook: its cells of Markdown."""
    import nbformat

    made: Any = nbformat  # without types
    try:
        book = made.convert(made.reader.reads(text), 4)
        texts = [(it.cell_type, str(it.source)) for it in book.cells]
    except Exception as error:  # of any kind, for data of another structure
        raise DocumentError(f"it is no notebook: {error!r:.80}") from error
    displays, prose, title = list[Display](), list[str](), ""
    for number, (kind, cell) in enumerate(texts, 1):
        if kind == "markdown":
            found = _markdown(cell)
            displays += [replace(it, cell=number) for it in found.displays]
            prose.append(found.prose)
            title = title or found.title
    return Document(title, tuple(displays), "\n".join(prose))
