"""Both ways to call a kernel from Python give the numbers of formulas written by hand, and keep NumPy's manners."""

from __future__ import annotations

import pickle
import sys

import array_api_strict as strict
import numpy as np
import pytest

from chasles.targets import signature


def skew(v):
    return np.cross(v, -np.eye(3))


def rotation_from_axis_angle(e, phi):
    return np.cos(phi) * np.eye(3) + (1 - np.cos(phi)) * np.outer(e, e) + np.sin(phi) * skew(e)


def screw_axis_point(e, phi, a, a_prime):
    d, s = a_prime - a, a + a_prime
    return (s - e * (e @ s) + np.cross(e, d) / np.tan(phi / 2)) / 2


def linear_invariants(Q):
    return np.array([Q[2, 1] - Q[1, 2], Q[0, 2] - Q[2, 0], Q[1, 0] - Q[0, 1]]) / 2, (np.trace(Q) - 1) / 2


def plucker_line(p_1, p_2):
    e = (p_2 - p_1) / np.linalg.norm(p_2 - p_1)
    return np.concatenate([e, np.cross(p_1, e)])


def signed_length(x):
    share = x[1] if x[0] < 0 else -x[2]
    return np.copysign(np.sqrt(2) * np.linalg.norm(x), x[0]), share / 3 + x[0]


def awkward_names(I, gamma, xp, out, count):
    angle = np.arctan2(I[0] + gamma, 2)
    t = np.sin(gamma) ** 2 + angle
    return np.array([t * xp, t * (out - count + I[2])]), 2 * angle - 1


def cross_product_matrix(v):
    return skew(v)


def swapped(a, b, x, y):
    return b, a, y, x


def long_sum(A, x):
    return 0.1 + sum((A[i, j] - x[i]) * (x[j] - 1.5 * A[j, i]) for i in range(3) for j in range(3))


def nested_turns(angles, idle):
    s, c = np.sin(angles[0] / 2), np.cos(angles[1] - angles[0])
    late = np.cos(s + angles[2])
    return np.array([late * s / np.hypot(s, c), c - late]), s, 0.5


def by_hand(name, inputs):
    """The results for one item, always a tuple."""
    found = globals()[name](*(np.asarray(value, float) for value in inputs))
    return found if isinstance(found, tuple) else (found,)


def results(found):
    return found if isinstance(found, tuple) else (found,)


TOLERANCE = {np.float64: 1e-13, np.float32: 1e-4}


@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_one_item_is_what_the_formula_gives(backend, name, kind, sample):
    for _ in range(10):
        inputs = sample(name, (), kind)
        found = results(getattr(backend, name)(*inputs))
        for got, expected in zip(found, by_hand(name, inputs), strict=True):
            assert got.dtype == kind
            assert got.shape == np.shape(expected)
            np.testing.assert_allclose(got, expected, rtol=TOLERANCE[kind], atol=TOLERANCE[kind])


def test_both_ways_agree_to_the_last_digits(ufuncs, functions, name, sample):
    inputs = sample(name, (500,))
    for compiled, written in zip(
        results(getattr(ufuncs, name)(*inputs)), results(getattr(functions, name)(*inputs)), strict=True
    ):
        np.testing.assert_allclose(compiled, written, rtol=4e-16, atol=4e-16 * np.max(np.abs(written)))


@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_batches_broadcast(backend, name, kind, sample, kernels):
    """The first input varies along one axis and the others along another; core axes are strided both ways."""
    (program,) = (kernel.program for kernel in kernels if kernel.name == name)
    first, *others = sample(name, (4,), kind)
    inputs = [first[:, None], *(np.asarray(other[:3])[None] for other in others)]
    found = results(getattr(backend, name)(*inputs))
    columns = 3 if others else 1
    for result, got in zip(program.results, found, strict=True):
        assert got.shape == (4, columns, *result.shape)
    for i in range(4):
        for j in range(columns):
            expected = by_hand(name, [first[i], *(other[j] for other in others)])
            for got, value in zip(found, expected, strict=True):
                np.testing.assert_allclose(got[i, j], value, rtol=TOLERANCE[kind], atol=TOLERANCE[kind])


