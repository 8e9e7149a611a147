"""What is assumed holds at all times: so do its rates, also where a definition names them, and nothing less refutes."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import pytest

from chasles.checker.certificate import Rejected, check
from chasles.checker.refutation import check_counterexample
from chasles.prover.decide import decide_problem
from chasles.statements import (
    Claim,
    Condition,
    Definition,
    Hypothesis,
    Problem,
    Statement,
    definite,
    half_turn,
    nonzero,
    orthonormal,
    perpendicular,
    problem_of,
    rotation,
    symmetric,
    unit,
    unit_column,
)
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder, Undecided
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    Node,
    at,
    column,
    cos,
    cross,
    det,
    dot,
    norm,
    paren,
    rate,
    scalar,
    sin,
    square,
    tr,
    vector,
)

from .sampling import WHOLE, sample

a, b, c, e, f, g, k = (vector(name, name, "") for name in "abcefgk")
u, v, w = (vector(name, name, "", FREQUENCY) for name in "uvw")
r, s = (vector(name, name, "", FREQUENCY**2) for name in "rs")
t = vector("t", "t", "", FREQUENCY**3)
Q, M = (square(name, name, "") for name in "QM")
K = square("K", "K", "", FREQUENCY)
L = square("L", "L", "", FREQUENCY**2)
spin = vector("omega", "omega", "", FREQUENCY)
p, q = scalar("p", "p", ""), scalar("q", "q", "")
constant = vector("h", "h", "", constant=True)
WITNESS = ("a_1", "a_2", "a_3", "b_1", "b_2", "b_3", "p", "h_1", "h_2", "h_3")
n = scalar("n", "n", "", FREQUENCY, constant=True)
triad = orthonormal(e, f, g)


def let(left: Node, right: Node) -> Definition:
    return Definition(f"d {left}", left, right)


Case = tuple[Node, Node, tuple[Statement, ...], tuple[Hypothesis, ...]]
TRUE: dict[str, Case] = {}


def true(name: str, left: Node, right: Node, *given: Statement, assuming: tuple[Hypothesis, ...]) -> None:
    TRUE[name] = (left, right, given, assuming)


WE, FU, GV = let(rate(e), w), let(rate(f), u), let(rate(g), v)
WR, RT = let(rate(w), r), let(rate(r), t)
UNIT = (unit(e),)
true("unit, first", dot(e, w), 0 * dot(e, w), WE, assuming=UNIT)
true("unit, second", dot(e, rate(w)), -dot(w, w), WE, assuming=UNIT)
true("unit, second by its own name", dot(e, rate(rate(e))), -dot(w, w), WE, assuming=UNIT)
true("unit, third", dot(e, rate(rate(w))), -3 * dot(w, rate(w)), WE, assuming=UNIT)
true("unit, fourth", dot(e, rate(rate(rate(w)))), -3 * dot(rate(w), rate(w)) - 4 * dot(w, rate(rate(w))), WE,
     assuming=UNIT)  # fmt: skip
true("unit, chain of two", dot(e, r), -dot(w, w), WE, WR, assuming=UNIT)
true("unit, rate of a chain", dot(e, rate(r)), -3 * dot(w, r), WE, WR, assuming=UNIT)
true("unit, chain of three", dot(e, t), -3 * dot(w, r), WE, WR, RT, assuming=UNIT)
true("unit, rate of a chain of three", dot(e, rate(t)), -3 * dot(r, r) - 4 * dot(w, t), WE, WR, RT, assuming=UNIT)
true("unit, second rate named", dot(e, r), -dot(rate(e), rate(e)), let(rate(rate(e)), r), assuming=UNIT)
true("unit, both rates named", dot(e, r), -dot(w, w), WE, let(rate(rate(e)), r), assuming=UNIT)
true("unit, both rates named, third", dot(e, rate(r)), -3 * dot(w, r), WE, let(rate(rate(e)), r), assuming=UNIT)
true("unit, a multiple named", dot(e, rate(w)), -2 * dot(w, w), let(rate(e), 2 * w), assuming=UNIT)
true("unit, a sum named", dot(e, rate(w) + rate(u)), -dot(w + u, w + u), let(rate(e), w + u), assuming=UNIT)
true("unit, a turn", dot(e, rate(rate(e))), -dot(cross(spin, e), cross(spin, e)), let(rate(e), cross(spin, e)),
     assuming=UNIT)  # fmt: skip
true("unit, of two one", dot(e, rate(w)), -dot(w, w), WE, FU, assuming=(unit(e), unit(f)))
true("unit, of two both", dot(e, rate(w)) + dot(f, rate(u)), -dot(w, w) - dot(u, u), WE, FU,
     assuming=(unit(e), unit(f)))  # fmt: skip
true("unit column", p * rate(p) + q * rate(q), 0 * rate(p), assuming=(unit_column(p, q),))
true("rotation, first", Q.T @ K, -(K.T @ Q), let(rate(Q), K), assuming=(rotation(Q),))
true("rotation, second", Q.T @ rate(K) + rate(K).T @ Q, -2 * (K.T @ K), let(rate(Q), K), assuming=(rotation(Q),))
true("rotation, other side", Q @ rate(K).T + rate(K) @ Q.T, -2 * (K @ K.T), let(rate(Q), K), assuming=(rotation(Q),))
true("rotation, chain", Q.T @ L + L.T @ Q, -2 * (K.T @ K), let(rate(Q), K), let(rate(K), L), assuming=(rotation(Q),))
true("rotation, second rate named", Q.T @ L + L.T @ Q, -2 * (rate(Q).T @ rate(Q)), let(rate(rate(Q)), L),
     assuming=(rotation(Q),))  # fmt: skip
true("rotation, trace", tr(Q.T @ K), 0 * tr(Q.T @ K), let(rate(Q), K), assuming=(rotation(Q),))
true("symmetric, first", K, K.T, let(rate(M), K), assuming=(symmetric(M),))
true("symmetric, second", rate(K), rate(K).T, let(rate(M), K), assuming=(symmetric(M),))
true("symmetric, third", rate(rate(K)), rate(rate(K)).T, let(rate(M), K), assuming=(symmetric(M),))
true("symmetric, chain", L, L.T, let(rate(M), K), let(rate(K), L), assuming=(symmetric(M),))
true("symmetric, rate of a chain", rate(L), rate(L).T, let(rate(M), K), let(rate(K), L), assuming=(symmetric(M),))
true("definite, second", rate(K), rate(K).T, let(rate(M), K), assuming=(definite(M),))
PERPENDICULAR = (perpendicular(a, b),)
AW, BU = let(rate(a), w), let(rate(b), u)
true("perpendicular, first", dot(w, b), -dot(a, u), AW, BU, assuming=PERPENDICULAR)
true("perpendicular, second", dot(rate(w), b) + dot(a, rate(u)), -2 * dot(w, u), AW, BU, assuming=PERPENDICULAR)
true("perpendicular, one named", dot(rate(w), b) + dot(a, rate(rate(b))), -2 * dot(w, rate(b)), AW,
     assuming=PERPENDICULAR)  # fmt: skip
true("perpendicular, chain", dot(r, b) + dot(a, rate(u)), -2 * dot(w, u), AW, BU, WR, assuming=PERPENDICULAR)
true("perpendicular, both chains", dot(r, b) + dot(a, s), -2 * dot(w, u), AW, BU, WR, let(rate(u), s),
     assuming=PERPENDICULAR)  # fmt: skip
true("perpendicular and unit", dot(rate(w), b) + dot(a, rate(u)), -2 * dot(w, u), AW, BU,
     assuming=(perpendicular(a, b), unit(a), unit(b)))  # fmt: skip
for (one, one_rate), (other, other_rate) in product(((e, w), (f, u), (g, v)), repeat=2):
    true(f"triad, {one} {other}", dot(one, rate(other_rate)) + dot(rate(one_rate), other),
         -2 * dot(one_rate, other_rate), WE, FU, GV, assuming=(triad,))  # fmt: skip
    true(f"triad, {one} {other}, first", dot(one, other_rate), -dot(one_rate, other), WE, FU, GV, assuming=(triad,))


def problem(name: str, times: int = 1) -> Problem:
    left, right, given, assuming = TRUE[name]
    return problem_of(Claim("1", times * left, right, given=given, assuming=assuming))


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", TRUE)
def test_what_follows_from_the_rates_of_what_is_assumed_holds(name: str) -> None:
    asked = problem(name)
    verdict = decide_problem(asked)
    assert isinstance(verdict, Holds | HoldsUnder), verdict
    check(asked, "", verdict.certificate)


NOTHING = ("unit, first", "unit column", "rotation, trace", *(f"triad, {one} {one}, first" for one in "efg"))
"""Both sides of these are zero, and so is twice the left."""


UNFOUND = ("perpendicular and unit",)
"""No point at which it fails is found."""


@pytest.mark.sampled(11)
@pytest.mark.parametrize("name", [name for name in TRUE if name not in NOTHING + UNFOUND])
def test_twice_as_much_fails_at_a_point_through_which_there_is_a_motion(name: str) -> None:
    asked = problem(name, 2)
    verdict = decide_problem(asked)
    assert isinstance(verdict, Fails), verdict
    check_counterexample(asked, verdict.counterexample)


def shown(left: str, right: str, **vectors: tuple[int, ...]) -> Counterexample:
    at = {f"{name}_{k + 1}": Fraction(x) for name, entries in vectors.items() for k, x in enumerate(entries)}
    return Counterexample(at, (1, 1), left, right)


X, Y, Z, NO = (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, 0)
FORGED = {
    "unit, second": shown("0", "-1", e=X, w=Y, w_dot=NO),
    "unit, second by its own name": shown("5", "-1", e=X, w=Y, w_dot=(5, 0, 0)),
    "unit, third": shown("1", "0", e=X, w=NO, w_dot=NO, w_ddot=X),
    "unit, chain of two": shown("1", "0", e=X, w=NO, r=X),
    "unit, rate of a chain": shown("2", "0", e=X, w=NO, r=NO, r_dot=(2, 0, 0)),
    "unit, chain of three": shown("1", "0", e=X, w=NO, r=NO, t=X),
    "unit, both rates named, third": shown("1", "0", e=X, v=NO, w=NO, r=NO, r_dot=X),
    "perpendicular, first": shown("1", "0", a=X, b=Y, w=Y, u=NO),
    "perpendicular, second": shown("1", "0", a=X, b=Y, w=NO, u=NO, w_dot=Y, u_dot=NO),
    "perpendicular, both chains": shown("1", "0", a=X, b=Y, w=NO, u=NO, r=Y, s=NO),
    "triad, e e": shown("1", "-2", e=X, f=Y, g=Z, w=NO, u=NO, v=NO, w_dot=X, u_dot=NO, v_dot=NO),
    "triad, e f": shown("1", "0", e=X, f=Y, g=Z, w=NO, u=NO, v=NO, w_dot=NO, u_dot=X, v_dot=NO),
}


@pytest.mark.parametrize("name", FORGED)
def test_a_point_at_which_a_rate_of_what_is_assumed_does_not_hold_refutes_nothing(name: str) -> None:
    with pytest.raises(Rejected, match="does not satisfy"):
        check_counterexample(problem(name), FORGED[name])


def test_a_point_through_which_nothing_is_known_to_move_refutes_nothing() -> None:
    """At a = b = 0 the rates of two perpendicular vectors are tied by more than a linear equation."""
    asked = problem_of(Claim("1", rate(a), 2 * rate(a), assuming=PERPENDICULAR))
    check_counterexample(asked, shown("1", "2", a=Y, b=X, a_dot=X, b_dot=(0, -1, 0)))
    with pytest.raises(Rejected, match="not known whether a motion"):
        check_counterexample(asked, shown("1", "2", a=NO, b=NO, a_dot=X, b_dot=NO))


def test_what_rests_beside_what_moves_stays_as_it_is() -> None:
    """A rate that is a quotient, and the rates of a half-turn, of which more equations are said than it takes."""
    given = let(rate(e), p * w / q)
    assuming = (unit(e), nonzero(q), half_turn(Q))
    asked = problem_of(Claim("1", dot(a, w), dot(b, w), given=(given,), assuming=assuming))
    verdict = decide_problem(asked)
    assert isinstance(verdict, Fails)
    check_counterexample(asked, verdict.counterexample)


CIRCLES = {
    "one leads to the other": (let(rate(a), n * b), let(rate(b), n * a)),
    "and back": (let(rate(a), n * b), let(rate(b), -n * a)),
    "three": (let(rate(a), n * b), let(rate(b), n * c), let(rate(c), n * a)),
}
SHORT = ("one leads to the other", "and back")
"""Those that take no more than two seconds."""


@pytest.mark.parametrize(("place", "name"), [(k, name) for k, name in enumerate(CIRCLES) if WHOLE or name in SHORT])
def test_rates_that_lead_back_are_followed_until_they_say_nothing_new(place: int, name: str) -> None:
    """Of a' = n b and b' = n a a unit vector a has a.b = 0 and b.b = -1: nothing is refuted under what cannot be."""
    for sides in sample(((dot(a, b), dot(a, a)), (dot(b, b), 3 * dot(a, a))), 2, first=place % 2):
        asked = problem_of(Claim("1", *sides, given=CIRCLES[name], assuming=(unit(a), nonzero(n))))
        verdict = decide_problem(asked)
        assert isinstance(verdict, Fails) == (name == "and back"), verdict


OTHER_INSTANTS = {
    "itself": (at(a, "0"), a),
    "from the other side": (a, at(a, "0")),
    "two others": (at(a, "0"), at(a, "1")),
    "the same": (at(a, "0"), at(a, "0")),
    "its rate": (rate(at(a, "0")), rate(a)),
    "a product": (dot(at(a, "0"), b), dot(a, b)),
    "a sum": (at(a + b, "0"), a + b),
    "an angle": (cos(at(p, "0")), cos(p)),
    "half an angle": (sin(at(p, "0") / 2), sin(p / 2)),
    "a length": (norm(at(a, "0")), norm(a)),
    "a power": (at(p, "0") ** 2, p**2),
    "a quotient": (at(p, "0") / 2, p / 2),
    "a matrix": (at(Q, "0"), Q),
    "a transpose": (at(Q, "0").T, Q.T),
    "a block": (column(at(a, "0"), b), column(a, b)),
    "a bracket": (paren(at(a, "s")), a),
    "a determinant": (det(at(Q, "0")), det(Q)),
    "a cross product": (cross(at(a, "0"), b), cross(a, b)),
    "a skew-symmetric matrix": (CPM(at(a, "0")), CPM(a)),
    "something constant": (at(constant, "0"), constant),
}


@pytest.mark.parametrize("name", OTHER_INSTANTS)
def test_another_instant_is_not_this_one(name: str) -> None:
    left, right = OTHER_INSTANTS[name]
    asked = problem_of(Claim("1", left, right))
    verdict = decide_problem(asked)
    assert isinstance(verdict, Undecided)
    assert "is of another instant than t" in verdict.reason
    with pytest.raises(Rejected):
        check(asked, "", {"witness": dict.fromkeys(WITNESS, "1")})


def test_a_definition_at_another_instant_says_nothing_of_this_one() -> None:
    given = Definition("d", at(a, "0"), 2 * b)
    assert isinstance(decide_problem(problem_of(Claim("1", a, 2 * b, given=(given,)))), Undecided)


def test_a_condition_at_another_instant_determines_nothing_at_this_one() -> None:
    given = Condition("d", at(p, "0"), 2 * q, on=(p,))
    assert isinstance(decide_problem(problem_of(Claim("1", cos(p), cos(2 * q), given=(given,)))), Undecided)
