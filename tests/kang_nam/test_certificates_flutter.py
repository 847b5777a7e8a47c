"""The parts that prove flutter onsets, each against exact rational numbers worked out by hand or by another way."""

from __future__ import annotations

from fractions import Fraction
from types import SimpleNamespace

import numpy as np
import pytest

from spragsym.exact import intervals
from spragsym.exact.descartes import Root
from spragsym.exact.polynomials import Undecided, primitive
from spragsym.generated import stability
from spragsym.kang_nam.catastrophe import flutter_proofs
from spragsym.kang_nam.statics import adaptive_precision
from tests.oracles.families import random_fluttering
from tests.support import exact_onsets, middle_of, with_roots


def test_multiple_roots_are_counted() -> None:
    """(v − 1/3)³ (v − 1/2)² (v − 3/4), in place of the polynomial of an elimination."""
    elimination = flutter_proofs.Elimination(*map(Fraction, (1, 1, 1, 1, 0)))
    third, half, other = Fraction(1, 3), Fraction(1, 2), Fraction(3, 4)
    elimination.__dict__["full"] = primitive(with_roots(third, third, third, half, half, other))
    for bits in (1, 90):
        roots = elimination.roots(bits)
        assert all(root.low <= true <= root.high for root, true in zip(roots, (third, half, other), strict=True))
        assert [elimination.multiplicity(root) for root in roots] == [3, 2, 1]


@pytest.mark.parametrize(
    ("quadratic", "lengths"),
    [
        ((2, -3, 1), [2, 1]), ((4, -6, 2), [2, 1]), ((2, 3, 1), []), ((5, -2, 1), []), ((5, 2, 1), []),
        ((Fraction(3, 4), -2, 1), [Fraction(3, 2), Fraction(1, 2)]),
    ],
)  # fmt: skip
def test_lengths_where_both_conditions_are_one(
    monkeypatch: pytest.MonkeyPatch, quadratic: tuple[Fraction, ...], lengths: list[Fraction]
) -> None:
    """Both roots of the quadratic in L, if they are positive: the signs of its coefficients are +, −, +."""
    arith = intervals.arithmetic()
    with arith.precision(100):
        monkeypatch.setattr(stability, "flutter_quadratic", lambda *_: tuple(map(arith.exact, map(Fraction, quadratic))))
        zero = arith.between(Fraction(-1, 2**80), Fraction(1, 2**80))
        spring = flutter_proofs._Spring(Root(Fraction(0), Fraction(0)), zero, zero, zero)
        same = SimpleNamespace(length=lambda *_: (zero, zero), vanishes=lambda *_: True, degree_of_length=4)
        found = flutter_proofs._lengths(arith, same, spring, (zero,) * 5)
        assert len(found) == len(lengths)
        for value, wanted in zip(found, lengths, strict=True):
            low, high = arith.ends(value)
            assert low <= wanted <= high
            assert high - low < 1e-20
        for way in (1, -1):
            apart = SimpleNamespace(length=lambda *_, way=way: (arith.exact(Fraction(3 * way)), arith.exact(Fraction(2))))
            found = flutter_proofs._lengths(arith, apart, spring, (zero,) * 5)
            assert [float(arith.ends(value)[0]) for value in found] == [1.5] * (way > 0)
        open_one = SimpleNamespace(length=lambda *_: (zero, zero), vanishes=lambda *_: False, degree_of_length=4)
        with pytest.raises(Undecided, match="Y = 0"):
            flutter_proofs._lengths(arith, open_one, spring, (zero,) * 5)


def test_directions_end_before_180_degrees() -> None:
    """Of v (2 v − 1)(v − 1) the roots 0 and 1/2: θ = π is no direction in contact."""
    elimination = flutter_proofs.Elimination(*map(Fraction, (1, 1, 1, 1, 1)))
    vars(elimination)["simple"] = (0, 1, -3, 2)
    half, none = Fraction(1, 2), Fraction(0)
    assert [tuple(root) for root in elimination.roots(60)] == [(none, none), (half, half)]


