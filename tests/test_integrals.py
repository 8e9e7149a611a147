"""Integrals between limits, as texts on mechanics have them, decided by their antiderivatives."""

from __future__ import annotations

from typing import Any

import pytest
from sympy import (
    Abs,
    Determinant,
    Eq,
    Expr,
    I,
    Integral,
    Matrix,
    Rational,
    Sum,
    atan,
    conjugate,
    cos,
    cosh,
    exp,
    log,
    oo,
    pi,
    sin,
    sinh,
    sqrt,
    symbols,
    tan,
)

from chasles.from_sympy import integrals
from chasles.prove import Untreatable, prove, recheck

x, y, t, a, b, r, th, ph = symbols("x y t a b r theta phi")
m, R, L, w, T, k, c, g = symbols("m R L omega T k c g", positive=True)
n, i = symbols("n i", integer=True, positive=True)
j, l = symbols("j l", integer=True)

TRUE: list[tuple[Any, Any, set[str]]] = [
    (Integral(m / L * x**2, (x, -L / 2, L / 2)), m * L**2 / 12, set()),
    (Integral(r**3 * m / (pi * R**2), (r, 0, R), (th, 0, 2 * pi)), m * R**2 / 2, set()),
    (Integral(r**4 * sin(th) ** 3, (r, 0, R), (th, 0, pi), (ph, 0, 2 * pi)), 8 * pi * R**5 / 15, set()),
    (w / (2 * pi) * Integral(sin(w * t) ** 2, (t, 0, 2 * pi / w)), Rational(1, 2), set()),
    (Integral(k * x, (x, a, b)), k * (b**2 - a**2) / 2, set()),
    (Integral(g * m / r**2, (r, R, 2 * R)), g * m / (2 * R), set()),
    (Integral(1 / m, (m, R, 2 * R)), log(2), set()),
    (Integral(sqrt(R**2 * sin(t) ** 2 + R**2 * cos(t) ** 2 + c**2), (t, 0, x)), x * sqrt(R**2 + c**2), set()),
    (Integral(exp(-c * t) * cos(w * t), (t, 0, T)),
     (c + exp(-c * T) * (w * sin(w * T) - c * cos(w * T))) / (c**2 + w**2), set()),
    (Integral(exp(a * x), (x, 0, y)), (exp(a * y) - 1) / a, {"a != 0"}),
    (a * Integral(x / a, (x, 0, 1)), Rational(1, 2), {"a != 0"}),
    (Integral(sin(n * x) * sin(2 * n * x), (x, 0, pi)), 0, set()),
    (Integral(cosh(x) ** 2, (x, 0, a)), a / 2 + sinh(2 * a) / 4, set()),
    (Integral(1, (y, -sqrt(x), sqrt(x)), (x, 0, R)), 4 * R ** Rational(3, 2) / 3, set()),
    (Integral(x * Integral(y, (y, 0, x)), (x, 0, 1)), Rational(1, 8), set()),
    (Integral(2**x, (x, 0, 1)), 1 / log(2), set()),
    (Integral(log(x), (x, 1, 2)), 2 * log(2) - 1, set()),
    (Integral(1 / (R + m * x), (x, 0, 1)), log(1 + m / R) / m, set()),
    (Integral(1 / (1 + x**2), (x, -oo, oo)), pi, set()),
    (Integral(atan(x) / (1 + x**2), (x, 0, 1)), pi**2 / 32, set()),
    (Integral(log(x + R) / (x + R), (x, 0, 1)), (log(1 + R) ** 2 - log(R) ** 2) / 2, set()),
    (Integral(sqrt(R**2 - x**2), (x, -R, R)), pi * R**2 / 2, set()),
    (Integral(x**2 * exp(-R * x), (x, 0, oo)), 2 / R**3, set()),
    (Integral(exp(-R * x) * cos(w * x), (x, 0, oo)), R / (R**2 + w**2), set()),
    (Integral(exp(-R * x**2), (x, -oo, oo)), sqrt(pi / R), set()),
    (Integral((x + 3) ** 2 * exp(a * x) * atan(x), (x, a, a)), 0, set()),
    (Integral(exp(I * w * t), (t, 0, T)), (exp(I * w * T) - 1) / (I * w), set()),
    (Matrix([Integral(cos(th), (th, 0, ph)), Integral(sin(th), (th, 0, ph))]), Matrix([sin(ph), 1 - cos(ph)]), set()),
]  # fmt: skip


