/* Branch and prune by recorded functions ("tapes"): boxes that hold no root are removed, the others
 * are proved to hold exactly one, left undecided, contracted or halved.
 *
 * The same tests in the same order, and so the same bits, as boxes.py, systems.py and verdicts.py
 * have with NumPy, which decide what is searched next.
 *
 * plan(...): a capsule with the tapes of a system, see `plan` below.
 *
 * kept(plan, given, parameters, margin, boxes, keep): writes the contracted boxes, and marks in
 * `keep` those that may hold a root.
 *
 * decided(plan, given, boxes, parameters, limits, single, spent, sharp, rules, wide, step, left,
 * verdicts, along): writes the verdict on each box, see BoxVerdict in verdicts.py.
 *
 * rounds(plan, given, parameters, limits, sharp, rules, budget, most): `kept` and `decided` for the
 * boxes of one point of the parameters, and again for the halves of these, until none is left or
 * more than `most` are. Returns the number of boxes looked at, and as bytes, box by box: boxes with
 * exactly one root, enclosures of these roots, undecided boxes, and boxes not looked at yet.
 *
 * tubes(tapes, borders, parameters, pivot, inflation, times, z, by_s, swing, half_pivot, beside,
 * reach, radius, remainder, proved): boxes that hold exactly one state for each value of a pivot,
 * see Place in tubes.py.
 *
 * corrected(tapes, parameters, pivot, steps, z): Newton's method for all unknowns but the pivot, in
 * place. tangents(tapes, parameters, pivot, z, by_s, by_p): derivatives of these unknowns by the
 * pivot, and by the parameters for which the tape of slopes has further columns. Both evaluate at
 * points and take midpoints of the enclosures.
 *
 * Arrays of boxes are contiguous doubles of shape (2, n, N) with −low and high first, limits (2,
 * n); parameters of shape (2, P, N) with any strides; keep, single, spent and verdicts bytes, along
 * int64, of shape (N,).
 *
 * Rounding: see _rounding.h. NaN bounds nothing: every comparison by which a box is removed is
 * false with it. */
#include "_arrays.h"

#include <math.h>

#include "_newton.h"
#include "_operations.h"

#define MAX_LINES 8
#define MAX_BORDERS 8
#define MAX_SIDES 16
#define MAX_ARCS 64
#define CAPSULE "spragsym search"

/* What a contact requires of its gap: not above 0 where it touches, not below 0 where it is open,
 * and above 0 where it is open and the border itself belongs to the touching side. */
enum { TOUCHING,
    OPEN,
    OPEN_AND_OFF,
    KINDS_OF_BORDERS };

/* Tapes for boxes near the anchor of a spring, where the direction of its line is not known: the
 * forces G + M u for a direction u, the direction over the box, and the determinant of the slopes
 * times the length, for directions on an arc. */
typedef struct {
    program forces;
    program direction;
    program determinant;
} line;

/* Tapes of a system of n equations in n unknowns. A tape without results is not evaluated. The
 * contraction is in the first `coordinates` unknowns. */
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
    int kinds[MAX_BORDERS];
    double rooms[MAX_BORDERS];
    int lines;
    line at[MAX_LINES];
    int arcs;
    double arc[2][2][MAX_ARCS];
    int sides;
    program on_sides[MAX_SIDES];
    Py_ssize_t slots;
    Py_ssize_t results;
} plan;

/* The boxes of one block that are still open, and memory for the results of tapes. `of` is the
 * number of each box in the arrays of the caller. */
typedef struct {
    int count;
    int32_t of[BLOCK];
    double ends[2][MAX_UNKNOWNS][BLOCK];
    double near[2][MAX_UNKNOWNS][BLOCK];
    double values[2][MAX_UNKNOWNS][BLOCK];
    vector inverse[BLOCK][MAX_UNKNOWNS];
    operand parameters;
    slot *slots;
    double *out;
} workspace;

/* Some boxes of a workspace: their places there, and their numbers in the arrays of the caller. */
typedef struct {
    int count;
    int32_t place[BLOCK];
    int32_t of[BLOCK];
} selection;

static operand rows_of(double (*ends)[MAX_UNKNOWNS][BLOCK], int rows, const int32_t *of) {
    return (operand){(const char *)ends,
        {sizeof(double) * MAX_UNKNOWNS * BLOCK, sizeof(double) * BLOCK, sizeof(double)}, rows, of};
}

static operand parameters_of(const workspace *at, const int32_t *of) {
    operand out = at->parameters;
    out.of = of;
    return out;
}

/* One row of results of a tape, −low for end 0 and high for end 1. */
static const double *result(const workspace *at, const program *tape, int end, int row) {
    return at->out + (end * tape->outputs + row) * BLOCK;
}

static void select_box(selection *to, const workspace *at, int i) {
    to->place[to->count] = i;
    to->of[to->count++] = at->of[i];
}

static void evaluate_over(
    const plan *by, const program *tape, workspace *at, double (*ends)[MAX_UNKNOWNS][BLOCK]) {
    const operand inputs[2] = {rows_of(ends, by->n, NULL), parameters_of(at, at->of)};
    block(tape, inputs, at->slots, at->out, BLOCK, 0, at->count);
}

static void evaluate(const plan *by, const program *tape, workspace *at) {
    evaluate_over(by, tape, at, at->ends);
}

static void evaluate_selection(
    const plan *by, const program *tape, workspace *at, const selection *boxes) {
    const operand inputs[2] = {
        rows_of(at->ends, by->n, boxes->place), parameters_of(at, boxes->of)};
    block(tape, inputs, at->slots, at->out, BLOCK, 0, boxes->count);
}

/* Whether some result of a tape is bounded away from 0, so that the box holds no root of it. */
static int excludes_zero(const workspace *at, const program *tape, int i) {
    for (int row = 0; row < tape->outputs; row++) {
        if (result(at, tape, 0, row)[i] < 0.0 || result(at, tape, 1, row)[i] < 0.0) {
            return 1;
        }
    }
    return 0;
}

