/* A look at the boxes of a search by tapes: those that hold no root are dropped, the others judged.
 *
 * The same tests in the same order, and so the same bits, as boxes.py, systems.py and verdicts.py
 * have by NumPy; which boxes are looked at next is told there.
 *
 * plan(…): a capsule, see below.
 *
 * kept(plan, given, parameters, margin, boxes, keep): what contraction leaves, and where a root may
 * be.
 *
 * decided(plan, given, boxes, parameters, limits, single, spent, sharp, rules, wide, step, left,
 * verdicts, along): what becomes of each box.
 *
 * rounds(plan, given, parameters, limits, sharp, rules, budget, most): both for the boxes of one
 * point, and for what is left of these, until nothing is or more than so many: how many were looked
 * at, and the bytes of boxes with a root, of where it is, of undecided and of further ones, box by
 * box.
 *
 * tubes(tapes, borders, parameters, pivot, inflation, times, z, along, swing, moved, beside, least,
 * room, most, sure): boxes of one state for each value of a pivot, as tubes.py has them.
 *
 * corrected(tapes, parameters, pivot, steps, z): Newton's method for the others at a pivot, in place;
 * tangents(tapes, parameters, pivot, z, by_s, by_p): slopes of the others by it and by what else the
 * tape of slopes has columns of. Both by the middles of enclosures at points.
 *
 * Arrays of boxes are contiguous doubles of shape (2, n, N) with −low and high first, limits (2,
 * n); parameters of shape (2, P, N) with any strides; keep, single, spent and verdicts bytes, along
 * int64, of shape (N,).
 *
 * Rounding: see _rounding.h. NaN bounds nothing: every comparison by which a box is dropped is
 * false with it. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "_arrays.h"
#include "_newton.h"
#include "_operations.h"

#define MOST_LINES 8
#define MOST_BORDERS 8
#define MOST_SIDES 16
#define MOST_ARCS 64
#define CAPSULE "spragsym search"

/* On which side of a border no state is: beyond it where the contact touches, before it where it is
 * open, or on it as well. */
enum { TOUCHING,
    OPEN,
    OPEN_AND_OFF,
    KINDS_OF_BORDERS };

/* What a line, as that of a spring, is asked for at its anchor, where its direction is not known:
 * forces by the direction, the direction over the box, and the determinant of slopes times the
 * length for directions on an arc. */
typedef struct {
    program forces;
    program direction;
    program determinant;
} line;

/* Tapes of a system of n equations. Those without results are not asked. Contraction is in the
 * first `coordinates` unknowns. */
typedef struct {
    PyObject *kept_alive;
    int n;
    int coordinates;
    Py_ssize_t parameters;
    program values;
    program slopes;
    program contraction;
    program gaps;
    program anchors;
    program turnings;
    int borders;
    int kinds[MOST_BORDERS];
    double rooms[MOST_BORDERS];
    int lines;
    line at[MOST_LINES];
    int arcs;
    double arc[2][2][MOST_ARCS];
    int sides;
    program on_sides[MOST_SIDES];
    Py_ssize_t slots;
    Py_ssize_t results;
} plan;

/* Boxes of a block that are still asked about, and room for what tapes give of them. */
typedef struct {
    int count;
    int32_t of[BLOCK];
    double ends[2][MOST][BLOCK];
    double near[2][MOST][BLOCK];
    double values[2][MOST][BLOCK];
    vector inverse[BLOCK][MOST];
    operand parameters;
    slot *slots;
    double *out;
} desk;

/* Boxes on the desk by their places; all of them without a list. */
typedef struct {
    int count;
    int32_t place[BLOCK];
    int32_t of[BLOCK];
} some;

static operand rows_of(double (*ends)[MOST][BLOCK], int rows, const int32_t *of) {
    return (operand){(const char *)ends,
        {sizeof(double) * MOST * BLOCK, sizeof(double) * BLOCK, sizeof(double)}, rows, of};
}

static operand parameters_of(const desk *at, const int32_t *of) {
    operand out = at->parameters;
    out.of = of;
    return out;
}

/* Row of results for −low or high. */
static const double *result(const desk *at, const program *tape, int end, int row) {
    return at->out + (end * tape->outputs + row) * BLOCK;
}

static void add(some *to, const desk *at, int i) {
    to->place[to->count] = i;
    to->of[to->count++] = at->of[i];
}

static void evaluated_at(
    const plan *by, const program *tape, desk *at, double (*ends)[MOST][BLOCK]) {
    const operand inputs[2] = {rows_of(ends, by->n, NULL), parameters_of(at, at->of)};
    block(tape, inputs, at->slots, at->out, BLOCK, 0, at->count);
}

static void evaluated(const plan *by, const program *tape, desk *at) {
    evaluated_at(by, tape, at, at->ends);
}

static void evaluated_of(const plan *by, const program *tape, desk *at, const some *boxes) {
    const operand inputs[2] = {
        rows_of(at->ends, by->n, boxes->place), parameters_of(at, boxes->of)};
    block(tape, inputs, at->slots, at->out, BLOCK, 0, boxes->count);
}

/* Whether some result is not 0. */
static int not_zero(const desk *at, const program *tape, int i) {
    for (int row = 0; row < tape->outputs; row++) {
        if (result(at, tape, 0, row)[i] < 0.0 || result(at, tape, 1, row)[i] < 0.0) {
            return 1;
        }
    }
    return 0;
}

static void dropped(const plan *by, desk *at, const uint8_t *gone) {
    int left = 0;
    for (int i = 0; i < at->count; i++) {
        if (gone[i]) {
            continue;
        }
        at->of[left] = at->of[i];
        for (int end = 0; end < 2; end++) {
            for (int k = 0; k < by->n; k++) {
                at->ends[end][k][left] = at->ends[end][k][i];
            }
        }
        left++;
    }
    at->count = left;
}

/* -------------------------------------------------------------------------------------------------
 * contraction */

/* A step of interval Newton with directions of lines that are those over the box: in place. Of some
 * boxes nothing is left. */
static void contracted(const plan *by, desk *at, uint8_t *gone) {
    const int n = by->coordinates;
    if (n < 1) {
        return;
    }
    for (int k = 0; k < n; k++) {
        for (int i = 0; i < at->count; i++) {
            const double middle = middle_of(at->ends[0][k][i], at->ends[1][k][i]);
            at->near[0][k][i] = -middle;
            at->near[1][k][i] = middle;
        }
    }
    const operand inputs[3] = {
        rows_of(at->ends, by->n, NULL), rows_of(at->near, n, NULL), parameters_of(at, at->of)};
    block(&by->contraction, inputs, at->slots, at->out, BLOCK, 0, at->count);
    for (int i = 0; i < at->count; i++) {
        box given;
        box values;
        box step;
        matrix slopes;
        vector middle;
        vector reach;
        vector noise;
        for (int k = 0; k < n; k++) {
            middle[k] = at->near[1][k][i];
            for (int end = 0; end < 2; end++) {
                given.ends[end][k] = at->ends[end][k][i];
                values.ends[end][k] = result(at, &by->contraction, end, k)[i];
                for (int j = 0; j < n; j++) {
                    slopes.ends[end][k][j] = result(at, &by->contraction, end, n + n * k + j)[i];
                }
            }
        }
        distance(n, &given, middle, reach);
        (void)newton_step(n, &values, &slopes, middle, reach, &step, noise);
        for (int k = 0; k < n; k++) {
            for (int end = 0; end < 2; end++) {
                at->ends[end][k][i] = least_known(step.ends[end][k], given.ends[end][k]);
            }
            gone[i] |= at->ends[0][k][i] + at->ends[1][k][i] < 0.0;
        }
    }
}

