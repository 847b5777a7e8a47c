"""The C target: clean under strict flags and sanitizers, Python's algebra, equilibria that it
vouches for.
"""

import ctypes
import itertools
import math
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from tests.oracles import c_target, languages, reference
from tests.oracles.families import FAMILIES
from tests.support import ROOT, few, in_python, leaves, lowest_sets

SOURCES = ROOT / "generated" / "c"
DRIVER = SOURCES.parents[1] / "derive" / "kang_nam" / "runtime" / "c" / "tests" / "driver.c"
HEADER = (SOURCES / "spragsym.h").read_text(encoding="utf-8")
COMPILERS = [name for name in ("gcc", "clang") if shutil.which(name)] or [
    name for name in ("cc",) if shutil.which(name)
]
STRICT = [
    "-std=c99",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Werror",
    "-Wconversion",
    "-Wshadow",
    "-Wstrict-prototypes",
]
OK, UNCERTAIN, BAD_INPUT, OUT_OF_RANGE = range(4)
LIFTOFF, CONTACT = 0, 1
#: Points that the driver's batch has room for.
BATCH = 4096
#: Without optimization: compiled fastest, and the same bits.
PLAIN = ("-O0", "-ffp-contract=off")
BASE = (math.radians(49.0), 0.5, 0.007, 0.007, 0.1, 0.0)
DISTANCES = (0.0, 1e-15, 1e-14, 1e-13, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4)

pytestmark = pytest.mark.skipif(not COMPILERS, reason="no C compiler on this machine")

# -------------------------------------------------------------------------------------------------
# driver

#: Generated functions in the header: name, names of the arguments, number of results.
ALGEBRA = {
    match[1]: (tuple(argument.split()[-1] for argument in match[2].split(",")), int(match[3] or 1))
    for match in re.finditer(
        r"spragsym_status spragsym_(\w+)\((double [^)]*?),\s+double (?:\*result|result\[(\d+)\])\)",
        HEADER,
    )
}


def calls() -> str:
    """C that runs every function of the algebra over arrays."""
    one_by_one = "\n".join(
        f"void call_{name}(long points, const double *in, double *out, int *status);\n"
        f"void call_{name}(long points, const double *in, double *out, int *status) {{\n"
        f"    for (long i = 0; i < points; i++) {{\n"
        f"        const double *const a = in + {len(arguments)} * i;\n"
        "        status[i] = "
        f"(int)spragsym_{name}({', '.join(f'a[{k}]' for k in range(len(arguments)))},\n"
        f"                                         out + {results} * i);\n"
        f"    }}\n}}\n"
        for name, (arguments, results) in ALGEBRA.items()
    )
    every = " ".join(f"call_{name}(1, numbers, results, status);" for name in ALGEBRA)
    return (
        f"#define BATCH {BATCH}\n\n{one_by_one}\n"
        "void call_all(const double *numbers, double *results, int *status);\n"
        f"void call_all(const double *numbers, double *results, int *status) {{\n    {every}\n}}\n"
    )


class LowestFold(ctypes.Structure):
    """``spragsym_critical_load``."""

    _fields_ = (("mu0", ctypes.c_double), ("theta0", ctypes.c_double), ("kind", ctypes.c_int))


def compile_driver(folder: Path, compiler: str, *flags: str) -> Path:
    """The driver as an executable or, with ``-shared``, as a shared object."""
    (folder / "calls.h").write_text(calls(), encoding="utf-8")
    target, sources = folder / "driver", [DRIVER, SOURCES / "spragsym.c"]
    command = [
        compiler,
        *STRICT,
        *flags,
        f"-I{SOURCES}",
        f"-I{folder}",
        "-o",
        target,
        *sources,
        "-lm",
    ]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    return target


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    return ctypes.CDLL(
        str(
            compile_driver(tmp_path_factory.mktemp("c99"), COMPILERS[0], *PLAIN, "-shared", "-fPIC")
        )
    )


def _pointer(array: Any) -> Any:
    assert array.flags.c_contiguous
    return array.ctypes.data_as(ctypes.c_void_p)


def solve(library: ctypes.CDLL, points: Any, regime: int) -> c_target.Solved:
    """All points in one batch."""
    points = np.ascontiguousarray(points, dtype=float)
    c_target.solve(library, points, found := c_target.room(len(points)), bool(regime))
    return found


# ------------------------------------------------------------------------------------------------
# points


def _decades(rng: np.random.Generator, low: float, high: float, count: int) -> Any:
    return 10.0 ** rng.uniform(low, high, count)


def _random(rng: np.random.Generator, count: int, **fixed: Any) -> Any:
    decades = {
        "mu0": (-3, 1),
        "kappa": (-4, 0),
        "alpha": (-4, 1),
        "sigma": (-3, 1),
        "beta": (-4, 1),
    }
    columns = {"theta0": rng.uniform(0.0, math.pi, count)}
    columns |= {name: _decades(rng, *ends, count) for name, ends in decades.items()}
    return np.column_stack(
        [np.broadcast_to(fixed.get(name, value), (count,)) for name, value in columns.items()]
    )


