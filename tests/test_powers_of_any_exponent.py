"""Powers whose exponents are letters: by induction what is true is proved, and nothing else."""

from __future__ import annotations

import json
from copy import deepcopy
from typing import Any

import pytest

from chasles.checker.any_size.proof import first_and_next
from chasles.checker.certificate import check
from chasles.checker.sparse import Rejected
from chasles.decisions.session import Session
from chasles.statements import Claim, Condition, Definition, problem_of, symmetric
from chasles.statements.matrices import commuting, idempotent, invertible, orthogonal
from chasles.verdict import Undecided
from chasles.vocabulary import (
    LENGTH,
    Identity,
    Misfit,
    abbreviation,
    det,
    inverse,
    latex,
    matrix,
    plain,
    scalar,
    square,
    tr,
    vector,
)
from chasles.vocabulary.sizes import Size

from .decided import claim, proved, refuted

n, m, k, j = Size("n"), Size("m"), Size("k"), Size("j")
A, B, Q, E = (square(name, name, "", size=n) for name in "ABQE")
C, D = square("C", "C", "", size=m), square("D", "D", "")
x, c = vector("x", "x", "", size=n), scalar("c", "c", "")
eigen = Condition("0", A @ x, c * x, on=(x,))

similar = abbreviation("S", "S", (Q @ A @ inverse(Q)) ** k, "a short letter")

TRUE = [
    claim(A**k @ A, A ** (k + 1)),
    claim(D @ D**k, D ** (k + 1)),
    claim(A**k @ A**j, A ** (j + k)),
    claim((A**k) ** 2, A ** (k + k)),
    claim(similar, Q @ A**k @ inverse(Q), invertible(Q)),
    claim((A**k).T, A.T**k),
    claim((A @ B) ** k, A**k @ B**k, commuting(A, B)),
    claim(A**k @ B**j, B**j @ A**k, commuting(A, B)),
    claim((Q @ A @ inverse(Q)) ** k, Q @ A**k @ inverse(Q), invertible(Q)),
    claim((Q @ A @ Q.T) ** k, Q @ A**k @ Q.T, orthogonal(Q)),
    claim(A**k, A, idempotent(A)),
    claim(A**k, (A**k).T, symmetric(A)),
    claim(inverse(A**k), inverse(A) ** k, invertible(A)),
    claim(det(A**k), det(A) ** k),
    claim(A @ (B @ A) ** k, (A @ B) ** k @ A),
    claim((c * A) ** k, c**k * A**k),
    claim(A**k @ x, c**k * x, given=(eigen,)),
    claim(matrix((A, 0), (0, C)) ** k, matrix((A**k, 0), (0, C**k))),
    claim((x @ x.T) ** (k + 1), (x.T @ x) ** k * (x @ x.T)),
    claim((Identity(n) - A) @ A**k, A**k - A ** (k + 1)),
]
FALSE = [
    claim((A @ B) ** k, A**k @ B**k),
    claim((A + B) ** k, A**k + B**k),
    claim((-A) ** k, A**k),
    claim((2 * A) ** k, 2 * A**k),
    claim(A**k, A),
    claim(A**k, Identity(n), orthogonal(A)),
    claim(A ** (k + 1), A**k, invertible(A)),
    claim((Q @ A @ Q.T) ** k, Q @ A**k @ Q.T, invertible(Q)),
    claim(det(A**k), det(A)),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("said", TRUE, ids=lambda said: f"{said.left} = {said.right}")
def test_what_is_true_is_proved_and_checked(said: Claim) -> None:
    proved(said)


@pytest.mark.parametrize("said", FALSE, ids=lambda said: f"{said.left} = {said.right}")
def test_what_is_false_is_refuted_and_checked(said: Claim) -> None:
    refuted(said)


def test_what_is_assumed_of_an_exponent_is_not_assumed_of_the_next() -> None:
    fixed = Condition("0", A**k @ x, x, on=(x,))
    proved(claim(A**k @ x, x, given=(fixed,)))
    assert not Session().decide(claim(A ** (k + 1) @ x, x, given=(fixed,))).verdict.true
    named = Definition("0", B, A**k)
    assert not Session().decide(claim(A ** (k + 1), A, symmetric(B), given=(named,))).verdict.true


@pytest.mark.parametrize("said", [claim(B, A), claim(B @ A, A @ A), claim(E, A)], ids=str)
def test_what_a_definition_by_the_exponent_names_is_not_assumed_of_the_next(said: Claim) -> None:
    """B = A^k is A for k = 1; that it is so for k + 1 if it is for k does not follow, B being another matrix there."""
    named = (Definition("0", B, A**k), Definition("00", E, B))
    with pytest.raises(Rejected, match="something is assumed of k"):
        first_and_next(problem_of(claim(said.left, said.right, given=named)), "k")


def test_what_induction_does_not_show_at_once_is_undecided() -> None:
    said = claim(tr((Q @ A @ inverse(Q)) ** k), tr(A**k), invertible(Q))
    assert isinstance(Session().decide(said).verdict, Undecided)


def test_no_forged_induction_is_accepted() -> None:
    said = claim((A @ B) ** k, A**k @ B**k, commuting(A, B))
    certificate: Any = json.loads(json.dumps(proved(said).certificate))
    assert certificate["induction"]["over"] == "k"
    for change in (
        lambda steps: steps.update(over="n"),
        lambda steps: steps.update(over="i"),
        lambda steps: steps["next"]["words"].clear(),
        lambda steps: steps.update(next=steps["first"]),
    ):
        forged = deepcopy(certificate)
        change(forged["induction"])
        with pytest.raises(Rejected):
            check(said, "printed", forged)
    for other in (claim((A @ B) ** k, A**k @ B**k), claim((A @ B) ** k, B**k @ A**k @ A, commuting(A, B))):
        with pytest.raises(Rejected):
            check(other, "printed", certificate)


def test_they_are_printed_and_fit() -> None:
    assert (plain(A ** (k + 1)), latex(A ** (k + 1))) == ("A^(k + 1)", r"\mathbf{A}^{k + 1}")
    assert plain(A**k) == "A^k"
    with pytest.raises(Misfit, match="has a dimension"):
        square("F", "F", "", LENGTH) ** k
    with pytest.raises(TypeError, match="or a letter for one"):
        A**0.5
