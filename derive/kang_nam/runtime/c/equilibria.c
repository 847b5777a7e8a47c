/* ------------------------------------------------------------------------------------------- equilibria */
/*
 * Worst-case operations, counted in this text: + - * / and comparisons of doubles, then calls of libm.
 * - spragsym_prepare: @cost:spragsym_prepare@
 * - spragsym_equilibria: @cost:spragsym_equilibria@
 * - spragsym_equilibria_batch: @cost:spragsym_equilibria_batch@
 * - spragsym_critical_friction: @cost:spragsym_critical_friction@
 * - spragsym_step: @cost:spragsym_step@
 * - balance: @cost:balance@
 * - guesses: @cost:guesses@
 * - at_root: @cost:at_root@
 * - runge_kutta: @cost:runge_kutta@
 */

/* On x86-64 the two loops over columns are compiled for three generations of processors, of which the fastest that is there
 * runs: the same bits, since no operations are fused. Not under a sanitizer, which starts later than the choice is made. */
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && __GNUC__ >= 12 && defined(__STRICT_ANSI__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(SPRAGSYM_ONE_BUILD)
#define CLONED __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define CLONED
#endif

/* Error per value that SPRAGSYM_OK vouches for. */
#define TOLERANCE 1e-12
#define UNIT_ROUNDOFF (0.5 * DBL_EPSILON)
#define MAX_ROOTS 4
/* Points and roots that are worked on side by side, and groups of roots that a block of points can have. */
#define BLOCK 64
#define LANES 16
#define GROUPS 16
#if GROUPS * LANES != MAX_ROOTS * BLOCK
#error "spragsym: the groups must have room for every root of a block"
#endif

/* Without branches, so that columns of points are looked at side by side; written so that a NaN fails. */
static int allowed(const spragsym_parameters *given) {
    const double pi = 3.14159265358979323846;
    const int inside = (given->theta0 > 0.0) & (given->theta0 < pi) & (given->mu0 >= 0.0) & (given->kappa > 0.0) &
        (given->alpha >= 0.0) & (given->sigma > 0.0) & (given->beta >= 0.0);
    const int finite = (given->mu0 <= DBL_MAX) & (given->kappa <= DBL_MAX) & (given->alpha <= DBL_MAX) &
        (given->sigma <= DBL_MAX) & (given->beta <= DBL_MAX);
    return inside & finite;
}

spragsym_status spragsym_prepare(const spragsym_parameters *parameters, spragsym_model *model) {
    if (!parameters || !model || !allowed(parameters)) {
        return SPRAGSYM_BAD_INPUT;
    }
    const Direction undeformed = cosine_and_sine(parameters->theta0);
    const spragsym_model checked = {undeformed.cosine, undeformed.sine, parameters->mu0, parameters->kappa, parameters->alpha,
        parameters->sigma, parameters->beta, parameters->theta0};
    *model = checked;
    return SPRAGSYM_OK;
}

/* Columns: one array a quantity, so that many points or roots are worked on side by side. */
typedef struct {
    double theta0[BLOCK], cos0[BLOCK], sin0[BLOCK], mu0[BLOCK], kappa[BLOCK], alpha[BLOCK], sigma[BLOCK], beta[BLOCK];
    double nbar[BLOCK]; /* the same for all; gcc makes vectors of a choice only where what decides is in a column */
    double t[MAX_ROOTS][BLOCK], count[BLOCK];
    int certain[BLOCK], representable[BLOCK];
} point_columns;

/* Guessed roots with their points, and what is there. */
typedef struct {
    double cos0[LANES], sin0[LANES], mu0[LANES], kappa[LANES], alpha[LANES], sigma[LANES], beta[LANES];
    double t[LANES], theta[LANES], L[LANES], x[LANES], y[LANES], radius[LANES], error[LANES], code[LANES];
    int member[LANES], outsider[LANES], known[LANES];
} root_columns;

CLONED static void guess_columns(point_columns *p) {
    for (int i = 0; i < BLOCK; i++) {
        const Direction undeformed = cosine_and_sine(p->theta0[i]);
        const Point point = {undeformed.cosine, undeformed.sine, p->mu0[i], p->kappa[i],
            p->alpha[i], p->sigma[i], p->beta[i], p->nbar[i]};
        const LineBalance line = balance(point);
        const Guesses all = guesses(point, line, UNIT_ROUNDOFF);
        p->cos0[i] = undeformed.cosine;
        p->sin0[i] = undeformed.sine;
        p->t[0][i] = all.t0;
        p->t[1][i] = all.t1;
        p->t[2][i] = all.t2;
        p->t[3][i] = all.t3;
        p->count[i] = all.count;
        p->certain[i] = all.certain;
        p->representable[i] = representable(line);
    }
}

CLONED static void root_at_columns(double nbar, root_columns *r) {
    for (int i = 0; i < LANES; i++) {
        const Point point = {r->cos0[i], r->sin0[i], r->mu0[i], r->kappa[i], r->alpha[i], r->sigma[i], r->beta[i], nbar};
        const Root root = at_root(r->t[i], point, balance(point), UNIT_ROUNDOFF);
        r->theta[i] = 2.0 * arctangent(r->t[i]);
        r->L[i] = root.L;
        r->x[i] = root.x;
        r->y[i] = root.y;
        r->radius[i] = root.radius;
        r->error[i] = root.error;
        r->code[i] = root.code;
        r->member[i] = root.member;
        r->outsider[i] = root.outsider;
        r->known[i] = root.known;
    }
}

/* The equilibria of a point as they are written, root by root in ascending order. */
typedef struct {
    double nbar;
    Wide t;        /* of the last root */
    double radius; /* of the interval in theta that holds it */
    int roots, count, certain;
} tally;

static tally nothing_yet(double nbar, int certain) {
    const tally none = {nbar, {0.0, 0.0}, 0.0, 0, 0, certain};
    return none;
}

static int sure(const Root *at) { return at->outsider || (at->member && at->known && at->error <= TOLERANCE); }

static int is_positive_root(double t, const tally *sum) { return !(sum->nbar > 0.0) || t > 0.0; }

static void seen(Wide t, const Root *at, int separate, tally *sum) {
    sum->certain = sum->certain && sure(at) && separate;
    sum->t = t;
    sum->radius = at->radius;
    sum->roots++;
}

/* Two proved roots are different when the intervals that hold them are; in contact all lie above t = 0. */
static void see(double t, const Root *at, tally *sum) {
    const int separate = (sum->roots > 0) ? apart(sum->t.high, sum->radius, t, at->radius) : is_positive_root(t, sum);
    seen(paired(t, 0.0), at, separate, sum);
}

static void see_widely(Wide t, const Root *at, tally *sum) {
    const int separate = (sum->roots > 0) ? wide_apart(sum->t, sum->radius, t, at->radius) : is_positive_root(t.high, sum);
    seen(t, at, separate, sum);
}

static void add(double theta, const Root *at, tally *sum, spragsym_equilibrium equilibria[SPRAGSYM_MAX_EQUILIBRIA]) {
    const int contact = sum->nbar > 0.0;
    const double clear = contact ? -at->y : at->y;
    if (isfinite(at->L + at->x + at->y) && at->L > 0.0 && (clear > 0.0 || (!contact && clear >= 0.0))) {
        const double error = isfinite(at->error) ? at->error : HUGE_VAL;
        const spragsym_equilibrium found = {theta, at->L, at->x, at->y, error, (spragsym_stability)(int)at->code};
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
static int stands(const tally *sum) { return sum->certain && (!(sum->nbar > 0.0) || sum->count % 2 == 1); }

static void clear_from(int count, spragsym_equilibrium equilibria[SPRAGSYM_MAX_EQUILIBRIA]) {
    const spragsym_equilibrium none = {0.0, 0.0, 0.0, 0.0, 0.0, SPRAGSYM_NONE};
    for (int i = count; i < SPRAGSYM_MAX_EQUILIBRIA; i++) {
        equilibria[i] = none;
    }
}

/* Roundings of a double that theta, L, x and y are off by when they are stored: the arc tangent is within one unit in the
 * last place, and its argument is rounded. */
#define STORED (4.0 * UNIT_ROUNDOFF)
/* Points, and then roots, that are worked on side by side in double-double arithmetic. */
#define WIDE_LANES 8
#define WIDE_GROUPS 8
#if WIDE_GROUPS * WIDE_LANES != BLOCK
#error "spragsym: the groups must have room for every point of a block"
#endif

/* Points that double precision leaves open. */
typedef struct {
    double theta0[WIDE_LANES], mu0[WIDE_LANES], kappa[WIDE_LANES], alpha[WIDE_LANES], sigma[WIDE_LANES], beta[WIDE_LANES];
    double nbar[WIDE_LANES];
    SplitDirection undeformed[WIDE_LANES];
    double t_high[MAX_ROOTS][WIDE_LANES], t_low[MAX_ROOTS][WIDE_LANES], count[WIDE_LANES];
    int certain[WIDE_LANES];
} wide_points;

/* Guessed roots with their points, and what is there. */
typedef struct {
    SplitDirection undeformed[WIDE_LANES];
    double mu0[WIDE_LANES], kappa[WIDE_LANES], alpha[WIDE_LANES], sigma[WIDE_LANES], beta[WIDE_LANES], nbar[WIDE_LANES];
    double t_high[WIDE_LANES], t_low[WIDE_LANES], theta[WIDE_LANES];
    Root root[WIDE_LANES];
} wide_roots;

INLINE WidePoint widened(SplitDirection undeformed, double mu0, double kappa, double alpha, double sigma, double beta,
    double nbar) {
    const WidePoint point = {paired(undeformed.cosine_high, undeformed.cosine_low), paired(undeformed.sine_high, undeformed.sine_low),
        paired(mu0, 0.0), paired(kappa, 0.0), paired(alpha, 0.0), paired(sigma, 0.0), paired(beta, 0.0), paired(nbar, 0.0)};
    return point;
}

CLONED static void turn_widely(wide_points *p) {
    for (int i = 0; i < WIDE_LANES; i++) {
        p->undeformed[i] = dd_cosine_and_sine(p->theta0[i]);
    }
}

CLONED static void guess_widely(wide_points *p) {
    for (int i = 0; i < WIDE_LANES; i++) {
        const WidePoint point =
            widened(p->undeformed[i], p->mu0[i], p->kappa[i], p->alpha[i], p->sigma[i], p->beta[i], p->nbar[i]);
        const WideLineBalance line = wide_balance(point);
        const WideGuesses all = wide_guesses(point, line, WIDE_ROUNDOFF);
        p->t_high[0][i] = all.t0.high;
        p->t_high[1][i] = all.t1.high;
        p->t_high[2][i] = all.t2.high;
        p->t_high[3][i] = all.t3.high;
        p->t_low[0][i] = all.t0.low;
        p->t_low[1][i] = all.t1.low;
        p->t_low[2][i] = all.t2.low;
        p->t_low[3][i] = all.t3.low;
        p->count[i] = all.count;
        p->certain[i] = all.certain & wide_representable(line) & wide_moderate(point);
    }
}

CLONED static void root_at_widely(wide_roots *r) {
    for (int i = 0; i < WIDE_LANES; i++) {
        const WidePoint point =
            widened(r->undeformed[i], r->mu0[i], r->kappa[i], r->alpha[i], r->sigma[i], r->beta[i], r->nbar[i]);
        Root root = wide_at_root(paired(r->t_high[i], r->t_low[i]), point, wide_balance(point), WIDE_ROUNDOFF);
        root.error = root.error + STORED;
        r->theta[i] = 2.0 * arctangent(r->t_high[i]);
        r->root[i] = root;
    }
}

/* A point into a lane. */
static void set_widely(const spragsym_parameters *given, double nbar, int lane, wide_points *p) {
    p->theta0[lane] = given->theta0;
    p->mu0[lane] = given->mu0;
    p->kappa[lane] = given->kappa;
    p->alpha[lane] = given->alpha;
    p->sigma[lane] = given->sigma;
    p->beta[lane] = given->beta;
    p->nbar[lane] = nbar;
}

/* Roots of all certain points one after the other; how many. */
static int line_up_widely(const wide_points *p, wide_roots groups[MAX_ROOTS]) {
    int total = 0;
    for (int i = 0; i < WIDE_LANES; i++) {
        const int count = p->certain[i] ? (int)p->count[i] : 0;
        for (int j = 0; j < MAX_ROOTS; j++) {
            if (j < count) {
                wide_roots *const r = &groups[total / WIDE_LANES];
                const int lane = total % WIDE_LANES;
                r->undeformed[lane] = p->undeformed[i];
                r->mu0[lane] = p->mu0[i];
                r->kappa[lane] = p->kappa[i];
                r->alpha[lane] = p->alpha[i];
                r->sigma[lane] = p->sigma[i];
                r->beta[lane] = p->beta[i];
                r->nbar[lane] = p->nbar[i];
                r->t_high[lane] = p->t_high[j][i];
                r->t_low[lane] = p->t_low[j][i];
                total++;
            }
        }
    }
    return total;
}

/* What is at the roots of a group of points; what stands in lanes from `points` on has none. */
static void solve_widely(int points, wide_points *p, wide_roots groups[MAX_ROOTS]) {
    turn_widely(p);
    guess_widely(p);
    for (int i = 0; i < WIDE_LANES; i++) {
        p->certain[i] = i < points && p->certain[i];
    }
    const int total = line_up_widely(p, groups);
    for (int i = 0; i < MAX_ROOTS; i++) {
        if (i * WIDE_LANES < total) {
            root_at_widely(&groups[i]);
        }
    }
}

/* Writes what was found, if it stands, and says whether. */
static int settled(const tally *sum, spragsym_equilibrium found[SPRAGSYM_MAX_EQUILIBRIA], int *count,
    spragsym_equilibrium equilibria[SPRAGSYM_MAX_EQUILIBRIA]) {
    if (!stands(sum)) {
        return 0;
    }
    clear_from(sum->count, found);
    for (int i = 0; i < SPRAGSYM_MAX_EQUILIBRIA; i++) {
        equilibria[i] = found[i];
    }
    *count = sum->count;
    return 1;
}

/* The equilibria of one lane of a group, whose roots begin at `next`; whether they are settled, or else nothing is written. */
static int take_widely(const wide_points *p, const wide_roots groups[MAX_ROOTS], int lane, int next, int *count,
    spragsym_equilibrium equilibria[SPRAGSYM_MAX_EQUILIBRIA]) {
    spragsym_equilibrium found[SPRAGSYM_MAX_EQUILIBRIA];
    tally sum = nothing_yet(p->nbar[lane], p->certain[lane]);
    for (int j = 0; j < MAX_ROOTS; j++) {
        if (p->certain[lane] && (double)j < p->count[lane]) {
            const wide_roots *const r = &groups[(next + j) / WIDE_LANES];
            const int at = (next + j) % WIDE_LANES;
            see_widely(paired(r->t_high[at], r->t_low[at]), &r->root[at], &sum);
            add(r->theta[at], &r->root[at], &sum, found);
        }
    }
    return settled(&sum, found, count, equilibria);
}

/* One point that double precision leaves open. */
static int settled_widely(const spragsym_model *model, double nbar, int *count,
    spragsym_equilibrium equilibria[SPRAGSYM_MAX_EQUILIBRIA]) {
    const WidePoint point = widened(dd_cosine_and_sine(model->theta0), model->mu0, model->kappa, model->alpha, model->sigma,
        model->beta, nbar);
    const WideLineBalance line = wide_balance(point);
    const WideGuesses all = wide_guesses(point, line, WIDE_ROUNDOFF);
    const Wide t[MAX_ROOTS] = {all.t0, all.t1, all.t2, all.t3};
    spragsym_equilibrium found[SPRAGSYM_MAX_EQUILIBRIA];
    tally sum = nothing_yet(nbar, all.certain && wide_representable(line) && wide_moderate(point));
    for (int i = 0; i < MAX_ROOTS; i++) {
        if (sum.certain && (double)i < all.count) {
            Root root = wide_at_root(t[i], point, line, WIDE_ROUNDOFF);
            root.error = root.error + STORED;
            see_widely(t[i], &root, &sum);
            add(2.0 * arctangent(t[i].high), &root, &sum, found);
        }
    }
    return settled(&sum, found, count, equilibria);
}

spragsym_status spragsym_equilibria(const spragsym_model *model, spragsym_regime regime,
    spragsym_equilibrium equilibria[SPRAGSYM_MAX_EQUILIBRIA], int *count) {
    if (!model || !equilibria || !count || (regime != SPRAGSYM_CONTACT && regime != SPRAGSYM_LIFTOFF)) {
        return SPRAGSYM_BAD_INPUT;
    }
    const double nbar = (regime == SPRAGSYM_CONTACT) ? 1.0 : 0.0;
    const Point point = {model->cos0, model->sin0, model->mu0, model->kappa, model->alpha, model->sigma, model->beta, nbar};
    const LineBalance line = balance(point);
    if (!representable(line)) {
        return SPRAGSYM_OUT_OF_RANGE;
    }
    const Guesses all = guesses(point, line, UNIT_ROUNDOFF);
    const double t[MAX_ROOTS] = {all.t0, all.t1, all.t2, all.t3};
    tally sum = nothing_yet(nbar, all.certain);
    for (int i = 0; i < MAX_ROOTS; i++) {
        if ((double)i < all.count) {
            const Root root = at_root(t[i], point, line, UNIT_ROUNDOFF);
            see(t[i], &root, &sum);
            add(2.0 * arctangent(t[i]), &root, &sum, equilibria);
        }
    }
    clear_from(sum.count, equilibria);
    *count = sum.count;
    return (stands(&sum) || settled_widely(model, nbar, count, equilibria)) ? SPRAGSYM_OK : SPRAGSYM_UNCERTAIN;
}

/* The guesses of all points one after the other; how many. Points that are refused have none. */
static int line_up(int points, const int refused[BLOCK], const point_columns *p, root_columns groups[GROUPS]) {
    int total = 0;
    for (int i = 0; i < BLOCK; i++) {
        const int count = (i < points && !refused[i]) ? (int)p->count[i] : 0;
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

/* One root out of its columns. */
static Root taken_from(const root_columns *r, int lane) {
    const Root root = {r->L[lane], r->x[lane], r->y[lane], r->radius[lane], r->error[lane],
        r->member[lane], r->outsider[lane], r->code[lane], r->known[lane]};
    return root;
}

/* What is at every root of a block of points, whose guesses are there. */
static void solve_columns(double nbar, int points, const int refused[BLOCK], const point_columns *p,
    root_columns groups[GROUPS]) {
    const int total = line_up(points, refused, p, groups);
    for (int i = 0; i < GROUPS; i++) {
        if (i * LANES < total) {
            root_at_columns(nbar, &groups[i]);
        }
    }
}

/* Parameters into columns; points that are refused give way to a harmless one. */
static void load(double nbar, int points, const spragsym_parameters given[], spragsym_status statuses[],
    point_columns *p) {
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
        p->nbar[i] = nbar;
        if (i < points) {
            statuses[i] = good ? SPRAGSYM_OK : SPRAGSYM_BAD_INPUT;
        }
    }
}

/* Points whose quartic double can't carry are refused as well. */
static void refuse(int points, const point_columns *p, spragsym_status statuses[], int refused[BLOCK]) {
    for (int i = 0; i < BLOCK; i++) {
        refused[i] = 1;
        if (i < points) {
            if (statuses[i] == SPRAGSYM_OK && !p->representable[i]) {
                statuses[i] = SPRAGSYM_OUT_OF_RANGE;
            }
            refused[i] = statuses[i] != SPRAGSYM_OK;
        }
    }
}

/* The answers back to their points; the largest status. */
static spragsym_status unload(double nbar, int points, const point_columns *p, const root_columns groups[GROUPS],
    spragsym_equilibrium equilibria[][SPRAGSYM_MAX_EQUILIBRIA], int counts[], spragsym_status statuses[]) {
    spragsym_status worst = SPRAGSYM_OK;
    int next = 0;
    for (int i = 0; i < BLOCK; i++) {
        if (i < points) {
            tally sum = nothing_yet(nbar, p->certain[i]);
            const int count = (statuses[i] == SPRAGSYM_OK) ? (int)p->count[i] : 0;
            for (int j = 0; j < MAX_ROOTS; j++) {
                if (j < count) {
                    const root_columns *const r = &groups[next / LANES];
                    const int lane = next % LANES;
                    const Root root = taken_from(r, lane);
                    see(r->t[lane], &root, &sum);
                    add(r->theta[lane], &root, &sum, equilibria[i]);
                    next++;
                }
            }
            clear_from(sum.count, equilibria[i]);
            counts[i] = sum.count;
            if (statuses[i] == SPRAGSYM_OK && !stands(&sum)) {
                statuses[i] = SPRAGSYM_UNCERTAIN;
            }
            worst = (statuses[i] > worst) ? statuses[i] : worst;
        }
    }
    return worst;
}

/* Points that double precision left open, a group at a time; the largest status. */
static spragsym_status reconsider(double nbar, int points, const spragsym_parameters given[],
    spragsym_equilibrium equilibria[][SPRAGSYM_MAX_EQUILIBRIA], int counts[], spragsym_status statuses[]) {
    wide_points p;
    wide_roots groups[MAX_ROOTS];
    int place[BLOCK];
    int open = 0;
    for (int i = 0; i < BLOCK; i++) {
        if (i < points && statuses[i] == SPRAGSYM_UNCERTAIN) {
            place[open] = i;
            open++;
        }
    }
    memset(groups, 0, sizeof groups);
    for (int i = 0; i < WIDE_GROUPS; i++) {
        const int left = open - i * WIDE_LANES;
        if (left > 0) {
            const int filled = (left < WIDE_LANES) ? left : WIDE_LANES;
            const int *const at = place + i * WIDE_LANES;
            int next = 0;
            for (int j = 0; j < WIDE_LANES; j++) {
                set_widely(&given[at[j % filled]], nbar, j, &p);
            }
            solve_widely(filled, &p, groups);
            for (int j = 0; j < WIDE_LANES; j++) {
                if (j < left && take_widely(&p, groups, j, next, &counts[at[j]], equilibria[at[j]])) {
                    statuses[at[j]] = SPRAGSYM_OK;
                }
                next += p.certain[j] ? (int)p.count[j] : 0;
            }
        }
    }
    spragsym_status worst = SPRAGSYM_OK;
    for (int i = 0; i < BLOCK; i++) {
        if (i < points) {
            worst = (statuses[i] > worst) ? statuses[i] : worst;
        }
    }
    return worst;
}

spragsym_status spragsym_equilibria_batch(size_t points, const spragsym_parameters given[], spragsym_regime regime,
    spragsym_equilibrium equilibria[][SPRAGSYM_MAX_EQUILIBRIA], int counts[], spragsym_status statuses[]) {
    root_columns groups[GROUPS];
    point_columns p;
    int refused[BLOCK];
    spragsym_status worst = SPRAGSYM_OK;
    const int missing = !given || !equilibria || !counts || !statuses;
    if ((points > 0 && missing) || (regime != SPRAGSYM_CONTACT && regime != SPRAGSYM_LIFTOFF)) {
        return SPRAGSYM_BAD_INPUT;
    }
    const double nbar = (regime == SPRAGSYM_CONTACT) ? 1.0 : 0.0;
    /* Lanes that hold no root are computed all the same: they start as zeros, and keep what the last block left there. */
    memset(groups, 0, sizeof groups);
    for (size_t start = 0; start < points; start += BLOCK) {
        const int length = (points - start < BLOCK) ? (int)(points - start) : BLOCK;
        load(nbar, length, given + start, statuses + start, &p);
        guess_columns(&p);
        refuse(length, &p, statuses + start, refused);
        solve_columns(nbar, length, refused, &p, groups);
        spragsym_status status = unload(nbar, length, &p, groups, equilibria + start, counts + start, statuses + start);
        if (status >= SPRAGSYM_UNCERTAIN) {
            status = reconsider(nbar, length, given + start, equilibria + start, counts + start, statuses + start);
        }
        worst = (status > worst) ? status : worst;
    }
    return worst;
}
