"""The space of designs around one, and the nearest design in a set.

A design is a vector z in units of tolerances. :class:`EndOfState` is the border on which the
followed state ends at the design's own value.

:func:`nearest` only asks which of many designs are members of a set. It starts from a point of the
set's border that is locally nearest. Rays from the origin, evenly spread and the same in every run,
look for nearer members, and from these the next locally nearest point is sought, until no ray meets
one. Without a point to start from, the rays go outward to their first members, and the best ray is
turned and shortened. A set that all rays miss is not found, and nothing is proved about it.

Borders are computed in floats: they are predictions, which the callers verify.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..bifurcation.defining_systems import Family
from ..bifurcation.paths import ModelEnd
from ..bifurcation.points import escapes
from ..bifurcation.tubes import Tubes
from ..bifurcation.turning_points import secants, size_of
from ..core.errors import ConvergenceError, ParameterError, require_kind
from ..core.options import Options, limit, option
from ..core.progress import doing
from ..core.remarks import At, Remark
from ..models.parameters import POSITIVE, ParameterSet, Range, as_number, set_of
from ..models.quantities import QuantityValues
from ..numerics.interval_arrays import BoolArray, FloatArray
from ..numerics.vectors import norm
from ..statics.equilibria import equilibria
from ..statics.search import balances_of, number_of
from .jumps import (
    Ends,
    Followed,
    first_limit_points,
    limit_point_passed,
    no_state_to_follow,
    require_known,
    slopes_of,
)

if TYPE_CHECKING:
    from ..models.model import Model

#: Lower and upper limits of quantities, or of z.
Limits = tuple[FloatArray, FloatArray]


@dataclass(frozen=True)
class Design:
    """One design: quantities ``given`` by name with their ``ranges``, and what they mean for the
    model.

    ``parameters`` gives the model's parameters from quantities of any number type. ``made`` gives
    another design, of the caller's class, from the quantities that changed. ``of_model`` is the
    class of the model's sets. ``begins`` gives, from the quantities, the value in the model's units
    from which the rising parameter rises, if that differs among designs. ``rises`` maps names of
    parameters to the quantities that stand for them.
    """

    given: Mapping[str, Any]
    ranges: Mapping[str, Range]
    parameters: Callable[[Mapping[str, Any]], dict[str, Any]]
    made: Callable[[Mapping[str, float]], Any]
    of_model: type[ParameterSet]
    begins: Callable[[Mapping[str, Any]], Any] | None = None
    followed: Mapping[str, float] | None = None  #: as :attr:`ParameterSet.followed`
    rises: Mapping[str, str] = field(default_factory=dict)

    def of(self, model: Model) -> Design:
        """The same design for the model with or without closed forms."""
        return replace(self, of_model=model.Parameters)


@dataclass(frozen=True)
class Space:
    """Designs around one: z = 0 is ``origin``, and quantities are ``origin`` + z ``scale``."""

    design: Design
    names: tuple[str, ...]
    origin: FloatArray
    scale: FloatArray

    def quantities(self, z: FloatArray) -> dict[str, Any]:
        """All quantities of the designs z, shape (…, number of names); others than ``names`` stay
        as they are.
        """
        values = self.origin + z * self.scale
        if not np.iscomplexobj(values):  # rounding must not leave the limits
            values = np.where(z <= self.limits()[0], self.ends[0], np.clip(values, *self.ends))
        return {**self.design.given, **{name: values[..., j] for j, name in enumerate(self.names)}}

    def parameters(self, z: FloatArray) -> dict[str, Any]:
        """The model's parameters of the designs z, by name."""
        return self.design.parameters(self.quantities(z))

    def sets(self, z: FloatArray) -> ParameterSet:
        """The designs z as one set of the model, of the shape of z without its last axis."""
        values = {
            name: np.broadcast_to(value, z.shape[:-1]) for name, value in self.parameters(z).items()
        }
        return set_of(self.design.of_model.model_of_class(), values, self.design.followed)

    def at(self, name: str, value: float) -> Space:
        """The same designs with one parameter, or the quantity that stands for it, fixed at a
        value.
        """
        design, quantity = self.design, self.design.rises.get(name)
        if quantity is not None:
            return replace(self, design=replace(design, given={**design.given, quantity: value}))
        return replace(
            self,
            design=replace(
                design, parameters=lambda given: {**design.parameters(given), name: value}
            ),
        )

    def slopes(self, z: FloatArray) -> dict[str, FloatArray]:
        """Derivatives of each parameter by z at one design, by complex steps, exact to rounding."""
        step = 1e-100
        moved = self.parameters(z + 1j * step * np.eye(z.size))
        return {
            name: np.broadcast_to(np.imag(value) / step, z.shape) for name, value in moved.items()
        }

    def made(self, z: FloatArray) -> ParameterSet | QuantityValues:
        """The design z, in the class of the first one."""
        return self.design.made(
            {name: float(value) for name, value in self.quantities(z).items() if name in self.names}
        )

    def change(self, z: FloatArray) -> dict[str, float]:
        """The change of each quantity from the first design."""
        return dict(zip(self.names, (z * self.scale).tolist(), strict=True))

    @functools.cached_property
    def ends(self) -> Limits:
        """Limits of each quantity that changes; the first design is always within them."""
        allowed = [self.design.ranges[name] for name in self.names]
        inward = 1e-9 * np.maximum(np.abs(self.origin), self.scale)  # from ends that are open
        low, high = np.array([(one.low, one.high) for one in allowed]).T
        low = low + inward * [one.open_low for one in allowed]
        return np.minimum(low, self.origin), np.maximum(high - inward, self.origin)

    def limits(self) -> Limits:
        """Limits of z."""
        low, high = ((end - self.origin) / self.scale for end in self.ends)
        return low, high


