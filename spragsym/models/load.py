"""Loading of models: shipped ones by name, others from a folder that ``spragsym derive`` wrote.

The generated code of a shipped model stands in ``generated/models``. That of a folder is compiled
from bytes whose digests have been verified.
"""

from __future__ import annotations

import hashlib
import importlib
import importlib.util
import os
import re
import shlex
import sys
import threading
from collections.abc import Mapping, Sequence
from functools import cache, partial
from itertools import chain
from pathlib import Path
from types import ModuleType
from typing import Any

from ..core.errors import ParameterError, ParameterTypeError, StoreError, hint
from ..files.text import contents, json_of, printed, text_of
from .model import Model, parameter_class

#: The default model.
USUAL = "kang_nam"
#: Name of the model that adds dampers beside the springs, by the name of the one without.
WITH_DAMPERS = {"kang_nam": "damped"}

#: Files of a folder that hold its code.
NEEDED = ("_broadcast.py", "algebra.py")
#: Largest size in bytes of a file of a folder, more than any generated one has.
_LARGEST = 64 << 20

_LOADED: dict[str, Model] = {}
_LOCK = threading.RLock()


@cache
def shipped() -> tuple[str, ...]:
    """Names of the models that come with the package."""
    return tuple(sorted(path.parent.name for path in _shipped_folder().glob("*/model.json")))


def _shipped_folder() -> Path:
    return Path(importlib.import_module("spragsym.generated").__path__[0]) / "models"


@cache
def _about(name: str) -> dict[str, Any]:
    """What ``model.json`` of a shipped model says."""
    text = (_shipped_folder() / name / "model.json").read_text(encoding="utf-8")
    about: dict[str, Any] = json_of(text)
    return about


def page_of(model: Model, pages: Path) -> Path:
    """Path of the page of a model: among the shipped ``pages``, or in the model's folder."""
    if model.where == model.name:
        return pages / f"{model.name}.py"
    return Path(model.where) / "page.py"


def mechanism(model: Model) -> str:
    """Drawing of a model's mechanism as SVG text; empty if its folder is from an older version
    without one.
    """
    folder = _shipped_folder() / model.where if model.where in shipped() else Path(model.where)
    path = folder / f"{model.name}.svg"
    return text_of(path, _LARGEST) if path.is_file() else ""


