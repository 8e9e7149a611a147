"""The report: the chapter decided and checked again, with its derivations, as files to be written."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from time import perf_counter

from chasles.cli.answers import all_derivations
from chasles.cli.checkout import manifest
from chasles.cli.failures import Failure
from chasles.cli.outcome import Outcome, decide
from chasles.report.closure import lines
from chasles.report.html.derivations import walked
from chasles.report.html.exercises import worked_exercises
from chasles.report.html.measured import ERRORS, TIMES, DamagedEvidence
from chasles.report.html.overview import Trusted
from chasles.report.html.page import PageContents, page
from chasles.report.html.shown import DerivationView
from chasles.report.html.site import site
from chasles.report.latex_page import latex_page
from chasles.report.words import seconds
from chasles.statements import Chapter
from chasles.statements.derivation import Derivation
from chasles.statements.packages import BOOK

EVIDENCE = (("benchmarks", "evidence"), ("evidence",))
"""Beside the declarations in a checkout, and in an installed wheel."""


@dataclass(frozen=True, slots=True)
class Reported:
    """The content of each file by its name, and what was done for it."""

    files: dict[str, str | bytes]
    outcome: Outcome
    roads: tuple[DerivationView, ...]
    unsolved: tuple[str, ...]
    seconds: float

    @property
    def in_words(self) -> Iterator[str]:
        """Totals and times."""
        yield from self.outcome.in_words
        arriving = sum(derivation.arrives for derivation in self.roads)
        yield f"{arriving} of {len(self.roads)} derivations complete; all in {seconds(self.seconds)}"

    @property
    def failures(self) -> Iterator[str]:
        """A line for each kind of failure; none if all is well."""
        yield from self.outcome.failures
        stuck = [derivation.name for derivation in self.roads if not derivation.arrives]
        if stuck:
            yield f"incomplete derivations: {', '.join(stuck)}"
        yield from self.unsolved


def reported(book: Chapter, as_site: bool, address: str) -> Reported:
    """The report on the whole chapter, or a site of it that will lie at the address.

    Raises Failure for contradictory declarations, and for damaged files.
    """
    started = perf_counter()
    outcome, session = decide(book.entries, book)
    roads = walked(_roads_of(book), session)
    decisions = {entry.name: decision for entry, decision in outcome.decided}
    again = outcome.rechecked
    assert again is not None
    exercises = worked_exercises(book)
    trusted = Trusted(again.certificates, again.counterexamples, len(again.rejected), lines("declared"))
    try:
        sources = PageContents(trusted, manifest(book), _evidence(book), roads, exercises)
        files: dict[str, str | bytes] = (
            dict(site(book, decisions, sources, address)) if as_site else {"index.html": page(book, decisions, sources)}
        )
    except DamagedEvidence as error:
        raise Failure(f"{'/'.join(EVIDENCE[0])}/{error}; benchmarks/README.md says how to measure anew") from error
    if not as_site:
        files["chapter.tex"] = latex_page(book, decisions, exercises)
    unsolved = tuple(f"exercise {one.number} is not solved: {one.unsolved}" for one in exercises if one.unsolved)
    return Reported(files, outcome, roads, unsolved, perf_counter() - started)


def _roads_of(book: Chapter) -> dict[str, Derivation]:
    """The derivations that are compared with statements of this book."""
    known = {id(entry.statement) for entry in book}
    return {
        name: derivation
        for name, derivation in all_derivations(book).items()
        if any(id(statement) in known for step in derivation.steps for statement in step.cited)
    }


def _evidence(book: Chapter) -> dict[str, str]:
    """What was measured, file by file; nothing where the declarations lie alone."""
    spec = find_spec(BOOK) if book.package == BOOK else None
    for declarations in (spec.submodule_search_locations or ()) if spec else ():
        folders = (Path(declarations).resolve().parent.joinpath(*parts) for parts in EVIDENCE)
        if folder := next(filter(Path.is_dir, folders), None):
            return {name: (folder / name).read_text("utf-8") for name in (TIMES, ERRORS) if (folder / name).is_file()}
    return {}
