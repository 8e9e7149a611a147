"""The same inputs in other storage: a result may not depend on where its numbers lie, nor on what lies there later."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from types import ModuleType
from typing import Any

import numpy as np

from chasles.lowering.program import Program

__all__ = ["LAYOUTS", "unlike"]

Array = np.ndarray[Any, Any]
Call = Callable[..., Any]


def _turned(value: Array) -> Array:
    """Every axis with a negative stride."""
    back = tuple(slice(None, None, -1) for _ in value.shape)
    return value[back].copy()[back]


def _gapped(value: Array) -> Array:
    """Other numbers between the items."""
    wide = np.full((2 * len(value), *value.shape[1:]), 7, value.dtype)[::2]
    wide[...] = value
    return wide


def _apart(call: Call, inputs: Sequence[Array], plain: Sequence[Array], arrange: Callable[[Array], Array]) -> Any:
    outs = tuple(arrange(np.zeros_like(x)) for x in plain)
    return call(*map(arrange, inputs), out=outs if len(outs) > 1 else outs[0])


def _overlapping(call: Call, inputs: Sequence[Array], plain: Sequence[Array]) -> Any:
    """Each output begins a number after an input does, in the same storage."""
    given, outs = list(inputs), []
    for k, out in enumerate(plain):
        source = inputs[k % len(inputs)]
        store = np.zeros(max(source.size, out.size + 1), source.dtype)
        view = store[: source.size].reshape(source.shape)
        view[...] = source
        if k < len(inputs):
            given[k] = view
        outs.append(store[1 : out.size + 1].reshape(out.shape))
    return call(*given, out=tuple(outs) if len(outs) > 1 else outs[0])


def _in_place(call: Call, inputs: Sequence[Array], plain: Sequence[Array]) -> Any:
    """An output in the place of an input of its shape; where there is none, in a new one."""
    given = [np.array(x) for x in inputs]
    free = list(given)
    outs = []
    for out in plain:
        same = next((x for x in free if x.shape == out.shape), None)
        outs.append(np.zeros_like(out) if same is None else same)
        free = [x for x in free if x is not same]
    return call(*given, out=tuple(outs) if len(outs) > 1 else outs[0])


LAYOUTS: dict[str, Callable[[Call, Sequence[Array], Sequence[Array]], Any]] = {
    "negative strides": lambda call, inputs, plain: _apart(call, inputs, plain, _turned),
    "gaps": lambda call, inputs, plain: _apart(call, inputs, plain, _gapped),
    "overlapping": _overlapping,
    "in place": _in_place,
}


def unlike(program: Program, modules: dict[str, ModuleType], inputs: Sequence[Array]) -> Iterator[str]:
    """The modules and layouts in which a result has other bits than in fresh storage; NaN is like NaN."""
    with np.errstate(all="ignore"):
        for title, module in modules.items():
            call = getattr(module, program.name)
            found = call(*inputs)
            plain = found if isinstance(found, tuple) else (found,)
            for name, arranged in LAYOUTS.items():
                again = arranged(call, inputs, plain)
                pairs = zip(plain, again if isinstance(again, tuple) else (again,), strict=True)
                if not all(np.array_equal(one, other, equal_nan=True) for one, other in pairs):
                    yield f"{title}, {name}"
