"""Expressions: SymPy's tree as words. What is divided by and what stands under a root is collected on the way."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from typing import Any

import sympy

from chasles.algebra.squarefree import primes_of, squarefree
from chasles.algebra.work_limit import check
from chasles.checker.expressions.defined_functions import BY_OTHERS, VALUED
from chasles.checker.expressions.quantities import is_atom
from chasles.checker.expressions.readings import FUNCTIONS
from chasles.from_sympy.angles import Angles
from chasles.from_sympy.atoms import QuantityNames
from chasles.from_sympy.divisors import DivisorText, divides, divisor_of, in_sines, is_reciprocal
from chasles.from_sympy.exponents import LARGEST_EXPONENT
from chasles.from_sympy.opening import excerpt
from chasles.problems.variables import Untreatable
from chasles.vocabulary import PI, Negative, Node, Number, Power, Quotient, Scale, Sum, Symbol


class Reader:
    """Reads SymPy expressions into words; one reader for everything that belongs to a question.

    `readings` says how, by the class of an expression or a class that it is derived from, and `meanings` what variables
    for values of functions stand for. Of what stands under a root `roots` has the symbol that is the nonnegative one.
    """

    def __init__(self, readings: Mapping[type, Reading], meanings: Mapping[Any, Any]) -> None:
        self.readings, self.meanings = readings, meanings
        self.atoms = QuantityNames()
        self.angles = Angles(self.atoms)
        self.divisors: dict[Node, DivisorText] = {}
        self.roots: dict[Node, Symbol] = {}
        self.primes: dict[int, Symbol] = {}
        self.met: set[Node] = set()
        self._known: dict[Any, Node] = {}

    def __call__(self, expression: Any) -> Node:
        """The expression in words; raises `Untreatable` naming the part that is not treated."""
        known = self._known.get(expression)
        if known is None:
            check()
            known = self._known[expression] = self._read(expression)
        return known

    def _read(self, e: Any) -> Node:
        if is_atom(e):
            return self.atoms.word(e)
        for kind in type(e).__mro__:
            if kind in self.readings:
                return self.readings[kind](self, e)
        raise self._untreatable(e)

    def _untreatable(self, e: Any) -> Untreatable:
        kinds = (*self.readings, *VALUED, *BY_OTHERS)
        own = {kind.__name__ for kind in kinds if issubclass(kind, sympy.Function)}
        functions = sorted({*own, *FUNCTIONS, "Max", "Min", "Piecewise"}, key=str.lower)
        return Untreatable(
            f"{excerpt(e)} is not treated. Treated are rational functions of real symbols, of functions such as f(t) "
            f"and their derivatives, of pi, of roots, and of {', '.join(functions)}"
        )

    def declare(self, node: Node, divisor: DivisorText) -> None:
        """Something does not vanish: a product does so where none of its factors does."""
        match node:
            case Number():
                return
            case Negative(term) | Power(term, _):
                self.declare(term, divisor)
            case Scale(factor, term):
                self.declare(factor, divisor)
                self.declare(term, divisor)
            case _:
                self.met.add(node)
                if self.divisors.setdefault(node, divisor).evident:
                    self.divisors[node] = divisor

    def product(self, e: Any) -> Node:
        """Factors above and below the line."""
        above: list[Node] = []
        below: list[Node] = []
        negative = False
        for factor in sympy.Mul.make_args(e):
            if is_reciprocal(factor):
                self._divide(factor, above, below)
            elif factor is sympy.S.NegativeOne:
                negative = True
            else:
                above.append(self(factor))
        product = Quotient(multiplied(above), multiplied(below)) if below else multiplied(above)
        return Negative(product) if negative else product

    def _divide(self, factor: Any, above: list[Node], below: list[Node]) -> None:
        """Put a power with a negative exponent below the line; a base that is itself a fraction is turned over.

        What stands below is an integral power, and no absolute value: x^(-1/2) = x^(1/2) / x.
        """
        base, exponent = factor.base, -factor.exp
        while (isinstance(base, sympy.Abs) and exponent.is_Integer) or not exponent.is_Integer:
            if exponent.is_Integer:
                above += [] if exponent.is_even else [self(base)]
                base, exponent = base.args[0], exponent + exponent % 2
            else:
                whole = sympy.ceiling(exponent)
                above.append(self._power(base, whole - exponent, factor))
                exponent = whole
        node, power = self(base), _limited(int(exponent), factor)
        if divides(base):
            numerator, denominator = sympy.fraction(sympy.together(in_sines(base)))
            if not (divides(numerator) or divides(denominator)):
                base, node = numerator, self(numerator)
                above.append(_raised(self(denominator), power))
        self.declare(node, divisor_of(base, self.meanings))
        below.append(_raised(node, power))

    def power(self, e: Any) -> Node:
        """A power, by its exponent."""
        return self.product(e) if is_reciprocal(e) else self._power(e.base, e.exp, e)

    def _power(self, base: Any, exponent: Any, whole: Any) -> Node:
        base = base.args[0] if isinstance(base, sympy.Abs) and exponent.is_even else base
        return self._halves(self(base), base, exponent, whole)

    def _halves(self, node: Node, base: Any, exponent: Any, whole: Any) -> Node:
        """A power with the exponent p, p/2, p/4, ... as an integral power of nested square roots."""
        if not exponent.is_Rational or exponent.q & (exponent.q - 1):
            raise self._untreatable(whole)
        power, below = _limited(int(exponent.p), whole), int(exponent.q)
        while below > 1:
            node, base, below = self.root(node, base), sympy.sqrt(base), below // 2
        return _raised(node, power)

    def root(self, radicand: Node, expression: Any) -> Node:
        """The nonnegative square root; a number's is a multiple of the roots of primes."""
        if isinstance(radicand, Number):
            return self.numeric_root(radicand.value)
        if radicand not in self.roots:
            self.roots[radicand] = self.atoms.fresh(f"root_{len(self.roots) + 1}", sympy.sqrt(expression))
        return self.roots[radicand]

    def numeric_root(self, value: Fraction) -> Node:
        """The square root of a nonnegative rational number, in the square roots of primes."""
        parts = squarefree(value.numerator * value.denominator) if value > 0 else (0, 1)
        if value < 0 or parts is None:
            what = "is not real" if value < 0 else "has no known factors"
            raise Untreatable(f"sqrt({value}) is not treated: it {what}")
        primes: list[Node] = [self._prime(p) for p in primes_of(parts[1])]
        factor = Fraction(parts[0], value.denominator)
        return multiplied(primes if primes and factor == 1 else [Number(factor), *primes])

    def _prime(self, number: int) -> Symbol:
        if number not in self.primes:
            self.primes[number] = self.atoms.fresh(f"root_of_{number}", sympy.sqrt(number))
        return self.primes[number]


