"""Files of results: units, provenance, and a checksum, whole or not there at all.

Every file, netCDF or CSV, ends in a line with the SHA-256 of all bytes before it. HDF5 ignores that line, because its superblock
says where the data end. The checksum is verified before anything else is read: HDF5 accepts many damaged files, and crashes the
process on others.
"""

import csv
import hashlib
import io
import json
import os
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from enum import IntEnum
from pathlib import Path
from typing import Any

import numpy as np

from .._version import __version__
from ..errors import DamagedError, MissingExtraError, ParameterError, StoreError, TargetError
from ..generated import SOURCE_HASH
from ..interrupts import held
from .writing import probe, put, resolved


def xarray() -> Any:
    """The module, or an error that names the extra."""
    try:
        with held():
            import h5netcdf  # noqa: F401  # here only to be missed early
            import h5py  # noqa: F401  # here only to be missed early
            import xarray
    except ModuleNotFoundError as error:
        raise MissingExtraError("a netCDF file", error.name or "xarray", "sweep") from error
    return xarray


def dataset(
    data: Mapping[str, Any], coords: Mapping[str, Any], attributes: Mapping[str, Any], explained: Mapping[str, tuple[str, str]],
    codes: Mapping[str, type[IntEnum]],
) -> Any:  # fmt: skip
    """An ``xarray.Dataset``, with unit and meaning of every quantity, and the words of ``codes``."""
    made = xarray().Dataset(data, coords=coords, attrs=attributes)
    for name in made.variables:
        made[name].attrs = dict(zip(("units", "long_name"), explained[name], strict=True))
    for name, kinds in codes.items():
        words = " ".join(kind.name.lower() for kind in kinds)
        made[name].attrs |= {"flag_values": np.array(list(kinds), dtype=np.int8), "flag_meanings": words}
    return made


def provenance() -> dict[str, str]:
    """What produced a file: the version and the hash of the derivation behind the generated code."""
    return {"source": f"spragsym {__version__}", "generated_from": SOURCE_HASH}


def fingerprint(arrays: Mapping[str, Any], settings: Mapping[str, Any]) -> str:
    """SHA-256 of everything that a result depends on."""
    digest = hashlib.sha256(json.dumps({**settings, **provenance()}, sort_keys=True).encode())
    for name, values in arrays.items():
        array = np.ascontiguousarray(values, dtype="<f8")
        digest.update(f"{name}{array.shape}".encode() + array.tobytes())
    return digest.hexdigest()


# ----------------------------------------------------------------------------------------------- before the work

#: Whether a file that is there is computed anew.
OVERWRITING: ContextVar[bool] = ContextVar("overwriting", default=False)


@contextmanager
def overwriting(asked: bool = True) -> Iterator[None]:
    """Within, a file that is there is computed anew; it stays as it is until the new one takes its place."""
    token = OVERWRITING.set(asked)
    try:
        yield
    finally:
        OVERWRITING.reset(token)


def check_target(path: str | os.PathLike[str], bytes_needed: int) -> Path:
    """Where a path leads; raise, before any work, if a file can't be written there."""
    target = resolved(path)
    if target.suffix not in (".nc", ".csv"):
        raise ParameterError(f"{target} ends neither in .nc nor in .csv; the ending says which file is meant")
    if target.suffix == ".nc":
        xarray()
    return probe(target, bytes_needed)


# ----------------------------------------------------------------------------------------------------- to write


def write(
    path: Path,
    dataset: Callable[[], Any],
    columns: Callable[[], Mapping[str, Any]],
    attrs: Mapping[str, Any],
    explained: Mapping[str, tuple[str, str]],
) -> None:
    """Write netCDF or CSV, by the ending, whole or not at all. Equal data give equal bytes.

    ``explained`` has unit and meaning of every column.
    """
    path = check_target(path, 0)
    # In memory first: HDF5 ends the process when a disk fills while it writes.
    if path.suffix == ".nc":
        put(path, _sealed(bytes(dataset().to_netcdf(engine="h5netcdf")) + b"\n"))
    else:
        put(path, _csv(columns(), attrs, explained))


