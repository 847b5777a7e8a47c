"""Double-double arithmetic, written once for every target language: a number as the exact sum of
two doubles.

:mod:`.language` reads the functions below and each target prints them, as it does a kernel.

Additions, products and quotients of doubles are each rounded once to nearest, and none is fused
with another: the results have the same bits on every machine. Where nothing overflows or
underflows, ``two_sum``, ``fast_two_sum`` and ``two_product`` are exact, and relative errors are at
most, in units of 2^-106 and but for terms of 2^-159: 3 for ``dd_add``, 7 for ``dd_multiply``, 2 for
either with one double, 15 for ``dd_divide``. A number is at most 2^996, so that it can be split.

Sources: M. Joldes, J.-M. Muller, V. Popescu, Tight and rigorous error bounds for basic building
blocks of double-word arithmetic, ACM Trans. Math. Softw. 44 (2017) 15res: algorithms 4, 6, 7, 10
and 17; T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math.
18 (1971) 224, for the exact product.
"""

from typing import NamedTuple

from .language import Flag, Real, absolute, sqrt, where


class Wide(NamedTuple):
    """A double-double: high + low, with high nearest to the sum."""

    high: Real
    low: Real


class SplitDirection(NamedTuple):
    """Cosine and sine of an angle, each in two parts."""

    cosine_high: Real
    cosine_low: Real
    sine_high: Real
    sine_low: Real


# -----------------------------------------------------------------------------------------------
# exact transformations


def paired(high: Real, low: Real) -> Wide:
    """The number of which both parts are known."""
    return Wide(high, low)


def two_sum(a: Real, b: Real) -> Wide:
    """a + b, exactly (Knuth)."""
    s = a + b
    of_b = s - a
    of_a = s - of_b
    return Wide(s, (a - of_a) + (b - of_b))


def fast_two_sum(a: Real, b: Real) -> Wide:
    """a + b, exactly where |a| ≥ |b| or a = 0 (Dekker)."""
    s = a + b
    return Wide(s, b - (s - a))


def two_product(a: Real, b: Real) -> Wide:
    """a b, exactly (Dekker, Veltkamp)."""
    # 2^27 + 1 splits a double into two halves of 26 bits.
    splitter = 134217729.0
    p = a * b
    big_a = splitter * a
    high_a = big_a - (big_a - a)
    low_a = a - high_a
    big_b = splitter * b
    high_b = big_b - (big_b - b)
    low_b = b - high_b
    return Wide(p, ((high_a * high_b - p) + high_a * low_b + low_a * high_b) + low_a * low_b)


# ------------------------------------------------------------------------------------------------
# arithmetic


def dd_negative(x: Wide) -> Wide:
    """−x, exactly."""
    return Wide(-x.high, -x.low)


def dd_absolute(x: Wide) -> Wide:
    """|x|, exactly."""
    return Wide(absolute(x.high), where(x.high < 0.0, -x.low, x.low))


def dd_leading(x: Wide) -> Real:
    """The double nearest to x."""
    return x.high


def dd_scaled(x: Wide, power: Real) -> Wide:
    """x times a power of two, exactly."""
    return Wide(x.high * power, x.low * power)


def dd_less(x: Wide, y: Wide) -> Flag:
    """Whether x < y, by the sign of the difference: low parts decide only where high ones are the
    same or next to each other.
    """
    return (x.high - y.high) + (x.low - y.low) < 0.0


def dd_where(chosen: Flag, x: Wide, y: Wide) -> Wide:
    """x where the flag is set, y elsewhere."""
    return Wide(where(chosen, x.high, y.high), where(chosen, x.low, y.low))


def dd_larger(x: Wide, y: Wide) -> Wide:
    """The larger of two."""
    return dd_where(dd_less(y, x), x, y)


def dd_smaller(x: Wide, y: Wide) -> Wide:
    """The smaller of two."""
    return dd_where(dd_less(x, y), x, y)


def dd_add(x: Wide, y: Wide) -> Wide:
    """x + y (algorithm 6)."""
    s = two_sum(x.high, y.high)
    t = two_sum(x.low, y.low)
    v = fast_two_sum(s.high, s.low + t.high)
    return fast_two_sum(v.high, t.low + v.low)


def dd_add_double(x: Wide, y: Real) -> Wide:
    """x + y with a double y (algorithm 4)."""
    s = two_sum(x.high, y)
    return fast_two_sum(s.high, x.low + s.low)


def dd_multiply(x: Wide, y: Wide) -> Wide:
    """x y (algorithm 10)."""
    c = two_product(x.high, y.high)
    crossed = x.high * y.low + x.low * y.high
    return fast_two_sum(c.high, c.low + crossed)


