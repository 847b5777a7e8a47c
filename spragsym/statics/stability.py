"""Type of an equilibrium by the eigenvalues λ of its linearization, with and without damping.

Without damping, the type follows from the roots κ = −λ² of det(K − κ M). It is proved by signs:

- All κ are real if the leading minors of the Hankel matrix of their power sums are positive, and
  some κ is not real if a minor is negative (Hermite). With a symmetric K all κ are real.
- If all κ are real, one is negative exactly if one of their elementary symmetric functions is.

With gyroscopic forces the λ are the roots of det(λ² M + λ G + K). Where its odd coefficients are 0,
as with a symmetric K, that is a polynomial in κ too. Elsewhere some λ grows, since their sum is 0:
by flutter, or by divergence where all λ with a positive real part are real. Routh's array counts
the λ with a positive real part, and Sturm's chain counts the positive ones.

With damping, whether some λ has a positive real part follows from Hurwitz's determinants.

Signs come from intervals around the state; where these contain 0, from ball arithmetic.
"""

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from itertools import chain
from typing import Any, Self, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..models.forces import inertia_error
from ..models.model import Touching
from ..numerics import balls
from ..numerics.arithmetic import (
    Matrix,
    Number,
    characteristic,
    coupled,
    determinant,
    hurwitz,
    is_zero,
    part_of,
)
from ..numerics.balls import UndecidedSign, ball
from ..numerics.interval_arrays import (
    BoolArray,
    ComplexArray,
    FloatArray,
    Int8Array,
    IntArray,
    Intervals,
    ends_around,
    matrix,
    quiet,
    scale_of,
    stacked,
)
from ..numerics.polynomials import derivative
from ..numerics.precise_roots import as_balls, narrowed
from ..results import Equilibria, EquilibriumType
from .balance import NEGLIGIBLE, Balance, PreciseBalance
from .forces import Evaluation, Indicators, as_intervals, filled

#: A λ whose imaginary part over its size is smaller than this counts as real.
REAL = 1e-9
#: A state whose growth rate over its frequency is smaller than this is called neutral.
NEUTRAL_GROWTH = 1e-4
#: Converts the entries of a matrix to one number type, intervals or balls.
Converted: TypeAlias = Callable[[Matrix], Matrix]
#: Numbers at a state whose signs decide a question, as lists of numbers.
SignTest: TypeAlias = Callable[[Evaluation, Converted], Matrix]


@dataclass(frozen=True)
class Linearized:
    """Stability of N states by the full linearization, with dampers and slopes of the friction
    laws.
    """

    growth: FloatArray  #: largest real part of the λ
    sign: Int8Array  #: 1 where growth is proved, −1 where it is disproved, 0 where undecided
    eigenvalues: ComplexArray  #: all λ, shape (N, 2 n), by falling real part

    @property
    def stability(self) -> NDArray[np.str_]:
        """``"stable"``, ``"unstable"`` or ``"neutral"`` for each state; empty where the rate is not
        finite.

        A state is neutral if its growth rate is below :data:`NEUTRAL_GROWTH` times its frequency.
        That is the frequency of the λ of largest real part or, if this λ is real, the lowest
        frequency.
        """
        return verdicts(self.growth, self.eigenvalues)

    def with_sign(self, sign: Int8Array) -> Self:
        """The same with the sign of the growth known otherwise, which the growth then has."""
        return replace(self, growth=_bounded(self.eigenvalues[:, 0].real, sign), sign=sign)


def verdicts(growth: FloatArray, eigenvalues: ComplexArray) -> NDArray[np.str_]:
    """:attr:`Linearized.stability` from the growth rates and all λ, sorted by falling real part."""
    frequency = np.abs(eigenvalues.imag)
    frequency = np.where(frequency > REAL * np.abs(eigenvalues), frequency, np.inf)
    own = np.where(np.isfinite(frequency[:, 0]), frequency[:, 0], frequency.min(axis=1))
    neutral = np.abs(growth) <= NEUTRAL_GROWTH * np.where(np.isfinite(own), own, 0.0)
    return np.select([neutral, growth < 0, growth > 0], ["neutral", "stable", "unstable"], "")


