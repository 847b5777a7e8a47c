"""How the solver uses the kernel's certificates: they alone settle a point, and other points go on to more digits."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym.exact.double_double import DoubleDouble
from spragsym.generated import kernel
from spragsym.kang_nam.statics import adaptive_precision, block, compiled, solver
from spragsym.parameters import NAMES
from spragsym.results import state_columns
from tests.oracles import reference
from tests.oracles.families import FAMILIES
from tests.oracles.true_errors import worst_errors


@pytest.fixture(autouse=True)
def _numpy() -> Iterator[None]:
    """NumPy's solver, whatever the number of points."""
    before = ss.get_backend()
    ss.set_backend("numpy")
    yield
    ss.set_backend(before)


def _points(n: int) -> ss.Parameters:
    """Some of every family in one array, which sends points down every way through the solver."""
    parts = [family(np.random.default_rng([51, k]), n).broadcast(*NAMES) for k, family in enumerate(FAMILIES.values())]
    return ss.Parameters(*(np.concatenate(columns) for columns in zip(*parts, strict=True)))


def _borders_in_liftoff(n: int) -> ss.Parameters:
    """Neighbouring floats of θ₀ between which the number of equilibria in lift-off changes."""
    p = FAMILIES["random"](np.random.default_rng(58), n)
    low, high = np.full(n, 0.05), np.full(n, 1.5)
    start = ss.equilibria(p.replace(theta0=low), contact=False).count
    differ = start != ss.equilibria(p.replace(theta0=high), contact=False).count
    for _ in range(60):
        middle = 0.5 * (low + high)
        same = ss.equilibria(p.replace(theta0=middle), contact=False).count == start
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    ends = [column for name, column in zip(NAMES, p.broadcast(*NAMES), strict=True) if name != "theta0"]
    return ss.Parameters(
        *(np.concatenate([one[differ], other[differ]]) for one, other in ((low, high), *zip(ends, ends, strict=True)))
    )


@pytest.mark.thorough
@pytest.mark.parametrize("contact", [True, False])
def test_counts_codes_and_bounds_over_every_family(contact: bool) -> None:
    p, rng = _points(24), np.random.default_rng(52)
    if not contact:
        borders = _borders_in_liftoff(30).broadcast(*NAMES)
        p = ss.Parameters(*map(np.concatenate, zip(p.broadcast(*NAMES), borders, strict=True)))
    eq = ss.equilibria(p, contact=contact)
    points = np.column_stack(p.broadcast(*NAMES)).tolist()
    count = reference.count_contact if contact else reference.count_liftoff
    assert eq.count.tolist() == [count(*point) for point in points]
    worst, ratio = worst_errors(p, eq, rng, 60)
    assert worst <= 1e-12
    assert ratio <= 1
    used = np.arange(eq.theta.shape[1]) < eq.count[:, None]
    assert (np.isfinite(eq.error) == used).all()
    assert ((eq.stability > 0) == used).all()
    assert np.nanmax(eq.error) <= block.TOLERANCE
    assert 0 < eq.escalated.mean() < 0.35
    for row, point in enumerate(points[::7]):
        states = adaptive_precision.equilibria(*point, contact=contact).states
        assert [state.stability for state in states] == eq.stability[7 * row, : eq.count[7 * row]].tolist()
        for slot, state in enumerate(states):
            assert abs(state.theta - eq.theta[7 * row, slot]) <= eq.error[7 * row, slot] * max(1, abs(state.theta))


def test_the_certificates_settle_most_points() -> None:
    """A bound that is too loose shows in the points that need more digits."""
    shares = {}
    for number, name in enumerate(("random", "right angle", "alpha = 1 + beta", "beta = 0")):
        p = FAMILIES[name](np.random.default_rng([53, number]), 4000)
        shares[name] = [float(ss.equilibria(p, contact=contact).escalated.mean()) for contact in (True, False)]
    assert all(share < 0.004 for contact in shares.values() for share in contact)


