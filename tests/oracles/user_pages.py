"""Pages as a user writes them, and their models, each derived once."""

import functools
import hashlib
from importlib.metadata import version
from pathlib import Path
from typing import Any

from filelock import FileLock

import spragsym as ss

ROOT = Path(__file__).parents[2]


def replaced(text: str, *changes: tuple[str, str]) -> str:
    """A text with pieces, each of which stands there once, replaced."""
    for before, after in changes:
        assert text.count(before) == 1, before
        text = text.replace(before, after)
    return text


def shipped_page(name: str, *changes: tuple[str, str]) -> str:
    """A page of the package as a user's, with pieces of its text replaced."""
    text = (ROOT / "derive/models" / f"{name}.py").read_text(encoding="utf-8")
    return replaced(text, ("from ..model import", "from spragsym.derive.model import"), *changes)


def derived(text: str, name: str) -> Path:
    """The folder of a page: derived once, also for later runs, and again after a change of the page
    or of the derivation.
    """
    from spragsym.derive.folder import write_page

    place = (
        ROOT
        / ".pytest_cache/pages"
        / _derivation()
        / hashlib.sha256(text.encode()).hexdigest()[:16]
    )
    place.mkdir(parents=True, exist_ok=True)
    with FileLock(place / f"{name}.lock"):
        if not (place / name).is_dir():
            (place / f"{name}.py").write_text(text, encoding="utf-8")
            write_page(place / f"{name}.py", place / name)
    return place / name


@functools.cache
def _derivation() -> str:
    digest = hashlib.sha256()
    for path in sorted((ROOT / "derive").rglob("*")):
        if path.is_file() and path.suffix != ".pyc":
            digest.update(
                path.relative_to(ROOT).as_posix().encode() + b"\0" + path.read_bytes() + b"\0"
            )
    return f"{digest.hexdigest()[:16]}-{version('sympy')}"


def model_of(text: str, name: str) -> Any:
    """The model of a page."""
    return ss.load(derived(text, name))


def alone(name: str) -> Any:
    """The model of a shipped page in a folder of its own: its functions take all arguments by name,
    and the kinked field is among them, from which other languages move.
    """
    return model_of(shipped_page(name), name)


#: A damped mass in two wells, whose hump is as high as the length l makes it.
WELLS = """'''Two wells.'''
from spragsym.derive.model import Page

page = Page("A damped mass in two wells.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
F = page.unit("F", "N", "force")
l = page.parameter("l", "m", "half the distance of the wells", "> 0", 1.0)
P = page.parameter("P", "N", "push", "real", 0.05)
c = page.parameter("c", "N s/m", "damper", ">= 0", 0.1)
x = page.coordinate("x", "m", "place")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.potential(-k * x**2 / 2 + k * x**4 / (4 * l**2))
page.damper(c, along=x)
page.force(P, along=x)
"""
