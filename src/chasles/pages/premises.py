"""What a page has said so far: rules for symbols and their rates, and equations that are posed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from dataclasses import replace as with_fields

from chasles.pages.quantities import Quantity, quantities
from chasles.problems.scanning import differs
from chasles.statements import Claim, Hypothesis, Statement
from chasles.vocabulary import Integral, Negative, Node, Rate, Sum, Symbol, plain, walk
from chasles.vocabulary.letters import zero_of

Rules = Mapping[Quantity, Statement]
MOST_RATES = 6
"""No higher rate is replaced by what rules say: they may lead to ever higher ones."""


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
    used before; `proved` the last claim proved of it, `opened` the last open equation that says what it is; `said` are
    all of these in their order, `stated` the equations, and `spoken` is what has occurred; a section has
    `begun` behind so many of what is posed, said and stated.
    On what is `relied` a proved claim rests. What is `moving` has a rate somewhere on the page, what is `recurring`
    stands in several sides of its equations. What is `told` under a
    name is true, or it is `unproved` by its own.
    """

    facts: Callable[[Symbol], tuple[Hypothesis, ...]]
    definitions: dict[Quantity, list[Statement | None]] = field(default_factory=dict)
    proved: dict[Quantity, Statement] = field(default_factory=dict)
    opened: dict[Quantity, Statement] = field(default_factory=dict)
    said: list[Statement] = field(default_factory=list)
    posed: list[PosedEquation] = field(default_factory=list)
    spoken: set[Quantity] = field(default_factory=set)
    stated: list[Claim] = field(default_factory=list)
    begun: tuple[int, int, int] = (0, 0, 0)
    relied: set[str] = field(default_factory=set)
    told: dict[str, list[Claim]] = field(default_factory=dict)
    unproved: set[str] = field(default_factory=set)
    moving: frozenset[Symbol] = frozenset()
    recurring: frozenset[Symbol] = frozenset()
    resting: dict[Symbol, PosedEquation] = field(default_factory=dict)

    def begin_section(self) -> None:
        """From here on another section."""
        self.begun = len(self.posed), len(self.said), len(self.stated)

    @property
    def posed_here(self) -> list[PosedEquation]:
        """The equations that this section has posed."""
        return self.posed[self.begun[0] :]

    @property
    def opened_here(self) -> Rules:
        """The open equations of this section that say what a symbol is."""
        here = {id(each) for each in self.said[self.begun[1] :]}
        return {(symbol, order): each for (symbol, order), each in self.opened.items() if id(each) in here}

    @property
    def stated_before(self) -> list[Claim]:
        """The equations of earlier sections."""
        return self.stated[: self.begun[2]]

    def said_before(self, key: Quantity) -> Statement | None:
        """What an earlier section says that a quantity is, where this one does not say it."""
        rule = self.proved.get(key) or self.defined().get(key)
        here = {each.left for each in self.said[self.begun[1] :]}
        return None if rule is None or rule.left in here else rule

    def copy(self) -> Premises:
        """The same, to which something else may be added."""
        other = with_fields(self, definitions={q: list(known) for q, known in self.definitions.items()})
        other.told = {name: list(claims) for name, claims in self.told.items()}
        for name in ("proved", "opened", "said", "posed", "stated", "unproved", "spoken", "relied"):
            setattr(other, name, getattr(self, name).copy())
        return other

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

    def restricting(self, found: Iterable[Quantity], rules: Rules, tied: bool = False) -> tuple[PosedEquation, ...]:
        """The posed equations on symbols found; of those that the notation knows only where it knows all.

        If they are to be `tied`, none has a symbol that stands nowhere else: mostly it says what that symbol is.
        """
        ruled = {symbol for symbol, _ in rules}
        symbols = {symbol for symbol, _ in found if symbol not in ruled}
        unknown = {symbol for symbol in symbols if not self.facts(symbol)}
        chosen: dict[int, set[Symbol]] = {}
        for place, each in enumerate(self.posed):
            free = _free(each, rules)
            if free & (unknown if any(not self.facts(symbol) for symbol in free) else symbols):
                chosen[place] = free
        while tied:
            occurring = Counter(symbol for free in chosen.values() for symbol in free)
            kept = {k: free for k, free in chosen.items() if all(s in symbols or occurring[s] > 1 for s in free)}
            tied = len(kept) < len(chosen)
            chosen = kept
        return tuple(self.posed[place] for place in chosen)

    def at_rest(self, sides: Iterable[Node], rules: Rules) -> tuple[PosedEquation, ...]:
        """That each symbol is constant of which a rate remains once rules are applied, and none is on the page.

        None of those that the page defines: they are what it says that they are.
        """
        found = sorted((each for side in sides for each in _remaining(side, rules)), key=str)
        known = self.moving.union(symbol for symbol, _ in self.defined())
        still = dict.fromkeys(symbol for symbol, order in found if order and symbol not in known)
        for symbol in still.keys() - self.resting.keys():
            sides = Rate(symbol), zero_of(symbol.shape)
            self.resting[symbol] = PosedEquation(posed(f"{plain(symbol)} is constant", *sides), *sides, open=False)
        return tuple(map(self.resting.__getitem__, still))

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


