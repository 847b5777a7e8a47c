/*
 * @header@
 *
 * The functions of FMI 3.0 about @library@: Model Exchange and Co-Simulation. All that an instance knows stands in itself.
 */
#include "fmi3.h"
#include "model.h"
#include "motion.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

/* The standard hands over more than this FMU has a use for. */
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif

enum {
    GIVEN = PARAMETERS + UNITS,
    FLAGS = LIFTS + SLIDES + HOLDS,
    STATE = 1, /* value references: the first one of each kind; 0 is the time */
    DERIVATIVE = STATE + STATES,
    INDICATOR = DERIVATIVE + STATES,
    QUANTITY = INDICATOR + INDICATORS,
    OUTPUT = QUANTITY + GIVEN,
    FLAG = OUTPUT + OUTPUTS
};

typedef enum {
    INSTANTIATED = 1,
    INITIALIZING = 2,
    EVENT = 4,
    CONTINUOUS = 8,
    STEPPING = 16,
    TERMINATED = 32,
    BEGINNING = INSTANTIATED | INITIALIZING,
    RUNNING = EVENT | CONTINUOUS | STEPPING,
    ANY = BEGINNING | RUNNING | TERMINATED
} Phase;

/* What is copied as the state of the FMU; numbers are those that the importer sees. */
typedef struct {
    Phase phase;
    int kind; /* of the instance: a bit for each of its two properties below */
    bool stops;
    bool jumped; /* a number was set between steps or at an event: the mode is that of the new state */
    double time, stop, tolerance, length;
    double given[GIVEN + 1];
    double state[STATES];
    double nominal[STATES]; /* as the importer was last told */
    double mode[MODES], next[MODES]; /* the next one where a step has ended at an event */
    double unit[STATES], second, level[BORDERS + 1]; /* of the motion, inside */
} State;

typedef struct {
    State now;
    bool exchange;   /* Model Exchange, else Co-Simulation */
    bool paused;     /* events are handled in event mode, else within a step */
    bool early;      /* a step may end at an event */
    unsigned logged; /* a bit for each category */
    void *environment;
    fmi3LogMessageCallback log;
} Instance;

/* -------------------------------------------------------------------------------------------------- log and errors */

typedef enum {
    EVENTS_LOG,
    DISCARD_LOG,
    ERROR_LOG,
    CATEGORIES
} Category;
static const char *const CATEGORY[CATEGORIES] = {"logEvents", "logStatusDiscard", "logStatusError"};

/* Logs a message and returns its status: OK, Discard, after which the instance is as before the call, or Error, after which it
 * can be reset, freed, or put back into a state that was saved. Errors are logged in any case. */
static fmi3Status say(Instance *it, fmi3Status status, const char *format, ...) {
    const Category category = status == fmi3OK ? EVENTS_LOG : status == fmi3Discard ? DISCARD_LOG :
                                                                                      ERROR_LOG;
    if (it->log && (category == ERROR_LOG || it->logged & 1u << category)) {
        char text[256];
        va_list values;
        va_start(values, format);
        vsnprintf(text, sizeof text, format, values);
        va_end(values);
        it->log(it->environment, status, CATEGORY[category], text);
    }
    if (status == fmi3Error) {
        it->now.phase = TERMINATED;
    }
    return status;
}

/* The name of the function without its prefixes, the same in each version of the standard. */
#define CALLED (strstr(__func__, "fmi3") + 4)

/* Begins a function that may be called in some phases. */
#define ENTER(phases)                                                                               \
    Instance *const it = instance;                                                                  \
    if (!it) {                                                                                      \
        return fmi3Error;                                                                           \
    }                                                                                               \
    if (!(it->now.phase & (unsigned)(phases))) {                                                    \
        return say(it, fmi3Error, "%s must not be called in this state of the instance", CALLED); \
    }

/* Refuses arguments that make no sense. */
#define EXPECT(condition, ...)                  \
    if (!(condition)) {                         \
        return say(it, fmi3Error, __VA_ARGS__); \
    }

/* ------------------------------------------------------------------------------- units: inside all is dimensionless */

/* A product of powers of the units of measure. */
static double scale(const State *now, const double *powers) {
    double product = 1.0;
    for (int i = 0; i < UNITS; i++) {
        if (powers[i] != 0.0) {
            product *= pow(now->given[PARAMETERS + i] * QUANTITIES[PARAMETERS + i].factor, powers[i]);
        }
    }
    return product;
}

/* What one dimensionless unit of time and of each number of the state is; units of states and rates. */
static double scales(const State *now, double *unit, double *unit_of_rate) {
    const double time = scale(now, POWERS[COORDINATES]);
    for (int i = 0; i < COORDINATES; i++) {
        unit[i] = scale(now, POWERS[i]);
        unit[COORDINATES + i] = unit_of_rate[i] = unit[i] / time;
        unit_of_rate[COORDINATES + i] = unit_of_rate[i] / time;
    }
    return time;
}

