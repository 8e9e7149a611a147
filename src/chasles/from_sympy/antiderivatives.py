"""Antiderivatives by the rules of textbooks, as SymPy finds them, where they are continuous between two ends.

That their derivative is what is integrated is seen by multiplying out. At an infinite end a product with an exponential
that decays vanishes, and so does a negative power; inverse tangents and error functions have their limits.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from typing import Any

import sympy
from sympy.integrals.manualintegrate import manualintegrate
from sympy.integrals.rationaltools import ratint

from chasles.checker.expressions.visible import signs_of

LARGEST = 30
"""Longer integrands are not looked at."""
MOST_GENERATORS = 2
LARGEST_POWER, LARGEST_BELOW, LARGEST_DEGREE = 6, 2, 12
"""The largest degrees with parameters or functions, in all and of divisors other than powers, and without them."""
CIRCULAR = (sympy.sin, sympy.cos, sympy.tan, sympy.cot, sympy.sec, sympy.csc)
KNOWN = (
    *CIRCULAR, sympy.exp, sympy.log, sympy.sinh, sympy.cosh, sympy.tanh, sympy.asin, sympy.acos, sympy.atan,
    sympy.asinh, sympy.acosh, sympy.atanh, sympy.erf,
)  # fmt: skip
SMOOTH = (
    sympy.Add, sympy.Mul, sympy.exp, sympy.sin, sympy.cos, sympy.sinh, sympy.cosh, sympy.tanh, sympy.atan, sympy.asinh,
    sympy.erf,
)  # fmt: skip
INVERSE = (sympy.log, sympy.asin, sympy.acos, sympy.atan, sympy.asinh, sympy.acosh, sympy.atanh)
LIMITS = {sympy.atan: sympy.pi / 2, sympy.erf: sympy.S.One, sympy.tanh: sympy.S.One}


def by_rules(term: Any, x: Any, ends: tuple[Any, Any]) -> Any:
    """What has the term as its derivative between the ends, and is continuous there; None if none is found."""
    if not _is_simple(term, x):
        return None
    found = None
    with suppress(NotImplementedError, ValueError, TypeError, AttributeError, RecursionError, sympy.PolynomialError):
        if term.is_rational_function(x) and term.free_symbols == {x}:
            found = ratint(term, x, real=True)
        else:
            found = manualintegrate(sympy.expand(term) if term.has(*INVERSE) else term, x)
    if found is None or found.has(sympy.Integral, sympy.RootSum, sympy.I):
        return None
    # Where a divisor vanishes, the other pieces hold: it is among what is divided by.
    found = found.replace(lambda e: isinstance(e, sympy.Piecewise), lambda e: e.args[0].expr)
    found = found.replace(sympy.asin, lambda u: sympy.atan2(u, sympy.sqrt(sympy.together(1 - u**2))))
    inside = _between(x, *ends)
    found = found.replace(sympy.log, lambda u: sympy.log(-u if signs_of(sympy.together(inside(u))) == {-1} else u))
    gap = sympy.expand(sympy.fraction(sympy.together(found.diff(x) - term))[0])
    return found if gap == 0 and is_continuous(found, x, ends) else None


def _is_simple(term: Any, x: Any) -> bool:
    """Whether an integrand is short, and rational in two generators at the most, in low powers.

    With more of them, SymPy's rules try integrations by parts and substitutions in all orders; with parameters or
    functions it comes to no end soon with divisors whose degree is more than two, nor with those of inverse functions
    that their derivatives do not divide by.
    """
    if term.count_ops() > LARGEST or term.has(sympy.I):
        return False
    generators = _generators(term, x)
    roots = [each for each in generators or () if each.is_Pow]
    if generators is None or len(generators) > MOST_GENERATORS or len(roots) > 1:
        return False
    above, below = sympy.fraction(sympy.together(term))
    if generators == {x} and term.free_symbols == {x}:
        return _degree(above * below, x) <= LARGEST_DEGREE
    divisors = {factor.as_base_exp()[0]: factor for factor in sympy.Mul.make_args(below)}
    rest = sympy.Mul(*(factor for base, factor in divisors.items() if base != x))
    inverse = [each for each in generators if isinstance(each, INVERSE)]
    own = {base for each in inverse for base in _divisors_of_rate(each, x)}
    if inverse and any(base.has(x) and base not in own for base in divisors):
        return False
    known = {root.base for root in roots} if roots and term.free_symbols != {x} else set(divisors)
    if any(base.is_polynomial(x) and _degree(base, x) > 1 for base in divisors if base not in known):
        return False
    return _degree(above * below, x) <= LARGEST_POWER and _degree(rest, x) <= LARGEST_BELOW


def _divisors_of_rate(e: Any, x: Any) -> Iterator[Any]:
    """What the derivative of a function divides by, with both signs, and the variable."""
    below = sympy.fraction(sympy.together(e.diff(x)))[1]
    for base in (x, *(factor.as_base_exp()[0] for factor in sympy.Mul.make_args(below))):
        yield from (base, sympy.expand(-base))


def _degree(product: Any, x: Any) -> int:
    """The degree of a product, functions and roots of the first degree."""
    powers = [factor.args if factor.is_Pow else (factor, 1) for factor in sympy.Mul.make_args(product)]
    return sum(abs(e) * (sympy.degree(base, x) if base.is_polynomial(x) else 1) for base, e in powers if base.has(x))


def _generators(e: Any, x: Any) -> set[Any] | None:
    """What an expression is rational in, and what stands in these; None if a function or power is not known."""
    if not e.has(x) or e == x:
        return {e} & {x}
    inner = [_generators(part, x) for part in e.args]
    if None in inner:
        return None
    found = {each for part in inner for each in part or ()}
    if isinstance(e, sympy.Add | sympy.Mul):
        return found
    if isinstance(e, KNOWN):
        argument = e.args[0].as_coeff_Mul()[1]
        return {sympy.tan(argument) if isinstance(e, CIRCULAR) else e.func(argument)} | found - {x}
    if not (e.is_Pow and e.exp.is_Rational) or abs(e.exp) > LARGEST_DEGREE:
        return None
    return found if e.exp.is_Integer else {e.base ** sympy.Rational(1, e.exp.q)} | (found - {x})


def _between(x: Any, low: Any, high: Any) -> Any:
    """What puts into an expression a number between two ends."""
    d = sympy.Dummy(positive=True)
    finite = [end for end in (low, high) if not end.is_infinite]
    if len(finite) == 2 and low == high:
        value = low
    elif finite[1:]:
        value = (low + high * d) / (1 + d)
    else:
        value = finite[0] + (d if sympy.oo in (low, high) else -d) if finite else sympy.Dummy(real=True)
    return lambda e: e.xreplace({x: value})


def is_continuous(e: Any, x: Any, ends: tuple[Any, Any]) -> bool:
    """Whether an expression is real and differentiable between two ends, and continuous at those that are finite."""
    if not e.has(x) or e == x:
        return True
    if isinstance(e, SMOOTH) or (e.is_Pow and e.exp.is_Integer and e.exp > 0):
        return all(is_continuous(part, x, ends) for part in e.args)
    if not isinstance(e, sympy.log | sympy.atan2) and not (e.is_Pow and e.exp.is_Rational):
        return False
    base = e.args[1] if isinstance(e, sympy.atan2) else e.args[0]
    signs = signs_of(sympy.together(_between(x, *ends)(base)))
    side = signs == {1} or (signs == {-1} and e.is_Pow and e.exp.is_Integer)
    closed = isinstance(e, sympy.atan2) or (e.is_Pow and e.exp > 0)
    at_ends = [signs_of(base.xreplace({x: end})) for end in ends if not end.is_infinite]
    kept = all(each == signs or (closed and each <= signs | {0}) for each in at_ends)
    return bool(side and kept) and all(is_continuous(part, x, ends) for part in e.args)


def at_end(e: Any, x: Any, end: Any) -> Any:
    """The value at an end, or the limit there if it is infinite; None if it is not known."""
    if not end.is_infinite:
        return e.xreplace({x: end})
    y = sympy.Dummy(positive=True)
    terms = sympy.Add.make_args(sympy.expand(e.xreplace({x: y if end is sympy.oo else -y})))
    limits = [_limit(sympy.factor_terms(sympy.factor(term)), y) for term in terms]
    return None if None in limits else sympy.Add(*limits)


def _limit(term: Any, y: Any) -> Any:
    """The limit of a product where a variable grows without bound; None if it is not known."""
    value, rest = term.as_independent(y, as_Add=False)
    degree, exponent, settled = sympy.S.Zero, sympy.S.Zero, True
    for factor in sympy.Mul.make_args(rest):
        base, power = factor.as_base_exp()
        if factor is sympy.S.One:
            continue
        if isinstance(factor, sympy.exp) and factor.args[0].is_polynomial(y):
            exponent += factor.args[0]
        elif base.is_polynomial(y) and power.is_Rational and _is_clear(base, power, y):
            polynomial = sympy.Poly(base, y)
            degree, value = degree + polynomial.degree() * power, value * polynomial.LC() ** power
        elif isinstance(factor, sympy.sin | sympy.cos) and factor.args[0].is_polynomial(y):
            settled = False
        elif (
            type(factor) in LIMITS
            and factor.args[0].is_polynomial(y)
            and len(signs := _leading(factor.args[0], y)) == 1
        ):
            value *= LIMITS[type(factor)] * sympy.Integer(min(signs))
        else:
            return None
    if exponent != 0:
        return sympy.S.Zero if _leading(exponent, y) == {-1} else None
    return sympy.S.Zero if degree < 0 else value if degree == 0 and settled else None


def _is_clear(base: Any, power: Any, y: Any) -> bool:
    """Whether the leading coefficient of a polynomial has a power that is real."""
    signs = _leading(base, y)
    return (power > 0 or 0 not in signs) and (bool(power.is_Integer) or signs <= {0, 1})


def _leading(e: Any, y: Any) -> frozenset[int]:
    return signs_of(sympy.Poly(e, y).LC())
