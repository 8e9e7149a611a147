"""Sentences made to mislead: true only under a condition that is not said, or resting on what contradicts itself.

Of a trap only this matters: what is true is not refuted, what is false not proved, and what cannot be is not decided.
"""

from __future__ import annotations

import pytest

from chasles.decisions.session import Session
from chasles.statements import (
    Claim,
    Condition,
    Definition,
    Exists,
    Minimum,
    Statement,
    Theorem,
    nonzero,
    orthonormal,
    perpendicular,
    positive,
    rotation,
    symmetric,
    unit,
)
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder, Undecided
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    PI,
    Identity,
    Node,
    Symbol,
    Zero,
    abbreviation,
    at,
    cos,
    cross,
    det,
    dot,
    norm,
    number,
    rate,
    scalar,
    sin,
    square,
    vect,
    vector,
)

a, b, e, f, u, x, y = (vector(name, name, "a vector") for name in "abefuxy")
turn = vector("w", "w", "a rate", FREQUENCY)
fixed = vector("k", "k", "a vector", constant=True)
p, q, m, phi, psi = (scalar(name, name, "a scalar") for name in ("p", "q", "m", "phi", "psi"))
Q, M = (square(name, name, "a matrix") for name in "QM")
e_1, e_2, e_3 = (vector(f"e_{k}", f"e_{k}", "a vector") for k in (1, 2, 3))
one, zero = Identity(3), Zero(3, 1)
half = abbreviation("h", "h", phi / 2, "half the angle")
slash = scalar("t/h", "t", "an angle")
triad = orthonormal(e_1, e_2, e_3)


def claim(left: Node, right: Node, *given: Statement, **more: object) -> Claim:
    return Claim("1", left, right, given=given, **more)  # type: ignore[arg-type]


def let(left: Node, right: Node) -> Definition:
    return Definition("2", left, right)


def where(left: Node, right: Node, symbol: Symbol) -> Condition:
    return Condition("3", left, right, on=(symbol,))


