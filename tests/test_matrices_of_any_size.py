"""Matrices whose sizes are letters: identities of handbooks hold; what is got wrong in them is refuted, not proved."""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from fractions import Fraction
from itertools import islice
from typing import Any

import pytest

from chasles.checker.any_size.at_sizes import PointAtSizes
from chasles.checker.certificate import check
from chasles.checker.refutation import check_counterexample
from chasles.checker.sparse import Rejected
from chasles.deciding import decided
from chasles.decisions.plain_data import from_data, to_data
from chasles.decisions.session import Session
from chasles.lowering.declaration import requested
from chasles.lowering.lower import program_of
from chasles.points.at_sizes import points_at_sizes
from chasles.repairs.repair import repair
from chasles.statements import (
    Claim,
    Condition,
    Definite,
    Definition,
    Entry,
    Hypothesis,
    Kernel,
    Problem,
    Section,
    Theorem,
    definite,
    positive,
    problem_of,
    rotation,
    symmetric,
    unit,
)
from chasles.statements.inequalities import PositiveDefinite, says_that
from chasles.statements.matrices import (
    commuting,
    idempotent,
    invertible,
    orthogonal,
    orthonormal_columns,
    skew_symmetric,
    with_sizes,
)
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder, IllFormed, Posed, Undecided, Verdict
from chasles.vocabulary import (
    LENGTH,
    MASS,
    Identity,
    Misfit,
    Node,
    Symbol,
    Zero,
    column,
    cross,
    det,
    dot,
    inverse,
    latex,
    matrix,
    norm,
    number,
    plain,
    printed,
    square,
    tr,
    vector,
)
from chasles.vocabulary.arguments import WrongArgument
from chasles.vocabulary.functions import Relation
from chasles.vocabulary.sizes import Size, rectangular

from .matrix_identities import IDENTITIES, A, B, D, I, P, Q, U, V, claims, m, n, s, slips, t, u, v, x, y

NAMES = [name for name, *_ in IDENTITIES]


def verdict_on(left: Node, right: Node, *assuming: Any) -> Verdict:
    return Session().decide(Claim("1", left, right, assuming=assuming)).verdict


def agree(problem: Problem) -> int:
    """At how many points the two sides are equal; fails at one where they are not."""
    count = 0
    for at in islice(points_at_sizes(problem), 25):
        point = PointAtSizes(problem, at)
        for goal in problem.goals:
            try:
                assert point(goal.left) == point(goal.right), at
            except Rejected:
                continue
            count += 1
    return count


@pytest.mark.sampled(7)
@pytest.mark.parametrize(("name", "claim"), list(claims()), ids=NAMES)
def test_identities_hold(name: str, claim: Claim) -> None:
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, Holds | HoldsUnder), f"{name}: {verdict}"
    assert set(verdict.needs) >= {h.text for h in claim.assuming} - set(verdict.unused)
    check(claim, "printed", verdict.certificate)
    assert from_data(to_data(verdict)) == verdict


@pytest.mark.sampled(7)
@pytest.mark.parametrize(("name", "left", "right", "assuming"), IDENTITIES, ids=NAMES)
def test_slips_are_refuted_or_are_none(name: str, left: Node, right: Node, assuming: Any) -> None:
    for kind, other in slips(right):
        try:
            problem = problem_of(Claim("1", left, other, assuming=assuming))
        except Misfit:
            continue
        verdict = decided(problem, assuming)
        if isinstance(verdict, Fails):
            check_counterexample(problem, verdict.counterexample)
        else:
            assert isinstance(verdict, Holds | HoldsUnder), f"{name}: {kind}: {other}: {verdict}"
            check(problem, "printed", verdict.certificate)
            assert agree(problem), f"{name}: {kind}: {other}"


def test_most_slips_are_refuted() -> None:
    found = {True: 0, False: 0}
    for _, left, right, assuming in IDENTITIES:
        for _, other in slips(right):
            problem = problem_of(Claim("1", left, other, assuming=assuming))
            found[isinstance(decided(problem), Fails)] += 1
    assert found[True] > 200
    assert found[False] < 20


