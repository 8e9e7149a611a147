"""A counterexample says all that a reader needs to evaluate both sides by hand: vectors with norms, angles in pi."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest

from chasles.algebra.values import InPi
from chasles.checker.refutation import check_counterexample
from chasles.prover.decide import decide_problem
from chasles.report.words import point_in_words
from chasles.statements import Claim, problem_of, unit
from chasles.verdict import Counterexample, Fails, Holds
from chasles.vocabulary import CPM, PI, Node, array, column, cos, norm, rate, scalar, sin, uniform, vector

a, b, e = (vector(name, name, "") for name in "abe")
phi, theta, x = scalar("phi", r"\phi", ""), scalar("theta", r"\theta", ""), scalar("x", "x", "")


def refuted(left: Node, right: Node, **rest: object) -> Counterexample:
    problem = problem_of(Claim("1", left, right, **rest))  # type: ignore[arg-type]
    verdict = decide_problem(problem)
    assert isinstance(verdict, Fails)
    check_counterexample(problem, verdict.counterexample)
    return verdict.counterexample


@pytest.mark.parametrize("right", [2 * norm(b), norm(a) + norm(b), norm(b)])
def test_a_norm_comes_with_its_vector(right: Node) -> None:
    at = refuted(norm(a + b), right).at
    assert {"a_1", "a_2", "a_3", "b_1", "b_2", "b_3"} <= at.keys()
    total = sum((at[f"a_{k}"] + at[f"b_{k}"]) ** 2 for k in (1, 2, 3))
    assert at["|a + b|"] ** 2 == total


def test_a_rate_comes_with_what_it_is_of() -> None:
    at = refuted(rate(e), CPM(rate(a)) @ e, assuming=(unit(e),)).at
    assert sum(at[f"e_{k}"] * at[f"e_dot_{k}"] for k in (1, 2, 3)) == 0


@pytest.mark.parametrize(
    ("left", "right", "angles"),
    [(phi * cos(phi), PI, ["phi"]), (phi * cos(theta), theta * sin(phi), ["phi", "theta"])],
)
def test_an_angle_measured_by_pi_is_said(left: Node, right: Node, angles: list[str]) -> None:
    found = refuted(left, right)
    for name in angles:
        assert isinstance(found.at[name], InPi)
        assert f"{name} = {InPi(found.at[name])}" in point_in_words(found.at)


turned = column(phi * cos(phi), theta * cos(theta))


@pytest.mark.parametrize(
    ("left", "right", "unit"),
    [
        (turned, 2 * turned, "pi"),
        (column(phi * cos(phi), PI * 1), column(2 * phi * cos(phi), PI * 1), "pi"),
        (column(phi * cos(phi), x * PI), column(phi * cos(phi), 2 * x * PI), "pi"),
        (phi * cos(phi + PI / 2), phi * cos(phi), "phi"),
        (phi * cos(phi), phi * 1, "phi"),
        (theta * cos(theta), theta * 1, "theta"),
    ],
)
def test_what_the_sides_are_multiples_of_fits_the_point(left: Node, right: Node, unit: str) -> None:
    found = refuted(left, right)
    assert unit in re.findall("[a-z]+", f"{found.left} {found.right}")
    assert all(isinstance(found.at[name], InPi) and unit == "pi" for name in ("phi", "theta") if name in found.at)


def test_a_person_reads_angles_as_multiples_of_pi() -> None:
    half = {"cos(phi)": Fraction(0), "sin(phi)": Fraction(-1), "x": Fraction(2)}
    assert point_in_words({**half, "phi": InPi(-1, 2)}) == "cos(phi) = 0, phi = -1/2 pi, sin(phi) = -1, x = 2"
    assert point_in_words({"cos(phi/2)": Fraction(-1), "phi": InPi(1), "pi": InPi(1)}) == "cos(phi/2) = -1, phi = pi"
    assert point_in_words({**half, "phi": Fraction(1)}) == "cos(phi) = 0, sin(phi) = -1, x = 2"
    assert point_in_words({"phi": Fraction(1), "x": Fraction(2)}) == "phi = 1, x = 2"


def test_a_witness_is_shown_in_multiples_of_pi_too() -> None:
    verdict = decide_problem(problem_of(Claim("1", phi * cos(phi) * PI, PI * cos(phi) * phi)))
    assert isinstance(verdict, Holds)
    assert isinstance(verdict.witness["phi"], InPi)
    assert f"phi = {InPi(verdict.witness['phi'])}" in point_in_words(verdict.witness)


def test_a_multiple_of_pi_is_spelled_as_the_sides_are() -> None:
    spelled = [str(InPi(Fraction(*parts))) for parts in ((0, 1), (1, 1), (-1, 1), (1, 2), (-3, 2), (2, 1))]
    assert spelled == ["0", "pi", "-pi", "1/2 pi", "-3/2 pi", "2 pi"]
    assert InPi(Fraction(1, 2)) + 1 == Fraction(3, 2)


def test_entries_of_large_matrices_are_told_apart() -> None:
    M = array("M", "M", "", uniform((12, 12)))
    assert isinstance(decide_problem(problem_of(Claim("1", (M @ M).T, M.T @ M.T))), Holds)
    assert {"M_1,11", "M_11,1"} <= refuted(M[1, 11], M[11, 1]).at.keys()
    assert f"v = ({', '.join('0' * 11)}, 1)" in point_in_words({f"v_{k}": int(k == 12) for k in range(1, 13)})


@pytest.mark.parametrize("entries", ["m_1 m_2", "M_11 M_12 M_21", "M_11 M_12 M_21 M_22", "q_1 q_2 q_4"])
def test_what_is_no_vector_and_no_large_matrix_is_said_by_itself(entries: str) -> None:
    assert point_in_words(dict.fromkeys(entries.split(), 1)) == ", ".join(f"{each} = 1" for each in entries.split())
