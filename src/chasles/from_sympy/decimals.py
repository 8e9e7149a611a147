"""Floating-point numbers as the decimal numbers that they are written as: 0.5 is 1/2."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy
from sympy.matrices import MatrixBase


def as_decimals(value: Any) -> Any:
    """The expression, matrix, equation or list with every floating-point number replaced by what its digits say."""
    if isinstance(value, list | tuple):
        return type(value)(map(as_decimals, value))
    if isinstance(value, Mapping):
        return {name: as_decimals(said) for name, said in value.items()}
    if isinstance(value, str):
        return value
    try:
        value = sympy.sympify(value, strict=True)
    except sympy.SympifyError:
        return value
    if isinstance(value, MatrixBase):
        return value.applyfunc(as_decimals)
    if not isinstance(value, sympy.Basic):
        return value
    return value.xreplace({number: sympy.Rational(str(number)) for number in value.atoms(sympy.Float)})
