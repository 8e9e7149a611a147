"""What a derivative takes for independent, and an equation that is given ties to what it is taken by."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from chasles.statements import Claim, Condition, Statement, Theorem
from chasles.statements.definitions import definitions_behind
from chasles.statements.goals import AcceptedSides
from chasles.statements.posing import said_by
from chasles.statements.statement import bare, is_rule
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Node, Symbol, undotted
from chasles.vocabulary.fields import Field
from chasles.vocabulary.partial import PartialDerivative


def tied_by(statement: Statement | Theorem, accepted: AcceptedSides) -> str:
    """Which letter is differentiated as if nothing tied it to what it is differentiated by; empty if there is none.

    A given claim with anything but a letter on its left ties the letters that are defined behind it, a condition on
    nothing all its letters; unless what is given says what they are.
    """
    derivatives = [
        part for side in said_by(statement, "printed") for part in opened_parts(side)
        if isinstance(part, PartialDerivative)
    ]  # fmt: skip
    if not derivatives:
        return ""
    rules = {bare(each.left): accepted(each)[1] for each in statement.given if is_rule(each)}
    posed = {symbol for each in statement.given if isinstance(each, Condition) for symbol in each.on}
    for told in statement.given:
        if is_rule(told) or not (isinstance(told, Claim) or (isinstance(told, Condition) and not told.on)):
            continue
        letters: set[Node] = {letter for side in accepted(told) for letter in _letters(side, {})}
        if isinstance(told, Claim):
            defined: set[Node] = {undotted(bare(each.left))[0] for each in definitions_behind((told,))}
        else:
            defined = letters
        for each in derivatives:
            by = {*_letters(each.by, {})}
            of = {*_letters(each.of, rules)} - by - posed - rules.keys()
            if letters & by and (tied := sorted(map(str, letters & defined & of))):
                return f"({told.number}) ties {tied[0]} to {each.by}, by which it is differentiated: say what it is"
    return ""


def _letters(node: Node, rules: Mapping[Node, Node]) -> Iterator[Symbol]:
    """The symbols of an expression, of what they are by rules too; what fields depend on is known of them."""
    waiting, seen = [node], set[Node]()
    while waiting:
        for part in opened_parts(waiting.pop()):
            if part not in seen:
                seen.add(part)
                waiting += [rules[part]] if part in rules else []
                if isinstance(part, Symbol) and not isinstance(part, Field):
                    yield part
