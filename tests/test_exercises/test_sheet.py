"""The sheet evaluates the book's declarations, refuses what they do not allow, and never confirms what is not so."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp
from chasles.derivations.notation import I_C, Q, a, a_, d_A, e, p, phi
from chasles.derivations.s02_screw import (
    displacement_of_a_point,
    displacement_of_landmark,
    rotation_from_axis_angle,
    screw_axis_point,
)
from chasles.derivations.s04_twist import natural_invariants
from click.testing import CliRunner
from sympy.polys.polyerrors import PolynomialError

from chasles.cli import main
from chasles.decisions.session import Session
from chasles.exact.evaluate import DividesByZero, NoValue, column_of, evaluate, matrix_of
from chasles.exact.linear import kernel_of, rank_of, solve_linear
from chasles.exact.spelling import text_of
from chasles.exercises.data import DataError
from chasles.exercises.solving import solve_with
from chasles.exercises.worksheet import HypothesisFails, Refuted, Worksheet, equal
from chasles.report.html.exercises import worked_view
from chasles.report.worked_page import in_lines
from chasles.statements import Claim, Condition, load, rotation
from chasles.statements.exercises import exercise_numbers
from chasles.verdict import Undecided
from chasles.vocabulary import CPM, cos, cross, det, dot, inverse, norm, number, over, rate, row, sin, tr, vect
from chasles.vocabulary.functions import arccos, arcsin, arctan, atan2, cases, exp, maximum, minimum, sign, sqrt

from .known import same

HALF = sp.Rational(1, 2)
TURN = matrix_of([[0, 0, 1], [1, 0, 0], [0, 1, 0]])


@pytest.mark.parametrize(
    ("node", "expected"),
    [
        (a + a_ - a, [4, 5, 6]),
        (2 * a, [2, 4, 6]),
        (a / norm(a), [1 / sp.sqrt(14), 2 / sp.sqrt(14), 3 / sp.sqrt(14)]),
        (cross(a, a_), [-3, 6, -3]),
        (CPM(a) @ a_, [-3, 6, -3]),
        (dot(a, a_), [32]),
        (Q @ a, [3, 1, 2]),
        (Q.T @ a, [2, 3, 1]),
        (inverse(Q) @ a, [2, 3, 1]),
        (Q**2 @ a, [2, 3, 1]),
        (tr(Q), [0]),
        (det(Q), [1]),
        (vect(Q), [HALF, HALF, HALF]),
        (row(a, a_) @ row(a, a_).T, [17, 22, 27, 22, 29, 36, 27, 36, 45]),
        (norm(a) ** 2, [14]),
        (cos(phi) + sin(over(phi, 2)), [HALF + HALF]),
        (sqrt(3 - cos(phi)), [sp.sqrt(10) / 2]),
        (abs(a.x - a_.x), [3]),
        (sign(a.x - a_.x), [-1]),
        (maximum(a.x, a.z, a.y) - minimum(a_.y, a_.x), [-1]),
        (arccos(-cos(phi)), [2 * sp.pi / 3]),
        (arcsin(-cos(phi)), [-sp.pi / 6]),
        (arctan(-a.x / a.x), [-sp.pi / 4]),
        (atan2(0 * a.x, -a.x), [sp.pi]),
        (cases((a, a.x > a.y), (2 * a, a.x <= a.y), otherwise=3 * a), [2, 4, 6]),
    ],
)
def test_every_word_has_its_value(node: object, expected: list) -> None:
    values = {a: column_of(1, 2, 3), a_: column_of(4, 5, 6), Q: TURN, phi: sp.pi / 3}
    assert same(evaluate(node, values), sp.Matrix(expected))


def test_what_has_no_value_is_named() -> None:
    with pytest.raises(NoValue, match="a has no value here"):
        evaluate(a, {})
    with pytest.raises(NoValue, match="a_dot has no value here"):
        evaluate(rate(a), {a: column_of(1, 2, 3)})
    with pytest.raises(DividesByZero, match=r"\|a\| is zero here"):
        evaluate(a / norm(a), {a: column_of(0, 0, 0)})
    with pytest.raises(DividesByZero, match="nothing can be divided"):
        evaluate(inverse(I_C), {I_C: sp.zeros(3, 3)})
    with pytest.raises(ValueError, match="a is 3 x 1, and its value is 2 x 1"):
        evaluate(a, {a: column_of(1, 2)})
    with pytest.raises(ValueError, match="square root of -1, which is negative"):
        evaluate(sqrt(-phi), {phi: sp.Integer(1)})
    with pytest.raises(ValueError, match=r"atan2\(0, 0\) is no angle"):
        evaluate(atan2(phi, phi), {phi: sp.Integer(0)})
    with pytest.raises(TypeError, match=r"exp.* has no exact value here"):
        evaluate(exp(phi), {phi: sp.Integer(1)})


def test_a_step_binds_the_left_side_and_cites_the_number() -> None:
    sheet = Worksheet({})
    sheet.given({a: column_of(1, 2, 3), a_: column_of(1, 1, 1)})
    assert same(sheet.compute(displacement_of_landmark), sp.Matrix([0, -1, -2]))
    assert same(sheet.value(d_A), sp.Matrix([0, -1, -2]))
    assert sheet.steps[-1].cites[0].shown == "(3.3)"
    assert sheet.steps[-1].lines[0].text == "d_A = a' - a = (0, -1, -2)"


def test_a_hypothesis_that_does_not_hold_is_refused() -> None:
    sheet = Worksheet({})
    identity = matrix_of(sp.eye(3))
    sheet.given({Q: identity, a: column_of(1, 0, 0), a_: column_of(1, 0, 0), phi: sp.Integer(0)})
    with pytest.raises(HypothesisFails, match="phi != 0 does not hold"):
        sheet.compute(screw_axis_point)
    sheet.given({e: column_of(1, 1, 0)})
    with pytest.raises(HypothesisFails, match=r"\|e\| = 1 does not hold"):
        sheet.compute(rotation_from_axis_angle)
    assert sheet.satisfied(rotation(Q))
    sheet.given({Q: -identity})
    assert not sheet.satisfied(rotation(Q))


def test_a_check_that_fails_is_a_defect() -> None:
    sheet = Worksheet({})
    sheet.given({a: column_of(1, 2, 3), a_: column_of(1, 1, 1), d_A: column_of(0, -1, -3)})
    with pytest.raises(Refuted, match=r"so it is: \(0, -1, -3\) is not \(0, -1, -2\)"):
        sheet.check(displacement_of_landmark, "so it is")
    assert not sheet.holds(displacement_of_landmark)


def test_a_false_claim_cannot_be_used() -> None:
    sheet = Worksheet({})
    wrong = Claim("9.1", dot(a, a), number(0), says="A vector has no length.")
    sheet.given({a: column_of(0, 0, 0)})
    with pytest.raises(TypeError, match="is not proved"):
        sheet.holds(wrong)
    sheet.refute(wrong, "It has.")
    assert "not so at a_" in sheet.steps[-1].lines[1].text
    with pytest.raises(Refuted, match="does not fail: holds"):
        sheet.refute(Claim("9.2", dot(a, a_), dot(a_, a), says="Dots commute."), "They do not.")


def test_a_corrected_form_stands_in_for_a_print_that_fails() -> None:
    sheet = Worksheet({})
    slip = Claim("9.3", cross(a, a_), cross(a_, a), says="Crosses commute.", corrected=-cross(a_, a))
    sheet.given({a: column_of(1, 0, 0), a_: column_of(0, 1, 0)})
    assert sheet.holds(slip)
    assert sheet.steps[-1].cites[0].form == "repair"


def test_linear_conditions_are_solved_for_all_solutions() -> None:
    sheet = Worksheet({})
    sheet.given({a: column_of(0, 0, 2), a_: column_of(0, 1, 0)})
    on_axis = Condition("9.4", cross(a, p), norm(a) * a_, says="P is somewhere.", on=(p,))
    found = sheet.solve(on_axis, p)
    assert (found.exist, found.unique, len(found.directions)) == (True, False, 1)
    assert same(found.one, sp.Matrix([1, 0, 0]))
    sheet.given({a_: column_of(0, 0, 1)})
    assert not sheet.solve(on_axis, p).exist


def test_ranks_are_exact() -> None:
    tiny = sp.Rational(1, 10**40)
    root = sp.sqrt(2)
    assert rank_of(sp.Matrix([[1, root], [root, 2]])) == 1
    assert rank_of(sp.Matrix([[1, root], [root, 2 + tiny]])) == 2
    assert len(kernel_of(sp.Matrix([[1, root], [root, 2]]))) == 1
    assert not solve_linear(sp.Matrix([[1, root], [root, 2]]), sp.Matrix([1, 1])).exist


@pytest.mark.parametrize("axis", [(1, -1, 0), (0, 1, -2), (3, -4, 12), (0, 0, 1)])
def test_an_inverse_makes_the_first_entry_positive(axis: tuple) -> None:
    """Also where the branch that applies would give the opposite."""
    u = sp.Matrix(axis) / sp.sqrt(sum(x * x for x in axis))
    turned = replace(natural_invariants, branches=(natural_invariants.branches[0], *natural_invariants.branches[:0:-1]))
    for inverted in (natural_invariants, turned):
        sheet = Worksheet({})
        sheet.given({Q: matrix_of(2 * u * u.T - sp.eye(3))})
        assert sheet.invert(inverted)
        assert same(sheet.value(e), u)


def test_a_displacement_of_any_point() -> None:
    """The chapter's claims hold of free symbols too."""
    sheet = Worksheet({})
    x = sp.Matrix(sp.symbols("x y z", real=True))
    sheet.given({Q: TURN, a: column_of(1, 0, 0), a_: column_of(0, 0, 1), p: matrix_of(x)})
    sheet.compute(displacement_of_landmark)
    expected = sp.Matrix([0, 0, 1]) + TURN * (x - sp.Matrix([1, 0, 0])) - x
    assert same(sheet.compute(displacement_of_a_point), expected)


