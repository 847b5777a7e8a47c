"""Functions of an angle in double precision, with the same bits on every machine: those of the
languages' libraries differ.

In the small language of :mod:`.language`, emitted with a kernel that needs them.
"""

from typing import NamedTuple

from .language import Real, absolute, where


class Direction(NamedTuple):
    """Cosine and sine of an angle."""

    cosine: Real
    sine: Real


def cosine_and_sine(x: Real) -> Direction:
    """cos x and sin x for 0 < x < π in double precision, within one unit in the last place.

    x = k π/2 + (r + tail) with r at most π/4, by π/2 in two parts, of which the first leaves
    nothing to round; then the polynomials of fdlibm's k_sin.c and k_cos.c.
    """
    k = where(x > 0.7853981633974483, 1.0, 0.0) + where(x > 2.356194490192345, 1.0, 0.0)
    near = x - k * 1.5707963267948966
    rest = k * 6.123233995736766e-17
    r = near - rest
    tail = (near - r) - rest
    z = r * r
    odd4 = -2.50507602534068634195e-08 + z * 1.58969099521155010221e-10
    odd = 8.33333333332248946124e-03 + z * (
        -1.98412698298579493134e-04 + z * (2.75573137070700676789e-06 + z * odd4)
    )
    s = r - ((z * (0.5 * tail - z * r * odd) - tail) - z * r * -1.66666666666666324348e-01)
    even4 = -2.75573143513906633035e-07 + z * (
        2.08757232129817482790e-09 + z * -1.13596475577881948265e-11
    )
    even = 4.16666666666666019037e-02 + z * (
        -1.38888888888741095749e-03 + z * (2.48015872894767294178e-05 + z * even4)
    )
    half = 0.5 * z
    top = 1.0 - half
    c = top + (((1.0 - top) - half) + (z * z * even - r * tail))
    sine = where(k == 1.0, c, where(k > 1.0, -s, s))
    cosine = where(k == 1.0, -s, where(k > 1.0, -c, c))
    return Direction(cosine, sine)


def arctangent(t: Real) -> Real:
    """atan t in double precision, within one unit in the last place.

    By atan t = atan c + atan((t − c)/(1 + c t)) with c one of 0, 1/2, 1, 3/2 and infinity, whose
    arc tangents stand in two parts; then the polynomial of fdlibm's s_atan.c.
    """
    size = absolute(t)
    first = size < 0.4375
    second = size < 0.6875
    third = size < 1.1875
    fourth = size < 2.4375
    beyond = where(fourth, size - 1.5, -1.0) / where(fourth, 1.0 + 1.5 * size, size)
    about_one = where(second, 2.0 * size - 1.0, size - 1.0) / where(second, 2.0 + size, size + 1.0)
    x = where(first, size, where(third, about_one, beyond))
    high = where(
        third,
        where(second, 4.63647609000806093515e-01, 7.85398163397448278999e-01),
        where(fourth, 9.82793723247329054082e-01, 1.57079632679489655800e00),
    )
    low = where(
        third,
        where(second, 2.26987774529616870924e-17, 3.06161699786838301793e-17),
        where(fourth, 1.39033110312309984516e-17, 6.12323399573676603587e-17),
    )
    z = x * x
    w = z * z
    even = 6.66107313738753120669e-02 + w * (
        4.97687799461593236017e-02 + w * 1.62858201153657823623e-02
    )
    even = 3.33333333333329318027e-01 + w * (
        1.42857142725034663711e-01 + w * (9.09088713343650656196e-02 + w * even)
    )
    odd = -5.83357013379057348645e-02 + w * -3.65315727442169155270e-02
    odd = -1.99999999998764832476e-01 + w * (
        -1.11111104054623557880e-01 + w * (-7.69187620504482999495e-02 + w * odd)
    )
    rest = x * (z * even + w * odd)
    result = where(first, x - rest, high - ((rest - low) - x))
    return where(t < 0.0, -result, result)
