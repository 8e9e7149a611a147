"""Where formulas fail and functions do not: at angles of zero, at squares out of range, at zeros with a sign."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
import sympy as sp

import chasles
from chasles.compiling.angles import vanishes
from chasles.compiling.removable import without_removable
from chasles.compiling.taylor import Stumpff

from .counted import at_most

x, y, z = sp.symbols("x y z", real=True)
r = sp.sqrt(x**2 + y**2 + z**2)
LIMITS = [
    *(sp.sinc(x), sp.sin(x) / x, (1 - sp.cos(x)) / x**2, (x - sp.sin(x)) / x**3, (x * sp.cos(x) - sp.sin(x)) / x**2),
    *(sp.sin(2 * x) * y / x, sp.sin(x) ** 2 / x, sp.sin(x) ** 4 / x**4, (1 - sp.cos(x)) ** 2 / x**4),
    *(sp.sin(3 * x) * sp.cos(x) / x, sp.tan(x) / x, x / sp.sin(x), x * sp.cot(x), 1 / x**2 - sp.cot(x) / x),
    *((sp.sin(x) / x).diff(x), (sp.sin(x) / x).diff(x, 2), (sp.cos(x) - 1 + x**2 / 2) / x**4),
    *(y * sp.sin(r) / r, x * y * (1 - sp.cos(r)) / r**2, x * y * (r - sp.sin(r)) / r**3, sp.sin(r / 2) / r),
    *(((1 - sp.cos(r)) / r**2).diff(x), 1 / r**2 - (1 + sp.cos(r)) / (2 * r * sp.sin(r)), sp.cos(r)),
    *((1 - sp.cos(x * y)) / x**2, (x * y - sp.sin(x * y)) / (x * y) ** 3, (1 - sp.cos(x**2)) / x**4),
    *(sp.sin(y * sp.sin(x)) / sp.sin(x), (1 - sp.cos(sp.sqrt(2) * x)) / x**2, (1 - sp.cos(sp.sqrt(x))) / x),
    *((x - z - sp.sin(x - z)) / (x - z) ** 3, (2 * x - 2 * z - sp.sin(2 * x - 2 * z)) / (z - x) ** 3),
    (x - x * sp.cos(x)) / (sp.sin(x) ** 2 + (1 - sp.cos(x)) ** 2) + sp.sin(x),
    *((sp.exp(x) - 1 - x) / x**2, (sp.sinh(x) - x) / x**3, (sp.cosh(r) - 1) / r**2, y * sp.sinh(r) / r, x / sp.tanh(x)),
    *(x / (sp.exp(x) - 1), 1 / x - 1 / (sp.exp(x) - 1), 1 / x - sp.coth(x), (1 - sp.exp(-x * y)) / x, sp.erf(x) / x),
    *(sp.log(1 + x * y) / x, (x - sp.log(1 + x)) / x**2, (x - z) / sp.log((1 + x) / (1 + z)), (x - sp.atan(x)) / x**3),
    *(((sp.exp(2 * x) - 1) / x).diff(x), (sp.log(1 + x) / x).diff(x), (sp.atan(x) / x).diff(x)),
    *(sp.asin(x / 3) / x, (x - sp.asinh(x)) / x**3, sp.sinh(x * y) * sp.cosh(x * y) / x, x * sp.exp(x) / sp.sinh(x)),
    *(x * sp.atan2(r, y + 1) / r, (sp.Integer(10) - x) / (sp.exp(1 - x / 10) - 1), (sp.exp(x) - sp.cos(x)) / x),
    *(
        y * (sp.sin(z + x * y) - sp.sin(z)) / x,
        y * (sp.cos(z) - sp.cos(x + z)) / x,
        x * y - sp.atan(x * y),
        x - sp.sin(x),
    ),
    *(sp.exp(x) - 1 - x - x**2 / 2, x * sp.atan2(r, y + 1) * (1 + sp.atan2(r, y + 1) ** 2) / r, sp.log(1 + sp.exp(x))),
    *(z * sp.exp(y + x / 2) - z * sp.exp(y - x / 3), sp.exp(sp.exp(x) - 1) - 1),
    *(
        (x**2 / 2 - x + sp.log(1 + x)) / x**2,
        (x - sp.tanh(x)) / x**3,
        x - z - sp.tanh(x - z),
        y * (r**2 + 2 * sp.cos(r) - 2) / (2 * r**4),
        (1 + x * y) ** (1 / x),
    ),
    sp.Piecewise((sp.sin(x) / x, sp.Ne(x, 0)), (1, True)),
    sp.Piecewise((1, sp.Eq(r, 0)), (sp.sin(r) / r, True)),
    sp.Piecewise((1, sp.Eq(x, 0)), (x / (1 - sp.exp(-x)), True)),
]
AT = [(1e-8, 0.3, 0.2), (1e-8, 1e-9, 2e-8), (0.3, 0.2, 0.1), (1e-3, 1e-3, 0.0), (2.0, 1.0, 1.5), (1e-5, 1.0, 0.0)]
UNITS = 64
"""Roundoffs, in parts of the largest of a value and its derivatives."""


@pytest.fixture(scope="module")
def kernel():
    return chasles.compile(sp.Matrix(LIMITS), [x, y, z], jacobian=True)


def exact(expression, point, apart=0):
    """The value and its derivatives to 200 digits, a little apart from the point."""
    rows = [expression, *(sp.diff(expression, by) for by in (x, y, z))]
    with mpmath.workdps(200):
        first, *others = map(mpmath.mpf, point)
        return [float(value) for value in sp.lambdify([x, y, z], rows, "mpmath")(first + apart, *others)]


@pytest.mark.sampled(4)
@pytest.mark.parametrize("number", range(len(LIMITS)), ids=lambda number: str(LIMITS[number]))
def test_values_and_derivatives_near_a_limit(kernel, number):
    expression = LIMITS[number].replace(sp.sinc, lambda a: sp.sin(a) / a)
    for point in AT:
        values, slopes = kernel(*point)
        got, wanted = [values[number], *slopes[number]], exact(expression, point)
        largest = max(map(abs, wanted))
        assert max(abs(a - b) for a, b in zip(got, wanted, strict=True)) <= UNITS * 2.0**-53 * largest


R = sp.Rational
AWAY = [
    *(
        (sp.sin(x) - sp.sin(y)) / (x - y),
        (x * sp.exp(-y * z) - y * sp.exp(-x * z)) / (x - y),
        (x**4 - y**4) / (x**2 - y**2),
    ),
    *((sp.log(x) - sp.log(y)) / (sp.sqrt(x) - sp.sqrt(y)), (x * sp.log(x) - y * sp.log(y)) / (x - y)),
    *(sp.log(x) / (x**2 - 1), (x**2 - 1) / sp.sin(sp.pi * x), 1 / sp.log(x) - 1 / (x - 1), (1 - x**z) / (1 - x)),
    *(
        (sp.cos(x) - sp.cos(y)) / (x**2 - y**2),
        (sp.tanh(x) - sp.tanh(y)) / (x - y),
        (sp.acos(x / 2) - R(1, 3) * sp.pi) / (x - 1),
    ),
    *(sp.erf(x) / (x - y) + sp.erf(y) / (y - x), (sp.sin(sp.atan(x)) - sp.sin(sp.atan(y))) / (sp.cosh(x) - sp.cosh(y))),
    *((sp.exp(x) - sp.exp(y) - (x - y) * sp.exp(y)) / (x - y) ** 2, (x * sp.log(x) - x + 1) / (x - 1) ** 2),
    *(
        sp.acos((x + 1 - y) / 2) / sp.sqrt(1 - ((x + 1 - y) / 2) ** 2),
        (sp.asinh(x) - sp.asinh(y)) / (x ** R(1, 3) - y ** R(1, 3)),
    ),
    *((1 / (sp.exp(1 / sp.cosh(x)) - R(1, 3)) - 1 / (sp.exp(1 / sp.cosh(1)) - R(1, 3))) / (1 - x),),
    *((sp.sin(5 * x * z) - x / y * sp.sin(5 * y * z)) / (y**2 - x**2), sp.sin(sp.pi * x) / (sp.pi * x * (1 - x**2))),
    sum(sp.exp(-a * 3) / ((b - a) * (c - a)) for a, b, c in ((x, y, z), (y, z, x), (z, x, y))),
    *((y / (x - 1) + z / (x - 1) ** 2) * (1 - x**2) + 2 * z / (x - 1), (sp.sinc(x) - sp.sinc(y)) / (x - y)),
]
PLACES = [(at + by, at, 0.3) for by in (0.0, 1e-10, -1e-5, 1e-3, 0.1, 0.4, -0.6) for at in (1.0, 0.7)]


@pytest.fixture(scope="module")
def away():
    return chasles.compile(sp.Matrix(AWAY), [x, y, z], jacobian=True)


@pytest.mark.sampled(4)
@pytest.mark.parametrize("number", range(len(AWAY)), ids=lambda number: str(AWAY[number]))
def test_values_and_derivatives_near_a_limit_away_from_zero(away, number):
    for at in PLACES:
        values, slopes = away(*at)
        got, wanted = (
            [values[number], *slopes[number]],
            exact(AWAY[number].replace(sp.sinc, lambda a: sp.sin(a) / a), at, apart=mpmath.mpf("1e-40")),
        )
        largest = max(map(abs, wanted))
        assert max(abs(a - b) for a, b in zip(got, wanted, strict=True)) <= UNITS * 2.0**-53 * largest


def test_a_branch_is_no_limit():
    expressions = [
        (sp.log(x) - sp.log(y)) / (x - y),
        (x ** R(1, 3) - y ** R(1, 3)) / (x - y),
        sp.acos(x) / sp.sqrt(1 - x**2),
    ]
    kernel = chasles.compile([*expressions, sp.asinh(sp.sqrt(x)) / sp.sqrt(x)], [x, y])
    # A root is divided by, and beside it what vanishes.
    assert chasles.compile(y**2 * (1 / sp.sqrt(1 - x**2 / y**2) - 1), [x, y])(0.6, 1.0) == pytest.approx(0.25)
    assert chasles.compile((x ** R(1, 9) - 1) / (x**3 - 1), [x])(1.0) == pytest.approx(1 / 27)
    assert chasles.compile((sp.log(x**2 + 3) - 2 * sp.log(2)) / (x - 1), [x])(1.0) == 0.5
    assert np.isfinite(chasles.compile(sp.coth(x + x / y) - sp.coth(x / y) / y, [x, y])(1.0, 2.0))
    with np.errstate(invalid="ignore"):
        assert all(map(math.isnan, [*kernel(-1.0, -1.0)[:2], *kernel(1.3, 1.0)[2:3], kernel(-1.0, 0.0)[3]]))


def test_at_the_limit_itself_all_have_values(kernel):
    assert all(np.isfinite(part).all() for part in kernel(0.0, 0.0, 0.0))


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    "expression",
    [
        *(sp.sin(x) / x**2, sp.cos(x) / x, 1 / sp.sin(x), sp.sin(y) / x, sp.sin(x + y) / x, sp.sin(x) / (x + y), 1 / x),
        *(sp.exp(x) / x, sp.sinh(x) / x**2, sp.log(1 + y) / x, sp.coth(x), (sp.exp(x) - 1 - y) / x),
        *(1 / (sp.erf(y) - 2) / x, sp.cos(sp.atan2(0, y)) / x, 1 / sp.Max(0, x + sp.sqrt(y))),
    ],
    ids=str,
)
def test_what_has_no_limit_has_no_value(expression):
    with np.errstate(invalid="ignore"):
        assert math.isnan(chasles.compile(expression, [x, y])(0.0, 0.0))


def test_away_from_a_limit_a_formula_is_as_it_stands():
    """Written for where the angle is small, it would overflow."""
    kernel = chasles.compile([sp.tanh(x) / x, 1 / x - 1 / (sp.exp(x) - 1), sp.coth(x) - 1 / x], [x])
    assert kernel(1000.0) == (1 / 1000, 1 / 1000, 1 - 1 / 1000)
    assert kernel(-1000.0) == (1 / 1000, 1 - 1 / 1000, 1 / 1000 - 1)
    turned = chasles.compile([2 * sp.atan2(r, y) / r, sp.acos(z) / sp.sqrt(1 - z**2)], [x, y, z])
    assert turned(3.0, 0.0, 0.0) == pytest.approx((math.pi / 3, math.pi / 2))
    assert turned(0.6, -0.8, 0.0)[0] == pytest.approx(2 * math.atan2(1.0, -0.8))
    around = chasles.compile(sp.atan2(x, y) / x, [x, y])
    assert [around(1e-9, y) for y in (1.0, -1.0)] == [1.0, math.atan2(1e-9, -1.0) / 1e-9]


def test_on_both_sides_of_a_root():
    """The functions of Stumpff, as orbits of any kind have them."""
    up, down = sp.sqrt(x), sp.sqrt(-x)
    kernel = chasles.compile(
        sp.Piecewise(((1 - sp.cos(up)) / x, x > 0), ((1 - sp.cosh(down)) / x, True)), [x], jacobian=True
    )
    for at in (-30.0, -1.0, -1e-9, 0.0, 1e-9, 1.0, 30.0):
        with mpmath.workdps(60):
            terms = [(-mpmath.mpf(at)) ** n / mpmath.factorial(2 * n + 2) for n in range(60)]
            slopes = [-n * (-mpmath.mpf(at)) ** (n - 1) / mpmath.factorial(2 * n + 2) for n in range(1, 60)]
        assert kernel(at) == pytest.approx((float(sum(terms)), float(sum(slopes))), rel=4e-15)


def test_the_functions_of_stumpff_in_three_cases():
    up, down = sp.sqrt(x), sp.sqrt(-x)
    cases = ((up - sp.sin(up)) / up**3, x > 0), ((sp.sinh(down) - down) / down**3, x < 0), (R(1, 6), True)
    found = chasles.compile(sp.Piecewise(*cases), [x])(np.array([0.7, 0.0, -0.7, 30.0, -30.0]))
    exact = [sum((-at) ** n / math.factorial(2 * n + 3) for n in range(40)) for at in (0.7, 0.0, -0.7, 30.0, -30.0)]
    np.testing.assert_allclose(found, exact, rtol=1e-14)


def test_a_logarithm_of_one_and_an_exponential_does_not_overflow():
    kernel = chasles.compile(sp.log(1 + sp.exp(x)), [x], jacobian=True)
    assert [kernel(at) for at in (800.0, 0.0, -800.0)] == [(800.0, 1.0), (math.log(2), 0.5), (0.0, 0.0)]
    kernel = chasles.compile(sp.log(sp.cosh(x * y)) / y, [x, y], jacobian=True, wrt=x)
    assert kernel(-1000.0, 2.0) == (1000.0 - math.log(2) / 2, -1.0)


@pytest.mark.parametrize(
    ("left", "is_zero"),
    [
        *(((x + y) ** 2 - x**2 - 2 * x * y - y**2, True), ((x**2 - y**2) / (x + y) - x + y, True)),
        *((sp.sqrt(x + y) * (1 + sp.sqrt(x + y)) - x - y - sp.sqrt(x + y), True), (x - y, False)),
        *((sp.sqrt(x**2 + 2 * x * y + y**2) - x - y, False), ((sp.sqrt(2) + x) ** 2 - 2 - x**2, False)),
    ],
)
def test_what_vanishes_is_seen(left, is_zero):
    assert vanishes(left) == is_zero


def test_a_piece_that_is_no_limit_stays():
    assert without_removable(sp.Piecewise((sp.sin(x) / x, sp.Ne(x, 0)), (2, True))).has(sp.Piecewise)
    assert without_removable(sp.Piecewise((sp.sin(x) / x, sp.Ne(x, 1)), (1, True))).has(sp.Piecewise)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("order", range(8))
def test_the_functions_of_stumpff(order):
    kernel = chasles.compile(Stumpff(order, x), x)
    angles = np.array([0.0, 5e-324, 1e-8, 0.1, 1.0, 2.0, 3.0, 3.5, 4.0, 5.0, 7.0, 20.0])
    with np.errstate(invalid="ignore"):
        values = kernel.array_api(angles)
    for a, got in zip(angles, values, strict=True):
        with mpmath.workdps(60):
            square = -(mpmath.mpf(a) ** 2)
            wanted = sum(square**n / mpmath.factorial(2 * n + order) for n in range(100))
        assert got == pytest.approx(float(wanted), rel=2e-15, abs=1e-16)


LENGTHS = [
    *(sp.sqrt(x**2 + y**2), sp.sqrt(x**2 + 4 * y**2 + z**2), sp.sqrt((x - y) ** 2 + (y + z) ** 2)),
    *(
        x / sp.sqrt(x**2 + y**2),
        x / (x**2 + y**2),
        x * y / (x**2 + z**2),
        x * y * z / (x**2 + y**2) ** sp.Rational(3, 2),
    ),
    *(x / sp.sqrt(x**2 + y**2) + z / sp.sqrt(z**2 + y**2), x / r, r, y / r),
]


@pytest.fixture(scope="module")
def lengths():
    return chasles.compile(sp.Matrix(LENGTHS), [x, y, z])


@pytest.mark.parametrize("scale", [1e200, 1e154, 1.0, 1e-154, 1e-200, 1e-300])
@pytest.mark.parametrize("number", range(len(LENGTHS)), ids=lambda number: str(LENGTHS[number]))
def test_lengths_neither_overflow_nor_vanish(lengths, number, scale):
    point = [scale * value for value in (3.0, 4.0, -2.0)]
    with mpmath.workdps(50):
        wanted = float(sp.lambdify([x, y, z], LENGTHS[number], "mpmath")(*map(mpmath.mpf, point)))
    assert lengths(*point)[number] == pytest.approx(wanted, rel=2e-15)


FORMS = [
    *(sp.sqrt(x**2 - y**2), x / sp.sqrt(x**2 - y**2), x * y / (x**2 - y**2), sp.sqrt(y**2 - 4 * x * z)),
    *(x**2 / (x**2 + 2 * x * y - y**2), x * y * z / (x**3 - y**3), (x**2 + y**2) / (x**2 - y**2)),
    *(sp.sqrt(1 + x**2), x / sp.sqrt(1 + x**2 + 4 * y**2), sp.sqrt(3 + 2 * (x - y) ** 2) / z),
    *(sp.log(x**2), sp.sqrt(1 + x**2) * sp.sqrt(1 + z**2) / x),
]


@pytest.fixture(scope="module")
def forms():
    return chasles.compile(sp.Matrix(FORMS), [x, y, z])


@pytest.mark.parametrize("scale", [1e200, 1e155, 1.0, 1e-154, 1e-162, 1e-200])
@pytest.mark.parametrize("number", range(len(FORMS)), ids=lambda number: str(FORMS[number]))
def test_forms_of_any_sign_and_with_constants_are_in_range(forms, number, scale):
    point = [scale * value for value in (3.0, 2.0, -1.0)]
    with mpmath.workdps(50):
        wanted = sp.lambdify([x, y, z], FORMS[number], "mpmath")(*map(mpmath.mpf, point))
    assert forms(*point)[number] == pytest.approx(float(wanted), rel=4e-15)


A, B, C = sp.symbols("a b c", real=True)
CANCELLING = [
    *(
        (sp.sin(x) - x * sp.cos(x), [x]),
        (sp.tan(x) - x, [x]),
        (sp.sinh(x) - sp.sin(x), [x]),
        (sp.sin(x) - sp.tan(x), [x]),
    ),
    *((x * sp.exp(x) - sp.exp(x) + 1, [x]), ((1 + x) * sp.log(1 + x) - x, [x]), (sp.sqrt(1 + x) - 1 - x / 2, [x])),
    *(
        (sp.exp(sp.sin(x)) - 1 - x, [x]),
        (sp.sqrt(2 - 2 * sp.cos(x) - x * sp.sin(x)), [x]),
        (sp.exp(x) - sp.cos(x), [x]),
    ),
    *((y * sp.sin(x * z) - y * x * z * sp.cos(x * z) + x, [x, y, z]), (sp.sin(r) - r * sp.cos(r), [x, y, z])),
    *((sp.log((1 + x) / (1 - x)), [x]), (1 / sp.log((y + x) / y), [x, y]), (sp.log((2 + x) / (2 + 3 * x)), [x])),
    *(
        (sp.sqrt(1 + x) - sp.sqrt(1 - x), [x]),
        (sp.sqrt(y**2 + x**2) - y, [x, y]),
        (sp.sqrt(x + y) - sp.sqrt(y), [x, y]),
    ),
    *(((-A + sp.sqrt(A**2 - 4 * B * x)) / (2 * B), [x, A, B]), ((-A - sp.sqrt(A**2 - 4 * B * x)) / (2 * B), [x, A, B])),
]
"""Sums that come to little near x = 0, beside their terms."""


@pytest.mark.parametrize(("expression", "symbols"), CANCELLING, ids=str)
@pytest.mark.parametrize("at", [1e-3, 1e-5, -1e-8, 0.3])
def test_what_cancels_is_computed_otherwise(expression, symbols, at):
    point = [at, *([-1.25, 0.75] if at < 0 else [1.5, 0.75])[: len(symbols) - 1]]
    if expression.subs(dict(zip(symbols, point, strict=True))).is_real is False:
        pytest.skip("there is no value")
    value, slopes = chasles.compile(expression, symbols, jacobian=True)(*point)
    rows = [expression, *(sp.diff(expression, by) for by in symbols)]
    with mpmath.workdps(200):
        wanted = [float(each) for each in sp.lambdify(symbols, rows, "mpmath")(*map(mpmath.mpf, point))]
    assert [value, *np.atleast_1d(slopes)] == pytest.approx(wanted, rel=2e-13)


@pytest.mark.parametrize("scale", [1e-200, 1.0, 1e200])
def test_what_is_computed_otherwise_is_in_range(scale):
    value, slopes = chasles.compile(sp.sqrt(x**2 + y**2) - y, [x, y], jacobian=True)(3 * scale, 4 * scale)
    assert value == pytest.approx(scale, rel=1e-15)
    assert slopes == pytest.approx([0.6, -0.2], rel=1e-14)


@pytest.mark.parametrize(
    ("expression", "point"),
    [
        (sp.beta(x, y), (100.5, 94.25)),
        (sp.binomial(x, y), (300.5, 150.0)),
        (sp.gamma(x + y) / sp.gamma(x), (500.0, 0.5)),
    ],
    ids=str,
)
def test_quotients_of_gamma_functions_that_overflow_are_in_range(expression, point):
    for at in (point, (4.5, 2.25)):
        with mpmath.workdps(50):
            wanted = sp.lambdify([x, y], expression.rewrite(sp.gamma), "mpmath")(*map(mpmath.mpf, at))
        assert float(chasles.compile(expression, [x, y])(*at)) == pytest.approx(float(wanted), rel=1e-12)


def test_a_limit_that_is_not_taken_is_named_as_given():
    with pytest.raises(ValueError, match=r"Limit\(sin\(x\)/x, x, 0.*\) is not evaluated .*call \.doit\(\) first"):
        chasles.compile(y * sp.Limit(sp.sin(x) / x, x, 0), [y])


def test_means_of_differences_that_meet():
    """The logarithmic mean of temperature differences."""
    mean = ((x - y) - (A - B)) / sp.log((x - y) / (A - B))
    kernel = chasles.compile(mean, [x, y, A, B], jacobian=True)
    for apart in (0.0, 1e-7, 1e-3):
        value, slopes = kernel(90, 20, 80, 10 + apart)
        assert value == pytest.approx(70 - apart / 2, rel=1e-10)
        assert slopes == pytest.approx([0.5, -0.5, 0.5, -0.5], rel=1e-4)


@pytest.mark.parametrize("power", [3, 5, 7])
def test_the_root_of_an_odd_power_is_divided_by_as_it_stands(power):
    kernel = chasles.compile((sp.sqrt(x) - sp.sin(sp.sqrt(x))) / sp.sqrt(x**power), [x])
    assert sum(kernel.operations.values()) < 40
    for at in (1e-3, 1e-8, 0.5):
        with mpmath.workdps(60):
            root = mpmath.sqrt(at)
            assert float(kernel(at)) == pytest.approx(float((root - mpmath.sin(root)) / root**power), rel=1e-14)


@pytest.mark.parametrize("large", [1e100, 1e150])
def test_products_of_small_and_large_numbers_are_divided_by(large):
    kernel = chasles.compile([x / (y * z), x / (y**2 * z), sp.sqrt(y * z)], [x, y, z])
    assert kernel(3.0, 2 / large, large) == pytest.approx((1.5, 0.75 * large, math.sqrt(2)), rel=1e-14)


def test_a_form_that_is_zero_is_not_divided_by():
    """Neither where its scale is one of the inputs, nor where all are small."""
    kernel = chasles.compile(x / (x**2 - 9 * y**2), [x, y])
    with np.errstate(invalid="ignore"):
        assert all(math.isnan(kernel(3 * a, a)) for a in (1.0, 2.0**-500, 2.0**500, 0.0))


def test_beside_a_constant_infinity_stays():
    kernel = chasles.compile(sp.sqrt(1 + x**2), [x])
    assert kernel(-math.inf) == math.inf
    assert math.isnan(kernel(math.nan))
    assert kernel(0.75) == 1.25


@pytest.mark.parametrize("of", [x, -x, 2 * x], ids=str)
def test_what_is_left_has_the_sign_of_the_divisor(of):
    divided = chasles.compile([sp.Mod(of, 3), sp.Mod(of, -3), sp.Mod(of, y)], [x, y])
    for way in (divided, divided.array_api):
        for at in (0.0, -0.0, 3.0, -3.0, 1.25, -1.25, 6.0, 1e300):
            for by in (3.0, -3.0):
                value = float(of.subs(x, 1)) * at
                wanted = [value % 3.0, value % -3.0, value % by]
                assert [math.copysign(1, each) for each in way(at, by)] == [math.copysign(1, w) for w in wanted]
                assert list(way(at, by)) == wanted


def test_near_one_the_inverse_secant_keeps_its_digits():
    kernel = chasles.compile(sp.asech(x), [x])
    for at in (1 - 2.0**-53, 1 - 1e-9, 0.5, 1e-300, 5e-324):
        with mpmath.workdps(60):
            assert kernel(at) == pytest.approx(float(mpmath.asech(at)), rel=4e-16)
    with np.errstate(invalid="ignore"):
        assert math.isnan(kernel(1.5))


@pytest.mark.parametrize(
    "expression", [sp.Abs(x), sp.sqrt(x**2), sp.Max(sp.Abs(x), 0), sp.Abs(-x), sp.Abs(3 * x)], ids=str
)
def test_no_size_is_a_negative_zero(expression):
    kernel = chasles.compile(sp.atan2(expression, y), [x, y])
    for way in (kernel, kernel.array_api):
        assert way(-0.0, -1.0) == math.pi
        assert way(0.0, -1.0) == math.pi


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    "expression",
    [
        sp.exp(x) * sp.sin(y) / y,
        (x**2 + 1) ** y * (1 - sp.cos(y)) / y**2,
        sp.exp(sp.sin(y) / y) * sp.sin(y) / y,
        2**x * sp.tan(y) / y,
        x * (1 - sp.cos(sp.tanh(sp.pi))) / sp.tanh(sp.pi) ** 2 + sp.sin(y) / y,
        sp.Piecewise((x, x > sp.sin(sp.Rational(1, 4) - sp.cos(2)) / (sp.Rational(1, 4) - sp.cos(2))), (y, True)),
    ],
    ids=str,
)
def test_beside_powers_and_constants(expression: sp.Expr) -> None:
    kernel = chasles.compile(expression, [x, y])
    for point in ((0.3, 0.7), (1.5, -0.2)):
        expected = float(expression.subs({x: sp.Rational(point[0]), y: sp.Rational(point[1])}).evalf(30))
        assert kernel(*point) == pytest.approx(expected, rel=1e-14)
    assert np.isfinite(kernel(0.3, 0.0))


def test_what_is_shared_is_looked_at_once():
    """In the tree it stands a million times, which would take minutes."""
    shared = x
    for _ in range(20):
        shared = sp.Mul(sp.sin(shared, evaluate=False), sp.Add(shared, y, evaluate=False), evaluate=False)
    whole = sp.Add(sp.Pow(shared, -1, evaluate=False), shared, evaluate=False)
    with at_most(calls=10_000_000):
        found = without_removable(whole)
    assert found.has(sp.sin)


e = sp.exp
GROWING = [
    *(
        1 / (1 + e(-x)),
        e(x) / (1 + e(x)),
        e(x) / (e(x) + e(y) + e(2 * z)),
        sp.log(e(x) + e(y)),
        sp.log(e(x) + 2 * e(y) + 1),
    ),
    *(
        (e(x) - e(-x)) / (e(x) + e(-x)),
        (e(2 * x) - 1) / (e(2 * x) + 1),
        x**3 / (e(x) - 1),
        x**2 * e(x) / (e(x) - 1) ** 2,
    ),
    *(sp.log(1 - e(-(x**2))), sp.cosh(x) ** -2, 1 / (e((x - y) / z) - 1), (1 - e(-x)) / (1 - y * e(-x) / 2)),
    *((1 + x**2) ** y / (1 + (1 + x**2) ** y), 1 / (1 + (x**2 + y**2) ** -z), z**y / (z**y + (1 + x**2) ** y)),
    *(y**2 * sp.log(y), y * (sp.log(y / z) - 1), -y * sp.log(y) - (1 - y) * sp.log(1 - y), sp.sqrt(y) * sp.log(y) * x),
]


def test_what_grows_beyond_all_bounds_is_no_part_of_what_does_not(monkeypatch):
    monkeypatch.setenv("CC", "no-such-compiler")
    made = chasles.compile(sp.Matrix(GROWING), [x, y, z], jacobian=True)
    rows = [sp.lambdify([x, y, z], [f, *(f.diff(s) for s in (x, y, z))], "mpmath") for f in GROWING]
    for point in ((800.0, 0.4, 0.7), (-800.0, 0.4, 0.7), (37.5, 0.4, 2.0), (-3.0, 0.1, 900.0), (0.3, 1e-200, 0.9)):
        values, slopes = made(*point)
        for number, row in enumerate(rows):
            with mpmath.workdps(900):
                wanted = [float(value) for value in row(*map(mpmath.mpf, point))]
            got = [values[number], *slopes[number]]
            np.testing.assert_allclose(got, wanted, rtol=1e-12, atol=1e-300, err_msg=str(GROWING[number]))
    values, slopes = made(1.0, 0.0, 0.5)
    assert not values[-4:].any()
    assert slopes[-4].tolist() == [0.0, 0.0, 0.0]
    assert slopes[-2][1] == np.inf
    with np.errstate(all="ignore"):
        assert made(np.inf, np.inf, 1.0)[0][3:5].tolist() == [np.inf, np.inf]
        assert made(-np.inf, -np.inf, 1.0)[0][3:5].tolist() == [-np.inf, 0.0]


def test_any_number_of_points_may_meet(monkeypatch):
    """Chains of decays, of three and of four rates."""
    monkeypatch.setenv("CC", "no-such-compiler")
    rates, t = sp.symbols("a b c d"), sp.Symbol("t")
    chains = [
        sp.prod(some[:-1]) * sum(e(-k * t) / sp.prod(j - k for j in some if j != k) for k in some)
        for some in (rates[:3], rates)
    ]
    made = chasles.compile(sp.Matrix(chains), [*rates, t], jacobian=True)
    rows = [sp.lambdify([*rates, t], [f, *(f.diff(s) for s in (*rates, t))], "mpmath") for f in chains]
    for point in (
        (1, 1, 1, 1, 2),
        (1, 1, 1, 3, 0.5),
        (0.5, 0.5, 2, 2, 1),
        (1, 1.001, 1, 0.999, 3),
        (9, 0.1, 2, 0.1, 4),
    ):
        values, slopes = made(*point)
        for value, slope, row in zip(values, slopes, rows, strict=True):
            with mpmath.workdps(300):
                apart = [mpmath.mpf(number) + mpmath.mpf(k) / 10**40 for k, number in enumerate(point)]
                wanted = [float(number) for number in row(*apart)]
            np.testing.assert_allclose([value, *slope], wanted, rtol=1e-11, atol=1e-14)
