"""Every onset of squeal of a model of matrices along a parameter, by the main inertia theorem."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from ..core.progress import doing, tell
from ..numerics.definite import Middle, Pencil, Series, Window, window
from ..numerics.interval_arrays import BoolArray, ComplexArray, joined
from .options import MatrixOptions
from .reduction import inverse


@dataclass(frozen=True)
class Stretch:
    """Values of the parameter from ``low`` to ``high`` at which ``count`` eigenvalues grow faster
    than the threshold, and none as fast: proved.
    """

    low: float
    high: float
    count: int


@dataclass(frozen=True)
class PairCrossing:
    """A value of the parameter at which an eigenvalue, with its conjugate, passes the threshold."""

    value: float
    proof: Window
    partner: float  #: frequency of the mode that bends its eigenvalue most, by floats


@dataclass
class OnsetSearch:
    """The proof over a range, by stretches about middles and windows about crossings.

    What is left between them is halved until it is as narrow as the option ``least`` says.
    """

    pencil: Pencil
    span: tuple[float, float]
    growth: float
    options: MatrixOptions
    stretches: list[Stretch] = field(default_factory=list)
    crossings: list[PairCrossing] = field(default_factory=list)
    undecided: list[tuple[float, float]] = field(default_factory=list)

    def run(self) -> OnsetSearch:
        """The search, to its end."""
        low, high = self.span
        at_end = next((one for end in self.span if (one := self._at(end)) is not None), None)
        gaps: list[tuple[float, float, float | None]] = [(low, high, at_end)]
        least, left = self.options.least * (high - low), self.options.middles
        with doing("onsets of squeal"):
            while gaps:
                gap = gaps.pop()
                # A model that lies on the threshold everywhere is given up early.
                hopeless = not self.stretches and left < self.options.middles - 64
                narrow = gap[1] - gap[0] <= least and gap[2] is None
                if narrow or not left or hopeless:
                    self.undecided.append(gap[:2])
                    continue
                left -= 1
                gaps += self._about(*gap)
                tell(
                    "{} onsets, {:.1%} of the range proved",
                    len(self.crossings),
                    1.0 - sum(b - a for a, b, _ in gaps) / (high - low),
                )
        self.stretches.sort(key=lambda one: one.low)
        self.crossings.sort(key=lambda one: one.value)
        self.undecided = [(low, high) for low, high in joined(np.array(self.undecided)).tolist()]
        return self

    def merged(self) -> list[Stretch]:
        """The stretches, those that touch and have one count as one, in order."""
        out = list[Stretch]()
        for one in self.stretches:
            if out and out[-1].count == one.count and one.low <= out[-1].high:
                out[-1] = Stretch(out[-1].low, max(out[-1].high, one.high), one.count)
            else:
                out.append(one)
        return out

    def _about(
        self, low: float, high: float, guess: float | None
    ) -> Iterator[tuple[float, float, float | None]]:
        """Parts that are left of a gap after a proof about its middle, or about a crossing in it;
        with the value of the crossing that is next there, if one is foreseen.
        """
        t = 0.5 * (low + high) if guess is None else guess
        middle = self._middle(t)
        if middle is None:
            for ends in ((low, t), (t, high)):
                yield (*ends, None)
            return
        left = right = t
        if guess is None and middle.is_neutral(0.5 * (high - low)):
            self.undecided.append((low, high))
            return
        if guess is None:
            signs, free = middle.values.real, self._near(middle, max(high - t, t - low))
            sides = (Series(middle, signs, self.options.terms, free),) * 2
            left, right = self._reached(sides, low, high)
        elif (found := self._crossing(middle, low, high)) is not None:
            left, right = found
        for near, far, side in ((left, low, -1), (right, high, 1)):
            if far * side > near * side:
                ends = (far, near) if side < 0 else (near, far)
                # What failed is not tried again before the gap is halved.
                failed = guess is not None and left == right == t
                yield (*ends, None if failed else self._foreseen(middle, ends))

    def _at(self, end: float) -> float | None:
        """The value of a crossing at an end of the range, by floats, or None."""
        if (middle := self._middle(end)) is None:
            return None
        growth, slope, _ = middle.paths.real
        reach = 1e-9 * (self.span[1] - self.span[0])
        near = np.flatnonzero(np.abs(growth) <= reach * np.abs(slope))
        if not near.size:
            return None
        frequency = abs(float(middle.values[near[0]].imag))
        found = polished(self.pencil, self.growth, end, frequency)
        return found[0] if found is not None and abs(found[0] - end) <= reach else None

    def _middle(self, t: float) -> Middle | None:
        """The eigenbasis at a value; None if floats have none."""
        try:
            middle = Middle(self.pencil, t, self.growth)
        except np.linalg.LinAlgError:
            return None
        return middle if middle.is_finite else None

    @staticmethod
    def _near(middle: Middle, reach: float) -> BoolArray:
        """The eigenvalues that pass the threshold within the reach, by floats to second order."""
        steps = (reach * np.linspace(-1.0, 1.0, 17))[:, None] ** np.arange(3)
        growth = (steps @ middle.paths).real
        one_side = (growth > 0).all(axis=0) | (growth < 0).all(axis=0)
        return np.logical_not(np.asarray(one_side))

    def _reached(
        self,
        sides: tuple[Series, Series],
        low: float,
        high: float,
        least: float = 0.0,
        touching: int | None = None,
    ) -> tuple[float, float]:
        """Ends of the stretches about a middle, within the gap; the stretches are kept."""
        t = sides[0].middle.t
        ends = [t, t]
        shortest = least or 1e-3 * self.options.least * (self.span[1] - self.span[0])
        for index, (series, side, end) in enumerate(zip(sides, (-1, 1), (low, high), strict=True)):
            limit = float(np.nextafter(abs(end - t), np.inf))
            if (end - t) * side <= shortest:
                continue
            h = series.reach(side, limit, shortest, touching)
            if h > 0:
                stop = end if h == limit else float(np.nextafter(t + side * h, t))
                start = t + side * least
                self.stretches.append(Stretch(min(start, stop), max(start, stop), series.count))
                ends[index] = stop
        return ends[0], ends[1]

    def _crossing(self, middle: Middle, low: float, high: float) -> tuple[float, float] | None:
        """Ends of the proof about a crossing, which is kept; None if it can't be proved."""
        index = int(np.abs(middle.values.real).argmin())
        width = self.span[1] - self.span[0]
        found = None
        for power in range(3, 16):
            found = window(middle, index, width * 10.0**-power)
            if found is not None:
                break
        if found is None:
            return None
        self.crossings.append(PairCrossing(middle.t, found, _partner(middle, index)))
        sides = list[Series]()
        free = self._near(middle, max(high - middle.t, middle.t - low))
        free[index] = True
        for side in (-1, 1):
            signs = middle.values.real.copy()
            signs[index] = side * found.direction
            sides.append(Series(middle, signs, self.options.terms, free))
        left, right = self._reached((sides[0], sides[1]), low, high, found.half, index)
        near = np.nextafter(found.half, 0.0)
        return (
            min(left, float(np.nextafter(middle.t - near, middle.t))),
            max(right, float(np.nextafter(middle.t + near, middle.t))),
        )

    def _foreseen(self, middle: Middle, ends: tuple[float, float]) -> float | None:
        """The value of a crossing in a gap, by floats from the eigenvalues beside it, or None."""
        away = np.array(ends) - middle.t
        near, far = away[np.abs(away).argsort()]
        # One at an end of the range may lie beyond it by a rounding.
        slack = 1e-9 * (self.span[1] - self.span[0])
        far += np.copysign(slack, far)
        steps = np.linspace(near, min(far, max(4.0 * near, 0.02 * far), key=abs), 25)
        along = steps[:, None] ** np.arange(3) @ middle.paths
        passed = along.real * np.where(middle.values.real > 0, 1.0, -1.0) <= 0.0
        if not passed.any():
            return None
        index = int(np.where(passed.any(axis=0), passed.argmax(axis=0), len(steps)).argmin())
        step = int(passed[:, index].argmax())
        found = polished(
            self.pencil, self.growth, middle.t + float(steps[step]), abs(along[step, index].imag)
        )
        if found is None or not ends[0] - slack <= (value := found[0]) <= ends[1] + slack:
            return None
        known = any(abs(value - one.value) <= one.proof.half for one in self.crossings)
        return None if known else value


