"""Every build of the loops gives what the scalar kernels give, wherever an item lies and whatever stands beside it."""

from __future__ import annotations

import ctypes
import shutil
import warnings
from fractions import Fraction
from importlib.util import module_from_spec, spec_from_file_location

import mpmath
import numpy as np
import pytest

from chasles.lowering.arithmetic import decimals, run
from chasles.lowering.program import Op

from ..sampling import WHOLE

KINDS = [np.float64, np.float32]
LENGTHS = [0, 1, 2, 3, 4, 5, 7, 8, 15, 16, 17, 63, 64, 65, 127, 128, 129, 1000]
SPECIAL = [0.0, -0.0, 1.0, -1.0, 5e-324, -1e-310, 1e-40, 1e300, -1e300, 1e38, np.inf, -np.inf, np.nan]
ANGLES = [np.pi, np.pi / 2, -np.pi / 2, 1.6e6, -1.6e6, np.nextafter(1.6e6, 2e6), 1e15, 1e22, 3.4e38, 45.553093477052]


def results(found):
    return found if isinstance(found, tuple) else (found,)


@pytest.fixture(params=["baseline", "x86-64-v3", "x86-64-v4"])
def loops(request, levels, ufuncs_by_level):
    """The ufuncs of one build of the loops."""
    if request.param not in levels:
        pytest.skip(f"this machine does not have {request.param}")
    return ufuncs_by_level[request.param]


def same(found, expected):
    """Whether two arrays hold the same bits, but for the sign and payload of NaN."""
    found, expected = np.asarray(found), np.asarray(expected)
    bits = {8: np.uint64, 4: np.uint32}[found.dtype.itemsize]
    equal = found[...].copy().view(bits) == expected[...].copy().view(bits)
    return found.dtype == expected.dtype and np.all(equal | (np.isnan(found) & np.isnan(expected)))


def quietly(ufunc, *inputs, **options):
    with np.errstate(all="ignore"):
        return results(ufunc(*inputs, **options))


