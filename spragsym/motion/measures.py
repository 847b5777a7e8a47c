"""Statistics of a motion (extrema, averages, event counts), and its amplitude spectrum.

Statistics are accumulated during an integration by heyoka, or computed from samples.
"""

import math
from dataclasses import dataclass
from dataclasses import field as attribute

import numpy as np

from ..display import Column
from ..models.field import Field
from ..models.parameters import FloatArray, as_count
from ..numerics.interval_arrays import ComplexArray, IndexArray
from ..numerics.vectors import TURN
from ..results.result import Result
from .lobatto import PiecewisePolynomial

#: Number of extrema of a kind that are kept, the latest: so the memory for a motion is bounded.
KEPT_EXTREMA = 5000


@dataclass(frozen=True)
class MotionStatistics:
    """Statistics of a motion with n coordinates, of which x, with index ``lead``, is the leading
    one.

    Attributes
    ----------
    begin, end : float
        Times.
    first, last : ndarray, shape (2 n,)
        States at these times.
    maxima_t, maxima : ndarray, shapes (k,) and (k, 2 n)
        Times and states of the latest maxima of x, KEPT_EXTREMA at most.
    integrals : ndarray, shape (n + 1,)
        Integrals over time of u = x − x(begin), of u², and of the other coordinates.
    minima : ndarray, shape (l, 2 n)
        States of the latest minima of x.
    events : ndarray
        Number of events of each kind.
    reach : tuple of float
        Smallest and largest x.
    passages_t, passages : ndarray, shapes (j,) and (j, 2 n)
        Times and states at which the phase of a clock, or else a periodic x, passes a whole turn.
    lead : int
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
        """Mean and standard deviation of x."""
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
    """Statistics of a motion given by samples and the number of ``events`` of each kind."""
    t, states, lead = samples.t, samples.states, field.lead
    n, x = len(states) // 2, states[lead]
    shift, others = x - x[0], np.delete(states[:n], lead, axis=0)
    minima_t, maxima_t = (samples.passages(n + lead, sign) for sign in (1, -1))
    maxima, minima = samples(maxima_t).T, samples(minima_t).T
    extrema = np.concatenate([x[[0, -1]], maxima[:, lead], minima[:, lead]])
    passages_t = np.empty(0)
    if field.marker is not None and field.clock:  # one step may be of many turns
        (begin, end), turn = states[field.marker, [0, -1]] / TURN, TURN / states[-1, 0]
        passages_t = t[0] + turn * (np.arange(math.ceil(begin), math.floor(end) + 1) - begin)
    elif field.marker is not None:
        half_turns = PiecewisePolynomial(t, np.sin(states[[field.marker]] / 2))
        passages_t = np.sort(half_turns.zeros())
    passages_t = passages_t[-KEPT_EXTREMA:]
    return MotionStatistics(
        float(t[0]),
        float(t[-1]),
        states[:, 0],
        states[:, -1],
        maxima_t[-KEPT_EXTREMA:],
        maxima[-KEPT_EXTREMA:],
        np.array([shift, shift**2, *others]) @ samples.weights(),
        minima[-KEPT_EXTREMA:],
        events,
        (float(extrema.min()), float(extrema.max())),
        passages_t,
        samples(passages_t).T,
        lead,
    )


@dataclass(frozen=True, eq=False)
class Spectrum(Result):
    """Amplitude spectrum over frequency, in cycles per unit of time.

    Over whole periods these are the Fourier coefficients: the motion is its mean and the sum of
    amplitude cos(2π frequency (t − t_0) + phase). Through a window a sine of amplitude A has the
    peak A if its frequency is on a bin; lines closer than two bins are not told apart.

    Attributes
    ----------
    frequency, amplitude, phase : ndarray, shape (k,)
        From the frequency 0 on, at which the amplitude is 0.
    window : str
        "Hann" or "whole periods".
    """

    schema = (
        Column("frequency", "1/s", "cycles per unit of time"),
        Column("phase", "rad", "phase of the cosine at the beginning"),
    )

    frequency: FloatArray
    amplitude: FloatArray
    phase: FloatArray = attribute(default_factory=lambda: np.empty(0))
    window: str = "Hann"

    def peak(self) -> float:
        """Frequency of the largest amplitude; through a window, interpolated between bins by a
        parabola through the logarithms of three amplitudes.
        """
        k = int(np.argmax(self.amplitude))
        step = float(self.frequency[1] - self.frequency[0])
        inner = self.window == "Hann" and 0 < k < self.amplitude.size - 1
        if not inner or (self.amplitude[k - 1 : k + 2] <= 0).any():
            return float(self.frequency[k])
        left, middle, right = np.log(self.amplitude[k - 1 : k + 2])
        bend = left - 2 * middle + right
        return float(self.frequency[k] + (0.5 * (left - right) / bend * step if bend else 0.0))


def spectrum_of(samples: PiecewisePolynomial, row: int, points: int) -> Spectrum:
    """Amplitude spectrum of one component about its mean, from equidistant points, with Hann's
    window.
    """
    points = as_count("points", points, 16, 2**20)
    t = np.linspace(samples.t[0], samples.t[-1], points, endpoint=False)
    values = samples(t)[row]
    window = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(points) / points)
    deviation = values - (window @ values) / window.sum()
    frequency = np.asarray(np.fft.rfftfreq(points, float(t[1] - t[0])), dtype=float)
    return _of_coefficients(frequency, 2 * np.fft.rfft(deviation * window) / window.sum(), "Hann")


def harmonics_of(samples: PiecewisePolynomial, row: int, periods: int, count: int) -> Spectrum:
    """Fourier coefficients of one component of a motion over whole periods, of the mean and
    ``count`` harmonics. The polynomials of the steps are integrated exactly.
    """
    harmonics = np.arange(count + 1)
    span = float(samples.t[-1] - samples.t[0])
    frequency: FloatArray = np.asarray(harmonics * periods / span, dtype=float)
    coefficients = 2 / span * samples.fourier(row, 2 * np.pi * frequency)
    coefficients[0] = 0.0
    return _of_coefficients(frequency, coefficients, "whole periods")


def _of_coefficients(frequency: FloatArray, found: ComplexArray, window: str) -> Spectrum:
    return Spectrum(frequency, np.abs(found), np.angle(found), window)
