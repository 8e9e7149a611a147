"""Square roots, each the principal (nonnegative) one: independent ones as variables, the others in terms of these.

sqrt(4 x^2 y) is 2 |x| sqrt(y), and sqrt(a b) is sqrt(a) sqrt(b) where these occur too. A radicand is factored; squares
leave the root, factors that are not negative get roots of their own. What is left over is independent as far as is
known, so that its square is all that a proof needs; where it is not, a true statement may stay undecided.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy

from chasles.algebra.rings import Polynomial
from chasles.from_sympy.constants import is_nonnegative
from chasles.from_sympy.numbers import NumberRoots, defining
from chasles.from_sympy.polynomials import Factors, Key, as_node, as_sympy, factored, key_of
from chasles.from_sympy.reader import Reader, multiplied
from chasles.from_sympy.seen_signs import sees_nonnegative
from chasles.problems.context import Context, build
from chasles.statements import Goal, Hypothesis, Problem
from chasles.vocabulary import PI, Node, Number, Power, Quotient, Symbol

Size = tuple[Key, Node, Any]


@dataclass(frozen=True, slots=True)
class Roots:
    """What the words for roots stand for, what the independent ones satisfy, and where they are real.

    `values` are roots of what nothing divides, as products of what is not negative: for certificates.
    """

    rules: tuple[tuple[Node, Node], ...] = ()
    hypotheses: tuple[Hypothesis, ...] = ()
    domains: tuple[str, ...] = ()
    values: tuple[tuple[Node, Node], ...] = ()


def resolve(reader: Reader, divisors: tuple[Hypothesis, ...]) -> Roots:
    """The roots that a reader has met, in terms of independent ones."""
    return _Resolver(reader, divisors).resolved()


def words_of(hypotheses: Iterable[Hypothesis]) -> tuple[Symbol, ...]:
    """The words for independent roots."""
    return tuple(h.subjects[0] for h in hypotheses if h.kind == "root" and isinstance(h.subjects[0], Symbol))


class _Resolver:
    def __init__(self, reader: Reader, divisors: tuple[Hypothesis, ...]) -> None:
        self.reader = reader
        self.divisors = divisors
        self.hypotheses: list[Hypothesis] = []
        self.numbers = NumberRoots(reader, self.hypotheses)
        self.rules: list[tuple[Node, Node]] = []
        self.domains: list[str] = []
        self.words: dict[Key, Symbol] = {}
        self.radicands: dict[Symbol, Node] = {}
        self.composite: list[tuple[Node, list[Size]]] = []
        self.known: set[Key] = set()
        self.noted: list[Node] = []
        self._seen: dict[Key, bool] = {}
        self.values: list[tuple[Node, Node]] = []
        self.symbols = set(reader.atoms.words.values())
        self.negative = {word.name for atom, word in reader.atoms.words.items() if atom.is_nonpositive}
        self.positive = {PI.name, *(word.name for atom, word in reader.atoms.words.items() if atom.is_nonnegative)}

    def resolved(self) -> Roots:
        """One root after the other: those inside a radicand come before it."""
        context = self._context() if self.reader.roots else None
        for radicand in self.reader.roots:
            assert context is not None
            self._note(context, self._reduced(context, self._radicand(context, radicand)[0]))
        for radicand, root in self.reader.roots.items():
            context = self._context()
            self._look_up_in(context)
            polynomial, absolute = self._radicand(context, radicand)
            value = self._square_free(context, polynomial)
            self.values.append((as_node(context, polynomial), value))
            below = [self._absolute(context, atom, node) for atom, node in absolute]
            self.values += [(Power(plain, 2), size) for size, plain in below]
            above = [value, *(node for node, _ in below)]
            squares: list[Node] = [Power(node, 2) for _, node in below]
            total = Quotient(multiplied(above), multiplied(squares)) if squares else multiplied(above)
            self.rules.append((root, total))
        self._compare()
        return Roots(tuple(self.rules), tuple(self.hypotheses), tuple(dict.fromkeys(self.domains)), tuple(self.values))

    def _context(self) -> Context:
        nothing = Number(Fraction(0))
        goals = tuple(Goal("", radicand, nothing) for radicand in self.reader.roots)
        words = words_of(self.hypotheses)
        # A symbol ranks above its own root, so that it is replaced by the root's square and more squares are seen; and
        # this root below all others, so that it is not replaced by what these are roots of.
        own = [h for h in self.hypotheses if h.kind == "root" and h.subjects[1] in self.symbols]
        symbols = tuple(symbol for h in own if isinstance(symbol := h.subjects[1], Symbol))
        others = [h for h in reversed(self.hypotheses) if h not in own]
        first = Hypothesis("equation", (*symbols, *words_of((*others, *own))), free=True)
        hypotheses = (first, *own, *others, *self.divisors)
        return build(Problem(goals, tuple(self.rules), (), (*symbols, *words), hypotheses))

    def _look_up_in(self, context: Context) -> None:
        """What is known, as a context says it: in the roots of symbols that have one by now."""
        self.words = {self._key(context, radicand): word for word, radicand in self.radicands.items()}
        self.known = {self._key(context, node) for node in self.noted}

    def _key(self, context: Context, node: Node) -> Key:
        return key_of(context, self._reduced(context, context.unfold(node)[0][0].numerator))

    def _radicand(self, context: Context, node: Node) -> tuple[Polynomial, list[tuple[Polynomial, Node]]]:
        """N d for a radicand N / d, and the factors of d, by whose absolute values the root is to be divided."""
        ratio = context.unfold(node)[0][0]
        numerator = ratio.numerator
        below: list[tuple[Polynomial, Node]] = []
        for place, power in enumerate(ratio.denominator):
            hypothesis, atom = context.nonzero[place]
            assert hypothesis is not None
            numerator = numerator * atom if power % 2 else numerator
            below += [(atom, hypothesis.nonvanishing[0])] * ((power + 1) // 2)
        return numerator, below

    def _reduced(self, context: Context, polynomial: Polynomial) -> Polynomial:
        return context.basis.reduce(polynomial)[1]

    def _factored(self, context: Context, polynomial: Polynomial) -> tuple[int, Fraction, Factors]:
        """Sign, size and factors, in symbols rather than in their roots."""
        return factored(
            context, polynomial, {word.name for word, node in self.radicands.items() if node in self.symbols}
        )

    def _note(self, context: Context, polynomial: Polynomial) -> None:
        """A root of a single factor says that this factor is not negative."""
        if polynomial == 0:
            return
        sign, _, factors = self._factored(context, polynomial)
        odd = [factor for factor, power in factors if power % 2]
        if len(odd) == 1:
            self.noted.append(as_node(context, odd[0] if sign > 0 else -odd[0]))

    def _square_free(self, context: Context, polynomial: Polynomial) -> Node:
        """The root of a polynomial whose squares leave it before cosines and sines are reduced."""
        sign, size, factors = self._factored(context, polynomial) if polynomial != 0 else (1, Fraction(1), [])
        squares = [factor for factor, power in factors for _ in range(power // 2)]
        left = context.field.ring.constant(sign * size)
        for factor, power in factors:
            left = left * factor if power % 2 else left
        if not squares or (sign < 0 and all(power % 2 == 0 for _, power in factors)):
            return self._root(context, self._reduced(context, polynomial))
        outside = [self._absolute(context, factor)[0] for factor in squares]
        return multiplied([*outside, self._root(context, self._reduced(context, left))])

    def _root(self, context: Context, polynomial: Polynomial) -> Node:
        """The root of a polynomial that is reduced."""
        if polynomial == 0:
            return Number(Fraction(0))
        sign, size, factors = self._factored(context, polynomial)
        parts: list[Node] = [] if size == 1 else [self.numbers.root(size)]
        left = context.field.ring.constant(Fraction(1))
        unknown: list[Polynomial] = []
        for factor, power in factors:
            parts += [self._absolute(context, factor)[0] for _ in range(power // 2)]
            if power % 2 and self._is_known(context, factor):
                parts.append(self._word(context, factor))
            elif power % 2 and self._is_known(context, -factor):
                sign = -sign
                parts.append(self._word(context, -factor))
            elif power % 2:
                left = left * factor
                unknown.append(factor)
        if sign < 0 and left == 1:
            return self._word(context, polynomial)
        if left != 1:
            left = left * context.field.ring.constant(Fraction(sign))
            parts.append(self._word(context, left))
            sizes = [self._size(context, factor) for factor in unknown]
            self.composite.append((as_node(context, left), sizes if len(sizes) > 1 else []))
        return multiplied(parts)

    def _absolute(self, context: Context, polynomial: Polynomial, plain: Node | None = None) -> tuple[Node, Node]:
        """The absolute value of a polynomial, and the polynomial, as words; `plain` if it has some already."""
        plain = as_node(context, polynomial) if plain is None else plain
        if self._is_known(context, polynomial):
            return plain, plain
        if self._is_known(context, -polynomial):
            return as_node(context, -polynomial), plain
        square = self._reduced(context, polynomial * polynomial)
        if square != polynomial * polynomial:
            return self._root(context, square), plain
        key, _, origin = self._size(context, polynomial)
        self._define(key, Power(plain, 2), origin)
        return self.words[key], plain

    def _size(self, context: Context, polynomial: Polynomial) -> Size:
        """How an absolute value is known: by its square; with the polynomial and its absolute value to be written."""
        square = self._reduced(context, polynomial * polynomial)
        origin = sympy.Abs(as_sympy(self.reader.atoms.origins, context, polynomial))
        return key_of(context, square), as_node(context, polynomial), origin

    def _compare(self) -> None:
        """Where a product is not negative, it is the product of the absolute values of its factors."""
        for product, sizes in self.composite:
            if any(key in self.words for key, _, _ in sizes):
                for key, plain, origin in sizes:
                    self._define(key, Power(plain, 2), origin)
                absolute = multiplied([self.words[key] for key, _, _ in sizes])
                text = f"{absolute} = {product}"
                self.hypotheses.append(
                    Hypothesis("consequence", (absolute, product), ((absolute, product),), (), "", text, free=True)
                )

    def _is_known(self, context: Context, polynomial: Polynomial) -> bool:
        return self._is_nonnegative(context, polynomial) or key_of(context, polynomial) in self.known

    def _is_nonnegative(self, context: Context, polynomial: Polynomial) -> bool:
        """Whether the checker sees that it is not negative."""
        key = key_of(context, polynomial)
        if key not in self._seen:
            expression = as_sympy(self.reader.atoms.origins, context, polynomial)
            self._seen[key] = sees_nonnegative(expression)
        return self._seen[key]

    def _word(self, context: Context, polynomial: Polynomial) -> Node:
        """The root of a polynomial as an independent one."""
        number = self.numbers.root_of_constant(context, polynomial)
        if number is not None:
            return number
        key = key_of(context, polynomial)
        expression = as_sympy(self.reader.atoms.origins, context, polynomial)
        if not (self._is_nonnegative(context, polynomial) or is_nonnegative(expression)):
            self.domains.append(f"{expression} >= 0")
        self._define(key, as_node(context, polynomial), sympy.sqrt(expression))
        return self.words[key]

    def _define(self, key: Key, radicand: Node, origin: Any) -> None:
        if key in self.words:
            return
        word = self.reader.atoms.fresh(f"w_{len(self.words) + 1}", origin)
        self.words[key], self.radicands[word] = word, radicand
        self.positive.add(word.name)
        self.hypotheses.append(defining(word, radicand, str(origin)))
