/* Extension module with the contractors of contractors.py, for many boxes: one box after the other,
 * with the same operations in the same order.
 *
 * inverse(matrices, n, to): approximate inverses of matrices of floats, shape (n, n, N).
 * newton(values, slopes, middle, reach, n, by_rows, ends, noise, none): interval Newton steps.
 *
 * Arrays are contiguous, with N boxes along the last axis. values and ends are doubles of shape (2,
 * n, N), −low first; slopes (2, n, n, N); middle, reach and noise (n, N); none are N bytes.
 *
 * The rounding of ends is explained in _rounding.h. NaN is an end that is not known: every
 * comparison that proves something is false with it. */
#include "_arrays.h"

#include "_newton.h"

static void load_box(const double *from, int n, Py_ssize_t N, Py_ssize_t i, box *to) {
    for (int end = 0; end < 2; end++) {
        for (int k = 0; k < n; k++) {
            to->ends[end][k] = from[(end * n + k) * N + i];
        }
    }
}

static void load_matrix(const double *from, int n, Py_ssize_t N, Py_ssize_t i, matrix *to) {
    for (int end = 0; end < 2; end++) {
        for (int k = 0; k < n; k++) {
            for (int j = 0; j < n; j++) {
                to->ends[end][k][j] = from[((end * n + k) * n + j) * N + i];
            }
        }
    }
}

static void load_vector(const double *from, int n, Py_ssize_t N, Py_ssize_t i, double *to) {
    for (int k = 0; k < n; k++) {
        to[k] = from[k * N + i];
    }
}

static void store_box(const box *from, int n, Py_ssize_t N, Py_ssize_t i, double *to) {
    for (int end = 0; end < 2; end++) {
        for (int k = 0; k < n; k++) {
            to[(end * n + k) * N + i] = from->ends[end][k];
        }
    }
}

/* Whether compiled code takes n unknowns; an exception if not. */
static int takes(int n) {
    if (n >= 1 && n <= MAX_UNKNOWNS) {
        return 1;
    }
    PyErr_Format(PyExc_ValueError, "n = %d unknowns; allowed are 1 to %d", n, MAX_UNKNOWNS);
    return 0;
}

static PyObject *newton(PyObject *module, PyObject *arguments) {
    (void)module;
    PyObject *given[7];
    Py_buffer of[7];
    int n;
    int rows;
    if (!PyArg_ParseTuple(arguments, "OOOOiiOOO", given, given + 1, given + 2, given + 3, &n, &rows,
            given + 4, given + 5, given + 6) ||
        !takes(n) || !hold(given, of, "ddddDDB")) {
        return NULL;
    }
    const Py_ssize_t N = of[6].len;
    const Py_ssize_t one = N * n;
    const Py_ssize_t sizes[] = {2 * one, 2 * one * n, one, one, 2 * one, one, N};
    if (!sizes_fit(of, sizes, 7)) {
        release(of, 7);
        return NULL;
    }
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t i = 0; i < N; i++) {
        box values;
        box step;
        matrix slopes;
        vector middle;
        vector reach;
        vector noise;
        load_box(of[0].buf, n, N, i, &values);
        load_matrix(of[1].buf, n, N, i, &slopes);
        load_vector(of[2].buf, n, N, i, middle);
        load_vector(of[3].buf, n, N, i, reach);
        const int none = rows ?
            preconditioned_step(n, &slopes, &values, middle, reach, &step, noise) :
            newton_step(n, &values, &slopes, middle, reach, &step, noise);
        store_box(&step, n, N, i, of[4].buf);
        for (int k = 0; k < n; k++) {
            ((double *)of[5].buf)[k * N + i] = noise[k];
        }
        ((uint8_t *)of[6].buf)[i] = (uint8_t)none;
    }
    Py_END_ALLOW_THREADS
    release(of, 7);
    Py_RETURN_NONE;
}

static PyObject *inverses(PyObject *module, PyObject *arguments) {
    (void)module;
    PyObject *given[2];
    Py_buffer of[2];
    int n;
    if (!PyArg_ParseTuple(arguments, "OiO", given, &n, given + 1) || !takes(n) ||
        !hold(given, of, "dD")) {
        return NULL;
    }
    const Py_ssize_t one = (Py_ssize_t)n * n;
    const Py_ssize_t N = items_of(of) / one;
    const Py_ssize_t sizes[] = {N * one, N * one};
    if (!sizes_fit(of, sizes, 2)) {
        release(of, 2);
        return NULL;
    }
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t i = 0; i < N; i++) {
        vector m[MAX_UNKNOWNS];
        vector Y[MAX_UNKNOWNS];
        for (int k = 0; k < n; k++) {
            for (int j = 0; j < n; j++) {
                m[k][j] = ((const double *)of[0].buf)[(k * n + j) * N + i];
            }
        }
        inverse(n, m, Y);
        for (int k = 0; k < n; k++) {
            for (int j = 0; j < n; j++) {
                ((double *)of[1].buf)[(k * n + j) * N + i] = Y[k][j];
            }
        }
    }
    Py_END_ALLOW_THREADS
    release(of, 2);
    Py_RETURN_NONE;
}

static PyMethodDef methods[] = {
    {"newton", newton, METH_VARARGS, "A step of interval Newton for many boxes."},
    {"inverse", inverses, METH_VARARGS, "Inverses of matrices, roughly."}, {NULL, NULL, 0, NULL}};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_contractors", NULL, -1, methods, NULL, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__contractors(void) {
    PyObject *module = new_module(&definition);
    return module != NULL && PyModule_AddIntConstant(module, "MOST", MAX_UNKNOWNS) < 0 ? NULL :
                                                                                         module;
}