/* Boxes as they were given where contraction has room left. */
static void with_room(const plan *by, desk *at, const double *given, Py_ssize_t N, double margin) {
    for (int k = 0; k < by->n; k++) {
        for (int i = 0; i < at->count; i++) {
            const double before[2] = {given[k * N + at->of[i]], given[(by->n + k) * N + at->of[i]]};
            const double room = margin * raised(before[0] + before[1], 1.0);
            for (int end = 0; end < 2; end++) {
                at->ends[end][k][i] = least_known(at->ends[end][k][i] + room, before[end]);
            }
        }
    }
}

/* -------------------------------------------------------------------------------------------------
 * boxes without a root */

static void without_zero(const plan *by, desk *at, uint8_t *gone) {
    evaluated(by, &by->values, at);
    for (int i = 0; i < at->count; i++) {
        gone[i] |= (uint8_t)not_zero(at, &by->values, i);
    }
}

static int beyond(int kind, double room, double low, double high) {
    return kind == TOUCHING ? -low > room : kind == OPEN ? high < -room :
                                                           high <= 0.0;
}

static void beyond_borders(const plan *by, desk *at, uint8_t *gone) {
    if (by->borders) {
        evaluated(by, &by->gaps, at);
    }
    for (int k = 0; k < by->borders; k++) {
        const double *low = result(at, &by->gaps, 0, k);
        const double *high = result(at, &by->gaps, 1, k);
        for (int i = 0; i < at->count; i++) {
            gone[i] |= (uint8_t)beyond(by->kinds[k], by->rooms[k], low[i], high[i]);
        }
    }
}

/* Which boxes are no farther from the anchor of each line than their size: of others the direction
 * is known so well that the equations themselves tell. */
static void near_anchors(const plan *by, desk *at, uint8_t (*near)[BLOCK]) {
    evaluated(by, &by->anchors, at);
    for (int k = 0; k < by->lines; k++) {
        for (int i = 0; i < at->count; i++) {
            double sizes[2];
            double widths = 0.0;
            for (int j = 0; j < 2; j++) {
                const double low = result(at, &by->anchors, 0, 2 * k + j)[i];
                const double high = result(at, &by->anchors, 1, 2 * k + j)[i];
                sizes[j] = mignitude(low, high);
                widths += raised(low + high, 1.0);
            }
            near[k][i] = hypot(sizes[0], sizes[1]) <= widths;
        }
    }
}

/* Whether G + M u = 0 for no unit vector u of two components, see no_unit_vector in contractors.py:
 * results G and then M. */
static int no_unit_vector(const desk *at, const program *tape, int n, int i) {
    double m[MOST][2];
    vector gram[MOST] = {{0.0}};
    vector inverted[MOST];
    double length[2] = {0.0, 0.0};
    for (int k = 0; k < n; k++) {
        for (int j = 0; j < 2; j++) {
            m[k][j] = middle_of(
                result(at, tape, 0, n + 2 * k + j)[i], result(at, tape, 1, n + 2 * k + j)[i]);
        }
        for (int j = 0; j < 2; j++) {
            for (int l = 0; l < 2; l++) {
                gram[j][l] = k == 0 ? m[k][j] * m[k][l] : gram[j][l] + m[k][j] * m[k][l];
            }
        }
    }
    inverse(2, gram, inverted);
    for (int j = 0; j < 2; j++) {
        vector P;
        double low[3][MOST];
        double high[3][MOST];
        double sizes[2];
        for (int k = 0; k < n; k++) {
            P[k] = inverted[j][0] * m[k][0] + inverted[j][1] * m[k][1];
            for (int column = 0; column < 3; column++) {
                const int row = column < 2 ? n + 2 * k + column : k;
                low[column][k] = result(at, tape, 0, row)[i];
                high[column][k] = result(at, tape, 1, row)[i];
            }
        }
        for (int column = 0; column < 2; column++) {
            double off[2];
            dot(n, P, low[column], high[column], 1, off, off + 1);
            if (column == j) {
                off[0] = raised(off[0] + 1.0, 1.0);
                off[1] = raised(off[1] - 1.0, 1.0);
            }
            sizes[column] = most(off[0], off[1]);
        }
        const double slack = (sizes[0] + sizes[1]) * (1 + 4 * EPS);
        double u[2];
        dot(n, P, low[2], high[2], 1, u, u + 1);
        u[0] = raised(u[0] + slack, 1.0);
        u[1] = raised(u[1] + slack, 1.0);
        const double near = mignitude(u[0], u[1]);
        const double far = most(u[0], u[1]);
        length[0] += least(raised(-(near * near), 1.0), 0.0);
        length[1] += raised(far * far, 1.0);
    }
    return -raised(length[0], 1.0) > 1.0 || raised(length[1], 1.0) < 1.0;
}

/* Boxes at an anchor where no direction of the line balances the forces. */
static void without_direction(
    const plan *by, desk *at, const uint8_t (*near)[BLOCK], uint8_t *gone) {
    for (int k = 0; k < by->lines; k++) {
        const program *tape = &by->at[k].forces;
        some boxes = {.count = 0};
        for (int i = 0; tape->outputs && i < at->count; i++) {
            if (near[k][i] && !gone[i]) {
                add(&boxes, at, i);
            }
        }
        if (boxes.count) {
            evaluated_of(by, tape, at, &boxes);
        }
        for (int i = 0; i < boxes.count; i++) {
            gone[boxes.place[i]] = (uint8_t)no_unit_vector(at, tape, (int)tape->outputs / 3, i);
        }
    }
}

/* For pairs of boxes and arcs: a box in which the determinant may be 0 for a direction on the arc
 * is not regular. */
static void asked_arcs(const plan *by, const program *tape, desk *at, some *pairs,
    const int32_t *arcs, uint8_t *regular) {
    const operand inputs[3] = {rows_of(at->ends, by->n, pairs->place),
        {(const char *)by->arc, {sizeof by->arc[0], sizeof by->arc[0][0], sizeof(double)}, 2, arcs},
        parameters_of(at, pairs->of)};
    block(tape, inputs, at->slots, at->out, BLOCK, 0, pairs->count);
    for (int i = 0; i < pairs->count; i++) {
        regular[pairs->place[i]] &= (uint8_t)not_zero(at, tape, i);
    }
    pairs->count = 0;
}

/* Boxes of which no direction of a line on some arcs, every eighth or the others, makes the
 * determinant 0. */
static void regular_along(const plan *by, int number, desk *at, const some *boxes,
    const double (*known)[2][BLOCK], int eighth, uint8_t *regular) {
    some pairs = {.count = 0};
    int32_t arcs[BLOCK];
    for (int arc = 0; arc < by->arcs; arc++) {
        for (int i = 0; (arc % 8 == 0) == eighth && i < boxes->count; i++) {
            int possible = regular[boxes->place[i]];
            for (int end = 0; end < 2; end++) {
                for (int j = 0; j < 2; j++) {
                    possible &= !(by->arc[end][j][arc] + known[1 - end][j][i] < 0.0);
                }
            }
            if (possible) {
                arcs[pairs.count] = arc;
                add(&pairs, at, boxes->place[i]);
            }
            if (pairs.count == BLOCK) {
                asked_arcs(by, &by->at[number].determinant, at, &pairs, arcs, regular);
            }
        }
    }
    if (pairs.count) {
        asked_arcs(by, &by->at[number].determinant, at, &pairs, arcs, regular);
    }
}

