"""The expression nodes: frozen, in the author's order, measured when they are made.

`-a * b` is read as the author writes it, -(a b); write `paren(-a) * b` for a factor with a sign of its own.
Equality is equality of spelling. A node has no truth value: whether an equation holds is decided, not computed here.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from fractions import Fraction
from functools import cache
from itertools import pairwise
from typing import TYPE_CHECKING, ClassVar

from chasles.display import Displayed
from chasles.vocabulary.dimension import NO_DIMENSION
from chasles.vocabulary.fitting import SCALAR, Fitted, measured, square_measure, word
from chasles.vocabulary.measure import Extent, Measure, Misfit, added, contracted, scaled, uniform
from chasles.vocabulary.pieces import Piece, Style

if TYPE_CHECKING:
    from chasles.vocabulary.functions import Relation

HOLDING = ("Node", "tuple[Node, ...]")


class Node(Displayed, Fitted):
    """A word with the operators that combine it with others."""

    __slots__ = ()
    has_no_polynomial_form: ClassVar[bool] = False
    expands: ClassVar[bool] = False
    is_field: ClassVar[bool] = False
    __iter__ = None  # places are counted from 1, which Python's own way through them is not
    __array_ufunc__ = None  # an array on the left leaves the operator to this class, which says what it takes

    def _parts(self) -> tuple[Node, ...]:
        held = [getattr(self, name) for name in node_fields(type(self))]  # type: ignore[arg-type]
        return tuple(part for each in held for part in (each if isinstance(each, tuple) else (each,)))

    def spelled(self, style: Style, spell: Callable[[Node], Piece]) -> Piece | None:
        """How it is printed, where the word says so itself."""
        return None

    def rate_by_parts(self) -> Node | None:
        """Its time derivative by the rates of its parts, where the word says so itself."""
        return None

    @property
    def T(self) -> Transpose:
        """The transpose."""
        return Transpose(self)

    def __add__(self, other: Node | int | Fraction) -> Sum:
        return Sum((*_terms(self), lifted(other)))

    def __radd__(self, other: int | Fraction) -> Node:
        return self if isinstance(other, int) and other == 0 else Sum((lifted(other), self))

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

    def __rmul__(self, other: int | Fraction) -> Node:
        factor = lifted(other)
        return Scale(factor, self) if other >= 0 else Negative(Scale(lifted(-other), self))

    def __truediv__(self, other: Node | int | Fraction) -> Node:
        return Negative(self.term / other) if isinstance(self, Negative) else Quotient(self, lifted(other))

    def __rtruediv__(self, other: int | Fraction) -> Quotient:
        return Quotient(lifted(other), self)

    def __abs__(self) -> Node:
        from chasles.vocabulary.functions import FunctionOf

        return FunctionOf("abs", (self,))

    def __lt__(self, other: Node | int | Fraction) -> Relation:
        return self._compared("<", other)

    def __le__(self, other: Node | int | Fraction) -> Relation:
        return self._compared("<=", other)

    def __gt__(self, other: Node | int | Fraction) -> Relation:
        return self._compared(">", other)

    def __ge__(self, other: Node | int | Fraction) -> Relation:
        return self._compared(">=", other)

    def _compared(self, sign: str, other: Node | int | Fraction) -> Relation:
        from chasles.vocabulary.functions import Relation

        return Relation(self, sign, lifted(other))

    def __matmul__(self, other: Node) -> Node:
        if isinstance(self, Negative):
            return Negative(self.term @ other)
        return Contract((*(self.factors if isinstance(self, Contract) else (self,)), lifted(other)))

    def __rmatmul__(self, other: object) -> Node:
        return lifted(other) @ self  # type: ignore[arg-type]

    def __pow__(self, exponent: Extent | Fraction) -> Node:
        from chasles.vocabulary.sizes import Size

        if isinstance(exponent, Fraction) and exponent.denominator == 2:
            from chasles.vocabulary.functions import HalfPower

            return HalfPower(self, exponent)
        if not isinstance(exponent, int | Size) or isinstance(exponent, bool):
            told = "it must be a whole number, or a letter for one: n = Size('n')"
            raise TypeError(f"the exponent of {self} is {exponent}; {told}")
        return Power(self, exponent)

    def __getitem__(self, places: int | slice | tuple[int | slice, int | slice] | str) -> Node:
        """An entry `R[1, 2]`, `v[3]`, or `R["xy"]`, or a block `T[1:3, 4]`: counted from 1, ends included."""
        from chasles.vocabulary.parts import part

        return part(self, places)

    @property
    def x(self) -> Node:
        """The first component of a vector."""
        return self["x"]

    @property
    def y(self) -> Node:
        """The second component of a vector."""
        return self["y"]

    @property
    def z(self) -> Node:
        """The third component of a vector."""
        return self["z"]

    def __float__(self) -> float:
        raise TypeError(f"{self} is no number: functions of it are those of chasles.vocabulary, or of its functions.py")

    def __str__(self) -> str:
        from chasles.vocabulary.plain import plain

        return plain(self)


@cache
def node_fields(kind: type[Node]) -> tuple[str, ...]:
    """The fields of a word that hold expressions, or tuples of them."""
    return tuple(each.name for each in fields(kind) if each.type in (*HOLDING, Node, tuple[Node, ...]))  # type: ignore[arg-type]


@word
class OfOne(Node):
    """A word of one expression."""

    of: Node


def lifted(value: Node | int | Fraction) -> Node:
    """The value as a node; raises TypeError for anything that is not exact."""
    if isinstance(value, Node):
        return value
    if isinstance(value, int | Fraction) and not isinstance(value, bool):
        return Number(Fraction(value))
    shown, instead = repr(value), ""
    if isinstance(value, float):
        instead = f": write {Fraction(value).limit_denominator(1000)!r}"
    elif hasattr(value, "__array__"):
        shown, instead = f"a {type(value).__name__}", ": write `matrix` or `column`, of exact numbers"
    raise TypeError(f"expected an expression, an integer or a Fraction, got {shown}{instead}")


def _terms(node: Node) -> tuple[Node, ...]:
    return node.terms if isinstance(node, Sum) else (node,)


@word
class Number(Node):
    """An exact rational number."""

    value: Fraction

    def _measured(self) -> Measure:
        return uniform(SCALAR, None if self.value == 0 else NO_DIMENSION)


@word
class Sum(Node):
    """Terms added in the author's order; a subtracted term is a `Negative`."""

    terms: tuple[Node, ...]

    def _measured(self) -> Measure:
        total = measured(self.terms[0])
        for index, term in enumerate(self.terms[1:], 1):
            total = added(total, measured(term), (_Spelled(self.terms[:index]), term))
        return total


