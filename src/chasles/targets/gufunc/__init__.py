"""Generalised ufuncs: one CPython extension module over the batches of the C library, in float64 and float32.

The loops themselves are the C library's; here stand the ufuncs that hand batches to them, and the light functions of
`chasles.kernels.one`, which take one element or a contiguous batch without the ufunc machinery, and the factory that
makes a ufunc of a loop that `chasles.compile` has compiled.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from chasles.targets.c.blocks import loop_name
from chasles.targets.constants import DOUBLE, SINGLE
from chasles.targets.contract import contract_in_arrays
from chasles.targets.kernel import TargetKernel, signature
from chasles.targets.target import Page, Target

# The order in which NumPy looks for a loop: the first that takes the inputs without loss.
_LOOPS = (SINGLE, DOUBLE)
_ESCAPES = {"\n": "\\n", '"': '\\"', "\\": "\\\\", "?": "\\?"}


@dataclass(frozen=True, slots=True)
class _Ufunc:
    """A kernel as the template lays it out."""

    name: str
    loops: str
    operands: str
    docstring: tuple[str, ...]
    signature: str


def _ufunc(kernel: TargetKernel) -> _Ufunc:
    program = kernel.program
    call = f"{kernel.name}({', '.join(item.name for item in program.arguments)}, /, *, out=None)"
    return _Ufunc(
        name=kernel.name,
        loops=", ".join(f"&{loop_name(kernel, precision)}" for precision in _LOOPS),
        operands=", ".join(c_string(item.name) for item in program.parameters),
        docstring=tuple(c_string(f"{line}\n") for line in (call, "--", "", *contract_in_arrays(kernel))),
        signature=c_string(signature(program)),
    )


def _pages(kernels: tuple[TargetKernel, ...]) -> Iterator[Page]:
    values = {"ufuncs": [_ufunc(kernel) for kernel in kernels], "count": len(kernels)}
    for name in ("kernels.h", "_kernels.c", "light.c", "factory.c"):
        yield Page(name, f"{name}.jinja", values)


TARGET = Target("gufunc", Path(__file__).parent, _pages)


def c_string(text: str) -> str:
    """The literal of the text in UTF-8; bytes beyond ASCII are octal escapes, the same for every compiler."""
    parts = []
    for character in text:
        if character in _ESCAPES:
            parts.append(_ESCAPES[character])
        elif character.isascii():
            parts.append(character)
        else:
            parts += [f"\\{byte:03o}" for byte in character.encode()]
    return f'"{"".join(parts)}"'
