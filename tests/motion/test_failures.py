"""What the machine does to a sweep: never a wrong number, never a wait without end, one clear
error, and no work lost.
"""

import itertools
import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.core.errors import SweepError
from spragsym.files.journal import path_of
from spragsym.motion import integrators
from spragsym.motion.sweeps import rms_sweep
from tests.oracles import sweep_attacks as attack
from tests.support import ROOT, needs_posix

pytest.importorskip("xarray")
P, SHORT = attack.P, attack.SHORT
Begin = Callable[..., "subprocess.Popen[str]"]


@pytest.fixture(scope="module")
def recorded() -> attack.Recorded:
    """Every point, computed once."""
    computed = attack.Recorded()
    rms_sweep(P, **SHORT, workers=computed)
    return computed


def points_of(path: Path) -> list[list[Any]]:
    """Points in a journal."""
    lines = [
        json.loads(line.partition(" ")[2])
        for line in path_of(path).read_text(encoding="utf-8").splitlines()
    ]
    return [line for line in lines if isinstance(line, list)]


# ------------------------------------------------------------------------------------------------
# what is no motion's failure is no result


def failing_at(monkeypatch: pytest.MonkeyPatch, number: int, failure: Callable[[], object]) -> None:
    """Have the motion of one point run into a failure."""
    measure, called = integrators.measure, itertools.count()

    def fails(*arguments: Any) -> Any:
        if of_points(arguments[0]) and next(called) == number:
            failure()
        return measure(*arguments)

    monkeypatch.setattr(integrators, "measure", fails)


def of_points(problems: Sequence[Any]) -> bool:
    """Whether motions are those of points, and not followed on from there to see what they near."""
    return any(problem.t_record for problem in problems)


def raising(error: BaseException) -> Callable[[], object]:
    """A failure that is an exception."""
    return lambda: (_ for _ in ()).throw(error)


@pytest.mark.parametrize("workers", [1, map])
@pytest.mark.parametrize(
    "error",
    [MemoryError(), ImportError("no heyoka"), OSError(12, "no memory"), RuntimeError("a mistake")],
)
def test_failures_of_the_machine_stop_the_run(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    error: Exception,
    workers: Any,
    recorded: attack.Recorded,
) -> None:
    path = tmp_path / "rms.csv"
    with monkeypatch.context() as patch:
        failing_at(patch, 3, raising(error))
        with pytest.raises(
            SweepError, match=f"theta0 = .*{type(error).__name__}.*3 of 12 points are kept in "
        ):
            rms_sweep(P, **SHORT, store=path, workers=workers)
    assert not path.exists()
    assert [(point[0], point[2]) for point in points_of(path)] == [(0, ""), (1, ""), (2, "")]
    expected = rms_sweep(P, **SHORT, workers=recorded)
    assert attack.same(expected, rms_sweep(P, **SHORT, store=path, workers=recorded))


def test_a_failure_of_the_motion_is_a_result(monkeypatch: pytest.MonkeyPatch) -> None:
    measure, called = integrators.measure, itertools.count()

    def stops(*arguments: Any) -> Any:
        found = measure(*arguments)
        return (
            [ss.errors.ConvergenceError("it cannot be followed"), *found[1:]]
            if of_points(arguments[0]) and next(called) == 3
            else found
        )

    monkeypatch.setattr(integrators, "measure", stops)
    found = rms_sweep(P, **SHORT)
    np.testing.assert_array_equal(np.isnan(found.rms), np.arange(12) == 3)
    assert found.reason[3] == "ConvergenceError: it cannot be followed"


# ------------------------------------------------------------------------------------------------
# workers


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("heyoka", "message"),
    [
        (
            "raise ImportError('it is not on this machine')",
            "ImportError: it is not on this machine",
        ),
        ("raise MemoryError", "MemoryError"),
        pytest.param(
            "import os, signal; os.kill(os.getpid(), signal.SIGKILL)",
            "ended by SIGKILL",
            marks=needs_posix,
        ),
        (
            "import os; print('LLVM ERROR: out of memory', flush=True); os._exit(3)",
            "exit code 3.*LLVM ERROR",
        ),
    ],
)
def test_a_worker_that_fails_is_one_error_at_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, heyoka: str, message: str
) -> None:
    pytest.importorskip("heyoka")
    (tmp_path / "heyoka.py").write_text(heyoka, encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)  # for the workers: this process has the other one
    with pytest.raises(SweepError, match=message):
        rms_sweep(P, **SHORT, workers=2, backend="heyoka", store=tmp_path / "rms.csv")
    assert not (tmp_path / "rms.csv").exists()
    assert points_of(tmp_path / "rms.csv") == []


