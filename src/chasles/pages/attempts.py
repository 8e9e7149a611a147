"""The premises with which a proof of a claim is tried, few before many, and all that the page says of it.

What the page leaves open is tried last: as a rule where it says what a symbol is, else as a hypothesis.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from dataclasses import replace as with_fields
from itertools import islice

from chasles.pages.consequences import Consequences
from chasles.pages.facts import divisors
from chasles.pages.premises import PosedEquation, Premises, Rules, balancing, chosen_rules, free_quantities, last_said
from chasles.pages.quantities import Quantity, quantities, quantity, symbols_in
from chasles.statements import Claim, Condition, Statement
from chasles.statements.rules import rated
from chasles.vocabulary import Node, Zero
from chasles.vocabulary.letters import zero_of

MOST_POSED = 4
"""So many posed equations, the last ones, are tried together for a proof."""
MOST_BALANCED = 8
"""So many rules for what occurs on one side only are tried together."""
MOST_WHOLE = 2
"""So many sets from which a claim is likely to follow are tried with what a random motion does not need, too."""
Known = tuple[Rules, tuple[PosedEquation, ...]]
"""Rules to apply and equations to assume."""


@dataclass(frozen=True, slots=True)
class Attempt:
    """The claim with some premises, from which it is `likely` to follow.

    `assumed` are the names of those among them that are no definitions, and that its verdict does not name by itself.
    """

    claim: Claim
    likely: bool
    assumed: tuple[str, ...] = ()


def attempts(
    claim: Claim, premises: Premises, consequences: Consequences, cited: Iterable[Known] = ()
) -> Iterator[Attempt]:
    """The claim with premises from which it may follow, few before many, each set once; early those that are cited."""
    seen: set[tuple[frozenset[int], frozenset[int]]] = set()
    asked: set[tuple[frozenset[int], frozenset[int]]] = set()

    def chosen() -> Iterator[tuple[bool, Known]]:
        whole: list[Known] = []
        for tried in _premise_sets(claim, premises, cited):
            likely = consequences.may_follow(*claim.printed, *tried) if _is_new(*tried, asked) else False
            if likely:
                whole.append(tried)
            if likely is not False:
                yield bool(likely), consequences.least(*claim.printed, *tried) if likely else tried
        yield from ((True, each) for each in whole[-MOST_WHOLE:])

    for likely, known in chosen():
        if _is_new(*known, seen) and not _vanishes(claim, known, premises, consequences):
            attempt = with_premises(claim, premises, *known)
            names = tuple(name for name in map(named, attempt.given) if name in premises.unproved)
            yield from ways(Attempt(attempt, likely, names), premises, known[1])


def _vanishes(claim: Claim, known: Known, premises: Premises, consequences: Consequences) -> bool:
    """Whether what is posed or left open makes both sides and a letter or a rate vanish, and no side is zero in print.

    That says nothing.
    """
    free = (rated(*found) for found in free_quantities(claim.printed, known[0]))
    is_defined = not known[1] and not any(rule in premises.opened.values() for rule in known[0].values())
    if is_defined or any(side == zero_of(side.shape) or isinstance(side, Zero) for side in claim.printed):
        return False
    told = consequences, consequences.elsewhere  # nothing may be left of a motion by chance
    vanish = (all(at.may_follow(each, zero_of(each.shape), *known) for at in told) for each in (*claim.printed, *free))
    return next(vanish) and next(vanish) and any(vanish)


def ways(attempt: Attempt, premises: Premises, posed: tuple[PosedEquation, ...]) -> Iterator[Attempt]:
    """An attempt that is likely by solving the posed equations for what the claim is about; then as it is."""
    if attempt.likely:
        for solved, names in solving(attempt.claim, premises, posed):
            yield Attempt(solved, True, (*attempt.assumed, *names))
    yield attempt


def _is_new(rules: Rules, posed: tuple[PosedEquation, ...], seen: set[tuple[frozenset[int], frozenset[int]]]) -> bool:
    key = frozenset(map(id, rules.values())), frozenset(map(id, posed))
    if key in seen:
        return False
    seen.add(key)
    return True


def _premise_sets(claim: Claim, premises: Premises, cited: Iterable[Known]) -> Iterator[Known]:
    """Rules to apply and equations to assume: nothing, what is said of what occurs, all that this rests on."""
    sides = claim.printed
    defined = [premises.defined(generation) for generation in range(premises.generations)]
    place = {id(each): k for k, each in enumerate(premises.said)}
    tables = [table for each in defined for table in ({**each, **premises.proved}, {**premises.proved, **each})]
    yield {}, ()
    shallow: Rules = chosen_rules(sides, tables[0], deep=False)
    yield shallow, ()
    yield from cited
    yield chosen_rules(sides, last_said(tables[0], place), deep=False), ()
    found: list[Rules] = [shallow]
    with_open = {**tables[0], **premises.opened}
    for table in (tables[0], with_open):
        last: Rules = {}
        for last in islice(balancing(*sides, table, place), MOST_BALANCED):
            yield last, ()
        found.append(last)
    yield next(iter(deque(balancing(*sides, tables[1], place), maxlen=1)), {}), ()
    for table in (*tables, with_open):
        yield chosen_rules(sides, table), ()
        yield chosen_rules(sides, last_said(table, place)), ()
    last_of_all: list[Known] = []
    for rules, tied in (*((rules, True) for rules in ({}, *found)), (shallow, False)):
        known = premises.restricting(free_quantities(sides, rules), rules, tied)
        posed = tuple(each for each in known if not each.is_rule)[-MOST_POSED:]
        if posed:
            yield rules, posed
        if resting := premises.at_rest(sides, rules):
            last_of_all += [(rules, resting), (rules, (*posed, *resting))]
    yield chosen_rules(sides_of(claim, posed), with_open), posed
    yield from last_of_all


def with_premises(
    claim: Claim, premises: Premises, rules: Rules, posed: tuple[PosedEquation, ...], everything: bool = False
) -> Claim:
    """The claim with rules, posed equations, and what is known of the symbols in them."""
    said = sides_of(claim, posed)
    found = free_quantities(said, rules)
    facts = premises.assumed(found, rules, everything)
    assuming = dict.fromkeys((*facts, *divisors(said), *(each.hypothesis for each in posed)))
    return with_fields(claim, given=tuple(rules.values()), assuming=tuple(assuming), sic=False)


def solving(
    claim: Claim, premises: Premises, posed: tuple[PosedEquation, ...]
) -> Iterator[tuple[Claim, tuple[str, ...]]]:
    """The claim on a letter with the posed equations on it as conditions, and their names.

    They determine it alone, or with what stands nowhere else.
    """
    for side, other in (claim.printed, claim.printed[::-1]):
        key = quantity(side)
        conditions = [each for each in posed if key in _spoken_of(each)]
        if key is None or key[1] or key in quantities(other) or not conditions:
            continue
        rest = [side for each in posed if each not in conditions for side in (each.left, each.right)]
        rest += [side for rule in claim.given if isinstance(rule, Statement) for side in rule.printed]
        elsewhere = symbols_in((other, *rest))
        spoken = dict.fromkeys(symbol for each in conditions for symbol, _ in _spoken_of(each))
        more = tuple(s for s in spoken if s != key[0] and s not in elsewhere and not premises.facts(s))
        names = tuple(each.hypothesis.text for each in conditions)
        others = tuple(h for h in claim.assuming if h not in [each.hypothesis for each in conditions])
        for on in dict.fromkeys(((key[0],), (key[0], *more))):
            given = (Condition(name, c.left, c.right, on=on) for name, c in zip(names, conditions, strict=True))
            yield with_fields(claim, given=(*claim.given, *given), assuming=others), names


def _spoken_of(posed: PosedEquation) -> tuple[Quantity, ...]:
    return (*quantities(posed.left), *quantities(posed.right))


def all_said(claim: Claim, premises: Premises, generation: int) -> Known:
    """All that the page says of the symbols of a claim, open equations among it."""
    rules = chosen_rules(claim.printed, premises.defined(generation))
    posed = premises.relevant_to(free_quantities(claim.printed, rules))
    return chosen_rules(sides_of(claim, posed), premises.defined(generation)), posed


def known_of(claim: Claim, premises: Premises) -> Iterator[Known]:
    """What is known of a claim's symbols: by their kinds; what the page does not leave open; all of this section."""
    defined = premises.defined()
    deep = chosen_rules(claim.printed, defined)
    known = premises.restricting(free_quantities(claim.printed, deep), deep)
    posed = tuple(each for each in known if not each.open)[-MOST_POSED:]
    first = chosen_rules(sides_of(claim, posed), defined), posed
    if any(premises.facts(symbol) for symbol, _ in first[0]):
        of_no_kind = {key: rule for key, rule in defined.items() if not premises.facts(key[0])}
        yield chosen_rules(claim.printed, of_no_kind), ()
    yield first
    table = {**defined, **premises.proved, **premises.opened_here}
    deep = chosen_rules(claim.printed, table)
    known = premises.restricting(free_quantities(claim.printed, deep), deep)
    posed = tuple(each for each in known if each in premises.posed_here and not each.is_rule)[-MOST_POSED:]
    second = chosen_rules(sides_of(claim, posed), table), posed
    if second != first:
        yield second


def sides_of(claim: Claim, posed: Iterable[PosedEquation]) -> tuple[Node, ...]:
    """The sides of the claim, and those of posed equations."""
    return (*claim.printed, *(side for each in posed for side in (each.left, each.right)))


def named(statement: Statement) -> str:
    """The number under which what a statement says is assumed, and its part."""
    return f"({statement.number})" if statement.part == 1 else f"({statement.number}/{statement.part})"
