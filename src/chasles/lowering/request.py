"""What is asked for when a kernel is? Its arguments, its results as expressions, and all that these rest on.

A request is closed: every symbol in it is an argument or is defined in it, and every argument is used.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from dataclasses import replace as with_fields
from keyword import iskeyword

from chasles.lowering.cases import Case, Choice
from chasles.lowering.named_functions import NamedFunction, NamedFunctions, is_plain
from chasles.lowering.reach import Reach
from chasles.lowering.refusal import LoweringError
from chasles.lowering.rewriting import Angle, without_angles
from chasles.statements import Hypothesis, Packed, Stack, symmetric
from chasles.statements.arrays import Place, argument_name, core_shape, places_of
from chasles.statements.inverses import Inverses
from chasles.statements.kernel import Argument, nodes_of
from chasles.statements.statement import bare
from chasles.vocabulary import Misfit, Node, Symbol, plain, undotted
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.measure import added
from chasles.vocabulary.partial import with_derivatives


@dataclass(frozen=True, slots=True)
class Output:
    """A result: its name in every language, what it means in plain text, and the expression that it holds.

    A `packed` one is a symmetric 3 x 3 matrix, given as six numbers.
    """

    name: str
    meaning: str
    value: Node
    packed: bool = False

    @property
    def places(self) -> tuple[Place, ...]:
        """The entries of the expression that the result holds, in their order."""
        return places_of(self._layout)

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of the array."""
        return core_shape(self._layout)

    @property
    def _layout(self) -> Argument:
        return Packed(self.value) if self.packed else self.value


@dataclass(frozen=True, slots=True)
class Request:
    """A kernel to be made: `outputs` as functions of arrays that hold symbols and rates of symbols.

    `rules` define other symbols, each before those that use it; `choices` give symbols values case by case, `angles` by
    cosine and sine. The program is right wherever the `hypotheses` hold and nothing that is divided by is zero.
    An offered `form` says the outputs in other words, of which the program is made; what it must equal is the outputs.
    Of `functions` the outputs have the symbols.
    """

    name: str
    arguments: tuple[Argument, ...]
    outputs: tuple[Output, ...]
    rules: tuple[tuple[Node, Node], ...] = ()
    hypotheses: tuple[Hypothesis, ...] = ()
    choices: tuple[Choice, ...] = ()
    angles: tuple[tuple[Symbol, Angle], ...] = ()
    form: tuple[Node, ...] = ()
    functions: tuple[NamedFunction, ...] = ()

    @property
    def spelled(self) -> tuple[Node, ...]:
        """What the program is made of: the offered form, or the outputs as they are stated."""
        return self.form or tuple(output.value for output in self.outputs)

    @property
    def of(self) -> tuple[Node, ...]:
        """The symbols, and rates of symbols, whose values the arguments hold."""
        return tuple(node for argument in self.arguments for node in nodes_of(argument))

    def place(self, argument: int, entry: int) -> Place:
        """What a step reads: the symbol, or its rate, with the row and the column."""
        return places_of(self.arguments[argument])[entry]


def _carried_out(name: str, node: Node, rules: Mapping[Node, Node]) -> Node:
    """The node with its derivatives and integrals taken; raises `LoweringError` for one that follows no rule."""
    try:
        return with_derivatives(node, {left: right for left, right in rules.items() if right != node})
    except TypeError as mistake:
        raise LoweringError(f"{name}: {mistake}") from None


