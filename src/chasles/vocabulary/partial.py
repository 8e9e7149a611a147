"""Partial derivatives: of an expression by a scalar, Jacobians of a column by a column, gradients."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace as with_fields
from functools import lru_cache
from itertools import groupby
from typing import ClassVar

from chasles.vocabulary.arguments import declaring, making
from chasles.vocabulary.differentiation import rate_of
from chasles.vocabulary.fields import Field, fields_of
from chasles.vocabulary.fitting import measured, word
from chasles.vocabulary.layout import At, Block, Group, Rate
from chasles.vocabulary.letters import Symbol, Zero
from chasles.vocabulary.matrix_derivatives import ONE, derivative_by_whole
from chasles.vocabulary.measure import Measure, Misfit, entrywise
from chasles.vocabulary.nodes import Contract, Negative, Node, Scale, Sum, Transpose
from chasles.vocabulary.parts import Submatrix
from chasles.vocabulary.pieces import Piece, Precedence, Style
from chasles.vocabulary.shorthand import Shorthand, opened
from chasles.vocabulary.sizes import extents_of, partition_of, sizes_of
from chasles.vocabulary.spatial import Cofactor, Cross, Determinant, Dot, Inverse, Skew, Trace, Vect
from chasles.vocabulary.tree import children, rebuilt, replace, undotted, walk, with_inner, with_parts

PRODUCTS = Scale, Contract, Dot, Cross
LINEAR = Sum, Negative, Transpose, Block, Group, At, Skew, Trace, Vect


class CarriedOut(Node):
    """What is said in simpler words once it is known what symbols stand for."""

    has_no_polynomial_form: ClassVar[bool] = True

    def carried_out(self, rules: Mapping[Node, Node]) -> Node:
        """The same in simpler words; `rules` say what symbols stand for."""
        raise NotImplementedError(type(self).__name__)


@word
class PartialDerivative(CarriedOut):
    """The derivative by a scalar, entry by entry, of a scalar by a matrix, or the Jacobian of a column by a column.

    What it is taken `by` is a symbol, an entry of one, the rate of one, which is independent of the symbol, or a column
    of such. By a matrix it has the shape of the matrix.
    """

    of: Node
    by: Node

    def _measured(self) -> Measure:
        for part in _parts_of(self.by):
            _place_of(part)
        of, by = measured(self.of), measured(self.by)
        if by.shape == (1, 1):
            below = by.grid[0][0]
            return entrywise(lambda d: below and d / below, of)
        if of.shape == (1, 1) and by.shape[1] != 1:
            above = of.grid[0][0]
            return entrywise(lambda e: above and above / e, by)
        if by.shape[1] != 1 or of.shape[1] != 1:
            raise Misfit(
                f"a derivative is by a scalar, of a scalar, or of a column by a column: "
                f"{self.of} by {self.by} is none of these"
            )
        partition = partition_of(extents_of(of)[0], extents_of(by)[0])
        return Measure(tuple(tuple(d and e and d / e for (e,) in by.grid) for (d,) in of.grid), partition)

    def carried_out(self, rules: Mapping[Node, Node]) -> Node:
        """The derivative by each part of a block, by what something stands for, or by a whole symbol or its rate."""
        if isinstance(self.by, Block):
            return Block(
                (tuple(with_derivatives(PartialDerivative(self.of, part), rules) for part in _parts_of(self.by)),)
            )
        whole, entry = _place_of(self.by)
        base, dots = undotted(whole)
        if (coordinates := _coordinates(base, dots, rules)) is not None:
            by = coordinates.rows[self.by.rows[0] - 1][0] if isinstance(self.by, Submatrix) else coordinates
            return with_derivatives(PartialDerivative(self.of, by), rules)
        of = opened(self.of)
        values = {key: _of_rule(key, rules) for key in rules if key not in (whole, base)}
        while (told := opened(replace(of, values | meanings(of)))) != of:
            of = told
        said = {part for key in (whole, base) if key in rules for part in walk(opened(rules[key]))}
        if whole not in (seen := {*walk(of)}) and any(isinstance(part, Symbol) for part in said & seen):
            raise TypeError(f"a derivative by {whole} is taken, and {self.of} does not depend on it but on what it is")
        rates: dict[Node, Node] = {}
        fields = fields_of((of,))
        of, moved = _at_rest(of, rates), _at_rest(whole, rates)
        placed: dict[Node, Node] = {each: _placed(each, values, rates) for each in fields}
        of = replace(of, placed) if placed else of
        back = {quantity: rate for rate, quantity in (*rates.items(), *placed.items())}
        if whole.is_scalar:
            return replace(_along(of, moved, ONE), back)
        if isinstance(entry, Submatrix):
            return replace(_along(of, moved, _unit(whole.shape, entry.rows[0] - 1, entry.columns[0] - 1)), back)
        if (whole.shape[1] != 1 and not fields) or sizes_of((of, whole)):
            return replace(derivative_by_whole(of, moved), back)
        slopes = [
            [_along(of, moved, _unit(whole.shape, i, j)) for j in range(whole.shape[1])] for i in range(whole.shape[0])
        ]
        grid = tuple(zip(*slopes, strict=True)) if whole.shape[1] == 1 else tuple(map(tuple, slopes))
        return replace(Block(grid), back)

    def spelled(self, style: Style, spell: Callable[[Node], Piece]) -> Piece:
        of: Node = self
        taken: list[Node] = []
        while isinstance(of, PartialDerivative) and (of.by.is_scalar or not taken):
            taken, of = [*taken, of.by], of.of
        sign = style.called("d", r"\partial ")
        above, below = spell(of).at_least(Precedence.POWER, style), list[str]()
        for by, repeated in groupby(taken):
            order = len([*repeated])
            letter = spell(by).at_least(Precedence.ATOM, style).text if order > 1 else spell(by).text
            below.append(sign + (style.power(letter, str(order)) if order > 1 else letter))
        depth = max(spell(by).depth for by in taken)
        times = style.power(sign.strip(), str(len(taken))) + " " * (sign != "d") if len(taken) > 1 else sign
        return style.fraction(
            Piece(f"{times}{above.text}", Precedence.PRODUCT, above.depth),
            Piece(" ".join(below), Precedence.PRODUCT if len(below) > 1 else Precedence.POWER, depth),
        )


def _parts_of(by: Node) -> tuple[Node, ...]:
    """What stands below each other in a column; else what is given."""
    return sum(by.rows, ()) if isinstance(by, Block) and by.shape[1] == 1 else (by,)


def _place_of(by: Node) -> tuple[Node, Node | None]:
    """What varies, and the entry of it that does; raises `Misfit` for anything but a symbol or the rate of one."""
    whole = by.of if isinstance(by, Submatrix) and by.is_scalar else by
    base, _ = undotted(whole)
    if not isinstance(base, Symbol) or base.stands_for is not None:
        raise Misfit(
            f"a derivative is by a symbol, an entry of one, the rate of one, or a column of such: {by} is none"
        )
    return whole, by if whole is not by else None


def _coordinates(base: Node, dots: int, rules: Mapping[Node, Node]) -> Block | None:
    """The column of different scalars that a rule says the quantity is, or of their rates."""
    parts = _parts_of(opened(rules.get(base, base)))
    if len({*parts}) < 2 or not all(
        isinstance(part, Symbol) and part.is_scalar and part not in rules for part in parts
    ):
        return None
    for _ in range(dots):
        parts = tuple(map(Rate, parts))
    return Block(tuple((part,) for part in parts))


def _of_rule(key: Node, rules: Mapping[Node, Node]) -> Node:
    """What a rule says, with every derivative carried out: it does not lead back to the rule."""
    others = rules.items() if differentiates(rules[key]) else ()
    return with_derivatives(rules[key], {other: rule for other, rule in others if other != key})


def with_derivatives(node: Node, rules: Mapping[Node, Node]) -> Node:
    """The expression with every derivative carried out; `rules` say what symbols stand for.

    Raises TypeError for what has no rule of differentiation, and where it is not said what varies.
    """
    if not differentiates(node):
        return node
    if isinstance(node, Shorthand) and node.has_no_polynomial_form:
        return with_derivatives(node.definition, rules)
    inner = with_inner(node, lambda part: with_derivatives(part, rules))
    return inner.carried_out(rules) if isinstance(inner, CarriedOut) else inner


@lru_cache(maxsize=16384)
def differentiates(node: Node) -> bool:
    """Whether there is a derivative in the expression, or in what an abbreviation stands for."""
    inner = node.stands_for if isinstance(node, Symbol) else None
    own = isinstance(node, CarriedOut) or (isinstance(node, Shorthand) and node.has_no_polynomial_form)
    return own or any(map(differentiates, children(node) if inner is None else (inner,)))


def meanings(node: Node) -> dict[Node, Node]:
    """What the abbreviations in the expression stand for."""
    found = {part: part.stands_for for part in walk(node) if isinstance(part, Symbol)}
    return {part: meaning for part, meaning in found.items() if meaning is not None}


def _placed(field: Field, values: Mapping[Node, Node], rates: dict[Node, Node]) -> Field:
    """The field with what is said of its variables."""
    arguments = tuple(_at_rest(opened(replace(by, values)), rates) for by in field.variables)
    return with_fields(field, arguments=arguments)


def _at_rest(node: Node, rates: dict[Node, Node]) -> Node:
    """The expression with a quantity of its own for each rate of a symbol, which does not depend on the symbol."""
    if isinstance(node, Rate):
        base, _ = undotted(node)
        if not isinstance(base, Symbol):
            return _at_rest(rate_of(node.of), rates)
        if node not in rates:
            measure = measured(node)
            rates[node] = Symbol(f"{node}", f"{node}", measure, constant=True, home=base.home, has_units=base.has_units)
        return rates[node]
    return with_parts(node, lambda part: _at_rest(part, rates))


@lru_cache(maxsize=16384)  # edits of an expression leave most of its parts, and so their derivatives, as they are
def _along(node: Node, by: Node, direction: Node) -> Node:
    """The derivative of an expression where one quantity moves in a direction, and everything else rests."""
    match node:
        case Field(arguments=places) if places:
            return node.varied([_along(place, by, direction) for place in places])
        case Symbol():
            return direction if node == by else Zero(*node.shape)
        case Inverse(of):
            return Negative(Contract((node, _along(of, by, direction), node)))
        case Determinant(of):
            return Trace(Contract((Transpose(Cofactor(of)), _along(of, by, direction))))
        case _:
            return _resolved(rate_of(node), by, direction)


def _resolved(node: Node, by: Node, direction: Node) -> Node:
    """What a rule of differentiation says, with derivatives for rates."""
    if isinstance(node, Rate):
        return _along(node.of, by, direction)
    parts = tuple(_resolved(part, by, direction) for part in children(node))
    zero = [isinstance(part, Zero) for part in parts]
    if (any(zero) and isinstance(node, PRODUCTS)) or (zero and all(zero) and isinstance(node, LINEAR)):
        return Zero(*node.shape)
    if isinstance(node, Sum) and any(zero):
        kept = tuple(part for part in parts if not isinstance(part, Zero))
        return kept[0] if len(kept) == 1 else Sum(kept)
    return rebuilt(node, parts) if parts else node


def _unit(shape: tuple[int, int], row: int, column: int) -> Node:
    """A matrix with one in one place and zero elsewhere."""
    places = [[(i, j) == (row, column) for j in range(shape[1])] for i in range(shape[0])]
    return Block(tuple(tuple(ONE if here else Zero(1, 1) for here in line) for line in places))


partial = making(PartialDerivative, "partial")


@declaring
def gradient(of: Node, by: Node) -> Node:
    """The gradient of a scalar: a column of its derivatives by the entries of a column."""
    return PartialDerivative(of, by).T
