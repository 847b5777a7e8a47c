"""Quantities measured on a motion while it runs, or from its samples afterwards: averages, turning
points, frequencies.
"""

import math
from dataclasses import dataclass

import numpy as np

from ..display import Column
from ..models.field import Field
from ..models.parameters import FloatArray, as_count
from ..numerics.interval_arrays import IndexArray
from ..numerics.vectors import makes_turns
from ..results.result import Result
from .lobatto import PiecewisePolynomial

#: Turning points that are kept of a motion, the latest: what is known of it needs no more memory
#: the longer it runs.
KEPT_EXTREMA = 5000


@dataclass(frozen=True)
class MotionStatistics:
    """Quantities measured on a motion while it runs; its steps are not kept, nor turning points
    before the latest KEPT_EXTREMA of a kind.

    States ``first`` (2 n,) at ``begin``, ``last`` at ``end``, ``maxima`` (k, 2 n) at ``maxima_t``
    where the leading coordinate x is largest, ``minima`` (l, 2 n), ``passages`` (j, 2 n) at
    ``passages_t`` of an x that comes around through whole turns; ``integrals`` (n + 1,) over time:
    of u = x − x(begin), of u², and of the other coordinates; how many ``events`` (4,) of each kind;
    least and largest x, ``reach``; the place of x, ``lead``.
    """

    begin: float
    end: float
    first: FloatArray
    last: FloatArray
    maxima_t: FloatArray
    maxima: FloatArray
    integrals: FloatArray
    minima: FloatArray
    events: IndexArray
    reach: tuple[float, float]
    passages_t: FloatArray
    passages: FloatArray
    lead: int

    def moments(self) -> tuple[float, float]:
        """Mean of x and root mean square about it."""
        shift, square, *_ = self.integrals / (self.end - self.begin)
        return float(self.first[self.lead] + shift), math.sqrt(max(square - shift * shift, 0.0))

    @property
    def means(self) -> FloatArray:
        """Means of all coordinates."""
        others = self.integrals[2:] / (self.end - self.begin)
        return np.insert(others, self.lead, self.moments()[0])


def statistics_of(
    samples: PiecewisePolynomial, events: IndexArray, field: Field
) -> MotionStatistics:
    """Statistics of a motion of a field given by its samples, and the number of events of each
    kind.
    """
    t, states, lead = samples.t, samples.states, field.lead
    n, x = len(states) // 2, states[lead]
    shift, others = x - x[0], np.delete(states[:n], lead, axis=0)
    lowest, highest = (samples.passages(n + lead, sign) for sign in (1, -1))
    maxima, minima = samples(highest).T, samples(lowest).T
    extrema = np.concatenate([x[[0, -1]], maxima[:, lead], minima[:, lead]])
    late = highest[-KEPT_EXTREMA:]
    turning = PiecewisePolynomial(t, np.sin(x[None] / 2))
    passed = np.sort(turning.zeros() if makes_turns(lead, field.periodic) else late[:0])[
        -KEPT_EXTREMA:
    ]
    return MotionStatistics(
        float(t[0]),
        float(t[-1]),
        states[:, 0],
        states[:, -1],
        late,
        maxima[-KEPT_EXTREMA:],
        np.array([shift, shift**2, *others]) @ samples.weights(),
        minima[-KEPT_EXTREMA:],
        events,
        (float(extrema.min()), float(extrema.max())),
        passed,
        samples(passed).T,
        lead,
    )


@dataclass(frozen=True, eq=False)
class Spectrum(Result):
    """Amplitudes over frequency, in cycles per unit of time: a sine of amplitude A has the peak A,
    if it lies on a bin.
    """

    schema = (Column("frequency", "1/s", "cycles per unit of time"),)

    frequency: FloatArray
    amplitude: FloatArray

    def peak(self) -> float:
        """The frequency of the largest amplitude, between the bins by a parabola through three
        logarithms.
        """
        k = int(np.argmax(self.amplitude))
        step = float(self.frequency[1] - self.frequency[0])
        if not 0 < k < self.amplitude.size - 1 or (self.amplitude[k - 1 : k + 2] <= 0).any():
            return float(self.frequency[k])
        left, middle, right = np.log(self.amplitude[k - 1 : k + 2])
        bend = left - 2 * middle + right
        return float(self.frequency[k] + (0.5 * (left - right) / bend * step if bend else 0.0))


def spectrum_of(samples: PiecewisePolynomial, row: int, points: int) -> Spectrum:
    """The amplitude spectrum of one component, about its mean, with Hann's window."""
    # Most points at equal steps that a motion is sampled at.
    most = 2**20
    points = as_count("points", points, 16, most)
    t = np.linspace(samples.t[0], samples.t[-1], points, endpoint=False)
    values = samples(t)[row]
    window = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(points) / points)
    amplitude = (
        2 * np.abs(np.fft.rfft((values - (window @ values) / window.sum()) * window)) / window.sum()
    )
    frequency = np.asarray(np.fft.rfftfreq(points, float(t[1] - t[0])), dtype=float)
    return Spectrum(frequency, np.asarray(amplitude, dtype=float))
