"""What a page says, taken as premises of what follows: definitions, posed equations, proved claims."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from chasles.decisions.session import Session
from chasles.pages.attempts import all_said, named, with_premises
from chasles.pages.bounded_proofs import posed_on
from chasles.pages.consequences import Consequences
from chasles.pages.defining import definition_of, said_to_be
from chasles.pages.finding import PageFinding
from chasles.pages.named_hypotheses import as_hypothesis
from chasles.pages.premises import PosedEquation, Premises, chosen_rules, free_quantities
from chasles.pages.quantities import Quantity, quantity, symbols_in
from chasles.pages.unsaid_derivatives import UnsaidDerivatives
from chasles.prover.certifying import proved
from chasles.reading.reading import Part
from chasles.statements import Claim, Statement, nonzero
from chasles.verdict import Defined, HoldsUnder, Undecided, Verdict
from chasles.vocabulary import PI
from chasles.vocabulary.families import indices_of


@dataclass
class Stating:
    """Takes equations of a page into its premises; `consequences` tells what may follow from these."""

    premises: Premises
    session: Session
    consequences: Consequences
    derivatives: UnsaidDerivatives = field(default_factory=UnsaidDerivatives)

    def copy(self) -> Stating:
        """The same, that takes what is said from here on by itself."""
        return replace(self, premises=self.premises.copy(), derivatives=self.derivatives.copy())

    def as_said(self, claim: Claim) -> Claim:
        """The claim without derivatives of what the page has not said to depend on anything."""
        if claim.fault:
            return claim
        left, right = self.derivatives.without(claim.printed, self.premises.defined())
        return claim if claim.printed == (left, right) else replace(claim, left=left, right=right)

    def assumption(self, name: str, said: Part | Claim) -> PosedEquation:
        """An equation that is assumed, by the name under which it is told."""
        left, right = self.as_said(Claim(name, said.left, said.right, sic=True)).printed
        return PosedEquation(as_hypothesis(name, left, right, self.session, self.consequences), left, right, False)

    def defined(self, claim: Claim, key: Quantity, turned: bool) -> PageFinding:
        """A definition of a quantity, `turned` if that stands on the right; what was proved of it, or open, is gone."""
        made = definition_of(claim, turned)
        known = self.premises.definitions.setdefault(
            key, [None] if any(q[0] == key[0] for q in self.premises.spoken) else []
        )
        known.insert(0, made)
        self.premises.said.append(made)
        self.premises.proved.pop(key, None)
        self.premises.opened.pop(key, None)
        return PageFinding("definition", Defined(), made)

    def posed(self, claim: Claim, is_open: bool, verdict: Verdict, is_rule: bool = False) -> PageFinding:
        """An equation that is assumed in what follows, with its verdict; open ones and rules define a letter alone."""
        if not any(map(indices_of, claim.printed)):
            said = as_hypothesis(named(claim), *claim.printed, self.session, self.consequences)
            key = said_to_be(claim) if is_open or is_rule else None
            self.premises.unproved.add(named(claim))
            if is_open and is_value(claim):
                return PageFinding("condition", verdict, claim, open=True)  # that in one case
            if key is not None:
                self.premises.opened[key[0]] = definition_of(claim, key[1])
                self.premises.said.append(self.premises.opened[key[0]])
            self.premises.posed.append(PosedEquation(said, claim.left, claim.right, is_open, key is not None))
        return PageFinding("condition", verdict, claim, open=is_open)

    def satisfied(self, claim: Claim) -> Verdict:
        """The verdict on a condition: posed if a point satisfies it with all that the page has said of its symbols.

        Where that takes too long, with what the notation says of them.
        """
        said = as_hypothesis(named(claim), *claim.printed, self.session, self.consequences)
        verdict: Verdict = Undecided("no point was looked for")
        for known in (all_said(claim, self.premises, 0), ({}, ())):
            assumed = with_premises(claim, self.premises, *known, everything=True)
            verdict = posed_on(replace(assumed, assuming=(*assumed.assuming, said)), self.session)
            if not isinstance(verdict, Undecided):
                break
        return verdict

    def proved(self, claim: Claim, verdict: Verdict) -> PageFinding:
        """A claim that is proved, without the hypotheses that it does not need; it says what a quantity is."""
        unused = verdict.unused
        least = replace(claim, assuming=tuple(h for h in claim.assuming if h.text not in unused))
        sides = (*claim.printed, *(side for each in claim.given for side in each.printed))
        verdict = given_freely((nonzero(PI).text,), verdict) if PI in symbols_in(sides) else verdict
        key = quantity(claim.left)
        behind = free_quantities((claim.right,), chosen_rules((claim.right,), self.premises.defined()))
        if key is not None and not any(symbol == key[0] for symbol, _ in behind):
            # What it was proved under need not be assumed again: a problem with more hypotheses takes more work.
            self.premises.proved[key] = definition_of(least, False)
            self.premises.said.append(self.premises.proved[key])
        return PageFinding("claim", verdict, least)


def is_value(said: Statement) -> bool:
    """Whether it says what number a letter is, which may be that of a case or an example."""
    letters = [side for side in said.printed if (key := quantity(side)) is not None and not key[1]]
    return len(letters) == 1 and letters[0].is_scalar and len(symbols_in(said.printed)) == 1


def given_freely(given: tuple[str, ...], verdict: Verdict) -> Verdict:
    """The verdict without what a person has given, or what is known of numbers, among what it needs."""
    if not isinstance(verdict, HoldsUnder):
        return verdict
    needs = tuple(need for need in verdict.needs if need not in given)
    return proved(needs, verdict.certificate, verdict.witness, verdict.unused)
