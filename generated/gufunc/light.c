/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* chasles._kernels.one: a light function for each kernel. Made by `chasles emit`; not to be edited by hand.
 *
 * Nothing is cast, copied or broadcast, which is what a call of a ufunc spends its time on: an input is one element or
 * a C-contiguous batch, all batches have one shape, and all arrays one precision.
 */
#define NO_IMPORT_ARRAY
#define NO_IMPORT_UFUNC
#include "kernels.h"

#include <string.h>

#include <numpy/arrayobject.h>

/* From so many items on the global lock is released: below, that costs more than the loop. */
#define MANY 256

/* A call under way. `batch` and `axes` are the shape that batches have; `kind` is 0 until an array says which. */
typedef struct {
    const Kernel *kernel;
    const chasles_loop *loop;
    PyObject *from[CHASLES_OPERANDS];
    char *at[CHASLES_OPERANDS];
    ptrdiff_t steps[CHASLES_OPERANDS];
    double numbers[CHASLES_OPERANDS];
    npy_intp batch[NPY_MAXDIMS];
    int axes;
    npy_intp count;
    int kind;
} Call;

static const char *word_of(int kind)
{
    return kind == NPY_FLOAT ? "float32" : "float64";
}

static void refuse(const Call *call, int k, PyObject *error, const char *what)
{
    PyErr_Format(error, "one.%s: %s %s", call->kernel->name, call->kernel->operands[k], what);
}

/* The extents of the core axes of operand k; gives how many. */
static int core_of(const Call *call, int k, npy_intp *core)
{
    const chasles_shape shape = call->loop->shapes[k];
    core[0] = shape.axes == 2 ? shape.rows : shape.columns;
    core[1] = shape.columns;
    return shape.axes;
}

/* Whether operand k is an array of the right kind, without gaps; sets the kind where it is open yet. */
static int is_plain(Call *call, int k, PyArrayObject *array)
{
    const int kind = PyArray_TYPE(array);
    if (!PyArray_CheckExact(array) && PyObject_HasAttrString((PyObject *)array, "mask")) {
        refuse(call, k, PyExc_ValueError, "is a masked array: hand over its numbers, as .filled(nan)");
        return 0;
    }
    if (kind != NPY_DOUBLE && kind != NPY_FLOAT) {
        PyErr_Format(
            PyExc_TypeError, "one.%s: %s must be of float64 or float32, not %S; kernels.%s casts", call->kernel->name,
            call->kernel->operands[k], PyArray_DESCR(array), call->kernel->name);
        return 0;
    }
    if (call->kind != 0 && kind != call->kind) {
        PyErr_Format(
            PyExc_TypeError, "one.%s: %s is of %s, arrays before it of %s; kernels.%s casts", call->kernel->name,
            call->kernel->operands[k], word_of(kind), word_of(call->kind), call->kernel->name);
        return 0;
    }
    call->kind = kind;
    if (!PyArray_ISCARRAY_RO(array)) {
        PyErr_Format(
            PyExc_ValueError, "one.%s: %s must be C-contiguous, aligned and in native byte order; kernels.%s takes any",
            call->kernel->name, call->kernel->operands[k], call->kernel->name);
        return 0;
    }
    return 1;
}

/* Raises for operand k, whose shape does not fit; gives 0. */
static int refuse_shape(const Call *call, int k, PyArrayObject *array)
{
    npy_intp core[2];
    const int axes = core_of(call, k, core);
    PyObject *found = PyObject_GetAttrString((PyObject *)array, "shape");
    PyObject *batch = PyTuple_New(call->axes + axes);
    for (int i = 0; batch != NULL && i < call->axes + axes; i++) {
        PyTuple_SetItem(batch, i, PyLong_FromSsize_t(i < call->axes ? call->batch[i] : core[i - call->axes]));
    }
    if (found != NULL && batch != NULL) {
        const char *what = call->axes > 0 ? "beside that batch" : k < call->loop->inputs ? "in its last axes" : "here";
        PyErr_Format(
            PyExc_ValueError, "one.%s: %s must have the shape %R %s; it has %R", call->kernel->name,
            call->kernel->operands[k], batch, what, found);
    }
    Py_XDECREF(found);
    Py_XDECREF(batch);
    return 0;
}

