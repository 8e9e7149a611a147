"""The expression nodes: frozen, in the author's order, measured when they are made.

`-a * b` is read as the author writes it, -(a b); write `paren(-a) * b` for a factor with a sign of its own.
Equality is equality of spelling. A node has no truth value: whether an equation holds is decided, not computed here.
"""

from __future__ import annotations

from collections.abc import Callable
from contextvars import ContextVar
from dataclasses import dataclass, field, fields
from fractions import Fraction
from functools import reduce
from itertools import pairwise, permutations
from typing import Any, TypeVar, dataclass_transform

from chasles.vocabulary.dimension import NO_DIMENSION, Dimension
from chasles.vocabulary.measure import (
    Measure,
    Misfit,
    added,
    completed,
    contracted,
    entrywise,
    scaled,
    stacked,
    uniform,
)

__all__ = [
    "At",
    "Block",
    "Call",
    "Cofactor",
    "Contract",
    "Cross",
    "Determinant",
    "Dot",
    "Group",
    "Identity",
    "Inverse",
    "Negative",
    "Node",
    "Norm",
    "Number",
    "Power",
    "Quotient",
    "Rate",
    "Scale",
    "Skew",
    "Sum",
    "Symbol",
    "Trace",
    "Transpose",
    "Vect",
    "Zero",
    "lifted",
    "printed",
]

SCALAR = (1, 1)
_tolerant: ContextVar[bool] = ContextVar("tolerant", default=False)
_N = TypeVar("_N", bound="Node")


class Node:
    """A word of the vocabulary.

    `measure` has the shape and the dimension of each entry; it is None, and `fault` says why, for an expression that
    does not fit and was made under `printed`.
    """

    __slots__ = ("_hash", "fault", "measure")
    measure: Measure | None
    fault: str | None
    _hash: int

    def __post_init__(self) -> None:
        fault = next((part.fault for part in self._parts() if part.fault), None)
        measure = None
        if fault is None:
            try:
                measure = self._measured()
            except Misfit as misfit:
                if not _tolerant.get():
                    raise
                fault = str(misfit)
        object.__setattr__(self, "measure", measure)
        object.__setattr__(self, "fault", fault)

    def _measured(self) -> Measure:
        raise NotImplementedError(type(self).__name__)

    def _parts(self) -> tuple[Node, ...]:
        return ()

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns; a scalar is 1 x 1. Raises `Misfit` for an expression that does not fit."""
        return measured(self).shape

    @property
    def is_scalar(self) -> bool:
        return self.measure is not None and self.measure.shape == SCALAR

    @property
    def T(self) -> Transpose:
        return Transpose(self)

    def __add__(self, other: Node | int | Fraction) -> Sum:
        return Sum((*_terms(self), lifted(other)))

    def __radd__(self, other: int | Fraction) -> Sum:
        return Sum((lifted(other), self))

    def __sub__(self, other: Node | int | Fraction) -> Sum:
        return Sum((*_terms(self), Negative(lifted(other))))

    def __rsub__(self, other: int | Fraction) -> Sum:
        return Sum((lifted(other), Negative(self)))

    def __neg__(self) -> Negative:
        return Negative(self)

    def __mul__(self, other: Node | int | Fraction) -> Node:
        other = lifted(other)
        if isinstance(self, Negative):
            return Negative(self.term * other)
        return Scale(other, self, trailing=True) if not self.is_scalar and other.is_scalar else Scale(self, other)

    def __rmul__(self, other: int | Fraction) -> Scale:
        return Scale(lifted(other), self)

    def __truediv__(self, other: Node | int | Fraction) -> Node:
        if isinstance(self, Negative):
            return Negative(self.term / other)
        return Quotient(self, lifted(other))

    def __rtruediv__(self, other: int | Fraction) -> Quotient:
        return Quotient(lifted(other), self)

    def __matmul__(self, other: Node) -> Node:
        if isinstance(self, Negative):
            return Negative(self.term @ other)
        return Contract((*(self.factors if isinstance(self, Contract) else (self,)), lifted(other)))

    def __pow__(self, exponent: int) -> Power:
        if not isinstance(exponent, int) or isinstance(exponent, bool):
            raise TypeError(f"the exponent of {self} is {exponent!r}; it must be a whole number")
        return Power(self, exponent)

    def __bool__(self) -> bool:
        raise TypeError("an expression has no truth value; `==` compares spelling, `chasles.prove` decides equality")

    def __reduce__(self) -> tuple[Callable[..., Node], tuple[Any, ...]]:
        return _copied, (type(self), *(getattr(self, field.name) for field in fields(self)))  # type: ignore[arg-type]

    def __str__(self) -> str:
        from chasles.vocabulary.plain import plain

        return plain(self)


def lifted(value: Node | int | Fraction) -> Node:
    """The value as a node; raises TypeError for anything that is not exact."""
    if isinstance(value, Node):
        return value
    if isinstance(value, int | Fraction) and not isinstance(value, bool):
        return Number(Fraction(value))
    raise TypeError(f"expected an expression, an integer or a Fraction, got {value!r}")


def measured(node: Node) -> Measure:
    """The node's measure; raises `Misfit` with the reason if it has none."""
    if node.measure is None:
        raise Misfit(node.fault or "this expression does not fit")
    return node.measure


