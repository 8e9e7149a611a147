"""What follows from equations of real numbers: each square of a sum that vanishes does; logarithms are equal, too."""

from __future__ import annotations

from copy import deepcopy
from dataclasses import replace
from typing import Any

import pytest
from sympy import Eq, Function, Symbol, cosh, exp, log, symbols

from chasles.from_sympy.real_zeros import squares_in
from chasles.prove import Rejected, prove, recheck
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder

x, y, z, a, b, t = symbols("x y z a b t")
m, k = symbols("m k", positive=True)
f, g = Function("f")(t), Function("g")(t)

ZEROS: list[tuple[Any, Any, list[Any]]] = [
    (x, 0, [Eq(x**2 + y**2, 0)]),
    (x * y + z, 0, [Eq(x**2 + y**2 + z**2, 0)]),
    (x, y, [Eq(x**3, y**3)]),
    (x, -y, [Eq(x**3 + y**3, 0)]),
    (x**2, y**2, [Eq(x**4, y**4)]),
    (x, 0, [Eq(x**4 + x**2, 0)]),
    (x, y, [Eq((x - 1) ** 2 + (x - y) ** 2, 0)]),
    (x, z, [Eq(x**2 + y**2 + z**2, x * y + y * z + z * x)]),
    (x, 0, [Eq(m * x**2 + k * y**2, 0)]),
    (x, 0, [Eq(-(x**2) - 2 * y**2, 0)]),
    (x, 2, [Eq(x**2 + y**2 + 4, 4 * x)]),
    (a, 0, [Eq(a**2 + b**2, 0), Eq(x, a)]),
    (f, 0, [Eq(f**2 + g**2, 0)]),
    (f.diff(t) * g, 0, [Eq(f**2 + g**2, 0)]),
]


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("left", "right", "given"), ZEROS, ids=str)
def test_each_square_of_a_sum_that_vanishes_does(left: Any, right: Any, given: list[Any]) -> None:
    verdict = prove(left, right, given=given)
    assert isinstance(verdict, HoldsUnder)
    recheck(verdict, left, right, given=given)
    assert isinstance(prove(left, right + 1, given=given), Fails)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("left", "right", "given"), ZEROS, ids=str)
def test_no_other_sum_of_squares_is_accepted(left: Any, right: Any, given: list[Any]) -> None:
    verdict = prove(left, right, given=given)
    assert isinstance(verdict, HoldsUnder)
    for item in range(len(verdict.certificate.get("squares", ()))):
        for place in range(len(verdict.certificate["squares"][item]["squares"])):
            for part, text in ((0, "-1"), (0, "0"), (1, "0"), (1, "2"), (0, "1/7")):
                certificate = deepcopy(dict(verdict.certificate))
                certificate["squares"][item]["squares"][place][part] = text
                if certificate["squares"] != verdict.certificate["squares"] and "square" in str(certificate["entries"]):
                    used = f"square {item} " in str(certificate["entries"])
                    if used:
                        with pytest.raises(Rejected):
                            recheck(replace(verdict, certificate=certificate), left, right, given=given)
    with pytest.raises(Rejected):
        recheck(verdict, left, right, given=[Eq(e.lhs, e.rhs + 1) for e in given])


def test_what_is_no_sum_of_squares_is_none() -> None:
    for given in (x**2 - y**2, x**2 + 3 * x * y + y**2, m * x**2 - k * y**2, x**2 * y + y**3 * x, x * y):
        assert not isinstance(prove(x, 0, given=Eq(given, 0)), Holds | HoldsUnder)
    n = Symbol("n", negative=True)
    assert not isinstance(prove(x, 0, given=Eq(m * x**2 + n * y**2, 0)), Holds | HoldsUnder)
    assert isinstance(prove(x, 0, given=Eq(x**2 + y**2, -1)), Contradictory)
    assert isinstance(prove(x, 0, given=[Eq(x**2 + y**2, 0), Eq(y, 1)]), Contradictory)


BOTH: list[tuple[Any, Any, list[Any]]] = [
    (log(y), 2 * x, [Eq(y, exp(2 * x))]),
    (x, log(y), [Eq(exp(x), y)]),
    (y, exp(x), [Eq(log(y), x)]),
    (x, y, [Eq(exp(x), exp(y))]),
    (x, y, [Eq(log(x), log(y))]),
    (x, 0, [Eq(exp(x), 1)]),
    (x, 1, [Eq(log(x), 0)]),
    (x, 5, [Eq(2**x, 32)]),
    (x, 3, [Eq(10**x * 100 ** (2 * x), 10**15)]),
    (x * y, 1, [Eq(log(x) + log(y), 0)]),
    (x, log(y) / log(2), [Eq(2**x, y)]),
    (x**2, exp(2 * a), [Eq(log(x), a)]),
    (log(x * y), a + b, [Eq(log(x), a), Eq(log(y), b)]),
    (f, log(g), [Eq(exp(f), g)]),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("left", "right", "given"), BOTH, ids=str)
def test_logarithms_and_exponentials_of_both_sides_are_equal(left: Any, right: Any, given: list[Any]) -> None:
    verdict = prove(left, right, given=given)
    assert isinstance(verdict, HoldsUnder)
    recheck(verdict, left, right, given=given)
    assert not isinstance(prove(left, right + 1, given=given), Holds | HoldsUnder)
    with pytest.raises(Rejected):
        recheck(verdict, left, right + 1, given=given)
    with pytest.raises(Rejected):
        recheck(verdict, left, right, given=[Eq(e.lhs, 2 * e.rhs + 1) for e in given])
    with pytest.raises(Rejected):
        recheck(verdict, left, right)


def test_no_logarithm_is_taken_of_what_may_be_negative() -> None:
    assert not isinstance(prove(log(x**2), 2 * log(y), given=Eq(x, y)), Fails)
    for given in (Eq(x**2, exp(2 * y)), Eq(x * y, exp(2 * x) * y), Eq(cosh(x), cosh(y))):
        assert not isinstance(prove(x, exp(y), given=given), Holds | HoldsUnder)
        assert not isinstance(prove(x, y, given=given), Holds | HoldsUnder)


def test_what_is_zero_once_it_is_multiplied_out_has_no_squares() -> None:
    x = Symbol("x", real=True)
    assert list(squares_in("a", (x + 1) ** 2 - x**2 - 2 * x - 1)) == []
