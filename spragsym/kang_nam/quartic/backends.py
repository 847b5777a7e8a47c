"""Backends that solve many points: NumPy, or the same kernel compiled from the generated C."""

from __future__ import annotations

from dataclasses import dataclass
from types import ModuleType

from ...errors import BackendError, ParameterError
from . import block, compiled


@dataclass
class _Choice:
    name: str = "auto"
    threads: int = 1


_choice = _Choice()


def set_backend(name: str, threads: int = 1) -> None:
    """Choose how :func:`spragsym.equilibria` solves points; counts are the same, and digits within the bounds.

    Parameters
    ----------
    name : {"auto", "numpy", "compiled"}
        ``"auto"``, the default, takes the compiled solver where a C compiler was at hand on installation, as in the wheels, and
        NumPy otherwise.
    threads : int
        Threads that solve blocks of points; results do not depend on it.

    Raises
    ------
    ParameterError
        For another name or a number of threads below 1.
    BackendError
        For ``"compiled"`` where it was not built.

    Examples
    --------
    >>> set_backend("numpy")
    >>> get_backend()
    'numpy'
    >>> set_backend("auto")
    """
    if name not in ("auto", "numpy", "compiled"):
        raise ParameterError(f"backend = {name!r} is not one of 'auto', 'numpy' and 'compiled'")
    if isinstance(threads, bool) or not isinstance(threads, int) or threads < 1:
        raise ParameterError(f"threads = {threads!r} is not a number of threads; give an integer of 1 or more")
    if name == "compiled" and not compiled.available():
        raise BackendError(
            "the backend 'compiled' was not built, for want of a C compiler or for a derivation that has changed since; "
            "install spragsym again, with a compiler, or install a wheel"
        )
    _choice.name, _choice.threads = name, threads


def get_backend() -> str:
    """The name of the backend that :func:`set_backend` has set; ``"auto"`` by default.

    Returns
    -------
    str

    Examples
    --------
    >>> get_backend() in ("auto", "numpy", "compiled")
    True
    """
    return _choice.name


def chosen() -> tuple[ModuleType, int]:
    """What solves points, and its threads."""
    name = ("compiled" if compiled.available() else "numpy") if _choice.name == "auto" else _choice.name
    return (compiled if name == "compiled" else block), _choice.threads
