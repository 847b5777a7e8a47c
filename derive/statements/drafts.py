"""Drafts of files of statements, from the displayed equations of a document: what each is about is
guessed, and the guess says why.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from .alone import derivatives_in, moving_names, read_alone
from .documents import Display, Document

from .tree import Equation, Node, Unread, nodes, symbols

#: Letters that papers give to energies, as the reader spells them.
_KINETIC = r"(mathcal|mathrm)?(T|K|KE|E_?k\w*|E_?c|Ekin|E_kin|T_?(tot|total)|K_?(tot|total))"
_POTENTIAL = r"(mathcal|mathrm)?(V|U|P|PE|E_?p\w*|W|Pi|V_?(tot|total)|U_?(tot|total))"
_LAGRANGIAN = r"(mathcal|mathrm|mathscr)?L(ag)?"
_MATRIX = re.compile(
    r"\s*(?:\\(?:mathbf|bm|boldsymbol|mathrm)\s*\{?)?([MCDGK])\}?\s*(?:\([^=]*\))?"
    r"\s*&?=\s*(?:\\left\s*[\[(])?\s*\\begin\{[a-z]*(?:matrix|array)"
)
_MATRICES = {"M": "mass", "C": "damping", "D": "damping", "G": "gyroscopic", "K": "stiffness"}


@dataclass(frozen=True)
class Drafted:
    """A displayed equation with what it may be about, and why."""

    display: Display
    about: str
    why: str
    is_read: bool


@dataclass(frozen=True)
class Draft:
    """The draft of a file of statements."""

    title: str
    rows: tuple[Drafted, ...]
    meanings: dict[str, str]  #: what the text says of each name, or nothing

    @property
    def unread(self) -> int:
        """Number of equations that can't be read."""
        return sum(not it.is_read for it in self.rows)

    @property
    def judged(self) -> int:
        """Number of equations that are about something a page has."""
        return sum(it.about not in ("other", "notation") for it in self.rows)


@dataclass
class _Known:
    """What the equations before one have given."""

    coordinates: tuple[str, ...]
    places: frozenset[str]  #: names that move and are defined by coordinates
    given: set[str] = field(default_factory=set)
    moved: Counter[str] = field(default_factory=Counter)


def drafted(document: Document) -> Draft:
    """The draft of a document's equations."""
    displays = [one for it in document.displays for one in _set_apart(it)]
    texts = [it.latex for it in displays]
    moving = moving_names(texts)
    read: list[list[Equation] | Unread] = []
    for text in texts:
        try:
            read.append(read_alone(_as_equal(text), moving))
        except (Unread, RecursionError) as error:
            read.append(error if isinstance(error, Unread) else Unread("too large"))
    whole = [one for it in read if isinstance(it, list) for one in it]
    coordinates, places = _coordinates(whole, moving)
    known = _Known(coordinates, places)
    rows = []
    for display, it in zip(displays, read, strict=True):
        if isinstance(it, Unread):
            rows.append(Drafted(display, "other", f"unread: {it.reason}", False))
        else:
            rows.append(Drafted(display, *_guess(display.latex, it, known), True))
    names = Counter(
        base
        for one in whole
        for name in symbols(one.left) | symbols(one.right)
        if not (base := _base(name, moving)).startswith("diff(")
    )
    meanings = {name: "" for name, _ in names.most_common()} | {
        name: said for name, said in _said(document.prose).items() if name in names
    }
    return Draft(document.title, tuple(rows), meanings)


def _set_apart(display: Display) -> list[Display]:
    """A display, or each of several energies that are printed side by side in it."""
    parts = re.split(r"[,;]?(?:\s|\\[,;])*\\q?quad(?![A-Za-z])(?:\s|\\q?quad)*", display.latex)
    energies = "|".join((_KINETIC, _POTENTIAL, _LAGRANGIAN))
    names = (re.sub(r"[\\{}&\s]", "", it.partition("=")[0]) for it in parts)
    if len(parts) > 1 and all(re.fullmatch(rf"(?:{energies})(?:\(.*\))?", it) for it in names):
        return [replace(display, latex=it) for it in parts]
    return [display]


def _as_equal(text: str) -> str:
    """A print in which what is approximately equal is equal."""
    return re.sub(r"\\(?:approx|simeq|cong)(?![A-Za-z])", lambda it: "=".center(len(it[0])), text)


def _base(name: str, moving: frozenset[str]) -> str:
    """The name of which another is the rate or the acceleration."""
    return name[1:] if name[:1] in ("v", "a") and name[1:] in moving else name


