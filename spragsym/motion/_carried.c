/* Integration of the article's motion in one mode (contact, side of sliding, branch of the friction
 * law) by DOP853, up to the next border of the mode. Each step is that of SciPy's DOP853.
 *
 * carry(constants, mode, limits, tables, unit, state, clock, times, states)
 *     -> (outcome, border, steps, kept)
 *
 * All arguments are buffers of doubles.
 *     constants: the nine constants of the vector field.
 *     mode: contact, side, near, reach, width, gap.
 *     limits: rtol, atol, end time, time at which samples begin, maximal number of steps.
 *     tables: A, B, C, E3, E5, A_EXTRA, C_EXTRA, D of the method, one after the other.
 *     unit: points in [0, 1] at which each step is sampled.
 *     state, clock: the state; time and length of the next step. Both are updated.
 *     times, states: the samples, with room for a number of steps.
 *
 * The outcome is one of those below, `border` the index of the border that was passed, `steps` the
 * number of steps, and `kept` that of the steps with samples. */
#include "_arrays.h"

#include "spragsym.c"

enum { ENDED,
    PASSED,
    FULL,
    TOO_SMALL,
    TOO_MANY };

#define STAGES 12
#define EXTENDED 16
#define POWERS 7
#define SEARCHED 8
#define BORDERS 3
#define LARGEST_EXPONENT 100.0

typedef struct {
    const double *constants;
    const double *mode;
} field;

typedef struct {
    const double *A, *B, *C, *E3, *E5, *A_extra, *C_extra, *D;
} tables;

/* Dense output of one step. */
typedef struct {
    double begin;
    double length;
    double from[4];
    double F[POWERS][4];
} dense;

/* Belt speed with which the generated field evaluates the friction law (10).
 *
 * Where the mode is not `near`, the exponential of the law is negligible: a large sliding speed
 * makes it 0. Where it is, trial steps far beyond the border must not make it overflow. */
static double belt_speed(const field *in, double vx) {
    const double V = in->constants[7];
    const double d = in->constants[8];
    const double side = in->mode[1];
    if (!(in->mode[2] > 0.0)) {
        return vx + side * 1000.0 / d;
    }
    return (d * side * (V - vx) < -LARGEST_EXPONENT) ? vx - side * LARGEST_EXPONENT / d : V;
}

/* Vector field: the rates of x, y, x', y'. */
static void rate_of(const field *in, const double state[4], double rate[4]) {
    const double *const c = in->constants;
    rate[0] = state[2];
    rate[1] = state[3];
    algebra_regime_rhs(state[0], state[1], state[2], state[3], c[0], c[1], c[2], c[3], c[4], c[5],
        c[6], belt_speed(in, state[2]), c[8], in->mode[0], in->mode[1], rate + 2);
}

/* from + h Σ weights_s K_s over the first stages. */
static void combined(const double *from, double h, const double *weights, int stages,
    const double K[EXTENDED][4], double to[4]) {
    for (int j = 0; j < 4; j++) {
        double sum = 0.0;
        for (int s = 0; s < stages; s++) {
            sum += K[s][j] * weights[s];
        }
        to[j] = from[j] + h * sum;
    }
}

/* One step of length h; K[0] is the rate at its beginning. */
static void step(const field *in, const tables *it, const double from[4], double h,
    double K[EXTENDED][4], double to[4]) {
    double at[4];
    for (int s = 1; s < STAGES; s++) {
        combined(from, h, it->A + s * STAGES, s, (const double (*)[4])K, at);
        rate_of(in, at, K[s]);
    }
    combined(from, h, it->B, STAGES, (const double (*)[4])K, to);
    rate_of(in, to, K[STAGES]);
}

