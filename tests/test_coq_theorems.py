"""Theorems of every form, on other matter than the chapter's, in Coq: it accepts them, and none that says more."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from chasles import vocabulary as w
from chasles.coq import checking
from chasles.coq.checking import MISSING, coq_version, verdicts_of_coq
from chasles.coq.folder import chunks
from chasles.coq.theorems import claims_of
from chasles.decisions.session import Session
from chasles.statements import Claim, Definition, Theorem, definite, nonzero, positive, unit
from chasles.statements.forms import Definite, Exists, Form, Iff, Minimum, OnlyWhere, Unique
from chasles.statements.inequalities import inequality

A = w.square("A", "A", "a matrix")
x, b, u = (w.vector(name, name, "a vector") for name in "xbu")
y, z, k, m = (w.scalar(name, name, "a number") for name in "yzkm")
CROSS = w.norm(w.cross(u, x)) ** 2

THEOREMS: dict[str, tuple[Form, tuple[object, ...]]] = {
    "one solution of linear equations": (Unique(x, A @ x - b, w.inverse(A)), ()),
    "one solution of a linear equation": (Unique(y, k * y - z, 1 / k), (nonzero(k),)),
    "a square is least": (Minimum((y - z) ** 2 + k, k, over=y, at=z, squares=(y - z,)), ()),
    "a sum of squares": (
        Definite(y**2 + m * z**2, squares=(y**2, m * z**2), over=(y, z), by=w.Identity(2)),
        (positive(m),),
    ),
    "Cauchy's inequality": (Definite(w.dot(x, x) - w.dot(u, x) ** 2, squares=(CROSS,)), (unit(u),)),
    "a definite form over a number": (
        Definite(x.T @ A @ x / m, squares=(x.T @ A @ x / m,), over=(x,), by=w.Identity(3)),
        (positive(m), definite(A)),
    ),
    "components along and across": (
        Definite(CROSS + w.dot(u, x) ** 2, squares=(CROSS, w.dot(u, x) ** 2), over=(x,), by=w.row(-w.CPM(u), u)),
        (unit(u),),
    ),
    "no difference of a projection": (
        OnlyWhere(w.Identity(3), w.Identity(3) + k**2 * x @ x.T, by=x, squares=(k**2 * w.dot(x, x) ** 2,)),
        (),
    ),
    "parallel": (Iff(w.cross(u, x), x - w.dot(u, x) * u, forth=-w.CPM(u), back=w.CPM(u)), (unit(u),)),
    "a root": (Exists(y, z / k, k * y, z), (nonzero(k),)),
}

STRONGER = {"0 <= dot": "0 < dot", " -> (x = x_other)%M": " -> (x = b_)%M", " -> k ^ 2": " -> 1 + k ^ 2"}

COMPARED = {
    "a divisor": Claim("1", (m * x + k * u) / m, x + k / m * u, assuming=(inequality(m > 0),)),
    "not needed": Claim("2", w.cross(x, u), -w.cross(u, x), assuming=(inequality(k <= m),)),
    "moving": Claim(
        "3", w.rate(y * x) / (m - k), (w.rate(y) * x + y * w.rate(x)) / (m - k), assuming=(inequality(k < m),)
    ),
    "failing": Claim("4", w.dot(x, u), w.dot(u, x) + k, assuming=(inequality(w.dot(x, x) >= 1),), sic=True),
}


def theorem(name: str) -> Theorem:
    form, assuming = THEOREMS[name]
    return Theorem("1", says=name, forms=(form,), assuming=assuming)  # type: ignore[arg-type]


@pytest.mark.parametrize("name", THEOREMS)
def test_every_form_has_words_and_a_proof(name: str) -> None:
    claim, *_ = claims_of([Session().decide(theorem(name))])
    assert claim.whole
    assert claim.proof, claim.why_not


@pytest.mark.skipif(coq_version() is None, reason=MISSING)
@pytest.mark.slow
def test_coq_accepts_them_and_nothing_more(coq_cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What is said of definite forms is that they are not negative; that they are positive, Coq refuses."""
    monkeypatch.setenv("CHASLES_CACHE", str(coq_cache))
    claims, more = [], []
    for each in THEOREMS:
        claim, *_ = claims_of([Session().decide(theorem(each))])
        key = f"t_{len(claims)}"
        said, proof = (text.replace(claim.name, key) for text in (claim.said, claim.proof))
        claims.append(replace(claim, name=key, said=said, proof=proof))
        for weak, strong in STRONGER.items():
            if weak in said:
                name = f"{key}_more"
                changed = [text.replace(weak, strong).replace(key, name) for text in (said, proof)]
                more.append(replace(claims[-1], name=name, said=changed[0], proof=changed[1]))
    assert len(more) == 3
    accepted = {found.claim.name for found in verdicts_of_coq(chunks([*claims, *more])) if found.accepted}
    assert accepted == {claim.name for claim in claims}


@pytest.mark.parametrize("name", COMPARED)
def test_what_is_compared_is_assumed_as_a_comparison(name: str) -> None:
    claims = [*claims_of([Session().decide(COMPARED[name])])]
    assert all(claim.proof and "root_of" not in claim.said for claim in claims)
    assert any(sign in claims[0].said for sign in ("  0 < m ->", "0 < m t - k t", "  0 <= "))


@pytest.mark.skipif(coq_version() is None, reason=MISSING)
@pytest.mark.slow
def test_coq_accepts_what_is_said_under_comparisons(coq_cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CHASLES_CACHE", str(coq_cache))
    claims = []
    for claim in COMPARED.values():
        claims += [*claims_of([Session().decide(claim)])]
    assert all(found.accepted for found in verdicts_of_coq(chunks(claims)))


def test_a_file_that_takes_too_long_is_halved(monkeypatch: pytest.MonkeyPatch) -> None:
    """A theorem is refused for its own time, not for that of the others in its file."""

    def compiled(folder: Path, name: str, text: str) -> CompletedProcess[str]:
        count = text.count("Theorem ") if name.startswith("Proofs") else 0
        killed = count > 1 or (count == 1 and "eq_1_1_slow" in text)
        return CompletedProcess([], -24 if killed else 0, "Closed under the global context", "")

    monkeypatch.setattr(checking, "_compiled", compiled)
    monkeypatch.setattr(checking, "compile_theories", lambda *_: None)
    first, *_ = claims_of([Session().decide(theorem("a root"))])
    names = ("eq_1_1_a", "eq_1_1_b", "eq_1_1_slow", "eq_1_1_c", "eq_1_1_d")
    claims = [replace(first, name=name, proof=first.proof.replace(first.name, name)) for name in names]
    found = [*verdicts_of_coq(chunks(claims))]
    assert [each.claim.name for each in found if not each.accepted] == ["eq_1_1_slow"]
    assert len(found) == len(claims)


def test_what_a_proof_uses_and_no_premise_says_is_told() -> None:
    """That a column and its rate, both given, agree is known to the prover alone."""
    column = Definition("1", w.vector("s", "s", ""), w.column(y, z, k))
    moves = Definition("2", w.rate(column.left), w.rate(w.column(z, y, k)))
    claims = claims_of([Session().decide(Claim("3", w.rate(y), w.rate(z), given=(column, moves)))])
    assert "no premise says s_dot is the rate of s" in {claim.why_not for claim in claims}