FALSE = (
    ("matrices commute", A @ B, B @ A, ()),
    ("one inverse of a sum", inverse(A + B), inverse(A) + inverse(B), ()),
    ("a left inverse is a right one", U @ (inverse(U.T @ U) @ U.T), I, ()),
    ("a trace does not go everywhere", tr(A @ B @ Q), tr(B @ A @ Q), ()),
    ("traces multiply", tr(A @ B), tr(A) * tr(B), ()),
    ("lengths add", norm(x + y) ** 2, norm(x) ** 2 + norm(y) ** 2, ()),
    ("idempotent is the identity", P, I, (idempotent(P),)),
    ("orthogonal is symmetric", Q, Q.T, (orthogonal(Q),)),
    ("definite ones commute", A @ B, B @ A, (definite(A), definite(B))),
    ("the product of symmetric ones is", (A @ B).T, A @ B, (symmetric(A), symmetric(B))),
    ("Woodbury with the wrong sign", inverse(A + U @ V), inverse(A) + inverse(A) @ U @ V @ inverse(A), ()),
    (
        "blocks inverted one by one",
        inverse(matrix([A, U], [V, D])) @ matrix([A, U], [V, D]),
        matrix([I, U], [V, Identity(m)]),
        (),
    ),
    ("commuting passes on", A @ Q, Q @ A, (commuting(A, B), commuting(B, Q))),
)


@pytest.mark.parametrize(("name", "left", "right", "assuming"), FALSE, ids=[name for name, *_ in FALSE])
def test_common_errors_are_refuted(name: str, left: Node, right: Node, assuming: Any) -> None:
    claim = Claim("1", left, right, assuming=assuming)
    verdict = Session().decide(claim).verdict
    if name == "commuting passes on":
        assert not verdict.true
        return
    assert isinstance(verdict, Fails), verdict
    check_counterexample(problem_of(claim), verdict.counterexample)
    assert verdict.counterexample.at["n"] <= 2


def test_no_forged_certificate_is_accepted() -> None:
    claim = Claim("1", inverse(A + u @ v.T @ B), inverse(A + u @ v.T @ B))
    push = Claim("1", inverse(I + A @ B) @ A, A @ inverse(I + B @ A))
    for honest in (claim, push):
        problem = problem_of(honest)
        verdict = decided(problem)
        assert isinstance(verdict, HoldsUnder)
        check(problem, "printed", verdict.certificate)
        for forged in forgeries(dict(verdict.certificate)):
            with pytest.raises(Rejected):
                check(problem, "printed", forged)


def forgeries(certificate: dict[str, Any]) -> list[dict[str, Any]]:
    def without_witness(c: dict[str, Any]) -> None:
        c["witness"] = {}

    def singular(c: dict[str, Any]) -> None:
        c["witness"] = {"n": "1", "A": "1", "B": "-1", "u": "1", "v": "1"}

    def times(c: dict[str, Any]) -> None:
        term(c)["times"] = "2"

    def other(c: dict[str, Any]) -> None:
        term(c)["of"] = "everything"

    def turned(c: dict[str, Any]) -> None:
        term(c)["transposed"] = not term(c).get("transposed")

    def behind(c: dict[str, Any]) -> None:
        term(c)["right"] = [*term(c).get("right", ()), "A"]

    def unknown(c: dict[str, Any]) -> None:
        term(c)["left"] = ["Z"]

    def dropped(c: dict[str, Any]) -> None:
        c["words"] = {}

    def term(c: dict[str, Any]) -> dict[str, Any]:
        return next(iter(c["words"].values()))[0]  # type: ignore[no-any-return]

    made = []
    forge: Callable[[dict[str, Any]], None]
    for forge in (without_witness, singular, times, other, turned, behind, unknown, dropped):
        copy = deepcopy(certificate)
        forge(copy)
        made.append(copy)
    return made


def test_no_false_counterexample_is_accepted() -> None:
    problem = problem_of(Claim("1", A @ B, B @ A))
    verdict = decided(problem)
    assert isinstance(verdict, Fails)
    found = verdict.counterexample
    check_counterexample(problem, found)
    for at in ({**found.at, "n": Fraction(1)}, {"n": Fraction(2)}, {**found.at, "n": Fraction(1, 2)}, {}):
        with pytest.raises(Rejected):
            check_counterexample(problem, type(found)(at, found.entry, found.left, found.right))


