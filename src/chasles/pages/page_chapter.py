"""What was read of a page as a chapter: each statement behind those that it rests on."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace as with_fields

from chasles.pages.notes import EQUAL
from chasles.pages.package import free_name, identifier
from chasles.pages.page_equation import PageEquation
from chasles.statements import Chapter, Entry, Postulate, Section, Statement
from chasles.verdict import Assumed

Key = tuple[str, int]


def chapter_of(title: str, equations: Iterable[PageEquation]) -> tuple[Chapter, dict[str, PageEquation]]:
    """The chapter of all equations that are read, and from what on the page each entry, by its name, was made.

    What is open or a law on the page is a postulate there: as a claim it would be called wrong.
    """
    made = _Declarations(equations)
    for key, (each, _) in made.equations.items():
        made.declare(key, Section(each.printed.section or "1", ""))
    return Chapter(title, tuple(made.entries), ""), made.read


class _Declarations:
    """Declares what is read in the order of the page; what stands further on and is rested on comes first."""

    def __init__(self, equations: Iterable[PageEquation]) -> None:
        self.entries: list[Entry] = []
        self.read: dict[str, PageEquation] = {}
        found = [(each, each.finding.statement) for each in equations if each.finding and each.finding.statement]
        self.equations: dict[Key, tuple[PageEquation, Statement]] = {
            (statement.number, statement.part): (each, statement)
            for each, statement in found
            if statement.sign in EQUAL
        }
        self._declared: dict[Key, Statement] = {}

    def declare(self, key: Key, section: Section) -> Statement:
        """The declaration of an equation, in a section if it is in none before."""
        if key in self._declared:
            return self._declared[key]
        each, statement = self.equations[key]
        given = tuple(self._cited(other, section) for other in statement.given)
        said = with_fields(statement, given=given, sic=statement.fault is not None)
        if each.finding and (each.finding.open or isinstance(each.finding.verdict, Assumed)):
            said = Postulate(key[0], *statement.printed, part=key[1], sign=statement.sign, sic=said.sic)
        stem = identifier(key[0])
        stem = stem if stem.isidentifier() else f"equation_{stem}".rstrip("_")
        name = free_name(f"{stem}_{key[1]}" if key[1] > 1 else stem, self.read)
        self.read[name] = each
        self.entries.append(Entry(name, section, said))
        self._declared[key] = said
        return said

    def _cited(self, given: Statement, section: Section) -> Statement:
        """The declaration of what is given, or what is given itself where that says something else."""
        key = given.number, given.part
        found = self.equations.get(key)
        return given if found is None or found[1].printed != given.printed else self.declare(key, section)
