/* Interval operations of a tape, on blocks of boxes that fit into the cache; for _tape.c and
 * _search.c.
 *
 * Each operation computes what the operation of the same name in interval_arrays.py computes, in
 * the same order, so that both give the same bits. Only exp, log, tanh, atan, sin and cos may
 * differ: they are those of the C library, within the same error bounds FUNCTION_ULPS and
 * TRIGONOMETRIC_ERROR.
 *
 * The rounding of ends is explained in _rounding.h. */
#ifndef SPRAGSYM_OPERATIONS_H
#define SPRAGSYM_OPERATIONS_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "_rounding.h"

#define BLOCK 256
#define FUNCTION_ULPS 8.0
#define LEAST (-1e300)
#define TRIGONOMETRIC_ERROR 0x1p-50
#define LARGEST_ANGLE 1e5
#define TURN_ERROR 1e-10
#define PI 3.141592653589793
#define TURN 6.283185307179586

static const char *const OPERATIONS[] = {"load", "constant", "store", "negative", "absolute", "sum",
    "product", "scaled", "quotient", "square", "odd_power", "sqrt", "exp", "log", "tanh", "atan",
    "sign", "cos", "sin", "not_negative", "component", "angle", "any_angle", "angle_above",
    "angle_below"};
enum {
    LOAD,
    CONSTANT,
    STORE,
    NEGATIVE,
    ABSOLUTE,
    SUM,
    PRODUCT,
    SCALED,
    QUOTIENT,
    SQUARE,
    ODD_POWER,
    SQRT,
    EXP,
    LOG,
    TANH,
    ATAN,
    SIGN,
    COS,
    SIN,
    NOT_NEGATIVE,
    COMPONENT,
    ANGLE,
    ANY_ANGLE,
    ANGLE_ABOVE,
    ANGLE_BELOW,
    COUNT
};

/* One interval for each box of a block: −low in the first row, high in the second. */
typedef struct {
    double ends[2][BLOCK];
} slot;

/* A tape. `code` holds four integers for each operation: which operation, the slot of the result,
 * and two arguments. Arguments are slots, or indices into `numbers`, or an input and its row. */
typedef struct {
    const int32_t *code;
    ptrdiff_t operations;
    const double *numbers;
    ptrdiff_t constants;
    ptrdiff_t outputs;
    ptrdiff_t slots;
} program;

/* An input of a tape: −low and high of each row of each box, with strides in bytes. `of` holds the
 * indices of the boxes of a block, NULL if these are consecutive. */
typedef struct {
    const char *ends;
    ptrdiff_t strides[3];
    ptrdiff_t rows;
    const int32_t *of;
} operand;

/* Smallest |x| of an interval, by its ends −low and high. */
PART double mignitude(double a, double b) { return maximum(-minimum(a, b), 0.0); }

PART void negative(const slot *restrict a, slot *restrict to, int n) {
    for (int i = 0; i < n; i++) {
        to->ends[0][i] = a->ends[1][i];
        to->ends[1][i] = a->ends[0][i];
    }
}

PART void absolute(const slot *restrict a, slot *restrict to, int n) {
    for (int i = 0; i < n; i++) {
        to->ends[0][i] = -mignitude(a->ends[0][i], a->ends[1][i]);
        to->ends[1][i] = maximum(a->ends[0][i], a->ends[1][i]);
    }
}

PART void sum(const slot *restrict a, const slot *restrict b, slot *restrict to, int n) {
    for (int i = 0; i < n; i++) {
        to->ends[0][i] = rounded_up(a->ends[0][i] + b->ends[0][i], 1.0);
        to->ends[1][i] = rounded_up(a->ends[1][i] + b->ends[1][i], 1.0);
    }
}

/* Maximum of two numbers that are not NaN. */
PART double larger(double a, double b) { return b > a ? b : a; }

/* Hull of the products, or quotients, of the ends of two intervals; NaN if one of these is NaN.
 * same_0 is that of both lower ends, same_1 of both upper ends; the crossed ones have the opposite
 * sign, as −low stands for low. */
