"""What may be divided by, when a program is compared with a request: what the request's expressions divide by."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import combinations_with_replacement

from chasles.algebra.rings import Polynomial
from chasles.problems.context import Context

LARGEST_POWER, LARGEST_ALONE = 4, 12
"""Of factors among others, and of one alone, as a distance is raised in the attraction of a flattened body."""
Product = tuple[Fraction, tuple[int, ...]]
"""A constant, and the powers of the units."""


class Units:
    """What does not vanish in a context, and products of a few such factors in normal form."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._products: list[tuple[tuple[int, ...], Polynomial]] = []
        self._waiting: Iterator[tuple[int, ...]] = iter(self._exponents())
        self._found: list[tuple[Polynomial, Product | None]] = []

    def product(self, polynomial: Polynomial) -> Product | None:
        """The polynomial as a constant times powers of units, modulo the hypotheses; None if it is none."""
        for known, answer in self._found:
            if known == polynomial:
                return answer
        found = self._product(polynomial)
        self._found.append((polynomial, found))
        return found

    def add(self, polynomial: Polynomial) -> Product:
        """The polynomial as a unit of its own."""
        atoms = self._context.field.nonzero
        atoms.append(polynomial)
        self._products, self._waiting, self._found = [], iter(self._exponents()), []
        return Fraction(1), tuple(int(k == len(atoms) - 1) for k in range(len(atoms)))

    def any_product(self, passes: Callable[[Polynomial], bool]) -> bool:
        """Whether some product of units passes a test."""
        return any(passes(product) for _, product in self._all())

    def _product(self, polynomial: Polynomial) -> Product | None:
        ring = self._context.field.ring
        normal = self._context.basis.reduce(polynomial)[1]
        if normal == 0:
            return None
        mine, c = ring.leading(normal)
        if not any(mine):
            return c, ()
        for exponents, product in self._all():
            if product == 0:
                continue
            theirs, d = ring.leading(product)
            if mine == theirs and normal == product * ring.constant(c / d):
                return c / d, exponents
        return None

    def _all(self) -> Iterator[tuple[tuple[int, ...], Polynomial]]:
        """Products of units in normal form, small ones first."""
        yield from self._products
        for exponents in self._waiting:
            product = self._context.basis.reduce(self._context.field.power_product(exponents))[1]
            self._products.append((exponents, product))
            yield exponents, product

    def _exponents(self) -> Iterator[tuple[int, ...]]:
        atoms = self._context.field.nonzero
        different = [k for k, atom in enumerate(atoms) if all(atom != other for other in atoms[:k])]
        for degree in range(1, LARGEST_POWER + 1):
            for chosen in combinations_with_replacement(different, degree):
                yield tuple(chosen.count(k) for k in range(len(atoms)))
        for degree in range(LARGEST_POWER + 1, LARGEST_ALONE + 1):
            yield from (tuple(degree * (k == place) for k in range(len(atoms))) for place in different)