/* Whether the array fits operand k; the first batch says what shape batches have. */
static int fits(Call *call, int k, PyArrayObject *array)
{
    npy_intp core[2];
    const int axes = core_of(call, k, core);
    const int before = PyArray_NDIM(array) - axes;
    const npy_intp *shape = PyArray_DIMS(array);
    int right = before >= 0;
    for (int i = 0; right && i < axes; i++) {
        right = shape[before + i] == core[i];
    }
    if (right && before > 0 && call->axes == 0 && k < call->loop->inputs) {
        call->axes = before;
        for (int i = 0; i < before; i++) {
            call->batch[i] = shape[i];
            call->count *= shape[i];
        }
    }
    right = right && (before == call->axes || (before == 0 && k < call->loop->inputs));
    for (int i = 0; right && i < before; i++) {
        right = shape[i] == call->batch[i];
    }
    call->steps[k] = right && before > 0 ? call->loop->number * call->loop->shapes[k].rows * call->loop->shapes[k].columns : 0;
    return right || refuse_shape(call, k, array);
}

/* Whether input k can be had: an array, or a number where one is asked for. */
static int take(Call *call, int k, PyObject *value)
{
    call->from[k] = value;
    if (PyArray_Check(value)) {
        return is_plain(call, k, (PyArrayObject *)value);
    }
    if (call->loop->shapes[k].axes > 0) {
        PyErr_Format(
            PyExc_TypeError, "one.%s: %s must be a NumPy array, not %R; kernels.%s takes what becomes one",
            call->kernel->name, call->kernel->operands[k], (PyObject *)Py_TYPE(value), call->kernel->name);
        return 0;
    }
    call->numbers[k] = PyFloat_AsDouble(value);
    if (call->numbers[k] == -1.0 && PyErr_Occurred()) {
        if (PyErr_ExceptionMatches(PyExc_TypeError)) {
            PyErr_Format(
                PyExc_TypeError, "one.%s: %s must be a real number or a NumPy array, not %R", call->kernel->name,
                call->kernel->operands[k], (PyObject *)Py_TYPE(value));
        }
        return 0;
    }
    return 1;
}

/* The address of input k, once it is known in what precision it is wanted. */
static int place(Call *call, int k)
{
    if (PyArray_Check(call->from[k])) {
        PyArrayObject *array = (PyArrayObject *)call->from[k];
        call->at[k] = PyArray_BYTES(array);
        return fits(call, k, array);
    }
    if (call->kind == NPY_FLOAT) {
        const float narrow = (float)call->numbers[k];
        memcpy(&call->numbers[k], &narrow, sizeof narrow);
    }
    call->at[k] = (char *)&call->numbers[k];
    call->steps[k] = 0;
    return 1;
}

/* Output k: the array given, or a new one; a new reference, or NULL with an exception set. */
static PyObject *room(Call *call, int k, PyObject *given)
{
    npy_intp shape[NPY_MAXDIMS];
    if (given == NULL || given == Py_None) {
        npy_intp core[2];
        const int axes = core_of(call, k, core);
        if (call->axes + axes > NPY_MAXDIMS) {
            refuse(call, k, PyExc_ValueError, "would have too many axes");
            return NULL;
        }
        memcpy(shape, call->batch, (size_t)call->axes * sizeof *shape);
        memcpy(shape + call->axes, core, (size_t)axes * sizeof *shape);
        PyObject *made = PyArray_SimpleNew(call->axes + axes, shape, call->kind);
        if (made != NULL) {
            call->at[k] = PyArray_BYTES((PyArrayObject *)made);
            call->steps[k] = call->loop->number * call->loop->shapes[k].rows * call->loop->shapes[k].columns;
        }
        return made;
    }
    if (!PyArray_Check(given)) {
        refuse(call, k, PyExc_TypeError, "as `out` must be a NumPy array or None");
        return NULL;
    }
    PyArrayObject *array = (PyArrayObject *)given;
    if (!is_plain(call, k, array) || !fits(call, k, array)) {
        return NULL;
    }
    if (!PyArray_ISWRITEABLE(array)) {
        refuse(call, k, PyExc_ValueError, "as `out` must be writable");
        return NULL;
    }
    call->at[k] = PyArray_BYTES(array);
    Py_INCREF(given);
    return given;
}

