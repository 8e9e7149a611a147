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
from copy import copy
from dataclasses import replace

from chasles.decisions.session import Session
from chasles.pages.attempts import named
from chasles.pages.consequences import Consequences
from chasles.pages.defining import is_new, is_said_ahead, meant_by
from chasles.pages.finding import PageFinding
from chasles.pages.notes import DEFINING, EQUAL, NOTHING, EquationNote, Given, is_defining
from chasles.pages.premises import Premises
from chasles.pages.proving import Proving
from chasles.pages.quantities import Quantity, quantities, quantity, symbols_in
from chasles.pages.refutation import expanded, refuted
from chasles.pages.restated import stated_otherwise
from chasles.pages.stating import Stating, is_value
from chasles.reading.prose import Lead
from chasles.reading.reading import Part, Reading
from chasles.statements import Claim, Statement
from chasles.verdict import Assumed, Contradictory, Defined, Fails, IllFormed, Undecided
from chasles.vocabulary import Node, plain, walk

NO_LEAD = Lead()
MOST_CITED = 8
"""So many equations that the prose before one cites are premises together."""
MOST_UNLIKELY = 6
"""So many sets of premises are tried of which a random motion does not tell whether a claim follows from them."""
WORK = 1e6
"""The work that one attempt at a proof may take, in products of terms."""


