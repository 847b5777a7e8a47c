"""What is about one model each, and nothing else, is run for the models that
``python -m tests.conformance`` was asked for.
"""

import os

import pytest

from tests.conformance.models import ASKED


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """In place: tests without a model's name go."""
    if ASKED in os.environ:
        items[:] = [
            item
            for item in items
            if "name" in getattr(getattr(item, "callspec", None), "params", {})
        ]