REFUSED: tuple[tuple[Callable[[], object], str], ...] = (
    (lambda: U @ U, "cannot multiply U (n x m) by U (n x m)"),
    (lambda: A + U, "cannot add A (n x n) and U (n x m)"),
    (lambda: A @ x + U.T @ x, "cannot add A x (n x 1) and U^T x (m x 1)"),
    (lambda: tr(U), "a trace takes a square matrix, and U is n x m"),
    (lambda: inverse(U), "an inverse takes a square matrix, and U is n x m"),
    (lambda: matrix([A, V]), "in one row of blocks, A is n x n and V is m x n"),
    (lambda: column(A, U), "rows of blocks differ in width: A is n x n; but U is n x m"),
    (lambda: matrix([A, U], [V, D]) + A, "(n + m x n + m) and A (n x n)"),
    (lambda: dot(x, U.T @ x), "the scalar product is that of two columns of one height"),
    (lambda: cross(x, y), "a vector product takes a vector (3 x 1), and x is n x 1"),
    (lambda: A[1, 2], "n stands for any number of rows or columns"),
    (lambda: vector("q", "q", "a column", size="n"), "'n' is no size: write a whole number, or a letter for one"),
    (lambda: x.x, "n stands for any number of rows or columns"),
    (lambda: Claim("1", U.T @ x, x), "cannot equate U^T x (m x 1) and x (n x 1)"),
    (lambda: commuting(A, D), "A and D cannot commute: they are of different size"),
)


@pytest.mark.parametrize(("made", "said"), REFUSED)
def test_what_does_not_fit_is_refused(made: Callable[[], object], said: str) -> None:
    with pytest.raises((Misfit, WrongArgument)) as refused:
        made()
    assert said in str(refused.value)


def test_sizes_and_dimensions() -> None:
    M = square("M", "M", "a mass matrix", MASS, size=n)
    q = vector("q", "q", "lengths", LENGTH, size=n)
    assert plain(M @ q) == "M q"
    assert latex(inverse(M + A.T @ M @ A)) == r"\left( \mathbf{M} + \mathbf{A}^T \mathbf{M} \mathbf{A} \right)^{-1}"
    with pytest.raises(Misfit, match=r"cannot add M q \[kg m\] and q \[m\]"):
        M @ q + q
    assert verdict_on(inverse(M) @ M @ q, q).needs == ("det(M) != 0",)  # type: ignore[attr-defined]
    assert Identity(n + m).shape == matrix([A, U], [V, D]).shape
    assert Zero(n, 1 + m).shape[1] == Size("k", (1, m)) or str(Zero(n, 1 + m).shape[1]) == "1 + m"
    three = rectangular("T", "T", "a map", n, 3)
    assert (three.T @ three).shape == (3, 3)


def test_given_definitions_are_used() -> None:
    K = rectangular("K", "K", "a gain", n, m)
    gain = Definition("1", K, U @ inverse(D))
    claim = Claim("2", K @ D, U, given=(gain,))
    assert Session().decide(claim).verdict.true
    assert isinstance(Session().decide(Claim("3", K @ D, 2 * U, given=(gain,))).verdict, Fails)


def test_what_is_divided_by_is_needed() -> None:
    verdict = verdict_on(x / dot(x, y), x / dot(x, y) * dot(x, x) / dot(x, x))
    assert isinstance(verdict, HoldsUnder)
    assert verdict.needs == ("x . x != 0",)


@pytest.mark.parametrize("numbers", [{"n": 1, "m": 1}, {"n": 2, "m": 1}, {"n": 1, "m": 3}, {"n": 2, "m": 2}])
@pytest.mark.parametrize("name", ["push-through, rectangular", "covariance in information form", "right inverse"])
def test_at_numbers_for_the_sizes(name: str, numbers: dict[str, int]) -> None:
    """The same is decided by polynomials there; a right inverse is none of a matrix that is too high."""
    claim = with_sizes(dict(claims())[name], numbers)
    verdict = Session().decide(claim).verdict
    assert verdict.true != (name == "right inverse" and numbers["m"] > numbers["n"])
    if verdict.true:
        assert isinstance(verdict, HoldsUnder)
        check(claim, "printed", verdict.certificate)