def linearized(
    eq: Equilibria, states: tuple[IntArray, ...], enclosures: FloatArray | None
) -> Linearized:
    """Full linearization at some states, by their indices into the columns of ``eq``.

    ``enclosures`` are boxes around all states, with one state in each; without them, boxes follow
    from ``eq.error``.

    Source: eigenvalues of det(λ² M + λ (C + G) + K) = 0; the sign of the growth by Hurwitz's
    determinants, see :func:`decay`.
    """
    model = eq.parameters.model
    keys, which = _combinations(eq, states)
    balances = [Balance(model, key) for key in keys]
    balance = balances[0]
    columns = (
        np.broadcast_to(value[..., None], eq.undamped.shape)
        for value in eq.parameters.broadcast(*balance.parameters)
    )
    given = np.array([value[states] for value in columns]).reshape(
        len(balance.parameters), states[-1].size
    )
    q = np.array([eq[name][states] for name in balance.coordinates])
    if enclosures is None:
        off = eq.error[states] * scale_of(q)
        with quiet():
            ends = np.nextafter(ends_around(q, off), np.inf)
    else:
        number = np.full(eq.undamped.shape, -1)
        number[eq.states] = np.arange(eq.states[0].size if eq.states else 0)
        ends = enclosures[:, :, number[states]]
    sign = np.where(eq.undamped[states] == EquilibriumType.STABLE, 1, -1)
    undamped: NDArray[Any] = np.where(eq.marginal[states], 0, sign).astype(np.int8)
    groups = [np.flatnonzero(which == k) for k in range(len(keys))]
    # Interval arrays of millions of states at once would take gigabytes.
    chunk = 1 << 14
    parts = [
        _linearized(one, *(part[..., rows] for part in (q, given, ends, undamped)))
        for one, group in zip(balances, groups, strict=True)
        for rows in np.split(group, range(chunk, group.size, chunk))
    ]
    back = np.argsort(np.concatenate(groups), kind="stable")
    return Linearized(*(np.concatenate(part)[back] for part in zip(*parts, strict=True)))


def _combinations(eq: Equilibria, states: tuple[IntArray, ...]) -> tuple[list[Touching], IntArray]:
    """Combinations of touching contacts that occur, and the index of that of each state."""
    if eq.contact is not None:
        return [eq.contact], np.zeros(states[-1].size, dtype=int)
    names, which = np.unique(eq["touching"][states], return_inverse=True)
    return [tuple(name.split(", ")) for name in names.tolist()] or [True], which


def _linearized(
    balance: Balance, q: FloatArray, given: FloatArray, ends: FloatArray, undamped: Int8Array
) -> tuple[FloatArray, Int8Array, ComplexArray]:
    """Fields of :class:`Linearized` for states of one combination of contacts."""
    every = roots(*linearization(balance, q, given))
    every = np.take_along_axis(every, np.argsort(-every.real, axis=1, kind="stable"), axis=1)
    fastest = every[:, 0].real
    sign = -decay(balance, given, ends, undamped, fastest)
    return _bounded(fastest, sign), sign, every


def _bounded(fastest: FloatArray, sign: Int8Array) -> FloatArray:
    """Growth rates as floats; one that has the wrong sign by rounding is 0."""
    bounded = [np.minimum(fastest, 0.0), np.maximum(fastest, 0.0)]
    return np.select([sign < 0, sign > 0], bounded, fastest)


def classified(
    balance: Balance, states: FloatArray, given: FloatArray, ends: FloatArray
) -> tuple[Int8Array, BoolArray, ComplexArray]:
    """Types of states without damping, whether each is proved, and the 2 n roots λ as floats.

    ``states`` have the shape (n, N), ``given`` parameters (P, N), and ``ends`` are boxes with one
    state in each, (2, n, N). Types are codes of :class:`spragsym.EquilibriumType`; an unknown sign
    counts as 0 in a type that is not proved.
    """
    with quiet():
        signs, real, even = _over(balance, balance.prepared_at(given), ends)
    codes, proved = _types_by_signs(signs, real, even)

    def test_of(row: int) -> SignTest:
        return partial(_types, even[:, row])

    for row, signs in _with_digits(balance, given, ends, ~proved, test_of):
        codes[row], proved[row] = _types_by_signs(signs, real[:, row], even[:, row])
    M, G, K = linearization(balance, states, given, damping=False)
    if (error := inertia_error(M, balance.parameters, given)) and not _moves(
        balance, states, given
    ):
        raise error
    if balance.gyroscopic:
        every = roots(M, G, K)
        order = np.argsort(-np.abs(every), axis=1, kind="stable")
        return codes, proved, np.take_along_axis(every, order, axis=1)
    negated = -squares(M, K)  # λ²
    negated = np.take_along_axis(negated, np.argsort(-np.abs(negated), axis=1), axis=1)
    upper = np.sqrt(negated)
    return codes, proved, np.concatenate([upper, -upper], axis=1)


