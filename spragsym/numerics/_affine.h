/* Operations of a tape in affine arithmetic, for _tape.c. Each computes what the operation of the
 * same name in affine.py computes, in the same order.
 *
 * An affine form is value + Σ terms_t ε_t ± error, with noise symbols |ε_t| ≤ 1 that all forms
 * share. Roundings of value and terms are added to the error. SLACK covers the roundings in the
 * computation of the error itself, UNDERFLOW_ROOM the underflow of a product. */
#ifndef SPRAGSYM_AFFINE_H
#define SPRAGSYM_AFFINE_H

#include "_operations.h"

/* Boxes in a block, fewer than of intervals as a form has many terms. */
#define FEW 64
/* Slots of intervals for the intermediate results of an elementary function. */
#define WORK 7
#define UNIT 0x1p-53
#define SLACK (1.0 + 0x1p-45)
#define UNDERFLOW_ROOM 1e-320

/* Forms of a block, slot after slot: a row of values, one of errors, and one for each symbol. */
typedef struct {
    int symbols;
    double *at;
} forms;

/* The rows of one slot. */
typedef struct {
    double *value;
    double *error;
    double *terms;
} form;

/* Inputs of a tape: forms with values and errors of shape (rows, N) and terms of shape (symbols,
 * rows, N), N = `every`; and intervals, which become forms without terms. */
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
    double *at = all->at + (ptrdiff_t)slot * (2 + all->symbols) * FEW;
    return (form){at, at + FEW, at + 2 * FEW};
}

/* Sum of the absolute values of the terms. */
PART void spread(const form *a, int symbols, double *restrict to, int n) {
    for (int i = 0; i < n; i++) {
        to[i] = 0.0;
    }
    for (int t = 0; t < symbols; t++) {
        for (int i = 0; i < n; i++) {
            to[i] += fabs(a->terms[t * FEW + i]);
        }
    }
}

/* Add the error of one rounding of the value and of each term. */
PART void rounded(const form *a, int symbols, int n) {
    double size[FEW];
    spread(a, symbols, size, n);
    for (int i = 0; i < n; i++) {
        a->error[i] = (a->error[i] + UNIT * (size[i] + fabs(a->value[i]))) * SLACK;
    }
}

/* The form without terms that encloses an interval. */
PART void between(const slot *from, const form *to, int symbols, int n) {
    for (int i = 0; i < n; i++) {
        const double middle = midpoint(from->ends[0][i], from->ends[1][i]);
        const double off = maximum(from->ends[1][i] - middle, middle + from->ends[0][i]);
        const double error = off * SLACK + UNDERFLOW_ROOM;
        to->value[i] = middle;
        to->error[i] = isfinite(error) ? error : INFINITY;
    }
    for (int t = 0; t < symbols; t++) {
        memset(to->terms + t * FEW, 0, (size_t)n * sizeof(double));
    }
}

/* The interval of all values of a form. */
PART void as_interval(const form *a, int symbols, slot *to, int n) {
    double size[FEW];
    spread(a, symbols, size, n);
    for (int i = 0; i < n; i++) {
        const double radius = (size[i] + a->error[i]) * SLACK;
        to->ends[0][i] = rounded_up(radius - a->value[i], 1.0);
        to->ends[1][i] = rounded_up(radius + a->value[i], 1.0);
    }
}

PART void affine_sum(const form *a, const form *b, const form *to, int symbols, int n) {
    for (int i = 0; i < n; i++) {
        to->value[i] = a->value[i] + b->value[i];
        to->error[i] = a->error[i] + b->error[i];
    }
    for (int i = 0; i < symbols * FEW; i++) {
        to->terms[i] = a->terms[i] + b->terms[i];
    }
    rounded(to, symbols, n);
}

PART void affine_negative(const form *a, const form *to, int symbols, int n) {
    for (int i = 0; i < n; i++) {
        to->value[i] = -a->value[i];
        to->error[i] = a->error[i];
    }
    for (int i = 0; i < symbols * FEW; i++) {
        to->terms[i] = -a->terms[i];
    }
}

PART void affine_scaled(const form *a, double factor, const form *to, int symbols, int n) {
    for (int i = 0; i < n; i++) {
        to->value[i] = a->value[i] * factor;
        to->error[i] = a->error[i] * fabs(factor) + UNDERFLOW_ROOM;
    }
    for (int i = 0; i < symbols * FEW; i++) {
        to->terms[i] = a->terms[i] * factor;
    }
    rounded(to, symbols, n);
}

