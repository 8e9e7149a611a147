"""Roots of numbers in words: those of primes are independent, and so are some roots of sums of them."""

from __future__ import annotations

from fractions import Fraction

import sympy

from chasles.algebra.rings import Polynomial
from chasles.algebra.surds import SurdSum, root_of
from chasles.from_sympy.reader import Reader, multiplied
from chasles.problems.context import Context
from chasles.statements import Hypothesis
from chasles.vocabulary import Node, Number, Power, Sum, Symbol


def defining(word: Symbol, radicand: Node, spelled: str) -> Hypothesis:
    """The word is a root of the radicand; `text` is for certificates, it is never a need."""
    subjects = (word, radicand)
    return Hypothesis("root", subjects, ((Power(word, 2), radicand),), (), "", f"{word.name} = {spelled}", free=True)


class NumberRoots:
    """The words for roots of numbers; what defines them is added to `hypotheses`."""

    def __init__(self, reader: Reader, hypotheses: list[Hypothesis]) -> None:
        self.reader = reader
        self.hypotheses = hypotheses
        self.names: set[str] = set()
        self.nested: dict[SurdSum, Symbol] = {}
        self._state_primes()

    def root(self, value: Fraction) -> Node:
        """The square root of a positive rational number."""
        root = self.reader.numeric_root(value)
        self._state_primes()
        return root

    def root_of_constant(self, context: Context, polynomial: Polynomial) -> Node | None:
        """The square root of a polynomial in nothing but roots of numbers; None if it is not, or its root not known."""
        value = self._value(context, polynomial)
        root = None if value is None else root_of(value, self.nested)
        return None if root is None else self._in_words(root)

    def _state_primes(self) -> None:
        """Define the roots of primes that have come up."""
        for number, word in self.reader.primes.items():
            if word.name not in self.names:
                self.names.add(word.name)
                self.hypotheses.append(defining(word, Number(Fraction(number)), f"sqrt({number})"))

    def _value(self, context: Context, polynomial: Polynomial) -> SurdSum | None:
        known = {word.name: root_of(SurdSum.rational(p)) for p, word in self.reader.primes.items()}
        known |= {word.name: SurdSum.root_of(inside) for inside, word in self.nested.items()}
        total = SurdSum({})
        for exponents, coefficient in context.field.ring.terms(polynomial):
            term = SurdSum.rational(coefficient)
            for variable, exponent in zip(context.variables, exponents, strict=True):
                value = known.get(variable.name) if exponent else SurdSum.rational(1)
                if value is None:
                    return None
                term = term * value**exponent
            total = total + term
        return total

    def _in_words(self, value: SurdSum) -> Node:
        """A number in words; the root of a sum of roots gets one of its own."""
        terms: list[Node] = []
        for (_, radicand, nested), coefficient in value.terms.items():
            factors = [self.root(Fraction(radicand))] if radicand != 1 else []
            factors += [self._nested(inside) for inside in sorted(nested, key=str)]
            terms.append(multiplied([Number(coefficient), *factors] if coefficient != 1 or not factors else factors))
        return terms[0] if len(terms) == 1 else Sum(tuple(terms)) if terms else Number(Fraction(0))

    def _nested(self, inside: SurdSum) -> Node:
        if inside not in self.nested:
            radicand = self._in_words(inside)
            origin = sympy.sqrt(sympy.sympify(inside.text()))
            self.nested[inside] = word = self.reader.atoms.fresh(f"u_{len(self.nested) + 1}", origin)
            self.names.add(word.name)
            self.hypotheses.append(defining(word, radicand, str(origin)))
        return self.nested[inside]
