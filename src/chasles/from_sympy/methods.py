"""By which methods is a question decided, and in which order? What the checker does not follow stays undecided.

Where a form changes, it is looked at by itself: where the argument of a sign is zero, or an angle is a half turn.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from functools import partial
from itertools import islice
from typing import Any

import sympy
from sympy import S

from chasles.algebra.work_limit import OutOfTime, remaining
from chasles.checker.expressions.counterexample import check_refutation
from chasles.checker.expressions.induction import at_numbers, check_induction
from chasles.checker.expressions.proof import check_proof
from chasles.checker.sparse import Rejected, well_formed
from chasles.from_sympy.asking import ask
from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.contradiction import contradiction
from chasles.from_sympy.decimals import with_values
from chasles.from_sympy.factors import factors_of
from chasles.from_sympy.induction import by_induction
from chasles.from_sympy.question import Question
from chasles.from_sympy.side_conditions import listed
from chasles.from_sympy.splitting import Splitting
from chasles.points.search import counterexamples_are_told
from chasles.problems.variables import Untreatable
from chasles.prover.decide import decide_problem
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder, Undecided, Verdict

MOST = 4
"""So many forms are looked at, and so many factors of each."""


def _decided_or_by_induction(*asked: Any) -> Verdict:
    """The verdict on the question as it stands; else on sums and products up to a letter, by induction on it."""
    try:
        verdict = _verdict(*asked)
    except Untreatable:
        found = by_induction(asked, _verdict)
        if found is None:
            raise
        return _followed(found, asked)
    found = by_induction(asked, _verdict) if isinstance(verdict, Undecided) else None
    return verdict if found is None else _followed(found, asked)


def _proved_by_cases(*asked: Any) -> Verdict:
    """The verdict if it is proved by cases; nothing is refuted."""
    lhs, rhs, given, nonzero = asked
    splitting = Splitting(lhs, rhs, given, nonzero, _answered)
    return _followed(splitting.verdict(refuting=False), asked) if splitting.possible else Undecided("the shapes differ")


def _verdict(*asked: Any) -> Verdict:
    """The verdict on the question as it stands; else by cases, or on a more general one."""
    lhs, rhs, given, nonzero = asked
    splitting = Splitting(lhs, rhs, given, nonzero, _answered)
    by_cases = _followed(splitting.verdict(), asked) if splitting.wanted else None
    if isinstance(by_cases, Undecided) and (of_nothing := _contradictory(given, nonzero)):
        return of_nothing
    if by_cases is not None and (by_cases.true or isinstance(by_cases, Fails) or not splitting.readable):
        return _also_where_forms_change(by_cases, asked) if isinstance(by_cases, Undecided) else by_cases
    refused = None
    try:
        question = ask(*asked)
        verdict = _followed(_answered(question), asked) if isinstance(question, Question) else question
    except Untreatable as error:
        refused = error
        verdict = Undecided(str(error))
    if by_cases is not None and isinstance(verdict, Contradictory) and not splitting.states(verdict.hypotheses):
        # Of a sign as a quotient it is said that it has no value at zero: by cases it has one.
        verdict = by_cases
    if isinstance(verdict, Undecided) and splitting.possible:
        again = by_cases or _followed(splitting.verdict(), asked)
        verdict = verdict if isinstance(again, Undecided) else again
    if isinstance(verdict, HoldsUnder | Undecided | Contradictory):
        verdict = _also_where_forms_change(verdict, asked)
    if isinstance(verdict, Undecided) and refused is not None:
        raise refused
    return verdict


WAYS = _decided_or_by_induction, _proved_by_cases, _verdict
"""How the first reading of inequalities is decided, the second, and the third."""


def _contradictory(given: Any, nonzero: Any) -> Contradictory | None:
    """Which conditions contradict each other, whatever is claimed; None where they are read by cases themselves."""
    asked = S.Zero, S.Zero, given, nonzero
    with suppress(Untreatable, OutOfTime):
        if not Splitting(*asked, _answered).wanted:
            question = ask(*asked)
            found = contradiction(question) if isinstance(question, Question) else question
            return found if isinstance(found, Contradictory) else None
    return None


def _also_where_forms_change(verdict: Verdict, asked: tuple[Any, ...]) -> Verdict:
    """A counterexample where that vanishes of which a sign is taken: the sign of zero is zero, and no quotient.

    Or the verdict, if there is none; but conditions that may hold there do not contradict each other.
    """
    for there in where_forms_change(*asked):
        found = None
        with suppress(Untreatable, OutOfTime):
            question = ask(*there)
            found = _followed(_answered(question), asked) if isinstance(question, Question) else question
        if isinstance(found, Fails):
            return found
        if isinstance(verdict, Contradictory) and not isinstance(found, Contradictory):
            verdict = Undecided("what is given may hold where an angle is a half turn, or a sign is zero")
    return verdict


def _followed(verdict: Verdict, asked: tuple[Any, ...]) -> Verdict:
    """The verdict, if it needs no proof or the checker follows it: what it does not follow is undecided."""
    try:
        check(verdict, asked)
    except Rejected as reason:
        return Undecided(f"an answer was found that the checker does not follow: {reason}")
    return verdict


def check(verdict: Verdict, asked: tuple[Any, ...]) -> None:
    """Raise `Rejected` for a proof or a counterexample that the checker does not follow."""
    match verdict:
        case Holds() | HoldsUnder():
            if "unread" in verdict.certificate:
                raise Rejected(verdict.certificate["unread"])
            (check_induction if "induction" in verdict.certificate else check_proof)(verdict, *asked)
        case Fails(found):
            with well_formed("counterexample"):
                check_refutation(*at_numbers(found, *asked))


def _answered(question: Question) -> Verdict:
    """The verdict; what algebra leaves open may fail at a point where both sides are bounded."""
    sampling = question.sampling
    found = sampling.counterexample(few=True) if sampling and question.formal else None
    if found:
        return Fails(found)
    verdict = question.answered(_decided(question))
    if sampling and isinstance(verdict, Undecided) and counterexamples_are_told():
        found = sampling.counterexample()
        return Fails(found) if found else verdict
    if sampling and question.formal and isinstance(verdict, Holds | HoldsUnder):
        point = sampling.point()
        if point is None:
            open_ = "it follows from what is given, but no point was found that satisfies all of it"
            return contradiction(question) or Undecided(open_)
        said = {str(name): str(value) for name, value in point.items()}
        named = [name for name in verdict.certificate["witness"] if name.startswith(("cos(", "sin("))]
        more = {"turns": named} if named else {}
        return replace(verdict, certificate={**verdict.certificate, **more, "witness": said}, witness=point)
    return verdict


def _decided(question: Question) -> Verdict:
    """The verdict; where it is open, a variant of the question may do."""
    evident = contradiction(question, effort=0)
    if evident is not None:
        return evident
    try:
        verdict = decide_problem(question.problem, question.own, search=question.search)
    except OutOfTime:
        if remaining() <= 0:
            raise
        return Undecided("it is too large for the work that was allowed")
    if isinstance(verdict, Undecided):
        impossible = contradiction(question)
        if impossible is not None:
            return impossible
        write = question.search.write
        for variant, problem in question.variants():
            blind = replace(question.search, blind=True, write=write and partial(write, variant=variant))
            again = decide_problem(problem, question.own, search=blind)
            if isinstance(again, Holds | HoldsUnder):
                return again
    return verdict


def where_forms_change(lhs: Any, rhs: Any, given: Any, nonzero: Any) -> Iterator[tuple[Any, Any, Any, Any]]:
    """The question where a factor of a sign's argument, or of a difference that is compared, is given to vanish.

    And where an angle is a half turn: half of it has no tangent there by which it could be read.
    """
    conditions = [item for _, item in listed(given, "given")]
    yield from _half_turns((lhs, rhs), conditions, nonzero)
    parts = {part for e in expressions_in((lhs, rhs)) for part in e.atoms(sympy.sign, sympy.Eq, sympy.Ne)}
    for part in sorted(parts, key=str)[:MOST]:
        sides = with_values((lhs, rhs), {part: part.func(*(0 for _ in part.args))})
        difference = part.args[0] if isinstance(part, sympy.sign) else part.lhs - part.rhs
        factors = (factor for factor, power, _ in factors_of(difference) if power.is_positive and factor.free_symbols)
        for factor in islice(factors, MOST):
            yield (*sides, [*conditions, sympy.Eq(factor, 0, evaluate=False)], nonzero)


def _half_turns(sides: tuple[Any, Any], conditions: list[Any], nonzero: Any) -> Iterator[tuple[Any, Any, Any, Any]]:
    parts = {part for e in expressions_in(sides) for part in e.atoms(sympy.atan2, sympy.arg)}
    for part in sorted(parts, key=str)[:MOST]:
        y, x = part.args if isinstance(part, sympy.atan2) else (sympy.im(part.args[0]), sympy.re(part.args[0]))
        behind = [sympy.Eq(y, 0, evaluate=False), sympy.Eq(sympy.Abs(x), -x, evaluate=False)]
        apart = [*(item for _, item in listed(nonzero, "nonzero")), x]
        yield (*with_values(sides, {part: sympy.pi}), [*conditions, *behind], apart)
