"""The checked kernels: valid inputs give the kernel's own bits, and what breaks a hypothesis is named."""

from __future__ import annotations

import re
import subprocess
import sys
from typing import Any

import numpy as np
import pytest
from chasles.generated.numpy.hypotheses import KERNELS
from scipy.spatial.transform import Rotation

from chasles import checked, kernels
from chasles.checked.hypotheses import TESTS
from chasles.kernels import written_out
from chasles.statements import load
from chasles.targets.commission import kernel_of
from chasles.targets.kernel import TESTED, Demand

from .decided import chapter_session
from .sampling import sample

BATCH = 4
WHERE = 2
DEMANDS = [(name, demand) for name, (_, demands) in KERNELS.items() for demand in demands]
EQUATIONS = [(name, demand) for name, demand in DEMANDS if demand[0] != "nonzero"]
DIVISORS = [(name, demand) for name, demand in DEMANDS if demand[0] == "nonzero"]
SIX = [0, 1, 2, 4, 5, 8]

# What makes a divisor vanish: values of those arguments that there are. None where no float does.
VANISHING = {
    "phi != 0": {"phi": 0.0, "Q": np.eye(3)},
    "p_1 != p_2": {"p_1": (1.0, 2.0, 3.0), "p_2": (1.0, 2.0, 3.0)},
    "omega != 0": {"omega": (0.0, -0.0, 0.0)},
    "f != 0": {"f": (0.0, 0.0, 0.0)},
    "1 + q_0 != 0": {"q": (0.0, 0.0, 0.0), "q_0": -1.0},
    "sin(theta_2) != 0": {"angles": (0.3, -0.0, 0.4)},
    "cos(theta_2) != 0": None,
    "phi != pi": None,
}


def valid(name: str, generator: np.random.Generator) -> dict[str, np.ndarray]:
    """A batch of inputs that satisfies all that is demanded."""
    inputs, demands = KERNELS[name]
    values = {word: generator.standard_normal((BATCH, *core)) + 0.1 for word, core in inputs}
    for kind, _, words, _ in demands:
        for word, value in zip(words, made(kind, [values[word] for word in words], generator), strict=True):
            values[word] = value
    return values


def made(kind: str, values: list[np.ndarray], generator: np.random.Generator) -> list[np.ndarray]:
    match kind:
        case "unit" | "unit column":
            whole = np.concatenate([value.reshape(BATCH, -1) for value in values], axis=1)
            size = np.linalg.norm(whole, axis=1)
            return [value / size.reshape(BATCH, *(1,) * (value.ndim - 1)) for value in values]
        case "rotation":
            return [Rotation.random(BATCH, random_state=generator).as_matrix() for _ in values]
        case "positive":
            return [np.abs(value) + 0.5 for value in values]
        case "symmetric":
            return [value + np.swapaxes(value, -1, -2) for value in values]
        case "definite":
            root = generator.standard_normal((BATCH, 3, 3))
            matrix = root @ np.swapaxes(root, -1, -2) + np.eye(3)
            return [matrix if value.shape[1:] == (3, 3) else matrix.reshape(BATCH, 9)[:, SIX] for value in values]
    return values


def breaking(kind: str, value: np.ndarray) -> list[np.ndarray]:
    """Values of one item that break a hypothesis."""
    match kind:
        case "unit" | "unit column":
            return [value * (1 + 1e-6), value * 1e200]
        case "rotation":
            return [value * (1 + 1e-6), -value, value[[1, 0, 2]], value * 0]
        case "positive":
            return [value * 0, -value]
        case "symmetric":
            return [value + 1e-6 * np.abs(value).max() * np.eye(3, k=1)]
        case "definite":
            return [-value, value * 0]
    raise AssertionError(kind)


def called(name: str, values: dict[str, np.ndarray], **options):
    return getattr(checked, name)(*values.values(), **options)


def bits(returned: object) -> list[bytes]:
    return [np.asarray(part).tobytes() for part in (returned if isinstance(returned, tuple) else (returned,))]


def labelled(item: object) -> str:
    return item if isinstance(item, str) else item[1]


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("name", KERNELS)
def test_valid_inputs_give_the_same_bits(name: str, dtype: type) -> None:
    values = {word: value.astype(dtype) for word, value in valid(name, np.random.default_rng(7)).items()}
    expected = getattr(kernels, name)(*values.values())
    assert bits(called(name, values)) == bits(expected)
    first = [value[0] for value in values.values()]
    assert bits(getattr(checked, name)(*first)) == bits(getattr(kernels, name)(*first))


