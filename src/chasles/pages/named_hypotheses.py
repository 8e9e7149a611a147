"""The named hypothesis that an equation is: points that satisfy it are then drawn, and not searched for."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace as with_fields
from itertools import permutations

from chasles.decisions.session import Session
from chasles.pages.bounded_proofs import proof_of
from chasles.pages.consequences import Consequences
from chasles.pages.premises import posed
from chasles.statements import Claim, Hypothesis, perpendicular, symmetric, unit, unit_column
from chasles.statements.matrices import commuting, idempotent, orthogonal, skew_symmetric
from chasles.vocabulary import Dot, Misfit, Negative, Node, Norm, Number, Sum, Symbol, symbols_of

NAMED: tuple[tuple[int, Callable[..., Hypothesis]], ...] = (
    (1, unit), (1, symmetric), (1, orthogonal), (1, skew_symmetric), (1, idempotent), (2, perpendicular), (2, commuting)
)  # fmt: skip
"""The named hypotheses on so many symbols each."""


def as_hypothesis(said: str, left: Node, right: Node, session: Session, consequences: Consequences) -> Hypothesis:
    """An equation as a hypothesis that is told as `said`: the named one that says the same, or a free one."""
    for one, other in ((left, right), (right, left)):
        if isinstance(one, Norm) and isinstance(other, Number) and other.value >= 0:
            left, right = Dot(one.of, one.of), Number(other.value**2)
    symbols = [s for s in symbols_of(Sum((left, Negative(right)))) if s.stands_for is None and not s.constant]
    for named in _candidates(symbols):
        if any(_is_same((left, right), equation, session, consequences) for equation in named.equations):
            return with_fields(named, latex=said, text=said)
    return posed(said, left, right)


def _candidates(symbols: Sequence[Symbol]) -> Iterator[Hypothesis]:
    """The named hypotheses on just these symbols."""
    for count, kind in NAMED:
        if count == len(symbols):
            for order in permutations(symbols):
                with suppress(Misfit, TypeError):
                    yield kind(*order)
    if symbols:
        with suppress(Misfit, TypeError):
            yield unit_column(*symbols)


def _is_same(one: tuple[Node, Node], other: tuple[Node, Node], session: Session, consequences: Consequences) -> bool:
    """Whether the sides of two equations differ by the same, or by the opposite."""
    if one[0].shape != other[0].shape:
        return False
    difference = Sum((one[0], Negative(one[1])))
    with suppress(Misfit, TypeError):
        for left, right in (other, other[::-1]):
            claim = Claim("", difference, Sum((left, Negative(right))), sic=True)
            if consequences.may_follow(*claim.printed, {}) is not False and proof_of(claim, session) is not None:
                return True
    return False