static Motion motion_of(const Instance *it) {
    Motion motion;
    memset(&motion, 0, sizeof motion);
    for (int i = 0; i < PARAMETERS; i++) {
        motion.p[i] = it->now.given[i] * QUANTITIES[i].factor / scale(&it->now, QUANTITIES[i].powers);
    }
    motion.borders = it->exchange ? INDICATORS : BORDERS;
    motion.tolerance = it->now.tolerance;
    memcpy(motion.mode, it->now.mode, sizeof motion.mode);
    memcpy(motion.unit, it->now.unit, sizeof motion.unit);
    memcpy(motion.level, it->now.level, sizeof motion.level);
    motion.second = it->now.second;
    return motion;
}

/* Gives the clock its rate, whatever else it was set to. */
static void wind(Instance *it) {
#if CLOCK
    double unit[STATES], unit_of_rate[STATES], rate;
    const Motion motion = motion_of(it);
    scales(&it->now, unit, unit_of_rate);
    if (!clock(motion.p, &rate)) {
        it->now.state[STATES - 1] = rate * unit[STATES - 1];
    }
#else
    (void)it;
#endif
}

/* Keeps the mode of a motion, and its units. */
static void keep(Instance *it, const Motion *motion) {
    memcpy(it->now.mode, motion->mode, sizeof motion->mode);
    memcpy(it->now.next, motion->mode, sizeof motion->mode);
    memcpy(it->now.unit, motion->unit, sizeof motion->unit);
    memcpy(it->now.level, motion->level, sizeof motion->level);
    it->now.second = motion->second;
}

/* Motion, rates and clearances as they are now, before the start and after a jump in the mode where the state is. Not 0: there are
 * none. */
static int here(const Instance *it, Motion *motion, Point *at, double *unit_of_rate) {
    double unit[STATES];
    scales(&it->now, unit, unit_of_rate);
    *motion = motion_of(it);
    for (int i = 0; i < STATES; i++) {
        at->state[i] = it->now.state[i] / unit[i];
    }
    const bool anew = (it->now.phase & BEGINNING) || it->now.jumped;
    return (anew && begin(motion, at->state)) || rates(motion, at->state, at->rate) || look(motion, at);
}

/* Forces, energy and power as the importer sees them. Not 0: there are none. */
static int told(const Instance *it, const Motion *motion, const Point *at, double *values) {
    if (outputs(at->state, motion->p, motion->mode, values)) {
        return 1;
    }
    for (int i = 0; i < OUTPUTS; i++) {
        values[i] *= scale(&it->now, OUTPUT_POWERS[i]);
    }
    return 0;
}

static const char NOWHERE[] = "the motion has no finite rates here: a spring has no length, or a number is too large";

/* ------------------------------------------------------------------------------------------- instances and phases */

static void reset(Instance *it) {
    State *const now = &it->now;
    memset(now, 0, sizeof *now);
    now->phase = INSTANTIATED;
    now->kind = it->exchange | it->paused << 1;
    now->tolerance = 1e-10;
    for (int i = 0; i < GIVEN; i++) {
        now->given[i] = QUANTITIES[i].start;
    }
    wind(it);
}

static Instance *instantiated(const char *token, bool exchange, bool paused, bool logging, void *environment,
    fmi3LogMessageCallback log) {
    Instance *it;
    if (!token || strcmp(token, TOKEN) != 0) {
        if (log) {
            log(environment, fmi3Error, CATEGORY[ERROR_LOG], "the instantiation token is that of another FMU");
        }
        return NULL;
    }
    it = calloc(1, sizeof *it);
    if (it) {
        it->exchange = exchange;
        it->paused = paused;
        reset(it);
        it->environment = environment;
        it->log = log;
        it->logged = logging ? ~0u : 0u;
    }
    return it;
}

FMI(const char *, GetVersion)(void) { return "3.0"; }

FMI(void *, InstantiateModelExchange)(const char *name, const char *token, const char *resources, bool visible, bool logging, void *environment,
    fmi3LogMessageCallback log) {
    return instantiated(token, true, true, logging, environment, log);
}

FMI(void *, InstantiateCoSimulation)(const char *name, const char *token, const char *resources, bool visible, bool logging, bool event_mode, bool early,
    const fmi3ValueReference *intermediate, size_t count, void *environment, fmi3LogMessageCallback log, void (*update)(void)) {
    Instance *it = instantiated(token, false, event_mode, logging, environment, log);
    if (it) {
        it->early = early;
    }
    return it;
}

FMI(void *, InstantiateScheduledExecution)(const char *name, const char *token, const char *resources, bool visible, bool logging, void *environment,
    fmi3LogMessageCallback log, void (*update)(void), void (*lock)(void), void (*unlock)(void)) {
    if (log) {
        log(environment, fmi3Error, CATEGORY[ERROR_LOG], "this FMU has no Scheduled Execution");
    }
    return NULL;
}

FMI(void, FreeInstance)(void *instance) { free(instance); }

