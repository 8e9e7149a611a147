"""Divisors: only products of constants and of factors that a hypothesis declares nonzero may be divided by."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from itertools import combinations_with_replacement
from operator import mul

from chasles.algebra.localization import Localization, joined
from chasles.evaluation.matrices import Matrix
from chasles.vocabulary import Group, Negative, Node, Norm, Number, Power, Quotient, Scale, plain
from chasles.vocabulary.parts import with_entries


class UndeclaredDivisor(ValueError):
    """A division by something that no hypothesis says is not zero."""

    def __init__(self, divisor: Node) -> None:
        said = plain(with_entries(divisor))
        super().__init__(f"divides by {said}, which nothing declares nonzero: assume nonzero({said})")
        self.divisor = divisor


class Divisors:
    """Reads divisors over one field: `entries` unfolds an expression, `rules` say what one is put for."""

    def __init__(self, field: Localization, rules: Mapping[Node, Node], entries: Callable[[Node], Matrix]) -> None:
        self.field = field
        self.rules = rules
        self.entries = entries

    def __call__(self, node: Node) -> tuple[Fraction, tuple[int, ...]]:
        """A divisor as a constant times powers of nonzero factors; raises `UndeclaredDivisor` for any other."""
        match node:
            case Group(of):
                return self(of)
            case Number(value) if value:
                return value, ()
            case Negative(term):
                constant, exponents = self(term)
                return -constant, exponents
            case Scale(factor, term):
                (a, one), (b, other) = self(factor), self(term)
                return a * b, joined(one, other)
            case Quotient(above, below):
                (a, one), (b, other) = self(above), self(below)
                return a / b, joined(one, tuple(-power for power in other))
            case Power(Norm(of), exponent) if exponent % 2 == 0 and not self.admit(Norm(of)):
                constant, exponents = self._atom(Power(Norm(of), 2))
                return constant ** (exponent // 2), tuple(e * (exponent // 2) for e in exponents)
            case Power(base, exponent):
                constant, exponents = self(base)
                return constant**exponent, tuple(e * exponent for e in exponents)
            case _:
                return self._atom(node)

    def _atom(self, node: Node) -> tuple[Fraction, tuple[int, ...]]:
        if node in self.rules:
            try:
                return self(self.rules[node])
            except UndeclaredDivisor:
                pass
        ratio = self.entries(node)[0][0]
        below = tuple(-power for power in ratio.denominator)
        leading = [self.field.ring.leading(factor)[0] for factor in self.field.nonzero]
        top = self.field.ring.leading(ratio.numerator)[0] if ratio.numerator != 0 else None
        for places in (each for size in (1, 2, 3) for each in combinations_with_replacement(range(len(leading)), size)):
            if tuple(map(sum, zip(*(leading[k] for k in places), strict=True))) == top:
                factor = reduce(mul, (self.field.nonzero[k] for k in places))
                constant = _multiple(self.field, ratio.numerator, factor)
                if constant is not None:
                    return constant, joined(tuple(map(places.count, range(max(places) + 1))), below)
        terms = self.field.ring.terms(ratio.numerator)
        if len(terms) == 1 and not any(terms[0][0]):
            return terms[0][1], below
        raise UndeclaredDivisor(node)

    def admit(self, node: Node) -> bool:
        """Whether it may be divided by."""
        try:
            self(node)
        except UndeclaredDivisor:
            return False
        return True


def _multiple(field: Localization, polynomial: object, factor: object) -> Fraction | None:
    """The constant c with polynomial = c factor, if there is one."""
    if polynomial == 0:
        return None
    (exponents, c), (other, d) = field.ring.leading(polynomial), field.ring.leading(factor)
    constant = c / d
    return constant if exponents == other and polynomial == factor * field.ring.constant(constant) else None
