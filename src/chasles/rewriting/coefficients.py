"""A term as a coefficient times a core: the coefficient is a number or a function of angles, the core is the rest.

So 2 (3 - cos(phi)) (e . omega) e e^T has the coefficient 2 (3 - cos(phi)) and the core (e . omega) e e^T.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from dataclasses import replace as with_fields
from fractions import Fraction
from math import gcd, lcm

from chasles.vocabulary import Contract, Group, Negative, Node, Number, Quotient, Scale, Sum, Zero

ONE = Number(Fraction(1))


@dataclass(frozen=True, slots=True)
class Term:
    """coefficient * core; a core of None stands for the number one."""

    coefficient: Node
    core: Node | None


@dataclass(frozen=True, slots=True)
class AngleFunction:
    """A function of angles that coefficients are made of: numerator / denominator."""

    numerator: Node = ONE
    denominator: Node | None = None

    @property
    def node(self) -> Node:
        """The function as an expression."""
        return self.numerator if self.denominator is None else Quotient(self.numerator, self.denominator)


def split(node: Node, constant: Callable[[Node], bool]) -> Term:
    """The term's coefficient and core; `constant` says which scalars depend on angles alone."""
    if node.is_scalar and constant(node):
        return Term(node, None)
    match node:
        case Negative(term):
            inner = split(term, constant)
            return Term(negated(inner.coefficient), inner.core)
        case Scale(factor, term):
            one, other = split(factor, constant), split(term, constant)
            return Term(product(one.coefficient, other.coefficient), _product(one.core, other.core))
        case Quotient(numerator, denominator):
            above, below = split(numerator, constant), split(denominator, constant)
            coefficient = _quotient(node, above.coefficient, below.coefficient)
            return Term(coefficient, above.core if below.core is None else _quotient(node, above.core, below.core))
        case Contract(factors):
            parts = [split(factor, constant) for factor in factors]
            if any(part.core is None for part in parts):
                return Term(ONE, node)
            coefficient = ONE
            for part in parts:
                coefficient = product(coefficient, part.coefficient)
            return Term(coefficient, Contract(tuple(part.core for part in parts if part.core is not None)))
        case Group(of) if not isinstance(of, Sum):
            return split(of, constant)
        case _:
            return Term(ONE, node)


def product(factor: Node, term: Node | None) -> Node:
    """The product, a factor of one left out."""
    if term is None or term == ONE:
        return factor
    return term if factor == ONE else Scale(factor, term)


def _product(one: Node | None, other: Node | None) -> Node | None:
    if one is None or other is None:
        return other if one is None else one
    return Scale(one, other)


def _quotient(like: Quotient, above: Node | None, below: Node) -> Node:
    above = ONE if above is None else above
    return above if below == ONE else with_fields(like, numerator=above, denominator=below)


def negated(node: Node) -> Node:
    """The expression with the other sign: without one if it has one in front."""
    return node.term if isinstance(node, Negative) else Negative(node)


def spelled(parts: Iterable[tuple[Fraction, AngleFunction]]) -> Node | None:
    """The sum of number * function, as a person would write it: 2 (2 + cos(phi)); None if it is zero."""
    groups: dict[Node | None, list[tuple[Fraction, Node]]] = {}
    for value, function in parts:
        if value:
            groups.setdefault(function.denominator, []).append((value, function.numerator))
    pieces = []
    for denominator, group in groups.items():
        size = Fraction(gcd(*(v.numerator for v, _ in group)), lcm(*(v.denominator for v, _ in group)))
        size = size if group[0][0] > 0 else -size
        inner = added([_times(value / size, node) for value, node in group])
        piece = product(Number(abs(size)), inner)
        if denominator is not None:
            above, below = Number(Fraction(abs(size.numerator))), Number(Fraction(size.denominator))
            piece = Quotient(product(above, inner), product(below, denominator))
        pieces.append(piece if size > 0 else Negative(piece))
    return added(pieces) if pieces else None


def times(coefficient: Node, core: Node | None) -> Node:
    """The product of a coefficient and a core, its sign in front of it all."""
    if isinstance(coefficient, Negative):
        return Negative(product(coefficient.term, core))
    return product(coefficient, core)


def scaled(term: Node, number: Fraction) -> Node | None:
    """A rational multiple of a term, its own number and the other made one; None for none of it."""
    if number == 0:
        return None
    if number == -1:
        return negated(term)
    own = split(term, lambda scalar: isinstance(scalar, Number))
    value = number * _value(own.coefficient)
    if isinstance(own.core, Quotient) and own.core.numerator.is_scalar:
        above, below = Number(Fraction(abs(value.numerator))), Number(Fraction(value.denominator))
        core = own.core
        fraction = _quotient(core, product(above, core.numerator), product(below, core.denominator))
        return fraction if value > 0 else Negative(fraction)
    return _times(value, ONE if own.core is None else own.core)


def _value(number: Node) -> Fraction:
    """The value of a product of numbers, as `split` leaves it."""
    match number:
        case Number(value):
            return value
        case Negative(term):
            return -_value(term)
        case Scale(factor, term):
            return _value(factor) * _value(term)
        case Quotient(numerator, denominator):
            return _value(numerator) / _value(denominator)
        case _:
            raise TypeError(f"{number} is no product of numbers")


def _times(value: Fraction, node: Node) -> Node:
    return times(Number(abs(value)) if value > 0 else Negative(Number(abs(value))), node)


def added(terms: Sequence[Node]) -> Node:
    """The sum of the terms, those of a sum among them one by one; zeros are left out."""
    flat = [part for term in terms for part in (term.terms if isinstance(term, Sum) else (term,))]
    kept = [term for term in flat if not isinstance(term, Zero)] or flat[:1]
    return kept[0] if len(kept) == 1 else Sum(tuple(kept))