@pytest.mark.parametrize(("name", "demand"), EQUATIONS, ids=labelled)
def test_each_hypothesis_is_tested(name: str, demand: tuple) -> None:
    kind, text, words, _ = demand
    values = valid(name, np.random.default_rng(8))
    good = values[words[0]].copy()
    for bad in breaking(kind, good[WHERE]):
        values[words[0]] = good.copy()
        values[words[0]][WHERE] = values[words[0]][WHERE + 1] = bad
        with pytest.raises(ValueError, match=rf"^{name}: {', '.join(words)} at index \({WHERE},\): ") as caught:
            called(name, values)
        assert text in str(caught.value)


@pytest.mark.parametrize(("name", "demand"), DIVISORS, ids=labelled)
def test_what_must_not_vanish_is_tested(name: str, demand: tuple) -> None:
    _, text, words, divisor = demand
    values = valid(name, np.random.default_rng(9))
    if VANISHING[text] is None:
        values[words[0]] = np.full_like(values[words[0]], np.pi if "pi" in text else np.pi / 2)
        with np.errstate(all="ignore"):
            expected = getattr(kernels, name)(*values.values())
        if not np.isnan(expected).any():
            assert bits(called(name, values)) == bits(expected)
        return
    for word in VANISHING[text].keys() & values.keys():
        values[word][WHERE] = VANISHING[text][word]
    assert divisor(*(values[word] for word in words))[WHERE] == 0
    message = re.escape(f"{name}: {', '.join(words)} at index ({WHERE},): {text} does not hold")
    with pytest.raises(ValueError, match=message):
        called(name, values)


@pytest.mark.parametrize("name", KERNELS)
def test_shapes_and_numbers_are_tested(name: str) -> None:
    inputs = KERNELS[name][0]
    for word, core in inputs:
        values = valid(name, np.random.default_rng(10))
        whole = values[word].copy()
        for bad in (np.nan, np.inf, -np.inf):
            values[word] = whole.copy()
            values[word].reshape(BATCH, -1)[WHERE, -1] = bad
            with pytest.raises(ValueError, match=rf"^{name}: {word} at index \({WHERE},\): all entries are finite"):
                called(name, values)
        if core:
            values[word] = whole[..., :-1]
            with pytest.raises(ValueError, match=rf"^{name}: {word} must have the shape \(\.\.\., {core[0]}"):
                called(name, values)
        values[word] = whole.astype(complex)
        with pytest.raises(TypeError, match=rf"^{name}: {word} must hold real numbers"):
            called(name, values)
        values[word] = np.concatenate([whole, whole])
        if len(inputs) > 1:
            with pytest.raises(ValueError, match=rf"^{name}: the batch axes"):
                called(name, values)
    with pytest.raises(TypeError, match=f"^{name} takes {len(inputs)} inputs"):
        getattr(checked, name)()


def test_where_an_input_is_spread_over_a_batch_its_own_index_is_told() -> None:
    axes = [[[0.0, 0.0, 1.0]], [[0.0, 0.0, 2.0]]]
    with pytest.raises(ValueError, match=r"e at index \(1, 0\): \|e\| = 1 does not hold"):
        checked.rotation_from_axis_angle(axes, np.zeros(5))
    with pytest.raises(ValueError, match=r"e: \|e\| = 1 does not hold"):
        checked.rotation_from_axis_angle([0, 0, 2], 1)
    with pytest.raises(ValueError, match=r"phi at index \(1,\): phi != 0 does not hold"):
        checked.natural_rate_matrix([[[0.0, 0.0, 1.0]], [[1.0, 0.0, 0.0]]], [1.0, 0.0, 2.0])
    with pytest.raises(ValueError, match=r"phi: phi != 0 does not hold"):
        checked.natural_rate_matrix([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]], 0.0)


def test_half_of_the_digits_are_enough() -> None:
    for dtype, near, far in ((np.float64, 7e-9, 8e-9), (np.float32, 1.7e-4, 1.8e-4)):
        e = np.array([0, 0, 1], dtype)
        checked.rotation_from_axis_angle(e * dtype(1 + near), dtype(1))
        with pytest.raises(ValueError, match="is allowed"):
            checked.rotation_from_axis_angle(e * dtype(1 + far), dtype(1))


def test_nothing_is_stored_if_something_does_not_hold() -> None:
    out = np.full((2, 4, 3), 7.0)
    with pytest.raises(ValueError, match="phi != 0"):
        checked.natural_rate_matrix([0.0, 0.0, 1.0], [1.0, 0.0], out=out)
    assert (out == 7).all()
    checked.natural_rate_matrix([0.0, 0.0, 1.0], [1.0, 2.0], out=out)
    assert (out != 7).all()


