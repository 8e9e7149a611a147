"""What does not follow from a page: it fails, if one slip away from it something true is said, or it is open."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace as with_fields

from chasles.decisions.session import Session
from chasles.pages.attempts import Known, all_said, known_of, named, with_premises
from chasles.pages.bounded_proofs import BRIEF, FEW_TERMS, LESS_WORK, OF_SLIP, verdict_on
from chasles.pages.consequences import Consequences
from chasles.pages.finding import PageFinding
from chasles.pages.notes import DEFINING, is_defining
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
    claim: Claim,
    premises: Premises,
    session: Session,
    consequences: Consequences,
    elsewhere: Sequence[Claim],
    told: bool,
    may_define: bool,
) -> PageFinding:
    """The finding on a claim that is not proved: it fails, or is open; one that may define tells no point then.

    It does not fail if what is true instead is stated `elsewhere`.
    """
    rules = chosen_rules(claim.printed, premises.defined())
    unit = imaginary_unit((*claim.printed, *(rule.right for rule in rules.values())))
    if unit is not None:
        reason = f"{unit} is the imaginary unit, and complex numbers are not treated"
        return PageFinding("claim", Undecided(reason), claim, open=True)
    of_its_own = any(symbol.meaning == OF_ITS_OWN for symbol, _ in free_quantities(claim.printed, rules))
    is_asked = not (claim.sign in DEFINING or _is_new_value(claim))
    is_said_anew = any(key in premises.opened for key in rules)
    may_fail = is_asked and not (of_its_own or is_said_anew or is_defining(claim))
    is_false = consequences.may_follow(*claim.printed, rules) is False
    nothing: tuple[None, None, Known] = None, None, ({}, ())
    instead, unsure, known = (
        _instead(claim, premises, session, consequences, elsewhere) if is_asked and is_false else nothing
    )
    attempt, is_open = with_premises(claim, premises, rules, ()), instead is None and (is_false or not may_fail)
    if is_open and may_define:
        return PageFinding("claim", Undecided("nothing near it is true"), claim, open=True)
    is_brief = is_open and is_false and not told
    verdict = verdict_on(attempt, session, OF_SLIP if instead else BRIEF if is_brief else FEW_TERMS)
    if may_fail and not is_false and isinstance(verdict, Fails):
        instead, unsure, known = _instead(claim, premises, session, consequences, elsewhere)
    again = unsure is not None and "" in unsure
    left_open = PageFinding("claim", verdict, claim, open=True, instead=instead, said_elsewhere=again)
    if not isinstance(verdict, Fails) or not (told or (instead and may_fail and not again)) or of_its_own:
        return left_open
    everywhere: list[tuple[Claim, Verdict]] = []
    work = LESS_WORK if told else 1.0  # a slip is found: now it is worth it
    for generation in range(premises.generations):
        said = all_said(claim, premises, generation)
        everything = with_premises(claim, premises, *said, everything=True)
        found = verdict_on(everything, session, work=work)
        if isinstance(found, Fails):
            everywhere.append((everything, found))
        elif not _differs(claim, said, consequences):
            return with_fields(left_open, verdict=found)
    if not everywhere:
        everything = with_premises(claim, premises, known[0], known[1], everything=True)
        found = verdict_on(everything, session, work=work)
        everywhere.append((everything, found) if isinstance(found, Fails) else (attempt, verdict))
    refuted_claim, first = everywhere[0]
    against = (*(given.number for given in refuted_claim.given), *(h.text for h in refuted_claim.assuming))
    fails = PageFinding("claim", first, refuted_claim, instead=instead, against=against)
    return with_fields(left_open, unless=(unsure, fails)) if unsure and not told else fails


def _differs(claim: Claim, said: Known, consequences: Consequences) -> bool:
    """Whether a random motion satisfies all that is said, and the sides differ there."""
    is_satisfied = consequences.may_follow(claim.left, claim.left, *said)
    return bool(is_satisfied) and consequences.may_follow(*claim.printed, *said) is False


def _is_new_value(claim: Claim) -> bool:
    """Whether a number is said to be made of itself: n = n/2 gives it a new value, and A + A = A is a law."""
    sides = (claim.printed, claim.printed[::-1])
    return any(one.is_scalar and (key := quantity(one)) and key in quantities(other) for one, other in sides)


def _instead(
    claim: Claim, premises: Premises, session: Session, consequences: Consequences, elsewhere: Sequence[Claim]
) -> tuple[Repair | None, frozenset[str] | None, Known]:
    """A true equation but for one slip under what the page says, on which open equations that rests, and under what.

    One of these over again, or what is stated elsewhere, is as well one of another case: the claim never fails then.
    """
    for known in known_of(claim, premises):
        if consequences.may_follow(*claim.printed, *known):
            continue
        found = true_but_for_a_slip(claim, known, premises, session, consequences)
        if found is not None:
            rules, posed = consequences.least(found.left, found.right, *known)
            opened = [rule for rule in rules.values() if rule in premises.opened.values()]
            said = [{each.left, each.right} for each in posed if each.open] + [{*rule.printed} for rule in opened]
            said += [{*each.printed} for each in elsewhere]
            again = [""] if {found.left, found.right} in said else []
            names = (*map(named, opened), *(each.hypothesis.text for each in posed if each.open))
            return found, frozenset([*again, *names]), known
    return None, None, ({}, ())
