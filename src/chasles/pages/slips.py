"""What a refuted equation of a page was meant to say: a true equation one slip of the pen away, which says something.

Only that shows it to be a slip. Where no such equation is near, it may as well be a condition.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace as with_fields
from fractions import Fraction
from itertools import islice

from chasles.algebra.work_limit import OutOfTime, within
from chasles.decisions.session import Session
from chasles.pages.bounded_proofs import proof_of
from chasles.pages.edited_marks import one_mark_away
from chasles.pages.premises import Premises, quantities, quantity
from chasles.repairs.modular_testing import REFUSED, modular_test
from chasles.repairs.repair import Repair, repair
from chasles.statements import Claim
from chasles.verdict import Holds, HoldsUnder
from chasles.vocabulary import Group, Negative, Node, Number, Sum, Symbol, Zero, walk

__all__ = ["true_but_for_a_slip"]

EFFORT = 3e5
"""The work that the search for what was meant may take, in products of terms."""
MOST_EDITS = 60
"""So many changes of one mark are proved or refuted; what does not vanish at random points is no proof's matter."""
MOST_TESTS = 600
"""So many are tried at random points."""


def true_but_for_a_slip(
    claim: Claim, attempts: Sequence[Claim], premises: Premises, session: Session
) -> Iterator[Repair]:
    """The true equations one slip away from a claim; `attempts` are the claim with premises, the most with the last."""
    if _is_one_term_said_to_vanish(claim):
        return
    known = {symbol for symbol, _ in premises.definitions}
    edits = one_mark_away(*claim.printed, lambda symbol: symbol in known or bool(premises.facts(symbol)))
    candidates = _likely(attempts[-1], islice(edits, MOST_TESTS), session)
    for left, right, said in islice(candidates, MOST_EDITS):
        meant = with_fields(attempts[-1], left=left, right=right, sic=True)
        verdict = None if meant.fault else proof_of(meant, session)
        if isinstance(verdict, Holds | HoldsUnder) and not _cancels(claim, (left, right)):
            yield Repair(left, right, (said,), 1, verdict)
    for attempt in attempts:
        for found in repair(attempt, session.accepted, EFFORT):
            sides = found.left, found.right
            if found.edits == 1 and sides[0] != sides[1] and _is_slip(claim, found, premises):
                yield from () if _cancels(claim, sides) else (found,)


def _likely(
    claim: Claim, edits: Iterable[tuple[Node, Node, str]], session: Session
) -> Iterator[tuple[Node, Node, str]]:
    """The edits that agree at random points where the premises hold; all of them where there are no such points.

    None where it takes too long to write the premises out.
    """
    try:
        with within(EFFORT):
            test = modular_test(claim, *claim.printed, session.accepted)
    except REFUSED:
        test = None
    except OutOfTime:
        return
    for left, right, said in edits:
        try:
            if test is None or not any(test.residual_of(test.varied, left, right)):
                yield left, right, said
        except REFUSED:
            yield left, right, said


def _is_slip(claim: Claim, found: Repair, premises: Premises) -> bool:
    """Whether what is changed is a mark; or one letter, in what is said of a quantity that is known.

    Another letter, or another term, may make any condition true; of a side that is one product of two letters it leaves
    too little to say that this was meant.
    """
    before, after = _symbols(claim.printed), _symbols((found.left, found.right))
    if before == after:
        return True
    known = {**premises.defined(), **premises.proved}
    is_one_letter = (before - after).total() == (after - before).total() == 1
    if is_one_letter and min(_symbols((side,)).total() for side in claim.printed) == 1 and before.total() < 4:
        return False
    said = {symbol for symbol, _ in known}
    is_about_known = any(quantity(side) in known for side in claim.printed) or all(
        symbol in said or premises.facts(symbol) for side in claim.printed for symbol, _ in quantities(side)
    )
    return is_one_letter and is_about_known


def _cancels(claim: Claim, sides: tuple[Node, Node]) -> bool:
    """Whether the change makes terms cancel that did not: what was printed says more than what would be meant."""
    return sum(map(_cancelling, sides)) > sum(map(_cancelling, claim.printed))


def _cancelling(side: Node) -> int:
    count = 0
    for part in walk(side):
        terms = [_unsigned(term) for term in part.terms] if isinstance(part, Sum) else []
        count += sum((not is_negative, term) in terms for is_negative, term in terms)
    return count


def _unsigned(term: Node) -> tuple[bool, Node]:
    """Whether a term is negative, and what it is but for that and its brackets."""
    is_negative = False
    while isinstance(term, Negative | Group):
        is_negative ^= isinstance(term, Negative)
        term = term.below[0]
    return is_negative, term


def _symbols(sides: Iterable[Node]) -> Counter[Node]:
    return Counter(part for side in sides for part in walk(side) if isinstance(part, Symbol))


def _is_one_term_said_to_vanish(claim: Claim) -> bool:
    """Whether a slip of the pen would have left it as true or as false."""
    one, other = claim.printed
    zero = Number(Fraction(0))
    return any(
        (right == zero or isinstance(right, Zero)) and not isinstance(left, Sum)
        for left, right in ((one, other), (other, one))
    )
