"""Shape of results: whatever a result depends on, it has the shape of all arguments together.

An argument is anything with + − × ÷ and integer powers: float, array, Fraction, mpmath number or
interval, Arb ball, expression.

@header@
"""

from collections.abc import Callable
from functools import wraps
from types import FunctionType
from typing import Any

import numpy as np
import numpy.typing as npt


def broadcasting(module: dict[str, Any]) -> list[str]:
    """Give every result of a module's functions the common shape of the arguments, constants
    included; the names of the functions.

    The algebra alone is ``function.__wrapped__``, for compilers.
    """
    functions = {
        name: it
        for name, it in module.items()
        if isinstance(it, FunctionType) and it.__module__ != __name__
    }
    module |= {
        name: _shaped(it) for name, it in functions.items() if it.__module__ == module["__name__"]
    }
    return list(functions)


def _shaped(function: Callable[..., object]) -> Callable[..., object]:
    @wraps(function)
    def shaped(*args: Any, **kwargs: Any) -> object:
        numbers = [*args, *(value for name, value in kwargs.items() if name != "xp")]
        if not function.__kwdefaults__:  # it needs no namespace
            kwargs.pop("xp", None)
        result: Any = function(*args, **kwargs)
        arrays = [value for value in numbers if isinstance(value, np.ndarray)]
        if arrays:
            shape = np.broadcast_shapes(*(value.shape for value in arrays))
            return _fill(result, shape, np.result_type(*arrays))
        return _typed(result, numbers)

    shaped.__doc__ = _documentation(function)
    return shaped


def _documentation(function: Callable[..., Any]) -> str:
    """Text that ``help`` shows: the function's own text, and its arguments by the table at the head
    of its module.
    """
    table = dict(
        line.split(" : ", 1)
        for line in (function.__globals__["__doc__"] or "").splitlines()
        if " : " in line
    )
    code = function.__code__
    names = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
    described = "".join(
        f"{name} : number or array\n    {table[name]}\n" for name in names if name in table
    )
    if "xp" in names:
        described += (
            "xp : module\n    namespace of the functions for the number type: numpy, mpmath\n"
        )
    return f"{' '.join((function.__doc__ or '').split())}\n\nParameters\n----------\n{described}"


def _fill(result: npt.ArrayLike, shape: tuple[int, ...], dtype: np.dtype[Any]) -> object:
    if isinstance(result, tuple):
        return tuple(_fill(item, shape, dtype) for item in result)
    if np.shape(result) == shape:
        return np.asarray(result)
    filled = np.empty(
        shape, dtype=np.result_type(dtype, result) if dtype != np.dtype(object) else object
    )
    filled[...] = result
    return filled


def _typed(result: object, numbers: list[Any]) -> object:
    """Constants of the algebra in the number type of the arguments."""
    if isinstance(result, tuple):
        return tuple(_typed(item, numbers) for item in result)
    return result + 0 * sum(numbers) if isinstance(result, int) else result