def _around(theta0: float) -> Any:
    return np.array(
        [(theta0 * (1 + sign * distance), *BASE[1:]) for distance in DISTANCES for sign in (-1, 1)]
    )


def _flutter_onsets() -> Any:
    """Parameters at which the discriminant in (27) is zero at an equilibrium, and next to them."""
    _, _, kappa, _, sigma, beta = BASE
    onsets = ss.kang_nam.flutter_boundary(ss.Parameters.article(alpha=0.7), n=60)
    some = np.linspace(0, onsets.mu0.size - 1, 5).astype(int)
    return np.array(
        [
            (theta0, mu0 * (1 + sign * distance), kappa, 0.7, sigma, beta)
            for theta0, mu0 in zip(onsets.theta0[some], onsets.mu0[some], strict=True)
            for distance in DISTANCES
            for sign in (-1, 1)
        ]
    )


def adversarial() -> dict[str, Any]:
    """The families, and what lies still farther apart or next to a fold or an onset of flutter."""
    rng, n = np.random.default_rng(99), 40
    families = {
        name: c_target.table(family(np.random.default_rng([99, k]), n))
        for k, (name, family) in enumerate(FAMILIES.items())
    }
    wide = {
        name: _decades(rng, low, high, n)
        for name, low, high in (("kappa", -12, 3), ("sigma", -8, 4), ("alpha", -12, 3))
    }
    return families | {
        "decades": _random(rng, n),
        "wild decades": _random(rng, n, **wide),
        "fold at 44.6 degrees": _around(math.radians(44.559317702565)),
        "fold at 155.1 degrees": _around(math.radians(155.059418789789)),
        "onset of flutter": _flutter_onsets(),
        "small kappa": _random(rng, n, kappa=_decades(rng, -16, -6, n)),
        "small kappa and theta0": _random(
            rng, n, kappa=_decades(rng, -16, -6, n), theta0=_decades(rng, -14, -3, n)
        ),
        "alpha = 0": _random(rng, n, alpha=0.0),
    }


def nonsense() -> Any:
    """Points of which many are refused."""
    return np.random.default_rng(7).choice(
        [0.0, -1.0, 1.0, 3.0, math.nan, math.inf, 1e300, 1e-300, 5e-324], (500, 6)
    )


# ------------------------------------------------------------------------------------------------
# tests


@pytest.mark.thorough
def test_sanitizers(tmp_path: Path) -> None:
    """No undefined behaviour, no access out of bounds, over the adversarial set and over
    nonsense.
    """
    compiler = COMPILERS[0]
    program = compile_driver(
        tmp_path, compiler, "-O0", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"
    )
    points = np.concatenate([*adversarial().values(), nonsense()])
    assert len(points) <= BATCH
    done = subprocess.run([program], input=points.tobytes(), capture_output=True, timeout=60)
    assert (done.returncode, done.stderr) == (0, b"")


@pytest.mark.thorough
def test_algebra_is_that_of_python(library: ctypes.CDLL) -> None:
    """Operation for operation; only exp may differ in its last digit."""
    for name, (names, results) in ALGEBRA.items():
        size = 500, len(names)
        arguments = np.random.default_rng(3).uniform(0.1, 1.5, size) * np.random.default_rng(
            4
        ).choice([-1, 1], size)
        ours, status = np.empty((500, results)), np.full(500, -1, np.intc)
        getattr(library, f"call_{name}")(
            ctypes.c_long(500), _pointer(arguments), _pointer(ours), _pointer(status)
        )
        assert not status.any()
        function = in_python(name, names)
        theirs = np.column_stack(
            [np.ravel(np.broadcast_to(value, 500)) for value in leaves(function(*arguments.T))]
        )
        with_exponential = names[0] in ("x", "vx") or name == "damping"
        rtol, atol = (1e-13, 1e-14) if with_exponential else (0, 0)
        np.testing.assert_allclose(ours, theirs, rtol=rtol, atol=atol, err_msg=name)


@pytest.mark.parametrize("regime", [CONTACT, LIFTOFF])
@pytest.mark.parametrize(
    "kind",
    few(adversarial(), "random", "cusp wedge", "wild decades", "onset of flutter", "alpha = 0"),
)
def test_equilibria_against_50_digits(library: ctypes.CDLL, kind: str, regime: int) -> None:
    """Counts that certified roots decide, states by Newton's method on the forces; the kinds are
    Python's.
    """
    points = adversarial()[kind]
    found, known = (
        solve(library, points, regime),
        ss.equilibria(ss.Parameters(*points.T), contact=bool(regime)),
    )
    sure = found.status == OK
    assert set(found.status[~sure]) <= {UNCERTAIN}
    count = reference.count_contact if regime == CONTACT else reference.count_liftoff
    for i in np.flatnonzero(sure):
        states = found.equilibria[i, : found.count[i]]
        assert found.count[i] == count(*points[i]), points[i]
        assert (states["stability"] == known.undamped[i, : found.count[i]]).all(), points[i]
        for state in states:
            exact = reference.refine(
                state["x"], state["y"], *points[i], contact=bool(regime), digits=70
            )
            ours = (state[name] for name in ("theta", "L", "x", "y"))
            off = max(
                abs(one - value) / max(1, abs(value))
                for one, value in zip(ours, exact, strict=True)
            )
            assert off <= state["error"] <= 1e-12, points[i]
    # Close to a fold or to flutter nothing can be vouched for; elsewhere nearly everything is.
    assert sure.sum() >= (
        0.35 if regime == CONTACT and re.search("fold|flutter|wedge", kind) else 0.95
    ) * len(points)


