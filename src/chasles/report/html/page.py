"""The page as one text: what is shown, put into the template."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import groupby
from typing import Any

from markupsafe import Markup

from chasles import __version__
from chasles.bounds.bound import Bound
from chasles.decisions.decision import WORST_FIRST
from chasles.report.details import number_in_words
from chasles.report.emission_records import emitted_kernels
from chasles.report.equations import labelled_equations
from chasles.report.findings import SLIPS, DecisionsByName, Pairs, ordered, slips
from chasles.report.html.citing import Book, Link, place_of_number, slug
from chasles.report.html.error_plots import plotted
from chasles.report.html.exercises import WorkedView
from chasles.report.html.filling import filled
from chasles.report.html.formulas import math
from chasles.report.html.graph import graph_of
from chasles.report.html.measured import measured
from chasles.report.html.overview import Trusted, overview
from chasles.report.html.palette import DARK, LIGHT
from chasles.report.html.shown import DerivationView, KernelRow, NumberShown, StatementShown, badge_of
from chasles.report.html.statements import part_of, place_of_part
from chasles.report.words import VERDICTS
from chasles.statements import Chapter, Section
from chasles.vocabulary import Symbol, latex, walk

FORMS = {"stated": "as stated", "offered": "in a form proved equal"}


@dataclass(frozen=True, slots=True)
class SectionView:
    """A section of the book with its numbers; `classes` are what filters look for."""

    place: str
    number: str
    title: str
    classes: str
    numbers: tuple[NumberShown, ...]


@dataclass(frozen=True, slots=True)
class Chosen:
    """A filter: its name, the class of what it lets through, and its words."""

    place: str
    lets_through: str
    words: str


@dataclass(frozen=True, slots=True)
class PageContents:
    """What the page shows besides the decisions: certificates, kernels, measurements, derivations, exercises.

    `evidence` are the texts of what was measured, by the names of their files.
    """

    trusted: Trusted
    manifest: str = ""
    evidence: Mapping[str, str] = field(default_factory=dict)
    roads: tuple[DerivationView, ...] = ()
    exercises: tuple[WorkedView, ...] = ()


def page(chapter: Chapter, decisions: DecisionsByName, sources: PageContents) -> str:
    """The whole page; the same decisions and sources give the same text. Raises DamagedEvidence."""
    return str(filled("index.html.jinja", **contents(chapter, decisions, sources), has_pages=False))


def contents(chapter: Chapter, decisions: DecisionsByName, sources: PageContents) -> dict[str, Any]:
    """What the templates show, by name. Raises DamagedEvidence."""
    book = Book(chapter)
    decided = ordered(chapter, decisions)
    kernels = kernel_rows(book, sources.manifest)
    sections = tuple(_sections(book, decided, kernels, sources.roads))
    numbers = [number for section in sections for number in section.numbers]
    figures = measured(sources.evidence, {name: kernel.place for name, kernel in kernels.items()})
    plots, without_plots = plotted(figures.curves)
    return {
        "title": chapter.title,
        "source": chapter.source,
        "version": __version__,
        "overview": overview(book, decided, sources.roads, sources.trusted),
        "sections": sections,
        "errata": _errata(decided, numbers),
        "kernels": tuple(kernels.values()),
        "measured": figures,
        "plots": plots,
        "without_plots": without_plots,
        "graph": graph_of(book, [(f"{s.number} {s.title}", s.numbers) for s in sections]),
        "exercises": sources.exercises,
        "without_pictures": tuple(dict.fromkeys(reason for view in sources.exercises for reason in view.without)),
        "verdict_filters": tuple(_verdict_filters(numbers)),
        "section_filters": tuple(_section_filters(sections)),
        "light": LIGHT,
        "dark": DARK,
        "letters": notation_of(chapter),
    }


def _errata(
    decided: Pairs, numbers: Sequence[NumberShown]
) -> list[tuple[str, list[tuple[NumberShown, StatementShown]]]]:
    """What is wrong as printed, by whose slip it probably is."""
    shown = {part.place: (number, part) for number in numbers for part in number.parts}
    found = slips(decided)
    return [(SLIPS[slip], [shown[place_of_part(entry)] for entry, _ in pairs]) for slip, pairs in found.items()]


def _sections(
    book: Book, decided: Pairs, kernels: Mapping[str, KernelRow], roads: Sequence[DerivationView]
) -> Iterator[SectionView]:
    """The sections in the book's order; a derivation is where its number is first."""
    leading: dict[str, list[DerivationView]] = {}
    for road in roads:
        leading.setdefault(road.number, []).append(road)
    seen: dict[str, int] = {}
    for section, members in groupby(decided, lambda pair: pair[0].section):
        numbers = []
        for number, group in groupby(members, lambda pair: pair[0].number):
            seen[number] = seen.get(number, 0) + 1
            numbers.append(_number(book, number, list(group), kernels, leading.pop(number, ()), seen[number]))
        yield SectionView(
            f"section-{slug(section.number)}", section.number, section.title, _within(section), tuple(numbers)
        )