def test_every_rung_gives_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    """Double-double arithmetic, which is asked first, and intervals."""
    p, plain, calls = FAMILIES["near folds"](np.random.default_rng(54), 60), adaptive_precision.equilibria, list[int]()
    monkeypatch.setattr(adaptive_precision, "equilibria", lambda *given, **named: (calls.append(1), plain(*given, **named))[1])
    found = [ss.equilibria(p)]
    assert not calls
    monkeypatch.setattr(solver, "_solve_widely", lambda given, contact, out, rows: np.arange(rows.size))
    found.append(ss.equilibria(p))
    assert found[0].escalated.sum() == len(calls) > 0
    assert (found[0].escalated == found[1].escalated).all()
    assert (found[0].count == found[1].count).all()
    assert (found[0].stability == found[1].stability).all()
    both = [np.nan_to_num(eq.theta) for eq in found]
    assert (np.abs(both[0] - both[1]) <= 4 * np.nan_to_num(found[0].error + found[1].error)).all()


#: tan(θ/2) of three roots of one point, and what is there: all are equilibria.
T = (0.5, 1.0, 2.0)
GOOD = dict(L=1.0, x=0.0, y=-0.1, radius=1e-15, error=1e-15, member=True, outsider=False, known=True)


def _settled(
    monkeypatch: pytest.MonkeyPatch, changes: dict[str, Any], contact: bool = True, t: tuple[float, ...] = T
) -> tuple[bool, state_columns.Slots]:
    """The result of a block for three roots of which the middle one has changed, at the second of two points."""
    columns = {name: [value, changes.get(name, value), value] for name, value in GOOD.items()} | {"code": [1.0, 2.0, 1.0]}
    given = {name: np.repeat(np.array(values)[:, None], 2, axis=1) for name, values in columns.items()}
    monkeypatch.setattr(block.kernel, "at_root", lambda *_: kernel.Root(**given))
    out = state_columns.Slots(3, 3 if contact else 4)
    point = kernel.Point(*[np.ones(2)] * 7, float(contact))
    times = np.repeat(np.array(t)[:, None], 2, axis=1)
    settled = block._some(times, point, kernel.Balance(*[np.ones(2)] * 7), out, np.array([2, 1]), np.float64(2.0**-53))
    out.clear()
    assert settled[0] == settled[1]
    return bool(settled[1]), out


@pytest.mark.parametrize(
    "changes",
    [
        {"member": False},  # neither equilibrium nor certainly none
        {"known": False}, {"error": 1.1e-12}, {"error": np.nan}, {"radius": np.inf}, {"radius": 0.7},
        {"radius": 0.45},  # reaches the third root, not the first
        {"member": False, "outsider": True},  # two equilibria in contact can't be
    ],
    ids=str,
)  # fmt: skip
def test_one_missing_certificate_settles_nothing(monkeypatch: pytest.MonkeyPatch, changes: dict[str, Any]) -> None:
    settled, out = _settled(monkeypatch, changes)
    assert not settled
    assert out.count.tolist() == [0, 0, 0]


def test_an_error_at_the_tolerance_is_within_it(monkeypatch: pytest.MonkeyPatch) -> None:
    assert _settled(monkeypatch, {"error": 1e-12})[0]
    # What double-double arithmetic found is rounded to float64, θ by as much as an arc tangent of it is off: four units u.
    for error, sure in ((1e-12, False), (1e-12 - 4.3e-16, False), (1e-12 - 4.6e-16, True)):
        root = kernel.Root(**GOOD | {"error": error, "code": 1.0})
        assert bool(block._sure(DoubleDouble(1.0), root)) == sure


@pytest.mark.parametrize("t", [(0.5, 0.5, 2.0), (0.5, 2.0, 2.0), (0.5, np.nan, 2.0), (-0.5, 1.0, 2.0), (0.0, 1.0, 2.0)])
def test_roots_that_may_be_one_or_lie_below_0_settle_nothing_in_contact(monkeypatch: pytest.MonkeyPatch, t: Any) -> None:
    assert not _settled(monkeypatch, {}, t=t)[0]
    assert _settled(monkeypatch, {}, contact=False, t=t)[0] == (t[0] <= 0)


