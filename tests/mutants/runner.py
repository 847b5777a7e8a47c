"""Runs the tests of one subject against each of its mutants, each in a fork of a process that has everything loaded.

The fault goes into the functions that exist already, by their code, so that whoever imported them gets it. The tests stop at
the first failure. A mutant that takes many times the processor time of the sound module counts as killed.
"""

from __future__ import annotations

import ast
import functools
import gc
import hashlib
import importlib
import inspect
import json
import os
import resource
import signal
import sys
import time
import types
from pathlib import Path
from typing import Any

import pytest

from .operators import Mutant, mutants

#: Memory that a mutant may take, and the processor time for one test, in seconds and in multiples of what it takes.
MEMORY, SECONDS, TIMES = 3 << 30, 0.7, 5.0
#: How a fork ends.
SURVIVED, KILLED, BROKEN = 0, 1, 3


class Runner:
    """A pytest plugin that puts its own loop over mutants in the place of the run of the tests."""

    def __init__(self, subject: dict[str, Any], results: Path, jobs: int, only: list[str], again: bool, last: set[str]) -> None:
        self.module, self.results, self.jobs, self.only = importlib.import_module(subject["module"]), results, jobs, set(only)
        self.last = last  #: keys that are run last: what probably survives takes longest
        self.functions, self.prepare, self.again = subject.get("functions", []), subject.get("prepare", []), again
        self.tree = _parsed(str(self.module.__file__))
        self.failed = ""
        self.killers: dict[str, list[str]] = {}

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Remember a failure."""
        if report.failed:
            self.failed = report.nodeid

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        """All mutants that have no result yet."""
        items = session.items
        sources = [self.tree, *map(_parsed, sorted({str(item.path) for item in items}))]
        text = " ".join([*map(ast.unparse, sources), *(item.nodeid for item in items)])  # layout changes nothing
        digest = hashlib.sha256(text.encode()).hexdigest()[:16]
        if self.prepare:
            module, function = self.prepare
            getattr(sys.modules[module], function)()
        took, reached = self._baseline(items)
        items = sorted(items, key=lambda item: took[item.nodeid])
        known = self._known(digest)
        every = [mutant for mutant in mutants(self.tree) if not self.functions or mutant.scope in self.functions]
        waiting = [mutant for mutant in every if mutant.key not in known]
        waiting = [mutant for mutant in waiting if not self.only or mutant.key in self.only]
        waiting.sort(key=lambda mutant: mutant.key in self.last)
        gc.collect()
        gc.freeze()  # forks then share what is loaded
        gc.disable()
        running: dict[int, tuple[Mutant, float, int]] = {}
        with self.results.open("a", encoding="utf-8") as out:
            while waiting or running:
                while waiting and len(running) < self.jobs:
                    mutant = waiting.pop(0)
                    read, write = os.pipe()
                    pid = os.fork()
                    if pid == 0:
                        try:
                            some = [item for item in items if not mutant.scope or mutant.scope in reached[item.nodeid]]
                            some.sort(key=lambda item: self._rank(mutant.scope, item.nodeid))
                            self._run(mutant, some, [SECONDS + TIMES * took[item.nodeid] for item in some], write)
                        finally:
                            os._exit(BROKEN)
                    os.close(write)
                    running[pid] = mutant, time.monotonic(), read
                pid, status = os.wait()
                mutant, begun, read = running.pop(pid)
                by = os.read(read, 1000).decode() or ("time" if os.WIFSIGNALED(status) else "")
                os.close(read)
                if os.WIFEXITED(status) and os.WEXITSTATUS(status) not in (SURVIVED, KILLED):
                    pytest.exit(f"the tool itself failed on {mutant.key}", 1)
                seconds = round(time.monotonic() - begun, 2)
                self.killers.setdefault(mutant.scope, []).insert(0, by)
                row = dict(key=mutant.key, line=mutant.line, killed=status != 0, by=by, seconds=seconds, digest=digest)
                out.write(json.dumps(row, ensure_ascii=False) + "\n")
                out.flush()
        return True

    def _rank(self, scope: str, test: str) -> int:
        """How many mutants of a function ago a test killed one: what noticed a fault there notices the next one soon."""
        killers = self.killers.get(scope, [])
        return killers.index(test) if test in killers else len(killers)

    def _known(self, digest: str) -> set[str]:
        """Mutants with a result for the module and the tests as they are, or killed by earlier ones; other results go."""
        rows = [json.loads(line) for line in self.results.read_text("utf-8").splitlines()] if self.results.exists() else []
        rows = [row | {"digest": digest} for row in rows if row["digest"] == digest or (self.again and row["killed"])]
        rows = [row for row in rows if row["key"] not in self.only and (row["killed"] or not self.again)]
        self.results.write_text("".join(json.dumps(row, ensure_ascii=False) + "\n" for row in rows), encoding="utf-8")
        return {row["key"] for row in rows}

    def _baseline(self, items: list[pytest.Item]) -> tuple[dict[str, float], dict[str, set[str]]]:
        """Processor time of each test on the sound module, and the functions that it reaches; in a fork of its own."""
        read, write = os.pipe()
        pid = os.fork()
        if pid == 0:
            took, reached = {}, {}
            install(self.module, self.tree, "")  # put in its own place the sound module must pass as well
            for item, following in zip(items, [*items[1:], None], strict=True):
                begun, codes = time.process_time(), set()
                sys.setprofile(lambda frame, event, _, codes=codes: codes.add(frame.f_code) if event == "call" else None)
                item.ihook.pytest_runtest_protocol(item=item, nextitem=following)
                sys.setprofile(None)
                took[item.nodeid] = time.process_time() - begun
                names = [code.co_qualname.split(".") for code in codes if code.co_filename == self.module.__file__]
                parts = [[part for part in name if not part.startswith("<")] for name in names]
                reached[item.nodeid] = sorted({".".join(some[:k]) for some in parts for k in range(1, len(some) + 1)})
            with os.fdopen(write, "w") as answer:
                json.dump([self.failed, took, reached], answer)
            os._exit(0)
        os.close(write)
        with os.fdopen(read) as answer:
            failed, took, reached = json.loads(answer.read() or '["a test that ends the process", {}, {}]')
        _, status = os.waitpid(pid, 0)
        if failed or status:
            pytest.exit(f"the tests fail on the sound module: {failed}", 1)
        print(f"{self.module.__name__}: {len(items)} tests, {sum(took.values()):.1f} s", flush=True)
        return took, {name: set(functions) for name, functions in reached.items()}

    def _run(self, mutant: Mutant, items: list[pytest.Item], limits: list[float], write: int) -> None:
        """In the fork: break the module, run the tests up to the first failure, and end."""
        quiet = os.open(os.devnull, os.O_WRONLY)
        os.dup2(quiet, 1)
        os.dup2(quiet, 2)
        resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        try:
            signal.setitimer(signal.ITIMER_PROF, SECONDS)
            mutant.apply()
            install(self.module, self.tree, mutant.scope)
            for item, following, limit in zip(items, [*items[1:], None], limits, strict=True):
                signal.setitimer(signal.ITIMER_PROF, limit)
                item.ihook.pytest_runtest_protocol(item=item, nextitem=following)
                if self.failed:
                    break
        except BaseException as error:
            self.failed = repr(error)
        if self.failed:
            os.write(write, self.failed.encode()[:1000])
        os._exit(KILLED if self.failed else SURVIVED)


def _parsed(file: str) -> ast.Module:
    return ast.parse(Path(file).read_text(encoding="utf-8"))


def install(module: types.ModuleType, tree: ast.Module, scope: str) -> None:
    """Give the functions of a loaded module the code that the tree has; and where its body changed, the values too."""
    fresh = types.ModuleType(module.__name__)
    fresh.__dict__.update({name: getattr(module, name) for name in ("__file__", "__package__", "__spec__")})
    exec(compile(tree, str(module.__file__), "exec"), fresh.__dict__)
    _transplant(vars(module), vars(fresh), module.__name__)
    if scope:
        return
    for name, new in vars(fresh).items():
        old = vars(module).get(name)
        if name.startswith("__") or _function(new) or isinstance(new, type | types.ModuleType):
            continue
        for other in [other for key, other in sys.modules.items() if key.startswith("spragsym") or key.startswith("test_")]:
            if vars(other).get(name) is old:
                setattr(other, name, new)


def _transplant(old: Any, new: Any, module: str) -> None:
    for name, value in dict(new).items():
        function, before = _function(value), _function(old.get(name))
        if function and before and function.__module__ == module:
            before.__code__, before.__defaults__ = function.__code__, function.__defaults__
            before.__kwdefaults__ = function.__kwdefaults__
        elif isinstance(value, type) and value.__module__ == module and isinstance(old.get(name), type):
            _transplant(vars(old[name]), vars(value), module)
            _take_over(old[name], value)


def _take_over(old: type, new: type) -> None:
    """Plain values in the body of a class."""
    for name, value in list(vars(old).items()):
        if name.startswith("_") or not isinstance(value, int | float | str | tuple):
            continue
        if name not in vars(new):
            delattr(old, name)
        elif vars(new)[name] != value:
            setattr(old, name, vars(new)[name])


def _function(value: Any) -> types.FunctionType | None:
    """The plain function in a decorated one, a method, a property."""
    if isinstance(value, staticmethod | classmethod):
        value = value.__func__
    elif isinstance(value, property):
        value = value.fget
    elif isinstance(value, functools.cached_property):
        value = value.func
    value = inspect.unwrap(value) if callable(value) and not isinstance(value, type) else value
    return value if isinstance(value, types.FunctionType) else None
