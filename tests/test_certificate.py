"""The checker takes what the prover proves and nothing else: no forged certificate, no counterexample that is none."""

from __future__ import annotations

import ast
import inspect
import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from copy import deepcopy
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from itertools import permutations, product
from operator import methodcaller
from pathlib import Path
from typing import Any

import pytest

from chasles.checker.certificate import Rejected, check
from chasles.checker.division import MOST_REPLACED
from chasles.checker.reading import PolynomialProblem
from chasles.checker.refutation import check_counterexample
from chasles.checker.sparse import Polynomial, exponents, limited, parsed, variable
from chasles.decisions.session import Session
from chasles.prover.decide import decide_problem
from chasles.statements import (
    Claim,
    Condition,
    Definition,
    Goal,
    Hypothesis,
    Inverse,
    Minimum,
    Problem,
    Statement,
    Theorem,
    definite,
    load,
    nonzero,
    orthonormal,
    perpendicular,
    positive,
    problem_of,
    rotation,
    symmetric,
    unit,
)
from chasles.statements.inversion import problems_of_inverse
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    LENGTH,
    PI,
    Cofactor,
    Identity,
    Integral,
    Node,
    Scale,
    Sum,
    Zero,
    abbreviation,
    array,
    at,
    column,
    cos,
    cross,
    det,
    dot,
    integral,
    inverse,
    matrix,
    norm,
    number,
    over,
    paren,
    rate,
    scalar,
    sin,
    square,
    tr,
    vect,
    vector,
)
from chasles.vocabulary.nodes import measured

from .decided import chapter_session
from .sampling import WHOLE, sample

Certificate = dict[str, Any]
Forgery = Callable[[Certificate], object]
SRC = Path(__file__).resolve().parents[1] / "src"

one, zero = Identity(3), number(0)
e, f, g, h = (vector(name, name, "a vector") for name in "efgh")
a, a_, b, d_A, p, p_0 = (vector(name, name, "a position", LENGTH) for name in ("a", "a'", "b", "d_A", "p", "p_0"))
omega = vector("omega", r"\omega", "angular velocity", FREQUENCY)
phi, theta, m, x = (scalar(name, name, "a scalar") for name in ("phi", "theta", "m", "x"))
rho = scalar("rho", r"\rho", "a density", constant=True)
Q, R, M = (square(name, name, "a matrix") for name in "QRM")
E = abbreviation("E", "E", CPM(e), "cross-product matrix of e")
A = array("A", "A", "four rows", column(Q - one, e.T))
N = column((sin(phi) / (2 * (1 - cos(phi)))) * (one - e @ e.T) - over(1, 2) * E, e.T)
H = over(1, 2) * column(cos(phi / 2) * one - sin(phi / 2) * E, -sin(phi / 2) * e.T)

turn = Definition("2.49", Q, e @ e.T + cos(phi) * (one - e @ e.T) + sin(phi) * E, assuming=(unit(e),))
turn_back = Definition("2.49", Q, e @ e.T + cos(phi) * (one - e @ e.T) - sin(phi) * E, assuming=(unit(e),))
rows = Definition("3.11", A, column(Q - one, e.T))
displacement = Definition("3.3", d_A, a_ - a)
spin = Definition("2.95", omega, vect(rate(Q) @ Q.T))
nearest = Condition("3.8", e.T @ p_0, zero, on=(p_0,))
on_axis = Condition("3.9", e @ e.T @ d_A, d_A + (Q - one) @ (p_0 - a), on=(p_0,), given=(turn,))
turns = nonzero(1 - cos(phi), r"\phi \neq 0")


def claim(name: str, left: Node, right: Node, *assuming: Any, given: tuple[Statement, ...] = ()) -> Claim:
    return Claim(name, left, right, given=given, assuming=assuming)


def moment(of: Node) -> Node:
    return integral(of, rho, p)


normal_matrix = 2 * (1 - cos(phi)) * one - (1 - 2 * cos(phi)) * e @ e.T
normal_inverse = 1 / (2 * (1 - cos(phi))) * one + (1 - 2 * cos(phi)) / (2 * (1 - cos(phi))) * e @ e.T
axis_point = (Q - one).T @ (Q @ a - a_) / (2 * (1 - cos(phi)))
steiner = moment(rho * p @ p.T) - moment(rho * p) @ b.T - b @ moment(rho * p).T + moment(rho) * b @ b.T

