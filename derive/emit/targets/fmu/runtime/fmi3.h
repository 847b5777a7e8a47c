/* What FMI 3.0 lays down of types and of what an importer hands over, as far as this FMU uses it: https://fmi-standard.org. */
#ifndef FMI3_H
#define FMI3_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum {
    fmi3OK,
    fmi3Warning,
    fmi3Discard,
    fmi3Error,
    fmi3Fatal
} fmi3Status;

typedef uint32_t fmi3ValueReference;
typedef void (*fmi3LogMessageCallback)(void *environment, fmi3Status status, const char *category, const char *message);

/* Statically linked FMUs have a prefix of their own; in a shared library functions have the names of the standard. */
#ifndef FMI3_FUNCTION_PREFIX
#define FMI3_FUNCTION_PREFIX
#endif
#define FMI_JOINED(prefix, name) prefix##name
#define FMI_NAME(prefix, name) FMI_JOINED(prefix, name)

/* What includes these functions to call them only defines it as nothing. */
#if defined(FMI_EXPORT)
#elif defined(_WIN32)
#define FMI_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define FMI_EXPORT __attribute__((visibility("default")))
#else
#define FMI_EXPORT
#endif
#define FMI(type, name) FMI_EXPORT type FMI_NAME(FMI3_FUNCTION_PREFIX, fmi3##name)

#endif
