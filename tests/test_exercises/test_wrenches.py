"""Exercises 3.2, 3.4 and 3.19: forces, moments and frames with known answers."""

from __future__ import annotations

from random import Random

import pytest
import sympy as sp

from chasles.exercises.data import DataError
from chasles.exercises.solving import solve

from .known import motion, plain, rational, same, vector

NAMES = ("P1", "P2", "P3", "P4")


@pytest.mark.sampled(3)
@pytest.mark.parametrize("seed", range(8))
def test_the_moment_is_least_at_the_point_found(seed: int) -> None:
    draw = Random(seed)
    points = {name: vector(draw) for name in NAMES}
    forces = [[*draw.sample(NAMES, 2), abs(rational(draw))] for _ in range(draw.randint(1, 3))]
    if any(points[one] == points[two] for one, two, _ in forces):
        pytest.skip("a force without direction")
    near = draw.choice(NAMES)
    raw = {"points": {k: plain(v) for k, v in points.items()}, "forces": [[a, b, str(s)] for a, b, s in forces]}
    solution = solve("3.2", **raw, closest_to=near)
    lengths = [sp.sqrt((points[b] - points[a]).dot(points[b] - points[a])) for a, b, _ in forces]
    acting = [(points[a], (points[b] - points[a]) / n * s) for (a, b, s), n in zip(forces, lengths, strict=True)]
    total = sum((f for _, f in acting), sp.zeros(3, 1))

    def moment(about: sp.Matrix) -> sp.Matrix:
        return sum(((at - about).cross(f) for at, f in acting), sp.zeros(3, 1))

    answers = solution.answers
    if same(total, sp.zeros(3, 1)):
        assert solution.status == "pure-couple"
        assert same(answers["n"], moment(points[near]))
        return
    assert solution.status == "ok"
    assert same(answers["f"], total)
    assert same(moment(sp.Matrix(answers["P"])), answers["n_min"])
    assert same(sp.Matrix(answers["n_min"]).cross(total), sp.zeros(3, 1))
    foot = sp.Matrix(answers["P"]) - points[near]
    assert same(foot.dot(total), 0)
    assert same(answers["distance"] ** 2, foot.dot(foot))
    assert same(sp.Matrix(answers["n_min"]), total * answers["pitch"])
    assert same(answers["n_min_signed"], answers["pitch"] * sp.sqrt(total.dot(total)))


def test_the_default_tetrahedron() -> None:
    answers = solve("3.2").as_data()["answers"]
    assert answers["P"] == ["1/4", "sqrt(3)/4", "0"]
    assert (answers["n_min_signed"], answers["pitch"], answers["distance"]) == ("1/2", "sqrt(2)/4", "1/2")


def test_couples() -> None:
    pair = solve("3.2", forces=[["P1", "P2", 2], ["P2", "P1", 2]])
    assert (pair.status, plain(pair.answers["n"])) == ("pure-couple", ["0", "0", "0"])
    square = {"P1": [0, 0, 0], "P2": [1, 0, 0], "P3": [1, 1, 0], "P4": [0, 1, 0]}
    couple = solve("3.2", points=square, forces=[["P1", "P2", 3], ["P3", "P4", 3]])
    assert (couple.status, plain(couple.answers["n"])) == ("pure-couple", ["0", "0", "3"])


@pytest.mark.parametrize(
    ("data", "match"),
    [
        ({"forces": [["P1", "P1", 1]]}, "a force from P1 to P1 has no direction"),
        ({"forces": [["P1", "P2", -1]]}, "magnitude of the force from P1 to P2 is negative"),
        ({"forces": [["P1", "P5", 1]]}, r"forces\[1\], to: expected one of P1, P2, P3, P4, and got 'P5'"),
        ({"forces": []}, "forces: expected at least 1 entries, and got 0"),
        ({"forces": [["P1", "P2"]]}, r"forces\[1\]: expected \[from, to, magnitude\], and got 2 of them"),
        ({"points": {"P1": [0, 0, 0]}}, "points: P2 is missing"),
        ({"closest_to": 4}, "closest_to: expected one of P1"),
    ],
)
def test_malformed_forces(data: dict, match: str) -> None:
    with pytest.raises(DataError, match=match):
        solve("3.2", **data)


@pytest.mark.parametrize("half_turn", [False, True])
@pytest.mark.parametrize("seed", range(6))
def test_a_known_rotation_between_two_sensors(seed: int, half_turn: bool) -> None:
    draw = Random(seed)
    known, n, f = motion(draw, half_turn), vector(draw), vector(draw)
    solution = solve("3.4", n1=plain(known.Q * n), f1=plain(known.Q * f), n2=plain(n), f2=plain(f))
    assert solution.status == "compatible"
    if n.cross(f) != sp.zeros(3, 1):
        assert solution.answers["unique"]
        assert same(solution.answers["R"], known.Q)
        assert same(solution.answers["e"], known.e)
        assert same(sp.cos(solution.answers["phi"]), known.cosine)
    else:
        assert not solution.answers["unique"]


