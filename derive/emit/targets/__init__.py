"""Target languages: a folder each, with a printer, runtime files in the language itself, and one entry in :data:`TARGETS`.

A target turns the same material, generated algebra and the kernel, into files of its language. Its folder holds

- ``__init__.py``: ``TARGET``, and ``render``, which puts the files together;
- printers: for the algebra (:mod:`..statements` gives assignments), and for the kernel (:mod:`..language` reads it);
- ``runtime/``: what is not algebra, in files of the target language with ``@name@`` where emitted text goes;
- ``tests/``: the driver with which ``tests/`` runs the target, if it needs one.

``generated/`` gets a folder for each, with ``target.json``, by which ``spragsym export`` finds it.
"""

from __future__ import annotations

import importlib
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from ...kang_nam.catalogue import Function, Module
from ..language import Source

#: Folders of this package that hold a target, in the order in which they are written.
LANGUAGES = ("python", "c99")


@dataclass(frozen=True)
class Material:
    """What every target prints."""

    modules: tuple[Module, ...]
    kernel: Source
    counts: Mapping[str, float]
    source: str  #: head of the hash of what all is made from
    header: str

    @property
    def algebra(self) -> dict[str, Function]:
        """Generated functions by name."""
        return {function.name: function for module in self.modules for function in module.functions}


@dataclass(frozen=True)
class Target:
    """A language: its name on the command line, its title, its folder below ``generated/``, how its files are made, which are exported."""

    language: str
    title: str
    folder: str
    render: Callable[[Material], dict[str, str]]
    exported: tuple[str, ...] = ()
    further: bool = False  #: whether it can print parameters that the published model does not have


def targets() -> tuple[Target, ...]:
    """All of them."""
    return tuple(importlib.import_module(f".{name}", __name__).TARGET for name in LANGUAGES)


def files(target: Target, material: Material) -> dict[str, str]:
    """Every file of a target, by its path below ``generated/``."""
    rendered = target.render(material)
    if target.exported:
        entry = {"language": target.language, "title": target.title, "files": list(target.exported)}
        rendered["target.json"] = json.dumps(entry, indent=1) + "\n"
    prefix = f"{target.folder}/" if target.folder else ""
    return {f"{prefix}{name}": text for name, text in rendered.items()}


def runtime(package_file: str, name: str) -> str:
    """The text of a runtime file beside a target's ``__init__.py``."""
    return (Path(package_file).parent / "runtime" / name).read_text(encoding="utf-8")
