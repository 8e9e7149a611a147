"""Side conditions as they are handed in: one, a list, a dict of values or a conjunction; others are refused."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import sympy
from sympy.logic.boolalg import Boolean
from sympy.matrices import MatrixBase, MatrixExpr

from chasles.from_sympy.opening import excerpt, opened
from chasles.problems.variables import Untreatable

Said = tuple[str, Any]
"""Where a condition stands, and the condition."""


def listed(conditions: Any, name: str) -> list[Said]:
    """Each of the conditions, with the place where it stands; raises `Untreatable` for what is no list of them."""
    return [said for what, item in _items(conditions, name) for said in _conjuncts(item, what)]


def _items(conditions: Any, name: str) -> Iterator[Said]:
    if isinstance(conditions, Mapping | sympy.Dict):
        if name != "given":
            raise Untreatable(f"{name} is {excerpt(conditions)}: a list is expected, {name}=[...]")
        for key, value in conditions.items():
            what = f"{name}[{key}]"
            opened(key, f"a key of {name}")
            yield what, sympy.Eq(key, value, evaluate=False) if not isinstance(value, str) else value
    elif isinstance(conditions, sympy.Expr | Boolean | MatrixBase | MatrixExpr):
        yield name, conditions
    elif isinstance(conditions, Iterable) and not isinstance(conditions, str | bytes | sympy.Set):
        items = list(conditions)
        ordered = sorted(items, key=str) if isinstance(conditions, set | frozenset) else items
        yield from ((f"{name}[{place}]", item) for place, item in enumerate(ordered))
    else:
        raise Untreatable(f"{name} is {excerpt(conditions)}: a list is expected, {name}=[...]")


def _conjuncts(item: Any, what: str) -> Iterator[Said]:
    """The parts of a conjunction. Python compares spellings with `==`, so its booleans say nothing of values."""
    if isinstance(item, sympy.And):
        if letter := next((part for part in item.args if isinstance(part, sympy.Expr)), None):
            raise Untreatable(f"{what} is {item}, where {letter} is true or false: no equation and no inequality")
        yield from ((what, part) for part in sorted(item.args, key=str))
    elif isinstance(item, bool):
        raise Untreatable(f"{what} is {item}: write Eq(a, b), for a == b compares spellings; and Ne(a, b) for a != b")
    elif isinstance(item, tuple | list | dict | sympy.Tuple):
        raise Untreatable(f"{what} is {excerpt(item)}: write Eq(a, b) for an equation, each in the list by itself")
    else:
        yield what, item


def nonvanishing(conditions: Any) -> Iterator[Any]:
    """The scalars that do not vanish, of `a != b` the difference; raises `Untreatable` for what is no scalar."""
    for what, item in listed(conditions, "nonzero"):
        if item is sympy.true:
            continue
        if isinstance(item, sympy.Unequality):
            sides = [opened(side, what) for side in item.args]
            if all(side.shape == (1, 1) for side in sides):
                yield sides[0].rows[0][0] - sides[1].rows[0][0]
                continue
        if isinstance(item, Boolean) and not isinstance(item, sympy.Expr) and item is not sympy.false:
            raise Untreatable(f"{what} is {excerpt(item)}: what does not vanish is expected, a scalar or Ne(a, b)")
        entries = opened(sympy.S.Zero if item is sympy.false else item, what)
        if entries.shape != (1, 1):
            raise Untreatable(f"{what} is {entries.size}: a scalar is expected, such as a vector's squared length")
        yield entries.rows[0][0]