def strided(array, core):
    """The same numbers with every axis reversed in memory and a gap between neighbours."""
    wide = np.zeros([2 * extent for extent in array.shape], array.dtype)
    view = wide[tuple(slice(None, None, -2) for _ in array.shape)]
    view[...] = array
    assert view.ndim < len(core) + 1 or min(view.strides) < 0
    return view


def test_strides_do_not_matter(backend, name, sample, kernels):
    (program,) = (kernel.program for kernel in kernels if kernel.name == name)
    inputs = sample(name, (5,))
    plain = results(getattr(backend, name)(*inputs))
    views = [strided(value, item.shape) for value, item in zip(inputs, program.arguments, strict=True)]
    for got, expected in zip(results(getattr(backend, name)(*views)), plain, strict=True):
        assert np.array_equal(got, expected)
    swapped_axes = [value.T.copy().T for value in inputs]
    for got, expected in zip(results(getattr(backend, name)(*swapped_axes)), plain, strict=True):
        assert np.array_equal(got, expected)
    repeated = [np.broadcast_to(value[0], value.shape) for value in inputs]
    for got, expected in zip(results(getattr(backend, name)(*repeated)), plain, strict=True):
        assert np.array_equal(got, np.broadcast_to(expected[0], expected.shape))


def test_empty_batches(backend, name, sample, kernels):
    (program,) = (kernel.program for kernel in kernels if kernel.name == name)
    for batch in ((0,), (3, 0), (0, 2)):
        found = results(getattr(backend, name)(*sample(name, batch)))
        assert [got.shape for got in found] == [(*batch, *result.shape) for result in program.results]


def test_out_takes_the_results_in_any_strides(backend, name, sample, kernels):
    (program,) = (kernel.program for kernel in kernels if kernel.name == name)
    inputs = sample(name, (4,))
    expected = results(getattr(backend, name)(*inputs))
    places = tuple(strided(np.empty((4, *result.shape)), result.shape) for result in program.results)
    given = getattr(backend, name)(*inputs, out=places if len(places) > 1 else places[0])
    for place, got, value in zip(places, results(given), expected, strict=True):
        assert got is place
        assert np.array_equal(place, value)
    half = getattr(backend, name)(*inputs, out=(places[0], *(None,) * (len(places) - 1)))
    assert results(half)[0] is places[0]


def test_out_may_lie_over_inputs(backend, sample):
    a, b, x, y = sample("swapped", (4,))
    expected = [np.array(value) for value in (b, a, y, x)]
    backend.swapped(a, b, x, y, out=(a, b, x, y))
    assert all(np.array_equal(got, value) for got, value in zip((a, b, x, y), expected, strict=True))
    store = np.zeros((6, 3, 3))
    e, phi = sample("rotation_from_axis_angle", (4,))
    expected = backend.rotation_from_axis_angle(e, phi)
    store[1:5, 1] = e
    backend.rotation_from_axis_angle(store[1:5, 1], phi, out=store[2:])
    assert np.array_equal(store[2:], expected)


def test_lists_integers_and_python_numbers(backend):
    Q = backend.rotation_from_axis_angle([0, 0, 1], 0)
    assert Q.dtype == np.float64
    assert np.array_equal(Q, np.eye(3))
    single = np.float32([0, 0, 1])
    assert backend.rotation_from_axis_angle(single, 0.5).dtype == np.float32
    assert backend.rotation_from_axis_angle(single, np.float64(0.5)).dtype == np.float64
    assert backend.rotation_from_axis_angle(single, np.zeros(2)).dtype == np.float64
    assert backend.rotation_from_axis_angle(np.float16([0, 0, 1]), 0.5).dtype == np.float32
    length, _ = backend.signed_length([3, 0, 4])
    assert np.ndim(length) == 0
    assert isinstance(length, np.float64)


@pytest.mark.parametrize("wrong", [(4,), (3, 1), (1,), ()])
def test_shapes_that_do_not_fit_are_value_errors(backend, wrong):
    with pytest.raises(ValueError, match="rotation_from_axis_angle"):
        backend.rotation_from_axis_angle(np.zeros(wrong), 0.0)