def test_sines_in_the_data_are_solved_with() -> None:
    answers = solve_with("3.21", {"omega": ["sin(1)", 1, 0]}).answers
    assert equal(answers["norm_O2"] ** 2, 2 * (1 + sp.sin(1) ** 2) ** 2)


def test_polynomials_that_are_not_known_are_refused_in_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object) -> None:
        raise PolynomialError("no generators")

    monkeypatch.setattr("chasles.exercises.solving.read_data", fail)
    with pytest.raises(DataError, match="give numbers that square roots express"):
        solve_with("3.5", {})


@pytest.fixture
def undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing can be decided."""
    monkeypatch.setattr("chasles.decisions.session.decided", lambda *_: Undecided("it is beyond the prover"))
    monkeypatch.setattr("chasles.decisions.session.repair", lambda *_, **__: ())
    judge = Session(book=load())
    monkeypatch.setattr("chasles.exercises.decided._session", lambda: judge)


@pytest.mark.usefixtures("undecided")
@pytest.mark.sampled(4)
@pytest.mark.parametrize("number", exercise_numbers())
def test_what_rests_on_an_undecided_statement_is_said_to(number: str) -> None:
    done = CliRunner().invoke(main, ["solve", number])
    assert done.exit_code == 1
    (line,) = done.stderr.splitlines()
    assert line.startswith(f"chasles: exercise {number} is not solved: ")
    assert "undecided" in line or "the derivation stops" in line
    assert done.stdout == ""
    view = worked_view(load(), number)
    assert (view.outcome, view.steps, view.unsolved) == ("unsolved", (), line.partition(" is not solved: ")[2])


def test_long_formulas_are_shown_in_lines() -> None:
    row = ", ".join(["sqrt(1234567)/7654321"] * 3)
    root = "sqrt(2 - sqrt(3))*12345678901234567890123"
    assert in_lines(f"I = [{row}; 0, 0, 0]") == f"I = [{row}; 0, 0, 0]"
    assert in_lines(f"I = [{row}; {row}]") == f"I = [{row};\n     {row}]"
    assert in_lines(f"int_B(rho (|r|^2 1 - r r^T)) = [{row}, 1]") == f"int_B(rho (|r|^2 1 - r r^T))\n= [{row}, 1]"
    assert in_lines(f"k = ({root}, f(x, y), {root}, 1)") == f"k = ({root},\n     f(x, y),\n     {root},\n     1)"


def test_a_root_is_written_with_short_numbers() -> None:
    assert all(len(text_of(entry)) < 120 for entry in solve_with("3.12", {}).answers["rest.axes"])
