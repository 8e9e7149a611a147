"""What is divided by, and which expressions divide: functions of angles are quotients of sines and cosines."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import sympy

from chasles.checker.expressions.complexes import QUOTIENTS
from chasles.checker.expressions.quantities import is_atom
from chasles.checker.expressions.readings import CIRCULAR
from chasles.checker.expressions.visible import signs_of
from chasles.from_sympy.atoms import real_copy
from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.opening import FunctionSymbol, Signed


@dataclass(frozen=True, slots=True)
class DivisorText:
    """How to say that something does not vanish; `evident` if it need not be said."""

    text: str
    evident: bool


def divisor_of(expression: Any, origins: Mapping[Any, Any] = {}) -> DivisorText:
    """What is said of a divisor: nothing of a number, nor of what SymPy sees to have one sign.

    `origins` are what variables in it stand for.
    """
    named = is_atom(expression) and not (isinstance(expression, FunctionSymbol) and not isinstance(expression, Signed))
    value = _with_cosines(expression)
    # Term by term, as the checker sees it.
    copy = sympy.expand(real_copy(value))
    seen = copy.is_positive or copy.is_negative or (copy.is_nonzero and not named)
    evident = (not value.free_symbols and value != 0) or bool(seen and not expression.has(Signed))
    spelled = expression if named else expression.xreplace(origins)
    evident = evident or (not named and spelled.has(sympy.Pow) and 0 not in signs_of(spelled))
    return DivisorText(f"{spelled} {'> 0' if expression.is_positive else '!= 0'}", evident)


def _with_cosines(e: Any) -> Any:
    """The expression without squares of sines, so that the sum of both squares is seen to be one."""
    squares = {p for p in e.atoms(sympy.Pow) if isinstance(p.base, sympy.sin) and p.exp.is_Integer and p.exp > 1}
    values = {p: (1 - sympy.cos(p.base.args[0]) ** 2) ** (p.exp // 2) * p.base ** (p.exp % 2) for p in squares}
    return sympy.expand(e.xreplace(values)) if values else e


def is_reciprocal(e: Any) -> bool:
    """Whether the expression is a power with a negative exponent."""
    return isinstance(e, sympy.Pow) and bool(e.exp.is_Rational and e.exp.is_negative)


def divides(e: Any) -> bool:
    """Whether the expression, as a rational function, divides by something."""
    if isinstance(e, sympy.Add | sympy.Mul | sympy.Abs):
        return any(map(divides, e.args))
    if isinstance(e, sympy.Pow):
        return is_reciprocal(e) or divides(e.base)
    return isinstance(e, sympy.sign) or bool(CIRCULAR.get(e.func, ("", ""))[1])


def in_sines(e: Any) -> Any:
    """The expression with every other function of an angle written as a quotient of sines and cosines."""
    calls = e.atoms(*(function for function, (_, below) in CIRCULAR.items() if below))
    return e.xreplace({call: QUOTIENTS[call.func](*call.args) for call in calls})


def lost_divisors(said: Any, put: Any, values: Mapping[Any, Any]) -> list[Any]:
    """What was divided by, and where values are put in is not any more: SymPy cancels it."""
    before = dict.fromkeys(_numerator(e.xreplace(values)) for e in _divisors(said) if e.has(*values))
    if not (unsure := [e for e in before if not e.is_nonzero]):
        return []
    left = {e for divisor in _divisors(put) for e in (_numerator(divisor), _numerator(-divisor))}
    return [e for e in unsure if e not in left]


def _numerator(e: Any) -> Any:
    """What vanishes where the expression does."""
    return sympy.expand(sympy.fraction(sympy.together(sympy.expand_trig(e)))[0]).as_coeff_Mul(rational=True)[1]


def _divisors(said: Any) -> Iterator[Any]:
    """What is divided by, also inside of functions of angles."""
    for e in expressions_in(said):
        yield from (in_sines(power.base) for power in e.atoms(sympy.Pow) if is_reciprocal(power))
        yield from (sympy.fraction(in_sines(call))[1] for call in e.atoms(*CIRCULAR))
