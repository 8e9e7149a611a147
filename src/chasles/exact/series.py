"""Functions of an angle near zero: their leading terms."""

from __future__ import annotations

from typing import Any

import sympy as sp

__all__ = ["leading_term"]

PHI = sp.Symbol("phi", real=True)
_FUNCTIONS = {"sin(phi) - phi": sp.sin(PHI) - PHI, "1 - cos(phi)": 1 - sp.cos(PHI)}


def leading_term(name: str) -> tuple[Any, Any]:
    """The first term of the Taylor series about zero, and its order."""
    term = sp.series(_FUNCTIONS[name], PHI, 0, 6).removeO().as_leading_term(PHI)
    return term, sp.degree(term, PHI)