def test_one_root_a_point(monkeypatch: pytest.MonkeyPatch) -> None:
    """In contact: settled where it is an equilibrium for certain, and t > 0."""
    for t, changes, wanted in (
        (1.0, {}, True), (1.0, {"member": False}, False), (1.0, {"known": False}, False), (1.0, {"error": 2e-12}, False),
        (0.0, {}, False), (-1.0, {}, False), (np.nan, {}, False), (1.0, {"error": 1e-12}, True),
    ):  # fmt: skip
        given = {name: np.array([changes.get(name, value)] * 2) for name, value in GOOD.items()} | {"code": np.ones(2)}
        monkeypatch.setattr(block.kernel, "at_root", lambda *_, given=given: kernel.Root(**given))
        out = state_columns.Slots(5, 3)
        line = kernel.Balance(*[np.ones(2)] * 7)
        settled = block._one_each(np.array([t, t]), kernel.Point(*[np.ones(2)] * 8), line, out, 2, np.float64(2.0**-53))
        assert settled.tolist() == [wanted] * 2
        assert out.count.tolist() == [0, 0, wanted, wanted, 0]
        if wanted:
            np.testing.assert_allclose(out.first["theta"][2:4], math.pi / 2)


def test_members_move_to_the_front_whichever_they_are() -> None:
    rng = np.random.default_rng(56)
    for candidates, room in ((3, 3), (3, 4), (2, 4), (4, 4)):
        members = np.array(list(itertools.product([False, True], repeat=candidates))).T
        columns = {name: rng.integers(1, 9, members.shape) for name in state_columns.COLUMNS}
        count, packed = state_columns.gathered(members, columns, room)
        assert count.tolist() == members.sum(axis=0).tolist()
        for name in state_columns.COLUMNS:
            for point in range(members.shape[1]):
                kept = columns[name][members[:, point], point]
                assert packed[name][: kept.size, point].tolist() == kept.tolist()
                rest = packed[name][kept.size :, point]
                assert (rest == 0).all() if name == "stability" else np.isnan(rest).all()


def test_slots_hold_what_was_put_last() -> None:
    out = state_columns.Slots(3, 3)
    for theta in (1.0, 2.0):
        columns = state_columns.empty(3, 2)
        columns["theta"][:2] = theta
        columns["stability"][:2] = 1
        out.put(np.array([2, 0]), np.array([2, 0]), columns)
    out.clear()
    assert out.count.tolist() == [0, 0, 2]
    assert out.padded("theta")[2, :2].tolist() == [2.0, 2.0]
    assert np.isnan(out.first["theta"][:2]).all()
    assert out.padded("stability").dtype == np.int8
    assert out.padded("stability")[2].tolist() == [1, 1, 0]
    assert out.first["stability"][:2].tolist() == [0, 0]


def test_count_counts() -> None:
    p = _points(40)
    np.testing.assert_array_equal(ss.count(p), ss.equilibria(p).count)
    assert ss.count(p).dtype == np.int8
    one = ss.Parameters.article(theta0=[[0.5], [0.8]], mu0=[0.3, 1.0, 1.3])
    assert ss.count(one).shape == (2, 3)


def test_points_without_an_answer_are_marked_with_their_reason(monkeypatch: pytest.MonkeyPatch) -> None:
    p = ss.Parameters(1.0, [0.5, 1e200, 0.7], [0.3, 1e200, 0.3], 1.0, 1.0, 1.0)
    eq = ss.equilibria(p)
    assert eq.decided.tolist() == [True, False, True]
    assert eq.escalated.tolist() == [False, True, False]
    assert eq.count.tolist() == [1, 0, 1]
    assert "beyond float64" in eq.reason(1)
    assert eq.reason(0) == ""
    assert np.isnan(eq.theta[1]).all()
    assert not eq.fold.any()
    with pytest.raises(ss.ConvergenceError, match="beyond float64"):
        eq.require_decided()
    assert ss.equilibria(p.replace(mu0=0.5, kappa=0.3)).require_decided().count == 1