PART void affine_product(const form *a, const form *b, const form *to, int symbols, int n) {
    double own[FEW];
    double others[FEW];
    double error[FEW];
    double value[FEW];
    spread(a, symbols, own, n);
    spread(b, symbols, others, n);
    for (int i = 0; i < n; i++) {
        const double left = fabs(a->value[i]);
        const double right = fabs(b->value[i]);
        const double crossed = left * b->error[i] + (right + b->error[i]) * a->error[i];
        error[i] = crossed + UNDERFLOW_ROOM + own[i] * (others[i] + b->error[i]) +
            others[i] * a->error[i] + (others[i] * left + own[i] * right) * (2 * UNIT);
        value[i] = a->value[i] * b->value[i];
    }
    for (int t = 0; t < symbols; t++) {
        for (int i = 0; i < n; i++) {
            const int place = t * FEW + i;
            to->terms[place] = b->terms[place] * a->value[i] + a->terms[place] * b->value[i];
        }
    }
    memcpy(to->value, value, (size_t)n * sizeof(double));
    memcpy(to->error, error, (size_t)n * sizeof(double));
    rounded(to, symbols, n);
}

/* With the values v of x and w of y, and q = v/w,
 *     x/y = q + (x − q y)/w + (x − q y)(1/y − 1/w),
 *     |1/y − 1/w| ≤ |y − w| / (|w| (|w| − |y − w|)). */
PART void affine_quotient(const form *a, const form *b, const form *to, int symbols, int n) {
    double own[FEW];
    double others[FEW];
    double found[FEW];
    double value[FEW];
    spread(a, symbols, own, n);
    spread(b, symbols, others, n);
    for (int i = 0; i < n; i++) {
        value[i] = a->value[i] / b->value[i];
        found[i] = 0.0;
    }
    for (int t = 0; t < symbols; t++) {
        for (int i = 0; i < n; i++) {
            const int place = t * FEW + i;
            const double term = (a->terms[place] - b->terms[place] * value[i]) / b->value[i];
            to->terms[place] = term;
            found[i] += fabs(term);
        }
    }
    for (int i = 0; i < n; i++) {
        const double size = fabs(b->value[i]);
        const double reach = (others[i] + b->error[i]) * SLACK;
        const double quotient = fabs(value[i]);
        const double least = size - reach;
        const double rounding = (others[i] * quotient + own[i]) * (4 * UNIT);
        const double own_error = a->error[i] + quotient * b->error[i];
        const double first = (rounding + own_error + UNDERFLOW_ROOM) / size;
        const double all = first + (found[i] + first) * (reach / least) + UNIT * quotient;
        to->error[i] = least > 0.0 ? all * (SLACK * SLACK * SLACK) + UNDERFLOW_ROOM : INFINITY;
        to->value[i] = value[i];
    }
}

