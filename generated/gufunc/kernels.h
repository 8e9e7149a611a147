/* SPDX-License-Identifier: BSD-3-Clause */
/* Emitted by chasles 0.2.0. */
/* What the files of chasles._kernels share. Made by `chasles emit`; not to be edited by hand. */
#ifndef CHASLES_KERNELS_H
#define CHASLES_KERNELS_H

#include <pyconfig.h>

/* The stable ABI does not load in a free-threaded interpreter, which gets a build of its own. */
#if !defined(Py_LIMITED_API) && !defined(Py_GIL_DISABLED)
#define Py_LIMITED_API 0x030B0000
#endif
#include <Python.h>

#ifndef NPY_NO_DEPRECATED_API
#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#endif
#ifndef NPY_TARGET_VERSION
#define NPY_TARGET_VERSION NPY_2_0_API_VERSION
#endif
#define PY_ARRAY_UNIQUE_SYMBOL chasles_array_api
#define PY_UFUNC_UNIQUE_SYMBOL chasles_ufunc_api
#include <numpy/ndarraytypes.h>
#include <numpy/ufuncobject.h>

#include "loops.h"

/* Runs a batch of items without gaps of a loop compiled elsewhere, at the level that is best there. */
typedef void (*chasles_runner)(const chasles_loop *loop, ptrdiff_t count, char *const *at, const ptrdiff_t *steps);

/* A kernel: a loop for float32 and one for float64, and what its operands are called; `run` is NULL for those of the
 * library. `doc` begins with the call of a light function, as CPython reads it from there, and a line of two hyphens.
 */
typedef struct {
    const char *name;
    const char *signature;
    const char *doc;
    const chasles_loop *loops[2];
    const char *operands[CHASLES_OPERANDS];
    chasles_runner run;
} Kernel;

/* All kernels; one without a name is the end. */
extern const Kernel chasles_kernels[];

/* The level of the loops, chosen when the module is imported. */
extern int chasles_level;

/* A module with a light function for each kernel; NULL with an exception set where that fails. */
PyObject *chasles_light_functions(void);

/* The light function of a kernel, which the capsule holds; NULL with an exception set where that fails. */
PyObject *chasles_light_function(PyMethodDef *method, PyObject *capsule, const Kernel *kernel);

/* The light function of loops compiled elsewhere: see `methods`; NULL with an exception set where that fails. */
PyObject *chasles_make_light(PyObject *module, PyObject *arguments);

/* The ufunc of a loop compiled elsewhere: see `methods`; NULL with an exception set where that fails. */
PyObject *chasles_make_ufunc(PyObject *module, PyObject *arguments);

#endif
