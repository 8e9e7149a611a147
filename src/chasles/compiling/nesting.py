"""Sums of products with what they share taken out: x y + x z as x (y + z), a polynomial as Horner's scheme.

Nothing is multiplied out, so that what the sum loses by rounding does not grow; what a sum shares is looked for as it
is written.
"""

from __future__ import annotations

from collections import Counter
from functools import reduce

import sympy

from chasles.compiling.variables import HELD

Monomial = dict[sympy.Expr, int]
"""Whole powers by what is raised to them; the number in front has the key 1, and the power 1."""


def nested(expression: sympy.Basic, done: dict[sympy.Basic, sympy.Basic] | None = None) -> sympy.Basic:
    """The expression with every sum in it nested; conditions stay as they are. What is `done` is not done again."""
    done = {} if done is None else done
    if not expression.args or isinstance(expression, sympy.logic.boolalg.Boolean):
        return expression
    if expression not in done:
        parts = [nested(part, done) for part in expression.args]
        # Functions of what is the same are not evaluated again: SymPy would ask what it knows of it for long.
        held = {"evaluate": False} if isinstance(expression, HELD) else {}
        changed = expression if list(expression.args) == parts else expression.func(*parts, **held)
        done[expression] = (
            _sum([_factors(term) for term in changed.args]) if isinstance(changed, sympy.Add) else changed
        )
    return done[expression]


def _factors(term: sympy.Expr) -> tuple[sympy.Expr, Monomial]:
    """A number, and the powers that it is multiplied by."""
    number, powers = sympy.S.One, Counter[sympy.Expr]()
    for factor in sympy.Mul.make_args(term):
        base, exponent = factor.as_base_exp() if isinstance(factor, sympy.Pow) else (factor, sympy.S.One)
        if factor.is_number:
            number *= factor
        elif exponent.is_Integer and exponent.is_positive:
            powers[base] += int(exponent)
        else:
            powers[factor] += 1
    return number, dict(powers)


def _sum(terms: list[tuple[sympy.Expr, Monomial]]) -> sympy.Expr:
    """The sum of the terms, with what most of them share taken out, again and again."""
    counts = Counter(base for _, powers in terms for base in powers)
    most = max(counts.values(), default=0)
    if most < 2:
        return sympy.Add(*(_product(number, powers) for number, powers in terms))
    shared = min((base for base, count in counts.items() if count == most), key=sympy.default_sort_key)
    with_it = [(number, powers) for number, powers in terms if shared in powers]
    without = [(number, powers) for number, powers in terms if shared not in powers]
    times = min(powers[shared] for _, powers in with_it)
    inner = _sum([(number, _lowered(powers, shared, times)) for number, powers in with_it])
    taken = sympy.Mul(shared**times, inner)
    return sympy.Add(taken, _sum(without)) if without else taken


def _lowered(powers: Monomial, base: sympy.Expr, times: int) -> Monomial:
    left = powers | {base: powers[base] - times}
    return {key: power for key, power in left.items() if power}


def _product(number: sympy.Expr, powers: Monomial) -> sympy.Expr:
    return reduce(sympy.Mul, (base**power for base, power in powers.items()), number)
