"""Type of an equilibrium by the roots λ of its linearization, with and without damping, and what
damps a model.

Types are told by signs that are proved: whether all roots κ = −λ² of det(K − κ M) are real, and
whether one is negative. With a gyroscopic G the λ are those of det(λ² M + λ G + K), a polynomial in
κ too where K is symmetric. Else every state grows: by flutter, or where all λ to the right are
real, by divergence. Those to the right are counted by Routh's array, the positive ones among them
by Sturm's chain.

All κ are real where the leading minors of the Hankel matrix of their sums of
powers are positive, and not all where one is negative (Hermite); where K is symmetric they are in
any case. Of a polynomial whose roots are all real, one is negative just if one of their elementary
symmetric functions is. Signs come from intervals around the state, and where these hold 0 from many
digits.
"""

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from itertools import chain
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

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
from .forces import Evaluation, Pushing, as_intervals, filled

#: Imaginary part of a λ that is real to floats, over its size.
REAL = 1e-9
#: Growth rate over the frequency below which a state is practically neutral.
NEUTRAL_GROWTH = 1e-4
#: A matrix with all entries of one number type, intervals or balls.
Taken: TypeAlias = Callable[[Matrix], Matrix]
#: Numbers whose signs are asked for at a state.
Ask: TypeAlias = Callable[[Evaluation, Taken], Matrix]


@dataclass(frozen=True)
class Linearized:
    """N states by the full linearization, with dampers and the slope of the friction law."""

    growth: FloatArray  #: largest real part of the λ
    # 1 where it is proved that something grows, −1 that nothing does, 0 where neither is
    sign: Int8Array
    eigenvalues: ComplexArray  #: all λ, shape (N, 2 n), by falling real part

    @property
    def stability(self) -> NDArray[np.str_]:
        """``"stable"``, ``"unstable"``, or ``"neutral"`` where the rate is below
        :data:`NEUTRAL_GROWTH` of the frequency.

        That is the one of the λ of the largest real part, or the lowest one where that λ does not
        oscillate. Empty where no float holds the rate.
        """
        return verdicts(self.growth, self.eigenvalues)


def verdicts(growth: FloatArray, eigenvalues: ComplexArray) -> NDArray[np.str_]:
    """:attr:`Linearized.stability` by the growth and all λ, by falling real part, of N states."""
    frequency = np.abs(eigenvalues.imag)
    frequency = np.where(frequency > REAL * np.abs(eigenvalues), frequency, np.inf)
    own = np.where(np.isfinite(frequency[:, 0]), frequency[:, 0], frequency.min(axis=1))
    neutral = np.abs(growth) <= NEUTRAL_GROWTH * np.where(np.isfinite(own), own, 0.0)
    return np.select([neutral, growth < 0, growth > 0], ["neutral", "stable", "unstable"], "")