def _csv(columns: Mapping[str, Any], attrs: Mapping[str, Any], explained: Mapping[str, tuple[str, str]]) -> bytes:
    """Names of the columns, then attributes and units in comment lines, then the numbers to the last digit.

    The names come first because NumPy takes them from the first line, comment or not.
    """
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    text.writelines(f"# {name}: {value}\n" for name, value in attrs.items())
    text.writelines(f"# {name} [{explained[name][0]}]: {explained[name][1]}\n" for name in columns)
    writer.writerows(zip(*(np.ravel(values).tolist() for values in columns.values()), strict=True))
    return _sealed(text.getvalue().encode())


def _sealed(data: bytes) -> bytes:
    """The content, followed by a last line with its checksum."""
    return data + _TRAILER % _sha256(data)


def plain(text: str) -> str:
    """Text that is one cell to every reader of CSV, NumPy too, which knows no quotes: no comma, quote, # or line end."""
    return " ".join(text.replace(",", ";").replace('"', "'").replace("#", "no. ").split())


def write_text(path: Path, text: str) -> None:
    """Write lines of text with the checksum after them, whole or not at all."""
    put(path, _sealed(text.encode()))


# ------------------------------------------------------------------------------------------------------ to read

#: The last line of a file.
_TRAILER = b"# sha256: %b\n"
_TRAILED = re.compile(rb"(.*\n)# sha256: ([0-9a-f]{64})\n", re.DOTALL)


def read(path: Path) -> tuple[dict[str, Any], dict[str, Any]]:
    """Columns, flat, and attributes of a file that :func:`write` wrote; a StoreError if a bit of it has changed."""
    content = _verified(path)
    if path.suffix != ".nc":
        return _read_csv(content)
    with xarray().open_dataset(io.BytesIO(content), engine="h5netcdf") as dataset:
        return {name: dataset[name].values.ravel() for name in dataset.variables}, dict(dataset.attrs)


def read_own(path: Path, key: str) -> dict[str, Any]:
    """Columns of the file that a call of this fingerprint wrote; a TargetError for any other one."""
    columns, attributes = read(path)
    if attributes.get("fingerprint") != key:
        raise TargetError(f"{path} exists and holds something else, or was made by other code; remove it, or give another path")
    return columns


def read_text(path: Path) -> str:
    """What :func:`write_text` wrote; errors as of :func:`read`."""
    return _verified(path).decode()


def _verified(path: Path) -> bytes:
    """The part of a file that its checksum covers."""
    try:
        data = resolved(path).read_bytes()
    except OSError as error:
        raise StoreError(f"{path} cannot be read: {error.strerror}; give another path") from error
    parts = _TRAILED.fullmatch(data)
    if parts is None:
        raise DamagedError(
            f"{path} has no checksum at its end: it was cut, changed, or written by something else; "
            "remove it to compute it again, or give another path"
        )
    if _sha256(parts[1]) != parts[2]:
        raise DamagedError(
            f"{path} is damaged or was changed: its {len(data)} bytes do not give its checksum; "
            "take it from a copy, or remove it to compute it again"
        )
    return parts[1]


def _read_csv(data: bytes) -> tuple[dict[str, Any], dict[str, Any]]:
    lines = data.decode().splitlines(keepends=True)
    comments, table = ([line for line in lines if line.startswith("#") == comment] for comment in (True, False))
    attrs = dict(line[2:].rstrip("\n").split(": ", 1) for line in comments)
    header, *rows = csv.reader(table)
    columns = dict(zip(header, zip(*rows, strict=True) if rows else [()] * len(header), strict=True))
    return {name: np.array(values) for name, values in columns.items()}, attrs


def _sha256(data: bytes) -> bytes:
    return hashlib.sha256(data).hexdigest().encode()
