"""Problems about matrices whose sizes are letters: what their words say in the free algebra.

Everything known is an equation there: what hypotheses say, and that a matrix times its inverse is the identity.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from fractions import Fraction
from functools import reduce
from itertools import chain

from chasles import vocabulary as w
from chasles.checker.any_size.free_algebra import Words, added
from chasles.checker.any_size.free_blocks import Blocks, Determinants, differences, key_of, multiplied, plus, stacked
from chasles.checker.any_size.known_relations import KnownRelations
from chasles.checker.sparse import Rejected
from chasles.statements import Goal, Problem
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.measure import Extent
from chasles.vocabulary.products import SizedKroneckerProduct, SizedVectorized
from chasles.vocabulary.sizes import blocks_of, parts_of


class SymbolicReading(KnownRelations):
    """A problem in the free algebra, with the equations that hold.

    `inverses` are the letters of inverses, each with what it is the inverse of, `lengths` those of norms.
    """

    def __init__(self, problem: Problem, assumed: Sequence[Goal] = ()) -> None:
        super().__init__()
        self.problem = problem
        self.rules = dict(problem.rules)
        self.inverses: dict[str, tuple[Words, Words]] = {}
        self.lengths: set[int] = set()
        self._read: dict[w.Node, Blocks] = {}
        self.determinants = Determinants(self, self._inverting, self._determinant)
        self.divisors = {node: h.text for h in problem.hypotheses for node in h.nonvanishing}
        said = [("condition", "", g.left, g.right) for g in problem.conditions]
        said += [("what is claimed of less", "", g.left, g.right) for g in assumed]
        said += [(h.text, h.text, *equation) for h in problem.hypotheses for equation in h.equations]
        for goal in problem.goals:
            _ = self(goal.left), self(goal.right)
        for number, (text, needs, left, right) in enumerate(said):
            # What the free algebra has no words for is not used; that it holds at the witness is asked there.
            with suppress(Rejected):
                for i, j, words, height, width in self.differences(left, right):
                    self.note(f"{text} [{number}: {i}, {j}]", words, height, width, needs)
        self.note_powers()
        self.note_tensors()

    def __call__(self, node: w.Node) -> Blocks:
        """The blocks of an expression; raises `Rejected` for a word that the free algebra has not."""
        if node not in self._read:
            self._read[node] = self._made(node)
        return self._read[node]

    def scalar(self, node: w.Node) -> Words:
        """The only block of a scalar."""
        return self(node).rows[0][0]

    def differences(self, left: w.Node, right: w.Node) -> Iterator[tuple[int, int, Words, Extent, Extent]]:
        """Row, column, difference, height and width of each block; raises `Rejected` where blocks do not fit."""
        return differences(self(left), self(right))

    def _made(self, node: w.Node) -> Blocks:
        match node:
            case _ if node in self.rules:
                return self(self.rules[node])
            case w.Symbol(stands_for=w.Node() as of) | w.Group(of) | w.At(of, "t"):
                return self(of)
            case w.Symbol():
                return self.lettered(node, str(node), *blocks_of(node.size))
            case w.Number() | w.Identity() | w.Zero():
                heights, widths = blocks_of(measured(node))
                value = node.value if isinstance(node, w.Number) else Fraction(isinstance(node, w.Identity))
                one: Words = {((), ()): value} if value else {}
                rows = [[one if i == j else {} for j, _ in enumerate(widths)] for i, _ in enumerate(heights)]
                return Blocks(heights, widths, rows)
            case w.Sum(terms):
                return reduce(plus, map(self, terms))
            case w.Negative(term):
                return multiplied(self(term), Fraction(-1))
            case w.Contract((*before, SizedKroneckerProduct(left, right), SizedVectorized(of))):
                column = SizedVectorized(w.Contract((right, of, w.Transpose(left))))
                return reduce(self.times, map(self, (*before, column)))
            case w.Contract(factors):
                return reduce(self.times, map(self, factors))
            case w.Power(base, exponent):
                powers = (self.power(self(base), str(base), each) for each in parts_of(exponent))
                return reduce(self.times, chain.from_iterable(powers))
            case w.Transpose(of):
                return self.flipped_blocks(self(of))
            case w.Block(blocks):
                return stacked([[self(block) for block in row] for row in blocks])
            case w.Inverse(SizedKroneckerProduct(left, right)) if left.shape[0] == left.shape[1]:
                return self.tensor(self(w.Inverse(left)), self(w.Inverse(right)))
            case w.Inverse(of):
                return self._inverse(of)
            case SizedKroneckerProduct(left, right):
                return self.tensor(self(left), self(right))
            case SizedVectorized(of):
                return self.vec(self(of))
            case w.Scale(factor, term):
                return self.scaled(self.scalar(factor), self(term))
            case w.Quotient(numerator, w.Power(divisor, exponent)) if exponent > 0:
                return self(reduce(lambda left, _: w.Quotient(left, divisor), range(exponent), numerator))
            case w.Quotient(numerator, w.Determinant(w.Contract(factors))) if len({f.shape for f in factors}) == 1:
                return self(reduce(lambda left, factor: w.Quotient(left, w.Determinant(factor)), factors, numerator))
            case w.Quotient(numerator, divisor):
                return self.scaled(self._inverse(divisor).rows[0][0], self(numerator))
            case _:
                return Blocks((1,), (1,), [[self._of_matrices(node)]])

    def _of_matrices(self, node: w.Node) -> Words:
        """A scalar that is made of matrices."""
        match node:
            case w.Dot(left, right):
                return self.times(self.flipped_blocks(self(left)), self(right)).rows[0][0]
            case w.Trace(SizedKroneckerProduct(left, right)) if left.shape[0] == left.shape[1]:
                return self.product(self.scalar(w.Trace(left)), self.scalar(w.Trace(right)))
            case w.Trace(of):
                inner = self(of)
                total: Words = {}
                for k, size in enumerate(inner.heights):
                    added(total, self.trace(inner.rows[k][k], size), Fraction(1))
                return total
            case w.Norm(of):
                square = self.scalar(w.Dot(of, of))
                length = self.letter(("norm", *sorted(square.items())), str(node), 1, 1)
                self.lengths |= {word[0] >> 1 for scalars, _ in length for _, word in scalars}
                zero = self.product(length, length)
                added(zero, square, Fraction(-1))
                self.note(f"the square of {node}", zero, 1, 1, "")
                return length
            case w.Determinant(w.Group(of)):
                return self.scalar(w.Determinant(of))
            case w.Determinant(w.Contract(factors)) if all(factor.shape == node.of.shape for factor in factors):
                return reduce(self.product, (self.scalar(w.Determinant(factor)) for factor in factors))
            case w.Determinant(of):
                return self.determinants.of_blocks(self(of))
            case _:
                raise Rejected(f"{node} ({type(node).__name__}) is no word of the algebra of matrices of any size")

    def _inverting(self) -> Iterator[tuple[Words, Words]]:
        """What is said to have an inverse, with its inverse, and inverses with what they are the inverses of."""
        for node in self.divisors:
            if not isinstance(node, w.Determinant) or any(isinstance(part, w.Determinant) for part in w.walk(node.of)):
                continue  # what has determinants in it would be read in order to read one
            if len(self(node.of).heights) == 1:
                yield self(node.of).rows[0][0], self._inverse(node.of).rows[0][0]
        yield from tuple(self.inverses.values())

    def _determinant(self, words: Words, size: Extent) -> Words:
        """The product of the determinants of square letters; of anything else, a letter."""
        total: Words = {((), ()): Fraction(1)}
        monomial = max(words, default=((), ()))
        is_square = all(self.shapes[k >> 1] == (size, size) for k in monomial[1])
        if words != {monomial: Fraction(1)} or monomial[0] or not is_square:
            least = min(sorted(words.items()), sorted(self.transposed(words).items()))  # either has this determinant
            return self.letter(("determinant", tuple(least)), f"det({self.spelled_sum(dict(least))})", 1, 1)
        for place in (letter >> 1 for letter in monomial[1]):
            spelled = self.names[place]
            one = self.letter(("determinant", place), f"det({spelled})", 1, 1)
            total = self.product(total, one)
            if spelled in self.inverses:
                zero = self.product(one, self.determinants.of_words(self.inverses[spelled][1], size))
                added(zero, {((), ()): Fraction(1)}, Fraction(-1))
                self.note(f"det({spelled})", zero, 1, 1, self.known[f"{spelled} from the right [1, 1]"].needs)
        return total

    def _inverse(self, of: w.Node) -> Blocks:
        """What a divisor, or a matrix, is multiplied by to give the identity; a hypothesis says that there is such."""
        matrix = self(of)
        if [*matrix.rows[0][0]] == [((), ())] and of.is_scalar:
            return multiplied(Blocks((1,), (1,), [[{((), ()): Fraction(1)}]]), 1 / matrix.rows[0][0][(), ()])
        text = self._nonvanishing(of)
        found = self.lettered(("inverse", key_of(matrix)), f"inverse({of})", matrix.widths, matrix.heights)
        identity = self(w.Identity(of.shape[0])) if not of.is_scalar else self(w.Number(Fraction(1)))
        if len(matrix.heights) == 1:
            self.inverses[f"inverse({of})"] = found.rows[0][0], matrix.rows[0][0]
        for side, (one, other) in (("from the right", (matrix, found)), ("from the left", (found, matrix))):
            for i, j, words, height, width in differences(self.times(one, other), identity):
                self.note(f"inverse({of}) {side} [{i}, {j}]", words, height, width, text)
        return found

    def _nonvanishing(self, of: w.Node) -> str:
        """The text of the hypothesis by which a scalar, or the determinant of a matrix, is not zero."""
        sought = of if of.is_scalar else w.Determinant(of)
        if sought in self.divisors:
            return self.divisors[sought]
        value = self(of)
        for node, text in self.divisors.items():
            inner = node.of if isinstance(node, w.Determinant) and not of.is_scalar else node
            if inner.shape == of.shape and of not in w.walk(inner) and self(inner) == value:
                return text
        raise Rejected(f"{of} divides, and nothing says that it is not zero: assume `nonzero` or `invertible` of it")
