"""From SymPy to words: a question on SymPy expressions becomes a `Problem`, or an error names what is not treated."""

from chasles.from_sympy.asking import ask
from chasles.from_sympy.question import Question

__all__ = ["Question", "ask"]
