/**
 * @file spragsym.h
 * Equilibria, stability and motion of the sprag-slip oscillator, for real-time use. C99, no allocation, no global state.
 *
 * @header@
 *
 * Angles are radians; lengths, times and forces are dimensionless: text after (9) of the article. Every function returns a
 * status, and writes results only with SPRAGSYM_OK or SPRAGSYM_UNCERTAIN: no NaN ever leaves this library.
 * Compile with -std=c99 or -ffp-contract=off, and link with -lm. Do not compile with -ffast-math or a part of it: the error
 * bounds rest on IEEE 754, with rounding to nearest and gradual underflow, as every program starts with.
 */
#ifndef SPRAGSYM_H
#define SPRAGSYM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The derivation that this was generated from: the head of a hash of its sources. */
#define SPRAGSYM_SOURCE "@source@"

/** Most equilibria there can be: roots of a quartic. At steady sliding in contact there are 1 or 3. */
#define SPRAGSYM_MAX_EQUILIBRIA 4

/** What became of a call. */
typedef enum {
    SPRAGSYM_OK = 0,           /**< done, and vouched for */
    SPRAGSYM_UNCERTAIN = 1,    /**< done, but the number, the kind or twelve digits can't be vouched for */
    SPRAGSYM_BAD_INPUT = 2,    /**< a null pointer, a NaN, an infinity or a parameter out of its range; no results */
    SPRAGSYM_OUT_OF_RANGE = 3  /**< allowed numbers whose result double can't carry; no results */
} spragsym_status;

/** Lift-off or contact: the n-bar of eq. (29). */
typedef enum { SPRAGSYM_LIFTOFF = 0, SPRAGSYM_CONTACT = 1 } spragsym_regime;

/** Stability of an equilibrium: eq. (27). */
typedef enum {
    SPRAGSYM_NONE = 0,      /**< no equilibrium */
    SPRAGSYM_STABLE = 1,    /**< both squared frequencies real and positive */
    SPRAGSYM_DIVERGENT = 2, /**< a squared frequency is negative */
    SPRAGSYM_FLUTTER = 3    /**< the squared frequencies are complex */
} spragsym_stability;

/** Dimensionless parameters. */
typedef struct {
    double theta0; /**< inclination of the undeformed spring, in (0, pi) */
    double mu0;    /**< friction coefficient at full slip, >= 0 */
    double kappa;  /**< preload F_L / (k_c L_0), > 0 */
    double alpha;  /**< stiffness ratio k_x / k_c, >= 0 */
    double sigma;  /**< stiffness ratio k / k_c, > 0 */
    double beta;   /**< stiffness ratio k_y / k_c, >= 0 */
} spragsym_parameters;

/** Parameters that were checked, with the cosine and sine of theta0. Made by spragsym_prepare. */
typedef struct {
    double cos0;
    double sin0;
    double mu0;
    double kappa;
    double alpha;
    double sigma;
    double beta;
    double theta0;
} spragsym_model;

/** One equilibrium. */
typedef struct {
    double theta; /**< inclination of the spring, in (-pi, pi) */
    double L;     /**< length of the spring */
    double x;     /**< displacement along the belt */
    double y;     /**< displacement across the belt, negative into it */
    double error; /**< bound on |error| of theta, L, x and y, each over max(1, |exact value|); HUGE_VAL if none is known */
    spragsym_stability stability;
} spragsym_equilibrium;

/**
 * Check parameters once, before any number of calls.
 * @return SPRAGSYM_OK or SPRAGSYM_BAD_INPUT.
 * Worst case: @cost:spragsym_prepare@.
 */
spragsym_status spragsym_prepare(const spragsym_parameters *parameters, spragsym_model *model);

/**
 * All equilibria of one regime with their stability, by ascending theta: roots of eq. (12), (13) with eq. (22)-(25).
 *
 * What double precision leaves open is decided in double-double arithmetic, of 106 bits.
 *
 * SPRAGSYM_UNCERTAIN: where these do not decide either, on a fold or on the onset of flutter to the last digits, or where
 * parameters are not 0 and beyond 1e-50 to 1e50. The best guess is written, which may be none at all; decide with a margin in the parameters, or with the Python
 * package's ladder.
 *
 * @param regime       SPRAGSYM_CONTACT: those with L > 0 and y < 0; SPRAGSYM_LIFTOFF: those with L > 0 and y >= 0.
 * @param equilibria   the first *count are written, the others cleared.
 * Worst case: @cost:spragsym_equilibria@.
 */
spragsym_status spragsym_equilibria(const spragsym_model *model, spragsym_regime regime,
                                    spragsym_equilibrium equilibria[SPRAGSYM_MAX_EQUILIBRIA], int *count);

/**
 * spragsym_equilibria at many points: the same bits, several times as fast where the compiler makes vector instructions.
 *
 * gcc and clang do with -O3 -march=native -fno-math-errno -fno-trapping-math, of which none changes a result under -std=c99.
 * Works in blocks of @block@ points, with 50 kB on the stack. A point takes 192 bytes of results: calls of some thousand points
 * stay in the processor's cache. Calls from several threads on different arrays do not disturb each other.
 *
 * @param points      how many; with 0, pointers may be null
 * @param given       their parameters, checked here
 * @param equilibria  of each point the first counts[i] are written, the others cleared
 * @param counts      of each point; 0 where its status is SPRAGSYM_BAD_INPUT or SPRAGSYM_OUT_OF_RANGE
 * @param statuses    of each point, as spragsym_prepare and spragsym_equilibria would return
 * @return the largest of the statuses, so that SPRAGSYM_UNCERTAIN is nothing unusual; SPRAGSYM_BAD_INPUT with nothing written
 *         for a null pointer or no such regime.
 * Worst case, for each block or part of one: @cost:spragsym_equilibria_batch@.
 */
spragsym_status spragsym_equilibria_batch(size_t points, const spragsym_parameters given[], spragsym_regime regime,
                                          spragsym_equilibrium equilibria[][SPRAGSYM_MAX_EQUILIBRIA], int counts[],
                                          spragsym_status statuses[]);

/**
 * One step of fixed length of the motion (8)-(11) by the classical Runge-Kutta method, of fourth order across the kinks.
 *
 * The vector field is kinked where y = 0 and where x' = V. A step that ends on the other side of a kink is cut there, at
 * most twice, and goes on in the new regime; the place of the cut is good enough to keep the fourth order. Not seen: a kink
 * that is crossed and crossed back within one step, and a third kink in one step; each costs an error of order h^3.
 *
 * @param V      belt speed
 * @param d      steepness of the friction law (10) in creep, > 0
 * @param h      length of the step in dimensionless time, > 0
 * @param state  x, y, x', y'; left as it was unless SPRAGSYM_OK is returned.
 * @return SPRAGSYM_OK; SPRAGSYM_BAD_INPUT; SPRAGSYM_OUT_OF_RANGE if the state blows up (h too long, or L = 0).
 * Worst case: @cost:spragsym_step@.
 */
spragsym_status spragsym_step(const spragsym_model *model, double V, double d, double h, double state[4]);

/*
 * The algebra that the above stands on. Each is generated from the derivation and agrees with the function of that name in
 * the Python package `spragsym.generated`, operation for operation. Matrices are row by row.
 */
/* @prototypes@ */
#ifdef __cplusplus
}
#endif

#endif
