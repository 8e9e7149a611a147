"""Things in plain text: the lines that the terminal shows of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import singledispatch
from io import StringIO
from itertools import chain
from typing import Any

from rich.console import RenderableType
from rich.text import Text

from chasles.compiling.kernel import CompiledKernel
from chasles.decisions.decision import Certificate, Decision
from chasles.deriving import CheckedDerivation
from chasles.emitted import EmittedKernel
from chasles.exercises.solution import Solution
from chasles.pages.findings_told import line_of
from chasles.pages.page import ReadPage
from chasles.pages.page_equation import PageEquation
from chasles.repairs.repair import Repair
from chasles.report.derivation_page import derivation_page
from chasles.report.details import Lines, evidence, indented, number_in_words, objections, printed, refuted
from chasles.report.notebook.alone import as_displayed, cited, entry_of, sections_of
from chasles.report.records import certificate_hash
from chasles.report.screen import Screen
from chasles.report.words import labelled, number_of, point_in_words
from chasles.report.worked_page import worked_page
from chasles.statements import Chapter, Entry
from chasles.statements.derivation import Derivation
from chasles.verdict import Counterexample, Verdict
from chasles.vocabulary import Node, plain


def text(value: object) -> str:
    """The value as a terminal shows it, without colours. Raises TypeError for what is not displayed."""
    file = StringIO()
    screen = Screen(file, terminal=False)
    screen.show(*_pages(as_displayed(value), screen))
    return file.getvalue().rstrip("\n")


@singledispatch
def _pages(value: object, screen: Screen) -> Iterator[RenderableType]:
    raise TypeError(f"nothing is known of how to display {type(value).__name__}")


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
    yield _judged(number, value.verdict, screen)
    yield indented(chain(printed(entry), objections(entry, value), evidence(value)))


@_pages.register
def _(value: Verdict, screen: Screen) -> Iterator[RenderableType]:
    found, certificate = getattr(value, "counterexample", None), getattr(value, "certificate", None)
    yield _judged("", value, screen)
    lines = [("because", value.reason)] if value.reason else []
    lines += [("certificate", str(certificate_hash(certificate)))] if certificate is not None else []
    yield indented(chain(lines, refuted(found) if found is not None else ()))


@_pages.register
def _(value: Counterexample, screen: Screen) -> Iterator[RenderableType]:
    yield indented(refuted(value))


@_pages.register
def _(value: Certificate, screen: Screen) -> Iterator[RenderableType]:
    yield indented(_certified(value))


@_pages.register
def _(value: Repair, screen: Screen) -> Iterator[RenderableType]:
    yield Text(f"{plain(value.left)} = {plain(value.right)}")
    yield indented(("changed", change) for change in value.changes)


@_pages.register
def _(value: CheckedDerivation, screen: Screen) -> Iterator[RenderableType]:
    yield from derivation_page(screen, "derivation", value)


@_pages.register
def _(value: Derivation, screen: Screen) -> Iterator[RenderableType]:
    yield Text(f"{number_in_words(value.number)}  {value.says}")
    yield indented((f"{place} {step.kind}", cited(step.cited)) for place, step in enumerate(value.steps, start=1))


@_pages.register
def _(value: Chapter, screen: Screen) -> Iterator[RenderableType]:
    yield Text(value.title)
    for number, title, numbers, statements in sections_of(value):
        yield Text(f"  {number:8}{title}: {numbers}, {number_of(int(statements), 'statement')}")


@_pages.register
def _(value: ReadPage, screen: Screen) -> Iterator[RenderableType]:
    yield from (Text(line_of(each, value.file or "page")) for each in value.equations)
    yield Text(value.summary)


@_pages.register
def _(value: PageEquation, screen: Screen) -> Iterator[RenderableType]:
    yield Text(line_of(value, "page"))


@_pages.register
def _(value: EmittedKernel, screen: Screen) -> Iterator[RenderableType]:
    yield Text(f"{value.name}{value.signature}  {number_in_words(value.number)} {value.says}")
    bound = (("error bound", clause) for clause in value.bound)
    yield indented(chain([("assumes", ", ".join(value.hypotheses) or "nothing")], bound))


@_pages.register
def _(value: CompiledKernel, screen: Screen) -> Iterator[RenderableType]:
    yield Text(repr(value))


def _judged(before: str, verdict: Verdict, screen: Screen) -> Text:
    words = (before, labelled(verdict, screen.signs).plain, ", ".join(verdict.needs))
    return Text("  ".join(filter(None, words)))


def _certified(certificate: Mapping[str, Any]) -> Lines:
    yield "certificate", str(certificate_hash(certificate))
    for name, replaced, *_ in certificate.get("division", ()):
        yield "divided by", f"{name}, which replaces {replaced}"
    if witness := point_in_words(certificate.get("witness", {})):
        yield "example", witness
