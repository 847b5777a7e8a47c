/**
 * @file @library@.c
 * @header@
 */
#include "@library@.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "@library@: -ffast-math and its parts break the error bounds and the checks for finite numbers"
#endif
#if FLT_EVAL_METHOD == 2 || FLT_EVAL_METHOD == -1
#error "@library@: doubles must be computed in double precision"
#endif
#if defined(_M_FP_FAST) || (defined(_M_IX86_FP) && _M_IX86_FP < 2)
#error "@library@: /fp:fast and /arch:IA32 break the error bounds; leave /fp:precise and /arch:SSE2 as they are"
#endif
/* One rounding an operation, so that no bit depends on where a compiler would fuse two: double-doubles rest on it. */
#if defined(__clang__) || !(defined(__GNUC__) || defined(_MSC_VER))
#pragma STDC FP_CONTRACT OFF
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#elif !defined(__STRICT_ANSI__) || defined(__cplusplus) /* where gcc fuses unless told not to */
#pragma GCC optimize("fp-contract=off")
#endif
/* What a loop calls must be part of it before it can be turned into vector instructions. */
#if defined(__GNUC__) || defined(__clang__)
#define INLINE static inline __attribute__((always_inline, unused))
#else
#define INLINE static inline
#endif

INLINE double square(double value) { return value * value; }

INLINE double sign(double value) { return (value > 0.0) ? 1.0 : ((value < 0.0) ? -1.0 : 0.0); }

INLINE double larger(double one, double other) { return (one > other) ? one : other; }

INLINE double smaller(double one, double other) { return (one < other) ? one : other; }

/* ------------------------------------------------------------------------------------ generated algebra */
// @algebra@
static int finite_all(int length, const double *values) {
    for (int i = 0; i < length; i++) {
        if (!isfinite(values[i])) {
            return 0;
        }
    }
    return 1;
}

static @library@_status deliver(int length, const double *values, double *result) {
    if (!finite_all(length, values)) {
        return @LIBRARY@_OUT_OF_RANGE;
    }
    for (int i = 0; i < length; i++) {
        result[i] = values[i];
    }
    return @LIBRARY@_OK;
}

// @primitives@
// @kernel@
// @definitions@
// @public@
