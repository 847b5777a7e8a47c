"""Typical mistakes in files and calls: what each is answered, and in what time."""

import re
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import spragsym as ss
from tests.oracles.mistakes import BEFORE, BRAKE, CALLS, FILES
from tests.support import written_brake


@pytest.mark.parametrize(("key", "value", "words"), FILES)
def test_a_mistake_in_a_file(key: str, value: str, words: tuple[str, ...], tmp_path: Path) -> None:
    file = written_brake(tmp_path, {**BRAKE, key: value})
    line = list({**BRAKE, key: value}).index(key) + 2
    said = _refusal(lambda: ss.Study.from_file(file))
    assert re.search(rf"{file.name}, line {line}: {key} = '{re.escape(value)}'", said), said
    assert all(word in said for word in words), said


@pytest.mark.parametrize(("call", "words"), CALLS)
def test_a_mistake_in_a_call(call: str, words: tuple[str, ...]) -> None:
    names: dict[str, Any] = {}
    exec(BEFORE, names)
    code = compile(call, "call", "exec")
    said = _refusal(lambda: exec(code, names))
    assert all(word in said for word in words), said


def _refusal(call: Callable[[], Any]) -> str:
    """What is said, one line, within 0.3 s of processor time once modules are loaded."""
    with pytest.raises(ss.errors.SpragsymError):  # loads what it needs
        call()
    begin = time.process_time()
    with pytest.raises((ss.errors.ParameterError, ss.errors.ParameterTypeError)) as refused:
        call()
    assert time.process_time() - begin < 0.3
    said = str(refused.value)
    assert "\n" not in said
    return said
