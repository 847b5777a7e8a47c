"""Bounds of ``precise`` at any precision, global precisions left alone, threads, and points without
an answer.
"""

import dataclasses
import sys
from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym import precise
from tests.oracles.families import cusp_wedge
from tests.oracles.true_errors import points, worst_shares

# -------------------------------------------------------------------------------------------------
# bounds


@pytest.mark.thorough
def test_bounds_hold_at_any_precision() -> None:
    """True errors, by Newton's method on the forces with a hundred digits more, whatever precision
    the caller has set.
    """
    for point in [(0.5, 0.5, 0.007, 0.007, 0.1, 0.0), *points(20, seed=3)]:
        shares = worst_shares(point, (1, 2, 15, 16, 17, 40, 50, 333))
        assert max(shares.values()) <= 1, (point, shares)
    for point, precisions, contact in (
        ((0.5, 0.5, 0.007, 0.007, 0.1, 0.0), (1, 1000), True),
        ((0.5, 0.5, 0.008, 0.008, 0.125, 0.0), (1, 8, 40, 150), False),
        ((1.25, 0.0, 0.5, 0.25, 1.0, 0.5), (1, 8, 40, 150), False),
    ):
        assert max(worst_shares(point, precisions, contact=contact).values()) <= 1


@pytest.mark.parametrize(
    ("mu0", "alpha", "contact"),
    [(0, 0, True), (0, "0.3", False), ("0.5", 0, False), (0, 1, True)],
    ids=[
        "no friction, no stiffness along the belt",
        "a = 0 in lift-off",
        "lift-off without it",
        "alpha = 1 + beta",
    ],
)
def test_more_digits_where_a_factor_is_even(
    mu0: int | str, alpha: int | str, contact: bool
) -> None:
    """Where one factor of the quartic in t is t² − 1 or another without a linear term."""
    sigma, beta = 1, "0.3" if alpha == "0.3" else 0
    assert precise.equilibria(
        theta0=1, mu0=mu0, kappa="0.4", alpha=alpha, sigma=sigma, beta=beta, contact=contact, dps=30
    )


# -----------------------------------------------------------------------------------------------
# global precisions


def _everything() -> dict[str, Any]:
    """A call of each kind that needs more digits than float64 has; every bit of its results."""
    p = ss.Parameters.article(theta0=0.8)
    wedge = cusp_wedge(np.random.default_rng(5), 12)
    found = {
        "escalated": [ss.equilibria(wedge)],
        "sums": [ss.equilibria(wedge, contact=False)],
        "cusps": [ss.cusps(p)],
        "folds": [ss.folds(p, "theta0"), ss.folds(p, "mu0")],
        **{f"precise {dps}": precise.equilibria(theta0_deg=30, dps=dps) for dps in (5, 50, 200)},
        "precise cusps": precise.cusps(dps=33).cusps,
    }
    return {name: repr([_bits(one) for one in many]) for name, many in found.items()}


def _bits(value: Any) -> Any:
    if isinstance(value, mpmath.mpf):
        return value._mpf_
    if isinstance(value, ss.results.Equilibria):
        return [
            _bits(getattr(value, name))
            for name in ("count", "theta", "L", "x", "y", "error", "undamped")
        ]
    if dataclasses.is_dataclass(value):
        return [_bits(part) for part in vars(value).values()]
    if isinstance(value, dict):
        return {name: _bits(part) for name, part in value.items()}
    return value.tobytes() if isinstance(value, np.ndarray) else str(value)


def test_no_precision_is_touched(monkeypatch: pytest.MonkeyPatch) -> None:
    """Not even for a moment: setting one is an error here, and Arb can't be imported."""

    def refuse(*_: Any) -> None:
        raise AssertionError("a global precision is set")

    expected = _everything()
    monkeypatch.setitem(sys.modules, "flint", None)
    for context in (mpmath.mp, mpmath.iv, mpmath.fp):
        for name in ("prec", "dps"):
            owner = next(one for one in type(context).__mro__ if name in vars(one))
            getter = vars(owner)[name]
            monkeypatch.setattr(
                owner,
                name,
                property(getattr(getter, "fget", None) or (lambda _, value=getter: value), refuse),
            )
    with pytest.raises(AssertionError, match="is set"):
        mpmath.mp.prec = 70
    assert _everything() == expected


def test_results_do_not_depend_on_the_callers_precisions() -> None:
    flint = pytest.importorskip("flint")
    expected = _everything()
    before = flint.ctx.prec, mpmath.iv.prec
    try:
        with mpmath.workdps(7):
            flint.ctx.prec = mpmath.iv.prec = 11
            assert _everything() == expected
            assert (flint.ctx.prec, mpmath.iv.prec, mpmath.mp.dps) == (11, 11, 7)
    finally:
        flint.ctx.prec, mpmath.iv.prec = before
