/* The generated C solver as a Python extension: from columns of points to columns of equilibria,
 * without the interpreter's lock.
 *
 * solve(theta0, mu0, kappa, alpha, sigma, beta, contact, settled, count, first, further)
 *     -> number of rows of `further` that are used
 *     Parameters are buffers of doubles of length n, or of length 1.
 *     settled, count: n signed chars each.
 *     first: a tuple of six columns of length n: theta, L, x, y, error (doubles) and stability
 *     (signed chars).
 *     further: a tuple of a buffer of n 64-bit rows, and the six columns of the slots from 1 on,
 *     with room for n rows.
 *
 * solve_widely: the same in double-double arithmetic.
 *
 * count(theta0, mu0, kappa, alpha, sigma, beta, counts): number of equilibria in contact, 0 if it
 * is not decided. */
#include "_arrays.h"

#include "spragsym.c"

#define COLUMNS 6
#define PARAMETERS 6

typedef struct {
    Py_buffer given[PARAMETERS];
    Py_buffer settled;
    Py_buffer count;
    Py_buffer first[COLUMNS];
    Py_buffer rows;
    Py_buffer further[COLUMNS];
    int held;
} buffers;

static Py_buffer *buffer_at(buffers *all, int place) {
    Py_buffer *const in_order[] = {&all->given[0], &all->given[1], &all->given[2], &all->given[3],
        &all->given[4], &all->given[5], &all->settled, &all->count, &all->first[0], &all->first[1],
        &all->first[2], &all->first[3], &all->first[4], &all->first[5], &all->rows,
        &all->further[0], &all->further[1], &all->further[2], &all->further[3], &all->further[4],
        &all->further[5]};
    return in_order[place];
}

static void release_all(buffers *all) {
    for (int i = 0; i < all->held; i++) {
        PyBuffer_Release(buffer_at(all, i));
    }
}

/* The next buffer, of items of a kind and as many of them; one that is read may have a single one. */
static int hold_next(buffers *all, PyObject *object, char kind, Py_ssize_t items, int written) {
    Py_buffer *const view = buffer_at(all, all->held);
    if (buffer_of_kind(object, view, kind, PyBUF_C_CONTIGUOUS | (written ? PyBUF_WRITABLE : 0)) <
        0) {
        return 0;
    }
    all->held++;
    return (!written && items_of(view) == 1) || sizes_fit(view, &items, 1);
}

static double entry(const Py_buffer *view, Py_ssize_t place) {
    const double *const values = (const double *)view->buf;
    return (view->len == (Py_ssize_t)sizeof(double)) ? values[0] : values[place];
}

static spragsym_parameters parameters_at(const Py_buffer given[PARAMETERS], Py_ssize_t place) {
    const spragsym_parameters here = {entry(&given[0], place), entry(&given[1], place),
        entry(&given[2], place), entry(&given[3], place), entry(&given[4], place),
        entry(&given[5], place)};
    return here;
}

/* A parameter of a block of points, 0 behind the last one. */
static void load_column(
    const Py_buffer *given, Py_ssize_t start, int points, double column[BLOCK]) {
    const double *const values = (const double *)given->buf;
    if (given->len == (Py_ssize_t)sizeof(double)) {
        for (int i = 0; i < points; i++) {
            column[i] = values[0];
        }
    } else {
        memcpy(column, values + start, (size_t)points * sizeof(double));
    }
    for (int i = points; i < BLOCK; i++) {
        column[i] = 0.0;
    }
}

/* Points that are no parameters are refused and give way to a harmless one. */
CLONED static void refuse_columns(point_columns *p, int refused[BLOCK]) {
    for (int i = 0; i < BLOCK; i++) {
        const spragsym_parameters here = {
            p->theta0[i], p->mu0[i], p->kappa[i], p->alpha[i], p->sigma[i], p->beta[i]};
        const int good = allowed(&here);
        p->theta0[i] = good ? here.theta0 : 1.0;
        p->mu0[i] = good ? here.mu0 : 1.0;
        p->kappa[i] = good ? here.kappa : 1.0;
        p->alpha[i] = good ? here.alpha : 1.0;
        p->sigma[i] = good ? here.sigma : 1.0;
        p->beta[i] = good ? here.beta : 1.0;
        refused[i] = !good;
    }
}