TRUE = {
    "a norm and the scalar product": claim(norm(a) ** 2, dot(a, a)),
    "a norm has the sign of nothing": claim(norm(-a), norm(a)),
    "the square of the norm of a multiple": claim(norm(p * a) ** 2, p**2 * dot(a, a)),
    "the rate of a norm": claim(rate(norm(a)), dot(a, rate(a)) / norm(a), assuming=(nonzero(norm(a)),)),
    "the rate of a square of a norm": claim(rate(norm(a) ** 2), 2 * dot(a, rate(a))),
    "division by a squared norm": claim(dot(a, a) / norm(a) ** 2, number(1), assuming=(nonzero(norm(a) ** 2),)),
    "the rate of a quotient": claim(rate(p / q), (rate(p) * q - p * rate(q)) / q**2, assuming=(nonzero(q),)),
    "three times an angle": claim(sin(3 * phi), 3 * sin(phi) - 4 * sin(phi) ** 3),
    "an angle less itself": claim(cos(phi - phi), number(1)),
    "an angle that is twice another": claim(cos(phi), 1 - 2 * sin(psi) ** 2, let(phi, 2 * psi)),
    "an angle by another name": claim(cos(half), cos(phi / 2)),
    "an angle by another name, doubled": claim(1 - 2 * sin(half) ** 2, cos(phi)),
    "an angle printed with its argument": claim(cos(at(phi)), cos(phi)),
    "a name with a slash": claim(cos(slash) ** 2 + sin(slash) ** 2, number(1)),
    "something constant": claim(rate(2 * fixed), zero),
    "a determinant": claim(det(Q), number(1), assuming=(rotation(Q),)),
    "a rotation's axis": claim((Q - Q.T) @ vect(Q), zero, assuming=(rotation(Q),)),
    "a second rate of a unit vector": claim(dot(rate(rate(e)), e), -dot(rate(e), rate(e)), assuming=(unit(e),)),
    "unit vectors at right angles": claim(
        norm(cross(e, f)) ** 2, number(1), assuming=(unit(e), unit(f), perpendicular(e, f))
    ),
    "rates of perpendicular vectors": claim(dot(rate(a), b), -dot(a, rate(b)), assuming=(perpendicular(a, b),)),
    "one vector of a triad": claim(dot(e_1, e_1), number(1), assuming=(triad,)),
    "two vectors of a triad": claim(dot(e_1, e_2), number(0), assuming=(triad,)),
    "the rate of one vector of a triad": claim(dot(rate(e_1), e_1), number(0) * dot(rate(e_1), e_1), assuming=(triad,)),
    "rates of a triad": claim(rate(e_3), cross(rate(e_1), e_2) + cross(e_1, rate(e_2)), assuming=(triad,)),
    "a unit vector whose rate is given": claim(
        dot(e, turn), number(0), Definition("2", rate(e), turn), assuming=(unit(e),)
    ),
    "a perpendicular whose rate is given": claim(
        dot(a, rate(b)), -dot(turn, b), Definition("2", rate(a), turn), assuming=(perpendicular(a, b),)
    ),
    "what a condition determines": claim(norm(u), norm(a), where(u, a, u)),
    "conditions that demand more of the rest": claim(a, b, where(u, a, u), where(u, b, u)),
    "a defined unit vector": claim(dot(a, a), number(1), let(e, a), assuming=(unit(e),)),
    "a defined rotation": claim(M.T @ M, one, let(Q, M), assuming=(rotation(Q),)),
    "a defined symmetric matrix": claim(M.T, M, let(Q, M), assuming=(symmetric(Q),)),
    "a determined unit vector": claim(dot(a, a), number(1), where(e, a, e), assuming=(unit(e),)),
    "a positive number and its size": claim(norm(m), m, assuming=(positive(m),)),
    "a positive number that is defined": claim(norm(p), p, let(m, p), assuming=(positive(m),)),
    "a positive sum that is defined": claim(norm(p + q), p + q, let(m, p + q), assuming=(positive(m),)),
    "the size of a multiple": claim(norm(2 * a), 2 * norm(a)),
    "the size of a product": claim(norm(p * a), norm(p) * norm(a)),
    "the size of a unit vector": claim(norm(e), number(1), assuming=(unit(e),)),
    "the size of a multiple of a unit vector": claim(norm(p * e), norm(p), assuming=(unit(e),)),
    "a bare angle and its size": claim(norm(phi * e) ** 2 * cos(phi), phi**2 * cos(phi), assuming=(unit(e),)),
    "the cosine of pi": claim(cos(PI), number(-1)),
    "a turn by pi more": claim(cos(phi + PI), -cos(phi)),
    "an angle that a condition determines": claim(cos(phi), cos(2 * psi), where(phi, 2 * psi, phi)),
}

