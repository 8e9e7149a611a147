"""What goes into a compiled expression: symbols, functions of time and their derivatives, arrays, by place or name."""

from __future__ import annotations

import inspect
import pickle

import numpy as np
import pytest
import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

import chasles
from chasles.compiling import LoweringError
from chasles.compiling.identifiers import identifier, name_of_group
from chasles.compiling.inputs import inputs_of

from .counted import at_most

t, x, m, g = sp.symbols("t x m g")
q1, q2 = dynamicsymbols("q1 q2")
f = sp.Function("f")
q = sp.Matrix([q1, q2])


@pytest.fixture(autouse=True)
def written(monkeypatch):
    """What goes in is read alike for every backend."""
    monkeypatch.setenv("CC", "no-such-compiler")


A = sp.IndexedBase("A", shape=(2, 3))
b = sp.IndexedBase("b", shape=(3,))
M = sp.MatrixSymbol("M", 2, 2)
d1, d2 = sp.Dummy("k"), sp.Dummy("k")
up, down = sp.Symbol("s"), sp.Symbol("s", positive=True)

VALUES = [
    (sp.Poly(x**2 + m, x, m), [x, m], (2, 3), 7),
    (m * q1.diff(t, 2) + q1.diff(t) * q2 - g, [q1.diff(t, 2), q1.diff(t), q2, m, g], (2, 3, 5, 7, 11), 18),
    (q1.diff(t, 2) * 100 + q1.diff(t) * 10 + q1, [q1, q1.diff(t), q1.diff(t, 2)], (1, 2, 3), 321),
    (q1.diff(t, 3) - q1.diff(t, 2), [q1.diff(t, 2), q1.diff(t, 3)], (1, 5), 4),
    (q.diff(t).dot(q), {"q": q, "rates": q.diff(t)}, ([1, 2], [3, 4]), 11),
    (q.T * q.diff(t), {"q": q, "rates": list(q.diff(t))}, ([1, 2], [3, 4]), 11),
    (f(x) * x, [f(x), x], (2, 3), 6),
    (f(x, m + 1) + f(0) - f(1), [f(0), f(1), f(x, m + 1)], (1, 2, 3), 2),
    (f(t - x) + f(t), [f(t), f(t - x)], (1, 5), 6),
    (f(x, t).diff(x, t) - f(x, t).diff(x), [f(x, t).diff(x), f(x, t).diff(t, x)], (1, 5), 4),
    (f(q1) + q1, [f(q1), q1], (1, 5), 6),
    (A[1, 2] - A[0, 1] + b[2], [A, b], ([[0, 1, 2], [3, 4, 5]], [6, 7, 8]), 12),
    (b[0] + b[1], {"array": b}, ([1, 2, 4],), 3),
    (sp.IndexedBase("b")[2], [b], ([1, 2, 4],), 4),
    ((M * M)[0, 1] + sp.Trace(M), [M], ([[1, 2], [3, 4]],), 15),
    (d1 - d2, [d2, d1], (1, 5), 4),
    (d1 - d2, {"ks": [d2, d1]}, ([1, 5],), 4),
    (up - down, [up, down], (5, 1), 4),
    (sp.Symbol("m", positive=True) * sp.Symbol("g", real=True), [m, g], (2, 3), 6),
    (m * g, [sp.Symbol("m", positive=True), sp.Symbol("g", integer=True)], (2, 3), 6),
    (dynamicsymbols("q1", positive=True).diff(t), [q1, q1.diff(t)], (2, 3), 3),
    (dynamicsymbols("q1", real=True).diff(t), [dynamicsymbols("q1", 1)], (3,), 3),
    (sp.Symbol("lambda") + sp.Symbol("t'") + sp.Symbol(r"\dot{q}"), sp.symbols(r"lambda t' \dot{q}"), (1, 2, 3), 6),
    (sp.Array([q1, q2])[1], [sp.Array([q1, q2])], ([1, 2],), 2),
    (sp.Symbol("q1(t)") - q1, [q1, sp.Symbol("q1(t)")], (1, 3), 2),
    (sp.Sum(x * m, (x, 1, 3)).doit() + x, [x, m], (1, 2), 13),
]


@pytest.mark.parametrize("number", range(len(VALUES)))
def test_each_variable_has_the_value_that_goes_in(number):
    expression, inputs, given, wanted = VALUES[number]
    kernel = chasles.compile(expression, inputs)
    assert kernel(*given) == wanted
    names = list(inspect.signature(kernel).parameters)[: len(given)]
    assert kernel(**dict(zip(names, given, strict=True))) == wanted
    assert kernel(given[0], **dict(zip(names[1:], given[1:], strict=True))) == wanted
    assert pickle.loads(pickle.dumps(kernel))(*given) == wanted