class Deduction:
    """Decides the equations of a page in the order in which it states them.

    Where what the letters are `is_proposed` only, what does not fit together is open; where it `is_complex`, what is
    found of real numbers alone is in doubt. `may_follow` keeps what is found of premises.
    """

    def __init__(
        self,
        premises: Premises,
        session: Session | None = None,
        is_proposed: bool = False,
        is_complex: bool = False,
        may_follow: dict[str, bool | None] | None = None,
    ) -> None:
        consequences = Consequences(premises.facts, {} if may_follow is None else may_follow)
        self.stating = Stating(premises, session or Session(WORK), consequences)
        self.proving = Proving(self.stating, is_proposed, is_complex, MOST_UNLIKELY)
        self._foretold: dict[tuple[str, int], PageFinding] = {}
        self._said_here: tuple[int, dict[Quantity, Node]] = (0, {})
        self._section: str | None = None
        self._cited: tuple[Given, ...] = ()

    @property
    def premises(self) -> Premises:
        """What the page has said."""
        return self.stating.premises

    def fork(self) -> Deduction:
        """A deduction that goes on from here by itself, and tries nothing that is not likely."""
        other = copy(self)
        other.stating = self.stating.copy()
        other.proving = replace(self.proving, stating=other.stating, most_unlikely=0)
        other._foretold, other._said_here = dict(self._foretold), (self._said_here[0], dict(self._said_here[1]))
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
                self.premises.posed.append(self.stating.assumption(f"({number}, for)", part))
        added = len(self.premises.posed) - before
        yield
        del self.premises.posed[before : before + added]

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
            self.stating.defined(claim, *meant)
        else:
            self.premises.posed.append(self.stating.assumption(claim.number, claim))

    def say_beside(self, claims: Iterable[Claim]) -> None:
        """What is named beside the displays; what has a definition keeps it."""
        for claim in map(self.stating.as_said, claims):
            meant = None if claim.fault else meant_by(claim, self.premises)
            if meant and is_new(claim, meant[0], self.premises):
                self.stating.defined(claim, *meant)

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
        claim = self.stating.as_said(Claim(number, left, right, part=part, sign=sign, sic=True))
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
            return PageFinding("claim", IllFormed(claim.fault), claim, open=self.proving.is_proposed)
        if any(part.expands for side in claim.printed for part in walk(side)):
            return expanded(claim, self.premises, self.stating.session)
        if role in ("condition", "law"):
            verdict = self.stating.satisfied(claim)
            is_law = role == "law" and not isinstance(verdict, Contradictory)
            return self.stating.posed(claim, False, Assumed() if is_law else verdict)
        if note.given is not None and role != "definition":
            return self.proving.under(claim, note.given)
        if lead.is_local and not role and not is_defining(claim):
            return PageFinding("condition", Assumed(), claim)
        meant = meant_by(claim, self.premises, note.of) if role != "claim" else None
        if meant and (role == "definition" or self._defines(claim, meant[0], ahead)):
            return self.stating.defined(claim, *meant)
        if role == "definition":
            return replace(self.stating.posed(claim, False, Defined()), role=role)
        finding = self.proving.proof(claim, self._cited) or self._refuted(claim, ahead, role, meant is not None)
        return self._taken(claim, meant, self._doubted(finding), lead)

    def _refuted(self, claim: Claim, ahead: tuple[Claim, ...], role: str, may_define: bool) -> PageFinding:
        """The finding on a claim that does not follow from what the page has said; it may from what is said ahead."""
        before, foretold = self.premises.copy(), len(self._foretold)
        if found := self._proof_ahead(claim, ahead):
            return found
        new = [each.statement for each in list(self._foretold.values())[foretold:]]
        is_example = any(isinstance(each, Statement) and is_value(each) for each in new)
        return refuted(
            claim,
            before if is_example else self.premises,
            self.stating.session,
            self.stating.consequences,
            (*self.premises.stated_before, *(ahead if new else ())),
            told=role == "claim",
            may_define=may_define,
        )

    def _doubted(self, finding: PageFinding) -> PageFinding:
        """The finding, open if what fails may be true of letters of other kinds."""
        fails = finding.unless[1] if finding.unless else finding
        if isinstance(fails.verdict, Fails) and not fails.open and isinstance(fails.statement, Claim):
            doubt = self.proving.doubt(fails.statement, fails.instead, is_true=False)
            return replace(fails, open=True, doubt=doubt) if doubt else finding
        return finding

    def _taken(
        self, claim: Claim, meant: tuple[Quantity, bool] | None, finding: PageFinding, lead: Lead
    ) -> PageFinding:
        """The finding on a claim, taken as a premise of what follows as far as it is open."""
        key = quantity(claim.left)
        is_case = key is not None and (lead.is_other or self._said_here[1].get(key, claim.right) != claim.right)
        is_false = isinstance(finding.verdict, Fails)
        twin = stated_otherwise(claim, self.premises.stated_before) if finding.open or is_false else None
        if twin or (is_case and is_false):
            made = self._posed_or_defined(claim, meant, replace(finding, unless=None))
            against = (named(twin),) if twin and not is_case else ()
            told = replace(made, verdict=finding.verdict, open=True, against=against, said_elsewhere=True)
            return told if against else made
        if finding.said_elsewhere and not meant:
            posed = self.stating.posed(claim, True, finding.verdict)
            return replace(posed, instead=finding.instead, said_elsewhere=True)
        if not finding.open or (finding.instead and not finding.verdict.true):
            return finding  # what is likely a slip is no premise of what follows
        if (lead.is_posed or lead.is_case) and not finding.doubt and not is_defining(claim):
            return replace(self.stating.posed(claim, lead.is_case, Assumed(), is_rule=True), open=False)
        return self._posed_or_defined(claim, meant, finding)

    def _defines(self, claim: Claim, key: Quantity, ahead: tuple[Claim, ...]) -> bool:
        following = map(self.stating.as_said, ahead)
        return is_new(claim, key, self.premises) and not is_said_ahead(claim, key, following, self.premises)

    def _posed_or_defined(self, claim: Claim, meant: tuple[Quantity, bool] | None, finding: PageFinding) -> PageFinding:
        key = quantity(claim.left)
        before = self.premises.said_before(key) if key and not finding.instead else None
        if key and before and not any(symbol == key[0] for symbol, _ in quantities(claim.right)):
            return replace(self.stating.defined(claim, key, False), against=(named(before),))
        if not meant:
            return replace(
                self.stating.posed(claim, True, finding.verdict), doubt=finding.doubt, instead=finding.instead
            )
        made = self.stating.defined(claim, *meant)
        return replace(made, verdict=finding.verdict, doubt=finding.doubt) if finding.doubt else made

    def settled(self, finding: PageFinding | None) -> PageFinding | None:
        """What is found once all of the page is known: what fails under equations on which others rest, too."""
        names, fails = finding.unless if finding and finding.unless else (frozenset(), finding)
        return fails if names <= self.premises.relied else finding

    def _proof_ahead(self, claim: Claim, ahead: tuple[Claim, ...]) -> PageFinding | None:
        """The finding on a claim that follows from what the page defines ahead; what it defines anew counts only so."""
        finding = self.proving.proof(claim, self._cited) if self._foretell(claim, ahead) else None
        before = self.premises.copy(), dict(self._foretold)
        if finding is None and self._foretell(claim, ahead, anew=True):
            finding = self.proving.proof(claim, self._cited)
            if finding is None:
                self.stating.premises, self._foretold = before
        return finding

    def _foretell(self, claim: Claim, ahead: tuple[Claim, ...], anew: bool = False) -> bool:
        """Take in advance the definitions of symbols that are new in a claim, or defined `anew`, if there are any."""
        before, found = len(self._foretold), symbols_in(claim.printed)
        new = found - {symbol for symbol, _ in self.premises.spoken}
        for other in map(self.stating.as_said, ahead):
            meant = None if other.fault else meant_by(other, self.premises)
            if meant is None or meant[0][0] not in found or (other.number, other.part) in self._foretold:
                continue
            is_first = meant[0][0] in new and meant[0] not in self.premises.definitions
            if is_defining(other) if anew else is_first:
                self._foretold[other.number, other.part] = self.stating.defined(other, *meant)
        return len(self._foretold) > before
