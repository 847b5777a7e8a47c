"""Files of columns, netCDF or CSV, with units, provenance and a checksum, written atomically.

Every file ends in a line with the SHA-256 of all bytes before it. HDF5 ignores that line, because
its superblock says where the data end. The checksum is verified before anything else is read: HDF5
accepts many damaged files, and crashes the process on others.

A file is written to a temporary one in the same folder, flushed to the disk and renamed. If a full
disk or a kill ends the write, the former file stays. Temporary files that a killed process left,
``.spragsym-*``, are removed by a later write to the same folder, after an hour.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import math
import os
import secrets
import shutil
import stat
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from io import FileIO
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from .._version import __version__
from ..core.errors import DamagedError, MissingExtraError, ParameterError, StoreError, TargetError
from ..core.interrupts import held
from ..display import Column
from ..generated import SOURCE_HASH
from .text import FilePath, contents, path_text, printed

if TYPE_CHECKING:
    from xarray import Dataset

#: Columns by name; their dimensions are the units in the file.
Columns: TypeAlias = Mapping[str, Column]


def xarray() -> ModuleType:
    """The module xarray.

    Raises
    ------
    MissingExtraError
        Without xarray, h5netcdf or h5py.
    """
    try:
        with held():
            import h5netcdf  # noqa: F401  # imported to notice early that it is missing
            import h5py  # noqa: F401
            import xarray
    except ModuleNotFoundError as error:
        raise MissingExtraError("a netCDF file", error.name or "xarray", "sweep") from error
    return xarray


def dataset(
    data: Mapping[str, tuple[Any, Any]],
    coords: Mapping[str, Any],
    attributes: Mapping[str, Any],
    columns: Columns,
) -> Dataset:
    """An ``xarray.Dataset`` with the unit, the meaning and the codes of every column.

    ``data`` and ``coords`` have axes and values by name.
    """
    variables = {
        name: (dims, values.astype(object) if values.dtype.kind == "U" else values)
        for name, (dims, values) in data.items()
    }
    # netCDF has no truth values.
    attrs = {
        name: int(value) if isinstance(value, bool) else value for name, value in attributes.items()
    }
    made = xarray().Dataset(variables, coords=coords, attrs=attrs)
    for name in made.variables:
        column = columns.get(name, Column(name, ""))
        described = {"units": column.dimension, "long_name": column.meaning}
        made[name].attrs = {key: text for key, text in described.items() if text}
        if column.codes is not None:
            made[name].attrs |= {
                "flag_values": np.array(list(column.codes), dtype=np.int8),
                "flag_meanings": " ".join(kind.name.lower() for kind in column.codes),
            }
    return made


def provenance() -> dict[str, str]:
    """The version of this package and the hash of the generated code, for a file."""
    return {"source": f"spragsym {__version__}", "generated_from": SOURCE_HASH}


def fingerprint(arrays: Mapping[str, Any], settings: Mapping[str, Any]) -> str:
    """SHA-256 of everything that a result depends on: settings, generated files and numbers."""
    decides = {**settings, "generated_from": SOURCE_HASH}
    digest = hashlib.sha256(json.dumps(decides, sort_keys=True).encode())
    for name, values in arrays.items():
        array = np.ascontiguousarray(values, dtype="<f8")
        digest.update(f"{name}{array.shape}".encode() + array.tobytes())
    return digest.hexdigest()


# -----------------------------------------------------------------------------------------------
# before the work

#: Whether an existing file is replaced; it stays until the new one is written.
OVERWRITING: ContextVar[bool] = ContextVar("overwriting", default=False)


def check_target(path: FilePath, bytes_needed: int) -> Path:
    """The file of a path, before any work; an error if it can't be written."""
    target = resolved(path)
    if target.suffix not in (".nc", ".csv"):
        raise ParameterError(
            f"{target} ends neither in .nc nor in .csv; the ending says which file is meant"
        )
    if target.suffix == ".nc":
        xarray()
    return probe(target, bytes_needed)


# ------------------------------------------------------------------------------------------------
# to write


def write(
    path: Path,
    dataset: Callable[[], Any],
    columns: Mapping[str, Any],
    attrs: Mapping[str, Any],
    described: Columns,
) -> None:
    """Write netCDF or CSV, by the ending, whole or not at all. Equal data give equal bytes.

    ``described`` says what columns are.
    """
    path = check_target(path, 0)
    # In memory first: HDF5 ends the process when a disk fills while it writes.
    if path.suffix == ".nc":
        put(path, sealed(_netcdf(dataset()) + b"\n"))
    else:
        put(path, _csv(columns, attrs, described))


