"""Expressions that are visibly sums of squares: never negative, and zero only where each square is.

Only the spelling counts: even powers, norms, scalar products of an expression with itself, positive factors, integrals
of such over a body. Nothing is computed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from chasles.statements.hypotheses import Hypothesis
from chasles.vocabulary import (
    Contract,
    Dot,
    Group,
    Integral,
    Misfit,
    Node,
    Norm,
    Number,
    Power,
    Quotient,
    Scale,
    Sum,
    Symbol,
    Trace,
    Transpose,
)


def squared(square: Node) -> tuple[Node, ...]:
    """What vanishes when the square does; nothing for a positive number or symbol.

    Raises `Misfit` where it is no product of a square and of factors that cannot vanish: the integral of a square
    vanishes where the square does in every element of the body, which is no equation.
    """
    match square:
        case Number() | Symbol():
            return ()
        case Group(of):
            return squared(of)
        case Norm(of) | Power(Norm(of), _) | Power(of, _):
            return (of,)
        case Dot(left, right) if left == right:
            return (left,)
        case Contract((Transpose(left), *_, right)) if left == right:
            return (left,)
        case Scale(factor, term) | Quotient(term, factor):
            found = (*squared(factor), *squared(term))
            if len(found) < 2:
                return found
    raise Misfit(f"{square} is not one square times factors that do not vanish")


def relied_on(square: Node, hypotheses: Iterable[Hypothesis]) -> Iterator[Hypothesis]:
    """The hypotheses by which the expression is never negative; raises `Misfit` if it is not seen to be so."""
    match square:
        case Number(value) if value >= 0:
            return
        case Norm():
            return
        case Power(base, exponent) if base.is_scalar and exponent % 2 == 0:
            return
        case Dot(left, right) if left == right:
            return
        case Contract((Transpose(left), right)) | Trace(Contract((Transpose(left), right))) if left == right:
            return
        case Symbol():
            yield _named("positive", square, hypotheses)
        case Contract((Transpose(left), matrix, right)) if left == right:
            yield _named("definite", matrix, hypotheses)
        case Scale(factor, term) | Quotient(factor, term):
            yield from relied_on(factor, hypotheses)
            yield from relied_on(term, hypotheses)
        case Sum(terms):
            for term in terms:
                yield from relied_on(term, hypotheses)
        case Group(of) | Power(of, _):
            yield from relied_on(of, hypotheses)
        case Integral(of, density):
            yield _named("positive", density, hypotheses)
            yield from relied_on(of, hypotheses)
        case _:
            raise Misfit(f"{square} is not seen to be a square, or a sum of squares with positive factors")


def _named(kind: str, subject: Node, hypotheses: Iterable[Hypothesis]) -> Hypothesis:
    """The hypothesis of that kind on the subject."""
    for hypothesis in hypotheses:
        if hypothesis.kind == kind and subject in hypothesis.subjects:
            return hypothesis
    raise Misfit(f"{subject} is not assumed to be {kind}, so a sum with it is not seen to be one of squares")
