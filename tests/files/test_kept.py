"""Files that an earlier version wrote, of each kind of result, a sweep and a study: every later
version opens them.

``python -m tests.files.test_kept`` adds those of kinds that are new; a file that is there is never
written anew. Where a class is moved, ``MOVED`` of ``spragsym.results.files`` says where to; where
the same file is to be read in another way, ``FORMAT`` there is raised, and the old way is kept
beside it.
"""

import json
from collections.abc import Callable, Iterator
from dataclasses import MISSING, fields, is_dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.files import storage
from spragsym.results import files
from spragsym.results.result import Result
from tests.models.test_results import BELT, MAKERS, ONE

KEPT = Path(__file__).parent / "kept"
#: Beside the cusp.
NARROW = {"mu0": (0.2, 0.21), "theta0": (1.1, 1.25)}


def _motion() -> ss.results.Trajectory:
    return ss.simulate(ONE, t_end=0.5, events=False, **BELT)


#: Smaller than those that are shown.
SMALL: dict[str, Callable[[], Any]] = {
    "BifurcationSet": lambda: ss.bifurcation_set(ONE, n=6, between=NARROW),
    "Curve": lambda: ss.bifurcation_set(ONE, n=6, between=NARROW).curves[0],
    "FlutterBoundary": lambda: ss.kang_nam.flutter_boundary(ONE.replace(alpha=0.7), 6),
    "Path": lambda: ss.quasi_static_path(ONE.replace(mu0=0.7), "theta0", [0.5, 0.6, 1.0]),
    "Trajectory": _motion,
    "Spectrum": lambda: _motion().spectrum(points=16),
    "Cycle": lambda: ss.cycle(
        ss.load("stick_slip").Parameters(V=0.2), backend="scipy", near=[0.0, 0.0]
    ),
    "Diagram": lambda: ss.diagram(
        ss.load("stick_slip").Parameters(), "V", between={"V": (0.05, 0.3)}, points=2
    ),
    "CycleBranch": lambda: ss.cycle_branch(
        MAKERS["Cycle"](),
        vary="theta0",
        between={"theta0": tuple(np.radians([41.9, 42.1]))},
        points=1,
    ),
}
#: Not opened from a file by itself: a report is computed anew from its study, and those of
#: matrices need these.
LEFT_OUT = ("Report", "MatrixOnsets", "Modes")


def kinds() -> list[str]:
    """Names of results that are kept."""
    return [name for name in MAKERS if name not in LEFT_OUT]


def made(name: str) -> Any:
    return (SMALL.get(name) or MAKERS[name])()


def file_of(name: str) -> Path:
    return KEPT / f"{name.replace(' ', '_')}.json"


def sweep(store: Path) -> ss.results.Sweep:
    """The same call as that which wrote the kept stores."""
    p = ss.Parameters.article(theta0=np.radians([38.0, 44.0]))
    return ss.rms_sweep(p, t_end=20.0, transient=10.0, store=store, **BELT)


@pytest.mark.parametrize("file", sorted(KEPT.glob("*.json")), ids=lambda file: file.stem)
def test_a_kept_result_is_opened(file: Path) -> None:
    found = ss.open(file)
    kept = json.loads(file.read_text(encoding="utf-8"))
    assert type(found).__name__ == kept["result"]["class"][1]
    assert repr(found).startswith(f"{type(found).__name__}(")
    assert all(np.size(column) >= 0 for column in found.data().values())


@pytest.mark.parametrize(
    "name", ["Equilibria", "Points", "Jump", "LinearSprag", "Onsets in closed form", "Surface"]
)
def test_a_kept_result_is_what_is_computed_now(name: str) -> None:
    found, now = ss.open(file_of(name)).data(), made(name).data()
    for column, values in now.items():
        if column != "error" and values.dtype.kind in "iuf":
            np.testing.assert_allclose(found[column], values, rtol=1e-6, atol=1e-9, err_msg=column)


def test_every_kind_is_kept() -> None:
    missing = [name for name in kinds() if not file_of(name).exists()]
    missing = [name for name in missing if isinstance(made(name), Result)]
    assert not missing, "python -m tests.files.test_kept adds them"


def classes_in(held: Any) -> Iterator[list[Any]]:
    """Every class in a file, as it is written there: its module, its name and its fields."""
    if isinstance(held, dict) and "class" in held:
        yield held["class"]
    for part in held.values() if isinstance(held, dict) else held if isinstance(held, list) else ():
        yield from classes_in(part)


def without(one: list[Any], name: str) -> list[Any]:
    """A class as a version wrote it that did not know one of its fields."""
    module, kind, parts = one
    names = (name, files.FORMER_FIELDS.get(name))
    return [module, kind, {"dict": [part for part in parts["dict"] if part[0] not in names]}]


