# ruff: noqa: E501  # C is 124 wide
"""The hand-written part of the C target: types, and algorithms that hold no formula of the model.

``@cost:name@`` is replaced by the counted worst case of the function ``name``, ``@...@`` by generated text.
The text keeps to what :mod:`.c99_cost` can count: loops with constant bounds, one function a definition.
"""

HEADER = r"""/**
 * @file spragsym.h
 * Equilibria, stability and motion of the sprag-slip oscillator, for real-time use. C99, no allocation, no global state.
 *
 * @header@
 *
 * Angles are radians; lengths, times and forces are dimensionless: text after (9) of the article. Every function returns a
 * status, and writes its results only with SPRAGSYM_OK or SPRAGSYM_UNCERTAIN: no NaN ever leaves this library.
 * Link with -lm. Do not compile with -ffast-math: the error bounds rest on IEEE 754.
 */
#ifndef SPRAGSYM_H
#define SPRAGSYM_H

#ifdef __cplusplus
extern "C" {
#endif

/** Most equilibria there can be: roots of a quartic. At steady sliding in contact there are 1 or 3. */
#define SPRAGSYM_MAX_EQUILIBRIA 4

/** What became of a call. */
typedef enum {
    SPRAGSYM_OK = 0,           /**< done, and vouched for */
    SPRAGSYM_UNCERTAIN = 1,    /**< done, but in double precision the number, the kind or twelve digits can't be vouched for */
    SPRAGSYM_BAD_INPUT = 2,    /**< a null pointer, a NaN, an infinity or a parameter out of its range; nothing written */
    SPRAGSYM_OUT_OF_RANGE = 3  /**< allowed numbers whose result double can't carry; nothing written */
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
} spragsym_model;

/** One equilibrium. */
typedef struct {
    double theta; /**< inclination of the spring, in (-pi, pi) */
    double L;     /**< length of the spring */
    double x;     /**< displacement along the belt */
    double y;     /**< displacement across the belt, negative into it */
    double error; /**< bound on |error| of theta, L, x and y, each over max(1, |value|); HUGE_VAL if none is known */
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
 * SPRAGSYM_UNCERTAIN: close to a fold, to the edge of contact or to the onset of flutter, or far from the scale of the
 * article. The best guess is written; decide with a margin in the parameters, or with the Python package's ladder.
 *
 * @param regime       SPRAGSYM_CONTACT: those with L > 0 and y < 0; SPRAGSYM_LIFTOFF: those with L > 0 and y >= 0.
 * @param equilibria   the first *count are written, the others cleared.
 * Worst case: @cost:spragsym_equilibria@.
 */
spragsym_status spragsym_equilibria(const spragsym_model *model, spragsym_regime regime,
                                    spragsym_equilibrium equilibria[SPRAGSYM_MAX_EQUILIBRIA], int *count);

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
@prototypes@
#ifdef __cplusplus
}
#endif

#endif
"""

SOURCE_HEAD = r"""/**
 * @file spragsym.c
 * @header@
 *
 * Worst-case operations, counted in this text: + - * / and comparisons of doubles, then calls of libm.
@table@
 */
#include "spragsym.h"

#include <float.h>
#include <math.h>

#ifdef __FAST_MATH__
#error "spragsym: -ffast-math breaks the error bounds and the checks for finite numbers"
#endif

static inline double square(double value) { return value * value; }

static inline double sign(double value) { return (value > 0.0) ? 1.0 : ((value < 0.0) ? -1.0 : 0.0); }

static inline double larger(double one, double other) { return (one > other) ? one : other; }

/* ------------------------------------------------------------------------------------ generated algebra */
"""