def load(name: str | os.PathLike[str]) -> Model:
    """Load a shipped model by its name, or a model from the folder that ``spragsym derive`` wrote.

    The code has been generated before; no SymPy is needed. A folder's files are run as Python: load
    only what you trust.

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
        For a name or a folder without a model.
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
        raise ParameterTypeError(
            f"{name!r} is no model; give a name, one of {', '.join(shipped())}, or a folder"
        )
    text = os.fspath(name)
    if len(text) > 4096 or "\0" in text:
        raise ParameterError(
            f"{text[:80]!r}… has {len(text)} characters, or a NUL, and is no model; give a "
            "name or a folder"
        )
    if text in _LOADED and text in shipped():  # its files do not change
        return _LOADED[text]
    if text in shipped():
        folder, where = _shipped_folder() / text, text
    elif os.path.isdir(text):
        folder = Path(text).resolve()
        where = str(folder)
    elif text.endswith(".py") and os.path.isfile(text):
        folder = Path(text).with_suffix("")
        raise ParameterError(
            f"{text} is a model page: spragsym derive {text} --out {folder} writes its "
            "folder; name that"
        )
    else:
        names = shipped()
        raise ParameterError(
            f"{text!r} is neither a shipped model nor a folder that spragsym derive PAGE.py "
            "--out DIR wrote"
            f"{hint(text, names) or '; the models are ' + ', '.join(names)}"
        )
    with _LOCK:
        if where in shipped():
            about, files = _about(text), dict[str, bytes]()
        else:
            about, files = _verified(folder)
        known_model = _LOADED.get(where)
        if known_model is None or known_model.about != about:
            _LOADED[where] = _loaded(where, about, files)
        return _LOADED[where]


def require_trust(name: str, code: str | os.PathLike[str], trust: bool | str) -> None:
    """Raise if a file names code, a model page or the folder of a model, that may not run.

    ``trust`` is True if it may, or the name of the only code that may.

    Raises
    ------
    ParameterError
        With what says that it may.
    """
    if trust is True or trust == name or not os.path.exists(code):
        return
    kind = "folder" if os.path.isdir(code) else "file"
    raise ParameterError(
        f"{name!r} is a {kind}, whose code runs; if you trust it, give --trust or --model "
        f"{shlex.quote(os.fspath(code))}, in Python trust=True"
    )


def _verified(folder: Path) -> tuple[dict[str, Any], dict[str, bytes]]:
    """Content of ``model.json``, and the bytes of all files that it names, with verified
    digests.
    """
    path = folder / "model.json"
    if not path.is_file():
        raise ParameterError(
            f"{folder} holds no model.json; give a folder that `spragsym derive PAGE.py --out "
            "DIR` wrote"
        )
    data = contents(path, _LARGEST)
    # The digest is that of model.json with a placeholder at its own place; the digests of all other
    # files are part of the content.
    digest = re.search(rb'"digest": "([0-9a-f]{64})"', data)
    placeholder = b"<digest-of-all>".ljust(64, b"-")
    if (
        digest is None
        or hashlib.sha256(data.replace(digest[1], placeholder)).hexdigest().encode() != digest[1]
    ):
        raise StoreError(
            f"{path} is damaged: it is not as it was written; derive its model page again"
        )
    try:
        about = printed(str(path), json_of(data), allowed="\n")
    except ParameterError:
        raise
    except ValueError as error:
        raise StoreError(f"{path} is no JSON ({error}); derive its model page again") from error
    current = [_about(name) for name in shipped()]
    missing = sorted(set.intersection(*map(set, current)) - {*about} if type(about) is dict else ())
    if missing or not _is_alike(about, [*current, _with_all(current[0])]):
        parts = f", and does not say {', '.join(missing)}" * bool(missing)
        raise StoreError(
            f"{path} is of another version of spragsym{parts}; derive its model page again"
        )
    if (
        not re.fullmatch(r"\w[\w .-]*", about["name"])
        or not {*NEEDED} <= {*about["files"]}
        or any(Path(name).name != name for name in about["files"])
    ):
        raise StoreError(
            f"{path} names a model or a file that is none; derive its model page again"
        )
    files = {}
    for name, digest_of_file in about["files"].items():
        if not (folder / name).is_file():
            raise StoreError(f"{folder / name} is missing; derive its model page again")
        files[name] = contents(folder / name, _LARGEST)
        if hashlib.sha256(files[name]).hexdigest() != digest_of_file:
            raise StoreError(
                f"{folder / name} is not as it was written; derive its model page again"
            )
    return about, files


def _with_all(about: Mapping[str, Any]) -> Mapping[str, Any]:
    """A model with what no shipped one has: an open end of a range, and coordinates that come
    around together with any others.
    """
    parameter, coordinate = about["parameters"][0], about["coordinates"][0]
    together = [{**coordinate, "comes_around": others} for others in ({}, {"any": 1})]
    return {**about, "parameters": [{**parameter, "low": None}], "coordinates": together}


def _is_alike(held: object, examples: Sequence[Any]) -> bool:
    """Whether data have the structure of examples.

    They are of a kind that an example is. A table has the keys that all tables of examples have,
    and under each key, as in each place of a list, what is alike to something that stands there in
    an example; under a key that is in none, to something under any. Lists that are empty in all
    examples may hold anything.
    """
    same = [one for one in examples if _kind(one) is _kind(held)]
    if not same or not isinstance(held, dict | list):
        return bool(same)
    if isinstance(held, list):
        parts = list(chain.from_iterable(same))
        return not parts or all(_is_alike(part, parts) for part in held)
    under_any = list(chain.from_iterable(one.values() for one in same))
    return set.intersection(*map(set, same)) <= {*held} and all(
        _is_alike(part, [one[key] for one in same if key in one] or under_any)
        for key, part in held.items()
    )


def _kind(value: object) -> type:
    """The type of a value; integers are numbers as floats are."""
    return float if type(value) is int else type(value)


def _loaded(where: str, about: Mapping[str, Any], files: Mapping[str, bytes]) -> Model:
    """A model with its class of parameters and, for a shipped model with a room of its own, its
    closed forms.
    """
    module = partial(_module, where, files)
    room = f"{__package__.rpartition('.')[0]}.{where}"
    if not files and importlib.util.find_spec(room):  # a shipped model with closed forms
        own = importlib.import_module(room)
        kind = getattr(own, "Parameters", None) or parameter_class(about, where)
        model = Model(where, about, module, kind, own.CLOSED_FORMS)
    else:
        model = Model(where, about, module, parameter_class(about, where))
    model.Parameters._model = model
    return model


def _module(where: str, files: Mapping[str, bytes]) -> ModuleType:
    """The module of generated functions: part of the package, or compiled from verified bytes."""
    if not files:
        return importlib.import_module(f"spragsym.generated.models.{where}.algebra")
    # A path may hold bytes that are no text in the locale.
    content = b"\0".join([os.fsencode(where), *(files[name] for name in sorted(files))])
    package = f"spragsym_model_{hashlib.sha256(content).hexdigest()[:16]}"
    for name in ("", *(file.removesuffix(".py") for file in NEEDED)):
        whole = f"{package}.{name}".rstrip(".")
        if whole in sys.modules:
            continue
        module = sys.modules[whole] = ModuleType(whole)
        module.__package__ = package
        if not name:
            module.__path__ = []
            continue
        module.__file__ = os.path.join(where, f"{name}.py")
        try:
            code = compile(files[f"{name}.py"], module.__file__, "exec")
            exec(code, module.__dict__)  # noqa: S102  # a model's folder is code
        except BaseException as error:
            del sys.modules[whole]
            if not isinstance(error, Exception):
                raise
            raise StoreError(
                f"{module.__file__} does not run ({error!r:.80}); derive its model page again"
            ) from error
    return sys.modules[f"{package}.algebra"]
