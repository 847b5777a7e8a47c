/* Extension module that runs tapes over many boxes: in interval arithmetic, see _operations.h, and
 * in affine arithmetic, see _affine.h.
 *
 * run(code, numbers, inputs, out, slots)
 *     code: int32, four for each operation; numbers: doubles, the constants.
 *     inputs: a tuple of buffers of doubles of shape (2, rows, N), −low and high, with any strides.
 *     out: doubles of shape (2, outputs, N), contiguous.
 *     slots: the number of intermediate results that are needed at once.
 *
 * affine(code, numbers, values, terms, errors, intervals, out_values, out_terms, out_errors, slots)
 *     values, errors: doubles of shape (rows, N) of the first input; terms of shape (symbols, rows,
 *     N). Those of the results have outputs in place of rows. All are contiguous.
 *     intervals: the second input, as those of `run`. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "_affine.h"
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
    if (!PyArg_ParseTuple(
            arguments, "y*y*O!On", &code, &numbers, &PyTuple_Type, &given, &result, &count)) {
        return NULL;
    }
    Py_buffer of[MOST_INPUTS];
    operand inputs[MOST_INPUTS];
    Py_buffer out;
    Py_ssize_t held = 0;
    int whole = 0;
    slot *slots = NULL;
    const Py_ssize_t wanted = PyTuple_GET_SIZE(given);
    if (interval_buffer(result, &out, PyBUF_C_CONTIGUOUS | PyBUF_WRITABLE) < 0) {
        goto end;
    }
    int as_many = wanted <= MOST_INPUTS;
    while (held < wanted && held < MOST_INPUTS &&
        interval_buffer(PyTuple_GET_ITEM(given, held), of + held, PyBUF_STRIDED_RO) == 0) {
        const Py_buffer *each = of + held;
        as_many &= each->shape[2] == out.shape[2];
        inputs[held++] = (operand){each->buf,
            {each->strides[0], each->strides[1], each->strides[2]}, each->shape[1], NULL};
    }
    if (PyErr_Occurred()) {
        goto release;
    }
    const program tape = {code.buf, code.len / (Py_ssize_t)(4 * sizeof(int32_t)), numbers.buf,
        numbers.len / (Py_ssize_t)sizeof(double), out.shape[1], count};
    if (!as_many || count < 1 || !sound(&tape, inputs, held)) {
        PyErr_SetString(PyExc_ValueError, "an operation of the tape is beyond its arrays");
        goto release;
    }
    slots = PyMem_RawMalloc((size_t)count * sizeof(slot));
    if (slots == NULL) {
        PyErr_NoMemory();
        goto release;
    }
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t begin = 0; begin < out.shape[2]; begin += BLOCK) {
        const Py_ssize_t left = out.shape[2] - begin;
        block(
            &tape, inputs, slots, out.buf, out.shape[2], begin, (int)(left < BLOCK ? left : BLOCK));
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

/* Run a tape in affine arithmetic on all boxes; 0 if there is no memory. */
static int affine_of_all(
    const program *tape, const affine_inputs *inputs, const affine_results *out, int symbols) {
    const size_t rows = (size_t)tape->slots * (size_t)(2 + symbols);
    forms all = {symbols, PyMem_RawCalloc(rows * FEW, sizeof(double))};
    slot *work = PyMem_RawCalloc(WORK, sizeof(slot));
    if (all.at != NULL && work != NULL) {
        Py_BEGIN_ALLOW_THREADS
        for (ptrdiff_t begin = 0; begin < inputs->every; begin += FEW) {
            const ptrdiff_t left = inputs->every - begin;
            affine_block(tape, inputs, &all, work, out, inputs->every, begin,
                (int)(left < FEW ? left : FEW));
        }
        Py_END_ALLOW_THREADS
    }
    const int whole = all.at != NULL && work != NULL;
    PyMem_RawFree(all.at);
    PyMem_RawFree(work);
    return whole;
}

static PyObject *affine(PyObject *module, PyObject *arguments) {
    (void)module;
    Py_buffer of[8];
    Py_buffer intervals;
    PyObject *given;
    Py_ssize_t slots;
    int whole = 0;
    if (!PyArg_ParseTuple(arguments, "y*y*y*y*y*Ow*w*w*n", of, of + 1, of + 2, of + 3, of + 4,
            &given, of + 5, of + 6, of + 7, &slots)) {
        return NULL;
    }
    if (interval_buffer(given, &intervals, PyBUF_STRIDED_RO) < 0) {
        release(of, 8);
        return NULL;
    }
    const Py_ssize_t N = intervals.shape[2];
    const Py_ssize_t row = N * (Py_ssize_t)sizeof(double);
    const Py_ssize_t rows = N ? of[2].len / row : 0;
    const Py_ssize_t outputs = N ? of[5].len / row : 0;
    const Py_ssize_t symbols = rows ? of[3].len / of[2].len : 0;
    const affine_inputs inputs = {of[2].buf, of[4].buf, of[3].buf, rows, N,
        {intervals.buf, {intervals.strides[0], intervals.strides[1], intervals.strides[2]},
            intervals.shape[1], NULL}};
    const program tape = {of[0].buf, of[0].len / (Py_ssize_t)(4 * sizeof(int32_t)), of[1].buf,
        of[1].len / (Py_ssize_t)sizeof(double), outputs, slots};
    const operand both[2] = {{.rows = rows}, {.rows = intervals.shape[1]}};
    const int fits = slots > 0 && symbols > 0 && of[2].len == rows * row &&
        of[4].len == of[2].len && of[3].len == symbols * of[2].len && of[5].len == outputs * row &&
        of[7].len == of[5].len && of[6].len == symbols * of[5].len;
    if (!fits || !sound(&tape, both, 2) || !affine_throughout(&tape)) {
        PyErr_SetString(PyExc_ValueError,
            "an operation of the tape is beyond its arrays, or none of affine numbers");
    } else {
        const affine_results out = {of[5].buf, of[7].buf, of[6].buf};
        whole = affine_of_all(&tape, &inputs, &out, (int)symbols);
        if (!whole) {
            PyErr_NoMemory();
        }
    }
    PyBuffer_Release(&intervals);
    release(of, 8);
    if (!whole) {
        return NULL;
    }
    Py_RETURN_NONE;
}

static PyMethodDef methods[] = {{"run", run, METH_VARARGS, "Operations of a tape over boxes."},
    {"affine", affine, METH_VARARGS, "Operations of a tape on affine numbers."},
    {NULL, NULL, 0, NULL}};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_tape", NULL, -1, methods, NULL, NULL, NULL, NULL};

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