def test_no_point_sees_another() -> None:
    """One at a time, all together, in blocks, in two dimensions, with parameters broadcast: the same bits."""
    p = _points(3)
    whole = ss.equilibria(p)
    columns = p.broadcast(*NAMES)
    for row in range(0, whole.count.size, 5):
        one = ss.equilibria(ss.Parameters(*(float(value[row]) for value in columns)))
        assert one.count == whole.count[row]
        for name in ("theta", "L", "x", "y", "stability", "error", "escalated", "fold"):
            np.testing.assert_array_equal(getattr(one, name), getattr(whole, name)[row])
    size = whole.count.size // 3 * 3
    square = ss.equilibria(ss.Parameters(*(value[:size].reshape(3, -1) for value in columns)))
    np.testing.assert_array_equal(square.theta.reshape(size, 3), whole.theta[:size])
    np.testing.assert_array_equal(square.count.reshape(size), whole.count[:size])
    theta0, mu0 = np.linspace(0.2, 2.9, 7)[:, None], np.linspace(0, 2, 5)
    grid = ss.equilibria(ss.Parameters.article(theta0=theta0, mu0=mu0))
    flat = ss.equilibria(ss.Parameters.article(theta0=np.repeat(theta0, 5), mu0=np.tile(mu0, 7)))
    for name in ("theta", "count", "error", "stability", "escalated"):
        np.testing.assert_array_equal(getattr(grid, name).reshape(getattr(flat, name).shape), getattr(flat, name))


@pytest.mark.parametrize("contact", [True, False])
def test_blocks_and_threads_do_not_show(monkeypatch: pytest.MonkeyPatch, contact: bool) -> None:
    p = _points(8 if contact else 4)
    whole = ss.equilibria(p, contact=contact)
    monkeypatch.setattr(solver, "BLOCK", 7)
    monkeypatch.setattr(solver, "A_THREAD", dict.fromkeys(solver.A_THREAD, 7))
    for threads in (1, 3):
        ss.set_backend("numpy", threads=threads)
        pieces = ss.equilibria(p, contact=contact)
        for name in ("theta", "L", "count", "stability", "error", "escalated"):
            np.testing.assert_array_equal(getattr(pieces, name), getattr(whole, name))


