"""All that a statement rests on: what it is given, and what that rests on in turn, as far as it speaks of its letters.

What proves a statement may use less, but nothing refutes it that does not satisfy them all.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import replace as with_fields
from itertools import chain

from chasles.statements.goals import AcceptedSides
from chasles.statements.posing import Decidable, hypotheses_of, said_by
from chasles.statements.rules import fit_together
from chasles.statements.statement import Claim, Condition, Definition, Equation, Statement, bare, is_rule
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Integral, Inverse, Node, Quotient, Symbol, undotted

IN_FULL = "all premises"
"""What a certificate says that proves a statement given all that it rests on."""


def with_all_premises(statement: Decidable, accepted: AcceptedSides) -> Decidable:
    """The statement given all that it rests on, of which what it is given directly may say less; itself if that is all.

    Claims among it follow from the rest, which is given instead; what a letter is its definition says, where one does.
    """
    direct = {each: accepted(each) for each in statement.given}
    resting = {each: accepted(each) for each in _rested_on(statement.given)}
    parts = _parts(said_by(statement, "printed", [*direct.values(), *(h.subjects for h in hypotheses_of(statement))]))
    found: dict[Statement, Equation] = {}
    while more := {each: resting.pop(each) for each in [*resting] if not _letters(parts).isdisjoint(_about(each))}:
        found |= more
        parts |= _parts(chain.from_iterable(more.values()))
    if found.keys() <= direct.keys():
        return statement
    rules: list[Equation] = []
    given: list[Statement] = []
    for each, sides in sorted((found | direct).items(), key=lambda item: not isinstance(item[0], Definition)):
        rule = bare(sides[0]), sides[1]
        if isinstance(each, Condition):
            given.append(with_fields(each, on=()) if any(undotted(left)[0] in each.on for left, _ in rules) else each)
        elif is_rule(each) and fit_together([*rules, rule]):
            given.append(each)
            rules.append(rule)
        elif not isinstance(each, Definition | Claim) or any(isinstance(p, Inverse | Quotient) for p in _parts(sides)):
            given.append(each)
    return with_fields(statement, given=tuple(given))


def _rested_on(given: Iterable[Statement]) -> list[Statement]:
    """What is given, and of that on which it rests, all but claims and expansions; each once, the first first."""
    found = [*dict.fromkeys(given)]
    for each in found:
        found += [other for other in dict.fromkeys(each.relied_on) if other not in found]
    return [each for each in found if not isinstance(each, Claim) and not each.right.expands]


def _about(statement: Statement) -> Collection[Node]:
    """The letters that it is posed on or says what they are, else all that occur in it."""
    if isinstance(statement, Condition) and statement.on:
        return statement.on
    return (undotted(bare(statement.left))[0],) if is_rule(statement) else _letters(_parts(statement.printed))


def _parts(sides: Iterable[Node]) -> set[Node]:
    return {part for side in sides for part in opened_parts(side)}


def _letters(parts: set[Node]) -> set[Node]:
    """The symbols among these parts, but for those over which integrals are taken: no rule may say what they are."""
    running = frozenset[Node]().union(*(part.running for part in parts if isinstance(part, Integral)))
    return {part for part in parts - running if isinstance(part, Symbol)}