/* Estimated error relative to the tolerance, as SciPy's DOP853 computes it. */
static double error_of(const tables *it, const double K[EXTENDED][4], double h,
    const double from[4], const double to[4], double rtol, double atol) {
    double fifth = 0.0;
    double third = 0.0;
    for (int j = 0; j < 4; j++) {
        const double scale = atol + rtol * larger(fabs(from[j]), fabs(to[j]));
        double five = 0.0;
        double three = 0.0;
        for (int s = 0; s <= STAGES; s++) {
            five += K[s][j] * it->E5[s];
            three += K[s][j] * it->E3[s];
        }
        fifth += (five / scale) * (five / scale);
        third += (three / scale) * (three / scale);
    }
    if (fifth == 0.0 && third == 0.0) {
        return 0.0;
    }
    return fabs(h) * fifth / sqrt((fifth + 0.01 * third) * 4.0);
}

/* Dense output of a step, after three more stages. */
static void extend(const field *in, const tables *it, const double from[4], const double to[4],
    double begin, double h, double K[EXTENDED][4], dense *out) {
    double at[4];
    for (int s = STAGES + 1; s < EXTENDED; s++) {
        combined(from, h, it->A_extra + (s - STAGES - 1) * EXTENDED, s, (const double (*)[4])K, at);
        rate_of(in, at, K[s]);
    }
    out->begin = begin;
    out->length = h;
    for (int j = 0; j < 4; j++) {
        const double change = to[j] - from[j];
        out->from[j] = from[j];
        out->F[0][j] = change;
        out->F[1][j] = h * K[0][j] - change;
        out->F[2][j] = 2.0 * change - h * (K[STAGES][j] + K[0][j]);
        for (int i = 3; i < POWERS; i++) {
            double sum = 0.0;
            for (int s = 0; s < EXTENDED; s++) {
                sum += it->D[(i - 3) * EXTENDED + s] * K[s][j];
            }
            out->F[i][j] = h * sum;
        }
    }
}

/* State after a share of the step. */
static void state_at(const dense *it, double share, double state[4]) {
    for (int j = 0; j < 4; j++) {
        double y = 0.0;
        for (int i = POWERS - 1; i >= 0; i--) {
            y += it->F[i][j];
            y *= ((POWERS - 1 - i) % 2 == 0) ? share : 1.0 - share;
        }
        state[j] = y + it->from[j];
    }
}

/* Distance to one border of the mode, negative beyond it, and its rate.
 *
 * The borders are the contact's, the reversal of sliding, and the end of the branch of the law. */
static void clearance(
    const field *in, int border, const double state[4], double *distance, double *rate) {
    const double *const m = in->mode;
    const double slip = m[1] * (in->constants[7] - state[2]);
    const double d = in->constants[8];
    double derivative[4];
    if (border == 0) {
        const double inward = (m[0] > 0.0) ? -1.0 : 1.0;
        *distance = inward * state[1] + m[5];
        *rate = inward * state[3];
        return;
    }
    rate_of(in, state, derivative);
    if (border == 1) {
        *distance = slip + m[5];
        *rate = -m[1] * derivative[2];
        return;
    }
    const double farther = (m[2] > 0.0) ? -1.0 : 1.0;
    *distance = farther * (d * slip - m[3] - m[4] * m[2]);
    *rate = farther * d * -m[1] * derivative[2];
}

/* The distance to a border after a share of the step, or its rate. */
static double part_at(const field *in, int border, int of_rate, const dense *it, double share) {
    double state[4];
    double both[2];
    state_at(it, share, state);
    clearance(in, border, state, &both[0], &both[1]);
    return both[of_rate];
}

/* Share of the step at which the distance, or its rate, changes sign, by bisection. Returns the
 * upper end of the bracket, where the sign has changed. */
static double sign_change(
    const field *in, int border, int of_rate, const dense *it, double low, double high) {
    const int before = part_at(in, border, of_rate, it, low) < 0.0;
    if (before == (part_at(in, border, of_rate, it, high) < 0.0)) {
        return low; /* by rounding, the step begins beyond the border: the mode ends at once */
    }
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        if ((part_at(in, border, of_rate, it, middle) < 0.0) == before) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return high;
}

