/* Interval Newton steps of one box, and the verdict of a search on it, for _contractors.c and
 * _search.c: the same operations in the same order as in contractors.py and verdicts.py.
 *
 * Rounding: see _rounding.h. NaN bounds nothing, so that every comparison from which something is
 * concluded is false with it. */
#ifndef SPRAGSYM_NEWTON_H
#define SPRAGSYM_NEWTON_H

#include <math.h>
#include <stdint.h>

#include "_rounding.h"

#define MAX_UNKNOWNS 8

/* Verdicts on a box, the numbers of BoxVerdict in verdicts.py.
 *
 * DROPPED: it holds no root. PROVED: it holds exactly one. UNDECIDED: bisection does not help.
 * PARTED: the points of the parameters are to be divided, not the box. AGAIN: it became much
 * narrower, so contract it again. HALVED: it is to be bisected. */
enum { DROPPED,
    PROVED,
    UNDECIDED,
    PARTED,
    AGAIN,
    HALVED };

typedef double vector[MAX_UNKNOWNS];
typedef struct {
    vector ends[2];
} box;
typedef struct {
    vector ends[2][MAX_UNKNOWNS];
} matrix;

/* The smaller number; where one is NaN, the other. */
PART double minimum_of_known(double a, double b) { return (a <= b || b != b) ? a : b; }

static void identity(int n, vector *Y) {
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            Y[i][j] = i == j ? 1.0 : 0.0;
        }
    }
}

/* Invert m by Gauss–Jordan elimination with partial pivoting; m is overwritten. */
static void gauss_jordan(int n, vector *m, vector *Y) {
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

/* An approximate inverse Y of m, which may be overwritten; the unit matrix where m is singular. */
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
        gauss_jordan(n, m, Y);
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

/* Enclose one entry of Y times a matrix of intervals: n products and n − 1 sums, rounding errors
 * included. */
static inline void dot(int n, const double *Y, const double *low, const double *high, int stride,
    double *to_low, double *to_high) {
    double total[2] = {0.0, 0.0};
    double size[2] = {0.0, 0.0};
    for (int k = 0; k < n; k++) {
        const double a = low[k * stride];
        const double b = high[k * stride];
        const double part[2] = {maximum(a * Y[k], -(b * Y[k])), maximum(b * Y[k], -(a * Y[k]))};
        for (int end = 0; end < 2; end++) {
            total[end] += part[end];
            size[end] += fabs(part[end]);
        }
    }
    *to_low = total[0] + (size[0] * ((n + 1) * EPS) + TINY);
    *to_high = total[1] + (size[1] * ((n + 1) * EPS) + TINY);
}

/* Interval Newton step with preconditioned slopes A and values b. Returns whether the box is proved
 * to hold no root; `noise` is half the width of b. */
static int preconditioned_step(int n, const matrix *A, const box *b, const double *middle,
    const double *reach, box *to, double *noise) {
    int none = 0;
    for (int i = 0; i < n; i++) {
        double around = 0.0;
        double own = 0.0;
        for (int j = 0; j < n; j++) {
            const double size = maximum(A->ends[0][i][j], A->ends[1][i][j]);
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
            const double far = rounded_up(b->ends[1 - end][i] + around, 1.0);
            const double away = rounded_up(far >= 0.0 ? far / smallest : far / largest, 1.0);
            const double value = rounded_up((end ? middle[i] : -middle[i]) + away, 1.0);
            to->ends[end][i] = value;
        }
        noise[i] = 0.5 * (b->ends[0][i] + b->ends[1][i]);
        none |= -minimum(b->ends[0][i], b->ends[1][i]) > rounded_up(around + own, 2.0);
    }
    return none;
}

/* An interval Newton step, preconditioned by the inverse of the midpoint slopes. */
static int newton_step(int n, const box *values, const matrix *slopes, const double *middle,
    const double *reach, box *to, double *noise) {
    vector middles[MAX_UNKNOWNS];
    vector Y[MAX_UNKNOWNS];
    matrix A;
    box b;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            middles[i][j] = midpoint(slopes->ends[0][i][j], slopes->ends[1][i][j]);
        }
    }
    inverse(n, middles, Y);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            dot(n, Y[i], &slopes->ends[0][0][j], &slopes->ends[1][0][j], MAX_UNKNOWNS,
                &A.ends[0][i][j], &A.ends[1][i][j]);
        }
        dot(n, Y[i], values->ends[0], values->ends[1], 1, &b.ends[0][i], &b.ends[1][i]);
    }
    return preconditioned_step(n, &A, &b, middle, reach, to, noise);
}

/* The intersection of interval Newton steps without an inverse, one for each cyclic permutation of
 * the rows. */
static int step_by_rows(int n, const box *values, const matrix *slopes, const double *middle,
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
        none |= preconditioned_step(n, &A, &b, middle, reach, &step, noise);
        for (int i = 0; i < n; i++) {
            for (int end = 0; end < 2; end++) {
                to->ends[end][i] =
                    minimum_of_known(shift ? to->ends[end][i] : INFINITY, step.ends[end][i]);
            }
        }
    }
    return none;
}

/* Whether two boxes have no point in common. */
static int disjoint(int n, const box *one, const box *other) {
    for (int i = 0; i < n; i++) {
        if (one->ends[0][i] + other->ends[1][i] < 0.0 ||
            one->ends[1][i] + other->ends[0][i] < 0.0) {
            return 1;
        }
    }
    return 0;
}

