"""Functions of an angle near zero: their leading terms."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

PHI = sp.Symbol("phi", real=True)
FUNCTIONS = {"sin(phi) - phi": sp.sin(PHI) - PHI, "1 - cos(phi)": 1 - sp.cos(PHI)}


@dataclass(frozen=True, slots=True)
class LeadingTerm:
    """A leading term, and the order of what is left out."""

    term: Any
    beyond: int

    def as_text(self) -> str:
        """As it is written: phi^2/2 + O(phi^4)."""
        return f"{self.term} + O({PHI**self.beyond})".replace("**", "^")

    as_data = as_text

    def as_latex(self) -> str:
        """LaTeX."""
        return f"{sp.latex(self.term)} + O\\left({sp.latex(PHI**self.beyond)}\\right)"


def leading_term(name: str) -> tuple[Any, Any]:
    """The first term of the Taylor series about zero with the order of the next, and its own order."""
    (first,), (second,), *_ = sorted(sp.Poly(sp.series(FUNCTIONS[name], PHI, 0, 8).removeO(), PHI).monoms())
    term = sp.series(FUNCTIONS[name], PHI, 0, first + 1).removeO()
    return LeadingTerm(term, second), sp.Integer(first)
