/* ----------------------------------------------------------------------------------------------- motion */

#define PIECES 3
#define SECANTS 2

/* What the motion needs beside its state: the smooth regime it is in. */
typedef struct {
    const spragsym_model *model;
    double V, d, nbar, side;
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
    double k1[4], k2[4], k3[4], k4[4], middle[4];
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
static int first_crossing(const double before[2], const double after[2], double *share) {
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
    double next[4], before[2], after[2], share;
    distances(in, state, before);
    runge_kutta(in, h, state, next);
    distances(in, next, after);
    const int kink = first_crossing(before, after, &share);
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
