"""What a refuted equation of a page was meant to say: a true equation one slip of the pen away, which says something.

Only that shows it to be a slip. Where no such equation is near, it may as well be a condition.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace as with_fields
from fractions import Fraction
from functools import lru_cache, partial
from itertools import count, islice

from chasles import vocabulary as w
from chasles.decisions.session import Session
from chasles.motions.random_motion import MOST_FACTORS
from chasles.pages.attempts import named, with_premises
from chasles.pages.bounded_proofs import LESS_WORK, proof_of
from chasles.pages.consequences import Consequences
from chasles.pages.edited_marks import in_words, one_mark_away
from chasles.pages.premises import PosedEquation, Premises, Rules, free_quantities
from chasles.pages.quantities import quantities, quantity
from chasles.reading.fits import OF_ITS_OWN
from chasles.repairs.repair import Repair
from chasles.statements import Claim
from chasles.verdict import Holds, HoldsUnder
from chasles.vocabulary.letters import zero_of

MARKS = re.compile(r"[_'^]")
MOST_EDITS = 12
"""So many changes of one mark are proved or refuted; what does not agree at a random motion is no proof's matter."""
MOST_UNKNOWN = 4
"""So many of them of which a random motion does not tell whether they may be true."""
MOST_TESTS, FEWER_TESTS = 600, 150
"""So many are tried at a random motion, and fewer where that has to satisfy open equations."""


def true_but_for_a_slip(
    claim: Claim,
    known: tuple[Rules, tuple[PosedEquation, ...]],
    premises: Premises,
    session: Session,
    consequences: Consequences,
) -> Repair | None:
    """The first true equation one slip away from a claim, under the rules and posed equations that are known."""
    if _is_one_term_said_to_vanish(claim) or _is_a_value(claim):
        return None
    said_of = {symbol for symbol, _ in premises.definitions}
    spoken_of = tuple(symbol for symbol, _ in free_quantities(claim.printed, known[0]))
    edits_of = partial(
        one_mark_away, *claim.printed, spoken_of, lambda symbol: symbol in said_of or bool(premises.facts(symbol))
    )
    edits = edits_of()
    tested = [*islice(edits, FEWER_TESTS if any(each.open for each in known[1]) else MOST_TESTS)]
    shown = _shown(claim, premises)
    if claim.left in shown:  # it was printed before, and mostly right
        tested.sort(key=lambda edit: edit[0] != claim.left)
    slips = (edit for edit in tested if _is_slip(claim, edit[:2], premises, shown))
    found = ((*edit[:2], consequences.may_follow(*edit[:2], *known)) for edit in slips)
    unknown = count()
    agreeing = (edit for edit in found if edit[-1] is not False)
    for left, right, likely in islice(agreeing, MOST_EDITS):
        meant = with_fields(claim, left=left, right=right, sic=True)
        if meant.fault or _cancels(claim, (left, right)) or _says_nothing(left, right):
            continue
        if not any(map(_is_zero, claim.printed)) and consequences.may_follow(left, zero_of(left.shape), *known):
            continue  # 0 = 0 under the premises: the change brings in what vanishes
        if likely is None and next(unknown) >= MOST_UNKNOWN:
            continue
        for chosen in (consequences.least(left, right, *known), known) if likely else (known,):
            verdict = proof_of(with_premises(meant, premises, *chosen), session, bool(likely), LESS_WORK)
            if isinstance(verdict, Holds | HoldsUnder):
                said = next(words for *sides, words in edits_of(in_words) if sides == [left, right])
                return Repair(left, right, (said,), 1, verdict)
    return None


def _shown(claim: Claim, premises: Premises) -> set[w.Node]:
    """What known quantities are said to be, and what that was proved to be in the same equation."""
    shown = {rule.right for rule in (*premises.defined().values(), *premises.proved.values())}
    for each in premises.told.get(claim.number, ()):
        shown |= {each.right} if each.left in shown and named(each) not in premises.unproved else set()
    return shown


def _is_about_known(claim: Claim, premises: Premises, shown: set[w.Node]) -> bool:
    """Whether a side is made of known quantities, or what one was shown to be; or all letters are known."""
    known = {**premises.defined(), **premises.proved}
    if any(quantity(side) in known or side in shown for side in claim.printed):
        return True
    if any((made_of := set(quantities(side))) and made_of <= known.keys() for side in claim.printed):
        return True
    said = {symbol for symbol, _ in known}
    return all(s in said or premises.facts(s) for side in claim.printed for s, _ in quantities(side))


