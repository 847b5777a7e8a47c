/*
 * Calls an FMU as importers do and as they must not, and prints each call whose status is another than the standard asks for.
 *
 * It compares the partial derivatives with differences too. Linked with the FMU's sources, under sanitizers. Arguments: the
 * instantiation token, and value references: the first state, the first derivative, the first quantity, and of a model with two
 * coordinates a derivative of a rate, a quantity that is positive, the first that is no number, the first that is none, and the first
 * of the numbers that are outputs.
 */
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    OK,
    WARNING,
    DISCARD,
    ERROR
};
typedef uint32_t Ref;
typedef void (*Log)(void *, int, const char *, const char *);

void *fmi3InstantiateModelExchange(const char *, const char *, const char *, bool, bool, void *, Log);
void *fmi3InstantiateCoSimulation(const char *, const char *, const char *, bool, bool, bool, bool, const Ref *, size_t, void *, Log,
    void (*)(void));
void fmi3FreeInstance(void *);
int fmi3EnterInitializationMode(void *, bool, double, double, bool, double);
int fmi3ExitInitializationMode(void *);
int fmi3EnterEventMode(void *);
int fmi3EnterStepMode(void *);
int fmi3EnterContinuousTimeMode(void *);
int fmi3UpdateDiscreteStates(void *, bool *, bool *, bool *, bool *, bool *, double *);
int fmi3Terminate(void *);
int fmi3Reset(void *);
int fmi3GetFloat64(void *, const Ref *, size_t, double *, size_t);
int fmi3SetFloat64(void *, const Ref *, size_t, const double *, size_t);
int fmi3GetBoolean(void *, const Ref *, size_t, bool *, size_t);
int fmi3GetInt32(void *, const Ref *, size_t, int32_t *, size_t);
int fmi3SetDebugLogging(void *, bool, size_t, const char *const *);
int fmi3GetNumberOfContinuousStates(void *, size_t *);
int fmi3SetContinuousStates(void *, const double *, size_t);
int fmi3GetContinuousStateDerivatives(void *, double *, size_t);
int fmi3GetEventIndicators(void *, double *, size_t);
int fmi3GetDirectionalDerivative(void *, const Ref *, size_t, const Ref *, size_t, const double *, size_t, double *, size_t);
int fmi3GetAdjointDerivative(void *, const Ref *, size_t, const Ref *, size_t, const double *, size_t, double *, size_t);
int fmi3GetFMUState(void *, void **);
int fmi3SetFMUState(void *, void *);
int fmi3FreeFMUState(void *, void **);
int fmi3SerializedFMUStateSize(void *, void *, size_t *);
int fmi3SerializeFMUState(void *, void *, uint8_t *, size_t);
int fmi3DeserializeFMUState(void *, const uint8_t *, size_t, void **);
int fmi3DoStep(void *, double, double, bool, bool *, bool *, bool *, double *);

static int logged;

static void count(void *environment, int status, const char *category, const char *message) {
    (void)environment;
    logged += status >= DISCARD && category && message && *message;
}