PART void hull(
    double same_0, double same_1, double cross_0, double cross_1, slot *restrict to, int i) {
    const int unknown = isunordered(same_0, same_1) | isunordered(cross_0, cross_1);
    const double low = rounded_up(larger(larger(cross_0, cross_1), larger(-same_0, -same_1)), 1.0);
    const double high = rounded_up(larger(larger(same_0, same_1), larger(-cross_0, -cross_1)), 1.0);
    to->ends[0][i] = unknown ? NAN : low;
    to->ends[1][i] = unknown ? NAN : high;
}

PART void product(const slot *restrict a, const slot *restrict b, slot *restrict to, int n) {
    for (int i = 0; i < n; i++) {
        hull(a->ends[0][i] * b->ends[0][i], a->ends[1][i] * b->ends[1][i],
            a->ends[0][i] * b->ends[1][i], a->ends[1][i] * b->ends[0][i], to, i);
    }
}

/* Product with a number: exact for 1 and −1, and for 0 unless an end is NaN or infinite. */
PART void scaled(const slot *restrict a, double factor, slot *restrict to, int n) {
    const double size = fabs(factor);
    const int reversed = !(factor >= 0.0);
    for (int end = 0; end < 2; end++) {
        const double *restrict from = a->ends[reversed ? 1 - end : end];
        double *restrict into = to->ends[end];
        if (size == 0.0) {
            for (int i = 0; i < n; i++) {
                into[i] = from[i] * 0.0;
            }
        } else if (size == 1.0) {
            for (int i = 0; i < n; i++) {
                into[i] = from[i];
            }
        } else {
            for (int i = 0; i < n; i++) {
                into[i] = rounded_up(from[i] * size, 1.0);
            }
        }
    }
}

/* Quotient by an interval that ends at 0, for divisors other than 0; NaN if 0 is in its inside. */
PART void quotient_beside_zero(double a_0, double a_1, double b_0, double b_1, double to[2]) {
    const int positive = b_0 == 0.0 && b_1 > 0.0;
    const int negative = b_1 == 0.0 && b_0 > 0.0;
    if (!(positive || negative)) {
        to[0] = NAN;
        to[1] = NAN;
        return;
    }
    const double far = negative ? b_0 : b_1;
    const double low = negative ? a_1 : a_0;
    const double high = negative ? a_0 : a_1;
    to[0] = low > 0.0 ? INFINITY : low / far;
    to[1] = high > 0.0 ? INFINITY : high / far;
}

PART void quotient(const slot *restrict a, const slot *restrict b, slot *restrict to, int n) {
    int zeros = 0;
    for (int i = 0; i < n; i++) {
        zeros |= !(b->ends[0][i] < 0.0 || b->ends[1][i] < 0.0);
    }
    for (int i = 0; i < n; i++) {
        hull(a->ends[0][i] / b->ends[0][i], a->ends[1][i] / b->ends[1][i],
            a->ends[0][i] / b->ends[1][i], a->ends[1][i] / b->ends[0][i], to, i);
    }
    for (int i = 0; zeros && i < n; i++) {
        if (!(b->ends[0][i] < 0.0 || b->ends[1][i] < 0.0)) {
            double ends[2];
            quotient_beside_zero(a->ends[0][i], a->ends[1][i], b->ends[0][i], b->ends[1][i], ends);
            to->ends[0][i] = rounded_up(ends[0], 1.0);
            to->ends[1][i] = rounded_up(ends[1], 1.0);
        }
    }
}

PART void square(const slot *restrict a, slot *restrict to, int n) {
    for (int i = 0; i < n; i++) {
        const double low = mignitude(a->ends[0][i], a->ends[1][i]);
        const double high = maximum(a->ends[0][i], a->ends[1][i]);
        to->ends[0][i] = minimum(rounded_up(-(low * low), 1.0), 0.0);
        to->ends[1][i] = rounded_up(high * high, 1.0);
    }
}

/* The relative error of a product of n numbers is below n units in the last place. */
PART void odd_power(const slot *restrict a, int power, slot *restrict to, int n) {
    for (int end = 0; end < 2; end++) {
        for (int i = 0; i < n; i++) {
            double value = a->ends[end][i];
            for (int k = 1; k < power; k++) {
                value *= a->ends[end][i];
            }
            to->ends[end][i] = rounded_up(value, (double)power);
        }
    }
}