def space(
    base: ParameterSet | QuantityValues | Design,
    change: str | Iterable[str] | Mapping[str, float],
    what: str,
) -> Space:
    """The space of designs around ``base`` in the quantities of ``change``.

    Each is measured by its tolerance or, without one, by its own value. ``what`` is the name of the
    argument, for messages.
    """
    design = base if isinstance(base, Design) else _design(base)
    require_kind(what, change, Iterable, "names of what may change, or tolerances by name")
    names = (change,) if isinstance(change, str) else tuple(change)
    for name in names:
        if not isinstance(name, str) or name not in design.given:
            raise ParameterError(
                f"{name!r:.60} in {what} is not a quantity here; the quantities are "
                f"{', '.join(design.given)}"
            )
    if not names:
        raise ParameterError(
            f"{what} names no quantity that may change; name at least one of "
            f"{', '.join(design.given)}"
        )
    origin = np.array([as_number(name, design.given[name]) for name in names])
    if isinstance(change, Mapping):
        sizes = [as_number(f"{what}[{name!r}]", change[name], POSITIVE) for name in names]
        return Space(design, names, origin, np.array(sizes))
    if (origin == 0).any():
        zero = names[int(np.abs(origin).argmin())]
        raise ParameterError(
            f"{zero} = 0 has no relative change; give its tolerance, as {what}={{{zero!r}: 0.1}}"
        )
    return Space(design, names, origin, np.abs(origin))


def _design(base: ParameterSet | QuantityValues) -> Design:
    """A design of a set's parameters of the balance, or of the given quantities of a brake at full
    slip.
    """
    if isinstance(base, QuantityValues):
        kind = base.kind
        return Design(
            base.known,
            kind.ranges(),
            kind.groups,
            lambda changed: replace(base, **changed),
            base.of_model,
        )
    names = base.model.balanced
    given = dict(zip(names, base.scalars(*names), strict=True))
    return Design(
        given,
        base.ranges,
        dict,
        lambda changed: base.replace(**changed),
        type(base),
        followed=base.followed,
    )