def roots(M: FloatArray, C: FloatArray, K: FloatArray) -> ComplexArray:
    """The roots λ of det(λ² M + λ C + K), of matrices of shape (…, n, n), by the companion matrix;
    NaN where an entry is not finite.
    """
    n = M.shape[-1]
    zero, unit = np.zeros_like(M), np.broadcast_to(np.eye(n), M.shape)
    return _eigenvalues(np.block([[zero, unit], [-_by_mass(M, K), -_by_mass(M, C)]]))


def squares(M: FloatArray, K: FloatArray) -> ComplexArray:
    """The roots κ = −λ² of det(K − κ M), unsorted; NaN where an entry is not finite."""
    return _eigenvalues(_by_mass(M, K))


def _are_finite(A: FloatArray) -> BoolArray:
    """Matrices all of whose entries are finite, with axes of size 1 in place of theirs."""
    out: BoolArray = np.logical_and.reduce(np.isfinite(A), axis=(-2, -1), keepdims=True)
    return out


def _by_mass(M: FloatArray, A: FloatArray) -> FloatArray:
    """M⁻¹ A, NaN where M is singular or an entry is not finite."""
    finite = _are_finite(M)
    regular = finite & (np.linalg.slogdet(np.where(finite, M, 0.0))[0][..., None, None] != 0)
    return np.where(regular, np.linalg.solve(np.where(regular, M, np.eye(M.shape[-1])), A), np.nan)


def _eigenvalues(A: FloatArray) -> ComplexArray:
    """The eigenvalues of matrices, NaN where an entry is not finite."""
    finite = _are_finite(A)
    out: ComplexArray = np.linalg.eigvals(np.where(finite, A, 0.0)).astype(complex)
    return np.where(finite[..., 0], out, np.nan)


def _moves(balance: Balance, states: FloatArray, given: FloatArray) -> bool:
    """Whether the mass matrix of each state that lacks a positive one is positive beside it: then a
    place is singular, as the middle of polar coordinates, and no parameter is to blame.
    """
    M, *_ = linearization(balance, states, given, damping=False)
    rows = [row for row in range(len(M)) if inertia_error(M[[row]], (), given[:0, [row]])]
    for row in rows:
        at = states[:, [row]]
        beside = at + np.random.default_rng(0).uniform(-1e-3, 1e-3, (len(at), 8)) * scale_of(at)
        M, *_ = linearization(balance, beside, np.repeat(given[:, [row]], 8, axis=1), False)
        if inertia_error(M, (), given[:0, [row] * 8]):
            return False
    return True


def without_eigenvalues(
    balance: Balance, states: FloatArray, given: FloatArray, undamped: ComplexArray
) -> BoolArray:
    """States whose eigenvalues, with or without damping, are not finite numbers."""
    out: BoolArray = np.logical_or.reduce(~np.isfinite(undamped), axis=1)
    # Only then do dampers alone leave the range of floats.
    rows = np.flatnonzero(extreme(given).any(axis=0) & ~out)
    if rows.size:
        every = roots(*linearization(balance, states[:, rows], given[:, rows]))
        out[rows] = np.logical_or.reduce(~np.isfinite(every), axis=1)
    return out


def extreme(given: FloatArray) -> BoolArray:
    """Values so large or small that products of some of them leave the range of floats."""
    size = np.abs(given)
    return (size > 1e100) | ((size < 1e-100) & (size > 0))


def linearization(
    balance: Balance, states: FloatArray, given: FloatArray, damping: bool = True
) -> tuple[FloatArray, ...]:
    """M, C + G and K at float states, each of shape (N, n, n); without ``damping``, G replaces C +
    G.

    Entries are NaN where a law has no value, as Hertz's beyond the border.
    """
    with quiet():
        at = balance.at(list(states), balance.floats(given), states.shape[1:], np)
        return tuple(
            np.moveaxis(filled(part, at.shape), -1, 0)
            for part in (
                at.mass(),
                at.by_rates() if damping else at.gyroscopic(),
                at.stiffness(),
            )
        )


