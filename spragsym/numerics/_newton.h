/* Interval Newton's steps of one box, and what becomes of it in a search: the same numbers,
 * operation by operation, as contractors.py and verdicts.py give, for _contractors.c and _search.c.
 *
 * Rounding: see _rounding.h. NaN bounds nothing, so that every comparison from which something is
 * concluded is false with it. */
#ifndef SPRAGSYM_NEWTON_H
#define SPRAGSYM_NEWTON_H

#include <math.h>
#include <stdint.h>

#include "_rounding.h"

#define MOST 8

/* What becomes of a box, see BoxVerdict in verdicts.py. */
enum { DROPPED,
    PROVED,
    UNDECIDED,
    PARTED,
    AGAIN,
    HALVED };

typedef double vector[MOST];
typedef struct {
    vector ends[2];
} box;
typedef struct {
    vector ends[2][MOST];
} matrix;

/* The other one of NaN. */
PART double least_known(double a, double b) { return (a <= b || b != b) ? a : b; }

static void identity(int n, vector *Y) {
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            Y[i][j] = i == j ? 1.0 : 0.0;
        }
    }
}

/* Gauss's and Jordan's elimination with the largest pivot of each column. */
static void eliminated(int n, vector *m, vector *Y) {
    identity(n, Y);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            if (!isfinite(m[i][j])) {
                return;
            }
        }
    }
    for (int k = 0; k < n; k++) {
        int pivot = k;
        for (int i = k + 1; i < n; i++) {
            pivot = fabs(m[i][k]) > fabs(m[pivot][k]) ? i : pivot;
        }
        for (int j = 0; j < n; j++) {
            const double one = m[k][j];
            const double other = Y[k][j];
            m[k][j] = m[pivot][j];
            m[pivot][j] = one;
            Y[k][j] = Y[pivot][j];
            Y[pivot][j] = other;
        }
        for (int i = 0; i < n; i++) {
            const double factor = i == k ? 0.0 : m[i][k] / m[k][k];
            for (int j = 0; i != k && j < n; j++) {
                m[i][j] -= factor * m[k][j];
                Y[i][j] -= factor * Y[k][j];
            }
        }
    }
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            Y[i][j] /= m[i][i];
        }
    }
}

/* The inverse of a matrix, roughly, which is lost; the unit matrix where there is none. */
static void inverse(int n, vector *m, vector *Y) {
    if (n == 1) {
        Y[0][0] = 1.0 / m[0][0];
    } else if (n == 2) {
        const double det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        Y[0][0] = m[1][1] / det;
        Y[0][1] = -m[0][1] / det;
        Y[1][0] = -m[1][0] / det;
        Y[1][1] = m[0][0] / det;
    } else {
        eliminated(n, m, Y);
    }
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            if (!isfinite(Y[i][j])) {
                identity(n, Y);
                return;
            }
        }
    }
}

/* One entry of Y times a matrix of intervals: n products, each rounded, and n − 1 sums. */
static inline void dot(int n, const double *Y, const double *low, const double *high, int stride,
    double *to_low, double *to_high) {
    double total[2] = {0.0, 0.0};
    double size[2] = {0.0, 0.0};
    for (int k = 0; k < n; k++) {
        const double a = low[k * stride];
        const double b = high[k * stride];
        const double part[2] = {most(a * Y[k], -(b * Y[k])), most(b * Y[k], -(a * Y[k]))};
        for (int end = 0; end < 2; end++) {
            total[end] += part[end];
            size[end] += fabs(part[end]);
        }
    }
    *to_low = total[0] + (size[0] * ((n + 1) * EPS) + TINY);
    *to_high = total[1] + (size[1] * ((n + 1) * EPS) + TINY);
}

/* A step of interval Newton with a matrix and forces that are multiplied already; whether there is
 * no root. */
