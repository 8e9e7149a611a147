"""The fractions in which a program is compared with its request: which of them vanish, and which cannot.

Every divisor that the request's expressions spell counts as a unit: the two are compared wherever the expressions have
a value.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from itertools import zip_longest

from chasles.algebra.groebner import Basis, completed, stated
from chasles.algebra.localization import Ratio, quotient
from chasles.algebra.rings import Polynomial
from chasles.checker.witness import root_of
from chasles.lowering.divisors import divisors_of
from chasles.lowering.equivalence.rotation_vectors import by_directions
from chasles.lowering.equivalence.units import Units
from chasles.lowering.request import Request
from chasles.problems.context import Context, build
from chasles.statements import Goal, Hypothesis, Problem, nonzero
from chasles.vocabulary import Node, Norm, Symbol

COMPLETION = 2e7
"""The work that one completion of hypotheses may take, in products of terms."""


class Algebra:
    """Fractions in the entries of a request's arguments, modulo its hypotheses, with some rules added to its own.

    The `positive` symbols are further variables, of which nothing else is known. `turning` are the lengths of arguments
    of which cosines and sines are taken.
    """

    def __init__(
        self,
        request: Request,
        rules: Mapping[Node, Node],
        further: Iterable[Node],
        positive: tuple[Symbol, ...] = (),
    ) -> None:
        table = {**dict(request.rules), **rules}
        angles = [side for _, angle in request.angles for side in (angle.cosine, angle.sine)]
        nodes = [*(output.value for output in request.outputs), *angles, *further, *positive]
        goals = tuple(Goal("", node, node) for node in nodes)
        seen: dict[Node, None] = {}
        divisors = dict.fromkeys(divisor for node in nodes for divisor in divisors_of(node, table, seen))
        roots = [(known.symbol, *known.arguments) for known in request.functions if known.function == "sqrt"]
        squares = (Hypothesis("root", (s,), ((s * s, of),), (), "", f"{s} is a root", free=True) for s, of in roots)
        hypotheses = (*request.hypotheses, *map(nonzero, (*divisors, *positive)), *squares)
        problem = Problem(goals, tuple(table.items()), hypotheses=tuple(dict.fromkeys(hypotheses)))
        problem, self._said, self.turning = by_directions(problem, request.of)
        self.context: Context = build(problem)
        self._completed: Basis | None = None
        self._remainders: dict[object, list[tuple[Polynomial, Polynomial]]] = {}
        self._roots: list[tuple[Ratio, Ratio | None]] = []
        self._nonzero: list[tuple[Polynomial, bool]] = []
        self._units = Units(self.context)
        self._positive = positive
        self._norms: list[Node] = [Norm(v.node) for v in self.context.variables if v.node is not None]
        self._norms += [symbol for symbol, _ in roots]

    def constant(self, value: Fraction) -> Ratio:
        """A number."""
        return self.context.field.constant(value)

    def entry(self, node: Node, row: int = 0, column: int = 0) -> Ratio:
        """An entry of an expression."""
        ratio: Ratio = self.context.unfold(self._said(node))[row][column]
        return ratio

    def number(self, ratio: Ratio) -> Fraction | None:
        """The value of a fraction that is a number as it stands, else None."""
        if ratio.is_zero:
            return Fraction(0)
        if len(ratio.numerator) > 1 or any(ratio.denominator):
            return None
        exponents, coefficient = self.context.field.ring.leading(ratio.numerator)
        return None if any(exponents) else coefficient

    def reduced(self, ratio: Ratio) -> Ratio:
        """The fraction with its numerator in normal form."""
        return Ratio(ratio.field, self._remainder(ratio.numerator), ratio.denominator)

    def vanishes(self, ratio: Ratio, zeros: tuple[Polynomial, ...] = ()) -> bool:
        """Whether the fraction is zero wherever the hypotheses hold and the further polynomials are zero."""
        numerator = ratio.numerator
        if self._remainder(numerator) == 0:
            return True
        if zeros:
            return bool(self._with(zeros).reduce(numerator)[1] == 0)
        if not self.context.basis.complete:
            if self._completed is None:
                self._completed = completed(self.context.basis, COMPLETION)
            return bool(self._completed.reduce(numerator)[1] == 0)
        return False

    def multiple(self, ratio: Ratio, of: Ratio) -> Fraction | None:
        """The number by which a fraction is a multiple of another; None where it is not seen to be one."""
        ring, product = self.context.field.ring, self.context.field.power_product
        sides = ratio.numerator * product(of.denominator), of.numerator * product(ratio.denominator)
        one, other = map(self._remainder, sides)
        if one == 0 or other == 0:
            return None
        (mine, c), (theirs, d) = ring.leading(one), ring.leading(other)
        return c / d if mine == theirs and self.vanishes(ratio - of * self.constant(c / d)) else None

    def root(self, ratio: Ratio) -> Ratio | None:
        """The norm or root whose square the fraction is, or that over a positive symbol, if the request has one."""
        for known, answer in self._roots:
            if (known - ratio).is_zero:
                return answer
        over = next((s for s in map(self.entry, self._positive) if self._times(ratio, s)), None)
        if over is not None:
            size = self.root(self._times(ratio, over) or ratio)
            root = size and self.quotient(size, over)
        else:
            sizes = map(self.entry, self._norms)
            root = next((size for size in sizes if self.vanishes(ratio - size * size)), self._turn(ratio))
            if root is None:
                root = next(self._roots_over(ratio), None)
        self._roots.append((ratio, root))
        return root

    def _roots_over(self, ratio: Ratio) -> Iterator[Ratio | None]:
        """The quotients of norms by positive symbols whose squares the fraction is."""
        for over in map(self.entry, self._positive):
            scaled = ratio * over * over
            sizes = (size for size in map(self.entry, self._norms) if self.vanishes(scaled - size * size))
            yield from (self.quotient(size, over) for size in sizes)

    def _turn(self, ratio: Ratio) -> Ratio | None:
        """The multiple of the length of a rotation vector whose square the fraction is."""
        for length in map(self.entry, self.turning):
            square = self.multiple(ratio, length * length)
            if square is not None and (times := root_of(square)) is not None:
                return length * self.constant(times)
        return None

    def _times(self, ratio: Ratio, divisor: Ratio) -> Ratio | None:
        """The fraction times the square of the divisor, a unit, if it is written with just that below the line."""
        one = self.quotient(self.constant(Fraction(1)), divisor)
        assert one is not None
        below = tuple(x - 2 * y for x, y in zip_longest(ratio.denominator, one.denominator, fillvalue=0))
        (place,) = (k for k, y in enumerate(one.denominator) if y)
        return None if below[place] else Ratio(ratio.field, ratio.numerator, below)

    def quotient(self, above: Ratio, below: Ratio) -> Ratio | None:
        """The quotient; None if that divides by what can be zero where the request's expressions have a value."""
        found = self._units.product(below.numerator)
        if found is None:
            if not self.cannot_vanish(below):
                return None
            found = self._units.add(below.numerator)
        return quotient(above, below, *found)

    def cannot_vanish(self, ratio: Ratio) -> bool:
        """Whether the fraction is nonzero wherever all units are: were it zero, a product of units would be."""
        if self.is_unit(ratio):
            return True
        for known, answer in self._nonzero:
            if known == ratio.numerator:
                return answer
        basis = self._with((ratio.numerator,))
        answer = self._units.any_product(lambda product: bool(basis.reduce(product)[1] == 0))
        self._nonzero.append((ratio.numerator, answer))
        return answer

    def is_unit(self, ratio: Ratio) -> bool:
        """Whether the fraction's numerator is a constant times powers of units."""
        return self._units.product(ratio.numerator) is not None

    def _remainder(self, polynomial: Polynomial) -> Polynomial:
        """The polynomial in normal form; the ways through a program ask for the same ones again and again."""
        if polynomial == 0:
            return polynomial
        basis = self.context.basis
        alike = self._remainders.setdefault((len(polynomial), basis.ring.leading(polynomial)), [])
        for known, remainder in alike:
            if known == polynomial:
                return remainder
        remainder = basis.reduce(polynomial)[1]
        alike.append((polynomial, remainder))
        return remainder

    def _with(self, zeros: tuple[Polynomial, ...]) -> Basis:
        basis = self.context.basis
        return completed(stated(basis.ring, (*basis.generators, *zeros), complete=False), COMPLETION)
