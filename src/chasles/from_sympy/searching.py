"""What a search for points needs: the assumptions of the symbols, angles that are products, functions of time."""

from __future__ import annotations

from collections.abc import Mapping
from math import inf
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.algebra.surds import SurdSum
from chasles.from_sympy.atoms import assumed_of
from chasles.from_sympy.given import orders_of
from chasles.from_sympy.given_equations import Equations, SideConditions
from chasles.from_sympy.reader import Reader
from chasles.from_sympy.triads import Triad
from chasles.points.search import Frame, Search


def search_for(reader: Reader, given: SideConditions) -> Search:
    """The search that a question needs."""
    atoms = reader.atoms.words
    assumed = {word.name: assumed_of(atom) for atom, word in atoms.items()}
    triads = [item.triad for item in given.equations if item.triad and not item.derived]
    return Search(
        allowed=lambda name, value: _agrees(value, assumed.get(name, {})),
        products=reader.angles.products,
        rigid=frozenset(word for atom, word in atoms.items() if _is_rigid(atom)),
        frames=tuple(Frame(_names(reader, triad), triad.proper) for triad in triads),
        determined=_determined(reader, given),
        spelled=lambda symbol: str(reader.atoms.origins[symbol]),
        blind=_is_blind(reader, given),
    )


def _names(reader: Reader, triad: Triad) -> tuple[tuple[str, ...], ...]:
    return tuple(tuple(reader.atoms.word(atom).name for atom in row) for row in triad.matrix.tolist())


def is_about_motion(reader: Reader, given: SideConditions) -> bool:
    """Whether it has to be asked if a motion goes through a point; where not, constants will do for functions."""
    moving = _moving(given)
    times = {argument for item in moving for row in item.moving for f in row.orders for argument in f.args}
    explicit = any(side.has(*times) for item in moving for side in map(_standing, item.sides)) if times else False
    return bool(moving) and (explicit or any(isinstance(atom, sympy.Derivative) for atom in reader.atoms.words))


def _determined(reader: Reader, given: SideConditions) -> frozenset[str]:
    """The names of the rates that the given equations determine."""
    if not is_about_motion(reader, given):
        return frozenset()
    words = reader.atoms.words.items()
    return frozenset(word.name for atom, word in words if _order(atom) >= given.highest.get(_function(atom), inf))


def _function(atom: Any) -> Any:
    return atom.expr if isinstance(atom, sympy.Derivative) else atom


def _order(atom: Any) -> int:
    return int(atom.derivative_count) if isinstance(atom, sympy.Derivative) else 0


def _standing(side: Any) -> Any:
    """What is left when functions, in whose arguments the time always occurs, are taken out."""
    return side.xreplace({f: sympy.Dummy() for f in side.atoms(AppliedUndef, sympy.Derivative)})


def _moving(given: SideConditions) -> list[Equations]:
    """The given equations between functions."""
    return [item for item in given.equations if item.moving]


def _is_blind(reader: Reader, given: SideConditions) -> bool:
    """Whether there are conditions that points are not checked for.

    Such are what SymPy assumes of angles that equations tie together, angles that are rational numbers, and partial
    differential equations.
    """
    tied = [part for _, atom, value in given.substitutions for part in (atom, *value.atoms(sympy.Symbol, AppliedUndef))]
    turning = [atom for atom, word in reader.atoms.words.items() if word in reader.angles.met]
    moving = [orders_of(item.sides) for item in _moving(given)]
    variables = {argument for orders in moving for function in orders for argument in function.args}
    partial = len(variables) > 1 and any(order for orders in moving for order in orders.values())
    return partial or any(map(assumed_of, tied)) or any(map(_is_rigid, turning))


def _is_rigid(atom: Any) -> bool:
    """Whether an atom is known to be algebraic: its cosine and sine are not rational then, unless it is zero."""
    return bool(atom.is_algebraic or atom.is_zero)


def _agrees(value: SurdSum, wanted: Mapping[str, bool]) -> bool:
    if not wanted:
        return True
    number = value.as_rational
    exact = sympy.sympify(value.text("pi")) if number is None else sympy.Rational(number.numerator, number.denominator)
    return all(getattr(exact, f"is_{key}") is known for key, known in wanted.items())
