"""Things as LaTeX: formulas between words, for notebooks that are printed, and to be pasted."""

from __future__ import annotations

from collections.abc import Iterator
from functools import singledispatch

from chasles.decisions.decision import Decision
from chasles.deriving import CheckedDerivation
from chasles.exact.spelling import latex_of, plain_in_latex, words_in_latex
from chasles.exercises.solution import Solution, SolutionStep, cited
from chasles.repairs.repair import Repair
from chasles.report.derivation_page import equations_of
from chasles.report.details import number_in_words
from chasles.report.equations import in_latex
from chasles.report.latex_page import escaped, item_of, listed
from chasles.report.notebook.alone import Alone, as_displayed, entry_of
from chasles.report.notebook.text import text
from chasles.report.words import VERDICTS
from chasles.statements import Entry
from chasles.vocabulary import Node
from chasles.vocabulary import latex as spelled


def latex(value: object) -> str:
    """The value in LaTeX, formulas between dollars and in displays."""
    return "\n\n".join(part for part in _parts(as_displayed(value)) if part) + "\n"


@singledispatch
def _parts(value: object) -> Iterator[str]:
    """What has no formulas, line by line as it is in plain text."""
    yield from (rf"\texttt{{{escaped(line)}}}" for line in text(value).splitlines())


@_parts.register
def _(value: Solution) -> Iterator[str]:
    yield "\n".join(_worked(value))


@_parts.register
def _(value: Node) -> Iterator[str]:
    yield rf"$\displaystyle {spelled(value)}$"


@_parts.register
def _(value: Entry) -> Iterator[str]:
    sentence = value.statement
    yield _headed(number_in_words(sentence.number, sentence.part), sentence.role)
    yield escaped(sentence.says)
    yield from map(_display, in_latex(sentence))
    if sentence.assuming:
        known = {hypothesis.text: hypothesis.latex for hypothesis in sentence.assuming}
        yield f"assuming {listed(known, known)}"


@_parts.register
def _(value: Decision) -> Iterator[str]:
    entry = entry_of(value.statement)
    item = item_of(entry, value, "", Alone(value.statement).hypotheses)
    yield _headed(number_in_words(entry.number, entry.statement.part), item.verdict, item.needs)
    yield item.says
    yield from map(_display, item.formulas)
    yield from item.why
    for instead in item.instead:
        yield instead.lead
        yield _display(instead.formula)
        yield f"which {instead.verdict}."
        yield from instead.changes
    yield from item.slip


@_parts.register
def _(value: Repair) -> Iterator[str]:
    yield _display(f"{spelled(value.left)} = {spelled(value.right)}")
    yield from map(escaped, value.changes)


@_parts.register
def _(value: CheckedDerivation) -> Iterator[str]:
    yield _headed(number_in_words(value.derivation.number), "", escaped(value.derivation.says))
    for number, step in enumerate(value.steps, start=1):
        verdict = "" if step.comparison is not None else VERDICTS[step.verdict.name][2]
        yield _headed(f"{number} {step.kind}", verdict, escaped(step.reason))
        yield from (_display(f"{spelled(left)} = {spelled(right)}") for _, left, right in equations_of(step))


def _headed(bold: str, small: str, rest: str = "") -> str:
    """A heading: in bold, in small capitals, and what follows."""
    parts = rf"\textbf{{{escaped(bold)}}}", rf"\textsc{{{escaped(small)}}}" if small else "", rest
    return " ".join(filter(None, parts))


def _display(formula: str) -> str:
    return rf"\[ {formula} \]"


def _worked(solution: Solution) -> Iterator[str]:
    """The steps of a solution, numbered, and the answers."""
    yield rf"\textbf{{Exercise {solution.exercise}: {plain_in_latex(solution.title)}}}"
    for assumed in solution.assumptions:
        yield rf"\par Assumed: {plain_in_latex(assumed)}"
    for number, step in enumerate(solution.steps, 1):
        yield rf"\par {number}. {_said(step)}"
        yield from (rf"\[ {line.latex} \]" for line in step.lines)
    yield rf"\par\textbf{{Answer: {plain_in_latex(solution.outcome)}}}"
    yield from (rf"\[ {words_in_latex(name)} = {latex_of(value)} \]" for name, value in solution.answers.items())
    for check in solution.checks:
        yield rf"\par {_said(check)}"
        yield from (rf"\[ {line.latex} \]" for line in check.lines)


def _said(step: SolutionStep) -> str:
    cites = cited(step.cites)
    return plain_in_latex(step.says) + (f" ({plain_in_latex(cites)})" if cites else "")
