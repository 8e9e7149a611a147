"""What must a kernel compute? Its inputs as symbols, its outputs, its hypotheses, its value to any number of digits."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chasles.evaluation.matrices import Matrix
from chasles.numerics.reference import MissingValue, Singular, Undetermined, evaluate
from chasles.statements import Hypothesis, Inverse, Kernel, Packed, Statement, problem_of, symmetric
from chasles.statements.arrays import argument_name, core_shape, places_of, variants
from chasles.statements.definitions import rules_behind
from chasles.statements.goals import AcceptedSides
from chasles.statements.kernel import Argument, nodes_of
from chasles.statements.posing import default_sides
from chasles.statements.statement import bare
from chasles.vocabulary import Block, Call, Node, Symbol, children, plain
from chasles.vocabulary.fitting import measured

ROUNDINGS = 16
"""How many roundings in a row a kernel may do where its program is not at hand."""

Values = Mapping[Node, Any]
Reference = Callable[[Values, int], tuple[Matrix, ...]]


@dataclass(frozen=True, slots=True)
class KernelInput:
    """An argument of the kernel, and the symbol, or rate of a symbol, or several, whose values it holds."""

    holds: Argument

    @property
    def name(self) -> str:
        """The argument's name in every language."""
        return argument_name(self.holds)

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of the array."""
        return core_shape(self.holds)

    @property
    def nodes(self) -> tuple[Node, ...]:
        """The symbols and rates of symbols."""
        return nodes_of(self.holds)

    def gathered(self, values: Mapping[Node, NDArray[Any]]) -> NDArray[Any]:
        """The argument as an array, from those of the symbols."""
        if isinstance(self.holds, Node):
            return values[self.holds].reshape(self.shape)
        return np.array([values[node].reshape(node.shape)[i, j] for node, i, j in places_of(self.holds)])


@dataclass(frozen=True, slots=True)
class ExpectedOutput:
    """A result; `alike` groups its entries (flat, row-major): those of one physical dimension are compared together."""

    name: str
    shape: tuple[int, ...]
    alike: tuple[tuple[int, ...], ...]


@dataclass(frozen=True, slots=True)
class Specification:
    """What a kernel must compute.

    `reference(values, digits)` gives every output as a matrix whose entries have so many right digits; it may raise
    `Singular`. `angles` are the inputs that occur in a sine or cosine. `roundings` is the length of the longest chain
    of rounded operations from an input to an output. With `exact_inputs` the reference is taken at the point that
    satisfies the hypotheses exactly and of which the inputs are the rounding, and not at the inputs themselves.
    """

    name: str
    inputs: tuple[KernelInput, ...]
    outputs: tuple[ExpectedOutput, ...]
    reference: Reference
    hypotheses: tuple[Hypothesis, ...] = ()
    rules: Mapping[Node, Node] = field(default_factory=dict)
    angles: frozenset[Node] = frozenset()
    roundings: int = ROUNDINGS
    exact_inputs: bool = False

    @property
    def nodes(self) -> tuple[Node, ...]:
        """The symbols, and rates of symbols, of which the inputs are the values."""
        return tuple(node for given in self.inputs for node in given.nodes)

    def admits(self, values: Values) -> bool:
        """Whether nothing vanishes, or is not real, that a hypothesis on the inputs says does not vanish."""
        for hypothesis in self.hypotheses:
            for node in hypothesis.nonvanishing:
                try:
                    if evaluate(node, values, self.rules, digits=1)[0][0] == 0:
                        return False
                except MissingValue:
                    continue
                except (Singular, ValueError, Undetermined):
                    return False
        return True


def specification_of(
    name: str,
    statement: Statement,
    kernel: Kernel | None = None,
    results: Sequence[str] = (),
    roundings: int = ROUNDINGS,
    accepted: AcceptedSides = default_sides,
) -> Specification:
    """What a statement's kernel must compute: the right side of the accepted form, as a function of the inputs.

    The reference applies what is given to the statement; an input comes before any rule. `results` are the
    names of the kernel's results. Raises TypeError if the statement asks for no kernel, or if the results are not as
    many as the blocks of the right side.
    """
    kernel = kernel or kernel_asked_by(statement, name)
    left, right = accepted(statement)
    problem = problem_of(statement.saying(left, right), "printed", accepted)
    rules = {**rules_behind(statement.given, accepted), **dict(problem.rules)}
    parts = _parts(statement, kernel, right)
    names = results or kernel.results or (plain(statement.left),)
    packed = bare(statement.left) in kernel.symmetric
    symbols = frozenset(node for argument in kernel.of for node in nodes_of(argument))

    def reference(values: Values, digits: int) -> tuple[Matrix, ...]:
        try:
            exact = [evaluate(part, values, rules, digits) for part in parts]
        except (ValueError, Undetermined) as error:  # a function is not real here, or is not known to be
            raise Singular(str(error)) from None
        return tuple([[value[i][j]] for _, i, j in places_of(Packed(parts[0]))] if packed else value for value in exact)

    return Specification(
        name,
        tuple(map(KernelInput, kernel.of)),
        tuple(expected_output(word, part, packed) for word, part in zip(names, parts, strict=True)),
        reference,
        (*problem.hypotheses, *(symmetric(of.matrix) for of in kernel.of if isinstance(of, Packed))),
        rules,
        frozenset(angle for part in parts for angle in _angles(part, symbols, rules)),
        roundings,
    )


def kernel_asked_by(sentence: Statement | Inverse, name: str) -> Kernel:
    """The kernel of that name that the sentence asks for. Raises TypeError if it asks for none."""
    if sentence.kernel is None:
        raise TypeError(f"({sentence.number}) asks for no kernel: give it one, or leave it out")
    return variants(sentence.kernel, name)[0]


def _parts(statement: Statement, kernel: Kernel, right: Node) -> tuple[Node, ...]:
    """The expressions of the results: the right side, or its blocks."""
    if len(kernel.results) <= 1:
        return (right,)
    blocks = tuple(row[0] for row in right.rows if len(row) == 1) if isinstance(right, Block) else ()
    if len(blocks) != len(kernel.results):
        raise TypeError(
            f"({statement.number}) has the results {', '.join(kernel.results)}: its right side must be a column of "
            f"{len(kernel.results)} blocks, and it is {right}"
        )
    return blocks


def expected_output(name: str, node: Node, packed: bool = False) -> ExpectedOutput:
    """The result that the expression is; entries of one dimension are alike, and so are zeros by construction."""
    alike: dict[object, list[int]] = {}
    holds = Packed(node) if packed else node
    grid = measured(node).grid
    for place, (_, row, column) in enumerate(places_of(holds)):
        alike.setdefault(grid[row][column], []).append(place)
    return ExpectedOutput(name, core_shape(holds), tuple(map(tuple, alike.values())))


def _angles(node: Node, inputs: frozenset[Node], rules: Mapping[Node, Node], inside: bool = False) -> Iterator[Node]:
    """The inputs that occur in the argument of a sine or cosine, rules applied and abbreviations opened."""
    if node in inputs:
        if inside:
            yield node
    elif node in rules:
        yield from _angles(rules[node], inputs, rules, inside)
    elif isinstance(node, Symbol) and node.stands_for is not None:
        yield from _angles(node.stands_for, inputs, rules, inside)
    else:
        for part in children(node):
            yield from _angles(part, inputs, rules, inside or isinstance(node, Call))
