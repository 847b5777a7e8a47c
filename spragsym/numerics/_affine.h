/* Operations of a tape on affine numbers, value + Σ terms_t ε_t ± error with every |ε_t| ≤ 1, for
 * _tape.c: each does what the same operation of affine.py does, in the same order.
 *
 * Rounding: see _rounding.h. What an operation rounds goes into the error; SLACK covers what the
 * error itself loses by that, and UNDERFLOW what a product may. */
#ifndef SPRAGSYM_AFFINE_H
#define SPRAGSYM_AFFINE_H

#include "_operations.h"

/* Boxes at a time: a number has many terms; and slots of intervals that a function works with. */
#define FEW 64
#define WORK 7
#define UNIT 0x1p-53
#define SLACK (1.0 + 0x1p-45)
#define UNDERFLOW_ROOM 1e-320

/* Numbers of a block in one slot: values, errors, and then a row for each term. */
typedef struct {
    int sides;
    double *at;
} forms;

typedef struct {
    double *value;
    double *error;
    double *terms;
} form;

/* What an affine tape reads: values, errors and terms of its numbers, shape (rows, N) and (sides,
 * rows, N), and intervals, of which nothing is known but their ends. */
typedef struct {
    const double *values;
    const double *errors;
    const double *terms;
    ptrdiff_t rows;
    ptrdiff_t every;
    operand intervals;
} affine_inputs;

typedef struct {
    double *values;
    double *errors;
    double *terms;
} affine_results;

PART form form_of(const forms *all, int slot) {
    double *at = all->at + (ptrdiff_t)slot * (2 + all->sides) * FEW;
    return (form){at, at + FEW, at + 2 * FEW};
}

/* Sum of the terms' absolute values. */
PART void spread(const form *a, int sides, double *restrict to, int n) {
    for (int i = 0; i < n; i++) {
        to[i] = 0.0;
    }
    for (int t = 0; t < sides; t++) {
        for (int i = 0; i < n; i++) {
            to[i] += fabs(a->terms[t * FEW + i]);
        }
    }
}

/* The error with that of one rounding of the value and of each term. */
PART void rounded(const form *a, int sides, int n) {
    double size[FEW];
    spread(a, sides, size, n);
    for (int i = 0; i < n; i++) {
        a->error[i] = (a->error[i] + UNIT * (size[i] + fabs(a->value[i]))) * SLACK;
    }
}

/* An interval's number, of which nothing is known but that. */
PART void between(const slot *from, const form *to, int sides, int n) {
    for (int i = 0; i < n; i++) {
        const double middle = midpoint(from->ends[0][i], from->ends[1][i]);
        const double off = maximum(from->ends[1][i] - middle, middle + from->ends[0][i]);
        const double error = off * SLACK + UNDERFLOW_ROOM;
        to->value[i] = middle;
        to->error[i] = isfinite(error) ? error : INFINITY;
    }
    for (int t = 0; t < sides; t++) {
        memset(to->terms + t * FEW, 0, (size_t)n * sizeof(double));
    }
}

/* The interval in which the numbers lie. */
PART void as_interval(const form *a, int sides, slot *to, int n) {
    double size[FEW];
    spread(a, sides, size, n);
    for (int i = 0; i < n; i++) {
        const double radius = (size[i] + a->error[i]) * SLACK;
        to->ends[0][i] = rounded_up(radius - a->value[i], 1.0);
        to->ends[1][i] = rounded_up(radius + a->value[i], 1.0);
    }
}

PART void affine_sum(const form *a, const form *b, const form *to, int sides, int n) {
    for (int i = 0; i < n; i++) {
        to->value[i] = a->value[i] + b->value[i];
        to->error[i] = a->error[i] + b->error[i];
    }
    for (int i = 0; i < sides * FEW; i++) {
        to->terms[i] = a->terms[i] + b->terms[i];
    }
    rounded(to, sides, n);
}

PART void affine_negative(const form *a, const form *to, int sides, int n) {
    for (int i = 0; i < n; i++) {
        to->value[i] = -a->value[i];
        to->error[i] = a->error[i];
    }
    for (int i = 0; i < sides * FEW; i++) {
        to->terms[i] = -a->terms[i];
    }
}

PART void affine_scaled(const form *a, double factor, const form *to, int sides, int n) {
    for (int i = 0; i < n; i++) {
        to->value[i] = a->value[i] * factor;
        to->error[i] = a->error[i] * fabs(factor) + UNDERFLOW_ROOM;
    }
    for (int i = 0; i < sides * FEW; i++) {
        to->terms[i] = a->terms[i] * factor;
    }
    rounded(to, sides, n);
}

