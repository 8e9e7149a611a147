"""One product: a number times scalars times factors in their order; and sums of products, written out."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from dataclasses import replace as with_fields
from fractions import Fraction

from chasles.rewriting.coefficients import ONE
from chasles.vocabulary import Contract, Group, Identity, Negative, Node, Number, Quotient, Scale, Sum
from chasles.vocabulary.letters import zero_of


@dataclass(frozen=True, slots=True)
class Product:
    """number * scalars / divisors * factors; `size` is the number of rows and columns, which no factors leave open."""

    number: Fraction
    scalars: tuple[Node, ...]
    divisors: tuple[Node, ...]
    factors: tuple[Node, ...]
    shape: tuple[int, int]

    @property
    def core(self) -> tuple[object, ...]:
        """What two products share if they can be put together."""
        return tuple(sorted(map(str, self.scalars))), tuple(sorted(map(str, self.divisors))), self.factors


def cancelled(
    number: Fraction,
    scalars: tuple[Node, ...],
    divisors: tuple[Node, ...],
    factors: tuple[Node, ...],
    shape: tuple[int, int],
) -> Product:
    """The product, scalars that are divided by again left out."""
    kept = list(scalars)
    below = []
    for divisor in divisors:
        if divisor in kept:
            kept.remove(divisor)
        else:
            below.append(divisor)
    return Product(number, tuple(kept), tuple(below), factors, shape)


def divided(above: Product, below: Node) -> Product:
    """The product divided by a scalar, factor by factor of it."""
    match below:
        case Number(value):
            return with_fields(above, number=above.number / value)
        case Scale(factor, term):
            return divided(divided(above, factor), term)
        case Group(of):
            return divided(above, of)
        case Negative(of):
            return divided(with_fields(above, number=-above.number), of)
        case _:
            return cancelled(above.number, above.scalars, (*above.divisors, below), above.factors, above.shape)


def contraction(factors: tuple[Node, ...]) -> Node:
    """The factors as one expression."""
    return factors[0] if len(factors) == 1 else Contract(factors)


def chained(factors: Iterable[Node]) -> Node:
    """The product of the factors, of products among them factor by factor."""
    return contraction(tuple(f for one in factors for f in (one.factors if isinstance(one, Contract) else (one,))))


def collected(found_terms: Iterable[Product]) -> list[Product]:
    """The products, those that differ in their numbers alone put together; what cancels is left out."""
    found: dict[object, Product] = {}
    for p in found_terms:
        known = found.get(p.core)
        found[p.core] = p if known is None else with_fields(known, number=known.number + p.number)
    return [p for p in found.values() if p.number]


def spelled_out(parts: list[Product], shape: tuple[int, int]) -> Node:
    """The sum of the products, written out; zero if there are none."""
    if not parts:
        return zero_of(shape)
    terms = [_term(p) for p in parts]
    return terms[0] if len(terms) == 1 else Sum(tuple(terms))


def _term(p: Product) -> Node:
    node: Node | None = contraction(p.factors) if p.factors else None
    if node is None and p.shape != (1, 1):
        node = Identity(p.shape[0])
    coefficient: Node | None = None
    for scalar in reversed(p.scalars):
        coefficient = scalar if coefficient is None else Scale(scalar, coefficient)
    for divisor in p.divisors:
        if coefficient is None and node is not None:
            node = Quotient(node, divisor)
        else:
            coefficient = Quotient(ONE if coefficient is None else coefficient, divisor)
    if coefficient is not None:
        node = coefficient if node is None else Scale(coefficient, node)
    size = abs(p.number)
    if size != 1 or node is None:
        node = Number(size) if node is None else Scale(Number(size), node)
    return Negative(node) if p.number < 0 else node
