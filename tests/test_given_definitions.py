"""A definition that is given brings the definitions that it names: continuum mechanics, as notes print it."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from chasles.decisions.session import Session
from chasles.statements import Claim, Condition, Definition, problem_of, symmetric
from chasles.statements.matrices import invertible
from chasles.verdict import Holds
from chasles.vocabulary import (
    CPM,
    Identity,
    column,
    cos,
    cross,
    det,
    inverse,
    matrix,
    number,
    rate,
    scalar,
    sin,
    square,
    tr,
    vector,
)

from .decided import proved, refuted

UNITS = False
one, half = Identity(3), Fraction(1, 2)
F, S, s = square("F", "F", ""), square("sigma", r"\sigma", ""), square("s", "s", "")
C, B, E, e, L, D = (square(name, name, "") for name in ("C", "B", "E", "e", "L", "D"))
J, J_2, a, b = scalar("J", "J", ""), scalar("J_2", "J_2", ""), vector("a", "a", ""), vector("b", "b", "")
right = Definition("1", C, F.T @ F)
left = Definition("2", B, F @ F.T)
green = Definition("3", E, half * (C - one), given=(right,))
almansi = Definition("4", e, half * (one - inverse(B)), given=(left,), assuming=(invertible(B),))
volume = Definition("5", J, det(F))
gradient = Definition("6", L, rate(F) @ inverse(F), assuming=(invertible(F),))
stretching = Definition("7", D, half * (L + L.T), given=(gradient,))
deviator = Definition("8", s, S - Fraction(1, 3) * tr(S) * one)
second = Definition("9", J_2, half * tr(s @ s), given=(deviator,))


def claim(sides: tuple[Any, Any], *assuming: Any, given: tuple[Any, ...]) -> Claim:
    return Claim("10", *sides, assuming=assuming, given=given)


Q, phi, omega = square("Q", "Q", ""), scalar("phi", "phi", ""), vector("omega", r"\omega", "")
turn = Definition("11", Q, matrix((cos(phi), -sin(phi), 0), (sin(phi), cos(phi), 0), (0, 0, 1)))
as_claimed = Claim("12", Q, matrix((cos(phi), -sin(phi), 0), (sin(phi), cos(phi), 0), (0, 0, 1)), given=(turn,))
spin, spin_as_claimed = (Condition("13", rate(Q), CPM(omega) @ Q, on=(omega,), given=(g,)) for g in (turn, as_claimed))
TRUE = [
    claim((omega, column(0, 0, rate(phi))), given=(spin,)),
    claim((omega, column(0, 0, rate(phi))), given=(spin_as_claimed,)),
    claim((e, inverse(F).T @ E @ inverse(F)), invertible(F), given=(green, almansi)),
    claim((E, F.T @ e @ F), invertible(F), given=(green, almansi)),
    claim((rate(E), F.T @ D @ F), given=(green, stretching)),
    claim((rate(J), J * tr(D)), given=(volume, stretching)),
    claim((cross(F @ a, F @ b), J * inverse(F).T @ cross(a, b)), invertible(F), given=(volume,)),
    claim((J_2, half * tr(S @ S) - Fraction(1, 6) * tr(S) ** 2), symmetric(S), given=(second,)),
]
FALSE = [
    claim((omega, column(0, 0, -rate(phi))), given=(spin_as_claimed,)),
    claim((e, inverse(F) @ E @ inverse(F).T), invertible(F), given=(green, almansi)),
    claim((rate(E), F @ D @ F.T), given=(green, stretching)),
    claim((J_2, half * tr(S @ S)), symmetric(S), given=(second,)),
]


@pytest.mark.parametrize("said", TRUE, ids=lambda said: f"{said.left} = {said.right}")
def test_true_ones_are_proved(said: Claim) -> None:
    proved(said)


@pytest.mark.parametrize("said", FALSE, ids=lambda said: f"{said.left} = {said.right}")
def test_false_ones_are_refuted(said: Claim) -> None:
    refuted(said)


def test_what_is_given_itself_comes_first() -> None:
    """Of C the claim is given something else: what the definition of E names of it is left out."""
    other = Definition("11", C, 2 * one)
    said = claim((E, half * one), given=(green, other))
    assert isinstance(Session().decide(said).verdict, Holds)
    assert [left for left, _ in problem_of(said).rules] == [E, C]


def test_a_claim_that_is_given_stands_for_what_it_says() -> None:
    """A proved claim is used as it stands: what it rests on is no part of what rests on it."""
    proved = Claim("12", E, half * (F.T @ F - one), given=(green,))
    rests = Claim("13", tr(E), half * (tr(F.T @ F) - number(3)), given=(proved,))
    assert Session().decide(proved).verdict.true
    assert [left for left, _ in problem_of(rests).rules] == [E]
