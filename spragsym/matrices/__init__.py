"""Models of matrices, as finite-element programs write them: files, onsets of squeal, modes."""

import sys as _sys
import types as _types
from typing import Any as _Any

from .answers import flutter_onsets as flutter_onsets
from .answers import modes as modes

#: Modules that other rooms ask; each is loaded when it is imported.
__all__ = ["answers", "contacts", "example", "files", "model", "onsets", "options"]


class _Callable(_types.ModuleType):
    """This room, which is called as the function of its name that the package offers: an import of
    one of its modules puts it in the function's place.
    """

    def __call__(self, *args: _Any, **options: _Any) -> _Any:
        from .model import matrices

        return matrices(*args, **options)


_sys.modules[__name__].__class__ = _Callable