def _partner(middle: Middle, index: int) -> float:
    """Frequency of the mode that bends an eigenvalue most, by perturbation to second order."""
    p = middle.pairs
    if index >= p or p < 2:
        return float("nan")
    B = middle.in_pairs(middle.slope)[:p, :p]
    away = middle.values[:p] - middle.values[index]
    away[index] = np.inf
    bends = np.abs(B[index] * B[:, index] / np.where(away == 0, np.inf, away))
    return float(middle.values[int(bends.argmax())].imag)


def polished(
    pencil: Pencil,
    growth: float,
    value: float,
    frequency: float,
) -> tuple[float, float] | None:
    """The parameter at which an eigenvalue has the real part ``growth``, and its frequency, by
    Newton in floats.
    """
    M = pencil.mass
    s, step = complex(growth, frequency), np.inf
    q: ComplexArray = np.ones(M.shape[0], dtype=complex)
    y: ComplexArray = np.ones(M.shape[0], dtype=complex)
    for turn in range(30):
        D, _ = pencil.at(value)
        L = pencil.dynamic_stiffness(s, value)
        try:
            solve, solve_transposed = inverse(L)
        except np.linalg.LinAlgError:  # it is an eigenvalue, to the bit
            return value, abs(s.imag)
        dL = 2.0 * s * M + D
        for _ in range(3 if turn == 0 else 1):
            q = solve(dL @ q)
            q /= np.linalg.norm(q)
            y = solve_transposed(dL.T @ y)
            y /= np.linalg.norm(y)
        by_s = y @ (dL @ q)
        by_t = y @ ((s * pencil.damping_slope + pencil.stiffness_slope) @ q)
        away = -(y @ (L @ q)) / by_s
        slope = -by_t / by_s
        if not np.isfinite(away) or not np.isfinite(slope) or slope.real == 0.0:
            return None
        step = float((growth - (s + away).real) / slope.real)
        value += step
        s = complex(growth, (s + away + slope * step).imag)
        if abs(step) <= 4e-16 * max(abs(value), 1e-3 * abs(step)) or (
            turn > 4 and abs(step) <= 1e-12 * abs(value)
        ):
            return value, abs(s.imag)
    return None
