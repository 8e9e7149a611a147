"""Side conditions: the given equations as hypotheses, with all that follows from them by differentiation.

Angles that a given equation determines, as alpha + beta + gamma = pi does, are put in wherever they occur.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.quantities import is_atom
from chasles.checker.expressions.readings import CIRCULAR, FUNCTIONS
from chasles.from_sympy.atoms import nonzero_by_sign, real_copy
from chasles.from_sympy.complex_symbols import RealParts
from chasles.from_sympy.exponents import may_be_factored
from chasles.from_sympy.given_equations import Equations, Moving, SideConditions
from chasles.from_sympy.opening import parts_of, sides
from chasles.from_sympy.pantelides import offsets
from chasles.from_sympy.real_zeros import squares_in
from chasles.from_sympy.side_conditions import listed
from chasles.from_sympy.triads import triads_of
from chasles.problems.variables import Untreatable

MOST_TERMS = 30
"""Longer polynomials are not factored."""
ELEMENTARY = tuple(getattr(sympy, name) for name in FUNCTIONS)


def collected(given: Any, spoken_of: Sequence[Any], parts: RealParts) -> tuple[SideConditions, list[Any]]:
    """The given equations, complex ones by their parts, and what is spoken of with the given angles put in.

    Raises `Untreatable` for what is no equation, and for differential equations in several variables.
    """
    result = SideConditions()
    for place, (what, item) in enumerate(listed(given, "given")):
        said = list(sides(item, what))
        pairs = list(dict.fromkeys(pair for one, other in said for pair in parts.pairs(one, other)))
        result.stated += pairs
        if pairs:
            text = text_of(item, what)
            taken = any(text == other.text for other in result.equations)
            label = f"given {place} 1,1" if len(said) == len(pairs) == 1 else ""
            result.equations.append(Equations(f"{text} [{place}]" if taken else text, pairs, (text,), label=label))
    expressions = without_given_angles(result, list(spoken_of))
    _state_triads(result)
    _state_squares(result)
    _differentiate(result, expressions)
    return result, expressions


def impossible(given: SideConditions, declared: Sequence[Any]) -> str | None:
    """A condition that is false on its face: two numbers that differ set equal, or zero said not to vanish."""
    for item in given.equations:
        if any((left - right).is_zero is False and not (left - right).free_symbols for left, right in item.pairs):
            return (item.sources or (item.text,))[0]
    return next((f"{scalar} != 0" for scalar in declared if scalar.is_zero or sympy.expand(scalar) == 0), None)


def evident(given: SideConditions, sides: Sequence[Any]) -> Iterator[Any]:
    """What does not vanish because of signs: factors of given equations and of rates there, a sum of positive sides."""
    for item in given.equations:
        for one, other in item.pairs if item.triad is None and not item.derived else ():
            if len(sympy.Add.make_args(one - other)) <= MOST_TERMS:
                found = [*_factors(one - other), *_leading(one - other)]
                yield from (factor for factor in found if nonzero_by_sign(factor))
    if len(sides) == 2 and given.equations and all(real_copy(side).is_nonnegative for side in sides):
        yield from (total for total in [sides[0] + sides[1]] if nonzero_by_sign(total))


def _factors(difference: Any) -> list[Any]:
    """The factors of a polynomial that has several, if its degree is moderate."""
    if not may_be_factored(difference):
        return []
    try:
        _, factors = sympy.factor_list(difference)
    except sympy.PolynomialError:
        return []
    return [factor for factor, _ in factors] if len(factors) > 1 else []


def _leading(difference: Any) -> Iterator[Any]:
    """What rates are multiplied by."""
    expanded = sympy.expand(difference)
    return (expanded.coeff(rate) for rate in sorted(expanded.atoms(sympy.Derivative), key=str))


def text_of(item: Any, what: str) -> str:
    """How a need on it is spelled: the equation, or its place in the list if it is a matrix."""
    if isinstance(item, sympy.Equality) and isinstance(item.lhs, sympy.Expr):
        return f"{item.lhs} = {item.rhs}"
    if item is sympy.false:
        return f"{what} (false to SymPy)"
    return f"{item} = 0" if isinstance(item, sympy.Expr) else what


def _state_triads(result: SideConditions) -> None:
    """Let orthonormal columns be said by all the quadrics they satisfy, in the place of the equations that say so."""
    places = [(item, k) for item in result.equations for k in range(len(item.pairs))]
    taken: dict[int, set[int]] = {}
    for triad in triads_of([item.pairs[k] for item, k in places]):
        sources = [places[source] for source in triad.sources]
        texts = dict.fromkeys(text for item, _ in sources for text in item.sources)
        for item, k in sources:
            taken.setdefault(id(item), set()).add(k)
        result.equations.append(Equations(" and ".join(texts), triad.equations, tuple(texts), triad))
    for item in result.equations:
        gone = taken.get(id(item), set())
        item.pairs = [pair for k, pair in enumerate(item.pairs) if k not in gone]
    result.equations = [item for item in result.equations if item.pairs]


def _state_squares(result: SideConditions) -> None:
    """Let each square vanish of which others and a given equation make a sum that does."""
    for item in [item for item in result.equations if item.label and len(item.pairs) == 1 and item.triad is None]:
        ((one, other),) = item.pairs
        for number, found in enumerate(squares_in(item.label, one - other)):
            result.squares.append(found)
            pairs = [(part, sympy.S.Zero) for part in found.vanishing]
            text = f"squares {number + 1} in {item.text}"
            result.equations.append(Equations(text, pairs, item.sources, derived=True))


def _differentiate(result: SideConditions, expressions: list[Any]) -> None:
    """Add derivatives of the given equations: all that say something of the rates that occur."""
    rows: list[Moving] = []
    for item in result.equations:
        moving = orders_of(item.sides)
        item.moving = [Moving({} if _says_sign(pair) else orders_of(pair)) for pair in item.pairs] if moving else []
        rows += [row for row in item.moving if row.orders]
    found = offsets([row.orders for row in rows])
    more = max((0, *(order - found.highest.get(f, order) for f, order in orders_of(expressions).items())))
    for row, times in zip(rows, found.times, strict=True):
        row.times = times + more
    result.highest = found.highest
    variables = {argument for row in rows for function in row.orders for argument in function.args}
    for item in [item for item in result.equations if item.moving]:
        _add_derivatives(result, item, variables)


def _is_differentiated(*sides: Any) -> bool:
    """Whether sides have only rates of functions: none of what jumps, or may not be real."""
    jumps = any(side.has(sympy.DiracDelta, sympy.re, sympy.im) for side in sides)
    return not jumps and all(isinstance(e.expr, AppliedUndef) for side in sides for e in side.atoms(sympy.Derivative))


def _add_derivatives(result: SideConditions, item: Equations, variables: set[Any]) -> None:
    pairs = list(zip(item.pairs, item.moving, strict=True))
    for count in range(1, 1 + max(row.times for row in item.moving)):
        if len(variables) != 1:
            raise Untreatable(f"{item.text}: given functions of several variables are not differentiated")
        (variable,) = variables
        pairs = [((sympy.diff(a, variable), sympy.diff(b, variable)), row) for (a, b), row in pairs]
        pairs = [(pair, row) for pair, row in pairs if count <= row.times and _is_differentiated(*pair)]
        changing = [pair for pair, _ in pairs if pair[0] != pair[1]]
        text = f"d{count if count > 1 else ''}/d{variable} ({item.text})"
        if changing:
            result.equations.append(Equations(text, changing, item.sources, derived=True))


def _says_sign(pair: tuple[Any, Any]) -> bool:
    """Whether an equation says that something is not negative: then its rates say nothing, where it is positive."""
    one, other = pair
    return bool(one != other and one == sympy.Abs(other))


def orders_of(expressions: Iterable[Any]) -> dict[Any, int]:
    """How often each function is differentiated."""
    found: dict[Any, int] = {}
    for expression in expressions:
        for function in sorted({part for part in parts_of(expression) if isinstance(part, AppliedUndef)}, key=str):
            found.setdefault(function, 0)
        derivatives = (part for part in parts_of(expression) if isinstance(part, sympy.Derivative))
        for derivative in sorted(derivatives, key=str):
            if isinstance(derivative.expr, AppliedUndef):
                found[derivative.expr] = max(found.get(derivative.expr, 0), derivative.derivative_count)
    return found


def without_given_angles(result: SideConditions, expressions: list[Any]) -> list[Any]:
    """Use equations between angles, such as alpha + beta + gamma = pi, to eliminate one of the angles."""
    for item in list(result.equations):
        for pair in list(item.pairs):
            spoken = [*expressions, *(side for other in result.equations for side in other.sides)]
            solved = _solved_for_angle(pair[0] - pair[1], _angles_in(spoken))
            if solved is None or not _keeps_its_meaning(spoken, *solved):
                continue
            atom, value = solved
            item.pairs.remove(pair)
            result.substitutions.append((item.text, atom, value))
            expressions = [_put_in(e, atom, value) for e in expressions]
            for other in result.equations:
                other.pairs = [(_put_in(a, atom, value), _put_in(b, atom, value)) for a, b in other.pairs]
    result.equations = [item for item in result.equations if item.pairs]
    return expressions


def _angles_in(expressions: Iterable[Any]) -> set[Any]:
    """The atoms that occur in arguments of functions, of which the angles are the most common."""
    return _arguments(expressions, *CIRCULAR, *ELEMENTARY, sympy.Pow)


def _arguments(expressions: Iterable[Any], *kinds: Any) -> set[Any]:
    calls = {call for e in expressions for call in parts_of(e) if isinstance(call, kinds)}
    calls = {
        call for call in calls if not (call.is_Pow and call.exp.is_Rational and call.exp.q & (call.exp.q - 1) == 0)
    }
    parts = (part for call in calls for argument in call.args for part in parts_of(argument))
    return {part for part in parts if is_atom(part)}


def _solved_for_angle(difference: Any, angles: set[Any]) -> tuple[Any, Any] | None:
    """The angle that a linear equation with rational coefficients determines, and its value.

    Nothing is lost by putting it in: the angle is no rate, and neither it nor a rate of it occurs in the value.
    """
    difference, below = sympy.fraction(sympy.together(difference))
    terms = sympy.expand(difference).as_coefficients_dict()
    if not nonzero_by_sign(below) or not all(term in (sympy.pi, sympy.S.One) or is_atom(term) for term in terms):
        return None
    moved = [term.expr for term in terms if isinstance(term, sympy.Derivative)]
    candidates = sorted((term for term in terms if term in angles and term not in moved), key=str)
    candidates = [term for term in candidates if not isinstance(term, sympy.Derivative)]
    if not candidates:
        return None
    atom = candidates[-1]
    return atom, sympy.expand(atom - difference / terms[atom])


def _keeps_its_meaning(expressions: list[Any], atom: Any, value: Any) -> bool:
    """Whether all is real, and an angle or defined, where a value that is no sum of angles is put in, as before."""
    rest = value.as_coefficients_dict().get(sympy.S.One, 0)
    if rest == 0 and value.free_symbols:
        return True
    powers = [part for e in expressions for part in parts_of(e) if part.is_Pow and part.exp.has(atom)]
    turned = rest != 0 and atom in _arguments(expressions, *CIRCULAR)
    if turned or not all(part.base.is_positive for part in powers):
        return False
    lost = (sympy.zoo, sympy.nan, sympy.oo, sympy.I)
    return not any(_put_in(e, atom, value).has(*lost) and not e.has(*lost) for e in expressions)


def _put_in(expression: Any, atom: Any, value: Any) -> Any:
    return expression.subs(atom, value).doit() if expression.has(atom) else expression
