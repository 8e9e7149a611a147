"""Identities of `prove` as theorems: what they say, that Coq accepts them, and not those that are not so."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from sympy import (
    Abs,
    Add,
    And,
    Determinant,
    Eq,
    Equivalent,
    Function,
    I,
    Identity,
    Implies,
    Integer,
    Inverse,
    Matrix,
    MatrixSymbol,
    Max,
    Min,
    Mod,
    Mul,
    Ne,
    Not,
    Or,
    Piecewise,
    Pow,
    Product,
    Rational,
    Sum,
    Trace,
    ZeroMatrix,
    acos,
    asin,
    asinh,
    atan,
    atan2,
    cos,
    cosh,
    cot,
    coth,
    exp,
    eye,
    floor,
    log,
    pi,
    sign,
    sin,
    sinh,
    sqrt,
    symbols,
    tan,
    tanh,
)  # fmt: skip

from chasles import prove
from chasles.coq.checking import MISSING, coq_version, verdicts_of_coq
from chasles.coq.folder import chunks
from chasles.coq.identities import as_theorem
from chasles.coq.sentences import Claimed

from .sampling import WHOLE
from .test_coq_statements import Tree, equations_of

x, y, t, phi = symbols("x y t phi")
p = symbols("p", positive=True)
A, B = MatrixSymbol("A", 2, 2), MatrixSymbol("B", 2, 2)
k = symbols("k", integer=True)
n = symbols("n", integer=True, positive=True)
f, g, ln = Function("f")(t), Function("g")(t), Function("ln")(t)
q = symbols("q", positive=True)
e = Matrix(symbols("e1:4"))
CROSS = Matrix([[0, -e[2], e[1]], [e[2], 0, -e[0]], [-e[1], e[0], 0]])
Q = e * e.T + cos(phi) * (eye(3) - e * e.T) + sin(phi) * CROSS
UNIT = [Eq(e.dot(e), 1)]
CIRCLE = [Eq(f**2 + g**2, 1)]
u, v = symbols("u v", real=True)
FIRST: list[tuple[Any, ...]] = [
    ((x**2 - y**2) / (x - y), x + y),
    ((1 - cos(x)) / sin(x), tan(x / 2)),
    (Q.T * Q, eye(3), UNIT),
    (f * f.diff(t) + g * g.diff(t), 0, CIRCLE),
    (sqrt(p**2 * (x - y) ** 2), p * Abs(x - y)),
    (sqrt(3 + 2 * sqrt(2)), 1 + sqrt(2)),
    (cos(pi / 4 - x), (cos(x) + sin(x)) / sqrt(2)),
    (Max(x, y) + Min(x, y), x + y),
    (sqrt(1 - cos(x) ** 2), Abs(sin(x))),
    (tanh(x / 2), (1 - exp(-x)) / (1 + exp(-x))),
    (log(1 - x**2), log(1 - x) + log(1 + x)),
    (f.diff(t), f / 2, [Eq(f, exp(t / 2))]),
    (Inverse(A * B), Inverse(B) * Inverse(A)),
    (Sum(x * k**2, (k, 1, 4)), 30 * x),
    (tan(2 * atan(x) - acos(y)), tan(2 * atan(x) + asin(y) - pi / 2)),
    (cos(atan2(p, y) - x) * sqrt(p**2 + y**2), y * cos(x) + p * sin(x)),
    (Piecewise((x - y, (x > y) & Ne(x, 0)), (0, True)), Max(x - y, 0) * sign(x) ** 2),
    (exp(I * x) ** 2, cos(2 * x) + I * sin(2 * x)),
    (sign(x**2 - 4 * x * y + 4 * y**2 + 1), 1),
    (exp(ln) * exp(ln.diff(t)), exp(ln + ln.diff(t))),
    (Abs(cos(x)), cos(x), [x > -pi / 2, x < pi / 2]),
    (sqrt((f - g) ** 2), f - g, [f > g]),
    (u * v <= (u**2 + v**2) / 2,),
    (p + 1 / p >= 2,),
    (Equivalent(Abs(u) < 1, And(u > -1, u < 1)),),
    (Implies(And(u > 0, v > 0), u * v > 0),),
    (u**3 < 1, None, [u > 0, u < 1]),
    (p, q, [Eq(p**2, q**2)]),
    (x, y, [Eq(x**3, y**3)]),
]
"""One of each class: quotients, half angles, matrices, functions of time, roots with absolute values, nested roots,
parts of pi, cases, roots of functions, hyperbolic functions, logarithms, exponentials of time, inverses, sums,
angles by their tangents and cosines, angles of points, cases by conditions, complex numbers, sums of squares,
functions that are called as a word of Coq is, ranges of angles, differences of functions, inequalities, and what joins
some, sides and sums of which the squares are told."""
MORE: list[tuple[Any, ...]] = [
    (cos(3 * x), 4 * cos(x) ** 3 - 3 * cos(x)),
    (tan(x + y), (tan(x) + tan(y)) / (1 - tan(x) * tan(y))),
    (sqrt(x) * sqrt(y), sqrt(x * y)),
    (1 / (sqrt(x) + sqrt(y)), (sqrt(x) - sqrt(y)) / (x - y)),
    (f * f.diff(t, 2) + f.diff(t) ** 2 + g * g.diff(t, 2) + g.diff(t) ** 2, 0, CIRCLE),
    (cos(x) ** 2, 1 / (1 + tan(x) ** 2)),
    (1 / sqrt(1 + x**2) - 1 / sqrt(1 + x**2) ** 3, x**2 / sqrt(1 + x**2) ** 3),
    (sin(pi / 6 + x) + sin(pi / 6 - x), cos(x)),
    (sqrt(5 + 2 * sqrt(6)), sqrt(2) + sqrt(3)),
    (Abs(x) * sign(x), x),
    (1 / sqrt(1 - x**2 / p**2), p / sqrt(p**2 - x**2)),
    (Abs(x / y), Abs(x) / Abs(y)),
    (1 / (sqrt(3) - sqrt(2)), sqrt(3) + sqrt(2)),
    (cot(x) - tan(x), 2 * cot(2 * x)),
    (sin(p * t + phi), sin(p * t) * cos(phi) + cos(p * t) * sin(phi)),
    (2**x * 3**x, 6**x),
    (exp(x) / (exp(x) + 1) + 1 / (exp(x) + 1), 1),
    (sqrt(1 + tan(x) ** 2), 1 / Abs(cos(x))),
    (p * f.diff(t, 2) + x * f, 0, [Eq(f.diff(t, 2), -x / p * f)]),
    (coth(x) ** 2 - 1, 1 / sinh(x) ** 2),
    (log(exp(x)) / log(2), x / log(2)),
    (sqrt(sqrt(2) + 2), 2 * sqrt(sqrt(2) / 4 + Rational(1, 2))),
    (-coth(x), -coth(x)),
    (p * x * sign(x), p * Abs(x)),
    (Determinant(A * B), Determinant(A) * Determinant(B)),
    (asinh(x), log(x + sqrt(x**2 + 1))),
    (sin(exp(x)) ** 2, 1 - cos(exp(x)) ** 2),
    (Abs(x + Abs(x)), x + Abs(x)),
    (cos(2), 2 * cos(1) ** 2 - 1),
    (sqrt(6 + 2 * sqrt(2) + 2 * sqrt(3) + 2 * sqrt(6)), 1 + sqrt(2) + sqrt(3)),
    ((p**3 + p**2) ** Rational(1, 3), p ** Rational(2, 3) * (p + 1) ** Rational(1, 3)),
    (sqrt((x * cos(t) - y * sin(t)) ** 2 + (x * sin(t) + y * cos(t)) ** 2), sqrt(x**2 + y**2)),
    (A**2 - Trace(A) * A + Determinant(A) * Identity(2), ZeroMatrix(2, 2)),
    (Abs(p + q - 2 * sqrt(p) * sqrt(q)), p + q - 2 * sqrt(p) * sqrt(q)),
    (sign(2 - cos(x)), 1),
    (Abs(x - 1), 1 - x, [x < 1]),
    (sqrt(1 - cos(x) ** 2), sin(x), [x > 0, x < pi]),
    (Abs(x - y) + y, x, [x > y, Eq(y, phi**2)]),
    (Abs(sqrt(x**2 + y**2) - x * cos(t) - y * sin(t)), sqrt(x**2 + y**2) - x * cos(t) - y * sin(t)),
]


SPEED = Function("w", real=True)(t)
UNDER_INEQUALITIES: list[tuple[Any, ...]] = [
    (Abs(u - 1), 1 - u, [u < 1]),
    (Abs(u), u, [u > 0]),
    (Abs(u - v), u - v, [u >= v]),
    (Abs(u * v), -u * v, [u > 0, v < 0]),
    (Abs(cos(u)), cos(u), [u > -pi / 2, u < pi / 2]),
    (sqrt(1 - cos(u) ** 2), sin(u), [u > 0, u < pi]),
    (sqrt(tan(u) ** 2 + 1), 1 / cos(u), [u > -pi / 2, u < pi / 2]),
    (Abs(SPEED), -SPEED, [SPEED < 0]),
    (Abs(SPEED - u), SPEED - u, [u < SPEED]),
    (Abs(SPEED) * SPEED.diff(t), SPEED * SPEED.diff(t), [SPEED >= 0]),
    (Max(u, v), u, [u > v]),
    (Abs(u * (1 - u)), u * (1 - u), [u > 0, u < 1]),
    (log(u * v), log(u) + log(v), [u > 0, v > 0]),
    (Abs(u - v) + v, u, [u > v, Eq(v, phi**2)]),
    ((u**2 - 1) / Abs(u - 1), u + 1, [u > 1]),
    (acos(u) + asin(u), pi / 2, [Abs(u) < 1]),
    (cos(u) ** 2 + sin(u) ** 2 + Abs(u), 1 + u, [u > 1]),
    (Abs(u + v), u + v, [u + v > 1]),
]
READ = {
    "+": Add, "-": lambda one, other: one - other, "*": Mul, "/": lambda one, other: one / other, "^": Pow,
    "neg": lambda one: -one, "Rabs": Abs, "Rmax": Max, "ln": log, "sqrt": sqrt, "cos": cos, "sin": sin, "tan": tan,
    "acos": acos, "asin": asin,
}  # fmt: skip
NAMES = {"u": u, "v": v, "w": SPEED, "w_dot": SPEED.diff(t), "PI": pi}


def read_back(tree: Tree) -> Any:
    """What the independent reader has read, as an expression."""
    if isinstance(tree, str):
        return Integer(tree) if tree.isdigit() else NAMES[tree]
    return READ[str(tree[0])](*map(read_back, tree[1:]))


def asked(number: int, *question: Any) -> Claimed:
    verdict = prove(*question)
    return as_theorem(verdict, *verdict.asked, name=f"identity_{number}")


def test_a_statement_says_what_was_asked_and_what_it_needs() -> None:
    assert asked(1, *FIRST[1]).said == (
        "Definition identity_1 : Prop :=\n"
        "  forall (x : R),\n"
        "  sin x <> 0 ->\n"
        "  cos (x / 2) <> 0 ->\n"
        "  (1 - cos x) / sin x = tan (x / 2).\n"
    )


@pytest.mark.parametrize("question", UNDER_INEQUALITIES, ids=str)
def test_under_inequalities_the_sides_are_those_of_the_question(question: tuple[Any, ...]) -> None:
    verdict = prove(*question)
    _, claimed, _ = equations_of(as_theorem(verdict, *verdict.asked).said)
    assert [tuple(map(read_back, sides[1:])) for sides in claimed] == [question[:2]]


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ([u < 1], ["u < 1"]),
        ([u > -1, u < 1], ["- 1 < u", "u < 1"]),
        ([Abs(u) < 1], ["Rabs u < 1"]),
        ([u <= -1], ["u <= - 1"]),
        ([u < v, v < 2], ["u < v", "v < 2"]),
    ],
    ids=str,
)
def test_inequalities_are_assumed_as_they_were_asked(given: list[Any], said: list[str]) -> None:
    verdict = prove(Abs(u - 2), 2 - u, given)
    text = as_theorem(verdict, *verdict.asked).said
    assert re.findall(r"^  (.*) ->$", text, re.MULTILINE) == said
    assert "d_1" not in text


@pytest.mark.parametrize(
    ("claim", "said"),
    [
        (2 * u * v <= u**2 + v**2, ["2 * u * v <= u ^ 2 + v ^ 2"]),
        (sign(u) < 2, ["sign u < 2"]),
        (Implies(And(u > 0, v > 0), u * v > 0), ["0 < u ->", "0 < v ->", "0 < u * v"]),
        (Or(Eq(u, 0), u**2 > 0), [r"(u = 0) \/ (0 < u ^ 2)"]),
        (Implies(u > v, Ne(u, v)), ["v < u ->", "u <> v"]),
        (Not(And(u > v, v > u)), [r"~ ((v < u) /\ (u < v))"]),
        (Equivalent(Eq(u**2, 1), Or(Eq(u, 1), Eq(u, -1))), [r"(u ^ 2 = 1) <-> ((u = - 1) \/ (u = 1))"]),
    ],
    ids=str,
)
def test_what_is_claimed_is_said_as_it_was_asked(claim: Any, said: list[str]) -> None:
    lines = asked(1, claim).said.removesuffix(".\n").splitlines()
    assert [line.strip() for line in lines[2:]] == said


def test_sums_are_said_term_by_term() -> None:
    assert "x + 4 * x + 9 * x + 16 * x = 30 * x" in asked(1, Sum(x * k**2, (k, 1, 4)), 30 * x).said
    assert "(x + 1) * (x + 2) = x ^ 2 + 3 * x + 2" in asked(1, Product(x + k, (k, 1, 2)), x**2 + 3 * x + 2).said


def test_functions_of_time_are_functions() -> None:
    said = asked(3, *FIRST[3]).said
    assert "(f g f_dot g_dot : R -> R)" in said
    assert "scalar_rate T f f_dot ->" in said
    assert "during T (fun t => f t ^ 2 + g t ^ 2 = 1) ->" in said


@pytest.mark.parametrize(
    ("question", "reason"),
    [
        ((floor(x + k), floor(x) + k), "floor is no word of the theories"),
        ((floor(x) + Mod(x, 1), x), "Mod is no word of the theories"),
        ((Sum(x, (x, 1, n)), n * (n + 1) / 2), "with any number of terms"),
        (((-1) ** n, cos(n * pi)), "whose base is not seen to be positive"),
        ((log(sqrt(p)), log(p) / 2), "the logarithm of what has the factor"),
        ((p ** (p**p), exp(p**p * log(p))), "an exponential in another"),
        ((atan(p) + atan(1 / p), pi / 2), "by the angle of a point"),
        ((f.diff(t) - g * g.diff(t) / f, 0, [Eq(f, sqrt(1 + g**2))]), "with the rate of f(t) = sqrt(g(t)**2 + 1)"),
    ],
)
def test_what_there_is_no_proof_of_has_a_reason(question: tuple[Any, ...], reason: str) -> None:
    claim = asked(0, *question)
    assert not claim.proof
    assert reason in claim.why_not


def test_only_what_is_decided_is_a_theorem() -> None:
    question = x, y, [Eq(x, 1), Eq(x, 2)]
    with pytest.raises(TypeError, match="contradictory"):
        as_theorem(prove(*question), *question)


FAILING: list[tuple[Any, ...]] = [
    (x**2 / y, x),
    (sin(x + y), sin(x) * cos(y) - cos(x) * sin(y)),
    (tan(x / 2), 2 * (1 - cos(x)) / sin(x)),
    (cos(p * t) * cos(q * t), (cos((p - q) * t) + cos((p + q) * t)) / 2 + 1),
    (Matrix([[u, v]]), Matrix([[u, u]])),
    (sqrt(x**2), x),
    (Abs(u + v), Abs(u) + Abs(v)),
    (Piecewise((1, u > 0), (0, Eq(u, 0)), (-1, True)), -sign(u)),
    (Max(u, v), u, [u > v - 1]),
    (u * v, 1, [Eq(u + v, 2), Eq(u - v, 1)]),
    (u, v, [Eq(u**2, v**2)]),
    (exp(x) + cosh(x), x + 1),
    (tanh(x) + acos(x), pi),
    (u < v, None, [u <= v]),
    (Implies(u > 0, u > 1),),
    (And(u > 0, u**2 > 0), None, [u > -1]),
    (u * v <= u**2 + v**2 - 1,),
]


def test_a_refutation_says_where_the_sides_are_defined() -> None:
    assert asked(1, *FAILING[0]).said == (
        "Definition identity_1 : Prop := ~ (\n  forall (x y : R),\n  y <> 0 ->\n  x ^ 2 / y = x).\n"
    )
    assert "  u - v = 1 ->\n  u * v = 1)." in asked(1, *FAILING[9]).said


@pytest.mark.parametrize(
    ("question", "reason"),
    [
        ((f.diff(t), f), "a point at which something moves"),
        ((k**2, k), "whole or rational numbers"),
        ((sqrt(p + q), sqrt(p) + sqrt(q)), "the values are not rational"),
        ((floor(x), x), "floor is no word of the theories"),
        ((p**u, u**p, [u > 0]), "the values are not rational"),
    ],
)
def test_what_there_is_no_refutation_of_has_a_reason(question: tuple[Any, ...], reason: str) -> None:
    with pytest.raises(ValueError, match=f"^there is no theorem for Coq: .*{reason}"):
        prove(*question).coq()


def test_a_verdict_writes_its_theorem() -> None:
    verdict = prove(*FIRST[1])
    claim = as_theorem(verdict, *FIRST[1])
    assert verdict.coq() == f"From Chasles Require Import Scalars.\n\n{claim.said}{claim.proof}"
    with pytest.raises(ValueError, match=r"^there is no theorem for Coq: .*floor"):
        prove(floor(x + k), floor(x) + k).coq()
    with pytest.raises(ValueError, match="chasles decide --coq"):
        replace(verdict, asked=()).coq()


@pytest.mark.skipif(coq_version() is None, reason=MISSING)
def test_coq_accepts_them_and_nothing_else(coq_cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CHASLES_CACHE", str(coq_cache))
    true = [asked(number, *question) for number, question in enumerate([*FIRST, *MORE] if WHOLE else FIRST)]
    false = []
    for claim in true[: 3 if WHOLE else 1]:
        name = claim.name.replace("identity", "mutant")
        head, end, last = claim.said.replace(claim.name, name).rpartition(" = ")
        false.append(
            replace(claim, name=name, said=f"{head}{end}1 + {last}", proof=claim.proof.replace(claim.name, name))
        )
    true += [asked(100 + number, *question) for number, question in enumerate(FAILING)]
    for claim in true[-len(FAILING) :][: None if WHOLE else 2]:  # what fails at another point only, and what holds
        name = claim.name.replace("identity", "mutant")
        said = re.sub(r"\n  ([^\n]*)\)\.\n$", r"\n  0 = 0).\n", claim.said).replace(claim.name, name)
        false.append(replace(claim, name=name, said=said, proof=claim.proof.replace(claim.name, name)))
    broken = replace(asked(99, *FIRST[0]), said="Definition identity_99 : Prop := no_such_word.\n")
    assert [claim.why_not for claim in true if claim.why_not] == []
    # Where a statement is refused, the others of its file are judged without it.
    parts = [*chunks(true), *(replace(part, number="false") for part in chunks([*false, broken, asked(98, *FIRST[0])]))]
    found = {each.claim.name: each for each in verdicts_of_coq(parts)}
    assert [
        (each.claim.says, each.why_not) for each in found.values() if not each.accepted and each.claim in true
    ] == []
    assert [name for name, each in found.items() if each.accepted and each.claim in false] == []
    assert "Coq refuses the statement: The reference no_such_word" in found["identity_99"].why_not
    assert found["identity_98"].accepted
    assert len(found) == len(true) + len(false) + 2