def linearized(
    eq: Equilibria, states: tuple[IntArray, ...], enclosures: FloatArray | None
) -> Linearized:
    """The full linearization at some states, by their indices; ``enclosures`` are boxes around all
    states, each alone in its own.

    Source: det(λ² M + λ (C + G) + K) = 0; whether something grows by Hurwitz's determinants, see
    :func:`decay`.
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
    # States that are looked at together: arrays of intervals of millions would take
    # gigabytes.
    together = 1 << 14
    parts = [
        _linearized(one, *(part[..., some] for part in (q, given, ends, undamped)))
        for one, group in zip(balances, groups, strict=True)
        for some in np.split(group, range(together, group.size, together))
    ]
    back = np.argsort(np.concatenate(groups), kind="stable")
    return Linearized(*(np.concatenate(part)[back] for part in zip(*parts, strict=True)))


def _combinations(eq: Equilibria, states: tuple[IntArray, ...]) -> tuple[list[Touching], IntArray]:
    """Combinations of contacts that touch in some states, and the number of that of each state."""
    if eq.contact is not None:
        return [eq.contact], np.zeros(states[-1].size, dtype=int)
    names, which = np.unique(eq["touching"][states], return_inverse=True)
    return [tuple(name.split(", ")) for name in names.tolist()] or [True], which


def _linearized(
    balance: Balance, q: FloatArray, given: FloatArray, ends: FloatArray, undamped: Int8Array
) -> tuple[FloatArray, Int8Array, ComplexArray]:
    """The fields of :class:`Linearized` for some of the states."""
    every = roots(*linearization(balance, q, given))
    every = np.take_along_axis(every, np.argsort(-every.real, axis=1, kind="stable"), axis=1)
    fastest = every[:, 0].real
    sign = -decay(balance, given, ends, undamped, fastest)
    # What rounding leaves is on the side that is proved.
    return (
        np.where(
            sign < 0,
            np.minimum(fastest, 0.0),
            np.where(sign > 0, np.maximum(fastest, 0.0), fastest),
        ),
        sign,
        every,
    )


def classified(
    balance: Balance, states: FloatArray, given: FloatArray, ends: FloatArray
) -> tuple[Int8Array, BoolArray, ComplexArray]:
    """Codes of :class:`spragsym.EquilibriumType`, whether each is proved; and the 2 n roots without
    damping, floats.

    States have the shape (n, N), parameters (P, N), boxes ``ends`` with one equilibrium each (2, n,
    N). A sign that is not known counts as that of 0.
    """
    with quiet():
        signs, real, even = _over(balance, balance.prepared_at(given), ends)
    codes, proved = _types_by_signs(signs, real, even)
    for row, signs in _with_digits(
        balance, given, ends, ~proved, lambda row: partial(_types, even[:, row])
    ):
        codes[row], proved[row] = _types_by_signs(signs, real[:, row], even[:, row])
    M, G, K = linearization(balance, states, given, damping=False)
    if balance.gyroscopic:
        every = roots(M, G, K)
        order = np.argsort(-np.abs(every), axis=1, kind="stable")
        return codes, proved, np.take_along_axis(every, order, axis=1)
    negated = -squares(M, K)  # λ²
    negated = np.take_along_axis(negated, np.argsort(-np.abs(negated), axis=1), axis=1)
    upper = np.sqrt(negated)
    return codes, proved, np.concatenate([upper, -upper], axis=1)


def roots(M: FloatArray, C: FloatArray, K: FloatArray) -> ComplexArray:
    """The roots of det(λ² M + λ C + K), of matrices of shape (…, n, n); NaN where an entry is not
    finite.
    """
    n = M.shape[-1]
    zero, unit = np.zeros_like(M), np.broadcast_to(np.eye(n), M.shape)
    companion = np.block([[zero, unit], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    finite = np.isfinite(companion).all(axis=(-2, -1), keepdims=True)
    out: ComplexArray = np.linalg.eigvals(np.where(finite, companion, 0.0)).astype(complex)
    return np.where(finite[..., 0], out, np.nan)


def squares(M: FloatArray, K: FloatArray) -> ComplexArray:
    """The roots κ = −λ² of det(K − κ M)."""
    return np.linalg.eigvals(np.linalg.solve(M, K)).astype(complex)


def linearization(
    balance: Balance, states: FloatArray, given: FloatArray, damping: bool = True
) -> tuple[FloatArray, ...]:
    """M, C + G, or G without ``damping``, and K at float states, each of shape (N, n, n).

    They are NaN where a law has no value, like Hertz's beyond the touch.
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
    """The code of one state, shape (n, 1), where one λ is 0, as at a fold: the others decide."""
    (M,), (G,), (K,) = linearization(balance, states, given, damping=False)
    if balance.gyroscopic:
        return _by_floats(roots(M, G, K))
    every = squares(M, K)
    others = np.delete(every, np.abs(every).argmin())
    if (np.abs(others.imag) > 1e-13 * np.abs(others).max(initial=0.0)).any():
        return int(EquilibriumType.FLUTTER)
    return int(EquilibriumType.STABLE if (others.real > 0).all() else EquilibriumType.DIVERGENT)


