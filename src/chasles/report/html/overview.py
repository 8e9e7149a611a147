"""The chapter in numbers: totals, a row for each section, what is assumed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from chasles.report.decisions import Tally, tallies
from chasles.report.findings import Pairs, numbers_of, replaced_by, slips_in_words
from chasles.report.html.citing import Book
from chasles.report.html.shown import Badge, DerivationView, badge_of
from chasles.report.words import VERDICTS, counted


@dataclass(frozen=True, slots=True)
class Trusted:
    """What the verdicts rest on: how much was checked again, how much was rejected, how many lines the checker has."""

    certificates: int
    counterexamples: int
    rejected: int
    lines: int


@dataclass(frozen=True, slots=True)
class VerdictShare:
    """How many statements have a verdict, and where they begin in a bar that is 1000 wide."""

    badge: Badge
    count: int
    start: float
    width: float


def overview(book: Book, decided: Pairs, roads: tuple[DerivationView, ...], trusted: Trusted) -> dict[str, Any]:
    """The totals of all that was decided and walked, for the template.

    `wrong` counts what is not true as printed, `slips` says whose slips these more likely are, `found`, `declared` and
    `without` how it is repaired; `postulates` are the laws that are assumed. A row is a section with its counts, in the
    order of the shares.
    """
    how = replaced_by(decided)
    sections = tallies(decided)
    shares = _shares(sections)
    return {
        "numbers": numbers_of(book.chapter),
        "statements": len(decided),
        "in_words": counted(decision.verdict for _, decision in decided),
        "shares": shares,
        "rows": [(tally, [tally.verdicts[share.badge.name] for share in shares]) for tally in sections],
        "wrong": how.total(),
        "slips": slips_in_words(decided),
        "found": how["repair"],
        "declared": how["declared"],
        "without": how["nothing"],
        "postulates": book.links(entry.key for entry, decision in decided if decision.verdict.name == "assumed"),
        "roads": len(roads),
        "steps": sum(len(road.steps) for road in roads),
        "arriving": sum(road.arrives for road in roads),
        "trusted": trusted,
    }


def _shares(sections: list[Tally]) -> tuple[VerdictShare, ...]:
    """The verdicts that occur, side by side."""
    total = Tally("", "")
    for section in sections:
        total.add(section)
    whole = total.verdicts.total() or 1
    shares, start = [], 0.0
    for name in VERDICTS:
        if count := total.verdicts[name]:
            width = 1000 * count / whole
            shares.append(VerdictShare(badge_of(name), count, round(start, 1), round(width, 1)))
            start += width
    return tuple(shares)