/* Boxes at an anchor where the determinant is not 0, whatever the direction of the line is. */
static void regular_at_anchors(
    const plan *by, desk *at, const uint8_t (*near)[BLOCK], uint8_t *gone) {
    for (int k = 0; k < by->lines; k++) {
        const program *tape = &by->at[k].direction;
        double known[2][2][BLOCK];
        some boxes = {.count = 0};
        uint8_t regular[BLOCK];
        for (int i = 0; by->at[k].determinant.outputs && i < at->count; i++) {
            regular[i] = 1;
            if (near[k][i] && !gone[i]) {
                add(&boxes, at, i);
            }
        }
        if (!boxes.count) {
            continue;
        }
        evaluated_of(by, tape, at, &boxes);
        for (int end = 0; end < 2; end++) {
            for (int j = 0; j < 2; j++) {
                memcpy(known[end][j], result(at, tape, end, j), sizeof known[end][j]);
            }
        }
        regular_along(by, k, at, &boxes, known, 1, regular);
        regular_along(by, k, at, &boxes, known, 0, regular);
        for (int i = 0; i < boxes.count; i++) {
            gone[boxes.place[i]] = regular[boxes.place[i]];
        }
    }
}

/* Boxes that meet the ray on which the angle of a torsion spring jumps, and hold no root on any
 * side of it. */
static void without_sides(const plan *by, desk *at, uint8_t *gone) {
    const program *tape = &by->turnings;
    some boxes = {.count = 0};
    if (!tape->outputs) {
        return;
    }
    evaluated(by, tape, at);
    for (int i = 0; i < at->count; i++) {
        int jumps = 0;
        for (int row = 0; row < tape->outputs; row++) {
            jumps |= isnan(result(at, tape, 0, row)[i]) != 0;
        }
        if (jumps && !gone[i]) {
            add(&boxes, at, i);
        }
    }
    for (int side = 0; side < by->sides && boxes.count; side++) {
        evaluated_of(by, by->on_sides + side, at, &boxes);
        const int asked = boxes.count;
        boxes.count = 0;
        for (int i = 0; i < asked; i++) {
            if (not_zero(at, by->on_sides + side, i)) {
                add(&boxes, at, boxes.place[i]);
            }
        }
    }
    for (int i = 0; i < boxes.count; i++) {
        gone[boxes.place[i]] = 1;
    }
}

static void hopeless(const plan *by, desk *at, uint8_t *gone) {
    beyond_borders(by, at, gone);
    if (by->lines) {
        uint8_t near[MOST_LINES][BLOCK];
        near_anchors(by, at, near);
        without_direction(by, at, near, gone);
        regular_at_anchors(by, at, near, gone);
    }
    without_sides(by, at, gone);
}

static void kept_block(const plan *by, desk *at, const double *given, Py_ssize_t N, double margin,
    double *boxes, uint8_t *keep) {
    uint8_t gone[BLOCK] = {0};
    if (by->contraction.operations) {
        contracted(by, at, gone);
    }
    with_room(by, at, given, N, margin);
    for (int end = 0; end < 2; end++) {
        for (int k = 0; k < by->n; k++) {
            memcpy(boxes + (end * by->n + k) * N + at->of[0], at->ends[end][k],
                (size_t)at->count * sizeof(double));
        }
    }
    without_zero(by, at, gone);
    dropped(by, at, gone);
    if (at->count) {
        memset(gone, 0, sizeof gone);
        hopeless(by, at, gone);
        dropped(by, at, gone);
    }
    for (int i = 0; i < at->count; i++) {
        keep[at->of[i]] = 1;
    }
}

/* -------------------------------------------------------------------------------------------------
 * verdicts */

typedef struct {
    const double *given;
    const double *boxes;
    const double *limits;
    const uint8_t *single;
    const uint8_t *spent;
    int sharp;
    rules by;
    double *wide;
    double *step;
    double *left;
    int8_t *verdicts;
    int64_t *along;
} judgement;

/* Boxes with room around, so that a root on the border of a box lies well inside, or by rounding
 * beside it; and their middles. */
static void widened(const plan *by, desk *at, const judgement *of, Py_ssize_t N) {
    const int n = by->n;
    for (int k = 0; k < n; k++) {
        for (int i = 0; i < at->count; i++) {
            const Py_ssize_t place = k * N + at->of[i];
            const double ends[2] = {of->boxes[place], of->boxes[n * N + place]};
            const double room = of->by.margin * raised(ends[0] + ends[1], 1.0) +
                of->by.finest * scale_of(ends[0], ends[1]);
            const double middle = middle_of(ends[0], ends[1]);
            at->near[0][k][i] = -middle;
            at->near[1][k][i] = middle;
            for (int end = 0; end < 2; end++) {
                at->ends[end][k][i] = least(ends[end] + room, of->limits[end * n + k]);
            }
        }
    }
}

static void decided_block(const plan *by, desk *at, const judgement *of, Py_ssize_t N) {
    const int n = by->n;
    widened(by, at, of, N);
    evaluated_at(by, &by->values, at, at->near);
    for (int end = 0; end < 2; end++) {
        for (int k = 0; k < n; k++) {
            memcpy(at->values[end][k], result(at, &by->values, end, k), sizeof at->values[end][k]);
        }
    }
    evaluated(by, &by->slopes, at);
    for (int i = 0; i < at->count; i++) {
        const Py_ssize_t place = at->of[i];
        box values, given, boxes, wide, step;
        box now = {{{0.0}}};
        matrix slopes;
        vector middle;
        for (int k = 0; k < n; k++) {
            middle[k] = at->near[1][k][i];
            for (int end = 0; end < 2; end++) {
                const Py_ssize_t entry = (end * n + k) * N + place;
                given.ends[end][k] = of->given[entry];
                boxes.ends[end][k] = of->boxes[entry];
                wide.ends[end][k] = at->ends[end][k][i];
                values.ends[end][k] = at->values[end][k][i];
                for (int j = 0; j < n; j++) {
                    slopes.ends[end][k][j] = result(at, &by->slopes, end, n * k + j)[i];
                }
            }
        }
        of->along[place] = 0;
        of->verdicts[place] =
            (int8_t)judged_box(n, &of->by, of->sharp, of->single[place], of->spent[place], &values,
                &slopes, middle, &given, &boxes, &wide, &step, &now, of->along + place);
        for (int k = 0; k < n; k++) {
            for (int end = 0; end < 2; end++) {
                const Py_ssize_t entry = (end * n + k) * N + place;
                of->wide[entry] = wide.ends[end][k];
                of->step[entry] = step.ends[end][k];
                of->left[entry] = now.ends[end][k];
            }
        }
    }
}

/* -------------------------------------------------------------------------------------------------
 * rounds */

/* The next boxes of N, from number `begin` on. */
static void laid_out(
    const plan *by, desk *at, const double *given, Py_ssize_t N, Py_ssize_t begin) {
    at->count = (int)(N - begin < BLOCK ? N - begin : BLOCK);
    for (int i = 0; i < at->count; i++) {
        at->of[i] = (int32_t)(begin + i);
    }
    for (int end = 0; end < 2; end++) {
        for (int k = 0; k < by->n; k++) {
            memcpy(at->ends[end][k], given + (end * by->n + k) * N + begin,
                (size_t)at->count * sizeof(double));
        }
    }
}

/* Boxes one after the other, of 2 n doubles each. */
typedef struct {
    double *boxes;
    Py_ssize_t count;
    Py_ssize_t room;
} pile;

/* What is made of the boxes of a search. */
typedef struct {
    pile unique;
    pile where;
    pile undecided;
    pile further;
} outcome;

