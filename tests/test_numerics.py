"""Numbers: 50-digit references, inputs that satisfy hypotheses, and kernels that are right, wrong or merely lossy."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from itertools import islice
from math import factorial, inf
from operator import methodcaller
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from chasles.decisions.session import Session
from chasles.lowering.cost import roundings
from chasles.lowering.declaration import requested
from chasles.lowering.lower import program_of
from chasles.lowering.program import Argument, Op, Program, Result, Step
from chasles.numerics.draws import CONTEXT, turned, unit_of
from chasles.numerics.reference import MissingValue, Singular, evaluate
from chasles.numerics.sampling import STRATEGIES, Unsatisfiable, draw, moves
from chasles.numerics.specification import ExpectedOutput, Specification, specification_of
from chasles.numerics.specification_of_inverse import specification_of_inverse
from chasles.numerics.verify import Evidence, Finding, verify
from chasles.statements import (
    Branch,
    Claim,
    Definition,
    Inverse,
    Kernel,
    definite,
    half_turn,
    nonzero,
    orthonormal,
    perpendicular,
    positive,
    rotation,
    symmetric,
    unit,
    unit_column,
)
from chasles.statements.matrices import skew_symmetric
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    LENGTH,
    PI,
    Cofactor,
    Identity,
    Misfit,
    Node,
    abbreviation,
    at,
    column,
    cos,
    cross,
    det,
    dot,
    inverse,
    norm,
    number,
    over,
    printed,
    rate,
    row,
    scalar,
    sin,
    square,
    tr,
    vect,
    vector,
)
from chasles.vocabulary.functions import sqrt

Array = NDArray[Any]

e, phi = vector("e", "e", ""), scalar("phi", r"\phi", "")
E = abbreviation("E", "E", CPM(e), "")
a, a_, p_0 = (vector(name, name, "", LENGTH) for name in ("a", "a'", "p_0"))
omega = vector("omega", r"\omega", "", FREQUENCY)
Q, one = square("Q", "Q", ""), Identity(3)

rotation_from_axis_angle = Definition(
    "2.49",
    Q,
    e @ e.T + cos(phi) * (one - e @ e.T) + sin(phi) * E,
    assuming=(unit(e),),
    kernel=Kernel(of=(e, phi)),
)
not_the_identity = nonzero(1 - cos(phi), r"\phi \neq 0")
screw_axis_point = Claim(
    "3.18",
    p_0,
    (Q - one).T @ (Q @ a - a_) / (2 * (1 - cos(phi))),
    given=(rotation_from_axis_angle,),
    assuming=(not_the_identity,),
    kernel=Kernel(of=(e, phi, a, a_)),
)
natural_rates = column(over(sin(phi), 2 * (1 - cos(phi))) * (one - e @ e.T) - over(1, 2) * E, e.T)
natural_rate_matrix = Claim(
    "3.76b", natural_rates, natural_rates, assuming=(unit(e), not_the_identity), kernel=Kernel(of=(e, phi))
)


# Kernels as a person would write them.


def cross_matrix(v: Array) -> Array:
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]], v.dtype)


def rotated(e: Array, phi: Any) -> Array:
    versine = 2 * np.sin(phi / 2) ** 2
    return np.eye(3, dtype=e.dtype) * np.cos(phi) + versine * np.outer(e, e) + np.sin(phi) * cross_matrix(e)


def turned_the_other_way(e: Array, phi: Any) -> Array:
    return rotated(e, -phi)


def rates_as_printed(e: Array, phi: Any) -> Array:
    factor = np.sin(phi) / (2 * (1 - np.cos(phi)))
    return np.vstack((factor * (np.eye(3, dtype=e.dtype) - np.outer(e, e)) - cross_matrix(e) / 2, e))


def rates_by_the_half_angle(e: Array, phi: Any) -> Array:
    factor = np.cos(phi / 2) / (2 * np.sin(phi / 2))
    across = -cross_matrix(e) @ cross_matrix(e)
    return np.vstack((factor * across - cross_matrix(e) / 2, e))


def axis_point(e: Array, phi: Any, a: Array, a_: Array) -> Array:
    half = phi / 2
    d = a_ - a
    across = a + a_ - e * (e @ (a + a_))
    return across / 2 + np.cross(e, d) * (np.cos(half) / (2 * np.sin(half)))


def request(name: str) -> Specification:
    return specification_of(name, globals()[name])


# References.


@given(st.lists(st.integers(-5, 5), min_size=9, max_size=9), st.lists(st.integers(-5, 5), min_size=3, max_size=3))
def test_values_agree_with_sympy(entries: list[int], numbers: list[int]) -> None:
    m, v = sympy.Matrix(3, 3, entries), sympy.Matrix(3, 1, numbers)
    values = {Q: entries, e: numbers}
    cases: list[tuple[Node, Any]] = [
        (Q @ e, m * v),
        (Q.T @ Q - 2 * one, m.T * m - 2 * sympy.eye(3)),
        (det(Q), sympy.Matrix([m.det()])),
        (Cofactor(Q), m.cofactor_matrix()),
        (tr(Q) * e, m.trace() * v),
        (vect(Q), sympy.Matrix([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]]) / 2),
        (CPM(e) @ Q, sympy.Matrix([v.cross(m.col(k)).T for k in range(3)]).T),
        (cross(e, Q @ e), v.cross(m * v)),
        (dot(e, Q @ e), sympy.Matrix([v.dot(m * v)])),
        (norm(e), sympy.Matrix([sympy.sqrt(v.dot(v))])),
        (Q**3, m**3),
        (row(Q, e) @ column(e, 2), m * v + 2 * v),
        (E @ e, sympy.zeros(3, 1)),
    ]
    if m.det() != 0:
        cases.append((inverse(Q), m.inv()))
    for node, expected in cases:
        found = evaluate(node, values)
        assert [len(found), len(found[0])] == list(expected.shape)
        for one_row, row_expected in zip(found, expected.tolist(), strict=True):
            for x, y in zip(one_row, row_expected, strict=True):
                decimal = sympy.Float(sympy.sympify(y).evalf(60), 60)
                assert abs(exact(x) - exact(decimal)) <= abs(exact(x)) / 10**49


def exact(number: Any) -> Fraction:
    """An mpmath number as the fraction that it is."""
    return Fraction(*mpmath.libmp.to_rational(number._mpf_))


@pytest.mark.parametrize("angle", [1e-3, 1e-9, 1e-30, 1e-160, 5e-324])
def test_cancellation_costs_the_result_no_digits(angle: float) -> None:
    found = evaluate((1 - cos(phi)) / phi**2, {phi: angle})[0][0]
    series = sum(Fraction((-1) ** k, factorial(2 * k + 2)) * Fraction(angle) ** (2 * k) for k in range(9))
    assert abs(exact(found) / series - 1) < Fraction(1, 10**50)


def test_digits_are_counted_in_the_result() -> None:
    with mpmath.workdps(80):
        expected = 2 * mpmath.sin(mpmath.mpf(1e-20) / 2) ** 2
        assert abs(evaluate(1 - cos(phi), {phi: 1e-20})[0][0] / expected - 1) < mpmath.mpf(10) ** -50
        few = evaluate(sin(phi), {phi: 1}, digits=10)[0][0]
        assert abs(few / mpmath.sin(1) - 1) < mpmath.mpf(10) ** -10


def test_zero_is_found_to_be_zero() -> None:
    assert evaluate(sin(phi) ** 2 + cos(phi) ** 2 - 1, {phi: 0.3}) == [[0]]
    assert evaluate(norm(sin(phi) * e - e * sin(phi)), {phi: 0.3, e: [1, 2, 3]}) == [[0]]


def test_values_come_before_rules_and_rules_before_abbreviations() -> None:
    twice = {phi: 2 * PI, Q: one}
    assert evaluate(Q @ e, {e: [1, 2, 3]}, twice) == [[1], [2], [3]]
    assert evaluate(Q @ e, {e: [1, 2, 3], Q: 2 * np.eye(3)}, twice) == [[2], [4], [6]]
    assert evaluate(E @ a, {e: [0, 0, 1], a: [1, 0, 0]}) == [[0], [1], [0]]
    assert evaluate(E @ a, {E: np.eye(3), a: [1, 0, 0]}) == [[1], [0], [0]]
    assert abs(evaluate(cos(phi), {}, twice)[0][0] - 1) == 0


def test_rates_are_values() -> None:
    assert evaluate(rate(a) + rate(at(a)), {rate(a): [1, 2, 3]}) == [[2], [4], [6]]
    assert evaluate(rate(rate(a)), {rate(rate(a)): [1, 2, 3]}) == [[1], [2], [3]]
    with pytest.raises(MissingValue, match="a_dot has no value: give it among the values"):
        evaluate(rate(a), {a: [1, 2, 3]})


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (Fraction(1, 3), Fraction(1, 3)),
        (0.1, Fraction(0.1)),
        (np.float32(0.1), Fraction(float(np.float32(0.1)))),
        (np.array(0.5), 0.5),
        (np.array([[2]]), 2),
        (mpmath.mpf("0.5"), 0.5),
    ],
)
def test_numbers_are_taken_as_they_are(value: Any, expected: Any) -> None:
    found = evaluate(phi, {phi: value})[0][0]
    assert abs(exact(found) - expected) <= (Fraction(1, 10**55) if isinstance(value, Fraction) else 0)


@pytest.mark.parametrize(
    ("write", "error", "said"),
    [
        (lambda: evaluate(a, {}), MissingValue, "a has no value: give it one"),
        (lambda: evaluate(1 / phi, {phi: 0}), Singular, "phi is zero here"),
        (lambda: evaluate(1 / (1 - cos(phi) ** 2 - sin(phi) ** 2), {phi: 1}), Singular, "is zero here"),
        (lambda: evaluate(inverse(CPM(e)), {e: [1, 2, 3]}), Singular, r"CPM\(e\) has no inverse here"),
        (lambda: evaluate(e, {e: [1, 2]}), ValueError, "e is 3 x 1, and its value has 2 entries"),
        (lambda: evaluate(phi, {phi: float("nan")}), ValueError, "nan has no digits"),
        (lambda: evaluate(phi, {phi: "one"}), TypeError, "expected a number, got 'one'"),
        (lambda: evaluate(printed(lambda: a + e), {}), Misfit, "cannot add a"),
    ],
)
def test_what_has_no_value_is_named(write: Callable[[], Any], error: type[Exception], said: str) -> None:
    with pytest.raises(error, match=said):
        write()


# Inputs.


def samples(request: Specification, strategy: str, count: int = 40, dtype: type[np.floating] = np.float64) -> list[Any]:
    return list(islice(draw(request, strategy, np.random.default_rng(1), dtype), count))


def bare_request(hypotheses: tuple[Any, ...], *of: Node, angles: tuple[Node, ...] = ()) -> Specification:
    whole = specification_of("any", Claim("1", number(0), number(0), assuming=hypotheses), Kernel(of=of))
    return Specification("any", whole.inputs, whole.outputs, whole.reference, hypotheses, angles=frozenset(angles))


@pytest.mark.parametrize("strategy", list(STRATEGIES))
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_inputs_satisfy_their_hypotheses_up_to_rounding(strategy: str, dtype: type[np.floating]) -> None:
    M, mass = square("M", "M", ""), scalar("m", "m", "")
    e_1, e_2, e_3, u, v, w = (vector(name, name, "") for name in ("e_1", "e_2", "e_3", "u", "v", "w"))
    R, four = square("R", "R", ""), column(e, phi)
    hypotheses = (
        unit(e), rotation(Q), symmetric(M), positive(mass), orthonormal(e_1, e_2, e_3), half_turn(R),
        perpendicular(u, v), unit(w), perpendicular(u, w),
    )  # fmt: skip
    assert four.shape == (4, 1)
    drawn = samples(bare_request(hypotheses, e, Q, M, mass, e_1, e_2, e_3, R, u, v, w), strategy, dtype=dtype)
    unit_in_last_place = float(np.finfo(dtype).eps)
    for sample in drawn:
        x = {key: value.astype(float) for key, value in sample.arrays.items()}
        exact = {key: np.array(value, object) for key, value in sample.exact.items()}
        triad = np.stack([x[e_1], x[e_2], x[e_3]], axis=1)
        for matrix in (x[Q], triad, x[R]):
            assert np.abs(matrix.T @ matrix - np.eye(3)).max() < 4 * unit_in_last_place
            assert np.linalg.det(matrix) > 0.9
        assert abs(np.linalg.norm(x[e]) - 1) < 2 * unit_in_last_place
        assert (x[M] == x[M].T).all()
        assert (x[R] == x[R].T).all()
        assert x[mass] > 0
        assert abs(x[u] @ x[v]) <= 4 * unit_in_last_place * np.linalg.norm(x[u]) * np.linalg.norm(x[v])
        assert not x[u].any() or abs(np.linalg.norm(x[w]) - 1) < 2 * unit_in_last_place or not x[w].any()
        identity = exact[Q].T @ exact[Q] - np.eye(3, dtype=int)
        assert max(abs(entry) for entry in identity.ravel()) < mpmath.mpf(10) ** -45
        for key, value in sample.arrays.items():
            assert value.dtype == dtype
            nearest = np.array([[float(entry) for entry in line] for line in sample.exact[key]], dtype)
            assert (value.ravel() == nearest.ravel()).all()
    assert len({sample.arrays[e].tobytes() for sample in drawn}) > 3


def test_the_near_strategy_comes_near() -> None:
    b = vector("b", "b", "", LENGTH)
    drawn = samples(bare_request((), phi, a, b, angles=(phi,)), "near", 200)
    angles = np.array([sample.arrays[phi] for sample in drawn])
    for target in (0, np.pi, -np.pi, np.pi / 2, 2 * np.pi):
        assert 0 < np.abs(angles - target)[angles != target].min() < 1e-10
    assert (angles == np.pi).any()
    lengths = [np.linalg.norm(sample.arrays[a]) for sample in drawn]
    assert min(lengths) < 1e-10
    gaps = [np.linalg.norm(s.arrays[a] - s.arrays[b]) / np.linalg.norm(s.arrays[a]) for s in drawn]
    assert min(gaps) < 1e-10
    spread = samples(bare_request((), phi, a, b, angles=(phi,)), "generic", 200)
    assert min(abs(sample.arrays[phi]) for sample in spread) > 1e-6


def test_what_must_not_vanish_does_not() -> None:
    where = bare_request((not_the_identity, nonzero(norm(a - a_))), phi, a, a_, angles=(phi,))
    for strategy in STRATEGIES:
        for sample in samples(where, strategy, 60):
            assert sample.arrays[phi] != 0
            assert (sample.arrays[a] != sample.arrays[a_]).any()


def test_hypotheses_that_no_input_satisfies_are_named() -> None:
    never = bare_request((nonzero(0 * phi),), phi)
    with pytest.raises(Unsatisfiable, match=r"any: none of 200 simple inputs satisfies its hypotheses \(0 phi != 0\)"):
        next(draw(never, "simple", np.random.default_rng(0)))


def test_the_same_seed_draws_the_same_inputs() -> None:
    one_run, another = (samples(request("screw_axis_point"), "near", 10) for _ in range(2))
    assert [s.arrays[a].tobytes() for s in one_run] == [s.arrays[a].tobytes() for s in another]


def test_a_rotation_turns_about_its_axis() -> None:
    axis = unit_of([CONTEXT.mpf(k) for k in (1, -2, 2)])
    found = turned(axis, CONTEXT.mpf(1) / 3)
    expected = evaluate(rotation_from_axis_angle.right, {e: axis, phi: CONTEXT.mpf(1) / 3})
    assert max(abs(x - y) for r, s in zip(found, expected, strict=True) for x, y in zip(r, s, strict=True)) < 1e-45


def test_no_turn_and_a_half_turn_are_exact() -> None:
    axis = unit_of([CONTEXT.mpf(k) for k in (1, -2, 2)])
    assert turned(axis, 2 * CONTEXT.pi) == turned(axis, CONTEXT.mpf(0)) == np.eye(3).tolist()
    half_turned = turned(axis, CONTEXT.pi)
    assert half_turned == [list(line) for line in zip(*half_turned, strict=True)]


def test_a_float_moves_to_its_neighbours_and_a_rotation_turns() -> None:
    asked = request("screw_axis_point")
    array = np.array([1.0, 0.0, -3.0])
    pairs = list(moves(asked, a, array, array))
    assert [(below - array).tolist() for below, _ in pairs] == [[-(2**-53), 0, 0], [0, 0, -(2**-51)]]
    assert [(above - array).tolist() for _, above in pairs] == [[2**-52, 0, 0], [0, 0, 2**-51]]
    turning = specification_of_inverse("natural_invariants", natural_invariants)
    exact_value = turned(unit_of([CONTEXT.mpf(k) for k in (1, -2, 2)]), CONTEXT.mpf(1))
    turns = list(moves(turning, Q, np.array(exact_value, float), exact_value))
    assert len(turns) == 3
    for value in (value for pair in turns for value in pair):
        m = np.array(value, object)
        assert max(abs(x) for x in (m.T @ m - np.eye(3, dtype=int)).ravel()) < 1e-45
        assert 1e-16 < max(abs(x) for x in (m - np.array(exact_value, object)).ravel()) < 3e-16


# Requests.


def test_a_request_has_the_kernel_s_inputs_and_the_statement_s_value() -> None:
    found = request("screw_axis_point")
    assert [(x.name, x.shape) for x in found.inputs] == [
        ("e", (3,)), ("phi", ()), ("a", (3,)), ("a_prime", (3,)),
    ]  # fmt: skip
    assert found.outputs == (ExpectedOutput("p_0", (3,), ((0, 1, 2),)),)
    assert found.angles == {phi}
    assert found.hypotheses == (not_the_identity, unit(e))
    values = {e: [0, 0, 1], phi: PI, a: [1, 0, 5], a_: [3, 0, 5]}
    ((x,), (y,), (z,)) = found.reference({**values, phi: mpmath.pi}, 50)[0]
    assert max(abs(x - 2), abs(y), abs(z)) < 1e-14


def test_angles_are_found_behind_rules_and_abbreviations() -> None:
    Q_of = abbreviation("S", "S", CPM(sin(phi) * e), "")
    for right in (Q @ a, Q_of @ a):
        behind = Claim("1", right, right, given=(rotation_from_axis_angle,), kernel=Kernel(of=(e, phi, a)))
        assert specification_of("behind", behind).angles == {phi}
    plain_number = Claim("1", phi * a, phi * a, kernel=Kernel(of=(phi, a)))
    assert specification_of("plain", plain_number).angles == set()


def test_entries_are_compared_with_those_of_their_dimension() -> None:
    t = vector("v", "v", "", LENGTH * FREQUENCY)
    twist = Definition("1", scalar("k", "k", ""), phi, kernel=Kernel(of=(phi,)))
    found = specification_of("t", Claim("2", column(omega, t), column(omega, t), kernel=Kernel(of=(omega, t))))
    assert found.outputs[0].alike == ((0, 1, 2), (3, 4, 5))
    assert specification_of("s", twist).outputs == (ExpectedOutput("k", (), ((0,),)),)
    skew = specification_of("E", Claim("3", CPM(a), CPM(a), kernel=Kernel(of=(a,))))
    assert skew.outputs[0].alike == ((0, 4, 8), (1, 2, 3, 5, 6, 7))


def test_several_results_are_the_blocks_of_the_right_side() -> None:
    both = Kernel(of=(Q,), results=("u", "u_0"))
    right = column(vect(Q), (tr(Q) - 1) / 2)
    found = specification_of("linear", Claim("1", right, right, kernel=both))
    assert [(x.name, x.shape) for x in found.outputs] == [("u", (3,)), ("u_0", ())]
    with pytest.raises(TypeError, match=r"\(1\) has the results u, u_0: its right side must be a column of 2 blocks"):
        specification_of("linear", Claim("1", vect(Q), vect(Q), kernel=both))
    with pytest.raises(TypeError, match=r"\(1\) asks for no kernel"):
        specification_of("none", Claim("1", a, a))


def test_the_form_that_stands_is_the_reference() -> None:
    wrong = Claim("1", p_0, a, corrected=-a, kernel=Kernel(of=(a,)))
    printed_value = specification_of("p", wrong).reference({a: [1, 2, 3]}, 20)
    corrected_value = specification_of("p", wrong, accepted=methodcaller("form", "corrected")).reference(
        {a: [1, 2, 3]}, 20
    )
    assert printed_value == ([[1], [2], [3]],)
    assert corrected_value == ([[-1], [-2], [-3]],)


def test_roundings_are_counted_in_a_program() -> None:
    steps = (
        Step(Op.INPUT),
        Step(Op.SINE, (0,)),
        Step(Op.MULTIPLY, (1, 1)),
        Step(Op.NEGATE, (2,)),
        Step(Op.ADD, (3, 0)),
        Step(Op.COSINE, (0,)),
    )
    arguments, results = (Argument("angle", (), ""),), (Result("value", (), "", (4,)),)
    program = Program("f", arguments, steps, results)
    assert roundings(program) == 4
    assert roundings(Program("f", arguments, steps, (Result("value", (), "", (5,)),))) == 2
    value = phi - sin(phi) ** 2
    found = specification_of("f", Claim("1", value, value, kernel=Kernel(of=(phi,))), results=["value"], roundings=4)
    assert (found.inputs[0].name, found.outputs[0].name, found.roundings) == ("phi", "value", 4)


# Kernels compared.


@pytest.mark.sampled(3)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize(
    ("name", "function"),
    [
        ("rotation_from_axis_angle", rotated),
        ("natural_rate_matrix", rates_by_the_half_angle),
        ("screw_axis_point", axis_point),
    ],
)
def test_a_right_kernel_passes(name: str, function: Callable[..., Array], dtype: type[np.floating]) -> None:
    evidence = verify(request(name), function, dtype=dtype, samples=60)
    assert evidence.passed, evidence.failures
    assert evidence.samples == 180
    assert evidence.skipped <= 20
    assert [finding.strategy for finding in evidence.worst] == list(STRATEGIES)
    assert min(finding.error for finding in evidence.worst) > 0


@pytest.mark.sampled(2)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_a_wrong_kernel_is_caught_everywhere(dtype: type[np.floating]) -> None:
    evidence = verify(request("rotation_from_axis_angle"), turned_the_other_way, dtype=dtype, samples=40)
    assert not evidence.passed
    assert evidence.failed >= 60
    worst = evidence.failures[0]
    assert worst.error > 1e6 > 200 > worst.allowed
    assert worst.error == evidence.error
    x = {key: np.array(value, dtype) for key, value in worst.at.items()}
    right, wrong = rotated(x["e"], x["phi"][()]), turned_the_other_way(x["e"], x["phi"][()])
    assert np.abs(right - wrong).max() > 1e-3


@pytest.mark.sampled(2)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_a_kernel_that_loses_digits_near_a_singular_set_is_caught_there(dtype: type[np.floating]) -> None:
    evidence = verify(request("natural_rate_matrix"), rates_as_printed, dtype=dtype, samples=60)
    assert not evidence.passed
    errors = {finding.strategy: finding.error for finding in evidence.worst}
    assert errors["near"] == np.inf or errors["near"] > 1e6
    assert errors["simple"] < 16
    assert evidence.failures[0].strategy == "near"


@pytest.mark.parametrize("flaw", [1e-15, 1e-14, 1e-12])
def test_a_small_flaw_is_caught_once_it_is_larger_than_the_roundings(flaw: float) -> None:
    evidence = verify(
        request("rotation_from_axis_angle"),
        lambda e, phi: rotated(e, phi) * (1 + flaw),
        samples=30,
        strategies=("generic",),
    )
    assert evidence.passed == (flaw == 1e-15)
    assert abs(evidence.error - flaw * 2**53) < 8 if flaw == 1e-15 else evidence.error > 40


def test_a_wrong_entry_among_large_ones_of_another_dimension_is_caught() -> None:
    both = column(omega, 10**9 * a)
    asked = specification_of("both", Claim("1", both, both, kernel=Kernel(of=(omega, a))))
    wrong = verify(asked, lambda w, a: np.concatenate((w + 1e-9, 1e9 * a)), samples=10)
    right = verify(asked, lambda w, a: np.concatenate((w, 1e9 * a)), samples=10)
    assert not wrong.passed
    assert right.passed


def test_zeros_by_construction_are_zero() -> None:
    asked = specification_of("E", Claim("1", CPM(a), CPM(a), kernel=Kernel(of=(a,))))
    assert verify(asked, cross_matrix, samples=10).error == 0
    assert not verify(asked, lambda a: cross_matrix(a) + 1e-300 * np.eye(3), samples=10).passed


def test_what_the_inputs_leave_open_is_allowed() -> None:
    gap = Claim("1", norm(a - a_), norm(a - a_), kernel=Kernel(of=(a, a_)))
    exact = verify(specification_of("gap", gap), lambda a, b: np.sqrt(np.sum((a - b) ** 2)), samples=60)
    assert exact.passed
    assert exact.error < 16
    rounded = verify(specification_of("gap", gap), lambda a, b: np.linalg.norm(a * 3 - b * 3) / 3, samples=60)
    assert rounded.passed
    assert rounded.error > 1000
    assert not verify(specification_of("gap", gap), lambda a, b: np.linalg.norm(a - b) * (1 + 1e-9), samples=60).passed


def test_infinities_and_nan_are_never_right() -> None:
    for nothing in (np.nan, np.inf, -np.inf):
        found = verify(request("rotation_from_axis_angle"), lambda e, phi, x=nothing: rotated(e, phi) * x, samples=5)
        assert found.failed == 15
        assert found.error == np.inf


def test_what_has_no_value_is_not_drawn_and_what_has_no_float_is_skipped() -> None:
    quotient = 1 / phi
    asked = specification_of("q", Claim("1", quotient, quotient, kernel=Kernel(of=(phi,))))
    evidence = verify(asked, lambda x: 1 / x, samples=40, strategies=("simple",))
    assert evidence.passed
    assert evidence.skipped == 0
    large = specification_of("q", Claim("1", 10**320 * quotient, 10**320 * quotient, kernel=Kernel(of=(phi,))))
    assert verify(large, lambda x: np.float64(np.inf), samples=10).skipped == 30


def test_what_is_given_brings_what_it_is_given() -> None:
    """A kernel and its value use the definitions behind those given; where a divisor is not real, there is no input."""
    side, tangent, slope, height = (scalar(name, name, "") for name in ("s", "t", "q", "h"))
    first = Definition("1", side, sqrt(1 - phi**2))
    second = Definition("2", tangent, phi / side, given=(first,))
    third = Definition("3", slope, 2 * tangent, given=(second,))
    claim = Claim("4", height, slope + 1, given=(Definition("5", height, 1 + slope, given=(third,)),))
    kernel = Kernel(of=(phi,), name="height")
    asked = specification_of("height", replace(claim, kernel=kernel))
    assert verify(asked, lambda x: 1 + 2 * x / np.sqrt(1 - x * x), samples=40, strategies=("simple",)).passed
    program = program_of(requested(replace(claim, kernel=kernel), Session().decide))
    assert [argument.name for argument in program.arguments] == ["phi"]


def test_batches_are_compared_like_single_calls() -> None:
    def batched(e: Array, phi: Array) -> Array:
        assert e.shape == (20, 3)
        assert phi.shape == (20,)
        return np.stack([rotated(*pair) for pair in zip(e, phi, strict=True)])

    asked = request("rotation_from_axis_angle")
    assert verify(asked, batched, samples=20, batched=True) == verify(asked, rotated, samples=20)


@pytest.mark.parametrize(
    ("function", "said"),
    [
        (lambda e, phi: rotated(e, phi)[0], r"returned Q as float64 of shape \(3,\): float64 of shape \(3, 3\)"),
        (lambda e, phi: rotated(e, phi).astype(np.float32), "returned Q as float32"),
        (lambda e, phi: (rotated(e, phi), phi), "returned 2 results, and 1 are expected"),
    ],
)
def test_results_of_another_shape_or_type_are_named(function: Callable[..., Any], said: str) -> None:
    with pytest.raises(TypeError, match=rf"rotation_from_axis_angle {said}"):
        verify(request("rotation_from_axis_angle"), function, samples=1)


def test_evidence_is_plain_data_and_the_same_each_time() -> None:
    both = [("rotation_from_axis_angle", turned_the_other_way), ("natural_rate_matrix", rates_as_printed)]
    runs = [
        [json.dumps(found.as_json(), allow_nan=False) for found in (verify(request(n), f, samples=8) for n, f in both)]
        for _ in range(2)
    ]
    assert runs[0] == runs[1]
    data = json.loads(runs[0][0])
    assert (data["kernel"], data["dtype"], data["samples"], data["passed"]) == (both[0][0], "float64", 24, False)
    assert len(data["failures"]) == 3
    assert set(data["failures"][0]["at"]) == {"e", "phi"}
    assert Evidence("k", "float64", 0, 0, (), (), 0).error == 0


@pytest.mark.parametrize(
    ("error", "allowed", "share"),
    [(0, 0, 0), (1, 0, inf), (3, 4, 0.75), (8, 4, 2), (inf, 4, inf), (0, 4, 0)],
)
def test_an_error_is_a_share_of_what_is_allowed(error: float, allowed: float, share: float) -> None:
    found = Finding("generic", "x", error, allowed, {})
    assert found.share == share
    assert found.failed == (share > 1)


def test_the_share_is_over_all_findings_not_that_of_the_largest_error() -> None:
    found = verify(request("rotation_from_axis_angle"), rotated, samples=50)
    assert 0 < found.share <= 1
    assert found.share >= max(worst.share for worst in found.worst)
    wrong = verify(request("rotation_from_axis_angle"), turned_the_other_way, samples=5)
    assert wrong.share > 1


# Inverses.

sine = norm(vect(Q))
along = [(Q + one) @ column(*(int(k == n) for k in range(3))) for n in range(3)]
natural_invariants = Inverse(
    "3.75",
    of=rotation_from_axis_angle,
    branches=(
        Branch("in general", sine, ((e, vect(Q) / sine), (cos(phi), (tr(Q) - 1) / 2), (sin(phi), sine))),
        *(
            Branch(
                f"a half-turn by column {n}",
                norm(v),
                ((e, v / norm(v)), (cos(phi), number(-1)), (sin(phi), number(0))),
                assuming=(half_turn(Q),),
            )
            for n, v in enumerate(along)
        ),
    ),
    gives=(e, phi),
    assuming=(rotation(Q),),
    kernel=Kernel(of=(Q,), results=("e", "phi")),
)


def axis_and_angle(Q: Array) -> tuple[Array, Any]:
    """By the largest of four times the squares of the Euler-Rodrigues parameters."""
    doubled = np.array([Q[2, 1] - Q[1, 2], Q[0, 2] - Q[2, 0], Q[1, 0] - Q[0, 1]])
    squares = np.array([*(1 + 2 * np.diag(Q) - np.trace(Q)), 1 + np.trace(Q)])
    k = int(np.argmax(squares))
    if k == 3:
        r = np.array([*doubled, squares[3]])
    else:
        r = np.array([*(Q[k] + Q[:, k]), doubled[k]])
        r[k] = squares[k]
    r = r / np.linalg.norm(r)
    first = r[np.flatnonzero(r)[0]]
    r = -r if r[3] < 0 or (r[3] == 0 and first < 0) else r
    size = np.linalg.norm(r[:3])
    return (r[:3] / size).astype(Q.dtype), Q.dtype.type(2 * np.arctan2(size, r[3]))


def axis_from_the_skew_part(Q: Array) -> tuple[Array, Any]:
    u = np.array([Q[2, 1] - Q[1, 2], Q[0, 2] - Q[2, 0], Q[1, 0] - Q[0, 1]]) / 2
    size = np.linalg.norm(u)
    return (u / size).astype(Q.dtype), Q.dtype.type(np.arctan2(size, (np.trace(Q) - 1) / 2))


def test_an_inverse_takes_the_first_branch_that_applies() -> None:
    asked = specification_of_inverse("natural_invariants", natural_invariants)
    assert [(x.name, x.shape) for x in asked.outputs] == [("e", (3,)), ("phi", ())]
    axis = unit_of([CONTEXT.mpf(k) for k in (2, -1, 2)])
    direction, ((angle,),) = asked.reference({Q: turned(axis, CONTEXT.mpf(3))}, 50)
    assert abs(angle - 3) < 1e-45
    assert max(abs(x - y) for (x,), y in zip(direction, axis, strict=True)) < 1e-45
    half = asked.reference({Q: np.diag([-1.0, 1.0, -1.0])}, 50)
    assert half[0] == [[0], [1], [0]]
    assert abs(half[1][0][0] - mpmath.pi) < 1e-14
    with pytest.raises(Singular, match=r"no branch of \(3\.75\) applies here"):
        asked.reference({Q: np.eye(3)}, 50)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_an_inverse_kernel_is_compared_at_the_point_of_which_its_input_is_the_rounding(
    dtype: type[np.floating],
) -> None:
    asked = specification_of_inverse("natural_invariants", natural_invariants)
    good = verify(asked, axis_and_angle, dtype=dtype, samples=60)
    assert good.passed, good.failures
    assert good.error < 16
    assert 0 < good.skipped < 60
    lossy = verify(asked, axis_from_the_skew_part, dtype=dtype, samples=60)
    assert not lossy.passed
    assert {finding.output for finding in lossy.failures} == {"e"}
    assert lossy.failures[0].error > 100 > lossy.failures[0].allowed


def test_inputs_of_unit_columns_and_definite_and_skew_matrices_satisfy_them() -> None:
    """Once "cannot be drawn yet", and no kernel of the chapter was compared."""
    M, S, u, s = square("M", "M", ""), square("S", "S", ""), vector("u", "u", ""), scalar("s", "s", "")
    hypotheses = (unit_column(u, s), definite(M), skew_symmetric(S))
    for sample in samples(bare_request(hypotheses, u, s, M, S), "generic", 5):
        x, y, m, n = (sample.arrays[node] for node in (u, s, M, S))
        assert np.isclose(x @ x + y * y, 1)
        assert np.allclose(m, m.T)
        assert np.all(np.linalg.eigvalsh(m) > 0)
        assert np.allclose(n, -n.T)