def _netcdf(data: Dataset) -> bytes:
    """The bytes of a dataset as netCDF.

    A lock is given, because ``to_netcdf`` would ask the scheduler of an open dask client for one,
    which does not know it.
    """
    buffer = io.BytesIO()
    open_store = xarray().backends.H5NetCDFStore.open
    store = open_store(buffer, mode="w", format="NETCDF4", lock=threading.Lock())
    data.dump_to_store(store)
    store.close()
    return buffer.getvalue()


def _csv(columns: Mapping[str, Any], attrs: Mapping[str, Any], described: Columns) -> bytes:
    """The bytes of a CSV file: column names, comment lines with attributes and units, numbers.

    The names come first, because NumPy takes them from the first line.
    """
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    text.writelines(f"# {name}: {value}\n" for name, value in attrs.items())
    described_columns = [described.get(name, Column(name, "")) for name in columns]
    text.writelines(
        f"# {each.name} [{each.dimension}]: {each.meaning}\n" for each in described_columns
    )
    writer.writerows(zip(*(np.ravel(values).tolist() for values in columns.values()), strict=True))
    return sealed(text.getvalue().encode())


def sealed(data: bytes) -> bytes:
    """The content, followed by a last line with its checksum."""
    return data + _TRAILER + hashlib.sha256(data).hexdigest().encode() + b"\n"


def plain(text: str) -> str:
    """Text without commas, quotes, # and line ends, so that it is one cell of a CSV file for every
    reader; NumPy knows no quotes.
    """
    return " ".join(text.replace(",", ";").replace('"', "'").replace("#", "no. ").split())


# ------------------------------------------------------------------------------------------------
# to read

#: The beginning of the last line, before the checksum.
_TRAILER = b"# sha256: "


def read(path: Path) -> tuple[dict[str, Any], dict[str, Any]]:
    """The columns, flat, and the attributes of a file that :func:`write` wrote.

    Raises
    ------
    StoreError
        If it can't be read or has changed.
    """
    content = verified(path)
    if path.suffix != ".nc":
        text = printed(str(path), content.decode(errors="replace"), allowed="\n")
        with _as_written(path):
            columns, attributes = _read_csv(text)
    else:
        netcdf = xarray()
        with (
            _as_written(path),
            netcdf.open_dataset(io.BytesIO(content), engine="h5netcdf") as dataset,
        ):
            columns = {name: dataset[name].values.ravel() for name in dataset.variables}
            attributes = dict(dataset.attrs)
    for name, values in columns.items():
        printed(str(path), [name, *(values.tolist() if values.dtype.kind in "OU" else ())])
    return columns, printed(str(path), attributes)


def read_own(path: Path, key: str) -> dict[str, Any]:
    """The columns of a file that was written with this fingerprint.

    Raises
    ------
    TargetError
        If it was written with another fingerprint.
    """
    columns, attributes = read(path)
    if attributes.get("fingerprint") != key:
        model = attributes.get("model", "some model")
        source = attributes.get("source", "another program")
        raise TargetError(
            f"{path} exists, a result of {model} by {source}, for other parameters or "
            "settings or of other code; remove it, "
            "or give another path"
        )
    return columns


@contextmanager
def _as_written(path: Path) -> Iterator[None]:
    """Context that refuses content of another structure than that of :func:`write`."""
    try:
        yield
    except (ValueError, LookupError, TypeError, AttributeError, OSError, csv.Error) as error:
        raise DamagedError(
            f"{path} holds no columns as they are written ({error!r:.60}); remove it to compute "
            "it again, or give another path"
        ) from error


def verified(path: Path) -> bytes:
    """The content of a file without its checksum, which is verified.

    Raises
    ------
    StoreError
        If it can't be read; DamagedError if the checksum is missing or wrong.
    """
    largest = 1 << 32  # bytes
    try:
        data = contents(resolved(path), largest, "another path")
    except ParameterError as error:
        raise StoreError(str(error)) from error
    covered, mark, _ = data.rpartition(_TRAILER)
    if not mark:
        raise DamagedError(
            f"{path} has no checksum at its end: it was cut, changed, or written by something "
            "else; "
            "remove it to compute it again, or give another path"
        )
    if data != sealed(covered):
        raise DamagedError(
            f"{path} is damaged or was changed: its {len(data)} bytes do not give its checksum; "
            "take it from a copy, or remove it to compute it again"
        )
    return covered


def _read_csv(text: str) -> tuple[dict[str, Any], dict[str, Any]]:
    """Columns and attributes of a CSV file."""
    lines = text.splitlines(keepends=True)
    comments = [line for line in lines if line.startswith("#")]
    table = [line for line in lines if not line.startswith("#")]
    attrs = dict(line[2:].rstrip("\n").split(": ", 1) for line in comments)
    header, *rows = csv.reader(table)
    return {name: np.array([row[i] for row in rows]) for i, name in enumerate(header)}, attrs


