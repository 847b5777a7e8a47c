/*
 * @header@
 *
 * The functions of FMI 2.0 about @library@: each calls those of FMI 3.0, which this file includes and does not offer.
 */
#define FMI_EXPORT
#ifdef FMI2_FUNCTION_PREFIX
#define FMI3_FUNCTION_PREFIX FMI2_FUNCTION_PREFIX
#else
#define FMI2_FUNCTION_PREFIX
#endif
#include "fmu.c"

#if defined(_WIN32)
#define FMI2_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define FMI2_EXPORT __attribute__((visibility("default")))
#else
#define FMI2_EXPORT
#endif
#define FMI2(type, name) FMI2_EXPORT type FMI_NAME(FMI2_FUNCTION_PREFIX, fmi2##name)
#define CALL(name) FMI_NAME(FMI3_FUNCTION_PREFIX, fmi3##name)

/* What FMI 2.0 lays down of types: https://fmi-standard.org. Statuses are those of FMI 3.0, and one more that is never given. */
typedef struct {
    void (*log)(void *environment, const char *name, fmi3Status status, const char *category, const char *message, ...);
    void *(*allocate)(size_t count, size_t size);
    void (*release)(void *memory);
    void (*finished)(void *environment, fmi3Status status);
    void *environment;
} Callbacks;

typedef struct {
    int again, terminate, nominals, values, next_defined;
    double next;
} EventInfo;

enum {
    MODEL_EXCHANGE,
    CO_SIMULATION
};

enum {
    DO_STEP_STATUS,
    PENDING_STATUS,
    LAST_SUCCESSFUL_TIME,
    TERMINATED_STATUS
};

typedef struct {
    Instance *inner;
    Callbacks callbacks;
    char *name;
    bool tolerance_defined, stop_defined; /* of the experiment */
    double tolerance, start, stop;
    fmi3Status step; /* what the last step ended with */
} Component;

/* Hands a message on, whose signs of percent are text. */
static void hand_on(void *environment, fmi3Status status, const char *category, const char *message) {
    const Component *const it = environment;
    if (it->callbacks.log) {
        it->callbacks.log(it->callbacks.environment, it->name, status, category, "%s", message);
    }
}

/* Begins a function about a component. */
#define OF_COMPONENT                     \
    Component *const it = component;     \
    if (!it) {                           \
        return fmi3Error;                \
    }

/* --------------------------------------------------------------------------------------------- instances and phases */

FMI2(const char *, GetTypesPlatform)(void) { return "default"; }

FMI2(const char *, GetVersion)(void) { return "2.0"; }

FMI2(void, FreeInstance)(void *component) {
    Component *const it = component;
    if (it) {
        CALL(FreeInstance)(it->inner);
        free(it->name);
        free(it);
    }
}

FMI2(void *, Instantiate)(const char *name, int type, const char *guid, const char *resources, const Callbacks *callbacks,
    int visible, int logging) {
    Component *const it = calloc(1, sizeof *it);
    const size_t length = name ? strlen(name) + 1 : 1;
    if (!it) {
        return NULL;
    }
    if (callbacks) {
        it->callbacks = *callbacks;
    }
    it->name = calloc(length, 1);
    if (it->name && name) {
        memcpy(it->name, name, length);
    }
    it->inner = it->name ? instantiated(guid, type == MODEL_EXCHANGE, type == MODEL_EXCHANGE, logging != 0, it, hand_on) : NULL;
    if (!it->inner) {
        FMI_NAME(FMI2_FUNCTION_PREFIX, fmi2FreeInstance)(it);
        return NULL;
    }
    return it;
}

FMI2(fmi3Status, SetDebugLogging)(void *component, int on, size_t count, const char *const *categories) {
    OF_COMPONENT
    return CALL(SetDebugLogging)(it->inner, on != 0, count, categories);
}

FMI2(fmi3Status, SetupExperiment)(void *component, int tolerance_defined, double tolerance, double start, int stop_defined, double stop) {
    OF_COMPONENT
    if (it->inner->now.phase != INSTANTIATED) {
        return say(it->inner, fmi3Error, "SetupExperiment must not be called in this state of the instance");
    }
    it->tolerance_defined = tolerance_defined != 0;
    it->tolerance = tolerance;
    it->start = start;
    it->stop_defined = stop_defined != 0;
    it->stop = stop;
    it->inner->now.time = start;
    return fmi3OK;
}

