"""Programs of any length: cut into parts they compute the same bits, at every level and wherever operands lie."""

from __future__ import annotations

import random

import numpy as np
import pytest

from chasles import kernels
from chasles.compiling import compiler, store
from chasles.compiling.kernel import CompiledKernel, kernel_of
from chasles.lowering.builder import Builder
from chasles.lowering.program import Argument, Program, Result
from chasles.targets.c import parts

needs_c = pytest.mark.skipif(
    kernels.make_ufunc is None or compiler.found("baseline") is None, reason="needs a compiler"
)


@pytest.fixture(autouse=True)
def cache(tmp_path_factory, monkeypatch):
    monkeypatch.setenv("CHASLES_CACHE", str(tmp_path_factory.getbasetemp() / "long-programs"))
    monkeypatch.setattr(store, "_loaded", {})


def made(seed: int, length: int, results: tuple[tuple[int, ...], ...] = ((7,), (), (3, 5))) -> Program:
    """A program of everything: choices among values of long ago, sines of sines, entries that are inputs, constants."""
    draw, build = random.Random(seed), Builder()
    arguments = (Argument("q", (5,), "q"), Argument("kept", (), "a name that parts use"), Argument("A", (2, 3), "A"))
    known = [build.input(0, k) for k in range(5)] + [build.input(1, 0)] + [build.input(2, k) for k in range(6)]
    while len(build.steps) < length:
        a, b, c = (draw.choice(known[-40:]), draw.choice(known), draw.choice(known[-9:]))
        match draw.randrange(12):
            case 0:
                new = build.select(build.less(a, b), c, build.negate(a))
            case 1:
                new = build.select(build.equal(a, b), build.not_a_number(), c)
            case 2:
                new = build.sine(a)
            case 3:
                new = build.cosine(build.multiply(build.constant(3), a))
            case 4:
                new = build.square_root(build.add(build.multiply(a, a), build.multiply(b, b)))
            case 5:
                new = build.arctangent2(a, b)
            case 6:
                new = build.divide(a, build.add(build.constant(2), build.multiply(b, b)))
            case 7 | 8:
                new = build.multiply(build.sine(a), b)
            case 9:
                new = build.subtract(a, b)
            case _:
                new = build.multiply(build.constant(draw.choice((1, -1))), build.add(a, c))
        if build.value(new) is None and new not in known:
            known.append(new)
    entries = [*known, build.constant(3), build.negate(known[1]), build.zero]
    wanted = [[draw.choice(entries) for _ in range(int(np.prod(shape)))] for shape in results]
    wanted[-1][-1] = known[-1]
    found = (Result(f"r{k}", shape, "r", tuple(w)) for k, (shape, w) in enumerate(zip(results, wanted, strict=True)))
    return Program("expression", arguments, build.steps, tuple(found))


def operands(count: int, dtype: type) -> list[np.ndarray]:
    draw = np.random.default_rng(count)
    return [draw.uniform(-2, 2, (count, *shape)).astype(dtype) for shape in ((5,), (), (2, 3))]


def same(one: object, other: object) -> bool:
    return all(np.array_equal(a, b, equal_nan=True) for a, b in zip(one, other, strict=True))


def compiled(program: Program, monkeypatch: pytest.MonkeyPatch, most: int, steps: int) -> CompiledKernel:
    monkeypatch.setattr(parts, "_MOST_STEPS", most)
    monkeypatch.setattr(parts, "_STEPS", steps)
    return kernel_of(program)


@pytest.mark.parametrize("seed", range(20))
def test_parts_read_what_is_kept_and_store_each_entry_once(seed, monkeypatch):
    program = made(seed, 150 + 20 * seed)
    monkeypatch.setattr(parts, "_MOST_STEPS", 0)
    monkeypatch.setattr(parts, "_STEPS", 3 + 4 * seed)
    found = parts.parts_of(program)
    assert len(found.parts) > 2
    inputs, outputs = found.places[3], found.places[3] + 7 + 1 + 15
    holds = dict.fromkeys(range(inputs), -1)
    for number, part in enumerate(found.parts):
        reads = [step.entry for step in part.program.steps if step.op.value == "input"]
        assert all(holds[slot] < number for slot in reads)
        assert not set(reads) & set(part.slots)
        holds.update(dict.fromkeys(part.slots, number))
    stored = [slot for part in found.parts for slot in part.slots if slot < outputs]
    assert sorted(stored) == list(range(inputs, outputs))
    assert max(holds) + 1 == found.room


