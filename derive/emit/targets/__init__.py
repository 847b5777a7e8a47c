"""Target languages: every folder beside this file is one.

A language prints generated algebra and the kernel as files of its own. Its folder holds

- ``__init__.py``: ``render``, which gives the text of every file by its name;
- ``RESERVED`` there: in small letters, the names that its files and its library can't have;
- printers: for the algebra (:mod:`..definitions` has its statements as text), and for the kernel
  (:mod:`..language` reads it);
- ``runtime/``: what is not algebra, in files of the language with ``@name@`` where emitted text
  goes.

Files that only one model has in a language stand with that model and come with the material:
:attr:`Material.runtime`. Nothing here needs SymPy: a library is made when it is exported.
"""

import importlib
import itertools
import pkgutil
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from pathlib import Path
from types import ModuleType
from typing import TypeAlias

from ..definitions import Definition, symbols
from ..language import Source, joined, read
from ..quantities import Interval, Quantity

#: Angles by name, with the arguments that stand for each: its cosine and sine, and before them the
#: angle itself if it is used.
Angles: TypeAlias = Mapping[str, tuple[str, ...]]
#: The sentence under which terms what is exported may be used.
TERMS = (
    "What is of spragsym in it, copyright The spragsym developers, may be used under the MIT "
    "licence (SPDX-License-Identifier: MIT); what follows from a page is its author's."
)

#: What begins and ends a comment, by the end of a file's name.
_COMMENTS = {
    **dict.fromkeys((".c", ".h"), ("/*", " */")),
    **dict.fromkeys((".mjs", ".ts", ".mts"), ("//", "")),
    **dict.fromkeys((".py", ".jl", ".auto", "Makefile"), ("#", "")),
    ".f90": ("!", ""),
    ".m": ("%", ""),
    ".xml": ("<!--", " -->"),
}


@dataclass(frozen=True)
class Variable:
    """A quantity of a model as a user of an FMU sees it, in its unit if there are units."""

    name: str
    meaning: str
    unit: str = ""
    #: powers of kilogram, metre, second and radian in the unit
    dimension: tuple[Fraction, ...] = (Fraction(0),) * 4
    factor: float = 1.0  #: the unit in SI
    powers: tuple[float, ...] = ()  #: powers of the units of measure in its scale
    nominal: float = 1.0  #: its scale, which is 1 in the library, in its unit
    start: float = 0.0
    allowed: Interval = field(default_factory=Interval)
    #: "continuous" or "discrete" for a quantity that other models drive
    input: str = ""
    reset: bool = False  #: whether a rate jumps where friction begins to stick


@dataclass(frozen=True)
class Edge:
    """A border at which a mode of a motion ends."""

    #: "gap" or "face" of a contact; "slip", "ahead" or "behind" of a friction
    kind: str
    place: int  #: index of the number of the mode that changes there
    contact: str  #: name of the contact, if there are several
    row: int = -1  #: index among the dry frictions

    def label(self, what: str) -> str:
        """``what``, followed by the name of the border's contact if there is one."""
        return f"{what}.{self.contact}" if self.contact else what


@dataclass(frozen=True)
class Start:
    """A steady state of a page's model at its base values, from which a branch is continued."""

    name: str
    along: str  #: the parameter that is followed first
    values: Mapping[str, float]  #: all parameters
    place: tuple[float, ...]
    mode: tuple[int, ...]  #: the numbers that select its smooth regime
    error: float  #: bound of the error of each coordinate


@dataclass(frozen=True)
class MotionMaterial:
    """The motion of a page's model, for languages whose libraries step in time or continue it."""

    time: Variable
    states: tuple[Variable, ...]  #: coordinates, then their rates
    accelerations: tuple[Variable, ...]
    #: parameters in order, then units of measure
    given: tuple[Variable, ...]
    step: float  #: time between two samples
    borders: tuple[Edge, ...]  #: kinks of the field
    turnings: int  #: number of torsion springs, each of which has a border
    #: for each contact, whether its law has no values in lift-off
    rooted: tuple[bool, ...]
    #: for each contact, whether it is one of several that can open
    of_place: tuple[bool, ...]
    #: for each friction the index of its contact; one entry on a page without friction
    rubbing: tuple[int, ...]
    outputs: tuple[Variable, ...]  #: forces, energy and power, as the function outputs gives them
    starts: tuple[Start, ...] = ()  #: for languages that continue branches