def test_shape_errors_name_the_argument_what_is_expected_and_what_came(functions):
    with pytest.raises(ValueError, match=r"linear_invariants: Q .*\(3, 3\).*\(3, 4\)"):
        functions.linear_invariants(np.zeros((3, 4)))
    with pytest.raises(ValueError, match=r"batch axes do not broadcast: e \(2,\), phi \(3,\)"):
        functions.rotation_from_axis_angle(np.zeros((2, 3)), np.zeros(3))
    with pytest.raises(ValueError, match=r"linear_invariants: Q is no array"):
        functions.linear_invariants([[1, 2], [3]])


def test_what_is_not_real_is_a_type_error(backend):
    for wrong in (np.zeros(3, complex), np.array(["a", "b", "c"]), np.zeros(3, object)):
        with pytest.raises(TypeError):
            backend.rotation_from_axis_angle(wrong, 0.0)


def test_an_out_that_does_not_fit_stores_nothing(backend):
    for wrong in (np.zeros(2), np.zeros((2, 4)), np.zeros(3, int)):
        kept = np.full((3, 3), 7.0)
        with pytest.raises((ValueError, TypeError)):
            backend.linear_invariants(np.eye(3), out=(wrong, kept[0, 0, ...]))
        assert np.all(kept == 7)
    with pytest.raises((ValueError, TypeError)):
        backend.linear_invariants(np.eye(3), out=np.zeros(3))
    with pytest.raises(TypeError):
        backend.rotation_from_axis_angle([0, 0, 1], 0, out=[0] * 9)


def test_ufuncs_are_ufuncs_with_their_contract(ufuncs, kernels):
    assert ufuncs.__all__ == [kernel.name for kernel in kernels]
    for kernel in kernels:
        ufunc = getattr(ufuncs, kernel.name)
        assert isinstance(ufunc, np.ufunc)
        assert ufunc.signature == signature(kernel.program)
        assert [types[0] for types in ufunc.types] == ["f", "d"]
        for part in (kernel.heading.says.split()[-1], "(3.18)", "|e| = 1", "phi != 0", kernel.heading.derivation):
            assert part in ufunc.__doc__
        assert 'a "quotation", Plücker' in " ".join(ufunc.__doc__.split())


def test_functions_have_their_contract(functions, kernels):
    assert functions.__all__ == tuple(kernel.name for kernel in kernels)
    for kernel in kernels:
        doc = getattr(functions, kernel.name).__doc__
        for part in ("(3.18)", "|e| = 1", "phi != 0", kernel.heading.derivation, signature(kernel.program)):
            assert part in doc


def test_axes_and_pickle_come_with_a_ufunc(ufuncs):
    e, phi = np.eye(3), np.array([0.1, 0.2, 0.3])
    turned = ufuncs.rotation_from_axis_angle(e, phi, axes=[0, (), (0, 1)])
    assert np.array_equal(np.moveaxis(turned, -1, 0), ufuncs.rotation_from_axis_angle(e, phi))
    assert sys.modules["_kernels"] is ufuncs
    assert pickle.loads(pickle.dumps(ufuncs.swapped)) is ufuncs.swapped


def test_loops_leave_the_global_lock(ufuncs):
    """Two threads in a loop at once give what one gives."""
    from concurrent.futures import ThreadPoolExecutor

    e, phi = np.array([0.6, 0, 0.8]), np.linspace(-3, 3, 20_000)
    expected = ufuncs.rotation_from_axis_angle(e, phi)
    with ThreadPoolExecutor(2) as pool:
        for found in pool.map(lambda _: ufuncs.rotation_from_axis_angle(e, phi), range(4)):
            assert np.array_equal(found, expected)


@pytest.mark.parametrize("kind", ["float64", "float32"])
def test_functions_run_on_any_array_library(functions, name, kind, sample, monkeypatch):
    def refuse(*_):
        raise AssertionError("nothing is written in place")

    monkeypatch.setattr(type(strict.zeros(1)), "__setitem__", refuse)
    inputs = sample(name, (4,), getattr(np, kind))
    expected = results(getattr(functions, name)(*inputs))
    found = results(getattr(functions, name)(*map(strict.asarray, inputs)))
    for got, value in zip(found, expected, strict=True):
        assert (got.__array_namespace__(), got.dtype) == (strict, getattr(strict, kind))
        assert np.array_equal(np.asarray(got), value)