REFUSED = [
    (q1.diff(t), [q1], r"Derivative\(q1\(t\), t\) in Derivative\(q1\(t\), t\) is not among"),
    (q1, [q1.diff(t)], r"q1\(t\) in q1\(t\) is not among the inputs: add it, as in \[\.\.\., q1\(t\)\]"),
    (q1.diff(t, 2), [q1.diff(t), q1], r"Derivative\(q1\(t\), \(t, 2\)\) in"),
    (
        m * q1.diff(t) + x * q2 + q2.diff(t) + g,
        [x],
        r"^Derivative\(q1\(t\), t\), Derivative\(q2\(t\), t\), g, m, q2\(t\) are not among the inputs: add them, as in "
        r"\{\.\.\., 'parameters': \[g, m\], 'q2': \[q2\(t\)\], 'q_dot': \[Derivative\(q1\(t\), t\), Deriv",
    ),
    ([x + m, x + g], [x], r"g, m are not among the inputs: add them, as in \{\.\.\., 'parameters': \[g, m\]\}"),
    (f(x), [x], r"f\(x\) in f\(x\) is not among the inputs"),
    (f(x, m), [f(m, x)], r"f\(x, m\) in"),
    (b[sp.Symbol("i")], [b], r"b\[i\] in"),
    (b[3], [b], r"b\[3\] in"),
    (M[sp.Symbol("i"), 0], [M, sp.Symbol("i")], r"M\[i, 0\] is no entry of M: give its row and column as numbers"),
    (up - down, [up], "s is the name of variables that differ only in their assumptions"),
    ([up, down], [sp.Symbol("s", real=True)], "s is the name of variables that differ only in their assumptions"),
    (sp.Symbol("s", integer=True), [up, down], "s is the name of variables that differ only in their assumptions"),
    (d1, [d2], "_k in _k is not among"),
    (sp.Symbol("k"), [d2], "k in k is not among"),
    (sp.Symbol("q1(t)"), [q1], r"q1\(t\) in"),
    (M[0, 0], [sp.MatrixSymbol("M", 3, 3)], "M in"),
    (x, [f], r"the function f is no input: give its value, as f\(t\)"),
    (x, [sp.IndexedBase("c")], r"c has no shape .* IndexedBase\('c', shape=\(3,\)\)"),
    (x, [sp.IndexedBase("c", shape=(m,))], "c has no shape"),
    (x, [sp.IndexedBase("c", shape=(2, 2, 2))], "c has no shape of one or two"),
    (x, [x, q1, q1], r"q1\(t\) comes twice"),
    (x, [sp.Derivative(sp.sin(x), x)], "is none"),
    (x, [2 * q1], "is none"),
]


@pytest.mark.parametrize("number", range(len(REFUSED)))
def test_what_does_not_go_in_is_named(number):
    expression, inputs, said = REFUSED[number]
    with pytest.raises(LoweringError, match=said):
        chasles.compile(expression, inputs)


IDENTIFIERS = [
    (q1, "q1"),
    (q1.diff(t), "q1_dot"),
    (q1.diff(t, 2), "q1_ddot"),
    (q1.diff(t, 3), "q1_dddot"),
    (q1.diff(t, 4), "q1_d4"),
    (f(x), "f"),
    (f(x, m), "f"),
    (f(0), "f_0"),
    (f(x, m).diff(x, m), "f_m_x"),
    (f(x).diff(x, x), "f_x_x"),
    (d1, "k"),
    (sp.Symbol("ω"), "omega"),
    (sp.Symbol("Ω_1"), "Omega_1"),
    (sp.Symbol("λ"), "lambda_"),
    (sp.Symbol("ϕ̇"), "phi_dot"),
    (sp.Symbol("q̈"), "q_ddot"),
    (sp.Symbol("é"), "e"),
    (sp.Symbol("x₁"), "x1"),
    (sp.Symbol("lambda"), "lambda_"),
    (sp.Symbol("theta'"), "theta_prime"),
    (sp.Symbol(r"\dot{q}"), "dot_q"),
    (sp.Symbol(r"\theta_{1}"), "theta_1"),
    (sp.Symbol("2x"), "value_2x"),
    (sp.Symbol("_"), ""),
    (b[1], "b_1"),
    (M[0, 1], "M_0_1"),
]


@pytest.mark.parametrize(("variable", "name"), IDENTIFIERS)
def test_a_variable_is_called_by_its_name(variable, name):
    assert identifier(variable) == name