@pytest.mark.parametrize("assume", [orthogonal, idempotent, skew_symmetric, orthonormal_columns])
def test_hypotheses_hold_somewhere_at_numbers(assume: Callable[[Symbol], Hypothesis]) -> None:
    claim = with_sizes(Claim("1", A @ A, A, assuming=(assume(A),)), {"n": 2})
    assert isinstance(Session().decide(claim).verdict, HoldsUnder if assume is idempotent else Fails)


def test_a_kernel_is_made_at_numbers() -> None:
    asked = Kernel(of=(A, x))
    with pytest.raises(WrongArgument, match="has no kernel: A x is of any size; give `with_sizes` one"):
        Claim("1", A @ x, A @ x, kernel=asked)
    with pytest.raises(WrongArgument, match="has no kernel"):
        Claim("1", dot(x, A @ x), dot(x, A @ x), kernel=asked)
    claim = with_sizes(Claim("1", dot(x, A @ x), dot(A.T @ x, x)), {"n": 4}, asked)
    assert claim.kernel is not None
    assert [argument.shape for argument in claim.kernel.of if isinstance(argument, Node)] == [(4, 4), (4, 1)]
    program = program_of(requested(Entry("form", Section("1", "Forms"), claim), Session().decide, claim.kernel))
    assert program.operations


def test_conditions_and_theorems() -> None:
    fixed = Condition("1", A @ x, x, on=(x,))
    assert isinstance(Session().decide(fixed).verdict, Posed)
    again = Session().decide(Claim("2", A @ A @ x, x, given=(fixed,))).verdict
    assert isinstance(again, Holds)
    check(Claim("2", A @ A @ x, x, given=(fixed,)), "printed", again.certificate)
    step = Condition("3", x, y + A @ x, on=(x,))
    solved = Claim("4", x, inverse(I - A) @ y, given=(step,), assuming=(invertible(I - A),))
    assert isinstance(Session().decide(solved).verdict, HoldsUnder)
    semidefinite = Theorem("3", "it is never negative", (Definite(x.T @ U @ U.T @ x, (dot(U.T @ x, U.T @ x),)),))
    assert Session().decide(semidefinite).verdict.true


@pytest.mark.parametrize(
    ("left", "right", "holds"),
    [
        (det(A @ B), det(B @ A), True),
        (det(A @ B), det(A) * det(B), True),
        (det(A.T), det(A), True),
        (det(2 * A - B.T), det(2 * A.T - B), True),
        (det(inverse(A)), inverse(det(A)), True),
        (det(inverse(A) @ B @ A), det(B), True),
        (det(A @ (B + Q)), det(A) * det(B + Q), True),
        (det(inverse(A + B)) * det(A + B), inverse(det(A)) * det(A), True),
        (det(A @ A), det(A) ** 2, True),
        (det(I), inverse(det(A)) * det(A), True),
        (det(A + B), det(A) + det(B), False),
        (det(-A), -det(A), False),
        (det(2 * A), 2 * det(A), False),
        (det(U @ V), det(V @ U), False),
        (det(A.T), -det(A), False),
        (det(A + B.T), det(A + B), False),
        (det(inverse(A)), det(A), False),
    ],
)
def test_determinants_of_products(left: Node, right: Node, holds: bool) -> None:
    claim = Claim("1", left, right)
    verdict = Session().decide(claim).verdict
    if holds:
        assert isinstance(verdict, Holds | HoldsUnder), verdict
        check(claim, "printed", verdict.certificate)
    else:
        assert isinstance(verdict, Fails), verdict
        check_counterexample(problem_of(claim), verdict.counterexample)


