"""The steps of a program as numbers, each a definition by earlier ones: a problem in the words of its request.

The polynomials of the problem see through all of them. Where a program divides by zero it gives no number, so that what
it divides by is assumed not to vanish; a scale, on which no result depends, may be any positive number. A root is a
length of the request, over a scale or not; a cosine that of a length that is an angle, or of a part of it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import Any

from chasles import vocabulary as w
from chasles.coq.expressions import EntryOf, Unsaid
from chasles.deciding import decided
from chasles.lowering.equivalence.rotation_vectors import by_directions
from chasles.lowering.program import Op, Program, Step
from chasles.lowering.request import Request
from chasles.lowering.scales import is_scale
from chasles.statements import Goal, Hypothesis, Problem, nonzero, positive
from chasles.statements.inverses import reached
from chasles.statements.simpler_words import in_simpler_words
from chasles.statements.varied import opened_parts
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
ZERO = Step(Op.CONSTANT)
PARTS = (Fraction(1), Fraction(1, 2), Fraction(2), Fraction(1, 4))
"""Of which multiples of a length that is an angle a program may take cosines and sines."""


@dataclass(frozen=True, slots=True)
class FunctionStep:
    """A number that is a function of another one: a root, cosine or sine. The problem says of what else, and why."""

    symbol: w.Symbol
    function: str
    of: w.Node
    problem: Problem
    certificate: Mapping[str, Any]


class ProgramSteps:
    """The steps of a program as numbers, in the words of its request; raises `Unsaid` for what has none.

    `functions` are those that are functions of what is shown to be said by the request; `entries` what is read.
    """

    def __init__(self, request: Request, program: Program) -> None:
        self.request, self.program = request, program
        goals = tuple(Goal(output.name, output.value, output.value) for output in request.outputs)
        simple = in_simpler_words(Problem(goals, request.rules, hypotheses=request.hypotheses))
        self._asked, self._said, turning = by_directions(simple, request.of)
        sides = (part for side in self._asked.sides_and_rules for part in opened_parts(side))
        self._angles = [*map(self._said, turning)]
        self._lengths = [*dict.fromkeys((*self._angles, *(part for part in sides if isinstance(part, w.Norm))))]
        self.rules: list[tuple[w.Node, w.Node]] = []
        self.assumed: list[Hypothesis] = [*map(positive, self._asked.nonnegative)]
        self.entries: dict[w.Node, EntryOf] = {}
        self.functions: dict[w.Node, FunctionStep] = {}
        self._scales: list[w.Node] = []
        self._values: list[w.Node | None] = []
        for step in program.steps:
            self._values.append(self._value(step))

    @property
    def problem(self) -> Problem:
        """That all results are what is requested."""
        return Problem(tuple(self._goals()), (*self._asked.rules, *self.rules), hypotheses=self._hypotheses)

    @property
    def _hypotheses(self) -> tuple[Hypothesis, ...]:
        return tuple(dict.fromkeys((*self._asked.hypotheses, *self.assumed)))

    def _goals(self) -> Iterator[Goal]:
        for output, result, asked in zip(self.request.outputs, self.program.results, self._asked.goals, strict=False):
            made = {(i, j): self._read(k) for (_, i, j), k in zip(output.places, result.entries, strict=True)}
            rows, columns = output.value.shape
            # Of what is packed one half is given.
            lines = (tuple(made[(i, j) if (i, j) in made else (j, i)] for j in range(columns)) for i in range(rows))
            yield Goal(result.name, made[0, 0] if (rows, columns) == (1, 1) else w.Block(tuple(lines)), asked.right)

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
                self._scales.append(scale)
                return scale
            case Op.SELECT if (guarded := self._guarded(step)) is not None:
                return guarded
            case Op.SQUARE_ROOT:
                of = self._read(step.operands[0])
                lengths = ((value, w.Power(value, 2)) for value in self._over_scales(self._lengths))
                return self._function("sqrt", of, lengths)
            case Op.COSINE | Op.SINE if self._angles:
                of, name = self._read(step.operands[0]), "cos" if step.op is Op.COSINE else "sin"
                angles = (w.Scale(w.Number(part), angle) for part, angle in product(PARTS, self._angles))
                return self._function(name, of, ((w.Call(name, angle), angle) for angle in angles))
            case Op.SELECT | Op.LESS | Op.EQUAL | Op.NOT_A_NUMBER:
                return None
        if step.op not in SPELLED:
            raise Unsaid(f"no proof is written of a program with a step {step.op.value.replace('_', ' ')}")
        value = SPELLED[step.op](*map(self._read, step.operands))
        if step.op is Op.NEGATE:
            return value
        if isinstance(value, w.Quotient) and not isinstance(value.denominator, w.Number):
            self.assumed.append(nonzero(value.denominator))
        return self._defined(value)

    def _defined(self, value: w.Node) -> w.Symbol:
        symbol = self._symbol(value)
        self.rules.append((symbol, value))
        return symbol

    def _over_scales(self, lengths: Iterable[w.Node]) -> Iterator[w.Node]:
        """The lengths, and what they are over each scale."""
        for length in lengths:
            yield from (length, *(w.Quotient(length, scale) for scale in self._scales))

    def _function(self, function: str, of: w.Node, ways: Iterable[tuple[w.Node, w.Node]]) -> w.Node:
        """A function of a number: the first of these values whose argument it is seen to be."""
        for value, argument in ways:
            sides = of, argument
            rules = dict((*self._asked.rules, *self.rules))
            used = reached(sides, rules)
            problem = Problem(
                (Goal("", *sides),),
                tuple((left, right) for left, right in rules.items() if left in used),
                hypotheses=self._hypotheses,
            )
            verdict = decided(problem)
            if isinstance(verdict, Holds | HoldsUnder):
                symbol = self._defined(value)
                self.functions[symbol] = FunctionStep(symbol, function, of, problem, verdict.certificate)
                return symbol
        raise Unsaid(f"no proof is written of a program with a {function} of what the request does not speak of")

    def _input(self, node: w.Node, i: int, j: int) -> w.Node:
        if node.is_scalar:
            return self._said(node)
        entry = self._said(Submatrix(node, (i + 1, i + 1), (j + 1, j + 1), "").definition)
        self.entries[entry] = (self._said(node), i, j)
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

    def _guarded(self, step: Step) -> w.Node | None:
        """What a step chooses where a number is not zero, if all that it is used for has no value where it is zero."""
        steps, number = self.program.steps, len(self._values)
        test, chosen, otherwise = step.operands
        compared = [k for k in steps[test].operands if steps[k] != ZERO]
        if steps[test].op is not Op.EQUAL or len(compared) != 1 or steps[chosen] != ZERO:
            return None
        uses = [each for each in steps if number in each.operands and each.op is not Op.EQUAL]
        if any(each.op is not Op.DIVIDE for each in uses) or any(
            number in each.entries for each in self.program.results
        ):
            return None
        if all(compared[0] in (each.operands[1], *steps[each.operands[1]].operands) for each in uses):
            return self._values[otherwise]
        if all(each.operands[1] == number for each in uses):
            self.assumed.append(nonzero(self._read(compared[0])))
            return self._values[otherwise]
        return None
