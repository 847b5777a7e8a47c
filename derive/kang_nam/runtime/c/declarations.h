/* Angles are radians; lengths, times and forces are dimensionless: text after (9) of the article. */

/** Most equilibria there can be: roots of a quartic. At steady sliding in contact there are 1 or 3. */
#define SPRAGSYM_MAX_EQUILIBRIA 4

/** Lift-off or contact: the n-bar of eq. (29). */
typedef enum {
    SPRAGSYM_LIFTOFF = 0,
    SPRAGSYM_CONTACT = 1
} spragsym_regime;

/** Stability of an equilibrium: eq. (27). */
typedef enum {
    SPRAGSYM_NONE = 0,      /**< no equilibrium */
    SPRAGSYM_STABLE = 1,    /**< both squared frequencies real and positive */
    SPRAGSYM_DIVERGENT = 2, /**< a squared frequency is negative */
    SPRAGSYM_FLUTTER = 3    /**< the squared frequencies are complex */
} spragsym_stability;

/** Dimensionless parameters. */
typedef struct {
    double theta0; /**< @meaning:theta0@, @range:theta0@ */
    double mu0;    /**< @meaning:mu0@, @range:mu0@ */
    double kappa;  /**< @meaning:kappa@, @range:kappa@ */
    double alpha;  /**< @meaning:alpha@, @range:alpha@ */
    double sigma;  /**< @meaning:sigma@, @range:sigma@ */
    double beta;   /**< @meaning:beta@, @range:beta@ */
} spragsym_parameters;

/** Parameters that were checked, with the cosine and sine of theta0. Made by spragsym_prepare. */
typedef struct {
    double cos0, sin0, mu0, kappa, alpha, sigma, beta, theta0;
} spragsym_model;

/** One equilibrium. */
typedef struct {
    double theta; /**< @meaning:theta@, in (-pi, pi) */
    double L;     /**< @meaning:L@ */
    double x;     /**< @meaning:x@ */
    double y;     /**< @meaning:y@ */
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
 * Works in blocks of @constant:BLOCK@ points, with 50 kB on the stack. A point takes 192 bytes of results: calls of some thousand points
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
    spragsym_equilibrium equilibria[][SPRAGSYM_MAX_EQUILIBRIA], int counts[], spragsym_status statuses[]);

/**
 * One step of fixed length of the motion (8)-(11) by the classical Runge-Kutta method, of fourth order across the kinks.
 *
 * The vector field is kinked where y = 0 and where x' = V. A step that ends on the other side of a kink is cut there, at
 * most twice, and goes on in the new regime; the place of the cut is good enough to keep the fourth order. Not seen: a kink
 * that is crossed and crossed back within one step, and a third kink in one step; each costs an error of order h^3.
 *
 * @param V      @meaning:V@
 * @param d      @meaning:d@: eq. (10), @range:d@
 * @param h      length of the step in dimensionless time, > 0
 * @param state  x, y, x', y'; left as it was unless SPRAGSYM_OK is returned.
 * @return SPRAGSYM_OK; SPRAGSYM_BAD_INPUT; SPRAGSYM_OUT_OF_RANGE if the state blows up (h too long, or L = 0).
 * Worst case: @cost:spragsym_step@.
 */
spragsym_status spragsym_step(const spragsym_model *model, double V, double d, double h, double state[4]);

/** Where the reference state ends first: on the curve of folds in the plane of theta0 and mu0. */
typedef enum {
    SPRAGSYM_NO_FOLD = 0, /**< no fold ends the reference state */
    SPRAGSYM_CUSP = 1,    /**< at a cusp */
    SPRAGSYM_TURN = 2,    /**< where the curve turns back in mu0 */
    SPRAGSYM_END = 3      /**< as theta0 goes to 0 */
} spragsym_fold_kind;

/** The least friction at which the reference state ends. */
typedef struct {
    double mu0;    /**< its friction; HUGE_VAL if no fold ends that state */
    double theta0; /**< its inclination; 0 if none does */
    spragsym_fold_kind kind;
} spragsym_critical_load;

/**
 * The critical friction: that below which the reference state, followed from mu0 = 0, jumps at no inclination.
 *
 * Cusps and points where the curve of folds turns back are roots of polynomials in sin theta, searched in double precision between the
 * roots of their derivatives. Unlike the equilibria this is not proved: SPRAGSYM_OK says that rounding, as estimated, can't have hidden
 * a root; the Python package proves.
 *
 * SPRAGSYM_UNCERTAIN: where it may have, as for alpha near 1 + beta, where roots lie close together, or for alpha that all but vanishes.
 *
 * @param parameters  theta0 and mu0 are not used.
 * Worst case: @cost:spragsym_critical_friction@.
 */
spragsym_status spragsym_critical_friction(const spragsym_parameters *parameters, spragsym_critical_load *lowest);
