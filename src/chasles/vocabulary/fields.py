"""Fields: quantities that depend on others, a temperature on where it is measured, an energy on coordinates.

Nothing is known of how they depend on them, but that the order of derivatives does not matter.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import fields
from dataclasses import replace as with_fields
from functools import lru_cache
from itertools import product
from typing import ClassVar

from chasles.vocabulary.arguments import WrongArgument, declaring
from chasles.vocabulary.fitting import measured, word
from chasles.vocabulary.layout import Block, Rate
from chasles.vocabulary.letters import Symbol, Zero
from chasles.vocabulary.measure import entrywise
from chasles.vocabulary.nodes import Node, Scale, Sum, lifted
from chasles.vocabulary.plain import latex, plain
from chasles.vocabulary.sizes import sizes_of
from chasles.vocabulary.tree import undotted, walk

ONE = lifted(1)
Nodes = tuple[Node, ...]
"""So named, they are no parts of a word: whoever replaces these leaves it as it is."""


@word
class Field(Symbol):
    """The value of a function at its `variables`; `taken` are the entries of them by which `root` is differentiated.

    Where it is to be differentiated, `arguments` say what the variables are.
    """

    variables: Nodes = ()
    taken: Nodes = ()
    root: Symbol | None = None
    arguments: Nodes = ()
    is_field: ClassVar[bool] = True

    @lru_cache(maxsize=4096)  # noqa: B019 - words are kept anyway, and equal derivatives are to be one
    def derivative(self, by: Node) -> Field:
        """The field's derivative by a scalar variable, or by an entry of one."""
        taken = tuple(sorted((*self.taken, by), key=plain))
        root = with_fields(self, arguments=()) if self.root is None else self.root
        order = str(len(taken)) if len(taken) > 1 else ""
        shown = (f"d({plain(each)})" if isinstance(each, Rate) else f"d{plain(each)}" for each in taken)
        name = f"d{order}{root.name}/{' '.join(shown)}"
        below = " ".join(rf"\partial {latex(each)}" for each in taken)
        letter = rf"\frac{{\partial{f'^{order}' if order else ''} {root.letter}}}{{{below}}}"
        unit = measured(by).grid[0][0]
        size = entrywise(lambda d: d / unit if unit else d, self.size)
        return with_fields(self, name=name, letter=letter, size=size, taken=taken, root=root, arguments=())

    def varied(self, changes: Sequence[Node]) -> Node:
        """What the field changes by where its variables change so."""
        terms: list[Node] = []
        for variable, change in zip(self.variables, changes, strict=True):
            for i, j in product(*map(range, variable.shape)):
                by, factor = _entry(variable, i, j), _entry(change, i, j)
                if not isinstance(factor, Zero):
                    terms.append(self.derivative(by) if factor == ONE else Scale(factor, self.derivative(by)))
        return terms[0] if len(terms) == 1 else Sum(tuple(terms)) if terms else Zero(*self.shape)


def _entry(node: Node, i: int, j: int) -> Node:
    """An entry, counted from 0, of a matrix; of a matrix of entries, what stands there."""
    if node.is_scalar or isinstance(node, Zero):
        return node if node.is_scalar else Zero(1, 1)
    if isinstance(node, Block) and all(part.is_scalar for part in node.below):
        return node.rows[i][j]
    return node[i + 1] if node.shape[1] == 1 else node[i + 1, j + 1]


def fields_of(nodes: Iterable[Node]) -> tuple[Field, ...]:
    """The fields that occur, abbreviations opened."""
    found: dict[Field, None] = {}
    for node in nodes:
        for part in walk(node):
            inner = (part.stands_for,) if isinstance(part, Symbol) and part.stands_for is not None else ()
            found |= dict.fromkeys((part,) if isinstance(part, Field) else fields_of(inner))
    return tuple(found)


def rates_of_fields(fields: Iterable[Field], depth: int) -> dict[Node, Node]:
    """By the chain rule, the rates of fields and of so many derivatives of them; time itself, t, has the rate 1."""
    rates: dict[Node, Node] = {}
    waiting = [*fields]
    for _ in range(depth):
        for each in waiting:
            changes = [ONE if getattr(by, "letter", "") == "t" else Rate(by) for by in each.variables]
            rates[Rate(each)] = each.varied(changes)
        waiting = [*fields_of(rates.values())]
    return rates


@declaring
def field(symbol: Symbol, *variables: Node) -> Field:
    """A symbol whose value depends on others: a position, a time, coordinates, their rates."""
    for by in variables:
        if not isinstance(undotted(by)[0], Symbol) or sizes_of([by]):
            raise WrongArgument(f"a field depends on symbols of known size, or rates of symbols, and {by} is none")
    if not variables or symbol.stands_for is not None:
        raise WrongArgument("field(symbol, *variables) takes a symbol and what it depends on: field(v, x, t)")
    return Field(**{each.name: getattr(symbol, each.name) for each in fields(symbol)}, variables=variables)
