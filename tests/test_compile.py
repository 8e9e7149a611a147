"""What `chasles.compile` makes of a user's SymPy expressions: values, shapes, the cache, the fallback, the errors."""

from __future__ import annotations

import gc
import math
import os
import pickle
import shutil
import signal
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from time import sleep

import numpy as np
import pytest
import sympy as sp

import chasles
from chasles import kernels
from chasles.compiling import LoweringError, compiler, depth, inputs, store
from chasles.kernels import chapter

from .sampling import WHOLE

x, y, z = sp.symbols("x y z")
X = sp.MatrixSymbol("X", 3, 3)
v = sp.Matrix(sp.symbols("v1:4"))

needs_c = pytest.mark.skipif(
    kernels.backend != "c" or shutil.which("cc") is None, reason="needs the extension and a C compiler"
)


@pytest.fixture(scope="module", autouse=True)
def cache(tmp_path_factory):
    folder = tmp_path_factory.mktemp("cache")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CHASLES_CACHE", str(folder))
        yield folder


@pytest.fixture
def empty_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("CHASLES_CACHE", str(tmp_path))
    monkeypatch.setattr(store, "_loaded", {})
    return tmp_path / "compiled"


@pytest.fixture(autouse=True)
def hastily(request, monkeypatch):
    """Some tests are of loops for this machine, optimised; all else is compiled for one set, as it stands."""
    optimised = (
        test_values_are_those_of_lambdify,
        test_pieces_that_share_conditions_and_terms,
        test_what_knows_no_expression_came_along_for_machines_of_any_level,
        test_what_knows_no_expression_is_compiled_once,
        test_other_levels_are_compiled_when_asked_for,
    )
    if not WHOLE and request.function not in optimised:
        monkeypatch.setenv("CHASLES_INSTRUCTIONS", "baseline")
        monkeypatch.setattr(kernels, "instructions", "baseline")
        monkeypatch.setattr(compiler, "_ONCE", ("-O0",))
        monkeypatch.setattr(compiler, "_BLOCK", ("-O0", "-fno-trapping-math"))


@pytest.fixture(params=[pytest.param("c", marks=needs_c), "numpy"])
def backend(request, monkeypatch):
    """Everything is to hold of the compiled kernels and of those where there is no compiler."""
    if request.param == "numpy":
        monkeypatch.setenv("CC", "no-such-compiler")
    return request.param


@pytest.fixture
def draw():
    return np.random.default_rng(20).uniform


EXPRESSIONS = [
    (x + 2 * y - z / 3, "sum"),
    (x * y / (1 + z**2) - sp.Rational(2, 7) * x**3, "fraction"),
    (sp.sqrt(x**2 + y**2 + 1) ** 3 / sp.sqrt(2 + z**2), "half powers"),
    (sp.sin(x) * sp.cos(y) + sp.tan(z / 2), "trigonometry"),
    (sp.atan2(y, x) + sp.atan(z) + sp.asin(x / 4) - sp.acos(y / 4), "arctangents"),
    (sp.Abs(x) + sp.sign(y) * sp.Max(x, y, z) - sp.Min(x, y, 1), "choices"),
    (sp.pi * x + sp.sqrt(2) * y + sp.Float("0.1") * z + sp.exp(1), "constants"),
    (x**7 - y ** (-3) + z ** sp.Integer(2) / y ** sp.Rational(2), "powers"),
    (
        sp.Piecewise((x, x < -1), (y, x <= 0), (z, sp.And(x > 1, y > 0)), (x * y, sp.Or(y > 1, z >= 1)), (-1, True)),
        "if",
    ),
    (sp.Piecewise((x, sp.Not(sp.And(sp.Ne(x, 1), x < y))), (y, True)), "not"),
    (sp.Piecewise((x, sp.ITE(x < y, y > z, z < 0)), (y, True)), "if in if"),
    (sp.cot(1 + x**2 / 9) + sp.sec(y / 4) * sp.csc(2 + z / 5) + sp.sinc(x) + sp.sinc(0 * y), "reciprocals"),
    (sp.sqrt(x**2 + 1) ** sp.Float(3.0) + (y**2 + 1) ** sp.Float(-0.5), "powers that are floats"),
]


@pytest.mark.sampled(2)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_values_are_those_of_lambdify(dtype, backend, draw):
    points = [draw(-3, 3, 200).astype(dtype) for _ in range(3)]
    kernel = chasles.compile([expression for expression, _ in EXPRESSIONS], (x, y, z))
    assert kernel.backend == backend
    eps = np.finfo(dtype).eps
    for found, (expression, said) in zip(kernel(*points), EXPRESSIONS, strict=True):
        expected = sp.lambdify((x, y, z), expression, "numpy")(*(p.astype(np.float64) for p in points))
        assert found.dtype == dtype
        scale = 30 + np.abs(expected).max()
        np.testing.assert_allclose(found, expected, rtol=64 * eps, atol=16 * scale * eps, err_msg=said)