#: Stands before heyoka in a worker: the same package, but the fourth motion of the process is
#: killed in its midst.
KILLED = """
import importlib, os, signal, sys
sys.path.pop(0)
del sys.modules["heyoka"]
importlib.import_module("heyoka")
from spragsym.motion import integrators
measure, begun = integrators.measure, [1]  # this is imported within the first motion
def killed(motions, backend):
    begun[0] += motions[0].t_record > 0  # a motion of the sweep, none that its judgement runs on
    if begun[0] == 4:
        os.kill(os.getpid(), signal.SIGKILL)
    return measure(motions, backend)
integrators.measure = killed
"""


@pytest.mark.thorough
@pytest.mark.skipif(sys.platform != "linux", reason="lists processes as Linux does")
def test_a_worker_killed_in_the_midst_is_one_error_and_its_work_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("heyoka")
    p, path = P.replace(theta0=np.radians(np.linspace(30.0, 60.0, 20))), tmp_path / "rms.csv"
    options, others = (
        {**SHORT, "backend": "heyoka"},
        attack.children(os.getpid()),
    )  # those of tests before
    (tmp_path / "heyoka.py").write_text(KILLED, encoding="utf-8")
    with monkeypatch.context() as patch:
        patch.syspath_prepend(tmp_path)  # for the workers: this process has the other one
        with pytest.raises(SweepError, match=r"ended by SIGKILL.* of 20 points are kept"):
            rms_sweep(p, **options, workers=2, store=path)
    kept = len(points_of(path))
    assert 3 <= kept <= 6  # three of the one that was noticed, and up to three of the other
    assert set(attack.children(os.getpid())) <= set(others)
    computed = attack.Recorded()
    found = rms_sweep(p, **options, store=path, workers=computed)
    assert len(computed.answers) == 20 - kept
    assert attack.same(found, rms_sweep(p, **options))


@pytest.mark.thorough
@pytest.mark.skipif(sys.platform != "linux", reason="lists processes as Linux does")
def test_workers_end_with_their_parent(tmp_path: Path, begin: Begin) -> None:
    call = [
        sys.executable,
        "-m",
        "spragsym",
        "sweep",
        "--theta0",
        "49,50",
        "--t-end",
        "1e6",
        "--backend",
        "scipy",
        "-j",
        "2",
    ]
    process = begin([*call, "-q", "-o", str(tmp_path / "rms.csv")])
    wait_for(lambda: len(attack.children(process.pid)) == 2)
    workers = attack.children(process.pid)
    time.sleep(0.5)
    process.kill()
    process.wait()
    wait_for(lambda: not any(_runs(worker) for worker in workers))


def _runs(pid: int) -> bool:
    try:
        return (
            Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[0]
            != "Z"
        )
    except FileNotFoundError:
        return False


def wait_for(condition: Callable[[], bool], seconds: float = 30.0) -> None:
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline
        time.sleep(0.02)


# ------------------------------------------------------------------------------------------------
# damage


@pytest.mark.thorough
def test_damaged_journals_give_the_right_numbers_or_are_refused(tmp_path: Path) -> None:
    outcomes = attack.attack_journals(np.random.default_rng(1), tmp_path, 60)
    assert sum(outcomes.values()) == 60
    assert outcomes["healed, and named"] > 20


@pytest.mark.thorough
def test_damaged_results_are_refused(tmp_path: Path) -> None:
    outcomes = attack.attack_files(np.random.default_rng(2), tmp_path, 80)
    assert outcomes[".nc: refused, and named"] > 35
    assert outcomes[".csv: refused, and named"] > 35


# ------------------------------------------------------------------------------------------------
# links, full disks


@pytest.mark.thorough
@pytest.mark.parametrize(("limit", "ending"), [(1500, "csv"), (4500, "nc")])
def test_a_full_disk_keeps_what_is_good(
    tmp_path: Path, begin: Begin, recorded: attack.Recorded, limit: int, ending: str
) -> None:
    """No file may be longer than the limit: the journal breaks off, or the result does."""
    pytest.importorskip("resource")
    path, whole = tmp_path / f"rms.{ending}", tmp_path / f"whole.{ending}"
    rms_sweep(P, **SHORT, store=whole, workers=recorded)
    code = (
        "import sys, resource; resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[1]),) * 2)\n"
        "from tests.oracles.sweep_attacks import *\n"
        "try: rms_sweep(P, **SHORT, store=sys.argv[2])\n"
        "except StoreError as error: sys.exit(str(error))"
    )
    call = [sys.executable, "-B", "-c", code, str(limit), str(path)]
    process = begin(call, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    _, said = process.communicate(timeout=60)
    assert process.returncode == 1
    assert said.count("\n") == 1, said
    assert "cannot be written: File too large; make room" in said
    assert f"{len(points_of(path))} of 12 points are kept in {path_of(path)}" in said
    assert (len(points_of(path)) == 12) == (limit == 4500)
    rms_sweep(P, **SHORT, store=path, workers=recorded)
    assert path.read_bytes() == whole.read_bytes()
    assert sorted(file.name for file in tmp_path.iterdir()) == sorted([path.name, whole.name])