def _number(
    book: Book,
    number: str,
    group: Pairs,
    kernels: Mapping[str, KernelRow],
    roads: Sequence[DerivationView],
    times: int,
) -> NumberShown:
    """A number with the parts of it that stand in one section; its verdict is the worst of theirs."""
    names = [decision.verdict.name for _, decision in group]
    parts = tuple(
        part_of(book, entry, decision, [kernels[k.name] for k in entry.kernels if k.name in kernels])
        for entry, decision in group
    )
    return NumberShown(
        place=place_of_number(number) if times == 1 else f"{place_of_number(number)}-again-{times}",
        cited=number_in_words(number),
        badge=badge_of(min(names, key=WORST_FIRST.index)),
        classes=" ".join(f"is-{name}" for name in dict.fromkeys(names)),
        parts=parts,
        roads=tuple(roads),
    )


def _within(section: Section) -> str:
    """The classes of a section: itself and those that it is part of, down to the chapter's sections."""
    pieces = section.number.split(".")
    return " ".join(f"within-{'-'.join(pieces[: k + 1])}" for k in range(1, max(2, len(pieces))))


def _verdict_filters(numbers: Sequence[NumberShown]) -> Iterator[Chosen]:
    present = {name for number in numbers for name in number.classes.split()}
    for name in VERDICTS:
        if f"is-{name}" in present:
            badge = badge_of(name)
            yield Chosen(f"verdict-{name}", f"is-{name}", f"{badge.sign} {badge.word}")


def _section_filters(sections: Sequence[SectionView]) -> Iterator[Chosen]:
    for outermost in dict.fromkeys(section.classes.split()[0] for section in sections):
        yield Chosen(f"only-{outermost}", outermost, outermost.removeprefix("within-").replace("-", "."))


def kernel_rows(book: Book, manifest: str) -> dict[str, KernelRow]:
    """The kernels of the chapter by name, in the manifest's order; those that are not of this chapter are left out."""
    known = {kernel.name for entry in book.chapter for kernel in entry.kernels}
    return {name: _row(book, name, kernel) for name, kernel in emitted_kernels(manifest).items() if name in known}


def _row(book: Book, name: str, kernel: Mapping[str, Any]) -> KernelRow:
    counts: Mapping[str, int] = kernel["operations"]
    number = kernel["number"]
    return KernelRow(
        name=name,
        place=f"kernel-{slug(name)}",
        number=Link(f"#{place_of_number(number)}", number_in_words(number)),
        says=kernel["says"],
        signature=kernel["signature"],
        needs=tuple(book.condition(text) for text in kernel["hypotheses"]),
        total=sum(counts.values()),
        operations=", ".join(f"{count} {kind.replace('_', ' ')}" for kind, count in counts.items()) or "none",
        bound=Bound.from_data(kernel["bound"]).in_words if kernel.get("bound") else (),
        form=FORMS.get(kernel["form"], kernel["form"]),
    )


@dataclass(frozen=True, slots=True)
class Letter:
    """A letter as the book prints it, its name in plain text, what it means, its shape and its unit."""

    math: Markup
    name: str
    means: str
    kind: str


def notation_of(chapter: Chapter) -> tuple[Letter, ...]:
    """The letters that mean something by themselves, each once."""
    sides = (side for entry in chapter for _, *both in labelled_equations(entry.statement) for side in both)
    found = dict.fromkeys(part for side in sides for part in walk(side) if isinstance(part, Symbol))
    return tuple(_letter(symbol) for symbol in found if symbol.meaning)


def _letter(symbol: Symbol) -> Letter:
    rows, columns = symbol.size.shape
    shape = "" if rows == columns == 1 else f"{rows} x {columns}" if columns != 1 else f"vector of {rows}"
    units = dict.fromkeys(str(dimension) for row in symbol.size.grid for dimension in row if dimension is not None)
    kind = ", ".join(filter(None, (shape, *(unit for unit in units if unit != "no dimension"))))
    return Letter(math(latex(symbol)), symbol.name, symbol.meaning, kind)