def composed(
    name: str,
    of: Iterable[Argument],
    outputs: Iterable[Output],
    *,
    rules: Mapping[Node, Node] | None = None,
    hypotheses: Iterable[Hypothesis] = (),
    choices: Iterable[Choice] = (),
    angles: Mapping[Symbol, Angle] | None = None,
    form: Iterable[Node] = (),
) -> Request:
    """The request with what it does not need left out; cosines and sines of `angles` are written by what is known.

    Raises `LoweringError` for a symbol that is neither an argument nor defined, a definition in a circle, an argument
    that is not used or is no symbol, a form that does not fit the outputs, and names that no language takes.
    """
    arguments = tuple(argument if isinstance(argument, Stack | Packed) else bare(argument) for argument in of)
    symbols, angles = tuple(node for argument in arguments for node in nodes_of(argument)), dict(angles or {})
    for node in symbols:
        _require_argument(name, node)
    hypotheses = (*hypotheses, *(symmetric(argument.matrix) for argument in arguments if isinstance(argument, Packed)))
    table = {left: right for left, right in (rules or {}).items() if left not in symbols}
    named, inverses = NamedFunctions(table), Inverses(hypotheses, table, any_size=False)

    def opened(node: Node) -> Node:
        return named(without_angles(inverses(_carried_out(name, node, table)), angles, table))

    hypotheses = tuple(h for h in hypotheses if all(map(is_plain, (*h.subjects, *h.nonvanishing, *h.sides))))
    rules = {left: opened(right) for left, right in table.items()}
    choices = [_opened_choice(choice, opened) for choice in choices]
    outputs = tuple(with_fields(output, value=opened(output.value)) for output in outputs)
    hypotheses = tuple(dict.fromkeys(_opened_hypothesis(hypothesis, opened) for hypothesis in hypotheses))
    form = tuple(map(opened, form))
    hypotheses += tuple(inverses.needed)
    _require_fit(name, outputs, form)
    reach = Reach(name, symbols, rules, choices, angles, {known.symbol: known for known in named.known.values()})
    for value in (*(output.value for output in outputs), *form):
        reach.follow(value)
    for argument in arguments:
        if not any(map(reach.is_used, nodes_of(argument))):
            said = argument.name if isinstance(argument, Stack) else plain(nodes_of(argument)[0])
            raise LoweringError(f"{name}: no result depends on the argument {said}: leave it out")
    _require_names(name, [argument_name(argument) for argument in arguments], [output.name for output in outputs])
    reached = reach.rules, hypotheses, reach.choices, reach.angles
    return Request(name, arguments, outputs, *reached, form, reach.functions)


def _opened_choice(choice: Choice, opened: Callable[[Node], Node]) -> Choice:
    cases = []
    for case in choice.cases:
        where = tuple(with_fields(c, left=opened(c.left), right=opened(c.right)) for c in case.where)
        cases.append(Case(where, tuple(map(opened, case.values))))
    return Choice(choice.symbols, tuple(cases))


def _opened_hypothesis(hypothesis: Hypothesis, opened: Callable[[Node], Node]) -> Hypothesis:
    subjects, nonvanishing = tuple(map(opened, hypothesis.subjects)), tuple(map(opened, hypothesis.nonvanishing))
    return with_fields(hypothesis, subjects=subjects, nonvanishing=nonvanishing)


def _require_fit(name: str, outputs: tuple[Output, ...], form: tuple[Node, ...]) -> None:
    if form and len(form) != len(outputs):
        raise LoweringError(f"{name}: its form has {len(form)} blocks, and {len(outputs)} results are asked for")
    for output, value in zip(outputs, form, strict=False):
        try:
            added(measured(output.value), measured(value), (output.value, value), "equate")
        except Misfit as misfit:
            raise LoweringError(f"{name}: the form offered for {output.name} does not fit: {misfit}") from None


def _require_argument(name: str, node: Node) -> None:
    symbol, _ = undotted(node)
    if not isinstance(symbol, Symbol) or symbol.stands_for is not None:
        raise LoweringError(f"{name}: the argument {plain(node)} is an expression; it must be a symbol or its rate")


def _require_names(name: str, arguments: list[str], outputs: list[str]) -> None:
    for word in (name, *arguments, *outputs):
        if not (word.isidentifier() and word.isascii()):
            raise LoweringError(f"{name}: {word!r} cannot be a name in a program: use letters, digits and underscores")
    if iskeyword(name):
        raise LoweringError(f"{name} is a word of Python, and cannot be called: give the kernel another `name`")
    for names in (arguments, outputs):
        twice = next((word for word in names if names.count(word) > 1), None)
        if twice:
            raise LoweringError(f"{name}: two arguments or two results are called {twice}: rename a symbol or a result")
    shared = next((word for word in outputs if word in arguments), None)
    if shared:
        raise LoweringError(f"{name}: {shared} is an argument and a result: give the result another name in `results`")
