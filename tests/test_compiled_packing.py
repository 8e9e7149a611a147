"""Kernels of more operands than a batch takes: their scalars are packed, and nobody sees it."""

from __future__ import annotations

import inspect
import pickle

import numpy as np
import pytest
import sympy as sp

import chasles

many = sp.symbols("p0:50")
v = sp.Matrix(sp.symbols("v1:4"))
NUMBERS = [0.1 * k + 0.3 for k in range(50)]


@pytest.fixture(scope="module")
def kernel():
    total = sum(k * p**2 for k, p in enumerate(many, 1))
    return chasles.compile([total * v, sp.sqrt(total)], [*many[:20], v, *many[20:]], outputs=["scaled", "root"])


@pytest.fixture(scope="module")
def results():
    return chasles.compile([k * p for k, p in enumerate(many)], many)


def exact(numbers):
    return sum(k * p**2 for k, p in enumerate(numbers, 1))


def test_scalars_go_in_in_their_order(kernel):
    scaled, root = kernel(*NUMBERS[:20], np.array([1.0, 2.0, 3.0]), *NUMBERS[20:])
    assert kernel.backend == "c"
    np.testing.assert_allclose(scaled, exact(NUMBERS) * np.array([1.0, 2.0, 3.0]), rtol=1e-14)
    assert root == pytest.approx(exact(NUMBERS) ** 0.5, rel=1e-14)


def test_batches_broadcast_and_names_do_as_well(kernel):
    column = np.linspace(1.0, 2.0, 7)
    named = {f"p{k}": number for k, number in enumerate(NUMBERS)} | {"p3": column[:, None], "p30": column}
    scaled, root = kernel(**named, v=np.ones(3))
    assert scaled.shape == (7, 7, 3)
    wanted = exact([*NUMBERS[:3], column[:, None], *NUMBERS[4:30], column, *NUMBERS[31:]])
    np.testing.assert_allclose(root, wanted**0.5, rtol=1e-14)
    np.testing.assert_allclose(scaled[..., 1], wanted, rtol=1e-14)


def test_precision_stays(kernel):
    single = [np.float32(number) for number in NUMBERS]
    scaled, root = kernel(*single[:20], np.ones(3, np.float32), *single[20:])
    assert scaled.dtype == root.dtype == np.float32


def test_as_many_results(results):
    found = results(*NUMBERS)
    assert len(found) == 50
    assert found == pytest.approx([k * p for k, p in enumerate(NUMBERS)])
    assert [part.shape for part in results(np.ones(4), *NUMBERS[1:])] == [(4,)] * 50
    with pytest.raises(ValueError, match="out"):
        results(*NUMBERS, out=(np.zeros(()),) * 50)


def test_what_is_said_of_them_is_as_ever(kernel, results):
    assert list(inspect.signature(kernel).parameters)[:3] == ["p0", "p1", "p2"]
    assert kernel.signature.count("()") == 51
    assert pickle.loads(pickle.dumps(results))(*NUMBERS) == results(*NUMBERS)
    assert (
        kernel.one(*NUMBERS[:20], np.ones(3), *NUMBERS[20:])[1] == kernel(*NUMBERS[:20], np.ones(3), *NUMBERS[20:])[1]
    )
    assert results.array_api(*map(np.float64, NUMBERS))[7] == results(*NUMBERS)[7]


def test_a_thousand_numbers():
    square = sp.MatrixSymbol("A", 30, 30)
    kernel = chasles.compile(square + 2 * square.T, [square])
    given = np.arange(900.0).reshape(30, 30)
    np.testing.assert_array_equal(kernel(given), given + 2 * given.T)