class EndOfState:
    """The border of designs at whose own value of ``vary`` the followed state ends, as it rises
    from ``begin``.

    For the first design the end is found by tubes, as by :func:`spragsym.jump_gradient`. For the
    next design it is predicted from the last: a fold by secant steps along the curve of states, in
    milliseconds, and a value at which a state runs to infinity as the nearest one of that kind.
    That the followed state ends there is then not known. If the prediction fails, tubes find the
    end again.
    """

    def __init__(self, designs: Space, vary: str, begin: float) -> None:
        self.designs, self.vary, self.begin = designs, vary, begin
        self.last: FloatArray | ModelEnd | None = None

    def ended(self, z: FloatArray) -> FloatArray:
        """1 where the state of a design has ended, 0 where it has not, NaN where that is unknown.

        A value below that from which the parameter rises counts as not ended.
        """
        return limit_point_passed(self.designs.sets(z), self.vary, self._begins(z))

    def _begins(self, z: FloatArray) -> Any:
        """The value from which the parameter rises, for each design."""
        begins = self.designs.design.begins
        return self.begin if begins is None else begins(self.designs.quantities(z))

    def require_beginning(self) -> None:
        """Raise ConvergenceError if the first design begins in no state or in an unknown one."""
        z = np.zeros(len(self.designs.names))
        first = self.designs.sets(z).replace(**{self.vary: self._begins(z)})
        eq = equilibria(first)
        if none := no_state_to_follow(eq, self.vary):
            raise ConvergenceError(none)
        # The state is followed last: that takes most of the time.
        if not eq.decided and np.isnan(self.ended(z)):
            text = (
                "equilibria at {}, where the state begins, are not all decided, as where a contact "
                "only just touches; begin a little beyond it"
            )
            raise ConvergenceError(Remark(text, At(self.vary, (float(first[self.vary]),), "g")))

    def ahead(self, z: FloatArray) -> tuple[float, FloatArray]:
        """The end of one design's state minus the design's own value, and the gradient of this by
        z.
        """
        p, slopes = self.designs.sets(z), self.designs.slopes(z)
        found = self._next(p) or require_known(first_limit_points(p, self.vary, begin=self.begin))
        unknowns = np.append(found.state, found.value)
        other = found.others.get(0)
        if np.isfinite(unknowns).all():
            self.last = unknowns
        else:
            self.last = other if other and other.kind == "infinity" else None
        # The end does not depend on parameters without slopes, as the belt's speed.
        by_z = sum(
            float(slope) * slopes[name]
            for name, slope in slopes_of(p, self.vary, found).items()
            if name in slopes
        )
        by_z = by_z - slopes[self.vary]
        if not 0 < float(by_z @ by_z) < np.inf:
            raise ConvergenceError("the state does not end, or no slope is known where it does")
        return float(found.value) - float(p[self.vary]), by_z

    def _next(self, p: ParameterSet) -> Ends | None:
        """The predicted end: the fold, or the value of an escape to infinity, near the last one;
        None if there is none in the range.
        """
        if self.last is None:
            return None
        if isinstance(self.last, ModelEnd):
            return self._next_escape(p, self.last)
        followed, z = Followed(p, self.vary, "up", self.begin, None), self.last[:, None]
        n, tubes = followed.balance.n, Tubes.of_points(followed.balance, self.vary, followed.fixed)
        # At a fold the null vector of K is the tangent of the curve, and the pivot is its largest
        # component.
        tangent = np.linalg.svd(tubes.floats(z)[1][:, :n, 0])[2][-1]
        tubes = replace(tubes, pivot=int(np.argmax(np.abs(tangent) / size_of(self.last)[:n])))
        z, converged = secants(tubes, tubes.corrected(z), np.ones(1))
        if not converged[0] or not followed.begin[0] <= z[n, 0] <= followed.until[0]:
            return None
        return Ends(z[n, 0], np.zeros(()), z[:n, 0], {}, followed.until)

    def _next_escape(self, p: ParameterSet, last: ModelEnd) -> Ends | None:
        """The value nearest to the last one at which a state runs to infinity along the same
        coordinates.

        It is sought between half and twice the last value; None if there is none.
        """
        allowed, balances = p.ranges[self.vary], balances_of(p.model)
        near = sorted([0.5 * last.value, 2 * last.value])
        low, high = max(near[0], allowed.low, self.begin), min(near[1], allowed.high)
        if not low < high:
            return None
        number = number_of(balances, last.touching)
        family = Family.of(p, (self.vary,), {self.vary: (low, high)}, balance=balances[number])
        found, before = escapes(family), [*last.before.values()]
        places = np.array([found[name] for name in last.before])
        rows = [
            k for k in range(len(found)) if np.array_equal(places[:, k], before, equal_nan=True)
        ]
        if not rows:
            return None
        row = min(rows, key=lambda row: abs(float(found[self.vary][row]) - last.value))
        end = replace(last, value=float(found[self.vary][row]), error=float(found.error[row]))
        state, until = np.full(len(before), np.nan), np.full(1, high)
        return Ends(np.array(end.value), np.array(end.error), state, {}, until, number, {0: end})

    def near(self, z: FloatArray, steps: int) -> FloatArray | None:
        """The locally smallest z on the border, near a given one; None if it is not found.

        Source: Newton steps on g(z) = 0, with g of :meth:`ahead`. Each step goes to the smallest z
        of the plane g + ∇g · (z′ − z) = 0, or a part of the way if steps do not become smaller.
        """
        share, best = 1.0, np.inf
        try:
            for _ in range(steps):
                ahead, by_z = self.ahead(z)
                step = _smallest(by_z, float(by_z @ z) - ahead, *self.designs.limits()) - z
                length = norm(step)
                share = min(1.0, 2 * share) if length < best else 0.3 * share
                best = min(best, length)
                z = z + share * step
                if length <= 1e-10 * norm(z):
                    break
            ahead, by_z = self.ahead(z)
        except ConvergenceError:
            return None
        return z if abs(ahead) < 1e-9 * norm(by_z) else None


