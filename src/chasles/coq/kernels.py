"""Kernels as theorems: the results of a program are what the statement says, over the real numbers.

The proof is that of a statement about the lengths and angles of the request; that the roots, cosines and sines of the
program are of these is shown first.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from chasles.coq.expressions import ATOM, EntryOf, Unsaid
from chasles.coq.program_steps import FunctionStep, ProgramSteps
from chasles.coq.proof import proof_of, steps_of, theorem
from chasles.coq.sentences import NOW, Claimed, asserted, assumed, holding, introduced
from chasles.coq.statement import CoqStatement, Premise
from chasles.coq.theorems import named
from chasles.deciding import decided
from chasles.decisions.decision import key_of
from chasles.lowering.declaration import Decide, requested
from chasles.lowering.lower import program_of
from chasles.lowering.program import Program
from chasles.lowering.refusal import LoweringError
from chasles.lowering.request import Request
from chasles.statements import Entry, Problem
from chasles.verdict import Holds, HoldsUnder
from chasles.vocabulary import Node

LONG = "first [nonnegative | apply norm_not_negative | apply Rle_mult_inv_pos; [apply norm_not_negative | above]]"
"""The step by which a length, over a scale or not, is not negative."""


def kernels_of(entries: Iterable[Entry], decide: Decide) -> Iterator[tuple[Claimed, Problem | None]]:
    """What is claimed of each kernel of these, and the problem that says it; None where there is none."""
    for entry in entries:
        for kernel in entry.kernels:
            key = key_of(entry.statement)
            try:
                request = requested(entry, decide, kernel)
                yield claim_of_kernel(key, request, program_of(request))
            except LoweringError as error:
                yield Claimed(key, "kernel", "", "", why_not=str(error), kernel=kernel.name), None


def claim_of_kernel(key: str, request: Request, program: Program) -> tuple[Claimed, Problem | None]:
    """That a program computes what is requested, with its proof or why there is none; and the problem that says it."""
    name = f"kernel_{named(request.name)}"
    said = f"what the program of {len(program.steps)} steps computes"
    claim = Claimed(key, f"kernel {request.name}", name, said, kernel=request.name)
    problem = None
    try:
        if request.functions:
            raise Unsaid("it has functions of which Coq is told in statements only")
        steps = ProgramSteps(request, program)
        problem = steps.problem
        statement = ProgramStatement(problem, steps.entries, steps.functions)
        claim = replace(claim, said=holding(name, statement))
        verdict = decided(problem)
        if not isinstance(verdict, Holds | HoldsUnder):
            raise Unsaid("the program is not seen to compute what the statement says")
        if steps.functions:
            return replace(claim, proof=theorem(name, _with_functions(statement, verdict.certificate))), problem
        return replace(claim, proof=proof_of(name, statement, verdict.certificate)), problem
    except Unsaid as reason:
        return replace(claim, why_not=str(reason)), problem


class ProgramStatement(CoqStatement):
    """The statement of a program, which says of each of these steps that it is a function of a number."""

    def __init__(
        self, problem: Problem, entries: Mapping[Node, EntryOf], functions: Mapping[Node, FunctionStep]
    ) -> None:
        self.functions = functions
        super().__init__(problem, entries=entries)

    def _definitions(self) -> Iterator[Premise]:
        for premise in super()._definitions():
            step = self.functions.get(premise.about)  # type: ignore[call-overload]
            number = self.spelling.number
            says = step and f"{number(step.symbol)} = {step.function} {number(step.of, ATOM)}"
            yield replace(premise, says=says or premise.says)


def _with_functions(said: ProgramStatement, certificate: Mapping[str, Any]) -> Iterator[str]:
    """The steps by which roots, cosines and sines are of lengths and angles, and then the results what is requested."""
    plain = CoqStatement(said.problem, said.names, said.spelling.entries)
    yield from asserted("plain'", plain, steps_of(plain, certificate))
    premises = {each.about: each for each in plain.premises if each.about in said.functions}
    values = [CoqStatement(step.problem, said.names, said.spelling.entries) for step in said.functions.values()]
    for count, (step, value) in enumerate(zip(said.functions.values(), values, strict=True)):
        yield from asserted(f"value'{count}", value, steps_of(value, step.certificate))
    yield f"intros {introduced(said)}."
    for count, (step, value) in enumerate(zip(said.functions.values(), values, strict=True)):
        if value.timed:
            raise Unsaid("no proof is written of a root, cosine or sine of what is made of rates")
        premise = premises[step.symbol]
        at_once = [f"specialize ({each.name}{NOW}); cbv beta in {each.name}" for each in said.premises if each.moves]
        given = " ".join(f"({name} t)" if said.moves(node) else name for node, name in value.names.symbols.items())
        equal = f"apply (value'{count} {given}); assumption"
        shown = f"rewrite {premise.name}; f_equal; {equal}"
        if step.function == "sqrt":
            shown = f"apply (root_value _ _ _ {premise.name}); [{LONG} | {equal}]"
        there = "; ".join((*[f"intros{NOW}"] * said.timed, *at_once, shown))
        yield f"assert (said'{count} : {assumed(premise)}) by ({there})."
        yield f"clear {premise.name}. rename said'{count} into {premise.name}."
    yield f"apply (plain' {' '.join(name for name, _ in said.binders)}); assumption."
