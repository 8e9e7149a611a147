"""Claims from which others follow: that one holds of any argument, or that arguments are where a function rises.

log(1 + 1/p) < 1/p holds if log(1 + u) < u does for u = 1/p, cos(x) > cos(y) if 0 <= x < y <= pi, and x = y if
sin(x) = sin(y) and both are between -pi/2 and pi/2.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import sympy
from sympy import S, pi
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from chasles.checker.expressions.visible import signs_of
from chasles.from_sympy.bounded_symbols import COMPARED, STRICT
from chasles.from_sympy.domains import BINDING
from chasles.from_sympy.monotone import RISING
from chasles.from_sympy.side_conditions import listed

Parts = tuple[Any, ...]
"""What is less than another, the other, and what holds besides."""
INVERSES: Mapping[type, Any] = {sympy.cos: sympy.acos, sympy.sin: sympy.asin, sympy.tan: sympy.atan}
MONOTONE: Mapping[type, tuple[int, Any, Any]] = {
    **{kind: (rises, -S.Infinity, S.Infinity) for kind, rises in RISING.items()},
    sympy.cos: (-1, S.Zero, pi), sympy.sin: (1, -pi / 2, pi / 2), sympy.tan: (1, -pi / 2, pi / 2),
    sympy.cosh: (1, S.Zero, S.Infinity),
}  # fmt: skip
"""Whether a function rises or falls, and between which arguments."""
REAL = (*INVERSES, sympy.exp, sympy.sinh, sympy.cosh, sympy.tanh, sympy.asinh, sympy.atan, sympy.erf)
"""Those that are real everywhere between them."""
HYPERBOLIC: Mapping[type, Any] = {sympy.asinh: sympy.sinh, sympy.acosh: sympy.cosh, sympy.atanh: sympy.tanh}
"""Inverse hyperbolic functions, and of what they are the inverses."""
SIGNED = {
    frozenset({1}): "positive", frozenset({0, 1}): "nonnegative",
    frozenset({-1}): "negative", frozenset({-1, 0}): "nonpositive",
}  # fmt: skip
"""What is assumed of a symbol that has one of these signs."""


def with_name(claim: Any) -> Any:
    """That a compound argument has a name implies the inequality with this name in its place; the same if none has.

    The argument is the largest after the naming of which none of its symbols is left.
    """
    if not _is_real(claim) or claim.has(AppliedUndef, *BINDING):
        return claim
    for part in dict.fromkeys(_arguments(claim)):
        name = "u_1"
        while any(symbol.name.startswith(name) for symbol in claim.free_symbols):
            name += "_"
        sign = SIGNED.get(signs_of(part))
        symbol = sympy.Symbol(name, real=True, **({sign: True} if sign else {}))
        sides = [side.subs(part, symbol) for side in claim.args]
        same = all(
            sympy.expand(one.xreplace({symbol: part}) - e) == 0 for one, e in zip(sides, claim.args, strict=True)
        )
        if same and not any(side.free_symbols & part.free_symbols for side in sides):
            equation = sympy.Eq(symbol, part, evaluate=False)
            return sympy.Implies(equation, claim.func(*sides, evaluate=False), evaluate=False)
    return claim


def of_values(claim: Any, given: Any) -> Iterator[Any]:
    """What is claimed of two numbers, said of their values by a function of which something is given, and where.

    If it is not real everywhere, something is given of these values themselves: else more would be needed.
    """
    if not _is_real(claim, (*COMPARED, sympy.Equality)):
        return
    stated = [item for _, item in listed(given, "given") if isinstance(item, Relational)]
    calls = {call for item in stated for call in item.atoms(*MONOTONE)}
    for kind in sorted(set(map(type, calls)), key=str):
        rises, low, high = MONOTONE[kind]
        values = [kind(side) for side in claim.args][::rises]
        within = sympy.Lt if kind is sympy.tan else sympy.Le
        ends = [within(low, side) for side in claim.args if low.is_finite]
        ends += [within(side, high) for side in claim.args if high.is_finite]
        real = kind in REAL or calls.issuperset(value for value in values if value.free_symbols)
        known = all(value.free_symbols or (value.is_real and value.is_finite) for value in values)
        if real and known and sympy.false not in ends:
            order = claim.func(*values, evaluate=False)
            yield sympy.And(order, *(end for end in ends if end is not sympy.true), evaluate=False)


def without_inverse(claim: Any) -> Any:
    """An equation solved for the value of an inverse hyperbolic function, said of that of which it is; or the same.

    asinh(x) + asinh(y) = asinh(z) if sinh(asinh(x) + asinh(y)) = z. The argument is the largest.
    """
    if not _is_real(claim, (sympy.Equality,)):
        return claim
    terms = [term.as_coeff_Mul() for term in sympy.Add.make_args(claim.lhs - claim.rhs)]
    calls = sorted(
        ((c, e) for c, e in terms if type(e) in HYPERBOLIC), key=lambda term: (-term[1].count_ops(), str(term))
    )
    if not calls or len(terms) < 3:
        return claim
    multiple, call = calls[0]
    rest = sympy.Add(*(-c / multiple * e for c, e in terms if e != call))
    said = HYPERBOLIC[type(call)](rest, evaluate=False), call.args[0]
    if isinstance(call, sympy.acosh):  # which is the one that is not negative
        said = sympy.Matrix([said[0], sympy.Abs(rest)]), sympy.Matrix([said[1], rest])
    return sympy.Eq(*said, evaluate=False)


def _is_real(claim: Any, kinds: tuple[Any, ...] = COMPARED) -> bool:
    """Whether it is a relation of one of these kinds between numbers that are real where they are defined."""
    complex_ = any(symbol.is_complex and not symbol.is_real for symbol in claim.free_symbols)
    return isinstance(claim, kinds) and not complex_ and not claim.has(sympy.I)


def _arguments(claim: Any) -> Iterator[Any]:
    """What stands in functions and is more than a sum of multiples of symbols, the larger before their parts."""
    for call in sorted(claim.atoms(sympy.Function, sympy.exp, sympy.Pow), key=lambda e: (-e.count_ops(), str(e))):
        for part in sympy.preorder_traversal(call.exp if call.is_Pow else call.args[0]):
            if isinstance(part, sympy.Expr) and part.free_symbols and not _is_affine(part):
                yield part


def _is_affine(e: Any) -> bool:
    polynomial = e.as_poly(*e.free_symbols)
    return polynomial is not None and polynomial.total_degree() < 2


def where_it_rises(claim: Any) -> Any:
    """That a function rises or falls between two arguments, which are as is claimed of its values; else the same."""
    if not _is_real(claim):
        return claim
    less, more, strict = claim.lts, claim.gts, isinstance(claim, STRICT)
    found = _of_angles(less, more) or _of_angles(-more, -less) or _of_powers(less, more, strict)
    if found is None:
        return claim
    low, high, *ends = found
    order = (sympy.Lt if strict else sympy.Le)(low, high, evaluate=False)
    return sympy.And(order, *ends, evaluate=False)


def _of_angles(less: Any, more: Any) -> Parts | None:
    """The lower and the higher argument of sines, tangents or cosines, and between which ends they are."""
    multiple, kind = next(
        ((m, type(e)) for m, e in (less.as_coeff_Mul(), more.as_coeff_Mul()) if type(e) in INVERSES), (0, None)
    )
    if kind is None or multiple <= 0:
        return None
    low, high = (_angle(side / multiple, kind) for side in (less, more))
    if low is None or high is None:
        return None
    if kind is sympy.cos:
        return sympy.Abs(high), sympy.Abs(low), sympy.Le(sympy.Abs(low), pi, evaluate=False)
    within = sympy.Lt if kind is sympy.tan else sympy.Le
    return low, high, within(-pi / 2, low, evaluate=False), within(high, pi / 2, evaluate=False)


def _angle(value: Any, kind: type) -> Any:
    """Of what a value is the sine, the tangent or the cosine, also a number; None if that is not seen."""
    if value.func is kind:
        return value.args[0]
    known = value.is_number and value.is_real and (kind is sympy.tan or (abs(value) <= 1) is sympy.true)
    return INVERSES[kind](value) if known else None


def _of_powers(less: Any, more: Any, strict: bool) -> Parts | None:
    """The bases of powers with one exponent, that neither is negative, and the exponent is not."""
    powers = [e for e in (less, more) if e.is_Pow and e.exp.free_symbols]
    if not powers or any(e not in (S.One, *powers) for e in (less, more)) or len({e.exp for e in powers}) > 1:
        return None
    exponent = powers[0].exp
    low, high = (e.base if e in powers else S.One for e in (less, more))
    right = (sympy.Gt if strict else sympy.Ge)(exponent, 0, evaluate=False)
    return low, high, sympy.Ge(low, 0, evaluate=False), right
