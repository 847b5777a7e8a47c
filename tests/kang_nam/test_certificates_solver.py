"""How the solver uses the kernel's certificates: they alone settle a point, and other points go on
to more digits.
"""

from collections.abc import Iterator
from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym.generated import kernel
from spragsym.generated.quantities import PARAMETERS
from spragsym.kang_nam.quartic import adaptive_precision, block, compiled, solver
from tests.oracles.families import FAMILIES


@pytest.fixture(autouse=True)
def _numpy() -> Iterator[None]:
    """NumPy's solver, whatever the number of points."""
    before = ss.kang_nam.get_backend()
    ss.kang_nam.set_backend("numpy")
    yield
    ss.kang_nam.set_backend(before)


def _points(n: int) -> ss.Parameters:
    """Some of every family in one array, which sends points down every way through the solver."""
    parts = [
        family(np.random.default_rng([51, k]), n).broadcast(*PARAMETERS)
        for k, family in enumerate(FAMILIES.values())
    ]
    return ss.Parameters(*(np.concatenate(columns) for columns in zip(*parts, strict=True)))


def test_the_certificates_settle_most_points() -> None:
    """A bound that is too loose shows in the points that need more digits."""
    shares = {}
    for number, name in enumerate(("random", "right angle", "alpha = 1 + beta", "beta = 0")):
        p = FAMILIES[name](np.random.default_rng([53, number]), 4000)
        shares[name] = [
            float(ss.equilibria(p, contact=contact).escalated.mean()) for contact in (True, False)
        ]
    assert all(share < 0.004 for contact in shares.values() for share in contact)


def test_every_rung_gives_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    """Double-double arithmetic, which is asked first, and intervals."""
    p, plain, calls = (
        FAMILIES["near folds"](np.random.default_rng(54), 60),
        adaptive_precision.equilibria,
        list[int](),
    )
    monkeypatch.setattr(
        adaptive_precision,
        "equilibria",
        lambda *given, **named: (calls.append(1), plain(*given, **named))[1],
    )
    found = [ss.equilibria(p)]
    assert not calls
    monkeypatch.setattr(
        solver, "_solve_widely", lambda given, contact, out, rows: np.arange(rows.size)
    )
    found.append(ss.equilibria(p))
    assert found[0].escalated.sum() == len(calls) > 0
    assert (found[0].escalated == found[1].escalated).all()
    assert (found[0].count == found[1].count).all()
    assert (found[0].undamped == found[1].undamped).all()
    both = [np.nan_to_num(eq.theta) for eq in found]
    assert (np.abs(both[0] - both[1]) <= 4 * np.nan_to_num(found[0].error + found[1].error)).all()


#: tan(θ/2) of three roots of one point, and what is there: all are equilibria.
T = (0.5, 1.0, 2.0)
GOOD = dict(
    L=1.0, x=0.0, y=-0.1, radius=1e-15, error=1e-15, member=True, outsider=False, known=True
)


def _settled(
    monkeypatch: pytest.MonkeyPatch,
    changes: dict[str, Any],
    contact: bool = True,
    t: tuple[float, ...] = T,
) -> tuple[bool, block.Slots]:
    """The result of a block for three roots of which the middle one has changed, at the second of
    two points.
    """
    columns = {name: [value, changes.get(name, value), value] for name, value in GOOD.items()} | {
        "code": [1.0, 2.0, 1.0]
    }
    given = {
        name: np.repeat(np.array(values)[:, None], 2, axis=1) for name, values in columns.items()
    }
    monkeypatch.setattr(block.kernel, "at_root", lambda *_: kernel.Root(**given))
    out = block.Slots(3, 3 if contact else 4)
    point = kernel.Point(*[np.ones(2)] * 7, float(contact))
    times = np.repeat(np.array(t)[:, None], 2, axis=1)
    settled = block._some(
        times,
        point,
        kernel.LineBalance(*[np.ones(2)] * 7),
        out,
        np.array([2, 1]),
        np.float64(2.0**-53),
    )
    assert settled[0] == settled[1]
    return bool(settled[1]), out


@pytest.mark.parametrize(
    "changes",
    [
        {"member": False},  # neither equilibrium nor certainly none
        {"known": False},
        {"error": 1.1e-12},
        {"error": np.nan},
        {"radius": np.inf},
        {"radius": 0.7},
        {"radius": 0.45},  # reaches the third root, not the first
        {"member": False, "outsider": True},  # two equilibria in contact can't be
    ],
    ids=str,
)
def test_one_missing_certificate_settles_nothing(
    monkeypatch: pytest.MonkeyPatch, changes: dict[str, Any]
) -> None:
    settled, out = _settled(monkeypatch, changes)
    assert not settled
    assert out.count.tolist() == [0, 0, 0]