def _by_floats(every: ComplexArray) -> int:
    """The code of a state by its 2 n λ without damping, of which one is 0, or two are if they come
    in pairs ± λ.
    """
    others = every[np.argsort(np.abs(every))][1:]
    # Real or imaginary part of a λ without damping beside a λ that is 0, over the largest
    # size.
    moved = 1e-7
    grow = others[others.real > moved * np.abs(others).max(initial=0.0)]
    if (np.abs(grow.imag) > moved * np.abs(grow)).any():
        return int(EquilibriumType.FLUTTER)
    return int(EquilibriumType.DIVERGENT if grow.size else EquilibriumType.STABLE)


def real(balance: Balance, parameters: Intervals, ends: FloatArray) -> BoolArray:
    """Boxes of coordinates and prepared parameters all over which all κ are proved to be real,
    those that meet included.
    """
    signs, real, even = _over(balance, parameters, ends)
    minors = [part[1] for part in _by_blocks(signs, len(real))]
    parts = zip(real, even, minors, strict=True)
    return np.logical_and.reduce([one | (two & (part > 0).all(axis=0)) for one, two, part in parts])


def types_over(
    balance: Balance, parameters: Intervals, ends: FloatArray
) -> tuple[Int8Array, BoolArray]:
    """Codes of :class:`spragsym.EquilibriumType` of all states in boxes of coordinates and prepared
    parameters, and whether each is proved.
    """
    return _types_by_signs(*_over(balance, parameters, ends))


def _over(
    balance: Balance, parameters: Intervals, ends: FloatArray
) -> tuple[list[Int8Array], BoolArray, BoolArray]:
    """Signs of :func:`_types` over boxes, and :func:`_in_pairs`."""
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
    """By blocks of :func:`_blocks`, shape (blocks, …): where all κ are real in any case, K being
    symmetric and G 0; and where either holds, so that λ come in pairs ± λ.

    Of a model without G it is not asked whether K is symmetric at this state.
    """
    real, even = list[BoolArray](), list[BoolArray]()
    for block in _blocks(at):
        still, same = (vanishes(part_of(A, block)) for A in (at.gyroscopic(), at.circulatory()))
        alike = symmetric | (len(block) == 1) | (same & at.balance.gyroscopic)
        real.append(alike & still)
        even.append(alike | still)
    return np.array(real), np.array(even)


def _blocks(at: Evaluation) -> list[tuple[int, ...]]:
    """Blocks of coordinates that swing by themselves without damping, but for what others drive."""
    return coupled(at.mass(), at.gyroscopic(), at.stiffness())


def _by_blocks(signs: Sequence[Int8Array], blocks: int) -> list[Sequence[Int8Array]]:
    """Signs of :func:`_types` block by block."""
    size = len(signs) // blocks
    return [signs[k * size : (k + 1) * size] for k in range(blocks)]


def _symmetric(balance: Balance, parameters: Intervals) -> BoolArray:
    """Parameters, of shape (…, N), for which K is symmetric whatever the state is."""
    shape = parameters.shape[1:]
    mus = balance.at((), balance.arguments(parameters), shape).circulatory_frictions
    none = [as_intervals(mu, shape).magnitude <= NEGLIGIBLE for mu in mus]
    return _without_friction(balance, np.logical_and.reduce(none or [np.ones(shape, dtype=bool)]))


def _without_friction(balance: Balance, frictionless: BoolArray) -> BoolArray:
    """:func:`_symmetric`: without friction K is, if the page's other forces have a potential."""
    return (balance.model.about["symmetric"] & frictionless) | (balance.n == 1)


