"""Slips in equations with functions of scalars are found at points in floating point, and what is right is proved."""

from __future__ import annotations

import pytest
from tests.test_inequalities import R, claim, e, euler, half, of_p, p, t, turn, v, w, x, y

from chasles.checker.certificate import check
from chasles.decisions.session import Session
from chasles.repairs.repair import repair
from chasles.statements import Claim, nonzero, rotation
from chasles.statements.inequalities import difference_of, inequality, says_that
from chasles.vocabulary import CPM, PI, column, cos, dot, matrix, norm, number, plain, rate, sin, square, tr
from chasles.vocabulary.expansions import up_to
from chasles.vocabulary.families import Entry, Family, Index, Kronecker
from chasles.vocabulary.functions import Relation, arccos, arcsin, arctan, atan2, cases, exp, log, sqrt
from chasles.vocabulary.partial import partial
from chasles.vocabulary.rotation_vectors import exp_of_vector

A = square("A", "A", "")
i, j = Index("i"), Index("j")
e_of = Family("e", tuple(column(*(number(int(row == place)) for row in range(3))) for place in range(3)))  # type: ignore[arg-type]
BETWEEN = (inequality(y > -PI), inequality(y <= PI), inequality(cos(x) > 0))
SLIPS: list[tuple[Claim, Claim]] = [
    (claim(sin(arccos(x)), sqrt(1 + x**2)), claim(sin(arccos(x)), sqrt(1 - x**2))),
    (claim(sin(arccos(x)), sqrt(1 - x)), claim(sin(arccos(x)), sqrt(1 - x**2))),
    (claim(cos(arcsin(x)), 1 - x**2), claim(cos(arcsin(x)), sqrt(1 - x**2))),
    (claim(sqrt((1 - cos(t)) / 2), abs(cos(t / 2))), claim(sqrt((1 + cos(t)) / 2), abs(cos(t / 2)))),
    (
        claim(p[1], sqrt(1 + tr(R)) / 4, inequality(p[1] > 0), given=(of_p,)),
        claim(p[1], sqrt(1 + tr(R)) / 2, inequality(p[1] > 0), given=(of_p,)),
    ),
    (
        claim(p[1], sqrt(1 - tr(R)) / 2, inequality(p[1] > 0), given=(of_p,)),
        claim(p[1], sqrt(1 + tr(R)) / 2, inequality(p[1] > 0), given=(of_p,)),
    ),
    (
        claim(x, arcsin(R[3, 1]), inequality(x >= -PI / 2), inequality(x <= PI / 2), given=(euler,)),
        claim(x, -arcsin(R[3, 1]), inequality(x >= -PI / 2), inequality(x <= PI / 2), given=(euler,)),
    ),
    (
        claim(y, atan2(R[3, 3], R[3, 2]), *BETWEEN, given=(euler,)),
        claim(y, atan2(R[3, 2], R[3, 3]), *BETWEEN, given=(euler,)),
    ),
    (
        claim(y, atan2(R[2, 3], R[3, 3]), *BETWEEN, given=(euler,)),
        claim(y, atan2(R[3, 2], R[3, 3]), *BETWEEN, given=(euler,)),
    ),
    (
        claim(t, arccos((tr(R) + 1) / 2), inequality(t >= 0), inequality(t <= PI), given=(turn,)),
        claim(t, arccos((tr(R) - 1) / 2), inequality(t >= 0), inequality(t <= PI), given=(turn,)),
    ),
    (
        claim(t, 2 * arcsin(p[1]), inequality(t >= 0), inequality(t <= 2 * PI), given=(half,)),
        claim(t, 2 * arccos(p[1]), inequality(t >= 0), inequality(t <= 2 * PI), given=(half,)),
    ),
    (claim(norm(v), sqrt(v.x**2 + v.y**2 - v.z**2)), claim(norm(v), sqrt(v.x**2 + v.y**2 + v.z**2))),
    (claim(exp(log(x**2)), x), claim(exp(log(x**2)), x**2)),
    (
        claim(partial(column(sin(v.y), v.z), v), matrix((0, sin(v.y), 0), (0, 0, 1))),
        claim(partial(column(sin(v.y), v.z), v), matrix((0, cos(v.y), 0), (0, 0, 1))),
    ),
    (
        claim(R @ exp_of_vector(x * v) @ w, up_to(R @ w - x * R @ CPM(v) @ w, x, 2), rotation(R), nonzero(norm(v))),
        claim(R @ exp_of_vector(x * v) @ w, up_to(R @ w + x * R @ CPM(v) @ w, x, 2), rotation(R), nonzero(norm(v))),
    ),
    (claim(abs(x), cases((x, x > 0), otherwise=x)), claim(abs(x), cases((x, x > 0), otherwise=-x))),
    (claim(dot(e, e) * sqrt(x**2), norm(e) * abs(x)), claim(dot(e, e) * sqrt(x**2), norm(e) ** 2 * abs(x))),
    (
        claim(rate(sqrt(1 + x**2)), x**2 * rate(x) / sqrt(1 + x**2)),
        claim(rate(sqrt(1 + x**2)), x * rate(x) / sqrt(1 + x**2)),
    ),
    (
        claim(rate(sqrt(1 + x**2)), rate(x) / sqrt(1 + x**2)),
        claim(rate(sqrt(1 + x**2)), x * (rate(x) / sqrt(1 + x**2))),
    ),
    (claim(cos(arctan(x)), 1 / sqrt(x**2)), claim(cos(arctan(x)), 1 / sqrt(x**2 + 1))),
    (claim(-v, exp_of_vector(v) @ v), claim(-v, -(exp_of_vector(v) @ v))),
    (claim(dot(e_of[i], e_of[i]), Kronecker(i, j)), claim(dot(e_of[i], e_of[j]), Kronecker(i, j))),
    (claim(Entry(A, i, j, "a"), dot(e_of[j], A @ e_of[i])), claim(Entry(A, j, i, "a"), dot(e_of[j], A @ e_of[i]))),
    (
        claim(partial(sqrt(1 + x), x), x / sqrt(1 + x**2)),
        claim(partial(sqrt(1 + x**2), x), x / sqrt(1 + x**2)),
    ),
]


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("wrong", "right"), SLIPS, ids=lambda said: f"{said.left} = {said.right}")
def test_the_slip_is_among_the_first_that_are_mended(wrong: Claim, right: Claim) -> None:
    assert not Session().decide(wrong).verdict.true
    found = repair(wrong)
    assert any((each.left, each.right) == right.printed for each in found), found
    assert len({(plain(each.left), plain(each.right)) for each in (wrong, *found)}) == 1 + len(found)
    for each in found:
        check(wrong.saying(each.left, each.right), "printed", each.verdict.certificate)


@pytest.mark.parametrize("relation", [x * y <= x**2 / 4 + y**2 / 4, x**2 > 1, dot(v, w) <= dot(v, v) + w[1]], ids=str)
def test_what_is_right_in_place_of_an_inequality_is_one_and_says_something(relation: Relation) -> None:
    (first, *_) = found = repair(claim(*says_that(relation)))
    assert first.verdict.true
    for each in found:
        assert each.left != each.right
        assert difference_of(each.left, each.right) is not None


def test_points_of_rotations_are_drawn() -> None:
    found = repair(claim(sqrt(R[1, 1] ** 2), -abs(R[1, 1]), rotation(R)))
    assert [each.right for each in found][:1] == [abs(R[1, 1])]


def test_nothing_is_offered_where_no_point_is_drawn() -> None:
    """Motions are not drawn."""
    assert repair(claim(rate(sqrt(1 + x**2)), sqrt(1 + x**2) * rate(x))) == ()
    assert repair(claim(sqrt(dot(v, w) ** 2), sqrt(dot(v, w) ** 2) + exp(x) + exp(y))) == ()
