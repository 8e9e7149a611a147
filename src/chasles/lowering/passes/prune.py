"""Dead code elimination: steps that no result reads are left out, the others numbered anew in their order."""

from __future__ import annotations

from dataclasses import replace as with_fields

from chasles.lowering.program import Program


def pruned(program: Program) -> Program:
    """The same program without dead steps."""
    alive = {entry for result in program.results for entry in result.entries}
    for number in reversed(range(len(program.steps))):
        if number in alive:
            alive.update(program.steps[number].operands)
    if len(alive) == len(program.steps):
        return program
    place = {number: new for new, number in enumerate(sorted(alive))}
    steps = tuple(
        program.steps[number].on(tuple([place[k] for k in program.steps[number].operands])) for number in place
    )
    results = tuple(with_fields(r, entries=tuple(place[k] for k in r.entries)) for r in program.results)
    return with_fields(program, steps=steps, results=results)
