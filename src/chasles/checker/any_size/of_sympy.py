"""Matrices whose sizes have letters, as SymPy has them, in words: a question on them is one of declared statements."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import reduce
from operator import add, matmul, mul
from typing import Any

import sympy
from sympy.matrices import MatrixExpr

from chasles import vocabulary as w
from chasles.checker.certificate import check
from chasles.checker.expressions.asked import listed
from chasles.checker.expressions.quantities import NUMBERS, SIGNS, require_real
from chasles.checker.refutation import check_counterexample
from chasles.checker.sparse import Rejected
from chasles.statements import Claim, Condition, Definition, Hypothesis, Problem, positive, problem_of
from chasles.statements import nonzero as vanishes_nowhere
from chasles.verdict import Fails
from chasles.vocabulary.measure import Extent, uniform
from chasles.vocabulary.nodes import lifted
from chasles.vocabulary.products import kronecker_product
from chasles.vocabulary.sizes import Size, times, uniform_blocks


def has_letters_for_sizes(expressions: Iterable[Any]) -> bool:
    """Whether a matrix occurs whose numbers of rows and columns are not both given."""
    parts = (part for e in expressions for part in sympy.preorder_traversal(e) if isinstance(part, MatrixExpr))
    return any(not sympy.sympify(extent).is_Integer for part in parts for extent in getattr(part, "shape", ()))


def problem_in_words(lhs: Any, rhs: Any, given: Any, nonzero: Any) -> tuple[Problem, tuple[str, ...]]:
    """The problem that a question on matrices of any size is, and all that a proof of it may use.

    Raises `Rejected` for what has no word.
    """
    read = _Words()
    equations = [_sides(item) for _, item in listed(given, "given")]
    nowhere_zero = [e.lhs - e.rhs if isinstance(e, sympy.Unequality) else e for _, e in listed(nonzero, "nonzero")]
    texts = [f"{one} = {other}" for one, other in equations]
    try:
        pairs = [tuple(map(read, map(sympy.sympify, sides))) for sides in equations]
        said = [each for text, pair in zip(texts, pairs, strict=True) for each in _equal(text, *pair)]
        assuming = [each for each in said if isinstance(each, Hypothesis)]
        assuming += [vanishes_nowhere(read(e)) for e in nowhere_zero]
        left, right = (read(sympy.sympify(side)) for side in (lhs, rhs))
        assuming += map(positive, read.positive)
        statements = tuple(each for each in said if not isinstance(each, Hypothesis))
        problem = problem_of(Claim("asked", left, right, given=statements, assuming=tuple(assuming)), "printed")
    except (w.Misfit, TypeError) as error:
        raise Rejected(str(error)) from None
    return problem, tuple(dict.fromkeys((*texts, *(h.text for h in problem.hypotheses if h.kind != "evident"))))


def check_at_any_size(verdict: Any, *asked: Any) -> None:
    """The verdict on a question on matrices of any size is right, and needs no more and no less than all it may use."""
    problem, needs = problem_in_words(*asked)
    if isinstance(verdict, Fails):
        check_counterexample(problem, verdict.counterexample)
        return
    if tuple(verdict.needs) != needs:
        raise Rejected(f"the proof may use {', '.join(needs)}, and the verdict says {', '.join(verdict.needs)}")
    check(problem, "printed", verdict.certificate)
    if {str(name): str(value) for name, value in verdict.witness.items()} != verdict.certificate["witness"]:
        raise Rejected("the verdict and its certificate have different witnesses")


def _sides(item: Any) -> tuple[Any, Any]:
    """Both sides of an equation, or of an expression that is zero."""
    if isinstance(item, sympy.Equality):
        return item.lhs, item.rhs
    if not isinstance(item, sympy.Expr | MatrixExpr):
        raise Rejected(f"{item} is no equation between matrices of any size")
    return item, (0 * item).doit()


def _equal(text: str, left: w.Node, right: w.Node) -> Iterator[Definition | Condition | Hypothesis]:
    """What an equation says: what a letter is, that a matrix is orthogonal, or a condition.

    Square matrices whose product is the identity have this product in either order.
    """
    if isinstance(left, w.Symbol) and left not in w.symbols_of(right):
        yield Definition(text, left, right)
        return
    pairs = [(left, right)]
    match left, right:
        case w.Contract((one, other)), w.Identity() if one.shape[0] == one.shape[1]:
            pairs.append((other @ one, right))
            letter = one if isinstance(one, w.Symbol) else other
            if isinstance(letter, w.Symbol) and w.Transpose(letter) in (one, other):
                yield Hypothesis("orthogonal", (letter,), tuple(pairs), text=text)
                return
            if isinstance(one, w.Symbol) and one not in w.symbols_of(other):
                yield Definition(text, one, w.inverse(other))
                return
    symbols = dict.fromkeys(symbol for side in (left, right) for symbol in w.symbols_of(side))
    for order, pair in enumerate(pairs):
        yield Condition(f"{text}{' turned round' * order}", *pair, on=tuple(symbols))


class _Words:
    """Reads expressions; symbols of a name are one, and some are `positive`."""

    def __init__(self) -> None:
        self.letters: dict[str, Any] = {}
        self.positive: dict[w.Node, None] = {}

    def __call__(self, e: Any) -> w.Node:
        match e:
            case sympy.MatrixSymbol() | sympy.Symbol():
                return self._letter(e)
            case sympy.Rational():
                return lifted(Fraction(int(e.p), int(e.q)))
            case sympy.Identity():
                return w.Identity(_extent(e.rows))
            case sympy.ZeroMatrix():
                return w.Zero(*map(_extent, e.shape))
            case sympy.Transpose() | sympy.Adjoint():
                return self(e.arg).T
            case sympy.Add() | sympy.MatAdd():
                return reduce(add, map(self, e.args))
            case sympy.MatMul():
                scalars, matrices = e.as_coeff_matrices()
                product = reduce(matmul, map(self, matrices))
                return product if scalars == 1 else self(scalars) * product
            case sympy.Mul():
                return reduce(mul, map(self, e.args))
            case sympy.Inverse():
                return w.inverse(self(e.arg))
            case sympy.Pow() | sympy.MatPow() if e.exp.is_Symbol and e.exp.is_integer and e.exp.is_positive:
                return self(e.base) ** Size(str(e.exp))
            case sympy.Pow() | sympy.MatPow() if e.exp.is_Integer and e.exp != 0:
                power = self(e.base) ** abs(int(e.exp))
                return power if e.exp > 0 else w.over(1, power) if power.is_scalar else w.inverse(power)
            case sympy.Trace():
                return w.tr(self(e.arg))
            case sympy.Determinant():
                return w.det(self(e.arg))
            case sympy.KroneckerProduct():
                return reduce(kronecker_product, map(self, e.args))
            case sympy.BlockMatrix():
                return w.matrix(*([self(e.blocks[i, j]) for j in range(e.blocks.cols)] for i in range(e.blocks.rows)))
        raise Rejected(f"{e} ({type(e).__name__}) is no word for matrices of any size")

    def _letter(self, e: Any) -> w.Node:
        is_scalar = isinstance(e, sympy.Symbol)
        if is_scalar:
            require_real(e)
        kinds = NUMBERS if e.is_positive else (*SIGNS, *NUMBERS)
        if known := [kind for kind in kinds if is_scalar and getattr(e, f"is_{kind}") is not None]:
            raise Rejected(f"{e} is assumed to be {known[0]} or not, which beside matrices of any size has no word")
        if self.letters.setdefault(str(e), e) != e:
            raise Rejected(f"two different quantities are both called {e}")
        height, width = map(_extent, (1, 1) if is_scalar else e.shape)
        given = isinstance(height, int) and isinstance(width, int)
        measure = uniform((height, width)) if given else uniform_blocks(height, width, w.NO_DIMENSION)
        symbol = w.Symbol(str(e), str(e), measure, constant=True)
        self.positive |= {symbol: None} if is_scalar and e.is_positive else {}
        return symbol


def _extent(e: Any) -> Extent:
    """A number of rows or columns: a whole number, a letter, or what is made of such by sums and products."""
    e = sympy.expand(e)
    if e.is_Integer and e >= 0:
        return int(e)
    if isinstance(e, sympy.Symbol):
        return Size(str(e))
    if isinstance(e, sympy.Add):
        return reduce(add, map(_extent, e.args))
    if isinstance(e, sympy.Mul):
        return reduce(times, map(_extent, e.args))
    raise Rejected(f"{e} is no number of rows or columns")
