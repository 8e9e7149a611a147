"""Partial derivatives of what the page has not said to depend on anything: quantities of their own, not zeros."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from chasles.pages.premises import Rules, chosen_rules
from chasles.pages.quantities import symbols_in
from chasles.reading.fits import OF_ITS_OWN, own_quantity
from chasles.statements.rules import rated
from chasles.vocabulary import Node, Symbol, latex, undotted, walk
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.partial import PartialDerivative
from chasles.vocabulary.tree import replace


@dataclass(slots=True)
class UnsaidDerivatives:
    """Makes derivatives say what they are of; letters that the page differentiates itself depend on something."""

    _functions: set[Symbol] = field(default_factory=set)

    def copy(self) -> UnsaidDerivatives:
        """The same, which goes on from here by itself."""
        return UnsaidDerivatives(set(self._functions))

    def without(self, sides: Sequence[Node], rules: Rules) -> list[Node]:
        """The sides with a quantity of its own for each derivative of which the rules do not say what it is.

        They say it where, written out, the letter stands in what is derived, and no function of which only the value is
        named; then it is that of what is written out. A derivative of a letter of which the page has said nothing may
        be anything.
        """
        parts = [part for side in sides for part in walk(side) if isinstance(part, PartialDerivative)]
        known = {symbol for symbol, _ in rules}
        self._functions |= {p.of for p in parts if isinstance(p.of, Symbol) and p.of.stands_for is None} - known
        values: dict[Node, Node] = {part: self._said(part, rules) for part in parts if part.fault is None}
        return [replace(side, values) if values else side for side in sides]

    def _said(self, derivative: PartialDerivative, rules: Rules) -> Node:
        by = {undotted(symbol)[0] for symbol in symbols_in((derivative.by,))}
        chosen = chosen_rules((derivative.of,), rules)
        written = _written_out(derivative.of, {key: rule for key, rule in chosen.items() if key[0] not in by})
        found = symbols_in((written,))
        others = found - by
        values = {each for each in others if each.meaning == OF_ITS_OWN or each.letter.endswith(")")}
        said = by <= found and not (values or others & self._functions)
        if found and not said:
            return _own(derivative)
        return derivative if written == derivative.of else PartialDerivative(written, derivative.by)


def _written_out(node: Node, rules: Rules) -> Node:
    """The expression with what the rules say of the letters in it."""
    values = {rated(symbol, order): rule.right for (symbol, order), rule in rules.items()}
    for _ in rules:
        node = replace(node, values)
    return node


def _own(derivative: PartialDerivative) -> Node:
    homes: Iterable[str] = (symbol.home for symbol in symbols_in((derivative,)))
    return own_quantity(latex(derivative), measured(derivative), next(iter(homes), ""))
