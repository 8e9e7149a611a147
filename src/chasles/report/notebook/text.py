"""Things in plain text: the lines that the terminal shows of them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import singledispatch
from io import StringIO
from itertools import chain

from markupsafe import escape
from rich.console import RenderableType
from rich.text import Text

from chasles.compiling.kernel import CompiledKernel
from chasles.decisions.decision import Decision
from chasles.deriving import CheckedDerivation
from chasles.exercises.solution import Solution
from chasles.pages.findings_told import line_of
from chasles.pages.page import ReadPage
from chasles.pages.page_equation import PageEquation
from chasles.repairs.repair import Repair
from chasles.report.derivation_page import derivation_page
from chasles.report.details import evidence, indented, number_in_words, objections, printed
from chasles.report.notebook.alone import as_displayed, entry_of
from chasles.report.notebook.cards import card_of
from chasles.report.screen import Screen
from chasles.report.words import VERDICTS, labelled
from chasles.report.worked_page import worked_page
from chasles.statements import Entry
from chasles.vocabulary import Node, plain


def text(value: object) -> str:
    """The value as a terminal shows it, without colours. Raises TypeError for what is not displayed."""
    file = StringIO()
    screen = Screen(file, terminal=False)
    screen.show(*_pages(as_displayed(value), screen))
    return file.getvalue().rstrip("\n")


@singledispatch
def _pages(value: object, screen: Screen) -> Iterator[RenderableType]:
    """The words of its card, one fact a line."""
    card = card_of(value)
    badges = (f"{badge.sign if screen.signs else VERDICTS[badge.name][1]} {badge.word}" for badge in card.badges)
    needs = ", ".join(need.striptags() for need in card.needs)
    yield Text("  ".join(filter(None, (card.title, *badges, needs, card.says, card.quiet))))
    facts = ((fact.term, fact.text.striptags()) for fact in card.facts)
    rows = ([escape(cell).striptags() for cell in row] for row in card.rows)
    yield indented(chain(facts, ((first, ", ".join(others)) for first, *others in rows)))


@_pages.register
def _(value: Solution, screen: Screen) -> Iterator[RenderableType]:
    yield from worked_page(value, screen.signs)


@_pages.register
def _(value: Node, screen: Screen) -> Iterator[RenderableType]:
    yield Text(plain(value))


@_pages.register
def _(value: Entry, screen: Screen) -> Iterator[RenderableType]:
    sentence = value.statement
    assumed = (("assuming", hypothesis.text) for hypothesis in sentence.assuming)
    yield Text(f"{number_in_words(sentence.number, sentence.part)}  {sentence.role}")
    yield indented(chain(printed(value), assumed))


@_pages.register
def _(value: Decision, screen: Screen) -> Iterator[RenderableType]:
    entry = entry_of(value.statement)
    number = number_in_words(entry.number, entry.statement.part)
    words = (number, labelled(value.verdict, screen.signs).plain, ", ".join(value.verdict.needs))
    yield Text("  ".join(filter(None, words)))
    yield indented(chain(printed(entry), objections(entry, value), evidence(value)))


@_pages.register
def _(value: Repair, screen: Screen) -> Iterator[RenderableType]:
    yield Text(f"{plain(value.left)} = {plain(value.right)}")
    yield indented(("changed", change) for change in value.changes)


@_pages.register
def _(value: CheckedDerivation, screen: Screen) -> Iterator[RenderableType]:
    yield from derivation_page(screen, "derivation", value)


@_pages.register
def _(value: ReadPage, screen: Screen) -> Iterator[RenderableType]:
    yield from (Text(line_of(each, value.file or "page")) for each in value.equations)
    yield Text(value.summary)


@_pages.register
def _(value: PageEquation, screen: Screen) -> Iterator[RenderableType]:
    yield Text(line_of(value, "page"))


@_pages.register
def _(value: CompiledKernel, screen: Screen) -> Iterator[RenderableType]:
    yield Text(repr(value))
