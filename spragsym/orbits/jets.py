"""Taylor coefficients of an expression in time, one after the other, over any number type: for python-flint's balls."""

from __future__ import annotations

from collections.abc import Callable
from operator import methodcaller
from typing import Any

from ..numerics.jets import Functions
from ..numerics.rounded import repeated_product


class Jet:
    """A power series whose next coefficient is computed when it is asked for; arithmetic builds further ones."""

    def __init__(self, following: Callable[[int], Any] | None = None) -> None:
        self.known: list[Any] = []
        self._following = following

    @classmethod
    def constant(cls, value: Any) -> Jet:
        """A number as a series."""
        found = cls(lambda k: 0 * value)
        found.known.append(value)
        return found

    def __getitem__(self, k: int) -> Any:
        while len(self.known) <= k:
            assert self._following is not None, "a coefficient of the unknown was asked for before it was there"
            self.known.append(self._following(len(self.known)))
        return self.known[k]

    def __add__(self, other: Any) -> Jet:
        if isinstance(other, Jet):
            return Jet(lambda k: self[k] + other[k])
        return Jet(lambda k: self[k] + other if k == 0 else self[k])

    __radd__ = __add__

    def __neg__(self) -> Jet:
        return Jet(lambda k: -self[k])

    def __sub__(self, other: Any) -> Jet:
        difference: Jet = self + (-other)
        return difference

    def __rsub__(self, other: Any) -> Jet:
        difference: Jet = (-self) + other
        return difference

    def __mul__(self, other: Any) -> Jet:
        if isinstance(other, Jet):
            return Jet(lambda k: _convolved(self, other, 0, k))
        return Jet(lambda k: self[k] * other)

    __rmul__ = __mul__

    def __pow__(self, power: int) -> Any:
        return repeated_product(self, power) if power else 1

    def __truediv__(self, other: Any) -> Jet:
        if not isinstance(other, Jet):
            return Jet(lambda k: self[k] / other)
        return _quotient(lambda k: self[k], other)

    def __rtruediv__(self, other: Any) -> Jet:
        return _quotient(lambda k: other if k == 0 else 0, self)

    def sqrt(self) -> Jet:
        """Square root: 2 s₀ s_k = a_k − Σ s_i s_{k−i}, 0 < i < k."""
        root = Jet()

        def following(k: int) -> Any:
            if k == 0:
                return self[0].sqrt()
            inner = _convolved(root, root, 1, k - 1, k)
            return (self[k] - inner) / (2 * root[0])

        root._following = following
        return root

    def exp(self) -> Jet:
        """Exponential: y′ = y x′."""
        return self._of_slope(lambda first: first.exp(), lambda y: y)

    def log(self) -> Jet:
        """Natural logarithm: y′ = x′/x."""
        return self._of_slope(lambda first: first.log(), lambda y: 1 / self)

    def tanh(self) -> Jet:
        """Hyperbolic tangent: y′ = (1 − y²) x′."""
        return self._of_slope(lambda first: first.tanh(), lambda y: 1 - y * y)

    def atan(self) -> Jet:
        """Arc tangent: y′ = x′/(1 + x²)."""
        return self._of_slope(lambda first: first.atan(), lambda y: 1 / (1 + self * self))

    def sin(self) -> Jet:
        """Sine."""
        return self._waves()[0]

    def cos(self) -> Jet:
        """Cosine."""
        return self._waves()[1]

    def _waves(self) -> tuple[Jet, Jet]:
        """Sine and cosine, each the slope of the other but for a sign."""
        cosine = Jet()
        sine = self._of_slope(lambda first: first.sin(), lambda y: cosine)
        cosine._following = self._of_slope(lambda first: first.cos(), lambda y: -sine)._following
        return sine, cosine

    def _of_slope(self, at: Callable[[Any], Any], slope: Callable[[Jet], Jet]) -> Jet:
        """A function y of this series x with y′ = s x′: k y_k = Σ i x_i s_{k−i}, 0 < i ≤ k."""
        found = Jet()
        factor = slope(found)

        def following(k: int) -> Any:
            if k == 0:
                return at(self[0])
            total = self[1] * factor[k - 1]
            for i in range(2, k + 1):
                total += i * self[i] * factor[k - i]
            return total / k

        found._following = following
        return found


def _convolved(one: Jet, other: Jet, begin: int, end: int, total: int | None = None) -> Any:
    """Σ one_i other_{total − i} for begin ≤ i ≤ end; total is end where it is left out."""
    total = end if total is None else total
    one[end], other[total - begin]  # all that are needed are there
    a, b = one.known, other.known
    found: Any = 0
    for i in range(begin, end + 1):
        found += a[i] * b[total - i]
    return found


def _quotient(numerator: Callable[[int], Any], divisor: Jet) -> Jet:
    """q₀ d₀ = n₀ and q_k d₀ = n_k − Σ q_i d_{k−i}, i < k."""
    quotient = Jet()

    def following(k: int) -> Any:
        rest = numerator(k)
        if k:
            divisor[k]
            a, b = quotient.known, divisor.known
            for i in range(k):
                rest -= a[i] * b[k - i]
        return rest / divisor[0]

    quotient._following = following
    return quotient


def _taken(value: Any) -> Any:
    from flint import arb

    return arb(value) if isinstance(value, int | float) else value


class _Methods:
    """Functions that are methods of the numbers."""

    def __getattr__(self, name: str) -> Any:
        return methodcaller(name)


class _Functions(Functions):
    @property
    def pi(self) -> Any:
        """π."""
        from flint import arb

        return arb.pi()


#: ``xp`` for python-flint's balls and series and jets of them; a number is a ball without width.
XP = _Functions(_Methods(), _taken)
