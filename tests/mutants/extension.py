"""Whether a build of the extension module tells the truth: points, counts, borders of blocks, and what is no parameter."""

from __future__ import annotations

import importlib.util
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from spragsym.kang_nam import statics
from spragsym.kang_nam.statics import compiled
from spragsym.results.state_columns import COLUMNS, Slots

from .c99 import FLAGS, LARGE, SOURCE, Judge, at_the_end

#: What is no parameter: place in the row, and value.
REFUSED = ((0, 4.0), (0, np.pi), (0, 2 * np.pi + 0.5), (0, np.nan), (1, -1.0), (2, 0.0), (3, np.inf), (4, -0.1), (5, -1e-9))


class Extension(Judge):
    """The same points, through Python's buffers."""

    def count(self, text: str) -> int:
        """Answers that a build gives; an error where one is wrong."""
        with tempfile.TemporaryDirectory() as name:
            module = _built(text, Path(name))
        sys.modules["spragsym.kang_nam.statics._compiled"] = statics._compiled = module  # type: ignore[attr-defined]  # it may not have been built
        columns = [np.ascontiguousarray(column) for column in self.rows.T]
        answered = sum(self._solved(columns, contact, range(len(self.rows))) for contact in (False, True))
        counts = compiled.count(columns, len(self.rows))
        for truth, number in zip(self.truth[True], counts, strict=True):
            assert number in (0, len(truth.states)), "number"
        for i in (0, 1, 2):  # one number for all; blocks that are full to the last, and by one more
            same = [np.broadcast_to(column[i : i + 1], 1) for column in columns]
            for size in (1, 64, 65, 256, 257):
                assert self._solved(same, True, [i] * size) in (0, size), "one for all"
                assert set(compiled.count(same, size)) == {counts[i]}, "number of one for all"
        self._refuses(columns, counts)
        _lengths(module)
        for size in (1, 3, 64, 65):
            _stays_inside(module, [column[:size] for column in columns], counts[:size])
        return answered + int((counts > 0).sum())

    def trespasses(self, text: str) -> str:
        """Nothing more: its buffers end where memory does."""
        return ""

    def _solved(self, columns: list[Any], contact: bool, rows: Any) -> int:
        """How many of the points, which are these rows, are settled, all of them as they must be."""
        out = Slots(len(rows), 3 if contact else 4)
        left = compiled.solve(columns, contact, out, 0, len(rows))
        out.clear()
        table = {name: out.padded(name) for name in COLUMNS}
        assert (out.count[left] == 0).all(), "count of what is not settled"
        for place in np.setdiff1d(np.arange(len(rows)), left):
            found = [{name: table[name][place, slot] for name in COLUMNS} for slot in range(out.count[place])]
            self.check(self.truth[contact][rows[place]], found)
            rest = table["theta"][place, len(found) :], table["stability"][place, len(found) :]
            assert np.isnan(rest[0]).all(), "beyond the count"
            assert not rest[1].any(), "kind beyond the count"
        return len(rows) - len(left)

    def _refuses(self, columns: list[Any], counts: Any) -> None:
        """What is no parameter is left, and its neighbours are as before."""
        changed, bad = [column.copy() for column in columns], np.arange(len(REFUSED)) * 11
        for place, (parameter, value) in zip(bad, REFUSED, strict=True):
            changed[parameter][place] = value
        out = Slots(len(self.rows), 3)
        left = compiled.solve(changed, True, out, 0, len(self.rows))
        assert np.isin(bad, left).all(), "no parameter"
        for row, values in zip((1, 2), LARGE, strict=True):
            for column, value in zip(changed, values, strict=True):
                column[row] = value
        out = Slots(len(self.rows), 3)
        left = compiled.solve(changed, True, out, 0, len(self.rows))
        assert np.isin([*bad, 1, 2], left).all(), "beyond double precision"
        assert not out.count[[*bad, 1, 2]].any(), "count of what is refused"
        again = compiled.count(changed, len(self.rows))
        assert not again[[1, 2]].any(), "number beyond double precision"
        again[[1, 2]] = counts[[1, 2]]
        assert not again[bad].any(), "number of no parameter"
        assert (np.delete(again, bad) == np.delete(counts, bad)).all(), "neighbours"


def _built(text: str, folder: Path) -> ModuleType:
    (folder / "_compiled.c").write_text(text, encoding="utf-8")
    command = [shutil.which("gcc") or "cc", "-std=c11", *FLAGS, "-ffp-contract=off", "-shared", "-fPIC"]
    command += [f"-I{SOURCE}", f"-I{sysconfig.get_path('include')}", "_compiled.c", "-o", "_compiled.so", "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    spec = importlib.util.spec_from_file_location("_compiled", folder / "_compiled.so")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _lengths(module: ModuleType) -> None:
    """A buffer that is too short or too long is an error, whichever it is."""
    n = 3

    def arguments() -> list[Any]:
        further = [np.empty(n, dtype=np.int64), *(np.empty(2 * n) for _ in range(5)), np.empty(2 * n, dtype=np.int8)]
        first = [*(np.empty(n) for _ in range(5)), np.empty(n, dtype=np.int8)]
        return [*(np.ones(n) for _ in range(6)), 1, np.empty(n, dtype=np.int8), np.empty(n, dtype=np.int8), first, further]

    def call(given: list[Any]) -> None:
        module.solve(*given[:9], tuple(given[9]), tuple(given[10]))

    call(arguments())
    places = [*((given, None) for given in (*range(6), 7)), *((9, i) for i in range(6)), *((10, i) for i in range(7))]
    for place, inner in places:
        for size in (0, 1, 2, 4, 7):
            given = arguments()
            part = given[place] if inner is None else given[place][inner]
            one = np.ones(size, dtype=part.dtype)
            if inner is None:
                given[place] = one
            else:
                given[place][inner] = one
            try:
                call(given)
                fits = True
            except ValueError:
                fits = False
            assert fits == (size == 1 and place < 6), "length of a buffer"
    good = arguments()
    first, further = tuple(good[9]), tuple(good[10])
    for bad in ((first[:5], further), (first, further[:6]), (good[9], further), (first, good[10])):
        try:
            module.solve(*good[:9], *bad)
        except TypeError:
            continue
        raise AssertionError("tuples of too few, or lists")


def _stays_inside(module: ModuleType, columns: list[Any], counts: Any) -> None:
    """Every buffer ends where memory that may be touched does."""
    size, kinds = len(counts), [*[np.float64] * 5, np.int8]
    given = [at_the_end(column) for column in columns]
    for contact in (0, 1):
        room = size * (2 if contact else 3)
        settled, number = (at_the_end(np.zeros(size, dtype=np.int8)) for _ in range(2))
        first = tuple(at_the_end(np.zeros(size, dtype=kind)) for kind in kinds)
        further = tuple(at_the_end(np.zeros(room, dtype=kind)) for kind in kinds)
        module.solve(*given, contact, settled, number, first, (at_the_end(np.zeros(size, dtype=np.int64)), *further))
    found = at_the_end(np.zeros(size, dtype=np.int8))
    module.count(*given, found)
    assert (found == counts).all(), "numbers of a few"
