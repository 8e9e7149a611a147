"""Classes of answers that were once wrong because something that is assumed was not kept; see `classes`."""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import Any

import sympy as sp

from chasles.prove import prove
from chasles.statements import Claim, positive
from chasles.statements.matrices import idempotent
from chasles.vocabulary import Identity, inverse, rate, scalar, square
from chasles.vocabulary import functions as f
from chasles.vocabulary.sizes import Size

from .asking import Answer, answer_of, ask_statement
from .judging import Alarm, Judged

__all__ = ["ASSUMED"]

x = sp.Symbol("x")
Judgement = tuple[Any, Judged]


def _judged(said: str, answer: Answer, wrong: tuple[str, ...]) -> Judgement:
    """An alarm for a crash, and for an answer that is wrong."""
    names = {"holds" if answer.true else answer.name}
    return said, Judged(answer, Alarm("wrong", answer.name) if names & {"crash", *wrong} else None)


def letters_that_are_even_or_prime(draw: Random) -> Judgement:
    """Sums up to a letter that is more than a natural number: they are not about the numbers between."""
    kinds: tuple[tuple[dict[str, bool], tuple[int, ...]], ...] = (
        ({"even": True, "positive": True}, (2, 4, 6, 8)), ({"odd": True, "positive": True}, (1, 3, 5, 7, 9)),
        ({"prime": True}, (2, 3, 5, 7, 11)), ({"composite": True}, (4, 6, 8, 9)),
        ({"odd": True, "prime": True}, (3, 5, 7, 11)), ({"integer": True, "negative": True}, (-1, -2, -3)),
    )  # fmt: skip
    assumed, values = draw.choice(kinds)
    n, i = sp.Symbol("n", **assumed), sp.Symbol("i", integer=True)
    a, b = draw.randint(1, 4), draw.choice((1, -2, x))
    terms: tuple[Callable[[Any], Any], ...] = (
        lambda k: b * (1 + a * (-1) ** k),
        lambda k: (k - 1) * (k - 2) * (k - 3) * (1 + draw.choice((1, -1)) * (-1) ** k),
        lambda k: b * sp.Rational(1) / (k + a),
        lambda k: (-1) ** k * (k + a),
        lambda k: b * sp.cos(sp.pi * k),
    )
    term = sp.sympify(draw.choice(terms)(i))
    total = [sp.expand(sp.Add(*(term.subs(i, k) for k in range(1, m + 1)))) for m in values]
    value = draw.choice(
        (total[0], sp.Integer(0), b * n / 2, b * n, (n - 1) / 2, ((-1) ** n - 1) / 2, n * total[1] / values[1])
    )
    differs = [sp.expand(value.subs(n, m) - t) != 0 for m, t in zip(values, total, strict=True) if m > 0]
    left = sp.Sum(term, (i, 1, n))
    answer = answer_of(lambda: prove(left, value))
    wrong = ("holds",) if any(differs) else ("fails",) if differs and len(differs) > 3 else ()
    return _judged(f"{left} = {value} for {assumed}", answer, wrong)


def indices_that_are_what_they_may_not_be(draw: Random) -> Judgement:
    """Integrals and sums over a variable that is assumed to have a sign, or to be whole, which SymPy uses up."""
    sign, whole = draw.choice(("positive", "negative", "nonnegative", "nonpositive")), draw.random() < 0.5
    index = sp.Symbol("i", **{sign: True}, integer=whole or None)
    low, high = draw.choice(((-2, 2), (-3, 1), (-1, 4), (-2, 1), (-4, 2)))
    makes: tuple[tuple[Callable[[Any], Any], Callable[[int], int]], ...] = (
        (sp.Abs, abs), (sp.sign, lambda k: (k > 0) - (k < 0)), (lambda k: sp.sqrt(k**2) * k, lambda k: abs(k) * k),
        (lambda k: sp.Max(k, 0), lambda k: max(k, 0)), (lambda k: k * sp.Heaviside(k), lambda k: max(k, 0)),
    )  # fmt: skip
    term, number_of = draw.choice(makes)
    if whole:
        left: Any = sp.Sum(term(index), (index, low, high))
        true = sum(number_of(k) for k in range(low, high + 1))
    else:
        left = sp.Integral(term(index), (index, low, high))
        true = sp.integrate(term(x), (x, low, high))
    value = left.doit()
    answer = answer_of(lambda: prove(left * x, value * x))
    return _judged(f"{left} = {value}", answer, () if sp.simplify(value - true) == 0 else ("holds",))


def whole_variables_of_integration(draw: Random) -> Judgement:
    """Cosines of whole turns between whole numbers are one, between those they are not."""
    index = sp.Symbol("i", **{draw.choice(("integer", "even", "odd", "prime")): True})
    turns, high = draw.choice((2, 4, 6)), draw.randint(1, 4)
    left = sp.Integral(sp.cos(turns * sp.pi * index) * draw.choice((1, 2, x)), (index, 0, high))
    answer = answer_of(lambda: prove(left, left.doit()))
    return _judged(str(left), answer, ("holds",))


