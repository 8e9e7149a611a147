"""Many statements at once: what can be decided without waiting for another verdict is decided over processes first.

Only the memory of the session is filled: what it decides afterwards, one by one, is the same as without.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import chain
from time import perf_counter
from typing import Any

from chasles.decisions.decision import Sentence
from chasles.decisions.kept_answers import verdict_stands
from chasles.decisions.memory import Memory
from chasles.decisions.processes import spread
from chasles.decisions.session import Session
from chasles.repairs.repair import Repair
from chasles.statements import Claim, Condition, Hypothesis, Inverse, Problem, Statement, Theorem, problem_of
from chasles.statements.inversion import problems_of_inverse
from chasles.statements.posing import default_sides
from chasles.statements.premises import with_all_premises
from chasles.verdict import Fails
from chasles.vocabulary import Misfit

Question = tuple[Problem, tuple[Hypothesis, ...]]
A_VERDICT, A_REPAIR, A_CHECK = 0.004, 0.06, 0.002
"""About how many seconds each takes."""


def predict(session: Session, sentences: Iterable[Sentence]) -> None:
    """Fill the memory with the verdicts on these sentences, and with the repairs of those that are wrong as printed."""
    memory, wrong = session.memory, list(sentences)
    for in_full in (False, True):
        asked = {s: {memory.key_of_verdict(*question): question for question in _questions(s, in_full)} for s in wrong}
        _ask(session, {key: question for of_sentence in asked.values() for key, question in of_sentence.items()})
        wrong = [s for s, keys in asked.items() if _is_wrong(s, [memory.recalled(key) for key in keys])]
    if not session.searches:
        return

    def repairs_of(statement: Statement) -> dict[str, tuple[Repair, ...] | None]:
        """The repairs by their key, unless they were kept from another time."""
        try:
            found = session.search(statement)
        except TypeError:
            return {}
        return {key: None if memory.has_accepted(key) else repairs for key, repairs in found.items()}

    searched = [sentence for sentence in wrong if isinstance(sentence, Statement)]
    for key, repairs in chain.from_iterable(found.items() for found in spread(repairs_of, searched, A_REPAIR)):
        if repairs is None:
            memory.settle(key, True)
        else:
            memory.settle(key, False)
            memory.remember(key, repairs)


def _is_wrong(sentence: Sentence, verdicts: Iterable[Any]) -> bool:
    return sentence.fault is not None or any(isinstance(verdict, Fails) for verdict in verdicts)


def _ask(session: Session, questions: Mapping[str, Question]) -> None:
    """Let the verdicts on questions be remembered."""
    memory = session.memory
    _check(memory, questions)
    left = [key for key in questions if not memory.knows(key)]
    verdicts = spread(lambda key: session.verdict_on(*questions[key]), left, A_VERDICT)
    for key, verdict in zip(left, verdicts, strict=True):
        memory.remember(key, verdict)


def _check(memory: Memory, questions: Mapping[str, Question]) -> None:
    """Let the verdicts that are kept from another time be checked."""
    started = perf_counter()
    kept = [key for key in questions if not memory.knows(key) and memory.kept(key) is not None]
    stand = spread(lambda key: verdict_stands(questions[key][0], memory.kept(key)), kept, A_CHECK)
    for key, stands in zip(kept, stand, strict=True):
        memory.settle(key, stands)
    memory.seconds += perf_counter() - started


def _questions(sentence: Sentence, in_full: bool) -> Iterator[Question]:
    """What is decided of a sentence, `in_full` given all that it rests on, if all that stands as declared."""
    try:
        said = with_all_premises(sentence, default_sides) if in_full and not isinstance(sentence, Inverse) else sentence
        match said:
            case Inverse():
                yield from ((problem, ()) for _, problem in problems_of_inverse(said))
            case Claim() | Theorem():
                yield problem_of(said), sentence.assuming
            case Condition() if not said.on or said.solution is not None:
                yield problem_of(said), sentence.assuming
    except (Misfit, TypeError):
        return
