"""Frequencies and damping of a motion, from its samples."""

from dataclasses import dataclass

import numpy as np

from ..errors import ParameterError
from ..models.parameters import FloatArray
from ..results.result import Result
from .lobatto import PiecewisePolynomial

#: Most points at equal steps that a motion is sampled at.
MOST_POINTS = 1 << 20


@dataclass(frozen=True)
class Spectrum(Result):
    """Amplitudes over frequency, in cycles per unit of time: a sine of amplitude A has the peak A, if it lies on a bin."""

    frequency: FloatArray
    amplitude: FloatArray

    def peak(self) -> float:
        """The frequency of the largest amplitude, between the bins by a parabola through three logarithms."""
        k = int(np.argmax(self.amplitude))
        step = float(self.frequency[1] - self.frequency[0])
        if not 0 < k < self.amplitude.size - 1 or (self.amplitude[k - 1 : k + 2] <= 0).any():
            return float(self.frequency[k])
        left, middle, right = np.log(self.amplitude[k - 1 : k + 2])
        bend = left - 2 * middle + right
        return float(self.frequency[k] + (0.5 * (left - right) / bend * step if bend else 0.0))


def spectrum_of(samples: PiecewisePolynomial, row: int, points: int) -> Spectrum:
    """The amplitude spectrum of one component, about its mean, with Hann's window."""
    if isinstance(points, bool) or not isinstance(points, int | np.integer) or not 16 <= points <= MOST_POINTS:
        raise ParameterError(f"points = {points!r} is not between 16 and {MOST_POINTS}; 4096 suits most motions")
    t = np.linspace(samples.t[0], samples.t[-1], points, endpoint=False)
    values = samples(t)[row]
    window = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(points) / points)
    amplitude = 2 * np.abs(np.fft.rfft((values - (window @ values) / window.sum()) * window)) / window.sum()
    frequency = np.asarray(np.fft.rfftfreq(points, float(t[1] - t[0])), dtype=np.float64)
    return Spectrum(frequency, np.asarray(amplitude, dtype=np.float64))


def decay_rate_of(t: FloatArray, extrema: FloatArray) -> float:
    """The rate at which swings between successive extrema shrink, by least squares on their logarithms; NaN for one."""
    order = np.argsort(t)
    swings = np.abs(np.diff(extrema[order]))
    middle = 0.5 * (t[order][1:] + t[order][:-1])
    kept = swings > 1e-13 * max(float(np.abs(extrema).max(initial=0.0)), 1e-300)
    if np.count_nonzero(kept) < 2:
        return float("nan")
    slope, _ = np.polyfit(middle[kept] - middle[kept][0], np.log(swings[kept]), 1)
    return -float(slope)
