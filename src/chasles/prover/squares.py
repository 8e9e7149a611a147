"""Inequalities by sums of squares: what is claimed not to be negative is one, up to what the hypotheses say.

Scalars of the free algebra are such sums too: |v|^2, v^T M v of a positive-definite M, tr(V^T V).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from fractions import Fraction

from chasles.algebra.rings import written
from chasles.algebra.squares import Square, by_lagrange, sum_of_squares
from chasles.checker.any_size.free_algebra import Atom, Letters, Monomial, Words
from chasles.checker.certificate import check
from chasles.checker.sparse import Rejected
from chasles.problems.context import Context, build, difference
from chasles.problems.divisors import UndeclaredDivisor
from chasles.problems.generators import entries
from chasles.problems.variables import Untreatable
from chasles.prover.certifying import ProvedEntry, certified, proved
from chasles.prover.conditions import solve_conditions
from chasles.prover.free_words import Completion
from chasles.prover.rewriting_words import Derived
from chasles.prover.sources import DeclaredPoints
from chasles.statements import Hypothesis, Problem
from chasles.statements.inequalities import as_differences
from chasles.verdict import Holds, HoldsUnder

Root = tuple[Letters, Monomial]
"""A letter that is positive, or none, and what stands on its right and, transposed, on its left."""
SquareOfWords = tuple[Fraction, Letters, dict[Monomial, Fraction]]


def decide_by_squares(problem: Problem, own: tuple[Hypothesis, ...]) -> Holds | HoldsUnder | None:
    """The verdict where all that is claimed is seen not to be negative, or to be positive; None where it is not."""
    found = as_differences(problem)
    if found is None or found[0].has_functions:
        return None
    plain, signs = found
    try:
        context = build(plain)
        conditions, solved = solve_conditions(context)
        parts = [_entries(context, number, sign) for number, sign in enumerate(signs)]
        witness = DeclaredPoints().witness(context, solved)
    except (Untreatable, UndeclaredDivisor):
        return None
    if witness is None or None in parts:
        return None
    done = [part for part in parts if part is not None]
    verdict = certified(context, conditions, solved, [entry for found, _ in done for entry in found], own, witness)
    assert isinstance(verdict, Holds | HoldsUnder)
    certificate = {**verdict.certificate, "squares": [_written(context, squares) for _, squares in done]}
    try:
        check(problem, "printed", certificate)
    except Rejected:
        return None
    used = {name for _, squares in done for name in _signs(context, squares)}
    needs = (*verdict.needs, *(h.text for h in problem.hypotheses if h.text in used and h.text not in verdict.needs))
    unused = tuple(text for text in verdict.unused if text not in used)
    return proved(needs, certificate, verdict.witness, unused)


def _entries(context: Context, number: int, sign: str) -> tuple[list[ProvedEntry], list[Square]] | None:
    """What is left of a claim when its squares are taken away, which the hypotheses say is zero, and the squares."""
    ring, goal = context.field.ring, context.problem.goals[number]
    signs = _nonnegative(context)
    positive = {place for place, text in signs.items() if text}
    squares: list[Square] | None = []
    found: list[ProvedEntry] = []
    for i, j, ratio in entries(difference(context, goal)):
        cofactors, remainder = context.basis.reduce(ratio.numerator)
        if sign:
            squares = None if any(ratio.denominator) else sum_of_squares(dict(ring.terms(remainder)), signs)
        elif remainder != 0:
            return None
        if squares is None or (sign == "positive" and not any(_is_positive(each, positive) for each in squares)):
            return None
        left = ratio - context.field.ratio(remainder)
        found.append(
            ProvedEntry(goal, f"{number}:{i},{j}", (i + 1, j + 1), left, cofactors, not context.basis.explicit)
        )
    return found, squares or []


def _is_positive(square: Square, positive: set[int]) -> bool:
    _, factor, root = square
    return not any(map(any, root)) and all(place in positive for place, e in enumerate(factor) if e)


def _nonnegative(context: Context) -> dict[int, str]:
    """The places of variables that are not negative, with what says that they are positive."""
    said = {h.subjects[0]: h.text for h in context.active if h.kind == "positive"}
    found: dict[int, str] = {}
    for place, variable in enumerate(context.variables):
        text = (
            said.get(variable.symbol)
            if variable.kind == "entry" and variable.symbol is not None and not variable.order
            else None
        )
        if text or variable.kind == "norm":
            found[place] = text or ""
    return found


def _signs(context: Context, squares: list[Square]) -> set[str]:
    """The texts of the hypotheses by which factors are not negative."""
    said = _nonnegative(context)
    return {said[place] for _, factor, _ in squares for place, e in enumerate(factor) if e}


def _written(context: Context, squares: list[Square]) -> list[list[str]]:
    ring = context.field.ring
    roots = ((c, ring.from_terms({factor: Fraction(1)}), ring.from_terms(root)) for c, factor, root in squares)
    return [[str(c), written(ring, factor), written(ring, root)] for c, factor, root in roots]


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