TRUE: tuple[Statement | Theorem, ...] = (
    claim("3.13", A.T @ A, normal_matrix, unit(e), given=(rows, turn)),
    claim("3.16", inverse(A.T @ A), normal_inverse, unit(e), turns, given=(rows, turn)),
    claim("3.18", p_0, axis_point, unit(e), turns, given=(turn, displacement, nearest, on_axis)),
    claim("3.76a, N", rate(column(e, phi)), N @ omega, unit(e), turns, given=(turn, spin)),
    claim("3.76a, H", rate(column(sin(phi / 2) * e, cos(phi / 2))), H @ omega, unit(e), given=(turn, spin)),
    claim("3.76b", rate(Q), CPM(omega) @ Q, unit(e), given=(turn, spin)),
    claim("half an angle", 2 * cos(phi / 2) ** 2, 1 + cos(phi)),
    claim("cosine alone", cos(phi) * (1 + cos(phi)), cos(phi) + cos(phi) ** 2),
    claim("sine alone", sin(phi) * (1 + sin(phi)), sin(phi) + sin(phi) ** 2),
    claim("angles", cos(phi + 2 * theta - phi / 2), cos(phi / 2) * cos(2 * theta) - sin(phi / 2) * sin(2 * theta)),
    claim("backwards", sin(theta - phi), sin(theta) * cos(phi) - cos(theta) * sin(phi)),
    claim("bare angle", rate(phi * cos(phi)), rate(phi) * (cos(phi) - phi * sin(phi))),
    claim("angle and pi", PI * phi * cos(phi) ** 2 + PI * phi * sin(phi) ** 2, phi * PI),
    claim("bare angles", phi * cos(phi) + phi * theta * sin(theta), phi * (cos(phi) + theta * sin(theta))),
    claim("second rate", dot(e, rate(rate(e))), -dot(rate(e), rate(e)), unit(e)),
    claim("rotation", R @ CPM(a) @ R.T, CPM(R @ a), rotation(R)),
    claim("rotation's rate", rate(R) @ R.T + paren(rate(R) @ R.T).T, Zero(3, 3), rotation(R)),
    claim("rotation's trace", tr(R) ** 2, tr(R @ R) + 2 * tr(R), rotation(R)),
    claim("triad", cross(e, f), g, orthonormal(e, f, g)),
    claim("perpendicular", dot(e, cross(e, f) + f), zero, perpendicular(e, f)),
    claim("double cross", cross(e, cross(f, g)), Zero(3, 1), perpendicular(e, f), perpendicular(e, g)),
    claim("symmetric", vect(rate(M)), Zero(3, 1), symmetric(M)),
    claim("definite", det(M) / det(M) ** 2, 1 / det(M), definite(M)),
    claim("3.57", (one - omega @ omega.T / norm(omega) ** 2) @ a, -(1 / norm(omega) ** 2 * CPM(omega) ** 2 @ a),
          nonzero(norm(omega))),
    claim("3.58", CPM(omega) ** 2, omega @ omega.T - norm(omega) ** 2 * one),
    claim("norm's rate", rate(norm(a - b)), dot(b - a, rate(b - a)) / norm(b - a), nonzero(norm(a - b))),
    claim("norms", norm(a - b) + norm(b - a), 2 * norm(b - a)),
    claim("free vectors", cross(a, cross(b, e)), dot(a, e) * b - dot(a, b) * e),
    claim("arguments", rate(at(e)) + rate(paren(f)), rate(paren(e + at(f)))),
    claim("adjugate", Cofactor(M) @ M.T, det(M) * one),
    claim("blocks", det(matrix((M, e), (Zero(1, 3), m))), m * det(M)),
    claim("quotients", 1 / paren(-2 * m) + 1 / m + x / m / m, (x / m) / m + 1 / (2 * m), positive(m)),
    claim("quotient's rate", rate(x / m), rate(x) / m - x * rate(m) / m**2, positive(m)),
    claim("moments", moment(rho * (p - b) @ (p - b).T), steiner),
    claim("moments by a rule", integral(rho * d_A @ d_A.T, rho, d_A, a_),
          integral(rho * a_ @ a_.T, rho, d_A, a_) - integral(rho * a_, rho, d_A, a_) @ a.T
          - a @ integral(rho * a_, rho, d_A, a_).T + integral(rho, rho, d_A, a_) * a @ a.T, given=(displacement,)),
    claim("moment's rate", rate(moment(rho * dot(p, p))), 2 * moment(rho * dot(p, rate(p)))),
    Theorem("least", "p is least at a.", (Minimum(dot(p - a, p - a), zero, p, a, (p - a,)),)),
)  # fmt: skip
BY_NAME = {statement.number: statement for statement in TRUE}


@cache
def proved(name: str) -> Certificate:
    verdict = decide_problem(problem_of(BY_NAME[name]))
    assert isinstance(verdict, Holds | HoldsUnder), (name, verdict)
    return dict(verdict.certificate)


@pytest.mark.parametrize("name", BY_NAME)
def test_a_certificate_is_accepted(name: str) -> None:
    check(BY_NAME[name], "printed", proved(name))
    check(problem_of(BY_NAME[name]), "", json.loads(json.dumps(proved(name))))


def refused(name: str, forge: Forgery, reason: str, statement: Any = None) -> None:
    forged = deepcopy(proved(name))
    forge(forged)
    with pytest.raises(Rejected, match=reason):
        check(statement or BY_NAME[name], "printed", forged)


def things_said(name: str, about: str) -> Iterator[tuple[tuple[str, str], Certificate]]:
    """What is said of unknowns and of entries that division alone does not show, each with the way to it."""
    for part in ("solved", "entries"):
        for key, said in proved(name).get(part, {}).items():
            if about in said:
                yield (part, key), said


WITH_DIVISION = [name for name in BY_NAME if "division" in proved(name)]
WITH_COFACTORS = [name for name in BY_NAME if any(things_said(name, "cofactors"))]
WITH_DENOMINATORS = [name for name in BY_NAME if any(things_said(name, "denominator"))]


def test_each_kind_of_certificate_is_there() -> None:
    assert len(WITH_DIVISION) > 12
    assert WITH_COFACTORS == ["3.18", "double cross"]
    assert WITH_DENOMINATORS == ["3.18"]


@pytest.mark.parametrize("name", WITH_COFACTORS)
def test_every_cofactor_counts(name: str) -> None:
    for (part, key), said in things_said(name, "cofactors"):
        for label, cofactor in said["cofactors"].items():
            for forged in ({}, {label: f"{cofactor} + 1"}, {label: f"{cofactor} + -1/2*{some_variable(name)}"}):
                kept = {other: text for other, text in said["cofactors"].items() if other != label} | forged
                refused(name, put(part, key, "cofactors", kept), "does not follow")


@pytest.mark.parametrize("name", WITH_DENOMINATORS)
def test_every_denominator_counts(name: str) -> None:
    for (part, key), said in things_said(name, "denominator"):
        for label, power in said["denominator"].items():
            for forged in ({}, {label: power + 1}):
                kept = {other: n for other, n in said["denominator"].items() if other != label} | forged
                refused(name, put(part, key, "denominator", kept), "does not follow")


