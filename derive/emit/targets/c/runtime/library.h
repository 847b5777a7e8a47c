/**
 * @file @library@.h
 * @summary@
 * C99, no allocation, no global state.
 *
 * @header@
 *
 * Every function returns a status, and writes results only with @LIBRARY@_OK or @LIBRARY@_UNCERTAIN: no NaN ever leaves this
 * library. For gcc, clang and MSVC, as C99 or C++11; link with -lm where there is one. No operations are fused, so that all but what
 * the C library's functions return is the same to the bit: -ffast-math, /fp:fast and x87 arithmetic are refused. What can't be seen
 * here is -ffp-contract=fast, which fuses all the same: the makefile ends its flags with -ffp-contract=off, as others should. Numbers
 * are those of IEEE 754, rounded to nearest.
 */
#ifndef @LIBRARY@_H
#define @LIBRARY@_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Head of the SHA-256 of what was emitted together. */
#define @LIBRARY@_SOURCE "@source@"

/** What became of a call. */
typedef enum {
    @LIBRARY@_OK = 0,          /**< done, and vouched for */
    @LIBRARY@_UNCERTAIN = 1,   /**< done, but the number, the kind or twelve digits can't be vouched for */
    @LIBRARY@_BAD_INPUT = 2,   /**< @bad@; no results */
    @LIBRARY@_OUT_OF_RANGE = 3 /**< allowed numbers whose result double can't carry; no results */
} @library@_status;

// @declarations@
/*
 * Algebra: each function is generated from the derivation and agrees with the Python function of that name, operation for
 * operation. Matrices are row by row. Arguments:
 *
 * @symbols@
 */
// @prototypes@
#ifdef __cplusplus
}
#endif

#endif
