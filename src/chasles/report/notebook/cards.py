"""What is displayed of each kind of thing."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from functools import singledispatch
from typing import Any

from markupsafe import Markup, escape

from chasles.compiling.kernel import CompiledKernel
from chasles.decisions.decision import Certificate, Decision
from chasles.deriving import CheckedDerivation
from chasles.emitted import EmittedKernel
from chasles.pages.findings_told import told
from chasles.pages.page import ReadPage
from chasles.pages.page_equation import PageEquation
from chasles.repairs.repair import Repair
from chasles.report.details import number_in_words
from chasles.report.equations import signature_in_words
from chasles.report.html.certificates import CODE
from chasles.report.html.derivations import derivation_view
from chasles.report.html.formulas import with_formulas
from chasles.report.html.shown import Card, Fact, badge_of
from chasles.report.html.statements import as_printed, equation, expression, part_of
from chasles.report.notebook.alone import Alone, cited, entry_of, rests_on, sections_of
from chasles.report.records import certificate_hash
from chasles.report.words import entry_in_words, number_of, point_in_words
from chasles.statements import Chapter, Entry
from chasles.statements.derivation import Derivation
from chasles.verdict import Counterexample, Verdict
from chasles.vocabulary import Node


@singledispatch
def card_of(value: object) -> Card:
    """What is displayed. Raises TypeError for what is not."""
    raise TypeError(f"nothing is known of how to display {type(value).__name__}")


@card_of.register
def _(value: Node) -> Card:
    return Card(equations=(expression(value),))


@card_of.register
def _(value: Entry) -> Card:
    book, sentence = Alone(value.statement), value.statement
    assumed = tuple(book.condition(hypothesis.text) for hypothesis in sentence.assuming)
    facts = {
        "assuming": Markup(", ").join(assumed),
        "rests on": escape(cited(rests_on(sentence))),
        "kernel": CODE.format(signature_in_words(value)) if value.kernels and value.name else Markup(),
        "declared as": CODE.format(value.name) if value.name else Markup(),
    }
    return Card(
        title=number_in_words(sentence.number, sentence.part),
        says=sentence.says,
        quiet=sentence.role,
        equations=as_printed(sentence, ()),
        facts=_told(facts),
    )


@card_of.register
def _(value: Decision) -> Card:
    entry = entry_of(value.statement)
    part = part_of(Alone(value.statement), entry, value, ())
    return Card(
        title=number_in_words(value.statement.number, value.statement.part),
        badges=(part.badge,),
        needs=part.needs,
        says=part.says,
        quiet=part.role,
        equations=part.equations,
        facts=(*part.why, *_standing(value, part.facts)),
        instead=part.instead,
        slip=part.slip,
    )


@card_of.register
def _(value: Verdict) -> Card:
    found = getattr(value, "counterexample", None)
    certificate = getattr(value, "certificate", None)
    witness = getattr(value, "witness", None)
    return Card(
        badges=(badge_of(value.name),),
        needs=tuple(map(escape, value.needs)),
        says=value.reason,
        facts=(
            *(_refuted(found) if found is not None else ()),
            *_told({"not needed": escape(", ".join(value.unused))}),
            *(_certified(certificate) if certificate is not None else ()),
            *_told({"for example at": CODE.format(point_in_words(witness)) if witness else Markup()}),
        ),
    )


@card_of.register
def _(value: Counterexample) -> Card:
    return Card(title="A counterexample", facts=tuple(_refuted(value)))


@card_of.register
def _(value: Certificate) -> Card:
    """By what is divided, step by step; all of it as JSON, to be opened."""
    whole = json.dumps(value, indent=1, ensure_ascii=False, default=str)
    return Card(
        title="A certificate",
        facts=(*_certified(value), *_told({"for example at": CODE.format(_witness(value)) if _witness(value) else ""})),
        head=("divided by", "which replaces"),
        rows=tuple((escape(name), CODE.format(replaced)) for name, replaced in _divisions(value)),
        code=(("The whole certificate", whole),),
    )


@card_of.register
def _(value: Repair) -> Card:
    sides = value.left, value.right
    facts = {term: with_formulas(words, sides) for term, words in
             (("changed", "; ".join(value.changes)), ("where", value.modulo or ""))}  # fmt: skip
    return Card(
        title="A repair",
        badges=(badge_of(value.verdict.name),),
        needs=tuple(map(escape, value.verdict.needs)),
        equations=(equation(value.left, value.right),),
        facts=_told(facts),
    )


@card_of.register
def _(value: CheckedDerivation) -> Card:
    view = derivation_view("", value)
    assumed = {"assuming": escape(", ".join(view.assuming))}
    return Card(
        title=number_in_words(view.number), says=view.says, quiet=view.outcome, facts=_told(assumed), steps=view.steps
    )


@card_of.register
def _(value: Derivation) -> Card:
    return Card(
        title=number_in_words(value.number),
        says=value.says,
        quiet=f"a derivation of {number_of(len(value.steps), 'step')}, not yet checked",
        facts=_told({"assuming": escape(", ".join(hypothesis.text for hypothesis in value.assuming))}),
        head=("step", "by"),
        rows=tuple((step.kind, cited(step.cited)) for step in value.steps),
    )


@card_of.register
def _(value: Chapter) -> Card:
    kernels = sum(len(entry.kernels) for entry in value)
    return Card(
        title=value.title,
        quiet=f"{number_of(len(value.entries), 'statement')} under {number_of(len(value.numbers), 'number')}, "
        f"{number_of(kernels, 'kernel')}",
        head=("section", "title", "numbers", "statements"),
        rows=tuple(sections_of(value)),
    )


@card_of.register
def _(value: ReadPage) -> Card:
    rows = tuple((str(each.printed.line), each.number, told(each)) for each in value.equations)
    return Card(title=value.file or "page", quiet=value.summary, head=("line", "number", "finding"), rows=rows)


@card_of.register
def _(value: PageEquation) -> Card:
    sides = () if value.part is None else (value.part.left, value.part.right)
    return Card(
        title=value.number, says=told(value), equations=tuple(e for side in sides for e in card_of(side).equations)
    )


@card_of.register
def _(value: EmittedKernel) -> Card:
    facts = {
        "signature": CODE.format(value.signature),
        "verdict": escape(value.verdict),
        "assumes": escape(", ".join(value.hypotheses) or "nothing"),
        "expects": escape(", ".join(value.expected)),
        "operations": escape(_counted(value.operations)),
        "error bound": escape("; ".join(value.bound)),
        "made of": escape("an offered form, proved equal to the statement" if value.form == "offered" else ""),
    }
    return Card(
        title=value.name, says=value.says, quiet=f"kernel of {number_in_words(value.number)}", facts=_told(facts)
    )


@card_of.register
def _(value: CompiledKernel) -> Card:
    facts = {
        "signature": CODE.format(value.signature),
        "operations": escape(_counted(value.operations)),
        "runs in": escape({"c": "compiled C", "numpy": "NumPy"}[value.backend]),
    }
    code = ("C", value.c_source), ("Python", value.numpy_source)
    return Card(title=value.name, quiet="kernel of an expression", facts=_told(facts), code=code)


def _told(facts: Mapping[str, Markup | str]) -> tuple[Fact, ...]:
    """The facts of which there is anything to tell."""
    return tuple(Fact(term, Markup(text)) for term, text in facts.items() if text)


def _standing(decision: Decision, facts: Iterable[Fact]) -> Iterator[Fact]:
    """What the report tells of what stands, but that it was checked again, which is not known here."""
    for fact in facts:
        if fact.term == "certificate" and decision.certificate is not None:
            yield from _certified(decision.certificate)
        elif fact.term != "declared as":
            yield fact


def _refuted(found: Counterexample) -> Iterator[Fact]:
    which = entry_in_words(found)
    if found.goal:
        yield Fact("what fails", escape(found.goal))
    yield Fact("at", CODE.format(point_in_words(found.at) or "every point"))
    yield Fact("the left side is", Markup("<code>{}</code>{}").format(found.left, which and f" in {which}"))
    yield Fact("the right side is", CODE.format(found.right))


def _certified(certificate: Mapping[str, Any]) -> Iterator[Fact]:
    yield Fact("certificate", CODE.format(certificate_hash(certificate)))


def _divisions(certificate: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """By what is divided, in every branch."""
    for branch in (certificate, *certificate.get("branches", {}).values()):
        yield from ((name, replaced) for name, replaced, *_ in branch.get("division", ()))


def _witness(certificate: Mapping[str, Any]) -> str:
    return point_in_words(certificate.get("witness", {}))


def _counted(operations: Mapping[str, int]) -> str:
    named = ", ".join(f"{count} {kind.replace('_', ' ')}" for kind, count in operations.items())
    return f"{sum(operations.values())}: {named}" if named else "none"
