"""Exact numbers: one form, their sign, and whether they are zero."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import mpmath
import pytest
import sympy as sp
from mpmath.ctx_iv import MPIntervalContext
from mpmath.libmp import to_rational

from chasles.exact.enclosures import enclosed
from chasles.exact.grammar import read_number
from chasles.exact.numbers import NotDecided, angle, decimals, is_zero, normal, root, sign
from chasles.exact.spelling import text_of


def nested(draw: Random, depth: int) -> sp.Expr:
    """A number made by arithmetic and square roots."""
    if depth == 0:
        return sp.Rational(draw.randint(-5, 5), draw.randint(1, 4))
    one, other = nested(draw, depth - 1), nested(draw, depth - 1)
    match draw.randint(0, 3):
        case 0:
            return one + other
        case 1:
            return one * other
        case 2:
            return sp.sqrt(one if sign(one) >= 0 else -one)
        case _:
            return one if is_zero(other) else one / other


def in_digits(value: sp.Expr) -> mpmath.mpf:
    """The value, with mpmath's own arithmetic."""
    return sp.lambdify((), value, "mpmath")()


@pytest.mark.sampled(5)
@pytest.mark.parametrize("seed", range(150))
def test_the_normal_form_has_the_same_value(seed: int) -> None:
    value = nested(Random(seed), 4)
    with mpmath.workdps(120):
        expected = in_digits(value)
        assert abs(expected - in_digits(normal(value))) < mpmath.mpf(10) ** -60 * (1 + abs(expected))
        assert sign(value) == (0 if is_zero(value) else mpmath.sign(expected))
        assert is_zero(value) == (abs(expected) < mpmath.mpf(10) ** -60)
    assert normal(value - normal(value)) == 0


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("sqrt(5 + 2*sqrt(6))", "sqrt(2) + sqrt(3)"),
        ("sqrt(12)", "2*sqrt(3)"),
        ("1/(sqrt(2) + sqrt(3) + sqrt(5))", "-sqrt(30)/12 + sqrt(3)/6 + sqrt(2)/4"),
        ("sqrt(2 + sqrt(2))*sqrt(2 - sqrt(2))", "sqrt(2)"),
        ("sin(2*asin(1/3))", "4*sqrt(2)/9"),
        ("cos(pi/12)", "sqrt(2)/4 + sqrt(6)/4"),
        ("cos(pi/16)^2 + sin(pi/16)^2", "1"),
    ],
)
def test_denested(text: str, expected: str) -> None:
    assert is_zero(read_number(text) - read_number(expected))
    assert text_of(read_number(text)) == text_of(normal(read_number(expected)))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("cos(pi/7) - cos(2*pi/7) + cos(3*pi/7) - 1/2", 0),
        ("cos(pi/7) - cos(2*pi/7) + cos(3*pi/7) - 1/3", 1),
        ("sqrt(2) + sqrt(3) - sqrt(10)", -1),
        ("sqrt(16 - 2*sqrt(29) + 2*sqrt(55 - 10*sqrt(29))) - sqrt(5) - sqrt(11 - 2*sqrt(29)) + sqrt(1)/10^64", 1),
        (
            "sqrt(5) + sqrt(22 + 2*sqrt(5)) - sqrt(11 + 2*sqrt(29)) - sqrt(16 - 2*sqrt(29) + 2*sqrt(55 - 10*sqrt(29)))",
            0,
        ),
        ("pi - 22/7", -1),
        ("pi*sqrt(2)/sqrt(8) - pi/2", 0),
        ("acos(1/3) - acos(1/4)", -1),
    ],
)
def test_signs(text: str, expected: int) -> None:
    value = read_number(text)
    assert sign(value) == expected
    assert is_zero(value) == (expected == 0)


def test_what_nothing_decides_is_not_guessed() -> None:
    with pytest.raises(NotDecided, match="nothing decides whether"):
        is_zero(sp.sqrt(1 + sp.cos(2)) - sp.sqrt(2) * sp.cos(1))
    assert is_zero(sp.sqrt(1 + 2 * sp.pi + sp.pi**2) - sp.pi - 1)


def test_the_root_of_a_negative_number_is_refused() -> None:
    with pytest.raises(ValueError, match="which is negative"):
        root(sp.sqrt(2) - 2)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("below", [1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 30])
