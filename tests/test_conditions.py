"""Conditions that no linear system solves: more unknowns than equations, products of unknowns, derivatives taken."""

from __future__ import annotations

import pytest

from chasles.decisions.session import Session
from chasles.statements import Claim, Condition, Definition, nonzero, rotation, unit
from chasles.statements.matrices import invertible
from chasles.verdict import Posed, Undecided
from chasles.vocabulary import CPM, inverse, rate, scalar, square, vector
from chasles.vocabulary.expansions import up_to
from chasles.vocabulary.nodes import lifted
from chasles.vocabulary.partial import partial
from chasles.vocabulary.sizes import Size, rectangular

from .decided import claim, proved, refuted

UNITS = False
V, i, R, w, K = (scalar(name, name, "") for name in "ViRwK")
x, y = scalar("x", "x", ""), scalar("y", "y", "")
a, b, c, r = (scalar(name, name, "", constant=True) for name in "abcr")
n, k = Size("n"), Size("k")
M, J, P, Q = square("M", "M", "", size=n), rectangular("J", "J", "", k, n), *(square(s, s, "", size=n) for s in "PQ")
A = square("A", "A", "", size=n, constant=True)
v, h, t, f = (vector(name, name, "", size=k if name == "f" else n) for name in "vhtf")

motor = Condition("0", V, i * R + w / K, on=(V, i, R, w, K), assuming=(nonzero(K),))
circle = Condition("0", x**2 + y**2, lifted(r**2), on=(x, y))
roots = Condition("0", a * x**2 + b * x + c, lifted(0), on=(x,))
motion = Condition("0", M @ rate(v) + h, t + J.T @ f, on=(v, h, t, f))
lyapunov = Condition("0", A.T @ Q + Q @ A, -P, on=(P,))
decay = Definition("0", V, v.T @ Q @ v), Definition("0", rate(v), A @ v), Definition("0", rate(Q), 0 * Q)
line = Condition("0", y - a * x, lifted(b), on=(y,))
area = Condition("0", V * w - K * i, R, on=(w,))
turn, s, s_ = square("turn", "R", ""), vector("s", "s", ""), vector("s_", "s'", "")
spin = Condition("0", CPM(s_), rate(turn) @ turn.T, on=(turn,), assuming=(rotation(turn),))
spin_in_body = Condition("0", CPM(s), turn.T @ rate(turn), on=(s,), assuming=(rotation(turn),))
axis = Condition("0", s.x, lifted(1), assuming=(unit(s),))

EMPTY = (Definition("0", y, w), Condition("1", y, w, on=(x,)))
"""A condition that says nothing of what it is posed on."""
TRUE = [
    claim(V * K, i * R * K + w, given=(motor,)),
    claim(K, w / (V - i * R), nonzero(V - i * R), given=(motor,)),
    claim(x * rate(x) + y * rate(y), 0, given=(circle,)),
    claim(x * rate(rate(x)) + y * rate(rate(y)), -(rate(x) ** 2) - rate(y) ** 2, given=(circle,)),
    claim((2 * a * x + b) ** 2, b**2 - 4 * a * c, given=(roots,)),
    claim(rate(v), inverse(M) @ (t + J.T @ f - h), invertible(M), given=(motion,)),
    claim(t, M @ rate(v) + h - J.T @ f, given=(motion,)),
    claim(rate(V), -(v.T @ P @ v), given=(*decay, lyapunov)),
    claim(partial(y, x), a, given=(line,)),
    claim(abs(x), 2, given=(Condition("0", x**2, lifted(4), on=(x,)),)),
    claim(V * w, R + K * i, given=(area,)),
    claim(w, (R + K * i) / V, nonzero(V), given=(area,)),
    claim(a * b, a**2, given=(Condition("0", a, b),)),
    claim(s.x, 1, given=(axis,)),
    claim(s, turn.T @ s_, rotation(turn), given=(spin, spin_in_body)),
    claim(rate(turn), turn @ CPM(s), rotation(turn), given=(spin_in_body,)),
    claim(x * V, x * i + x * w, given=(Condition("0", x, 2 * V, given=(Definition("0", V, i + w),), on=(x,)),)),
    claim(x * y, x * w, given=EMPTY),
]
FALSE = [
    claim(V * K, i * R * K - w, given=(motor,)),
    claim(x * rate(x), y * rate(y), given=(circle,)),
    claim(x, y, given=(circle,)),
    claim(2 * a * x, -b, given=(roots,)),
    claim(t, M @ rate(v) + h + J.T @ f, given=(motion,)),
    claim(rate(V), v.T @ P @ v, given=(*decay, lyapunov)),
    claim(V * w, R - K * i, given=(area,)),
    claim(a * b, 2 * a**2, given=(Condition("0", a, b),)),
    claim(s.y, 1, given=(axis,)),
    claim(x, i + w, given=(Condition("0", x, 2 * V, given=(Definition("0", V, i + w),), on=(x,)),)),
    claim(x, w, given=EMPTY),
]


@pytest.mark.parametrize("said", TRUE, ids=str)
def test_what_is_true_is_proved_and_checked(said: Claim) -> None:
    verdict = proved(said)
    assert not any("(0)" in need for need in getattr(verdict, "needs", ()))


@pytest.mark.parametrize("said", FALSE, ids=str)
def test_what_is_false_is_refuted_and_checked(said: Claim) -> None:
    refuted(said)


@pytest.mark.parametrize("posed", [motor, circle, roots, motion], ids=str)
def test_they_are_posed_with_a_point(posed: Condition) -> None:
    assert isinstance(Session().decide(posed).verdict, Posed)


@pytest.mark.parametrize(
    "said",
    [
        claim(partial(y, x), a, given=(Condition("0", y**2, lifted(x), on=(y,)),)),
        claim(partial(y, c), 0, given=(Condition("0", x + y, lifted(c), on=(x, y)),)),
        claim(partial(y, c), 1, given=(Condition("0", x + y, lifted(c), on=(y, x)),)),
    ],
    ids=str,
)
def test_what_does_not_say_what_depends_on_what_is_not_differentiated(said: Claim) -> None:
    assert isinstance(Session().decide(said).verdict, Undecided)


def test_an_expansion_in_what_a_condition_binds_is_not_refuted() -> None:
    root = Condition("0", y**2, 1 + x, on=(y,))
    for said in (claim(y**2, up_to(1 + x, x, 2), given=(root,)), claim(y, up_to(1 + x, x, 2), given=(root,))):
        assert isinstance(Session().decide(said).verdict, Undecided)


def test_what_is_assumed_of_an_unknown_is_known_of_it() -> None:
    """The homography of a plane divides by its distance, which the condition determines and an earlier statement says
    is not zero: the claim was called ill-formed."""
    q, p_, normal = (vector(name, name, "") for name in ("q", "p", "normal"))
    homography = Definition("1", q, p_ - s * (normal.T @ p_) / r, assuming=(nonzero(r),))
    plane = Condition("2", normal.T @ p_ + r, lifted(0), on=(r,))
    assert proved(Claim("3", q, p_ + s, given=(homography, plane))).needs == ("r != 0",)
