"""Decorator of public functions: NumPy's default error state, and checks of the arguments' names
and classes.
"""

from __future__ import annotations

import builtins
import functools
import inspect
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, get_args, get_origin

import numpy as np

from .errors import ParameterTypeError, SpragsymError, hint
from .type_variables import P, T


def in_usual_state(function: Callable[P, T]) -> Callable[P, T]:
    """Run a function in NumPy's default error state, whatever the caller's is.

    Algorithms rely on underflow to 0; they set other states themselves. A TypeError for wrong
    arguments becomes a ParameterTypeError that names the right ones.
    """

    @functools.wraps(function)
    def calculated(*args: P.args, **options: P.kwargs) -> T:
        with np.errstate(divide="warn", over="warn", under="ignore", invalid="warn"):
            try:
                return function(*args, **options)
            except (TypeError, AttributeError, ValueError) as error:
                if isinstance(error, TypeError):
                    _require_arguments(function, args, options, str(error))
                if not isinstance(error, SpragsymError):
                    _require_kinds(function, args, options)
                raise

    return calculated


def _require_arguments(
    function: Callable[..., Any], args: tuple[Any, ...], options: Mapping[str, Any], message: str
) -> None:
    """Raise a ParameterTypeError if the arguments do not fit the signature.

    ``message`` is that of the original error. A misspelt argument that was taken for the name of a
    parameter is refused with the name it resembles.
    """
    signature = inspect.signature(function)
    for name in options:
        meant = hint(name, signature.parameters)
        if message.startswith(f"{name} is ") and name not in signature.parameters and meant:
            raise ParameterTypeError(f"{function.__name__}: {message.partition(';')[0]}{meant}")
    try:
        signature.bind(*args, **options)
    except TypeError as error:
        signature_parts, names = list[str](), [*signature.parameters]
        for name, one in signature.parameters.items():
            if one.kind is one.KEYWORD_ONLY and "*" not in signature_parts:
                signature_parts.append("*")
            signature_parts.append(f"**{name}" if one.kind is one.VAR_KEYWORD else name)
        meant = next((hint(name, names) for name in options if name not in names), "")
        called = f"{function.__name__}({', '.join(signature_parts)})"
        raise ParameterTypeError(
            f"{function.__name__}: {error}{meant or f'; call it as {called}'}"
        ) from None


def _require_kinds(
    function: Callable[..., Any], args: tuple[Any, ...], options: Mapping[str, Any]
) -> None:
    """Raise a ParameterTypeError for the first argument of none of the classes in its
    annotation.
    """
    general = inspect.unwrap(function)
    signature = inspect.signature(general)
    for name, value in signature.bind_partial(*args, **options).arguments.items():
        words = str(signature.parameters[name].annotation).split(" | ")
        if not any(_may_be(word.partition("[")[0], value, general) for word in words):
            kinds = " or ".join(word for word in words if word != "None")
            remedy = "one, or leave it out" if "None" in words else "one"
            raise ParameterTypeError(f"{name} = {value!r:.60} is no {kinds}; give {remedy}")


def _may_be(word: str, value: Any, general: Callable[..., Any]) -> bool:
    """Whether a value may be of the class that a word of an annotation names.

    True for sequences, in whose place arrays may be given, and for unknown names.
    """
    kind = general.__globals__.get(word) or getattr(builtins, word, None)
    if word == "None":
        return value is None
    if word.endswith("Options"):  # imported by type checkers only
        return word in (base.__name__ for base in type(value).__mro__)
    if get_origin(kind) is Literal:
        return isinstance(value, str) and value in get_args(kind)
    if get_origin(kind) is Mapping:
        return isinstance(value, Mapping)
    if kind in (float, int, bool):
        return np.ndim(value) == 0
    if not isinstance(kind, type) or kind is Sequence:
        return True
    return isinstance(value, kind)