PART void square_root(const slot *restrict a, slot *restrict to, int n) {
    for (int i = 0; i < n; i++) {
        const double low = sqrt(-a->ends[0][i]);
        const double high = a->ends[0][i] > 0.0 ? NAN : sqrt(a->ends[1][i]);
        to->ends[0][i] = minimum(rounded_up(-low, 1.0), 0.0);
        to->ends[1][i] = rounded_up(high, 1.0);
    }
}

/* exp(0) = 1 is exact. If the lower end overflows it is the largest float. */
PART void exponential(const slot *restrict a, slot *restrict to, int n) {
    for (int i = 0; i < n; i++) {
        const double low = maximum(-exp(-a->ends[0][i]), -DBL_MAX);
        const double high = exp(a->ends[1][i]);
        to->ends[0][i] = a->ends[0][i] == 0.0 ? low : minimum(rounded_up(low, FUNCTION_ULPS), 0.0);
        to->ends[1][i] = a->ends[1][i] == 0.0 ? high : rounded_up(high, FUNCTION_ULPS);
    }
}

PART void logarithm(const slot *restrict a, slot *restrict to, int n) {
    for (int i = 0; i < n; i++) {
        const double low = -log(-a->ends[0][i]);
        const double high = log(a->ends[1][i]);
        to->ends[0][i] =
            a->ends[0][i] == 0.0 ? maximum(low, LEAST) : rounded_up(low, FUNCTION_ULPS);
        to->ends[1][i] =
            a->ends[1][i] == 0.0 ? maximum(high, LEAST) : rounded_up(high, FUNCTION_ULPS);
    }
}

/* An increasing odd function with values of at most `bound`; f(0) = 0 is exact. */
PART void increasing(
    double (*function)(double), double bound, const slot *restrict a, slot *restrict to, int n) {
    for (int end = 0; end < 2; end++) {
        for (int i = 0; i < n; i++) {
            const double at = a->ends[end][i];
            to->ends[end][i] =
                at == 0.0 ? 0.0 : minimum(rounded_up(function(at), FUNCTION_ULPS), bound);
        }
    }
}

PART void sign(const slot *restrict a, slot *restrict to, int n) {
    for (int end = 0; end < 2; end++) {
        for (int i = 0; i < n; i++) {
            const double at = a->ends[end][i];
            const double negative_or_zero = at < 0.0 ? -1.0 : at;
            to->ends[end][i] = at > 0.0 ? 1.0 : negative_or_zero;
        }
    }
}

/* A cosine whose maxima are at 2π (peak + n) for integer n. */
PART void wave(
    double (*function)(double), double peak, const slot *restrict a, slot *restrict to, int n) {
    for (int i = 0; i < n; i++) {
        const double low = -a->ends[0][i];
        const double high = a->ends[1][i];
        const double one = function(low);
        const double other = function(high);
        const double from = low / TURN - peak;
        const double until = high / TURN - peak;
        const int known =
            maximum(a->ends[0][i], high) <= LARGEST_ANGLE && isfinite(one) && isfinite(other);
        const int top = floor(until + TURN_ERROR) >= ceil(from - TURN_ERROR);
        const int bottom = floor(until + (0.5 + TURN_ERROR)) >= ceil(from + (0.5 - TURN_ERROR));
        to->ends[0][i] =
            (bottom || !known) ? 1.0 : minimum(-minimum(one, other) + TRIGONOMETRIC_ERROR, 1.0);
        to->ends[1][i] =
            (top || !known) ? 1.0 : minimum(maximum(one, other) + TRIGONOMETRIC_ERROR, 1.0);
    }
}

PART void not_negative(const slot *restrict a, slot *restrict to, int n) {
    for (int i = 0; i < n; i++) {
        to->ends[0][i] = minimum(a->ends[0][i], 0.0);
        to->ends[1][i] = a->ends[1][i];
    }
}

/* a/√(a² + b²), which increases with a and tends to 0 as |b| increases. Three roundings in the sum
 * of squares and two more stay below four units. */
