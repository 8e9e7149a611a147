"""Floating-point numbers as the decimal numbers that they are written as: 0.5 is 1/2."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import sympy
from sympy.matrices import MatrixBase


def as_decimals(value: Any) -> Any:
    """The expression, matrix, equation or list with every floating-point number replaced by what its digits say."""
    return each_replaced(value, lambda e: {number: sympy.Rational(str(number)) for number in e.atoms(sympy.Float)})


def with_values(said: tuple[Any, ...], values: Mapping[Any, Any]) -> tuple[Any, ...]:
    """What is said, with these values everywhere."""
    return tuple(each_replaced(each, lambda _: values) for each in said)


def each_replaced(value: Any, values: Callable[[Any], Mapping[Any, Any]]) -> Any:
    """The expression, matrix, equation or list with parts of every expression replaced by the values that it has."""
    if isinstance(value, list | tuple):
        return type(value)(each_replaced(item, values) for item in value)
    if isinstance(value, Mapping):
        keyed = any(isinstance(name, sympy.Basic) and values(name) for name in value)
        pairs = [(name, each_replaced(said, values)) for name, said in value.items()]
        if keyed:
            return tuple(sympy.Eq(each_replaced(name, values), said, evaluate=False) for name, said in pairs)
        return dict(pairs)
    if isinstance(value, str):
        return value
    try:
        value = sympy.sympify(value, strict=True)
    except sympy.SympifyError:
        return value
    if isinstance(value, MatrixBase):
        return value.applyfunc(lambda entry: each_replaced(entry, values))
    return value.xreplace(dict(values(value))) if isinstance(value, sympy.Basic) else value
