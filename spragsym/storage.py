"""Files: datasets with units and provenance, and the journal that a long sweep writes as it goes."""

from __future__ import annotations

import csv
import hashlib
import json
import math
import os
import shutil
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO, Any

import numpy as np

from ._version import __version__
from .errors import MissingExtraError, ParameterError
from .generated import SOURCE_HASH

#: (unit, meaning) of every quantity that a file can hold.
QUANTITIES = {
    "theta0": ("rad", "inclination of the undeformed spring"),
    "theta0_deg": ("degree", "the same in degrees"),
    "mu0": ("1", "friction coefficient at full slip"),
    "kappa": ("1", "preload F_L / (k_c L_0)"),
    "alpha": ("1", "stiffness ratio k_x / k_c"),
    "sigma": ("1", "stiffness ratio k / k_c"),
    "beta": ("1", "stiffness ratio k_y / k_c"),
    "V": ("L_0 sqrt(k_c/m)", "belt speed"),
    "d": ("1/(L_0 sqrt(k_c/m))", "steepness of the friction law in creep"),
    "x0": ("L_0", "initial displacement along the belt"),
    "y0": ("L_0", "initial displacement across the belt"),
    "vx0": ("L_0 sqrt(k_c/m)", "initial speed along the belt"),
    "vy0": ("L_0 sqrt(k_c/m)", "initial speed across the belt"),
    "t": ("sqrt(m/k_c)", "time"),
    "x": ("L_0", "displacement along the belt"),
    "y": ("L_0", "displacement across the belt, negative into the belt"),
    "vx": ("L_0 sqrt(k_c/m)", "speed along the belt"),
    "vy": ("L_0 sqrt(k_c/m)", "speed across the belt"),
    "error": ("1", "largest difference of x, y, x', y' to a run at a tighter tolerance"),
    "rms": ("L_0", "root mean square of x about zero, after the transient"),
    "spread": ("L_0", "root mean square of x about its mean, after the transient"),
    "amplitude": ("L_0", "largest |x| after the transient"),
    "mean": ("L_0", "mean of x after the transient"),
    "mean_y": ("L_0", "mean of y after the transient"),
    "period": ("sqrt(m/k_c)", "period of the cycle that the motion is on or approaches; NaN for none"),
    "rate": ("sqrt(k_c/m)", "rate at which what the motion settles to or approaches attracts"),
    "distance": ("1", "what is left of the way there: of the reach of a cycle, over L_0 for rest"),
    "cycle_mean": ("L_0", "mean of x over one period of the cycle"),
    "cycle_rms": ("L_0", "root mean square of x about zero over one period of the cycle"),
    "cycle_x": ("L_0", "largest x of the cycle"),
    "cycle_y": ("L_0", "y of the cycle where its x is largest"),
    "cycle_vy": ("L_0 sqrt(k_c/m)", "speed across the belt of the cycle where its x is largest"),
    "contact_lost": ("1", "times contact was lost after the transient"),
    "slip_reversed": ("1", "times x' passed V after the transient"),
    "regime": ("1", "what the motion settles to or approaches"),
    "equilibrium": ("1", "index of the equilibrium that it settles to or approaches; -1 for none"),
    "reason": ("1", "why a point has no result"),
    "event_t": ("sqrt(m/k_c)", "time of an event"),
    "event": ("1", "what happened"),
}


def xarray() -> Any:
    """The module, or an error that names the extra."""
    try:
        import h5netcdf  # noqa: F401
        import h5py  # noqa: F401
        import xarray
    except ModuleNotFoundError as error:
        raise MissingExtraError("a netCDF file", error.name or "xarray", "sweep") from error
    return xarray


def attributes(name: str) -> dict[str, str]:
    """Unit and meaning of a quantity."""
    unit, meaning = QUANTITIES[name]
    return {"units": unit, "long_name": meaning}


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


# ----------------------------------------------------------------------------------------------- whole files


def check_target(path: Path, bytes_needed: int) -> None:
    """Raise, before any work, if a file cannot be written there."""
    if path.suffix not in (".nc", ".csv"):
        raise ParameterError(f"{path} ends neither in .nc nor in .csv; the ending says which file is meant")
    if path.is_dir() or not path.parent.is_dir():
        problem = "is a folder" if path.is_dir() else "lies in a folder that does not exist"
        raise ParameterError(f"{path} {problem}; give the name of a file in an existing folder")
    if path.suffix == ".nc":
        xarray()
    probe = path.with_name(path.name + ".probe")
    try:
        probe.write_bytes(b"\0")
        probe.unlink()
    except OSError as error:
        with suppress(OSError):
            probe.unlink()
        raise ParameterError(
            f"{path} cannot be written ({error.strerror}); give another path, or the right to write there"
        ) from error
    free = shutil.disk_usage(path.parent).free
    if free < bytes_needed:
        raise ParameterError(
            f"{path}: about {_megabytes(bytes_needed)} are needed and {_megabytes(free)} are free; "
            "make room, or write to another disk"
        )


