"""An inequality without an increasing function of both sides, or a rounding of one: the same is said without it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy

from chasles.checker.expressions.visible import signs_of

RISING: Mapping[type, int] = {
    **dict.fromkeys((sympy.exp, sympy.log, sympy.sinh, sympy.asinh, sympy.tanh, sympy.atanh, sympy.acosh), 1),
    **dict.fromkeys((sympy.asin, sympy.atan, sympy.erf), 1), sympy.acos: -1,
}  # fmt: skip
"""Functions that rise or fall strictly on the interval on which they are real."""
INVERSE_OF: Mapping[type, Any] = {
    sympy.exp: sympy.log, sympy.sinh: sympy.asinh, sympy.asinh: sympy.sinh, sympy.tanh: sympy.atanh,
    sympy.atan: sympy.tan, sympy.log: sympy.exp,
}  # fmt: skip
"""Functions that rise everywhere, or where they are real, and their inverse functions."""
BETWEEN: Mapping[type, tuple[Any, Any]] = {
    sympy.exp: (0, sympy.oo), sympy.tanh: (-1, 1), sympy.atan: (-sympy.pi / 2, sympy.pi / 2),
}  # fmt: skip
"""Between what their values are."""
Relation = tuple[Any, Any, bool]
"""The side that is less, the other one, and whether they are not equal."""


def plainer(claim: Any) -> Any:
    """An inequality that holds just where another one does, as far as both sides of that are defined; or the same.

    f(a) < f(b) says a < b of an increasing function, log(a) < b says a < exp(b), and a <= floor(b) says a <= b of an
    integer a.
    """
    if not isinstance(claim, sympy.Ge | sympy.Gt | sympy.Le | sympy.Lt):
        return claim
    said = claim.lts, claim.gts, isinstance(claim, sympy.Lt | sympy.Gt)
    found = _without_rounding(*said) or _without_function(*said) or _without_logarithm(*said)
    if found is None:
        return claim
    less, more, strict = found
    return (sympy.Lt if strict else sympy.Le)(less, more, evaluate=False)


def of_arguments(item: Any) -> Any:
    """The same said of the arguments of a function that rises: exp(x) > 1 says x > 0; or the inequality.

    Of a logarithm it is said where it is seen then to be real: log(x) > 1 says x > e, but log(x) < 1 not only x < e.
    """
    kind = next((type(side) for side in item.args if type(side) in INVERSE_OF), None)
    if kind is None or item.has(sympy.I) or any(len(side.args) > 1 for side in item.args if type(side) is kind):
        return item
    sides = [side.args[0] if type(side) is kind else _argument(side, kind) for side in item.args]
    if None in sides or (kind is sympy.log and signs_of(sides[item.args.index(item.lts)]) != {1}):
        return item
    return item.func(*sides, evaluate=False)


def _argument(value: Any, kind: type) -> Any:
    """Of what a number is the value; None if it is none or none is seen."""
    low, high = BETWEEN.get(kind, (-sympy.oo, sympy.oo))
    seen = value.is_number and value.is_real and (value > low) is sympy.true and (value < high) is sympy.true
    return INVERSE_OF[kind](value) if seen else None


def _without_rounding(less: Any, more: Any, strict: bool) -> Relation | None:
    if not (is_whole(less) and is_whole(more)):
        return None
    by_less, by_more = int(strict), int(not strict)
    if isinstance(less, sympy.floor):
        return less.args[0], more + by_more, True
    if isinstance(more, sympy.floor):
        return less + by_less, more.args[0], False
    if isinstance(less, sympy.ceiling):
        return less.args[0], more - by_less, False
    return (less - by_more, more.args[0], True) if isinstance(more, sympy.ceiling) else None


def is_whole(e: Any) -> bool:
    """Whether an expression is a sum of integral multiples of integers."""
    terms = (term.as_coeff_Mul() for term in sympy.Add.make_args(e))
    return all(n.is_Integer and (e.is_integer or isinstance(e, sympy.floor | sympy.ceiling)) for n, e in terms)


def _without_function(less: Any, more: Any, strict: bool) -> Relation | None:
    one, other = less.as_coeff_Mul(), more.as_coeff_Mul()
    if one[0] != other[0]:
        return None
    inside = _arguments(one[1], other[1])
    if inside is None:
        return None
    low, high, rises = inside
    return (low, high, strict) if rises == one[0].is_positive else (high, low, strict)


def _arguments(one: Any, other: Any) -> tuple[Any, Any, bool] | None:
    """The arguments of a monotone function that both have, and whether it rises."""
    if type(one) is type(other) and type(one) in RISING and len(one.args) == len(other.args) == 1:
        return one.args[0], other.args[0], RISING[type(one)] > 0
    (a, m), (b, n) = one.as_base_exp(), other.as_base_exp()
    if a.is_Rational and b.is_Rational and a > 0 < b and {m, n} - {1}:
        return m * sympy.log(a), n * sympy.log(b), True
    # The powers of what is negative are not real, unless the exponent is an integer.
    rises = m.is_Rational and (m.is_odd if m.is_Integer else True) and m > 0 and m != 1
    return (a, b, True) if m == n and rises else None


def _without_logarithm(less: Any, more: Any, strict: bool) -> Relation | None:
    if isinstance(less, sympy.log) and len(less.args) == 1:
        return less.args[0], sympy.exp(more), strict
    if isinstance(more, sympy.log) and len(more.args) == 1:
        return sympy.exp(less), more.args[0], strict
    return None