@pytest.mark.parametrize("name", WITH_DIVISION)
def test_every_division_counts(name: str) -> None:
    for place, (label, term) in enumerate(proved(name)["division"]):
        refused(name, lambda c, k=place: c["division"].pop(k), "does not follow")
        for forged, reason in (
            (["|h| = 1 [0: 1, 1]", term], "which the statement does not assume"),
            ([label, f"{term}*{some_variable(name)}"], "which does not occur in it"),
            ([label, "h_1"], "no power of a variable"),
        ):
            refused(name, lambda c, k=place, forged=forged: c["division"].__setitem__(k, forged), reason)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", WITH_DIVISION)
def test_division_by_any_term_proves_nothing_false(name: str) -> None:
    """Whatever the certificate divides by, and for whichever term it is solved."""
    problem = problem_of(BY_NAME[name])
    for label, _ in proved(name)["division"]:
        for monomial in PolynomialProblem(problem, proved(name)["witness"]).vanishing[label].terms:
            forged = deepcopy(proved(name)) | {"division": [[label, named(problem, monomial)]]}
            for goal in problem.goals:
                with pytest.raises(Rejected):
                    check(replace(problem, goals=(Goal("", goal.left, and_more(goal, 0, 0)),)), "", forged)


def named(problem: Problem, monomial: int) -> str:
    """The factors of a monomial, as a certificate writes them."""
    names = {place: name for name, place in PolynomialProblem(problem, ("cos(phi)", "cos(phi/2)")).places.items()}
    return "*".join(f"{names[place]}^{power}" for place, power in exponents(monomial))


def test_the_witness_satisfies_what_is_divided_by() -> None:
    two = claim("0.0", dot(e, e), number(1), unit(e), unit(f))
    lengths = {"e_1": "0", "e_2": "1", "e_3": "0", "f_1": "1", "f_2": "1", "f_3": "0"}
    division = [["|e| = 1 [0: 1, 1]", "e_3^2"], ["|f| = 1 [0: 1, 1]", "f_3^2"]]
    check(two, "printed", {"division": division[:1], "witness": {f"e_{k}": lengths[f"e_{k}"] for k in (1, 2, 3)}})
    for known, reason in (("e", "no value is given for f_1, f_2, f_3"), ("ef", r"does not satisfy \|f\| = 1")):
        witness = {name: value for name, value in lengths.items() if name[0] in known}
        with pytest.raises(Rejected, match=reason):
            check(two, "printed", {"division": division, "witness": witness})


def test_a_division_without_end_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("chasles.checker.division.MOST_REPLACED", MOST_REPLACED if WHOLE else 2000)
    labels = ("e is perpendicular to f [0: 1, 1]", "f is perpendicular to e [0: 1, 1]")
    circular = [[label, term] for label, term in zip(labels, ("e_3*f_3", "e_1*f_1"), strict=True)]
    third = matrix(*(tuple(number(int(i == j == 2)) for j in range(3)) for i in range(3)))
    turning = claim("0.0", dot(e, third @ f), zero, perpendicular(e, f), perpendicular(f, e))
    for division, reason in ((circular[:1], "does not follow"), (circular, "there is no end to the division")):
        with pytest.raises(Rejected, match=reason):
            check(turning, "printed", proved("perpendicular") | {"division": division})


def put(part: str, key: str, what: str, value: object) -> Forgery:
    """A forgery that says something else of one entry or one unknown."""

    def forge(certificate: Certificate) -> None:
        certificate[part][key][what] = value

    return forge


def some_variable(name: str) -> str:
    return next(iter(sorted(name for name in proved(name)["witness"] if " " not in name)))


@pytest.mark.parametrize("name", ["3.13", "3.16", "3.76a, N", "rotation", "3.58", "adjugate", "double cross"])
def test_every_entry_is_asked_for(name: str) -> None:
    problem = problem_of(BY_NAME[name])
    for count, goal in enumerate(problem.goals):
        rows, columns = goal.left.shape
        for i, j in product(range(rows), range(columns)):
            wrong = and_more(goal, i, j)
            goals = [*problem.goals]
            goals[count] = Goal("", goal.left, wrong)
            with pytest.raises(Rejected, match=f"entry {i + 1}, {j + 1} of equation {count + 1} does not follow"):
                check(replace(problem, goals=tuple(goals)), "", proved(name))


def and_more(goal: Goal, row: int, column: int) -> Node:
    """The right side of a goal, with something more in one entry."""
    rows, columns = goal.left.shape
    dimension = measured(goal.left).grid[row][column]
    more = scalar("more", "more", "something more", dimension)
    ones = [tuple(number(int((i, j) == (row, column))) for j in range(columns)) for i in range(rows)]
    return Sum((goal.right, more if goal.left.is_scalar else Scale(more, matrix(*ones))))


@pytest.mark.parametrize(
    ("name", "lost"),
    [
        ("3.13", "e_1"),
        ("3.13", "cos(phi)"),
        ("3.13", "sin(phi)"),
        ("3.16", "e_3"),
        ("3.18", "p_0_2"),
        ("3.18", "a'_1"),
        ("3.76a, N", "phi_dot"),
        ("3.76b", "e_dot_3"),
        ("half an angle", "sin(phi/2)"),
        ("cosine alone", "sin(phi)"),
        ("sine alone", "cos(phi)"),
        ("second rate", "e_ddot_1"),
        ("3.57", "|omega|"),
        ("3.57", "omega_1"),
        ("norm's rate", "a_2"),
        ("norms", "a_1"),
        ("rotation", "R_33"),
        ("moments", "int(rho p_2)"),
    ],
)
def test_a_witness_is_complete(name: str, lost: str) -> None:
    refused(name, lambda c: c["witness"].pop(lost), "no value is given for")


