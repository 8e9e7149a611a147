"""Kernels as theorems: the results of a program are what the statement says, over the real numbers.

Every step is a number that is said by earlier ones, a definition like any other: the polynomials of the problem see
through all of them, and the proof is that of a statement. Where a program divides by zero it gives no number, so that
what it divides by is assumed not to vanish; a scale, on which no result depends, may be any positive number.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace

from chasles import vocabulary as w
from chasles.coq.claims import Claimed
from chasles.coq.expressions import EntryOf, Unsaid
from chasles.coq.proof import proof_of
from chasles.coq.sentences import holding
from chasles.coq.statement import CoqStatement
from chasles.coq.theorems import named
from chasles.deciding import decided
from chasles.decisions.decision import key_of
from chasles.lowering.declaration import Decide, requested
from chasles.lowering.lower import program_of
from chasles.lowering.program import Op, Program, Step
from chasles.lowering.refusal import LoweringError
from chasles.lowering.request import Request
from chasles.lowering.scales import is_scale
from chasles.statements import Entry, Goal, Hypothesis, Problem, nonzero, positive
from chasles.statements.simpler_words import in_simpler_words
from chasles.verdict import Holds, HoldsUnder
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.parts import Submatrix

SPELLED: dict[Op, Callable[..., w.Node]] = {
    Op.ADD: lambda a, b: w.Sum((a, b)),
    Op.SUBTRACT: lambda a, b: w.Sum((a, w.Negative(b))),
    Op.MULTIPLY: w.Scale,
    Op.DIVIDE: w.Quotient,
    Op.NEGATE: w.Negative,
    Op.SINE: lambda angle: w.Call("sin", angle),
    Op.COSINE: lambda angle: w.Call("cos", angle),
}


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
        steps = _Steps(request, program)
        problem = steps.problem
        statement = CoqStatement(problem, entries=steps.entries)
        claim = replace(claim, said=holding(name, statement))
        verdict = decided(problem)
        if not isinstance(verdict, Holds | HoldsUnder):
            raise Unsaid("the program is not seen to compute what the statement says")
        return replace(claim, proof=proof_of(name, statement, verdict.certificate)), problem
    except Unsaid as reason:
        return replace(claim, why_not=str(reason)), problem


class _Steps:
    """The steps of a program as numbers, in the words of its request; raises `Unsaid` for what has none."""

    def __init__(self, request: Request, program: Program) -> None:
        self.request, self.program = request, program
        self.rules: list[tuple[w.Node, w.Node]] = []
        self.assumed: list[Hypothesis] = []
        self.entries: dict[w.Node, EntryOf] = {}
        self._values: list[w.Node | None] = []
        for step in program.steps:
            self._values.append(self._value(step))

    @property
    def problem(self) -> Problem:
        """That all results are what is requested."""
        request = self.request
        rules, assumed = (*request.rules, *self.rules), (*request.hypotheses, *self.assumed)
        problem = Problem(tuple(self._goals()), rules, hypotheses=tuple(dict.fromkeys(assumed)))
        return in_simpler_words(problem)

    def _goals(self) -> Iterator[Goal]:
        for output, result in zip(self.request.outputs, self.program.results, strict=True):
            made = {(i, j): self._read(k) for (_, i, j), k in zip(output.places, result.entries, strict=True)}
            rows, columns = output.value.shape
            # Of what is packed one half is given.
            lines = (tuple(made[(i, j) if (i, j) in made else (j, i)] for j in range(columns)) for i in range(rows))
            yield Goal(result.name, made[0, 0] if (rows, columns) == (1, 1) else w.Block(tuple(lines)), output.value)

    def _value(self, step: Step) -> w.Node | None:
        """A step as an expression: a symbol that is said by a rule, or what needs none; None for a choice."""
        match step.op:
            case Op.INPUT:
                return self._input(*self.request.place(step.argument, step.entry))
            case Op.CONSTANT:
                return w.Number(step.value)
            case Op.SELECT if is_scale(self.program.steps, len(self._values)):
                scale = self._symbol(self._read(self._of_scale(step)))
                self.assumed.append(positive(scale))
                return scale
            case Op.SELECT | Op.LESS | Op.EQUAL | Op.NOT_A_NUMBER:
                return None
        if step.op not in SPELLED:
            raise Unsaid(f"no proof is written of a program with a step {step.op.value.replace('_', ' ')}")
        operands = self._unguarded(step) if step.op is Op.DIVIDE else step.operands
        value = SPELLED[step.op](*map(self._read, operands))
        if step.op is Op.NEGATE:
            return value
        if isinstance(value, w.Quotient) and not isinstance(value.denominator, w.Number):
            self.assumed.append(nonzero(value.denominator))
        symbol = self._symbol(value)
        self.rules.append((symbol, value))
        return symbol

    def _input(self, node: w.Node, i: int, j: int) -> w.Node:
        if node.is_scalar:
            return node
        entry = Submatrix(node, (i + 1, i + 1), (j + 1, j + 1), "").definition
        self.entries[entry] = (node, i, j)
        return entry

    def _symbol(self, like: w.Node) -> w.Symbol:
        """A number of the dimension of an expression."""
        name = f"s_{len(self._values)}"
        return w.Symbol(name, name, measured(like))

    def _read(self, number: int) -> w.Node:
        value = self._values[number]
        if value is None:
            raise Unsaid("no proof is written of a program that chooses between cases")
        return value

    def _of_scale(self, step: Step) -> int:
        """One of the numbers of which a step is the scale."""
        number = step.operands[-1]
        while self._values[number] is None:
            number = self.program.steps[number].operands[-1]
        return number

    def _unguarded(self, step: Step) -> tuple[int, ...]:
        """The operands of a quotient, without the zero that the numerator is where the divisor is zero."""
        steps, (above, below) = self.program.steps, step.operands
        if steps[above].op is Op.SELECT:
            test, _, otherwise = steps[above].operands
            others = [steps[k] for k in steps[test].operands if k != below]
            if steps[test].op is Op.EQUAL and others == [Step(Op.CONSTANT)]:
                return otherwise, below
        return step.operands