/* Copies each input that an output lies over: an item's result may fall on what a later item reads. */
static int keep_apart(Call *call, PyObject **copies)
{
    for (int i = 0; i < call->loop->inputs; i++) {
        const int is_array = PyArray_Check(call->from[i]);
        const char *low = call->at[i], *high = low + (is_array ? PyArray_NBYTES((PyArrayObject *)call->from[i]) : 0);
        int over = 0;
        for (int k = call->loop->inputs; k < call->loop->operands; k++) {
            over |= call->at[k] < high && low < call->at[k] + call->count * call->steps[k];
        }
        if (over) {
            copies[i] = PyArray_NewCopy((PyArrayObject *)call->from[i], NPY_CORDER);
            if (copies[i] == NULL) {
                return 0;
            }
            call->at[i] = PyArray_BYTES((PyArrayObject *)copies[i]);
        }
    }
    return 1;
}

static void go(const Call *call)
{
    if (call->kernel->run != NULL) {
        call->kernel->run(call->loop, call->count, call->at, call->steps);
    } else {
        chasles_run(call->loop, chasles_level, call->count, call->at, call->steps, NULL);
    }
}

/* Runs the kernel on operands that are all in place. */
static int run(Call *call)
{
    if (call->count == 1) {
        go(call);
        return 1;
    }
    PyObject *copies[CHASLES_OPERANDS] = {NULL};
    const int apart = keep_apart(call, copies);
    if (apart && call->count < MANY) {
        go(call);
    } else if (apart) {
        Py_BEGIN_ALLOW_THREADS
        go(call);
        Py_END_ALLOW_THREADS
    }
    for (int i = 0; i < CHASLES_OPERANDS; i++) {
        Py_XDECREF(copies[i]);
    }
    return apart;
}

/* The arrays given as `out`, one for each output or NULL; whether they are as many as they must be. */
static int find_out(const Call *call, PyObject *out, PyObject **given)
{
    const int outputs = call->loop->operands - call->loop->inputs;
    for (int k = 0; k < outputs; k++) {
        given[k] = NULL;
    }
    if (out == NULL || out == Py_None) {
        return 1;
    }
    if (PyTuple_Check(out)) {
        if (PyTuple_Size(out) != outputs) {
            PyErr_Format(
                PyExc_ValueError, "one.%s: out must hold %d arrays, not %zd", call->kernel->name, outputs,
                PyTuple_Size(out));
            return 0;
        }
        for (int k = 0; k < outputs; k++) {
            given[k] = PyTuple_GetItem(out, k);
        }
        return 1;
    }
    if (outputs != 1) {
        PyErr_Format(PyExc_TypeError, "one.%s: out must be a tuple of %d arrays", call->kernel->name, outputs);
        return 0;
    }
    given[0] = out;
    return 1;
}