@pytest.mark.parametrize(
    "t", [(0.5, 0.5, 2.0), (0.5, 2.0, 2.0), (0.5, np.nan, 2.0), (-0.5, 1.0, 2.0), (0.0, 1.0, 2.0)]
)
def test_roots_that_may_be_one_or_lie_below_0_settle_nothing_in_contact(
    monkeypatch: pytest.MonkeyPatch, t: Any
) -> None:
    assert not _settled(monkeypatch, {}, t=t)[0]
    assert _settled(monkeypatch, {}, contact=False, t=t)[0] == (t[0] <= 0)


def test_points_without_an_answer_are_marked_with_their_reason(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    p = ss.Parameters(1.0, [0.5, 1e200, 0.7], [0.3, 1e200, 0.3], 1.0, 1.0, 1.0)
    eq = ss.equilibria(p)
    assert eq.decided.tolist() == [True, False, True]
    assert eq.escalated.tolist() == [False, True, False]
    assert eq.count.tolist() == [1, 0, 1]
    assert "beyond float64" in eq.reason(1)
    assert eq.reason(0) == ""
    assert np.isnan(eq.theta[1]).all()
    assert not eq.fold.any()
    with pytest.raises(ss.errors.ConvergenceError, match="beyond float64"):
        eq.require_decided()
    assert ss.equilibria(p.replace(mu0=0.5, kappa=0.3)).require_decided().count == 1


@pytest.mark.parametrize("contact", [True, False])
def test_blocks_and_threads_do_not_show(monkeypatch: pytest.MonkeyPatch, contact: bool) -> None:
    p = _points(8 if contact else 4)
    whole, in_blocks = ss.equilibria(p, contact=contact), solver._in_blocks
    monkeypatch.setattr(solver, "BLOCK", 7)
    monkeypatch.setattr(solver, "_in_blocks", lambda p, _, work: in_blocks(p, 7, work))
    for threads in (1, 3):
        ss.kang_nam.set_backend("numpy", threads=threads)
        pieces = ss.equilibria(p, contact=contact)
        for name in ("theta", "L", "count", "undamped", "error", "escalated"):
            np.testing.assert_array_equal(getattr(pieces, name), getattr(whole, name))


#: In lift-off the spring is so short here that the trace of its stiffness is negative.
SHORT = (0.311, 0.661, 0.143, 1.791, 2.269, 0.0)


def test_eigenvalues_are_those_of_the_stiffness() -> None:
    for contact in (True, False):
        columns = [
            np.append(column, value)
            for column, value in zip(_points(6).broadcast(*PARAMETERS), SHORT, strict=True)
        ]
        p = ss.Parameters(*columns)
        eq = ss.equilibria(p, contact=contact)
        _, mu0, _, alpha, sigma, beta = p.broadcast(*PARAMETERS)
        traces = []
        for row, slot in zip(
            *np.nonzero(np.arange(eq.theta.shape[1]) < eq.count[:, None]), strict=True
        ):
            s, c, L = np.sin(eq.theta[row, slot]), np.cos(eq.theta[row, slot]), eq.L[row, slot]
            K = np.array(
                [
                    [
                        sigma[row] * (1 - s * s / L) + alpha[row],
                        sigma[row] / L * s * c + mu0[row] * contact,
                    ],
                    [sigma[row] / L * s * c, sigma[row] * (1 - c * c / L) + beta[row] + contact],
                ]
            )
            found, size = eq.eigenvalues[row, slot], np.abs(K).max()
            np.testing.assert_allclose(found[2:], -found[:2])
            traces.append(np.trace(K))
            assert abs(found[0]) >= abs(found[1]) * (
                1 - 1e-9
            )  # the larger first: it loses no digits
            wanted = np.poly(-np.linalg.eigvals(K).astype(complex))
            np.testing.assert_allclose(
                np.poly(found[:2] ** 2), wanted, atol=1e-9 * max(size, 1) ** 2
            )
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
    ss.kang_nam.set_backend(backend)
    given = dict(theta0=1.0, mu0=size, kappa=size, alpha=1.0, sigma=1.0, beta=1.0)
    with pytest.raises(
        ss.errors.ConvergenceError, match=r"theta0=1\.0, mu0=.* is beyond float64"
    ) as failure:
        ss.equilibria(ss.Parameters(**given))
    (state,) = ss.precise.equilibria(**given, dps=20)
    said = float(str(failure.value).split("log10 L = ")[1].split(" ")[0])
    assert said == pytest.approx(float(mpmath.log10(state.L)), rel=2e-6)
