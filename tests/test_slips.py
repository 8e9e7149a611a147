"""The slips of the pen that are made, and those that are none because the words still mean the same."""

from __future__ import annotations

from collections import Counter

import pytest

from chasles.statements import Claim, Definition, problem_of, symmetric, unit
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    Identity,
    Node,
    cos,
    cross,
    dot,
    integral,
    matrix,
    norm,
    number,
    paren,
    rate,
    scalar,
    sin,
    square,
    tr,
    vector,
)

from .meaning import Meaning
from .mutation import Mutant, mutants_of

e, a, b, c = (vector(name, name, name) for name in "eabc")
a_ = vector("a'", "a'", "another a")
phi, x, y = (scalar(name, name, name) for name in ("phi", "x", "y"))
rho = scalar("rho", "rho", "a density", constant=True)
M, S, rotation = (square(name, name, name) for name in "MSQ")
w = vector("w", "w", "a spin", FREQUENCY)
one = Identity(3)


@pytest.mark.parametrize(
    ("claim", "slips"),
    [
        (Claim("1", a + b, b + a), {"sign": 4, "term left out": 4, "letter": 4, "factor of two": 4}),
        (Claim("1", cross(a, b), -cross(b, a)), {"sign": 2, "operands swapped": 2, "letter": 4}),
        (Claim("1", M.T @ a, M @ a), {"sign": 2, "transpose lost": 0, "transpose added": 1, "factor left out": 2}),
        (Claim("1", sin(phi), 2 * cos(phi)), {"sign": 2, "sine and cosine": 2, "number": 2, "half of the angle": 2}),
        (Claim("1", cos(phi / 2), x), {"factor left out": 1, "number": 2}),
        (Claim("1", norm(a) ** 2, dot(a, a)), {"sign": 2, "exponent": 2}),
        (Claim("1", dot(a, b), number(0)), {"sign": 0, "number": 1, "letter": 2, "factor of two": 0}),
        (Claim("1", x * y * a, a / x), {"divided, not multiplied": 2, "multiplied, not divided": 1}),
        (Claim("1", x * paren(a + b + c), x * a), {"brackets left out": 2}),
        (Claim("1", M @ paren(a - b), a), {"brackets left out": 2}),
        (Claim("1", rate(x) * y, 2 * x * rate(y)), {"rate of the other factor": 2, "rate left out": 0}),
        (Claim("1", matrix((one, CPM(a)), (M, one)), matrix((M, M), (M, M))), {"block left out": 8, "rows swapped": 1}),
        (Claim("1", matrix((a, b), (b, c)), matrix((a, a), (a, b))), {"blocks exchanged": 6}),
        (Claim("1", cross(a, b) + c, c), {"letters exchanged": 2}),
    ],
)
def test_slips_are_made_everywhere(claim: Claim, slips: dict[str, int]) -> None:
    made = Counter(mutant.change.slip for mutant in mutants_of(claim, "printed", []))
    assert {slip: made[slip] for slip in slips} == slips


def test_a_mark_is_lost_only_where_the_letter_means_something_without_it() -> None:
    claim = Claim("1", cross(a_, b), -cross(b, a_))
    for letters, count in (({}, 0), ({"b": b}, 0), ({"a": a}, 2)):
        made = [m for m in mutants_of(claim, "printed", [], chapter=letters) if m.change.slip == "mark lost"]
        assert len(made) == count


SAME_IN_WORDS: dict[str, tuple[Node, Node]] = {
    "scalars in the other order": (x * y * a, y * x * a),
    "transpose of a symmetric spelling": (M @ M.T, (M @ M.T).T),
    "trace of a transpose": (tr(M), tr(M.T)),
    "trace of a product": (tr(M @ S), tr(S @ M)),
    "sign under a square": (norm(a - b) ** 2, norm(b - a) ** 2),
    "skew-symmetric": (CPM(a) @ CPM(a).T, CPM(a).T @ CPM(a)),
    "under an integral": (integral(rho * (CPM(a) @ CPM(a).T), rho, a), integral(rho * (CPM(a).T @ CPM(a)), rho, a)),
    "the product rule": (rate(dot(a, b)), dot(rate(a), b) + dot(a, rate(b))),
}
OTHER_IN_WORDS: dict[str, tuple[Node, Node]] = {
    "order of a vector product": (cross(a, b), cross(b, a)),
    "transpose": (M @ a, M.T @ a),
    "order of matrices": (M @ S, S @ M),
    "density": (integral(rho * a, rho, a), integral(rho * (rho * a), rho, a)),
    "what is integrated": (integral(rho * a, rho, a), integral(rho * x * a, rho, a)),
    "unit vector": (dot(e, e) * a, a),
    "symmetric matrix": (S @ a, S.T @ a),
    "rotation": (rotation @ e, rotation.T @ e),
    "rate": (dot(rate(a), b), dot(a, rate(b))),
    "angle": (cos(phi), cos(phi / 2)),
}
GIVEN = Definition("0", rotation, e @ e.T + cos(phi) * (one - e @ e.T) + sin(phi) * CPM(e), assuming=(unit(e),))


def meaning_of(said: Node) -> Meaning:
    claim = Claim("1", said, 2 * said, given=(GIVEN,), assuming=(unit(e), symmetric(S)))
    return Meaning.of(problem_of(claim), (a, b, w))


@pytest.mark.parametrize("pair", SAME_IN_WORDS)
def test_what_says_the_same_in_other_words_is_no_mutant(pair: str) -> None:
    said, again = SAME_IN_WORDS[pair]
    meaning = meaning_of(said)
    assert meaning.free
    assert meaning.of_words(said) == meaning.of_words(again)


@pytest.mark.parametrize("pair", OTHER_IN_WORDS)
def test_what_is_the_same_by_a_hypothesis_or_a_definition_alone_is_a_mutant(pair: str) -> None:
    said, other = OTHER_IN_WORDS[pair]
    meaning = meaning_of(said)
    assert meaning.free
    assert meaning.of_words(said) != meaning.of_words(other)


def test_what_is_given_tells_what_is_symmetric() -> None:
    meaning = meaning_of((S + rotation) @ cross(w, e))
    assert meaning.given
    assert meaning.is_symmetric(S)
    assert not meaning.is_symmetric(rotation)
    assert not meaning.is_symmetric(CPM(w))


def test_each_meaning_is_a_mutant_once() -> None:
    claim = Claim("1", 2 * x * a, x * a + x * a)
    alike: list[Mutant] = []
    meaning = Meaning.of(problem_of(claim))
    made = [str(m.change.whole) for m in mutants_of(claim, "printed", [], meaning, alike=alike) if "left" in m.where]
    assert "2 (2 x a)" in made
    assert not [m for m in alike if m.change.slip == "factor of two"]
    assert {m.change.slip for m in alike} <= {"letters exchanged", "factors swapped"}
    values = [meaning.of_words(m.change.whole) for m in mutants_of(claim, "printed", [], meaning) if "left" in m.where]
    assert len(set(values)) == len(values)


def test_without_a_meaning_every_spelling_is_a_mutant() -> None:
    claim = Claim("1", tr(M @ S), tr(S @ M))
    with_meaning = {str(m) for m in mutants_of(claim, "printed", [], Meaning.of(problem_of(claim)))}
    without = {str(m) for m in mutants_of(claim, "printed", [])}
    assert with_meaning < without
    assert not [m for m in with_meaning if "factors swapped" in m]
