"""The stage on which a program is compared with its request: fractions, what vanishes and what cannot.

Here every divisor that the request's expressions spell counts as an atom: the two are compared wherever the expressions
have a value.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from itertools import combinations_with_replacement
from time import monotonic

from chasles.lowering.request import Request
from chasles.proof.completion import Basis, completed, stated
from chasles.proof.context import Context, build
from chasles.proof.ratios import Ratio
from chasles.proof.rings import Polynomial
from chasles.statements import Goal, Problem, nonzero
from chasles.statements.statement import bare
from chasles.vocabulary import Group, Negative, Node, Norm, Number, Power, Quotient, Scale, Symbol, children

__all__ = ["Algebra"]

LARGEST_POWER = 4


class Algebra:
    """Fractions in the entries of a request's arguments, modulo its hypotheses, with some rules added to its own."""

    def __init__(self, request: Request, rules: Mapping[Node, Node], further: Iterable[Node], deadline: float) -> None:
        table = {**dict(request.rules), **rules}
        angles = [side for _, angle in request.angles for side in (angle.cosine, angle.sine)]
        nodes = [*(output.value for output in request.outputs), *angles, *further]
        goals = tuple(Goal("", node, node) for node in nodes)
        divisors = dict.fromkeys(divisor for node in nodes for divisor in _divisors(node, table))
        hypotheses = (*request.hypotheses, *map(nonzero, divisors))
        self.context: Context = build(Problem(goals, tuple(table.items()), hypotheses=tuple(dict.fromkeys(hypotheses))))
        self._deadline = deadline
        self._completed: Basis | None = None
        self._roots: list[tuple[Ratio, Ratio | None]] = []
        self._nonzero: list[tuple[Polynomial, bool]] = []
        self._products_of_atoms: list[tuple[Polynomial, bool]] = []
        self._norms = [Norm(variable.node) for variable in self.context.variables if variable.node is not None]

    def constant(self, value: Fraction) -> Ratio:
        """A number."""
        return self.context.field.constant(value)

    def entry(self, node: Node, row: int = 0, column: int = 0) -> Ratio:
        """An entry of an expression."""
        return self.context.unfold(node)[row][column]

    def vanishes(self, ratio: Ratio, zeros: tuple[Polynomial, ...] = ()) -> bool:
        """Whether the fraction is zero wherever the hypotheses hold and the further polynomials are zero."""
        numerator = ratio.numerator
        if self.context.basis.reduce(numerator)[1] == 0:
            return True
        if zeros:
            return bool(self._with(zeros).reduce(numerator)[1] == 0)
        if not self.context.basis.complete:
            if self._completed is None:
                self._completed = completed(self.context.basis, self._in_time)
            return bool(self._completed.reduce(numerator)[1] == 0)
        return False

    def root(self, ratio: Ratio) -> Ratio | None:
        """The norm whose square the fraction is, if the request's expressions have one."""
        for known, answer in self._roots:
            if (known - ratio).is_zero:
                return answer
        sizes = map(self.entry, self._norms)
        root = next((size for size in sizes if self.vanishes(ratio - size * size)), None)
        self._roots.append((ratio, root))
        return root

    def quotient(self, above: Ratio, below: Ratio) -> Ratio | None:
        """The quotient; None if that divides by what can be zero where the request's expressions have a value."""
        field, numerator = self.context.field, below.numerator
        found = self._as_atoms(numerator)
        if found is None:
            if not self.cannot_vanish(below):
                return None
            field.atoms.append(numerator)
            found = Fraction(1), tuple(int(k == len(field.atoms) - 1) for k in range(len(field.atoms)))
        scale, exponents = found
        return Ratio(field, above.numerator * field.power_product(below.denominator), above.denominator).divided(
            scale, exponents
        )

    def cannot_vanish(self, ratio: Ratio) -> bool:
        """Whether the fraction is nonzero wherever all atoms are: were it zero, a product of atoms would be."""
        if self.is_product_of_atoms(ratio):
            return True
        for known, answer in self._nonzero:
            if known == ratio.numerator:
                return answer
        basis = self._with((ratio.numerator,))
        answer = any(basis.reduce(product)[1] == 0 for _, product in self._products())
        self._nonzero.append((ratio.numerator, answer))
        return answer

    def is_product_of_atoms(self, ratio: Ratio) -> bool:
        """Whether the fraction's numerator is a constant times powers of atoms."""
        for known, answer in self._products_of_atoms:
            if known == ratio.numerator:
                return answer
        answer = self._as_atoms(ratio.numerator) is not None
        self._products_of_atoms.append((ratio.numerator, answer))
        return answer

    def _as_atoms(self, polynomial: Polynomial) -> tuple[Fraction, tuple[int, ...]] | None:
        """The polynomial as a constant times powers of atoms, modulo the hypotheses."""
        ring, reduce = self.context.field.ring, self.context.basis.reduce
        normal = reduce(polynomial)[1]
        if normal == 0:
            return None
        mine, c = ring.leading(normal)
        if not any(mine):
            return c, ()
        for exponents, product in self._products():
            candidate = reduce(product)[1]
            if candidate == 0:
                continue
            theirs, d = ring.leading(candidate)
            if mine == theirs and normal == candidate * ring.constant(c / d):
                return c / d, exponents
        return None

    def _products(self) -> Iterator[tuple[tuple[int, ...], Polynomial]]:
        """Products of atoms, small ones first."""
        atoms = self.context.field.atoms
        different = [k for k, atom in enumerate(atoms) if all(atom != other for other in atoms[:k])]
        for degree in range(1, LARGEST_POWER + 1):
            for chosen in combinations_with_replacement(different, degree):
                exponents = tuple(chosen.count(k) for k in range(len(atoms)))
                yield exponents, self.context.field.power_product(exponents)

    def _with(self, zeros: tuple[Polynomial, ...]) -> Basis:
        basis = self.context.basis
        return completed(stated(basis.ring, (*basis.generators, *zeros), complete=False), self._in_time)

    def _in_time(self) -> bool:
        return monotonic() < self._deadline


def _divisors(node: Node, rules: Mapping[Node, Node]) -> Iterator[Node]:
    """What an expression divides by, factor by factor, those inside before those around them."""
    node = bare(node)
    if node in rules:
        yield from _divisors(rules[node], rules)
        return
    if isinstance(node, Symbol) and node.stands_for is not None:
        yield from _divisors(node.stands_for, rules)
        return
    for part in children(node):
        yield from _divisors(part, rules)
    if isinstance(node, Quotient):
        yield from _factors(node.denominator)


def _factors(divisor: Node) -> Iterator[Node]:
    match divisor:
        case Number():
            return
        case Group(inner) | Negative(inner) | Power(inner, _):
            yield from _factors(inner)
        case Scale(factor, term):
            yield from _factors(factor)
            yield from _factors(term)
        case _:
            yield divisor