def _coordinates(
    equations: Sequence[Equation], moving: frozenset[str]
) -> tuple[tuple[str, ...], frozenset[str]]:
    """The names that move, without those that an equation defines by others, and the latter."""
    own: set[str] = set()
    counts: Counter[str] = Counter()
    for one in equations:
        others = {_base(it, moving) for it in symbols(one.right)} & moving
        is_new = one.left.kind == "symbol" and one.left.value in moving
        place = one.left.value.removeprefix("v") if one.left.kind == "symbol" else ""
        is_rate = place in moving and any(f"v{it}" in symbols(one.right) for it in moving)
        if (is_new or is_rate) and others - {place} and place not in others:
            own.add(place)
        if is_new and derivatives_in(one):
            own.add(one.left.value)  # a momentum
        for side in (one.left, one.right):
            counts.update(_base(it.value, moving) for it in nodes(side) if it.kind == "symbol")
    rest = [it for it in sorted(moving - own) if not re.fullmatch(r"q(_[a-z])?|[EHLTVU]", it)]
    return tuple(sorted(rest, key=lambda it: -counts[it])), frozenset(own)


def _guess(latex: str, equations: Sequence[Equation], known: _Known) -> tuple[str, str]:
    """What equations may be about, and why."""
    first = equations[0]
    inside = set().union(*(symbols(it.left) | symbols(it.right) for it in equations))
    seconds = [it for it in known.coordinates if f"a{it}" in inside]
    rates = [it for it in (*known.coordinates, *known.places) if f"v{it}" in inside]
    left, name = first.left, first.left.value if first.left.kind == "symbol" else ""
    if not re.search(r"(?<![<>!])=|\\equiv|\\approx|\\simeq", latex):
        return "other", "no equation"
    if re.search(r"\\(?:approx|simeq|cong)(?![A-Za-z])", latex):
        return "other", "an approximation; give about, and say in which limit"
    formal = set().union(*map(derivatives_in, equations))
    if any(re.search(r"\bv?q(_[a-z])?\b", it) for it in formal):
        return "notation", "Lagrange's equations of any coordinate"
    if not name and left.kind == "symbol":
        return "other", "no name"
    if matrix := _MATRIX.match(latex):
        return _MATRICES[matrix[1]], f"a matrix that is called {matrix[1]}"
    if re.search(r"\\begin\{[a-z]*(?:matrix|array)\}", latex):
        return "other", "a vector or a matrix"
    energy = _energy(name, first, rates, known)
    if energy:
        return energy
    if seconds:
        return _of_motion(left, name, equations, seconds, known)
    if {"lam", "lambda"} & inside and any(it.kind == "pow" for it in nodes(first.left)):
        return "characteristic", "a polynomial of λ"
    if formal or (left.kind == "symbol" and left.value.startswith("diff(")):
        return "identity", "a derivative"
    if name and name not in known.coordinates and (name[1:] in known.given or name in known.given):
        return "identity", f"{name} is given before, or a rate of what is"
    if name and name not in known.coordinates and name[1:] not in known.coordinates:
        known.given.add(name)
        return "definition", f"a new name, {name}"
    return _of_rest(first, inside, rates, known)


def _energy(
    name: str, first: Equation, rates: Sequence[str], known: _Known
) -> tuple[str, str] | None:
    """The guess for a name that energies have."""
    if re.fullmatch(_LAGRANGIAN, name) and (rates or len(symbols(first.right)) <= 3):
        return "energy L", f"{name} of rates, or of energies"
    if re.fullmatch(_KINETIC, name) and rates:
        return "energy T", f"{name} of rates"
    is_of_places = symbols(first.right) & {*known.coordinates, *known.places}
    if re.fullmatch(_POTENTIAL, name) and not rates and is_of_places:
        return "energy V", f"{name} of coordinates without rates"
    return None


def _of_motion(
    left: Node, name: str, equations: Sequence[Equation], seconds: Sequence[str], known: _Known
) -> tuple[str, str]:
    """The guess for an equation that holds accelerations."""
    if derivatives_in(equations[0]):
        return "identity", "a derivative"
    alone = name[1:] if name[:1] == "a" and name[1:] in seconds else ""
    if name and not alone:
        is_place = name[1:] in known.places or name in known.given
        if is_place:
            return "identity", f"the value of {name}"
        known.given.add(name)
        return "definition", f"a new name, {name}, of accelerations"
    if alone and not any(f"a{it}" in symbols(equations[0].right) for it in seconds):
        known.moved[alone] += 1
        return f"acceleration {alone}", f"solved for the acceleration of {alone}"
    # Coefficients of an own acceleration seldom hold a cosine.
    plain = [it for it in seconds if not _with_waves(equations[0], f"a{it}")]
    chosen = min(plain or seconds, key=lambda it: (known.moved[it], seconds.index(it)))
    chosen = alone or chosen
    known.moved[chosen] += 1
    others = ", ".join(it for it in seconds if it != chosen)
    return f"motion {chosen}", f"accelerations of {chosen}" + (f" and {others}" if others else "")


