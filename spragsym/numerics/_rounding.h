/* Rounding of interval ends, the same as in interval_arrays.py; for _operations.h and _newton.h.
 *
 * The code needs IEEE 754 doubles, each + − × ÷ and √ rounded to nearest by itself, without
 * contraction. A compiler that does not promise this stops here with an error; then NumPy is used.
 *
 * An interval is stored as −low and high, so both ends are rounded upward. If r is the rounded
 * result, the exact value is below the next float after r. That is at most r + 2⁻⁵² |r| for normal
 * r; TINY is added for subnormal r. The sum is rounded to nearest, which keeps the order of
 * numbers.
 *
 * NaN is an end that is not known. minimum and maximum give NaN if either number is NaN, as those
 * of NumPy do. */
#ifndef SPRAGSYM_ROUNDING_H
#define SPRAGSYM_ROUNDING_H

#include <float.h>
#include <math.h>

#if defined(__FAST_MATH__) || FLT_EVAL_METHOD != 0
#error "intervals need IEEE 754 doubles, each operation rounded by itself"
#endif
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif

/* Functions compiled for wider registers as well: the same operations, none contracted. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__)
#define WIDER __attribute__((target_clones("avx512f", "avx2", "default")))
#define PART static inline __attribute__((always_inline))
#else
#define WIDER
#define PART static inline
#endif

#define EPS 0x1p-52
#define TINY 0x1p-1000

PART double minimum(double a, double b) {
    const double known = b < a ? b : a;
    return b != b ? b : known;
}

PART double maximum(double a, double b) {
    const double known = b > a ? b : a;
    return b != b ? b : known;
}

PART double rounded_up(double end, double ulps) { return (fabs(end) * (ulps * EPS) + TINY) + end; }

/* A float in an interval, within rounding of its middle. */
PART double midpoint(double low, double high) {
    return minimum(maximum(0.5 * high - 0.5 * low, -low), high);
}

#endif
