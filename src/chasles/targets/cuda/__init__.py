"""CUDA: a header for each kernel, with its functions for host and device and kernels that compute batches.

The functions are those of C. Without nvcc the header is C++ and has the functions of the host alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from chasles.lowering.names import Names
from chasles.targets.c.alone import STRICT
from chasles.targets.c.functions import precisions_of, public_name, single
from chasles.targets.c.language import RESERVED
from chasles.targets.constants import DOUBLE, Precision
from chasles.targets.kernel import TargetKernel, signature
from chasles.targets.layout import listed
from chasles.targets.target import Page, Target

_USED = {"count", "item", "needed", "stride", "stream", "threads", "most", "blocks"}
_BUILT_IN = {"blockDim", "blockIdx", "gridDim", "threadIdx", "warpSize"}
_DEEPER = "\n        "


def _pages(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    for kernel in kernels:
        values = {
            "guard": public_name(kernel, DOUBLE).upper(),
            "signature": signature(kernel.program),
            "functions": [single(kernel, precision, STRICT) for precision in precisions_of(kernel)],
            "batches": [_batch(kernel, precision) for precision in precisions_of(kernel)],
        }
        yield Page(f"{kernel.name}.cuh", "kernel.cuh.jinja", values)


def _batch(kernel: TargetKernel, precision: Precision) -> dict[str, str]:
    """A kernel that computes `count` items, each argument with a step of its own, and the function that starts it."""
    program = kernel.program
    name, launcher = (public_name(kernel, precision, variant) for variant in ("_items", "_batch"))
    names = Names(RESERVED | _USED | _BUILT_IN | {public_name(kernel, precision), name, launcher})
    words = [names.take(item.name) for item in program.parameters]
    steps = [names.take(f"{word}_step") for word in words]
    parameters, passed, places = ["size_t count"], ["count"], []
    for position, (word, step, item) in enumerate(zip(words, steps, program.parameters, strict=True)):
        is_input = position < len(program.arguments)
        parameters.append(f"{'const ' if is_input else ''}{precision.name} *{word}, ptrdiff_t {step}")
        passed.append(f"{word}, {step}")
        place = f"{word} + item * {step}"
        places.append(place if item.shape or not is_input else f"{word}[item * {step}]")
    queued = [*parameters, "cudaStream_t stream = nullptr"]
    return {
        "prototype": "\n".join(listed(f"static __global__ void {name}(", parameters, ")")),
        "call": _DEEPER.join(listed(f"{public_name(kernel, precision)}(", places, ");")),
        "launcher": "\n".join(listed(f"inline cudaError_t {launcher}(", queued, ")")),
        "launch": _DEEPER.join(listed(f"{name}<<<blocks, threads, 0, stream>>>(", passed, ");")),
    }


TARGET = Target("cuda", Path(__file__).parent, _pages, _pages, by_default=False)