PART void component(const slot *restrict a, const slot *restrict b, slot *restrict to, int n) {
    for (int i = 0; i < n; i++) {
        const double near = mignitude(b->ends[0][i], b->ends[1][i]);
        const double far = maximum(b->ends[0][i], b->ends[1][i]);
        for (int end = 0; end < 2; end++) {
            const double at = a->ends[end][i];
            const double other = at > 0.0 ? near : far;
            const double value = rounded_up(at / sqrt(at * at + other * other), 4.0);
            const double size = maximum(fabs(at), other);
            to->ends[end][i] = (size > 1e-140 && size < 1e150 && value <= 1.0) ? value : 1.0;
        }
    }
}

/* End of an angle, rounded up but not beyond π. */
PART double bounded_by_pi(double end) {
    return minimum(rounded_up(end, FUNCTION_ULPS), rounded_up(PI, 1.0));
}

/* Angles of vectors in a rectangle that meets the ray sine = 0, cosine ≤ 0, where the angle jumps.
 * ANGLE: not bounded. ANY_ANGLE: −π to π. ANGLE_ABOVE and ANGLE_BELOW: those of vectors on that
 * side of the ray, from the corner of largest cosine to π. */
PART void across_the_ray(int which, double cosine, double low, double high, double to[2]) {
    if (which == ANGLE) {
        to[0] = NAN;
        to[1] = NAN;
    } else if (which == ANY_ANGLE) {
        to[0] = rounded_up(PI, 1.0);
        to[1] = rounded_up(PI, 1.0);
    } else {
        /* + 0.0 turns −0 into 0: atan2 takes −0 to the other side of the ray. */
        const double far = maximum(which == ANGLE_ABOVE ? high : -low, 0.0) + 0.0;
        const double size = -bounded_by_pi(-minimum(atan2(far, cosine), atan2(0.0, cosine)));
        to[0] = which == ANGLE_ABOVE ? -size : rounded_up(PI, 1.0);
        to[1] = which == ANGLE_ABOVE ? rounded_up(PI, 1.0) : -size;
    }
}

/* Angles of vectors in a rectangle; off the ray, the extrema are at corners. */
PART void angle(
    int which, const slot *restrict sine, const slot *restrict cosine, slot *restrict to, int n) {
    for (int i = 0; i < n; i++) {
        const double x[2] = {-cosine->ends[0][i], cosine->ends[1][i]};
        const double y[2] = {-sine->ends[0][i], sine->ends[1][i]};
        if (x[0] > 0.0 || y[0] > 0.0 || y[1] < 0.0) {
            const double low = minimum(minimum(atan2(y[0], x[0]), atan2(y[1], x[0])),
                minimum(atan2(y[0], x[1]), atan2(y[1], x[1])));
            const double high = maximum(maximum(atan2(y[0], x[0]), atan2(y[1], x[0])),
                maximum(atan2(y[0], x[1]), atan2(y[1], x[1])));
            to->ends[0][i] = bounded_by_pi(-low);
            to->ends[1][i] = bounded_by_pi(high);
        } else {
            double ends[2];
            across_the_ray(which, x[1], y[0], y[1], ends);
            to->ends[0][i] = ends[0];
            to->ends[1][i] = ends[1];
        }
    }
}

PART void load(const operand *from, ptrdiff_t row, ptrdiff_t begin, slot *to, int n) {
    const ptrdiff_t next = from->strides[2];
    for (int end = 0; end < 2; end++) {
        const char *at = from->ends + end * from->strides[0] + row * from->strides[1];
        for (int i = 0; i < n; i++) {
            const ptrdiff_t box = from->of ? from->of[begin + i] : begin + i;
            to->ends[end][i] = *(const double *)(const void *)(at + box * next);
        }
    }
}

