"""Programs that are cheap and right to the last digits: operations, and errors near every singular set.

Errors are normwise, in units of the roundoff (2^-53 or 2^-24), against 50-digit values of the statements.
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from chasles import generated, kernels
from chasles.decisions.session import Session
from chasles.lowering.lower import lower
from chasles.lowering.program import Op, Program
from chasles.numerics.draws import CONTEXT
from chasles.numerics.enclosures import exactly
from chasles.numerics.reference import Singular
from chasles.numerics.sampling import moves
from chasles.numerics.specification import Specification, specification_of
from chasles.statements import Chapter, load

# Additions, subtractions, multiplications, divisions and roots, with the halving of an angle; cosine and sine apart.
OPERATIONS = {
    "rotation_from_axis_angle": 22,
    "natural_rate_matrix": 24,
    "linear_rate_matrix": 28,
    "euler_rodrigues_rate_matrix": 6,
    "linear_velocity_matrix": 5,
    "euler_rodrigues_velocity_matrix": 6,
    "natural_rate_matrix_dot": 69,
    "linear_rate_matrix_dot": 71,
    "euler_rodrigues_rate_matrix_dot": 27,
    "screw_axis_point": 38,
    "twist_transfer": 15,
    "wrench_transfer": 15,
    "inertia_about_point": 24,
    "inertia_dyad": 24,
    "newton_euler_wrench": 45,
    "instant_screw": 49,
}

UNITS = {
    "rotation_from_axis_angle": 8,
    "natural_rate_matrix": 6,
    "linear_rate_matrix": 6,
    "euler_rodrigues_rate_matrix": 6,
    "natural_velocity_matrix": 6,
    "linear_velocity_matrix": 6,
    "euler_rodrigues_velocity_matrix": 6,
    "natural_rate_matrix_dot": 10,
    "linear_rate_matrix_dot": 10,
    "euler_rodrigues_rate_matrix_dot": 10,
    "natural_velocity_matrix_dot": 10,
    "euler_rodrigues_velocity_matrix_dot": 10,
    "normal_matrix_inverse": 8,
    "inertia_about_point": 4,
}
LISTED = tomllib.loads((Path(generated.__file__).parent / "MANIFEST.toml").read_text("utf-8"))["kernels"]
# The kernels whose proved bound is about each entry itself or the largest one, and not about sizes of terms.
NORMWISE = [n for n in UNITS if {g["against"] for g in LISTED[n]["bound"]["guarantees"]} <= {"itself", "largest"}]
CIRCULAR = (Op.SINE, Op.COSINE, Op.ARCTANGENT2)
PRECISIONS = [np.float64, np.float32]
OFFSETS = {np.float64: (1e-300, 1e-150, 1e-12, 1e-8, 1e-4, 0.1), np.float32: (1e-37, 1e-18, 1e-6, 1e-4, 1e-2, 0.1)}


class Book:
    """The requests and programs of the chapter's kernels."""

    def __init__(self) -> None:
        self._judge = Session()
        self._chapter: Chapter = load()
        self._made: dict[str, tuple[Specification, Program]] = {}

    def made(self, name: str) -> tuple[Specification, Program]:
        if name not in self._made:
            entry = next(e for e in self._chapter if e.name == name)
            program = lower(entry, self._judge.decide)
            names = [result.name for result in program.results]
            request = specification_of(name, entry.statement, results=names, accepted=self._judge.accepted)  # type: ignore[arg-type]
            self._made[name] = request, program
        return self._made[name]


@pytest.fixture(scope="module")
def book() -> Book:
    return Book()


@pytest.mark.parametrize("name", OPERATIONS)
def test_no_more_operations_than_by_hand(book: Book, name: str) -> None:
    counts = book.made(name)[1].operations
    assert sum(count for op, count in counts.items() if op not in CIRCULAR) <= OPERATIONS[name]
    assert counts[Op.SINE] <= 1
    assert counts[Op.COSINE] <= 1


def angles(dtype: type[np.floating[Any]]) -> Iterator[float]:
    """Near zero, near half a turn and a whole one, from both sides, and at large."""
    for offset in OFFSETS[dtype]:
        for middle in (0.0, math.pi, math.pi / 2, 2 * math.pi):
            yield middle + offset
            yield middle - offset
    yield from (1.0, 2.0, -2.5, math.pi, 2 * math.pi, 100.0)


def points(request: Specification, dtype: type[np.floating[Any]]) -> Iterator[dict[Any, Any]]:
    """Inputs as arrays of the type: at every angle two axes, and all else at large."""
    generator = np.random.default_rng(7)
    units = {h.subjects[0] for h in request.hypotheses if h.kind == "unit"}
    for angle in angles(dtype) if request.angles else range(30):
        for near_axis in (False, True):
            point = {}
            for given in request.inputs:
                value = generator.standard_normal(given.shape)
                if given.holds in units:
                    value = np.array([1e-7, 1.0, -1e-4]) if near_axis else value
                    value = value / np.linalg.norm(value)
                elif given.shape == (3, 3):
                    value = value @ value.T
                elif given.name == "m":
                    value = abs(value)
                point[given.holds] = np.asarray(angle if given.holds in request.angles else value, dtype)
            yield point


