"""Proved error bounds hold on real machines and against the worst machine that the rounding model allows."""

from __future__ import annotations

import math
import sys
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from dataclasses import replace as with_fields
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from chasles.generated.numpy import kernels as readable

from chasles import generated, kernels
from chasles.bounds import proving
from chasles.bounds.bound import Bound, Guarantee
from chasles.bounds.cases import cases
from chasles.bounds.cover import covered
from chasles.bounds.covering import Boxes, bounds_over, largest
from chasles.bounds.intervals import Interval
from chasles.bounds.model import DOUBLE, SINGLE, Model
from chasles.bounds.outline import NoBound, Outline, outlined
from chasles.bounds.pieces import NEAR, face_values
from chasles.bounds.proving import bound_of, key_of, remembered
from chasles.bounds.sensitivity import against_largest
from chasles.bounds.termwise import termwise_errors
from chasles.cli import emission
from chasles.cli.failures import Failure
from chasles.decisions.session import Session
from chasles.lowering.builder import Builder
from chasles.lowering.declaration import requested
from chasles.lowering.lower import program_of
from chasles.lowering.program import Argument, Op, Program, Result, Step, is_power_of_two
from chasles.lowering.request import Request
from chasles.statements import load

MANIFEST = (Path(generated.__file__).parent / "MANIFEST.toml").read_text("utf-8")
LISTED = tomllib.loads(MANIFEST)["kernels"]
PROVED = [name for name in LISTED if LISTED[name]["bound"]["guarantees"]]
COVERED = [name for name in PROVED if any(g["against"] == "largest" for g in LISTED[name]["bound"]["guarantees"])]
# Which take one case or another, so that a program of each case is compared.
CHOOSING = {"natural_invariants", "euler_rodrigues_parameters", "screw_of_motion"}
CONTEXT = mpmath.MPContext()
CONTEXT.dps = 60
ANY_SCALE = CONTEXT.mpf("0.7")
"""A scale that the machine does not take: exact values do not depend on which it is."""


class Book:
    """The chapter's requests and programs."""

    def __init__(self) -> None:
        judge, self.made = Session(), dict[str, tuple[Request, Program]]()
        for entry in load():
            for asked in entry.kernels:
                request = requested(entry, judge.decide, asked)
                self.made[request.name] = request, program_of(request)


@pytest.fixture(scope="module")
def book() -> Book:
    return Book()


@dataclass(frozen=True)
class Value:
    """An exact value beside the sum of its terms' sizes; `exact` where nothing has been rounded.

    `condition` is that of the divisors that it depends on.
    """

    value: Any
    size: Any
    exact: bool
    condition: Any = 1


def exact_values(outline: Outline, inputs: list[list[Any]]) -> dict[int, Value]:
    """Every step to 60 digits, and its terms' sizes as the definition has them."""
    found: dict[int, Value] = {}
    for number in outline.needed:
        step = outline.program.steps[number]
        if number in outline.angles:
            argument, entry, factor = outline.angles[number]
            angle = CONTEXT.mpf(factor.numerator) / factor.denominator * inputs[argument][entry]
            value = CONTEXT.sin(angle) if step.op is Op.SINE else CONTEXT.cos(angle)
            found[number] = Value(value, abs(value), False)
            continue
        if number in outline.scales:
            found[number] = Value(ANY_SCALE, ANY_SCALE, True)
            continue
        of = [found[k] for k in outline.operands(number)]
        match step.op:
            case Op.INPUT:
                found[number] = Value(inputs[step.argument][step.entry], abs(inputs[step.argument][step.entry]), True)
            case Op.CONSTANT:
                value = CONTEXT.mpf(step.value.numerator) / step.value.denominator
                found[number] = Value(value, abs(value), SINGLE.is_exact(step.value))
            case Op.NEGATE:
                found[number] = Value(-of[0].value, of[0].size, of[0].exact)
            case Op.ADD | Op.SUBTRACT:
                value = of[0].value + (of[1].value if step.op is Op.ADD else -of[1].value)
                one_term = of[0].exact and of[1].exact
                found[number] = Value(value, abs(value) if one_term else of[0].size + of[1].size, False)
            case Op.MULTIPLY:
                scaled = any(scales(outline, k) for k in outline.operands(number)) and of[0].exact and of[1].exact
                found[number] = Value(of[0].value * of[1].value, of[0].size * of[1].size, scaled)
            case Op.DIVIDE:
                condition = max(of[1].condition, of[1].size / abs(of[1].value))
                found[number] = Value(of[0].value / of[1].value, of[0].size / abs(of[1].value), False, condition)
            case Op.SQUARE_ROOT:
                value = CONTEXT.sqrt(of[0].value)
                found[number] = Value(value, value, False)
            case Op.ARCTANGENT2:
                value = CONTEXT.atan2(of[0].value, of[1].value)
                found[number] = Value(value, abs(value), False)
            case op:
                raise AssertionError(op)
        worst = max((x.condition for x in of), default=1)
        found[number] = with_fields(found[number], condition=max(found[number].condition, worst))
    return found


