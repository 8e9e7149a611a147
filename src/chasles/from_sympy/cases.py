"""Questions by cases: what changes its form with a sign, such as Max(x, y) with that of x - y, is written out for each.

Where x - y is positive, x is y + d with a positive d, which takes the place of x everywhere; where it is zero, x is y.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from itertools import combinations
from math import prod
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from chasles.from_sympy.atoms import ASSUMPTIONS
from chasles.from_sympy.remainders import at_integer, quotient, remainders_of
from chasles.from_sympy.switches import (
    HOLDING,
    WRITTEN,
    deciding,
    excludes,
    factors_of,
    powers_in,
    ratio_of,
    switches_in,
    visible_sign,
)

SIGNS = {"+": 1, "0": 0, "-": -1}
OF_SIGN = {"positive", "negative", "nonpositive", "nonnegative", "zero", "nonzero"}
Fact = tuple[Any, int]
"""An expression, and its sign."""


@dataclass(frozen=True, slots=True)
class SplitCase:
    """What is spoken of in one case, the equations that hold there besides, and the signs that are known.

    `path` says of each substituted positive symbol what it stands for, `zeros` what vanishes, as the question has it,
    and `values` what symbols are, in turn. `excluded` is what a question needs that does not hold here: that a divisor
    is not zero, or a radicand not negative.
    """

    spoken: tuple[Any, ...]
    equations: tuple[Any, ...] = ()
    facts: tuple[Fact, ...] = ()
    path: tuple[tuple[Any, Any], ...] = ()
    zeros: tuple[Any, ...] = ()
    excluded: str = ""
    values: tuple[tuple[Any, Any], ...] = ()
    _signs: dict[Any, int | None] = field(default_factory=dict)

    def settled(self) -> SplitCase:
        """The case with every part written out whose sign is known."""
        case = self
        while True:
            known = {part: value for part in switches_in(case.spoken) if (value := case._written(part)) is not None}
            first = next(iter(known), None)
            if first is None:
                return case
            case = replace(case, spoken=tuple(e.xreplace({first: known[first]}) for e in case.spoken), _signs={})

    @property
    def open(self) -> Any:
        """A factor of what decides the form of some part, of unknown sign; None if there is none."""
        for part in switches_in(self.spoken):
            for decisive in deciding(part):
                for factor in factors_of(decisive):
                    if self.sign(factor) is None:
                        return factor
        return None

    @property
    def vanishing(self) -> bool:
        """Whether something is divided by that is zero in this case."""
        return any(e.has(sympy.zoo, sympy.nan, sympy.oo, -sympy.oo) for e in (*self.spoken, *self.equations))

    @property
    def possible(self) -> bool:
        """Whether the known signs do not visibly contradict each other, alone or two of them."""
        if any(excludes(e, sign) for e, sign in self.facts):
            return False
        pairs = ((ratio_of(e, other), sign, known) for (e, sign), (other, known) in combinations(self.facts, 2))
        return all(ratio is None or sign == ratio * known for ratio, sign, known in pairs)

    def sign(self, e: Any) -> int | None:
        """The sign of an expression, if it is known."""
        if e not in self._signs:
            self._signs[e] = self._sign(e)
        return self._signs[e]

    def _sign(self, e: Any) -> int | None:
        e = sympy.expand(e)
        if (visible := visible_sign(e)) is not None:
            return visible
        for fact, sign in self.facts:
            if (ratio := ratio_of(e, fact)) is not None:
                return sign * ratio
        above, below = sympy.fraction(sympy.together(e))
        if below.free_symbols:
            one, other = self.sign(above), self.sign(below)
            return one * other if one is not None and other else None
        factors = factors_of(e)
        ratio = ratio_of(e, sympy.Mul(*factors))
        if ratio is None or len(factors) == 1:
            return None
        signs = [self.sign(factor) for factor in factors]
        return None if None in signs else ratio * prod(sign for sign in signs if sign is not None)

    def _written(self, part: Any) -> Any:
        """The part without its switch; None where that takes a sign that is not known."""
        if switches_in(part.args) and not isinstance(part, sympy.Piecewise):
            return None
        if isinstance(part, sympy.Piecewise):
            return self._chosen(part)
        sign = self.sign(deciding(part)[0])
        return None if sign is None else WRITTEN[part.func](part.args, sign)

    def _chosen(self, part: Any) -> Any:
        """What stands at the first condition that holds."""
        for value, condition in part.args:
            relations = {r: self._truth(r) for r in condition.atoms(Relational)}
            known = {r: sympy.true if truth else sympy.false for r, truth in relations.items() if truth is not None}
            decided = condition.xreplace(known)
            if decided == sympy.true:
                return value
            if decided != sympy.false:
                return None
        return sympy.nan

    def _truth(self, relation: Any) -> bool | None:
        sign = self.sign(relation.lhs - relation.rhs)
        return None if sign is None else sign in HOLDING[relation.rel_op]

    def split(self, factor: Any, positive: Any) -> Mapping[str, SplitCase]:
        """The three cases of a factor of unknown sign; a positive symbol stands for its size."""
        return {name: self._with(factor, sign, positive) for name, sign in SIGNS.items()}

    def _with(self, factor: Any, sign: int, positive: Any) -> SplitCase:
        atom = None if excludes(factor, sign) else eliminable(factor, (*self.spoken, *self.equations))
        zeros = self.zeros if sign else (*self.zeros, self.back(factor))
        if atom is None:
            equations = self.equations if sign else (*self.equations, factor)
            return replace(self, equations=equations, facts=(*self.facts, (factor, sign)), zeros=zeros, _signs={})
        slope = sympy.diff(factor, atom)
        size = sign * positive
        value = sympy.expand(atom + (size - factor) / slope)
        put = {atom: value}
        facts = [(e.xreplace(put), known) for e, known in self.facts]
        facts += [(value, known) for known in _assumed_sign(atom)]
        path = (*self.path, (size * sign, factor * sign)) if sign else self.path
        spoken, equations = (tuple(_with_value(e, put) for e in part) for part in (self.spoken, self.equations))
        case = SplitCase(spoken, equations, tuple(facts), path, zeros, values=(*self.values, (atom, value)))
        return replace(case, excluded=self._lost(case, put))

    def split_by_remainder(self, symbol: Any, modulus: int, name: str) -> Mapping[str, SplitCase]:
        """The cases of an integer by its remainder; a new integer is the quotient."""
        whole = quotient(name, symbol)
        return {str(r): self._at(symbol, modulus * whole + r, (whole, (symbol - r) / modulus))
                for r in remainders_of(symbol, modulus)}  # fmt: skip

    def _at(self, symbol: Any, value: Any, meaning: tuple[Any, Any]) -> SplitCase:
        spoken, equations = (
            tuple(at_integer(e, symbol, value) for e in part) for part in (self.spoken, self.equations)
        )
        facts = [(at_integer(e, symbol, value), known) for e, known in self.facts]
        facts += [(value, known) for known in _assumed_sign(symbol)]
        values = (*self.values, (symbol, value))
        return SplitCase(spoken, equations, tuple(facts), (*self.path, meaning), self.zeros, values=values)

    def _lost(self, case: SplitCase, put: Mapping[Any, Any]) -> str:
        """What is not defined where symbols have these values, that is outside of conditions; "" if nothing is."""
        for power in powers_in(self.spoken, within=False):
            sign = case.sign(power.base.xreplace(put))
            if sign == 0 and power.exp.is_negative:
                return f"{self.back(power.base)} != 0"
            if sign == -1 and not power.exp.is_Integer:
                return f"{self.back(power.base)} >= 0"
        return ""

    def sign_here(self, e: Any) -> int | None:
        """The sign of an expression of the question, if it is known."""
        for atom, value in self.values:
            e = e.xreplace({atom: value})
        return self.sign(e)

    def back(self, e: Any) -> Any:
        """An expression in the symbols of the question."""
        for symbol, meaning in reversed(self.path):
            e = e.xreplace({symbol: meaning})
        return sympy.expand(e)


def _with_value(e: Any, put: Mapping[Any, Any]) -> Any:
    """The expression at the value; undefined where something in it is that SymPy does not compare."""
    try:
        return e.xreplace(put)
    except (TypeError, ValueError):
        return sympy.zoo


def eliminable(factor: Any, expressions: Iterable[Any]) -> Any:
    """A symbol in which the factor is linear with a rational coefficient, and whose values need not be of a kind.

    None if there is no such symbol.
    """
    inside = {s for e in expressions for f in e.atoms(AppliedUndef, sympy.Derivative) for s in f.free_symbols}
    for symbol in sorted(factor.free_symbols - inside, key=str):
        slope = sympy.diff(factor, symbol)
        if isinstance(slope, sympy.Rational) and slope != 0 and not _is_of_a_kind(symbol):
            return symbol
    return None


def _is_of_a_kind(symbol: Any) -> bool:
    return any(getattr(symbol, f"is_{name}") is not None for name in ASSUMPTIONS if name not in OF_SIGN)


def _assumed_sign(symbol: Any) -> list[int]:
    """The sign that SymPy assumes of a symbol, if it is one."""
    return [1] if symbol.is_positive else [-1] if symbol.is_negative else []
