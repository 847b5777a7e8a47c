"""The friction up to which sliding is unique, against all minors and states counted by hand."""

import dataclasses
from itertools import chain, combinations
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.matrices.contacts import directions
from spragsym.matrices.uniqueness import unique_up_to
from tests.oracles.brakes import held_block


def operators(n: int, pairs: int, seed: int) -> tuple[Any, Any, Any]:
    """A random model with contact pairs, and A(0) and the slope of A in the friction."""
    rng = np.random.default_rng(seed)
    K, each = held_block(n, pairs, rng)
    W_n, W_t, k = directions(each, n, {})
    whole = K + (W_n.T * k) @ W_n
    m = ss.matrices(np.eye(n), whole, each)
    inverse = np.linalg.inv(K)
    return m, np.diag(1.0 / k) + W_n @ inverse @ W_n.T, W_n @ inverse @ W_t.T


def is_p_matrix(A: np.ndarray) -> bool:
    rows = range(len(A))
    some = chain.from_iterable(combinations(rows, size) for size in range(1, len(A) + 1))
    return all(np.linalg.det(A[np.ix_(one, one)]) > 0 for one in some)


@pytest.mark.parametrize("pairs", [1, 3, 6])
def test_up_to_it_all_minors_are_positive_and_the_symmetric_part_ends_there(pairs: int) -> None:
    ends = 0
    for seed in range(12):
        m, A, slope = operators(14, pairs, seed)
        found = m.unique_up_to(m.Parameters(mu=0.3))
        for mu in np.linspace(0.0, found, 9):
            assert is_p_matrix(A + mu * slope)
        if found < 9.9:
            beyond = A + found * (1.0 + 1e-6) * slope
            assert np.linalg.eigvalsh(beyond + beyond.T)[0] < 0.0
            ends += 1
    assert ends >= 2


def test_beyond_it_a_load_has_two_states() -> None:
    """Of one contact the criterion is sharp: states are counted by contacts that touch or not."""
    m, A, slope = next(
        one for seed in range(20) if (one := operators(6, 1, seed))[2][0, 0] < -0.2 * one[1][0, 0]
    )
    limit = m.unique_up_to(m.Parameters(mu=0.0))
    for factor, count in ((0.999, 1), (1.001, 2)):
        a = (A + factor * limit * slope)[0, 0]
        gap = 1.0
        states = [p for p, w in ((0.0, gap), (-gap / a, 0.0)) if p >= 0 and w >= 0]
        assert len(states) == count


def test_softer_contacts_are_those_of_softer_pairs() -> None:
    """As a parameter that is held, and as the one that varies; C makes onsets simple."""
    n, share, span = 6, 0.5, {"mu": (0.0, 3.0)}
    K, pairs = held_block(n, 3, np.random.default_rng(4))
    W_n, _, k = directions(pairs, n, {})
    contact = (W_n.T * k) @ W_n
    m = ss.matrices(np.eye(n), K + contact, pairs, rayleigh=(1e-3, 1e-3))
    softer = [dataclasses.replace(one, stiffness=share * one.stiffness) for one in pairs]
    other = ss.matrices(np.eye(n), K + share * contact, softer, C=m.given["C"])
    p, q = m.Parameters(contact=share), other.Parameters()
    on, there = (ss.flutter_onsets(one, "mu", between=span, threshold=0.0) for one in (p, q))
    assert on.mu == pytest.approx(there.mu, abs=1e-9)
    limits = [one.model.unique_up_to(one.replace(mu=0.0)) for one in (p, q)]
    assert limits[0] == pytest.approx(limits[1])
    r = m.Parameters(mu=on.mu[0])
    along = ss.flutter_onsets(r, "contact", between={"contact": (0.3, 2.0)}, threshold=0.0)
    assert np.abs(along.contact - share).min() < 1e-9


def test_what_holds_no_body_is_refused() -> None:
    pair = ss.ContactPair(across=(1,), along=(0,), stiffness=2.0)
    m = ss.matrices(np.eye(2), np.diag([1.0, 2.0]), [pair])
    with pytest.raises(ss.errors.ModelError, match="hold each body"):
        m.unique_up_to(m.Parameters(mu=0.0))
    m = ss.matrices(np.eye(2), np.eye(2), np.eye(2))
    with pytest.raises(ss.errors.ModelError, match="contact pairs"):
        m.unique_up_to(m.Parameters(mu=0.0))


def test_roundings_are_counted() -> None:
    """A stiffness that is rounded by more than its lowest eigenvalue holds nothing."""
    W, K = np.eye(2), np.diag([1.0, 1e-6])
    assert 1.0 < unique_up_to(K + W, K, W, -W, np.ones(2)) < 1.0 + 1e-6
    with pytest.raises(ss.errors.ModelError):
        unique_up_to(K + W, np.full((2, 2), 1e9), W, -W, np.ones(2))
