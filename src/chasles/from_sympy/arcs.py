"""Inverse functions of angles: their cosines and sines, which are algebraic, and the ranges in which they lie.

atan(u) is the angle of the point (1, u), asin(u) that of (sqrt(1 - u^2), u), atan2(y, x) that of (x, y). A sum of
rational multiples of such angles and of pi is zero if its cosine is one and it lies strictly between -2 pi and 2 pi:
there cosine is one at zero only. Where the bounds are wider, the sum is halved first.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import sympy

from chasles.checker.expressions.readings import CIRCULAR
from chasles.from_sympy.opening import FunctionSymbol

LARGEST_MULTIPLE = 16
MOST_HALVINGS = 4
HALF = Fraction(1, 2)
NONNEGATIVE = sympy.Dummy(nonnegative=True)
# Each with what it is in terms of atan, asin and atan2; SymPy's acot(0) is pi/2, which division by zero leaves out.
INVERSE: Mapping[type, Any] = {
    sympy.atan: lambda u: (sympy.S.Zero, 1, sympy.atan, (u,)),
    sympy.asin: lambda u: (sympy.S.Zero, 1, sympy.asin, (u,)),
    sympy.acos: lambda u: (sympy.pi / 2, -1, sympy.asin, (u,)),
    sympy.acot: lambda u: (sympy.S.Zero, 1, sympy.atan, (1 / u,)),
    sympy.asec: lambda u: (sympy.pi / 2, -1, sympy.asin, (1 / u,)),
    sympy.acsc: lambda u: (sympy.S.Zero, 1, sympy.asin, (1 / u,)),
    sympy.atan2: lambda y, x: (sympy.S.Zero, 1, sympy.atan2, (y, x)),
}
RECIPROCAL = (sympy.acot, sympy.asec, sympy.acsc)
"""What is said by one over the argument."""


@dataclass(frozen=True, slots=True)
class Arc:
    """The angle of the point (x, y), whose distance from the origin has the given square, and bounds in units of pi.

    `open` says of the lower and the upper one whether it is not attained.
    """

    x: Any
    y: Any
    square: Any
    low: Fraction
    high: Fraction
    open: tuple[bool, bool]


def arc_of(function: type, arguments: tuple[Any, ...]) -> Arc:
    """The arc of atan, asin or atan2."""
    y, scale = _scaled(arguments[0])
    if function is sympy.atan:
        return Arc(scale, y, _tidy(scale**2 + y**2), *_range(y, scale))
    if function is sympy.asin:
        return Arc(sympy.sqrt(_tidy(scale**2 - y**2)), y, scale**2, *_range(y, NONNEGATIVE))
    y, x = arguments
    return Arc(x, y, _tidy(x**2 + y**2), *_range(y, x))


def _scaled(quotient: Any) -> tuple[Any, Any]:
    """A quotient without its divisor, and the divisor, if that is positive: a root is."""
    above, below = sympy.fraction(quotient)
    return (above, below) if _is_rooted(below) or below.is_positive else (quotient, sympy.S.One)


def _is_rooted(e: Any) -> bool:
    return bool(e.is_Pow and e.exp.is_Rational and not e.exp.is_Integer)


def _of_sign(root: Any) -> Any:
    """A symbol with the sign that a root has where it is real."""
    strict = root.is_positive or root.exp.is_negative
    return sympy.Dummy(positive=True) if strict else sympy.Dummy(nonnegative=True)


def _tidy(square: Any) -> Any:
    """A sum with squares of sums seen in it."""
    above, below = sympy.fraction(sympy.together(square))
    return (sympy.factor(above) if above.has(FunctionSymbol) else sympy.expand(above)) / below


def _range(y: Any, x: Any) -> tuple[Fraction, Fraction, tuple[bool, bool]]:
    """The bounds of the angle of a point: -pi is never attained, pi where y is zero and x is negative."""
    y, x = (
        side.xreplace({root: _of_sign(root) for root in side.atoms(sympy.Pow) if _is_rooted(root)}) for side in (y, x)
    )
    bound = HALF if x.is_nonnegative else Fraction(1)
    low = Fraction(0) if y.is_nonnegative else -bound
    high = Fraction(0) if y.is_negative or (y.is_nonpositive and x.is_nonnegative) else bound
    open_ = {-1: True, -HALF: x.is_positive, 0: y.is_nonzero, HALF: x.is_positive, 1: y.is_positive}
    return low, high, (bool(open_[low]), bool(open_[high]))


def _split(expression: Any, arcs: Mapping[FunctionSymbol, Arc]) -> tuple[dict[FunctionSymbol, Fraction], Any]:
    """The rational multiples of arcs in a sum, and the rest of it."""
    multiples: dict[FunctionSymbol, Fraction] = {}
    rest = sympy.S.Zero
    for term in sympy.Add.make_args(sympy.expand(expression)):
        multiple, word = term.as_coeff_Mul()
        q = Fraction(int(multiple.p), int(multiple.q)) if multiple.is_Rational else Fraction(0)
        halved = q.denominator & (q.denominator - 1) == 0 and q.denominator <= 2**MOST_HALVINGS
        if word in arcs and halved and abs(q.numerator) <= LARGEST_MULTIPLE:
            multiples[word] = multiples.get(word, Fraction(0)) + q
        else:
            rest += term
    return {word: q for word, q in multiples.items() if q}, rest


def _direction(arc: Arc, multiple: Fraction, above: bool = False) -> tuple[Any, Any]:
    """Cosine and sine of a multiple of an arc: that of half of it has a cosine that is not negative.

    Nor has it a sine that is, where the point is `above` the axis.
    """
    x, y, square = arc.x, arc.y, arc.square
    for _ in range(multiple.denominator.bit_length() - 1):
        cosine = x / sympy.sqrt(square)
        x = sympy.sqrt((1 + cosine) / 2)
        y = sympy.sqrt((1 - cosine) / 2) if above else y / sympy.sqrt(square) / (2 * x)
        square = sympy.S.One
    cosine, sine = sympy.S.One, sympy.S.Zero
    for _ in range(abs(multiple.numerator)):
        cosine, sine = cosine * x - sine * y, cosine * y + sine * x
    length = square ** sympy.Rational(abs(multiple.numerator), 2)
    return cosine / length, (sine if multiple > 0 else -sine) / length


def _cosine_and_sine(
    multiples: Mapping[FunctionSymbol, Fraction], rest: Any, arcs: Mapping[FunctionSymbol, Arc]
) -> tuple[Any, Any]:
    directions = []
    for word, multiple in multiples.items():
        arc, more = arcs[word], sympy.pi * sympy.Rational(multiple) / 2
        # Half of acos(u), for example, which is said as pi/2 - asin(u), is half of the angle of (u, sqrt(1 - u^2)).
        simpler = multiple.denominator > 1 and _parts(rest + more) < _parts(rest)
        if simpler and max(-arc.low, arc.high) <= HALF:
            rest, arc = sympy.expand(rest + more), replace(arc, x=arc.y, y=arc.x)
            directions.append(_direction(arc, -multiple, above=True))
        else:
            directions.append(_direction(arc, multiple))
    cosine, sine = sympy.cos(rest), sympy.sin(rest)
    for x, y in directions:
        cosine, sine = cosine * x - sine * y, cosine * y + sine * x
    return cosine, sine


def _parts(angle: Any) -> int:
    """Into how many parts a half turn is divided that occurs in a sum of angles."""
    return int(sympy.expand(angle).coeff(sympy.pi).as_coeff_Mul()[0].q)


def without_arcs(function: type, argument: Any, arcs: Mapping[FunctionSymbol, Arc]) -> Any:
    """Sine, cosine, ... of an angle in which arcs occur, in terms of their cosines and sines."""
    multiples, rest = _split(argument, arcs)
    if not multiples:
        return function(argument)
    cosine, sine = _cosine_and_sine(multiples, rest, arcs)
    values = {"": sympy.S.One, "cos": cosine, "sin": sine}
    above, below = CIRCULAR[function]
    return values[above] / values[below]


def _vanishes(difference: Any, arcs: Mapping[FunctionSymbol, Arc]) -> tuple[Any, int] | None:
    """A cosine that is one exactly where the difference is zero, and how often that was halved."""
    multiples, rest = _split(difference, arcs)
    turn = (rest / sympy.pi).expand()
    if not multiples or not turn.is_Rational:
        return None
    low = high = Fraction(int(turn.p), int(turn.q))
    open_low = open_high = False
    for word, multiple in multiples.items():
        arc = arcs[word]
        (least, above), (most, below) = [*zip((arc.low, arc.high), arc.open, strict=True)][:: 1 if multiple > 0 else -1]
        low, high = low + multiple * least, high + multiple * most
        open_low, open_high = open_low or above, open_high or below
    for halvings in range(MOST_HALVINGS):
        size = 2**halvings
        if (low > -2 * size or (open_low and low == -2 * size)) and (
            high < 2 * size or (open_high and high == 2 * size)
        ):
            halved = {word: multiple / size for word, multiple in multiples.items()}
            return _cosine_and_sine(halved, rest / size, arcs)[0], halvings
    return None


def turned(left: Any, right: Any, arcs: Mapping[FunctionSymbol, Arc]) -> tuple[Any, int] | None:
    """A cosine that is one exactly where sums of arcs are equal, and of which part of their difference it is."""
    if not arcs or not (left.has(*arcs) or right.has(*arcs)):
        return None
    return _vanishes(left - right, arcs)
