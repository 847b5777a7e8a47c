/* Interval arithmetic over many boxes: operations of a tape, one after the other, see _operations.h.
 *
 * run(code, numbers, inputs, out, slots)
 *
 * code: int32, four to an operation: which, to, a, b. numbers: doubles that operations name by their place. inputs: a tuple of buffers of
 * doubles of shape (2, rows, N), −low and high, with any strides. out: doubles of shape (2, outputs, N), contiguous. slots: how many
 * intermediate results are alive at once. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "_arrays.h"
#include "_operations.h"

#define MOST_INPUTS 8

static PyObject *run(PyObject *module, PyObject *arguments) {
    (void)module;
    Py_buffer code;
    Py_buffer numbers;
    PyObject *given;
    PyObject *result;
    Py_ssize_t count;
    if (!PyArg_ParseTuple(arguments, "y*y*O!On", &code, &numbers, &PyTuple_Type, &given, &result, &count)) {
        return NULL;
    }
    Py_buffer of[MOST_INPUTS];
    operand inputs[MOST_INPUTS];
    Py_buffer out;
    Py_ssize_t held = 0;
    int whole = 0;
    slot *slots = NULL;
    const Py_ssize_t wanted = PyTuple_GET_SIZE(given);
    if (taken(result, &out, PyBUF_C_CONTIGUOUS | PyBUF_WRITABLE) < 0) {
        goto end;
    }
    int as_many = wanted <= MOST_INPUTS;
    while (held < wanted && held < MOST_INPUTS && taken(PyTuple_GET_ITEM(given, held), of + held, PyBUF_STRIDED_RO) == 0) {
        const Py_buffer *each = of + held;
        as_many &= each->shape[2] == out.shape[2];
        inputs[held++] = (operand){each->buf, {each->strides[0], each->strides[1], each->strides[2]}, each->shape[1], NULL};
    }
    if (PyErr_Occurred()) {
        goto release;
    }
    const program tape = {code.buf, code.len / (Py_ssize_t)(4 * sizeof(int32_t)), numbers.buf, numbers.len / (Py_ssize_t)sizeof(double),
        out.shape[1], count};
    if (!as_many || count < 1 || !sound(&tape, inputs, held)) {
        PyErr_SetString(PyExc_ValueError, "an operation of the tape is beyond its arrays");
        goto release;
    }
    slots = PyMem_RawMalloc((size_t)count * sizeof(slot));
    if (slots == NULL) {
        PyErr_NoMemory();
        goto release;
    }
    Py_BEGIN_ALLOW_THREADS for (Py_ssize_t begin = 0; begin < out.shape[2]; begin += BLOCK) {
        const Py_ssize_t left = out.shape[2] - begin;
        block(&tape, inputs, slots, out.buf, out.shape[2], begin, (int)(left < BLOCK ? left : BLOCK));
    }
    Py_END_ALLOW_THREADS
        whole = 1;
release:
    while (held > 0) {
        PyBuffer_Release(of + --held);
    }
    PyBuffer_Release(&out);
end:
    PyMem_RawFree(slots);
    PyBuffer_Release(&code);
    PyBuffer_Release(&numbers);
    if (!whole) {
        return NULL;
    }
    Py_RETURN_NONE;
}

static PyMethodDef methods[] = {{"run", run, METH_VARARGS, "Operations of a tape over boxes."}, {NULL, NULL, 0, NULL}};

static struct PyModuleDef definition = {PyModuleDef_HEAD_INIT, "_tape", NULL, -1, methods, NULL, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__tape(void) {
    PyObject *module = PyModule_Create(&definition);
    PyObject *names = PyTuple_New(COUNT);
    if (module == NULL || names == NULL) {
        return NULL;
    }
    for (int k = 0; k < COUNT; k++) {
        PyTuple_SET_ITEM(names, k, PyUnicode_FromString(OPERATIONS[k]));
    }
    return PyModule_AddObject(module, "OPERATIONS", names) < 0 ? NULL : module;
}