def test_a_matrix_with_constant_entries_broadcasts(backend, draw):
    turn = sp.Matrix([[sp.cos(x), -sp.sin(x), 0], [sp.sin(x), sp.cos(x), 0], [0, 0, 1]])
    kernel = chasles.compile(turn * y, (x, y), name="turn")
    assert kernel.signature == "(),()->(3,3)"
    angles, sizes = draw(-3, 3, (5, 1)), draw(1, 2, 4)
    found = kernel(angles, sizes)
    assert found.shape == (5, 4, 3, 3)
    exact = sp.lambdify((x, y), turn * y)
    for i, j in np.ndindex(5, 4):
        np.testing.assert_allclose(found[i, j], exact(angles[i, 0], sizes[j]), rtol=1e-14, atol=1e-15)


def test_a_constant_has_the_shape_of_the_batch(backend):
    assert chasles.compile([sp.Integer(3), sp.eye(2)], x)(np.zeros(4))[1].shape == (4, 2, 2)


def test_several_outputs_and_matrix_inputs(backend, draw):
    kernel = chasles.compile(
        [X * v, (v.T * X * v)[0, 0], X.T, sp.Trace(X)], {"A": X, "p": v}, outputs=("image", "form", "turned", "trace")
    )
    assert kernel.signature == "(3,3),(3)->(3),(),(3,3),()"
    A, p = draw(-1, 1, (6, 3, 3)), draw(-1, 1, (2, 1, 3))
    image, form, turned, trace = kernel(A, p)
    np.testing.assert_allclose(image, (A @ p[..., None])[..., 0], atol=1e-14)
    np.testing.assert_allclose(
        form, np.einsum("abi,bij,abj->ab", np.broadcast_to(p, (2, 6, 3)), A, np.broadcast_to(p, (2, 6, 3))), atol=1e-14
    )
    np.testing.assert_array_equal(turned, np.broadcast_to(np.swapaxes(A, -1, -2), (2, 6, 3, 3)))
    np.testing.assert_allclose(trace, np.broadcast_to(np.trace(A, axis1=1, axis2=2), (2, 6)), atol=1e-14)


def test_a_piece_that_is_not_taken_says_nothing(backend):
    sinc = chasles.compile(sp.Piecewise((sp.sin(x) / x, sp.Ne(x, 0)), (1, True)), x)
    np.testing.assert_array_equal(sinc([0.0, -0.0, 1e-300]), 1.0)


def test_a_piecewise_is_as_in_c_at_nan_and_where_no_piece_applies(backend):
    kernel = chasles.compile(sp.Piecewise((1, x < 0), (2, x > 0)), x)
    with np.errstate(invalid="ignore"):
        np.testing.assert_array_equal(kernel([-1.0, 3.0, 0.0, np.nan]), [1, 2, np.nan, np.nan])
        either = chasles.compile([sp.Max(x, y), sp.Min(x, y), sp.Abs(x), sp.sign(x)], (x, y))
        for result in either([np.nan], [1.0]):
            assert np.isnan(result).all()
        assert np.isnan(either([1.0], [np.nan])[0]).all()


def test_pieces_that_share_conditions_and_terms(backend, draw):
    inside = sp.And(x**2 + y**2 < z, sp.Or(x > y, sp.Eq(y, z)))
    first = sp.Piecewise((sp.sqrt(x**2 + y**2), inside), (x + y, x**2 + y**2 < z), (z, True))
    second = sp.Piecewise((first, sp.Not(inside)), (2 * (x + y), True))
    points = draw(-1.5, 1.5, (3, 300))
    found = chasles.compile([first, second], (x, y, z))(*points)
    for values, expression in zip(found, (first, second), strict=True):
        expected = [float(expression.subs(dict(zip((x, y, z), point, strict=True)))) for point in points.T[:40]]
        np.testing.assert_allclose(values[:40], expected, rtol=1e-14)


def test_what_is_divided_by_zero_is_not_a_number(backend):
    with np.errstate(all="ignore"):
        assert np.isnan(chasles.compile(1 / (1 + 1 / x), x)(0.0))


JACOBIANS = [
    [x * sp.sin(y) / sp.sqrt(1 + z**2), sp.atan2(x, 2 + z**2)],
    [sp.Matrix([x**2 * y, sp.tan(y * z) - z])],
    [sp.Matrix([[x, sp.Abs(y)], [sp.Max(x, z), sp.Piecewise((x * y, z > 0), (y**2, True))]])],
]


@pytest.mark.sampled(2)
@pytest.mark.parametrize("expressions", JACOBIANS)
def test_derivatives_are_those_of_sympy(expressions, backend, draw):
    kernel = chasles.compile(expressions, (x, y, z), jacobian=True)
    points = draw(0.1, 1.2, (3, 20)) * np.where(draw(-1, 1, (3, 20)) < 0, -1, 1)
    found = kernel(*points)
    for expression, jacobian in zip(expressions, found[len(expressions) :], strict=True):
        entries = list(expression) if isinstance(expression, sp.MatrixBase) else [expression]
        for column in range(20):
            at = {s: sp.Float(float(value), 30) for s, value in zip((x, y, z), points[:, column], strict=True)}
            expected = np.array([[_slope(e, s, at) for s in (x, y, z)] for e in entries])
            np.testing.assert_allclose(jacobian[column].reshape(expected.shape), expected, rtol=1e-13, atol=1e-13)


