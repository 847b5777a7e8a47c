# ruff: noqa: E501  # C is 124 wide
"""All equilibria of a point, and of many side by side, in C: algorithms that hold no formula of the model."""

EQUILIBRIA = r"""
/* ------------------------------------------------------------------------------------------- equilibria */

/* Error per value that SPRAGSYM_OK vouches for. */
#define TOLERANCE 1e-12
/* The quartic's last coefficient over its largest below which its roots are too far apart for one scale. */
#define SMALLEST_RATIO 1e-60
#define SMALLEST_SCALE 1e-200
#define LARGEST_SCALE 1e200
/* A parameter smaller than this, but not 0, may lose digits to underflow. */
#define SMALLEST_PARAMETER 1e-250
/* Error of a coefficient over the largest of them from which bounds of first order in it do not hold. */
#define LARGEST_ERROR 1e-8
#define CUBE_ROOT_STEPS 3
#define CHORD_STEPS 2
#define CUBIC_STEPS 1
#define FACTOR_STEPS 1
#define MAX_ROOTS 4
/* Points and roots that are worked on side by side, and groups of roots that a block of points can have. */
#define BLOCK 64
#define LANES 16
#define GROUPS 16
#if GROUPS * LANES != MAX_ROOTS * BLOCK
#error "spragsym: the groups must have room for every root of a block"
#endif

/* (t^2 + p1 t + q1) (t^2 + p2 t + q2) with q1 < 0 < q2. */
typedef struct {
    double p1;
    double q1;
    double p2;
    double q2;
} factors;

/* f of the derivation, scaled, with bounds on the errors of its coefficients and on |f''|; carried: double can; sound: and
 * the bounds hold. */
typedef struct {
    double value[4];
    double error[4];
    double curvature;
    int carried;
    int sound;
} line;

/* The quartic in t = tan(theta/2); two: it certainly has two real roots, not four; lone: and certainly one positive root. */
typedef struct {
    factors F;
    int two;
    int lone;
} quartic;

/* Real roots of the quartic that can be equilibria of a regime, ascending; certain: there are no more. */
typedef struct {
    double t[MAX_ROOTS];
    int count;
    int certain;
} guesses;

/* f at one point. */
typedef struct {
    double cosine;
    double sine;
    double value;
    double value_error;
    double slope;
    double slope_error;
} sample;

/* What is at a guess. reach: there is a root of f within it in t, and one only in a part of it. */
typedef struct {
    double t;
    double reach;
    double L;
    double x;
    double y;
    double error;
    int stability;
    int taken;   /* an equilibrium of the regime, by the numbers */
    int certain; /* that it is, with its kind and digits, or that it is none */
} candidate;

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

/* cos x and sin x for 0 < x < pi, within one unit in the last place (0.80 measured), without a branch. x = k pi/2 + (r + tail)
 * with |r| <= pi/4, by pi/2 in two parts, of which the first leaves nothing to round; then the polynomials of fdlibm's k_sin.c
 * and k_cos.c. */
INLINE void cosine_and_sine(double x, double *cosine, double *sine) {
    const double half_pi = 1.57079632679489655800e+00;
    const double rest = 6.12323399573676603587e-17;
    const double k = ((x > 0.78539816339744831) ? 1.0 : 0.0) + ((x > 2.3561944901923448) ? 1.0 : 0.0);
    const double near = x - k * half_pi;
    const double r = near - k * rest;
    const double tail = (near - r) - k * rest;
    const double z = r * r;
    const double odd = 8.33333333332248946124e-03 +
                       z * (-1.98412698298579493134e-04 +
                            z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
    const double s = r - ((z * (0.5 * tail - z * r * odd) - tail) - z * r * -1.66666666666666324348e-01);
    const double even =
        4.16666666666666019037e-02 +
        z * (-1.38888888888741095749e-03 +
             z * (2.48015872894767294178e-05 +
                  z * (-2.75573143513906633035e-07 + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11))));
    const double half = 0.5 * z;
    const double top = 1.0 - half;
    const double c = top + (((1.0 - top) - half) + (z * z * even - r * tail));
    const double s_or_c = (k == 1.0) ? c : s;
    *sine = (k > 1.0) ? 0.0 - s : s_or_c;
    const double c_or_s = (k == 1.0) ? 0.0 - s : c;
    *cosine = (k > 1.0) ? 0.0 - c : c_or_s;
}

static int allowed(const spragsym_parameters *given) {
    const double pi = 3.14159265358979323846;
    /* Written so that a NaN fails. */
    return given->theta0 > 0.0 && given->theta0 < pi && given->mu0 >= 0.0 && given->kappa > 0.0 && given->alpha >= 0.0 &&
           given->sigma > 0.0 && given->beta >= 0.0 && isfinite(given->mu0) && isfinite(given->kappa) &&
           isfinite(given->alpha) && isfinite(given->sigma) && isfinite(given->beta);
}

spragsym_status spragsym_prepare(const spragsym_parameters *parameters, spragsym_model *model) {
    if (!parameters || !model || !allowed(parameters)) {
        return SPRAGSYM_BAD_INPUT;
    }
    cosine_and_sine(parameters->theta0, &model->cos0, &model->sin0);
    model->mu0 = parameters->mu0;
    model->kappa = parameters->kappa;
    model->alpha = parameters->alpha;
    model->sigma = parameters->sigma;
    model->beta = parameters->beta;
    return SPRAGSYM_OK;
}

/* From here to `examine` there is no branch and no loop that stays one, so that many points can be worked on side by side:
 * both sides of a choice are computed, and conditions are joined by & and |. */

/* Over max(1, |exact value|), which may be smaller than the value. */
INLINE double relative(double error, double value) { return error / larger(1.0, fabs(value) - error); }

INLINE int normal(double parameter) { return (parameter > SMALLEST_PARAMETER) | (parameter <= 0.0); }

/* Coefficients of f over the largest of them, with error bounds. */
INLINE line scaled_line(const spragsym_model *model, double nbar) {
    double value[4];
    double error[4];
    line f;
    algebra_f_coefficients(model->cos0, model->sin0, model->mu0, model->kappa, model->alpha, model->sigma, model->beta, nbar,
                           value);
    bound_f_coefficients(model->cos0, model->sin0, model->mu0, model->kappa, model->alpha, model->sigma, model->beta, nbar,
                         error);
    const double scale = larger(larger(fabs(value[0]), fabs(value[1])), larger(fabs(value[2]), fabs(value[3])));
    const double sum = value[0] + value[1] + value[2] + value[3] + error[0] + error[1] + error[2] + error[3];
    const double inverse = 1.0 / scale;
    for (int i = 0; i < 4; i++) {
        f.value[i] = value[i] * inverse;
        f.error[i] = error[i] * inverse + 2.0 * DBL_EPSILON * fabs(f.value[i]);
    }
    curvature_f(f.value[0], f.value[1], f.value[2], f.value[3], &f.curvature);
    f.curvature *= 1.0001;
    f.carried = (scale > SMALLEST_SCALE) & (scale < LARGEST_SCALE) & (fabs(sum) < HUGE_VAL) &
                (f.value[1] <= 0.0 - SMALLEST_RATIO);
    f.sound = (larger(larger(f.error[0], f.error[1]), larger(f.error[2], f.error[3])) < LARGEST_ERROR) & normal(model->sin0) &
              normal(model->mu0) & normal(model->kappa) & normal(model->alpha) & normal(model->sigma) & normal(model->beta);
    return f;
}

/* Cube root of x > 0: a third of the exponent by the bits, which is good to a few percent, then Halley's method. */
INLINE double cube_root(double x) {
    union {
        double number;
        uint64_t bits;
    } start;
    start.number = x;
    uint64_t third = start.bits >> 2;
    third += third >> 2;
    third += third >> 4;
    third += third >> 8;
    start.bits = third + UINT64_C(3071306043645493248);
    double root = start.number;
    for (int i = 0; i < CUBE_ROOT_STEPS; i++) {
        const double cube = root * root * root;
        root *= (cube + 2.0 * x) / (2.0 * cube + x);
    }
    return root;
}

/* The root of z^3 + P z + Q of largest magnitude: the one that no other root is close to. */
INLINE double outermost(double P, double Q) {
    const double third = P / 3.0;
    const double half = 0.5 * fabs(Q);
    const double inside = half * half + third * third * third;
    /* One real root: Cardano. */
    const double radical = cube_root(half + sqrt(larger(inside, 0.0)) + DBL_MIN);
    const double alone = radical - third / radical;
    /* Three: 2 cos(acos(cosine)/3) is the root of v^3 - 3 v = 2 cosine next to this chord. */
    const double radius = sqrt(larger(0.0 - third, DBL_MIN));
    const double cosine = smaller(half / (radius * radius * radius), 1.0);
    double v = 1.7320508075688772 + 0.26794919243112270 * cosine;
    for (int i = 0; i < CHORD_STEPS; i++) {
        v -= (v * v * v - 3.0 * v - 2.0 * cosine) / (3.0 * v * v - 3.0);
    }
    const double z = (inside >= 0.0) ? alone : radius * v;
    return (Q > 0.0) ? 0.0 - z : z;
}

/* That root of the resolvent itself, to full relative accuracy, which the shift of the depressed cubic may have cost. */
INLINE double isolated_root(const double cubic[3], const double depressed[2]) {
    double isolated = outermost(depressed[0], depressed[1]) - cubic[2] / 3.0;
    for (int i = 0; i < CUBIC_STEPS; i++) {
        const double value = ((isolated + cubic[2]) * isolated + cubic[1]) * isolated + cubic[0];
        const double slope = (3.0 * isolated + 2.0 * cubic[2]) * isolated + cubic[1];
        const double step = value / slope;
        isolated -= (fabs(step) < HUGE_VAL) ? step : 0.0;
    }
    return isolated;
}

/* One Newton step on both factors at once: what F1 F2 lacks of t^4 + A3 t^3 + A2 t^2 + A1 t - 1, divided by F2 modulo F1.
 * q1 q2 = -1 is kept by setting the smaller from the larger. */
INLINE factors polish(double A1, double A2, double A3, factors F) {
    const double R3 = A3 - (F.p1 + F.p2);
    const double R2 = A2 - (F.q1 + F.q2 + F.p1 * F.p2);
    const double R1 = A1 - (F.p1 * F.q2 + F.p2 * F.q1);
    const double R0 = 0.0 - 1.0 - F.q1 * F.q2;
    const double r = R1 - F.p1 * R2 + (F.p1 * F.p1 - F.q1) * R3;
    const double s = R0 - F.q1 * R2 + F.p1 * F.q1 * R3;
    const double u = F.p2 - F.p1;
    const double v = F.q2 - F.q1;
    const double inverse = 1.0 / (v * v - F.p1 * u * v + F.q1 * u * u);
    const double step_p1 = (r * v - s * u) * inverse;
    const double step_q1 = (r * u * F.q1 + s * (v - F.p1 * u)) * inverse;
    const double step_p2 = R3 - step_p1;
    const double step_q2 = R2 - step_q1 - F.p2 * step_p1 - F.p1 * step_p2;
    /* Where three roots meet the factors share one, and the step is none. */
    const int sound = (F.q1 + step_q1 < 0.0) & (F.q2 + step_q2 > 0.0) & (fabs(step_p1 + step_p2 + step_q1 + step_q2) < HUGE_VAL);
    F.p1 += sound ? step_p1 : 0.0;
    F.q1 += sound ? step_q1 : 0.0;
    F.p2 += sound ? step_p2 : 0.0;
    F.q2 += sound ? step_q2 : 0.0;
    const int low = 0.0 - F.q1 >= F.q2;
    const double other = 0.0 - 1.0 / (low ? F.q1 : F.q2);
    F.q1 = low ? F.q1 : other;
    F.q2 = low ? other : F.q2;
    return F;
}

/* Two quadratic factors of the quartic in t from the isolated root of its resolvent: a close pair of roots ends up together,
 * in the second. */
INLINE factors factorize(const double e[5], double resolvent_root) {
    const double b = e[0];
    const double inverse = 1.0 / e[4];
    const double A1 = e[1] * inverse;
    const double A2 = e[2] * inverse;
    const double A3 = e[3] * inverse;
    const double twice = 2.0 * resolvent_root;
    const double sum = fabs(twice) + sqrt(twice * twice + b * b);
    const double quotient = (twice < 0.0) ? b / sum : sum / b;
    factors F;
    F.q1 = (quotient < 0.0) ? quotient : 0.0 - DBL_EPSILON;
    F.q2 = 0.0 - 1.0 / F.q1;
    const double over_gap = 1.0 / (F.q2 - F.q1);
    F.p1 = (A1 - A3 * F.q1) * over_gap;
    F.p2 = (A3 * F.q2 - A1) * over_gap;
    for (int i = 0; i < FACTOR_STEPS; i++) {
        F = polish(A1, A2, A3, F);
    }
    return F;
}

/* The roots of t^2 + p t + q without cancellation; whether they are real. */
INLINE int quadratic_roots(double p, double q, double roots[2]) {
    const double half = 0.5 * p;
    const double inside = half * half - q;
    const double radical = sqrt(larger(inside, 0.0));
    const double outer = (half > 0.0) ? 0.0 - half - radical : radical - half;
    roots[0] = outer;
    roots[1] = q / outer;
    return inside >= 0.0;
}

/* The quartic e0 + e1 t + ... of f in its factors. Its roots multiply to -1: four or two of them are real, two if its
 * discriminant is negative, which is that of its resolvent, -4 P^3 - 27 Q^2. With e0 < 0 < e4 and e2 <= 0, Descartes' rule of
 * signs leaves one positive root if e1 < 0. */
INLINE quartic split(const line *f) {
    const double *const c = f->value;
    const double *const off = f->error;
    double e[5];
    double cubic[3];
    double depressed[2];
    double error[2];
    quartic it;
    algebra_t_quartic(c[0], c[1], c[2], c[3], e);
    algebra_resolvent(c[0], c[1], c[2], c[3], cubic);
    algebra_depressed(c[0], c[1], c[2], c[3], depressed);
    bound_depressed(c[0], c[1], c[2], c[3], off[0], off[1], off[2], off[3], error);
    it.F = factorize(e, isolated_root(cubic, depressed));
    const double P = fabs(depressed[0]);
    const double Q = fabs(depressed[1]);
    const double cube = 4.0 * P * P * P;
    const double squared = 27.0 * Q * Q;
    const double discriminant = ((depressed[0] < 0.0) ? cube : 0.0 - cube) - squared;
    const double from_P = (12.0 * P * P + (12.0 * P + 4.0 * error[0]) * error[0]) * error[0];
    const double from_Q = (54.0 * Q + 27.0 * error[1]) * error[1];
    const double bound = from_P + from_Q + 8.0 * DBL_EPSILON * (cube + squared) + DBL_MIN;
    it.two = discriminant < 0.0 - bound;
    it.lone = e[1] < 0.0 - 2.0 * (off[0] + off[2]) - 4.0 * DBL_EPSILON * (fabs(c[0]) + fabs(c[2]));
    return it;
}

/* In contact only positive roots matter: with sin theta < 0 < L, y = sin theta0 - L sin theta would be positive. The first
 * factor has a root of either sign; those of the second are complex, or both negative, or both positive. */
INLINE guesses guess(const quartic *it, double nbar) {
    const int contact = nbar > 0.0;
    const int spared = it->two | (contact & it->lone);
    double first[2];
    double second[2];
    guesses all;
    (void)quadratic_roots(it->F.p1, it->F.q1, first);
    const int real = quadratic_roots(it->F.p2, it->F.q2, second);
    const int more = real & !spared;
    all.count = (contact ? 1 : 2) + (more ? 2 : 0);
    all.certain = spared | real;
    /* A sorting network; what is left out goes to the end. */
    const double a = contact ? HUGE_VAL : smaller(first[0], first[1]);
    const double b = larger(first[0], first[1]);
    const double c = more ? second[0] : HUGE_VAL;
    const double d = more ? second[1] : HUGE_VAL;
    const double inner = larger(smaller(a, b), smaller(c, d));
    const double outer = smaller(larger(a, b), larger(c, d));
    all.t[0] = smaller(smaller(a, b), smaller(c, d));
    all.t[1] = smaller(inner, outer);
    all.t[2] = larger(inner, outer);
    all.t[3] = larger(larger(a, b), larger(c, d));
    return all;
}

/* f at tan(theta/2) = t with bounds on its errors. */
INLINE sample look(const line *f, double t) {
    const double *const c = f->value;
    const double *const e = f->error;
    const double over = 1.0 / (1.0 + t * t);
    sample at;
    at.cosine = (1.0 - t) * (1.0 + t) * over;
    at.sine = 2.0 * t * over;
    algebra_f(at.cosine, at.sine, c[0], c[1], c[2], c[3], &at.value);
    bound_f(at.cosine, at.sine, c[0], c[1], c[2], c[3], e[0], e[1], e[2], e[3], &at.value_error);
    algebra_f_slope(at.cosine, at.sine, c[0], c[1], c[2], c[3], &at.slope);
    bound_f_slope(at.cosine, at.sine, c[0], c[1], c[2], c[3], e[0], e[1], e[2], e[3], &at.slope_error);
    return at;
}

/* A Newton step on f, if it is sound: the root stands alone, and f is above its rounding error. */
INLINE double improve(const line *f, double t) {
    const sample at = look(f, t);
    const int sound = (fabs(at.value) > at.value_error) & (4.0 * f->curvature * fabs(at.value) < at.slope * at.slope);
    const double step = 0.5 * at.value / at.slope * (1.0 + t * t);
    return t - (sound ? step : 0.0);
}

/* The equilibrium at a root of f near a guess. Where Kantorovich's theorem holds for f with all its rounding errors there is
 * exactly one root within the radius. */
INLINE candidate examine(const spragsym_model *model, const line *f, double guessed, double nbar) {
    const double t = improve(f, guessed);
    const sample here = look(f, t);
    const double cosine = here.cosine;
    const double sine = here.sine;
    double state[3];
    double state_error[3];
    double measure[3];
    double measure_error[3];
    candidate at;
    const double steep = fabs(here.slope) - here.slope_error;
    const double step = (fabs(here.value) + here.value_error) / steep;
    const double h = f->curvature * step / steep;
    const double radius = step / (1.0 - h);
    const int proved = f->sound & (steep > 0.0) & (h <= 0.5);

    algebra_state(cosine, sine, model->cos0, model->sin0, model->kappa, model->sigma, model->beta, nbar, state);
    bound_state(cosine, sine, model->cos0, model->sin0, model->kappa, model->sigma, model->beta, nbar, radius, state_error);
    /* The bounds are of second order in the error of the angle. While that is small beside sin theta they are good to a
     * thousandth, what is proved stays on one side of sin theta = 0, and in t = tan(theta/2) it grows as reach has it. */
    for (int i = 0; i < 3; i++) {
        state_error[i] *= 1.001;
    }
    const int bounded = proved & (radius < 1e-3 * fabs(sine)) & (state_error[0] + state_error[1] + state_error[2] < HUGE_VAL);
    const int finite = fabs(state[0] + state[1] + state[2]) < HUGE_VAL;
    const int contact = nbar > 0.0;
    const double clear = contact ? 0.0 - state[2] : state[2];
    const int member = (state[0] > state_error[0]) & (clear > state_error[2]);
    const int outsider = (state[0] < 0.0 - state_error[0]) | (clear < 0.0 - state_error[2]);
    at.taken = finite & (state[0] > 0.0) & ((clear > 0.0) | (!contact & (clear >= 0.0)));

    /* Eq. (27), with the sign of f', which is that of det K. */
    algebra_measures(cosine, sine, state[0], model->mu0, model->alpha, model->sigma, model->beta, nbar, measure);
    bound_measures(cosine, sine, state[0], model->mu0, model->alpha, model->sigma, model->beta, nbar, radius, state_error[0],
                   measure_error);
    const int saddle = here.slope < 0.0;
    const int flutter = !saddle & (measure[2] < 0.0);
    const int close = state_error[0] < 1e-3 * fabs(state[0]); /* bounds of first order in the error of L */
    const int decided = (fabs(measure[2]) > measure_error[2]) & (flutter | (fabs(measure[0]) > measure_error[0]));
    const int known = saddle | (close & decided);
    at.stability = (saddle | !(measure[0] > 0.0)) ? SPRAGSYM_DIVERGENT : SPRAGSYM_STABLE;
    at.stability = flutter ? SPRAGSYM_FLUTTER : at.stability;

    at.t = t;
    /* In t the radius is (1 + t^2)/2 times that of the angle; twice that covers its growth. */
    at.reach = radius * (1.0 + t * t);
    at.L = state[0];
    at.x = state[1];
    at.y = state[2];
    const double error = larger(larger(radius + 8.0 * DBL_EPSILON, relative(state_error[0], state[0])),
                                larger(relative(state_error[1], state[1]), relative(state_error[2], state[2])));
    at.error = bounded ? error : HUGE_VAL;
    at.certain = bounded & (outsider | (member & known & (error <= TOLERANCE)));
    return at;
}

/* The equilibria of a point as they are written, root by root in ascending order; end: of the last root's reach, and to begin
 * with of what no root may be in. */
typedef struct {
    double end;
    int count;
    int certain;
} tally;

static tally nothing_yet(double nbar, int certain) {
    tally sum;
    sum.end = (nbar > 0.0) ? 0.0 : 0.0 - HUGE_VAL;
    sum.count = 0;
    sum.certain = certain;
    return sum;
}

static void add(const candidate *at, tally *sum, spragsym_equilibrium equilibria[SPRAGSYM_MAX_EQUILIBRIA]) {
    sum->certain = sum->certain && at->certain && at->t - at->reach > sum->end;
    sum->end = at->t + at->reach;
    if (at->taken) {
        const spragsym_equilibrium found = {2.0 * atan(at->t), at->L, at->x, at->y, at->error, (spragsym_stability)at->stability};
        int place = sum->count++;
        /* Roots that may be one can have changed places. */
        for (int i = 1; i < SPRAGSYM_MAX_EQUILIBRIA; i++) {
            if (place > 0 && equilibria[place - 1].theta > found.theta) {
                equilibria[place] = equilibria[place - 1];
                place--;
            }
        }
        equilibria[place] = found;
    }
}

/* All roots seen: whether the count stands, which in contact is one or three. */
static int stands(const tally *sum, double nbar) { return sum->certain && (!(nbar > 0.0) || sum->count % 2 == 1); }

static void clear_from(int count, spragsym_equilibrium equilibria[SPRAGSYM_MAX_EQUILIBRIA]) {
    const spragsym_equilibrium none = {0.0, 0.0, 0.0, 0.0, 0.0, SPRAGSYM_NONE};
    for (int i = count; i < SPRAGSYM_MAX_EQUILIBRIA; i++) {
        equilibria[i] = none;
    }
}

spragsym_status spragsym_equilibria(const spragsym_model *model, spragsym_regime regime,
                                    spragsym_equilibrium equilibria[SPRAGSYM_MAX_EQUILIBRIA], int *count) {
    if (!model || !equilibria || !count || (regime != SPRAGSYM_CONTACT && regime != SPRAGSYM_LIFTOFF)) {
        return SPRAGSYM_BAD_INPUT;
    }
    const double nbar = (regime == SPRAGSYM_CONTACT) ? 1.0 : 0.0;
    const line f = scaled_line(model, nbar);
    if (!f.carried) {
        return SPRAGSYM_OUT_OF_RANGE;
    }
    const quartic it = split(&f);
    const guesses all = guess(&it, nbar);
    tally sum = nothing_yet(nbar, all.certain);
    for (int i = 0; i < MAX_ROOTS; i++) {
        if (i < all.count) {
            const candidate at = examine(model, &f, all.t[i], nbar);
            add(&at, &sum, equilibria);
        }
    }
    clear_from(sum.count, equilibria);
    *count = sum.count;
    return stands(&sum, nbar) ? SPRAGSYM_OK : SPRAGSYM_UNCERTAIN;
}

/* Models in columns. */
typedef struct {
    double theta0[BLOCK];
    double cos0[BLOCK];
    double sin0[BLOCK];
    double mu0[BLOCK];
    double kappa[BLOCK];
    double alpha[BLOCK];
    double sigma[BLOCK];
    double beta[BLOCK];
    double t[MAX_ROOTS][BLOCK];
    int carried[BLOCK];
    int count[BLOCK];
    int certain[BLOCK];
} point_columns;

/* Guesses with their models, and what is there, in columns. */
typedef struct {
    double cos0[LANES];
    double sin0[LANES];
    double mu0[LANES];
    double kappa[LANES];
    double alpha[LANES];
    double sigma[LANES];
    double beta[LANES];
    double t[LANES];
    double reach[LANES];
    double L[LANES];
    double x[LANES];
    double y[LANES];
    double error[LANES];
    int stability[LANES];
    int taken[LANES];
    int certain[LANES];
} root_columns;

static void guess_columns(double nbar, point_columns *p) {
    for (int i = 0; i < BLOCK; i++) {
        cosine_and_sine(p->theta0[i], &p->cos0[i], &p->sin0[i]);
        const spragsym_model model = {p->cos0[i], p->sin0[i], p->mu0[i], p->kappa[i], p->alpha[i], p->sigma[i], p->beta[i]};
        const line f = scaled_line(&model, nbar);
        const quartic it = split(&f);
        const guesses all = guess(&it, nbar);
        p->t[0][i] = all.t[0];
        p->t[1][i] = all.t[1];
        p->t[2][i] = all.t[2];
        p->t[3][i] = all.t[3];
        p->carried[i] = f.carried;
        p->count[i] = all.count;
        p->certain[i] = all.certain;
    }
}

static void examine_columns(double nbar, root_columns *r) {
    for (int i = 0; i < LANES; i++) {
        const spragsym_model model = {r->cos0[i], r->sin0[i], r->mu0[i], r->kappa[i], r->alpha[i], r->sigma[i], r->beta[i]};
        const line f = scaled_line(&model, nbar);
        const candidate at = examine(&model, &f, r->t[i], nbar);
        r->t[i] = at.t;
        r->reach[i] = at.reach;
        r->L[i] = at.L;
        r->x[i] = at.x;
        r->y[i] = at.y;
        r->error[i] = at.error;
        r->stability[i] = at.stability;
        r->taken[i] = at.taken;
        r->certain[i] = at.certain;
    }
}

/* Parameters into columns; points that are refused give way to a harmless one. */
static void load(int points, const spragsym_parameters given[], spragsym_status statuses[], point_columns *p) {
    const spragsym_parameters harmless = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    for (int i = 0; i < BLOCK; i++) {
        const int good = i < points && allowed(&given[i]);
        const spragsym_parameters *const from = good ? &given[i] : &harmless;
        p->theta0[i] = from->theta0;
        p->mu0[i] = from->mu0;
        p->kappa[i] = from->kappa;
        p->alpha[i] = from->alpha;
        p->sigma[i] = from->sigma;
        p->beta[i] = from->beta;
        if (i < points) {
            statuses[i] = good ? SPRAGSYM_OK : SPRAGSYM_BAD_INPUT;
        }
    }
}

/* The guesses of all points one after the other; how many. Points that double can't carry have none. */
static int line_up(int points, spragsym_status statuses[], const point_columns *p, root_columns groups[GROUPS]) {
    int total = 0;
    for (int i = 0; i < BLOCK; i++) {
        if (i < points && statuses[i] == SPRAGSYM_OK && !p->carried[i]) {
            statuses[i] = SPRAGSYM_OUT_OF_RANGE;
        }
        const int count = (i < points && statuses[i] == SPRAGSYM_OK) ? p->count[i] : 0;
        for (int j = 0; j < MAX_ROOTS; j++) {
            if (j < count) {
                root_columns *const r = &groups[total / LANES];
                const int lane = total % LANES;
                r->cos0[lane] = p->cos0[i];
                r->sin0[lane] = p->sin0[i];
                r->mu0[lane] = p->mu0[i];
                r->kappa[lane] = p->kappa[i];
                r->alpha[lane] = p->alpha[i];
                r->sigma[lane] = p->sigma[i];
                r->beta[lane] = p->beta[i];
                r->t[lane] = p->t[j][i];
                total++;
            }
        }
    }
    return total;
}

/* The answers back to their points; the largest status. */
static spragsym_status unload(double nbar, int points, const point_columns *p, const root_columns groups[GROUPS],
                              spragsym_equilibrium equilibria[][SPRAGSYM_MAX_EQUILIBRIA], int counts[],
                              spragsym_status statuses[]) {
    spragsym_status worst = SPRAGSYM_OK;
    int next = 0;
    for (int i = 0; i < BLOCK; i++) {
        if (i < points) {
            tally sum = nothing_yet(nbar, p->certain[i]);
            const int count = (statuses[i] == SPRAGSYM_OK) ? p->count[i] : 0;
            for (int j = 0; j < MAX_ROOTS; j++) {
                if (j < count) {
                    const root_columns *const r = &groups[next / LANES];
                    const int lane = next % LANES;
                    const candidate at = {r->t[lane], r->reach[lane], r->L[lane], r->x[lane], r->y[lane], r->error[lane],
                                          r->stability[lane], r->taken[lane], r->certain[lane]};
                    add(&at, &sum, equilibria[i]);
                    next++;
                }
            }
            clear_from(sum.count, equilibria[i]);
            counts[i] = sum.count;
            if (statuses[i] == SPRAGSYM_OK && !stands(&sum, nbar)) {
                statuses[i] = SPRAGSYM_UNCERTAIN;
            }
            worst = (statuses[i] > worst) ? statuses[i] : worst;
        }
    }
    return worst;
}

spragsym_status spragsym_equilibria_batch(size_t points, const spragsym_parameters given[], spragsym_regime regime,
                                          spragsym_equilibrium equilibria[][SPRAGSYM_MAX_EQUILIBRIA], int counts[],
                                          spragsym_status statuses[]) {
    root_columns groups[GROUPS];
    point_columns p;
    spragsym_status worst = SPRAGSYM_OK;
    const int missing = !given || !equilibria || !counts || !statuses;
    if ((points > 0 && missing) || (regime != SPRAGSYM_CONTACT && regime != SPRAGSYM_LIFTOFF)) {
        return SPRAGSYM_BAD_INPUT;
    }
    const double nbar = (regime == SPRAGSYM_CONTACT) ? 1.0 : 0.0;
    /* Lanes that no root is in are computed too: with old numbers, but with numbers. */
    memset(groups, 0, sizeof groups);
    for (size_t start = 0; start < points; start += BLOCK) {
        const int length = (points - start < BLOCK) ? (int)(points - start) : BLOCK;
        load(length, given + start, statuses + start, &p);
        guess_columns(nbar, &p);
        const int total = line_up(length, statuses + start, &p, groups);
        for (int i = 0; i < GROUPS; i++) {
            if (i * LANES < total) {
                examine_columns(nbar, &groups[i]);
            }
        }
        const spragsym_status status =
            unload(nbar, length, &p, groups, equilibria + start, counts + start, statuses + start);
        worst = (status > worst) ? status : worst;
    }
    return worst;
}
"""
