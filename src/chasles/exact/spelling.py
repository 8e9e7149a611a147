"""Exact values written as text that the grammar of data reads back, as LaTeX, and in decimals."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import Any, Protocol, runtime_checkable

import sympy as sp
from sympy.printing.str import StrPrinter

from chasles.exact.numbers import decimals, normal

SHOWN_DIGITS = 6


@runtime_checkable
class SpelledValue(Protocol):
    """A value that knows its own spellings, as a root of a polynomial does."""

    def as_data(self) -> Any:
        """What JSON holds of it."""

    def as_text(self) -> str:
        """A line of text."""

    def as_latex(self) -> str:
        """LaTeX."""


class _Printer(StrPrinter):  # type: ignore[misc]
    """Fractional powers as nested square roots, which the grammar knows."""

    def _print_Pow(self, expr: Any, rational: bool = False) -> str:
        below = int(expr.exp.q) if expr.exp.is_Rational else 0
        if below < 2 or below & (below - 1) or expr.exp.p < 0:
            return str(super()._print_Pow(expr, rational))
        inside = self._print(expr.base)
        for _ in range(below.bit_length() - 1):
            inside = f"sqrt({inside})"
        return inside if expr.exp.p == 1 else f"{inside}**{expr.exp.p}"

    def _as_ordered_terms(self, expr: Any, order: str | None = None) -> list[Any]:
        """The terms in SymPy's own order where the usual one asks for decimals of many cotangents, which takes long."""
        return list(expr.args) if expr.has(sp.cot) else list(super()._as_ordered_terms(expr, order))


_PRINTER = _Printer()


def as_data(value: Any) -> Any:
    """The value for JSON: exact strings, in lists as a matrix has rows; words, truth values and None as they are."""
    match value:
        case None | bool() | str():
            return value
        case Mapping():
            return {str(key): as_data(part) for key, part in value.items()}
        case SpelledValue():
            return value.as_data()
    if hasattr(value, "shape"):
        rows, columns = value.shape
        return [as_data(value[i, 0] if columns == 1 else list(value[i, :])) for i in range(rows)]
    if isinstance(value, Sequence):
        return [as_data(part) for part in value]
    return _number_text(normal(value))


def text_of(value: Any) -> str:
    """The value on one line: (1, 0, 0) for a column, [1, 0; 0, 1] for a matrix."""
    match value:
        case None:
            return "none"
        case bool():
            return "yes" if value else "no"
        case str():
            return value
        case Mapping():
            return ", ".join(f"{key}: {text_of(part)}" for key, part in value.items())
        case SpelledValue():
            return value.as_text()
    if hasattr(value, "shape"):
        return _in_brackets(value, text_of)
    if isinstance(value, Sequence):
        return f"[{', '.join(map(text_of, value))}]"
    return _number_text(normal(value)).replace("**", "^")


def _in_brackets(matrix: Any, spell: Callable[[Any], str]) -> str:
    rows = [", ".join(map(spell, row)) for row in matrix.tolist()]
    return f"({', '.join(rows)})" if matrix.shape[1] == 1 else f"[{'; '.join(rows)}]"


def latex_of(value: Any) -> str:
    """The value in LaTeX."""
    match value:
        case None | bool() | str():
            return words_in_latex(text_of(value))
        case Mapping():
            parts = (f"{words_in_latex(f'{key}: ')} {latex_of(part)}" for key, part in value.items())
            return r",\; ".join(parts)
        case SpelledValue():
            return value.as_latex()
    if hasattr(value, "shape"):
        rows = (" & ".join(map(_number_latex, row)) for row in value.tolist())
        return r"\begin{bmatrix}" + r"\\".join(rows) + r"\end{bmatrix}"
    if isinstance(value, Sequence):
        return r"\left\{" + r",\; ".join(map(latex_of, value)) + r"\right\}"
    return _number_latex(normal(value))


@lru_cache(maxsize=5_000)
def _number_text(number: Any) -> str:
    return str(_PRINTER.doprint(number))


@lru_cache(maxsize=5_000)
def _number_latex(number: Any) -> str:
    return str(sp.latex(number, order="none" if number.has(sp.cot) else None))


def words_in_latex(words: str) -> str:
    """Words among formulas."""
    return rf"\text{{{plain_in_latex(words)}}}"


def plain_in_latex(words: str) -> str:
    """Words with what LaTeX reads as commands taken out or escaped."""
    for sign in ("\\", "{", "}"):
        words = words.replace(sign, "")
    for sign in "&%$#_":
        words = words.replace(sign, f"\\{sign}")
    return words.replace("^", r"\^{}").replace("~", r"\~{}")


def decimal_text(value: Any) -> str:
    """The value in decimals where that tells more than its exact form, else nothing."""
    if isinstance(value, list):
        parts = [decimal_text(part) for part in value]
        if not any(parts):
            return ""
        return f"[{', '.join(short or text_of(part) for short, part in zip(parts, value, strict=True))}]"
    if hasattr(value, "shape"):
        return _in_brackets(value, _decimal) if any(map(_needs_decimals, value)) else ""
    return _decimal(value) if _needs_decimals(value) else ""


def _needs_decimals(value: Any) -> bool:
    return isinstance(value, sp.Expr) and not value.is_Rational and not value.free_symbols


def _decimal(value: Any) -> str:
    if value.free_symbols:
        return text_of(value)
    text = decimals(value, SHOWN_DIGITS)
    return text.rstrip("0").rstrip(".") if "." in text and "e" not in text else text
