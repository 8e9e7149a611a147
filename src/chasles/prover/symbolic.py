"""The decision of what is said of matrices of any size: by words of the free algebra, or refuted at numbers for sizes.

What is not proved there may still be true: then it is undecided. Only a point at which all that is assumed holds, and
the two sides differ, refutes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import islice
from typing import Any

from chasles.checker.any_size.at_sizes import PointAtSizes, sizes_in
from chasles.checker.any_size.free_algebra import Letters, added
from chasles.checker.any_size.known_relations import Known
from chasles.checker.any_size.proof import PROJECTION, check_words, first_and_next, nonnegative, square
from chasles.checker.any_size.words import SymbolicReading
from chasles.checker.sparse import Rejected
from chasles.points.at_sizes import points_at_sizes
from chasles.prover.certifying import UNSAID, proved
from chasles.prover.free_words import Completion
from chasles.prover.rewriting_words import Derived, Multiple, Occurrence, Proof
from chasles.prover.squares import SquareOfWords, squares_of_words
from chasles.statements import Hypothesis, Problem
from chasles.statements.inequalities import as_differences
from chasles.verdict import Counterexample, Fails, Posed, Undecided, Verdict

POINTS = 60
"""So many points are looked at for one that refutes."""
OPEN = "the algebra of matrices of any size neither proves nor refutes it: say it for numbers in place of the letters"
NO_POINT = "it follows from its hypotheses, but no point was found that satisfies them all"


def decide_words(problem: Problem, own: tuple[Hypothesis, ...] = ()) -> Verdict:
    """The verdict on a problem in which letters stand for sizes; `own` are the hypotheses whose use is reported."""
    plain, signs = as_differences(problem) or (problem, ())
    try:
        proofs = _Proofs(SymbolicReading(plain), signs)
    except Rejected as reason:
        found = _refuted(problem)
        return Fails(found) if found else Undecided(str(reason))
    if not proofs.soon():
        found = _refuted(problem)
        if found:
            return Fails(found)
        by_induction = None if signs else _by_induction(problem)
        if by_induction is None and not proofs.at_length():
            return Undecided(OPEN)
    else:
        by_induction = None
    witness = next(points_at_sizes(problem, "condition"), None)
    if witness is None:
        return Undecided(NO_POINT)
    steps, needed = by_induction or ({}, ())
    certificate = {**(steps or proofs.spelled()), "witness": {name: str(value) for name, value in witness.items()}}
    try:
        check_words(problem, certificate)
    except Rejected as reason:
        return Undecided(f"an answer was found that the checker does not follow: {reason}")
    used = {*(needed or proofs.needs()), *(h.text for h in problem.presupposed)}
    needs = tuple(dict.fromkeys(h.text for h in problem.hypotheses if h.text in used and h.kind not in UNSAID))
    unused = tuple(h.text for h in own if h.text not in needs)
    return proved(needs, certificate, witness, unused)


def pose_at_sizes(problem: Problem) -> Verdict:
    """A condition, with a point that satisfies it together with the hypotheses."""
    witness = next(points_at_sizes(problem), None)
    return Undecided("no point was found that satisfies the condition") if witness is None else Posed(witness)


def _by_induction(problem: Problem) -> tuple[dict[str, Any], set[str]] | None:
    """A proof by induction over one of the exponents, and the texts of the hypotheses that it uses."""
    for name in sizes_in(problem):
        try:
            first, following = first_and_next(problem, name)
            proofs = _Proofs(SymbolicReading(first), ()), _Proofs(SymbolicReading(following, problem.goals), ())
        except Rejected:
            continue
        if all(each.soon() or each.at_length() for each in proofs):
            steps = {"over": name, "first": proofs[0].spelled(), "next": proofs[1].spelled()}
            return {"words": {}, "induction": steps}, {text for each in proofs for text in each.needs()}
    return None


class _Proofs:
    """The proofs of all blocks of all claims."""

    def __init__(self, reading: SymbolicReading, signs: Sequence[str]) -> None:
        self.reading = reading
        self.squares: dict[str, list[SquareOfWords]] = {}
        self._unsigned = {f"{number}:1,1" for number, sign in enumerate(signs) if sign == "not negative"}
        self.claims: dict[str, Derived] = {}
        for number, goal in enumerate(reading.problem.goals):
            for i, j, words, _, _ in reading.differences(goal.left, goal.right):
                self.claims[f"{number}:{i},{j}"] = Derived(dict(words), {})
        known = [Derived(dict(k.words), _from(label, False)) for label, k in reading.known.items()]
        turned = [Derived(reading.transposed(k.words), _from(label, True)) for label, k in reading.known.items()]
        self.completion = Completion(reading, [*known, *turned])

    def soon(self) -> bool:
        """Whether the claims follow by what is known as it stands."""
        for _ in range(2 * len(self.reading.known)):
            if self._done() or not self.completion.extend():
                break
        return self._done()

    def at_length(self) -> bool:
        """Whether the claims follow by what the completion finds besides."""
        while not self._done():
            if not self.completion.extend():
                return self._done(multiplied=True)
        return True

    def _done(self, multiplied: bool = False) -> bool:
        for place, claim in self.claims.items():
            self.completion.reduce(claim)
            if claim.words and multiplied:
                self._multiply(claim)
            if claim.words and place in self._unsigned and place not in self.squares:
                squares = squares_of_words(self.completion, claim.words, nonnegative(self.reading))
                for each in squares or ():
                    added(claim.words, square(self.reading, *self._square(each)), Fraction(-1))
                self.squares |= {place: squares} if squares else {}
                self.completion.reduce(claim)
        return not any(claim.words for claim in self.claims.values())

    def _multiply(self, claim: Derived) -> None:
        """Prove a claim f by M f or f M, for a matrix M with an inverse W: f is W (M f) - (W M - 1) f."""
        reading = self.reading
        for name, (inverse, matrix) in reading.inverses.items():
            ((_, letter),) = inverse
            for side in ("left", "right"):
                label, words = f"{name} from the {side} [1, 1]", claim.words
                known = reading.known.get(label)
                if not letter or known is None or not all(_fits(reading, known, word, side) for _, word in words):
                    continue
                both = (matrix, words) if side == "left" else (words, matrix)
                again = Derived(reading.product(*both), {})
                self.completion.reduce(again)
                if again.words:
                    continue
                back = Derived({}, {term: -c for term, c in again.proof.items()})
                place = Occurrence((), left=letter) if side == "left" else Occurrence((), right=letter)
                self.completion.subtract(claim, back, place, Fraction(1))
                for (scalars, word), coefficient in words.items():
                    around = ((), word) if side == "left" else (word, ())
                    term = Multiple(scalars, around[0], label, False, around[1], "", ())
                    claim.proof[term] = claim.proof.get(term, Fraction(0)) + coefficient
                claim.words = {}
                return

    def needs(self) -> Iterator[str]:
        """The texts of the hypotheses that are used."""
        for claim in self.claims.values():
            yield from (self.reading.known[term.of].needs for term in claim.proof)
        if any(middle for found in self.squares.values() for _, middle, _ in found):
            kinds = ("positive", "definite", *PROJECTION)
            yield from (h.text for h in self.reading.problem.hypotheses if h.kind in kinds)

    def spelled(self) -> dict[str, Any]:
        """For each block the terms of its proof, and the squares that are left."""
        words = {place: [self._term(*each) for each in c.proof.items()] for place, c in self.claims.items() if c.proof}
        squares = {place.partition(":")[0]: list(map(self._square, found)) for place, found in self.squares.items()}
        return {"words": words} | ({"squares": squares} if squares else {})

    def _square(self, found: SquareOfWords) -> list[Any]:
        spelled = self.reading.spelled
        factor, middle, root = found
        parts = [[str(c), [[k, spelled(w)] for k, w in scalars], spelled(word)] for (scalars, word), c in root.items()]
        return [str(factor), spelled(middle), parts]

    def _term(self, term: Multiple, coefficient: Fraction) -> dict[str, Any]:
        spelled = self.reading.spelled
        said: dict[str, Any] = {"times": str(-coefficient), "of": term.of}
        said |= {"transposed": True} if term.transposed else {}
        said |= {"as": term.kind} if term.kind else {}
        words = {"left": term.left, "right": term.right, "beside": term.beside}
        said |= {name: spelled(word) for name, word in words.items() if word}
        return said | ({"scalars": [[kind, spelled(word)] for kind, word in term.scalars]} if term.scalars else {})


def _from(label: str, transposed: bool) -> Proof:
    return {Multiple((), (), label, transposed, (), "", ()): Fraction(1)}


def _fits(reading: SymbolicReading, known: Known, word: Letters, side: str) -> bool:
    """Whether a word can be multiplied by a matrix from that side."""
    if not word:
        return False
    extent = reading.height(word[0]) if side == "left" else reading.width(word[-1])
    return bool(extent == known.height)


def _refuted(problem: Problem) -> Counterexample | None:
    """A counterexample at the smallest sizes at which one is found."""
    for at in islice(points_at_sizes(problem), POINTS):
        point = PointAtSizes(problem, at)
        for goal in problem.goals:
            try:
                left, right = point(goal.left), point(goal.right)
            except Rejected:
                continue
            for i, row in enumerate(left):
                for j, entry in enumerate(row):
                    if entry != right[i][j]:
                        return Counterexample(at, (i + 1, j + 1), str(entry), str(right[i][j]), goal.label)
    return None