/* Share of the step at which a border is first passed; 2 if it is not.
 *
 * Between the points of the search, a minimum of the distance may lie beyond the border too. */
static double first_passing(const field *in, int border, const dense *it) {
    double value[SEARCHED + 1];
    double rate[SEARCHED + 1];
    double least = HUGE_VAL;
    double fastest = 0.0;
    for (int i = 0; i <= SEARCHED; i++) {
        double state[4];
        state_at(it, (double)i / SEARCHED, state);
        clearance(in, border, state, &value[i], &rate[i]);
        least = smaller(least, value[i]);
        fastest = larger(fastest, fabs(rate[i]));
    }
    if (least > fastest * it->length / SEARCHED) {
        return 2.0;
    }
    for (int i = 0; i < SEARCHED; i++) {
        const double low = (double)i / SEARCHED;
        const double high = (double)(i + 1) / SEARCHED;
        if (value[i + 1] < 0.0) {
            return sign_change(in, border, 0, it, low, high);
        }
        if (rate[i] < 0.0 && rate[i + 1] > 0.0) {
            const double lowest = sign_change(in, border, 1, it, low, high);
            if (part_at(in, border, 0, it, lowest) < 0.0) {
                return sign_change(in, border, 0, it, low, lowest);
            }
        }
    }
    return 2.0;
}

typedef struct {
    field in;
    tables method;
    const double *limits;
    const double *unit;
    Py_ssize_t points;
    double *state;
    double *clock;
    double *times;
    double *states;
    Py_ssize_t room;
    int border;
    Py_ssize_t steps;
    Py_ssize_t kept;
} job;

/* Store samples of a step up to a share of it, at times after the one at which samples begin. */
static void keep(job *it, const dense *polynomial, double share, double end) {
    const double wanted = it->limits[3];
    double from = 0.0;
    if (!(end > wanted)) {
        return;
    }
    if (wanted > polynomial->begin) {
        from = (wanted - polynomial->begin) / polynomial->length;
    }
    for (Py_ssize_t i = 0; i < it->points; i++) {
        const double at = (i == it->points - 1) ? share : from + it->unit[i] * (share - from);
        double state[4];
        it->times[it->kept * it->points + i] =
            (i == it->points - 1) ? end : polynomial->begin + at * polynomial->length;
        state_at(polynomial, at, state);
        for (int j = 0; j < 4; j++) {
            it->states[(it->kept * 4 + j) * it->points + i] = state[j];
        }
    }
    it->kept++;
}

/* Integrate to a border or to the end, and return the outcome. */
static int carry_on(job *it) {
    const double rtol = it->limits[0];
    const double atol = it->limits[1];
    const double bound = it->limits[2];
    double K[EXTENDED][4];
    double h = it->clock[1];
    memset(K, 0, sizeof K);
    rate_of(&it->in, it->state, K[0]);
    while (it->clock[0] < bound) {
        const double t = it->clock[0];
        const double least = 10.0 * (nextafter(t, HUGE_VAL) - t);
        double to[4];
        double end = t;
        int rejected = 0;
        dense polynomial;
        if (it->kept == it->room) {
            it->clock[1] = h;
            return FULL;
        }
        if ((double)it->steps >= it->limits[4]) {
            return TOO_MANY;
        }
        h = larger(h, least);
        for (;;) {
            if (!(h >= least)) {
                return TOO_SMALL;
            }
            end = smaller(t + h, bound);
            h = end - t;
            step(&it->in, &it->method, it->state, h, K, to);
            const double error =
                error_of(&it->method, (const double (*)[4])K, h, it->state, to, rtol, atol);
            const double eighth = 0.9 / sqrt(sqrt(sqrt(error)));
            if (error < 1.0) {
                double factor = (error == 0.0) ? 10.0 : smaller(10.0, eighth);
                factor = rejected ? smaller(1.0, factor) : factor;
                extend(&it->in, &it->method, it->state, to, t, h, K, &polynomial);
                h *= factor;
                break;
            }
            h *= (eighth > 0.2) ? eighth : 0.2;
            rejected = 1;
        }
        it->steps++;
        double share = 2.0;
        for (int border = 0; border < BORDERS; border++) {
            const double at = first_passing(&it->in, border, &polynomial);
            if (at < share) {
                share = at;
                it->border = border;
            }
        }
        it->clock[1] = h;
        if (share <= 1.0) {
            const double left = t + share * polynomial.length;
            keep(it, &polynomial, share, left);
            state_at(&polynomial, share, it->state);
            it->clock[0] = left;
            it->clock[1] = polynomial.length; /* as after a restart of SciPy's integrator */
            return PASSED;
        }
        keep(it, &polynomial, 1.0, end);
        it->clock[0] = end;
        for (int j = 0; j < 4; j++) {
            it->state[j] = to[j];
            K[0][j] = K[STAGES][j];
        }
    }
    return ENDED;
}