def printed(write: Callable[[], _N]) -> _N:
    """The expression as `write` spells it, even if its parts do not fit together; then its `fault` says why."""
    token = _tolerant.set(True)
    try:
        return write()
    finally:
        _tolerant.reset(token)


def _copied(cls: type[_N], *values: Any) -> _N:
    """A node with the given fields, as copies and pickles make it; one that does not fit stays so."""
    return printed(lambda: cls(*values))


def _terms(node: Node) -> tuple[Node, ...]:
    return node.terms if isinstance(node, Sum) else (node,)


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def _word(cls: type[_N]) -> type[_N]:
    """A frozen node whose hash is computed once: proofs look the same nodes up again and again."""
    made = dataclass(frozen=True, slots=True)(cls)
    by_fields: Any = made.__hash__

    def hash_once(self: _N) -> int:
        try:
            return self._hash
        except AttributeError:
            object.__setattr__(self, "_hash", by_fields(self))
            return self._hash

    made.__hash__ = hash_once  # type: ignore[assignment]
    return made


def _square(of: Node, rule: str) -> Measure:
    """The measure of a square matrix; `rule` names what asks for one."""
    measure = measured(of)
    if measure.shape[0] != measure.shape[1]:
        raise Misfit(f"{rule} takes a square matrix, and {of} is {measure.shape[0]} x {measure.shape[1]}")
    return measure


def _vector(of: Node, rule: str) -> Dimension | None:
    if measured(of).shape != (3, 1):
        rows, columns = of.shape
        raise Misfit(f"{rule} takes a vector (3 x 1), and {of} is {rows} x {columns}")
    return measured(of).the_dimension(of)


def _times(one: Dimension | None, other: Dimension | None) -> Dimension | None:
    return None if one is None or other is None else one * other


@_word
class Symbol(Node):
    """A named quantity. `stands_for` makes it an abbreviation, as E is for the cross-product matrix of e.

    `constant` says that it does not change with time. Two symbols of different `name` are different even where the
    book prints the same letter.
    """

    name: str
    letter: str
    size: Measure
    meaning: str = ""
    constant: bool = False
    stands_for: Node | None = None

    def _measured(self) -> Measure:
        return self.size


@_word
class Number(Node):
    """An exact rational number."""

    value: Fraction

    def _measured(self) -> Measure:
        return uniform(SCALAR, None if self.value == 0 else NO_DIMENSION)


@_word
class Identity(Node):
    """The identity matrix of the given size."""

    size: int
    letter: str = r"\mathbf{1}"

    def _measured(self) -> Measure:
        one_on_the_diagonal = tuple(
            tuple(NO_DIMENSION if i == j else None for j in range(self.size)) for i in range(self.size)
        )
        return Measure(one_on_the_diagonal)


@_word
class Zero(Node):
    """A zero matrix; it fits every dimension."""

    rows: int
    columns: int
    letter: str = r"\mathbf{O}"

    def _measured(self) -> Measure:
        return uniform((self.rows, self.columns), None)


@_word
class Sum(Node):
    """Terms added in the author's order; a subtracted term is a `Negative`."""

    terms: tuple[Node, ...]

    def _parts(self) -> tuple[Node, ...]:
        return self.terms

    def _measured(self) -> Measure:
        total = measured(self.terms[0])
        for index, term in enumerate(self.terms[1:]):
            names = (" + ".join(map(str, self.terms[: index + 1])), str(term)) if _differ(total, term) else ("", "")
            total = added(total, measured(term), names)
        return total