def test_the_default_sensors() -> None:
    answers = solve("3.4").as_data()["answers"]
    assert answers["invariants_1"] == answers["invariants_2"] == ["25", "4", "0"]
    assert answers["R"] == [["2/3", "1/3", "2/3"], ["-2/3", "2/3", "1/3"], ["-1/3", "-2/3", "2/3"]]
    assert answers["phi"] == "pi/3"


@pytest.mark.parametrize(
    ("n1", "f1", "n2", "f2"),
    [
        ([0, 0, 1], [0, 0, 2], [0, 0, -1], [0, 0, -2]),
        ([0, 0, 1], [0, 0, 2], [1, 0, 0], [2, 0, 0]),
        ([0, 0, 0], [0, 0, 2], [0, 0, 0], [0, 2, 0]),
        ([0, 3, 4], [0, 0, 0], [5, 0, 0], [0, 0, 0]),
        ([0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]),
    ],
)
def test_vectors_along_one_line_leave_a_rotation_open(n1: list, f1: list, n2: list, f2: list) -> None:
    solution = solve("3.4", n1=n1, f1=f1, n2=n2, f2=f2)
    assert (solution.status, solution.answers["unique"]) == ("compatible", False)
    R = sp.Matrix(solution.answers["R"])
    assert same(R * sp.Matrix(n2), sp.Matrix(n1))
    assert same(R * sp.Matrix(f2), sp.Matrix(f1))
    assert same(R.T * R, sp.eye(3))
    assert R.det() == 1


@pytest.mark.parametrize(
    ("data", "violated"),
    [
        ({"n1": [0, 0, 6]}, ["n.n"]),
        ({"f1": [0, 3, 0]}, ["f.f"]),
        ({"n1": [0, 3, 4]}, ["n.f"]),
        ({"n1": [0, 1, 4], "f1": [1, 1, 1]}, ["n.n", "f.f", "n.f"]),
        ({"n1": [0, 0, "5 + 1/10^30"]}, ["n.n"]),
    ],
)
def test_sensors_that_contradict_each_other(data: dict, violated: list) -> None:
    solution = solve("3.4", **data)
    assert (solution.status, solution.answers["violated"]) == ("incompatible", violated)


@pytest.mark.parametrize("seed", range(6))
def test_a_wrench_at_another_point_in_another_frame(seed: int) -> None:
    draw = Random(seed)
    R, n, f, r = motion(draw).Q, vector(draw), vector(draw), vector(draw)
    answers = solve("3.19", n=plain(n), f=plain(f), r=plain(r), R=plain(R)).answers
    assert same(answers["n_P_in_S"], n - r.cross(f))
    assert same(answers["n_P_in_2"], R * (n - r.cross(f)))
    assert same(answers["f_in_2"], R * f)


def test_the_default_sensor() -> None:
    assert solve("3.19").as_data()["answers"]["n_P_in_2"] == ["11/10", "0", "1"]


@pytest.mark.parametrize(
    ("data", "match"),
    [
        ({"R": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]}, "R: expected a rotation matrix"),
        ({"R": [[2, 0, 0], [0, 1, 0], [0, 0, 1]]}, "R: expected a rotation matrix"),
        ({"R": [[1, 0, 0], [0, 1, 0]]}, "R: expected 3 rows of 3 numbers, and got 2 of them"),
        ({"R": [[1, 0, 0], [0, 1], [0, 0, 1]]}, r"R\[2\]: expected a list of 3 numbers"),
        ({"r": [0, 0, "100 mm"]}, r"r\[3\]: .*at character 5"),
    ],
)
def test_malformed_sensors(data: dict, match: str) -> None:
    with pytest.raises(DataError, match=match):
        solve("3.19", **data)


def test_more_square_roots_than_can_be_handled_are_refused_at_once() -> None:
    roots = [f"sqrt({prime})" for prime in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)]
    points = {name: roots[3 * k : 3 * k + 3] for k, name in enumerate(NAMES)}
    with pytest.raises(DataError, match="more than 8 independent square roots; give simpler numbers"):
        solve("3.2", points=points)


@pytest.mark.parametrize(
    ("forces", "said"),
    [([["P2", "P3", 1], ["P4", "P1", 1]], "P is the midpoint of P2 and P4"), ([["P2", "P3", 2], ["P4", "P1", 1]], "")],
)
def test_a_midpoint_is_named_where_there_is_one(forces: list, said: str) -> None:
    solution = solve("3.2", forces=forces)
    found = [step.says for step in solution.steps if "midpoint" in step.says]
    assert bool(found) == bool(said)
    assert all(said in says for says in found)
    named = [line.text.split(" = ")[0] for step in solution.steps for line in step.lines]
    assert {"f_1", "f_2"} <= set(named)