class _Spelled:
    """Terms that are spelled only when somebody reads them: spelling takes longer than measuring."""

    __slots__ = ("terms",)

    def __init__(self, terms: tuple[Node, ...]) -> None:
        self.terms = terms

    def __str__(self) -> str:
        return " + ".join(map(str, self.terms))


@word
class Negative(Node):
    """The term with the opposite sign."""

    term: Node

    def _measured(self) -> Measure:
        return measured(self.term)


@word
class Scale(Node):
    """A scalar times a term; `trailing` where the author writes the scalar behind."""

    factor: Node
    term: Node
    trailing: bool = False

    def _measured(self) -> Measure:
        if not self.factor.is_scalar:
            raise Misfit(f"{self.factor} is not a scalar: write A @ B to multiply matrices")
        return scaled(measured(self.term), measured(self.factor).grid[0][0])


@word
class Quotient(Node):
    """A term divided by a scalar; `slash` where the author writes it on one line, `called` where by a name of its own.

    A tangent is a sine divided by the cosine of the same, and stands where that is not zero.
    """

    numerator: Node
    denominator: Node
    slash: bool = False
    called: str = ""

    def _measured(self) -> Measure:
        if not self.denominator.is_scalar:
            raise Misfit(f"cannot divide {self.numerator} by {self.denominator}, which is not a scalar")
        divisor = measured(self.denominator).grid[0][0]
        if divisor is None:
            raise Misfit(f"cannot divide {self.numerator} by zero")
        return scaled(measured(self.numerator), NO_DIMENSION / divisor)


@word
class Contract(Node):
    """Matrices multiplied in the author's order."""

    factors: tuple[Node, ...]

    def _measured(self) -> Measure:
        total = measured(self.factors[0])
        for before, factor in pairwise(self.factors):
            if total.shape[1] != factor.shape[0]:
                contracted(measured(before), measured(factor), (before, factor))
            total = contracted(total, measured(factor), (before, factor))
        return total


@word
class Power(Node):
    """A scalar or a square matrix raised to a positive integer, or to a letter for one."""

    base: Node
    exponent: Extent

    def _measured(self) -> Measure:
        if not isinstance(self.exponent, int):
            once = square_measure(self.base, "a power")
            if contracted(once, once, (self.base, self.base)) != once:
                raise Misfit(f"{self.base} has a dimension: of its powers only those of known exponents can have one")
            return once
        if self.exponent < 1:
            raise Misfit(f"the exponent of {self.base} is {self.exponent}; write a quotient or `inverse` instead")
        total = measure = square_measure(self.base, "a power")
        for _ in range(self.exponent - 1):
            before, total = total, contracted(total, measure, (self.base, self.base))
            if total == before:
                break
        return total


@word
class Transpose(OfOne):
    """The transpose."""

    def _measured(self) -> Measure:
        return measured(self.of).transposed