def reference(request: Specification, point: dict[Any, Any]) -> list[Any] | None:
    """The first output's entries; None where it has no value, or none within the range of the type."""
    try:
        exact = [x for row in request.reference(point, 40)[0] for x in row]
    except Singular:
        return None
    largest = max(map(abs, exact))
    limits = np.finfo(next(iter(point.values())).dtype)
    return exact if float(limits.tiny) / float(limits.eps) < largest < float(limits.max) / 16 else None


def error(request: Specification, point: dict[Any, Any], exact: list[Any], dtype: type[np.floating[Any]]) -> float:
    """The largest error of an entry in units of the roundoff of the largest entry."""
    got = np.asarray(getattr(kernels, request.name)(*(point[given.holds] for given in request.inputs)))
    assert got.dtype == dtype
    assert np.all(np.isfinite(got)), point
    gaps = [abs(exactly(float(y), CONTEXT) - x) for x, y in zip(exact, got.flat, strict=True)]
    return float(max(gaps) / max(map(abs, exact)) * 2 / exactly(float(np.finfo(dtype).eps), CONTEXT))


def entries(
    request: Specification, point: dict[Any, Any], k: int, places: tuple[int, ...], digits: int = 40
) -> list[Any]:
    flat = [x for row in request.reference(point, digits)[k] for x in row]
    return [flat[place] for place in places]


def condition(request: Specification, point: dict[Any, Any], k: int, places: tuple[int, ...]) -> float:
    """The condition number of a group of entries."""
    exact, total = entries(request, point, k, places), exactly(0, CONTEXT)
    for node, value in point.items():
        for below, above in moves(request, node, value, value):
            low, high = np.ravel(below), np.ravel(above)
            (place,) = np.flatnonzero(low != high)
            step = exactly(float(high[place]), CONTEXT) - exactly(float(low[place]), CONTEXT)
            sides = (entries(request, {**point, node: moved}, k, places, 20) for moved in (below, above))
            change = max(abs(x - y) for x, y in zip(*sides, strict=True))
            total += change / step * abs(float(np.ravel(value)[place]))
    return float(total / max(map(abs, exact)))


@pytest.mark.sampled(7)
@pytest.mark.parametrize("dtype", PRECISIONS)
@pytest.mark.parametrize("name", UNITS)
def test_right_to_the_last_digits_at_every_angle(book: Book, name: str, dtype: type[np.floating[Any]]) -> None:
    request = book.made(name)[0]
    compared = 0
    for point in points(request, dtype):
        exact = reference(request, point)
        if exact is not None:
            assert error(request, point, exact, dtype) <= UNITS[name], point
            compared += 1
    assert compared > 50


@pytest.mark.sampled(3)
@pytest.mark.parametrize("dtype", PRECISIONS)
@pytest.mark.parametrize("name", NORMWISE)
def test_no_error_beside_the_statement_is_larger_than_proved(
    book: Book, name: str, dtype: type[np.floating[Any]]
) -> None:
    (proved,) = LISTED[name]["bound"]["guarantees"]
    request = book.made(name)[0]
    for point in points(request, dtype):
        exact = reference(request, point)
        assert exact is None or error(request, point, exact, dtype) <= float(proved["units"]), point


@pytest.mark.sampled(4)
@pytest.mark.parametrize("dtype", PRECISIONS)
@pytest.mark.parametrize(
    ("name", "units"), [("screw_axis_point", 0), ("linear_velocity_matrix_dot", 0), ("newton_euler_wrench", 4)]
)
def test_as_good_as_the_inputs_leave_it(book: Book, name: str, units: int, dtype: type[np.floating[Any]]) -> None:
    request = book.made(name)[0]
    compared = 0
    for point in points(request, dtype):
        exact = reference(request, point)
        if exact is not None:
            found = error(request, point, exact, dtype)
            assert found <= units or found <= 2 * condition(request, point, 0, tuple(range(len(exact)))), point
            compared += 1
    assert compared > 50


AXIS = np.array([2.0, 3.0, 6.0]) / 7
SPIN = np.array([0.5, -1.0, 2.0])


