"""The emitted kernels on arrays that are not NumPy's: the array API's referee, JAX and PyTorch.

What array-api-strict does not know no library has to know: it lets nothing but the standard through, no mixing of
devices, no promotion between kinds of numbers.
"""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Iterator
from typing import Any

import array_api_strict as strict
import numpy as np
import pytest

from chasles import compile as compiled
from chasles import kernels
from chasles.kernels import array_api

AXIS = np.array([0.6, 0.0, 0.8])
NAMES = dir(array_api)
BATCH = 5
PHI_GIVES_NAN = (
    "pitch_of_motion",
    "normal_matrix_inverse",
    "screw_axis_point",
    "natural_rate_matrix",
    "natural_rate_matrix_dot",
    "natural_velocity_matrix_dot",
    "pose_rate_natural",
    "pose_acceleration_natural",
)
"""At phi = 0 some entries of these have no limit."""


def inputs_of(name: str, phi: Any, dtype: Any = np.float64) -> dict[str, np.ndarray]:
    """Inputs of a kernel by their names: a batch with unit axes, rotations through phi and anything for the rest."""
    function = getattr(array_api, name)
    called = [p for p in inspect.signature(function).parameters if p != "out"]
    found = re.search(r"signature +(\S+)->", function.__doc__)
    assert found
    shapes = [tuple(map(int, re.findall(r"\d", core))) for core in re.findall(r"\(([\d,]*)\)", found[1])]
    random = np.random.default_rng(len(name))
    turned = np.broadcast_to(np.asarray(phi, dtype=float), (BATCH,))
    drawn = {}
    for argument, shape in zip(called, shapes, strict=True):
        values = random.standard_normal((BATCH, *shape))
        if argument == "phi":
            values = turned
        elif argument == "e":
            values = np.broadcast_to(AXIS, (BATCH, 3))
        elif argument == "Q":
            values = np.asarray(array_api.rotation_from_axis_angle(AXIS, turned))
        elif argument == "I_C" and shape == (3, 3):
            values = values @ values.swapaxes(-1, -2) + np.eye(3)
        drawn[argument] = np.array(values, dtype=dtype)
    return drawn


def parts(result: Any) -> tuple[Any, ...]:
    return result if isinstance(result, tuple) else (result,)