def _with_waves(equation: Equation, second: str) -> bool:
    """Whether an acceleration stands in a product with a sine or a cosine."""
    products = (it for side in (equation.left, equation.right) for it in nodes(side))
    for it in (it for it in products if it.kind == "mul"):
        values = [one.value for part in it.args for one in nodes(part)]
        is_plain = all(part.kind != "add" for part in it.args if second in symbols(part))
        if second in values and {"sin", "cos"} & {*values} and is_plain:
            return True
    return False


def _of_rest(
    first: Equation, inside: set[str], rates: Sequence[str], known: _Known
) -> tuple[str, str]:
    """The guess for an equation without accelerations and without a new name."""
    here = [it for it in known.coordinates if it in inside]
    left = first.left
    if rates or (left.kind == "symbol" and left.value in known.coordinates):
        return "other", "a solution, a constraint or an integral; no object of a page"
    if here and first.right.value == "0":
        return f"equilibrium {here[0]}", "coordinates without rates"
    return "other", "no name on the left"


# ------------------------------------------------------------------------------------------------
# what the text says of names

_MATH = r"\$\s*(?P<name>\\?[A-Za-z]+(?:_(?:\{[^{}$]*\}|\w))?)\s*(?:\(t\))?\s*\$"
_AFTER = re.compile(
    _MATH + r"\*{0,2}\s*(?::|is|are|denotes|represents|being|stands for|be|the|—|–|-|=)\s*"
    r"(?P<said>[^.,;:$\n\\&|]{3,70})"
)
_BEFORE = re.compile(r"(?:[Tt]he|[Aa]n?|of|with|and)\s+(?P<said>(?:[\w-]+ ){1,4}?)" + _MATH)


def _said(prose: str) -> dict[str, str]:
    """What a text says of names: ``$m$ is the mass``, ``the mass $m$``."""
    prose, found = re.sub(r"\\\(|\\\)", "$", prose), dict[str, str]()
    for pattern in (_AFTER, _BEFORE):
        for it in pattern.finditer(prose):
            try:
                node = read_alone(it["name"], ())[0].left
            except Unread:
                continue
            said = re.sub(r"^(?:is|are|the|an?|denotes|be)\s+", "", " ".join(it["said"].split()))
            said = re.split(r"\s(?:and|where|with|which|so|in terms)\b", said)[0]
            if node.kind == "symbol" and re.search(r"[a-z]{3}", said):
                found.setdefault(node.value, said)
    return found


# ------------------------------------------------------------------------------------------------
# the file


def as_toml(draft: Draft, source: str) -> str:
    """The text of a file of statements; all texts are visible ones already."""
    total = len(draft.rows)
    lines = [
        f"# Drafted from {source}: {total} displayed equations, {total - draft.unread} read, "
        f"{draft.unread} unread;",
        f"# {draft.judged} have a guess of what they are about, which is worth a look; other is "
        "not judged.",
        '# Name the page that they are held against, model = "page.py"; without it the energies',
        "# and forces that are printed first are premises, and all else is held against these.",
        f"paper = {_quoted(draft.title or source)}",
        "",
        "[meanings]",
    ]
    lines += [f"{_quoted(name)} = {_quoted(said)}" for name, said in draft.meanings.items()]
    ids: Counter[str] = Counter()
    for number, row in enumerate(draft.rows, 1):
        label = re.sub(r"[^\w:.-]+", "-", row.display.label).strip("-") or str(number)
        ids[label] += 1
        where = f"line {row.display.line}"
        if row.display.cell:
            where = f"cell {row.display.cell}, {where}"
        lines += [
            "",
            "[[statement]]",
            f"id = {_quoted(label if ids[label] == 1 else f'{label}-{ids[label]}')}",
            f"where = {_quoted(where)}",
            f"about = {_quoted(row.about)}",
            f"latex = {_literal(row.display.latex)}",
            f"note = {_quoted(row.why)}",
        ]
    return "\n".join([*lines, ""])


def _quoted(text: str) -> str:
    """A text of TOML between quotation marks."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _literal(text: str) -> str:
    """A text of TOML as it stands; between quotation marks if it holds three apostrophes."""
    return _quoted(text) if "'''" in text or text.endswith("'") else f"'''{text}'''"
