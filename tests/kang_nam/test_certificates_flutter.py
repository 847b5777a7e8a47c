"""The parts that prove flutter onsets, each against exact rational numbers worked out by hand or by
another way.
"""

from fractions import Fraction

import numpy as np
import pytest

from spragsym.generated import stability
from spragsym.kang_nam import flutter
from spragsym.kang_nam.quartic import adaptive_precision
from spragsym.numerics import balls
from spragsym.numerics.balls import UndecidedSign
from spragsym.numerics.polynomials import primitive
from tests.oracles.families import random_fluttering
from tests.support import exact_onsets, middle_of, with_roots


def test_multiple_roots_are_counted() -> None:
    """(v − 1/3)³ (v − 1/2)² (v − 3/4), in place of the polynomial of an elimination."""
    elimination = flutter.Elimination(*map(Fraction, (1, 1, 1, 1, 0)))
    third, half, other = Fraction(1, 3), Fraction(1, 2), Fraction(3, 4)
    elimination.__dict__["full"] = primitive(with_roots(third, third, third, half, half, other))
    for bits in (1, 90):
        roots = elimination.roots(bits)
        assert all(
            root.low <= true <= root.high
            for root, true in zip(roots, (third, half, other), strict=True)
        )
        assert [elimination.multiplicity(root) for root in roots] == [3, 2, 1]


def test_directions_end_before_180_degrees() -> None:
    """Of v (2 v − 1)(v − 1) the roots 0 and 1/2: θ = π is no direction in contact."""
    elimination = flutter.Elimination(*map(Fraction, (1, 1, 1, 1, 1)))
    vars(elimination)["simple"] = (0, 1, -3, 2)
    half, none = Fraction(1, 2), Fraction(0)
    assert [(root.low, root.high) for root in elimination.roots(60)] == [(none, none), (half, half)]


def test_a_boundary_is_touched_at_an_even_root_of_one_length(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Where the discriminant's slope may be 0: else nothing is said."""
    given = (Fraction(13, 10), Fraction(7, 1000), Fraction(13, 10), Fraction(32, 100), Fraction(0))
    assert {onset.side for onset in exact_onsets(*given)} == {1, -1}
    with balls.precision(192):
        zero = balls.between(Fraction(-1, 2**150), Fraction(1, 2**150))
    monkeypatch.setattr(stability, "flutter_crossing", lambda *_: (zero, zero))
    for multiplicity in (2, 4):
        monkeypatch.setattr(flutter.Elimination, "multiplicity", lambda *_, m=multiplicity: m)
        assert {onset.side for onset in exact_onsets(*given)} == {0}
    monkeypatch.setattr(flutter.Elimination, "multiplicity", lambda *_: 3)
    with pytest.raises(UndecidedSign, match="slope"):
        exact_onsets(*given)
    monkeypatch.setattr(flutter.Elimination, "multiplicity", lambda *_: 2)
    plain = flutter._lengths
    monkeypatch.setattr(flutter, "_lengths", lambda *given: [*plain(*given)] * 2)
    with pytest.raises(UndecidedSign, match="slope"):
        exact_onsets(*given)


@pytest.mark.thorough
def test_a_rank_is_that_among_the_equilibria_of_the_point() -> None:
    """Which are proved, with more digits, at a friction that is as exact as its onset's θ₀ is not:
    none is next to a fold.
    """
    rng, kinds = np.random.default_rng(77), set()
    for _ in range(40):
        p = random_fluttering(rng)
        values = [
            Fraction(float(value)) for value in p.scalars("mu0", "kappa", "alpha", "sigma", "beta")
        ]
        for onset in exact_onsets(*values):
            states = adaptive_precision.equilibria(
                Fraction(middle_of(onset.parameters[0])), *values
            ).states
            nearest = int(
                np.argmin([abs(float(state.theta) - middle_of(onset.theta)) for state in states])
            )
            assert (onset.branch, onset.count) == (nearest, len(states))
            assert balls.sign(onset.y) < 0
            kinds.add((onset.branch, onset.count))
    assert kinds == {(0, 1), (2, 3)}


def test_a_crossing_is_one_whatever_the_multiplicity(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the discriminant's slope is not 0 the boundary is crossed, though the polynomial has
    another factor there.
    """
    given = (Fraction(13, 10), Fraction(7, 1000), Fraction(13, 10), Fraction(32, 100), Fraction(0))
    sides = [onset.side for onset in exact_onsets(*given)]
    monkeypatch.setattr(flutter.Elimination, "multiplicity", lambda *_: 2)
    assert [onset.side for onset in exact_onsets(*given)] == sides
    assert set(sides) == {1, -1}


def test_a_root_that_may_be_at_the_edge_of_contact_is_undecided() -> None:
    """At sin θ = 0 to 2⁻⁹⁰, with a root at t = 2⁻⁹⁵."""
    roots = [Fraction(1, 2**95), Fraction(1, 4), Fraction(2, 3), Fraction(-12, 5)]
    with balls.precision(300):
        quartic = tuple(map(balls.exact, with_roots(*roots)))
        edge = balls.between(-Fraction(1, 2**90), Fraction(1, 2**90))
        with pytest.raises(UndecidedSign, match="y = 0"):
            flutter.rank(quartic, balls.exact(roots[2]), edge, 150)
        for clear in (Fraction(-1, 2**90), Fraction(1, 2**100)):
            assert flutter.rank(quartic, balls.exact(roots[2]), balls.exact(clear), 150) == (2, 3)
