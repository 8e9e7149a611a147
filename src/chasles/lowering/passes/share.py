"""Equal steps become one, constants are folded and signs absorbed: every step is asked for anew."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace as with_fields

from chasles.lowering.builder import Builder
from chasles.lowering.program import Op, Program

__all__ = ["shared"]


def shared(program: Program) -> Program:
    """The same program with common subexpressions computed once; for programs that were not built that way."""
    build = Builder()
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
    place: list[int] = []
    for step in program.steps:
        match step.op:
            case Op.INPUT:
                place.append(build.input(step.argument, step.entry))
            case Op.CONSTANT:
                place.append(build.constant(step.value))
            case _:
                place.append(ask[step.op](*(place[k] for k in step.operands)))
    results = tuple(with_fields(r, entries=tuple(place[k] for k in r.entries)) for r in program.results)
    return with_fields(program, steps=build.steps, results=results)
