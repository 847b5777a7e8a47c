"""Truncated Taylor polynomials of several variables as a number type: automatic differentiation of
generated functions, to any order.

A :class:`Jet` has the coefficients of a polynomial in the variables' small changes, up to an order.
The coefficients are numbers of any type: arrays of intervals give enclosures of derivatives over
boxes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from itertools import cycle, islice
from math import comb, factorial, prod
from typing import Any, TypeAlias

from .arithmetic import Arithmetic, Number, is_zero, repeated_product

#: Indices of the variables of a monomial, ascending: () is the constant, (0, 0, 2) is x₀² x₂.
Term: TypeAlias = tuple[int, ...]


class Jet(Arithmetic):
    """A polynomial in small changes of variables, truncated beyond ``order``.

    Examples
    --------
    >>> x, y = Jet.variable(3.0, 0, 2), Jet.variable(2.0, 1, 2)
    >>> (x * x * y).derivative(0), (x * x * y).derivative(0, 1)
    (12.0, 6.0)
    """

    __slots__ = ("like", "order", "terms")
    __array_ufunc__ = None

    #: ``like``: of a product with 0, a number of the type of its coefficients.
    def __init__(self, terms: Mapping[Term, Any], order: int, like: Any = 0) -> None:
        self.terms, self.order, self.like = dict(terms), order, like

    @classmethod
    def variable(cls, value: Number, number: int, order: int) -> Jet:
        """The variable with index ``number`` at a value."""
        return cls({(): value, (number,): 1} if order else {(): value}, order)

    @property
    def value(self) -> Any:
        """The constant term."""
        return self.terms.get((), 0)

    def derivative(self, *variables: int) -> Number:
        """The derivative by these variables; the integer 0 if there is no such term."""
        term = tuple(sorted(variables))
        coefficient = self.terms.get(term, 0)
        repeats = prod(factorial(term.count(number)) for number in set(term))
        return coefficient * repeats if repeats > 1 else coefficient

    def differentiated(self, variable: int) -> Jet:
        """The derivative by a variable, as a polynomial of one order less."""
        terms = {}
        for term, coefficient in self.terms.items():
            times = term.count(variable)
            if times:
                index = term.index(variable)
                terms[term[:index] + term[index + 1 :]] = (
                    coefficient * times if times > 1 else coefficient
                )
        return Jet(terms, self.order - 1)

    def __neg__(self) -> Jet:
        return Jet({term: -coefficient for term, coefficient in self.terms.items()}, self.order)

    def __add__(self, other: Number) -> Jet:
        if not isinstance(other, Jet):
            if is_zero(other):
                return self
            value = self.terms[()] if () in self.terms else self.like * 0
            return Jet({**self.terms, (): value + other}, self.order)
        order = min(self.order, other.order)
        terms = {term: value for term, value in self.terms.items() if len(term) <= order}
        for term, coefficient in other.terms.items():
            if len(term) <= order:
                terms[term] = terms[term] + coefficient if term in terms else coefficient
        return Jet(terms, order)

    def __mul__(self, other: Number) -> Jet:
        if other is self:
            return self**2
        if not isinstance(other, Jet):
            if is_zero(other):
                return Jet({}, self.order, self.value)
            terms = {term: coefficient * other for term, coefficient in self.terms.items()}
            return Jet(terms, self.order)
        order, terms = min(self.order, other.order), {}
        for one, a in self.terms.items():
            for two, b in other.terms.items():
                if len(one) + len(two) <= order:
                    term = tuple(sorted(one + two))
                    terms[term] = terms[term] + a * b if term in terms else a * b
        return Jet(terms, order)

    def __truediv__(self, other: Number) -> Jet:
        if isinstance(other, Jet):
            return self.__mul__(other.reciprocal())
        terms = {term: _quotient(a, other, self.value) for term, a in self.terms.items()}
        return Jet(terms, self.order)

    def __rtruediv__(self, other: Number) -> Jet:
        return self.reciprocal().__mul__(other)

    def __pow__(self, power: int) -> Jet:
        if power < 0:
            return self.__pow__(-power).reciprocal()
        a = self.value
        return self.composed(
            [comb(power, k) * _power(a, power - k) for k in range(min(power, self.order) + 1)]
        )

    def composed(self, coefficients: Sequence[Any]) -> Jet:
        """A function of this polynomial, by its Taylor coefficients at the constant term: Σ
        coefficients[k] hᵏ, with the non-constant part h.
        """
        varying = change(self, self.order)
        result, power = Jet({(): coefficients[0]}, self.order), None
        for coefficient in coefficients[1:]:
            power = varying if power is None else _times(power, varying)
            result = result + power * coefficient
        return result

    def reciprocal(self) -> Jet:
        """1 / x."""
        inverse = 1 / self.value
        return self.composed([inverse ** (k + 1) * (-1) ** k for k in range(self.order + 1)])

    def sign(self) -> Jet:
        """−1, 0 or 1; its derivative is NaN if an interval contains 0."""
        return self.composed([self.value.sign(), *[self._flat()] * self.order])

    def __abs__(self) -> Jet:
        return self.composed(
            [abs(self.value), self.value.sign(), *[self._flat()] * (self.order - 1)]
        )

    def _flat(self) -> Any:
        """0, or unbounded if the value may be 0."""
        # Without abs, an interval that ends at 0 would keep one bound.
        return abs(1 / self.value * 0)

    def function(self, name: str, value: object) -> Jet:
        """The function ``name`` of this polynomial; ``value`` is that of the constant term, for
        "cos" and "sin" the pair of both.
        """
        return self.composed(_SERIES[name](self.value, value, self.order))


def _quotient(a: Any, by: Any, kind: object) -> Any:
    """a/by, of integers as a number of a ``kind``: a float of 43/10 is not enclosed."""
    inexact = isinstance(a, int) and isinstance(by, int) and a % by
    return (kind * 0 + a if inexact and isinstance(kind, Arithmetic) else a) / by


def _sqrt(_: object, y: Number, order: int) -> list[Any]:
    factors = binomial_series(Fraction(1, 2), order)[1:]
    return [y, *(factor / y ** (2 * k - 1) for k, factor in enumerate(factors, 1))]


def _log(x: Any, y: object, order: int) -> list[Any]:
    inverse = 1 / x
    return [
        y,
        *(inverse**k * (-1) ** (k - 1) / k if k > 1 else inverse for k in range(1, order + 1)),
    ]


def _tanh(_: object, value: Number, order: int) -> list[Any]:
    """From y′ = 1 − y²."""
    y = [value]
    for k in range(order):
        # A square of its own is narrower than a product.
        middle = y[k // 2] ** 2 if k % 2 == 0 else 0
        square = sum((y[i] * y[k - i] * 2 for i in range((k + 1) // 2)), middle)
        y.append((-square if k else 1 - square) / (k + 1))
    return y


def _atan(x: Number, y: Number, order: int) -> list[Any]:
    """From (1 + x²) y′ = 1."""
    inverse = 1 / (1 + x**2)
    slope: list[Any] = []
    for k in range(order):
        slope.append(
            inverse if not k else -(x * slope[k - 1] * 2 + (slope[k - 2] if k > 1 else 0)) * inverse
        )
    return [y, *(term / k if k > 1 else term for k, term in enumerate(slope, 1))]


def _repeated(repeating: Sequence[Any], order: int) -> list[Any]:
    """Taylor coefficients from periodically repeating derivatives, as of exp, cos and sin."""
    derivatives = islice(cycle(repeating), order + 1)
    return [value / factorial(k) if k > 1 else value for k, value in enumerate(derivatives)]


#: Taylor coefficients of a function, from its argument, its value there, and the order.
_SERIES: dict[str, Callable[[Any, Any, int], list[Any]]] = {
    "sqrt": _sqrt,
    "log": _log,
    "tanh": _tanh,
    "atan": _atan,
    "exp": lambda _, y, order: _repeated([y], order),
    "cos": lambda _, wave, order: _repeated([wave[0], -wave[1], -wave[0], wave[1]], order),
    "sin": lambda _, wave, order: _repeated([wave[1], wave[0], -wave[1], -wave[0]], order),
}


class Functions:
    """Namespace ``xp`` of generated functions, for numbers of a type and jets of these.

    ``kind`` is a module with the functions of the numbers; ``taken`` converts an int or float to
    one.
    """

    def __init__(self, kind: Any, taken: Callable[[Any], Any]) -> None:
        self.kind, self.taken = kind, taken

    def __getattr__(self, name: str) -> Callable[[Any], Any]:
        if name not in _SERIES:
            raise AttributeError(name)
        return lambda value: self.of(name, value)

    def of(self, name: str, value: Number) -> Any:
        """The function ``name`` of a number or jet."""
        if not isinstance(value, Jet):
            return getattr(self.kind, name)(self.taken(value))
        at = value.value
        return value.function(
            name, (self.cos(at), self.sin(at)) if name in ("cos", "sin") else self.of(name, at)
        )

    def sign(self, value: Number) -> Number:
        """−1, 0, 1."""
        return (value if isinstance(value, Jet) else self.taken(value)).sign()

    def atan2(self, sine: Number, cosine: Number) -> Number:
        """Angle of the vector (cosine, sine), in [−π, π]."""
        if isinstance(sine, Jet) or isinstance(cosine, Jet):
            return argument(*rotation(sine, cosine)) + self.atan2(constant(sine), constant(cosine))
        return self.kind.atan2(self.taken(sine), self.taken(cosine))


def argument(u: Jet, v: Jet) -> Jet:
    """The angle of 1 + z, z = u + i v, for u and v without constant terms: Im log(1 + z) = Im(z −
    z²/2 + …).
    """
    one, other = u, v
    total = v
    for power in range(2, max(u.order, v.order) + 1):
        one, other = _times(one, u) - _times(other, v), _times(one, v) + _times(other, u)
        total = total + other / (power if power % 2 else -power)
    return total


def order_of(*parts: Any) -> int:
    """The highest order of the jets among numbers, 0 without jets."""
    return max((part.order for part in parts if isinstance(part, Jet)), default=0)


def rotation(sine: Number, cosine: Number) -> tuple[Jet, Jet]:
    """(u, v) such that the vector cosine + i sine, of any length, is its value times 1 + u + i
    v.
    """
    c, s = constant(cosine), constant(sine)
    return change_along(cosine, sine, c, s, c * c + s * s)


def change_along(dx: Number, dy: Number, c: Number, s: Number, size: Number) -> tuple[Jet, Jet]:
    """Components of the change of a vector (dx, dy) along (c, s) and across it, over ``size``."""
    hx, hy = (change(part, order_of(dx, dy)) for part in (dx, dy))
    return (hx * c + hy * s) / size, (hy * c - hx * s) / size


def change(value: Number, order: int) -> Jet:
    """The non-constant part of a number or jet."""
    terms = value.terms if isinstance(value, Jet) else {}
    return Jet({term: coefficient for term, coefficient in terms.items() if term}, order)


@cache
def binomial_series(exponent: Fraction, order: int) -> tuple[float, ...]:
    """Coefficients of (1 + h)^exponent up to an order; exact for half-integer exponents."""
    series = [Fraction(1)]
    for k in range(order):
        series.append(series[-1] * (exponent - k) / (k + 1))
    return tuple(map(float, series))


def variables(values: Sequence[Any], order: int) -> list[Jet]:
    """Values as jets of independent variables with indices 0, 1, …."""
    return [Jet.variable(value, number, order) for number, value in enumerate(values)]


def gradient(value: Number, count: int) -> list[Any]:
    """First derivatives of a jet or constant by the variables 0 to count − 1."""
    return [value.derivative(number) if isinstance(value, Jet) else 0 for number in range(count)]


def is_linear(value: Jet) -> bool:
    """True if a jet has no terms of second or higher order."""
    return all(len(term) < 2 or is_zero(part) for term, part in value.terms.items())


def constant(value: Number) -> Any:
    """The constant term of a jet; a number itself."""
    return value.value if isinstance(value, Jet) else value


def _times(one: Jet, other: Jet) -> Jet:
    """The product, computed as such even of a jet with itself."""
    return one * Jet(other.terms, other.order)


def _power(value: Number, power: int) -> Number:
    """A power; of python-flint's balls by products, since its own is NaN if a ball contains 0."""
    if power and type(value).__module__.startswith("flint"):
        return repeated_product(value, power)
    return value**power
