"""What is left of a number to which a function comes close, by a function of its own: 1 - erf(x) is erfc(x).

Of the difference no digit is right where the function is as good as the number; what is left has all of them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from operator import is_
from typing import Any

import sympy

from chasles.compiling.angles import KEPT, parts_of_kinds
from chasles.compiling.elementary import HeldErfc
from chasles.compiling.taylor import NearZero
from chasles.compiling.variables import HELD

_QUARTER = sympy.pi / 2
_LEFT: Mapping[type, Mapping[Any, Callable[[Any], Any]]] = {
    sympy.erf: {1: HeldErfc, -1: lambda a: -HeldErfc(-a)},
    sympy.erfc: {1: sympy.erf, 2: lambda a: HeldErfc(-a)},
    sympy.tanh: {1: lambda a: 2 / (1 + sympy.exp(2 * a)), -1: lambda a: -2 / (1 + sympy.exp(-2 * a))},
    sympy.atan: {_QUARTER: lambda a: sympy.atan2(1, a), -_QUARTER: lambda a: -sympy.atan2(1, -a)},
    sympy.asin: {_QUARTER: sympy.acos, -_QUARTER: lambda a: -sympy.acos(-a)},
    sympy.acos: {_QUARTER: sympy.asin, sympy.pi: lambda a: sympy.acos(-a)},
}
"""For functions, by the number: the number less the function of what goes in."""
_LEFT_OF_SQUARE: Mapping[type, Mapping[Any, Callable[[Any], Any]]] = {
    sympy.tanh: {1: lambda a: sympy.sech(a) ** 2},
}
"""The same for squares of functions."""
_KINDS = tuple(_LEFT)


@lru_cache(KEPT)
def by_complements(expression: Any) -> Any:
    """The expression, in which no function is taken from a number that it comes close to."""
    if not parts_of_kinds(expression, _KINDS) or isinstance(expression, NearZero):
        return expression
    parts = [by_complements(part) for part in expression.args]
    held = {"evaluate": False} if isinstance(expression, HELD) else {}
    found = expression if all(map(is_, parts, expression.args)) else expression.func(*parts, **held)
    return _of_sum(found) if isinstance(found, sympy.Add) else found


def _of_sum(total: sympy.Add) -> Any:
    for term in total.args:
        for factor in sympy.Mul.make_args(term):
            base, power = factor.as_base_exp()
            table = {1: _LEFT, 2: _LEFT_OF_SQUARE}.get(power, {}).get(type(base), {})
            for number, left in table.items():
                times = term / factor
                if -times * number in total.args:
                    rest = (other for other in total.args if other not in (term, -times * number))
                    return sympy.Add(-times * left(base.args[0]), *rest)
    return total
