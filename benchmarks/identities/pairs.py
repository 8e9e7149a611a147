"""Pairs of sides as plain text, and as SymPy's expressions."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

import sympy
from sympy import functions
from sympy.core.parameters import evaluate

__all__ = ["ASSUMED", "ELEMENTARY", "Pair", "built", "load", "read", "text_of", "written"]

ELEMENTARY = {
    *(functions.sin, functions.cos, functions.tan, functions.cot, functions.sec, functions.csc),
    *(functions.asin, functions.acos, functions.atan, functions.acot, functions.asec, functions.acsc, functions.atan2),
    *(functions.exp, functions.log, functions.sinh, functions.cosh, functions.tanh, functions.coth, functions.sech),
    *(functions.csch, functions.asinh, functions.acosh, functions.atanh, functions.acoth, functions.Abs),
    *(functions.sign, functions.Max, functions.Min, functions.Piecewise, functions.Heaviside, functions.re),
    *(functions.im, functions.conjugate, functions.factorial, functions.binomial),
}
ASSUMED = {
    *("positive", "negative", "nonnegative", "nonpositive", "nonzero", "zero", "real", "integer", "rational", "even"),
    *("odd", "finite", "extended_real", "commutative", "extended_positive", "extended_nonnegative", "imaginary"),
}
KEYS = ("from", "kind", "left", "right", "wrong")


class Pair(NamedTuple):
    """Two sides, where they are from, and a right side that is wrong ("" for none)."""

    source: str
    kind: str
    left: str
    right: str
    wrong: str


def text_of(expression: Any) -> str:
    """The expression as it is built, in SymPy's `srepr`; a plain spelling where that is read as the same."""
    exact = sympy.srepr(expression)
    symbols = {str(s): s for s in expression.free_symbols}
    text = " ".join(str(expression).split())
    try:
        plain = all(s._assumptions_orig in ({}, {"commutative": True}) for s in symbols.values())
        if plain and sympy.srepr(sympy.sympify(text)) == exact:
            return text
    except Exception:
        pass
    return exact


def built(text: str) -> Any:
    """The expression of a text."""
    if not any(word in text for word in ("Symbol(", "Integer(", "Rational(")):
        return sympy.sympify(text)
    with evaluate(False):
        return eval(text, vars(sympy) | {"MutableDenseMatrix": sympy.Matrix})


def read(pair: Pair) -> tuple[Any, Any]:
    """Both sides."""
    return built(pair.left), built(pair.right)


def written(pairs: Iterable[Pair]) -> str:
    """The pairs as text, a paragraph each."""
    return "\n".join(
        "".join(f"{key} {value}\n" for key, value in zip(KEYS, pair, strict=True) if value) for pair in pairs
    )


def load(path: Path) -> list[Pair]:
    """The pairs of a file; lines that begin with # are comments."""
    found = []
    for paragraph in path.read_text("utf-8").split("\n\n"):
        lines = [line for line in paragraph.splitlines() if line and not line.startswith("#")]
        said = dict(line.split(" ", 1) for line in lines)
        if said:
            found.append(Pair(*(said.get(key, "") for key in KEYS)))
    return found
