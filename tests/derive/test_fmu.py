"""The FMU target: FMPy has nothing to say and simulates as Python does, in units too; bad calls get
their status.
"""

import io
import math
import os
import re
import shlex
import shutil
import subprocess
import zipfile
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("sympy")
pytest.importorskip("fmpy", reason="FMPy is not installed: pip install fmpy")

import fmpy
from fmpy.validation import validate_fmu

import spragsym as ss
from spragsym.cli import main
from spragsym.cli.export import _of_page
from spragsym.derive.emit.targets import fmu
from spragsym.explorer import explorer_page
from spragsym.models.load import shipped
from tests.conformance.models import answers, starts
from tests.explorer.pages import moved
from tests.oracles.contact_pages import BLOCKS, PADS, STOPPED_ROW
from tests.oracles.coupled_frictions import SYSTEMS, drawn
from tests.oracles.user_pages import derived
from tests.shown import DOCS, programs, run
from tests.support import ROOT, few

CC = shutil.which("cc") or ""
pytestmark = pytest.mark.skipif(not CC, reason="there is no C compiler on this machine")
BRAKE = ROOT / "spragsym" / "report" / "brake.toml"


def exported(folder: Path, *options: str) -> str:
    """What the command writes, with nothing for FMPy to find wrong."""
    out = folder / "brake.fmu"
    with pytest.raises(SystemExit, match="0"):
        main(["export", "--language", "fmu", "--fmi", "3", *options, "--out", str(out)])
    assert validate_fmu(str(out)) == []
    return str(out)


def stepped(
    file: str, values: dict[str, float], names: list[str], t_end: float
) -> tuple[list[float], list[float]]:
    """The state at the end, by steps of Co-Simulation, and times of events, each of which turns one
    of the flags.
    """
    description, options = (
        fmpy.read_model_description(file),
        {"early_return_allowed": True, "event_mode_used": True},
    )
    references = {one.name: one.valueReference for one in description.modelVariables}
    fmu = fmpy.simulation.instantiate_fmu(
        fmpy.extract(file), description, "CoSimulation", **options
    )
    fmu.enterInitializationMode(tolerance=1e-12, startTime=0.0)
    fmu.setFloat64([references[name] for name in values], list(values.values()))
    fmu.exitInitializationMode()
    flags = [place for name, place in references.items() if name.startswith("mode.")]
    t, events = 0.0, []
    fmu.enterStepMode()
    while t < t_end:
        needed, _, _, t = fmu.doStep(t, min(1.0, t_end - t))
        if needed:
            before = fmu.getBoolean(flags)
            fmu.enterEventMode()
            fmu.updateDiscreteStates()
            events += [t] * (fmu.getBoolean(flags) != before)
            fmu.enterStepMode()
    return fmu.getFloat64([references[name] for name in names]), events


def outputs(tr: ss.results.Trajectory) -> dict[str, float]:
    """Forces, energy and power at the end of a motion, by the names that they have in an FMU."""
    model = tr.model
    told = {"energy": tr.energy()[-1], "power": tr.power()[-1]}
    rubbing = [one["name"] for one in model.frictions]
    for name, gap in ((one["name"], one["gap"]) for one in model.contacts):
        behind = f".{name}" if name else ""
        if gap or name in rubbing:
            told[f"force.normal{behind}"] = tr.contact_force(name)[-1]
        if name in rubbing:
            told[f"force.friction{behind}"] = tr.friction_force(name)[-1]
    turned = [torsion["spring"] + 1 for torsion in model.about["torsions"]]
    for count, spring in enumerate(model.about["springs"], 1):
        if count in turned:  # a line without a spring along it
            continue
        told[f"force.spring{count}"] = tr.spring_force(spring["name"])[-1]
    return told