ALGORITHM = r"""
/* -------------------------------------------------------------------------------------------- algorithms */

/* Error per value that SPRAGSYM_OK vouches for. */
#define TOLERANCE 1e-12
/* The quartic's last coefficient over its largest below which its roots are too far apart for one scale. */
#define SMALLEST_RATIO 1e-60
#define SMALLEST_SCALE 1e-200
#define LARGEST_SCALE 1e200
#define CHORD_STEPS 2
#define CUBIC_STEPS 2
#define FACTOR_STEPS 1
#define ROOT_STEPS 2
#define MAX_ROOTS 4
#define PIECES 3
#define SECANTS 2

/* (t^2 + p1 t + q1) (t^2 + p2 t + q2) with q1 < 0 < q2. */
typedef struct {
    double p1;
    double q1;
    double p2;
    double q2;
} factors;

/* f of the derivation, scaled, with bounds on the errors of its coefficients and on |f''|. */
typedef struct {
    double value[4];
    double error[4];
    double curvature;
} line;

/* A root of f: its direction, f' there, and the bound on the error of the angle. */
typedef struct {
    double t;
    double cos_theta;
    double sin_theta;
    double slope;
    double radius;
} root;

static int finite_all(int length, const double *values) {
    for (int i = 0; i < length; i++) {
        if (!isfinite(values[i])) {
            return 0;
        }
    }
    return 1;
}

static spragsym_status deliver(int length, const double *values, double *result) {
    if (!finite_all(length, values)) {
        return SPRAGSYM_OUT_OF_RANGE;
    }
    for (int i = 0; i < length; i++) {
        result[i] = values[i];
    }
    return SPRAGSYM_OK;
}

spragsym_status spragsym_prepare(const spragsym_parameters *parameters, spragsym_model *model) {
    const double pi = 3.14159265358979323846;
    const spragsym_parameters *const given = parameters;
    if (!given || !model) {
        return SPRAGSYM_BAD_INPUT;
    }
    /* Written so that a NaN fails. */
    if (!(given->theta0 > 0.0 && given->theta0 < pi && given->mu0 >= 0.0 && given->kappa > 0.0 && given->alpha >= 0.0 &&
          given->sigma > 0.0 && given->beta >= 0.0)) {
        return SPRAGSYM_BAD_INPUT;
    }
    if (!isfinite(given->mu0) || !isfinite(given->kappa) || !isfinite(given->alpha) || !isfinite(given->sigma) ||
        !isfinite(given->beta)) {
        return SPRAGSYM_BAD_INPUT;
    }
    model->cos0 = cos(given->theta0);
    model->sin0 = sin(given->theta0);
    model->mu0 = given->mu0;
    model->kappa = given->kappa;
    model->alpha = given->alpha;
    model->sigma = given->sigma;
    model->beta = given->beta;
    return SPRAGSYM_OK;
}

/* Coefficients of f over the largest of them, with error bounds; 0 if double can't carry them. */
static int scaled_line(const spragsym_model *model, double nbar, line *f) {
    algebra_f_coefficients(model->cos0, model->sin0, model->mu0, model->kappa, model->alpha, model->sigma, model->beta, nbar,
                           f->value);
    bound_f_coefficients(model->cos0, model->sin0, model->mu0, model->kappa, model->alpha, model->sigma, model->beta, nbar,
                         f->error);
    const double scale = larger(larger(fabs(f->value[0]), fabs(f->value[1])), larger(fabs(f->value[2]), fabs(f->value[3])));
    if (!(scale > SMALLEST_SCALE && scale < LARGEST_SCALE && finite_all(4, f->value) && finite_all(4, f->error))) {
        return 0;
    }
    const double inverse = 1.0 / scale;
    for (int i = 0; i < 4; i++) {
        f->value[i] *= inverse;
        f->error[i] = f->error[i] * inverse + 2.0 * DBL_EPSILON * fabs(f->value[i]);
    }
    curvature_f(f->value[0], f->value[1], f->value[2], f->value[3], &f->curvature);
    f->curvature *= 1.0001;
    return f->value[1] <= 0.0 - SMALLEST_RATIO;
}

/* 4 or 2: the number of real roots by the sign of the discriminant; 0 if rounding could change it. The cubic's
 * discriminant -4 P^3 - 27 Q^2 is the quartic's, and the quartic's roots multiply to -1: four or two are real. */
static int certain_count(const double depressed[2], const double error[2]) {
    const double P = fabs(depressed[0]);
    const double Q = fabs(depressed[1]);
    const double cube = 4.0 * P * P * P;
    const double squared = 27.0 * Q * Q;
    const double discriminant = (depressed[0] < 0.0) ? cube - squared : 0.0 - cube - squared;
    const double from_P = (12.0 * P * P + (12.0 * P + 4.0 * error[0]) * error[0]) * error[0];
    const double from_Q = (54.0 * Q + 27.0 * error[1]) * error[1];
    const double bound = from_P + from_Q + 8.0 * DBL_EPSILON * (cube + squared) + DBL_MIN;
    if (discriminant > bound) {
        return 4;
    }
    return (discriminant < 0.0 - bound) ? 2 : 0;
}

/* The root of z^3 + P z + Q of largest magnitude: the one that no other root is close to. */
static double outermost(double P, double Q) {
    const double third = P / 3.0;
    const double half = 0.5 * fabs(Q);
    const double inside = half * half + third * third * third;
    double z;
    if (inside >= 0.0) {
        const double radical = cbrt(half + sqrt(inside));
        z = (radical > 0.0) ? radical - third / radical : 0.0;
    } else {
        const double radius = sqrt(fabs(third));
        const double cosine = half / (radius * radius * radius);
        /* 2 cos(acos(cosine)/3) is the root of v^3 - 3 v = 2 cosine next to this chord. */
        double v = 1.7320508075688772 + 0.26794919243112270 * ((cosine < 1.0) ? cosine : 1.0);
        for (int i = 0; i < CHORD_STEPS; i++) {
            v -= (v * v * v - 3.0 * v - 2.0 * cosine) / (3.0 * v * v - 3.0);
        }
        z = radius * v;
    }
    return (Q > 0.0) ? 0.0 - z : z;
}

/* That root of the resolvent itself, to full relative accuracy, which the shift of the depressed cubic may have cost. */
static double isolated_root(const double cubic[3], const double depressed[2]) {
    double isolated = outermost(depressed[0], depressed[1]) - cubic[2] / 3.0;
    for (int i = 0; i < CUBIC_STEPS; i++) {
        const double value = ((isolated + cubic[2]) * isolated + cubic[1]) * isolated + cubic[0];
        const double slope = (3.0 * isolated + 2.0 * cubic[2]) * isolated + cubic[1];
        if (fabs(slope) > 0.0) {
            isolated -= value / slope;
        }
    }
    return isolated;
}

/* One Newton step on both factors at once: what F1 F2 lacks of t^4 + A3 t^3 + A2 t^2 + A1 t - 1, divided by F2 modulo F1.
 * q1 q2 = -1 is kept by setting the smaller from the larger. */
static void polish(const double A[4], factors *F) {
    const double p1 = F->p1;
    const double q1 = F->q1;
    const double R3 = A[3] - (p1 + F->p2);
    const double R2 = A[2] - (q1 + F->q2 + p1 * F->p2);
    const double R1 = A[1] - (p1 * F->q2 + F->p2 * q1);
    const double R0 = 0.0 - 1.0 - q1 * F->q2;
    const double r = R1 - p1 * R2 + (p1 * p1 - q1) * R3;
    const double s = R0 - q1 * R2 + p1 * q1 * R3;
    const double u = F->p2 - p1;
    const double v = F->q2 - q1;
    const double resultant = v * v - p1 * u * v + q1 * u * u;
    if (!(fabs(resultant) > 0.0)) {
        return;
    }
    const double inverse = 1.0 / resultant;
    const double step_p1 = (r * v - s * u) * inverse;
    const double step_q1 = (r * u * q1 + s * (v - p1 * u)) * inverse;
    const double step_p2 = R3 - step_p1;
    const double step_q2 = R2 - step_q1 - F->p2 * step_p1 - p1 * step_p2;
    const double next_q1 = q1 + step_q1;
    const double next_q2 = F->q2 + step_q2;
    if (!(next_q1 < 0.0 && next_q2 > 0.0 && isfinite(step_p1) && isfinite(next_q1) && isfinite(next_q2))) {
        return;
    }
    F->p1 = p1 + step_p1;
    F->p2 += step_p2;
    F->q1 = (fabs(next_q1) >= next_q2) ? next_q1 : 0.0 - 1.0 / next_q2;
    F->q2 = (fabs(next_q1) >= next_q2) ? 0.0 - 1.0 / next_q1 : next_q2;
}

/* Two quadratic factors of the quartic in t = tan(theta/2) from the isolated root of its resolvent: a close pair of
 * roots ends up together, in the second. */
static factors factorize(const double e[5], double resolvent_root) {
    const double b = e[0];
    const double inverse = 1.0 / e[4];
    const double A[4] = {0.0 - 1.0, e[1] * inverse, e[2] * inverse, e[3] * inverse};
    const double twice = 2.0 * resolvent_root;
    const double hypotenuse = sqrt(twice * twice + b * b);
    factors F;
    F.q1 = (twice >= 0.0) ? (twice + hypotenuse) / b : b / (hypotenuse - twice);
    F.q1 = (F.q1 < 0.0) ? F.q1 : 0.0 - DBL_EPSILON;
    F.q2 = 0.0 - 1.0 / F.q1;
    const double over_gap = 1.0 / (F.q2 - F.q1);
    F.p1 = (A[1] - A[3] * F.q1) * over_gap;
    F.p2 = (A[3] * F.q2 - A[1]) * over_gap;
    for (int i = 0; i < FACTOR_STEPS; i++) {
        polish(A, &F);
    }
    return F;
}

/* Real roots of t^2 + p t + q without cancellation; their number. */
static int quadratic_roots(double p, double q, double roots[2]) {
    const double half = 0.5 * p;
    const double inside = half * half - q;
    if (!(inside >= 0.0)) {
        return 0;
    }
    const double outer = (half > 0.0) ? 0.0 - half - sqrt(inside) : sqrt(inside) - half;
    if (!(fabs(outer) > 0.0)) {
        return 0;
    }
    roots[0] = outer;
    roots[1] = q / outer;
    return 2;
}

static void sort(int length, double *values) {
    for (int i = 1; i < MAX_ROOTS; i++) {
        for (int j = 1; j < MAX_ROOTS; j++) {
            if (j < length && values[j] < values[j - 1]) {
                const double smaller = values[j];
                values[j] = values[j - 1];
                values[j - 1] = smaller;
            }
        }
    }
}

static void direction(double t, root *at) {
    const double squared = t * t;
    at->t = t;
    at->cos_theta = (1.0 - t) * (1.0 + t) / (1.0 + squared);
    at->sin_theta = 2.0 * t / (1.0 + squared);
}

/* A root of f from a guess. Where Kantorovich's theorem holds for f with all its rounding errors there is exactly one root
 * within the radius; where it does not, the radius is HUGE_VAL. */
static root locate(double t, const line *f) {
    const double *const c = f->value;
    const double *const e = f->error;
    root at;
    double value;
    double value_error;
    double slope_error;
    direction(t, &at);
    algebra_f(at.cos_theta, at.sin_theta, c[0], c[1], c[2], c[3], &value);
    algebra_f_slope(at.cos_theta, at.sin_theta, c[0], c[1], c[2], c[3], &at.slope);
    bound_f(at.cos_theta, at.sin_theta, c[0], c[1], c[2], c[3], e[0], e[1], e[2], e[3], &value_error);
    for (int i = 0; i < ROOT_STEPS; i++) {
        /* A single step is sound for a root that stands alone, and gains nothing below the rounding of f. */
        if (fabs(value) > value_error && 4.0 * f->curvature * fabs(value) < at.slope * at.slope) {
            direction(at.t - 0.5 * value / at.slope * (1.0 + at.t * at.t), &at);
            algebra_f(at.cos_theta, at.sin_theta, c[0], c[1], c[2], c[3], &value);
            algebra_f_slope(at.cos_theta, at.sin_theta, c[0], c[1], c[2], c[3], &at.slope);
            bound_f(at.cos_theta, at.sin_theta, c[0], c[1], c[2], c[3], e[0], e[1], e[2], e[3], &value_error);
        }
    }
    bound_f_slope(at.cos_theta, at.sin_theta, c[0], c[1], c[2], c[3], e[0], e[1], e[2], e[3], &slope_error);
    const double steep = fabs(at.slope) - slope_error;
    const double off = fabs(value) + value_error;
    at.radius = HUGE_VAL;
    if (steep > 0.0) {
        const double h = f->curvature * off / (steep * steep);
        if (h <= 0.5) {
            at.radius = off / steep / (1.0 - h);
        }
    }
    return at;
}

/* Stability from the sign of f', which is that of det K, and of the discriminant and the trace in eq. (27). */
static spragsym_stability classify(const spragsym_model *model, const root *at, double L, double L_error, double nbar,
                                   int *certain) {
    double value[3];
    double error[3];
    if (at->slope < 0.0) {
        *certain = at->radius < HUGE_VAL;
        return SPRAGSYM_DIVERGENT;
    }
    algebra_measures(at->cos_theta, at->sin_theta, L, model->mu0, model->alpha, model->sigma, model->beta, nbar, value);
    bound_measures(at->cos_theta, at->sin_theta, L, model->mu0, model->alpha, model->sigma, model->beta, nbar, at->radius,
                   L_error, error);
    *certain = at->radius < HUGE_VAL && fabs(value[2]) > error[2];
    if (value[2] < 0.0) {
        return SPRAGSYM_FLUTTER;
    }
    *certain = *certain && fabs(value[0]) > error[0];
    return (value[0] > 0.0) ? SPRAGSYM_STABLE : SPRAGSYM_DIVERGENT;
}

static double relative(double error, double value) { return error / larger(1.0, fabs(value)); }

/* The equilibrium at a root of f, if it is one of this regime: 1 or 0. */
static int accept(const spragsym_model *model, const root *at, spragsym_regime regime, spragsym_equilibrium *found,
                  int *certain) {
    const double nbar = (regime == SPRAGSYM_CONTACT) ? 1.0 : 0.0;
    double value[3];
    double error[3];
    algebra_state(at->cos_theta, at->sin_theta, model->cos0, model->sin0, model->kappa, model->sigma, model->beta, nbar, value);
    bound_state(at->cos_theta, at->sin_theta, model->cos0, model->sin0, model->kappa, model->sigma, model->beta, nbar,
                at->radius, error);
    /* The bound is of second order in the error of the angle: it holds while that is small beside sin theta. */
    const int bounded = at->radius < 1e-3 * fabs(at->sin_theta) && finite_all(3, error);
    const int known = bounded && fabs(value[0]) > error[0];
    if (!(value[0] > 0.0)) {
        *certain = known;
        return 0;
    }
    *certain = known && fabs(value[2]) > error[2];
    if ((value[2] < 0.0) != (regime == SPRAGSYM_CONTACT) || !finite_all(3, value)) {
        return 0;
    }
    int stability_certain;
    found->theta = 2.0 * atan(at->t);
    found->L = value[0];
    found->x = value[1];
    found->y = value[2];
    found->stability = classify(model, at, value[0], error[0], nbar, &stability_certain);
    const double angle_error = at->radius + 2.0 * DBL_EPSILON * fabs(found->theta);
    found->error = larger(larger(relative(angle_error, found->theta), relative(error[0], value[0])),
                          larger(relative(error[1], value[1]), relative(error[2], value[2])));
    found->error = bounded ? found->error : HUGE_VAL;
    *certain = *certain && stability_certain && found->error <= TOLERANCE;
    return 1;
}

/* Guesses of all real roots of f in t, ascending; their number. *certain: the sign of the discriminant stands. */
static int guesses(const line *f, double roots[MAX_ROOTS], int *certain) {
    const double *const c = f->value;
    const double *const e = f->error;
    double quartic[5];
    double cubic[3];
    double depressed[2];
    double depressed_error[2];
    algebra_t_quartic(c[0], c[1], c[2], c[3], quartic);
    algebra_resolvent(c[0], c[1], c[2], c[3], cubic);
    algebra_depressed(c[0], c[1], c[2], c[3], depressed);
    bound_depressed(c[0], c[1], c[2], c[3], e[0], e[1], e[2], e[3], depressed_error);
    const factors F = factorize(quartic, isolated_root(cubic, depressed));
    int count = quadratic_roots(F.p1, F.q1, roots);
    count += quadratic_roots(F.p2, F.q2, roots + count);
    sort(count, roots);
    *certain = count == certain_count(depressed, depressed_error);
    return count;
}

spragsym_status spragsym_equilibria(const spragsym_model *model, spragsym_regime regime,
                                    spragsym_equilibrium equilibria[SPRAGSYM_MAX_EQUILIBRIA], int *count) {
    line f;
    double t[MAX_ROOTS] = {0.0, 0.0, 0.0, 0.0};
    double previous_end = 0.0 - HUGE_VAL;
    int certain;
    int found = 0;
    if (!model || !equilibria || !count || (regime != SPRAGSYM_CONTACT && regime != SPRAGSYM_LIFTOFF)) {
        return SPRAGSYM_BAD_INPUT;
    }
    if (!scaled_line(model, (regime == SPRAGSYM_CONTACT) ? 1.0 : 0.0, &f)) {
        return SPRAGSYM_OUT_OF_RANGE;
    }
    const int real = guesses(&f, t, &certain);
    for (int i = 0; i < MAX_ROOTS; i++) {
        /* Of one negative root nothing more need be known in contact: with sin theta < 0 < L, y = sin theta0 - L sin theta > 0. */
        const int needed = i < real && (regime == SPRAGSYM_LIFTOFF || t[i] > 0.0 || t[1] < 0.0);
        if (needed) {
            const root at = locate(t[i], &f);
            /* In t the radius is (1 + t^2)/2 times that of the angle; twice that covers its growth. */
            const double reach = at.radius * (1.0 + at.t * at.t);
            int sure;
            certain = certain && at.radius * (1.0 + fabs(at.t)) < 0.5 && at.t - reach > previous_end;
            previous_end = at.t + reach;
            found += accept(model, &at, regime, &equilibria[found], &sure);
            certain = certain && sure;
        }
    }
    const spragsym_equilibrium none = {0.0, 0.0, 0.0, 0.0, 0.0, SPRAGSYM_NONE};
    for (int i = found; i < SPRAGSYM_MAX_EQUILIBRIA; i++) {
        equilibria[i] = none;
    }
    *count = found;
    return certain ? SPRAGSYM_OK : SPRAGSYM_UNCERTAIN;
}

/* What the motion needs beside its state: the smooth regime it is in. */
typedef struct {
    const spragsym_model *model;
    double V;
    double d;
    double nbar;
    double side;
} motion;

static void derivative(const motion *in, const double state[4], double rate[4]) {
    const spragsym_model *const m = in->model;
    rate[0] = state[2];
    rate[1] = state[3];
    algebra_regime_rhs(state[0], state[1], state[2], state[3], m->cos0, m->sin0, m->mu0, m->kappa, m->alpha, m->sigma, m->beta,
                       in->V, in->d, in->nbar, in->side, rate + 2);
}

static void copy(const double from[4], double to[4]) {
    for (int i = 0; i < 4; i++) {
        to[i] = from[i];
    }
}

static void advance(const double state[4], double h, const double rate[4], double next[4]) {
    for (int i = 0; i < 4; i++) {
        next[i] = state[i] + h * rate[i];
    }
}

/* One classical Runge-Kutta step in one smooth regime. */
static void runge_kutta(const motion *in, double h, const double state[4], double next[4]) {
    double k1[4];
    double k2[4];
    double k3[4];
    double k4[4];
    double middle[4];
    derivative(in, state, k1);
    advance(state, 0.5 * h, k1, middle);
    derivative(in, middle, k2);
    advance(state, 0.5 * h, k2, middle);
    derivative(in, middle, k3);
    advance(state, h, k3, middle);
    derivative(in, middle, k4);
    for (int i = 0; i < 4; i++) {
        next[i] = state[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
    }
}

/* Distances to the two kinks, positive inside the regime: into or above the belt, behind or ahead of it. */
static void distances(const motion *in, const double state[4], double distance[2]) {
    distance[0] = (in->nbar > 0.0) ? 0.0 - state[1] : state[1];
    distance[1] = in->side * (in->V - state[2]);
}

/* The sign of the first of three that is not zero. */
static double leading_sign(double value, double first, double second) {
    const double deciding = (fabs(value) > 0.0) ? value : ((fabs(first) > 0.0) ? first : second);
    return (deciding > 0.0) ? 1.0 : 0.0 - 1.0;
}

/* The regime that the motion goes on in: by the state, and on a kink by where the state is headed, for which the regime
 * does not matter: forces are continuous there. */
static void enter(motion *in, const double state[4]) {
    double rate[4];
    derivative(in, state, rate);
    in->nbar = (leading_sign(state[1], state[3], rate[3]) < 0.0) ? 1.0 : 0.0;
    in->side = leading_sign(in->V - state[2], 0.0 - rate[2], 1.0);
}

/* The kink that a step from distances `before` to `after` crosses first, or -1, and a guess at which share of the step. */
static int crossed(const double before[2], const double after[2], double *share) {
    int kink = -1;
    *share = 1.0;
    for (int i = 0; i < 2; i++) {
        if (before[i] > 0.0 && after[i] < 0.0) {
            const double at = before[i] / (before[i] - after[i]);
            if (at < *share) {
                *share = at;
                kink = i;
            }
        }
    }
    return kink;
}

/* As far as the first kink, or to the end of h; what is left of h. */
static double piece(motion *in, double h, double state[4], int last) {
    double next[4];
    double before[2];
    double after[2];
    double share;
    distances(in, state, before);
    runge_kutta(in, h, state, next);
    distances(in, next, after);
    const int kink = crossed(before, after, &share);
    if (last || kink < 0) {
        copy(next, state);
        return 0.0;
    }
    /* Regula falsi on the step itself: each pass gains an order in h. */
    double low = 0.0;
    double high = 1.0;
    double at_low = before[kink];
    double at_high = after[kink];
    for (int i = 0; i < SECANTS; i++) {
        runge_kutta(in, share * h, state, next);
        distances(in, next, after);
        if (after[kink] > 0.0) {
            low = share;
            at_low = after[kink];
        } else {
            high = share;
            at_high = after[kink];
        }
        if (i < SECANTS - 1 && at_low > at_high) {
            share = low + (high - low) * at_low / (at_low - at_high);
        }
    }
    copy(next, state);
    if (kink == 0) {
        in->nbar = 1.0 - in->nbar;
    } else {
        in->side = 0.0 - in->side;
    }
    return (1.0 - share) * h;
}

spragsym_status spragsym_step(const spragsym_model *model, double V, double d, double h, double state[4]) {
    if (!model || !state || !isfinite(V) || !(d > 0.0) || !isfinite(d) || !(h > 0.0) || !isfinite(h) ||
        !finite_all(4, state)) {
        return SPRAGSYM_BAD_INPUT;
    }
    motion in = {model, V, d, (state[1] < 0.0) ? 1.0 : 0.0, (V >= state[2]) ? 1.0 : 0.0 - 1.0};
    double next[4];
    copy(state, next);
    enter(&in, next);
    double left = h;
    for (int i = 0; i < PIECES; i++) {
        if (left > 0.0) {
            left = piece(&in, left, next, i == PIECES - 1);
        }
    }
    return deliver(4, next, state);
}
"""

