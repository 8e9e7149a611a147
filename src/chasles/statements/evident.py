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
    """That divisors are not zero which nothing declares so, and which are seen to be positive.

    Those that are so whatever symbols stand for are "evident", and are no condition of a verdict.
    """
    positive = {subject for h in hypotheses if h.kind == "positive" for subject in h.subjects}
    declared = {node: h for h in hypotheses for node in h.nonvanishing}
    quotients = (part for side in sides for part in opened_parts(side) if isinstance(part, w.Quotient))
    for divisor in dict.fromkeys(part for quotient in quotients for part in _factors(quotient.denominator)):
        if divisor in declared:
            continue
        for other in _lengths(divisor):
            if other in declared:
                yield with_fields(declared[other], subjects=(divisor,), nonvanishing=(divisor,))
                break
        counts = isinstance(rules.get(divisor), w.Integral)
        if (counts or isinstance(divisor, w.Sum)) and _sign(divisor, positive, rules):
            always = _sign(divisor, set(), rules)
            yield with_fields(nonzero(divisor), kind="evident") if always else nonzero(divisor)


def _factors(node: Node) -> Iterator[Node]:
    match node:
        case w.Group(of) | w.Power(of):
            yield from _factors(of)
        case w.Scale(factor, term):
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


def _sign(node: Node, positive: set[Node], rules: Mapping[Node, Node]) -> int | None:
    """1 for what is positive, 0 for what is not negative, None for what is neither at sight."""

    def sign(part: Node) -> int | None:
        return _sign(part, positive, rules)

    match node:
        case _ if node in positive:
            return 1
        case w.Symbol() if node in rules:
            return sign(rules[node])
        case w.Symbol(stands_for=Node() as of) | w.Group(of):
            return sign(of)
        case w.Number(value):
            return None if value < 0 else int(value > 0)
        case w.Sum(terms):
            signs = [found for found in map(sign, terms) if found is not None]
            return max(signs) if len(signs) == len(terms) else None
        case w.Scale(one, other):
            signs = [found for found in map(sign, (one, other)) if found is not None]
            return min(signs) if len(signs) == 2 else 0 if one == other and one.is_scalar else None
        case w.Quotient(above, below):
            return sign(above) if sign(below) == 1 else None
        case w.Power(base, exponent) if base.is_scalar:
            return 0 if exponent % 2 == 0 and sign(base) != 1 else sign(base)
        case w.Dot(one, other) | w.Contract((w.Transpose(one), other)) if one == other and one.shape[1] == 1:
            return 0
        case w.Norm():
            return 0
        case w.Integral(w.Number(value)):
            return int(value > 0)
        case _:
            return None
