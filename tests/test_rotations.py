"""The chapter `chasles.rotations`: decided whole, as on record, and by numbers that share nothing with the prover.

`pytest tests/test_rotations.py --update-golden` records the verdicts anew.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import expm
from scipy.spatial.transform import Rotation

from chasles.cli.rechecking import recheck
from chasles.decisions.memory import Memory
from chasles.decisions.session import Session
from chasles.numerics.reference import evaluate
from chasles.numerics.sampling import draw
from chasles.numerics.specification import specification_of
from chasles.statements import (
    Claim,
    Entry,
    Inverse,
    Kernel,
    Section,
    load,
    nonzero,
    perpendicular,
    rotation,
    unit,
    unit_column,
)
from chasles.targets.commission import kernel_of
from chasles.verdict import Defined, Holds, HoldsUnder
from chasles.vocabulary import (
    Identity,
    Misfit,
    Node,
    array,
    column,
    dot,
    norm,
    number,
    paren,
    rate,
    square,
    symbols_of,
    uniform,
    vector,
)
from chasles.vocabulary.expansions import UpTo
from chasles.vocabulary.motion_vectors import (
    exp_of_motion_vector,
    left_jacobian_of_motion,
    right_jacobian_of_motion,
)
from chasles.vocabulary.motions import adjoint_of_motion, adjoint_of_twist, inverse_motion, twist_matrix
from chasles.vocabulary.products import direct_sum, kronecker_product, outer
from chasles.vocabulary.quaternions import (
    product_from_left,
    product_from_right,
    quaternion_conjugate,
    quaternion_product,
    rotation_of_quaternion,
)
from chasles.vocabulary.rotation_vectors import cayley, exp_of_vector, left_jacobian, right_jacobian

from .sampling import WHOLE
from .second_opinion.opinion import opinion_on
from .test_verdicts import differences, line

GOLDEN = Path(__file__).parent / "golden" / "rotations.toml"
HEAD = "# The verdict on every statement; `pytest tests/test_rotations.py --update-golden` writes this file.\n\n"
CHAPTER = load("chasles.rotations")
SECTIONS = [section.number for section in CHAPTER.sections]
Array = NDArray[np.float64]


@cache
def session() -> Session:
    return Session(book=CHAPTER)


def test_the_verdicts_are_those_on_record(pytestconfig: pytest.Config) -> None:
    found = HEAD + "".join(line(entry, session().decide(entry.statement)) + "\n" for entry in CHAPTER)
    if pytestconfig.getoption("--update-golden"):
        GOLDEN.write_text(found, encoding="utf-8")
    different = list(differences(GOLDEN.read_text(encoding="utf-8"), found))
    assert not different, "\n".join([*different, "if this is meant: pytest tests/test_rotations.py --update-golden"])


def test_all_is_true_and_nothing_is_assumed_in_vain() -> None:
    for entry in CHAPTER:
        verdict = session().decide(entry.statement).verdict
        if isinstance(entry.statement, Claim | Inverse):
            assert isinstance(verdict, Holds | HoldsUnder), f"({entry.number}) {entry.name}: {verdict}"
            assert not verdict.unused, f"({entry.number}) {entry.name} assumes {verdict.unused} in vain"
        else:
            assert isinstance(verdict, Defined), f"({entry.number}) {entry.name}: {verdict}"


def test_certificates_are_accepted() -> None:
    found = recheck([(entry, session().decide(entry.statement)) for entry in CHAPTER], Memory())
    assert found.certificates > 300
    assert not found.rejected


@pytest.mark.sampled(3)
@pytest.mark.parametrize("section", SECTIONS)
def test_numbers_agree(section: str) -> None:
    """At an explicit motion, in 80 digits and more, with differences for rates."""
    for entry in CHAPTER.select(sections=[section]):
        if isinstance(entry.statement, Claim | Inverse) and entry.name not in CALCULUS:
            opinion = opinion_on(entry.statement, motions=1)
            assert opinion.agrees, f"({entry.number}) {entry.name}: {opinion}"


# The words, beside what NumPy and SciPy make of the same numbers.

p, q = (array(name, name, "a quaternion", uniform((4, 1))) for name in "pq")
v, C = vector("v", "v", "a rotation vector"), square("C", "C", "a matrix")
T, t = array("T", "T", "a motion", uniform((4, 4))), array("t", "t", "a twist", uniform((6, 1)))
A, B = array("A", "A", "a matrix", uniform((2, 3))), array("B", "B", "another", uniform((3, 2)))


def of_scipy(x: Array) -> Rotation:
    return Rotation.from_quat(x, scalar_first=True)


def hamilton(x: Array, y: Array) -> Array:
    """By Hamilton's table: i j = k and so on."""
    a, b, c, d = x
    e, f, g, h = y
    return np.array(
        [
            a * e - b * f - c * g - d * h,
            a * f + b * e + c * h - d * g,
            a * g - b * h + c * e + d * f,
            a * h + b * g - c * f + d * e,
        ]
    )