def multiplied(factors: list[Node]) -> Node:
    """The product; one if there are no factors."""
    return reduce(Scale, factors) if factors else Number(Fraction(1))


def _limited(exponent: int, whole: Any) -> int:
    if exponent > LARGEST_EXPONENT:
        raise Untreatable(f"{excerpt(whole)} is not treated: its exponent is larger than {LARGEST_EXPONENT}")
    return exponent


def _raised(node: Node, power: int) -> Node:
    return Number(Fraction(1)) if power == 0 else node if power == 1 else Power(node, power)


Reading = Callable[[Reader, Any], Node]
ARITHMETIC: Mapping[type, Reading] = {
    sympy.Rational: lambda _, e: Number(Fraction(int(e.p), int(e.q))),
    type(sympy.pi): lambda _, e: PI,
    sympy.Add: lambda reader, e: Sum(tuple(map(reader, e.args))),
    sympy.Mul: Reader.product,
    sympy.Pow: Reader.power,
    sympy.Abs: lambda reader, e: reader.root(Power(reader(e.args[0]), 2), e.args[0] ** 2),
    sympy.sign: lambda reader, e: reader(e.args[0] * sympy.Abs(e.args[0], evaluate=False) / e.args[0] ** 2),
}
"""Sums, products, powers, roots and absolute values."""
