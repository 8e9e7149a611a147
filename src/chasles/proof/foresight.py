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
    memory = judge.memory
    asked = {s: {memory.key_of_verdict(*question): question for question in _questions(s)} for s in sentences}
    questions = {
        key: question
        for of_sentence in asked.values()
        for key, question in of_sentence.items()
        if memory.recalled(key) is None
    }

    def verdict_on(question: Question) -> Verdict:
        return judge.verdict_on(*question)

    for key, verdict in zip(questions, spread(verdict_on, list(questions.values()), A_VERDICT), strict=True):
        memory.remember(key, verdict)
    if not judge.searches:
        return

    def repairs_of(statement: Statement) -> tuple[str, tuple[Repair, ...]] | None:
        try:
            return judge.search(statement)
        except TypeError:
            return None

    wrong = [
        sentence
        for sentence, keys in asked.items()
        if isinstance(sentence, Statement)
        and (sentence.fault or any(isinstance(memory.recalled(key), Fails) for key in keys))
    ]
    for found in spread(repairs_of, wrong, A_REPAIR):
        if found is not None:
            memory.remember(*found)


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