def _slope(expression, symbol, at):
    """By a central difference of 30 digits."""
    step = sp.Float("1e-9", 30)
    up, down = (expression.subs({**at, symbol: at[symbol] + s}).evalf(30) for s in (step, -step))
    return float((up - down) / (2 * step))


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("expression", "inputs", "signature"),
    [
        (x**2, x, "()->(),()"),
        (x**2, (x, y), "(),()->(),(2)"),
        (v, [v], "(3)->(3),(3,3)"),
        (v.dot(v), [v], "(3)->(),(3)"),
        (X, [X], "(3,3)->(3,3),(9,9)"),
    ],
)
def test_shapes_of_jacobians(expression, inputs, signature, backend):
    assert chasles.compile(expression, inputs, jacobian=True).signature == signature


@needs_c
def test_it_is_a_ufunc():
    kernel = chasles.compile(sp.Matrix([x, y]), (x, y), name="pair")
    assert isinstance(kernel.ufunc, np.ufunc)
    assert kernel.ufunc.types == ["ff->f", "dd->d"]
    out = np.empty((3, 2))
    assert kernel([1, 2, 3], 4, out=out) is out
    np.testing.assert_array_equal(kernel([1, 2, 3], 4, axes=[(), (), (0,)]), out.T)
    with pytest.raises(ValueError, match="mismatch"):
        chasles.compile(v, [v])(np.zeros(4))


def test_one_is_the_same_for_an_element_or_a_batch(backend, draw):
    kernel = chasles.compile([v * x, v.dot(v)], (v, x), outputs=("scaled", "square"))
    vectors, factors = draw(-1, 1, (7, 3)), draw(-1, 1, 7)
    for given in ((vectors, factors), (vectors[0], 2.0), (vectors.astype(np.float32), factors.astype(np.float32))):
        for found, wanted in zip(kernel.one(*given), kernel(*given), strict=True):
            np.testing.assert_array_equal(found, wanted)
            assert found.dtype == wanted.dtype


@needs_c
def test_one_takes_what_it_takes_and_says_what_not():
    kernel = chasles.compile(v * x, (v, x), outputs="scaled", name="stretched")
    out = np.empty((2, 3))
    assert kernel.one(np.ones((2, 3)), 4.0, out=out) is out
    assert (out == 4).all()
    with pytest.raises(TypeError, match=r"one\.stretched: v must be a NumPy array"):
        kernel.one([1.0, 2.0, 3.0], 4.0)
    with pytest.raises(TypeError, match="takes 2 inputs"):
        kernel.one(1.0)
    large = np.ones((1000, 3))
    assert kernel.one(large, 2.0, out=large) is large
    assert (large == 2).all()
    for _ in range(50):
        light = chasles.compile(x + 1, x).one
        assert light(1.0) == 2.0
        del light


@needs_c
def test_ufuncs_are_freed_with_what_they_point_to():
    for _ in range(50):
        ufunc = chasles.compile(x + 1, x).ufunc
        assert ufunc(1.0) == 2.0
        del ufunc


def test_a_kernel_travels(backend):
    kernel = pickle.loads(pickle.dumps(chasles.compile(x * y, (x, y), name="product")))
    assert kernel(2.0, 3.0) == 6.0
    assert kernel.name == "product"


@needs_c
def test_the_c_source_stands_alone(tmp_path):
    kernel = chasles.compile([sp.Matrix([x, x / y]), sp.Piecewise((1, x > 0))], (x, y), name="two")
    (tmp_path / "two.c").write_text(kernel.c_source)
    flags = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror", "-c"]
    subprocess.run(["cc", *flags, "two.c", "-o", "two.o"], cwd=tmp_path, check=True)


def test_the_numpy_source_stands_alone():
    kernel = chasles.compile(sp.Matrix([x, 1]), x, name="column")
    names: dict[str, object] = {}
    exec(kernel.numpy_source, names)
    np.testing.assert_array_equal(names["column"](np.arange(2.0)), [[0, 1], [1, 1]])


def test_operations_are_counted_and_shared():
    first = sp.sin(x + y) * (x + y) + z
    kernel = chasles.compile([first, first**2], (x, y, z))
    assert kernel.operations == {"add": 2, "multiply": 2, "sine": 1}


def test_names_of_the_users_are_never_in_the_way(backend):
    words = ("at", "steps", "g", "groups", "item0", "LANES", "sines", "loop", "xp", "double", "k", "step0", "prepared")
    symbols = sp.symbols(words)
    kernel = chasles.compile(sum(map(sp.sin, symbols)), symbols, outputs="batch")
    assert kernel.backend == backend
    assert kernel(*range(len(words))) == pytest.approx(np.sin(range(len(words))).sum(), rel=1e-14)


def test_symbols_of_one_name_are_told_apart():
    positive = sp.Symbol("x", positive=True)
    assert chasles.compile(x - positive, (x, positive))(5.0, 1.0) == 4.0
    assert chasles.compile(positive, x)(2.0) == 2.0
    with pytest.raises(LoweringError, match="x is the name of variables that differ only in their assumptions"):
        chasles.compile(x + positive, x)