PART void affine_product(const form *a, const form *b, const form *to, int sides, int n) {
    double own[FEW];
    double others[FEW];
    double error[FEW];
    double value[FEW];
    spread(a, sides, own, n);
    spread(b, sides, others, n);
    for (int i = 0; i < n; i++) {
        const double left = fabs(a->value[i]);
        const double right = fabs(b->value[i]);
        const double crossed = left * b->error[i] + (right + b->error[i]) * a->error[i];
        error[i] = crossed + UNDERFLOW_ROOM + own[i] * (others[i] + b->error[i]) +
            others[i] * a->error[i] + (others[i] * left + own[i] * right) * (2 * UNIT);
        value[i] = a->value[i] * b->value[i];
    }
    for (int t = 0; t < sides; t++) {
        for (int i = 0; i < n; i++) {
            const int place = t * FEW + i;
            to->terms[place] = b->terms[place] * a->value[i] + a->terms[place] * b->value[i];
        }
    }
    memcpy(to->value, value, (size_t)n * sizeof(double));
    memcpy(to->error, error, (size_t)n * sizeof(double));
    rounded(to, sides, n);
}

/* x/y = q + (x − q y)/w + (x − q y)(1/y − 1/w) for q = v/w, and |1/y − 1/w| ≤ |y − w| / (|w| (|w| −
 * |y − w|)). */
PART void affine_quotient(const form *a, const form *b, const form *to, int sides, int n) {
    double own[FEW];
    double others[FEW];
    double found[FEW];
    double value[FEW];
    spread(a, sides, own, n);
    spread(b, sides, others, n);
    for (int i = 0; i < n; i++) {
        value[i] = a->value[i] / b->value[i];
        found[i] = 0.0;
    }
    for (int t = 0; t < sides; t++) {
        for (int i = 0; i < n; i++) {
            const int place = t * FEW + i;
            const double term =
                (a->terms[place] - b->terms[place] * value[i]) / b->value[i];
            to->terms[place] = term;
            found[i] += fabs(term);
        }
    }
    for (int i = 0; i < n; i++) {
        const double size = fabs(b->value[i]);
        const double reach = (others[i] + b->error[i]) * SLACK;
        const double quotient = fabs(value[i]);
        const double left = size - reach;
        const double rounding = (others[i] * quotient + own[i]) * (4 * UNIT);
        const double own_error = a->error[i] + quotient * b->error[i];
        const double first = (rounding + own_error + UNDERFLOW_ROOM) / size;
        const double all = first + (found[i] + first) * (reach / left) + UNIT * quotient;
        to->error[i] = left > 0.0 ? all * (SLACK * SLACK * SLACK) + UNDERFLOW_ROOM : INFINITY;
        to->value[i] = value[i];
    }
}

/* f(x) from f at the value of x, and slopes of f over all of x. */
PART void linear(
    const form *x, const slot *middle, const slot *slopes, const form *to, int sides, int n) {
    double reach[FEW];
    double size[FEW];
    double slope[FEW];
    spread(x, sides, reach, n);
    for (int i = 0; i < n; i++) {
        reach[i] = (reach[i] + x->error[i]) * SLACK;
        slope[i] = midpoint(slopes->ends[0][i], slopes->ends[1][i]);
        size[i] = 0.0;
    }
    for (int t = 0; t < sides; t++) {
        for (int i = 0; i < n; i++) {
            const double term = slope[i] * x->terms[t * FEW + i];
            to->terms[t * FEW + i] = term;
            size[i] += fabs(term);
        }
    }
    for (int i = 0; i < n; i++) {
        const double value = midpoint(middle->ends[0][i], middle->ends[1][i]);
        const double beside = maximum(middle->ends[1][i] - value, value + middle->ends[0][i]);
        const double off =
            maximum(slopes->ends[1][i] - slope[i], slope[i] + slopes->ends[0][i]) * reach[i];
        const double at_middle = beside * SLACK + UNDERFLOW_ROOM;
        const double error =
            (fabs(slope[i]) * x->error[i] + off + at_middle + UNIT * size[i]) * SLACK +
            UNDERFLOW_ROOM;
        const int known = isfinite(error) && isfinite(value);
        to->value[i] = known ? value : 0.0;
        to->error[i] = known ? error : INFINITY;
        for (int t = 0; t < sides && !known; t++) {
            to->terms[t * FEW + i] = 0.0;
        }
    }
}

PART void constant(double value, slot *to, int n) {
    for (int i = 0; i < n; i++) {
        to->ends[0][i] = -value;
        to->ends[1][i] = value;
    }
}