static int solved(int n, const matrix *A, const box *b, const double *middle, const double *reach,
    box *to, double *noise) {
    int none = 0;
    for (int i = 0; i < n; i++) {
        double around = 0.0;
        double own = 0.0;
        for (int j = 0; j < n; j++) {
            const double size = most(A->ends[0][i][j], A->ends[1][i][j]);
            own = j == i ? size * reach[j] : own;
            around += (j == i ? 0.0 : size) * reach[j];
        }
        around = around * (1.0 + 2 * (n + 1) * EPS) + TINY;
        const double smallest = -A->ends[0][i][i];
        const double largest = A->ends[1][i][i];
        for (int end = 0; end < 2; end++) {
            if (!(smallest > 0.0)) {
                to->ends[end][i] = INFINITY;
                continue;
            }
            const double far = raised(b->ends[1 - end][i] + around, 1.0);
            const double away = raised(far >= 0.0 ? far / smallest : far / largest, 1.0);
            const double value = raised((end ? middle[i] : -middle[i]) + away, 1.0);
            to->ends[end][i] = value;
        }
        noise[i] = 0.5 * (b->ends[0][i] + b->ends[1][i]);
        none |= -least(b->ends[0][i], b->ends[1][i]) > raised(around + own, 2.0);
    }
    return none;
}

static int newton_step(int n, const box *values, const matrix *slopes, const double *middle,
    const double *reach, box *to, double *noise) {
    vector middles[MOST];
    vector Y[MOST];
    matrix A;
    box b;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            middles[i][j] = middle_of(slopes->ends[0][i][j], slopes->ends[1][i][j]);
        }
    }
    inverse(n, middles, Y);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            dot(n, Y[i], &slopes->ends[0][0][j], &slopes->ends[1][0][j], MOST, &A.ends[0][i][j],
                &A.ends[1][i][j]);
        }
        dot(n, Y[i], values->ends[0], values->ends[1], 1, &b.ends[0][i], &b.ends[1][i]);
    }
    return solved(n, &A, &b, middle, reach, to, noise);
}

/* The step with every cyclic permutation of the rows in place of an inverse. */
static int by_each_row(int n, const box *values, const matrix *slopes, const double *middle,
    const double *reach, box *to) {
    int none = 0;
    for (int shift = 0; shift < n; shift++) {
        matrix A;
        box b;
        box step;
        vector noise;
        for (int i = 0; i < n; i++) {
            const int row = (i + shift) % n;
            const int turned = slopes->ends[1][row][i] < 0.0;
            for (int end = 0; end < 2; end++) {
                for (int j = 0; j < n; j++) {
                    A.ends[end][i][j] = slopes->ends[turned ? 1 - end : end][row][j];
                }
                b.ends[end][i] = values->ends[turned ? 1 - end : end][row];
            }
        }
        none |= solved(n, &A, &b, middle, reach, &step, noise);
        for (int i = 0; i < n; i++) {
            for (int end = 0; end < 2; end++) {
                to->ends[end][i] =
                    least_known(shift ? to->ends[end][i] : INFINITY, step.ends[end][i]);
            }
        }
    }
    return none;
}

static int apart(int n, const box *one, const box *other) {
    for (int i = 0; i < n; i++) {
        if (one->ends[0][i] + other->ends[1][i] < 0.0 ||
            one->ends[1][i] + other->ends[0][i] < 0.0) {
            return 1;
        }
    }
    return 0;
}

/* |x − m| over a box. */
static void distance(int n, const box *of, const double *middle, double *to) {
    for (int i = 0; i < n; i++) {
        to[i] =
            most(raised(middle[i] + of->ends[0][i], 1.0), raised(-middle[i] + of->ends[1][i], 1.0));
    }
}

/* Numbers that a search is ruled by, and how far each unknown spans. */
typedef struct {
    double margin, spread, small, narrow, shrunk, finest, spans[MOST];
} rules;

/* How they are read. */
#define RULES "(dddddd(dddddddd))"
#define INTO_RULES(by)                                                                 \
    &(by).margin, &(by).spread, &(by).small, &(by).narrow, &(by).shrunk, &(by).finest, \
        (by).spans, (by).spans + 1, (by).spans + 2, (by).spans + 3, (by).spans + 4,    \
        (by).spans + 5, (by).spans + 6, (by).spans + 7

static double scale_of(double low, double high) {
    return most(most(1.0, fabs(low)), most(1.0, fabs(high)));
}