def test_symbols_of_any_name_go_in(backend):
    words = ("I", "E", "lambda", "class", "alpha", "my x", "x'", r"\dot{q}_1", "ω", "result")
    symbols = [sp.Symbol(word) for word in words]
    kernel = chasles.compile(sum(k * symbol for k, symbol in enumerate(symbols, 1)), symbols)
    assert kernel(*range(len(words))) == sum((k + 1) * k for k in range(len(words)))


def test_indexed_symbols_go_in(backend):
    a = sp.IndexedBase("a")
    assert chasles.compile(a[0] + 2 * a[1], (a[0], a[1]))(1.0, 2.0) == 5.0
    assert chasles.compile(a[0] + 2 * a[1], {"a": [a[0], a[1]]})([1.0, 2.0]) == 5.0
    with pytest.raises(LoweringError, match=r"a\[2\]"):
        chasles.compile(a[2], (a[0], a[1]))


def test_latex_and_unicode_names_are_made_plain(backend):
    phi, psi = sp.Symbol(r"\phi'"), sp.Symbol("ψ")
    assert chasles.compile(phi - psi, (phi, psi))(3.0, 2.0) == 1.0


REFUSED = [
    (lambda: chasles.compile(sp.DiracDelta(x), x), r"DiracDelta\(x\) \(DiracDelta\); it computes"),
    (lambda: chasles.compile(sp.mathieus(1, 2, x), x), r"mathieus\(1, 2, x\) \(mathieus\)"),
    (
        lambda: chasles.compile(sp.Max(x, y + sp.asin(2, evaluate=False)), (x, y)),
        "no value for real inputs|no finite real",
    ),
    (lambda: chasles.compile(sp.Function("f")(x), x), r"f\(x\) in f\(x\) is not among the inputs"),
    (lambda: chasles.compile(sp.Integral(sp.sin(x), (x, 0, y)), [x, y]), r"call \.doit\(\)"),
    (lambda: chasles.compile(sp.Sum(x**y, (y, 0, sp.oo)), x), r"call \.doit\(\)"),
    (lambda: chasles.compile(x, {x: "y"}), "x, which is no name"),
    (lambda: chasles.compile([[x, "y"]], x), "is a text"),
    (lambda: chasles.compile([[x, [x]]], x), "no array of expressions"),
    (lambda: chasles.compile(x + y, x), "y in x [+] y is not among the inputs"),
    (lambda: chasles.compile(X * v, [v]), "X in .* is not among the inputs"),
    (lambda: chasles.compile(x + sp.I, x), "no finite real number"),
    *(
        (lambda e=e: chasles.compile(e, x), "no finite real number")
        for e in (x**sp.I, sp.sin(x) ** sp.cbrt(-5), 2 / x**sp.I)
    ),
    (lambda: chasles.compile(x + sp.oo, x), "no finite real number|not among|no program"),
    (lambda: chasles.compile(sp.Contains(x, sp.ImageSet(sp.Lambda(y, y**2), sp.S.Naturals)), x), "condition"),
    (lambda: chasles.compile(sp.MatrixSymbol("Y", sp.Symbol("n"), 2), x), "extents must be numbers"),
    (lambda: chasles.compile(sp.Matrix(0, 3, []), x), "no entries"),
    (lambda: chasles.compile("x", x), "is a text"),
    (lambda: chasles.compile(object(), x), "no SymPy expression"),
    (lambda: chasles.compile([], x), "nothing to compile"),
    (lambda: chasles.compile(x, []), "inputs is empty"),
    (lambda: chasles.compile(x, "x"), "inputs must be symbols"),
    (lambda: chasles.compile(x - y, {x, y}), "inputs is a set, which has no order"),
    (lambda: chasles.compile([x, y], [x, y], outputs={"a", "b"}), "outputs is a set"),
    (lambda: chasles.compile(x, x + 1), "is none"),
    (lambda: chasles.compile(x, (x, sp.Matrix([x, y]))), "x comes twice"),
    (lambda: chasles.compile([x, x], x, outputs=("a",)), "names 1 results, and there are 2"),
    (lambda: chasles.compile([x, x], x, outputs=("a", "a")), "one name"),
    (lambda: chasles.compile(x, x, outputs="a b"), "cannot be a name"),
    (lambda: chasles.compile(x, x, name="lambda"), "cannot be a name"),
    (lambda: chasles.compile(x, x, name="run"), "cannot be called"),
    (lambda: chasles.compile(x / (y - y + 0 * y), (x, y)), "no finite real number|zero by construction|no program"),
    (lambda: chasles.compile(x + sp.Rational(1, 10**320), x), "range of double"),
    (lambda: chasles.compile(x * sp.exp(800), x), "range of double"),
    (lambda: chasles.compile(x + 10**400, x), "range of double"),
]


@pytest.mark.parametrize("number", range(len(REFUSED)))
def test_what_is_refused_is_named(number):
    wrong, said = REFUSED[number]
    with pytest.raises(LoweringError, match=said) as caught:
        wrong()
    assert "Traceback" not in str(caught.value)