@pytest.mark.parametrize(("left", "right", "needs"), TRUE)
def test_values_are_proved_and_slips_refuted(left: Any, right: Any, needs: set[str]) -> None:
    verdict = prove(left, right)
    assert verdict.true
    assert set(verdict.needs) == needs
    recheck(verdict, left, right)
    wrong = right + 1 if isinstance(left, Expr) else right + Matrix([1, 0])
    verdict = prove(left, wrong)
    assert verdict.wrong
    recheck(verdict, left, wrong)


@pytest.mark.parametrize(
    "e",
    [
        Integral(x, x), Integral(x, (x, a)), Integral(exp(x**2), (x, 0, 1)), Integral(tan(x), (x, 0, 2)),
        Integral(1 / x, (x, -1, 1)), Integral(1 / x, (x, a, b)), Integral(Abs(x), (x, -1, 1)),
        Integral(1 / x**2, (x, -1, 1)),
        Integral(exp(a * x), (x, 0, oo)), Integral(cos(x), (x, 0, oo)), Integral(1 / x, (x, 1, oo)),
        Integral(sqrt(x), (x, a, 1)),
        Integral(1 / (1 - x) ** 2, (x, oo, 0)), Integral(1 / (1 + x) ** 2, (x, 0, -oo)),
        Integral(conjugate(x), (x, 0, I)), Integral(x, (x, 0, sqrt(-R))),
        Integral(1 / (2 + cos(x)), (x, 0, 2 * pi)), Integral(1 / (a + b * x), (x, 0, 1)), Integral(log(x), (x, -1, 1)),
        Integral(1 / x, (x, 0, 0)), Integral((x + 3) ** 2 * exp(c * x) * atan(x), (x, 0, 1)),
        Integral((x + R) ** 5 * atan(R * x) ** 3 / (x**3 + R) ** 3, (x, 0, 1)), Integral(sin(x) ** 9 / x, (x, 1, 2)),
        Integral(sqrt(1 - x**2) * (x**2 + R**2) ** Rational(3, 2), (x, 0, 1)),
        Integral(log(x**2 + 1) / (1 - x**2), (x, n, -pi)), Integral(sqrt(R + 3 * x) / ((x - a) ** 2 + 1), (x, 0, 1)),
    ],
)  # fmt: skip
def test_others_are_refused_by_name(e: Any) -> None:
    with pytest.raises(Untreatable, match=r"Integral\(.*is not treated: "):
        prove(e, 1)


def test_an_antiderivative_has_the_right_derivative(monkeypatch: pytest.MonkeyPatch) -> None:
    right = integrals._antiderivative
    monkeypatch.setattr(integrals, "_antiderivative", lambda part, x, whole: right(part, x, whole) * (1 + x))
    with pytest.raises(Untreatable, match="no antiderivative was found"):
        prove(Integral(x * sin(x), (x, 0, pi)), pi)


def test_what_is_cancelled_where_something_is_written_out_is_needed() -> None:
    for left, right in ((x * Sum(i / x, (i, 1, 3)), 6), (Determinant(Matrix([[1 / x, 0], [0, x]])), 1)):
        verdict = prove(left, right)
        assert verdict.needs == ("x != 0",)
        recheck(verdict, left, right)


@pytest.mark.parametrize(
    ("e", "value"),
    [(cos(j * x), 0), (cos(j * x) ** 2, pi), (x * cos(j * x), 0), (cos(j * x) * cos(l * x), 0), (exp(I * j * x), 0)],
)
def test_what_an_antiderivative_divides_by_is_needed_where_it_is_lost(e: Any, value: Any) -> None:
    """Of an integer j, sin(2*pi*j)/j is zero where j is not; where j is zero, the integral is another one."""
    integral = Integral(e, (x, 0, 2 * pi))
    verdict = prove(integral, value)
    assert set(verdict.needs) == ({"j + l != 0", "j - l != 0"} if e.has(l) else {"j != 0"})
    recheck(verdict, integral, value)
    assert not prove(integral, value, given=[Eq(j, 0), Eq(l, 0)]).true
