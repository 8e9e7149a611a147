"""Rational functions of symbols that are called as Coq calls them, and how they are spelled."""

from __future__ import annotations

import re
from typing import Any

import sympy


def text_of(e: Any) -> str:
    """A rational function, in brackets unless it is a symbol."""
    above, below = (sympy.sstr(part).replace("**", "^") for part in sympy.fraction(sympy.together(e)))
    text = above if below == "1" else f"({above}) / ({below})"
    return text if text.isalnum() else f"({text})"


def polynomial(e: Any) -> str:
    """A polynomial, in brackets unless it is a symbol."""
    return text_of(sympy.expand(e))


def rank(symbol: Any) -> tuple[int, str]:
    """What rules replace comes first: the root of something with roots in it before these, cosines before sines."""
    found = re.fullmatch(r"(?:value|word)'(\d+)", symbol.name)
    return (-int(found[1]) - 1, "") if found else (0, symbol.name)


def divisors_of(e: Any) -> list[Any]:
    """What is divided by, factor by factor, also where it cancels."""
    bases = [power.base for power in e.atoms(sympy.Pow) if power.exp.is_negative]
    belows = [
        sympy.fraction(sympy.together(e))[1],
        *(part for base in bases for part in sympy.fraction(sympy.together(base))),
    ]
    factors = (factor.as_base_exp()[0] for below in belows for factor in sympy.Mul.make_args(below))
    return sorted({factor for factor in factors if factor.free_symbols}, key=str)
