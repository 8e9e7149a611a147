"""The chapter as a LaTeX document: every equation as printed, with its verdict and what is right instead."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

from jinja2 import Environment

from chasles.decisions.session import Decision
from chasles.report.details import number_in_words, objections_to_print
from chasles.report.equations import hypotheses_in_latex, in_both, in_latex
from chasles.report.findings import (
    DecisionsByName,
    Pairs,
    Replacement,
    likely_slip,
    ordered,
    replacements,
    slips_in_words,
)
from chasles.report.html.exercises import WorkedView
from chasles.report.html.filling import environment
from chasles.report.words import VERDICTS, counted
from chasles.statements import Chapter, Entry

_SPECIAL = str.maketrans(
    {
        "\\": r"\textbackslash{}",
        "~": r"\textasciitilde{}",
        "^": r"\textasciicircum{}",
        **{mark: f"\\{mark}" for mark in "{}_#$%&"},
    }
)


@dataclass(frozen=True, slots=True)
class Instead:
    """What is right instead of an equation, in LaTeX, and what is said of it; `lead` comes before it."""

    lead: str
    formula: str
    verdict: str
    changes: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Item:
    """A statement: number, verdict, words and formulas, in LaTeX; `number` is empty but for the first part."""

    number: str
    verdict: str
    needs: str
    says: str
    formulas: tuple[str, ...]
    why: tuple[str, ...]
    instead: tuple[Instead, ...]
    slip: tuple[str, ...]


def escaped(text: str) -> str:
    """The text as it stands, for a LaTeX document."""
    return text.translate(_SPECIAL)


def latex_page(chapter: Chapter, decisions: DecisionsByName, worked: Sequence[WorkedView] = ()) -> str:
    """The document, the worked exercises at its end; the same decisions and exercises give the same text."""
    decided = ordered(chapter, decisions)
    values = {
        "title": escaped(chapter.title),
        "source": escaped(chapter.source),
        "slips": escaped(slips_in_words(decided)),
        "statements": len(decided),
        "totals": escaped(counted(decision.verdict for _, decision in decided)),
        "exercises": worked,
        "headings": _headings(decided, hypotheses_in_latex(chapter)),
    }
    return _environment().get_template("chapter.tex.jinja").render(values)


def _environment() -> Environment:
    """Templates whose marks do not look like LaTeX."""
    found = environment(
        autoescape=False,
        block_start_string="<%",
        block_end_string="%>",
        variable_start_string="<<",
        variable_end_string=">>",
        comment_start_string="<#",
        comment_end_string="#>",
    )
    found.filters["tex"] = escaped
    return found


def _headings(decided: Pairs, hypotheses: Mapping[str, str]) -> Iterator[tuple[str, Iterator[Item]]]:
    """The sections of the book, each with its statements."""
    for section, group in groupby(decided, lambda pair: pair[0].section):
        members = list(group)
        numbers = ["", *(entry.number for entry, _ in members)]
        pairs = zip(members, numbers, strict=False)
        items = (item_of(entry, decision, before, hypotheses) for (entry, decision), before in pairs)
        yield escaped(f"{section.number} {section.title}"), items


def item_of(entry: Entry, decision: Decision, before: str, hypotheses: Mapping[str, str]) -> Item:
    """A statement; `before` is the number of the one before it."""
    found = replacements(entry, decision)
    wrong = decision.verdict.wrong
    return Item(
        number="" if entry.number == before else escaped(number_in_words(entry.number)),
        verdict=VERDICTS[decision.verdict.name][2],
        needs=listed(decision.verdict.needs, hypotheses),
        says=escaped(entry.statement.says),
        formulas=in_latex(entry.statement),
        why=tuple(escaped(f"{label}: {text}") for label, text in objections_to_print(decision)),
        instead=tuple(_instead(replacement, hypotheses, first=replacement is found[0]) for replacement in found),
        slip=(escaped(likely_slip(entry, decision)),) if wrong else (),
    )


def _instead(replacement: Replacement, hypotheses: Mapping[str, str], *, first: bool) -> Instead:
    verdict = f"{VERDICTS[replacement.verdict.name][2]} {listed(replacement.verdict.needs, hypotheses)}".rstrip()
    return Instead(
        "Right is" if first else "or",
        in_both((replacement.left, replacement.right), replacement.sign)[1],
        escaped(replacement.in_words) if replacement.by else verdict,
        tuple(map(escaped, replacement.changes)),
    )


def listed(texts: Iterable[str], hypotheses: Mapping[str, str]) -> str:
    """Hypotheses as formulas; in words where one is not told as a formula."""
    return ", ".join(f"${hypotheses[text]}$" if hypotheses.get(text) else escaped(text) for text in texts)
