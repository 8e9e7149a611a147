"""Wherever operands lie in memory, results are the same bits."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from benchmarks.strides import LAYOUTS, NAMES, batches, compiled, shapes_of

import chasles
from chasles import kernels

LAID = {"contiguous": lambda a: a, **LAYOUTS}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("which", [*NAMES, ""], ids=lambda which: which or "compiled")
def test_every_layout_gives_the_same_bits(which, dtype, ufuncs_by_level):
    modules = kernels, *ufuncs_by_level.values()
    for kernel in [getattr(each, which) for each in modules if hasattr(each, which)] if which else [compiled()]:
        given, returned = shapes_of(kernel)
        for count in (1, 2, 3, 7, 8, 9, 17, 63, 64, 65, 131):
            inputs = [a.astype(dtype) for a in batches(given, count)]
            found = kernel(*inputs)
            expected = found if isinstance(found, tuple) else (found,)
            for number, (there, laid) in enumerate(LAID.items()):
                for place in (slice(None), slice(number % len(inputs), number % len(inputs) + 1)):
                    some = [laid(a) if k in range(len(inputs))[place] else a for k, a in enumerate(inputs)]
                    for back, put in LAID.items():
                        outputs = tuple(put(a.astype(dtype)) for a in batches(returned, count))
                        kernel(*some, out=outputs)
                        for a, b in zip(outputs, expected, strict=True):
                            assert np.array_equal(a, b), (there, back, count)


def test_rows_may_lie_far_from_each_other():
    """Items as far apart as if they were without gaps, and so many that results without gaps go around the cache."""
    x = sp.Symbol("x")
    kernel = chasles.compile(sp.Matrix(3, 3, [k + x for k in range(9)]), [x])
    room = np.zeros((3, 240_000, 9))
    kernel(np.arange(240_000.0), out=room[:, :, :3].transpose(1, 0, 2))
    rows = np.arange(9.0).reshape(3, 1, 3) + np.arange(240_000.0)[:, None]
    assert np.array_equal(room[:, :, :3], rows)
    assert not room[:, :, 3:].any()