@pytest.mark.by_hand(
    "cubic", "hertz", "inclined", "kang_nam", "mode", "pad", "stick_slip", "stribeck"
)
@pytest.mark.parametrize("name", few(shipped(), "sprag_rod"))
def test_an_fmu_moves_as_python_does(name: str, tmp_path: Path) -> None:
    """Lift-off, reversals of the slip, sticking, a torsion spring that is counted on; Model
    Exchange as FMPy's solver can.
    """
    model = ss.load(name)
    if not answers(model, "export to fmu", lambda: _of_page(model, "fmu", None, ())):
        return
    file = exported(tmp_path, "--model", name)
    values = {one: 0.9 for one in model.parameters if one not in model.base}
    p, names = model.Parameters(**values), [*model.starting]
    options = {
        "fmi_type": "ModelExchange",
        "stop_time": 100.0,
        "output_interval": 0.1,
        "relative_tolerance": 1e-12,
    }
    usual = [0.05] * len(names)
    for begun in [usual] if model.clock else starts(p, usual):
        tr = ss.simulate(p, start=begun, t_end=100.0, rtol=1e-13)
        start = values | dict(zip(names, begun, strict=True))
        state, events = stepped(file, start, names, 100.0)
        there = tr.state[: len(names), -1]
        np.testing.assert_allclose(state, there, rtol=1e-7, atol=1e-7)
        told = outputs(ss.simulate(p, start=begun, t_end=1.3, rtol=1e-13))
        found, _ = stepped(file, start, [*told], 1.3)
        np.testing.assert_allclose(found, [*told.values()], rtol=1e-9, atol=1e-9)
        assert tr.events is not None
        np.testing.assert_allclose(events, tr.events.t[tr.events.t > 0], rtol=0, atol=1e-8)
        found = fmpy.simulate_fmu(file, start_values=start, **options)
        np.testing.assert_allclose([found[one][-1] for one in names], there, atol=1e-5)


def test_the_clock_runs_at_its_rate_whatever_is_set(tmp_path: Path) -> None:
    """The phase is φ_0 + ω t of the importer's time, by steps and by a solver of its own."""
    file = exported(tmp_path, "--model", "forced_oscillator")
    start = {"phase": 0.4, "vphase": 5.0, "omega": 1.3, "x": 0.2}
    found, _ = stepped(file, start, ["phase", "vphase"], 7.0)
    np.testing.assert_allclose(found, [0.4 + 1.3 * 7.0, 1.3], rtol=1e-9)
    options = {"fmi_type": "ModelExchange", "stop_time": 7.0, "relative_tolerance": 1e-10}
    told = fmpy.simulate_fmu(file, start_values=start, **options)
    np.testing.assert_allclose(told["phase"], 0.4 + 1.3 * told["time"], atol=1e-6)


STEPPED = [(True, True), (True, False), (False, True), (False, False)]


@pytest.mark.parametrize(("event_mode", "early"), STEPPED)
@pytest.mark.thorough
def test_steps_are_right_with_event_mode_or_early_return_or_without(
    event_mode: bool, early: bool, stick_slip: str
) -> None:
    """As Python at the ends of equal steps; only with both does a step end at an event."""
    found = fmpy.simulate_fmu(
        stick_slip,
        fmi_type="CoSimulation",
        stop_time=20.0,
        output_interval=0.5,
        relative_tolerance=1e-12,
        use_event_mode=event_mode,
        early_return_allowed=early,
        start_values={"x": 1.5},
        output=["x", "vx"],
    )
    tr = ss.simulate(ss.load("coulomb_stick_slip").Parameters(), start=(1.5, 0.0), t_end=20.0)
    assert tr.events is not None
    between = len(np.unique(found["time"])) - 41
    assert between == (tr.events.t.size if event_mode and early else 0)
    assert tr.events.t.size > 3
    at = np.isin(found["time"], np.arange(41) / 2)
    expected = np.array([tr(t) for t in found["time"][at]])
    np.testing.assert_allclose(
        np.column_stack([found["x"][at], found["vx"][at]]), expected, atol=1e-9
    )


