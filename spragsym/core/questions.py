"""Questions: one function for all models, answered by a closed form where the model of the
parameters brings one.

``@question`` stands on the general algorithm, whose signature and docstring are the public ones:
``ss.folds`` is that function. A model must bring ``model.json`` and generated functions,
``algebra``, which follow from a page. A shipped one may bring closed forms of primitives
(equilibria, folds, cusps, where states end, …) in a room of its name: ``CLOSED_FORMS`` there says
for a question in which module the function of the same name stands. It is not asked about arguments
that it does not have, and raises :class:`NotInClosedForm` for values that it does not know: then
the general algorithm answers. What is derived from primitives asks the public questions, and so
stands once. So a model gets every public question for nothing, by its general algorithm, but for
those that a room of a model keeps to itself. ``method="search"`` asks the same of the model without
closed forms, ``model.search``: its sets of parameters know it, so that everything below searches
too.
"""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, get_args

from .error_states import in_usual_state
from .errors import ModelError, ParameterTypeError, one_of
from .type_variables import P, R

if TYPE_CHECKING:
    from ..models import Model


#: Ways to an answer: by closed form where there is one, by closed form only, or by the general
#: algorithm and all that it asks.
Method: TypeAlias = Literal["auto", "closed", "search"]


#: Questions that are answered of a page with a clock.
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
    """Raised by a closed form for arguments that it does not know."""


def question(general: Callable[P, R]) -> Callable[P, R]:
    """The general algorithm behind the closed form of that name, if the model of the parameters
    brings one.
    """
    name = general.__name__

    @in_usual_state
    @functools.wraps(general)
    def ask(*args: P.args, **options: P.kwargs) -> R:
        method = options.pop("method", "auto")
        model = model_of(*args, *options.values())
        model.require_answered(name)
        asked = model
        if method != "auto":
            asked = (
                model.whole
                if one_of("method", method, get_args(Method)) == "closed"
                else model.search
            )
            args = of(asked, args)
            options.update({key: of(asked, value) for key, value in options.items()})
        given = {key: value for key, value in options.items() if not _says_nothing(value)}
        if (closed := _closed_form(asked, name, args, given)) is not None:
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
    """The model of the first set of parameters among arguments, all of which must be of that
    model.
    """
    sets = [*_sets(things)]
    if not sets:
        raise ParameterTypeError(
            f"p = {things[0] if things else None!r:.60} is no set of parameters; make one "
            "with model.Parameters(...)"
        )
    (_, kind), *others = sets
    model: Model = kind.model_of_class()
    for other, its in others:
        if not issubclass(its, kind) and not issubclass(kind, its):
            remedy = (
                "call .dimensionless() on it"
                if hasattr(other, "dimensionless")
                else "make one with model.Parameters(...)"
            )
            raise ParameterTypeError(
                f"p = {other!r:.60} is no set of parameters of {model.name}; {remedy}"
            )
    return model


def _is_set(thing: object) -> bool:
    return hasattr(type(thing), "model_of_class")


def _sets(things: Iterable[Any]) -> Iterator[tuple[Any, Any]]:
    """Sets of parameters among arguments, and designs that stand for one, each with its class;
    those in pairs of corners too.
    """
    for thing in things:
        if _is_set(thing):
            yield thing, type(thing)
        elif isinstance(thing, tuple):
            yield from _sets(thing)
        elif (kind := getattr(thing, "of_model", None)) is not None:
            yield thing, kind


def of(model: Model, thing: Any) -> Any:
    """Arguments with their sets of parameters as sets of the model without closed forms, or of the
    one with them.
    """
    if _is_set(thing) or hasattr(thing, "of_model"):
        return thing.of(model)
    return tuple(of(model, one) for one in thing) if type(thing) is tuple else thing


_signature = functools.cache(inspect.signature)


def _says_nothing(value: object) -> bool:
    """Whether an option is as if it were left out: None, or ranges of no parameter."""
    return value is None or (isinstance(value, Mapping) and not value)


def _closed_form(
    model: Model, name: str, args: tuple[Any, ...], options: Mapping[str, Any]
) -> Callable[..., Any] | None:
    """The closed form of a question, if it has arguments of these names."""
    closed = model.closed_form(name)
    if closed is None or (len(args) == 1 and not options):
        return closed
    try:
        _signature(closed).bind(*args, **options)
    except TypeError:
        return None
    return closed
