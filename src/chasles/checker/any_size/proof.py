"""Does a claim on matrices of any size follow? It is a sum of known equations, each multiplied from both sides.

What is not negative is a sum of squares in the free algebra: |v|^2, v^T M v with a matrix M that is visibly not
negative, tr(V^T V). By induction over an exponent what is said of a letter n holds for 1, and for n + 1 if for n.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace as with_fields
from fractions import Fraction
from typing import Any

from chasles.checker.any_size.at_sizes import PointAtSizes, sizes_in
from chasles.checker.any_size.free_algebra import FreeAlgebra, Letters, Words, added
from chasles.checker.any_size.words import SymbolicReading
from chasles.checker.sparse import Rejected
from chasles.statements import Goal, Problem
from chasles.statements.inequalities import as_differences
from chasles.vocabulary import Node, walk
from chasles.vocabulary.measure import Extent
from chasles.vocabulary.sizes import Size, at_exponent, sizes_of

PROJECTION = {"idempotent", "symmetric"}
"""What makes a matrix an orthogonal projection: x . P x is the square of the length of P x."""


def first_and_next(problem: Problem, name: str) -> tuple[Problem, Problem]:
    """The problem for 1 and for n + 1; `Rejected` if n is no exponent, or something is assumed of it."""
    letter = Size(name)
    said = [node for goal in problem.conditions for node in goal.sides]
    said += [node for h in problem.hypotheses for node in (*h.subjects, *h.nonvanishing, *sum(h.equations, ()))]
    sides = [node for goal in problem.goals for node in goal.sides]
    parts = {part for node in (*said, *sides) for part in walk(node)}
    # What is defined by n is something else for n + 1, and has one name.
    if letter in sizes_of(said) or (
        letter in sizes_of(right for _, right in problem.rules) and parts & {*dict(problem.rules)}
    ):
        raise Rejected(f"something is assumed of {name}: what is said of another number does not follow from it")

    def at(exponent: Extent) -> Problem:
        def put(node: Node) -> Node:
            return at_exponent(node, letter, exponent)

        goals = tuple(Goal(goal.label, put(goal.left), put(goal.right)) for goal in problem.goals)
        return with_fields(problem, goals=goals)

    first = at(1)
    if name not in sizes_in(problem) or name in sizes_in(first):
        raise Rejected(f"{name} is no exponent, or a number of rows or columns too")
    return first, at(letter + 1)


def is_mirrored(algebra: FreeAlgebra, word: Letters, letters: Collection[int]) -> bool:
    """Whether it is a word with its transpose before it, with one of the letters, or nothing, between them."""
    size = len(word) // 2
    end = len(word) - size
    return algebra.flipped(word[:size]) == word[end:] and all(k >> 1 in letters for k in word[size:end])


def nonnegative(reading: SymbolicReading) -> set[int]:
    """The letters that are not negative: by a hypothesis, as lengths are, and the inverses of visibly such matrices."""
    kinds: dict[Any, set[str]] = {}
    for hypothesis in reading.problem.hypotheses:
        for node in hypothesis.subjects:
            kinds.setdefault(node, set()).add(hypothesis.kind)
    said = [n for n, k in kinds.items() if n not in reading.rules and (k & {"positive", "definite"} or k >= PROJECTION)]
    found = {letter for node in said for letter in _letters(reading(node).rows[0][0])} | reading.lengths
    for _ in reading.inverses:
        for inverse, of in reading.inverses.values():
            parts = [(c, word, {inner for _, inner in scalars}) for (scalars, word), c in of.items()]
            single = all(len(scalar) == 1 and scalar[0] >> 1 in found for _, _, each in parts for scalar in each)
            if single and all(c > 0 and is_mirrored(reading, word, found) for c, word, _ in parts):
                found |= _letters(inverse)
    return found


def _letters(words: Words) -> set[int]:
    """The letters that occur."""
    return {k >> 1 for scalars, word in words for part in (word, *(inner for _, inner in scalars)) for k in part}


def square(
    reading: SymbolicReading,
    times: str,
    middle: Sequence[str],
    root: Sequence[tuple[str, Sequence[Any], Sequence[str]]],
) -> Words:
    """A square, or v^T M v with a letter M that is not negative; `Rejected` for what is none."""
    between, total = reading.read(middle), Words()
    words = [reading.read(word) for _, _, word in root]
    height, width = (reading.height(words[0][0]), reading.width(words[0][-1])) if words[0] else (1, 1)
    fits = all(reading.fits(word, height, width) for word in words)
    fits = fits and (reading.fits(between, height, height) or reading.fits(between, 1, 1))
    if Fraction(times) <= 0 or len(between) > 1 or not fits or not {k >> 1 for k in between} <= nonnegative(reading):
        raise Rejected(f"{times} times the square of {root} is not seen not to be negative")
    for (coefficient, scalars, _), word in zip(root, words, strict=True):
        one = reading.alone(word)
        for kind, inner in scalars:
            one = reading.product(reading.of_atom(kind, reading.read(inner)), one)
        added(total, one, Fraction(coefficient))
    inner_words = reading.product(reading.product(reading.transposed(total), reading.alone(between)), total)
    return {monomial: Fraction(times) * c for monomial, c in reading.trace(inner_words, width).items()}


def check_words(problem: Problem, certificate: Mapping[str, Any]) -> None:
    """Each difference of two sides is the sum of known equations that the certificate says; `Rejected` if it is not.

    What is claimed not to be negative is such a sum and squares. Nor is it said of nothing: the witness satisfies all
    that is assumed. By induction it follows for 1, and for n + 1 from what is claimed of n.
    """
    PointAtSizes(problem, certificate["witness"]).require("condition")
    if steps := certificate.get("induction"):
        first, following = first_and_next(problem, steps["over"])
        _check_differences(first, steps["first"], ())
        _check_differences(following, steps["next"], problem.goals)
    else:
        _check_differences(problem, certificate, ())


def _check_differences(problem: Problem, certificate: Mapping[str, Any], assumed: Sequence[Goal]) -> None:
    plain, signs = as_differences(problem) or (problem, ("",) * len(problem.goals))
    if assumed and any(signs):
        raise Rejected("what is said by induction is an equation")
    reading = SymbolicReading(plain, assumed)
    for number, (goal, sign) in enumerate(zip(plain.goals, signs, strict=True)):
        for i, j, words, height, width in reading.differences(goal.left, goal.right):
            left = dict(words)
            for said in certificate.get("squares", {}).get(str(number), ()) if sign else ():
                added(left, square(reading, *said), Fraction(-1))
            for term in certificate["words"].get(f"{number}:{i},{j}", ()):
                added(left, _multiple(reading, term, height, width), -Fraction(term["times"]))
            if left or sign == "positive":
                raise Rejected(f"block {i}, {j} of equation {number + 1} does not follow")


def _multiple(reading: SymbolicReading, term: Mapping[str, Any], height: Extent, width: Extent) -> Words:
    """A known equation multiplied from both sides, or the scalar or trace that it is then, before a word.

    Raises `Rejected` where something does not fit.
    """
    known = reading.known.get(term["of"])
    if known is None:
        raise Rejected(f"it is said to follow from {term['of']!r}, which the statement does not assume")
    words, rows, columns = known.words, known.height, known.width
    if term.get("transposed"):
        words, rows, columns = reading.transposed(words), columns, rows
    left, right, beside = (reading.read(term.get(name, ())) for name in ("left", "right", "beside"))
    outer = {"": (height, width), "scalar": (1, 1)}.get(term.get("as", ""))
    outer = outer or (reading.height(left[0]) if left else rows,) * 2
    if not (reading.fits(left, outer[0], rows) and reading.fits(right, columns, outer[1])):
        raise Rejected(f"{term['of']!r} is multiplied by what does not fit")
    words = reading.product(reading.product(reading.alone(left), words), reading.alone(right))
    if term.get("as"):
        if not reading.fits(beside, height, width):
            raise Rejected(f"{term['of']!r} stands before what does not fit")
        words = reading.trace(words, outer[0]) if term["as"] == "trace" else words
        words = reading.product(words, reading.alone(beside))
    for kind, word in term.get("scalars", ()):
        words = reading.product(reading.of_atom(kind, reading.read(word)), words)
    return words
