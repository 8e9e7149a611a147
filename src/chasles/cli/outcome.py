"""The outcome of `decide`: what was decided and checked again, how long it took, and what failed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import TYPE_CHECKING

from chasles.cli.book import decisions
from chasles.decisions.prediction import predict
from chasles.decisions.session import Decision, Session
from chasles.report.details import number_in_words
from chasles.report.findings import slips_in_words
from chasles.report.words import counted, number_of, seconds
from chasles.statements import Chapter, Entry

if TYPE_CHECKING:
    from chasles.cli.rechecking import Rechecked
    from chasles.report.findings import Decided

SHOWN = 3
"""How many rejected verdicts have a line of their own."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """The decisions, how many seconds they took, and what came of checking them again, if that was asked for."""

    decided: tuple[Decided, ...]
    deciding: float
    rechecked: Rechecked | None = None

    @property
    def in_words(self) -> Iterator[str]:
        """Totals and times."""
        verdicts = [decision.verdict for _, decision in self.decided]
        yield f"{number_of(len(verdicts), 'statement')}: {counted(verdicts)}"
        if found := slips_in_words(self.decided):
            yield f"not true as printed: {found}"
        times = f"decided in {seconds(self.deciding)}"
        if self.rechecked is not None:
            what = number_of(self.rechecked.certificates, "certificate")
            if refuted := self.rechecked.counterexamples:
                what += f" and {number_of(refuted, 'counterexample')}"
            times += f"; {what} checked again in {seconds(self.rechecked.seconds)}"
        yield times

    @property
    def failures(self) -> Iterator[str]:
        """A line for each kind of failure; none if all is well."""
        undecided = [entry for entry, decision in self.decided if decision.verdict.name == "undecided"]
        unproved = [entry for entry, decision in self.decided if _stands_in_wrongly(decision)]
        if undecided:
            yield f"undecided: {_numbers(undecided, placed=True)}"
        if unproved:
            yield f"the declared correction is not proved: {_numbers(unproved, placed=True)}"
        rejected = self.rechecked.rejected if self.rechecked else ()
        for entry, why in rejected[:SHOWN]:
            yield f"checked again, the verdict on {_numbers([entry])} is rejected: {why}"
        if len(rejected) > SHOWN:
            yield f"so are those on {_numbers([entry for entry, _ in rejected[SHOWN:]])}"


def decide(
    entries: Sequence[Entry], book: Chapter, recheck: bool = True, anew: bool = False
) -> tuple[Outcome, Session]:
    """Decide the statements and, unless told otherwise, check the verdicts again without the prover.

    What the chapter brings along, and what was decided in an earlier run, is only checked. Where all is to be decided
    `anew`, that is not asked for, or something is rejected, everything is decided.
    """
    from chasles.decisions.recalled import forget, retained, session_of

    started = perf_counter()
    session = session_of(book, anew or not recheck)
    memory = session.memory
    decided = _decided(entries, session)
    deciding = perf_counter() - started - memory.seconds
    if not recheck:
        return Outcome(decided, deciding), session
    from chasles.cli.rechecking import recheck as check_again

    outcome = Outcome(decided, deciding, check_again(decided, memory))
    if outcome.rechecked and outcome.rechecked.rejected and memory.has_recalled:
        forget()
        return decide(entries, book, anew=True)
    retained(memory)
    return outcome, session


def _decided(entries: Sequence[Entry], session: Session) -> tuple[Decided, ...]:
    predict(session, [entry.statement for entry in entries])
    return tuple(decisions(entries, session))


def _stands_in_wrongly(decision: Decision) -> bool:
    """Whether what is declared to be right is not; a likely reading that fails is a finding about the book."""
    correction = decision.correction
    tried = () if correction is None else (correction, *correction.others)
    return any(each.form == "corrected" and not each.verdict.true for each in tried)


def _numbers(entries: Sequence[Entry], placed: bool = False) -> str:
    """The numbers, each with file and line of its declaration if it is to be `placed`."""
    places = [f" ({entry.statement.place})" if placed and entry.statement.place else "" for entry in entries]
    numbers = [number_in_words(entry.number, entry.statement.part) for entry in entries]
    return ", ".join(f"{number}{place}" for number, place in zip(numbers, places, strict=True))
