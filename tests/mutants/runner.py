"""Runs the tests of one subject against each of its mutants, each in a fork of a process that has everything loaded.

The fault goes into the functions that exist already, by their code, so that whoever imported them gets it. The tests stop at
the first failure. A mutant that takes many times the processor time of the sound module counts as killed.
"""

from __future__ import annotations

import ast
import functools
import gc
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
from .verdicts import Definitions, Journal, code_of, report, stamp

#: Memory that a mutant may take, and the processor time for one test, in seconds and in multiples of what it takes.
MEMORY, SECONDS, TIMES = 3 << 30, 0.7, 5.0
#: How a fork ends.
SURVIVED, KILLED, BROKEN = 0, 1, 3
#: What kills a mutant that can't even be loaded.
_LOADING = "loading"


class Runner:
    """A pytest plugin that puts its own loop over mutants in the place of the run of the tests."""

    def __init__(
        self, name: str, subject: dict[str, Any], results: Path, jobs: int, only: set[str], listed: set[str], quick: bool
    ) -> None:
        self.name, self.jobs, self.only, self.listed, self.quick = name, jobs, only, listed, quick
        self.module, self.prepare = importlib.import_module(subject["module"]), subject.get("prepare", [])
        self.journal = Journal(results / f"{name}.jsonl")
        self.tree = _parsed(str(self.module.__file__))
        functions = subject.get("functions", [])
        self.mutants = [mutant for mutant in mutants(self.tree) if not functions or mutant.scope in functions]
        self.failed = ""
        self.killers: dict[str, list[str]] = {}
        self.unexplained = 0

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Remember a failure."""
        if report.failed:
            self.failed = report.nodeid

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        """All mutants without a verdict that holds."""
        if self.prepare:
            module, function = self.prepare
            getattr(sys.modules[module], function)()
        took, reached = self._baseline(session.items)
        items = sorted(session.items, key=lambda item: took[item.nodeid])
        stamps = self._stamps(items, reached)
        plans = {mutant.key: self._plan(mutant, items, reached, stamps) for mutant in self.mutants}
        waiting = [mutant for mutant in self.mutants if (mutant.key in self.only if self.only else plans[mutant.key])]
        waiting = [mutant for mutant in waiting if not (self.quick and mutant.key in self.listed)]
        waiting.sort(key=lambda mutant: mutant.key in self.listed)  # what survives takes longest
        gc.collect()
        gc.freeze()  # forks then share what is loaded
        gc.disable()
        try:
            self._run_all(waiting, plans, took, stamps)
        finally:
            self._report(plans, stamps)
        return True

    def _stamps(self, items: list[pytest.Item], reached: dict[str, set[str]]) -> dict[str, str]:
        """The hash of each test, with what it names and what it reaches; and of a module that doesn't load."""
        own = Definitions(str(self.module.__file__))
        files = {str(item.path): Definitions(str(item.path)) for item in items}
        stamps = {_LOADING: stamp(ast.unparse(code_of(str(self.module.__file__))))}
        for item in items:
            test = files[str(item.path)].text([getattr(item, "originalname", item.name)])
            stamps[item.nodeid] = stamp(item.nodeid, test, own.text({name.split(".")[0] for name in reached[item.nodeid]}))
        return stamps

    def _plan(
        self, mutant: Mutant, items: list[pytest.Item], reached: dict[str, set[str]], stamps: dict[str, str]
    ) -> list[pytest.Item]:
        """The tests that a mutant has to meet still: none if its verdict holds."""
        if self.journal.killed(mutant.key, stamps) and mutant.key not in self.only:
            return []
        met = set() if mutant.key in self.only else self.journal.survived(mutant.key)
        some = [item for item in items if not mutant.scope or mutant.scope in reached[item.nodeid]]
        if not some and not met:  # reached by no test: it survives, by a test that tells nothing of it
            some = items[:1]
        return [item for item in some if stamps[item.nodeid] not in met]

    def _run_all(
        self, waiting: list[Mutant], plans: dict[str, list[pytest.Item]], took: dict[str, float], stamps: dict[str, str]
    ) -> None:
        running: dict[int, tuple[Mutant, list[pytest.Item], float, int]] = {}
        try:
            while waiting or running:
                while waiting and len(running) < self.jobs:
                    mutant = waiting.pop(0)
                    some = sorted(plans[mutant.key], key=lambda item: self._rank(mutant, item.nodeid))
                    read, write = os.pipe()
                    pid = os.fork()
                    if pid == 0:
                        try:
                            self._run(mutant, some, [SECONDS + TIMES * took[item.nodeid] for item in some], write)
                        finally:
                            os._exit(BROKEN)
                    os.close(write)
                    running[pid] = mutant, some, time.monotonic(), read
                pid, status = os.wait()
                mutant, some, begun, read = running.pop(pid)
                told = os.read(read, 1 << 16).decode()
                os.close(read)
                if os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGINT:
                    raise KeyboardInterrupt
                if os.WIFEXITED(status) and os.WEXITSTATUS(status) not in (SURVIVED, KILLED):
                    pytest.exit(f"the tool itself failed on {mutant.key}", 1)
                by = "" if not status else some[told.count("\n") - 1].nodeid if told else _LOADING
                if by:
                    self.killers.setdefault(mutant.scope, []).insert(0, by)
                met = {stamps[item.nodeid] for item in some} | self.journal.survived(mutant.key)
                self.journal.add(mutant.key, by, {stamps[by]} if by else met, time.monotonic() - begun)
        finally:
            for pid in running:
                os.kill(pid, signal.SIGKILL)
                os.waitpid(pid, 0)

    def _report(self, plans: dict[str, list[pytest.Item]], stamps: dict[str, str]) -> None:
        lines = {mutant.key: mutant.line for mutant in self.mutants}
        killed = {key for key in lines if self.journal.killed(key, stamps)}
        met = {key: self.journal.survived(key) for key in lines}
        run = {key for key in lines if met[key] and all(stamps[item.nodeid] in met[key] for item in plans[key])} | killed
        self.unexplained = report(self.name, lines, killed, run, self.listed)

    def _rank(self, mutant: Mutant, test: str) -> int:
        """What killed this mutant before; then, how many mutants of its function ago a test killed one: it may do so again."""
        killers = self.killers.get(mutant.scope, [])
        if test == self.journal.killer(mutant.key):
            return -1
        return killers.index(test) if test in killers else len(killers)

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
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        try:
            signal.setitimer(signal.ITIMER_PROF, SECONDS)
            mutant.apply()
            install(self.module, self.tree, mutant.scope)
            for item, following, limit in zip(items, [*items[1:], None], limits, strict=True):
                signal.setitimer(signal.ITIMER_PROF, limit)
                os.write(write, b"\n")  # a byte for each test that was begun
                item.ihook.pytest_runtest_protocol(item=item, nextitem=following)
                if self.failed:
                    break
        except BaseException as error:
            self.failed = repr(error)
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
