"""Reading of pages: a page is run, checked and derived."""

import ast
import hashlib
import inspect
import re
import traceback
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from . import mechanics, statement_checks, smoothness_checks, physical_checks
from . import model as vocabulary
from .limits import Limit
from .mechanics import Mechanics
from .model import Page, PageError

#: Where the shipped pages stand.
SHIPPED = Path(__file__).parent / "models"
#: Folders of pages that belong to the source of this package.
OWN = (SHIPPED, SHIPPED.resolve().parents[1] / "validation" / "papers")


@dataclass(frozen=True)
class PageModel:
    """A page with its mechanics."""

    name: str
    text: str
    docstring: str
    page: Page
    mechanics: Mechanics

    @property
    def digest(self) -> str:
        """SHA-256 of the page's text."""
        return hashlib.sha256(self.text.encode()).hexdigest()


def shipped() -> tuple[Path, ...]:
    """Paths of the pages that come with the package, the article's first."""
    pages = sorted(path for path in SHIPPED.glob("*.py") if not path.stem.startswith("_"))
    return tuple(sorted(pages, key=lambda path: path.stem != "kang_nam"))


def read(path: Path, name: str = "", *, only_equations: bool = False) -> PageModel:
    """Read a page; the model is named after its file, or ``name``.

    The page is run as a module of this package. The result is cached by the page's text. Of
    ``only_equations`` of motion a page may have no equilibrium: a coordinate without a force, drag,
    a support that a clock moves.

    Raises
    ------
    PageError
        If it can't be read or derived, with the page's name and the line.
    """
    try:
        largest = 1 << 20  # bytes
        if not path.is_file() or path.stat().st_size > largest:
            raise PageError(
                0, f"the page is no file, or has more than {largest} bytes; give a file of Python"
            )
        # The folder of a model is loaded by such names only.
        a_name = re.compile(r"\w[\w .-]*")
        if not a_name.fullmatch(name or path.stem):
            raise PageError(
                0,
                f"its name {name or path.stem!a} holds more than letters, digits, blanks and "
                ". - _; rename the file",
            )
        text = path.read_text(encoding="utf-8-sig")
        return _model(path, text, name or path.stem, only_equations)
    except UnicodeDecodeError as error:
        raise PageError(
            0, f"the file is no text in UTF-8: {error.reason}; save it as UTF-8", path.name
        ) from error
    except PageError as error:
        raise error.of(path.name) from error


@cache
def _model(path: Path, text: str, name: str, only_equations: bool) -> PageModel:
    page, docstring = _run(path, text)
    vocabulary.check_characters("the docstring", docstring, 1, "\n\t")
    statement_checks.check(page, docstring, only_equations=only_equations)
    physical_checks.check_units(page)
    physical_checks.groups(page)
    model = mechanics.of(page)
    smoothness_checks.check(model, only_equations=only_equations)
    physical_checks.check_forces(model, only_equations=only_equations)
    statement_checks.check_used(page)
    return PageModel(name, text, docstring, page, model)


def _run(path: Path, text: str) -> tuple[Page, str]:
    """Run a page: the Page that it makes, and its docstring."""
    try:
        tree = ast.parse(text, str(path))
    except SyntaxError as error:
        raise PageError(error.lineno or 0, f"the page is no Python: {error.msg}") from error
    except (
        ValueError,
        RecursionError,
        MemoryError,
    ) as error:  # a NUL, or a line of thousands of terms
        raise PageError(
            0, f"the page is no Python that can be read: {error}; write shorter lines"
        ) from error
    # All pages use one module, by whichever name they import it.
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module in (
            "spragsym.derive.model",
            "derive.model",
        ):
            node.module, node.level = "model", 2
    package = __name__.rpartition(".")[0]
    names: dict[str, Any] = {
        "__name__": f"{package}.models.{path.stem}",
        "__package__": f"{package}.models",
    }
    try:
        # a page is a program: its author runs it
        exec(compile(tree, str(path), "exec"), names)  # noqa: S102
    except PageError:
        raise
    except (Exception, SystemExit) as error:
        lines = [
            frame.lineno or 0
            for frame in traceback.extract_tb(error.__traceback__)
            if frame.filename == str(path)
        ]
        raise PageError(lines[-1] if lines else 0, _said(error)) from error
    page = names.get("page")
    if not isinstance(page, Page):
        raise PageError(0, "the file makes no page; begin it with page = Page('…')")
    return page, ast.get_docstring(tree) or ""


def _said(error: BaseException) -> str:
    """The text of an error in a page, with the remedy for a missing name or a wrong argument."""
    said = f"{type(error).__name__}: {error}"
    names = f"spragsym.derive.model offers {', '.join(vocabulary.__all__)}"
    if isinstance(error, ImportError):
        return f"{str(error).partition(' (')[0]}; {names}"  # without the place of the package
    forcing = f": {Limit.FORCING}" if getattr(error, "name", None) in ("t", "time") else ""
    call = re.match(r"(Page\.)?(\w+)\(\) (.+)", str(error))
    asked = call and vars(Page if call[1] else vocabulary).get(call[2])
    if call and isinstance(error, TypeError) and inspect.isfunction(asked):
        is_page = call[2] == "__init__"  # its other fields are what statements add to
        taken = [it for it in inspect.signature(asked).parameters if it != "self"]
        name = "Page" if is_page else f"page.{call[2]}" if call[1] else call[2]
        return f"{name}: {call[3]}; it takes {', '.join(taken[:1] if is_page else taken)}"
    if isinstance(error, NameError):
        return said + (forcing or f"; define it above, or import it: {names}")
    if isinstance(error, AttributeError) and isinstance(error.obj, Page):
        offered = ", ".join(
            name
            for name, value in vars(Page).items()
            if callable(value) and not name.startswith("_")
        )
        return f"{said}{forcing}; a page has {offered}"
    return said
