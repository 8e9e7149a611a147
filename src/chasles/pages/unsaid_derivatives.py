"""Partial derivatives of what the page has not said to depend on anything: quantities of their own, not zeros."""

from __future__ import annotations

from collections.abc import Iterable

from chasles.pages.premises import Rules, chosen_rules, free_quantities
from chasles.pages.quantities import symbols_in
from chasles.reading.fits import OF_ITS_OWN, own_quantity
from chasles.vocabulary import Node, Symbol, latex, undotted, walk
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.partial import PartialDerivative
from chasles.vocabulary.tree import replace


def without_unsaid_derivatives(side: Node, rules: Rules) -> Node:
    """The side with a quantity of its own for each derivative of which the rules do not say what it is.

    They say it where, written out, the letter stands in what is derived, and no function of which only the value is
    named. A derivative of a letter of which the page has said nothing may be anything.
    """
    derived = [part for part in walk(side) if isinstance(part, PartialDerivative)]
    unsaid = [part for part in derived if part.fault is None and not _is_said(part, rules)]
    return replace(side, {part: _own(part) for part in unsaid}) if unsaid else side


def _is_said(derivative: PartialDerivative, rules: Rules) -> bool:
    chosen = chosen_rules((derivative.of,), rules)
    found = {symbol for symbol, _ in free_quantities((derivative.of,), chosen)}
    by = {undotted(symbol)[0] for symbol in symbols_in((derivative.by,))}
    return not found or (by <= found and not any(map(_is_value, found - by)))


def _is_value(symbol: Symbol) -> bool:
    """Whether it is the value of a function, or another quantity of its own."""
    return symbol.meaning == OF_ITS_OWN or symbol.letter.endswith(")")


def _own(derivative: PartialDerivative) -> Node:
    homes: Iterable[str] = (symbol.home for symbol in symbols_in((derivative,)))
    return own_quantity(latex(derivative), measured(derivative), next(iter(homes), ""))