@needs_c
@pytest.mark.sampled(4)
@pytest.mark.parametrize("level", ["baseline", "x86-64-v3", "x86-64-v4"])
@pytest.mark.parametrize("seed", range(2))
def test_parts_compute_the_same_bits(seed, level, monkeypatch):
    if level > kernels.instructions and level != "baseline":
        pytest.skip(f"no {level} here")
    monkeypatch.setattr(kernels, "instructions", level)
    program = made(seed, 200)
    whole = compiled(program, monkeypatch, 10**6, 10**6)
    cut = compiled(program, monkeypatch, 0, 13)
    assert "_part_2" in cut_blocks(program)
    assert whole.backend == cut.backend == "c"
    for dtype in (float, np.float32):
        given = operands(37, dtype)
        expected = whole(*given)
        assert same(cut(*given), expected)
        assert same([r[5] for r in expected], cut(*(g[5] for g in given)))
        assert same([r[5] for r in expected], cut.one(*(np.array(g[5]) for g in given)))
        assert same([r[::-2] for r in expected], cut(*(g[::-2] for g in given)))
        turned = [np.asfortranarray(g) for g in given]
        into = [np.zeros_like(r, order="F") for r in expected]
        assert same(cut(*turned, out=tuple(into)), expected)
        # More results than the cache holds go around it, but not those of parts.
        many = [np.tile(g, (2000, *[1] * (g.ndim - 1))) for g in given]
        assert same([r[-37:] for r in cut(*many)], expected)


def cut_blocks(program: Program) -> str:
    from chasles.compiling.sources import sources_of

    return sources_of(program)[1]["src/expression_blocks.c"]


@needs_c
@pytest.mark.parametrize(("size", "outputs"), [(1000, 4), (3, 2500), (4000, 4000)])
def test_thousands_of_entries(size, outputs, hasty_compiler, monkeypatch):
    monkeypatch.setenv("CC", hasty_compiler)
    build = Builder()
    places = [build.input(0, k) for k in range(size)]
    total = places[0]
    for place in places[1:]:
        total = build.add(total, place)
    ends = [build.multiply(total, places[k % size]) if k % 3 else places[k % size] for k in range(outputs)]
    arguments, result = (Argument("q", (size,), "q"),), Result("r", (outputs,), "r", tuple(ends))
    kernel = kernel_of(Program("expression", arguments, build.steps, (result,)))
    assert kernel.backend == "c"
    q = np.random.default_rng(1).integers(-9, 9, (45, size)).astype(float)
    wanted = np.where(np.arange(outputs) % 3, q.sum(1)[:, None], 1.0) * q[:, np.arange(outputs) % size]
    assert np.array_equal(kernel(q), wanted)
    assert np.array_equal(kernel(q[3]), wanted[3])
    assert np.array_equal(kernel.one(q[3].copy()), wanted[3])
    assert np.array_equal(kernel(np.asfortranarray(q)), wanted)
    # Over itself: operands that overlap are copied.
    room = np.zeros((45, size + outputs))
    room[:, :size] = q
    assert np.array_equal(kernel(room[:, :size], out=room[:, size:]), wanted)
    assert np.array_equal(kernel(room[:, :size], out=room[:, 1 : 1 + outputs]), wanted)


@needs_c
@pytest.mark.parametrize("count", [31, 32, 40])
def test_more_than_32_operands_are_packed(count):
    build = Builder()
    total = build.one
    for k in range(count):
        total = build.add(total, build.input(k, 0))
    names = (Argument(f"x{k}", (), "x") for k in range(count))
    kernel = kernel_of(Program("expression", tuple(names), build.steps, (Result("r", (), "r", (total,)),)))
    x = np.random.default_rng(1).integers(-9, 9, (count, 50)).astype(float)
    assert np.array_equal(kernel(*x), 1 + x.sum(0))
    assert kernel.one(*x[:, 7]) == 1 + x[:, 7].sum()