/* Room for one more box, NULL where there is no memory. */
static double *one_more(pile *to, int n) {
    if (to->count == to->room) {
        const Py_ssize_t room = to->room ? 2 * to->room : 64;
        double *boxes = PyMem_RawRealloc(to->boxes, (size_t)room * 2 * (size_t)n * sizeof(double));
        if (boxes == NULL) {
            return NULL;
        }
        to->boxes = boxes;
        to->room = room;
    }
    return to->boxes + 2 * n * to->count++;
}

/* Box j of M in an array of boxes, put on a pile. */
static double *piled(pile *to, int n, const double *from, Py_ssize_t M, Py_ssize_t j) {
    double *box = one_more(to, n);
    for (int k = 0; box != NULL && k < 2 * n; k++) {
        box[k] = from[k * M + j];
    }
    return box;
}

/* One half of a box, cut not in the middle, where symmetric systems have their roots. */
static int half_piled(pile *to, const judgement *of, int n, Py_ssize_t M, Py_ssize_t j, int upper) {
    double *box = piled(to, n, of->left, M, j);
    if (box == NULL) {
        return 0;
    }
    const Py_ssize_t along = of->along[j];
    const double low = -box[along];
    const double high = box[n + along];
    const double cut = least(most(low + 0.4921875 * (high - low), low), high);
    box[upper ? along : n + along] = upper ? -cut : cut;
    return 1;
}

/* What becomes of M judged boxes: those that are much narrower as they are, then lower and then
 * upper halves. */
static int sorted_out(const judgement *of, int n, Py_ssize_t M, outcome *to) {
    int whole = 1;
    for (Py_ssize_t j = 0; j < M && whole; j++) {
        if (of->verdicts[j] == PROVED) {
            whole = piled(&to->unique, n, of->wide, M, j) != NULL &&
                piled(&to->where, n, of->step, M, j) != NULL;
        } else if (of->verdicts[j] == UNDECIDED) {
            whole = piled(&to->undecided, n, of->left, M, j) != NULL;
        } else if (of->verdicts[j] == AGAIN) {
            whole = piled(&to->further, n, of->left, M, j) != NULL;
        }
    }
    for (int upper = 0; upper < 2; upper++) {
        for (Py_ssize_t j = 0; j < M && whole; j++) {
            whole = of->verdicts[j] != HALVED || half_piled(&to->further, of, n, M, j, upper);
        }
    }
    return whole;
}

/* A look at N boxes; 0 where there is no memory. */
static int one_round(const plan *by, desk *at, judgement *of, int spent, const double *given,
    Py_ssize_t N, outcome *to) {
    const int rows = 2 * by->n;
    const Py_ssize_t size = rows * N;
    double *room = PyMem_RawMalloc((size_t)size * 6 * sizeof(double) +
        (size_t)N * (sizeof(int64_t) + 4 * sizeof(uint8_t)));
    if (room == NULL) {
        return 0;
    }
    double *parts[6];
    for (int k = 0; k < 6; k++) {
        parts[k] = room + k * size;
    }
    of->along = (int64_t *)(void *)(room + 6 * size);
    uint8_t *const keep = (uint8_t *)(void *)(of->along + N);
    memset(keep, 0, (size_t)N);
    for (Py_ssize_t begin = 0; begin < N; begin += BLOCK) {
        laid_out(by, at, given, N, begin);
        kept_block(by, at, given, N, of->by.margin, parts[0], keep);
    }
    Py_ssize_t M = 0;
    for (Py_ssize_t i = 0; i < N; i++) {
        M += keep[i];
    }
    for (int k = 0; k < rows; k++) {
        Py_ssize_t j = 0;
        for (Py_ssize_t i = 0; i < N; i++) {
            if (keep[i]) {
                parts[1][k * M + j] = given[k * N + i];
                parts[2][k * M + j++] = parts[0][k * N + i];
            }
        }
    }
    memset(keep + N, 1, (size_t)N);
    memset(keep + 2 * N, spent, (size_t)N);
    of->given = parts[1];
    of->boxes = parts[2];
    of->wide = parts[3];
    of->step = parts[4];
    of->left = parts[5];
    of->single = keep + N;
    of->spent = keep + 2 * N;
    of->verdicts = (int8_t *)(keep + 3 * N);
    for (Py_ssize_t begin = 0; begin < M; begin += BLOCK) {
        laid_out(by, at, of->boxes, M, begin);
        decided_block(by, at, of, M);
    }
    const int whole = sorted_out(of, by->n, M, to);
    PyMem_RawFree(room);
    return whole;
}

/* Rounds until no box is left or more than `limit`; how many boxes were looked at, −1 where there
 * is no memory. */
static Py_ssize_t all_rounds(const plan *by, desk *at, judgement *of, Py_ssize_t budget,
    Py_ssize_t limit, outcome *to) {
    const int rows = 2 * by->n;
    Py_ssize_t looks = 0;
    while (to->further.count && to->further.count <= limit) {
        const Py_ssize_t N = to->further.count;
        double *given = PyMem_RawMalloc((size_t)(rows * N) * sizeof(double));
        if (given == NULL) {
            return -1;
        }
        for (int k = 0; k < rows; k++) {
            for (Py_ssize_t i = 0; i < N; i++) {
                given[k * N + i] = to->further.boxes[rows * i + k];
            }
        }
        to->further.count = 0;
        looks += N;
        const int whole = one_round(by, at, of, looks > budget, given, N, to);
        PyMem_RawFree(given);
        if (!whole) {
            return -1;
        }
    }
    return looks;
}

/* -------------------------------------------------------------------------------------------------
 * tubes */

/* Tubes of N points: n equations in n + 1 unknowns, of which one is the pivot. */
typedef struct {
    plan by;
    int pivot;
    int times;
    double more;
    Py_ssize_t N;
    const double *z;
    const double *along;
    const double *swing;
    const double *moved;
    const double *beside;
    const double *least;
    double *room;
    double *most;
    uint8_t *sure;
} tube;

/* Whether a gap is on the side asked for, or on the border. */
static int on_side(int kind, double room, double low, double high) {
    return kind == TOUCHING ? high <= room : kind == OPEN ? low >= -room :
                                                            low > 0.0;
}

/* What is left of forces along a tube: row i of slopes times the way, and that as far as it goes. */
static void left_along(const tube *of, const desk *at, int i, int a, Py_ssize_t c, const double (*forces)[MOST][BLOCK],
    double *to) {
    const int size = of->by.n;
    double total[2] = {0.0, 0.0};
    for (int j = 0; j < size; j++) {
        const double factor = of->along[j * of->N + c];
        if (factor == 0.0) {
            continue;
        }
        const double low = result(at, &of->by.slopes, 0, i * size + j)[a];
        const double high = result(at, &of->by.slopes, 1, i * size + j)[a];
        total[0] = raised(total[0] + raised(most(low * factor, -(high * factor)), 1.0), 1.0);
        total[1] = raised(total[1] + raised(most(high * factor, -(low * factor)), 1.0), 1.0);
    }
    const double moved = of->moved[c];
    const double size_of = raised(most(most(total[0] * moved, total[1] * moved), -least(total[0] * moved, total[1] * moved)), 1.0);
    for (int end = 0; end < 2; end++) {
        to[end] = raised(forces[end][i][c % BLOCK] + size_of, 1.0);
    }
}

/* Some widths of the boxes about the tubes of a block, each larger than the one before, until one
 * is proved. */
