"""Whether a relation can follow from premises: what differs at a random motion that satisfies them does not.

What agrees there is a conjecture, which the prover then decides.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property, lru_cache
from hashlib import sha256
from itertools import chain
from math import prod
from typing import Any

import numpy as np

from chasles.evaluation.matrices import Matrix
from chasles.pages.premises import PosedEquation, Rules, chosen_rules
from chasles.pages.quantities import quantities
from chasles.pages.random_motion import TERMS, Key, NotInMotion, RandomMotion, TooFewTerms, ValuesInMotion
from chasles.pages.time_series import Array, stacked
from chasles.statements import Hypothesis
from chasles.statements.fingerprint import Fingerprints
from chasles.statements.rules import rated
from chasles.vocabulary import Integral, Node, Symbol, walk

TOLERANCE = 1e-6
"""Relative to the size of what is compared: what is left of rounding is smaller, and mostly what differs is larger."""
STEPS = 24
"""So many steps Newton's method takes."""
SHORTER = (1, 1 / 2, 1 / 4, 1 / 8, 1 / 32)
"""The parts of a step of which the first is taken that leaves less."""
ENOUGH = 0.9
"""A step has to leave less than this of the equations."""
PRECISION = 1e-9
"""Relative to the size of the sides: what is left of equations that hold."""
DAMPING = 1e-12
"""Relative to the largest sum of squares: slopes below its root are not followed."""
MOST_NUMBERS = 600
"""With more free numbers no motion is looked for that satisfies equations."""
SMALL_CHANGE = 1e-7
"""Of a free number, by which slopes are found."""
MOTIONS_COMPARED = 2
"""At so many motions sides are compared, the first at which they are real: of angles more may be of other branches."""
Pair = tuple[Node, Node]
Running = Mapping[Symbol, bool]


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
                    return _equal(values(left), values(right))
            except TooFewTerms:
                continue
            except (NotInMotion, KeyError, TypeError, ValueError, RecursionError, np.linalg.LinAlgError):
                return None
        return None

    def _values(self, motion: RandomMotion, rules: Rules, running: Running, terms: int) -> ValuesInMotion:
        """The values under the same rules as before, if they are, so that what is in many sides is evaluated once."""
        last = self._last
        if last is None or (last.motion, last.rules_of, last.running, last.terms) != (motion, rules, running, terms):
            self._last = last = ValuesInMotion(motion, rules, running, terms)
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
                self._found[key] = None if unsatisfied else satisfying(pairs, rules, running, terms, self.motion)
            except NotInMotion as reason:
                self._found[key] = reason
        found = self._found[key]
        if isinstance(found, NotInMotion):
            raise found
        return found


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


def satisfying(
    equations: Sequence[Pair], rules: Rules, running: Running, terms: int, motion: RandomMotion
) -> RandomMotion | None:
    """A motion nearby at which equations hold with their rates, by Newton's method; None if there is none.

    Raises `NotInMotion` where it is not found soon, or there are too many numbers to look for.
    """
    known = motion.undrawn
    _residual(equations, ValuesInMotion(known, rules, running, terms))
    keys = [key for key in known.numbers if not key[1]]
    numbers = {key: known.numbers[key][:, :, :, :1].copy() for key in known.numbers}
    shapes = {key: (*key[0].shape, 1 if key[0].constant else terms) for key in keys}
    count = sum(map(prod, shapes.values()))
    if count > MOST_NUMBERS:
        raise NotInMotion
    shifts = SMALL_CHANGE * np.eye(count, 1 + count, 1)

    def residual_at(step: Array) -> tuple[Array, float, float]:
        """What is left there, and beside it for each number changed a little; the size of the sides, what is left."""
        lanes = _changed(numbers, shapes, step[:, None] + shifts)
        found, size = _residual(equations, ValuesInMotion(motion.with_numbers(lanes), rules, running, terms))
        return found, size, float(np.max(np.abs(found[:, 0])))

    residual, size, left = residual_at(np.zeros(count))
    for _ in range(STEPS):
        if not np.all(np.isfinite(residual)):
            raise NotInMotion
        slopes = (residual[:, 1:] - residual[:, :1]) / SMALL_CHANGE
        whole, before = _least_solution(slopes, -residual[:, 0]), left
        for part in SHORTER:
            residual, size, left = residual_at(part * whole)
            if left < max(ENOUGH * before, PRECISION * size):
                break
        else:
            return None
        numbers = _changed(numbers, shapes, part * whole[:, None])
        if left < PRECISION * size:
            return motion.with_numbers(numbers)
    raise NotInMotion


def _least_solution(slopes: Array, wanted: Array) -> Array:
    """The smallest solution of linear equations, or what comes nearest to one.

    It is that of the normal equations with a little damping (Levenberg and Marquardt), as Newton's method goes on from
    there: a decomposition into singular values takes ten times as long.
    """
    is_wide = slopes.shape[0] <= slopes.shape[1]
    square = slopes @ slopes.T if is_wide else slopes.T @ slopes
    damping = DAMPING * max(float(np.max(np.diag(square))), np.finfo(float).tiny)
    square[np.diag_indices_from(square)] += damping
    found = np.linalg.solve(square, wanted if is_wide else slopes.T @ wanted)
    return np.asarray(slopes.T @ found if is_wide else found)


def _changed(numbers: Mapping[Key, Array], shapes: Mapping[Key, tuple[int, ...]], steps: Array) -> dict[Key, Array]:
    """The numbers changed by each of the columns of steps, one beside the other; those of these shapes are changed."""
    found, start = dict(numbers), 0
    for key, shape in shapes.items():
        end = start + prod(shape)
        found[key] = np.repeat(numbers[key], steps.shape[1], axis=3)
        found[key][:, :, : shape[2]] += steps[start:end].reshape(*shape, -1, 1)
        start = end
    return found


def _residual(equations: Sequence[Pair], values: ValuesInMotion) -> tuple[Array, float]:
    """What is left of the equations, term by term, and the size of their sides."""
    rows, size = [], 1.0
    for left, right in equations:
        pairs = [*zip(*(chain.from_iterable(values(side)) for side in (left, right)), strict=True)]
        is_even = len({len(entry) for pair in pairs for entry in pair}) == 1
        for together in (pairs,) if is_even else ([pair] for pair in pairs):
            one, other = (stacked(side, len(side[0])) for side in zip(*together, strict=True))
            size = max(size, float(np.abs(one).max()), float(np.abs(other).max()))
            n = min(one.shape[1], other.shape[1])
            apart = one[:, :n] - other[:, :n]
            rows.append(apart.transpose(0, 1, 3, 2).reshape(-1, apart.shape[2]))
    width = max(row.shape[1] for row in rows)
    wide = (row if row.shape[1] == width else np.broadcast_to(row, (row.shape[0], width)) for row in rows)
    return np.concatenate([*wide]), size


def _equal(left: Matrix, right: Matrix) -> bool | None:
    """Whether the values are equal now; None where they have none, or that is not the same at all motions."""
    values = stacked([*chain(*left, *right)], 1)[:, 0]
    one, other = np.split(values, 2)
    sizes, apart = np.abs(values).max(axis=(0, 2)), np.abs(one - other).max(axis=(0, 2))
    is_real = np.flatnonzero(np.isfinite(apart) & np.isfinite(sizes))[:MOTIONS_COMPARED]
    if not is_real.size:
        return None
    apart, size = apart[is_real], 1 + np.max(sizes[is_real])
    if np.all(apart > TOLERANCE * size):
        return False
    return True if np.all(apart <= TOLERANCE * size) else None
