"""How much longer a batch takes whose operands lie elsewhere than item after item, row after row.

Run it as `python -m benchmarks.strides [--rounds N] [--sizes N ...]` from the root of a checkout. For each kernel,
layout and size it prints the time by that of the contiguous batch, of the same run: with inputs so laid out, with
outputs, and with both, each with `out=`.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import sympy as sp
from benchmarks.timing import interleaved, ratio

import chasles
from chasles import kernels

Array = np.ndarray[Any, Any]
NAMES = (
    "rotation_from_axis_angle",
    "rotation_in_triad_axes",
    "twist_transfer",
    "velocity_of_point",
    "kinetic_energy",
    "inertia_about_point",
    "newton_euler_wrench",
)


def _order(a: Array, axes: tuple[int, ...]) -> Array:
    """The same array, with its axes in this order in memory."""
    return np.ascontiguousarray(a.transpose(axes)).transpose(np.argsort(axes))


def _every(step: int, a: Array) -> Array:
    room = np.zeros((a.shape[0] * abs(step), *a.shape[1:]), a.dtype)[::step]
    room[:] = a
    return room


def _wide(a: Array) -> Array:
    """Items that are columns of a wider table, each apart from its neighbour."""
    room = np.zeros((a.shape[0], *(n + 1 for n in a.shape[1:])), a.dtype)[(..., *(slice(n) for n in a.shape[1:]))]
    room[:] = a
    return room


LAYOUTS: dict[str, Callable[[Array], Array]] = {
    "Fortran order": np.asfortranarray,
    "items last": lambda a: _order(a, (*range(1, a.ndim), 0)),
    "transposed cores": lambda a: _order(a, (0, *range(a.ndim - 1, 0, -1))),
    "every second item": partial(_every, 2),
    "backwards": partial(_every, -1),
    "parts of wider arrays": _wide,
}


def batches(shapes: list[tuple[int, ...]], count: int) -> list[Array]:
    """Arrays of numbers in [0.5, 1.5], whose items have these shapes."""
    draw = np.random.default_rng(1)
    return [draw.uniform(0.5, 1.5, (count, *shape)) for shape in shapes]


def shapes_of(kernel: Any) -> tuple[list[tuple[int, ...]], list[tuple[int, ...]]]:
    """The core shapes of the inputs and of the outputs."""

    def parts(text: str) -> list[tuple[int, ...]]:
        return [tuple(int(n) for n in part.split(",") if n) for part in text[1:-1].split("),(")]

    given, returned = kernel.signature.split("->")
    return parts(given), parts(returned)


def calls(kernel: Any, count: int) -> dict[str, Callable[[], object]]:
    """A call for each layout, and `contiguous`."""
    given, returned = (batches(shapes, count) for shapes in shapes_of(kernel))

    def call(inputs: list[Array], outputs: list[Array]) -> Callable[[], object]:
        return partial(kernel, *inputs, out=tuple(outputs))

    made = {"contiguous": call(given, returned)}
    for name, laid in LAYOUTS.items():
        there, back = list(map(laid, given)), list(map(laid, returned))
        made[f"{name}, in"] = call(there, returned)
        made[f"{name}, out"] = call(given, back)
        made[f"{name}, both"] = call(there, back)
    if len(given) > 1:
        made["first input the same for all"] = call([given[0][:1], *given[1:]], returned)
    return made


def compiled() -> Any:
    """The positions of an arm with two links, and their derivatives."""
    q, lengths = sp.Matrix(sp.symbols("q1:3")), sp.Matrix(sp.symbols("l1:3"))
    elbow = sp.Matrix([sp.cos(q[0]), sp.sin(q[0])]) * lengths[0]
    tip = elbow + sp.Matrix([sp.cos(q[0] + q[1]), sp.sin(q[0] + q[1])]) * lengths[1]
    return chasles.compile([tip, tip.jacobian(q)], {"q": q, "lengths": lengths}, outputs=["tip", "jacobian"])


def main() -> None:
    """Print the ratios, kernel by kernel."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--sizes", type=int, nargs="+", default=[1_000, 10_000, 100_000])
    parser.add_argument("--kernels", nargs="+", default=[*NAMES, ""])
    chosen = parser.parse_args()
    for name in chosen.kernels:
        kernel = getattr(kernels, name) if name else compiled()
        found = {}
        for count in chosen.sizes:
            times = interleaved(calls(kernel, count), chosen.rounds)
            found[count] = {layout: ratio(each, times["contiguous"]) for layout, each in times.items()}
            found[count]["ns an item"] = min(times["contiguous"]) / count * 1e9
        print(f"\n{name or 'a compiled arm'} {kernel.signature}")
        for layout in found[chosen.sizes[0]]:
            print(f"  {layout:32}", *(f"{found[count][layout]:8.2f}" for count in chosen.sizes))


if __name__ == "__main__":
    main()
