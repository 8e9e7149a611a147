"""Whether a relation can follow from premises: what differs at a random motion that satisfies them does not.

What agrees there is a conjecture, which the prover then decides.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cached_property, lru_cache
from hashlib import sha256
from typing import Any

import numpy as np

from chasles.motions.random_motion import TERMS, NotInMotion, RandomMotion, TooFewTerms, ValuesInMotion
from chasles.motions.satisfying_motion import Pair, Running, equal, satisfying
from chasles.pages.premises import PosedEquation, Rules, chosen_rules
from chasles.pages.quantities import quantities
from chasles.statements import Hypothesis
from chasles.statements.fingerprint import Fingerprints
from chasles.statements.rules import rated
from chasles.vocabulary import Integral, Node, Symbol, walk


class Digests(Fingerprints):
    """Hashes of expressions by those of their parts and by what their letters mean: of a changed one little is new."""

    def key(self, node: Node) -> str:
        """The hash of an expression, with what it means where it is a letter."""
        waiting, new = [node], list[Node]()
        while waiting:
            if id(part := waiting.pop()) not in self._hashes:
                new.append(part)
                waiting += part.below
        for part in reversed(new):  # of the parts first, however deep
            self.of(part)
        return str(self._plain(node))

    def _plain(self, value: Any) -> Any:
        if not isinstance(value, Node):
            return super()._plain(value)
        return f"{self.of(value)} {value.meaning}" if isinstance(value, Symbol) else self.of(value)


class Consequences:
    """Tells what may follow at one random motion; what satisfies the same equations is found once."""

    def __init__(
        self,
        facts: Callable[[Symbol], tuple[Hypothesis, ...]],
        known: dict[str, bool | None] | None = None,
        start: int = 0,
    ) -> None:
        self.motion = RandomMotion(facts, start=start)
        self._facts, self._start = facts, start
        self._known = {} if known is None else known
        self._digests = Digests()
        self._found: dict[tuple[frozenset[Pair], frozenset[Pair], int], RandomMotion | NotInMotion | None] = {}
        self._last: ValuesInMotion | None = None

    @cached_property
    def elsewhere(self) -> Consequences:
        """The same, told at another motion."""
        return Consequences(self._facts, self._known, self._start + 1)

    def may_follow(self, left: Node, right: Node, rules: Rules, posed: Sequence[PosedEquation] = ()) -> bool | None:
        """Whether two sides are equal with the rules applied where all that is posed holds; None where it is not known.

        What two rules say of one quantity and its rate holds too. Nothing follows where no motion satisfies all of it.
        """
        sides = (left, right, *(side for each in posed for side in (each.left, each.right)))
        told = (
            f"{self._digests.key(symbol)}{'.' * order} {self._digests.key(rule.right)}"
            for (symbol, order), rule in rules.items()
        )
        key = sha256("\n".join([*map(self._digests.key, sides), *sorted(told), "." * self._start]).encode()).hexdigest()
        if key not in self._known:
            self._known[key] = self._may_follow(left, right, rules, posed)
        return self._known[key]

    def _may_follow(self, left: Node, right: Node, rules: Rules, posed: Sequence[PosedEquation]) -> bool | None:
        pairs = (*((each.left, each.right) for each in posed), *_agreements(rules))
        spoken = (left, right, *(side for pair in pairs for side in pair), *(rule.right for rule in rules.values()))
        running = _running(spoken)
        orders = (order for side in spoken for _, order in quantities(side))
        for terms in range(1 + max((*orders, *(order for _, order in rules)), default=0), TERMS + 1):
            try:
                with np.errstate(all="ignore"):
                    motion = self._satisfying(pairs, rules, running, terms) if pairs else self.motion
                    if motion is None:
                        return False
                    values = self._values(motion, rules, running, terms)
                    return equal(values(left), values(right))
            except TooFewTerms:
                continue
            except (NotInMotion, KeyError, TypeError, ValueError, RecursionError, np.linalg.LinAlgError):
                return None
        return None

    def _values(self, motion: RandomMotion, rules: Rules, running: Running, terms: int) -> ValuesInMotion:
        """The values under the same rules as before, if they are, so that what is in many sides is evaluated once."""
        last, said = self._last, _said(rules)
        if last is None or (last.motion, last.rules, last.running, last.terms) != (motion, said, running, terms):
            self._last = last = ValuesInMotion(motion, said, running, terms)
        return last

    def least(
        self, left: Node, right: Node, rules: Rules, posed: tuple[PosedEquation, ...]
    ) -> tuple[Rules, tuple[PosedEquation, ...]]:
        """Premises from which the same may follow without any one of them: what is posed goes first, then old rules."""
        for each in posed:
            fewer = tuple(other for other in posed if other is not each)
            if self.may_follow(left, right, rules, fewer):
                posed = fewer
        for key in tuple(rules):
            remaining = {other: rule for other, rule in rules.items() if other != key}
            if key in rules and self.may_follow(left, right, remaining, posed):
                rules = chosen_rules((left, right, *(s for each in posed for s in (each.left, each.right))), remaining)
        return rules, posed

    def _satisfying(self, pairs: Sequence[Pair], rules: Rules, running: Running, terms: int) -> RandomMotion | None:
        chosen = chosen_rules((side for pair in pairs for side in pair), rules)
        key = frozenset(pairs), frozenset(rule.printed for rule in chosen.values()), terms
        if key not in self._found:
            unsatisfied = any(found is None and k[0] <= key[0] and k[1] <= key[1] for k, found in self._found.items())
            try:
                self._found[key] = None if unsatisfied else satisfying(pairs, _said(rules), running, terms, self.motion)
            except NotInMotion as reason:
                self._found[key] = reason
        found = self._found[key]
        if isinstance(found, NotInMotion):
            raise found
        return found


def _said(rules: Rules) -> dict[Node, Node]:
    return {rated(*quantity): rule.right for quantity, rule in rules.items()}


def _running(sides: Iterable[Node]) -> Running:
    integrals = (each for side in sides for each in _integrals(side))
    return {symbol: symbol != each.density for each in integrals for symbol in each.running}


@lru_cache(maxsize=4096)
def _integrals(side: Node) -> tuple[Integral, ...]:
    return tuple(part for part in walk(side) if isinstance(part, Integral))


def _agreements(rules: Rules) -> Iterator[Pair]:
    """What it means that rules for a quantity and for its rate both hold."""
    for (symbol, order), rule in rules.items():
        lower = max((k for s, k in rules if s == symbol and k < order), default=None)
        if lower is not None:
            yield rated(rules[symbol, lower].right, order - lower), rule.right
