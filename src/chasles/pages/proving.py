"""Proofs of what a page claims, from what it has said or from what a person says that it rests on."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from chasles.pages.attempts import Attempt, Known, attempts, named, sides_of, ways, with_premises
from chasles.pages.bounded_proofs import proof_of, verdict_on
from chasles.pages.defining import definition_of, said_to_be
from chasles.pages.finding import PageFinding
from chasles.pages.notes import Given
from chasles.pages.other_kinds import doubt_of_falsity, doubt_of_reals, doubt_of_truth
from chasles.pages.premises import PosedEquation, chosen_rules
from chasles.pages.quantities import Quantity
from chasles.pages.stating import Stating, given_freely
from chasles.repairs.repair import Repair
from chasles.statements import Claim, Statement
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder, Verdict


@dataclass
class Proving:
    """Finds proofs of claims, which are premises of what follows then.

    Where what the letters are `is_proposed` only, or the page `is_complex`, some findings are in doubt. So many sets of
    premises from which a claim is not likely to follow are tried for each.
    """

    stating: Stating
    is_proposed: bool
    is_complex: bool
    most_unlikely: int

    def proof(self, claim: Claim, cited: tuple[Given, ...] = ()) -> PageFinding | None:
        """The finding on a claim that follows from what the page has said; None for any other."""
        unlikely = 0
        for attempt in attempts(
            claim, self.stating.premises, self.stating.consequences, self._sets_cited(claim, cited)
        ):
            unlikely += not attempt.likely
            if not attempt.likely and unlikely > self.most_unlikely:
                continue
            verdict = proof_of(attempt.claim, self.stating.session, attempt.likely)
            if verdict is not None:
                verdict = _resting_on(attempt.assumed, verdict)
                self.stating.premises.relied.update(verdict.needs)
                if doubt := self.doubt(attempt.claim):
                    return PageFinding("claim", verdict, attempt.claim, open=True, doubt=doubt)
                return self.stating.proved(attempt.claim, verdict)
        return None

    def _sets_cited(self, claim: Claim, cited: tuple[Given, ...]) -> Iterator[Known]:
        """What the prose cites: alone, and with what the page says of the symbols in it."""
        if cited:
            rules, posed = self._premises_of(cited)
            yield chosen_rules(sides_of(claim, posed), rules), posed
            table = {**self.stating.premises.defined(), **self.stating.premises.proved}
            applied = {named(rule) for rule in table.values()}
            others = tuple(self.stating.assumption(*each) for each in cited if each[0] not in applied)
            yield chosen_rules(sides_of(claim, others), table), others

    def _premises_of(self, given: Iterable[Given]) -> tuple[dict[Quantity, Statement], tuple[PosedEquation, ...]]:
        """Equations as rules for the symbols that stand alone in them, the first of each; others are assumed."""
        rules: dict[Quantity, Statement] = {}
        posed: list[PosedEquation] = []
        for name, each in ((name, self.stating.as_said(each)) for name, each in given):
            key = said_to_be(each)
            if key is not None and key[0] not in rules:
                rules[key[0]] = definition_of(each, key[1])
            else:
                posed.append(self.stating.assumption(name, each))
        return rules, tuple(posed)

    def doubt(self, claim: Claim, instead: Repair | None = None, is_true: bool = True) -> str:
        """Under what kinds of letters alone a claim is true, or false; empty where that is not in doubt."""
        if self.is_complex and (doubt := doubt_of_reals(claim)):
            return doubt
        if not self.is_proposed:
            return ""
        known = self.stating.consequences
        return doubt_of_truth(claim, known) if is_true else doubt_of_falsity(claim, instead, known)

    def under(self, claim: Claim, given: tuple[Given, ...]) -> PageFinding:
        """The finding on a claim under the premises that a person gives, and no others of the page.

        What is proved of what the page does not say is assumed in what follows.
        """
        (rules, posed), told = self._premises_of(given), tuple(name for name, _ in given)
        attempt = with_premises(claim, self.stating.premises, rules, posed)
        likely = self.stating.consequences.may_follow(*claim.printed, rules, posed)
        proved, verdict = attempt, None
        for way in ways(Attempt(attempt, bool(likely)), self.stating.premises, posed) if likely is not False else ():
            proved, verdict = way.claim, proof_of(way.claim, self.stating.session, way.likely)
            if verdict is not None:
                break
        verdict = verdict or verdict_on(attempt, self.stating.session)
        if verdict.true:
            if not {named(each) for each in self.stating.premises.said}.issuperset(told):
                self.stating.posed(claim, False, verdict)
            return replace(self.stating.proved(proved, given_freely(told, verdict)), given=told)
        against = (*(rule.number for rule in rules.values()), *(h.text for h in attempt.assuming))
        is_open = not isinstance(verdict, Fails | Contradictory)
        return PageFinding("claim", verdict, attempt, open=is_open, against=against, given=told)


def _resting_on(opened: tuple[str, ...], verdict: Verdict) -> Verdict:
    """The verdict with the open equations that it rests on among what it needs."""
    if not opened or not isinstance(verdict, Holds | HoldsUnder):
        return verdict
    return HoldsUnder((*verdict.needs, *opened), verdict.certificate, verdict.witness, verdict.unused)
