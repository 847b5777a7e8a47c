"""Files of results: JSON with all data of a result, which is read back bit for bit.

Reading runs no code of the file and loads no folder: only data classes of this package are made,
from their fields. A digest detects damage.
"""

from __future__ import annotations

import base64
import dataclasses
import enum
import hashlib
import importlib
import json
import os
from collections.abc import Callable, Mapping
from dataclasses import MISSING, fields, is_dataclass
from functools import partial
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
from numpy.typing import NDArray

from .._version import __version__
from ..core.errors import ParameterError
from ..files.storage import put
from ..files.text import FilePath, json_of, path_text, printed, text_of
from ..models import Model
from ..models.field import Field
from ..models.load import load, shipped
from ..models.parameters import ParameterSet, set_of
from .result import Result

#: Version of the format, to be raised if older files have to be converted by :func:`_read`. Files
#: without a version are of the first one.
FORMAT = 1
#: Present module and name of classes that older files name otherwise.
MOVED: Mapping[tuple[str, str], tuple[str, str]] = {
    ("spragsym.report.brake_files", "FrictionFit"): ("spragsym.report.friction_fit", "FrictionFit"),
    ("spragsym.models.quantities", "PhysicalParameters"): (
        "spragsym.kang_nam.parameters",
        "PhysicalParameters",
    ),
    ("spragsym.motion.shooting", "Guess"): ("spragsym.motion.shooting", "Iterate"),
    ("spragsym.motion.shooting", "Loop"): ("spragsym.motion.shooting", "Orbit"),
    ("spragsym.motion.solution", "Passage"): ("spragsym.motion.solution", "FlowResult"),
    ("spragsym.motion.solution", "Turn"): ("spragsym.motion.solution", "Extremum"),
    ("spragsym.orbits.arclength", "Point"): ("spragsym.orbits.arclength", "BranchPoint"),
    ("spragsym.orbits.events", "Finding"): ("spragsym.orbits.events", "DetectedEvent"),
}
#: Former names of fields by the present ones.
FORMER_FIELDS: Mapping[str, str] = {
    "orbit": "loop",
    "orbits": "loops",
    "flow_results": "passages",
    "extrema": "turns",
}


#: Endings of files that hold columns only, and the functions that read them.
_COLUMNS = {".csv": "pandas.read_csv", ".nc": "xarray.open_dataset"}


def save(result: Result, path: FilePath) -> None:
    """Write a result to ``*.json``, which :func:`open` reads, or its columns to ``*.csv``,
    ``*.nc``.

    Raises
    ------
    ParameterError
        For another ending.
    """
    ending = Path(path_text(path)).suffix
    if ending not in (".json", *_COLUMNS):
        raise ParameterError(
            f"{path_text(path)} ends in none of .json, .csv and .nc; the first holds the whole "
            "result, the others its columns"
        )
    if ending == ".json":
        body = _text(_written(result))
        head = f'"spragsym":"{__version__}","format":{FORMAT},"sha256":"{_digest(body)}"'
        put(path, f'{{{head},"result":{body}}}\n')
    else:
        result._save_columns(Path(path))


def open(path: str | os.PathLike[str], model: Model | None = None) -> Any:
    """Read a result from the file that its ``save`` wrote.

    Parameters
    ----------
    path : str or path-like
    model : Model, optional
        The model that the result is of, needed if it is none of the shipped ones: a file never
        loads a folder by itself.

    Raises
    ------
    ParameterError
        If the file can't be read, is damaged, holds no result of this version or an earlier one, or
        is of a model that is not known.

    Examples
    --------
    >>> import pathlib, tempfile, spragsym as ss
    >>> file = pathlib.Path(tempfile.mkdtemp(), "folds.json")
    >>> ss.folds(ss.Parameters.article()).save(file)
    >>> len(ss.open(file))
    2
    """
    name = path_text(path)
    if (reader := _COLUMNS.get(Path(name).suffix)) is not None:
        raise ParameterError(
            f"{name} holds columns alone; read them with {reader}, or give a *.json that save() "
            "wrote, which holds the whole result"
        )
    remedy = ", or give a *.json that save() wrote"
    largest = 2**30  # bytes
    text = text_of(path, largest, "a *.json that save() wrote", remedy)
    # Errors in reading a file that is not as save() writes it now.
    wrong = (
        ValueError,
        TypeError,
        LookupError,
        AttributeError,
        ImportError,
        ArithmeticError,
        RecursionError,
    )
    try:
        content = printed(name, json_of(text))
        version, body = content["spragsym"], _text(content["result"])
        is_sealed = content.get("format", 1) <= FORMAT and "sha256" in content
        if is_sealed and _digest(body) != content["sha256"]:
            raise ValueError("it is not as it was written")
    except ParameterError:
        raise
    except wrong as error:
        raise ParameterError(
            f"{name} holds no result of spragsym ({error!r:.80}); give a *.json that save() wrote"
        ) from error
    version_reason = f"this is {__version__}"
    if is_sealed:
        try:
            return json_of(body, partial(_read, model))
        except ParameterError:
            raise
        except wrong as error:
            version_reason = f"when results had other parts than now ({error!r:.80})"
    raise ParameterError(
        f"{name} was written by spragsym {version}, {version_reason}; compute it anew"
    )