def hat(omega: Array, v: Array) -> Array:
    return np.block([[np.cross(np.eye(3), omega), v[:, None]], [np.zeros((1, 4))]])


def bracket(x: Array, y: Array) -> Array:
    product: Array = x @ y - y @ x
    return product


def of_twists(carried: Callable[[Array], Array]) -> Array:
    """The 6 x 6 matrix of a map of twists that is said of their 4 x 4 matrices."""
    images = [carried(unit.reshape(2, 3)) for unit in np.eye(6)]
    return np.column_stack([[x[2, 1], x[0, 2], x[1, 0], *x[:3, 3]] for x in images])


def mean_adjoint(x: Array) -> Array:
    """The mean of the exponentials of parts of the adjoint of a twist, by Gauss and Legendre."""
    ad = of_twists(lambda y: bracket(hat(x[:3], x[3:]), hat(*y)))
    points, weights = np.polynomial.legendre.leggauss(20)
    mean: Array = np.tensordot(weights / 2, np.array([expm((point + 1) / 2 * ad) for point in points]), 1)
    return mean


def mean_rotation(x: Array) -> Array:
    """The mean of the rotations through parts of a rotation vector, by Gauss and Legendre."""
    points, weights = np.polynomial.legendre.leggauss(20)
    parts = Rotation.from_rotvec((points[:, None] + 1) / 2 * x).as_matrix()
    mean: Array = np.tensordot(weights / 2, parts, 1)
    return mean


def of_basis(multiply: Callable[[Array], Array]) -> Array:
    return np.column_stack([multiply(unit) for unit in np.eye(4)])


WORDS: dict[str, tuple[Node, Callable[..., Any]]] = {
    "product": (quaternion_product(p, q), hamilton),
    "conjugate": (quaternion_conjugate(p), lambda x: x * [1, -1, -1, -1]),
    "from the left": (product_from_left(p), lambda x: of_basis(lambda y: hamilton(x, y))),
    "from the right": (product_from_right(p), lambda x: of_basis(lambda y: hamilton(y, x))),
    "rotation": (rotation_of_quaternion(p), lambda x: x @ x * of_scipy(x).as_matrix()),
    "composition": (
        rotation_of_quaternion(quaternion_product(p, q)),
        lambda x, y: x @ x * (y @ y) * (of_scipy(x) * of_scipy(y)).as_matrix(),
    ),
    "exponential": (exp_of_vector(v), lambda x: Rotation.from_rotvec(x).as_matrix()),
    "left Jacobian": (left_jacobian(v), mean_rotation),
    "right Jacobian": (right_jacobian(v), lambda x: mean_rotation(-x)),
    "Cayley's transform": (cayley(C), lambda c: np.linalg.solve(np.eye(3) - c, np.eye(3) + c)),
    "inverse motion": (inverse_motion(T), np.linalg.inv),
    "matrix of a twist": (twist_matrix(t), lambda x: hat(x[:3], x[3:])),
    "adjoint of a motion": (adjoint_of_motion(T), lambda y: of_twists(lambda x: y @ hat(*x) @ np.linalg.inv(y))),
    "adjoint of a twist": (adjoint_of_twist(t), lambda y: of_twists(lambda x: bracket(hat(y[:3], y[3:]), hat(*x)))),
    "exponential of a motion": (exp_of_motion_vector(t), lambda x: expm(hat(x[:3], x[3:]))),
    "left Jacobian of motions": (left_jacobian_of_motion(t), mean_adjoint),
    "right Jacobian of motions": (right_jacobian_of_motion(t), lambda x: mean_adjoint(-x)),
    "outer product": (outer(p, q), np.outer),
    "Kronecker product": (kronecker_product(A, B), np.kron),
    "direct sum": (
        direct_sum(A, B, p),
        lambda a, b, x: np.block(
            [
                [a, np.zeros((2, 2)), np.zeros((2, 1))],
                [np.zeros((3, 3)), b, np.zeros((3, 1))],
                [np.zeros((4, 3)), np.zeros((4, 2)), x[:, None]],
            ]
        ),
    ),
}