def _is_slip(claim: Claim, sides: tuple[w.Node, w.Node], premises: Premises, shown: set[w.Node]) -> bool:
    """Whether what is changed is a mark; or one letter, in what is said of a quantity that is known.

    In what was shown before no letter is changed. Another letter, or another term, may make any condition true; of a
    side that is one product of two letters it leaves too little to say that this was meant. A new letter was not meant
    for one that differs from it by its marks alone, nor a function for its values, nor a quantity of its own for any,
    nor is one that the page goes on to use a slip.
    """
    before, after = _symbols(claim.printed), _symbols(sides)
    if before == after:
        return True
    is_one_letter = (before - after).total() == (after - before).total() == 1
    if is_one_letter and sides[0] != claim.left and claim.left in shown:
        return False
    if is_one_letter and min(_symbols((side,)).total() for side in claim.printed) == 1 and before.total() < 4:
        return False
    spoken = {symbol for symbol, _ in premises.spoken}
    if is_one_letter:
        (new,), (old,) = before - after, after - before
        if OF_ITS_OWN in (new.meaning, old.meaning) or new in premises.recurring - spoken:
            return False
        is_bare = old.letter.startswith(f"{new.letter}(") or new.letter.startswith(f"{old.letter}(")
        if is_bare or (new not in spoken and MARKS.split(w.plain(new))[0] == MARKS.split(w.plain(old))[0]):
            return False
    return is_one_letter and _is_about_known(claim, premises, shown)


def _cancels(claim: Claim, sides: tuple[w.Node, w.Node]) -> bool:
    """Whether the change makes terms cancel that did not: what was printed says more than what would be meant."""
    return sum(map(_cancelling, sides)) > sum(map(_cancelling, claim.printed))


def _says_nothing(left: w.Node, right: w.Node) -> bool:
    """Whether the sides are the same terms, or the same product, written otherwise: that says not what was meant."""
    one, other = (map(_unsigned, side.terms if isinstance(side, w.Sum) else (side,)) for side in (left, right))
    return Counter(one) == Counter(other) or _is_one_product(left, right)


def _is_one_product(left: w.Node, right: w.Node) -> bool:
    one, other = (tuple(_factors(side)) for side in (left, right))
    in_order = [[each for each in side if not each.is_scalar] for side in (one, other)]
    return Counter(one) == Counter(other) and in_order[0] == in_order[1]


def _factors(side: w.Node) -> Iterator[w.Node]:
    match side:
        case w.Negative(of):
            yield from (w.Number(Fraction(-1)), *_factors(of))
        case w.Power(base, exponent) if isinstance(exponent, int) and exponent <= MOST_FACTORS:
            yield from (*_factors(base),) * exponent
        case w.Group() | w.Scale() | w.Contract():
            yield from (factor for part in side.below for factor in _factors(part))
        case w.Transpose(of) if of.is_scalar:
            yield from _factors(of)
        case _:
            yield side


def _cancelling(side: w.Node) -> int:
    count = 0
    for part in w.walk(side):
        terms = [_unsigned(term) for term in part.terms] if isinstance(part, w.Sum) else []
        count += sum((not is_negative, term) in terms for is_negative, term in terms)
    return count


def _unsigned(term: w.Node) -> tuple[bool, w.Node]:
    """Whether a term is negative, and what it is but for that and its brackets."""
    is_negative = False
    while isinstance(term, w.Negative | w.Group):
        is_negative ^= isinstance(term, w.Negative)
        term = term.below[0]
    return is_negative, term


@lru_cache(maxsize=64)
def _symbols(sides: tuple[w.Node, ...]) -> Counter[w.Symbol]:
    return Counter(part for side in sides for part in w.walk(side) if isinstance(part, w.Symbol))


def _is_one_term_said_to_vanish(claim: Claim) -> bool:
    """Whether a slip of the pen would have left it as true or as false."""
    one, other = claim.printed
    return any(_is_zero(right) and not isinstance(left, w.Sum) for left, right in ((one, other), (other, one)))


def _is_zero(side: w.Node) -> bool:
    return side == w.Number(Fraction(0)) or isinstance(side, w.Zero)


def _is_a_value(claim: Claim) -> bool:
    """Whether it says what a letter is in numbers: that may be another one from case to case."""
    return any(quantity(side) is not None for side in claim.printed) and min(map(_letters, claim.printed)) == 0


def _letters(side: w.Node) -> int:
    return _symbols((side,)).total()
