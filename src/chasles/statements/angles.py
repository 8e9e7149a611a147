"""Conditions on angles: where one determines an angle as a sum of rational multiples of others, it says what it is."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from chasles.vocabulary import At, Call, Group, Negative, Node, Number, Quotient, Scale, Sum, Symbol, symbols_of, walk

Multiples = dict[Symbol, Fraction]


def turning(nodes: Iterable[Node]) -> set[Symbol]:
    """The symbols of which cosines and sines are taken."""
    return {s for node in nodes for part in walk(node) if isinstance(part, Call) for s in symbols_of(part.argument)}


def determined_angle(left: Node, right: Node, unknowns: Iterable[Symbol]) -> tuple[Symbol, Node] | None:
    """The one unknown in an equation between sums of multiples of scalars, and what the equation says that it is."""
    multiples = _multiples(Sum((left, Negative(right)))) if left.is_scalar and right.is_scalar else None
    sought = [symbol for symbol in unknowns if symbol in (multiples or {})]
    if not multiples or len(sought) != 1:
        return None
    divisor = -multiples.pop(sought[0])
    terms: list[Node] = [Scale(Number(multiple / divisor), symbol) for symbol, multiple in multiples.items()]
    return (sought[0], terms[0] if len(terms) == 1 else Sum(tuple(terms))) if terms else None


def _multiples(node: Node) -> Multiples | None:
    """A sum of rational multiples of scalar symbols; None for anything else."""
    total: Multiples = {}
    for term, multiple in linear_terms(node, {}):
        if isinstance(term, Symbol):
            total[term] = total.get(term, Fraction(0)) + multiple
        elif not isinstance(term, Number) or term.value:
            return None
    return {symbol: multiple for symbol, multiple in total.items() if multiple}


def linear_terms(
    node: Node, rules: Mapping[Node, Node], scale: Fraction = Fraction(1)
) -> Iterator[tuple[Node, Fraction]]:
    """The terms of a sum of rational multiples, `rules` applied, each with its multiple; nothing is collected."""
    match node:
        case _ if node in rules:
            yield from linear_terms(rules[node], rules, scale)
        case Symbol(stands_for=Node() as of) | At(of, "t") | Group(of):
            yield from linear_terms(of, rules, scale)
        case Negative(term):
            yield from linear_terms(term, rules, -scale)
        case Sum(terms):
            for term in terms:
                yield from linear_terms(term, rules, scale)
        case Scale(Number(value), term) | Scale(term, Number(value)):
            yield from linear_terms(term, rules, scale * value)
        case Quotient(numerator, Number(value)):
            yield from linear_terms(numerator, rules, scale / value)
        case _:
            yield node, scale