def symbols_in(node: Node) -> list[Node]:
    return [symbol for symbol in (A, B, C, T, p, q, t, v) if symbol in set(_walked(node))]


def _walked(node: Node) -> list[Node]:
    return [node, *(below for part in node._parts() for below in _walked(part))]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", WORDS)
def test_a_word_means_what_others_mean_by_it(name: str) -> None:
    word, other = WORDS[name]
    draws = np.random.default_rng(7)
    for _ in range(20 if WHOLE else 5):
        values = {symbol: draws.standard_normal(symbol.shape) for symbol in symbols_in(word)}
        if T in values:
            values[T][:3, :3] = Rotation.random(rng=draws).as_matrix()
            values[T][3] = [0, 0, 0, 1]
        found = np.array(evaluate(word, values, digits=20), dtype=float)
        expected = np.atleast_2d(other(*(x[:, 0] if x.shape[1] == 1 else x for x in values.values())))
        assert found.reshape(-1) == pytest.approx(expected.reshape(-1))


LAST = {"scalar_last": True}
ORDERS: list[Callable[..., Node]] = [
    quaternion_conjugate,
    product_from_left,
    product_from_right,
    rotation_of_quaternion,
]


@pytest.mark.parametrize("word", ORDERS)
def test_the_scalar_may_come_last(word: Callable[..., Node]) -> None:
    """The numbers in the other order, the result in the other order."""
    x = np.array([0.3, -0.5, 0.7, 0.4])
    first = np.array(evaluate(word(p), {p: x}, digits=20), dtype=float)
    last = np.array(evaluate(word(p, **LAST), {p: np.roll(x, -1)}, digits=20), dtype=float)
    if first.shape[0] == 4:
        first = np.roll(first, -1, axis=0)
    if first.shape == (4, 4):
        first = np.roll(first, -1, axis=1)
    assert last == pytest.approx(first)


@pytest.mark.parametrize("word", ORDERS)
def test_what_is_no_quaternion_is_refused(word: Callable[..., Node]) -> None:
    with pytest.raises(Misfit, match="a quaternion is a column of four numbers"):
        word(column(1, 2, 3))


# Columns of length one, of every height.

HEIGHTS = (2, 3, 4, 5, 6, 9)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("height", HEIGHTS)
def test_columns_of_any_height_are_units(height: int) -> None:
    x, y = (array(name, name, "a column", uniform((height, 1))) for name in "xy")
    across = (unit(x), unit(y), perpendicular(x, y))
    true = [
        Claim("1", dot(x + y, x + y), number(2), assuming=across),
        Claim("2", x.T @ (x @ x.T), x.T, assuming=(unit(x),)),
        Claim("3", dot(x, rate(x)), number(0), assuming=(unit(x),)),
        Claim("4", dot(x, x) * norm(y) ** 2, number(1), assuming=(unit_column(x), unit(y))),
    ]
    wrong = [
        Claim("5", dot(x + y, x + y), number(1), assuming=across),
        Claim("6", x @ y.T, y @ x.T, assuming=(unit(x), unit_column(y))),
        Claim("7", dot(x, y), number(1), assuming=(perpendicular(x, y),)),
        Claim("8", dot(rate(x), rate(x)), rate(dot(x, y)) ** 2, assuming=across),
    ]
    assert [Session().decide(claim).verdict.name for claim in true] == ["holds-under"] * 4
    assert [Session().decide(claim).verdict.name for claim in wrong] == ["fails"] * 4


@pytest.mark.parametrize("height", HEIGHTS)
def test_a_kernel_of_a_unit_column_is_tested_at_units(height: int) -> None:
    x = array("x", "x", "a column", uniform((height, 1)))
    claim = Claim("1", x @ x.T @ x, x, assuming=(unit(x),), kernel=Kernel(of=(x,)))
    entry = Entry("projected", Section("1", "One"), claim)
    checks = kernel_of(entry, Session().decide).checks
    assert len(checks) == 2
    for point in checks:
        assert sum(entry * entry for entry in point.inputs[0]) == 1


# Lengths of turned, stretched and opposite vectors, where they are divided by.

R = square("R", "R", "a rotation")
STRETCHED = {
    "opposite": -v,
    "twice": 2 * v,
    "a third": v / 3,
    "turned": R @ v,
    "turned back": R.T @ v,
    "turned and opposite": -(R @ v),
    "in brackets": paren(-v),
    "opposite of a half": -(v / 2),
    "turned twice": R @ (R @ v),
}


