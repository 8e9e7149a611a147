"""Integrals between limits in declared statements: decided, refuted, repaired; undecided where of no polynomial."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy

from chasles.checker.certificate import check
from chasles.decisions.session import Session
from chasles.lowering.lower import lower
from chasles.numerics.reference import evaluate
from chasles.repairs.repair import repair
from chasles.statements import Claim, Definition, Kernel, nonzero
from chasles.vocabulary import (
    LENGTH,
    MASS,
    PI,
    Misfit,
    Node,
    Symbol,
    cos,
    dot,
    latex,
    matrix,
    number,
    plain,
    row,
    scalar,
    sin,
    square,
    tr,
    uniform,
    vector,
)
from chasles.vocabulary.antiderivatives import Oscillation, oscillations_in
from chasles.vocabulary.definite_integrals import definite_integral
from chasles.vocabulary.functions import cases, cosh, exp, log, maximum, sign, sinh, sqrt
from chasles.vocabulary.hadamard import hadamard_product
from chasles.vocabulary.partial import partial
from chasles.vocabulary.products import outer

UNITS = False
x, l, a, k = (scalar(name, name, "a number") for name in ("x", "l", "a", "k"))
N_1, N_2 = scalar("N_1", "N_1", "a shape function"), scalar("N_2", "N_2", "another")
N = Symbol("N", r"\mathbf{N}", uniform((1, 2)), "shape functions")
B = Symbol("B", r"\mathbf{B}", uniform((1, 2)), "their slopes")
K = Symbol("K", r"\mathbf{K}", uniform((2, 2)), "stiffness")
A, H = square("A", "A", "a matrix"), square("H", "H", "another")
u, v = vector("u", "u", "a vector"), vector("v", "v", "another")
first, second = Definition("1", N_1, 1 - x / l), Definition("2", N_2, x / l)
shapes = Definition("3", N, row(N_1, N_2), given=(first, second))
slopes = Definition("4", B, partial(N, x), given=(shapes,))
GIVEN = (slopes, shapes, first, second)


def claim(left: Node, right: Node) -> Claim:
    return Claim("5", left, right, given=GIVEN, assuming=(nonzero(l),))


TRUE = [
    (definite_integral(x**2, x, a, l), (l**3 - a**3) / 3),
    (definite_integral(3, x, a, l), 3 * (l - a)),
    (definite_integral(0 * x, x, 0, l), number(0)),
    (definite_integral(N_1 * N_2, x, 0, l), l / 6),
    (definite_integral(N.T @ N, x, 0, l), l / 6 * matrix((2, 1), (1, 2))),
    (definite_integral(k * B.T @ B, x, 0, l), k / l * matrix((1, -1), (-1, 1))),
    (definite_integral((x * u - a * v).T @ (x * u - a * v), x, 0, 1), dot(u, u) / 3 - a * dot(u, v) + a**2 * dot(v, v)),
    (definite_integral((A + x * H) @ (A + x * H), x, 0, 1), A @ A + (A @ H + H @ A) / 2 + H @ H / 3),
    (definite_integral(tr(x * A), x, -1, 1), number(0)),
    (definite_integral(cos(a) * x, x, 0, 2), 2 * cos(a)),
    (definite_integral(definite_integral(x * k, k, 0, x), x, 0, l), l**4 / 8),
    (definite_integral(x, x, x, l), (l**2 - x**2) / 2),
    (partial(definite_integral(a * x**2, x, 0, l), l), a * l**2),
    (definite_integral(x * partial(x**3, x), x, 0, l), l**4 - definite_integral(x**3, x, 0, l)),
]


@pytest.mark.parametrize(("left", "right"), TRUE, ids=plain)
def test_what_is_true_is_proved_and_a_slip_is_refuted(left: Node, right: Node) -> None:
    said = claim(left, right)
    verdict = Session().decide(said).verdict
    assert verdict.true, verdict.reason
    check(said, "printed", verdict.certificate)
    assert Session().decide(claim(left, right + right + left)).verdict.wrong or right == number(0)


def test_what_is_wrong_beside_an_integral_is_repaired() -> None:
    (found, *_) = repair(claim(definite_integral(N.T @ N, x, 0, l), l / 6 * matrix((2, 1), (1, 3))))
    assert found.right == l / 6 * matrix((2, 1), (1, 2))


@pytest.mark.parametrize(
    "of",
    [
        sin(x**2),
        exp(1 / x),
        cos(sin(x)),
        log(x),
        sqrt(x),
        sin(sqrt(a) * x) * sin(sqrt(k) * x),
        1 / x,
        N_2 / N_1,
        maximum(x, 0),
        cases((x, x < a), otherwise=a),
        (x * u).T @ A @ u / (x + 1),
    ],
    ids=plain,
)
def test_what_is_no_polynomial_is_undecided(of: Node) -> None:
    verdict = Session().decide(claim(definite_integral(of, x, 0, l), number(0))).verdict
    assert verdict.name == "undecided"
    assert "integrated between limits" in verdict.reason


PHI, C = scalar("phi", "phi", ""), scalar("c", "c", "")
OF_FUNCTIONS: list[tuple[Node, Node]] = [
    (definite_integral(sin(x), x, 0, PI), number(2)),
    (definite_integral(sin(x) ** 2, x, 0, 2 * PI), PI),
    (definite_integral(sin(x) * cos(x), x, 0, 2 * PI), 0 * PI),
    (definite_integral(sin(x) ** 3, x, 0, PI), number(Fraction(4, 3))),
    (definite_integral(x * cos(x), x, 0, PI / 2), PI / 2 - 1),
    (definite_integral(x**2 * sin(x), x, 0, PI), PI**2 - 4),
    (definite_integral(1 - k * cos(x), x, 0, a), a - k * sin(a)),
    (definite_integral(exp(-2 * x), x, 0, a), (1 - exp(-2 * a)) / 2),
    (definite_integral(exp(x) * cos(x), x, 0, PI), -(exp(PI) + 1) / 2),
    (definite_integral(x * exp(-x), x, 0, a), 1 - (1 + a) * exp(-a)),
    (definite_integral(sin(PI * x / l) ** 2, x, 0, l), l / 2),
    (definite_integral(sin(PI * x / l) * sin(2 * PI * x / l), x, 0, l), 0 * l),
    (definite_integral(cos(x + PHI), x, 0, a), sin(a + PHI) - sin(PHI)),
    (definite_integral(cosh(x), x, 0, a), sinh(a)),
    (definite_integral((cos(x) * u + sin(x) * v).T @ (cos(x) * u + sin(x) * v), x, 0, 2 * PI),
     PI * (dot(u, u) + dot(v, v))),
    (definite_integral(sin(2 * a * k * x) * sin(k * a * 2 * x), x, 0, 0), 0 * a),
]  # fmt: skip


@pytest.mark.parametrize(("left", "right"), OF_FUNCTIONS, ids=plain)
def test_integrals_of_functions_of_multiples(left: Node, right: Node) -> None:
    said = claim(left, right)
    verdict = Session().decide(said).verdict
    assert verdict.true, verdict
    check(said, "printed", verdict.certificate)
    assert Session().decide(claim(left, right + 1)).verdict.wrong


def test_what_is_multiplied_by_the_variable_is_needed_not_to_be_zero() -> None:
    verdict = Session().decide(claim(definite_integral(cos(k * x), x, 0, a), sin(k * a) / k)).verdict
    assert verdict.needs == ("k != 0",)
    beat = definite_integral(sin(k * x) * sin(a * x), x, 0, PI)
    assert any("k" in need and "a" in need for need in Session().decide(claim(beat, beat)).verdict.needs)


def test_antiderivatives_are_those_of_sympy() -> None:
    t = sympy.Symbol("x")
    for of, expected in (
        (x**3 * exp(2 * x) * sin(3 * x), t**3 * sympy.exp(2 * t) * sympy.sin(3 * t)),
        (x**2 * cos(2 * x) ** 2 * cos(x), t**2 * sympy.cos(2 * t) ** 2 * sympy.cos(t)),
        (x * sin(x) * cos(3 * x + 1) * exp(-x), t * sympy.sin(t) * sympy.cos(3 * t + 1) * sympy.exp(-t)),
    ):
        wanted = float(sympy.Integral(expected, (t, 0, 1)).evalf(20))
        [[found]] = evaluate(definite_integral(of, x, 0, 1), {}, digits=30)
        assert abs(float(found) - wanted) < 1e-14


def test_what_depends_on_the_variable_by_another_way_is_undecided() -> None:
    verdict = Session().decide(claim(definite_integral(N_1, N_2, 0, l), l)).verdict
    assert verdict.name == "undecided"


def test_coefficients_are_those_of_the_polynomial() -> None:
    t = sympy.Symbol("x")
    of = (x - 2) ** 3 * (x**2 + 1) / 3 - (1 - x) * x
    found = oscillations_in(of, x)
    expected = sympy.Poly((t - 2) ** 3 * (t**2 + 1) / 3 - (1 - t) * t, t)
    for power in range(6):
        wanted = expected.coeff_monomial(t**power)
        value = found.get(Oscillation(power), number(0))
        assert Session().decide(Claim("6", value, number(Fraction(int(wanted.p), int(wanted.q))))).verdict.true


def test_its_dimension_is_that_of_the_product() -> None:
    length = Symbol("s", "s", uniform((1, 1), LENGTH), "a length")
    mass = Symbol("m", "m", uniform((1, 1), MASS), "a mass")
    assert definite_integral(mass, length, 0, length).measure == (mass * length).measure
    with pytest.raises(Misfit, match="limit"):
        definite_integral(mass, length, 0, mass)
    with pytest.raises(Misfit, match="scalar symbol"):
        definite_integral(a, u, 0, 1)


def test_it_is_printed_with_its_limits() -> None:
    said = definite_integral((x + a) * N, x, -l, l)
    assert latex(said) == r"\int_{-l}^{l} \left( x + a \right) \mathbf{N} \, \mathrm{d}x"
    assert plain(said) == "integral from -l to l of (x + a) N dx"


@pytest.mark.parametrize("of", [sign(x), maximum(x, 0), cases((x, x < a), otherwise=2 * x)], ids=plain)
def test_a_derivative_that_follows_no_rule_is_undecided(of: Node) -> None:
    """It fits together: nothing is wrong in the book."""
    assert Session().decide(Claim("8", partial(of, x), number(0))).verdict.name == "undecided"


def test_products_entry_by_entry() -> None:
    both = hadamard_product(u, v)
    for left, right in (
        (hadamard_product(A, H), hadamard_product(H, A)),
        (hadamard_product(outer(u, u), outer(v, v)), outer(both, both)),
        (u.T @ hadamard_product(A, H) @ v, tr(matrix((u.x, 0, 0), (0, u.y, 0), (0, 0, u.z)) @ A
         @ matrix((v.x, 0, 0), (0, v.y, 0), (0, 0, v.z)) @ H.T)),
    ):  # fmt: skip
        assert Session().decide(Claim("9", left, right)).verdict.true
    assert Session().decide(Claim("9", tr(hadamard_product(A, H)), tr(A @ H))).verdict.wrong
    with pytest.raises(Misfit, match="entry by entry"):
        hadamard_product(A, u)


def test_kernels_are_made_of_integrals_and_derivatives() -> None:
    """Once they were refused: x is free."""
    judge = Session()
    for of in (definite_integral(k * x**2, x, 0, a), definite_integral(k * sin(x), x, 0, a), partial(k * a**3, a)):
        program = lower(Definition("10", l, of, kernel=Kernel(of=(k, a), name="made")), judge.decide)
        assert [each.name for each in program.arguments] == ["k", "a"]