@pytest.mark.parametrize(
    ("bad", "error"), [([[0.0, 1.0], [2.0]], ValueError), ("abc", TypeError), (None, TypeError), ([{}] * 3, TypeError)]
)
def test_what_is_no_array_of_numbers_is_named(bad: object, error: type[Exception]) -> None:
    with pytest.raises(error, match=r"^rotation_from_axis_angle: e "):
        checked.rotation_from_axis_angle(bad, 1.0)


def test_an_empty_batch_passes() -> None:
    assert checked.rotation_from_axis_angle(np.empty((0, 3)), np.empty(0)).shape == (0, 3, 3)


@pytest.mark.skipif(kernels.backend != "c", reason="these options are a ufunc's")
def test_options_of_a_ufunc_pass() -> None:
    down = np.array([[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]])
    found = checked.rotation_from_axis_angle(down, [0.5, 0.6], axes=[(0,), (), (0, 1)], dtype=np.float32)
    assert found.shape == (3, 3, 2)
    assert found.dtype == np.float32
    with pytest.raises(ValueError, match=r"e at index \(1,\): \|e\| = 1"):
        checked.rotation_from_axis_angle(down * [1, 2], [0.5, 0.6], axes=[(0,), (), (0, 1)])


def test_the_identity_has_no_axis() -> None:
    """Where the plain kernel says so by NaN beside the angle 0, the checked one names the hypothesis that is broken."""
    with np.errstate(invalid="ignore"):
        e, phi = kernels.natural_invariants(np.eye(3))
    assert np.isnan(e).all()
    assert phi == 0
    with pytest.raises(ValueError, match="natural_invariants: Q: phi != 0 does not hold: the kernel has no value"):
        checked.natural_invariants(np.eye(3))


def test_importing_needs_no_sympy() -> None:
    code = (
        "import sys; from chasles import checked; checked.power([0.0] * 6, [0.0] * 6); sys.exit('sympy' in sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_an_unknown_kernel_is_no_attribute() -> None:
    with pytest.raises(AttributeError, match="'no_such'"):
        _ = checked.no_such


@pytest.mark.slow
def test_every_hypothesis_of_a_kernel_is_tested_or_has_a_stand_in() -> None:
    """What is assumed of symbols that are no arguments is expected of the arguments in other words."""
    session, silent = chapter_session(), []
    pairs = [(entry, kernel) for entry in load() for kernel in entry.kernels]
    known = [pair for pair in pairs if (pair[1].name or pair[0].name) == "angular_acceleration_matrix"]
    for entry, kernel in dict.fromkeys([*sample(pairs, 4), *known]):
        emitted = kernel_of(entry, session.decide, kernel)
        tested = {demand.text for demand in emitted.demands}
        if not tested.issuperset(emitted.heading.hypotheses) and not emitted.heading.expected:
            silent.append(emitted.name)
    assert silent == ["angular_acceleration_matrix"]


def test_all_kinds_have_a_test() -> None:
    assert {*TESTS} | {"nonzero"} == {*TESTED}
    with pytest.raises(ValueError, match="no test of arguments knows the hypothesis 'half_turn'"):
        Demand("half_turn", "Q is a half-turn", ("Q",))


MASKED = np.ma.array([[0, 0, 1.0], [0, 1.0, 0]], mask=[[0, 0, 0], [0, 1, 0]])


@pytest.mark.parametrize("inputs", [(MASKED, 0.5), (MASKED[0], 0.5), ([0, 0, 1.0], np.ma.array([0.5]))])
@pytest.mark.parametrize("module", [kernels, checked, written_out()])
def test_masked_arrays_are_refused(module: Any, inputs: tuple[Any, ...]) -> None:
    """NumPy would give the rotations the masks of the axes."""
    with pytest.raises(ValueError, match=r"rotation_from_axis_angle: (e|phi) is a masked array: hand over its numbers"):
        module.rotation_from_axis_angle(*inputs)


@pytest.mark.parametrize("inputs", [(MASKED, np.ones(2)), (np.ones((2, 3)), np.ma.array([0.5, 1.0]))])
def test_masked_arrays_are_refused_by_light_functions(inputs: tuple[Any, ...]) -> None:
    with pytest.raises(ValueError, match=r"rotation_from_axis_angle: (e|phi) is a masked array"):
        kernels.one.rotation_from_axis_angle(*inputs)
