"""Does a point satisfy what is given? Equations between functions hold at all times, and so do their derivatives."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import reduce
from math import isqrt
from operator import add
from typing import Any

import sympy

from chasles.checker.expressions.algebra import constant, primitive
from chasles.checker.expressions.asked import Asked, GivenEquation
from chasles.checker.expressions.at_point import AtPoint
from chasles.checker.expressions.complexes import differences, parts
from chasles.checker.expressions.expressions import Expressions
from chasles.checker.expressions.quantities import atoms_of
from chasles.checker.expressions.rates import MOST_RATES
from chasles.checker.expressions.readings import CIRCULAR
from chasles.checker.expressions.symbolic import UnknownValue
from chasles.checker.sparse import ONE, ZERO, Polynomial, Rejected, determinant, number, product, variable


def time_of(given: Iterable[GivenEquation]) -> Any:
    """The one symbol of which all functions in some equations are functions; raises `Rejected` if there is none."""
    times = {argument for item in given for function in item.functions for argument in function.args}
    if len(times) != 1:
        raise Rejected("functions of several variables are not differentiated")
    return times.pop()


def require_motion(given: Iterable[GivenEquation], point: AtPoint, through: bool) -> None:
    """Equations between functions hold at the point with all derivatives that speak of what has a value there.

    If a motion is to go `through` the point, the last of these can be solved for as many of the highest rates, and no
    higher rate has a value. Then implicit functions, and ordinary differential equations for them, make one (and an
    equation that follows from the others holds along it). So do constants where all rates vanish and nothing that is
    given speaks of time. Raises `Rejected` if not.
    """
    moving = [item for item in given if item.functions]
    read = point.symbolic
    times = {argument for item in moving for function in item.functions for argument in function.args}
    if not moving or not any(isinstance(e, sympy.Derivative) or e in times for e in read.atoms.values()):
        return  # constants will do for functions
    time = time_of(moving)
    pairs = [dict([item]) for each in moving for item in each.pairs.items() if not _holds_nearby(point, *item[1])]
    stated = [fact for pair in pairs for fact in differences(read, pair).values()]
    stated = [fact for fact in stated if fact and not _is_determinant(read, fact, moving)]
    unlike = {frozenset(base.terms.items()): base for _, base in map(primitive, stated)}
    chains = [_chain(point, fact, time) for fact in unlike.values()]
    last = [chain[-1] for chain in chains]
    lower = [fact for chain in chains for fact in reversed(chain[:-1])]
    spoken = {read.atoms[place] for fact in stated for place in _spoken_of(read, fact)}
    valued = [e for e in read.atoms.values() if isinstance(e, sympy.Derivative) and str(e) in point.numbers]
    if not through or (time not in spoken and not any(point.sign(point.atom(e)) for e in valued)):
        return
    highest: dict[Any, int] = {}
    for fact in last:
        for e in (read.atoms[place] for place in _spoken_of(read, fact)):
            function, order = (e.expr, int(e.derivative_count)) if isinstance(e, sympy.Derivative) else (e, 0)
            highest[function] = max(highest.get(function, 0), order)
    for e in read.atoms.values():
        higher = isinstance(e, sympy.Derivative) and e.derivative_count > highest.get(e.expr, e.derivative_count)
        if higher and str(e) in point.numbers:
            raise Rejected(f"it is not seen that {e} can have its value at the point")
    rates = [sympy.Derivative(f, (time, n)) if n else f for f, n in highest.items() if time in f.args]
    rows: list[list[Polynomial]] = []
    for k, fact in enumerate(last):
        row = [point.value_of(read.rate(fact, rate)) for rate in rates]
        if _rank(point, [*rows, row]) > len(rows):
            rows.append(row)
        elif not _follows(point, fact, [*last[:k], *last[k + 1 :], *lower], time):
            raise Rejected("it is not seen that there is a motion through the point")


def _holds_nearby(point: AtPoint, *sides: Any) -> bool:
    """Whether sides that are equal up to their sign are equal at the point and not zero: so they are, near it."""
    (a, b), (c, d) = (parts(point.symbolic, side) for side in sides)
    equal = not (b or d) and point.symbolic.vanishes(point.symbolic.normal(a * a - c * c))
    return equal and bool(point.sign(point.value_of(a + c)))


def _chain(point: AtPoint, fact: Polynomial, time: Any) -> list[Polynomial]:
    """It and its derivatives that speak of what has a value only; raises `Rejected` if one does not vanish."""
    chain = [fact]
    if not point.vanishes(point.value_of(fact)):
        raise Rejected("an equation given does not vanish at the point")
    for _ in range(MOST_RATES):
        rate = point.symbolic.rate(fact, time)
        try:
            value = point.value_of(rate)
        except UnknownValue:
            break
        if not point.vanishes(value):
            raise Rejected("a derivative of an equation given does not vanish at the point")
        if not rate:
            break
        fact = rate
        chain.append(fact)
    return chain


def _spoken_of(read: Expressions, fact: Polynomial) -> set[int]:
    """The quantities on which something depends."""
    known: set[int] = set()
    waiting = set(fact.places)
    while waiting:
        place = waiting.pop()
        if place not in known:
            known.add(place)
            for of in (read.squares.get(place), read.inverses.get(place)):
                waiting |= of.places if of is not None else set()
            for monomial, (_, cosine, sine) in read.circles.items():
                waiting |= Polynomial({monomial: 1}).places if place in cosine.places | sine.places else set()
    return known & read.atoms.keys()


def _follows(point: AtPoint, fact: Polynomial, others: list[Polynomial], time: Any) -> bool:
    """Whether something vanishes at all times when the highest rates that others determine are put in.

    What is left of it, a multiple, may also speak of nothing that changes: it vanishes at the point.
    """
    read = point.symbolic
    for other in others:
        rates = [k for k in other.places if isinstance(read.atoms.get(k), sympy.Derivative)]
        for place in sorted(rates, key=lambda k: -read.atoms[k].derivative_count):
            slope, own = other.partials()[place], fact.partials().get(place)
            number_of = constant(slope)
            if own is not None and number_of is not None:
                factors = {k: variable(k) for k in fact.places}
                factors[place] = variable(place) - other * number(1 / number_of)
                terms = (product(factors, m) * number(Fraction(c, fact.below)) for m, c in fact.terms.items())
                fact = read.normal(reduce(add, terms, ZERO))
                break
            linear = own is not None and place not in slope.places | own.places
            if own is not None and linear and point.sign(point.value_of(slope)):
                fact = read.normal(fact * slope - own * other)
                break
    changing = (read.atoms[place] for place in _spoken_of(read, fact))
    return read.vanishes(fact) or not any(e.has(time) for e in changing)


def _is_determinant(read: Expressions, fact: Polynomial, moving: list[GivenEquation]) -> bool:
    """Whether the square of what is said to be one is one already, since it is the determinant of what is given."""
    square = (fact + ONE) * (fact + ONE)
    for item in moving:
        size = isqrt(len(item.pairs))
        if size > 1 and item.pairs.keys() == {(i, j) for i in range(size) for j in range(size)}:
            said = differences(read, item.pairs)
            gram = [[said[i, j] + number(int(i == j)) for j in range(size)] for i in range(size)]
            if read.vanishes(determinant(gram) - square):
                return True
    return False


def _rank(point: AtPoint, rows: list[list[Polynomial]]) -> int:
    """The rank of a matrix of numbers, by elimination without division."""
    rank = 0
    for column in range(len(rows[0]) if rows else 0):
        pivot = next((r for r in range(rank, len(rows)) if point.sign(rows[r][column])), None)
        if pivot is None:
            continue
        rows[rank], rows[pivot] = rows[pivot], rows[rank]
        lead = rows[rank]
        for r in range(rank + 1, len(rows)):
            row = rows[r]
            rows[r] = [point.normal(a * lead[column] - b * row[column]) for a, b in zip(row, lead, strict=True)]
        rank += 1
    return rank


def require_given(asked: Asked, point: AtPoint, through: bool = True) -> None:
    """Every equation given holds at the point, and nothing vanishes there that must not.

    Where functions move, the derivatives hold too, and a motion goes `through` the point, if it is asked whether one
    does. Raises `Rejected` if not.
    """
    _eliminate(asked, point)
    for item in asked.given:
        read = point.symbolic
        # An equation by which an angle was eliminated says nothing more.
        pairs = {
            place: pair
            for place, pair in item.pairs.items()
            if not (read.values and all(map(read.vanishes, differences(read, {place: pair}).values())))
        }
        if not all(map(point.vanishes, differences(point, pairs).values())):
            raise Rejected(f"the point does not satisfy {item.text}")
    for e in asked.nonzero:
        if not any(map(point.sign, parts(point, e))):
            raise Rejected(f"{e} is zero at the point")
    require_motion(asked.given, point, through)


def _eliminate(asked: Asked, point: AtPoint) -> None:
    """Angles that equations give, and of which the point does not speak, have the values given."""
    calls = {call for expression in asked.expressions for call in expression.atoms(*CIRCULAR)}
    turned = {e for call in calls for e in atoms_of(call.args[0])}
    for item in asked.given:
        for difference in differences(point.symbolic, item.pairs).values():
            atoms = {point.symbolic.atoms.get(place) for place in difference.places} & turned
            unspoken = [e for e in atoms if not any(str(e) in name for name in point.turns)]
            if unspoken:
                eliminate_angle(point.symbolic, difference, max(unspoken, key=str))


def eliminate_angle(reading: Expressions, difference: Polynomial, e: Any) -> bool:
    """Let a quantity have the value that a linear equation with rational coefficients gives it, if this is one."""
    slopes = {place: constant(slope) for place, slope in difference.partials().items()}
    own, slope = next(((place, slopes[place]) for place in slopes if reading.atoms.get(place) == e), (0, None))
    if slope is None or None in slopes.values() or not slopes.keys() <= reading.atoms.keys():
        return False
    reading.substitute(e, variable(own) - difference * number(1 / slope))
    return True