def test_more_numbers_than_a_batch_takes_are_refused_before_they_are_looked_at(monkeypatch):
    monkeypatch.setattr(inputs, "MOST_ENTRIES", 100)
    monkeypatch.setattr(sp.MatrixSymbol, "as_explicit", None)
    w = sp.Matrix(sp.symbols("w1:11"))
    for wrong in (
        lambda: chasles.compile(x, (x, sp.MatrixSymbol("Y", 10, 11))),
        lambda: chasles.compile(x, (x, sp.IndexedBase("Y", shape=(10, 11)))),
        lambda: chasles.compile(sp.Matrix(10, 10, [x] * 100), [x]),
        lambda: chasles.compile(w * w[0], {"w": w}, jacobian=True),
        lambda: chasles.compile(x, sp.symbols("x:101")),
    ):
        with pytest.raises(LoweringError, match="numbers go in and come out, and a kernel has at most 100: split it"):
            wrong()


def nested(depth):
    """A sine of a sine of a sine..."""
    with sp.evaluate(False):
        expression = x
        for _ in range(depth):
            expression = sp.sin(expression) + x
    return expression


def test_expressions_deeper_than_pythons_stack_compile(monkeypatch):
    value = 0.3
    for _ in range(1500):
        value = math.sin(value) + 0.3
    limit = sys.getrecursionlimit()
    assert chasles.compile(nested(1500), [x])(0.3) == pytest.approx(value, rel=1e-13)
    assert sys.getrecursionlimit() == limit
    monkeypatch.setattr(depth, "CALLS", limit)
    with pytest.raises(LoweringError, match="nested too deeply"):
        chasles.compile(nested(2000), [x])


@pytest.fixture
def commands(monkeypatch):
    """What is compiled, and for which level."""
    ran = []
    run = compiler._run

    def noted(command, *rest):
        ran.append(" ".join(word for word in command if word.endswith(".c") or word.startswith("-DCHASLES_LEVEL=")))
        return run(command, *rest)

    monkeypatch.setattr(compiler, "_run", noted)
    return ran


@needs_c
@pytest.mark.parametrize("levels", ["own", "all"])
@pytest.mark.parametrize("instructions", ["baseline", "x86-64-v3", "x86-64-v4"])
def test_what_knows_no_expression_came_along_for_machines_of_any_level(
    instructions, levels, empty_cache, commands, monkeypatch
):
    if not (Path(find_spec("chasles._kernels").origin).parent / "objects").is_dir():
        pytest.skip("the installation brought no objects")
    runs_here = chapter.LEVELS.index(instructions) <= chapter.LEVELS.index(kernels.instructions)
    monkeypatch.setattr(kernels, "instructions", instructions)
    kernel = chasles.compile(sp.sin(x) * y + sp.atan2(x, y) + 18, (x, y), levels=levels)
    # If what is compiled is another text than what was emitted: install again.
    assert not any("batches.c" in command or "trigonometry" in command for command in commands)
    assert any("expression_blocks.c" in command for command in commands)
    if runs_here or levels == "all":
        at = np.random.default_rng(1).uniform(-9, 9, (2, 77))
        np.testing.assert_allclose(kernel(*at), np.sin(at[0]) * at[1] + np.arctan2(*at) + 18, rtol=1e-14)


@needs_c
def test_what_knows_no_expression_is_compiled_once(empty_cache, commands, monkeypatch, tmp_path):
    monkeypatch.setattr(compiler, "_ready", lambda *_: tmp_path)

    def compiled(expression):
        commands.clear()
        chasles.compile(expression, (x, y))(1.0, 1.0)
        return [command.split("/")[-1] for command in commands if "batches.c" in command or "trigonometry" in command]

    assert compiled(x * y + 11) == ["batches.c"]
    assert compiled(x * y + 12) == []
    assert compiled(sp.sin(x) * y + 13) == ["trigonometry_blocks.c"]
    assert compiled(sp.atan2(x, y) + 14) == compiled(x * sp.cos(sp.sin(y)) + 15) == []
    for path in empty_cache.glob("*.o"):
        path.write_bytes(path.read_bytes()[:-1] + b"?")
    assert len(compiled(sp.cos(y) + 16)) == 2


@needs_c
def test_other_levels_are_compiled_when_asked_for(empty_cache, commands):
    own = chasles.compile(sp.sin(x) * y + 17, (x, y))
    assert not any("LEVEL=0" in command for command in commands) or chasles.kernels.instructions == "baseline"
    every = chasles.compile(sp.sin(x) * y + 17, (x, y), levels="all")
    assert any("LEVEL=0" in command for command in commands)
    at = np.random.default_rng(1).uniform(-9, 9, (2, 77))
    assert (own(*at) == every(*at)).all()
    with pytest.raises(LoweringError, match="levels must be"):
        chasles.compile(x, x, levels="most")


SCRIPT = """
import sys
from chasles.compiling import compiler
ran = []
made = compiler.Compiler.shared_object
compiler.Compiler.shared_object = lambda self, *rest: ran.append(1) or made(self, *rest)
import sympy, chasles
x, y = sympy.symbols("x y")
kernel = chasles.compile(sympy.sin(x) * y + 1, (x, y))
assert kernel.backend == "c"
print(len(ran), kernel(0.5, 2.0))
"""


