"""What a search for points needs: the assumptions of the symbols, angles that are products, functions of time."""

from __future__ import annotations

from collections.abc import Mapping
from math import inf
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.algebra.surds import SurdSum
from chasles.from_sympy.atoms import ASSUMPTIONS
from chasles.from_sympy.given import Equations, Moving, SideConditions, orders_of
from chasles.from_sympy.reader import Reader
from chasles.from_sympy.triads import Triad
from chasles.points.search import DifferentiatedRow, EquationBlock, Frame, Motion, Search
from chasles.vocabulary import Symbol


def search_for(reader: Reader, given: SideConditions) -> Search:
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


def _motion(reader: Reader, given: SideConditions) -> Motion | None:
    """What has to be looked at where given equations hold at all times; None where constants will do for functions."""
    atoms = reader.atoms.words
    moving = _moving(given)
    times = {argument for item in moving for row in item.moving for f in row.orders for argument in f.args}
    explicit = any(side.has(*times) for item in moving for side in map(_standing, item.sides)) if times else False
    if not moving or not (explicit or any(isinstance(atom, sympy.Derivative) for atom in atoms)):
        return None
    highest = {f: order for item in moving for row in item.moving for f, order in row.highest.items()}

    def named(row: Moving) -> DifferentiatedRow:
        labels = [f"{text} [{place}: 1, 1]" for text, place in row.places]
        return DifferentiatedRow(
            labels, [_name(atoms, f, order - row.times) for f, order in highest.items()], row.times
        )

    blocks = [EquationBlock([named(row)]) for item in moving if item.triad is None for row in item.moving if row.orders]
    blocks.sort(key=lambda block: len(block.rows[0].labels))
    blocks += [EquationBlock([named(row) for row in item.moving], item.triad.rank) for item in moving if item.triad]
    determined = [w for atom, w in atoms.items() if _order(atom) >= highest.get(_function(atom), inf)]
    still = [w for atom, w in atoms.items() if not isinstance(_function(atom), AppliedUndef) and atom not in times]
    names = [_name(atoms, f, order) for f, order in highest.items()]
    return Motion(blocks, names, frozenset(w.name for w in determined), frozenset(w.name for w in still))


def _function(atom: Any) -> Any:
    return atom.expr if isinstance(atom, sympy.Derivative) else atom


def _order(atom: Any) -> int:
    return int(atom.derivative_count) if isinstance(atom, sympy.Derivative) else 0


def _name(atoms: Mapping[Any, Symbol], function: Any, order: int) -> str:
    """The name of the word for a rate of a function; none if it does not occur."""
    if order < 0:
        return ""
    word = atoms.get(_rate(function, order))
    return "" if word is None else word.name


def _rate(function: Any, order: int) -> Any:
    return sympy.Derivative(function, (function.args[0], order)) if order else function


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
    return partial or any(map(_assumed, tied)) or any(map(_is_rigid, turning))


def _is_rigid(atom: Any) -> bool:
    """Whether an atom is known to be algebraic: its cosine and sine are not rational then, unless it is zero."""
    return bool(atom.is_algebraic or atom.is_zero)


def _assumed(atom: Any) -> dict[str, bool]:
    """What SymPy knows of an atom, beyond its being real."""
    return {key: known for key in ASSUMPTIONS if (known := getattr(atom, f"is_{key}")) is not None}


def _agrees(value: SurdSum, wanted: Mapping[str, bool]) -> bool:
    if not wanted:
        return True
    number = value.as_rational
    exact = sympy.sympify(value.text("pi")) if number is None else sympy.Rational(number.numerator, number.denominator)
    return all(getattr(exact, f"is_{key}") is known for key, known in wanted.items())
