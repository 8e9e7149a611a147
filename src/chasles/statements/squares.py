"""Expressions that are visibly sums of squares: never negative, and zero only where each square is.

Only the spelling counts: even powers, norms, scalar products of an expression with itself, positive factors, integrals
of such over a body. Nothing is computed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from chasles import vocabulary as w
from chasles.statements.hypotheses import Hypothesis
from chasles.vocabulary import Node


def squared(square: Node) -> tuple[Node, ...]:
    """What vanishes when the square does; nothing for a positive number or symbol.

    Raises `Misfit` where it is no product of a square and of factors that cannot vanish: the integral of a square
    vanishes where the square does in every element of the body, which is no equation.
    """
    match square:
        case w.Number() | w.Symbol():
            return ()
        case w.Group(of):
            return squared(of)
        case w.Norm(of) | w.Power(w.Norm(of), _) | w.Power(of, _):
            return (of,)
        case w.Dot(left, right) if left == right:
            return (left,)
        case w.Contract((w.Transpose(left), *_, right)) if left == right:
            return (left,)
        case w.Scale(factor, term) | w.Quotient(term, factor):
            found = (*squared(factor), *squared(term))
            if len(found) < 2:
                return found
    raise w.Misfit(f"{square} is not one square times factors that do not vanish")


def relied_on(square: Node, hypotheses: Iterable[Hypothesis]) -> Iterator[Hypothesis]:
    """The hypotheses by which the expression is never negative; raises `Misfit` if it is not seen to be so."""
    match square:
        case w.Number(value) if value >= 0:
            return
        case w.Norm():
            return
        case w.Power(base, exponent) if base.is_scalar and exponent % 2 == 0:
            return
        case w.Dot(left, right) if left == right:
            return
        case w.Contract((w.Transpose(left), right)) | w.Trace(w.Contract((w.Transpose(left), right))) if left == right:
            return
        case w.Symbol():
            yield _named("positive", square, hypotheses)
        case w.Contract((w.Transpose(left), matrix, right)) if left == right:
            yield _named("definite", matrix, hypotheses)
        case w.Scale(factor, term) | w.Quotient(factor, term):
            yield from relied_on(factor, hypotheses)
            yield from relied_on(term, hypotheses)
        case w.Sum(terms):
            for term in terms:
                yield from relied_on(term, hypotheses)
        case w.Group(of) | w.Power(of, _):
            yield from relied_on(of, hypotheses)
        case w.Integral(of, density):
            yield _named("positive", density, hypotheses)
            yield from relied_on(of, hypotheses)
        case _:
            raise w.Misfit(f"{square} is not seen to be a square, or a sum of squares with positive factors")


def _named(kind: str, subject: Node, hypotheses: Iterable[Hypothesis]) -> Hypothesis:
    """The hypothesis of that kind on the subject."""
    for hypothesis in hypotheses:
        if hypothesis.kind == kind and subject in hypothesis.subjects:
            return hypothesis
    raise w.Misfit(f"{subject} is not assumed to be {kind}, so a sum with it is not seen to be one of squares")
