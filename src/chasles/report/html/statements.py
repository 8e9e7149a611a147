"""What the page says of one statement: the printed equation, the verdict and why, what is right, what it rests on."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from xml.etree.ElementTree import Element

from markupsafe import Markup, escape

from chasles.coq.recorded import checked_by_coq
from chasles.decisions.session import Decision
from chasles.report.by_hand import Refutation, refutations
from chasles.report.details import number_in_words
from chasles.report.equations import Sentence, compared, in_both, labelled_equations
from chasles.report.findings import Replacement, likely_slip, replacements
from chasles.report.html.certificates import CODE, proof_in_words
from chasles.report.html.citing import Book, Link, place_of_number
from chasles.report.html.differences import mark_differences
from chasles.report.html.formulas import equation_tree, latex_for_mathml, markup, math, tree_of, with_formulas
from chasles.report.html.shown import Equation, Fact, KernelRow, Related, Repaired, StatementShown, badge_of
from chasles.report.records import certificate_hash
from chasles.report.words import entry_in_words, point_in_words
from chasles.statements import Entry, Statement
from chasles.statements.elsewhere import chapter_of, cited, other_chapter
from chasles.verdict import Fails, IllFormed
from chasles.vocabulary import Node, Rate, plain, symbols_of

Sides = tuple[Node, Node]


def place_of_part(entry: Entry) -> str:
    """The place of a statement on the page."""
    return f"{place_of_number(entry.number)}-part-{entry.statement.part}"


def part_of(book: Book, entry: Entry, decision: Decision, kernels: Sequence[KernelRow]) -> StatementShown:
    """All that is said of a statement; `kernels` are those that it asks for."""
    found = replacements(entry, decision)
    wrong = decision.verdict.wrong
    return StatementShown(
        place=place_of_part(entry),
        name=entry.name,
        role=entry.statement.role,
        says=entry.statement.says,
        badge=badge_of(decision.verdict.name),
        equations=as_printed(entry.statement, found),
        needs=tuple(map(book.condition, decision.needs)),
        why=tuple(_why(entry, decision)),
        instead=tuple(_repaired(book, entry, replacement) for replacement in found),
        slip=(likely_slip(entry, decision),) if wrong else (),
        related=tuple(each for each in _related(book, entry, kernels) if each.links),
        facts=tuple(_facts(book, entry, decision)),
    )


def equation(left: Node, right: Node, sign: str = "=", label: str = "") -> Equation:
    """An equation as the page shows it."""
    left, sign, right, mark = compared(left, right, sign)
    return Equation(markup(equation_tree(left, right, sign)), f"{plain(left)} {mark} {plain(right)}", label)


def expression(node: Node) -> Equation:
    """An expression as the page shows it."""
    return Equation(markup(tree_of(latex_for_mathml(node))), plain(node))


def as_printed(sentence: Sentence, found: Sequence[Replacement]) -> tuple[Equation, ...]:
    """The equations as printed; what was changed to make one right is marked."""
    if not isinstance(sentence, Statement):
        return tuple(equation(left, right, "=", label) for label, left, right in labelled_equations(sentence))
    tree = _tree(sentence)
    for replacement in found[:1]:
        mark_differences(tree, _tree(replacement))
    return (Equation(markup(tree), in_both((sentence.left, sentence.right), sentence.sign)[0]),)


def _tree(said: Statement | Replacement) -> Element:
    left, sign, right, _ = compared(said.left, said.right, said.sign)
    return equation_tree(left, right, sign)


def _why(entry: Entry, decision: Decision) -> Iterator[Fact]:
    """Why the equation is wrong as printed; what the reading or the correction comes to where that fails as well."""
    verdict = decision.verdict
    if isinstance(verdict, IllFormed):
        yield Fact("does not fit", with_formulas(verdict.reason, _sides(entry, decision)))
    elif not verdict.true and not isinstance(verdict, Fails):
        yield Fact("because", escape(verdict.reason))
    for refuted in refutations(decision):
        if refuted.form != "printed":
            read = "as likely read" if refuted.form == "reading" else "as corrected"
            yield Fact(read, Markup("{}, which fails too").format(_formula(*refuted.statement.printed)))
        yield from _by_hand(refuted, chapter_of(decision.statement))


def _sides(entry: Entry, decision: Decision) -> tuple[Node, ...]:
    """All sides that are known of an equation: as printed, as read, as corrected."""
    statement = entry.statement
    return (*statement.printed, *_read(statement), *decision.sides) if isinstance(statement, Statement) else ()


def _by_hand(refuted: Refutation, here: str) -> Iterator[Fact]:
    """The values, the left side and the right side there, and by which definitions."""
    found, by_hand = refuted.found, refuted.by_hand
    which = entry_in_words(found, refuted.statement)
    defining = (refuted.statement, *by_hand.left, *by_hand.right)
    known = _with_rates(side for given in defining for side in given.printed)
    if found.goal:
        yield Fact("what fails", escape(found.goal))
    yield Fact("at", with_formulas(point_in_words(found.at) or "every point", known, of_words=False))
    if by_hand.values:
        yield Fact("so that", with_formulas(point_in_words(by_hand.values), known, of_words=False))
    where = Markup("<code>{}</code>{}{}")
    yield Fact("the left side is", where.format(found.left, which and f" in {which}", _by(by_hand.left, here)))
    yield Fact("the right side is", Markup("<code>{}</code>{}").format(found.right, _by(by_hand.right, here)))


def _by(definitions: Iterable[Statement], here: str) -> Markup:
    listed = Markup(", ").join(_definition(each, here) for each in definitions)
    return Markup(", by {}").format(listed) if listed else Markup()


def _definition(given: Statement, here: str) -> Markup:
    """The number of a definition; if the book does not number it, what it says."""
    if other_chapter(given, here):
        return escape(cited(given, here))
    if given.number[0].isdigit():
        return Markup('<a href="#{}">{}</a>').format(
            place_of_number(given.number), number_in_words(given.number, given.part)
        )
    return _formula(*given.printed)


def _formula(left: Node, right: Node) -> Markup:
    """The equation within a line."""
    return math(f"{latex_for_mathml(left)} = {latex_for_mathml(right)}")


def _with_rates(sides: Iterable[Node]) -> list[Node]:
    """The sides, and the rates of their symbols: what the values of a point are the values of."""
    nodes = list(sides)
    return [*nodes, *(Rate(symbol) for node in nodes for symbol in symbols_of(node) if not symbol.constant)]


def _repaired(book: Book, entry: Entry, replacement: Replacement) -> Repaired:
    assert isinstance(entry.statement, Statement)
    after = _tree(replacement)
    mark_differences(_tree(entry.statement), after)
    words, _ = in_both((replacement.left, replacement.right), replacement.sign)
    sides = (*entry.statement.printed, *_read(entry.statement), replacement.left, replacement.right)
    changes = tuple(with_formulas(change, sides) for change in replacement.changes)
    return Repaired(Equation(markup(after), words), _stands(book, replacement), replacement.who_found, changes)


def _read(statement: Statement) -> Sides | tuple[()]:
    """The sides as they are likely to be read, where that is declared."""
    return () if statement.reading is None else statement.form("reading")


def _stands(book: Book, replacement: Replacement) -> Markup:
    """In which way it stands: it holds, under what, or it is the definition with which others hold."""
    if replacement.by:
        links = (
            Markup('<a href="#{}">{}</a>').format(place_of_number(number), number_in_words(number))
            for number in replacement.by
        )
        return Markup("is the definition with which {} hold").format(Markup(", ").join(links))
    needs = Markup(", ").join(book.condition(text) for text in replacement.verdict.needs)
    word = badge_of(replacement.verdict.name).word
    return Markup("{} {}").format(word, needs) if needs else escape(word)


def _related(book: Book, entry: Entry, kernels: Sequence[KernelRow]) -> Iterator[Related]:
    """What the statement rests on, what rests on it, and its kernels."""
    yield Related("rests on", book.links((basis.number, basis.part) for basis in Book.bases(entry)))
    yield Related("used by", book.links(user.key for user in book.used_by.get(entry.key, ())))
    calls = (Link(f"#{kernel.place}", f"{kernel.name} ({kernel.total} operations)") for kernel in kernels)
    yield Related("kernels", tuple(calls))


def _facts(book: Book, entry: Entry, decision: Decision) -> Iterator[Fact]:
    """What of others it rests on, what is assumed, what of it is not needed, the certificate, an example, the name."""
    here = chapter_of(entry.statement)
    if other := Book.elsewhere(entry):
        yield Fact("rests on", escape("; ".join(f"{cited(each, here)}: {each.says}" for each in other)))
    if assumed := Markup(", ").join(book.condition(h.text) for h in entry.statement.assuming):
        yield Fact("assuming", assumed)
    if unused := Markup(", ").join(book.condition(text) for text in decision.verdict.unused):
        yield Fact("not needed", unused)
    if decision.certificate is not None:
        yield Fact(
            "proof" if decision.verdict.true else "proof of what is right",
            Markup(" ").join(proof_in_words(book, decision.certificate)),
        )
        size = len(json.dumps(decision.certificate, separators=(",", ":"), ensure_ascii=False).encode())
        text = Markup("<code>{}</code>, {} bytes, checked again without the prover")
        yield Fact("certificate", text.format(certificate_hash(decision.certificate), f"{size:,}"))
    if checked := checked_by_coq(decision.statement):
        yield Fact("Coq", CODE.format(checked.in_words))
    if witness := getattr(decision.standing, "witness", None):
        statements = (entry.statement, *getattr(entry.statement, "given", ()))
        known = _with_rates(side for each in statements if isinstance(each, Statement) for side in each.printed)
        yield Fact("for example at", with_formulas(point_in_words(witness), known, of_words=False))
    yield Fact("declared as", CODE.format(entry.name))
