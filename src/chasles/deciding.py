"""The verdict on any problem: by polynomials, or as a question of scalars where functions without such a form occur."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import reduce
from typing import TYPE_CHECKING, Any

from chasles.checker.any_size.at_sizes import sizes_in
from chasles.prover.certifying import proved
from chasles.prover.decide import BUDGET, NO_POINT, decide_problem
from chasles.prover.squares import decide_by_squares
from chasles.statements import Hypothesis, Problem
from chasles.verdict import Contradictory, Counterexample, Fails, Holds, HoldsUnder, Undecided, Verdict

if TYPE_CHECKING:
    from chasles.checker.expressions.scalars import ScalarQuestion


def decided(problem: Problem, own: tuple[Hypothesis, ...] = (), budget: float = BUDGET) -> Verdict:
    """The verdict on a problem; `own` are the hypotheses whose use it reports."""
    if sizes_in(problem):
        from chasles.prover.symbolic import decide_words  # few chapters have letters for sizes

        return decide_words(problem, own)
    if problem.has_functions:
        return decide_by_squares(problem, own) or _by_scalars(problem, own)
    verdict = decide_problem(problem, own, budget)
    ranges = any(h.kind == "inequality" for h in problem.hypotheses)
    if isinstance(verdict, Undecided) and (verdict.without_form or ranges or verdict.reason == NO_POINT):
        again = _by_scalars(problem, own)
        return verdict if isinstance(again, Undecided) else again
    return verdict


def _by_scalars(problem: Problem, own: tuple[Hypothesis, ...]) -> Verdict:
    """The verdict on the question that the problem asks of scalars."""
    # SymPy is loaded where it is needed only.
    from chasles.checker.expressions.scalars import scalar_question
    from chasles.prove import Rejected, Untreatable, prove

    try:
        question = scalar_question(problem)
        verdict = prove(*question.asked)
        asked_whole = False
        if isinstance(verdict, Fails | Undecided):
            whole = scalar_question(problem, proving=False)
            asked_whole = whole.asked != question.asked
            if asked_whole:
                question, verdict = whole, prove(*whole.asked)
    except (Rejected, Untreatable, TypeError) as error:
        return Undecided(str(error))
    match verdict:
        case Fails(found):
            label, entry = question.places[found.entry[0] - 1]
            if question.partial:
                return Undecided("a counterexample was found, which may not satisfy all that is assumed")
            return Fails(Counterexample(found.at, entry, found.left, found.right, label))
        case Contradictory(hypotheses, certificate):
            return Contradictory(tuple(dict.fromkeys(_said(hypotheses, question))), certificate)
        case Holds() | HoldsUnder():
            return _proved(verdict, problem, own, question, asked_whole)
        case _:
            return verdict


def _proved(
    verdict: Holds | HoldsUnder, problem: Problem, own: tuple[Hypothesis, ...], question: ScalarQuestion, whole: bool
) -> Verdict:
    """The proof of the question as one of the problem; that quantities are positive counts among what it needs."""
    certificate = {"scalars": verdict.certificate, "needs": list(verdict.needs), **({"whole": True} if whole else {})}
    certificate["point"] = {name: str(value) for name, value in verdict.witness.items()}
    positive = (h.text for h in problem.hypotheses if h.kind == "positive")
    order = {h.text: place for place, h in enumerate(problem.hypotheses)}
    used = (*positive, *question.used, *_said(verdict.needs, question))
    needs = tuple(sorted(dict.fromkeys(used), key=lambda text: order.get(text, len(order))))
    unused = tuple(h.text for h in own if h.text not in needs)
    return proved(needs, certificate, _at_quantities(verdict.witness, question.values), unused)


def _at_quantities(point: Mapping[str, Any], values: Mapping[Any, Any]) -> dict[str, Any]:
    """A point with the values of quantities in place of those of the symbols by which these were said."""
    shown = dict(point)
    for quantity, value in values.items():
        put = {new: point[str(new)] for new in value.free_symbols if str(new) in point}
        if len(put) == len(value.free_symbols):
            shown = {name: number for name, number in shown.items() if name not in map(str, put)}
            found = value.subs({new: str(number) for new, number in put.items()})
            shown[str(quantity)] = Fraction(int(found.p), int(found.q)) if found.is_Rational else found
    return shown


def _said(texts: tuple[str, ...], question: ScalarQuestion) -> Iterator[str]:
    """Which hypothesis says what SymPy spells; what none says is spelled as in the chapter, conditions are given."""
    from chasles.checker.expressions.scalars import spelled

    free = {quantity: value for quantity, value in question.values.items() if value.free_symbols}
    for text in texts:
        if text in question.sources:
            yield from filter(None, question.sources[text])
        else:
            yield from map(spelled, _of_quantities(text, free) if free else (text,))


def _of_quantities(text: str, values: Mapping[Any, Any]) -> Iterator[str]:
    """What a need says of quantities, where it is not evident; what it says of new symbols, with their meaning."""
    import sympy as sp
    from sympy.core.function import AppliedUndef

    from chasles.checker.expressions.visible import signs_of
    from chasles.checker.expressions.widened import said_need

    text = reduce(lambda text, known: text.replace(str(known[1]), str(known[0])), values.items(), text)
    owners = {new: q for q, value in values.items() for new in value.atoms(AppliedUndef) or value.free_symbols}
    need = said_need(text.replace("(t)", ""), {str(new).split("(")[0]: new for new in owners})
    if need is None or not need[0].has(*owners):
        yield text
        return
    if need[0] in {sp.Add(*(part**2 for part in arc.args)) for arc in sp.Tuple(*values.values()).atoms(sp.atan2)}:
        return  # a direction
    said, relation = need
    for new, quantity in owners.items():
        value = values[quantity]
        for call in value.atoms(sp.asin, sp.atan):
            slope = value.coeff(call)
            if call.args == (new,):
                turn = sp.expand((quantity - value + slope * call) / slope)
                said = said.subs(new, (sp.sin if isinstance(call, sp.asin) else sp.tan)(turn))
        if said.has(new):
            yield f"{quantity} = {value}"
    if relation != ">=" or said.has(*owners) or -1 in signs_of(said):
        yield f"{said} {relation} 0"
