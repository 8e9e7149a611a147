"""Side conditions: the given equations as hypotheses, with all that follows from them by differentiation."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.proof.from_sympy.complexes import Parts
from chasles.proof.from_sympy.divisors import CIRCULAR
from chasles.proof.from_sympy.opening import is_atom, sides
from chasles.proof.from_sympy.triads import Triad, triads_of
from chasles.proof.variables import Untreatable

__all__ = ["Equations", "Given", "collected", "orders_of"]

Pair = tuple[Any, Any]


@dataclass(slots=True)
class Equations:
    """Equations under one name; `sources` are what the user gave, `derived` if they follow by differentiation."""

    text: str
    pairs: list[Pair]
    sources: tuple[str, ...]
    triad: Triad | None = None
    derived: bool = False

    @property
    def sides(self) -> list[Any]:
        """Both sides of all of them."""
        return [side for pair in self.pairs for side in pair]


@dataclass(slots=True)
class Given:
    """The given equations, what they say of angles (used by substitution), and the triads among them.

    `stated` are the pairs of sides as they were given.
    """

    equations: list[Equations] = field(default_factory=list)
    substitutions: list[tuple[str, Any, Any]] = field(default_factory=list)
    stated: list[Pair] = field(default_factory=list)


def collected(given: Iterable[Any], spoken_of: Sequence[Any], parts: Parts) -> tuple[Given, list[Any]]:
    """The given equations, complex ones by their parts, and what is spoken of with the given angles put in.

    Raises `Untreatable` for what is no equation, and for differential equations in several variables.
    """
    result = Given()
    for place, item in enumerate(given):
        said = sides(item, f"given[{place}]")
        pairs = list(dict.fromkeys(pair for one, other in said for pair in parts.pairs(one, other)))
        result.stated += pairs
        if pairs:
            text = _text(item, place)
            taken = any(text == other.text for other in result.equations)
            result.equations.append(Equations(f"{text} [{place}]" if taken else text, pairs, (text,)))
    expressions = _without_given_angles(result, list(spoken_of))
    _state_triads(result)
    _differentiate(result, expressions)
    return result, expressions


def _text(item: Any, place: int) -> str:
    """How a need on it is spelled: the equation, or its place in the list if it is a matrix."""
    if isinstance(item, sympy.Equality) and isinstance(item.lhs, sympy.Expr):
        return f"{item.lhs} = {item.rhs}"
    return f"{item} = 0" if isinstance(item, sympy.Expr) else f"given[{place}]"


def _without_given_angles(result: Given, expressions: list[Any]) -> list[Any]:
    """Use equations between angles, such as alpha + beta + gamma = pi, to eliminate one of the angles."""
    for item in list(result.equations):
        for pair in list(item.pairs):
            angles = _angles_in([*expressions, *(side for other in result.equations for side in other.sides)])
            solved = _solved_for_angle(pair[0] - pair[1], angles)
            if solved is None:
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
    """The atoms that occur in arguments of functions of angles."""
    calls = {call for e in expressions for call in e.atoms(*CIRCULAR)}
    return {part for call in calls for part in sympy.preorder_traversal(call.args[0]) if is_atom(part)}


def _solved_for_angle(difference: Any, angles: set[Any]) -> tuple[Any, Any] | None:
    """The angle that a linear equation with rational coefficients determines, and its value."""
    terms = sympy.expand(difference).as_coefficients_dict()
    if not all(term is sympy.pi or is_atom(term) for term in terms):
        return None
    candidates = sorted((term for term in terms if term in angles), key=str)
    if not candidates:
        return None
    atom = candidates[-1]
    return atom, sympy.expand(atom - difference / terms[atom])


def _put_in(expression: Any, atom: Any, value: Any) -> Any:
    return expression.subs(atom, value).doit() if expression.has(atom) else expression


def _state_triads(result: Given) -> None:
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


def _differentiate(result: Given, expressions: list[Any]) -> None:
    """Add the derivatives of the given equations, up to the highest order that the question asks for."""
    moving = [(item, orders_of(item.sides)) for item in result.equations if orders_of(item.sides)]
    variables = {argument for _, orders in moving for function in orders for argument in function.args}
    wanted = orders_of(expressions)
    for _, orders in moving:
        for function, order in orders.items():
            wanted[function] = max(wanted.get(function, 0), order)
    times = max((wanted[f] - order for _, orders in moving for f, order in orders.items()), default=0)
    if times and len(variables) != 1:
        raise Untreatable(f"{moving[0][0].text}: given functions of several variables are not differentiated")
    for item, _ in moving:
        pairs, variable = item.pairs, next(iter(variables))
        for count in range(1, times + 1):
            pairs = [(sympy.diff(a, variable), sympy.diff(b, variable)) for a, b in pairs]
            text = f"d{count if count > 1 else ''}/d{variable} ({item.text})"
            changing = [pair for pair in pairs if pair[0] != pair[1]]
            if changing:
                result.equations.append(Equations(text, changing, item.sources, derived=True))


def _functions(expression: Any) -> set[Any]:
    return set(expression.atoms(AppliedUndef))


def orders_of(expressions: Iterable[Any]) -> dict[Any, int]:
    """How often each function is differentiated."""
    found: dict[Any, int] = {}
    for expression in expressions:
        for function in _functions(expression):
            found.setdefault(function, 0)
        for derivative in expression.atoms(sympy.Derivative):
            if isinstance(derivative.expr, AppliedUndef):
                found[derivative.expr] = max(found.get(derivative.expr, 0), derivative.derivative_count)
    return found
