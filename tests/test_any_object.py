"""Whatever is handed in as a side or a condition is decided, or refused with a reason: there is no other error."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy
from sympy import I, S, Symbol, oo, symbols, zoo
from sympy.combinatorics import Permutation
from sympy.core.symbol import Str
from sympy.physics.units import meter
from sympy.physics.vector import ReferenceFrame
from sympy.vector import CoordSys3D

from chasles.prove import Untreatable, prove
from chasles.verdict import Verdict

x, y = symbols("x y")
n, i = symbols("n i", integer=True)
f = sympy.Function("f")
A, N, M = ReferenceFrame("A"), CoordSys3D("N"), sympy.MatrixSymbol("M", 2, 2)
OBJECTS = [
    sympy.Lambda(x, x), sympy.Lambda((x, y), x + y), sympy.Tuple(x, y), sympy.FiniteSet(1, x), sympy.Interval(0, 1),
    sympy.ImageSet(sympy.Lambda(x, x**2), S.Integers), sympy.Sum(1 / i**2, (i, 1, oo)), sympy.Product(i, (i, 1, oo)),
    sympy.Integral(f(x), (x, 0, oo)), sympy.Limit(sympy.sin(x) / x, x, 0), x + sympy.O(x**2), zoo, S.NaN, x + oo,
    sympy.Poly(x**2, x, modulus=3), sympy.rootof(x**5 - x + 1, 0), sympy.RootSum(x**5 + x + 1, sympy.Lambda(x, x)),
    sympy.Wild("w"), sympy.Dummy("x"), f, sympy.sin, meter, 5 * meter, A.x, A.x | A.x, A, N, N.i, Permutation([1, 0]),
    "x + 1", b"x", None, True, sympy.Contains(x, sympy.Interval(0, 1)), sympy.Implies(x > 0, y > 0),
    sympy.Derivative(f(f(x)), x), sympy.Derivative(f(x), (x, n)), f(2), f(x, x), f(M), [], [[x, [y]]], {x: 1}, object(),
    1 + 2j, float("nan"), sympy.IndexedBase("a")[i], sympy.Idx("j", 3), sympy.Array([[[1, x]]]), Str("a"), M**n,
    sympy.Piecewise((M, x > 0), (2 * M, True)), sympy.DiracDelta(x), Symbol("q", commutative=False),
    Symbol("q", infinite=True),
    1 / Symbol("q", zero=True), sympy.AccumBounds(-1, 1), sympy.Matrix(2, 0, []), sympy.Pow(x, 0, evaluate=False),
    sympy.Pow(0, -1, evaluate=False), sympy.Pow(10, sympy.Pow(10, 10, evaluate=False), evaluate=False),
    sympy.factorial(10**9, evaluate=False), sympy.totient(i), sympy.exp_polar(I * x), np.array([x, y], dtype=object),
    np.ones((2, 2, 2)), sympy.QQ, sympy.Point(1, 2),
]  # fmt: skip
POSITIONS = [
    lambda e: prove(e, 1), prove, lambda e: prove(x, y, given=[e]), lambda e: prove(x, y, given=e),
    lambda e: prove(x, y, nonzero=[e]), lambda e: prove(sympy.Le(x, e, evaluate=False)),
    lambda e: prove(x, y, given=sympy.Eq(x, e, evaluate=False)),
]  # fmt: skip


@pytest.mark.parametrize("position", POSITIONS)
def test_there_is_a_verdict_or_a_reason(position: Any) -> None:
    for e in OBJECTS:
        try:
            assert isinstance(position(e), Verdict)
        except (Untreatable, sympy.SympifyError):  # the latter of Eq or Le, before anything is asked
            continue


@pytest.mark.parametrize(
    ("asked", "message"),
    [
        ((x, 0, sympy.And(x, y)), "given is x & y, where x is true or false: no equation and no inequality"),
        ((sympy.Lambda(x, x), 1), "Lambda.* is not treated"),
        ((x, sympy.Sum(i, (i, 1, oo))), "it has an infinite limit"),
        ((sympy.factorial(10**9, evaluate=False), x), "its argument is larger than 10000"),
        ((sympy.Poly(x**2, x, modulus=3), x), "finite field"),
    ],
)
def test_the_reason_names_what_is_not_treated(asked: Any, message: str) -> None:
    with pytest.raises(Untreatable, match=message):
        prove(*asked)
