"""The real quantities that occur in a SymPy expression, and their names in the problem.

An atom is a symbol, an entry of a matrix symbol, a function of symbols such as theta(t), or a derivative of one. Each
becomes a scalar word with a plain name; the SymPy spelling is kept for the reader.
"""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.quantities import NUMBERS, SIGNS, is_atom, is_unreal
from chasles.from_sympy.opening import excerpt
from chasles.from_sympy.positivity import is_definite
from chasles.problems.variables import Untreatable
from chasles.vocabulary import PI, Symbol, scalar

ASSUMPTIONS = (*SIGNS, *NUMBERS)
"""What SymPy may know of a quantity that its values at a point have to respect."""


class QuantityNames:
    """The words that stand for a question's atoms."""

    def __init__(self) -> None:
        self.words: dict[Any, Symbol] = {}
        self.origins: dict[Symbol, Any] = {PI: sympy.pi}
        self._names = {PI.name}
        self._spellings: dict[str, Any] = {}
        self._arguments: dict[str, tuple[Any, ...]] = {}

    def word(self, atom: Any) -> Symbol:
        """The word for an atom; raises `Untreatable` for what is not real, or has the name of another."""
        known = self.words.get(atom)
        if known is None:
            self._check(atom)
            known = self.words[atom] = self.fresh(_stem(atom), atom)
        return known

    def fresh(self, stem: str, origin: Any) -> Symbol:
        """A new word whose name is made of letters, digits and underscores, and belongs to nothing else."""
        plain = re.sub(r"[^A-Za-z0-9_]+", "_", stem).strip("_")
        plain = plain if plain[:1].isalpha() else f"x_{plain}".rstrip("_")
        name, number = plain, 1
        while name in self._names:
            name, number = f"{plain}_{number + 1}", number + 1
        self._names.add(name)
        symbol = scalar(name, name.replace("_", r"\_"), str(origin), constant=True)
        self.origins[symbol] = origin
        return symbol

    def _check(self, atom: Any) -> None:
        if is_unreal(atom):
            kind = "does not commute" if atom.is_commutative is False else "is not real"
            raise Untreatable(f"{excerpt(atom)} {kind}: the variables are real numbers")
        text = str(atom)
        if self._spellings.setdefault(text, atom) != atom:
            raise Untreatable(f"two different symbols are both called {text}: rename one")
        function = atom.expr if isinstance(atom, sympy.Derivative) else atom
        if isinstance(function, AppliedUndef):
            self._check_function(function)
        elif not isinstance(atom, sympy.Symbol) and not isinstance(atom.parent, sympy.MatrixSymbol):
            raise Untreatable(f"{excerpt(atom)} is not treated: only entries of a matrix symbol are")

    def _check_function(self, function: Any) -> None:
        arguments = function.args
        if len(set(arguments)) != len(arguments) or not all(isinstance(a, sympy.Symbol) for a in arguments):
            raise Untreatable(f"{excerpt(function)} is not treated: the arguments of a function are different symbols")
        name = function.func.__name__
        if self._arguments.setdefault(name, arguments) != arguments:
            earlier = ", ".join(map(str, self._arguments[name]))
            raise Untreatable(f"{excerpt(function)} and {name}({earlier}) occur together: use one set of arguments")


def _stem(atom: Any) -> str:
    """What the name is made of: theta(t) is theta, its derivatives theta_dot, theta_ddot, theta_t_t."""
    if isinstance(atom, sympy.Derivative):
        stem = str(atom.expr.func.__name__)
        if len(atom.expr.args) == 1 and len(atom.variables) <= 3:
            return f"{stem}_{'d' * len(atom.variables)}ot"
        return "_".join([stem, *map(str, atom.variables)])
    return str(atom.func.__name__) if isinstance(atom, AppliedUndef) else str(atom)


def assumed_of(atom: Any) -> dict[str, bool]:
    """What SymPy knows of an atom, beyond its being real."""
    return {key: known for key in ASSUMPTIONS if (known := getattr(atom, f"is_{key}")) is not None}


def real_copy(expression: Any) -> Any:
    """The expression with every atom a real symbol of which SymPy assumes the same."""
    copies: dict[Any, Any] = {}
    walk = sympy.preorder_traversal(expression)
    for part in walk:
        if is_atom(part):
            walk.skip()
            copies.setdefault(part, sympy.Dummy(**{**assumed_of(part), "real": True}))
    return expression.xreplace(copies)


def nonnegative_by_sign(expression: Any) -> bool:
    """Whether a real expression is not negative by what SymPy sees, roots being real."""
    roots = {part: sympy.Dummy(nonnegative=True) for part in expression.atoms(sympy.Pow) if part.exp.is_Rational
             and part.exp.q == 2 and part.exp > 0}  # fmt: skip
    return bool(real_copy(expression.xreplace(roots)).is_nonnegative)


def nonzero_by_sign(expression: Any) -> bool:
    """Whether a real expression is positive, or negative, by what SymPy sees or by completing squares."""
    copy = real_copy(expression)
    if copy.is_positive or copy.is_negative:
        return True
    symbols = sorted(copy.free_symbols, key=str)
    if not symbols or not copy.is_polynomial(*symbols):
        return False
    terms = sympy.Poly(copy, *symbols).as_dict()
    if not all(c.is_Rational for c in terms.values()):
        return False
    return any(is_definite({m: Fraction(sign * int(c.p), int(c.q)) for m, c in terms.items()}) for sign in (1, -1))