@pytest.mark.parametrize(
    ("name", "variable", "value", "reason"),
    [
        ("3.13", "e_1", "7", r"does not satisfy \|e\| = 1"),
        ("3.13", "cos(phi)", "1/3", "does not satisfy circle phi"),
        ("3.18", "p_0_1", "77", "does not satisfy 1. \\(3.8\\)|does not satisfy 2. \\(3.9\\)"),
        ("3.76b", "e_dot_1", "5", r"does not satisfy \|e\| = 1 \(dot\)"),
        ("second rate", "e_ddot_1", "5", r"does not satisfy \|e\| = 1 \(ddot\)"),
        ("rotation", "R_11", "7", "does not satisfy R is a rotation"),
        ("symmetric", "M_dot_12", "1/7", r"does not satisfy M is symmetric \(dot\)"),
        ("3.57", "|omega|", "100", "does not satisfy norm"),
        ("quotients", "m", "-1", "does not satisfy m > 0"),
        ("quotients", "m", "0", "does not satisfy 1.m>0"),
        ("angle and pi", "pi", "2", "pi is given two values"),
        ("angle and pi", "phi", "1/3", "are not those of the angle given"),
        ("bare angle", "phi", "0", "are not those of the angle given"),
        ("3.13", "e_1", "0.6.", "malformed"),
        ("3.13", "e_1", "1/0", "malformed"),
    ],
)
def test_a_witness_satisfies_everything(name: str, variable: str, value: str, reason: str) -> None:
    refused(name, lambda c: c["witness"].update({variable: value}), reason)


def test_pi_is_what_it_is_even_where_the_witness_does_not_say_so() -> None:
    """The sine of pi vanishes; a witness that leaves pi out does not hide it."""
    half_a_turn = Hypothesis("equation", (phi,), ((phi, PI * 1),), (), "", "phi = pi", free=True)
    absurd = Problem((Goal("", phi * cos(phi), cos(phi) * phi),), hypotheses=(half_a_turn, nonzero(sin(phi))))
    for turn, reason in (("1", "not those of the angle given"), ("1/2", "does not satisfy phi = pi")):
        witness = {"phi": turn, "cos(phi)": "0", "sin(phi)": "1"}
        with pytest.raises(Rejected, match=reason):
            check(absurd, "", {"witness": witness})
    third = problem_of(claim("0.0", cos(PI / 3), cos(PI / 3), nonzero(2 * cos(PI / 3) - 1)))
    with pytest.raises(Rejected, match="no angle"):
        check(third, "", {"witness": {"cos(pi/3)": "3/5", "sin(pi/3)": "4/5"}})


def test_a_norm_is_not_negative() -> None:
    length = proved("3.57")["witness"]["|omega|"]
    refused("3.57", lambda c: c["witness"].update({"|omega|": f"-{length}"}), "negative")


def test_what_is_divided_by_is_not_zero_at_the_witness() -> None:
    north = {"cos(phi)": "1", "sin(phi)": "0"}
    refused("3.16", lambda c: c["witness"].update(north), "does not satisfy 1.phi!=0")


def test_a_definite_matrix_is_so_at_the_witness() -> None:
    indefinite = {f"M_{i}{j}": str((i == j) * (-1 if i < 3 else 1)) for i in (1, 2, 3) for j in (1, 2, 3)}
    refused("definite", lambda c: c["witness"].update(indefinite), "does not satisfy M is positive-definite")


def test_contradictory_hypotheses_prove_nothing() -> None:
    absurd = claim("0.0", dot(e, e), number(7), unit(e), perpendicular(e, e))
    entry = {
        "cofactors": {"|e| = 1 [0: 1, 1]": "7", "e is perpendicular to e [0: 1, 1]": "-6"},
    }
    for length in ("0", "1"):
        witness = {"e_1": length, "e_2": "0", "e_3": "0"}
        with pytest.raises(Rejected, match="the point does not satisfy"):
            check(absurd, "printed", {"entries": {"0:0,0": entry}, "witness": witness})


def bare_certificate(**witness: str) -> Certificate:
    """Of a statement with one entry, whose sides are the same polynomial."""
    return {"witness": witness}


def test_contradictory_conditions_prove_nothing() -> None:
    contradiction = (Condition("1", x * 1, number(1), on=(x,)), Condition("2", x * 1, number(2), on=(x,)))
    absurd = claim("0.0", m * 1, 1 * m, given=contradiction)
    check(claim("0.0", m * 1, 1 * m, given=contradiction[:1]), "printed", bare_certificate(m="3", x="1"))
    for witness, reason in (({"x": "1"}, "does not satisfy 2."), ({"x": "2"}, "does not satisfy 1."), ({}, "for x")):
        with pytest.raises(Rejected, match=reason):
            check(absurd, "printed", bare_certificate(m="3", **witness))


def test_a_quotient_of_what_is_not_zero_can_be_divided_by() -> None:
    turned = claim("0.0", 1 / paren(m / x), x / m, positive(m), nonzero(x))
    check(turned, "printed", bare_certificate(m="3", x="1"))
    needs_what_it_divides_by = claim("0.0", 1 / paren(m / x), x / m, nonzero(x))
    check(needs_what_it_divides_by, "printed", bare_certificate(m="3", x="1"))
    with pytest.raises(Rejected, match=r"does not satisfy 2\.m!=0"):
        check(needs_what_it_divides_by, "printed", bare_certificate(m="0", x="1"))


def test_a_hypothesis_nobody_cites_is_satisfied_too() -> None:
    certificate = bare_certificate(e_1="0", e_2="0", e_3="0")
    check(claim("0.0", dot(e, e), norm(e) ** 2), "printed", certificate)
    with pytest.raises(Rejected, match=r"does not satisfy \|e\| = 1"):
        check(claim("0.0", dot(e, e), norm(e) ** 2, unit(e)), "printed", certificate)


