"""Which equations of a page define, which claim, and from what each claim follows.

- A symbol alone on one side is defined: by a sign of definition, or where the page has said nothing of it before; so is
  its rate, which may depend on it. What the page has defined already is decided as a claim first, and defined anew only
  if it is not nearly true. Symbols that are new in a claim may be defined by the equations that follow at once, as
  behind "where".
- Everything else is a claim. It may rest on definitions, proved claims, posed equations and what the notation says of
  its symbols, each taken transitively; of these, few are tried before many, and those that its certificate does not use
  are left out. What it divides by is taken not to vanish. A proof counts only with a point that satisfies all of it.
- Where a symbol was defined several times, or used before it was, a claim may rest on any one of these meanings.
- What is refuted under everything that the page has said is `fails` only if one change makes it a true equation, and
  not an empty one: an equation of free symbols may as well be a condition, and is `open`, with the point at which it
  does not hold. An open equation is assumed in what follows, under its number; for its sake something fails only if it
  is a slip away from what follows from it, and other claims of the page rest on it, too. What is likely a slip is no
  premise. What one section says of a symbol, another may say anew.
- A condition or a law is one because a person says so: it is posed, and what follows rests on it. What is open is
  posed, too, if the sentence that leads to it says that it is a law or a condition.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from dataclasses import replace as with_fields
from functools import cached_property

from chasles.decisions.session import Session
from chasles.pages.attempts import Attempt, Known, all_said, attempts, named, sides_of, ways, with_premises
from chasles.pages.bounded_proofs import posed_on, proof_of, verdict_on
from chasles.pages.consequences import Consequences
from chasles.pages.defining import definition_of, is_new, is_said_ahead, meant_by, said_to_be
from chasles.pages.finding import PageFinding
from chasles.pages.named_hypotheses import as_hypothesis
from chasles.pages.notes import DEFINING, EQUAL, NOTHING, EquationNote, Given, is_defining
from chasles.pages.other_kinds import doubt_of_falsity, doubt_of_reals, doubt_of_truth
from chasles.pages.premises import PosedEquation, Premises, chosen_rules, free_quantities
from chasles.pages.quantities import Quantity, quantities, quantity, symbols_in
from chasles.pages.refutation import expanded, refuted
from chasles.pages.restated import stated_otherwise
from chasles.pages.unsaid_derivatives import UnsaidDerivatives
from chasles.prover.certifying import proved
from chasles.reading.prose import Lead
from chasles.reading.reading import Part, Reading
from chasles.repairs.repair import Repair
from chasles.statements import Claim, Statement, nonzero
from chasles.verdict import Assumed, Contradictory, Defined, Fails, Holds, HoldsUnder, IllFormed, Undecided, Verdict
from chasles.vocabulary import PI, Node, plain, walk
from chasles.vocabulary.families import indices_of

NO_LEAD = Lead()
MOST_CITED = 8
"""So many equations that the prose before one cites are premises together."""
MOST_UNLIKELY = 6
"""So many sets of premises are tried of which a random motion does not tell whether a claim follows from them."""
WORK = 1e6
"""The work that one attempt at a proof may take, in products of terms."""


@dataclass
class Deduction:
    """Decides the equations of a page in the order in which it states them.

    Where what the letters are `is_proposed` only, what does not fit together is open; where it `is_complex`, what is
    found of real numbers alone is in doubt. So many sets of premises from which it is not likely to follow are tried
    for each claim: of another reading none.
    """

    premises: Premises
    session: Session = field(default_factory=lambda: Session(WORK))
    is_proposed: bool = False
    is_complex: bool = False
    may_follow: dict[str, bool | None] = field(default_factory=dict)
    most_unlikely: int = MOST_UNLIKELY
    _foretold: dict[tuple[str, int], PageFinding] = field(default_factory=dict)
    _derivatives: UnsaidDerivatives = field(default_factory=UnsaidDerivatives)
    _said_here: tuple[int, dict[Quantity, Node]] = (0, {})
    _section: str | None = None
    _cited: tuple[Given, ...] = ()

    @cached_property
    def consequences(self) -> Consequences:
        """Tells what may follow from premises."""
        return Consequences(self.premises.facts, self.may_follow)

    def fork(self) -> Deduction:
        """A deduction that goes on from here by itself."""
        other = with_fields(self, premises=self.premises.copy(), most_unlikely=0, _foretold=dict(self._foretold))
        other._derivatives, other._said_here = self._derivatives.copy(), (self._said_here[0], dict(self._said_here[1]))
        other.consequences = self.consequences
        return other

    @contextmanager
    def where(self, number: str, given: Iterable[Part], display: int = 0, section: str | None = None) -> Iterator[None]:
        """What is said within is said for the case that the relations hold; those that are no equations are left.

        What one display says of a symbol in several ways may be cases, too.
        """
        if display != self._said_here[0]:
            self._said_here = display, {}
        if section != self._section:
            self._section = section
            self.premises.begin_section()
        before = len(self.premises.posed)
        for part in given:
            if part.sign == "=" and not part.fault:
                self.premises.posed.append(self._assumption(f"({number}, for)", part))
        added = len(self.premises.posed) - before
        yield
        del self.premises.posed[before : before + added]

    def _as_said(self, claim: Claim) -> Claim:
        """The claim without derivatives of what the page has not said to depend on anything."""
        if claim.fault:
            return claim
        left, right = self._derivatives.without(claim.printed, self.premises.defined())
        return claim if claim.printed == (left, right) else with_fields(claim, left=left, right=right)

    def _assumption(self, name: str, said: Part | Claim) -> PosedEquation:
        """An equation that is assumed, by the name under which it is told."""
        left, right = self._as_said(Claim(name, said.left, said.right, sic=True)).printed
        return PosedEquation(as_hypothesis(name, left, right, self.session, self.consequences), left, right, False)

    def strange(self, reading: Reading) -> int:
        """How many symbols of a reading the page has neither used nor named; the value of a function counts for two."""
        known = (*self.premises.spoken, *self.premises.defined())
        new = symbols_in(reading.sides) - {symbol for symbol, _ in known}
        return len(new) + sum("(" in symbol.letter for symbol in new)

    def assume(self, left: Node, right: Node) -> None:
        """What holds on the whole page: of a symbol alone on a side a rule, of anything else a hypothesis."""
        claim = Claim(f"{plain(left)} = {plain(right)}", left, right, sic=True)
        meant = meant_by(claim, self.premises)
        if meant:
            self._defined(claim, *meant)
        else:
            self.premises.posed.append(self._assumption(claim.number, claim))

    def say_beside(self, claims: Iterable[Claim]) -> None:
        """What is named beside the displays; what has a definition keeps it."""
        for claim in map(self._as_said, claims):
            meant = None if claim.fault else meant_by(claim, self.premises)
            if meant and is_new(claim, meant[0], self.premises):
                self._defined(claim, *meant)

    def say(
        self,
        number: str,
        part: int,
        left: Node,
        sign: str,
        right: Node,
        note: EquationNote = NOTHING,
        ahead: Iterable[Claim] = (),
        lead: Lead = NO_LEAD,
    ) -> PageFinding:
        """The finding on the next equation of the page, which is a premise of what follows.

        What is `ahead` may say what new symbols of a claim are, as behind "where". What neither follows nor fails is
        assumed if the prose that leads to it says so, and open otherwise.
        """
        finding = self._foretold.pop((number, part), None)
        claim = self._as_said(Claim(number, left, right, part=part, sign=sign, sic=True))
        if finding is None:
            told = [each for name in lead.cited for each in self.premises.told.get(name, ())]
            self._cited = tuple((named(each), each) for each in told[:MOST_CITED])
            finding = self._found(claim, note, tuple(ahead), lead)
        is_wrong = claim.fault or finding.instead or (isinstance(finding.verdict, Fails) and not finding.open)
        if sign in EQUAL and not (is_wrong or lead.is_local):
            self.premises.told.setdefault(number, []).append(claim)
        self.premises.spoken.update(q for side in (left, right) for q in quantities(side))
        self.premises.stated.append(claim)
        if self._said_here[0] and (key := quantity(left)) is not None:
            self._said_here[1].setdefault(key, right)
        return finding

    def _found(self, claim: Claim, note: EquationNote, ahead: tuple[Claim, ...], lead: Lead) -> PageFinding:
        role = note.role
        if claim.sign not in ("=", *DEFINING):
            return PageFinding("claim", Undecided(f"relations such as {claim.sign} are not decided"), claim, open=True)
        if claim.fault:
            return PageFinding("claim", IllFormed(claim.fault), claim, open=self.is_proposed)
        if any(part.expands for side in claim.printed for part in walk(side)):
            return expanded(claim, self.premises, self.session)
        if role in ("condition", "law"):
            verdict = self._satisfied(claim)
            is_law = role == "law" and not isinstance(verdict, Contradictory)
            return self._posed(claim, False, Assumed() if is_law else verdict)
        if note.given is not None and role != "definition":
            return self._under(claim, note.given)
        if lead.is_local and not role and not is_defining(claim):
            return PageFinding("condition", Assumed(), claim)
        meant = meant_by(claim, self.premises, note.of) if role != "claim" else None
        if meant and (role == "definition" or self._defines(claim, meant[0], ahead)):
            return self._defined(claim, *meant)
        if role == "definition":
            return with_fields(self._posed(claim, False, Defined()), role=role)
        finding = self._proof(claim)
        key = quantity(claim.left)
        if finding is None:
            before, foretold = self.premises.copy(), len(self._foretold)
            finding = self._proof_ahead(claim, ahead)
        if finding is None:
            new = [each.statement for each in list(self._foretold.values())[foretold:]]
            is_example = any(isinstance(each, Statement) and _is_value(each) for each in new)
            finding = refuted(
                claim,
                before if is_example else self.premises,
                self.session,
                self.consequences,
                (*self.premises.stated_before, *(ahead if new else ())),
                told=role == "claim",
                may_define=meant is not None,
            )
        fails = finding.unless[1] if finding.unless else finding
        if isinstance(fails.verdict, Fails) and not fails.open and isinstance(fails.statement, Claim):
            doubt = self._doubt(fails.statement, fails.instead, is_true=False)
            finding = with_fields(fails, open=True, doubt=doubt) if doubt else finding
        is_case = key is not None and (lead.is_other or self._said_here[1].get(key, claim.right) != claim.right)
        is_false = isinstance(finding.verdict, Fails)
        twin = stated_otherwise(claim, self.premises.stated_before) if finding.open or is_false else None
        if twin or (is_case and is_false):
            made = self._posed_or_defined(claim, meant, with_fields(finding, unless=None))
            against = (named(twin),) if twin and not is_case else ()
            told = with_fields(made, verdict=finding.verdict, open=True, against=against, said_elsewhere=True)
            return told if against else made
        if finding.said_elsewhere and not meant:
            return with_fields(self._posed(claim, True, finding.verdict), instead=finding.instead, said_elsewhere=True)
        if not finding.open or (finding.instead and not finding.verdict.true):
            return finding  # what is likely a slip is no premise of what follows
        if (lead.is_posed or lead.is_case) and not finding.doubt and not is_defining(claim):
            return with_fields(self._posed(claim, lead.is_case, Assumed(), is_rule=True), open=False)
        return self._posed_or_defined(claim, meant, finding)

    def _defines(self, claim: Claim, key: Quantity, ahead: tuple[Claim, ...]) -> bool:
        following = map(self._as_said, ahead)
        return is_new(claim, key, self.premises) and not is_said_ahead(claim, key, following, self.premises)

    def _posed_or_defined(self, claim: Claim, meant: tuple[Quantity, bool] | None, finding: PageFinding) -> PageFinding:
        key = quantity(claim.left)
        before = self.premises.said_before(key) if key and not finding.instead else None
        if key and before and not any(symbol == key[0] for symbol, _ in quantities(claim.right)):
            return with_fields(self._defined(claim, key, False), against=(named(before),))
        if not meant:
            return with_fields(self._posed(claim, True, finding.verdict), doubt=finding.doubt, instead=finding.instead)
        made = self._defined(claim, *meant)
        return with_fields(made, verdict=finding.verdict, doubt=finding.doubt) if finding.doubt else made

    def settled(self, finding: PageFinding | None) -> PageFinding | None:
        """What is found once all of the page is known: what fails under equations on which others rest, too."""
        names, fails = finding.unless if finding and finding.unless else (frozenset(), finding)
        return fails if names <= self.premises.relied else finding

    def _proof_ahead(self, claim: Claim, ahead: tuple[Claim, ...]) -> PageFinding | None:
        """The finding on a claim that follows from what the page defines ahead; what it defines anew counts only so."""
        finding = self._proof(claim) if self._foretell(claim, ahead) else None
        before = self.premises.copy(), dict(self._foretold)
        if finding is None and self._foretell(claim, ahead, anew=True):
            finding = self._proof(claim)
            if finding is None:
                self.premises, self._foretold = before
        return finding

    def _foretell(self, claim: Claim, ahead: tuple[Claim, ...], anew: bool = False) -> bool:
        """Take in advance the definitions of symbols that are new in a claim, or defined `anew`, if there are any."""
        before, found = len(self._foretold), symbols_in(claim.printed)
        new = found - {symbol for symbol, _ in self.premises.spoken}
        for other in map(self._as_said, ahead):
            meant = None if other.fault else meant_by(other, self.premises)
            if meant is None or meant[0][0] not in found or (other.number, other.part) in self._foretold:
                continue
            is_first = meant[0][0] in new and meant[0] not in self.premises.definitions
            if is_defining(other) if anew else is_first:
                self._foretold[other.number, other.part] = self._defined(other, *meant)
        return len(self._foretold) > before

    def _defined(self, claim: Claim, key: Quantity, turned: bool) -> PageFinding:
        made = definition_of(claim, turned)
        known = self.premises.definitions.setdefault(
            key, [None] if any(q[0] == key[0] for q in self.premises.spoken) else []
        )
        known.insert(0, made)
        self.premises.said.append(made)
        self.premises.proved.pop(key, None)
        self.premises.opened.pop(key, None)
        return PageFinding("definition", Defined(), made)

    def _posed(self, claim: Claim, is_open: bool, verdict: Verdict, is_rule: bool = False) -> PageFinding:
        if not any(map(indices_of, claim.printed)):
            said = as_hypothesis(named(claim), *claim.printed, self.session, self.consequences)
            key = said_to_be(claim) if is_open or is_rule else None
            self.premises.unproved.add(named(claim))
            if is_open and _is_value(claim):
                return PageFinding("condition", verdict, claim, open=True)  # that in one case
            if key is not None:
                self.premises.opened[key[0]] = definition_of(claim, key[1])
                self.premises.said.append(self.premises.opened[key[0]])
            self.premises.posed.append(PosedEquation(said, claim.left, claim.right, is_open, key is not None))
        return PageFinding("condition", verdict, claim, open=is_open)

    def _satisfied(self, claim: Claim) -> Verdict:
        """The verdict on a condition: posed if a point satisfies it with all that the page has said of its symbols.

        Where that takes too long, with what the notation says of them.
        """
        said = as_hypothesis(named(claim), *claim.printed, self.session, self.consequences)
        verdict: Verdict = Undecided("no point was looked for")
        for known in (all_said(claim, self.premises, 0), ({}, ())):
            assumed = with_premises(claim, self.premises, *known, everything=True)
            verdict = posed_on(with_fields(assumed, assuming=(*assumed.assuming, said)), self.session)
            if not isinstance(verdict, Undecided):
                break
        return verdict

    def _proof(self, claim: Claim) -> PageFinding | None:
        """The finding on a claim that follows from what the page has said; None for any other."""
        unlikely = 0
        for attempt in attempts(claim, self.premises, self.consequences, self._sets_cited(claim)):
            unlikely += not attempt.likely
            if not attempt.likely and unlikely > self.most_unlikely:
                continue
            verdict = proof_of(attempt.claim, self.session, attempt.likely)
            if verdict is not None:
                verdict = _resting_on(attempt.assumed, verdict)
                self.premises.relied.update(verdict.needs)
                if doubt := self._doubt(attempt.claim):
                    return PageFinding("claim", verdict, attempt.claim, open=True, doubt=doubt)
                return self._proved(attempt.claim, verdict)
        return None

    def _sets_cited(self, claim: Claim) -> Iterator[Known]:
        """What the prose cites: alone, and with what the page says of the symbols in it."""
        if self._cited:
            rules, posed = self._premises_of(self._cited)
            yield chosen_rules(sides_of(claim, posed), rules), posed
            table = {**self.premises.defined(), **self.premises.proved}
            applied = {named(rule) for rule in table.values()}
            others = tuple(self._assumption(*each) for each in self._cited if each[0] not in applied)
            yield chosen_rules(sides_of(claim, others), table), others

    def _premises_of(self, given: Iterable[Given]) -> tuple[dict[Quantity, Statement], tuple[PosedEquation, ...]]:
        """Equations as rules for the symbols that stand alone in them, the first of each; others are assumed."""
        rules: dict[Quantity, Statement] = {}
        posed: list[PosedEquation] = []
        for name, each in ((name, self._as_said(each)) for name, each in given):
            key = said_to_be(each)
            if key is not None and key[0] not in rules:
                rules[key[0]] = definition_of(each, key[1])
            else:
                posed.append(self._assumption(name, each))
        return rules, tuple(posed)

    def _doubt(self, claim: Claim, instead: Repair | None = None, is_true: bool = True) -> str:
        """Under what kinds of letters alone a claim is true, or false; empty where that is not in doubt."""
        if self.is_complex and (doubt := doubt_of_reals(claim)):
            return doubt
        if not self.is_proposed:
            return ""
        known = self.consequences
        return doubt_of_truth(claim, known) if is_true else doubt_of_falsity(claim, instead, known)

    def _under(self, claim: Claim, given: tuple[Given, ...]) -> PageFinding:
        """The finding on a claim under the premises that a person gives, and no others of the page.

        What is proved of what the page does not say is assumed in what follows.
        """
        (rules, posed), told = self._premises_of(given), tuple(name for name, _ in given)
        attempt = with_premises(claim, self.premises, rules, posed)
        likely = self.consequences.may_follow(*claim.printed, rules, posed)
        proved, verdict = attempt, None
        for way in ways(Attempt(attempt, bool(likely)), self.premises, posed) if likely is not False else ():
            proved, verdict = way.claim, proof_of(way.claim, self.session, way.likely)
            if verdict is not None:
                break
        verdict = verdict or verdict_on(attempt, self.session)
        if verdict.true:
            if not {named(each) for each in self.premises.said}.issuperset(told):
                self._posed(claim, False, verdict)
            return with_fields(self._proved(proved, _given_freely(told, verdict)), given=told)
        against = (*(rule.number for rule in rules.values()), *(h.text for h in attempt.assuming))
        is_open = not isinstance(verdict, Fails | Contradictory)
        return PageFinding("claim", verdict, attempt, open=is_open, against=against, given=told)

    def _proved(self, claim: Claim, verdict: Verdict) -> PageFinding:
        unused = verdict.unused
        least = with_fields(claim, assuming=tuple(h for h in claim.assuming if h.text not in unused))
        sides = (*claim.printed, *(side for each in claim.given for side in each.printed))
        verdict = _given_freely((nonzero(PI).text,), verdict) if PI in symbols_in(sides) else verdict
        key = quantity(claim.left)
        behind = free_quantities((claim.right,), chosen_rules((claim.right,), self.premises.defined()))
        if key is not None and not any(symbol == key[0] for symbol, _ in behind):
            # What it was proved under need not be assumed again: a problem with more hypotheses takes more work.
            self.premises.proved[key] = definition_of(least, False)
            self.premises.said.append(self.premises.proved[key])
        return PageFinding("claim", verdict, least)


def _is_value(said: Statement) -> bool:
    """Whether it says what number a letter is, which may be that of a case or an example."""
    letters = [side for side in said.printed if (key := quantity(side)) is not None and not key[1]]
    return len(letters) == 1 and letters[0].is_scalar and len(symbols_in(said.printed)) == 1


def _resting_on(opened: tuple[str, ...], verdict: Verdict) -> Verdict:
    """The verdict with the open equations that it rests on among what it needs."""
    if not opened or not isinstance(verdict, Holds | HoldsUnder):
        return verdict
    return HoldsUnder((*verdict.needs, *opened), verdict.certificate, verdict.witness, verdict.unused)


def _given_freely(given: tuple[str, ...], verdict: Verdict) -> Verdict:
    """The verdict without what a person has given, or what is known of numbers, among what it needs."""
    if not isinstance(verdict, HoldsUnder):
        return verdict
    needs = tuple(need for need in verdict.needs if need not in given)
    return proved(needs, verdict.certificate, verdict.witness, verdict.unused)
