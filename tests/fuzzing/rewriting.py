"""The same thing said otherwise: a side rewritten by rules that are true wherever both sides have values."""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import Any

import sympy as sp

__all__ = ["distorted", "rewritten"]

Rule = Callable[[Any, Random], Any]


def _expanded(e: Any, draw: Random) -> Any:
    return sp.expand(e)


def _together(e: Any, draw: Random) -> Any:
    return sp.together(e)


def _factored(e: Any, draw: Random) -> Any:
    return sp.factor(e) if sp.count_ops(e) < 25 else e


def _angles_added(e: Any, draw: Random) -> Any:
    return sp.expand_trig(e)


def _in_sines(e: Any, draw: Random) -> Any:
    return e.rewrite(sp.tan, sp.sin).replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x))


def _with_circle(e: Any, draw: Random) -> Any:
    angle = draw.choice(sorted(e.free_symbols, key=str)) if e.free_symbols else sp.Integer(1)
    return e * (sp.sin(angle) ** 2 + sp.cos(angle) ** 2) if e.free_symbols else e


def _with_nothing(e: Any, draw: Random) -> Any:
    if not e.free_symbols:
        return e
    x = draw.choice(sorted(e.free_symbols, key=str))
    return sp.Add(e, sp.Mul(x, sp.Add(x, 1, evaluate=False), evaluate=False), -sp.expand(x * (x + 1)))


def _abs_by_root(e: Any, draw: Random) -> Any:
    return e.replace(sp.Abs, lambda x: sp.sqrt(sp.expand(x**2))) if e.atoms(sp.Symbol) else e


def _root_by_square(e: Any, draw: Random) -> Any:
    roots = sorted((p for p in e.atoms(sp.Pow) if p.exp == sp.Rational(1, 2) and p.base.free_symbols), key=str)
    if not roots:
        return e
    root = draw.choice(roots)
    return e.subs(root, root.base / root) if draw.random() < 0.5 else e + root**2 - sp.expand(root.base)


def _scaled_under_root(e: Any, draw: Random) -> Any:
    k = draw.choice((2, 3, 4, 8))
    return e.replace(
        lambda p: isinstance(p, sp.Pow) and p.exp == sp.Rational(1, 2) and bool(p.base.free_symbols),
        lambda p: sp.sqrt(sp.expand(k * p.base)) / sp.sqrt(k),
    )


def _shifted(e: Any, draw: Random) -> Any:
    turn = draw.choice((2 * sp.pi, -2 * sp.pi, 4 * sp.pi))
    return e.replace(sp.sin, lambda x: sp.sin(sp.Add(x, turn, evaluate=False), evaluate=False))


def _half_angles(e: Any, draw: Random) -> Any:
    return e.replace(sp.cos, lambda x: 1 - 2 * sp.sin(x / 2) ** 2)


RULES: tuple[Rule, ...] = (
    _expanded, _together, _factored, _angles_added, _in_sines, _with_circle, _with_nothing, _abs_by_root,
    _root_by_square, _scaled_under_root, _shifted, _half_angles,
)  # fmt: skip


def rewritten(e: Any, draw: Random, times: int = 2) -> Any:
    """The expression in other words; equal to it where both have values."""
    for _ in range(times):
        other = draw.choice(RULES)(e, draw)
        if sp.count_ops(other) < 60 and not other.has(sp.nan, sp.zoo, sp.oo):
            e = other
    return e


def distorted(e: Any, draw: Random) -> Any:
    """The expression with a slip: it may still be equal to it."""
    parts = [p for p in sp.preorder_traversal(e) if isinstance(p, sp.Expr) and (p.args or p.is_Symbol or p.is_Integer)]
    if not parts:
        return e + 1
    part = draw.choice(parts)
    symbols = sorted(e.free_symbols, key=str) or [sp.Integer(2)]
    other = draw.choice((-part, part + 1, 2 * part, part + draw.choice(symbols), sp.Abs(part), part**2))
    try:
        found = e.xreplace({part: other})
    except (TypeError, ValueError):
        return e + 1
    return e + 1 if found.has(sp.nan, sp.zoo, sp.oo) else found
