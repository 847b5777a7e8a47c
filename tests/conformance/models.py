"""The models of the suite: those that are shipped and two that the tests write, or those that it is
asked for.
"""

import math
import os
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

import spragsym as ss
from spragsym.command_line import options_of
from spragsym.models.load import shipped
from tests.oracles.user_pages import derived

TESTS = Path(__file__).resolve().parent.parent
#: Pages of the tests: a torsion spring on a belt that hardens, and a belt that leans, without
#: angles.
PAGES = (TESTS / "oracles/pages/soft_brake.py", TESTS / "oracles/pages/pressed.py")
#: Where ``python -m tests.conformance`` leaves the pages and folders that are asked for, in place
#: of all others.
ASKED = "SPRAGSYM_CONFORMANCE"


def folder_of(asked: str) -> Path:
    """The folder of a model, derived if it is a page that is asked for."""
    return _derived(Path(asked)) if asked.endswith(".py") else Path(asked)


def _derived(page: Path) -> Path:
    return derived(page.read_text(encoding="utf-8"), page.stem)


def _places() -> dict[str, str]:
    """What :func:`spragsym.load` takes for each model, by its name."""
    if ASKED in os.environ:
        folders = [folder_of(asked) for asked in os.environ[ASKED].split(os.pathsep)]
        return {ss.load(folder).name: str(folder) for folder in folders}
    written = [_derived(page) for page in PAGES] if find_spec("sympy") else []
    return {name: name for name in shipped()} | {folder.name: str(folder) for folder in written}


PLACES = _places()
MODELS = tuple(PLACES)

#: Those that are another one with another law or one spring more: what is the same by the same code
#: is asked of them by hand.
ALIKE = (
    "damped",
    "coulomb",
    "stribeck",
    "cubic_contact",
    "hertz_contact",
    "inclined_belt",
    "trolley",
    "pad_on_disc",
)


def place(name: str) -> str:
    """What :func:`spragsym.load` and ``--model`` take for a model."""
    return PLACES.get(name, name)


def load(name: str) -> ss.Model:
    """A model by the name that tests have in brackets."""
    return ss.load(place(name))


#: Those of which something is at rest: all without a clock.
RESTING = tuple(name for name in MODELS if not load(name).clock)
#: Those that rub: all that are asked for motions.
MOVING = tuple(name for name in MODELS if load(name).frictions)


def without_base(name: str, degrees: float) -> dict[str, float]:
    """What a set has to be given: an angle in degrees, 1 for anything else."""
    model = load(name)
    return {
        one: degrees if one in model.about["angles"] else 1.0
        for one in model.parameters
        if one not in model.base
    }


def a_set(name: str, degrees: float = 40.0, **changes: Any) -> Any:
    """Base values of a model; an angle that has none is of so many degrees."""
    model = load(name)
    given = without_base(name, degrees)
    return model.Parameters(
        **{
            one: math.radians(value) if one in model.about["angles"] else value
            for one, value in given.items()
        }
        | changes
    )


def words(name: str, degrees: float = 40.0) -> list[str]:
    """The options of a command for the same set."""
    given = without_base(name, degrees)
    options = [f"{options_of(load(name).about, one)[0]}={value!r}" for one, value in given.items()]
    return ["--model", place(name), *options]


def answers(model: ss.Model, question: str, ask: Callable[[], object]) -> bool:
    """Whether a model answers a question; where it says that it does not, asking is refused by the
    question's name, with the reason.
    """
    why = model.refusal(question)
    if why:
        with pytest.raises(ss.errors.ModelError) as error:
            ask()
        assert str(error.value) == f"{question} is not answered yet of {model.name}, {why}"
    return not why


def starts(p: Any, usual: list[float]) -> list[list[float]]:
    """Starts of a motion: the usual one, and where friction holds the mass one that rides with the
    belt.
    """
    if not hasattr(p.model.algebra, "grip"):
        return [usual]
    across = len(p.model.coordinates) - 1
    return [
        usual,
        [0.05]
        + [-0.1] * across
        + [float(getattr(p, p.model.frictions[0]["belt"]))]
        + [0.0] * across,
    ]


def moved(name: str, *first: str) -> tuple[str, float]:
    """A parameter to change, the first of those named that the model has or else its last one that
    is no angle, and its base value.
    """
    model = load(name)
    names = [one for one in model.parameters if one not in model.about["angles"]]
    one = next((wanted for wanted in first if wanted in names), names[-1])
    return one, float(a_set(name)[one])