def scales(outline: Outline, number: int) -> bool:
    step = outline.program.steps[number]
    return step.op is Op.CONSTANT and is_power_of_two(step.value)


def worst_roundings(outline: Outline, inputs: list[list[Any]], model: Model, entry: int) -> tuple[Any, Any]:
    """The exact entry, and the farthest from it that a machine within the model gets by always rounding one way.

    Which way each operation rounds is found by letting it alone round; then all do it together.
    """
    plain = simulated(outline, inputs, model, {})
    ways: dict[int, int] = {}
    for number in outline.needed:
        moved = simulated(outline, inputs, model, {number: 1})[entry]
        ways[number] = 1 if moved >= plain[entry] else -1
    outcomes = [simulated(outline, inputs, model, {k: sign * s for k, s in ways.items()})[entry] for sign in (1, -1)]
    return plain[entry], max(outcomes, key=lambda x: abs(x - plain[entry]))


def simulated(outline: Outline, inputs: list[list[Any]], model: Model, ways: dict[int, int]) -> dict[int, Any]:
    """Every step on a machine whose operations are off by as much as they may be, in the direction of `ways`."""
    unit, found = CONTEXT.mpf(model.roundoff.numerator) / model.roundoff.denominator, dict[int, Any]()
    for number in outline.needed:
        step, loss = outline.program.steps[number], unit
        if number in outline.angles:
            argument, entry, factor = outline.angles[number]
            angle = CONTEXT.mpf(factor.numerator) / factor.denominator * inputs[argument][entry]
            value, loss = (CONTEXT.sin if step.op is Op.SINE else CONTEXT.cos)(angle), 2 * unit * float(model.ulps)
        else:
            operands = outline.operands(number)
            of = [found[k] for k in operands]
            match step.op:
                case Op.INPUT:
                    value, loss = inputs[step.argument][step.entry], 0
                case Op.CONSTANT:
                    value, loss = CONTEXT.mpf(step.value.numerator) / step.value.denominator, 0
                case Op.NEGATE:
                    value, loss = -of[0], 0
                case Op.ADD | Op.SUBTRACT:
                    value = of[0] + (of[1] if step.op is Op.ADD else -of[1])
                case Op.MULTIPLY:
                    value, loss = of[0] * of[1], 0 if any(scales(outline, k) for k in operands) else unit
                case Op.DIVIDE:
                    value = of[0] / of[1]
                case _:
                    value = CONTEXT.sqrt(of[0])
        place = CONTEXT.mpf(2) ** int(CONTEXT.floor(CONTEXT.log(abs(value), 2))) if value else 0
        found[number] = value + ways.get(number, 0) * loss * place
    return found


def measured_against(guarantee: Guarantee, values: list[Value], got: list[Any], alike: list[list[int]]) -> Any:
    """The error in parts of what it is measured against."""
    worst = CONTEXT.mpf(0)
    for group in alike:
        largest = max(abs(values[k].value) for k in group)
        for k in group:
            gap = abs(CONTEXT.mpf(got[k]) - values[k].value)
            sizes = {"largest": largest, "terms": values[k].size, "conditioned": values[k].size * values[k].condition}
            size = sizes.get(guarantee.against, abs(values[k].value))
            worst = max(worst, gap / size if size else gap and CONTEXT.inf)
    return worst


ANGLES = (1.0, -2.5, 1e-4, -1e-9, math.pi - 1e-5, math.pi, -math.pi / 2 + 1e-7, 3 * math.pi / 2, 6.2, 40.0)
# Just above a power of two a rounding is relatively largest; on the axes and diagonals the boxes' corners lie.
AXES = ((1, 1e-5, 1e-6), (1, 1, 1), (-1, 1, 1e-3), (1e-7, 0, 1), (0.6, -0.48, 0.64), (-0.1, 2.0, 0.9))