/* The unknown in which the residuals change most in proportion to all that they change. */
static int most_told(int n, const rules *by, const matrix *slopes, const double *widths,
    const double *scales, const int *closed) {
    vector share = {0.0};
    int known = 1;
    for (int i = 0; i < n; i++) {
        vector change;
        double total = 0.0;
        for (int j = 0; j < n; j++) {
            change[j] = most(slopes->ends[0][i][j], slopes->ends[1][i][j]) * widths[j];
            total += change[j];
        }
        for (int j = 0; j < n; j++) {
            share[j] += change[j] / total;
        }
    }
    for (int j = 0; j < n; j++) {
        known &= isfinite(share[j]) != 0;
    }
    int best = 0;
    double largest = 0.0;
    for (int j = 0; j < n; j++) {
        const int done = closed[j] || widths[j] <= by->finest * scales[j];
        const double value = done ? -1.0 : known ? share[j] :
                                                   widths[j] / by->spans[j];
        if (j == 0 || value > largest || (value != value && largest == largest)) {
            largest = value;
            best = j;
        }
    }
    return best;
}

/* What is to be done with a box that is neither dropped nor proved. */
static int divided(int n, const rules *by, const box *before, const box *now, const double *noise,
    const matrix *slopes, const int *closed, int single, int spent, int64_t *along) {
    vector widths;
    vector scales;
    int some_stuck = 0;
    int all_small = 1;
    int narrow = 1;
    int still = 1;
    double left = 1.0;
    for (int i = 0; i < n; i++) {
        widths[i] = now->ends[0][i] + now->ends[1][i];
        scales[i] = scale_of(now->ends[0][i], now->ends[1][i]);
        some_stuck |= noise[i] >= by->spread * widths[i];
        all_small &= widths[i] <= by->small * scales[i];
        narrow &= widths[i] <= by->narrow * scales[i];
        still &= noise[i] < by->spread * widths[i];
        const double ratio = widths[i] <= by->finest * scales[i] ?
            1.0 :
            widths[i] / (before->ends[0][i] + before->ends[1][i]);
        left *= closed[i] ? 1.0 : ratio;
    }
    if ((single && (spent || (some_stuck && all_small))) || (narrow && (single || still))) {
        return UNDECIDED;
    }
    if (!single && (spent || !still)) {
        return PARTED;
    }
    if (left < by->shrunk) {
        return AGAIN;
    }
    *along = most_told(n, by, slopes, widths, scales, closed);
    return HALVED;
}

static inline int judged_box(int n, const rules *by, int sharp, int single, int spent, const box *values,
    const matrix *slopes, const double *middle, const box *given, const box *boxes, const box *wide,
    box *step, box *now, int64_t *along) {
    vector reach;
    vector noise;
    int closed[MOST];
    int proved = 1;
    distance(n, wide, middle, reach);
    const int none = newton_step(n, values, slopes, middle, reach, step, noise);
    for (int i = 0; i < n; i++) {
        closed[i] = step->ends[0][i] < wide->ends[0][i] && step->ends[1][i] < wide->ends[1][i];
        proved &= closed[i];
    }
    if (proved) {
        return PROVED;
    }
    if (none || apart(n, step, boxes)) {
        return DROPPED;
    }
    box ends = *step;
    if (sharp) {
        box rows;
        distance(n, boxes, middle, reach);
        int empty = by_each_row(n, values, slopes, middle, reach, &rows);
        for (int i = 0; i < n; i++) {
            for (int end = 0; end < 2; end++) {
                ends.ends[end][i] = least_known(ends.ends[end][i], rows.ends[end][i]);
            }
            empty |= ends.ends[0][i] + ends.ends[1][i] < 0.0;
        }
        if (empty || apart(n, &ends, boxes)) {
            return DROPPED;
        }
    }
    for (int i = 0; i < n; i++) {
        const double room =
            by->margin * raised(boxes->ends[0][i] + boxes->ends[1][i], 1.0) + 4 * noise[i];
        for (int end = 0; end < 2; end++) {
            now->ends[end][i] = least_known(ends.ends[end][i] + room, boxes->ends[end][i]);
        }
    }
    return divided(n, by, given, now, noise, slopes, closed, single, spent, along);
}

#endif
