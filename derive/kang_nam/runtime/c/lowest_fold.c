/* -------------------------------------------------------------------------------------- the critical friction */

/* Degree of the polynomials in sin theta among whose roots cusps and turns are, and one more. */
#define DEGREE 9
#define COEFFICIENTS 10
#define SEXTIC 7
#define HALVINGS 44
#define SHARPENINGS 4
/* Rounding of a polynomial's value, over the sum of its terms' sizes, beyond which its sign is known. */
#define OPEN 1e-14
#define NARROW 1e-11

static double polynomial(const double e[COEFFICIENTS], double x) {
    double value = 0.0;
    for (int i = 0; i < COEFFICIENTS; i++) {
        value = value * x + e[DEGREE - i];
    }
    return value;
}

static int decided(const double e[COEFFICIENTS], double x) {
    double size = 0.0;
    for (int i = 0; i < COEFFICIENTS; i++) {
        size = size * x + fabs(e[DEGREE - i]);
    }
    return fabs(polynomial(e, x)) > OPEN * size;
}

/* Where a polynomial changes its sign between two places; the second, if its sign is the same at both. */
static double change(const double e[COEFFICIENTS], double low, double high, int *found) {
    const int falls = polynomial(e, low) > 0.0;
    *found = falls != (polynomial(e, high) > 0.0);
    double left = low;
    double right = high;
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = 0.5 * (left + right);
        const int before = (polynomial(e, middle) > 0.0) == falls;
        left = before ? middle : left;
        right = before ? right : middle;
    }
    return *found ? 0.5 * (left + right) : high;
}

/* Roots in (0, 1), ascending: between two neighbouring roots of its derivative a polynomial has one at most. Whether no two can
 * have been lost to rounding. */
static int roots_within(const double e[COEFFICIENTS], double roots[DEGREE], int *count) {
    double derived[COEFFICIENTS][COEFFICIENTS], ends[COEFFICIENTS + 1], next[COEFFICIENTS + 1];
    int certain = 1;
    int found = 0;
    for (int i = 0; i < COEFFICIENTS; i++) {
        derived[0][i] = e[i];
        ends[i] = (i > 0) ? 1.0 : 0.0;
        next[i] = ends[i];
    }
    ends[COEFFICIENTS] = 1.0;
    for (int k = 0; k < DEGREE; k++) {
        derived[k + 1][DEGREE] = 0.0;
        for (int i = 0; i < DEGREE; i++) {
            derived[k + 1][i] = (i + 1.0) * derived[k][i + 1];
        }
    }
    for (int k = 0; k < DEGREE; k++) {
        for (int i = 0; i < DEGREE; i++) {
            next[i + 1] = change(derived[DEGREE - k], ends[i], ends[i + 1], &found);
        }
        for (int i = 0; i < DEGREE; i++) {
            ends[i + 1] = next[i + 1];
        }
    }
    *count = 0;
    for (int i = 0; i < COEFFICIENTS; i++) {
        certain = certain && decided(e, ends[i]);
        const double root = change(e, ends[i], ends[i + 1], &found);
        if (found && *count < DEGREE) {
            roots[*count] = root;
            *count += 1;
        }
    }
    return certain && decided(e, 1.0);
}

/* A candidate: a fold at which the lower two of three states meet, or a cusp. */
typedef struct {
    double mu0, theta0;
    double cosine; /* of the state's direction */
    double sine;
    spragsym_fold_kind kind;
} candidate;

/* One step of Newton's method in theta0 and mu0 for f = f' = 0, the direction fixed; how far it went, over what there was. At a cusp
 * both, and at a turn mu0, hardly depend on the direction, whose error therefore counts by its square. */
