"""From an accepted statement to a straight-line program, without any target language."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import reduce
from math import sqrt

import numpy as np

from chasles.lowering.builder import Builder
from chasles.lowering.cost import price
from chasles.lowering.declaration import Decide, Sentence, requested
from chasles.lowering.expansion import Expansion
from chasles.lowering.passes.angles import respelled
from chasles.lowering.passes.guard import guarded
from chasles.lowering.passes.prune import pruned
from chasles.lowering.passes.scale import scaled
from chasles.lowering.program import Argument, Op, Program, Result
from chasles.lowering.request import Request
from chasles.lowering.rounding import ANGLES, angular_entries, generic_numbers, steady
from chasles.statements import Entry, Kernel
from chasles.statements.arrays import argument_name, core_shape, meaning_of, places_of
from chasles.vocabulary import Node

LAST: tuple[Callable[[Program], Program], ...] = (guarded,)
"""What is done to the program that was chosen, one pass after the other."""


def lower(sentence: Entry | Sentence, decide: Decide, kernel: Kernel | None = None) -> Program:
    """The program of a sentence's kernel, in the accepted form of the sentence; `decide` is `Session.decide`.

    Raises `LoweringError` where the sentence asks for no kernel, is undecided or false without a correction that holds,
    or has a symbol that is neither an argument nor defined by what is given.
    """
    return program_of(requested(sentence, decide, kernel))


def program_of(request: Request) -> Program:
    """The cheapest of the programs that lose no digits another one keeps; NaN where one of its divisors is zero."""
    cheapest = min(map(scaled, stable(request, list(dict.fromkeys(_candidates(request))))), key=price)
    return reduce(lambda program, last: last(program), LAST, cheapest)


def _candidates(request: Request) -> Iterator[Program]:
    """The request's words in several spellings.

    Matrices that a rule defines may be kept in their structure, or written in components once and for all; functions of
    one angle may stay as they are, or be written in lowest terms of the angle or of its half.
    """
    seen: list[Program] = []
    for dense in (False, True):
        spelled = pruned(expanded(request, dense=dense))
        if spelled in seen:
            continue
        seen.append(spelled)
        yield spelled
        if spelled.operations[Op.SINE] + spelled.operations[Op.COSINE]:
            for halved in (False, True):
                yield pruned(respelled(spelled, halved=halved))


def expanded(request: Request, *, dense: bool) -> Program:
    """The program that the request's words spell; `dense` writes every matrix that a rule defines in components."""
    expansion = Expansion(Builder(), request, dense=dense)
    results = []
    for output, value in zip(request.outputs, request.spelled, strict=True):
        rows = expansion.rows(value)
        entries = tuple(rows[i][j] for _, i, j in output.places)
        results.append(Result(output.name, output.shape, output.meaning, entries))
    arguments = tuple(Argument(argument_name(item), core_shape(item), meaning_of(item)) for item in request.arguments)
    return Program(request.name, arguments, expansion.builder.steps, tuple(results))


def stable(request: Request, programs: Sequence[Program]) -> list[Program]:
    """The programs that lose nowhere much more than the best of them does there; all where there are no angles."""
    angles = [node for node in request.of if node in _angles(programs, request)]
    if not angles or len(programs) == 1:
        return list(programs)
    # An array is one of angles, or a rotation vector, whose length is one.
    ways = (True,) if all(node.is_scalar for node in angles) else (True, False)
    points = [_point(request, dict.fromkeys(angles, value), each) for value in ANGLES for each in ways]
    return steady(programs, {place: np.array([point[place] for point in points]) for place in points[0]})


def _angles(programs: Sequence[Program], request: Request) -> set[Node]:
    """The arguments of which some program takes a cosine or sine."""
    return {request.place(*place)[0] for program in programs for place in angular_entries(program)}


def _point(request: Request, angles: dict[Node, float], each: bool) -> dict[tuple[int, int], float]:
    """Values of the arguments: the angles as given, unit vectors of unit length, the rest at large.

    In an array of angles `each` entry is as given, or the length is.
    """
    units = {h.subjects[0] for h in request.hypotheses if h.kind == "unit"}
    values: dict[Node, list[float]] = {}
    drawn = 0
    for node in request.of:
        size = node.shape[0] * node.shape[1]
        values[node] = [float(x) for x in generic_numbers(drawn, size)]
        drawn += size
        if node in units or (node in angles and not each):
            length = sqrt(sum(x * x for x in values[node]))
            values[node] = [x / length for x in values[node]]
        if node in angles:
            values[node] = [angles[node] if each else angles[node] * x for x in values[node]]
    return {
        (number, entry): values[node][i * node.shape[1] + j]
        for number, argument in enumerate(request.arguments)
        for entry, (node, i, j) in enumerate(places_of(argument))
    }