static void tubes_of_block(const tube *of, desk *at, Py_ssize_t begin) {
    const plan *by = &of->by;
    const int size = by->n;
    const int n = size - 1;
    const Py_ssize_t N = of->N;
    double (*forces)[MOST][BLOCK] = at->values;
    double reach[MOST][BLOCK];
    at->count = (int)(N - begin < BLOCK ? N - begin : BLOCK);
    for (int i = 0; i < at->count; i++) {
        at->of[i] = (int32_t)(begin + i);
        for (int k = 0; k < size; k++) {
            at->ends[0][k][i] = -of->z[k * N + begin + i];
            at->ends[1][k][i] = of->z[k * N + begin + i];
        }
        for (int k = 0; k < n; k++) {
            reach[k][i] = of->least[k * N + begin + i];
        }
    }
    evaluated(by, &by->values, at);
    for (int end = 0; end < 2; end++) {
        for (int k = 0; k < n; k++) {
            memcpy(forces[end][k], result(at, &by->values, end, k), (size_t)at->count * sizeof(double));
        }
    }
    for (int time = 0; time < of->times && at->count; time++) {
        some proved = {0};
        int left = 0;
        int32_t further[BLOCK];
        for (int a = 0; a < at->count; a++) {
            const Py_ssize_t c = at->of[a];
            for (int k = 0; k < size; k++) {
                const double own = of->beside[k * N + c];
                const int row = k - (k > of->pivot);
                const double alone = k == of->pivot ? own : most(reach[row][c - begin], own);
                const double middle = of->z[k * N + c];
                const double held = of->swing[k * N + c] + alone;
                const double size_here = fabs(middle) + held;
                const double wide = held > 0.0 ? held + (nextafter(size_here, INFINITY) - size_here) : held;
                at->near[0][k][a] = alone;
                at->ends[0][k][a] = -middle + wide;
                at->ends[1][k][a] = middle + wide;
            }
        }
        evaluated(by, &by->slopes, at);
        for (int a = 0; a < at->count; a++) {
            const Py_ssize_t c = at->of[a];
            matrix slopes;
            box values;
            box step;
            vector middle = {0.0};
            vector noise;
            vector room;
            int known = 1;
            int inside = 1;
            for (int i = 0; i < n; i++) {
                double ends[2];
                left_along(of, at, i, a, c, (const double (*)[MOST][BLOCK])forces, ends);
                room[i] = reach[i][c - begin];
                for (int end = 0; end < 2; end++) {
                    values.ends[end][i] = ends[end];
                    for (int j = 0; j < n; j++) {
                        slopes.ends[end][i][j] =
                            result(at, &by->slopes, end, i * size + j + (j >= of->pivot))[a];
                    }
                }
            }
            (void)newton_step(n, &values, &slopes, middle, room, &step, noise);
            for (int i = 0; i < n; i++) {
                known &= isfinite(step.ends[0][i]) && isfinite(step.ends[1][i]);
                inside &= step.ends[0][i] < room[i] && step.ends[1][i] < room[i];
            }
            if (known && inside) {
                for (int k = 0; k < size; k++) {
                    of->room[k * N + c] = at->near[0][k][a];
                }
                for (int i = 0; i < n; i++) {
                    of->most[i * N + c] = most(step.ends[0][i], step.ends[1][i]);
                }
                add(&proved, at, a);
            } else if (known) {
                for (int i = 0; i < n; i++) {
                    reach[i][c - begin] =
                        of->more * most(room[i], most(fabs(step.ends[0][i]), fabs(step.ends[1][i])));
                }
                further[left++] = at->of[a];
            }
        }
        if (by->borders && proved.count) {
            evaluated_of(by, &by->gaps, at, &proved);
        }
        for (int i = 0; i < proved.count; i++) {
            int sure = 1;
            for (int k = 0; k < by->borders; k++) {
                sure &= on_side(by->kinds[k], by->rooms[k], -result(at, &by->gaps, 0, k)[i],
                    result(at, &by->gaps, 1, k)[i]);
            }
            of->sure[proved.of[i]] = (uint8_t)sure;
        }
        at->count = left;
        memcpy(at->of, further, (size_t)left * sizeof(int32_t));
    }
}

/* A point on the desk, in a block that begins with number `begin` of N. */
static void at_point(const plan *by, desk *at, int i, const double *z, Py_ssize_t N) {
    for (int k = 0; k < by->n; k++) {
        at->ends[0][k][i] = -z[k * N + at->of[i]];
        at->ends[1][k][i] = z[k * N + at->of[i]];
    }
}

static double middle_result(const desk *at, const program *tape, int row, int i) {
    return middle_of(result(at, tape, 0, row)[i], result(at, tape, 1, row)[i]);
}

/* The inverse of slopes by all unknowns but the pivot, of which the tape has been evaluated. */
static void inverse_of_slopes(const plan *by, int pivot, const desk *at, int i, vector *to) {
    const int n = by->n - 1;
    const int columns = (int)by->slopes.outputs / n;
    vector slopes[MOST];
    for (int row = 0; row < n; row++) {
        for (int j = 0; j < n; j++) {
            slopes[row][j] = middle_result(at, &by->slopes, row * columns + j + (j >= pivot), i);
        }
    }
    inverse(n, slopes, to);
}

/* Steps of Newton's method, slopes renewed every other one, until each point stands still. */
static void corrected_block(
    const plan *by, int pivot, int steps, desk *at, double *z, Py_ssize_t N, Py_ssize_t begin) {
    const int n = by->n - 1;
    for (int step = 0; step < steps && at->count; step++) {
        for (int i = 0; i < at->count; i++) {
            at_point(by, at, i, z, N);
        }
        if (step % 2 == 0) {
            evaluated(by, &by->slopes, at);
            for (int i = 0; i < at->count; i++) {
                inverse_of_slopes(by, pivot, at, i, at->inverse[at->of[i] - begin]);
            }
        }
        evaluated(by, &by->values, at);
        int left = 0;
        for (int i = 0; i < at->count; i++) {
            vector *Y = at->inverse[at->of[i] - begin];
            int still = 1;
            for (int k = 0; k < n; k++) {
                double *to = z + (k + (k >= pivot)) * N + at->of[i];
                double way = 0.0;
                for (int j = 0; j < n; j++) {
                    way += Y[k][j] * middle_result(at, &by->values, j, i);
                }
                *to -= isfinite(way) ? way : 0.0;
                still &= !(fabs(way) >= 1e-13 * (1.0 + fabs(*to)));
            }
            if (!still) {
                at->of[left++] = at->of[i];
            }
        }
        at->count = left;
    }
}

static void tangents_block(const plan *by, int pivot, desk *at, const double *z, double *by_s,
    double *by_p, Py_ssize_t N) {
    const int size = by->n;
    const int n = size - 1;
    const int columns = (int)by->slopes.outputs / n;
    const int more = columns - size;
    for (int i = 0; i < at->count; i++) {
        at_point(by, at, i, z, N);
    }
    evaluated(by, &by->slopes, at);
    for (int i = 0; i < at->count; i++) {
        vector Y[MOST];
        inverse_of_slopes(by, pivot, at, i, Y);
        for (int column = -1; column < more; column++) {
            const int moved = column < 0 ? pivot : size + column;
            for (int k = 0; k < size; k++) {
                const int row = k - (k > pivot);
                double total = 0.0;
                for (int j = 0; k != pivot && j < n; j++) {
                    total += Y[row][j] * middle_result(at, &by->slopes, j * columns + moved, i);
                }
                if (column >= 0) {
                    by_p[(k * more + column) * N + at->of[i]] = -total;
                } else {
                    by_s[k * N + at->of[i]] = k == pivot ? 1.0 : -total;
                }
            }
        }
    }
}