/* A block of points. What lies behind the last one is refused, since theta0 is 0 there. */
static void load_columns(const Py_buffer given[PARAMETERS], double nbar, Py_ssize_t start,
    int points, point_columns *p, int refused[BLOCK]) {
    double *const columns[PARAMETERS] = {p->theta0, p->mu0, p->kappa, p->alpha, p->sigma, p->beta};
    for (int k = 0; k < PARAMETERS; k++) {
        load_column(&given[k], start, points, columns[k]);
    }
    for (int i = 0; i < BLOCK; i++) {
        p->nbar[i] = nbar;
    }
    refuse_columns(p, refused);
}

static void store(
    const Py_buffer columns[COLUMNS], Py_ssize_t place, double theta, const Root *root) {
    ((double *)columns[0].buf)[place] = theta;
    ((double *)columns[1].buf)[place] = root->L;
    ((double *)columns[2].buf)[place] = root->x;
    ((double *)columns[3].buf)[place] = root->y;
    ((double *)columns[4].buf)[place] = root->error;
    ((signed char *)columns[5].buf)[place] = (signed char)root->code;
}

static void store_none(const Py_buffer columns[COLUMNS], Py_ssize_t place) {
    const Root none = {Py_NAN, Py_NAN, Py_NAN, Py_NAN, Py_NAN, 0, 0, 0.0, 0};
    store(columns, place, Py_NAN, &none);
}

/* A point's equilibrium into its slot. */
static void put(buffers *all, Py_ssize_t slots, Py_ssize_t place, Py_ssize_t used, int slot,
    double theta, const Root *root) {
    if (slot == 0) {
        store(all->first, place, theta, root);
    } else {
        store(all->further, slots * used + slot - 1, theta, root);
    }
}

/* Store whether a point is settled, and its row of `further` if it has one; returns the number of
 * rows that are used. */
static Py_ssize_t close_point(
    buffers *all, Py_ssize_t slots, Py_ssize_t place, int good, int count, Py_ssize_t used) {
    ((signed char *)all->settled.buf)[place] = (signed char)good;
    ((signed char *)all->count.buf)[place] = (signed char)(good ? count : 0);
    if (good && count > 1) {
        for (Py_ssize_t slot = count - 1; slot < slots; slot++) {
            store_none(all->further, slots * used + slot);
        }
        ((int64_t *)all->rows.buf)[used++] = (int64_t)place;
    }
    return used;
}

/* What the groups say of a block, into the columns; the rows of `further` that are used by then. */
static Py_ssize_t unload_columns(buffers *all, double nbar, Py_ssize_t start, int points,
    const int refused[BLOCK], const point_columns *p, const root_columns groups[GROUPS],
    Py_ssize_t used) {
    const Py_ssize_t slots = (nbar > 0.0) ? 2 : 3;
    int next = 0;
    for (int i = 0; i < points; i++) {
        tally sum = nothing_yet(nbar, !refused[i] && p->certain[i]);
        const int roots = refused[i] ? 0 : (int)p->count[i];
        for (int j = 0; j < roots; j++) {
            const root_columns *const r = &groups[next / LANES];
            const int lane = next % LANES;
            const Root root = taken_from(r, lane);
            see(r->t[lane], &root, &sum);
            if (root.member) {
                put(all, slots, start + i, used, sum.count++, r->theta[lane], &root);
            }
            next++;
        }
        used = close_point(all, slots, start + i, !refused[i] && stands(&sum), sum.count, used);
    }
    return used;
}

/* The same of a group in double-double arithmetic. */
static Py_ssize_t unload_widely(buffers *all, double nbar, Py_ssize_t start, int points,
    const wide_points *p, const wide_roots groups[MAX_ROOTS], Py_ssize_t used) {
    const Py_ssize_t slots = (nbar > 0.0) ? 2 : 3;
    int next = 0;
    for (int i = 0; i < points; i++) {
        tally sum = nothing_yet(nbar, p->certain[i]);
        const int roots = p->certain[i] ? (int)p->count[i] : 0;
        for (int j = 0; j < roots; j++) {
            const wide_roots *const r = &groups[next / WIDE_LANES];
            const int lane = next % WIDE_LANES;
            see_widely(paired(r->t_high[lane], r->t_low[lane]), &r->root[lane], &sum);
            if (r->root[lane].member) {
                put(all, slots, start + i, used, sum.count++, r->theta[lane], &r->root[lane]);
            }
            next++;
        }
        used = close_point(all, slots, start + i, stands(&sum), sum.count, used);
    }
    return used;
}

