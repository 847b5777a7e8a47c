"""Pages: where the shipped ones stand, and how one is read."""

from __future__ import annotations

import ast
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from . import mechanics
from .mechanics import Mechanics
from .model import Page, PageError

#: Where the shipped pages stand.
SHIPPED = Path(__file__).parent / "models"


@dataclass(frozen=True)
class Model:
    """A page and what follows from it."""

    name: str
    text: str
    docstring: str
    page: Page
    mechanics: Mechanics


def shipped() -> tuple[Path, ...]:
    """The pages that come with the package, the article's first."""
    pages = sorted(path for path in SHIPPED.glob("*.py") if not path.stem.startswith("_"))
    return tuple(sorted(pages, key=lambda path: path.stem != "kang_nam"))


def read(path: Path) -> Model:
    """Read a page: it is run as a module of this package, wherever it stands."""
    text = path.read_text(encoding="utf-8")
    try:
        tree = _Imports().visit(ast.parse(text, str(path)))
    except SyntaxError as error:
        raise PageError(error.lineno or 0, f"the page is no Python: {error.msg}") from error
    package = __name__.rpartition(".")[0]
    names: dict[str, Any] = {"__name__": f"{package}.models.{path.stem}", "__package__": f"{package}.models"}
    exec(compile(tree, str(path), "exec"), names)  # noqa: S102  # a page is a program: its author runs it
    page = names.get("page")
    if not isinstance(page, Page):
        raise PageError(0, f"{path.name} makes no page; begin it with page = Page('…')")
    return Model(path.stem, text, ast.get_docstring(tree) or "", page, mechanics.of(page))


class _Imports(ast.NodeTransformer):
    """Lets a page name the vocabulary as ``spragsym.derive.model``, ``derive.model`` or ``..model``: one module in any case."""

    def visit_ImportFrom(self, node: ast.ImportFrom) -> ast.ImportFrom:
        if node.level == 0 and node.module in ("spragsym.derive.model", "derive.model"):
            return ast.copy_location(ast.ImportFrom("model", node.names, 2), node)
        return node