@pytest.mark.parametrize("threads", [1, 2, 3])
def test_every_thread_has_as_many_blocks_of_one_size(monkeypatch: pytest.MonkeyPatch, threads: int) -> None:
    """Of BLOCK points or more, but less than twice as many; a thread has 12 points at least; every point is in one block."""
    monkeypatch.setattr(solver, "BLOCK", 10)
    kept: list[int] = []
    monkeypatch.setattr(solver, "ThreadPoolExecutor", lambda many: (kept.append(many), ThreadPoolExecutor(many))[1])
    for size in (0, 1, 9, 10, 11, 19, 20, 24, 35, 36, 60, 100, 101):
        kept.clear()
        blocks = solver._in_blocks(ss.Parameters.article(theta0=np.full(size, 0.5)), threads, 12, lambda _, *block: block)
        used = kept[0] if kept else 1
        assert used == max(1, min(threads, size // 12))
        assert np.concatenate([[], *(np.arange(begin, begin + part) for begin, part in blocks)]).tolist() == list(range(size))
        lengths = {part for _, part in blocks[:-1]}
        assert len(lengths) <= 1
        assert size < 10 * used or all(10 <= part < 20 for part in lengths)
        assert len(blocks) == (used * max(1, size // (10 * used)) if size else 0)


@pytest.mark.parametrize(("wide", "u"), [(False, 2.0**-53), (True, 2.0**-102)])
def test_bounds_are_asked_for_the_types_own_roundoff(monkeypatch: pytest.MonkeyPatch, wide: bool, u: float) -> None:
    asked = []
    for name in ("discriminant", "one_positive", "at_root"):
        plain = getattr(kernel, name)
        monkeypatch.setattr(block.kernel, name, lambda *given, plain=plain: (asked.append(given[-1]), plain(*given))[1])
    values = [np.full(3, value) for value in (0.6, 1.0, 0.1, 0.1, 0.1, 0.1)]
    with np.errstate(all="ignore"):
        if wide:
            block.solve_widely(values, True, state_columns.Slots(3, 3), 0, 3)
        else:
            block.solve(
                kernel.Point(np.cos(values[0]), np.sin(values[0]), *values[1:], 1), 3, state_columns.Slots(3, 3), 0, np.float64
            )
    assert len(asked) >= 3
    assert all(type(value) is np.float64 and value == u for value in asked)


#: A point with one equilibrium, one with three, and one with one, both in double-double as elsewhere.
WIDE_POINTS = [
    *np.array([(1.2, 0.3, 0.1, 0.1, 0.1, 0.1), (0.7, 0.7, 0.007, 0.007, 0.1, 0.0), (0.6, 1.0, 0.1, 0.1, 0.1, 0.1)]).T.copy()
]


def test_double_double_writes_to_its_rows() -> None:
    out = state_columns.Slots(8, 3)
    with np.errstate(all="ignore"):
        block.solve_widely(WIDE_POINTS, True, out, 4, 3)
    expected = ss.equilibria(ss.Parameters(*WIDE_POINTS))
    assert out.count.tolist() == [0, 0, 0, 0, *expected.count, 0]
    out.clear()
    np.testing.assert_allclose(out.padded("theta")[4:7], expected.theta, rtol=1e-12)


@pytest.mark.parametrize("value", [-1.0, 0.0, 1.0])
def test_a_discriminant_within_its_error_counts_for_nothing(monkeypatch: pytest.MonkeyPatch, value: float) -> None:
    """The second factor is then looked at: its roots, complex here, settle nothing."""
    p = ss.Parameters.article(theta0=[1.2, 2.0], mu0=0.3)
    assert not ss.equilibria(p, contact=False).escalated.any()
    monkeypatch.setattr(kernel, "discriminant", lambda line, *_: kernel.Discriminant(value + 0 * line.b, 1 + 0 * line.b))
    assert ss.equilibria(p, contact=False).escalated.all()


#: In lift-off the spring is so short here that the trace of its stiffness is negative.
SHORT = (0.311, 0.661, 0.143, 1.791, 2.269, 0.0)


def test_eigenvalues_are_those_of_the_stiffness() -> None:
    for contact in (True, False):
        columns = [np.append(column, value) for column, value in zip(_points(6).broadcast(*NAMES), SHORT, strict=True)]
        p = ss.Parameters(*columns)
        eq = ss.equilibria(p, contact=contact)
        _, mu0, _, alpha, sigma, beta = p.broadcast(*NAMES)
        traces = []
        for row, slot in zip(*np.nonzero(np.arange(eq.theta.shape[1]) < eq.count[:, None]), strict=True):
            s, c, L = np.sin(eq.theta[row, slot]), np.cos(eq.theta[row, slot]), eq.L[row, slot]
            K = np.array([
                [sigma[row] * (1 - s * s / L) + alpha[row], sigma[row] / L * s * c + mu0[row] * contact],
                [sigma[row] / L * s * c, sigma[row] * (1 - c * c / L) + beta[row] + contact],
            ])  # fmt: skip
            found, size = eq.eigenvalues[row, slot], np.abs(K).max()
            np.testing.assert_allclose(found[2:], -found[:2])
            traces.append(np.trace(K))
            assert abs(found[0]) >= abs(found[1]) * (1 - 1e-9)  # the larger first: it loses no digits
            wanted = np.poly(-np.linalg.eigvals(K).astype(complex))
            np.testing.assert_allclose(np.poly(found[:2] ** 2), wanted, atol=1e-9 * max(size, 1) ** 2)
        assert (min(traces) < 0) != contact
        assert any(0 < trace < 1 for trace in traces)
        assert np.isnan(eq.eigenvalues[np.arange(eq.theta.shape[1]) >= eq.count[:, None]]).all()


def test_what_is_not_normal_goes_to_more_digits() -> None:
    p = ss.Parameters(1.0, [0.5, 1e-260], 0.3, 0.2, 0.1, 0.0)
    assert ss.equilibria(p).escalated.tolist() == [False, True]


@pytest.mark.parametrize("backend", ["numpy", "compiled"])
@pytest.mark.parametrize("size", [1e160, 1e200])
def test_the_logarithm_of_a_length_beyond_float64_is_said(backend: str, size: float) -> None:
    """A length of 1e399 is no inf with twelve digits."""
    if backend == "compiled" and not compiled.available():
        pytest.skip("the compiled solver was not built: no C compiler")
    ss.set_backend(backend)
    given = dict(theta0=1.0, mu0=size, kappa=size, alpha=1.0, sigma=1.0, beta=1.0)
    with pytest.raises(ss.ConvergenceError, match=r"theta0=1\.0, mu0=.* is beyond float64") as failure:
        ss.equilibria(ss.Parameters(**given))
    (state,) = ss.precise.equilibria(**given, dps=20)
    said = float(str(failure.value).split("log10 L = ")[1].split(" ")[0])
    assert said == pytest.approx(float(mpmath.log10(state.L)), rel=2e-6)


def test_both_angle_and_friction_are_needed() -> None:
    for solve in (ss.equilibria, ss.count):
        for given, lacking in (({"mu0": 0.5}, "theta0"), ({"theta0": 0.5, "mu0": None}, "mu0")):
            with pytest.raises(ss.ParameterError, match=lacking):
                solve(ss.Parameters(**given, kappa=0.1, alpha=0.1, sigma=0.1, beta=0.1))


LONG = (1.0, 1e200, 1e200, 1.0, 1.0, 1.0)


@pytest.mark.parametrize("backend", ["numpy", "compiled"])
def test_slots_without_an_equilibrium_are_empty_whatever_memory_held(monkeypatch: pytest.MonkeyPatch, backend: str) -> None:
    if backend == "compiled" and not compiled.available():
        pytest.skip("the compiled solver was not built: no C compiler")
    ss.set_backend(backend)
    made = state_columns.Slots.__post_init__

    def filled(self: state_columns.Slots) -> None:
        made(self)
        for values in self.first.values():
            values[:] = 7

    monkeypatch.setattr(state_columns.Slots, "__post_init__", filled)
    # Of the last one, whose length float64 can't carry, nothing is written.
    columns = [np.append(column, value) for column, value in zip(_points(6).broadcast(*NAMES), LONG, strict=True)]
    p = ss.Parameters(*columns)
    for contact, room in ((True, 3), (False, 4)):
        eq = ss.equilibria(p, contact=contact)
        assert eq.theta.shape == (*p.shape, room)
        empty = np.arange(room) >= eq.count[:, None]
        assert np.isnan(eq.theta[empty]).all()
        assert not eq.stability[empty].any()
        assert eq.count[-1] == 0
        assert "Slots" not in repr(eq)


def test_counting_solves_nothing_where_signs_tell(monkeypatch: pytest.MonkeyPatch) -> None:
    """With the backend that was asked for, and the roundoff of float64."""
    p = ss.Parameters.article(theta0=np.radians([30.0, 35.0, 49.0, 120.0]), mu0=0.5)
    asked: list[float] = []
    plain = kernel.one_or_three
    monkeypatch.setattr(solver, "equilibria", None)
    monkeypatch.setattr(solver.compiled, "count", None)
    monkeypatch.setattr(kernel, "one_or_three", lambda point, u: (asked.append(u), plain(point, u))[1])
    assert ss.count(p).tolist() == [3, 3, 1, 1]
    assert asked == [2.0**-53]
    monkeypatch.setattr(solver, "_count", None)
    monkeypatch.setattr(solver.compiled, "count", lambda values, size: np.full(size, 3, dtype=np.int8))
    monkeypatch.setattr(solver.backends, "chosen", lambda: ("compiled", 1))
    assert ss.count(p).tolist() == [3, 3, 3, 3]


def test_folds_are_marked(monkeypatch: pytest.MonkeyPatch) -> None:
    """And of their states the two slots that hold one."""
    plain = adaptive_precision.equilibria

    def fold(*given: float, contact: bool) -> adaptive_precision.Settled:
        found = plain(*given, contact=contact)
        (one,) = found.states
        return replace(found, states=(replace(one, theta=one.theta - 1), one, one), fold=True) if given[0] > 1 else found

    monkeypatch.setattr(adaptive_precision, "equilibria", fold)
    p = ss.Parameters([0.9, 1.1, 1.2], [0.5, 0.5, 1e-260], 0.3, 0.2, 0.1, 0.0)
    assert not ss.equilibria(p.replace(theta0=0.9)).fold.any()
    assert ss.equilibria(p).fold.tolist() == [False, False, True]
    assert ss.equilibria(p).marginal.tolist() == [[False] * 3] * 2 + [[False, True, True]]


#: Three points beside two whose numbers are so far apart that double-double arithmetic is not what its bounds say.
IMMODERATE = [
    (1.2327756113845494, 4.53e21, 7.32e-53, 6.145e51, 2.6e-32, 1.748e49),
    (1.3664280351761058, 3.45e90, 1.433e12, 3.5579e34, 1.27e29, 9.49e41),
]
SOME_IMMODERATE = [
    np.insert(column, [1, 2], others) for column, others in zip(WIDE_POINTS, np.transpose(IMMODERATE), strict=True)
]


@pytest.mark.parametrize("size", [1, 2, 3, 5])
def test_blocks_of_double_double_do_not_show(monkeypatch: pytest.MonkeyPatch, size: int) -> None:
    """What is left is told by its place among the points, and the others are where their rows are."""
    monkeypatch.setattr(solver, "WIDE_BLOCK", size)
    out = state_columns.Slots(9, 3)
    rows = np.array([1, 2, 4, 7, 8])
    assert solver._solve_widely(SOME_IMMODERATE, True, out, rows).tolist() == [1, 3]
    expected = ss.equilibria(ss.Parameters(*(column[[0, 2, 4]] for column in SOME_IMMODERATE)))
    assert out.count[[1, 4, 8]].tolist() == expected.count.tolist()
    assert not out.count[[0, 2, 3, 5, 6, 7]].any()
    out.clear()
    np.testing.assert_allclose(out.padded("theta")[[1, 4, 8]], expected.theta, rtol=1e-12)


@pytest.mark.parametrize("name", ["numpy", "compiled"])
def test_double_double_is_that_of_the_backend(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    asked: list[str] = []
    monkeypatch.setattr(solver.backends, "chosen", lambda: (name, 1))
    for module, its in ((solver.compiled, "compiled"), (block, "numpy")):
        monkeypatch.setattr(module, "solve_widely", lambda *_, its=its: (asked.append(its), np.arange(5))[1])
    assert solver._solve_widely(SOME_IMMODERATE, True, state_columns.Slots(5, 3), np.arange(5)).tolist() == [0, 1, 2, 3, 4]
    assert asked == [name]


def test_the_error_of_a_stored_state_covers_its_rounding() -> None:
    """Of numbers halfway between two floats."""
    with mpmath.workprec(120):
        half = 1 + mpmath.mpf(2) ** -53
        state = adaptive_precision.State(half, 2 * half, -half, 4 * half, 1, mpmath.mpf(2) ** -110)
        columns = state_columns.empty(3, 1)
        solver._store(columns, 0, adaptive_precision.Settled((state,), False, 128), {})
        error = columns["error"][0, 0]
        for name in ("theta", "L", "x", "y"):
            true = getattr(state, name)
            assert abs(float(columns[name][0, 0]) - true) / max(1, abs(true)) <= error <= 1.3e-16
