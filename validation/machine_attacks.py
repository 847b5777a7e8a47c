"""Attacks on sweeps from outside: workers killed, disks filled; what became of each is counted.

A wrong number, a wait without end, or an error that is not spragsym's own ends one with that error.
Filled disks are small file systems in memory, which take root.
"""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import numpy as np

from spragsym.core.errors import StoreError
from spragsym.files.journal import path_of
from spragsym.motion.sweeps import rms_sweep
from tests.oracles.sweep_attacks import SHORT, P, Recorded, children, named, same


@contextmanager
def small_disk(kilobytes: int) -> Iterator[Path]:
    """A file system of its own, in memory; PermissionError without the right to mount one."""
    with tempfile.TemporaryDirectory() as folder:
        call = ["mount", "-t", "tmpfs", "-o", f"size={kilobytes}k", "tmpfs", folder]
        here = sys.platform == "linux" and shutil.which("mount")
        if not here or subprocess.run(call, capture_output=True, timeout=10).returncode:
            raise PermissionError("no file system can be mounted here")
        try:
            yield Path(folder)
        finally:
            subprocess.run(["umount", folder], check=True, timeout=10)


def attack_disks(rng: np.random.Generator, count: int) -> Counter[str]:
    """Fill the disk after any number of points, but for a few bytes, and go on when there is room
    again.
    """
    recorded, outcomes = Recorded(), Counter[str]()
    expected = rms_sweep(P, **SHORT, workers=recorded)
    for k in range(count):
        with small_disk(400) as folder:
            path = folder / f"rms.{('nc', 'csv')[k % 2]}"
            ballast = folder / "ballast"

            def fill(ballast: Path = ballast, spare: int = int(rng.integers(0, 3)) * 4096) -> None:
                with open(ballast, "wb", buffering=0) as file:
                    try:
                        while file.write(bytes(4096)) == 4096:
                            pass
                    except OSError:
                        file.truncate(max(0, file.tell() - spare))

            recorded.limit, recorded.at_limit = int(rng.integers(len(P.theta0) + 1)), fill
            try:
                rms_sweep(P, **SHORT, store=path, workers=recorded)
                outcomes["room enough"] += 1
            except StoreError as error:
                named(error, path, "points are kept")
                outcomes["said so"] += 1
            recorded.limit = -1
            ballast.unlink(missing_ok=True)
            assert same(rms_sweep(P, **SHORT, store=path, workers=recorded), expected)
            assert same(rms_sweep(P, **SHORT, store=path, workers=recorded), expected)  # as loaded
            assert [file.name for file in folder.iterdir()] == [path.name]
    return outcomes


def attack_workers(rng: np.random.Generator, folder: Path, count: int) -> Counter[str]:
    """Kill one of two workers, or every fourth time their parent, at a random moment: one line, at
    once, and the same command finishes the same file.
    """
    outcomes = Counter[str]()
    grid = ["--theta0", "20:160:21", "--t-end", "1000", "--transient", "500", "-q", "-j", "2"]
    command = [sys.executable, "-m", "spragsym", "sweep", *grid, "-o"]
    _finish([*command, folder / "whole.nc"])
    for k in range(count):
        path = folder / f"killed{k}.nc"
        process = subprocess.Popen(
            [*command, path], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )
        try:
            wanted, pause = int(rng.integers(21)), rng.uniform(0.0, 0.02)
            while process.poll() is None and (
                _finished_points(path) < wanted or not children(process.pid)
            ):
                time.sleep(0.001)
            time.sleep(pause)
            for victim in [process.pid] if k % 4 == 3 else children(process.pid)[:1]:
                with suppress(ProcessLookupError):  # it has just ended
                    os.kill(victim, signal.SIGKILL)
            killed = time.perf_counter()
            _, said = process.communicate(timeout=60)
        finally:
            process.kill()
        if process.returncode == -signal.SIGKILL:
            outcomes["parent killed"] += 1
        elif process.returncode:
            assert process.returncode == 1, said
            assert said.startswith("spragsym: "), said
            assert said.count("\n") == 1, said
            assert "worker process" in said, said
            outcomes["said so"] += 1
            outcomes["slowest answer, ms"] = max(
                outcomes["slowest answer, ms"], round(1e3 * (time.perf_counter() - killed))
            )
        else:
            outcomes["had finished"] += 1
        _finish([*command, path])
        assert path.read_bytes() == (folder / "whole.nc").read_bytes()
    return outcomes


def _finished_points(path: Path) -> int:
    try:
        return path_of(path).read_bytes().count(b"\n") - 1
    except FileNotFoundError:
        return -1


def _finish(command: list[Any]) -> None:
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