NOT_NEGATIVE: tuple[tuple[Relation, tuple[Hypothesis, ...]], ...] = (
    (x.T @ A.T @ A @ x >= 0, ()),
    (x.T @ U @ U.T @ x >= 0, ()),
    (dot(x, y) ** 2 <= dot(x, x) * dot(y, y), ()),
    (dot(x + y, x + y) <= 2 * dot(x, x) + 2 * dot(y, y), ()),
    (2 * dot(x, y) <= norm(x) ** 2 + norm(y) ** 2, ()),
    (norm(x) >= 0, ()),
    (tr(A.T @ A) >= 0, ()),
    (tr(A @ A) <= tr(A.T @ A), ()),
    (2 * tr(A.T @ B) <= tr(A.T @ A) + tr(B.T @ B), ()),
    (tr(A @ A) >= 0, (symmetric(A),)),
    (x.T @ A @ x >= 0, (definite(A),)),
    (x.T @ inverse(A) @ x >= 0, (definite(A),)),
    (x.T @ (A + B) @ x >= 0, (definite(A), definite(B))),
    (2 * x.T @ A @ y <= x.T @ A @ x + y.T @ A @ y, (definite(A),)),
    (tr(U @ D @ U.T) >= 0, (definite(D),)),
    (x.T @ U @ D @ U.T @ x >= 0, (definite(D),)),
    (x.T @ U @ inverse(U.T @ U) @ U.T @ x >= 0, ()),
    (x.T @ inverse(inverse(A) + U @ inverse(D) @ U.T) @ x >= 0, (definite(A), definite(D))),
    (x.T @ P @ x >= 0, (idempotent(P), symmetric(P))),
    (s * dot(x, x) >= 0, (positive(s),)),
    (s * dot(x, x) + t**2 >= 0, (positive(s),)),
    (x.T @ B @ x >= 0, (skew_symmetric(B),)),
)
NEGATIVE: tuple[tuple[Relation, tuple[Hypothesis, ...]], ...] = (
    (x.T @ A @ x >= 0, ()),
    (x.T @ A @ x >= 0, (symmetric(A),)),
    (x.T @ A @ x >= 0, (orthogonal(A),)),
    (x.T @ A @ x >= 0, (idempotent(A),)),
    (x.T @ A @ A @ x >= 0, ()),
    (x.T @ A @ B @ x >= 0, (definite(A), definite(B))),
    (dot(x, y) >= 0, ()),
    (dot(x, y) ** 2 >= dot(x, x) * dot(y, y), ()),
    (dot(x + y, x + y) <= dot(x, x) + dot(y, y), ()),
    (tr(A @ A) >= 0, ()),
    (tr(A) >= 0, (symmetric(A),)),
    (s * dot(x, x) >= 0, ()),
    (x.T @ (A - B) @ x >= 0, (definite(A), definite(B))),
    (2 * x.T @ A @ y >= x.T @ A @ x + y.T @ A @ y, (definite(A),)),
)


@pytest.mark.parametrize(("relation", "assuming"), NOT_NEGATIVE, ids=str)
def test_squares_are_not_negative(relation: Relation, assuming: tuple[Hypothesis, ...]) -> None:
    claim = Claim("1", *says_that(relation), assuming=assuming)
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    check(claim, "printed", verdict.certificate)
    without = Claim("1", *says_that(relation))
    if {"positive", "definite"} & {h.kind for h in assuming} and "^-1" not in str(relation):
        with pytest.raises(Rejected):
            check(without, "printed", verdict.certificate)


@pytest.mark.parametrize(("relation", "assuming"), NEGATIVE, ids=str)
def test_what_is_no_square_is_refuted(relation: Relation, assuming: tuple[Hypothesis, ...]) -> None:
    claim = Claim("1", *says_that(relation), assuming=assuming)
    verdict = Session().decide(claim).verdict
    if relation.left == x.T @ A @ B @ x and not isinstance(verdict, Fails):
        assert isinstance(verdict, Undecided)
        return
    assert isinstance(verdict, Fails), verdict
    check_counterexample(problem_of(claim), verdict.counterexample)


def test_no_forged_square_is_accepted() -> None:
    claim = Claim("1", *says_that(x.T @ A @ x + dot(y, y) >= 0), assuming=(definite(A),))
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, HoldsUnder)
    honest = dict(verdict.certificate)
    first, second = honest["squares"]["0"]
    for forged in ([first], [["-1", *first[1:]], second], [[first[0], ["A", "A"], first[2]], second], [], [second]):
        with pytest.raises(Rejected):
            check(claim, "printed", {**honest, "squares": {"0": forged}})
    product = Claim("2", *says_that(tr(A @ B @ Q) >= 0), assuming=(definite(A), definite(B), definite(Q)))
    assert not Session().decide(product).verdict.true
    nested = says_that(x.T @ inverse(A @ B @ Q) @ x >= 0)
    assert not Session().decide(Claim("3", *nested, assuming=product.assuming)).verdict.true


