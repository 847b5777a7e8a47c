"""Former names of arguments: for one version they are errors that say the present spelling."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable
from typing import ParamSpec, TypeVar

from .errors import ParameterTypeError

P = ParamSpec("P")
R = TypeVar("R")


def former(**names: str) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Arguments that a function no longer has, each with what is written now.

    Arguments by position that have become keywords are such errors too: the last of ``names`` is
    what is written instead.

    Raises
    ------
    ParameterTypeError
        From the function, if it is called with one of them.

    Examples
    --------
    >>> from spragsym.core.former import former
    >>> @former(to='between={"V": (0, 1)}')
    ... def follow(vary, *, between=None): ...
    >>> follow("V", to=(0.1, 0.3))
    Traceback (most recent call last):
        ...
    spragsym.core.errors.ParameterTypeError: follow has no argument to; write between={"V": (0, 1)}
    """

    def with_former(function: Callable[P, R]) -> Callable[P, R]:
        parameters = inspect.signature(function).parameters.values()
        most = sum(one.kind is not one.KEYWORD_ONLY for one in parameters)

        @functools.wraps(function)
        def called(*args: P.args, **options: P.kwargs) -> R:
            for name, now in names.items():
                if name in options:
                    raise ParameterTypeError(
                        f"{function.__name__} has no argument {name}; write {now}"
                    )
            if len(args) > most:
                raise ParameterTypeError(
                    f"{function.__name__} takes {most} arguments by position, not {len(args)}; "
                    f"write {[*names.values()][-1]}"
                )
            return function(*args, **options)

        return called

    return with_former
