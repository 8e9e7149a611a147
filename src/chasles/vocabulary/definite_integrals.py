"""Integrals between limits, of what is a polynomial in the variable of integration, entry by entry."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import reduce
from itertools import product

from chasles.vocabulary.arguments import declaring
from chasles.vocabulary.fitting import measured, word
from chasles.vocabulary.layout import At, Block, Group
from chasles.vocabulary.letters import Symbol, Zero, zero_of
from chasles.vocabulary.measure import Measure, Misfit, added, entrywise
from chasles.vocabulary.nodes import Contract, Negative, Node, Number, Power, Quotient, Scale, Sum, Transpose, lifted
from chasles.vocabulary.partial import CarriedOut, meanings, with_derivatives
from chasles.vocabulary.pieces import Piece, Precedence, Style
from chasles.vocabulary.shorthand import opened
from chasles.vocabulary.spatial import Cross, Dot, Skew, Trace, Vect
from chasles.vocabulary.tree import children, rebuilt, replace, walk

LARGEST_DEGREE = 24


@word
class DefiniteIntegral(CarriedOut):
    """The integral of an expression `by` a scalar symbol, from `lower` to `upper`."""

    of: Node
    by: Node
    lower: Node
    upper: Node

    def _measured(self) -> Measure:
        if not isinstance(self.by, Symbol) or not self.by.is_scalar or self.by.stands_for is not None:
            raise Misfit(f"it is integrated by a scalar symbol, and {self.by} is none")
        for limit in (self.lower, self.upper):
            added(measured(self.by), measured(limit), (self.by, limit), "take as a limit of")
        times = measured(self.by).grid[0][0]
        return entrywise(lambda dimension: dimension and times and dimension * times, measured(self.of))

    def carried_out(self, rules: Mapping[Node, Node]) -> Node:
        """The sum of the integrals of the powers of the variable, each times its coefficient.

        Raises TypeError where it is not seen how the expression depends on the variable.
        """
        known = {key: rule for key, rule in rules.items() if key != self.by}
        of = opened(self.of)
        while (told := with_derivatives(opened(replace(of, known | meanings(of))), known)) != of:
            of = told
        by = {part for part in walk(opened(replace(rules.get(self.by, self.by), known))) if isinstance(part, Symbol)}
        if any(part in by and part != self.by for part in walk(of)):
            raise TypeError(f"an integral by {self.by} is taken, and {self.of} depends on what {self.by} is")
        terms: list[Node] = []
        for power, coefficient in coefficients(of, self.by).items():
            above, below = (Power(limit, power + 1) if power else limit for limit in (self.upper, self.lower))
            terms.append(Scale(Quotient(Sum((above, Negative(below))), Number(Fraction(power + 1))), coefficient))
        return Sum(tuple(terms)) if len(terms) > 1 else terms[0] if terms else Scale(self.upper, Zero(*of.shape))

    def spelled(self, style: Style, spell: Callable[[Node], Piece]) -> Piece:
        of, by = spell(self.of).at_least(Precedence.PRODUCT, style), spell(self.by).text
        lower, upper = spell(self.lower).text, spell(self.upper).text
        sign = style.called(f"integral from {lower} to {upper} of", rf"\int_{{{lower}}}^{{{upper}}}")
        ends = style.called("d", r"\, \mathrm{d}")
        return Piece(f"{sign} {of.text} {ends}{by}", Precedence.DOT, of.depth)


def coefficients(node: Node, by: Node) -> dict[int, Node]:
    """The coefficients of the powers of a symbol in an expression; raises TypeError where none are seen."""
    if by not in walk(node):
        return {} if isinstance(node, Zero) or node == Number(Fraction(0)) else {0: node}
    match node:
        case Symbol():
            return {1: Number(Fraction(1))}
        case Group(of):
            return coefficients(of, by)
        case Negative() | Transpose() | At() | Skew() | Trace() | Vect():
            return {power: rebuilt(node, (each,)) for power, each in coefficients(children(node)[0], by).items()}
        case Quotient(numerator, denominator) if by not in walk(denominator):
            return {power: Quotient(each, denominator) for power, each in coefficients(numerator, by).items()}
        case Sum(terms):
            return _added([coefficients(term, by) for term in terms])
        case Block(rows):
            entries = [[(entry, coefficients(entry, by)) for entry in row] for row in rows]
            powers = dict.fromkeys(power for row in entries for _, found in row for power in found)
            return {
                power: Block(
                    tuple(tuple(found.get(power, zero_of(entry.shape)) for entry, found in row) for row in entries)
                )
                for power in powers
            }
        case Power(base, int() as exponent) if 0 < exponent <= LARGEST_DEGREE:
            return coefficients(reduce(Scale if base.is_scalar else _contracted, [base] * exponent), by)
        case Scale() | Contract() | Dot() | Cross():
            parts = [coefficients(part, by) for part in children(node)]
            chosen = product(*(found.items() for found in parts))
            return _added([{sum(p for p, _ in each): rebuilt(node, tuple(c for _, c in each))} for each in chosen])
    raise TypeError(f"{node} is no polynomial in {by}: only such are integrated between limits")


def _added(found: Iterable[Mapping[int, Node]]) -> dict[int, Node]:
    terms: dict[int, list[Node]] = {}
    for each in found:
        for power, term in each.items():
            terms.setdefault(power, []).append(term)
    return {power: Sum(tuple(same)) if len(same) > 1 else same[0] for power, same in terms.items()}


def _contracted(one: Node, other: Node) -> Node:
    return Contract((one, other))


@declaring
def definite_integral(
    of: Node | int | Fraction, by: Node, lower: Node | int | Fraction, upper: Node | int | Fraction
) -> DefiniteIntegral:
    """The integral of a polynomial in a scalar symbol, from one limit to another."""
    return DefiniteIntegral(lifted(of), by, lifted(lower), lifted(upper))
