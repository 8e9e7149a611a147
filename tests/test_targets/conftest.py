"""Kernels written by hand, emitted once and compiled once, for all tests of the languages."""

from __future__ import annotations

import ctypes
import math
import shutil
import subprocess
import sys
import sysconfig
from fractions import Fraction
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import numpy as np
import pytest

from chasles.lowering.program import Argument, Op, Program, Result, Step
from chasles.targets import Check, Heading, TargetKernel, discover, render, write

CC = shutil.which("gcc") or shutil.which("cc")
STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]


class Wire:
    """A step under construction; arithmetic on wires adds steps."""

    def __init__(self, line, number):
        self.line, self.number = line, number

    def __add__(self, other):
        return self.line.step(Op.ADD, self, other)

    def __radd__(self, other):
        return self.line.step(Op.ADD, other, self)

    def __sub__(self, other):
        return self.line.step(Op.SUBTRACT, self, other)

    def __rsub__(self, other):
        return self.line.step(Op.SUBTRACT, other, self)

    def __mul__(self, other):
        return self.line.step(Op.MULTIPLY, self, other)

    def __rmul__(self, other):
        return self.line.step(Op.MULTIPLY, other, self)

    def __truediv__(self, other):
        return self.line.step(Op.DIVIDE, self, other)

    def __neg__(self):
        return self.line.step(Op.NEGATE, self)


class Line:
    """A program under construction; equal steps are one."""

    def __init__(self, name, **shapes):
        self.name = name
        self.arguments = tuple(Argument(word, shape, f"the input {word}") for word, shape in shapes.items())
        self.steps = {}

    def inputs(self):
        """Each argument as a wire or a list of wires, row-major."""
        for place, argument in enumerate(self.arguments):
            wires = [
                self.add(Step(Op.INPUT, argument=place, entry=entry)) for entry in range(math.prod(argument.shape))
            ]
            yield wires if argument.shape else wires[0]

    def step(self, op, *operands):
        return self.add(Step(op, tuple(self.wire(operand).number for operand in operands)))

    def wire(self, value):
        return value if isinstance(value, Wire) else self.add(Step(Op.CONSTANT, value=Fraction(value)))

    def add(self, step):
        return Wire(self, self.steps.setdefault(step, len(self.steps)))

    def program(self, **results):
        """The program with these results: a wire, or a pair of a shape and entries."""
        made = []
        for word, value in results.items():
            shape, entries = value if isinstance(value, tuple) else ((), [value])
            numbers = tuple(self.wire(entry).number for entry in entries)
            made.append(Result(word, shape, f"the output {word}", numbers))
        return Program(self.name, self.arguments, tuple(self.steps), tuple(made))


def rotation_from_axis_angle():
    line = Line("rotation_from_axis_angle", e=(3,), phi=())
    e, phi = line.inputs()
    s, c = line.step(Op.SINE, phi), line.step(Op.COSINE, phi)
    w = [(1 - c) * x for x in e]
    a, b, d = w[0] * e[1], w[0] * e[2], w[1] * e[2]
    r = [s * x for x in e]
    entries = [c + w[0] * e[0], a - r[2], b + r[1], a + r[2], c + w[1] * e[1], d - r[0], b - r[1], d + r[0]]
    return line.program(Q=((3, 3), [*entries, c + w[2] * e[2]]))


def screw_axis_point():
    line = Line("screw_axis_point", e=(3,), phi=(), a=(3,), a_prime=(3,))
    e, phi, a, b = line.inputs()
    half = phi * Fraction(1, 2)
    cotangent = line.step(Op.COSINE, half) / line.step(Op.SINE, half)
    d, s = [y - x for x, y in zip(a, b, strict=True)], [x + y for x, y in zip(a, b, strict=True)]
    along = e[0] * s[0] + e[1] * s[1] + e[2] * s[2]
    turned = [e[1] * d[2] - e[2] * d[1], e[2] * d[0] - e[0] * d[2], e[0] * d[1] - e[1] * d[0]]
    return line.program(p_0=((3,), [(s[i] - e[i] * along + cotangent * turned[i]) / 2 for i in range(3)]))