def _smallest(slopes: FloatArray, level: float, low: FloatArray, high: FloatArray) -> FloatArray:
    """The z of smallest norm with slopes · z = level, within limits around 0; components beyond a
    limit are fixed at it one after another.
    """
    z, free = np.zeros_like(slopes), slopes != 0
    while free.any():
        z[free] = (level - slopes[~free] @ z[~free]) * slopes[free] / (slopes[free] @ slopes[free])
        beyond = free & ((z < low) | (z > high))
        if not beyond.any():
            break
        z[beyond] = np.clip(z, low, high)[beyond]
        free &= ~beyond
    return z


Member = Callable[[FloatArray], BoolArray]
#: Gives the locally nearest point of the border, a member, from a point near the border or from 0;
#: None if it is not found.
Improved = Callable[[FloatArray], FloatArray | None]


@dataclass(frozen=True)
class MarginOptions(Options):
    """Options of the search for the nearest design on a border.

    Parameters
    ----------
    rays : int
        Number of rays over the square of the dimension.
    rounds : int
        Most improvements of the nearest design.
    coarse, fine : int
        Halvings of a radius, to compare rays and at the end.
    steps : int
        Most steps of Newton's method towards the border.
    prove : bool
        Also prove that nothing jumps within a part of the distance, as large as can be proved in a
        few seconds.
    proof : float
        Limit of the parts of a box in one attempt to prove, over that of a certificate.

    Examples
    --------
    >>> import spragsym as ss
    >>> p = ss.Parameters.article(theta0=0.7)
    >>> few = ss.MarginOptions(rays=1, rounds=2)
    >>> margin = ss.jump_margin(p, {"theta0": 0.02, "mu0": 0.05}, options=few)
    >>> round(margin.distance, 4)
    1.6056
    """

    rays: int = limit(8)
    rounds: int = limit(20, 0)
    coarse: int = limit(9)
    fine: int = limit(36)
    steps: int = limit(40)
    prove: bool = False
    proof: float = option(0.15, 0.0, 10.0)


def nearest(
    member: Member, limits: Limits, improved: Improved, options: MarginOptions | None = None
) -> FloatArray | None:
    """A member of a set near 0, about as near as rays find one, shape (dimensions,); None without
    one.

    ``member`` says which of many points, shape (n, dimensions), are members, and ``limits`` are the
    limits of each component. ``improved`` gives the locally nearest member on the border, if it
    finds one.
    """
    return _RaySearch(member, limits, improved, options or MarginOptions()).nearest()


