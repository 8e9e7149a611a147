"""Functions of scalars beside sine and cosine, and what is defined by cases.

They have no polynomial form: a statement with one of them is decided as a question of scalars, and stands where each of
them is real.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar

from chasles.vocabulary.arguments import Declared, declaring
from chasles.vocabulary.dimension import NO_DIMENSION
from chasles.vocabulary.fitting import SCALAR, measured, word
from chasles.vocabulary.layout import Call, Rate
from chasles.vocabulary.measure import Measure, Misfit, added, uniform
from chasles.vocabulary.nodes import Node, Sum, lifted
from chasles.vocabulary.pieces import Piece, Precedence, Style
from chasles.vocabulary.shorthand import Shorthand

_Scalar = Node | int | Fraction
PRINTED = {
    "sqrt": r"\sqrt{#}",
    "abs": "|#|",
    **{name: rf"\{name}" for name in ("exp", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "max", "min")},
    "log": r"\ln",
    **{name: rf"\operatorname{{{name}}}" for name in ("arcsinh", "arccosh", "arctanh", "atan2", "sign")},
}
"""In LaTeX: a form with a place for the argument, or a name that stands before it."""
OF_ANY, RESULT_LIKE = ("sign", "atan2"), ("abs", "max", "min")


@word
class FunctionOf(Node):
    """A function of scalars, called by its `function`: "sqrt", "atan2", "max"."""

    function: str
    arguments: tuple[Node, ...]
    has_no_polynomial_form: ClassVar[bool] = True

    def _measured(self) -> Measure:
        if not self.arguments:
            raise Misfit(f"{self.function} takes one scalar or more")
        first = measured(self.arguments[0])
        for argument in self.arguments:
            if not argument.is_scalar:
                raise Misfit(f"{self.function} takes scalars, and {argument} is none")
            first = added(first, measured(argument), (self.arguments[0], argument), f"take {self.function} of")
        dimension = first.grid[0][0]
        if self.function in RESULT_LIKE:
            return uniform(SCALAR, dimension)
        if self.function == "sqrt":
            return uniform(SCALAR, dimension and dimension ** Fraction(1, 2))
        if dimension not in (None, NO_DIMENSION) and self.function not in OF_ANY:
            raise Misfit(f"{self.function} takes a number without dimension, and {self.arguments[0]} is in {dimension}")
        return uniform(SCALAR)

    def rate_by_parts(self) -> Node | None:
        if self.function not in DERIVATIVES:
            return None
        slopes = DERIVATIVES[self.function](*self.arguments)
        return Sum(tuple(slope * Rate(argument) for slope, argument in zip(slopes, self.arguments, strict=True)))

    def spelled(self, style: Style, spell: Callable[[Node], Piece]) -> Piece:
        inner = [spell(argument) for argument in self.arguments]
        text, depth = ", ".join(piece.text for piece in inner), max(piece.depth for piece in inner)
        form = style.called(self.function, PRINTED[self.function])
        if "#" in form:
            return Piece(form.replace("#", text), Precedence.ATOM, depth)
        if len(inner) == 1 and (bare := style.function(form, inner[0])).level is Precedence.PRODUCT:
            return bare
        return Piece(f"{form}{style.brackets(text, depth)}", Precedence.POWER, depth + 1)


@dataclass(frozen=True, slots=True)
class Relation(Declared):
    """A relation between scalars: `x < 1`, as it is written; it is a condition of a case, or is assumed."""

    left: Node
    sign: str
    right: Node

    def __bool__(self) -> bool:
        raise TypeError("a comparison has no truth value: it is the condition of a case, or is assumed")

    def __str__(self) -> str:
        return f"{self.left} {self.sign} {self.right}"


@word
class Cases(Node):
    """The first of the `values` whose condition holds: a comparison of `left` and `right`; the last has none."""

    values: tuple[Node, ...]
    left: tuple[Node, ...]
    right: tuple[Node, ...]
    signs: tuple[str, ...]
    has_no_polynomial_form: ClassVar[bool] = True

    def _measured(self) -> Measure:
        total = measured(self.values[0])
        for value in self.values[1:]:
            total = added(total, measured(value), (self.values[0], value), "take by cases")
        for left, right in zip(self.left, self.right, strict=True):
            if not (left.is_scalar and right.is_scalar):
                raise Misfit(f"only scalars are compared: {left} and {right}")
            added(measured(left), measured(right), (left, right), "compare")
        return total

    def spelled(self, style: Style, spell: Callable[[Node], Piece]) -> Piece:
        shown = zip(self.left, self.signs, self.right, strict=True)
        where = [f"{spell(left).text} {style.compared(sign)} {spell(right).text}" for left, sign, right in shown]
        return Piece(style.cases([spell(value).text for value in self.values], where), Precedence.ATOM, 2)


@word
class HalfPower(Shorthand):
    """A scalar to half of an odd number: its root to that number."""

    of: Node
    exponent: Fraction
    function: ClassVar[str] = "power"
    has_no_polynomial_form: ClassVar[bool] = True

    @property
    def definition(self) -> Node:
        power = FunctionOf("sqrt", (self.of,)) ** abs(self.exponent.numerator)
        return power if self.exponent > 0 else 1 / power

    def spelled(self, style: Style, spell: Callable[[Node], Piece]) -> Piece:
        base, exponent = spell(self.of).at_least(Precedence.ATOM, style), str(self.exponent)
        return Piece(style.power(base.text, style.called(f"({exponent})", exponent)), Precedence.POWER, base.depth)


def _function(name: str, *arguments: _Scalar) -> FunctionOf:
    return FunctionOf(name, tuple(map(lifted, arguments)))


def _of_one(name: str, meaning: str) -> Callable[[_Scalar], FunctionOf]:
    def function(of: _Scalar) -> FunctionOf:
        return _function(name, of)

    function.__name__, function.__doc__ = name, meaning
    return declaring(function)


sqrt = _of_one("sqrt", "The nonnegative square root.")
exp = _of_one("exp", "The exponential function.")
log = _of_one("log", "The natural logarithm.")
arcsin = _of_one("arcsin", "The angle between -pi/2 and pi/2 that has this sine.")
arccos = _of_one("arccos", "The angle between 0 and pi that has this cosine.")
arctan = _of_one("arctan", "The angle between -pi/2 and pi/2 that has this tangent.")


@declaring
def atan2(sine: _Scalar, cosine: _Scalar) -> FunctionOf:
    """The angle above -pi and at most pi whose sine and cosine have the ratio of the two, and their signs."""
    return _function("atan2", sine, cosine)


sinh = _of_one("sinh", "The hyperbolic sine.")
cosh = _of_one("cosh", "The hyperbolic cosine.")
tanh = _of_one("tanh", "The hyperbolic tangent.")
arcsinh = _of_one("arcsinh", "The number that has this hyperbolic sine.")
arccosh = _of_one("arccosh", "The number, not negative, that has this hyperbolic cosine.")
arctanh = _of_one("arctanh", "The number that has this hyperbolic tangent.")
sign = _of_one("sign", "1, 0 or -1, as the scalar is positive, zero or negative.")


@declaring
def maximum(*of: _Scalar) -> FunctionOf:
    """The largest of several scalars."""
    return _function("max", *of)


@declaring
def minimum(*of: _Scalar) -> FunctionOf:
    """The smallest of several scalars."""
    return _function("min", *of)


DERIVATIVES: dict[str, Callable[..., tuple[Node, ...]]] = {
    "sin": lambda x: (Call("cos", x),),
    "cos": lambda x: (-Call("sin", x),),
    "sqrt": lambda x: (1 / (2 * sqrt(x)),),
    "abs": lambda x: (sign(x),),
    "exp": lambda x: (exp(x),),
    "log": lambda x: (1 / x,),
    "arcsin": lambda x: (1 / sqrt(1 - x**2),),
    "arccos": lambda x: (-(1 / sqrt(1 - x**2)),),
    "arctan": lambda x: (1 / (1 + x**2),),
    "atan2": lambda y, x: (x / (x**2 + y**2), -(y / (x**2 + y**2))),
    "sinh": lambda x: (cosh(x),),
    "cosh": lambda x: (sinh(x),),
    "tanh": lambda x: (1 / cosh(x) ** 2,),
    "arcsinh": lambda x: (1 / sqrt(x**2 + 1),),
    "arccosh": lambda x: (1 / sqrt(x**2 - 1),),
    "arctanh": lambda x: (1 / (1 - x**2),),
}
"""The partial derivatives of each function."""


@declaring
def cases(*rows: tuple[_Scalar, Relation], otherwise: _Scalar) -> Cases:
    """The value of the first row whose comparison holds, else that `otherwise`."""
    values = (*(lifted(value) for value, _ in rows), lifted(otherwise))
    left, right, signs = zip(*((c.left, c.right, c.sign) for _, c in rows), strict=True)
    return Cases(values, left, right, signs)