@pytest.mark.sampled(4)
@pytest.mark.parametrize("vector", STRETCHED)
@pytest.mark.parametrize("word", [exp_of_vector, left_jacobian, right_jacobian])
def test_words_that_divide_by_a_length_take_any_vector(word: Callable[[Node], Node], vector: str) -> None:
    given = (nonzero(norm(v)), rotation(R))
    of = STRETCHED[vector]
    assert Session().decide(Claim("1", word(of) @ of, of, assuming=given)).verdict.true
    assert Session().decide(Claim("2", word(of), Identity(3), assuming=given)).verdict.name == "fails"


# Twists with either part first.


@pytest.mark.parametrize(
    "word", [adjoint_of_twist, adjoint_of_motion, left_jacobian_of_motion, right_jacobian_of_motion]
)
def test_the_velocity_may_come_first(word: Callable[..., Node]) -> None:
    of = T if word is adjoint_of_motion else t
    x = np.arange(1.0, 1 + of.shape[0] * of.shape[1]).reshape(of.shape)
    turned = np.roll(x, 3, axis=0) if of is t else x
    first = np.array(evaluate(word(of), {of: x}, digits=20), dtype=float)
    last = np.array(evaluate(word(of, linear_first=True), {of: turned}, digits=20), dtype=float)
    assert last == pytest.approx(np.roll(first, 3, axis=(0, 1)))


def test_the_matrix_of_a_twist_is_the_same_in_either_order() -> None:
    x = np.array([[1.0], [2.0], [3.0], [4.0], [5.0], [6.0]])
    for word in (twist_matrix, exp_of_motion_vector):
        assert evaluate(word(t), {t: x}) == evaluate(word(t, linear_first=True), {t: np.roll(x, 3, axis=0)})


@pytest.mark.parametrize("word", [twist_matrix, adjoint_of_twist, adjoint_of_motion, inverse_motion])
def test_what_is_no_twist_or_motion_is_refused(word: Callable[..., Node]) -> None:
    with pytest.raises(Misfit, match=r"a (twist is a column of six numbers|motion is a 4 x 4 matrix), and .* is 3 x 3"):
        word(C)


@pytest.mark.parametrize("height", [1, *HEIGHTS])
@pytest.mark.parametrize("strategy", ["generic", "simple", "near"])
def test_units_of_every_height_are_drawn(height: int, strategy: str) -> None:
    x = array("x", "x", "a column", uniform((height, 1)))
    asked = specification_of("projected", Claim("1", x @ x.T @ x, x, assuming=(unit(x),), kernel=Kernel(of=(x,))))
    for sample in islice(draw(asked, strategy, np.random.default_rng(3)), 5):
        assert np.linalg.norm(sample.arrays[x]) == pytest.approx(1)


# What is said with derivatives, expansions and inverse functions, beside differences and SciPy.

AXIS, ANGLE = np.array([2.0, -1.0, 2.0]) / 3, 0.7
VECTOR, SMALL = np.array([0.4, -0.9, 0.5]), np.array([2e-3, -1e-3, 2e-3])
QUATERNION, OTHER, OF = np.array([0.3, -0.5, 0.7, 0.4]), np.array([0.2, 0.8, -0.1, 0.6]), np.array([1.0, 2.0, -0.5])
LINKS, JOINTS = (0.7, 0.5), np.array([0.3, -0.8, 1.1])


def slopes(function: Callable[[Array], Any], at: Array) -> Array:
    """Central differences: a column for each number that varies."""
    steps = 1e-6 * np.eye(len(at))
    columns = [(np.asarray(function(at + step)) - np.asarray(function(at - step))) / 2e-6 for step in steps]
    return np.stack(columns, axis=-1)


def last_to_first(x: Array) -> Array:
    return np.roll(x, 1)


def times_last(x: Array, y: Array) -> Array:
    return np.roll(hamilton(last_to_first(x), last_to_first(y)), -1)


def turned_by(x: Array) -> Array:
    turned: Array = x @ x * Rotation.from_quat(x).apply(OF)
    return turned


def about(angle: float) -> Array:
    return Rotation.from_rotvec(AXIS * angle).as_matrix()


def end_of_two(x: Array) -> Array:
    a, b = LINKS
    return np.array([a * np.cos(x[0]) + b * np.cos(x[0] + x[1]), a * np.sin(x[0]) + b * np.sin(x[0] + x[1])])


