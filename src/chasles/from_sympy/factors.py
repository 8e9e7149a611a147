"""Factors of the arguments of logarithms: with which powers they occur, and which of them are positive."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import sympy

from chasles.checker.expressions.quantities import is_atom
from chasles.from_sympy.divisors import in_sines
from chasles.from_sympy.opening import Signed

MOST_OPERATIONS = 200
"""Sums that are larger are not factored."""


def is_entire(part: Any) -> bool:
    """Whether a function, or an operation, is defined for all real numbers, and divides by nothing."""
    if isinstance(part, sympy.Pow):
        return bool(part.exp.is_Integer and part.exp.is_positive)
    return is_atom(part) or not part.args or isinstance(part, sympy.Add | sympy.Mul | sympy.sin | sympy.cos)


def is_evident(base: Any) -> bool:
    """Whether a factor is positive wherever it is defined, all symbols being real."""
    real = {part: sympy.Dummy(real=True) for part in _atoms(base) if isinstance(part, Signed) or part.is_real is None}
    return bool(base.xreplace(real).is_positive)


def _atoms(expression: Any) -> list[Any]:
    """The atoms of an expression, each once."""
    walk = sympy.preorder_traversal(expression)
    found: dict[Any, None] = {}
    for part in walk:
        if is_atom(part):
            walk.skip()
            found[part] = None
    return list(found)


def factors_of(value: Any) -> list[tuple[Any, Any, Any]]:
    """Factors with the exponents of their sizes, and of their signs; sums are factored where that is quick."""
    sizes: dict[Any, Any] = {}
    signs: dict[Any, Any] = {}
    for factor in sympy.Mul.make_args(sympy.together(in_sines(value))):
        base, power = factor.as_base_exp()
        if not power.is_Rational:
            base, power = factor, sympy.S.One
        inner = base.args[0] if isinstance(base, sympy.Abs) else base
        for part, count in _parts(inner):
            sizes[part] = sizes.get(part, sympy.S.Zero) + count * power
            signs[part] = signs.get(part, sympy.S.Zero) + (count * power if inner is base else 0)
    return [(part, power, signs[part]) for part, power in sizes.items() if part != 1 and (power or signs[part])]


def _parts(base: Any) -> list[tuple[Any, int]]:
    """A product, a quotient of numbers or a sum by its factors."""
    if base.is_Add and base.count_ops() <= MOST_OPERATIONS:
        base = sympy.expand(base)
    if base.is_Add and base.count_ops() <= MOST_OPERATIONS:
        with suppress(sympy.PolynomialError):
            content, rest = sympy.factor_list(base)
            return [*rest, (content, 1)]
    if base.is_Mul:
        return [(part.base, int(part.exp)) if part.is_Pow and part.exp.is_Integer else (part, 1) for part in base.args]
    return [(sympy.Integer(base.p), 1), (sympy.Integer(base.q), -1)] if base.is_Rational else [(base, 1)]
