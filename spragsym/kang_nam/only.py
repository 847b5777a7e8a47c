"""Decorator of functions that exist for the article's model only."""

from __future__ import annotations

import functools
from collections.abc import Callable

from ..core.error_states import in_usual_state
from ..core.errors import ModelError
from ..core.questions import model_of
from ..core.type_variables import P, T
from .parameters import Parameters


def of_article(instead: str) -> Callable[[Callable[P, T]], Callable[P, T]]:
    """Decorate a function of the article's model: for another model it raises a ModelError that
    says what to ask ``instead``.
    """

    def only(own: Callable[P, T]) -> Callable[P, T]:
        @functools.wraps(own)
        @in_usual_state
        def ask(*args: P.args, **options: P.kwargs) -> T:
            model = model_of(*args, *options.values())
            if not issubclass(model.Parameters, Parameters):
                raise ModelError(
                    f"{own.__name__} is not there yet for the model {model.name}; {instead}"
                )
            return own(*args, **options)

        return ask

    return only