static double sharpened(const spragsym_parameters *p, candidate *at) {
    double line[4], rates[12];
    const Direction leaning = cosine_and_sine(at->theta0);
    algebra_f_coefficients(leaning.cosine, leaning.sine, at->mu0, p->kappa, p->alpha, p->sigma, p->beta, 1.0, line);
    algebra_unfolding(at->cosine, at->sine, leaning.cosine, leaning.sine, at->mu0, p->kappa, p->alpha, p->sigma, p->beta, rates);
    const double f = algebra_f(at->cosine, at->sine, line[0], line[1], line[2], line[3]);
    const double slope = algebra_f_slope(at->cosine, at->sine, line[0], line[1], line[2], line[3]);
    const double inverse = 1.0 / (rates[0] * rates[3] - rates[1] * rates[2]);
    const double turn = (f * rates[3] - slope * rates[2]) * inverse;
    const double rise = (slope * rates[0] - f * rates[1]) * inverse;
    if (fabs(turn) < 0.01 * at->theta0 && fabs(rise) < 0.01 * at->mu0) {
        at->theta0 = at->theta0 - turn;
        at->mu0 = at->mu0 - rise;
    }
    return larger(fabs(turn) / at->theta0, fabs(rise) / at->mu0);
}

/* Whether the lower two of three states meet there, f'' < 0. */
static int meets_below(const spragsym_parameters *p, const candidate *at) {
    double line[4];
    const Direction leaning = cosine_and_sine(at->theta0);
    algebra_f_coefficients(leaning.cosine, leaning.sine, at->mu0, p->kappa, p->alpha, p->sigma, p->beta, 1.0, line);
    return algebra_f_curvature(at->cosine, at->sine, line[0], line[1], line[2], line[3]) < 0.0;
}

/* Take a candidate that is in contact if it is the lowest; whether it is certain which it is. */
static int weighed(const spragsym_parameters *p, candidate at, spragsym_critical_load *least) {
    double state[3];
    double step = 0.0;
    if (!(at.mu0 >= 0.0)) {
        return at.mu0 < 0.0;
    }
    if (at.mu0 > 0.0 && at.kind != SPRAGSYM_END) {
        for (int i = 0; i < SHARPENINGS; i++) {
            step = sharpened(p, &at);
        }
    }
    const Direction leaning = cosine_and_sine(at.theta0);
    algebra_state(at.cosine, at.sine, leaning.cosine, leaning.sine, p->kappa, p->sigma, p->beta, 1.0, state);
    const int in_contact = state[0] > 0.0 && state[2] < 0.0;
    if (in_contact && (at.kind == SPRAGSYM_CUSP || meets_below(p, &at)) && at.mu0 < least->mu0) {
        least->mu0 = at.mu0;
        least->theta0 = at.theta0;
        least->kind = at.kind;
    }
    return step < NARROW && fabs(state[0]) > TOLERANCE && fabs(state[2]) > TOLERANCE;
}

static int weigh_cusp(const spragsym_parameters *p, double s, spragsym_critical_load *least) {
    double angles[2];
    double point[3] = {0.0, 1.0, 0.0};
    algebra_cusp_sine(s, p->kappa, p->alpha, p->sigma, p->beta, angles);
    if (p->alpha > 0.0) {
        algebra_cusp_point(s, p->kappa, p->alpha, p->sigma, p->beta, point);
    }
    const double width = sqrt((1.0 - s) * (1.0 + s));
    const double cosine = (angles[1] < 0.0) ? 0.0 - width : width;
    const double leaning = (p->alpha > 0.0) ? point[1] * cosine : 1.0;
    if (!(angles[0] > 0.0 && angles[0] < 1.0 && leaning > 0.0)) {
        return angles[0] < 0.0 - TOLERANCE || angles[0] > 1.0 + TOLERANCE || leaning < 0.0;
    }
    const candidate at = {angles[1] * cosine, 2.0 * arctangent(angles[0] / (1.0 + sqrt((1.0 - angles[0]) * (1.0 + angles[0])))),
        cosine, s, SPRAGSYM_CUSP};
    return weighed(p, at, least);
}