@pytest.mark.parametrize("dtype", ["float64", "float32"])
def test_the_referee_of_the_array_api_lets_every_kernel_pass(dtype: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise AssertionError("nothing is written in place: else it could not be traced")

    monkeypatch.setattr(type(strict.zeros(1)), "__setitem__", refuse)
    kind, device = getattr(strict, dtype), strict.Device("device1")
    for name in NAMES:
        given = inputs_of(name, np.linspace(0.3, 2.9, BATCH), dtype)
        there = [strict.asarray(value, dtype=kind, device=device) for value in given.values()]
        found = parts(getattr(array_api, name)(*there))
        expected = parts(getattr(array_api, name)(*given.values()))
        assert len(found) == len(expected), name
        for ours, right in zip(found, expected, strict=True):
            assert (ours.__array_namespace__(), ours.dtype, ours.device) == (strict, kind, device), name
            np.testing.assert_array_equal(np.asarray(ours.to_device(strict.Device("CPU_DEVICE"))), right, name)


def test_the_kernels_are_those_of_chasles_kernels() -> None:
    plain = {"array_api", "backend", "instructions", "one"}
    assert [name for name in dir(kernels) if name not in plain] == NAMES
    assert kernels.array_api is array_api
    for name in NAMES:
        given = inputs_of(name, np.linspace(0.3, 2.9, BATCH)).values()
        for ours, right in zip(
            parts(getattr(array_api, name)(*given)), parts(getattr(kernels, name)(*given)), strict=True
        ):
            np.testing.assert_allclose(ours, right, rtol=1e-12, atol=1e-12, err_msg=name)
    with pytest.raises(AttributeError, match=r"no kernel 'twist_off'; dir\(chasles\.kernels\.array_api\)"):
        array_api.twist_off  # noqa: B018


def test_lists_and_numbers_join_the_arrays_beside_them() -> None:
    phi = strict.asarray([0.0, 0.5], dtype=strict.float32, device=strict.Device("device1"))
    Q = array_api.rotation_from_axis_angle([0, 0, 1], phi)
    assert (Q.shape, Q.device) == ((2, 3, 3), strict.Device("device1"))
    single = array_api.rotation_from_axis_angle(strict.asarray([0.0, 0.0, 1.0], dtype=strict.float32), 0.5)
    assert single.dtype == strict.float32


def test_a_given_array_is_filled() -> None:
    out = strict.zeros((2, 3, 3))
    phi = strict.asarray([0.0, 0.5])
    assert array_api.rotation_from_axis_angle([0.0, 0.0, 1.0], phi, out=out) is out
    assert strict.all(out == array_api.rotation_from_axis_angle([0.0, 0.0, 1.0], phi))


def test_an_expression_of_ones_own_takes_them_too() -> None:
    import sympy

    x, y = sympy.symbols("x y")
    kernel = compiled(sympy.sin(x) * y, [x, y])
    found = kernel.array_api(strict.asarray([0.0, 1.0]), 2.0)
    assert found.__array_namespace__() is strict
    np.testing.assert_allclose(np.asarray(found), kernel([0.0, 1.0], 2.0))


def test_what_is_missing_for_a_foreign_array_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    class Tensor:
        """An array that offers DLPack and not the array API."""

        def __dlpack__(self) -> None: ...

    monkeypatch.setitem(sys.modules, "array_api_compat", None)
    with pytest.raises(TypeError, match=rf"arrays of {Tensor.__module__.partition('.')[0]} .*array-api-compat"):
        array_api.cross_product_matrix(Tensor())


@pytest.fixture
def jax() -> Iterator[Any]:
    """JAX in double precision."""
    jax = pytest.importorskip("jax", reason="needs JAX, which CI does not install: 620 MB")
    before = jax.config.jax_enable_x64
    jax.config.update("jax_enable_x64", True)
    yield jax
    jax.config.update("jax_enable_x64", before)


def flat(jax: Any, name: str) -> Any:
    """The kernel as a function of its inputs to all its numbers in one row."""
    function = getattr(array_api, name)
    return lambda *inputs: jax.numpy.concatenate([jax.numpy.ravel(part) for part in parts(function(*inputs))])


def differences(function: Any, inputs: list[np.ndarray], step: float = 1e-6) -> np.ndarray:
    """Central differences of the function by all numbers that go in."""
    columns = []
    for place, value in enumerate(inputs):
        for k in range(value.size):
            either = []
            for sign in (1, -1):
                moved = [array.copy() for array in inputs]
                moved[place].reshape(-1)[k] += sign * step
                either.append(np.asarray(function(*moved)))
            columns.append((either[0] - either[1]) / (2 * step))
    return np.stack(columns, axis=1)


def one_item(given: dict[str, np.ndarray]) -> list[np.ndarray]:
    return [np.array(value[0]) for value in given.values()]


DERIVED = (
    "rotation_from_axis_angle",
    "euler_rodrigues_parameters",
    "natural_invariants",
    "screw_of_motion",
    "instant_screw",
    "pose_acceleration_natural",
    "newton_euler_twist_rate",
    "euler_rates_zxz",
)


@pytest.mark.parametrize("name", DERIVED)
def test_jax_compiles_maps_and_differentiates(jax: Any, name: str) -> None:
    function, given = flat(jax, name), inputs_of(name, 0.7)
    inputs = one_item(given)
    value = jax.jit(function)(*inputs)
    assert isinstance(value, jax.Array)
    expected = np.concatenate([np.ravel(part) for part in parts(getattr(array_api, name)(*inputs))])
    np.testing.assert_allclose(value, expected, rtol=1e-13, atol=1e-13)
    mapped = jax.vmap(function)(*given.values())
    np.testing.assert_allclose(mapped[0], expected, rtol=1e-13, atol=1e-13)
    found = jax.jit(jax.jacrev(function, argnums=tuple(range(len(inputs)))))(*inputs)
    jacobian = np.concatenate([np.asarray(block).reshape(expected.size, -1) for block in found], axis=1)
    np.testing.assert_allclose(jacobian, differences(function, inputs), rtol=1e-6, atol=1e-7)


def with_phi() -> list[str]:
    return [name for name in NAMES if "phi" in inspect.signature(getattr(array_api, name)).parameters]


@pytest.mark.parametrize("name", with_phi())
def test_a_limit_has_the_limits_derivative(jax: Any, name: str) -> None:
    """At phi = 0 the derivative of every entry that has a value is that of its neighbours, forward entry by entry."""
    function, inputs = jax.jit(flat(jax, name)), one_item(inputs_of(name, 0.0))
    value = np.asarray(function(*inputs))
    finite = np.isfinite(value)
    assert finite.all() == (name not in PHI_GIVES_NAN)
    found = jax.jacfwd(function, argnums=tuple(range(len(inputs))))(*inputs)
    jacobian = np.concatenate([np.asarray(block).reshape(value.size, -1) for block in found], axis=1)
    assert np.isfinite(jacobian[finite]).all()
    step = 1e-4
    near = differences(function, inputs, step)
    known = np.isfinite(near) & finite[:, None]
    np.testing.assert_allclose(jacobian[known], near[known], rtol=1e-6, atol=1e-6)
    if finite.all():
        backward = jax.jacrev(function, argnums=tuple(range(len(inputs))))(*inputs)
        for forward, other in zip(found, backward, strict=True):
            np.testing.assert_allclose(other, forward, rtol=1e-12, atol=1e-12)


def test_a_gradient_through_an_entry_that_is_nan_is_nan(jax: Any) -> None:
    """Backward, a result's NaN entries reach the derivatives of all its entries: 0 times NaN is NaN."""
    function, e = flat(jax, "natural_rate_matrix"), jax.numpy.asarray(AXIS)
    np.testing.assert_array_equal(function(e, 0.0)[-3:], AXIS)
    backward = jax.grad(lambda e: function(e, 0.0)[-1])(e)
    forward = jax.jacfwd(lambda e: function(e, 0.0)[-1])(e)
    assert np.isnan(backward).all()
    np.testing.assert_array_equal(forward, [0.0, 0.0, 1.0])


def test_jax_keeps_single_precision(jax: Any) -> None:
    e, phi = jax.numpy.asarray(AXIS, dtype="float32"), jax.numpy.asarray(0.5, dtype="float32")
    assert array_api.rotation_from_axis_angle(e, phi).dtype == "float32"


@pytest.fixture
def torch() -> Any:
    pytest.importorskip("array_api_compat", reason="needs array-api-compat, to speak with PyTorch")
    return pytest.importorskip("torch", reason="needs PyTorch, which CI does not install: 750 MB")


@pytest.mark.parametrize("name", DERIVED)
def test_torch_differentiates(torch: Any, name: str) -> None:
    inputs = one_item(inputs_of(name, 0.7))

    def function(*given: Any) -> Any:
        return torch.cat([part.reshape(-1) for part in parts(getattr(array_api, name)(*given))])

    tensors = tuple(torch.tensor(value) for value in inputs)
    value = function(*tensors)
    assert isinstance(value, torch.Tensor)
    found = torch.autograd.functional.jacobian(function, tensors)
    jacobian = np.concatenate([np.asarray(block).reshape(value.numel(), -1) for block in found], axis=1)
    expected = differences(lambda *given: function(*map(torch.tensor, given)), inputs)
    np.testing.assert_allclose(jacobian, expected, rtol=1e-6, atol=1e-7)


def test_torch_keeps_single_precision_and_the_graph(torch: Any) -> None:
    phi = torch.tensor([0.0, 0.5], requires_grad=True)
    Q = array_api.rotation_from_axis_angle([0.0, 0.0, 1.0], phi)
    assert (Q.dtype, Q.shape) == (torch.float32, (2, 3, 3))
    Q.sum().backward()
    np.testing.assert_allclose(phi.grad, -2 * np.sin([0.0, 0.5]), rtol=1e-6)
