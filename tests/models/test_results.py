"""Every result shows itself: names in completion, values in repr, rows, a frame, a dataset and a
picture.
"""

import copy
import functools
import hashlib
import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Callable
from dataclasses import is_dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.paths import first_end
from spragsym.report.example import example
from spragsym.report.friction_fit import fit_friction
from spragsym.results.equilibria import Undecided
from spragsym.results.result import Named, Result
from tests.support import LONG_MOTIONS_TAKE_MINUTES, few

P = ss.Parameters.article(theta0=np.radians([30.0, 49.0]))
ONE = ss.Parameters.article(theta0=0.5)
BELT: dict[str, Any] = {"V": 0.5, "d": 10.0, "backend": "scipy"}


def _basin() -> ss.results.Basin:
    return ss.basin(ONE, x=[0.0, 1.0], vx=[0.0, 0.1, 0.2], t_end=20.0, transient=10.0, **BELT)


SLIDING = ss.Parameters.article(theta0=np.radians(42.0))
SPEED: dict[str, float] = {"V": 0.5, "d": 10.0}


@functools.cache
def _cycle() -> ss.results.Cycle:
    return ss.cycle(SLIDING, **SPEED)


@functools.cache
def _branch() -> ss.results.CycleBranch:
    """From 42° over its doubling at 43.1°."""
    return ss.cycle_branch(
        _cycle(), vary="theta0", between={"theta0": tuple(np.radians([41.9, 43.3]))}
    )


def _doubling() -> ss.results.CycleEvent:
    return next(event for event in _branch().events if event.kind == "period_doubling")


def _fate() -> ss.results.FateBoundary:
    return ss.fate_boundary(
        ss.Parameters.article(), "theta0", between={"theta0": (0.7208, 0.7212)}, **SPEED
    )


MODEL = ss.load("kang_nam").search


@functools.cache
def _diagram() -> ss.results.Diagram:
    return ss.diagram(
        ss.load("stick_slip").Parameters(), "V", between={"V": (0.05, 0.3)}, points=60
    )


@functools.cache
def _report() -> Any:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "brake.toml")
        file.write_text(example(ss.load("kang_nam")), encoding="utf-8")
        return ss.Study.from_file(file).report(n=256)


def _of_matrices() -> Any:
    K, F = [[1.55, -0.25], [-0.25, 1.25]], [[0, 1], [0, 0]]
    return ss.matrices(np.eye(2), K, F, damping_ratio=1e-3).Parameters(mu=0.3)