def test_rational_multiples_of_pi_are_found(below: int) -> None:
    for above in range(-below + 1, below + 1):
        turn = sp.Rational(above, below)
        cosine, sine = normal(sp.cos(turn * sp.pi)), normal(sp.sin(turn * sp.pi))
        assert angle(cosine, sine) == turn * sp.pi


def test_other_angles_stay_inverse_functions() -> None:
    assert angle(sp.Rational(1, 3), 1) == sp.acos(sp.Rational(1, 3))
    assert angle(sp.Rational(1, 3), -1) == -sp.acos(sp.Rational(1, 3))


def test_free_symbols_are_carried_along() -> None:
    a, h = sp.symbols("a h", positive=True)
    assert is_zero((a + h * sp.sqrt(2)) * (a - sp.sqrt(8) * h / 2) - a**2 + 2 * h**2)
    assert normal((a**2 - h**2) / (a - h)) == a + h
    assert not is_zero(a - h)


@pytest.mark.parametrize(
    ("text", "zero"),
    [
        ("sin(1)^2 + cos(1)^2 - 1", True),
        ("sin(1)^2 - cos(1)^2 - 1", False),
        ("cos(3/10) - cos(1/10)*cos(1/5) + sin(1/10)*sin(1/5)", True),
        ("cos(3/10) - cos(1/10)*cos(1/5) - sin(1/10)*sin(1/5)", False),
        ("sin(2/3)*sqrt(2) - sqrt(8)*sin(1/3)*cos(1/3)", True),
        ("cos(pi/7)*sin(1)^2 + cos(pi/7)*cos(1)^2 - cos(pi/7)", True),
        ("(tan(1/2)^2 + 1)*cos(1/2)^2 - 1", True),
        ("cos(1) - 54030230586813971740/10^20", False),
    ],
)
def test_cosines_of_rational_angles(text: str, zero: bool) -> None:
    assert is_zero(read_number(text)) is zero


def test_fractions_are_exact() -> None:
    assert normal(Fraction(1, 3)) == sp.Rational(1, 3)


@pytest.mark.parametrize("text", ["sqrt(sin(1)) + cos(1)", "sqrt(1 + 2*sin(1)^2)", "sqrt(sin(1)^3) - sin(2)"])
def test_roots_of_sines_are_known_not_to_vanish(text: str) -> None:
    value = read_number(text)
    assert not is_zero(value)
    assert sign(value) == mpmath.sign(in_digits(value))


def test_a_number_that_grows_too_long_is_declined() -> None:
    value = sp.prod(sp.sin(sp.Rational(1, k)) + sp.sqrt(sp.sin(1)) * k for k in range(1, 200))
    with pytest.raises(NotDecided, match="beyond 800 operations"):
        normal(value)
    assert not is_zero(value)


def test_decimals_are_those_of_both_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    """Near a right angle SymPy's decimals of a cotangent lose digits; an enclosure without ends tells none."""
    near = sp.cot(sp.pi / 2 - sp.pi / 10**15)
    assert decimals(near, 15) == str(sp.Float(sp.pi.n(40) / 10**15, 15))
    assert decimals(sp.sqrt(2) - sp.Rational("1.4142135623730950488016887"), 3) == "2.42e-26"
    nothing = MPIntervalContext().mpf(["-inf", "inf"])
    monkeypatch.setattr("chasles.exact.numbers.enclosed", lambda *_: nothing)
    with pytest.raises(NotDecided, match="nothing tells 10 digits"):
        decimals(sp.cot(sp.Rational(1, 7)))


@pytest.mark.sampled(5)
@pytest.mark.parametrize("bits", [64, 700])
@pytest.mark.parametrize(
    "coefficients", [(1, 0, -3, 1), (7, 0, 0, -(2 * 10**40), 0, 1), (1, 0, 0, 0, 0, -2 * 10**24, 4 * 10**12, -2)]
)
def test_roots_of_polynomials_are_enclosed(coefficients: tuple[int, ...], bits: int) -> None:
    polynomial = sp.Poly(coefficients, sp.Symbol("x"))
    for index in range(polynomial.count_roots()):
        root_of = sp.CRootOf(polynomial, index, radicals=False)
        ends = [sp.Rational(*map(int, to_rational(end))) for end in enclosed(root_of, bits)._mpi_]
        assert ends[1] - ends[0] < sp.Rational(32, 2**bits) * (1 + abs(ends[0]))
        assert ends[0] <= root_of.eval_rational(sp.Rational(1, 2 ** (bits + 9))) <= ends[1]
