"""Which code solves many points: NumPy, or the same formulas compiled by numba."""

from __future__ import annotations

import importlib.util
from dataclasses import dataclass

from .errors import MissingExtraError, ParameterError

#: Points from which the compiled solver is chosen by itself: below, importing it takes longer than NumPy's answer.
WORTH_COMPILING = 20_000


@dataclass
class _Choice:
    name: str = "auto"
    threads: int = 1


_choice = _Choice()


def set_backend(name: str, threads: int = 1) -> None:
    """Choose how :func:`spragsym.equilibria` solves points; counts and digits are the same, bounds included.

    Parameters
    ----------
    name : {"auto", "numpy", "numba"}
        ``"auto"``, the default, takes numba for 20 000 points and more where it is installed, and NumPy otherwise.
    threads : int
        Threads of the compiled solver; results do not depend on it.

    Raises
    ------
    ParameterError
        For another name or a number of threads below 1.
    MissingExtraError
        For ``"numba"`` where it is not installed.

    Examples
    --------
    >>> set_backend("numpy")
    >>> get_backend()
    'numpy'
    >>> set_backend("auto")
    """
    if name not in ("auto", "numpy", "numba"):
        raise ParameterError(f"backend = {name!r} is not one of 'auto', 'numpy' and 'numba'")
    if isinstance(threads, bool) or not isinstance(threads, int) or threads < 1:
        raise ParameterError(f"threads = {threads!r} is not a number of threads; give an integer of 1 or more")
    if name == "numba" and not _has_numba():
        raise MissingExtraError("the backend 'numba'", "numba", "fast")
    _choice.name, _choice.threads = name, threads


def get_backend() -> str:
    """The name that was set last, ``"auto"`` to begin with."""
    return _choice.name


def chosen(points: int) -> tuple[str, int]:
    """The backend for so many points, and its threads."""
    if _choice.name == "auto":
        return ("numba" if points >= WORTH_COMPILING and _has_numba() else "numpy"), _choice.threads
    return _choice.name, _choice.threads


def _has_numba() -> bool:
    return importlib.util.find_spec("numba") is not None
