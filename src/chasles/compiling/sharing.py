"""What do sums share with sums, and products with products? Terms and factors that come together more than once.

What the products of a sum share is taken out: x y + x z as x (y + z), a polynomial as Horner's scheme.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import reduce
from typing import Any

import sympy
from sympy.simplify.cse_main import Unevaluated, match_common_args

from chasles.compiling.variables import HELD

Monomial = dict[sympy.Expr, int]
"""Whole powers by what is raised to them; the number in front has the key 1, and the power 1."""


def common(expressions: Iterable[sympy.Basic]) -> dict[sympy.Basic, Any]:
    """Sums and products spelled as such of others, so that what they share is one of them; opposite ones are one.

    SymPy's search for common terms and factors is taken, but not that for signs, which orders the terms of all sums: of
    a sum and its opposite that with fewer negative terms is taken, or else the first.
    """
    spelled: dict[sympy.Basic, Any] = {}
    sums: dict[frozenset[tuple[Any, Any]], sympy.Basic] = {}
    products: dict[sympy.Basic, None] = {}
    for part in parts_before(expressions):
        taken = part
        if isinstance(part, sympy.Add):
            terms = [term.as_coeff_Mul() for term in part.args]
            opposite = frozenset((-number, of) for number, of in terms)
            if opposite in sums or 2 * sum(bool(number.is_negative) for number, _ in terms) > len(terms):
                taken = sums.setdefault(opposite, sympy.Add(*(-term for term in part.args)))
            else:
                sums[frozenset(terms)] = part
        elif isinstance(part, sympy.Mul):
            taken = -part if part.args[0].is_Number and part.args[0].is_negative else part
            if isinstance(taken, sympy.Mul):
                products[taken] = None
        if taken is not part:
            spelled[part] = Unevaluated(sympy.Mul, (sympy.S.NegativeOne, taken))
    match_common_args(sympy.Add, list(sums.values()), spelled)
    match_common_args(sympy.Mul, list(products), spelled)
    return spelled


def repeated(entries: Sequence[sympy.Basic], spelled: Mapping[sympy.Basic, Any]) -> Iterator[sympy.Basic]:
    """The parts that come more than once where each part is written once."""
    seen: set[sympy.Basic] = set()
    waiting = list(entries)
    while waiting:
        part = waiting.pop()
        if part in seen:
            yield part
        else:
            seen.add(part)
            waiting += [inner for inner in spelled.get(part, part).args if not isinstance(inner, int)]


def parts_before(expressions: Iterable[sympy.Basic]) -> Iterator[sympy.Basic]:
    """All parts of the expressions, each once, those of a part before it."""
    seen: set[sympy.Basic] = set()
    waiting = list(expressions)[::-1]
    while waiting:
        part = waiting[-1]
        missing = [inner for inner in reversed(part.args) if inner not in seen and inner.args]
        if missing and part not in seen:
            waiting += missing
            continue
        waiting.pop()
        if part not in seen:
            seen.add(part)
            yield part


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
