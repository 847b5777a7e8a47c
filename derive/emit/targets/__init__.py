"""Target languages: each folder beside this file is one, found by itself.

A target turns the same material, generated algebra and the kernel, into files of its language. Its folder holds

- ``__init__.py``: ``TARGET``, and ``render``, which puts the files together;
- printers: for the algebra (:mod:`..statements` gives assignments), and for the kernel (:mod:`..language` reads it);
- ``runtime/``: what is not algebra, in files of the target language with ``@name@`` where emitted text goes.

What only one model has in a language stands with that model, and comes with the material: see :attr:`Material.runtime`.

``generated/`` gets a folder for each, with ``target.json``, by which ``spragsym export`` finds it.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from pathlib import Path

from ..function import Function, Module
from ..language import NOTHING, Source, joined
from ..quantities import Quantity
from ..write import as_json


@dataclass(frozen=True)
class Material:
    """What every target prints."""

    modules: tuple[Module, ...]
    kernel: Source
    counts: Mapping[str, float]  #: counts of roundings that the kernel's error bounds name
    quantities: Mapping[str, Quantity]  #: by their names in code
    parameters: tuple[str, ...]  #: of the dimensionless model, in the order in which functions take them
    base_values: Mapping[str, float]
    public: tuple[str, ...]  #: functions of the algebra that a library in another language offers to its callers
    variant: bool  #: whether there are parameters that the published model does not have
    digest: str  #: SHA-256 of what is emitted
    header: str  #: one sentence for the head of every file: where it comes from
    library: str = "spragsym"  #: names of files and functions begin with it in languages without modules of their own
    summary: str = ""  #: one sentence: what the library computes
    #: By target language, the model's own files: what it offers besides algebra, with ``@name@`` where emitted text goes.
    runtime: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    #: Angles by their names, and the arguments of the algebra that stand for one: its cosine and sine, itself before them if it is used.
    angles: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    of_a_page: bool = False  #: whether names are a page's, each of which ends with an underscore, and not known here
    of_page: tuple[Module, ...] = ()  #: further modules, which Python has in the folder of the model's page
    asked: tuple[str, ...] = ()  #: functions of the kernel that extension modules in C call, besides the model's own files
    arithmetic: Source = NOTHING  #: double-double numbers
    widened: Source = NOTHING  #: the kernel a second time, on these

    @property
    def all_modules(self) -> tuple[Module, ...]:
        """What a library has that stands alone."""
        return (*self.modules, *self.of_page)

    @property
    def algebra(self) -> dict[str, Function]:
        """Generated functions by name."""
        return {function.name: function for module in self.all_modules for function in module.functions}

    @property
    def both_kernels(self) -> Source:
        """The kernel on doubles, then on double-doubles, with their arithmetic: for languages that have numbers of one type."""
        return joined(self.arithmetic, self.kernel, self.widened)


@dataclass(frozen=True)
class Target:
    """A language.

    Its name on the command line, its title, its folder below ``generated/``, how its files are made, and the names of those that are
    exported, with ``{library}`` for that of the library and ``*`` for any text. Files that a model does not have, an example say, are
    left out.
    """

    language: str
    title: str
    folder: str
    render: Callable[[Material], dict[str, str]]
    exported: tuple[str, ...] = ()
    variants: bool = False  #: whether it can print parameters that the published model does not have


def targets() -> tuple[Target, ...]:
    """All of them, in the order of their folders' names."""
    folders = sorted(module.name for module in pkgutil.iter_modules(__path__) if module.ispkg)
    return tuple(importlib.import_module(f".{name}", __name__).TARGET for name in folders)


def render(material: Material) -> dict[str, str]:
    """The files of every target that can print the material, by their paths below ``generated/``."""
    rendered: dict[str, str] = {}
    for target in targets():
        if material.variant and not target.variants:
            continue
        for path, text in files(target, material).items():
            if path in rendered:
                raise ArithmeticError(f"{target.title}: another target writes {path} too; give the target a folder of its own")
            rendered[path] = text
    return rendered


def files(target: Target, material: Material) -> dict[str, str]:
    """Every file of a target, by its path below ``generated/``."""
    rendered = target.render(material)
    if target.exported:
        patterns = [pattern.format(library=material.library) for pattern in target.exported]
        names = [name for pattern in patterns for name in rendered if fnmatchcase(name, pattern)]
        entry = {"language": target.language, "title": target.title, "files": names}
        rendered["target.json"] = as_json(entry)
    prefix = f"{target.folder}/" if target.folder else ""
    return {f"{prefix}{name}": text for name, text in rendered.items()}


def runtime(package_file: str, name: str) -> str:
    """The text of a runtime file beside a target's ``__init__.py``."""
    return (Path(package_file).parent / "runtime" / name).read_text(encoding="utf-8")