#define ARGUMENTS 9

static PyObject *carry(PyObject *module, PyObject *arguments) {
    const Py_ssize_t table =
        STAGES * STAGES + 2 * STAGES + 2 * (STAGES + 1) + 3 * EXTENDED + 3 + 4 * EXTENDED;
    Py_buffer view[ARGUMENTS];
    PyObject *given[ARGUMENTS];
    PyObject *result = NULL;
    (void)module;
    if (!PyArg_ParseTuple(arguments, "OOOOOOOOO", &given[0], &given[1], &given[2], &given[3],
            &given[4], &given[5], &given[6], &given[7], &given[8]) ||
        !hold(given, view, "dddddDDDD")) {
        return NULL;
    }
    const Py_ssize_t points = items_of(&view[4]);
    const Py_ssize_t room = points ? items_of(&view[7]) / points : 0;
    const Py_ssize_t sizes[ARGUMENTS] = {
        9, 6, 5, table, points, 4, 2, room * points, 4 * room * points};
    if (!points) {
        PyErr_SetString(PyExc_ValueError, "unit is empty; a step is sampled at one point at least");
    } else if (sizes_fit(view, sizes, ARGUMENTS)) {
        const double *at = (const double *)view[3].buf;
        job it;
        int outcome;
        memset(&it, 0, sizeof it);
        it.in.constants = (const double *)view[0].buf;
        it.in.mode = (const double *)view[1].buf;
        it.limits = (const double *)view[2].buf;
        it.method.A = at;
        it.method.B = it.method.A + STAGES * STAGES;
        it.method.C = it.method.B + STAGES;
        it.method.E3 = it.method.C + STAGES;
        it.method.E5 = it.method.E3 + STAGES + 1;
        it.method.A_extra = it.method.E5 + STAGES + 1;
        it.method.C_extra = it.method.A_extra + 3 * EXTENDED;
        it.method.D = it.method.C_extra + 3;
        it.unit = (const double *)view[4].buf;
        it.points = points;
        it.state = (double *)view[5].buf;
        it.clock = (double *)view[6].buf;
        it.times = (double *)view[7].buf;
        it.states = (double *)view[8].buf;
        it.room = room;
        Py_BEGIN_ALLOW_THREADS;
        outcome = carry_on(&it);
        Py_END_ALLOW_THREADS;
        result = Py_BuildValue("iinn", outcome, it.border, it.steps, it.kept);
    }
    release(view, ARGUMENTS);
    return result;
}

static PyMethodDef methods[] = {
    {"carry", carry, METH_VARARGS, "Integrate in one mode, up to a border of it or to the end."},
    {NULL, NULL, 0, NULL}};

static struct PyModuleDef definition = {PyModuleDef_HEAD_INIT, "_carried",
    "The generated motion, compiled.", -1, methods, NULL, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__carried(void) { return new_module(&definition); }
