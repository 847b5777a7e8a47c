"""Typical mistakes in files and calls: what each is answered, and in what time."""

import re
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from tests.support import written_brake

BRAKE = {
    "m": "0.35 kg",
    "k": "180 N/mm",
    "L_0": "38 mm",
    "theta0": "52 deg",
    "k_x": "9 N/mm",
    "k_y": "0 N/mm",
    "k_c": "1500 N/mm",
    "F_L": "420 N",
    "mu0": "[0.3, 0.6]",
    "V": "1.2 m/s",
    "d": "10 s/m",
}

#: Key, what is written for it, and words of the message beside file, line, key and value: what is
#: wrong, and what to write.
FILES: list[tuple[str, str, tuple[str, ...]]] = [
    ("k", "180", ("there is no unit", '"180 N/mm')),
    ("k", "180 apples", ("'apples' is not known", '"180 N/mm')),
    ("k", "180 kg", ("'kg' (kilogram) does not measure what N/m does", '"180 N/mm')),
    ("k", "-180 N/mm", ("is not above 0 N/mm", "without the inclined spring")),
    ("k_x", "-1500 N/mm", ("is not at least 0 N/mm", "all of it must be")),
    ("k", "180 N/mm +- 200 %", ("tolerance reaches", "-180 N/mm", "above 0 N/mm")),
    ("k", "180,5 N/mm", ("a number with a point", '"180 N/mm')),
    ("k", "180 N/mm ± 15", ("the tolerance has no unit", "± 15 %")),
    ("theta0", "52", ("there is no unit", '"52 deg')),
    ("theta0", "200 deg", ("above 0 deg and below 180 deg",)),
    ("theta0", "0 deg", ("above 0 deg and below 180 deg",)),
    ("mu0", "45 % +- 10 %", ("points or a share", "(45 ± 10) %")),
    ("mu0", "[0.6, 0.3]", ("begins above its end", "[0.3, 0.6]")),
    ("mu0", "-0.1", ("is not at least 0", "supplement of theta0")),
    ("V", "1.2 km", ("does not measure what m/s does", '"1.2 m/s"')),
    ("d", "10 m/s", ("does not measure what s/m does", '"10 s/m"')),
    ("mass", "0.35 kg", ("is not a quantity of the model kang_nam", "the keys are m, k_c")),
    ("K", "180 N/mm", ("did you mean k?",)),
    ("model", "kangnam", ("did you mean kang_nam?",)),
    ("k_c", "1500 N/mn", ("'N/mn' is not known", '"1500 N/mm"')),
    ("damping_ratio", "5", ("at least 0 and below 1",)),
    ("damping_ratio", "0.5 % +- 0.1 %", ("takes no tolerance here", 'write "0.5 %"')),
    ("F_L", "420 kg", ("does not measure what N does", '"420 N')),
    ("L_0", "38 mm sd 5 mm in [40, 41] mm", ("does not lie between the ends", '"38 mm"')),
    ("vary", "foo", ("does not move the states", "choose one of theta0")),
]

P = ss.Parameters.article(theta0=0.8, mu0=0.5)
A = ss.Parameters.article

#: A call, and words of its message: argument, value, range, remedy.
CALLS: list[tuple[Callable[[], Any], tuple[str, ...]]] = [
    (lambda: A(theta0=49), ("theta0 = 49", "(0, pi)", "numpy.radians")),
    (lambda: A(theta=0.8), ("theta is not a parameter", "did you mean theta0?")),
    (lambda: A(mu0=-1), ("mu0 = -1", "[0, inf)", "supplement of theta0")),
    (lambda: A(sigma="0.1"), ("sigma = '0.1'", "real numbers")),
    (lambda: A(theta0=np.nan), ("theta0 = nan", "(0, pi)")),
    (lambda: ss.folds(0.5), ("p = 0.5", "model.Parameters(...)")),
    (lambda: ss.folds(A(), "mu"), ("vary = 'mu'", "choose one of theta0, mu0")),
    (
        lambda: ss.folds(P, between={"theta0": (1, 0)}),
        ("between['theta0'] = (1, 0)", "lower and upper end"),
    ),
    (lambda: ss.equilibria(A()), ("theta0 is missing", "p.replace(theta0=...)")),
    (lambda: ss.simulate(P, t_end=-1), ("t_end = -1", "(0, inf)")),
    (lambda: ss.simulate(P, start=(1, 2), t_end=9), ("start has the shape (2,)", "x0, y0")),
    (lambda: ss.simulate(P, t_end=9, backend="matlab"), ("'matlab'", "heyoka, compiled, scipy")),
    (lambda: ss.cycle(P, near=(1, 2)), ("near has the shape (2,)", "4 numbers")),
    (lambda: ss.load("trolly"), ("'trolly'", "did you mean trolley?")),
    (lambda: ss.certify(P, P, "no jmp"), ("claim = 'no jmp'", "'no jump'")),
    (
        lambda: ss.quasi_static_path(P, "mu0", [0.5, 0.1, 0.7]),
        ("values do not go one way", "strictly increasing"),
    ),
    (lambda: ss.open("nofile.json"), ("nofile.json can't be read", "save() wrote")),
    (lambda: ss.equilibria(P, method="fast"), ("method = 'fast'", "auto, closed, search")),
    (lambda: ss.Study(P), ("parameters = Parameters", "a study needs PhysicalParameters")),
    (lambda: ss.redesign(P, "theta", {"mu0": 0.7}), ("'theta'", "theta0, mu0")),
]


@pytest.mark.parametrize(("key", "value", "words"), FILES)
def test_a_mistake_in_a_file(key: str, value: str, words: tuple[str, ...], tmp_path: Path) -> None:
    file = written_brake(tmp_path, {**BRAKE, key: value})
    line = list({**BRAKE, key: value}).index(key) + 2
    said = _refusal(lambda: ss.Study.from_file(file))
    assert re.search(rf"{file.name}, line {line}: {key} = '{re.escape(value)}'", said), said
    assert all(word in said for word in words), said


@pytest.mark.parametrize(("call", "words"), CALLS)
def test_a_mistake_in_a_call(call: Callable[[], Any], words: tuple[str, ...]) -> None:
    said = _refusal(call)
    assert all(word in said for word in words), said


def test_there_are_forty_of_them() -> None:
    assert len(FILES) + len(CALLS) >= 40


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