static Py_ssize_t solve_all_widely(buffers *all, double nbar, Py_ssize_t points) {
    const spragsym_parameters harmless = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    wide_roots groups[MAX_ROOTS];
    wide_points p;
    Py_ssize_t used = 0;
    memset(groups, 0, sizeof groups);
    for (Py_ssize_t start = 0; start < points; start += WIDE_LANES) {
        const int length = (points - start < WIDE_LANES) ? (int)(points - start) : WIDE_LANES;
        int refused[WIDE_LANES];
        for (int i = 0; i < WIDE_LANES; i++) {
            const spragsym_parameters here =
                parameters_at(all->given, (i < length) ? start + i : start);
            refused[i] = !allowed(&here);
            set_widely(refused[i] ? &harmless : &here, nbar, i, &p);
        }
        solve_widely(length, &p, groups);
        used = unload_widely(all, nbar, start, length, &p, groups, used);
        for (int i = 0; i < length; i++) {
            if (refused[i]) {
                ((signed char *)all->settled.buf)[start + i] = 0;
            }
        }
    }
    return used;
}

static Py_ssize_t solve_all(buffers *all, double nbar, Py_ssize_t points) {
    root_columns groups[GROUPS];
    point_columns p;
    int refused[BLOCK];
    Py_ssize_t used = 0;
    memset(groups, 0, sizeof groups);
    for (Py_ssize_t start = 0; start < points; start += BLOCK) {
        const int length = (points - start < BLOCK) ? (int)(points - start) : BLOCK;
        load_columns(all->given, nbar, start, length, &p, refused);
        guess_columns(&p);
        solve_columns(nbar, length, refused, &p, groups);
        used = unload_columns(all, nbar, start, length, refused, &p, groups, used);
    }
    return used;
}

static int hold_columns(buffers *all, PyObject *tuple, int offset, Py_ssize_t items) {
    for (int i = 0; i < COLUMNS; i++) {
        const char kind = (i < COLUMNS - 1) ? 'd' : 'b';
        if (!hold_next(all, PyTuple_GET_ITEM(tuple, i + offset), kind, items, 1)) {
            return 0;
        }
    }
    return 1;
}

static int hold_all(buffers *all, PyObject *const given[PARAMETERS], int contact, PyObject *settled,
    PyObject *count, PyObject *first, PyObject *further) {
    if (!PyTuple_Check(first) || !PyTuple_Check(further) || PyTuple_GET_SIZE(first) != COLUMNS ||
        PyTuple_GET_SIZE(further) != COLUMNS + 1) {
        PyErr_SetString(PyExc_TypeError, "first and further are tuples of 6 and 7 buffers");
        return 0;
    }
    const Py_ssize_t points = PyObject_Length(count);
    if (points < 0) {
        return 0;
    }
    for (int i = 0; i < PARAMETERS; i++) {
        if (!hold_next(all, given[i], 'd', points, 0)) {
            return 0;
        }
    }
    return hold_next(all, settled, 'b', points, 1) && hold_next(all, count, 'b', points, 1) &&
        hold_columns(all, first, 0, points) &&
        hold_next(all, PyTuple_GET_ITEM(further, 0), 'l', points, 1) &&
        hold_columns(all, further, 1, points * (contact ? 2 : 3));
}

typedef Py_ssize_t (*method)(buffers *all, double nbar, Py_ssize_t points);

static PyObject *solve_by(method solver, PyObject *arguments) {
    PyObject *given[PARAMETERS];
    PyObject *settled;
    PyObject *count;
    PyObject *first;
    PyObject *further;
    int contact;
    buffers all;
    all.held = 0;
    if (!PyArg_ParseTuple(arguments, "OOOOOOiOOOO", &given[0], &given[1], &given[2], &given[3],
            &given[4], &given[5], &contact, &settled, &count, &first, &further)) {
        return NULL;
    }
    Py_ssize_t used = -1;
    if (hold_all(&all, given, contact, settled, count, first, further)) {
        const Py_ssize_t points = all.count.len;
        Py_BEGIN_ALLOW_THREADS;
        used = solver(&all, contact ? 1.0 : 0.0, points);
        Py_END_ALLOW_THREADS;
    }
    release_all(&all);
    return (used < 0) ? NULL : PyLong_FromSsize_t(used);
}

