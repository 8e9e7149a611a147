"""What does a batch need to know of a kernel? Its operands' core shapes, in the words of `batches.h`."""

from __future__ import annotations

from dataclasses import dataclass

from chasles.lowering.program import Op
from chasles.targets.c.blocks import block_name, loop_name
from chasles.targets.c.parts import parts_of
from chasles.targets.c.sincos import CIRCULAR
from chasles.targets.constants import Precision
from chasles.targets.kernel import EmissionError, TargetKernel
from chasles.targets.layout import listed


@dataclass(frozen=True, slots=True)
class Loop:
    """The constant that describes a kernel in one precision, as the template lays it out."""

    name: str
    number: str
    silent: int
    most: str
    gaps: str
    inputs: int
    operands: int
    shapes: tuple[str, ...]
    block: str


def loop(kernel: TargetKernel, precision: Precision, *, gaps: bool) -> Loop:
    """The constant for the kernel, whose blocks take items with `gaps` whatever their registers.

    Raises EmissionError for an operand of more than two core axes.
    """
    program = kernel.program
    shapes = []
    for item in program.parameters:
        if len(item.shape) > 2:
            raise EmissionError(
                f"{kernel.name}: {item.name} has {len(item.shape)} core axes; a batch knows none, one or two"
            )
        rows, columns = (1, 1, *item.shape)[-2:]
        shapes.append(f"{{{len(item.shape)}, {rows}, {columns}}}")
    name, cut = loop_name(kernel, precision), parts_of(program).parts
    return Loop(
        name=name,
        number=precision.name,
        silent=int(any(step.op is Op.NOT_A_NUMBER for step in program.steps)),
        most="CHASLES_BLOCK" if any(step.op in CIRCULAR for step in program.steps) else "CHASLES_LONG_BLOCK",
        gaps="2" if gaps or cut else "CHASLES_GAPS",
        inputs=len(program.arguments),
        operands=len(program.parameters),
        shapes=listed(f"static const chasles_shape {name}_shapes[] = {{", shapes, "};", closing_line=True),
        block=block_name(kernel, precision),
    )
