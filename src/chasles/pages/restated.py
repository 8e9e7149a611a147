"""What a page states twice, the second time otherwise in one mark: one of the two is a slip, or another case."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from chasles.pages.edited_marks import one_mark_away
from chasles.statements import Claim
from chasles.vocabulary import Node, Symbol, walk

ENOUGH, ENOUGH_FOR_A_LETTER = 5, 8
"""Of fewer letters an equation says too little to be the same one; more show that one letter stands for another."""


def stated_otherwise(claim: Claim, earlier: Sequence[Claim]) -> Claim | None:
    """The last of the earlier equations from which a claim differs in one mark, or in one letter for another in it."""
    found = _letters(claim)
    if found.total() < ENOUGH:
        return None
    alike = (
        each
        for each in reversed(earlier)
        if len({*claim.printed} & {*each.printed}) == 1 and _are_alike(found, _letters(each))
    )
    return next((each for each in alike if _is_one_mark_away(claim, each) or _is_one_mark_away(each, claim)), None)


def _are_alike(one: Counter[Symbol], other: Counter[Symbol]) -> bool:
    """Whether two equations have the same letters, but for one that stands elsewhere in one of them."""
    if one == other:
        return True
    is_one_letter = (one - other).total() == (other - one).total() == 1 and one.total() >= ENOUGH_FOR_A_LETTER
    return is_one_letter and (one.keys() <= other.keys() or other.keys() <= one.keys())


def _is_one_mark_away(claim: Claim, other: Claim) -> bool:
    """Whether one change of a mark makes one equation of the other."""
    return any(other.printed == (left, right) for left, right, _ in one_mark_away(*claim.printed, (), lambda _: True))


def _letters(claim: Claim) -> Counter[Symbol]:
    sides: tuple[Node, ...] = claim.printed
    return Counter(part for side in sides for part in walk(side) if isinstance(part, Symbol))