#: One of each class, those within others too.
MAKERS: dict[str, Callable[[], Any]] = {
    "Parameters": lambda: P,
    "PhysicalParameters": lambda: ss.PhysicalParameters(1, 1, 1, 1, 1, 1, 1, 1, 1),
    "Scales": lambda: ss.PhysicalParameters(1, 1, 1, 1, 1, 1, 1, 1, 1).scales,
    "Equilibria": lambda: ss.equilibria(P),
    "InUnits": lambda: ss.equilibria(P).to_units(MAKERS["Scales"]()),
    "Surface": lambda: ss.kang_nam.surface(ONE, 1.0, [[0.5], [0.6]]),
    "Points": lambda: ss.folds(ONE),
    "Points of two parameters": lambda: ss.cusps(ONE),
    "CriticalLoad": lambda: ss.critical_friction(ONE.replace(beta=[0.0, 1.0])),
    "BifurcationSet": lambda: ss.bifurcation_set(ONE, n=600),
    "Curve": lambda: ss.bifurcation_set(ONE, n=600).curves[0],
    "FlutterBoundary": lambda: ss.kang_nam.flutter_boundary(ONE.replace(alpha=0.7), 50),
    "Onsets in closed form": lambda: ss.flutter_onsets(ONE.replace(alpha=0.7), damping=False),
    "StickingStates": lambda: ss.sticking_states(ss.load("coulomb_stick_slip").Parameters(V=0.0)),
    "LinearSprag": lambda: ss.kang_nam.linear_sprag(P),
    "Path": lambda: ss.quasi_static_path(
        ss.Parameters.article(mu0=0.7), "theta0", np.radians(np.arange(1.0, 180.0))
    ),
    "Jump": lambda: ss.quasi_static_path(
        ss.Parameters.article(mu0=0.7), "theta0", [0.5, 1.0]
    ).jumps[0],
    "Trajectory": lambda: ss.simulate(ONE, t_end=20.0, events=False, **BELT),
    "Outcome": lambda: ss.simulate(ONE, t_end=20.0, **BELT).outcome(),
    "Events": lambda: ss.simulate(ONE.replace(theta0=0.9), t_end=40.0, **BELT).events,
    "Sweep": lambda: ss.rms_sweep(P, t_end=20.0, **BELT),
    "Basin": _basin,
    "JumpGradient": lambda: ss.jump_gradient(P),
    "JumpMargin": lambda: ss.jump_margin(ONE, {"mu0": 0.05}),
    "JumpProbability": lambda: ss.jump_probability((ONE, ONE.replace(mu0=0.9)), n=256, rng=1),
    "Certificate": lambda: ss.certify(ONE),
    "Redesign": lambda: ss.redesign(ONE, "theta0", {"mu0": 0.8}),
    "Cycle": _cycle,
    "Phases": lambda: _cycle().phases,
    "CycleBranch": _branch,
    "CycleEvent": _doubling,
    "EventCurve": lambda: ss.cycle_events(_doubling(), vary=("theta0", "mu0"), points=1),
    "Fate": lambda: ss.fate(SLIDING, **SPEED),
    "FateBoundary": _fate,
    "FateMap": lambda: ss.fate_map(
        ss.Parameters.article(theta0=np.radians([[30.0], [35.0]]), mu0=[0.5, 0.6]), **SPEED
    ),
    "BasinBoundary": lambda: ss.basin_boundary(
        ss.Parameters.article(theta0=np.radians(40.0)), **SPEED, step=0.05, points=1
    ),
    "Lyapunov": lambda: ss.lyapunov(
        SLIDING, **SPEED, start=_cycle().state, t_end=2 * _cycle().period
    ),
    "Report": _report,
    "Points of a search": lambda: ss.folds(MODEL.Parameters(), vary="theta0"),
    "Onsets": lambda: ss.flutter_onsets(ss.load("stick_slip").Parameters(), vary="V"),
    "Path of a search": lambda: ss.quasi_static_path(MODEL.Parameters(), "theta0", [0.5, 0.6]),
    "Diagram": _diagram,
    "Sensitivity": lambda: ss.sensitivity(P, [0.5], [10.0], refine=1, t_end=20.0, backend="scipy"),
    "Path of a rod": lambda: ss.quasi_static_path(
        ss.load("sprag_rod").Parameters(theta0=0.6), "mu0", [0.0, 0.2]
    ),
    "OnsetCurves": lambda: ss.onset_curves(
        ss.load("mode_coupling").Parameters(), ("mu0", "beta"), n=3
    ),
    "Undecided": lambda: Undecided((), (0.0, 0.0), (1.0, 1.0), "two equilibria, or none"),
    "Ended": lambda: ss.folds(ss.Parameters.article())._for_file()._ended,
    "Branch": lambda: ss.figures.branches(ONE)[0],
    "Spectrum": lambda: MAKERS["Trajectory"]().spectrum(),
    "ModelEnd": lambda: first_end(ss.load("stribeck").Parameters(theta0=0.5), "theta0", (0.3, 1.5)),
    "FrictionFit": lambda: fit_friction(
        np.array([0.05, 0.1, 0.3, 1.0]), np.array([0.2, 0.3, 0.39, 0.4])
    ),
    "CycleProof": lambda: ss.precise.prove_cycle(_cycle()),
    "EquilibriumBranch": lambda: _diagram().equilibria[0],
    "Label": lambda: _diagram().labels[0],
    "State": lambda: _report().states[0],
    "JumpPeak": lambda: _report().peak,
    "Oscillation": lambda: _report().oscillation,
    "Change": lambda: _report().redesign[0],
    "MatrixOnsets": lambda: ss.flutter_onsets(_of_matrices()),
    "Modes": lambda: ss.modes(_of_matrices()),
}

#: Those that take long motions.
LONG_MOTIONS = (
    "Cycle",
    "CycleBranch",
    "CycleEvent",
    "CycleProof",
    "Diagram",
    "EquilibriumBranch",
    "EventCurve",
    "Fate",
    "FateMap",
    "FateBoundary",
    "BasinBoundary",
    "Label",
    "Lyapunov",
    "Phases",
)


def test_every_class_of_results_is_here() -> None:
    classes: list[type] = [Result]
    for one in classes:
        classes += one.__subclasses__()
    known = {one.__name__ for one in classes if is_dataclass(one) and one.__name__[0] != "_"}
    assert known <= {name.split()[0] for name in MAKERS}


#: Those that take minutes, and those that a quick run looks at.
SLOW = ("BasinBoundary", "CycleProof", "FateBoundary")
QUICK = (
    "Equilibria",
    "Points",
    "BifurcationSet",
    "Jump",
    "Trajectory",
    "Sweep",
    "JumpProbability",
    "Path of a rod",
)
KINDS = [
    pytest.param(name, id=name, marks=pytest.mark.validate if name in SLOW else ())
    for name in MAKERS
]