/* -------------------------------------------------------------------------------------------------
 * Python */

/* A tape, (code, numbers, outputs, slots); nothing of None. */
static int as_program(PyObject *from, program *to) {
    const char *code;
    const char *numbers;
    Py_ssize_t codes;
    Py_ssize_t constants;
    memset(to, 0, sizeof *to);
    if (from == Py_None) {
        return 1;
    }
    if (!PyTuple_Check(from) ||
        !PyArg_ParseTuple(
            from, "y#y#nn", &code, &codes, &numbers, &constants, &to->outputs, &to->slots)) {
        return 0;
    }
    to->code = (const int32_t *)(const void *)code;
    to->operations = codes / (Py_ssize_t)(4 * sizeof(int32_t));
    to->numbers = (const double *)(const void *)numbers;
    to->constants = constants / (Py_ssize_t)sizeof(double);
    return 1;
}

/* Whether a tape has so many results of inputs with so many rows; if it is there at all. */
static int good(plan *by, const program *tape, Py_ssize_t results, int inputs, Py_ssize_t between) {
    const operand two[2] = {{.rows = by->n}, {.rows = by->parameters}};
    const operand three[3] = {{.rows = by->n}, {.rows = between}, {.rows = by->parameters}};
    by->slots = tape->slots > by->slots ? tape->slots : by->slots;
    by->results = tape->outputs > by->results ? tape->outputs : by->results;
    if (!tape->operations) {
        return !tape->outputs;
    }
    return tape->outputs == results && tape->slots > 0 &&
        sound(tape, inputs == 2 ? two : three, inputs);
}

static int all_good(plan *by) {
    const int n = by->n;
    const int m = by->coordinates;
    int whole =
        n >= 1 && n <= MOST && m >= 1 && m <= n && by->values.operations && by->slopes.operations;
    whole = whole && good(by, &by->values, n, 2, 0) && good(by, &by->slopes, n * n, 2, 0);
    whole = whole && good(by, &by->contraction, m + m * m, 3, m) &&
        good(by, &by->gaps, by->borders, 2, 0);
    whole = whole && good(by, &by->anchors, 2 * by->lines, 2, 0) &&
        good(by, &by->turnings, by->turnings.outputs, 2, 0);
    whole =
        whole && (!by->lines || by->anchors.operations) && (!by->borders || by->gaps.operations);
    for (int k = 0; whole && k < by->lines; k++) {
        const line *at = by->at + k;
        whole = good(by, &at->forces, 3 * m, 2, 0) && good(by, &at->direction, 2, 2, 0) &&
            good(by, &at->determinant, 1, 3, 2);
        whole = whole && (!at->determinant.operations || at->direction.operations);
    }
    for (int k = 0; whole && k < by->sides; k++) {
        whole = by->on_sides[k].operations && good(by, by->on_sides + k, n, 2, 0);
    }
    return whole;
}

static int borders_of(PyObject *from, plan *to) {
    to->borders = (int)PyTuple_GET_SIZE(from);
    for (int k = 0; k < to->borders && k < MOST_BORDERS; k++) {
        PyObject *entry = PyTuple_GET_ITEM(from, k);
        if (!PyTuple_Check(entry) || !PyArg_ParseTuple(entry, "id", to->kinds + k, to->rooms + k)) {
            return 0;
        }
    }
    return to->borders <= MOST_BORDERS;
}

static int lines_of(PyObject *from, plan *to) {
    to->lines = (int)PyTuple_GET_SIZE(from);
    for (int k = 0; k < to->lines && k < MOST_LINES; k++) {
        PyObject *forces;
        PyObject *direction;
        PyObject *determinant;
        line *at = to->at + k;
        PyObject *entry = PyTuple_GET_ITEM(from, k);
        if (!PyTuple_Check(entry) ||
            !PyArg_ParseTuple(entry, "OOO", &forces, &direction, &determinant)) {
            return 0;
        }
        if (!as_program(forces, &at->forces) || !as_program(direction, &at->direction) ||
            !as_program(determinant, &at->determinant)) {
            return 0;
        }
    }
    return to->lines <= MOST_LINES;
}

static int arcs_of(PyObject *from, plan *to) {
    Py_buffer arcs;
    if (taken(from, &arcs, PyBUF_STRIDED_RO) < 0) {
        return 0;
    }
    to->arcs = arcs.shape[1] == 2 && arcs.shape[2] <= MOST_ARCS ? (int)arcs.shape[2] : -1;
    for (int end = 0; end < 2; end++) {
        for (int j = 0; j < 2; j++) {
            for (int i = 0; i < to->arcs; i++) {
                to->arc[end][j][i] = *(double *)((char *)arcs.buf + end * arcs.strides[0] +
                    j * arcs.strides[1] + i * arcs.strides[2]);
            }
        }
    }
    PyBuffer_Release(&arcs);
    return to->arcs >= 0;
}

static int sides_of(PyObject *from, plan *to) {
    to->sides = (int)PyTuple_GET_SIZE(from);
    for (int k = 0; k < to->sides && k < MOST_SIDES; k++) {
        if (!as_program(PyTuple_GET_ITEM(from, k), to->on_sides + k)) {
            return 0;
        }
    }
    return to->sides <= MOST_SIDES;
}

static void forgotten(PyObject *capsule) {
    plan *by = PyCapsule_GetPointer(capsule, CAPSULE);
    if (by != NULL) {
        Py_DECREF(by->kept_alive);
        PyMem_Free(by);
    }
}

/* plan(n, coordinates, parameters, values, slopes, contraction, gaps, anchors, turnings, borders,
 * lines, arcs, sides) */
static PyObject *planned(PyObject *module, PyObject *arguments) {
    (void)module;
    PyObject *of[6];
    PyObject *borders;
    PyObject *lines;
    PyObject *arcs;
    PyObject *sides;
    plan *by = PyMem_Calloc(1, sizeof *by);
    if (by == NULL) {
        return PyErr_NoMemory();
    }
    program *const tapes[6] = {
        &by->values, &by->slopes, &by->contraction, &by->gaps, &by->anchors, &by->turnings};
    int whole = PyArg_ParseTuple(arguments, "iinOOOOOOO!O!OO!", &by->n, &by->coordinates,
        &by->parameters, of, of + 1, of + 2, of + 3, of + 4, of + 5, &PyTuple_Type, &borders,
        &PyTuple_Type, &lines, &arcs, &PyTuple_Type, &sides);
    for (int k = 0; whole && k < 6; k++) {
        whole = as_program(of[k], tapes[k]);
    }
    whole = whole && borders_of(borders, by) && lines_of(lines, by) && arcs_of(arcs, by) &&
        sides_of(sides, by) && all_good(by);
    PyObject *capsule = whole ? PyCapsule_New(by, CAPSULE, forgotten) : NULL;
    if (capsule == NULL) {
        PyMem_Free(by);
        if (!PyErr_Occurred()) {
            PyErr_SetString(PyExc_ValueError, "a tape of the search is not as its system is");
        }
        return NULL;
    }
    by->kept_alive = Py_NewRef(arguments);
    return capsule;
}