def linear_invariants():
    line = Line("linear_invariants", Q=(3, 3))
    (q,) = line.inputs()
    axial = [(q[7] - q[5]) * Fraction(1, 2), (q[2] - q[6]) * Fraction(1, 2), (q[3] - q[1]) * Fraction(1, 2)]
    return line.program(u=((3,), axial), u_0=(q[0] + q[4] + q[8] - 1) / 2)


def plucker_line():
    line = Line("plucker_line", p_1=(3,), p_2=(3,))
    p, q = line.inputs()
    d = [y - x for x, y in zip(p, q, strict=True)]
    length = line.step(Op.SQUARE_ROOT, d[0] * d[0] + d[1] * d[1] + d[2] * d[2])
    e = [x / length for x in d]
    moment = [p[1] * e[2] - p[2] * e[1], p[2] * e[0] - p[0] * e[2], p[0] * e[1] - p[1] * e[0]]
    return line.program(kappa=((6,), [*e, *moment]))


def signed_length():
    """A select between constants, a select between numbers, and constants that no float holds."""
    line = Line("signed_length", x=(3,))
    (x,) = line.inputs()
    below = line.step(Op.LESS, x[0], 0)
    sign = line.step(Op.SELECT, below, -1, 1)
    root = line.step(Op.SQUARE_ROOT, x[0] * x[0] + x[1] * x[1] + x[2] * x[2])
    none = line.step(Op.EQUAL, root, 0)
    share = line.step(Op.SELECT, below, x[1], line.step(Op.SELECT, none, Fraction(1, 7), -x[2])) * Fraction(1, 3)
    scale = line.step(Op.SQUARE_ROOT, 2)
    return line.program(length=sign * root * scale, share=share - (-x[0]))


def awkward_names():
    line = Line("awkward_names", I=(3,), gamma=(), xp=(), out=(), count=())
    I, gamma, xp, out, count = line.inputs()
    angle = line.step(Op.ARCTANGENT2, I[0] + gamma, 2)
    t1 = line.step(Op.SINE, gamma) * line.step(Op.SINE, gamma) + angle
    return line.program(j0=((2,), [t1 * xp, t1 * (out - (count - I[2]))]), batch=angle - (-(angle - 1)))


def cross_product_matrix():
    line = Line("cross_product_matrix", v=(3,))
    (v,) = line.inputs()
    return line.program(V=((3, 3), [0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0]))


def swapped():
    line = Line("swapped", a=(3,), b=(3,), x=(), y=())
    a, b, x, y = line.inputs()
    return line.program(b_out=((3,), b), a_out=((3,), a), y_out=y, x_out=x)


def long_sum():
    line = Line("long_sum", A=(3, 3), x=(3,))
    A, x = line.inputs()
    total = line.wire(Fraction(1, 10))
    for i in range(3):
        for j in range(3):
            total = total + (A[3 * i + j] - x[i]) * (x[j] - A[3 * j + i] / Fraction(2, 3))
    return line.program(total=total)


def nested_turns():
    """Several angles, sines of what sines and arctangents give, an input that nothing reads, NaN by choice."""
    line = Line("nested_turns", angles=(3,), idle=(2,))
    a, _ = line.inputs()
    s, c = line.step(Op.SINE, a[0] * Fraction(1, 2)), line.step(Op.COSINE, a[1] - a[0])
    late = line.step(Op.COSINE, s + a[2])
    w = line.step(Op.SINE, line.step(Op.ARCTANGENT2, s, c))
    none = line.step(Op.EQUAL, a[0], 0)
    chosen = line.step(Op.SELECT, none, line.add(Step(Op.NOT_A_NUMBER)), s)
    return line.program(y=((2,), [late * w, c - late]), sine=chosen, half=Fraction(1, 2))


