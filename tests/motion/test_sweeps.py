"""Sweeps: the same bits whoever computes them and however often they are interrupted."""

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.motion import Event, simulate
from spragsym.motion.sweeps import Sweep, many, rms_sweep
from tests.support import ROOT, needs_posix

pytest.importorskip("xarray")
P = ss.Parameters.article(theta0=np.radians([35.0, 40.0, 42.0, 49.0, 60.0, 100.0]))
SHORT = {"V": 0.5, "d": 10.0, "t_end": 60.0, "transient": 20.0}


def assert_same(one: Sweep, other: Sweep) -> None:
    """To the last bit."""
    for name in (*one.measured, "regime", "equilibrium", "reason"):
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name), err_msg=name)


@pytest.mark.parametrize("backend", [None, pytest.param("scipy", marks=pytest.mark.thorough)])
def test_a_sweep_is_a_map_of_simulate(backend: str | None) -> None:
    p = P.replace(theta0=P.theta0[::2])
    found = rms_sweep(p, **SHORT, rtol=1e-13, backend=backend)
    for i, theta0 in enumerate(p.theta0):
        tr = simulate(
            p.replace(theta0=theta0), V=0.5, d=10.0, t_end=60.0, rtol=1e-13, backend=backend
        ).after(20.0)
        assert found.rms[i] == pytest.approx(tr.rms(0.0), rel=1e-10)
        assert found.spread[i] == pytest.approx(tr.rms(0.0, about="mean"), rel=1e-10)
        assert found.largest[i] == pytest.approx(tr.largest(0.0), rel=1e-10)
        assert found.mean[i] == pytest.approx(tr.mean(0.0), rel=1e-10)
        assert found.contact_lost[i] == len(tr.events.of(Event.CONTACT_LOST))


def test_axes_of_a_table_are_what_varies_along_them() -> None:
    table = rms_sweep(P.replace(mu0=[[0.4], [0.5]]), V=0.5, d=10.0, t_end=1.0).to_dataset()
    assert dict(table.rms.sizes) == {"mu0": 2, "theta0": 6}
    assert table.theta0.dims == table.theta0_deg.dims == ("theta0",)


@pytest.mark.thorough
def test_the_same_bits_from_any_map() -> None:
    one = rms_sweep(P, **SHORT)
    assert_same(one, rms_sweep(P, **SHORT, workers=2))
    assert_same(one, rms_sweep(P, **SHORT, workers=map))
    with ThreadPoolExecutor(3) as pool:
        assert_same(one, rms_sweep(P, **SHORT, workers=pool.map))
        # Futures, as an engine's own map gives them.
        assert_same(
            one,
            rms_sweep(
                P,
                **SHORT,
                workers=lambda function, points: [pool.submit(function, p) for p in points],
            ),
        )


# ------------------------------------------------------------------------------------------------
# the store


def interrupted(path: Path, points: int) -> Path:
    """Leave a sweep to ``path`` as a kill does, after some points; its journal."""
    written: list[int] = []
    partial = path.with_name(path.name + ".partial")

    def some(function: Callable[[object], object], tasks: list[object]) -> Iterator[object]:
        for task in tasks[:points]:
            written.append(
                partial.read_bytes().count(b"\n")
            )  # each point is in the file before the next is asked for
            yield function(task)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        rms_sweep(P, **SHORT, store=path, workers=some)
    assert written[1:] == [written[0] + 1 + i for i in range(len(written) - 1)]
    return partial


@pytest.mark.parametrize(
    ("cut", "ending"),
    [
        (0, "csv"),
        (7, "csv"),
        *(
            pytest.param(*one, marks=pytest.mark.thorough)
            for one in ((0, "nc"), (1, "csv"), (1, "nc"), (7, "nc"))
        ),
    ],
)
def test_a_sweep_goes_on_where_it_stopped(tmp_path: Path, ending: str, cut: int) -> None:
    whole, path = tmp_path / f"whole.{ending}", tmp_path / f"rms.{ending}"
    expected = rms_sweep(P, **SHORT, store=whole)
    partial = interrupted(path, 3)
    if cut:  # a kill in the middle of a line
        partial.write_bytes(partial.read_bytes()[:-cut])
    interrupted(path, 1)
    assert not path.exists()
    computed = []

    def counting(function: Callable[[object], object], tasks: list[object]) -> Iterator[object]:
        computed.extend(tasks)
        return map(function, tasks)

    for _ in ("computed", "loaded"):
        assert_same(expected, rms_sweep(P, **SHORT, store=path, workers=counting))
        assert len(computed) == (3 if cut else 2)
        assert path.read_bytes() == whole.read_bytes()
        assert not partial.exists()