FMI(fmi3Status, SetDebugLogging)(void *instance, bool on, size_t count, const char *const *categories) {
    unsigned named = 0;
    ENTER(ANY)
    for (size_t i = 0; i < count; i++) {
        unsigned found = 0;
        for (int k = 0; k < CATEGORIES && categories && categories[i]; k++) {
            found |= strcmp(categories[i], CATEGORY[k]) == 0 ? 1u << k : 0u;
        }
        EXPECT(found, "log category %u is none of this FMU", (unsigned)i)
        named |= found;
    }
    named = count ? named : ~0u;
    it->logged = on ? it->logged | named : it->logged & ~named;
    return fmi3OK;
}

FMI(fmi3Status, EnterInitializationMode)(void *instance, bool tolerance_defined, double tolerance, double start, bool stop_defined, double stop) {
    ENTER(INSTANTIATED)
    EXPECT(isfinite(start) && (!stop_defined || stop >= start), "the times are %g to %g; give finite ones in order", start, stop)
    EXPECT(!tolerance_defined || (tolerance > 0.0 && tolerance < 1.0), "the tolerance is %g; give one in (0, 1)", tolerance)
    if (tolerance_defined) {
        it->now.tolerance = fmax(tolerance, 1e-13);
    }
    it->now.time = start;
    it->now.stops = stop_defined;
    it->now.stop = stop;
    it->now.phase = INITIALIZING;
    return fmi3OK;
}

FMI(fmi3Status, ExitInitializationMode)(void *instance) {
    Motion motion;
    Point at;
    double unit_of_rate[STATES];
    ENTER(INITIALIZING)
    EXPECT(!here(it, &motion, &at, unit_of_rate), "%s", NOWHERE)
    keep(it, &motion);
    it->now.length = FIRST_STEP * motion.second;
    scales(&it->now, it->now.nominal, unit_of_rate);
    it->now.jumped = false;
    it->now.phase = it->paused ? EVENT : STEPPING;
    return fmi3OK;
}

FMI(fmi3Status, EnterEventMode)(void *instance) {
    ENTER(CONTINUOUS | STEPPING)
    EXPECT(it->paused, "the instance was made without event mode")
    it->now.phase = EVENT;
    return fmi3OK;
}

FMI(fmi3Status, EnterContinuousTimeMode)(void *instance) {
    ENTER(EVENT)
    EXPECT(it->exchange, "Co-Simulation has no continuous-time mode")
    it->now.phase = CONTINUOUS;
    return fmi3OK;
}

FMI(fmi3Status, EnterStepMode)(void *instance) {
    ENTER(EVENT)
    EXPECT(!it->exchange, "Model Exchange has no step mode")
    it->now.phase = STEPPING;
    return fmi3OK;
}

FMI(fmi3Status, Terminate)(void *instance) {
    ENTER(RUNNING)
    it->now.phase = TERMINATED;
    return fmi3OK;
}

FMI(fmi3Status, Reset)(void *instance) {
    ENTER(ANY)
    reset(it);
    return fmi3OK;
}

/* --------------------------------------------------------------------------------------------------------- values */

FMI(fmi3Status, GetFloat64)(void *instance, const fmi3ValueReference *references, size_t count, double *values, size_t size) {
    Motion motion;
    Point at;
    double unit_of_rate[STATES], output[OUTPUTS];
    int looked = 0;
    ENTER(ANY)
    EXPECT(count == size && (!count || (references && values)), "%u values are asked for, with room for %u", (unsigned)count,
        (unsigned)size)
    for (size_t i = 0; i < count; i++) {
        const fmi3ValueReference one = references[i];
        EXPECT(one < FLAG, "there is no Float64 with the value reference %u", (unsigned)one)
        if (one < STATE) {
            values[i] = it->now.time;
        } else if (one < DERIVATIVE) {
            values[i] = it->now.state[one - STATE];
        } else if (one >= QUANTITY && one < OUTPUT) {
            values[i] = it->now.given[one - QUANTITY];
        } else {
            if (!looked && (here(it, &motion, &at, unit_of_rate) || told(it, &motion, &at, output))) {
                return say(it, fmi3Discard, "%s", NOWHERE);
            }
            looked = 1;
            values[i] = one < INDICATOR ? at.rate[one - DERIVATIVE] * unit_of_rate[one - DERIVATIVE] :
                one < QUANTITY          ? at.clearance[one - INDICATOR] :
                                          output[one - OUTPUT];
        }
    }
    return fmi3OK;
}

