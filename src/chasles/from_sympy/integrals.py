"""Integrals of sums of products of powers, exponentials, cosines and sines: an antiderivative at both ends.

In complex exponentials, x^n e^(a x) is the derivative of e^(a x) (x^n/a - n x^(n - 1)/a^2 + ...).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy

from chasles.checker.expressions.complexes import OF_COMPLEX
from chasles.checker.expressions.visible import is_running, kinds_of, signs_of
from chasles.from_sympy.antiderivatives import at_end, by_rules, is_continuous
from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.decimals import with_values
from chasles.from_sympy.inequalities import signed
from chasles.from_sympy.opening import excerpt
from chasles.from_sympy.side_conditions import listed
from chasles.problems.variables import Untreatable

CIRCULAR = (sympy.sin, sympy.cos, sympy.sinh, sympy.cosh)
LARGEST_POWER = 32


def without_integrals(said: tuple[Any, ...]) -> tuple[Any, ...]:
    """What is said, with their values for integrals between limits; what they divide by does not vanish.

    Raises `Untreatable` for integrals without limits, and for those whose value is not known here.
    """
    found = {part for e in expressions_in(said) for part in e.atoms(sympy.Integral)}
    if not found:
        return said
    outer = found - {part for integral in found for part in integral.function.atoms(sympy.Integral)}
    known = {e: each for _, item in listed(said[2], "given") for e, each in signed(item).items() if e.is_Symbol}
    back = {each: e for e, each in known.items()}
    values, lost = dict[Any, Any](), dict[Any, None]()
    for integral in sorted(outer, key=str):
        value, divided = _value(integral.xreplace(known))
        values[integral] = value.xreplace(back)
        # Of what antiderivatives divide by, 1/n is lost where sin(2*pi*n) is zero.
        lost |= dict.fromkeys(_divisors(integral))
        lost |= dict.fromkeys(e for each in divided if (e := each.xreplace(back)) not in _divisors(values[integral]))
    lhs, rhs, given, nonzero = with_values(said, values)
    return without_integrals((lhs, rhs, given, [*(item for _, item in listed(nonzero, "nonzero")), *lost]))


def _divisors(e: Any, *bound: Any) -> Iterator[Any]:
    """What an expression divides by, whatever is bound in it, as are the variables of integrals."""
    powers = sorted((power for power in e.atoms(sympy.Pow) if power.exp.is_negative), key=str)
    bound = (*bound, *(symbol for part in e.atoms(sympy.Integral) for symbol in part.variables))
    factors = (f for power in powers for f in sympy.Mul.make_args(sympy.factor_terms(power.base)))
    unlike = (sympy.S.One if f.is_number else -f if f.could_extract_minus_sign() else f for f in factors)
    yield from (base for base in unlike if not base.has(*bound) and 0 in signs_of(base))


def _value(integral: Any) -> tuple[Any, list[Any]]:
    """The value of an integral, and what antiderivatives divide by; those in it and the inner one come first."""
    inner = {part: _value(part) for part in integral.function.atoms(sympy.Integral)}
    term = integral.function.xreplace({part: value for part, (value, _) in inner.items()})
    divided = [each for _, more in inner.values() for each in more]
    for index, *ends in integral.limits:
        if len(ends) < 2:
            raise Untreatable(f"{excerpt(integral)} is not treated: without limits it is known up to a constant only")
        # Along a path that is not real, what is conjugate and what is real are no antiderivatives.
        if any(end.is_extended_real is False or end.has(*OF_COMPLEX, sympy.nan, sympy.zoo) for end in ends):
            raise Untreatable(f"{excerpt(integral)} is not treated: its limits are not seen to be real")
        large = sympy.Dummy(positive=True)
        finite = [sympy.sign(end) * large if end.is_infinite else end for end in ends]
        if not is_running(index, finite, "real"):
            told = f"what is assumed of {index} need not hold from {ends[0]} to {ends[1]}"
            raise Untreatable(f"{excerpt(integral)} is not treated: {told}")
        x = sympy.Dummy(str(index), real=True, **kinds_of(signs_of(finite[0]) | signs_of(finite[1])))
        before = _before(term.xreplace({index: x}), x, ends, integral)
        low, high = (at_end(before, x, end) for end in ends)
        if low is None or high is None:
            raise Untreatable(f"{excerpt(integral)} is not treated: what it tends to at an infinite limit is not known")
        divided += _divisors(before, x)
        term = sympy.expand(high - low)
    return term, divided


def _before(term: Any, x: Any, ends: Any, integral: Any) -> Any:
    """What has the term as its derivative between two ends; raises `Untreatable` if nothing is found."""
    if ends[0] == ends[1] and not ends[0].is_infinite and is_continuous(term, x, ends):
        return sympy.S.Zero
    parts = sympy.Add.make_args(_in_exponentials(term, x))
    try:
        before = sympy.expand(sympy.Add(*(_antiderivative(part, x, integral) for part in parts)))
    except Untreatable:
        if (found := by_rules(term, x, ends)) is None:
            raise
        return found
    # That the derivative is right between the ends will do.
    y = sympy.Dummy(positive=True) if x.is_nonnegative else x
    gap = _in_exponentials(before.xreplace({x: y}).diff(y) - term.xreplace({x: y}), y)
    if sympy.expand(sympy.fraction(sympy.together(gap))[0]) != 0:
        raise Untreatable(f"{excerpt(integral)} is not treated: no antiderivative was found")
    return before


def _in_exponentials(e: Any, x: Any) -> Any:
    """The expression multiplied out, functions of angles and hyperbolic ones of the variable as exponentials."""
    calls = {call: call.rewrite(sympy.exp) for call in e.atoms(*CIRCULAR) if call.has(x)}
    powers = {power for power in e.atoms(sympy.Pow) if power.exp.has(x)}
    return sympy.expand(e.xreplace(calls | {power: sympy.exp(power.exp * sympy.log(power.base)) for power in powers}))


def _antiderivative(part: Any, x: Any, whole: Any) -> Any:
    """What has a product as its derivative, wherever the variable may be, in functions of real numbers."""
    (constant, rest), power, exponent = part.as_independent(x, as_Add=False), sympy.S.Zero, sympy.S.Zero
    for factor in sympy.Mul.make_args(rest):
        base, above = factor.as_base_exp()
        if base == x and not above.has(x):
            power += above
        elif not base.has(x) and (base is sympy.E or signs_of(base) == {1}):
            exponent += sympy.expand(above * sympy.log(base))
        elif factor != 1:
            raise _unknown(factor, x, whole)
    rate = exponent.coeff(x)
    fixed = sympy.expand(exponent - rate * x)
    known = power.is_Integer and 0 <= power <= LARGEST_POWER
    known = known or (rate == 0 and bool(x.is_positive or (x.is_nonnegative and power.is_nonnegative)))
    if fixed.has(x) or not known:
        raise _unknown(rest, x, whole)
    if rate == 0:
        return constant * _real(fixed) * (sympy.log(x) if power == -1 else x ** (power + 1) / (power + 1))
    turn = rate.coeff(sympy.I)
    growth = sympy.expand(rate - sympy.I * turn)
    inverse = (growth - sympy.I * turn) / (growth**2 + turn**2)
    terms = ((-1) ** k * sympy.ff(power, k) * x ** (power - k) * inverse ** (k + 1) for k in range(int(power) + 1))
    return constant * _real(exponent) * sympy.Add(*terms)


def _real(exponent: Any) -> Any:
    """The exponential in functions of real numbers."""
    turn = exponent.coeff(sympy.I)
    return sympy.exp(exponent - sympy.expand(sympy.I * turn)) * (sympy.cos(turn) + sympy.I * sympy.sin(turn))


def _unknown(part: Any, x: Any, whole: Any) -> Untreatable:
    told = excerpt(part.xreplace({x: sympy.Symbol(x.name)}))
    return Untreatable(f"{excerpt(whole)} is not treated: no antiderivative of {told} is known between these limits")
