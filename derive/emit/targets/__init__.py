"""Target languages: each folder beside this file is one, found by its name.

A language turns generated algebra and the kernel into files of its own. Its folder holds

- ``__init__.py``: ``render``, which gives the text of every file by its name;
- printers: for the algebra (:mod:`..definitions` has its statements as text), and for the kernel
  (:mod:`..language` reads it);
- ``runtime/``: what is not algebra, in files of the language with ``@name@`` where emitted text
  goes.

What only one model has in a language stands with that model, and comes with the material: see
:attr:`Material.runtime`. Nothing here needs SymPy: a library is put together when it is exported.
"""

import importlib
import pkgutil
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import TypeAlias

from ..definitions import Definition, symbols
from ..language import Source, joined
from ..quantities import Interval, Quantity

#: Angles by their names, and the arguments of the algebra that stand for one: its cosine and sine,
#: itself before them if it is used.
Angles: TypeAlias = Mapping[str, tuple[str, ...]]


@dataclass(frozen=True)
class Variable:
    """A quantity of a model as whoever runs it sees it: in its unit, where there are units."""

    name: str
    meaning: str
    unit: str = ""
    dimension: tuple[Fraction, ...] = (
        Fraction(0),
    ) * 4  #: of the unit: powers of kilogram, metre, second and radian
    factor: float = 1.0  #: one of the unit in SI
    powers: tuple[float, ...] = ()  #: of the units of measure in what is 1 inside
    nominal: float = 1.0  #: what is 1 inside, in its unit
    start: float = 0.0
    allowed: Interval = field(default_factory=Interval)
    #: Of a quantity that another model drives: "continuous", or "discrete" at events.
    input: str = ""
    reset: bool = False  #: of a rate: whether it jumps where friction begins to hold


@dataclass(frozen=True)
class Edge:
    """A border at which a mode of a motion ends, and the number of the mode that it changes."""

    #: ``gap`` and ``face`` of a contact, ``slip``, ``ahead`` and ``behind`` of a friction.
    kind: str
    place: int
    contact: str  #: its name, of several
    row: int = -1  #: of friction that holds, its number among these

    def said(self, what: str) -> str:
        """What is said of it, by the name of its contact, of several."""
        return f"{what}.{self.contact}" if self.contact else what


@dataclass(frozen=True)
class MotionMaterial:
    """Motion of a page's model, for languages that hand it over as a whole."""

    time: Variable
    states: tuple[Variable, ...]  #: coordinates, then their rates
    accelerations: tuple[Variable, ...]
    #: Parameters in their order, then units of measure where there are any.
    given: tuple[Variable, ...]
    step: float  #: between two samples, in the unit of time
    borders: tuple[Edge, ...]  #: where it is not smooth
    turnings: int  #: springs whose turning is counted, each with a border too
    #: Of each contact whether its law has no values without contact, and whether it goes with the
    #: place of a state at rest.
    rooted: tuple[bool, ...]
    of_place: tuple[bool, ...]
    #: Of each friction its contact, by its number; of a page without friction there is one.
    rubbing: tuple[int, ...]
    outputs: tuple[Variable, ...]  #: forces, energy and power, in the order of the function outputs


@dataclass(frozen=True)
class Material:
    """Material that every target prints."""

    modules: tuple[tuple[Definition, ...], ...]
    quantities: Mapping[str, Quantity]  #: by their names in code
    #: Of the dimensionless model, in the order in which functions take them.
    parameters: tuple[str, ...]
    base_values: Mapping[str, float]
    #: Functions of the algebra that a library in another language offers to its callers.
    public: tuple[str, ...]
    digest: str  #: SHA-256 of what it is made of
    header: str  #: one sentence for the head of every file: where it comes from
    # names of files and functions begin with it in languages without modules of their own
    library: str = "spragsym"
    summary: str = ""  #: one sentence: what the library computes
    kernel: Source = field(default_factory=Source)
    #: Counts of roundings that the kernel's error bounds name.
    counts: Mapping[str, float] = field(default_factory=dict)
    #: By target language, the model's own files: what it offers besides algebra, with ``@name@``
    #: where emitted text goes.
    runtime: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    angles: Angles = field(default_factory=dict)
    # whether names are a page's, each of which ends with an underscore, and not known here
    of_a_page: bool = False
    asked: tuple[
        str, ...
        # functions of the kernel that extension modules in C call, besides the model's own files
    ] = ()
    arithmetic: Source = field(default_factory=Source)  #: double-double numbers
    widened: Source = field(default_factory=Source)  #: the kernel a second time, on these
    motion: MotionMaterial | None = None  #: of a page

    @property
    def algebra(self) -> dict[str, Definition]:
        """Generated functions by name."""
        return {function.name: function for module in self.modules for function in module}

    @property
    def both_kernels(self) -> Source:
        """The kernel on doubles, then on double-doubles, with their arithmetic: for languages that
        have numbers of one type.
        """
        return joined(self.arithmetic, self.kernel, self.widened)


def languages() -> list[str]:
    """Their names."""
    return sorted(module.name for module in pkgutil.iter_modules(__path__) if module.ispkg)


def render(language: str, material: Material) -> dict[str, str]:
    """The files of a library in a language, by their names."""
    files: dict[str, str] = importlib.import_module(f".{language}", __name__).render(material)
    return files


def packer(language: str) -> Callable[[Mapping[str, str]], bytes] | None:
    """Function that makes one file of all in a language that has it so; None for others."""
    return vars(importlib.import_module(f".{language}", __name__)).get("packed")


def in_python(language: str) -> bool:
    """Whether it is Python on another array library, where a page's names are as they are."""
    return hasattr(importlib.import_module(f".{language}", __name__), "NAMESPACE")


# ------------------------------------------------------------------------------------------- what
# languages share


def runtime(package_file: str, name: str) -> str:
    """The text of a runtime file beside a target's ``__init__.py``."""
    return (Path(package_file).parent / "runtime" / name).read_text(encoding="utf-8")


def spoken(text: str, words: Mapping[str, str]) -> str:
    """A text with words in the places that ``@name@`` marks."""
    return re.sub(r"@([\w:]+)@", lambda match: words.get(match[1], match[0]), text)


def words(text: str, comment: str) -> set[str]:
    """Words of a source outside of its comments, which a pattern finds."""
    return set(re.findall(r"\w+", re.sub(comment, "", text, flags=re.DOTALL)))


def taken(function: Definition, angles: Angles) -> list[str]:
    """Arguments of the algebra, an angle in the place of its cosine and sine."""
    angle_of = {part: angle for angle, parts in angles.items() for part in parts}
    return list(dict.fromkeys(angle_of.get(name, name) for name in function.arguments))


def ranges(material: Material) -> dict[str, Interval]:
    """The allowed values of the parameters, and of what the algebra takes besides."""
    further = symbols(material.algebra.values()).keys() - set(material.parameters)
    return {
        name: material.quantities[name].interval
        for name in (*material.parameters, *sorted(further))
    }