def _text(body: object) -> str:
    return json.dumps(body, separators=(",", ":"))


def _digest(body: str) -> str:
    return hashlib.sha256(body.encode("ascii")).hexdigest()


def _array(thing: NDArray[Any]) -> list[Any]:
    array = np.ascontiguousarray(thing)
    if array.dtype.hasobject:
        raise ParameterError(
            f"{array.dtype} is no kind of numbers or words that a file holds; write its "
            "columns to *.csv"
        )
    return [array.dtype.str, list(np.shape(thing)), base64.b64encode(array.tobytes()).decode()]


def _array_of(kind: str, shape: list[int], data: str) -> NDArray[Any]:
    array = np.frombuffer(base64.b64decode(data), np.dtype(kind)).reshape(shape).copy()
    if array.dtype.kind == "U":
        printed("an array of words", array.ravel().tolist())
    return array


#: Kinds of numbers: their types in Python, how they are written, and how they are read.
_NUMBERS: dict[str, tuple[Any, Callable[[Any], Any], Callable[[Any], Any]]] = {
    "float": (float, float.hex, float.fromhex),
    "array": (
        np.ndarray | np.generic,
        _array,
        lambda held: _array_of(*held),
    ),
    "mpf": (
        mpmath.mpf,
        lambda number: [*map(int, number._mpf_)],
        lambda held: mpmath.make_mpf(tuple(held)),
    ),
    "mpc": (
        mpmath.mpc,
        lambda number: [[*map(int, part)] for part in number._mpc_],
        lambda held: mpmath.make_mpc(tuple(map(tuple, held))),
    ),
}


def _written(thing: object) -> object:
    """An object as JSON data: what JSON has not is a mapping from its kind to its parts."""
    match thing:
        case None | bool() | str():
            return thing
        case enum.Enum():
            return {"enum": [*_place(type(thing)), _written(thing.value)]}
        case int():
            return int(thing)
        case Mapping():
            return {"dict": [[_written(key), _written(value)] for key, value in thing.items()]}
        case Model():
            return {"model": [thing.where, thing is thing.search]}
        case ParameterSet():
            values = {name: thing[name] for name in thing.ranges}
            return {
                "parameters": [_written(part) for part in (thing.model, values, thing.followed)]
            }
        case Field():
            return {"field": thing.where}
        case tuple() | list() if not hasattr(thing, "_fields"):
            return {type(thing).__name__: [_written(part) for part in thing]}
    for kind, (numbers, write, _) in _NUMBERS.items():
        if isinstance(thing, numbers):
            return {kind: write(thing)}
    whole: Any = thing._for_file() if isinstance(thing, Result) else thing
    names = getattr(thing, "_fields", None) or [each.name for each in fields(whole)]
    return {
        "class": [*_place(type(thing)), _written({name: getattr(whole, name) for name in names})]
    }


def _place(kind: type) -> tuple[str, str]:
    return kind.__module__, kind.__qualname__


def _read(model_of_user: Model | None, entry: dict[str, Any]) -> object:
    """The object of a mapping from :func:`_written`, whose parts are already read.

    Raises
    ------
    ParameterError
        If it is of a model that is neither shipped nor the one that the user gave.
    """
    ((kind, value),) = entry.items()

    def model(where: str) -> Model:
        if model_of_user is not None and model_of_user.where == where:
            return model_of_user
        if where not in shipped():
            raise ParameterError(
                f"model: the result is of {where}, which is no shipped model; give "
                "model=spragsym.load(...)"
            )
        return load(where)

    if kind in _NUMBERS:
        return _NUMBERS[kind][2](value)
    match kind:
        case "tuple":
            return tuple(value)
        case "list":
            return value
        case "dict":
            return dict(value)
        case "model":
            return model(value[0]).search if value[1] else model(value[0])
        case "field":
            return model(value).field
        case "parameters":
            return set_of(*value)
    *names, parts = value
    kind_class = _class(*names)
    if kind == "enum":
        return kind_class(parts)
    if hasattr(kind_class, "_fields"):
        return kind_class(**parts)
    out = object.__new__(kind_class)
    out.__dict__.update({each.name: _part(each, parts) for each in fields(kind_class)})
    return out


def _part(field: dataclasses.Field[Any], parts: Mapping[str, Any]) -> object:
    """The value of a field in a file; the default of a field that is newer than the file."""
    for name in (field.name, FORMER_FIELDS.get(field.name, field.name)):
        if name in parts:
            return parts[name]
    if field.default_factory is not MISSING:
        return field.default_factory()
    if field.default is MISSING:
        raise LookupError(field.name)
    return field.default


def _class(module: str, name: str) -> type[Any]:
    """A data class, named tuple or enumeration of this package, by module and name.

    Raises
    ------
    ValueError
        For anything else.
    """
    module, name = MOVED.get((module, name), (module, name))
    package, *inner = module.split(".")
    # The derivation, and modules that run as commands when they are imported, have no results.
    ours = package == __package__.partition(".")[0] and not {"derive", "__main__"} & {*inner}
    found = getattr(importlib.import_module(module), name) if ours else None
    if not isinstance(found, type) or not (
        is_dataclass(found) or issubclass(found, enum.Enum) or hasattr(found, "_fields")
    ):
        raise ValueError(f"{module}.{name} is no class of results")
    return found