@dataclass(frozen=True)
class _RaySearch:
    """The search along rays from 0; arguments as for :func:`nearest`."""

    member: Member
    limits: Limits
    improved: Improved
    options: MarginOptions

    def nearest(self) -> FloatArray | None:
        """The nearest member found, or None."""
        size = self.limits[0].size
        if self.member(np.zeros((1, size)))[0]:
            return np.zeros(size)
        rays = self._rays(size)
        found = self.improved(np.zeros(size))
        if found is None:
            radii = np.concatenate([[1e-6], 2.0 ** np.arange(-8, 8.01, 0.25)])  # from near to far
            batches = np.array_split(radii, -(-radii.size // max(1, 512 // len(rays))))
            tried = (self._on_rays(rays, batch) for batch in batches)
            first = next((point for point in tried if point is not None), None)
            if first is None:
                return None
            found = self._better(self._rotated(first))
        for _ in range(self.options.rounds):
            nearer = self._on_rays(rays, norm(found) * np.array([0.999, 0.7, 0.4]))
            if nearer is None:
                break
            found = self._better(nearer)
        return found

    def _better(self, point: FloatArray) -> FloatArray:
        """The locally nearest point of the border near a member, or the border on the
        member's ray.
        """
        radius = np.array([norm(point)])
        ray = point[None] / radius
        # A few halvings are mostly enough; more of them, near the border, are expensive.
        far = self._shortened(ray, radius, self.options.coarse)
        found = self.improved(ray[0] * far)
        if found is not None and not self.member(ray * norm(found) * (1 - 1e-6))[0]:
            return found
        border = ray[0] * self._shortened(ray, far, self.options.fine)
        found = self.improved(border * (1 - 1e-9))  # from just before the border
        return border if found is None or norm(found) > norm(border) else found

    def _on_rays(self, rays: FloatArray, radii: FloatArray) -> FloatArray | None:
        """The nearest point where a ray meets the border, among rays with a member at one of the
        radii; None if there is no member. Rays end at the limits.
        """
        lengths = np.minimum(radii[:, None], self._reach(rays))
        with doing("designs up to {:.4g} tolerances away", lengths.max()):
            inside = self.member((lengths[..., None] * rays).reshape(-1, rays.shape[1])).reshape(
                lengths.shape
            )
        if not inside.any():
            return None
        radius = np.where(inside, lengths, np.inf).min(axis=0)
        near = np.flatnonzero(radius <= 1.5 * radius.min())
        found = self._shortened(rays[near], radius[near], self.options.coarse)
        return rays[near[np.argmin(found)]] * found.min()

    def _rays(self, size: int) -> FloatArray:
        """Unit vectors: in both directions along every axis, and evenly spread."""
        from scipy import stats

        axes = np.concatenate([np.eye(size), -np.eye(size)])
        if size == 1:
            return axes
        number = 1 << int(np.ceil(np.log2(self.options.rays * size * size)))
        points = stats.qmc.Sobol(size, scramble=True, rng=np.random.default_rng(20)).random(number)
        normal = stats.norm.ppf(np.clip(points, 1e-9, 1 - 1e-9))
        return np.concatenate([axes, normal / np.linalg.norm(normal, axis=-1, keepdims=True)])

    def _reach(self, rays: FloatArray) -> FloatArray:
        """Length of each ray within the limits."""
        with np.errstate(divide="ignore", invalid="ignore"):
            low, high = (limit / rays for limit in self.limits)
            ends = np.select([rays > 0, rays < 0], [high, low], np.inf)
        return ends.min(axis=-1)

    def _shortened(self, rays: FloatArray, radius: FloatArray, halvings: int) -> FloatArray:
        """Radii of the border on rays whose ends are members, by division into parts; more parts at
        once where rays are few.
        """
        parts = min(16, max(2, 4096 // len(rays)))
        low, high = np.zeros_like(radius), radius.copy()
        for _ in range(-(-halvings // int(np.log2(parts)))):
            marks = low + np.linspace(0.0, 1.0, parts + 1)[1:-1, None] * (high - low)
            with doing("designs {:.4g} tolerances away, and nearer ones", high.min()):
                inside = self.member((rays * marks[..., None]).reshape(-1, rays.shape[-1])).reshape(
                    marks.shape
                )
            edges = np.concatenate([low[None], marks, high[None]])
            first = (
                np.argmax(np.concatenate([inside, np.ones((1, radius.size), dtype=bool)]), axis=0)
                + 1
            )
            low, high = (
                np.take_along_axis(edges, (first - side)[None], axis=0)[0] for side in (1, 0)
            )
        return high

    def _rotated(self, point: FloatArray) -> FloatArray:
        """A member on a shorter ray: the ray is turned by random steps, ever smaller ones, that
        shorten it.
        """
        radius = norm(point)
        ray = point / radius
        if ray.size > 1:
            normal = np.random.default_rng(21).standard_normal(
                (self.options.rays * ray.size, ray.size)
            )
            for spread in (0.3, 0.1, 0.1, 0.03, 0.03, 0.01):
                rays = ray + spread * normal
                rays /= np.linalg.norm(rays, axis=-1, keepdims=True)
                tried = radius * (1 - 1e-2 * spread)
                good = (self._reach(rays) >= tried) & self.member(rays * tried)
                if good.any():
                    found = self._shortened(
                        rays[good], np.full(int(good.sum()), tried), self.options.coarse
                    )
                    ray, radius = rays[good][np.argmin(found)], float(found.min())
        return ray * radius
