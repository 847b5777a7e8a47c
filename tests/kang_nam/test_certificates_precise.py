"""Numbers taken exactly, ranges, digits, and the radii of cusps."""

import math
from fractions import Fraction
from typing import Any

import mpmath
import pytest

import spragsym as ss
from spragsym.generated.quantities import PARAMETERS
from spragsym.models.parameters import Range
from tests.oracles import reference

# -------------------------------------------------------------------------------------------------
# precise


def test_a_number_is_what_it_writes() -> None:
    for given, exact in (
        (1, Fraction(1)),
        (0.5, Fraction(1, 2)),
        ("0.007", Fraction(7, 1000)),
        (" +7/1000 ", Fraction(7, 1000)),
        (".5e-1", Fraction(1, 20)),
        ("1.", Fraction(1)),
        (Fraction(2, 3), Fraction(2, 3)),
        (mpmath.mpf("0.75"), Fraction(3, 4)),
        (mpmath.mpf(6), Fraction(6)),
        ("7/1000", Fraction(7, 1000)),
        ("10/10", Fraction(1)),
    ):
        assert ss.precise.as_exact("kappa", given, ss.Parameters.ranges["kappa"]) == exact


def test_what_is_no_number_in_range_is_named() -> None:
    for name, given, error in (
        ("kappa", True, ss.errors.ParameterTypeError),
        ("kappa", None, ss.errors.ParameterTypeError),
        ("kappa", "seven", ss.errors.ParameterTypeError),
        ("kappa", "1/0", ss.errors.ParameterError),
        ("kappa", "1/00 ", ss.errors.ParameterError),
        ("kappa", math.nan, ss.errors.ParameterError),
        ("kappa", mpmath.inf, ss.errors.ParameterError),
        ("kappa", 0, ss.errors.ParameterError),
        ("kappa", mpmath.mpf(-1), ss.errors.ParameterError),
        ("alpha", "-1/9", ss.errors.ParameterError),
        ("theta0", math.pi, ss.errors.ParameterError),
        ("theta0", 4, ss.errors.ParameterError),
        ("theta0", 0, ss.errors.ParameterError),
    ):
        with pytest.raises(error, match=f"^{name} = "):
            ss.precise.as_exact(name, given, ss.Parameters.ranges[name])


def test_the_ends_of_ranges_that_belong_to_them() -> None:
    for name in ("alpha", "beta", "mu0"):
        assert ss.precise.as_exact(name, 0, ss.Parameters.ranges[name]) == 0
    assert ss.precise.as_exact("kappa", "1e300", ss.Parameters.ranges["kappa"]) == 10**300
    with pytest.raises(ss.errors.ParameterError, match=r"numpy\.radians"):
        ss.precise.as_exact("theta0", 49, ss.Parameters.ranges["theta0"])
    anything, half_open = Range(-math.inf), Range(0.0, 1.0, closed_high=True)
    assert ss.precise.as_exact("a", "-1e300", anything) == -(10**300)
    assert ss.precise.as_exact("a", 1, half_open) == 1
    with pytest.raises(ss.errors.ParameterError, match=r"^a = "):
        ss.precise.as_exact("a", Fraction(1) + Fraction(1, 10**30), half_open)


def _are_cusps(found: ss.precise.CuspProof, values: tuple[Any, ...], digits: int) -> None:
    """f = f′ = f″ = 0 by the balance of forces, and the geometry."""
    with mpmath.workdps(digits + 20):
        kappa, alpha, sigma, beta = (mpmath.mpf(str(value)) for value in values)
        for cusp in found:
            given = cusp.theta0, cusp.mu0, kappa, alpha, sigma, beta
            small = mpmath.mpf(10) ** -digits * (1 + abs(cusp.mu0) + cusp.L)
            for order in range(3):
                slope = mpmath.diff(
                    lambda theta, given=given: reference.along(theta, *given), cusp.theta, order
                )
                assert abs(slope) < mpmath.mpf(10) ** (8 * order) * small
            state = cusp.theta, cusp.L, cusp.x, cusp.y
            assert reference.lack_of_a_state(state, cusp.theta0, kappa, sigma, beta) < small


CUSPS = [("0.007", "0.007", "0.1", 0), ("0.3", 0, "1.7", "0.4"), ("0.2", "1.5", "0.9", "0.5")]


@pytest.mark.parametrize("dps", [3, 25])
def test_the_radius_of_a_cusp_holds_every_number(dps: int) -> None:
    for values in CUSPS:
        given = dict(zip(PARAMETERS[2:], values, strict=True))
        exact, rough = ss.precise.cusps(**given, dps=dps + 40), ss.precise.cusps(**given, dps=dps)
        assert len(exact) == len(rough)
        _are_cusps(exact, values, dps + 20)
        assert values[1] == 0 or all(cusp.versal for cusp in exact)
        assert [cusp.mu0 for cusp in rough] == sorted(cusp.mu0 for cusp in rough)
        with mpmath.workdps(dps + 40):
            for one in rough:
                names = ("theta0", "mu0", "theta", "L", "x", "y")
                gaps = [
                    max(abs(getattr(one, name) - getattr(two, name)) for name in names)
                    for two in exact
                ]
                size = max(1, *(abs(getattr(one, name)) for name in names))
                spare = (
                    2 if values[1] == "1.5" else 4
                )  # roots of intervals are found to half of the bits
                assert min(gaps) <= one.radius <= mpmath.mpf(10) ** -(dps + spare) * size * 1.01
        assert rough.count == exact.count
        if values[1] == "1.5":  # α = 1 + β
            assert (rough.polynomial, rough.sines, rough.count) == ((), (), None)
        else:
            assert rough.count == len(rough.sines) > 0
            assert all(high - low <= Fraction(1, 2**64) for low, high in rough.sines)
    assert rough[0] is rough.cusps[0]
