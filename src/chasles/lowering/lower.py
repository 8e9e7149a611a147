"""From a statement that stands to a straight-line program, without any target language."""

from __future__ import annotations

from collections.abc import Iterator

from chasles.lowering.builder import Builder
from chasles.lowering.cost import cost
from chasles.lowering.declaration import Decide, Sentence, requested
from chasles.lowering.expansion import Expansion
from chasles.lowering.passes.guard import guarded
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Argument, Program, Result
from chasles.lowering.request import Request, argument_name, core_shape, meaning_of
from chasles.statements import Entry, Kernel

__all__ = ["lower", "program_of"]


def lower(sentence: Entry | Sentence, decide: Decide, kernel: Kernel | None = None) -> Program:
    """The program of a sentence's kernel, in the form of the sentence that stands; `decide` is `Judge.decide`.

    Raises `LoweringError` where the sentence asks for no kernel, is undecided or false without a correction that holds,
    or has a symbol that is neither an argument nor defined by what is given.
    """
    return program_of(requested(sentence, decide, kernel))


def program_of(request: Request) -> Program:
    """The cheapest of the programs that the request's expressions spell; NaN where one of its divisors is zero."""
    return guarded(min(_candidates(request), key=cost))


def _candidates(request: Request) -> Iterator[Program]:
    """Matrices that a rule defines may be kept in their structure, or written in components once and for all."""
    for dense in (False, True):
        yield pruned(_expanded(request, dense=dense))


def _expanded(request: Request, *, dense: bool) -> Program:
    expansion = Expansion(Builder(), request, dense=dense)
    results = []
    for output in request.outputs:
        rows = expansion.rows(output.value)
        entries = tuple(rows[i][j] for _, i, j in output.places)
        results.append(Result(output.name, output.shape, output.meaning, entries))
    arguments = tuple(Argument(argument_name(item), core_shape(item), meaning_of(item)) for item in request.arguments)
    return Program(request.name, arguments, expansion.builder.steps, tuple(results))