/* A function of intervals and its slopes; three of `work` for what is between them. */
static void function_and_slopes(
    int which, const slot *of, slot *values, slot *slopes, slot *work, int n) {
    switch (which) {
    case ABSOLUTE:
        absolute(of, values, n);
        sign(of, slopes, n);
        break;
    case SQRT:
        square_root(of, values, n);
        constant(0.5, work, n);
        quotient(work, values, slopes, n);
        break;
    case EXP:
        exponential(of, values, n);
        *slopes = *values;
        break;
    case LOG:
        logarithm(of, values, n);
        constant(1.0, work, n);
        quotient(work, of, slopes, n);
        break;
    case TANH:
        growing(tanh, 1.0, of, values, n);
        square(values, work, n);
        negative(work, work + 1, n);
        constant(1.0, work, n);
        sum(work, work + 1, slopes, n);
        break;
    case ATAN:
        growing(atan, INFINITY, of, values, n);
        square(of, work, n);
        constant(1.0, work + 1, n);
        sum(work, work + 1, work + 2, n);
        quotient(work + 1, work + 2, slopes, n);
        break;
    case COS:
        wave(cos, 0.0, of, values, n);
        wave(sin, 0.25, of, work, n);
        negative(work, slopes, n);
        break;
    default:
        wave(sin, 0.25, of, values, n);
        wave(cos, 0.0, of, slopes, n);
        break;
    }
}

static void affine_function(int which, const form *x, const form *to, int sides, slot *work, int n) {
    slot *at = work;
    slot *values = work + 1;
    slot *slopes = work + 2;
    slot *none = work + 3;
    as_interval(x, sides, at, n);
    function_and_slopes(which, at, none, slopes, work + 4, n);
    for (int i = 0; i < n; i++) {
        at->ends[0][i] = -x->value[i];
        at->ends[1][i] = x->value[i];
    }
    function_and_slopes(which, at, values, none, work + 4, n);
    linear(x, values, slopes, to, sides, n);
}

PART void affine_load(const affine_inputs *from, int input, ptrdiff_t row, ptrdiff_t begin,
    const form *to, int sides, slot *work, int n) {
    if (input) {
        load(&from->intervals, row, begin, work, n);
        between(work, to, sides, n);
        return;
    }
    const ptrdiff_t place = row * from->every + begin;
    memcpy(to->value, from->values + place, (size_t)n * sizeof(double));
    memcpy(to->error, from->errors + place, (size_t)n * sizeof(double));
    for (int t = 0; t < sides; t++) {
        memcpy(to->terms + t * FEW, from->terms + t * from->rows * from->every + place,
            (size_t)n * sizeof(double));
    }
}

/* Whether every operation is one that affine numbers have. */
static int affine_throughout(const program *of) {
    for (ptrdiff_t k = 0; k < of->operations; k++) {
        if (of->code[4 * k] >= COMPONENT) {
            return 0;
        }
    }
    return 1;
}

/* The tape on n boxes, at most FEW, from number `begin` on. */
WIDER static void affine_block(const program *of, const affine_inputs *inputs, const forms *all,
    slot *work, const affine_results *out, ptrdiff_t every, ptrdiff_t begin, int n) {
    const int32_t *code = of->code;
    const double *numbers = of->numbers;
    const int sides = all->sides;
    for (ptrdiff_t k = 0; k < of->operations; k++, code += 4) {
        const int reading = reads(code[0]);
        const form to = form_of(all, code[0] == STORE ? 0 : code[1]);
        const form a = form_of(all, reading ? code[2] : 0);
        const form b = form_of(all, reading == 2 ? code[3] : 0);
        switch (code[0]) {
        case LOAD:
            affine_load(inputs, code[2], code[3], begin, &to, sides, work, n);
            break;
        case CONSTANT:
            for (int i = 0; i < n; i++) {
                work->ends[0][i] = numbers[code[2]];
                work->ends[1][i] = numbers[code[3]];
            }
            between(work, &to, sides, n);
            break;
        case STORE:
            memcpy(out->values + code[1] * every + begin, a.value, (size_t)n * sizeof(double));
            memcpy(out->errors + code[1] * every + begin, a.error, (size_t)n * sizeof(double));
            for (int t = 0; t < sides; t++) {
                memcpy(out->terms + (t * of->outputs + code[1]) * every + begin,
                    a.terms + t * FEW, (size_t)n * sizeof(double));
            }
            break;
        case NEGATIVE:
            affine_negative(&a, &to, sides, n);
            break;
        case SUM:
            affine_sum(&a, &b, &to, sides, n);
            break;
        case PRODUCT:
            affine_product(&a, &b, &to, sides, n);
            break;
        case SCALED:
            affine_scaled(&a, numbers[code[3]], &to, sides, n);
            break;
        case QUOTIENT:
            affine_quotient(&a, &b, &to, sides, n);
            break;
        case SQUARE:
            affine_product(&a, &a, &to, sides, n);
            break;
        case ODD_POWER:
            affine_product(&a, &a, &to, sides, n);
            for (int power = 2; power < code[3]; power++) {
                affine_product(&to, &a, &to, sides, n);
            }
            break;
        case SIGN:
            as_interval(&a, sides, work, n);
            sign(work, work + 1, n);
            between(work + 1, &to, sides, n);
            break;
        case NOT_NEGATIVE:
            memmove(to.value, a.value, (size_t)(2 + sides) * FEW * sizeof(double));
            break;
        default:
            affine_function(code[0], &a, &to, sides, work, n);
            break;
        }
    }
}

#endif
