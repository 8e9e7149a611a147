"""Equal steps become one, constants are folded and signs absorbed: every step is asked for anew."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace as with_fields

from chasles.lowering.builder import Builder
from chasles.lowering.program import Op, Program, Step

__all__ = ["asked", "shared"]


def asked(build: Builder, step: Step, operands: Sequence[int]) -> int:
    """The step of a builder that does to the operands, steps of the same builder, what `step` does to its own."""
    ask: dict[Op, Callable[..., int]] = {
        Op.NOT_A_NUMBER: build.not_a_number,
        Op.ADD: build.add,
        Op.SUBTRACT: build.subtract,
        Op.MULTIPLY: build.multiply,
        Op.DIVIDE: build.divide,
        Op.NEGATE: build.negate,
        Op.SQUARE_ROOT: build.square_root,
        Op.SINE: build.sine,
        Op.COSINE: build.cosine,
        Op.ARCTANGENT2: build.arctangent2,
        Op.LESS: build.less,
        Op.EQUAL: build.equal,
        Op.SELECT: build.select,
    }
    match step.op:
        case Op.INPUT:
            return build.input(step.argument, step.entry)
        case Op.CONSTANT:
            return build.constant(step.value)
        case op:
            return ask[op](*operands)


def shared(program: Program) -> Program:
    """The same program with common subexpressions computed once; for programs that were not built that way."""
    build = Builder()
    place: list[int] = []
    for step in program.steps:
        place.append(asked(build, step, [place[k] for k in step.operands]))
    results = tuple(with_fields(r, entries=tuple(place[k] for k in r.entries)) for r in program.results)
    return with_fields(program, steps=build.steps, results=results)
