"""Integrals between limits, of polynomials, exponentials, cosines and sines of multiples, entry by entry."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from chasles.vocabulary.antiderivatives import integrated, oscillations_in
from chasles.vocabulary.arguments import declaring
from chasles.vocabulary.fitting import measured, word
from chasles.vocabulary.letters import Symbol, Zero
from chasles.vocabulary.measure import Measure, Misfit, added, entrywise
from chasles.vocabulary.nodes import Negative, Node, Scale, Sum, lifted
from chasles.vocabulary.partial import CarriedOut, meanings, with_derivatives
from chasles.vocabulary.pieces import Piece, Precedence, Style
from chasles.vocabulary.shorthand import opened
from chasles.vocabulary.tree import replace, walk


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
        """The sum of the integrals of powers, exponentials and turns of the variable, each times what multiplies it.

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
        for term, coefficient in oscillations_in(of, self.by).items():
            found = integrated(term, self.by)
            above, below = (replace(found, {self.by: limit}) for limit in (self.upper, self.lower))
            terms.append(Scale(Sum((above, Negative(below))), coefficient))
        return Sum(tuple(terms)) if len(terms) > 1 else terms[0] if terms else Scale(self.upper, Zero(*of.shape))

    def spelled(self, style: Style, spell: Callable[[Node], Piece]) -> Piece:
        of, by = spell(self.of).at_least(Precedence.PRODUCT, style), spell(self.by).text
        lower, upper = spell(self.lower).text, spell(self.upper).text
        sign = style.called(f"integral from {lower} to {upper} of", rf"\int_{{{lower}}}^{{{upper}}}")
        ends = style.called("d", r"\, \mathrm{d}")
        return Piece(f"{sign} {of.text} {ends}{by}", Precedence.DOT, of.depth)


@declaring
def definite_integral(
    of: Node | int | Fraction, by: Node, lower: Node | int | Fraction, upper: Node | int | Fraction
) -> DefiniteIntegral:
    """The integral of a polynomial in a scalar symbol, exponentials, cosines and sines, from one limit to another."""
    return DefiniteIntegral(lifted(of), by, lifted(lower), lifted(upper))