def test_a_field_that_is_younger_than_a_file_has_its_default(tmp_path: Path) -> None:
    """Of every class that is kept, and each of its fields; one without a default is needed."""
    seen, defaults = dict[tuple[str, str], list[Any]](), 0
    for file in sorted(KEPT.glob("*.json"), key=lambda file: file.stat().st_size):
        for one in classes_in(json.loads(file.read_text(encoding="utf-8"))["result"]):
            seen.setdefault((one[0], one[1]), one)
    for place, one in seen.items():
        for field in fields(files._class(*place)) if is_dataclass(files._class(*place)) else ():
            whole = json.dumps({"class": without(one, field.name)})
            read = partial(json.loads, whole, object_hook=partial(files._read, None))
            if field.default is MISSING and field.default_factory is MISSING:
                with pytest.raises(LookupError, match=field.name):
                    read()
                continue
            made = field.default if field.default is not MISSING else field.default_factory()
            np.testing.assert_equal(getattr(read(), field.name), made, err_msg=f"{place}")
            defaults += 1
    assert len(seen) > 40
    assert defaults > 20
    held = json.loads(file_of("Jump").read_text(encoding="utf-8"))
    held["result"]["class"] = without(held["result"]["class"], "value")
    held["sha256"] = files._digest(files._text(held["result"]))
    (tmp_path / "old.json").write_text(json.dumps(held), encoding="utf-8")
    with pytest.raises(ss.errors.ParameterError, match=r"had other parts than now .*'value'"):
        ss.open(tmp_path / "old.json")


def test_a_kept_sweep_is_read_and_computed_to_the_same() -> None:
    """Where numbers differ by more than rounding, ``RECORDS`` of ``motion.sweeps.many`` is to be
    raised.
    """
    pytest.importorskip("h5netcdf")
    now = sweep(store=None)  # type: ignore[arg-type]
    for ending in ("csv", "nc"):
        columns, attributes = storage.read(KEPT / f"sweep.{ending}")
        assert attributes["model"] == "kang_nam"
        assert len(attributes["fingerprint"]) == 64
        for name in ("rms", "mean", "largest", "spread"):
            kept = np.array(columns[name], dtype=float)
            np.testing.assert_allclose(kept, getattr(now, name), rtol=1e-6, atol=1e-12)


def test_a_kept_study_is_read() -> None:
    study = ss.Study.from_file(KEPT / "brake.toml")
    values = {name: one.value for name, one in study.quantities.items()}
    assert values["k"] == 180e3
    assert (study.title, study.date) == ("Kept", "2026-11-28")
    assert values["F_L"] == 420.0


def test_a_store_does_not_depend_on_the_text_of_a_source(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """But on the generated files, and on the number of its format."""
    from spragsym.motion.sweeps import many

    found = ss.rms_sweep(ONE, t_end=1.0, **BELT)

    def key() -> str:
        return str(found._attributes()["fingerprint"])

    before = key()
    with monkeypatch.context() as patched:
        patched.setattr(Path, "read_bytes", lambda _: pytest.fail("a source is read"))
        assert key() == before
    for module, name, value in (
        (many, "RECORDS", many.RECORDS + 1),
        (storage, "SOURCE_HASH", "of another derivation"),
    ):
        with monkeypatch.context() as patched:
            patched.setattr(module, name, value)
            assert key() != before
    monkeypatch.setattr(storage, "__version__", "9.9.9")
    assert key() == before


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"spragsym": "0.0.7"}, ""),
        ({"spragsym": "9.0.0"}, ""),
        ({"format": 99}, "was written by spragsym"),
        ({"sha256": "0"}, "not as it was written"),
    ],
)
def test_a_file_is_read_by_its_format_and_not_by_its_version(
    change: dict[str, Any], words: str, tmp_path: Path
) -> None:
    held = json.loads(file_of("Points").read_text()) | change
    (tmp_path / "a.json").write_text(json.dumps(held))
    if not words:
        assert len(ss.open(tmp_path / "a.json")) == 2
        return
    with pytest.raises(ss.errors.ParameterError, match=words):
        ss.open(tmp_path / "a.json")


if __name__ == "__main__":
    KEPT.mkdir(exist_ok=True)
    for kind in kinds():
        if not file_of(kind).exists() and isinstance(result := made(kind), Result):
            result.save(file_of(kind))
            print(file_of(kind).name, file_of(kind).stat().st_size)
    for written in (KEPT / "sweep.csv", KEPT / "sweep.nc"):
        if not written.exists():
            sweep(written)