@dataclass(frozen=True)
class Material:
    """All that a target prints a library from."""

    modules: tuple[tuple[Definition, ...], ...]
    quantities: Mapping[str, Quantity]  #: by names in code
    #: names of the dimensionless parameters, in the order of arguments
    parameters: tuple[str, ...]
    base_values: Mapping[str, float]
    #: names of the functions that the library offers to its callers
    public: tuple[str, ...]
    digest: str  #: SHA-256 of the sources
    header: str  #: the sentence at the head of every file
    #: prefix of files and functions in languages without modules
    library: str = "spragsym"
    summary: str = ""  #: what the library computes, in one sentence
    kernel: Source = field(default_factory=Source)
    #: the counts of roundings that the kernel names
    counts: Mapping[str, float] = field(default_factory=dict)
    #: by language, the model's own files, with ``@name@`` where emitted text goes
    runtime: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    angles: Angles = field(default_factory=dict)
    #: whether the functions are those of a page, whose names end in an underscore
    of_a_page: bool = False
    #: functions of the kernel that extension modules in C call directly
    asked: tuple[str, ...] = ()
    arithmetic: Source = field(default_factory=Source)  #: double-double arithmetic
    widened: Source = field(default_factory=Source)  #: the kernel on double-doubles
    motion: MotionMaterial | None = None  #: of a page, for a language that has it as a whole

    @property
    def algebra(self) -> dict[str, Definition]:
        """Generated functions by name."""
        return {function.name: function for module in self.modules for function in module}

    @property
    def both_kernels(self) -> Source:
        """The double-double arithmetic, and the kernels on doubles and on double-doubles, as one
        source for languages in which a function has one type.
        """
        return joined(self.arithmetic, self.kernel, self.widened)


def transition() -> Source:
    """The rule by which dry frictions go on, for all that step a motion in time."""
    return read(Path(__file__).parents[1] / "transition.py")


def languages() -> list[str]:
    """The names of the target languages."""
    return sorted(module.name for module in pkgutil.iter_modules(__path__) if module.ispkg)


def _target(language: str) -> ModuleType:
    return importlib.import_module(f".{language}", __name__)


def render(language: str, material: Material) -> dict[str, str]:
    """The files of a library in a language, by name."""
    sealed = replace(material, header=f"{material.header} {TERMS}")
    files: dict[str, str] = _target(language).render(sealed)
    return {name: with_terms(name, text) for name, text in files.items()}


def with_terms(name: str, text: str) -> str:
    """A file with the mark of its terms; one without gets it as its last line, so that what stands
    first in it is still its help.
    """
    mark = "SPDX-License-Identifier: MIT"
    before, after = _COMMENTS.get(Path(name).suffix or name, ("", ""))
    if mark in " ".join(text.split()) or not before:
        return text
    return f"{text.rstrip()}\n{before} {mark}{after}\n"


def reserved(language: str) -> frozenset[str]:
    """The names that the library of a page can't have in a language, in small letters."""
    return vars(_target(language)).get("RESERVED", frozenset())


def packer(language: str) -> Callable[..., bytes] | None:
    """The function that packs all files into one, for a language that has one file, of which there
    may be several versions; else None.
    """
    return vars(_target(language)).get("packed")


def moves(language: str) -> bool:
    """Whether the library of a page in a language steps in time, or continues states, so that its
    material needs the motion.
    """
    return hasattr(_target(language), "MOVES") or continues(language)


def continues(language: str) -> bool:
    """Whether a language continues branches of states: it takes starts."""
    return vars(_target(language)).get("CONTINUES", False)


def in_python(language: str) -> bool:
    """Whether a language is Python on another array library, which keeps a page's names."""
    return hasattr(_target(language), "NAMESPACE")


# ------------------------------------------------------------------------------------------------
# shared by languages


def runtime(package_file: str, name: str) -> str:
    """The text of a runtime file beside a target's ``__init__.py``."""
    return (Path(package_file).parent / "runtime" / name).read_text(encoding="utf-8")


def spoken(text: str, words: Mapping[str, str]) -> str:
    """A text with ``@name@``, or a line ``// @name@``, replaced by words; unknown names stay."""
    marked = r"// @(\w+)@\n|@([\w:]+)@"
    return re.sub(marked, lambda at: words.get(at[at.lastindex or 0], at[0]), text)


def words(text: str, comment: str) -> set[str]:
    """The words of a source outside its comments; ``comment`` is the pattern of these."""
    return set(re.findall(r"\w+", re.sub(comment, "", text, flags=re.DOTALL)))


def beginnings(source: str) -> frozenset[str]:
    """The beginnings of the words of a source in C, up to one of their underscores, in small
    letters: a library of such a name would have functions that are called so.
    """
    return frozenset(
        beginning.casefold()
        for word in words(source, r"/\*.*?\*/")
        for beginning in itertools.accumulate(word.split("_"), "{}_{}".format)
        if beginning != word
    )


def taken(function: Definition, angles: Angles) -> list[str]:
    """The arguments of a function, with an angle in place of its cosine and sine."""
    angle_of = {part: angle for angle, parts in angles.items() for part in parts}
    return list(dict.fromkeys(angle_of.get(name, name) for name in function.arguments))


def ranges(material: Material) -> dict[str, Interval]:
    """The domains of the parameters and of all other arguments."""
    further = symbols(material.algebra.values()).keys() - set(material.parameters)
    return {
        name: material.quantities[name].interval
        for name in (*material.parameters, *sorted(further))
    }
