"""What divisors need: those that are positive wherever they are real, and those that must not be zero."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace as with_fields

from chasles import vocabulary as w
from chasles.statements.hypotheses import Hypothesis
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Node


def needed_of_divisors(
    sides: Iterable[Node], hypotheses: tuple[Hypothesis, ...], rules: Mapping[Node, Node]
) -> Iterator[Hypothesis]:
    """That divisors are not zero which nothing declares so: an equation is about where its sides have values.

    What is seen not to be zero is "evident", no condition of a verdict; a `free` need may follow from declared ones.
    """
    whole = {node: h for h in hypotheses for node in h.nonvanishing}
    declared = {factor: h for node, h in whole.items() for factor in factors_of(node)} | whole
    for divisor in dict.fromkeys(
        factor for side in sides for each in _divisors(side, rules) for factor in factors_of(each)
    ):
        said = [declared[each] for each in (divisor, *_lengths(divisor)) if each in declared]
        if not said:
            from chasles.statements.bounds import seen_not_to_vanish  # few claims divide by what nothing declares

            said = [seen_not_to_vanish(divisor, rules)]
        if divisor not in whole:
            yield with_fields(said[0], subjects=(divisor,), nonvanishing=(divisor,))


def _divisors(side: Node, rules: Mapping[Node, Node]) -> Iterator[Node]:
    """What an expression divides by, and the lengths whose rates it takes, but for those of squares of lengths."""
    parts = opened_parts(side)
    rated = {each: None for part in parts if isinstance(part, w.Rate) for each in opened_parts(part.of)}
    while more := [each for part in rated if part in rules for each in opened_parts(rules[part]) if each not in rated]:
        rated |= dict.fromkeys(more)
    squared = {part.base for part in rated if isinstance(part, w.Power) and part.exponent in (2, 4)}
    yield from (part.denominator for part in parts if isinstance(part, w.Quotient))
    yield from (part for part in rated if isinstance(part, w.Norm) and part not in squared)


def factors_of(divisor: Node) -> Iterator[Node]:
    """The factors on whose vanishing it depends whether a divisor vanishes; a number is none."""
    match divisor:
        case w.Group(of) | w.Negative(of) | w.Power(of) | w.Quotient(of):
            yield from factors_of(of)
        case w.Scale(factor, term) | w.Dot(factor, term) if factor.is_scalar and term.is_scalar:
            yield from (each for part in (factor, term) for each in factors_of(part))
        case _ if not isinstance(divisor, w.Number):
            yield divisor


def _lengths(node: Node) -> tuple[Node, ...]:
    """The length of a vector, its square, and how else it is written: where one is not zero, none is."""
    match node:
        case w.Norm((of) as other) | w.Dot(of, other) | w.Contract((w.Transpose(of), other)) if of == other:
            return w.Norm(of), w.Dot(of, of), w.Contract((w.Transpose(of), of)), w.Power(w.Norm(of), 2)
    return ()
