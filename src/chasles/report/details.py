"""The details of a verdict: labels and lines of text, the same on every page."""

from __future__ import annotations

from collections.abc import Iterator

from rich.console import RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from chasles.coq.recorded import checked_by_coq
from chasles.decisions.decision import HOW, Correction, Decision, key_of
from chasles.report.equations import in_both, in_latex, in_words, signature_in_words
from chasles.report.records import certificate_hash
from chasles.report.words import entry_in_words, point_in_words, said
from chasles.statements import Entry, Inverse, Statement
from chasles.statements.elsewhere import chapter_of, cited
from chasles.statements.inequalities import difference_of
from chasles.verdict import Counterexample, Fails, Verdict
from chasles.vocabulary import plain

Lines = Iterator[tuple[str, str]]


def number_in_words(number: str, part: int = 1) -> str:
    """A number as a reader looks for it: "(3.16)", "(3.4) part 2", "Thm 3.2.2"."""
    cited = f"({number})" if number[:1].isdecimal() else number
    return f"{cited} part {part}" if part > 1 else cited


def printed(entry: Entry, latex: bool = False) -> Lines:
    """The equations and what they say."""
    if isinstance(entry.statement, Inverse):
        for branch, equations in zip(entry.statement.branches, in_words(entry.statement), strict=True):
            yield "case", f"{branch.says}: {equations}"
    else:
        label = "printed" if isinstance(entry.statement, Statement) else "equations"
        yield from ((label, equation) for equation in in_words(entry.statement))
    if latex:
        yield from (("LaTeX", equation) for equation in in_latex(entry.statement))
    if entry.statement.says:
        yield "says", entry.statement.says


def said_of(entry: Entry) -> str:
    """What a statement says, in words where it has any, else as its equations."""
    return entry.statement.says or "; ".join(in_words(entry.statement))


def rests_on(entry: Entry, decision: Decision) -> Lines:
    """What is given and assumed, and which function is asked for."""
    for given in entry.statement.given:
        used = decision.given.get(key_of(given, entry.statement))
        how = f" ({HOW[used.form]})" if used is not None and used.form != "printed" else ""
        yield "given", f"{cited(given, chapter_of(entry.statement))} {given.says}{how}"
    for hypothesis in entry.statement.assuming:
        yield "assuming", hypothesis.text
    if call := signature_in_words(entry):
        yield "kernel", call


def objections(entry: Entry, decision: Decision) -> Lines:
    """Why the equation is wrong as printed and what is right, or which hypotheses it does not need."""
    yield from objections_to_print(decision)
    if decision.correction is not None and isinstance(entry.statement, Statement):
        yield from _instead(entry.statement, decision.correction)
    if unused := decision.verdict.unused:
        yield "unused", f"assumes {', '.join(unused)}, which it does not need"


def objections_to_print(decision: Decision) -> Lines:
    """Why the equation is wrong as printed."""
    if why := decision.verdict.reason:
        yield "because", why
    if isinstance(decision.verdict, Fails):
        yield from refuted(decision.verdict.counterexample, decision.statement)


def evidence(decision: Decision) -> Lines:
    """What anyone can check again: the certificate's hash and size, and a point that satisfies all that is assumed."""
    certificate = decision.certificate
    if certificate is not None:
        yield "certificate", str(certificate_hash(certificate))
    if checked := checked_by_coq(decision.statement):
        yield "Coq", checked.in_words
    if witness := getattr(decision.standing, "witness", None):
        yield "example", f"satisfies all that is assumed: {point_in_words(witness)}"


def indented(lines: Lines) -> RenderableType:
    """The lines in two columns; a label that repeats is shown once."""
    grid = Table.grid(padding=(0, 2, 0, 0))
    grid.add_column(style="dim", no_wrap=True)
    grid.add_column(overflow="fold")
    before = ""
    for label, text in lines:
        grid.add_row("" if label == before else label, Text(text))
        before = label
    return Padding(grid, (0, 0, 0, 2))


def refuted(found: Counterexample, statement: object) -> Lines:
    """A counterexample: where, and what the sides come to there."""
    which = "; ".join(filter(None, (entry_in_words(found, statement), found.goal)))
    yield "at", point_in_words(found.at) or "every point"
    sides = statement.printed if isinstance(statement, Statement) else ()
    if sides and (difference := difference_of(*sides)) is not None and sides[1] == difference:
        yield "where", f"{plain(difference)} = {found.right}"
        return
    yield "left", f"{found.left}   ({which})" if which else found.left
    yield "right", found.right


def _instead(statement: Statement, correction: Correction) -> Lines:
    text, _ = in_both(correction.sides, statement.sign)
    how, verdict = HOW[correction.form], correction.verdict
    yield "instead", text
    yield "", ": ".join(filter(None, (f"{how}, it {_predicate(verdict)}", verdict.reason)))
    if isinstance(verdict, Fails):
        yield from refuted(verdict.counterexample, statement)


def _predicate(verdict: Verdict) -> str:
    words = said(verdict)
    return words if words.startswith(("holds", "fails")) else f"is {words}"
