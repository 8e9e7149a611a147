"""What a search for points has to know: what SymPy assumes of symbols, which angles are products, what moves."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.proof.from_sympy.atoms import ASSUMPTIONS
from chasles.proof.from_sympy.given import Equations, Given, orders_of
from chasles.proof.from_sympy.reader import Reader
from chasles.proof.from_sympy.triads import Triad
from chasles.proof.search import Frame, Motion, Search
from chasles.proof.surds import Exact

__all__ = ["search_for"]


def search_for(reader: Reader, given: Given) -> Search:
    """The search that a question needs."""
    atoms = reader.atoms.words
    assumed = {word.name: _assumed(atom) for atom, word in atoms.items()}
    triads = [item.triad for item in given.equations if item.triad and not item.derived]
    return Search(
        allowed=lambda name, value: _agrees(value, assumed.get(name, {})),
        products=reader.angles.products,
        rigid=frozenset(word for atom, word in atoms.items() if _is_rigid(atom)),
        frames=tuple(Frame(_names(reader, triad), triad.proper) for triad in triads),
        motion=_motion(reader, given),
        spelled=lambda symbol: str(reader.atoms.origins[symbol]),
        blind=_is_blind(reader, given),
    )


def _names(reader: Reader, triad: Triad) -> tuple[tuple[str, ...], ...]:
    return tuple(tuple(reader.atoms.word(atom).name for atom in row) for row in triad.matrix.tolist())


def _motion(reader: Reader, given: Given) -> Motion | None:
    """What has to be looked at where given equations hold at all times, and rates occur."""
    atoms = reader.atoms.words
    highest: dict[Any, int] = {}
    equations: dict[str, int | None] = {}
    for item in _moving(given):
        for function, order in orders_of(item.sides).items():
            highest[function] = max(highest.get(function, 0), order)
        equations[item.text] = None if item.triad is None else item.triad.rank
    if not equations or not any(isinstance(atom, sympy.Derivative) for atom in atoms):
        return None
    rates = [sympy.Derivative(f, (f.args[0], order)) if order else f for f, order in highest.items()]
    return Motion(equations, [atoms[rate].name for rate in rates if rate in atoms])


def _moving(given: Given) -> list[Equations]:
    """The given equations between functions."""
    return [item for item in given.equations if not item.derived and orders_of(item.sides)]


def _is_blind(reader: Reader, given: Given) -> bool:
    """Whether there are conditions that points are not checked for.

    Such are what SymPy assumes of angles that equations tie together, angles that are rational numbers, and partial
    differential equations.
    """
    tied = [part for _, atom, value in given.substitutions for part in (atom, *value.atoms(sympy.Symbol, AppliedUndef))]
    turning = [atom for atom, word in reader.atoms.words.items() if word in reader.angles.met]
    moving = [orders_of(item.sides) for item in _moving(given)]
    variables = {argument for orders in moving for function in orders for argument in function.args}
    partial = len(variables) > 1 and any(order for orders in moving for order in orders.values())
    return partial or any(map(_assumed, tied)) or any(map(_is_rigid, turning))


def _is_rigid(atom: Any) -> bool:
    """Whether an atom is known to be algebraic: its cosine and sine are not rational then, unless it is zero."""
    return bool(atom.is_algebraic or atom.is_zero)


def _assumed(atom: Any) -> dict[str, bool]:
    """What SymPy knows of an atom, beyond its being real."""
    return {key: known for key in ASSUMPTIONS if (known := getattr(atom, f"is_{key}")) is not None}


def _agrees(value: Exact, wanted: Mapping[str, bool]) -> bool:
    if not wanted:
        return True
    number = value.as_rational
    exact = sympy.sympify(value.text("pi")) if number is None else sympy.Rational(number.numerator, number.denominator)
    return all(getattr(exact, f"is_{key}") is known for key, known in wanted.items())
