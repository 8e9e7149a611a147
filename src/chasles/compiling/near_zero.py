"""What is computed in another way where an angle is small, and in sums that vanish there with more than their terms."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import permutations
from operator import is_
from typing import Any

import sympy
from sympy.codegen.cfunctions import expm1, log1p

from chasles.compiling.angles import KEPT, KNOWN, angle_of, divisors, parts_of_kinds, square_of, with_series
from chasles.compiling.elementary import PowerTimesLog
from chasles.compiling.root_differences import by_conjugate
from chasles.compiling.taylor import ANALYTIC, CIRCULAR, NearZero, TaylorPolynomial, coefficient_of, left_of
from chasles.compiling.vanishing_sums import in_series
from chasles.compiling.variables import HELD, Substitution

_LESSENED = {sympy.exp: expm1, sympy.cosh: lambda a: 2 * sympy.sinh(a / 2) ** 2}
"""Functions less one, which lose nothing where what goes in is small."""
_POWERS: dict[Any, Any] = {
    sympy.S.Half: lambda root: 1 / (1 + root),
    -sympy.S.Half: lambda root: -1 / root / (1 + root),
    sympy.S.NegativeOne: lambda root: -1 / root**2,
}
"""Powers of 1 + u less one, in parts of u, of its root."""


def near_zero(found: Any, stated: sympy.Expr, angle: sympy.Expr) -> Any:
    """What is found where its polynomials hold, and elsewhere what is stated."""
    if not _polynomials(found):
        return found
    found = in_squares(found, angle) if angle.is_Pow else found
    return NearZero((found, where_near(found)), (stated, True), evaluate=False)


def in_squares(found: Any, angle: sympy.Expr) -> Any:
    """Functions of a root as powers of it times functions of its square, which have a derivative where it vanishes."""
    table = {}
    for f in parts_of_kinds(found, tuple(ANALYTIC)):
        if angle_of(f) == angle and type(f) not in CIRCULAR:
            first, times = ANALYTIC[type(f)].first, f.args[0].as_coeff_Mul()[0]
            table[f] = angle**first * left_of(type(f), first, times, angle, square_of(angle))
    return Substitution(table).of(found)


def where_near(found: Any) -> Any:
    """Where its polynomials hold; the square that is put in for that of an angle may be negative."""
    return sympy.And(*(sympy.Abs(part.args[0], evaluate=False) < part.args[1] for part in _polynomials(found)))


def _polynomials(found: Any) -> frozenset[Any]:
    """Those that are not in cases of their own."""
    return parts_of_kinds(found, (TaylorPolynomial,), (NearZero,))


def without_cancellation(expression: sympy.Basic) -> Any:
    """The expression, in which functions less the first terms of their series are what is left of these."""
    changed = _changed(expression)
    return expression if changed is None else changed


@lru_cache(KEPT)
def _changed(expression: sympy.Basic) -> Any:
    """What it becomes; None where it stays the object that it is, which an equal one of another call is not."""
    if isinstance(expression, NearZero) or not parts_of_kinds(expression, (*KNOWN, sympy.Pow, PowerTimesLog)):
        return None
    parts = [without_cancellation(part) for part in expression.args]
    held = {"evaluate": False} if isinstance(expression, HELD) else {}
    found = expression if all(map(is_, parts, expression.args)) else expression.func(*parts, **held)
    found = _of_roots(found) if isinstance(found, sympy.Add) else found
    found = _lessened(found) if isinstance(found, sympy.Add) else found
    found = in_series(found) if isinstance(found, sympy.Add) else found
    found = by_conjugate(found) if isinstance(found, sympy.Add) else found
    found = _cancelled(found) if isinstance(found, sympy.Mul) else found
    found = _of_logarithm(found) if isinstance(found, sympy.log) else found
    return None if found is expression else found


def _of_logarithm(logarithm: sympy.log) -> Any:
    """The logarithm; of a hyperbolic cosine, and of a quotient of which the sides share terms, by what is above 1."""
    [of] = logarithm.args
    if isinstance(of, sympy.cosh):
        size = sympy.Abs(of.args[0])
        near = sympy.log(1 + _LESSENED[sympy.cosh](of.args[0])), size < 1
        # Farther away it does not overflow.
        return NearZero(near, (size + log1p(sympy.exp(-2 * size)) - sympy.log(2), True), evaluate=False)
    above, below = sympy.fraction(of)
    less, both = above - below, above + below
    if below == 1 or len(sympy.Add.make_args(less)) >= len(sympy.Add.make_args(above)):
        return logarithm
    # Of both sides of a number it is odd in what is between them.
    near = 2 * sympy.atanh(less / both) if both.is_number else log1p(less / below)
    return NearZero((near, sympy.Abs(less / below) < sympy.S.Half), (logarithm, True), evaluate=False)


def _cancelled(product: sympy.Mul) -> Any:
    """The product; where in a case near zero what is divided by cancels with factors, these are within the cases."""
    for case in product.args:
        if isinstance(case, NearZero):
            (left, near), (stated, _) = case.args
            rest = _cofactor(product, case)
            bases = {f.as_base_exp()[0] for found in (left, stated) for f in sympy.Mul.make_args(found)}
            beside = sympy.Mul(*(f for f in sympy.Mul.make_args(rest) if f.as_base_exp()[0] in bases))
            if any(_divisors(beside, found) - _divisors(beside * found) for found in (left, stated)):
                within = NearZero((beside * left, near), (beside * stated, True), evaluate=False)
                return rest / beside * within
    return product


def _divisors(*products: Any) -> set[Any]:
    return divisors(factor for product in products for factor in sympy.Mul.make_args(product))


def _of_roots(total: sympy.Add) -> Any:
    """The sum, in which c (1 + u)^(1/2) - c is c u/(1 + (1 + u)^(1/2)) where u is small, and so for other powers."""
    for term in total.args:
        for root in (factor for factor in sympy.Mul.make_args(term) if factor.is_Pow):
            base, power = root.as_base_exp()
            factor = _cofactor(term, root)
            exact = base.is_Symbol or (base.is_Add and sympy.S.One in base.args)
            by_root = power in _POWERS and exact
            if (by_root or not (power.is_Rational or base.is_number)) and root.is_Pow and -factor in total.args:
                small = base - 1 if by_root else power * sympy.log(base)
                left = small * _POWERS[power](sympy.sqrt(base)) if by_root else expm1(small, evaluate=False)
                near = NearZero((left, sympy.Abs(small) < 1), (root - 1, True), evaluate=False)
                return sympy.Add(factor * near, *(other for other in total.args if other not in (term, -factor)))
    return total


def _lessened(total: sympy.Add) -> Any:
    """The sum, in which a function from which the first terms of its series are taken is what is left of the series."""
    terms = list(total.args)
    split = [(term, [f for f in sympy.Mul.make_args(term) if isinstance(f, KNOWN)]) for term in terms]
    bases = {factor.as_base_exp()[0] for term, of in split if not of for factor in sympy.Mul.make_args(term)}
    for term, functions in split:
        for f in functions:
            series = with_series(f)
            of: Any = type(series)
            kind, (times, angle) = ANALYTIC.get(of), series.args[0].as_coeff_Mul()
            inside = {factor.as_base_exp()[0] for factor in sympy.Mul.make_args(_terms_of(angle)[0])}
            if kind is None or isinstance(f, sympy.atan2) or not (of in _LESSENED or inside <= bases):
                continue
            taken: list[Any] = []
            order, count, factor = kind.first, 0, _cofactor(term, f)
            while set(first := _terms_of(-factor * coefficient_of(of, order) * (times * angle) ** order)) <= set(terms):
                taken, order, count = [*taken, *first], order + kind.step, count + 1
            if term not in terms or not taken or (of is sympy.cos and count == 1):
                # Of 1 - cos(x) programs lose nothing that are cheaper.
                continue
            if count == 1 and of in _LESSENED:
                left = factor * _LESSENED[of](f.args[0])
            else:
                left = factor * angle**order * left_of(of, order, times, angle, square_of(angle))
                left = near_zero(left, sympy.Add(term, *taken), angle)
            terms = [left, *(each for each in terms if each not in (term, *taken))]
    return _of_differences(terms) if len(terms) < len(total.args) or len(_exponentials(terms)) > 1 else total


def _terms_of(total: sympy.Expr) -> tuple[Any, ...]:
    terms: tuple[Any, ...] = sympy.Add.make_args(total)
    return terms


def _cofactor(term: sympy.Expr, factor: sympy.Expr) -> Any:
    return sympy.Mul(*(each for each in sympy.Mul.make_args(term) if each is not factor))


def _exponentials(terms: Sequence[sympy.Expr]) -> list[tuple[sympy.Expr, sympy.Expr, sympy.Expr]]:
    """The terms that are multiples of an exponential, their factors, and of what it is taken."""
    split = ((term, f) for term in terms for f in sympy.Mul.make_args(term) if isinstance(f, sympy.exp))
    return [(term, _cofactor(term, f), f.exp) for term, f in split]


def _of_differences(terms: list[sympy.Expr]) -> Any:
    """The sum of the terms, in which c exp(a) - c exp(b) is c exp(b) expm1(a - b) where a is close to b."""
    found = sympy.Add(*terms)
    for (one, factor, a), (other, opposite, b) in permutations(_exponentials(terms), 2):
        is_first = factor == -opposite and not factor.could_extract_minus_sign()
        if is_first and {one, other} <= set(terms):
            near = factor * sympy.exp(b) * expm1(a - b), sympy.Abs(a - b) < 1
            terms = [NearZero(near, (one + other, True), evaluate=False), *(t for t in terms if t not in (one, other))]
            found = sympy.Add(*terms)
    return found