def started(folder: Path) -> subprocess.Popen[str]:
    environment = os.environ | {"CHASLES_CACHE": str(folder)}
    return subprocess.Popen([sys.executable, "-c", SCRIPT], env=environment, stdout=subprocess.PIPE, text=True)


def ended(process: subprocess.Popen[str]) -> tuple[int, float]:
    text, _ = process.communicate()
    assert process.returncode == 0
    ran, value = text.split()
    return int(ran), float(value)


@pytest.fixture
def compilations(monkeypatch):
    ran = []
    made = compiler.Compiler.shared_object

    def counted(self, *rest):
        ran.append(rest)
        return made(self, *rest)

    monkeypatch.setattr(compiler.Compiler, "shared_object", counted)
    return ran


@needs_c
def test_it_is_compiled_once(empty_cache, compilations, monkeypatch):
    for _ in range(2):
        assert chasles.compile(x * y + 7, (x, y))(2.0, 3.0) == 13.0
    monkeypatch.setattr(store, "_loaded", {})
    assert chasles.compile(x * y + 7, (x, y))(2.0, 3.0) == 13.0
    assert len(compilations) == 1
    assert chasles.compile(x * y + 8, (x, y))(2.0, 3.0) == 14.0
    assert len(compilations) == 2


@needs_c
@pytest.mark.slow
def test_processes_at_once_and_one_after_another(tmp_path):
    value = 2 * np.sin(0.5) + 1
    both = [ended(process) for process in [started(tmp_path), started(tmp_path)]]
    assert [found for _, found in both] == pytest.approx([value, value], rel=1e-15)
    assert ended(started(tmp_path)) == (0, both[0][1])
    assert not list(tmp_path.rglob("*.part"))


