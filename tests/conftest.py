"""Settings of all tests."""

import ctypes
import os
import pickle
import re
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from typing import Any, TypeAlias

import numpy as np
import pytest
from filelock import FileLock
from hypothesis import settings
from hypothesis.internal.conjecture import providers

Once: TypeAlias = Callable[[str, Callable[[], Any]], Any]
Begin: TypeAlias = Callable[..., "subprocess.Popen[Any]"]
Run: TypeAlias = Callable[..., str]

# The same numbers in every run, so that a failure is one everywhere: a few in `make test`, three
# times as many in `make thorough`, which sets HYPOTHESIS_PROFILE=all. HYPOTHESIS_PROFILE=search looks
# for new ones.
settings.register_profile("repeat", derandomize=True, deadline=None, max_examples=30)
settings.register_profile("all", derandomize=True, deadline=None, max_examples=100)
settings.register_profile("search", deadline=None, max_examples=2000)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "repeat"))
# By itself hypothesis also tries constants that stand in the modules that a process has imported:
# other numbers beside other tests, and seconds in each worker of a fresh clone.
if os.environ.get("HYPOTHESIS_PROFILE") != "search" and hasattr(providers, "_get_local_constants"):
    providers._get_local_constants = lambda none=providers._local_constants: none


#: Files that take longest begin first, so that no worker is left with one of them when the others
#: have nothing to do.
LONGEST = (
    "test_documents",
    "test_explorer_pages",
    "test_explorer",
    "test_cycles",
    "test_packaging",
    "test_models_statics",
    "test_studies",
    "test_commands",
    "test_onset_curves",
    "test_figures",
    "test_sweeps",
    "test_cli",
    "test_failures",
    "test_digits",
    "test_exports",
    "test_criticality",
    "test_check",
    "test_theorem",
    "test_design",
    "test_dynamics",
    "test_page_laws",
    "test_models_certificates",
    "test_questions",
    "test_machines",
    "test_c99",
    "test_javascript",
    "test_pages",
)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The order of files, within each of which it stays; and the marks of parameters that take
    long.
    """
    for item in items:
        mark = item.get_closest_marker("by_hand")
        if mark and re.match(rf"({'|'.join(map(re.escape, mark.args))})\b", item.callspec.id):  # type: ignore[attr-defined]
            item.add_marker("validate")
    items.sort(
        key=lambda item: (
            LONGEST.index(item.path.stem) if item.path.stem in LONGEST else len(LONGEST)
        )
    )


# ----------------------------------------------------------------------------------------------
# what is computed once


@pytest.fixture(scope="session")
def once(tmp_path_factory: pytest.TempPathFactory) -> Once:
    """``once(name, compute)``: what a computation gives, made by the first test of a run that asks
    and kept for all others.
    """
    folder = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        folder = folder.parent  # of the run, shared by its workers

    def given(name: str, compute: Callable[[], Any]) -> Any:
        file = folder / f"{name}.pickle"
        with FileLock(file.with_suffix(".lock")):
            if not file.is_file():
                file.write_bytes(pickle.dumps(compute()))
        return pickle.loads(file.read_bytes())  # noqa: S301  # written above

    return given


@pytest.fixture
def checked(once: Once, monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """The rows of the check against the article; until the test ends commands take them instead of
    deriving them again.
    """
    pytest.importorskip("sympy")
    from spragsym.derive.kang_nam import ledger

    rows: list[Any] = once("check", ledger.run)
    monkeypatch.setattr(ledger, "run", lambda: rows)
    return rows


@pytest.fixture(scope="session")
def c_library(once: Once) -> ctypes.CDLL:
    """The C target, without optimization: compiled fastest, and the same bits."""
    from tests.oracles import c_target

    compiler = c_target.compiler()
    if compiler is None:
        pytest.skip("no C compiler on this machine")
    return c_target.load(
        once("c_target", lambda: c_target.compiled(compiler, ("-O0", "-ffp-contract=off")))
    )


@pytest.fixture
def silent() -> Iterator[None]:
    """Arrays may hold NaN and infinities, of which NumPy says nothing."""
    with np.errstate(all="ignore"):
        yield


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    """``run(*words, code=0)``: what a command prints on stdout; on stderr, if it fails."""
    from spragsym.cli import main

    def printed(*words: str, code: int = 0) -> str:
        with pytest.raises(SystemExit) as stop:
            main(list(words))
        told = capsys.readouterr()
        assert stop.value.code == code, told.err
        return told.err if code else told.out

    return printed


# -----------------------------------------------------------------------------------------
# processes that tests start

_LIBC = ctypes.CDLL(None) if sys.platform == "linux" else None
_PR_SET_PDEATHSIG = 1


def _as_from_a_terminal() -> None:
    """Ctrl-C ends a process, also where these tests run under nohup; and it does not outlive them,
    even if they are killed.
    """
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    if _LIBC is not None:
        _LIBC.prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)


@pytest.fixture
def begin() -> Iterator[Begin]:
    """``subprocess.Popen`` whose processes, and those that they started, end with the test,
    whatever happens.
    """
    started: list[subprocess.Popen[Any]] = []
    posix: dict[str, Any] = (
        {"preexec_fn": _as_from_a_terminal, "start_new_session": True} if os.name == "posix" else {}
    )

    def popen(call: list[str], **options: Any) -> subprocess.Popen[Any]:
        started.append(subprocess.Popen(call, **posix, **options))
        return started[-1]

    try:
        yield popen
    finally:
        for process in started:
            _end(process)


def _end(process: subprocess.Popen[Any]) -> None:
    if process.poll() is None:
        if os.name == "posix":
            os.killpg(process.pid, signal.SIGKILL)
        process.kill()
        process.wait()
    for pipe in (process.stdin, process.stdout, process.stderr):
        if pipe is not None:
            pipe.close()


@pytest.fixture
def ctrl_c() -> Iterator[None]:
    """SIGINT raises KeyboardInterrupt in this process, also where these tests run under nohup."""
    former = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, former)