/* A desk for a plan and parameters of N boxes, shape (2, parameters, N). */
static desk *opened(const plan *by, PyObject *from, Py_buffer *parameters, Py_ssize_t N) {
    if (taken(from, parameters, PyBUF_STRIDED_RO) < 0) {
        return NULL;
    }
    desk *at = NULL;
    if (parameters->shape[1] != by->parameters || parameters->shape[2] != N || N > INT32_MAX) {
        PyErr_SetString(PyExc_ValueError, "parameters do not have the shape of the boxes");
    } else {
        at = PyMem_Calloc(1, sizeof *at);
        slot *slots = PyMem_Malloc((size_t)by->slots * sizeof(slot));
        double *out = PyMem_Malloc((size_t)by->results * 2 * BLOCK * sizeof(double));
        if (at == NULL || slots == NULL || out == NULL) {
            PyMem_Free(at);
            PyMem_Free(slots);
            PyMem_Free(out);
            PyErr_NoMemory();
            at = NULL;
        } else {
            at->slots = slots;
            at->out = out;
            at->parameters = (operand){parameters->buf,
                {parameters->strides[0], parameters->strides[1], parameters->strides[2]},
                parameters->shape[1], NULL};
        }
    }
    if (at == NULL) {
        PyBuffer_Release(parameters);
    }
    return at;
}

static void cleared(desk *at, Py_buffer *parameters) {
    PyMem_Free(at->slots);
    PyMem_Free(at->out);
    PyMem_Free(at);
    PyBuffer_Release(parameters);
}

/* Whether buffers are of as many bytes as they should be. */
static int fit(const Py_buffer *given, const Py_ssize_t *sizes, int count) {
    for (int k = 0; k < count; k++) {
        if (given[k].len != sizes[k]) {
            PyErr_SetString(
                PyExc_ValueError, "arrays of boxes do not have the shapes of one another");
            return 0;
        }
    }
    return 1;
}

static PyObject *kept(PyObject *module, PyObject *arguments) {
    (void)module;
    PyObject *capsule;
    PyObject *given_parameters;
    Py_buffer of[3];
    Py_buffer parameters;
    double margin;
    if (!PyArg_ParseTuple(
            arguments, "Oy*Odw*w*", &capsule, of, &given_parameters, &margin, of + 1, of + 2)) {
        return NULL;
    }
    const plan *by = PyCapsule_GetPointer(capsule, CAPSULE);
    desk *at = NULL;
    if (by != NULL) {
        const Py_ssize_t N = of[2].len;
        const Py_ssize_t size = (Py_ssize_t)sizeof(double) * 2 * by->n * N;
        const Py_ssize_t sizes[] = {size, size, N};
        at = fit(of, sizes, 3) ? opened(by, given_parameters, &parameters, N) : NULL;
        if (at != NULL) {
            memset(of[2].buf, 0, (size_t)N);
            Py_BEGIN_ALLOW_THREADS for (Py_ssize_t begin = 0; begin < N; begin += BLOCK) {
                laid_out(by, at, of[0].buf, N, begin);
                kept_block(by, at, of[0].buf, N, margin, of[1].buf, of[2].buf);
            }
            Py_END_ALLOW_THREADS cleared(at, &parameters);
        }
    }
    release(of, 3);
    if (at == NULL) {
        return NULL;
    }
    Py_RETURN_NONE;
}

static PyObject *decided(PyObject *module, PyObject *arguments) {
    (void)module;
    PyObject *capsule;
    PyObject *given_parameters;
    Py_buffer of[10];
    Py_buffer parameters;
    judgement to;
    if (!PyArg_ParseTuple(arguments, "Oy*y*Oy*y*y*i" RULES "w*w*w*w*w*", &capsule, of, of + 1,
            &given_parameters, of + 2, of + 3, of + 4, &to.sharp, INTO_RULES(to.by), of + 5, of + 6, of + 7,
            of + 8, of + 9)) {
        return NULL;
    }
    const plan *by = PyCapsule_GetPointer(capsule, CAPSULE);
    desk *at = NULL;
    if (by != NULL) {
        const Py_ssize_t N = of[8].len;
        const Py_ssize_t one = (Py_ssize_t)sizeof(double) * 2 * by->n;
        const Py_ssize_t sizes[] = {one * N, one * N, one, N, N, one * N, one * N, one * N, N,
            N * (Py_ssize_t)sizeof(int64_t)};
        at = fit(of, sizes, 10) ? opened(by, given_parameters, &parameters, N) : NULL;
        if (at != NULL) {
            to.given = of[0].buf;
            to.boxes = of[1].buf;
            to.limits = of[2].buf;
            to.single = of[3].buf;
            to.spent = of[4].buf;
            to.wide = of[5].buf;
            to.step = of[6].buf;
            to.left = of[7].buf;
            to.verdicts = of[8].buf;
            to.along = of[9].buf;
            Py_BEGIN_ALLOW_THREADS for (Py_ssize_t begin = 0; begin < N; begin += BLOCK) {
                laid_out(by, at, of[1].buf, N, begin);
                decided_block(by, at, &to, N);
            }
            Py_END_ALLOW_THREADS cleared(at, &parameters);
        }
    }
    release(of, 10);
    if (at == NULL) {
        return NULL;
    }
    Py_RETURN_NONE;
}

static PyObject *tubes(PyObject *module, PyObject *arguments) {
    (void)module;
    PyObject *tapes[3];
    PyObject *borders;
    PyObject *given_parameters;
    Py_buffer of[9];
    Py_buffer parameters;
    tube to;
    desk *at = NULL;
    memset(&to, 0, sizeof to);
    plan *by = &to.by;
    if (!PyArg_ParseTuple(arguments, "(OOO)O!Oidiy*y*y*y*y*y*w*w*w*", tapes, tapes + 1, tapes + 2,
            &PyTuple_Type, &borders, &given_parameters, &to.pivot, &to.more, &to.times, of, of + 1,
            of + 2, of + 3, of + 4, of + 5, of + 6, of + 7, of + 8)) {
        return NULL;
    }
    const Py_ssize_t N = to.N = of[8].len;
    const Py_ssize_t row = N * (Py_ssize_t)sizeof(double);
    if (!N) {
        release(of, 9);
        Py_RETURN_NONE;
    }
    by->n = (int)(of[0].len / row);
    const int n = by->n - 1;
    const Py_ssize_t every = row * by->n;
    const Py_ssize_t sizes[] = {every, every, every, row, every, row * n, every, row * n, N};
    int whole = n >= 1 && by->n <= MOST && to.pivot >= 0 && to.pivot <= n;
    whole = whole && as_program(tapes[0], &by->values) && as_program(tapes[1], &by->slopes) &&
        as_program(tapes[2], &by->gaps) && borders_of(borders, by);
    if (whole && taken(given_parameters, &parameters, PyBUF_STRIDED_RO) == 0) {
        by->parameters = parameters.shape[1];
        PyBuffer_Release(&parameters);
        whole = by->values.operations && by->slopes.operations &&
            good(by, &by->values, n, 2, 0) && good(by, &by->slopes, n * (n + 1), 2, 0) &&
            good(by, &by->gaps, by->borders, 2, 0) && (!by->borders || by->gaps.operations);
        at = whole && fit(of, sizes, 9) ? opened(by, given_parameters, &parameters, N) : NULL;
    }
    if (at != NULL) {
        to.z = of[0].buf;
        to.along = of[1].buf;
        to.swing = of[2].buf;
        to.moved = of[3].buf;
        to.beside = of[4].buf;
        to.least = of[5].buf;
        to.room = of[6].buf;
        to.most = of[7].buf;
        to.sure = of[8].buf;
        Py_BEGIN_ALLOW_THREADS for (Py_ssize_t begin = 0; begin < N; begin += BLOCK) {
            tubes_of_block(&to, at, begin);
        }
        Py_END_ALLOW_THREADS cleared(at, &parameters);
    } else if (!PyErr_Occurred()) {
        PyErr_SetString(PyExc_ValueError, "a tape of tubes is not as its system is");
    }
    release(of, 9);
    if (at == NULL) {
        return NULL;
    }
    Py_RETURN_NONE;
}

