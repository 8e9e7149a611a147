/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* Ufuncs and light functions over loops that were compiled elsewhere. Made by `chasles emit`; not to be edited by hand.
 *
 * A loop is a plain C function of a ufunc's inner loop: whoever compiles one needs no header of Python or NumPy.
 */
#define NO_IMPORT_ARRAY
#define NO_IMPORT_UFUNC
#include "kernels.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* What a ufunc points to and does not own. */
typedef struct {
    PyUFuncGenericFunction functions[2];
    void *data[2];
    char types[2 * CHASLES_OPERANDS];
    char text[];
} Made;

static void discard(PyObject *capsule)
{
    free(PyCapsule_GetPointer(capsule, NULL));
}

/* The ufunc of what was made, which goes when the ufunc goes; NULL with an exception set where that fails. */
static PyObject *ufunc_of(Made *made, int inputs, int outputs, const char *doc, const char *signature)
{
    PyObject *capsule = PyCapsule_New(made, NULL, discard);
    if (capsule == NULL) {
        free(made);
        return NULL;
    }
    PyObject *ufunc = PyUFunc_FromFuncAndDataAndSignature(
        made->functions, made->data, made->types, 2, inputs, outputs, PyUFunc_None, made->text, doc, 0, signature);
    if (ufunc == NULL) {
        Py_DECREF(capsule);
        return NULL;
    }
    ((PyUFuncObject *)ufunc)->obj = capsule;
    return ufunc;
}

PyObject *chasles_make_ufunc(PyObject *module, PyObject *arguments)
{
    const char *name, *doc, *signature;
    int inputs, outputs;
    unsigned long long loop, single, twofold;
    (void)module;
    if (!PyArg_ParseTuple(
            arguments, "sssiiKKK:make_ufunc", &name, &doc, &signature, &inputs, &outputs, &loop, &single, &twofold)) {
        return NULL;
    }
    if (inputs < 1 || outputs < 1 || inputs > CHASLES_OPERANDS - outputs || loop == 0) {
        return PyErr_Format(
            PyExc_ValueError, "make_ufunc: expected a loop, and inputs and outputs that are at most %d together",
            CHASLES_OPERANDS);
    }
    const size_t operands = (size_t)(inputs + outputs), named = strlen(name) + 1, said = strlen(doc) + 1;
    Made *made = calloc(1, sizeof *made + named + said);
    if (made == NULL) {
        return PyErr_NoMemory();
    }
    const PyUFuncGenericFunction function = (PyUFuncGenericFunction)(uintptr_t)loop;
    made->functions[0] = made->functions[1] = function;
    made->data[0] = (void *)(uintptr_t)single;
    made->data[1] = (void *)(uintptr_t)twofold;
    memset(made->types, NPY_FLOAT, operands);
    memset(made->types + operands, NPY_DOUBLE, operands);
    memcpy(made->text, name, named);
    memcpy(made->text + named, doc, said);
    return ufunc_of(made, inputs, outputs, made->text + named, signature);
}

/* What a light function points to; the function holds the capsule that holds it. */
typedef struct {
    Kernel kernel;
    PyMethodDef method;
    char text[];
} Light;

/* The names of the operands, which follow one another in `text`; whether they are as many as the loop has operands. */
static int name_operands(Kernel *kernel, PyObject *names, char *text)
{
    for (Py_ssize_t k = 0; k < PyTuple_Size(names); k++) {
        Py_ssize_t size;
        const char *name = PyUnicode_AsUTF8AndSize(PyTuple_GetItem(names, k), &size);
        if (name == NULL) {
            return 0;
        }
        memcpy(text, name, (size_t)size + 1);
        kernel->operands[k] = text;
        text += size + 1;
    }
    return 1;
}

/* How many bytes the names take; -1 with an exception set for what is no name. */
static Py_ssize_t size_of(PyObject *names)
{
    Py_ssize_t total = 0;
    for (Py_ssize_t k = 0; k < PyTuple_Size(names); k++) {
        Py_ssize_t size;
        if (PyUnicode_AsUTF8AndSize(PyTuple_GetItem(names, k), &size) == NULL) {
            return -1;
        }
        total += size + 1;
    }
    return total;
}

PyObject *chasles_make_light(PyObject *module, PyObject *arguments)
{
    const char *name, *doc;
    PyObject *names;
    unsigned long long run, single, twofold;
    (void)module;
    if (!PyArg_ParseTuple(
            arguments, "ssO!KKK:make_light", &name, &doc, &PyTuple_Type, &names, &run, &single, &twofold)) {
        return NULL;
    }
    const chasles_loop *const loops[2] = {(void *)(uintptr_t)single, (void *)(uintptr_t)twofold};
    if (run == 0 || single == 0 || twofold == 0 || loops[0]->operands > CHASLES_OPERANDS ||
        PyTuple_Size(names) != loops[0]->operands) {
        return PyErr_Format(PyExc_ValueError, "make_light: expected loops, what runs them, and a name for each operand");
    }
    const Py_ssize_t size = size_of(names);
    if (size < 0) {
        return NULL;
    }
    const size_t named = strlen(name) + 1, said = strlen(doc) + 1;
    Light *made = calloc(1, sizeof *made + (size_t)size + named + said);
    if (made == NULL) {
        return PyErr_NoMemory();
    }
    PyObject *capsule = PyCapsule_New(made, NULL, discard);
    if (capsule == NULL || !name_operands(&made->kernel, names, made->text)) {
        free(capsule == NULL ? made : NULL);
        Py_XDECREF(capsule);
        return NULL;
    }
    made->kernel.name = memcpy(made->text + size, name, named);
    made->kernel.doc = memcpy(made->text + (size_t)size + named, doc, said);
    made->kernel.loops[0] = loops[0];
    made->kernel.loops[1] = loops[1];
    made->kernel.run = (chasles_runner)(uintptr_t)run;
    PyObject *function = chasles_light_function(&made->method, capsule, &made->kernel);
    Py_DECREF(capsule);
    return function;
}