def with_a_zero(balance: Balance, states: FloatArray, given: FloatArray) -> int:
    """Type of one state, shape (n, 1), that has an eigenvalue 0, as at a fold: by the other
    eigenvalues.
    """
    (M,), (G,), (K,) = linearization(balance, states, given, damping=False)
    if balance.gyroscopic:
        return _by_floats(roots(M, G, K))
    every = squares(M, K)
    others = np.delete(every, np.abs(every).argmin())
    if (np.abs(others.imag) > 1e-13 * np.abs(others).max(initial=0.0)).any():
        return int(EquilibriumType.FLUTTER)
    return int(EquilibriumType.STABLE if (others.real > 0).all() else EquilibriumType.DIVERGENT)


def _by_floats(every: ComplexArray) -> int:
    """Type of a state of a gyroscopic model from its 2 n roots λ, the smallest of which is 0."""
    others = every[np.argsort(np.abs(every))][1:]
    # Real and imaginary parts below this, relative to the largest λ, are rounding. A λ that should
    # be 0 too, as one of a pair, is off by the square root of the unit of rounding.
    rounding = 1e-7
    grow = others[others.real > rounding * np.abs(others).max(initial=0.0)]
    if (np.abs(grow.imag) > rounding * np.abs(grow)).any():
        return int(EquilibriumType.FLUTTER)
    return int(EquilibriumType.DIVERGENT if grow.size else EquilibriumType.STABLE)


def real(balance: Balance, parameters: Intervals, ends: FloatArray) -> BoolArray:
    """Boxes all over which all κ are proved to be real; equal ones may occur.

    ``parameters`` are prepared, ``ends`` boxes of coordinates.
    """
    signs, real, even = _over(balance, parameters, ends)
    minors = [part[1] for part in _by_blocks(signs, len(real))]
    parts = zip(real, even, minors, strict=True)
    return np.logical_and.reduce(
        [symmetric | (two & (part > 0).all(axis=0)) for symmetric, two, part in parts]
    )


def types_over(
    balance: Balance, parameters: Intervals, ends: FloatArray
) -> tuple[Int8Array, BoolArray]:
    """Type of all states in each box, a code of :class:`spragsym.EquilibriumType`, and whether it
    is proved; boxes of prepared parameters and of coordinates.
    """
    return _types_by_signs(*_over(balance, parameters, ends))


def _over(
    balance: Balance, parameters: Intervals, ends: FloatArray
) -> tuple[list[Int8Array], BoolArray, BoolArray]:
    """Signs of :func:`_types` over boxes, and the masks of :func:`_in_pairs`."""
    at = balance.state(Intervals(ends), parameters)
    real, even = _in_pairs(
        at,
        _symmetric(balance, parameters),
        lambda part: matrix(part, at.shape).magnitude.max(axis=(0, 1)) <= NEGLIGIBLE,
    )
    return _signs_over(at, partial(_types, even)), real, even


def _in_pairs(
    at: Evaluation, symmetric: BoolArray, vanishes: Callable[[Matrix], BoolArray | bool]
) -> tuple[BoolArray, BoolArray]:
    """Masks by block of :func:`_blocks`, shape (blocks, …), of what follows from symmetry.

    The first marks blocks whose κ are all real: K is symmetric and G vanishes. The second marks
    blocks whose λ come in pairs ± λ: K is symmetric, G vanishes, or the odd coefficients do.
    ``symmetric`` says where K is symmetric at every state. Whether it is at this state alone is
    asked only for a model with G.
    """
    real, even = list[BoolArray](), list[BoolArray]()
    for block in _blocks(at):
        without_G = vanishes(part_of(at.gyroscopic(), block))
        same = vanishes(part_of(at.circulatory(), block)) & at.balance.gyroscopic
        alike = symmetric | (len(block) == 1) | same
        real.append(alike & without_G)
        paired = alike | without_G
        even.append(paired if np.all(paired) else paired | vanishes([at.unpaired(block)]))
    return np.array(real), np.array(even)


def _blocks(at: Evaluation) -> list[tuple[int, ...]]:
    """Diagonal blocks of coordinates: M, G and K are block triangular in them, so that the
    characteristic polynomial without damping is the product of those of the blocks.
    """
    return coupled(at.mass(), at.gyroscopic(), at.stiffness())