FMI(fmi3Status, SetFloat64)(void *instance, const fmi3ValueReference *references, size_t count, const double *values, size_t size) {
    ENTER(BEGINNING | RUNNING)
    EXPECT(count == size && (!count || (references && values)), "%u values are set, of %u given", (unsigned)count, (unsigned)size)
    for (size_t i = 0; i < count; i++) {
        const fmi3ValueReference one = references[i];
        const bool quantity = one >= QUANTITY && one < OUTPUT;
        const unsigned state = it->exchange ? BEGINNING | EVENT : BEGINNING;
        const unsigned flows = quantity && QUANTITIES[one - QUANTITY].flows ? CONTINUOUS : 0u;
        const unsigned when = quantity ? BEGINNING | EVENT | STEPPING | flows : state;
        EXPECT(quantity || (one >= STATE && one < DERIVATIVE), "no Float64 with the value reference %u can be set", (unsigned)one)
        EXPECT(it->now.phase & when, "the Float64 with the value reference %u can't be set now", (unsigned)one)
        if (!isfinite(values[i])) {
            return say(it, fmi3Discard, "the value %g is no finite number", values[i]);
        }
        if (quantity) {
            const struct quantity *allowed = QUANTITIES + (one - QUANTITY);
            if (!(values[i] >= allowed->low && values[i] <= allowed->high)) {
                return say(it, fmi3Discard, "%s = %.17g is out of its range, %.17g to %.17g", allowed->name, values[i], allowed->low,
                    allowed->high);
            }
        }
    }
    for (size_t i = 0; i < count; i++) {
        double *const place = references[i] < DERIVATIVE ? it->now.state + (references[i] - STATE) : it->now.given + (references[i] - QUANTITY);
        it->now.jumped |= *place != values[i] && it->now.phase & (EVENT | STEPPING);
        *place = values[i];
    }
    if (it->now.phase & (BEGINNING | STEPPING)) {
        wind(it); /* in event mode where states are told to have changed */
    }
    return fmi3OK;
}

FMI(fmi3Status, GetBoolean)(void *instance, const fmi3ValueReference *references, size_t count, bool *values, size_t size) {
    Motion motion;
    Point at;
    double unit_of_rate[STATES];
    ENTER(ANY)
    EXPECT(count == size && (!count || (references && values)), "%u values are asked for, with room for %u", (unsigned)count,
        (unsigned)size)
    if (count && here(it, &motion, &at, unit_of_rate)) {
        return say(it, fmi3Discard, "%s", NOWHERE);
    }
    for (size_t i = 0; i < count; i++) {
        const fmi3ValueReference one = references[i];
        EXPECT(one >= FLAG && one < FLAG + FLAGS, "there is no Boolean with the value reference %u", (unsigned)one)
        int flag = (int)(one - FLAG), border = 0;
        while (EVENT_BORDERS[border].kind == BEHIND || flag--) {
            border++; /* the one that brings the flag */
        }
        const double number = motion.mode[EVENT_BORDERS[border].place];
        values[i] = (EVENT_BORDERS[border].kind == AHEAD) ? number == 0.0 : number > 0.0;
    }
    return fmi3OK;
}

