"""All that a statement rests on: what it is given, and what that rests on in turn, as far as it speaks of its letters.

What proves a statement may use less, but nothing refutes it that does not satisfy them all.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace as with_fields
from itertools import chain

from chasles.statements.goals import AcceptedSides
from chasles.statements.hypotheses import nonzero
from chasles.statements.posing import Decidable, hypotheses_of, said_by
from chasles.statements.rules import fit_together
from chasles.statements.statement import Claim, Condition, Definition, Equation, Statement, bare, is_rule
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Integral, Node, Number, Quotient, Symbol, undotted

IN_FULL = "all premises"
"""What a certificate says that proves a statement given all that it rests on."""


def with_all_premises(statement: Decidable, accepted: AcceptedSides) -> Decidable:
    """The statement given all that it rests on, of which what it is given directly may say less; itself if that is all.

    Claims among it follow from the rest, which is given instead; what a letter is its definition says, where one does.
    """
    direct = {each: accepted(each) for each in statement.given}
    resting = {each: accepted(each) for each in _rested_on(statement.given)}
    parts = _parts((*said_by(statement, "printed"), *chain(*direct.values())))
    bound = _parts(subject for hypothesis in hypotheses_of(statement) for subject in hypothesis.subjects)
    found: dict[Statement, Equation] = {}
    while more := {each: resting.pop(each) for each in [*resting] if _is_about(each, _letters(parts), bound)}:
        found |= more
        parts |= _parts(chain(*more.values()))
    if found.keys() <= direct.keys():
        return statement
    rules, given, said, followed = list[Equation](), list[Statement](), set[Node](), list[Node]()
    for each in sorted(used := found | direct, key=lambda each: {Definition: 0, Claim: 2}.get(type(each), 1)):
        rule, letter = (bare(used[each][0]), used[each][1]), undotted(bare(used[each][0]))[0]
        if isinstance(each, Claim) and letter in said:
            followed += rule
        elif isinstance(each, Condition):
            given.append(with_fields(each, on=()) if said.intersection(each.on) else each)
            said |= {*each.on}
        elif not is_rule(each) or fit_together([*rules, rule]):
            given.append(each)
            rules += [rule] if is_rule(each) else []
            said |= {letter}
    below = {part.denominator for part in _parts(followed) if isinstance(part, Quotient)}
    needed = [nonzero(each) for each in sorted(below, key=str) if not isinstance(each, Number)]
    return with_fields(statement, given=tuple(given), assuming=(*statement.assuming, *needed))


def _rested_on(given: Iterable[Statement]) -> list[Statement]:
    """What is given and what that rests on, but for claims, expansions and moments of a body, which are any numbers."""
    found = [*dict.fromkeys(given)]
    for each in found:
        found += [other for other in dict.fromkeys(each.relied_on) if other not in found]
    defining = [each for each in found if not isinstance(each, Claim) and not each.right.expands]
    return [each for each in defining if not any(isinstance(part, Integral) for part in opened_parts(each.right))]


def _is_about(statement: Statement, letters: set[Node], bound: set[Node]) -> bool:
    """Whether it says what one of the letters is, or what one is by these of which something else is assumed, too."""
    all_letters = _letters(_parts(statement.printed))
    posed = statement.on if isinstance(statement, Condition) else ()
    said = posed or ((undotted(bare(statement.left))[0],) if is_rule(statement) else all_letters)
    return not letters.isdisjoint(said) or not (bound.isdisjoint(said) or letters.isdisjoint(all_letters))


def _parts(sides: Iterable[Node]) -> set[Node]:
    return {part for side in sides for part in opened_parts(side)}


def _letters(parts: set[Node]) -> set[Node]:
    """The symbols among these parts, but for those over which integrals are taken: no rule may say what they are."""
    running = frozenset[Node]().union(*(part.running for part in parts if isinstance(part, Integral)))
    return {part for part in parts - running if isinstance(part, Symbol)}