def _by_blocks(signs: Sequence[Int8Array], blocks: int) -> list[Sequence[Int8Array]]:
    """The signs of :func:`_types`, split into equal parts, one for each block."""
    size = len(signs) // blocks
    return [signs[k * size : (k + 1) * size] for k in range(blocks)]


def _symmetric(balance: Balance, parameters: Intervals) -> BoolArray:
    """Points, of prepared parameters (…, N), at which K is symmetric at every state."""
    shape = parameters.shape[1:]
    mus = balance.at((), balance.arguments(parameters), shape).circulatory_frictions
    none = [as_intervals(mu, shape).magnitude <= NEGLIGIBLE for mu in mus]
    return _without_friction(balance, np.logical_and.reduce(none or [np.ones(shape, dtype=bool)]))


def _without_friction(balance: Balance, frictionless: BoolArray) -> BoolArray:
    """:func:`_symmetric` from a mask of points without friction: K is symmetric there if the other
    forces of the page have a potential.
    """
    return (balance.model.about["symmetric"] & frictionless) | (balance.n == 1)


def decay(
    balance: Balance, given: FloatArray, ends: FloatArray, undamped: Int8Array, growth: FloatArray
) -> Int8Array:
    """Stability with damping: 1 where it is proved that no λ of det(λ² M + λ (C + G) + K) has a
    positive real part, −1 where it is proved that one has, 0 where it is undecided.

    All λ have negative real parts exactly if the coefficients of that polynomial and Hurwitz's
    determinants are positive. If one of these numbers is negative, some λ has a positive real part.
    If signs are undecided, as with very weak damping, the same test is made for the polynomial
    shifted to the right by half of the float ``growth``; it may prove that a λ has a positive real
    part.

    Where C vanishes, every second coefficient may be 0; there the result is ``undamped``, the same
    answer for λ² M + λ G + K. Other arguments are those of :func:`classified`.
    """

    def test_right_of(shift: Number) -> SignTest:
        return partial(_of_blocks, partial(_routh_twice, shift))

    with quiet():
        at = balance.state(Intervals(ends), balance.prepared_at(given))
        without = matrix(at.damping(), at.shape).magnitude.max(axis=(0, 1)) <= NEGLIGIBLE
        half = np.where(growth > 0, 0.5 * growth, 0.0)
        by_signs = _decay_by_signs(_signs_over(at, test_right_of(Intervals.point(half))))
        found = np.where(without & (undamped != 0), undamped, by_signs).astype(np.int8)

    def test_of(row: int) -> SignTest:
        return test_right_of(ball(float(half[row]), balance.options.root_bits))

    for row, signs in _with_digits(balance, given, ends, found == 0, test_of):
        found[row] = _decay_by_signs(signs)
    return found


def decays(balance: Balance, parameters: Intervals, ends: FloatArray) -> BoolArray:
    """Boxes all over which all λ of det(λ² M + λ (C + G) + K) are proved to have negative real
    parts: the coefficients and Hurwitz's determinants are positive.

    ``parameters`` are prepared, ``ends`` boxes of coordinates.
    """

    def test(M: Matrix, C: Matrix, K: Matrix) -> Matrix:
        return [_routh(M, C, K)]

    (signs,) = _signs_over(balance.state(Intervals(ends), parameters), partial(_of_blocks, test))
    return np.asarray((signs > 0).all(axis=0))


def _of_blocks(
    test: Callable[[Matrix, Matrix, Matrix], Matrix], at: Evaluation, convert: Converted
) -> Matrix:
    """The numbers that a test of M, C + G and K gives for all blocks that do not act on each
    other, sequence by sequence.
    """
    every = at.mass(), at.by_rates(), at.stiffness()
    parts = [test(*(convert(part_of(A, block)) for A in every)) for block in coupled(*every)]
    return [[*chain.from_iterable(part)] for part in zip(*parts, strict=True)]


def _types(even: BoolArray, at: Evaluation, convert: Converted) -> Matrix:
    """Numbers whose signs give the type without damping, block by block.

    For each block: :func:`invariants`, and for a gyroscopic model :func:`_growing` too, or three
    constants where λ come in pairs. Blocks are necessary: with a pair of λ on the imaginary axis in
    one block, Routh's array of the whole polynomial would end in zeros.
    """
    numbers = list[Any]()
    for block, in_pairs in zip(_blocks(at), even, strict=True):
        M, G, K = (convert(part_of(A, block)) for A in (at.mass(), at.gyroscopic(), at.stiffness()))
        if not at.balance.gyroscopic:
            numbers += invariants(characteristic(K, M))
            continue
        a = characteristic(K, G, M)
        numbers += [*invariants(a[::2]), *([[1]] * 3 if in_pairs.all() else _growing(a))]
    return numbers


