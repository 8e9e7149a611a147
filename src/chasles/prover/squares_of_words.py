"""Scalars of the free algebra as sums of squares: |v|^2, v^T M v of a positive-definite M, tr(V^T V)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from fractions import Fraction

from chasles.algebra.squares import by_lagrange
from chasles.checker.any_size.free_algebra import Atom, Letters, Monomial, Words
from chasles.prover.free_words import Completion
from chasles.prover.rewriting_words import Derived

Root = tuple[Letters, Monomial]
"""A letter that is positive, or none, and what stands on its right and, transposed, on its left."""
SquareOfWords = tuple[Fraction, Letters, dict[Monomial, Fraction]]


def squares_of_words(completion: Completion, words: Words, positive: Collection[int]) -> list[SquareOfWords] | None:
    """Squares whose sum is the scalar, up to what is known; None if none are found.

    Each product is shared among the squares that it may belong to.
    """
    roots = list(
        dict.fromkeys(root for m, c in sorted(words.items()) if c > 0 for root in _roots(completion, m[0], positive))
    )
    pairs = {(one, other): _product(completion, one, other) for one in roots for other in roots}
    shared = Counter(monomial for monomial in pairs.values() if monomial is not None)
    if not words.keys() <= shared.keys():
        return None
    gram: dict[Root, dict[Root, Fraction]] = {root: {} for root in roots}
    for (one, other), monomial in pairs.items():
        if monomial in words:
            gram[one][other] = words[monomial] / shared[monomial]
    found = by_lagrange(gram)
    if found is None:
        return None
    return [(factor, middle, {inner: c for (_, inner), c in row.items()}) for (middle, _), factor, row in found]


def _product(completion: Completion, one: Root, other: Root) -> Monomial | None:
    """The trace of the product of two roots, one transposed; None where they do not go together."""
    (middle, (scalars, word)), (another, (others, behind)) = one, other
    algebra = completion.algebra
    ends = [(algebra.height(each[0]), algebra.width(each[-1])) if each else (1, 1) for each in (word, behind)]
    if middle != another or ends[0] != ends[1]:
        return None
    inner = algebra.product(algebra.alone(algebra.flipped(word)), algebra.alone(middle))
    ((monomial, _),) = algebra.trace(algebra.product(inner, algebra.alone(behind)), ends[0][1]).items()
    return _reduced(completion, (tuple(sorted((*scalars, *others, *monomial[0]))), ()))


def _reduced(completion: Completion, monomial: Monomial) -> Monomial | None:
    """What is known to be the same, if that is one monomial."""
    found = Derived({monomial: Fraction(1)}, {})
    completion.reduce(found)
    return next(iter(found.words)) if [*found.words.values()] == [1] else None


def _roots(completion: Completion, atoms: tuple[Atom, ...], positive: Collection[int]) -> Iterator[Root]:
    """What a product of scalars is the square of."""
    count = Counter(atoms)
    half = tuple(sorted(atom for atom, times in count.items() for _ in range(times // 2)))
    odd = sorted(atom for atom, times in count.items() if times % 2)
    signed = [(kind, word) for kind, word in odd if kind == "word" and len(word) == 1 and word[0] >> 1 in positive]
    factor: Letters = signed[0][1] if signed else ()
    rest = [atom for atom in odd if atom not in signed]
    if len(signed) <= 1 and not rest:
        yield factor, (half, ())
    if len(signed) <= 1 and len(rest) == 1:
        ((kind, word),) = rest
        for turn in range(len(word)) if kind == "trace" else (0,):
            for middle, root in _halves(completion, word[turn:] + word[:turn], positive):
                if not (middle and signed):
                    yield middle or factor, (half, root)
    if len(atoms) == 2 and not signed:
        sides = [[root for middle, root in _halves(completion, word, ()) if not middle] for _, word in atoms]
        flipped = completion.algebra.flipped
        for one in sides[0]:
            yield from (((), ((), each)) for other in sides[1] for each in (one + flipped(other), other + flipped(one)))


def _halves(completion: Completion, word: Letters, positive: Collection[int]) -> Iterator[tuple[Letters, Letters]]:
    """A letter that is not negative, or none, with what stands on its right and, transposed, on its left."""
    size = len(word) // 2
    end = len(word) - size
    turned = _reduced(completion, ((), completion.algebra.flipped(word[:size])))
    if size and turned == _reduced(completion, ((), word[end:])) and all(k >> 1 in positive for k in word[size:end]):
        yield word[size:end], word[end:]