def symbols_that_are_no_real_numbers(draw: Random) -> Judgement:
    """What is said of symbols that are not real, or of which more is known than that they are complex."""
    more = draw.choice(("positive", "negative", "integer", "rational", "prime", "even", "imaginary"))
    assumed: dict[str, bool] = draw.choice((
        {"antihermitian": True}, {"imaginary": True}, {"complex": True, more: False}, {"algebraic": True},
        {"complex": True, "hermitian": True}, {"complex": True, "antihermitian": True}, {"transcendental": True},
        {"infinite": True},
    ))  # fmt: skip
    z, y = sp.Symbol("z", **assumed), sp.Symbol("y")
    left, right, given = draw.choice((
        (z**2 >= 0, None, ()), (sp.conjugate(z) * y, z * y, ()), (sp.re(z), z, ()),
        (z + sp.Abs(z), 0, (sp.Eq(sp.im(z), 0),)), (z**2 * y, sp.Abs(z) ** 2 * y, ()), (z * y, y, ()),
        (sp.im(z), y, ()), (sp.sqrt(z**2), z, ()), (z, 2, ()),
    ))  # fmt: skip
    if left in (sp.true, sp.false):
        left, right = z * y, 2 * z * y
    answer = answer_of(lambda: prove(left, right, given=given))
    return _judged(f"{left} = {right} for {assumed}", answer, ("holds", "fails", "contradictory"))


def what_is_said_to_be_an_inverse(draw: Random) -> Judgement:
    """A matrix that has an inverse is meant: a point where it has none refutes nothing."""
    n, k = Size("n"), Size("k")
    J, one = square("J", "J", "a matrix", size=n), Identity(n)
    same = (J, J @ J, J**k, J.T.T, one, J @ J @ J, 2 * J - one, J**3)
    left, right = inverse(draw.choice(same[:4])), draw.choice(same)
    left, right = (left, right) if draw.random() < 0.7 else (right, left)
    more = draw.random() < 0.3
    answer = ask_statement(Claim("1", left, 2 * right if more else right, assuming=(idempotent(J),)))
    return _judged(f"{left} = {'2 ' * more}{right}", answer, ("holds",) if more else ("fails", "contradictory"))


def quantities_that_are_called_as_the_time(draw: Random) -> Judgement:
    """A constant whose name is t does not change with the time."""
    c = scalar(draw.choice("ttts"), "c", "a constant", constant=True)
    y = scalar(draw.choice("yt") if c.name != "t" else "y", "y", "a number")
    of = draw.choice((f.exp(y), f.sqrt(y), f.arctan(y), f.log(y), f.sinh(y)))
    left, right = draw.choice((
        (rate(c * of), c * rate(of)), (rate(f.exp(c) * of), f.exp(c) * rate(of)),
        (rate(of / f.exp(c)), rate(of) / f.exp(c)),
        (rate(f.exp(c * y)), c * rate(y) * f.exp(c * y)), (rate(f.arctan(c) + of), rate(of)),
    ))  # fmt: skip
    answer = ask_statement(Claim("1", left, right, assuming=(positive(y),)))
    return _judged(f"{left} = {right}", answer, ("fails", "contradictory", "ill-formed"))


def inequalities_of_compound_arguments(draw: Random) -> Judgement:
    """What is so of any number is so of products and roots, and no more than that is."""
    x, y = sp.symbols("x y")
    of = draw.choice((x * y, x**2 + y**2, sp.sin(x), x * y**2, sp.sqrt(x), sp.Abs(x) * y))
    less, more = draw.choice((
        (1 + of, sp.exp(of)), (1 - of**2 / 2, sp.cos(of)), (1 + of**2 / 2, sp.cosh(of)), (-(of**2), -(sp.sin(of) ** 2)),
    ))  # fmt: skip
    beyond = draw.choice((0, 0, 1, sp.Rational(1, 10**6)))
    if draw.random() < 0.3:
        claim, wrong = less + beyond < more, ("holds",)  # both sides are equal where the argument is zero
    else:
        claim, wrong = less + beyond <= more, ("holds",) if beyond else ("fails", "contradictory")
    return _judged(f"{claim}", answer_of(lambda: prove(claim)), wrong)


def what_is_shown_by_induction_between_bounds(draw: Random) -> Judgement:
    """A bound without which something is false is among the needs, also of what is shown by induction."""
    x, n, k = sp.Symbol("x"), sp.Symbol("n", integer=True, nonnegative=True), sp.Symbol("k", integer=True)
    low, high = draw.choice(((0, 1), (0, sp.Rational(1, 2)), (sp.Rational(1, 3), 1)))
    left, right = draw.choice((
        (x ** (n + 1) <= x**n, None), (sp.Sum(sp.Abs(x), (k, 1, n)), n * x),
        (sp.Sum(sp.sqrt(x**2), (k, 0, n)), x + n * x),
    ))  # fmt: skip
    given = [draw.choice((sp.Gt, sp.Ge))(x, low), draw.choice((sp.Lt, sp.Le))(x, high)]
    answer = answer_of(lambda: prove(left, right, given=given))
    free = answer.name == "holds" and not answer.needs
    return _judged(f"{left} = {right} where {given}", answer, ("holds",) if free else ("fails", "contradictory"))


ASSUMED = (
    inequalities_of_compound_arguments, what_is_shown_by_induction_between_bounds,
    letters_that_are_even_or_prime, indices_that_are_what_they_may_not_be, whole_variables_of_integration,
    symbols_that_are_no_real_numbers, what_is_said_to_be_an_inverse, quantities_that_are_called_as_the_time,
)  # fmt: skip
