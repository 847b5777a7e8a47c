"""What the solver makes of the kernel's certificates: nothing is settled but by them, and what isn't goes on to more digits."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from benchmarks.families import FAMILIES
from benchmarks.validate_equilibria import worst_errors, wrong_counts
from spragsym.parameters import NAMES
from spragsym.statics import kernel, ladder, solver


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


def test_counts_codes_and_bounds_over_every_family() -> None:
    p, rng = _points(24), np.random.default_rng(52)
    for contact in (True, False):
        eq = ss.equilibria(p, contact=contact)
        if contact:
            assert wrong_counts(p, eq) == 0
        worst, ratio = worst_errors(p, eq, rng, 60)
        assert worst <= 1e-12
        assert ratio <= 1
        used = np.arange(eq.theta.shape[1]) < eq.count[:, None]
        assert (np.isfinite(eq.error) == used).all()
        assert ((eq.stability > 0) == used).all()
        assert np.nanmax(eq.error) <= solver.TOLERANCE
        assert 0 < eq.escalated.mean() < 0.35
        for row in range(0, eq.count.size, 7):
            point = [float(value[row]) for value in p.broadcast(*NAMES)]
            states = ladder.equilibria(*point, contact=contact).states
            assert [state.stability for state in states] == eq.stability[row, : eq.count[row]].tolist()
            for slot, state in enumerate(states):
                assert abs(state.theta - eq.theta[row, slot]) <= eq.error[row, slot] * max(1, abs(state.theta))


def test_the_certificates_settle_most_points() -> None:
    """A bound that is too loose shows in the points that need more digits."""
    shares = {}
    for number, name in enumerate(("random", "right angle", "alpha = 1 + beta", "beta = 0")):
        p = FAMILIES[name](np.random.default_rng([53, number]), 4000)
        shares[name] = [float(ss.equilibria(p, contact=contact).escalated.mean()) for contact in (True, False)]
    assert all(share < 0.004 for contact in shares.values() for share in contact)


def test_every_rung_gives_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    p = FAMILIES["near folds"](np.random.default_rng(54), 30)
    found = [ss.equilibria(p)]
    monkeypatch.setattr(solver, "_extended_precision", lambda: False)
    found.append(ss.equilibria(p))
    assert found[0].escalated.any()
    assert (found[0].escalated == found[1].escalated).all()
    assert (found[0].count == found[1].count).all()
    assert (found[0].stability == found[1].stability).all()
    both = [np.nan_to_num(eq.theta) for eq in found]
    assert (np.abs(both[0] - both[1]) <= 4 * np.nan_to_num(found[0].error + found[1].error)).all()


def _roots(**changes: Any) -> list[solver.Root]:
    """Three roots of one point, all equilibria; changes are of the middle one."""
    columns = []
    for k, t in enumerate((0.5, 1.0, 2.0)):
        given = dict(t=t, L=1.0, x=0.0, y=-0.1, radius=1e-15, error=1e-15, member=True, outsider=False, code=1 + (k == 1))
        columns.append(given | (changes if k == 1 else {}))
    return [solver.Root(**{name: np.array([value]) for name, value in column.items()}) for column in columns]


def _settled(roots: list[solver.Root], wanted: bool = True, contact: bool = True) -> tuple[bool, solver._Slots]:
    out = solver._Slots(1, 4)
    return bool(solver._fill(out, np.array([0]), roots, np.array([wanted]), contact, np.float64(2.0**-53))[0]), out


def test_three_certain_equilibria_are_settled_in_order() -> None:
    settled, out = _settled(_roots())
    assert settled
    assert out.count[0] == 3
    np.testing.assert_allclose(out.theta[0, :3], 2 * np.arctan([0.5, 1.0, 2.0]))
    assert out.stability[0].tolist() == [1, 2, 1, 0]
    assert out.error[0, :3].tolist() == [1e-15] * 3


@pytest.mark.parametrize(
    "changes",
    [
        {"member": False},  # neither equilibrium nor certainly none
        {"code": 0}, {"error": 1.1e-12}, {"error": np.nan}, {"radius": np.nan}, {"radius": 0.7},
        {"member": False, "outsider": True},  # two equilibria in contact can't be
        {"t": 0.5}, {"t": np.nan},
    ],
    ids=str,
)  # fmt: skip
def test_one_missing_certificate_settles_nothing(changes: dict[str, Any]) -> None:
    settled, out = _settled(_roots(**changes))
    assert not settled
    assert out.count[0] == 0


def test_roots_that_are_none_leave_their_slots() -> None:
    settled, out = _settled(_roots(member=False, outsider=True), contact=False)
    assert settled
    assert out.count[0] == 2
    np.testing.assert_allclose(out.theta[0, :2], 2 * np.arctan([0.5, 2.0]))
    assert np.isnan(out.theta[0, 2:]).all()
    assert not _settled(_roots(), wanted=False)[0]
    first, *rest = _roots()
    backward = [first._replace(t=np.array([-0.5])), *rest]
    assert not _settled(backward)[0]  # in contact no equilibrium has sin θ < 0
    assert _settled(backward, contact=False)[0]


def test_ascending_sorts_and_spreads_what_is_no_number() -> None:
    for order in itertools.permutations((3.0, -1.0, 2.0, 0.5)):
        assert [float(value[0]) for value in solver._ascending([np.array([value]) for value in order])] == [-1.0, 0.5, 2.0, 3.0]
    assert all(np.isnan(value[0]) for value in solver._ascending([np.array([value]) for value in (1.0, np.nan, 2.0)]))


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


def test_blocks_and_threads_do_not_show(monkeypatch: pytest.MonkeyPatch) -> None:
    p = _points(8)
    whole = ss.equilibria(p)
    monkeypatch.setattr(solver, "BLOCK", 7)
    for threads in (1, 3):
        ss.set_backend("numpy", threads=threads)
        pieces = ss.equilibria(p)
        for name in ("theta", "L", "count", "stability", "error", "escalated"):
            np.testing.assert_array_equal(getattr(pieces, name), getattr(whole, name))


def test_eigenvalues_are_those_of_the_stiffness() -> None:
    for contact in (True, False):
        p = _points(6)
        eq = ss.equilibria(p, contact=contact)
        _, mu0, _, alpha, sigma, beta = p.broadcast(*NAMES)
        for row, slot in zip(*np.nonzero(np.arange(eq.theta.shape[1]) < eq.count[:, None]), strict=True):
            s, c, L = np.sin(eq.theta[row, slot]), np.cos(eq.theta[row, slot]), eq.L[row, slot]
            K = np.array([
                [sigma[row] * (1 - s * s / L) + alpha[row], sigma[row] / L * s * c + mu0[row] * contact],
                [sigma[row] / L * s * c, sigma[row] * (1 - c * c / L) + beta[row] + contact],
            ])  # fmt: skip
            found, size = eq.eigenvalues[row, slot], np.abs(K).max()
            np.testing.assert_allclose(found[2:], -found[:2])
            wanted = np.poly(-np.linalg.eigvals(K).astype(complex))
            np.testing.assert_allclose(np.poly(found[:2] ** 2), wanted, atol=1e-9 * max(size, 1) ** 2)
        assert np.isnan(eq.eigenvalues[np.arange(eq.theta.shape[1]) >= eq.count[:, None]]).all()


def test_what_is_not_normal_goes_to_more_digits() -> None:
    p = ss.Parameters(1.0, [0.5, 1e-260], 0.3, 0.2, 0.1, 0.0)
    assert ss.equilibria(p).escalated.tolist() == [False, True]
    assert not kernel.normal(*(np.float64(value) for value in (1.0, 1e-260, 0.3, 0.2, 0.1, 0.0)))


def test_a_length_beyond_float64_is_said() -> None:
    with pytest.raises(ss.ConvergenceError, match=r"log10 L = .* of theta0=1\.0, mu0=.* is beyond float64"):
        ss.equilibria(ss.Parameters(theta0=1.0, mu0=1e200, kappa=1e200, alpha=1.0, sigma=1.0, beta=1.0))