@pytest.mark.sampled(2)
@needs_c
@pytest.mark.parametrize("harm", ["truncated", "changed", "removed", "index", "index of nothing", "half-written"])
def test_a_harmed_cache_is_made_anew(harm, empty_cache, compilations, monkeypatch):
    assert chasles.compile(x - 3 * y, (x, y))(2.0, 3.0) == -7.0
    [index], [made] = empty_cache.glob("*.index"), empty_cache.glob("*.so")
    content = made.read_bytes()
    match harm:
        case "truncated":
            made.unlink()
            made.write_bytes(content[: len(content) // 2])
        case "changed":
            made.unlink()
            made.write_bytes(content.replace(b"chasles", b"selsahc"))
        case "removed":
            made.unlink()
        case "index":
            index.write_bytes(b"\xff\x00/../x")
        case "index of nothing":
            index.write_text("0" * 64)
        case "half-written":
            index.unlink()
            (empty_cache / "killed.part").write_bytes(content[:100])
            os.utime(empty_cache / "killed.part", (0, 0))
    monkeypatch.setattr(store, "_loaded", {})
    assert chasles.compile(x - 3 * y, (x, y))(2.0, 3.0) == -7.0
    assert len(compilations) == 2
    assert not list(empty_cache.glob("*.part"))
    monkeypatch.setattr(store, "_loaded", {})
    assert chasles.compile(x - 3 * y, (x, y))(2.0, 3.0) == -7.0
    assert len(compilations) == 2


@needs_c
def test_what_was_not_used_for_longest_goes_when_there_is_too_much(empty_cache, compilations, monkeypatch):
    def compiled(number):
        monkeypatch.setattr(store, "_loaded", {})
        assert chasles.compile(x + 100 * y + number, (x, y))(1.0, 1.0) == 101.0 + number

    for number in (1, 2):
        compiled(number)
    first, second = sorted(empty_cache.glob("*.so"), key=lambda path: path.stat().st_mtime_ns)
    for age, path in ((200, first), (100, second)):
        os.utime(path, (path.stat().st_mtime - age,) * 2)
    compiled(1)
    monkeypatch.setattr(store, "MOST", 2 * max(first.stat().st_size, second.stat().st_size) + 100)
    compiled(3)
    assert len(compilations) == 3
    assert first.exists()
    assert not second.exists()
    assert len(list(empty_cache.glob("*.so"))) == len(list(empty_cache.glob("*.index"))) == 2
    compiled(1)
    compiled(2)
    assert len(compilations) == 4


@needs_c
@pytest.mark.parametrize("place", ["", "/proc/nowhere"])
def test_without_a_cache_it_compiles_all_the_same(place, empty_cache, compilations, monkeypatch):
    monkeypatch.setenv("CHASLES_CACHE", place)
    kernel = chasles.compile(x + 5 * y, (x, y))
    assert kernel.backend == "c"
    assert kernel(2.0, 3.0) == 17.0
    assert len(compilations) == 1


@needs_c
def test_a_compiler_that_fails_is_warned_of(empty_cache, tmp_path, monkeypatch):
    broken = tmp_path / "broken"
    broken.write_text('#!/bin/sh\n[ "$1" = --version ] && echo broken 1.0 || { echo "error: no" >&2; exit 1; }\n')
    broken.chmod(0o755)
    monkeypatch.setenv("CC", str(broken))
    with pytest.warns(RuntimeWarning, match="could not be compiled.*error: no"):
        kernel = chasles.compile(x + 9 * y, (x, y))
    assert kernel.backend == "numpy"
    assert kernel(2.0, 3.0) == 29.0
    assert not list(empty_cache.glob("*.index"))


@needs_c
@pytest.mark.parametrize("endless", ["while :; do :; done", "sh -c 'while :; do :; done'; exit $?", "CPU"])
def test_a_compiler_without_end_is_ended(endless, tmp_path, monkeypatch):
    """After so much processor time, also where the work is done by a process below it."""
    if endless == "CPU":
        endless = "echo 'gcc: fatal error: CPU time limit exceeded signal terminated program cc1' >&2; exit 4"
    script = tmp_path / "endless"
    script.write_text(f"#!/bin/sh\n{endless}\n")
    script.chmod(0o755)
    monkeypatch.setattr(compiler, "_PATIENCE", 1)
    with pytest.raises(compiler.CompilerFailed, match=r"endless -c x\.c: .*stopped after 1 seconds of processor time"):
        compiler._run((str(script), "-c", "x.c"))


@needs_c
@pytest.mark.slow
def test_a_killed_compilation_leaves_nothing_that_is_believed(tmp_path):
    slow = tmp_path / "slow"
    slow.write_text(f'#!/bin/sh\n[ "$1" = --version ] && exec cc --version\ntouch {tmp_path}/begun\nexec sleep 60\n')
    slow.chmod(0o755)
    environment = os.environ | {"CHASLES_CACHE": str(tmp_path / "cache"), "CC": str(slow), "TMPDIR": str(tmp_path)}
    process = subprocess.Popen([sys.executable, "-c", SCRIPT], env=environment, start_new_session=True)
    while not (tmp_path / "begun").exists() and process.poll() is None:
        sleep(0.05)
    os.killpg(process.pid, signal.SIGKILL)
    assert process.wait() == -signal.SIGKILL
    assert ended(started(tmp_path / "cache"))[0] == 1
    assert ended(started(tmp_path / "cache"))[0] == 0


def test_the_numpy_backend_compiles_nothing(tmp_path):
    script = SCRIPT.replace('== "c"', '== "numpy"')
    environment = os.environ | {"CHASLES_CACHE": str(tmp_path), "CHASLES_BACKEND": "numpy"}
    done = subprocess.run([sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True)
    assert done.stdout.startswith("0 ")
    assert not list(tmp_path.rglob("*.so"))


@needs_c
@pytest.mark.slow
@pytest.mark.parametrize("flag", ["CC=clang", "CHASLES_INSTRUCTIONS=baseline"])
def test_other_compilers_and_levels_give_the_same(flag, tmp_path):
    name, value = flag.split("=")
    if name == "CC" and shutil.which(value) is None:
        pytest.skip(f"needs {value}")
    environment = os.environ | {"CHASLES_CACHE": str(tmp_path), name: value}
    done = subprocess.run([sys.executable, "-c", SCRIPT], env=environment, capture_output=True, text=True, check=True)
    ran, found = done.stdout.split()
    assert ran == "1"
    assert float(found) == pytest.approx(2 * np.sin(0.5) + 1, rel=1e-15)


def test_importing_chasles_stays_light():
    light = "import sys, chasles; assert not {'sympy', 'numpy', 'ctypes'} & set(sys.modules), sys.modules.keys()"
    subprocess.run([sys.executable, "-c", light], check=True)


def test_making_and_calling_load_no_masked_arrays():
    script = "import sys, chasles, sympy; x = sympy.Symbol('x'); chasles.compile(x + 1, x)([1.0])"
    done = subprocess.run(
        [sys.executable, "-c", f"{script}; print('numpy.ma' in sys.modules)"], capture_output=True, check=True
    )
    assert done.stdout.split() == [b"False"]


@pytest.mark.parametrize("enabled", [True, False])
def test_cycles_are_not_looked_for_while_a_kernel_is_made_and_again_afterwards(enabled, monkeypatch):
    compiling = sys.modules["chasles.compiling"]
    seen, made, was_enabled = [], compiling.kernel_for, gc.isenabled()
    monkeypatch.setattr(compiling, "kernel_for", lambda *given: seen.append(gc.isenabled()) or made(*given))
    (gc.enable if enabled else gc.disable)()
    try:
        chasles.compile(x + 1, x)
        assert gc.isenabled() == enabled
        with pytest.raises(LoweringError):
            chasles.compile(x + y, x)
        assert gc.isenabled() == enabled
    finally:
        (gc.enable if was_enabled else gc.disable)()
    assert seen == [False]


@needs_c
def test_single_precision_is_rounded_from_double_until_there_is_much_of_it(monkeypatch):
    """Whatever the layout; then it is compiled too, and the results are as good."""
    monkeypatch.setattr(sys.modules["chasles.compiling.kernel"], "MANY_SINGLES", 11_000)
    kernel = chasles.compile([v / v.norm(), v.dot(v) * x], [v, x])
    draw = np.random.default_rng(5)
    for shape in [(), (1,), (5,), (33,), (4, 40), (700,)]:
        vectors, factors = np.float32(draw.uniform(-1, 1, (*shape, 3))), np.float32(draw.uniform(-1, 1, shape))
        for given in ((vectors, factors), (vectors[..., ::-1], factors), (vectors, factors * 0 + np.float32(2))):
            wide = kernel(*(each.astype(float) for each in given))
            for narrow, exact in zip(kernel(*given), wide, strict=True):
                assert narrow.dtype == np.float32
                assert np.array_equal(narrow, np.float32(exact))
    before, rounded = kernel.ufunc, kernel(vectors, factors)
    assert kernel.ufunc is before
    kernel(vectors, factors)
    assert kernel.ufunc is not before
    for one, other in zip(kernel(vectors, factors), rounded, strict=True):
        assert one.dtype == np.float32
        np.testing.assert_allclose(one, other, rtol=1e-6)
    after = kernel.ufunc
    kernel(vectors, factors)
    assert kernel.ufunc is after


def test_constants_out_of_the_range_of_single_precision_are_computed_in_double(backend):
    kernel = chasles.compile([x + sp.Float("1e-60"), x * sp.Float("1e-300") / sp.Float("1e-310") * y], [x, y])
    assert kernel(0.0, 1e-20)[0] == 1e-60
    assert kernel(2.0, 1e-20)[1] == pytest.approx(2e-10, rel=1e-12)
    if backend == "c":
        narrow = kernel(np.float32([0, 2]), np.float32(1e-20))
        assert narrow[1].dtype == np.float32
        np.testing.assert_allclose(narrow[1], [0, 2e-10], rtol=1e-6)
    assert "chasles_expressionf" not in chasles.compile(x + sp.Float("1e-60"), x).c_source
    assert "chasles_expressionf" in chasles.compile(x + sp.Float("1e-30"), x).c_source


def test_a_long_constant_that_has_a_name_is_a_number_like_others(recwarn):
    smallest = chasles.compile(sp.sqrt(sp.Max(sp.Float("2.30258509299405"), sp.acos(y / 2))), y)
    assert smallest.backend == "c"
    assert smallest(0.0) == math.sqrt(2.30258509299405)
    assert not recwarn.list


j = sp.symbols("j", integer=True)
WRITTEN_OUT = [
    (sp.Derivative(sp.sin(x) * y, x), sp.cos(x) * y),
    (sp.Subs(x**2, x, y), y**2),
    (sp.Sum(x**j, (j, 0, 3)), 1 + x + x**2 + x**3),
    (sp.Product(x + j, (j, 0, 2)), x * (x + 1) * (x + 2)),
    (sp.Tuple(x, y), [x, y]),
    (np.array([x, y]), sp.Matrix([x, y])),
    ([[x, y], x], [sp.Matrix([x, y]), x]),
    (sp.SingularityFunction(x, y, 2), sp.Piecewise(((x - y) ** 2, x >= y), (0, True))),
    (sp.KroneckerDelta(x, 1), sp.Piecewise((1, sp.Eq(x, 1)), (0, True))),
    (sp.binomial(x, 2), x * (x - 1) / 2),
    (sp.arg(x + sp.I * y), sp.atan2(y, x)),
    (sp.beta(x, y), sp.gamma(x) * sp.gamma(y) / sp.gamma(x + y)),
    (sp.Contains(x, sp.Interval(0, y), evaluate=False), (x >= 0) & (x <= y)),
    (sp.Rem(x, y), x - y * sp.floor(x / y)),
]


@pytest.mark.parametrize("number", range(len(WRITTEN_OUT)))
def test_what_is_short_for_others_is_written_out(number, monkeypatch):
    monkeypatch.setenv("CC", "no-such-compiler")
    given, meant = (chasles.compile(expression, [x, y]) for expression in WRITTEN_OUT[number])
    for point in ((2.5, 1.25), (1.0, 1.75)):
        found, wanted = (
            values if isinstance(values, tuple) else (values,) for values in (given(*point), meant(*point))
        )
        for one, other in zip(found, wanted, strict=True):
            np.testing.assert_allclose(one, other, rtol=1e-14)


def test_spherical_bessel_functions_have_their_values_at_zero():
    kernel = chasles.compile([sp.jn(0, x), sp.jn(1, x), sp.jn(2, x)], x)
    near = [1 - 1e-10 / 6, 1e-5 / 3 - 1e-15 / 30, 1e-10 / 15]
    far = [math.sin(2) / 2, 0.435397774979992, 0.198447949057147]
    np.testing.assert_allclose(np.array(kernel([0.0, 1e-5, 2.0])).T, [[1, 0, 0], near, far], rtol=1e-14, atol=1e-17)


def test_functions_of_a_users_own_are_read_anew(monkeypatch, tmp_path):
    """Another run may define another function of the same name."""
    monkeypatch.setenv("CHASLES_CACHE", str(tmp_path))
    monkeypatch.setenv("CC", "no-such-compiler")
    for power in (2, 3):
        body = {"doit": lambda self, power=power, **_: self.args[0] ** power}
        assert chasles.compile(type("Mine", (sp.Function,), body)(x), [x])(3.0) == 3.0**power
