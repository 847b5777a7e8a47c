"""Attacks on sweeps: journals and files damaged; what became of each is counted.

A wrong number, or an error that is not spragsym's own, ends one with that error.
"""

import warnings
from collections import Counter
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.core.errors import DamageWarning, StoreError
from spragsym.files.journal import path_of
from spragsym.motion.sweeps import Sweep, rms_sweep

P = ss.Parameters.article(theta0=np.radians(np.linspace(30.0, 60.0, 12)))
SHORT = {"V": 0.5, "d": 10.0, "t_end": 30.0, "transient": 10.0}


class Recorded:
    """A map that computes every point once, and gives it from memory later: the attack is on what
    is stored.
    """

    def __init__(self) -> None:
        self.answers: dict[Any, Any] = {}
        self.limit = -1
        self.at_limit: Any = None

    def __call__(self, function: Any, tasks: Iterable[Any]) -> Iterator[Any]:
        for number, task in enumerate(tasks):
            if number == self.limit:
                self.at_limit()
            if task not in self.answers:
                self.answers[task] = function(task)
            yield self.answers[task]
        if self.limit >= len(P.theta0):
            self.at_limit()


def same(one: Sweep, other: Sweep) -> bool:
    """To the last bit."""
    names = (*one.measured, "regime", "equilibrium", "reason")
    return all(
        np.array_equal(
            getattr(one, n), getattr(other, n), equal_nan=getattr(one, n).dtype.kind == "f"
        )
        for n in names
    )


def damaged(rng: np.random.Generator, data: bytes) -> tuple[str, bytes]:
    """One of the ways in which disks, transfers and people change a file, and the file after it."""
    kind = rng.choice(
        [
            "bit",
            "byte",
            "digit",
            "cut",
            "lost",
            "added",
            "zeros",
            "twice",
            "swapped",
            "half a line",
            "another's",
        ]
    )
    at = int(rng.integers(len(data)))
    end = min(len(data), at + int(rng.integers(1, 200)))
    lines = data.splitlines(keepends=True)
    i, j = (int(k) for k in rng.integers(len(lines), size=2))
    if kind == "bit":
        return kind, data[:at] + bytes([data[at] ^ (1 << int(rng.integers(8)))]) + data[at + 1 :]
    if kind == "byte":
        return kind, data[:at] + bytes([int(rng.integers(256))]) + data[at + 1 :]
    if kind == "digit":
        digits = [k for k in range(len(data)) if data[k : k + 1].isdigit()] or [at]
        k = int(rng.choice(digits))
        return kind, data[:k] + b"%d" % rng.integers(10) + data[k + 1 :]
    if kind == "twice":
        return kind, b"".join([*lines[: i + 1], *lines[i:]])
    if kind == "swapped":
        lines[i], lines[j] = lines[j], lines[i]
        return kind, b"".join(lines)
    if kind == "half a line":
        return kind, b"".join([*lines[:i], lines[i][: len(lines[i]) // 2], *lines[i + 1 :]])
    if kind == "another's":
        return kind, b"".join([*lines[:i], b'[6, [], ""]\n', *lines[i:]])
    new = {
        "cut": data[:at],
        "lost": data[:at] + data[end:],
        "added": data[:end] + data[at:],
        "zeros": data[:at] + bytes(end - at) + data[end:],
    }
    return kind, new[kind]


def journal_bytes(path: Path, recorded: Recorded, points: int) -> bytes:
    """The journal that a kill leaves after some points."""

    def kill() -> None:
        raise KeyboardInterrupt

    recorded.limit, recorded.at_limit = points, kill
    with suppress(KeyboardInterrupt):
        rms_sweep(P, **SHORT, store=path, workers=recorded)
    recorded.limit = -1
    return path_of(path).read_bytes()


def named(error: Exception, *words: object) -> None:
    """An error says which file it is about, and more."""
    assert all(str(word) in str(error) for word in words), error


def attack_journals(rng: np.random.Generator, folder: Path, count: int) -> Counter[str]:
    """Resume from damaged journals: the right numbers, or a refusal that names the file."""
    recorded, outcomes = Recorded(), Counter[str]()
    expected = rms_sweep(P, **SHORT, workers=recorded)
    path = folder / "rms.csv"
    whole = journal_bytes(path, recorded, 8)
    for _ in range(count):
        kind, data = damaged(rng, whole)
        path_of(path).write_bytes(data)
        path.unlink(missing_ok=True)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            try:
                found = rms_sweep(P, **SHORT, store=path, workers=recorded)
            except (StoreError, ss.errors.ParameterError) as error:
                named(error, path_of(path))
                outcomes["refused, and named"] += 1
                continue
        assert same(found, expected), kind
        for warning in caught:
            assert warning.category is DamageWarning, warning
            assert str(path_of(path)) in str(warning.message)
            assert "line" in str(warning.message)
        changed = data != whole
        outcomes[
            "healed, and named"
            if caught
            else "healed: a line was cut, doubled or missing"
            if changed
            else "as it was"
        ] += 1
    path_of(path).unlink(missing_ok=True)
    return outcomes


def attack_files(rng: np.random.Generator, folder: Path, count: int) -> Counter[str]:
    """Load damaged results: an error that names the file, or not a bit has changed."""
    recorded, outcomes = Recorded(), Counter[str]()
    wholes = {}
    for ending in ("nc", "csv"):
        path = folder / f"damaged.{ending}"
        expected = rms_sweep(P, **SHORT, store=path, workers=recorded)
        wholes[path] = path.read_bytes()
    for k in range(count):
        path = list(wholes)[k % 2]
        kind, data = damaged(rng, wholes[path])
        path.write_bytes(data)
        try:
            found = rms_sweep(P, **SHORT, store=path, workers=recorded)
        except StoreError as error:
            named(error, path)
            outcomes[f"{path.suffix}: refused, and named"] += 1
            continue
        assert data == wholes[path], f"{kind} was not noticed"
        assert same(found, expected), kind
        outcomes[f"{path.suffix}: as it was"] += 1
    return outcomes


def children(pid: int) -> list[int]:
    """Processes that one has started, on Linux."""
    try:
        return [
            int(number)
            for file in Path(f"/proc/{pid}/task").glob("*/children")
            for number in file.read_text(encoding="utf-8").split()
        ]
    except OSError:  # it has just ended
        return []
