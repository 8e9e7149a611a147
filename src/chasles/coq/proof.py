"""The proof of a statement, from the certificate of its verdict. Nothing here has to be believed: Coq checks it.

First what moves is replaced by what it is at one instant, rates by the rules of differentiation; then definitions are
put in and matrices taken apart; then every entry is a combination of what vanishes, with the cofactors of the division.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from chasles import vocabulary as w
from chasles.checker.sparse import Rejected
from chasles.coq.cofactors import Combination, Reckoning
from chasles.coq.expressions import Unsaid
from chasles.coq.facts import KnownFacts
from chasles.coq.motion import Instant
from chasles.coq.polynomials import Polynomials, taken_apart
from chasles.coq.sources import ProofReading
from chasles.coq.statement import CoqStatement
from chasles.statements import Problem
from chasles.statements.spins import with_spins


def proof_of(name: str, said: CoqStatement, certificate: Mapping[str, Any]) -> str:
    """The theorem that a statement, written under its name, holds. Raises `Unsaid` where no proof is known."""
    return theorem(name, steps_of(said, certificate))


def theorem(name: str, steps: Iterable[str]) -> str:
    """The theorem that what is defined under a name holds, by these steps."""
    lines = "\n".join(f"  {step}" for step in (f"unfold {name}.", *steps))
    return f"Theorem {name}_holds : {name}.\nProof.\n{lines}\nQed.\n"


def steps_of(said: CoqStatement, certificate: Mapping[str, Any]) -> list[str]:
    """The steps that show a statement."""
    if other := {"scalars", "words", "squares", "freed"} & certificate.keys():
        raise Unsaid(f"a certificate of {', '.join(sorted(other))}")
    try:
        problem = with_spins(said.problem) if certificate.get("spins") else said.problem
        return list(_Proof(said, problem, certificate).steps())
    except Rejected as error:
        raise Unsaid(str(error)) from error


class _Proof:
    def __init__(self, said: CoqStatement, problem: Problem, certificate: Mapping[str, Any]) -> None:
        self.said = said
        self.reading = ProofReading(problem, certificate["witness"], said.nodes)
        self.spell = Polynomials(said, self.reading)
        sources = self.reading.sources(_labels(certificate))
        self.reckoning = Reckoning(self.reading, certificate)
        self.combinations = [
            list(self.reckoning.goal(count, goal.left, goal.right)) for count, goal in enumerate(said.problem.goals)
        ]
        used = [sources[label] for label in self._labels() if label in sources]
        self.instant = Instant(said, problem, self.spell, used)
        self.facts = KnownFacts(said, self.spell, self.instant, sources)

    def _labels(self) -> list[str]:
        """All that is used of what vanishes."""
        found = [each for goal in self.combinations for each in goal] + [each.why for each in self.reckoning.solved]
        return list(dict.fromkeys(label for each in found for label, _ in each.cofactors))

    def steps(self) -> Iterator[str]:
        """All steps."""
        said = self.said
        if said.timed:
            yield "unfold during."
        yield from self.instant.steps()
        yield from self._named_words()
        if premises := [*self.facts.names_of_words, *self.instant.premises]:
            yield f"intros {' '.join(premises)}."
        yield from self._apart()
        yield from self._definitions_put_in()
        yield from self.facts.of_norms()
        yield from self.facts.of_angles()
        yield from self.facts.of_integrals(divided=False)
        yield from self.facts.nonzero()
        yield from self.facts.of_integrals(divided=True)
        if self.reading.keeps_squares:
            yield from self.facts.of_squares()
        yield from self.facts.vanishing(self._labels())
        for each in self.reckoning.solved:
            value = self.spell(each.numerator)
            below = self.spell.product(each.below)
            claim = f"{self.spell.variable(each.place)} = {value}" + (f" / ({below})" if below else "")
            yield f"assert (value'{each.place} : {claim}) by ({self._shown(each.why)})."
        yield from self._goals()

    def _named_words(self) -> Iterator[str]:
        """Norms, cosines and integrals as numbers of their own, before anything is put into them."""
        nodes = self.said.nodes
        yield from self.facts.named_integrals()
        norms = dict.fromkeys(node for node in nodes if isinstance(node, w.Norm))
        for node in sorted(norms, key=lambda norm: -sum(1 for _ in w.walk(norm))):  # a norm in a norm comes later
            if not any(self.said.runs(part) for part in w.walk(node)):
                yield from self.facts.named_norm(node)
        yield from self.facts.named_angles()

    def _definitions_put_in(self) -> Iterator[str]:
        for node, name in self.instant.defined.items():
            if node in self.instant.integrals:
                continue
            if self.said.runs(node):
                yield f"apply functional_extensionality in def'{name}."
            yield f"subst {name}."

    def _apart(self) -> Iterator[str]:
        """Matrices taken apart into entries."""
        for name, node in self.instant.free.items():
            if node.shape == (1, 1):
                continue
            if self.said.runs(node):
                yield f"destruct (in_elements {name}) as [{name}_ ?]; subst {name}."
            else:
                yield taken_apart(name, node.shape)

    def _goals(self) -> Iterator[str]:
        values = "".join(f" rewrite ?value'{each.place};" for each in self.reckoning.solved)
        several = len(self.combinations) > 1
        if several:
            yield "repeat apply conj."
        for goal, entries in zip(self.said.problem.goals, self.combinations, strict=True):
            yield from ["-"] * several
            if not (goal.left.is_scalar and goal.right.is_scalar):
                yield "each_entry."
            for each in entries:
                yield f"{'+ ' if len(entries) > 1 else ''}words;{values} {self._shown(each)}."

    def _shown(self, why: Combination) -> str:
        """That two numbers are equal."""
        products = [f"{self.spell(cofactor)} * {self.facts.polynomial(label)}" for label, cofactor in why.cofactors]
        total = " + ".join(products) or "0"
        if below := self.spell.product(why.powers):
            return f"apply (by_multiple ({below}) _ _ ({total})); [not_zero | vanish | identity]"
        return f"apply (by_parts _ _ ({total})); [vanish | identity]" if products else "identity"


def _labels(certificate: Mapping[str, Any]) -> list[str]:
    """All that a certificate says vanishes."""
    combined = (*certificate.get("solved", {}).values(), *certificate.get("entries", {}).values())
    divided = [label for label, _ in certificate.get("division", ())]
    return list(dict.fromkeys((*divided, *(label for said in combined for label in said.get("cofactors", {})))))