def _differ(total: Measure, term: Node) -> bool:
    return total.grid != measured(term).grid


@_word
class Negative(Node):
    """The term with the opposite sign."""

    term: Node

    def _parts(self) -> tuple[Node, ...]:
        return (self.term,)

    def _measured(self) -> Measure:
        return measured(self.term)


@_word
class Scale(Node):
    """A scalar times a term; `trailing` where the author writes the scalar behind."""

    factor: Node
    term: Node
    trailing: bool = False

    def _parts(self) -> tuple[Node, ...]:
        return (self.factor, self.term)

    def _measured(self) -> Measure:
        if not self.factor.is_scalar:
            raise Misfit(f"{self.factor} is not a scalar: write A @ B to multiply matrices")
        return scaled(measured(self.term), measured(self.factor).grid[0][0])


@_word
class Quotient(Node):
    """A term divided by a scalar; `slash` where the author writes it on one line."""

    numerator: Node
    denominator: Node
    slash: bool = False

    def _parts(self) -> tuple[Node, ...]:
        return (self.numerator, self.denominator)

    def _measured(self) -> Measure:
        if not self.denominator.is_scalar:
            raise Misfit(f"cannot divide {self.numerator} by {self.denominator}, which is not a scalar")
        divisor = measured(self.denominator).grid[0][0]
        if divisor is None:
            raise Misfit(f"cannot divide {self.numerator} by zero")
        return scaled(measured(self.numerator), NO_DIMENSION / divisor)


@_word
class Contract(Node):
    """Matrices multiplied in the author's order."""

    factors: tuple[Node, ...]

    def _parts(self) -> tuple[Node, ...]:
        return self.factors

    def _measured(self) -> Measure:
        total = measured(self.factors[0])
        for before, factor in pairwise(self.factors):
            if total.shape[1] != factor.shape[0]:
                contracted(measured(before), measured(factor), (before, factor))
            total = contracted(total, measured(factor), (before, factor))
        return total


@_word
class Power(Node):
    """A scalar or a square matrix raised to a positive integer."""

    base: Node
    exponent: int

    def _parts(self) -> tuple[Node, ...]:
        return (self.base,)

    def _measured(self) -> Measure:
        if self.exponent < 1:
            raise Misfit(f"the exponent of {self.base} is {self.exponent}; write a quotient or `inverse` instead")
        total = measure = _square(self.base, "a power")
        for _ in range(self.exponent - 1):
            total = contracted(total, measure, (self.base, self.base))
        return total


@_word
class Transpose(Node):
    """The transpose."""

    of: Node

    def _parts(self) -> tuple[Node, ...]:
        return (self.of,)

    def _measured(self) -> Measure:
        return measured(self.of).transposed


@_word
class Inverse(Node):
    """The inverse of a square matrix; a claim about it says that the product with the other side is the identity."""

    of: Node

    def _parts(self) -> tuple[Node, ...]:
        return (self.of,)

    def _measured(self) -> Measure:
        of = completed(_square(self.of, "an inverse"), self.of)
        return entrywise(lambda d: NO_DIMENSION / d, of.transposed)


@_word
class Cofactor(Node):
    """The cofactor matrix of a 3 x 3 matrix; a rotation equals its own."""

    of: Node

    def _parts(self) -> tuple[Node, ...]:
        return (self.of,)

    def _measured(self) -> Measure:
        if _square(self.of, "a cofactor matrix").shape != (3, 3):
            raise Misfit(f"the cofactor matrix is that of a 3 x 3 matrix, and {self.of} is not")
        dimension = measured(self.of).the_dimension(self.of)
        return uniform((3, 3), _times(dimension, dimension))


@_word
class Skew(Node):
    """The cross-product matrix of a vector: CPM(a) b = a x b. Source: (2.38)."""

    of: Node

    def _parts(self) -> tuple[Node, ...]:
        return (self.of,)

    def _measured(self) -> Measure:
        dimension = _vector(self.of, "a cross-product matrix")
        return Measure(tuple(tuple(None if i == j else dimension for j in range(3)) for i in range(3)))


@_word
class Vect(Node):
    """The axial vector of a 3 x 3 matrix: that of its skew-symmetric part."""

    of: Node

    def _parts(self) -> tuple[Node, ...]:
        return (self.of,)

    def _measured(self) -> Measure:
        if _square(self.of, "an axial vector").shape != (3, 3):
            raise Misfit(f"the axial vector is that of a 3 x 3 matrix, and {self.of} is not")
        return uniform((3, 1), measured(self.of).the_dimension(self.of))