@pytest.mark.parametrize(
    ("name", "statement", "reason"),
    [
        ("3.13", claim("3.13", A.T @ A, normal_matrix + e @ e.T, unit(e), given=(rows, turn)), "does not follow"),
        ("3.13", claim("3.13", A.T @ A, normal_matrix, given=(rows,)), "which the statement does not assume"),
        ("3.76b", claim("3.76b", rate(Q), CPM(omega) @ Q.T, unit(e), given=(turn_back, spin)), "does not follow"),
        (
            "3.18",
            claim("", p_0, axis_point + a, unit(e), turns, given=(turn, displacement, nearest, on_axis)),
            "follow",
        ),
        ("3.18", claim("", p_0, axis_point, unit(e), turns, given=(turn, displacement, nearest)), "does not assume"),
        (
            "second rate",
            claim("", dot(e, rate(rate(e))), -dot(rate(e), rate(e))),
            "which the statement does not assume",
        ),
        ("rotation", claim("", R @ CPM(a) @ R.T, CPM(R @ a), symmetric(R)), "which the statement does not assume"),
        ("norms", claim("norms", norm(a - b) + norm(b + a), 2 * norm(b - a)), "does not follow"),
        ("arguments", claim("", a, a), "no value is given for a_1, a_2, a_3"),
        ("free vectors", Definition("", d_A, a), "nothing to prove"),
    ],
)
def test_a_certificate_is_of_one_statement(name: str, statement: Statement, reason: str) -> None:
    refused(name, lambda c: None, reason, statement)


def first(**said: object) -> Forgery:
    """A forgery that says this of the first entry."""
    return lambda certificate: certificate.update(entries={"0:0,0": said})


@pytest.mark.parametrize(
    ("name", "forge", "reason"),
    [
        ("3.16", first(denominator={"2. e != 0": 1}), "not declared nonzero"),
        ("3.16", first(denominator={"cos(phi)": 1}), "not declared nonzero"),
        ("3.13", first(denominator={"1. phi != 0": 1}), "not declared nonzero"),
        ("3.13", first(cofactors={"|e| = 2 [0: 1, 1]": "1"}), "does not assume"),
        ("3.13", first(cofactors={"circle theta": "1"}), "does not assume"),
        ("3.13", first(cofactors={"|e| = 1 (dot) [0: 1, 1]": "1"}), "not assume"),
        ("double cross", lambda c: c["entries"].pop("0:2,0"), "entry 3, 1 of equation 1 does not follow"),
        ("3.18", lambda c: c["solved"]["p_0_1"].update(numerator="0"), "value of p_0_1 does not follow"),
        ("3.18", lambda c: c["solved"]["p_0_2"]["denominator"].clear(), "value of p_0_2 does not follow"),
        ("3.18", lambda c: c["solved"].clear(), "does not follow"),
        ("3.18", lambda c: c["solved"].update(q=c["solved"]["p_0_1"]), "malformed"),
        ("3.13", lambda c: c.pop("witness"), "malformed"),
        ("3.18", lambda c: c.pop("solved"), "does not follow"),
        ("3.13", lambda c: c.pop("division"), "does not follow"),
        ("3.13", lambda c: c.update(division=7), "malformed"),
        ("3.13", lambda c: c.update(division=[["|e| = 1 [0: 1, 1]", "e_1", "e_2"]]), "malformed"),
        ("3.13", lambda c: c.update(entries=[]), "malformed"),
        ("3.13", first(cofactors={"|e| = 1 [0: 1, 1]": "e_4"}), "malformed"),
        ("3.13", first(cofactors={"|e| = 1 [0: 1, 1]": "1*e_4"}), "no power of a"),
        ("3.13", first(cofactors={"|e| = 1 [0: 1, 1]": "1*e_1^32768"}), "exponent from"),
        ("3.13", first(cofactors={"|e| = 1 [0: 1, 1]": "1*e_1^65536"}), "exponent from"),
        ("3.13", first(cofactors={"|e| = 1 [0: 1, 1]": "1*e_1^-1"}), "exponent from"),
        ("3.13", first(cofactors={"|e| = 1 [0: 1, 1]": "1*e_1^32767"}), "larger than 32767"),
        ("3.13", first(cofactors={"|e| = 1 [0: 1, 1]": "1*e_1^32767*e_1^32767*e_1^32767"}), "larger than 32767"),
        (
            "3.18",
            lambda c: c["solved"]["p_0_1"].update(denominator={" 1. phi!=0"[k:]: 127 for k in (0, 1)}),
            "does not follow",
        ),
        ("3.13", first(cofactors={"|e| = 1 [0: 1, 1]": "1/0"}), "malformed"),
        ("3.13", first(cofactors={"|e| = 1 [0: 1, 1]": None}), "malformed"),
    ],
)
def test_a_forgery_is_refused(name: str, forge: Forgery, reason: str) -> None:
    refused(name, forge, reason)


def test_a_product_of_large_powers_does_not_spill_over() -> None:
    large = variable(1, 20_000)
    [monomial] = (large * variable(1, 12_000) * variable(0, 7)).terms
    assert exponents(monomial) == [(0, 7), (1, 32_000)]
    with pytest.raises(Rejected, match="larger than 32767"):
        large * large


def test_two_quantities_of_one_name_are_not_confused() -> None:
    other = vector("e", "e'", "another vector")
    same = claim("0.0", e, other)
    witness = {f"e_{k}": "1" for k in (1, 2, 3)}
    with pytest.raises(Rejected, match="two different quantities are both called e_1"):
        check(same, "printed", {"witness": witness})