def lowest_folds(
    library: ctypes.CDLL, sets: list[dict[str, float]]
) -> list[tuple[int, LowestFold]]:
    points = np.array(
        [
            [math.nan, math.nan, *(given[name] for name in ("kappa", "alpha", "sigma", "beta"))]
            for given in sets
        ]
    )
    found = (LowestFold * len(sets))()
    status = np.zeros(len(sets), dtype=np.int32)
    library.lowest(ctypes.c_long(len(sets)), _pointer(points), found, _pointer(status))
    return list(zip(status.tolist(), found, strict=True))


@pytest.mark.thorough
def test_the_lowest_fold_is_that_python_proves(library: ctypes.CDLL) -> None:
    """Certain for all but a few random sets; near alpha = 1 + beta and with hardly any alpha at
    least not wrong.
    """
    names = ("kappa", "alpha", "sigma", "beta")
    usual = [{name: float(getattr(p, name)) for name in names} for p in lowest_sets(60)]
    hard = [{name: given[name] for name in names} for given in languages.fold_sets(40)]
    kinds = {0: "", 1: "cusp", 2: "turn", 3: "end"}
    found = lowest_folds(library, usual + hard)
    certain = 0
    for i, (given, (status, fold)) in enumerate(zip(usual + hard, found, strict=True)):
        assert status in (OK, UNCERTAIN)
        if status == OK:
            certain += i < len(usual)
            theirs = ss.critical_friction(ss.Parameters(**given))
            assert kinds[fold.kind] == theirs.kind, given
            assert fold.mu0 == pytest.approx(float(theirs), rel=1e-11, abs=1e-13), given
            assert fold.theta0 == pytest.approx(theirs.theta0 if theirs.kind else 0.0, rel=1e-5), (
                given
            )
    assert certain > 0.9 * len(usual)
    assert {fold.kind for _, fold in found} >= {0, 1, 2}


def test_what_double_cannot_carry_is_said(library: ctypes.CDLL) -> None:
    """Never a NaN: a status, or equilibria with finite numbers."""
    for index, value in itertools.product((1, 2, 3, 4, 5), (sys.float_info.max, 1e300, 1e-300)):
        found = solve(
            library, [[value if i == index else one for i, one in enumerate(BASE)]], CONTACT
        )
        assert found.status != BAD_INPUT
        assert (found.status == OUT_OF_RANGE) == (found.count == 0)
        assert all(np.isfinite(found.equilibria[name]).all() for name in ("theta", "L", "x", "y"))


# ------------------------------------------------------------------------------------------------
# step


def _steps(
    library: ctypes.CDLL,
    h: float,
    count: int,
    V: float = 0.5,
    d: float = 10.0,
    start: Any = (0, 0, 0, 0),
) -> Any:
    state = np.array(start, dtype=float)
    numbers = (ctypes.c_double(V), ctypes.c_double(d), ctypes.c_double(h))
    status = library.steps(
        _pointer(np.array(BASE)), *numbers, ctypes.c_long(count), _pointer(state)
    )
    return status, state


@pytest.mark.parametrize(
    ("V", "start", "kinks"), [(0.2, (0, 0, 0, 0), (4, 0)), (0.1, (0, -0.01, 0.3, 0), (4, 2))]
)
def test_step_is_of_fourth_order_across_the_kinks(
    library: ctypes.CDLL, V: float, start: Any, kinks: tuple[int, int]
) -> None:
    """The orbits leave the belt and come back, or overtake it; the first starts on a kink. By
    Python's integrator.
    """
    begun = dict(zip(("x0", "y0", "vx0", "vy0"), start, strict=True))
    tr = ss.simulate(ss.Parameters(*BASE), V=V, d=10.0, t_end=60.0, rtol=1e-13, **begun)
    of = (
        (ss.Event.CONTACT_LOST, ss.Event.CONTACT_REGAINED),
        (ss.Event.MASS_OVERTAKES, ss.Event.BELT_OVERTAKES),
    )
    assert tuple(len(tr.events.of(*each)) for each in of) == kinks
    errors = []
    for h in (0.1, 0.05, 0.025, 0.0125):
        status, state = _steps(library, h, round(60.0 / h), V=V, start=start)
        assert status == OK
        errors.append(float(np.abs(state - tr.state[:, -1]).max()))
    assert errors[-1] < 1e-8
    assert math.log2(errors[0] / errors[-1]) / 3 > 3.6


# ------------------------------------------------------------------------------------------------
# cost and export
