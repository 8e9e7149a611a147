"""Variables in the place of exponentials, logarithms, roots and angles, and what is needed for these to be real."""

from __future__ import annotations

from math import lcm
from typing import Any

import sympy

from chasles.checker.expressions.quantities import is_atom
from chasles.from_sympy.arcs import Arc
from chasles.from_sympy.factors import factors_of, is_entire, is_evident
from chasles.from_sympy.opening import FunctionSymbol, Signed, excerpt, parts_of
from chasles.problems.variables import Untreatable

LARGEST_UNIT = 60
LARGEST_EXPONENT = 1000
LARGEST_ORIGIN = 1_000
"""What is longer, part by part, has no variable."""


class Placeholders:
    """What variables stand for, and what is known of them.

    Where they are real is collected in `needs`, with something that is defined nowhere else; what has to be defined for
    that in `defined`. `equations` are what roots of higher order satisfy. `halvings` tell in which entries a cosine is
    compared with one, and of which part of the difference; `multiples` in which entries exponentials are, and of which
    multiple of it. `units` and `signs` say which denominators exponents have,
    and which sign the factors of logarithms have; they are learned in one round and used in the next.
    """

    def __init__(self) -> None:
        self.units: dict[Any, int] = {}
        self.signs: dict[Any, int] = {}
        self._reset()

    def _reset(self) -> None:
        self.needs: dict[str, Any] = {}
        self.defined: dict[Any, None] = {}
        self.atoms: dict[Any, None] = {}
        self.equations: dict[tuple[Any, Any], None] = {}
        self.origins: dict[Any, Any] = {}
        self.exponents: dict[Any, Any] = {}
        self.logs: dict[Any, Any] = {}
        self.arcs: dict[FunctionSymbol, Arc] = {}
        self.halvings: dict[tuple[int, int], int] = {}
        self.multiples: dict[tuple[int, int], int] = {}
        self._known: dict[Any, Any] = {}

    def _atom(self, e: Any) -> Any:
        """An atom whose sign or roots occur is written so that they are known."""
        self.atoms[e] = None
        unit = self.units.get(("root", e), 1)
        if unit > 1:
            self.needs |= {} if e.is_positive else {f"{e} > 0": sympy.log(e)}
            return self._word(e ** sympy.Rational(1, unit), FunctionSymbol if e.is_positive else Signed) ** unit
        return self._word(e, Signed) if self.signs.get(e) == 1 and not e.is_positive else e

    def _meet(self, *arguments: Any) -> None:
        """What is hidden in a variable, or cancels, has to be real, and not to divide by zero."""
        met = map(sympy.sympify, arguments)
        self.defined |= {e: None for e in met if not all(map(is_entire, parts_of(e)))}

    def _word(self, origin: Any, kind: type[FunctionSymbol] = FunctionSymbol, positive: bool = True) -> Any:
        if sum(1 for _ in sympy.preorder_traversal(origin)) > LARGEST_ORIGIN:
            raise Untreatable(f"{excerpt(origin)} is not treated: written in exponentials it is too long")
        word = kind(str(origin), positive=True) if positive else kind(str(origin), real=True)
        if self.origins.setdefault(word, origin) != origin:
            raise Untreatable(f"two different symbols are called the same in {excerpt(origin)}: rename one")
        return word

    def _original(self, expression: Any) -> Any:
        return expression.xreplace(self.origins)

    def _unit(self, key: Any, multiple: Any) -> int:
        self.units[key] = unit = lcm(self.units.get(key, 1), int(multiple.q))
        if unit > LARGEST_UNIT or abs(multiple) * unit > LARGEST_EXPONENT:
            raise Untreatable(f"exponents with {multiple} are not treated: numerators or denominators are too large")
        return unit

    def logs_key(self, base: Any) -> Any:
        """The atom that a base is, for its roots to be the variable."""
        original = self._original(base)
        return original if is_atom(original) and self.signs.get(original, 1) == 1 else base

    def _need(self, value: Any, spelled: Any, sign: int) -> None:
        """Say that the argument of a logarithm is positive; its `sign` is known where it does not vanish."""
        if sign < 0 or value == 0:
            raise Untreatable(f"log({excerpt(spelled)}) is not treated: it is not real")
        if sign == 0:
            self.needs[f"{spelled} > 0"] = sympy.log(spelled, evaluate=False)
        if sign:
            self.nonvanishing(value)

    def nonvanishing(self, value: Any) -> None:
        """Say that something does not vanish, factor by factor, as far as that is not seen."""
        for base, _, _ in factors_of(value):
            original = self._original(base)
            seen = base.is_Rational or base in self.exponents or is_evident(base)
            if not (seen or (isinstance(base, Signed) and base != original)):
                self.needs[f"{original} != 0"] = 1 / original

    def _learn(self, base: Any, sign: int) -> None:
        """The sign of a factor, by which an atom is written as a variable that has it."""
        original = self._original(base)
        if base in self.exponents:
            return
        if not is_evident(base) and self.signs.setdefault(original if is_atom(original) else base, sign) != sign:
            raise Untreatable(f"roots and logarithms with {excerpt(original)} in them are nowhere all real")