/* Remove marked boxes; the others keep their order. */
static void remove_boxes(const plan *by, workspace *at, const uint8_t *gone) {
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

/* Contract boxes in place by one interval Newton step with frozen directions of springs, those over
 * the box. A box that becomes empty is marked. */
static void contract(const plan *by, workspace *at, uint8_t *gone) {
    const int n = by->coordinates;
    if (n < 1) {
        return;
    }
    for (int k = 0; k < n; k++) {
        for (int i = 0; i < at->count; i++) {
            const double middle = midpoint(at->ends[0][k][i], at->ends[1][k][i]);
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
                at->ends[end][k][i] = minimum_of_known(step.ends[end][k], given.ends[end][k]);
            }
            gone[i] |= at->ends[0][k][i] + at->ends[1][k][i] < 0.0;
        }
    }
}

/* Widen contracted boxes by a margin, but not beyond the boxes that were given. */
static void add_margin(
    const plan *by, workspace *at, const double *given, Py_ssize_t N, double margin) {
    for (int k = 0; k < by->n; k++) {
        for (int i = 0; i < at->count; i++) {
            const double before[2] = {given[k * N + at->of[i]], given[(by->n + k) * N + at->of[i]]};
            const double room = margin * rounded_up(before[0] + before[1], 1.0);
            for (int end = 0; end < 2; end++) {
                at->ends[end][k][i] = minimum_of_known(at->ends[end][k][i] + room, before[end]);
            }
        }
    }
}

/* -------------------------------------------------------------------------------------------------
 * boxes without a root */

static void mark_without_zero(const plan *by, workspace *at, uint8_t *gone) {
    evaluate(by, &by->values, at);
    for (int i = 0; i < at->count; i++) {
        gone[i] |= (uint8_t)excludes_zero(at, &by->values, i);
    }
}

/* Whether the whole gap violates what the contact requires. */
static int is_beyond(int kind, double room, double low, double high) {
    return kind == TOUCHING ? -low > room : kind == OPEN ? high < -room :
                                                           high <= 0.0;
}

static void mark_beyond_borders(const plan *by, workspace *at, uint8_t *gone) {
    if (by->borders) {
        evaluate(by, &by->gaps, at);
    }
    for (int k = 0; k < by->borders; k++) {
        const double *low = result(at, &by->gaps, 0, k);
        const double *high = result(at, &by->gaps, 1, k);
        for (int i = 0; i < at->count; i++) {
            gone[i] |= (uint8_t)is_beyond(by->kinds[k], by->rooms[k], low[i], high[i]);
        }
    }
}

/* Find the boxes that are no farther from the anchor of each line than their size. In other boxes
 * the direction varies so little that the equations themselves decide. */
static void find_near_anchors(const plan *by, workspace *at, uint8_t (*near)[BLOCK]) {
    evaluate(by, &by->anchors, at);
    for (int k = 0; k < by->lines; k++) {
        for (int i = 0; i < at->count; i++) {
            double sizes[2];
            double widths = 0.0;
            for (int j = 0; j < 2; j++) {
                const double low = result(at, &by->anchors, 0, 2 * k + j)[i];
                const double high = result(at, &by->anchors, 1, 2 * k + j)[i];
                sizes[j] = mignitude(low, high);
                widths += rounded_up(low + high, 1.0);
            }
            near[k][i] = hypot(sizes[0], sizes[1]) <= widths;
        }
    }
}

/* Whether G + M u = 0 holds for no unit vector u of two components, see no_unit_vector in
 * contractors.py. Results of the tape are G and then M. */
static int no_unit_vector(const workspace *at, const program *tape, int n, int i) {
    double m[MAX_UNKNOWNS][2];
    vector gram[MAX_UNKNOWNS] = {{0.0}};
    vector inverted[MAX_UNKNOWNS];
    double length[2] = {0.0, 0.0};
    for (int k = 0; k < n; k++) {
        for (int j = 0; j < 2; j++) {
            m[k][j] = midpoint(
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
        double low[3][MAX_UNKNOWNS];
        double high[3][MAX_UNKNOWNS];
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
                off[0] = rounded_up(off[0] + 1.0, 1.0);
                off[1] = rounded_up(off[1] - 1.0, 1.0);
            }
            sizes[column] = maximum(off[0], off[1]);
        }
        const double slack = (sizes[0] + sizes[1]) * (1 + 4 * EPS);
        double u[2];
        dot(n, P, low[2], high[2], 1, u, u + 1);
        u[0] = rounded_up(u[0] + slack, 1.0);
        u[1] = rounded_up(u[1] + slack, 1.0);
        const double near = mignitude(u[0], u[1]);
        const double far = maximum(u[0], u[1]);
        length[0] += minimum(rounded_up(-(near * near), 1.0), 0.0);
        length[1] += rounded_up(far * far, 1.0);
    }
    return -rounded_up(length[0], 1.0) > 1.0 || rounded_up(length[1], 1.0) < 1.0;
}

/* Mark boxes at an anchor in which no direction of the line balances the forces. */
static void mark_without_direction(
    const plan *by, workspace *at, const uint8_t (*near)[BLOCK], uint8_t *gone) {
    for (int k = 0; k < by->lines; k++) {
        const program *tape = &by->at[k].forces;
        selection boxes = {.count = 0};
        for (int i = 0; tape->outputs && i < at->count; i++) {
            if (near[k][i] && !gone[i]) {
                select_box(&boxes, at, i);
            }
        }
        if (boxes.count) {
            evaluate_selection(by, tape, at, &boxes);
        }
        for (int i = 0; i < boxes.count; i++) {
            gone[boxes.place[i]] = (uint8_t)no_unit_vector(at, tape, (int)tape->outputs / 3, i);
        }
    }
}

/* Test pairs of boxes and arcs: a box whose determinant may be 0 for a direction on the arc is not
 * regular. */
static void test_arcs(const plan *by, const program *tape, workspace *at, selection *pairs,
    const int32_t *arcs, uint8_t *regular) {
    const operand inputs[3] = {rows_of(at->ends, by->n, pairs->place),
        {(const char *)by->arc, {sizeof by->arc[0], sizeof by->arc[0][0], sizeof(double)}, 2, arcs},
        parameters_of(at, pairs->of)};
    block(tape, inputs, at->slots, at->out, BLOCK, 0, pairs->count);
    for (int i = 0; i < pairs->count; i++) {
        regular[pairs->place[i]] &= (uint8_t)excludes_zero(at, tape, i);
    }
    pairs->count = 0;
}