PROGRAMS = {
    make.__name__: make()
    for make in (
        rotation_from_axis_angle,
        screw_axis_point,
        linear_invariants,
        plucker_line,
        signed_length,
        awkward_names,
        cross_product_matrix,
        swapped,
        long_sum,
        nested_turns,
    )
}
SECTIONS = {"rotation_from_axis_angle": "s01_rotation", "screw_axis_point": "s02_screw", "plucker_line": "s02_screw"}


def checks_of(name):
    """Vectors whose outputs were found by hand."""
    F = Fraction
    sixty = (F(2, 3), F(-1, 3), F(2, 3), F(2, 3), F(2, 3), F(-1, 3), F(-1, 3), F(2, 3), F(2, 3))
    half = F(1, 2)
    return {
        "rotation_from_axis_angle": [Check(((0, 0, 1), (0,)), ((1, 0, 0, 0, 1, 0, 0, 0, 1),))],
        "linear_invariants": [Check((sixty,), ((half, half, half), (half,)))],
        "plucker_line": [
            Check(((1, 2, 3), (2, 4, 5)), ((F(1, 3), F(2, 3), F(2, 3), F(-2, 3), F(1, 3), 0),)),
            Check(((1, 2, 3), (1, 2, 3)), (("nan",) * 6,)),
        ],
        "signed_length": [
            Check(((0, 0, 0),), ((0,), (F(1, 21),))),
            Check(((-3, 0, 4),), (("-7.0710678118654752440",), (-3,))),
        ],
        "swapped": [Check(((1, 2, 3), (4, 5, 6), (7,), (8,)), ((4, 5, 6), (1, 2, 3), (8,), (7,)))],
    }.get(name, [])


def kernel_of(name):
    heading = Heading(
        number="3.18",
        says=f'What {name} is, in a sentence with 100 % of a "quotation", Plücker coordinates, a /* and a */.',
        verdict="holds under",
        hypotheses=("|e| = 1", "phi != 0"),
        derivation="0123456789abcdef" * 4,
        section=SECTIONS.get(name, "s03_invariants"),
    )
    return TargetKernel(PROGRAMS[name], heading, tuple(checks_of(name)))


def pytest_generate_tests(metafunc):
    if "name" in metafunc.fixturenames:
        metafunc.parametrize("name", PROGRAMS)


@pytest.fixture(scope="session")
def builder():
    return Line


@pytest.fixture(scope="session")
def kernels():
    return tuple(kernel_of(name) for name in PROGRAMS)


@pytest.fixture(scope="session")
def texts(kernels):
    return render(kernels, discover())


@pytest.fixture(scope="session")
def generated(texts, tmp_path_factory):
    """The folder with everything that is emitted for the kernels above."""
    root = tmp_path_factory.mktemp("emitted") / "generated"
    write(root, texts)
    return root


def run(*command, **options):
    """Run a command and show what it says where it fails."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **options)
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    return done.stdout


@pytest.fixture(scope="session")
def compile_c():
    """Runs the C compiler; the tests that ask for it are left out where there is none."""
    if CC is None:
        pytest.skip("no C compiler")
    return lambda *words: run(CC, *words)


@pytest.fixture(scope="session")
def library(generated, compile_c, tmp_path_factory):
    """The C kernels as a shared library, compiled with every warning an error."""
    out = tmp_path_factory.mktemp("library") / "libchasles.so"
    sources = sorted((generated / "c/src").glob("*.c"))
    compile_c("-std=c99", "-O2", *STRICT, "-shared", "-fPIC", f"-I{generated}/c/include", *sources, "-lm", "-o", out)
    return ctypes.CDLL(str(out))


def imported(name, path, **options):
    spec = spec_from_file_location(name, path, **options)
    module = module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


LEVELS = {
    "baseline": (),
    "x86-64-v3": ("avx2", "fma", "bmi2"),
    "x86-64-v4": ("avx512f", "avx512dq", "avx512vl", "avx512bw", "avx512cd"),
}
"""The sets of instructions for which blocks are compiled, and what a processor must say of itself to have them."""


@pytest.fixture(scope="session")
def levels():
    """The levels that this machine can run."""
    return [level for level, needs in LEVELS.items() if set(needs) <= set(_processor())]


def _processor():
    info = Path("/proc/cpuinfo")
    flags = [line for line in info.read_text().splitlines() if line.startswith("flags")] if info.exists() else []
    return flags[0].split() if flags else []


@pytest.fixture(scope="session")
def compile_levels(compile_c):
    """Compiles the C library's sources: the blocks once for each level, all else once, as the build does."""

    def objects(generated, folder, levels, *options):
        folder.mkdir(parents=True, exist_ok=True)
        made = []
        for source in sorted((generated / "c/src").glob("*.c")):
            is_blocks = source.stem.endswith("_blocks")
            for number, level in enumerate(levels if is_blocks else levels[:1]):
                target = [f"-march={level}"] if number else []
                own = ["-O3", "-fno-math-errno", "-fno-trapping-math"] if is_blocks else ["-O2"]
                own.append(f"-ffp-contract={'fast' if source.stem == 'trigonometry_blocks' else 'off'}")
                made.append(folder / f"{source.stem}.{number}.o")
                macros = [f"-DCHASLES_LEVELS={len(levels)}", f"-DCHASLES_LEVEL={number}", "-DCHASLES_STREAMS=1"]
                words = ["-std=c99", *STRICT, *own, *options, *target, *macros, f"-I{generated}/c/include", "-fPIC"]
                compile_c(*words, "-c", source, "-o", made[-1])
        return made

    return objects