@pytest.mark.parametrize("dtype", PRECISIONS)
@pytest.mark.parametrize("zero", [0.0, -0.0])
def test_no_value_where_there_is_no_limit(zero: float, dtype: type[np.floating[Any]]) -> None:
    e, phi, omega = (np.asarray(x, dtype) for x in (AXIS, zero, SPIN))
    with np.errstate(all="ignore"):
        found = kernels.natural_rate_matrix(e, phi)
        assert np.isnan(found[:3]).all()
        assert (found[3] == e).all()
        assert np.isnan(kernels.natural_rate_matrix_dot(e, phi, omega)).all()
        turned = kernels.natural_velocity_matrix_dot(e, phi, omega)
        assert np.isnan(turned[:, 3]).all()
        assert np.isfinite(turned[:, :3]).all()
        assert np.isnan(kernels.normal_matrix_inverse(e, phi)).all()
        assert np.isnan(kernels.screw_axis_point(e, phi, omega, e)).all()


@pytest.mark.parametrize("dtype", PRECISIONS)
def test_limits_are_exact(dtype: type[np.floating[Any]]) -> None:
    e, phi, omega = (np.asarray(x, dtype) for x in (AXIS, 0.0, SPIN))
    half, one = np.asarray(0.5, dtype), np.eye(3, dtype=dtype)
    cross = np.array([[0, -omega[2], omega[1]], [omega[2], 0, -omega[0]], [-omega[1], omega[0], 0]])
    assert (kernels.rotation_from_axis_angle(e, phi) == one).all()
    assert (kernels.linear_rate_matrix(e, phi) == np.vstack([one, np.zeros(3)])).all()
    assert (kernels.linear_velocity_matrix(e, phi) == np.column_stack([one, np.zeros(3)])).all()
    assert (kernels.linear_rate_matrix_dot(e, phi, omega) == np.vstack([-half * cross, -omega])).all()
    assert (kernels.linear_velocity_matrix_dot(e, phi, omega) == np.column_stack([half * cross, -half * omega])).all()


SLOW = {np.float64: (1e-140, 1e-100, 1e-12, 1e-8, 1e-4, 1.0), np.float32: (1e-17, 1e-12, 1e-8, 1e-4, 1e-2, 1.0)}
PARALLEL = {np.float64: (1.0, 1e-4, 1e-8, 1e-12), np.float32: (1.0, 1e-2, 1e-4, 1e-6)}


def slow_points(request: Specification, dtype: type[np.floating[Any]]) -> Iterator[dict[Any, Any]]:
    """The first input, of which the direction is taken, ever smaller; the second ever nearer to parallel to it."""
    generator = np.random.default_rng(11)
    for size in SLOW[dtype]:
        for aside in PARALLEL[dtype]:
            first, second, third = (generator.standard_normal(3) for _ in range(3))
            values = (size * first, first + aside * second, third)
            yield {given.holds: x.astype(dtype) for given, x in zip(request.inputs, values, strict=True)}


@pytest.mark.sampled(4)
@pytest.mark.parametrize("dtype", PRECISIONS)
@pytest.mark.parametrize("name", ["instant_screw", "wrench_axis", "instant_screw_point"])
def test_as_good_as_the_inputs_where_nothing_turns_or_pulls(
    book: Book, name: str, dtype: type[np.floating[Any]]
) -> None:
    request = book.made(name)[0]
    for point in slow_points(request, dtype):
        got = getattr(kernels, name)(*(point[given.holds] for given in request.inputs))
        got = got if isinstance(got, tuple) else (got,)
        for k, output in enumerate(request.outputs):
            for places in output.alike:
                found = relative(request, point, got[k], k, places)
                bound = condition(request, point, k, places)
                assert found / float(np.finfo(dtype).eps) * 2 <= 4 + 2 * bound, (output.name, point)


def relative(request: Specification, point: dict[Any, Any], got: Any, k: int, places: tuple[int, ...]) -> float:
    """The error of a group of entries, in parts of the largest of them."""
    exact = entries(request, point, k, places)
    flat = np.ravel(got)
    gaps = [abs(exactly(float(flat[place]), CONTEXT) - x) for place, x in zip(places, exact, strict=True)]
    return float(max(gaps) / max(map(abs, exact)))


@pytest.mark.parametrize("dtype", PRECISIONS)
def test_no_screw_of_what_stands_still(dtype: type[np.floating[Any]]) -> None:
    nothing, e = np.zeros(3, dtype), AXIS.astype(dtype)
    with np.errstate(all="ignore"):
        for screw in (kernels.instant_screw, kernels.wrench_axis):
            assert all(np.isnan(found).all() for found in screw(nothing, e, e))
        assert np.isnan(kernels.instant_screw_point(nothing, e, e)).all()


def test_the_manifest_marks_the_kernels_that_needed_a_form(book: Book) -> None:
    asked = {e.name: e.statement.kernel for e in load() if e.statement.kernel is not None}
    assert {name for name in LISTED if LISTED[name]["form"] == "offered"} == {
        n for n in asked if asked[n].form is not None
    }
    assert LISTED["screw_axis_point"]["form"] == "offered"
    assert LISTED["natural_rate_matrix"]["form"] == "stated"
