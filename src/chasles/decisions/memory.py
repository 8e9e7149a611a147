"""What was decided before need not be decided again: answers, kept by the hash of what was asked.

What is kept from another time is no proof. It is an answer again once its certificate or counterexample was checked.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from hashlib import sha256
from time import perf_counter
from typing import Any

from chasles.decisions.plain_data import from_data, to_data
from chasles.repairs.repair import Repair
from chasles.statements import Hypothesis, Problem, Statement
from chasles.statements.fingerprint import Fingerprints
from chasles.statements.statement import Equation
from chasles.verdict import Fails, Holds, HoldsUnder, Verdict
from chasles.vocabulary import Node

Answer = Verdict | tuple[Repair, ...] | Node
"""The verdict on a problem; the repairs of a statement; an expression as a combination of terms."""
LASTING = (Holds, HoldsUnder, Fails, tuple, Node)
"""What can be checked, or need not be: anything else is asked again."""


class Memory:
    """Answers by the hash of the question; those `kept` and `shipped` are plain data from another time.

    What is shipped is there for everyone, and is not among what is to be kept. `asked` are the questions, in order;
    `seconds` is how long it took to check what came from another time. `reasons` are why something was not decided, by
    the question and the bounds within which it was asked.
    """

    def __init__(self, kept: Mapping[str, Any] | None = None, shipped: Mapping[str, Any] | None = None) -> None:
        self._shipped = dict(shipped or {})
        self._kept = self._shipped | dict(kept or {})
        self._answers: dict[str, Any] = {}
        self._checked: dict[int, Any] = {}
        self._conjectures: set[str] = set()
        self._fingerprints = Fingerprints()
        self.asked: dict[str, None] = {}
        self.reasons: dict[str, str] = {}
        self.seconds = 0.0

    def key_of_verdict(self, problem: Problem, own: Iterable[Hypothesis]) -> str:
        """The key of the verdict on a problem; `own` are the hypotheses whose use it reports."""
        return self._key("verdict", problem, *own)

    def key_of_repairs(self, statement: Statement, used: Iterable[Equation], before: Iterable[Statement]) -> str:
        """The key of a statement's repairs: they rest on the sides used, and on what the book says before."""
        return self._key("repairs", statement, *before, *(side for equation in used for side in equation))

    def key_of_combination(self, node: Node, terms: Iterable[Node], problem: Problem) -> str:
        """The key of an expression as a combination of terms, by what a problem declares."""
        return self._key("combination", problem, node, *terms)

    def _key(self, kind: str, *asked: Any) -> str:
        parts = [kind, *map(self._fingerprints.of, asked)]
        return sha256("\n".join(parts).encode()).hexdigest()

    def answer(self, key: str, check: Callable[[Any], bool], find: Callable[[], Answer]) -> Any:
        """The answer that is known; the one that is kept, if the check accepts it; else what is found."""
        self.asked[key] = None
        if key not in self._answers:
            started, kept = perf_counter(), self.kept(key)
            if kept is not None:
                self.settle(key, check(kept))
                self.seconds += perf_counter() - started
        if key in self._answers:
            return self._answers[key]
        found = find()
        self.remember(key, found)
        return found

    def knows(self, key: str) -> bool:
        """Whether the answer was given here, or has been checked."""
        return key in self._answers

    def recalled(self, key: str) -> Any:
        """The answer that was given here, or has been checked; else None."""
        return self._answers.get(key)

    def has_accepted(self, key: str) -> bool:
        """Whether the answer came from another time, and is known by now."""
        return key in self._answers and key in self._kept

    def kept(self, key: str) -> Any:
        """The answer from another time, which nobody has checked; None if there is none that can be read."""
        try:
            return from_data(self._kept[key]) if key in self._kept else None
        except (AssertionError, AttributeError, TypeError, ValueError):
            return None

    def settle(self, key: str, accepted: bool) -> None:
        """What is kept is the answer, or is forgotten."""
        kept = self.kept(key)
        if not accepted or kept is None:
            self._forget(key)
            return
        self._answers[key] = kept
        if isinstance(kept, Node):
            self._conjectures.add(key)
        for verdict in [each.verdict for each in kept] if isinstance(kept, tuple) else [kept]:
            self._checked[id(verdict)] = verdict

    def remember(self, key: str, answer: Answer) -> None:
        """Give the answer again when it is asked for; what is not decided is asked anew."""
        if isinstance(answer, LASTING):
            self._answers[key] = answer

    def has_checked(self, verdict: Verdict) -> bool:
        """Whether the verdict came from another time, and was checked here."""
        return id(verdict) in self._checked

    def forget_conjectures(self) -> bool:
        """Ask anew for all combinations that came from another time; whether there were any."""
        for key in self._conjectures:
            self._forget(key)
        found = bool(self._conjectures)
        self._conjectures.clear()
        return found

    def _forget(self, key: str) -> None:
        for known in (self._answers, self._kept, self._shipped):
            known.pop(key, None)

    @property
    def has_recalled(self) -> bool:
        """Whether an answer from another time was given."""
        return not self._answers.keys().isdisjoint(self._kept)

    @property
    def has_learned(self) -> bool:
        """Whether there is an answer that was not kept before."""
        return not self._answers.keys() <= self._kept.keys()

    def data_of(self, key: str) -> Any:
        """An answer as plain data, as it was kept if it was; None for none, and for one with an author's own words."""
        try:
            return self._kept.get(key) or to_data(self._answers.get(key))
        except TypeError:
            return None

    @property
    def everything(self) -> dict[str, Any]:
        """All answers as plain data, checked or not."""
        return self._kept | {key: self.data_of(key) for key in self._answers}

    def as_data(self, most: int) -> dict[str, Any]:
        """The answers as plain data: those given here, and those kept before as long as they are not too many."""
        found = {key: self.data_of(key) for key in self._answers if key not in self._shipped}
        here = {key: data for key, data in found.items() if data is not None}
        others = {key: data for key, data in self._kept.items() if key not in here and key not in self._shipped}
        return here | dict(list(others.items())[: max(0, most - len(here))])
