/* Ends of intervals in doubles, for _operations.h and _newton.h, and as interval_arrays.py has them.
 *
 * Rounding. IEEE 754 doubles, rounded to nearest, + − × ÷ and √ without contraction: a build that promises less is refused here, and
 * NumPy serves. An end is −low or high, so that both are rounded upward: the exact value lies below the float after r, which is at
 * most r + 2⁻⁵² |r| for normal r, and TINY is added for others; the sum is rounded to nearest, and rounding keeps the order of
 * numbers. NaN bounds nothing: minimum and maximum give NaN where either number is NaN, as NumPy's minimum and maximum do. */
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

/* For processors with wider registers too: the same operations, none contracted. */
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

PART double rounded_up(double end, double ulps) {
    return (fabs(end) * (ulps * EPS) + TINY) + end;
}

/* A float inside of an interval, the nearest to its middle or next to it. */
PART double midpoint(double low, double high) {
    return minimum(maximum(0.5 * high - 0.5 * low, -low), high);
}

#endif