@pytest.mark.parametrize(
    ("variables", "name"),
    [
        (q, "q"),
        (q.diff(t), "q_dot"),
        (q.diff(t, 2), "q_ddot"),
        (sp.symbols("v1:4"), "v"),
        (sp.symbols("x_1 x_2"), "x"),
        (sp.symbols("k_a1 k_a2"), "k_a"),
        (sp.symbols("mass_a mass_b"), "mass"),
        (sp.symbols("a b"), ""),
        ((b[0], b[1]), "b"),
    ],
)
def test_several_are_called_by_what_they_share(variables, name):
    assert name_of_group(list(variables)) == name


def test_no_two_inputs_have_one_name():
    given = [
        q1,
        sp.Symbol("q1"),
        sp.Symbol("out"),
        sp.Symbol("axis"),
        d1,
        d2,
        sp.symbols("a b"),
        {1: 2} and sp.Symbol("_"),
    ]
    names = [item.argument.name for item in inputs_of(given)]
    assert names == ["q1", "q1_", "out_", "axis_", "k", "k_", "input_7", "input_8"]


def test_comments_say_what_an_input_holds():
    plain, strange = chasles.compile(q1 + sum(q.diff(t)), {"a": q1, "b": q.diff(t)}), sp.Symbol("*/ $ \\ \n")
    assert "a: a number: q1(t)" in plain.c_source
    assert "2 numbers: Derivative(q1(t), t), Derivative(q2(t), t)" in " ".join(plain.c_source.replace("*", "").split())
    assert "$" not in chasles.compile(2 * strange, [strange]).c_source


def test_a_call_says_what_is_missing():
    kernel = chasles.compile(m * x + g, [m, x, g], name="line")
    for inputs, named, said in [
        ((), {}, "without m, x, g: it takes m, x, g"),
        ((1,), {"g": 2}, "without x: "),
        ((1, 2, 3, 4), {}, "with 4 inputs"),
    ]:
        with pytest.raises(TypeError, match=said):
            kernel(*inputs, **named)
    with pytest.raises(TypeError, match="m"):
        kernel(1, 2, 3, m=3)
    out = np.empty(2)
    assert kernel(g=[1, 2], m=3, x=4, out=out) is out
    np.testing.assert_array_equal(out, [13, 14])


def test_the_same_in_every_run():
    def texts():
        one, other = sp.Dummy("k"), sp.Dummy("k")
        return chasles.compile(sp.sin(one) * other + one**2, [other, one]).c_source

    assert texts() == texts()


def test_what_is_shared_is_read_once():
    """As a tree this expression has 2^60 leaves."""
    expression = x
    for number in range(60):
        expression = sp.sin(expression) * expression + m * number
    kernel = chasles.compile(expression, [x, m])
    assert kernel.operations["sine"] == 60
    value = 0.5
    for number in range(60):
        value = np.sin(value) * value + 0.1 * number
    assert kernel(0.5, 0.1) == pytest.approx(value, rel=1e-9)
    with pytest.raises(LoweringError, match=r"m in Add\(\.\.\.\) is not among the inputs"):
        chasles.compile(expression, [x])


def test_inverses_and_determinants_of_many_rows():
    """SymPy writes the inverse of four rows out in minutes."""
    A, c = sp.MatrixSymbol("A", 5, 5), sp.MatrixSymbol("c", 5, 1)
    wanted = [A.I, (A * A.T + sp.Identity(5)).I * c, A**-2, sp.Trace(A.I), sp.Determinant(A)]
    with at_most(calls=10_000_000):
        kernel = chasles.compile([*wanted, sp.Determinant(A.I)], [A, c])
    square, column = np.random.default_rng(1).normal(size=(5, 5)), np.arange(5.0)
    inverse = np.linalg.inv(square)
    expected = [inverse, np.linalg.solve(square @ square.T + np.eye(5), column), inverse @ inverse]
    expected += [np.trace(inverse), np.linalg.det(square), np.linalg.det(inverse)]
    for got, exact in zip(kernel(square, column), expected, strict=True):
        assert np.allclose(got, exact, rtol=1e-12, atol=1e-12)
    slope = chasles.compile(sp.Determinant(A), [A], jacobian=True)(np.diag([1.0, 2.0, 3.0, 4.0, 0.0]))[1]
    assert np.array_equal(slope.reshape(5, 5), np.diag([0.0, 0.0, 0.0, 0.0, 24.0]))
    assert np.isnan(chasles.compile((c * c.T).I, [c])(column)).all()
    with pytest.raises(LoweringError, match="of 13 rows"):
        chasles.compile(sp.Determinant(sp.MatrixSymbol("A", 13, 13)), [sp.MatrixSymbol("A", 13, 13)])
