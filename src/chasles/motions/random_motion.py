"""Random motions of everything on a page, and the values of expressions at them, with all their rates."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import lru_cache
from math import factorial
from types import MappingProxyType

import numpy as np

from chasles.evaluation import matrices
from chasles.evaluation.interpreter import Interpreter
from chasles.evaluation.matrices import Matrix, each
from chasles.motions.time_series import Array, TimeSeries, chosen, function_of, matrix_product
from chasles.statements import Hypothesis
from chasles.vocabulary import PI, At, Call, Integral, Inverse, Node, Norm, Power, Rate, Symbol, undotted
from chasles.vocabulary.functions import Cases, FunctionOf
from chasles.vocabulary.partial import CarriedOut, with_derivatives

MOTIONS, ELEMENTS = 12, 7
"""So many motions are looked at, of bodies of so many elements: at some of them roots are real."""
MOST_FACTORS = 100
"""So many factors of a power are multiplied; a higher one has no value here, and is one factor."""
TERMS = 7
"""Terms of each series: so many rates less one may be taken."""
RELATIONS = {"<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge}
Key = tuple[Symbol, bool, bool]
"""A symbol, whether it differs from element to element, and whether it may move."""


class NotInMotion(Exception):
    """Something that has no value at a motion, or none that is known here."""


class TooFewTerms(Exception):
    """A rate of what has one term only."""


class RandomMotion:
    """A motion of every symbol that satisfies the `facts` of it; the same symbol moves alike in all that is asked.

    A symbol's series is made of numbers that are free: by rows, columns, terms, motions and elements; others are drawn
    with another `start`.
    """

    def __init__(
        self,
        facts: Callable[[Symbol], tuple[Hypothesis, ...]],
        numbers: Mapping[Key, Array] = MappingProxyType({}),
        start: int = 0,
    ) -> None:
        self._facts, self._start = facts, start
        self.numbers = dict(numbers)
        self._made: dict[tuple[Key, int], Matrix] = {}

    @property
    def undrawn(self) -> RandomMotion:
        """The motion before anything is asked of it."""
        return RandomMotion(self._facts, start=self._start)

    def with_numbers(self, numbers: Mapping[Key, Array]) -> RandomMotion:
        """The motion with other free numbers of some symbols."""
        return RandomMotion(self._facts, {**self.numbers, **numbers}, self._start)

    def of(self, symbol: Symbol, terms: int, running: Mapping[Symbol, bool]) -> Matrix:
        """The series of a symbol; one that is `running` differs from element to element, and may move."""
        key = symbol, symbol in running, running.get(symbol, True)
        if (key, terms) not in self._made:
            if key not in self.numbers:
                self.numbers[key] = _drawn(*key, self._start)
            self._made[key, terms] = self._satisfying(symbol, self.numbers[key][:, :, :terms])
        return self._made[key, terms]

    def _satisfying(self, symbol: Symbol, free: Array) -> Matrix:
        reach = 1 if symbol.constant else None
        made = [[TimeSeries(entry, reach) for entry in row] for row in free]
        for fact in self._facts(symbol):
            if fact.kind not in SATISFYING or fact.subjects != (symbol,):
                raise NotInMotion
            made = SATISFYING[fact.kind](made)
        return made


@lru_cache(maxsize=4096)
def _drawn(symbol: Symbol, runs: bool, moves: bool, start: int) -> Array:
    letters = list(f"{symbol.name} {symbol.letter} {symbol.shape} {symbol.meaning}".encode())
    numbers = np.random.default_rng([*letters, *[start] * (start > 0)])
    blocks = [numbers.uniform(-1, 1, (*symbol.shape, TERMS, n, ELEMENTS if runs else 1)) for n in (2, MOTIONS - 2)]
    free = np.concatenate(blocks, axis=3)
    if symbol.constant or not moves:
        free[:, :, 1:] = 0
    return free


def _normalized(column: Matrix) -> Matrix:
    square = matrices.product(matrices.transposed(column), column)[0][0]
    length = function_of("sqrt")(square)
    return each(column, lambda entry: entry / length)


def _rotation(free: Matrix) -> Matrix:
    """The columns made orthonormal one after the other, the last their cross product."""
    first, second = ([[row[k]] for row in free] for k in range(2))
    first = _normalized(first)
    along = matrices.product(matrices.transposed(first), second)[0][0]
    second = _normalized([[a - along * b] for (a,), (b,) in zip(second, first, strict=True)])
    third = matrices.cross(first, second)
    return [[a, b, c] for (a,), (b,), (c,) in zip(first, second, third, strict=True)]


SATISFYING: dict[str, Callable[[Matrix], Matrix]] = {
    "unit": _normalized,
    "rotation": _rotation,
    "symmetric": lambda free: matrices.plus(free, matrices.transposed(free)),
    "positive-definite": lambda free: matrices.product(matrices.transposed(free), free),
    "positive": lambda free: each(free, function_of("exp")),
}
"""By the kind of a hypothesis, what satisfies it, made of what is free."""


class ValuesInMotion(Interpreter):
    """The values of expressions at a motion, under rules for quantities; raises `NotInMotion` for what has none.

    `begun` are the first terms of quantities whose later ones are being found.
    """

    def __init__(
        self,
        motion: RandomMotion,
        rules: Mapping[Node, Node],
        running: Mapping[Symbol, bool],
        terms: int,
        begun: Mapping[Symbol, Matrix] = MappingProxyType({}),
    ) -> None:
        super().__init__(rules)
        self.motion, self.running = motion, running
        self._rates = [(*undotted(left), right) for left, right in rules.items() if isinstance(left, Rate)]
        self.terms, self.begun = terms, begun

    def entries(self, node: Node) -> Matrix:
        is_elsewhere = isinstance(node, At) and node.argument != "t" and node not in self.rules
        if is_elsewhere or (isinstance(node, Power) and node.exponent > MOST_FACTORS):
            raise NotInMotion
        return super().entries(node)

    def constant(self, value: Fraction) -> TimeSeries:
        return self._resting(float(value))

    def product(self, left: Matrix, right: Matrix) -> Matrix:
        return matrix_product(left, right)

    def own(self, node: Node) -> Matrix:
        match node:
            case Symbol():
                return [[self._resting(np.pi)]] if node == PI else self._moved(node)
            case Rate(of):
                return each(self(of), _rate)
            case Call(function, argument):
                return [[function_of(function)(self.scalar(argument))]]
            case FunctionOf(function, arguments):
                return [[function_of(function)(*map(self.scalar, arguments))]]
            case Cases(values, left, right, signs):
                found = self(values[-1])
                for value, one, sign, other in reversed([*zip(values, left, signs, right, strict=False)]):
                    is_so = RELATIONS[sign](self.scalar(one).now, self.scalar(other).now)
                    rows = zip(self(value), found, strict=True)
                    found = [[chosen(a, b, is_so) for a, b in zip(*row, strict=True)] for row in rows]
                return found
            case Norm(of):
                square = matrices.product(matrices.transposed(self(of)), self(of))[0][0]
                return [[function_of("sqrt")(square)]]
            case Inverse(of):
                return self.inverse(of)
            case CarriedOut():
                return self(with_derivatives(node, self.rules))
            case Integral(of):
                return each(self(of), lambda entry: TimeSeries(entry.terms.sum(axis=-1, keepdims=True)))
            case _:
                raise NotInMotion

    def _resting(self, value: float) -> TimeSeries:
        terms = np.zeros((self.terms, 1, 1))
        terms[0] = value
        return TimeSeries(terms, int(value != 0))

    def _moved(self, symbol: Symbol) -> Matrix:
        """The series of a symbol; where a rule says what its rate is, its later terms are found by that one by one."""
        if symbol in self.begun:
            return self.begun[symbol]
        found = self.motion.of(symbol, self.terms, self.running)
        for order, right in sorted((order, right) for base, order, right in self._rates if base == symbol):
            found = self._continued(symbol, order, right, found)
        return found

    def _continued(self, symbol: Symbol, order: int, right: Node, start: Matrix) -> Matrix:
        found = each(start, lambda entry: entry.first(order))
        known = order
        while known < self.terms:
            begun = {**self.begun, symbol: found}
            following = ValuesInMotion(self.motion, self.rules, self.running, self.terms, begun)
            longer = following(right)
            for k in reversed(range(order)):
                longer = [
                    [entry.integrated(first.terms[k] * factorial(k)) for entry, first in zip(*rows, strict=True)]
                    for rows in zip(longer, start, strict=True)
                ]
            reached = min(len(entry) for row in longer for entry in row)
            if reached <= known:
                break
            found, known = longer, reached
        return each(found, lambda entry: entry.first(self.terms))


def _rate(series: TimeSeries) -> TimeSeries:
    if len(series) == 1:
        raise TooFewTerms
    return series.rate
