"""Functions of scalars in a request: each is a symbol of its own, of which is known only of what it is a function.

A program is right whatever numbers the functions give: like functions of like arguments are one symbol. An angle that
is no sum of multiples of others is such a symbol, too.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce

from chasles import vocabulary as w
from chasles.lowering.builder import Builder
from chasles.statements.angles import linear_terms
from chasles.vocabulary import Node, Symbol
from chasles.vocabulary.differentiation import rate_of
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.functions import FunctionOf
from chasles.vocabulary.shorthand import Shorthand
from chasles.vocabulary.tree import with_parts

CALLED = {
    "abs": "fabs", "arcsinh": "asinh", "arccosh": "acosh", "arctanh": "atanh",
    **{name: name for name in ("exp", "log", "sinh", "cosh", "tanh")},
}  # fmt: skip
"""Functions of one number that programs call, by the names of the calls."""
ANGLE = "angle"
ANGLES = Symbol | Shorthand | w.Norm | w.Number | w.At | w.Rate
"""Of these sums of multiples are angles as they stand."""
ONE = w.Number(Fraction(1))


@dataclass(frozen=True, slots=True)
class NamedFunction:
    """A symbol that stands for a function of expressions, or for an angle, which is an expression itself."""

    symbol: Symbol
    function: str
    arguments: tuple[Node, ...]

    def made(self, build: Builder, operands: list[int]) -> int:
        """The step that holds its value, of those that hold its arguments."""
        match self.function:
            case "sqrt":
                return build.square_root(*operands)
            case "atan2":
                return build.arctangent2(*operands)
            case "max" | "min":
                first, second = operands if self.function == "min" else operands[::-1]
                return build.select(build.less(*operands), first, second)
            case _:
                return operands[0] if self.function == ANGLE else build.function(CALLED[self.function], *operands)


class NamedFunctions:
    """Gives functions of scalars in expressions their names, the same one to the same function of the same."""

    def __init__(self, rules: Mapping[Node, Node]) -> None:
        self._rules = rules
        self.known: dict[Node, NamedFunction] = {}

    def __call__(self, node: Node) -> Node:
        """The expression with a symbol for each function; one that no program computes stays as it is."""
        match node:
            case Symbol(stands_for=Node() as of) if not is_plain(of):
                return self(of)
            case Shorthand() if not is_plain(node):
                return self(node.definition)
            case w.Rate(of) if not is_plain(of):
                return self(rate_of(of))
            case FunctionOf(function, arguments):
                said = _in_few_functions(function, arguments)
                return self._named(said) if isinstance(said, FunctionOf) else self(said)
            case w.Call(function, argument):
                return self._of_angle(node, self(argument))
        return with_parts(node, self)

    def _named(self, node: FunctionOf) -> Node:
        arguments = tuple(map(self, node.arguments))
        if node.function not in (*CALLED, "sqrt", "atan2", "max", "min"):
            return FunctionOf(node.function, arguments)
        return self._symbol(FunctionOf(node.function, arguments), node.function, arguments)

    def _symbol(self, node: Node, function: str, arguments: tuple[Node, ...]) -> Symbol:
        if node not in self.known:
            name = f"function {len(self.known) + 1}"
            self.known[node] = NamedFunction(Symbol(name, name, measured(node), f"{node}"), function, arguments)
        return self.known[node].symbol

    def _of_angle(self, call: w.Call, argument: Node) -> Node:
        """The cosine or sine with a symbol for each term that is no multiple of a symbol, or of the length of one."""
        terms = [*linear_terms(argument, self._rules)]
        if all(isinstance(term, ANGLES) for term, _ in terms):
            return call if argument == call.argument else w.Call(call.function, argument)
        said = [w.Scale(w.Number(times), self._angle(term)) for term, times in terms]
        return w.Call(call.function, said[0] if len(said) == 1 else w.Sum(tuple(said)))

    def _angle(self, term: Node) -> Node:
        return term if isinstance(term, ANGLES) else self._symbol(term, ANGLE, (term,))


def _in_few_functions(function: str, arguments: tuple[Node, ...]) -> Node:
    """The same said by functions that programs have, of two numbers at the most."""
    match function, arguments:
        case (("max" | "min"), (first, *others)):
            return reduce(lambda one, other: FunctionOf(function, (one, other)), others, first)
        case "arctan", (of,):
            return FunctionOf("atan2", (of, ONE))
        case (("arcsin" | "arccos"), (of,)):
            across = FunctionOf("sqrt", (w.Scale(w.Group(ONE - of), w.Group(ONE + of)),))
            return FunctionOf("atan2", (of, across) if function == "arcsin" else (across, of))
        case _:
            return FunctionOf(function, arguments)


def is_plain(node: Node) -> bool:
    """Whether no function of scalars besides sine and cosine is in an expression."""
    return not any(
        isinstance(part, FunctionOf) or (isinstance(part, Shorthand) and not is_plain(part.definition))
        for part in w.walk(node)
    )