def test_what_differs_from_element_to_element_is_not_taken_out_of_an_integral() -> None:
    outside = "no polynomial in what differs from element to element"
    for left, right, reason in (
        (moment(rho * norm(p)), norm(p) * moment(rho), outside),
        (integral(rho * cos(phi), rho, phi), cos(phi) * integral(rho, rho, phi), outside),
        (moment(rho * p / dot(p, p)), p * moment(rho) / dot(p, p), outside),
        (Integral(rho * p, rho, (p,), "B"), Integral(rho * p, rho, (p,), "C"), "two different quantities"),
    ):
        with pytest.raises(Rejected, match=reason):
            PolynomialProblem(problem_of(claim("0.0", left, right, nonzero(dot(p, p)))), ())
    first = vector("first", "f", "a first moment", LENGTH**4)
    for of, rule in ((p, a + b), (first, integral(a_, rho, a_))):
        whole = integral(of, rho, of, a_)
        with pytest.raises(Rejected, match="the same for all elements"):
            PolynomialProblem(Problem((Goal("", whole, whole),), rules=((of, rule),)), ())


@dataclass(frozen=True)
class Refuted:
    """A false claim and what refutes it."""

    problem: Problem
    by: Counterexample


FALSE = {
    statement.number: statement
    for statement in (
        claim("3.13", A.T @ A, normal_matrix + 2 * e @ e.T, unit(e), given=(rows, turn)),
        claim("3.18", p_0, axis_point + a, unit(e), turns, given=(turn, displacement, nearest, on_axis)),
        claim("3.76a", rate(column(e, phi)), 2 * N @ omega, unit(e), turns, given=(turn, spin)),
        claim("angle", cos(phi), 2 * cos(phi / 2) ** 2 + 1),
        claim("bare angle", phi * cos(phi), sin(phi)),
        claim("pi", phi * 1, PI * 1),
        claim("angle and pi", PI * sin(phi), PI * cos(phi) + phi * 0),
        claim("rotation", R @ cross(a, b), cross(a, R @ b), rotation(R)),
        claim("symmetric", M @ M, M.T, symmetric(M)),
        claim("definite", 1 / det(M), 2 * det(M) / det(M) ** 2, definite(M)),
        claim("triad", cross(e, f), -g, orthonormal(e, f, g)),
        claim("norm", norm(f) ** 2 * g, norm(f) * f, nonzero(norm(f))),
        claim("norm assumed", dot(f, f), zero, nonzero(norm(f))),
        claim("norm of a difference", norm(a - b) * norm(a), dot(a, a), nonzero(norm(b))),
        claim("bare angles", phi * cos(theta) + theta * cos(phi), zero),
        claim("norm's rate", rate(norm(a)) * norm(a), 2 * dot(a, rate(a)), nonzero(norm(a))),
        claim("second rate", dot(e, rate(rate(e))), dot(rate(e), rate(e)), unit(e)),
        claim("positive", 1 / m, m / m, positive(m)),
        claim("moments", moment(rho * (p - b) @ (p - b).T), moment(rho * p @ p.T) - moment(rho) * b @ b.T),
    )
}


@cache
def refutation(name: str) -> Refuted:
    problem = problem_of(FALSE[name])
    verdict = decide_problem(problem)
    assert isinstance(verdict, Fails), (name, verdict)
    return Refuted(problem, verdict.counterexample)


@pytest.mark.parametrize("name", FALSE)
def test_a_counterexample_refutes(name: str) -> None:
    check_counterexample(refutation(name).problem, refutation(name).by)


def not_refuted(problem: Problem, shown: Counterexample, reason: str) -> None:
    with pytest.raises(Rejected, match=reason):
        check_counterexample(problem, shown)


@pytest.mark.parametrize("name", FALSE)
def test_a_counterexample_shows_the_values_of_both_sides(name: str) -> None:
    problem, by = refutation(name).problem, refutation(name).by
    not_refuted(problem, replace(by, left="17"), f"at the point, not 17 and {by.right}".replace("+", "."))
    not_refuted(problem, replace(by, right="17"), "at the point, not .* and 17")
    not_refuted(problem, replace(by, left=by.right, right=by.left), "at the point, not")
    not_refuted(problem, replace(by, goal="another"), "no equation of the statement is called 'another'")
    not_refuted(problem, replace(by, entry=(9, 9)), "the equation has no entry 9, 9")


@pytest.mark.parametrize("name", FALSE)
def test_what_is_true_is_not_refuted(name: str) -> None:
    problem, by = refutation(name).problem, refutation(name).by
    goals = tuple(Goal(goal.label, goal.left, goal.left) for goal in problem.goals)
    not_refuted(replace(problem, goals=goals), by, f"both sides are {by.left} at the point".replace("+", "."))


@pytest.mark.parametrize(
    ("name", "at", "reason"),
    [
        ("3.13", {"e_1": Fraction(1, 3)}, r"does not satisfy \|e\| = 1"),
        ("3.13", {"cos(phi)": Fraction(1, 3)}, "does not satisfy circle phi"),
        ("3.76a", {"cos(phi)": Fraction(1), "sin(phi)": Fraction(0)}, "does not satisfy 1.phi!=0"),
        ("3.18", {"p_0_1": Fraction(1, 77)}, "does not satisfy"),
        ("rotation", {"R_11": Fraction(1, 3)}, "does not satisfy R is a rotation"),
        ("symmetric", {"M_12": Fraction(1, 3)}, "does not satisfy M is symmetric"),
        ("definite", {f"M_{k}{k}": Fraction(-1) for k in (1, 2, 3)}, "does not satisfy M is positive-definite"),
        ("bare angles", {"phi": Fraction(2)}, "not those of the angle given"),
        ("norm", {"|f|": Fraction(-1)}, "negative"),
        ("norm", {"|f|": Fraction(100)}, "does not satisfy norm"),
        ("positive", {"m": Fraction(-2)}, "does not satisfy m > 0"),
        ("positive", {"m": Fraction(0)}, "does not satisfy 1.m>0"),
        ("second rate", {"e_ddot_1": Fraction(1, 7), "e_dot_1": Fraction(1, 7)}, "does not satisfy"),
    ],
)
def test_a_counterexample_satisfies_every_hypothesis(name: str, at: dict[str, Fraction], reason: str) -> None:
    problem, by = refutation(name).problem, refutation(name).by
    not_refuted(problem, replace(by, at={**by.at, **at}), reason)


