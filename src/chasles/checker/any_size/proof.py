"""Does a claim on matrices of any size follow? It is a sum of known equations, each multiplied from both sides."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from chasles.checker.any_size.at_sizes import PointAtSizes
from chasles.checker.any_size.free_algebra import Words, added
from chasles.checker.any_size.free_squares import square
from chasles.checker.any_size.induction import first_and_next
from chasles.checker.any_size.words import SymbolicReading
from chasles.checker.sparse import Rejected
from chasles.statements import Goal, Problem
from chasles.statements.inequalities import as_differences
from chasles.vocabulary.measure import Extent


def check_words(problem: Problem, certificate: Mapping[str, Any]) -> None:
    """Each difference of two sides is the sum of known equations that the certificate says; `Rejected` if it is not.

    What is claimed not to be negative is such a sum and squares. Nor is it said of nothing: the witness satisfies all
    that is assumed. By induction it follows for 1, and for n + 1 from what is claimed of n.
    """
    PointAtSizes(problem, certificate["witness"]).require()
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