/* Types of which the model has no variable. */
#define WITHOUT(type, c_type)                                                                                                     \
    FMI(fmi3Status, Get##type)(void *instance, const fmi3ValueReference *references, size_t count, c_type *values, size_t size) { \
        ENTER(ANY)                                                                                                                \
        EXPECT(!count && !size, "there is no variable of the type " #type)                                                        \
        return fmi3OK;                                                                                                            \
    }                                                                                                                             \
    WITHOUT_SETTER(type, c_type)
#define WITHOUT_SETTER(type, c_type)                                                                                                    \
    FMI(fmi3Status, Set##type)(void *instance, const fmi3ValueReference *references, size_t count, const c_type *values, size_t size) { \
        ENTER(ANY)                                                                                                                      \
        EXPECT(!count && !size, "no variable of the type " #type " can be set")                                                         \
        return fmi3OK;                                                                                                                  \
    }

WITHOUT(Float32, float)
WITHOUT(Int8, int8_t)
WITHOUT(UInt8, uint8_t)
WITHOUT(Int16, int16_t)
WITHOUT(UInt16, uint16_t)
WITHOUT(Int32, int32_t)
WITHOUT(UInt32, uint32_t)
WITHOUT(Int64, int64_t)
WITHOUT(UInt64, uint64_t)
WITHOUT(String, char *)
WITHOUT_SETTER(Boolean, bool)

/* Functions about what the model has not: always an error. */
#define NONE(name, ...)                                              \
    FMI(fmi3Status, name)(void *instance, __VA_ARGS__) {             \
        ENTER(ANY)                                                   \
        return say(it, fmi3Error, "this FMU has no use for " #name); \
    }

NONE(GetBinary, const fmi3ValueReference *r, size_t n, size_t *sizes, const uint8_t **values, size_t m)
NONE(SetBinary, const fmi3ValueReference *r, size_t n, const size_t *sizes, const uint8_t *const *values, size_t m)
NONE(GetClock, const fmi3ValueReference *r, size_t n, bool *values)
NONE(SetClock, const fmi3ValueReference *r, size_t n, const bool *values)
NONE(GetIntervalDecimal, const fmi3ValueReference *r, size_t n, double *intervals, int *qualifiers)
NONE(GetIntervalFraction, const fmi3ValueReference *r, size_t n, uint64_t *counters, uint64_t *resolutions, int *qualifiers)
NONE(GetShiftDecimal, const fmi3ValueReference *r, size_t n, double *shifts)
NONE(GetShiftFraction, const fmi3ValueReference *r, size_t n, uint64_t *counters, uint64_t *resolutions)
NONE(SetIntervalDecimal, const fmi3ValueReference *r, size_t n, const double *intervals)
NONE(SetIntervalFraction, const fmi3ValueReference *r, size_t n, const uint64_t *counters, const uint64_t *resolutions)
NONE(SetShiftDecimal, const fmi3ValueReference *r, size_t n, const double *shifts)
NONE(SetShiftFraction, const fmi3ValueReference *r, size_t n, const uint64_t *counters, const uint64_t *resolutions)
NONE(GetNumberOfVariableDependencies, fmi3ValueReference reference, size_t *count)
NONE(GetVariableDependencies, fmi3ValueReference dependent, size_t *elements, fmi3ValueReference *independents,
    size_t *independent_elements, int *kinds, size_t count)
NONE(GetOutputDerivatives, const fmi3ValueReference *r, size_t n, const int32_t *orders, double *values, size_t m)
NONE(ActivateModelPartition, fmi3ValueReference clock, double time)

FMI(fmi3Status, EnterConfigurationMode)(void *instance) {
    ENTER(ANY)
    return say(it, fmi3Error, "this FMU has no structural parameters");
}

FMI(fmi3Status, ExitConfigurationMode)(void *instance) {
    ENTER(ANY)
    return say(it, fmi3Error, "this FMU has no structural parameters");
}

/* ------------------------------------------------------------------------------------------- states of the instance */

FMI(fmi3Status, GetFMUState)(void *instance, void **saved) {
    ENTER(ANY)
    EXPECT(saved, "there is no place for the state")
    if (!*saved) {
        *saved = malloc(sizeof(State));
    }
    EXPECT(*saved, "there is no memory for the state")
    memcpy(*saved, &it->now, sizeof(State));
    return fmi3OK;
}

FMI(fmi3Status, SetFMUState)(void *instance, void *saved) {
    ENTER(ANY)
    EXPECT(saved, "there is no state to set")
    EXPECT(((const State *)saved)->kind == it->now.kind, "the state is that of an instance of another kind")
    memcpy(&it->now, saved, sizeof(State));
    return fmi3OK;
}

FMI(fmi3Status, FreeFMUState)(void *instance, void **saved) {
    ENTER(ANY)
    if (saved) {
        free(*saved);
        *saved = NULL;
    }
    return fmi3OK;
}

/* A state as bytes begins with the token: that of another FMU is refused. */
enum { HEAD = sizeof TOKEN,
    BYTES = HEAD + sizeof(State) };

FMI(fmi3Status, SerializedFMUStateSize)(void *instance, void *saved, size_t *size) {
    ENTER(ANY)
    EXPECT(saved && size, "there is no state, or no place for its size")
    *size = BYTES;
    return fmi3OK;
}

FMI(fmi3Status, SerializeFMUState)(void *instance, void *saved, uint8_t *bytes, size_t size) {
    ENTER(ANY)
    EXPECT(saved && bytes && size == BYTES, "a state has %u bytes, and there is room for %u", (unsigned)BYTES, (unsigned)size)
    memcpy(bytes, TOKEN, HEAD);
    memcpy(bytes + HEAD, saved, sizeof(State));
    return fmi3OK;
}

FMI(fmi3Status, DeserializeFMUState)(void *instance, const uint8_t *bytes, size_t size, void **saved) {
    ENTER(ANY)
    EXPECT(saved && bytes && size == BYTES && !memcmp(bytes, TOKEN, HEAD), "these %u bytes are no state of this FMU", (unsigned)size)
    if (!*saved) {
        *saved = malloc(sizeof(State));
    }
    EXPECT(*saved, "there is no memory for the state")
    memcpy(*saved, bytes + HEAD, sizeof(State));
    return fmi3OK;
}

/* ---------------------------------------------------------------------------------------------------- derivatives */

/* A number that depends on the state and the given quantities: inside its value, its unit and the powers of the units of measure in
 * that, and its derivatives. */
typedef struct {
    double value, unit, powers[3];
    const double *by_state, *by_parameter;
} Told;

/*
 * Its derivatives by the numbers of the state and by the given quantities, as the importer sees them. A unit of measure u with the
 * power w in a quantity v changes what v is inside by -w v/u, and the number by the power in its own unit.
 */
static void derived(const Instance *it, const Motion *motion, const Point *at, const double *unit, const Told *of, double *row) {
    const double *const times = POWERS[COORDINATES];
    for (int k = 0; k < STATES; k++) {
        row[k] = of->by_state[k] * of->unit / unit[k];
    }
    for (int k = 0; k < PARAMETERS; k++) {
        row[STATES + k] = of->by_parameter[k] * of->unit * QUANTITIES[k].factor / scale(&it->now, QUANTITIES[k].powers);
    }
    for (int u = 0; u < UNITS; u++) {
        double change = of->powers[u] * of->value;
        for (int k = 0; k < PARAMETERS; k++) {
            change -= QUANTITIES[k].powers[u] * motion->p[k] * of->by_parameter[k];
        }
        for (int k = 0; k < COORDINATES; k++) {
            change -= POWERS[k][u] * at->state[k] * of->by_state[k];
            change -= (POWERS[k][u] - times[u]) * at->state[COORDINATES + k] * of->by_state[COORDINATES + k];
        }
        row[STATES + PARAMETERS + u] = of->unit * change / it->now.given[PARAMETERS + u];
    }
}

/* Derivatives of all rates, then of forces, energy and power. */
static int derivatives(const Instance *it, double slope[STATES + OUTPUTS][STATES + GIVEN + 1]) {
    Motion motion;
    Point at;
    double unit[STATES], unit_of_rate[STATES], output[OUTPUTS], by_state[COORDINATES * STATES];
    double by_parameter[COORDINATES * PARAMETERS + 1], of_outputs[OUTPUTS * WIDE];
    memset(slope, 0, (STATES + OUTPUTS) * sizeof *slope);
    scales(&it->now, unit, unit_of_rate);
    if (here(it, &motion, &at, unit_of_rate) || regime_jacobian(at.state, motion.p, motion.mode, by_state) ||
        outputs(at.state, motion.p, motion.mode, output) || output_slopes(at.state, motion.p, motion.mode, of_outputs)) {
        return 1;
    }
#if PARAMETERS
    if (regime_by_parameters(at.state, motion.p, motion.mode, by_parameter)) {
        return 1;
    }
#endif
    for (int i = 0; i < COORDINATES; i++) {
        const int rate = COORDINATES + i;
        Told of = {at.rate[rate], unit_of_rate[rate], {0.0}, by_state + i * STATES, by_parameter + i * PARAMETERS};
        for (int u = 0; u < UNITS; u++) {
            of.powers[u] = POWERS[i][u] - 2.0 * POWERS[COORDINATES][u];
        }
        slope[i][rate] = 1.0;
        derived(it, &motion, &at, unit, &of, slope[rate]);
    }
    for (int i = 0; i < OUTPUTS; i++) {
        const double *const own = of_outputs + i * WIDE;
        Told of = {output[i], scale(&it->now, OUTPUT_POWERS[i]), {0.0}, own, own + STATES};
        memcpy(of.powers, OUTPUT_POWERS[i], sizeof of.powers);
        derived(it, &motion, &at, unit, &of, slope[STATES + i]);
    }
    return 0;
}

/* Products with the matrix of partial derivatives, from the right, or transposed from the left. */
static fmi3Status multiplied(Instance *it, const fmi3ValueReference *unknowns, size_t unknown_count,
    const fmi3ValueReference *knowns, size_t known_count, const double *seed, size_t seeds, double *result, size_t results,
    bool transposed) {
    double slope[STATES + OUTPUTS][STATES + GIVEN + 1];
    EXPECT(seeds == (transposed ? unknown_count : known_count) && results == (transposed ? known_count : unknown_count),
        "seed and sensitivity have %u and %u numbers, and are not as many as the variables", (unsigned)seeds, (unsigned)results)
    EXPECT((!unknown_count || unknowns) && (!known_count || knowns) && (!seeds || seed) && (!results || result),
        "an argument is a null pointer")
    if (derivatives(it, slope)) {
        return say(it, fmi3Discard, "%s", NOWHERE);
    }
    for (size_t i = 0; i < results; i++) {
        result[i] = 0.0;
    }
    for (size_t i = 0; i < unknown_count; i++) {
        const fmi3ValueReference row = unknowns[i];
        const bool output = row >= OUTPUT && row < FLAG;
        EXPECT(output || (row >= STATE && row < INDICATOR), "the variable %u is no output and no derivative", (unsigned)row)
        for (size_t k = 0; k < known_count; k++) {
            const fmi3ValueReference column = knowns[k];
            const bool quantity = column >= QUANTITY && column < OUTPUT;
            const size_t place = quantity ? STATES + (column - QUANTITY) : column - STATE;
            double value;
            EXPECT(quantity || (column >= STATE && column < DERIVATIVE), "the variable %u is no state and no parameter",
                (unsigned)column)
            value = row < DERIVATIVE ? (row == column) : slope[output ? STATES + (row - OUTPUT) : row - DERIVATIVE][place];
            result[transposed ? k : i] += value * seed[transposed ? i : k];
        }
    }
    return fmi3OK;
}

FMI(fmi3Status, GetDirectionalDerivative)(void *instance, const fmi3ValueReference *unknowns, size_t unknown_count, const fmi3ValueReference *knowns, size_t known_count,
    const double *seed, size_t seeds, double *result, size_t results) {
    ENTER(INITIALIZING | RUNNING | TERMINATED)
    return multiplied(it, unknowns, unknown_count, knowns, known_count, seed, seeds, result, results, false);
}

FMI(fmi3Status, GetAdjointDerivative)(void *instance, const fmi3ValueReference *unknowns, size_t unknown_count, const fmi3ValueReference *knowns, size_t known_count,
    const double *seed, size_t seeds, double *result, size_t results) {
    ENTER(INITIALIZING | RUNNING | TERMINATED)
    return multiplied(it, unknowns, unknown_count, knowns, known_count, seed, seeds, result, results, true);
}

/* --------------------------------------------------------------------------------------------------------- events */

/* Enters the next mode, and that beyond every border that the state has reached; where friction begins to hold or ceases to, the
 * sliding speed becomes 0. Not 0: the motion has no rates. */
static int enter(Instance *it) {
    Motion motion;
    Point at;
    double unit[STATES], unit_of_rate[STATES], mode[MODES];
    memcpy(mode, it->now.mode, sizeof mode);
    scales(&it->now, unit, unit_of_rate);
    if (here(it, &motion, &at, unit_of_rate)) {
        return 1;
    }
    if (!it->now.jumped) {
        memcpy(motion.mode, it->now.next, sizeof motion.mode);
        if (stop(&motion, mode + CONTACTS, at.state)) {
            return 1;
        }
    }
    if (settle(&motion, &at)) {
        return 1;
    }
    keep(it, &motion);
    it->now.jumped = false;
    for (int k = 0; k < EVENTS; k++) {
        const int kind = EVENT_BORDERS[k].kind, place = EVENT_BORDERS[k].place;
        const double number = motion.mode[place];
        if (kind > SLIP || mode[place] == number) {
            continue;
        }
        if (kind == LIFT) {
            say(it, fmi3OK, "at %.12g contact%s is %s", it->now.time, EVENT_BORDERS[k].contact, number > 0.0 ? "regained" : "lost");
            continue;
        }
        say(it, fmi3OK, "at %.12g the %s%s", it->now.time,
            number > 0.0 ? "belt overtakes" : (number < 0.0 ? "mass overtakes" : "mass sticks"), EVENT_BORDERS[k].contact);
        for (int i = COORDINATES; HOLDS && i < STATES; i++) {
            it->now.state[i] = at.state[i] * unit[i];
        }
    }
    return 0;
}

FMI(fmi3Status, EvaluateDiscreteStates)(void *instance) {
    ENTER(INITIALIZING | EVENT)
    return fmi3OK;
}

FMI(fmi3Status, UpdateDiscreteStates)(void *instance, bool *again, bool *terminate, bool *nominals, bool *values, bool *next_defined, double *next) {
    double before[STATES], nominal[STATES], unit_of_rate[STATES];
    ENTER(EVENT)
    memcpy(before, it->now.state, sizeof before);
    memcpy(nominal, it->now.nominal, sizeof nominal);
    wind(it);
    if (enter(it)) {
        return say(it, fmi3Discard, "%s", NOWHERE);
    }
    bool *const flags[] = {again, terminate, nominals, values, next_defined};
    for (size_t i = 0; i < sizeof flags / sizeof *flags; i++) {
        if (flags[i]) {
            *flags[i] = false;
        }
    }
    scales(&it->now, it->now.nominal, unit_of_rate);
    if (nominals) {
        *nominals = memcmp(nominal, it->now.nominal, sizeof nominal) != 0;
    }
    if (values) {
        *values = memcmp(before, it->now.state, sizeof before) != 0;
    }
    return fmi3OK;
}

/* ------------------------------------------------------------------------------------------------- Model Exchange */

#define EXCHANGE(phases) \
    ENTER(phases)        \
    EXPECT(it->exchange, "%s is of Model Exchange", CALLED)

FMI(fmi3Status, CompletedIntegratorStep)(void *instance, bool no_return, bool *event_mode, bool *terminate) {
    EXCHANGE(CONTINUOUS)
    EXPECT(event_mode && terminate, "an argument is a null pointer")
    *event_mode = *terminate = false;
    return fmi3OK;
}

FMI(fmi3Status, SetTime)(void *instance, double time) {
    EXCHANGE(EVENT | CONTINUOUS)
    EXPECT(isfinite(time), "the time is %g; give a finite one", time)
    it->now.time = time;
    return fmi3OK;
}

FMI(fmi3Status, SetContinuousStates)(void *instance, const double *states, size_t count) {
    EXCHANGE(CONTINUOUS)
    EXPECT(states && count == STATES, "%u states are set of %u", (unsigned)count, (unsigned)STATES)
    for (int i = 0; i < STATES; i++) {
        if (!isfinite(states[i])) {
            return say(it, fmi3Discard, "state %d is %g, no finite number", i + 1, states[i]);
        }
    }
    memcpy(it->now.state, states, sizeof it->now.state);
    wind(it);
    return fmi3OK;
}

FMI(fmi3Status, GetContinuousStates)(void *instance, double *states, size_t count) {
    EXCHANGE(INITIALIZING | EVENT | CONTINUOUS | TERMINATED)
    EXPECT(states && count == STATES, "%u states are asked for of %u", (unsigned)count, (unsigned)STATES)
    memcpy(states, it->now.state, sizeof it->now.state);
    return fmi3OK;
}

FMI(fmi3Status, GetNominalsOfContinuousStates)(void *instance, double *nominals, size_t count) {
    double unit_of_rate[STATES];
    EXCHANGE(INITIALIZING | EVENT | CONTINUOUS | TERMINATED)
    EXPECT(nominals && count == STATES, "%u nominal values are asked for of %u", (unsigned)count, (unsigned)STATES)
    scales(&it->now, nominals, unit_of_rate);
    return fmi3OK;
}

FMI(fmi3Status, GetContinuousStateDerivatives)(void *instance, double *values, size_t count) {
    Motion motion;
    Point at;
    double unit_of_rate[STATES];
    EXCHANGE(INITIALIZING | EVENT | CONTINUOUS | TERMINATED)
    EXPECT(values && count == STATES, "%u derivatives are asked for of %u", (unsigned)count, (unsigned)STATES)
    if (here(it, &motion, &at, unit_of_rate)) {
        return say(it, fmi3Discard, "%s", NOWHERE);
    }
    for (int i = 0; i < STATES; i++) {
        values[i] = at.rate[i] * unit_of_rate[i];
    }
    return fmi3OK;
}

FMI(fmi3Status, GetEventIndicators)(void *instance, double *values, size_t count) {
    Motion motion;
    Point at;
    double unit_of_rate[STATES];
    EXCHANGE(INITIALIZING | EVENT | CONTINUOUS | TERMINATED)
    EXPECT((values || !count) && count == INDICATORS, "%u event indicators are asked for of %u", (unsigned)count,
        (unsigned)INDICATORS)
    if (here(it, &motion, &at, unit_of_rate)) {
        return say(it, fmi3Discard, "%s", NOWHERE);
    }
    memcpy(values, at.clearance, INDICATORS * sizeof *values);
    return fmi3OK;
}

FMI(fmi3Status, GetNumberOfContinuousStates)(void *instance, size_t *count) {
    EXCHANGE(ANY)
    EXPECT(count, "there is no place for the number")
    *count = STATES;
    return fmi3OK;
}

FMI(fmi3Status, GetNumberOfEventIndicators)(void *instance, size_t *count) {
    EXCHANGE(ANY)
    EXPECT(count, "there is no place for the number")
    *count = INDICATORS;
    return fmi3OK;
}

/* -------------------------------------------------------------------------------------------------- Co-Simulation */

FMI(fmi3Status, DoStep)(void *instance, double from, double duration, bool no_return, bool *event, bool *terminate, bool *early, double *reached) {
    ENTER(STEPPING)
    EXPECT(event && terminate && early && reached, "an argument is a null pointer")
    EXPECT(duration > 0.0 && isfinite(duration), "the step is %g; give a positive one", duration)
    EXPECT(fabs(from - it->now.time) <= 1e-9 * duration + 1e-12 * fabs(from), "the step begins at %.12g, and the instance is at %.12g",
        from, it->now.time)
    EXPECT(!it->now.stops || from + duration <= it->now.stop + 1e-9 * duration + 1e-12 * fabs(from),
        "the step ends at %.12g, beyond the stop time %.12g", from + duration, it->now.stop)
    State *const now = &it->now;
    const State before = *now;
    double unit[STATES], unit_of_rate[STATES], state[STATES], done = 0.0;
    const double second = scales(now, unit, unit_of_rate), whole = duration / second;
    *event = *terminate = *early = false;
    while (done < whole) {
        Motion motion;
        double elapsed = 0.0;
        int border = STUCK;
        if (!enter(it)) {
            motion = motion_of(it);
            for (int i = 0; i < STATES; i++) {
                state[i] = now->state[i] / unit[i];
            }
            border = carry(&motion, state, whole - done, &now->length, &elapsed, now->next);
        }
        if (border == STUCK) {
            const double stuck = now->time;
            *now = before;
            return say(it, fmi3Discard, "the motion can't be carried beyond %.12g: steps are too short or too many, or it has no rates", stuck);
        }
        done = (border == DONE) ? whole : done + elapsed;
        memcpy(now->mode, motion.mode, sizeof motion.mode);
        for (int i = 0; i < STATES; i++) {
            now->state[i] = state[i] * unit[i];
        }
        now->time = (border == DONE) ? from + duration : from + done * second;
        if (border != DONE && it->paused && (it->early || done >= whole)) {
            *event = true;
            *early = now->time < from + duration;
            break;
        }
    }
    *reached = now->time;
    return fmi3OK;
}
