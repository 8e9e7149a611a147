"""C and C++ functions of one element, bound as generalised ufuncs: the same way in for every generated peer.

The compiler may use every instruction of this machine and is told that contiguous elements lie at fixed strides and
that nothing overlaps: what is best for the peers.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sysconfig
import tempfile
from collections.abc import Sequence
from importlib.machinery import ExtensionFileLoader
from importlib.util import module_from_spec, spec_from_loader
from math import prod
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.formulas import Kernel

COMPILERS = {"c": shlex.split(os.environ.get("CC", "cc")), "cpp": shlex.split(os.environ.get("CXX", "c++"))}
for _command in COMPILERS.values():
    if shutil.which(_command[0]) is None:
        raise ImportError(f"there is no compiler {_command[0]!r} here")
if not (Path(sysconfig.get_path("include")) / "Python.h").exists():
    raise ImportError("there is no Python.h here")

FLAGS = ("-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math", "-fPIC", "-shared", "-w")
HEAD = """
#define PY_SSIZE_T_CLEAN
#include <Python.h>
#include <numpy/arrayobject.h>
#include <numpy/ufuncobject.h>
#include <math.h>
#ifdef __cplusplus
#include <cmath>
#endif
"""
LOOP = """
static inline __attribute__((always_inline)) void {name}_run(char **p, npy_intp n, {strides})
{{
    for (npy_intp i = 0; i < n; i++) {{
        {inputs}
        double *__restrict__ y = (double *)(p[{count}] + i * s{count});
        {call}
    }}
}}
static void {name}_loop(char **p, const npy_intp *n, const npy_intp *s, void *none)
{{
    if ({contiguous}) {name}_run(p, n[0], {sizes});
    else {name}_run(p, n[0], {steps});
}}
static PyUFuncGenericFunction {name}_loops[1] = {{{name}_loop}};
static char {name}_types[{total}] = {{{types}}};
"""
MODULE = """
static struct PyModuleDef def = {{PyModuleDef_HEAD_INIT, "{module}", 0, -1}};
PyMODINIT_FUNC PyInit_{module}(void)
{{
    static void *data[1] = {{0}};
    PyObject *made = PyModule_Create(&def);
    import_array();
    import_umath();
    {adding}
    return made;
}}
"""
ADD = """PyModule_AddObject(made, "{name}", PyUFunc_FromFuncAndDataAndSignature({name}_loops, data, {name}_types, 1,
        {count}, 1, PyUFunc_None, "{name}", "", 0, "{signature}"));"""


def bind(module: str, kernels: Sequence[Kernel], text: str, calls: dict[str, str], cxx: bool = False) -> dict[str, Any]:
    """A ufunc for each kernel; a call reads the arrays `x0`, `x1`, ... and writes `y`."""
    loops = "".join(loop(kernel, calls[kernel.name]) for kernel in kernels)
    adding = "\n    ".join(ADD.format(name=k.name, count=len(k.inputs), signature=k.signature) for k in kernels)
    source = HEAD + text + loops + MODULE.format(module=module, adding=adding)
    suffix = "cpp" if cxx else "c"
    with tempfile.TemporaryDirectory() as folder:
        file, library = Path(folder) / f"peer.{suffix}", Path(folder) / f"{module}.so"
        file.write_text(source, "utf-8")
        include = (f"-I{sysconfig.get_path('include')}", f"-I{np.get_include()}")
        subprocess.run([*COMPILERS[suffix], *FLAGS, *include, str(file), "-o", str(library), "-lm"], check=True)
        loader = ExtensionFileLoader(module, str(library))
        spec = spec_from_loader(module, loader)
        assert spec is not None
        found = module_from_spec(spec)
        loader.exec_module(found)
    return {kernel.name: getattr(found, kernel.name) for kernel in kernels}


def loop(kernel: Kernel, call: str) -> str:
    """The text of a kernel's loop."""
    count = len(kernel.inputs)
    sizes = [8 * prod(shape) for shape in (*kernel.inputs.values(), kernel.output)]
    return LOOP.format(
        name=kernel.name,
        call=call,
        count=count,
        total=count + 1,
        types=", ".join(["NPY_DOUBLE"] * (count + 1)),
        strides=", ".join(f"npy_intp s{i}" for i in range(count + 1)),
        steps=", ".join(f"s[{i}]" for i in range(count + 1)),
        sizes=", ".join(map(str, sizes)),
        contiguous=" && ".join(f"s[{i}] == {size}" for i, size in enumerate(sizes)),
        inputs="\n        ".join(
            f"const double *__restrict__ x{i} = (const double *)(p[{i}] + i * s{i});" for i in range(count)
        ),
    )


def entries(kernel: Kernel) -> list[str]:
    """How each entry of each input is read in C."""
    return [f"x{i}[{j}]" for i, shape in enumerate(kernel.inputs.values()) for j in range(prod(shape))]


def operations(text: str) -> int:
    """Additions, subtractions, products, quotients and calls in C text; sine, cosine and signs are not counted."""
    body = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.DOTALL)
    body = re.sub(r"\w+\* const \w+ = nullptr", "", body)
    body = re.sub(r"(?:Scalar|static_cast<Scalar>)\(([\d.]+)\)", r"\1", body)
    body = re.sub(r"\b\d+\.?\d*\s*/\s*\d+\.?\d*\b|\d\.?\d*[eE][-+]\d+", "1", body)
    lines = [statement.partition("=")[2] for statement in re.split(r"[;{}]", body) if "=" in statement]
    right = ";".join(re.sub(r"^\s*=.*", "", line) for line in lines)
    binary = len(re.findall(r"[\w.)\]]\s*[-+*/](?!=)", right))
    return binary + len(re.findall(r"\b(?:pow|sqrt|fabs|tan|atan2)\s*\(", right))
