"""Questions by cases: what changes its form with a sign, such as Max(x, y) with that of x - y, is written out for each.

Where x - y is positive, x is y + d with a positive d, which takes the place of x everywhere; where it is zero, x is y.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from math import prod
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from chasles.from_sympy.atoms import ASSUMPTIONS
from chasles.from_sympy.enclosures import NotEnclosed, ends_of
from chasles.from_sympy.opening import parts_of

SIGNS = {"+": 1, "0": 0, "-": -1}
SWITCHES = (sympy.Max, sympy.Min, sympy.Piecewise, sympy.Heaviside, sympy.sign, sympy.Abs)
OF_SIGN = {"positive", "negative", "nonpositive", "nonnegative", "zero", "nonzero"}
BITS = 200
Fact = tuple[Any, int]
"""An expression, and its sign."""


def switches_in(expressions: Iterable[Any], *kinds: type) -> list[Any]:
    """The parts of some kinds, or of any that change with a sign, innermost first."""
    found = {part for e in expressions for part in parts_of(e) if isinstance(part, kinds or SWITCHES)}
    return sorted(found, key=lambda part: (len(part.atoms(*SWITCHES)), str(part)))


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
            for deciding in _deciding(part):
                for factor in _factors(deciding):
                    if self.sign(factor) is None:
                        return factor
        return None

    @property
    def vanishing(self) -> bool:
        """Whether something is divided by that is zero in this case."""
        return any(e.has(sympy.zoo, sympy.nan, sympy.oo, -sympy.oo) for e in (*self.spoken, *self.equations))

    @property
    def possible(self) -> bool:
        """Whether the known signs do not visibly contradict each other."""
        return all(_visible(e) in (None, sign) for e, sign in self.facts)

    def sign(self, e: Any) -> int | None:
        """The sign of an expression, if it is known."""
        if e not in self._signs:
            self._signs[e] = self._sign(e)
        return self._signs[e]

    def _sign(self, e: Any) -> int | None:
        e = sympy.expand(e)
        if (visible := _visible(e)) is not None:
            return visible
        for fact, sign in self.facts:
            if (ratio := _ratio(e, fact)) is not None:
                return sign * ratio
        factors = _factors(e)
        ratio = _ratio(e, sympy.Mul(*factors))
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
        sign = self.sign(_deciding(part)[0])
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
        atom = _eliminable(factor, (*self.spoken, *self.equations))
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
    except ValueError:
        return sympy.zoo


def powers_in(expressions: Iterable[Any], within: bool) -> list[Any]:
    """The powers with rational exponents within conditions, or those outside."""
    found: set[Any] = set()
    for e in expressions:
        outside = e.replace(lambda part: isinstance(part, sympy.Piecewise), lambda _: sympy.S.Zero)
        parts = e.atoms(sympy.Piecewise) if within else {outside}
        found |= {power for part in parts for power in part.atoms(sympy.Pow) if power.exp.is_Rational}
    return sorted(found, key=str)


def _deciding(part: Any) -> list[Any]:
    """Whose signs decide the form of a part."""
    if isinstance(part, sympy.Piecewise):
        relations = [r for _, condition in part.args for r in sorted(condition.atoms(Relational), key=str)]
        return [r.lhs - r.rhs for r in relations]
    if isinstance(part, sympy.Max | sympy.Min):
        one, other = sorted(part.args, key=str)[:2]
        return [one - other]
    return [part.args[0]]


def _larger(arguments: tuple[Any, ...], sign: int | None, function: Any) -> Any:
    one, other, *rest = sorted(arguments, key=str)
    first = (sign or 0) >= 0 if function is sympy.Max else (sign or 0) <= 0
    return function(one if first else other, *rest)


HOLDING = {"==": (0,), "!=": (1, -1), ">": (1,), ">=": (0, 1), "<": (-1,), "<=": (0, -1)}
WRITTEN: Mapping[Any, Callable[[Any, Any], Any]] = {
    sympy.Max: lambda arguments, sign: _larger(arguments, sign, sympy.Max),
    sympy.Min: lambda arguments, sign: _larger(arguments, sign, sympy.Min),
    sympy.Abs: lambda arguments, sign: sign * arguments[0],
    sympy.sign: lambda _, sign: sympy.Integer(sign),
    sympy.Heaviside: lambda arguments, sign: sympy.Integer((sign + 1) // 2) if sign else arguments[1],
}


def _factors(e: Any) -> list[Any]:
    """The irreducible factors of a polynomial, each once as often as it occurs; else the expression itself."""
    symbols = sorted(e.free_symbols, key=str)
    if not symbols or not e.is_polynomial(*symbols) or e.has(*SWITCHES):
        return [e]
    return [factor for factor, power in sympy.factor_list(e)[1] for _ in range(int(power))]


def _ratio(e: Any, other: Any) -> int | None:
    """The sign of a rational number by which one expression is a multiple of another; None if it is none."""
    one, rest = sympy.expand(e).as_content_primitive()
    two, same = sympy.expand(other).as_content_primitive()
    if sympy.expand(rest - same) == 0:
        return int(sympy.sign(one * two))
    return int(-sympy.sign(one * two)) if sympy.expand(rest + same) == 0 else None


def _visible(e: Any) -> int | None:
    """The sign that is seen from an expression alone."""
    if not e.free_symbols:
        if e == 0:
            return 0
        try:
            least, most = ends_of(e, BITS)
        except NotEnclosed:
            return None
        return 1 if least > 0 else -1 if most < 0 else None
    return 1 if e.is_positive else -1 if e.is_negative else 0 if e.is_zero else None


def _eliminable(factor: Any, expressions: Iterable[Any]) -> Any:
    """A symbol in which the factor is linear with a rational coefficient, and whose values need not be of a kind."""
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