@pytest.mark.sampled(7)
@pytest.mark.parametrize("kind", KINDS)
def test_where_an_item_stands_does_not_matter(loops, name, sample, kind):
    for length in LENGTHS:
        inputs = sample(name, (length,), kind)
        together = quietly(getattr(loops, name), *inputs)
        for i in {0, 1, length // 2, length - 1} & set(range(length)):
            alone = quietly(getattr(loops, name), *(value[i] for value in inputs))
            assert all(same(got[i], value) for got, value in zip(together, alone, strict=True)), (length, i)


@pytest.mark.sampled(11)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("length", [1, 3, 64, 65, 200])
def test_strides_of_every_kind_change_no_bit(loops, name, sample, kind, length):
    ufunc, inputs = getattr(loops, name), sample(name, (length,), kind)
    plain = quietly(ufunc, *inputs)
    for arrange in (gapped, reversed_in_memory, misaligned, core_axes_first, broadcast):
        views, expected = [arrange(value) for value in inputs], plain
        if arrange is broadcast:
            expected = quietly(ufunc, *(np.repeat(value[:1], length, axis=0) for value in inputs))
        assert all(map(same, quietly(ufunc, *views), expected)), arrange.__name__
        outs = tuple(arrange(np.full_like(value, 7)) for value in plain if arrange is not broadcast)
        if outs:
            given = quietly(ufunc, *views, out=outs)
            assert all(got is out for got, out in zip(given, outs, strict=True))
            assert all(map(same, outs, expected)), arrange.__name__


def gapped(value):
    wide = np.zeros((2 * len(value), *value.shape[1:]), value.dtype)[::2]
    wide[...] = value
    return wide


def reversed_in_memory(value):
    turned = tuple(slice(None, None, -1) for _ in value.shape)
    return value[turned].copy()[turned]


def misaligned(value):
    store = np.zeros(value.nbytes + 1, np.uint8)[1:].view(value.dtype).reshape(value.shape)
    store[...] = value
    return store


def core_axes_first(value):
    return value.T.copy().T


def broadcast(value):
    return np.broadcast_to(value[0], value.shape)


def test_what_lies_around_an_output_stays(loops, name, sample):
    for length in (1, 3, 5, 66):
        inputs = sample(name, (length,))
        plain = quietly(getattr(loops, name), *inputs)
        stores = [np.full((length + 2, got[0].size + 2), 7.0) for got in plain]
        outs = tuple(
            store[1:-1, 1:-1].reshape(got.shape)
            if got[0].size == 1
            else np.lib.stride_tricks.as_strided(store[1:, 1:], got.shape, (store.strides[0], *got.strides[1:]))
            for store, got in zip(stores, plain, strict=True)
        )
        quietly(getattr(loops, name), *inputs, out=outs)
        for store, out, got in zip(stores, outs, plain, strict=True):
            assert same(out, got) or got[0].size == 1
            if got[0].size > 1:
                assert np.all(store[[0, -1]] == 7)
                assert np.all(store[:, [0, -1]] == 7)


def exact(program, inputs):
    """The results in 50 digits."""
    arithmetic = decimals(50)
    entries = [[arithmetic.constant(Fraction(float(x))) for x in np.ravel(value)] for value in inputs]
    return [[float(entry) for entry in group] for group in run(program, entries, arithmetic)]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("kind", KINDS)
def test_results_are_those_of_50_digits(loops, name, sample, kernels, kind):
    (program,) = (kernel.program for kernel in kernels if kernel.name == name)
    inputs = sample(name, (70,), kind)
    found = quietly(getattr(loops, name), *inputs)
    for i in range(70):
        for got, expected in zip(found, exact(program, [value[i] for value in inputs]), strict=True):
            margin = 100 * np.finfo(kind).eps * max(1, np.max(np.abs(expected)))
            np.testing.assert_allclose(np.ravel(got[i]), expected, rtol=0, atol=margin)


@pytest.mark.sampled(5)
@pytest.mark.parametrize("kind", KINDS)
def test_sines_and_cosines_are_within_a_unit_in_the_last_place(loops, kind):
    random = np.random.default_rng(1)
    near = [k * np.pi / 2 for k in (*range(-40, 41), 2**19 - 1, 2**20 - 3, 10**6 + 1)]
    steps = [np.nextafter(x, way) for x in near for way in (-np.inf, np.inf)]
    spread = random.uniform(-1.6e6, 1.6e6, 2000), random.uniform(-4, 4, 4000), 10.0 ** random.uniform(-300, 6, 500)
    every = 1 if WHOLE else 4
    x = np.concatenate([near, steps, *(part[::every] for part in spread), ANGLES]).astype(kind)
    x = x[np.isfinite(x)]
    e = np.zeros((len(x), 3), kind)
    e[:, 2] = 1
    Q = loops.rotation_from_axis_angle(e, x)
    with mpmath.workprec(1400):
        for row, angle in zip(Q, x, strict=True):
            for got, exact in (
                (row[1, 0], mpmath.sin(mpmath.mpf(float(angle)))),
                (row[0, 0], mpmath.cos(float(angle))),
            ):
                ulp = np.spacing(np.maximum(abs(kind(float(exact))), np.finfo(kind).tiny))
                assert abs(mpmath.mpf(float(got)) - exact) <= 0.8 * mpmath.mpf(float(ulp)), (angle, got)


def scalar_results(library, program, inputs, kind):
    """What the scalar C kernel gives for each item."""
    number = {np.float64: ctypes.c_double, np.float32: ctypes.c_float}[kind]
    kernel = getattr(library, f"chasles_{program.name}{'' if kind is np.float64 else 'f'}")
    count = len(inputs[0])
    outs = [np.zeros((count, *item.shape), kind) for item in program.results]
    for i in range(count):
        given = [
            value[i].ctypes.data_as(ctypes.c_void_p) if item.shape else number(value[i])
            for value, item in zip(inputs, program.arguments, strict=True)
        ]
        kernel(*given, *(ctypes.c_void_p(out.ctypes.data + i * out.strides[0]) for out in outs))
    return outs


def special(program, kind, count):
    """Inputs drawn from what is zero, tiny, huge, infinite, NaN, or an angle of note, among plain numbers."""
    random = np.random.default_rng(5)
    with np.errstate(over="ignore", under="ignore"):
        values = np.array([*SPECIAL, *ANGLES]).astype(kind)
    drawn = []
    for item in program.arguments:
        plain = random.uniform(-2, 2, (count, *item.shape)).astype(kind)
        odd = random.random(plain.shape) < random.choice([0.1, 0.6], (count, *[1] * len(item.shape)))
        drawn.append(np.where(odd, random.choice(values, plain.shape), plain))
    return drawn


def program_of(kernels, name):
    (program,) = (kernel.program for kernel in kernels if kernel.name == name)
    return program


def turns(program):
    return any(step.op in (Op.SINE, Op.COSINE) for step in program.steps)


@pytest.mark.sampled(5)
@pytest.mark.parametrize("kind", KINDS)
def test_a_batch_gives_the_bits_of_the_scalar_kernel(loops, name, kernels, library, kind):
    """Whatever the numbers. Where a sine or a cosine comes in, whose last bit may differ, to the last digits, and NaN
    and infinities alike but for the largest numbers, where that bit says whether a product overflows."""
    program = program_of(kernels, name)
    inputs = special(program, kind, 2000)
    found = quietly(getattr(loops, name), *inputs)
    scalar = scalar_results(library, program, inputs, kind)
    if not turns(program):
        assert all(map(same, found, scalar))
        return
    mild = np.all([~((np.abs(x) > 1e16) & np.isfinite(x)).reshape(2000, -1).any(axis=1) for x in inputs], axis=0)
    assert np.count_nonzero(mild) > 300
    for got, expected in zip(found, scalar, strict=True):
        unlike = (np.isnan(got) != np.isnan(expected)) | (np.isinf(got) != np.isinf(expected))
        unlike = unlike.reshape(2000, -1).any(axis=1)
        assert not [([x[i] for x in inputs], got[i], expected[i]) for i in np.flatnonzero(mild & unlike)]
        size = np.max(np.abs(np.where(np.isfinite(expected), expected, 0)).reshape(2000, -1), axis=1)
        finite = mild & np.isfinite(expected).reshape(2000, -1).all(axis=1)
        off = np.abs(got[finite] - expected[finite]).reshape(np.count_nonzero(finite), -1).max(axis=1, initial=0)
        far = np.flatnonzero(finite)[off > 32 * np.finfo(kind).eps * np.maximum(size[finite], 1)]
        assert not [([x[i] for x in inputs], got[i], expected[i]) for i in far]


@pytest.mark.sampled(7)
@pytest.mark.parametrize("kind", KINDS)
def test_invalid_is_raised_for_a_singular_item_and_for_nothing_else(loops, name, kernels, kind):
    program, ufunc = program_of(kernels, name), getattr(loops, name)
    inputs = special(program, kind, 400)
    found = quietly(ufunc, *inputs)
    came = np.any([np.isnan(value).reshape(400, -1).any(axis=1) for value in inputs], axis=0)
    went = np.any([np.isnan(value).reshape(400, -1).any(axis=1) for value in found], axis=0)
    singular = went & ~came
    for i in range(400):
        assert raises_invalid(ufunc, [value[i] for value in inputs]) == singular[i], [value[i] for value in inputs]
    calm = [value[~singular] for value in inputs]
    assert not raises_invalid(ufunc, calm)
    for i in np.flatnonzero(singular)[:5]:
        assert raises_invalid(
            ufunc, [np.insert(value, 70, whole[i], 0) for value, whole in zip(calm, inputs, strict=True)]
        )


def raises_invalid(ufunc, inputs):
    """Whether NumPy finds the flag `invalid`; any other flag is a failure."""
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        with np.errstate(all="warn"):
            ufunc(*inputs)
    assert all("invalid value" in str(one.message) for one in said), [str(one.message) for one in said]
    return bool(said)


def test_the_singular_are_singular(loops):
    """The tests above would pass on kernels that never give NaN."""
    with pytest.warns(RuntimeWarning, match="invalid value"):
        assert np.all(np.isnan(loops.plucker_line(np.ones(3), np.ones(3))))
    with pytest.warns(RuntimeWarning, match="invalid value"):
        assert np.isnan(loops.rotation_from_axis_angle([0, 0, 1], np.inf)).any()


@pytest.mark.parametrize("length", [3, 64, 65, 200])
def test_outputs_may_lie_over_inputs(loops, length, sample):
    a, b, x, y = sample("swapped", (length,))
    expected = [np.array(value) for value in (b, a, y, x)]
    loops.swapped(a, b, x, y, out=(a, b, x, y))
    assert all(map(same, (a, b, x, y), expected))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("shift", [0, 1, 2, 3])
def test_results_that_go_around_the_cache_are_the_same(loops, kind, shift):
    """More than 16 MiB of them, from any place, the item that is singular among them."""
    length = 2**24 // (9 * np.dtype(kind).itemsize) + 77
    e, phi = np.array([0.6, 0, 0.8], kind), np.linspace(-3, 3, length, dtype=kind)
    store = np.full(9 * length + shift + 1, 7, kind)
    out = store[shift:-1].reshape(length, 3, 3)
    assert not raises_invalid(lambda *inputs: loops.rotation_from_axis_angle(*inputs, out=out), (e, phi))
    for start in range(0, length, 100_000):
        assert same(out[start : start + 100_000], loops.rotation_from_axis_angle(e, phi[start : start + 100_000]))
    assert np.all(store[:shift] == 7)
    assert store[-1] == 7
    phi[length // 2] = np.inf
    assert raises_invalid(lambda *inputs: loops.rotation_from_axis_angle(*inputs, out=out), (e, phi))
    assert np.count_nonzero(np.isnan(out).any(axis=(1, 2))) == 1


@pytest.mark.sampled(5)
@pytest.mark.parametrize("shift", [0, 1, 5])
@pytest.mark.parametrize("alone", [True, False])
def test_the_widest_of_several_results_goes_around_the_cache(loops, shift, alone):
    """Where one matrix is read for all; where more is read than written nothing does."""
    length = 2**24 // (3 * 8) + 33
    Q = np.random.default_rng(2).normal(size=(1 if alone else length, 3, 3))
    store = np.full(3 * length + shift + 1, 7.0)
    u, u_0 = store[shift:-1].reshape(length, 3), np.full(length, 7.0)
    loops.linear_invariants(Q, out=(u, u_0))
    for start in range(0, length, 100_000):
        there = slice(start, start + 100_000)
        expected = np.broadcast_to(Q, (length, 3, 3))[there]
        assert all(map(same, (u[there], u_0[there]), loops.linear_invariants(expected)))
    assert np.all(store[:shift] == 7)
    assert store[-1] == 7


def test_an_unknown_set_of_instructions_is_named(extension, tmp_path, monkeypatch):
    copy = shutil.copy(extension, tmp_path / extension.name)
    monkeypatch.setenv("CHASLES_INSTRUCTIONS", "sse9")
    with pytest.raises(ImportError, match=r"CHASLES_INSTRUCTIONS is 'sse9'; this build on this machine has baseline"):
        imported("unknown._kernels", copy)


def imported(name, path):
    spec = spec_from_file_location(name, path)
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