def points(request: Request, program: Program, dtype: type[np.floating[Any]], count: int) -> Iterator[list[Any]]:
    """Inputs in the order of the arguments; what is bounded for all inputs gets inputs that obey no hypothesis."""
    generator = np.random.default_rng(3)
    units = set(proving._units(request))
    angles = {argument for argument, _, _ in outlined(program).angles.values()}
    for n in range(count):
        point: list[Any] = []
        for k, argument in enumerate(program.arguments):
            value = generator.standard_normal(argument.shape)
            if n % 3 == 1:
                value = np.sign(value) * 2.0 ** generator.integers(-2, 3, argument.shape) * (1 + 1e-6 * abs(value))
            if k in units:
                value = np.array(AXES[n % len(AXES)]) if n % 2 else value
                value = value / np.linalg.norm(value)
            elif k in angles:
                drawn = generator.choice(ANGLES, argument.shape)
                value = drawn if n % 4 else generator.uniform(-7, 7, argument.shape)
            point.append(np.asarray(value, dtype))
        yield point


def compare(
    book: Book, name: str, function: Callable[..., Any], dtype: type[np.floating[Any]], count: int
) -> list[tuple[Guarantee, float]]:
    """The largest error of each result in units of the roundoff, beside what is proved."""
    request, program = book.made[name]
    outline = outlined(program)
    bound = Bound.from_data(LISTED[name]["bound"])
    worst = [CONTEXT.mpf(0)] * len(bound.guarantees)
    for point in points(request, program, dtype, count):
        inputs = [[CONTEXT.mpf(float(x)) for x in np.ravel(value)] for value in point]
        try:
            exact = exact_values(outline, inputs)
        except ZeroDivisionError:
            continue
        with np.errstate(all="ignore"):
            got = function(*(value[()] for value in point))
        for k, result in enumerate(got if isinstance(got, tuple) else (got,)):
            values = [exact[number] for number in outline.entries(k)]
            alike = [list(group) for group in proving._places(request)[k]]
            entries = [float(x) for x in np.ravel(result)]
            worst[k] = max(worst[k], measured_against(bound.guarantees[k], values, entries, alike))
    unit = float(np.finfo(dtype).eps) / 2
    return [(g, float(x) / unit) for g, x in zip(bound.guarantees, worst, strict=True)]


@pytest.mark.sampled(13)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("name", [name for name in PROVED if name not in CHOOSING])
def test_no_kernel_errs_by_more_than_is_proved(book: Book, name: str, dtype: type[np.floating[Any]]) -> None:
    for function in dict.fromkeys((getattr(kernels, name), getattr(readable, name))):
        for guarantee, found in compare(book, name, function, dtype, 8):
            assert found <= float(guarantee.units), guarantee


def test_something_is_proved_of_every_kernel() -> None:
    assert set(PROVED) == set(LISTED)
    assert not any(LISTED[name]["bound"]["reason"] for name in LISTED)


