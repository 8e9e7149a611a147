"""Derivatives of compiled expressions: by what, of which kind, in which shape; against those that SymPy forms."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from math import prod

import mpmath
import numpy as np
import pytest
import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

import chasles
from chasles.compiling import derivatives as module
from chasles.compiling.derived import derived_from
from chasles.compiling.inputs import inputs_of
from chasles.compiling.program_of import program_of
from chasles.compiling.results import outputs_of
from chasles.lowering.arithmetic import decimals, run
from chasles.lowering.builder import Builder
from chasles.lowering.program import Op

x, y, z = sp.symbols("x y z")
v = sp.Matrix(sp.symbols("v1:4"))
NUMBERS = decimals(60)
POINT = {x: Fraction(7, 10), y: Fraction(-13, 10), z: Fraction(21, 10)}
EXPRESSIONS = [
    x * y**2 / z - x / (y * z),
    sp.sqrt(x**2 + y**2 + z**2) ** 3 * sp.sin(x * y),
    sp.exp(x * y) * sp.log(z) + sp.cosh(x) * sp.tanh(y - z),
    sp.atan2(x * y, z) + sp.asin(x / 3) * sp.acos(y / 4),
    sp.Piecewise((x * y, z > 2), (sp.sqrt(y), True)) * sp.Abs(y * x),
    sp.Max(x * z, y**2) * sp.Min(x, sp.cos(z)) + z ** sp.Rational(1, 3),
    x**z + sp.erf(x * y) * sp.gamma(z),
    sp.cos(sp.sqrt(x**2 + y**2)) * sp.sinc(sp.sqrt(y**2 + z**2)),
    sp.Piecewise((1 / (x - sp.Rational(7, 10)), y > 0), (x**2 * z, True)) ** 2 + z,
    x + 2 * y,
]


@pytest.fixture
def in_numpy(monkeypatch):
    monkeypatch.setenv("CC", "no-such-compiler")
    monkeypatch.setenv("CHASLES_CACHE", "")


def program(expression, inputs, *kinds, **options):
    given = inputs_of(inputs)
    results = outputs_of(expression, given, None)
    return program_of("made", given, results, derived_from(given, results, kinds, **options))


def values(made, point, *more):
    """The results of a program in 60 digits, by name."""
    flat = iter([*point, *more])
    given = [[NUMBERS.constant(Fraction(next(flat))) for _ in range(prod(each.shape))] for each in made.arguments]
    return {each.name: found for each, found in zip(made.results, run(made, given, NUMBERS), strict=True)}


def exact(expression, by, point=POINT):
    """The value of the derivative that SymPy forms, in 60 digits."""
    real = {symbol: sp.Symbol(symbol.name, real=True) for symbol in point}
    whole = expression.replace(sp.sinc, lambda a: sp.sin(a) / a).xreplace(real)
    slope = whole.diff(*(real[symbol] for symbol in by))
    with mpmath.workdps(60):
        at = [mpmath.mpf(value.numerator) / value.denominator for value in point.values()]
        return sp.lambdify(list(real.values()), slope, [{"DiracDelta": lambda *_: 0}, "mpmath"])(*at)


def same(found, wanted):
    small = NUMBERS.constant(Fraction(1, 10**45))
    return all(abs(a - b) <= small * (1 + abs(b)) for a, b in zip(found, wanted, strict=True))


@pytest.fixture(params=["forward", "back"])
def direction(request, monkeypatch):
    monkeypatch.setattr(module, "_work_back", lambda *_: -1 if request.param == "back" else 10**9)
    return request.param


@pytest.mark.sampled(5)
@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_all_kinds_are_those_of_sympy_in_both_directions(expression, direction):
    symbols = (x, y, z)
    made = program(expression, symbols, "jacobian", "hessian", "jvp", "vjp")
    found = values(made, POINT.values(), 3, -1, 2, 5)
    slopes = [exact(expression, [by]) for by in symbols]
    assert same(found["result_jacobian"], slopes)
    assert same(found["result_hessian"], [exact(expression, [one, two]) for one in symbols for two in symbols])
    with mpmath.workdps(60):
        assert same(found["result_jvp"], [3 * slopes[0] - slopes[1] + 2 * slopes[2]])
        assert same(found["result_vjp"], [5 * slope for slope in slopes])


@pytest.mark.sampled(5)
@pytest.mark.parametrize("at", [0.0, 1e-200, 1e-9, 1e-3, 0.4])
@pytest.mark.parametrize("shape", ["sin(r)/r", "(1 - cos(r))/r**2", "cos(r)", "(r - sin(r))/r**3"])
def test_second_derivatives_at_removable_singularities(shape, at, in_numpy, direction):
    """Of functions of a length r the Hessian is A 1 + B r r^T, with A and B from the series at zero."""
    expression = sp.sympify(shape).subs(sp.Symbol("r"), v.norm())
    _, slope, hessian = chasles.compile(expression, {"v": v}, jacobian=True, hessian=True)(at * np.array([2.0, -1, 2]))
    with mpmath.workdps(900):
        function = sp.lambdify(sp.Symbol("r"), sp.sympify(shape), "mpmath")
        r = mpmath.mpf(3 * at) or mpmath.mpf(10) ** -220
        terms = mpmath.taylor(function, r, 2) if at else None
        one, two = (terms[1], 2 * terms[2]) if terms else (0, 2 * (function(r) - function(2 * r)) / (-3 * r * r))
        unit = np.array([2.0, -1.0, 2.0]) / 3
        wanted = float(one / r) * np.eye(3) + float(two - one / r) * np.outer(unit, unit) if at else float(two)
    np.testing.assert_allclose(slope, float(one) * unit, rtol=1e-14, atol=1e-300)
    np.testing.assert_allclose(hessian, wanted if at else wanted * np.eye(3), rtol=2e-14, atol=1e-15)
    assert (hessian == hessian.T).all()


@pytest.mark.parametrize("shape", ["sin(r*t)/r", "(1 - cos(t*r))/r**2", "cos(2*r*t)"])
def test_derivatives_of_a_turn_at_a_rate_that_may_be_zero(shape, in_numpy, direction):
    r, t = sp.symbols("r t")
    shape = sp.sympify(shape)
    kernel = chasles.compile(shape.subs(r, v.norm()), {"v": v, "t": t}, jacobian=True)
    for at in (0.0, 1e-200, 1e-9, 0.4):
        value, slope = kernel(at * np.array([2.0, -1.0, 2.0]), 0.7)
        point = {r: sp.Rational(3 * at) or sp.Rational(1, 10**250), t: sp.Rational(0.7)}
        exact, by_rate, by_time = (
            float(each.subs(point).evalf(20, maxn=2000)) for each in (shape, shape.diff(r), shape.diff(t))
        )
        wanted = [exact, *(by_rate * np.array([2.0, -1.0, 2.0]) / 3), by_time]
        np.testing.assert_allclose([value, *slope], wanted, rtol=1e-13, atol=1e-220)


def test_what_is_not_chosen_is_not_differentiated(in_numpy, direction):
    """The other piece has no value, nor has its derivative, and neither shows."""
    f = sp.Piecewise((sp.sqrt(x) * sp.log(x), x > 0), (y**2, True)) * z
    _, slope, second = chasles.compile(f, [x, y, z], jacobian=True, hessian=True)(-1.0, 3.0, 2.0)
    assert slope.tolist() == [0, 12, 9]
    assert second.tolist() == [[0, 0, 0], [0, 4, 6], [0, 6, 0]]
    _, slope = chasles.compile(sp.cbrt(x) + y, [x, y], jacobian=True)(-1.0, 1.0)
    assert np.isnan(slope[0])
    assert slope[1] == 1


SHAPES = [
    (x**2, [x, y], {"jacobian": True, "wrt": x}, "(),()->(),()"),
    (x**2, [x, y], {"jacobian": True, "wrt": ["y", x]}, "(),()->(),(2)"),
    (v, [x, v], {"jacobian": True, "wrt": [v]}, "(),(3)->(3),(3,3)"),
    (v, {"x": x, "w": v}, {"jacobian": True, "wrt": ["w"]}, "(),(3)->(3),(3,3)"),
    (v, [v], {"jacobian": True, "wrt": ["v2"]}, "(3)->(3),(3)"),
    (x * y, [x, y], {"hessian": True}, "(),()->(),(2,2)"),
    (x * y, [x, y], {"hessian": True, "wrt": "x"}, "(),()->(),()"),
    ([v, x], [v, x], {"jvp": True, "wrt": v}, "(3),(),(3)->(3),(),(3),()"),
    ([v, x], [v, x], {"vjp": True}, "(3),(),(3),()->(3),(),(4)"),
    (sp.diag(x, y), [x, y], {"jacobian": True, "coo": True}, "(),()->(2,2),(2)"),
]


@pytest.mark.parametrize(("expression", "inputs", "options", "signature"), SHAPES)
def test_shapes(expression, inputs, options, signature, in_numpy):
    assert chasles.compile(expression, inputs, **options).signature == signature


def test_by_functions_of_time_and_by_symbols_whatever_is_assumed(in_numpy):
    q, rate = dynamicsymbols("q"), dynamicsymbols("q", 1)
    kernel = chasles.compile(q**2 * rate * x, [q, rate, x], jacobian=True, wrt=[rate, sp.Symbol("x", positive=True)])
    assert kernel(3.0, 5.0, 7.0)[1].tolist() == [63, 45]


def test_what_is_not_zero_by_construction(in_numpy):
    chain = sp.Matrix([v[0] ** 2, v[0] * v[1], v[2], 5])
    dense, sparse = (chasles.compile(chain, [v], jacobian=True, coo=coo) for coo in (False, True))
    at = np.array([[2.0, 3.0, 4.0], [5.0, 6.0, 7.0]])
    for kernel in (dense, sparse):
        rows, columns = kernel.pattern["result_jacobian"]
        assert (rows.tolist(), columns.tolist()) == ([0, 1, 1, 2], [0, 0, 1, 2])
    (_, matrix), (_, entries) = dense(at), sparse(at)
    assert (matrix[:, rows, columns] == entries).all()
    assert (matrix != 0).sum() == 8
    kernel = chasles.compile(v[0] * v[1] ** 2 + v[2], [v], hessian=True, coo=True)
    rows, columns = kernel.pattern["result_hessian"]
    assert list(zip(rows, columns, kernel(np.array([2.0, 3, 4]))[1], strict=True)) == [(0, 1, 6), (1, 0, 6), (1, 1, 4)]


def test_a_gradient_of_many_costs_little_more_than_the_function():
    """As back propagation has it: not more than five times (Griewank and Walther, section 4.6)."""
    q = sp.Matrix(sp.symbols("q1:41"))
    whole = sp.exp(-sp.sqrt(sum(sp.sin(a) * sp.cos(b) for a, b in pairwise(q)) ** 2 + 1) * q[0])
    made = program(whole, {"q": q}, "jacobian")
    assert made.operations.total() < 5 * program(whole, {"q": q}).operations.total()
    assert made.operations[Op.DIVIDE] < 5
    column = program(sp.Matrix([sp.sin(x * k) / (1 + x**k) for k in range(1, 20)]), [x], "jacobian")
    assert column.operations[Op.SINE] == 19


def test_seeds_that_meet_are_summed(in_numpy):
    kernel = chasles.compile(sp.Matrix([x, x, x * y]), [x, y], vjp=True)
    assert kernel(2.0, 3.0, np.array([1.0, 10, 100]))[1].tolist() == [311, 200]


def test_derivatives_of_what_does_not_change_are_none():
    build = Builder()
    assert module.derivatives(build, [build.one], [build.input(0, 0)]) == [{}]


REFUSED = [
    (x, [x], {"wrt": x}, "wrt is for derivatives: ask for jacobian=True"),
    (x, [x], {"coo": True}, "coo=True is for matrices"),
    (x, [x], {"jacobian": True, "wrt": y}, "wrt names y, which is not among the inputs: x"),
    (x, {"q": v, "x": x}, {"vjp": True, "wrt": ["r"]}, "wrt names r, which is not among the inputs: q, x"),
    (x, [x], {"jacobian": True, "wrt": []}, "wrt is empty"),
    (x, [x], {"jacobian": True, "wrt": {x}}, "wrt is a set, which has no order"),
    (x, [x], {"jacobian": True, "wrt": x + 1}, "wrt names x . 1, which is not among the inputs: x"),
    (x, [x], {"jacobian": True, "wrt": 3}, "wrt names 3, which is not among the inputs: x"),
    (x, [x, y], {"jacobian": True, "wrt": [x, "x"]}, "wrt names x twice"),
    (v, [v], {"hessian": True}, "hessian=True asks for scalars, and result has 3 entries"),
    (x, [x, y], {"jacobian": True, "coo": True, "wrt": y}, "all entries of result_jacobian are zero"),
    (sp.elliptic_k(x), [x], {"jacobian": True}, "the derivative of ellipk is not known"),
    (
        x,
        [x, sp.Symbol("x", real=True)],
        {"jvp": True, "wrt": sp.Symbol("x", positive=True)},
        "which is among the inputs more than once",
    ),
]


@pytest.mark.parametrize(("expression", "inputs", "options", "said"), REFUSED)
def test_what_is_refused(expression, inputs, options, said, in_numpy):
    with pytest.raises(chasles.compiling.LoweringError, match=said):
        chasles.compile(expression, inputs, **options)


def test_names_that_are_taken(in_numpy):
    with pytest.raises(ValueError, match="two results would be called f_jacobian: give other names"):
        chasles.compile([x, y], [x, y], ["f", "f_jacobian"], jacobian=True)
    kernel = chasles.compile(x, {"tangent": x}, jvp=True)
    assert list(kernel.inputs) == ["tangent", "tangent_"]


def test_compiled_over_a_batch():
    q = sp.Matrix(sp.symbols("q1:5"))
    energy = sum(sp.cos(a - b) for a, b in pairwise(q)) / sp.sqrt(1 + q.dot(q))
    kernel = chasles.compile(energy, {"q": q}, jacobian=True, hessian=True, jvp=True, vjp=True)
    rows, directions = (np.random.default_rng(k).uniform(-2, 2, (50, 4)) for k in range(2))
    _, slope, second, along, back = kernel(rows, directions, np.arange(50.0))
    np.testing.assert_allclose(along, (slope * directions).sum(axis=-1), rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(back, np.arange(50.0)[:, None] * slope, rtol=1e-13, atol=1e-15)
    for k in range(0, 50, 7):
        at = dict(zip(q, rows[k], strict=True))
        np.testing.assert_allclose(slope[k], [float(energy.diff(a).subs(at)) for a in q], rtol=1e-12, atol=1e-13)
        wanted = [[float(energy.diff(a, b).subs(at)) for a in q] for b in q]
        np.testing.assert_allclose(second[k], wanted, rtol=1e-12, atol=1e-13)


R = sp.Rational
SMALL_SLOPES = [
    *(x ** R(5, 2) + x ** R(4, 3), (1 + y) * sp.Max(x - 1, 0) ** R(3, 2), x**4 / (1 + x**4), y * x / (z + x)),
    *((x - y) / (x + y), x ** R(5, 2) / (y ** R(5, 2) + x ** R(5, 2)), sp.exp(x / 9) / (sp.exp(x / 9) + sp.exp(-y))),
    *(x / sp.sqrt(x**2 + y**2), z * x / sp.sqrt(x**2 + y**2 + 1), sp.atan(y / x), (1 - x * y) / (z + 2 * x * y)),
]


def test_slopes_keep_their_digits_each_for_itself(in_numpy):
    """Where a function is flat, and where a root vanishes of which a higher power is taken."""
    made = chasles.compile(sp.Matrix(SMALL_SLOPES), [x, y, z], jacobian=True)
    exact = [sp.lambdify([x, y, z], [f.diff(s) for s in (x, y, z)], "mpmath") for f in SMALL_SLOPES]
    for point in ((1e3, 0.7, 0.3), (1e-4, 0.8, 1e3), (3e2, 1e-7, 0.4), (2.0, 5e3, 1e-3), (1.0, 1.0, 1.0)):
        for slopes, wanted in zip(made(*point)[1], exact, strict=True):
            with mpmath.workdps(80):
                rows = [float(sp.re(slope)) for slope in wanted(*map(mpmath.mpf, point))]
            np.testing.assert_allclose(slopes, rows, rtol=1e-13)
    assert not made(0.0, 1.0, 1.0)[1][0].any()
    assert not made(1.0, 1.0, 1.0)[1][1].any()
