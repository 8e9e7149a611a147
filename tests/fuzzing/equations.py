"""A question about an equation between SymPy expressions, and points of our own that satisfy what is given.

A point is a motion: the Taylor coefficients of every function of time, which satisfy the given equations and all their
derivatives as far as coefficients are kept, and values of the symbols.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from math import factorial
from random import Random
from typing import Any

import numpy as np
import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.printing.str import StrPrinter

from .newton import solved
from .series import Series, Undefined, mpf
from .sympy_values import Values, atoms_of, orders_of

__all__ = ["Equation", "Point", "entries", "pairs", "points"]

SMALLEST = mpf(10) ** -10
"""What is smaller is not taken for positive: the search may have run into zero."""
SPARE = 3
"""So many derivatives of the given equations are satisfied beyond those that the question names."""
TIME = sp.Symbol("t")
Point = Mapping[Any, Series]


class _Python(StrPrinter):
    """Spells a fraction that stands alone so that Python reads it as one."""

    def _print_Rational(self, e: Any) -> str:
        return f"Rational({e.p}, {e.q})"


@dataclass(frozen=True)
class Equation:
    """A question for `prove`.

    `where` are inequalities that are given as well. `truth` is what the equation is by construction, None where nobody
    knows; `satisfiable` likewise for the given equations. `kind` is the family it belongs to; `lenient` says that it
    may be declined.
    """

    lhs: Any
    rhs: Any
    given: tuple[Any, ...] = ()
    nonzero: tuple[Any, ...] = ()
    kind: str = ""
    truth: bool | None = None
    satisfiable: bool | None = None
    lenient: bool = False
    notes: tuple[str, ...] = field(default=(), compare=False)
    where: tuple[Any, ...] = ()

    @property
    def expressions(self) -> list[Any]:
        """Everything in which symbols occur, entry by entry."""
        sides = [e for side in (self.lhs, self.rhs) for e in entries(side)]
        return [
            *sides,
            *(e for item in self.given for pair in pairs(item) for e in pair),
            *(e for item in self.where for e in item.args),
            *map(sp.sympify, self.nonzero),
        ]

    @property
    def atoms(self) -> list[Any]:
        return atoms_of(*self.expressions)

    @property
    def order(self) -> int:
        """The highest derivative that occurs."""
        return max(orders_of(*self.expressions).values(), default=0)

    def unlabelled(self) -> Equation:
        """The question of which nothing is known."""
        return replace(self, truth=None, satisfiable=None)

    def source(self) -> str:
        """Python text that asks it again."""
        names = dict.fromkeys(f.func.__name__ for f in self.atoms if isinstance(f, AppliedUndef))
        lines = [f"{name} = Function({name!r})" for name in names]
        lines += ["t = Symbol('t')"] if names else []
        for symbol in (a for a in self.atoms if isinstance(a, sp.Symbol)):
            assumed = "".join(f", {key}={value}" for key, value in sorted(symbol._assumptions_orig.items()))
            lines.append(f"{symbol} = Symbol({symbol.name!r}{assumed})")
        return "; ".join(lines) + f"\n{self}"

    def __str__(self) -> str:
        shown = _Python().doprint
        told = (*self.given, *self.where)
        given = f", given=[{', '.join(map(shown, told))}]" if told else ""
        nonzero = f", nonzero=[{', '.join(map(shown, self.nonzero))}]" if self.nonzero else ""
        return f"prove({shown(self.lhs)}, {shown(self.rhs)}{given}{nonzero})"


def entries(side: Any) -> list[Any]:
    """The entries of a scalar or a matrix."""
    return list(side) if isinstance(side, sp.MatrixBase) else [sp.sympify(side)]


def pairs(item: Any) -> list[tuple[Any, Any]]:
    """The equations between scalars that a given item says."""
    if isinstance(item, sp.Equality):
        return list(zip(entries(item.lhs), entries(item.rhs), strict=True))
    return [(e, sp.Integer(0)) for e in entries(item)]


class _System:
    """The equations for the coefficients of a motion; some of the coefficients are fixed."""

    def __init__(self, question: Equation, extra: tuple[tuple[Any, Any], ...], last: int) -> None:
        self.equations = [*extra, *(p for item in question.given for p in pairs(item))]
        self.momentary = len(extra)
        self.atoms = atoms_of(*question.expressions, *(e for p in extra for e in p))
        self.last = last
        self.orders = [max(orders_of(a, b).values(), default=None) for a, b in self.equations]  # type: ignore[type-var]
        self.places = [
            (atom, k) for atom in self.atoms for k in range(last + 1 if isinstance(atom, AppliedUndef) else 1)
        ]

    def assembled(self, values: list[Any]) -> dict[Any, Series]:
        found: dict[Any, Series] = {}
        for (atom, _), value in zip(self.places, values, strict=True):
            found.setdefault(atom, []).append(value)
        return found

    def residuals(self, values: list[Any]) -> list[Any]:
        like = values[0] if values else mpf(0)
        evaluate = Values(self.assembled(values), like)
        total = []
        for place, ((one, other), order) in enumerate(zip(self.equations, self.orders, strict=True)):
            n = 0 if order is None or place < self.momentary else self.last - order
            total += [a - b for a, b in zip(evaluate(one, n), evaluate(other, n), strict=True)]
        return total


def points(
    question: Equation,
    draw: Random,
    tries: int,
    fixed: Mapping[tuple[Any, int], Any] | None = None,
    extra: tuple[tuple[Any, Any], ...] = (),
    spare: int = SPARE,
    near: Mapping[Any, float] | None = None,
) -> Iterator[Point]:
    """Motions that satisfy all that is given and assumed, of at most so many tries.

    `fixed` gives derivatives of atoms by their order, `extra` further equations at the moment, `near` where to start.
    """
    order = max(question.order, *(orders_of(*p).get(f, 0) for p in extra for f in orders_of(*p)), 0)
    moving = any(isinstance(a, AppliedUndef) for a in question.atoms)
    system = _System(question, extra, order + spare if moving else 0)
    pinned = {place: mpf(value) / factorial(place[1]) for place, value in (fixed or {}).items()}
    for atom in system.atoms:
        if atom.is_zero:
            pinned[atom, 0] = mpf(0)
    for _ in range(tries):
        whole = {(a, 0): mpf(_integer(a, draw)) for a in system.atoms if a.is_integer and (a, 0) not in pinned}
        held = {**_held(system, draw), **whole, **pinned}
        free = [place for place in system.places if place not in held]

        def residuals(values: Any, free: Any = free, held: Any = held) -> list[Any]:
            known = dict(zip(free, values, strict=True))
            like = values[0] if len(values) else mpf(0)
            machine = isinstance(like, np.ndarray)
            full = [
                known[p] if p in known else like * 0 + float(held[p]) if machine else held[p] for p in system.places
            ]
            return system.residuals(full)

        start = [_start(atom, k, draw, near or {}) for atom, k in free]
        found = solved(residuals, start)
        if found is None:
            continue
        known = dict(zip(free, found, strict=True))
        point = system.assembled([known.get(p, held.get(p)) for p in system.places])
        if _in_domain(question, point):
            yield point


def _held(system: _System, draw: Random) -> dict[Any, Any]:
    """Values that some symbols keep: beside what moves all, most often, else some of those with assumptions.

    Otherwise equations such as J f' = K g h would be satisfied where all constants vanish, most of the time.
    """
    symbols = [a for a in system.atoms if isinstance(a, sp.Symbol)]
    moving = len(symbols) < len(system.atoms)
    if moving:
        chosen = symbols if draw.random() < 0.75 else []
    else:
        chosen = [a for a in symbols if a._assumptions_orig and draw.random() < 0.4]
    return {(a, 0): mpf(_start(a, 0, draw, {})) for a in chosen}


def _start(atom: Any, k: int, draw: Random, near: Mapping[Any, float]) -> float:
    if k == 0 and atom in near:
        return near[atom]
    value = draw.uniform(-2.5, 2.5)
    if k == 0 and (atom.is_positive or atom.is_nonnegative):
        return abs(value) + 0.1
    if k == 0 and (atom.is_negative or atom.is_nonpositive):
        return -abs(value) - 0.1
    return value


def _integer(atom: Any, draw: Random) -> int:
    value = draw.randint(-4, 4)
    if atom.is_positive:
        return abs(value) or 1
    if atom.is_negative:
        return -abs(value) or -1
    return abs(value) if atom.is_nonnegative else value


def _in_domain(question: Equation, point: Point) -> bool:
    evaluate = Values(point, mpf(0))
    for atom in question.atoms:
        value = point[atom][0]
        if (
            (atom.is_positive and not value > SMALLEST)
            or (atom.is_negative and not value < -SMALLEST)
            or (atom.is_nonnegative and value < 0)
            or (atom.is_nonpositive and value > 0)
        ):
            return False
    try:
        return all(_is_met(item, evaluate) for item in question.where) and all(
            abs(evaluate(sp.sympify(item))[0]) > mpf(10) ** -30
            for item in question.nonzero
            if not isinstance(item, sp.Ne)
        )
    except Undefined:
        return False


def _is_met(inequality: Any, evaluate: Values) -> bool:
    """Whether it holds at the moment; what is not strict, up to what a search leaves."""
    more = evaluate(inequality.gts)[0] - evaluate(inequality.lts)[0]
    return bool(more > SMALLEST if isinstance(inequality, sp.Gt | sp.Lt) else more > -(SMALLEST**3))