def decay(
    balance: Balance, given: FloatArray, ends: FloatArray, undamped: Int8Array, growth: FloatArray
) -> Int8Array:
    """Signs of the real parts of all λ of det(λ² M + λ (C + G) + K) = 0: 1 where it is proved that
    none grows, −1 that one does, 0 where it is not known.

    All decay just where the coefficients of that polynomial and Hurwitz's determinants are
    positive; where one of these is negative some λ has a positive real part, since without such all
    would be limits of positive ones. Where these are not told from 0, as of damping that is next to
    nothing, the same test right of half the ``growth`` of floats tells that one grows. Arguments as
    for :func:`classified`; ``undamped`` says the same of λ² M + λ G + K, which counts where C is 0:
    there every second coefficient may be 0.
    """

    def asked(shift: Number) -> Ask:
        def ask(at: Evaluation, taken: Taken) -> Matrix:
            every = at.mass(), at.by_rates(), at.stiffness()
            parts = [
                _routh_twice(shift, *(taken(part_of(A, block)) for A in every))
                for block in coupled(*every)
            ]
            return [[*chain.from_iterable(part)] for part in zip(*parts, strict=True)]

        return ask

    with quiet():
        at = balance.state(Intervals(ends), balance.prepared_at(given))
        without = matrix(at.damping(), at.shape).magnitude.max(axis=(0, 1)) <= NEGLIGIBLE
        half = np.where(growth > 0, 0.5 * growth, 0.0)
        by_signs = _decay_by_signs(_signs_over(at, asked(Intervals.point(half))))
        found = np.where(without & (undamped != 0), undamped, by_signs).astype(np.int8)
    for row, signs in _with_digits(
        balance,
        given,
        ends,
        found == 0,
        lambda row: asked(ball(float(half[row]), balance.options.root_bits)),
    ):
        found[row] = _decay_by_signs(signs)
    return found


def _types(even: BoolArray, at: Evaluation, taken: Taken) -> Matrix:
    """Types of states, block by block; with G, unless λ come in pairs, by Routh's array and Sturm's
    chain too.

    A block that swings by itself has λ on the axis, where the array of all together would end.
    """
    numbers = list[Any]()
    for block, in_pairs in zip(_blocks(at), even, strict=True):
        M, G, K = (taken(part_of(A, block)) for A in (at.mass(), at.gyroscopic(), at.stiffness()))
        if not at.balance.gyroscopic:
            numbers += invariants(characteristic(K, M))
            continue
        a = characteristic(K, G, M)
        numbers += [*invariants(a[::2]), *([[1]] * 3 if in_pairs.all() else _growing(a))]
    return numbers


def _growing(a: list[Any]) -> Matrix:
    """Numbers by whose changes of sign roots of a polynomial are counted: those to the right, and
    at 0 and far out, the real ones.

    The first is the column of Routh's array of the polynomial times λ + 1: with a root on the left
    the sum of all is not 0, at which the array would end. The others are ends of Sturm's chain.
    """
    b = [low + high for low, high in zip([*a, 0], [0, *a], strict=True)][::-1]
    rows = [b[::2], b[1::2]]
    while rows[-1]:
        rows.append(_reduced(*rows[-2:]))
    sturm = [a[::-1], [*derivative(a)][::-1]]
    while len(sturm[-1]) > 1:
        sturm.append([-entry for entry in _reduced(_reduced(*sturm[-2:]), sturm[-1])])
    return [
        [row[0] for row in rows[:-1]],
        [part[-1] for part in sturm],
        [part[0] for part in sturm],
    ]


def _reduced(one: list[Any], two: list[Any]) -> list[Any]:
    """A row, the highest coefficient first, less the multiple of another that takes its first
    entry away.
    """
    factor = one[0] / two[0]
    more = [*two, *[0] * (len(one) - len(two))]
    return [x - factor * y for x, y in zip(one[1:], more[1:], strict=True)]


def _routh_twice(shift: Number, M: Matrix, C: Matrix, K: Matrix) -> Matrix:
    """:func:`_routh` for the imaginary axis, and for the line right of it by ``shift``."""
    moved = [
        [k + shift * (c + shift * m) for m, c, k in zip(*rows, strict=True)]
        for rows in zip(M, C, K, strict=True)
    ]
    damped = [
        [c + 2 * shift * m for m, c in zip(*rows, strict=True)] for rows in zip(M, C, strict=True)
    ]
    return [_routh(M, C, K), _routh(M, damped, moved)]


def _routh(M: Matrix, C: Matrix, K: Matrix) -> list[Any]:
    """The coefficients, and all determinants of Hurwitz but the first and the last, which add
    nothing.
    """
    a = characteristic(K, C, M)
    return [*a, *(hurwitz(a, size) for size in range(2, len(a) - 1))]


