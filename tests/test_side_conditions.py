"""Side conditions of `prove`: what is handed in is understood whole, or refused by a clear sentence."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp
from sympy import Eq, Matrix, Ne, Or, sqrt

from chasles.prove import Untreatable, prove, recheck
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder

x, y, z = sp.symbols("x y z")
p = sp.Symbol("p", positive=True)
n = sp.Symbol("n", integer=True)


@pytest.mark.parametrize(
    ("given", "value"),
    [
        ({x: 1}, 1),
        ({x: y, y: 2}, 2),
        ({x + 1: 2}, 1),
        ({sp.ImmutableMatrix([x, y]): Matrix([1, 2])}, 1),
        (sp.Dict({x: 1}), 1),
        ({Eq(x, y), Eq(y, 3)}, 3),
        (frozenset({Eq(x, 1)}), 1),
        ((Eq(x, k) for k in [1]), 1),
        (iter([x - 1]), 1),
        ((Eq(x, y), Eq(y, 4)), 4),
        (Eq(x, 1), 1),
        (x - 1, 1),
        (x, 0),
        (Matrix([x - 1, y]), 1),
        (Eq(Matrix([x, y]), Matrix([5, 6])), 5),
        ([sp.And(Eq(x, y), Eq(y, 1))], 1),
        (sp.And(Eq(x, 2), Eq(y, 1)), 2),
        ([Eq(x, 1), sp.true], 1),
        ([Eq(x, 1), Eq(y, y)], 1),
        ([[Eq(x, 1)]][0], 1),
        (sp.Tuple(Eq(x, 1)), 1),
        (np.array([Eq(x, 1), Eq(y, 2)]), 1),
        ([sp.Eq(x, 1, evaluate=False)], 1),
        ({x: 0}, 0),
    ],
)
def test_equations_are_understood_in_many_forms(given: Any, value: int) -> None:
    given = list(given) if not isinstance(given, dict | sp.Basic | sp.MatrixBase | set | frozenset) else given
    verdict = prove(x, value, given=given)
    assert isinstance(verdict, HoldsUnder), verdict
    recheck(verdict, x, value, given=given)
    assert isinstance(prove(x, value + 1, given=given), Fails)


def test_an_iterator_is_read_once() -> None:
    assert isinstance(prove(x, 1, given=(Eq(x, k) for k in [1])), HoldsUnder)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ([(x, 1)], r"^given\[0\] is \(x, 1\): write Eq\(a, b\)"),
        ([[x, 1]], r"^given\[0\] is \[x, 1\]: write Eq\(a, b\)"),
        ((x, 1), r"^given\[1\] is 1, which is not zero: write Eq\(a, b\)"),
        ([1], r"^given\[0\] is 1, which is not zero"),
        ([sp.Rational(1, 2)], r"^given\[0\] is 1/2, which is not zero"),
        ([x == 1], r"^given\[0\] is False: write Eq\(a, b\)"),
        ([x != 1], r"^given\[0\] is True: write Eq\(a, b\)"),
        (True, r"^given is True: a list is expected"),
        (None, r"^given is None: a list is expected"),
        (1, r"^given is 1: a list is expected"),
        ("x = 1", r"^given is x = 1: a list is expected"),
        (["x = 1"], r"^given\[0\] is the text 'x = 1'"),
        ({"x": 1}, r"^a key of given is the text 'x'"),
        ({x: "1"}, r"^given\[x\] is the text '1'"),
        ({x: 0.5}, r"is a floating-point number"),
        ({Eq(x, 1): True}, r"^a key of given is Eq\(x, 1\), of type Equality"),
        ([x < sp.oo], r"^x < oo is not treated: it compares with what is infinite"),
        ([sp.And(Eq(x, 1), Or(y, x > 0))], r"^given\[0\] is .*, which is no equation"),
        ([sp.Implies(y, Eq(x, 1))], r"^given\[0\] is .*, which is no equation"),
        ([Eq(sp.FiniteSet(x), sp.FiniteSet(1))], r"of type FiniteSet: a scalar or a matrix is expected"),
        (sp.FiniteSet(Eq(x, 1)), r"^given is .*: a list is expected"),
        ([Eq(Matrix([x, y]), Matrix([[1, 2]]), evaluate=False)], r"^given\[0\] sets a 2 x 1 matrix equal to"),
        ([object()], r"which is no SymPy expression or matrix"),
    ],
)
def test_what_is_no_equation_or_inequality_is_refused(given: Any, message: str) -> None:
    with pytest.raises(Untreatable, match=message):
        prove(x, 1, given=given)


@pytest.mark.parametrize(
    "nonzero",
    [x, [x], (x,), {x}, iter([x]), [Ne(x, 0)], Ne(x, 0), [Ne(2 * x, x)], [x, sp.true], [x**2], [x * (y**2 + 1)], [-x]],
)
def test_what_does_not_vanish_is_understood_in_many_forms(nonzero: Any) -> None:
    assert isinstance(prove(x * y / x, y, nonzero=nonzero), Holds)


@pytest.mark.parametrize(
    ("nonzero", "message"),
    [
        ({x: 1}, r"^nonzero is \{x: 1\}: a list is expected"),
        (Matrix([x, y]), r"^nonzero is a 2 x 1 matrix: a scalar is expected"),
        ([Matrix([x, y])], r"^nonzero\[0\] is a 2 x 1 matrix: a scalar is expected"),
        ([True], r"^nonzero\[0\] is True: write"),
        ([x != 0], r"^nonzero\[0\] is True: write"),
        (None, r"^nonzero is None: a list is expected"),
        ("x", r"^nonzero is x: a list is expected"),
        ([Eq(x, 0)], r"^nonzero\[0\] is Eq\(x, 0\): what does not vanish is expected"),
        ([x > 0], r"^nonzero\[0\] is x > 0: what does not vanish is expected"),
        ([(x, y)], r"^nonzero\[0\] is \(x, y\): write"),
        ([0.5 * x], r"is a floating-point number"),
        ([Ne(Matrix([x, y]), Matrix([0, 0]))], r"(?s)^nonzero\[0\] is .*: what does not vanish is expected"),
    ],
)
def test_what_is_no_scalar_that_does_not_vanish_is_refused(nonzero: Any, message: str) -> None:
    with pytest.raises(Untreatable, match=message):
        prove(x, x, nonzero=nonzero)


@pytest.mark.parametrize(
    ("under", "said"),
    [
        ({"given": [Eq(1, 2)]}, "given[0] (false to SymPy)"),
        ({"given": [Eq(x, 1), Eq(p, -1)]}, "given[1] (false to SymPy)"),
        ({"given": [Eq(2 * n, 1)]}, "given[0] (false to SymPy)"),
        ({"given": [Matrix([x, 1])]}, "given[0]"),
        ({"given": [Eq(sqrt(2), sqrt(3), evaluate=False)]}, "sqrt(2) = sqrt(3)"),
        ({"nonzero": [0]}, "0 != 0"),
        ({"nonzero": [x - x]}, "0 != 0"),
        ({"nonzero": [Ne(x, x)]}, "0 != 0"),
        ({"nonzero": [(x + 1) ** 2 - x**2 - 2 * x - 1]}, "-x**2 - 2*x + (x + 1)**2 - 1 != 0"),
    ],
)
def test_what_is_false_on_its_face_contradicts_itself(under: dict[str, Any], said: str) -> None:
    for sides in ((x, 1), (x, x)):
        assert prove(*sides, **under) == Contradictory((said,))
