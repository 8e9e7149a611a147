"""Sums and products up to a letter: proved by induction, refuted at a number, and no forged proof is accepted."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
from sympy import Abs, Eq, I, Product, Sum, binomial, cos, exp, factorial, log, sin, sqrt, symbols

from chasles import prove
from chasles.checker.expressions.induction import letters_of, steps
from chasles.prove import Rejected, Untreatable, recheck
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder

i, n = symbols("i n", integer=True, positive=True)
m, z = symbols("m", integer=True, nonnegative=True), symbols("z", integer=True)
x, y, q = symbols("x y q", real=True)
p = symbols("p", positive=True)
TRUE: dict[str, tuple[Any, ...]] = {
    "telescoping": (Sum(1 / (i * (i + 1)), (i, 1, n)), n / (n + 1)),
    "geometric": (Sum(p**i, (i, 0, m)), (p ** (m + 1) - 1) / (p - 1)),
    "its derivative": (Sum(i * p**i, (i, 0, n)), p * (1 - (n + 1) * p**n + n * p ** (n + 1)) / (1 - p) ** 2),
    "exponentials": (Sum(exp(i * x), (i, 0, n)), (exp((n + 1) * x) - 1) / (exp(x) - 1)),
    "cosines": (Sum(cos(i * x), (i, 1, n)), sin(n * x / 2) * cos((n + 1) * x / 2) / sin(x / 2)),
    "products": (Product(1 - 1 / (i + 1) ** 2, (i, 1, n)), (n + 2) / (2 * (n + 1))),
    "logarithms": (Sum(log(1 + 1 / i), (i, 1, n)), log(n + 1)),
    "roots": (Sum(1 / (sqrt(i) + sqrt(i + 1)), (i, 1, n)), sqrt(n + 1) - 1),
    "factorials": (Sum(i * factorial(i), (i, 1, n)), factorial(n + 1) - 1),
    "two at once": (Sum(i, (i, 1, n)) + Sum(1 / (i * (i + 1)), (i, 1, n)), n * (n + 1) / 2 + n / (n + 1)),
    "by two": (Sum((-1) ** i * i, (i, 1, 2 * n)), n),
    "between two numbers": (Sum(x * p**i, (i, 0, m)) * (1 - p), x * (1 - p ** (m + 1)), [x > 0, x < 1]),
    "with what is given": (Sum(q / (i * (i + 1)), (i, 1, n)), n / (n + 1), [Eq(q, 1)]),
}
FALSE: dict[str, tuple[Any, ...]] = {
    "at the first": (Sum(p**i, (i, 0, m)), (p**m - 1) / (p - 1)),
    "at a later one": (Sum(1 / (i * (i + 1)), (i, 1, n)), n**2 / (2 * (2 * n - 1))),
    "terms with the letter": (Sum(binomial(n, i), (i, 0, n)), 2**n + 1),
    "everywhere": (Sum(1 / sqrt(i), (i, 1, n)), 2 * sqrt(n)),
}
OPEN: dict[str, tuple[Any, ...]] = {
    "a letter that is no count": (Sum(1 / (i * (i + 1)), (i, 1, z)), z / (z + 1)),
    "terms with the letter": (Sum(binomial(n, i), (i, 0, n)), 2**n),
    "what is given of the letter": (Sum(q / (i * (i + 1)), (i, 1, n)), n / (n + 1), [Eq(q, n)]),
    "what may not be real": (Sum(I / (i * (i + 1)), (i, 1, n)), I * n / (n + 1)),
    "what is undefined": (Sum(1 / i, (i, 0, n)), Sum(1 / i, (i, 1, n))),
    "true at the first numbers": (Sum(p**0 / i, (i, 1, n)), Sum(1 / i, (i, 1, n)) + (n - 1) * (n - 2) * (n - 3) * x),
    "a divisor that vanishes at a number": (Sum(1 / (i - 9), (i, 1, n)), Sum(1 / (i - 9), (i, 1, n)) * (y + 1)),
}


@pytest.mark.parametrize("question", [pytest.param(each, id=name) for name, each in TRUE.items()])
def test_what_holds_for_all_numbers_is_proved(question: tuple[Any, ...]) -> None:
    verdict = prove(*question)
    assert isinstance(verdict, Holds | HoldsUnder)
    assert not any("n" in need.split(" ") or "s_1" in need for need in verdict.needs)
    recheck(verdict, *question)


@pytest.mark.parametrize("question", [pytest.param(each, id=name) for name, each in FALSE.items()])
def test_what_fails_at_a_number_is_refuted(question: tuple[Any, ...]) -> None:
    verdict = prove(*question)
    assert isinstance(verdict, Fails)
    recheck(verdict, *question)
    for name in {"n", "m"} & verdict.counterexample.at.keys():
        forged = replace(verdict.counterexample, at={**verdict.counterexample.at, name: -1})
        with pytest.raises(Rejected):
            recheck(Fails(forged), *question)


@pytest.mark.parametrize("question", [pytest.param(each, id=name) for name, each in OPEN.items()])
def test_what_induction_does_not_show_is_open(question: tuple[Any, ...]) -> None:
    try:
        verdict = prove(*question)
    except Untreatable:
        return
    assert not isinstance(verdict, Holds | HoldsUnder)


def test_no_forged_proof_is_accepted() -> None:
    question = TRUE["geometric"]
    verdict = prove(*question)
    assert isinstance(verdict, HoldsUnder)
    said = verdict.certificate["induction"]
    base, step = said["parts"]
    forged = [
        {**said, "parts": [step, base]},
        {**said, "parts": [base, base]},
        {**said, "parts": [base]},
        {**said, "on": "p"},
        {**said, "name": "p"},
        {**said, "parts": [base, {**step, "needs": step["needs"][1:]}]},
        {**said, "parts": [base, {**step, "needs": [*step["needs"], "m + 1 != 0"]}]},
    ]
    others = [replace(verdict, certificate={"induction": each}) for each in forged]
    others += [replace(verdict, needs=()), replace(verdict, needs=(*verdict.needs, "p > 0"))]
    others += [replace(verdict, witness={**verdict.witness, "p": 1})]
    for other in others:
        with pytest.raises(Rejected):
            recheck(other, *question)
    with pytest.raises(Rejected):
        recheck(verdict, question[0], question[1] + m)


GROWING: list[tuple[Any, bool]] = [
    (2**n >= n + 1, True),
    (3**m >= 2 * m + 1, True),
    ((1 + p) ** m >= 1 + m * p, True),
    (factorial(n) >= n, True),
    (4**n >= 3 * n**2, True),
    (3**n >= 2**n + 1, True),
    (2**n >= n + 2, False),
    (2**n > n**2, False),
    (3**m >= 2**m + 1, False),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("claim", "true"), GROWING, ids=str)
def test_powers_and_factorials_are_compared_step_by_step(claim: Any, true: bool) -> None:
    verdict = prove(claim)
    assert isinstance(verdict, Holds | HoldsUnder if true else Fails)
    recheck(verdict, claim)
    if true and "induction" in getattr(verdict, "certificate", {}):
        with pytest.raises(Rejected):
            recheck(verdict, claim.func(claim.lhs, claim.rhs + 1))


def test_a_need_on_a_bound_is_said_of_what_is_shown_by_induction() -> None:
    question = (x ** (m + 1) <= x**m, None, [x >= 0, x <= 1])
    verdict = prove(*question)
    assert isinstance(verdict, HoldsUnder)
    [need] = verdict.needs
    assert need.startswith("x = ")
    recheck(verdict, *question)
    for needs in ((), (need, "x = 2"), (need, f"{m} = 0")):
        with pytest.raises(Rejected):
            recheck(replace(verdict, needs=needs), *question)
    with pytest.raises(Rejected):
        recheck(verdict, question[0])


def test_an_empty_product_is_one() -> None:
    """SymPy (1.14) takes that of 2 for negative."""
    product = Product(2, (z, 1, m))
    for claim in (product > m, 2**m > m):
        assert not isinstance(outcome(claim), Fails)
        for left in ("-1", "1"):
            forged = Fails(Counterexample({str(m): Fraction(0)}, (1, 1), left, "1"))
            with pytest.raises(Rejected):
                recheck(forged, claim)


def outcome(claim: Any) -> Any:
    """The verdict, or None where it is refused."""
    try:
        return prove(claim)
    except Untreatable:
        return None


k = symbols("k", integer=True)
j = symbols("j", integer=True)
COUNTED: list[tuple[Any, Any, list[Any], bool]] = [
    (2**k > k, None, [k >= 0], True),
    (k <= factorial(k), None, [k >= 0], True),
    (2**k <= factorial(k), None, [k >= 4], True),
    (k**2 < 2**k, None, [k >= 5], True),
    ((1 + x) ** k >= 1 + k * x, None, [x >= -1, k >= 0], True),
    (Sum(1 / (i * (i + 1)), (i, 1, k)), k / (k + 1), [k >= 1], True),
    (Sum(i * factorial(i), (i, 1, k)), factorial(k + 1) - 1, [k >= 1], True),
    (2**k <= factorial(k), None, [k >= 3], False),
    (k**2 < 2**k, None, [k >= 4], False),
    ((1 + x) ** k >= 1 + k * x, None, [k >= 0], False),
    (Sum(1 / (i * (i + 1)), (i, 1, k)), (k + 1) / (k + 3), [k >= 1], False),
]


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("claim", "value", "given", "true"), COUNTED, ids=str)
def test_an_integer_counts_from_where_it_is_given_to_be(claim: Any, value: Any, given: list[Any], true: bool) -> None:
    verdict = prove(claim, value, given)
    assert isinstance(verdict, Holds | HoldsUnder if true else Fails)
    recheck(verdict, claim, value, given)
    if isinstance(verdict, HoldsUnder):
        with pytest.raises(Rejected):
            recheck(replace(verdict, needs=()), claim, value, given)
    if true:
        with pytest.raises((Rejected, Untreatable)):
            recheck(verdict, claim, value)


def test_a_product_downwards_is_not_more_than_one() -> None:
    """Up to m - 3 the product of 2 is 1/8 where m is zero."""
    downwards = m * Product(2, (j, 1, m - 3)) >= m
    assert not isinstance(outcome(downwards), Holds | HoldsUnder)
    question = (Abs(downwards.gts - downwards.lts), downwards.gts - downwards.lts, [], [])
    _, _, (left, *_) = steps(question, m, "s")
    (symbol,) = {s for s in left.free_symbols if str(s).startswith("s_")}
    assert symbol.is_nonnegative is None
    upwards = Product(2, (j, 1, m)) - 1
    _, _, (left, *_) = steps((Abs(upwards), upwards, [], []), m, "s")
    (symbol,) = {s for s in left.free_symbols if str(s).startswith("s_")}
    assert symbol.is_nonnegative


def test_what_is_given_of_a_letter_is_no_step() -> None:
    """An equation that only says what a symbol is plays no part; one that ties a letter to what is spoken of does."""
    question = (Sum(q / (i * (i + 1)), (i, 1, n)), n / (n + 1))
    assert letters_of((*question, [Eq(z, n + 3)], [])) == [n]
    assert not letters_of((*question, [Eq(q, n)], []))
    assert not letters_of((*question, [Eq(z, n + 3), Eq(q, z)], []))
    assert not letters_of((*question, [z < n], []))