FMI2(fmi3Status, EnterInitializationMode)(void *component) {
    OF_COMPONENT
    return CALL(EnterInitializationMode)(it->inner, it->tolerance_defined, it->tolerance, it->start, it->stop_defined, it->stop);
}

/* Functions that FMI 3.0 has with the same arguments. */
#define SAME(name)                                    \
    FMI2(fmi3Status, name)(void *component) {         \
        OF_COMPONENT                                  \
        return CALL(name)(it->inner);                 \
    }

SAME(ExitInitializationMode)
SAME(EnterEventMode)
SAME(EnterContinuousTimeMode)
SAME(Terminate)

FMI2(fmi3Status, Reset)(void *component) {
    OF_COMPONENT
    it->tolerance_defined = it->stop_defined = false;
    it->start = 0.0;
    it->step = fmi3OK;
    return CALL(Reset)(it->inner);
}

/* ----------------------------------------------------------------------------------------------------------- values */

FMI2(fmi3Status, GetReal)(void *component, const fmi3ValueReference *references, size_t count, double *values) {
    OF_COMPONENT
    return CALL(GetFloat64)(it->inner, references, count, values, count);
}

FMI2(fmi3Status, SetReal)(void *component, const fmi3ValueReference *references, size_t count, const double *values) {
    OF_COMPONENT
    return CALL(SetFloat64)(it->inner, references, count, values, count);
}

FMI2(fmi3Status, GetBoolean)(void *component, const fmi3ValueReference *references, size_t count, int *values) {
    OF_COMPONENT
    for (size_t i = 0; i < count; i++) {
        bool value = false;
        const fmi3Status status = CALL(GetBoolean)(it->inner, references ? references + i : NULL, 1, values ? &value : NULL, 1);
        if (status != fmi3OK) {
            return status;
        }
        values[i] = value;
    }
    return fmi3OK;
}

FMI2(fmi3Status, SetBoolean)(void *component, const fmi3ValueReference *references, size_t count, const int *values) {
    OF_COMPONENT
    return CALL(SetBoolean)(it->inner, references, count, NULL, count);
}