def test_a_boundary_is_touched_at_an_even_root_of_one_length(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the discriminant's slope may be 0: else nothing is said."""
    given, arith = (Fraction(13, 10), Fraction(7, 1000), Fraction(13, 10), Fraction(32, 100), Fraction(0)), intervals.arithmetic()
    assert {onset.side for onset in exact_onsets(*given)} == {1, -1}
    with arith.precision(192):
        zero = arith.between(Fraction(-1, 2**150), Fraction(1, 2**150))
    monkeypatch.setattr(stability, "flutter_crossing", lambda *_: (zero, zero))
    for multiplicity in (2, 4):
        monkeypatch.setattr(flutter_proofs.Elimination, "multiplicity", lambda *_, m=multiplicity: m)
        assert {onset.side for onset in exact_onsets(*given)} == {0}
    monkeypatch.setattr(flutter_proofs.Elimination, "multiplicity", lambda *_: 3)
    with pytest.raises(Undecided, match="slope"):
        exact_onsets(*given)
    monkeypatch.setattr(flutter_proofs.Elimination, "multiplicity", lambda *_: 2)
    plain = flutter_proofs._lengths
    monkeypatch.setattr(flutter_proofs, "_lengths", lambda *given: [*plain(*given)] * 2)
    with pytest.raises(Undecided, match="slope"):
        exact_onsets(*given)


def _held(arith: intervals.Arithmetic, *values: Fraction | int) -> list[intervals.Interval]:
    return [arith.between(Fraction(value) - Fraction(1, 2**90), Fraction(value) + Fraction(1, 2**90)) for value in values]


@pytest.mark.parametrize("place", [0, 1, 2])
@pytest.mark.parametrize("edge", [Fraction(-1, 3), Fraction(1, 100), Fraction(3, 5), Fraction(4, 5), Fraction(0)])
def test_a_rank_counts_what_is_in_contact(place: int, edge: Fraction) -> None:
    """Of roots t = 1/4, 2/3, 5/2 and one below 0, of which those with sin θ above the edge count: 8/17, 12/13, 20/29."""
    arith, roots = intervals.arithmetic(), [Fraction(1, 4), Fraction(2, 3), Fraction(5, 2), Fraction(-12, 5)]
    sines = [2 * t / (1 + t * t) for t in roots[:3]]
    inside = [sine > edge for sine in sines]
    if not inside[place]:
        return
    with arith.precision(120):
        (t,), (border,) = _held(arith, roots[place]), (arith.exact(edge),)
        arguments = arith, tuple(_held(arith, *with_roots(*roots, lead=-3))), t, border
        below, above = sum(inside[:place]), sum(inside[place + 1 :])
        if (below, above) in ((0, 0), (2, 0), (0, 2)):
            assert flutter_proofs.rank(*arguments) == (below, 1 + below + above)
            return
        with pytest.raises(Undecided, match="equilibria below"):  # neither one nor three
            flutter_proofs.rank(*arguments)


@pytest.mark.thorough
def test_a_rank_is_that_among_the_equilibria_of_the_point() -> None:
    """Which are proved, with more digits, at a friction that is as exact as its onset's θ₀ is not: none is next to a fold."""
    rng, kinds, arith = np.random.default_rng(77), set(), intervals.arithmetic()
    for _ in range(40):
        p = random_fluttering(rng)
        values = [Fraction(float(value)) for value in p.scalars("mu0", "kappa", "alpha", "sigma", "beta")]
        for onset in exact_onsets(*values):
            states = adaptive_precision.equilibria(Fraction(middle_of(onset.theta0)), *values, arith=arith).states
            nearest = int(np.argmin([abs(float(state.theta) - middle_of(onset.theta)) for state in states]))
            assert (onset.branch, onset.count) == (nearest, len(states))
            assert arith.sign(onset.y) < 0
            kinds.add((onset.branch, onset.count))
    assert kinds == {(0, 1), (2, 3)}


def test_a_crossing_is_one_whatever_the_multiplicity(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the discriminant's slope is not 0 the boundary is crossed, though the polynomial has another factor there."""
    given = (Fraction(13, 10), Fraction(7, 1000), Fraction(13, 10), Fraction(32, 100), Fraction(0))
    sides = [onset.side for onset in exact_onsets(*given)]
    monkeypatch.setattr(flutter_proofs.Elimination, "multiplicity", lambda *_: 2)
    assert [onset.side for onset in exact_onsets(*given)] == sides
    assert set(sides) == {1, -1}


def test_a_root_that_may_be_at_the_edge_of_contact_is_undecided() -> None:
    """At sin θ = 0 to 2⁻⁹⁰, with a root at t = 2⁻⁹⁵."""
    arith, roots = intervals.arithmetic(), [Fraction(1, 2**95), Fraction(1, 4), Fraction(2, 3), Fraction(-12, 5)]
    with arith.precision(300):
        quartic = tuple(map(arith.exact, with_roots(*roots)))
        edge = arith.between(-Fraction(1, 2**90), Fraction(1, 2**90))
        with pytest.raises(Undecided, match="holds 0"):
            flutter_proofs.rank(arith, quartic, arith.exact(roots[2]), edge)
        for clear in (Fraction(-1, 2**90), Fraction(1, 2**100)):
            assert flutter_proofs.rank(arith, quartic, arith.exact(roots[2]), arith.exact(clear)) == (2, 3)


@pytest.mark.parametrize(
    ("signs", "changes"),
    [("+-", 1), ("++", 0), ("+0-", 1), ("-0+", 1), ("+-0+-", 3), ("+0+", None), ("-0-", None), ("0+", None), ("+0", None),
     ("0+-", None), ("0-+", None), ("+-0", None), ("+00-", None), ("+-+-+", 4)],
)  # fmt: skip
def test_changes_of_sign_with_open_ones_between(signs: str, changes: int | None) -> None:
    arith = intervals.arithmetic()
    with arith.precision(60):
        held = {"+": arith.exact(Fraction(2)), "-": arith.exact(Fraction(-3)), "0": arith.between(Fraction(-1), Fraction(1))}
        values = [held[sign] for sign in signs]
        if changes is None:
            with pytest.raises(Undecided, match="holds 0"):
                flutter_proofs._variations(arith, values)
        else:
            assert flutter_proofs._variations(arith, values) == changes