static int weigh_turn(const spragsym_parameters *p, double s, spragsym_critical_load *least) {
    double ratio[2];
    algebra_turning_sine(s, p->kappa, p->alpha, p->sigma, p->beta, ratio);
    const double s0 = ratio[0] / ratio[1];
    if (!(s0 > 0.0 && s0 < 1.0)) {
        return s0 < 0.0 - TOLERANCE || s0 > 1.0 + TOLERANCE;
    }
    const double c0 = sqrt((1.0 - s0) * (1.0 + s0));
    const double width = sqrt((1.0 - s) * (1.0 + s));
    const double product = algebra_turning_cosine(s, s0, p->kappa, p->alpha, p->sigma, p->beta);
    const double c = (product < 0.0) ? 0.0 - width : width;
    const double mu0 = algebra_surface(c, s, c0, s0, p->kappa, p->alpha, p->sigma, p->beta);
    const candidate at = {mu0, 2.0 * arctangent(s0 / (1.0 + c0)), c, s, SPRAGSYM_TURN};
    return weighed(p, at, least);
}

/* t = tan(theta/2), or its inverse where theta lies beyond pi/2. */
static int weigh_level(const spragsym_parameters *p, double t, double sign_of_cosine, spragsym_critical_load *least) {
    const Direction there = direction(t);
    const double c = sign_of_cosine * there.cosine;
    const double mu0 = algebra_surface(c, there.sine, 1.0, 0.0, p->kappa, p->alpha, p->sigma, p->beta);
    const candidate at = {mu0, 0.0, c, there.sine, SPRAGSYM_END};
    return weighed(p, at, least);
}

static int weigh_level_folds(const spragsym_parameters *p, spragsym_critical_load *least) {
    double line[4], rates[24], sextic[SEXTIC];
    double turned[2][COEFFICIENTS] = {{0.0}, {0.0}};
    double roots[DEGREE];
    int count;
    int certain = 1;
    algebra_f_coefficients(1.0, 0.0, 0.0, p->kappa, p->alpha, p->sigma, p->beta, 1.0, line);
    algebra_f_changes(1.0, 0.0, 0.0, p->kappa, p->alpha, p->sigma, p->beta, rates);
    algebra_fold_sextic(line[0], line[1], line[2], line[3], rates[4], rates[5], rates[6], rates[7], sextic);
    for (int i = 0; i < SEXTIC; i++) {
        turned[0][i] = sextic[i];
        turned[1][SEXTIC - 1 - i] = sextic[i];
    }
    for (int side = 0; side < 2; side++) {
        certain = roots_within(turned[side], roots, &count) && certain;
        for (int i = 0; i < DEGREE; i++) {
            certain = (i >= count || weigh_level(p, roots[i], 1.0 - 2.0 * side, least)) && certain;
        }
    }
    return certain;
}

spragsym_status spragsym_critical_friction(const spragsym_parameters *parameters, spragsym_critical_load *lowest) {
    if (!parameters || !lowest) {
        return SPRAGSYM_BAD_INPUT;
    }
    spragsym_parameters given = *parameters;
    given.theta0 = 1.0;
    given.mu0 = 0.0;
    if (!allowed(&given)) {
        return SPRAGSYM_BAD_INPUT;
    }
    double e[COEFFICIENTS] = {0.0};
    double roots[DEGREE];
    int count;
    spragsym_critical_load least = {HUGE_VAL, 0.0, SPRAGSYM_NO_FOLD};
    if (given.alpha > 0.0) {
        algebra_cusp_polynomial(given.kappa, given.alpha, given.sigma, given.beta, e);
    } else {
        algebra_cusp_cubic(given.kappa, given.sigma, given.beta, e);
    }
    int certain = roots_within(e, roots, &count);
    for (int i = 0; i < DEGREE; i++) {
        certain = (i >= count || weigh_cusp(&given, roots[i], &least)) && certain;
    }
    if (given.alpha > 0.0) {
        algebra_turning_polynomial(given.kappa, given.alpha, given.sigma, given.beta, e);
        certain = roots_within(e, roots, &count) && certain;
        for (int i = 0; i < DEGREE; i++) {
            certain = (i >= count || weigh_turn(&given, roots[i], &least)) && certain;
        }
    } else { /* an upright one without friction, where states meet by symmetry */
        certain = weigh_cusp(&given, 1.0, &least) && certain;
    }
    certain = weigh_level_folds(&given, &least) && certain;
    *lowest = least;
    return certain ? SPRAGSYM_OK : SPRAGSYM_UNCERTAIN;
}