/* f(x) by the mean value form, from f at the value of x, and slopes f' over all of x. */
PART void linear(
    const form *x, const slot *middle, const slot *slopes, const form *to, int symbols, int n) {
    double reach[FEW];
    double size[FEW];
    double slope[FEW];
    spread(x, symbols, reach, n);
    for (int i = 0; i < n; i++) {
        reach[i] = (reach[i] + x->error[i]) * SLACK;
        slope[i] = midpoint(slopes->ends[0][i], slopes->ends[1][i]);
        size[i] = 0.0;
    }
    for (int t = 0; t < symbols; t++) {
        for (int i = 0; i < n; i++) {
            const double term = slope[i] * x->terms[t * FEW + i];
            to->terms[t * FEW + i] = term;
            size[i] += fabs(term);
        }
    }
    for (int i = 0; i < n; i++) {
        const double value = midpoint(middle->ends[0][i], middle->ends[1][i]);
        const double beside = maximum(middle->ends[1][i] - value, value + middle->ends[0][i]);
        const double nonlinear =
            maximum(slopes->ends[1][i] - slope[i], slope[i] + slopes->ends[0][i]) * reach[i];
        const double at_middle = beside * SLACK + UNDERFLOW_ROOM;
        const double error =
            (fabs(slope[i]) * x->error[i] + nonlinear + at_middle + UNIT * size[i]) * SLACK +
            UNDERFLOW_ROOM;
        const int known = isfinite(error) && isfinite(value);
        to->value[i] = known ? value : 0.0;
        to->error[i] = known ? error : INFINITY;
        for (int t = 0; t < symbols && !known; t++) {
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

/* An elementary function of intervals and its derivative; uses three slots of `work`. */
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
        increasing(tanh, 1.0, of, values, n);
        square(values, work, n);
        negative(work, work + 1, n);
        constant(1.0, work, n);
        sum(work, work + 1, slopes, n);
        break;
    case ATAN:
        increasing(atan, INFINITY, of, values, n);
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

/* An elementary function of a form: its values at the value of x, and its slopes over all of x. */
static void affine_function(
    int which, const form *x, const form *to, int symbols, slot *work, int n) {
    slot *at = work;
    slot *values = work + 1;
    slot *slopes = work + 2;
    slot *unused = work + 3;
    as_interval(x, symbols, at, n);
    function_and_slopes(which, at, unused, slopes, work + 4, n);
    for (int i = 0; i < n; i++) {
        at->ends[0][i] = -x->value[i];
        at->ends[1][i] = x->value[i];
    }
    function_and_slopes(which, at, values, unused, work + 4, n);
    linear(x, values, slopes, to, symbols, n);
}

PART void affine_load(const affine_inputs *from, int input, ptrdiff_t row, ptrdiff_t begin,
    const form *to, int symbols, slot *work, int n) {
    if (input) {
        load(&from->intervals, row, begin, work, n);
        between(work, to, symbols, n);
        return;
    }
    const ptrdiff_t place = row * from->every + begin;
    memcpy(to->value, from->values + place, (size_t)n * sizeof(double));
    memcpy(to->error, from->errors + place, (size_t)n * sizeof(double));
    for (int t = 0; t < symbols; t++) {
        memcpy(to->terms + t * FEW, from->terms + t * from->rows * from->every + place,
            (size_t)n * sizeof(double));
    }
}

/* Whether affine arithmetic has every operation of a tape. */
static int affine_throughout(const program *tape) {
    for (ptrdiff_t k = 0; k < tape->operations; k++) {
        if (tape->code[4 * k] >= COMPONENT) {
            return 0;
        }
    }
    return 1;
}

/* Run a tape on the n boxes from index `begin` on, at most FEW. */
WIDER static void affine_block(const program *tape, const affine_inputs *inputs, const forms *all,
    slot *work, const affine_results *out, ptrdiff_t every, ptrdiff_t begin, int n) {
    const int32_t *code = tape->code;
    const double *numbers = tape->numbers;
    const int symbols = all->symbols;
    for (ptrdiff_t k = 0; k < tape->operations; k++, code += 4) {
        const int reading = reads(code[0]);
        const form to = form_of(all, code[0] == STORE ? 0 : code[1]);
        const form a = form_of(all, reading ? code[2] : 0);
        const form b = form_of(all, reading == 2 ? code[3] : 0);
        switch (code[0]) {
        case LOAD:
            affine_load(inputs, code[2], code[3], begin, &to, symbols, work, n);
            break;
        case CONSTANT:
            for (int i = 0; i < n; i++) {
                work->ends[0][i] = numbers[code[2]];
                work->ends[1][i] = numbers[code[3]];
            }
            between(work, &to, symbols, n);
            break;
        case STORE:
            memcpy(out->values + code[1] * every + begin, a.value, (size_t)n * sizeof(double));
            memcpy(out->errors + code[1] * every + begin, a.error, (size_t)n * sizeof(double));
            for (int t = 0; t < symbols; t++) {
                memcpy(out->terms + (t * tape->outputs + code[1]) * every + begin,
                    a.terms + t * FEW, (size_t)n * sizeof(double));
            }
            break;
        case NEGATIVE:
            affine_negative(&a, &to, symbols, n);
            break;
        case SUM:
            affine_sum(&a, &b, &to, symbols, n);
            break;
        case PRODUCT:
            affine_product(&a, &b, &to, symbols, n);
            break;
        case SCALED:
            affine_scaled(&a, numbers[code[3]], &to, symbols, n);
            break;
        case QUOTIENT:
            affine_quotient(&a, &b, &to, symbols, n);
            break;
        case SQUARE:
            affine_product(&a, &a, &to, symbols, n);
            break;
        case ODD_POWER:
            affine_product(&a, &a, &to, symbols, n);
            for (int power = 2; power < code[3]; power++) {
                affine_product(&to, &a, &to, symbols, n);
            }
            break;
        case SIGN:
            as_interval(&a, symbols, work, n);
            sign(work, work + 1, n);
            between(work + 1, &to, symbols, n);
            break;
        case NOT_NEGATIVE:
            memmove(to.value, a.value, (size_t)(2 + symbols) * FEW * sizeof(double));
            break;
        default:
            affine_function(code[0], &a, &to, symbols, work, n);
            break;
        }
    }
}

#endif
