/* Extension module that runs tapes over many boxes: in interval arithmetic, see _operations.h, and
 * in affine arithmetic, see _affine.h.
 *
 * run(code, numbers, inputs, out, slots)
 *     code: bytes of int32, four for each operation; numbers: bytes of doubles, the constants.
 *     inputs: a tuple of buffers of doubles of shape (2, rows, N), −low and high, with any strides.
 *     out: doubles of shape (2, outputs, N), contiguous.
 *     slots: the number of intermediate results that are needed at once.
 *
 * affine(code, numbers, values, terms, errors, intervals, out_values, out_terms, out_errors, slots)
 *     values, errors: doubles of shape (rows, N) of the first input; terms of shape (symbols, rows,
 *     N). Those of the results have outputs in place of rows. All are contiguous.
 *     intervals: the second input, as those of `run`. */
#include "_arrays.h"

#include "_affine.h"
#include "_operations.h"

#define MOST_INPUTS 8

static PyObject *run(PyObject *module, PyObject *arguments) {
    (void)module;
    const char *code;
    const char *numbers;
    Py_ssize_t codes;
    Py_ssize_t constants;
    PyObject *given;
    PyObject *result;
    Py_ssize_t count;
    if (!PyArg_ParseTuple(arguments, "y#y#O!On", &code, &codes, &numbers, &constants, &PyTuple_Type,
            &given, &result, &count)) {
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
        return NULL;
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
    const program tape = program_of(code, codes, numbers, constants, out.shape[1], count);
    if (!as_many || !sound(&tape, inputs, held)) {
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
    PyMem_RawFree(slots);
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
    const char *code;
    const char *numbers;
    Py_ssize_t codes;
    Py_ssize_t constants;
    PyObject *arrays[6];
    Py_buffer of[6];
    Py_buffer intervals;
    PyObject *given;
    Py_ssize_t slots;
    int whole = 0;
    if (!PyArg_ParseTuple(arguments, "y#y#OOOOOOOn", &code, &codes, &numbers, &constants, arrays,
            arrays + 1, arrays + 2, &given, arrays + 3, arrays + 4, arrays + 5, &slots) ||
        interval_buffer(given, &intervals, PyBUF_STRIDED_RO) < 0) {
        return NULL;
    }
    if (!hold(arrays, of, "dddDDD")) {
        PyBuffer_Release(&intervals);
        return NULL;
    }
    const Py_ssize_t N = intervals.shape[2];
    const Py_ssize_t entries = items_of(of);
    const Py_ssize_t results = items_of(of + 3);
    const Py_ssize_t rows = N ? entries / N : 0;
    const Py_ssize_t outputs = N ? results / N : 0;
    const Py_ssize_t symbols = rows ? items_of(of + 1) / entries : 0;
    const affine_inputs inputs = {of[0].buf, of[2].buf, of[1].buf, rows, N,
        {intervals.buf, {intervals.strides[0], intervals.strides[1], intervals.strides[2]},
            intervals.shape[1], NULL}};
    const program tape = program_of(code, codes, numbers, constants, outputs, slots);
    const operand both[2] = {{.rows = rows}, {.rows = intervals.shape[1]}};
    const Py_ssize_t sizes[] = {rows * N, symbols * entries, entries, outputs * N,
        outputs * N * symbols, outputs * N};
    if (!sizes_fit(of, sizes, 6)) {
        whole = 0;
    } else if (symbols < 1 || symbols > INT16_MAX || !sound(&tape, both, 2) ||
        !affine_throughout(&tape)) {
        PyErr_SetString(PyExc_ValueError,
            "an operation of the tape is beyond its arrays, or none of affine numbers");
    } else {
        const affine_results out = {of[3].buf, of[5].buf, of[4].buf};
        whole = affine_of_all(&tape, &inputs, &out, (int)symbols);
        if (!whole) {
            PyErr_NoMemory();
        }
    }
    PyBuffer_Release(&intervals);
    release(of, 6);
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
    PyObject *module = new_module(&definition);
    PyObject *names = PyTuple_New(COUNT);
    if (module == NULL || names == NULL) {
        return NULL;
    }
    for (int k = 0; k < COUNT; k++) {
        PyTuple_SET_ITEM(names, k, PyUnicode_FromString(OPERATIONS[k]));
    }
    return PyModule_AddObject(module, "OPERATIONS", names) < 0 ? NULL : module;
}