@pytest.mark.thorough
def test_a_driven_belt_leaves_the_mass_its_speed(stick_slip: str) -> None:
    """Stuck on a belt that slows to 0.1: x + mu_k oscillates until the speeds are equal."""
    signals = np.array(
        [(0.0, 0.5), (0.5, 0.5), (0.5, 0.1), (9.0, 0.1)], dtype=[("time", float), ("V", float)]
    )
    angle = np.linspace(0.0, 0.4, 5)
    for event_mode, early in STEPPED:
        found = fmpy.simulate_fmu(
            stick_slip,
            fmi_type="CoSimulation",
            stop_time=1.0,
            output_interval=0.1,
            input=signals,
            start_values={"vx": 0.5},
            use_event_mode=event_mode,
            early_return_allowed=early,
            output=["x", "vx", "mode.sticks"],
        )
        for after in angle[1:]:
            (*_, row) = found[np.isclose(found["time"], 0.5 + after)]
            x, v = 0.25 + 0.4, 0.5
            freely = v * np.cos(after) - x * np.sin(after)
            assert freely > 0.1
            assert not row["mode.sticks"]
            assert row["vx"] == pytest.approx(freely, abs=1e-9)
            assert row["x"] == pytest.approx(x * np.cos(after) + v * np.sin(after) - 0.4, abs=1e-9)


@pytest.fixture(scope="module")
def stick_slip(tmp_path_factory: pytest.TempPathFactory) -> str:
    model = ("--model", "coulomb_stick_slip")
    return exported(tmp_path_factory.mktemp("driven"), *model, "--input", "V", "--input", "mu_k")