@pytest.mark.thorough
def test_a_store_made_by_other_code_is_another(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Be it a journal or a result."""
    path = tmp_path / "rms.nc"
    interrupted(path, 2)
    for _ in ("journal", "result"):
        with monkeypatch.context() as patch:
            patch.setattr(many, "RECORDS", many.RECORDS + 1)
            with pytest.raises(ss.errors.ParameterError, match="other code"):
                rms_sweep(P, **SHORT, store=path)
        rms_sweep(P, **SHORT, store=path)


@pytest.mark.thorough
@needs_posix
def test_ctrl_c_ends_cleanly_and_says_how_to_go_on(
    tmp_path: Path, begin: Callable[..., subprocess.Popen[str]]
) -> None:
    partial = tmp_path / "rms.nc.partial"
    motions = [
        "--theta0",
        "1:179:61",
        "--t-end",
        "60",
        "--transient",
        "45",
        "--backend",
        "scipy",
        "-j",
        "2",
        "-q",
    ]
    call = [sys.executable, "-m", "spragsym", "sweep", *motions, "-o", str(tmp_path / "rms.nc")]
    process = begin(call, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline and not (partial.exists() and partial.stat().st_size > 1000):
        time.sleep(0.001)
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does
    _, stderr = process.communicate(timeout=30)
    assert process.returncode == 130
    points = [
        json.loads(line.partition(" ")[2])
        for line in partial.read_text(encoding="utf-8").splitlines()
    ]
    numbers = [point[0] for point in points if isinstance(point, list)]
    assert len(set(numbers)) == len(numbers) > 0
    kept = (
        f"{len(numbers)} of 61 points are kept in {partial}, and the same call goes on from there"
    )
    assert stderr == f"spragsym: interrupted; {kept}\n"


@pytest.mark.thorough
@needs_posix
def test_the_page_on_clusters_runs(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """As written, to files of both formats, while one of the two processes is killed."""
    distributed = pytest.importorskip("distributed")
    page = (ROOT / "docs" / "howto_cluster.md").read_text(encoding="utf-8")
    cells = re.findall(
        r"^```(?:\{code-cell\} )?python\n(.*?)^```$", page, flags=re.DOTALL | re.MULTILINE
    )
    mapped, killed = distributed.Client.map, list[int]()

    def killing(client: Any, *arguments: Any) -> Any:
        found = mapped(client, *arguments)
        found[0].result()
        killed.append(client.cluster.workers[0].pid)
        os.kill(killed[0], signal.SIGKILL)
        return found

    monkeypatch.setattr(distributed.Client, "map", killing)
    names: dict[str, Any] = {"__name__": "page"}
    for cell in cells:
        exec(cell, names)
    assert (len(cells), len(killed)) == (4, 1)
    assert capsys.readouterr().out.splitlines()[1:] == ["True", "True", "True"]


@pytest.mark.thorough
def test_basins_say_by_default_what_fates_are() -> None:
    """Of a motion that decays for 10,000 units of time; with a t_end a remark counts the others."""
    p = ss.Parameters.article(theta0=np.radians(30))
    speeds = {"V": 0.5, "d": 4.0}
    found = ss.basin(p, **speeds, x=[0.1], vx=[0.0])
    fate = ss.fate(p, **speeds, start=(0.1, 0.0, 0.0, 0.0))
    assert fate.kind == "rest"
    assert [regime.name for regime, *_ in found.attractors] == ["EQUILIBRIUM"]
    assert not found.remarks
    short = ss.basin(p, **speeds, x=[0.1], vx=[0.0], t_end=200.0)
    assert [regime.name for regime, *_ in short.attractors] == ["UNSETTLED"]
    assert "1 of 1 motions have no limit by t = 200" in short.remarks[0]