def rotations(count: int) -> Iterator[Any]:
    """By quaternions at large, near and on half turns, near none, and with components of equal size."""
    generator = np.random.default_rng(9)
    for n in range(count):
        q = generator.standard_normal(4)
        if n % 4 == 1:
            q[0] *= 10.0 ** -(n % 17)
        elif n % 4 == 2:
            q[1:] *= 10.0 ** -(n % 17)
        elif n % 4 == 3:
            q = np.sign(q) * (1 + 1e-3 * abs(q))
        w, x, y, z = (CONTEXT.mpf(float(c)) for c in q)
        size = w * w + x * x + y * y + z * z
        rows = (
            (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
        )
        yield np.array([[float(entry / size) for entry in row] for row in rows])


def signed(found: float, value: Any) -> float:
    """A sign that is chosen is looked through in a case: either is right."""
    return min(found, -found, key=lambda x: abs(x - value))


def errors_beside_cases(book: Book, name: str, dtype: Any, factor: float = 1.0) -> list[tuple[Guarantee, float]]:
    """The largest error of each result in units of the roundoff, of the case to which it is nearest."""
    program = book.made[name][1]
    guarantees = Bound.from_data(LISTED[name]["bound"]).guarantees
    worst = [CONTEXT.mpf(0)] * len(guarantees)
    generator, different = np.random.default_rng(4), cases(program)
    for Q in rotations(40):
        point = [Q.astype(dtype)]
        point += [generator.standard_normal(a.shape).astype(dtype) for a in program.arguments[1:]]
        inputs = [[CONTEXT.mpf(float(x)) for x in np.ravel(value)] for value in point]
        got = getattr(kernels, name)(*point)
        found = []
        for case in different:
            try:
                exact = exact_values(case.outline, inputs)
            except ZeroDivisionError:
                continue
            parts = []
            for i, (guarantee, result) in enumerate(zip(guarantees, got, strict=True)):
                values = [exact[k] for k in case.outline.entries(i)]
                computed = zip(factor * np.ravel(result), values, strict=True)
                entries = [signed(float(x), value.value) for x, value in computed]
                parts.append(measured_against(guarantee, values, entries, [[k] for k in range(len(values))]))
            found.append(parts)
        nearest = min(found, key=max)
        worst = [max(pair) for pair in zip(worst, nearest, strict=True)]
    unit = float(np.finfo(dtype).eps) / 2
    return [(g, float(x) / unit) for g, x in zip(guarantees, worst, strict=True)]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("name", sorted(CHOOSING))
def test_no_kernel_of_several_cases_errs_by_more_than_is_proved(book: Book, name: str, dtype: Any) -> None:
    for guarantee, found in errors_beside_cases(book, name, dtype):
        assert 0.05 * float(guarantee.units) <= found <= float(guarantee.units), guarantee


def test_a_case_that_errs_by_more_is_found_out(book: Book) -> None:
    ((guarantee, found), _) = errors_beside_cases(book, "euler_rodrigues_parameters", np.float64, 1 + 2.0**-49)
    assert found > float(guarantee.units)


def test_the_cases_of_a_rotation_are_those_of_its_quaternion(book: Book) -> None:
    found = cases(book.made["euler_rodrigues_parameters"][1])
    assert len(found) == 4
    assert sum(len(case.truths) for case in found) == 2**6


@pytest.mark.parametrize("name", ["natural_invariants", "screw_of_motion"])
def test_comparisons_for_a_scale_choose_no_case(book: Book, name: str) -> None:
    found = cases(book.made[name][1])
    assert len(found) == 4
    assert all(len(case.outline.scales) == 1 for case in found)


def held_back(read: int, *, test: Op = Op.EQUAL) -> Program:
    """x / (y y - z z where that is not zero), and as a second result the divisor itself or another step."""
    build = Builder()
    x, y, z = (build.input(0, k) for k in range(3))
    form = build.subtract(build.multiply(y, y), build.multiply(z, z))
    plain = build.subtract(y, z)
    asked = build.equal(plain, build.zero) if test is Op.EQUAL else build.less(plain, build.zero)
    divisor = build.select(asked, build.zero, form)
    above = build.select(build.equal(divisor, build.zero), build.zero, x)
    results = Result("q", (), "", (build.divide(above, divisor),)), Result("r", (), "", ((plain, divisor)[read],))
    return Program("q", (Argument("x", (3,), ""),), build.steps, results)


def test_a_divisor_held_back_is_looked_through_where_it_is_but_divided_by() -> None:
    outline = outlined(held_back(0))
    assert not any(outline.program.steps[k].op is Op.SELECT for k in outline.needed)
    for other in (held_back(1), held_back(0, test=Op.LESS)):
        with pytest.raises(NoBound, match="chooses between cases"):
            outlined(other)


@pytest.mark.parametrize("finite", [True, False])
def test_what_is_no_number_is_looked_through_where_something_is_infinite(finite: bool) -> None:
    build = Builder()
    x, y = build.input(0, 0), build.input(0, 1)
    asked = build.equal(build.zero, build.subtract(x, x if finite else y))
    chosen = build.select(asked, y, build.not_a_number())
    program = Program("p", (Argument("x", (2,), ""),), build.steps, (Result("p", (), "", (chosen,)),))
    if finite:
        assert outlined(program).entries(0) == (y,)
    else:
        with pytest.raises(NoBound, match="chooses between cases"):
            outlined(program)


LARGEST = {
    "rotation_from_axis_angle": 8,
    "natural_rate_matrix": 6,
    "linear_rate_matrix": 6,
    "natural_velocity_matrix": 6,
}


@pytest.mark.parametrize("name", LARGEST)
def test_what_is_proved_is_what_is_asked_for(name: str) -> None:
    (guarantee,) = Bound.from_data(LISTED[name]["bound"]).guarantees
    assert guarantee.against == "largest"
    assert float(guarantee.units) <= LARGEST[name]


@pytest.mark.sampled(7)
@pytest.mark.parametrize("name", [name for name in LISTED if name not in COVERED])
def test_the_manifest_has_what_is_proved_by_counting(book: Book, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "flint", None)
    request, program = book.made[name]
    assert bound_of(program, request).as_data() == LISTED[name]["bound"]


@pytest.mark.sampled(7)
@pytest.mark.slow
@pytest.mark.parametrize("name", COVERED)
def test_the_manifest_has_what_is_proved_over_boxes(book: Book, name: str) -> None:
    pytest.importorskip("flint")
    request, program = book.made[name]
    (fresh,), (listed,) = (
        bound.guarantees for bound in (bound_of(program, request), Bound.from_data(LISTED[name]["bound"]))
    )
    assert (fresh.against, fresh.inputs) == (listed.against, listed.inputs)
    assert float(fresh.units) == pytest.approx(float(listed.units), abs=0.11)


def worst_found(book: Book, name: str, model: Model, point: list[Any], against: str) -> float:
    """The largest error, in units, that the worst machine makes at a point."""
    request, program = book.made[name]
    outline = outlined(program)
    inputs = [[CONTEXT.mpf(float(x)) for x in np.ravel(value)] for value in point]
    exact = exact_values(outline, inputs)
    worst = 0.0
    for places in proving._places(request)[0]:
        numbers = [outline.entries(0)[place] for place in places]
        largest = max(abs(exact[k].value) for k in numbers)
        for k in dict.fromkeys(numbers):
            value, got = worst_roundings(outline, inputs, model, k)
            size = largest if against == "largest" else exact[k].size
            worst = max(worst, float(abs(got - value) / size / float(model.roundoff)) if size else 0.0)
    return worst


UNIT = np.array([1.0, 3e-7, 2e-7])
WORST = {
    "rotation_from_axis_angle": [np.float32(UNIT), np.float32(math.pi) + np.float32(1e-6)],
    "natural_rate_matrix": [np.float32([2e-7, 0.7071068, 0.70710677]), np.float32(0.5)],
    "linear_rate_matrix": [np.float32([0.57735026, 0.57735026, 0.57735026]), np.float32(3.1)],
    "normal_matrix_inverse": [np.float32([0.57735026, 0.57735026, 0.57735026]), np.float32(0.0313)],
    "rotation_from_euler_xyz": [np.float32([0.53, 0.74, 0.6])],
}


@pytest.mark.sampled(5)
@pytest.mark.parametrize("name", WORST)
def test_no_machine_within_the_model_errs_by_more(book: Book, name: str) -> None:
    (guarantee,) = Bound.from_data(LISTED[name]["bound"]).guarantees
    found = worst_found(book, name, SINGLE, WORST[name], "largest")
    request, program = book.made[name]
    for point in points(request, program, np.float32, 6):
        found = max(found, worst_found(book, name, SINGLE, point, "largest"))
    assert 0.6 * float(guarantee.units) <= found <= float(guarantee.units)


def test_a_kernel_that_errs_by_more_is_found_out(book: Book) -> None:
    def careless(*arguments: Any) -> Any:
        return kernels.euler_rodrigues_rate_matrix(*arguments) * (1 + 8 * np.finfo(np.float64).eps)

    ((guarantee, found),) = compare(book, "euler_rodrigues_rate_matrix", careless, np.float64, 8)
    assert found > float(guarantee.units)


EXACT_FUNCTIONS = Model(SINGLE.roundoff, Fraction(0))


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("name", "point", "against"),
    [
        ("rotation_from_euler_xyz", [np.float32([0.53, 0.74, 0.6])], "largest"),
        ("euler_rodrigues_rate_matrix", [np.float32([0.6, 0.0, 0.8]), np.float32(0.9)], "itself"),
    ],
)
def test_a_bound_for_better_functions_does_not_hold(
    book: Book, name: str, point: list[Any], against: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("flint")
    monkeypatch.setattr(proving, "BOXES", 20_000)
    request, program = book.made[name]
    (guarantee,) = bound_of(program, request, EXACT_FUNCTIONS).guarantees
    assert worst_found(book, name, EXACT_FUNCTIONS, point, against) <= float(guarantee.units)
    assert worst_found(book, name, SINGLE, point, against) > float(guarantee.units)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", ["power", "rotation_from_axis_angle"])
def test_a_rounding_left_out_is_missed(book: Book, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("flint")
    request, program = book.made[name]
    # Products that are taken to be exact, in both kinds of proof.
    monkeypatch.setattr("chasles.bounds.running.Running._only_scales", lambda running, number: True)
    monkeypatch.setattr("chasles.bounds.termwise._after", lambda growth, loss: growth - 1 if growth > 1 else loss)
    (guarantee,) = bound_of(program, request).guarantees
    ones = np.full(6, np.float32(1 + 2**-20))
    point = {"power": [ones, ones], "rotation_from_axis_angle": WORST["rotation_from_axis_angle"]}[name]
    assert worst_found(book, name, SINGLE, point, guarantee.against) > float(guarantee.units)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", ["power", "inertia_about_point", "momentum_screw", "kinetic_energy"])
def test_counted_roundings_can_all_happen(book: Book, name: str) -> None:
    ones = [np.float32(1 + 2**-20 + np.zeros(a.shape)) for a in book.made[name][1].arguments]
    largest = [
        np.float32(-1 - 2**-21 * (1 + np.zeros(a.shape))) if a.name == "a" else x
        for a, x in zip(book.made[name][1].arguments, ones, strict=True)
    ]
    found = max(worst_found(book, name, SINGLE, point, "terms") for point in (ones, largest))
    assert found >= 0.5 * float(LISTED[name]["bound"]["guarantees"][0]["units"])


STEINER = (1.7801741e-06, 1.000772, [-2.353589e-07, -1.7214994e-07, -1.7630758e-07], [0.00391596, 1.0036025, 1.0006915])
ROWS = [[1.0000143, 1.000273, 1.0002564], [0.50128877, 0.5005953, 0.5002897], [1.0000281, 1.0003545, 1.0000799]]
SPIN, TURN = [1.0022944, 1.0005239, 0.015684912], [0.0004883028, 0.0004883196, 0.0004883382]


def test_four_roundoffs_are_too_few_for_the_inertia_about_a_point() -> None:
    size, m, c, a = STEINER
    inputs = [np.float32(size) * np.eye(3, dtype=np.float32), np.float32(m), np.float32(c), np.float32(a)]
    central, mass, *points_of = [np.asarray(x, np.float64) for x in inputs]
    d = points_of[1] - points_of[0]
    exact = central + mass * (d @ d * np.eye(3) - np.outer(d, d))
    error = abs(readable.inertia_about_point(*inputs) - exact).max() / abs(exact).max() * 2.0**24
    assert 4.5 < error <= float(LISTED["inertia_about_point"]["bound"]["guarantees"][0]["units"])


def test_four_roundoffs_are_too_few_for_the_wrench() -> None:
    nothing = np.zeros(3, np.float32)
    matrix, omega, omega_dot = (np.array(x, np.float32) for x in (ROWS, SPIN, TURN))
    wrench = readable.newton_euler_wrench(
        matrix, np.float32(1), np.concatenate((omega, nothing)), np.concatenate((omega_dot, nothing))
    )
    inertia, spin, turn = (x.astype(np.float64) for x in (matrix, omega, omega_dot))
    momentum = inertia @ spin
    terms = inertia[0] @ turn + spin[1] * momentum[2] + spin[2] * momentum[1]
    exact = inertia[0] @ turn + spin[1] * momentum[2] - spin[2] * momentum[1]
    error = abs(float(wrench[0]) - exact) / terms * 2.0**24
    assert 4.5 < error <= float(LISTED["newton_euler_wrench"]["bound"]["guarantees"][0]["units"])


def test_what_holds_for_single_precision_holds_for_double(book: Book) -> None:
    for name in ("plucker_line", "natural_rate_matrix_dot", "screw_axis_point"):
        outline = outlined(book.made[name][1])
        single, double = (
            [share.error / model.roundoff for share in termwise_errors(outline, model).values()]
            for model in (SINGLE, DOUBLE)
        )
        assert all(y <= x for x, y in zip(single, double, strict=True))


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", ["rotation_from_axis_angle", "natural_rate_matrix", "rotation_from_euler_zyx"])
def test_changes_of_sign_that_stand_for_each_other_have_one_bound(book: Book, name: str) -> None:
    pytest.importorskip("flint")
    request, program = book.made[name]
    outline = outlined(program)
    cover = covered(outline, proving._units(request))
    measure = against(outline)
    found: dict[object, float] = {}
    for pieces in product(*cover.choices):
        signs = cover.symmetry.canonical([sign for piece in pieces for sign in piece.negative])
        low, high = [], []
        for place, (start, end) in zip((0.3, 0.6, 0.4, 0.7), (x for p in pieces for x in p.ranges), strict=False):
            part = place if abs(end) >= abs(start) else 0.95 - place
            low.append(start + part * (end - start))
            high.append(start + (part + 0.05) * (end - start))
        (bound,) = bounds_of(outline, measure, pieces, np.array([low]), np.array([high]))
        key = signs, *(piece.kind for piece in pieces)
        assert found.setdefault(key, float(bound)) == pytest.approx(float(bound), rel=1e-6)
    assert len(found) < 200


def bounds_of(outline: Outline, measure: Any, region: tuple[Any, ...], low: Any, high: Any) -> Any:
    boxes = Boxes((region,), np.zeros(1, np.intp), low, high)
    return bounds_over(boxes, outline, SINGLE, measure)[0]


def against(outline: Outline) -> Callable[[Any, float], Any]:
    """The error of the first result, relative to its largest entry."""
    groups = [outline.entries(0)]
    return lambda running, enough: against_largest(running, groups, SINGLE.roundoff, enough)


def program(*steps: Step) -> Program:
    """A program of x and y with the last step for a result."""
    arguments = Argument("x", (), "x"), Argument("y", (), "y")
    return Program("made", arguments, steps, (Result("z", (), "z", (len(steps) - 1,)),))


X, Y, ZERO = Step(Op.INPUT), Step(Op.INPUT, argument=1), Step(Op.CONSTANT)
EQUAL = Step(Op.EQUAL, (1, 2))


def test_a_guard_of_a_division_is_looked_through() -> None:
    guarded = program(X, Y, ZERO, EQUAL, Step(Op.SELECT, (3, 2, 0)), Step(Op.DIVIDE, (4, 1)))
    assert termwise_errors(outlined(guarded), SINGLE)[5].error == SINGLE.roundoff


@pytest.mark.parametrize(
    ("steps", "reason"),
    [
        ((X, Y, ZERO, Step(Op.LESS, (1, 2)), Step(Op.SELECT, (3, 2, 0)), Step(Op.DIVIDE, (4, 1))), "cases"),
        ((X, Y, ZERO, EQUAL, Step(Op.SELECT, (3, 1, 0)), Step(Op.DIVIDE, (4, 1))), "cases"),
        ((X, Y, ZERO, EQUAL, Step(Op.SELECT, (3, 2, 0)), Step(Op.DIVIDE, (4, 0))), "cases"),
        ((X, Y, ZERO, EQUAL, Step(Op.SELECT, (3, 2, 0)), Step(Op.MULTIPLY, (4, 1))), "cases"),
        ((X, Y, Step(Op.MULTIPLY, (0, 1)), Step(Op.SINE, (2,))), "angle"),
        ((X, Y, Step(Op.MULTIPLY, (0, 1)), Step(Op.SUBTRACT, (2, 0)), Step(Op.DIVIDE, (0, 3))), "divides"),
        ((X, Y, Step(Op.MULTIPLY, (0, 1)), Step(Op.SQUARE_ROOT, (2,))), "root"),
    ],
)
def test_what_cannot_be_bounded_is_refused(steps: tuple[Step, ...], reason: str) -> None:
    with pytest.raises(NoBound, match=reason):
        termwise_errors(outlined(program(*steps)), SINGLE)


def test_bounds_are_remembered_by_what_they_depend_on(book: Book) -> None:
    known = remembered(MANIFEST)
    for name, (request, made) in book.made.items():
        assert known[key_of(made, request)].as_data() == LISTED[name]["bound"]
    request, made = book.made["power"]
    steps = tuple(with_fields(s, op=Op.SUBTRACT) if s.op is Op.ADD else s for s in made.steps)
    assert key_of(with_fields(made, steps=steps), request) not in known
    assert key_of(made, request, Model(SINGLE.roundoff, Fraction(2))) not in known


@pytest.mark.parametrize(
    "text",
    [
        "",
        "kernels = 3",
        "[kernels",
        "[kernels.a]\nbound = {}",
        '[kernels.a]\nbound = { program = "a", reason = "", guarantees = [] }',
        '[kernels.a]\nbound = { program = "a", reason = "", guarantees = [{ result = "x" }] }',
        '[kernels.a]\nbound = { program = "a", reason = "", guarantees = '
        '[{ result = "x", against = "itself", units = "-1", inputs = "all" }] }',
    ],
)
def test_a_damaged_manifest_remembers_nothing(text: str) -> None:
    assert remembered(text) == {}


def test_a_new_bound_asks_for_flint(book: Book, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    entries = [entry for entry in load() if entry.name == "rotation_from_axis_angle"]
    monkeypatch.setattr(proving, "covered", missing)
    with pytest.raises(Failure, match=r"rotation_from_axis_angle .* pip install 'chasles\[fast\]'"):
        emission.commissioned(entries, Session(), tmp_path)
    (tmp_path / "MANIFEST.toml").write_text(MANIFEST, "utf-8")
    ((kernel,), _) = emission.commissioned(entries, Session(), tmp_path)
    assert kernel.bound is not None
    assert kernel.bound.as_data() == LISTED["rotation_from_axis_angle"]["bound"]


def missing(*_: Any) -> None:
    raise ModuleNotFoundError("No module named 'flint'", name="flint")


def test_heads_say_what_is_proved() -> None:
    files = sorted((Path(generated.__file__).parent / "c/src").glob("section_*.c"))
    said = " ".join("".join(path.read_text("utf-8") for path in files).replace("*", " ").split())
    assert "error bound 6.0 u of the largest entry, for every unit e and every phi; u = 2^-53" in said
    assert "supposed: every operation rounded to nearest, with or without FMA, sine and cosine within 0.8 ulp" in said
    assert "times the condition of its divisor" in said
    assert "u of the largest entry" in (kernels.rotation_from_axis_angle.__doc__ or "")


def place_of(
    e: np.ndarray[Any, Any], phi: float, least: Fraction
) -> tuple[int, tuple[int, ...], int, int, list[float]]:
    """The face, the signs, the quarter and the side on which inputs lie, and their coordinates there."""
    axis = int(np.argmax(abs(e)))
    signs = tuple(1 if x >= 0 else -1 for x in e)
    quarter = math.floor(phi * float(least) / (math.pi / 2) + 0.5)
    t = phi / math.pi - quarter / 2 / float(least)
    coordinates = [float(e[k] / abs(e[axis])) for k in range(3) if k != axis]
    return axis, signs, quarter % 4, 1 if t >= 0 else -1, [*coordinates, abs(t)]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", ["rotation_from_axis_angle", "natural_rate_matrix", "linear_rate_matrix"])
def test_every_input_lies_in_a_piece_and_none_is_worse_than_proved(book: Book, name: str) -> None:
    pytest.importorskip("flint")
    request, program = book.made[name]
    outline = outlined(program)
    cover = covered(outline, proving._units(request))
    (guarantee,) = Bound.from_data(LISTED[name]["bound"]).guarantees
    generator = np.random.default_rng(5)
    factor = next(iter(outline.angles.values()))[2]
    for n in range(60):
        e = np.array(AXES[n % len(AXES)]) if n % 2 else generator.standard_normal(3)
        e = e / np.linalg.norm(e)
        phi = float(generator.choice(ANGLES)) if n % 3 else float(generator.uniform(-9, 9))
        axis, signs, quarter, side, box = place_of(e, phi, factor)
        if not box[2]:
            continue
        near = name == "natural_rate_matrix" and box[2] < NEAR
        ((face, turn),) = (
            pieces
            for pieces in product(*cover.choices)
            if (pieces[0].axis, pieces[0].signs, pieces[1].quarter, pieces[1].side) == (axis, signs, quarter, side)
            and pieces[1].near == near
        )
        halvings = math.floor(math.log2(NEAR / box[2])) if near else 0
        box[2] *= 2.0**halvings
        ranges = [*face.ranges, *turn.ranges]
        assert all(low - 1e-12 <= x <= high + 1e-12 for x, (low, high) in zip(box, ranges, strict=True))
        inner = np.array([min(max(x, low), high) for x, (low, high) in zip(box, ranges, strict=True)])
        values = face_values(axis, signs[axis], (Interval(*inner[[0, 0], None]), Interval(*inner[[1, 1], None])))
        for k in range(3):
            assert values[k].low[0] - 1e-9 <= e[k] <= values[k].high[0] + 1e-9
        for found, function in zip(turn.functions(factor)(inner[2], inner[2]), (math.sin, math.cos), strict=True):
            power, low, high = found
            value = function(float(factor) * phi) * 2.0 ** (halvings * power)
            assert low - 1e-12 <= value <= high + 1e-12
        (bound,) = bounds_of(outline, against(outline), (face, turn), inner[None, :], inner[None, :])
        assert bound <= float(guarantee.units) + 0.5 * near


def test_a_root_is_bounded_over_boxes_as_it_is_by_counting() -> None:
    pytest.importorskip("flint")
    cosine, one = Step(Op.COSINE, (0,)), Step(Op.CONSTANT, value=Fraction(1))
    steps = (X, cosine, Step(Op.MULTIPLY, (1, 1)), one, Step(Op.ADD, (2, 3)), Step(Op.SQUARE_ROOT, (4,)))
    outline = outlined(program(*steps))
    counted = float(termwise_errors(outline, SINGLE)[5].error / SINGLE.roundoff)
    found = largest(
        outline,
        SINGLE,
        covered(outline, ()),
        lambda running, enough: against_largest(running, [(5,)], SINGLE.roundoff, enough),
        2000,
    )
    worst = 0.0
    for angle in np.linspace(0.01, 3.2, 40):
        value, got = worst_roundings(outline, [[CONTEXT.mpf(float(angle))], [CONTEXT.mpf(1)]], SINGLE, 5)
        worst = max(worst, float(abs(got / value - 1) / float(SINGLE.roundoff)))
    assert worst <= found <= counted
    assert found <= 1.5 * worst


@pytest.mark.parametrize("loss", [0.0, 1e-3])
def test_an_angle_moves_no_more_than_the_ratio_of_coordinates(loss: float) -> None:
    error = float(termwise_errors(outlined(program(X, Y, Step(Op.ARCTANGENT2, (0, 1)))), SINGLE)[2].error)
    assert error == float(SINGLE.loss(Op.ARCTANGENT2))
    for angle in np.linspace(-3.1, 3.1, 63):
        moved = math.atan2(math.sin(angle) * (1 + loss), math.cos(angle) * (1 - loss))
        assert abs(moved - angle) <= abs(angle) * ((1 + loss) / (1 - loss) - 1) + 1e-15
