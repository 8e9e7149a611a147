"""What was decided before need not be decided again: verdicts and repairs, kept by the hash of what was asked.

What is remembered is no proof. Whoever uses it checks its certificates and counterexamples again.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from hashlib import sha256
from typing import Any

from chasles.proof.plain_data import from_data, to_data
from chasles.proof.repair import Repair
from chasles.proof.verdict import Undecided, Verdict
from chasles.statements import Hypothesis, Problem, Statement
from chasles.statements.fingerprint import Fingerprints
from chasles.statements.statement import Equation

__all__ = ["Memory"]


class Memory:
    """Answers by the hash of the question; those `kept` are plain data from another time, as `as_data` gives them.

    What is not decided, and what is not repaired, is asked again: more time may help.
    """

    def __init__(self, kept: Mapping[str, Any] | None = None) -> None:
        self._kept = dict(kept or {})
        self._answers: dict[str, Any] = {}
        self._fingerprints = Fingerprints()

    def key_of_verdict(self, problem: Problem, own: Iterable[Hypothesis]) -> str:
        """The key of the verdict on a problem; `own` are the hypotheses whose use it reports."""
        return _hashed(["verdict", self._fingerprints.of(problem), *(self._fingerprints.of(each) for each in own)])

    def key_of_repairs(self, statement: Statement, used: Iterable[Equation], before: Iterable[Statement]) -> str:
        """The key of a statement's repairs: they rest on the sides used, and on what the book says before."""
        said = [self._fingerprints.of(each) for each in (statement, *before)]
        sides = [self._fingerprints.of(side) for equation in used for side in equation]
        return _hashed(["repairs", *said, *sides])

    def recalled(self, key: str) -> Any:
        """The answer to a question; None if none is known, or none that can be read."""
        if key not in self._answers and key in self._kept:
            try:
                self._answers[key] = from_data(self._kept[key])
            except (ValueError, TypeError):
                del self._kept[key]
        return self._answers.get(key)

    def remember(self, key: str, answer: Verdict | tuple[Repair, ...]) -> None:
        """Keep an answer, unless it is none."""
        if answer != () and not isinstance(answer, Undecided):
            self._answers[key] = answer

    @property
    def has_recalled(self) -> bool:
        """Whether an answer from another time was given."""
        return not self._answers.keys().isdisjoint(self._kept)

    @property
    def has_learned(self) -> bool:
        """Whether there is an answer that was not kept before."""
        return not self._answers.keys() <= self._kept.keys()

    def as_data(self, most: int) -> dict[str, Any]:
        """The answers as plain data: those given here, and those kept before as long as they are not too many."""
        here = {key: self._kept.get(key) or to_data(answer) for key, answer in self._answers.items()}
        others = {key: data for key, data in self._kept.items() if key not in here}
        return here | dict(list(others.items())[: max(0, most - len(here))])


def _hashed(parts: list[str]) -> str:
    return sha256("\n".join(parts).encode()).hexdigest()
