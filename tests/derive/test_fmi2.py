"""FMUs of FMI 2.0: FMPy has nothing to say, both versions move alike, and an importer of another
house comes to the same end.
"""

import shutil
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("sympy")
pytest.importorskip("fmpy", reason="FMPy is not installed: pip install fmpy")

import fmpy
from fmpy.validation import validate_fmu

import spragsym as ss
from spragsym.cli import main
from tests.oracles.contact_pages import BLOCKS, PADS, STOPPED_ROW
from tests.oracles.coupled_frictions import SYSTEMS
from tests.oracles.user_pages import derived
from tests.support import few

pytestmark = pytest.mark.skipif(
    not shutil.which("cc"), reason="there is no C compiler on this machine"
)
#: Several contacts, coupled frictions, clocks, a turning frame, and laws with exponentials.
PAGES = {
    "pads": PADS,
    "stopped_row": STOPPED_ROW,
    "blocks": BLOCKS,
    "stack": SYSTEMS["stack"].text,
    "tied": SYSTEMS["tied"].text,
    "pushed_stack": SYSTEMS["pushed_stack"].text,
}
SHIPPED = ("sprag_rod", "forced_oscillator", "two_blocks", "trolley", "wobbling_disc", "stribeck")


def both(folder: Path, page: str) -> tuple[Path, Path]:
    """The archives of FMI 3.0 and 2.0 that one call writes."""
    out = folder / "model.fmu"
    with pytest.raises(SystemExit, match="0"):
        main(["export", "--language", "fmu", "--model", page, "--out", str(out)])
    return out, folder / "model_fmi2.fmu"


def begun(page: str) -> tuple[ss.results.Trajectory, dict[str, float]]:
    """A motion to t = 20, and what it starts from."""
    model = ss.load(page)
    values = {one: 0.9 for one in model.parameters if one not in model.base}
    start = dict.fromkeys(model.starting, 0.05)
    p = model.Parameters(**values)
    return ss.simulate(p, start=start, t_end=20.0, rtol=1e-12), values | start


@pytest.mark.by_hand(*(name for name in (*PAGES, *SHIPPED) if name not in ("stack", "sprag_rod")))
@pytest.mark.parametrize("name", few((*PAGES, *SHIPPED), "sprag_rod"))
def test_both_versions_move_as_python_does(name: str, tmp_path: Path) -> None:
    """By steps of their own, and as the rates of an integrator of the importer's, CVODE."""
    page = str(derived(PAGES[name], name)) if name in PAGES else name
    tr, values = begun(page)
    names, stepped = [*tr.model.starting], list[list[float]]()
    for archive, version in zip(both(tmp_path, page), ("3.0", "2.0"), strict=True):
        assert validate_fmu(str(archive)) == []
        assert fmpy.read_model_description(str(archive)).fmiVersion == version
        for kind, error in (("CoSimulation", 1e-8), ("ModelExchange", 1e-5)):
            found = fmpy.simulate_fmu(
                str(archive),
                fmi_type=kind,
                start_values=values,
                stop_time=20.0,
                output_interval=0.1,
                relative_tolerance=1e-12,
                output=names,
            )
            end = [float(found[one][-1]) for one in names]
            stepped += [end] if kind == "CoSimulation" else []
            np.testing.assert_allclose(end, tr.state[: len(names), -1], rtol=0, atol=error)
    assert stepped[0] == stepped[1]  # to the bit


@pytest.mark.validate
@pytest.mark.parametrize("name", [*PAGES, *SHIPPED])
def test_another_importer_comes_to_the_same_end(name: str, tmp_path: Path) -> None:
    """The co-simulation library of the Open Simulation Platform, on the FMI Library."""
    pytest.importorskip("libcosimpy", reason="libcosimpy is not installed: pip install libcosimpy")
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimManipulator import CosimManipulator
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    page = str(derived(PAGES[name], name)) if name in PAGES else name
    tr, values = begun(page)
    _, archive = both(tmp_path, page)
    step = 10**8  # nanoseconds
    run = CosimExecution.from_step_size(step)
    one = run.add_local_slave(CosimLocalSlave(str(archive), "model"))
    seen = CosimObserver.create_last_value()
    run.add_observer(seen)
    run.add_manipulator(CosimManipulator.create_override())
    places = {each.name.decode(): each.reference for each in run.slave_variables(one)}
    for what, value in values.items():
        run.real_initial_value(one, places[what], value)
    assert run.simulate_until(200 * step)
    end = seen.last_real_values(one, [places[what] for what in tr.model.starting])
    np.testing.assert_allclose(end, tr.state[: len(end), -1], rtol=0, atol=1e-8)


@pytest.mark.thorough
def test_states_are_kept_and_bad_calls_refused(tmp_path: Path) -> None:
    """A step that was taken back is taken again to the bit; derivatives are those of differences;
    what comes at a wrong time is an error, and the instance can be reset.
    """
    archive = both(tmp_path, "sprag_rod")[1]
    description = fmpy.read_model_description(str(archive))
    unit = fmpy.simulation.instantiate_fmu(fmpy.extract(str(archive)), description, "CoSimulation")
    places = {one.name: one.valueReference for one in description.modelVariables}
    state = [places["phi"], places["vphi"]]
    unit.setupExperiment(tolerance=1e-12, startTime=0.0)
    unit.enterInitializationMode()
    unit.setReal([places["phi"]], [0.05])
    unit.exitInitializationMode()
    unit.doStep(0.0, 1.0)
    kept = unit.getFMUState()
    told = unit.serializeFMUState(kept)
    unit.doStep(1.0, 1.0)
    after = unit.getReal(state)
    assert unit.getRealStatus(2) == 2.0
    unit.setFMUState(unit.deserializeFMUState(told))
    unit.doStep(1.0, 1.0)
    assert unit.getReal(state) == after
    assert unit.getBoolean([places["mode.contact"]]) in ([False], [True])
    slope = unit.getDirectionalDerivative([places["der(vphi)"]], state[:1], [1.0])
    unit.setFMUState(kept)
    unit.freeFMUState(kept)
    assert np.isfinite(slope).all()
    for wrong in (
        lambda: unit.getReal([10**6]),
        lambda: unit.setReal(state[:1], [0.1]),
        lambda: unit.doStep(5.0, 1.0),
        lambda: unit.setupExperiment(startTime=0.0),
    ):
        with pytest.raises(fmpy.fmi1.FMICallException):
            wrong()
        unit.reset()
        unit.setupExperiment(startTime=0.0)
        unit.enterInitializationMode()
        unit.exitInitializationMode()
    unit.freeInstance()


def test_one_version_is_asked_for(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    options = ["export", "--model", "sprag_rod", "--fmi", "2"]
    with pytest.raises(SystemExit, match="2"):
        main([*options, "--language", "c", "--out", str(tmp_path / "c")])
    assert "--fmi: an export to c is no FMU" in capsys.readouterr().err
    out = tmp_path / "rod.fmu"
    with pytest.raises(SystemExit, match="0"):
        main([*options, "--language", "fmu", "--out", str(out)])
    assert [path.name for path in tmp_path.iterdir()] == ["rod.fmu"]
    assert fmpy.read_model_description(str(out)).fmiVersion == "2.0"
