"""What a page has said so far: rules for symbols and their rates, and equations that are posed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from dataclasses import replace as with_fields

from chasles.statements import Hypothesis, Statement
from chasles.statements.statement import bare
from chasles.vocabulary import Negative, Node, Rate, Sum, Symbol, undotted
from chasles.vocabulary.families import Member

__all__ = ["PosedEquation", "Premises", "Quantity", "Rules", "chosen_rules", "free_quantities", "quantities",
           "quantity"]  # fmt: skip

Quantity = tuple[Symbol, int]
"""A symbol and how often it is dotted."""
Rules = Mapping[Quantity, Statement]


@dataclass(frozen=True, slots=True)
class PosedEquation:
    """An equation that nothing proves: a condition or a law, or `open` where that is not known.

    One that `is_rule` is open, and says what a symbol is.
    """

    hypothesis: Hypothesis
    left: Node
    right: Node
    open: bool
    is_rule: bool = False


@dataclass(slots=True)
class Premises:
    """What is known of symbols before an equation: `facts` come from the notation, all else from the page.

    `definitions` has for each quantity what the page has said it to be, the last first, and None at the end if it was
    used before; `proved` the last claim proved of it, `opened` the last open equation that says what it is; `spoken`
    is what has occurred.
    """

    facts: Callable[[Symbol], tuple[Hypothesis, ...]]
    definitions: dict[Quantity, list[Statement | None]] = field(default_factory=dict)
    proved: dict[Quantity, Statement] = field(default_factory=dict)
    opened: dict[Quantity, Statement] = field(default_factory=dict)
    posed: list[PosedEquation] = field(default_factory=list)
    spoken: set[Quantity] = field(default_factory=set)

    def copy(self) -> Premises:
        """The same, to which something else may be added."""
        definitions = {q: list(known) for q, known in self.definitions.items()}
        rules = dict(self.proved), dict(self.opened)
        return Premises(self.facts, definitions, *rules, list(self.posed), set(self.spoken))

    def defined(self, generation: int = 0) -> Rules:
        """The rules of the definitions; of an older `generation` those before them, or none for what was free then."""
        chosen = {q: known[min(generation, len(known) - 1)] for q, known in self.definitions.items()}
        return {q: statement for q, statement in chosen.items() if statement is not None}

    @property
    def generations(self) -> int:
        """How many definitions a symbol has at most."""
        return max(map(len, self.definitions.values()), default=1)

    def assumed(self, found: Iterable[Quantity], rules: Rules, everything: bool) -> tuple[Hypothesis, ...]:
        """The facts of the symbols; of those that a rule replaces, if `everything`, as equations on what it says."""
        ruled = {symbol for symbol, order in rules if order == 0}
        symbols = dict.fromkeys(symbol for symbol, _ in found)
        facts = [fact for symbol in symbols if symbol not in ruled for fact in self.facts(symbol)]
        said = [_restated(fact) for symbol in symbols if everything and symbol in ruled for fact in self.facts(symbol)]
        return (*facts, *said)

    def restricting(self, found: Iterable[Quantity], rules: Rules) -> tuple[PosedEquation, ...]:
        """The posed equations on symbols found; of those that the notation knows only where it knows all."""
        ruled = {symbol for symbol, _ in rules}
        symbols = {symbol for symbol, _ in found if symbol not in ruled}
        unknown = {symbol for symbol in symbols if not self.facts(symbol)}
        chosen = []
        for each in self.posed:
            free = _free(each, rules)
            if free & (unknown if any(not self.facts(symbol) for symbol in free) else symbols):
                chosen.append(each)
        return tuple(chosen)

    def relevant_to(self, found: Iterable[Quantity]) -> tuple[PosedEquation, ...]:
        """The posed equations that share symbols with those found, or with equations that do."""
        rules = self.defined()
        reached = {symbol for symbol, _ in found}
        chosen: list[PosedEquation] = []
        while True:
            more = [each for each in self.posed if each not in chosen and reached & _free(each, rules)]
            if not more:
                return tuple(each for each in self.posed if each in chosen)
            chosen += more
            reached |= {symbol for each in more for symbol in _free(each, rules)}


def _restated(fact: Hypothesis) -> Hypothesis:
    """A hypothesis on a symbol, as its equations between expressions."""
    differences = tuple(Sum((left, Negative(right))) for left, right in fact.equations)
    return with_fields(fact, kind="posed", subjects=differences, free=True) if differences else fact


def _free(posed: PosedEquation, rules: Rules) -> set[Symbol]:
    """The symbols of a posed equation on which it depends, definitions applied."""
    chosen = chosen_rules((posed.left, posed.right), rules)
    return {s for s, _ in free_quantities((posed.left, posed.right), chosen)}


def quantity(node: Node) -> Quantity | None:
    """The symbol, or rate of one, that a side is; None for anything else, and for an abbreviation."""
    base, order = undotted(bare(node))
    base = bare(base)
    return (base, order) if isinstance(base, Symbol) and base.stands_for is None else None


def quantities(node: Node, order: int = 0) -> Iterator[Quantity]:
    """The symbols that occur and how often they are dotted, abbreviations opened."""
    match node:
        case Symbol(stands_for=None):
            yield node, order
        case Symbol(stands_for=Node() as meant):
            yield from quantities(meant, order)
        case Rate(of):
            yield from quantities(of, order + 1)
        case Member(family):
            for member in family.members:
                yield from quantities(member, order)
        case _:
            for part in node.below:
                yield from quantities(part, order)


def rule_for(found: Quantity, rules: Rules) -> Quantity | None:
    """The rule that says most of the quantity: that for its highest rate."""
    symbol, order = found
    return next(((symbol, k) for k in range(order, -1, -1) if (symbol, k) in rules), None)


def chosen_rules(sides: Iterable[Node], rules: Rules, deep: bool = True) -> dict[Quantity, Statement]:
    """The rules for what occurs in the sides and, if `deep`, in what they say; none that leads back to itself."""
    chosen: dict[Quantity, Statement] = {}
    visiting: set[Quantity] = set()
    done: set[Quantity] = set()

    def is_circular(found: Quantity) -> bool:
        key = rule_for(found, rules)
        if key is None or key in done:
            return False
        if key in visiting:
            return True
        visiting.add(key)
        below = quantities(rules[key].right, found[1] - key[1]) if deep else ()
        leads_back = [is_circular(each) for each in dict.fromkeys(below)]
        visiting.discard(key)
        done.add(key)
        if not any(leads_back):
            chosen[key] = rules[key]
        return False

    for found in dict.fromkeys(q for side in sides for q in quantities(side)):
        is_circular(found)
    return chosen


def free_quantities(sides: Iterable[Node], chosen: Rules) -> dict[Quantity, None]:
    """The quantities in the sides and in the rules chosen, the rules' own among them."""
    everything = (*sides, *(rule.right for rule in chosen.values()))
    return dict.fromkeys(q for side in everything for q in quantities(side))
