"""MathML of expressions in SymPy's syntax, which browsers show without any library."""

from __future__ import annotations

import html
import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Sequence

from ..shapes import greek
from .tree import FUNCTIONS, Node, Unread, Vocabulary, read_sympy


def rendered(text: str, coordinates: Sequence[str]) -> str | None:
    """MathML of equations separated by semicolons, with dots on rates; None if they can't be read.

    Examples
    --------
    >>> from spragsym.derive.statements.mathml import rendered
    >>> rendered("m_1*ax = 0", ["x"])
    '<math><mrow><msub><mi>m</mi><mn>1</mn></msub><mo>&#8290;</mo><mover><mi>x</mi>\
<mo>¨</mo></mover></mrow><mo>=</mo><mn>0</mn></math>'
    """
    names = frozenset(re.findall(r"[^\W\d]\w*", text)) - FUNCTIONS.keys()
    try:
        found = read_sympy(text, Vocabulary(names, (), {}))
    except Unread:
        return None
    dotted = {
        f"{mark}{it}": (it, dots) for it in coordinates for mark, dots in (("v", "˙"), ("a", "¨"))
    }
    sides = [f"{_shown(it.left, dotted)}<mo>=</mo>{_shown(it.right, dotted)}" for it in found]
    if "=" not in text:
        sides = [_shown(it.left, dotted) for it in found]
    return "".join(f"<math>{it}</math>" for it in sides)


def _shown(node: Node, dotted: dict[str, tuple[str, str]]) -> str:
    """MathML of a tree."""
    parts = [_shown(part, dotted) for part in node.args]
    match node.kind:
        case "number":
            return f"<mn>{node.value}</mn>"
        case "symbol" if node.value in dotted:
            name, dots = dotted[node.value]
            return f"<mover>{_name(name)}<mo>{dots}</mo></mover>"
        case "symbol":
            return _name(node.value)
        case "neg":
            return f"<mrow><mo>-</mo>{_bracketed(node.args[0], parts[0], ('add', 'neg'))}</mrow>"
        case "add":
            signed = [
                it if part.kind == "neg" else f"<mo>+</mo>{it}"
                for part, it in zip(node.args[1:], parts[1:], strict=True)
            ]
            return f"<mrow>{parts[0]}{''.join(signed)}</mrow>"
        case "mul":
            factors = [
                _bracketed(part, it, ("add", "neg"))
                for part, it in zip(node.args, parts, strict=True)
            ]
            return f"<mrow>{'<mo>&#8290;</mo>'.join(factors)}</mrow>"
        case "div":
            return f"<mfrac>{parts[0]}{parts[1]}</mfrac>"
        case "pow":
            base = _bracketed(node.args[0], parts[0], ("add", "neg", "mul", "div", "pow"))
            return f"<msup>{base}{parts[1]}</msup>"
    if node.value == "sqrt":
        return f"<msqrt>{parts[0]}</msqrt>"
    if node.value == "Abs":
        return f"<mrow><mo>|</mo>{parts[0]}<mo>|</mo></mrow>"
    inner = "<mo>,</mo>".join(parts)
    return f"<mrow><mi>{node.value}</mi><mo>(</mo>{inner}<mo>)</mo></mrow>"


def _bracketed(node: Node, text: str, kinds: tuple[str, ...]) -> str:
    """MathML of an operand, in brackets if its node is of one of the kinds."""
    return f"<mrow><mo>(</mo>{text}<mo>)</mo></mrow>" if node.kind in kinds else text


def _name(name: str) -> str:
    """MathML of a name with its index; names of Greek letters become these letters."""
    letters_and_index = re.compile(r"([^\W\d_]+)_?(\w*)")
    found = letters_and_index.fullmatch(name)
    base, index = (found[1], found[2]) if found else (name, "")
    letter = f"<mi>{html.escape(greek(base))}</mi>"
    if not index:
        return letter
    sign = "mn" if index.isdigit() else "mi"
    return f"<msub>{letter}<{sign}>{html.escape(greek(index))}</{sign}></msub>"


#: Attributes of MathML that only lay out.
_LAYOUT = re.compile(
    r"accent|close|open|column\w+|row\w+|display|displaystyle|fence|form|height|width|depth|largeop"
    r"|linethickness|[lr]space|mathvariant|(max|min)size|movablelimits|notation|scriptlevel"
    r"|separators?|stretchy|symmetric|voffset"
)
_MARK = "#d55e00"  #: the colour by which a marked part is found


def typeset(latex: str) -> str | None:
    """MathML of an equation as it is printed in LaTeX; what stands between guillemets is marked by
    the class ``edit``. None if it can't be laid out.
    """
    from latex2mathml.converter import convert_to_element  # imported late: only HTML needs it

    source = re.sub(r"\\(?:label|tag)\{[^{}]*\}|\\(?:nonumber|notag)\b", "", latex)
    source = source.replace("«", rf"{{\color{{{_MARK}}} ").replace("»", "}")
    if re.search(
        r"(?<!\\)&|\\\\", re.sub(r"\\begin\{(\w+)\}.*\\end\{\1\}", "", source, flags=re.S)
    ):
        source = rf"\begin{{aligned}}{source}\end{{aligned}}"
    try:
        found = convert_to_element(source, display="block")
    except Exception:  # of any kind: it reads what others wrote
        return None
    for part in found.iter():
        is_mark = part.attrib.get("mathcolor") == _MARK
        part.attrib = {name: it for name, it in part.attrib.items() if _LAYOUT.fullmatch(name)}
        if is_mark:
            part.set("class", "edit")
        # The library has entities where a tree has characters.
        part.text, part.tail = (it and html.unescape(it) for it in (part.text, part.tail))
    return ElementTree.tostring(found, encoding="unicode")