def test_an_angle_beside_pi_fits_its_cosine_and_sine() -> None:
    problem = problem_of(claim("0.0", phi * cos(phi), PI * 1))
    full_turn = {"phi": Fraction(2), "cos(phi)": Fraction(1), "sin(phi)": Fraction(0)}
    check_counterexample(problem, Counterexample(full_turn, (1, 1), "2 pi", "pi"))
    for odd in (
        {"phi": Fraction(1)},
        {"phi": Fraction(1, 3)},
        {"cos(phi)": Fraction(3, 5), "sin(phi)": Fraction(4, 5)},
        {"cos(phi)": Fraction(0), "sin(phi)": Fraction(1)},
    ):
        not_refuted(problem, Counterexample({**full_turn, **odd}, (1, 1), "2 pi", "pi"), "not those of the angle given")


def test_what_a_counterexample_leaves_open_is_asked_for() -> None:
    for name, lost in (("bare angles", "phi"), ("3.13", "sin(phi)")):
        problem, by = refutation(name).problem, refutation(name).by
        shown = {variable: value for variable, value in by.at.items() if variable != lost}
        not_refuted(problem, replace(by, at=shown), "no value is given for")


def test_a_counterexample_where_the_sides_agree_is_none() -> None:
    problem = problem_of(claim("0.0", m**2, m * 1, positive(m)))
    check_counterexample(problem, Counterexample({"m": Fraction(2)}, (1, 1), "4", "2"))
    not_refuted(problem, Counterexample({"m": Fraction(1)}, (1, 1), "1", "1"), "both sides are 1 at the point")


def test_a_counterexample_satisfies_hypotheses_on_symbols_it_does_not_show() -> None:
    problem = problem_of(claim("0.0", dot(e, e), number(1), orthonormal(e, f, g)))
    short = Counterexample({"e_1": Fraction(2), "e_2": Fraction(0), "e_3": Fraction(0)}, (1, 1), "4", "1")
    not_refuted(problem, short, "does not satisfy e, f, g are orthonormal")
    absurd = problem_of(claim("0.0", dot(e, e), number(2), perpendicular(e, f), nonzero(dot(e, f))))
    not_refuted(absurd, replace(short, right="2"), "does not satisfy 1.e.f!=0")


def test_an_angle_in_two_measures_is_not_taken_apart() -> None:
    problem = problem_of(claim("0.0", cos(phi), 2 * cos(phi / 2) ** 2 - 1))
    check(problem, "", dict(decided(problem)))
    one_measure = {"cos(phi/3)": Fraction(1)}
    not_refuted(problem, Counterexample(one_measure, (1, 1), "0", "1"), "no whole multiple")
    not_refuted(problem, Counterexample({}, (1, 1), "0", "1"), "by which fraction of an angle")


def decided(problem: Problem) -> Certificate:
    verdict = decide_problem(problem)
    assert isinstance(verdict, Holds | HoldsUnder)
    return dict(verdict.certificate)


EVERY = 3
"""The certificate of one sentence of the book in so many is checked."""


def book() -> tuple[Session, tuple[Any, ...]]:
    """A session and the decisions on sentences of the book."""
    session = chapter_session()
    return session, tuple(session.decide(entry.statement) for entry in sample(load(), EVERY))