@pytest.mark.parametrize("size", [1e-6, 3e4, 1e6])
def test_a_motion_of_any_size_is_the_same_scaled(size: float, stick_slip: str) -> None:
    """In lengths, speeds and forces: states and events."""
    values = {"mu_s": 0.6, "mu_k": 0.4, "V": 0.5, "x": 1.5}
    one, times = stepped(stick_slip, values, ["x", "vx"], 30.0)
    large = {name: size * value for name, value in values.items()}
    other, scaled = stepped(stick_slip, large, ["x", "vx"], 30.0)
    np.testing.assert_allclose(np.array(other) / size, one, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(scaled, times, rtol=0.0, atol=1e-9)


@pytest.mark.parametrize("V", [1e-2, 1e-6, 1e-8])
def test_slip_goes_on_from_where_a_slow_belt_uses_the_friction_up(
    V: float, stick_slip: str
) -> None:
    """On the circle about μ_k through x = μ_s, x′ = V, and told when that was met."""
    values = {"mu_s": 0.6, "mu_k": 0.4, "V": V, "x": 0.6 - 2.0 * V, "vx": V}
    state, times = stepped(stick_slip, values, ["x", "vx"], 5.0)
    rounded = 1e-9 + 3e-16 / V
    assert times == pytest.approx([2.0], abs=rounded)
    c, s = math.cos(3.0), math.sin(3.0)
    turned = 0.4 + 0.2 * c + V * s, V * c - 0.2 * s
    assert state == pytest.approx(turned, abs=rounded)


@pytest.mark.thorough
def test_what_an_importer_is_told_of_a_variable(stick_slip: str) -> None:
    """A quantity that a border has jumps at events only; the rate that sticking resets says so."""
    told = {one.name: one for one in fmpy.read_model_description(stick_slip).modelVariables}
    assert (told["V"].causality, told["V"].variability) == ("input", "discrete")
    assert (told["mu_k"].causality, told["mu_k"].variability) == ("input", "continuous")
    assert (told["mu_s"].causality, told["mu_s"].variability) == ("parameter", "tunable")
    with zipfile.ZipFile(stick_slip) as archive:
        text = archive.read("modelDescription.xml").decode()
    assert re.findall(r'name="(\S+)"[^>]* reinit="true"', text) == ["vx"]


@pytest.fixture(scope="module")
def brake(tmp_path_factory: pytest.TempPathFactory) -> str:
    return exported(tmp_path_factory.mktemp("brake"), "--data", str(BRAKE))


@pytest.mark.thorough
def test_a_brake_has_its_units(brake: str, tmp_path: Path) -> None:
    study = ss.Study.from_file(BRAKE)
    given = {
        one.name: (float(one.start), one.unit)
        for one in fmpy.read_model_description(brake).modelVariables
        if one.start
    }
    assert (given["k"], given["theta0"], given["m"]) == (
        (180.0, "N/mm"),
        (52.0, "deg"),
        (0.35, "kg"),
    )
    state, _ = stepped(brake, {}, ["x", "vx"], 100.0 * study.scales.time)
    tr = ss.simulate(study.dimensionless, t_end=100.0, rtol=1e-13)
    units = study.scales.length / np.array([1.0, study.scales.time])
    np.testing.assert_allclose(state, units * [tr.x[-1], tr.vx[-1]], rtol=1e-7)
    assert Path(exported(tmp_path, "--data", str(BRAKE))).read_bytes() == Path(brake).read_bytes()
    ((program, shown),) = (
        one for one in programs(DOCS / "howto_languages.md", "python") if "fmpy" in one[0]
    )
    assert run(f"python -c {shlex.quote(program)}", tmp_path) == shown


@pytest.mark.thorough
def test_the_ends_that_are_told_are_the_last_that_are_allowed(brake: str) -> None:
    """Open or closed: the next double beyond an end is refused, the end itself is not."""
    description = fmpy.read_model_description(brake)
    fmu = fmpy.simulation.instantiate_fmu(fmpy.extract(brake), description, "CoSimulation")
    asked = 0
    for one in description.modelVariables:
        for end, beyond in ((one.min, -math.inf), (one.max, math.inf)):
            if one.causality != "parameter" or end is None:
                continue
            asked += 1
            fmu.setFloat64([one.valueReference], [float(end)])
            with pytest.raises(fmpy.fmi1.FMICallException):
                fmu.setFloat64([one.valueReference], [math.nextafter(float(end), beyond)])
    assert asked > 8
    ends = {one.name: (one.min, one.max) for one in description.modelVariables}
    assert 0.0 < float(ends["theta0"][0]) < 1e-300
    assert 180.0 - 1e-12 < float(ends["theta0"][1]) < 180.0
    fmu.freeInstance()


def test_an_input_is_a_quantity_of_the_page(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for language, said in (("fmu", "give mu_s, mu_k, V"), ("c", "or give --language fmu")):
        options = ["--model", "coulomb_stick_slip", "--language", language, "--input", "W"]
        with pytest.raises(SystemExit, match="2"):
            main(["export", *options, "--out", str(tmp_path / "driven")])
        assert said in capsys.readouterr().err


@pytest.mark.thorough
def test_bad_calls_get_the_status_of_the_standard(tmp_path: Path) -> None:
    """And partial derivatives by states, by parameters in their units and by the units of measure
    are those of differences.
    """
    lines = BRAKE.read_text(encoding="utf-8").splitlines()
    plain = tmp_path / "plain.toml"
    plain.write_text(
        "\n".join(line for line in lines if not line.startswith("damping")), encoding="utf-8"
    )
    brake = exported(tmp_path, "--data", str(plain))
    description, sources = fmpy.read_model_description(brake), Path(fmpy.extract(brake)) / "sources"
    command = [
        CC,
        "-std=c99",
        "-fsanitize=address,undefined",
        "-fno-sanitize-recover=all",
        "-Wall",
        "-Wextra",
        "-Werror",
    ]
    files = [sources / "fmu.c", sources / "kang_nam.c", Path(__file__).with_name("fmu_driver.c")]
    subprocess.run([*command, *files, "-lm", "-o", tmp_path / "driver"], check=True)
    references = {one.name: str(one.valueReference) for one in description.modelVariables}
    asked = ("x", "der(x)", "theta0", "der(vx)", "k", "mode.contact")
    given = [description.guid, *(references[name] for name in asked), str(len(references))]
    given.append(references["force.normal"])
    done = subprocess.run([tmp_path / "driver", *given], capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


FILES = {"modelDescription.xml": "<x/>", "sources/brake.c": "int f(void) { return 1; }\n"}
FILES |= {"sources/fmu.c": "int g(void) { return 2; }\n"}


def program(folder: Path, name: str, text: str) -> Path:
    path = folder / name
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return path


@pytest.mark.skipif(os.name != "posix", reason="its programs are of the shell")
def test_the_compiler_is_the_one_that_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With a program before it, with options, in a folder with a blank; else an error in its own
    words.
    """
    seen = tmp_path / "seen"
    wrapped = 'echo "$@" > ' + f"{seen}\n"
    program(tmp_path, "ccache", wrapped + 'exec "$@"')
    program(tmp_path, "zig", wrapped + f'shift; exec {CC} "$@"')
    (tmp_path / "my tools").mkdir()
    blank = program(tmp_path / "my tools", "cc", wrapped + f'exec {CC} "$@"')
    monkeypatch.setenv("PATH", f"{tmp_path}{os.pathsep}{os.environ['PATH']}")
    for given in ("ccache cc", "zig cc", str(blank), f"'{blank}' -O1", f"ccache  {CC} -O1"):
        monkeypatch.setenv("CC", given)
        seen.unlink(missing_ok=True)
        held = zipfile.ZipFile(io.BytesIO(fmu.packed(FILES))).namelist()
        assert [name for name in held if name.startswith("binaries/")], given
        assert "-std=c99" in seen.read_text(), given
    program(tmp_path, "broken", "echo broken: no such option >&2; exit 3")
    program(tmp_path, "idle", "exit 0")
    (tmp_path / "plain").write_text("no program")
    for given, words in (
        ("no-such-cc", "no program 'no-such-cc'"),
        ("no-such-cc gcc", "no program 'no-such-cc'"),
        ("ccache no-such-cc", "ccache no-such-cc failed"),
        ("broken", "failed with exit code 3: broken: no such option"),
        ("idle", "failed with exit code 0"),
        (str(tmp_path / "plain"), "no program"),
        ("'cc", "close its quotes"),
        (f"{CC} -Wnot-c99 -fno-such-thing", "no-such-thing"),
    ):
        monkeypatch.setenv("CC", given)
        with pytest.raises(ChildProcessError, match=re.escape(words)):
            fmu.packed(FILES)


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("name", "text", "changes"),
    [
        ("pads", PADS, {}),
        ("stopped_row", STOPPED_ROW, {}),
        ("blocks", BLOCKS, {"N_2": 1.0, "beta": 1.0}),
    ],
)
def test_modes_of_several_contacts_are_entered_as_python_enters_them(
    name: str, text: str, changes: dict[str, float], tmp_path: Path
) -> None:
    """Stops that open, three frictions beside a stop, and equal blocks that slip together."""
    page = derived(text, name)
    p, file = ss.load(page).Parameters(**changes), exported(tmp_path, "--model", str(page))
    names = [*p.model.starting]
    start = dict(zip(names, [0.12] * len(names), strict=True)) | changes
    tr = ss.simulate(p, start=[0.12] * len(names), t_end=40.0, rtol=1e-13)
    assert tr.events is not None
    state, events = stepped(file, start, names, 40.0)
    np.testing.assert_allclose(state, tr.state[:, -1], atol=1e-8)
    times = tr.events.t[tr.events.t > 0]
    np.testing.assert_allclose(events, times[np.diff(times, prepend=0.0) > 1e-9], atol=1e-8)
    assert len(events) > 5


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["stack", "tied", "lifting"])
def test_coupled_frictions_move_as_in_python(name: str, tmp_path: Path) -> None:
    """Where one turns or begins to hold and another has to slip at that instant, and where several
    modes agree, as of twins that come to their limits together; on the explorer's page too.
    """
    page = derived(SYSTEMS[name].text, name)
    file, model = exported(tmp_path, "--model", str(page)), ss.load(page)
    shown = explorer_page(model) if shutil.which("node") else ""
    for seed in (1, 2):
        values, state = drawn(name, np.random.default_rng([seed, len(name)]), seed == 2)
        values = {each: values[each] for each in values if each in model.parameters}
        if name == "tied" and seed == 1:
            values |= {"a": 1.0, "n_1": 1.0, "n_2": 1.0}
            state = np.array([0.0, 0.0, values["V"], values["V"]])
        start = dict(zip(model.starting, state, strict=True))
        tr = ss.simulate(model.Parameters(**values), start=state, t_end=20.0, rtol=1e-12)
        found, events = stepped(file, start | values, [*start], 20.0)
        np.testing.assert_allclose(found, tr.state[:, -1], rtol=0, atol=1e-7)
        assert len(events) > 3
        if shown:
            ours = moved(shown, model.base | values, state.tolist(), 0.01, 2000)
            np.testing.assert_allclose(ours, tr.state[:, -1], rtol=0, atol=1e-6)
