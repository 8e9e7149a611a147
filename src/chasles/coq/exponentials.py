"""Exponentials and logarithms of sums and products in those of their parts, for proofs in Coq."""

from __future__ import annotations

from collections.abc import Iterator
from functools import reduce
from math import gcd, lcm
from typing import Any

import sympy

from chasles.coq.expressions import Unsaid
from chasles.coq.plain import PlainExpressions, polynomial, text_of
from chasles.coq.sympy_words import is_exponential

EXPONENTIAL = {sympy.exp: "exp", sympy.sinh: "sinh", sympy.cosh: "cosh", sympy.tanh: "tanh"}
MOST = 20
"""Exponents and powers beyond this are not taken apart."""


def exponential(plain: PlainExpressions, e: Any) -> Any:
    """An exponential, a hyperbolic function or a power: a product of powers of exponentials; None for what is none."""
    if e.func not in EXPONENTIAL and e is not sympy.E and not (e.is_Pow and is_exponential(e)):
        return None
    function = EXPONENTIAL.get(e.func, "exp")
    product, parts = sympy.Integer(1), list[str]()
    for part, value, count in _factors(plain, _exponent(plain, e)):
        product *= value**count
        parts += [part if count > 0 else f"(- {part})"] * abs(count)
    if function == "exp":
        value = product
    else:
        sine, cosine = product - 1 / product, product + 1 / product
        value = sympy.cancel({"sinh": sine / 2, "cosh": cosine / 2, "tanh": sine / cosine}[function])
    plain.facts += plain.nonzero(value)
    plain.named |= {plain.labels[str(e)]: value} if str(e) in plain.labels else {}
    name = plain.remember(e)
    opened = "repeat first [rewrite exp_plus | rewrite exp_Ropp | rewrite exp_0 | rewrite exp_ln by above]"
    logs = "".join(f"rewrite <- ?of'{each}; " for text, each in plain.remembered.items() if text.startswith("ln "))
    equal = f"apply f_equal; {logs}{plain.rewritten}first [lra | reckon]"
    total = f"{function} ({' + '.join(parts) or '0'})"
    steps = f"transitivity ({total}); [{equal} | unfold tanh, sinh, cosh; {opened}; reckon]"
    plain.value(name, value, f"(rewrite of'{name}; unfold Rpower; {steps})")
    return value


def _exponent(plain: PlainExpressions, e: Any) -> Any:
    """What the exponential is of."""
    if e is sympy.E:
        return sympy.Integer(1)
    if e.is_Pow:
        return sympy.expand(plain(e.exp) * plain(sympy.log(e.base)))
    return sympy.expand(plain(e.args[0]))


def _factors(plain: PlainExpressions, exponent: Any) -> Iterator[tuple[str, Any, int]]:
    """What is added in an exponent, as spelled, its exponential, and how often."""
    for term, multiple in exponent.as_coefficients_dict().items():
        if term in plain.logarithms and multiple.is_Integer:
            unit, value = sympy.Integer(1), plain.logarithms[term]
        else:
            unit = plain.units.setdefault(term, _unit(plain, term, multiple))
            value = plain.symbol(f"(exp {text_of(unit * term)})", "positive")
            if value not in plain.exponents:
                plain.exponents[value] = unit * term
                plain.facts.append(f"pose proof (exp_pos {text_of(unit * term)}).")
                plain.facts.append(f"assert ({value} <> 0) by (apply Rgt_not_eq; assumption).")
        count = multiple / unit
        if not count.is_Integer or abs(count) > MOST:
            raise Unsaid(f"no proof is written about the exponent {multiple * term}")
        yield text_of(unit * term), value, int(count)


def _unit(plain: PlainExpressions, term: Any, multiple: Any) -> Any:
    """What all multiples of a term in the exponents of the question are whole multiples of."""
    asked = sympy.Tuple(*plain.statement.asked.expressions)
    everything = sorted(asked.atoms(sympy.Pow, *EXPONENTIAL, sympy.coth, sympy.sech, sympy.csch), key=str)
    exponents = [_exponent(plain, e) for e in everything if not e.is_Pow or is_exponential(e)]
    found = [multiple, *(each.as_coefficients_dict().get(term, sympy.Integer(0)) for each in exponents)]
    below = reduce(lcm, (int(each.q) for each in found))
    return sympy.Rational(reduce(gcd, (int(each * below) for each in found)), below)


def logarithm(plain: PlainExpressions, e: Any) -> Any:
    """A logarithm: the sum of those of the factors, which are positive; None for what is none."""
    if e.func is not sympy.log:
        return None
    inside = plain(e.args[0])
    total, above, below = sympy.Integer(0), list[str](), list[str]()
    for factor, count in _positive_factors(plain, inside):
        of = plain.exponents.get(factor)
        text = polynomial(factor)
        if of is None:
            of = plain.symbol(f"(ln {text})", "positive" if factor.is_Integer else "real")
            if factor.is_Integer:
                plain.facts.append(f"assert (0 < ln {text}) by (rewrite <- ln_1; apply ln_increasing; lra).")
            plain.logarithms[of] = factor
        total += count * of
        (above if count > 0 else below).extend([text] * abs(count))
    product = " * ".join(above) or "1"
    product = f"({product}) / ({' * '.join(below)})" if below else product
    name = plain.remember(e)
    opened = "repeat first [rewrite log_over by above | rewrite ln_mult by above | rewrite ln_exp | rewrite ln_1]"
    steps = f"transitivity (ln ({product})); [apply f_equal; {plain.rewritten}reckon | {opened}; reckon]"
    plain.value(name, total, f"(rewrite of'{name}; {steps})")
    return total


def _positive_factors(plain: PlainExpressions, inside: Any) -> Iterator[tuple[Any, int]]:
    """What is positive, and to which powers it is multiplied."""
    sign = sympy.Integer(1)
    for side, way in zip(sympy.fraction(sympy.together(inside)), (1, -1), strict=True):
        number, factors = sympy.factor_list(side)
        sign *= sympy.sign(number)
        yield from ((sympy.Integer(prime), way * count) for prime, count in sympy.factorint(abs(number)).items())
        for factor, count in factors:
            value = next((each for each in (factor, -factor) if _is_positive(plain, each)), None)
            if value is None or count > MOST:
                raise Unsaid(f"no proof is written of the logarithm of what has the factor {factor}")
            sign *= 1 if value == factor else (-1) ** count
            yield value, way * count
    if sign != 1:
        raise Unsaid("no proof is written of the logarithm of what is not seen to be positive")


def _is_positive(plain: PlainExpressions, e: Any) -> bool:
    """Whether something is positive: visibly, or because it is assumed."""
    if e.is_positive:
        return True
    ratios = (sympy.cancel(plain(each) / e) for each in plain.statement.positive)
    return any(ratio.is_Rational and ratio > 0 for ratio in ratios)
