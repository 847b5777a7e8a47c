/* NumPy arrays as buffers, and the digest of its sources, for every extension module.
 *
 * Kinds and sizes of buffers are checked here, before anything is read or written. */
#ifndef SPRAGSYM_ARRAYS_H
#define SPRAGSYM_ARRAYS_H

#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include <stdint.h>
#include <string.h>

/* Given by setup.py; a module without it is not used, see core/extensions.py. */
#ifndef SPRAGSYM_DIGEST
#define SPRAGSYM_DIGEST none
#endif
#define TEXT_OF(word) #word
#define TEXT(word) TEXT_OF(word)

/* The module of a definition, with the digest of the sources that it was compiled from. */
static inline PyObject *new_module(PyModuleDef *definition) {
    PyObject *module = PyModule_Create(definition);
    if (module != NULL &&
        PyModule_AddStringConstant(module, "DIGEST", TEXT(SPRAGSYM_DIGEST)) < 0) {
        Py_DECREF(module);
        return NULL;
    }
    return module;
}

/* Whether the items of a buffer are of a kind: d doubles, l integers of 64 bits, b bytes
 * of any meaning. */
static inline int is_of_kind(const Py_buffer *given, char kind) {
    const char *formats = kind == 'd' ? "d" : kind == 'l' ? "lq" :
                                                            "?bB";
    const Py_ssize_t size = kind == 'b' ? 1 : 8;
    const char *format = given->format == NULL ? "B" : given->format;
    int aligned = (uintptr_t)given->buf % (uintptr_t)size == 0;
    for (int k = 0; given->strides != NULL && k < given->ndim; k++) {
        aligned &= given->strides[k] % size == 0;
    }
    return given->itemsize == size && format[0] != '\0' && format[1] == '\0' &&
        strchr(formats, format[0]) != NULL && aligned;
}

/* Get a buffer of a kind; −1, and an exception, if it is none. */
static inline int buffer_of_kind(PyObject *from, Py_buffer *to, char kind, int flags) {
    if (PyObject_GetBuffer(from, to, flags | PyBUF_FORMAT) < 0) {
        return -1;
    }
    if (is_of_kind(to, kind)) {
        return 0;
    }
    PyErr_Format(PyExc_ValueError, "an array holds items of format %s and of %zd bytes; expected is kind %c, aligned",
        to->format == NULL ? "B" : to->format, to->itemsize, kind);
    PyBuffer_Release(to);
    return -1;
}

/* Get a buffer of doubles of shape (2, rows, N); −1, and an exception, if it is none. */
static inline int interval_buffer(PyObject *from, Py_buffer *to, int flags) {
    if (buffer_of_kind(from, to, 'd', flags | PyBUF_STRIDES) < 0) {
        return -1;
    }
    if (to->ndim == 3 && to->shape[0] == 2) {
        return 0;
    }
    PyBuffer_Release(to);
    PyErr_SetString(PyExc_ValueError, "boxes are doubles of shape (2, rows, N)");
    return -1;
}

static inline void release(Py_buffer *given, int count) {
    for (int k = 0; k < count; k++) {
        PyBuffer_Release(given + k);
    }
}

/* Get contiguous buffers, as many as `kinds` has letters, of which a capital is for one that is
 * written; 0, none held, and an exception, if one is not of its kind. */
static inline int hold(PyObject *const *from, Py_buffer *to, const char *kinds) {
    for (int k = 0; kinds[k] != '\0'; k++) {
        const int written = kinds[k] >= 'A' && kinds[k] <= 'Z';
        const char kind = (char)(written ? kinds[k] - 'A' + 'a' : kinds[k]);
        if (buffer_of_kind(
                from[k], to + k, kind, PyBUF_C_CONTIGUOUS | (written ? PyBUF_WRITABLE : 0)) < 0) {
            release(to, k);
            return 0;
        }
    }
    return 1;
}

/* The number of items of a buffer. */
static inline Py_ssize_t items_of(const Py_buffer *given) { return given->len / given->itemsize; }

/* Whether buffers have as many items as they should have; an exception if not. */
static inline int sizes_fit(const Py_buffer *given, const Py_ssize_t *sizes, int count) {
    for (int k = 0; k < count; k++) {
        if (items_of(given + k) != sizes[k]) {
            PyErr_SetString(PyExc_ValueError, "arrays do not have the shapes of one another");
            return 0;
        }
    }
    return 1;
}

#endif