@pytest.fixture(scope="module", params=few(KINDS, *QUICK))
def shown(request: pytest.FixtureRequest) -> Any:
    if request.param in LONG_MOTIONS and LONG_MOTIONS_TAKE_MINUTES:
        pytest.skip(LONG_MOTIONS_TAKE_MINUTES)
    return MAKERS[request.param]()


@pytest.fixture(scope="module")
def result(shown: Any) -> Any:
    if not isinstance(shown, Result):
        pytest.skip("a set of parameters, or a number")
    return shown


def test_a_notebook_gets_a_table(shown: Any) -> None:
    result = shown
    text = result._repr_html_()
    assert text == copy.deepcopy(result)._repr_html_()  # of equal results
    rows = [
        ["".join(cell.itertext()) for cell in row]
        for row in ET.fromstring(f"<p>{text}</p>").iter("tr")
    ]
    assert 2 <= len(rows) < 100
    assert all(cell for cell in rows[0][1:])
    assert "array(" not in text
    assert not any("\n" in cell for row in rows for cell in row)
    if type(result).__str__ is Result.__str__:
        assert all(cell in str(result) for row in rows for cell in row)
        # Radians stand under no heading: every angle is in degrees, and says so.
        headings = [
            cell
            for row in rows
            for cell in row
            if cell.split(" ")[0].startswith(("theta", "poles"))
        ]
        assert all(heading.split(" ")[0].endswith("_deg") for heading in headings)
    assert repr(result).startswith(f"{type(result).__name__}(")


def test_a_result_shows_itself(result: Any) -> None:
    columns = result.data()
    assert set(columns) <= set(result.columns)
    assert all(np.shape(result[name]) is not None for name in result.columns)
    assert isinstance(result == copy.deepcopy(result), bool | np.bool_ | np.ndarray)
    if isinstance(result, Named):
        assert set(result.columns) <= set(dir(result))
        first = next((name for name in result.columns if name in columns), None)
        assert first is None or first in repr(result)


def test_a_saved_result_is_read_back(result: Any, tmp_path: Path) -> None:
    if isinstance(result, ss.results.Report):
        with pytest.raises(ss.errors.ParameterError, match="to_html"):
            result.save(tmp_path / "result.json")
        return
    result.save(tmp_path / "result.json")
    of_matrices = isinstance(result, ss.results.MatrixOnsets | ss.results.Modes)
    model = result.parameters.model if of_matrices else None
    found = ss.open(tmp_path / "result.json", model=model)
    assert type(found) is type(result)
    assert (repr(found), str(found)) == (repr(result), str(result))
    for name, column in result.data().items():
        assert np.array_equal(found.data()[name], column, equal_nan=column.dtype.kind == "f")
    result.save(tmp_path / "again.json")
    assert (tmp_path / "again.json").read_bytes() == (tmp_path / "result.json").read_bytes()


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("{}", "holds no result"),
        ('{"spragsym":"0.0.1","result":null}', "was written by spragsym 0.0.1"),
        (
            '{"spragsym":"VERSION","sha256":"DIGEST","result":{"class":["os","system",{"dict":[]}]}}',
            "is no class of results",
        ),
        (
            '{"spragsym":"VERSION","sha256":"DIGEST","result":{"class":["spragsym.article.__main__","Path",{"dict":[]}]}}',
            "is no class",
        ),
        (
            '{"spragsym":"VERSION","sha256":"DIGEST","result":{"model":["elsewhere",false]}}',
            "no shipped model",
        ),
        (
            '{"spragsym":"VERSION","sha256":"DIGEST","result":{"array":["<f8",[2]]}}',
            "other parts than now",
        ),
        ('{"spragsym":"VERSION","sha256":"0","result":null}', "not as it was written"),
    ],
)
def test_a_file_runs_no_code(text: str, what: str, tmp_path: Path) -> None:
    digest = hashlib.sha256(text.partition('"result":')[2][:-1].encode()).hexdigest()
    (tmp_path / "a.json").write_text(
        text.replace("VERSION", ss.__version__).replace("DIGEST", digest)
    )
    with pytest.raises(ss.errors.ParameterError, match=what):
        ss.open(tmp_path / "a.json")


def test_a_damaged_file_is_refused(tmp_path: Path) -> None:
    ss.folds(ss.Parameters.article()).save(tmp_path / "a.json")
    whole, rng = (tmp_path / "a.json").read_bytes(), np.random.default_rng(3)
    for place in rng.integers(0, len(whole) - 1, 100):  # but for the line's end
        changed = bytearray(whole)
        changed[place] ^= int(rng.integers(1, 128))
        (tmp_path / "a.json").write_bytes(changed)
        with pytest.raises(ss.errors.ParameterError):
            ss.open(tmp_path / "a.json")