#define IS(wanted, call)                                                           \
    do {                                                                           \
        const int found = (call);                                                  \
        if (found != (wanted)) {                                                   \
            printf("line %d: %s is %d, not %d\n", __LINE__, #call, found, wanted); \
        }                                                                          \
    } while (0)

/* The call fails with a message, and the instance takes nothing but a reset. */
#define FAILS(call)                                                              \
    do {                                                                         \
        logged = 0;                                                              \
        IS(ERROR, call);                                                         \
        IS(ERROR, fmi3EnterInitializationMode(it, false, 0.0, 0.0, false, 0.0)); \
        if (logged != 2) {                                                       \
            printf("line %d: %d messages of %s\n", __LINE__, logged, #call);     \
        }                                                                        \
        IS(OK, fmi3Reset(it));                                                   \
    } while (0)

static void start(void *it) {
    IS(OK, fmi3EnterInitializationMode(it, true, 1e-9, 0.0, true, 10.0));
    IS(OK, fmi3ExitInitializationMode(it));
}

static int step(void *it, double from, double length) {
    bool event, terminate, early;
    double reached;
    return fmi3DoStep(it, from, length, true, &event, &terminate, &early, &reached);
}

/* Derivatives by a number of some others, against differences of these where that number is a millionth more and less. */
static void compare(void *it, Ref known, Ref first, size_t number) {
    const double one = 1.0;
    Ref unknowns[16];
    double here, ends[2][16], sensitivity[16], size = 0.0;
    for (size_t i = 0; i < number; i++) {
        unknowns[i] = first + (Ref)i;
    }
    IS(OK, fmi3GetFloat64(it, &known, 1, &here, 1));
    for (int side = 0; side < 2; side++) {
        const double moved = here * (side ? 1.0 - 1e-6 : 1.0 + 1e-6);
        IS(OK, fmi3SetFloat64(it, &known, 1, &moved, 1));
        IS(OK, fmi3GetFloat64(it, unknowns, number, ends[side], number));
    }
    IS(OK, fmi3SetFloat64(it, &known, 1, &here, 1));
    IS(OK, fmi3GetDirectionalDerivative(it, unknowns, number, &known, 1, &one, 1, sensitivity, number));
    for (size_t i = 0; i < number; i++) {
        size = fmax(size, fabs(sensitivity[i]));
    }
    for (size_t i = 0; i < number && here != 0.0; i++) {
        const double slope = (ends[0][i] - ends[1][i]) / (2e-6 * here);
        double adjoint;
        IS(OK, fmi3GetAdjointDerivative(it, unknowns + i, 1, &known, 1, &one, 1, &adjoint, 1));
        if (!(fabs(slope - sensitivity[i]) <= 1e-6 * size) || adjoint != sensitivity[i]) {
            printf("%u by %u: %g and %g, by differences %g\n", (unsigned)unknowns[i], (unsigned)known, sensitivity[i], adjoint, slope);
        }
    }
}

int main(int argc, char **argv) {
    const char *const token = argv[1];
    Ref of[8];
    for (int i = 0; i < 8 && i + 2 < argc; i++) {
        of[i] = (Ref)atoi(argv[i + 2]);
    }
    const Ref state = of[0], rate = of[3], positive = of[4], none = of[6];
    const double place[4] = {2e-3, -1e-4, 0.3, -0.1};
    double value = 0.1, other = -1.0, many[64] = {0.0};
    void *saved = NULL, *again = NULL, *it;
    bool flag, nominals, again_changed;
    int32_t number;
    size_t size = 0;
    uint8_t *bytes;

    if (fmi3InstantiateCoSimulation("a", "no token", "", false, false, false, false, NULL, 0, NULL, count, NULL)) {
        printf("the token is not looked at\n");
    }
    IS(ERROR, fmi3Reset(NULL));
    it = fmi3InstantiateCoSimulation("a", token, "", false, true, false, false, NULL, 0, NULL, count, NULL);
    FAILS(step(it, 0.0, 0.1));
    FAILS(fmi3ExitInitializationMode(it));
    FAILS(fmi3EnterInitializationMode(it, true, -1.0, 0.0, false, 0.0));
    FAILS(fmi3EnterInitializationMode(it, false, 0.0, NAN, false, 0.0));
    FAILS(fmi3GetFloat64(it, &none, 1, &value, 1));
    FAILS(fmi3SetFloat64(it, &none, 1, &value, 1));
    FAILS(fmi3SetFloat64(it, &rate, 1, &value, 1));
    FAILS(fmi3SetFloat64(it, &state, 1, &value, 2));
    FAILS(fmi3SetFloat64(it, NULL, 1, &value, 1));
    FAILS(fmi3GetBoolean(it, &state, 1, &flag, 1));
    FAILS(fmi3GetInt32(it, &state, 1, &number, 1));
    FAILS(fmi3SetDebugLogging(it, true, 1, &token));
    logged = 0;
    IS(DISCARD, fmi3SetFloat64(it, &positive, 1, &other, 1));
    other = NAN;
    IS(DISCARD, fmi3SetFloat64(it, &positive, 1, &other, 1));
    if (logged != 2) {
        printf("%d messages of values out of range\n", logged);
    }
    start(it);
    FAILS(step(it, 0.0, 0.0));
    start(it);
    FAILS(step(it, 0.0, -0.1));
    start(it);
    FAILS(step(it, 1.0, 0.1));
    start(it);
    FAILS(step(it, 0.0, 11.0));
    start(it);
    FAILS(fmi3SetFloat64(it, &state, 1, &value, 1));
    start(it);
    FAILS(fmi3EnterEventMode(it));
    start(it);
    FAILS(fmi3GetFMUState(it, NULL));
    start(it);
    IS(OK, step(it, 0.0, 0.5));
    IS(OK, fmi3GetFMUState(it, &saved));
    IS(OK, fmi3SerializedFMUStateSize(it, saved, &size));
    bytes = malloc(size);
    IS(OK, fmi3SerializeFMUState(it, saved, bytes, size));
    IS(OK, step(it, 0.5, 0.5));
    IS(OK, fmi3GetFloat64(it, &state, 1, &value, 1));
    FAILS(fmi3DeserializeFMUState(it, bytes, size - 1, &again));
    IS(OK, fmi3DeserializeFMUState(it, bytes, size, &again));
    IS(OK, fmi3SetFMUState(it, again));
    IS(OK, step(it, 0.5, 0.5));
    IS(OK, fmi3GetFloat64(it, &state, 1, &other, 1));
    if (memcmp(&value, &other, sizeof value) != 0) {
        printf("from a state that was saved the motion is another: %g\n", value - other);
    }
    bytes[0] ^= 1;
    FAILS(fmi3DeserializeFMUState(it, bytes, size, &again));
    IS(OK, fmi3FreeFMUState(it, &again));
    fmi3FreeInstance(it);
    free(bytes);
    for (int kind = 0; kind < 2; kind++) { /* of Co-Simulation with event mode, and of Model Exchange */
        it = kind ? fmi3InstantiateModelExchange("b", token, "", false, false, NULL, count) :
                    fmi3InstantiateCoSimulation("a", token, "", false, true, true, false, NULL, 0, NULL, count, NULL);
        start(it);
        FAILS(fmi3SetFMUState(it, saved));
        fmi3FreeInstance(it);
    }
    it = fmi3InstantiateModelExchange("b", token, "", false, false, NULL, count);
    IS(OK, fmi3FreeFMUState(it, &saved));
    fmi3FreeInstance(it);

    it = fmi3InstantiateModelExchange("b", token, "", false, false, NULL, count);
    start(it);
    FAILS(fmi3EnterStepMode(it));
    start(it);
    FAILS(step(it, 0.0, 0.1));
    start(it);
    for (int changed = 0; changed < 2; changed++) { /* a unit of measure is a nominal value's */
        const Ref measure = of[7] - 1;              /* the last quantity */
        IS(OK, fmi3GetFloat64(it, &measure, 1, &other, 1));
        other *= changed ? 1.5 : 1.0;
        IS(OK, fmi3SetFloat64(it, &measure, 1, &other, 1));
        IS(OK, fmi3UpdateDiscreteStates(it, &flag, NULL, &nominals, NULL, NULL, NULL));
        IS(OK, fmi3UpdateDiscreteStates(it, &flag, NULL, &again_changed, NULL, NULL, NULL));
        if (nominals != changed || again_changed) {
            printf("nominal values: %d, then %d\n", nominals, again_changed);
        }
    }
    IS(OK, fmi3EnterContinuousTimeMode(it));
    IS(OK, fmi3GetNumberOfContinuousStates(it, &size));
    IS(OK, fmi3SetContinuousStates(it, many, size));
    many[0] = INFINITY;
    IS(DISCARD, fmi3SetContinuousStates(it, many, size));
    IS(OK, fmi3GetContinuousStateDerivatives(it, many, size));
    IS(OK, fmi3GetDirectionalDerivative(it, &rate, 1, &state, 1, &value, 1, &other, 1));
    FAILS(fmi3GetDirectionalDerivative(it, &rate, 1, &rate, 1, &value, 1, &other, 1));
    start(it);
    FAILS(fmi3GetDirectionalDerivative(it, &rate, 1, &state, 1, &value, 2, &other, 1));
    start(it);
    FAILS(fmi3GetEventIndicators(it, many, 63));
    start(it);
    FAILS(fmi3GetContinuousStateDerivatives(it, NULL, size));
    start(it);
    IS(OK, fmi3SetFloat64(it, (const Ref[]){state, state + 1, state + 2, state + 3}, 4, place, 4));
    for (Ref known = state; known < of[1]; known++) {
        compare(it, known, of[1], 4);
        compare(it, known, of[7], of[5] - of[7]);
    }
    for (Ref known = of[2]; known < of[7]; known++) {
        compare(it, known, of[1], 4);
        compare(it, known, of[7], of[5] - of[7]);
    }
    IS(OK, fmi3Terminate(it));
    FAILS(fmi3Terminate(it));
    fmi3FreeInstance(it);
    fmi3FreeInstance(NULL);
    return 0;
}