/* The largest |x − m| over a box, for each unknown. */
static void distance(int n, const box *of, const double *middle, double *to) {
    for (int i = 0; i < n; i++) {
        to[i] = maximum(rounded_up(middle[i] + of->ends[0][i], 1.0),
            rounded_up(-middle[i] + of->ends[1][i], 1.0));
    }
}

/* Limits of a search, see Rules in verdicts.py, and the span of each unknown. */
typedef struct {
    double margin, spread, small, narrow, shrunk, finest, spans[MAX_UNKNOWNS];
} rules;

/* Format and targets for PyArg_ParseTuple. */
#define RULES "(dddddd(dddddddd))"
#define INTO_RULES(by)                                                                             \
    &(by).margin, &(by).spread, &(by).small, &(by).narrow, &(by).shrunk, &(by).finest, (by).spans, \
        (by).spans + 1, (by).spans + 2, (by).spans + 3, (by).spans + 4, (by).spans + 5,            \
        (by).spans + 6, (by).spans + 7

/* The scale of an unknown by which tolerances are multiplied: its size, but at least 1. */
static double scale_of(double low, double high) {
    return maximum(maximum(1.0, fabs(low)), maximum(1.0, fabs(high)));
}

/* The unknown with the largest share in the change of the residuals over the box. */
static int coordinate_to_halve(int n, const rules *by, const matrix *slopes, const double *widths,
    const double *scales, const int *contracted_inside) {
    vector share = {0.0};
    int known = 1;
    for (int i = 0; i < n; i++) {
        vector change;
        double total = 0.0;
        for (int j = 0; j < n; j++) {
            change[j] = maximum(slopes->ends[0][i][j], slopes->ends[1][i][j]) * widths[j];
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
        const int done = contracted_inside[j] || widths[j] <= by->finest * scales[j];
        const double value = done ? -1.0 : known ? share[j] :
                                                   widths[j] / by->spans[j];
        if (j == 0 || value > largest || (value != value && largest == largest)) {
            largest = value;
            best = j;
        }
    }
    return best;
}

/* The verdict on a box that is neither dropped nor proved. */
static int next_verdict(int n, const rules *by, const box *before, const box *now,
    const double *noise, const matrix *slopes, const int *contracted_inside, int single, int spent,
    int64_t *along) {
    vector widths;
    vector scales;
    int some_noisy = 0;
    int all_small = 1;
    int narrow = 1;
    int still = 1;
    double left = 1.0;
    for (int i = 0; i < n; i++) {
        widths[i] = now->ends[0][i] + now->ends[1][i];
        scales[i] = scale_of(now->ends[0][i], now->ends[1][i]);
        some_noisy |= noise[i] >= by->spread * widths[i];
        all_small &= widths[i] <= by->small * scales[i];
        narrow &= widths[i] <= by->narrow * scales[i];
        still &= noise[i] < by->spread * widths[i];
        const double ratio = widths[i] <= by->finest * scales[i] ?
            1.0 :
            widths[i] / (before->ends[0][i] + before->ends[1][i]);
        left *= contracted_inside[i] ? 1.0 : ratio;
    }
    if ((single && (spent || (some_noisy && all_small))) || (narrow && (single || still))) {
        return UNDECIDED;
    }
    if (!single && (spent || !still)) {
        return PARTED;
    }
    if (left < by->shrunk) {
        return AGAIN;
    }
    *along = coordinate_to_halve(n, by, slopes, widths, scales, contracted_inside);
    return HALVED;
}

/* The verdict on a box. `single` says that it is of one point of the parameters, `spent` that the
 * budget is used up, `sharp` that steps by rows are tried as well. */
static inline int judge_box(int n, const rules *by, int sharp, int single, int spent,
    const box *values, const matrix *slopes, const double *middle, const box *given,
    const box *boxes, const box *wide, box *step, box *now, int64_t *along) {
    vector reach;
    vector noise;
    int contracted_inside[MAX_UNKNOWNS];
    int proved = 1;
    distance(n, wide, middle, reach);
    const int none = newton_step(n, values, slopes, middle, reach, step, noise);
    for (int i = 0; i < n; i++) {
        contracted_inside[i] =
            step->ends[0][i] < wide->ends[0][i] && step->ends[1][i] < wide->ends[1][i];
        proved &= contracted_inside[i];
    }
    if (proved) {
        return PROVED;
    }
    if (none || disjoint(n, step, boxes)) {
        return DROPPED;
    }
    box ends = *step;
    if (sharp) {
        box rows;
        distance(n, boxes, middle, reach);
        int empty = step_by_rows(n, values, slopes, middle, reach, &rows);
        for (int i = 0; i < n; i++) {
            for (int end = 0; end < 2; end++) {
                ends.ends[end][i] = minimum_of_known(ends.ends[end][i], rows.ends[end][i]);
            }
            empty |= ends.ends[0][i] + ends.ends[1][i] < 0.0;
        }
        if (empty || disjoint(n, &ends, boxes)) {
            return DROPPED;
        }
    }
    for (int i = 0; i < n; i++) {
        const double room =
            by->margin * rounded_up(boxes->ends[0][i] + boxes->ends[1][i], 1.0) + 4 * noise[i];
        for (int end = 0; end < 2; end++) {
            now->ends[end][i] = minimum_of_known(ends.ends[end][i] + room, boxes->ends[end][i]);
        }
    }
    return next_verdict(n, by, given, now, noise, slopes, contracted_inside, single, spent, along);
}

#endif