FORGED_SQUARES: tuple[tuple[Relation, tuple[Hypothesis, ...], list[Any]], ...] = (
    (-dot(x, x) >= 0, (), ["-1", [], [["1", [], ["x"]]]]),
    (x.T @ A @ x >= 0, (symmetric(A),), ["1", ["A"], [["1", [], ["x"]]]]),
    (x.T @ inverse(A) @ x >= 0, (), ["1", ["inverse(A)"], [["1", [], ["x"]]]]),
    (x.T @ inverse(A - B) @ x >= 0, (definite(A), definite(B)), ["1", ["inverse(A - B)"], [["1", [], ["x"]]]]),
    (
        x.T @ inverse(A + tr(A @ B @ Q) * I) @ x >= 0,
        (definite(A), definite(B), definite(Q)),
        ["1", ["inverse(A + tr(A B Q) 1)"], [["1", [], ["x"]]]],
    ),
    (s * dot(x, x) >= 0, (), ["1", ["s"], [["1", [], ["x"]]]]),
)


@pytest.mark.parametrize(("relation", "assuming", "forged"), FORGED_SQUARES, ids=str)
def test_no_square_of_what_may_be_negative(
    relation: Relation, assuming: tuple[Hypothesis, ...], forged: list[Any]
) -> None:
    claim = Claim("1", *says_that(relation), assuming=assuming)
    somewhere = next(points_at_sizes(problem_of(claim)))
    witness = {name: str(value) for name, value in somewhere.items()}
    with pytest.raises(Rejected, match="is not seen not to be negative"):
        check(claim, "printed", {"words": {}, "squares": {"0": [forged]}, "witness": witness})


@pytest.mark.parametrize(
    "term",
    [
        {"of": "inverse(D) from the right [1, 1]"},
        {"of": "inverse(A) from the right [1, 1]", "left": ["U^T"]},
        {"of": "inverse(A) from the right [1, 1]", "right": ["U"]},
        {"of": "inverse(A) from the right [1, 1]", "as": "scalar", "left": ["x^T"], "right": ["x"], "beside": ["U"]},
        {"of": "inverse(A) from the right [1, 1]", "as": "scalar", "left": ["x^T"], "right": ["A"]},
        {"of": "inverse(D) from the right [1, 1]", "as": "trace", "left": ["A"]},
        {"of": "inverse(A) from the right [1, 1]", "scalars": [["word", ["A"]]]},
        {"of": "inverse(A) from the right [1, 1]", "scalars": [["trace", ["U"]]]},
    ],
    ids=str,
)
def test_what_does_not_fit_is_no_proof(term: dict[str, Any]) -> None:
    """Not even where it is added and taken away again."""
    left = A @ inverse(A) @ (x @ x.T) @ U @ inverse(D) @ U.T
    problem = problem_of(Claim("1", left, left))
    honest = decided(problem)
    assert isinstance(honest, HoldsUnder)
    check(problem, "printed", honest.certificate)
    both = [{"times": "1", **term}, {"times": "-1", **term}]
    with pytest.raises(Rejected):
        check(problem, "printed", {**honest.certificate, "words": {"0:1,1": both}})


def test_a_counterexample_satisfies_what_is_assumed() -> None:
    skew = Counterexample({"n": Fraction(2), "A_12": Fraction(1)}, (1, 2), "1", "0")
    check_counterexample(problem_of(Claim("1", A, A.T)), skew)
    with pytest.raises(Rejected, match="does not satisfy A is symmetric"):
        check_counterexample(problem_of(Claim("1", A, A.T, assuming=(symmetric(A),))), skew)


def test_a_theorem_says_that_a_matrix_is_semidefinite() -> None:
    for of, holds in ((U @ U.T, True), (U @ D.T @ D @ U.T, True), (A @ A, False)):
        verdict = Session().decide(Theorem("1", "", (PositiveDefinite(of, semi=True),))).verdict
        assert verdict.true == holds


