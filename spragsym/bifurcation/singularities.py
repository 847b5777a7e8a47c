"""Folds, pitchforks and cusps of any model, proved and classified; which states end at a fold.

Pitchforks. If a model is its own mirror image, three equilibria may become one at a pitchfork, as
in the article's model without friction and without a spring along the belt. Forces and det K have
no regular root there, so that a search over boxes stays undecided around it. The mirror decides:

- At a state on the mirror K has two diagonal blocks: that of odd coordinates, whose signs the
  mirror changes, and that of even ones. The pitchfork is a regular root of the even rows of the
  balance and of the determinant of the odd block, in the even coordinates and the parameter.
- A mirror that exchanges two coordinates changes the sign of their half difference, and keeps their
  mean. Rows, K and boxes are transformed to means and half differences.
- Near the pitchfork the balance reduces to one function g(u) of one coordinate, odd about the
  mirror (Lyapunov–Schmidt). Let g‴ ≠ 0 all over a box that is its own image. Another fold in the
  box would give g a double root on either side and a root on the mirror. Five roots would give g‴
  two roots. So the box holds no other fold.
- In the plane of two parameters pitchforks form curves, on which the equations of a cusp hold too.
  With one odd coordinate, the derivative of det K along that column of the adjugate is odd in it.
  Where its slope is nonzero over a box and its image, the box holds no cusp.

Ends. Near a fold with K v = 0 and w K = 0 the states are q + s v, and up to higher order w · ∂F/∂λ
δλ + ½ w · D²F(v, v) s² = 0, while det K changes by s ∇(det K) · v. At a regular fold none of these
numbers is 0; each is enclosed over the fold's box.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np

from ..core.errors import ConvergenceError
from ..models.parameters import ParameterSet, Ranges
from ..numerics import balls, certified_roots, contractors
from ..numerics.arithmetic import Number, cofactor, determinant
from ..numerics.balls import UndecidedSign
from ..numerics.certified_roots import Roots, different
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    Intervals,
    Shape,
    matrix,
    quiet,
    scale_of,
    spans_of,
    stacked,
    width_of,
)
from ..numerics.jets import constant, gradient, variables
from ..numerics.precise_roots import exact_ends, third_derivative
from ..results import EquilibriumType
from ..results.points import Ended, Points, nowhere
from ..statics.balance import NEGLIGIBLE, Balance, PreciseBalance
from ..statics.equilibria import equilibria
from ..statics.forces import Evaluation, Values
from ..statics.namespaces import XP, follows
from ..statics.options import SearchOptions
from ..statics.precise_balance import clusters, on_side
from ..statics.reference_state import nearest_state
from ..statics.stability import with_a_zero
from .borders import at_point, borders, enter_border_folds, with_numbers
from .defining_systems import (
    FOLD,
    Augmented,
    Block,
    Condition,
    Family,
    OfFamily,
    blocks_of,
    change,
    cusp,
)
from .points import Found, all_of, arranged, in_lift_off, of_ends, search, together, vanishes


def folds_of(
    p: ParameterSet,
    vary: str,
    between: Ranges | None,
    within: Ranges | None,
    options: SearchOptions | None = None,
) -> Points:
    """All folds and pitchforks along one parameter, and border points between combinations of
    touching contacts; arguments as for :func:`spragsym.folds`.
    """
    families = Family.every(p, (vary,), between, within, options)
    parts = [*map(_folds_in, families)]
    if len(families) > 1:
        parts += borders(families)
    found = together(parts)
    others = in_lift_off(families[0], between, within, _folds_in)
    return replace(found, remarks=(*found.remarks, *others), _ended=ended)


def _folds_in(family: Family) -> Points:
    """Folds and pitchforks of one combination of touching contacts."""
    (vary,) = family.vary
    found, pitchforks = with_pitchforks(family, search(family, FOLD))
    kind = np.repeat(["fold", "pitchfork"], [found.roots.point.size - pitchforks, pitchforks])

    def singular(end: float, left: FloatArray) -> str | None:
        if not vanishes(Augmented(family, FOLD), end, left).any():
            return None
        why = "det K is 0 in every state: equilibria there form curves, or there are none"
        return f", and {why}; for folds beside it give between with another end for {vary}"

    moves = vary in family.balance.balanced
    remarks = of_ends(family, found, singular) if moves else (f"{vary} moves no equilibrium",)
    family = family if moves else replace(family, endless=())
    return arranged(family, found, kind, remarks=remarks)


def cusps_of(
    p: ParameterSet,
    vary: Sequence[str],
    between: Ranges | None,
    within: Ranges | None,
    options: SearchOptions | None = None,
) -> Points:
    """All cusps in the plane of two parameters; arguments as for :func:`spragsym.cusps`."""
    families = Family.every(p, vary, between, within, options)
    return together([arranged(family, isolated(family), "cusp") for family in families])


@dataclass(frozen=True)
class Mirror:
    """A mirror symmetry: odd coordinates, the image of a state, and the springs with dx = 0 on the
    mirror.

    If the mirror exchanges coordinates i and j, ``partners[j]`` is (i, sign). Then number i stands
    for their mean, which is even, and number j for half their difference, which is odd.
    """

    odd: list[int]
    image: Callable[[Sequence[Any], Mapping[str, Any]], Sequence[Any]]
    upright: Sequence[int] = ()
    partners: Mapping[int, tuple[int, int]] = field(default_factory=dict)
    #: Whether coordinates are exchanged: then the symmetric rows are ``forces``, not the balance in
    #: another basis.
    exchanges: bool = False

    def forces(self, at: Evaluation) -> list[Any]:
        """Rows of the balance by means and half differences."""
        return self.along(at.rows("forces") if self.exchanges else at.forces())

    def slopes(self, at: Evaluation) -> list[list[Any]]:
        """K by means and half differences, in rows and columns."""
        K = at.rows("forces_jacobian") if self.exchanges else at.slopes
        rows = [self.along(row) for row in K]
        return [list(row) for row in zip(*map(self.along, zip(*rows, strict=True)), strict=True)]

    def along(self, parts: Sequence[Any], sign: int = 1) -> list[Any]:
        """Sums and differences of the numbers that belong to exchanged coordinates.

        ``sign`` −1 is the transformation of coordinates, 1 that of forces.
        """
        out = list(parts)
        for j, (i, partner_sign) in self.partners.items():
            out[i] = parts[i] + sign * partner_sign * parts[j]
            out[j] = parts[j] - sign * partner_sign * parts[i]
        return out

    def parts(self, q: Sequence[Any]) -> list[Any]:
        """Means and half differences of coordinates."""
        found = self.along(q)
        for j, (i, _) in self.partners.items():
            found[i], found[j] = found[i] * 0.5, found[j] * 0.5
        return found

    def state(self, parts: Sequence[Any]) -> list[Any]:
        """Coordinates from means and half differences."""
        return self.along(parts, -1)


def with_pitchforks(family: Family, found: Found) -> tuple[Found, int]:
    """The result of a search for folds, in which proved pitchforks replace the undecided boxes
    around them.

    Pitchforks are the last roots; their number is returned too.
    """
    number, system = 0, Augmented(family, FOLD)
    scattered = found.roots.undecided.shape[2] > system.options.scattered
    for mirror in () if scattered or found.why else _mirrors(family):
        left = found.roots.undecided
        if not left.shape[2]:
            break
        on_mirror = certified_roots.search(
            _OnMirror(family, mirror), found.region, family.begin, family.begin
        )
        inside, beyond = on_side(system, system.fixed(on_mirror.point.size), on_mirror.ends)
        open_boxes, decided = np.ones(left.shape[2], dtype=bool), []
        for hull in np.moveaxis(clusters(left, found.roots.undecided_point)[0], 2, 0):
            here = np.flatnonzero(contractors.within(on_mirror.ends, hull[:, :, None]))
            complete = contractors.apart(on_mirror.undecided, hull[:, :, None]).all()
            one_root = complete and here.size == 1 and (inside | beyond)[here[0]]
            if one_root and only_fold(family, hull, mirror):
                decided += [int(here[0])] if inside[here[0]] else []
                open_boxes &= ~contractors.within(left, hull[:, :, None])
        pitchforks = on_mirror.select(np.array(decided, dtype=np.intp), slice(0))
        roots = found.roots.select(undecided=open_boxes).concatenated(pitchforks)
        found = replace(found, roots=roots)
        number += len(decided)
    return found, number


def only_fold(family: Family, box: FloatArray, mirror: Mirror) -> bool:
    """Whether a box around one pitchfork, shape (2, n + 1), is proved to hold no other fold."""
    balance, (vary,), low, high = family.balance, family.vary, -box[0], box[1]
    with quiet():
        begin, end = family.at(low[-1:, None]), family.at(high[-1:, None])
        parameters = balance.prepared(Intervals.between(begin, end))
        sides = Intervals(box[:, :-1, None])
        image = stacked(mirror.image(list(sides), balance.arguments(parameters)), (1,))
        wide = np.maximum(box[:, :-1], image.ends[:, :, 0])
        wide = wide + 0.25 * width_of(wide) + 1e-9
        sides = Intervals(wide[:, :, None])
        slopes = matrix(mirror.slopes(balance.state(sides, parameters)), (1,)).middle[:, :, 0]
        wide = stacked(mirror.parts(list(sides)), (1,)).ends[:, :, 0]
    if not np.isfinite(slopes).all():
        return False
    *whole, span = exact_ends(np.concatenate([wide, box[:, -1:]], axis=1))
    bits = 120  # of ball arithmetic
    precise = PreciseBalance(balance, family.given[:, 0], bits, {vary: span})

    def values(parts: Sequence[Any]) -> Sequence[Any]:
        return mirror.forces(precise.state(mirror.state(parts)))

    try:
        return bool(balls.sign(third_derivative(values, whole, slopes, bits, mirror.odd)))
    except UndecidedSign:
        return False


class _OnMirror(OfFamily):
    """The defining system of pitchforks: states on the mirror whose odd block of K is singular."""

    def __init__(self, family: Family, mirror: Mirror) -> None:
        super().__init__(family)
        self.mirror = mirror

    def at(
        self, q: Sequence[Any], values: Values, shape: Shape = (), xp: object = XP
    ) -> Evaluation:
        """The evaluation at the state on the mirror that has the given even coordinates."""
        state, values = self.parted(q, values, xp)
        odd, partners = self.mirror.odd, self.mirror.partners
        for i in odd:
            state[i] = state[i] if i in partners else 0
        image = self.mirror.image(state, values)
        for i, (other, sign) in partners.items():
            state[other] = (state[other] + sign * state[i]) * 0.5
            state[i] = sign * state[other]
        for i in odd:
            state[i] = state[i] if i in partners else image[i] * 0.5
        return Evaluation(self.balance, state, values, shape, xp, self.mirror.upright)

    def conditions(self, at: Evaluation, unknowns: Sequence[Any]) -> Sequence[Any]:
        """Even rows of the balance, the odd coordinates minus their values on the mirror, and the
        determinant of the odd block of K.
        """
        K, odd, forces = self.mirror.slopes(at), self.mirror.odd, self.mirror.forces(at)
        rows = [unknowns[i] - at.q[i] if i in odd else force for i, force in enumerate(forces)]
        return [*rows, determinant([[K[i][j] for j in odd] for i in odd])]


def _mirrors(family: Family) -> list[Mirror]:
    """The mirrors of the page, and mirrors that only change the signs of some coordinates."""
    balance, over = family.balance, family.over
    found = mirrors_of(balance, over)
    known = [one.odd for one in found if not one.exchanges]
    values = balance.over(over)
    for size in range(1, balance.n + 1):
        for odd in itertools.combinations(range(balance.n), size):
            if list(odd) not in known and follows(balance, values, odd):
                found.append(Mirror(list(odd), partial(_with_signs, odd)))
    return found


def even_one(family: Family, block: Sequence[int]) -> int:
    """The number of a coordinate of a block that no mirror changes, else of its first.

    At a fold on a mirror, rows and columns of the adjugate of K are 0 for odd coordinates.
    """
    odd = {number for mirror in _mirrors(family) for number in mirror.odd}
    return next((number for number in block if number not in odd), block[0])


def mirrors_of(balance: Balance, over: Intervals) -> list[Mirror]:
    """The mirrors that the page states for these parameters, shape (P, 1).

    Mirrors that change signs stand before those that exchange coordinates or contacts.
    """
    about, found = balance.model.about["mirror"], list[Mirror]()
    if any(_hold(balance, over, [(name, 0) for name in names]) for names in about["zero"]):
        odd = [balance.coordinates.index(name) for name in about["turned"]]
        if odd:
            found.append(
                Mirror(odd, lambda q, given: balance.at(q, given).mirrored(), about["upright"])
            )
    for about in balance.model.about.get("exchanges", ()):
        touching = [balance.indicators[k] for k in about["contacts"]]
        if touching == balance.indicators and any(
            _hold(balance, over, one) for one in about["where"]
        ):
            pairs = {j: (i, about["signs"][i]) for i, j in enumerate(about["places"]) if i < j}
            alone = [k for k, j in enumerate(about["places"]) if j == k and about["signs"][k] < 0]
            image = partial(_exchanged, about["places"], about["signs"])
            found.append(Mirror(sorted([*pairs, *alone]), image, (), pairs, exchanges=True))
    return found


def _hold(balance: Balance, over: Intervals, equations: Sequence[Sequence[Any]]) -> bool:
    """Whether the equations hold for all parameters in a box.

    An equation is (name, value), where a name is that of a parameter or friction coefficient, and
    the value is a number or another name.
    """
    ends = {name: part.ends.ravel() for name, part in zip(balance.parameters, over, strict=True)}
    with quiet():
        mus = stacked(balance.at((), balance.over(over)).frictions, (1,)).ends[..., 0]
    mus = np.where(np.abs(mus).max(axis=0) <= NEGLIGIBLE, 0.0, mus)
    names = balance.model.about["by_parameters"][-mus.shape[1] :]
    ends |= dict(zip(names, mus.T, strict=True))

    def holds(name: str, value: str | float) -> bool:
        low, high = -ends[name][0], ends[name][1]
        if isinstance(value, str):
            return bool(low == high and (ends[name] == ends[value]).all())
        return bool(low == high == value)

    return all(holds(name, value) for name, value in equations)


def _exchanged(
    places: Sequence[int], signs: Sequence[int], q: Sequence[Any], _: Values
) -> list[Any]:
    """The image of a state whose coordinates are exchanged, with signs."""
    return [sign * q[place] for place, sign in zip(places, signs, strict=True)]


def _with_signs(odd: Sequence[int], q: Sequence[Any], _: Values) -> list[Any]:
    """The image of a state whose odd coordinates change their signs."""
    return [-part if i in odd else part for i, part in enumerate(q)]


def isolated(family: Family) -> Found:
    """Cusps, and undecided boxes, in the plane of two parameters."""
    return all_of([_of_block(family, block) for block in blocks_of(family)])


def _of_block(family: Family, block: tuple[int, ...]) -> Found:
    """Cusps at which the determinant of a block of K vanishes."""
    balance, first = family.balance, block[0]
    found = search(family, cusp_off_mirrors(family, first, block))
    roots = told_apart(family, found, first)
    for column in (k for k in range(balance.n) if k != first):
        # If the first column of the adjugate is 0 at a cusp, as on a mirror, the root is double,
        # but regular with another column.
        hulls = roots.undecided[:, :, :0]
        if roots.undecided_point.size <= balance.options.scattered:
            hulls, _ = clusters(roots.undecided, roots.undecided_point)
        for hull in np.moveaxis(hulls, 2, 0):
            spans = spans_of(hull)[balance.n :]
            near = replace(family, spans=spans, requested=hull[:, : balance.n])
            more = told_apart(near, search(near, cusp_off_mirrors(near, column, block)), column)
            if not more.undecided_point.size:
                open_ = ~contractors.within(roots.undecided, hull[:, :, None])
                roots = different(roots.select(undecided=open_).concatenated(more), found.region)
    return replace(found, roots=roots)


def told_apart(family: Family, found: Found, column: int) -> Roots:
    """The roots of a search for cusps that are cusps; those not known to be become undecided.

    A root is a cusp if the column of the adjugate in use is nonzero. It is no cusp if the
    derivative of det K along another column is nonzero.
    """
    ends, n = found.roots.ends, family.balance.n
    shape = ends.shape[2:]
    system = Augmented(family, cusp(column))
    with quiet():
        K = system.state(variables(list(Intervals(ends)), 1), system.fixed(shape[0])).slopes
        adjugate = [cofactor(K, column, i) for i in range(n)]
        changes = [change(K, other) for other in range(n) if other != column]
    is_cusp, is_none = (
        ~np.logical_and.reduce(stacked([constant(part) for part in parts], shape).holds_zero())
        for parts in (adjugate, changes)
    )
    return found.roots.reopened(is_cusp & ~is_none, ~is_cusp & ~is_none)


def cusp_off_mirrors(family: Family, column: int = 0, block: Block = None) -> Condition:
    """The condition of a cusp, with boxes excluded around mirrors that change the sign of one
    coordinate, or of one half difference.

    Cusps there are possible only where pitchforks are degenerate.
    """
    n = family.balance.n
    mirrors = [one for one in _mirrors(family) if len(one.odd) == 1]

    def images(at: Evaluation) -> list[Intervals]:
        return [stacked(mirror.image(at.q, at.values), at.shape) for mirror in mirrors]

    def excluded(at: Evaluation) -> BoolArray:
        K = replace(at, q=variables(list(at.q), 1)).slopes
        numbers = [constant(change(K, number)) for number in range(n)]
        for mirror, image in zip(mirrors, images(at), strict=True):
            (odd,), both = mirror.odd, Intervals(np.maximum(at.box.ends, image.ends))
            q = mirror.state(variables(mirror.parts(list(both)), 2))
            numbers.append(gradient(change(mirror.slopes(replace(at, q=q)), odd), n)[odd])
        return ~np.logical_and.reduce(stacked(numbers, at.shape).holds_zero())

    def abandoned(at: Evaluation) -> BoolArray:
        q = at.box
        on = [~contractors.apart(q.ends, image.ends) for image in images(at)]
        # Beside a degenerate pitchfork halving decides too slowly.
        small = np.logical_and.reduce(q.width <= 2.0**-12 * scale_of(q.magnitude))
        return small & np.logical_or.reduce(on)

    condition = cusp(column, block)
    return replace(condition, excluded=excluded, abandoned=abandoned) if mirrors else condition


def ended(points: Points) -> Ended:
    """Columns ``ends``, ``when`` and ``after`` of points; empty except at folds along one
    parameter.
    """
    found = replace(with_numbers(points), after=_afterwards)
    enter_border_folds(points, found)
    for row in np.flatnonzero(points.kind == "fold") if len(points.vary) == 1 else ():
        try:
            found.ends[row], found.when[row] = _at(points, int(row))
        except ConvergenceError:
            found.ends[row] = found.when[row] = "undecided"
    return found


def _at(points: Points, row: int) -> tuple[str, str]:
    """Columns ``ends`` and ``when`` at one fold: which of the two states is stable, and in which
    direction they vanish.
    """
    family, z, ends = at_point(points, row)
    side, lower = _normal_form(family, Intervals(ends))
    when = "up" if side < 0 else "down"
    if with_a_zero(family.balance, z[:-1, None], family.at(z[-1:, None])) != EquilibriumType.STABLE:
        return "", when
    return "lower" if lower else "upper", when


def _normal_form(family: Family, box: Intervals) -> tuple[int, bool]:
    """On which side of a fold its two states exist, 1 or −1 along the parameter, and whether det K
    > 0 in the lower one.

    Raises ConvergenceError if a sign is not known.
    """
    system, balance = Augmented(family, FOLD), family.balance
    with quiet():
        at = system.state(variables(list(box), 1), system.fixed(1))
        K, n = at.stiffness(), balance.n
        rows = at.rows("forces")
        adjugate = [[constant(cofactor(K, j, i)) for j in range(n)] for i in range(n)]
        sizes = np.abs(matrix(adjugate, (1,)).middle[:, :, 0])
        r, c = np.unravel_index(int(sizes.argmax()), sizes.shape)
        by_parameter = sum(  # w · ∂F/∂λ, with row r of the adjugate for w
            gradient(force, n + 1)[n] * w for force, w in zip(rows, adjugate[r], strict=True)
        )
        of_determinant = constant(change(K, int(c)))  # ∇(det K) · v, with column c for v
        curvature = of_determinant * adjugate[r][c]
        side = -_sign(by_parameter) * _sign(curvature)
        first = next((sign for sign in (_sign(line[c]) for line in adjugate) if sign), 0)
    if not side or not first:
        raise ConvergenceError("the normal form at the fold is not known well enough")
    return side, first * _sign(of_determinant) < 0


def _sign(value: Number) -> int:
    """Sign of an enclosure, 1 or −1; 0 where it is unknown."""
    return int(stacked([value], (1,)).signs[0, 0])


def _afterwards(points: Points) -> dict[str, FloatArray]:
    """Column ``after``: the stable equilibrium beyond each fold at which a stable state ends,
    nearest to it.
    """
    found, vary = nowhere(points), points.vary[0]
    allowed = points.parameters.ranges[vary]
    for row in np.flatnonzero(np.isin(points.ends, ("lower", "upper"))):
        value, forward = float(points[vary][row]), 1 if points.when[row] == "up" else -1
        # Several errors beyond the fold, its two states have vanished for certain.
        beyond = value + forward * 4 * max(1.0, abs(value)) * float(points.error[row])
        beyond = beyond if allowed.low < beyond < allowed.high else value
        here = equilibria(points.parameters.replace(**{vary: beyond}), method="search")
        stable = here.undamped == EquilibriumType.STABLE
        if here.decided and stable.any():
            before = {
                name: float(points[name][row]) for name in points.parameters.model.coordinates
            }
            slot = nearest_state(here, before, stable, here.error + points.error[row])
            for name, column in found.items():
                column[row] = here[name][slot]
    return found