static PyObject *bytes_of(const pile *from, int n) {
    const Py_ssize_t size = from->count * 2 * n * (Py_ssize_t)sizeof(double);
    return PyBytes_FromStringAndSize((const char *)from->boxes, size);
}

static PyObject *rounds(PyObject *module, PyObject *arguments) {
    (void)module;
    PyObject *capsule;
    PyObject *given_parameters;
    Py_buffer of[2];
    Py_buffer parameters;
    Py_ssize_t budget;
    Py_ssize_t limit;
    judgement to;
    outcome found;
    memset(&found, 0, sizeof found);
    if (!PyArg_ParseTuple(arguments, "Oy*Oy*i" RULES "nn", &capsule, of, &given_parameters, of + 1,
            &to.sharp, INTO_RULES(to.by), &budget, &limit)) {
        return NULL;
    }
    const plan *by = PyCapsule_GetPointer(capsule, CAPSULE);
    PyObject *out = NULL;
    desk *at = NULL;
    Py_ssize_t looks = -1;
    if (by != NULL) {
        const Py_ssize_t one = 2 * by->n * (Py_ssize_t)sizeof(double);
        const Py_ssize_t N = of[0].len / one;
        const Py_ssize_t sizes[] = {N * one, one};
        at = fit(of, sizes, 2) ? opened(by, given_parameters, &parameters, 1) : NULL;
        int whole = at != NULL;
        for (Py_ssize_t i = 0; i < N && whole; i++) {
            whole = piled(&found.further, by->n, of[0].buf, N, i) != NULL;
        }
        if (whole) {
            at->parameters.strides[2] = 0; /* those of the point, for every box */
            to.limits = of[1].buf;
            Py_BEGIN_ALLOW_THREADS looks = all_rounds(by, at, &to, budget, limit, &found);
            Py_END_ALLOW_THREADS
        }
        if (at != NULL) {
            cleared(at, &parameters);
        }
    }
    if (looks >= 0) {
        out = Py_BuildValue("nNNNN", looks, bytes_of(&found.unique, by->n),
            bytes_of(&found.where, by->n), bytes_of(&found.undecided, by->n),
            bytes_of(&found.further, by->n));
    } else if (!PyErr_Occurred()) {
        PyErr_NoMemory();
    }
    PyMem_RawFree(found.unique.boxes);
    PyMem_RawFree(found.where.boxes);
    PyMem_RawFree(found.undecided.boxes);
    PyMem_RawFree(found.further.boxes);
    release(of, 2);
    return out;
}

/* What `corrected` and `tangents` are given: tapes of values and slopes of a system with a pivot, z
 * of shape (n + 1, N), and a desk; NULL with an error where these do not fit. */
static desk *opened_at_points(PyObject *const tapes[2], PyObject *given_parameters, int pivot,
    const Py_buffer *z, plan *by, Py_buffer *parameters, Py_ssize_t *N) {
    memset(by, 0, sizeof *by);
    if (!as_program(tapes[0], &by->values) || !as_program(tapes[1], &by->slopes) ||
        taken(given_parameters, parameters, PyBUF_STRIDED_RO) < 0) {
        return NULL;
    }
    by->parameters = parameters->shape[1];
    *N = parameters->shape[2];
    PyBuffer_Release(parameters);
    const Py_ssize_t n = by->values.outputs;
    by->n = (int)n + 1;
    const Py_ssize_t columns = n > 0 ? by->slopes.outputs / n : 0;
    if (n < 1 || by->n > MOST || pivot < 0 || pivot > n || columns <= n ||
        z->len != by->n * *N * (Py_ssize_t)sizeof(double) || !by->values.operations ||
        !by->slopes.operations || !good(by, &by->values, n, 2, 0) ||
        !good(by, &by->slopes, n * columns, 2, 0)) {
        PyErr_SetString(PyExc_ValueError, "tapes of points are not as their system is");
        return NULL;
    }
    return opened(by, given_parameters, parameters, *N);
}

static void placed(desk *at, Py_ssize_t N, Py_ssize_t begin) {
    at->count = (int)(N - begin < BLOCK ? N - begin : BLOCK);
    for (int i = 0; i < at->count; i++) {
        at->of[i] = (int32_t)(begin + i);
    }
}

static PyObject *corrected(PyObject *module, PyObject *arguments) {
    (void)module;
    PyObject *tapes[2];
    PyObject *given_parameters;
    Py_buffer z;
    Py_buffer parameters;
    Py_ssize_t N;
    plan by;
    int pivot;
    int steps;
    if (!PyArg_ParseTuple(
            arguments, "(OO)Oiiw*", tapes, tapes + 1, &given_parameters, &pivot, &steps, &z)) {
        return NULL;
    }
    desk *at = opened_at_points(tapes, given_parameters, pivot, &z, &by, &parameters, &N);
    if (at != NULL) {
        Py_BEGIN_ALLOW_THREADS for (Py_ssize_t begin = 0; begin < N; begin += BLOCK) {
            placed(at, N, begin);
            corrected_block(&by, pivot, steps, at, z.buf, N, begin);
        }
        Py_END_ALLOW_THREADS cleared(at, &parameters);
    }
    release(&z, 1);
    if (at == NULL) {
        return NULL;
    }
    Py_RETURN_NONE;
}

static PyObject *tangents(PyObject *module, PyObject *arguments) {
    (void)module;
    PyObject *tapes[2];
    PyObject *given_parameters;
    Py_buffer of[3];
    Py_buffer parameters;
    Py_ssize_t N;
    plan by;
    int pivot;
    if (!PyArg_ParseTuple(arguments, "(OO)Oiy*w*w*", tapes, tapes + 1, &given_parameters,
            &pivot, of, of + 1, of + 2)) {
        return NULL;
    }
    desk *at = opened_at_points(tapes, given_parameters, pivot, of, &by, &parameters, &N);
    if (at != NULL) {
        const Py_ssize_t more = by.slopes.outputs / (by.n - 1) - by.n;
        const Py_ssize_t sizes[] = {of->len, of->len, of->len * more};
        if (!fit(of, sizes, 3)) {
            cleared(at, &parameters);
            at = NULL;
        }
    }
    if (at != NULL) {
        Py_BEGIN_ALLOW_THREADS for (Py_ssize_t begin = 0; begin < N; begin += BLOCK) {
            placed(at, N, begin);
            tangents_block(&by, pivot, at, of[0].buf, of[1].buf, of[2].buf, N);
        }
        Py_END_ALLOW_THREADS cleared(at, &parameters);
    }
    release(of, 3);
    if (at == NULL) {
        return NULL;
    }
    Py_RETURN_NONE;
}

static PyMethodDef methods[] = {
    {"corrected", corrected, METH_VARARGS, "Newton's method at points with a pivot."},
    {"tangents", tangents, METH_VARARGS, "Slopes by a pivot and by free parameters at points."},
    {"plan", planned, METH_VARARGS, "Tapes by which a search looks at boxes."},
    {"kept", kept, METH_VARARGS, "What is left of boxes, and which may hold a root."},
    {"tubes", tubes, METH_VARARGS, "Boxes that hold one state for each value of a pivot."},
    {"rounds", rounds, METH_VARARGS, "A search at one point."},
    {"decided", decided, METH_VARARGS, "What becomes of boxes that may hold a root."},
    {NULL, NULL, 0, NULL}};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_search", NULL, -1, methods, NULL, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__search(void) { return PyModule_Create(&definition); }
