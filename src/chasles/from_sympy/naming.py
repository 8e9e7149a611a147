"""Points in SymPy's terms: the names of variables, and exact numbers as SymPy's."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import sympy

from chasles.algebra.surds import SurdSum


def number_of(value: SurdSum, angle: Any) -> Any:
    """An exact number as SymPy's, the transcendental number being an angle."""
    return sympy.sympify(value.text("theta"), locals={"theta": sympy.Symbol("theta")}).subs("theta", angle)


def written(value: Fraction | SurdSum, theta: str) -> str:
    """A coordinate for the checker, the transcendental number by its name."""
    return value.text(theta) if isinstance(value, SurdSum) else str(value)


def spelled(name: str, origins: Mapping[str, Any]) -> str:
    """A variable in SymPy's spelling: x, Derivative(f(t), t), cos(phi/2)."""
    if not name.startswith(("cos(", "sin(")):
        return str(origins[name])
    word, unit = angle_of(name, origins)
    return str(getattr(sympy, name[:3])(unit * origins[word], evaluate=False))


def angle_of(name: str, origins: Mapping[str, Any]) -> tuple[str, Any]:
    """The word and the multiple of it of which a variable such as cos(3phi/2) is the cosine."""
    above, _, below = name[4:].removesuffix(")").partition("/")
    word = next(word for word in origins if above.endswith(word) and (above.removesuffix(word) or "1").isdigit())
    return word, sympy.Rational(int(above.removesuffix(word) or 1), int(below or 1))