@pytest.fixture(scope="session")
def objects(made_once, generated, compile_levels, levels):
    """The C library, compiled for all levels that this machine can run."""
    return sorted(made_once("emitted-objects", lambda folder: compile_levels(generated, folder, levels)).iterdir())


@pytest.fixture(scope="session")
def extension(made_once, generated, compile_c, objects, levels):
    """The file of the compiled extension module, with all levels that this machine can run."""
    headers = Path(sysconfig.get_paths()["include"])
    if not (headers / "Python.h").is_file():
        pytest.skip("no Python.h")
    folders = [f"-I{generated}/c/include", f"-I{generated}/c/src", f"-I{np.get_include()}", f"-I{headers}"]
    sources = sorted((generated / "gufunc").glob("*.c"))
    warnings = ["-std=c11", "-O2", "-Wall", "-Wextra", "-Werror", f"-DCHASLES_LEVELS={len(levels)}"]

    def link(folder):
        folder.mkdir()
        out = folder / "_kernels.abi3.so"
        compile_c(*warnings, "-shared", "-fPIC", *folders, *sources, *objects, "-lm", "-o", out)

    (out,) = made_once("emitted-extension", link).iterdir()
    return out


@pytest.fixture(scope="session")
def ufuncs(extension):
    """The compiled extension module."""
    return imported("_kernels", extension)


@pytest.fixture(scope="session")
def ufuncs_by_level(extension, levels, tmp_path_factory):
    """The compiled extension module once for each level that this machine can run."""
    modules = {}
    for level in levels:
        copy = tmp_path_factory.mktemp(level) / extension.name
        shutil.copy(extension, copy)
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("CHASLES_INSTRUCTIONS", level)
            modules[level] = imported(f"{level}._kernels", copy)
        assert modules[level].instructions == level
    return modules


@pytest.fixture(scope="session")
def functions(generated):
    """The module of array-API functions."""
    folder = generated / "numpy"
    package = imported("emitted_numpy", folder / "__init__.py", submodule_search_locations=[str(folder)])
    return imported(f"{package.__name__}.kernels", folder / "kernels.py")


@pytest.fixture(params=["ufuncs", "functions"])
def backend(request):
    """Either way to call a kernel from Python."""
    return request.getfixturevalue(request.param)


@pytest.fixture
def sample():
    """Random inputs of a kernel: `sample(name, batch, dtype)`."""
    random = np.random.default_rng(3)

    def inputs(name, batch=(), dtype=np.float64):
        shapes = [argument.shape for argument in PROGRAMS[name].arguments]
        return [np.asarray(random.uniform(-2, 2, (*batch, *shape)), dtype) for shape in shapes]

    return inputs