/* Run a tape on the n boxes from index `begin` on; results have the shape (2, outputs, N). */
WIDER static void block(const program *tape, const operand *inputs, slot *slots, double *out,
    ptrdiff_t N, ptrdiff_t begin, int n) {
    const int32_t *code = tape->code;
    const double *numbers = tape->numbers;
    for (ptrdiff_t k = 0; k < tape->operations; k++, code += 4) {
        slot *to = slots + code[1];
        const slot *a = slots + code[2];
        const slot *b = slots + code[3];
        switch (code[0]) {
        case LOAD:
            load(inputs + code[2], code[3], begin, to, n);
            break;
        case CONSTANT:
            for (int i = 0; i < n; i++) {
                to->ends[0][i] = numbers[code[2]];
                to->ends[1][i] = numbers[code[3]];
            }
            break;
        case STORE:
            for (int end = 0; end < 2; end++) {
                memcpy(out + (end * tape->outputs + code[1]) * N + begin, a->ends[end],
                    (size_t)n * sizeof(double));
            }
            break;
        case NEGATIVE:
            negative(a, to, n);
            break;
        case ABSOLUTE:
            absolute(a, to, n);
            break;
        case SUM:
            sum(a, b, to, n);
            break;
        case PRODUCT:
            product(a, b, to, n);
            break;
        case SCALED:
            scaled(a, numbers[code[3]], to, n);
            break;
        case QUOTIENT:
            quotient(a, b, to, n);
            break;
        case SQUARE:
            square(a, to, n);
            break;
        case ODD_POWER:
            odd_power(a, code[3], to, n);
            break;
        case SQRT:
            square_root(a, to, n);
            break;
        case EXP:
            exponential(a, to, n);
            break;
        case LOG:
            logarithm(a, to, n);
            break;
        case TANH:
            increasing(tanh, 1.0, a, to, n);
            break;
        case ATAN:
            increasing(atan, INFINITY, a, to, n);
            break;
        case SIGN:
            sign(a, to, n);
            break;
        case COS:
            wave(cos, 0.0, a, to, n);
            break;
        case SIN:
            wave(sin, 0.25, a, to, n);
            break;
        case NOT_NEGATIVE:
            not_negative(a, to, n);
            break;
        case COMPONENT:
            component(a, b, to, n);
            break;
        case ANGLE:
        case ANY_ANGLE:
        case ANGLE_ABOVE:
        case ANGLE_BELOW:
            angle(code[0], a, b, to, n);
            break;
        default:
            break;
        }
    }
}

/* A tape of the bytes of its code and of its constants. */
static inline program program_of(const char *code, ptrdiff_t codes, const char *numbers,
    ptrdiff_t constants, ptrdiff_t outputs, ptrdiff_t slots) {
    return (program){(const int32_t *)(const void *)code,
        codes / (ptrdiff_t)(4 * sizeof(int32_t)), (const double *)(const void *)numbers,
        constants / (ptrdiff_t)sizeof(double), outputs, slots};
}

/* Number of slots that an operation reads. */
static int reads(int32_t operation) {
    if (operation == LOAD || operation == CONSTANT) {
        return 0;
    }
    const int two = operation == SUM || operation == PRODUCT || operation == QUOTIENT;
    return two || operation >= COMPONENT ? 2 : 1;
}

static int within(int32_t index, ptrdiff_t size) { return index >= 0 && index < size; }

/* Whether all indices of a tape are within their arrays; `given` is the number of inputs. Each slot
 * and each result is that of an operation: no product of their number and a size overflows. */
static int sound(const program *tape, const operand *inputs, ptrdiff_t given) {
    const int32_t *code = tape->code;
    const ptrdiff_t most = tape->operations;
    if (tape->slots < 1 || tape->slots > most + 1 || tape->outputs < 0 || tape->outputs > most) {
        return 0;
    }
    for (ptrdiff_t k = 0; k < tape->operations; k++, code += 4) {
        const int32_t which = code[0];
        const int32_t a = code[2];
        const int32_t b = code[3];
        const int fits = within(which, COUNT) &&
            within(code[1], which == STORE ? tape->outputs : tape->slots) &&
            (reads(which) < 1 || within(a, tape->slots)) &&
            (reads(which) < 2 || within(b, tape->slots)) &&
            (which != LOAD || (within(a, given) && within(b, inputs[a].rows))) &&
            (which != CONSTANT || (within(a, tape->constants) && within(b, tape->constants))) &&
            (which != SCALED || within(b, tape->constants));
        if (!fits) {
            return 0;
        }
    }
    return 1;
}

#endif
