"""Every function that is compiled, in C and in NumPy, beside 400 digits: at large and small arguments, and at edges."""

from __future__ import annotations

import math
from functools import cache

import mpmath
import numpy as np
import pytest
import sympy as sp
from sympy.codegen import cfunctions

import chasles
from chasles.bounds.model import precision
from chasles.compiling.derived import derived_from
from chasles.compiling.inputs import inputs_of
from chasles.compiling.program_of import program_of
from chasles.compiling.results import outputs_of
from chasles.lowering.arithmetic import decimals, run
from chasles.lowering.program import Op

x, y = sp.symbols("x y", real=True)
third = sp.Rational(1, 3)
EXPRESSIONS = [
    *(sp.exp(x), sp.log(x), sp.log(1 + x), sp.log(x, 10), sp.exp(x) - 1, sp.exp(x) + y - 1, sp.exp(-x * y)),
    *(x**third, x ** (2 * third), x**-third, x ** sp.Rational(3, 4), x ** sp.Float(0.25)),
    *(x**y, 2**x, sp.pi**x, x**40, x**-50, x**7, x**-3, x ** sp.Rational(5, 2), sp.sqrt(x), sp.real_root(x, 3)),
    *(sp.sinh(x), sp.cosh(x), sp.tanh(x), sp.coth(x), sp.sech(x), sp.csch(x)),
    *(sp.asinh(x), sp.acosh(x), sp.atanh(x), sp.acoth(x), sp.asech(x), sp.acsch(x)),
    *(sp.sin(x), sp.cos(x), sp.tan(x), sp.cot(x), sp.sec(x), sp.csc(x), sp.sinc(x), sp.atan2(x, y)),
    *(sp.asin(x), sp.acos(x), sp.atan(x), sp.acot(x), sp.asec(x), sp.acsc(x)),
    *(sp.floor(x), sp.ceiling(x), sp.frac(x), sp.Mod(x, y), sp.Mod(x, 3), sp.Heaviside(x), sp.Heaviside(x, 0)),
    *(sp.erf(x), sp.erfc(x), sp.gamma(x), sp.loggamma(x), sp.factorial(x)),
    *(sp.Max(x, y), sp.Min(x, y, 1), sp.Abs(x), sp.sign(x), sp.Abs(x) ** y),
    *(x < y, sp.And(x < y, x > 0), sp.Or(x < y, sp.Not(x > 0)), sp.Xor(x < y, x > 0), sp.Implies(x < y, x < 1)),
    sp.Piecewise((sp.exp(x), x < y), (sp.log(x), True)),
]
AT = [-3.7, -2.0, -1.0, -0.5, -1e-9, 0.0, 1e-9, 0.3, 1.0, 1.5, 2.0, 3.3, 10.0, 1e-150, 1e150, -1e150, 5e-324]
BESIDE = (0.7, -1.3, 2.0)
POINTS = [(a, b) for a in AT for b in BESIDE]
UNITS = 24
"""Roundoffs of 2^-53: what a chain of a few functions of libm may lose."""


@cache
def in_mpmath(expression):
    return sp.lambdify([x, y], expression, "mpmath")


@cache
def exact(expression, a, b):
    """The value to 400 digits, NaN where it is not real or there is none."""
    with mpmath.workdps(400):
        try:
            value = in_mpmath(expression)(mpmath.mpf(a), mpmath.mpf(b))
            return math.nan if isinstance(value, mpmath.mpc) and value.imag else float(getattr(value, "real", value))
        except OverflowError:
            return math.inf
        except (ZeroDivisionError, ValueError):
            # Some functions have a value where mpmath's own formula has none: acot(0).
            value = expression.subs({x: a, y: b}) if not a else sp.nan
            return float(value) if value.is_finite and value.is_real else math.nan


def overflows(expression, a):
    """Whether one over the smallest of numbers stands in what is computed, by us or by SciPy."""
    return a == 5e-324 and expression.has(sp.acsch, sp.loggamma)


def agrees(got, wanted):
    if math.isnan(wanted) or math.isinf(wanted):
        return not math.isfinite(got)
    if math.isinf(got):
        return abs(wanted) > 1e307
    return abs(got - wanted) <= UNITS * 2.0**-53 * abs(wanted) + 1e-307


@pytest.fixture(scope="module")
def computed():
    """All expressions at all points: one kernel, since a compiler takes its time over each."""
    entries = [sp.Piecewise((1, e), (0, True)) if isinstance(e, sp.logic.boolalg.Boolean) else e for e in EXPRESSIONS]
    kernel = chasles.compile(sp.Matrix(entries), [x, y])
    assert kernel.backend == "c"
    first, second = (np.array(v) for v in zip(*POINTS, strict=True))
    with np.errstate(all="ignore"):
        single = np.array([kernel(a, b) for a, b in POINTS])
        return {"c": kernel(first, second), "numpy": kernel.array_api(first, second), "one at a time": single}


@pytest.mark.sampled(11)
@pytest.mark.parametrize("way", ["c", "numpy", "one at a time"])
@pytest.mark.parametrize("number", range(len(EXPRESSIONS)), ids=lambda number: str(EXPRESSIONS[number]))
def test_every_function_beside_400_digits(computed, number, way):
    wanted = [exact(EXPRESSIONS[number], a, b) for a, b in POINTS]
    values = computed[way][:, number]
    wrong = [found for found in zip(POINTS, values, wanted, strict=True) if not agrees(*found[1:])]
    assert not [found for found in wrong if not overflows(EXPRESSIONS[number], found[0][0])]


def test_a_power_that_is_no_number_of_the_machine_loses_what_its_rounding_does():
    kernel = chasles.compile(x ** sp.Rational(5, 7), x)
    for at in (1e-9, 0.3, 2.0, 1e9):
        assert agrees(kernel(at), exact(x ** sp.Rational(5, 7), at, 0.0))