@_word
class Trace(Node):
    """The sum of the diagonal entries of a square matrix."""

    of: Node

    def _parts(self) -> tuple[Node, ...]:
        return (self.of,)

    def _measured(self) -> Measure:
        grid = _square(self.of, "a trace").grid
        diagonal = Measure((tuple(grid[i][i] for i in range(len(grid))),))
        return uniform(SCALAR, diagonal.the_dimension(f"the diagonal of {self.of}"))


@_word
class Determinant(Node):
    """The determinant of a square matrix."""

    of: Node

    def _parts(self) -> tuple[Node, ...]:
        return (self.of,)

    def _measured(self) -> Measure:
        grid = completed(_square(self.of, "a determinant"), self.of).grid
        terms = ([row[j] for row, j in zip(grid, order, strict=True)] for order in permutations(range(len(grid))))
        term = next((term for term in terms if None not in term), [None])
        return uniform(SCALAR, reduce(_times, term))


@_word
class Norm(Node):
    """The Euclidean norm of a column or a scalar."""

    of: Node

    def _parts(self) -> tuple[Node, ...]:
        return (self.of,)

    def _measured(self) -> Measure:
        if measured(self.of).shape[1] != 1:
            raise Misfit(f"the norm is that of a column, and {self.of} is {self.of.shape[0]} x {self.of.shape[1]}")
        return uniform(SCALAR, measured(self.of).the_dimension(self.of))


@_word
class Dot(Node):
    """The scalar product of two columns, written with a dot."""

    left: Node
    right: Node

    def _parts(self) -> tuple[Node, ...]:
        return (self.left, self.right)

    def _measured(self) -> Measure:
        left, right = measured(self.left), measured(self.right)
        if left.shape[1] != 1 or left.shape != right.shape:
            sizes = [f"{side} is {side.shape[0]} x {side.shape[1]}" for side in (self.left, self.right)]
            raise Misfit(f"the scalar product is that of two columns of one height: {sizes[0]}, and {sizes[1]}")
        return contracted(left.transposed, right, (self.left, self.right))


@_word
class Cross(Node):
    """The vector product of two vectors."""

    left: Node
    right: Node

    def _parts(self) -> tuple[Node, ...]:
        return (self.left, self.right)

    def _measured(self) -> Measure:
        left = _vector(self.left, "a vector product")
        return uniform((3, 1), _times(left, _vector(self.right, "a vector product")))


@_word
class Call(Node):
    """A function of a dimensionless scalar: "sin" or "cos"."""

    function: str
    argument: Node

    def _parts(self) -> tuple[Node, ...]:
        return (self.argument,)

    def _measured(self) -> Measure:
        if not self.argument.is_scalar or measured(self.argument).grid[0][0] not in (None, NO_DIMENSION):
            raise Misfit(f"{self.function} takes an angle in radians, and {self.argument} is not one")
        return uniform(SCALAR)


@_word
class Block(Node):
    """A matrix of blocks, row by row."""

    rows: tuple[tuple[Node, ...], ...]

    def _parts(self) -> tuple[Node, ...]:
        return sum(self.rows, ())

    def _measured(self) -> Measure:
        measures = [[measured(block) for block in row] for row in self.rows]
        return stacked(measures, self.rows)


@_word
class Rate(Node):
    """The time derivative."""

    of: Node

    def _parts(self) -> tuple[Node, ...]:
        return (self.of,)

    def _measured(self) -> Measure:
        return entrywise(lambda d: Dimension(d.length, d.mass, d.time - 1), measured(self.of))


@_word
class At(Node):
    """The quantity, printed with its argument: p(t)."""

    of: Node
    argument: str

    def _parts(self) -> tuple[Node, ...]:
        return (self.of,)

    def _measured(self) -> Measure:
        return measured(self.of)


@_word
class Group(Node):
    """A term that the author puts between brackets which its meaning does not ask for.

    With a `frame`, the brackets say in which coordinate frame the components are given, and bear its letter.
    """

    of: Node
    brackets: str = "()"
    frame: str = ""

    def _parts(self) -> tuple[Node, ...]:
        return (self.of,)

    def _measured(self) -> Measure:
        return measured(self.of)