/* Test each box with the arcs on which the direction of a line may lie, either every eighth arc or
 * the other ones. Every eighth comes first: most boxes that are not regular fail there. */
static void test_directions(const plan *by, int number, workspace *at, const selection *boxes,
    const double (*known)[2][BLOCK], int eighth, uint8_t *regular) {
    selection pairs = {.count = 0};
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
                select_box(&pairs, at, boxes->place[i]);
            }
            if (pairs.count == BLOCK) {
                test_arcs(by, &by->at[number].determinant, at, &pairs, arcs, regular);
            }
        }
    }
    if (pairs.count) {
        test_arcs(by, &by->at[number].determinant, at, &pairs, arcs, regular);
    }
}

/* Mark boxes at an anchor whose determinant is not 0 for any direction of the line. */
static void mark_regular_at_anchors(
    const plan *by, workspace *at, const uint8_t (*near)[BLOCK], uint8_t *gone) {
    for (int k = 0; k < by->lines; k++) {
        const program *tape = &by->at[k].direction;
        double known[2][2][BLOCK];
        selection boxes = {.count = 0};
        uint8_t regular[BLOCK];
        for (int i = 0; by->at[k].determinant.outputs && i < at->count; i++) {
            regular[i] = 1;
            if (near[k][i] && !gone[i]) {
                select_box(&boxes, at, i);
            }
        }
        if (!boxes.count) {
            continue;
        }
        evaluate_selection(by, tape, at, &boxes);
        for (int end = 0; end < 2; end++) {
            for (int j = 0; j < 2; j++) {
                memcpy(known[end][j], result(at, tape, end, j), sizeof known[end][j]);
            }
        }
        test_directions(by, k, at, &boxes, known, 1, regular);
        test_directions(by, k, at, &boxes, known, 0, regular);
        for (int i = 0; i < boxes.count; i++) {
            gone[boxes.place[i]] = regular[boxes.place[i]];
        }
    }
}

/* Mark boxes that meet the ray on which the angle of a torsion spring jumps, and hold no root with
 * the angle of either side. */
static void mark_without_sides(const plan *by, workspace *at, uint8_t *gone) {
    const program *tape = &by->turnings;
    selection boxes = {.count = 0};
    if (!tape->outputs) {
        return;
    }
    evaluate(by, tape, at);
    for (int i = 0; i < at->count; i++) {
        int jumps = 0;
        for (int row = 0; row < tape->outputs; row++) {
            jumps |= isnan(result(at, tape, 0, row)[i]) != 0;
        }
        if (jumps && !gone[i]) {
            select_box(&boxes, at, i);
        }
    }
    for (int side = 0; side < by->sides && boxes.count; side++) {
        evaluate_selection(by, by->on_sides + side, at, &boxes);
        const int asked = boxes.count;
        boxes.count = 0;
        for (int i = 0; i < asked; i++) {
            if (excludes_zero(at, by->on_sides + side, i)) {
                select_box(&boxes, at, boxes.place[i]);
            }
        }
    }
    for (int i = 0; i < boxes.count; i++) {
        gone[boxes.place[i]] = 1;
    }
}

/* Mark boxes without a state of the contact combination. */
static void mark_without_state(const plan *by, workspace *at, uint8_t *gone) {
    mark_beyond_borders(by, at, gone);
    if (by->lines) {
        uint8_t near[MAX_LINES][BLOCK];
        find_near_anchors(by, at, near);
        mark_without_direction(by, at, near, gone);
        mark_regular_at_anchors(by, at, near, gone);
    }
    mark_without_sides(by, at, gone);
}

/* `kept` for one block. */
static void contract_block(const plan *by, workspace *at, const double *given, Py_ssize_t N,
    double margin, double *boxes, uint8_t *keep) {
    uint8_t gone[BLOCK] = {0};
    if (by->contraction.operations) {
        contract(by, at, gone);
    }
    add_margin(by, at, given, N, margin);
    for (int end = 0; end < 2; end++) {
        for (int k = 0; k < by->n; k++) {
            memcpy(boxes + (end * by->n + k) * N + at->of[0], at->ends[end][k],
                (size_t)at->count * sizeof(double));
        }
    }
    mark_without_zero(by, at, gone);
    remove_boxes(by, at, gone);
    if (at->count) {
        memset(gone, 0, sizeof gone);
        mark_without_state(by, at, gone);
        remove_boxes(by, at, gone);
    }
    for (int i = 0; i < at->count; i++) {
        keep[at->of[i]] = 1;
    }
}

/* -------------------------------------------------------------------------------------------------
 * verdicts */

/* Arguments and results of `decided`. */
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

/* Widen boxes, so that a root on the border of a box, or beside it by rounding, lies well inside;
 * their midpoints go to `near`. */
static void widen(const plan *by, workspace *at, const judgement *of, Py_ssize_t N) {
    const int n = by->n;
    for (int k = 0; k < n; k++) {
        for (int i = 0; i < at->count; i++) {
            const Py_ssize_t place = k * N + at->of[i];
            const double ends[2] = {of->boxes[place], of->boxes[n * N + place]};
            const double room = of->by.margin * rounded_up(ends[0] + ends[1], 1.0) +
                of->by.finest * scale_of(ends[0], ends[1]);
            const double middle = midpoint(ends[0], ends[1]);
            at->near[0][k][i] = -middle;
            at->near[1][k][i] = middle;
            for (int end = 0; end < 2; end++) {
                at->ends[end][k][i] = minimum(ends[end] + room, of->limits[end * n + k]);
            }
        }
    }
}