def test_one_is_taken_from_an_exponential_without_loss():
    expressions = [sp.exp(x) - 1 + y, 1 - sp.exp(-x), y - y * sp.exp(x / y), 2 * sp.exp(x) - 2, 3 - 3 * sp.cosh(2 * x)]
    kernel = chasles.compile(expressions, [x, y])
    for at in ((1e-10, 1e-11), (-1e-7, 0.5), (0.7, 2.0), (-30.0, 3.0), (300.0, -1.0)):
        for expression, got in zip(expressions, kernel(*at), strict=True):
            assert agrees(got, exact(expression, *at)), (expression, at)


@pytest.mark.parametrize("relation", [x < y, sp.Or(x > 1, y > 1)], ids=str)
def test_a_truth_value_is_one_or_zero(relation):
    kernel = chasles.compile(relation, [x, y])
    assert kernel(1.0, 2.0) == 1.0
    assert kernel(1.0, 0.5) == 0.0


SUPPOSED = {
    "exp": (sp.exp(x), np.exp, -80, 80),
    "expm1": (sp.exp(x) - 1, np.expm1, -5, 20),
    "log": (sp.log(x), np.log, 1e-5, 1e5),
    "log1p": (sp.log(1 + x), np.log1p, -0.9, 10),
    "cbrt": (cfunctions.Cbrt(x), np.cbrt, -1e3, 1e3),
    "sinh": (sp.sinh(x), np.sinh, -20, 20),
    "cosh": (sp.cosh(x), np.cosh, -20, 20),
    "tanh": (sp.tanh(x), np.tanh, -5, 5),
    "asinh": (sp.asinh(x), np.arcsinh, -20, 20),
    "acosh": (sp.acosh(x), np.arccosh, 1, 20),
    "atanh": (sp.atanh(x), np.arctanh, -1, 1),
    "sine": (sp.sin(x), np.sin, -20, 20),
    "cosine": (sp.cos(x), np.cos, -20, 20),
    "arctangent2": (sp.atan2(x, 1), lambda a: np.arctan2(a, type(a[0])(1)), -20, 20),
}


@pytest.mark.skipif(np.finfo(np.longdouble).nmant < 63, reason="needs numbers of more digits")
@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", SUPPOSED)
def test_functions_are_within_what_error_bounds_suppose(name):
    """Compiled, and in NumPy, in both precisions."""
    expression, function, low, high = SUPPOSED[name]
    kernel = chasles.compile(expression, [x])
    draw = np.random.default_rng(1)
    points = np.concatenate([draw.uniform(low, high, 50_000), low + (high - low) * draw.uniform(0, 1, 20_000) ** 8])
    for kind, wider in ((np.float64, np.longdouble), (np.float32, np.float64)):
        given = points.astype(kind)
        with np.errstate(all="ignore"):
            wanted = function(given.astype(wider))
        plain = np.isfinite(wanted) & (abs(wanted) > np.finfo(kind).tiny)
        unit = np.spacing(abs(wanted[plain]).astype(kind)).astype(wider)
        for way, in_numpy in ((kernel, False), (kernel.array_api, True)):
            model, _ = precision(kind, in_numpy=in_numpy)
            is_operation = name in [op.value for op in Op]
            within = model._within(Op(name) if is_operation else Op.FUNCTION, name)
            with np.errstate(all="ignore"):
                found = way(given)
            assert (abs(found[plain].astype(wider) - wanted[plain]) / unit).max() <= float(within) + 1e-3


SPECIAL = [
    *(sp.Ei(x), sp.E1(x), sp.expint(3, x), sp.li(x + 2), sp.Si(x), sp.Ci(x), sp.Shi(x), sp.Chi(x)),
    *(sp.fresnels(x), sp.fresnelc(x), sp.airyai(x), sp.airybi(x), sp.airyaiprime(x), sp.airybiprime(x)),
    *(sp.LambertW(x), sp.erfi(x), sp.erfinv(x), sp.erfcinv(x), sp.besselj(2, x), sp.polygamma(1, x)),
]


def test_functions_of_scipy_have_their_rates():
    given, arithmetic = inputs_of([x]), decimals(30)
    for expression in SPECIAL:
        results = outputs_of(expression, given, None)
        program = program_of("f", given, results, derived_from(given, results, ("jacobian",), None, coo=False))

        def value(at, program=program):
            return run(program, [[arithmetic.context.mpf(at)]], arithmetic)[0][0]

        for at in (0.3, 0.8):
            _, [slope] = run(program, [[arithmetic.context.mpf(at)]], arithmetic)
            assert abs(slope - arithmetic.context.diff(value, at)) < 1e-12, (expression, at)


def test_orders_of_exponential_integrals_are_whole():
    with pytest.raises(chasles.compiling.LoweringError, match="whole numbers"):
        chasles.compile(sp.expint(x, y), [x, y])


def test_functions_of_scipy_have_no_value_where_it_is_not_real():
    scipy = pytest.importorskip("scipy.special")
    at = np.array([-0.5, 0.4, 2.0])
    found = chasles.compile([sp.Ci(x), sp.Chi(x), sp.LambertW(x), sp.erfinv(x), sp.airybiprime(x)], [x])(at)
    wanted = [scipy.sici(at)[1], scipy.shichi(at)[1], scipy.lambertw(at).real, scipy.erfinv(at), scipy.airy(at)[3]]
    for number, (got, value) in enumerate(zip(found, wanted, strict=True)):
        assert np.array_equal(np.isnan(got), [number < 3, False, number == 3])
        assert np.array_equal(got[~np.isnan(got)], value[~np.isnan(got)])
