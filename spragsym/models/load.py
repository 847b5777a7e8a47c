"""Models by name or from a folder: shipped ones stand in ``generated/models``, others where ``spragsym derive`` wrote them."""

from __future__ import annotations

import functools
import importlib
import importlib.util
import json
import os
import sys
import threading
from collections.abc import Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

from ..errors import ParameterError, ParameterTypeError, StoreError
from ..names import hint
from .model import Model
from .parameters import parameter_class

#: The model that is meant where none is named.
USUAL = "kang_nam"

#: What ``model.json`` says at least.
_KEYS = frozenset((
    "name", "summary", "drawing", "source", "coordinates", "parameters", "angles", "arguments", "by_parameters", "contact",
    "dampers", "drawn", "friction", "mirror", "scales", "springs", "ties", "files",
))  # fmt: skip

_LOADED: dict[str, Model] = {}
_LOCK = threading.RLock()


@functools.cache
def shipped() -> tuple[str, ...]:
    """Names of the models that come with the package."""
    return tuple(sorted(path.parent.name for path in _shipped_folder().glob("*/model.json")))


def _shipped_folder() -> Path:
    return Path(importlib.import_module("spragsym.generated").__path__[0]) / "models"


def page_of(model: Model, pages: Path) -> Path:
    """Where the page of a model stands: among the shipped ``pages``, or in its folder."""
    return pages / f"{model.name}.py" if model.where == model.name else Path(model.where) / "page.py"


def load(name: str | os.PathLike[str]) -> Model:
    """A model: a shipped one by its name, or the folder that ``spragsym derive`` wrote.

    Its code was generated before; no SymPy is needed. A folder's files are run as Python: load only what you trust.

    Parameters
    ----------
    name : str or path
        A name such as ``"two_springs"``, or a folder.

    Returns
    -------
    Model

    Raises
    ------
    ParameterError
        For a name that no model has, and a folder that holds none.
    StoreError
        For a folder whose files are damaged or changed.

    Examples
    --------
    >>> import spragsym as ss
    >>> model = ss.load("two_springs")
    >>> model.coordinates
    ('x', 'y')
    >>> model.Parameters(theta0=1.0, sigma_2=0.02).shape
    ()
    """
    if not isinstance(name, str | os.PathLike):
        raise ParameterTypeError(f"{name!r} is no model; give a name, one of {', '.join(shipped())}, or a folder")
    text = os.fspath(name)
    if text in _LOADED and text in shipped():  # its files do not change
        return _LOADED[text]
    if text in shipped():
        folder, where = _shipped_folder() / text, text
    elif Path(text).is_dir():
        folder = Path(text).resolve()
        where = str(folder)
    elif text.endswith(".py") and Path(text).is_file():
        folder = Path(text).with_suffix("")
        raise ParameterError(f"{text} is a page: spragsym derive {text} --out {folder} writes its folder, which is what to name")
    else:
        known = shipped()
        raise ParameterError(
            f"{text!r} is no shipped model, and no folder, as spragsym derive PAGE.py --out DIR writes one"
            f"{hint(text, known) or '; the models are ' + ', '.join(known)}"
        )
    with _LOCK:
        about = _about(folder)
        known_model = _LOADED.get(where)
        if known_model is None or known_model.about != about:
            _LOADED[where] = _loaded(folder, where, about)
        return _LOADED[where]


def _about(folder: Path) -> dict[str, Any]:
    """``model.json``, checked."""
    path = folder / "model.json"
    if not path.is_file():
        raise ParameterError(f"{folder} holds no model.json; give a folder that `spragsym derive PAGE.py --out DIR` wrote")
    try:
        about = json.loads(path.read_text(encoding="utf-8"))
    except (UnicodeDecodeError, json.JSONDecodeError) as error:
        raise StoreError(f"{path} is damaged ({error}); derive the page again") from error
    if not isinstance(about, dict) or not about.keys() >= _KEYS:
        missing = ", ".join(sorted(_KEYS - about.keys())) if isinstance(about, dict) else "everything"
        raise StoreError(f"{path} is not what this version of spragsym writes (without {missing}); derive the page again")
    if "algebra.py" not in about["files"]:
        raise StoreError(f"{folder} was derived by another version (without algebra.py); derive the page again")
    if "rate" not in about["scales"]:
        raise StoreError(f"{folder} was derived by another version (without the units of its files); derive the page again")
    if about["friction"] is not None and not about["friction"].keys() >= {"quantities", "at_rest"}:
        raise StoreError(f"{folder} was derived by another version (without what is said of its law); derive the page again")
    return about


def _require_whole(folder: Path, about: Mapping[str, Any]) -> None:
    """Raise unless the files of a folder are as they were written, by a version whose functions mean the same."""
    import hashlib  # takes milliseconds to import, and shipped models have no need of it

    for name, digest in about["files"].items():
        file = folder / name
        if not file.is_file() or hashlib.sha256(file.read_bytes()).hexdigest() != digest:
            state = "is missing" if not file.is_file() else "is not as it was written"
            raise StoreError(f"{file} {state}; derive the page again")
    page = folder / "page.py"
    if "torsions" not in about and page.is_file() and ".torsion(" in page.read_text(encoding="utf-8", errors="replace"):
        raise StoreError(
            f"{folder} was derived when the torque of a torsion spring was k φ up to 41 degrees only; derive the page again"
        )


def _loaded(folder: Path, where: str, about: Mapping[str, Any]) -> Model:
    shipped_one = where == folder.name
    if not shipped_one:
        _require_whole(folder, about)

    def module() -> ModuleType:
        return _module(folder, where)

    room = f"{__package__.rpartition('.')[0]}.{where}"
    if shipped_one and importlib.util.find_spec(room):  # a shipped model with closed forms
        own = importlib.import_module(room)
        model = Model(where, about, module, own.Parameters, own.CLOSED)
    else:
        model = Model(where, about, module, parameter_class(about, where))
    model.Parameters._model = model
    return model


def _module(folder: Path, where: str) -> ModuleType:
    """The functions of the model: of the package for a shipped one, else of a package of the folder's own."""
    if where == folder.name:
        return importlib.import_module(f"spragsym.generated.models.{where}.algebra")
    import hashlib

    # A path may hold bytes that are no text in the locale.
    digest = hashlib.sha256(os.fsencode(where) + (folder / "model.json").read_bytes()).hexdigest()[:16]
    package = f"spragsym_model_{digest}"
    if package not in sys.modules:
        parent = ModuleType(package)
        parent.__path__ = [str(folder)]
        sys.modules[package] = parent
    return importlib.import_module(f"{package}.algebra")