def posed(said: str, left: Node, right: Node) -> Hypothesis:
    """An equation as a free hypothesis, which is told as `said`."""
    return Hypothesis("posed", (Sum((left, Negative(right))),), ((left, right),), (), said, said, free=True)


def _restated(fact: Hypothesis) -> Hypothesis:
    """A hypothesis on a symbol, as its equations between expressions."""
    differences = tuple(Sum((left, Negative(right))) for left, right in fact.equations)
    return with_fields(fact, kind="posed", subjects=differences, free=True) if differences else fact


def _free(posed: PosedEquation, rules: Rules) -> set[Symbol]:
    """The symbols of a posed equation on which it depends, definitions applied."""
    chosen = chosen_rules((posed.left, posed.right), rules)
    return {s for s, _ in free_quantities((posed.left, posed.right), chosen)}


def rule_for(found: Quantity, rules: Rules) -> Quantity | None:
    """The rule that says most of the quantity: that for its highest rate."""
    symbol, order = found
    return next(((symbol, k) for k in range(order, -1, -1) if (symbol, k) in rules), None)


def chosen_rules(sides: Iterable[Node], rules: Rules, deep: bool = True) -> dict[Quantity, Statement]:
    """The rules for what occurs in the sides and, if `deep`, in what they say.

    None leads back to itself, or makes something the same for all elements of a body that an integral is taken over.
    """
    sides = tuple(sides)
    while True:
        chosen = _reached(sides, rules, deep)
        same = _same_for_all_elements(sides, chosen)
        if not same:
            return chosen
        rules = {key: rule for key, rule in rules.items() if key not in same}


def last_said(rules: Rules, place: Mapping[int, int]) -> Rules:
    """The rules without those for rates of what has been said anew since; `place` is that of each statement."""
    when: dict[Symbol, dict[int, int]] = {}
    for (symbol, order), rule in rules.items():
        when.setdefault(symbol, {})[order] = place.get(id(rule), -1)
    return {
        (symbol, order): rule
        for (symbol, order), rule in rules.items()
        if not any(k < order and said > when[symbol][order] for k, said in when[symbol].items())
    }


def balancing(left: Node, right: Node, rules: Rules, place: Mapping[int, int]) -> Iterator[dict[Quantity, Statement]]:
    """Ever more rules, each for a quantity that occurs on one side only: of several the one that was said last.

    `place` is that of each statement, by its identity.
    """
    chosen: dict[Quantity, Statement] = {}
    refused: set[Quantity] = set()
    while True:
        one, other = (_remaining(side, chosen) for side in (left, right))
        behind = (rule_for(each, rules) for each in one ^ other)
        keys = {key for key in behind if key is not None and key not in chosen and key not in refused}
        if not keys:
            return
        key = max(keys, key=lambda each: place.get(id(rules[each]), -1))
        more = chosen_rules((left, right), {**chosen, key: rules[key]})
        if key in more and chosen.keys() <= more.keys():
            yield (chosen := more)
        else:
            refused.add(key)


def _remaining(side: Node, chosen: Rules) -> set[Quantity]:
    """The quantities in a side once rules are applied."""
    found: set[Quantity] = set()
    reached = dict.fromkeys(quantities(side))
    waiting = [*reached]
    while waiting:
        each = waiting.pop()
        key = rule_for(each, chosen)
        if key is None or each[1] > MOST_RATES:
            found.add(each)
            continue
        more = dict.fromkeys(quantities(chosen[key].right, each[1] - key[1]))
        waiting += [other for other in more if other not in reached]
        reached.update(more)
    return found


def _same_for_all_elements(sides: Iterable[Node], chosen: Rules) -> set[Quantity]:
    """The rules that say of what an integral is taken over that it is the same for all elements."""
    behind = (*sides, *(rule.right for rule in chosen.values()))
    integrals = [part for side in behind for part in walk(side) if isinstance(part, Integral)]
    ruled: dict[Node, Node] = {symbol: rule.right for (symbol, order), rule in chosen.items() if not order}
    return {
        (symbol, 0)
        for integral in integrals
        for symbol in integral.running
        if symbol in ruled and not differs(ruled[symbol], integral.running, ruled)
    }


def _reached(sides: Iterable[Node], rules: Rules, deep: bool) -> dict[Quantity, Statement]:
    chosen: dict[Quantity, Statement] = {}
    visiting: set[Quantity] = set()
    done: set[Quantity] = set()
    circular: set[Quantity] = set()

    def is_circular(found: Quantity) -> bool:
        key = rule_for(found, rules)
        if key in visiting:
            return True
        if key is None or found in done:
            return False
        visiting.add(key)
        below = quantities(rules[key].right, found[1] - key[1]) if deep else ()
        leads_back = [is_circular(each) for each in dict.fromkeys(below)]
        visiting.discard(key)
        done.add(found)
        if any(leads_back):
            circular.add(key)
        chosen[key] = rules[key]
        return False

    for found in dict.fromkeys(q for side in sides for q in quantities(side)):
        is_circular(found)
    return {key: rule for key, rule in chosen.items() if key not in circular}


def free_quantities(sides: Iterable[Node], chosen: Rules) -> dict[Quantity, None]:
    """The quantities in the sides and in the rules chosen, the rules' own among them."""
    everything = (*sides, *(rule.right for rule in chosen.values()))
    return dict.fromkeys(q for side in everything for q in quantities(side))
