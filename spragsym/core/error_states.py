"""What each public function is called under: NumPy's handling of overflow, underflow and invalid
operations, of which a caller's own changes no answer, and arguments that it takes.
"""

from __future__ import annotations

import builtins
import functools
import inspect
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from .errors import ParameterTypeError, SpragsymError, hint
from .type_variables import P, R


def in_usual_state(function: Callable[P, R]) -> Callable[P, R]:
    """The function under NumPy's default error state, whatever that of its caller is.

    Algorithms rely on underflow to 0, and ask for more where they rely on it. Arguments that the
    function does not take are refused with those that it does.
    """

    @functools.wraps(function)
    def calculated(*args: P.args, **options: P.kwargs) -> R:
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
    function: Callable[..., Any], args: tuple[Any, ...], options: Mapping[str, Any], trouble: str
) -> None:
    """Refuse arguments that a function does not take, and the lack of one that it needs; a name
    that was taken for that of a parameter, if it is like one of an argument.
    """
    signature = inspect.signature(function)
    for name in options:
        meant = hint(name, signature.parameters)
        if trouble.startswith(f"{name} is ") and name not in signature.parameters and meant:
            raise ParameterTypeError(f"{function.__name__}: {trouble.partition(';')[0]}{meant}")
    try:
        signature.bind(*args, **options)
    except TypeError as error:
        taken, names = list[str](), [*signature.parameters]
        for name, one in signature.parameters.items():
            if one.kind is one.KEYWORD_ONLY and "*" not in taken:
                taken.append("*")
            taken.append(f"**{name}" if one.kind is one.VAR_KEYWORD else name)
        meant = next((hint(name, names) for name in options if name not in names), "")
        called = f"{function.__name__}({', '.join(taken)})"
        raise ParameterTypeError(
            f"{function.__name__}: {error}{meant or f'; call it as {called}'}"
        ) from None


def _require_kinds(
    function: Callable[..., Any], args: tuple[Any, ...], options: Mapping[str, Any]
) -> None:
    """Refuse the first argument that is of no class in its annotation."""
    general = inspect.unwrap(function)
    signature = inspect.signature(general)
    for name, value in signature.bind_partial(*args, **options).arguments.items():
        words = str(signature.parameters[name].annotation).split(" | ")
        if not any(_may_be(word.partition("[")[0], value, general) for word in words):
            kinds = " or ".join(word for word in words if word != "None")
            remedy = "one, or leave it out" if "None" in words else "one"
            raise ParameterTypeError(f"{name} = {value!r:.60} is no {kinds}; give {remedy}")


def _may_be(word: str, value: object, general: Callable[..., Any]) -> bool:
    """Whether a value is of the class that a word of an annotation names, or that is not known, as
    of numbers and sequences, which arrays may be too.
    """
    found = general.__globals__.get(word) or getattr(builtins, word, None)
    if word == "None" or word.endswith("Options"):  # named only where types are checked
        return word in (
            "None" if value is None else "",
            *(it.__name__ for it in type(value).__mro__),
        )
    if not isinstance(found, type) or found in (float, int, bool, Sequence):
        return True
    return isinstance(value, found)