/* `decided` for one block. */
static void judge_block(const plan *by, workspace *at, const judgement *of, Py_ssize_t N) {
    const int n = by->n;
    widen(by, at, of, N);
    evaluate_over(by, &by->values, at, at->near);
    for (int end = 0; end < 2; end++) {
        for (int k = 0; k < n; k++) {
            memcpy(at->values[end][k], result(at, &by->values, end, k), sizeof at->values[end][k]);
        }
    }
    evaluate(by, &by->slopes, at);
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
            (int8_t)judge_box(n, &of->by, of->sharp, of->single[place], of->spent[place], &values,
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

/* Load a block of boxes, from number `begin` of N on. */
static void load_boxes(
    const plan *by, workspace *at, const double *given, Py_ssize_t N, Py_ssize_t begin) {
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

/* A list of boxes that grows, of 2 n doubles each. */
typedef struct {
    double *boxes;
    Py_ssize_t count;
    Py_ssize_t room;
} box_list;

/* Results of a search: boxes with one root, enclosures of these roots, undecided boxes, and boxes
 * that are searched further. */
typedef struct {
    box_list unique;
    box_list where;
    box_list undecided;
    box_list further;
} outcome;

/* The place of one more box; NULL without memory. */
static double *append_slot(box_list *to, int n) {
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

/* Append box j of M in an array of boxes to a list; NULL without memory. */
static double *append_box(box_list *to, int n, const double *from, Py_ssize_t M, Py_ssize_t j) {
    double *box = append_slot(to, n);
    for (int k = 0; box != NULL && k < 2 * n; k++) {
        box[k] = from[k * M + j];
    }
    return box;
}

/* Append one half of a box. It is not cut in the middle, where symmetric systems have roots. */
static int append_half(
    box_list *to, const judgement *of, int n, Py_ssize_t M, Py_ssize_t j, int upper) {
    double *box = append_box(to, n, of->left, M, j);
    if (box == NULL) {
        return 0;
    }
    const Py_ssize_t along = of->along[j];
    const double low = -box[along];
    const double high = box[n + along];
    const double cut = minimum(maximum(low + 0.4921875 * (high - low), low), high);
    box[upper ? along : n + along] = upper ? -cut : cut;
    return 1;
}

/* Distribute M judged boxes to the lists. Boxes to search further: those that became much narrower,
 * then all lower halves, then all upper halves. 0 without memory. */
static int distribute(const judgement *of, int n, Py_ssize_t M, outcome *to) {
    int whole = 1;
    for (Py_ssize_t j = 0; j < M && whole; j++) {
        if (of->verdicts[j] == PROVED) {
            whole = append_box(&to->unique, n, of->wide, M, j) != NULL &&
                append_box(&to->where, n, of->step, M, j) != NULL;
        } else if (of->verdicts[j] == UNDECIDED) {
            whole = append_box(&to->undecided, n, of->left, M, j) != NULL;
        } else if (of->verdicts[j] == AGAIN) {
            whole = append_box(&to->further, n, of->left, M, j) != NULL;
        }
    }
    for (int upper = 0; upper < 2; upper++) {
        for (Py_ssize_t j = 0; j < M && whole; j++) {
            whole = of->verdicts[j] != HALVED || append_half(&to->further, of, n, M, j, upper);
        }
    }
    return whole;
}

/* One round of the search: N boxes are contracted, judged and distributed; 0 without memory. */
static int search_round(const plan *by, workspace *at, judgement *of, int spent,
    const double *given, Py_ssize_t N, outcome *to) {
    const int rows = 2 * by->n;
    const Py_ssize_t size = rows * N;
    double *room = PyMem_RawMalloc(
        (size_t)size * 6 * sizeof(double) + (size_t)N * (sizeof(int64_t) + 4 * sizeof(uint8_t)));
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
        load_boxes(by, at, given, N, begin);
        contract_block(by, at, given, N, of->by.margin, parts[0], keep);
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
        load_boxes(by, at, of->boxes, M, begin);
        judge_block(by, at, of, M);
    }
    const int whole = distribute(of, by->n, M, to);
    PyMem_RawFree(room);
    return whole;
}

/* Rounds until no box is left or more than `limit` are; returns how many boxes were looked at, −1
 * without memory. */
static Py_ssize_t search_rounds(const plan *by, workspace *at, judgement *of, Py_ssize_t budget,
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
        const int whole = search_round(by, at, of, looks > budget, given, N, to);
        PyMem_RawFree(given);
        if (!whole) {
            return -1;
        }
    }
    return looks;
}

/* -------------------------------------------------------------------------------------------------
 * tubes */

/* Arguments and results of `tubes` for N points: n equations in n + 1 unknowns, of which one is the
 * pivot. */
typedef struct {
    plan by;
    int pivot;
    int times;
    double more;
    Py_ssize_t N;
    const double *z;
    const double *by_s;
    const double *swing;
    const double *half_pivot;
    const double *beside;
    const double *smallest_reach;
    double *radius;
    double *remainder;
    uint8_t *proved;
} tube;

/* Whether the whole gap satisfies what the contact requires. */
static int on_side(int kind, double room, double low, double high) {
    return kind == TOUCHING ? high <= room : kind == OPEN ? low >= -room :
                                                            low > 0.0;
}

/* Enclose residual i along a tube: the residual at its centre, and the change along the tube, which
 * is the slopes times `by_s` over the half-range of the pivot. */
static void residual_along(const tube *of, const workspace *at, int i, int a, Py_ssize_t c,
    const double (*forces)[MAX_UNKNOWNS][BLOCK], double *to) {
    const int size = of->by.n;
    double total[2] = {0.0, 0.0};
    for (int j = 0; j < size; j++) {
        const double factor = of->by_s[j * of->N + c];
        if (factor == 0.0) {
            continue;
        }
        const double low = result(at, &of->by.slopes, 0, i * size + j)[a];
        const double high = result(at, &of->by.slopes, 1, i * size + j)[a];
        total[0] =
            rounded_up(total[0] + rounded_up(maximum(low * factor, -(high * factor)), 1.0), 1.0);
        total[1] =
            rounded_up(total[1] + rounded_up(maximum(high * factor, -(low * factor)), 1.0), 1.0);
    }
    const double half = of->half_pivot[c];
    const double low = total[0] * half;
    const double high = total[1] * half;
    const double change = rounded_up(maximum(maximum(low, high), -minimum(low, high)), 1.0);
    for (int end = 0; end < 2; end++) {
        to[end] = rounded_up(forces[end][i][c % BLOCK] + change, 1.0);
    }
}

/* Prove the tubes of a block by interval Newton steps with ε-inflation: boxes grow until each is
 * proved to hold one state. */
static void enclose_block(const tube *of, workspace *at, Py_ssize_t begin) {
    const plan *by = &of->by;
    const int size = by->n;
    const int n = size - 1;
    const Py_ssize_t N = of->N;
    double (*forces)[MAX_UNKNOWNS][BLOCK] = at->values;
    double reach[MAX_UNKNOWNS][BLOCK];
    at->count = (int)(N - begin < BLOCK ? N - begin : BLOCK);
    for (int i = 0; i < at->count; i++) {
        at->of[i] = (int32_t)(begin + i);
        for (int k = 0; k < size; k++) {
            at->ends[0][k][i] = -of->z[k * N + begin + i];
            at->ends[1][k][i] = of->z[k * N + begin + i];
        }
        for (int k = 0; k < n; k++) {
            reach[k][i] = of->smallest_reach[k * N + begin + i];
        }
    }
    evaluate(by, &by->values, at);
    for (int end = 0; end < 2; end++) {
        for (int k = 0; k < n; k++) {
            memcpy(forces[end][k], result(at, &by->values, end, k),
                (size_t)at->count * sizeof(double));
        }
    }
    for (int time = 0; time < of->times && at->count; time++) {
        selection unique = {0};
        int left = 0;
        int32_t further[BLOCK];
        for (int a = 0; a < at->count; a++) {
            const Py_ssize_t c = at->of[a];
            for (int k = 0; k < size; k++) {
                const double own = of->beside[k * N + c];
                const int row = k - (k > of->pivot);
                const double alone = k == of->pivot ? own : maximum(reach[row][c - begin], own);
                const double middle = of->z[k * N + c];
                const double half_width = of->swing[k * N + c] + alone;
                const double size_here = fabs(middle) + half_width;
                const double rounding =
                    half_width > 0.0 ? nextafter(size_here, INFINITY) - size_here : 0.0;
                const double wide = half_width + rounding;
                at->near[0][k][a] = alone;
                at->ends[0][k][a] = -middle + wide;
                at->ends[1][k][a] = middle + wide;
            }
        }
        evaluate(by, &by->slopes, at);
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
                residual_along(
                    of, at, i, a, c, (const double (*)[MAX_UNKNOWNS][BLOCK])forces, ends);
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
                    of->radius[k * N + c] = at->near[0][k][a];
                }
                for (int i = 0; i < n; i++) {
                    of->remainder[i * N + c] = maximum(step.ends[0][i], step.ends[1][i]);
                }
                select_box(&unique, at, a);
            } else if (known) {
                for (int i = 0; i < n; i++) {
                    reach[i][c - begin] = of->more *
                        maximum(room[i], maximum(fabs(step.ends[0][i]), fabs(step.ends[1][i])));
                }
                further[left++] = at->of[a];
            }
        }
        if (by->borders && unique.count) {
            evaluate_selection(by, &by->gaps, at, &unique);
        }
        for (int i = 0; i < unique.count; i++) {
            int inside = 1;
            for (int k = 0; k < by->borders; k++) {
                inside &= on_side(by->kinds[k], by->rooms[k], -result(at, &by->gaps, 0, k)[i],
                    result(at, &by->gaps, 1, k)[i]);
            }
            of->proved[unique.of[i]] = (uint8_t)inside;
        }
        at->count = left;
        memcpy(at->of, further, (size_t)left * sizeof(int32_t));
    }
}