def dd_multiply_double(x: Wide, y: Real) -> Wide:
    """x y with a double y (algorithm 7)."""
    c = two_product(x.high, y)
    v = fast_two_sum(c.high, x.low * y)
    return fast_two_sum(v.high, v.low + c.low)


def dd_divide(x: Wide, y: Wide) -> Wide:
    """x / y (algorithm 17)."""
    t = x.high / y.high
    r = dd_multiply_double(y, t)
    rest = (x.high - r.high) + (x.low - r.low)
    return fast_two_sum(t, rest / y.high)


def dd_sqrt(x: Wide) -> Wide:
    """√x for x ≥ 0, to some units of 2^-106: a double root with one step of Newton's method."""
    root = sqrt(x.high)
    root_squared = two_product(root, root)
    rest = ((x.high - root_squared.high) - root_squared.low) + x.low
    return fast_two_sum(root, where(root > 0.0, rest / (2.0 * root), 0.0))


# ------------------------------------------------------------------------------------------------
# cosine and sine


def dd_cosine_and_sine(x: Real) -> SplitDirection:
    """cos x and sin x of a double 0 < x < π, within 2^-101 of themselves.

    x = k π/2 + r with |r| ≤ π/4 by π/2 in three parts, of which the first leaves nothing to round;
    then Taylor's series, whose terms from the tenth on need a double only.
    """
    k = where(x > 0.7853981633974483, 1.0, 0.0) + where(x > 2.356194490192345, 1.0, 0.0)
    near = x - k * 1.5707963267948966
    r = dd_add_double(two_sum(near, -k * 6.123233995736766e-17), k * 1.4973849048591698e-33)
    z = dd_multiply(r, r)
    odd = -9.183689863795546e-29
    odd = 6.446950284384474e-26 + z.high * odd
    odd = -3.868170170630684e-23 + z.high * odd
    odd = 1.9572941063391263e-20 + z.high * odd
    odd = -8.22063524662433e-18 + z.high * odd
    s = paired(odd, 0.0)
    s = dd_add(dd_multiply(z, s), paired(2.8114572543455206e-15, 1.6508842730861433e-31))
    s = dd_add(dd_multiply(z, s), paired(-7.647163731819816e-13, -7.03872877733453e-30))
    s = dd_add(dd_multiply(z, s), paired(1.6059043836821613e-10, 1.2585294588752098e-26))
    s = dd_add(dd_multiply(z, s), paired(-2.505210838544172e-08, 1.448814070935912e-24))
    s = dd_add(dd_multiply(z, s), paired(2.7557319223985893e-06, -1.858393274046472e-22))
    s = dd_add(dd_multiply(z, s), paired(-0.0001984126984126984, -1.7209558293420705e-22))
    s = dd_add(dd_multiply(z, s), paired(0.008333333333333333, 1.1564823173178714e-19))
    s = dd_add(dd_multiply(z, s), paired(-0.16666666666666666, -9.25185853854297e-18))
    s = dd_multiply(r, dd_add_double(dd_multiply(z, s), 1.0))
    even = -2.4795962632247976e-27
    even = 1.6117375710961184e-24 + z.high * even
    even = -8.896791392450574e-22 + z.high * even
    even = 4.110317623312165e-19 + z.high * even
    even = -1.5619206968586225e-16 + z.high * even
    c = paired(even, 0.0)
    c = dd_add(dd_multiply(z, c), paired(4.779477332387385e-14, 4.399205485834081e-31))
    c = dd_add(dd_multiply(z, c), paired(-1.1470745597729725e-11, -2.0655512752830745e-28))
    c = dd_add(dd_multiply(z, c), paired(2.08767569878681e-09, -1.20734505911326e-25))
    c = dd_add(dd_multiply(z, c), paired(-2.755731922398589e-07, -2.3767714622250297e-23))
    c = dd_add(dd_multiply(z, c), paired(2.48015873015873e-05, 2.1511947866775882e-23))
    c = dd_add(dd_multiply(z, c), paired(-0.001388888888888889, 5.300543954373577e-20))
    c = dd_add(dd_multiply(z, c), paired(0.041666666666666664, 2.3129646346357427e-18))
    c = dd_add(dd_multiply(z, c), paired(-0.5, 0.0))
    c = dd_add_double(dd_multiply(z, c), 1.0)
    sine = dd_where(k == 1.0, c, dd_where(k > 1.0, dd_negative(s), s))
    cosine = dd_where(k == 1.0, dd_negative(s), dd_where(k > 1.0, dd_negative(c), c))
    return SplitDirection(cosine.high, cosine.low, sine.high, sine.low)