def _decay_by_signs(signs: Sequence[Int8Array]) -> Int8Array:
    """1 where nothing grows, −1 where something does, by the signs of :func:`_routh_twice`; of the
    second that it grows only.
    """
    here, beyond = (
        np.where((part > 0).all(axis=0), 1, np.where((part < 0).any(axis=0), -1, 0))
        for part in signs
    )
    return np.where(here != 0, here, np.minimum(beyond, 0)).astype(np.int8)


def invariants(coefficients: list[Any]) -> Matrix:
    """Elementary symmetric functions e₁ … eₙ of the κ, and the minors of sizes 2 to n of Hermite's
    matrix, of any number type, by the coefficients of det M Π (κ_i + λ²), the lowest first.
    """
    n = len(coefficients) - 1
    # That of λ²ᵏ is e_{n−k} det M.
    e = [1, *(coefficients[n - k] / coefficients[n] for k in range(1, n + 1))]
    sums: list[Any] = [n]
    for k in range(1, 2 * n - 1):
        newton: Any = (-1) ** (k - 1) * k * e[k] if k <= n else 0
        for i in range(1, min(k - 1, n) + 1):
            newton = newton + (-1) ** (i - 1) * e[i] * sums[k - i]
        sums.append(newton)
    hermite = [[sums[i + j] for j in range(n)] for i in range(n)]
    return e[1:], [determinant([row[:size] for row in hermite[:size]]) for size in range(2, n + 1)]


def _signs_over(at: Evaluation, ask: Ask) -> list[Int8Array]:
    """Signs of what is asked over boxes."""
    parts = ask(at, lambda part: [list(row) for row in matrix(part, at.shape)])
    return [stacked(part, at.shape).signs for part in parts]


def _types_by_signs(
    signs: Sequence[Int8Array], real: BoolArray, even: BoolArray
) -> tuple[Int8Array, BoolArray]:
    """Codes, and whether the signs that are known decide them, 0 for one that is not; ``real`` and
    ``even`` as :func:`_in_pairs` has them. A state has the worst type of its blocks.
    """
    parts = zip(_by_blocks(signs, len(real)), real, even, strict=True)
    codes, proved = map(np.array, zip(*(_type_of_block(*part) for part in parts), strict=True))
    flutter = (codes == EquilibriumType.FLUTTER) & proved
    return codes.max(axis=0), proved.all(axis=0) | flutter.any(axis=0)