# ------------------------------------------------------------------------------------------------
# atomic writing


def resolved(path: FilePath) -> Path:
    """The file that a path leads to through links, even if it does not exist yet.

    Raises
    ------
    ParameterError
        If the path leads nowhere, or to a device or a pipe.
    """
    try:
        target = Path(path_text(path)).resolve()
        if target.is_symlink():
            target.stat()  # raises what Python from 3.13 on no longer says when it resolves
        if target.exists() and not target.is_file() and not target.is_dir():
            raise ParameterError(f"{path} is a device or a pipe; give the name of a file")
    except (OSError, RuntimeError, ValueError) as error:
        # A circular link, a name that is too long, or a NUL in it.
        reason = getattr(error, "strerror", None) or error
        raise ParameterError(
            f"{os.fspath(path)[:200]!r} leads nowhere ({reason}); give another path"
        ) from error
    return target


def probe(path: FilePath, bytes_needed: int = 0, *, made: bool = False) -> Path:
    """The file of a path, checked before any work by writing a temporary file.

    ``made`` says that missing folders will be made: then the nearest existing one is tried.

    Raises
    ------
    ParameterError
        If no file of that size can be written there.
    """
    target = resolved(path)
    folder = target.parent
    while made and not folder.exists() and folder != folder.parent:
        folder = folder.parent
    if target.is_dir() or not folder.is_dir():
        problem = "is a folder" if target.is_dir() else "lies in a folder that does not exist"
        raise ParameterError(f"{target} {problem}; give the name of a file in an existing folder")
    try:
        os.close(new_file(trial := _beside(folder)))
        trial.unlink()
        free = shutil.disk_usage(folder).free
    except OSError as error:
        raise ParameterError(
            f"{target} cannot be written ({error.strerror}); give another path, or the right "
            "to write there"
        ) from error
    if free < bytes_needed:
        raise ParameterError(
            f"{target}: about {math.ceil(bytes_needed / 1e3)} kB are needed and "
            f"{math.floor(free / 1e3)} kB are free; make room, or write to another disk"
        )
    return target


def put(path: FilePath, data: bytes | str, *, made: bool = False, private: bool = False) -> None:
    """Write a file atomically; a former file is replaced and its mode kept.

    ``made`` says that missing folders are made, ``private`` that only this user may read the file.

    Raises
    ------
    StoreError
        If it can't be written.
    """
    target = resolved(path)
    new = [folder for folder in target.parents if not folder.exists()] if made else []
    try:
        if made:
            target.parent.mkdir(parents=True, exist_ok=True)
        _remove_left(target.parent)
        _replace(target, data.encode() if isinstance(data, str) else data, private)
        _settle(target.parent)
    except OSError as error:
        for folder in new:  # empty ones that were made for it, from the innermost on
            with suppress(OSError):
                folder.rmdir()
        cure = "make room, or give another path"
        # On Windows also while a spreadsheet shows the file that was there.
        if isinstance(error, PermissionError):
            cure = "close what has it open, or give a path where you may write"
        raise StoreError(f"{target} cannot be written: {error.strerror}; {cure}") from error


def _replace(target: Path, data: bytes, private: bool) -> None:
    """Write data to a temporary file, flush it to the disk and rename it to the target."""
    temporary = _beside(target.parent)
    number = new_file(temporary, 0o600 if private else 0o666)
    try:
        with open(number, "wb", buffering=0) as file:
            write_all(file, data)
            with suppress(OSError):
                os.chmod(temporary, stat.S_IMODE(target.stat().st_mode))
            os.fsync(number)
        os.replace(temporary, target)
    except BaseException:
        with suppress(OSError):
            temporary.unlink()
        raise


def write_all(file: FileIO, data: bytes) -> None:
    """Write all data: an almost full disk accepts a part, and fails only at the next write."""
    view = memoryview(data)
    while view:
        view = view[file.write(view) :]


def _beside(folder: Path) -> Path:
    """A new name for a temporary file in a folder."""
    return folder / f".spragsym-{os.getpid()}-{secrets.token_hex(8)}"


def new_file(path: Path, mode: int = 0o666) -> int:
    """The descriptor of a new file; an error if the name exists, even as a link to nothing."""
    return os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), mode)


def _remove_left(folder: Path) -> None:
    """Remove temporary files of killed writes from a folder: those older than an hour."""
    old = time.time() - 3600.0
    with suppress(OSError):
        for path in folder.glob(".spragsym-*-" + 16 * "[0-9a-f]"):
            if path.lstat().st_mtime < old:
                path.unlink()


def _settle(folder: Path) -> None:
    """Flush a folder to the disk, so that a new name in it survives a power cut, where possible."""
    with suppress(OSError):
        number = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(number)
        finally:
            os.close(number)