/* Types of which the model has no variable. */
#define WITHOUT2(type, of3, c_type)                                                                                       \
    FMI2(fmi3Status, Get##type)(void *component, const fmi3ValueReference *references, size_t count, c_type *values) {    \
        OF_COMPONENT                                                                                                      \
        return CALL(Get##of3)(it->inner, references, count, NULL, count);                                                 \
    }                                                                                                                     \
    FMI2(fmi3Status, Set##type)(void *component, const fmi3ValueReference *references, size_t count, const c_type *values) { \
        OF_COMPONENT                                                                                                      \
        return CALL(Set##of3)(it->inner, references, count, NULL, count);                                                 \
    }

WITHOUT2(Integer, Int32, int)
WITHOUT2(String, String, char *)

/* --------------------------------------------------------------------------------------------- states of the instance */

FMI2(fmi3Status, GetFMUstate)(void *component, void **saved) {
    OF_COMPONENT
    return CALL(GetFMUState)(it->inner, saved);
}

FMI2(fmi3Status, SetFMUstate)(void *component, void *saved) {
    OF_COMPONENT
    return CALL(SetFMUState)(it->inner, saved);
}

FMI2(fmi3Status, FreeFMUstate)(void *component, void **saved) {
    OF_COMPONENT
    return CALL(FreeFMUState)(it->inner, saved);
}

FMI2(fmi3Status, SerializedFMUstateSize)(void *component, void *saved, size_t *size) {
    OF_COMPONENT
    return CALL(SerializedFMUStateSize)(it->inner, saved, size);
}

FMI2(fmi3Status, SerializeFMUstate)(void *component, void *saved, uint8_t *bytes, size_t size) {
    OF_COMPONENT
    return CALL(SerializeFMUState)(it->inner, saved, bytes, size);
}

FMI2(fmi3Status, DeSerializeFMUstate)(void *component, const uint8_t *bytes, size_t size, void **saved) {
    OF_COMPONENT
    return CALL(DeserializeFMUState)(it->inner, bytes, size, saved);
}

/* ------------------------------------------------------------------------------------------------------ derivatives */

FMI2(fmi3Status, GetDirectionalDerivative)(void *component, const fmi3ValueReference *unknowns, size_t unknown_count,
    const fmi3ValueReference *knowns, size_t known_count, const double *seed, double *result) {
    OF_COMPONENT
    return CALL(GetDirectionalDerivative)(
        it->inner, unknowns, unknown_count, knowns, known_count, seed, known_count, result, unknown_count);
}

/* --------------------------------------------------------------------------------------------------- Model Exchange */

FMI2(fmi3Status, NewDiscreteStates)(void *component, EventInfo *info) {
    bool again, terminate, nominals, values, next_defined;
    fmi3Status status;
    OF_COMPONENT
    if (!info) {
        return say(it->inner, fmi3Error, "an argument is a null pointer");
    }
    status = CALL(UpdateDiscreteStates)(it->inner, &again, &terminate, &nominals, &values, &next_defined, &info->next);
    if (status == fmi3OK) {
        info->again = again;
        info->terminate = terminate;
        info->nominals = nominals;
        info->values = values;
        info->next_defined = next_defined;
    }
    return status;
}

FMI2(fmi3Status, CompletedIntegratorStep)(void *component, int no_return, int *event_mode, int *terminate) {
    bool event, ended;
    fmi3Status status;
    OF_COMPONENT
    if (!event_mode || !terminate) {
        return say(it->inner, fmi3Error, "an argument is a null pointer");
    }
    status = CALL(CompletedIntegratorStep)(it->inner, no_return != 0, &event, &ended);
    if (status == fmi3OK) {
        *event_mode = event;
        *terminate = ended;
    }
    return status;
}

FMI2(fmi3Status, SetTime)(void *component, double time) {
    OF_COMPONENT
    return CALL(SetTime)(it->inner, time);
}

FMI2(fmi3Status, SetContinuousStates)(void *component, const double *states, size_t count) {
    OF_COMPONENT
    return CALL(SetContinuousStates)(it->inner, states, count);
}

/* Arrays of numbers that an importer asks for. */
#define ARRAY(name, of3)                                                                  \
    FMI2(fmi3Status, name)(void *component, double *values, size_t count) {               \
        OF_COMPONENT                                                                      \
        return CALL(of3)(it->inner, values, count);                                       \
    }

ARRAY(GetContinuousStates, GetContinuousStates)
ARRAY(GetNominalsOfContinuousStates, GetNominalsOfContinuousStates)
ARRAY(GetDerivatives, GetContinuousStateDerivatives)
ARRAY(GetEventIndicators, GetEventIndicators)

/* ---------------------------------------------------------------------------------------------------- Co-Simulation */

FMI2(fmi3Status, DoStep)(void *component, double from, double duration, int no_return) {
    bool event, terminate, early;
    double reached;
    OF_COMPONENT
    it->step = CALL(DoStep)(it->inner, from, duration, no_return != 0, &event, &terminate, &early, &reached);
    return it->step;
}

FMI2(fmi3Status, CancelStep)(void *component) {
    OF_COMPONENT
    return say(it->inner, fmi3Error, "no step is pending: this FMU returns when a step is done");
}

/* Derivatives of inputs and outputs by time, of which the FMU offers none. */
#define NO_DERIVATIVES(name, c_type)                                                                                            \
    FMI2(fmi3Status, name)(void *component, const fmi3ValueReference *references, size_t count, const int *orders, c_type *values) { \
        OF_COMPONENT                                                                                                            \
        return say(it->inner, fmi3Error, "this FMU has no use for " #name);                                                     \
    }

NO_DERIVATIVES(SetRealInputDerivatives, const double)
NO_DERIVATIVES(GetRealOutputDerivatives, double)

/* What is known of the last step, each kind asked for by its type; of others there is nothing to tell. */
#define STATUS(name, c_type, known, told)                                  \
    FMI2(fmi3Status, name)(void *component, int kind, c_type *value) {     \
        OF_COMPONENT                                                       \
        if (kind != (known) || !value) {                                   \
            return fmi3Discard;                                            \
        }                                                                  \
        *value = told;                                                     \
        return fmi3OK;                                                     \
    }

STATUS(GetStatus, fmi3Status, DO_STEP_STATUS, it->step)
STATUS(GetRealStatus, double, LAST_SUCCESSFUL_TIME, it->inner->now.time)
STATUS(GetBooleanStatus, int, TERMINATED_STATUS, 0) /* no motion ends by itself */
STATUS(GetStringStatus, const char *, PENDING_STATUS, "no step is pending")

FMI2(fmi3Status, GetIntegerStatus)(void *component, int kind, int *value) {
    OF_COMPONENT
    return fmi3Discard;
}
