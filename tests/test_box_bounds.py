"""The error bound of a user's own expression, over a box of inputs: never less than what is found at a float of it."""

from __future__ import annotations

import sys
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp

import chasles
from chasles.bounds.box import bound_of_program
from chasles.bounds.outline import NoBound
from chasles.compiling.derived import derived_from
from chasles.compiling.inputs import inputs_of
from chasles.compiling.program_of import program_of
from chasles.compiling.results import outputs_of
from chasles.lowering.arithmetic import decimals, run
from chasles.lowering.program import Program

x, y, z = sp.symbols("x y z")
v = sp.Matrix(sp.symbols("v1:4"))
EXACT = decimals(60)
CONTEXT = mpmath.MPContext()
CONTEXT.dps = 60


@pytest.fixture(autouse=True)
def as_numpy(monkeypatch: pytest.MonkeyPatch) -> None:
    """The bound is of the program: nothing has to be compiled for it."""
    monkeypatch.setenv("CC", "no-such-compiler")


def made(expression: Any, inputs: Any, *kinds: str) -> Program:
    given = inputs_of(inputs)
    outputs = outputs_of(expression, given, None)
    return program_of("made", given, outputs, derived_from(given, outputs, kinds))


BOXES = [
    (x * y + 1, (x, y), {"x": (0, 1), "y": (2, 3)}),
    (sp.sin(x) / x, (x,), {"x": (0.1, 1)}),
    (sp.sqrt(x**2 + y**2), (x, y), {"x": (1, 2), "y": (-3, 1)}),
    (sp.sqrt(x), (x,), {"x": (0, 2)}),
    (sp.Abs(x - y) + sp.Max(x * y, y), (x, y), {"x": (-1, 2), "y": (-3, 1)}),
    (sp.Piecewise((x * sp.Rational(21, 10), x < 1), (x**2, True)), (x,), {"x": (-1, 2)}),
    (sp.atan2(y, x) + sp.tan(x), (x, y), {"x": (-1, 1), "y": (1, 2)}),
    (sp.Matrix([[sp.cos(x), -sp.sin(x)], [sp.sin(x), sp.cos(x)]]), (x,), {"x": (-50, 50)}),
    (v / v.norm(), (v,), {"v": (np.array([1, -2, 0.5]), np.array([2, -1, 3]))}),
    ((x - y) * (x + y) / 3, (x, y), {"x": 1.5, "y": (1, 2)}),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize(("expression", "inputs", "box"), BOXES)
def test_no_float_of_a_box_errs_by_more_than_is_proved(expression: Any, inputs: Any, box: Any, dtype: Any) -> None:
    absolute, largest = proved_and_found(expression, inputs, box, dtype)
    assert absolute <= 12 * largest


def proved_and_found(expression: Any, inputs: Any, box: Any, dtype: Any) -> tuple[float, float]:
    """The largest error that is proved and that is found, where no entry has more than is proved of it."""
    pytest.importorskip("flint")
    kernel = chasles.compile(expression, inputs)
    bound = kernel.error_bound(box, dtype)
    absolute = bound["result"].absolute
    generator = np.random.default_rng(2)
    largest = np.zeros_like(absolute)
    for _ in range(60):
        point = []
        for argument in kernel.program.arguments:
            given = box[argument.name]
            low, high = given if isinstance(given, tuple) else (given, given)
            drawn = np.broadcast_to(low + generator.random(argument.shape) * (np.asarray(high) - low), argument.shape)
            point.append(np.clip(drawn.astype(dtype), np.asarray(low, dtype), np.asarray(high, dtype)))
        exact = run(kernel.program, [[CONTEXT.mpf(float(e)) for e in np.ravel(p)] for p in point], EXACT)[0]
        got = np.ravel(np.asarray(kernel(*(p[()] for p in point)), dtype))
        gaps = [float(abs(CONTEXT.mpf(float(a)) - b)) for a, b in zip(got, exact, strict=True)]
        assert (np.array(gaps) <= absolute.ravel()).all()
        largest = np.maximum(largest, np.reshape(gaps, absolute.shape))
    return float(absolute.max()), float(largest.max())


def test_a_bound_says_what_it_holds_for() -> None:
    bound = bound_of_program(made(x * y, (x, y)), {"x": (1, 2), "y": 3}, np.float32)
    assert bound["result"].absolute == pytest.approx(2.0**-22)
    assert 1 <= bound["result"].units <= 1.1
    assert str(bound).endswith("for x in [1, 2], y = 3; u = 2^-24")
    with pytest.raises(KeyError, match="the results are result"):
        bound["other"]


def test_underflow_is_no_way_out() -> None:
    bound = bound_of_program(made(x * y, (x, y)), {"x": (0, 1e-160), "y": (0, 1e-160)})
    assert 5e-324 <= bound["result"].absolute <= 1e-323


@pytest.mark.parametrize(
    ("expression", "box", "said"),
    [
        (
            1 / x,
            {"x": (-1, 2)},
            r"made: no error bound is proved for x in \[-1, 2\]: it divides by what may be zero",
        ),
        (sp.sqrt(x - 1), {"x": (0, 2)}, "root of what may be zero or negative, x near"),
        (x**7, {"x": (0, 1e60)}, "numbers are too large, x near"),
        (x, {"z": (0, 1)}, "the box must give a range to each of x; it lacks x"),
        (x, {"x": (0, 1), "z": (0, 1)}, "there is no argument 'z'"),
        (x, {"x": (2, 1)}, "finite ends, the lower one first"),
        (x, {"x": (0, np.inf)}, "finite ends"),
        (x, {"x": ("a", 1)}, r"x must be a pair \(low, high\) of numbers"),
        (x, {"x": (1, 2, 3)}, "pair"),
    ],
)
def test_what_cannot_be_bounded_is_named(expression: Any, box: Any, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        bound_of_program(made(expression, (x,)), box)


def test_other_precisions_are_refused() -> None:
    with pytest.raises(ValueError, match="float64 and float32"):
        bound_of_program(made(x, (x,)), {"x": (0, 1)}, np.int64)


def test_the_angle_jumps() -> None:
    pytest.importorskip("flint")
    with pytest.raises(NoBound, match="where the angle jumps"):
        bound_of_program(made(sp.atan2(y, x), (x, y)), {"x": (-2, -1), "y": (-1, 1)})


def test_a_choice_that_rounding_may_change_is_bounded_by_how_far_the_cases_are_apart() -> None:
    apart = sp.Piecewise((x, x * y < 1), (x + 1, True))
    bound = bound_of_program(made(apart, (x, y)), {"x": (0.9, 1.1), "y": (0.9, 1.1)})
    assert 1 <= bound["result"].absolute <= 1.3
    same = bound_of_program(made(sp.Max(x * y, x), (x, y)), {"x": (0.9, 1.1), "y": (0.9, 1.1)})
    assert same["result"].absolute <= 2.0**-51


def test_sines_need_flint_and_say_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "flint", None)
    with pytest.raises(ModuleNotFoundError, match=r"pip install 'chasles\[fast\]'"):
        chasles.compile(sp.sin(x), x).error_bound({"x": (0, 1)})
    assert chasles.compile(x * x, x).error_bound({"x": (0, 1)})["result"].absolute <= 2.0**-52


def test_a_rounding_left_out_is_missed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("chasles.bounds.running.Running._only_scales", lambda running, number: True)
    expression, inputs, box = (x - y) * (x + y), (x, y), {"x": (1, 2), "y": (1, 2)}
    with pytest.raises(AssertionError):
        test_no_float_of_a_box_errs_by_more_than_is_proved(expression * x * y * x * y, inputs, box, np.float32)


OF_LIBM = [
    (sp.exp(x) * x, {"x": (-1, 2)}),
    (sp.log(1 + x**2), {"x": (0.5, 2)}),
    (sp.log(1 + x), {"x": (0.1, 2)}),
    (x ** sp.Rational(7, 3), {"x": (0.5, 2)}),
    (x ** (x + 1), {"x": (0.5, 3)}),
    (sp.cbrt(x), {"x": (0.5, 9)}),
    (sp.sinh(x) - sp.cosh(2 * x), {"x": (-2, 1)}),
    (sp.tanh(3 * x) + sp.asinh(x), {"x": (0.1, 2)}),
    (sp.acosh(x) + sp.atanh(1 / x), {"x": (1.5, 3)}),
    (sp.erf(x) + sp.erfc(2 * x), {"x": (-1, 1)}),
    (sp.gamma(x), {"x": (2, 4)}),
    (sp.Abs(sp.exp(x) - 2), {"x": (0, 2)}),
    (sp.asin(x) - sp.acos(x**2), {"x": (-0.5, 0.5)}),
    ((1 - sp.cos(x)) / x**2, {"x": (0.5, 2)}),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize(("expression", "box"), OF_LIBM, ids=lambda each: str(each).replace(" ", ""))
def test_functions_of_libm_err_by_no_more_than_is_proved(expression: Any, box: Any, dtype: Any) -> None:
    absolute, largest = proved_and_found(expression, (x,), box, dtype)
    # The C library's manual grants the gamma function ten units in the last place.
    assert absolute <= 40 * largest


@pytest.mark.parametrize(
    ("expression", "box"),
    [(sp.log(x), (0, 1)), (x ** sp.Rational(1, 3), (-1, 1)), (sp.acosh(x), (0.5, 2)), (sp.gamma(x), (-1.5, 1))],
)
def test_where_a_function_has_no_value_nothing_is_proved(expression: Any, box: Any) -> None:
    pytest.importorskip("flint")
    with pytest.raises(NoBound, match=r"x near"):
        bound_of_program(made(expression, (x,)), {"x": box})
