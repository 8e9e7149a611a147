/* Ufuncs over loops that were compiled elsewhere. Made by `chasles emit`; not to be edited by hand.
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