MAKEFILE = """# Builds the example: `make && ./example`.
CC ?= cc
CFLAGS ?= -O2
override CFLAGS += -std=c99 -Wall -Wextra -Wpedantic -Werror

example: main.o spragsym.o
\t$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

main.o spragsym.o: spragsym.h

clean:
\trm -f example main.o spragsym.o

.PHONY: clean
"""

EXAMPLE = r"""/* Equilibria at the article's base values, and some steps of the motion. */
#include <stdio.h>

#include "spragsym.h"

static const char *const names[] = {"none", "stable", "divergent", "flutter"};

static int print_equilibria(const spragsym_model *model, spragsym_regime regime) {
    spragsym_equilibrium found[SPRAGSYM_MAX_EQUILIBRIA];
    int count;
    const spragsym_status status = spragsym_equilibria(model, regime, found, &count);
    if (status != SPRAGSYM_OK) {
        return (int)status;
    }
    printf("%s: %d\n", regime == SPRAGSYM_CONTACT ? "contact" : "lift-off", count);
    for (int i = 0; i < count; i++) {
        printf("  theta %.12f  L %.12f  x %+.12f  y %+.12f  error %.0e  %s\n", found[i].theta, found[i].L, found[i].x,
               found[i].y, found[i].error, names[found[i].stability]);
    }
    return 0;
}

int main(void) {
    const double pi = 3.14159265358979323846;
    const spragsym_parameters article = {49.0 / 180.0 * pi, 0.5, 0.007, 0.007, 0.1, 0.0};
    spragsym_model model;
    double state[4] = {0.0, 0.0, 0.0, 0.0};
    if (spragsym_prepare(&article, &model) != SPRAGSYM_OK) {
        return 1;
    }
    if (print_equilibria(&model, SPRAGSYM_CONTACT) || print_equilibria(&model, SPRAGSYM_LIFTOFF)) {
        return 1;
    }
    for (int i = 0; i <= 1000; i++) {
        if (i % 200 == 0) {
            printf("time %5.1f  x %+.9f  y %+.9f\n", 0.05 * i, state[0], state[1]);
        }
        if (spragsym_step(&model, 0.5, 10.0, 0.05, state) != SPRAGSYM_OK) {
            return 1;
        }
    }
    return 0;
}
"""