def test_what_has_no_words_is_not_used_and_holds_all_the_same() -> None:
    """Of a rotation the cofactors are no words of the free algebra; its other equations are."""
    T, turn = rectangular("T", "T", "columns in space", 3, n), square("C", "C", "a rotation")
    claim = Claim("1", (turn @ T).T @ (turn @ T), T.T @ T, assuming=(rotation(turn),))
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, HoldsUnder)
    assert verdict.needs == ("C is a rotation",)
    check(claim, "printed", verdict.certificate)
    false = Claim("2", turn @ T, turn.T @ T, assuming=(rotation(turn),))
    refuted = Session().decide(false).verdict
    assert isinstance(refuted, Fails)
    check_counterexample(problem_of(false), refuted.counterexample)


def test_primes_and_transposes_are_told_apart() -> None:
    prime = square("A'", "A'", "another matrix", size=n)
    assert isinstance(verdict_on(A.T @ prime, (prime.T @ A).T), Holds)
    assert isinstance(verdict_on(A.T @ prime, prime @ A), Fails)
    assert isinstance(verdict_on(inverse(prime) @ inverse(A.T), inverse(A.T @ prime)), HoldsUnder)


def test_nothing_is_said_of_nothing() -> None:
    """That a matrix which cannot have an inverse has one is never assumed."""
    verdict = verdict_on(inverse(A - A) @ B, B @ inverse(A - A))
    assert isinstance(verdict, Undecided)


DETERMINANTS = (
    (det(inverse(A) + B) * det(A), det(I + A @ B), ()),
    (det(I + U @ V), det(Identity(m) + V @ U), ()),
    (det(I + u @ v.T), 1 + v.T @ u, ()),
    (det(I - 2 * u @ u.T), number(-1), (unit(u),)),
    (det(A + u @ v.T), det(A) * (1 + v.T @ inverse(A) @ u), (invertible(A),)),
    (det(A + A @ u @ v.T), det(A) * (1 + v.T @ u), (invertible(A),)),
    (det(A + U @ D @ V), det(inverse(D) + V @ inverse(A) @ U) * det(D) * det(A), (invertible(A), invertible(D))),
    (det(matrix([A, U], [V, D])), det(A) * det(D - V @ inverse(A) @ U), (invertible(A),)),
    (det(matrix([A, U], [V, D])), det(D) * det(A - U @ inverse(D) @ V), (invertible(D),)),
    (det(matrix([A, U], [0, D])), det(A) * det(D), ()),
    (det(matrix([A, 0], [V, D])), det(D) * det(A), ()),
    (det(matrix([I, U], [V, Identity(m)])), det(Identity(m) - V @ U), ()),
)
SLIPPED = (
    (det(I + U @ V), det(Identity(m) - V @ U), ()),
    (det(A + u @ v.T), det(A) * (1 + u.T @ inverse(A) @ v), (invertible(A),)),
    (det(matrix([A, U], [V, D])), det(A) * det(D + V @ inverse(A) @ U), (invertible(A),)),
    (det(matrix([A, U], [V, D])), det(A) * det(D), ()),
    (det(A + B), det(A) + det(B), (invertible(A), invertible(B))),
)


@pytest.mark.parametrize(("left", "right", "assuming"), DETERMINANTS)
def test_determinants_of_sums_and_blocks(left: Node, right: Node, assuming: Any) -> None:
    claim = Claim("1", left, right, assuming=assuming)
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    check(claim, "printed", verdict.certificate)
    assert agree(problem_of(claim))


@pytest.mark.parametrize(("left", "right", "assuming"), SLIPPED)
def test_slips_in_determinants_are_refuted(left: Node, right: Node, assuming: Any) -> None:
    claim = Claim("1", left, right, assuming=assuming)
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, Fails), verdict
    check_counterexample(problem_of(claim), verdict.counterexample)


def test_a_letter_that_does_not_fit_is_repaired_at_any_size() -> None:
    gain, other = rectangular("K", "K", "a gain", n, m), rectangular("L", "L", "a gain", n, m)
    z, y = vector("z", "z", "a residual", size=m), vector("y", "y", "an error", size=n)
    wrong = Claim("1", (gain + other) @ z + y, gain @ z + printed(lambda: other @ y) + y, sic=True)
    assert isinstance(Session().decide(wrong).verdict, IllFormed)
    assert repair(wrong)[0].changes == ("z instead of y",)
