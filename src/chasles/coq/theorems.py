"""What is said in Coq of each decision: a statement with its proof, or why there is none."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from chasles import vocabulary as w
from chasles.coq.expressions import Spelling, Unsaid
from chasles.coq.names import CoqNames
from chasles.coq.points import existence, refutation
from chasles.coq.proof import proof_of
from chasles.coq.quantifiers import cover_and_proof, theorem_and_proof
from chasles.coq.sentences import Claimed, failing, holding, satisfiable
from chasles.coq.statement import CoqStatement, opened
from chasles.decisions.decision import HOW, Decision, Sentence, key_of
from chasles.statements import Inverse, Problem, Statement, Theorem
from chasles.statements.inversion import COVER, problems_of_inverse
from chasles.statements.premises import IN_FULL
from chasles.verdict import Contradictory, Counterexample, Fails, HoldsUnder, IllFormed, Verdict
from chasles.vocabulary.dimension import NO_DIMENSION
from chasles.vocabulary.measure import Misfit, uniform

ENDINGS = {"printed": "", "reading": "_as_read", "repair": "_repaired", "corrected": "_corrected"}


def claims_of(decisions: Iterable[Decision]) -> Iterator[Claimed]:
    """What is claimed by the decisions, in their order; names are unique."""
    taken: set[str] = set()
    for decision in decisions:
        for form, verdict, sentence in _forms(decision):
            yield from _claims(decision, form, verdict, sentence, taken)


def _forms(decision: Decision) -> Iterator[tuple[str, Verdict, Sentence]]:
    """The sentence as printed, and each other form that was decided."""
    sentence = decision.statement
    yield "printed", decision.verdict, sentence
    if decision.correction is not None and not isinstance(sentence, Theorem | Inverse):
        for each in (decision.correction, *decision.correction.others):
            yield each.form, each.verdict, sentence.saying(*each.sides)


def _claims(decision: Decision, form: str, verdict: Verdict, sentence: Sentence, taken: set[str]) -> Iterator[Claimed]:
    certificate: Mapping[str, Any] | None = getattr(verdict, "certificate", None)
    key = key_of(decision.statement)
    stem = named(key) + ENDINGS[form]
    if isinstance(verdict, IllFormed) and isinstance(sentence, Statement):
        yield _misfit(key, form, _fresh(stem, taken), sentence)
    elif isinstance(verdict, Fails) and not isinstance(sentence, Inverse):
        name = _fresh(f"{stem}_fails", taken)
        problem = decision.problem(sentence, True)
        claim = Claimed(key, f"{HOW[form]}, which fails", name, sentence.says, whole=not isinstance(sentence, Theorem))
        yield _failing(claim, problem, verdict.counterexample)
    elif isinstance(verdict, Fails | IllFormed | Contradictory):
        fault = {"fails": "fails", "ill-formed": "does not fit together"}.get(verdict.name, "is contradictory")
        why_not = f"no theorem says yet that it {fault}"
        yield Claimed(key, HOW[form], _fresh(stem, taken), sentence.says, why_not=why_not)
    elif certificate is None:
        return
    elif isinstance(sentence, Inverse):
        for count, (says, problem) in enumerate(problems_of_inverse(sentence, decision.accepted)):
            claim = Claimed(key, HOW[form], _fresh(f"{stem}_case_{count + 1}", taken), says)
            first, *others = _claimed(claim, problem, certificate["branches"][says])
            if says == COVER:
                first = _said_by(first, cover_and_proof, problem, certificate["branches"][says])
            yield from (first, *others)
    else:
        problem = decision.problem(sentence, IN_FULL in certificate)
        claim = Claimed(key, HOW[form], _fresh(stem, taken), sentence.says)
        if isinstance(sentence, Theorem):
            yield from _theorem(claim, sentence, problem, certificate)
        else:
            yield from _claimed(claim, problem, certificate)


def _failing(claim: Claimed, problem: Problem, found: Counterexample) -> Claimed:
    """That a statement fails; entry by entry where it has functions."""
    if not any(part.has_no_polynomial_form for side in problem.sides for part in w.walk(side)):
        return _written(claim, problem, failing, lambda said: refutation(claim.name, said, found))
    from chasles.checker.expressions.scalars import scalar_question  # loads SymPy
    from chasles.coq.scalar_points import as_refutation

    asked = scalar_question(problem, proving=False)
    shown = as_refutation(found, asked.left, asked.right, asked.given, asked.nonzero, name=claim.name)
    return replace(claim, said=shown.said, proof=shown.proof, why_not=shown.why_not)


def _claimed(claim: Claimed, problem: Problem, certificate: Mapping[str, Any]) -> Iterator[Claimed]:
    """The statement, entry by entry where it has functions, and that there is what satisfies all that it assumes."""
    if {"scalars", "squares"} & certificate.keys():
        from chasles.checker.expressions.scalars import scalar_question  # loads SymPy
        from chasles.coq.identities import as_theorem
        from chasles.prove import prove

        question = scalar_question(problem, proving=not certificate.get("whole"))
        if "scalars" in certificate:
            verdict: Verdict = HoldsUnder(tuple(certificate["needs"]), certificate["scalars"], {})
        else:
            verdict = prove(*question.asked)
        if not verdict.true:
            yield replace(claim, why_not="no proof is written of what is shown by such squares")
            return
        sides = question.left, question.right
        found = as_theorem(verdict, *sides, question.given, question.nonzero, name=claim.name)
        yield replace(claim, said=found.said, proof=found.proof, why_not=found.why_not)
        return
    yield _written(claim, problem, holding, lambda said: proof_of(claim.name, said, certificate))
    if "witness" not in certificate:  # of scalars or matrices of any size, which Coq is not told of
        return
    found = replace(claim, name=f"{claim.name}_assumes", form=f"what it assumes, {claim.form}", is_witness=True)
    witness = _written(found, problem, satisfiable, lambda said: existence(found.name, said, certificate["witness"]))
    if witness.proof:
        yield witness


def _theorem(claim: Claimed, sentence: Theorem, problem: Problem, certificate: Mapping[str, Any]) -> Iterator[Claimed]:
    """What a theorem says; of forms for which there are no words, the equations."""
    first, *others = _claimed(claim, problem, certificate)
    yield _said_by(first, partial(theorem_and_proof, sentence=sentence), problem, certificate)
    yield from others


def _said_by(
    claim: Claimed, says: Callable[..., tuple[str, str]], problem: Problem, certificate: Mapping[str, Any]
) -> Claimed:
    """A claim as it is said with its quantifiers; if there are no words for it, as its equations."""
    try:
        text, proof = says(claim.name, said=CoqStatement(problem), certificate=certificate)
        return replace(claim, said=text, proof=proof, why_not="")
    except Unsaid:
        return replace(claim, whole=False)


def _written(
    claim: Claimed, problem: Problem, sentence: Callable[[str, CoqStatement], str], proof: Callable[[CoqStatement], str]
) -> Claimed:
    """A claim with its statement and its proof, or why there is none."""
    try:
        said = CoqStatement(problem)
        claim = replace(claim, said=sentence(claim.name, said))
        return replace(claim, proof=proof(said))
    except Unsaid as reason:
        return replace(claim, why_not=str(reason))


def _misfit(key: str, form: str, name: str, statement: Statement) -> Claimed:
    proof, why_not = "", ""
    try:
        proof = misfit(name, statement)
    except Unsaid as reason:
        why_not = str(reason)
    said = f"(* It is no statement: {name} is refused. *)\n"
    return Claimed(key, HOW[form], name, statement.says, said, proof, why_not, is_misfit=True)


def named(key: str) -> str:
    """A number and part as a name for Coq: eq_3_97a_1."""
    plain = re.sub(r"\W+", "_", key, flags=re.ASCII).strip("_")
    return f"eq_{plain}" if plain[:1].isdigit() else plain


def _fresh(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_"
    taken.add(name)
    return name


def misfit(name: str, statement: Statement) -> str:
    """A command that succeeds if the equation, at one instant, is no statement. Raises `Unsaid` if its sizes fit."""
    left, right = statement.printed
    if _sizes_fit(statement):
        raise Unsaid("its sizes fit together, and Coq is told neither of dimensions nor of divisors")
    names = CoqNames()
    sizes: dict[str, str] = {}

    def applied(node: w.Node, name: str) -> str:
        sizes[name] = "R" if node.is_scalar else f"M {node.shape[0]} {node.shape[1]}"
        return name

    for node in (part for side in (left, right) for part in opened(side)):
        if isinstance(node, w.Symbol):
            names.symbol(node)
    equation = Spelling(names, applied).equation(left, right)
    bound = " ".join(f"({each} : {size})" for each, size in sizes.items())
    return f"Fail Definition {name} : Prop :=\n  forall {bound},\n  {equation}.\n"


def _sizes_fit(statement: Statement) -> bool:
    """Whether the statement is a good one if nothing has a dimension."""
    symbols = {part for side in statement.printed for part in opened(side) if isinstance(part, w.Symbol)}
    bare: dict[w.Node, w.Node] = {
        each: w.Symbol(each.name, each.name, uniform(each.shape, NO_DIMENSION), home=__name__, has_units=False)
        for each in symbols
    }
    try:
        left, right = (w.replace(side, bare) for side in statement.printed)
        return not replace(statement, left=left, right=right, kernel=None, reading=None, corrected=None, sic=True).fault
    except Misfit:
        return False