static PyObject *solve(PyObject *module, PyObject *arguments) {
    (void)module;
    return solve_by(solve_all, arguments);
}

static PyObject *solve_more(PyObject *module, PyObject *arguments) {
    (void)module;
    return solve_by(solve_all_widely, arguments);
}

/* Parameters outside of their ranges have no count. The kernel itself decides nothing if they are
 * not finite, or if kappa or sigma is not positive. */
CLONED static void count_columns(const double *theta0, const double *mu0, const double *kappa,
    const double *alpha, const double *sigma, const double *beta, signed char *restrict counts) {
    for (int i = 0; i < BLOCK; i++) {
        const Direction undeformed = cosine_and_sine(theta0[i]);
        const Point point = {
            undeformed.cosine, undeformed.sine, mu0[i], kappa[i], alpha[i], sigma[i], beta[i], 1.0};
        const double number = one_or_three(point, UNIT_ROUNDOFF);
        const int inside = (theta0[i] > 0.0) & (theta0[i] < 3.14159265358979323846) &
            (mu0[i] >= 0.0) & (alpha[i] >= 0.0) & (beta[i] >= 0.0);
        counts[i] = (signed char)(inside ? number : 0.0);
    }
}

/* A parameter at the points of a block: a part of its buffer, or a copy in `room` if the buffer has
 * one number, or fewer than a block. */
static const double *column_at(
    const Py_buffer *given, Py_ssize_t start, int points, double room[BLOCK]) {
    if (points == BLOCK && given->len != (Py_ssize_t)sizeof(double)) {
        return (const double *)given->buf + start;
    }
    load_column(given, start, points, room);
    return room;
}

static void count_all(const Py_buffer given[PARAMETERS], Py_ssize_t points, signed char *counts) {
    double room[PARAMETERS][BLOCK];
    signed char found[BLOCK];
    for (Py_ssize_t start = 0; start < points; start += BLOCK) {
        const int length = (points - start < BLOCK) ? (int)(points - start) : BLOCK;
        const double *p[PARAMETERS];
        for (int k = 0; k < PARAMETERS; k++) {
            p[k] = column_at(&given[k], start, length, room[k]);
        }
        count_columns(p[0], p[1], p[2], p[3], p[4], p[5], found);
        memcpy(counts + start, found, (size_t)length);
    }
}

static PyObject *count_points(PyObject *module, PyObject *arguments) {
    PyObject *given[PARAMETERS];
    PyObject *result;
    buffers all;
    (void)module;
    all.held = 0;
    if (!PyArg_ParseTuple(arguments, "OOOOOOO", &given[0], &given[1], &given[2], &given[3],
            &given[4], &given[5], &result)) {
        return NULL;
    }
    const Py_ssize_t points = PyObject_Length(result);
    int held = points >= 0;
    for (int i = 0; held && i < PARAMETERS; i++) {
        held = hold_next(&all, given[i], 'd', points, 0);
    }
    held = held && hold_next(&all, result, 'b', points, 1);
    if (held) {
        Py_BEGIN_ALLOW_THREADS;
        count_all(all.given, points, (signed char *)all.settled.buf);
        Py_END_ALLOW_THREADS;
    }
    release_all(&all);
    if (!held) {
        return NULL;
    }
    Py_RETURN_NONE;
}

static PyMethodDef methods[] = {
    {"solve", solve, METH_VARARGS, "Points in columns to equilibria in columns."},
    {"solve_widely", solve_more, METH_VARARGS, "The same in double-double arithmetic."},
    {"count", count_points, METH_VARARGS,
        "The number of equilibria in contact, 0 where that is open."},
    {NULL, NULL, 0, NULL}};

static struct PyModuleDef definition = {PyModuleDef_HEAD_INIT, "_compiled",
    "The generated C solver.", -1, methods, NULL, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__compiled(void) { return new_module(&definition); }