def end_of_shoulder(x: Array) -> Array:
    """By SciPy's turns: the waist about z, the links in the plane that it faces."""
    a, b = LINKS
    links = Rotation.from_euler("y", -x[1]).apply([a, 0, 0]) + Rotation.from_euler("y", -x[1] - x[2]).apply([b, 0, 0])
    end: Array = Rotation.from_euler("z", x[0]).apply(links + np.array([0, 0, 0.4]))
    return end


ABOUT = {"e": AXIS, "phi": ANGLE}
ARM = {"a_1": LINKS[0], "a_2": LINKS[1], "theta_1": JOINTS[0], "theta_2": JOINTS[1]}
SHOULDER = {"a_2": LINKS[0], "a_3": LINKS[1], "h": 0.4, **{f"theta_{k + 1}": JOINTS[k] for k in range(3)}}
YAW = {"alpha": 0.3, "beta": -0.6, "gamma": 1.2}
TURNED = {"v": VECTOR, "a": OF}
CALCULUS: dict[str, tuple[dict[str, Any], Any, float]] = {
    "derivative_by_angle": (ABOUT, slopes(lambda x: about(x[0]), np.array([ANGLE]))[..., 0], 1e-8),
    "angle_from_trace": (ABOUT, np.arccos((np.trace(about(ANGLE)) - 1) / 2), 1e-12),
    "angle_from_axial_vector_and_trace": (ABOUT, Rotation.from_matrix(about(ANGLE)).magnitude(), 1e-12),
    "trace_is_three_at_most": (ABOUT, 3 - np.trace(about(ANGLE)), 1e-12),
    "derivative_of_product_by_second_factor": (
        {"p": QUATERNION, "q": OTHER},
        slopes(lambda x: times_last(QUATERNION, x), OTHER),
        1e-8,
    ),
    "derivative_of_product_by_first_factor": (
        {"p": QUATERNION, "q": OTHER},
        slopes(lambda x: times_last(x, OTHER), QUATERNION),
        1e-8,
    ),
    "derivative_of_turned_vector_by_quaternion": ({"q": QUATERNION, "a": OF}, slopes(turned_by, QUATERNION), 1e-8),
    "derivative_of_turned_vector": (TURNED, slopes(lambda x: Rotation.from_rotvec(x).apply(OF), VECTOR), 1e-8),
    "gradient_of_angle": (TURNED, slopes(np.linalg.norm, VECTOR), 1e-8),
    "small_rotation": ({"v": SMALL}, Rotation.from_rotvec(SMALL).as_matrix(), 9e-6),
    "rotation_of_second_order": ({"v": SMALL}, Rotation.from_rotvec(SMALL).as_matrix(), 9e-9),
    "jacobian_of_small_rotation": ({"v": SMALL}, mean_rotation(SMALL), 9e-9),
    "exponential_at_zero": ({"v": SMALL}, Rotation.from_rotvec(0 * SMALL).as_matrix(), 1e-12),
    "pitch_from_rotation": (
        YAW,
        Rotation.from_euler("ZYX", [0.3, -0.6, 1.2]).as_euler("ZYX")[1],
        1e-12,
    ),
    "jacobian_of_planar_arm_by_derivatives": (ARM, slopes(end_of_two, JOINTS[:2]), 1e-8),
    "jacobian_of_shoulder_arm_by_derivatives": (SHOULDER, slopes(end_of_shoulder, JOINTS), 1e-8),
    "manipulability_is_not_negative": (ARM, np.linalg.det(slopes(end_of_two, JOINTS[:2])) ** 2, 1e-8),
}


@pytest.mark.parametrize("name", CALCULUS)
def test_calculus_agrees_with_differences(name: str) -> None:
    given, expected, tolerance = CALCULUS[name]
    (entry,) = CHAPTER.select([name])
    assert isinstance(entry.statement, Claim)
    rules = {rule.left: rule.right for rule in entry.statement.given}
    right = entry.statement.right.of if isinstance(entry.statement.right, UpTo) else entry.statement.right
    known = {symbol.name: symbol for node in (right, *rules.values()) for symbol in symbols_of(node)}
    values = {known[said]: value for said, value in given.items() if said in known}
    found = np.array(evaluate(right, values, rules, digits=20), dtype=float)
    assert np.abs(found.reshape(-1) - np.asarray(expected).reshape(-1)).max() < tolerance