def _growing(a: list[Any]) -> Matrix:
    """Three sequences of numbers whose sign changes count roots of the polynomial with coefficients
    ``a``, the lowest first.

    The changes in the first, the leading column of Routh's array, are the roots with a positive
    real part. The other two are Sturm's chain at 0 and at +∞; the difference of their changes is
    the number of positive real roots. Routh's array is that of the polynomial times λ + 1, whose
    root −1 makes the sum of all roots nonzero; with the sum 0 the array would end.
    """
    sturm = [a[::-1], [*derivative(a)][::-1]]
    while len(sturm[-1]) > 1:
        sturm.append([-entry for entry in _reduced(_reduced(*sturm[-2:]), sturm[-1])])
    return [
        routh_column(a),
        [part[-1] for part in sturm],
        [part[0] for part in sturm],
    ]


def routh_column(a: list[Any]) -> list[Any]:
    """Leading column of Routh's array of λ + 1 times the polynomial with coefficients ``a``, the
    lowest first: it changes its sign once for each root with a positive real part.
    """
    b = [low + high for low, high in zip([*a, 0], [0, *a], strict=True)][::-1]
    rows = [b[::2], b[1::2]]
    while rows[-1]:
        rows.append(_reduced(*rows[-2:]))
    return [row[0] for row in rows[:-1]]


def _reduced(one: list[Any], two: list[Any]) -> list[Any]:
    """One step of polynomial division: row ``one`` minus the multiple of ``two`` that cancels its
    leading entry; the highest coefficient stands first.
    """
    factor = one[0] / two[0]
    more = [*two, *[0] * (len(one) - len(two))]
    return [x - factor * y for x, y in zip(one[1:], more[1:], strict=True)]


def _routh_twice(shift: Number, M: Matrix, C: Matrix, K: Matrix) -> Matrix:
    """:func:`_routh` for the imaginary axis, and for the parallel line at real part ``shift``."""
    # λ = shift + ν: ν² M + ν (C + 2 shift M) + K + shift (C + shift M)
    shifted_K = [
        [k + shift * (c + shift * m) for m, c, k in zip(*rows, strict=True)]
        for rows in zip(M, C, K, strict=True)
    ]
    shifted_C = [
        [c + 2 * shift * m for m, c in zip(*rows, strict=True)] for rows in zip(M, C, strict=True)
    ]
    return [_routh(M, C, K), _routh(M, shifted_C, shifted_K)]


def _routh(M: Matrix, C: Matrix, K: Matrix) -> list[Any]:
    """Coefficients of det(λ² M + λ C + K), and Hurwitz's determinants of sizes 2 to 2 n − 1.

    The first determinant is a coefficient, and the last is a coefficient times the one before it.
    As polynomials in the entries: ``derive/hurwitz.py``.
    """
    a = characteristic(K, C, M)
    return [*a, *(hurwitz(a, size) for size in range(2, len(a) - 1))]


def _decay_by_signs(signs: Sequence[Int8Array]) -> Int8Array:
    """The answer of :func:`decay` from the signs of :func:`_routh_twice`; the second line can prove
    only growth.
    """
    on_axis, shifted = (
        np.select([(part > 0).all(axis=0), (part < 0).any(axis=0)], [1, -1], 0) for part in signs
    )
    return np.where(on_axis != 0, on_axis, np.minimum(shifted, 0)).astype(np.int8)


def invariants(coefficients: list[Any]) -> Matrix:
    """Elementary symmetric functions e₁ … eₙ of the κ, and the minors of sizes 2 to n of Hermite's
    matrix.

    ``coefficients`` are those of det M Π (κ_i + λ²) in λ², the lowest first, of any number type.
    The entries of Hermite's matrix are the power sums of the κ, by Newton's identities.
    """
    n = len(coefficients) - 1
    # The coefficient of λ²ᵏ is e_{n−k} det M.
    e = [1, *(coefficients[n - k] / coefficients[n] for k in range(1, n + 1))]
    sums: list[Any] = [n]
    for k in range(1, 2 * n - 1):
        newton: Any = (-1) ** (k - 1) * k * e[k] if k <= n else 0
        for i in range(1, min(k - 1, n) + 1):
            newton = newton + (-1) ** (i - 1) * e[i] * sums[k - i]
        sums.append(newton)
    hermite = [[sums[i + j] for j in range(n)] for i in range(n)]
    return e[1:], [determinant([row[:size] for row in hermite[:size]]) for size in range(2, n + 1)]