def test_rows_are_the_columns(result: Any) -> None:
    columns = result.data()
    if not columns or not hasattr(type(result), "__iter__"):
        pytest.skip("it has no rows, or gives its parts")
    rows = list(result)
    assert len(rows) == len(result)
    for name, column in columns.items():
        codes = result.columns[name].codes if name in result.columns else None
        told = column.tolist()
        if codes is not None:  # words, as in the table
            told = [codes(code).name.lower() for code in told]
            assert all(word in str(result) for word in told)
        assert [row[name] for row in rows] == told


def test_a_cell_says_what_an_event_is() -> None:
    found = MAKERS["Diagram"]()
    events = [event for branch in found.cycles for event in branch.events]
    assert events
    assert all(f"{event.kind} at {event.value:.6g}" in str(found) for event in events)


def _same(one: Any, other: Any) -> bool:
    one, other = np.ravel(one), np.ravel(other)
    return np.array_equal(one.astype(other.dtype), other, equal_nan=other.dtype.kind == "f")


def test_every_table_reaches_files_and_frames(result: Any, tmp_path: Path) -> None:
    xarray, pandas = pytest.importorskip("xarray"), pytest.importorskip("pandas")
    if isinstance(result, ss.results.Report):
        pytest.skip("a report is a text; its numbers are those of its parts")
    columns, dataset = result.data(), result.to_xarray()
    frame = result.to_dataframe()
    assert columns
    assert list(frame.columns) == list(columns)
    result.save(tmp_path / "a.nc")
    result.save(tmp_path / "a.csv")
    # As texts: pandas before 3.1 rounds the last bit of numbers that it reads.
    read = pandas.read_csv(tmp_path / "a.csv", comment="#", dtype=str, keep_default_na=False)
    assert len(read)
    with xarray.open_dataset(tmp_path / "a.nc", engine="h5netcdf") as file:
        assert {*file.variables} == {*dataset.variables}
        # Every axis has values that say where on it one is.
        assert {*file.dims} - {*dataset.coords} <= {"state", "mode"}
        for name in dataset.variables:
            assert _same(file[name].values, dataset[name].values.astype(file[name].dtype)), name
    for name, column in result.columns.items():
        if name in dataset:
            assert dataset[name].attrs.get("long_name", "") == column.meaning
    if isinstance(result, ss.results.Cycle):  # its samples; a frame has its state
        return
    whole = next((one for one in dataset.data_vars.values() if one.ndim), None)
    for name, column in columns.items():
        if name in read and column.dtype.kind == "f":
            assert _same(read[name].to_numpy(), column), name
        if isinstance(result, ss.results.Equilibria):
            if name in dataset.data_vars:
                assert _same(dataset[name].values[result.states], column), name
        elif name in dataset:
            full = dataset[name].broadcast_like(whole) if column.ndim else dataset[name]
            assert _same(full.values, column), name
    named = {*dataset.variables, *dataset.attrs}
    assert {*columns} <= named
    # What stands above a table or below it is there, too.
    for fact in frame.attrs:
        assert fact in named, fact
    for title in (line.split(":")[0] for line in str(result).splitlines() if line.endswith(":")):
        assert any(name.startswith(title) for name in named), title


def test_what_is_printed_last_was_found(result: Any) -> None:
    options = {"budget", "same_state", "same_range", "moves", "newton_steps"}
    assert not options & {line.split(" ")[0] for line in str(result).splitlines()}


def test_a_result_is_drawn(result: Any) -> None:
    pytest.importorskip("matplotlib")
    from matplotlib.figure import Figure

    ax = Figure().add_subplot()
    one_row = all(not column.ndim for column in result.data().values())
    if isinstance(result, ss.results.Fate) or (
        one_row and not isinstance(result, ss.results.JumpProbability | ss.results.CycleEvent)
    ):
        with pytest.raises(ss.errors.ParameterError, match=r"print it|\.plot\(\)"):
            result.plot(ax=ax)
        return
    found = result.plot(ax=ax)
    axes = [ax, *found.axes] if isinstance(found, Figure) else [ax]
    drawn = [line for one in axes for line in one.lines if np.size(line.get_xdata())]
    assert drawn or any(one.collections or one.patches for one in axes)
    # A legend names whatever is drawn; what has the name of another is hidden behind it.
    names = ax.get_legend_handles_labels()[1]
    assert len({*names}) == len(names)
    for line in drawn:
        assert line.get_label().removeprefix("_") in names
