"""Matrices from files: of finite-element programs, MatrixMarket, MATLAB, NumPy and SciPy."""

from __future__ import annotations

import io
import os
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from ..core.errors import ParameterError, one_of
from ..files.text import FilePath, contents, path_text
from .exports import (
    Label,
    Labelled,
    abaqus,
    bulk,
    harwell_boeing,
    mapping,
    matlab,
    matrix_market,
    output4,
)

#: Bytes of the largest file that is read.
LARGEST = 2_000_000_000


def read(path: FilePath, variable: str | None = None) -> Any:
    """A matrix from a file, by its ending.

    Parameters
    ----------
    path : str or path
        ``.mtx`` of MatrixMarket, or of Abaqus' ``*MATRIX OUTPUT``; ``.matrix``, ``.hb``, ``.rua``
        or ``.rsa`` of Harwell and Boeing, as Ansys' ``HBMAT`` writes it; ``.op4``, formatted, and
        ``.pch``, ``.bdf`` or ``.dat`` with ``DMIG`` of Nastran; ``.mat`` of MATLAB; ``.npy``,
        ``.npz``.
    variable : str, optional
        The name of the matrix in a file with several.

    Returns
    -------
    ndarray, sparse array, or Labelled
        To the bit; ``Labelled`` if the file has labels of nodes.

    Raises
    ------
    ParameterError
        For a file that can't be read, is damaged, or holds no or several real matrices.

    Examples
    --------
    >>> import numpy as np, pathlib, tempfile
    >>> from spragsym.matrices.files import read
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     np.save(pathlib.Path(folder, "M.npy"), np.eye(2))
    ...     read(pathlib.Path(folder, "M.npy")).tolist()
    [[1.0, 0.0], [0.0, 1.0]]
    """
    shown = path_text(path)
    ending = os.path.splitext(shown)[1].lower()
    data = contents(path, LARGEST, "a file with a matrix")
    reader = READERS[one_of(f"the ending of {shown}", ending, READERS)]
    try:
        found = reader(data)
    except Exception as error:  # whatever a library says of damaged bytes
        why = "it ends too early" if isinstance(error, StopIteration) else error
        raise ParameterError(
            f"{shown} is no {ending} file with a matrix, or it is damaged: {why}"
        ) from error
    if isinstance(found, dict):
        found = _chosen(shown, found, variable)
    if isinstance(found, Labelled):
        if not found.dofs:
            raise ParameterError(f"{shown} holds no matrix; export one")
        return found
    kind = getattr(found, "dtype", np.dtype(object)).kind
    if kind not in "fiu" or len(getattr(found, "shape", ())) != 2:
        raise ParameterError(f"{shown} holds no real matrix; export one by itself")
    values = found.data if hasattr(found, "toarray") else found
    if not np.isfinite(values).all():
        raise ParameterError(f"{shown} holds numbers that are not finite")
    return found


def _chosen(shown: str, found: dict[str, Any], variable: str | None) -> Any:
    """The matrix of a name, or the only one."""
    if variable is None and len(found) == 1:
        return next(iter(found.values()))
    if variable is None:
        raise ParameterError(
            f"{shown} holds {', '.join(found) or 'nothing'}; name one, as read(path, 'K')"
        )
    return found[one_of(f"the matrix in {shown}", variable, found)]


def _of_text(reader: Callable[[str], Any]) -> Callable[[bytes], Any]:
    return lambda data: reader(data.decode("ascii"))


def _mtx(text: str) -> Any:
    return (matrix_market if text.startswith("%%MatrixMarket") else abaqus)(text)


def _numpy(data: bytes) -> Any:
    return np.load(io.BytesIO(data), allow_pickle=False)


def _archive(data: bytes) -> Any:
    with np.load(io.BytesIO(data), allow_pickle=False) as held:
        if "format" not in held:
            return dict(held)
    from scipy.sparse import load_npz

    found = load_npz(io.BytesIO(data))
    if hasattr(found, "check_format"):
        found.check_format(full_check=True)
    return found


def read_dofs(path: FilePath) -> tuple[Label, ...]:
    """The degrees of freedom of rows, of the file ``.mapping`` that Ansys writes beside a matrix;
    errors are those of :func:`read`.
    """
    shown = path_text(path)
    try:
        return mapping(contents(path, LARGEST, "a file .mapping").decode("ascii"))
    except ValueError as error:
        if isinstance(error, ParameterError):
            raise
        raise ParameterError(
            f"{shown} is no .mapping of Ansys, or it is damaged: {error}"
        ) from error


#: The reader of each ending.
READERS: dict[str, Callable[[bytes], Any]] = {
    ".mtx": _of_text(_mtx),
    **dict.fromkeys((".matrix", ".hb", ".rua", ".rsa"), _of_text(harwell_boeing)),
    ".op4": _of_text(output4),
    **dict.fromkeys((".pch", ".bdf", ".dat"), _of_text(bulk)),
    ".mat": partial(matlab, largest=LARGEST),
    ".npy": _numpy,
    ".npz": _archive,
}