@pytest.mark.slow
def test_every_certificate_of_the_book_is_accepted() -> None:
    judge, decisions = book()
    checked = 0
    for decision in decisions:
        if decision.certificate is not None:
            check(decision.repaired, "printed", decision.certificate, judge.accepted)
            checked += 1
        if isinstance(decision.verdict, Fails) and not isinstance(decision.statement, Inverse):
            problem = problem_of(decision.statement, standing=judge.accepted)
            check_counterexample(problem, decision.verdict.counterexample)
    assert checked >= (98 if WHOLE else 98 // EVERY)


@pytest.mark.slow
def test_the_certificates_of_the_book_are_small(record_property: Callable[[str, object], None]) -> None:
    """As JSON without blanks: all together less than 500 kB by far, where cofactors would take a megabyte."""
    sizes = {}
    for decision in book()[1]:
        if decision.certificate is not None:
            text = json.dumps(decision.certificate, separators=(",", ":"), ensure_ascii=False)
            sizes[f"{decision.statement.number} part {decision.statement.part}"] = len(text.encode())
    record_property("report", f"{len(sizes)} certificates, {sum(sizes.values())} bytes")
    assert sum(sizes.values()) < 200_000
    assert max(sizes.values()) < 25_000, max(sizes, key=sizes.__getitem__)


def test_an_inverse_has_a_certificate_for_each_branch() -> None:
    judge, decisions = book()
    inverses = [decision for decision in decisions if isinstance(decision.statement, Inverse)]
    assert inverses
    for decision in inverses:
        certificate = decision.certificate
        for says, _ in problems_of_inverse(decision.statement, judge.accepted):
            others = {k: v for k, v in certificate["branches"].items() if k != says}
            with pytest.raises(Rejected, match="malformed"):
                check(decision.statement, "printed", {"branches": others}, judge.accepted)


def test_a_certificate_is_checked_in_the_form_in_which_it_was_made() -> None:
    slip = Claim("0.0", norm(e) ** 2, 2 * dot(e, e), corrected=dot(e, e))
    certificate = decided(problem_of(slip, "corrected"))
    check(slip, "corrected", certificate)
    with pytest.raises(Rejected, match="does not follow"):
        check(slip, "printed", certificate)
    resting = claim("0.1", x, norm(e) ** 2, given=(Claim("0.2", x, 2 * dot(e, e), corrected=dot(e, e)),))
    corrected = methodcaller("form", "corrected")
    certificate = decided(problem_of(resting, standing=corrected))
    check(resting, "printed", certificate, corrected)
    with pytest.raises(Rejected, match="does not follow"):
        check(resting, "printed", certificate)


CERTIFY = """
import json, sys
from chasles.algebra.rings import backend
sys.path.insert(0, sys.argv[1])
from tests import test_certificate as declared
print(backend(), json.dumps({name: declared.proved(name) for name in declared.BY_NAME}, sort_keys=True))
"""


@pytest.mark.slow
@pytest.mark.skipif(not WHOLE, reason="test_two_backends compares certificates: set CHASLES_TEST_WHOLE=1")
def test_both_kinds_of_polynomials_give_the_same_certificates() -> None:
    pytest.importorskip("flint")
    printed = {}
    for chosen in ("flint", "sympy"):
        environment = {**os.environ, "CHASLES_POLYNOMIALS": chosen}
        done = subprocess.run(
            [sys.executable, "-c", CERTIFY, str(Path(__file__).parents[1])],
            env=environment,
            capture_output=True,
            text=True,
            check=True,
        )
        used, text = done.stdout.split(" ", 1)
        assert used == chosen
        printed[used] = text
    assert printed["flint"] == printed["sympy"]
    for name, certificate in json.loads(printed["sympy"]).items():
        check(BY_NAME[name], "printed", certificate)


CHECKER = sorted((SRC / "chasles" / "checker").glob("*.py"))
MAY_IMPORT = ("chasles.vocabulary", "chasles.statements", "chasles.verdict", "chasles.checker")


def imports(source: str) -> Iterator[str]:
    for node in ast.walk(ast.parse(source)):
        match node:
            case ast.Import(names=names):
                yield from (alias.name for alias in names)
            case ast.ImportFrom(module=str(origin), names=names, level=0):
                yield from (f"{origin}.{alias.name}" for alias in names)
            case ast.ImportFrom():
                yield "relative"
            case ast.Call(func=ast.Name(id="__import__" | "import_module") | ast.Attribute(attr="import_module")):
                yield "dynamic"


def foreign(source: str) -> list[str]:
    """What is imported that is neither of the standard library nor of what the checker may know."""
    return [
        name
        for name in imports(source)
        if not any(name == known or name.startswith(f"{known}.") for known in MAY_IMPORT)
        and name.split(".")[0] not in sys.stdlib_module_names
    ]


@pytest.mark.parametrize("path", CHECKER, ids=lambda path: path.name)
def test_the_checker_knows_nothing_of_the_prover(path: Path) -> None:
    assert foreign(path.read_text("utf-8")) == []


@pytest.mark.parametrize(
    "source",
    [
        "import sympy",
        "from chasles.algebra.localization import Ratio",
        "from chasles.prover import decide",
        "import chasles.prove",
        "from . import unfold",
        "from importlib import import_module\nimport_module('flint')",
    ],
)
def test_an_import_of_the_prover_is_found(source: str) -> None:
    assert foreign(source)


def test_the_checker_loads_no_algebra_of_others() -> None:
    code = (
        "import sys, chasles.checker.certificate, chasles.checker.refutation\n"
        "print(*(name for name in sys.modules if name.split('.')[0] in ('sympy', 'flint', 'numpy', 'mpmath')))\n"
        "print(*sorted(name for name in sys.modules if name.startswith('chasles.')))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    algebra, loaded = done.stdout.split("\n")[:2]
    assert algebra == ""
    rooms = {name.split(".")[1] for name in loaded.split()}
    assert rooms <= {"display", "vocabulary", "statements", "checker"}


def test_the_checker_is_short() -> None:
    """Motions through a point, norms as angles, contradictions and determinants of any size take two fifths of it.

    The whole folder is counted, that hypotheses contradict each other too, and what has no polynomial form is handed
    on to the checker of SymPy expressions.
    """
    lines = {path.name: len(path.read_text("utf-8").splitlines()) for path in CHECKER}
    assert lines["certificate.py"] < 160
    assert max(lines.values()) < 250
    assert sum(lines.values()) < 1373
    assert len(inspect.getsource(Polynomial).splitlines()) < 60


ORDERS_OF_DIVISORS = list(permutations(range(4)))


@pytest.mark.parametrize("order", ORDERS_OF_DIVISORS)
def test_what_is_divided_by_is_read_in_any_order(order: tuple[int, ...]) -> None:
    """A divisor may be defined by a quotient whose own divisor is named after it."""
    x, y, z = (scalar(name, name, "a number") for name in "xyz")
    given = (Definition("1", y, (1 + x) / x), Definition("2", z, (2 + y) / y))
    assumed = [nonzero(each) for each in (x, y, z, 1 + z)]
    assuming = tuple(assumed[k] for k in order)
    claim = Claim("3", z * y / z + (1 + z) / (1 + z) + 2 * y / y, y + 3, given=given, assuming=assuming)
    verdict = Session().decide(claim).verdict
    assert isinstance(verdict, HoldsUnder)
    check(problem_of(claim), "printed", verdict.certificate)


def test_the_work_of_a_check_is_counted() -> None:
    long = parsed(" + ".join(f"1*x^{k}*y^{j}" for k in range(1, 11) for j in range(1, 11)), {"x": 0, "y": 1})
    with limited(10_000):
        assert len((long * long).terms) == 19**2
        with pytest.raises(Rejected, match="more products of terms"):
            long * long


@pytest.mark.parametrize("odd", [None, [], "nonsense", 5, {}], ids=str)
def test_what_is_no_certificate_is_rejected(odd: Any) -> None:
    with pytest.raises(Rejected):
        check(Claim("1", cross(e, f), -cross(f, e)), "printed", odd)