/* The results, as a ufunc gives them: a scalar where a new array would have no axes. */
static PyObject *delivered(const Call *call, PyObject **made, PyObject **given)
{
    const int outputs = call->loop->operands - call->loop->inputs;
    for (int k = 0; k < outputs; k++) {
        if (given[k] == NULL || given[k] == Py_None) {
            made[k] = PyArray_Return((PyArrayObject *)made[k]);
        }
    }
    if (outputs == 1) {
        return made[0];
    }
    PyObject *all = PyTuple_New(outputs);
    for (int k = 0; k < outputs; k++) {
        if (all == NULL || made[k] == NULL) {
            Py_XDECREF(made[k]);
        } else {
            PyTuple_SetItem(all, k, made[k]);
        }
    }
    if (PyErr_Occurred()) {
        Py_CLEAR(all);
    }
    return all;
}

static PyObject *compute(Call *call, PyObject *out)
{
    PyObject *made[CHASLES_OPERANDS], *given[CHASLES_OPERANDS];
    const int inputs = call->loop->inputs, outputs = call->loop->operands - inputs;
    int right = find_out(call, out, given), rooms = 0;
    call->count = 1;
    for (int k = 0; right && k < inputs; k++) {
        right = place(call, k);
    }
    while (right && rooms < outputs) {
        made[rooms] = room(call, inputs + rooms, given[rooms]);
        right = made[rooms] != NULL;
        rooms += right;
    }
    if (right && run(call)) {
        return delivered(call, made, given);
    }
    while (rooms > 0) {
        Py_DECREF(made[--rooms]);
    }
    return NULL;
}

static PyObject *one(PyObject *self, PyObject *const *args, Py_ssize_t count, PyObject *names)
{
    Call call;
    call.kernel = PyCapsule_GetPointer(self, NULL);
    if (call.kernel == NULL) {
        return NULL;
    }
    call.loop = call.kernel->loops[0];
    call.kind = 0;
    call.axes = 0;
    const Py_ssize_t named = names == NULL ? 0 : PyTuple_Size(names);
    if (named > 1 || (named == 1 && PyUnicode_CompareWithASCIIString(PyTuple_GetItem(names, 0), "out") != 0)) {
        PyErr_Format(PyExc_TypeError, "one.%s takes no argument by name but out", call.kernel->name);
        return NULL;
    }
    if (count != call.loop->inputs) {
        PyErr_Format(
            PyExc_TypeError, "one.%s takes %d inputs, %zd were given", call.kernel->name, call.loop->inputs, count);
        return NULL;
    }
    for (int k = 0; k < call.loop->inputs; k++) {
        if (!take(&call, k, args[k])) {
            return NULL;
        }
    }
    call.kind = call.kind == 0 ? NPY_DOUBLE : call.kind;
    call.loop = call.kernel->loops[call.kind == NPY_DOUBLE];
    return compute(&call, named == 1 ? args[count] : NULL);
}

PyObject *chasles_light_function(PyMethodDef *method, PyObject *capsule, const Kernel *kernel)
{
    method->ml_name = kernel->name;
    method->ml_meth = (PyCFunction)(void (*)(void))one;
    method->ml_flags = METH_FASTCALL | METH_KEYWORDS;
    method->ml_doc = kernel->doc;
    return PyCFunction_NewEx(method, capsule, NULL);
}

/* Adds the function of a kernel; -1 with an exception set where that fails. */
static int add(PyObject *module, PyMethodDef *method, const Kernel *kernel)
{
    PyObject *capsule = PyCapsule_New((void *)kernel, NULL, NULL);
    PyObject *function = capsule == NULL ? NULL : chasles_light_function(method, capsule, kernel);
    const int status = function == NULL ? -1 : PyModule_AddObjectRef(module, kernel->name, function);
    Py_XDECREF(capsule);
    Py_XDECREF(function);
    return status;
}

PyObject *chasles_light_functions(void)
{
    static PyMethodDef methods[113 + 1];
    PyObject *module = PyModule_New("chasles._kernels.one");
    for (int i = 0; module != NULL && chasles_kernels[i].name != NULL; i++) {
        if (add(module, &methods[i], &chasles_kernels[i]) < 0) {
            Py_CLEAR(module);
        }
    }
    return module;
}