def write(
    path: Path, dataset: Callable[[], Any], columns: Callable[[], Mapping[str, Any]], attrs: Mapping[str, Any]
) -> None:
    """Write netCDF or CSV, by the ending, whole or not at all. Equal data give equal bytes."""
    check_target(path, 0)
    temporary = path.with_name(path.name + ".new")
    try:
        if path.suffix == ".nc":
            dataset().to_netcdf(temporary, engine="h5netcdf")
        else:
            write_csv(temporary, columns(), attrs)
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def write_csv(path: Path, columns: Mapping[str, Any], attrs: Mapping[str, Any]) -> None:
    """Names of the columns, then attributes and units in comment lines, then the numbers to the last digit.

    The names come first because NumPy takes them from the first line, comment or not.
    """
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        file.writelines(f"# {name}: {value}\n" for name, value in attrs.items())
        file.writelines(f"# {name} [{QUANTITIES[name][0]}]: {QUANTITIES[name][1]}\n" for name in columns)
        writer.writerows(zip(*(np.ravel(values).tolist() for values in columns.values()), strict=True))


def plain(text: str) -> str:
    """Text that is one cell to every reader of CSV, NumPy too, which knows no quotes: no comma, quote, # or line end."""
    return " ".join(text.replace(",", ";").replace('"', "'").replace("#", "no. ").split())


def read(path: Path) -> tuple[dict[str, Any], dict[str, str]]:
    """Columns, flat, and attributes of a file that :func:`write` wrote."""
    if path.suffix == ".nc":
        with xarray().open_dataset(path, engine="h5netcdf") as dataset:
            return {name: dataset[name].values.ravel() for name in dataset.variables}, dict(dataset.attrs)
    with path.open(newline="", encoding="utf-8") as file:
        lines = file.readlines()
    comments, table = ([line for line in lines if line.startswith("#") == comment] for comment in (True, False))
    attrs = dict(line[2:].rstrip("\n").split(": ", 1) for line in comments)
    header, *rows = csv.reader(table)
    columns = dict(zip(header, zip(*rows, strict=True) if rows else [()] * len(header), strict=True))
    return {name: np.array(values) for name, values in columns.items()}, attrs


def _megabytes(size: int) -> str:
    return f"{math.ceil(size / 1e6)} MB"


# ------------------------------------------------------------------------------------------------ the journal

#: One point of a sweep: its measured values and, if it failed, why.
Record = tuple[list[float], str]


@contextmanager
def journal(
    target: Path, header: Mapping[str, Any]
) -> Iterator[tuple[dict[int, Record], Callable[[int, Record], None]]]:
    """Finished points of an earlier run to ``target``, and a function that appends one more.

    The journal stands next to the target, a line of JSON a point after a line that says which sweep it
    belongs to. A line that a kill cut short is dropped; every line is out of this process before the next
    point is asked for. The journal is removed when the body ends well, which must have written the target.
    """
    path = target.with_name(target.name + ".partial")
    done: dict[int, Record] = {}
    first = json.dumps(header, sort_keys=True).encode() + b"\n"
    with path.open("a+b") as file:
        file.seek(0)
        found = file.readline()
        if not found.endswith(b"\n"):  # new, or killed before its first line was whole
            file.truncate(0)
            file.write(first)
            file.flush()
        elif found != first:
            raise ParameterError(
                f"{path} belongs to another sweep; remove it to start anew, or give another path"
            )
        else:
            _replay(file, done)

        def append(index: int, record: Record) -> None:
            file.write(json.dumps([index, *record]).encode() + b"\n")
            file.flush()

        yield done, append
    path.unlink()


def _replay(file: IO[bytes], done: dict[int, Record]) -> None:
    """Read whole lines into ``done``, and cut off what follows the last."""
    while True:
        begin = file.tell()
        line = file.readline()
        if not line.endswith(b"\n"):
            file.truncate(begin)
            return
        index, values, reason = json.loads(line)
        done[index] = (values, reason)
