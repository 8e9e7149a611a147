"""A model as the peers take formulas: an expression of SymPy said again in the words of another library."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce
from typing import Any

import sympy as sp
from benchmarks.compile.models import Model
from benchmarks.formulas import Shape

__all__ = ["Formula"]


class Formula:
    """What a peer's module asks of a kernel: names, shapes and `of`, which says the entries in other words."""

    singular = False

    def __init__(self, model: Model) -> None:
        self.model = model
        self.name = "model"
        self.title = model.name
        self.inputs: dict[str, Shape] = {name: (len(group),) for name, group in model.inputs.items()}
        self.output: Shape = (len(model.entries),)
        self.size = len(model.entries)

    @property
    def signature(self) -> str:
        """The generalised ufunc's signature."""
        return ",".join(f"({shape[0]})" for shape in self.inputs.values()) + f"->({self.size})"

    def symbols(self, make: Callable[[str], Any]) -> list[list[Any]]:
        """A scalar for each entry of each input, of the symbol's name."""
        return [[make(str(symbol)) for symbol in group] for group in self.model.inputs.values()]

    def of(self, functions: Any, *values: Sequence[Any]) -> list[Any]:
        """The entries with these values for the symbols and these functions."""
        if functions is sp:
            return list(self.model.entries)
        symbols = [symbol for group in self.model.inputs.values() for symbol in group]
        said = dict(zip(symbols, (value for group in values for value in group), strict=True))
        return [_said(functions, entry, said) for entry in self.model.entries]


def _said(functions: Any, expression: Any, said: dict[Any, Any]) -> Any:
    found = said.get(expression)
    if found is None:
        found = said[expression] = _made(functions, expression, said)
    return found


def _made(functions: Any, expression: Any, said: dict[Any, Any]) -> Any:
    if expression.is_Rational:
        return _number(functions, int(expression.p), int(expression.q))
    if expression.is_Float:
        return float(expression)
    if expression.is_Pow and (2 * expression.exp).is_Integer:
        base, exponent = _said(functions, expression.base, said), 2 * expression.exp
        base = functions.sqrt(base) if exponent % 2 else base
        power = reduce(lambda a, b: a * b, [base] * abs(int(exponent if exponent % 2 else exponent / 2)))
        return power if exponent > 0 else 1 / power
    if expression.is_Mul:
        number, rest = expression.as_coeff_Mul()
        if number.is_Rational and number not in (1, -1):
            return _said(functions, number, said) * _said(functions, rest, said)
        above, below = sp.fraction(expression, exact=True)
        if below != 1:
            return _said(functions, above, said) / _said(functions, below, said)
    parts = [_said(functions, each, said) for each in expression.args]
    if expression.is_Add:
        return reduce(lambda a, b: a + b, parts)
    if expression.is_Mul:
        return reduce(lambda a, b: a * b, parts)
    return getattr(functions, type(expression).__name__)(*parts)


def _number(functions: Any, above: int, below: int) -> Any:
    if below == 1:
        return above
    if hasattr(functions, "Rational"):
        return functions.Rational(above, below)
    # wrenfold's own rational numbers overflow in products of several, which ends the process.
    return functions.mpf(above) / below if hasattr(functions, "mpf") else above / below
