"""What does not follow from a page: it fails, if one slip away from it something true is said, or it is open."""

from __future__ import annotations

from dataclasses import replace as with_fields

from chasles.decisions.session import Session
from chasles.pages.attempts import MOST_POSED, sides_of, with_everything, with_premises
from chasles.pages.bounded_proofs import verdict_on
from chasles.pages.consequences import Consequences
from chasles.pages.finding import PageFinding
from chasles.pages.notes import is_defining
from chasles.pages.other_kinds import imaginary_unit
from chasles.pages.premises import Premises, chosen_rules, free_quantities
from chasles.pages.quantities import quantities, quantity
from chasles.pages.slips import true_but_for_a_slip
from chasles.reading.fits import OF_ITS_OWN
from chasles.repairs.repair import Repair
from chasles.statements import Claim
from chasles.verdict import Fails, Undecided, Verdict
from chasles.vocabulary import walk
from chasles.vocabulary.expansions import Limit, UpTo


def expanded(claim: Claim, premises: Premises, session: Session) -> PageFinding:
    """The finding on an expansion or a limit, which rests on definitions alone and is no premise of anything.

    It fails only where no letter stands in it but what goes to zero: any other may go with that.
    """
    left, right = claim.printed
    if isinstance(right, Limit) and not left.expands:
        claim = with_fields(claim, left=right, right=left)
    rules = chosen_rules(claim.printed, premises.defined())
    attempt = with_premises(claim, premises, rules, ())
    verdict = verdict_on(attempt, session)
    small = {part.small for side in claim.printed for part in walk(side) if isinstance(part, UpTo | Limit)}
    is_alone = all(symbol in small for symbol, _ in free_quantities(claim.printed, rules))
    return PageFinding("claim", verdict, attempt, open=not (verdict.true or (isinstance(verdict, Fails) and is_alone)))


def refuted(
    claim: Claim, premises: Premises, session: Session, consequences: Consequences, told: bool, may_define: bool
) -> PageFinding:
    """The finding on a claim that is not proved: it fails, or is open; one that may define tells no point then."""
    rules = chosen_rules(claim.printed, premises.defined())
    unit = imaginary_unit((*claim.printed, *(rule.right for rule in rules.values())))
    if unit is not None:
        reason = f"{unit} is the imaginary unit, and complex numbers have no word"
        return PageFinding("claim", Undecided(reason), claim, open=True)
    of_its_own = any(symbol.meaning == OF_ITS_OWN for symbol, _ in free_quantities(claim.printed, rules))
    is_asked = not (is_defining(claim) or of_its_own or _is_new_value(claim))
    is_false = consequences.may_follow(*claim.printed, rules) is False
    instead = _instead(claim, premises, session, consequences) if is_asked and is_false else None
    attempt, is_open = with_premises(claim, premises, rules, ()), instead is None and (is_false or not is_asked)
    if is_open and may_define:
        return PageFinding("claim", Undecided("nothing near it is true"), claim, open=True)
    verdict = verdict_on(attempt, session, is_brief=is_open and is_false and not told)
    if is_asked and not is_false and isinstance(verdict, Fails):
        instead = _instead(claim, premises, session, consequences)
    if not isinstance(verdict, Fails) or (instead is None and not told) or of_its_own:
        return PageFinding("claim", verdict, claim, open=True, instead=None if of_its_own else instead)
    everywhere: list[tuple[Claim, Verdict]] = []
    for generation in range(premises.generations):
        everything = with_everything(claim, premises, generation)
        found = verdict_on(everything, session)
        if not isinstance(found, Fails):
            return PageFinding("claim", found, claim, open=True, instead=instead)
        everywhere.append((everything, found))
    refuted_claim, first = everywhere[0]
    against = (*(given.number for given in refuted_claim.given), *(h.text for h in refuted_claim.assuming))
    return PageFinding("claim", first, refuted_claim, instead=instead, against=against)


def _is_new_value(claim: Claim) -> bool:
    """Whether a number is said to be made of itself: n = n/2 gives it a new value, and A + A = A is a law."""
    sides = (claim.printed, claim.printed[::-1])
    return any(one.is_scalar and (key := quantity(one)) and key in quantities(other) for one, other in sides)


def _instead(claim: Claim, premises: Premises, session: Session, consequences: Consequences) -> Repair | None:
    """A true equation but for one slip, under what the page says of the claim's symbols and does not leave open."""
    rules = premises.defined()
    deep = chosen_rules(claim.printed, rules)
    known = premises.restricting(free_quantities(claim.printed, deep), deep)
    posed = tuple(each for each in known if not each.open)[-MOST_POSED:]
    rules = chosen_rules(sides_of(claim, posed), rules)
    return true_but_for_a_slip(claim, (rules, posed), premises, session, consequences)
