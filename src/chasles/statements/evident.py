"""Divisors that are positive wherever they are real: one and squares, sums of what is assumed positive."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace as with_fields

from chasles import vocabulary as w
from chasles.statements.hypotheses import Hypothesis, nonzero
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Node


def evident_divisors(
    sides: Iterable[Node], hypotheses: tuple[Hypothesis, ...], rules: Mapping[Node, Node]
) -> Iterator[Hypothesis]:
    """That divisors are not zero which nothing declares so: those of tangents, and what is seen to be of one sign.

    Those that are so whatever symbols stand for are "evident", and are no condition of a verdict.
    """
    whole = {node: h for h in hypotheses for node in h.nonvanishing}
    declared = {factor: h for node, h in whole.items() for factor in _factors(node)} | whole
    quotients = [part for side in sides for part in opened_parts(side) if isinstance(part, w.Quotient)]
    named = {quotient.denominator for quotient in quotients if quotient.called}
    for divisor in dict.fromkeys(part for quotient in quotients for part in _factors(quotient.denominator)):
        if divisor in whole:
            continue
        for other in (divisor, *_lengths(divisor)):
            if other in declared:
                yield with_fields(declared[other], subjects=(divisor,), nonvanishing=(divisor,))
                break
        if isinstance(divisor, w.Sum | w.Symbol):
            from chasles.statements.bounds import AssumedBounds  # few claims divide by what nothing declares

            if AssumedBounds(hypotheses, rules).exclude_zero(divisor):
                always = AssumedBounds((), rules).exclude_zero(divisor)
                yield with_fields(nonzero(divisor), kind="evident") if always else nonzero(divisor)
        elif divisor in named:
            yield nonzero(divisor)


def _factors(node: Node) -> Iterator[Node]:
    match node:
        case w.Group(of) | w.Power(of):
            yield from _factors(of)
        case w.Scale(factor, term) if term.is_scalar:
            yield from _factors(factor)
            yield from _factors(term)
        case _:
            yield node


def _lengths(node: Node) -> tuple[Node, ...]:
    """The length of a vector, its square, and how else it is written: where one is not zero, none is."""
    match node:
        case w.Dot(one, other) | w.Contract((w.Transpose(one), other)) if one == other and one.shape[1] == 1:
            of = one
        case w.Norm(of):
            pass
        case _:
            return ()
    return w.Norm(of), w.Dot(of, of), w.Contract((w.Transpose(of), of)), w.Power(w.Norm(of), 2)