def _signs_over(at: Evaluation, test: SignTest) -> list[Int8Array]:
    """Signs of the numbers of a test over boxes; 0 where a sign is unknown."""
    parts = test(at, lambda part: [list(row) for row in matrix(part, at.shape)])
    return [stacked(part, at.shape).signs for part in parts]


def _types_by_signs(
    signs: Sequence[Int8Array], real: BoolArray, even: BoolArray
) -> tuple[Int8Array, BoolArray]:
    """Types from signs of :func:`_types`, 0 for unknown ones, and whether the signs prove them.

    A state has the worst type of its blocks. ``real`` and ``even`` are those of :func:`_in_pairs`.
    """
    parts = zip(_by_blocks(signs, len(real)), real, even, strict=True)
    codes, proved = map(np.array, zip(*(_type_of_block(*part) for part in parts), strict=True))
    flutter = (codes == EquilibriumType.FLUTTER) & proved
    return codes.max(axis=0), proved.all(axis=0) | flutter.any(axis=0)


def _type_of_block(
    signs: Sequence[Int8Array], real: BoolArray, even: BoolArray
) -> tuple[Int8Array, BoolArray]:
    """:func:`_types_by_signs` for one block."""
    elementary, minors, *counted = signs
    flutter = (minors < 0).any(axis=0) & ~real
    real = real | (minors > 0).all(axis=0)
    divergent = (elementary < 0).any(axis=0)
    code = np.select(
        [flutter, divergent],
        [EquilibriumType.FLUTTER, EquilibriumType.DIVERGENT],
        EquilibriumType.STABLE,
    ).astype(np.int8)
    proved = flutter | (real & (divergent | (elementary > 0).all(axis=0)))
    if not counted:
        return code, proved
    certain = np.logical_and.reduce([(part != 0).all(axis=0) for part in counted])
    # Sign changes in the sequences of _growing.
    right, at_zero, far = (np.abs(np.diff(part, axis=0)).sum(axis=0) // 2 for part in counted)
    other = np.where(right > at_zero - far, EquilibriumType.FLUTTER, EquilibriumType.DIVERGENT)
    codes = np.where(even | ~certain, code, other).astype(np.int8)
    return codes, np.where(even, proved, certain)


def _with_digits(
    balance: Balance,
    given: FloatArray,
    ends: FloatArray,
    among: BoolArray,
    test_of: Callable[[int], SignTest],
) -> Iterator[tuple[slice, list[Int8Array]]]:
    """Signs in ball arithmetic for the states marked in ``among``, with the slice of their row.

    ``test_of`` gives the test of a row. A state is left out if its box can't be narrowed or a sign
    remains undecided.
    """
    for row in np.flatnonzero(among).tolist():
        precise = PreciseBalance(balance, given[:, row], balance.options.root_bits)
        q = narrowed(precise, ends[:, :, row], ends[:, :, row])
        with suppress(UndecidedSign, ZeroDivisionError):
            if q is not None:
                yield slice(row, row + 1), _signs_at(precise, q, test_of(row))


def type_at(precise: PreciseBalance, q: Sequence[Any]) -> EquilibriumType:
    """Type of a state given as balls; raises :class:`UndecidedSign` if a sign that it needs is
    undecided.
    """
    balance, at = precise.balance, precise.state(q)

    vanishes = partial(_vanishes, bits=precise.bits)
    frictionless = np.array([vanishes([[*at.circulatory_frictions]])])
    real, even = _in_pairs(at, _without_friction(balance, frictionless), vanishes)
    code, proved = _types_by_signs(_signs_at(precise, q, partial(_types, even)), real, even)
    if not proved[0]:
        raise UndecidedSign("a state on the border of its type")
    return EquilibriumType(int(code[0]))


def _signs_at(precise: PreciseBalance, q: Sequence[Any], test: SignTest) -> list[Int8Array]:
    """Signs of the numbers of a test at a state given as balls."""
    parts = test(precise.state(q), lambda part: as_balls(part, precise.bits))
    return [np.array([*map(balls.sign, part)], dtype=np.int8)[:, None] for part in parts]


def is_undamped(balance: Balance, given: FloatArray, state: Sequence[float]) -> bool:
    """Whether C is exactly 0 at a state, as without friction and dampers; a C that is too small for
    floats is not.
    """
    precise = PreciseBalance(balance, given, balance.options.root_bits)
    C = precise.state([ball(float(value), precise.bits) for value in state]).damping()
    return _vanishes(C, precise.bits)


def _vanishes(part: Matrix, bits: int) -> bool:
    """Whether a matrix of balls is exactly 0."""
    return all(
        low == 0 == high for row in as_balls(part, bits) for low, high in map(balls.ends, row)
    )


def damped_entries(balance: Balance, over: Intervals) -> list[tuple[int, int]]:
    """Rows and columns of the entries of C that can differ from 0.

    Dampers and slopes that are exactly 0 at the given parameters have no entry.
    """
    C = _damping(balance, over)
    return [(i, j) for i, row in enumerate(C) for j, entry in enumerate(row) if not is_zero(entry)]


def _anywhere(balance: Balance, over: Intervals) -> Evaluation:
    """The evaluation over states in [−1, 1]ⁿ, with any directions of springs: what is 0 there is 0
    at every state.
    """
    any_number = Intervals(np.ones((2, 1)))
    at = balance.at([any_number] * balance.n, balance.over(over), (1,))
    return replace(at, fixed=[any_number] * (3 * balance.springs + len(balance.torsions)))


def _damping(balance: Balance, over: Intervals, indicators: Indicators | None = None) -> Matrix:
    """Enclosure of C at every state."""
    with quiet():
        return _anywhere(balance, over).damping(indicators)


def is_damped(balance: Balance, over: Intervals) -> bool:
    """Whether C differs from 0 at some of 64 random states, on the contact's side of its border."""
    samples = 64  # enough that some are in contact
    point = np.repeat(0.5 * over.low + 0.5 * over.high, samples, axis=1)
    states = np.random.default_rng(0).uniform(-1.0, 1.0, (balance.n, samples)) * np.geomspace(
        0.01, 3.0, samples
    )
    at = balance.at(list(states), balance.floats(point), states.shape[1:], np)
    with quiet():
        C = filled(at.damping(), at.shape)
    return bool((np.isfinite(C) & (C != 0)).any())


def damped_by_friction_alone(balance: Balance, over: Intervals) -> int | None:
    """Number of the coordinate along which friction acts, if nothing else damps over the range of
    parameters; None if that is not proved.
    """
    frictions = balance.model.frictions
    if len(frictions) != 1 or frictions[0]["along"] not in balance.coordinates:
        return None
    if balance.model.about["dampers"]:
        C = matrix(_damping(balance, over, [0] * len(balance.indicators)), (1,))
        # Without contact, C is that of the dampers alone.
        if not balance.opens or not C.magnitude.max() <= NEGLIGIBLE:
            return None
    return balance.coordinates.index(frictions[0]["along"])


def slope_over(balance: Balance, over: Intervals) -> Intervals:
    """Enclosure of the slope dμ/dv of the one friction law over ranges of parameters."""
    with quiet():
        (slope,) = balance.at((), balance.over(over)).slopes_of_friction()
        return as_intervals(slope, over.shape[1:])


def is_conservative(balance: Balance, over: Intervals) -> bool:
    """Whether all κ are proved to be real at every state over the ranges: K is symmetric, and there
    are no gyroscopic forces.
    """
    with quiet():
        symmetric = _symmetric(balance, balance.prepared(over)).all()
    return bool(symmetric and not balance.gyroscopic)


def unpaired(balance: Balance, over: Intervals, block: Sequence[int] | None = None) -> list[int]:
    """Numbers of the odd coefficients without damping, of all or of a block of coordinates, that
    may differ from 0 at some state over the ranges.

    Without any, the λ come in pairs ± λ at every state. Where one differs from 0, some λ grows.
    """
    with quiet():
        if not balance.gyroscopic or _symmetric(balance, balance.prepared(over)).all():
            return []
        odd = _anywhere(balance, over).unpaired(block)
        zero = stacked(odd, (1,)).magnitude[:, 0] <= NEGLIGIBLE
        return np.flatnonzero(~zero).tolist()
