"""A question proved as asked, or by a more general one, which the certificate then states and proves."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.proof import check_part
from chasles.checker.sparse import Rejected, well_formed
from chasles.from_sympy.asking import ask
from chasles.from_sympy.general import General, relations
from chasles.from_sympy.question import Question
from chasles.problems.variables import Untreatable
from chasles.verdict import Holds, HoldsUnder, Verdict

Decide = Callable[[Question], Verdict]


@dataclass(frozen=True, slots=True)
class Proved:
    """The certificate of a question, and what it needs besides what is given."""

    certificate: Mapping[str, Any]
    needs: tuple[str, ...]


def generalised(
    left: Sequence[Any], right: Sequence[Any], given: Sequence[tuple[Any, Any]], nonzero: Sequence[Any], decide: Decide
) -> Proved | None:
    """What proves that the left entries are the right ones; None if it is not proved.

    What a symbol stands for is a further entry of both sides, so that it is seen where it is defined.
    """
    try:
        return _proved(left, right, given, nonzero, decide)
    except Rejected as error:
        raise Untreatable(str(error)) from None


def _proved(
    left: Sequence[Any], right: Sequence[Any], given: Sequence[tuple[Any, Any]], nonzero: Sequence[Any], decide: Decide
) -> Proved | None:
    general = General((*left, *right, *(side for pair in given for side in pair), *nonzero))
    sides = [list(map(general, side)) for side in (left, right)]
    equations = [sympy.Eq(general(one), general(other), evaluate=False) for one, other in given]
    declared = list(map(general, nonzero))
    met: list[Any] = []
    while len(met) < len(general.met):
        met.append(general(general.met[len(met)]))
    if met and any(side.has(AppliedUndef) for pair in given for side in pair):
        return None
    equal = _equal(general, given, nonzero, decide)
    put = {symbol: multiple * other for symbol, multiple, other, _ in equal}
    columns = [sympy.Matrix([*side, *met]).xreplace(put) for side in sides]
    equations, declared = ([e.xreplace(put) for e in said] for said in (equations, declared))
    facts = [*general.facts]
    while True:
        vanishing = [*general.roots, *((fact, sympy.S.Zero) for fact in facts)]
        known = [*equations, *(sympy.Eq(one, other, evaluate=False) for one, other in vanishing)]
        question = ask(columns[0], columns[1], known, declared)
        if not isinstance(question, Question):
            return None
        more = relations(question, general.meanings) if len(facts) == len(general.facts) else []
        if not more:
            break
        facts += [general(fact.xreplace(general.meanings)) for fact in more]
    question.sampling = None
    question.search.blind = question.search.unseen = True
    verdict = decide(question)
    if not isinstance(verdict, Holds | HoldsUnder) or "unread" in verdict.certificate:
        return None
    try:
        with well_formed("certificate"):
            check_part(verdict.certificate, verdict.needs, (*columns, known, declared))
    except Rejected:
        return None
    said = {text for item in question.sources.values() for text in item} | {f"{e.lhs} = {e.rhs}" for e in known}
    needs = tuple(text for text in verdict.needs if text not in said)
    certificate: dict[str, Any] = {"proof": verdict.certificate, "needs": list(verdict.needs)}
    if general.meanings or facts:
        certificate |= {"parts": general.parts, "facts": [str(fact.xreplace(general.meanings)) for fact in facts]}
    if equal:
        certificate["equal"] = [[str(a), str(q), str(b), proved.certificate] for a, q, b, proved in equal]
    return Proved(certificate, (*needs, *(text for *_, proved in equal for text in proved.needs)))


def _equal(
    general: General, given: Sequence[tuple[Any, Any]], nonzero: Sequence[Any], decide: Decide
) -> list[tuple[Any, Any, Any, Proved]]:
    """Symbols, each with a multiple of another one that it is, and the proof that what they stand for is equal."""
    found = []
    for symbol, multiple, other in general.alike():
        sides = [general.meanings[symbol]], [multiple * general.meanings[other]]
        if proved := generalised(*sides, given, nonzero, decide):
            found.append((symbol, multiple, other, proved))
    return found
