"""Questions: public functions of a set of parameters, the same for all models.

``@question`` decorates the general algorithm of a question, whose signature and docstring are the
public ones: ``ss.folds`` is that function. Any model with a ``model.json`` and the generated
functions ``algebra`` is answered by it.

A shipped model may bring closed forms of primitives (equilibria, folds, cusps, ends of states, …)
in a room of its name. ``CLOSED_FORMS`` there names, for each such question, the module with the
function of the same name. The closed form answers if it has the arguments that are given. It raises
:class:`NotInClosedForm` for values that it does not cover, and then the general algorithm answers.
Algorithms that need primitives ask the public questions, so that they use closed forms too.

``method="search"`` asks ``model.search``, the same model without closed forms. Its sets of
parameters belong to it, so that all further questions are answered by search as well.
"""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, get_args

from .error_states import in_usual_state
from .errors import ModelError, ParameterTypeError, one_of
from .type_variables import P, T

if TYPE_CHECKING:
    from ..models import Model


#: How a question is answered: by a closed form if there is one, by a closed form only, or by
#: general algorithms only.
Method: TypeAlias = Literal["auto", "closed", "search"]


#: Questions that are answered for a page with a clock.
FORCED = (
    "basin",
    "check",
    "cycle",
    "cycle_branch",
    "cycle_events",
    "export",
    "export to fmu",
    "fate",
    "fate_map",
    "lyapunov",
    "rms_sweep",
    "sensitivity",
    "simulate",
)


class NotInClosedForm(Exception):
    """Raised by a closed form for values that it does not cover."""


def question(general: Callable[P, T]) -> Callable[P, T]:
    """Decorate a general algorithm: the model's closed form of the same name is tried first."""
    name = general.__name__

    @in_usual_state
    @functools.wraps(general)
    def ask(*args: P.args, **options: P.kwargs) -> T:
        method = options.pop("method", "auto")
        model = model_of(*args, *options.values())
        model.require_answered(name)
        answering = model
        if method != "auto":
            one_of("method", method, get_args(Method))
            answering = model.whole if method == "closed" else model.search
            args = of(answering, args)
            options.update({key: of(answering, value) for key, value in options.items()})
        given = {key: value for key, value in options.items() if not _says_nothing(value)}
        if (closed := _closed_form(answering, name, args, given)) is not None:
            try:
                return closed(*args, **given)
            except NotInClosedForm:
                pass
        if method == "closed":
            raise ModelError(
                f"{model.name} answers {name} with these arguments by no closed form; leave "
                "method out, or give method='search'"
            )
        return general(*args, **options)

    return ask


def model_of(*things: Any) -> Model:
    """The model of the sets of parameters among the arguments.

    Raises
    ------
    ParameterTypeError
        If there is none, or they are of different models.
    """
    sets = [*_sets(things)]
    if not sets:
        raise ParameterTypeError(
            f"p = {things[0] if things else None!r:.60} is no set of parameters; make one "
            "with model.Parameters(...)"
        )
    (_, kind), *others = sets
    model: Model = kind.model_of_class()
    for other, other_class in others:
        if not issubclass(other_class, kind) and not issubclass(kind, other_class):
            remedy = (
                "call .dimensionless() on it"
                if hasattr(other, "dimensionless")
                else "make one with model.Parameters(...)"
            )
            raise ParameterTypeError(
                f"p = {other!r:.60} is no set of parameters of {model.name}; {remedy}"
            )
    return model


def require_answered(name: str, *things: object) -> None:
    """Raise ModelError if the model of a set of parameters has no answer to a question."""
    for _, kind in _sets(things):
        kind.model_of_class().require_answered(name)


def _is_set(thing: object) -> bool:
    return hasattr(type(thing), "model_of_class")


def _sets(things: Iterable[Any]) -> Iterator[tuple[Any, Any]]:
    """Sets of parameters among the arguments, and designs, which have one; in tuples too.

    Each comes with the class of its parameters.
    """
    for thing in things:
        if _is_set(thing):
            yield thing, type(thing)
        elif isinstance(thing, tuple):
            yield from _sets(thing)
        elif (kind := getattr(thing, "of_model", None)) is not None:
            yield thing, kind


def of(model: Model, thing: Any) -> Any:
    """An argument with its sets of parameters turned into sets of another version of the model,
    with or without closed forms.
    """
    if _is_set(thing) or hasattr(thing, "of_model"):
        return thing.of(model)
    return tuple(of(model, one) for one in thing) if type(thing) is tuple else thing


_signature = functools.cache(inspect.signature)


def _says_nothing(value: object) -> bool:
    """Whether an option is equivalent to leaving it out: None, or an empty mapping."""
    return value is None or (isinstance(value, Mapping) and not value)


def _closed_form(
    model: Model, name: str, args: tuple[Any, ...], options: Mapping[str, Any]
) -> Callable[..., Any] | None:
    """The closed form of a question, if it accepts these arguments; else None."""
    closed = model.closed_form(name)
    if closed is None or (len(args) == 1 and not options):
        return closed
    try:
        _signature(closed).bind(*args, **options)
    except TypeError:
        return None
    return closed
