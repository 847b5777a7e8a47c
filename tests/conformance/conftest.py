"""What is about one model each, and nothing else, is run for the models that
``python -m tests.conformance`` was asked for; what a model does not answer is accepted by its
refusal.
"""

import os
import re
from collections.abc import Generator

import pytest

from spragsym.core.errors import ModelError
from tests.conformance.models import ASKED, MODELS, load


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """In place: tests without a model's name go."""
    if ASKED in os.environ:
        items[:] = [
            item
            for item in items
            if "name" in getattr(getattr(item, "callspec", None), "params", {})
        ]


@pytest.hookimpl(wrapper=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> Generator[None, object, object]:
    """Of a page with a clock, of which nothing is at rest, tests end at the first question that is
    refused by its name, with the reason.
    """
    try:
        return (yield)
    except (ModelError, AssertionError) as error:
        params = getattr(getattr(pyfuncitem, "callspec", None), "params", {})
        model = load(params["name"]) if params.get("name") in MODELS else None
        said = re.search(r"(\w+) is not answered yet of", str(error))
        if model is None or not model.clock or said is None:
            raise
        if f"{said[1]} is not answered yet of {model.name}, {model.refusal(said[1])}" not in str(
            error
        ):
            raise
        return True
