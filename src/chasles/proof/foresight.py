"""Many statements at once: what can be decided without waiting for another verdict is decided over processes first.

Only the memory of the judge is filled: what it decides afterwards, one by one, is the same as without.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from chasles.proof.decision import Sentence
from chasles.proof.judge import Judge
from chasles.proof.repair import Repair
from chasles.proof.spreading import spread
from chasles.proof.verdict import Fails, Verdict
from chasles.statements import Claim, Condition, Hypothesis, Inverse, Problem, Statement, Theorem, problem_of
from chasles.statements.inversion import problems_of_inverse
from chasles.vocabulary import Misfit

__all__ = ["foresee"]

Question = tuple[Problem, tuple[Hypothesis, ...]]
A_VERDICT, A_REPAIR = 0.004, 0.06
"""About how many seconds each takes."""


def foresee(judge: Judge, sentences: Iterable[Sentence]) -> None:
    """Let the judge remember the verdicts on these sentences, and the repairs of those that do not stand."""
    listed = list(sentences)
    questions = {
        key: question
        for sentence in listed
        for question in _questions(sentence)
        if judge.memory.recalled(key := judge.memory.key_of_verdict(*question)) is None
    }

    def verdict_on(question: Question) -> Verdict:
        return judge.verdict_on(*question)

    for key, verdict in zip(questions, spread(verdict_on, list(questions.values()), A_VERDICT), strict=True):
        judge.memory.remember(key, verdict)
    if not judge.searches:
        return

    def repairs_of(statement: Statement) -> tuple[str, tuple[Repair, ...]] | None:
        try:
            return judge.search(statement)
        except TypeError:
            return None

    wrong = [each for each in listed if isinstance(each, Statement) and _is_wrong(judge, each)]
    for found in spread(repairs_of, wrong, A_REPAIR):
        if found is not None:
            judge.memory.remember(*found)


def _is_wrong(judge: Judge, statement: Statement) -> bool:
    """Whether the print does not fit together, or is known to fail."""
    asked = [judge.memory.recalled(judge.memory.key_of_verdict(*question)) for question in _questions(statement)]
    return bool(statement.fault) or any(isinstance(verdict, Fails) for verdict in asked)


def _questions(sentence: Sentence) -> Iterator[Question]:
    """What is decided of a sentence, if all that is given to it stands as declared."""
    try:
        match sentence:
            case Inverse():
                yield from ((problem, ()) for _, problem in problems_of_inverse(sentence))
            case Claim() | Theorem():
                yield problem_of(sentence), sentence.assuming
            case Condition() if not sentence.on or sentence.solution is not None:
                yield problem_of(sentence), sentence.assuming
    except (Misfit, TypeError):
        return