FALSE = {
    "the size of a number and the number": claim(norm(p), p),
    "the size of a multiple and the multiple": claim(norm(p * e), p, assuming=(unit(e),)),
    "the size of a sum": claim(norm(a + b), norm(a) + norm(b)),
    "twice an angle": claim(sin(2 * phi), 2 * sin(phi)),
    "a bare angle": claim(phi * cos(phi), phi),
    "the size of a bare angle": claim(norm(phi * e) * cos(phi), phi * cos(phi), assuming=(unit(e),)),
    "a triple product without its condition": claim(cross(a, cross(a, b)), -dot(a, a) * b),
    "an axial vector and its opposite": claim(vect(M), vect(M.T)),
    "a third rate of a unit vector": claim(dot(rate(rate(rate(e))), e), number(0), assuming=(unit(e),)),
    "rates of perpendicular vectors": claim(dot(rate(a), b), dot(a, rate(b)), assuming=(perpendicular(a, b),)),
    "unit vectors at right angles": claim(
        norm(cross(e, f)) ** 2, number(2), assuming=(unit(e), unit(f), perpendicular(e, f))
    ),
    "half of a determined unit vector": claim(a, 2 * e, where(e, a, e), assuming=(unit(e),)),
    "the cosine of a third of pi": claim(cos(PI / 3), number(1)),
    "a norm that is a sum of others": claim(norm(a) ** 2 + norm(b) ** 2, norm(a + b) ** 2),
    "a skew matrix and its square": claim(CPM(a) @ CPM(a), CPM(dot(a, a) * a)),
    "another instant": claim(at(a, "0"), at(a, "t")),
    "a least value that varies": Theorem(
        "1", "", (Minimum(norm(x) ** 2, norm(x) ** 2 - norm(x - a) ** 2, over=x, at=a, squares=(x - a,)),)
    ),
    "a least value where nothing varies": Theorem(
        "1", "", (Minimum(norm(x) ** 2, norm(a) ** 2, over=x, at=a, squares=(x - a,)),), given=(let(x, a),)
    ),
    "a least value outside": Theorem(
        "1", "", (Minimum(norm(x - a) ** 2, number(0), over=x, at=a, squares=(x - a,)),), assuming=(unit(x),)
    ),
    "a witness outside": Theorem("1", "", (Exists(e, zero, cross(e, a), zero),), assuming=(unit(e),)),
    "a step from a false claim": claim(a - b, zero, Claim("2", a, b)),
    "a condition that is not linear": claim(p, number(1), where(p**2, number(1), p)),
    "a condition that determines nothing": claim(p, sin(phi), where(p * cos(phi), sin(phi) * cos(phi), p)),
}

IMPOSSIBLE = {
    "conditions that contradict each other": claim(
        2 * u, 2 * a + e, where(u, a, u), where(u, a + e, u), assuming=(unit(e),)
    ),
    "a divisor that is zero": claim(
        p / (dot(e, e) - 1), p / (dot(e, e) - 1) * dot(e, e), assuming=(unit(e), nonzero(dot(e, e) - 1))
    ),
    "a divisor that is zero by its spelling": claim(
        p / (dot(a, b) - dot(b, a)), p / (dot(a, b) - dot(b, a)), assuming=(nonzero(dot(a, b) - dot(b, a)),)
    ),
    "two definitions": claim(a, b, let(u, a), let(u, b)),
    "a definition and a condition": claim(a, b, let(u, a), where(u, b, u)),
    "a constant that varies": claim(rate(a), rate(b), let(fixed, a)),
    "a definition by itself": claim(a, b, let(a, a + b)),
    "definitions in a circle": claim(a, b, let(a, b), let(b, a)),
}


def named(traps: dict[str, Claim | Theorem]) -> list[object]:
    return [pytest.param(trap, id=name) for name, trap in traps.items()]


@pytest.mark.sampled(4)
@pytest.mark.parametrize("sentence", named(TRUE))
def test_what_is_true_is_not_refuted(sentence: Claim | Theorem) -> None:
    assert isinstance(Session().decide(sentence).verdict, Holds | HoldsUnder | Undecided)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("sentence", named(FALSE))
def test_what_is_false_is_not_proved(sentence: Claim | Theorem) -> None:
    assert isinstance(Session().decide(sentence).verdict, Fails | Undecided)


@pytest.mark.parametrize("sentence", named(IMPOSSIBLE))
def test_what_cannot_be_is_not_decided(sentence: Claim | Theorem) -> None:
    verdict = Session().decide(sentence).verdict
    assert isinstance(verdict, Undecided | Contradictory), verdict
    assert verdict.reason


def test_most_traps_are_seen_through() -> None:
    """Doubt is allowed, but not as a way out."""
    judge = Session()
    doubted = [name for name, trap in (TRUE | FALSE).items() if isinstance(judge.decide(trap).verdict, Undecided)]
    assert len(doubted) <= (len(TRUE) + len(FALSE)) / 3, doubted
