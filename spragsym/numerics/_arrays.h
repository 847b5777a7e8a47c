/* NumPy arrays as buffers, for _tape.c, _contractors.c and _search.c. */
#ifndef SPRAGSYM_ARRAYS_H
#define SPRAGSYM_ARRAYS_H

#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include <string.h>

/* Get a buffer of doubles of shape (2, rows, N); −1, and an exception, if it is none. */
static inline int interval_buffer(PyObject *from, Py_buffer *to, int flags) {
    if (PyObject_GetBuffer(from, to, flags | PyBUF_FORMAT) < 0) {
        return -1;
    }
    if (to->ndim == 3 && to->shape[0] == 2 && to->format != NULL && strcmp(to->format, "d") == 0) {
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

#endif