def _type_of_block(
    signs: Sequence[Int8Array], real: BoolArray, even: BoolArray
) -> tuple[Int8Array, BoolArray]:
    """:func:`_types_by_signs` of one block."""
    elementary, minors, *counted = signs
    flutter = (minors < 0).any(axis=0) & ~real
    real = real | (minors > 0).all(axis=0)
    divergent = (elementary < 0).any(axis=0)
    code = np.where(
        flutter,
        EquilibriumType.FLUTTER,
        np.where(divergent, EquilibriumType.DIVERGENT, EquilibriumType.STABLE),
    ).astype(np.int8)
    proved = flutter | (real & (divergent | (elementary > 0).all(axis=0)))
    if not counted:
        return code, proved
    certain = np.logical_and.reduce([(part != 0).all(axis=0) for part in counted])
    right, at_zero, far = (np.abs(np.diff(part, axis=0)).sum(axis=0) // 2 for part in counted)
    other = np.where(right > at_zero - far, EquilibriumType.FLUTTER, EquilibriumType.DIVERGENT)
    return (
        np.where(even | ~certain, code, other).astype(np.int8),
        np.where(even, proved, certain),
    )


def _with_digits(
    balance: Balance,
    given: FloatArray,
    ends: FloatArray,
    among: BoolArray,
    ask: Callable[[int], Ask],
) -> Iterator[tuple[slice, list[Int8Array]]]:
    """Signs by many digits for states ``among`` all, by row; none where the box of a state can't be
    made smaller.
    """
    for row in np.flatnonzero(among).tolist():
        precise = PreciseBalance(balance, given[:, row], balance.options.root_bits)
        q = narrowed(precise, ends[:, :, row], ends[:, :, row])
        with suppress(UndecidedSign, ZeroDivisionError):
            if q is not None:
                yield slice(row, row + 1), _signs_at(precise, q, ask(row))


def type_at(precise: PreciseBalance, q: Sequence[Any]) -> EquilibriumType:
    """The type of a state of balls; :class:`UndecidedSign` where a sign that it takes is not
    decided.
    """
    balance, at = precise.balance, precise.state(q)

    def vanishes(part: Matrix) -> bool:
        rows = as_balls(part, precise.bits)
        return all(low == 0 == high for row in rows for low, high in map(balls.ends, row))

    frictionless = np.array([vanishes([[*at.circulatory_frictions]])])
    real, even = _in_pairs(at, _without_friction(balance, frictionless), vanishes)
    code, proved = _types_by_signs(_signs_at(precise, q, partial(_types, even)), real, even)
    if not proved[0]:
        raise UndecidedSign("a state on the border of its type")
    return EquilibriumType(int(code[0]))


def _signs_at(precise: PreciseBalance, q: Sequence[Any], ask: Ask) -> list[Int8Array]:
    """Signs of what is asked of a state of balls."""
    parts = ask(precise.state(q), lambda part: as_balls(part, precise.bits))
    return [np.array([*map(balls.sign, part)], dtype=np.int8)[:, None] for part in parts]


def damped_entries(balance: Balance, over: Intervals) -> list[tuple[int, int]]:
    """Rows and columns of the entries of C that are not 0 by structure.

    Dampers and slopes that are exactly 0 by the given parameters have no entry.
    """
    C = _damping(balance, over)
    return [(i, j) for i, row in enumerate(C) for j, entry in enumerate(row) if not is_zero(entry)]


def _damping(balance: Balance, over: Intervals, pushing: Pushing | None = None) -> Matrix:
    """C at states of all kinds."""
    at = balance.at([Intervals(np.ones((2, 1)))] * balance.n, balance.over(over), (1,))
    with quiet():
        return replace(at, fixed=[Intervals(np.ones((2, 1)))] * 3 * balance.springs).damping(
            pushing
        )


def is_damped(balance: Balance, over: Intervals) -> bool:
    """Whether C is not 0 at generic states on the contact's side, where its laws have values."""
    # Number of states at which it is looked at whether anything damps: some are in contact.
    places = 64
    point = np.repeat(0.5 * over.low + 0.5 * over.high, places, axis=1)
    states = np.random.default_rng(0).uniform(-1.0, 1.0, (balance.n, places)) * np.geomspace(
        0.01, 3.0, places
    )
    at = balance.at(list(states), balance.floats(point), states.shape[1:], np)
    with quiet():
        C = filled(at.damping(), at.shape)
    return bool((np.isfinite(C) & (C != 0)).any())


def damped_by_friction_alone(balance: Balance, over: Intervals) -> int | None:
    """The coordinate that friction opposes, if nothing else damps for any parameter of the range;
    None if that is not known.
    """
    frictions = balance.model.frictions
    if len(frictions) != 1 or frictions[0]["along"] not in balance.coordinates:
        return None
    if balance.model.about["dampers"]:
        C = matrix(_damping(balance, over, [0] * len(balance.pushing)), (1,))
        # They are known on their own in lift-off.
        if not balance.opens or not C.magnitude.max() <= NEGLIGIBLE:
            return None
    return balance.coordinates.index(frictions[0]["along"])


def slope_over(balance: Balance, over: Intervals) -> Intervals:
    """The slope of the friction law over the ranges."""
    with quiet():
        (slope,) = balance.at((), balance.over(over)).slopes_of_friction()
        return as_intervals(slope, over.shape[1:])


def is_conservative(balance: Balance, over: Intervals) -> bool:
    """Whether all κ are real all over the ranges, whatever the state is: K is symmetric, or one
    number, and nothing gyroscopic acts.
    """
    with quiet():
        symmetric = _symmetric(balance, balance.prepared(over)).all()
    return bool(symmetric and not balance.gyroscopic)


def comes_in_pairs(balance: Balance, over: Intervals) -> bool:
    """Whether λ without damping come in pairs ± λ all over the ranges; with G and a K that is not
    symmetric they do not, and something grows in every state.
    """
    with quiet():
        return not balance.gyroscopic or bool(_symmetric(balance, balance.prepared(over)).all())
