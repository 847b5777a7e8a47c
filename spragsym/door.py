"""The door: ``ss.f(p)`` is ``p.model.f(p)``, for every function of :data:`INTERFACE`.

A model must bring
    ``model.json`` and generated functions, ``algebra``: of the balance of forces, of small deviations from it, of the motion. All
    of it follows from a page, see :mod:`spragsym.derive`; it is what :class:`spragsym.Model` holds.

A model may bring
    closed forms, if it is a shipped one, in a room of its name: ``CLOSED`` there says for a public function in which room its
    closed form stands, under the same name, and along which parameters it is known. It answers first (``method="auto"`` or
    ``"closed"``) wherever it takes the arguments that are given. So for a step of :data:`PARTS`, as the motion that compiled
    code integrates.

A model gets for nothing
    every question of :data:`INTERFACE` that has a general way, the methods of :class:`spragsym.Model`: by search over boxes
    with proofs, or by the generated field. Where there are closed forms it is the second witness, ``method="search"``, and
    ``model.search`` is the model without its closed forms.

A model never gets
    the answer of another one: a set of parameters is checked at this one entry, for every question and every method, and what
    can't be answered yet is :class:`~spragsym.errors.ModelError`, which says what can be asked instead.
"""

from __future__ import annotations

import functools
import importlib
import inspect
from collections.abc import Callable, Collection, Mapping
from typing import Any

from .errors import ModelError, ParameterError, ParameterTypeError
from .parameters import ParameterSet
from .questions import is_chosen, of
from .questions import model_of as _model_of

#: Public functions that are asked of a model.
INTERFACE: frozenset[str] = frozenset()
#: Steps on the way to answers: compiled code that integrates a motion, the equilibrium that one rests at, whether one that is
#: above the belt stays there, which states lie on one branch, whether they have ended at their friction, what is known to any
#: number of digits, and points that show what the model does.
PARTS = frozenset(("cases", "integrate", "aloft", "precise_equilibria", "precise_cusps"))
#: Ways to an answer.
WAYS = ("auto", "closed", "search")


def question(general: Callable[..., Any]) -> Callable[..., Any]:
    """A method of a model: the closed form where the model brings one that takes the arguments, else ``general``."""
    name, answered = general.__name__, getattr(general, "answered", True)

    @functools.wraps(general)
    def ask(model: Any, *args: Any, method: str = "auto", **options: Any) -> Any:
        if method not in WAYS:
            raise ParameterError(f"method = {method!r} is not one of {', '.join(WAYS)}")
        _check(model, args, options)
        if method != "search" and name in model.closed and not is_chosen(name, args, options):
            room, along = model.closed[name]
            closed = closed_form(room, name)
            alone = len(args) == 1 and not options  # one argument always fits
            if alone or not answered or _takes(closed, along, model, args, options):
                return closed(*args, **options)
        if method == "closed":
            raise ModelError(
                f"{model.name} answers {name} with these arguments by no closed form; leave method out, or give method='search'"
            )
        asked = model.search if method == "search" else model
        return general(asked, *of(asked, args), **options)

    return ask


def part(general: Callable[..., Any]) -> Callable[..., Any]:
    """A step on the way to answers that a model may bring in a faster form: its own where there is one, else ``general``."""
    name = general.__name__

    @functools.wraps(general)
    def taken(model: Any, *args: Any, **options: Any) -> Any:
        if name in model.closed:
            return closed_form(model.closed[name][0], name)(*args, **options)
        return general(model, *args, **options)

    return taken


def unanswered(instead: str) -> Callable[..., Any]:
    """A method of a model for which there is no general way yet; what can be asked instead."""

    class Unanswered:
        def __set_name__(self, owner: type, name: str) -> None:
            def general(model: Any, *_: Any, **__: Any) -> Any:
                raise ModelError(f"{name} is not there yet for the model {model.name}; {instead}")

            general.__name__ = name
            general.answered = False  # type: ignore[attr-defined]  # a mark for question
            general.__doc__ = f"See :func:`spragsym.{name}`. There is no general way yet: {instead}."
            setattr(owner, name, question(general))

    return Unanswered()  # type: ignore[return-value]  # a method, once the class is made


def public(closed: Callable[..., Any]) -> Callable[..., Any]:
    """The public function: the question of that name, asked of the model of its parameters."""
    name = closed.__name__

    @functools.wraps(closed)
    def ask(*args: Any, **options: Any) -> Any:
        return getattr(_model_of(*args, *options.values()), name)(*args, **options)

    return ask


def model_of(p: ParameterSet) -> Any:
    """The model of a set."""
    return _model_of(p)


def _check(model: Any, args: tuple[Any, ...], options: Mapping[str, Any]) -> None:
    """Raise unless all sets of parameters are the model's: another's would be taken for what they are not."""
    if len(args) == 1 and not options and isinstance(args[0], model.Parameters):
        return
    first = args[0] if args else options.get("p")
    if not isinstance(first, model.Parameters | Mapping):
        remedy = "call .dimensionless() on it" if hasattr(first, "dimensionless") else "make one with model.Parameters(...)"
        raise ParameterTypeError(f"p = {first!r:.60} is no set of parameters of {model.name}; {remedy}")


@functools.cache
def closed_form(room: str, name: str) -> Callable[..., Any]:
    found: Callable[..., Any] = getattr(importlib.import_module(f".{room}", __package__), name)
    return found


@functools.cache
def _signature(function: Callable[..., Any]) -> inspect.Signature:
    return inspect.signature(function)


def _takes(
    closed: Callable[..., Any], along: Collection[Any], model: Any, args: tuple[Any, ...], options: dict[str, Any]
) -> bool:
    """Whether a closed form has arguments of these names and values, and knows what varies, if that is of the model at all."""
    try:
        given = _signature(closed).bind(*args, **options).arguments
    except TypeError:
        return False
    if not along or "vary" not in given:
        return True
    vary = given["vary"]
    if vary is None:
        return False
    names = (vary,) if isinstance(vary, str) else tuple(vary)
    return (vary if isinstance(vary, str) else names) in along or not set(names) <= set(model.parameters)