/* Load a point as a box of width 0. */
static void load_point(const plan *by, workspace *at, int i, const double *z, Py_ssize_t N) {
    for (int k = 0; k < by->n; k++) {
        at->ends[0][k][i] = -z[k * N + at->of[i]];
        at->ends[1][k][i] = z[k * N + at->of[i]];
    }
}

static double result_midpoint(const workspace *at, const program *tape, int row, int i) {
    return midpoint(result(at, tape, 0, row)[i], result(at, tape, 1, row)[i]);
}

/* The inverse of the slopes by all unknowns but the pivot; their tape has been evaluated. */
static void invert_slopes(const plan *by, int pivot, const workspace *at, int i, vector *to) {
    const int n = by->n - 1;
    const int columns = (int)by->slopes.outputs / n;
    vector slopes[MAX_UNKNOWNS];
    for (int row = 0; row < n; row++) {
        for (int j = 0; j < n; j++) {
            slopes[row][j] = result_midpoint(at, &by->slopes, row * columns + j + (j >= pivot), i);
        }
    }
    inverse(n, slopes, to);
}

/* Newton's method for a block of points, with new slopes at every second step, until steps are as
 * small as rounding. */
static void correct_block(const plan *by, int pivot, int steps, workspace *at, double *z,
    Py_ssize_t N, Py_ssize_t begin) {
    const int n = by->n - 1;
    for (int step = 0; step < steps && at->count; step++) {
        for (int i = 0; i < at->count; i++) {
            load_point(by, at, i, z, N);
        }
        if (step % 2 == 0) {
            evaluate(by, &by->slopes, at);
            for (int i = 0; i < at->count; i++) {
                invert_slopes(by, pivot, at, i, at->inverse[at->of[i] - begin]);
            }
        }
        evaluate(by, &by->values, at);
        int left = 0;
        for (int i = 0; i < at->count; i++) {
            vector *Y = at->inverse[at->of[i] - begin];
            int still = 1;
            for (int k = 0; k < n; k++) {
                double *to = z + (k + (k >= pivot)) * N + at->of[i];
                double way = 0.0;
                for (int j = 0; j < n; j++) {
                    way += Y[k][j] * result_midpoint(at, &by->values, j, i);
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

/* `tangents` for one block. */
static void differentiate_block(const plan *by, int pivot, workspace *at, const double *z,
    double *by_s, double *by_p, Py_ssize_t N) {
    const int size = by->n;
    const int n = size - 1;
    const int columns = (int)by->slopes.outputs / n;
    const int more = columns - size;
    for (int i = 0; i < at->count; i++) {
        load_point(by, at, i, z, N);
    }
    evaluate(by, &by->slopes, at);
    for (int i = 0; i < at->count; i++) {
        vector Y[MAX_UNKNOWNS];
        invert_slopes(by, pivot, at, i, Y);
        for (int column = -1; column < more; column++) {
            const int moved = column < 0 ? pivot : size + column;
            for (int k = 0; k < size; k++) {
                const int row = k - (k > pivot);
                double total = 0.0;
                for (int j = 0; k != pivot && j < n; j++) {
                    total += Y[row][j] * result_midpoint(at, &by->slopes, j * columns + moved, i);
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

/* Parse a tape (code, numbers, outputs, slots); None is a tape without results. */
static int parse_tape(PyObject *from, program *to) {
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
    *to = program_of(code, codes, numbers, constants, to->outputs, to->slots);
    return 1;
}

/* Whether a tape has the number of results that the system requires, and reads only rows that there
 * are. A tape without operations fits. */
static int tape_fits(
    plan *by, const program *tape, Py_ssize_t results, int inputs, Py_ssize_t between) {
    const operand two[2] = {{.rows = by->n}, {.rows = by->parameters}};
    const operand three[3] = {{.rows = by->n}, {.rows = between}, {.rows = by->parameters}};
    if (!tape->operations) {
        return !tape->outputs;
    }
    by->slots = tape->slots > by->slots ? tape->slots : by->slots;
    by->results = tape->outputs > by->results ? tape->outputs : by->results;
    return tape->outputs == results && sound(tape, inputs == 2 ? two : three, inputs);
}

static int plan_fits(plan *by) {
    const int n = by->n;
    const int m = by->coordinates;
    int whole = n >= 1 && n <= MAX_UNKNOWNS && m >= 1 && m <= n && by->values.operations &&
        by->slopes.operations;
    whole = whole && tape_fits(by, &by->values, n, 2, 0) && tape_fits(by, &by->slopes, n * n, 2, 0);
    whole = whole && tape_fits(by, &by->contraction, m + m * m, 3, m) &&
        tape_fits(by, &by->gaps, by->borders, 2, 0);
    whole = whole && tape_fits(by, &by->anchors, 2 * by->lines, 2, 0) &&
        tape_fits(by, &by->turnings, by->turnings.outputs, 2, 0);
    whole =
        whole && (!by->lines || by->anchors.operations) && (!by->borders || by->gaps.operations);
    for (int k = 0; whole && k < by->lines; k++) {
        const line *at = by->at + k;
        whole = tape_fits(by, &at->forces, 3 * m, 2, 0) && tape_fits(by, &at->direction, 2, 2, 0) &&
            tape_fits(by, &at->determinant, 1, 3, 2);
        whole = whole && (!at->determinant.operations || at->direction.operations);
    }
    for (int k = 0; whole && k < by->sides; k++) {
        whole = by->on_sides[k].operations && tape_fits(by, by->on_sides + k, n, 2, 0);
    }
    return whole;
}

static int parse_borders(PyObject *from, plan *to) {
    to->borders = (int)PyTuple_GET_SIZE(from);
    for (int k = 0; k < to->borders && k < MAX_BORDERS; k++) {
        PyObject *entry = PyTuple_GET_ITEM(from, k);
        if (!PyTuple_Check(entry) || !PyArg_ParseTuple(entry, "id", to->kinds + k, to->rooms + k)) {
            return 0;
        }
    }
    return to->borders <= MAX_BORDERS;
}

static int parse_lines(PyObject *from, plan *to) {
    to->lines = (int)PyTuple_GET_SIZE(from);
    for (int k = 0; k < to->lines && k < MAX_LINES; k++) {
        PyObject *forces;
        PyObject *direction;
        PyObject *determinant;
        line *at = to->at + k;
        PyObject *entry = PyTuple_GET_ITEM(from, k);
        if (!PyTuple_Check(entry) ||
            !PyArg_ParseTuple(entry, "OOO", &forces, &direction, &determinant)) {
            return 0;
        }
        if (!parse_tape(forces, &at->forces) || !parse_tape(direction, &at->direction) ||
            !parse_tape(determinant, &at->determinant)) {
            return 0;
        }
    }
    return to->lines <= MAX_LINES;
}

static int parse_arcs(PyObject *from, plan *to) {
    Py_buffer arcs;
    if (interval_buffer(from, &arcs, PyBUF_STRIDED_RO) < 0) {
        return 0;
    }
    to->arcs = arcs.shape[1] == 2 && arcs.shape[2] <= MAX_ARCS ? (int)arcs.shape[2] : -1;
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

static int parse_sides(PyObject *from, plan *to) {
    to->sides = (int)PyTuple_GET_SIZE(from);
    for (int k = 0; k < to->sides && k < MAX_SIDES; k++) {
        if (!parse_tape(PyTuple_GET_ITEM(from, k), to->on_sides + k)) {
            return 0;
        }
    }
    return to->sides <= MAX_SIDES;
}

static void free_plan(PyObject *capsule) {
    plan *by = PyCapsule_GetPointer(capsule, CAPSULE);
    if (by != NULL) {
        Py_DECREF(by->kept_alive);
        PyMem_Free(by);
    }
}

/* plan(n, coordinates, parameters, values, slopes, contraction, gaps, anchors, turnings, borders,
 * lines, arcs, sides) */
static PyObject *make_plan(PyObject *module, PyObject *arguments) {
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
        whole = parse_tape(of[k], tapes[k]);
    }
    whole = whole && parse_borders(borders, by) && parse_lines(lines, by) && parse_arcs(arcs, by) &&
        parse_sides(sides, by) && plan_fits(by);
    PyObject *capsule = whole ? PyCapsule_New(by, CAPSULE, free_plan) : NULL;
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

/* A workspace for a plan and parameters of N boxes, shape (2, parameters, N); NULL with an error
 * set. */
static workspace *open_workspace(
    const plan *by, PyObject *from, Py_buffer *parameters, Py_ssize_t N) {
    if (interval_buffer(from, parameters, PyBUF_STRIDED_RO) < 0) {
        return NULL;
    }
    workspace *at = NULL;
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

static void close_workspace(workspace *at, Py_buffer *parameters) {
    PyMem_Free(at->slots);
    PyMem_Free(at->out);
    PyMem_Free(at);
    PyBuffer_Release(parameters);
}

static PyObject *kept(PyObject *module, PyObject *arguments) {
    (void)module;
    PyObject *capsule;
    PyObject *given_parameters;
    PyObject *given[3];
    Py_buffer of[3];
    Py_buffer parameters;
    double margin;
    if (!PyArg_ParseTuple(arguments, "OOOdOO", &capsule, given, &given_parameters, &margin,
            given + 1, given + 2) ||
        !hold(given, of, "dDB")) {
        return NULL;
    }
    const plan *by = PyCapsule_GetPointer(capsule, CAPSULE);
    workspace *at = NULL;
    if (by != NULL) {
        const Py_ssize_t N = of[2].len;
        const Py_ssize_t size = 2 * by->n * N;
        const Py_ssize_t sizes[] = {size, size, N};
        at = sizes_fit(of, sizes, 3) ? open_workspace(by, given_parameters, &parameters, N) : NULL;
        if (at != NULL) {
            memset(of[2].buf, 0, (size_t)N);
            Py_BEGIN_ALLOW_THREADS
            for (Py_ssize_t begin = 0; begin < N; begin += BLOCK) {
                load_boxes(by, at, of[0].buf, N, begin);
                contract_block(by, at, of[0].buf, N, margin, of[1].buf, of[2].buf);
            }
            Py_END_ALLOW_THREADS
            close_workspace(at, &parameters);
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
    PyObject *given[10];
    Py_buffer of[10];
    Py_buffer parameters;
    judgement to;
    if (!PyArg_ParseTuple(arguments, "OOOOOOOi" RULES "OOOOO", &capsule, given, given + 1,
            &given_parameters, given + 2, given + 3, given + 4, &to.sharp, INTO_RULES(to.by),
            given + 5, given + 6, given + 7, given + 8, given + 9) ||
        !hold(given, of, "dddbbDDDBL")) {
        return NULL;
    }
    const plan *by = PyCapsule_GetPointer(capsule, CAPSULE);
    workspace *at = NULL;
    if (by != NULL) {
        const Py_ssize_t N = of[8].len;
        const Py_ssize_t one = 2 * by->n;
        const Py_ssize_t sizes[] = {
            one * N, one * N, one, N, N, one * N, one * N, one * N, N, N};
        at = sizes_fit(of, sizes, 10) ? open_workspace(by, given_parameters, &parameters, N) : NULL;
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
            Py_BEGIN_ALLOW_THREADS
            for (Py_ssize_t begin = 0; begin < N; begin += BLOCK) {
                load_boxes(by, at, of[1].buf, N, begin);
                judge_block(by, at, &to, N);
            }
            Py_END_ALLOW_THREADS
            close_workspace(at, &parameters);
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
    PyObject *given[9];
    Py_buffer of[9];
    Py_buffer parameters;
    tube to;
    workspace *at = NULL;
    memset(&to, 0, sizeof to);
    plan *by = &to.by;
    if (!PyArg_ParseTuple(arguments, "(OOO)O!OidiOOOOOOOOO", tapes, tapes + 1, tapes + 2,
            &PyTuple_Type, &borders, &given_parameters, &to.pivot, &to.more, &to.times, given,
            given + 1, given + 2, given + 3, given + 4, given + 5, given + 6, given + 7,
            given + 8) ||
        !hold(given, of, "ddddddDDB")) {
        return NULL;
    }
    const Py_ssize_t N = to.N = of[8].len;
    if (!N) {
        release(of, 9);
        Py_RETURN_NONE;
    }
    const Py_ssize_t unknowns = items_of(of) / N;
    by->n = unknowns <= MAX_UNKNOWNS ? (int)unknowns : 0;
    const int n = by->n - 1;
    const Py_ssize_t every = N * by->n;
    const Py_ssize_t sizes[] = {every, every, every, N, every, N * n, every, N * n, N};
    int whole = n >= 1 && to.pivot >= 0 && to.pivot <= n;
    whole = whole && parse_tape(tapes[0], &by->values) && parse_tape(tapes[1], &by->slopes) &&
        parse_tape(tapes[2], &by->gaps) && parse_borders(borders, by);
    if (whole && interval_buffer(given_parameters, &parameters, PyBUF_STRIDED_RO) == 0) {
        by->parameters = parameters.shape[1];
        PyBuffer_Release(&parameters);
        whole = by->values.operations && by->slopes.operations &&
            tape_fits(by, &by->values, n, 2, 0) && tape_fits(by, &by->slopes, n * (n + 1), 2, 0) &&
            tape_fits(by, &by->gaps, by->borders, 2, 0) && (!by->borders || by->gaps.operations);
        at = whole && sizes_fit(of, sizes, 9) ?
            open_workspace(by, given_parameters, &parameters, N) :
            NULL;
    }
    if (at != NULL) {
        to.z = of[0].buf;
        to.by_s = of[1].buf;
        to.swing = of[2].buf;
        to.half_pivot = of[3].buf;
        to.beside = of[4].buf;
        to.smallest_reach = of[5].buf;
        to.radius = of[6].buf;
        to.remainder = of[7].buf;
        to.proved = of[8].buf;
        Py_BEGIN_ALLOW_THREADS
        for (Py_ssize_t begin = 0; begin < N; begin += BLOCK) {
            enclose_block(&to, at, begin);
        }
        Py_END_ALLOW_THREADS
        close_workspace(at, &parameters);
    } else if (!PyErr_Occurred()) {
        PyErr_SetString(PyExc_ValueError, "a tape of tubes is not as its system is");
    }
    release(of, 9);
    if (at == NULL) {
        return NULL;
    }
    Py_RETURN_NONE;
}

static PyObject *list_bytes(const box_list *from, int n) {
    const Py_ssize_t size = from->count * 2 * n * (Py_ssize_t)sizeof(double);
    return PyBytes_FromStringAndSize((const char *)from->boxes, size);
}

static PyObject *rounds(PyObject *module, PyObject *arguments) {
    (void)module;
    PyObject *capsule;
    PyObject *given_parameters;
    PyObject *given[2];
    Py_buffer of[2];
    Py_buffer parameters;
    Py_ssize_t budget;
    Py_ssize_t limit;
    judgement to;
    outcome found;
    memset(&found, 0, sizeof found);
    if (!PyArg_ParseTuple(arguments, "OOOOi" RULES "nn", &capsule, given, &given_parameters,
            given + 1, &to.sharp, INTO_RULES(to.by), &budget, &limit) ||
        !hold(given, of, "dd")) {
        return NULL;
    }
    const plan *by = PyCapsule_GetPointer(capsule, CAPSULE);
    PyObject *out = NULL;
    workspace *at = NULL;
    Py_ssize_t looks = -1;
    if (by != NULL) {
        const Py_ssize_t one = 2 * by->n;
        const Py_ssize_t N = items_of(of) / one;
        const Py_ssize_t sizes[] = {N * one, one};
        at = sizes_fit(of, sizes, 2) ? open_workspace(by, given_parameters, &parameters, 1) : NULL;
        int whole = at != NULL;
        for (Py_ssize_t i = 0; i < N && whole; i++) {
            whole = append_box(&found.further, by->n, of[0].buf, N, i) != NULL;
        }
        if (whole) {
            at->parameters.strides[2] = 0; /* those of the point, for every box */
            to.limits = of[1].buf;
            Py_BEGIN_ALLOW_THREADS
            looks = search_rounds(by, at, &to, budget, limit, &found);
            Py_END_ALLOW_THREADS
        }
        if (at != NULL) {
            close_workspace(at, &parameters);
        }
    }
    if (looks >= 0) {
        out = Py_BuildValue("nNNNN", looks, list_bytes(&found.unique, by->n),
            list_bytes(&found.where, by->n), list_bytes(&found.undecided, by->n),
            list_bytes(&found.further, by->n));
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

/* Parse the common arguments of `corrected` and `tangents`: tapes of values and slopes of a system
 * with a pivot, and z of shape (n + 1, N). Returns a workspace, or NULL with an error set if these
 * do not fit. */
static workspace *open_at_points(PyObject *const tapes[2], PyObject *given_parameters, int pivot,
    const Py_buffer *z, plan *by, Py_buffer *parameters, Py_ssize_t *N) {
    memset(by, 0, sizeof *by);
    if (!parse_tape(tapes[0], &by->values) || !parse_tape(tapes[1], &by->slopes) ||
        interval_buffer(given_parameters, parameters, PyBUF_STRIDED_RO) < 0) {
        return NULL;
    }
    by->parameters = parameters->shape[1];
    *N = parameters->shape[2];
    PyBuffer_Release(parameters);
    const Py_ssize_t n = by->values.outputs;
    by->n = n < MAX_UNKNOWNS ? (int)n + 1 : 0;
    const Py_ssize_t columns = n > 0 ? by->slopes.outputs / n : 0;
    if (by->n < 2 || pivot < 0 || pivot > n || columns <= n ||
        items_of(z) != by->n * *N || !by->values.operations ||
        !by->slopes.operations || !tape_fits(by, &by->values, n, 2, 0) ||
        !tape_fits(by, &by->slopes, n * columns, 2, 0)) {
        PyErr_SetString(PyExc_ValueError, "tapes of points are not as their system is");
        return NULL;
    }
    return open_workspace(by, given_parameters, parameters, *N);
}

/* Begin a block: its boxes have the numbers from `begin` on. */
static void number_boxes(workspace *at, Py_ssize_t N, Py_ssize_t begin) {
    at->count = (int)(N - begin < BLOCK ? N - begin : BLOCK);
    for (int i = 0; i < at->count; i++) {
        at->of[i] = (int32_t)(begin + i);
    }
}

static PyObject *corrected(PyObject *module, PyObject *arguments) {
    (void)module;
    PyObject *tapes[2];
    PyObject *given_parameters;
    PyObject *given;
    Py_buffer z;
    Py_buffer parameters;
    Py_ssize_t N;
    plan by;
    int pivot;
    int steps;
    if (!PyArg_ParseTuple(arguments, "(OO)OiiO", tapes, tapes + 1, &given_parameters, &pivot,
            &steps, &given) ||
        !hold(&given, &z, "D")) {
        return NULL;
    }
    workspace *at = open_at_points(tapes, given_parameters, pivot, &z, &by, &parameters, &N);
    if (at != NULL) {
        Py_BEGIN_ALLOW_THREADS
        for (Py_ssize_t begin = 0; begin < N; begin += BLOCK) {
            number_boxes(at, N, begin);
            correct_block(&by, pivot, steps, at, z.buf, N, begin);
        }
        Py_END_ALLOW_THREADS
        close_workspace(at, &parameters);
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
    PyObject *given[3];
    Py_buffer of[3];
    Py_buffer parameters;
    Py_ssize_t N;
    plan by;
    int pivot;
    if (!PyArg_ParseTuple(arguments, "(OO)OiOOO", tapes, tapes + 1, &given_parameters, &pivot,
            given, given + 1, given + 2) ||
        !hold(given, of, "dDD")) {
        return NULL;
    }
    workspace *at = open_at_points(tapes, given_parameters, pivot, of, &by, &parameters, &N);
    if (at != NULL) {
        const Py_ssize_t more = by.slopes.outputs / (by.n - 1) - by.n;
        const Py_ssize_t size = items_of(of);
        const Py_ssize_t sizes[] = {size, size, size * more};
        if (!sizes_fit(of, sizes, 3)) {
            close_workspace(at, &parameters);
            at = NULL;
        }
    }
    if (at != NULL) {
        Py_BEGIN_ALLOW_THREADS
        for (Py_ssize_t begin = 0; begin < N; begin += BLOCK) {
            number_boxes(at, N, begin);
            differentiate_block(&by, pivot, at, of[0].buf, of[1].buf, of[2].buf, N);
        }
        Py_END_ALLOW_THREADS
        close_workspace(at, &parameters);
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
    {"plan", make_plan, METH_VARARGS, "A capsule with the tapes of a system."},
    {"kept", kept, METH_VARARGS, "Contract boxes, and mark those that may hold a root."},
    {"tubes", tubes, METH_VARARGS, "Boxes that hold exactly one state for each value of a pivot."},
    {"rounds", rounds, METH_VARARGS, "Branch and prune at one point of the parameters."},
    {"decided", decided, METH_VARARGS, "Verdicts on boxes that may hold a root."},
    {NULL, NULL, 0, NULL}};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_search", NULL, -1, methods, NULL, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__search(void) { return new_module(&definition); }
